//! The viewpoint that shows each preset well.

use glam::DVec3;

use crate::camera::{Parameters, Projection};
use crate::scene::Preset;

/// A camera that shows the scene well, with clipping planes close around it, so that its view volume is visible in the
/// world too. For an exercise it's the camera of the exercise.
pub fn recommended_camera(preset: Preset) -> Parameters {
    let perspective = |position: [f64; 3], focal_point: [f64; 3], view_angle, near, far| Parameters {
        position: DVec3::from(position),
        focal_point: DVec3::from(focal_point),
        view_angle,
        near,
        far,
        ..Parameters::default()
    };
    let origin = [0.0; 3];
    match preset {
        Preset::Empty => Parameters::default(),
        Preset::Primitives => perspective([3.0, 4.0, 5.0], origin, 42.0, 3.0, 12.0),
        Preset::Cube => perspective([2.6, 2.4, 3.6], origin, 42.0, 2.0, 8.0),
        Preset::House => perspective([3.2, 2.6, 5.4], [0.0, 0.8, 0.0], 38.0, 3.0, 11.0),
        Preset::Corridor => perspective([0.3, 1.3, 4.5], [0.0, 1.1, -5.0], 50.0, 1.5, 20.0),
        // `[1]`, exercises II and III for D = 15 and M = 8, with near = D/100 and far = 10 D. Angle and aspect are free
        // there.
        Preset::Pyramid => Parameters { aspect: 1.0, ..perspective([0.0, 0.0, 8.0], origin, 90.0, 0.15, 150.0) },
        // The answer to `[0]` exercise 5.3.
        Preset::NdcCube => Parameters {
            projection: Projection::Parallel,
            height: 2.0,
            aspect: 1.0,
            ..perspective([0.0, 0.0, 2.0], origin, 45.0, 1.0, 3.0)
        },
        Preset::Exercise51 => perspective([3.0, 4.0, 0.0], origin, 45.0, 1.5, 9.0),
        // The text gives a view angle of 90° for a parallel projection. H is its span on the front plane, 2 F tan 45°.
        Preset::Exercise52 => Parameters {
            view_up: DVec3::X,
            projection: Projection::Parallel,
            height: 10.0,
            aspect: 0.75,
            ..perspective([7.0, 0.0, 0.0], [1.0; 3], 90.0, 5.0, 20.0)
        },
        Preset::Exercise53 => perspective([3.0, 4.0, 5.0], origin, 35.0, 4.0, 11.0),
    }
}
