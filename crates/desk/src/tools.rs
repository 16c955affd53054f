//! The tools of the window for the author's labels, the lines on a photograph, and the list of cameras. They belong to
//! the window, not to the figure.

use glam::DVec2;

use crate::camera::{
    Convergence, ImageSize, Parameters, PhotographCamera, PhotographError, PhotographLine, PhotographMarks, WorldAxis,
    camera_of_photograph,
};
use crate::figure::{Comparison, Figure, NamedCamera};
use crate::history::Revision;
use crate::limits::MAX_UNDO_STEPS;
use crate::views::View;
use camera_lab_words::window::cameras;

/// The mode *Labels*.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LabelMode {
    /// The pointer chooses and drags labels.
    pub on: bool,
    /// The chosen label, and the picture in which it was chosen.
    pub chosen: Option<(View, String)>,
    /// The next click puts a note.
    pub adding: bool,
    /// The typed text of the chosen label. `None` for the figure's.
    pub typed: Option<String>,
    /// True if the text was put there just now. Its field gets the focus.
    pub is_new: bool,
    /// The field of the text has the focus.
    pub is_typing: bool,
}

impl LabelMode {
    /// Enters or leaves the mode.
    pub fn toggle(&mut self) {
        *self = Self { on: !self.on, ..Self::default() };
    }

    /// Chooses a label, or none.
    pub fn choose(&mut self, label: Option<(View, String)>) {
        if self.chosen != label {
            (self.chosen, self.typed) = (label, None);
        }
    }

    /// One thing after the other: stops adding a note, then leaves the mode.
    pub fn step_back(&mut self) {
        if self.adding {
            self.adding = false;
        } else {
            *self = Self::default();
        }
    }
}

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
    /// While lines are drawn, the scene is over the photograph too.
    pub has_scene: bool,
    /// The lines and points, in pixels of the image.
    pub marks: PhotographMarks,
    /// The thing that the next drag draws.
    pub drawn: Drawn,
    /// The axis and the coordinate of the point of the length, even before that exists.
    pub length: (WorldAxis, f64),
    /// The line being drawn.
    pub new_line: Option<usize>,
    /// The axis of the length in the image: the pixel of the origin, the way, and the reach within which a point snaps
    /// to it, in pixels. Set by [`find_axis`](Self::find_axis) in each frame.
    pub axis: Option<(DVec2, DVec2, f64)>,
    /// The marks of the last step of undo.
    settled: PhotographMarks,
    /// The marks before each step, and the figure's step then.
    earlier: Vec<(PhotographMarks, Revision)>,
    /// The same of the undone steps.
    later: Vec<(PhotographMarks, Revision)>,
}

impl Default for PhotographTool {
    fn default() -> Self {
        Self {
            on: false,
            has_scene: false,
            marks: PhotographMarks::default(),
            drawn: Drawn::ALL[0],
            length: (WorldAxis::X, 1.0),
            new_line: None,
            axis: None,
            settled: PhotographMarks::default(),
            earlier: Vec::new(),
            later: Vec::new(),
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

    /// Finds the axis on which the point of the length has to lie.
    pub fn find_axis(&mut self, image: ImageSize, given: &Parameters, reach: f64) {
        let axis = self.length.0;
        self.axis = self.marks.origin.and_then(|origin| {
            let found =
                camera_of_photograph(&PhotographMarks { length: None, ..self.marks.clone() }, image, given).ok()?;
            // Without θ, only its own lines tell where an axis is.
            let is_known = found.focal_length.is_some() || found.vanishing.iter().any(|point| point.axis == axis);
            is_known.then(|| (origin, found.way(axis, origin, image), reach))
        });
    }

    /// A place, on the axis of the length if it's near.
    fn snapped(&self, place: DVec2) -> DVec2 {
        let Some((origin, way, reach)) = self.axis else { return place };
        let on_axis = origin + way * way.dot(place - origin);
        if on_axis.distance(place) <= reach { on_axis } else { place }
    }

    /// Closes the tool. The lines stay for the next time.
    pub fn step_back(&mut self) {
        (self.on, self.new_line) = (false, None);
    }

    /// Opens or closes it. It opens with the photograph alone.
    pub fn toggle(&mut self) {
        (self.on, self.has_scene) = (!self.on, false);
    }

    /// Removes all marks.
    pub fn clear(&mut self) {
        (self.marks, self.has_scene) = (PhotographMarks::default(), false);
    }

    /// Makes a step of undo of the changes since the last one, after this step of the figure.
    pub fn settle(&mut self, step: Revision) {
        if self.marks != self.settled {
            self.earlier.push((std::mem::replace(&mut self.settled, self.marks.clone()), step));
            self.earlier.drain(..self.earlier.len().saturating_sub(MAX_UNDO_STEPS));
            self.later.clear();
        }
    }

    /// True if the last step (`back`), or the next one, is one of the marks. Steps of the figure that came after it
    /// come first.
    pub(crate) fn can_undo(&self, step: Revision, back: bool) -> bool {
        let steps = if back { &self.earlier } else { &self.later };
        self.on && steps.last().is_some_and(|(_, after)| *after == step)
    }

    /// Undoes a step of the marks (`back`), or redoes it.
    pub(crate) fn undo(&mut self, back: bool) {
        let (from, to) = if back { (&mut self.earlier, &mut self.later) } else { (&mut self.later, &mut self.earlier) };
        let Some((marks, step)) = from.pop() else { return };
        to.push((std::mem::replace(&mut self.settled, marks), step));
        (self.marks, self.new_line) = (self.settled.clone(), None);
    }

    /// The grips, with their places in the image.
    pub fn grips(&self) -> Vec<(Grip, DVec2)> {
        let PhotographMarks { lines, origin, length, .. } = &self.marks;
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
            Grip::Length => self.marks.length = Some((self.length.0, self.snapped(place), self.length.1)),
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

/// The list of cameras.
#[derive(Clone, Debug, Default)]
pub struct CameraList {
    /// The baseline of the next stereo pair. `None` for a thirtieth of D, as in the textbooks of stereo photography.
    pub baseline: Option<f64>,
    /// True if the search leads to one of its buttons, so that the list is unfolded.
    pub was_called: bool,
}

impl crate::Model {
    /// Looks through one of the other cameras of the figure.
    pub fn look_through(&mut self, index: usize) {
        self.desk.commit();
        self.desk.shown.look_through(index);
        // Its aspect is its own.
        let (camera, image) = (self.desk.shown.draft(), self.desk.shown.figure().image);
        let is_of_image = camera.aspect == f64::from(image.width) / f64::from(image.height);
        self.settings.aspect_follows_image &= is_of_image || camera.window.is_some();
    }

    /// Keeps the current camera in the list, unless it's full. Returns its name there.
    pub fn keep_camera(&mut self) -> String {
        let figure = self.desk.shown.figure();
        let name = figure.free_camera_name();
        let camera = NamedCamera { name: name.clone(), color: None, ..figure.current_camera() };
        self.desk.shown.edit_cameras(|figure| figure.add_camera(camera));
        name
    }

    /// The other camera whose image stands beside that of the current one, by its place in the list.
    pub fn camera_beside(&self) -> Option<usize> {
        let figure = self.desk.shown.figure();
        let name = figure.compare.as_ref()?.camera.as_ref()?;
        figure.cameras.iter().position(|other| other.name == *name)
    }

    /// Shows the image of another camera beside that of the current one, in place of any other comparison. `None` shows
    /// the current one alone.
    pub fn show_beside(&mut self, index: Option<usize>) {
        self.desk.shown.edit_cameras(|figure| {
            let other = index.and_then(|index| figure.cameras.get(index));
            figure.compare = other.map(|other| Comparison::of_camera(&other.name));
        });
    }

    /// Makes the current camera and one more a stereo pair around it. The left one becomes the current one.
    pub fn make_stereo(&mut self, baseline: f64, convergence: Convergence) {
        let t = cameras::texts(self.settings.lang);
        match self.desk.shown.camera().stereo(baseline, convergence) {
            Err(error) => self.say_camera_error(Err(error)),
            Ok([left, right]) => {
                self.desk.commit();
                let name = free(self.desk.shown.figure(), t.right);
                let parameters = *right.parameters();
                let right = NamedCamera { name, color: None, parameters, lens: None };
                let figure = self.desk.shown.figure();
                let has_it = figure.tag.name.as_deref() == Some(t.left);
                let name = if has_it { t.left.to_owned() } else { free(figure, t.left) };
                self.desk.shown.edit_cameras(|figure| {
                    figure.tag.name = Some(name);
                    figure.add_camera(right);
                });
                self.desk.shown.set_camera(left);
            }
        }
    }
}

/// The name, or if it's taken, the name with the first free number.
fn free(figure: &Figure, name: &str) -> String {
    if figure.may_name_camera(name, None) {
        return name.to_owned();
    }
    (2..).map(|i| format!("{name} {i}")).find(|name| figure.may_name_camera(name, None)).unwrap_or_default()
}
