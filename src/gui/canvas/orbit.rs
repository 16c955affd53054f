//! The observers of the two three-dimensional pictures, and their changes by pointer and keys.

use std::collections::VecDeque;

use eframe::egui::Vec2;
use glam::DVec2;

use crate::camera::Camera;
use crate::figure::observer::HALF_VIEW_ANGLE;
use crate::figure::{Observer, Observers, Outside};
use crate::gui::state::ObserverChange;
use crate::views::observer::Viewpoint;
use crate::views::{Request, SharedScene, Size, View};

/// Degrees of orbit for one point of pointer motion.
pub(super) const DEGREES_PER_POINT: f64 = 0.5;

/// The observer of a figure that says nothing about it: it has everything in the picture, and stays where it is as long
/// as that is about true, so that a camera that is moved is seen moving.
#[derive(Debug, Default)]
pub(super) struct Auto {
    kept: Option<FittedObserver>,
    /// Cameras that were there before, and from where they were seen: one that comes back, as by undo, is seen as then.
    before: VecDeque<(Camera, Observer)>,
}

/// The number of cameras that are remembered.
const REMEMBERED: usize = 64;

#[derive(Debug)]
struct FittedObserver {
    observer: Observer,
    /// The observer that would fit, and its inputs.
    fitted: Observer,
    camera: Camera,
    scene: SharedScene,
    subject: u64,
    size: Size,
    outside: Outside,
    /// Nothing was being dragged.
    settled: bool,
}

impl Auto {
    /// The observer for a picture; `None` for the image. With `steady` (while something is dragged) it does not move,
    /// except to fit a picture of another size. It looks in the same direction, unless the camera turns towards it,
    /// until there is another `subject`: a scene that has nothing to do with the last one.
    pub(super) fn observer(&mut self, request: &Request, subject: u64, steady: bool) -> Option<Observer> {
        let (camera, scene, size) = (&request.camera, &request.scene, request.size);
        let outside = request.shot.look.reveal.outside;
        let Some(kept) = self.kept.as_mut().filter(|kept| kept.subject == subject) else {
            let fitted = request.observer_from(Viewpoint::default())?;
            let (camera, scene) = (camera.clone(), scene.clone());
            let settled = !steady;
            self.before.clear();
            self.kept =
                Some(FittedObserver { observer: fitted, fitted, camera, scene, subject, size, outside, settled });
            return Some(fitted);
        };
        // Gear and letters have sizes of their own, in pixels; parts outside the canonical volume need room.
        let reshaped = kept.size != size || (request.view == View::Canonical && kept.outside != outside);
        if reshaped || kept.scene != *scene {
            self.before.clear();
        } else if kept.settled && kept.camera != *camera {
            self.before.truncate(REMEMBERED - 1);
            self.before.push_front((kept.camera.clone(), kept.observer));
        }
        let returns = kept.camera != *camera || !kept.settled;
        let then = self.before.iter().find(|(before, _)| returns && !steady && before == camera);
        kept.settled = !steady;
        if reshaped || kept.camera != *camera || kept.scene != *scene {
            (kept.size, kept.outside) = (size, outside);
            kept.camera = camera.clone();
            kept.scene = scene.clone();
            kept.fitted = request.kept_clear(&kept.observer)?;
        }
        if let Some((_, observer)) = then {
            kept.observer = *observer;
        } else if reshaped || !(steady || still_fits(&kept.observer, &kept.fitted)) {
            kept.observer = kept.fitted;
        }
        Some(kept.observer)
    }

    /// Fits again in the next frame.
    pub(super) fn forget(&mut self) {
        self.kept = None;
        self.before.clear();
    }
}

/// Whether this observer's picture contains everything in the fitted one's, and not too small.
fn still_fits(observer: &Observer, fitted: &Observer) -> bool {
    if (observer.azimuth, observer.elevation) != (fitted.azimuth, fitted.elevation) {
        return false;
    }
    let offset = observer.target.distance(fitted.target) / (2.0 * HALF_VIEW_ANGLE.tan());
    let needed = fitted.distance + 2.0 * offset;
    needed <= 1.08 * observer.distance && fitted.distance >= 0.4 * observer.distance
}

/// The observer requested by a button of the toolbar or a key, from the present one. `None`: the figure has none any
/// more, and [`Auto`] applies.
pub(super) fn changed(request: &Request, change: ObserverChange) -> Option<Observer> {
    match change {
        ObserverChange::From(Viewpoint::Iso) => None,
        ObserverChange::From(viewpoint) => request.observer_from(viewpoint),
        ObserverChange::Fit => request.fitted(&request.seen_from()?),
    }
}

/// The observer after the pointer went by `motion` points from where it turned `pressed`: the picture follows the
/// pointer.
pub(super) fn orbited(pressed: Observer, motion: Vec2) -> Observer {
    pressed.orbit(f64::from(motion.x) * DEGREES_PER_POINT, f64::from(motion.y) * DEGREES_PER_POINT)
}

/// Moves nearer by `factor` so that the point at `pointer` (pixels) stays there.
pub(super) fn zoomed_at(observer: Observer, factor: f64, pointer: DVec2, size: Size) -> Observer {
    let height = f64::from(size.height);
    let from_center = pointer - DVec2::new(f64::from(size.width), height) / 2.0;
    let shift = from_center * (1.0 - factor);
    observer.zoom(factor).pan(shift.x, shift.y, height)
}

/// Writes the observer of a picture into a figure; the image has none.
pub(super) fn set(observers: &mut Observers, view: View, observer: Option<Observer>) {
    match view {
        View::World => observers.world = observer,
        View::Canonical => observers.canonical = observer,
        View::Image => {}
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::camera::Parameters;
    use crate::figure::Figure;
    use crate::i18n::{Lang, pictures::labels};
    use eframe::egui::vec2;
    use glam::DVec3;

    fn observer() -> Observer {
        Observer {
            target: DVec3::new(1.0, 2.0, 3.0),
            distance: 20.0,
            azimuth: 35.0,
            elevation: 25.0,
            roll: 0.0,
            parallel: false,
        }
    }

    #[test]
    fn the_picture_follows_the_pointer() {
        let turned = orbited(observer(), vec2(40.0, 10.0));
        assert_eq!((turned.azimuth, turned.elevation), (15.0, 30.0));
    }

    /// Projects by hand: right and up in the plane of the target, one length for all pixels there.
    #[test]
    fn zoom_keeps_what_is_under_the_pointer() {
        let size = Size { width: 400, height: 300, scale: 1.0 };
        let pointer = DVec2::new(310.0, 60.0);
        let on_target_plane = |o: Observer| {
            let unit = 2.0 * o.distance * HALF_VIEW_ANGLE.tan() / 300.0;
            let [right, up, _] = o.axes();
            o.target + right * ((pointer.x - 200.0) * unit) - up * ((pointer.y - 150.0) * unit)
        };
        let before = observer();
        let after = zoomed_at(before, 1.7, pointer, size);
        assert!((after.distance - 20.0 / 1.7).abs() < 1e-12);
        assert!(on_target_plane(before).distance(on_target_plane(after)) < 1e-12);
    }

    #[test]
    fn an_observer_stays_until_something_leaves_its_picture_or_gets_lost_in_it() {
        let fits = |fitted: Observer| still_fits(&observer(), &fitted);
        assert!(fits(observer()));
        assert!(fits(Observer { distance: 12.0, ..observer() }));
        assert!(fits(Observer { distance: 21.0, ..observer() }));
        assert!(!fits(Observer { distance: 24.0, ..observer() }));
        assert!(!fits(Observer { distance: 5.0, ..observer() }));
        assert!(!fits(Observer { target: DVec3::new(9.0, 2.0, 3.0), ..observer() }));
    }

    #[test]
    fn a_camera_that_comes_back_is_seen_from_where_it_was_seen() {
        let figure = Figure::default();
        let (scene, mut auto) = (SharedScene::default(), Auto::default());
        let camera = Camera::new(&figure.camera).unwrap();
        let turned = |degrees| {
            let by = crate::camera::Operation::Azimuth(crate::geometry::Angle::from_degrees(degrees));
            by.apply(&camera, crate::camera::Convention::RightHand).unwrap()
        };
        let mut seen = |camera: &Camera, steady: bool| {
            let size = Size { width: 400, height: 300, scale: 1.0 };
            let request = Request::of(&figure, View::World, camera, &scene, labels(Lang::En), size);
            auto.observer(&request, 0, steady).unwrap()
        };
        let first = seen(&camera, false);
        // A drag, and what is there when it is let go; then undo and redo.
        for degrees in [20.0, 45.0, 65.0] {
            assert_eq!(seen(&turned(degrees), true), first, "nothing moves in the hand");
        }
        let moved = seen(&turned(65.0), false);
        assert_ne!(moved, first, "the camera looked along the line of sight");
        assert_eq!(seen(&camera, false), first, "undone");
        assert_eq!(seen(&turned(65.0), false), moved, "done again");
    }

    #[test]
    fn an_untold_observer_keeps_its_direction_and_waits_until_nothing_is_held() {
        let figure = Figure::default();
        let scene = SharedScene::default();
        let mut auto = Auto::default();
        let mut seen = |position: DVec3, width: u32, steady: bool| {
            let camera = Camera::new(&Parameters { position, far: 12.0, ..figure.camera }).unwrap();
            let size = Size { width, height: 300, scale: 1.0 };
            let request = Request::of(&figure, View::World, &camera, &scene, labels(Lang::En), size);
            auto.observer(&request, 0, steady).unwrap()
        };
        let near = DVec3::new(3.0, 4.0, 5.0);
        let first = seen(near, 400, false);
        assert_eq!(seen(near * 1.02, 400, false), first);
        assert_eq!(seen(near * 9.0, 400, true), first, "something is held");
        let later = seen(near * 9.0, 400, false);
        assert!(later.distance > 2.0 * first.distance);
        assert_eq!((later.azimuth, later.elevation), (first.azimuth, first.elevation));
        let narrow = seen(near * 9.0, 150, true);
        assert!(narrow.distance > later.distance, "another shape is fitted at once");
        assert_eq!(narrow.azimuth, first.azimuth);
    }
}
