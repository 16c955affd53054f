//! Preferences of the window, in a small TOML file in the user's configuration folder.
//!
//! Each window writes only the keys that changed in it. If two windows are open at once, the last one wins, key by key,
//! and keys of a later version stay.

mod answers;
mod progress;
#[cfg(test)]
mod progress_tests;
mod store;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

pub use store::Preferences;
use toml_edit::{DocumentMut, Value};

use crate::camera::{Amount, Convention, Descriptor, Freedom, Ndc, OPERATIONS};
use crate::export::format::PictureFormat;
use crate::figure::words::{self, ARRANGEMENTS, EXPLANATIONS, THEMES, Words};
use crate::gui::app::launch_options::LANGUAGES;
use crate::gui::app::state::State;
use crate::gui::export::family_choice::{FamilyChoice, Subject, Varied};
use crate::limits::{MAX_TYPED_NAME, PAPER_CM, PAPER_DPI, PAPER_LETTERS, PAPER_LINES};
use crate::picture::Faces;
use crate::views::Views;
use camera_lab_desk::{Side, WindowPlace};

/// The conventions for the signs of rotations, by the names in `--convention`.
const CONVENTIONS: Words<Convention> = &[("right-hand", Convention::RightHand), ("vtk", Convention::Vtk)];

/// The key of the list of recent files.
const RECENT: &str = "recent";

/// The key of the furthest steps of lessons, each as `id=step`, from 1.
const LESSONS: &str = "lessons";
/// The done steps of lessons.
const LESSONS_DONE: &str = "lessons_done";

/// A key of the file, with its value in a window and its effect on one. An impossible value has none.
struct Key {
    name: &'static str,
    of: fn(&State) -> Value,
    apply: fn(&mut State, &Value),
}

/// A key whose value is in one place of the window: a switch, a word of a list, a number within bounds, or what one
/// expression writes of it and a function reads.
macro_rules! key {
    ($name:literal, switch, $($place:tt)+) => {
        Key {
            name: $name,
            of: |state| state.$($place)+.into(),
            apply: |state, value| put(&mut state.$($place)+, value.as_bool()),
        }
    };
    ($name:literal, one of $words:ident, $($place:tt)+) => {
        Key {
            name: $name,
            of: |state| words::name($words, state.$($place)+).into(),
            apply: |state, value| put(&mut state.$($place)+, word($words, value)),
        }
    };
    ($name:literal, within $range:expr, $($place:tt)+) => {
        Key {
            name: $name,
            of: |state| state.$($place)+.into(),
            apply: |state, value| put(&mut state.$($place)+, number(value).filter(|v| $range.contains(v))),
        }
    };
    ($name:literal, [$($place:tt)+], |$own:ident| $write:expr, $read:expr) => {
        Key {
            name: $name,
            of: |state| {
                let $own = &state.$($place)+;
                $write.into()
            },
            apply: |state, value| put(&mut state.$($place)+, $read(value)),
        }
    };
}

/// Every key but the steps of operations and [`RECENT`].
const KEYS: &[Key] = &[
    key!("language", one of LANGUAGES, model.settings.lang),
    key!("theme", one of THEMES, model.settings.theme),
    Key {
        name: "zoom",
        of: |state| ((f64::from(state.model.settings.zoom) * 100.0).round() / 100.0).into(),
        #[expect(clippy::cast_possible_truncation, reason = "at most 3")]
        apply: |state, value| {
            let zoom = number(value).filter(|zoom| (0.5..=3.0).contains(zoom));
            put(&mut state.model.settings.zoom, zoom.map(|zoom| zoom as f32));
        },
    },
    Key {
        name: "parameters_panel",
        of: |state| state.learn.own_panels(&state.model).wanted[Side::Left as usize].into(),
        apply: |state, value| put(&mut state.model.settings.panels.wanted[Side::Left as usize], value.as_bool()),
    },
    Key {
        name: "numbers_panel",
        of: |state| state.learn.own_panels(&state.model).wanted[Side::Right as usize].into(),
        apply: |state, value| put(&mut state.model.settings.panels.wanted[Side::Right as usize], value.as_bool()),
    },
    Key {
        name: "explanations",
        of: |state| state.model.preferred_layout().is_open.into(),
        apply: |state, value| put(&mut state.model.settings.panels.wanted[Side::Explain as usize], value.as_bool()),
    },
    Key {
        name: "explanation",
        of: |state| words::name(EXPLANATIONS, state.model.preferred_layout().explanation).into(),
        apply: |state, value| word(EXPLANATIONS, value).into_iter().for_each(|shown| state.model.explained.show(shown)),
    },
    // The last one of each question.
    Key {
        name: "explanations_read",
        of: |state| state.model.explained.last().map(|last| words::name(EXPLANATIONS, last)).into_iter().collect(),
        apply: |state, value| {
            let names = value.as_array().into_iter().flatten().filter_map(Value::as_str);
            let shown = state.model.explained.shown();
            names.filter_map(|name| words::value(EXPLANATIONS, name)).for_each(|read| state.model.explained.show(read));
            state.model.explained.show(shown);
        },
    },
    Key {
        name: "layout",
        of: |state| words::name(ARRANGEMENTS, state.model.preferred_layout().arrangement).into(),
        apply: |state, value| put(&mut state.model.layout.arrangement, word(ARRANGEMENTS, value)),
    },
    key!("pipeline", switch, model.layout.strip),
    key!("digits", [model.settings.digits], |own| i64::try_from(*own).unwrap_or_default(), digits),
    // Width and height, whether it's maximized, and its corner if known. Empty if unknown.
    key!(
        "window",
        [model.settings.window],
        |own| own.map(window_numbers).into_iter().flatten().collect::<Value>(),
        window
    ),
    key!("reduce_motion", switch, model.settings.reduce_motion),
    key!("numbers", switch, model.settings.numbers_open),
    key!("welcomed", switch, model.settings.welcomed),
    Key {
        name: LESSONS,
        of: |state| lessons_value(&state.learn.taken),
        apply: |state, value| state.learn.taken = lessons_taken(pairs(value)),
    },
    Key {
        name: LESSONS_DONE,
        of: |state| done_value(&state.learn.done),
        apply: |state, value| state.learn.done = lessons_done(pairs(value)),
    },
    // Empty: none yet.
    Key {
        name: "lesson_stopped",
        of: |state| state.learn.stopped.as_ref().map_or_else(String::new, |(id, step)| pair(id, *step)).into(),
        apply: |state, value| state.learn.stopped = value.as_str().and_then(of_pair),
    },
    key!("convention", one of CONVENTIONS, model.operations.convention),
    key!("ndc", [model.settings.conventions.ndc], |own| own.name(), ndc),
    // Empty: with none.
    Key {
        name: "compared_ndc",
        of: |state| state.model.settings.conventions.compared.map_or("", Ndc::name).into(),
        apply: |state, value| state.model.settings.conventions.compared = ndc(value),
    },
    key!("row_vectors", switch, model.settings.conventions.row_vectors),
    key!("left_handed_view", switch, model.settings.conventions.left_handed),
    Key {
        name: "gallery_folder",
        of: |state| state.gallery.folder().and_then(Path::to_str).unwrap_or_default().into(),
        apply: |state, value| {
            file(value).into_iter().for_each(|folder| state.gallery.remember(folder));
        },
    },
    // Empty: not known.
    key!("page_address", [sharing.page_address], |own| own.as_str(), text),
    // Empty: not needed yet.
    key!("page_file", [sharing.page_file], |own| own.to_str().unwrap_or_default(), file),
    // Empty: none.
    Key {
        name: "exercise_folder",
        of: |state| state.learn.exercises.own.as_ref().and_then(|own| own.folder.to_str()).unwrap_or_default().into(),
        apply: |state, value| {
            state.learn.exercises.look_into(file(value));
        },
    },
    // The exported views, and the displayed ones for which they were chosen.
    Key {
        name: "export_views",
        of: |state| {
            let views = std::iter::once(state.export.what).chain(state.exported_of);
            views.map(Views::name).collect()
        },
        apply: |state, value| {
            let names = value.as_array().into_iter().flatten().filter_map(Value::as_str);
            let mut views = names.map(|name| Views::CHOICES.into_iter().find(|views| views.name() == name));
            put(&mut state.export.what, views.next().flatten());
            state.exported_of = views.next().flatten();
        },
    },
    // The ticks of the dialog that prints, with its exercises.
    Key {
        name: "handout",
        of: |state| state.learn.ticks.iter().map(String::as_str).collect(),
        apply: |state, value| {
            let ticks = value.as_array().into_iter().flatten().filter_map(Value::as_str);
            state.learn.ticks = ticks.map(str::to_owned).collect();
            state.learn.ticks_before.clone_from(&state.learn.ticks);
        },
    },
    key!("export_theme", one of THEMES, export.theme),
    key!("export_times", [export.times], |own| i64::from(own.unwrap_or_default()), times),
    key!("export_format", [export.format], |own| own.ending(), format),
    key!("export_on_paper", switch, export.on_paper),
    key!("export_transparent", switch, export.transparent),
    key!("export_crop", switch, export.crop),
    key!("export_outlines", switch, export.outlines),
    key!("export_faces", [export.faces], |own| own.name(), faces),
    // Keys or operations with their values. Empty if there are none.
    Key {
        name: "family",
        of: |state| family_of(&state.family, 0),
        apply: |state, value| set_family(&mut state.family, value, 0),
    },
    Key {
        name: "family_rows",
        of: |state| family_of(&state.family, 1),
        apply: |state, value| set_family(&mut state.family, value, 1),
    },
    // 0 means as many as there is room for.
    key!(
        "family_columns",
        [family.columns],
        |own| own.and_then(|n| i64::try_from(n).ok()).unwrap_or_default(),
        columns
    ),
    key!("family_parts", switch, family.parts),
    key!("export_width_cm", within PAPER_CM, export.paper.size[0]),
    key!("export_height_cm", within PAPER_CM, export.paper.size[1]),
    key!("export_dpi", within PAPER_DPI, export.paper.dpi),
    key!("export_letters", within PAPER_LETTERS, export.paper.letters),
    // 0: in proportion to the letters.
    Key {
        name: "export_lines",
        of: |state| state.export.paper.lines.unwrap_or_default().into(),
        apply: |state, value| match number(value) {
            Some(0.0) => state.export.paper.lines = None,
            lines => put(&mut state.export.paper.lines, lines.filter(|lines| PAPER_LINES.contains(lines)).map(Some)),
        },
    },
];

fn window_numbers(WindowPlace { at, size, maximized }: WindowPlace) -> Vec<i64> {
    let numbers = size.map(i64::from).into_iter().chain([i64::from(maximized)]);
    numbers.chain(at.into_iter().flatten().map(i64::from)).collect()
}

fn window(value: &Value) -> Option<Option<WindowPlace>> {
    let numbers: Vec<i64> = value.as_array().into_iter().flatten().filter_map(Value::as_integer).collect();
    window_of(&numbers).map(Some)
}

fn window_of(numbers: &[i64]) -> Option<WindowPlace> {
    let (&[width, height, maximized], at) = numbers.split_first_chunk::<3>()?;
    let side = |side: i64| u32::try_from(side).ok().filter(|side| (200..=20_000).contains(side));
    let at = if let [x, y] = at { Some([i32::try_from(*x).ok()?, i32::try_from(*y).ok()?]) } else { None };
    Some(WindowPlace { at, size: [side(width)?, side(height)?], maximized: maximized != 0 })
}

/// A key of the last family: its word, then its values.
fn family_of(family: &FamilyChoice, place: usize) -> Value {
    let Varied { subject, values } = &family.remembered()[place];
    [subject.word(), values].into_iter().collect()
}

fn set_family(family: &mut FamilyChoice, value: &Value, place: usize) {
    let texts: Vec<&str> = value.as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    if let [word, values] = texts[..]
        && let Some(subject) = Subject::of_word(word)
        && values.chars().count() <= MAX_TYPED_NAME
    {
        family.last[place] = Varied { subject, values: values.to_owned() };
    }
}

fn put<T>(place: &mut T, value: Option<T>) {
    if let Some(value) = value {
        *place = value;
    }
}

fn word<T: Clone>(words: Words<T>, value: &Value) -> Option<T> {
    words::value(words, value.as_str()?)
}

/// A convention of NDC, by its name on the command line.
fn ndc(value: &Value) -> Option<Ndc> {
    Ndc::ALL.into_iter().find(|ndc| value.as_str() == Some(ndc.name()))
}

fn text(value: &Value) -> Option<String> {
    value.as_str().map(str::to_owned)
}

fn file(value: &Value) -> Option<PathBuf> {
    value.as_str().map(PathBuf::from).filter(|path| path.is_absolute())
}

/// A whole number in a range.
fn whole(value: &Value, range: std::ops::RangeInclusive<usize>) -> Option<usize> {
    value.as_integer().and_then(|whole| usize::try_from(whole).ok()).filter(|whole| range.contains(whole))
}

fn digits(value: &Value) -> Option<usize> {
    whole(value, 2..=crate::numbers::EXACT_DIGITS)
}

fn times(value: &Value) -> Option<Option<u32>> {
    whole(value, 1..=4).map(|times| u32::try_from(times).ok())
}

fn columns(value: &Value) -> Option<Option<usize>> {
    whole(value, 0..=8).map(|columns| Some(columns).filter(|columns| *columns > 0))
}

fn format(value: &Value) -> Option<PictureFormat> {
    PictureFormat::of(&Path::new("a").with_extension(value.as_str()?))
}

fn faces(value: &Value) -> Option<Faces> {
    Faces::ALL.into_iter().find(|faces| value.as_str() == Some(faces.name()))
}

/// A number, even if it's written without a point.
fn number(value: &Value) -> Option<f64> {
    #[expect(clippy::cast_precision_loss, reason = "what people write is far below 2⁵³")]
    let whole = value.as_integer().map(|whole| whole as f64);
    value.as_float().or(whole).filter(|number| number.is_finite())
}

/// The keys of the steps of operations, in the order of [`OPERATIONS`].
static STEP_KEYS: LazyLock<Vec<String>> = LazyLock::new(|| OPERATIONS.iter().map(step_key).collect());

/// The key of the step of an operation.
fn step_key(descriptor: &Descriptor) -> String {
    let axis = match descriptor.freedom {
        Freedom::PanU => "_u",
        Freedom::PanV => "_v",
        Freedom::Elevation
        | Freedom::Azimuth
        | Freedom::Roll
        | Freedom::Yaw
        | Freedom::Pitch
        | Freedom::Zoom
        | Freedom::Dolly => "",
    };
    format!("{}{axis}_step", descriptor.word)
}

/// The preferences of a window: keys with their values.
fn values(state: &State) -> impl Iterator<Item = (&'static str, Value)> {
    let step = |row: &Descriptor| Value::from(state.model.operations.steps[row.freedom as usize]);
    let steps = STEP_KEYS.iter().map(String::as_str).zip(OPERATIONS.iter().map(step));
    KEYS.iter().map(|key| (key.name, (key.of)(state))).chain(steps)
}

/// Sets up a window as in the file. An invalid value counts as none.
fn apply(document: &DocumentMut, state: &mut State) {
    let value = |key: &str| document.get(key).and_then(|item| item.as_value());
    for key in KEYS {
        if let Some(value) = value(key.name) {
            (key.apply)(state, value);
        }
    }
    for (row, key) in OPERATIONS.iter().zip(&*STEP_KEYS) {
        let possible = |step: &f64| *step > 0.0 && (row.amount != Amount::Factor || *step != 1.0);
        if let Some(step) = value(key).and_then(number).filter(possible) {
            state.model.operations.steps[row.freedom as usize] = step;
        }
    }
    state.recent.files = recent(document);
}

/// A lesson and a step of it, from 0, as a text of [`LESSONS`] and [`LESSONS_DONE`].
fn pair(id: &str, step: usize) -> String {
    format!("{id}={}", step + 1)
}

/// The lessons and steps in such a value.
fn pairs(value: &Value) -> impl Iterator<Item = (String, usize)> {
    let texts = value.as_array().into_iter().flatten().filter_map(Value::as_str);
    texts.filter_map(of_pair)
}

/// The lesson and the step, from 0, in a text of [`pair`].
fn of_pair(text: &str) -> Option<(String, usize)> {
    let (id, step) = text.split_once('=')?;
    Some((id.to_owned(), step.parse::<usize>().ok()?.checked_sub(1)?))
}

/// The value of [`LESSONS`].
fn lessons_value(taken: &BTreeMap<String, usize>) -> Value {
    taken.iter().map(|(id, step)| pair(id, *step)).collect()
}

/// The furthest step of each lesson.
fn lessons_taken(pairs: impl Iterator<Item = (String, usize)>) -> BTreeMap<String, usize> {
    let mut taken = BTreeMap::new();
    for (id, step) in pairs {
        let furthest = taken.entry(id).or_default();
        *furthest = step.max(*furthest);
    }
    taken
}

/// The value of [`LESSONS_DONE`].
fn done_value(done: &BTreeMap<String, BTreeSet<usize>>) -> Value {
    done.iter().flat_map(|(id, steps)| steps.iter().map(move |step| pair(id, *step))).collect()
}

/// The done steps of each lesson.
fn lessons_done(pairs: impl Iterator<Item = (String, usize)>) -> BTreeMap<String, BTreeSet<usize>> {
    let mut done: BTreeMap<String, BTreeSet<usize>> = BTreeMap::new();
    for (id, step) in pairs {
        done.entry(id).or_default().insert(step);
    }
    done
}

/// The recent files, the latest first.
fn recent(document: &DocumentMut) -> Vec<PathBuf> {
    let list = document.get(RECENT).and_then(|item| item.as_array());
    let paths = list.into_iter().flatten().filter_map(|value| value.as_str().map(PathBuf::from));
    paths.filter(|path| path.is_absolute()).collect()
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::appearance::Theme;
    use crate::figure::Explanation;
    use crate::gui::Start;
    use crate::gui::export::family_choice::FamilyChoice;
    use crate::gui::export::{Export, Paper};
    use crate::views::Arrangement;
    use camera_lab_desk::Conventions;
    use camera_lab_words::Lang;

    fn state() -> State {
        State::new(Start::default()).unwrap()
    }

    fn written(state: &State) -> BTreeMap<&'static str, String> {
        values(state).map(|(key, value)| (key, value.to_string())).collect()
    }

    fn document(state: &State) -> DocumentMut {
        let lines: Vec<String> =
            written(state).into_iter().map(|(key, value)| format!("\"{key}\" = {value}\n")).collect();
        lines.concat().parse().unwrap()
    }

    #[test]
    fn every_preference_comes_back() {
        let mut changed = state();
        let settings = &mut changed.model.settings;
        (settings.lang, settings.theme, settings.zoom, settings.digits) = (Lang::PtBr, Theme::Dark, 1.3, 9);
        (settings.panels.wanted, settings.reduce_motion) = ([false, false, true], true);
        (settings.welcomed, settings.numbers_open) = (true, true);
        settings.window = Some(WindowPlace { at: Some([-8, 30]), size: [1000, 700], maximized: true });
        changed.learn.taken.insert("basis".to_owned(), 2);
        changed.learn.stopped = Some(("basis".to_owned(), 1));
        changed.learn.done.insert("basis".to_owned(), [0, 2].into());
        changed.model.layout.arrangement = Some(Arrangement::Beside);
        changed.model.layout.strip = true;
        changed.model.operations.convention = Convention::Vtk;
        let [ndc, compared] = [Ndc::ALL[9], Ndc::ALL[3]];
        changed.model.settings.conventions =
            Conventions { ndc, compared: Some(compared), row_vectors: true, left_handed: true };
        changed.gallery.remember(PathBuf::from("/lectures"));
        changed.sharing.page_file = PathBuf::from("/lectures/camera-lab.html");
        changed.learn.ticks = ["plan", "3-30", "basis"].map(str::to_owned).to_vec();
        changed.export.what = Views::Without(crate::views::View::Image);
        changed.exported_of = Some(Views::All);
        changed.sharing.page_address = "https://example.org/lab/".to_owned();
        changed.learn.exercises.look_into(Some(PathBuf::from("/exercises")));
        let paper = Paper { size: [12.0, 7.5], dpi: 600.0, letters: 11.0, lines: Some(0.75) };
        let (theme, times, format) = (Theme::Light, Some(3), PictureFormat::WebP);
        changed.export = Export {
            theme,
            times,
            format,
            on_paper: true,
            transparent: true,
            crop: true,
            faces: Faces::Picture,
            outlines: true,
            paper,
            ..changed.export
        };
        changed.family = FamilyChoice { columns: Some(3), parts: false, ..FamilyChoice::default().or_last() };
        changed.family.first.values = "20, 30".to_owned();
        changed.family.second.choose(Subject::Typed);
        changed.model.operations.steps = std::array::from_fn(|i| 2.5 + i as f64);
        changed.model.explained.show(Explanation::Code);
        let plain = written(&state());
        for (key, value) in &written(&changed) {
            assert_ne!(Some(value), plain.get(key), "{key} was not changed");
        }
        let mut back = state();
        apply(&document(&changed), &mut back);
        assert_eq!(written(&back), written(&changed));
        assert_eq!((back.model.settings, back.model.layout), (changed.model.settings, changed.model.layout));
    }

    #[test]
    fn two_windows_lose_no_done_step_of_each_other() {
        let value = |text: &str| text.parse::<Value>().unwrap();
        let (one, other) = (value("[\"cube=2\", \"basis=1\"]"), value("[\"basis=3\", \"basis=1\", \"x=0\"]"));
        let merged = lessons_done(pairs(&one).chain(pairs(&other)));
        assert_eq!(merged, [("basis".to_owned(), [0, 2].into()), ("cube".to_owned(), [1].into())].into());
        assert_eq!(lessons_done(pairs(&done_value(&merged))), merged);
    }

    #[test]
    fn values_that_make_no_sense_count_as_none() {
        let text = "language = \"fr\"\ntheme = 3\nzoom = 99\ndigits = -1\nelevation_step = 0\nzoom_step = 1\n\
                    roll_step = nan\npan_u_step = 2\nlayout = [1]\nrecent = [\"relative\", 3]\n";
        let mut state = state();
        let mut expected = written(&state);
        apply(&text.parse().unwrap(), &mut state);
        expected.insert("pan_u_step", "2.0".to_owned());
        assert_eq!(written(&state), expected);
        assert!(state.recent.files.is_empty());
    }
}
