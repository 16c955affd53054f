//! `camera-lab photograph`: the camera of a photograph, from lines that are parallel to the axes of the world.

use std::fmt::Write as _;

use serde::Serialize;

use super::{Failure, json_of, open, print, text_to_print};
use crate::camera::{Doubt, PhotographCamera, camera_of_photograph, condition_of_photograph};
use crate::cli::args::figure::size;
use crate::cli::args::photograph::PhotographArgs;
use crate::cli::args::words::{TableFormat, written};
use crate::inspect::CameraReport;
use camera_lab_words::why::photograph as texts;
use camera_lab_words::{Lang, messages};

/// The JSON output.
#[derive(Serialize)]
struct Answer {
    camera: CameraReport,
    image: [u32; 2],
    vanishing: Vec<Vanishing>,
    horizon: Option<[[f64; 2]; 2]>,
    focal_length: Option<f64>,
    view_angle_per_pixel: Option<f64>,
    direction_per_pixel: f64,
    middle: [f64; 2],
    condition: Option<f64>,
    untold: Vec<Notice>,
    notices: Vec<Notice>,
}

#[derive(Serialize)]
struct Vanishing {
    axis: &'static str,
    pixel: Option<[f64; 2]>,
    spread: f64,
}

/// A value that stays open, or a contradiction in the marks.
#[derive(Serialize)]
struct Notice {
    code: &'static str,
    message: String,
}

pub(super) fn run(args: &PhotographArgs, lang: Lang) -> Result<(), Failure> {
    let (marks, size) = (args.marks(lang)?, size(args.size.as_deref(), lang)?);
    let (opened, camera) = open(&args.figure, &args.common, lang)?;
    let mut figure = opened.figure.clone();
    let image = size.unwrap_or(figure.image);
    let refused = |why: String| Failure::BadInput(format!("{}: {why}", messages::opened(lang, &args.figure)));
    let found = camera_of_photograph(&marks, image, camera.parameters())
        .map_err(|error| refused(texts::error(lang, &error)))?;
    (figure.camera, figure.image) = (found.parameters, image);
    let written = written(args.common.lang);
    let condition = condition_of_photograph(&marks, image, camera.parameters());
    let text = match args.format {
        TableFormat::Json => json_of(&Answer::new(&found, condition, [image.width, image.height], written))?,
        TableFormat::Text => {
            comments(&found, condition, written) + &text_to_print((&args.figure, &opened), &figure, lang)?
        }
    };
    print(text.as_bytes(), lang)
}

impl Answer {
    fn new(found: &PhotographCamera, condition: Option<f64>, image: [u32; 2], lang: Lang) -> Self {
        Self {
            camera: CameraReport::new(&found.parameters),
            image,
            vanishing: found
                .vanishing
                .iter()
                .map(|point| Vanishing {
                    axis: point.axis.name(),
                    pixel: point.pixel.map(|pixel| pixel.to_array()),
                    spread: point.spread,
                })
                .collect(),
            horizon: found.horizon.map(|ends| ends.map(|end| end.to_array())),
            focal_length: found.focal_length,
            view_angle_per_pixel: found.view_angle_per_pixel,
            direction_per_pixel: found.direction_per_pixel,
            middle: found.middle.to_array(),
            condition,
            untold: (found.untold.iter())
                .map(|untold| Notice { code: untold.code(), message: texts::untold(lang, *untold).to_owned() })
                .collect(),
            notices: (found.doubts.iter().zip(texts::doubts(lang, found)))
                .map(|(doubt, message)| Notice { code: doubt.code(), message })
                .collect(),
        }
    }
}

/// The arithmetic and the values that stay open, as comments of a figure file.
fn comments(found: &PhotographCamera, condition: Option<f64>, lang: Lang) -> String {
    let mut text = String::new();
    for line in texts::steps(lang, found).into_iter().chain([texts::condition(lang, condition)]) {
        // Writing to a String can't fail.
        let _ = writeln!(text, "# {line}");
    }
    let untold = found.untold.iter().map(|untold| texts::untold(lang, *untold).to_owned());
    for line in untold.chain(texts::doubts(lang, found)) {
        let _ = writeln!(text, "# {line}");
    }
    if let Some(Doubt::Middle { pixel, .. }) = found.doubts.last() {
        let _ = writeln!(text, "# --middle {:.0},{:.0}", pixel.x, pixel.y);
    }
    text + "\n"
}
