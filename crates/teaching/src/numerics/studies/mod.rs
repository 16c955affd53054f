//! One file per study.

pub(super) mod antialiasing;
pub(super) mod basis;
pub(super) mod clipping;
pub(super) mod depth_buffer;
pub(super) mod grid;
pub(super) mod painter;
pub(super) mod photograph;
pub(super) mod repeated_operations;
pub(super) mod shading;
pub(super) mod shadows;
pub(super) mod texture_filter;
pub(super) mod vertex_transform;
pub(super) mod visibility;

use glam::DVec3;

use crate::camera::Parameters;
use crate::figure::{Figure, write};
use crate::numbers::random::Random;
use crate::scene::{ObjectSpec, Preset, SceneSpec, Shape};

/// The figure file of a camera that looks at a cube of the size `size` around PF.
fn figure_of(camera: &Parameters, size: f64) -> String {
    let [x, y, z] = camera.focal_point.to_array();
    // The box is 2 wide.
    let half = size / 2.0;
    let cube = ObjectSpec::new("cube", Shape::Box).at(x, y, z).scaled(half, half, half);
    figure_with(camera, vec![cube])
}

/// The figure file of objects before a camera.
fn figure_with(camera: &Parameters, objects: Vec<ObjectSpec>) -> String {
    let scene = SceneSpec { preset: Preset::Empty, objects, ..SceneSpec::default() };
    write::to_toml(&Figure { camera: *camera, scene, ..Figure::default() })
}

/// A camera that looks at a point near `center` from a distance of about 3, with nothing special about its numbers.
fn random_camera(random: &mut Random, center: DVec3) -> Parameters {
    let focal_point = center + random.direction() * random.between(0.1, 0.5);
    let towards_viewer = random.direction();
    let position = focal_point + towards_viewer * random.between(2.0, 4.0);
    let view_up = loop {
        let up = random.direction();
        if up.cross(towards_viewer).length() > 0.3 {
            break up;
        }
    };
    let view_angle = random.between(20.0, 90.0);
    Parameters { position, focal_point, view_up, view_angle, near: 0.5, far: 10.0, ..Parameters::default() }
}
