//! Texts of labels: subscripts and lines, and with the feature `text` the bundled fonts, in which they're measured and
//! drawn.

#[cfg(feature = "text")]
mod font;

#[cfg(feature = "text")]
pub use font::{
    BOLD_BYTES, Extent, FONT_BYTES, Face, ITALIC_BYTES, ROMAN_BYTES, SetRun, advance, face, glyph, measure, outline,
    set_runs, x_height,
};

/// A step of an outline, in pixels: x to the right, y downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Element {
    /// A contour begins here.
    Move([f32; 2]),
    /// A straight line to a point.
    Line([f32; 2]),
    /// A quadratic Bézier curve: control point, end.
    Quad([f32; 2], [f32; 2]),
    /// A cubic Bézier curve: two control points, end.
    Cubic([f32; 2], [f32; 2], [f32; 2]),
    /// The contour is closed.
    Close,
}

/// A piece of a text whose characters are all on the line, or all lowered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run<'a> {
    /// In the order of reading, on one line.
    pub text: &'a str,
    /// A subscript: smaller and lower.
    pub lowered: bool,
}

/// A text whose every `_` stands for itself, such as a user's name for an object or a key of a file.
pub fn literal(text: &str) -> String {
    text.replace('_', "\\_")
}

/// The pieces of a text, joined to lines that fit. A piece that fits nowhere has a line of its own.
pub fn broken<T: AsRef<str>>(pieces: impl IntoIterator<Item = T>, fits: impl Fn(&str) -> bool) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for piece in pieces {
        let piece = piece.as_ref();
        match lines.last_mut() {
            Some(line) if fits(format!("{line}{piece}").trim_end()) => line.push_str(piece),
            _ => lines.push(piece.to_owned()),
        }
    }
    lines.iter_mut().for_each(|line| line.truncate(line.trim_end().len()));
    lines
}

/// The runs of a text: `_c` lowers one character, `_{abc}` several. A `_` with nothing to lower stands for itself, and
/// so does that of `\_`.
pub fn runs(text: &str) -> Vec<Run<'_>> {
    let mut runs = Vec::new();
    let mut push = |text, lowered| runs.push(Run { text, lowered });
    let mut rest = text;
    while let Some(at) = rest.find('_') {
        let (before, mark) = rest.split_at(at);
        let after = &mark[1..];
        if let Some(before) = before.strip_suffix('\\') {
            push(before, false);
            push(&mark[..1], false);
            rest = after;
            continue;
        }
        push(before, false);
        rest = if let Some((group, after)) = after.strip_prefix('{').and_then(|group| group.split_once('}')) {
            push(group, true);
            after
        } else if let Some(next) = after.chars().next() {
            let (next, after) = after.split_at(next.len_utf8());
            push(next, true);
            after
        } else {
            push(mark, false);
            after
        };
    }
    push(rest, false);
    runs.retain(|run| !run.text.is_empty());
    runs
}

/// An outline moved by some pixels.
pub fn moved(outline: &[Element], by: [f32; 2]) -> Vec<Element> {
    let at = |p: [f32; 2]| [p[0] + by[0], p[1] + by[1]];
    let element = |element: &Element| match *element {
        Element::Move(p) => Element::Move(at(p)),
        Element::Line(p) => Element::Line(at(p)),
        Element::Quad(c, p) => Element::Quad(at(c), at(p)),
        Element::Cubic(a, b, p) => Element::Cubic(at(a), at(b), at(p)),
        Element::Close => Element::Close,
    };
    outline.iter().map(element).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subscripts_are_found() {
        let cases: [(&str, &str); 8] = [
            ("x_c", "x[c]"),
            ("M_{prp}·p", "M[prp]·p"),
            ("a_", "a_"),
            ("_{", "[{]"),
            ("", ""),
            ("_é_ç", "[é][ç]"),
            ("p_{}q", "pq"),
            ("a__b", "a[_]b"),
        ];
        for (text, expected) in cases {
            let found: String = runs(text)
                .iter()
                .map(|r| if r.lowered { format!("[{}]", r.text) } else { r.text.to_owned() })
                .collect();
            assert_eq!(found, expected, "{text}");
        }
    }
}
