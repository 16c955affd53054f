//! The scene after clipping and projection: what the canonical volume shows.

use std::sync::Arc;

use glam::{DMat4, DVec3};

use super::clip::{Clipper, NEAR, NOT_A_NUMBER, outcode, segment};
use super::faces::Cut;
use super::light::{Lights, ObjectLight};
use super::shade::{color_at, mean_color, mean_of_colors, mean_of_uv};
use super::transform::{ClipPoint, Projector, Vertices, each_chunk};
use crate::appearance::{LineStyle, Rgba, Shading};
use crate::camera::Camera;
use crate::scene::{Line, Mesh, Object, ObjectPaint, PointMark, Scene, Text};

/// All of `scene` that is in the volume of `camera`, clipped and projected to `(x_n, y_n, −z_n)`: NDC are left-handed, with z
/// away from the eye, and this is how they are shown in a right-handed space.
///
/// Colours are baked as they are lit in the world (at the vertices for Gouraud and Phong, on faces otherwise); nothing is lit
/// any more, so the meshes have no normals. No face is culled: the observer of the result stands elsewhere than the camera. An
/// object that was cut is open, so both sides of its faces show; one that was not stays closed, and convex if it was.
#[must_use]
pub fn clipped_scene(scene: &Scene, camera: &Camera, shading: Shading) -> Scene {
    let projector = Projector::new(camera);
    // Edges alone show the object's own colour.
    let lit = shading != Shading::Wireframe && !scene.lights.is_empty();
    let lights = lit.then(|| Lights::new(&scene.lights, &projector, shading));
    let inside = |p_world: DVec3| {
        let p = projector.clip(projector.view(p_world));
        (outcode(&projector, p) == 0).then(|| displayed(&projector, p))
    };
    Scene {
        objects: scene.objects.iter().filter_map(|o| clipped_object(o, &projector, lights.as_ref(), shading)).collect(),
        lights: Vec::new(),
        lines: scene.lines.iter().flat_map(|line| clipped_line(line, &projector)).collect(),
        marks: scene
            .marks
            .iter()
            .filter_map(|mark| Some(PointMark { position: inside(mark.position)?, ..mark.clone() }))
            .collect(),
        texts: scene
            .texts
            .iter()
            .filter_map(|text| Some(Text { position: inside(text.position)?, ..text.clone() }))
            .collect(),
    }
}

/// The point at which `p_world` is shown; `None` where it cannot be projected (w ≤ 0).
#[must_use]
pub fn displayed_ndc(camera: &Camera, p_world: DVec3) -> Option<DVec3> {
    let projector = Projector::new(camera);
    let p = projector.clip(projector.view(p_world));
    (p.w > 0.0).then(|| displayed(&projector, p)).filter(|p| p.is_finite())
}

/// `(x_n, y_n, −z_n)`; the last is twice the depth of the picture less one, so it has no cancellation either.
pub(super) fn displayed(projector: &Projector, p: ClipPoint) -> DVec3 {
    DVec3::new(p.x / p.w, p.y / p.w, 2.0 * projector.picture_depth(p.depth) - 1.0)
}

fn clipped_line(line: &Line, projector: &Projector) -> Vec<Line> {
    let points: Vec<ClipPoint> = line.points.iter().map(|&p| projector.clip(projector.view(p))).collect();
    let mut pieces: Vec<Line> = Vec::new();
    let mut joined = false;
    for (i, ends) in points.windows(2).enumerate() {
        let Some([(a, _), (b, cut)]) = segment(projector, [ends[0], ends[1]]) else {
            joined = false;
            continue;
        };
        let arrow = line.style.arrow && !cut && i + 2 == points.len();
        match pieces.last_mut().filter(|_| joined) {
            Some(piece) => {
                piece.points.push(displayed(projector, b));
                piece.style.arrow = arrow;
            }
            None => pieces.push(Line {
                points: vec![displayed(projector, a), displayed(projector, b)],
                style: LineStyle { arrow, ..line.style },
            }),
        }
        joined = !cut;
    }
    pieces
}

/// An object on its way into the volume.
struct Projected<'a> {
    projector: &'a Projector,
    vertices: Vertices<'a>,
    outcodes: Vec<u8>,
    /// The new index of each vertex of the mesh that is still used.
    index: Vec<Option<u32>>,
    mesh: Mesh,
    /// What each vertex of the new mesh is made of.
    origin: Vec<Cut>,
    /// The triangle of the old mesh that each new one comes from.
    source: Vec<u32>,
    cut: bool,
}

fn clipped_object(object: &Object, projector: &Projector, lights: Option<&Lights>, shading: Shading) -> Option<Object> {
    let view_from_object = projector.view_from_object(object.world_from_object);
    let vertices = Vertices { projector, view_from_object: &view_from_object, positions: &object.mesh.positions };
    let mut outcodes = vec![0; vertices.len()];
    each_chunk(&mut outcodes, |codes, first| {
        for (code, &p) in codes.iter_mut().zip(&vertices.positions[first..]) {
            *code = outcode(projector, projector.clip(view_from_object.point(p)));
        }
    });
    let mut projected = Projected {
        projector,
        index: vec![None; vertices.len()],
        vertices,
        outcodes,
        mesh: Mesh::default(),
        origin: Vec::new(),
        source: Vec::new(),
        cut: false,
    };
    projected.triangles(&object.mesh.triangles, view_from_object.mirrored());
    projected.edges(&object.mesh.edges);
    if projected.mesh.triangles.is_empty() && projected.mesh.edges.is_empty() {
        return None;
    }
    let whole = !projected.cut && projected.source.len() == object.mesh.triangles.len();
    projected.mesh.closed = whole && object.mesh.closed;
    projected.mesh.convex = whole && object.mesh.convex;
    let paint = projected.paint(object, lights.filter(|_| object.lit), shading);
    Some(Object {
        name: object.name.clone(),
        mesh: Arc::new(projected.mesh),
        world_from_object: DMat4::IDENTITY,
        paint,
        lit: false,
        two_sided: object.two_sided || !whole,
        faces: object.faces,
        edges: object.edges,
    })
}

impl Projected<'_> {
    fn triangles(&mut self, triangles: &[[u32; 3]], mirrored: bool) {
        let mut clipper = Clipper::default();
        for (source, &triangle) in (0_u32..).zip(triangles) {
            let triangle = if mirrored { [triangle[0], triangle[2], triangle[1]] } else { triangle };
            let Some([a, b, c]) = self.codes(triangle) else { continue };
            let either = a | b | c;
            if a & b & c != 0 || either & NOT_A_NUMBER != 0 {
                continue;
            }
            if either == 0 {
                let corners = triangle.map(|i| self.own_vertex(i));
                self.mesh.triangles.push(corners);
                self.source.push(source);
                continue;
            }
            self.cut = true;
            let corners = triangle.map(|i| self.vertices.clip(i));
            let mut fan: Vec<u32> = Vec::new();
            for corner in clipper.triangle(self.projector, corners, either) {
                fan.push(match corner.original() {
                    Some(own) => self.own_vertex(triangle[own]),
                    None => self.new_vertex(corner.point, Cut { of: triangle, weights: corner.weights }),
                });
            }
            for k in 1..fan.len().saturating_sub(1) {
                self.mesh.triangles.push([fan[0], fan[k], fan[k + 1]]);
                self.source.push(source);
            }
        }
    }

    fn edges(&mut self, edges: &[[u32; 2]]) {
        for &[a, b] in edges {
            if self.codes([a, b, b]).is_none() {
                continue;
            }
            let ends = [a, b].map(|i| self.vertices.clip(i));
            let Some(kept) = segment(self.projector, ends) else { continue };
            let index: [u32; 2] = std::array::from_fn(|k| {
                let (point, cut) = kept[k];
                let own = [a, b][k];
                // An edge has no colour: what its new ends are made of does not matter.
                let of = Cut { of: [own; 3], weights: [1.0, 0.0, 0.0] };
                if cut { self.new_vertex(point, of) } else { self.own_vertex(own) }
            });
            self.mesh.edges.push(index);
        }
    }

    /// The outcodes of three vertices; `None` where the mesh has no such vertices.
    fn codes(&self, corners: [u32; 3]) -> Option<[u8; 3]> {
        let code = |i: u32| self.outcodes.get(i as usize).copied();
        Some([code(corners[0])?, code(corners[1])?, code(corners[2])?])
    }

    fn own_vertex(&mut self, i: u32) -> u32 {
        if let Some(index) = self.index[i as usize] {
            return index;
        }
        let point = self.vertices.clip(i);
        let index = self.new_vertex(point, Cut { of: [i; 3], weights: [1.0, 0.0, 0.0] });
        self.index[i as usize] = Some(index);
        index
    }

    fn new_vertex(&mut self, point: ClipPoint, origin: Cut) -> u32 {
        let index = u32::try_from(self.mesh.positions.len()).unwrap_or(u32::MAX);
        self.mesh.positions.push(displayed(self.projector, point));
        self.origin.push(origin);
        index
    }

    /// The colours, as they are seen in the world.
    fn paint(&self, object: &Object, lights: Option<&Lights>, shading: Shading) -> ObjectPaint {
        let smooth = matches!(shading, Shading::Gouraud | Shading::Phong);
        let old = &object.mesh;
        let cut_open = old.closed && self.outcodes.iter().any(|code| code & NEAR != 0);
        let both_sides = object.two_sided || cut_open || (old.closed && object.paint.is_translucent());
        let light = lights.map(|lights| ObjectLight::new(lights, old, self.vertices, both_sides));
        let faces = |color: &(dyn Fn(u32) -> Rgba + Sync)| {
            let face = |k: usize| (old.triangles[self.source[k] as usize], color(self.source[k]));
            ObjectPaint::Faces(Arc::new(match &light {
                Some(light) => light.faces(Vec::new(), self.source.len(), face),
                None => self.source.iter().map(|&face| color(face)).collect(),
            }))
        };
        let vertices = |color: &dyn Fn(u32) -> Rgba| {
            let lit = |i: u32| light.as_ref().map_or(color(i), |light| light.vertex(i, color(i)));
            let colors = self.origin.iter().map(|origin| match origin.of {
                [a, b, c] if a == b && b == c => lit(a),
                of => mean_of_colors(of.map(lit), origin.weights),
            });
            ObjectPaint::Vertices(Arc::new(colors.collect()))
        };
        match &object.paint {
            ObjectPaint::Texture { image, uv, opacity } => {
                let at = |i: u32| uv.get(i as usize).copied().unwrap_or_default();
                let uv = self.origin.iter().map(|origin| mean_of_uv(origin.of.map(at), origin.weights)).collect();
                ObjectPaint::Texture { image: image.clone(), uv: Arc::new(uv), opacity: *opacity }
            }
            ObjectPaint::Solid(color) if light.is_none() => ObjectPaint::Solid(*color),
            ObjectPaint::Solid(color) if smooth => vertices(&|_| *color),
            ObjectPaint::Solid(color) => faces(&|_| *color),
            ObjectPaint::Faces(colors) => faces(&|face| color_at(colors, face)),
            ObjectPaint::Vertices(colors) if smooth || light.is_none() => vertices(&|i| color_at(colors, i)),
            ObjectPaint::Vertices(colors) => faces(&|face| mean_color(colors, old.triangles[face as usize])),
        }
    }
}
