//! The notes: a short text for each symbol, operation, equation, step and stage, found by words or by F1 on the item
//! itself.

use eframe::egui::{self, Button, Label, RichText, Role, ScrollArea, TextStyle, Ui, WidgetInfo, vec2};

use super::answer::{self, Writing};
use super::{ExplainedSetting, stages};
use crate::explain::{Axis, Component, Symbol};
use crate::gui::kit::{Explained, TextField, mathematics, theme};
use crate::gui::why::state::explain::Explain;
use crate::gui::why::state::notes::Notes;
use camera_lab_desk::Model;
use camera_lab_words::why::explain::Texts;
use camera_lab_words::why::notes::{self, Note, Piece};
use camera_lab_words::why::sources::with_titles;
use camera_lab_words::why::{explain as words, stages as stages_words};

/// The type size of equations, in points.
const SIZE: f32 = 14.0;
/// Greatest share of the list in the height.
const LIST: f32 = 0.36;

/// Shows the tab.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, explain: &mut Explain) {
    let t = words::texts(model.settings.lang);
    let height = (ui.ctx().content_rect().height() * LIST).max(96.0);
    search(ui, t, &mut explain.notes);
    ScrollArea::vertical().id_salt("list of notes").max_height(height).auto_shrink([false, true]).show(ui, |ui| {
        list(ui, t, &mut explain.notes);
    });
    ui.separator();
    let all = notes::notes(t.lang);
    let chosen = explain.notes.chosen;
    let Some(note) = notes::note(t.lang, chosen).or_else(|| all.first()) else { return };
    heading(ui, t, note, &mut explain.notes);
    for latex in &note.equations {
        ScrollArea::horizontal().id_salt(latex).show(ui, |ui| {
            mathematics::show(ui, latex, &notes::plain(latex), SIZE);
        });
    }
    for paragraph in &note.paragraphs {
        words_of(ui, "", paragraph, ui.visuals().text_color());
    }
    for erratum in &note.errata {
        words_of(ui, "≠ ", erratum, ui.visuals().warn_fg_color);
    }
    numbers(ui, model, note);
    links(ui, t, note, &mut explain.notes);
    if !note.source.is_empty() {
        // Other readers don't have the texts at hand, so one page describes them.
        if ui.link(RichText::new(note.source).small()).explained(with_titles(note.source)).clicked() {
            explain.notes.go_to(notes::SOURCES);
        }
    }
    if let Some(stage) = crate::pipeline::Stage::ALL.into_iter().find(|stage| notes::of_stage(*stage) == note.id) {
        stages::source(ui, stages_words::texts(t.lang), stage);
    }
}

/// The search field. Enter opens the first note found.
fn search(ui: &mut Ui, t: &Texts, state: &mut Notes) {
    let field = TextField::line(&mut state.wanted, crate::limits::MAX_TYPED_NAME);
    let field = field.with(|edit| edit.hint_text(t.search_notes).desired_width(f32::INFINITY));
    let response = field.show(ui, t.lang).explained(t.search_notes_hint).accessible_name(t.search_notes);
    if response.lost_focus()
        && ui.input(|input| input.key_pressed(egui::Key::Enter))
        && let Some(first) = found(t, &state.wanted).first()
    {
        state.read(first.id);
        state.wants_focus = true;
    }
}

/// The notes that contain all the words. Those with the words in the heading come first.
fn found(t: &Texts, wanted: &str) -> Vec<&'static Note> {
    let mut found: Vec<_> = notes::notes(t.lang).iter().filter(|note| note.says(wanted)).collect();
    found.sort_by_key(|note| !note.is_headed(wanted));
    found
}

/// The headings of the notes found, or of all notes, by groups.
fn list(ui: &mut Ui, t: &Texts, state: &mut Notes) {
    let found = found(t, &state.wanted);
    if found.is_empty() {
        ui.label(t.no_note);
    }
    let grouped = state.wanted.trim().is_empty();
    let mut group = "";
    // The displayed note follows the keyboard, unless the keyboard is to follow the note.
    let follows = !state.wants_focus;
    ui.spacing_mut().item_spacing.y = 1.0;
    for note in found {
        if grouped && note.group != group {
            group = note.group;
            ui.label(RichText::new(group).small().strong());
        }
        let chosen = state.chosen == note.id;
        let button = Button::selectable(chosen, theme::symbol(ui, note.title)).truncate();
        let response = ui.with_layout(egui::Layout::top_down_justified(egui::Align::LEFT), |ui| ui.add(button)).inner;
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, chosen, note.title));
        if chosen && state.wants_focus {
            state.wants_focus = false;
            response.request_focus();
            response.scroll_to_me(Some(egui::Align::Center));
        }
        // Arrow keys move the focus after the frame, so no frame reports its arrival.
        if response.clicked() || (follows && response.has_focus()) {
            state.read(note.id);
        }
    }
}

/// The way back, and the subject of the note.
fn heading(ui: &mut Ui, t: &Texts, note: &Note, state: &mut Notes) {
    ui.horizontal(|ui| {
        let back = ui.add_enabled(!state.before.is_empty(), Button::new("◀").small());
        if back.explained(t.note_before).accessible_name(t.note_before).clicked() {
            state.go_back();
        }
        let said = Label::new(RichText::new(note.title).strong().heading()).wrap();
        ui.add(said);
    });
}

/// Words with mathematics among them.
fn words_of(ui: &mut Ui, begins: &str, pieces: &[Piece], color: egui::Color32) {
    let font = TextStyle::Body.resolve(ui.style());
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(0.0, 2.0);
        // All lines are as high as words, not as controls.
        ui.spacing_mut().interact_size.y = 0.0;
        if !begins.is_empty() {
            ui.label(RichText::new(begins).color(color));
        }
        for piece in pieces {
            match piece {
                Piece::Words(words) => drop(ui.label(RichText::new(*words).color(color))),
                Piece::Mathematics(latex) => mathematics::inline(ui, latex, &font, color),
            }
        }
    });
}

/// The values of a note's symbols in this figure.
fn numbers(ui: &mut Ui, model: &Model, note: &Note) {
    let symbols: Vec<Symbol> = parameters().filter(|symbol| notes::of_symbol(*symbol) == note.id).collect();
    if symbols.is_empty() {
        return;
    }
    let t = words::texts(model.settings.lang);
    let subject = ExplainedSetting::of(model);
    let setting = subject.setting(model);
    let writing = Writing { setting: &setting, lang: model.settings.lang, digits: model.settings.digits };
    ui.label(RichText::new(t.in_this_figure).small().weak());
    for symbol in symbols {
        answer::of_symbol(ui, writing, symbol);
    }
}

/// The symbols that have a number without a point or an object.
fn parameters() -> impl Iterator<Item = Symbol> {
    let vectors: [fn(Component) -> Symbol; 6] = [
        Symbol::Position,
        Symbol::FocalPoint,
        Symbol::ViewUp,
        |c| Symbol::Axis(Axis::U, c),
        |c| Symbol::Axis(Axis::V, c),
        |c| Symbol::Axis(Axis::N, c),
    ];
    let single = [
        Symbol::Distance,
        Symbol::Near,
        Symbol::Far,
        Symbol::Left,
        Symbol::Right,
        Symbol::Bottom,
        Symbol::Top,
        Symbol::Width,
        Symbol::Height,
        Symbol::Aspect,
        Symbol::ViewAngle,
        Symbol::ImageWidth,
        Symbol::ImageHeight,
        Symbol::ViewportX,
        Symbol::ViewportY,
        Symbol::ViewportWidth,
        Symbol::ViewportHeight,
        Symbol::DepthNear,
        Symbol::DepthFar,
    ];
    vectors.into_iter().flat_map(|vector| Component::THREE.map(vector)).chain(single)
}

/// Other notes that belong to it.
fn links(ui: &mut Ui, t: &Texts, note: &Note, state: &mut Notes) {
    let mut wanted = None;
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(12.0, 2.0);
        ui.spacing_mut().interact_size.y = 0.0;
        ui.label(RichText::new(t.see_also).weak());
        for link in note.links.iter().filter_map(|id| notes::note(t.lang, id)) {
            let response = ui.link(link.title);
            if response.explained(link.group).clicked() {
                wanted = Some(link.id);
            }
        }
    });
    if let Some(id) = wanted {
        state.go_to(id);
    }
}
