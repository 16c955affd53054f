//! Finds what the pointer points at: at once in a light scene, beside the window's thread in a heavy one, so that neither the
//! pointer nor the pictures wait for a walk through a million triangles.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use eframe::egui;
use glam::DVec2;

use super::probe::{self, Depths};
use crate::camera::Camera;
use crate::figure::{Figure, Observer};
use crate::i18n::{Lang, pictures::labels};
use crate::scene::Scene;
use crate::views::View;
use crate::views::{Extras, Probe, Setup, Size};

/// More vertices and triangles than this take longer to look through than a frame has.
const HEAVY: usize = 60_000;

/// How long a frame waits for an answer.
const PATIENCE: Duration = Duration::from_millis(4);

/// What is asked about a scene.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum What {
    /// What is at a place (pixels) of a picture, within reach.
    Under { picture: View, observer: Observer, size: Size, pointer: DVec2, reach: f64 },
    /// What the depth buffer holds where the probe is.
    Depths(Probe),
}

/// A question, with all that its answer depends on.
#[derive(Clone, Debug)]
pub(super) struct Question {
    pub(super) what: What,
    pub(super) figure: Figure,
    pub(super) camera: Camera,
    pub(super) scene: Arc<Scene>,
    /// What the views may know beforehand.
    pub(super) extras: Extras,
}

impl PartialEq for Question {
    fn eq(&self, other: &Self) -> bool {
        self.what == other.what && self.is_about_the_same(other)
    }
}

impl Question {
    fn is_about_the_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.scene, &other.scene) && self.camera == other.camera && self.figure == other.figure
    }

    /// True where an answer to the other is better than none: the pointer has moved a little.
    fn is_near(&self, other: &Self) -> bool {
        let picture = |question: &Self| match question.what {
            What::Under { picture, .. } => Some(picture),
            What::Depths(_) => None,
        };
        picture(self).is_some() && picture(self) == picture(other) && self.is_about_the_same(other)
    }

    fn is_heavy(&self) -> bool {
        self.scene.objects.iter().map(|o| o.mesh.positions.len() + o.mesh.triangles.len()).sum::<usize>() > HEAVY
    }

    fn answer(&self) -> Answer {
        let size = match self.what {
            What::Under { size, .. } => size,
            What::Depths(_) => Size { width: 1, height: 1, scale: 1.0 },
        };
        let setup = Setup {
            figure: &self.figure,
            camera: &self.camera,
            scene: &self.scene,
            // What is found has no words.
            labels: labels(Lang::En),
            size,
            extras: &self.extras,
        };
        match &self.what {
            What::Under { picture, observer, pointer, reach, .. } => {
                Answer { probe: probe::at(*picture, &setup, observer, *pointer, *reach), depths: None }
            }
            What::Depths(probe) => Answer { probe: None, depths: probe::depths(*probe, &setup) },
        }
    }
}

/// What was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Answer {
    pub(super) probe: Option<Probe>,
    pub(super) depths: Option<Depths>,
}

/// Answers one question after the other; one that has not been begun is forgotten when the next comes.
#[derive(Default)]
pub(super) struct Seeker {
    shared: Arc<Shared>,
    started: bool,
    asked: Option<Question>,
    answered: Option<(Question, Answer)>,
}

#[derive(Default)]
struct Shared {
    desk: Mutex<Desk>,
    wake: Condvar,
    done: Condvar,
}

#[derive(Default)]
struct Desk {
    wanted: Option<Question>,
    found: Option<(Question, Answer)>,
    quit: bool,
}

impl Shared {
    fn desk(&self) -> MutexGuard<'_, Desk> {
        self.desk.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Seeker {
    /// The answer, or the last one near it while this one is being looked for; `ctx` is asked for a frame when it is found.
    pub(super) fn ask(&mut self, ctx: &egui::Context, question: Question) -> Answer {
        if !question.is_heavy() || !self.start(ctx) {
            return question.answer();
        }
        let mut desk = self.shared.desk();
        if self.asked.as_ref() != Some(&question) {
            desk.wanted = Some(question.clone());
            self.asked = Some(question.clone());
            self.shared.wake.notify_one();
        }
        let is_it = |found: &Option<(Question, Answer)>| found.as_ref().is_some_and(|(q, _)| *q == question);
        if !self.answered.as_ref().is_some_and(|(q, _)| *q == question) && !is_it(&desk.found) {
            desk = match self.shared.done.wait_timeout_while(desk, PATIENCE, |desk| !is_it(&desk.found)) {
                Ok((desk, _)) => desk,
                Err(poisoned) => poisoned.into_inner().0,
            };
        }
        if let Some(found) = desk.found.take() {
            self.answered = Some(found);
        }
        let near = self.answered.as_ref().filter(|(q, _)| *q == question || q.is_near(&question));
        near.map_or_else(Answer::default, |(_, answer)| *answer)
    }

    /// Starts the thread that looks, with the first question that needs one; false where there are no threads.
    fn start(&mut self, ctx: &egui::Context) -> bool {
        if !self.started {
            let (theirs, ctx) = (Arc::clone(&self.shared), ctx.clone());
            let thread = std::thread::Builder::new().name("pointer".to_owned());
            self.started = thread.spawn(move || work(&theirs, &ctx)).is_ok();
        }
        self.started
    }
}

impl Drop for Seeker {
    fn drop(&mut self) {
        self.shared.desk().quit = true;
        self.shared.wake.notify_one();
    }
}

fn work(shared: &Shared, ctx: &egui::Context) {
    loop {
        let mut desk = shared.desk();
        let question = loop {
            if desk.quit {
                return;
            }
            if let Some(question) = desk.wanted.take() {
                break question;
            }
            desk = shared.wake.wait(desk).unwrap_or_else(PoisonError::into_inner);
        };
        drop(desk);
        // A panic here is a bug, but not one for which nothing should be found any more.
        let answer = catch_unwind(AssertUnwindSafe(|| question.answer())).unwrap_or_default();
        shared.desk().found = Some((question, answer));
        shared.done.notify_one();
        ctx.request_repaint();
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use std::time::Instant;

    use super::*;
    use crate::appearance::Style;
    use crate::scene::{ObjectSpec, Preset, SceneSpec, Shape, build};

    fn question(segments: u32, pointer: DVec2) -> Question {
        let ball = ObjectSpec::new("ball", Shape::Sphere).with_segments(segments);
        let spec = SceneSpec { preset: Preset::Empty, objects: vec![ball], lights: Vec::new() };
        let scene = build(&spec, &Style::default(), &mut crate::scene::no_files).unwrap();
        let figure = Figure::default();
        let nobody =
            Observer { target: glam::DVec3::ZERO, distance: 1.0, azimuth: 0.0, elevation: 0.0, parallel: false };
        let size = Size { width: 400, height: 300, scale: 1.0 };
        Question {
            what: What::Under { picture: View::Image, observer: nobody, size, pointer, reach: 7.0 },
            camera: Camera::new(&figure.camera).unwrap(),
            figure,
            scene: Arc::new(scene),
            extras: Extras::default(),
        }
    }

    #[test]
    fn a_heavy_scene_gives_the_same_answer_a_little_later() {
        let ctx = egui::Context::default();
        let mut seeker = Seeker::default();
        let light = question(16, DVec2::new(200.0, 150.0));
        assert!(!light.is_heavy());
        assert_eq!(seeker.ask(&ctx, light.clone()), light.answer());
        assert!(!seeker.started);
        let heavy = question(256, DVec2::new(200.0, 150.0));
        assert!(heavy.is_heavy());
        let wanted = heavy.answer();
        assert!(wanted.probe.is_some());
        let start = Instant::now();
        while seeker.ask(&ctx, heavy.clone()) != wanted {
            assert!(start.elapsed() < Duration::from_secs(60));
        }
        // Until the next is found, the last one nearby stands; nothing of another camera.
        let beside = Question {
            what: match heavy.what.clone() {
                What::Under { picture, observer, size, reach, .. } => {
                    What::Under { picture, observer, size, reach, pointer: DVec2::new(201.0, 150.0) }
                }
                other => other,
            },
            ..heavy.clone()
        };
        assert!(seeker.ask(&ctx, beside).probe.is_some());
        let near = crate::camera::Parameters { near: 2.0, ..*heavy.camera.parameters() };
        let other = Question { camera: Camera::new(&near).unwrap(), ..heavy };
        assert!(!other.is_near(&seeker.answered.as_ref().unwrap().0));
    }
}
