//! Products of matrices as worked steps, row by column.

use glam::{DMat4, DVec4};

use super::worked::{Worked, named};
use crate::explain::{sum, times};

macro_rules! names {
    ($letter:literal, $($index:literal)*) => {
        [$((concat!($letter, "_", $index), concat!($letter, "_{", $index, "}"))),*]
    };
}

/// The entries of a matrix.
pub(super) const ENTRIES: [[(&str, &str); 4]; 4] = [
    names!("m", "11" "12" "13" "14"),
    names!("m", "21" "22" "23" "24"),
    names!("m", "31" "32" "33" "34"),
    names!("m", "41" "42" "43" "44"),
];
/// Points before and after a transform.
const BEFORE: [[(&str, &str); 5]; 4] = [
    names!("x", "1" "2" "3" "4" "5"),
    names!("y", "1" "2" "3" "4" "5"),
    names!("z", "1" "2" "3" "4" "5"),
    names!("w", "1" "2" "3" "4" "5"),
];
const AFTER: [[(&str, &str); 5]; 4] = [
    names!("x'", "1" "2" "3" "4" "5"),
    names!("y'", "1" "2" "3" "4" "5"),
    names!("z'", "1" "2" "3" "4" "5"),
    names!("w'", "1" "2" "3" "4" "5"),
];

/// Points multiplied by a matrix, row by column. Rows that leave w unchanged need no sum.
pub(super) fn multiplied(by: DMat4, vertices: &[DVec4]) -> Worked {
    multiplied_as("vertices", by, vertices)
}

/// The same under a heading that says where the points come from.
pub(super) fn multiplied_as(heading: &'static str, by: DMat4, vertices: &[DVec4]) -> Worked {
    let mut step = Worked::new(heading, "");
    for (k, vertex) in vertices.iter().enumerate().take(BEFORE[0].len()) {
        let product = by * *vertex;
        for row in (0..4).filter(|row| by.row(*row) != DVec4::W) {
            let term = |column: usize| {
                let ((entry, entry_latex), (of, of_latex)) = (ENTRIES[row][column], BEFORE[column][k]);
                let entry = named(entry, entry_latex, by.row(row)[column]);
                times([entry.into(), named(of, of_latex, vertex[column]).into()])
            };
            let (text, latex) = AFTER[row][k];
            step = step.row(named(text, latex, product[row]), sum((0..4).map(term)));
        }
    }
    step
}
