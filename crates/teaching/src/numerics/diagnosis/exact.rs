//! Compares the image with exact visibility, pixel by pixel.
//!
//! A depth buffer, an order of painting and a shadow map each decide with rounded numbers which surface is in front.
//! Here a ray through the centre of each pixel decides in `f64`, against all opaque faces. A pixel counts as wrong only
//! if the rasterizer can't have meant another face. The face it drew has to lie behind the nearest one at the centre of
//! the pixel and a quarter of a pixel to each side. So silhouettes, whose pixels belong to either face, are never
//! wrong.
//!
//! Translucent faces all count, not only the nearest. They're compared with the image that a BSP tree paints.

use std::collections::BTreeSet;

use glam::DVec3;

use super::count::{Counter, numbered};
use super::{Cause, ImageSpec};
use crate::appearance::{DepthFormat, HiddenLines, Rgba, Shading, Style, TextureReveal, Visibility};
use crate::camera::ImageSize;
use crate::figure::ShadowReveal;
use crate::limits::{MAX_RAY_TRIANGLES, MAX_STEPPED_PIXELS};
use crate::picture::shadow_truth::{TrueLight, Verdict, arriving, by_rows, center, under};
use crate::picture::tiles::Tiles;
use crate::pipeline::shadow_rays::{SeenPoint, Solids, to_light};
use crate::pipeline::{Pipeline, light_cameras};
use crate::progress::Progress;
use crate::raster::Rasterizer;
use crate::scene::{Light, LightKind, Object, ObjectPaint, Scene};

/// The distance of the further rays from the centre of a pixel, in pixels.
const ASIDE: f64 = 0.25;
/// Colours of two images that differ by this much in a channel, of 255, differ visibly.
const VISIBLE: u8 = 4;
/// Fewer wrong pixels than this are no fault, because three faces share a pixel at corners.
const FEW_WRONG: u64 = 3;
/// The least share of the pixels turned towards a light at which wrong shadows are a fault. A map has texels, so a few
/// pixels at the foot of a thing are wrong in every image.
const WRONG_SHADOWS: f64 = 5e-4;
/// The greatest number of pixels in which shadows are compared. Each takes a ray to every light. In a larger image,
/// fewer of its pixels are compared, evenly spread.
const SHADOW_PIXELS: u64 = 1 << 16;

/// The greatest number of faces to sort if any of them is translucent. More take seconds.
const MAX_LAYERED: usize = 1 << 15;

/// A kind of wrong pixels in an image.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fault {
    pub(super) cause: Cause,
    pub(super) pixels: WrongPixels,
    /// The objects concerned, by their places in the scene, in its order.
    pub(super) objects: Vec<usize>,
}

/// Wrong pixels, and the pixels that were compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongPixels {
    /// Pixels that show something else than they should.
    pub wrong: u64,
    /// The compared pixels: those that the scene covers, or those turned towards a light.
    pub of: u64,
}

impl WrongPixels {
    /// The share of wrong pixels, 0 … 1.
    pub fn share(self) -> f64 {
        let [wrong, of] = [self.wrong, self.of].map(|pixels| pixels as f64);
        wrong / of.max(1.0)
    }
}

/// Compares an image with exact visibility. A [`Cause::NotCompared`] means that this would take too long. `None` if it
/// was cancelled. It pauses on the way.
pub(super) async fn faults(spec: &ImageSpec<'_>, counter: &mut Counter, progress: &Progress) -> Option<Vec<Fault>> {
    let mut faults = Vec::new();
    let rounded = &ImageSpec { image: smaller(spec.image, spec.compared), ..*spec };
    // All other faults are judged with exact vertices.
    let style = spec.style.with_exact_vertices();
    let spec = &ImageSpec { style: &style, ..*rounded };
    let pixels = u64::from(spec.image.width) * u64::from(spec.image.height);
    if spec.style.shading == Shading::Wireframe {
        // Lines hide nothing.
        return Some(faults);
    }
    if pixels > MAX_STEPPED_PIXELS || Solids::count(spec.scene) > MAX_RAY_TRIANGLES {
        return Some(vec![not_compared(Vec::new())]);
    }
    faults.extend(vertices(rounded, spec, counter));
    faults.extend(faces(spec, counter, progress).await?);
    faults.extend(layers(spec, counter));
    if progress.is_cancelled() {
        return None;
    }
    faults.extend(affine(spec, counter));
    faults.extend(shadows(spec, progress).await?);
    faults.retain(|fault| fault.pixels.wrong >= FEW_WRONG || fault.cause == Cause::NotCompared);
    once_each(&mut faults);
    Some(faults)
}

/// Keeps, for each cause, the fault with the most wrong pixels, in the order in which the causes came.
fn once_each(faults: &mut Vec<Fault>) {
    let most = |cause| faults.iter().filter(|fault| fault.cause == cause).map(|fault| fault.pixels.wrong).max();
    let greatest: Vec<bool> = faults.iter().map(|fault| most(fault.cause) == Some(fault.pixels.wrong)).collect();
    let (mut greatest, mut known) = (greatest.into_iter(), Vec::new());
    faults.retain(|fault| {
        let is_new = greatest.next() == Some(true) && !known.contains(&fault.cause);
        if is_new {
            known.push(fault.cause);
        }
        is_new
    });
}

/// The finding that an image wasn't compared.
fn not_compared(objects: Vec<usize>) -> Fault {
    Fault { cause: Cause::NotCompared, pixels: WrongPixels { wrong: 0, of: 0 }, objects }
}

/// The pixels that show an opaque or translucent face of the wrong depth. `None` if it was cancelled.
pub(in crate::numerics) async fn wrong_faces(
    spec: &ImageSpec<'_>,
    counter: &mut Counter,
    progress: &Progress,
) -> Option<u64> {
    let spec = &ImageSpec { image: smaller(spec.image, spec.compared), ..*spec };
    let opaque = faces(spec, counter, progress).await?;
    Some(opaque.into_iter().chain(layers(spec, counter)).map(|fault| fault.pixels.wrong).sum())
}

/// Opaque faces in front of nearer ones. The outer `None` means it was cancelled.
async fn faces(spec: &ImageSpec<'_>, counter: &mut Counter, progress: &Progress) -> Option<Option<Fault>> {
    let Some(faces) = Faces::new(spec) else { return Some(Some(not_compared(Vec::new()))) };
    let drawn = counter.numbered(spec, &faces.objects);
    faces.compare(&drawn, progress).await
}

/// The opaque faces of a scene, for rays.
struct Faces<'a> {
    spec: &'a ImageSpec<'a>,
    tiles: Tiles<'a>,
    /// The objects that have opaque faces, by their places in the scene.
    objects: Vec<usize>,
    /// The number of the first triangle of each of them.
    first: Vec<usize>,
}

/// The face in a pixel.
enum FaceVerdict {
    /// No face, or one of two that meet in the pixel.
    Open,
    Right,
    /// The object in the image, and the one in front of it.
    Wrong([usize; 2]),
}

impl<'a> Faces<'a> {
    /// `None` if listing the faces would take too much memory.
    fn new(spec: &'a ImageSpec<'a>) -> Option<Self> {
        let all = &spec.scene.objects;
        let objects: Vec<usize> = (0..).zip(all).filter(|(_, o)| is_solid(o)).map(|(place, _)| place).collect();
        let first = objects.iter().scan(0, |next, &place| {
            let first = *next;
            *next += all[place].mesh.triangles.len();
            Some(first)
        });
        let first = first.collect();
        let tiles = Tiles::new(objects.iter().map(|&place| &all[place]), spec.camera, spec.image)?;
        Some(Self { spec, tiles, objects, first })
    }

    /// The object of a triangle, by its place in the scene, and the number of the triangle in it.
    fn object(&self, triangle: usize) -> (usize, usize) {
        let place = self.first.partition_point(|&first| first <= triangle).saturating_sub(1);
        (self.objects.get(place).copied().unwrap_or(0), triangle - self.first.get(place).copied().unwrap_or(0))
    }

    async fn compare(&self, drawn: &[u32], progress: &Progress) -> Option<Option<Fault>> {
        let verdict = |pixel: [u32; 2], at: usize| self.verdict(pixel.map(center), drawn.get(at).copied().unwrap_or(0));
        let verdicts = by_rows(self.spec.image, progress, verdict).await?;
        let (mut pixels, mut objects) = (WrongPixels { wrong: 0, of: 0 }, BTreeSet::new());
        for verdict in verdicts {
            match verdict {
                FaceVerdict::Open => {}
                FaceVerdict::Right => pixels.of += 1,
                FaceVerdict::Wrong(both) => {
                    pixels.of += 1;
                    pixels.wrong += 1;
                    objects.extend(both);
                }
            }
        }
        let in_order = self.spec.style.visibility == Visibility::Painter;
        let cause = if in_order { Cause::WrongOrder } else { Cause::DepthConflict };
        Some((pixels.wrong > 0).then(|| Fault { cause, pixels, objects: objects.into_iter().collect() }))
    }

    /// Judges the face with a number, from 1, at a place of the image.
    fn verdict(&self, place: [f64; 2], number: u32) -> FaceVerdict {
        let Some(drawn) = (number as usize).checked_sub(1) else { return FaceVerdict::Open };
        let Some(nearest) = self.tiles.nearest(place) else { return FaceVerdict::Open };
        if nearest.triangle == drawn {
            return FaceVerdict::Right;
        }
        let [x, y] = place;
        let around = [[0.0, 0.0], [ASIDE, 0.0], [-ASIDE, 0.0], [0.0, ASIDE], [0.0, -ASIDE]];
        let is_behind = |[dx, dy]: [f64; 2]| {
            let place = [x + dx, y + dy];
            let nearest = self.tiles.nearest(place);
            nearest
                .and_then(|nearest| self.tiles.behind(drawn, place, nearest.depth))
                .is_some_and(|errors| errors > 1.0)
        };
        if self.look_different(nearest.triangle, drawn) && around.into_iter().all(is_behind) {
            FaceVerdict::Wrong([self.object(drawn).0, self.object(nearest.triangle).0])
        } else {
            FaceVerdict::Open
        }
    }

    /// True if two faces have different colours.
    fn look_different(&self, nearest: usize, drawn: usize) -> bool {
        let ((a, i), (b, j)) = (self.object(nearest), self.object(drawn));
        let [front, back] = [a, b].map(|object| &self.spec.scene.objects[object]);
        let same_colour = match (face_color(front, i), face_color(back, j)) {
            (Some(front), Some(back)) => front == back,
            _ => a == b,
        };
        let parallel = || {
            let normals = self.tiles.normal(nearest).zip(self.tiles.normal(drawn));
            normals.is_some_and(|(a, b)| a.dot(b).abs() > 1.0 - 1e-9)
        };
        !same_colour || (front.lit || back.lit) && !parallel()
    }
}

fn is_solid(object: &Object) -> bool {
    object.faces && !object.mesh.triangles.is_empty() && !object.paint.is_translucent()
}

/// The colour of a face that has one colour.
fn face_color(object: &Object, triangle: usize) -> Option<Rgba> {
    match &object.paint {
        ObjectPaint::Solid(color) => Some(*color),
        ObjectPaint::Faces(colors) => colors.get(triangle).copied(),
        ObjectPaint::Vertices(_) | ObjectPaint::Texture(_) => None,
    }
}

/// Pixels that show another face than with exact vertices.
fn vertices(spec: &ImageSpec<'_>, exact: &ImageSpec<'_>, counter: &mut Counter) -> Option<Fault> {
    if spec.style == exact.style {
        return None;
    }
    let faces = Faces::new(exact)?;
    let [drawn, meant] = [spec, exact].map(|spec| counter.numbered(spec, &faces.objects));
    let (mut pixels, mut objects) = (WrongPixels { wrong: 0, of: 0 }, BTreeSet::new());
    for pair in drawn.into_iter().zip(meant).filter(|pair| *pair != (0, 0)) {
        pixels.of += 1;
        if pair.0 != pair.1 {
            pixels.wrong += 1;
            let of = |number: u32| (number as usize).checked_sub(1).map(|triangle| faces.object(triangle).0);
            objects.extend([pair.0, pair.1].into_iter().filter_map(of));
        }
    }
    Some(Fault { cause: Cause::VertexRounding, pixels, objects: objects.into_iter().collect() })
}

/// Translucent faces in the wrong order. The image, without light, differs from the one that a BSP tree paints. Several
/// layers of one pixel are sorted by the depths of their centroids, which is wrong for long faces.
///
/// It also finds depths that the figure's format confuses between a translucent face and others, because rays only know
/// opaque faces.
fn layers(spec: &ImageSpec<'_>, counter: &mut Counter) -> Vec<Fault> {
    let objects = spec.scene.objects.iter().enumerate();
    let is_clear = |object: &Object| object.faces && object.paint.is_translucent();
    let clear: Vec<usize> = objects.filter(|(_, object)| is_clear(object)).map(|(place, _)| place).collect();
    if clear.is_empty() {
        return Vec::new();
    }
    let scene = plain(spec.scene, |_| true);
    let faces: usize = scene.objects.iter().map(|object| object.mesh.triangles.len()).sum();
    let float = Style { depth_format: DepthFormat::Float, ..*spec.style };
    let by_tree = Style { visibility: Visibility::Bsp, ..float };
    let exact = (faces <= MAX_LAYERED).then(|| counter.colors(&scene, spec, &by_tree)).flatten();
    let Some(exact) = exact else { return vec![not_compared(clear)] };
    if spec.style.visibility == Visibility::Bsp {
        return Vec::new();
    }
    let Some(in_float) = counter.colors(&scene, spec, &float) else { return vec![not_compared(clear)] };
    let order = differing(&in_float, &exact, spec.image);
    let own = (*spec.style != float).then(|| counter.colors(&scene, spec, spec.style)).flatten();
    let depth = own.map(|own| differing(&own, &in_float, spec.image));
    let depth = depth.map(|pixels| Fault { cause: Cause::DepthConflict, pixels, objects: clear.clone() });
    std::iter::once(Fault { cause: Cause::WrongOrder, pixels: order, objects: clear }).chain(depth).collect()
}

/// A texture interpolated without w, if that changes it.
fn affine(spec: &ImageSpec<'_>, counter: &mut Counter) -> Option<Fault> {
    if spec.reveal.texture != Some(TextureReveal::Affine) {
        return None;
    }
    let objects = spec.scene.objects.iter().enumerate();
    let is_textured = |object: &Object| object.faces && matches!(object.paint, ObjectPaint::Texture(_));
    let textured: Vec<usize> = objects.filter(|(_, object)| is_textured(object)).map(|(place, _)| place).collect();
    let right = plain(spec.scene, |_| true);
    let mut wrong = right.clone();
    for object in &mut wrong.objects {
        if let ObjectPaint::Texture(pictured) = &mut object.paint {
            pictured.sampler.reveal = Some(TextureReveal::Affine);
        }
    }
    let [wrong, right] = [wrong, right].map(|scene| counter.colors(&scene, spec, spec.style));
    let pixels = differing(&wrong?, &right?, spec.image);
    Some(Fault { cause: Cause::AffineTexture, pixels, objects: textured })
}

/// The faces of a scene in their own colours, without light and strokes.
fn plain(scene: &Scene, wanted: impl Fn(&Object) -> bool) -> Scene {
    let bare = |object: &Object| Object { lit: false, edges: None, outline: None, ..object.clone() };
    let objects = scene.objects.iter().filter(|object| object.faces && wanted(object)).map(bare).collect();
    Scene { objects, ..Scene::default() }
}

/// Compares two images. A pixel differs if at least three of its neighbours do too, because pieces that meet at an edge
/// may each take a single pixel of it.
fn differing(a: &[u8], b: &[u8], image: ImageSize) -> WrongPixels {
    let [a, b] = [a, b].map(|bytes| bytes.chunks_exact(4));
    let covered = a.clone().zip(b.clone()).filter(|(a, b)| a[3] > 0 || b[3] > 0).count() as u64;
    let differs: Vec<bool> = a.zip(b).map(|(a, b)| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > VISIBLE)).collect();
    let at = |x: i64, y: i64| {
        let [x, y] = [x, y].map(|v| u32::try_from(v).unwrap_or(u32::MAX));
        x < image.width && y < image.height && differs.get((y * image.width + x) as usize).copied().unwrap_or(false)
    };
    let mut wrong = 0;
    for y in 0..i64::from(image.height) {
        for x in 0..i64::from(image.width) {
            let around = || (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy)));
            wrong += u64::from(at(x, y) && around().filter(|&(x, y)| at(x, y)).count() > 3);
        }
    }
    WrongPixels { wrong, of: covered }
}

/// Shadows that a map gets wrong: faces that shadow themselves, and shadows detached from the thing that casts them.
pub(super) async fn shadows(spec: &ImageSpec<'_>, progress: &Progress) -> Option<Vec<Fault>> {
    let mut faults = Vec::new();
    if !spec.scene.lights.iter().any(|light| light.shadows.cast) {
        return Some(faults);
    }
    let spec = &ImageSpec { image: smaller(spec.image, SHADOW_PIXELS), ..*spec };
    let solids = &Solids::of(spec.scene);
    let (mut pipeline, mut rasterizer) = (Pipeline::default(), Rasterizer::default());
    rasterizer.watch(progress);
    for light in spec.scene.lights.iter().filter(|light| light.shadows.cast) {
        let mut light = *light;
        if spec.reveal.shadows == Some(ShadowReveal::Acne) {
            light.shadows.bias = 0.0;
        }
        let Some(texels) = Texels::new(spec.scene, &light) else { continue };
        let drawing = arriving(&mut pipeline, &under(spec.scene, light), spec.camera, spec.image);
        let shares = rasterizer.paint(&drawing)?;
        if progress.is_cancelled() {
            return None;
        }
        let truth = TrueLight::by_rays(solids, spec.camera, &light, spec.image, progress).await?;
        let verdicts = truth.judge(&shares, solids, spec.camera, progress).await?;
        let cause = |pixel: [u32; 2], at: usize| {
            let verdict = verdicts.get(at).copied().filter(|verdict| verdict.is_wrong())?;
            let seen = solids.seen(spec.camera, spec.image, pixel.map(center))?;
            let is_all = |lit: bool| {
                texels
                    .around(&seen, &light)
                    .is_some_and(|points| points.into_iter().all(|p| solids.is_lit(p, seen.triangle, &light) == lit))
            };
            match verdict {
                Verdict::WronglyDark if is_all(true) => Some(Cause::ShadowAcne),
                Verdict::WronglyLit if is_all(false) => Some(Cause::ShadowDetached),
                _ => None,
            }
        };
        let causes = by_rows(spec.image, progress, cause).await?;
        let of = verdicts.iter().filter(|verdict| **verdict != Verdict::None).count() as u64;
        for cause in [Cause::ShadowAcne, Cause::ShadowDetached] {
            let wrong = causes.iter().filter(|found| **found == Some(cause)).count() as u64;
            faults.push(Fault { cause, pixels: WrongPixels { wrong, of }, objects: Vec::new() });
        }
    }
    faults.retain(|fault| fault.pixels.share() > WRONG_SHADOWS);
    once_each(&mut faults);
    Some(faults)
}

/// The size of an image with every k-th pixel across and down, so that it has at most this many.
fn smaller(image: ImageSize, most: u64) -> ImageSize {
    let ImageSize { width, height } = image;
    let fits = |k: &u32| u64::from(width / k) * u64::from(height / k) <= most;
    let k = (1..).find(fits).unwrap_or(1);
    ImageSize { width: (width / k).max(1), height: (height / k).max(1) }
}

/// The texels of a light's map, as they lie on surfaces.
struct Texels {
    /// Width of a texel at the distance 1 from a lamp, or at every distance from a parallel light, in scene units.
    width: f64,
    /// The radius within which the map may take one point for another, in texels: half of
    /// the soft edge, and one.
    radius: f64,
}

impl Texels {
    fn new(scene: &Scene, light: &Light) -> Option<Self> {
        let shadows = light.shadows.held();
        let camera = light_cameras(scene, light)?.into_iter().next()?;
        let side = match light.kind {
            LightKind::Directional => camera.window_width(),
            LightKind::Point => camera.window_width() / camera.near(),
        };
        let radius = 0.5 * shadows.softness + 1.0;
        Some(Self { width: side / f64::from(shadows.map), radius })
    }

    /// Points on the plane of a face around a point of it, as far away as the map may confuse them. If the map
    /// contradicts the ray at all of them too, no border of a shadow is near. `None` if the light grazes the face.
    fn around(&self, seen: &SeenPoint, light: &Light) -> Option<Vec<DVec3>> {
        let (to_light, _) = to_light(seen.point, light);
        let facing = to_light.dot(seen.normal);
        if facing < 0.02 {
            return None;
        }
        let distance = match light.kind {
            LightKind::Directional => 1.0,
            LightKind::Point => (seen.point - light.vector).abs().max_element(),
        };
        let (u, v) = to_light.any_orthonormal_pair();
        let radius = self.radius * self.width * distance * std::f64::consts::SQRT_2;
        let ring = |radius: f64| {
            (0..8).map(move |k| {
                let (sin, cos) = (f64::from(k) * std::f64::consts::FRAC_PI_4).sin_cos();
                let aside = (u * cos + v * sin) * radius;
                // Along the light, back to the plane of the face.
                seen.point + aside - to_light * (aside.dot(seen.normal) / facing)
            })
        };
        Some(ring(radius).chain(ring(0.5 * radius)).collect())
    }
}

impl Counter {
    /// The number of the opaque face at each pixel, from 1, according to the figure's own order and depth format.
    fn numbered(&mut self, spec: &ImageSpec<'_>, objects: &[usize]) -> Vec<u32> {
        let mut next = 1;
        let numbered_objects = objects.iter().map(|&place| {
            let object = &spec.scene.objects[place];
            let first = next;
            next += u32::try_from(object.mesh.triangles.len()).unwrap_or(0);
            numbered(object, |triangle| first + u32::try_from(triangle).unwrap_or(0))
        });
        let scene = Scene { objects: numbered_objects.collect(), ..Scene::default() };
        let style = Style { shading: Shading::Flat, hidden_lines: HiddenLines::Hidden, ..*spec.style };
        let mut numbers = Vec::new();
        self.paint(&scene, spec.camera, &style, spec.image, |[r, g, b, _]| {
            numbers.push(u32::from_be_bytes([0, r, g, b]));
        });
        numbers
    }

    /// The colours of a scene, four bytes for each pixel, with one sample per pixel. `None` if there are too many faces
    /// to sort.
    fn colors(&mut self, scene: &Scene, spec: &ImageSpec<'_>, style: &Style) -> Option<Vec<u8>> {
        let mut bytes = Vec::new();
        let style = Style { hidden_lines: HiddenLines::Hidden, ..*style };
        let drawn = self.paint(scene, spec.camera, &style, spec.image, |pixel| bytes.extend(pixel))?;
        drawn.over_budget.is_none().then_some(bytes)
    }
}
