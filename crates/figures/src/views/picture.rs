//! The pictures of a shot, as a list: three of a figure, or as many as another caller asks for.

use super::View;
use crate::camera::Camera;
use crate::figure::{Observer, Observers};

/// The most pictures shown at a time.
pub const MAX_PICTURES: usize = 8;

/// One picture of a shot: its kind, its observer, and its camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// The world, the canonical volume, or the image.
    pub kind: View,
    /// The observer of a three-dimensional picture; `None` means from a corner, with everything in the picture. Only
    /// the camera sees the image.
    pub observer: Option<Observer>,
    /// Its camera; `None` means that of the figure.
    pub camera: Option<Camera>,
}

impl Picture {
    /// A picture of the figure's camera.
    pub const fn new(kind: View, observer: Option<Observer>) -> Self {
        Self { kind, observer, camera: None }
    }

    /// The three pictures of a figure, in the order of [`View::ALL`].
    pub fn of_figure(observers: &Observers) -> Vec<Self> {
        View::ALL.into_iter().map(|kind| Self::new(kind, observer_in(observers, kind))).collect()
    }

    /// The observers of the first picture of each kind.
    pub fn observers(pictures: &[Self]) -> Observers {
        let of = |kind| pictures.iter().find(|picture| picture.kind == kind).and_then(|picture| picture.observer);
        Observers { world: of(View::World), canonical: of(View::Canonical) }
    }
}

/// The observer of a picture in a figure.
pub fn observer_in(observers: &Observers, kind: View) -> Option<Observer> {
    match kind {
        View::World => observers.world,
        View::Canonical => observers.canonical,
        View::Image => None,
    }
}
