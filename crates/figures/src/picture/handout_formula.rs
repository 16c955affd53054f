//! Formulas of a handout on lines of their own, with matrices in rows between brackets.

use crate::appearance::Rgba;
use crate::drawing::Anchor;
use crate::export::vector::Item;
use crate::text::{self, Element, measure};

/// The colour of letters.
pub(super) const INK: Rgba = Rgba::rgb(0x1a, 0x1a, 0x1a);

/// The gap between the columns of a matrix, and between its bracket and its entries, in heights of the letters.
const COLUMNS: f32 = 1.0;
const INSIDE: f32 = 0.35;
/// From row to row.
const ROWS: f32 = 1.4;
/// The gap beside a matrix.
const BESIDE: f32 = 0.3;

/// A part of a formula. `_c` and `_{abc}` in its texts are subscripts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FormulaPart {
    /// Signs on a line.
    Line(String),
    /// The rows of a matrix.
    Matrix(Vec<Vec<String>>),
}

/// A formula, laid out at (0, 0).
pub(super) struct SetFormula {
    pub(super) items: Vec<Item>,
    pub(super) height: f32,
}

impl FormulaPart {
    fn width(&self, size: f32) -> f32 {
        match self {
            Self::Line(text) => measure(text, size, false).width,
            Self::Matrix(rows) => {
                let columns = widths(rows, size);
                let gaps = columns.len().saturating_sub(1) as f32;
                columns.iter().sum::<f32>() + (gaps * COLUMNS + 2.0 * (INSIDE + BESIDE)) * size
            }
        }
    }

    fn height(&self, size: f32) -> f32 {
        match self {
            Self::Line(_) => ROWS * size,
            Self::Matrix(rows) => rows.len() as f32 * ROWS * size,
        }
    }
}

/// A text that begins at a place, on its baseline.
pub(super) fn written(text: String, at: [f32; 2], size: f32, color: Rgba) -> Item {
    Item::text(text, at, size, color, Anchor::Left)
}

/// Sets a formula. If a line has no space for a part, the part begins another line.
pub(super) fn set(parts: &[FormulaPart], size: f32, width: f32) -> SetFormula {
    let parts: Vec<FormulaPart> = parts.iter().flat_map(|part| broken(part, size, width)).collect();
    let mut lines: Vec<Vec<&FormulaPart>> = Vec::new();
    let mut x = 0.0;
    for part in &parts {
        let wide = part.width(size);
        match lines.last_mut().filter(|_| x + wide <= width) {
            Some(line) => line.push(part),
            None => {
                lines.push(vec![part]);
                x = 0.0;
            }
        }
        x += wide;
    }
    let mut formula = SetFormula { items: Vec::new(), height: 0.0 };
    for line in lines {
        let height = line.iter().map(|part| part.height(size)).fold(0.0, f32::max);
        let middle = formula.height + 0.5 * height;
        let mut x = 0.0;
        for part in line {
            match part {
                FormulaPart::Line(text) => {
                    formula.items.push(written(text.clone(), [x, middle + 0.35 * size], size, INK));
                }
                FormulaPart::Matrix(rows) => matrix(rows, [x, middle], size, &mut formula.items),
            }
            x += part.width(size);
        }
        formula.height += height;
    }
    formula
}

/// A line that's wider than its space, broken after brackets. Anything else stays as it is.
fn broken(part: &FormulaPart, size: f32, width: f32) -> Vec<FormulaPart> {
    let FormulaPart::Line(text) = part else { return vec![part.clone()] };
    let lines = text::broken(text.split_inclusive(") "), |line| measure(line, size, false).width <= width);
    lines.into_iter().map(FormulaPart::Line).collect()
}

fn widths(rows: &[Vec<String>], size: f32) -> Vec<f32> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |row: &Vec<String>, k: usize| row.get(k).map_or(0.0, |entry| measure(entry, size, false).width);
    (0..columns).map(|k| rows.iter().map(|row| width(row, k)).fold(0.0, f32::max)).collect()
}

/// Draws a matrix from `left` on about the height `middle`.
fn matrix(rows: &[Vec<String>], [left, middle]: [f32; 2], size: f32, items: &mut Vec<Item>) {
    let half = 0.5 * rows.len() as f32 * ROWS * size;
    let columns = widths(rows, size);
    let mut y = middle - half;
    let mut right = left;
    for row in rows {
        let mut x = left + (BESIDE + INSIDE) * size;
        for (entry, width) in row.iter().zip(&columns) {
            // Entries stand in the middle of their column, as in print.
            let at = [x + 0.5 * width, y + (0.5 * ROWS + 0.35) * size];
            items.push(Item::text(entry.clone(), at, size, INK, Anchor::Center));
            x += width + COLUMNS * size;
        }
        right = right.max(x - COLUMNS * size + INSIDE * size);
        y += ROWS * size;
    }
    let (foot, inset) = (0.25 * size, 0.08 * size);
    for (x, foot) in [(left + BESIDE * size, foot), (right, -foot)] {
        let path = vec![
            Element::Move([x + foot, middle - half + inset]),
            Element::Line([x, middle - half + inset]),
            Element::Line([x, middle + half - inset]),
            Element::Line([x + foot, middle + half - inset]),
        ];
        items.push(Item::stroke(path, INK, 0.07 * size, false));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_has_its_entries_in_rows_and_columns_between_brackets() {
        let row = |row: [&str; 2]| row.map(str::to_owned).to_vec();
        let parts = [
            FormulaPart::Line("M =".to_owned()),
            FormulaPart::Matrix(vec![row(["1", "−20"]), row(["0", "1"]), row(["5", "6"])]),
        ];
        let wide = set(&parts, 10.0, 300.0);
        let place = |wanted: &str| {
            let texts = wide.items.iter().filter_map(|item| match item {
                Item::Text(text) => Some((&text.text, text.at)),
                _ => None,
            });
            texts.filter(|(text, _)| *text == wanted).map(|(_, at)| at).collect::<Vec<_>>()
        };
        let [ones, wide_entry] = [place("1"), place("−20")];
        assert_eq!(ones[0][1], wide_entry[0][1], "one row");
        assert_eq!(ones[0][0], place("0")[0][0], "one column");
        assert!(ones[0][1] < ones[1][1] && place("M =")[0][1] == place("0")[0][1], "about the middle");
        assert!(wide_entry[0][0] < ones[1][0], "a narrow entry stands in the middle of its column");
        assert_eq!(wide.items.iter().filter(|item| matches!(item, Item::Stroke { .. })).count(), 2);
        assert_eq!(wide.height, 3.0 * ROWS * 10.0);
        let axes = [FormulaPart::Line("u = (1, 0, 0) v = (0, 1, 0)".to_owned())];
        assert_eq!(set(&axes, 10.0, 400.0).height, ROWS * 10.0);
        assert_eq!(set(&axes, 10.0, 90.0).height, 2.0 * ROWS * 10.0, "what is too wide goes on below");
        let narrow = set(&parts, 10.0, 40.0);
        assert_eq!(narrow.height, 4.0 * ROWS * 10.0, "the matrix has a line of its own");
    }
}
