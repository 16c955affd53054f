//! Cameras of answers, by the names of the notes.

use crate::camera::{ParameterKey, Parameters, Projection, ViewWindow};
use crate::figure::FigureError;
use crate::figure::error::Problem;
use crate::messages::cameras::camera_wording;
use crate::messages::figure_files;

texts!("learn/exercise_cameras");

/// A camera by the names of the notes, in typed form, with all that its projection needs, to the last digit.
pub(crate) fn typed(lang: Lang, parameters: &Parameters) -> String {
    let mark = lang.mark();
    let exact = |value: f64| mark.typed(&value.to_string());
    let tuple = |values: &[f64]| {
        let numbers: Vec<String> = values.iter().map(|value| exact(*value)).collect();
        format!("({})", numbers.join(mark.separator()))
    };
    let projection = match parameters.projection {
        Projection::Perspective => text!(lang, typed_perspective),
        Projection::Parallel => text!(lang, typed_parallel),
    };
    let mut pairs = vec![
        ("C", tuple(&parameters.position.to_array())),
        ("PF", tuple(&parameters.focal_point.to_array())),
        ("VUP", tuple(&parameters.view_up.to_array())),
        (text!(lang, typed), projection.to_owned()),
    ];
    match (parameters.window, parameters.projection) {
        (Some(ViewWindow { left, right, bottom, top }), _) => {
            pairs.push((text!(lang, typed_view_window), tuple(&[left, right, bottom, top])));
        }
        (None, Projection::Perspective) => pairs.push(("θ", exact(parameters.view_angle))),
        (None, Projection::Parallel) => pairs.push(("H", exact(parameters.height))),
    }
    if parameters.window.is_none() {
        pairs.push(("A", exact(parameters.aspect)));
    }
    pairs.extend([("F", exact(parameters.near)), ("B", exact(parameters.far))]);
    pairs.iter().map(|(name, value)| format!("{name} = {value}")).collect::<Vec<_>>().join("; ")
}

/// The reason why the values of an answer aren't a camera, by the names of the notes.
pub(crate) fn refused(lang: Lang, error: &FigureError) -> String {
    let of_key = |key: &ParameterKey| error.key.strip_prefix("[camera] ").is_some_and(|name| name == key.name());
    match (&error.problem, ParameterKey::ALL.iter().find(|key| of_key(key))) {
        (Problem::Camera(error), _) => camera_wording(lang, error).in_symbols,
        // The user types a window as its four sides.
        (problem, Some(ParameterKey::Window)) => {
            format!("{} {}", text!(lang, window), figure_files::problem(lang, problem))
        }
        (problem, Some(key)) => format!("{} {}", key.symbol(), figure_files::problem(lang, problem)),
        (_, None) => figure_files::without_line(lang, error),
    }
}
