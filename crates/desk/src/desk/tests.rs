#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::path::PathBuf;

use glam::DVec3;
use proptest::prelude::*;

use super::*;
use crate::figure::NamedPoint;
use camera_lab_files::Renamed;

/// An act of the user, with the answer to the question that it raises.
#[derive(Clone, Copy, Debug)]
enum Act {
    Build,
    Turn,
    Undo(bool),
    Save,
    Exercise,
    Open(Answer),
    Next,
    Back(usize),
    Play(Answer),
    Write,
    Step(usize),
    MoveSteps,
    LeaveLesson,
    Close(Answer),
}

#[derive(Clone, Copy, Debug)]
enum Answer {
    Save,
    Discard,
    Cancel,
}

fn act() -> impl Strategy<Value = Act> {
    let answer = || prop_oneof![Just(Answer::Save), Just(Answer::Discard), Just(Answer::Cancel)];
    prop_oneof![
        4 => Just(Act::Build),
        1 => Just(Act::Turn),
        3 => any::<bool>().prop_map(Act::Undo),
        1 => Just(Act::Save),
        2 => Just(Act::Exercise),
        2 => answer().prop_map(Act::Open),
        1 => Just(Act::Next),
        1 => (0_usize..4).prop_map(Act::Back),
        2 => answer().prop_map(Act::Play),
        1 => Just(Act::Write),
        4 => (0_usize..4).prop_map(Act::Step),
        1 => Just(Act::MoveSteps),
        1 => Just(Act::LeaveLesson),
        1 => answer().prop_map(Act::Close),
    ]
}

/// A desk, the step of its lesson, and the marks that the user has put into figures and neither saved, undone nor
/// given up.
struct Trial {
    desk: Desk,
    step: usize,
    marks: Vec<u32>,
    count: u32,
}

fn document() -> Document {
    Document::new(Figure::default(), None).unwrap()
}

fn has(document: &Document, mark: u32) -> bool {
    document.figure().points.iter().any(|point| point.position.x == f64::from(mark))
}

impl Trial {
    fn forget_shown(&mut self) {
        let shown = self.desk.shown.clone();
        self.marks.retain(|mark| !has(&shown, *mark));
    }

    fn save(&mut self) {
        self.desk.commit();
        let figure = self.desk.shown.figure().clone();
        self.desk.shown.mark_saved(PathBuf::from("/a.toml"), String::new(), figure, &Renamed::new());
        self.forget_shown();
    }

    /// States an intent, and gives the user's answer if the desk asks. True if it's to be done.
    fn wants(&mut self, intent: &Intent, answer: Answer) -> bool {
        let losses = |desk: &Desk| Losses { figure: desk.shows_work(), text: false };
        let need = self.desk.wish(intent.clone(), losses(&self.desk));
        let need = match (need, answer) {
            (Need::AskAboutFigure, Answer::Save) => {
                assert_eq!(self.desk.reply(Reply::Save), Need::SaveFigure);
                self.save();
                let waiting = self.desk.errand().cloned().unwrap();
                self.desk.wish(waiting, losses(&self.desk))
            }
            (Need::AskAboutFigure, Answer::Discard) => {
                self.forget_shown();
                self.desk.reply(Reply::GiveUp)
            }
            (Need::AskAboutFigure, Answer::Cancel) => self.desk.reply(Reply::Cancel),
            (need, _) => need,
        };
        assert_eq!(self.desk.errand(), None);
        need == Need::Do(intent.clone())
    }

    fn leave_lesson(&mut self) {
        if self.desk.plays_lesson() {
            self.desk.leave_lesson();
        }
    }

    fn take_over(&mut self, document: Document) {
        self.desk.keep_behind();
        self.leave_lesson();
        self.desk.take_over(document);
    }

    fn perform(&mut self, act: Act) {
        match act {
            Act::Build => {
                self.count += 1;
                let (mark, name) = (self.count, format!("Q{}", self.count));
                let point = NamedPoint { name, position: DVec3::new(f64::from(mark), 0.0, 0.0) };
                self.desk.shown.edit(|figure| figure.points.push(point));
                self.desk.commit();
                self.marks.push(mark);
            }
            Act::Turn => {
                let far = self.desk.shown.draft().far + 1.0;
                let parameters = crate::camera::Parameters { far, ..*self.desk.shown.draft() };
                self.desk.shown.set_parameters(parameters);
                self.desk.commit();
            }
            Act::Undo(back) => {
                let before = self.desk.shown.clone();
                self.desk.undo(back);
                let after = self.desk.shown.clone();
                if before.id() == after.id() {
                    // The user takes it back, and may repeat it until another step is made.
                    self.marks.retain(|mark| !has(&before, *mark) || has(&after, *mark));
                } else {
                    self.marks.retain(|mark| !has(&before, *mark) || !back);
                }
            }
            Act::Save => self.save(),
            Act::Exercise => self.desk.show_in_front(Figure::default()).unwrap(),
            Act::Open(answer) if self.wants(&Intent::New, answer) => self.take_over(document()),
            Act::Next => {
                self.desk.keep_shown();
                self.take_over(document());
            }
            Act::Back(place) => {
                let left: Vec<_> = self.desk.left().collect();
                if let Some(source) = left.get(place)
                    && self.wants(&Intent::Open, Answer::Save)
                    && let Some(document) = self.desk.take_left(source.as_ref())
                {
                    self.take_over(document);
                }
            }
            Act::Play(answer) if self.wants(&Intent::Shipped("house"), answer) => {
                self.take_over(document());
                self.desk.play_lesson();
                self.step = 0;
            }
            Act::Write if self.desk.plays_lesson() => self.desk.write_lesson(),
            Act::Step(step) if self.desk.plays_lesson() => {
                self.desk.leave_step(self.step);
                let next = self.desk.take_from_step(step).unwrap_or_else(document);
                self.desk.keep_behind();
                self.desk.take_over(next);
                self.step = step;
            }
            Act::MoveSteps => self.desk.move_steps(|step| step.checked_sub(1)),
            Act::LeaveLesson => self.leave_lesson(),
            Act::Close(answer) => {
                // The user gives up the first document, and then stays.
                if self.wants(&Intent::Quit, answer)
                    && let Some(next) = self.desk.next_to_close(self.desk.shows_work())
                {
                    self.take_over(next);
                }
                self.desk.keep_given_up();
            }
            Act::Open(_) | Act::Play(_) | Act::Write | Act::Step(_) => {}
        }
    }

    fn holds(&self, mark: u32) -> bool {
        has(&self.desk.shown, mark) || self.desk.held().into_iter().any(|document| has(document, mark))
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn work_is_held_or_saved_or_given_up(acts in prop::collection::vec(act(), 0..40)) {
        let mut trial = Trial { desk: Desk::new(document()), step: 0, marks: Vec::new(), count: 0 };
        for (k, act) in acts.iter().enumerate() {
            trial.perform(*act);
            for mark in &trial.marks {
                prop_assert!(trial.holds(*mark), "mark {mark} is lost by {act:?}, act {k}");
            }
        }
    }
}
