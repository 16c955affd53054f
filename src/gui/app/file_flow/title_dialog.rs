//! The question for the title and the caption of a figure, in both languages.

use std::iter;

use eframe::egui::{self, Key, Modifiers, RichText};

use crate::figure::{Figure, Localized};
use crate::gui::app::file_flow::file_kind::FileKind;
use crate::gui::app::file_flow::questions::{Dialog, FileFlow, Purpose, TitleForm};
use crate::gui::app::state::State;
use crate::gui::kit::{Pressed, TextField, buttons, text_field};
use crate::limits::{MAX_CAPTION, MAX_TITLE, MAX_TYPED};
use camera_lab_desk::Model;
use camera_lab_words::window::{Texts, sharing};
use camera_lab_words::{Lang, told, told_mut};

/// The answer of the dialog, if the figure is saved with its words.
pub(in crate::gui) enum Answer {
    /// In this file.
    Save(Purpose, String),
    /// In a file that the user chooses in the system's dialog.
    Choose(Purpose),
}

impl TitleForm {
    /// The words of the figure. `None` if they belong to a card and the window shows another figure by now. `then` is
    /// the save that follows.
    pub(in crate::gui) fn of(model: &Model, then: Option<Purpose>) -> Self {
        let Figure { title, caption, .. } = model.desk.shown.figure();
        if model.desk.shown.has_words_of_card() {
            return Self { of_card: Box::new([title.clone(), caption.clone()]), then, ..Self::default() };
        }
        let text = |text: &Option<Localized>| text.clone().unwrap_or_default();
        Self { title: text(title), caption: text(caption), then, ..Self::default() }
    }
}

/// Shows the dialog. Returns the save that follows. `first` is true when it has just been opened.
pub(in crate::gui) fn show(
    ui: &mut egui::Ui,
    t: &'static Texts,
    state: &mut State,
    mut form: TitleForm,
    first: bool,
) -> Option<Answer> {
    ui.heading(t.title_heading);
    ui.add_space(6.0);
    ui.label(t.title_text);
    ui.add_space(6.0);
    let entered = ui.input(|input| input.key_pressed(Key::Enter) && input.modifiers == Modifiers::NONE);
    let mut done = false;
    let [card_title, card_caption] = &*form.of_card;
    let rows = [
        (t.title_name, &mut form.title, card_title, MAX_TITLE, 1),
        (t.caption_name, &mut form.caption, card_caption, MAX_CAPTION, 3),
    ];
    for (name, text, of_card, most, lines) in rows {
        let others = Lang::ALL.into_iter().filter(|lang| *lang != t.lang);
        for lang in iter::once(t.lang).chain(others) {
            let label = ui.label(format!("{name}, {}", lang.name()));
            let hint = of_card.as_ref().map(|text| told(lang, text)).unwrap_or_default();
            let typed = told_mut(lang, text);
            let typed_length = typed.chars().count();
            let field = if lines == 1 { TextField::line(typed, most) } else { TextField::lines(typed, most) };
            let field = field
                .with(|edit| edit.desired_width(f32::INFINITY).desired_rows(lines).hint_text(hint).return_key(None));
            let response = field.show(ui, t.lang).labelled_by(label.id);
            if first && lines == 1 && lang == t.lang {
                response.request_focus();
                text_field::select(ui.ctx(), response.id, 0..typed_length);
            }
            done |= response.has_focus() && entered;
        }
    }
    ui.label(RichText::new(t.title_note).small().weak());
    let by_system = state.file_flow.native && !state.model.in_browser;
    let path = form.then.as_ref().and_then(|purpose| {
        let mut path =
            form.path.clone().unwrap_or_else(|| proposal(FileKind::of(state, purpose), t.lang, form.title.clone()));
        // Without a folder it would land anywhere, so the system's dialog asks.
        let has_folder = std::path::Path::new(&path).parent().is_some_and(|folder| !folder.as_os_str().is_empty());
        if by_system && form.path.is_none() && !has_folder {
            return None;
        }
        let hint = if state.model.in_browser { sharing::texts(t.lang).name_hint } else { t.path_hint };
        let label = ui.label(t.title_file);
        let field = TextField::line(&mut path, MAX_TYPED);
        let field = field.with(|edit| edit.desired_width(f32::INFINITY).hint_text(hint).return_key(None));
        let response = field.show(ui, t.lang).labelled_by(label.id);
        done |= response.has_focus() && entered;
        if response.changed() {
            form.path = Some(path.clone());
        }
        Some(path)
    });
    ui.add_space(10.0);
    let actions: &[&str] = match &path {
        None if form.then.is_none() => &[t.title_action],
        None => &[t.save_as],
        Some(_) if by_system => &[t.title_choose, t.save_action],
        Some(_) => &[t.save_action],
    };
    let last = actions.len() - 1;
    let pressed = match buttons(ui, t.cancel, actions, None) {
        Pressed::Nothing if done => Pressed::Action(last),
        pressed => pressed,
    };
    let waits = match (&pressed, &path) {
        (Pressed::Nothing, _) => true,
        (Pressed::Action(which), Some(path)) => *which == last && path.trim().is_empty(),
        (Pressed::Action(_) | Pressed::Cancel, _) => false,
    };
    if waits {
        state.file_flow.dialog = Some(Dialog::Title(form));
        return None;
    }
    let Pressed::Action(which) = pressed else { return None };
    let purpose = accept(&mut state.model, &mut state.file_flow, form)?;
    Some(match path {
        Some(path) if which == last => Answer::Save(purpose, path.trim().to_owned()),
        Some(_) | None => Answer::Choose(purpose),
    })
}

/// The file of a figure with this title.
fn proposal(kind: FileKind, lang: Lang, title: Localized) -> String {
    let title = written(title);
    let title = title.as_ref().map(|title| told(lang, title));
    kind.with_name_of(title).proposal().display().to_string()
}

fn accept(model: &mut Model, file_flow: &mut FileFlow, form: TitleForm) -> Option<Purpose> {
    let [title, caption] = [form.title, form.caption].map(written);
    let figure = model.desk.shown.figure();
    if (&figure.title, &figure.caption) != (&title, &caption) {
        model.desk.shown.edit(|figure| (figure.title, figure.caption) = (title, caption));
        model.desk.commit();
    }
    if form.then.is_some() {
        file_flow.titled = Some(model.desk.shown.id());
    }
    form.then
}

/// A text of one line in each language. English replaces an empty one, or else the first.
fn written(text: Localized) -> Option<Localized> {
    let line = |_: &str, text: &str| {
        let words =
            text.split(|c: char| c.is_whitespace() || crate::sanitize::is_obeyed(c)).filter(|word| !word.is_empty());
        words.collect::<Vec<_>>().join(" ")
    };
    let Localized { en, pt_br, others } = text.map(line);
    let mut texts = vec![("en".to_owned(), en), ("pt-BR".to_owned(), pt_br)];
    texts.extend(others.into_iter().filter(|(_, text)| !text.is_empty()));
    Localized::from_languages(texts)
}
