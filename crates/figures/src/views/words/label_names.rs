//! The names of labels, with which an author changes them.

use std::collections::BTreeSet;

use crate::camera::Operation;
use crate::figure::labels::{LEGEND, is_in_legend, note_index};
use crate::sanitize::escaped;
use crate::views::reveal::stage_overlay;
use crate::views::{OtherCamera, SharedScene, Shot};

/// The names that don't depend on the figure.
#[rustfmt::skip]
const NAMES: &[&str] = &[
    "C", "PF", "VUP", "DOP", "u", "v", "n", "x", "y", "z", "x_n", "y_n", "z_n", "window", "near", "far", "scene", "before", "answered",
    "F", "B", "D", "W", "H", "theta", "theta/2", "W/2", "H/2", "y_p", "y_c", "−z_c", "l", "r", "b", "t", "P", "O_R", "V_x", "V_y", "V_z", "horizon", "epipolar", "epipole", "outside",
    "u_x", "u_y", "u_z", "v_x", "v_y", "v_z", "n_x", "n_y", "n_z", "−u · c", "−v · c", "−n · c", "c_x", "c_y", "c_z", "PF_x", "PF_y", "PF_z",
    "VUP_x", "VUP_y", "VUP_z", "t_x", "t_y", "t_z", "φ_x", "φ_y", "φ_z", "s_x", "s_y", "s_z", "a", "c",
    "corner:near-left-bottom", "corner:near-left-top", "corner:near-right-bottom", "corner:near-right-top", "corner:far-left-bottom",
    "corner:far-left-top", "corner:far-right-bottom", "corner:far-right-top", "goes-in", "comes-out", "behind-eye", "side:1", "side:2", "differ",
    "legend", "legend:depth", "legend:nothing", "legend:Z-near", "legend:Z-middle", "legend:Z-far", "legend:distance-near",
    "legend:distance-middle", "legend:distance-far", "legend:triangles", "legend:vanishing", "legend:V_x", "legend:V_y", "legend:V_z",
    "legend:step", "legend:handedness", "legend:ndc", "legend:cuts", "legend:outside", "legend:back-faces", "legend:dropped",
    "legend:divided-first", "legend:not-split", "legend:rounded", "legend:goes-in", "legend:comes-out", "legend:vertices", "legend:not-all",
    "legend:acne", "legend:affine", "legend:levels", "legend:level", "legend:texels", "legend:truth",
];

/// The names in the `[labels]` of a shot that no label has in any of its pictures, each with the name that the author
/// probably meant.
pub fn unknown_labels(shot: &Shot, scene: &SharedScene) -> Vec<(String, Option<String>)> {
    let mut known: BTreeSet<&str> = NAMES.iter().copied().collect();
    // Kept operations.
    known.extend(Operation::names());
    known.extend(shot.points.iter().map(|point| point.name.as_str()));
    let cameras: Vec<String> = shot.cameras.iter().flat_map(OtherCamera::label_names).collect();
    known.extend(cameras.iter().map(String::as_str));
    known.extend(scene.texts.iter().map(|text| text.name.as_str()));
    // Axes of previewed objects, axes of the selection, and vertices that clipping makes.
    let is_numbered = |name: &str| {
        let letter = name.split('_').next().unwrap_or_default();
        name.contains('_') && ["x", "y", "z"].contains(&letter) || name.chars().count() == 1
    };
    let objects: Vec<String> = scene.objects.iter().map(|object| escaped(&object.name)).collect();
    let is_stages = |name: &str| {
        let name = name.strip_prefix(LEGEND).filter(|_| is_in_legend(name)).map_or(name, |name| &name[1..]);
        stage_overlay::is_label(name, &objects)
    };
    let is_known = |name: &str| is_numbered(name) || is_stages(name) || note_index(name).is_some();
    shot.labels.unknown(&known.into_iter().collect::<Vec<_>>(), is_known)
}
