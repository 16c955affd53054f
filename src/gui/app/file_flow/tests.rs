#![expect(clippy::expect_used, reason = "a test may fail by panicking")]

use std::sync::Mutex;
use std::time::Instant;

use super::*;
use crate::gui::export::{Export, Exported};
use crate::progress::Progress;
use crate::testing::{Directory, Stall};
use camera_lab_words::Lang;

/// The window while `make` writes a picture, and frames of it.
fn exporting<W: AsyncFnMut(Task, &Progress) -> Exported + 'static>(make: fn() -> W) -> (egui::Context, State) {
    let (ctx, mut state) = (egui::Context::default(), State::new(crate::gui::Start::default()).expect("a camera"));
    let export = Export::new([[4, 3]; 3], 1.0);
    let (what, to) = (ExportKind::Pictures(export), (PathBuf::from("a.png"), Overwrite::Writable));
    let task = Task::new(&state.model, &state.family, what, to);
    let exporting = Exporting::with(&ctx, task, make);
    state.file_flow.exporting.push(exporting);
    (ctx, state)
}

/// One frame, in which the window's close button is pressed or not. Returns the requests to the system.
fn frame(ctx: &egui::Context, state: &mut State, close: bool) -> Vec<ViewportCommand> {
    let mut input = egui::RawInput::default();
    if close {
        let window = input.viewports.entry(egui::ViewportId::ROOT).or_default();
        window.events.push(egui::ViewportEvent::Close);
    }
    let mut output = ctx.run_ui(input, |ui| poll(ui.ctx(), state));
    output.textures_delta.clear();
    output.viewport_output[&egui::ViewportId::ROOT].commands.clone()
}

fn until_done(ctx: &egui::Context, state: &mut State) -> Vec<ViewportCommand> {
    let since = Instant::now();
    let mut commands = Vec::new();
    while !state.file_flow.exporting.is_empty() {
        assert!(since.elapsed().as_secs() < 60);
        std::thread::sleep(Duration::from_millis(5));
        commands.extend(frame(ctx, state, false));
    }
    commands
}

#[test]
fn a_panic_while_writing_a_picture_is_not_reported_as_lack_of_memory() {
    let (ctx, mut state) = exporting(|| async |_, _: &Progress| panic!("as a fault would"));
    until_done(&ctx, &mut state);
    let message = state.model.message.expect("said");
    let text = message.text(Lang::En);
    assert!(message.is_error() && text.contains("bug in this program") && text.contains("a.png"));
}

#[test]
fn the_answer_of_a_dialog_belongs_to_the_figure_it_was_asked_for() {
    let (ctx, mut state) = (egui::Context::default(), State::new(crate::gui::Start::default()).expect("a camera"));
    let folder = std::env::temp_dir().join(format!("camera-lab-answer-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join("copy.toml");
    for is_same in [false, true] {
        // The user has already been asked for the title of the figure.
        state.file_flow.titled = Some(state.model.desk.shown.id());
        ask(&ctx, &mut state, Purpose::Save);
        assert!(state.file_flow.is_asking());
        if !is_same {
            open_shipped(&mut state.model, &mut state.learn, "house");
        }
        answered(&ctx, &mut state, FileAnswer::Chosen(path.clone()));
        assert!(!state.file_flow.is_asking());
        assert_eq!((path.exists(), state.model.desk.shown.path().is_some()), (is_same, is_same));
        assert_eq!(matches!(state.model.message, Some(Message::OtherFigure(_))), !is_same);
    }
    // If the system has no dialogs now, the next question still tries them.
    ask(&ctx, &mut state, Purpose::Open);
    answered(&ctx, &mut state, FileAnswer::Unavailable);
    assert!(matches!(state.file_flow.dialog, Some(Dialog::Path(Purpose::Open, _))) && state.file_flow.native);
    std::fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn a_latex_picture_replaces_the_pdf_beside_it_only_after_a_question() {
    let (ctx, mut state) = (egui::Context::default(), State::new(crate::gui::Start::default()).expect("a camera"));
    let folder = std::env::temp_dir().join(format!("camera-lab-beside-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let beside = folder.join("my-fig-art.pdf");
    std::fs::write(&beside, "precious").expect("written");
    let export = Export { format: PictureFormat::Tex, ..Export::new([[4, 3]; 3], 1.0) };
    chosen(&ctx, &mut state, Purpose::Export(export), folder.join("my fig.tex"));
    let Some(Dialog::Overwrite(purpose, path)) = &state.file_flow.dialog else { panic!("a question") };
    assert_eq!(replaced(purpose, path), [beside]);
    assert!(state.file_flow.exporting.is_empty());
    std::fs::remove_dir_all(folder).expect("removed");
}

#[test]
fn a_window_that_is_closed_waits_for_its_pictures() {
    static HELD: Mutex<()> = Mutex::new(());
    fn make() -> impl AsyncFnMut(Task, &Progress) -> Exported {
        async |_, _: &Progress| {
            let _wait = HELD.lock();
            Ok(Vec::new())
        }
    }
    let held = HELD.lock();
    let (ctx, mut state) = exporting(make);
    assert!(frame(&ctx, &mut state, true).contains(&ViewportCommand::CancelClose));
    assert_eq!(state.file_flow.dialog, Some(Dialog::Closing));
    assert!(!frame(&ctx, &mut state, false).contains(&ViewportCommand::Close));
    drop(held);
    assert!(until_done(&ctx, &mut state).contains(&ViewportCommand::Close));
    assert_eq!(state.file_flow.dialog, None);
    assert!(!frame(&ctx, &mut state, true).contains(&ViewportCommand::CancelClose));

    // A failed one is reported, and the window stays.
    let (ctx, mut state) = exporting(|| async |_, _: &Progress| Err(ExportError::Panic));
    meet(&ctx, &mut state, Need::Do(Intent::Quit));
    assert!(!until_done(&ctx, &mut state).contains(&ViewportCommand::Close));
    assert!(state.model.message.is_some_and(|message| message.is_error()) && state.file_flow.dialog.is_none());
}

fn new_state() -> (egui::Context, State) {
    let mut state = State::new(crate::gui::Start::default()).expect("a camera");
    (state.file_flow.saving.patience, state.file_flow.native) = (Duration::ZERO, false);
    (egui::Context::default(), state)
}

/// Frames until nothing is being written.
fn finish(ctx: &egui::Context, state: &mut State) {
    let begin = Instant::now();
    while state.file_flow.saving.count() > 0 {
        assert!(begin.elapsed() < Duration::from_secs(60));
        std::thread::sleep(Duration::from_millis(5));
        ctx.run_ui(egui::RawInput::default(), |ui| poll(ui.ctx(), state)).textures_delta.clear();
    }
}

#[test]
fn changes_made_while_a_disk_stalls_are_not_taken_for_saved() {
    let directory = Directory::new("saving");
    let (ctx, mut state) = new_state();
    let [path, other] = ["slow.toml", "other.toml"].map(|name| directory.path().join(name));
    let stall = Stall::of(&path);
    let start = Instant::now();
    state.model.desk.shown.edit(|figure| figure.image.width = 300);
    confirmed_save(&ctx, &mut state, &path);
    assert!(start.elapsed() < Duration::from_secs(5) && state.file_flow.saving.writes(&path));
    state.model.desk.shown.edit(|figure| figure.image.width = 301);
    drop(stall);
    finish(&ctx, &mut state);
    assert_eq!(state.model.desk.shown.path(), Some(&path));
    assert_eq!(files::open_figure(&path).expect("a figure").figure.image.width, 300);
    assert!(state.model.desk.shown.is_changed() && state.model.desk.shown.figure().image.width == 301);
    // A second one would overtake the first, so it waits.
    let stall = Stall::of(&path);
    confirmed_save(&ctx, &mut state, &path);
    state.model.desk.shown.edit(|figure| figure.image.width = 302);
    confirmed_save(&ctx, &mut state, &path);
    assert_eq!(state.file_flow.saving.count(), 1);
    drop(stall);
    finish(&ctx, &mut state);
    assert_eq!(files::open_figure(&path).expect("a figure").figure.image.width, 302);
    assert!(!state.model.desk.shown.is_changed());
    // While it stalls again, the figure is saved elsewhere, and that's its file from then on.
    let stall = Stall::of(&path);
    confirmed_save(&ctx, &mut state, &path);
    state.file_flow.saving.patience = Duration::from_secs(60);
    confirmed_save(&ctx, &mut state, &other);
    assert_eq!(state.model.desk.shown.path(), Some(&other));
    drop(stall);
    finish(&ctx, &mut state);
    assert_eq!(state.model.desk.shown.path(), Some(&other));
    assert_eq!(files::open_figure(&path).expect("a figure").figure.image.width, 302);
}

/// Saves into a new file.
fn confirmed_save(ctx: &egui::Context, state: &mut State, path: &Path) {
    confirmed(ctx, state, Purpose::Save, path, Agreed::default());
}

#[test]
fn changes_made_while_the_last_save_runs_are_asked_about_before_the_window_closes() {
    let directory = Directory::new("closing");
    let (ctx, mut state) = new_state();
    let path = directory.path().join("slow.toml");
    let stall = Stall::of(&path);
    state.model.desk.shown.edit(|figure| figure.image.width = 300);
    begin(&ctx, &mut state, Intent::Quit);
    assert_eq!(state.file_flow.dialog.take(), Some(Dialog::Unsaved));
    confirmed_save(&ctx, &mut state, &path);
    assert!(state.is_closing() && !state.file_flow.may_close);
    state.model.desk.shown.edit(|figure| figure.image.width = 301);
    drop(stall);
    finish(&ctx, &mut state);
    assert_eq!((&state.file_flow.dialog, state.model.desk.errand()), (&Some(Dialog::Unsaved), Some(&Intent::Quit)));
    assert!(!state.file_flow.may_close);
}

#[test]
fn a_stalled_name_is_asked_about_as_if_it_were_there() {
    let directory = Directory::new("stalled-name");
    let path = directory.path().join("slow.toml");
    let stall = Stall::of(&path);
    std::thread::spawn({
        let path = path.clone();
        move || {
            files::limit_waiting(Duration::from_millis(100));
            let (ctx, mut state) = new_state();
            chosen(&ctx, &mut state, Purpose::Save, path.clone());
            assert_eq!(state.file_flow.dialog, Some(Dialog::Overwrite(Purpose::Save, path)));
        }
    })
    .join()
    .expect("no panic");
    drop(stall);
}

/// Does something on a thread that waits for files as the window's does, but not as long.
fn as_the_window(work: impl FnOnce() + Send + 'static) {
    let work = || {
        files::limit_waiting(Duration::from_millis(100));
        work();
    };
    std::thread::spawn(work).join().expect("no panic");
}

/// The words of the last message, which must be an error.
fn last_error(state: &State) -> String {
    let message = state.model.message.as_ref().expect("a message");
    assert!(message.is_error());
    message.text(Lang::En)
}

#[test]
fn a_stalled_lesson_keeps_its_steps_and_the_text_you_type() {
    let directory = Directory::new("stalled-lesson");
    let path = directory.path().join("mine.toml");
    as_the_window(move || {
        let (_, mut state) = new_state();
        let State { model, learn, .. } = &mut state;
        learn.add_step(model, &path, Overwrite::Writable);
        let before = std::fs::read_to_string(&path).expect("a lesson");
        let stall = Stall::of(&path);
        learn.add_step(model, &path, Overwrite::Writable);
        assert!(last_error(&state).contains("mine.toml"), "recording");
        drop(stall);
        assert_eq!(std::fs::read_to_string(&path).expect("a lesson"), before);

        let State { model, learn, .. } = &mut state;
        let begin = Instant::now();
        let lesson = loop {
            // The work that stalled may still be about to end.
            match files::read_lesson(&path) {
                Ok((lesson, _)) => break lesson,
                Err(error) => assert!(begin.elapsed() < Duration::from_secs(60), "{error}"),
            }
        };
        let open = crate::lessons::OpenLesson { lesson: lesson.into(), path: Some(path.clone()), step: 0 };
        learn.play(model, open);
        learn.write_lesson(model);
        let writing = learn.lesson.as_mut().and_then(|playing| playing.writing.as_mut());
        writing.expect("a lesson of one's own").typed.words[0].en.push_str(" typed");
        learn.text_edited(0.0);
        let stall = Stall::of(&path);
        assert!(!learn.save_text(model));
        assert!(last_error(&state).contains("mine.toml"), "writing");
        drop(stall);
        let State { model, learn, .. } = &mut state;
        let begin = Instant::now();
        while !learn.save_text(model) {
            assert!(begin.elapsed() < Duration::from_secs(60));
            std::thread::sleep(Duration::from_millis(5));
        }
        assert!(std::fs::read_to_string(&path).expect("a lesson").contains(" typed"));
    });
}
