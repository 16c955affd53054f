//! The share of a light that arrives at a pixel: its place compared with the depths that the light sees.
//!
//! The standard way adds one constant to the depth, the bias, and either surfaces shadow themselves or shadows come off
//! their objects. A texel of the map stands for all points in it, but the surface rises and falls within. So here the
//! depth of a pixel is taken along the plane of its triangle to the middle of each texel it is compared with, and the
//! bias only says how much deeper it must lie there. The shares of the texels under the soft edge, a square around the
//! place, are added, for eight places at once.

use crate::drawing::{Rays, Shadow};
use crate::simd::prelude::*;

use crate::raster::pixel::LANES;

/// The part of a texel's length that a bias of 1 allows beside the plane, because surfaces that meet in a corner, or
/// are round, lie over the plane of their neighbour within a texel.
const STEP: f32 = 0.5;
/// The part of the plane's change within a texel that counts as equal, because vertices of the map lie on a grid of
/// 1/256 of a texel, and depths are single.
const UNSURE: f32 = 1.0 / 32.0;

/// The greatest number of texels along one side that is looked at. A place beyond it doesn't count as a number.
const FAR: f32 = 1e6;

/// Places on a map: x and y in texels, the depth, its change from texel to texel, and the step of the bias.
struct OnMap<K: Simd> {
    x: f32x8<K>,
    y: f32x8<K>,
    z: f32x8<K>,
    slope: [f32x8<K>; 2],
    step: f32x8<K>,
    /// The view that each lies in.
    view: i32x8<K>,
}

/// The share of a light that arrives at eight places, 0 … 1, each on a plane of its own. It's 1 if it isn't wanted or
/// the place isn't a number. `None` before the map is painted.
#[inline(always)]
pub(super) fn arriving<K: Simd>(
    shadow: &Shadow,
    wanted: mask32x8<K>,
    places: [f32x8<K>; 3],
    planes: [f32x8<K>; 3],
) -> Option<f32x8<K>> {
    let map = &*shadow.map;
    let depths = map.depths()?;
    let simd = wanted.witness();
    Some(match &map.rays {
        Rays::Parallel { step } => {
            let ([x, y, z], [dx, dy, _]) = (places, planes);
            let (step, view) = (f32x8::splat(simd, *step), i32x8::splat(simd, 0));
            filtered(shadow, depths, wanted, &OnMap { x, y, z, slope: [dx, dy], step, view })
        }
        Rays::FromLamp { axes, reach, unit } => {
            // The view in whose direction it is farthest.
            let mut view = i32x8::splat(simd, 0);
            let mut distance = f32x8::splat(simd, f32::NEG_INFINITY);
            // In the view so far: the place to the right and up, and how the plane rises there.
            let mut along = [f32x8::splat(simd, 0.0); 4];
            for (k, [right, up, forwards]) in (0..).zip(&**axes) {
                let new = dot(*forwards, places);
                let farther = new.simd_gt(distance);
                let of_view = [dot(*right, places), dot(*up, places), dot(*right, planes), dot(*up, planes)];
                for k in 0..along.len() {
                    along[k] = farther.select(of_view[k], along[k]);
                }
                (distance, view) = (farther.select(new, distance), farther.select(i32x8::splat(simd, k), view));
            }
            let size = map.size as f32;
            let ahead = distance.simd_gt(0.0);
            let texels = f32x8::splat(simd, 0.5 * size) / (distance * *reach);
            let inverse = f32x8::splat(simd, *unit) / distance;
            let steep = 2.0 * reach * unit / size;
            let [right, up, plane_right, plane_up] = along;
            let on_map = OnMap {
                x: right * texels + 0.5 * size,
                y: f32x8::splat(simd, 0.5 * size) - up * texels,
                z: inverse - *unit,
                slope: [plane_right * steep, plane_up * -steep],
                step: inverse * (2.0 * reach / size),
                view,
            };
            filtered(shadow, depths, wanted & ahead, &on_map)
        }
    })
}

/// The share of the texels under the soft edge that are no nearer to the light.
#[inline(always)]
fn filtered<K: Simd>(shadow: &Shadow, depths: &[Vec<f32>], wanted: mask32x8<K>, at: &OnMap<K>) -> f32x8<K> {
    let simd = wanted.witness();
    let (zero, one) = (f32x8::splat(simd, 0.0), f32x8::splat(simd, 1.0));
    let OnMap { x, y, z, slope: [dx, dy], step, view } = *at;
    let wanted = wanted & x.abs().simd_lt(FAR) & y.abs().simd_lt(FAR);
    if !wanted.any_true() {
        return one;
    }
    let Shadow { map, bias, .. } = shadow;
    let size = map.size.cast_signed();
    let softness = map.softness.max(0.0);
    let half = 0.5 * softness;
    let follows = bias.min(1.0);
    let allowed = z + (step * STEP + (dx.abs() + dy.abs()) * UNSURE) * *bias;
    let (left, top) = ((x - half).floor(), (y - half).floor());
    // A soft edge of whole texels reaches over one more.
    #[expect(clippy::cast_possible_truncation, reason = "8 at most")]
    let side = if softness > 0.0 { softness.ceil() as i32 + 1 } else { 1 };
    let Some(first) = depths.first() else { return one };
    let mut views = [first.as_slice(); LANES];
    if depths.len() > 1 {
        for (l, depths_there) in views.iter_mut().enumerate() {
            *depths_there = depths.get(view[l] as usize).map_or(&[], Vec::as_slice);
        }
    }
    let mut sum = zero;
    for j in 0..side {
        let row = top + j as f32;
        let (height, below) = (under(row, y, softness), (row + 0.5 - y) * dy);
        let row = row.to_int::<i32x8<K>>();
        let in_rows = wanted & row.simd_ge(0) & row.simd_lt(size);
        let start = row * size;
        for i in 0..side {
            let column = left + i as f32;
            let (width, beside) = (under(column, x, softness), (column + 0.5 - x) * dx);
            let column = column.to_int::<i32x8<K>>();
            let there = in_rows & column.simd_ge(0) & column.simd_lt(size);
            // Texels lie anywhere in memory: each place asks for its own, or for the first if it has none, so that
            // no branch is guessed wrong.
            let (mut texels, mut found) = ([0; LANES], [f32::NEG_INFINITY; LANES]);
            there.select(start + column, i32x8::splat(simd, 0)).store_slice(&mut texels);
            for ((found, &texel), depths) in found.iter_mut().zip(&texels).zip(&views) {
                if let Some(&depth) = depths.get(texel as usize) {
                    *found = depth;
                }
            }
            // Beyond the map all is lit.
            let found = there.select(f32x8::from_slice(simd, &found), f32x8::splat(simd, f32::NEG_INFINITY));
            let hidden = found.simd_gt(allowed + (beside + below) * follows);
            sum += hidden.select(zero, height * width);
        }
    }
    let share = if softness > 0.0 { (sum * (1.0 / (softness * softness))).max(zero).min(one) } else { sum };
    wanted.select(share, one)
}

/// The part of a texel from `from` on that lies under the soft edge around `middle`, along one axis.
#[inline(always)]
fn under<K: Simd>(from: f32x8<K>, middle: f32x8<K>, softness: f32) -> f32x8<K> {
    let half = 0.5 * softness;
    if softness > 0.0 {
        ((middle + half).min(from + 1.0) - (middle - half).max(from)).max(0.0)
    } else {
        f32x8::splat(from.witness(), 1.0)
    }
}

#[inline(always)]
fn dot<K: Simd>(a: [f32; 3], b: [f32x8<K>; 3]) -> f32x8<K> {
    b[0] * a[0] + b[1] * a[1] + b[2] * a[2]
}
