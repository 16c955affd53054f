//! Helpers of the tests.

#[expect(dead_code, reason = "the engine needs the rest")]
#[path = "engine.rs"]
mod engine;
pub(crate) mod named_files;
pub(crate) mod program;
pub(crate) mod rendered;
pub(crate) mod shot;

pub(crate) use engine::*;
