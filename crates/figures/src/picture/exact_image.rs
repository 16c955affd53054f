//! The exact image of a figure: rays in `f64` find what each place of a pixel shows.
//!
//! A pixel has 8 × 8 places. At each of them, a ray meets all faces there. They're blended from front to back, each in
//! the light at that very point, with rays to the lights for shadows. The mean of the places is the pixel, of
//! premultiplied sRGB, as the program averages. Nothing is rounded before.
//!
//! *Textbook*: 64 rays for each pixel. *Here*: one, if the pixel shows one face and one texel. A pixel through which no
//! edge of any face goes is covered whole by each of its faces. Their planes are affine in the inverse depth, so a face
//! that is nearest in all four corners is nearest everywhere between them.

use std::array::from_fn;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::{DMat3, DVec3};

use crate::appearance::{DepthFormat, Filter, Level, Rgba, Samples, Shading, Visibility, Wrap};
use crate::camera::{Camera, ImageSize, Projection};
use crate::drawing::{Base, Drawing};
use crate::geometry::try_unit;
use crate::limits::{MAX_RAY_TRIANGLES, MAX_STEPPED_PIXELS};
use crate::picture::Pixels;
use crate::picture::shadow_truth::{by_rows, center};
use crate::picture::tiles::{Nearest, Tiles};
use crate::pipeline::reflection::{AMBIENT, DIFFUSE, SHININESS, SPECULAR};
use crate::pipeline::shadow_rays::Solids;
use crate::progress::{Activity, Progress};
use crate::raster::Rasterizer;
use crate::scene::{Light, LightKind, Object, ObjectPaint, Pictured, Scene};
use crate::views::{self, Palette, PixelRect, Request, TimedPipeline};

/// Places along one side of a pixel.
const SIDE: u32 = 8;
/// Places of a pixel.
pub const SAMPLES: u32 = SIDE * SIDE;
/// Points along one side of a place at which a texture is read, at most. Beyond that, its levels of detail are read.
const FINEST: u32 = 4;
/// Edges count for the pixels that they come this near to, in pixels. More than the rounding of their ends.
const NEAR_EDGE: f64 = 1e-6;

/// The reason why there is no exact image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoExactImage {
    /// Too many pixels.
    Pixels,
    /// Too many triangles, or too many large ones.
    Triangles,
    /// There isn't enough memory.
    Memory,
    /// It was cancelled.
    Cancelled,
}

/// The exact image of a figure.
#[derive(Clone, Debug)]
pub struct ExactImage {
    /// The picture, opaque.
    pub pixels: Pixels,
    /// Rays from the eye and to the lights.
    pub rays: u64,
    /// For each object of the scene: true if its texture is smaller than its texels' size at any place that's visible.
    pub minified: Vec<bool>,
}

/// A colour, premultiplied, 0 … 255.
type Color = [f64; 4];

/// Draws the exact image of a request for the image. Lines, marks and letters are drawn by the program, hidden by its
/// best depth buffer: those of the request would be wrong as its faces are, if they're painted in order.
///
/// # Errors
/// [`NoExactImage`] says why there is none.
pub async fn exact_image(request: &Request, progress: &Progress) -> Result<ExactImage, NoExactImage> {
    let size = request.size;
    if u64::from(size.width) * u64::from(size.height) > MAX_STEPPED_PIXELS {
        return Err(NoExactImage::Pixels);
    }
    let frame = request.image_frame();
    let rays = Rays::new(request, frame)?;
    progress.begin(Activity::Measuring, frame.height as usize);
    let image = ImageSize { width: frame.width, height: frame.height };
    let faces = by_rows(image, progress, |pixel, at| rays.pixel(pixel, rays.edges.get(at).copied().unwrap_or(true)));
    let faces = faces.await.ok_or(NoExactImage::Cancelled)?;
    let best = request.clone().with_shot(|shot| {
        let style = &mut shot.look.style;
        (style.visibility, style.depth_format) = (Visibility::DepthBuffer, DepthFormat::Float);
        style.antialias = Samples::Sixteen;
    });
    let drawing = views::frame(&best, None, &mut TimedPipeline::default()).drawing;
    let over = Overlay::of(drawing).ok_or(NoExactImage::Memory)?;
    let palette = Palette::of(request.shot.look.style.theme);
    let PixelRect { x, y, width, height } = frame;
    let mut bytes = Vec::with_capacity(4 * (size.width * size.height) as usize);
    for (j, i) in (0..size.height).flat_map(|j| (0..size.width).map(move |i: u32| (j, i))) {
        let inside = i.checked_sub(x).zip(j.checked_sub(y)).filter(|&(i, j)| i < width && j < height);
        let ground = inside.map_or(palette.surround, |_| palette.paper);
        let face = inside.and_then(|(i, j)| faces.get((j * width + i) as usize)).copied();
        let color = face.unwrap_or_else(|| premultiplied(ground));
        bytes.extend(over.over(color, (j * size.width + i) as usize));
    }
    let pixels = Pixels::opaque([size.width, size.height], bytes).ok_or(NoExactImage::Memory)?;
    let minified = rays.bodies_of_scene(&request.scene);
    Ok(ExactImage { pixels, rays: rays.count.into_inner(), minified })
}

/// Lines, marks and letters of a drawing, without its faces.
struct Overlay {
    /// Their colours on black.
    on_black: Pixels,
    /// The same in white: how much they cover.
    cover: Pixels,
}

impl Overlay {
    /// Paints a drawing with black faces on black. Faces still hide lines, but have no colour of their own.
    fn of(mut drawing: Drawing) -> Option<Self> {
        let black = |color: &mut Rgba| (color.r, color.g, color.b) = (0, 0, 0);
        let white = |color: &mut Rgba| (color.r, color.g, color.b) = (255, 255, 255);
        black(&mut drawing.background);
        for surface in &mut drawing.surfaces {
            let mut base = surface.base.clone();
            match &mut base {
                Base::Solid(color) => black(color),
                Base::Faces(colors) | Base::Vertices(colors) => colors.iter_mut().for_each(black),
                Base::Texture { tint, tints, .. } => tints.iter_mut().chain([tint]).for_each(black),
            }
            surface.repaint(base);
        }
        let mut rasterizer = Rasterizer::default();
        let on_black = rasterizer.paint(&drawing)?.into();
        drawing.strokes.iter_mut().for_each(|stroke| white(&mut stroke.style.color));
        drawing.areas.iter_mut().for_each(|area| white(&mut area.fill));
        drawing.marks.iter_mut().flat_map(|mark| [&mut mark.color, &mut mark.outline]).for_each(white);
        drawing.labels.iter_mut().flat_map(|label| [&mut label.color, &mut label.halo]).for_each(white);
        Some(Self { on_black, cover: rasterizer.paint(&drawing)?.into() })
    }

    /// The bytes of a pixel whose faces have a colour.
    fn over(&self, face: Color, pixel: usize) -> [u8; 4] {
        let byte = |of: &Pixels, k: usize| f64::from(of.rgba().get(4 * pixel + k).copied().unwrap_or(0));
        let [r, g, b] = from_fn(|k| {
            let mixed = byte(&self.on_black, k) + face[k] * (1.0 - byte(&self.cover, k) / 255.0);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 … 255")]
            let rounded = mixed.round().clamp(0.0, 255.0) as u8;
            rounded
        });
        [r, g, b, 255]
    }
}

/// An object with faces.
struct Body<'a> {
    object: &'a Object,
    /// Its place in the scene.
    place: usize,
    /// The number of its first triangle, among all and, if it's opaque, among those that cast shadows.
    first: usize,
    first_solid: Option<usize>,
    /// Takes normals to view space, and keeps them outside. They have any length.
    normals: DMat3,
    mirrored: bool,
    /// Lit on the side that is seen.
    both_sides: bool,
    /// Its texture is minified at a place that was seen. 0 or 1.
    minified: AtomicU64,
}

/// The scene, for rays from the eye.
struct Rays<'a> {
    camera: &'a Camera,
    shading: Shading,
    ground: Color,
    tiles: Tiles<'a>,
    bodies: Vec<Body<'a>>,
    /// The lights, and each one's vector in view space.
    lights: Vec<(Light, DVec3)>,
    /// For the rays to lights that cast shadows.
    solids: Option<Solids>,
    /// The pixels through which an edge goes, row by row.
    edges: Vec<bool>,
    count: AtomicU64,
}

impl<'a> Rays<'a> {
    fn new(request: &'a Request, frame: PixelRect) -> Result<Self, NoExactImage> {
        let (scene, camera): (&Scene, _) = (&request.scene, &request.camera);
        let style = &request.shot.look.style;
        let is_drawn =
            |object: &&Object| style.shading != Shading::Wireframe && object.faces && !object.mesh.triangles.is_empty();
        let objects = || scene.objects.iter().filter(is_drawn);
        let count = |objects: &mut dyn Iterator<Item = &Object>| objects.map(|o| o.mesh.triangles.len()).sum::<usize>();
        if count(&mut objects()) > MAX_RAY_TRIANGLES || Solids::count(scene) > MAX_RAY_TRIANGLES {
            return Err(NoExactImage::Triangles);
        }
        let image = ImageSize { width: frame.width, height: frame.height };
        let tiles = Tiles::new(objects(), camera, image).ok_or(NoExactImage::Triangles)?;
        let basis = camera.basis();
        let to_view = DMat3::from_cols(basis.u, basis.v, basis.n).transpose();
        let (mut first, mut first_solid) = (0, 0);
        let all = scene.objects.iter().enumerate().filter(|(_, object)| is_drawn(object));
        let bodies = all.map(|(place, object)| {
            let linear = to_view * DMat3::from_mat4(object.world_from_object);
            let mirrored = linear.determinant() < 0.0;
            let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
            let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
            let in_view = |p: &DVec3| camera.view_point(object.world_from_object.transform_point3(*p));
            let is_cut_open = object.mesh.positions.iter().any(|p| -in_view(p).z < camera.near());
            let is_solid = !object.paint.is_translucent();
            let body = Body {
                object,
                place,
                first,
                first_solid: is_solid.then_some(first_solid),
                normals: if mirrored { cofactors * -1.0 } else { cofactors },
                mirrored,
                both_sides: object.shows_both_sides(is_cut_open),
                minified: AtomicU64::new(0),
            };
            first += object.mesh.triangles.len();
            first_solid += if is_solid { object.mesh.triangles.len() } else { 0 };
            body
        });
        let bodies: Vec<Body> = bodies.collect();
        let in_view = |light: &Light| match light.kind {
            LightKind::Directional => Some((*light, try_unit(to_view * -try_unit(light.vector)?)?)),
            LightKind::Point => Some((*light, camera.view_point(light.vector))),
        };
        let lights: Vec<_> = scene.lights.iter().filter_map(in_view).collect();
        let casts = lights.iter().any(|(light, _)| light.shadows.cast);
        let mut rays = Self {
            camera,
            shading: style.shading,
            ground: premultiplied(Palette::of(style.theme).paper),
            tiles,
            bodies,
            lights,
            solids: casts.then(|| Solids::of(scene)),
            edges: vec![false; image.width as usize * image.height as usize],
            count: AtomicU64::new(0),
        };
        for triangle in 0..first {
            rays.mark_edges(triangle, image);
        }
        Ok(rays)
    }

    /// Marks the pixels through which the edges of a triangle go, also those at the front and the back plane.
    fn mark_edges(&mut self, triangle: usize, image: ImageSize) {
        let Some(corners) = self.tiles.corners(triangle) else { return };
        let (near, far) = (self.camera.near(), self.camera.far());
        let inside = cut(cut(corners.to_vec(), |p| -p.z - near), |p| far + p.z);
        let places: Vec<[f64; 2]> = inside.iter().map(|&p| self.tiles.place(p)).collect();
        let [width, height] = [image.width, image.height].map(f64::from);
        for (k, &p) in places.iter().enumerate() {
            let q = places[(k + 1) % places.len()];
            let [top, bottom] = if p[1] <= q[1] { [p, q] } else { [q, p] };
            let at = |y: f64| {
                let part = (y - top[1]) / (bottom[1] - top[1]);
                if part.is_finite() { top[0] + part.clamp(0.0, 1.0) * (bottom[0] - top[0]) } else { top[0] }
            };
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a pixel of the image")]
            let whole = |v: f64, most: f64| v.floor().clamp(0.0, most - 1.0) as usize;
            let [first, last] = [top[1] - NEAR_EDGE, bottom[1] + NEAR_EDGE];
            if !(last >= 0.0 && first < height) {
                continue;
            }
            let level = bottom[1] - top[1] < NEAR_EDGE;
            for row in whole(first, height)..=whole(last, height) {
                let ends = if level { [top[0], bottom[0]] } else { [at(row as f64), at(row as f64 + 1.0)] };
                let [left, right] = [ends[0].min(ends[1]) - NEAR_EDGE, ends[0].max(ends[1]) + NEAR_EDGE];
                if right >= 0.0 && left < width {
                    let start = row * image.width as usize;
                    self.edges[start + whole(left, width)..=start + whole(right, width)].fill(true);
                }
            }
        }
    }

    /// The mean colour of the faces in a pixel, on the ground of the image.
    fn pixel(&self, pixel: [u32; 2], has_edge: bool) -> Color {
        let middle = pixel.map(center);
        let hits = self.hits(middle);
        if !has_edge && self.is_even(pixel, &hits) {
            return self.color(middle, &hits);
        }
        let part = |k: u32| (f64::from(k) + 0.5) / f64::from(SIDE);
        let place = |k: u32| [f64::from(pixel[0]) + part(k % SIDE), f64::from(pixel[1]) + part(k / SIDE)];
        let colors = (0..SAMPLES).map(place).map(|place| self.color(place, &self.hits(place)));
        colors.fold([0.0; 4], |sum, color| from_fn(|k| sum[k] + color[k])).map(|sum| sum / f64::from(SAMPLES))
    }

    /// The texels of a face at a place: their mean, which is that of their light as in levels of detail, if a pixel is
    /// larger than a texel, else their colour as the figure's own filter has it.
    ///
    /// The place is small, but many texels may lie under it. Then it's read at several points, and if those aren't
    /// enough either, at the level of detail whose texels are as large as their distance.
    fn texels(&self, body: &Body, pictured: &Pictured, hit: &Nearest, [x, y]: [f64; 2]) -> Option<Color> {
        let indices = body.object.mesh.triangles.get(hit.triangle - body.first)?.map(|i| i as usize);
        let corners = self.tiles.corners(hit.triangle)?;
        let uv = indices.map(|i| pictured.uv.get(i).map_or([0.0; 2], |uv| uv.map(f64::from)));
        let at = |place: [f64; 2]| -> [f64; 2] {
            let shares = shares(corners, self.tiles.on_plane(corners, place));
            from_fn(|k| (0..3).map(|corner| shares[corner] * uv[corner][k]).sum())
        };
        let side = 1.0 / f64::from(SIDE);
        let texels = texels_between(pictured, at([x, y]), [at([x + side, y]), at([x, y + side])]);
        if texels <= side {
            return Some(textured(pictured, at([x, y]), 0.0, false));
        }
        body.minified.store(1, Ordering::Relaxed);
        let fine = texels.ceil().clamp(1.0, f64::from(FINEST));
        let level = (texels / fine).log2().ceil().max(0.0);
        let part = |k: f64| ((k + 0.5) / fine - 0.5) * side;
        let points = (0..FINEST * FINEST).map(|k| [f64::from(k % FINEST), f64::from(k / FINEST)]);
        let points = points.filter(|[i, j]| *i < fine && *j < fine);
        let colors = points.map(|[i, j]| light(textured(pictured, at([x + part(i), y + part(j)]), level, true)));
        let sum = colors.fold([0.0; 4], |sum, color| from_fn(|k| sum[k] + color[k]));
        Some(encoded(sum.map(|sum| sum / (fine * fine))))
    }

    /// True if a pixel without an edge shows one colour, but for light that changes smoothly: the same faces in the
    /// same order at its corners, none with a texture, and each corner in the light of the same lights.
    fn is_even(&self, [i, j]: [u32; 2], hits: &[Nearest]) -> bool {
        if hits
            .iter()
            .any(|hit| matches!(self.body(hit.triangle).map(|b| &b.object.paint), Some(ObjectPaint::Texture(_))))
        {
            return false;
        }
        let lit = |place: [f64; 2], hit: &Nearest| -> u32 {
            let Some(body) = self.body(hit.triangle).filter(|body| body.object.lit) else { return 0 };
            let Some((_, p)) = self.point(hit.triangle, place) else { return 0 };
            let bits = (0..).zip(&self.lights).map(|(k, (light, _))| u32::from(self.arrives(body, hit, p, light)) << k);
            bits.sum()
        };
        let at = |place: [f64; 2], hits: &[Nearest]| -> Vec<(usize, u32)> {
            hits.iter().map(|hit| (hit.triangle, lit(place, hit))).collect()
        };
        let seen = at([i, j].map(center), hits);
        [[0, 0], [1, 0], [0, 1], [1, 1]].into_iter().all(|[dx, dy]| {
            let corner = [f64::from(i + dx), f64::from(j + dy)];
            at(corner, &self.hits(corner)) == seen
        })
    }

    /// The faces at a place down to the first opaque one, the nearest first.
    fn hits(&self, place: [f64; 2]) -> Vec<Nearest> {
        self.count.fetch_add(1, Ordering::Relaxed);
        let mut hits = self.tiles.all(place);
        let opaque = |hit: &Nearest| self.body(hit.triangle).is_some_and(|body| body.first_solid.is_some());
        if let Some(last) = hits.iter().position(opaque) {
            hits.truncate(last + 1);
        }
        hits
    }

    fn body(&self, triangle: usize) -> Option<&Body<'a>> {
        let after = self.bodies.partition_point(|body| body.first <= triangle);
        self.bodies.get(after.checked_sub(1)?)
    }

    /// The point of a triangle at a place, as the shares of its corners, and in view space.
    fn point(&self, triangle: usize, place: [f64; 2]) -> Option<([f64; 3], DVec3)> {
        let corners = self.tiles.corners(triangle)?;
        let p = self.tiles.on_plane(corners, place);
        Some((shares(corners, p), p))
    }

    /// The colours of faces, nearest first, over the ground.
    fn color(&self, place: [f64; 2], hits: &[Nearest]) -> Color {
        let mut sum = [0.0; 4];
        let over = |sum: &mut Color, below: Color| *sum = from_fn(|k| sum[k] + (1.0 - sum[3] / 255.0) * below[k]);
        for hit in hits {
            over(&mut sum, self.color_of(hit, place).unwrap_or_default());
        }
        over(&mut sum, self.ground);
        sum
    }

    /// The colour of a face at a place, in its light.
    fn color_of(&self, hit: &Nearest, place: [f64; 2]) -> Option<Color> {
        let body = self.body(hit.triangle)?;
        let Object { mesh, paint, lit, .. } = body.object;
        let number = hit.triangle - body.first;
        let indices = mesh.triangles.get(number)?.map(|i| i as usize);
        let corners = self.tiles.corners(hit.triangle)?;
        let (shares, p) = self.point(hit.triangle, place)?;
        let is_lit = *lit && !self.lights.is_empty();
        let mixed = |colors: &[Rgba], shares: [f64; 3]| -> Color {
            let colors = indices.map(|i| colors.get(i).copied().map_or([0.0; 4], premultiplied));
            from_fn(|k| (0..3).map(|corner| shares[corner] * colors[corner][k]).sum())
        };
        let base = match paint {
            ObjectPaint::Solid(color) => premultiplied(*color),
            ObjectPaint::Faces(colors) => premultiplied(*colors.get(number)?),
            // Flat shading gives a face one colour.
            ObjectPaint::Vertices(colors) if is_lit && self.shading == Shading::Flat => mixed(colors, [1.0 / 3.0; 3]),
            ObjectPaint::Vertices(colors) => mixed(colors, shares),
            ObjectPaint::Texture(pictured) => {
                let texels = self.texels(body, pictured, hit, place)?;
                let tint = if pictured.tints.is_empty() {
                    premultiplied(pictured.tint)
                } else {
                    mixed(&pictured.tints, shares)
                };
                from_fn(|k| texels[k] * (tint[k] / 255.0))
            }
        };
        if !is_lit {
            return Some(base);
        }
        let (normal, at) = if self.shading == Shading::Flat {
            let [a, b, c] = corners;
            let outward = if body.mirrored { -1.0 } else { 1.0 };
            ((b - a).cross(c - a) * outward, (a + b + c) / 3.0)
        } else {
            let normals =
                indices.map(|i| (body.normals * mesh.normals.get(i).copied().unwrap_or_default()).normalize_or_zero());
            ((0..3).map(|corner| normals[corner] * shares[corner]).sum(), p)
        };
        let (mut diffuse, mut white) = (0.0, 0.0);
        let to_viewer =
            if self.camera.projection() == Projection::Parallel { DVec3::Z } else { (-at).normalize_or_zero() };
        let normal: DVec3 = normal.normalize_or_zero();
        let normal = if body.both_sides && normal.dot(to_viewer) < 0.0 { -normal } else { normal };
        for (light, vector) in &self.lights {
            let to_light = match light.kind {
                LightKind::Directional => *vector,
                LightKind::Point => (*vector - at).normalize_or_zero(),
            };
            let cosine = normal.dot(to_light);
            if cosine > 0.0 && self.arrives(body, hit, p, light) {
                diffuse += cosine;
                let half = (to_light + to_viewer).normalize_or_zero();
                white += normal.dot(half).max(0.0).powf(f64::from(SHININESS));
            }
        }
        let share = f64::from(AMBIENT) + f64::from(DIFFUSE) * diffuse;
        let white = if self.shading == Shading::Flat { 0.0 } else { f64::from(SPECULAR) * white };
        let [.., alpha] = base;
        Some(from_fn(|k| if k < 3 { (base[k] * share + white * alpha).min(alpha) } else { alpha }))
    }

    /// True if no face hides a light from a point of a face. The point is in view space.
    fn arrives(&self, body: &Body, hit: &Nearest, p: DVec3, light: &Light) -> bool {
        let Some(solids) = self.solids.as_ref().filter(|_| light.shadows.cast) else { return true };
        self.count.fetch_add(1, Ordering::Relaxed);
        let basis = self.camera.basis();
        let p_world = self.camera.position() + basis.u * p.x + basis.v * p.y + basis.n * p.z;
        let triangle = body.first_solid.map_or(usize::MAX, |first| first + hit.triangle - body.first);
        solids.is_lit(p_world, triangle, light)
    }

    /// For each object of the scene: true if its texture was minified.
    fn bodies_of_scene(&self, scene: &Scene) -> Vec<bool> {
        let mut minified = vec![false; scene.objects.len()];
        for body in &self.bodies {
            if let Some(minified) = minified.get_mut(body.place) {
                *minified = body.minified.load(Ordering::Relaxed) > 0;
            }
        }
        minified
    }
}

/// The part of a polygon where a distance isn't negative (Sutherland and Hodgman).
fn cut(polygon: Vec<DVec3>, distance: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut inside = Vec::with_capacity(polygon.len() + 1);
    for (k, &p) in polygon.iter().enumerate() {
        let q = polygon[(k + 1) % polygon.len()];
        let [a, b] = [p, q].map(&distance);
        if a >= 0.0 {
            inside.push(p);
        }
        if (a >= 0.0) != (b >= 0.0) {
            inside.push(p + (q - p) * (a / (a - b)));
        }
    }
    inside
}

/// The shares of the corners of a triangle at a point of its plane: barycentric coordinates, as ratios of areas.
fn shares([a, b, c]: [DVec3; 3], p: DVec3) -> [f64; 3] {
    let normal = (b - a).cross(c - a);
    let area = |q: DVec3, r: DVec3| (q - p).cross(r - p).dot(normal) / normal.length_squared();
    [area(b, c), area(c, a), area(a, b)]
}

fn premultiplied(color: Rgba) -> Color {
    let alpha = f64::from(color.a) / 255.0;
    [f64::from(color.r) * alpha, f64::from(color.g) * alpha, f64::from(color.b) * alpha, f64::from(color.a)]
}

/// The longer of the two changes of (u, v) to the places beside, in texels.
fn texels_between(pictured: &Pictured, at: [f64; 2], beside: [[f64; 2]; 2]) -> f64 {
    let sides = [pictured.image.width(), pictured.image.height()].map(f64::from);
    let change = |to: [f64; 2]| ((to[0] - at[0]) * sides[0]).hypot((to[1] - at[1]) * sides[1]);
    beside.into_iter().map(change).fold(0.0, f64::max)
}

/// The colour of a picture at a point: the texel under it if the picture is minified, else as its own filter has it.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, and few levels exist")]
fn textured(pictured: &Pictured, at: [f64; 2], level: f64, is_minified: bool) -> Color {
    let levels = pictured.image.levels();
    let Some(level) = levels.get((level as usize).min(levels.len().saturating_sub(1))) else { return [0.0; 4] };
    let smooth = !is_minified && pictured.sampler.filter != Filter::Nearest;
    let around = |k: usize, size: u32, wrap: Wrap| around(at[k], f64::from(size), wrap, smooth);
    let [x, y] = [around(0, level.width, pictured.sampler.wrap_u), around(1, level.height, pictured.sampler.wrap_v)];
    let texel = |level: &Level, i: usize, j: usize| level.texel(x.0[i], y.0[j]).map(f64::from);
    let mut color = [0.0; 4];
    for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let weight = [1.0 - x.1, x.1][i] * [1.0 - y.1, y.1][j];
        let texel = texel(level, i, j);
        color = from_fn(|k| color[k] + weight * texel[k]);
    }
    color
}

/// A premultiplied colour as light, still premultiplied, 0 … 1.
fn light([r, g, b, a]: Color) -> Color {
    let light = |v: f64| if v <= 0.040_45 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
    let channel = |v: f64| if a > 0.0 { a / 255.0 * light(v / a) } else { 0.0 };
    [channel(r), channel(g), channel(b), a / 255.0]
}

/// The way back from [`light`].
fn encoded([r, g, b, a]: Color) -> Color {
    let srgb = |v: f64| if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
    let channel = |v: f64| if a > 0.0 { 255.0 * a * srgb(v / a) } else { 0.0 };
    [channel(r), channel(g), channel(b), 255.0 * a]
}

/// The two texels beside a coordinate along one axis, and the share of the second. The nearest one alone if it isn't
/// `smooth`.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place among the texels")]
fn around(t: f64, size: f64, wrap: Wrap, smooth: bool) -> ([u32; 2], f64) {
    let whole = |texel: f64| {
        let texel = texel.floor();
        let folded = match wrap {
            Wrap::Clamp => texel,
            Wrap::Repeat => texel.rem_euclid(size),
            Wrap::Mirror => {
                let twice = texel.rem_euclid(2.0 * size);
                if twice < size { twice } else { 2.0 * size - 1.0 - twice }
            }
        };
        folded.clamp(0.0, size - 1.0) as u32
    };
    let at = t * size;
    if !smooth {
        return ([whole(at); 2], 0.0);
    }
    let before = (at - 0.5).floor();
    ([whole(before), whole(before + 1.0)], at - 0.5 - before)
}

#[cfg(test)]
mod tests;
