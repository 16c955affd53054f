//! Probing without a pointer: the arrow keys move the probe from pixel to pixel, or from vertex to vertex.

use eframe::egui::{Key, Modifiers};
use glam::DVec2;

use super::picking;
use crate::camera::ImageSize;
use crate::views::{Probe, Request, View, pick};

/// Pixels for one press of an arrow key with Shift.
const FAST: f64 = 10.0;

/// The targets of the probe for the arrow keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Probing {
    /// The pixels of the image (key I).
    Pixels,
    /// The vertices that a picture shows (key V).
    Vertices,
}

impl Probing {
    /// The mode that a key begins in a picture; pixels only in the image.
    pub(super) fn asked(key: Key, view: View) -> Option<Self> {
        match (key, view) {
            (Key::I, View::Image) => Some(Self::Pixels),
            (Key::V, _) => Some(Self::Vertices),
            _ => None,
        }
    }

    /// Where the probe begins: at the middle of the image, or at the vertex nearest to the middle of the picture.
    pub(super) fn first(self, request: &Request) -> Option<Probe> {
        let ImageSize { width, height } = request.shot.look.image;
        match self {
            Self::Pixels => Some(at_pixel(request, DVec2::new(f64::from(width / 2), f64::from(height / 2)))),
            Self::Vertices => pick::vertex_beside(request, None, DVec2::ZERO).map(Probe::Point),
        }
    }

    /// Where it goes from `now` with an arrow key (`arrow`: x right, y up); stays at the border, and where there is no
    /// vertex on.
    pub(super) fn moved(self, request: &Request, now: Probe, arrow: DVec2, modifiers: Modifiers) -> Option<Probe> {
        let down = DVec2::new(arrow.x, -arrow.y);
        match (self, now) {
            (Self::Pixels, Probe::Window(point)) => {
                let ImageSize { width, height } = request.shot.look.image;
                let last = DVec2::new(f64::from(width), f64::from(height)) - 1.0;
                let step = down * if modifiers.shift { FAST } else { 1.0 };
                let pixel = picking::pixel_of(request.shot.look.image, &request.camera, point);
                Some(at_pixel(request, (pixel + step).clamp(DVec2::ZERO, last)))
            }
            (Self::Vertices, Probe::Point(p)) => {
                Some(Probe::Point(pick::vertex_beside(request, Some(p), down).unwrap_or(p)))
            }
            (Self::Pixels, Probe::Point(_)) | (Self::Vertices, Probe::Window(_)) => self.first(request),
        }
    }
}

fn at_pixel(request: &Request, pixel: DVec2) -> Probe {
    Probe::Window(picking::center_of(request.shot.look.image, &request.camera, pixel))
}
