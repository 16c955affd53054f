//! Parameters that make no camera. There's nothing to draw, but the error is a finding, and most have a repair.

use glam::DVec3;

use super::{Cause, Counter, Diagnosis, Finding, Repair};
use crate::appearance::Style;
use crate::camera::{Camera, CameraError, Checked, ImageSize, ParameterKey, Parameters, camera_repairs};
use crate::figure::Reveal;
use crate::scene::Scene;

/// Parameters that make no camera, and the desired image.
#[derive(Clone, Debug, PartialEq)]
pub struct ImpossibleCamera {
    /// The reason why they make none.
    pub error: CameraError,
    /// The parameters after the repair.
    pub parameters: Parameters,
    /// The style of the image.
    pub style: Style,
    /// The inner work of the pipeline in the image.
    pub reveal: Reveal,
    /// In pixels, after the repair.
    pub image: ImageSize,
}

/// The finding about parameters that make no camera. Its repair is the first one whose image shows the scene, or the
/// first one at all.
pub fn impossible_camera(impossible: &ImpossibleCamera, scene: &Scene) -> Diagnosis {
    let ImpossibleCamera { error, parameters, style, reveal, image } = impossible;
    let mut counter = Counter::default();
    let mut shows = |camera: &Parameters| {
        let camera = Camera::new(camera).ok();
        let drawn = camera.and_then(|camera| counter.draw(scene, &camera, style, *image));
        drawn.is_some_and(|drawn| drawn.pixels > 0)
    };
    let repairs = fallback(parameters, scene).map(|good| camera_repairs(error, parameters, &good));
    let repairs: Vec<Parameters> = repairs.unwrap_or_default().into_iter().map(|(_, camera)| camera).collect();
    let best = repairs.iter().copied().find(|camera| shows(camera)).or(repairs.first().copied());
    let repair = best.map(|camera| Repair { camera, style: *style, reveal: *reveal, shadow_bias: None });
    let finding = Finding { cause: cause(error), whole: Vec::new(), partly: Vec::new(), repair, pixels: None };
    Diagnosis {
        visible: 0,
        covered: 0.0,
        placed_within: 0.0,
        findings: vec![finding],
        infinite_faces: 0,
        camera_error: Some(error.clone()),
    }
}

const fn cause(error: &CameraError) -> Cause {
    match error {
        CameraError::FocalPointAtPosition => Cause::FocalPointAtPosition,
        CameraError::ViewUpZero | CameraError::ViewUpCollinear => Cause::ViewUpAlongView,
        CameraError::FarNotBeyondNear { .. }
        | CameraError::OutOfRange { key: Checked::Parameter(ParameterKey::Near | ParameterKey::Far), .. } => {
            Cause::NearBeyondFar
        }
        CameraError::OutOfRange { key: Checked::Parameter(ParameterKey::ViewAngle), .. } => Cause::ViewAngleRange,
        _ => Cause::CameraValue,
    }
}

/// A camera at C, if that's possible, that looks at the middle of the scene.
fn fallback(parameters: &Parameters, scene: &Scene) -> Option<Camera> {
    let default = Parameters::default();
    let middle = scene.bounds().map_or(DVec3::ZERO, |bounds| bounds.center());
    let towards = [middle, parameters.position - DVec3::Z];
    let looking = towards.map(|focal_point| Parameters { position: parameters.position, focal_point, ..default });
    let upright = looking.into_iter().flat_map(|p| [DVec3::Y, DVec3::Z].map(|view_up| Parameters { view_up, ..p }));
    upright.chain([default]).find_map(|p| Camera::new(&p).ok())
}
