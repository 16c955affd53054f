//! Opening, saving and closing: the questions, their order, and the actions.
//!
//! ```text
//! New, Open, a dropped file, Quit ── unsaved? ── ask ──┐
//! Save, Save as, Export ── which file? ── there already? changed by another program? read-only? ── ask ── do it ── then what was wanted
//! ```

pub(super) mod file_kind;
pub(super) mod hand_out;
pub(super) mod link_dialog;
mod opening;
pub(super) mod qr;
pub mod questions;
mod reading;
mod saving;
mod sequence;
pub mod title_dialog;

use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui::{self, ViewportCommand};

use crate::export::format::PictureFormat;
use crate::figure::read::parse;
use crate::figure::update;
use crate::gui::app::file_flow::file_kind::FileKind;
use crate::gui::app::file_flow::opening::{mesh, open_shipped, photograph, texture};
use crate::gui::app::file_flow::questions::{Agreed, Asking, Changed, Dialog, FileFlow, Purpose, TitleForm};
use crate::gui::app::file_flow::reading::Take;
use crate::gui::app::file_flow::saving::{Save, Saved};
use crate::gui::app::file_flow::sequence::FigureSearch;
use crate::gui::app::state::State;
use crate::gui::export::{ExportKind, Exporting, Task, save_chart};
use crate::gui::kit::frames;
use crate::gui::platform::native::{FileAnswer, OpenFileDialog, Wanted};
use crate::scene::Shape;
use crate::scene::import::MESH_ENDINGS;
use camera_lab_desk::desk::{Losses, Need, Reply};
use camera_lab_desk::{
    Document, ExportError, FileFor, Intent, MeshFor, Message, Model, NotExported, Source, Tab, Theirs,
};
use camera_lab_files::{self as files, FileError, Overwrite, disk};
use camera_lab_words::class::ClassReport;

/// Does what the user wants, after asking about all losses: text of a lesson that can't be saved, and changes of the
/// figure. Every intent that replaces or closes a document comes through here.
pub fn begin(ctx: &egui::Context, state: &mut State, intent: Intent) {
    state.learn.end_move(&mut state.model);
    state.model.settle_layout();
    state.model.desk.commit();
    let text = !state.learn.save_text(&mut state.model);
    let is_recorded = intent == Intent::WriteRecorded && state.learn.is_recorded(&mut state.model);
    let figure = state.model.is_unsaved() && !is_recorded;
    let need = state.model.desk.wish(intent, Losses { figure, text });
    meet(ctx, state, need);
}

/// Takes the answer to a question about losses.
pub fn reply(ctx: &egui::Context, state: &mut State, reply: Reply) {
    let need = state.model.desk.reply(reply);
    meet(ctx, state, need);
}

/// Goes on with the intent that waited until work was saved.
pub fn go_on(ctx: &egui::Context, state: &mut State) {
    if let Some(intent) = state.model.desk.errand().cloned() {
        begin(ctx, state, intent);
    }
}

fn meet(ctx: &egui::Context, state: &mut State, need: Need) {
    match need {
        Need::AskAboutText => {
            // The dialog says why.
            state.file_flow.refused = state.model.message.take();
            state.file_flow.dialog = Some(Dialog::UnsavedText);
        }
        Need::AskAboutFigure => state.file_flow.dialog = Some(Dialog::Unsaved),
        Need::SaveFigure => save(ctx, state),
        Need::SaveText => ask(ctx, state, Purpose::LessonText),
        // Changes are lost, so only the desk's answer leads here.
        Need::Do(Intent::New) => {
            if let Ok(document) = Document::new(camera_lab_desk::document::fresh(), None) {
                state.learn.take_over(&mut state.model, document);
            }
        }
        Need::Do(Intent::Open) => ask(ctx, state, Purpose::Open),
        Need::Do(Intent::OpenPath(path)) => open(ctx, state, &path),
        Need::Do(Intent::Shipped(name)) => open_shipped(&mut state.model, &mut state.learn, name),
        Need::Do(Intent::Text(text)) => match parse(&text).map(|figure| Document::new(figure, None)) {
            Ok(Ok(document)) => state.learn.take_over(&mut state.model, document),
            Ok(Err(error)) => state.model.say(Message::Camera(error)),
            // The program wrote it, for a camera that it had measured. A test opens every one.
            Err(_) => {}
        },
        Need::Do(Intent::Lesson(open)) => {
            open.path
                .iter()
                .filter(|path| files::share::link_of(path).is_none())
                .for_each(|path| state.recent.add(path));
            state.learn.play(&mut state.model, open);
        }
        Need::Do(Intent::LeaveLesson) => state.learn.leave_lesson(&mut state.model),
        Need::Do(Intent::WriteRecorded) => state.learn.write_recorded(&mut state.model),
        Need::Do(Intent::ReadLesson) => state.learn.read_lesson_again(&mut state.model),
        Need::Do(Intent::Reload) => {
            if let Some(path) = state.model.desk.shown.path().cloned() {
                open(ctx, state, &path);
            }
        }
        Need::Do(Intent::Restore(slot)) => state.file_flow.restore = Some(slot),
        // On to the next document that closing would lose. If there are none left, the window closes.
        Need::Do(Intent::Quit) => match state.model.desk.next_to_close(state.model.is_unsaved()) {
            Some(document) => {
                state.learn.take_over(&mut state.model, document);
                begin(ctx, state, Intent::Quit);
            }
            None if state.file_flow.exporting.is_empty() => close(ctx, &mut state.file_flow),
            None => state.file_flow.show(Dialog::Closing),
        },
        Need::Nothing => {}
    }
}

/// Closes the window, regardless of running work.
pub fn close(ctx: &egui::Context, file_flow: &mut FileFlow) {
    file_flow.may_close = true;
    ctx.send_viewport_cmd(ViewportCommand::Close);
}

/// Saves to the figure's own file. If it has none, asks for one.
pub fn save(ctx: &egui::Context, state: &mut State) {
    let named = || state.model.in_browser.then(|| FileKind::of(state, &Purpose::Save).proposal());
    match state.model.desk.shown.path().cloned().or_else(named) {
        Some(path) => write(ctx, state, Save::of(&state.model, path, Agreed::default())),
        None => ask(ctx, state, Purpose::Save),
    }
}

/// Asks for a file, with the system's dialog or with a text field if there is none. A page in a browser has no folders
/// to choose from, so it asks only for the name of a figure.
pub fn ask(ctx: &egui::Context, state: &mut State, purpose: Purpose) {
    // A figure made from a card has words of its own.
    let asks_title = matches!(purpose, Purpose::Save) && state.model.desk.shown.shipped_name().is_some();
    if asks_title && state.file_flow.titled != Some(state.model.desk.shown.id()) {
        let form = TitleForm::of(&state.model, Some(purpose));
        state.file_flow.dialog = Some(Dialog::Title(form));
        return;
    }
    let kind = FileKind::of(state, &purpose);
    let hands_out = state.model.in_browser && kind.wanted == Wanted::NewFile;
    if hands_out && !matches!(purpose, Purpose::Save) {
        chosen(ctx, state, purpose, kind.proposal());
    } else if state.file_flow.native && !hands_out {
        // The shell opens the dialog, in front of its window.
        let (document, question) = (state.model.desk.shown.id(), Some(kind.question()));
        state.file_flow.asking = Some(Asking { purpose, document, question, dialog: None });
        ctx.request_repaint();
    } else {
        ask_in_window(&mut state.file_flow, purpose, &kind);
    }
}

/// Asks for the path of a file in a field.
fn ask_in_window(file_flow: &mut FileFlow, purpose: Purpose, kind: &FileKind) {
    file_flow.refused = None;
    file_flow.show(Dialog::Path(purpose, kind.proposal().display().to_string()));
}

/// Opens the system's dialog for the waiting question, in front of the window of `frame`.
pub(in crate::gui) fn open_dialog(ctx: &egui::Context, file_flow: &mut FileFlow, frame: &eframe::Frame) {
    if let Some(asking) = &mut file_flow.asking
        && let Some(question) = asking.question.take()
    {
        asking.dialog = Some(OpenFileDialog::start(ctx, question, frame));
    }
}

/// Goes on with the answer of the system's dialog. It belongs to the document that was shown when the question came up.
fn answered(ctx: &egui::Context, state: &mut State, answer: FileAnswer) {
    let Some(Asking { purpose, document, .. }) = state.file_flow.asking.take() else { return };
    let is_same = document == state.model.desk.shown.id();
    match (answer, purpose) {
        (FileAnswer::Cancelled, _) => {}
        // The next question may have a dialog again.
        (FileAnswer::Unavailable, purpose) => {
            let kind = FileKind::of(state, &purpose);
            ask_in_window(&mut state.file_flow, purpose, &kind);
        }
        (FileAnswer::Chosen(path), Purpose::Open) if !is_same => begin(ctx, state, Intent::OpenPath(path)),
        (FileAnswer::Chosen(path), purpose) if is_same || !purpose.is_about_figure() => {
            chosen(ctx, state, purpose, path);
        }
        (FileAnswer::Chosen(path), _) => state.model.say(Message::OtherFigure(path)),
    }
}

/// Goes on with the chosen file. Asks before it replaces a file.
pub fn chosen(ctx: &egui::Context, state: &mut State, mut purpose: Purpose, path: PathBuf) {
    let kind = FileKind::of(state, &purpose);
    let path = kind.with_ending(files::whole(&path));
    if let Purpose::Export(export) = &mut purpose {
        export.transparent = export.is_without_ground();
        export.format = PictureFormat::of(&path).unwrap_or(export.format);
        if export.transparent && !export.format.has_transparency() {
            let error = ExportError::NoTransparency(export.format);
            return state.model.say(Message::NotExported(path, NotExported(error)));
        }
    }
    let own = state.model.desk.shown.path() == Some(&path);
    // A step is added to the file's content.
    let adds = purpose.adds_step();
    let is_new = kind.wanted == Wanted::NewFile && !own && !adds;
    if is_new && !replaced(&purpose, &path).is_empty() {
        state.file_flow.dialog = Some(Dialog::Overwrite(purpose, path));
    } else {
        confirmed(ctx, state, purpose, &path, Agreed::default());
    }
}

/// The existing files that writing to `path` replaces. A picture may have another file beside it.
pub fn replaced(purpose: &Purpose, path: &Path) -> Vec<PathBuf> {
    let writes_pictures =
        matches!(purpose, Purpose::Export(_) | Purpose::For(FileFor::Animation(_) | FileFor::Chart(_)));
    let beside = crate::picture::file_beside(path).filter(|_| writes_pictures);
    std::iter::once(path.to_owned()).chain(beside).filter(|path| disk::may_exist(path)).collect()
}

/// Opens or writes the file, with the overwrites in `agreed`.
pub fn confirmed(ctx: &egui::Context, state: &mut State, purpose: Purpose, path: &Path, agreed: Agreed) {
    let writes_lesson = purpose.writes_lesson();
    match purpose {
        Purpose::Open => open(ctx, state, path),
        Purpose::Save => write(ctx, state, Save::of(&state.model, path.to_owned(), agreed)),
        Purpose::SaveWithFiles => {
            write(ctx, state, Save { with_files: true, ..Save::of(&state.model, path.to_owned(), agreed) });
        }
        Purpose::Export(_)
        | Purpose::For(
            FileFor::Animation(_) | FileFor::Chart(_) | FileFor::Progress | FileFor::ClassReport(_) | FileFor::Keys(_),
        )
        | Purpose::Handout(_)
        | Purpose::HandOut(..)
        | Purpose::Step
        | Purpose::NewLesson
        | Purpose::OwnLesson
        | Purpose::LessonText
            if !agreed.read_only && files::is_read_only(path) =>
        {
            state.file_flow.dialog = Some(Dialog::ReadOnly(purpose, path.to_owned(), agreed));
        }
        Purpose::For(FileFor::Mesh(which)) => mesh(&mut state.model, which, path),
        Purpose::For(FileFor::CompareWith) => {
            let path = path.to_owned();
            read(ctx, state, path.clone(), move || opening::read_compared(path));
        }
        Purpose::For(FileFor::Texture(object)) => texture(&mut state.model, &object, path),
        Purpose::For(FileFor::Photograph) => photograph(&mut state.model, path),
        Purpose::For(FileFor::Progress) => {
            save_bytes(&mut state.model, path, Ok(state.learn.exercises.progress.to_csv().into_bytes()), &agreed);
        }
        Purpose::Step => state.learn.add_step(&mut state.model, path, agreed.overwrite()),
        Purpose::NewLesson => {
            state.learn.add_step(&mut state.model, path, agreed.overwrite());
            if state.learn.file.as_deref() == Some(path) {
                begin(ctx, state, Intent::WriteRecorded);
            }
        }
        Purpose::OwnLesson => state.learn.copy_lesson(&mut state.model, path, agreed.overwrite()),
        Purpose::LessonText => {
            if state.learn.save_text_as(&mut state.model, path, agreed.overwrite()) {
                go_on(ctx, state);
            }
        }
        Purpose::For(FileFor::Chart(block)) => {
            let saved = save_chart(&block, state.model.settings.lang, path, agreed.overwrite());
            say_whether_saved(&mut state.model, path, saved);
        }
        Purpose::For(FileFor::Animation(decomposition)) => {
            let what = ExportKind::Animation(decomposition, state.model.settings.theme);
            export(ctx, state, what, (path.to_owned(), agreed.overwrite()));
        }
        Purpose::Page(what) => hand_out::take_page(ctx, state, what, path),
        Purpose::HandOut(what, page) => {
            let bytes = hand_out::bytes(state, what, &page);
            save_bytes(&mut state.model, path, bytes, &agreed);
        }
        Purpose::Handout(form) => {
            let what = ExportKind::Handout(Box::new(form.job(&state.learn)));
            export(ctx, state, what, (path.to_owned(), agreed.overwrite()));
        }
        Purpose::For(FileFor::Class) => match ClassReport::of_folder(path, state.model.settings.lang) {
            Ok(report) => state.file_flow.dialog = Some(Dialog::Class(Box::new(report))),
            Err(error) => state.model.say(Message::File(path.to_owned(), error)),
        },
        Purpose::For(FileFor::Keys(bytes)) => save_bytes(&mut state.model, path, Ok(bytes), &agreed),
        Purpose::For(FileFor::ClassReport(report)) => {
            let bytes = report.file(path, state.model.settings.lang);
            let bytes = bytes.ok_or_else(|| FileError::Write(std::io::ErrorKind::InvalidInput.into()));
            save_bytes(&mut state.model, path, bytes, &agreed);
        }
        Purpose::For(FileFor::Exercises) => state.learn.exercises.look_into(Some(path.to_owned())),
        Purpose::Folder => {
            state.gallery.look_into(path.to_owned());
            state.file_flow.dialog = Some(Dialog::Gallery);
        }
        Purpose::Export(options) => {
            export(ctx, state, ExportKind::Pictures(options), (path.to_owned(), agreed.overwrite()));
        }
    }
    if writes_lesson && state.learn.file.as_deref() == Some(path) {
        state.recent.add(path);
    }
}

fn save_bytes(model: &mut Model, path: &Path, bytes: Result<Vec<u8>, FileError>, agreed: &Agreed) {
    let saved = bytes.and_then(|bytes| files::save(path, &bytes, agreed.overwrite()));
    say_whether_saved(model, path, saved);
}

fn say_whether_saved(model: &mut Model, path: &Path, saved: Result<(), FileError>) {
    match saved {
        Ok(()) => say_saved(model, path.to_owned()),
        Err(error) => model.say(Message::File(path.to_owned(), error)),
    }
}

fn export(
    ctx: &egui::Context,
    State { model, family, file_flow, .. }: &mut State,
    what: ExportKind,
    to: (PathBuf, Overwrite),
) {
    file_flow.exporting.push(Exporting::start(ctx, Task::new(model, family, what, to)));
    model.say(Message::Exporting);
}

/// Opens a figure, a lesson, or a link in a file. A figure that was left with changes returns with them.
fn open(ctx: &egui::Context, state: &mut State, path: &Path) {
    match state.model.desk.take_left(Some(&Source::File(files::whole(path)))) {
        Some(kept) => {
            state.learn.take_over(&mut state.model, kept);
            state.file_flow.look = true;
        }
        None => {
            let path = path.to_owned();
            read(ctx, state, path.clone(), move || opening::read(path));
        }
    }
}

/// Moves on to the next figure, or back to the one before.
pub fn step(ctx: &egui::Context, state: &mut State, forwards: bool) {
    state.model.desk.commit();
    let search = FigureSearch::of(&state.model, forwards);
    let folder = search.folder().map(Path::to_owned).unwrap_or_default();
    read(ctx, state, folder, move || {
        let found = search.find();
        Box::new(move |_, state, _| sequence::show(state, found))
    });
}

/// Reads a file. If it takes long, the window stays usable, and [`poll`] goes on with it.
fn read(ctx: &egui::Context, state: &mut State, path: PathBuf, read: impl FnOnce() -> Take + Send + 'static) {
    state.file_flow.reading.begin(ctx, &state.model, path, Box::new(read));
    take_content(ctx, state, state.file_flow.reading.patience);
}

/// Goes on with a file that was read.
fn take_content(ctx: &egui::Context, state: &mut State, patience: Duration) {
    if let Some((take, is_changed)) = state.file_flow.reading.take(&state.model, patience) {
        take(ctx, state, is_changed);
    }
}

/// Asks about the content of another program in the figure's file.
pub fn ask_about(file_flow: &mut FileFlow, theirs: Theirs) {
    file_flow.dialog = Some(Dialog::Changed(Changed { theirs, comparison: None }));
}

/// The text that saving would write into the figure's own file.
pub fn text_to_save(model: &Model) -> String {
    update(model.desk.shown.source(), &model.figure_to_save())
}

/// The text of the present screen, in the form for links.
pub fn text_as_shown(model: &Model) -> String {
    update(model.desk.shown.source(), &model.figure_as_shown())
}

/// Writes the figure. If it takes long, the window stays usable, and [`poll`] takes the result.
fn write(ctx: &egui::Context, state: &mut State, save: Save) {
    if let Some(error) = state.model.desk.shown.problem().filter(|_| state.model.desk.shown.has_stand_in_camera()) {
        state.model.say(Message::NotSaved(error.clone()));
        return;
    }
    let path = save.path.clone();
    if state.file_flow.saving.writes(&path) {
        // It could overtake the first one, so it waits for it.
        state.file_flow.saving.queue(save, state.model.desk.shown.id());
    } else {
        state.file_flow.saving.begin(ctx, &state.model, save);
        take_saved(ctx, state, state.file_flow.saving.patience);
    }
    if state.file_flow.saving.writes(&path) {
        state.model.say(Message::Saving(path));
    }
}

/// Goes on with the result of writing the figure. It may be about a document that the window has left meanwhile.
fn take_saved(ctx: &egui::Context, state: &mut State, patience: Duration) {
    let Some((save, of, saved)) = state.file_flow.saving.take(patience) else { return };
    let is_shown = of == Some(state.model.desk.shown.id());
    let Save { path, agreed, with_files, for_errand } = save;
    match saved {
        Saved::Done(done) => {
            let (figure, renamed, text) = *done;
            if let Some(document) = of.and_then(|of| state.model.desk.by_id(of)) {
                document.mark_saved(path.clone(), text, figure, &renamed);
                if with_files {
                    document.forget_carried();
                }
            }
            state.recent.add(&path);
            say_saved(&mut state.model, path);
            if is_shown {
                state.file_flow.watch.forget();
                if for_errand {
                    go_on(ctx, state);
                }
            }
        }
        Saved::Changed(theirs) if is_shown => ask_about(&mut state.file_flow, theirs),
        Saved::ReadOnly if is_shown => {
            let purpose = if with_files { Purpose::SaveWithFiles } else { Purpose::Save };
            state.file_flow.dialog = Some(Dialog::ReadOnly(purpose, path, agreed));
        }
        Saved::Changed(_) | Saved::ReadOnly => state.model.say(Message::OtherFigure(path)),
        Saved::Failed(error) => state.model.say(Message::File(path, error)),
    }
    if let Some(next) = state.file_flow.saving.queued(state.model.desk.shown.id()) {
        write(ctx, state, next);
    }
}

/// Reports that a file has been written: to the requested path, or as a download of the browser.
fn say_saved(model: &mut Model, path: PathBuf) {
    model.say(if model.in_browser { Message::Downloaded(path) } else { Message::Saved(path) });
}

/// Checks if another program has changed the figure's file, when the window gets the focus and when it was restored.
fn watch(ctx: &egui::Context, model: &Model, file_flow: &mut FileFlow) {
    let focused = ctx.input(|input| input.raw.events.contains(&egui::Event::WindowFocused(true)));
    if std::mem::take(&mut file_flow.look) || focused {
        file_flow.watch.begin(&frames(ctx), &model.desk.shown);
    }
    file_flow.watch.poll(&model.desk.shown);
}

/// The automatic part of each frame: answers of dialogs and of exports, dropped files, the window's own close button.
pub fn poll(ctx: &egui::Context, state: &mut State) {
    if let Some(answer) = state.file_flow.asking.as_mut().and_then(|asking| asking.dialog.as_mut()?.poll()) {
        answered(ctx, state, answer);
    }
    take_content(ctx, state, Duration::ZERO);
    take_saved(ctx, state, Duration::ZERO);
    take_exports(ctx, &mut state.model, &mut state.file_flow);
    if !state.file_flow.serves_errand() {
        // The user has left the question, or the file can't be written.
        state.model.desk.reply(Reply::Cancel);
    }
    if !state.is_closing() {
        state.model.desk.keep_given_up();
    }
    watch(ctx, &state.model, &mut state.file_flow);
    take_given(ctx, state);
    if ctx.input(|input| input.viewport().close_requested()) && !state.file_flow.may_close {
        if state.would_lose_something() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            if !state.is_closing() {
                // We don't wait for the answer of a system dialog any more. If the window stays, an open dialog comes
                // back.
                state.file_flow.asking = None;
                let document = state.model.desk.shown.id();
                state.file_flow.covered = state.file_flow.dialog.take().map(|dialog| (document, dialog));
                begin(ctx, state, Intent::Quit);
            }
        } else {
            state.file_flow.may_close = true;
        }
    }
    if state.file_flow.dialog.is_none() && state.file_flow.asking.is_none() && !state.file_flow.may_close {
        let covered = state.file_flow.covered.take().filter(|(document, _)| *document == state.model.desk.shown.id());
        state.file_flow.dialog = covered.map(|(_, dialog)| dialog);
    }
}

/// Opens files that were dropped, or given to a page. The first one waits until no question is open that it would
/// replace.
fn take_given(ctx: &egui::Context, state: &mut State) {
    let dropped: Vec<PathBuf> =
        ctx.input(|input| input.raw.dropped_files.iter().map(|file| files::whole(file.path())).collect());
    if !dropped.is_empty() {
        state.file_flow.given = dropped;
    }
    if state.file_flow.has_question() {
        return;
    }
    let given = std::mem::take(&mut state.file_flow.given);
    let count = given.len();
    let Some(path) = given.into_iter().next() else { return };
    if state.file_flow.is_asking() {
        state.file_flow.dialog = None;
        state.gallery.end();
    }
    take_file(ctx, state, path.clone());
    // An error matters more. In a page, the files that come with one are those that it names.
    if count > 1 && !state.model.in_browser && !state.model.message.as_ref().is_some_and(Message::is_error) {
        state.model.say(Message::FirstOfDropped(path, count));
    }
}

/// Opens a dropped file: a figure, or a mesh, which is added to the scene. In place of the figure that the window
/// begins with, it's a scene of its own.
fn take_file(ctx: &egui::Context, state: &mut State, path: PathBuf) {
    let shown = &state.model.desk.shown;
    let has_origin = shown.path().is_some() || shown.shipped_name().is_some() || !shown.source().is_empty();
    let is_begun = has_origin || state.model.is_unsaved() || state.model.in_browser;
    if !files::has_ending(&path, MESH_ENDINGS) || !is_begun {
        return begin(ctx, state, Intent::OpenPath(path));
    }
    let is_this = |shape: &Shape| matches!(shape, Shape::Mesh { path: named } if Path::new(named).file_name() == path.file_name());
    let mut shapes = state.model.desk.shown.figure().scene.objects.iter().filter_map(|object| object.shape.as_ref());
    if state.model.in_browser && shapes.any(is_this) {
        // The scene names it, but hasn't been able to read it so far.
        return state.model.scene_cache.read_again();
    }
    mesh(&mut state.model, MeshFor::New, &path);
    state.model.settings.tab = Tab::Scene;
}

/// Reports finished exports. A window that waits for them closes with the last one, unless one has failed, because the
/// user wouldn't see that.
fn take_exports(ctx: &egui::Context, model: &mut Model, file_flow: &mut FileFlow) {
    let mut failed = false;
    for (path, result) in file_flow.exported() {
        let message = match result {
            Ok(shortfalls) if shortfalls.is_empty() => {
                say_saved(model, path);
                continue;
            }
            Ok(shortfalls) => Message::SavedOtherwise(path, shortfalls),
            Err(error) => {
                failed |= !matches!(error, ExportError::Cancelled);
                Message::NotExported(path, NotExported(error))
            }
        };
        model.say(message);
    }
    if file_flow.dialog == Some(Dialog::Closing) && (failed || file_flow.exporting.is_empty()) {
        file_flow.dialog = None;
        if !failed {
            close(ctx, file_flow);
        }
    }
}

#[cfg(test)]
mod tests;
