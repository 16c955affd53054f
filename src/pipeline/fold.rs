//! What comes of dividing by w before clipping: the mistake that homogeneous clipping is there to avoid `[2]`.
//!
//! Behind the eye w < 0, and the divide turns a point there round the eye to the front, upside down; an edge that passes the
//! plane w = 0 leads to the wrong place, although both its ends have coordinates. Clipping comes too late to mend that.

use std::sync::Arc;

use glam::{DMat4, DVec3};

use super::project::displayed;
use super::shade::{color_at, mean_color};
use super::transform::{ClipPoint, Projector};
use crate::appearance::Rgba;
use crate::camera::Camera;
use crate::scene::{Line, Mesh, Object, ObjectPaint, PointMark, Scene};

/// Farther than this a point divided by a w near 0 is nowhere.
const NOWHERE: f64 = 1e100;

/// A scene, divided before it is clipped.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Folded {
    /// What the mistake does no harm to, in the world.
    pub right: Scene,
    /// What only exists by the mistake, as the canonical volume shows it: (x_n, y_n, −z_n), clipped there. Faces have one
    /// colour each and take no light.
    pub wrong: Scene,
}

/// Divides each point of `scene` by its w as it is, and clips what comes of it to the cube of `reach` times the size of the
/// canonical volume. A point with w = 0 takes what it belongs to with it.
#[must_use]
pub fn divided_first(scene: &Scene, camera: &Camera, reach: f64) -> Folded {
    let fold = Fold { projector: Projector::new(camera), reach };
    let mut folded = Folded::default();
    folded.right.lights.clone_from(&scene.lights);
    folded.right.texts.clone_from(&scene.texts);
    folded.right.marks.clone_from(&scene.marks);
    for object in &scene.objects {
        let (right, wrong) = fold.object(object);
        folded.right.objects.push(right);
        folded.wrong.objects.extend(wrong);
    }
    for line in &scene.lines {
        fold.line(line, &mut folded);
    }
    let behind = scene.marks.iter().filter_map(|mark| {
        let p = fold.clip(mark.position);
        let position = fold.display(p).filter(|shown| p.w < 0.0 && shown.abs().max_element() <= reach)?;
        Some(PointMark { position, ..mark.clone() })
    });
    folded.wrong.marks.extend(behind);
    folded
}

struct Fold {
    projector: Projector,
    reach: f64,
}

impl Fold {
    fn clip(&self, p_world: DVec3) -> ClipPoint {
        self.projector.clip(self.projector.view(p_world))
    }

    /// The point after the divide, whatever the sign of w.
    fn display(&self, p: ClipPoint) -> Option<DVec3> {
        let shown = displayed(&self.projector, p);
        (p.w != 0.0 && shown.is_finite() && shown.abs().max_element() < NOWHERE).then_some(shown)
    }

    /// The part of a convex polygon, or of a segment, in the cube.
    fn inside(&self, polygon: &[ClipPoint]) -> Vec<DVec3> {
        let shown: Option<Vec<DVec3>> = polygon.iter().map(|p| self.display(*p)).collect();
        let mut rest = shown.unwrap_or_default();
        for axis in 0..3 {
            for sign in [1.0, -1.0] {
                rest = half(&rest, |p| self.reach - sign * p[axis]);
            }
        }
        if rest.len() < polygon.len().min(3) { Vec::new() } else { rest }
    }

    /// What is right of an object, and what is wrong of it.
    fn object(&self, object: &Object) -> (Object, Option<Object>) {
        let mesh = &object.mesh;
        let view_from_object = self.projector.view_from_object(object.world_from_object);
        let clip: Vec<ClipPoint> =
            mesh.positions.iter().map(|&p| self.projector.clip(view_from_object.point(p))).collect();
        let behind = |corners: &[u32]| corners.iter().any(|&i| clip.get(i as usize).is_some_and(|p| p.w < 0.0));
        if !clip.iter().any(|p| p.w < 0.0) {
            return (object.clone(), None);
        }
        let corners = |of: &[u32]| of.iter().filter_map(|&i| clip.get(i as usize).copied()).collect::<Vec<_>>();
        let mut right = Mesh { closed: false, convex: false, ..Mesh::clone(mesh) };
        right.triangles.retain(|triangle| !behind(triangle));
        right.edges.retain(|edge| !behind(edge));
        let (mut wrong, mut colors) = (Mesh::default(), Vec::new());
        for (face, triangle) in (0_u32..).zip(&mesh.triangles).filter(|(_, triangle)| behind(&triangle[..])) {
            let fan = add(&mut wrong, &self.inside(&corners(triangle)));
            for k in 1..fan.len().saturating_sub(1) {
                wrong.triangles.push([fan[0], fan[k], fan[k + 1]]);
                colors.push(own_color(&object.paint, face, *triangle));
            }
        }
        for edge in mesh.edges.iter().filter(|edge| behind(&edge[..])) {
            if let [a, b] = add(&mut wrong, &self.inside(&corners(edge)))[..] {
                wrong.edges.push([a, b]);
            }
        }
        let paint = match &object.paint {
            ObjectPaint::Faces(colors) => {
                let kept = mesh.triangles.iter().zip(0..).filter(|(triangle, _)| !behind(&triangle[..]));
                ObjectPaint::Faces(Arc::new(kept.map(|(_, face)| color_at(colors, face)).collect()))
            }
            paint => paint.clone(),
        };
        // Open now, so that its inside shows, as where clipping has cut it open.
        let two_sided = object.two_sided || mesh.closed;
        let right = Object { mesh: Arc::new(right), paint, two_sided, ..object.clone() };
        let empty = wrong.triangles.is_empty() && wrong.edges.is_empty();
        let wrong = (!empty).then(|| Object {
            mesh: Arc::new(wrong),
            world_from_object: DMat4::IDENTITY,
            paint: ObjectPaint::Faces(Arc::new(colors)),
            lit: false,
            two_sided: true,
            ..object.clone()
        });
        (right, wrong)
    }

    fn line(&self, line: &Line, folded: &mut Folded) {
        let clip: Vec<ClipPoint> = line.points.iter().map(|&p| self.clip(p)).collect();
        if !clip.iter().any(|p| p.w < 0.0) {
            folded.right.lines.push(line.clone());
            return;
        }
        for (ends, points) in clip.windows(2).zip(line.points.windows(2)) {
            let (lines, points) = if ends.iter().any(|p| p.w < 0.0) {
                (&mut folded.wrong.lines, self.inside(ends))
            } else {
                (&mut folded.right.lines, points.to_vec())
            };
            if !points.is_empty() {
                lines.push(Line { points, ..line.clone() });
            }
        }
    }
}

/// The part of a convex polygon, or of a segment, where `distance` is not negative.
fn half(polygon: &[DVec3], distance: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut kept = Vec::new();
    for (i, &p) in polygon.iter().enumerate() {
        let d1 = distance(p);
        if d1 >= 0.0 {
            kept.push(p);
        }
        if polygon.len() == 2 && i == 1 {
            break;
        }
        let q = polygon[(i + 1) % polygon.len()];
        let d2 = distance(q);
        if d1 * d2 < 0.0 {
            let (d1, d2) = (d1.abs(), d2.abs());
            kept.push(p * (d2 / (d1 + d2)) + q * (d1 / (d1 + d2)));
        }
    }
    kept
}

/// Adds points to a mesh; the result is their indices.
fn add(mesh: &mut Mesh, points: &[DVec3]) -> Vec<u32> {
    let first = u32::try_from(mesh.positions.len()).unwrap_or(u32::MAX);
    mesh.positions.extend_from_slice(points);
    (first..).take(points.len()).collect()
}

fn own_color(paint: &ObjectPaint, face: u32, triangle: [u32; 3]) -> Rgba {
    match paint {
        ObjectPaint::Solid(color) => *color,
        ObjectPaint::Faces(colors) => color_at(colors, face),
        ObjectPaint::Vertices(colors) => mean_color(colors, triangle),
        ObjectPaint::Texture { .. } => color_at(&[], 0),
    }
}
