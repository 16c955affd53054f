//! A sample of the cases that the example `stress` tries by the million.

use crate::stress_case::{Tried, case};

#[test]
fn no_camera_operation_or_scene_breaks_an_invariant() {
    let mut tried = Tried::default();
    for k in 0..20_000 {
        if let Err(what) = case(20_261_122, k, 100, &mut tried) {
            panic!("cargo run --release --example stress -- 1 20261122 {k}: {what}");
        }
    }
    assert!(tried.cameras > 10_000 && tried.pictures > 200, "{tried:?}");
}

/// Cases that failed once, by seed and number.
#[test]
fn cases_that_failed_once_pass() {
    for (seed, k) in FOUND {
        assert_eq!(case(seed, k, 1, &mut Tried::default()), Ok(()), "{seed} {k}");
    }
}

const FOUND: [(u64, u64); 1] = [(20_261_122, 9500)];
