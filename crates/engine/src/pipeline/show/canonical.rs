//! The scene after clipping and projection: the content of the canonical volume.

use std::sync::Arc;

use glam::{DMat4, DVec3, DVec4};

use super::projected::{Projected, displayed};
use crate::appearance::{LightShare, LineStyle, Rgba, Shading};
use crate::camera::Camera;
use crate::drawing::single;
use crate::pipeline::mesh::resample::{Rebuilt, VertexOrigin, color_at, face_color, object_paint};
use crate::pipeline::scenes::Scenes;
use crate::pipeline::space::depths::{DepthScale, InView, Sheet};
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{ClipPoint, NEAR, WorldPoint, outcode};
use crate::pipeline::stage::clip::Clipper;
use crate::pipeline::stage::light::WHITE;
use crate::pipeline::stage::lines;
use crate::pipeline::stage::reflection::{Lights, ObjectLight};
use crate::pipeline::stage::vertex::clip_from_world;
use crate::pipeline::stage::vertices::Vertices;
use crate::scene::{Adjacency, FoundLight, InWorld, Line, Mesh, Object, ObjectPaint, PointMark, Scene, Text};

/// The part of `scene` in the volume of `camera`, clipped and projected to `(x_n, y_n, −z_n)`. NDC are left-handed,
/// with z away from the eye, and this is their display in a right-handed space.
///
/// Colours are baked as they are lit in the world (at the vertices for Gouraud and Phong, on faces otherwise). On
/// textured objects and those in the reach of shadows light stays apart, and shadows fall where they fall in the world.
/// The result takes no light, so the meshes have no normals. No face is culled. The observer of the result is elsewhere
/// than the camera. An object that was cut is open, so both sides of its faces show. An uncut one stays closed, and
/// convex if it was.
pub fn clipped_scene(scene: &Scene, camera: &Camera, shading: Shading) -> Scene {
    clipped_by(scene, &Projector::new(camera), shading).0
}

/// [`clipped_scene`], unless the whole scene is thinner along z_n than a picture of the volume can show. With an F or a
/// B that is far from the scene, NDC make it a sheet, in which nothing is in front of anything else. It's then shown a
/// pixel or two thick.
pub fn legible_clipped_scene(scene: &Scene, camera: &Camera, shading: Shading) -> Scene {
    let mut projector = Projector::new(camera);
    let (clipped, in_view) = clipped_by(scene, &projector, shading);
    projector.sheet = Sheet::of(&projector.depths, in_view);
    match projector.sheet {
        None => clipped,
        Some(_) => clipped_by(scene, &projector, shading).0,
    }
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
        let p = clip_from_world(projector, WorldPoint(p_world));
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
        ..Scene::default()
    };
    (clipped, in_view)
}

/// The point at which `p_world` is shown. `None` if it can't be projected (w ≤ 0).
pub fn displayed_ndc(camera: &Camera, p_world: DVec3) -> Option<DVec3> {
    let projector = Projector::new(camera);
    let p = clip_from_world(&projector, WorldPoint(p_world));
    (p.w > 0.0).then(|| displayed(&projector, p)).filter(|p| p.is_finite())
}

/// World points in view space, as the pictures are drawn from them: C is subtracted before anything is rotated, in
/// `f64`.
pub fn view_of(camera: &Camera) -> impl Fn(DVec3) -> DVec3 {
    let projector = Projector::new(camera);
    move |p_world| projector.view(WorldPoint(p_world)).0
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
        let ends = ends.map(|p| clip_from_world(&projector, WorldPoint(p)));
        let [(a, _), (b, _)] = Clipper::default().segment(&projector, ends)?;
        Some([displayed(&projector, a), displayed(&projector, b)])
    }
}

/// [`displayed`] as a matrix, from view space. The divide is still to be done.
fn display_from_view(projector: &Projector) -> DMat4 {
    let [sx, sy] = projector.scale;
    // w as a function of (x, y, z, 1).
    let w = if projector.projection.is_perspective() { DVec4::NEG_Z } else { DVec4::W };
    // 2 · depth of the picture · w: of F (B − d)/(B − F) in perspective, (B − d)/(B − F) else, with d = −z.
    let slope = 2.0 * if projector.projection.is_perspective() { projector.near } else { 1.0 }
        / (projector.far - projector.near);
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
    let points: Vec<ClipPoint> = line.points.iter().map(|&p| clip_from_world(projector, WorldPoint(p))).collect();
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
                role: line.role,
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

fn clipped_object(
    object: &Object,
    projector: &Projector,
    lights: Option<WorldLight>,
    shading: Shading,
) -> Option<(Object, InView, Vec<Line>)> {
    let view_from_object = projector.view_from_object(object.world_from_object);
    let vertices = Vertices { projector, view_from_object: &view_from_object, positions: &object.mesh.positions };
    let projected = Projected::new(vertices, &object.mesh);
    if projected.rebuilt.is_empty() {
        return None;
    }
    let planes = match object.mesh.adjacency.planes.as_slice() {
        [] => Vec::new(),
        planes => {
            let display_from_object = display_from_view(projector) * view_from_object.matrix();
            let of_planes = display_from_object.inverse().transpose();
            planes.iter().map(|&plane| of_planes * plane).collect()
        }
    };
    let cut_open = projected.outside() & NEAR != 0;
    let colored = Colored { object, vertices, rebuilt: &projected.rebuilt, cut_open, shading };
    let (paint, in_world) = colored.paint(lights.filter(|_| object.lit));
    let Projected { rebuilt: Rebuilt { positions, triangles, edges, shared, .. }, in_view, whole, borders, .. } =
        projected;
    // An object with edges or an outline has them along its cuts too. A wireframe shows only edges.
    let border = object.edges.or(object.outline).filter(|_| shading != Shading::Wireframe && object.faces);
    let cuts =
        border.map_or_else(Vec::new, |style| borders.into_iter().map(|ends| Line::new(ends.to_vec(), style)).collect());
    let (closed, convex) = (whole && object.mesh.closed, whole && object.mesh.convex);
    let clipped = Object {
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
        in_world: in_world.map(Arc::new),
        ..object.clone()
    };
    Some((clipped, in_view, cuts))
}

/// An object with its mesh but not yet its paint.
struct Colored<'a> {
    object: &'a Object,
    vertices: Vertices<'a>,
    rebuilt: &'a Rebuilt,
    cut_open: bool,
    shading: Shading,
}

impl Colored<'_> {
    /// The colours without light.
    fn own_paint(&self) -> ObjectPaint {
        object_paint(self.object, self.rebuilt.origins.iter().copied(), &self.rebuilt.sources)
    }

    /// One colour for each face, without light.
    fn face_colors(&self) -> Arc<Vec<Rgba>> {
        let color = |&face: &u32| face_color(&self.object.paint, face, self.object.mesh.triangles[face as usize]);
        Arc::new(self.rebuilt.sources.iter().map(color).collect())
    }

    /// One colour for each face, lit by `light`.
    fn lit_faces(&self, light: &ObjectLight) -> Arc<Vec<Rgba>> {
        let face = |k: usize| {
            let source = self.rebuilt.sources[k];
            let triangle = self.object.mesh.triangles[source as usize];
            (triangle, face_color(&self.object.paint, source, triangle))
        };
        Arc::new(light.faces(self.rebuilt.sources.len(), face))
    }

    /// One colour for each vertex, lit by `light`.
    fn lit_vertices(&self, light: &ObjectLight, color: impl Fn(u32) -> Rgba + Sync + Send) -> Arc<Vec<Rgba>> {
        let lit: Vec<Rgba> = light.vertices(&[], color);
        Arc::new(self.rebuilt.origins.iter().map(|origin| origin.of(|i| color_at(&lit, i))).collect())
    }

    /// The shares of a light.
    fn found(&self, light: &ObjectLight) -> FoundLight {
        if self.is_smooth() {
            let shares: Vec<LightShare> = light.vertices(&[], |_| WHITE);
            let at = |i: u32| shares.get(i as usize).copied().unwrap_or_default();
            return FoundLight::Vertices(self.rebuilt.origins.iter().map(|origin| origin.of(at)).collect());
        }
        let face = |k: usize| (self.object.mesh.triangles[self.rebuilt.sources[k] as usize], WHITE);
        FoundLight::Faces(light.faces(self.rebuilt.sources.len(), face))
    }

    fn is_smooth(&self) -> bool {
        matches!(self.shading, Shading::Gouraud | Shading::Phong)
    }

    /// The colours as seen in the world, or the objects' own colours and the light of the world on them.
    fn paint(&self, world: Option<WorldLight>) -> (ObjectPaint, Option<InWorld>) {
        let Self { object, vertices, cut_open, .. } = *self;
        let old = &object.mesh;
        let both_sides = object.shows_both_sides(cut_open);
        let light_of = |lights| ObjectLight::new(lights, old, vertices, both_sides);
        let casting = world.map_or(&[][..], |world| world.casting);
        if matches!(object.paint, ObjectPaint::Texture(_)) || !casting.is_empty() {
            return self.in_world(world, casting, both_sides);
        }
        let Some(WorldLight { lights, .. }) = world else { return (self.own_paint(), None) };
        let light = light_of(lights);
        let paint = match &object.paint {
            ObjectPaint::Solid(color) if self.is_smooth() => {
                ObjectPaint::Vertices(self.lit_vertices(&light, |_| *color))
            }
            ObjectPaint::Vertices(colors) if self.is_smooth() => {
                ObjectPaint::Vertices(self.lit_vertices(&light, |i| color_at(colors, i)))
            }
            _ => ObjectPaint::Faces(self.lit_faces(&light)),
        };
        (paint, None)
    }

    /// The objects' own colours, and the light of the world apart.
    fn in_world(
        &self,
        world: Option<WorldLight>,
        casting: &[usize],
        both_sides: bool,
    ) -> (ObjectPaint, Option<InWorld>) {
        let Self { object, vertices, .. } = *self;
        let origins = || self.rebuilt.origins.iter();
        let (old, projector) = (&object.mesh, vertices.projector);
        let w = |i: u32| vertices.clip_point(i).w;
        let inverse = |origin: &VertexOrigin| projector.depths.relative_inverse_w(origin.of(w));
        let place = |i: u32| object.world_from_object.transform_point3(old.positions[i as usize]);
        let of = |lights: &Lights| self.found(&ObjectLight::new(lights, old, vertices, both_sides));
        let in_world = InWorld {
            light: world.map_or(FoundLight::None, |world| of(world.lights)),
            inverse_w: origins().filter(|_| projector.projection.is_perspective()).map(inverse).collect(),
            positions: origins().filter(|_| !casting.is_empty()).map(|origin| origin.of(place)).collect(),
            taken: world.map_or_else(Vec::new, |world| {
                casting.iter().map(|&light| (light, of(&world.lights.only(light)))).collect()
            }),
        };
        // Flat faces have one colour, and so has their light.
        let paint = match &object.paint {
            ObjectPaint::Vertices(_) if !self.is_smooth() => ObjectPaint::Faces(self.face_colors()),
            _ => self.own_paint(),
        };
        (paint, Some(in_world))
    }
}
