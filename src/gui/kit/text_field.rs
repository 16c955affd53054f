//! The text fields of the window, and their limits.
//!
//! Pasted text may be any file from the clipboard. It's cut before it's laid out, and the field reports that. No other
//! file makes fields of egui's own, which take everything.

use eframe::egui::os::OperatingSystem;
use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::{Align2, Context, Event, Id, Key, Margin, Response, TextEdit, Ui};

use crate::limits::MAX_TYPED;
use camera_lab_words::{Lang, messages};

/// A field for a text with a greatest number of characters.
pub(in crate::gui) struct TextField<'t> {
    edit: TextEdit<'t>,
    most: usize,
    says: bool,
}

impl<'t> TextField<'t> {
    /// One line.
    pub(in crate::gui) fn line(text: &'t mut String, most: usize) -> Self {
        Self { edit: TextEdit::singleline(text).align(Align2::LEFT_CENTER), most, says: true }
    }

    /// Several lines.
    pub(in crate::gui) fn lines(text: &'t mut String, most: usize) -> Self {
        Self { edit: TextEdit::multiline(text), most, says: true }
    }

    /// One line that can be read, selected and copied, but not changed.
    pub(in crate::gui) fn fixed_line(text: &'t mut &str) -> Self {
        Self { edit: TextEdit::singleline(text).align(Align2::LEFT_CENTER), most: usize::MAX, says: false }
    }

    /// As [`Self::fixed_line`], with several lines.
    pub(in crate::gui) fn fixed_lines(text: &'t mut &str) -> Self {
        Self { edit: TextEdit::multiline(text), most: usize::MAX, says: false }
    }

    /// For a text that is refused, with a message of its own, if it's too long. It has room for one character more than
    /// is allowed.
    pub(in crate::gui) fn refused_beyond(self) -> Self {
        Self { most: self.most.saturating_add(1), says: false, ..self }
    }

    /// Its look.
    pub(in crate::gui) fn with(self, look: impl FnOnce(TextEdit<'t>) -> TextEdit<'t>) -> Self {
        Self { edit: look(self.edit), ..self }
    }

    /// Shows the field. While it's full, a note beside it shows that.
    pub(in crate::gui) fn show(self, ui: &mut Ui, lang: Lang) -> Response {
        let (output, text) = self.edit.char_limit(self.most).show_returning_text(ui);
        let response = output.response.response;
        if self.says && response.has_focus() && text.as_str().chars().nth(self.most.saturating_sub(1)).is_some() {
            super::tooltip::beside(&response, |ui| drop(ui.label(messages::at_most_characters(lang, self.most))));
        }
        response
    }
}

/// A line that takes effect with Enter, or when its field is left. A refused text stays until it's mended, and Escape
/// drops it.
pub(in crate::gui) struct KeptLine<'t> {
    pub(in crate::gui) id: Id,
    /// The text in effect.
    pub(in crate::gui) old: &'t str,
    /// Its greatest number of characters.
    pub(in crate::gui) most: usize,
    /// Width in points.
    pub(in crate::gui) width: f32,
}

impl KeptLine<'_> {
    /// Shows the field. Returns the value of a text once it takes effect, or the reason why it's refused.
    pub(in crate::gui) fn show<T, E>(
        self,
        ui: &mut Ui,
        lang: Lang,
        check: impl FnOnce(&str) -> Result<T, E>,
    ) -> (Response, Option<Result<T, E>>) {
        let Self { id, old, most, width } = self;
        // The text in effect, the text typed instead, and true if its field was left although it's wrong.
        type Typing = (String, String, bool);
        let typing = ui.data_mut(|data| data.remove_temp::<Typing>(id)).filter(|(of, ..)| of == old);
        let (old, mut text, was_left) = typing.unwrap_or_else(|| (old.to_owned(), old.to_owned(), false));
        let field = TextField::line(&mut text, most)
            .with(|edit| edit.id(id).desired_width(width).margin(Margin::symmetric(4, 2)));
        let response = field.show(ui, lang);
        let left = response.lost_focus();
        let drops = left && ui.input(|input| input.key_pressed(Key::Escape));
        let is_other = text.trim() != old && !drops;
        let checked = (is_other && (left || was_left)).then(|| check(text.trim()));
        let ends = left && checked.as_ref().is_some_and(Result::is_ok);
        if is_other && !ends || response.has_focus() {
            ui.data_mut(|data| data.insert_temp::<Typing>(id, (old, text, checked.is_some())));
        }
        (response, checked.filter(|checked| left || checked.is_err()))
    }
}

/// Selects characters of a field, so that typing replaces them.
pub(in crate::gui) fn select(ctx: &Context, id: Id, characters: std::ops::Range<usize>) {
    let mut edit = TextEdit::load_state(ctx, id).unwrap_or_default();
    let [begin, end] = [characters.start, characters.end].map(CCursor::new);
    edit.cursor.set_char_range(Some(CCursorRange::two(begin, end)));
    edit.store(ctx, id);
}

/// Cuts pasted text to the limit of the largest field, and one character more.
pub(in crate::gui) fn cut_pasted(events: &mut [Event]) {
    for event in events {
        if let Event::Paste(text) | Event::Text(text) = event
            && let Some((end, _)) = text.char_indices().nth(MAX_TYPED + 1)
        {
            text.truncate(end);
            text.shrink_to_fit();
        }
    }
}

/// Removes the letters of keys pressed with Alt. X11 delivers them like typed ones, so a field would get the letter of
/// each command called from it. On a Mac, Option writes accents and signs.
pub(in crate::gui) fn drop_letters_with_alt(events: &mut Vec<Event>, os: OperatingSystem) {
    if os == OperatingSystem::Mac {
        return;
    }
    let mut is_after_alt = false;
    events.retain(|event| {
        let is_letter = is_after_alt && matches!(event, Event::Text(_));
        // With Ctrl it's AltGr, which writes signs.
        is_after_alt = matches!(event, Event::Key { pressed: true, modifiers, .. } if modifiers.alt && !modifiers.ctrl);
        !is_letter
    });
}

/// Stops the caret after a while without input, because its blinking redraws the whole window twice a second.
#[derive(Debug, Default)]
pub(in crate::gui) struct CaretRest {
    last_input: f64,
    rests: bool,
}

impl CaretRest {
    /// Seconds for which it blinks after the last input, as on most desktops.
    const BLINKS: f64 = 10.0;

    /// Must be called in each frame.
    pub(in crate::gui) fn follow(&mut self, ctx: &Context) {
        let (time, anything) = ctx.input(|input| (input.time, !input.raw.events.is_empty()));
        if anything {
            self.last_input = time;
        }
        let rests = time - self.last_input > Self::BLINKS;
        let blinks = ctx.global_style().visuals.text_cursor.blink;
        // Who has it never blink keeps it so.
        if (rests && blinks) || (!rests && self.rests) {
            self.rests = rests;
            ctx.global_style_mut(|style| style.visuals.text_cursor.blink = !rests);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn alt_writes_no_letters_but_option_does() {
        use eframe::egui::{Key, Modifiers};
        let pressed = |key, modifiers| Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers };
        let text = |text: &str| Event::Text(text.to_owned());
        let events = [
            pressed(Key::M, Modifiers::ALT),
            text("m"),
            text("é"),
            pressed(Key::A, Modifiers::NONE),
            text("a"),
            pressed(Key::Q, Modifiers::ALT | Modifiers::CTRL),
            text("@"),
        ];
        let typed = |os| {
            let mut events = events.to_vec();
            drop_letters_with_alt(&mut events, os);
            let texts =
                events.into_iter().filter_map(|event| if let Event::Text(text) = event { Some(text) } else { None });
            texts.collect::<String>()
        };
        assert_eq!(typed(OperatingSystem::Nix), "éa@");
        assert_eq!(typed(OperatingSystem::Mac), "méa@");
    }

    #[test]
    fn pasted_text_is_cut_if_no_field_has_room_for_it() {
        let long = "θ".repeat(10 * MAX_TYPED);
        let mut events = [Event::Paste(long.clone()), Event::Text(long), Event::Paste("θ = 45°".to_owned())];
        cut_pasted(&mut events);
        let lengths = events.map(|event| match event {
            Event::Paste(text) | Event::Text(text) => text.chars().count(),
            _ => 0,
        });
        assert_eq!(lengths, [MAX_TYPED + 1, MAX_TYPED + 1, 7]);
    }
}
