//! One point in every space, from the world to the viewport.

use glam::{DMat4, DVec2, DVec3, DVec4};

use super::basis::{CameraFrame, Pose};
use super::{Camera, ClipSpace, ImageSize, Ndc, Projection, Viewport};
use crate::geometry::double_double::{Dd, Dd3, NOISE};

/// A point on its way from the world to the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stations {
    /// World.
    pub world: DVec3,
    /// VRC.
    pub view: DVec3,
    /// Clip coordinates (X, Y, Z, W).
    pub clip: DVec4,
    /// The coordinates after the division by W; `None` if W = 0.
    pub projected: Option<Projected>,
    /// |X|, |Y|, |Z| ≤ W and W > 0, for `clip` in this convention. (In other conventions Z lies between the depths of F
    /// and B, times W.)
    pub inside: bool,
}

/// A point after the division.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected {
    /// NDC, `[0]` Eq. (5.6); in the convention of the [`ClipSpace`].
    pub ndc: DVec3,
    /// (x_p, y_p) on the plane of the view window, `[0]` Eqs. (5.9) and (5.10).
    pub window: DVec2,
    /// (i, j), whole numbers, `[0]` Eq. (5.22). Outside the image for points outside the window.
    pub pixel: DVec2,
    /// (X, Y, Z), `[0]` Eqs. (5.24) and (5.25); X and Y are whole numbers.
    pub viewport: DVec3,
}

impl Camera {
    /// A world point in every space.
    ///
    /// ```
    /// # use camera_lab_engine::camera::{Camera, ImageSize, Parameters, Viewport};
    /// # use glam::{DVec2, DVec3, DVec4};
    /// let position = DVec3::new(0.0, 0.0, 5.0);
    /// let p = Parameters { position, view_angle: 90.0, near: 1.0, far: 3.0, aspect: 1.0, ..Parameters::default() };
    /// let image = ImageSize { width: 100, height: 100 };
    /// let s = Camera::new(&p)?.stations(DVec3::new(1.0, -1.0, 3.0), image, &Viewport::whole(image));
    /// assert_eq!(s.view, DVec3::new(1.0, -1.0, -2.0));
    /// assert_eq!(s.clip, DVec4::new(1.0, -1.0, 1.0, 2.0));
    /// let projected = s.projected.expect("W is not 0");
    /// assert_eq!(projected.ndc, DVec3::new(0.5, -0.5, 0.5)); // (5.6)
    /// assert_eq!(projected.window, DVec2::new(0.5, -0.5)); // (5.9), (5.10)
    /// assert_eq!(projected.pixel, DVec2::new(75.0, 75.0)); // (5.22): j grows downwards
    /// assert_eq!(projected.viewport, DVec3::new(75.0, 25.0, 0.75)); // (5.24), (5.25): Y grows upwards
    /// # Ok::<(), camera_lab_engine::camera::CameraError>(())
    /// ```
    ///
    /// *Guarantees*: computed in double-double and rounded at the end. W = 0 is recognised: (p − C) · **n** is an exact
    /// sum of products, in which anything below 2⁻⁹⁶ of the summands counts as zero; relative to the distance of p and
    /// C, so does the error that rounding their coordinates to `f64`s can cause for a point in the plane of the eye.
    /// z_c keeps its digits. Floors are those of the exact numbers: a number that differs from a whole number by no
    /// more than the noise of 106 bits is that number.
    pub fn stations(&self, p_world: DVec3, image: ImageSize, viewport: &Viewport) -> Stations {
        self.notes_clip_space().stations(p_world, image, viewport)
    }

    /// (x_n, y_n) of a point of an object with this model matrix, computed in double-double and rounded at the end.
    /// `None` if it isn't before the eye.
    pub(crate) fn exact_ndc(&self, world_from_object: &DMat4, p_object: DVec3) -> Option<DVec2> {
        let column = |k: usize, factor: f64| Dd3::from(world_from_object.col(k).truncate()) * Dd::new(factor);
        let world = column(0, p_object.x) + column(1, p_object.y) + column(2, p_object.z) + column(3, 1.0);
        let (aside, ahead) = (world - self.sideways_origin(world.value()), world - self.pose.position);
        let CameraFrame { u, v, n, .. } = &self.frame;
        let [x, y, _, w] = self.lens.clip(self.projection(), Dd3::new(u.dot(aside), v.dot(aside), n.dot(ahead)));
        (w.value() > 0.0).then(|| DVec2::new((x / w).value(), (y / w).value()))
    }

    /// The rest of C after rounding. If C is the result of operations, it's [`position`](Self::position) and this.
    pub(crate) fn position_rest(&self) -> DVec3 {
        self.pose.position_rest()
    }

    /// True for a point whose depth (p − C) · **n** is less than half a unit in the last place of each coordinate of p
    /// and C can make it, and nothing beside the distance of the two: of a point so near to C that all of p − C is such
    /// a rest, nothing is known.
    fn is_beside_the_eye(&self, p_world: DVec3, view: Dd3) -> bool {
        const NOTHING: f64 = 1.0 / (1u64 << 30) as f64;
        let half_ulp = |x: f64| (x.abs().next_up() - x.abs()) / 2.0;
        let coordinates = p_world.to_array().into_iter().zip(self.position().to_array());
        let rounded = coordinates.map(|(p, c)| half_ulp(p) + half_ulp(c));
        let slack: f64 = rounded.zip(self.basis().n.abs().to_array()).map(|(rounded, n)| rounded * n).sum();
        let view = view.value().abs();
        view.z < slack && view.z <= NOTHING * view.x.max(view.y)
    }

    /// The point from which x_c and y_c of `p_world` are measured: C, or PF if C is so much farther away that even
    /// double-double would keep too little of p − C. Both give the same, since **u** and **v** are perpendicular to C −
    /// PF.
    pub(super) fn sideways_origin(&self, p_world: DVec3) -> Dd3 {
        /// Up to here a difference of 106 bits has more than 30 bits to spare.
        const MUCH_FARTHER: f64 = (1u64 << 20) as f64;
        let Pose { position, focal_point, .. } = self.pose;
        let far = |from: Dd3| (p_world - from.value()).abs().max_element();
        if far(position) > MUCH_FARTHER * far(focal_point) { focal_point } else { position }
    }

    /// A world point in the VRC, and its possible noise, sideways and along **n**: from the differences after rounding
    /// C (or PF), and from the products.
    fn exact_view_point(&self, p_world: DVec3) -> (Dd3, [f64; 2]) {
        let CameraFrame { u, v, n, .. } = &self.frame;
        let [(aside, made_of_aside), (ahead, made_of_ahead)] =
            [self.sideways_origin(p_world), self.pose.position].map(|origin| difference(p_world, origin));
        let clean = |axis: &Dd3, x: Dd, made_of: DVec3| x.without_noise(axis.value().abs().dot(made_of));
        let view = Dd3::new(
            clean(u, u.dot(aside), made_of_aside),
            clean(v, v.dot(aside), made_of_aside),
            clean(n, self.frame.along_normal(ahead), made_of_ahead),
        );
        let noise = |d: Dd3, made_of: DVec3| (d.value().abs() + made_of).element_sum() * NOISE;
        (view, [noise(aside, made_of_aside), noise(ahead, made_of_ahead)])
    }
}

/// p − `origin`, and the size of its terms in each coordinate in which `origin` is the inexact result of operations.
fn difference(p_world: DVec3, origin: Dd3) -> (Dd3, DVec3) {
    let is_rounded = origin.to_array().map(|x| x.parts()[1] != 0.0);
    let sizes = (p_world.abs() + origin.value().abs()).to_array();
    let made_of = DVec3::from_array(std::array::from_fn(|i| if is_rounded[i] { sizes[i] } else { 0.0 }));
    (Dd3::from(p_world) - origin, made_of)
}

impl ClipSpace<'_> {
    /// A world point in every space. Clip coordinates, NDC and `inside` are those of the convention. The others don't
    /// depend on it.
    ///
    /// *Guarantees*: those of [`Camera::stations`].
    pub fn stations(&self, p_world: DVec3, image: ImageSize, viewport: &Viewport) -> Stations {
        let camera = self.camera();
        let (view, [aside, ahead]) = camera.exact_view_point(p_world);
        let mut clip = self.lens.clip(camera.projection(), view);
        if camera.projection() == Projection::Perspective && camera.is_beside_the_eye(p_world, view) {
            clip[3] = Dd::ZERO;
        }
        let [x, y, z, w] = clip;
        let projected = (w.value() != 0.0).then(|| {
            let ndc = [x / w, y / w, z / w];
            // Window and viewport are those of (5.24) and (5.25), whatever lies between.
            let notes = if self.ndc() == Ndc::default() {
                ndc
            } else {
                let [x, y, z, _] = camera.lens.clip(camera.projection(), view);
                [x / w, y / w, z / w]
            };
            let (window, noise) = match camera.projection() {
                Projection::Perspective => {
                    let near = Dd::new(camera.near());
                    let window = [near * (view.x / w), near * (view.y / w)];
                    let farthest = window[0].value().abs().max(window[1].value().abs());
                    (window, (aside * camera.near() + ahead * farthest) / w.value().abs())
                }
                Projection::Parallel => ([view.x, view.y], aside),
            };
            let noise = [noise / camera.window_width(), noise / camera.window_height()];
            Projected {
                ndc: DVec3::from_array(ndc.map(Dd::value)),
                window: DVec2::from_array(window.map(Dd::value)),
                pixel: DVec2::from_array(camera.pixel_of_window(image, window, noise)),
                viewport: DVec3::from_array(viewport.of_ndc(notes, noise)),
            }
        });
        let clip = DVec4::from_array(clip.map(Dd::value));
        Stations { world: p_world, view: view.value(), clip, projected, inside: self.is_inside(clip) }
    }
}
