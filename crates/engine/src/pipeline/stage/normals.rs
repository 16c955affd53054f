//! **Normals**: take the normals of vertices to view space.
//!
//! *Notes*: `[3]` §1.4 stores a normal with each vertex. *Textbook*: the inverse transpose of the model-view matrix, so
//! that a normal stays perpendicular to its surface if the object is stretched, and then length 1. *Here*: the
//! cofactors of the matrix, which are its inverse transpose times its determinant
//! ([`normal_matrix`](crate::pipeline::space::projector::ViewFromObject::normal_matrix)): a flattened object, which has
//! no inverse, has normals all the same. The length is left to the light, which needs a square root there anyway. Only
//! normals that light asks for are transformed, eight at a time, in the loop of [`reflection`](super::reflection).

use glam::{DMat3, DVec3};

use super::faces::LANES;
use crate::geometry::try_unit;
use crate::lighting::Eight;
use crate::simd::prelude::*;

/// A matrix by its rows, in single precision.
pub(super) type Rows = [[f32; 3]; 3];

/// Takes eight normals of any length, coordinate by coordinate, to view space.
#[inline(always)]
pub(super) fn normals<S: Simd>(simd: S, normal_matrix: &Rows, normals: [[f32; LANES]; 3]) -> Eight<S> {
    product(normal_matrix, eight(simd, normals))
}

/// Takes one normal to view space, with length 1. Zero if it has no direction.
pub(super) fn unit_normal(normal_matrix: DMat3, normal: DVec3) -> DVec3 {
    /// Squared lengths outside this range are near underflow or overflow.
    const SAFE: std::ops::Range<f64> = 1e-200..1e200;
    let normal = normal_matrix * normal;
    let square = normal.length_squared();
    if SAFE.contains(&square) { normal / square.sqrt() } else { try_unit(normal).unwrap_or_default() }
}

#[inline(always)]
pub(super) fn eight<S: Simd>(simd: S, v: [[f32; LANES]; 3]) -> Eight<S> {
    [f32x8::simd_from(simd, v[0]), f32x8::simd_from(simd, v[1]), f32x8::simd_from(simd, v[2])]
}

/// The product of a matrix with eight vectors.
#[inline(always)]
pub(super) fn product<S: Simd>(m: &Rows, v: Eight<S>) -> Eight<S> {
    [row_product(m[0], v), row_product(m[1], v), row_product(m[2], v)]
}

#[inline(always)]
fn row_product<S: Simd>(row: [f32; 3], v: Eight<S>) -> f32x8<S> {
    v[0] * row[0] + v[1] * row[1] + v[2] * row[2]
}

pub(super) fn rows(m: DMat3) -> Rows {
    m.transpose().as_mat3().to_cols_array_2d()
}
