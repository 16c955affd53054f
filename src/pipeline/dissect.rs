//! The scene taken apart at the planes of the view volume, where it stands: what clipping keeps, what it takes away, and the
//! vertices that it makes.
//!
//! Pictures draw without this; it is for who wants to see what clipping does. The cuts are those of `clip`: an edge is cut
//! where the distances of its ends from the plane, linear in homogeneous coordinates, add up to 0.

use std::collections::HashSet;
use std::sync::Arc;

use glam::DVec3;

use super::bounds::Bounds;
use super::clip::{NOT_A_NUMBER, PLANES, PlaneSet, distances, outcode};
use super::cull::{Place, place};
use super::shade::{color_at, mean_of_colors, mean_of_uv};
use super::transform::{ClipPoint, Projector, ViewFromObject};
use crate::appearance::LineStyle;
use crate::camera::{Camera, Projection};
use crate::geometry::try_unit;
use crate::scene::{Line, Mesh, Object, ObjectPaint, Scene};

/// The bits of an outcode, `true` where a point is outside: left, right, bottom, top, near, far. `None` for a point with a
/// coordinate that is no number.
#[must_use]
pub fn outcode_of(camera: &Camera, p_world: DVec3) -> Option<[bool; 6]> {
    let projector = Projector::new(camera);
    let code = outcode(&projector, projector.clip(projector.view(p_world)));
    (code != NOT_A_NUMBER).then(|| std::array::from_fn(|i| code >> i & 1 == 1))
}

/// The six homogeneous distances of a point, positive inside: w + x, w − x, w + y, w − y, w + z, w − z `[2]`.
///
/// *Guarantees*: each has the sign that the outcode goes by, also where `z_clip` would round it away.
#[must_use]
pub fn homogeneous_distances(camera: &Camera, p_world: DVec3) -> [f64; 6] {
    let projector = Projector::new(camera);
    let [left, right, bottom, top, near, far] = distances(&projector, projector.clip(projector.view(p_world)));
    let (f, b) = (camera.near(), camera.far());
    // w + z = 2 B (d − F)/(B − F), w − z = 2 F (B − d)/(B − F); in parallel projection without B and F.
    let [at_near, at_far] = match camera.projection() {
        Projection::Perspective => [b, f],
        Projection::Parallel => [1.0, 1.0],
    };
    [left, right, bottom, top, 2.0 * at_near * (near / (b - f)), 2.0 * at_far * (far / (b - f))]
}

/// A scene in two parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dissection {
    /// What lies in the volume. An object that was cut is open, so both sides of its faces show.
    pub inside: Scene,
    /// What lies outside, without the lights.
    pub outside: Scene,
    /// The vertices that clipping makes, in the world, each once.
    pub cuts: Vec<DVec3>,
    /// The sides that it gives to faces, in the planes.
    pub sides: Vec<[DVec3; 2]>,
}

/// Takes `scene` apart at the planes of the volume of `camera`. With `edges_only` the new vertices are those of edges, else
/// those of triangles where an object has faces.
#[must_use]
pub fn dissect(scene: &Scene, camera: &Camera, edges_only: bool) -> Dissection {
    let mut knife = Knife { projector: Projector::new(camera), parts: Dissection::default(), known: HashSet::new() };
    knife.parts.inside.lights.clone_from(&scene.lights);
    for object in &scene.objects {
        knife.object(object, edges_only);
    }
    for line in &scene.lines {
        knife.line(line);
    }
    let inside = |p| outcode_of(camera, p).is_some_and(|code| !code.contains(&true));
    let Dissection { inside: kept, outside: cut, .. } = &mut knife.parts;
    (kept.marks, cut.marks) = scene.marks.iter().cloned().partition(|mark| inside(mark.position));
    (kept.texts, cut.texts) = scene.texts.iter().cloned().partition(|text| inside(text.position));
    knife.parts
}

/// Near and far first, as in `clip`.
const ORDER: [usize; PLANES] = [4, 5, 0, 1, 2, 3];

/// A corner of a piece of a triangle: what it is made of, and where it lies relative to the planes.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Corner {
    weights: [f64; 3],
    distances: [f64; PLANES],
    /// The corner of the triangle that it is; `None` for a new one.
    own: Option<usize>,
}

impl Corner {
    fn between(inside: &Self, outside: &Self, plane: usize) -> Self {
        let (d1, d2) = (inside.distances[plane], -outside.distances[plane]);
        let (w1, w2) = (d2 / (d1 + d2), d1 / (d1 + d2));
        let mut distances: [f64; PLANES] =
            std::array::from_fn(|i| w1 * inside.distances[i] + w2 * outside.distances[i]);
        distances[plane] = 0.0;
        let weights = std::array::from_fn(|i| w1 * inside.weights[i] + w2 * outside.weights[i]);
        Self { weights, distances, own: None }
    }
}

/// The two parts of a convex polygon (or, with two corners, of a segment) on the sides of a plane.
fn split(polygon: &[Corner], plane: usize) -> [Vec<Corner>; 2] {
    let least = polygon.len().min(3);
    let (mut inside, mut outside) = (Vec::new(), Vec::new());
    let sides = if polygon.len() == 2 { 1 } else { polygon.len() };
    for (i, current) in polygon.iter().enumerate() {
        let d1 = current.distances[plane];
        if d1 >= 0.0 {
            inside.push(*current);
        }
        if d1 <= 0.0 {
            outside.push(*current);
        }
        if i >= sides {
            break;
        }
        let following = &polygon[(i + 1) % polygon.len()];
        let d2 = following.distances[plane];
        if d1 * d2 < 0.0 {
            let cut = if d1 > 0.0 {
                Corner::between(current, following, plane)
            } else {
                Corner::between(following, current, plane)
            };
            inside.push(cut);
            outside.push(cut);
        }
    }
    // What lies in the plane is inside.
    let any_outside = outside.iter().any(|corner| corner.distances[plane] < 0.0);
    if inside.len() < least {
        inside.clear();
    }
    if outside.len() < least || !any_outside {
        outside.clear();
    }
    [inside, outside]
}

/// The piece inside all planes, and those outside one of them.
fn pieces(polygon: Vec<Corner>) -> (Vec<Corner>, Vec<Vec<Corner>>) {
    let (mut rest, mut outside) = (polygon, Vec::new());
    for plane in ORDER {
        if rest.iter().any(|corner| corner.distances[plane] < 0.0) {
            let [kept, cut] = split(&rest, plane);
            rest = kept;
            outside.extend(Some(cut).filter(|cut| !cut.is_empty()));
        }
    }
    (rest, outside)
}

struct Knife {
    projector: Projector,
    parts: Dissection,
    /// The new vertices that have been noted, rounded.
    known: HashSet<[i64; 3]>,
}

impl Knife {
    fn object(&mut self, object: &Object, edges_only: bool) {
        let view_from_object = self.projector.view_from_object(object.world_from_object);
        match Bounds::of(&object.mesh).map(|bounds| place(&self.projector, &view_from_object, &bounds)) {
            None | Some(Place::Empty | Place::Crosses(0)) => self.parts.inside.objects.push(object.clone()),
            Some(Place::Outside(_)) => self.parts.outside.objects.push(object.clone()),
            Some(Place::Crosses(_)) => self.crossing(object, &view_from_object, edges_only),
        }
    }

    fn crossing(&mut self, object: &Object, view_from_object: &ViewFromObject, edges_only: bool) {
        let mesh = &object.mesh;
        let clip: Vec<ClipPoint> =
            mesh.positions.iter().map(|&p| self.projector.clip(view_from_object.point(p))).collect();
        let codes: Vec<PlaneSet> = clip.iter().map(|&p| outcode(&self.projector, p)).collect();
        let corner = |i: u32, own: usize| {
            let weights = std::array::from_fn(|k| f64::from(u8::from(k == own)));
            Corner { weights, distances: distances(&self.projector, clip[i as usize]), own: Some(own) }
        };
        let parted = |of: &[u32]| {
            let codes: Option<Vec<PlaneSet>> = of.iter().map(|&i| codes.get(i as usize).copied()).collect();
            let [all, any] = codes?.iter().fold([PlaneSet::MAX, 0], |[all, any], code| [all & code, any | code]);
            if any & NOT_A_NUMBER != 0 {
                return None;
            }
            let whole = of.iter().enumerate().map(|(own, &i)| corner(i, own)).collect();
            Some(match (all, any) {
                (_, 0) => (whole, Vec::new()),
                (0, _) => pieces(whole),
                _ => (Vec::new(), vec![whole]),
            })
        };
        let (mut inside, mut outside) = (Part::new(object), Part::new(object));
        let faces = object.faces && !edges_only;
        let mut made = Vec::new();
        for (source, triangle) in (0_u32..).zip(&mesh.triangles) {
            let Some((kept, cut)) = parted(&triangle[..]) else { continue };
            inside.polygon(*triangle, &kept, source);
            for piece in &cut {
                outside.polygon(*triangle, piece, source);
            }
            if faces && !cut.is_empty() && !kept.is_empty() {
                made.push((*triangle, kept));
            }
        }
        for &[a, b] in &mesh.edges {
            let Some((kept, cut)) = parted(&[a, b]) else { continue };
            inside.edge([a, b, b], &kept);
            for piece in &cut {
                outside.edge([a, b, b], piece);
            }
            if !faces && !cut.is_empty() && !kept.is_empty() {
                made.push(([a, b, b], kept));
            }
        }
        let place = |of: [u32; 3], corner: &Corner| {
            object.world_from_object.transform_point3(mean(of.map(|i| mesh.positions[i as usize]), corner.weights))
        };
        let made: Vec<Vec<(Corner, DVec3)>> =
            made.iter().map(|(of, corners)| corners.iter().map(|c| (*c, place(*of, c))).collect()).collect();
        for polygon in &made {
            self.note(polygon);
        }
        match outside.finish() {
            // The box crosses a plane, but nothing in it does.
            None => self.parts.inside.objects.push(object.clone()),
            Some(outside) => {
                self.parts.inside.objects.extend(inside.finish());
                self.parts.outside.objects.push(outside);
            }
        }
    }

    /// Notes what is new of a polygon that was cut.
    fn note(&mut self, polygon: &[(Corner, DVec3)]) {
        for (_, p) in polygon.iter().filter(|(corner, _)| corner.own.is_none()) {
            if self.is_new(*p) {
                self.parts.cuts.push(*p);
            }
        }
        let sides = if polygon.len() < 3 { 0 } else { polygon.len() };
        for (i, (a, p)) in polygon.iter().enumerate().take(sides) {
            let (b, q) = &polygon[(i + 1) % polygon.len()];
            if (0..PLANES).any(|plane| a.distances[plane] == 0.0 && b.distances[plane] == 0.0) {
                self.parts.sides.push([*p, *q]);
            }
        }
    }

    /// True for the first of points that are the same up to rounding: neighbours reckon them in another order.
    fn is_new(&mut self, p: DVec3) -> bool {
        const CELLS: f64 = 1e9;
        let size = p.abs().max_element().max(f64::MIN_POSITIVE).log2().ceil().exp2();
        #[expect(clippy::cast_possible_truncation, reason = "not above 10⁹")]
        let [x, y, z] = (p * (CELLS / size)).round().to_array().map(|c| c as i64);
        let near = || [-1, 0, 1].into_iter();
        let cells = near().flat_map(|i| near().flat_map(move |j| near().map(move |k| [x + i, y + j, z + k])));
        let new = !cells.into_iter().any(|cell| self.known.contains(&cell));
        self.known.insert([x, y, z]);
        new
    }

    fn line(&mut self, line: &Line) {
        let (mut inside, mut outside) = (Pieces::new(line), Pieces::new(line));
        for (i, ends) in line.points.windows(2).enumerate() {
            let clip = [ends[0], ends[1]].map(|p| self.projector.clip(self.projector.view(p)));
            if clip.iter().any(|p| outcode(&self.projector, *p) == NOT_A_NUMBER) {
                continue;
            }
            let corner = |k: usize| Corner {
                weights: [f64::from(u8::from(k == 0)), f64::from(u8::from(k == 1)), 0.0],
                distances: distances(&self.projector, clip[k]),
                own: Some(k),
            };
            let (kept, cut) = pieces(vec![corner(0), corner(1)]);
            let point = |c: &Corner| c.own.map_or_else(|| ends[0] * c.weights[0] + ends[1] * c.weights[1], |k| ends[k]);
            if !cut.is_empty() {
                self.note(&kept.iter().map(|c| (*c, point(c))).collect::<Vec<_>>());
            }
            let last = i + 2 == line.points.len();
            let add = |pieces: &mut Pieces, segment: &[Corner]| {
                if let [a, b] = segment {
                    pieces.add([point(a), point(b)], last && b.own == Some(1));
                }
            };
            add(&mut inside, &kept);
            cut.iter().for_each(|piece| add(&mut outside, piece));
        }
        self.parts.inside.lines.extend(inside.lines);
        self.parts.outside.lines.extend(outside.lines);
    }
}

fn mean(of: [DVec3; 3], weights: [f64; 3]) -> DVec3 {
    (0..3).fold(DVec3::ZERO, |sum, i| sum + of[i] * weights[i])
}

/// The polylines that are left of one.
struct Pieces {
    style: LineStyle,
    lines: Vec<Line>,
}

impl Pieces {
    fn new(line: &Line) -> Self {
        Self { style: line.style, lines: Vec::new() }
    }

    /// Adds a segment; `end`: it ends where the whole polyline does, and has its arrow head.
    fn add(&mut self, [a, b]: [DVec3; 2], end: bool) {
        match self.lines.last_mut().filter(|line| line.points.last() == Some(&a)) {
            Some(line) => line.points.push(b),
            None => self.lines.push(Line { points: vec![a, b], style: self.style }),
        }
        if let Some(line) = self.lines.last_mut() {
            line.style.arrow = end && self.style.arrow;
        }
    }
}

/// What is left of an object on one side.
struct Part<'a> {
    object: &'a Object,
    mesh: Mesh,
    /// The new index of each vertex of the mesh that is still used.
    index: Vec<Option<u32>>,
    /// What each new vertex is made of.
    origin: Vec<([u32; 3], [f64; 3])>,
    /// The old triangle of each new one.
    source: Vec<u32>,
}

impl<'a> Part<'a> {
    fn new(object: &'a Object) -> Self {
        let index = vec![None; object.mesh.positions.len()];
        Self { object, mesh: Mesh::default(), index, origin: Vec::new(), source: Vec::new() }
    }

    fn polygon(&mut self, of: [u32; 3], corners: &[Corner], source: u32) {
        let fan: Vec<u32> = corners.iter().map(|corner| self.vertex(of, corner)).collect();
        for k in 1..fan.len().saturating_sub(1) {
            self.mesh.triangles.push([fan[0], fan[k], fan[k + 1]]);
            self.source.push(source);
        }
    }

    fn edge(&mut self, of: [u32; 3], ends: &[Corner]) {
        if let [a, b] = ends {
            let ends = [self.vertex(of, a), self.vertex(of, b)];
            self.mesh.edges.push(ends);
        }
    }

    fn vertex(&mut self, of: [u32; 3], corner: &Corner) -> u32 {
        let own = corner.own.map(|k| of[k] as usize);
        if let Some(index) = own.and_then(|own| self.index[own]) {
            return index;
        }
        let index = u32::try_from(self.mesh.positions.len()).unwrap_or(u32::MAX);
        let old = &self.object.mesh;
        let normal = |i: u32| old.normals.get(i as usize).copied().unwrap_or_default();
        match own {
            Some(own) => {
                self.index[own] = Some(index);
                self.mesh.positions.push(old.positions[own]);
                self.mesh.normals.extend(old.normals.get(own));
            }
            None => {
                self.mesh.positions.push(mean(of.map(|i| old.positions[i as usize]), corner.weights));
                if !old.normals.is_empty() {
                    let normal = mean(of.map(normal), corner.weights);
                    self.mesh.normals.push(try_unit(normal).unwrap_or(DVec3::Y));
                }
            }
        }
        self.origin.push((of, corner.weights));
        index
    }

    fn finish(self) -> Option<Object> {
        let Self { object, mesh, origin, source, .. } = self;
        if mesh.triangles.is_empty() && mesh.edges.is_empty() {
            return None;
        }
        let paint = match &object.paint {
            ObjectPaint::Solid(color) => ObjectPaint::Solid(*color),
            ObjectPaint::Faces(colors) => {
                ObjectPaint::Faces(Arc::new(source.iter().map(|&face| color_at(colors, face)).collect()))
            }
            ObjectPaint::Vertices(colors) => {
                let color = |(of, weights): &([u32; 3], _)| mean_of_colors(of.map(|i| color_at(colors, i)), *weights);
                ObjectPaint::Vertices(Arc::new(origin.iter().map(color).collect()))
            }
            ObjectPaint::Texture { image, uv, opacity } => {
                let at = |i: u32| uv.get(i as usize).copied().unwrap_or_default();
                let uv = origin.iter().map(|(of, weights)| mean_of_uv(of.map(at), *weights)).collect();
                ObjectPaint::Texture { image: image.clone(), uv: Arc::new(uv), opacity: *opacity }
            }
        };
        // Open now, so that its inside shows.
        let two_sided = object.two_sided || object.mesh.closed;
        Some(Object { mesh: Arc::new(mesh), paint, two_sided, ..object.clone() })
    }
}
