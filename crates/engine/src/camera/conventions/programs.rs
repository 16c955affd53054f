//! The table of programs: the axes, the NDC, the order and the units of each, one row each.

use super::{Api, Axes, Ndc, Order};

/// The unit of a vertical view angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AngleUnit {
    /// Degrees.
    Degrees,
    /// Radians.
    Radians,
}

/// The conventions of a program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Program {
    /// Its common name.
    pub name: &'static str,
    /// Its word on the command line.
    pub word: &'static str,
    /// The axes of its camera and of its world.
    pub axes: Axes,
    /// The NDC of its M_p; `None` if it has pixels instead.
    pub ndc: Option<Ndc>,
    /// The order in which it keeps or prints the numbers of a matrix for column vectors. Row vectors have them by
    /// columns.
    pub order: Order,
    /// The unit of its vertical view angle; `None` if its lens is another number.
    pub angle: Option<AngleUnit>,
    /// Its units of length in ours.
    pub units: f64,
    /// The least F that it takes. Below it, it would cut other points.
    pub least_near: f64,
}

const RADIANS: Option<AngleUnit> = Some(AngleUnit::Radians);
const DEGREES: Option<AngleUnit> = Some(AngleUnit::Degrees);
const OPENGL: Option<Ndc> = Some(Ndc { api: Api::OpenGl, reversed: false, infinite: false });

/// Depth reversed and without a back plane.
const fn reversed_infinite(api: Api) -> Option<Ndc> {
    Some(Ndc { api, reversed: true, infinite: true })
}

impl Program {
    /// The conventions of `[0]`, by columns.
    const OF_THE_NOTES: Self = Self {
        name: "OpenGL, GLU",
        word: "opengl",
        axes: Axes::OPENGL,
        ndc: OPENGL,
        order: Order::Columns,
        angle: DEGREES,
        units: 1.0,
        least_near: f64::NEG_INFINITY,
    };

    /// A program with pixels instead of NDC.
    const OF_PIXELS: Self =
        Self { axes: Axes::OPENCV, ndc: None, order: Order::Rows, angle: None, ..Self::OF_THE_NOTES };

    /// All, in the order in which they are listed.
    pub const ALL: [Self; 19] = [
        Self::OF_THE_NOTES,
        Self { name: "GLM", word: "glm", angle: RADIANS, ..Self::OF_THE_NOTES },
        Self { name: "glam", word: "glam", angle: RADIANS, ..Self::OF_THE_NOTES },
        Self { name: "three.js", word: "threejs", ..Self::OF_THE_NOTES },
        Self { name: "VTK, PyVista", word: "vtk", order: Order::Rows, least_near: 1e-20, ..Self::OF_THE_NOTES },
        Self { name: "NumPy", word: "numpy", order: Order::Rows, angle: None, ..Self::OF_THE_NOTES },
        Self { name: "LaTeX", word: "latex", order: Order::Rows, angle: None, ..Self::OF_THE_NOTES },
        // Its lens is a focal length.
        Self {
            name: "Blender",
            word: "blender",
            axes: Axes::BLENDER,
            order: Order::Rows,
            angle: None,
            least_near: 1e-6,
            ..Self::OF_THE_NOTES
        },
        Self { name: "Unity", word: "unity", axes: Axes::DIRECT3D, order: Order::Rows, ..Self::OF_THE_NOTES },
        // Its view angle is horizontal.
        Self {
            name: "Unreal",
            word: "unreal",
            axes: Axes::UNREAL,
            ndc: reversed_infinite(Api::Direct3d),
            angle: None,
            units: 100.0,
            ..Self::OF_THE_NOTES
        },
        Self { name: "OpenCV", word: "opencv", ..Self::OF_PIXELS },
        Self { name: "Open3D", word: "open3d", order: Order::Columns, ..Self::OF_PIXELS },
        Self { name: "COLMAP", word: "colmap", order: Order::WxyzThenT, ..Self::OF_PIXELS },
        Self { name: "nerfstudio", word: "nerfstudio", axes: Axes::BLENDER, ..Self::OF_PIXELS },
        Self { name: "glTF", word: "gltf", angle: RADIANS, least_near: 0.0, ..Self::OF_THE_NOTES },
        Self { name: "PyTorch3D", word: "pytorch3d", axes: Axes::PYTORCH3D, order: Order::Columns, ..Self::OF_PIXELS },
        Self { name: "Godot", word: "godot", ..Self::OF_THE_NOTES },
        Self { name: "Babylon.js", word: "babylon", axes: Axes::DIRECT3D, angle: RADIANS, ..Self::OF_THE_NOTES },
        Self { name: "Bevy", word: "bevy", ndc: reversed_infinite(Api::WebGpu), angle: RADIANS, ..Self::OF_THE_NOTES },
    ];

    /// True if all programs with these axes write matrices by columns. False if there is none.
    pub(crate) fn is_always_by_columns(axes: Axes) -> bool {
        let mut own = Self::ALL.iter().filter(|program| program.axes == axes).peekable();
        own.peek().is_some() && own.all(|program| program.order == Order::Columns)
    }

    /// True if it has the axes and the NDC of `[0]`.
    pub fn is_of_the_notes(&self) -> bool {
        self.axes == Axes::OPENGL && self.ndc == Some(Ndc::default())
    }
}
