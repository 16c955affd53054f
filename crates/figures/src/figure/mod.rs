//! A figure: camera parameters, image, viewport, scene, points, style, the `[reveal]` of the pipeline, observers, and
//! the explanations in the pictures. One figure file is one `Figure`.

mod cameras;
mod comparison;
mod edit;
pub mod error;
mod keys;
pub mod labels;
mod localized;
mod near;
pub mod observer;
mod other_side;
pub mod points;
pub mod read;
mod reveal;
mod screen;
mod show;
pub mod value;
pub mod variation;
mod view;
pub mod words;
mod world_look;
pub mod write;

use glam::DVec3;

use crate::appearance::Style;
use crate::camera::{ImageSize, LensForm, Parameters, Projection, Viewport};
use crate::scene::{FileUse, Preset, SceneSpec};
pub use cameras::{CameraTag, NamedCamera};
pub use comparison::Comparison;
pub use edit::{Difference, difference, has, number_at, show_with, update, varied, varied_together};
pub use error::FigureError;
pub use keys::KEYS;
pub use labels::{
    LabelChange, LabelledMeasure, Labels, Letters, MeasureText, MovedLabel, Note, NotePlace, RenamedLabel, StyledLabel,
};
pub use localized::Localized;
pub use observer::Observer;
pub use other_side::OtherSide;
pub use points::NamedPoint;
pub use reveal::{CostReveal, Depth, Outside, Reveal, ShadowReveal};
pub use screen::{Arrangement, Explanation, Screen, ScreenEntry, ScreenMatrix};
pub use show::{
    Measure, Measured, Show, ShownProbe, ShownStep, ShownTriangle, StagePicture, TransformPreview, TriangleStep,
    WindowSide,
};
pub use view::{View, Views};
pub use world_look::{AXES_LENGTHS, WorldLook, WorldPart, WorldParts};

/// Everything that a picture depends on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// `title`, of at most [`MAX_TITLE`](crate::limits::MAX_TITLE) characters.
    pub title: Option<Localized>,
    /// `caption`, of at most [`MAX_CAPTION`](crate::limits::MAX_CAPTION) characters.
    pub caption: Option<Localized>,
    /// `[camera]`
    pub camera: Parameters,
    /// `[camera] horizontal_angle` or `lens`: the form in which the file gives θ. It's written as long as it gives the
    /// angle of `camera`. See [`Figure::lens_in_force`].
    pub lens: Option<LensForm>,
    /// `[camera] name` and `color`.
    pub tag: CameraTag,
    /// `[[cameras]]`: at most [`MAX_CAMERAS`](crate::limits::MAX_CAMERAS).
    pub cameras: Vec<NamedCamera>,
    /// `[image]`
    pub image: ImageSize,
    /// `[image] undistorted`: the image is shown with the aspect of the view window, as the eye would see it, instead
    /// of the m × n image of `[0]` Eq. (5.22).
    pub undistorted: bool,
    /// `[image] photograph` and `photograph_opacity`.
    pub photograph: Option<Photograph>,
    /// `[viewport]`; `None` means the whole image, depth 0 … 1.
    pub viewport: Option<Viewport>,
    /// `[scene]`
    pub scene: SceneSpec,
    /// `[[points]]`: at most [`MAX_NAMED_POINTS`](crate::limits::MAX_NAMED_POINTS).
    pub points: Vec<NamedPoint>,
    /// `[style]`
    pub style: Style,
    /// `[reveal]`
    pub reveal: Reveal,
    /// `[world]`
    pub world: WorldLook,
    /// `[observers]`: the observers of the world and of the canonical volume. `None` means one that sees everything.
    pub observers: Observers,
    /// `[show]`: explanations in the pictures.
    pub show: Show,
    /// `[screen]`: the display of the figure in a window.
    pub screen: Screen,
    /// `[compare]`: the same figure in another way, beside it.
    pub compare: Option<Comparison>,
    /// `[labels]`: the author's changes of labels, and notes.
    pub labels: Labels,
}

impl Figure {
    /// A named scene, with a camera that shows it and its view volume well.
    pub fn of_preset(preset: Preset) -> Self {
        let scene = SceneSpec { preset, ..SceneSpec::default() };
        Self { camera: recommended_camera(preset), scene, ..Self::default() }
    }

    /// The form in which θ was given, unless the angle has changed since, or the aspect from which it followed.
    pub fn lens_in_force(&self) -> Option<LensForm> {
        self.lens.filter(|lens| lens.view_angle(self.camera.aspect) == self.camera.view_angle)
    }

    /// Every name in the figure that leads to a file, relative to the figure file, with the use of the file.
    pub fn files(&self) -> impl Iterator<Item = (&str, FileUse)> {
        let photograph = self.photograph.iter().map(|photograph| (photograph.file.as_str(), FileUse::Image));
        self.scene.files().chain(photograph)
    }

    /// The same names, to be replaced by others.
    pub fn files_mut(&mut self) -> impl Iterator<Item = &mut String> {
        self.scene.files_mut().chain(self.photograph.iter_mut().map(|photograph| &mut photograph.file))
    }

    /// Everything except the scene, the observers and the display, which aren't edits.
    #[must_use]
    pub fn without_scene(&self) -> Self {
        Self { scene: SceneSpec::default(), observers: Observers::default(), show: Show::default(), ..self.clone() }
    }
}

/// The observers of the two three-dimensional pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Observers {
    /// `[observers.world]`
    pub world: Option<Observer>,
    /// `[observers.canonical]`
    pub canonical: Option<Observer>,
}

/// A photograph that fills the image under the scene, for comparing the two.
#[derive(Clone, Debug, PartialEq)]
pub struct Photograph {
    /// `[image] photograph`: the file, relative to the figure file.
    pub file: String,
    /// `[image] photograph_opacity`, 0 … 1: its share. The background has the rest.
    pub opacity: f64,
}

impl Photograph {
    /// The opacity without the key.
    pub const USUAL_OPACITY: f64 = 0.5;
}

/// A camera that shows the scene well, with clipping planes close around it, so that its view volume is visible in the
/// world too. For an exercise it's the camera of the exercise.
pub fn recommended_camera(preset: Preset) -> Parameters {
    let perspective = |position: [f64; 3], focal_point: [f64; 3], view_angle, near, far| Parameters {
        position: DVec3::from(position),
        focal_point: DVec3::from(focal_point),
        view_angle,
        near,
        far,
        ..Parameters::default()
    };
    let origin = [0.0; 3];
    match preset {
        Preset::Empty => Parameters::default(),
        Preset::Primitives => perspective([3.0, 4.0, 5.0], origin, 42.0, 3.0, 12.0),
        Preset::Cube => perspective([2.6, 2.4, 3.6], origin, 42.0, 2.0, 8.0),
        Preset::House => perspective([3.2, 2.6, 5.4], [0.0, 0.8, 0.0], 38.0, 3.0, 11.0),
        Preset::Corridor => perspective([0.3, 1.3, 4.5], [0.0, 1.1, -5.0], 50.0, 1.5, 20.0),
        // `[1]`, exercises II and III for D = 15 and M = 8, with near = D/100 and far = 10 D. Angle and aspect are free
        // there.
        Preset::Pyramid => Parameters { aspect: 1.0, ..perspective([0.0, 0.0, 8.0], origin, 90.0, 0.15, 150.0) },
        // The answer to `[0]` exercise 5.3.
        Preset::NdcCube => Parameters {
            projection: Projection::Parallel,
            height: 2.0,
            aspect: 1.0,
            ..perspective([0.0, 0.0, 2.0], origin, 45.0, 1.0, 3.0)
        },
        Preset::Exercise51 => perspective([3.0, 4.0, 0.0], origin, 45.0, 1.5, 9.0),
        // The text gives a view angle of 90° for a parallel projection. H is its span on the front plane, 2 F tan 45°.
        Preset::Exercise52 => Parameters {
            view_up: DVec3::X,
            projection: Projection::Parallel,
            height: 10.0,
            aspect: 0.75,
            ..perspective([7.0, 0.0, 0.0], [1.0; 3], 90.0, 5.0, 20.0)
        },
        Preset::Exercise53 => perspective([3.0, 4.0, 5.0], origin, 35.0, 4.0, 11.0),
    }
}
