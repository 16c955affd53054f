//! Detection of vertices that rounding misplaces in the picture, by the code that draws them.
//!
//! Up to the viewport the pipeline computes in `f64`, behind it in single precision on a grid of subpixels. That's
//! enough for nearly all cameras, and [`Misplaced::bound`] proves it for an object without looking at a vertex. It
//! isn't enough if a picture magnifies more than its coordinates have digits, or if the window is far off-axis. Then
//! each vertex is compared with its place in double-double.

use rayon::prelude::*;

use crate::appearance::VertexFormat;
use crate::camera::Camera;
use crate::pipeline::budget::MisplacedVertex;
use crate::pipeline::space::depths::InView;
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{NOT_A_NUMBER, ObjectPoint, Screen, outcode};
use crate::pipeline::stage::vertex::{clip_from_view, divide, snap, view_point, viewport};
use crate::pipeline::stage::vertices::Vertices;
use crate::scene::{Object, Scene};

/// Tolerance in pixels. A quarter can't be seen.
const ALLOWED: f64 = 0.25;

/// Looks for vertices that aren't drawn at their places.
pub(crate) struct Misplaced<'a> {
    camera: &'a Camera,
    screen: &'a Screen,
    /// The misplaced vertices of all objects in view.
    in_view: InView,
    found: Vec<MisplacedVertex>,
    /// No vertex so far is drawn farther than this from its place, pixels.
    within: f64,
}

impl<'a> Misplaced<'a> {
    pub(crate) fn new(camera: &'a Camera, screen: &'a Screen, in_view: InView) -> Self {
        Self { camera, screen, in_view, found: Vec::new(), within: 0.0 }
    }

    /// Looks at an object as it was drawn.
    pub(crate) fn look_at(&mut self, object: &Object, vertices: &Vertices) {
        let Vertices { projector, view_from_object, .. } = *vertices;
        let summands = self.in_view.magnitude + view_from_object.rest;
        if projector.format != VertexFormat::F64 {
            // In other formats they're misplaced on purpose.
            self.within = f64::INFINITY;
            return;
        }
        let bound = self.bound(projector, summands, self.in_view.nearest);
        if within(bound) {
            self.within = self.within.max(bound);
            return;
        }
        let off = |(i, &p): (usize, &glam::DVec3)| {
            let clip = clip_from_view(projector, view_point(view_from_object, ObjectPoint(p)));
            let summands = view_from_object.magnitude(p) + view_from_object.rest;
            // A vertex that isn't drawn has no place.
            if outcode(projector, clip) != 0 {
                return None;
            }
            let bound = self.bound(projector, summands, clip.w);
            let exact = if within(bound) { None } else { self.camera.exact_ndc(&object.world_from_object, p) };
            let off = exact.map(|exact| {
                let [x, y, _] = snap(self.screen, viewport(self.screen, divide(&projector.depths, clip)));
                self.screen.pixels(exact).distance(glam::DVec2::new(x.into(), y.into()))
            });
            Some((bound, off.filter(|off| !within(*off)), i))
        };
        let drawn: Vec<(f64, Option<f64>, usize)> = vertices.positions.par_iter().enumerate().filter_map(off).collect();
        // Of a bound that isn't a number nothing is known.
        let bounds = drawn.iter().map(|(bound, ..)| if bound.is_nan() { f64::INFINITY } else { *bound });
        self.within = bounds.fold(self.within, f64::max);
        let misplaced = drawn.into_iter().filter_map(|(_, off, i)| Some((off?, i)));
        // The first of several.
        let farthest = misplaced.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        if let Some((off, vertex)) = farthest {
            self.found.push(MisplacedVertex { object: object.name.clone(), vertex, off });
        }
    }

    /// Greatest distance, in pixels, of a point from its place, if it's in the volume, its view coordinates are sums of
    /// numbers up to `summands`, and its w is at least `w`.
    ///
    /// A view coordinate has an error e of a few roundings of its summands, and of the rest of C after rounding. So x_n
    /// = (s x_c − shift w)/w has (s + 1 + |shift|) e/w, since |x_n| ≤ 1, and some roundings of 1 + |shift|, once more
    /// times that if the width of the window is a small difference. Half the picture's size makes pixels of it, and
    /// single precision and the grid come on top.
    ///
    /// In units of 2⁻⁵³, of which 16 ε are 32: a view coordinate costs 1 for the difference, 3 for the product with the
    /// matrix, 5.2 for the product of M_v and M_m in it, and 1.7 for rounding **u**, **v**, **n**, which is 11 of its
    /// summands. If C was taken to the object's space, the inverse costs 2 for its cofactors, 1.3 for its determinant
    /// and 6 for the product, times the condition squared. The coefficients of M_p and x_n cost 3 and 4 with the
    /// division, the viewport 4.
    fn bound(&self, projector: &Projector, summands: f64, w: f64) -> f64 {
        const ROUNDINGS: f64 = 16.0 * f64::EPSILON;
        let w = if projector.projection.is_perspective() { w } else { 1.0 };
        let error = ROUNDINGS * summands + self.camera.position_rest().length();
        let aside = |axis: usize| 1.0 + projector.shift[axis].abs();
        let by = |axis: usize| (projector.scale[axis] + aside(axis)) * (error / w) + ROUNDINGS * aside(axis).powi(2);
        self.screen.half_size().x * by(0) + self.screen.half_size().y * by(1) + self.screen.snap_distance()
    }

    /// No vertex is drawn farther than this from its place, pixels. It's proved, not measured.
    pub(crate) fn within(&self) -> f64 {
        self.within
    }

    /// One of each object, the farthest first.
    pub(crate) fn found(mut self) -> Vec<MisplacedVertex> {
        self.found.sort_by(|a, b| b.off.total_cmp(&a.off));
        self.found
    }
}

/// The number of faces that a format leaves out of the image, because a coordinate of a vertex isn't finite in it.
pub fn infinite_faces(scene: &Scene, camera: &Camera, format: VertexFormat) -> usize {
    let mut projector = Projector::new(camera);
    projector.format = format;
    let projector = &projector;
    let of_object = |object: &Object| {
        let view_from_object = &projector.view_from_object(object.world_from_object);
        let vertices = Vertices { projector, view_from_object, positions: &object.mesh.positions };
        let is_infinite = |i: &u32| outcode(projector, vertices.clip_point(*i)) & NOT_A_NUMBER != 0;
        object.mesh.triangles.iter().filter(|corners| corners.iter().any(is_infinite)).count()
    };
    let is_drawn = |object: &&Object| object.faces && format != VertexFormat::F64;
    scene.objects.iter().filter(is_drawn).map(of_object).sum()
}

/// True if an offset is within the tolerance. False for NaN.
fn within(off: f64) -> bool {
    off <= ALLOWED
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::appearance::Rgba;
    use crate::camera::{Parameters, Projection, ViewWindow};
    use crate::pipeline::Target;
    use glam::{DMat4, DQuat, DVec2, DVec3};
    use proptest::prelude::*;

    /// From 10^from to 10^to, and from minus that.
    fn decades(from: f64, to: f64) -> impl Strategy<Value = f64> {
        (from..to, any::<bool>()).prop_map(|(decade, minus)| 10_f64.powf(decade) * if minus { -1.0 } else { 1.0 })
    }

    fn vector(from: f64, to: f64) -> impl Strategy<Value = DVec3> {
        [decades(from, to), decades(from, to), decades(from, to)].prop_map(DVec3::from_array)
    }

    /// A camera anywhere, near to its focal point or not, with a window of any width, also far off-axis.
    fn camera() -> impl Strategy<Value = Camera> {
        let window = (decades(-16.0, 2.0), decades(-3.0, 8.0), any::<bool>());
        let ends = (vector(-2.0, 12.0), vector(-4.0, 6.0));
        (ends, window, decades(-9.0, 0.0), any::<bool>()).prop_filter_map(
            "a camera",
            |(ends, window, near, parallel)| {
                let (position, way) = ends;
                let (width, aside, centred) = window;
                let distance = way.length();
                let (near, width) = (near.abs() * distance, width.abs() * distance);
                let left = if centred { -0.5 * width } else { aside * width };
                let parameters = Parameters {
                    position,
                    focal_point: position + way,
                    near,
                    far: 2.0 * distance,
                    projection: if parallel { Projection::Parallel } else { Projection::Perspective },
                    window: Some(ViewWindow { left, right: left + width, bottom: -0.5 * width, top: 0.5 * width }),
                    ..Parameters::default()
                };
                Camera::new(&parameters).ok()
            },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn no_vertex_is_farther_beside_its_place_than_the_bound(
            camera in camera(),
            axis in vector(-1.0, 0.0),
            (angle, scale, origin) in (0.0..6.0_f64, vector(-2.0, 2.0), vector(-3.0, 12.0)),
            at in [-1.0..1.0_f64, -1.0..1.0, 0.0..1.0],
        ) {
            let world_from_object =
                DMat4::from_scale_rotation_translation(scale, DQuat::from_axis_angle(axis.normalize(), angle), origin);
            let projector = Projector::new(&camera);
            let view_from_object = projector.view_from_object(world_from_object);
            let target = Target { width: 640, height: 480, scale: 1.0, background: Rgba::rgb(0, 0, 0) };
            let screen = Screen::new(target);
            // A point of the volume, and then the vertex that is nearest to it.
            let depth = camera.near() + at[2] * (camera.far() - camera.near());
            let (window, to) = (camera.window(), if projector.projection.is_perspective() { depth / camera.near() } else { 1.0 });
            let across = |t: f64, least: f64, most: f64| to * (least + (most - least) * (0.5 + 0.5 * t));
            let p_view = DVec3::new(across(at[0], window.left, window.right), across(at[1], window.bottom, window.top), -depth);
            let p = world_from_object.inverse().transform_point3(camera.world_from_view().transform_point3(p_view));
            let clip = clip_from_view(&projector, view_point(&view_from_object, ObjectPoint(p)));
            let misplaced = Misplaced::new(&camera, &screen, InView::NOTHING);
            let bound = misplaced.bound(&projector, view_from_object.magnitude(p) + view_from_object.rest, clip.w);
            if outcode(&projector, clip) == 0 && let Some(exact) = camera.exact_ndc(&world_from_object, p) {
                let [x, y, _] = snap(&screen, viewport(&screen, divide(&projector.depths, clip)));
                let off = screen.pixels(exact).distance(DVec2::new(x.into(), y.into()));
                prop_assert!(off <= bound, "{off} > {bound}");
            }
        }
    }

    #[test]
    fn of_ordinary_cameras_it_is_known_without_looking() {
        let camera = Camera::new(&Parameters::default()).unwrap();
        let screen = Screen::new(Target { width: 1920, height: 1080, scale: 1.0, background: Rgba::rgb(0, 0, 0) });
        let misplaced = Misplaced::new(&camera, &screen, InView::NOTHING);
        let bound = misplaced.bound(&Projector::new(&camera), 1e3, camera.near());
        assert!(bound < 0.01, "{bound}");
    }
}
