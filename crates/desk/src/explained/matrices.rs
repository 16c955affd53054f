//! The explanation of matrices: its content, and the effect of the last change.

use std::collections::BTreeSet;

use crate::camera::ParameterKey;
use crate::explain::{Component, Matrix, Symbol};

/// A notation for the entries of a matrix.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Reading {
    /// With the notes' symbols.
    #[default]
    Formulas,
    /// With numbers in place of the symbols.
    Numbers,
    /// Their values.
    Values,
}

/// The explanation of matrices.
#[derive(Clone, Debug)]
pub struct Matrices {
    /// The matrix. Never an inverse.
    pub matrix: Matrix,
    /// Its inverse is shown.
    pub inverse: bool,
    /// The notation of its entries.
    pub reading: Reading,
    /// The explained entry: row and column from 0.
    pub entry: [usize; 2],
    /// The entry takes the keyboard in the next frame.
    pub wants_focus: bool,
    /// The symbols whose definitions are open, each with those that lead to it.
    pub open: BTreeSet<Vec<Symbol>>,
    /// The effect of the last change.
    pub glow: Glow,
}

impl Default for Matrices {
    fn default() -> Self {
        Self {
            matrix: Matrix::Projection,
            inverse: false,
            reading: Reading::default(),
            entry: [0, 0],
            wants_focus: false,
            open: BTreeSet::new(),
            glow: Glow::default(),
        }
    }
}

impl Matrices {
    /// The displayed matrix.
    pub fn shown(&self) -> Matrix {
        if self.inverse { self.matrix.inverse() } else { self.matrix }
    }

    /// Goes to an entry of a matrix, which takes the keyboard.
    pub fn go_to(&mut self, matrix: Matrix, entry: [usize; 2]) {
        let inverse = !Self::CHOICES.contains(&matrix);
        (self.matrix, self.inverse) = (if inverse { matrix.inverse() } else { matrix }, inverse);
        self.entry = entry;
        self.wants_focus = true;
    }

    /// Shows an entry of a matrix, or of its inverse.
    pub const fn show_entry(&mut self, matrix: Matrix, inverse: bool, entry: [usize; 2]) {
        (self.matrix, self.inverse, self.entry) = (matrix, inverse, entry);
    }

    /// The matrices to choose from, each with its inverse.
    pub const CHOICES: [Matrix; 5] =
        [Matrix::Model, Matrix::View, Matrix::Projection, Matrix::ViewProjection, Matrix::Viewport];
}

/// Duration of the glow of a change, in seconds.
const GLOW_SECONDS: f64 = 1.0;

/// Entries changed last, with the time.
#[derive(Clone, Debug, Default)]
pub struct Glow {
    /// The matrix, and its owner.
    of: Option<(Matrix, Option<String>)>,
    values: [[f64; 4]; 4],
    since: [[Option<f64>; 4]; 4],
}

impl Glow {
    /// Notes which values differ from the last frame. For another matrix, none do. `now` is a time in seconds.
    pub fn follow(&mut self, of: (Matrix, Option<&str>), values: [[f64; 4]; 4], now: f64) {
        let same = self.of.as_ref().is_some_and(|(matrix, whose)| (*matrix, whose.as_deref()) == of);
        if !same {
            *self = Self { of: Some((of.0, of.1.map(str::to_owned))), values, since: Default::default() };
            return;
        }
        for (i, row) in values.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                if self.values[i][j].to_bits() != value.to_bits() {
                    self.since[i][j] = Some(now);
                }
            }
        }
        self.values = values;
    }

    /// From 1, at the change, to 0.
    pub fn strength(&self, [row, column]: [usize; 2], now: f64) -> f64 {
        self.since[row][column].map_or(0.0, |since| (1.0 - (now - since) / GLOW_SECONDS).clamp(0.0, 1.0))
    }

    /// True while anything glows.
    pub fn is_seen(&self, now: f64) -> bool {
        (0..16).any(|i| self.strength([i / 4, i % 4], now) > 0.0)
    }
}

/// The symbols of a parameter.
pub fn symbols_of(key: ParameterKey) -> Vec<Symbol> {
    match key {
        ParameterKey::Position => Component::THREE.map(Symbol::Position).to_vec(),
        ParameterKey::FocalPoint => Component::THREE.map(Symbol::FocalPoint).to_vec(),
        ParameterKey::ViewUp => Component::THREE.map(Symbol::ViewUp).to_vec(),
        ParameterKey::Near => vec![Symbol::Near],
        ParameterKey::Far => vec![Symbol::Far],
        ParameterKey::ViewAngle => vec![Symbol::ViewAngle],
        ParameterKey::Height => vec![Symbol::Height],
        ParameterKey::Aspect => vec![Symbol::Aspect],
        ParameterKey::Window => vec![Symbol::Left, Symbol::Right, Symbol::Bottom, Symbol::Top],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changed_entries_glow_for_a_second_and_another_matrix_does_not() {
        let mut glow = Glow::default();
        let mut values = [[1.0; 4]; 4];
        glow.follow((Matrix::View, None), values, 0.0);
        assert!(!glow.is_seen(0.0));
        values[1][2] = 2.0;
        glow.follow((Matrix::View, None), values, 5.0);
        glow.follow((Matrix::View, None), values, 5.5);
        assert_eq!((glow.strength([1, 2], 5.5), glow.strength([2, 1], 5.5)), (0.5, 0.0));
        assert!(glow.is_seen(5.9) && !glow.is_seen(6.0));
        glow.follow((Matrix::Projection, None), [[0.0; 4]; 4], 5.5);
        assert!(!glow.is_seen(5.5));
        glow.follow((Matrix::Projection, Some("cube")), values, 5.5);
        assert!(!glow.is_seen(5.5), "another object's");
    }
}
