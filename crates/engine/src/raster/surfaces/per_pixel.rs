//! Light, textures and translucent colours between vertices: computed at each pixel, eight at a time.
//!
//! The standard way interpolates each attribute divided by w. There are up to sixteen: normal, position, coordinates,
//! colour, light, place in a shadow map. Here the share of each vertex in a pixel is computed once, with one division,
//! and every attribute is the sum of its three values with these shares. Eight triangles are set up together. Each is
//! then painted on its own, eight pixels at a time, with the same attributes in all lanes.

use crate::appearance::{LightShare, Rgba, TextureReveal};
use crate::drawing::{Base, BlockedLight, Lighting, Shadow, Surface, SurfaceLight};
use crate::lighting::{light_eight, packed, with_light};
use crate::simd::prelude::*;

use super::batch::{BATCH, Corners, Planes, SetUp, gather, gather_points};
use super::filter::channel;
use super::setup::Triangle;
use super::shade::{Colors, Shader, gather_colors};
use super::shadow::arriving;
use super::texel::{Textured, all};
use crate::raster::grid::STEEPEST;
use crate::raster::pixel::{premultiply, premultiply_packed};

/// An attribute of the vertices of eight triangles, component by component.
type Attribute<K, const N: usize> = [[f32x8<K>; 3]; N];

/// The shader of pixels that are coloured one by one: a triangle in each lane.
#[derive(Clone)]
pub(super) struct PerPixel<'a, K: Simd> {
    surface: &'a Surface,
    triangles: [u32; BATCH],
    corners: Corners,
    /// The share of each vertex, without regard to perspective.
    planes: [Planes<K>; 3],
    inverse_w: [f32x8<K>; 3],
    base: BaseColors<'a, K>,
    light: LightOfEight<'a, K>,
    /// The first of the shadows. Those after it are read again at each pixel.
    shadow: Option<ShadowOn<K>>,
    /// Those that go together.
    simple: mask32x8<K>,
    x: f32x8<K>,
    y: f32x8<K>,
}

/// The base colours of eight triangles.
#[derive(Clone)]
enum BaseColors<'a, K: Simd> {
    /// One for each, [`packed`], not premultiplied.
    One(u32x8<K>),
    /// Premultiplied.
    Vertices(Attribute<K, 4>),
    /// With the tints of the vertices, premultiplied, if they have any.
    Texture(Textured<'a, K>, Option<Attribute<K, 4>>),
}

/// The light on eight triangles.
#[derive(Clone)]
enum LightOfEight<'a, K: Simd> {
    /// It's in their colours.
    InBase,
    /// It's found at their vertices.
    Vertices(Attribute<K, 2>),
    /// It's computed at each pixel, from attributes that are interpolated between the vertices.
    Pixels { normals: Attribute<K, 3>, positions: Attribute<K, 3>, lighting: &'a Lighting },
}

/// The shadow of one light on eight triangles.
#[derive(Clone, Copy)]
struct ShadowOn<K: Simd> {
    places: Attribute<K, 3>,
    planes: [f32x8<K>; 3],
    /// The light at the vertices that is missing in the shadow. None if light is found at pixels.
    taken: Option<Attribute<K, 2>>,
}

// The code for light, textures and shadows is long, and would be copied for each way of filling. So these are functions
// of their own, which all ways share.
impl<'a, K: Simd> PerPixel<'a, K> {
    #[inline(never)]
    fn apart(
        simd: K,
        surface: &'a Surface,
        planes: [Planes<K>; 3],
        list: &[u32],
        corners: Corners,
        simple: mask32x8<K>,
    ) -> Self {
        simd.vectorize(
            #[inline(always)]
            || Self::build(simd, surface, planes, list, corners, simple),
        )
    }

    /// The triangle of one lane in each.
    #[inline(never)]
    fn one(&self, lane: usize) -> Self {
        self.x.witness().vectorize(
            #[inline(always)]
            || self.only(lane),
        )
    }

    /// The colours at points relative to the origins of the triangles.
    #[inline(never)]
    fn colors_at(&self, wanted: mask32x8<K>, x: f32x8<K>, y: f32x8<K>) -> u32x8<K> {
        wanted.witness().vectorize(
            #[inline(always)]
            || self.at(wanted, x, y),
        )
    }
}

impl<'a, K: Simd> PerPixel<'a, K> {
    #[inline(always)]
    fn build(
        simd: K,
        surface: &'a Surface,
        planes: [Planes<K>; 3],
        list: &[u32],
        corners: Corners,
        simple: mask32x8<K>,
    ) -> Self {
        let mut triangles = [u32::MAX; BATCH];
        for (triangle, &listed) in triangles.iter_mut().zip(list) {
            *triangle = listed;
        }
        let affine =
            matches!(&surface.base, Base::Texture { sampler, .. } if sampler.reveal == Some(TextureReveal::Affine));
        let alike = affine || surface.inverse_w.is_empty();
        let inverse_w = if alike { [f32x8::splat(simd, 1.0); 3] } else { gather(simd, &surface.inverse_w, &corners) };
        let base = match &surface.base {
            Base::Solid(_) | Base::Faces(_) => {
                let color = |triangle: u32| surface.face_color(triangle as usize).map_or(0, packed);
                BaseColors::One(u32x8::from_slice(simd, &triangles.map(color)))
            }
            Base::Vertices(colors) => BaseColors::Vertices(of_vertices(simd, colors, &corners)),
            Base::Texture { image, sampler, uv, tint, tints } => {
                let mut change = [inverse_w; 2];
                for (k, plane) in planes.iter().enumerate() {
                    (change[0][k], change[1][k]) = (change[0][k] * plane.dx, change[1][k] * plane.dy);
                }
                let uv = gather_pairs(simd, uv, &corners);
                let tints = (!tints.is_empty()).then(|| of_vertices(simd, tints, &corners));
                let tint = if tints.is_some() { Rgba::rgb(255, 255, 255) } else { *tint };
                BaseColors::Texture(Textured::new(image, *sampler, tint, uv, change), tints)
            }
        };
        let light = match &surface.light {
            SurfaceLight::InBase => LightOfEight::InBase,
            SurfaceLight::Faces(shares) => LightOfEight::Vertices(of_faces(simd, shares, &triangles)),
            SurfaceLight::Vertices(shares) => LightOfEight::Vertices(gather_pairs(simd, shares, &corners)),
            SurfaceLight::PerPixel(light) => LightOfEight::Pixels {
                normals: gather_points(simd, &light.normals, &corners),
                positions: gather_points(simd, &light.positions, &corners),
                lighting: &light.lighting,
            },
        };
        let mut shadow = None;
        if let Some(first) = surface.shadows.first() {
            shadow = Some(ShadowOn::new(simd, first, &triangles, &corners));
        }
        let zero = f32x8::splat(simd, 0.0);
        Self { surface, triangles, corners, planes, inverse_w, base, light, shadow, simple, x: zero, y: zero }
    }

    #[inline(always)]
    fn only(&self, lane: usize) -> Self {
        let base = match &self.base {
            BaseColors::One(colors) => BaseColors::One(u32x8::splat(colors.witness(), colors[lane])),
            BaseColors::Vertices(channels) => BaseColors::Vertices(all_of(channels, lane)),
            BaseColors::Texture(textured, tints) => {
                BaseColors::Texture(textured.of(lane), tints.as_ref().map(|tints| all_of(tints, lane)))
            }
        };
        let light = match &self.light {
            LightOfEight::InBase => LightOfEight::InBase,
            LightOfEight::Vertices(shares) => LightOfEight::Vertices(all_of(shares, lane)),
            LightOfEight::Pixels { normals, positions, lighting } => {
                LightOfEight::Pixels { normals: all_of(normals, lane), positions: all_of(positions, lane), lighting }
            }
        };
        let shadow = match &self.shadow {
            Some(on) => Some(ShadowOn {
                places: all_of(&on.places, lane),
                planes: all(&on.planes, lane),
                taken: match &on.taken {
                    Some(taken) => Some(all_of(taken, lane)),
                    None => None,
                },
            }),
            None => None,
        };
        let planes = &self.planes;
        Self {
            surface: self.surface,
            triangles: [self.triangles[lane]; BATCH],
            corners: self.corners.map(|corner| [corner[lane]; BATCH]),
            planes: [planes[0].all(lane), planes[1].all(lane), planes[2].all(lane)],
            inverse_w: all(&self.inverse_w, lane),
            base,
            light,
            shadow,
            simple: self.simple,
            x: self.x,
            y: self.y,
        }
    }

    /// The share of each vertex at these points, and the sum by which they were divided.
    #[inline(always)]
    fn shares(&self, x: f32x8<K>, y: f32x8<K>) -> ([f32x8<K>; 3], f32x8<K>) {
        let mut b = self.inverse_w;
        for (b, plane) in b.iter_mut().zip(&self.planes) {
            *b *= plane.hold(plane.at(x, y));
        }
        let sum = b[0] + b[1] + b[2];
        ([b[0] / sum, b[1] / sum, b[2] / sum], sum)
    }

    /// One of the shadows, as these triangles take it.
    #[inline(always)]
    fn on(&self, simd: K, number: usize, shadow: &Shadow) -> ShadowOn<K> {
        match self.shadow {
            Some(first) if number == 0 => first,
            _ => ShadowOn::new(simd, shadow, &self.triangles, &self.corners),
        }
    }

    /// Baked light where shadows fall: the rest of it.
    #[inline(always)]
    fn shadowed(&self, mut left: [f32x8<K>; 2], wanted: mask32x8<K>, w: [f32x8<K>; 3]) -> [f32x8<K>; 2] {
        let simd = wanted.witness();
        for (number, shadow) in self.surface.shadows.iter().enumerate() {
            let on = self.on(simd, number, shadow);
            let Some(taken) = on.taken else { continue };
            let taken = mix(w, &taken);
            // If the lamp gives no light there is no shadow to look for.
            let lit = wanted & (taken[0].simd_gt(0.0) | taken[1].simd_gt(0.0));
            if let Some(arriving) = arriving(shadow, lit, mix(w, &on.places), on.planes) {
                let missing = f32x8::splat(simd, 1.0) - arriving;
                left = [left[0] - taken[0] * missing, left[1] - taken[1] * missing];
            }
        }
        left
    }

    /// The share of one light that no shadow takes away. `None` means all of it.
    #[inline(always)]
    fn arriving_of(&self, light: usize, wanted: mask32x8<K>, w: [f32x8<K>; 3]) -> Option<f32x8<K>> {
        for (number, shadow) in self.surface.shadows.iter().enumerate() {
            if shadow.taken == BlockedLight::Light(light) {
                let on = self.on(wanted.witness(), number, shadow);
                return arriving(shadow, wanted, mix(w, &on.places), on.planes);
            }
        }
        None
    }

    #[inline(always)]
    fn at(&self, wanted: mask32x8<K>, x: f32x8<K>, y: f32x8<K>) -> u32x8<K> {
        let simd = wanted.witness();
        let (w, sum) = self.shares(x, y);
        let own = match &self.base {
            BaseColors::One(colors) => *colors,
            BaseColors::Vertices(colors) => bytes(mix(w, colors)),
            BaseColors::Texture(textured, tints) => {
                let mut colors = textured.colors(wanted, mix(w, &textured.uv), f32x8::splat(simd, 1.0) / sum);
                if let Some(tints) = tints {
                    let tint = mix(w, tints);
                    for k in 0..4 {
                        colors[k] *= tint[k] * (1.0 / 255.0);
                    }
                }
                bytes(colors)
            }
        };
        let most = match &self.base {
            BaseColors::One(_) => f32x8::splat(simd, 255.0),
            BaseColors::Vertices(_) | BaseColors::Texture(..) => channel(own >> 24),
        };
        let lit = match &self.light {
            LightOfEight::InBase => own,
            LightOfEight::Vertices(shares) => with_light(simd, self.shadowed(mix(w, shares), wanted, w), own, most),
            LightOfEight::Pixels { normals, positions, lighting } => {
                let shares = light_eight(
                    simd,
                    lighting,
                    mix(w, normals),
                    mix(w, positions),
                    #[inline(always)]
                    |light, lit| self.arriving_of(light, wanted & lit, w),
                );
                with_light(simd, shares, own, most)
            }
        };
        match &self.base {
            // The alpha of opaque surfaces doesn't count.
            _ if !self.surface.translucent => lit | 0xff00_0000,
            BaseColors::One(_) => premultiply_packed(lit),
            BaseColors::Vertices(_) | BaseColors::Texture(..) => lit,
        }
    }
}

impl<K: Simd> Shader<K> for PerPixel<'_, K> {
    #[inline(always)]
    fn columns(&mut self, x: f32x8<K>) {
        self.x = x;
    }

    #[inline(always)]
    fn rows(&mut self, y: f32x8<K>) {
        self.y = y;
    }

    #[inline(always)]
    fn colors(&self, wanted: mask32x8<K>) -> u32x8<K> {
        self.colors_at(wanted, self.x, self.y)
    }
}

impl<'a, K: Simd> Colors<'a, K> for PerPixel<'a, K> {
    type Simple = Self;
    type Shader = Self;

    #[inline(always)]
    fn new(
        simd: K,
        surface: &'a Surface,
        triangles: &[u32],
        corners: &Corners,
        set_up: &SetUp<K>,
        _outside: bool,
    ) -> Self {
        let (zero, one) = (f32x8::splat(simd, 0.0), f32x8::splat(simd, 1.0));
        // The value of each vertex whose share is wanted.
        let planes =
            [set_up.planes(&[one, zero, zero]), set_up.planes(&[zero, one, zero]), set_up.planes(&[zero, zero, one])];
        // Shares are as exact as colours if these go together, because only the differences of attributes count.
        let simple = (set_up.steepness() * 255.0).simd_lt(STEEPEST) & present(simd, surface, triangles, corners);
        Self::apart(simd, surface, planes, triangles, *corners, simple)
    }

    #[inline(always)]
    fn simple(&self) -> mask32x8<K> {
        self.simple
    }

    #[inline(always)]
    fn of(&self, lane: usize) -> Self {
        self.one(lane)
    }

    #[inline(always)]
    fn alone(simd: K, surface: &'a Surface, triangle: &Triangle, index: u32, corners: [usize; 3]) -> Option<Self> {
        let corner = |corner: usize| u32::try_from(corner).map(|corner| [corner; BATCH]);
        let corners = [corner(corners[0]).ok()?, corner(corners[1]).ok()?, corner(corners[2]).ok()?];
        if present(simd, surface, &[index], &corners)[0] == 0 {
            return None;
        }
        let planes = [
            Planes::splat(simd, triangle.plane([1.0, 0.0, 0.0])),
            Planes::splat(simd, triangle.plane([0.0, 1.0, 0.0])),
            Planes::splat(simd, triangle.plane([0.0, 0.0, 1.0])),
        ];
        let none = mask32x8::splat(simd, 0);
        Some(Self::apart(simd, surface, planes, &[index; BATCH], corners, none))
    }
}

/// The triangles for which the arrays of the surface have all values that are read.
#[inline(always)]
fn present<K: Simd>(simd: K, surface: &Surface, triangles: &[u32], corners: &Corners) -> mask32x8<K> {
    let (mut vertices, mut faces) = (surface.positions.len(), surface.triangles.len());
    if !surface.inverse_w.is_empty() {
        vertices = vertices.min(surface.inverse_w.len());
    }
    match &surface.base {
        Base::Solid(_) => {}
        Base::Faces(colors) => faces = faces.min(colors.len()),
        Base::Vertices(colors) => vertices = vertices.min(colors.len()),
        Base::Texture { uv, tints, .. } => {
            vertices = vertices.min(uv.len());
            if !tints.is_empty() {
                vertices = vertices.min(tints.len());
            }
        }
    }
    match &surface.light {
        SurfaceLight::InBase => {}
        SurfaceLight::Faces(shares) => faces = faces.min(shares.len()),
        SurfaceLight::Vertices(shares) => vertices = vertices.min(shares.len()),
        SurfaceLight::PerPixel(light) => vertices = vertices.min(light.normals.len()).min(light.positions.len()),
    }
    let mut present = [0; BATCH];
    for (l, (present, &triangle)) in present.iter_mut().zip(triangles).enumerate() {
        let are_there = corners.iter().all(|corner| (corner[l] as usize) < vertices);
        *present = -i32::from(are_there && (triangle as usize) < faces);
    }
    mask32x8::from_slice(simd, &present)
}

impl<K: Simd> ShadowOn<K> {
    /// A triangle without known values is lit, as one whose values aren't numbers.
    #[inline(always)]
    fn new(simd: K, shadow: &Shadow, triangles: &[u32; BATCH], corners: &Corners) -> Self {
        let taken = match &shadow.taken {
            BlockedLight::Faces(shares) => Some(of_faces(simd, shares, triangles)),
            BlockedLight::Vertices(shares) => Some(gather_pairs(simd, shares, corners)),
            BlockedLight::Light(_) => None,
        };
        let [x, y, z] = gather_points(simd, &shadow.planes, &[*triangles; 3]);
        Self { places: gather_points(simd, &shadow.places, corners), planes: [x[0], y[0], z[0]], taken }
    }
}

/// An attribute of the triangle of one lane in each.
#[inline(always)]
fn all_of<K: Simd, const N: usize>(attribute: &Attribute<K, N>, lane: usize) -> Attribute<K, N> {
    let mut one = *attribute;
    for k in 0..N {
        one[k] = all(&attribute[k], lane);
    }
    one
}

/// Colours at each corner, premultiplied, by channel.
#[inline(always)]
fn of_vertices<K: Simd>(simd: K, colors: &[Rgba], corners: &Corners) -> Attribute<K, 4> {
    let (colors, _) = gather_colors(simd, colors, corners, |c| premultiply(*c));
    let mut channels = [[f32x8::splat(simd, 0.0); 3]; 4];
    for k in 0..3 {
        for (channels, shift) in channels.iter_mut().zip([0, 8, 16, 24]) {
            channels[k] = channel(colors[k] >> shift);
        }
    }
    channels
}

/// Pairs at each corner, by component. NaN if there are none.
#[inline(always)]
fn gather_pairs<K: Simd>(simd: K, pairs: &[[f32; 2]], corners: &Corners) -> Attribute<K, 2> {
    let mut result = [[f32x8::splat(simd, f32::NAN); 3]; 2];
    for (k, corner) in corners.iter().enumerate() {
        let mut lanes = [[f32::NAN; BATCH]; 2];
        for (l, &corner) in corner.iter().enumerate() {
            if let Some(&pair) = pairs.get(corner as usize) {
                (lanes[0][l], lanes[1][l]) = pair.into();
            }
        }
        for (component, lanes) in result.iter_mut().zip(&lanes) {
            component[k] = f32x8::from_slice(simd, lanes);
        }
    }
    result
}

/// The light of faces as that of their vertices.
#[inline(always)]
fn of_faces<K: Simd>(simd: K, shares: &[LightShare], triangles: &[u32; BATCH]) -> Attribute<K, 2> {
    gather_pairs(simd, shares, &[*triangles; 3])
}

/// The values between those of three vertices, component by component.
#[inline(always)]
fn mix<K: Simd, const N: usize>(w: [f32x8<K>; 3], values: &Attribute<K, N>) -> [f32x8<K>; N] {
    let mut mixed = [w[0]; N];
    for k in 0..N {
        mixed[k] = w[0] * values[k][0] + w[1] * values[k][1] + w[2] * values[k][2];
    }
    mixed
}

/// Channels → pixels: rounded, a half up, and held to 0 … 255.
#[inline(always)]
fn bytes<K: Simd>([r, g, b, a]: [f32x8<K>; 4]) -> u32x8<K> {
    (byte(r) | (byte(g) << 8)) | ((byte(b) << 16) | (byte(a) << 24))
}

#[inline(always)]
fn byte<K: Simd>(v: f32x8<K>) -> u32x8<K> {
    (v + 0.5).max(0.0).min(255.0).to_int::<i32x8<K>>().bitcast()
}
