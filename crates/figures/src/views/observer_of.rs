//! The observer of another figure, for the pictures of a series.

use super::{Request, SharedScene, Shot};
use crate::camera::Camera;
use crate::figure::Observer;

/// A figure whose observers serve others.
#[derive(Clone, Debug, PartialEq)]
pub struct ObserverOf {
    /// The content of its pictures.
    pub shot: Shot,
    /// The camera of that figure.
    pub camera: Camera,
    /// The scene of that figure.
    pub scene: SharedScene,
}

impl ObserverOf {
    /// The observer of its picture of the kind and the size of another one; `None` for an image.
    pub fn observer(&self, like: &Request) -> Option<Observer> {
        let own = Request::new(&self.shot, like.view, &self.camera, &self.scene, like.labels, like.size);
        own.seen_from()
    }
}
