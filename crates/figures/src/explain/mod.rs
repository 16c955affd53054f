//! Every number explained: the formulas of the matrices, and a point followed from space to space with all its
//! arithmetic, as data that the window, the command line and exported texts share.
//!
//! A [`Formula`] is written in the notes' [`Symbol`]s. A [`Setting`] (a camera in a convention of NDC, with image,
//! viewport and followed point) gives each of them its number. A formula with its symbols and one with its numbers come
//! from the same tree that's evaluated, so they can't disagree.

pub mod code;
mod definitions;
mod factors;
mod formula;
mod formula_writer;
pub mod homogeneous;
mod matrices;
pub mod order;
mod report;
mod setting;
mod step_lines;
mod symbol;
mod trace;
pub mod vocabulary;

pub use definitions::{Definition, definition, leaves};
pub use factors::factor_entries;
pub use formula::{Formula, Function, Named, minus, over, plus, sum, times};
pub use formula_writer::{Notation, Numbers, Writer};
pub use matrices::{EntryFormula, MatrixFormula, entry_product, projection_equation};
pub use report::{DepthPixelReport, json};
pub use setting::{Placement, Setting};
pub use step_lines::{Line, Style, aligned, written};
pub use symbol::{Axis, Component, Matrix, Symbol, Vector};
pub use trace::{Step, back, forward};
