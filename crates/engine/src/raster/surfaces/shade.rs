//! Colours of flat and of Gouraud's shading, eight pixels at a time.
//!
//! The standard way divides by w at each pixel. Between two vertices that makes no difference of half a step in a byte
//! unless their w differ enough for their colours, and in a fine mesh they hardly ever do. So colours are affine on the
//! picture if that gives the same within half a step, which saves a division and three products for a pixel. For large
//! triangles that perspective bends, the channels divided by w are interpolated, and w once for all three.

use crate::appearance::Rgba;
use crate::drawing::{Base, Surface};
use crate::simd::prelude::*;
use crate::simd::{ROUND_F32, round_bits};

use super::batch::{BATCH, Corners, Planes, SetUp, gather};
use super::setup::{AffineValue, Triangle, greater, pick};
use crate::raster::grid::STEEPEST;
use crate::raster::pixel::{Pixel, premultiply};

/// A shader of one triangle.
pub(super) trait Shader<K: Simd> {
    /// Goes to a tile's columns. Its pixels' centres are `x` to the right of the triangle's origin.
    fn columns(&mut self, x: f32x8<K>);
    /// Goes to a tile's rows. Its pixels' centres are `y` below the origin.
    fn rows(&mut self, y: f32x8<K>);
    /// The colours of the tile's pixels. Only those wanted need be right.
    fn colors(&self, wanted: mask32x8<K>) -> u32x8<K>;
}

/// The shaders of a batch of triangles.
pub(super) trait Colors<'a, K: Simd>: Sized {
    /// The shader of one of the batch.
    type Simple: Shader<K>;
    /// The shader of a triangle on its own.
    type Shader: Shader<K>;

    /// `outside` is true if colours are needed at centres outside their triangle.
    fn new(
        simd: K,
        surface: &'a Surface,
        triangles: &[u32],
        corners: &Corners,
        set_up: &SetUp<K>,
        outside: bool,
    ) -> Self;
    /// The triangles that the batch can paint. The others must be painted on their own.
    fn simple(&self) -> mask32x8<K>;
    /// The shader of one.
    fn of(&self, lane: usize) -> Self::Simple;
    /// The shader of a triangle of any kind. `None` if the surface has no colours for it.
    fn alone(
        simd: K,
        surface: &'a Surface,
        triangle: &Triangle,
        index: u32,
        corners: [usize; 3],
    ) -> Option<Self::Shader>;
}

/// One colour.
pub(super) struct Flat<K: Simd>(u32x8<K>);

impl<K: Simd> Shader<K> for Flat<K> {
    #[inline(always)]
    fn columns(&mut self, _x: f32x8<K>) {}

    #[inline(always)]
    fn rows(&mut self, _y: f32x8<K>) {}

    #[inline(always)]
    fn colors(&self, _wanted: mask32x8<K>) -> u32x8<K> {
        self.0
    }
}

/// The colours of faces.
pub(super) struct FlatColors<K: Simd> {
    colors: u32x8<K>,
    present: mask32x8<K>,
}

/// The colour of a face. The alpha of opaque surfaces doesn't count.
#[inline(always)]
fn face_color(surface: &Surface, triangle: u32) -> Option<Pixel> {
    let color = surface.face_color(triangle as usize)?;
    Some(if surface.translucent { premultiply(color) } else { u32::from_le_bytes([color.r, color.g, color.b, 255]) })
}

impl<'a, K: Simd> Colors<'a, K> for FlatColors<K> {
    type Simple = Flat<K>;
    type Shader = Flat<K>;

    #[inline(always)]
    fn new(
        simd: K,
        surface: &'a Surface,
        triangles: &[u32],
        _corners: &Corners,
        _set_up: &SetUp<K>,
        _outside: bool,
    ) -> Self {
        let (mut colors, mut present) = ([0; BATCH], [0; BATCH]);
        for (l, &triangle) in triangles.iter().take(BATCH).enumerate() {
            if let Some(color) = face_color(surface, triangle) {
                (colors[l], present[l]) = (color, -1);
            }
        }
        Self { colors: u32x8::from_slice(simd, &colors), present: mask32x8::from_slice(simd, &present) }
    }

    #[inline(always)]
    fn simple(&self) -> mask32x8<K> {
        self.present
    }

    #[inline(always)]
    fn of(&self, lane: usize) -> Flat<K> {
        Flat(u32x8::splat(self.colors.witness(), self.colors[lane]))
    }

    #[inline(always)]
    fn alone(simd: K, surface: &'a Surface, _triangle: &Triangle, index: u32, _corners: [usize; 3]) -> Option<Flat<K>> {
        Some(Flat(u32x8::splat(simd, face_color(surface, index)?)))
    }
}

/// Channels that are interpolated if colours are opaque.
const RGB: usize = 3;

/// Opaque colours between those of the vertices, affine on the picture.
pub(super) struct Affine<K: Simd> {
    planes: [AffineValue; RGB],
    /// Each channel's change from the origin to the columns, and its value in the rows, of the tile at hand.
    across: [f32x8<K>; RGB],
    down: [f32x8<K>; RGB],
    outside: bool,
}

impl<K: Simd> Affine<K> {
    #[inline(always)]
    fn channel(&self, k: usize) -> u32x8<K> {
        let value = self.across[k] + self.down[k];
        round(if self.outside { value.max(self.planes[k].low).min(self.planes[k].high) } else { value })
    }
}

impl<K: Simd> Shader<K> for Affine<K> {
    #[inline(always)]
    fn columns(&mut self, x: f32x8<K>) {
        for k in 0..RGB {
            self.across[k] = x * self.planes[k].dx;
        }
    }

    #[inline(always)]
    fn rows(&mut self, y: f32x8<K>) {
        for k in 0..RGB {
            self.down[k] = y * self.planes[k].dy + self.planes[k].value;
        }
    }

    #[inline(always)]
    fn colors(&self, _wanted: mask32x8<K>) -> u32x8<K> {
        pack(self.channel(0), self.channel(1), self.channel(2))
    }
}

/// Opaque colours between those of the vertices. With regard to perspective c/w and 1/w are affine on the picture;
/// without, or if it makes no difference, the colours are.
pub(super) struct Gouraud<K: Simd> {
    /// Red, green, blue, divided by w if `perspective`. Their ranges aren't.
    affine: Affine<K>,
    perspective: bool,
    inverse_w: AffineValue,
    inverse_w_across: f32x8<K>,
    inverse_w_down: f32x8<K>,
}

impl<K: Simd> Gouraud<K> {
    #[inline(always)]
    fn channel(&self, k: usize, w: f32x8<K>) -> u32x8<K> {
        let AffineValue { low, high, .. } = self.affine.planes[k];
        round(((self.affine.across[k] + self.affine.down[k]) * w).max(low).min(high))
    }
}

impl<K: Simd> Shader<K> for Gouraud<K> {
    #[inline(always)]
    fn columns(&mut self, x: f32x8<K>) {
        self.affine.columns(x);
        if self.perspective {
            self.inverse_w_across = x * self.inverse_w.dx;
        }
    }

    #[inline(always)]
    fn rows(&mut self, y: f32x8<K>) {
        self.affine.rows(y);
        if self.perspective {
            self.inverse_w_down = y * self.inverse_w.dy + self.inverse_w.value;
        }
    }

    #[inline(always)]
    fn colors(&self, wanted: mask32x8<K>) -> u32x8<K> {
        if self.perspective {
            let inverse_w = self.inverse_w_across + self.inverse_w_down;
            let inverse_w = inverse_w.max(self.inverse_w.low).min(self.inverse_w.high);
            let w = f32x8::splat(wanted.witness(), 1.0) / inverse_w;
            pack(self.channel(0, w), self.channel(1, w), self.channel(2, w))
        } else {
            self.affine.colors(wanted)
        }
    }
}

/// Rounds channels, 0 … 255.
#[inline(always)]
fn round<K: Simd>(v: f32x8<K>) -> u32x8<K> {
    round_bits(v, ROUND_F32) & 0xff
}

/// Channels → opaque pixels.
#[inline(always)]
fn pack<K: Simd>(r: u32x8<K>, g: u32x8<K>, b: u32x8<K>) -> u32x8<K> {
    (r | (g << 8)) | ((b << 16) | 0xff00_0000)
}

/// The colours of vertices.
pub(super) struct GouraudColors<K: Simd> {
    simd: K,
    planes: [Planes<K>; RGB],
    simple: mask32x8<K>,
    outside: bool,
}

impl<'a, K: Simd> Colors<'a, K> for GouraudColors<K> {
    type Simple = Affine<K>;
    type Shader = Gouraud<K>;

    #[inline(always)]
    fn new(
        simd: K,
        surface: &'a Surface,
        _triangles: &[u32],
        corners: &Corners,
        set_up: &SetUp<K>,
        outside: bool,
    ) -> Self {
        let rgba = |c: &Rgba| u32::from_le_bytes([c.r, c.g, c.b, c.a]);
        let (packed, present) = gather_colors(simd, vertex_colors(surface), corners, rgba);
        let zero = f32x8::splat(simd, 0.0);
        let mut planes = [Planes { value: zero, dx: zero, dy: zero, low: zero, high: zero }; RGB];
        for (plane, shift) in planes.iter_mut().zip([0, 8, 16]) {
            let mut channel = [zero; 3];
            for k in 0..3 {
                channel[k] = ((packed[k] >> shift) & 0xff).to_float();
            }
            *plane = set_up.planes(&channel);
        }
        let spread = planes[0].spread().max(planes[1].spread()).max(planes[2].spread());
        let mut simple = present & (spread * set_up.steepness()).simd_lt(STEEPEST);
        if !surface.inverse_w.is_empty() {
            let w = gather(simd, &surface.inverse_w, corners);
            let (far, near) = (w[0].min(w[1]).min(w[2]), w[0].max(w[1]).max(w[2]));
            // False if one is missing and therefore not a number.
            simple &= !perspective_matters(spread, far, near) & near.simd_eq(near);
        }
        Self { simd, planes, simple, outside }
    }

    #[inline(always)]
    fn simple(&self) -> mask32x8<K> {
        self.simple
    }

    #[inline(always)]
    fn of(&self, lane: usize) -> Affine<K> {
        let planes = [self.planes[0].of(lane), self.planes[1].of(lane), self.planes[2].of(lane)];
        let zero = [f32x8::splat(self.simd, 0.0); RGB];
        Affine { planes, across: zero, down: zero, outside: self.outside }
    }

    #[inline(always)]
    fn alone(
        simd: K,
        surface: &'a Surface,
        triangle: &Triangle,
        _index: u32,
        corners: [usize; 3],
    ) -> Option<Gouraud<K>> {
        let (planes, perspective, inverse_w) = gouraud_alone(simd, surface, triangle, corners)?;
        let zero = f32x8::splat(simd, 0.0);
        let affine = Affine { planes, across: [zero; RGB], down: [zero; RGB], outside: true };
        Some(Gouraud { affine, perspective, inverse_w, inverse_w_across: zero, inverse_w_down: zero })
    }
}

/// True if interpolating the colours of a triangle with regard to perspective makes a difference of half a step or
/// more. They differ by up to `spread` (steps of 255), and 1/w goes from `far` to `near`.
///
/// Between two vertices whose w have the ratio r, the perspective share of one differs from the affine share by at most
/// (√r − 1)/(√r + 1) ≤ (r − 1)/4.
#[inline(always)]
fn perspective_matters<K: Simd>(spread: f32x8<K>, far: f32x8<K>, near: f32x8<K>) -> mask32x8<K> {
    (spread * (near - far)).simd_gt(far * 2.0)
}

/// Planes of red, green and blue, true if they are divided by w, and the plane of 1/w.
fn gouraud_alone<K: Simd>(
    simd: K,
    surface: &Surface,
    triangle: &Triangle,
    corners: [usize; 3],
) -> Option<([AffineValue; RGB], bool, AffineValue)> {
    let colors = pick(vertex_colors(surface), corners)?;
    let colors = [colors.map(|c| f32::from(c.r)), colors.map(|c| f32::from(c.g)), colors.map(|c| f32::from(c.b))];
    let w = inverse_w(surface, corners)?;
    let inverse_w = triangle.plane(w);
    let planes = colors.map(|c| triangle.plane(c));
    let spread = planes.iter().map(|p| p.high - p.low).fold(0.0, greater);
    let [spread, far, near] = [spread, inverse_w.low, inverse_w.high].map(|v| f32x8::splat(simd, v));
    if !perspective_matters(spread, far, near).any_true() {
        return Some((planes, false, inverse_w));
    }
    let divided = |k: usize| {
        let [p, q, r] = colors[k];
        AffineValue { low: planes[k].low, high: planes[k].high, ..triangle.plane([p * w[0], q * w[1], r * w[2]]) }
    };
    Some(([divided(0), divided(1), divided(2)], true, inverse_w))
}

fn vertex_colors(surface: &Surface) -> &[Rgba] {
    match &surface.base {
        Base::Vertices(colors) => colors,
        Base::Solid(_) | Base::Faces(_) | Base::Texture { .. } => &[],
    }
}

/// The colours at each corner, as `pixel` makes them, and which triangles have all three.
#[inline(always)]
pub(super) fn gather_colors<K: Simd>(
    simd: K,
    colors: &[Rgba],
    corners: &Corners,
    pixel: impl Fn(&Rgba) -> Pixel,
) -> ([u32x8<K>; 3], mask32x8<K>) {
    let (mut packed, mut present) = ([[0; BATCH]; 3], [-1; BATCH]);
    for k in 0..3 {
        for l in 0..BATCH {
            match colors.get(corners[k][l] as usize) {
                Some(c) => packed[k][l] = pixel(c),
                None => present[l] = 0,
            }
        }
    }
    let [p, q, r] = &packed;
    let packed = [u32x8::from_slice(simd, p), u32x8::from_slice(simd, q), u32x8::from_slice(simd, r)];
    (packed, mask32x8::from_slice(simd, &present))
}

/// 1/w at the vertices of a triangle: 1 if the surface has none.
#[inline(always)]
fn inverse_w(surface: &Surface, corners: [usize; 3]) -> Option<[f32; 3]> {
    if surface.inverse_w.is_empty() { Some([1.0; 3]) } else { pick(&surface.inverse_w, corners) }
}
