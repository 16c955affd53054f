//! A matrix as programs and people write it → its numbers.

use glam::DMat4;

use crate::expression::{self, Dimension};

/// The numbers of a matrix of four or three rows and four columns, in the order in which they were written.
#[derive(Clone, Debug, PartialEq)]
pub struct MatrixEntries {
    numbers: Vec<f64>,
}

/// Why a text is not a matrix.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MatrixTextError {
    /// Another count of numbers.
    #[error("{0} numbers; a matrix has 16, four rows of four, or 12: K [R | t]")]
    Count(usize),
    /// A part of it is not a number.
    #[error("“{}” is not a number", crate::sanitize::escaped(.0))]
    Part(String),
}

impl MatrixEntries {
    /// Reads sixteen or twelve numbers, in any brackets, apart by spaces, commas, semicolons or line ends, as Python,
    /// MATLAB, JSON, YAML and GLSL write them; each may be an expression.
    ///
    /// ```
    /// # use camera_lab_engine::camera::MatrixEntries;
    /// let blender = "<Matrix 4x4 (1.0, 0.0, 0.0, 7.0)\n(0.0, 1.0, 0.0, 8.0)\n(0.0, 0.0, 1.0, 9.0)\n(0.0, 0.0, 0.0, 1.0)>";
    /// assert_eq!(MatrixEntries::read(blender)?.matrix(false).w_axis.z, 9.0);
    /// # Ok::<(), camera_lab_engine::camera::MatrixTextError>(())
    /// ```
    ///
    /// # Errors
    /// [`MatrixTextError`] names the part that is not a number, or their count.
    pub fn read(text: &str) -> Result<Self, MatrixTextError> {
        let plain: String = text.chars().map(|c| if "[](){}<>|\n\t\r;&\\\"".contains(c) { ' ' } else { c }).collect();
        let separated = if has_decimal_commas(&plain) { plain } else { plain.replace(',', " ") };
        let mut numbers = Vec::new();
        for part in separated.split_whitespace() {
            match expression::evaluate(part, Dimension::Number) {
                Ok(number) => numbers.push(number),
                // `dtype=float32`, with which NumPy ends it.
                Err(_) if part.starts_with("dtype") => break,
                Err(_) if numbers.is_empty() && is_name(part) => {}
                Err(_) => return Err(MatrixTextError::Part(part.to_owned())),
            }
        }
        // `Float32Array(16)`, as consoles of browsers begin it.
        #[expect(clippy::float_cmp, reason = "a count")]
        if [(17, 16.0), (13, 12.0)].iter().any(|(count, first)| numbers.len() == *count && numbers[0] == *first) {
            numbers.remove(0);
        }
        match numbers.len() {
            12 | 16 => Ok(Self { numbers }),
            count => Err(MatrixTextError::Count(count)),
        }
    }

    /// Three or four.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.numbers.len() / 4
    }

    /// The matrix, which acts on column vectors; three rows are followed by 0 0 0 1. By columns the numbers go down
    /// first, as OpenGL, glTF and three.js have them; so does a matrix that is written for row vectors.
    #[must_use]
    pub fn matrix(&self, by_columns: bool) -> DMat4 {
        let rows = self.rows();
        let mut matrix = DMat4::IDENTITY;
        for (k, number) in self.numbers.iter().enumerate() {
            let (row, column) = if by_columns { (k % rows, k / rows) } else { (k / 4, k % 4) };
            matrix.col_mut(column)[row] = *number;
        }
        matrix
    }
}

/// Whether a part before the first number belongs to a name: `np.array`, `mat4`, `"matrix":`, `P2 =`.
fn is_name(part: &str) -> bool {
    part.chars().any(char::is_alphabetic) || !part.contains(|c: char| c.is_ascii_digit())
}

/// Whether commas stand inside the numbers: no more than one in each part, between digits.
fn has_decimal_commas(text: &str) -> bool {
    let is_decimal = |part: &str| {
        part.split_once(',').is_none_or(|(whole, decimals)| {
            !decimals.contains(',')
                && whole.ends_with(|c: char| c.is_ascii_digit())
                && decimals.starts_with(|c: char| c.is_ascii_digit())
        })
    };
    text.contains(',') && text.split_whitespace().all(is_decimal)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;

    fn read(text: &str) -> Result<DMat4, MatrixTextError> {
        MatrixEntries::read(text).map(|entries| entries.matrix(false))
    }

    #[test]
    fn matrices_are_read_as_programs_and_people_write_them() {
        let expected =
            DMat4::from_cols_array(&[1.0, 0.0, 0.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.5, 0.0, 3.0, 0.0, 0.25, 1.0]);
        for text in [
            "1 2 0 3\n0 1 0 0\n0 0 -1.5 0.25\n0 0 0 1",
            "[[1, 2, 0, 3], [0, 1, 0, 0], [0, 0, -1.5, 0.25], [0, 0, 0, 1]]",
            "np.array([[1., 2., 0., 3.],\n [0., 1., 0., 0.],\n [0., 0., -1.5, 0.25],\n [0., 0., 0., 1.]])",
            "[1 2 0 3; 0 1 0 0; 0 0 -3/2 1/4; 0 0 0 1]",
            "1 2 0 3\n0 1 0 0\n0 0 −1,5 0,25\n0 0 0 1",
            "1,0 2,0 0,0 3,0\n0,0 1,0 0,0 0,0\n0,0 0,0 −1,5 0,25\n0,0 0,0 0,0 1,0",
            r"1 & 2 & 0 & 3 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & -1.5 & 0.25 \\ 0 & 0 & 0 & 1",
            "1,2,0,3,0,1,0,0,0,0,-1.5,0.25,0,0,0,1",
            "1,2,0,3\n0,1,0,0\n0,0,-1.5,0.25",
            "[1,2,0,3;0,1,0,0;0,0,-1.5,0.25]",
            "array([[1., 2., 0., 3.],\n [0., 1., 0., 0.],\n [0., 0., -1.5, 0.25]], dtype=float32)",
            "<Matrix 4x4 (1.0000, 2.0000, 0.0000, 3.0000)\n            (0.0000, 1.0000, 0.0000, 0.0000)\n\
             (0.0000, 0.0000, -1.5000, 0.2500)\n            (0.0000, 0.0000, 0.0000, 1.0000)>",
            "Matrix(((1.0, 2.0, 0.0, 3.0),\n (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, -1.5, 0.25), (0.0, 0.0, 0.0, 1.0)))",
            // Twelve numbers, as they stand in files of OpenCV and of KITTI.
            "data: [ 1.0e+00, 2., 0., 3.,\n 0., 1., 0., 0., 0., 0., -1.5e+00, 2.5e-01 ]",
            "P2: 1.000000000000e+00 2.000000000000e+00 0 3 0 1 0 0 0 0 -1.500000000000e+00 2.500000000000e-01",
        ] {
            assert_eq!(read(text).unwrap(), expected, "{text}");
        }
        let by_columns = |text: &str| MatrixEntries::read(text).unwrap().matrix(true);
        for text in [
            r#""matrix": [1,0,0,0,2,1,0,0,0,0,-1.5,0,3,0,0.25,1]"#,
            "Float32Array(16) [1, 0, 0, 0, 2, 1, 0, 0, 0, 0, -1.5, 0, 3, 0, 0.25, 1]",
            "1 0 0\n2 1 0\n0 0 -1.5\n3 0 0.25",
        ] {
            assert_eq!(by_columns(text), expected, "{text}");
        }
        assert_eq!(read("1 2 3"), Err(MatrixTextError::Count(3)));
        assert_eq!(read("1 2 x 3"), Err(MatrixTextError::Part("x".to_owned())));
    }
}
