//! The kinds of requested files: title, endings, proposed name.

use std::path::{Path, PathBuf};

use crate::export::format::{FIGURE_ENDINGS, PictureFormat};
use crate::gui::app::file_flow::questions::{HandOut, Purpose, TEXTURE_ENDINGS};
use crate::gui::app::state::State;
use crate::gui::platform::native::{FileQuestion, Wanted};
use crate::scene::import::MESH_ENDINGS;
use crate::views::Views;
use camera_lab_desk::FileFor;
use camera_lab_words::class;
use camera_lab_words::file_names::name_of_title;
use camera_lab_words::learn::{exercise_window, handouts, lessons};
use camera_lab_words::why::explain;
use camera_lab_words::window::{self, canvas, gallery, photograph, scenes};
use camera_lab_words::{families, told};

/// A kind of files.
pub(in crate::gui) struct FileKind {
    /// An existing file, a new one, or a folder.
    pub(in crate::gui) wanted: Wanted,
    /// The title of the question.
    pub(in crate::gui) title: &'static str,
    /// The button below it.
    pub(in crate::gui) action: &'static str,
    /// Names of formats with their endings. The first ending is appended to names that have none.
    filters: Vec<(String, &'static [&'static str])>,
    /// The proposed name. Empty for a file to read.
    name: String,
    /// The folder in which the question begins.
    folder: PathBuf,
}

impl FileKind {
    /// The kind of the requested file.
    pub(in crate::gui) fn of(state: &State, purpose: &Purpose) -> Self {
        let lang = state.model.settings.lang;
        let (t, exercises, film) = (window::texts(lang), exercise_window::texts(lang), explain::texts(lang));
        let title =
            state.model.desk.shown.figure().title.as_ref().filter(|_| !state.model.desk.shown.has_words_of_card());
        let title = title.and_then(|title| name_of_title(told(lang, title)));
        let named = if state.model.desk.shown.path().is_some() { None } else { title };
        let figure = named.or_else(|| state.model.desk.shown.name()).unwrap_or_else(|| t.untitled_file.to_owned());
        let figure = PathBuf::from(figure);
        let stem = figure.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let (scene, hand) = (scenes::texts(lang), handouts::texts(lang));
        let format = |name: &str, format: PictureFormat| (format!("{name} {}", format.name()), format.endings());
        let formats = |name: &str, first: PictureFormat| {
            let mut formats = PictureFormat::ALL;
            formats.sort_by_key(|format| *format != first);
            formats.map(|of| format(name, of)).to_vec()
        };
        let file = |title, action, filter: &str, endings| {
            (Wanted::File, title, action, vec![(filter.to_owned(), endings)], String::new())
        };
        let folder = |title| (Wanted::Folder, title, t.open_action, Vec::new(), String::new());
        let new_file = |title, filters, name| (Wanted::NewFile, title, t.save_action, filters, name);
        let (wanted, title, action, filters, name) = match purpose {
            Purpose::Open => {
                let filters =
                    [(t.figure_filter.to_owned(), &FIGURE_ENDINGS[..]), (scenes::mesh_filter(lang), MESH_ENDINGS)];
                (Wanted::File, t.open_title, t.open_action, filters.to_vec(), String::new())
            }
            Purpose::For(FileFor::CompareWith) => {
                file(t.open_title, t.open_action, t.figure_filter, &FIGURE_ENDINGS[..])
            }
            Purpose::Save | Purpose::SaveWithFiles => {
                let filters = vec![(t.figure_filter.to_owned(), &["toml"][..])];
                new_file(t.save_title, filters, figure.with_extension("toml").display().to_string())
            }
            Purpose::Export(export) => {
                let names = canvas::texts(lang);
                let what = match export.what {
                    _ if state.family.variations().is_some() => families::texts(lang).family.to_owned(),
                    Views::All => String::new(),
                    some => some.views().map(|view| names.view(view)).collect::<Vec<_>>().join(" "),
                };
                let what = name_of_title(&what).map_or_else(String::new, |name| format!("-{name}"));
                let name = format!("{stem}{what}.{}", export.format.ending());
                new_file(t.export_title, formats(t.picture_filter, export.format), name)
            }
            Purpose::For(FileFor::Animation(decomposition)) => {
                let mut filters = vec![
                    (format!("{} GIF", film.animation), &["gif"][..]),
                    (format!("{} APNG", film.animation), &["apng"][..]),
                ];
                filters.extend(PictureFormat::ALL.map(|of| format(film.strip, of)));
                new_file(t.export_title, filters, format!("{stem}-{}.gif", decomposition.name()))
            }
            Purpose::Step | Purpose::NewLesson | Purpose::OwnLesson | Purpose::LessonText => {
                let t = lessons::texts(lang);
                let filters = vec![(t.lesson.to_owned(), &["toml"][..])];
                let copied = state.learn.lesson.as_ref().filter(|_| !purpose.adds_step());
                let name = copied.map(|playing| format!("{}.toml", playing.lesson.id));
                let (title, action) =
                    if name.is_some() { (t.copy_title, t.copy_action) } else { (t.step_title, t.step_action) };
                (Wanted::NewFile, title, action, filters, name.unwrap_or_else(|| t.step_file.to_owned()))
            }
            Purpose::For(FileFor::Chart(chart)) => {
                let mut filters = formats(t.chart_filter, PictureFormat::Svg);
                let tables = [(&chart.csv, "CSV", &["csv"][..]), (&chart.json, "JSON", &["json"][..])];
                let tables = tables.into_iter().filter(|(table, ..)| !table.is_empty());
                filters.extend(tables.map(|(_, name, endings)| (name.to_owned(), endings)));
                new_file(t.export_chart_title, filters, format!("{stem}-{}.svg", t.chart_file))
            }
            Purpose::Page(_) => file(hand.page_title, t.open_action, hand.page_filter, &["html"][..]),
            Purpose::HandOut(what, _) => {
                let of_lesson = state.learn.lesson.as_ref();
                let title = of_lesson.and_then(|playing| name_of_title(told(lang, &playing.lesson.title)));
                let (filter, ending) = match what {
                    HandOut::Page => (hand.page_filter, &["html"][..]),
                    HandOut::Course => (hand.package, &["zip"][..]),
                };
                let name = format!("{}.{}", title.unwrap_or(stem), ending[0]);
                new_file(hand.write_title, vec![(filter.to_owned(), ending)], name)
            }
            Purpose::Handout(form) => {
                let t = handouts::texts(lang);
                let filters = vec![(format!("{} PDF", t.filter), &["pdf"][..])];
                new_file(t.title, filters, format!("{}.pdf", form.stem()))
            }
            Purpose::For(FileFor::Progress) => {
                let filters = vec![("CSV".to_owned(), &["csv"][..])];
                // Thirty files in one folder need thirty names.
                let student = state.learn.exercises.progress.student.as_deref().and_then(name_of_title);
                let file = exercises.progress_file;
                let name =
                    student.map_or_else(|| file.to_owned(), |name| file.replace(".csv", &format!("-{name}.csv")));
                new_file(exercises.export_title, filters, name)
            }
            Purpose::For(FileFor::Mesh(_)) => {
                file(scene.mesh_title, scene.mesh_action, &scenes::mesh_filter(lang), MESH_ENDINGS)
            }
            Purpose::For(FileFor::Texture(_)) => {
                file(scene.texture_title, scene.texture_action, scene.texture_filter, TEXTURE_ENDINGS)
            }
            Purpose::For(FileFor::Photograph) => {
                let t = photograph::texts(lang);
                file(t.choose_title, t.choose_action, scene.texture_filter, TEXTURE_ENDINGS)
            }
            Purpose::Folder => folder(gallery::texts(lang).choose),
            Purpose::For(FileFor::Exercises) => folder(exercises.own_open),
            Purpose::For(FileFor::Class) => folder(class::texts(lang).choose),
            Purpose::For(FileFor::Keys(_)) => {
                new_file(t.help_commands, vec![("PDF".to_owned(), &["pdf"][..])], format!("{}.pdf", t.keys_file))
            }
            Purpose::For(FileFor::ClassReport(_)) => {
                let t = class::texts(lang);
                let filters = [("PDF", &["pdf"][..]), ("CSV", &["csv"]), ("JSON", &["json"])];
                new_file(
                    t.report,
                    filters.map(|(name, endings)| (name.to_owned(), endings)).to_vec(),
                    t.file.to_owned(),
                )
            }
        };
        let last = state.recent.files.first().filter(|_| !state.model.in_browser && wanted == Wanted::NewFile);
        let folder = state.model.desk.shown.folder().or_else(|| last.and_then(|path| path.parent()));
        let folder = folder.map(Path::to_owned).unwrap_or_default();
        Self { wanted, title, action, filters, name, folder }
    }

    /// The kind for a figure with a title, whose words become its name.
    pub(in crate::gui) fn with_name_of(self, title: Option<&str>) -> Self {
        let name = title.and_then(name_of_title).map(|name| format!("{name}.toml"));
        Self { name: name.unwrap_or(self.name), ..self }
    }

    /// The proposed path.
    pub(in crate::gui) fn proposal(&self) -> PathBuf {
        // Without a name, a folder ends with its separator.
        if self.folder.as_os_str().is_empty() { PathBuf::from(&self.name) } else { self.folder.join(&self.name) }
    }

    /// The path with an ending of this kind, if it's to be written.
    pub(in crate::gui) fn with_ending(&self, path: PathBuf) -> PathBuf {
        let endings: Vec<&str> = self.filters.iter().flat_map(|(_, endings)| endings.iter().copied()).collect();
        let has_one = endings.iter().any(|own| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(own)));
        match endings.first() {
            Some(ending) if self.wanted == Wanted::NewFile && !has_one => {
                let mut name = path.into_os_string();
                name.push(".");
                name.push(ending);
                name.into()
            }
            Some(_) | None => path,
        }
    }

    /// The question for a dialog outside the window.
    pub(in crate::gui) fn question(self) -> FileQuestion {
        let folder = Some(self.folder).filter(|folder| !folder.as_os_str().is_empty());
        FileQuestion { wanted: self.wanted, title: self.title, filters: self.filters, name: self.name, folder }
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::expect_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::camera::Decomposition;
    use crate::gui::Start;

    #[test]
    fn endings_are_appended_once() {
        let state = State::new(Start::default()).expect("a camera");
        let kind = FileKind::of(&state, &Purpose::Save);
        for (given, made) in [("a", "a.toml"), ("a.toml", "a.toml"), ("a.TOML", "a.TOML"), ("v1.2", "v1.2.toml")] {
            assert_eq!(kind.with_ending(PathBuf::from(given)), PathBuf::from(made));
        }
        let kind = FileKind::of(&state, &Purpose::For(FileFor::Animation(Decomposition::ALL[0])));
        for (given, made) in [("a", "a.gif"), ("a.APNG", "a.APNG"), ("a.jpeg", "a.jpeg"), ("a.toml", "a.toml.gif")] {
            assert_eq!(kind.with_ending(PathBuf::from(given)), PathBuf::from(made));
        }
        let kind = FileKind::of(&state, &Purpose::Open);
        assert_eq!(kind.with_ending(PathBuf::from("a")), PathBuf::from("a"), "what is read has the name it has");
    }
}
