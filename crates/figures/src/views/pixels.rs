//! Sizes and rectangles in pixels, and the place of the image in a picture.

use crate::appearance::Rgba;
use crate::pipeline::Target;

/// The size of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Pixels for one unit of stroke width or type size: 1 on a plain screen, 2 if pixels are small or in a large
    /// export.
    pub scale: f32,
}

/// The size of the letters of names in a picture of scale 1 and middling size, in pixels.
const LETTERS: f32 = 14.0;

/// Pictures up to this size fill a screen without enlargement.
const SCREEN: [f32; 2] = [1920.0, 1080.0];

/// Growth of letters and strokes with the side of a picture (`side`, in units of stroke width).
#[expect(clippy::cast_possible_truncation, reason = "0.8 … 1.6")]
fn growth(side: f32) -> f32 {
    (f64::from(side) / 480.0).powf(0.4).clamp(0.8, 1.6) as f32
}

impl Size {
    /// The width of the edges of solids relative to the height of the letters of names, if strokes are in proportion.
    pub const EDGES_TO_LETTERS: f64 = 1.0 / LETTERS as f64;

    /// Letters and strokes as on a screen of 1920 × 1080. A picture that's larger in both directions has them larger by
    /// the same factor.
    pub fn as_on_a_screen(width: u32, height: u32) -> Self {
        let [x, y] = [width as f32 / SCREEN[0], height as f32 / SCREEN[1]];
        Self { width, height, scale: x.min(y).max(1.0) }
    }

    /// Names in letters of this number of pixels (the height of the type), and strokes in proportion.
    pub fn with_letters(width: u32, height: u32, letters: f32) -> Self {
        let wanted = letters / LETTERS;
        let of = |scale: f32| Self { width, height, scale };
        // The growth depends on the scale. It falls as the scale rises, so that their product rises.
        let (mut low, mut high) = (wanted / 1.6, wanted / 0.8);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if of(middle).type_scale() < wanted { low = middle } else { high = middle }
        }
        of(high)
    }

    /// The height of the type of names, in pixels.
    pub fn letters(self) -> f32 {
        LETTERS * self.type_scale()
    }

    /// The factor of stroke widths that makes the edges of solids this number of pixels wide.
    pub fn stroke_factor(self, edges: f32) -> f32 {
        edges / self.type_scale()
    }

    /// Pixels for one unit of stroke width and of type size.
    pub(super) fn type_scale(self) -> f32 {
        let (width, height) = (self.width as f32, self.height as f32);
        self.scale * growth(height.min(0.8 * width) / self.scale.max(0.1))
    }

    /// Width / height; 1 for an empty picture.
    pub fn aspect(&self) -> f64 {
        if self.width == 0 || self.height == 0 { 1.0 } else { f64::from(self.width) / f64::from(self.height) }
    }

    /// The smaller of width and height, in pixels. Across it an observer has its view angle.
    pub fn smaller_side(&self) -> f64 {
        f64::from(self.width.min(self.height))
    }

    /// Letters and strokes grow a little with the picture, so that they're neither too fine in a large one nor too big
    /// in a small one.
    pub(super) fn target(self, background: Rgba) -> Target {
        Target { width: self.width, height: self.height, scale: self.type_scale(), background }
    }
}

/// A rectangle of a picture, in pixels; (0, 0) is the top left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelRect {
    /// Left.
    pub x: u32,
    /// Top.
    pub y: u32,
    /// Width, at least 1 in a picture that isn't empty.
    pub width: u32,
    /// Height, at least 1 in a picture that isn't empty.
    pub height: u32,
}

impl PixelRect {
    /// All of a picture.
    pub(super) fn whole(size: Size) -> Self {
        Self { x: 0, y: 0, width: size.width, height: size.height }
    }
}

/// The place of the image in a picture of this size: the largest rectangle with its aspect (to the nearest pixel;
/// [`Look::image_aspect`](super::Look::image_aspect)), in the middle. The whole picture if that has m × n pixels.
pub fn image_frame(size: Size, aspect: f64) -> PixelRect {
    let width = rounded(f64::from(size.height) * aspect, size.width);
    let height = rounded(f64::from(size.width) / aspect, size.height);
    PixelRect { x: (size.width - width) / 2, y: (size.height - height) / 2, width, height }
}

/// The nearest whole number of pixels, 1 … `most`.
fn rounded(pixels: f64, most: u32) -> u32 {
    let bounded = pixels.round().clamp(1.0_f64.min(f64::from(most)), f64::from(most));
    #[expect(clippy::cast_possible_truncation, reason = "a whole number in 0 … most")]
    let whole = bounded as u32;
    whole
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size(width: u32, height: u32) -> Size {
        Size { width, height, scale: 1.0 }
    }

    #[test]
    fn letters_grow_beyond_screen_size_and_have_the_requested_height() {
        assert_eq!(Size::as_on_a_screen(1920, 1080).scale, 1.0);
        assert_eq!(Size::as_on_a_screen(8000, 600).scale, 1.0);
        assert_eq!(Size::as_on_a_screen(3840, 2160).scale, 2.0);
        let (screen, large) = (Size::as_on_a_screen(1440, 1080), Size::as_on_a_screen(5760, 4320));
        assert!((large.letters() / screen.letters() - 3.0).abs() < 0.5, "{} {}", large.letters(), screen.letters());
        for (width, height, letters) in [(945, 709, 37.5), (300, 200, 9.0), (6000, 4000, 60.0), (2000, 100, 14.0)] {
            let size = Size::with_letters(width, height, letters);
            assert!((size.letters() - letters).abs() < 0.01 * letters, "{size:?}: {}", size.letters());
        }
    }

    #[test]
    fn the_frame_has_the_windows_aspect_and_lies_in_the_middle() {
        let rect = |x, y, width, height| PixelRect { x, y, width, height };
        assert_eq!(image_frame(size(400, 300), 4.0 / 3.0), rect(0, 0, 400, 300));
        assert_eq!(image_frame(size(400, 300), 1.0), rect(50, 0, 300, 300));
        assert_eq!(image_frame(size(400, 300), 2.0), rect(0, 50, 400, 200));
        assert_eq!(image_frame(size(401, 300), 0.5), rect(125, 0, 150, 300));
    }

    #[test]
    fn an_extreme_window_still_has_a_frame() {
        for aspect in [1e-12, 1e12] {
            let f = image_frame(size(400, 300), aspect);
            assert!(f.width >= 1 && f.height >= 1 && f.x + f.width <= 400 && f.y + f.height <= 300, "{f:?}");
        }
        assert_eq!(image_frame(size(0, 0), 1.0), PixelRect { x: 0, y: 0, width: 0, height: 0 });
    }
}
