//! The storage of the preferences.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui;
use toml_edit::{Array, DocumentMut, Value};

use crate::gui::app::launch_options::LaunchOptions;
use crate::gui::app::preferences::progress::KeptProgress;
use crate::gui::app::preferences::{
    LESSONS, LESSONS_DONE, RECENT, answers, apply, done_value, lessons_done, lessons_taken, lessons_value, pairs,
    recent, values,
};
use crate::gui::app::state::State;
use crate::gui::kit::frames;
use camera_lab_desk::storage::shared_file::{Change, MAX_WAIT};
use camera_lab_desk::{Keeping, News, Recent, SharedFile, merged};
use camera_lab_files as files;

/// The changes of one window.
#[derive(Clone, Debug, PartialEq)]
struct SettingsJob {
    /// Keys with their values as TOML.
    changed: BTreeMap<&'static str, String>,
    /// The files opened in it, the latest first.
    opened: Vec<PathBuf>,
    /// The typed answers are in a file of their own now.
    answers_moved: bool,
}

impl Change for SettingsJob {
    type Content = DocumentMut;
    /// All files that are remembered.
    type Merged = Vec<PathBuf>;

    fn understood(text: &str) -> Option<DocumentMut> {
        text.parse().ok()
    }

    fn is_empty(&self) -> bool {
        self.changed.is_empty() && self.opened.is_empty() && !self.answers_moved
    }

    fn is_same(&self, other: &Self) -> bool {
        self == other
    }

    fn merge(&self, mut document: DocumentMut) -> (String, Vec<PathBuf>) {
        if self.answers_moved {
            answers::remove(&mut document);
        }
        for (key, value) in &self.changed {
            let Ok(value) = value.parse::<Value>() else { continue };
            let before = document.get(key).and_then(|item| item.as_value());
            let value = match (*key, before) {
                (LESSONS, Some(before)) => lessons_value(&lessons_taken(pairs(before).chain(pairs(&value)))),
                (LESSONS_DONE, Some(before)) => done_value(&lessons_done(pairs(before).chain(pairs(&value)))),
                _ => value,
            };
            document[*key] = value.into();
        }
        let recent = merged(&self.opened, &recent(&document));
        if !self.opened.is_empty() {
            let mut list = Array::new();
            list.extend(recent.iter().filter_map(|path| path.to_str()));
            document[RECENT] = list.into();
        }
        (document.to_string(), recent)
    }
}

/// The preferences of a window, and the file in which they are kept.
pub struct Preferences {
    file: SharedFile<SettingsJob>,
    /// The keys of this window as in the file, at present or when it was read.
    kept: BTreeMap<&'static str, Value>,
    /// The keys in the file.
    remembered: BTreeSet<String>,
    progress: KeptProgress,
    /// The file of preferences still has typed answers.
    has_answers: bool,
}

impl Preferences {
    /// Sets up a window from the file in `folder`. The options in `asked` are for this window only, and aren't saved.
    pub fn begin(folder: &Path, state: &mut State, asked: LaunchOptions) -> Self {
        files::remove_left_over(folder);
        let (file, content) = SharedFile::open(
            folder.join("preferences.toml"),
            "preferences",
            (Keeping::Preferences, News::PreferencesSetAside),
        );
        // The initial figure may set how it's shown, but that isn't a preference.
        state.model.give_back_layout();
        if let Some(document) = &content {
            apply(document, state);
        }
        let kept_before = content.unwrap_or_default();
        state.model.show_screen(state.model.desk.shown.figure().screen);
        asked.apply(&mut state.model);
        let progress = KeptProgress::begin(folder, &mut state.learn, &kept_before);
        let has_answers = answers::read(&kept_before).next().is_some();
        let remembered = kept_before.iter().map(|(key, _)| key.to_owned()).collect();
        let kept = values(state).collect();
        // A page may show a figure in the middle of another author's text.
        state.learn.welcome = !state.model.settings.welcomed && !state.model.in_browser;
        state.learn.goes_on = state.model.settings.welcomed && !state.model.in_browser && !state.learn.taken.is_empty();
        Self { file, kept, remembered, progress, has_answers }
    }

    /// Sets a key to the system's value, unless the user has chosen otherwise. That isn't remembered.
    #[cfg(any(test, target_arch = "wasm32"))]
    pub(in crate::gui) fn follow(&mut self, state: &mut State, key: &str, set: impl FnOnce(&mut State)) {
        let is_chosen = values(state).any(|(of, value)| of == key && !self.is_kept(of, &value));
        if self.remembered.contains(key) || is_chosen {
            return;
        }
        set(state);
        self.kept.extend(values(state).filter(|(of, _)| *of == key));
    }

    /// Saves changes, beside the window's thread. A failed write is repeated with the next change.
    pub fn keep(&mut self, ctx: &egui::Context, state: &mut State) {
        self.progress.keep(ctx, &mut state.model, &mut state.learn);
        self.take(&mut state.recent, Duration::ZERO);
        let job = self.job(state);
        self.file.ask(&frames(ctx), job);
    }

    /// Saves the rest, before the window closes.
    pub fn finish(&mut self, state: &mut State) {
        self.progress.finish(&mut state.learn);
        self.take(&mut state.recent, MAX_WAIT);
        let job = self.job(state);
        self.file.finish(&job);
    }

    /// New messages about them, each once.
    pub fn news(&mut self) -> Vec<News> {
        let mut news = self.file.news();
        news.extend(self.progress.news());
        news
    }

    /// The savable parts, as far as known.
    pub fn kept(&self) -> impl Iterator<Item = Keeping> {
        let kept = [(Keeping::Preferences, self.file.is_failing()), (Keeping::Progress, self.progress.is_failing())];
        kept.into_iter().filter(|(_, fails)| !fails).map(|(what, _)| what)
    }

    /// The part that isn't in the file yet.
    fn job(&mut self, state: &State) -> SettingsJob {
        let changed = values(state).filter(|(key, value)| !self.is_kept(key, value));
        let changed = changed.map(|(key, value)| (key, value.to_string())).collect();
        let answers_moved = self.has_answers && self.progress.is_written(&state.learn);
        SettingsJob { changed, opened: state.recent.new.clone(), answers_moved }
    }

    fn is_kept(&self, key: &str, value: &Value) -> bool {
        self.kept.get(key).is_some_and(|kept| is_same(kept, value))
    }

    /// Takes the result of a write.
    fn take(&mut self, recent_state: &mut Recent, patience: Duration) {
        if let Some((SettingsJob { changed, opened, answers_moved }, recent)) = self.file.take(patience) {
            self.has_answers &= !answers_moved;
            self.remembered.extend(changed.keys().map(|key| (*key).to_owned()));
            self.kept.extend(changed.into_iter().filter_map(|(key, value)| Some((key, value.parse().ok()?))));
            recent_state.new.retain(|path| !opened.contains(path));
            recent_state.files = merged(&recent_state.new, &recent);
        }
    }
}

/// True if two values of preferences are equal. Every frame compares all of them, so none is written as a text for it.
fn is_same(one: &Value, other: &Value) -> bool {
    match (one, other) {
        (Value::String(one), Value::String(other)) => one.value() == other.value(),
        (Value::Integer(one), Value::Integer(other)) => one.value() == other.value(),
        (Value::Float(one), Value::Float(other)) => one.value() == other.value(),
        (Value::Boolean(one), Value::Boolean(other)) => one.value() == other.value(),
        (Value::Array(one), Value::Array(other)) => {
            one.len() == other.len() && one.iter().zip(other).all(|(one, other)| is_same(one, other))
        }
        _ => false,
    }
}

#[cfg(test)]
pub(in crate::gui) mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use std::fs;

    use super::*;
    use crate::appearance::Theme;
    use crate::gui::Start;
    use camera_lab_files::disk;
    use camera_lab_words::Lang;

    pub(in crate::gui) struct Folder(pub(in crate::gui) PathBuf);

    impl Folder {
        pub(in crate::gui) fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("camera-lab-preferences-{name}-{}", std::process::id()));
            let _ = fs::remove_dir_all(&path);
            Self(path)
        }

        fn text(&self) -> String {
            fs::read_to_string(self.0.join("preferences.toml")).unwrap_or_default()
        }

        pub(in crate::gui) fn window(&self) -> (State, Preferences) {
            let mut state = State::new(Start::default()).unwrap();
            let preferences = Preferences::begin(&self.0, &mut state, LaunchOptions::default());
            (state, preferences)
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    fn keep(preferences: &mut Preferences, state: &mut State) {
        preferences.keep(&egui::Context::default(), state);
        preferences.take(&mut state.recent, Duration::from_secs(60));
    }

    #[test]
    fn nothing_is_written_before_something_is_changed_and_then_that_alone() {
        let folder = Folder::new("alone");
        let (mut state, mut preferences) = folder.window();
        keep(&mut preferences, &mut state);
        assert_eq!(folder.text(), "");
        state.model.settings.theme = Theme::Dark;
        keep(&mut preferences, &mut state);
        assert_eq!(folder.text(), "theme = \"dark\"\n");
        assert_eq!(folder.window().0.model.settings.theme, Theme::Dark);
    }

    #[test]
    fn of_two_windows_the_last_one_wins_key_by_key_and_nothing_is_lost() {
        let folder = Folder::new("two");
        fs::create_dir_all(&folder.0).unwrap();
        fs::write(folder.0.join("preferences.toml"), "# mine\nlater_key = [1, 2] # stays\ndigits = 7\n").unwrap();
        let ((mut one, mut of_one), (mut two, mut of_two)) = (folder.window(), folder.window());
        assert_eq!((one.model.settings.digits, two.model.settings.digits), (7, 7));
        one.model.settings.theme = Theme::Dark;
        one.model.settings.digits = 9;
        one.recent.add(Path::new("/one.toml"));
        keep(&mut of_one, &mut one);
        two.model.settings.digits = 3;
        two.model.layout.strip = true;
        two.recent.add(Path::new("/two.toml"));
        keep(&mut of_two, &mut two);
        assert_eq!(two.recent.files, ["/two.toml", "/one.toml"].map(PathBuf::from));
        let text = folder.text();
        assert!(text.starts_with("# mine\nlater_key = [1, 2] # stays\n"), "{text}");
        let (third, _) = folder.window();
        assert_eq!(
            (third.model.settings.theme, third.model.settings.digits, third.model.layout.strip),
            (Theme::Dark, 3, true)
        );
        assert_eq!(third.recent.files, two.recent.files);
    }

    #[test]
    fn of_two_windows_each_lesson_is_remembered_as_far_as_either_has_come() {
        let folder = Folder::new("lessons");
        let ((mut one, mut of_one), (mut two, mut of_two)) = (folder.window(), folder.window());
        let taken = |lessons: &[(&str, usize)]| lessons.iter().map(|(id, step)| ((*id).to_owned(), *step)).collect();
        two.learn.taken = taken(&[("cube", 2), ("camera", 6)]);
        keep(&mut of_two, &mut two);
        one.learn.taken = taken(&[("camera", 3)]);
        keep(&mut of_one, &mut one);
        one.learn.taken = taken(&[("camera", 4), ("basis", 1)]);
        keep(&mut of_one, &mut one);
        assert_eq!(folder.window().0.learn.taken, taken(&[("basis", 1), ("camera", 6), ("cube", 2)]));
    }

    #[test]
    fn a_broken_file_is_set_aside_and_reported() {
        let folder = Folder::new("broken");
        fs::create_dir_all(&folder.0).unwrap();
        for bytes in [&b"theme = \"dark"[..], &[0xff, 0xfe, 0x00]] {
            fs::write(folder.0.join("preferences.toml"), bytes).unwrap();
            let (mut state, mut preferences) = folder.window();
            let news = preferences.news();
            let [News::PreferencesSetAside(aside)] = &news[..] else { panic!("{news:?}") };
            assert_eq!(fs::read(aside).unwrap(), bytes);
            state.model.settings.digits = 4;
            preferences.finish(&mut state);
            assert_eq!(folder.text(), "digits = 4\n");
        }
    }

    #[test]
    fn a_file_that_is_far_too_large_is_set_aside_unread() {
        let folder = Folder::new("large");
        fs::create_dir_all(&folder.0).unwrap();
        let names = ["preferences", "progress"];
        for name in names {
            // A hole: it takes no room on the disk.
            let file = fs::File::create(folder.0.join(format!("{name}.toml"))).unwrap();
            file.set_len(200 << 20).unwrap();
        }
        let (mut state, mut preferences) = folder.window();
        assert!(matches!(&preferences.news()[..], [News::PreferencesSetAside(_), News::ProgressSetAside(_)]));
        for name in names {
            assert_eq!(fs::metadata(folder.0.join(format!("{name}.damaged"))).unwrap().len(), 200 << 20);
        }
        state.model.settings.digits = 4;
        preferences.finish(&mut state);
        assert_eq!(folder.text(), "digits = 4\n");
        // A large and valid file is read.
        let text = format!("{}digits = 5\n", "# long\n".repeat(100_000));
        fs::write(folder.0.join("preferences.toml"), text).unwrap();
        assert_eq!(folder.window().0.model.settings.digits, 5);
    }

    #[test]
    fn a_language_that_was_asked_for_is_not_remembered() {
        let folder = Folder::new("language");
        let mut state = State::new(Start::default()).unwrap();
        let asked = LaunchOptions { lang: Some(Lang::PtBr), ..LaunchOptions::default() };
        let mut preferences = Preferences::begin(&folder.0, &mut state, asked);
        assert_eq!(state.model.settings.lang, Lang::PtBr);
        preferences.finish(&mut state);
        assert_eq!(folder.text(), "");
    }

    #[test]
    fn system_settings_count_until_the_user_chooses_and_are_not_stored() {
        let folder = Folder::new("follow");
        let (mut state, mut preferences) = folder.window();
        let follow = |preferences: &mut Preferences, state: &mut State, theme| {
            preferences.follow(state, "theme", |state| state.model.settings.theme = theme);
            keep(preferences, state);
            state.model.settings.theme
        };
        assert_eq!(follow(&mut preferences, &mut state, Theme::Dark), Theme::Dark);
        assert_eq!(folder.text(), "");
        assert_eq!(follow(&mut preferences, &mut state, Theme::Light), Theme::Light);
        state.model.settings.theme = Theme::Dark;
        assert_eq!(follow(&mut preferences, &mut state, Theme::Light), Theme::Dark);
        assert_eq!(folder.text(), "theme = \"dark\"\n");
        let (mut next, mut preferences) = folder.window();
        assert_eq!(follow(&mut preferences, &mut next, Theme::Light), Theme::Dark);
    }

    #[test]
    fn preferences_that_cannot_be_written_give_one_message() {
        let folder = Folder::new("refused");
        fs::create_dir_all(folder.0.join("preferences.toml")).unwrap();
        let (mut state, mut preferences) = folder.window();
        assert!(matches!(&preferences.news()[..], [News::NotKept(_)]));
        let mut write = |digits| {
            state.model.settings.digits = digits;
            keep(&mut preferences, &mut state);
            (preferences.news().len(), preferences.kept().collect::<Vec<_>>())
        };
        assert_eq!(write(3), (0, vec![Keeping::Progress]));
        assert_eq!(write(4), (0, vec![Keeping::Progress]));
        fs::remove_dir(folder.0.join("preferences.toml")).unwrap();
        assert_eq!(write(6), (0, vec![Keeping::Preferences, Keeping::Progress]));
        fs::remove_file(folder.0.join("preferences.toml")).unwrap();
        fs::create_dir(folder.0.join("preferences.toml")).unwrap();
        assert_eq!(write(7), (1, vec![Keeping::Progress]));
    }

    #[test]
    fn a_lock_that_is_never_released_is_named_and_does_not_keep_the_window_open() {
        let folder = Folder::new("locked");
        fs::create_dir_all(&folder.0).unwrap();
        let (mut state, mut preferences) = folder.window();
        let locks = ["preferences.lock", "progress.lock"].map(|name| disk::lock(&folder.0.join(name)).unwrap());
        state.model.settings.theme = Theme::Dark;
        keep(&mut preferences, &mut state);
        let said = |news: &News| matches!(news, News::NotKept(why) if format!("{why:?}").contains("ResourceBusy"));
        assert!(preferences.news().iter().any(said));
        let begin = std::time::Instant::now();
        preferences.finish(&mut state);
        assert!(begin.elapsed() < Duration::from_secs(8), "{:?}", begin.elapsed());
        assert_eq!(folder.text(), "");
        drop(locks);
        state.model.settings.digits = 9;
        preferences.finish(&mut state);
        assert!(folder.text().contains("theme = \"dark\""), "it's written as soon as it can be");
    }
}
