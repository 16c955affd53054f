//! `camera-lab bench`: the time that a picture takes.

use std::time::Duration;

use serde::Serialize;

use super::args::BenchArgs;
use super::render::no_picture;
use super::{Failure, OpenFigure, json_of, print};
use crate::cli::args::figure::size;
use crate::cli::args::words::TableFormat;
use crate::clock;
use crate::picture::{Composite, Pixels, Renderer};
use crate::progress::at_once;
use crate::views::{Request, Shot, View};
use camera_lab_words::{Lang, command_line as texts, messages};

/// Pictures drawn before the clock starts, so that buffers have their size.
const WARM_UP: usize = 3;

/// The JSON output.
#[derive(Serialize)]
struct Measurement<'a> {
    view: &'a str,
    width: u32,
    height: u32,
    triangles: usize,
    frames: usize,
    median_ms: f64,
    min_ms: f64,
    p95_ms: f64,
}

pub(super) fn run(args: &BenchArgs, lang: Lang) -> Result<(), Failure> {
    let frames = args.frames(lang)?;
    let subject = OpenFigure::open(&args.figure, &args.common, size(args.size.as_deref(), lang)?, lang)?;
    let OpenFigure { opened, scene, size, lang, .. } = &subject;
    let request = subject.request(View::Image, args.force_all_stages);
    let sheet = Composite::of(args.view, &request, &Shot::of(&opened.figure), None)
        .map_err(|error| no_picture(*lang, &messages::opened(*lang, &args.figure), error.into(), subject.pixels()))?;
    let times = measure(&sheet.requests, frames).ok_or_else(|| subject.too_large())?;
    let measurement = Measurement {
        view: args.view.name(),
        width: size.width,
        height: size.height,
        triangles: scene.objects.iter().map(|object| object.mesh.triangles.len()).sum(),
        frames,
        median_ms: millis(median(&times)),
        min_ms: times.first().copied().map_or(0.0, millis),
        p95_ms: millis(share(&times, 0.95)),
    };
    let text = match args.format {
        TableFormat::Json => json_of(&measurement)?,
        TableFormat::Text => {
            let Measurement { view, width, height, triangles, median_ms, min_ms, p95_ms, .. } = measurement;
            texts::bench(*lang, &format!("{view}, {width} × {height}"), triangles, frames, [median_ms, min_ms, p95_ms])
        }
    };
    print(text.as_bytes(), *lang)
}

/// The times of the frames, shortest first, each drawn from scratch. `None` if pictures can't be so large.
fn measure(requests: &[Request], frames: usize) -> Option<Vec<Duration>> {
    let mut renderer = Renderer::default();
    let mut pictures = vec![Pixels::default(); requests.len()];
    let mut times = Vec::with_capacity(frames);
    for frame in 0..WARM_UP + frames {
        let start = clock::now();
        renderer.forget();
        at_once(renderer.all_into(requests, &mut pictures))?;
        if frame >= WARM_UP {
            times.push(clock::now().saturating_sub(start));
        }
    }
    times.sort();
    Some(times)
}

/// The middle of sorted times, or the mean of the two in the middle.
fn median(times: &[Duration]) -> Duration {
    let middle = |i: usize| times.get(i).copied().unwrap_or_default();
    (middle(times.len().saturating_sub(1) / 2) + middle(times.len() / 2)) / 2
}

/// The time that this share of sorted times doesn't exceed (nearest rank).
fn share(times: &[Duration], share: f64) -> Duration {
    #[expect(clippy::cast_possible_truncation, reason = "a rank in the list, which has a million entries at most")]
    let rank = (share * times.len() as f64).ceil() as usize;
    times.get(rank.saturating_sub(1)).copied().unwrap_or_default()
}

fn millis(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_and_the_slow_end_of_a_list() {
        let times = |n: u64| (1..=n).map(Duration::from_millis).collect::<Vec<_>>();
        assert_eq!(median(&times(1)), Duration::from_millis(1));
        assert_eq!(median(&times(5)), Duration::from_millis(3));
        assert_eq!(median(&times(4)), Duration::from_micros(2500));
        assert_eq!(share(&times(100), 0.95), Duration::from_millis(95));
        assert_eq!(share(&times(3), 0.95), Duration::from_millis(3));
        assert_eq!(share(&times(1), 0.95), Duration::from_millis(1));
    }
}
