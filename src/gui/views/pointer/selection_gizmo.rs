//! The effect of the gizmo in the world on the selection.

use std::collections::BTreeSet;

use glam::{DMat4, DVec3};

use crate::geometry::{Angle, try_unit};
use crate::numbers::round_to;
use crate::scene::edit::placement;
use crate::scene::transform::{Transform, frame, transform, turned};
use crate::scene::{Light, LightKind, SceneError, SceneSpec};
use crate::views::transform_gizmo::Pull;
use crate::views::{GizmoPart, TransformGizmo, Transforming};
use camera_lab_desk::{Model, Selected};

/// The step of turns while the modifier is held, in degrees.
const SNAP_TURN: f64 = 15.0;
/// The step of scales while the modifier is held.
const SNAP_SCALE: f64 = 0.1;

/// The selection, if it can be moved, turned or scaled.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::gui) struct Movable {
    what: MovedThing,
    /// The gizmo's place and orientation.
    pub(in crate::gui) gizmo: TransformGizmo,
    /// The length in the world of a unit along each of its parent's axes.
    units: [f64; 3],
    /// Its place in the figure. For a parallel light, its direction.
    pub(in crate::gui) place: DVec3,
    /// Its angles in degrees.
    pub(in crate::gui) rotate: DVec3,
    /// Its factors.
    pub(in crate::gui) scale: DVec3,
}

#[derive(Clone, Debug, PartialEq)]
enum MovedThing {
    Objects(BTreeSet<String>),
    /// A light, by its place in the list.
    Light(usize),
}

impl Movable {
    /// The selection, if it can be changed.
    pub(in crate::gui) fn selected(model: &Model) -> Option<Self> {
        let scene = &model.desk.shown.figure().scene;
        match model.tree.selected(scene)? {
            Selected::Object(name) => Self::objects(scene, name, model.tree.names(scene), model.tree.transforming),
            Selected::Light(index) => {
                let middle = model.scene_cache.scene().bounds().map_or(DVec3::ZERO, |bounds| bounds.center());
                Some(Self::light(*index, *scene.lights.get(*index)?, middle))
            }
            Selected::OfPreset(_) => None,
        }
    }

    /// Moved and turned along the axes of the parent of `primary`, scaled along its own.
    fn objects(scene: &SceneSpec, primary: &str, names: BTreeSet<String>, does: Transforming) -> Option<Self> {
        let object = scene.objects.iter().find(|o| o.name == primary)?;
        let world_from_object = placement(scene, primary).ok()??;
        let world_from_parent = match &object.parent {
            Some(parent) => placement(scene, parent).ok()??,
            None => DMat4::IDENTITY,
        };
        let (_, of_parent) = frame(&world_from_parent)?;
        let (origin, own) = frame(&world_from_object)?;
        let axes = if does == Transforming::Scale { own } else { of_parent };
        let units = DVec3::AXES.map(|axis| world_from_parent.transform_vector3(axis).length());
        Some(Self {
            what: MovedThing::Objects(names),
            gizmo: TransformGizmo { does, origin, axes, hovered: None },
            units,
            place: object.translate,
            rotate: object.rotate,
            scale: object.scale,
        })
    }

    /// Moves a lamp, or turns parallel light about `middle`.
    fn light(index: usize, light: Light, middle: DVec3) -> Self {
        let (does, origin) = match light.kind {
            LightKind::Point => (Transforming::Move, light.vector),
            LightKind::Directional => (Transforming::Turn, middle),
        };
        Self {
            what: MovedThing::Light(index),
            gizmo: TransformGizmo { does, origin, axes: DVec3::AXES, hovered: None },
            units: [1.0; 3],
            place: light.vector,
            rotate: DVec3::ZERO,
            scale: DVec3::ONE,
        }
    }

    /// True for a light, whose axes are those of the world.
    pub(in crate::gui) fn is_light(&self) -> bool {
        !matches!(self.what, MovedThing::Objects(_))
    }

    /// Number of objects transformed together.
    pub(in crate::gui) fn count(&self) -> usize {
        if let MovedThing::Objects(names) = &self.what { names.len() } else { 1 }
    }

    /// The scene after a part of the gizmo has been pulled, beginning with `before`, the scene when it was taken, and
    /// true if all objects could follow. Rounds away digits smaller than a pixel. With `snap`, moves are multiples of
    /// it, turns of 15°, scales of 0.1.
    ///
    /// `None` if there is nothing to change.
    ///
    /// # Errors
    /// [`SceneError`] if the scene can't be built with it.
    pub(in crate::gui) fn pulled(
        &self,
        before: &SceneSpec,
        part: GizmoPart,
        pull: Pull,
        snap: Option<f64>,
    ) -> Result<Option<(SceneSpec, bool)>, SceneError> {
        let Some(change) = self.change(part, pull, snap) else { return Ok(None) };
        let mut scene = before.clone();
        let all = match (&self.what, change) {
            (MovedThing::Objects(names), change) => transform(&mut scene, names, change)?,
            (MovedThing::Light(index), change) => {
                let vector = match change {
                    Transform::Move(way) => self.place + way,
                    Transform::Turn { axis, angle, .. } => turned(self.place, axis, angle),
                    Transform::Scale(_) => return Ok(None),
                };
                if let Some(light) = scene.lights.get_mut(*index) {
                    light.vector = vector;
                }
                true
            }
        };
        Ok(Some((scene, all)))
    }

    fn change(&self, part: GizmoPart, pull: Pull, snap: Option<f64>) -> Option<Transform> {
        let axis = match part {
            GizmoPart::Axis(axis) => axis,
            GizmoPart::Middle => 0,
        };
        match pull {
            Pull::Along { way, pixel } => {
                let unit = self.units[axis];
                let wanted = round_to(self.place[axis] + way / unit, snap.unwrap_or(pixel / unit));
                Some(Transform::Move(self.gizmo.axes[axis] * ((wanted - self.place[axis]) * unit)))
            }
            Pull::Round { angle, pixel } => {
                let degrees = match snap {
                    Some(_) => (angle.degrees() / SNAP_TURN).round() * SNAP_TURN,
                    None => round_to(angle.degrees(), pixel.degrees()),
                };
                let axis = try_unit(self.gizmo.axes[axis])?;
                Some(Transform::Turn { pivot: self.gizmo.origin, axis, angle: Angle::from_degrees(degrees) })
            }
            Pull::Times { factor, pixel } => {
                let before = self.scale[axis];
                let finest = if snap.is_some() { SNAP_SCALE } else { pixel * before.abs() };
                let wanted = round_to(before * factor, finest);
                // Avoids scaling to zero.
                let factor = wanted / before;
                let factor = Some(factor).filter(|factor| factor.is_finite() && *factor > 0.0)?;
                Some(Transform::Scale(match part {
                    GizmoPart::Middle => DVec3::splat(factor),
                    GizmoPart::Axis(axis) => DVec3::ONE + DVec3::AXES[axis] * (factor - 1.0),
                }))
            }
        }
    }
}
