//! The visible content of the world: its size, and the part of it that a picture should hold.

use glam::{DVec2, DVec3};

use crate::camera::Camera;
use crate::figure::Observer;
use crate::geometry::Aabb;
use crate::numbers::nice_above;

use super::volume::DrawnVolume;
use crate::views::Request;
use crate::views::observer::on_side;

/// The boxes of the world's content.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::views) struct Content {
    scene: Option<Aabb>,
    /// Points that a picture should hold.
    pub(in crate::views) of_interest: Vec<DVec3>,
    /// The box around scene, C and PF.
    pub(in crate::views) core: Aabb,
    /// The view volume among them.
    pub(in crate::views) volume: DrawnVolume,
    /// The volumes of the other cameras.
    pub(in crate::views) others: Vec<DrawnVolume>,
}

impl Content {
    pub(in crate::views) fn of(request: &Request) -> Self {
        let camera = &request.camera;
        let scene = request.scene.bounds();
        let mut points = vec![camera.position()];
        points.extend(request.hover.ghost.iter().map(|g| g.before.position()));
        points.extend(request.operations().iter().map(|(ghost, _)| ghost.before.position()));
        points.extend(request.shot.cameras.iter().map(|other| other.camera.position()));
        points.extend(request.shot.answered.iter().map(Camera::position));
        points.extend(scene.iter().flat_map(Aabb::corners));
        let boxed = |points: &[DVec3]| {
            Aabb::around(points.iter().copied()).unwrap_or(Aabb { min: camera.position(), max: camera.position() })
        };
        // PF far beyond the scene would make everything else a speck, so DOP shows its direction.
        let small = boxed(&points);
        let to_focus = small.center().distance(camera.focal_point());
        if scene.is_none() || to_focus < 4.0 * small.radius() {
            points.push(camera.focal_point());
        }
        let core = boxed(&points);
        let volume = DrawnVolume::of(camera, &core, &points);
        let others: Vec<_> =
            request.shot.cameras.iter().map(|other| DrawnVolume::of(&other.camera, &core, &points)).collect();
        points.extend(volume.of_interest(camera, &core));
        for (other, drawn) in request.shot.cameras.iter().zip(&others) {
            points.extend(drawn.of_interest(&other.camera, &core));
        }
        let mut content = Self { scene, of_interest: points, core, volume, others };
        // Followed points that aren't far beyond everything else are in the picture.
        let (middle, reach) = (content.core.center(), 4.0 * content.core.radius());
        let near = |p: &DVec3| p.distance(middle) < reach;
        content.of_interest.extend(request.shot.points.iter().map(|point| point.position).filter(near));
        let tips = content.axis_tips();
        content.of_interest.extend(tips.into_iter().flatten());
        content
    }

    /// The radius of the content.
    pub(in crate::views) fn radius(&self) -> f64 {
        self.core.radius()
    }

    /// The box around everything drawn.
    pub(in crate::views) fn bounds(&self) -> Aabb {
        Aabb::around(self.others.iter().chain([&self.volume]).flat_map(DrawnVolume::all_corners))
            .map_or(self.core, |volume| volume.union(self.core))
    }

    /// The tips of the axes of the world, each a little outside the scene; `None` if the origin is out of sight.
    pub(in crate::views) fn axis_tips(&self) -> Option<[DVec3; 3]> {
        let around = self.scene.unwrap_or(self.core);
        let largest = around.min.abs().max(around.max.abs()).max_element();
        let near_origin = self.core.center().length() < 8.0 * self.radius();
        let length = |reach: f64| (1.2 * reach).max(0.5 * largest).clamp(0.15 * self.radius(), 0.75 * self.radius());
        near_origin.then(|| DVec3::AXES.map(|axis| axis * length(around.max.dot(axis))))
    }

    /// The grid under the content; `None` if the ground is out of sight.
    pub(in crate::views) fn ground(&self) -> Option<Ground> {
        let (min, max) = (self.core.min, self.core.max);
        let radius = self.radius();
        if min.y.abs().min(max.y.abs()) > 3.0 * radius && min.y * max.y > 0.0 {
            return None;
        }
        let (low, high) = (DVec2::new(min.x, min.z), DVec2::new(max.x, max.z));
        let step = nice_above((high - low).max_element().max(0.5 * radius) / 12.0)?;
        let low = ((low - 0.5 * step) / step).floor() * step;
        let high = ((high + 0.5 * step) / step).ceil() * step;
        (low.is_finite() && high.is_finite()).then_some(Ground { low, high, step })
    }
}

/// A grid on y = 0, with the extent in x and z, and the size of its squares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::views) struct Ground {
    low: DVec2,
    high: DVec2,
    step: f64,
}

impl Ground {
    /// The lines of the grid.
    pub(in crate::views) fn lines(&self) -> Vec<[DVec3; 2]> {
        // A hair below y = 0, so that a floor of the scene, whose face is there, covers it.
        const SUNK: f64 = 0.01;
        let Self { low, high, step } = *self;
        let at = |x: f64, z: f64| DVec3::new(x, -SUNK * step, z);
        let stops =
            |a: f64, b: f64| (0..64).map(move |i| a + f64::from(i) * step).take_while(move |v| *v < b + 0.5 * step);
        let across = stops(low.x, high.x).map(|x| [at(x, low.y), at(x, high.y)]);
        let along = stops(low.y, high.y).map(|z| [at(low.x, z), at(high.x, z)]);
        across.chain(along).collect()
    }
}

/// The direction of [`Viewpoint::Iso`](crate::views::observer::Viewpoint::Iso). It's to the side of the camera and a
/// little behind it, so that its axis runs across the picture from left to right and the image on its window isn't seen
/// from the back.
pub(in crate::views) fn iso_direction(camera: &Camera) -> Observer {
    const ASIDE: f64 = 60.0;
    let n = camera.basis().n;
    // A camera that looks straight down is placed like a map, with **v** to the back.
    let flat = if n.x.hypot(n.z) > 0.1 { n } else { camera.basis().v * -n.y.signum() };
    let azimuth = flat.x.atan2(flat.z).to_degrees();
    on_side((azimuth + ASIDE).round().rem_euclid(360.0), 20.0, false)
}
