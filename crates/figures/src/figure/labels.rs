//! The author's changes of the labels in the pictures, and the author's notes: the `[labels]` section of a figure.

use glam::{DVec2, DVec3};

use super::{Measure, View, near};
use crate::appearance::Rgba;
pub use crate::formula::symbols;
use crate::formula::{self, FormulaError};
use crate::limits::MAX_LABEL_TEXT;

/// The `[labels]` section. The default leaves every label as the pictures make it.
///
/// Labels are identified by their names. Those of the notes (`C`, `PF`, `u`, `near`) are the same in every language and
/// stay if the text changes. Several labels of a picture may have one name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Labels {
    /// The letters of all labels.
    pub letters: Letters,
    /// The names of hidden labels.
    pub hidden: Vec<String>,
    /// Labels with other texts.
    pub renamed: Vec<RenamedLabel>,
    /// Labels at places that the author chose.
    pub moved: Vec<MovedLabel>,
    /// Labels of other sizes and colours.
    pub styled: Vec<StyledLabel>,
    /// Lengths and angles shown in the world.
    pub measures: Vec<LabelledMeasure>,
    /// The author's notes.
    pub notes: Vec<Note>,
}

/// The letters of labels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Letters {
    /// The letters of the window, without serifs.
    #[default]
    Plain,
    /// The letters of the explanations: vectors bold, other symbols in italics.
    Mathematics,
}

/// A label with another text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RenamedLabel {
    /// The name of the label, as `label_names` gives it.
    pub name: String,
    /// The picture; `None` means all of them.
    pub view: Option<View>,
    /// Its text. Between dollar signs, mathematics ([`set_text`]).
    pub text: String,
}

/// A label at a place that the author chose.
#[derive(Clone, Debug, PartialEq)]
pub struct MovedLabel {
    /// The name of the label, as `label_names` gives it.
    pub name: String,
    /// The picture; `None` means all of them.
    pub view: Option<View>,
    /// From the label's point to the middle of its text, to the right and upwards, in heights of its type.
    pub by: DVec2,
}

/// A label of another size or colour.
#[derive(Clone, Debug, PartialEq)]
pub struct StyledLabel {
    /// The name of the label, as `label_names` gives it.
    pub name: String,
    /// The factor of its size.
    pub size: Option<f64>,
    /// The colour of its letters.
    pub color: Option<Rgba>,
}

/// A length or an angle shown in the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LabelledMeasure {
    /// The length or angle.
    pub measure: Measure,
    /// The text at it.
    pub shown: MeasureText,
}

/// The text of a measure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum MeasureText {
    /// F
    Symbol,
    /// 2.5
    Value,
    /// F = 2.5
    #[default]
    Both,
}

/// A note of the author's.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// The picture; `None` means all of them. A note at a place of the picture is in one only.
    pub view: Option<View>,
    /// The point, vertex, edge or place in the view that it belongs to.
    pub at: NotePlace,
    /// From there to the middle of its text, like [`MovedLabel::by`]; `None` places it where there's room.
    pub by: Option<DVec2>,
    /// Its text, as [`RenamedLabel::text`].
    pub text: String,
    /// The factor of its size.
    pub size: Option<f64>,
    /// The colour of its letters.
    pub color: Option<Rgba>,
}

/// The subject of a note.
#[derive(Clone, Debug, PartialEq)]
pub enum NotePlace {
    /// A point of the world.
    World(DVec3),
    /// A vertex of an object's mesh, from 0.
    Vertex {
        /// The name of an object in the scene.
        object: String,
        /// The index of the vertex.
        vertex: u32,
    },
    /// The middle of an edge of an object's mesh, from 0.
    Edge {
        /// The name of an object in the scene.
        object: String,
        /// The index of the edge.
        edge: u32,
    },
    /// A place of the picture, where (0, 0) is its lower left corner, and (1, 1) its upper right one.
    Picture(DVec2),
}

/// The changes of one label in one picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LabelChange<'a> {
    /// True if it's hidden.
    pub hidden: bool,
    /// `None` if the label keeps its own text.
    pub text: Option<&'a str>,
    /// Its place, as [`MovedLabel::by`].
    pub by: Option<DVec2>,
    /// The factor of its size.
    pub size: Option<f64>,
    /// The colour of its letters.
    pub color: Option<Rgba>,
}

impl LabelChange<'_> {
    /// True if the author left the label unchanged.
    pub fn is_automatic(&self) -> bool {
        *self == Self::default()
    }
}

impl Labels {
    /// The changes of a label in a picture. A place or a text for one picture takes precedence over one for all.
    pub fn change(&self, name: &str, view: View) -> LabelChange<'_> {
        if let Some(note) = note_index(name).and_then(|i| self.notes.get(i)) {
            // A text for a place of the picture stands there.
            let there = matches!(note.at, NotePlace::Picture(_)).then_some(DVec2::ZERO);
            return LabelChange {
                hidden: false,
                text: Some(&note.text),
                by: note.by.or(there),
                size: note.size,
                color: note.color,
            };
        }
        let moves = |moved: &&MovedLabel| moved_as(&moved.name) == moved_as(name);
        let moved = |view: Option<View>| self.moved.iter().filter(moves).find(|moved| moved.view == view);
        let style = self.styled.iter().find(|style| style.name == name);
        let renamed =
            |view: Option<View>| self.renamed.iter().find(|renamed| renamed.name == name && renamed.view == view);
        LabelChange {
            hidden: self.hidden.iter().any(|hidden| hidden == name),
            text: renamed(Some(view)).or_else(|| renamed(None)).map(|renamed| renamed.text.as_str()),
            by: moved(Some(view)).or_else(|| moved(None)).map(|moved| moved.by),
            size: style.and_then(|style| style.size),
            color: style.and_then(|style| style.color),
        }
    }

    /// Moves a label in one picture, or a note in all of its pictures.
    pub fn move_to(&mut self, name: &str, view: View, by: DVec2) {
        if let Some(note) = self.note_mut(name) {
            note.by = Some(by);
            return;
        }
        let name = moved_as(name);
        match self.moved.iter_mut().find(|moved| moved_as(&moved.name) == name && moved.view == Some(view)) {
            Some(moved) => moved.by = by,
            None => self.moved.push(MovedLabel { name: name.to_owned(), view: Some(view), by }),
        }
    }

    /// Gives a label another text, in one picture or in all of them.
    pub fn rename(&mut self, name: &str, view: Option<View>, text: &str) {
        if let Some(note) = self.note_mut(name) {
            text.clone_into(&mut note.text);
            return;
        }
        self.renamed.retain(|renamed| renamed.name != name || renamed.view != view);
        self.renamed.push(RenamedLabel { name: name.to_owned(), view, text: text.to_owned() });
    }

    /// Hides a label, or removes a note.
    pub fn hide(&mut self, name: &str) {
        if let Some(i) = note_index(name) {
            if i < self.notes.len() {
                self.notes.remove(i);
            }
        } else if !self.hidden.iter().any(|hidden| hidden == name) {
            self.hidden.push(name.to_owned());
        }
    }

    /// Shows a hidden label again.
    pub fn show(&mut self, name: &str) {
        self.hidden.retain(|hidden| hidden != name);
    }

    /// Gives a label another size and colour.
    pub fn style(&mut self, name: &str, size: Option<f64>, color: Option<Rgba>) {
        if let Some(note) = self.note_mut(name) {
            (note.size, note.color) = (size, color);
            return;
        }
        self.styled.retain(|styled| styled.name != name);
        if size.is_some() || color.is_some() {
            self.styled.push(StyledLabel { name: name.to_owned(), size, color });
        }
    }

    /// Shows a length or an angle with a text, or hides it.
    pub fn measure(&mut self, measure: Measure, shown: Option<MeasureText>) {
        match (self.measures.iter_mut().find(|labelled| labelled.measure == measure), shown) {
            (Some(labelled), Some(shown)) => labelled.shown = shown,
            (None, Some(shown)) => self.measures.push(LabelledMeasure { measure, shown }),
            (_, None) => self.measures.retain(|labelled| labelled.measure != measure),
        }
    }

    /// Leaves a label to the pictures again. A note stays, at a place with room for it.
    pub fn reset(&mut self, name: &str) {
        if let Some(note) = self.note_mut(name) {
            (note.by, note.size, note.color) = (None, None, None);
            return;
        }
        self.show(name);
        self.renamed.retain(|renamed| renamed.name != name);
        self.moved.retain(|moved| moved_as(&moved.name) != moved_as(name));
        self.styled.retain(|styled| styled.name != name);
    }

    /// Leaves all labels to the pictures again, with the notes as [`reset`](Self::reset) leaves them.
    pub fn reset_all(&mut self) {
        for i in 0..self.notes.len() {
            self.reset(&note_name(i));
        }
        *self = Self {
            letters: self.letters,
            measures: std::mem::take(&mut self.measures),
            notes: std::mem::take(&mut self.notes),
            ..Self::default()
        };
    }

    /// The part of it that's visible in a picture of a kind.
    #[must_use]
    pub fn seen_in(&self, view: View) -> Self {
        let mut seen = self.clone();
        seen.moved.retain(|moved| moved.view.is_none_or(|of| of == view));
        seen.renamed.retain(|renamed| renamed.view.is_none_or(|of| of == view));
        if view != View::World {
            seen.measures.clear();
        }
        seen
    }

    /// Every name in it, except for notes.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let renamed = self.renamed.iter().map(|renamed| renamed.name.as_str());
        let moved = self.moved.iter().map(|moved| moved.name.as_str());
        let styled = self.styled.iter().map(|styled| styled.name.as_str());
        self.hidden.iter().map(String::as_str).chain(renamed).chain(moved).chain(styled)
    }

    /// The names that are neither in `known` nor `allowed`, each once, with the name that the author probably meant.
    pub fn unknown(&self, known: &[&str], allowed: impl Fn(&str) -> bool) -> Vec<(String, Option<String>)> {
        let mut unknown: Vec<(String, Option<String>)> = Vec::new();
        for name in self.names().filter(|name| !known.contains(name) && !allowed(name)) {
            if !unknown.iter().any(|(other, _)| other == name) {
                unknown.push((name.to_owned(), near::name(name, known)));
            }
        }
        unknown
    }

    /// Follows an object to another name.
    pub fn rename_object(&mut self, from: &str, to: &str) {
        for note in &mut self.notes {
            if let NotePlace::Vertex { object, .. } | NotePlace::Edge { object, .. } = &mut note.at
                && object == from
            {
                to.clone_into(object);
            }
        }
    }

    fn note_mut(&mut self, name: &str) -> Option<&mut Note> {
        self.notes.get_mut(note_index(name)?)
    }
}

/// The beginning of the name of a note. Its number follows, from 1.
const NOTE: &str = "note:";

/// The name of the label of a note, by its place in the list.
pub fn note_name(index: usize) -> String {
    format!("{NOTE}{}", index + 1)
}

/// The place in the list of the note whose label has this name; `None` for other labels.
pub fn note_index(name: &str) -> Option<usize> {
    name.strip_prefix(NOTE)?.parse::<usize>().ok()?.checked_sub(1)
}

/// The name of a legend as a whole, for hiding, moving and styling it.
pub const LEGEND: &str = "legend";

/// True for the name of a line of a legend: `legend:depth`.
pub fn is_in_legend(name: &str) -> bool {
    name.strip_prefix(LEGEND).is_some_and(|rest| rest.starts_with(':'))
}

/// The name under which a label moves, because a legend moves as a whole.
fn moved_as(name: &str) -> &str {
    if is_in_legend(name) { LEGEND } else { name }
}

/// The reason why a text can't be that of a label.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LabelTextError {
    /// It has no letters, several lines, or too many letters.
    #[error("a label has 1 … {MAX_LABEL_TEXT} characters on one line")]
    Length,
    /// A formula that a label can't show.
    #[error(transparent)]
    Formula(#[from] FormulaError),
}

/// The text set in a picture. Mathematics between dollar signs becomes symbols, `$\theta_c$` → `θ_c`, and
/// `$\mathbf{u}$` a bold letter.
///
/// # Errors
/// [`LabelTextError`]
pub fn set_text(text: &str) -> Result<String, LabelTextError> {
    let is_line = !text.trim().is_empty() && !text.contains(crate::sanitize::is_obeyed);
    if !is_line || text.chars().count() > MAX_LABEL_TEXT {
        return Err(LabelTextError::Length);
    }
    Ok(formula::set(text)?)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::figure::read::parse;

    fn labels(text: &str) -> Labels {
        parse(text).unwrap().labels
    }

    #[test]
    fn a_label_has_the_changes_of_its_name_and_a_place_for_one_picture_counts_more() {
        let labels = labels(
            "[labels]\nhidden = [\"VUP\"]\n[[labels.renamed]]\nname = \"C\"\ntext = \"eye\"\n\
             [[labels.moved]]\nname = \"C\"\nby = [1, 2]\n[[labels.moved]]\nname = \"C\"\nview = \"image\"\nby = [3, 4]\n\
             [[labels.styled]]\nname = \"C\"\nsize = 2\ncolor = \"#ff0000\"\n",
        );
        assert!(labels.change("VUP", View::World).hidden && labels.change("u", View::World).is_automatic());
        let of = |view| labels.change("C", view);
        assert_eq!((of(View::World).by, of(View::Image).by), (Some(DVec2::new(1.0, 2.0)), Some(DVec2::new(3.0, 4.0))));
        assert_eq!((of(View::World).text, of(View::World).size), (Some("eye"), Some(2.0)));
        assert_eq!(of(View::World).color, Some(Rgba::rgb(255, 0, 0)));
        assert_eq!(labels.seen_in(View::World).moved.len(), 1);
    }

    #[test]
    fn a_label_is_renamed_in_one_view_or_in_all() {
        let mut labels = labels("[[labels.renamed]]\nname = \"far\"\nview = \"world\"\ntext = \"back\"\n");
        let text = |labels: &Labels, view| labels.change("far", view).text.map(str::to_owned);
        assert_eq!(text(&labels, View::World).as_deref(), Some("back"));
        assert_eq!(text(&labels, View::Canonical), None);
        labels.rename("far", None, "end");
        assert_eq!(text(&labels, View::World).as_deref(), Some("back"), "the text of one view comes first");
        assert_eq!(text(&labels, View::Canonical).as_deref(), Some("end"));
        labels.rename("far", Some(View::World), "rear");
        assert_eq!((labels.renamed.len(), text(&labels, View::World).as_deref()), (2, Some("rear")));
        labels.reset("far");
        assert_eq!(text(&labels, View::World), None);
    }

    #[test]
    fn automatic_undoes_changes_to_labels_and_keeps_notes() {
        let note = "[[labels.notes]]\nat = [0, 1, 2]\ntext = \"here\"\n";
        let before = labels(note);
        let mut after = before.clone();
        for name in ["C", "note:1"] {
            after.move_to(name, View::World, DVec2::X);
            after.rename(name, None, "eye");
            after.style(name, Some(2.0), None);
        }
        after.hide("u");
        assert_eq!(after.notes[0].by, Some(DVec2::X));
        let mut one = after.clone();
        one.reset("C");
        one.reset("u");
        assert!(one.change("C", View::World).is_automatic() && one.hidden.is_empty());
        after.reset_all();
        assert_eq!(after.notes[0], Note { text: "eye".to_owned(), ..before.notes[0].clone() });
        assert_eq!(Labels { notes: Vec::new(), ..after.clone() }, Labels::default());
        after.hide("note:1");
        assert_eq!(after, Labels::default());
    }

    #[test]
    fn names_of_notes_are_their_numbers() {
        assert_eq!((note_name(0).as_str(), note_index("note:12")), ("note:1", Some(11)));
        for other in ["note", "note:", "note:0", "note:x", "C", "note:99999999999999999999999"] {
            assert_eq!(note_index(other), None, "{other}");
        }
    }

    #[test]
    fn impossible_labels_are_refused_with_their_line() {
        let long = format!("[[labels.renamed]]\nname = \"C\"\ntext = \"{}\"\n", "x".repeat(MAX_LABEL_TEXT + 1));
        let many = format!("[labels]\nhidden = [{}]\n", "\"C\", ".repeat(crate::limits::MAX_LABELS + 1));
        for (text, line, key) in [
            ("[[labels.moved]]\nname = \"C\"\nby = [1e9, 0]\n", 3, "by"),
            ("[[labels.moved]]\nname = \"C\"\nby = [\"1/0\", 0]\n", 3, "by"),
            ("[[labels.moved]]\nname = \"C\"\n", 1, "by"),
            ("[[labels.moved]]\nname = \"C\"\nview = \"wordl\"\nby = [1, 0]\n", 3, "view"),
            ("[[labels.renamed]]\nname = \"C\"\ntext = \"\"\n", 3, "text"),
            ("[[labels.renamed]]\nname = \"C\"\ntext = \"a\\nb\"\n", 3, "text"),
            ("[[labels.renamed]]\nname = \"C\"\ntext = '$\\input{x}$'\n", 3, "text"),
            ("[[labels.renamed]]\nname = \"C\"\ntext = '$\\begin{matrix}1\\end{matrix}$'\n", 3, "text"),
            ("[[labels.styled]]\nname = \"C\"\nsize = 1e30\n", 3, "size"),
            ("[[labels.measures]]\nname = \"Q\"\n", 2, "name"),
            ("[[labels.notes]]\nat = [0.5, 0.5]\ntext = \"n\"\n", 1, "view"),
            ("[[labels.notes]]\nview = \"image\"\nat = [0.5, 1.5]\ntext = \"n\"\n", 3, "at"),
            ("[[labels.notes]]\nat = { object = \"box\" }\ntext = \"n\"\n", 2, "vertex"),
            ("[[labels.notes]]\nat = { object = \"box\", vertex = 1, edge = 2 }\ntext = \"n\"\n", 2, "edge"),
            ("[[labels.notes]]\nat = 7\ntext = \"n\"\n", 2, "at"),
            ("[labels]\nhiden = []\n", 2, "hiden"),
            (&long, 3, "text"),
            (&many, 2, "hidden"),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.line == line && error.key.contains(key), "{text}: {error}");
        }
    }
}
