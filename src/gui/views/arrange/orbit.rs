//! The observers of the two three-dimensional pictures, and their changes by pointer and keys.

use eframe::egui::Vec2;
use glam::DVec2;

use crate::figure::{Observer, Observers};
use crate::views::observer::Viewpoint;
use crate::views::{Request, Size, View};
use camera_lab_desk::ObserverChange;

/// Degrees of orbit for one point of pointer motion.
pub(in crate::gui::views) const DEGREES_PER_POINT: f64 = 0.5;

/// The observer requested by a button of the toolbar or a key, from the present one. `None` if the figure doesn't set
/// one any more, so that [`Auto`](super::auto_observer::Auto) applies.
pub(in crate::gui::views) fn changed(request: &Request, change: ObserverChange) -> Option<Observer> {
    match change {
        ObserverChange::From(Viewpoint::Iso) => None,
        ObserverChange::From(viewpoint) => request.observer_from(viewpoint),
        ObserverChange::Fit => request.fitted(&request.seen_from()?),
    }
}

/// The observer after the pointer moved by `motion` points from the one at the press, `pressed`. The picture follows
/// the pointer.
pub(in crate::gui::views) fn orbited(pressed: Observer, motion: Vec2) -> Observer {
    pressed.orbit(f64::from(motion.x) * DEGREES_PER_POINT, f64::from(motion.y) * DEGREES_PER_POINT)
}

/// Moves nearer by `factor` so that the point at `pointer` (pixels) stays there.
pub(in crate::gui::views) fn zoomed_at(observer: Observer, factor: f64, pointer: DVec2, size: Size) -> Observer {
    let from_center = pointer - DVec2::new(f64::from(size.width), f64::from(size.height)) / 2.0;
    let shift = from_center * (1.0 - factor);
    observer.zoom(factor).pan(shift.x, shift.y, size.smaller_side())
}

/// Writes the observer of a picture into a figure. The image has none.
pub(in crate::gui::views) fn set(observers: &mut Observers, view: View, observer: Option<Observer>) {
    match view {
        View::World => observers.world = observer,
        View::Canonical => observers.canonical = observer,
        View::Image => {}
    }
}

#[cfg(test)]
mod tests {
    use eframe::egui::vec2;
    use glam::DVec3;

    use super::*;
    use crate::figure::observer::HALF_VIEW_ANGLE;

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
    fn zoom_keeps_the_point_under_the_pointer() {
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
}
