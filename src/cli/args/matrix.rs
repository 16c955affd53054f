//! The arguments of `matrix`.

use std::path::PathBuf;

use clap::Args;

use super::words::{TableFormat, one_of};
use crate::camera::{Axes, MatrixKind, Ndc};
use crate::cli::args::figure::FigureArgs;
use camera_lab_words::Lang;
use camera_lab_words::why::conventions;

#[derive(Debug, Args)]
pub(in crate::cli) struct MatrixArgs {
    /// Figure file, or a PNG, SVG or PDF that camera-lab wrote. Its camera has what the matrix leaves open, such as F
    /// and B
    pub(in crate::cli) figure: PathBuf,
    #[command(flatten)]
    pub(in crate::cli) common: FigureArgs,
    /// A matrix, K, a quaternion and t, or C, PF and VUP, as any program prints them
    #[arg(long, allow_hyphen_values = true, required_unless_present = "from", conflicts_with = "from")]
    pub(in crate::cli) numbers: Option<String>,
    /// A file of another program: JSON of `Open3D`, nerfstudio or three.js, glTF, GLB, YAML of `OpenCV`, `cameras.txt`
    /// and `images.txt` of COLMAP, KITTI, TUM, or any text with a matrix
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) from: Option<PathBuf>,
    /// Which of several cameras: its number from 1, or its name; the first without it. `all`: the first becomes the
    /// figure's, and the others its `[[cameras]]`
    #[arg(long, value_name = "N")]
    pub(in crate::cli) camera: Option<String>,
    /// Kind of the matrix; without it, the program recognises it. camera-to-world: `matrix_world` of Blender, a node of
    /// glTF, `matrixWorld` of three.js; pinhole: K [R | t]; intrinsics: K alone; look-at: C, PF and VUP
    #[arg(long = "as", value_parser = one_of(MatrixKind::ALL, MatrixKind::name), value_name = "KIND")]
    pub(in crate::cli) kind: Option<MatrixKind>,
    /// Program or convention whose axes the matrix has; without it, the program recognises them
    #[arg(long, value_parser = one_of(Axes::ALL, |axes: Axes| axes.name), value_name = "NAME", long_help = axes_help())]
    pub(in crate::cli) axes: Option<Axes>,
    /// The numbers go down the columns first, or the matrix is for row vectors
    #[arg(long)]
    pub(in crate::cli) columns: bool,
    /// Convention of the normalised device coordinates of a projection; without it, the program recognises it
    #[arg(long, value_parser = one_of(Ndc::ALL, Ndc::name), value_name = "NAME")]
    pub(in crate::cli) ndc: Option<Ndc>,
    /// The size in pixels of the image that K belongs to; without it, the figure's image size
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub(in crate::cli) size: Option<String>,
    /// A figure file, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: TableFormat,
}

/// The table of axes.
fn axes_help() -> String {
    let table = conventions::axes_table(Lang::En, |axes| axes.name);
    format!("Program or convention whose axes the matrix has; without it, the program recognises them\n{table}")
}
