//! The effects of w: points side by side in (x_r, w_r), the image of the middle of a segment, and a chequered floor
//! interpolated with and without it.
//!
//! `[2]` and `[4]`; J. F. Blinn, *Hyperbolic interpolation*, IEEE CG&A 12(4), 1992.

use glam::{DVec2, DVec3};

use crate::camera::Camera;

/// The position, along the image of a segment, of the point at `share` along the segment itself:
/// `t w_B / ((1 − t) w_A + t w_B)`.
///
/// ```
/// use camera_lab_figures::explain::homogeneous::projected_share;
/// // B is three times as far from the eye: the middle is seen three quarters along.
/// assert_eq!(projected_share(0.5, 1.0, 3.0), 0.75);
/// assert_eq!(projected_share(0.5, 2.0, 2.0), 0.5);
/// ```
pub fn projected_share(share: f64, w_a: f64, w_b: f64) -> f64 {
    share * w_b / ((1.0 - share) * w_a + share * w_b)
}

/// Squares along a side of the floor.
pub const SQUARES: f64 = 8.0;

/// A square around PF, at right angles to VUP if possible, that lies entirely in front of the eye.
#[derive(Clone, Debug)]
pub struct Floor {
    /// Corners in the world, around it.
    pub corners: [DVec3; 4],
    /// (x_p, y_p) of the corners.
    window: [DVec2; 4],
    /// w_r of the corners.
    w: [f64; 4],
}

impl Floor {
    /// The floor of a camera.
    pub fn new(camera: &Camera) -> Self {
        let basis = camera.basis();
        let up = camera.view_up().normalize_or(basis.v);
        let right = basis.u;
        let ahead = up.cross(right).normalize_or(basis.v);
        // Half a diagonal of it is shorter than D.
        let half = 0.48 * camera.distance();
        let corner = |a: f64, b: f64| camera.focal_point() + (right * a + ahead * b) * half;
        let corners = [corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)];
        let clip = corners.map(|p| camera.clip_point(p));
        let size = DVec2::new(camera.window_width(), camera.window_height());
        let sides = camera.window();
        let low = DVec2::new(sides.left, sides.bottom);
        let window = clip.map(|c| low + (c.truncate().truncate() / c.w + 1.0) / 2.0 * size);
        Self { corners, window, w: clip.map(|c| c.w) }
    }

    /// The floor at a window point: the colour of a square, or `None` beside the floor. `with_w` interpolates as
    /// rasterizers do, u/w, v/w and 1/w. Without it, only u and v are interpolated, which is wrong if w differs.
    pub fn is_dark(&self, point: DVec2, with_w: bool) -> Option<bool> {
        const UV: [DVec2; 4] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let inside = |[a, b, c]: [usize; 3]| {
            let [p, q, r] = [a, b, c].map(|i| self.window[i]);
            let area = (q - p).perp_dot(r - p);
            let weights =
                [(q - point).perp_dot(r - point), (r - point).perp_dot(p - point), (p - point).perp_dot(q - point)]
                    .map(|weight| weight / area);
            (weights.iter().all(|weight| *weight >= 0.0)).then_some(([a, b, c], weights))
        };
        let (corners, weights) = inside([0, 1, 2]).or_else(|| inside([0, 2, 3]))?;
        let over_w = |i: usize| if with_w { 1.0 / self.w[i] } else { 1.0 };
        let sum: f64 = corners.iter().zip(weights).map(|(i, weight)| weight * over_w(*i)).sum();
        let uv: DVec2 = corners.iter().zip(weights).map(|(i, weight)| UV[*i] * (weight * over_w(*i))).sum();
        let square = (uv / sum * SQUARES).floor();
        square.is_finite().then(|| (square.x + square.y).rem_euclid(2.0) != 0.0)
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::{Parameters, Projection};

    /// The floor by casting a ray onto its plane, without any interpolation.
    fn cast(camera: &Camera, floor: &Floor, point: DVec2) -> Option<bool> {
        let [a, b, _, d] = floor.corners;
        let (across, along) = (b - a, d - a);
        let normal = across.cross(along);
        let ray = camera.ray_through_window(point);
        let t = (a - ray.origin).dot(normal) / ray.direction.dot(normal);
        let p = ray.origin + ray.direction * t - a;
        let uv = DVec2::new(p.dot(across) / across.length_squared(), p.dot(along) / along.length_squared());
        let inside = t > 0.0 && uv.cmpge(DVec2::ZERO).all() && uv.cmple(DVec2::ONE).all();
        let square = (uv * SQUARES).floor();
        inside.then(|| (square.x + square.y).rem_euclid(2.0) != 0.0)
    }

    #[test]
    fn only_with_w_the_floor_agrees_with_rays() {
        for projection in [Projection::Perspective, Projection::Parallel] {
            let camera =
                Camera::new(&Parameters { projection, view_angle: 70.0, height: 8.0, ..Parameters::default() })
                    .unwrap();
            let floor = Floor::new(&camera);
            let window = camera.window();
            let (mut seen, mut with, mut without) = (0, 0, 0);
            for i in 0..100 {
                for j in 0..100 {
                    let share = DVec2::new(f64::from(i) + 0.5, f64::from(j) + 0.5) / 100.0;
                    let point =
                        DVec2::new(window.left, window.bottom) + share * DVec2::new(window.width(), window.height());
                    let Some(truth) = cast(&camera, &floor, point) else { continue };
                    seen += 1;
                    with += usize::from(floor.is_dark(point, true) != Some(truth));
                    without += usize::from(floor.is_dark(point, false) != Some(truth));
                }
            }
            assert!(seen > 1000 && with * 200 < seen, "{with} of {seen} wrong with w");
            if projection == Projection::Perspective {
                assert!(without * 5 > seen, "only {without} of {seen} wrong without w");
            } else {
                assert!(without * 200 < seen, "in parallel projection w is 1");
            }
        }
    }

    #[test]
    fn the_middle_of_a_segment_is_seen_at_the_computed_share() {
        let camera = Camera::new(&Parameters::default()).unwrap();
        let (a, b) = (DVec3::new(1.0, 0.0, 1.0), DVec3::new(-2.0, 0.5, -3.0));
        let place = |p: DVec3| {
            let clip = camera.clip_point(p);
            (clip.truncate().truncate() / clip.w, clip.w)
        };
        let ((from, w_a), (to, w_b)) = (place(a), place(b));
        for share in [0.1, 0.5, 0.9] {
            let (seen, _) = place(a.lerp(b, share));
            assert!(seen.distance(from.lerp(to, projected_share(share, w_a, w_b))) < 1e-12);
        }
    }
}
