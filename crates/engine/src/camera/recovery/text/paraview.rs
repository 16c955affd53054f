//! A camera of `ParaView`: its `.pvcc` file, or the lines of its Python trace.
//!
//! Both have the names of VTK, with a list of numbers behind each: `<Element index="0" value="6.7"/>` up to
//! `</Property>`, or `view.CameraPosition = [6.7, …]`. So one reader of names reads both, without a parser of XML.

use crate::camera::recovery::entries::{MatrixEntries, Written};
use crate::camera::recovery::text::{GivenLens, Pasted};
use crate::camera::recovery::{Axes, MatrixKind, Order};

/// The camera of a text, if it has the position of one.
pub(crate) fn camera(text: &str) -> Option<Pasted> {
    let position = numbers(text, "CameraPosition")?;
    // A trace leaves out default values.
    let focal_point = numbers(text, "CameraFocalPoint").unwrap_or_else(|| vec![0.0; 3]);
    let view_up = numbers(text, "CameraViewUp").unwrap_or_else(|| vec![0.0, 1.0, 0.0]);
    let nine: Vec<f64> =
        [position, focal_point, view_up].into_iter().filter(|three| three.len() == 3).flatten().collect();
    let entries = nine.into_iter().map(|value| Written { value, error: 0.0 }).collect();
    let entries = MatrixEntries::new(entries, Some(3)).filter(|entries| entries.count() == 9)?;
    let number = |name| numbers(text, name).and_then(|list| list.first().copied());
    let is_parallel = number("CameraParallelProjection").is_some_and(|switch| switch > 0.5);
    let lens = match number("CameraParallelScale").filter(|_| is_parallel) {
        // Half of the height.
        Some(scale) => GivenLens::Parallel { height: 2.0 * scale, aspect: None, planes: None },
        None => GivenLens::AngleY {
            degrees: number("CameraViewAngle").unwrap_or(30.0),
            aspect: None,
            near: None,
            far: None,
        },
    };
    let pose = Pasted::pose("", entries, MatrixKind::LookAt, Axes::OPENGL, (Order::Rows, "CameraPosition"));
    Some(Pasted { lens: Some(lens), ..pose })
}

/// The numbers behind a name, which is a whole word.
fn numbers(text: &str, name: &str) -> Option<Vec<f64>> {
    let rest = text.match_indices(name).find_map(|(at, _)| {
        let rest = &text[at + name.len()..];
        let is_name = text[..at].ends_with(['.', '"']) && rest.starts_with(['"', ' ', '=']);
        is_name.then_some(rest)
    })?;
    let parts: Vec<&str> = match rest.strip_prefix('"') {
        Some(property) => {
            let values = property.split("</Property>").next()?.split("value=\"").skip(1);
            values.filter_map(|value| value.split('"').next()).collect()
        }
        None => {
            let line = rest.lines().next()?.trim_start().strip_prefix('=')?;
            line.trim().trim_matches(['[', ']']).split(',').collect()
        }
    };
    parts.into_iter().map(|part| part.trim().parse().ok()).collect()
}
