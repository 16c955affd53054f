//! *Predict first*: the expected effect of an operation, and the real one.

use glam::DVec3;

use crate::camera::{Camera, Convention, Freedom, ImageSize};
use crate::history::Revision;

/// An invisible change of size.
const SAME: f64 = 0.01;
/// A point has room for its name this share of a side away from the border.
const BORDER: f64 = 0.15;
/// A place is right within this share of the shorter side of the image.
const NEAR: f64 = 0.05;

/// The switch, and the operation that waits for a prediction.
#[derive(Clone, Debug, Default)]
pub struct Predict {
    /// Operations ask first.
    pub on: bool,
    /// The operation that asks, or whose prediction was compared last.
    pub asked: Option<Prediction>,
}

impl Predict {
    /// Puts the mark of the question there.
    pub fn put_mark(&mut self, place: [f64; 2]) {
        if let Some(Prediction { about: About::Place { mark, .. }, .. }) = &mut self.asked {
            *mark = Some(place);
        }
    }
}

/// An operation that asks about its effect.
#[derive(Clone, Debug)]
pub struct Prediction {
    /// The operation.
    pub freedom: Freedom,
    /// Its amount.
    pub amount: f64,
    /// Its question.
    pub about: About,
    /// The document with the camera that it moves. Another document ends it.
    pub document: Revision,
    /// True once it's done. Then the prediction is compared with the outcome.
    pub is_done: bool,
}

/// The subject of a question. Places are pixels from the left edge of the image and from its upper one.
#[derive(Clone, Debug, PartialEq)]
pub enum About {
    /// A vertex of the scene, in the image before and after.
    Place {
        /// Its place before.
        from: [f64; 2],
        /// Its place afterwards.
        to: [f64; 2],
        /// Its expected place.
        mark: Option<[f64; 2]>,
        /// The size of the image.
        image: ImageSize,
    },
    /// The objects in the image.
    Size {
        /// The factor of their size.
        times: f64,
        /// The expectation.
        said: Option<Change>,
    },
}

/// A change of size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Larger.
    Larger,
    /// Smaller.
    Smaller,
    /// As large as before.
    Same,
}

impl Change {
    /// All, in the order of the menu.
    pub const ALL: [Self; 3] = [Self::Larger, Self::Smaller, Self::Same];

    /// The change by a factor.
    pub fn of(times: f64) -> Self {
        match times {
            _ if times > 1.0 + SAME => Self::Larger,
            _ if times < 1.0 - SAME => Self::Smaller,
            _ => Self::Same,
        }
    }
}

impl About {
    /// The question of an operation, by its effect on the scene. `None` if the image has no content before and after it
    /// that can be followed.
    pub fn of(
        (camera, image, scene): (&Camera, ImageSize, &crate::scene::Scene),
        (freedom, amount): (Freedom, f64),
        convention: Convention,
    ) -> Option<Self> {
        let after = freedom.by(amount).apply(camera, convention).ok()?;
        let seen = |camera: &Camera, point: DVec3| {
            crate::exercises::place_of(camera, image, point).filter(|at| is_in(*at, image, 0.0))
        };
        let both = |point: DVec3| Some([seen(camera, point)?, seen(&after, point)?]);
        let followed: Vec<[[f64; 2]; 2]> = scene.vertices().filter_map(|vertex| both(vertex.p_world)).collect();
        if freedom == Freedom::Zoom {
            return size(&followed).map(|times| Self::Size { times, said: None });
        }
        // The highest in the image is on the outline, so no face hides it. Near the border its name would be cut off.
        let is_near_border = |at: [f64; 2]| !is_in(at, image, BORDER);
        let height = |places: &[[f64; 2]; 2]| (places.iter().any(|at| is_near_border(*at)), places[0][1]);
        let highest = followed.into_iter().min_by(|a, b| {
            let (a, b) = (height(a), height(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        })?;
        Some(Self::Place { from: highest[0], to: highest[1], mark: None, image })
    }

    /// True once the user has predicted it.
    pub fn is_said(&self) -> bool {
        match self {
            Self::Place { mark, .. } => mark.is_some(),
            Self::Size { said, .. } => said.is_some(),
        }
    }

    /// The distance of a mark from the point's destination, pixels to the right and down.
    pub fn off(&self) -> Option<[f64; 2]> {
        let Self::Place { to, mark, .. } = self else { return None };
        mark.map(|mark| [mark[0] - to[0], mark[1] - to[1]])
    }

    /// True if the prediction was right.
    pub fn is_right(&self) -> bool {
        match self {
            Self::Place { image, .. } => {
                let near = NEAR * f64::from(image.width.min(image.height));
                self.off().is_some_and(|[x, y]| x.hypot(y) <= near)
            }
            Self::Size { times, said } => *said == Some(Change::of(*times)),
        }
    }
}

/// True if a place is in the image, away from its border by this share of each side.
fn is_in(at: [f64; 2], image: ImageSize, border: f64) -> bool {
    let sides = [image.width, image.height].map(f64::from);
    at.iter().zip(sides).all(|(at, side)| (border * side..=(1.0 - border) * side).contains(at))
}

/// The factor by which the distance of two points grows: the first and the one farthest from it.
fn size(followed: &[[[f64; 2]; 2]]) -> Option<f64> {
    let first = followed.first()?;
    let apart = |of: &[[f64; 2]; 2], k: usize| (of[k][0] - first[k][0]).hypot(of[k][1] - first[k][1]);
    let farthest = followed.iter().max_by(|a, b| apart(a, 0).total_cmp(&apart(b, 0)))?;
    (apart(farthest, 0) > 0.0).then(|| apart(farthest, 1) / apart(farthest, 0))
}
