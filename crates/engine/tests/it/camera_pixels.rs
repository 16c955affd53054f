//! Pixels of points: floors are those of the exact numbers, on a border of pixels and beside it, for windows of any
//! size and cameras that rounding has touched.

use camera_lab_engine::camera::{Camera, ImageSize, Parameters, Projected, Projection, Viewport};
use glam::{DVec2, DVec3};

use crate::common::camera::{apply, camera};

const IMAGE: ImageSize = ImageSize { width: 1000, height: 800 };

fn projected(camera: &Camera, point: DVec3) -> Projected {
    let projected = camera.stations(point, IMAGE, &Viewport::whole(IMAGE)).projected;
    projected.unwrap_or_else(|| panic!("{point} lies in the plane of the eye"))
}

/// Looks along −z from the origin at a window of the size 1.25 `height` × `height`.
fn straight(projection: Projection, height: f64) -> Camera {
    camera(|p| {
        *p = Parameters {
            position: DVec3::ZERO,
            focal_point: DVec3::NEG_Z,
            view_up: DVec3::Y,
            projection,
            // H = 2 F tan(θ/2) = 2 F for a right angle.
            view_angle: 90.0,
            near: height / 2.0,
            far: height * 4.0,
            height,
            aspect: 1.25,
            ..Parameters::default()
        };
    })
}

#[test]
fn a_point_inside_a_pixel_belongs_to_it_however_large_the_window_is() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        for height in [1e-12, 0.01, 8.0, 1e12] {
            let camera = straight(projection, height);
            let pixel = height / 800.0;
            // The last is nearer to the border than any noise that a floor may overlook.
            for share in [0.001, 0.25, 0.75, 0.999, 1.0 - 1e-9] {
                // On the plane of the window, share of a pixel to the right of and above the centre.
                let point = DVec3::new(share * pixel, share * pixel, -height / 2.0);
                let found = projected(&camera, point);
                assert_eq!(found.pixel, DVec2::new(500.0, 399.0), "{projection:?}, H = {height}, {share}");
                assert_eq!(
                    found.viewport.truncate(),
                    DVec2::new(500.0, 400.0),
                    "{projection:?}, H = {height}, {share}"
                );
            }
        }
    }
}

/// Points on the axis of projection lie exactly on the corner of four pixels, though no basis vector of these cameras
/// is a vector of `f64`s.
#[test]
fn a_point_on_a_border_of_pixels_is_known_through_the_rounding_of_the_basis() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        for height in [1e-9, 1.0, 1e6] {
            for toward in [DVec3::new(1.0, 2.0, 3.0), DVec3::new(-7.0, 3.0, 11.0), DVec3::new(5.0, -13.0, 1.0)] {
                let camera = camera(|p| {
                    (p.position, p.focal_point, p.view_up) = (DVec3::ZERO, toward, DVec3::new(0.3, 1.0, -0.2));
                    (p.projection, p.height, p.aspect, p.near, p.far) = (projection, height, 1.25, 1.0, 1e3);
                    p.view_angle = 2.0 * (height / 2.0).atan().to_degrees();
                });
                for times in [1.0, 2.0, 3.0, 7.0] {
                    let found = projected(&camera, toward * times);
                    let place = format!("{projection:?}, H = {height}, {times} × {toward}");
                    assert_eq!(found.pixel, DVec2::new(500.0, 400.0), "{place}");
                    assert_eq!(found.viewport.truncate(), DVec2::new(500.0, 400.0), "{place}");
                }
            }
        }
    }
}

/// PF stays in the middle of the image while the camera goes round it, far from the origin as well, although C is
/// rounded there.
#[test]
fn the_focal_point_stays_in_the_middle_while_the_camera_goes_round_it() {
    for away in [0.0, 1e3, 1e6] {
        for projection in [Projection::Perspective, Projection::Parallel] {
            let mut camera = camera(|p| {
                p.focal_point = DVec3::new(0.1 + away, 0.2 - away, 0.3);
                p.position = p.focal_point + DVec3::new(1.0, 2.0, 5.0);
                (p.projection, p.aspect) = (projection, 1.25);
            });
            for step in 0..24 {
                for operation in ["azimuth=37", "elevation=11", "roll=5"] {
                    camera = apply(&camera, operation);
                    let found = projected(&camera, camera.focal_point());
                    assert_eq!(found.pixel, DVec2::new(500.0, 400.0), "step {step}, {away} away, {projection:?}");
                }
            }
        }
    }
}

#[test]
fn the_pipeline_knows_the_rounding_error_of_the_position() {
    let start = camera(|p| {
        p.focal_point = DVec3::new(1e6, 1e6, 0.0);
        p.position = p.focal_point + DVec3::new(1.0, 2.0, 5.0);
    });
    let turned = apply(&start, "azimuth=37");
    // C as a sum of two `f64`s: at the first of them, all that is left is the second.
    let exact = turned.stations(turned.position(), IMAGE, &Viewport::whole(IMAGE)).view;
    let fast = turned.view_point(turned.position());
    assert!(exact.length() > 1e-13, "C of this camera is not rounded: {exact}");
    assert!((fast - exact).length() <= 1e-9 * exact.length(), "{fast} against {exact}");
}

#[test]
fn the_aspect_of_an_image_is_its_width_by_its_height() {
    assert_eq!(ImageSize { width: 1000, height: 800 }.aspect(), 1.25);
    assert_eq!(ImageSize { width: 3, height: 12 }.aspect(), 0.25);
}

#[test]
fn a_point_in_the_plane_of_the_eye_stays_there_despite_rounding() {
    // Exercise 5.1: C + u + v = (2.2, 4.6, −1), of which no `f64` holds the first two.
    let camera = camera(|p| p.position = DVec3::new(3.0, 4.0, 0.0));
    let at = |point| camera.stations(point, IMAGE, &Viewport::whole(IMAGE));
    let s = at(DVec3::new(2.2, 4.6, -1.0));
    assert_eq!((s.clip.w, s.projected, s.inside), (0.0, None, false));
    assert_eq!(s.view.z, -1.776_356_839_400_250_5e-16, "every digit of what the rounded coordinates say");
    // A depth that rounding cannot explain: two units in the last place, towards the eye and away from it.
    for (x, sign) in [(2.2_f64.next_down().next_down().next_down(), -1.0), (2.2 + 1e-14, 1.0)] {
        let s = at(DVec3::new(x, 4.6, -1.0));
        assert_eq!(s.view.z.signum(), sign, "{x}");
        assert!(s.clip.w != 0.0 && s.projected.is_some());
    }
    // If coordinates are whole numbers far away, they are meant exactly: one unit in the last place is seen.
    let far = crate::common::camera::camera(|p| {
        p.position = DVec3::new(0.0, 0.0, 1e15);
        p.focal_point = DVec3::new(0.0, 0.0, 1e15 - 8.0);
    });
    let s = far.stations(DVec3::new(3.0, 0.0, 1e15_f64.next_down()), IMAGE, &Viewport::whole(IMAGE));
    assert_eq!(s.view.z, -0.125);
    assert!(s.projected.is_some());
}
