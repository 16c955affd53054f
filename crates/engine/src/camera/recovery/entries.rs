//! The bare numbers of a matrix, in the order in which they were written.

use glam::{DMat4, DQuat, DVec3, DVec4};

use crate::camera::recovery::Order;

/// A number of a text, with the error that its digits leave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Written {
    pub(crate) value: f64,
    /// Half of its last digit, or the rounding of an `f32` if it has as many digits. 0 for whole numbers.
    pub(crate) error: f64,
}

/// The numbers of a matrix in the order in which they were written, and how many stood in a line.
#[derive(Clone, Debug, PartialEq)]
pub struct MatrixEntries {
    numbers: Vec<Written>,
    /// The count of numbers in each line or inner bracket; `None` if they are one list.
    in_line: Option<usize>,
}

impl MatrixEntries {
    /// Numbers of a file, if their count is that of a matrix.
    pub(crate) fn new(numbers: Vec<Written>, in_line: Option<usize>) -> Option<Self> {
        matches!(numbers.len(), 7 | 9 | 12 | 16).then_some(Self { numbers, in_line })
    }

    /// A matrix that acts on column vectors, by rows.
    pub(crate) fn of_matrix(m: DMat4, error: f64) -> Self {
        let numbers = (0..16).map(|k| Written { value: m.row(k / 4)[k % 4], error }).collect();
        Self { numbers, in_line: Some(4) }
    }

    /// Three, or four.
    pub fn rows(&self) -> usize {
        if self.numbers.len() == 16 { 4 } else { 3 }
    }

    /// The count of numbers: 7, 9, 12 or 16.
    pub fn count(&self) -> usize {
        self.numbers.len()
    }

    /// True if they are one list, without lines.
    pub(crate) fn is_flat(&self) -> bool {
        self.in_line.is_none()
    }

    /// The greatest error that the digits of a number leave.
    pub(crate) fn error(&self) -> f64 {
        self.numbers.iter().map(|number| number.error).fold(0.0, f64::max)
    }

    /// The errors that the digits leave, in the places of the entries.
    pub(crate) fn errors(&self, order: Order) -> DMat4 {
        let errors = self.numbers.iter().map(|number| Written { value: number.error, error: 0.0 }).collect();
        let m = Self { numbers: errors, in_line: self.in_line }.lines(order);
        // Three rows were followed by 0 0 0 1, which is exact.
        if self.rows() == 3 { m - DMat4::IDENTITY } else { m }
    }

    /// The first number that isn't finite, with its place in the lines.
    pub(crate) fn not_finite(&self) -> Option<(usize, usize, f64)> {
        let columns = self.in_line.unwrap_or(if self.count() == 9 { 3 } else { 4 });
        let at = self.numbers.iter().position(|number| !number.value.is_finite())?;
        Some((at / columns + 1, at % columns + 1, self.numbers[at].value))
    }

    /// The orders in which they may be written, the likelier first.
    pub(crate) fn orders(&self) -> &'static [Order] {
        use Order::{Columns, RotationThenTranslation, Rows, TThenWxyz, TThenXyzw, WxyzThenT, XyzwThenT};
        match (self.count(), self.in_line) {
            (7, _) => &[WxyzThenT, TThenXyzw, XyzwThenT, TThenWxyz],
            (12, Some(3)) => &[RotationThenTranslation, Columns],
            (12, Some(4)) => &[Rows],
            (12, _) => &[Rows, Columns, RotationThenTranslation],
            _ => &[Rows, Columns],
        }
    }

    /// The matrix, which acts on column vectors. Three rows are followed by 0 0 0 1. By columns the numbers go down
    /// first, as in OpenGL, glTF and three.js, and as in a matrix written for row vectors.
    pub fn matrix(&self, by_columns: bool) -> DMat4 {
        self.in_order(if by_columns { Order::Columns } else { Order::Rows })
    }

    /// The matrix of an order. Nine numbers are its upper left corner. A quaternion that isn't of unit length gives a
    /// matrix of zeros.
    pub(crate) fn in_order(&self, order: Order) -> DMat4 {
        let value = |k: usize| self.numbers.get(k).map_or(0.0, |number| number.value);
        let at = |places: [usize; 4]| DQuat::from_array(places.map(value));
        let (quaternion, t) = match order {
            Order::WxyzThenT => (at([1, 2, 3, 0]), 4),
            Order::XyzwThenT => (at([0, 1, 2, 3]), 4),
            Order::TThenXyzw => (at([3, 4, 5, 6]), 0),
            Order::TThenWxyz => (at([4, 5, 6, 3]), 0),
            Order::Rows | Order::Columns | Order::RotationThenTranslation => return self.lines(order),
        };
        if (quaternion.length() - 1.0).abs() > 1e-2 {
            return DMat4::ZERO;
        }
        DMat4::from_rotation_translation(quaternion.normalize(), DVec3::new(value(t), value(t + 1), value(t + 2)))
    }

    fn lines(&self, order: Order) -> DMat4 {
        let rows = self.rows();
        let columns = if self.count() == 9 { 3 } else { 4 };
        let mut matrix = DMat4::IDENTITY;
        for (k, number) in self.numbers.iter().enumerate() {
            let (row, column) = match order {
                Order::Columns => (k % rows, k / rows),
                Order::RotationThenTranslation if k >= 9 => (k - 9, 3),
                Order::RotationThenTranslation => (k / 3, k % 3),
                _ => (k / columns, k % columns),
            };
            matrix.col_mut(column)[row] = number.value;
        }
        matrix
    }
}

/// The matrix of R and t, which are in rows.
pub(crate) fn rigid(r: [DVec3; 3], t: DVec3) -> DMat4 {
    let rows = [r[0].extend(t.x), r[1].extend(t.y), r[2].extend(t.z), DVec4::W];
    DMat4::from_cols(rows[0], rows[1], rows[2], rows[3]).transpose()
}
