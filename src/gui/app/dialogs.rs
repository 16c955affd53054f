//! The questions in the window.

#[cfg(target_arch = "wasm32")]
use crate::gui::app::web::third_party;
use std::path::{Path, PathBuf};

use eframe::egui::{self, Id, Key, Modal, RichText};

use super::command::{MENUS, keys_pdf};
use super::{menu, search};
use crate::gui::app::file_flow::file_kind::FileKind;
use crate::gui::app::file_flow::questions::{Agreed, Changed, Dialog, DialogKind, FileFlow, Purpose};
use crate::gui::app::file_flow::title_dialog::{self, Answer};
use crate::gui::app::file_flow::{self, link_dialog, qr};
use crate::gui::app::state::State;
use crate::gui::export::export_dialog::{self, Choices};
use crate::gui::gallery::{self, Chosen};
use crate::gui::inspector::{coach, compare_dialog, scene};
use crate::gui::kit::{CANCEL, Command, Explained, Pressed, TextField, buttons, complaint, text_field, theme, written};
use crate::gui::learn::{Learn, handout, lesson};
use crate::gui::platform::native::Wanted;
use crate::sanitize;
use crate::scene::edit::Children;
use camera_lab_desk::desk::Reply;
use camera_lab_desk::{FileFor, Intent, LineComparison, LineOrigin, Message, Model, Source};
use camera_lab_words::class::{self, ClassReport};
use camera_lab_words::learn::{exercise_window, lessons};
use camera_lab_words::window::{self, Texts, canvas, gallery as gallery_words, scenes, sharing};

/// Shows the open question, if any, and acts on the answer. Returns a command to perform.
pub fn show(ctx: &egui::Context, state: &mut State) -> Option<Command> {
    if state.file_flow.waits_for_system() {
        wait_for_system(ctx, &state.model, &mut state.file_flow);
        return None;
    }
    let shown = Id::unique("dialog shown");
    let Some(dialog) = state.file_flow.dialog.take() else {
        ctx.data_mut(|data| data.remove::<Option<DialogKind>>(shown));
        (state.file_flow.preview, state.file_flow.pages) = (None, None);
        return None;
    };
    let kind = Some(dialog.kind());
    let first = ctx.data_mut(|data| data.get_temp(shown)) != Some(kind);
    ctx.data_mut(|data| data.insert_temp(shown, kind));
    let dialog = if first { state.file_flow.reopened(dialog) } else { dialog };
    let t = window::texts(state.model.settings.lang);
    match dialog {
        Dialog::Qr => {
            if qr::show(ctx, &state.model, &state.learn, &mut state.sharing, first) {
                state.file_flow.show(Dialog::Qr);
            }
            return None;
        }
        Dialog::Compare(form) => {
            let draws = state.annotations.any();
            let stays = compare_dialog::show(ctx, t, &mut state.model, form, draws);
            // A command may have opened another one in between.
            if state.file_flow.dialog.is_none() {
                state.file_flow.dialog = stays.map(Dialog::Compare);
            }
            return None;
        }
        _ => {}
    }
    // Handouts are kept for the next one. Other answers are given once.
    let is_answered_once = (!matches!(dialog, Dialog::Handout(_))).then(|| dialog.clone());
    let mut wanted = None;
    let frame = egui::Frame::popup(&ctx.global_style()).inner_margin(14.0);
    let modal = Modal::new(Id::unique("dialog").with(kind)).frame(frame).show(ctx, |ui| {
        ui.set_width(width(&dialog).min(ui.ctx().content_rect().width() - 40.0));
        wanted = body(ui, t, state, dialog, first);
    });
    match (&state.file_flow.dialog, is_answered_once) {
        (Some(_), _) => state.file_flow.keep_form(),
        (None, Some(answered)) => state.file_flow.forget_form(&answered),
        (None, None) => {}
    }
    let is_form = state.file_flow.dialog.as_ref().is_some_and(Dialog::is_form);
    if !(is_form && modal.backdrop_response.clicked()) && modal.should_close() {
        state.gallery.end();
        if let Some(Dialog::Export(left)) = state.file_flow.dialog.take() {
            state.export = left;
            state.family.leave();
        }
    }
    if state.file_flow.dialog.is_none() && state.file_flow.covered.is_some() {
        // It comes back in the next frame.
        ctx.request_repaint();
    }
    if !matches!(state.file_flow.dialog, Some(Dialog::Export(_))) {
        state.file_flow.preview = None;
    }
    wanted
}

const fn width(dialog: &Dialog) -> f32 {
    match dialog {
        Dialog::Help
        | Dialog::Class(_)
        | Dialog::Delete { .. }
        | Dialog::DeleteProgress
        | Dialog::Link
        | Dialog::Title(_) => 520.0,
        Dialog::Changed(Changed { comparison: Some(_), .. }) => 760.0,
        // The lines of the licences.
        Dialog::About => 810.0,
        Dialog::Gallery => 1110.0,
        Dialog::Lessons => lesson::LIST_WIDTH,
        Dialog::Coach => coach::WIDTH,
        Dialog::Search => search::WIDTH,
        Dialog::Export(_) => export_dialog::WIDTH,
        Dialog::Handout(_) => handout::dialog::WIDTH,
        Dialog::Changed(_) => 480.0,
        Dialog::Unsaved
        | Dialog::UnsavedText
        | Dialog::Path(..)
        | Dialog::Overwrite(..)
        | Dialog::ReadOnly(..)
        | Dialog::Closing
        | Dialog::Qr
        | Dialog::Compare(_) => 380.0,
    }
}

/// The content of a dialog. One that stays open goes back into `file_flow`.
fn body(ui: &mut egui::Ui, t: &'static Texts, state: &mut State, dialog: Dialog, first: bool) -> Option<Command> {
    let ctx = &ui.ctx().clone();
    if let Some(question) = Question::of(&dialog, t, &state.model, &state.learn, state.file_flow.refused.as_ref()) {
        match question.show(ui, t, first) {
            Pressed::Action(button) => answer(ctx, state, dialog, button),
            Pressed::Cancel => {}
            Pressed::Nothing => state.file_flow.dialog = Some(dialog),
        }
        return None;
    }
    let stays = match dialog {
        Dialog::Path(purpose, path) => {
            ask_path(ui, t, state, purpose, path, first);
            None
        }
        Dialog::Title(form) => {
            match title_dialog::show(ui, t, state, form, first) {
                Some(Answer::Save(purpose, path)) => choose_typed(ctx, state, purpose, path),
                Some(Answer::Choose(purpose)) => file_flow::ask(ctx, state, purpose),
                None => {}
            }
            None
        }
        Dialog::Export(mut export) => {
            let State { model, family, export: last, file_flow, .. } = &mut *state;
            let mut choices = Choices { family, last, preview: &mut file_flow.preview };
            let pressed = export_dialog::show(ui, t, model, &mut choices, &mut export, first);
            asked_file(ctx, state, pressed, Purpose::Export(export), Dialog::Export(export))
        }
        Dialog::Handout(mut form) => {
            let State { model, learn, file_flow, .. } = &mut *state;
            let pressed = handout::dialog::show(ui, model, learn, &mut file_flow.pages, &mut form, first);
            learn.ticks = form.ticks();
            asked_file(ctx, state, pressed, Purpose::Handout(form.clone()), Dialog::Handout(form))
        }
        Dialog::Lessons => lesson::list(ui, &mut state.model, &state.learn, first).then_some(Dialog::Lessons),
        Dialog::Class(report) => {
            let purpose = Purpose::For(FileFor::ClassReport(report.clone()));
            let pressed = class_report(ui, t, &report, first);
            asked_file(ctx, state, pressed, purpose, Dialog::Class(report))
        }
        Dialog::Help => {
            let pressed = help(ui, t, &state.model, first);
            let page = matches!(pressed, Pressed::Action(_)).then(|| keys_pdf(&state.model, state.model.settings.lang));
            asked_file(
                ctx,
                state,
                pressed,
                Purpose::For(FileFor::Keys(page.flatten().unwrap_or_default())),
                Dialog::Help,
            )
        }
        Dialog::About => about(ui, t, &state.sharing.address(), first).then_some(Dialog::About),
        Dialog::Link => {
            let State { model, learn, sharing, file_flow, .. } = &mut *state;
            link_dialog::show(ui, t, model, learn, (sharing, file_flow.refused.as_ref()), first)
        }
        Dialog::Coach => coach::show(ui, t, &mut state.model, first).then_some(Dialog::Coach),
        Dialog::Search => return search::show(ui, state, first),
        Dialog::Gallery => show_gallery(ui, state, first),
        // They're questions, or have a window of their own.
        _ => None,
    };
    // An answer may have opened another one.
    state.file_flow.dialog = state.file_flow.dialog.take().or(stays);
    None
}

/// The report on a class.
fn class_report(ui: &mut egui::Ui, t: &Texts, report: &ClassReport, first: bool) -> Pressed {
    let words = class::texts(t.lang);
    ui.heading(words.report);
    let height = (ui.ctx().content_rect().height() - 160.0).clamp(120.0, 560.0);
    egui::ScrollArea::vertical().max_height(height).show(ui, |ui| {
        for (heading, lines) in report.sections(t.lang) {
            ui.add_space(6.0);
            ui.label(RichText::new(heading).font(theme::bold(12.5)));
            lines.iter().for_each(|line| crate::gui::kit::prose::show(ui, line));
        }
    });
    ui.add_space(10.0);
    buttons(ui, t.cancel, &[words.save], first.then_some(0))
}

/// Asks for the file of a form. Returns the form if it stays.
fn asked_file(
    ctx: &egui::Context,
    state: &mut State,
    pressed: Pressed,
    purpose: Purpose,
    form: Dialog,
) -> Option<Dialog> {
    match pressed {
        Pressed::Action(_) => file_flow::ask(ctx, state, purpose),
        Pressed::Nothing => return Some(form),
        Pressed::Cancel => {}
    }
    None
}

/// The figures that one can begin with. Returns the dialog if it stays.
fn show_gallery(ui: &mut egui::Ui, state: &mut State, first: bool) -> Option<Dialog> {
    if first {
        let beside = state.model.desk.shown.folder().map(Path::to_owned);
        let here = Source::of(&state.model.desk.shown);
        state.gallery.begin(&state.recent.files, beside.as_deref(), here.as_ref());
    }
    let style = (state.model.settings.theme, state.model.settings.lang);
    let Some(chosen) = gallery::show(ui, &mut state.gallery, style, first) else { return Some(Dialog::Gallery) };
    let next = match chosen {
        Chosen::Nothing => None,
        Chosen::Folder => {
            // It stays unless the system has no dialogs.
            file_flow::ask(ui.ctx(), state, Purpose::Folder);
            return Some(Dialog::Gallery);
        }
        Chosen::Open(Source::Shipped(name)) => Some(Intent::Shipped(name)),
        Chosen::Open(Source::File(path)) => Some(Intent::OpenPath(path)),
    };
    state.gallery.end();
    next.into_iter().for_each(|next| file_flow::begin(ui.ctx(), state, next));
    None
}

/// A question without fields: a title, a text, and buttons.
struct Question {
    title: String,
    text: String,
    /// The reason why the question arises, if there is a fault.
    fault: Option<String>,
    comparison: Option<LineComparison>,
    buttons: Vec<&'static str>,
    /// The button that Enter presses. The choice that loses nothing.
    default: usize,
}

impl Question {
    /// The question of a dialog, unless it has fields.
    fn of(dialog: &Dialog, t: &'static Texts, model: &Model, learn: &Learn, refused: Option<&Message>) -> Option<Self> {
        let lang = model.settings.lang;
        let asked = |title: &str, text: String, buttons: Vec<&'static str>| Self {
            title: title.to_owned(),
            text,
            fault: None,
            comparison: None,
            buttons,
            default: CANCEL,
        };
        Some(match dialog {
            Dialog::Unsaved => {
                let text = format!("{} {}", t.unsaved_text, model.figure_name());
                Self { default: 1, ..asked(t.unsaved_title, text, vec![t.dont_save, t.save_first]) }
            }
            Dialog::UnsavedText => {
                let words = lessons::texts(lang);
                let mut buttons = vec![t.dont_save];
                buttons.extend(learn.has_good_text().then_some(words.save_copy));
                let fault = refused.map(|why| why.text(lang));
                Self { fault, ..asked(words.unsaved_text_title, words.unsaved_text.to_owned(), buttons) }
            }
            Dialog::Overwrite(purpose, path) => {
                let replaced = file_flow::replaced(purpose, path);
                let names: Vec<String> = replaced.iter().map(|path| sanitize::path(path)).collect();
                let text = if names.len() > 1 { t.overwrite_several } else { t.overwrite_text };
                asked(t.overwrite_title, format!("{} {text}", names.join(", ")), vec![t.replace])
            }
            Dialog::Changed(Changed { theirs, comparison, .. }) => {
                let name = model.desk.shown.path().map(|path| sanitize::path(path)).unwrap_or_default();
                let offers = comparison.is_none() && theirs.is_some();
                let buttons = offers.then_some(t.compare).into_iter().chain([t.replace, t.save_as]).collect();
                let text = format!("{name} {}", t.changed_text);
                Self { comparison: comparison.clone(), ..asked(t.changed_title, text, buttons) }
            }
            Dialog::ReadOnly(_, path, _) => {
                let text = format!("{} {}", sanitize::path(path), t.read_only_text);
                asked(t.read_only_title, text, vec![t.replace, t.save_as])
            }
            Dialog::Closing => asked(t.closing_title, t.closing_text.to_owned(), vec![t.close_now]),
            Dialog::Delete { names, below } => {
                let words = scenes::texts(lang);
                let listed = names.iter().map(|name| sanitize::escaped(name)).collect::<Vec<_>>().join(", ");
                let title = format!("{} {}", words.delete, sanitize::within(&listed, 120));
                let text = format!("{} {below}", words.delete_question);
                asked(&title, text, vec![words.delete_alone, words.delete_all])
            }
            Dialog::DeleteProgress => {
                let words = exercise_window::texts(lang);
                asked(words.delete_progress, words.delete_progress_text.to_owned(), vec![words.delete_progress])
            }
            _ => return None,
        })
    }

    fn show(&self, ui: &mut egui::Ui, t: &Texts, first: bool) -> Pressed {
        text(ui, &self.title, &self.text);
        if let Some(fault) = &self.fault {
            complaint(ui, fault);
            ui.add_space(10.0);
        }
        if let Some(comparison) = &self.comparison {
            compared(ui, t, comparison);
        }
        buttons(ui, t.cancel, &self.buttons, first.then_some(self.default))
    }
}

/// Acts on the pressed button of a question, from 0.
fn answer(ctx: &egui::Context, state: &mut State, dialog: Dialog, button: usize) {
    match (dialog, button) {
        (Dialog::Unsaved | Dialog::UnsavedText, 1) => file_flow::reply(ctx, state, Reply::Save),
        (Dialog::Unsaved, _) => file_flow::reply(ctx, state, Reply::GiveUp),
        (Dialog::UnsavedText, _) => {
            state.learn.forget_text();
            file_flow::go_on(ctx, state);
        }
        (Dialog::Overwrite(purpose, path), _) => file_flow::confirmed(ctx, state, purpose, &path, Agreed::default()),
        (Dialog::Changed(changed), button) => answer_changed(ctx, state, changed, button),
        (Dialog::ReadOnly(purpose, path, agreed), 0) => {
            file_flow::confirmed(ctx, state, purpose, &path, Agreed { read_only: true, ..agreed });
        }
        (Dialog::ReadOnly(purpose, ..), _) => file_flow::ask(ctx, state, purpose),
        (Dialog::Closing, _) => file_flow::close(ctx, &mut state.file_flow),
        (Dialog::Delete { names, .. }, button) => {
            let children = if button == 0 { Children::HungHigher } else { Children::Removed };
            scene::remove(&mut state.model, &names, children);
        }
        (Dialog::DeleteProgress, _) if state.learn.exercises.file.is_some() => state.learn.exercises.forgets = true,
        (Dialog::DeleteProgress, _) => state.learn.exercises.forget(),
        // It asks no question.
        (dialog, _) => state.file_flow.dialog = Some(dialog),
    }
}

/// Acts on the answer about a file changed by another program. The comparison, if it's offered, is the first button.
fn answer_changed(ctx: &egui::Context, state: &mut State, mut changed: Changed, button: usize) {
    let offers = usize::from(changed.comparison.is_none() && changed.theirs.is_some());
    match (button + 1).checked_sub(offers) {
        Some(0) => {
            let theirs = String::from_utf8_lossy(changed.theirs.as_deref().unwrap_or_default()).into_owned();
            changed.comparison = Some(LineComparison::new(&theirs, &file_flow::text_to_save(&state.model)));
            state.file_flow.dialog = Some(Dialog::Changed(changed));
        }
        Some(1) => {
            if let Some(path) = state.model.desk.shown.path().cloned() {
                let agreed = Agreed { theirs: Some(changed.theirs), ..Agreed::default() };
                file_flow::confirmed(ctx, state, Purpose::Save, &path, agreed);
            }
        }
        _ => file_flow::ask(ctx, state, Purpose::Save),
    }
}

/// Locks the window while a system dialog is open, because its answer belongs to the document shown now.
fn wait_for_system(ctx: &egui::Context, model: &Model, file_flow: &mut FileFlow) {
    let t = window::texts(model.settings.lang);
    Modal::new(Id::unique("dialog of the system")).show(ctx, |ui| {
        ui.set_width(380.0);
        text(ui, t.choosing_title, t.choosing_text);
        // A system that doesn't answer must not keep the window for ever.
        if matches!(buttons(ui, t.cancel, &[], None), Pressed::Cancel) {
            file_flow.asking = None;
        }
    });
}

fn text(ui: &mut egui::Ui, title: &str, text: &str) {
    ui.heading(title);
    ui.add_space(6.0);
    ui.label(text);
    ui.add_space(10.0);
}

/// The differing lines: those of the file with −, those of the window with +.
fn compared(ui: &mut egui::Ui, t: &Texts, comparison: &LineComparison) {
    let visuals = ui.visuals().clone();
    ui.label(RichText::new(t.compare_file).monospace().color(visuals.error_fg_color));
    ui.label(RichText::new(t.compare_mine).monospace().color(visuals.hyperlink_color));
    ui.add_space(4.0);
    if comparison.lines.is_empty() {
        ui.label(t.compare_equal);
    }
    let height = (ui.ctx().content_rect().height() - 280.0).max(80.0);
    let line = ui.text_style_height(&egui::TextStyle::Monospace);
    ui.spacing_mut().item_spacing.y = 1.0;
    // At its final height at once, as in the help.
    let area = egui::ScrollArea::both().max_height(height).min_scrolled_height(height).auto_shrink([false, true]);
    area.show_rows(ui, line, comparison.lines.len(), |ui, rows| {
        for (whose, text) in comparison.lines.get(rows).unwrap_or_default() {
            let (sign, color) = match whose {
                LineOrigin::Both => (" ", visuals.text_color()),
                LineOrigin::Theirs => ("−", visuals.error_fg_color),
                LineOrigin::Mine => ("+", visuals.hyperlink_color),
                LineOrigin::Gap => ("⋯", visuals.weak_text_color()),
            };
            let line = RichText::new(format!("{sign} {text}")).monospace().color(color);
            ui.add(egui::Label::new(line).extend());
        }
    });
    ui.add_space(10.0);
}

fn ask_path(ui: &mut egui::Ui, t: &'static Texts, state: &mut State, purpose: Purpose, mut path: String, first: bool) {
    let kind = FileKind::of(state, &purpose);
    ui.heading(kind.title);
    ui.add_space(6.0);
    let words = sharing::texts(state.model.settings.lang);
    let (which, hint) = match (kind.wanted == Wanted::Folder, state.model.in_browser) {
        (true, _) => (gallery_words::texts(state.model.settings.lang).which_folder, t.path_hint),
        (false, true) => (words.name_text, words.name_hint),
        (false, false) => (t.path_text, t.path_hint),
    };
    ui.label(which);
    let field = TextField::line(&mut path, crate::limits::MAX_TYPED);
    let field = field.with(|edit| edit.desired_width(f32::INFINITY).hint_text(hint));
    let response = field.show(ui, state.model.settings.lang).accessible_name(t.path_name);
    if first {
        response.request_focus();
        // What is opened has a name of its own, so a typed path replaces all.
        let begins_new = kind.wanted == Wanted::NewFile;
        let (begin, end) = if begins_new { stem(&path) } else { (0, path.chars().count()) };
        text_field::select(ui.ctx(), response.id, begin..end);
    }
    let enter = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    if let Some(error) = &state.file_flow.refused {
        complaint(ui, &error.text(state.model.settings.lang));
    }
    ui.add_space(10.0);
    let pressed = buttons(ui, t.cancel, &[kind.action], None);
    let go = (enter || matches!(pressed, Pressed::Action(_))) && !path.trim().is_empty();
    if matches!(pressed, Pressed::Cancel) {
        return;
    }
    if !go {
        state.file_flow.dialog = Some(Dialog::Path(purpose, path));
        return;
    }
    choose_typed(ui.ctx(), state, purpose, path);
    if state.file_flow.refused.is_some() {
        response.request_focus();
    }
}

/// Goes on with a typed path. Shows errors below the path, and only there.
fn choose_typed(ctx: &egui::Context, state: &mut State, purpose: Purpose, path: String) {
    (state.model.message, state.file_flow.refused) = (None, None);
    file_flow::chosen(ctx, state, purpose.clone(), PathBuf::from(path.trim()));
    if state.file_flow.dialog.is_none() && state.model.message.as_ref().is_some_and(|message| message.is_error()) {
        state.file_flow.refused = state.model.message.take();
        state.file_flow.dialog = Some(Dialog::Path(purpose, path));
    }
}

/// The place of the name in a proposed path, in characters, without its folder and its ending, so that typing replaces
/// it.
fn stem(path: &str) -> (usize, usize) {
    let begin = path.rfind(['/', '\\']).map_or(0, |at| at + 1);
    let end = path[begin..].rfind('.').map_or(path.len(), |at| begin + at);
    (path[..begin].chars().count(), path[..end].chars().count())
}

/// Help on mouse and keyboard. False once it's closed.
fn help(ui: &mut egui::Ui, t: &'static Texts, model: &Model, first: bool) -> Pressed {
    let pictures = canvas::texts(model.settings.lang);
    let keys = [
        (t.show_world, pictures.keys_in_world),
        (t.show_canonical, pictures.keys_in_canonical),
        (t.show_image, pictures.keys_in_image),
    ];
    ui.heading(t.help);
    // At its final height from the first frame, because a dialog that grows moves its buttons away from the pointer.
    let height = (ui.ctx().content_rect().height() - 160.0).max(120.0);
    let area = egui::ScrollArea::vertical().max_height(height).min_scrolled_height(height).auto_shrink([false, true]);
    area.show(ui, |ui| {
        let title = |ui: &mut egui::Ui, text: &str| {
            ui.add_space(6.0);
            ui.label(RichText::new(text).font(theme::bold(12.5)));
        };
        title(ui, t.help_pictures);
        ui.label(t.help_pictures_text);
        ui.label(pictures.pointer_in_space);
        for (name, text) in keys {
            ui.label(format!("{name}: {text}"));
        }
        if model.in_browser {
            let words = sharing::texts(model.settings.lang);
            title(ui, words.help_touch);
            ui.label(words.help_touch_text);
        }
        title(ui, t.help_signs);
        let signs = menu::legend().map(|(sign, command)| format!("{sign} {}", command.label(t)));
        ui.label(signs.collect::<Vec<_>>().join(" · "));
        title(ui, t.help_numbers);
        ui.label(t.help_numbers_text);
        title(ui, t.help_commands);
        if model.in_browser {
            ui.label(sharing::texts(model.settings.lang).keys_of_browser);
        }
        ui.spacing_mut().interact_size.y = 0.0;
        egui::Grid::new("commands").num_columns(2).spacing([16.0, 2.0]).show(ui, |ui| {
            for command in MENUS.iter().flat_map(|menu| menu.groups(model)).flatten() {
                ui.monospace(
                    command
                        .keys(model)
                        .map(|keys| written(ui.ctx(), &keys, model.settings.lang))
                        .collect::<Vec<_>>()
                        .join(", "),
                );
                ui.label(command.label(t)).explained(command.hint(t));
                ui.end_row();
            }
        });
    });
    ui.add_space(8.0);
    buttons(ui, t.close, &[t.save_keys], first.then_some(CANCEL))
}

/// Names and licences of all libraries, and the texts of the licences, written by `.ci/third-party`.
#[cfg(not(target_arch = "wasm32"))]
#[expect(clippy::unnecessary_wraps, reason = "in a page the text arrives later")]
fn third_party(_: &egui::Context) -> Option<&'static str> {
    Some(include_str!("../../../THIRD-PARTY.md"))
}

/// The program: its version, its licence, and those of its components. They're built in, so a single copied file has
/// them too. Only in a browser they stand beside the program, in its page. `first` is true when it has just been
/// opened. False once it's closed.
fn about(ui: &mut egui::Ui, t: &Texts, page_address: &str, first: bool) -> bool {
    ui.heading(format!("Camera Lab {}", env!("CARGO_PKG_VERSION")));
    ui.add_space(6.0);
    ui.label(t.about_text);
    let [address, authors] = [env!("CARGO_PKG_REPOSITORY"), env!("CARGO_PKG_AUTHORS")];
    for line in [page_address, address, authors].into_iter().filter(|line| !line.is_empty()) {
        ui.label(sanitize::escaped(line));
    }
    ui.label(t.about_licence);
    ui.add_space(6.0);
    let height = (ui.ctx().content_rect().height() - 220.0).max(80.0);
    let lines: Vec<&str> =
        third_party(ui.ctx()).unwrap_or("…").lines().filter(|line| !line.starts_with("| ---")).collect();
    let row = ui.text_style_height(&egui::TextStyle::Small);
    // At its full height from the first frame, or the dialog would grow for some frames.
    let area = egui::ScrollArea::both().max_height(height).min_scrolled_height(height).auto_shrink(false);
    area.show_rows(ui, row, lines.len(), |ui, range| {
        ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
        // Every row has the height of its letters.
        ui.spacing_mut().interact_size.y = 0.0;
        for line in &lines[range] {
            // Headings are bold, and the cells of a table stand in columns.
            if let Some(heading) = line.strip_prefix('#') {
                ui.label(RichText::new(heading.trim_start_matches(['#', ' '])).font(theme::bold(10.0)));
            } else if let Some(row) = line.strip_prefix("| ").and_then(|row| row.strip_suffix(" |")) {
                let widths = [180.0, 90.0, 260.0];
                ui.horizontal(|ui| {
                    ui.spacing_mut().item_spacing.x = 0.0;
                    for (k, cell) in row.split(" | ").enumerate() {
                        let left = ui.cursor().left();
                        ui.label(RichText::new(cell).small());
                        if let Some(width) = widths.get(k) {
                            ui.add_space((left + width - ui.cursor().left()).max(6.0));
                        }
                    }
                });
            } else {
                let line = line.replace("](https://crates.io)", "").replace(" Do not edit this file.", "");
                ui.label(RichText::new(line.replace(['`', '<', '>', '['], "")).small());
            }
        }
    });
    ui.add_space(8.0);
    matches!(buttons(ui, t.close, &[], first.then_some(CANCEL)), Pressed::Nothing)
}
