//! The values of answers.

use glam::{DMat3, DMat4, DVec3, DVec4};

/// Numbers in rows and columns, row by row. A number is 1 × 1, a vector is a column.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub columns: usize,
    /// `rows` × `columns` numbers.
    pub entries: Vec<f64>,
}

impl Table {
    /// A table of one row and one column.
    pub fn number(value: f64) -> Self {
        Self::column(&[value])
    }

    /// A table of one column.
    pub fn column(values: &[f64]) -> Self {
        Self { rows: values.len(), columns: 1, entries: values.to_vec() }
    }

    /// A matrix from rows of the same length.
    pub fn from_rows<const N: usize>(rows: &[[f64; N]]) -> Self {
        Self { rows: rows.len(), columns: N, entries: rows.concat() }
    }

    /// A matrix whose columns are points.
    pub fn from_columns<const N: usize>(columns: &[[f64; N]]) -> Self {
        Self { rows: columns.len(), columns: N, entries: columns.concat() }.transposed()
    }

    /// Its shape: rows and columns.
    pub fn shape(&self) -> [usize; 2] {
        [self.rows, self.columns]
    }

    /// The number in a row and a column, from 0.
    pub fn get(&self, row: usize, column: usize) -> f64 {
        self.entries[row * self.columns + column]
    }

    /// The rows, from the first to the last.
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.entries.chunks(self.columns.max(1))
    }

    /// Exchanges rows and columns.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let entries = (0..self.columns).flat_map(|column| (0..self.rows).map(move |row| self.get(row, column)));
        Self { rows: self.columns, columns: self.rows, entries: entries.collect() }
    }

    /// The inverse of a 3 × 3 or 4 × 4 matrix that has one.
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        let inverse = match (self.shape(), &self.entries[..]) {
            ([4, 4], entries) => {
                let array: [f64; 16] = entries.try_into().ok()?;
                let inverse = DMat4::from_cols_array(&array).transpose().inverse();
                inverse.transpose().to_cols_array().to_vec()
            }
            ([3, 3], entries) => {
                let array: [f64; 9] = entries.try_into().ok()?;
                let inverse = DMat3::from_cols_array(&array).transpose().inverse();
                inverse.transpose().to_cols_array().to_vec()
            }
            _ => return None,
        };
        inverse.iter().all(|entry| entry.is_finite()).then_some(Self { entries: inverse, ..*self })
    }

    /// The size of its greatest entry.
    pub fn size(&self) -> f64 {
        self.entries.iter().fold(0.0, |size, entry| size.max(entry.abs()))
    }

    /// The vector of three entries; `None` for other tables.
    pub fn vector(&self) -> Option<DVec3> {
        let [x, y, z] = self.entries[..] else { return None };
        Some(DVec3::new(x, y, z))
    }

    /// The matrix of four rows and columns; `None` for other tables.
    pub fn matrix(&self) -> Option<DMat4> {
        let entries: [f64; 16] = self.entries[..].try_into().ok()?;
        Some(DMat4::from_cols_array(&entries).transpose())
    }

    /// Changes each entry.
    #[must_use]
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Self { entries: self.entries.iter().map(|entry| f(*entry) + 0.0).collect(), ..*self }
    }

    /// True if nothing is infinite or NaN.
    pub fn is_finite(&self) -> bool {
        self.entries.iter().all(|entry| entry.is_finite())
    }
}

impl From<f64> for Table {
    fn from(value: f64) -> Self {
        Self::number(value)
    }
}

impl From<DVec3> for Table {
    fn from(v: DVec3) -> Self {
        Self::column(&v.to_array())
    }
}

impl From<DVec4> for Table {
    fn from(v: DVec4) -> Self {
        Self::column(&v.to_array())
    }
}

impl From<DMat4> for Table {
    fn from(m: DMat4) -> Self {
        Self { rows: 4, columns: 4, entries: m.transpose().to_cols_array().to_vec() }
    }
}

impl From<DMat3> for Table {
    fn from(m: DMat3) -> Self {
        Self { rows: 3, columns: 3, entries: m.transpose().to_cols_array().to_vec() }
    }
}
