//! The choices for printing.

use crate::gui::learn::Learn;
use crate::lessons::{OpenLesson, shipped};
use camera_lab_desk::{Content, Job};
use camera_lab_words::handout::{HandoutOptions, Solutions, Version};

/// The greatest number for choosing the numbers of the exercises.
pub(in crate::gui) const MAX_SEED: u32 = 9_999;

/// The choices in the dialog.
#[derive(Clone, Debug, PartialEq)]
pub struct HandoutForm {
    /// The lesson to print. `None` prints exercises.
    pub lesson: Option<OpenLesson>,
    /// The exercises, by their identifiers, in the order of choosing them.
    pub exercises: Vec<String>,
    /// The sources of the exercises' numbers: those of the first version, and those of the last one.
    pub seeds: [u32; 2],
    /// Language, columns, answers and plan.
    pub options: HandoutOptions,
    /// The displayed page, from 0.
    pub(in crate::gui) page: usize,
}

impl HandoutForm {
    /// The lesson being played, or the first one, or else exercises, beginning with the open one.
    pub(in crate::gui) fn of(learn: &Learn, lang: camera_lab_words::Lang, is_lesson: bool) -> Self {
        let open = learn.exercises.open.as_ref();
        let open = open.filter(|open| learn.exercises.entries().any(|entry| entry.id == open.id));
        let options = HandoutOptions { lang, columns: 1, answers: Solutions::None, plan: false, late: true };
        // One that has the numbers of the sheet.
        let first = crate::exercises::entries().find(|entry| entry.is_family).map(|entry| entry.id.to_string());
        Self {
            lesson: is_lesson.then(|| played(learn)).flatten(),
            exercises: open.map(|open| open.id.clone()).or(first).into_iter().collect(),
            seeds: [open
                .and_then(|open| u32::try_from(open.seed).ok())
                .filter(|seed| *seed <= MAX_SEED)
                .unwrap_or_default(); 2],
            options,
            page: 0,
        }
    }

    /// Everything that the handout depends on.
    pub(in crate::gui) fn job(&self, learn: &Learn) -> Job {
        let content = match &self.lesson {
            Some(open) => Content::Lesson(open.clone()),
            None => {
                let [first, last] = self.seeds.map(u64::from);
                let version = |seed: u64| {
                    let of = |id: &String| Some(learn.exercises.entry(id)?.exercise(seed, &Default::default()));
                    let exercises = self.exercises.iter().filter_map(of).collect();
                    Version { number: (first < last).then_some(seed), exercises }
                };
                Content::Exercises((first..=last).map(version).collect())
            }
        };
        Job { content, options: self.options }
    }

    /// True if there's something to print.
    pub(in crate::gui) fn is_whole(&self) -> bool {
        self.lesson.is_some() || !self.exercises.is_empty()
    }
}

/// The lesson being played, or the one to which steps were added last, or the first built-in one.
pub(in crate::gui) fn played(learn: &Learn) -> Option<OpenLesson> {
    let of_playing = learn.lesson.as_ref().map(|playing| (playing.lesson.clone(), playing.path.clone()));
    let last = || learn.own.iter().find(|(path, _)| Some(path) == learn.file.as_ref());
    let of_playing = of_playing.or_else(|| last().map(|(path, lesson)| (lesson.clone(), Some(path.clone()))));
    let first = || shipped().first().map(|shipped| (shipped.lesson.clone(), None));
    of_playing.or_else(first).map(|(lesson, path)| OpenLesson { lesson, path, step: 0 })
}
