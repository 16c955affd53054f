//! The matrices of `[0]` §5.3: view (5.7), projection (5.13) to (5.16), their product and their inverses, in closed
//! form.
//!
//! Everything is computed in double-double and rounded once, so that an entry is the `f64` nearest to the exact value
//! (but for ties too close to call), however large far/near, C or the lack of symmetry.

use glam::{DMat4, DVec3, DVec4};

use crate::camera::basis::CameraFrame;
use crate::camera::window::WideWindow;
use crate::camera::{Camera, Ndc, Projection};
use crate::geometry::double_double::{Dd, Dd3};

/// The entries of M_p that are neither 0 nor ±1. With (X, Y, Z, W) = M_p (x, y, z, 1):
/// perspective: X = `x` x + `skew_x` z, Y = `y` y + `skew_y` z, Z = `z` z + `depth`, W = −z;
/// parallel: X = `x` x + `skew_x`, Y = `y` y + `skew_y`, Z = `z` z + `depth`, W = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lens {
    pub(crate) x: Dd,
    pub(crate) y: Dd,
    pub(crate) skew_x: Dd,
    pub(crate) skew_y: Dd,
    pub(crate) z: Dd,
    pub(crate) depth: Dd,
}

impl Camera {
    /// M_v, `[0]` Eq. (5.7).
    ///
    /// *Guarantees*: −**u** · **c** and its neighbours are rounded once, from unrounded **u**, **v**, **n**, so
    /// cancellation costs no digits, and a zero is a zero.
    ///
    /// ```
    /// # use camera_lab_engine::camera::{Camera, Parameters};
    /// # use glam::{DVec3, DVec4};
    /// let camera = Camera::new(&Parameters { position: DVec3::new(3.0, 4.0, 0.0), ..Parameters::default() })?;
    /// assert_eq!(camera.view_from_world().row(2), DVec4::new(0.6, 0.8, 0.0, -5.0));
    /// # Ok::<(), camera_lab_engine::camera::CameraError>(())
    /// ```
    pub fn view_from_world(&self) -> DMat4 {
        let [u, v, n] = self.view_rows().map(rounded);
        from_rows([u, v, n, DVec4::W])
    }

    /// The inverse of M_v: its columns are **u**, **v**, **n** and C.
    pub fn world_from_view(&self) -> DMat4 {
        let basis = self.basis();
        DMat4::from_cols(basis.u.extend(0.0), basis.v.extend(0.0), basis.n.extend(0.0), self.position().extend(1.0))
    }

    /// M_p, `[0]` Eqs. (5.13) to (5.16). The notes print 0 0 0 0 as the last row of (5.15)
    /// and (5.16), which is 0 0 0 1, and 2n/(r − l) for 2F/(r − l) in (5.11).
    ///
    /// ```
    /// # use camera_lab_engine::camera::{Camera, Parameters, ViewWindow};
    /// # use glam::DVec4;
    /// let window = Some(ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 });
    /// let camera = Camera::new(&Parameters { window, near: 2.0, far: 6.0, ..Parameters::default() })?;
    /// let m = camera.clip_from_view();
    /// assert_eq!(m.row(0), DVec4::new(1.0, 0.0, 0.5, 0.0)); // 2F/(r−l)  0  (r+l)/(r−l)  0
    /// assert_eq!(m.row(2), DVec4::new(0.0, 0.0, -2.0, -6.0)); // 0  0  −(B+F)/(B−F)  −2BF/(B−F)
    /// # Ok::<(), camera_lab_engine::camera::CameraError>(())
    /// ```
    pub fn clip_from_view(&self) -> DMat4 {
        self.notes_clip_space().clip_from_view()
    }

    /// The inverse of M_p, in closed form.
    pub fn view_from_clip(&self) -> DMat4 {
        self.notes_clip_space().view_from_clip()
    }

    /// M_p M_v, composed in double-double, not from the rounded factors.
    pub fn clip_from_world(&self) -> DMat4 {
        self.notes_clip_space().clip_from_world()
    }

    /// A world point in the VRC. C is subtracted before anything is rotated.
    ///
    /// *Guarantees*: an error of a few ε ‖p − C‖, however far the world lies from the origin. In plain `f64`, for the
    /// pipeline; [`Camera::stations`] gives every digit.
    pub fn view_point(&self, p_world: DVec3) -> DVec3 {
        let d = p_world - self.position() - self.pose.position_rest();
        let basis = self.basis();
        DVec3::new(basis.u.dot(d), basis.v.dot(d), basis.n.dot(d))
    }

    /// A world point in clip coordinates, in plain `f64`. See [`Camera::view_point`].
    pub fn clip_point(&self, p_world: DVec3) -> DVec4 {
        self.clip_from_view() * self.view_point(p_world).extend(1.0)
    }

    /// The first three rows of M_v in double-double.
    pub(crate) fn view_rows(&self) -> [[Dd; 4]; 3] {
        let aside = self.sideways_origin(DVec3::ZERO);
        let CameraFrame { u, v, n, .. } = self.frame;
        [(u, aside), (v, aside), (n, self.pose.position)].map(|(axis, c)| [axis.x, axis.y, axis.z, -axis.dot(c)])
    }
}

impl Lens {
    /// A point of the VRC in clip coordinates, in double-double.
    pub(crate) fn clip(&self, projection: Projection, p: Dd3) -> [Dd; 4] {
        let Self { x, y, skew_x, skew_y, z, depth } = *self;
        match projection {
            Projection::Perspective => {
                [(x * p.x).plus(skew_x * p.z), (y * p.y).plus(skew_y * p.z), (z * p.z).plus(depth), -p.z]
            }
            Projection::Parallel => [(x * p.x).plus(skew_x), (y * p.y).plus(skew_y), (z * p.z).plus(depth), Dd::ONE],
        }
    }
}

/// The entries of M_p in a convention of NDC: those of `[0]` for −1 … 1 and y up.
///
/// From z_n = (z z_c + d) / w at F and at B, where z_n is z₀ and z₁: z = (z₀ F − z₁ B)/(B − F) and d = (z₀ − z₁) B F/(B
/// − F) in perspective, z = (z₀ − z₁)/(B − F) and d = (z₀ B − z₁ F)/(B − F) in parallel projection. With B → ∞ in
/// perspective, z → −z₁ and d → (z₀ − z₁) F.
///
/// Differences are exact sums, quotients come before products: (B + F)/(B − F) and 2BF/(B − F) overflow only if they
/// aren't `f64`s themselves.
pub(crate) fn lens(projection: Projection, window: &WideWindow, near: f64, far: f64, ndc: Ndc) -> Lens {
    let (width, height) = (window.width(), window.height());
    let (sum_x, sum_y) = (window.right + window.left, window.top + window.bottom);
    // Half of far and near, so their sum and difference can't overflow, and the quotients stay the same.
    let half = |x: f64| Dd::new(x).scaled(-1);
    let difference = half(far) - half(near);
    let two = |x: Dd| x.scaled(1);
    let up = |y: Dd| if ndc.y_points_down() { -y } else { y };
    let [at_near, at_far] = ndc.depths().map(Dd::new);
    // (z₀ − z₁)/2: −1, −1/2 or 1/2.
    let half_range = (at_near - at_far).scaled(-1);
    match projection {
        Projection::Perspective => {
            let far_over_difference = Dd::new(far) / difference;
            let near_wide = Dd::new(near);
            let (z, depth) = if ndc.infinite {
                (-at_far, two(near_wide) * half_range)
            } else {
                let z = (at_near * half(near) - at_far * half(far)) / difference;
                (z, near_wide * far_over_difference * half_range)
            };
            Lens {
                x: two(near_wide / width),
                y: up(two(near_wide / height)),
                skew_x: sum_x / width,
                skew_y: up(sum_y / height),
                z,
                depth,
            }
        }
        Projection::Parallel => Lens {
            x: two(Dd::ONE / width),
            y: up(two(Dd::ONE / height)),
            skew_x: -(sum_x / width),
            skew_y: up(-(sum_y / height)),
            z: half_range / difference,
            depth: (at_near * half(far) - at_far * half(near)) / difference,
        },
    }
}

pub(crate) fn rounded(row: [Dd; 4]) -> DVec4 {
    DVec4::from_array(row.map(Dd::value))
}

pub(crate) fn from_rows(rows: [DVec4; 4]) -> DMat4 {
    DMat4::from_cols_array_2d(&rows.map(|row| row.to_array())).transpose()
}
