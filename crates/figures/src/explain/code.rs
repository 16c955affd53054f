//! The camera as code for libraries: the copied code gives the matrices that the program shows.

use std::fmt::Write as _;

use super::{Matrix, MatrixFormula, Notation, Setting, Writer};
use crate::camera::{Camera, Projection, ViewWindow};
use crate::numbers::{DecimalMark, exact};

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
}

/// A fact about a library that is needed to use its camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CodeConvention {
    /// Column vectors, right-handed view space, z_n in −1 … 1.
    OfTheNotes,
    /// Matrices are stored by columns.
    ColumnMajor,
    /// Angles are in radians.
    Radians,
    /// Angles are in degrees.
    Degrees,
    /// Only a centred window: an asymmetric one is set by the matrix, or by window centre.
    WindowCentre,
    /// The matrix is set by hand: the library has no call for this window.
    ByMatrix,
}

impl CodeTarget {
    /// All of them.
    pub const ALL: [Self; 7] =
        [Self::OpenGl, Self::Glm, Self::Glam, Self::ThreeJs, Self::Vtk, Self::NumPy, Self::Latex];

    /// Its common name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::OpenGl => "OpenGL, GLU",
            Self::Glm => "GLM",
            Self::Glam => "glam",
            Self::ThreeJs => "three.js",
            Self::Vtk => "VTK, PyVista",
            Self::NumPy => "NumPy",
            Self::Latex => "LaTeX",
        }
    }

    /// Its word on the command line.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::OpenGl => "opengl",
            Self::Glm => "glm",
            Self::Glam => "glam",
            Self::ThreeJs => "threejs",
            Self::Vtk => "vtk",
            Self::NumPy => "numpy",
            Self::Latex => "latex",
        }
    }

    /// The beginning of a comment line.
    #[must_use]
    pub const fn comment(self) -> &'static str {
        match self {
            Self::OpenGl | Self::Glm | Self::Glam | Self::ThreeJs => "// ",
            Self::Vtk | Self::NumPy => "# ",
            Self::Latex => "% ",
        }
    }

    /// The conventions stated in its code.
    #[must_use]
    pub fn conventions(self, camera: &Camera) -> Vec<CodeConvention> {
        let mut said = vec![CodeConvention::OfTheNotes];
        match self {
            Self::OpenGl => said.push(CodeConvention::Degrees),
            Self::Glm | Self::Glam => said.extend([CodeConvention::ColumnMajor, CodeConvention::Radians]),
            Self::ThreeJs => {
                said.push(CodeConvention::Degrees);
                if !camera.has_symmetric_window() && camera.projection() == Projection::Perspective {
                    said.push(CodeConvention::ByMatrix);
                }
            }
            Self::Vtk => {
                said.push(CodeConvention::Degrees);
                if !camera.has_symmetric_window() {
                    said.push(CodeConvention::WindowCentre);
                }
            }
            Self::NumPy | Self::Latex => {}
        }
        said
    }

    /// The code, behind lines of comment.
    #[must_use]
    pub fn code(self, setting: &Setting<'_>, comments: &[String]) -> String {
        let mut text = String::new();
        for line in comments {
            let _ = writeln!(text, "{}{line}", self.comment());
        }
        let camera = setting.space().camera();
        text.push_str(&match self {
            Self::OpenGl => open_gl(camera),
            Self::Glm => glm(camera),
            Self::Glam => glam(camera),
            Self::ThreeJs => three_js(camera),
            Self::Vtk => vtk(camera),
            Self::NumPy => num_py(camera),
            Self::Latex => latex(setting),
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

/// l, r, b, t, F, B.
fn frustum(camera: &Camera) -> String {
    list(sides(camera).into_iter().chain([camera.near(), camera.far()]))
}

/// θ in radians, A, F, B: those of a symmetric perspective.
fn perspective(camera: &Camera, angle: f64) -> String {
    list([angle, camera.window_aspect(), camera.near(), camera.far()])
}

fn open_gl(camera: &Camera) -> String {
    let [eye, centre, up] = pose(camera);
    let lens = match (camera.projection(), camera.has_symmetric_window()) {
        (Projection::Perspective, true) => {
            format!("gluPerspective({});", perspective(camera, camera.view_angle().degrees()))
        }
        (Projection::Perspective, false) => format!("glFrustum({});", frustum(camera)),
        (Projection::Parallel, _) => format!("glOrtho({});", frustum(camera)),
    };
    format!(
        "glMatrixMode(GL_PROJECTION);\nglLoadIdentity();\n{lens}\nglMatrixMode(GL_MODELVIEW);\nglLoadIdentity();\ngluLookAt({eye}, {centre}, {up});\n"
    )
}

fn glm(camera: &Camera) -> String {
    let [eye, centre, up] = pose(camera);
    let lens = match (camera.projection(), camera.has_symmetric_window()) {
        (Projection::Perspective, true) => {
            format!("glm::perspectiveRH_NO({})", perspective(camera, camera.view_angle().radians()))
        }
        (Projection::Perspective, false) => format!("glm::frustumRH_NO({})", frustum(camera)),
        (Projection::Parallel, _) => format!("glm::orthoRH_NO({})", frustum(camera)),
    };
    format!(
        "glm::dmat4 view = glm::lookAtRH(glm::dvec3({eye}), glm::dvec3({centre}), glm::dvec3({up}));\nglm::dmat4 projection = {lens};\n"
    )
}

fn glam(camera: &Camera) -> String {
    let [eye, centre, up] = pose(camera);
    let lens = match (camera.projection(), camera.has_symmetric_window()) {
        (Projection::Perspective, true) => {
            format!(
                "glam::dcamera::rh::proj::opengl::perspective({})",
                perspective(camera, camera.view_angle().radians())
            )
        }
        (Projection::Perspective, false) => format!("glam::dcamera::rh::proj::opengl::frustum({})", frustum(camera)),
        (Projection::Parallel, _) => format!("glam::dcamera::rh::proj::opengl::orthographic({})", frustum(camera)),
    };
    format!(
        "let view = glam::dcamera::rh::view::look_at_mat4(glam::dvec3({eye}), glam::dvec3({centre}), glam::dvec3({up}));\nlet projection = {lens};\n"
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
