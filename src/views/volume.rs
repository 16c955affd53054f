//! The view volume as the world shows it: whole, or, where B is so great that all else would be too small to be read, with its
//! far end drawn nearer and its long edges broken, as draughtsmen break a long shaft.

use glam::DVec3;

use crate::camera::Camera;
use crate::geometry::Aabb;

/// So many times larger than all else the whole volume may make what there is to see; beyond it, the volume is broken.
const MOST_ENLARGED: f64 = 2.5;

/// Where a broken volume ends in the picture, and where its gap is, measured by the depth at which all that there is to see ends.
const END: f64 = 1.22;
const GAP: [f64; 2] = [1.06, 1.105];

/// How far the corners of a wide volume may pull the picture's border, measured by the radius of all else. Of a volume twice as wide as
/// that only the middle is in the picture, and what it holds can be told apart.
const WIDEST: f64 = 26.0;
const MIDDLE: f64 = 4.0;

/// The volume as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct DrawnVolume {
    corners: [DVec3; 8],
    near: f64,
    far: f64,
    /// The distance from C at which the far face is drawn: B, or less where the volume is broken.
    pub(super) end: f64,
    /// From which to which distance the volume is left out.
    pub(super) gap: Option<[f64; 2]>,
}

impl DrawnVolume {
    /// The volume among what else there is to see: the box around it, and the points of it that the volume should hold.
    pub(super) fn of(camera: &Camera, core: &Aabb, points: &[DVec3]) -> Self {
        let (near, far, corners) = (camera.near(), camera.far(), camera.volume_corners());
        let whole = Self { corners, near, far, end: far, gap: None };
        let deepest = points.iter().map(|&p| -camera.view_point(p).z).fold(near, f64::max);
        let enlarged = Aabb::around(corners).map_or(0.0, |volume| volume.union(*core).radius()) / core.radius();
        let (end, gap) = (END * deepest, GAP.map(|share| share * deepest));
        // `!(… > …)`: where there is nothing else to see, the volume is all.
        let fits = !(enlarged > MOST_ENLARGED && core.radius() > 0.0);
        if fits || end > 0.9 * far || !end.is_finite() { whole } else { Self { end, gap: Some(gap), ..whole } }
    }

    /// The corners of the window: (l, b), (r, b), (r, t), (l, t).
    pub(super) fn window(&self) -> [DVec3; 4] {
        let [a, b, c, d, ..] = self.corners;
        [a, b, c, d]
    }

    /// The corners of the far face as it is drawn, in the same order.
    pub(super) fn far_face(&self) -> [DVec3; 4] {
        self.section(self.end)
    }

    /// The corners of the volume's section at a distance from C, in the same order.
    pub(super) fn section(&self, distance: f64) -> [DVec3; 4] {
        let c = self.corners;
        if distance == self.far {
            return [c[4], c[5], c[6], c[7]];
        }
        let t = (distance - self.near) / (self.far - self.near);
        std::array::from_fn(|i| c[i].lerp(c[4 + i], t))
    }

    /// The parts of the volume that are drawn, by their distances from C.
    pub(super) fn parts(&self) -> Vec<[f64; 2]> {
        match self.gap {
            None => vec![[self.near, self.end]],
            Some([from, to]) => vec![[self.near, from], [to, self.end]],
        }
    }

    /// All corners, as drawn.
    pub(super) fn all_corners(&self) -> impl Iterator<Item = DVec3> + use<> {
        self.window().into_iter().chain(self.far_face())
    }

    /// The corners that a picture should hold; those of an angle so wide that little else would be seen are drawn in, and those
    /// of a volume that begins far beyond all else are left out.
    pub(super) fn of_interest(&self, camera: &Camera, core: &Aabb) -> Vec<DVec3> {
        let limit = WIDEST * core.radius();
        let (c, dop) = (camera.position(), camera.direction_of_projection());
        let deepest = core.corners().iter().map(|&p| -camera.view_point(p).z).fold(0.0, f64::max);
        let drawn = [self.near, self.end].into_iter().filter(|d| core.radius() <= 0.0 || *d <= 4.0 * deepest);
        drawn
            .flat_map(|d| {
                let middle = c + dop * d;
                self.section(d).map(|p| if limit > 0.0 { middle + drawn_in(p - middle, core.radius()) } else { p })
            })
            .collect()
    }

    /// B after the far face was moved by `way` (units) along DOP from where it is drawn: that of a broken volume goes in proportion.
    pub(super) fn far_moved(&self, way: f64) -> f64 {
        if self.gap.is_some() { self.far * (self.end + way) / self.end } else { self.far + way }
    }
}

/// The way from the axis to a corner, as far as the picture follows it.
fn drawn_in(aside: DVec3, radius: f64) -> DVec3 {
    let width = aside.length() / radius;
    let beyond = (width / WIDEST - 1.0).clamp(0.0, 1.0);
    aside.clamp_length_max(radius * (WIDEST + (MIDDLE - WIDEST) * beyond))
}
