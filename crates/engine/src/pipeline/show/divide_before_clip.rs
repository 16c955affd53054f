//! The result of dividing by w before clipping, the mistake that homogeneous clipping avoids `[2]`.
//!
//! Behind the eye w < 0, and the divide moves a point there through the eye to the front, upside down. An edge that
//! passes the plane w = 0 leads to the wrong place, although both its ends have coordinates. Clipping comes too late to
//! repair that.

use glam::{DMat4, DVec3};

use super::projected::displayed;
use crate::camera::Camera;
use crate::pipeline::mesh::cut::{Origin, cut};
use crate::pipeline::mesh::resample::{OWN_WEIGHTS, Rebuilt, VertexOrigin, with_triangles};
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{ClipPoint, ObjectPoint, WorldPoint};
use crate::pipeline::stage::vertex::{clip_from_view, clip_from_world, view_point};
use crate::scene::{Line, Object, PointMark, Scene};

/// A point divided by a w near 0 that lies farther away than this is nowhere.
const MAX_DIVIDED: f64 = 1e100;

/// A scene, divided before it is clipped.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DividedFirst {
    /// The part of the scene unharmed by the mistake, in the world.
    pub right: Scene,
    /// The part that exists only by the mistake, as the canonical volume shows it: (x_n, y_n, −z_n), clipped there. It
    /// takes no light.
    pub wrong: Scene,
}

impl DividedFirst {
    /// True if nothing of the scene is wrong.
    pub fn is_right(&self) -> bool {
        let Scene { objects, lines, marks, .. } = &self.wrong;
        objects.is_empty() && lines.is_empty() && marks.is_empty()
    }
}

/// Divides each point of `scene` by its own w, and clips the result to the cube of `reach` times the size of the
/// canonical volume. A point with w = 0 removes the face or stroke it belongs to.
pub fn divided_first(scene: &Scene, camera: &Camera, reach: f64) -> DividedFirst {
    let divide = Divide { projector: Projector::new(camera), reach };
    let mut result = DividedFirst::default();
    result.right.lights.clone_from(&scene.lights);
    result.right.texts.clone_from(&scene.texts);
    result.right.marks.clone_from(&scene.marks);
    for object in &scene.objects {
        let (right, wrong) = divide.object(object);
        result.right.objects.push(right);
        result.wrong.objects.extend(wrong);
    }
    for line in &scene.lines {
        divide.line(line, &mut result);
    }
    let behind = scene.marks.iter().filter_map(|mark| {
        let p = divide.clip(mark.position);
        let position = divide.display(p).filter(|shown| p.w < 0.0 && shown.abs().max_element() <= reach)?;
        Some(PointMark { position, ..mark.clone() })
    });
    result.wrong.marks.extend(behind);
    result
}

/// A corner of a polygon after the divide.
#[derive(Clone, Copy)]
struct DividedCorner {
    shown: DVec3,
    /// Its share of each corner of the triangle, or of the ends of the segment, that it came from.
    weights: [f64; 3],
}

struct Divide {
    projector: Projector,
    reach: f64,
}

impl Divide {
    fn clip(&self, p_world: DVec3) -> ClipPoint {
        clip_from_world(&self.projector, WorldPoint(p_world))
    }

    /// The point after the divide, whatever the sign of w.
    fn display(&self, p: ClipPoint) -> Option<DVec3> {
        let shown = displayed(&self.projector, p);
        (p.w != 0.0 && shown.is_finite() && shown.abs().max_element() < MAX_DIVIDED).then_some(shown)
    }

    /// The part of a triangle, or of a segment, in the cube.
    fn inside(&self, polygon: &[ClipPoint]) -> Vec<DividedCorner> {
        let whole = polygon.iter().zip(OWN_WEIGHTS);
        let shown: Option<Vec<DividedCorner>> =
            whole.map(|(p, weights)| Some(DividedCorner { shown: self.display(*p)?, weights })).collect();
        let mut rest = shown.unwrap_or_default();
        for axis in 0..3 {
            for sign in [1.0, -1.0] {
                rest = half(&rest, |p| self.reach - sign * p[axis]);
            }
        }
        if rest.len() < polygon.len().min(3) { Vec::new() } else { rest }
    }

    /// The right part of an object, and the wrong part.
    fn object(&self, object: &Object) -> (Object, Option<Object>) {
        let mesh = &object.mesh;
        let view_from_object = self.projector.view_from_object(object.world_from_object);
        let clip: Vec<ClipPoint> = mesh
            .positions
            .iter()
            .map(|&p| clip_from_view(&self.projector, view_point(&view_from_object, ObjectPoint(p))))
            .collect();
        let behind = |corners: &[u32]| corners.iter().any(|&i| clip.get(i as usize).is_some_and(|p| p.w < 0.0));
        if !clip.iter().any(|p| p.w < 0.0) {
            return (object.clone(), None);
        }
        let inside = |of: &[u32]| {
            let corners: Option<Vec<ClipPoint>> = of.iter().map(|&i| clip.get(i as usize).copied()).collect();
            self.inside(&corners.unwrap_or_default())
        };
        let right: Vec<u32> =
            (0..).zip(&mesh.triangles).filter(|(_, triangle)| !behind(&triangle[..])).map(|(face, _)| face).collect();
        let edges = mesh.edges.iter().copied().filter(|edge| !behind(&edge[..])).collect();
        let outlined = mesh.adjacency.edges.iter().copied().filter(|edge| !behind(&edge.ends)).collect();
        let mut wrong = Rebuilt::new(mesh);
        let vertices = |wrong: &mut Rebuilt, of: [u32; 3], corners: &[DividedCorner]| -> Vec<u32> {
            let index = |corner: &DividedCorner| wrong.vertex(VertexOrigin::on(of, corner.weights), || corner.shown);
            corners.iter().map(index).collect()
        };
        for (face, triangle) in (0_u32..).zip(&mesh.triangles).filter(|(_, triangle)| behind(&triangle[..])) {
            let polygon = vertices(&mut wrong, *triangle, &inside(triangle));
            wrong.polygon(&polygon, face);
        }
        for &[a, b] in mesh.edges.iter().filter(|edge| behind(&edge[..])) {
            if let [a, b] = vertices(&mut wrong, [a, b, b], &inside(&[a, b]))[..] {
                wrong.edges.push([a, b]);
            }
        }
        let wrong = wrong.into_object(object).map(|wrong| Object {
            world_from_object: DMat4::IDENTITY,
            lit: false,
            two_sided: true,
            // Turned round the eye, no face has a side that is seen.
            outline: None,
            ..wrong
        });
        // Open now, so that its inside shows, as if clipping had cut it open.
        let two_sided = object.two_sided || mesh.closed;
        let right = Object { two_sided, ..with_triangles(object, &right, edges, outlined) };
        (right, wrong)
    }

    fn line(&self, line: &Line, result: &mut DividedFirst) {
        let clip: Vec<ClipPoint> = line.points.iter().map(|&p| self.clip(p)).collect();
        if !clip.iter().any(|p| p.w < 0.0) {
            result.right.lines.push(line.clone());
            return;
        }
        for (ends, points) in clip.windows(2).zip(line.points.windows(2)) {
            let (lines, points) = if ends.iter().any(|p| p.w < 0.0) {
                (&mut result.wrong.lines, self.inside(ends).iter().map(|corner| corner.shown).collect())
            } else {
                (&mut result.right.lines, points.to_vec())
            };
            if !points.is_empty() {
                lines.push(Line { points, ..line.clone() });
            }
        }
    }
}

/// The part of a convex polygon, or of a segment, where `distance` isn't negative.
fn half(polygon: &[DividedCorner], distance: impl Fn(DVec3) -> f64) -> Vec<DividedCorner> {
    let mut kept = Vec::new();
    let keep = |origin| {
        kept.push(match origin {
            Origin::Corner(i) => polygon[i],
            Origin::Edge(edge) => {
                let (inside, outside) = (&polygon[edge.inside], &polygon[edge.outside]);
                DividedCorner {
                    shown: inside.shown * edge.shares[0] + outside.shown * edge.shares[1],
                    weights: std::array::from_fn(|i| edge.mean(inside.weights[i], outside.weights[i])),
                }
            }
        });
    };
    cut(polygon.len(), |i| distance(polygon[i].shown), keep, |_| {});
    kept
}
