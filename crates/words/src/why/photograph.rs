//! The camera of a photograph: its arithmetic, its errors, and the numbers that it can't give.

use crate::camera::{AxisVanishing, Doubt, PhotographCamera, PhotographError, Untold};
use crate::messages::camera as camera_error;
use crate::sanitize::escaped;

texts!("why/photograph");

/// Digits of the numbers in sentences.
const DIGITS: usize = 6;

/// An argument that can't be read, with an example.
pub fn unreadable(lang: Lang, text: &str, example: &str) -> String {
    let text = escaped(text);
    text!(lang, unreadable, text, example)
}

/// The reason why there is no camera.
pub fn error(lang: Lang, error: &PhotographError) -> String {
    match error {
        PhotographError::TooFewLines => text!(lang, error_too_few_lines).to_owned(),
        PhotographError::NoDirection(line) => text!(lang, error_no_direction, line),
        PhotographError::OneLine(axis) => {
            let axis = axis.name();
            text!(lang, error_one_line, axis)
        }
        PhotographError::NotAtRightAngles(a, b, angles) => {
            let ((a, b), [angle, theta]) = ((a.name(), b.name()), angles.map(|angle| lang.mark().number(angle, 3)));
            text!(lang, error_not_at_right_angles, a, b, angle, theta)
        }
        PhotographError::OffMiddle(middle) => {
            let middle = doubt(lang, middle, true);
            text!(lang, error_off_middle, middle)
        }
        PhotographError::SameDirection(a, b) => {
            let (a, b) = (a.name(), b.name());
            text!(lang, error_same_direction, a, b)
        }
        PhotographError::Impossible(error) => camera_error(lang, error),
        PhotographError::BesideAxis(axis, pixels) => {
            let (axis, pixels) = (axis.name(), lang.mark().number(*pixels, 3));
            text!(lang, error_beside_axis, axis, pixels)
        }
        PhotographError::Length => text!(lang, error_length).to_owned(),
        PhotographError::LengthAtAngle(theta) => {
            let theta = lang.mark().number(*theta, DIGITS);
            text!(lang, error_length_at_angle, theta)
        }
        other => other.to_string(),
    }
}

/// A number that the photograph can't give, and the one that stands for it.
pub fn untold(lang: Lang, untold: Untold) -> &'static str {
    match untold {
        Untold::ViewAngle => text!(lang, untold_view_angle),
        Untold::Position => text!(lang, untold_position),
        Untold::Distance => text!(lang, untold_distance),
    }
}

/// A contradiction in the marks. `is_told`: θ is known.
pub fn doubt(lang: Lang, doubt: &Doubt, is_told: bool) -> String {
    match doubt {
        Doubt::OneLine(axis) => {
            let axis = axis.name();
            text!(lang, doubt_one_line, axis)
        }
        Doubt::Angle(a, b, angle) => {
            let (a, b, angle) = (a.name(), b.name(), lang.mark().number(*angle, 3));
            if is_told { text!(lang, doubt_left_out, a, b, angle) } else { text!(lang, doubt_angle, a, b, angle) }
        }
        Doubt::Turned(axis) => {
            let axis = axis.name();
            text!(lang, doubt_turned, axis)
        }
        Doubt::UpsideDown => text!(lang, doubt_upside_down).to_owned(),
        Doubt::Middle { pixel, offset, error } => {
            let pixel = pixel.to_array().map(f64::round);
            let pixel = lang.mark().tuple(&pixel, DIGITS);
            let [offset, error] = [offset, error].map(|length| lang.mark().number(*length, 2));
            text!(lang, doubt_middle, pixel, offset, error)
        }
    }
}

/// The contradictions of a camera, one sentence or two each.
pub fn doubts(lang: Lang, found: &PhotographCamera) -> impl Iterator<Item = String> {
    found.doubts.iter().map(move |one| doubt(lang, one, found.focal_length.is_some()))
}

/// The steps from the lines to the camera, one sentence each.
pub fn steps(lang: Lang, found: &PhotographCamera) -> Vec<String> {
    let number = |x: f64| lang.mark().number(x, DIGITS);
    let mut steps: Vec<String> = found.vanishing.iter().map(|point| vanishing(lang, point)).collect();
    if let (Some(f), Some(cost)) = (found.focal_length, found.view_angle_per_pixel) {
        let (f, theta, cost) = (number(f), number(found.parameters.view_angle), lang.mark().number(cost, 2));
        steps.push(text!(lang, steps_ome, f));
        steps.push(text!(lang, steps_angle, theta, cost));
    }
    steps.push(horizon(lang, found));
    let cost = lang.mark().number(found.direction_per_pixel, 2);
    steps.push(text!(lang, steps, cost));
    let [u, v, n] = found.axes().map(|axis| lang.mark().tuple(&axis.to_array(), 4));
    steps.push(format!("u = {u}, v = {v}, n = {n}"));
    let c = lang.mark().tuple(&found.parameters.position.to_array(), DIGITS);
    if found.untold.contains(&Untold::Position) {
        return steps;
    }
    steps.push(if found.untold.contains(&Untold::Distance) {
        text!(lang, steps_found, c)
    } else {
        text!(lang, steps_origin, c)
    });
    steps
}

/// The digits that the question itself loses.
pub fn condition(lang: Lang, condition: Option<f64>) -> String {
    match condition {
        Some(number) => {
            let (times, lost) = (lang.mark().number(number, 3), lang.mark().number(number.max(1.0).log10(), 2));
            text!(lang, condition, times, lost)
        }
        None => text!(lang, condition_infinite).to_owned(),
    }
}

/// The horizon, and the roll of the camera that it shows.
fn horizon(lang: Lang, found: &PhotographCamera) -> String {
    let roll = lang.mark().number(found.roll(), 3);
    match found.horizon {
        Some(_) => text!(lang, horizon_level, roll),
        None => text!(lang, horizon_infinity).to_owned(),
    }
}

fn vanishing(lang: Lang, point: &AxisVanishing) -> String {
    let (axis, spread) = (point.axis.name(), lang.mark().number(point.spread, 3));
    match point.pixel {
        Some(pixel) => {
            let pixel = lang.mark().tuple(&pixel.to_array(), DIGITS);
            text!(lang, vanishing_at, axis, pixel, spread)
        }
        None => text!(lang, vanishing_infinity, axis, spread),
    }
}
