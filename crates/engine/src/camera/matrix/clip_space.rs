//! The matrices to clip coordinates, and points in them, in any convention of NDC.

use glam::{DMat4, DVec4};

use crate::camera::matrix::projection::{Lens, from_rows, lens, rounded};
use crate::camera::{Camera, InfiniteParallel, Ndc, Projection};
use crate::geometry::double_double::Dd;

/// The part of a camera that depends on the convention of NDC. Made by [`Camera::clip_space`].
///
/// Each matrix is computed from the parameters in double-double and rounded once. No matrix is made by changing another
/// one after it was rounded.
#[derive(Clone, Copy, Debug)]
pub struct ClipSpace<'a> {
    camera: &'a Camera,
    ndc: Ndc,
    pub(crate) lens: Lens,
}

impl Camera {
    /// The clip space of this camera in a convention.
    ///
    /// *Guarantees*: entries are finite, as those of the notes are: |z|, |d| and their quotients by F are never greater
    /// than there.
    ///
    /// # Errors
    /// [`InfiniteParallel`]: parallel projection without a far plane.
    ///
    /// ```
    /// use camera_lab_engine::camera::{Camera, Ndc, Parameters};
    /// use glam::DVec4;
    ///
    /// let camera = Camera::new(&Parameters { near: 2.0, far: 6.0, ..Parameters::default() })?;
    /// let direct3d = Ndc::ALL.into_iter().find(|ndc| ndc.name() == "direct3d").unwrap_or_default();
    /// let m = camera.clip_space(direct3d)?.clip_from_view();
    /// assert_eq!(m.row(2), DVec4::new(0.0, 0.0, -1.5, -3.0)); // 0  0  −B/(B−F)  −BF/(B−F)
    /// let m = camera.clip_space(Ndc { reversed: true, ..direct3d })?.clip_from_view();
    /// assert_eq!(m.row(2), DVec4::new(0.0, 0.0, 0.5, 3.0)); // 0  0  F/(B−F)  BF/(B−F)
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn clip_space(&self, ndc: Ndc) -> Result<ClipSpace<'_>, InfiniteParallel> {
        if ndc.infinite && self.projection() == Projection::Parallel {
            return Err(InfiniteParallel(ndc));
        }
        let lens = lens(self.projection(), &self.wide_window, self.near(), self.far(), ndc);
        Ok(ClipSpace { camera: self, ndc, lens })
    }

    /// The clip space of this camera in a convention. If that has no matrices without a far plane, then with one.
    pub fn possible_clip_space(&self, ndc: Ndc) -> ClipSpace<'_> {
        self.clip_space(ndc)
            .or_else(|_| self.clip_space(Ndc { infinite: false, ..ndc }))
            .unwrap_or(self.notes_clip_space())
    }

    /// The clip space of the notes, `[0]` §5.3.
    pub fn notes_clip_space(&self) -> ClipSpace<'_> {
        ClipSpace { camera: self, ndc: Ndc::default(), lens: self.lens }
    }
}

impl<'a> ClipSpace<'a> {
    /// The camera whose clip space it is.
    pub fn camera(&self) -> &'a Camera {
        self.camera
    }

    /// The convention.
    pub fn ndc(&self) -> Ndc {
        self.ndc
    }

    /// M_p: in the convention of the notes [`Camera::clip_from_view`].
    pub fn clip_from_view(&self) -> DMat4 {
        let Lens { x, y, skew_x, skew_y, z, depth } = self.lens;
        let [x, y, skew_x, skew_y, z, depth] = [x, y, skew_x, skew_y, z, depth].map(Dd::value);
        from_rows(match self.camera.projection() {
            Projection::Perspective => [
                DVec4::new(x, 0.0, skew_x, 0.0),
                DVec4::new(0.0, y, skew_y, 0.0),
                DVec4::new(0.0, 0.0, z, depth),
                DVec4::new(0.0, 0.0, -1.0, 0.0),
            ],
            Projection::Parallel => [
                DVec4::new(x, 0.0, 0.0, skew_x),
                DVec4::new(0.0, y, 0.0, skew_y),
                DVec4::new(0.0, 0.0, z, depth),
                DVec4::W,
            ],
        })
    }

    /// The inverse of M_p, in closed form.
    pub fn view_from_clip(&self) -> DMat4 {
        let w = &self.camera.wide_window;
        let near = Dd::new(self.camera.near());
        let half = |x: Dd| x.scaled(-1);
        let (half_width, half_height) = (half(w.width()), half(w.height()));
        let half_height = if self.ndc.y_points_down() { -half_height } else { half_height };
        let (middle_x, middle_y) = (half(w.left + w.right), half(w.bottom + w.top));
        let [z, one] = self.depth_row_inverted().map(Dd::value);
        from_rows(match self.camera.projection() {
            Projection::Perspective => {
                let over_near = |x: Dd| (x / near).value();
                [
                    DVec4::new(over_near(half_width), 0.0, 0.0, over_near(middle_x)),
                    DVec4::new(0.0, over_near(half_height), 0.0, over_near(middle_y)),
                    DVec4::new(0.0, 0.0, 0.0, -1.0),
                    DVec4::new(0.0, 0.0, z, one),
                ]
            }
            Projection::Parallel => [
                DVec4::new(half_width.value(), 0.0, 0.0, middle_x.value()),
                DVec4::new(0.0, half_height.value(), 0.0, middle_y.value()),
                DVec4::new(0.0, 0.0, z, one),
                DVec4::W,
            ],
        })
    }

    /// Factors of Z and W for the fourth row of the inverse in perspective, and of Z and 1 for its third in parallel
    /// projection.
    fn depth_row_inverted(&self) -> [Dd; 2] {
        let (near, far) = (Dd::new(self.camera.near()), Dd::new(self.camera.far()));
        let half = |x: Dd| x.scaled(-1);
        let [at_near, at_far] = self.ndc.depths();
        // Over z₀ − z₁, which is 1, −1 or −2: nothing is rounded.
        let over_range = |x: Dd| match at_near - at_far {
            1.0 => x,
            -1.0 => -x,
            _ => -half(x),
        };
        let times = |depth: f64, x: Dd| Dd::new(depth) * x;
        match self.camera.projection() {
            // 1/d and z/d: (B − F)/(B F) and z₀/B − z₁/F, over z₀ − z₁.
            Projection::Perspective if self.ndc.infinite => {
                [over_range(Dd::ONE / near), over_range(-(Dd::new(at_far) / near))]
            }
            Projection::Perspective => {
                let difference = Dd::difference(self.camera.far(), self.camera.near()) / far / near;
                // F/B may underflow. It's left out if nothing is added to it.
                let sum = if at_far == 0.0 {
                    Dd::new(at_near) / far
                } else {
                    (times(at_near, near / far) - Dd::new(at_far)) / near
                };
                [over_range(difference), over_range(sum)]
            }
            // 1/z and −d/z: B − F and z₁ F − z₀ B, over z₀ − z₁.
            Projection::Parallel => {
                let halves = [half(far) - half(near), times(at_far, half(near)) - times(at_near, half(far))];
                halves.map(|x| over_range(x).scaled(1))
            }
        }
    }

    /// M_p M_v, composed in double-double, not from the rounded factors.
    pub fn clip_from_world(&self) -> DMat4 {
        let Lens { x, y, skew_x, skew_y, z, depth } = self.lens;
        let [u, v, n] = self.camera.view_rows();
        let row = |a: Dd, from: [Dd; 4]| from.map(|entry| a * entry);
        let last = |skew: Dd| [Dd::ZERO, Dd::ZERO, Dd::ZERO, skew];
        let (skewed_x, skewed_y, w) = match self.camera.projection() {
            Projection::Perspective => (row(skew_x, n), row(skew_y, n), n.map(|entry| -entry)),
            Projection::Parallel => (last(skew_x), last(skew_y), last(Dd::ONE)),
        };
        from_rows([
            rounded(sum(row(x, u), skewed_x)),
            rounded(sum(row(y, v), skewed_y)),
            rounded(sum(row(z, n), last(depth))),
            rounded(w),
        ])
    }

    /// z_n at this distance from the plane of the eye, −z_c, which isn't 0 in perspective.
    pub fn ndc_depth(&self, distance: f64) -> f64 {
        let distance = Dd::new(distance);
        let clip = self.lens.depth - self.lens.z * distance;
        match self.camera.projection() {
            Projection::Perspective => (clip / distance).value(),
            Projection::Parallel => clip.value(),
        }
    }

    /// True if these clip coordinates are in the volume: |X|, |Y| ≤ W, Z / W between the depths of F and B, and W > 0.
    pub(crate) fn is_inside(&self, clip: DVec4) -> bool {
        let [at_near, at_far] = self.ndc.depths();
        let (least, most) = (at_near.min(at_far) * clip.w, at_near.max(at_far) * clip.w);
        clip.w > 0.0 && clip.x.abs() <= clip.w && clip.y.abs() <= clip.w && (least..=most).contains(&clip.z)
    }
}

fn sum(a: [Dd; 4], b: [Dd; 4]) -> [Dd; 4] {
    std::array::from_fn(|i| a[i].plus(b[i]))
}
