//! The view volume as the world shows it. It's drawn whole, unless it's so large or so far away that everything else
//! would be too small to read. Then it's drawn nearer and narrower, with its edges broken, as draughtsmen break a long
//! shaft.

use glam::DVec3;

use crate::camera::{Camera, Projection};
use crate::geometry::Aabb;

/// Greatest enlargement of the visible content by the whole volume. Beyond it, the volume is broken.
const MOST_ENLARGED: f64 = 2.5;

/// The end of a broken volume in the picture, and its gap, relative to the greatest depth of the other content.
const END: f64 = 1.22;
const GAP: [f64; 2] = [1.06, 1.105];

/// If F is more than this multiple of the greatest depth of the other content, the window is drawn at the place of the
/// back face of a broken volume, with the back face behind it, as deep as this at most.
const FARTHEST: f64 = 4.0;
const DEEPEST: f64 = 0.5;

/// Greatest distance of the corners of a wide volume in the picture, in radii of the other content. A volume that's
/// wider around its axis is drawn as wide as [`NARROWED`], with broken sides. If one is twice as wide and lies
/// off-axis, only its middle is in the picture.
const WIDEST: f64 = 26.0;
const NARROWED: f64 = 2.2;
const MIDDLE: f64 = 4.0;

/// The volume as drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::views) struct DrawnVolume {
    corners: [DVec3; 8],
    near: f64,
    far: f64,
    eye: DVec3,
    dop: DVec3,
    /// **u** and **v**.
    across: [DVec3; 2],
    /// From the axis to the corners of the window, along **u** and **v**.
    window: [[f64; 2]; 4],
    perspective: bool,
    /// The scale of the drawn volume along **u** and **v**: 1, or less if its sides are broken.
    pub(in crate::views) narrowed: [f64; 2],
    /// The distance from C at which the window is drawn: F, or less if it lies far beyond everything else.
    pub(in crate::views) start: f64,
    /// The range of distances left out between C and the window.
    pub(in crate::views) before: Option<[f64; 2]>,
    /// The distance from C at which the far face is drawn: B, or less if the volume is broken.
    pub(in crate::views) end: f64,
    /// The range of distances left out of the volume.
    pub(in crate::views) gap: Option<[f64; 2]>,
}

impl DrawnVolume {
    /// The volume among the other content: the box around it, and the points that the volume should hold.
    pub(in crate::views) fn of(camera: &Camera, core: &Aabb, points: &[DVec3]) -> Self {
        let whole = Self::whole(camera);
        let depth = |least: f64| points.iter().map(|&p| -camera.view_point(p).z).fold(least, f64::max);
        let reach = depth(0.5 * core.radius());
        let deep = if core.radius() > 0.0 && whole.near > FARTHEST * reach {
            whole.nearer(reach)
        } else {
            whole.shorter(core, depth(whole.near))
        };
        deep.narrower(core.radius())
    }

    /// The volume as it is.
    pub(in crate::views) fn whole(camera: &Camera) -> Self {
        let (near, far, window) = (camera.near(), camera.far(), camera.window());
        let (left, right) = (window.left, window.right);
        Self {
            corners: camera.volume_corners(),
            near,
            far,
            eye: camera.position(),
            dop: camera.direction_of_projection(),
            across: [camera.basis().u, camera.basis().v],
            window: [[left, window.bottom], [right, window.bottom], [right, window.top], [left, window.top]],
            perspective: camera.projection() == Projection::Perspective,
            narrowed: [1.0; 2],
            start: near,
            before: None,
            end: far,
            gap: None,
        }
    }

    /// The volume as drawn for measuring F and the window, which are at their true places.
    pub(in crate::views) fn measured(self, camera: &Camera) -> Self {
        if self.before.is_some() { Self::whole(camera) } else { Self { narrowed: [1.0; 2], ..self } }
    }

    /// Puts the far face at the end of the other content if the far face would make that too small.
    fn shorter(self, core: &Aabb, deepest: f64) -> Self {
        let enlarged = Aabb::around(self.corners).map_or(0.0, |volume| volume.union(*core).radius()) / core.radius();
        let (end, gap) = (END * deepest, GAP.map(|share| share * deepest));
        // `!(… > …)`, so that if there's nothing else to see, the volume is all.
        let fits = !(enlarged > MOST_ENLARGED && core.radius() > 0.0);
        if fits || end > 0.9 * self.far || !end.is_finite() { self } else { Self { end, gap: Some(gap), ..self } }
    }

    /// Puts the window at the end of the other content, and the far face behind it.
    fn nearer(self, reach: f64) -> Self {
        let (start, before) = (END * reach, Some(GAP.map(|share| share * reach)));
        let (depth, most) = (self.far - self.near, DEEPEST * reach);
        let gap = (depth > most).then_some([start + 0.45 * most, start + 0.55 * most]);
        Self { start, before, end: start + depth.min(most), gap, ..self }
    }

    /// Narrows the sides so that the other content stays readable.
    fn narrower(self, radius: f64) -> Self {
        let widest = self.scale(self.end);
        let narrowed = std::array::from_fn(|axis| {
            let (least, most) = (self.window[0][axis], self.window[2][axis]);
            let reach = widest * most.max(-least);
            let around_the_axis = least < 0.0 && most > 0.0;
            let wide = around_the_axis && radius > 0.0 && reach > WIDEST * radius && reach.is_finite();
            if wide { NARROWED * radius / reach } else { 1.0 }
        });
        Self { narrowed, ..self }
    }

    /// The width of a section relative to the window.
    fn scale(&self, distance: f64) -> f64 {
        if self.perspective { distance / self.near } else { 1.0 }
    }

    /// True if the sides are broken along **u** (0) or **v** (1).
    pub(in crate::views) fn is_narrowed(&self, axis: usize) -> bool {
        self.narrowed[axis] < 1.0
    }

    /// The corners of the window as drawn: (l, b), (r, b), (r, t), (l, t).
    pub(in crate::views) fn window(&self) -> [DVec3; 4] {
        self.section(self.start)
    }

    /// The corners of the far face as drawn, in the same order.
    pub(in crate::views) fn far_face(&self) -> [DVec3; 4] {
        self.section(self.end)
    }

    /// The corners of the volume's section at a distance from C as drawn, in the same order.
    pub(in crate::views) fn section(&self, distance: f64) -> [DVec3; 4] {
        let c = self.corners;
        if distance == 0.0 && self.perspective {
            return [self.eye; 4];
        }
        if self.before.is_some() || self.narrowed != [1.0; 2] {
            let middle = self.eye + self.dop * distance;
            let along = |corner: usize, axis: usize| {
                self.across[axis] * (self.window[corner][axis] * self.scale(distance) * self.narrowed[axis])
            };
            return std::array::from_fn(|corner| middle + along(corner, 0) + along(corner, 1));
        }
        if distance == self.near {
            return [c[0], c[1], c[2], c[3]];
        }
        if distance == self.far {
            return [c[4], c[5], c[6], c[7]];
        }
        let t = (distance - self.near) / (self.far - self.near);
        std::array::from_fn(|i| c[i].lerp(c[4 + i], t))
    }

    /// The parts of the volume that are drawn, by their distances from C.
    pub(in crate::views) fn parts(&self) -> Vec<[f64; 2]> {
        match self.gap {
            None => vec![[self.start, self.end]],
            Some([from, to]) => vec![[self.start, from], [to, self.end]],
        }
    }

    /// The parts between C and the window that are drawn.
    pub(in crate::views) fn parts_before(&self) -> Vec<[f64; 2]> {
        match self.before {
            None => vec![[0.0, self.start]],
            Some([from, to]) => vec![[0.0, from], [to, self.start]],
        }
    }

    /// All corners, as drawn.
    pub(in crate::views) fn all_corners(&self) -> impl Iterator<Item = DVec3> + use<> {
        self.window().into_iter().chain(self.far_face())
    }

    /// The corners that a picture should hold. If the angle is so wide that little else would be visible, they're drawn
    /// in.
    pub(in crate::views) fn of_interest(&self, camera: &Camera, core: &Aabb) -> Vec<DVec3> {
        let limit = WIDEST * core.radius();
        let (c, dop) = (camera.position(), camera.direction_of_projection());
        let deepest = core.corners().iter().map(|&p| -camera.view_point(p).z).fold(0.0, f64::max);
        let held = |d: &f64| core.radius() <= 0.0 || self.before.is_some() || *d <= FARTHEST * deepest;
        let drawn = [self.start, self.end].into_iter().filter(held);
        drawn
            .flat_map(|d| {
                let middle = c + dop * d;
                self.section(d).map(|p| if limit > 0.0 { middle + drawn_in(p - middle, core.radius()) } else { p })
            })
            .collect()
    }

    /// F after the window was moved by `way` (units) along DOP from its drawn place. A window that's drawn nearer moves
    /// in proportion.
    pub(in crate::views) fn near_moved(&self, way: f64) -> f64 {
        if self.before.is_some() { self.near * (self.start + way) / self.start } else { self.near + way }
    }

    /// B after the far face was moved by `way` (units) along DOP from its drawn place. That of a broken volume moves in
    /// proportion.
    pub(in crate::views) fn far_moved(&self, way: f64) -> f64 {
        let broken = self.gap.or(self.before).is_some();
        if broken { self.far * (self.end + way) / self.end } else { self.far + way }
    }
}

/// The way from the axis to a corner, as far as the picture follows it.
fn drawn_in(aside: DVec3, radius: f64) -> DVec3 {
    let width = aside.length() / radius;
    let beyond = (width / WIDEST - 1.0).clamp(0.0, 1.0);
    aside.clamp_length_max(radius * (WIDEST + (MIDDLE - WIDEST) * beyond))
}
