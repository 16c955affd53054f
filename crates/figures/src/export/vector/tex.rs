//! A page as a figure of a LaTeX document. Its letters are the document's, and everything else is in a PDF beside it.

use std::sync::Arc;

use super::{Item, Page, PageText, number};
use crate::appearance::Rgba;
use crate::drawing::Anchor;
use crate::{formula, text};

/// The LaTeX of a page, a `picture` for `\input`. Everything except texts is in the PDF `art`, a name without its
/// extension. The document needs the packages graphicx and color (or xcolor). Compiled alone, it's a document of one
/// page as large as the picture.
///
/// Each label is set in the document's font, at the height that it has on the page. Its symbols are mathematics.
pub(super) fn tex(page: &Page, art: &str) -> String {
    let [width, height] = page.size.map(|side| number(side * page.points));
    // LaTeX drops its error for text before the body once the body begins. That distinguishes a file inside a document
    // from one compiled alone.
    let alone = format!(
        "\\expandafter\\ifx\\csname @nodocument\\endcsname\\relax\\let\\endofpage\\relax\\else\n  \
         \\documentclass{{article}}\\usepackage[utf8]{{inputenc}}\\usepackage{{graphicx,color}}%\n  \
         \\usepackage[paperwidth={width}bp,paperheight={height}bp,margin=0bp]{{geometry}}%\n  \
         \\pagestyle{{empty}}\\setlength{{\\parindent}}{{0bp}}\\setlength{{\\topskip}}{{0bp}}%\n  \
         \\def\\endofpage{{\\end{{document}}}}\\expandafter\\begin\\expandafter{{document}}%\n\\fi\n"
    );
    let mut latex = format!(
        "% {}\n% \\usepackage{{graphicx, color}}\n{alone}\\begingroup\n\\setlength{{\\unitlength}}{{1bp}}%\n\
         \\begin{{picture}}({width},{height})%\n  \\put(0,0){{\\includegraphics[width={width}bp]{{{art}}}}}%\n",
        page.title.split_whitespace().collect::<Vec<_>>().join(" ")
    );
    labels(page, &page.items, ([0.0; 2], 1.0), &mut latex);
    latex.push_str("\\end{picture}%\n\\endgroup\\endofpage\n");
    latex
}

/// The page without its texts.
pub(super) fn without_texts(page: &Page) -> Page {
    fn kept(items: &[Item]) -> Vec<Item> {
        let keep = |item: &Item| match item {
            Item::Text(_) => None,
            Item::Group { corner, scale, clip, items } => {
                Some(Item::Group { corner: *corner, scale: *scale, clip: *clip, items: Arc::new(kept(items)) })
            }
            Item::Fill { .. } | Item::Stroke { .. } | Item::Picture { .. } => Some(item.clone()),
        };
        items.iter().filter_map(keep).collect()
    }
    Page { items: kept(&page.items), ..page.clone() }
}

/// `by` and `zoom`: the place of the items on the page, and units of the page per unit of theirs.
fn labels(page: &Page, items: &[Item], (by, zoom): ([f32; 2], f32), latex: &mut String) {
    for item in items {
        match item {
            Item::Group { corner, scale, items, .. } => {
                let corner = [0, 1].map(|k| by[k] + zoom * corner[k]);
                labels(page, items, (corner, zoom * scale), latex);
            }
            Item::Text(PageText { at, text, mathematical, size, color, anchor, .. }) => {
                let width = text::measure(text, *size, *mathematical).width;
                let (share, before, after) = match anchor {
                    Anchor::Left => (0.0, "", r"\hss"),
                    Anchor::Center => (0.5, r"\hss", r"\hss"),
                    Anchor::Right => (1.0, r"\hss", ""),
                };
                let x = number((by[0] + zoom * (at[0] + share * width)) * page.points);
                let y = number((page.size[1] - by[1] - zoom * at[1]) * page.points);
                let Rgba { r, g, b, .. } = *color;
                let [r, g, b] = [r, g, b].map(|part| number(f32::from(part) / 255.0));
                let size = number(zoom * size * page.points);
                let text = label(text);
                latex.push_str(&format!(
                    "  \\put({x},{y}){{\\hbox to 0pt{{{before}\\fontsize{{{size}bp}}{{{size}bp}}\\selectfont\
                     \\color[rgb]{{{r},{g},{b}}}{text}{after}}}}}%\n"
                ));
            }
            Item::Fill { .. } | Item::Stroke { .. } | Item::Picture { .. } => {}
        }
    }
}

/// A label in LaTeX: symbols as mathematics, **u**, **v** and **n** as vectors.
fn label(text: &str) -> String {
    let mut latex = String::new();
    let runs = text::runs(text);
    for (k, run) in runs.iter().enumerate() {
        if run.lowered {
            continue;
        }
        let below = runs.get(k + 1).filter(|next| next.lowered).map(|next| next.text);
        // The symbol with the subscript is the last word.
        let letters = run.text.char_indices().rev().take_while(|(_, c)| c.is_alphabetic());
        let start = letters.last().map_or(run.text.len(), |(at, _)| at);
        let (before, symbol) = match below {
            Some(_) => run.text.split_at(start),
            None => (run.text, ""),
        };
        before.split_inclusive(|c: char| !c.is_alphabetic()).for_each(|part| latex.push_str(&word(part)));
        if let Some(below) = below {
            latex.push_str(&format!("${}_{{{}}}$", mathematics(symbol), subscript(below)));
        }
    }
    latex
}

/// A word, with the character that ends it.
fn word(part: &str) -> String {
    let name = part.trim_end_matches(|c: char| !c.is_alphabetic());
    let rest = formula::words(&part[name.len()..]);
    if let Some(symbol) = letter_of_mathematics(name) {
        return format!("${symbol}${rest}");
    }
    let is_symbol = matches!(name, "u" | "v" | "n" | "x" | "y" | "z" | "w" | "t" | "PF" | "VUP" | "DOP")
        || (name.chars().count() == 1 && name.chars().all(char::is_uppercase) && name.is_ascii());
    let name = if is_symbol { format!("${}$", mathematics(name)) } else { formula::words(name) };
    name + &rest
}

/// The name of a symbol in mathematics.
fn mathematics(name: &str) -> String {
    if let Some(symbol) = letter_of_mathematics(name) {
        return symbol;
    }
    match name {
        "u" | "v" | "n" => format!("\\mathbf{{{name}}}"),
        name if name.chars().count() > 1 => format!("\\mathrm{{{}}}", formula::words(name)),
        name => formula::words(name).replace('$', ""),
    }
}

/// A bold or an italic letter of Unicode's mathematics in LaTeX; `None` for any other word.
fn letter_of_mathematics(name: &str) -> Option<String> {
    let letters: Vec<(text::Face, char)> = name.chars().map(|c| text::face(c, true)).collect();
    let all = |face| letters.iter().all(|(other, letter)| *other == face && letter.is_ascii());
    let plain: String = letters.iter().map(|(_, letter)| letter).collect();
    match name.chars().next() {
        Some(first) if !first.is_ascii() && all(text::Face::Bold) => Some(format!("\\mathbf{{{plain}}}")),
        Some(first) if !first.is_ascii() && all(text::Face::Italic) => Some(plain),
        _ => None,
    }
}

fn subscript(name: &str) -> String {
    if let Some(symbol) = letter_of_mathematics(name) {
        return symbol;
    }
    let plain = formula::words(name).replace('$', "");
    if name.chars().count() > 1 { format!("\\mathrm{{{plain}}}") } else { plain }
}

#[cfg(test)]
mod tests {
    use super::label;

    #[test]
    fn symbols_are_mathematics_and_words_are_words() {
        for (text, latex) in [
            ("u", r"$\mathbf{u}$"),
            ("PF", r"$\mathrm{PF}$"),
            ("far (B)", "far ($B$)"),
            ("z_n", "$z_{n}$"),
            ("D_R", "$D_{R}$"),
            ("θ/2", r"$\theta$/2"),
            ("(−1, −1, −1)", "($-$1, $-$1, $-$1)"),
            ("50 % & more", r"50 \% \& more"),
        ] {
            assert_eq!(label(text), latex, "{text}");
        }
    }
}
