//! The list of exercises.

use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{self, Button, Key, RichText, Role, TextStyle, Ui, WidgetInfo};

use crate::exercises::{Entry, Stage};
use crate::gui::kit::{Explained, TextField};
use crate::gui::learn::exercises::state::{Chosen, Exercises};
use camera_lab_words::Lang;
use camera_lab_words::learn::exercise_window::Texts;
use camera_lab_words::learn::{exercise_messages, exercise_window as words, exercises as said};
use camera_lab_words::window::search::{folded, has_words};

/// The search field. Enter opens the first exercise found.
pub(super) fn search(ui: &mut Ui, t: &Texts, state: &mut Exercises) {
    let field = TextField::line(&mut state.wanted, crate::limits::MAX_TYPED_NAME);
    let field = field.with(|edit| edit.hint_text(t.search).desired_width(f32::INFINITY));
    let response = field.show(ui, t.lang).explained(t.search_hint).accessible_name(t.search);
    state.answer_call(&response);
    if response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
        let first = found(t.lang, state).next().cloned();
        first.iter().for_each(|first| open(state, first));
    }
}

/// The number of solved ones.
pub(super) fn count(ui: &mut Ui, state: &Exercises, lang: Lang) {
    let all = state.entries().count();
    let of = |stages: &[Stage]| state.entries().filter(|entry| stages.contains(&state.stage(&entry.id))).count();
    let (solved, alone) = (of(&[Stage::Solved, Stage::Alone]), of(&[Stage::Alone]));
    let text = format!("✓ {} · ★ {alone}", exercise_messages::score(lang, solved, all));
    let t = words::texts(lang);
    ui.label(RichText::new(text).weak()).explained(format!("✓ {} · ★ {}", t.solved, t.alone));
}

/// The exercises that contain all the words.
fn found(lang: Lang, state: &Exercises) -> impl Iterator<Item = &Entry> {
    state.entries().filter(move |entry| {
        has_words(&folded(&format!("{} {} {}", entry.id, entry.source, said::title(lang, entry))), &state.wanted)
    })
}

pub(in crate::gui) fn open(state: &mut Exercises, entry: &Entry) {
    let seed = state.seed_of(entry);
    state.work_on(Chosen { id: entry.id.clone().into_owned(), seed });
    state.calls_keyboard = true;
}

/// Shows the exercises found, by groups.
pub(super) fn ui(ui: &mut Ui, t: &Texts, state: &mut Exercises) {
    let found: Vec<Entry> = found(t.lang, state).cloned().collect();
    let own = state.own.as_ref().map(|own| own.folder.file_name().unwrap_or(own.folder.as_os_str()));
    let own = own.map(|name| crate::sanitize::escaped(&name.to_string_lossy())).unwrap_or_default();
    let mut group = None;
    let mut chosen = None;
    ui.spacing_mut().item_spacing.y = 1.0;
    for entry in &found {
        let heading = match (entry.texts(), entry.is_family) {
            (Some(_), _) => own.as_str(),
            (None, true) => t.families,
            (None, false) => t.of_the_notes,
        };
        if group != Some(heading) {
            group = Some(heading);
            ui.add_space(4.0);
            ui.label(RichText::new(heading).small().strong());
        }
        if row(ui, t, entry, state) {
            chosen = Some(entry);
        }
    }
    if group.is_none() {
        ui.label(t.none_found);
    }
    if let Some(entry) = chosen {
        open(state, entry);
    }
}

/// A row with progress, title and source. Returns true if it's chosen.
fn row(ui: &mut Ui, t: &Texts, entry: &Entry, state: &mut Exercises) -> bool {
    let (sign, stage) = match state.stage(&entry.id) {
        Stage::Untouched => ("○", t.untouched),
        Stage::Begun => ("◐", t.begun),
        Stage::Solved => ("✓", t.solved),
        Stage::Alone => ("★", t.alone),
    };
    let title = said::title(t.lang, entry);
    let mut job = LayoutJob::default();
    let format = |style: TextStyle, color| TextFormat::simple(style.resolve(ui.style()), color);
    let visuals = ui.visuals();
    job.append(&format!("{sign} "), 0.0, format(TextStyle::Body, visuals.weak_text_color()));
    job.append(title, 0.0, format(TextStyle::Body, visuals.text_color()));
    // The source may be cut at the end of a narrow row.
    let minutes = entry.minutes.map_or_else(String::new, |minutes| format!("  {minutes} min"));
    job.append(&format!("{minutes}  {}", entry.source), 0.0, format(TextStyle::Small, visuals.weak_text_color()));
    let button = Button::selectable(false, job).truncate();
    let response = ui.with_layout(egui::Layout::top_down_justified(egui::Align::LEFT), |ui| ui.add(button)).inner;
    response.widget_info(|| {
        WidgetInfo::labeled(
            Role::Button,
            true,
            [title, entry.source, stage].into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", "),
        )
    });
    state.give_focus(&entry.id, &response);
    response.explained(stage).clicked()
}
