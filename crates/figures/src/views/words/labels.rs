//! The words in the pictures.

use crate::camera::{Ndc, Operation, Step};
use crate::figure::WorldPart;
use crate::numbers::DecimalMark;
use crate::pipeline::{NEAR, PlaneSet};
use crate::stage::Stage;

/// The few words in the pictures. Symbols (C, PF, u, v, n …) are the same in every language.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Labels {
    /// The number format.
    pub mark: DecimalMark,
    /// The view window.
    pub window: &'static str,
    /// The front face of the volume.
    pub near: &'static str,
    /// The back face of the volume.
    pub far: &'static str,
    /// All objects together.
    pub scene: &'static str,
    /// A corner of an object.
    pub vertex: &'static str,
    /// A place on an object.
    pub point: &'static str,
    /// The camera before an operation.
    pub before: &'static str,
    /// The camera that an answer describes.
    pub answered: &'static str,
    /// Heading of a picture of Z.
    pub depth_stored: &'static str,
    /// Heading of a picture of distances.
    pub depth_linear: &'static str,
    /// Heading of the picture of a light: its shadow map.
    pub depth_of_light: &'static str,
    /// Shadows without bias.
    pub acne: &'static str,
    /// Before the number of pixels where a shadow map is wrong.
    pub map_wrong: &'static str,
    /// Between a number and the total.
    pub out_of: &'static str,
    /// The message if shadow maps aren't compared with rays.
    pub too_much_for_rays: &'static str,
    /// The label of pixels without a depth.
    pub nothing: &'static str,
    /// Parts outside the view volume.
    pub outside: &'static str,
    /// Vertices that clipping makes.
    pub cuts: &'static str,
    /// Faces that are culled because they turn their back.
    pub back_faces: &'static str,
    /// Objects that are culled because they are outside.
    pub dropped: &'static str,
    /// Before the planes that an object is outside of.
    pub outside_of: &'static str,
    /// The planes: left, right, bottom, top, near, far.
    pub planes: [&'static str; 6],
    /// Texture coordinates are interpolated with w.
    pub with_w: &'static str,
    /// Texture coordinates are interpolated without w.
    pub affine: &'static str,
    /// The title of the colours of levels of detail.
    pub levels: &'static str,
    /// Texels are shown.
    pub texels: &'static str,
    /// The divide comes before clipping.
    pub divided_first: &'static str,
    /// The result, if anything is behind the eye.
    pub wrong: &'static str,
    /// The result otherwise.
    pub no_difference: &'static str,
    /// Depth that's 1 at F and 0 at B.
    pub reversed: &'static str,
    /// Axes that are right-handed.
    pub right_handed: &'static str,
    /// Axes that are left-handed.
    pub left_handed: &'static str,
    /// The message if too many pieces can't be sorted.
    pub not_split: &'static str,
    /// Vertices are drawn beside their places.
    pub rounded: &'static str,
    /// For an unfinished picture.
    pub triangles: &'static str,
    /// The input of a stage of the pipeline.
    pub goes_in: &'static str,
    /// The output of a stage of the pipeline.
    pub comes_out: &'static str,
    /// For a stage that had more to do than is shown.
    pub not_all: &'static str,
    /// Parallel projection has no vanishing points.
    pub no_vanishing: &'static str,
    /// A direction parallel to the view plane.
    pub ideal: &'static str,
    /// A vanishing point that isn't in the picture.
    pub beyond_image: &'static str,
    /// For a point that has no image, because it's behind the eye.
    pub behind_eye: &'static str,
    /// The same for a point in the plane through the eye that is parallel to the window.
    pub in_eye_plane: &'static str,
    /// The same for a point at the place of the eye.
    pub in_eye: &'static str,
    /// The line of the vanishing points of horizontal directions.
    pub horizon: &'static str,
    /// The name of the line on which another image shows a pixel.
    pub epipolar: &'static str,
    /// The name of the image of another centre.
    pub epipole: &'static str,
    /// Before the first step of the way to the canonical volume.
    pub world: &'static str,
    /// The side of a comparison with the figure's own camera.
    pub this_camera: &'static str,
    /// The side with another camera.
    pub other_camera: &'static str,
    /// The difference between two sides of a comparison.
    pub differ: &'static str,
    /// The operations: elevation, azimuth, roll, yaw, pitch, zoom, dolly, pan.
    pub operations: [&'static str; 8],
    /// Keys of figure files that are on or off, with their names.
    pub switches: [(&'static str, &'static str); 8],
    /// The values of `[reveal] depth`: off, stored, linear.
    pub depths: [&'static str; 3],
    /// The values of `[reveal] outside`, the usual one first, the others in the order of their words.
    pub outsides: [&'static str; 4],
    /// The values of `[reveal] shadows`: none, then in the order of their words.
    pub shadow_reveals: [&'static str; 4],
    /// The values of `[reveal] cost`: none, then in the order of their words.
    pub costs: [&'static str; 5],
    /// Before the share of fills that are painted over.
    pub painted_over: &'static str,
    /// Before the same share if faces came from front to back.
    pub from_front: &'static str,
    /// The values of `[style] order`.
    pub face_orders: [&'static str; 3],
    /// No stage is shown.
    pub no_stage: &'static str,
    /// The parts of the world, in the order of [`WorldPart::ALL`].
    pub world_parts: [&'static str; WorldPart::ALL.len()],
    /// The values of a switch.
    pub yes_no: [&'static str; 2],
    /// The values of `[style] shading`, in the order of their words.
    pub shadings: [&'static str; 4],
    /// The values of `[style] visibility`.
    pub visibilities: [&'static str; 3],
    /// The values of `[style] hidden_lines`.
    pub hidden_lines: [&'static str; 3],
    /// The values of `[style] depth_format`.
    pub depth_formats: [&'static str; 3],
    /// Before a value of `[style] vertex_format`.
    pub vertices_in: &'static str,
    /// Before a value of `[style] subpixel_bits`.
    pub subpixel_bits: &'static str,
    /// The values of `[camera] projection`.
    pub projections: [&'static str; 2],
    /// The stages of the pipeline, in their order.
    pub stages: [&'static str; Stage::ALL.len()],
    /// Before the number of a step of the way to the canonical volume.
    pub step_number: &'static str,
    /// Before the number of samples of a pixel.
    pub samples: &'static str,
    /// The effect of each step, in the order of [`Step`].
    pub steps: [&'static str; 15],
}

impl Labels {
    /// The words of a label by its name in `[labels]`, as far as they don't depend on the figure. A symbol is its own
    /// name.
    pub fn named(&self, name: &str) -> String {
        let planes = ["left", "right", "bottom", "top", "near", "far"].into_iter().zip(self.planes);
        if let Some(corner) = name.strip_prefix("corner:") {
            let word = |part| planes.clone().find(|(known, _)| *known == part).map_or(part, |(_, word)| word);
            return corner.split('-').map(word).collect::<Vec<_>>().join(", ");
        }
        let words = [
            ("window", self.window),
            ("near", self.near),
            ("far", self.far),
            ("scene", self.scene),
            ("before", self.before),
            ("answered", self.answered),
            ("outside", self.outside),
            ("horizon", self.horizon),
            ("epipolar", self.epipolar),
            ("epipole", self.epipole),
            ("behind-eye", self.behind_eye),
            ("goes-in", self.goes_in),
            ("comes-out", self.comes_out),
            ("differ", self.differ),
        ];
        let words = words.into_iter().chain(Operation::names().into_iter().zip(self.operations));
        words.into_iter().find(|(known, _)| *known == name).map_or(name, |(_, words)| words).to_owned()
    }

    /// The reason why an object is dropped. Behind the eye all signs are reversed, so only the front plane is
    /// meaningful.
    pub fn outside_planes(&self, planes: PlaneSet) -> String {
        let planes = if planes & NEAR != 0 { NEAR } else { planes };
        let names: Vec<&str> =
            (0..).zip(self.planes).filter(|(i, _)| planes >> i & 1 == 1).map(|(_, name)| name).collect();
        format!("{}: {}", self.outside_of, names.join(", "))
    }

    /// The effect of a step of the way to the canonical volume.
    pub fn step(&self, step: Step) -> &'static str {
        self.steps.get(step as usize).copied().unwrap_or_default()
    }

    /// A convention of NDC in words: its owner, reversed, without a far plane.
    pub fn ndc_title(&self, ndc: Ndc) -> String {
        let reversed = if ndc.reversed { format!(", {}", self.reversed) } else { String::new() };
        let infinite = if ndc.infinite { ", B → ∞" } else { "" };
        format!("{}{reversed}{infinite}", ndc.api.title())
    }
}

/// Labels without words, for tests that look at anything but words.
#[cfg(test)]
pub(crate) fn unlabelled() -> &'static Labels {
    static UNLABELLED: std::sync::LazyLock<Labels> = std::sync::LazyLock::new(Labels::default);
    &UNLABELLED
}
