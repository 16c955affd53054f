//! The choices for printing.

use crate::gui::learn::Learn;
use crate::lessons::{OpenLesson, shipped};
use camera_lab_desk::{Content, Job};
use camera_lab_words::handout::{HandoutOptions, MAX_VERSIONS, Solutions, Version};

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
    /// The address of the course's page. Empty if it isn't known.
    pub address: String,
    /// The displayed page, from 0.
    pub(in crate::gui) page: usize,
}

impl HandoutForm {
    /// The lesson being played, or the first one, or else exercises: those of the last run, or the open one. The ticks
    /// are those of the last run.
    pub(in crate::gui) fn of(learn: &Learn, lang: camera_lab_words::Lang, is_lesson: bool, address: String) -> Self {
        let has = |word: &str| learn.ticks_before.iter().any(|tick| tick == word);
        let open = learn.exercises.open.as_ref();
        let open = open.filter(|open| learn.exercises.entries().any(|entry| entry.id == open.id));
        let options = HandoutOptions {
            lang,
            columns: if has("small") { 2 } else { 1 },
            answers: if has("answers") { Solutions::AtEnd } else { Solutions::None },
            plan: has("plan"),
            late: !has("early"),
        };
        let known = |id: &&String| learn.exercises.entries().any(|entry| entry.id == **id);
        let mut chosen: Vec<String> = learn.ticks_before.iter().filter(known).cloned().collect();
        let of_open = open.and_then(|open| u32::try_from(open.seed).ok()).filter(|seed| *seed <= MAX_SEED);
        let of_open = of_open.unwrap_or_default();
        // One that has the numbers of the sheet.
        let first = crate::exercises::entries().find(|entry| entry.is_family).map(|entry| entry.id.to_string());
        if chosen.is_empty() {
            chosen.extend(open.map(|open| open.id.clone()).or(first));
        }
        Self {
            lesson: is_lesson.then(|| played(learn)).flatten(),
            exercises: chosen,
            seeds: learn.ticks_before.iter().find_map(|tick| numbers(tick)).unwrap_or([of_open; 2]),
            options,
            address,
            page: 0,
        }
    }

    /// Its ticks for the next run of the program: the words of those that differ from a new dialog's, the numbers, and
    /// the exercises.
    pub(in crate::gui) fn ticks(&self) -> Vec<String> {
        let HandoutOptions { answers, late, plan, columns, .. } = self.options;
        let words = [("answers", answers != Solutions::None), ("early", !late), ("plan", plan), ("small", columns > 1)];
        let words = words.into_iter().filter(|(_, on)| *on).map(|(word, _)| word.to_owned());
        let [first, last] = self.seeds;
        words.chain([format!("{first}-{last}")]).chain(self.exercises.iter().cloned()).collect()
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
        let mut options = self.options;
        if self.lesson.is_none() {
            (options.plan, options.columns) = (false, 1);
        }
        Job { content, options, address: self.address.clone() }
    }

    /// True if the solutions stand in the file of the questions.
    pub(in crate::gui) fn shows_solutions(&self) -> bool {
        self.options.answers != Solutions::None && (self.lesson.is_some() || self.seeds[0] == self.seeds[1])
    }

    /// True if there's something to print.
    pub(in crate::gui) fn is_whole(&self) -> bool {
        self.lesson.is_some() || !self.exercises.is_empty()
    }
}

/// The numbers of the sheet among the ticks.
fn numbers(tick: &str) -> Option<[u32; 2]> {
    let (first, last) = tick.split_once('-')?;
    let [first, last] = [first.parse().ok()?, last.parse().ok()?];
    (first <= last && last <= MAX_SEED && last - first < MAX_VERSIONS).then_some([first, last])
}

/// The lesson being played, or the one to which steps were added last, or the first built-in one.
pub(in crate::gui) fn played(learn: &Learn) -> Option<OpenLesson> {
    let of_playing = learn.lesson.as_ref().map(|playing| (playing.lesson.clone(), playing.path.clone()));
    let last = || learn.own.iter().find(|(path, _)| Some(path) == learn.file.as_ref());
    let of_playing = of_playing.or_else(|| last().map(|(path, lesson)| (lesson.clone(), Some(path.clone()))));
    let first = || shipped().first().map(|shipped| (shipped.lesson.clone(), None));
    of_playing.or_else(first).map(|(lesson, path)| OpenLesson { lesson, path, step: 0 })
}

#[cfg(test)]
mod tests {
    #![expect(clippy::expect_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::gui::Start;
    use crate::gui::app::state::State;
    use camera_lab_words::Lang;

    #[test]
    fn the_last_run_gives_ticks_and_numbers_and_its_file_says_if_it_has_solutions() {
        let mut state = State::new(Start::default()).expect("a camera");
        state.learn.ticks_before = ["answers", "3-30", "basis"].map(str::to_owned).to_vec();
        let mut form = HandoutForm::of(&state.learn, Lang::En, false, String::new());
        assert_eq!((form.seeds, form.exercises.as_slice()), ([3, 30], &["basis".to_owned()][..]));
        assert_eq!(form.ticks(), state.learn.ticks_before);
        assert_eq!(form.stem(), "exercises", "the solutions of several versions stand beside it");
        form.seeds = [3, 3];
        assert_eq!(form.stem(), "exercises-with-solutions");
        for no_numbers in ["30-3", "3-", "0-10000", "1-9999"] {
            assert_eq!(numbers(no_numbers), None, "{no_numbers}");
        }
    }
}
