//! Edits of the scene of a figure: objects moved to another parent, renamed and removed, a preset expanded into a list.
//!
//! An object is known by its name. Parents are looked for among a figure's own objects, then among those of its preset.
//! A change here never leaves an object whose parent doesn't exist.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DMat3, DMat4, DVec3, EulerRot};

use super::presets;
use super::resolve::{by_name, parent_from_object, place};
use crate::appearance::Theme;
use crate::scene::palette::SceneColors;
use crate::scene::{ObjectSpec, Preset, SceneError, SceneSpec};

/// The fate of the children of a removed object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Children {
    /// They are removed with it, and theirs with them.
    Removed,
    /// Its parent becomes theirs. They stay where they are in the world, if translation, rotation and scale can express
    /// that.
    HungHigher,
}

/// The matrix world ← object of every object of a scene, by name. If a figure's object and one of the preset have the
/// same name, it's the figure's.
///
/// # Errors
/// [`SceneError`], as for building the scene.
pub fn placements(spec: &SceneSpec) -> Result<BTreeMap<String, DMat4>, SceneError> {
    let preset = presets::objects(spec.preset, &SceneColors::of(Theme::Light));
    let placed_preset = place(&preset, &[])?;
    let placed_own = place(&spec.objects, &placed_preset)?;
    let all = placed_preset.iter().chain(&placed_own);
    Ok(all.map(|placed| (placed.spec.name.clone(), placed.world_from_object)).collect())
}

/// The object of a scene with this name, the figure's before the preset's.
pub fn object_named(spec: &SceneSpec, name: &str) -> Option<ObjectSpec> {
    let own = spec.objects.iter().find(|object| object.name == name).cloned();
    let of_preset = || presets::objects(spec.preset, &SceneColors::of(Theme::Light)).into_iter();
    own.or_else(|| of_preset().find(|object| object.name == name))
}

/// Like [`placements`], for one object alone, without a look at objects that it doesn't hang on. `None` if there is
/// none of this name.
///
/// # Errors
/// [`SceneError`] of the object, or of one that it hangs on.
pub fn placement(spec: &SceneSpec, name: &str) -> Result<Option<DMat4>, SceneError> {
    let preset = presets::objects(spec.preset, &SceneColors::of(Theme::Light));
    let placed_preset = place(&preset, &[])?;
    let Some(own) = spec.objects.iter().find(|object| object.name == name) else {
        return Ok(placed_preset.iter().find(|placed| placed.spec.name == name).map(|placed| placed.world_from_object));
    };
    let mut chain = vec![own.clone()];
    let mut known = BTreeSet::from([own.name.as_str()]);
    // Most objects hang on none.
    let by_name = if own.parent.is_some() { by_name(&spec.objects)? } else { BTreeMap::new() };
    let mut next = own.parent.as_deref().and_then(|parent| by_name.get(parent));
    while let Some(above) = next.and_then(|&above| spec.objects.get(above)).filter(|above| known.insert(&above.name)) {
        chain.push(above.clone());
        next = above.parent.as_deref().and_then(|parent| by_name.get(parent));
    }
    Ok(place(&chain, &placed_preset)?.first().map(|placed| placed.world_from_object))
}

/// The requested name if no object has it, else with the first number that makes it free.
pub fn free_name(spec: &SceneSpec, wanted: &str) -> String {
    let taken = names(spec);
    let numbered = (2..).map(|k| format!("{wanted} {k}"));
    std::iter::once(wanted.to_owned()).chain(numbered).find(|name| !taken.contains(name)).unwrap_or_default()
}

/// All names of a scene, those of the preset too.
fn names(spec: &SceneSpec) -> BTreeSet<String> {
    preset_names(spec).chain(spec.objects.iter().map(|o| o.name.clone())).collect()
}

fn preset_names(spec: &SceneSpec) -> impl Iterator<Item = String> {
    presets::objects(spec.preset, &SceneColors::of(Theme::Light)).into_iter().map(|object| object.name)
}

/// The names of the figure's objects below the one called `name`, at any depth. Not itself.
pub fn descendants(spec: &SceneSpec, name: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut above = vec![name.to_owned()];
    while let Some(parent) = above.pop() {
        for child in spec.objects.iter().filter(|o| o.parent.as_ref() == Some(&parent)) {
            if child.name != name && found.insert(child.name.clone()) {
                above.push(child.name.clone());
            }
        }
    }
    found
}

/// Renames an object of a figure. Its children follow.
///
/// # Errors
/// [`SceneError::DuplicateName`] if another object, also one of the preset, already has this name, because its children
/// would become children of this one. Nothing has changed then.
pub fn rename(spec: &mut SceneSpec, from: &str, to: &str) -> Result<(), SceneError> {
    if from == to {
        return Ok(());
    }
    if preset_names(spec).any(|name| name == to) {
        return Err(SceneError::DuplicateName { name: to.to_owned() });
    }
    let mut objects = spec.objects.clone();
    for object in &mut objects {
        if object.name == from {
            to.clone_into(&mut object.name);
        }
        if object.parent.as_deref() == Some(from) {
            object.parent = Some(to.to_owned());
        }
    }
    by_name(&objects)?;
    spec.objects = objects;
    Ok(())
}

/// Gives a figure's object another parent, or none. With `stay` it gets the numbers that keep it in place in the world.
/// Otherwise it keeps its numbers and moves with its new parent.
///
/// Returns true if `stay` could be satisfied. A scale along axes that the new parent has turned is a shear, which
/// translation, rotation and scale can't express. The numbers stay then.
///
/// # Errors
/// [`SceneError`] if the parent doesn't exist or is below the object. Nothing has changed then.
pub fn hang(spec: &mut SceneSpec, name: &str, parent: Option<&str>, stay: bool) -> Result<bool, SceneError> {
    let before = placements(spec)?;
    let mut changed = spec.clone();
    let Some(object) = changed.objects.iter_mut().find(|o| o.name == name) else { return Ok(true) };
    object.parent = parent.map(str::to_owned);
    let mut stayed = true;
    if stay {
        let parent_from_world = match parent {
            Some(parent) => before.get(parent).copied().unwrap_or(DMat4::IDENTITY).inverse(),
            None => DMat4::IDENTITY,
        };
        let wanted = before.get(name).map(|world_from_object| parent_from_world * *world_from_object);
        stayed = wanted.is_some_and(|wanted| put(object, &wanted));
    }
    placements(&changed)?;
    *spec = changed;
    Ok(stayed)
}

/// Removes a figure's object. True if all remaining objects stay where they are in the world.
///
/// # Errors
/// [`SceneError`] if the scene could not be built before. Nothing has changed then.
pub fn remove(spec: &mut SceneSpec, name: &str, children: Children) -> Result<bool, SceneError> {
    let mut changed = spec.clone();
    let mut stayed = true;
    match children {
        Children::Removed => {
            let below = descendants(spec, name);
            changed.objects.retain(|o| o.name != name && !below.contains(&o.name));
        }
        Children::HungHigher => {
            let parent = spec.objects.iter().find(|o| o.name == name).and_then(|o| o.parent.clone());
            let direct = spec.objects.iter().filter(|o| o.parent.as_deref() == Some(name));
            for child in direct {
                stayed &= hang(&mut changed, &child.name, parent.as_deref(), true)?;
            }
            changed.objects.retain(|o| o.name != name);
        }
    }
    *spec = changed;
    Ok(stayed)
}

/// Chooses another preset. A figure's objects whose parent was one of the old preset's have none then.
pub fn choose_preset(spec: &mut SceneSpec, preset: Preset) {
    spec.preset = preset;
    let known = names(spec);
    for object in &mut spec.objects {
        object.parent = object.parent.take().filter(|parent| known.contains(parent));
    }
}

/// Writes the preset's objects into the figure's list, before its own, so that they can be edited. The preset is then
/// empty. The objects have the colours of `theme` and the names that `called` gives them, numbered if a name is taken.
/// The features that [`Preset::beyond_objects`] names are lost. Returns the new name of each.
pub fn write_out_preset(
    spec: &mut SceneSpec,
    theme: Theme,
    called: impl Fn(&str) -> String,
) -> BTreeMap<String, String> {
    let mut objects = presets::objects(spec.preset, &SceneColors::of(theme));
    let own: BTreeSet<String> = spec.objects.iter().map(|o| o.name.clone()).collect();
    let wanted: BTreeSet<String> = objects.iter().map(|o| called(&o.name)).collect();
    let mut names: BTreeMap<String, String> = BTreeMap::new();
    let mut taken = own.clone();
    for object in &objects {
        let name = called(&object.name);
        let numbered = (2..).map(|k| format!("{name} {k}")).filter(|n| !wanted.contains(n));
        let free = std::iter::once(name.clone()).chain(numbered).find(|n| !taken.contains(n)).unwrap_or_default();
        taken.insert(free.clone());
        names.insert(object.name.clone(), free);
    }
    let renamed = |name: &str| names.get(name).cloned().unwrap_or_else(|| name.to_owned());
    for object in &mut objects {
        object.name = renamed(&object.name);
        object.parent = object.parent.as_deref().map(renamed);
    }
    // Children of an object of the preset remain its children.
    for object in &mut spec.objects {
        object.parent =
            object.parent.take().map(|parent| if own.contains(&parent) { parent } else { renamed(&parent) });
    }
    objects.append(&mut spec.objects);
    *spec = SceneSpec { preset: Preset::Empty, objects, lights: std::mem::take(&mut spec.lights) };
    names
}

/// Gives an object the translation, rotation and scale that make this matrix parent ← object. False if there are none,
/// and then nothing changes.
pub(crate) fn put(object: &mut ObjectSpec, parent_from_object_wanted: &DMat4) -> bool {
    let wanted = DMat3::from_mat4(*parent_from_object_wanted);
    let mut lengths = DVec3::new(wanted.x_axis.length(), wanted.y_axis.length(), wanted.z_axis.length());
    if wanted.determinant() < 0.0 {
        // The mirrored axis stays the one that was mirrored before.
        let mirrored = (0..3).find(|&i| object.scale[i] < 0.0).unwrap_or(0);
        lengths[mirrored] = -lengths[mirrored];
    }
    let turned = DMat3::from_cols(wanted.x_axis / lengths.x, wanted.y_axis / lengths.y, wanted.z_axis / lengths.z);
    let (z, y, x) = turned.to_euler(EulerRot::ZYX);
    let put = ObjectSpec {
        translate: tidy(parent_from_object_wanted.w_axis.truncate()),
        rotate: tidy_angles(nearest_angles(DVec3::new(x, y, z).map(f64::to_degrees), object.rotate)),
        scale: tidy(lengths),
        ..object.clone()
    };
    let Ok(got) = parent_from_object(&put) else { return false };
    let error = |a: DMat3, b: DMat3| (a - b).to_cols_array().iter().fold(0.0_f64, |most, e| most.max(e.abs()));
    let far = (put.translate - parent_from_object_wanted.w_axis.truncate()).abs().max_element();
    let largest = lengths.abs().max_element();
    let exact = error(DMat3::from_mat4(got), wanted) <= 1e-9 * largest
        && far <= 1e-9 * parent_from_object_wanted.w_axis.truncate().abs().max_element();
    if exact {
        *object = put;
    }
    exact
}

/// Drops the last digits, which are rounding. 12 of the largest component's digits stay.
pub(crate) fn tidy(v: DVec3) -> DVec3 {
    let unit = 10_f64.powi(12 - magnitude(v.abs().max_element()));
    let rounded = v.map(|x| (x * unit).round() / unit + 0.0);
    if rounded.is_finite() && (rounded - v).abs().max_element() <= 1e-11 * v.abs().max_element() { rounded } else { v }
}

/// The angles (degrees about x, y, z) nearest to the ones before that express the same rotation as these. A rotation
/// about one axis alone stays so, and nothing jumps by whole turns.
fn nearest_angles(angles: DVec3, before: DVec3) -> DVec3 {
    let other = DVec3::new(angles.x + 180.0, 180.0 - angles.y, angles.z + 180.0);
    let near = |a: DVec3| a - 360.0 * ((a - before) / 360.0).round();
    let far = |a: DVec3| (a - before).abs().element_sum();
    let (first, second) = (near(angles), near(other));
    if far(first) <= far(second) { first } else { second }
}

/// Degrees with ten decimals.
fn tidy_angles(v: DVec3) -> DVec3 {
    v.map(|x| (x * 1e10).round() / 1e10 + 0.0)
}

/// The number of digits before the decimal point.
#[expect(clippy::cast_possible_truncation, reason = "a logarithm of an f64 is within ±324")]
fn magnitude(x: f64) -> i32 {
    if x > 0.0 { x.log10().ceil() as i32 } else { 0 }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;
    use crate::appearance::Style;
    use crate::scene::{Scene, Shape, build};

    fn built(spec: &SceneSpec, theme: Theme) -> Scene {
        let style = Style { theme, ..Style::default() };
        build(spec, &style, &mut crate::scene::no_files).unwrap()
    }

    fn objects(objects: Vec<ObjectSpec>) -> SceneSpec {
        SceneSpec { preset: Preset::Empty, objects, lights: Vec::new() }
    }

    /// An arm of three links, each turned and moved.
    fn arm() -> SceneSpec {
        let link = |name: &str| ObjectSpec::new(name, Shape::Cylinder).at(0.5, 2.0, -0.25).turned(10.0, 20.0, 30.0);
        objects(vec![
            ObjectSpec::group("arm").at(1.0, 2.0, 3.0).turned(0.0, 35.0, 0.0).scaled(2.0, 2.0, 2.0),
            link("upper").under("arm"),
            link("lower").under("upper"),
            link("hand").under("lower").scaled(1.0, 0.5, -0.25),
        ])
    }

    #[test]
    fn one_object_stands_where_all_of_them_do() {
        let mut scenes = vec![arm(), SceneSpec { preset: Preset::House, ..arm() }];
        let preset = preset_names(&scenes[1]).next().unwrap();
        scenes[1].objects[0].parent = Some(preset.clone());
        for scene in &scenes {
            for (name, matrix) in placements(scene).unwrap() {
                assert_eq!(placement(scene, &name).unwrap(), Some(matrix), "{name}");
            }
            assert_eq!(placement(scene, "nobody").unwrap(), None);
        }
        let mut circle = arm();
        circle.objects[0].parent = Some("hand".to_owned());
        assert!(matches!(placement(&circle, "upper"), Err(SceneError::Cycle { .. })));
        circle.objects[0].parent = Some("nobody".to_owned());
        assert!(matches!(placement(&circle, "hand"), Err(SceneError::UnknownParent { .. })));
    }

    fn assert_same_place(before: &SceneSpec, after: &SceneSpec, names: &[&str]) {
        let (a, b) = (placements(before).unwrap(), placements(after).unwrap());
        for name in names {
            let error = (a[*name] - b[*name]).to_cols_array().iter().fold(0.0_f64, |m, e| m.max(e.abs()));
            assert!(error < 1e-9, "{name} has moved by {error}");
        }
    }

    #[test]
    fn what_is_hung_elsewhere_stays_where_it_is() {
        let before = arm();
        for parent in [None, Some("arm"), Some("upper")] {
            let mut after = before.clone();
            assert!(hang(&mut after, "hand", parent, true).unwrap());
            assert_eq!(after.objects[3].parent.as_deref(), parent);
            assert_same_place(&before, &after, &["arm", "upper", "lower", "hand"]);
        }
        let mut after = before.clone();
        assert!(hang(&mut after, "hand", Some("arm"), false).unwrap());
        assert_eq!(after.objects[3].translate, before.objects[3].translate, "the numbers stay, the place does not");
    }

    #[test]
    fn a_shear_is_said_to_be_one() {
        let mut spec = objects(vec![
            ObjectSpec::group("flat").scaled(3.0, 1.0, 1.0),
            ObjectSpec::new("box", Shape::Box).turned(0.0, 0.0, 45.0),
        ]);
        let numbers = spec.objects[1].clone();
        assert!(!hang(&mut spec, "box", Some("flat"), true).unwrap());
        assert_eq!(spec.objects[1], numbers.under("flat"));
    }

    #[test]
    fn nothing_hangs_on_its_own_descendant() {
        let mut spec = arm();
        let before = spec.clone();
        assert!(matches!(hang(&mut spec, "arm", Some("hand"), true), Err(SceneError::Cycle { .. })));
        assert!(matches!(hang(&mut spec, "arm", Some("nobody"), false), Err(SceneError::UnknownParent { .. })));
        assert_eq!(spec, before);
        assert_eq!(descendants(&spec, "upper").into_iter().collect::<Vec<_>>(), ["hand", "lower"]);
    }

    #[test]
    fn children_go_with_their_parent_or_take_its_place() {
        let before = arm();
        let mut after = before.clone();
        remove(&mut after, "upper", Children::Removed).unwrap();
        assert_eq!(after.objects.iter().map(|o| o.name.as_str()).collect::<Vec<_>>(), ["arm"]);
        let mut after = before.clone();
        assert!(remove(&mut after, "upper", Children::HungHigher).unwrap());
        assert_eq!(after.objects[1].parent.as_deref(), Some("arm"));
        assert_same_place(&before, &after, &["lower", "hand"]);
    }

    #[test]
    fn children_keep_a_parent_that_is_renamed() {
        let mut spec = arm();
        rename(&mut spec, "upper", "shoulder").unwrap();
        assert_eq!(spec.objects[2].parent.as_deref(), Some("shoulder"));
        let before = spec.clone();
        assert!(matches!(rename(&mut spec, "hand", "arm"), Err(SceneError::DuplicateName { .. })));
        assert_eq!(spec, before);
        spec.preset = Preset::Primitives;
        assert!(matches!(rename(&mut spec, "hand", "box"), Err(SceneError::DuplicateName { .. })), "the preset's");
        spec.preset = Preset::Empty;
        assert_eq!(free_name(&spec, "arm"), "arm 2");
        assert_eq!(free_name(&spec, "leg"), "leg");
    }

    #[test]
    fn a_preset_that_is_written_out_looks_as_before_or_says_what_is_lost() {
        for theme in [Theme::Light, Theme::Dark, Theme::Print] {
            for preset in Preset::NAMED.iter().map(|(_, preset)| *preset) {
                let mut spec = SceneSpec { preset, ..SceneSpec::default() };
                let before = built(&spec, theme);
                write_out_preset(&mut spec, theme, str::to_owned);
                let after = built(&spec, theme);
                assert_eq!(spec.preset, Preset::Empty);
                assert_eq!(before == after, preset.beyond_objects().is_empty(), "{preset}");
            }
        }
    }

    #[test]
    fn a_preset_that_is_written_out_gets_other_names_and_all_stays_where_it_is() {
        let lamp = ObjectSpec::new("mesa", Shape::Box).under("table");
        let mut spec = SceneSpec { preset: Preset::Primitives, objects: vec![lamp], lights: Vec::new() };
        let before = placements(&spec).unwrap();
        let names = write_out_preset(&mut spec, Theme::Light, |name| name.replace("table", "mesa"));
        let after = placements(&spec).unwrap();
        assert_eq!(names["table"], "mesa 2", "the figure has a “mesa” of its own");
        assert_eq!(spec.objects.last().unwrap().parent.as_deref(), Some("mesa 2"));
        assert_eq!(before["mesa"], after["mesa"]);
        assert_eq!(before.len(), after.len());
        for (old, new) in names {
            assert_eq!(before[&old], after[&new], "{old}");
        }
    }

    #[test]
    fn a_preset_that_is_written_out_respects_the_names_in_the_figure() {
        let lamp = ObjectSpec::new("box", Shape::Box).under("table");
        let mut spec = SceneSpec { preset: Preset::Primitives, objects: vec![lamp], lights: Vec::new() };
        let before = placements(&spec).unwrap();
        write_out_preset(&mut spec, Theme::Light, str::to_owned);
        let after = placements(&spec).unwrap();
        assert_eq!(before["box"], after["box"], "the figure's own");
        assert!(after.contains_key("box 2"), "the preset's");
        assert_eq!(after["table"], before["table"]);
        choose_preset(&mut spec, Preset::Cube);
        assert_eq!(spec.objects.last().unwrap().parent.as_deref(), Some("table"), "which is in the list now");
        spec.objects.retain(|o| o.name == "box");
        choose_preset(&mut spec, Preset::House);
        assert_eq!(spec.objects[0].parent, None);
    }
}
