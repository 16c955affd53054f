//! Budgets of a drawing, and the shortfall if one is exceeded.

use crate::limits::{MAX_PIECES, MAX_STROKE_STEPS};
use crate::sanitize::escaped;

/// An exceeded budget.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum OverBudget {
    /// Faces that cross one another make too many pieces. They weren't sorted, and a depth buffer has to decide.
    #[error(
        "the faces of {} cross too often to be split (more than {MAX_PIECES} pieces), and the depth buffer decides; allowed: fewer faces, or visibility = \"depth-buffer\"",
        names(objects, "and others")
    )]
    Pieces {
        /// The objects with these faces, the one with most of them first.
        objects: Vec<String>,
    },
    /// Strokes meet too many faces or one another too often. Their visible parts and their order were not found.
    #[error(
        "strokes meet too many faces or one another too often to be drawn without a depth buffer (more than {MAX_STROKE_STEPS} steps); allowed: fewer edges and lines"
    )]
    Strokes,
    /// Rounding puts vertices more than a quarter of a pixel off their places: the picture magnifies more than
    /// coordinates have digits.
    #[error(
        "{}: the image magnifies more than coordinates have digits; allowed: a wider window, or scene and camera nearer to the origin",
        vertex_offsets(vertices)
    )]
    Rounding {
        /// The vertex of each object that is farthest off its place, the farthest of all first; at least one.
        vertices: Vec<MisplacedVertex>,
    },
}

/// The vertex of an object that is drawn farthest off its place.
#[derive(Clone, Debug, PartialEq)]
pub struct MisplacedVertex {
    /// The object's name.
    pub object: String,
    /// The index of the vertex in the mesh, from 0.
    pub vertex: usize,
    /// Distance between its place and its drawn position, pixels. More than a quarter.
    pub off: f64,
}

fn vertex_offsets(vertices: &[MisplacedVertex]) -> String {
    let one = |MisplacedVertex { object, vertex, off }: &MisplacedVertex| {
        format!("vertex {vertex} of {:?} is drawn {off:.1} px off", escaped(object))
    };
    let first = vertices.first().map(one).unwrap_or_default();
    match vertices.len() {
        0 | 1 => first,
        objects => format!("{first}, and so are vertices of other objects ({})", objects - 1),
    }
}

impl OverBudget {
    /// `shares`: how many pieces each object of the scene has, by its name. `None` if only gear was split.
    pub(crate) fn pieces<'a>(shares: impl Iterator<Item = (&'a str, usize)>) -> Option<Self> {
        let mut shares: Vec<(&str, usize)> = shares.collect();
        shares.sort_by_key(|(_, share)| std::cmp::Reverse(*share));
        let objects: Vec<String> = shares.into_iter().map(|(name, _)| name.to_owned()).collect();
        (!objects.is_empty()).then_some(Self::Pieces { objects })
    }

    /// `None` if no vertex is.
    pub(crate) fn rounding(vertices: Vec<MisplacedVertex>) -> Option<Self> {
        (!vertices.is_empty()).then_some(Self::Rounding { vertices })
    }
}

/// The most objects that are named.
const MOST_NAMES: usize = 3;

/// The names of a few objects, in quotes; `rest` replaces the others.
pub fn names(objects: &[String], rest: &str) -> String {
    let mut named: Vec<String> = objects.iter().take(MOST_NAMES).map(|name| format!("{:?}", escaped(name))).collect();
    if objects.len() > MOST_NAMES {
        named.push(rest.to_owned());
    }
    named.join(", ")
}
