//! Probing without a pointer: the arrow keys move the probe from pixel to pixel, or from vertex to vertex.

use eframe::egui::Key;
use glam::DVec2;

use crate::camera::{Camera, ImageSize};
use crate::views::{Probe, Request, View, pick};

/// Pixels for one press of an arrow key with Shift.
const FAST: f64 = 10.0;

/// The targets of the probe for the arrow keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::gui::views) enum Probing {
    /// The pixels of the image (key I).
    Pixels,
    /// The vertices that a picture shows (key V).
    Vertices,
}

impl Probing {
    /// The mode that a key begins in a picture. Pixels only in the image.
    pub(in crate::gui::views) fn asked(key: Key, view: View) -> Option<Self> {
        match (key, view) {
            (Key::I, View::Image) => Some(Self::Pixels),
            (Key::V, _) => Some(Self::Vertices),
            _ => None,
        }
    }

    /// The first target: the pixel at the middle of the image, or the vertex nearest to the middle of the picture.
    fn first(self, request: &Request) -> Option<Probe> {
        let ImageSize { width, height } = request.shot.look.image;
        match self {
            Self::Pixels => Some(at_pixel(request, DVec2::new(f64::from(width / 2), f64::from(height / 2)))),
            Self::Vertices => pick::vertex_beside(request, None, DVec2::ZERO).map(Probe::Point),
        }
    }

    /// The target next to `now` in the direction of an arrow key (`arrow`, x right and y up). Stays at the border, and
    /// if there is no vertex beyond.
    fn moved(self, request: &Request, now: Probe, arrow: DVec2, fast: bool) -> Option<Probe> {
        let down = DVec2::new(arrow.x, -arrow.y);
        match (self, now) {
            (Self::Pixels, Probe::Window(point)) => {
                let ImageSize { width, height } = request.shot.look.image;
                let last = DVec2::new(f64::from(width), f64::from(height)) - 1.0;
                let step = down * if fast { FAST } else { 1.0 };
                let pixel = pixel_of(request.shot.look.image, &request.camera, point);
                Some(at_pixel(request, (pixel + step).clamp(DVec2::ZERO, last)))
            }
            (Self::Vertices, Probe::Point(p)) => {
                Some(Probe::Point(pick::vertex_beside(request, Some(p), down).unwrap_or(p)))
            }
            (Self::Pixels, Probe::Point(_)) | (Self::Vertices, Probe::Window(_)) => self.first(request),
        }
    }
}

/// A key that moves the probe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::gui::views) struct ProbeStep {
    pub(in crate::gui::views) probing: Probing,
    /// The start. `None` if it begins.
    pub(in crate::gui::views) from: Option<Probe>,
    /// x right, y up.
    pub(in crate::gui::views) arrow: DVec2,
    /// By several pixels.
    pub(in crate::gui::views) fast: bool,
}

impl ProbeStep {
    /// The new place of the probe. `None` if there is nothing to probe.
    pub(in crate::gui::views) fn taken(self, request: &Request) -> Option<Probe> {
        match self.from {
            Some(now) => self.probing.moved(request, now, self.arrow, self.fast).or(Some(now)),
            None => self.probing.first(request),
        }
    }
}

fn at_pixel(request: &Request, pixel: DVec2) -> Probe {
    Probe::Window(center_of(request.shot.look.image, &request.camera, pixel))
}

/// The pixel (i, j) of the figure's image at a point of the view window, `[0]` Eq. (5.22). On the right and the lower
/// border, the last one.
pub(in crate::gui::views) fn pixel_of(image: ImageSize, camera: &Camera, point: DVec2) -> DVec2 {
    let last = DVec2::new(f64::from(image.width), f64::from(image.height)) - 1.0;
    image.image_from_window(&camera.window(), point).floor().clamp(DVec2::ZERO, last.max(DVec2::ZERO))
}

/// The point of the view window at the centre of a pixel, `[0]` Eq. (5.23).
pub(in crate::gui::views) fn center_of(image: ImageSize, camera: &Camera, pixel: DVec2) -> DVec2 {
    image.window_from_image(&camera.window(), pixel + 0.5)
}
