//! Shortens texts that are longer than their room, at the ends of words.

use eframe::egui::{FontId, Ui};

/// A text, or as many of its words as fit, with `…` after them.
pub(in crate::gui) fn words(text: &str, fits: impl Fn(&str) -> bool) -> String {
    if fits(text) {
        return text.to_owned();
    }
    let ends = text.char_indices().filter(|(_, c)| c.is_whitespace()).map(|(at, _)| &text[..at]);
    let shorter = |start: &str| format!("{}…", start.trim_end_matches([' ', ',', ';', ':', '·', '–']));
    ends.map(shorter).filter(|shortened| fits(shortened)).last().unwrap_or_else(|| "…".to_owned())
}

/// A text, or as many of its parts (between `·`, semicolons and sentences, but not in brackets) as fit. Of the first,
/// if need be, only its first words.
pub(in crate::gui) fn parts(text: &str, fits: impl Fn(&str) -> bool) -> String {
    let is_end = |at: &usize| [" · ", "; ", ". "].iter().any(|mark| text[*at..].starts_with(mark));
    let ends = text.char_indices().map(|(at, _)| at).filter(is_end).map(|at| &text[..at]).chain([text]);
    let is_open = |start: &str| start.matches('(').count() > start.matches(')').count();
    match ends.filter(|start| !is_open(start) && fits(start)).last() {
        Some(start) => start.to_owned(),
        None => words(text, fits),
    }
}

/// Width of a text on one line.
pub(in crate::gui) fn width(ui: &Ui, font: &FontId, text: &str) -> f32 {
    ui.painter().layout_no_wrap(text.to_owned(), font.clone(), ui.visuals().text_color()).size().x
}

#[cfg(test)]
mod tests {
    use super::{parts, words};

    #[test]
    fn a_text_ends_where_a_word_or_a_part_ends() {
        let within = |most: usize| move |text: &str| text.chars().count() <= most;
        assert_eq!(words("não há nada a recortar", within(40)), "não há nada a recortar");
        assert_eq!(words("não há nada a recortar", within(16)), "não há nada a…");
        assert_eq!(words("tudo dentro, nada fora", within(14)), "tudo dentro…");
        assert_eq!(words("palavra", within(3)), "…");
        assert_eq!(parts("Drag: turn · wheel: zoom · V: probe", within(30)), "Drag: turn · wheel: zoom");
        assert_eq!(parts("Drag: turn · wheel: zoom · V: probe", within(9)), "Drag…");
        assert_eq!(parts("Janela (0,453; 0,102) · 351 px", within(20)), "Janela (0,453…");
        assert_eq!(parts("Pixel (7; 3) · Janela (0,4; 0,1)", within(30)), "Pixel (7; 3)");
        assert_eq!(parts("Drag C, PF; elsewhere: turn the view", within(30)), "Drag C, PF");
        assert_eq!(parts("A list of objects now. It loses the texts.", within(30)), "A list of objects now");
    }
}
