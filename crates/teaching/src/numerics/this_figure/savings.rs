//! The savings of the plan: the time that each stage it leaves out would have cost this frame.

use std::time::Duration;

use crate::clock;
use crate::numerics::times::Interval;
use crate::picture::{Pixels, Renderer};
use crate::pipeline::Stage;
use crate::progress::Progress;
use crate::views::Request;

/// Frames that are drawn before the clock starts, so that buffers have their size.
const WARM_UP: usize = 2;
/// Rounds, at least and at most.
const ROUNDS: [usize; 2] = [7, 500];

/// A stage that the plan leaves out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Saving {
    /// The stage.
    pub stage: Stage,
    /// Milliseconds by which the frame is slower if the stage runs. Around 0 if that can't be measured.
    pub ms: Interval,
    /// The frame has the same bytes with the stage.
    pub same_bytes: bool,
}

/// Draws a frame as planned and with each of some stages forced, in turns, for about this many seconds. `None` if there
/// isn't enough memory, or it was cancelled.
pub async fn savings(request: &Request, left_out: &[Stage], seconds: f64, progress: &Progress) -> Option<Vec<Saving>> {
    let forced = |&stage: &Stage| Request { force_stage: Some(stage), ..request.clone() };
    let requests: Vec<Request> = std::iter::once(request.clone()).chain(left_out.iter().map(forced)).collect();
    let mut renderer = Renderer::default();
    let mut pictures = vec![Pixels::default(); requests.len()];
    let mut times: Vec<Vec<f64>> = vec![Vec::new(); requests.len()];
    let end = clock::now() + Duration::try_from_secs_f64(seconds).unwrap_or_default();
    for round in 0..WARM_UP + ROUNDS[1] {
        for k in 0..requests.len() {
            let k = super::turn(k, round, requests.len());
            let start = clock::now();
            renderer.forget();
            renderer.pixels_into(&requests[k], &mut pictures[k]).await?;
            if round >= WARM_UP {
                times[k].push(clock::now().saturating_sub(start).as_secs_f64() * 1e3);
            }
            if progress.is_cancelled() {
                return None;
            }
            crate::progress::pause().await;
        }
        if round + 1 >= WARM_UP + ROUNDS[0] && clock::now() >= end {
            break;
        }
    }
    let (planned, forced) = times.split_first()?;
    let saving = |(k, (&stage, times)): (usize, (&Stage, &Vec<f64>))| {
        let differences: Vec<f64> = times.iter().zip(planned).map(|(forced, planned)| forced - planned).collect();
        Saving { stage, ms: Interval::bootstrap(&differences), same_bytes: pictures[k + 1] == pictures[0] }
    };
    Some(left_out.iter().zip(forced).enumerate().map(saving).collect())
}
