//! The notes: a short text for each symbol, operation, equation, step and stage, in both languages, written in
//! `assets/notes`.
//!
//! A file is read line by line. `# ` begins a group, `## id: title` a note, `$$…$$` is an equation set apart, `≠ `
//! begins an erratum of the lecture notes, `[` the place in them, `→ ` the identifiers of other notes. Every other line
//! is a paragraph, with mathematics between `$`.

use std::sync::OnceLock;

use crate::camera::{Freedom, Step};
use crate::explain::{Axis, Component, Matrix, Symbol};
use crate::pipeline::Stage;
use crate::window::search::{folded, has_words};
use crate::{Lang, pages};

/// A piece of a paragraph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Words.
    Words(&'static str),
    /// LaTeX, no higher than a line.
    Mathematics(&'static str),
}

/// A note in one language.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Note {
    /// The identifier, the same in both languages: `F`, `5.13`, `stage-clip`.
    pub id: &'static str,
    /// Its heading, with the symbol.
    pub title: &'static str,
    /// Its group.
    pub group: &'static str,
    /// Equations, in LaTeX.
    pub equations: Vec<&'static str>,
    /// Its text.
    pub paragraphs: Vec<Vec<Piece>>,
    /// Errata of the lecture notes.
    pub errata: Vec<Vec<Piece>>,
    /// Its place in the lecture notes. Empty if it has none.
    pub source: &'static str,
    /// The identifiers of other notes.
    pub links: Vec<&'static str>,
    /// Its whole text, as [`folded`].
    searched: String,
}

impl Note {
    /// True if it contains all words of `wanted`, ignoring accents and case. Without words, it does.
    pub fn says(&self, wanted: &str) -> bool {
        has_words(&self.searched, wanted)
    }

    /// All its words, without accents and capitals.
    pub fn searched(&self) -> &str {
        &self.searched
    }

    /// True if all words of `wanted` are in its heading.
    pub fn is_headed(&self, wanted: &str) -> bool {
        has_words(&folded(self.title), wanted)
    }

    fn finish(mut self) -> Self {
        let mut said = format!("{} {} ", self.id, self.title);
        for equation in &self.equations {
            said.push_str(&plain(equation));
            said.push(' ');
        }
        for piece in self.paragraphs.iter().chain(&self.errata).flatten() {
            match piece {
                Piece::Words(words) => said.push_str(words),
                Piece::Mathematics(latex) => said.push_str(&plain(latex)),
            }
        }
        said.push(' ');
        said.push_str(self.source);
        self.searched = folded(&said);
        self
    }
}

/// The page that describes the texts `[0]` … `[4]` and the spaces.
pub const SOURCES: &str = "sources";

/// By the numbers of the languages.
static NOTES: [OnceLock<Vec<Note>>; Lang::ALL.len()] = [const { OnceLock::new() }; Lang::ALL.len()];

/// All notes, in reading order.
pub fn notes(lang: Lang) -> &'static [Note] {
    NOTES[lang as usize].get_or_init(|| read(pages::notes(lang)))
}

/// The note with this identifier.
pub fn note(lang: Lang, id: &str) -> Option<&'static Note> {
    notes(lang).iter().find(|note| note.id == id)
}

fn read(text: &'static str) -> Vec<Note> {
    let (mut notes, mut group): (Vec<Note>, &str) = (Vec::new(), "");
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
        if let Some(heading) = line.strip_prefix("## ") {
            let (id, title) = heading.split_once(": ").unwrap_or((heading, heading));
            notes.push(Note { id, title, group, ..Note::default() });
        } else if let Some(name) = line.strip_prefix("# ") {
            group = name;
        } else if let Some(note) = notes.last_mut() {
            take(note, line);
        }
    }
    notes.into_iter().map(Note::finish).collect()
}

fn take(note: &mut Note, line: &'static str) {
    if let Some(latex) = line.strip_prefix("$$").and_then(|rest| rest.strip_suffix("$$")) {
        note.equations.push(latex);
    } else if let Some(links) = line.strip_prefix("→ ") {
        note.links.extend(links.split(", "));
    } else if let Some(erratum) = line.strip_prefix("≠ ") {
        note.errata.push(pieces(erratum));
    } else if line.starts_with('[') {
        note.source = line;
    } else {
        note.paragraphs.push(pieces(line));
    }
}

fn pieces(line: &'static str) -> Vec<Piece> {
    let piece = |(i, part)| if i % 2 == 0 { Piece::Words(part) } else { Piece::Mathematics(part) };
    line.split('$').enumerate().map(piece).filter(|piece| *piece != Piece::Words("")).collect()
}

/// A text in Markdown, with its mathematics between dollar signs.
pub fn markdown(pieces: &[Piece]) -> String {
    let piece = |piece: &Piece| match piece {
        Piece::Words(words) => (*words).to_owned(),
        Piece::Mathematics(latex) => format!("${latex}$"),
    };
    pieces.iter().map(piece).collect()
}

/// LaTeX of the notes in a line, for screen readers, and for the search.
pub fn plain(latex: &str) -> String {
    let (mut text, mut rest) = (String::new(), latex);
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        match c {
            '\\' => rest = command(&mut text, rest),
            '{' | '}' => {}
            '&' => text.push(','),
            '-' => text.push('−'),
            c => text.push(c),
        }
    }
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Markdown in a line, without its marks and with its formulas in plain signs.
pub fn line(markdown: &str) -> String {
    let part = |(k, part): (usize, &str)| if k % 2 == 1 { plain(part) } else { part.replace(['*', '`'], "") };
    markdown.split('$').enumerate().map(part).collect()
}

/// Writes the command after a backslash. Returns the text after it.
fn command<'a>(text: &mut String, rest: &'a str) -> &'a str {
    let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
    // A sign is a command by itself.
    let end = if letters == 0 { rest.chars().next().map_or(0, char::len_utf8) } else { letters };
    let (name, rest) = rest.split_at(end);
    match name {
        "frac" => {
            let (above, rest) = argument(rest);
            let (below, rest) = argument(rest);
            text.push_str(&format!("{}/{}", held(&plain(above)), held(&plain(below))));
            return rest;
        }
        "sqrt" => {
            let (under, rest) = argument(rest);
            text.push_str(&format!("√{}", held(&plain(under))));
            return rest;
        }
        // Written as a power.
        "circ" => {
            if text.ends_with('^') {
                text.pop();
            }
            text.push('°');
        }
        "begin" | "end" => {
            text.push(if name == "begin" { '[' } else { ']' });
            return argument(rest).1;
        }
        "\\" | "quad" | "qquad" => text.push_str("; "),
        "|" => text.push('‖'),
        "cdot" => text.push('·'),
        "times" => text.push('×'),
        "alpha" => text.push('α'),
        "beta" => text.push('β'),
        "delta" => text.push('δ'),
        "theta" => text.push('θ'),
        "lambda" => text.push('λ'),
        "rho" => text.push('ρ'),
        "Delta" => text.push('Δ'),
        "le" => text.push('≤'),
        "ne" => text.push('≠'),
        "lfloor" => text.push('⌊'),
        "rfloor" => text.push('⌋'),
        "," | ";" | ":" | "!" => text.push(' '),
        // Only of how it looks.
        "mathbf" | "mathrm" | "mathit" | "left" | "right" => {}
        // A function, such as tan.
        _ => text.push_str(name),
    }
    rest
}

/// A part of a fraction or under a root, in brackets unless it's short.
fn held(part: &str) -> String {
    if part.contains([' ', '+', '−', '/']) { format!("({part})") } else { part.to_owned() }
}

/// The text in braces, and the text after them.
fn argument(rest: &str) -> (&str, &str) {
    let mut depth = 0;
    for (at, c) in rest.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 1 => return (&rest[1..at], &rest[at + 1..]),
            '}' => depth -= 1,
            _ => {}
        }
    }
    (rest, "")
}

/// The note on a symbol.
pub const fn of_symbol(symbol: Symbol) -> &'static str {
    match symbol {
        Symbol::Axis(Axis::U, _) => "u",
        Symbol::Axis(Axis::V, _) => "v",
        Symbol::Axis(Axis::N, _) => "n",
        Symbol::Position(_) => "C",
        Symbol::FocalPoint(_) => "PF",
        Symbol::ViewUp(_) => "VUP",
        Symbol::Distance => "D",
        Symbol::Near => "F",
        Symbol::Far => "B",
        Symbol::Left | Symbol::Right | Symbol::Bottom | Symbol::Top => "window",
        Symbol::Width => "W",
        Symbol::Height => "H",
        Symbol::Aspect => "A",
        Symbol::ViewAngle => "theta",
        Symbol::ImageWidth | Symbol::ImageHeight => "image",
        Symbol::ViewportX | Symbol::ViewportY | Symbol::ViewportWidth | Symbol::ViewportHeight => "viewport-rectangle",
        Symbol::DepthNear | Symbol::DepthFar => "depth-range",
        Symbol::Translate(_) => "translation",
        Symbol::Rotate(_) => "rotation",
        Symbol::Scale(_) => "scale",
        Symbol::Entry(matrix, ..) => of_matrix(matrix),
        Symbol::Local(_) => "local",
        Symbol::World(_) => "world",
        Symbol::View(_) => "view",
        Symbol::Clip(Component::W) => "w",
        Symbol::Clip(_) => "clip",
        Symbol::Homogeneous(_) => "homogeneous",
        Symbol::Ndc(_) => "ndc",
        Symbol::Window(_) => "on-window",
        Symbol::Pixel(_) => "pixel",
        Symbol::Viewport(Component::Z) => "Z",
        Symbol::Viewport(_) => "viewport-point",
    }
}

/// The note on a matrix.
pub const fn of_matrix(matrix: Matrix) -> &'static str {
    match matrix {
        Matrix::Model | Matrix::Parent => "M_m",
        Matrix::View => "M_v",
        Matrix::Projection => "M_p",
        Matrix::ViewProjection => "M_pM_v",
        Matrix::Viewport => "M_vp",
        Matrix::InverseModel
        | Matrix::InverseParent
        | Matrix::InverseView
        | Matrix::InverseProjection
        | Matrix::InverseViewProjection
        | Matrix::InverseViewport => "inverse",
    }
}

/// The note on the first equation of `[0]` that a text names: `5.7` for `(5.7), p − C`.
pub fn of_equation(text: &str) -> Option<&'static str> {
    let number = text.split_once('(')?.1.split_once(')')?.0;
    note(Lang::En, number).map(|note| note.id)
}

/// The note on an operation.
pub const fn of_operation(freedom: Freedom) -> &'static str {
    match freedom {
        Freedom::Elevation => "elevation",
        Freedom::Azimuth => "azimuth",
        Freedom::Roll => "roll",
        Freedom::Yaw => "yaw",
        Freedom::Pitch => "pitch",
        Freedom::Zoom => "zoom",
        Freedom::Dolly => "dolly",
        Freedom::PanU | Freedom::PanV => "pan",
    }
}

/// The note on a step to the canonical volume.
pub const fn of_step(step: Step) -> &'static str {
    match step {
        Step::ToEye => "step-to-eye",
        Step::Turn => "step-turn",
        Step::TurnLeftHanded => "step-turn-left-handed",
        Step::ClipRows => "step-clip-rows",
        Step::Divide => "step-divide",
        Step::Box => "step-box",
        Step::Centre => "step-centre",
        Step::Scale => "step-scale",
        Step::Pers => "step-pers",
        Step::XyScale => "step-xy-scale",
        Step::UnitSlope => "step-unit-slope",
        Step::UnitDepth => "step-unit-depth",
        Step::CanonicalBox => "step-canonical-box",
        Step::NearToOrigin => "step-near-to-origin",
        Step::ScaleOrt => "step-scale-ort",
    }
}

/// The note on a stage of the pipeline.
pub fn of_stage(stage: Stage) -> &'static str {
    let of_it = |note: &&Note| note.id.strip_prefix("stage-") == Some(stage.name());
    notes(Lang::En).iter().find(of_it).map(|note| note.id).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn a_formula_in_a_line_loses_none_of_its_signs() {
        for (latex, line) in [
            (r"F \tan \frac{\theta}{2}", "F tan θ/2"),
            (r"0.8 \cdot \tan(40^\circ/2)", "0.8 · tan(40°/2)"),
            (r"\frac{-\frac{4}{7}}{\sqrt{17}/7}", "(−4/7)/(√17/7)"),
            (r"\left(\alpha + \beta\right) \ne \mathbf{u}", "(α + β) ≠ u"),
        ] {
            assert_eq!(plain(latex), line);
        }
    }
}
