//! Lessons of the user's own: their steps as they are recorded, and those of a folder.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::figure::{Figure, Localized, Screen};
use crate::gui::learn::{CAN_WRITE, Learn};
use crate::lessons::{Draft, Lesson, with_step};
use camera_lab_desk::{Message, Model, Side};
use camera_lab_files::{self as files, FigureFiles, FileAccess, FileError, LeftOut, Overwrite};
use camera_lab_words::learn::lessons as words;

impl Learn {
    /// Reads the user's own lessons: the recent ones, and those beside the one written last, the figure and the
    /// gallery's figures.
    pub(in crate::gui) fn look_for_lessons(&mut self, model: &Model, gallery: Option<&Path>, recent: &[PathBuf]) {
        self.own.clear();
        if !CAN_WRITE || model.in_browser {
            return;
        }
        let of_file = recent.iter().filter(|path| !files::is_network(path) && files::is_lesson(path));
        let of_file = of_file.filter_map(|path| Some((path.clone(), Arc::new(files::read_lesson(path).ok()?.0))));
        self.own.extend(of_file);
        let folders = [self.file.as_deref().and_then(Path::parent), model.desk.shown.folder(), gallery];
        let folders: BTreeSet<&Path> = folders.into_iter().flatten().filter(|f| !f.as_os_str().is_empty()).collect();
        // A folder that can't be read has none.
        let of_folders = folders.into_iter().filter_map(|folder| files::read_lessons(folder).ok());
        self.own.extend(of_folders.flat_map(|found| found.lessons));
        let mut seen = BTreeSet::new();
        self.own.retain(|(path, _)| seen.insert(path.clone()));
    }

    /// Adds the state on the screen to the lesson in a file, which is created if it doesn't exist.
    pub(in crate::gui) fn add_step(&mut self, model: &mut Model, path: &Path, overwrite: Overwrite) {
        if !CAN_WRITE {
            return;
        }
        if self
            .lesson
            .as_ref()
            .is_some_and(|playing| playing.writing.is_some() && playing.path.as_deref() == Some(path))
        {
            // The window has the text of the file, and knows its own changes.
            return self.add_to_written(model, path);
        }
        let (figure, left_out) = for_lesson(model, path);
        match added(self, model, (path, &figure), overwrite) {
            Ok(lesson) => self.step_is_added(model, path, lesson, left_out),
            Err(error) => model.say(Message::File(path.to_owned(), error)),
        }
    }

    /// Goes on with a built-in lesson or that of a link as the user's own, in a copy in a file. The meshes of a link go
    /// beside it.
    pub(in crate::gui) fn copy_lesson(&mut self, model: &mut Model, path: &Path, overwrite: Overwrite) {
        if !CAN_WRITE {
            return;
        }
        let Some(playing) = &self.lesson else { return };
        let text = match &playing.path {
            Some(link) => files::read_lesson(link).map(|(_, text)| text),
            None => {
                let mut all = crate::lessons::shipped().iter();
                let Some(shipped) = all.find(|shipped| shipped.lesson.id == playing.lesson.id) else { return };
                Ok(shipped.text.to_owned())
            }
        };
        let saved = text.and_then(|text| files::save(path, text.as_bytes(), overwrite));
        match saved {
            Ok(()) => {
                let carried = playing.path.as_deref().zip(path.parent());
                let left_out = carried.and_then(|(link, folder)| files::save_carried(link, &playing.lesson, folder));
                // The figure of the step stays as on the screen.
                if let Some(playing) = &mut self.lesson {
                    playing.path = Some(path.to_owned());
                }
                self.write_lesson(model);
                if let Some(left_out) = left_out {
                    model.say(Message::NotBeside(path.to_owned(), left_out));
                }
            }
            Err(error) => model.say(Message::File(path.to_owned(), error)),
        }
    }

    /// True if the figure, which has no file of its own, is in the last step of the lesson to which steps were added.
    pub(in crate::gui) fn is_recorded(&self, model: &mut Model) -> bool {
        if !CAN_WRITE {
            return false;
        }
        let Some(path) = self.file.as_deref().filter(|_| model.desk.shown.path().is_none()) else {
            return false;
        };
        let Ok((lesson, _)) = files::read_lesson(path) else { return false };
        if self.title_to_record(model, Some(&lesson)).is_some() {
            return false;
        }
        let here = as_shown(model);
        let content = |figure: &Figure| (Figure { title: None, ..figure.without_scene() }, figure.scene.clone());
        lesson.steps.last().is_some_and(|step| content(&step.figure) == content(&here))
    }

    /// The title that the user gave the figure, if no step of the lesson has it yet.
    pub(in crate::gui) fn title_to_record(&self, model: &Model, lesson: Option<&Lesson>) -> Option<Localized> {
        let title = model.desk.shown.figure().title.as_ref()?;
        let mut steps = lesson.iter().flat_map(|lesson| &lesson.steps);
        let is_of_step = self.lesson.is_some() && model.desk.shown.saved().title.as_ref() == Some(title);
        let is_new = !is_of_step && !model.desk.shown.has_words_of_card() && steps.all(|step| step.title != *title);
        is_new.then(|| title.clone())
    }

    /// The words of a new step in a lesson. If the user gave the figure a title, it becomes the step's.
    pub(in crate::gui) fn draft_of_step(&self, model: &Model, lesson: Option<&Lesson>) -> Draft {
        let mut draft = words::draft(model.settings.lang, lesson.map_or(0, |lesson| lesson.steps.len()) + 1);
        if let Some(title) = self.title_to_record(model, lesson) {
            draft.title = title;
        }
        draft
    }

    /// Reports the last step of a lesson as added, and continues with the lesson if it's the one being played.
    /// `left_out` are the files that it can't show.
    pub(in crate::gui) fn step_is_added(
        &mut self,
        model: &mut Model,
        path: &Path,
        lesson: Lesson,
        left_out: Option<LeftOut>,
    ) {
        self.file = Some(path.to_owned());
        model.say(Message::StepAdded(path.to_owned(), lesson.steps.len(), left_out));
        if let Some(playing) = self.lesson.as_mut().filter(|playing| playing.path.as_deref() == Some(path)) {
            // The steps before it have their places.
            playing.lesson = Arc::new(lesson);
        }
    }
}

fn added(
    learn: &Learn,
    model: &Model,
    (path, figure): (&Path, &Figure),
    overwrite: Overwrite,
) -> Result<Lesson, FileError> {
    let (lesson, text) = if files::disk::may_exist(path) {
        let (lesson, text) = files::read_lesson(path)?;
        (Some(lesson), text)
    } else {
        (None, String::new())
    };
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let draft = learn.draft_of_step(model, lesson.as_ref());
    let (text, lesson) = with_step(&text, &stem, &draft, figure)?;
    files::save(path, text.as_bytes(), overwrite)?;
    Ok(lesson)
}

/// The figure as on the screen, for a step of the lesson in a file: its files are the same from there. Those that
/// lessons don't read are returned too.
pub(in crate::gui) fn for_lesson(model: &mut Model, lesson: &Path) -> (Figure, Option<LeftOut>) {
    let (figure, _) = files::for_folder(&as_shown(model), model.desk.shown.folder(), lesson.parent());
    let folder = lesson.parent().unwrap_or(Path::new(""));
    let mut reads = FigureFiles::new(folder, FileAccess::Lesson);
    let is_lost = |name: &&str| reads.read(crate::scene::Wanted { path: name, named_by: None }).is_err();
    let left_out: Vec<String> = files::own_files(&figure).into_keys().filter(is_lost).map(str::to_owned).collect();
    (figure, (!left_out.is_empty()).then_some(LeftOut(left_out)))
}

/// The figure as on the screen, with explanations, views and panel. If you haven't turned a view, its viewpoint isn't
/// stored, so that it's fitted when the step is played.
pub(in crate::gui) fn as_shown(model: &mut Model) -> Figure {
    let seen = model.as_seen();
    let panel = model.settings.panels().is_shown(Side::Explain).then(|| model.explained.shown());
    let pictures = crate::views::View::ALL.map(|view| model.layout.is_shown(view));
    let figure = model.desk.shown.figure();
    let screen = Screen {
        pictures: Some(pictures),
        panel: Some(panel),
        arrangement: Some(model.layout.arrangement),
        ..figure.screen
    };
    Figure { show: seen.show, screen, ..figure.clone() }
}
