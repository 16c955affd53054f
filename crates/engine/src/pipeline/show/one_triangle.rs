//! One triangle step by step, as every triangle goes: its corners in each space, the side of each plane on which they
//! lie, the cut of each plane, and the rest on the image.
//!
//! No picture needs this. It shows the steps. The numbers are those of the functions that draw.

use glam::{DVec2, DVec3};

use crate::camera::Camera;
use crate::pipeline::Target;
use crate::pipeline::mesh::cut::Origin;
use crate::pipeline::mesh::resample::VertexOrigin;
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{NOT_A_NUMBER, ObjectPoint, PLANES, Screen, distances, outcode};
use crate::pipeline::stage::clip::Clipper;
use crate::pipeline::stage::cull_faces::facing;
use crate::pipeline::stage::vertex::{clip_from_view, divide, snap, view_point, viewport};
use crate::scene::Object;

/// A triangle on its way.
#[derive(Clone, Debug, PartialEq)]
pub struct TriangleSteps {
    /// Its corners, named a, b, c.
    pub corners: [CornerSteps; 3],
    /// The normal times the way to the eye, in view space: positive if it's seen from its front.
    pub facing: f64,
    /// All corners are outside one plane, or one isn't a number. Nothing of it is left.
    pub is_outside: bool,
    /// The planes that it crosses, in the order in which they cut.
    pub cuts: Vec<PlaneCut>,
    /// The corners of the rest, in order. None if nothing remains.
    pub left: Vec<CornerLeft>,
}

/// A corner before clipping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CornerSteps {
    /// Object.
    pub local: DVec3,
    /// World.
    pub world: DVec3,
    /// View.
    pub view: DVec3,
    /// x and y of the clip space.
    pub clip: DVec2,
    /// w of the clip space.
    pub w: f64,
    /// Homogeneous distances from left, right, bottom, top, near, far, positive inside: w + x, w − x, w + y, w − y, d −
    /// F, B − d.
    pub distances: [f64; PLANES],
    /// The bits of the outcode, one for each plane that it's outside of.
    pub outside: [bool; PLANES],
}

/// The cut of a plane.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneCut {
    /// Left, right, bottom, top, near, far: 0 … 5.
    pub plane: usize,
    /// The corners that it makes.
    pub made: Vec<Cut>,
    /// The names of the corners that are left after it, in order.
    pub left: String,
}

/// A corner that a plane makes: inside + t (outside − inside).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// The letter of the new vertex.
    pub name: char,
    /// The name of the end inside.
    pub inside: char,
    /// The name of the end outside.
    pub outside: char,
    /// The distances of the two ends from the plane: d₁ of the end inside, positive, and −d₂ of the end outside.
    pub distances: [f64; 2],
    /// d₁ / (d₁ + d₂)
    pub t: f64,
}

/// A corner of the rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CornerLeft {
    /// The letter of the vertex, an old or a new one.
    pub name: char,
    /// World.
    pub world: DVec3,
    /// x and y of the clip space.
    pub clip: DVec2,
    /// w of the clip space.
    pub w: f64,
    /// x_n and y_n.
    pub ndc: DVec2,
    /// On the image, pixels (y down), on the grid of 1/256 pixel.
    pub image: [f32; 2],
}

/// Takes a triangle of an object through the steps. `target` is the image. `None` if there is no such triangle.
pub fn one_triangle(object: &Object, triangle: usize, camera: &Camera, target: Target) -> Option<TriangleSteps> {
    let (projector, screen) = (Projector::new(camera), Screen::new(target));
    let view_from_object = projector.view_from_object(object.world_from_object);
    let indices = *object.mesh.triangles.get(triangle)?;
    let [a, b, c] = indices.map(|i| object.mesh.positions.get(i as usize).copied());
    let local = [a?, b?, c?];
    let view = local.map(|p| view_point(&view_from_object, ObjectPoint(p)));
    let clip = view.map(|p| clip_from_view(&projector, p));
    let codes = clip.map(|p| outcode(&projector, p));
    let corners = std::array::from_fn(|i| CornerSteps {
        local: local[i],
        world: object.world_from_object.transform_point3(local[i]),
        view: view[i].0,
        clip: DVec2::new(clip[i].x, clip[i].y),
        w: clip[i].w,
        distances: distances(&projector, clip[i]),
        outside: std::array::from_fn(|plane| codes[i] >> plane & 1 == 1),
    });
    let any = codes.iter().fold(0, |any, code| any | code);
    let is_outside = codes[0] & codes[1] & codes[2] != 0 || any & NOT_A_NUMBER != 0;
    let (mut cuts, mut left) = (Vec::new(), Vec::new());
    if !is_outside {
        let mut origins = Vec::new();
        let mut clipper = Clipper::default();
        let polygon = clipper.watched(&projector, &clip, any, |plane, polygon, origin| {
            let ends = match origin {
                Origin::Corner(_) => [0.0; 2],
                Origin::Edge(edge) => [edge.inside, edge.outside].map(|i| polygon[i].distances[plane]),
            };
            origins.push((plane, origin, ends));
        });
        let names;
        (cuts, names) = named(&origins);
        let world = |weights: [f64; 3]| {
            object.world_from_object.transform_point3(VertexOrigin::on([0, 1, 2], weights).of(|i| local[i as usize]))
        };
        let reached = polygon.iter().zip(names).map(|(corner, name)| {
            let p = corner.point;
            let [x, y, _] = snap(&screen, viewport(&screen, divide(&projector.depths, p)));
            let clip = DVec2::new(p.x, p.y);
            CornerLeft { name, world: world(corner.weights), clip, w: p.w, ndc: clip / p.w, image: [x, y] }
        });
        left = reached.collect();
    }
    let facing = facing(&projector, view) * view_from_object.outward();
    Some(TriangleSteps { corners, facing, is_outside, cuts, left })
}

/// The cuts, from the corners that each plane leaves, and the names of those that are left in the end.
fn named(origins: &[(usize, Origin, [f64; 2])]) -> (Vec<PlaneCut>, Vec<char>) {
    let mut names = vec!['a', 'b', 'c'];
    let (mut cuts, mut letters) = (Vec::new(), 'd'..='z');
    for of_plane in origins.chunk_by(|one, other| one.0 == other.0) {
        let (mut made, mut left) = (Vec::new(), Vec::new());
        for &(_, origin, distances) in of_plane {
            match origin {
                Origin::Corner(i) => left.extend(names.get(i)),
                Origin::Edge(edge) => {
                    // Six planes make no more than twelve corners.
                    let name = letters.next().unwrap_or('z');
                    let [inside, outside] = [edge.inside, edge.outside].map(|i| names.get(i).copied().unwrap_or('?'));
                    made.push(Cut { name, inside, outside, distances, t: edge.shares[1] });
                    left.push(name);
                }
            }
        }
        if !made.is_empty() || left.len() < 3 {
            cuts.push(PlaneCut { plane: of_plane[0].0, made, left: left.iter().collect() });
        }
        names = left;
    }
    (cuts, names)
}
