//! One point in every space, from the world to the viewport.

use glam::{DVec2, DVec3, DVec4};

use super::{Camera, ImageSize, Projection, Viewport};
use crate::geometry::double_double::{Dd, Dd3, two_sum};

/// A point on its way from the world to the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stations {
    /// World.
    pub world: DVec3,
    /// VRC.
    pub view: DVec3,
    /// Clip coordinates (X, Y, Z, W).
    pub clip: DVec4,
    /// What follows the division by W; `None` where W = 0.
    pub projected: Option<Projected>,
    /// |X|, |Y|, |Z| ≤ W and W > 0, for `clip` as it stands here.
    pub inside: bool,
}

/// A point after the division.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected {
    /// NDC, `[0]` Eq. (5.6).
    pub ndc: DVec3,
    /// (x_p, y_p) on the plane of the view window, `[0]` Eqs. (5.9) and (5.10).
    pub window: DVec2,
    /// (i, j), whole numbers, `[0]` Eq. (5.22); outside the image for what is outside the window.
    pub pixel: DVec2,
    /// (X, Y, Z), `[0]` Eqs. (5.24) and (5.25); X and Y are whole numbers.
    pub viewport: DVec3,
}

impl Camera {
    /// A world point in every space.
    ///
    /// *Guarantees*: computed in double-double and rounded at the end. W = 0 is recognised exactly, (p − C) · **n** being
    /// an exact sum of products; after operations, whose results are not exact, what lies below 2⁻⁹⁶ of the summands is 0.
    /// Floors are those of the exact numbers: what differs from a whole number by less than 2⁻⁹⁰ is that number.
    #[must_use]
    pub fn stations(&self, p_world: DVec3, image: ImageSize, viewport: &Viewport) -> Stations {
        let view = self.exact_view_point(p_world);
        let clip @ [x, y, z, w] = self.clip_of_view(view);
        let projected = (w.value() != 0.0).then(|| {
            let ndc = [x / w, y / w, z / w];
            let window = match self.projection() {
                Projection::Perspective => {
                    let near = Dd::new(self.near());
                    [near * (view.x / w), near * (view.y / w)]
                }
                Projection::Parallel => [view.x, view.y],
            };
            Projected {
                ndc: DVec3::from_array(ndc.map(Dd::value)),
                window: DVec2::from_array(window.map(Dd::value)),
                pixel: DVec2::from_array(self.pixel_of_window(image, window)),
                viewport: DVec3::from_array(viewport.of_ndc(ndc)),
            }
        });
        let clip = DVec4::from_array(clip.map(Dd::value));
        let inside = clip.w > 0.0 && clip.truncate().abs().max_element() <= clip.w;
        Stations { world: p_world, view: view.value(), clip, projected, inside }
    }

    fn exact_view_point(&self, p_world: DVec3) -> Dd3 {
        let (p, c) = (p_world.to_array(), self.pose.position.to_array());
        let terms: [[f64; 3]; 3] = std::array::from_fn(|i| {
            let [c_hi, c_lo] = c[i].parts();
            let (sum, error) = two_sum(p[i], -c_hi);
            [sum, error, -c_lo]
        });
        let [x, y, z] = terms.map(|[sum, error, rest]| Dd::sum(sum, error) + Dd::new(rest));
        let d = Dd3::new(x, y, z);
        let depth = self.frame.height_above_eye_plane(&terms, !self.pose.is_exact());
        Dd3::new(self.frame.u.dot(d), self.frame.v.dot(d), depth)
    }
}
