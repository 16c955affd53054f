//! The followed point.

use crate::figure::NamedPoint;

/// A space in which the user types a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Space {
    /// The space of the selected object.
    Local,
    /// The world.
    World,
    /// VRC.
    View,
    /// NDC, in the convention of the window.
    Ndc,
    /// (x_p, y_p) and the distance from the eye.
    Window,
    /// (i, j) and Z.
    Pixel,
}

/// The tab that follows a point.
#[derive(Clone, Debug, Default)]
pub struct Follow {
    /// The name of the followed point.
    pub chosen: Option<String>,
    /// The reason why the last typed coordinates belong to no point. Shown until the user types again.
    pub refused: Option<(Space, crate::camera::NotProjectable)>,
}

impl Follow {
    /// The index of the followed point in the list. The first one if the chosen one is gone. `None` without points.
    pub fn index(&self, points: &[NamedPoint]) -> Option<usize> {
        let chosen = self.chosen.as_ref().and_then(|name| points.iter().position(|point| point.name == *name));
        chosen.or_else(|| (!points.is_empty()).then_some(0))
    }

    /// Follows a point from now on.
    pub fn choose(&mut self, name: &str) {
        *self = Self { chosen: Some(name.to_owned()), ..Self::default() };
    }
}
