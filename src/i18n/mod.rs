//! Every text in both languages, as typed Rust values.

pub mod canvas;
pub mod command_line;
pub mod faults;
mod figure_files;
mod meshes;
pub mod messages;
pub mod pictures;
pub mod pipeline;
pub mod window;

/// A language of the interface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Lang {
    /// English.
    #[default]
    En,
    /// Brazilian Portuguese.
    PtBr,
}
