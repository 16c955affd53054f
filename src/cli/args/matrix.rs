//! The arguments of `matrix`.

use std::path::PathBuf;

use clap::Args;

use super::words::{TableFormat, one_of};
use crate::camera::{Axes, ImageSize, MatrixKind, Ndc};
use crate::cli::Failure;
use crate::cli::args::figure::{FigureArgs, size};
use crate::i18n::Lang;

#[derive(Debug, Args)]
pub(in crate::cli) struct MatrixArgs {
    /// Figure file, or a PNG that camera-lab wrote; its camera has what the matrix leaves open, such as F and B
    pub(in crate::cli) figure: PathBuf,
    #[command(flatten)]
    pub(in crate::cli) common: FigureArgs,
    /// The sixteen numbers of the matrix, or the twelve of K [R | t], row by row, as any program writes them
    #[arg(long, allow_hyphen_values = true)]
    pub(in crate::cli) numbers: String,
    /// Kind of the matrix; without it, that is recognised. camera-to-world: `matrix_world` of Blender, a node of glTF,
    /// `matrixWorld` of three.js; pinhole: K [R | t]
    #[arg(long = "as", value_parser = one_of(MatrixKind::ALL, MatrixKind::name), value_name = "KIND")]
    pub(in crate::cli) kind: Option<MatrixKind>,
    /// Whose axes; without it, they are recognised. opengl: x right, y up, z towards the viewer, y up in the world
    /// (glTF and three.js too); blender: z up in the world, which is turned; opencv: x right, y down, z into the scene
    #[arg(long, value_parser = one_of(Axes::ALL, Axes::name), value_name = "NAME")]
    pub(in crate::cli) axes: Option<Axes>,
    /// The numbers go down the columns first, or the matrix is for row vectors
    #[arg(long)]
    pub(in crate::cli) columns: bool,
    /// Whose normalised device coordinates a projection leads to
    #[arg(long, value_parser = one_of(Ndc::ALL, Ndc::name), value_name = "NAME", default_value = Ndc::default().name())]
    pub(in crate::cli) ndc: Ndc,
    /// The size in pixels of the image that K belongs to; without it, the figure's image size
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    size: Option<String>,
    /// A figure file, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: TableFormat,
}

impl MatrixArgs {
    /// The size of the image of K, if it is given.
    pub(in crate::cli) fn size(&self, lang: Lang) -> Result<Option<ImageSize>, Failure> {
        size(self.size.as_deref(), lang)
    }
}
