//! The figure as a link: its purpose, its address, and its length.

use std::collections::BTreeSet;

use eframe::egui::{self, RichText};

use crate::figure::Figure;
use crate::gui::app::file_flow;
use crate::gui::app::file_flow::questions::Dialog;
use crate::gui::kit::{Explained, Pressed, TextField, buttons, complaint};
use crate::gui::learn::Learn;
use crate::limits::{MAX_LINK_CHARACTERS, MAX_TYPED};
use crate::sanitize;
use camera_lab_desk::{Memo, Message, Model};
use camera_lab_files::share::{self, Held, ShareError};
use camera_lab_files::{self as files, FigureFiles};
use camera_lab_words::window::{Texts, sharing};

/// The address of links, and the link that a dialog shows.
#[derive(Debug, Default)]
pub struct Sharing {
    /// The address of that page, if others can open it too.
    pub own_address: Option<String>,
    /// The address of a page with this program, for links, as entered by the user.
    pub page_address: String,
    /// The page in one file, where the user found it last. Empty if there is none beside the program.
    pub page_file: std::path::PathBuf,
    /// The shown link, by the address and whether it holds a whole lesson. Computed when the dialog is opened, since
    /// nothing behind it changes.
    link: Memo<(String, bool), Result<Link, ShareError>>,
}

/// A link, the names of the files that it leaves out, and true if a page would hold them.
type Link = (String, Vec<String>, bool);

/// Shows the dialog, with the reason why it's `asked` for. Returns the dialog that stays open. `first` is true when it
/// has just been opened.
pub(in crate::gui) fn show(
    ui: &mut egui::Ui,
    t: &Texts,
    model: &mut Model,
    learn: &mut Learn,
    (sharing, asked): (&mut Sharing, Option<&Message>),
    first: bool,
) -> Option<Dialog> {
    let words = sharing::texts(model.settings.lang);
    ui.heading(words.title);
    ui.add_space(6.0);
    ui.label(words.text);
    ui.add_space(6.0);
    sharing.show_address(ui, words, first && asked.is_some());
    let address = sharing.address();
    ui.add_space(6.0);
    if address.is_empty()
        && let Some(why) = asked
    {
        // Nothing is wrong yet.
        ui.strong(why.text(model.settings.lang));
        ui.add_space(6.0);
    }
    if let Some(playing) = learn.lesson.as_mut().filter(|playing| playing.path.is_some()) {
        ui.checkbox(&mut playing.links_whole, words.whole_lesson).explained(words.whole_lesson_hint);
        ui.add_space(6.0);
    }
    let link = sharing.link(model, learn, first);
    match &link {
        Ok((link, ..)) => {
            // If the clipboard is out of reach, the user can copy the link from here.
            let mut shown = link.as_str();
            let field = TextField::fixed_line(&mut shown);
            let field = field.with(|edit| edit.desired_width(f32::INFINITY).font(egui::TextStyle::Monospace));
            field.show(ui, model.settings.lang).accessible_name(words.link);
            let length = format!("{} / {MAX_LINK_CHARACTERS} {}", link.len(), words.characters);
            ui.label(RichText::new(length).small().weak());
        }
        Err(error) => complaint(ui, &camera_lab_words::messages::link(model.settings.lang, *error)),
    }
    if let Ok((_, own, fits_page)) = &link
        && !own.is_empty()
    {
        complaint(ui, &format!("{} {}", words.own_files, sanitize::within(&own.join(", "), 200)));
        if *fits_page && !model.in_browser {
            ui.label(words.own_files_in_page);
        }
    }
    ui.add_space(10.0);
    let actions: &[&str] = match &link {
        Ok(_) if !address.is_empty() => &[t.copy, words.code],
        Ok(_) => &[t.copy],
        Err(_) => &[],
    };
    match buttons(ui, t.cancel, actions, (first && asked.is_none()).then_some(0)) {
        Pressed::Action(1) => return Some(Dialog::Qr),
        Pressed::Action(_) => {
            if let Ok((link, ..)) = link {
                let length = link.len();
                ui.ctx().copy_text(link);
                model.say(Message::LinkCopied(length));
            }
        }
        Pressed::Cancel => {}
        Pressed::Nothing => return Some(Dialog::Link),
    }
    None
}

impl Sharing {
    /// The address that links begin with: that of the page itself, otherwise the one that the user has entered.
    pub(in crate::gui) fn address(&self) -> String {
        self.own_address.clone().unwrap_or_else(|| self.page_address.clone())
    }

    /// The link to the state on the screen, for a dialog. `first` is true when it has just been opened.
    ///
    /// # Errors
    /// [`ShareError`] if the figure makes it too long.
    pub(in crate::gui) fn link(&mut self, model: &Model, learn: &Learn, first: bool) -> Result<Link, ShareError> {
        if first {
            self.link.forget();
        }
        let is_whole = learn.lesson.as_ref().is_some_and(|playing| playing.links_whole);
        self.link.of((self.address(), is_whole), |(address, _)| made(model, learn, address)).clone()
    }

    /// Shows the address, or its field, which gets the keyboard if the address is `wanted`.
    fn show_address(&mut self, ui: &mut egui::Ui, words: &sharing::Texts, wanted: bool) {
        if let Some(own) = &self.own_address {
            ui.label(format!("{}: {}", words.address, sanitize::escaped(own)));
            return;
        }
        let label = ui.label(words.address);
        let address = &mut self.page_address;
        let field = TextField::line(address, MAX_TYPED);
        let field = field.with(|edit| edit.desired_width(f32::INFINITY).hint_text(words.address_hint));
        let field = field.show(ui, words.lang).labelled_by(label.id);
        if wanted && address.is_empty() {
            field.request_focus();
        }
        *address = address.split('#').next().unwrap_or_default().trim().to_owned();
        ui.label(RichText::new(if address.is_empty() { words.no_address } else { words.address_text }).weak());
    }
}

/// The link: for a built-in lesson to its step, otherwise with the whole figure or lesson in it.
fn made(model: &Model, learn: &Learn, address: &str) -> Result<Link, ShareError> {
    let of_program = learn.lesson.as_ref().filter(|playing| playing.path.is_none() && !address.is_empty());
    if let Some(playing) = of_program {
        let lang = model.settings.lang.tag();
        let link = format!("{address}?lesson={}&step={}&lang={lang}", playing.lesson.id, playing.step + 1);
        return Ok((link, Vec::new(), true));
    }
    let whole = learn.lesson.as_ref().filter(|playing| playing.links_whole);
    let whole = whole.and_then(|playing| Some((playing, playing.path.as_deref()?)));
    if let Some((playing, path)) = whole
        && let Ok((_, text)) = files::read_lesson(path)
    {
        let figures = playing.lesson.steps.iter().map(|step| &*step.figure);
        return with_files(address, Held::Lesson, &text, figures, &FigureFiles::of_lesson(Some(path), false));
    }
    figure_link(model, address)
}

/// The link to the figure on the screen.
pub(in crate::gui) fn figure_link(model: &Model, address: &str) -> Result<Link, ShareError> {
    let shown = &model.desk.shown;
    let text = file_flow::text_as_shown(model);
    with_files(address, Held::Figure, &text, std::iter::once(shown.figure()), &shown.files())
}

/// A link with the files that the figures name, unless it's too long with them.
fn with_files<'a>(
    address: &str,
    held: Held,
    text: &str,
    figures: impl Iterator<Item = &'a Figure> + Clone,
    from: &FigureFiles,
) -> Result<Link, ShareError> {
    let whole = files::text_with_files(text, figures.clone(), from).ok();
    if let Some(link) = whole.as_ref().and_then(|whole| share::link(address, held, whole).ok()) {
        return Ok((link, Vec::new(), true));
    }
    let own: BTreeSet<&str> = figures.flat_map(|figure| files::own_files(figure).into_keys()).collect();
    let own = own.into_iter().map(sanitize::path_text).collect();
    Ok((share::link(address, held, text)?, own, whole.is_some()))
}
