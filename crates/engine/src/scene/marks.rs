//! The marks of points and their names.

use glam::DVec3;

use super::{PointMark, Text};
use crate::appearance::{MarkShape, Rgba};
use crate::text::literal;

/// Half the width of a point's mark, in pixels at scale 1.
const MARK_RADIUS: f32 = 4.0;
/// Height of a point's name, in pixels at scale 1.
const NAME_SIZE: f32 = 14.0;

/// The mark of a point.
pub(super) fn point_mark(position: DVec3, shape: MarkShape, color: Rgba) -> PointMark {
    PointMark { position, shape, radius: MARK_RADIUS, color, fade_if_hidden: true }
}

/// The name of an object that is a point, as you type it.
pub(super) fn object_name(position: DVec3, name: &str, color: Rgba) -> Text {
    Text { text: literal(name), ..point_name(position, name, color) }
}

/// The name beside a point, with subscripts.
pub(super) fn point_name(position: DVec3, text: &str, color: Rgba) -> Text {
    Text {
        name: text.to_owned(),
        position,
        text: text.to_owned(),
        offset: [8.0, -8.0],
        size: NAME_SIZE,
        color,
        fade_if_hidden: true,
    }
}
