//! The hand on the image, which moves the camera, as in Blender and `GeoGebra`.

use glam::{DQuat, DVec2, DVec3};

use crate::camera::{Camera, Convention, Operation, Parameters, Projection};
use crate::views::{Request, pick};

/// Degrees for one point of a drag.
const DEGREES_PER_POINT: f64 = 0.4;
/// The camera stays this far from looking along VUP, in degrees.
const POLE: f64 = 1.0;

/// A camera moved by dragging its image.
#[derive(Clone, Debug)]
pub(in crate::gui::views) struct CameraDrag {
    /// The camera that Esc restores.
    pub(super) start: Camera,
    /// Units of the window for a pixel to the right and for one down, at PF, so that the content there stays below the
    /// pointer. `None` if the camera turns about PF.
    pans: Option<DVec2>,
    /// The motion of the pointer so far, in points.
    gone: DVec2,
}

impl CameraDrag {
    /// Takes the camera at a pixel of its image. `None` outside.
    pub(in crate::gui::views) fn taken(request: &Request, camera: &Camera, at: DVec2, pans: bool) -> Option<Self> {
        let window = |p: DVec2| pick::window_point_in_image(request, p);
        let here = window(at)?;
        let pans = if pans {
            // A pixel on one of its sides is in the image.
            let step = |by: DVec2| window(at + by).map(|p| p - here).or_else(|| window(at - by).map(|p| here - p));
            let magnified = match camera.projection() {
                Projection::Perspective => camera.distance() / camera.near(),
                Projection::Parallel => 1.0,
            };
            Some(DVec2::new(step(DVec2::X)?.x, step(DVec2::Y)?.y) * magnified)
        } else {
            None
        };
        Some(Self { start: camera.clone(), pans, gone: DVec2::ZERO })
    }

    /// Follows the pointer, whose way is `points` on the screen and `pixels` in the picture. Returns true if it has
    /// moved on.
    pub(in crate::gui::views) fn follow(
        &mut self,
        model: &mut camera_lab_desk::Model,
        points: DVec2,
        pixels: DVec2,
    ) -> bool {
        if std::mem::replace(&mut self.gone, points) == points {
            return false;
        }
        match self.pans {
            None => model.desk.shown.set_parameters(orbited(&self.start, points)),
            Some(per_pixel) => {
                let by = -pixels * per_pixel;
                let pan = Operation::Pan { dx: by.x, dy: by.y };
                let done = model.desk.shown.operate_from(&self.start, pan, Convention::RightHand);
                model.say_camera_error(done);
            }
        }
        true
    }

    /// True if it pans.
    pub(in crate::gui::views) fn is_pan(&self) -> bool {
        self.pans.is_some()
    }
}

/// A turn about PF that keeps VUP. The scene goes with the pointer, and the camera stays level.
fn orbited(start: &Camera, points: DVec2) -> Parameters {
    let parameters = *start.parameters();
    let up = parameters.view_up.normalize_or_zero();
    let arm = start.position() - start.focal_point();
    let around = DQuat::from_axis_angle(up, (-points.x * DEGREES_PER_POINT).to_radians());
    // From VUP to the camera, as seen from PF.
    let now = arm.angle_between(up).to_degrees();
    let then = (now - points.y * DEGREES_PER_POINT).clamp(POLE, 180.0 - POLE);
    let raise = DQuat::from_axis_angle(start.basis().u, (then - now).to_radians());
    let position: DVec3 = start.focal_point() + around * (raise * arm);
    Parameters { position, ..parameters }
}

/// The wheel over the image: nearer, or, in parallel projection, enlarged.
pub(in crate::gui::views) fn dollied(camera: &Camera, factor: f64) -> Operation {
    match camera.projection() {
        Projection::Perspective => Operation::Dolly(factor),
        Projection::Parallel => Operation::Zoom(factor),
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]
    use super::*;

    #[test]
    fn the_scene_goes_with_the_pointer_and_the_camera_stays_level() {
        let camera = Camera::new(&Parameters::default()).unwrap();
        let d = camera.distance();
        for points in [DVec2::new(90.0, 0.0), DVec2::new(0.0, 40.0), DVec2::new(-700.0, 3000.0)] {
            let turned = orbited(&camera, points);
            let after = Camera::new(&turned).unwrap();
            assert!((after.distance() - d).abs() < 1e-12 * d);
            assert_eq!((turned.view_up, turned.focal_point), (camera.view_up(), camera.focal_point()));
            assert!(after.basis().u.y.abs() < 1e-12, "level");
        }
        // To the right: the content before PF goes to the right, so the camera goes to the left.
        let after = orbited(&camera, DVec2::new(30.0, 0.0)).position - camera.position();
        assert!(after.dot(camera.basis().u) < 0.0);
        // Down: the camera rises.
        assert!(orbited(&camera, DVec2::new(0.0, 30.0)).position.y > camera.position().y);
    }
}
