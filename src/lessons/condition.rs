//! Goals of a student: conditions on the camera, or on what is seen.

use super::numbers_in_texts::numbers_of;
use crate::camera::{Camera, Convention, ImageSize};
use crate::figure::variation::{Variant, VariationError, varied_by};
use crate::figure::{Bilingual, Figure};
use crate::inspect::InspectError;
use crate::inspect::quantity::QuantityPath;
use crate::numerics::diagnosis::Counter;
use crate::scene::Scene;

/// The longest side of the image in which pixels are counted: a picture in a window is not much larger.
const SIDE: u32 = 640;

/// Something to reach with the controls.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// The wording, in Markdown, with `{quantity}` for the numbers of the figure.
    pub text: Bilingual,
    /// The conditions: it is reached where all hold.
    pub until: Vec<Condition>,
    /// Operations and keys with their values that reach it from the step's figure; may be empty.
    pub way: Vec<(String, String)>,
}

/// One condition.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// Every number of a quantity lies between two, both included.
    Quantity {
        /// The path in the output of `inspect`.
        path: QuantityPath,
        /// The least number.
        least: Option<f64>,
        /// The greatest number.
        most: Option<f64>,
    },
    /// A pixel of the image or more shows the object with this name.
    Seen(String),
    /// No pixel of the image shows the object with this name.
    Hidden(String),
}

/// The state in which a condition holds or not.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The figure.
    pub figure: &'a Figure,
    /// Its camera.
    pub camera: &'a Camera,
    /// Its scene.
    pub scene: &'a Scene,
}

/// Counts what is seen; keeps its buffers.
#[derive(Debug, Default)]
pub struct Seen(Counter);

impl Goal {
    /// True where all conditions hold. An object that is not in the scene is not seen.
    #[must_use]
    pub fn is_reached(&self, subject: Subject<'_>, seen: &mut Seen) -> bool {
        self.until.iter().all(|condition| condition.holds(subject, seen))
    }

    /// The figure after the way that the lesson knows.
    ///
    /// # Errors
    /// [`VariationError`] names the impossible value.
    ///
    /// # Panics
    /// Never.
    pub fn reached_from(&self, figure: &Figure, camera: &Camera) -> Result<Variant, VariationError> {
        let way: Vec<(&str, &str)> = self.way.iter().map(|(key, value)| (&**key, &**value)).collect();
        varied_by(figure, camera, &way, Convention::RightHand)
    }
}

impl Condition {
    /// The name of the object that it is about.
    #[must_use]
    pub fn object(&self) -> Option<&str> {
        match self {
            Self::Seen(name) | Self::Hidden(name) => Some(name),
            Self::Quantity { .. } => None,
        }
    }

    fn holds(&self, subject: Subject<'_>, seen: &mut Seen) -> bool {
        match self {
            Self::Quantity { path, least, most } => {
                let report: Result<_, InspectError> = numbers_of(subject.figure);
                let numbers = report.ok().and_then(|report| path.numbers(&report));
                let within = |x: &f64| least.is_none_or(|least| *x >= least) && most.is_none_or(|most| *x <= most);
                numbers.is_some_and(|numbers| numbers.entries.iter().all(within))
            }
            Self::Seen(name) => seen.pixels(subject, name) > 0,
            Self::Hidden(name) => seen.pixels(subject, name) == 0,
        }
    }
}

impl Seen {
    /// The pixels of a smaller image on which an object is seen, or the objects below it.
    fn pixels(&mut self, subject: Subject<'_>, name: &str) -> u64 {
        let of: Vec<usize> = objects_named(subject.scene, name).collect();
        let ImageSize { width, height } = subject.figure.image;
        let most = width.max(height).max(1);
        let side = |side: u32| if most > SIDE { (side * SIDE / most).max(1) } else { side };
        let image = ImageSize { width: side(width), height: side(height) };
        self.0.seen(subject.scene, &of, subject.camera, image).iter().sum()
    }
}

/// The places in a scene of the object with a name, and of those below it in the tree.
pub fn objects_named<'a>(scene: &'a Scene, name: &'a str) -> impl Iterator<Item = usize> + 'a {
    let is_it =
        move |other: &str| other.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'));
    scene
        .objects
        .iter()
        .enumerate()
        .filter(move |(_, object)| is_it(&object.name) || object.owner() == name)
        .map(|(i, _)| i)
}
