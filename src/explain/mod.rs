//! Every number explained: the formulas of the matrices, and a point followed from space to space with all its
//! arithmetic, as data that the window, the command line and exported texts share.
//!
//! A [`Formula`] is written in the notes' [`Symbol`]s; a [`Setting`] (a camera in a convention of NDC, with image,
//! viewport and followed point) gives each of them its number. A formula with its symbols and one with its numbers come
//! from the same tree that is evaluated, so that they cannot disagree.
//!
//! | file | purpose |
//! | --- | --- |
//! | `code` | the camera as code for libraries: the copied code gives the matrices that the program shows |
//! | `definitions` | definitions of each symbol in the notes, down to the parameters |
//! | `factors` | each entry of each step to the canonical volume as a formula |
//! | `formula` | formulas as trees: one tree is evaluated, written with symbols, and written with numbers |
//! | `formula_writer` | formulas as text and as LaTeX: with the notes' symbols, or with the numbers put in |
//! | `homogeneous` | the effects of w: points, the middle of a segment, a chequered floor |
//! | `matrices` | each entry of each matrix as a formula |
//! | `order` | lists of transforms, as calls to a stack of matrices, in both readings |
//! | `report` | the output of `camera-lab inspect` for followed points |
//! | `setting` | the numbers of the symbols |
//! | `step_lines` | the steps of a point's way in writing: each row with its symbols, with its numbers, and its value |
//! | `symbol` | the notes' symbols |
//! | `trace` | a point followed from space to space, with its whole arithmetic |
//! | `vocabulary` | the camera in the vocabularies of other sources and libraries, and back |

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
