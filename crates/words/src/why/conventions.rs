//! The words of conventions: the NDC, rows or columns, left or right hand.

use crate::camera::{Axes, InfiniteParallel, Ndc, Toward, WorldUp};
use crate::pictures;

texts!("why/conventions");

/// The axes of a camera.
pub fn camera_axes(lang: Lang, axes: Axes) -> String {
    let [x, y, z] = axes.camera.map(|toward| direction(lang, toward));
    format!("x {x}, y {y}, z {z}")
}

/// A row of the table of axes: camera and world.
pub fn axes_row(lang: Lang, axes: Axes) -> String {
    let world = match axes.up {
        WorldUp::Y => text!(lang, axes_row_y),
        WorldUp::Z => text!(lang, axes_row_z),
        WorldUp::Open => text!(lang, axes_row_open),
    };
    let hand = if axes.left_handed { text!(lang, axes_row_axes) } else { "" };
    format!("{}; {world}{hand}", camera_axes(lang, axes))
}

/// The table of axes, a line for each row, by their titles or by the names on the command line.
pub fn axes_table(lang: Lang, name: fn(Axes) -> &'static str) -> String {
    let rows = Axes::ALL.map(|axes| format!("{}: {}", name(axes), axes_row(lang, axes)));
    rows.join("\n")
}

/// The direction of an axis of a camera.
fn direction(lang: Lang, toward: Toward) -> &'static str {
    match toward {
        Toward::Right => text!(lang, direction_right),
        Toward::Left => text!(lang, direction_left),
        Toward::Up => text!(lang, direction_up),
        Toward::Down => text!(lang, direction_down),
        Toward::Viewer => text!(lang, direction_viewer),
        Toward::Scene => text!(lang, direction_scene),
    }
}

/// A convention in words, as in the pictures.
pub fn name(lang: Lang, ndc: Ndc) -> String {
    pictures::labels(lang).ndc_title(ndc)
}

/// The reason why the pictures still have a back plane.
pub fn finite_instead(lang: Lang, error: InfiniteParallel) -> String {
    let name = error.0.api.title();
    text!(lang, finite_instead, name)
}

/// The differences of a convention from the one in use, as the reasons for different entries.
pub fn differences(lang: Lang, ndc: Ndc, compared: Ndc) -> String {
    let (mine, other) = (name(lang, ndc), name(lang, compared));
    let mut reasons = Vec::new();
    let number = |depth: f64| lang.mark().number(depth, 2);
    let ([near, far], [other_near, other_far]) = (ndc.depths().map(number), compared.depths().map(number));
    if ndc.depths() != compared.depths() {
        reasons.push(text!(lang, differences_ndc, other_near, other_far, near, far));
    }
    if ndc.y_points_down() != compared.y_points_down() {
        reasons.push(match compared.y_points_down() {
            true => text!(lang, differences_down).to_owned(),
            false => text!(lang, differences_up).to_owned(),
        });
    }
    if ndc.infinite != compared.infinite {
        reasons.push(match compared.infinite {
            true => text!(lang, differences_no_back_plane).to_owned(),
            false => text!(lang, differences_back_plane).to_owned(),
        });
    }
    match reasons.is_empty() {
        true => text!(lang, differences_none, other, mine),
        false => text!(lang, differences_marked, other, capital = capital(&reasons.join("; "))),
    }
}

/// A sentence begins with a capital letter, but not with a symbol's.
fn capital(sentence: &str) -> String {
    let mut letters = sentence.chars();
    match letters.next() {
        Some(first) if !sentence.starts_with("z_n") && !sentence.starts_with("y_n") => {
            first.to_uppercase().chain(letters).collect()
        }
        _ => sentence.to_owned(),
    }
}
