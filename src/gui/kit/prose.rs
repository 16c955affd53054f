//! Text in Markdown, with mathematics between dollar signs.

use std::sync::{Arc, Mutex, PoisonError};

use eframe::egui::{FontId, Id, Label, Response, RichText, Sense, TextStyle, Ui};
use egui_commonmark::{CommonMarkCache, CommonMarkViewer};

use super::{mathematics, theme};
use camera_lab_words::why::notes::{line, plain};

/// Turns symbols such as `M_v` into mathematics. Text between dollar signs stays as it is.
fn with_symbols(markdown: &str) -> String {
    // A formula on a line of its own is between two of them.
    let part = |(k, part): (usize, &str)| if k % 2 == 1 { part.to_owned() } else { with_symbols_in_line(part) };
    markdown.split("$$").enumerate().map(part).collect::<Vec<_>>().join("$$")
}

fn with_symbols_in_line(markdown: &str) -> String {
    let mut set = String::with_capacity(markdown.len() + 16);
    for (k, part) in markdown.split('$').enumerate() {
        if k > 0 {
            set.push('$');
        }
        if k % 2 == 1 {
            set.push_str(part);
            continue;
        }
        for word in with_tuples_kept(part).split_inclusive(|c: char| !(c.is_ascii_alphanumeric() || c == '_')) {
            let end = word.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(word.len());
            let (symbol, rest) = word.split_at(end);
            match symbol.split_once('_') {
                Some((letter, below))
                    if letter.len() == 1 && (1..=3).contains(&below.len()) && !below.contains('_') =>
                {
                    set.push_str(&format!("${letter}_{{{below}}}${rest}"));
                }
                _ => set.push_str(word),
            }
        }
    }
    set
}

/// Keeps a tuple in one line, so that no line ends at a space in (1; −1; 2).
fn with_tuples_kept(text: &str) -> String {
    /// In characters. A longer one may be wider than a narrow panel.
    const LONGEST: usize = 30;
    let (mut set, mut rest) = (String::with_capacity(text.len()), text);
    while let Some((before, from)) = rest.split_once('(') {
        set.push_str(before);
        set.push('(');
        rest = from;
        let Some(end) = from.find(['(', ')']).filter(|end| from[*end..].starts_with(')')) else { continue };
        let (inner, after) = from.split_at(end);
        let separator = if inner.contains("; ") { "; " } else { ", " };
        let is_tuple = inner.contains(separator)
            && inner.chars().count() <= LONGEST
            && inner.split(separator).all(|item| !item.contains(' '));
        set.push_str(&if is_tuple { inner.replace(' ', "\u{a0}") } else { inner.to_owned() });
        rest = after;
    }
    set + rest
}

/// The mark of bold words. The renderer has no bold letters, so they are set like formulas, with our letters.
const BOLD: char = '\u{e000}';
/// Between two formulas that touch: `$$` would begin one on a line of its own.
const APART: char = '\u{200b}';

/// Words between `**` as formulas that begin with [`BOLD`]. Formulas between them stay.
fn with_bold(markdown: &str) -> String {
    let part = |(k, part): (usize, &str)| if k % 2 == 1 { part.to_owned() } else { with_bold_in_lines(part) };
    markdown.split("$$").enumerate().map(part).collect::<Vec<_>>().join("$$")
}

fn with_bold_in_lines(markdown: &str) -> String {
    let marks = markdown.matches("**").count();
    let mut set = String::with_capacity(markdown.len() + 16);
    for (k, run) in markdown.split("**").enumerate() {
        let is_bold = k % 2 == 1 && k < marks;
        if k % 2 == 1 && !is_bold {
            // No mark closes it.
            set.push_str("**");
        }
        for (j, part) in run.split('$').enumerate() {
            let is_formula = j % 2 == 1;
            let words = part.trim();
            let touches = is_formula || is_bold && !words.is_empty() && !part.starts_with(char::is_whitespace);
            if touches && set.ends_with('$') {
                set.push(APART);
            }
            match (is_formula, is_bold && !words.is_empty()) {
                (true, _) => set.push_str(&format!("${part}$")),
                (_, true) => {
                    let (before, after) = (part.len() - part.trim_start().len(), part.trim_end().len());
                    let words = words.replace('*', "");
                    set.push_str(&format!("{}${BOLD}{words}${}", &part[..before], &part[after..]));
                }
                _ => set.push_str(part),
            }
        }
    }
    set
}

/// Shows a text.
pub(in crate::gui) fn show(ui: &mut Ui, markdown: &str) {
    let cache = ui.data_mut(|data| {
        Arc::clone(data.get_temp_mut_or_default::<Arc<Mutex<CommonMarkCache>>>(Id::unique("markdown")))
    });
    // A cache after a panic is still a cache.
    let mut cache = cache.lock().unwrap_or_else(PoisonError::into_inner);
    let set = |ui: &mut Ui, latex: &str, in_line: bool| {
        let font = TextStyle::Body.resolve(ui.style());
        if let Some(words) = latex.strip_prefix(BOLD) {
            ui.add(Label::new(RichText::new(words).font(theme::bold(font.size))).wrap());
        } else if in_line {
            mathematics::inline(ui, latex, &font, ui.visuals().text_color());
        } else {
            displayed(ui, latex, font.size);
        }
    };
    ui.scope(|ui| {
        // Lines are as high as words, not as controls.
        ui.spacing_mut().interact_size.y = 0.0;
        CommonMarkViewer::new().render_math_fn(Some(&set)).show(ui, &mut cache, &with_bold(&with_symbols(markdown)));
    });
}

/// A formula on a line of its own. In a narrow panel its parts stand below one another, and a wide part is smaller.
fn displayed(ui: &mut Ui, latex: &str, size: f32) {
    const BETWEEN: &str = r"\quad";
    let room = ui.max_rect().width();
    let width = |latex: &str, size| mathematics::Formula::new(ui, latex, &plain(latex), size).size().x;
    let all = width(latex, size);
    if all > room && latex.contains(BETWEEN) {
        for part in latex.split(BETWEEN) {
            displayed(ui, part, size);
            ui.add_space(size);
        }
    } else {
        mathematics::show(ui, latex, &plain(latex), size * (room / all).clamp(0.6, 1.0));
    }
}

/// A short text in a row of other things. Formulas and bold words are set.
pub(in crate::gui) fn in_row(ui: &mut Ui, markdown: &str) {
    if has_marks(markdown) {
        show(ui, markdown);
    } else {
        ui.label(markdown);
    }
}

/// A radio button and its text, in a row of others. A click on either chooses it.
pub(in crate::gui) fn radio(ui: &mut Ui, is_chosen: bool, markdown: &str) -> Response {
    if !has_marks(markdown) {
        return ui.radio(is_chosen, markdown);
    }
    let set = with_bold(&with_symbols(markdown));
    let button = ui.spacing().icon_width + ui.spacing().icon_spacing;
    let width = button + pieces(&set).map(|piece| piece.width(ui)).sum::<f32>();
    let fits = width <= ui.max_rect().width();
    if fits && width > ui.available_size_before_wrap().x {
        ui.end_row();
    }
    let words = |ui: &mut Ui| {
        // As for a button with its text, which isn't wider than its circle.
        let height = ui.spacing().interact_size.y;
        (ui.spacing_mut().interact_size.y, ui.spacing_mut().item_spacing.x) = (0.0, 0.0);
        let button = ui.radio(is_chosen, "").accessible_name(line(markdown));
        ui.spacing_mut().interact_size.y = height;
        if fits {
            pieces(&set).for_each(|piece| piece.show(ui));
        } else {
            show(ui, markdown);
        }
        button
    };
    let row = if fits { ui.horizontal(words) } else { ui.horizontal_top(words) };
    // Above the words, which can be selected otherwise.
    let click = ui.interact(row.response.rect, row.inner.id.with("words"), Sense::click());
    if click.clicked() { click } else { row.inner }
}

/// A part of a short text.
enum Piece<'a> {
    Words(&'a str),
    Bold(&'a str),
    Formula(&'a str),
}

/// The parts of a text whose bold words are set as formulas.
fn pieces(set: &str) -> impl Iterator<Item = Piece<'_>> {
    set.split('$').enumerate().filter(|(_, part)| !part.is_empty()).map(|(k, part)| match part.strip_prefix(BOLD) {
        Some(words) => Piece::Bold(words),
        None if k % 2 == 1 => Piece::Formula(part),
        None => Piece::Words(part),
    })
}

impl Piece<'_> {
    fn width(&self, ui: &Ui) -> f32 {
        let font = TextStyle::Body.resolve(ui.style());
        let words = |words: &str, font: FontId| {
            ui.painter().layout_no_wrap(words.to_owned(), font, ui.visuals().text_color()).size().x
        };
        match self {
            Self::Words(text) => words(&text.replace(['*', '`'], ""), font),
            Self::Bold(text) => words(text, theme::bold(font.size)),
            Self::Formula(latex) => mathematics::inline_width(ui, latex, &font),
        }
    }

    fn show(&self, ui: &mut Ui) {
        let font = TextStyle::Body.resolve(ui.style());
        match self {
            Self::Words(text) => drop(ui.label(text.replace(['*', '`'], ""))),
            Self::Bold(text) => drop(ui.label(RichText::new(*text).font(theme::bold(font.size)))),
            Self::Formula(latex) => mathematics::inline(ui, latex, &font, ui.visuals().text_color()),
        }
    }
}

/// True for a text with formulas, bold words or code.
fn has_marks(markdown: &str) -> bool {
    markdown.contains(['$', '*', '`'])
}

#[cfg(test)]
mod tests {
    use super::{with_bold, with_symbols, with_tuples_kept};

    #[test]
    fn a_tuple_is_not_broken_and_words_in_brackets_are() {
        let kept = "PF = (1;\u{a0}−1;\u{a0}1/2) e $(1, 2)$";
        assert_eq!(with_symbols("PF = (1; −1; 1/2) e $(1, 2)$"), kept);
        assert_eq!(with_tuples_kept("at (0.5, 2), (x, y)"), "at (0.5,\u{a0}2), (x,\u{a0}y)");
        for text in ["(as it is, or not)", "(5.2), (5.3)", "f(a; (1; b c))", "an open (1, 2"] {
            assert_eq!(with_tuples_kept(text), text);
        }
    }

    #[test]
    fn bold_words_are_set_apart_and_formulas_between_them_stay() {
        assert_eq!(with_bold("**n** and **u × v**."), "$\u{e000}n$ and $\u{e000}u × v$.");
        assert_eq!(with_bold("**put $M_{p}$ in *Image*:** so"), "$\u{e000}put$ $M_{p}$ $\u{e000}in Image:$ so");
        assert_eq!(with_bold("**($w$)** 5"), "$\u{e000}($\u{200b}$w$\u{200b}$\u{e000})$ 5");
        for text in ["2 ** 3 stays", "$$a ** b ** c$$", "*so*, $x$"] {
            assert_eq!(with_bold(text), text);
        }
    }

    #[test]
    fn symbols_are_set_and_nothing_else() {
        assert_eq!(with_symbols("(c) M_v and **u** of O_R."), "(c) $M_{v}$ and **u** of $O_{R}$.");
        for text in [
            "$M_v$ is set already",
            "so $$i = \\frac{m}{W} x_p$$ and",
            "view_angle stays, and key=a_b_c",
            "**n** × VUP",
        ] {
            assert_eq!(with_symbols(text), text);
        }
    }
}
