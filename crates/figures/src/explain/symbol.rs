//! The notes' symbols.

use crate::inspect::quantity::ReportMatrix;

/// A coordinate of a point or of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Component {
    /// x
    X,
    /// y
    Y,
    /// z
    Z,
    /// w, of homogeneous coordinates
    W,
}

impl Component {
    /// x, y and z.
    pub const THREE: [Self; 3] = [Self::X, Self::Y, Self::Z];
    /// x, y, z and w.
    pub const FOUR: [Self; 4] = [Self::X, Self::Y, Self::Z, Self::W];

    /// Its place in a row.
    pub const fn index(self) -> usize {
        self as usize
    }

    /// `x`, `y` or `z`.
    pub const fn letter(self) -> char {
        ['x', 'y', 'z', 'w'][self.index()]
    }
}

/// An axis of the VRC.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// **u**
    U,
    /// **v**
    V,
    /// **n**
    N,
}

impl Axis {
    /// In the order of the rows of M_v.
    pub const ALL: [Self; 3] = [Self::U, Self::V, Self::N];
}

/// A vector that has a name of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Vector {
    /// **u**, **v** or **n**
    Axis(Axis),
    /// **c** = C − O
    Position,
    /// PF − C
    ToFocalPoint,
    /// VUP × **n**
    UpCrossNormal,
}

crate::worded! {
    /// A matrix of the notes, or its inverse.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Matrix {
        /// M_m, of one object: local → world.
        Model = "M_m",
        /// `M_m⁻¹`
        InverseModel = "M_m⁻¹",
        /// The M_m of the object's parent.
        Parent = "M_parent",
        /// Its inverse.
        InverseParent = "M_parent⁻¹",
        /// M_v, `[0]` (5.7): world → view.
        View = "M_v",
        /// `M_v⁻¹`
        InverseView = "M_v⁻¹",
        /// M_p, `[0]` (5.13) to (5.16): view → clip.
        Projection = "M_p",
        /// `M_p⁻¹`
        InverseProjection = "M_p⁻¹",
        /// M_p M_v: world → clip.
        ViewProjection = "M_p M_v",
        /// `(M_p M_v)⁻¹`: clip → world.
        InverseViewProjection = "(M_p M_v)⁻¹",
        /// `M_vp`, of (5.24) before the floor, and (5.25): NDC → viewport.
        Viewport = "M_vp",
        /// `M_vp⁻¹`
        InverseViewport = "M_vp⁻¹",
    }
    /// Its symbol as text: `M_v`, `M_p⁻¹`.
    pub fn text
}

impl From<ReportMatrix> for Matrix {
    fn from(reported: ReportMatrix) -> Self {
        match reported {
            ReportMatrix::View => Self::View,
            ReportMatrix::Projection => Self::Projection,
            ReportMatrix::ViewProjection => Self::ViewProjection,
            ReportMatrix::InverseView => Self::InverseView,
            ReportMatrix::InverseProjection => Self::InverseProjection,
        }
    }
}

impl Matrix {
    /// The matrix that undoes it, its symbol in LaTeX, and the letters of its entries.
    const fn row(self) -> (Self, &'static str, &'static str) {
        match self {
            Self::Model => (Self::InverseModel, r"\mathbf{M}_m", "m"),
            Self::InverseModel => (Self::Model, r"\mathbf{M}_m^{-1}", "m"),
            Self::Parent => (Self::InverseParent, r"\mathbf{M}_{\mathrm{parent}}", "a"),
            Self::InverseParent => (Self::Parent, r"\mathbf{M}_{\mathrm{parent}}^{-1}", "a"),
            Self::View => (Self::InverseView, r"\mathbf{M}_v", "v"),
            Self::InverseView => (Self::View, r"\mathbf{M}_v^{-1}", "v"),
            Self::Projection => (Self::InverseProjection, r"\mathbf{M}_p", "p"),
            Self::InverseProjection => (Self::Projection, r"\mathbf{M}_p^{-1}", "p"),
            Self::ViewProjection => (Self::InverseViewProjection, r"\mathbf{M}_p \mathbf{M}_v", "q"),
            Self::InverseViewProjection => (Self::ViewProjection, r"(\mathbf{M}_p \mathbf{M}_v)^{-1}", "q"),
            Self::Viewport => (Self::InverseViewport, r"\mathbf{M}_{vp}", "d"),
            Self::InverseViewport => (Self::Viewport, r"\mathbf{M}_{vp}^{-1}", "d"),
        }
    }

    /// The matrix that undoes it.
    #[must_use]
    pub const fn inverse(self) -> Self {
        self.row().0
    }

    /// Its symbol in LaTeX.
    pub const fn latex(self) -> &'static str {
        self.row().1
    }

    /// The letters of its entries: `p` in p₁₁.
    pub(super) const fn entry_letter(self) -> &'static str {
        self.row().2
    }
}

/// A symbol for a number in a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Symbol {
    /// `u_x` … `n_z`
    Axis(Axis, Component),
    /// `c_x`, `c_y`, `c_z`: C
    Position(Component),
    /// `PF_x`, `PF_y`, `PF_z`
    FocalPoint(Component),
    /// `VUP_x`, `VUP_y`, `VUP_z`
    ViewUp(Component),
    /// D
    Distance,
    /// F
    Near,
    /// B
    Far,
    /// l
    Left,
    /// r
    Right,
    /// b
    Bottom,
    /// t
    Top,
    /// W
    Width,
    /// H
    Height,
    /// A
    Aspect,
    /// θ, degrees
    ViewAngle,
    /// m, columns of the image
    ImageWidth,
    /// n, rows of the image. Written `n_j` beside the **n** of the VRC
    ImageHeight,
    /// `X_v`
    ViewportX,
    /// `Y_v`
    ViewportY,
    /// `W_v`
    ViewportWidth,
    /// `H_v`
    ViewportHeight,
    /// n of glDepthRange, written `d_n`
    DepthNear,
    /// f of glDepthRange, written `d_f`
    DepthFar,
    /// `t_x`, `t_y`, `t_z` of an object
    Translate(Component),
    /// `φ_x`, `φ_y`, `φ_z` of an object, degrees
    Rotate(Component),
    /// `s_x`, `s_y`, `s_z` of an object
    Scale(Component),
    /// An entry of a matrix: row and column from 0
    Entry(Matrix, u8, u8),
    /// `x_o`, `y_o`, `z_o`: a point in the space of its object
    Local(Component),
    /// x, y, z: a point of the world
    World(Component),
    /// x_c, y_c, z_c
    View(Component),
    /// x_r, y_r, z_r, w_r
    Clip(Component),
    /// `x_h`, `y_h`, `z_h`, `w_h`: VRC before the division by `w_h`, on the way back
    Homogeneous(Component),
    /// x_n, y_n, z_n
    Ndc(Component),
    /// x_p, y_p
    Window(Component),
    /// i, j
    Pixel(Component),
    /// X, Y, Z
    Viewport(Component),
}

impl Symbol {
    /// The letters, and their subscript.
    const fn parts(self) -> (&'static str, &'static str) {
        const fn below(component: Component) -> &'static str {
            ["x", "y", "z", "w"][component.index()]
        }
        match self {
            Self::Axis(Axis::U, component) => ("u", below(component)),
            Self::Axis(Axis::V, component) => ("v", below(component)),
            Self::Axis(Axis::N, component) => ("n", below(component)),
            Self::Position(component) => ("c", below(component)),
            Self::FocalPoint(component) => ("PF", below(component)),
            Self::ViewUp(component) => ("VUP", below(component)),
            Self::Distance => ("D", ""),
            Self::Near => ("F", ""),
            Self::Far => ("B", ""),
            Self::Left => ("l", ""),
            Self::Right => ("r", ""),
            Self::Bottom => ("b", ""),
            Self::Top => ("t", ""),
            Self::Width => ("W", ""),
            Self::Height => ("H", ""),
            Self::Aspect => ("A", ""),
            Self::ViewAngle => ("θ", ""),
            Self::ImageWidth => ("m", ""),
            Self::ImageHeight => ("n", ""),
            Self::ViewportX => ("X", "v"),
            Self::ViewportY => ("Y", "v"),
            Self::ViewportWidth => ("W", "v"),
            Self::ViewportHeight => ("H", "v"),
            Self::DepthNear => ("n", "d"),
            Self::DepthFar => ("f", "d"),
            Self::Translate(component) => ("t", below(component)),
            Self::Rotate(component) => ("φ", below(component)),
            Self::Scale(component) => ("s", below(component)),
            Self::Entry(matrix, ..) => (matrix.entry_letter(), ""),
            Self::Local(component) => (below(component), "o"),
            Self::World(component) => (below(component), ""),
            Self::View(component) => (below(component), "c"),
            Self::Clip(component) => (below(component), "r"),
            Self::Homogeneous(component) => (below(component), "h"),
            Self::Ndc(component) => (below(component), "n"),
            Self::Window(component) => (below(component), "p"),
            Self::Pixel(Component::X) => ("i", ""),
            Self::Pixel(_) => ("j", ""),
            Self::Viewport(Component::X) => ("X", ""),
            Self::Viewport(Component::Y) => ("Y", ""),
            Self::Viewport(_) => ("Z", ""),
        }
    }

    /// As text: `u_x`, `F`, `p_11`.
    pub fn text(self) -> String {
        match (self, self.parts()) {
            (Self::Entry(_, row, column), (letter, _)) => format!("{letter}_{}{}", row + 1, column + 1),
            (_, (letters, "")) => letters.to_owned(),
            (_, (letters, below)) => format!("{letters}_{below}"),
        }
    }

    /// In LaTeX: `u_x`, `\mathrm{PF}_x`, `\theta`.
    pub fn latex(self) -> String {
        let (letters, below) = match (self, self.parts()) {
            (Self::Entry(_, row, column), (letter, _)) => (letter, format!("{}{}", row + 1, column + 1)),
            (_, (letters, below)) => (letters, below.to_owned()),
        };
        let letters = match letters {
            "θ" => r"\theta".to_owned(),
            "φ" => r"\varphi".to_owned(),
            letters if letters.len() > 1 => format!(r"\mathrm{{{letters}}}"),
            letters => letters.to_owned(),
        };
        if below.is_empty() { letters } else { format!("{letters}_{{{below}}}") }
    }
}

impl Vector {
    /// As text, and in LaTeX.
    const fn row(self) -> (&'static str, &'static str) {
        match self {
            Self::Axis(Axis::U) => ("u", r"\mathbf{u}"),
            Self::Axis(Axis::V) => ("v", r"\mathbf{v}"),
            Self::Axis(Axis::N) => ("n", r"\mathbf{n}"),
            Self::Position => ("c", r"\mathbf{c}"),
            Self::ToFocalPoint => ("PF − C", r"\mathrm{PF}-C"),
            Self::UpCrossNormal => ("VUP × n", r"\mathbf{VUP}\times\mathbf{n}"),
        }
    }

    /// As text.
    pub const fn text(self) -> &'static str {
        self.row().0
    }

    /// In LaTeX.
    pub const fn latex(self) -> &'static str {
        self.row().1
    }
}
