//! Steps, signs and the held slider.

pub mod motion;
pub mod predict;

use crate::camera::{Camera, Convention, Freedom, OPERATIONS, Operation};
use crate::exercises::Ask;
use crate::model::Model;
use crate::operations::predict::{About, Predict, Prediction};
use crate::views::{Ghost, View};
use camera_lab_words::window::predict as words;

/// The state of the panel of operations.
#[derive(Clone, Debug)]
pub struct Operations {
    /// The step of each button: degrees, factor or scene units, in the order of [`OPERATIONS`].
    pub steps: [f64; OPERATIONS.len()],
    /// The operation whose slider is shown.
    open: Freedom,
    /// The rows above it that are still open, so that no row moves under the pointer.
    open_above: Vec<Freedom>,
    /// Predictions of the effect of an operation, before it's done.
    pub predict: Predict,
    /// The convention of the signs.
    pub convention: Convention,
    /// The slider that is being pulled.
    pub scrub: Option<Scrub>,
    /// The last step done, while the world shows it.
    pub done: Option<DoneStep>,
    /// The last operation done, by a button or a slider.
    pub last: Option<Ghost>,
    /// The kept operations, and the camera after the last of them. The next one continues from there.
    kept: Option<(Vec<Operation>, Camera)>,
}

impl Operations {
    /// True for an operation whose slider is shown.
    pub fn shows(&self, freedom: Freedom) -> bool {
        self.open == freedom || self.open_above.contains(&freedom)
    }

    /// Shows the slider of an operation. Its row stays in place.
    pub fn open(&mut self, freedom: Freedom) {
        self.open_above.push(self.open);
        self.open_above.retain(|other| (*other as usize) < freedom as usize);
        self.open = freedom;
    }

    /// Leaves one operation open.
    pub fn close_others(&mut self) {
        self.open_above.clear();
    }

    /// The operation that led to this camera, by the notes' signs. `None` if it has another origin.
    pub fn led_to(&self, camera: &Camera) -> Option<(Operation, &Camera)> {
        let Ghost { before, operation, convention } = self.last.as_ref()?;
        let after = operation.apply(before, *convention).ok()?;
        let turned = |turn: fn(crate::geometry::Angle) -> Operation| operation.right_hand_angle(*convention).map(turn);
        let operation = match operation {
            Operation::Elevation(_) => turned(Operation::Elevation)?,
            Operation::Roll(_) => turned(Operation::Roll)?,
            other => *other,
        };
        (after.parameters() == camera.parameters()).then_some((operation, before))
    }

    /// Adds the operation that led to a camera to those that its figure shows, if it continues them. Otherwise it
    /// replaces them.
    pub fn keep(&mut self, camera: &Camera, shown: &mut Vec<Operation>) {
        let Some((operation, before)) = self.led_to(camera) else { return };
        let continued = self.kept.as_ref().filter(|(_, after)| after.parameters() == before.parameters());
        let mut all = continued.map(|(kept, _)| kept.clone()).unwrap_or_default();
        if all.len() == crate::figure::Show::MOST_OPERATIONS {
            all.remove(0);
        }
        all.push(operation);
        shown.clone_from(&all);
        self.kept = Some((all, camera.clone()));
    }
}

/// A step of a button that the world still shows, with its axis, its arc, its angle.
#[derive(Clone, Debug)]
pub struct DoneStep {
    /// The camera before it, and its way.
    pub ghost: Ghost,
    /// When it was done, in seconds. `None` for the next frame.
    pub since: Option<f64>,
}

/// A held slider.
#[derive(Clone, Debug)]
pub struct Scrub {
    /// The operation.
    pub freedom: Freedom,
    /// The camera when it was taken.
    pub start: Camera,
    /// The amount of the slider.
    pub amount: f64,
}

impl Default for Operations {
    fn default() -> Self {
        Self {
            steps: OPERATIONS.map(|descriptor| descriptor.step),
            open: Freedom::Elevation,
            open_above: Vec::new(),
            predict: Predict::default(),
            convention: Convention::default(),
            scrub: None,
            done: None,
            last: None,
            kept: None,
        }
    }
}

impl Model {
    /// Applies an operation to the camera, by the chosen signs. If that's impossible, a message says why.
    pub fn operate(&mut self, operation: Operation) {
        let done = self.desk.shown.operate(operation, self.operations.convention);
        self.say_camera_error(done);
    }

    /// The question of an operation, where a point will go.
    pub fn placing_of_operation(&self) -> Option<Placing> {
        let asked = self.operations.predict.asked.as_ref().filter(|asked| asked.document == self.desk.shown.id())?;
        let About::Place { from, to, mark, .. } = asked.about else { return None };
        let done = |place| Some(place).filter(|_| asked.is_done);
        Some(Placing {
            from: Some(from).filter(|_| !asked.is_done),
            mark,
            guess: mark.and_then(done),
            right: done(to),
            second: None,
            is_open: !asked.is_done,
            hint: words::texts(self.settings.lang).mark_here,
            of: Mark::Operation,
        })
    }

    /// Makes an operation ask about its effect, if that's wanted. Returns false if it's to be done at once.
    pub fn predict_first(&mut self, freedom: Freedom, amount: f64) -> bool {
        let predict = &mut self.operations.predict;
        predict.asked = None;
        if !predict.on {
            return false;
        }
        let (camera, image) = (self.desk.shown.camera(), self.desk.shown.figure().image);
        let subject = (camera, image, &**self.scene_cache.scene());
        let about = About::of(subject, (freedom, amount), self.operations.convention);
        let document = self.desk.shown.id();
        let asked = about.map(|about| Prediction { freedom, amount, about, document, is_done: false });
        let asks = asked.is_some();
        self.layout.shown[View::Image.index()] |= asks;
        self.operations.predict.asked = asked;
        asks
    }
}

/// A question for a place in the image. Places are pixels from its left edge and from its upper one.
#[derive(Clone, Debug)]
pub struct Placing {
    /// The question.
    pub of: Mark,
    /// The present place of the followed point.
    pub from: Option<[f64; 2]>,
    /// The chosen place.
    pub mark: Option<[f64; 2]>,
    /// The guess that can't be changed any more.
    pub guess: Option<[f64; 2]>,
    /// The right place, once it may be seen.
    pub right: Option<[f64; 2]>,
    /// The right place of a second question, once it may be seen.
    pub second: Option<[f64; 2]>,
    /// The mark may be put elsewhere.
    pub is_open: bool,
    /// The words in the empty picture.
    pub hint: &'static str,
}

/// The owner of a mark in the image.
#[derive(Clone, Debug)]
pub enum Mark {
    /// A question of an exercise or a lesson.
    Ask(Box<Ask>),
    /// An operation that asks where a point will go.
    Operation,
}
