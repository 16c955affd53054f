//! The proof of figures and their numbers, in one binary.

#[expect(dead_code, reason = "the engine needs the rest")]
#[path = "../../../../tests/common/engine.rs"]
mod common;

mod explain_formulas;
mod inspect_report;
mod lens;
mod pipeline_project;
mod textures;
