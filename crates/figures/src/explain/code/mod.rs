//! The camera as code for libraries. The copied code gives the matrices that the program shows.

mod programs;

use std::fmt::Write as _;

use super::vocabulary::Limitation;
use super::{Matrix, MatrixFormula, Notation, Setting, Writer};
use crate::camera::{AngleUnit, Axes, Camera, ImageSize, Parameters, Program, Projection, ViewWindow};
use crate::numbers::{DecimalMark, exact};

crate::listed! {
    /// A library, or a language.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum CodeTarget {
        /// C with OpenGL 1 and GLU
        #[default]
        OpenGl,
        /// C++ with GLM
        Glm,
        /// Rust with glam
        Glam,
        /// JavaScript with three.js
        ThreeJs,
        /// Python with VTK or `PyVista`
        Vtk,
        /// Python with `NumPy`
        NumPy,
        /// LaTeX
        Latex,
        /// Python in Blender
        Blender,
        /// C# in Unity
        Unity,
        /// C++ in Unreal
        Unreal,
        /// Python with `NumPy`, in the words of `OpenCV`
        OpenCv,
        /// A file of `Open3D`
        Open3d,
        /// Two files of COLMAP
        Colmap,
        /// A file of nerfstudio
        Nerfstudio,
        /// A file of glTF
        Gltf,
        /// Python with `PyTorch3D`
        PyTorch3d,
        /// `GDScript` in Godot
        Godot,
        /// JavaScript with Babylon.js
        Babylon,
        /// Rust with Bevy
        Bevy,
    }
}

/// A fact about a library that's needed to use its camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CodeConvention {
    /// Column vectors, right-handed view space, z_n in −1 … 1.
    OfTheNotes,
    /// Matrices are stored by columns.
    ColumnMajor,
    /// Angles are in radians.
    Radians,
    /// Angles are in degrees.
    Degrees,
    /// Only a centred window. An asymmetric one is set by the matrix, or by window centre.
    WindowCentre,
    /// The matrix is set by hand, because the library has no call for this window.
    ByMatrix,
    /// The camera and the world have these axes.
    Axes(Axes),
    /// Lengths are in centimetres.
    Centimetres,
    /// C is so far behind that of the figure, because the library takes no smaller F.
    MovedBack(f64),
}

/// The rows of the targets, in their order.
static PROGRAMS: [Program; CodeTarget::ALL.len()] = Program::ALL;

impl CodeTarget {
    /// Its row of the table of programs.
    pub const fn program(self) -> &'static Program {
        &PROGRAMS[self as usize]
    }

    /// Its common name.
    pub const fn name(self) -> &'static str {
        self.program().name
    }

    /// Its word on the command line.
    pub const fn word(self) -> &'static str {
        self.program().word
    }

    /// The beginning of a comment line; `None` for JSON, which has no comments.
    pub const fn comment(self) -> Option<&'static str> {
        match self {
            Self::Vtk | Self::NumPy | Self::Blender | Self::OpenCv | Self::Colmap | Self::PyTorch3d | Self::Godot => {
                Some("# ")
            }
            Self::Latex => Some("% "),
            Self::Open3d | Self::Nerfstudio | Self::Gltf => None,
            _ => Some("// "),
        }
    }

    /// The reason why it can't express a camera.
    pub fn limitation(self, camera: &Camera, image: ImageSize) -> Option<Limitation> {
        let parallel = camera.projection() == Projection::Parallel;
        let symmetric = camera.has_symmetric_window();
        match self {
            Self::OpenCv | Self::Open3d | Self::Colmap | Self::Nerfstudio if parallel => {
                Some(Limitation::PerspectiveOnly)
            }
            Self::Gltf | Self::Unreal | Self::Bevy if !symmetric => Some(Limitation::SymmetricOnly),
            Self::Babylon if !symmetric && !parallel => Some(Limitation::SymmetricOnly),
            Self::Godot if !symmetric && parallel => Some(Limitation::SymmetricOnly),
            Self::Blender if programs::blender_lens(camera, image).is_none() => Some(Limitation::OutOfRange),
            _ if camera.near() < self.program().least_near && self.moved_back(camera).is_none() => {
                Some(Limitation::OutOfRange)
            }
            _ => None,
        }
    }

    /// The same camera with the least F that it takes, if its own is smaller. In parallel projection the image stays if
    /// C moves along **n**.
    fn moved_back(self, camera: &Camera) -> Option<(Camera, f64)> {
        let (own, near) = (camera.parameters(), self.program().least_near);
        if own.projection != Projection::Parallel || own.near >= near {
            return None;
        }
        let back = near - own.near;
        let position = own.position + camera.basis().n * back;
        let moved = Camera::new(&Parameters { position, near, far: own.far + back, ..*own });
        moved.ok().map(|camera| (camera, back))
    }

    /// The conventions stated in its code.
    pub fn conventions(self, camera: &Camera) -> Vec<CodeConvention> {
        let program = self.program();
        let axes = CodeConvention::Axes(program.axes);
        let mut said = vec![if program.is_of_the_notes() { CodeConvention::OfTheNotes } else { axes }];
        said.extend(matches!(self, Self::Glm | Self::Glam).then_some(CodeConvention::ColumnMajor));
        said.extend(program.angle.map(|unit| match unit {
            AngleUnit::Degrees => CodeConvention::Degrees,
            AngleUnit::Radians => CodeConvention::Radians,
        }));
        said.extend((program.units == 100.0).then_some(CodeConvention::Centimetres));
        said.extend(self.moved_back(camera).map(|(_, back)| CodeConvention::MovedBack(back)));
        let symmetric = camera.has_symmetric_window();
        said.extend(match self {
            Self::ThreeJs if !symmetric && camera.projection() == Projection::Perspective => {
                Some(CodeConvention::ByMatrix)
            }
            Self::Vtk if !symmetric => Some(CodeConvention::WindowCentre),
            _ => None,
        });
        said
    }

    /// The code, after lines of comment. For a camera that it can't express (see [`Self::limitation`]), it's the code
    /// of another one.
    pub fn code(self, setting: &Setting<'_>, comments: &[String]) -> String {
        let mut text = String::new();
        if let Some(mark) = self.comment() {
            for line in comments {
                let _ = writeln!(text, "{mark}{line}");
            }
        }
        let (camera, image) = (setting.space().camera(), setting.image());
        let moved = self.moved_back(camera);
        let camera = moved.as_ref().map_or(camera, |moved| &moved.0);
        text.push_str(&match self {
            Self::OpenGl => open_gl(camera),
            Self::Glm => glm(camera),
            Self::Glam => glam(camera),
            Self::ThreeJs => three_js(camera),
            Self::Vtk => vtk(camera),
            Self::NumPy => num_py(camera),
            Self::Latex => latex(setting),
            Self::Blender => programs::blender(camera, image),
            Self::Unity => programs::unity(camera),
            Self::Unreal => programs::unreal(camera),
            Self::OpenCv => programs::open_cv(camera, image),
            Self::Open3d => programs::open3d(camera, image),
            Self::Colmap => programs::colmap(camera, image),
            Self::Nerfstudio => programs::nerfstudio(camera, image),
            Self::Gltf => programs::gltf(camera),
            Self::PyTorch3d => programs::pytorch3d(camera, image),
            Self::Godot => programs::godot(camera),
            Self::Babylon => programs::babylon(camera),
            Self::Bevy => programs::bevy(camera),
        });
        text
    }
}

/// Numbers one after the other, each in all its digits.
fn list(values: impl IntoIterator<Item = f64>) -> String {
    values.into_iter().map(|x| exact(x + 0.0)).collect::<Vec<_>>().join(", ")
}

fn sides(camera: &Camera) -> [f64; 4] {
    let ViewWindow { left, right, bottom, top } = camera.window();
    [left, right, bottom, top]
}

/// C, PF and VUP, three numbers each.
fn pose(camera: &Camera) -> [String; 3] {
    [camera.position(), camera.focal_point(), camera.view_up()].map(|v| list(v.to_array()))
}

/// θ in radians, A, F and B of a symmetric perspective.
fn perspective(camera: &Camera, angle: f64) -> String {
    list([angle, camera.window_aspect(), camera.near(), camera.far()])
}

/// A call of the function for a symmetric perspective, for any perspective, or for a parallel projection.
fn lens_call(camera: &Camera, angle: f64, [symmetric, frustum, ortho]: [&str; 3]) -> String {
    let function = match (camera.projection(), camera.has_symmetric_window()) {
        (Projection::Perspective, true) => return format!("{symmetric}({})", perspective(camera, angle)),
        (Projection::Perspective, false) => frustum,
        (Projection::Parallel, _) => ortho,
    };
    format!("{function}({})", list(sides(camera).into_iter().chain([camera.near(), camera.far()])))
}

fn open_gl(camera: &Camera) -> String {
    let [eye, centre, up] = pose(camera);
    let lens = lens_call(camera, camera.view_angle().degrees(), ["gluPerspective", "glFrustum", "glOrtho"]);
    format!(
        "glMatrixMode(GL_PROJECTION);\nglLoadIdentity();\n{lens};\nglMatrixMode(GL_MODELVIEW);\nglLoadIdentity();\ngluLookAt({eye}, {centre}, {up});\n"
    )
}

fn glm(camera: &Camera) -> String {
    let [eye, centre, up] = pose(camera);
    let functions = ["glm::perspectiveRH_NO", "glm::frustumRH_NO", "glm::orthoRH_NO"];
    let lens = lens_call(camera, camera.view_angle().radians(), functions);
    format!(
        "glm::dmat4 view = glm::lookAtRH(glm::dvec3({eye}), glm::dvec3({centre}), glm::dvec3({up}));\nglm::dmat4 projection = {lens};\n"
    )
}

fn glam(camera: &Camera) -> String {
    let [eye, centre, up] = pose(camera);
    let lens = lens_call(camera, camera.view_angle().radians(), ["perspective", "frustum", "orthographic"]);
    format!(
        "let view = glam::dcamera::rh::view::look_at_mat4(glam::dvec3({eye}), glam::dvec3({centre}), glam::dvec3({up}));\nlet projection = glam::dcamera::rh::proj::opengl::{lens};\n"
    )
}

fn three_js(camera: &Camera) -> String {
    let [eye, centre, up] = pose(camera);
    let [left, right, bottom, top] = sides(camera);
    let (near, far) = (camera.near(), camera.far());
    let lens = match (camera.projection(), camera.has_symmetric_window()) {
        (Projection::Perspective, true) => {
            format!(
                "const camera = new THREE.PerspectiveCamera({});\n",
                perspective(camera, camera.view_angle().degrees())
            )
        }
        (Projection::Perspective, false) => format!(
            "const camera = new THREE.PerspectiveCamera();\ncamera.projectionMatrix.makePerspective({});\ncamera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();\n",
            list([left, right, top, bottom, near, far])
        ),
        (Projection::Parallel, _) => {
            format!("const camera = new THREE.OrthographicCamera({});\n", list([left, right, top, bottom, near, far]))
        }
    };
    format!(
        "{lens}camera.position.set({eye});\ncamera.up.set({up});\ncamera.lookAt({centre});\ncamera.updateMatrixWorld();\n"
    )
}

fn vtk(camera: &Camera) -> String {
    let [eye, centre, up] = pose(camera);
    let mut text = format!(
        "camera = vtk.vtkCamera()  # PyVista: camera = plotter.camera\ncamera.SetPosition({eye})\ncamera.SetFocalPoint({centre})\ncamera.SetViewUp({up})\ncamera.SetClippingRange({})\n",
        list([camera.near(), camera.far()])
    );
    let [left, right, bottom, top] = sides(camera);
    match camera.projection() {
        Projection::Perspective => {
            // VTK's angle is that of a symmetric window as high as this one.
            let angle = 2.0 * (camera.window_height() / 2.0).atan2(camera.near()).to_degrees();
            let angle = if camera.has_symmetric_window() { camera.view_angle().degrees() } else { angle };
            let _ = writeln!(text, "camera.SetViewAngle({})", exact(angle));
        }
        Projection::Parallel => {
            let _ = writeln!(
                text,
                "camera.ParallelProjectionOn()\ncamera.SetParallelScale({})",
                exact(camera.window_height() / 2.0)
            );
        }
    }
    if !camera.has_symmetric_window() {
        // In half windows.
        let centre = [(left + right) / camera.window_width(), (bottom + top) / camera.window_height()];
        let _ = writeln!(text, "camera.SetWindowCenter({})", list(centre));
    }
    let _ = writeln!(
        text,
        "projection = camera.GetProjectionTransformMatrix({}, -1, 1)\nview = camera.GetViewTransformMatrix()",
        exact(camera.window_aspect())
    );
    text
}

fn num_py(camera: &Camera) -> String {
    let [eye, centre, up] = pose(camera);
    let [left, right, bottom, top] = sides(camera);
    let mut text = format!(
        "import numpy as np\n\nC, PF, VUP = np.array([{eye}]), np.array([{centre}]), np.array([{up}])\nn = (C - PF) / np.linalg.norm(C - PF)\nu = np.cross(VUP, n)\nu /= np.linalg.norm(u)\nv = np.cross(n, u)\nview = np.eye(4)\nview[:3, :3] = u, v, n\nview[:3, 3] = -view[:3, :3] @ C\n\nl, r, b, t, F, B = {}\n",
        list([left, right, bottom, top, camera.near(), camera.far()])
    );
    text.push_str(match camera.projection() {
        Projection::Perspective => {
            "projection = np.array([\n    [2 * F / (r - l), 0, (r + l) / (r - l), 0],\n    [0, 2 * F / (t - b), (t + b) / (t - b), 0],\n    [0, 0, -(B + F) / (B - F), -2 * B * F / (B - F)],\n    [0, 0, -1, 0],\n])\n"
        }
        Projection::Parallel => {
            "projection = np.array([\n    [2 / (r - l), 0, 0, -(r + l) / (r - l)],\n    [0, 2 / (t - b), 0, -(t + b) / (t - b)],\n    [0, 0, -2 / (B - F), -(B + F) / (B - F)],\n    [0, 0, 0, 1],\n])\n"
        }
    });
    text
}

fn latex(setting: &Setting<'_>) -> String {
    let mut text = String::new();
    let plain = Writer { notation: Notation::Latex, mark: DecimalMark::Point, numbers: None };
    for matrix in [Matrix::View, Matrix::Projection] {
        let formulas = MatrixFormula::new(matrix, setting);
        let numbers = setting.matrix(matrix);
        let rows = |write: &dyn Fn(usize, usize) -> String| {
            let row = |i: usize| (0..4).map(|j| write(i, j)).collect::<Vec<_>>().join(" & ");
            (0..4).map(row).collect::<Vec<_>>().join(" \\\\\n  ")
        };
        let _ = writeln!(
            text,
            "\\[\n{} =\n\\begin{{bmatrix}}\n  {}\n\\end{{bmatrix}}\n=\n\\begin{{bmatrix}}\n  {}\n\\end{{bmatrix}}\n\\]",
            matrix.latex(),
            rows(&|i, j| plain.write(formulas.entry(i, j))),
            rows(&|i, j| plain.number(numbers.row(i)[j] + 0.0)),
        );
    }
    text
}
