//! The words of the photograph under the image, and of the tool that finds its camera, in both languages.

use crate::Lang;
use crate::camera::WorldAxis;

texts!("window/photograph");

/// The name of an end of a line: its number from 1 and its axis, and true for the first end.
pub fn end(lang: Lang, (number, axis): (usize, WorldAxis), is_first: bool) -> String {
    let axis = axis.name();
    if is_first { text!(lang, end_is_first, number, axis) } else { text!(lang, end_first, number, axis) }
}

/// A point on an axis with its coordinate: x = 2.
pub fn length(lang: Lang, (axis, coordinate): (WorldAxis, f64)) -> String {
    format!("{} = {}", axis.name(), lang.mark().number(coordinate, 4))
}

/// The count of lines along each axis.
pub fn counts(lang: Lang, [x, y, z]: [usize; 3]) -> String {
    text!(lang, counts, x, y, z)
}

/// The size of the photograph.
pub fn size(lang: Lang, [width, height]: [u32; 2]) -> String {
    text!(lang, size, width, height)
}
