//! The layout of the window, and requests to the pictures.

pub mod asked_layout;
pub mod view_history;

use crate::views::observer::Viewpoint;
use crate::views::{Arrangement, View, Views};

/// A change of the observer of a three-dimensional picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ObserverChange {
    /// From a side, with everything in the picture.
    From(Viewpoint),
    /// Resets it to show everything in the picture.
    Fit,
}

/// Visible pictures, and their layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// If false, the picture is hidden and not drawn. In the order of [`View::ALL`]; at least one is true.
    pub shown: [bool; View::COUNT],
    /// The picture that has all the room, even if `shown` hides it.
    pub maximized: Option<View>,
    /// The arrangement of the pictures. `None` for automatic.
    pub arrangement: Option<Arrangement>,
    /// Orbiting one three-dimensional picture turns the other too.
    pub linked: bool,
    /// The stages of the pipeline are shown under the pictures.
    pub strip: bool,
    /// The view of the stages.
    pub strip_of: View,
    /// The views and their arrangement as they were when the presentation began.
    before_presentation: Option<([bool; View::COUNT], Option<Arrangement>)>,
}

impl Default for Layout {
    fn default() -> Self {
        Self {
            shown: [true; View::COUNT],
            maximized: None,
            arrangement: None,
            linked: false,
            strip: false,
            strip_of: View::Image,
            before_presentation: None,
        }
    }
}

impl Layout {
    /// True if the picture is on the screen.
    pub fn is_shown(&self, view: View) -> bool {
        match self.maximized {
            Some(only) => only == view,
            None => self.shown[view.index()],
        }
    }

    /// Begins or ends a presentation. Its hidden parts and its arrangement end with it.
    pub fn turn_presentation(&mut self, begins: bool) {
        if begins {
            self.before_presentation = Some((self.shown, self.arrangement));
        } else if let Some((shown, arrangement)) = self.before_presentation.take() {
            (self.shown, self.arrangement, self.maximized) = (shown, arrangement, None);
        }
    }

    /// The pictures on the screen.
    pub fn views(&self) -> Views {
        let is_shown = |view: &View| self.is_shown(*view);
        let shown: Vec<View> = View::ALL.into_iter().filter(is_shown).collect();
        match (shown.as_slice(), View::ALL.into_iter().find(|view| !is_shown(view))) {
            ([one], _) => Views::One(*one),
            (_, Some(hidden)) => Views::Without(hidden),
            (_, None) => Views::All,
        }
    }

    /// Shows or hides a picture. The last one stays.
    pub fn toggle(&mut self, view: View) {
        if let Some(only) = self.maximized.take() {
            self.shown = [false; View::COUNT];
            self.shown[only.index()] = true;
        }
        let shown = &mut self.shown[view.index()];
        *shown = !*shown;
        if self.shown == [false; View::COUNT] {
            self.shown[view.index()] = true;
        }
    }
}

/// The place of a window on its screen, in points of an interface that is neither enlarged nor reduced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WindowPlace {
    /// The upper left corner. `None` if the system doesn't give it.
    pub at: Option<[i32; 2]>,
    /// Width and height of its content when it isn't maximized.
    pub size: [u32; 2],
    /// It fills the screen.
    pub maximized: bool,
}

/// A panel at a side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    /// The parameters.
    #[default]
    Left,
    /// The operations and the numbers.
    Right,
    /// The explanations, in the place of operations and numbers.
    Explain,
}

/// A tab of the panel on the left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Tab {
    /// Camera, projection, view window, image.
    #[default]
    Camera,
    /// Objects and lights.
    Scene,
    /// The style of the drawing.
    Drawing,
}

/// Panels requested by the user, and panels that fit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Panels {
    /// Requested by the user, in the order of [`Side`].
    pub wanted: [bool; 3],
    /// The side that stays if two don't fit.
    pub last: Side,
    /// Only one panel fits.
    pub narrow: bool,
}

impl Panels {
    /// True if the panel is on the screen.
    pub fn is_shown(&self, side: Side) -> bool {
        let [left, right, explain] = self.wanted;
        let at_right = right || explain;
        match side {
            Side::Left => left && !(self.narrow && at_right && self.last != Side::Left),
            Side::Right => right && !explain && !(self.narrow && left && self.last == Side::Left),
            Side::Explain => explain && !(self.narrow && left && self.last == Side::Left),
        }
    }

    /// Shows a panel.
    pub fn show(&mut self, side: Side) {
        if !self.is_shown(side) {
            self.toggle(side);
        }
    }

    /// Shows or hides a panel.
    pub fn toggle(&mut self, side: Side) {
        let shown = self.is_shown(side);
        self.wanted[side as usize] = !shown;
        if !shown {
            self.last = side;
            self.wanted[Side::Explain as usize] &= side != Side::Right;
        }
    }
}
