//! The one table of conventions: handedness, axes of camera and world, NDC, orders and units of programs.
//!
//! Reading, writing, the window, `--axes`, `--ndc` and the table of the guide take their rows from here. Each row is
//! data. A new program is a row of [`Program::ALL`], and new axes are a row of [`Axes::ALL`].

mod axes;
mod ndc;
mod order;
mod programs;
mod range;

pub use axes::{Axes, Toward, WorldUp};
pub use ndc::{Api, InfiniteParallel, Ndc};
pub use order::Order;
pub use programs::{AngleUnit, Program};
pub use range::NdcRange;
