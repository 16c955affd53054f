//! The words of the coach: the health of a camera, and the reasons why a picture is empty.

use std::collections::BTreeMap;

use super::scenes::preset_object;
use crate::appearance::DepthFormat;
use crate::camera::{Camera, CameraError, Ndc, Projection};
use crate::messages::cameras::warning_wording;
use crate::numbers::{power_of_ten, round_to, significant};
use crate::numerics::diagnosis::{Cause, Diagnosis, Finding, Value, WrongPixels};
use crate::numerics::health::{Health, HealthQuantity, Level, LostDigits, coarseness, lost_digits, volume_sides};
use crate::sanitize::{self, escaped};
use crate::scene::SceneSpec;
use crate::why::conventions;

texts!("window/coach");

/// The word for a level.
pub const fn level(lang: Lang, level: Level) -> &'static str {
    let t = texts(lang);
    match level {
        Level::Good => t.good,
        Level::Fair => t.fair,
        Level::Poor => t.poor,
    }
}

/// The level of the camera, in two words.
pub fn camera_is(lang: Lang, level: Level) -> String {
    format!("{} {}", texts(lang).camera_is, self::level(lang, level))
}

/// The judged quantity, in a few words.
pub const fn quantity(lang: Lang, quantity: HealthQuantity) -> &'static str {
    match quantity {
        HealthQuantity::VupAngle => text!(lang, quantity_vup_angle),
        HealthQuantity::FarNearRatio => "B / F",
        HealthQuantity::DepthResolution => text!(lang, quantity_depth_resolution),
        HealthQuantity::PositionDigits => text!(lang, quantity_position_digits),
        HealthQuantity::VolumeShape => text!(lang, quantity_volume_shape),
        HealthQuantity::ViewAngle => text!(lang, quantity_view_angle),
    }
}

/// A plain sentence about one quantity of a camera, with the equation of the notes that it comes from.
pub fn health(lang: Lang, health: &Health, camera: &Camera, format: DepthFormat) -> String {
    let n = |x: f64| length(lang, x);
    let perspective = camera.projection() == Projection::Perspective;
    let own = match health.quantity {
        HealthQuantity::VupAngle => vup_angle(lang, health.value, camera),
        HealthQuantity::FarNearRatio if perspective => {
            let half = 2.0 * camera.near() / (1.0 + camera.near() / camera.far());
            let (ratio, half) = (n(health.value), n(half));
            text!(lang, health_far_near_ratio, ratio, half)
        }
        HealthQuantity::FarNearRatio => {
            let ratio = n(health.value);
            text!(lang, health_far_near_ratio_parallel, ratio)
        }
        HealthQuantity::DepthResolution => depth_resolution(lang, camera, format),
        HealthQuantity::PositionDigits => {
            let (ratio, digits) = (n(camera.origin_ratio()), n(health.value));
            text!(lang, health_position_digits, ratio, digits)
        }
        HealthQuantity::VolumeShape => {
            let [w, h, d] = volume_sides(camera).map(n);
            let ratio = n(health.value);
            text!(lang, health_volume_shape, w, h, d, ratio)
        }
        HealthQuantity::ViewAngle => view_angle(lang, health.value, perspective),
    };
    let more = health.warnings.iter().filter(|_| health.quantity == HealthQuantity::VolumeShape);
    more.fold(own, |text, warning| format!("{text} {}.", warning_wording(lang, warning).in_symbols))
}

/// The condition of **u**, **v**, **n** and the digits of our method, in one sentence.
fn vup_angle(lang: Lang, degrees: f64, camera: &Camera) -> String {
    let n = |x: f64| lang.mark().number(x, 3);
    let angle = n(degrees);
    let Some(LostDigits { question, method, error }) = lost_digits(camera) else {
        return text!(lang, vup_angle_unknown, angle);
    };
    let [question, method] = [question, method].map(|lost| round_to(lost, 0.1));
    let t = texts(lang);
    let question = if question == 0.0 { t.no_digits.to_owned() } else { text!(lang, digits, digits = n(question)) };
    let method = if method == 0.0 { t.none.to_owned() } else { n(method) };
    text!(lang, vup_angle, angle, question, method, error = at_most(lang, error))
}

/// How far vertices are from their places at most, in pixels. `None` if there are no vertices, or nothing is known.
pub fn placed(lang: Lang, within: f64) -> Option<String> {
    (within > 0.0 && within.is_finite()).then(|| text!(lang, placed, within = at_most(lang, within)))
}

/// A positive number with two digits, rounded up.
fn at_most(lang: Lang, x: f64) -> String {
    let unit = power_of_ten(x).map_or(x, |power| power / 10.0);
    lang.mark().number((x / unit).ceil() * unit, 2)
}

/// A number with three digits. If it's beyond the greatest `f64`, the text says so.
fn length(lang: Lang, x: f64) -> String {
    if x < f64::MAX { lang.mark().number(x, 3) } else { text!(lang, length).to_owned() }
}

fn depth_resolution(lang: Lang, camera: &Camera, format: DepthFormat) -> String {
    let step = |z: f64| length(lang, (camera.depth_step(z) * coarseness(format)).min(f64::MAX));
    let [at_near, at_focus, at_far] = [camera.near(), camera.distance(), camera.far()].map(step);
    let (bits, power) = if format == DepthFormat::Fixed16 { (16, "2¹⁶") } else { (24, "2²⁴") };
    let own = match camera.projection() {
        Projection::Perspective => text!(lang, depth_resolution_perspective, bits, power, at_near, at_focus, at_far),
        Projection::Parallel => text!(lang, depth_resolution_parallel, bits, power, at_far),
    };
    match format {
        DepthFormat::Float => text!(lang, depth_resolution_float, own),
        _ => own,
    }
}

fn view_angle(lang: Lang, degrees: f64, perspective: bool) -> String {
    let stretched = (0.5 * degrees).to_radians().cos().powi(-2);
    let (angle, stretched) = (lang.mark().number(degrees, 4), lang.mark().number(stretched, 3));
    if !perspective {
        return text!(lang, view_angle_perspective).to_owned();
    }
    text!(lang, view_angle, angle, stretched)
}

/// The owner of the NDC of depths.
pub fn depth_in(lang: Lang, ndc: Ndc) -> String {
    let name = conventions::name(lang, ndc);
    let [near, far] = ndc.depths().map(|depth| lang.mark().number(depth, 2));
    let back = if ndc.infinite { "B → ∞" } else { "B" };
    text!(lang, depth_in, name, near, far, back)
}

/// The verdict of a depth buffer on two planes. `share` is the part of their common area in which the farther one is
/// visible.
pub fn two_planes(lang: Lang, share: f64) -> String {
    let percent = lang.mark().number(100.0 * share, 2);
    if share == 0.0 {
        return text!(lang, two_planes_share).to_owned();
    }
    text!(lang, two_planes, percent)
}

/// Explains a finding, with the names of the objects concerned in this language. `scene` is the figure's, whose own
/// objects have their names from its author.
pub fn finding(lang: Lang, finding: &Finding, diagnosis: &Diagnosis, scene: &SceneSpec) -> String {
    if let Some(error) = &diagnosis.camera_error {
        return impossible_camera(lang, error);
    }
    if let Some(pixels) = finding.pixels {
        let names: Vec<String> = finding.objects().map(|name| object_name(lang, name, scene)).collect();
        let mut sentence = wrong_pixels(lang, finding.cause, pixels);
        if finding.cause == Cause::VertexRounding && diagnosis.infinite_faces > 0 {
            let [one, many] = text!(lang, infinite_faces);
            let faces = diagnosis.infinite_faces;
            sentence += &format!(" {faces} {}", if faces == 1 { one } else { many });
        }
        return if names.is_empty() { sentence } else { format!("{}: {sentence}", listed(lang, &names)) };
    }
    match finding.cause {
        Cause::EmptyScene => {
            return text!(lang, finding_empty_scene).to_owned();
        }
        Cause::NotCompared => {
            return text!(lang, finding_not_compared).to_owned();
        }
        _ => {}
    }
    let [whole, in_part] = [false, true].map(|partly| not_seen(lang, finding.cause, partly, diagnosis));
    let [lost, cut] = [&finding.whole, &finding.partly]
        .map(|names| names.iter().map(|name| object_name(lang, name, scene)).collect::<Vec<_>>());
    // A sentence that also holds for partly visible objects is written once.
    let groups =
        if whole == in_part { vec![([lost, cut].concat(), whole)] } else { vec![(lost, whole), (cut, in_part)] };
    let sentences = groups.into_iter().filter(|(names, _)| !names.is_empty());
    sentences.map(|(names, said)| format!("{}: {said}", listed(lang, &names))).collect::<Vec<_>>().join(" ")
}

/// The files that a figure needs and that can't be read. Each is true if there is no such file.
pub fn lost_files(lang: Lang, lost: &BTreeMap<String, bool>) -> String {
    let (gone, unread): (Vec<_>, Vec<_>) = lost.iter().partition(|(_, is_gone)| **is_gone);
    let sentence = |files: Vec<(&String, &bool)>, [one, many]: [&str; 2]| {
        let names: Vec<String> = files.into_iter().map(|(name, _)| sanitize::within(name, 60)).collect();
        let words = if names.len() == 1 { one } else { many };
        (!names.is_empty()).then(|| format!("{} {words}", listed(lang, &names)))
    };
    let gone = sentence(gone, text!(lang, lost_files_gone));
    let unread = sentence(unread, text!(lang, lost_files));
    gone.into_iter().chain(unread).collect::<Vec<_>>().join("; ")
}

/// The name of an object: its author's, or in this language that of a part of a named scene.
fn object_name(lang: Lang, name: &str, scene: &SceneSpec) -> String {
    match name {
        "" => text!(lang, object_name).to_owned(),
        name if scene.objects.iter().any(|object| object.name == name) => escaped(name),
        name => preset_object(lang, name),
    }
}

/// The equation that has no result, and why.
fn impossible_camera(lang: Lang, error: &CameraError) -> String {
    let reason = match (lang, error) {
        (_, CameraError::ViewUpZero | CameraError::ViewUpCollinear) => text!(lang, impossible_camera_view_up_zero),
        (_, CameraError::FocalPointAtPosition) => text!(lang, impossible_camera_focal_point_at_position),
        (_, CameraError::FarNotBeyondNear { .. }) => text!(lang, impossible_camera_far_not_beyond_near),
        _ => "",
    };
    format!("{reason}{}.", crate::messages::cameras::camera_wording(lang, error).in_symbols)
}

/// The fault of pixels, with their number.
fn wrong_pixels(lang: Lang, cause: Cause, pixels: WrongPixels) -> String {
    let WrongPixels { wrong, of } = pixels;
    let share = lang.mark().number(100.0 * pixels.share(), 3);
    let count = text!(lang, wrong_pixels_count, share, wrong, of);
    match cause {
        Cause::WrongOrder => text!(lang, wrong_pixels_wrong_order, count),
        Cause::ShadowAcne => text!(lang, wrong_pixels_shadow_acne, count),
        Cause::ShadowDetached => text!(lang, wrong_pixels_shadow_detached, count),
        Cause::AffineTexture => text!(lang, wrong_pixels_affine_texture, count),
        Cause::VertexRounding => text!(lang, wrong_pixels_vertex_rounding, count),
        _ => text!(lang, wrong_pixels_z_fighting, count),
    }
}

/// Some names, and how many more.
fn listed(lang: Lang, names: &[String]) -> String {
    const MOST: usize = 4;
    let first = names.iter().take(MOST).map(String::as_str).collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(MOST) {
        0 => first,
        more => text!(lang, listed, first, more),
    }
}

/// The reason why an object, or most of it, can't be seen.
fn not_seen(lang: Lang, cause: Cause, partly: bool, diagnosis: &Diagnosis) -> String {
    let most = if partly { text!(lang, not_seen_partly) } else { "" };
    let percent = lang.mark().number(100.0 * diagnosis.covered, 2);
    match cause {
        Cause::CameraInsideObject => text!(lang, not_seen_camera_inside_object).to_owned(),
        Cause::BehindCamera => text!(lang, not_seen_behind_camera, most),
        Cause::BeforeNear => {
            text!(lang, not_seen_before_near, most)
        }
        Cause::BeyondFar => text!(lang, not_seen_beyond_far, most),
        Cause::OutsideLeft => text!(lang, not_seen_outside_left, most),
        Cause::OutsideRight => text!(lang, not_seen_outside_right, most),
        Cause::OutsideTop => text!(lang, not_seen_outside_top, most),
        Cause::OutsideBottom => text!(lang, not_seen_outside_bottom, most),
        Cause::SmallerThanPixel => text!(lang, not_seen_smaller_than_pixel).to_owned(),
        Cause::FullyTransparent => text!(lang, not_seen_fully_transparent).to_owned(),
        Cause::HiddenByNearCut => text!(lang, not_seen_hidden_by_near_cut).to_owned(),
        Cause::FewPixels => text!(lang, not_seen_few_pixels, percent),
        // The others have sentences of their own.
        _ => String::new(),
    }
}

/// The changes of a repair: keys of the figure file with their new values.
pub fn changes(changes: &[(&'static str, Value)]) -> String {
    let n = |x: f64| significant(x, 6);
    let of = |(key, value): &(&'static str, Value)| match value {
        Value::Number(x) => format!("{key} = {}", n(*x)),
        Value::Vector(v) => format!("{key} = [{}, {}, {}]", n(v.x), n(v.y), n(v.z)),
        Value::Window(w) => {
            format!("{key} = [{}, {}] × [{}, {}]", n(w.left), n(w.right), n(w.bottom), n(w.top))
        }
        Value::Word(word) => format!("{key} = {word}"),
        Value::Absent => format!("{key} = –"),
    };
    changes.iter().map(of).collect::<Vec<_>>().join(", ")
}

/// The changes of a repair as in the panels: the notes' symbols, with the decimal mark of the language.
pub fn changes_in_symbols(lang: Lang, changes: &[(&'static str, Value)]) -> String {
    let n = |x: f64| lang.mark().number(x, 4);
    let mark = lang.mark();
    let symbol = |key: &'static str| match key {
        "position" => "C",
        "focal_point" => "PF",
        "view_up" => "VUP",
        "view_angle" => "θ",
        "height" => "H",
        "aspect" => "A",
        "near" => "F",
        "far" => "B",
        "shading" => crate::window::texts(lang).shading,
        "visibility" => crate::window::texts(lang).visibility,
        "depth_format" => texts(lang).format,
        "scene.lights.shadow_bias" => texts(lang).shadow_bias,
        key => key,
    };
    let of = |(key, value): &(&'static str, Value)| match value {
        Value::Number(x) if *key == "view_angle" => format!("θ = {}°", n(*x)),
        Value::Number(x) => format!("{} = {}", symbol(key), n(*x)),
        Value::Vector(v) => format!("{} = {}", symbol(key), mark.tuple(&v.to_array(), 4)),
        Value::Window(w) => format!("l = {}, r = {}, b = {}, t = {}", n(w.left), n(w.right), n(w.bottom), n(w.top)),
        Value::Word(word) => format!("{}: {}", symbol(key), style_word(lang, word)),
        Value::Absent => format!("{}: –", symbol(key)),
    };
    changes.iter().map(of).collect::<Vec<_>>().join(" · ")
}

/// A word of `[style]` as in the panels.
fn style_word(lang: Lang, word: &'static str) -> &'static str {
    let t = crate::window::texts(lang);
    match word {
        "wireframe" => t.shading_wireframe,
        "flat" => t.shading_flat,
        "depth-buffer" => t.visibility_depth_buffer,
        "bsp" => t.visibility_bsp,
        word => word,
    }
}

/// The share of the image that the scene covers.
pub fn seen(lang: Lang, visible: u64, covered: f64) -> String {
    let share = lang.mark().number(100.0 * covered, 3);
    text!(lang, seen, visible, share)
}
