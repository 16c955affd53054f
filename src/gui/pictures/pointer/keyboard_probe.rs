//! Probing without a pointer: the arrow keys move the probe from pixel to pixel, or from vertex to vertex.

use eframe::egui::Key;
use glam::DVec2;

use super::picking::{center_of, pixel_of};
use crate::camera::ImageSize;
use crate::views::{Probe, Request, View, pick};

/// Pixels for one press of an arrow key with Shift.
const FAST: f64 = 10.0;

/// The targets of the probe for the arrow keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::gui::pictures) enum Probing {
    /// The pixels of the image (key I).
    Pixels,
    /// The vertices that a picture shows (key V).
    Vertices,
}

impl Probing {
    /// The mode that a key begins in a picture. Pixels only in the image.
    pub(in crate::gui::pictures) fn asked(key: Key, view: View) -> Option<Self> {
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
pub(in crate::gui::pictures) struct ProbeStep {
    pub(in crate::gui::pictures) probing: Probing,
    /// The start. `None` if it begins.
    pub(in crate::gui::pictures) from: Option<Probe>,
    /// x right, y up.
    pub(in crate::gui::pictures) arrow: DVec2,
    /// By several pixels.
    pub(in crate::gui::pictures) fast: bool,
}

impl ProbeStep {
    /// The new place of the probe. `None` if there is nothing to probe.
    pub(in crate::gui::pictures) fn taken(self, request: &Request) -> Option<Probe> {
        match self.from {
            Some(now) => self.probing.moved(request, now, self.arrow, self.fast).or(Some(now)),
            None => self.probing.first(request),
        }
    }
}

fn at_pixel(request: &Request, pixel: DVec2) -> Probe {
    Probe::Window(center_of(request.shot.look.image, &request.camera, pixel))
}
