//! The scene after clipping and projection: the content of the canonical volume.

use std::sync::Arc;

use glam::{DMat4, DVec3, DVec4};

use super::clip::Clipper;
use super::depths::{DepthScale, InView, Sheet};
use super::light::{Lights, ObjectLight};
use super::lines;
use super::planes::{NEAR, NOT_A_NUMBER, PLANES, outcode};
use super::projector::{ClipPoint, Projector};
use super::resample::{Remake, VertexOrigin, color_at, face_color, object_paint};
use super::scenes::Scenes;
use super::shade::WHITE;
use super::transform::{Vertices, each_chunk};
use crate::appearance::{LightShare, LineStyle, Rgba, Shading};
use crate::camera::Camera;
use crate::drawing::single;
use crate::scene::{
    Adjacency, FoundLight, InWorld, Line, Mesh, Object, ObjectPaint, PointMark, Scene, SharedEdge, Text,
};

/// All of `scene` that is in the volume of `camera`, clipped and projected to `(x_n, y_n, −z_n)`: NDC are left-handed,
/// with z away from the eye, and this is their display in a right-handed space.
///
/// Colours are baked as they are lit in the world (at the vertices for Gouraud and Phong, on faces otherwise), but for
/// what is textured or in the reach of shadows: light stays apart there, and shadows fall where they fall in the world.
/// The result takes no light, so the meshes have no normals. No face is culled: the observer of the result is elsewhere
/// than the camera. An object that was cut is open, so both sides of its faces show; an uncut one stays closed, and
/// convex if it was.
#[must_use]
pub fn clipped_scene(scene: &Scene, camera: &Camera, shading: Shading) -> Scene {
    clipped_by(scene, &Projector::new(camera), shading).0
}

/// [`clipped_scene`], unless all of it together is thinner along z_n than a picture of the volume can show: with an F
/// or a B that is far from the scene, NDC make it a sheet, in which nothing is in front of anything else. It is shown a
/// pixel or two thick then.
#[must_use]
pub fn legible_clipped_scene(scene: &Scene, camera: &Camera, shading: Shading) -> Scene {
    let mut projector = Projector::new(camera);
    let (clipped, in_view) = clipped_by(scene, &projector, shading);
    projector.sheet = Sheet::of(&projector.depths, in_view);
    if projector.sheet.is_some() { clipped_by(scene, &projector, shading).0 } else { clipped }
}

fn clipped_by(scene: &Scene, projector: &Projector, shading: Shading) -> (Scene, InView) {
    let mut in_view = lines::in_view(scene.into(), projector);
    // Edges alone show the object's own colour.
    let lit = shading != Shading::Wireframe && !scene.lights.is_empty();
    let lights = lit.then(|| Lights::new(&scene.lights, projector, shading));
    let casting = scene.lights.iter().enumerate().filter(|(_, light)| light.shadows.cast).map(|(light, _)| light);
    let casting: Vec<usize> = casting.filter(|_| Scenes::from(scene).casts_shadows()).collect();
    let lights = lights.as_ref().map(|lights| WorldLight { lights, casting: &casting });
    let inside = |p_world: DVec3| {
        let p = projector.clip(projector.view(p_world));
        (outcode(projector, p) == 0).then(|| displayed(projector, p))
    };
    let mut borders = Vec::new();
    let mut clip = |object| {
        let (clipped, depths, cuts) = clipped_object(object, projector, lights, shading)?;
        in_view = in_view.and(depths);
        borders.extend(cuts);
        Some(clipped)
    };
    let objects = scene.objects.iter().filter_map(&mut clip).collect();
    let lines = scene.lines.iter().flat_map(|line| clipped_line(line, projector));
    let clipped = Scene {
        objects,
        lights: Vec::new(),
        lines: lines.chain(borders).collect(),
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
        grids: Vec::new(),
        notices: Vec::new(),
    };
    (clipped, in_view)
}

/// The point at which `p_world` is shown; `None` where it cannot be projected (w ≤ 0).
#[must_use]
pub fn displayed_ndc(camera: &Camera, p_world: DVec3) -> Option<DVec3> {
    let projector = Projector::new(camera);
    let p = projector.clip(projector.view(p_world));
    (p.w > 0.0).then(|| displayed(&projector, p)).filter(|p| p.is_finite())
}

/// World points in view space, as the pictures are drawn from them: C is subtracted before anything is rotated, in
/// `f64`.
pub fn view_of(camera: &Camera) -> impl Fn(DVec3) -> DVec3 {
    let projector = Projector::new(camera);
    move |p_world| projector.view(p_world)
}

/// The depth that the depth buffer of a picture holds for a distance from the plane of the eye (scene units), and its
/// scale.
pub fn depth_buffer_of(camera: &Camera, in_view: InView) -> (DepthScale, impl Fn(f64) -> f32) {
    let projector = Projector::new(camera);
    let depths = projector.depths.resolving(in_view.clipped(camera.near(), camera.far()));
    (depths, move |distance| single(depths.depth(distance)))
}

/// The part in the volume of a segment between two world points, as shown in the canonical volume: `(x_n, y_n, −z_n)`
/// of its ends.
pub fn clipped_segment_of(camera: &Camera) -> impl Fn([DVec3; 2]) -> Option<[DVec3; 2]> {
    let projector = Projector::new(camera);
    move |ends| {
        let ends = ends.map(|p| projector.clip(projector.view(p)));
        let [(a, _), (b, _)] = Clipper::default().segment(&projector, ends)?;
        Some([displayed(&projector, a), displayed(&projector, b)])
    }
}

/// `(x_n, y_n, −z_n)`; the last is twice the depth of the picture less one, so it has no cancellation either.
pub(super) fn displayed(projector: &Projector, p: ClipPoint) -> DVec3 {
    let z = match projector.sheet {
        None => 2.0 * projector.depths.depth(p.depth) - 1.0,
        Some(Sheet { farthest, slope, behind }) => behind + slope * (farthest - p.depth) / p.w,
    };
    DVec3::new(p.x / p.w, p.y / p.w, z)
}

/// [`displayed`] as a matrix, from view space: the divide is still to be done.
fn display_from_view(projector: &Projector) -> DMat4 {
    let [sx, sy] = projector.scale;
    // w as a function of (x, y, z, 1).
    let w = if projector.perspective { DVec4::NEG_Z } else { DVec4::W };
    // 2 · depth of the picture · w: of F (B − d)/(B − F) in perspective, (B − d)/(B − F) else, with d = −z.
    let slope = 2.0 * if projector.perspective { projector.near } else { 1.0 } / (projector.far - projector.near);
    let whole = Sheet { farthest: projector.far, slope, behind: -1.0 };
    let Sheet { farthest, slope, behind } = projector.sheet.unwrap_or(whole);
    let rows = [
        DVec4::X * sx - w * projector.shift[0],
        DVec4::Y * sy - w * projector.shift[1],
        (DVec4::Z + DVec4::W * farthest) * slope + w * behind,
        w,
    ];
    DMat4::from_cols(rows[0], rows[1], rows[2], rows[3]).transpose()
}

fn clipped_line(line: &Line, projector: &Projector) -> Vec<Line> {
    let points: Vec<ClipPoint> = line.points.iter().map(|&p| projector.clip(projector.view(p))).collect();
    let mut pieces: Vec<Line> = Vec::new();
    let mut joined = false;
    let mut clipper = Clipper::default();
    for (i, ends) in points.windows(2).enumerate() {
        let Some([(a, _), (b, cut)]) = clipper.segment(projector, [ends[0], ends[1]]) else {
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

/// The lights of the world.
#[derive(Clone, Copy)]
struct WorldLight<'a> {
    lights: &'a Lights,
    /// The places of those that cast shadows.
    casting: &'a [usize],
}

/// An object on its way into the volume.
struct Projected<'a> {
    projector: &'a Projector,
    vertices: Vertices<'a>,
    outcodes: Vec<u8>,
    remake: Remake,
    /// The displayed position of each new vertex.
    positions: Vec<DVec3>,
    in_view: InView,
    cut: bool,
    /// The sides along which triangles were cut.
    borders: Vec<[DVec3; 2]>,
}

fn clipped_object(
    object: &Object,
    projector: &Projector,
    lights: Option<WorldLight>,
    shading: Shading,
) -> Option<(Object, InView, Vec<Line>)> {
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
        vertices,
        outcodes,
        remake: Remake::new(&object.mesh),
        positions: Vec::new(),
        in_view: InView::NOTHING,
        cut: false,
        borders: Vec::new(),
    };
    projected.triangles(&object.mesh.triangles, view_from_object.mirrored());
    projected.edges(&object.mesh.edges);
    projected.shared(&object.mesh.adjacency.edges);
    let planes = match object.mesh.adjacency.planes.as_slice() {
        [] => Vec::new(),
        planes => {
            let display_from_object = display_from_view(projector) * view_from_object.matrix();
            let of_planes = display_from_object.inverse().transpose();
            planes.iter().map(|&plane| of_planes * plane).collect()
        }
    };
    if projected.remake.is_empty() {
        return None;
    }
    let whole = !projected.cut && projected.remake.sources.len() == object.mesh.triangles.len();
    let (paint, in_world) = projected.paint(object, lights.filter(|_| object.lit), shading);
    let Projected { remake: Remake { triangles, edges, shared, .. }, positions, in_view, borders, .. } = projected;
    // What has edges or an outline has them where it was cut too; of a wireframe only edges are seen.
    let border = object.edges.or(object.outline).filter(|_| shading != Shading::Wireframe && object.faces);
    let cuts = border
        .map_or_else(Vec::new, |style| borders.into_iter().map(|ends| Line { points: ends.to_vec(), style }).collect());
    let (closed, convex) = (whole && object.mesh.closed, whole && object.mesh.convex);
    let clipped = Object {
        part_of: object.part_of.clone(),
        name: object.name.clone(),
        mesh: Arc::new(Mesh {
            positions,
            normals: Vec::new(),
            triangles,
            edges,
            adjacency: Adjacency { planes, edges: shared },
            closed,
            convex,
        }),
        world_from_object: DMat4::IDENTITY,
        paint,
        lit: false,
        two_sided: object.two_sided || !whole,
        faces: object.faces,
        edges: object.edges,
        outline: object.outline,
        in_world: in_world.map(Arc::new),
    };
    Some((clipped, in_view, cuts))
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
                self.remake.polygon(&corners, source);
                continue;
            }
            self.cut = true;
            let corners = triangle.map(|i| self.vertices.clip(i));
            let mut polygon: Vec<u32> = Vec::new();
            let kept = clipper.triangle(self.projector, corners, either);
            for corner in kept {
                polygon.push(self.vertex(corner.point, corner.origin(triangle)));
            }
            // A side whose ends both lie in a plane that the triangle crosses is where that plane cuts it.
            for (corner, next) in kept.iter().zip(kept.iter().cycle().skip(1)) {
                let lies_in = |plane: usize| corner.distances[plane] == 0.0 && next.distances[plane] == 0.0;
                if (0..PLANES).any(|plane| either >> plane & 1 == 1 && lies_in(plane)) {
                    self.borders.push([corner, next].map(|end| displayed(self.projector, end.point)));
                }
            }
            self.remake.polygon(&polygon, source);
        }
    }

    fn edges(&mut self, edges: &[[u32; 2]]) {
        let mut clipper = Clipper::default();
        for &ends in edges {
            if let Some(ends) = self.edge(ends, &mut clipper) {
                self.remake.edges.push(ends);
            }
        }
    }

    fn shared(&mut self, edges: &[SharedEdge]) {
        let mut clipper = Clipper::default();
        for &edge in edges {
            if let Some(ends) = self.edge(edge.ends, &mut clipper) {
                self.remake.shared.push(SharedEdge { ends, ..edge });
            }
        }
    }

    /// The part of an edge that is in the volume.
    fn edge(&mut self, ends: [u32; 2], clipper: &mut Clipper) -> Option<[u32; 2]> {
        let [a, b] = ends;
        self.codes([a, b, b])?;
        let kept = clipper.segment(self.projector, ends.map(|i| self.vertices.clip(i)))?;
        Some(std::array::from_fn(|k| {
            let (point, cut) = kept[k];
            let own = ends[k];
            // An edge has no colour: the origin of its new ends does not matter.
            let between = VertexOrigin::Between { of: [own; 3], weights: [1.0, 0.0, 0.0] };
            self.vertex(point, if cut { between } else { VertexOrigin::Vertex(own) })
        }))
    }

    /// The outcodes of three vertices; `None` where the mesh has no such vertices.
    fn codes(&self, corners: [u32; 3]) -> Option<[u8; 3]> {
        let code = |i: u32| self.outcodes.get(i as usize).copied();
        Some([code(corners[0])?, code(corners[1])?, code(corners[2])?])
    }

    fn own_vertex(&mut self, i: u32) -> u32 {
        self.vertex(self.vertices.clip(i), VertexOrigin::Vertex(i))
    }

    fn vertex(&mut self, point: ClipPoint, origin: VertexOrigin) -> u32 {
        let index = self.remake.vertex(origin);
        if self.remake.origins.len() > self.positions.len() {
            self.positions.push(displayed(self.projector, point));
            self.in_view = self.in_view.and(InView::between(point.depth, point.depth));
        }
        index
    }

    /// The colours without light.
    fn own_paint(&self, object: &Object) -> ObjectPaint {
        object_paint(object, self.remake.origins.iter().copied(), &self.remake.sources)
    }

    /// One colour for each face, without light.
    fn face_colors(&self, object: &Object) -> Arc<Vec<Rgba>> {
        let color = |&face: &u32| face_color(&object.paint, face, object.mesh.triangles[face as usize]);
        Arc::new(self.remake.sources.iter().map(color).collect())
    }

    /// One colour for each face, lit by `light`.
    fn lit_faces(&self, object: &Object, light: &ObjectLight) -> Arc<Vec<Rgba>> {
        let face = |k: usize| {
            let source = self.remake.sources[k];
            let triangle = object.mesh.triangles[source as usize];
            (triangle, face_color(&object.paint, source, triangle))
        };
        Arc::new(light.faces(Vec::new(), self.remake.sources.len(), face))
    }

    /// The shares of a light.
    fn found(&self, old: &Mesh, light: &ObjectLight, is_smooth: bool) -> FoundLight {
        if is_smooth {
            let shares: Vec<LightShare> = light.vertices(Vec::new(), &[], |_| WHITE);
            let at = |i: u32| shares.get(i as usize).copied().unwrap_or_default();
            return FoundLight::Vertices(self.remake.origins.iter().map(|origin| origin.of(at)).collect());
        }
        let sources = &self.remake.sources;
        let face = |k: usize| (old.triangles[sources[k] as usize], WHITE);
        FoundLight::Faces(light.faces(Vec::new(), sources.len(), face))
    }

    /// The colours as they are seen in the world, or their own colours and the light of the world on them.
    fn paint(&self, object: &Object, world: Option<WorldLight>, shading: Shading) -> (ObjectPaint, Option<InWorld>) {
        let old = &object.mesh;
        let cut_open = old.closed && self.outcodes.iter().any(|code| code & NEAR != 0);
        let both_sides = object.two_sided || cut_open || (old.closed && object.paint.is_translucent());
        let light_of = |lights| ObjectLight::new(lights, old, self.vertices, both_sides);
        let is_smooth = matches!(shading, Shading::Gouraud | Shading::Phong);
        let casting = world.map_or(&[][..], |world| world.casting);
        if matches!(object.paint, ObjectPaint::Texture(_)) || !casting.is_empty() {
            let w = |i: u32| self.vertices.clip(i).w;
            let inverse = |origin: &VertexOrigin| self.projector.depths.relative_inverse_w(origin.of(w));
            let place = |i: u32| object.world_from_object.transform_point3(old.positions[i as usize]);
            let origins = || self.remake.origins.iter();
            let of_one = |world: WorldLight, light| {
                let alone = world.lights.only(light);
                self.found(old, &ObjectLight::new(&alone, old, self.vertices, both_sides), is_smooth)
            };
            let in_world = InWorld {
                light: world.map_or(FoundLight::None, |world| self.found(old, &light_of(world.lights), is_smooth)),
                inverse_w: origins().filter(|_| self.projector.perspective).map(inverse).collect(),
                positions: origins().filter(|_| !casting.is_empty()).map(|origin| origin.of(place)).collect(),
                taken: world.map_or_else(Vec::new, |world| {
                    casting.iter().map(|&light| (light, of_one(world, light))).collect()
                }),
            };
            // Flat faces have one colour, that of their light too.
            let paint = match &object.paint {
                ObjectPaint::Vertices(_) if !is_smooth => ObjectPaint::Faces(self.face_colors(object)),
                _ => self.own_paint(object),
            };
            return (paint, Some(in_world));
        }
        let Some(WorldLight { lights, .. }) = world else { return (self.own_paint(object), None) };
        let light = light_of(lights);
        let vertices = |color: &dyn Fn(u32) -> Rgba| {
            let lit = |i: u32| light.vertex(i, color(i));
            ObjectPaint::Vertices(Arc::new(self.remake.origins.iter().map(|origin| origin.of(lit)).collect()))
        };
        let paint = match &object.paint {
            ObjectPaint::Solid(color) if is_smooth => vertices(&|_| *color),
            ObjectPaint::Vertices(colors) if is_smooth => vertices(&|i| color_at(colors, i)),
            _ => ObjectPaint::Faces(self.lit_faces(object, &light)),
        };
        (paint, None)
    }
}
