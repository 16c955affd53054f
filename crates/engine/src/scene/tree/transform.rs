//! Objects that are moved, turned, scaled and copied together. A transform in the world is stored as the translation,
//! rotation and scale of each.

use std::collections::BTreeSet;

use glam::{DMat4, DQuat, DVec3};

use super::edit::{descendants, free_name, placements, put, tidy};
use crate::geometry::{Angle, try_unit};
use crate::scene::{ObjectSpec, SceneError, SceneSpec};

/// Number of descendants of these objects that aren't among them.
pub fn below(spec: &SceneSpec, names: &BTreeSet<String>) -> usize {
    names
        .iter()
        .flat_map(|name| descendants(spec, name))
        .filter(|name| !names.contains(name))
        .collect::<BTreeSet<_>>()
        .len()
}

/// A transform of objects in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transform {
    /// A translation by this vector (scene units).
    Move(DVec3),
    /// A counter-clockwise rotation about an axis (unit vector) through a point.
    Turn {
        /// On the axis.
        pivot: DVec3,
        /// Towards a viewer who sees the turn as counter-clockwise.
        axis: DVec3,
        /// The angle.
        angle: Angle,
    },
    /// A scale of each along its own axes, from its own place. No factor is 0.
    Scale(DVec3),
}

/// A translation, a rotation and a scale: the matrix T · R · S.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trs {
    /// Scene units.
    pub translate: DVec3,
    /// Degrees about x, then y, then z.
    pub rotate: DVec3,
    /// Factors along its own axes.
    pub scale: DVec3,
}

impl Default for Trs {
    /// No translation, no rotation, scale 1.
    fn default() -> Self {
        Self { translate: DVec3::ZERO, rotate: DVec3::ZERO, scale: DVec3::ONE }
    }
}

/// Puts a figure's object at the end of a chain. It gets the last of `chain`, and between its parent and itself a group
/// for each of the others, called `group`, numbered if the name is taken. Without a chain, or without the object,
/// nothing changes.
///
/// # Errors
/// [`SceneError`] if the scene can't be built afterwards. Nothing has changed then.
pub fn put_on_chain(spec: &mut SceneSpec, name: &str, chain: &[Trs], group: &str) -> Result<(), SceneError> {
    let Some((own, above)) = chain.split_last() else { return Ok(()) };
    let mut changed = spec.clone();
    let Some(mut at) = changed.objects.iter().position(|o| o.name == name) else { return Ok(()) };
    let placed =
        |object: ObjectSpec, Trs { translate, rotate, scale }: Trs| ObjectSpec { translate, rotate, scale, ..object };
    let mut parent = changed.objects[at].parent.clone();
    for trs in above {
        let name = free_name(&changed, group);
        let link = ObjectSpec { parent: parent.replace(name.clone()), ..ObjectSpec::group(name) };
        changed.objects.insert(at, placed(link, *trs));
        at += 1;
    }
    let object = ObjectSpec { parent, ..changed.objects[at].clone() };
    changed.objects[at] = placed(object, *own);
    crate::scene::check(&changed)?;
    *spec = changed;
    Ok(())
}

/// The `names` without an ancestor among them. A transform of these transforms all.
pub fn topmost(spec: &SceneSpec, names: &BTreeSet<String>) -> Vec<String> {
    let below: BTreeSet<String> = names.iter().flat_map(|name| descendants(spec, name)).collect();
    let own = spec.objects.iter().map(|o| &o.name);
    own.filter(|name| names.contains(*name) && !below.contains(*name)).cloned().collect()
}

/// Moves, turns or scales a figure's objects. Their descendants go along.
///
/// Returns true if each could be transformed. Turned below a parent with unequal scales an object would be sheared,
/// which translation, rotation and scale can't express. Such an object stays as it was.
///
/// # Errors
/// [`SceneError`] if the scene can't be built, before or afterwards. Nothing has changed then.
pub fn transform(spec: &mut SceneSpec, names: &BTreeSet<String>, transform: Transform) -> Result<bool, SceneError> {
    let placed = placements(spec)?;
    let mut changed = spec.clone();
    let mut all = true;
    for name in topmost(spec, names) {
        let Some(object) = changed.objects.iter_mut().find(|o| o.name == name) else { continue };
        let world_from_parent =
            object.parent.as_ref().and_then(|parent| placed.get(parent)).copied().unwrap_or(DMat4::IDENTITY);
        match transform {
            Transform::Move(way) => {
                let moved = object.translate + world_from_parent.inverse().transform_vector3(way);
                object.translate = tidy(moved);
            }
            Transform::Turn { pivot, axis, angle } => {
                let turn = DMat4::from_quat(DQuat::from_axis_angle(axis, angle.radians()));
                let about = DMat4::from_translation(pivot) * turn * DMat4::from_translation(-pivot);
                let before = placed.get(&name).copied().unwrap_or(world_from_parent);
                all &= put(object, &(world_from_parent.inverse() * about * before));
            }
            Transform::Scale(factors) => object.scale = tidy(object.scale * factors),
        }
    }
    crate::scene::check(&changed)?;
    *spec = changed;
    Ok(all)
}

/// The direction of parallel light after a turn.
pub fn turned(direction: DVec3, axis: DVec3, angle: Angle) -> DVec3 {
    tidy(DQuat::from_axis_angle(axis, angle.radians()) * direction)
}

/// Copies a figure's objects with all their descendants, each group after its original. Children of a copied object
/// become children of its copy. Returns the names of the copies of the [`topmost`].
pub fn duplicate(spec: &mut SceneSpec, names: &BTreeSet<String>) -> BTreeSet<String> {
    let mut copies = BTreeSet::new();
    for top in topmost(spec, names) {
        let mut members = descendants(spec, &top);
        members.insert(top.clone());
        let originals: Vec<ObjectSpec> = spec.objects.iter().filter(|o| members.contains(&o.name)).cloned().collect();
        let after = spec.objects.iter().rposition(|o| members.contains(&o.name)).map_or(0, |last| last + 1);
        let mut new_names: Vec<(String, String)> = Vec::new();
        for (k, original) in originals.iter().enumerate() {
            let name = free_name(spec, stem(&original.name));
            new_names.push((original.name.clone(), name.clone()));
            spec.objects.insert(after + k, ObjectSpec { name, ..original.clone() });
        }
        for copy in &mut spec.objects[after..after + originals.len()] {
            let hung_on = copy.parent.as_ref().and_then(|parent| new_names.iter().find(|(old, _)| old == parent));
            if let Some((_, new)) = hung_on {
                copy.parent = Some(new.clone());
            }
        }
        copies.extend(new_names.into_iter().find(|(old, _)| *old == top).map(|(_, new)| new));
    }
    copies
}

/// A name without the number that an earlier copy has.
fn stem(name: &str) -> &str {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end();
    if stem.is_empty() { name } else { stem }
}

/// The unit vectors along an object's own axes in the world, and its place. `None` if one has no length.
pub fn frame(world_from_object: &DMat4) -> Option<(DVec3, [DVec3; 3])> {
    let axis = |v: DVec3| try_unit(world_from_object.transform_vector3(v));
    let origin = world_from_object.w_axis.truncate();
    Some((origin, [axis(DVec3::X)?, axis(DVec3::Y)?, axis(DVec3::Z)?])).filter(|_| origin.is_finite())
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;
    use crate::scene::{Preset, Shape};

    fn names(names: &[&str]) -> BTreeSet<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    /// A turned and scaled group with a box and a turned cone, and a ball of its own.
    fn scene() -> SceneSpec {
        SceneSpec {
            preset: Preset::Empty,
            objects: vec![
                ObjectSpec::group("arm").at(1.0, 2.0, 3.0).turned(0.0, 90.0, 0.0).scaled(2.0, 2.0, 2.0),
                ObjectSpec::new("box", Shape::Box).at(0.5, 0.0, 0.0).under("arm"),
                ObjectSpec::new("cone 2", Shape::Cone).at(0.0, 1.0, 0.0).turned(20.0, 30.0, 40.0).under("box"),
                ObjectSpec::new("ball", Shape::Sphere).at(-4.0, 0.0, 0.0),
            ],
            lights: Vec::new(),
        }
    }

    fn places(spec: &SceneSpec, p: DVec3) -> Vec<DVec3> {
        let placed = placements(spec).unwrap();
        spec.objects.iter().map(|o| placed[&o.name].transform_point3(p)).collect()
    }

    fn assert_near(a: &[DVec3], b: &[DVec3]) {
        assert!(a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (*a - *b).length() < 1e-9), "{a:?}\n{b:?}");
    }

    #[test]
    fn all_that_is_chosen_goes_the_same_way_and_what_hangs_on_it_goes_once() {
        let (before, way) = (scene(), DVec3::new(0.3, -1.0, 2.0));
        let mut after = before.clone();
        assert!(transform(&mut after, &names(&["arm", "cone 2", "ball"]), Transform::Move(way)).unwrap());
        let wanted: Vec<DVec3> = places(&before, DVec3::ONE).into_iter().map(|p| p + way).collect();
        assert_near(&places(&after, DVec3::ONE), &wanted);
        assert_eq!(after.objects[1..3], before.objects[1..3], "they are told from their parent");
        // Below a turned and scaled parent: the group's −2 z is the world's x.
        let mut after = before.clone();
        transform(&mut after, &names(&["box"]), Transform::Move(DVec3::new(1.0, 0.0, 0.0))).unwrap();
        assert_eq!(after.objects[1].translate, DVec3::new(0.5, 0.0, 0.5));
    }

    #[test]
    fn they_turn_together_about_one_axis() {
        let (before, pivot) = (scene(), DVec3::new(1.0, 0.0, -2.0));
        let mut after = before.clone();
        let turn = Transform::Turn { pivot, axis: DVec3::Y, angle: Angle::from_degrees(90.0) };
        assert!(transform(&mut after, &names(&["arm", "ball"]), turn).unwrap());
        // Counter-clockwise from above: x goes to −z.
        let quarter = |p: DVec3| pivot + DVec3::new((p - pivot).z, (p - pivot).y, -(p - pivot).x);
        let wanted: Vec<DVec3> = places(&before, DVec3::ONE).into_iter().map(quarter).collect();
        assert_near(&places(&after, DVec3::ONE), &wanted);
        assert_eq!(after.objects[0].rotate, DVec3::new(0.0, 180.0, 0.0), "without digits that rounding makes");

        // A shear can't be stored.
        let mut flat = before.clone();
        flat.objects[0].scale = DVec3::new(3.0, 1.0, 1.0);
        let untouched = flat.clone();
        let slanted = Transform::Turn { pivot, axis: DVec3::X, angle: Angle::from_degrees(45.0) };
        assert!(!transform(&mut flat, &names(&["box"]), slanted).unwrap());
        assert_eq!(flat, untouched);
    }

    #[test]
    fn each_is_scaled_along_its_own_axes_and_not_to_nothing() {
        let mut after = scene();
        transform(&mut after, &names(&["box", "ball"]), Transform::Scale(DVec3::new(1.0, 0.5, 1.0))).unwrap();
        assert_eq!(after.objects[1].scale, DVec3::new(1.0, 0.5, 1.0));
        assert_eq!(after.objects[3].scale, DVec3::new(1.0, 0.5, 1.0));
        let before = after.clone();
        assert!(transform(&mut after, &names(&["box"]), Transform::Scale(DVec3::ZERO)).is_err());
        assert_eq!(after, before);
    }

    #[test]
    fn a_chain_is_groups_above_an_object() {
        let mut spec = scene();
        let before = spec.clone();
        let along = |x: f64| Trs { translate: DVec3::new(x, 0.0, 0.0), ..Trs::default() };
        let chain = [along(1.0), Trs { scale: DVec3::splat(2.0), ..Trs::default() }, along(3.0)];
        put_on_chain(&mut spec, "box", &chain, "arm").unwrap();
        let hung: Vec<(&str, Option<&str>)> =
            spec.objects.iter().map(|o| (o.name.as_str(), o.parent.as_deref())).collect();
        assert_eq!(
            hung[..5],
            [
                ("arm", None),
                ("arm 2", Some("arm")),
                ("arm 3", Some("arm 2")),
                ("box", Some("arm 3")),
                ("cone 2", Some("box"))
            ]
        );
        let parent = placements(&before).unwrap()["arm"];
        let wanted = parent.transform_point3(DVec3::new(1.0 + 2.0 * 3.0, 0.0, 0.0));
        assert_near(&[placements(&spec).unwrap()["box"].w_axis.truncate()], &[wanted]);
        // One link alone is the object's own. One that is scaled to nothing is refused.
        let mut one = before.clone();
        put_on_chain(&mut one, "ball", &[along(7.0)], "group").unwrap();
        assert!(one.objects.len() == 4 && one.objects[3].translate.x == 7.0);
        let flat = Trs { scale: DVec3::new(1.0, 0.0, 1.0), ..Trs::default() };
        assert!(put_on_chain(&mut spec, "ball", &[flat, along(1.0)], "group").is_err());
        assert_eq!(spec.objects.len(), 6);
    }

    #[test]
    fn a_copy_takes_its_children_along() {
        let mut spec = scene();
        let copies = duplicate(&mut spec, &names(&["arm", "box", "ball"]));
        assert_eq!(copies, names(&["arm 2", "ball 2"]));
        let all: Vec<(&str, Option<&str>)> =
            spec.objects.iter().map(|o| (o.name.as_str(), o.parent.as_deref())).collect();
        assert_eq!(
            all,
            [
                ("arm", None),
                ("box", Some("arm")),
                ("cone 2", Some("box")),
                ("arm 2", None),
                ("box 2", Some("arm 2")),
                ("cone", Some("box 2")),
                ("ball", None),
                ("ball 2", None),
            ]
        );
        let places = places(&spec, DVec3::ONE);
        assert_near(&places[..3], &places[3..6]);
    }
}
