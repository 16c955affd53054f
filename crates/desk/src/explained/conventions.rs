//! The display of matrices and the numbers that follow from them. The figure doesn't depend on it.

use crate::camera::Ndc;

/// The convention of NDC, and the notation of matrices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Conventions {
    /// The NDC of the numbers, the probe and the canonical volume.
    pub ndc: Ndc,
    /// The convention compared with.
    pub compared: Option<Ndc>,
    /// Points are rows: matrices are transposed.
    pub row_vectors: bool,
    /// True if z_c is shown growing along DOP.
    pub left_handed: bool,
}
