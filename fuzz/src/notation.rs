//! Tables as people write them.

use arbitrary::Arbitrary;
use camera_lab::exercises::{Kind, Table};

/// How brackets and separators are written.
#[derive(Arbitrary, Clone, Copy, Debug)]
pub enum Notation {
    /// `[1, 2]`, `[[1, 2], [3, 4]]`
    Brackets,
    /// `(1; 2)`, `[1; 2] [3; 4]` in brackets
    Semicolons,
    /// `1, 2`, one row a line
    Lines,
}

impl Notation {
    /// The cells of a table, row by row, as text. A vector lies.
    pub fn table(self, kind: &Kind, rows: usize, cells: &[String]) -> String {
        let (comma, open, close) = match self {
            Self::Brackets => (", ", "[", "]"),
            Self::Semicolons => ("; ", "[", "]"),
            Self::Lines => (", ", "", ""),
        };
        match kind {
            Kind::Number => cells.first().cloned().unwrap_or_default(),
            Kind::Vector(_) => format!("{open}{}{close}", cells.join(comma)),
            Kind::Matrix(..) => {
                let columns = (cells.len() / rows.max(1)).max(1);
                let rows: Vec<String> =
                    cells.chunks(columns).map(|row| format!("{open}{}{close}", row.join(comma))).collect();
                let between = if matches!(self, Self::Lines) { "\n" } else { comma };
                format!("{open}{}{close}", rows.join(between))
            }
            Kind::Choice(_) | Kind::Camera => String::new(),
        }
    }

    /// A table with all digits.
    pub fn exact(self, kind: &Kind, table: &Table) -> String {
        let cells: Vec<String> = table.entries.iter().map(|entry| format!("{entry:e}")).collect();
        self.table(kind, table.rows, &cells)
    }
}
