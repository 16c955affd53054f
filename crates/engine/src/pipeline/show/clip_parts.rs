//! The scene in two parts, cut at the planes of the view volume in world space: the parts that clipping keeps and
//! removes, and the vertices that it makes.
//!
//! No picture needs this. It shows the effect of clipping. The corners and the cuts are those of `clip`.

use std::collections::HashSet;

use glam::DVec3;

use crate::appearance::LineStyle;
use crate::camera::{Camera, Ndc, Projection};
use crate::pipeline::mesh::bounds::Bounds;
use crate::pipeline::mesh::cut::cut;
use crate::pipeline::mesh::resample::Rebuilt;
use crate::pipeline::plan::Containment;
use crate::pipeline::space::projector::{Projector, ViewFromObject};
use crate::pipeline::space::{
    ClipPoint, NOT_A_NUMBER, ORDER, ObjectPoint, PLANES, PlaneSet, WorldPoint, distances, outcode,
};
use crate::pipeline::stage::clip::ClippedCorner;
use crate::pipeline::stage::cull_objects::containment;
use crate::pipeline::stage::vertex::{clip_from_view, clip_from_world, view_point};
use crate::scene::{Line, Object, Scene, SharedEdge};

/// The bits of an outcode, `true` if a point is outside: left, right, bottom, top, near, far. `None` for a point with a
/// coordinate that isn't a number.
pub fn outcode_of(camera: &Camera, p_world: DVec3) -> Option<[bool; 6]> {
    let projector = Projector::new(camera);
    let code = outcode(&projector, clip_from_world(&projector, WorldPoint(p_world)));
    (code != NOT_A_NUMBER).then(|| std::array::from_fn(|i| code >> i & 1 == 1))
}

/// The six homogeneous distances of a point, positive inside: of `[0]` w + x, w − x, w + y, w − y, w + z, w − z `[2]`;
/// in other conventions of NDC those from the planes left, right, bottom, top, near, far, such as z and w − z for near
/// and far.
///
/// *Guarantees*: each has the sign that the outcode goes by, even if `z_clip` would round it away. (Without a far
/// plane the last is positive.)
pub fn homogeneous_distances(camera: &Camera, p_world: DVec3, ndc: Ndc) -> [f64; 6] {
    let projector = Projector::new(camera);
    let [left, right, bottom, top, near, far] = distances(&projector, clip_from_world(&projector, WorldPoint(p_world)));
    let (f, b) = (camera.near(), camera.far());
    let [at_near, at_far] = ndc.depths();
    let range = (at_near - at_far).abs();
    // w + z = 2 B (d − F)/(B − F), w − z = 2 F (B − d)/(B − F); in parallel projection without B and F; half of it
    // if z_n is in 0 … 1.
    let [near, far] = match camera.projection() {
        Projection::Perspective if ndc.infinite => [near, f],
        Projection::Perspective => [b * (near / (b - f)), f * (far / (b - f))],
        Projection::Parallel => [near / (b - f), far / (b - f)],
    };
    [left, right, bottom, top, range * near, range * far]
}

/// A scene in two parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parts {
    /// The parts in the volume. A cut object is open, so both sides of its faces show.
    pub inside: Scene,
    /// The parts outside, without the lights.
    pub outside: Scene,
    /// The vertices that clipping makes, in the world, each once.
    pub cuts: Vec<DVec3>,
    /// The sides that clipping gives to faces, in the planes.
    pub sides: Vec<[DVec3; 2]>,
}

/// Cuts `scene` into two at the planes of the volume of `camera`. With `edges_only` the new vertices are those of
/// edges, else those of triangles if an object has faces.
pub fn clip_parts(scene: &Scene, camera: &Camera, edges_only: bool) -> Parts {
    let mut splitter = Splitter { projector: Projector::new(camera), parts: Parts::default(), known: HashSet::new() };
    splitter.parts.inside.lights.clone_from(&scene.lights);
    for object in &scene.objects {
        splitter.object(object, edges_only);
    }
    for line in &scene.lines {
        splitter.line(line);
    }
    let inside = |p| outcode_of(camera, p).is_some_and(|code| !code.contains(&true));
    let Parts { inside: kept, outside: cut, .. } = &mut splitter.parts;
    (kept.marks, cut.marks) = scene.marks.iter().cloned().partition(|mark| inside(mark.position));
    (kept.texts, cut.texts) = scene.texts.iter().cloned().partition(|text| inside(text.position));
    splitter.parts
}

/// The two parts of a convex polygon (or, with two corners, of a segment) on the sides of a plane.
fn split(polygon: &[ClippedCorner], plane: usize, projector: &Projector) -> [Vec<ClippedCorner>; 2] {
    let least = polygon.len().min(3);
    let (mut inside, mut outside) = (Vec::new(), Vec::new());
    let corner = |origin| ClippedCorner::of_part(polygon, origin, plane, projector);
    let distance = |i: usize| polygon[i].distances[plane];
    cut(polygon.len(), distance, |origin| inside.push(corner(origin)), |origin| outside.push(corner(origin)));
    // A face in the plane is inside.
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
fn pieces(projector: &Projector, points: &[ClipPoint]) -> (Vec<ClippedCorner>, Vec<Vec<ClippedCorner>>) {
    let (mut rest, mut outside) = (ClippedCorner::whole(projector, points).collect::<Vec<_>>(), Vec::new());
    for plane in ORDER {
        if rest.iter().any(|corner| corner.distances[plane] < 0.0) {
            let [kept, cut] = split(&rest, plane, projector);
            rest = kept;
            outside.extend(Some(cut).filter(|cut| !cut.is_empty()));
        }
    }
    (rest, outside)
}

struct Splitter {
    projector: Projector,
    parts: Parts,
    /// The new vertices recorded so far, rounded.
    known: HashSet<[i64; 3]>,
}

impl Splitter {
    fn object(&mut self, object: &Object, edges_only: bool) {
        let view_from_object = self.projector.view_from_object(object.world_from_object);
        match Bounds::of(&object.mesh)
            .map(|bounds| containment(&self.projector, &view_from_object, &bounds).containment)
        {
            None | Some(Containment::Empty | Containment::Crosses(0)) => self.parts.inside.objects.push(object.clone()),
            Some(Containment::Outside(_)) => self.parts.outside.objects.push(object.clone()),
            Some(Containment::Crosses(_)) => self.crossing(object, &view_from_object, edges_only),
        }
    }

    fn crossing(&mut self, object: &Object, view_from_object: &ViewFromObject, edges_only: bool) {
        let mesh = &object.mesh;
        let clip: Vec<ClipPoint> = mesh
            .positions
            .iter()
            .map(|&p| clip_from_view(&self.projector, view_point(view_from_object, ObjectPoint(p))))
            .collect();
        let codes: Vec<PlaneSet> = clip.iter().map(|&p| outcode(&self.projector, p)).collect();
        let parted = |of: &[u32]| {
            let codes: Option<Vec<PlaneSet>> = of.iter().map(|&i| codes.get(i as usize).copied()).collect();
            let [all, any] = codes?.iter().fold([PlaneSet::MAX, 0], |[all, any], code| [all & code, any | code]);
            if any & NOT_A_NUMBER != 0 {
                return None;
            }
            let points: Vec<ClipPoint> = of.iter().map(|&i| clip[i as usize]).collect();
            let whole = || ClippedCorner::whole(&self.projector, &points).collect();
            Some(match (all, any) {
                (_, 0) => (whole(), Vec::new()),
                (0, _) => pieces(&self.projector, &points),
                _ => (Vec::new(), vec![whole()]),
            })
        };
        let (mut inside, mut outside) = (Rebuilt::new(mesh), Rebuilt::new(mesh));
        let polygon = |part: &mut Rebuilt, of: [u32; 3], piece: &[ClippedCorner], source: u32| {
            let corners = vertices(part, object, of, piece);
            part.polygon(&corners, source);
        };
        // A segment has two corners, and so has a piece of it.
        let ends = |part: &mut Rebuilt, [a, b]: [u32; 2], piece: &[ClippedCorner]| {
            <[u32; 2]>::try_from(vertices(part, object, [a, b, b], piece)).ok()
        };
        let faces = object.faces && !edges_only;
        let mut made = Vec::new();
        for (source, triangle) in (0_u32..).zip(&mesh.triangles) {
            let Some((kept, cut)) = parted(&triangle[..]) else { continue };
            polygon(&mut inside, *triangle, &kept, source);
            cut.iter().for_each(|piece| polygon(&mut outside, *triangle, piece, source));
            if faces && !cut.is_empty() && !kept.is_empty() {
                made.push((*triangle, kept));
            }
        }
        for &[a, b] in &mesh.edges {
            let Some((kept, cut)) = parted(&[a, b]) else { continue };
            let of_inside = ends(&mut inside, [a, b], &kept);
            inside.edges.extend(of_inside);
            for piece in &cut {
                let of_outside = ends(&mut outside, [a, b], piece);
                outside.edges.extend(of_outside);
            }
            if !faces && !cut.is_empty() && !kept.is_empty() {
                made.push(([a, b, b], kept));
            }
        }
        for shared in &mesh.adjacency.edges {
            let Some((kept, cut)) = parted(&shared.ends) else { continue };
            let of_inside = ends(&mut inside, shared.ends, &kept);
            inside.shared.extend(of_inside.map(|ends| SharedEdge { ends, ..*shared }));
            for piece in &cut {
                let of_outside = ends(&mut outside, shared.ends, piece);
                outside.shared.extend(of_outside.map(|ends| SharedEdge { ends, ..*shared }));
            }
        }
        let place = |of: [u32; 3], corner: &ClippedCorner| {
            object.world_from_object.transform_point3(corner.origin(of).of(|i| mesh.positions[i as usize]))
        };
        let made: Vec<Vec<(ClippedCorner, DVec3)>> =
            made.iter().map(|(of, corners)| corners.iter().map(|c| (*c, place(*of, c))).collect()).collect();
        for polygon in &made {
            self.note(polygon);
        }
        match outside.into_object(object) {
            // The box crosses a plane, but nothing in it does.
            None => self.parts.inside.objects.push(object.clone()),
            Some(outside) => {
                self.parts.inside.objects.extend(inside.into_object(object));
                self.parts.outside.objects.push(outside);
            }
        }
    }

    /// Records the new vertices of a polygon that was cut.
    fn note(&mut self, polygon: &[(ClippedCorner, DVec3)]) {
        for (_, p) in polygon.iter().filter(|(corner, _)| corner.original().is_none()) {
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

    /// True for the first of points that are the same up to rounding, because faces of different objects may meet.
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
        let (mut inside, mut outside) = (Polylines::new(line), Polylines::new(line));
        for (i, ends) in line.points.windows(2).enumerate() {
            let clip = [ends[0], ends[1]].map(|p| clip_from_world(&self.projector, WorldPoint(p)));
            if clip.iter().any(|p| outcode(&self.projector, *p) == NOT_A_NUMBER) {
                continue;
            }
            let (kept, cut) = pieces(&self.projector, &clip);
            let point = |c: &ClippedCorner| c.origin([0, 1, 1]).of(|k| ends[k as usize]);
            if !cut.is_empty() {
                self.note(&kept.iter().map(|c| (*c, point(c))).collect::<Vec<_>>());
            }
            let last = i + 2 == line.points.len();
            let add = |polylines: &mut Polylines, segment: &[ClippedCorner]| {
                if let [a, b] = segment {
                    polylines.add([point(a), point(b)], last && b.original() == Some(1));
                }
            };
            add(&mut inside, &kept);
            cut.iter().for_each(|piece| add(&mut outside, piece));
        }
        self.parts.inside.lines.extend(inside.lines);
        self.parts.outside.lines.extend(outside.lines);
    }
}

/// The polylines that remain of one after the cuts.
struct Polylines {
    style: LineStyle,
    lines: Vec<Line>,
}

impl Polylines {
    fn new(line: &Line) -> Self {
        Self { style: line.style, lines: Vec::new() }
    }

    /// Adds a segment. `end` means that it ends where the whole polyline does, and has its arrow head.
    fn add(&mut self, [a, b]: [DVec3; 2], end: bool) {
        match self.lines.last_mut().filter(|line| line.points.last() == Some(&a)) {
            Some(line) => line.points.push(b),
            None => self.lines.push(Line::new(vec![a, b], self.style)),
        }
        if let Some(line) = self.lines.last_mut() {
            line.style.arrow = end && self.style.arrow;
        }
    }
}

/// The indices of corners that lie on the triangle, or the edge, with these vertices of an object.
fn vertices(part: &mut Rebuilt, object: &Object, of: [u32; 3], corners: &[ClippedCorner]) -> Vec<u32> {
    let index = |corner: &ClippedCorner| {
        let origin = corner.origin(of);
        part.vertex(origin, || origin.of(|i| object.mesh.positions[i as usize]))
    };
    corners.iter().map(index).collect()
}
