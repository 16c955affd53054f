//! The lines and points on the photograph, and the kind that the next drag draws. They belong to the window, not to the
//! figure.

use glam::DVec2;

use crate::camera::{ImageSize, Parameters};
use crate::camera::{
    PhotographCamera, PhotographError, PhotographLine, PhotographMarks, WorldAxis, camera_of_photograph,
};

/// The marks that a drag on the photograph can draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawn {
    /// A line along an axis.
    Line(WorldAxis),
    /// The pixel of the origin.
    Origin,
    /// A point on an axis with a known coordinate.
    Length,
}

impl Drawn {
    /// All, in the order of the menu.
    pub const ALL: [Self; 5] =
        [Self::Line(WorldAxis::X), Self::Line(WorldAxis::Y), Self::Line(WorldAxis::Z), Self::Origin, Self::Length];
}

/// A mark that can be dragged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Grip {
    /// An end of a line, with the place of the line in the list, and 0 or 1.
    End(usize, usize),
    /// The origin.
    Origin,
    /// The point of the length.
    Length,
}

/// The tool.
#[derive(Clone, Debug, PartialEq)]
pub struct PhotographTool {
    /// Lines are shown and drawn.
    pub on: bool,
    /// The lines and points, in pixels of the image.
    pub marks: PhotographMarks,
    /// The thing that the next drag draws.
    pub drawn: Drawn,
    /// The axis and the coordinate of the point of the length, even before that exists.
    pub length: (WorldAxis, f64),
    /// The line being drawn.
    pub new_line: Option<usize>,
}

impl Default for PhotographTool {
    fn default() -> Self {
        Self {
            on: false,
            marks: PhotographMarks::default(),
            drawn: Drawn::ALL[0],
            length: (WorldAxis::X, 1.0),
            new_line: None,
        }
    }
}

/// A shorter line, in pixels of the screen, was a click.
pub const SHORTEST: f32 = 6.0;

impl PhotographTool {
    /// The camera of the marks, or the reason why there is none.
    ///
    /// # Errors
    /// [`PhotographError`].
    pub fn camera(&self, image: ImageSize, given: &Parameters) -> Result<PhotographCamera, PhotographError> {
        camera_of_photograph(&self.marks, image, given)
    }

    /// Closes the tool. The lines stay for the next time.
    pub fn step_back(&mut self) {
        (self.on, self.new_line) = (false, None);
    }

    /// Removes all marks.
    pub fn clear(&mut self) {
        self.marks = PhotographMarks::default();
    }

    /// The grips, with their places in the image.
    pub fn grips(&self) -> Vec<(Grip, DVec2)> {
        let PhotographMarks { lines, origin, length } = &self.marks;
        let ends = lines.iter().enumerate().flat_map(|(i, line)| [0, 1].map(|end| (Grip::End(i, end), line.ends[end])));
        let origin = origin.map(|at| (Grip::Origin, at));
        let length = length.map(|(_, at, _)| (Grip::Length, at));
        ends.chain(origin).chain(length).collect()
    }

    /// Moves a grip to a place in the image.
    pub fn move_to(&mut self, grip: Grip, place: DVec2) {
        match grip {
            Grip::End(line, end) => {
                if let Some(line) = self.marks.lines.get_mut(line) {
                    line.ends[end] = place;
                }
            }
            Grip::Origin => self.marks.origin = Some(place),
            Grip::Length => self.marks.length = Some((self.length.0, place, self.length.1)),
        }
    }

    /// Removes the mark that a grip belongs to. For an end, the whole line.
    pub fn remove(&mut self, grip: Grip) {
        match grip {
            Grip::End(line, _) if line < self.marks.lines.len() => drop(self.marks.lines.remove(line)),
            Grip::End(..) => {}
            Grip::Origin => self.marks.origin = None,
            Grip::Length => self.marks.length = None,
        }
    }

    /// Begins the next mark at a place.
    pub fn begin(&mut self, place: DVec2) {
        match self.drawn {
            Drawn::Line(axis) => {
                self.new_line = Some(self.marks.lines.len());
                self.marks.lines.push(PhotographLine { axis, ends: [place; 2] });
            }
            Drawn::Origin => self.move_to(Grip::Origin, place),
            Drawn::Length => self.move_to(Grip::Length, place),
        }
    }

    /// Goes on with it.
    pub fn go_on(&mut self, place: DVec2) {
        match (self.new_line, self.drawn) {
            (Some(line), _) => self.move_to(Grip::End(line, 1), place),
            (None, Drawn::Origin) => self.move_to(Grip::Origin, place),
            (None, Drawn::Length) => self.move_to(Grip::Length, place),
            (None, Drawn::Line(_)) => {}
        }
    }

    /// Ends a new line, which is removed if it's too short to be one.
    pub fn end(&mut self, is_long_enough: bool) {
        if let Some(line) = self.new_line.take().filter(|_| !is_long_enough) {
            self.marks.lines.truncate(line);
        }
    }
}
