//! Text in Markdown, with mathematics between dollar signs.

use std::sync::{Arc, Mutex, PoisonError};

use eframe::egui::{Id, TextStyle, Ui};
use egui_commonmark::{CommonMarkCache, CommonMarkViewer};

use super::mathematics;
use crate::i18n::notes::plain;

/// Symbols such as `M_v` as mathematics; what is between dollar signs already stays as it is.
fn with_symbols(markdown: &str) -> String {
    let mut set = String::with_capacity(markdown.len() + 16);
    for (k, part) in markdown.split('$').enumerate() {
        if k > 0 {
            set.push('$');
        }
        if k % 2 == 1 {
            set.push_str(part);
            continue;
        }
        for word in part.split_inclusive(|c: char| !(c.is_ascii_alphanumeric() || c == '_')) {
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

/// Shows a text.
pub(super) fn show(ui: &mut Ui, markdown: &str) {
    let cache = ui.data_mut(|data| {
        Arc::clone(data.get_temp_mut_or_default::<Arc<Mutex<CommonMarkCache>>>(Id::unique("markdown")))
    });
    // What a panic has left of a cache is still a cache.
    let mut cache = cache.lock().unwrap_or_else(PoisonError::into_inner);
    let set = |ui: &mut Ui, latex: &str, in_line: bool| {
        let font = TextStyle::Body.resolve(ui.style());
        if in_line {
            mathematics::inline(ui, latex, &font, ui.visuals().text_color());
        } else {
            mathematics::show(ui, latex, &plain(latex), font.size);
        }
    };
    ui.scope(|ui| {
        // Lines are as high as words, not as controls.
        ui.spacing_mut().interact_size.y = 0.0;
        CommonMarkViewer::new().render_math_fn(Some(&set)).show(ui, &mut cache, &with_symbols(markdown));
    });
}

#[cfg(test)]
mod tests {
    use super::with_symbols;

    #[test]
    fn symbols_are_set_and_nothing_else() {
        assert_eq!(with_symbols("(c) M_v and **u** of O_R."), "(c) $M_{v}$ and **u** of $O_{R}$.");
        for text in ["$M_v$ is set already", "view_angle stays, and key=a_b_c", "**n** × VUP"] {
            assert_eq!(with_symbols(text), text);
        }
    }
}
