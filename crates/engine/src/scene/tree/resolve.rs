//! The tree of a scene: names resolved, transforms multiplied out, `[3]` "Descrição da cena", and all of it checked.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DMat3, DMat4, DVec3};

use super::presets;
use crate::appearance::{Rgba, Theme};
use crate::geometry::{Angle, try_unit};
use crate::limits::{MAX_LIGHTS, MAX_SEGMENTS, MAX_SHADOW_TEXELS, MIN_SEGMENTS};
use crate::scene::palette::SceneColors;
use crate::scene::{Light, LightKind, ObjectSpec, SceneError, SceneSpec, Shape};

/// Direction of the default light: from above, behind the usual viewer at (3, 4, 5) and a little to his left, so that
/// the three visible sides of a box differ and none is black.
pub const DEFAULT_LIGHT: DVec3 = DVec3::new(-0.33, -0.755, -0.6);

/// Checks whether a scene can be built from this, apart from its mesh files.
///
/// # Errors
/// [`SceneError`] names the object and its fault.
pub fn check(spec: &SceneSpec) -> Result<(), SceneError> {
    let preset = presets::objects(spec.preset, &SceneColors::of(Theme::Light));
    let placed_preset = place(&preset, &[])?;
    place(&spec.objects, &placed_preset)?;
    for object in spec.objects.iter().filter(|o| o.shape.as_ref().is_some_and(Shape::has_segments)) {
        allowed_segments(object)?;
    }
    lights(&spec.lights).map(|_| ())
}

/// The number of segments of an object, if it's allowed.
pub(crate) fn allowed_segments(spec: &ObjectSpec) -> Result<u32, SceneError> {
    if (MIN_SEGMENTS..=MAX_SEGMENTS).contains(&spec.segments) {
        Ok(spec.segments)
    } else {
        Err(SceneError::Segments { name: spec.name.clone(), found: spec.segments })
    }
}

/// An object whose ancestors have been found.
pub(crate) struct Placed<'a> {
    pub(crate) spec: &'a ObjectSpec,
    pub(crate) world_from_object: DMat4,
    pub(crate) color: Option<Rgba>,
}

/// T · R · S of one object.
///
/// # Errors
/// A value that isn't finite, or a scale of 0.
pub(crate) fn parent_from_object(spec: &ObjectSpec) -> Result<DMat4, SceneError> {
    for (key, v) in [("translate", spec.translate), ("rotate", spec.rotate), ("scale", spec.scale)] {
        if !v.is_finite() {
            return Err(SceneError::NotFinite { name: spec.name.clone(), key });
        }
    }
    if spec.scale.cmpeq(DVec3::ZERO).any() {
        return Err(SceneError::ZeroScale { name: spec.name.clone() });
    }
    let m = rotation(spec.rotate) * DMat3::from_diagonal(spec.scale);
    Ok(DMat4::from_cols(m.x_axis.extend(0.0), m.y_axis.extend(0.0), m.z_axis.extend(0.0), spec.translate.extend(1.0)))
}

/// Rz · Ry · Rx for angles in degrees.
fn rotation(degrees: DVec3) -> DMat3 {
    // Most objects aren't turned, and sines to the last digit take their time.
    if degrees == DVec3::ZERO {
        return DMat3::IDENTITY;
    }
    product_of_rotations(degrees)
}

fn product_of_rotations(degrees: DVec3) -> DMat3 {
    let [(sx, cx), (sy, cy), (sz, cz)] = degrees.to_array().map(|d| Angle::from_degrees(d).sin_cos());
    let rx = DMat3::from_cols_array(&[1.0, 0.0, 0.0, 0.0, cx, sx, 0.0, -sx, cx]);
    let ry = DMat3::from_cols_array(&[cy, 0.0, -sy, 0.0, 1.0, 0.0, sy, 0.0, cy]);
    let rz = DMat3::from_cols_array(&[cz, sz, 0.0, -sz, cz, 0.0, 0.0, 0.0, 1.0]);
    rz * ry * rx
}

/// The index of each object, by its name. The rule that each name is used once.
pub(crate) fn by_name(specs: &[ObjectSpec]) -> Result<BTreeMap<&str, usize>, SceneError> {
    let mut by_name = BTreeMap::new();
    for (i, spec) in specs.iter().enumerate() {
        if by_name.insert(spec.name.as_str(), i).is_some() {
            return Err(SceneError::DuplicateName { name: spec.name.clone() });
        }
    }
    Ok(by_name)
}

/// Multiplies out the tree of `specs`. Parents are looked for among them, then among `others`.
pub(crate) fn place<'a>(specs: &'a [ObjectSpec], others: &[Placed<'_>]) -> Result<Vec<Placed<'a>>, SceneError> {
    let by_name = by_name(specs)?;
    let mut done: Vec<Option<(DMat4, Option<Rgba>)>> = vec![None; specs.len()];
    for start in 0..specs.len() {
        // Up to the first ancestor that is done (or to a root), then down again.
        let mut path = Vec::new();
        let mut on_path = BTreeSet::new();
        let mut above = (DMat4::IDENTITY, None);
        let mut next = Some(start);
        while let Some(i) = next {
            if let Some(known) = done[i] {
                above = known;
                break;
            }
            path.push(i);
            if !on_path.insert(i) {
                let from = path.iter().position(|&k| k == i).unwrap_or(0);
                return Err(SceneError::Cycle { chain: path[from..].iter().map(|&k| specs[k].name.clone()).collect() });
            }
            next = None;
            if let Some(parent) = &specs[i].parent {
                if let Some(&p) = by_name.get(parent.as_str()) {
                    next = Some(p);
                } else if let Some(other) = others.iter().find(|o| &o.spec.name == parent) {
                    above = (other.world_from_object, other.color);
                } else {
                    return Err(SceneError::UnknownParent { name: specs[i].name.clone(), parent: parent.clone() });
                }
            }
        }
        for &i in path.iter().rev() {
            let matrix = above.0 * parent_from_object(&specs[i])?;
            if !matrix.is_finite() {
                return Err(SceneError::NotFinite { name: specs[i].name.clone(), key: "parent" });
            }
            above = (matrix, specs[i].color.or(above.1));
            done[i] = Some(above);
        }
    }
    Ok(specs
        .iter()
        .zip(done)
        .filter_map(|(spec, d)| d.map(|(world_from_object, color)| Placed { spec, world_from_object, color }))
        .collect())
}

/// The lights of a scene. The default one if there is none.
pub(crate) fn lights(specs: &[Light]) -> Result<Vec<Light>, SceneError> {
    if specs.is_empty() {
        return Ok(vec![Light::directional(DEFAULT_LIGHT)]);
    }
    if specs.len() > MAX_LIGHTS {
        return Err(SceneError::TooManyLights { found: specs.len() });
    }
    let texels = specs.iter().map(Light::shadow_texels).fold(0, u64::saturating_add);
    if texels > MAX_SHADOW_TEXELS {
        return Err(SceneError::ShadowMaps { texels });
    }
    let is_right = |light: &Light| match light.kind {
        LightKind::Directional => try_unit(light.vector).is_some(),
        LightKind::Point => light.vector.is_finite(),
    };
    match specs.iter().enumerate().find(|(_, light)| !is_right(light)) {
        Some((index, light)) => Err(SceneError::Light { index, key: light.kind.vector().0 }),
        None => Ok(specs.to_vec()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Shadows;

    #[test]
    fn shadow_maps_have_a_limit_all_together() {
        let shadows = Shadows { map: 4096, ..Shadows::CAST };
        let sun = Light::directional(DVec3::NEG_Y).with_shadows(shadows);
        let lamp = Light::point(DVec3::Y).with_shadows(shadows);
        // 2²⁴ texels each, and six times as many around a lamp.
        assert_eq!(lights(&[sun; 8]).map(|lights| lights.len()), Ok(8));
        assert_eq!(lights(&[sun; 9]), Err(SceneError::ShadowMaps { texels: 9 << 24 }));
        assert!(lights(&[lamp, sun, sun]).is_ok(), "exactly the limit");
        assert_eq!(lights(&[lamp, lamp]), Err(SceneError::ShadowMaps { texels: 12 << 24 }));
        // A light without shadows has no map.
        let plain = Light { shadows: Shadows { cast: false, ..shadows }, ..sun };
        assert!(lights(&[lamp, sun, sun, plain]).is_ok());
    }

    #[test]
    fn what_is_not_turned_is_so_to_the_last_bit() {
        let bits = |m: DMat3| m.to_cols_array().map(f64::to_bits);
        for zero in [DVec3::ZERO, -DVec3::ZERO] {
            assert_eq!(bits(rotation(zero)), bits(DMat3::IDENTITY));
            assert_eq!(product_of_rotations(zero), DMat3::IDENTITY);
        }
        assert_eq!(rotation(DVec3::new(0.0, 0.0, 90.0)) * DVec3::X, DVec3::Y);
    }
}
