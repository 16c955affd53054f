//! A point is found again from its coordinates in any of its spaces.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::camera::{ImageSize, Ndc, NotProjectable, Place, Projection, Viewport};
use glam::{DVec2, DVec3};
use proptest::prelude::*;

use crate::common::any_camera::plain_camera;
use crate::common::camera::camera;

const IMAGE: ImageSize = ImageSize { width: 1024, height: 768 };

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_space_leads_back_to_the_point(camera in plain_camera(), p in [-0.9..0.9, -0.9..0.9, 0.05..0.95]) {
        let viewport = Viewport::whole(IMAGE);
        for ndc in Ndc::ALL {
            let Ok(space) = camera.clip_space(ndc) else { continue };
            // A point in the volume, from its view coordinates.
            let w = camera.window();
            let distance: f64 = camera.near() + p[2] * (camera.far() - camera.near());
            let share = if camera.projection() == Projection::Perspective { distance / camera.near() } else { 1.0 };
            let x = (w.left + w.right + p[0] * w.width()) / 2.0 * share;
            let y = (w.bottom + w.top + p[1] * w.height()) / 2.0 * share;
            let view = DVec3::new(x, y, -distance);
            let world = space.world_of(IMAGE, &viewport, Place::View(view)).unwrap();
            let stations = space.stations(world, IMAGE, &viewport);
            let size = camera.position().length() + camera.far() + view.length();
            prop_assert!(stations.view.abs_diff_eq(view, 1e-13 * size));
            let projected = stations.projected.unwrap();
            for place in [Place::World(world), Place::Ndc(projected.ndc), Place::Window(projected.window, -stations.view.z)] {
                let again = space.world_of(IMAGE, &viewport, place).unwrap();
                // The worth of a last digit of z_n, in the distance.
                let per_depth = 1.0 + camera.far() / camera.near();
                prop_assert!(again.abs_diff_eq(world, 1e-13 * size * per_depth), "{:?} {:?}: {} {}", ndc, place, again, world);
            }
        }
    }
}

#[test]
fn behind_the_eye_a_point_is_found_from_the_window_and_from_ndc() {
    let camera = camera(|p| (p.position, p.near, p.far) = (DVec3::new(0.0, 0.0, 5.0), 1.0, 3.0));
    let (space, viewport) = (camera.notes_clip_space(), Viewport::whole(IMAGE));
    let at = |place| space.world_of(IMAGE, &viewport, place);
    assert_eq!(at(Place::Window(DVec2::new(-0.5, 1.0), -2.0)).unwrap(), DVec3::new(1.0, -2.0, 7.0));
    assert_eq!(at(Place::Window(DVec2::ONE, 0.0)), Err(NotProjectable::InPlaneOfEye));
    // z_n reaches (B + F)/(B − F) = 2 at infinity.
    let infinity = NotProjectable::BeyondInfinity { depth: 2.0, near: -1.0, infinity: 2.0 };
    assert_eq!(at(Place::Ndc(DVec3::new(0.0, 0.0, 2.0))), Err(infinity));
    assert_eq!(at(Place::Ndc(DVec3::new(0.0, 0.0, 1.0))).unwrap(), DVec3::new(0.0, 0.0, 2.0));
    // Beyond it are those behind the eye, in every convention: z_n = 2 − 3/distance here.
    assert_eq!(at(Place::Ndc(DVec3::new(0.0, 0.0, 3.5))).unwrap(), DVec3::new(0.0, 0.0, 7.0));
    let behind = DVec3::new(1.0, -2.0, 7.0);
    for ndc in Ndc::ALL {
        let space = camera.clip_space(ndc).unwrap();
        let projected = space.stations(behind, IMAGE, &viewport).projected.unwrap();
        let found = space.world_of(IMAGE, &viewport, Place::Ndc(projected.ndc)).unwrap();
        assert!(found.abs_diff_eq(behind, 1e-12), "{ndc:?}: {found}");
    }
    assert_eq!(at(Place::View(DVec3::splat(1e308) * 2.0)), Err(NotProjectable::Overflow { depth: f64::INFINITY }));
}
