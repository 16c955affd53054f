//! The output of `camera-lab inspect` for followed points: their traces, and pixels with a depth on their way back.

use serde::Serialize;
use serde_json::Value;

use super::{Setting, Step, back, forward};
use crate::camera::{NotProjectable, Unprojected};
use crate::inspect::{Bounds, Report};

/// A pixel with a depth, followed back to the world.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DepthPixelReport {
    /// (i, j)
    pub pixel: [i64; 2],
    /// Z
    pub depth: f64,
    /// (x_p, y_p) of the pixel's centre.
    pub window: [f64; 2],
    /// NDC.
    pub ndc: [f64; 3],
    /// Clip coordinates.
    pub clip: [f64; 4],
    /// VRC.
    pub view: [f64; 3],
    /// World.
    pub world: [f64; 3],
    /// Step by step, from the pixel to the world.
    pub trace: Vec<Step>,
}

impl DepthPixelReport {
    /// The way back from the centre of a pixel with a depth.
    ///
    /// # Errors
    /// [`NotProjectable`] if the depth belongs to no point.
    pub fn new(setting: &Setting<'_>, pixel: [i64; 2], depth: f64) -> Result<Self, NotProjectable> {
        let way = setting.space().way_back(setting.image(), &setting.viewport(), pixel, depth)?;
        let trace = back(setting, &way);
        let Unprojected { pixel, depth, window, ndc, clip, view, world } = way;
        Ok(Self {
            pixel,
            depth,
            window: window.to_array(),
            ndc: ndc.to_array(),
            clip: clip.to_array(),
            view: view.to_array(),
            world: world.to_array(),
            trace,
        })
    }
}

/// The report as a value, with the `trace` of each of its points if requested, with `depth_pixels` if there are any,
/// and with bounds. [`json_text`](crate::inspect::json_text) writes it like [`Report::to_json`].
pub fn json(
    report: &Report,
    setting: &Setting<'_>,
    traced: bool,
    depth_pixels: &[DepthPixelReport],
    bounds: Option<&Bounds>,
) -> Value {
    // Everything in a report and a trace can become a JSON value.
    let mut value = serde_json::to_value(report).unwrap_or_default();
    if traced {
        for (point, entry) in report.points.iter().zip(value["points"].as_array_mut().into_iter().flatten()) {
            let steps = forward(&setting.clone().with_point(point.world.into()));
            entry["trace"] = serde_json::to_value(steps).unwrap_or_default();
        }
    }
    if !depth_pixels.is_empty() {
        value["depth_pixels"] = serde_json::to_value(depth_pixels).unwrap_or_default();
    }
    if let Some(bounds) = bounds {
        value["bounds"] = bounds.to_json();
        value["condition"] = serde_json::to_value(bounds.condition).unwrap_or_default();
    }
    value
}
