//! The share of a light that arrives at a pixel: its place held against the depths that the light sees.
//!
//! A texel of the map stands for all points in it, but the surface rises and falls within. So the depth of a pixel is
//! taken along the plane of its triangle to the middle of each texel that it is held against, and the bias says how
//! much deeper it must lie there. The shares of the texels under the soft edge, a square around the place, are added.

use crate::drawing::{Rays, Shadow, ShadowMap};
use crate::simd::prelude::*;
use crate::simd::{Simd, f32x8, mask32x8};

/// The part of a texel's length that a bias of 1 allows beside the plane: what meets in a corner, or is round, lies
/// over the plane of its neighbour within a texel.
const STEP: f32 = 0.5;
/// The part of the plane's change within a texel that counts as equal: vertices of the map lie on a grid of 1/256 of a
/// texel, and depths are single.
const UNSURE: f32 = 1.0 / 32.0;

/// The greatest number of texels along one side that is looked at; beyond, a place is no number.
const FAR: f32 = 1e6;

/// The shadow of one light on one triangle.
#[derive(Clone, Copy)]
pub(super) struct TriangleShadow<'a> {
    map: &'a ShadowMap,
    depths: &'a [Vec<f32>],
    plane: [f32; 3],
}

/// A place on a view of the map: x and y in texels, depth, its change from texel to texel, and the step of the bias.
struct OnMap {
    x: f32,
    y: f32,
    z: f32,
    slope: [f32; 2],
    step: f32,
}

impl<'a> TriangleShadow<'a> {
    /// `None` where nothing is known of the triangle, or of the map.
    pub(super) fn new(shadow: &'a Shadow, triangle: usize) -> Option<Self> {
        let plane = *shadow.planes.get(triangle)?;
        Some(Self { map: &shadow.map, depths: shadow.map.depths()?, plane })
    }

    /// The share of the light that arrives at each of eight places, 0 … 1; anything where it is not wanted.
    pub(super) fn arriving<K: Simd>(&self, wanted: mask32x8<K>, places: [f32x8<K>; 3]) -> f32x8<K> {
        let mut shares = [1.0; 8];
        for (l, share) in shares.iter_mut().enumerate().filter(|(l, _)| wanted[*l] != 0) {
            *share = self.share([places[0][l], places[1][l], places[2][l]]);
        }
        f32x8::from_slice(wanted.witness(), &shares)
    }

    fn share(&self, place: [f32; 3]) -> f32 {
        match &self.map.rays {
            Rays::Parallel { step } => {
                let ([x, y, z], [dx, dy, _]) = (place, self.plane);
                self.filtered(0, &OnMap { x, y, z, slope: [dx, dy], step: *step })
            }
            Rays::FromLamp { axes, reach, unit } => {
                // The view in whose direction it is farthest.
                let mut best = (0, f32::NEG_INFINITY);
                for (view, [_, _, forwards]) in axes.iter().enumerate() {
                    let distance = dot(*forwards, place);
                    if distance > best.1 {
                        best = (view, distance);
                    }
                }
                let (view, distance) = best;
                if distance <= 0.0 {
                    return 1.0;
                }
                let [right, up, _] = axes[view];
                #[expect(clippy::cast_precision_loss, reason = "at most 4096")]
                let size = self.map.size as f32;
                let texels = 0.5 * size / (distance * reach);
                let (inverse, along) = (unit / distance, 2.0 * reach * unit / size);
                self.filtered(
                    view,
                    &OnMap {
                        x: 0.5 * size + dot(right, place) * texels,
                        y: 0.5 * size - dot(up, place) * texels,
                        z: inverse - unit,
                        slope: [along * dot(right, self.plane), -along * dot(up, self.plane)],
                        step: 2.0 * reach * inverse / size,
                    },
                )
            }
        }
    }

    /// The share of the texels under the soft edge that are no nearer to the light.
    fn filtered(&self, view: usize, at: &OnMap) -> f32 {
        let Some(depths) = self.depths.get(view) else { return 1.0 };
        let OnMap { x, y, z, slope: [dx, dy], step } = *at;
        if !(x.abs() < FAR && y.abs() < FAR) {
            return 1.0;
        }
        let ShadowMap { bias, softness, size, .. } = *self.map;
        let size = size as usize;
        let follows = bias.min(1.0);
        let allowed = z + bias * (STEP * step + UNSURE * (dx.abs() + dy.abs()));
        let lit = |i: i32, j: i32| {
            let (Ok(column), Ok(row)) = (usize::try_from(i), usize::try_from(j)) else { return true };
            if column >= size {
                return true;
            }
            let Some(depth) = depths.get(row * size + column) else { return true };
            let (to_x, to_y) = (i as f32 + 0.5 - x, j as f32 + 0.5 - y);
            // What is not a number is lit.
            let is_hidden = *depth > allowed + follows * (dx * to_x + dy * to_y);
            !is_hidden
        };
        if softness <= 0.0 {
            return f32::from(u8::from(lit(floor(x), floor(y))));
        }
        let half = 0.5 * softness;
        let (columns, rows) = (floor(x - half)..=floor(x + half), floor(y - half)..=floor(y + half));
        let mut sum = 0.0;
        for j in rows {
            let height = (y + half).min(j as f32 + 1.0) - (y - half).max(j as f32);
            for i in columns.clone() {
                if lit(i, j) {
                    sum += height * ((x + half).min(i as f32 + 1.0) - (x - half).max(i as f32));
                }
            }
        }
        (sum / (softness * softness)).clamp(0.0, 1.0)
    }
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The whole number below.
#[expect(clippy::cast_possible_truncation, reason = "texels")]
fn floor(v: f32) -> i32 {
    let whole = v as i32;
    whole - i32::from(whole as f32 > v)
}
