//! Goals of a student: conditions on the camera, on the keys of the figure, or on visible objects.

use glam::DVec3;

use super::numbers_in_texts::numbers_of;
use crate::camera::{Camera, Convention, ImageSize};
use crate::figure::variation::{Variant, VariationError, varied_by};
use crate::figure::{Figure, Localized, has, number_at};
use crate::inspect::Report;
use crate::inspect::quantity::QuantityPath;
use crate::numerics::diagnosis::Counter;
use crate::scene::Scene;

/// The longest side of the image whose pixels are counted. A picture in a window isn't much larger.
const SIDE: u32 = 640;

/// Something to reach with the controls.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// The wording, in Markdown, with `{quantity}` for the numbers of the figure.
    pub text: Localized,
    /// The conditions. The goal is reached if all hold.
    pub until: Vec<Condition>,
    /// Operations and keys with their values that reach the goal from the step's figure. May be empty.
    pub way: Vec<(String, String)>,
}

/// One condition.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// Every number of a quantity lies between two, both included.
    Quantity {
        /// The path in the output of `inspect`.
        path: QuantityPath,
        /// The numbers.
        range: Range,
    },
    /// The angle between two vectors lies between two, both included.
    Angle {
        /// The paths of the vectors in the output of `inspect`.
        between: [QuantityPath; 2],
        /// The angles in degrees.
        range: Range,
    },
    /// A key of the figure has a value: `style.visibility`, `"painter"`.
    Key {
        /// The key with its section.
        key: String,
        /// The value as a figure file writes it.
        value: String,
    },
    /// The number of a key of the figure lies between two, both included. Without such a number the condition doesn't
    /// hold.
    Number {
        /// The key with its section.
        key: String,
        /// The numbers.
        range: Range,
    },
    /// At least one pixel of the image shows the object with this name.
    Seen(String),
    /// No pixel of the image shows the object with this name.
    Hidden(String),
}

/// Numbers between two, both included.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Range {
    /// The least number.
    pub least: Option<f64>,
    /// The greatest number.
    pub most: Option<f64>,
}

/// The state in which a condition may hold.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The figure as the student left it.
    pub figure: &'a Figure,
    /// The validated camera of the figure.
    pub camera: &'a Camera,
    /// The scene of the figure, with its meshes.
    pub scene: &'a Scene,
}

/// Counts visible pixels. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Seen(Counter);

impl Goal {
    /// True if all conditions hold. An object that isn't in the scene isn't visible.
    pub fn is_reached(&self, subject: Subject<'_>, seen: &mut Seen) -> bool {
        self.until.iter().all(|condition| condition.holds(subject, seen))
    }

    /// The figure after the lesson's own way to the goal.
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
    /// True if no figure can meet both conditions: an object visible and hidden, two values of a key, or ranges of the
    /// same number that have none in common.
    pub fn excludes(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Seen(a), Self::Hidden(b)) | (Self::Hidden(a), Self::Seen(b)) => a == b,
            (Self::Key { key: a, value: x }, Self::Key { key: b, value: y }) => a == b && x != y,
            (Self::Quantity { path: a, range: x }, Self::Quantity { path: b, range: y }) => {
                a == b && x.and(*y).is_empty()
            }
            (Self::Angle { between: a, range: x }, Self::Angle { between: b, range: y }) => {
                a == b && x.and(*y).is_empty()
            }
            (Self::Number { key: a, range: x }, Self::Number { key: b, range: y }) => a == b && x.and(*y).is_empty(),
            _ => false,
        }
    }

    /// The name of the object that it's about.
    pub fn object(&self) -> Option<&str> {
        match self {
            Self::Seen(name) | Self::Hidden(name) => Some(name),
            Self::Quantity { .. } | Self::Angle { .. } | Self::Key { .. } | Self::Number { .. } => None,
        }
    }

    fn holds(&self, subject: Subject<'_>, seen: &mut Seen) -> bool {
        match self {
            Self::Quantity { path, range } => {
                let numbers = numbers_of(subject.figure).ok().and_then(|report| path.numbers(&report));
                numbers.is_some_and(|numbers| numbers.entries.iter().all(|number| range.holds(*number)))
            }
            Self::Angle { between, range } => {
                let angle = numbers_of(subject.figure).ok().and_then(|report| angle(*between, &report));
                angle.is_some_and(|angle| range.holds(angle))
            }
            Self::Key { key, value } => has(subject.figure, key, value),
            Self::Number { key, range } => number_at(subject.figure, key).is_some_and(|number| range.holds(number)),
            Self::Seen(name) => seen.pixels(subject, name) > 0,
            Self::Hidden(name) => seen.pixels(subject, name) == 0,
        }
    }
}

impl Range {
    /// True if it contains every number.
    pub fn is_everything(self) -> bool {
        self == Self::default()
    }

    /// True if no number is in it.
    pub fn is_empty(self) -> bool {
        self.least.zip(self.most).is_some_and(|(least, most)| least > most)
    }

    /// The numbers in both ranges.
    fn and(self, other: Self) -> Self {
        let least = self.least.into_iter().chain(other.least).reduce(f64::max);
        let most = self.most.into_iter().chain(other.most).reduce(f64::min);
        Self { least, most }
    }

    fn holds(self, number: f64) -> bool {
        self.least.is_none_or(|least| number >= least) && self.most.is_none_or(|most| number <= most)
    }
}

/// The angle between two vectors in degrees, 0 … 180; `None` if one of them isn't a vector.
pub(super) fn angle(between: [QuantityPath; 2], report: &Report) -> Option<f64> {
    let vector = |path: QuantityPath| match path.numbers(report)?.entries[..] {
        [x, y, z] => DVec3::new(x, y, z).try_normalize(),
        _ => None,
    };
    let [a, b] = between.map(vector);
    let (a, b) = (a?, b?);
    // Near 0 and 180 degrees the cosine alone has only half of the digits.
    Some(a.cross(b).length().atan2(a.dot(b)).to_degrees())
}

impl Seen {
    /// The number of pixels of a smaller image that show an object, or the objects below it.
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
