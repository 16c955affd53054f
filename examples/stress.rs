//! Tries cameras, operations, points and scenes that no person would write:
//! `cargo run --release --example stress -- [COUNT] [SEED] [FIRST]`.
//!
//! Prints the seed. For a case that fails, panics or takes longer than a second, it prints the arguments that repeat
//! it.
#![expect(clippy::print_stdout, reason = "a program")]

#[path = "../tests/it/stress_case.rs"]
mod stress;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use stress::{Tried, case};

fn main() -> ExitCode {
    let mut numbers = std::env::args().skip(1).map(|argument| argument.parse::<u64>());
    let mut number = |default: u64| numbers.next().and_then(Result::ok).unwrap_or(default);
    let now = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_secs());
    let (count, seed, first) = (number(10_000_000), number(now), number(0));
    println!("{count} cameras, seed {seed}");
    let (mut tried, mut failed, started) = (Tried::default(), 0, Instant::now());
    for k in first..first + count {
        let begun = Instant::now();
        let outcome = catch_unwind(AssertUnwindSafe(|| case(seed, k, 500, &mut tried)));
        let what = match outcome {
            Err(_) => "panicked".to_owned(),
            Ok(Err(what)) => what,
            Ok(Ok(())) if begun.elapsed() > Duration::from_secs(1) => format!("took {:?}", begun.elapsed()),
            Ok(Ok(())) => continue,
        };
        failed += 1;
        println!("stress 1 {seed} {k}: {what}");
        if failed == 20 {
            break;
        }
    }
    println!("{tried:?} in {:.0?}: {failed} failed", started.elapsed());
    if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
