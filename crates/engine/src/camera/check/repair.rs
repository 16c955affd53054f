//! Repairs of parameters that make no camera, for `diagnose` and for the buttons next to a field.

use glam::DVec3;

use crate::camera::{Camera, CameraError, Checked, ParameterKey, Parameters};

/// A change of [`Parameters`] after which they make a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CameraRepair {
    /// PF goes back to where the camera looked last.
    FocalPointAhead,
    /// VUP becomes this axis.
    ViewUp(DVec3),
    /// F and B change places.
    SwapNearFar,
    /// B = 10 F.
    FarTenTimesNear,
    /// θ becomes this.
    ViewAngle(f64),
    /// l and r, or b and t, change places.
    SwapSides,
    /// All parameters at fault go back to their last possible values.
    Back,
}

/// The usual θ in degrees, for an angle out of its range.
const USUAL_DEGREES: f64 = 45.0;

/// Lists the repairs of `draft`, the best first. `good` is a camera to fall back on: the last one that was possible.
/// Each repair gives parameters that [`Camera::new`] accepts.
pub fn camera_repairs(error: &CameraError, draft: &Parameters, good: &Camera) -> Vec<(CameraRepair, Parameters)> {
    let mut list = Vec::new();
    match error {
        CameraError::FocalPointAtPosition => {
            let ahead = good.focal_point() - good.position();
            list.push((CameraRepair::FocalPointAhead, Parameters { focal_point: draft.position + ahead, ..*draft }));
        }
        CameraError::ViewUpZero | CameraError::ViewUpCollinear => {
            let forward = (draft.focal_point - draft.position).abs();
            // The most usual axis first, unless the camera looks along it.
            let axis = [DVec3::Y, DVec3::Z, DVec3::X]
                .into_iter()
                .find(|axis| forward.dot(*axis) < 0.9 * forward.length())
                .unwrap_or(DVec3::Y);
            list.push((CameraRepair::ViewUp(axis), Parameters { view_up: axis, ..*draft }));
        }
        CameraError::FarNotBeyondNear { near, far } => {
            list.push((CameraRepair::SwapNearFar, Parameters { near: *far, far: *near, ..*draft }));
            list.push((CameraRepair::FarTenTimesNear, Parameters { far: 10.0 * near, ..*draft }));
        }
        CameraError::OutOfRange { key: Checked::Parameter(ParameterKey::ViewAngle), .. } => {
            let view_angle = USUAL_DEGREES;
            list.push((CameraRepair::ViewAngle(view_angle), Parameters { view_angle, ..*draft }));
        }
        CameraError::WindowWidth { .. } | CameraError::WindowHeight { .. } => {
            let mut mended = *draft;
            if let Some(w) = &mut mended.window {
                if w.left > w.right {
                    std::mem::swap(&mut w.left, &mut w.right);
                }
                if w.bottom > w.top {
                    std::mem::swap(&mut w.bottom, &mut w.top);
                }
            }
            list.push((CameraRepair::SwapSides, mended));
        }
        CameraError::OutOfRange { .. } | CameraError::Overflow { .. } => {}
    }
    list.push((CameraRepair::Back, back(error.parameters(), draft, good.parameters())));
    list.retain(|(_, mended)| Camera::new(mended).is_ok());
    if list.is_empty() {
        list.push((CameraRepair::Back, *good.parameters()));
    }
    list
}

/// `draft` with these parameters taken from `good`, or all parameters if none are given.
fn back(keys: &[ParameterKey], draft: &Parameters, good: &Parameters) -> Parameters {
    let mut mended = if keys.is_empty() { *good } else { *draft };
    keys.iter().for_each(|key| key.copy(good, &mut mended));
    mended
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::ViewWindow;

    fn mend(change: impl FnOnce(&mut Parameters)) -> Vec<(CameraRepair, Parameters)> {
        let good = Camera::new(&Parameters::default()).unwrap_or_else(|e| panic!("{e}"));
        let mut draft = *good.parameters();
        change(&mut draft);
        let error = Camera::new(&draft).err().unwrap_or_else(|| panic!("{draft:?} is possible"));
        let list = camera_repairs(&error, &draft, &good);
        assert!(!list.is_empty());
        for (repair, mended) in &list {
            assert!(Camera::new(mended).is_ok(), "{repair:?} leaves {mended:?}");
        }
        list
    }

    #[test]
    fn collinear_up_takes_another_axis() {
        let list = mend(|p| (p.position, p.view_up) = (DVec3::new(0.0, 5.0, 0.0), DVec3::Y));
        assert_eq!(list[0].0, CameraRepair::ViewUp(DVec3::Z));
        let list = mend(|p| p.view_up = DVec3::ZERO);
        assert_eq!(list[0].0, CameraRepair::ViewUp(DVec3::Y));
    }

    #[test]
    fn near_behind_far_is_moved_or_swapped() {
        let list = mend(|p| (p.near, p.far) = (8.0, 2.0));
        assert_eq!((list[0].1.near, list[0].1.far), (2.0, 8.0));
        assert_eq!(list[1].1.far, 80.0);
        let list = mend(|p| (p.near, p.far) = (3.0, 3.0));
        assert_eq!(
            list.iter().map(|(r, _)| *r).collect::<Vec<_>>(),
            [CameraRepair::FarTenTimesNear, CameraRepair::Back]
        );
    }

    #[test]
    fn every_other_fault_has_a_way_back() {
        assert_eq!(mend(|p| p.view_angle = 200.0)[0].0, CameraRepair::ViewAngle(USUAL_DEGREES));
        assert_eq!(mend(|p| p.view_angle = -3.0)[0].0, CameraRepair::ViewAngle(USUAL_DEGREES));
        assert_eq!(mend(|p| p.focal_point = p.position)[0].0, CameraRepair::FocalPointAhead);
        let sides = ViewWindow { left: 1.0, right: -1.0, bottom: -1.0, top: 1.0 };
        let list = mend(|p| p.window = Some(sides));
        assert_eq!(list[0].1.window.map(|w| (w.left, w.right)), Some((-1.0, 1.0)));
        for change in [
            |p: &mut Parameters| p.near = 0.0,
            |p: &mut Parameters| p.near = f64::NAN,
            |p: &mut Parameters| p.far = -1.0,
            |p: &mut Parameters| p.aspect = 0.0,
            |p: &mut Parameters| p.position.x = f64::INFINITY,
            |p: &mut Parameters| (p.near, p.view_angle) = (-1.0, 500.0),
        ] {
            mend(change);
        }
    }
}
