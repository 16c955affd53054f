//! The reading of a matrix of another program: its task, its axes and its normalised device coordinates.

use glam::{DMat4, DQuat, DVec3, DVec4};

use crate::camera::{Axes, ImageSize, NdcRange, Order};

crate::listed! {
    /// The kind of a pasted matrix.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum MatrixKind {
        /// M_v, from the world to the camera.
        View = "view",
        /// The inverse of M_v: `matrix_world` of Blender, a node of glTF, `matrixWorld` of three.js.
        CameraToWorld = "camera-to-world",
        /// M_p
        Projection = "projection",
        /// M_p M_v
        ViewProjection = "view-projection",
        /// K \[R | t\] of computer vision, from the world to pixels. It may be padded to four rows.
        Pinhole = "pinhole",
        /// K alone: focal lengths and principal point in pixels.
        Intrinsics = "intrinsics",
        /// Three points and vectors: C, PF and VUP.
        LookAt = "look-at",
    }
    /// The name on the command line.
    pub fn name
}

impl MatrixKind {
    /// True if it's written in axes of the camera that programs choose differently.
    pub const fn has_camera_axes(self) -> bool {
        matches!(self, Self::View | Self::CameraToWorld)
    }

    /// True if it holds C and the axes of the camera, and so is written in axes of a world.
    pub const fn has_pose(self) -> bool {
        !matches!(self, Self::Projection | Self::Intrinsics)
    }

    /// True if it leads to normalised device coordinates.
    pub const fn has_ndc(self) -> bool {
        matches!(self, Self::Projection | Self::ViewProjection)
    }

    /// True if it holds pixels.
    pub const fn has_pixels(self) -> bool {
        matches!(self, Self::Pinhole | Self::Intrinsics)
    }
}

/// How a matrix is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading {
    /// The kind of the matrix.
    pub kind: MatrixKind,
    /// The program's axes: those of the camera if the kind has some, and those of the world.
    pub axes: Axes,
    /// Its NDC. Counts for M_p and M_p M_v.
    pub ndc: NdcRange,
    /// The image that its pixels are of. Counts for K.
    pub image: ImageSize,
}

impl Reading {
    /// A kind in the axes and the NDC of `[0]`.
    pub fn of(kind: MatrixKind) -> Self {
        Self { kind, axes: Axes::default(), ndc: NdcRange::default(), image: ImageSize::default() }
    }

    /// The hand of the axes in which it is written: of the world, or of the camera in M_p.
    pub fn is_left_handed(&self) -> bool {
        if self.kind == MatrixKind::Projection {
            let [down, forward] = self.axes.signs();
            down * forward < 0.0
        } else {
            self.axes.left_handed
        }
    }
}

/// The part of a reading that is stated. `None` means it is recognised.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stated {
    /// The kind of the matrix.
    pub kind: Option<MatrixKind>,
    /// The program whose axes it's in.
    pub axes: Option<Axes>,
    /// It's written by columns, or for row vectors. If `kind` is open too, `false` leaves it open.
    pub by_columns: bool,
    /// The NDC that a projection leads to; `None` leaves them open.
    pub ndc: Option<NdcRange>,
    /// The image that its pixels are of.
    pub image: ImageSize,
}

crate::worded! {
    /// A quantity that the matrix leaves open.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
    pub enum Unknown {
        /// PF lies anywhere along DOP. D is kept.
        FocalDistance = "focal-distance",
        /// VUP is any vector above **v**. The present one stays if it fits, else it's **v**.
        ViewUp = "view-up",
        /// C lies anywhere along **n**. F is kept.
        PositionAlongNormal = "position-along-normal",
        /// Only where the window lies beside the axis *and* where C lies sideways together are known. The window is
        /// symmetric.
        WindowCentre = "window-centre",
        /// The far plane is at infinity. B is kept.
        Far = "far",
        /// Lens, F and B are kept.
        Lens = "lens",
        /// θ, or H, is kept: the text has none.
        Window = "window",
        /// C, PF and VUP are kept.
        Pose = "pose",
        /// It has no pose, and the other cameras of its file stand around it, so it's the origin of their world.
        RigOrigin = "rig-origin",
        /// z is turned around beside that of the notes. The volume is the same, but depth grows the other way.
        DepthDirection = "depth-direction",
        /// The axes of the view are left-handed, so **n** is turned around.
        LeftHandedView = "left-handed",
        /// The axes are orthonormal only as far as their digits go. They were straightened.
        Rounded = "rounded",
        /// The axes of a node have other lengths than 1. Its scale was divided out.
        Scaled = "scaled",
        /// z is up in the world of the matrix, which was turned.
        WorldTurned = "world-turned",
        /// The world of the matrix is left-handed. Its z was reversed.
        WorldMirrored = "world-mirrored",
        /// The world of the matrix is left-handed with z up. Its y and z were exchanged.
        WorldExchanged = "world-exchanged",
        /// K \[R | t\] has no clipping planes. F and B are kept.
        ClippingPlanes = "clipping-planes",
        /// K \[R | t\] doesn't hold the size of the image. It's that of the reading.
        ImageSize = "image-size",
        /// `f_x` and `f_y` differ, so A isn't m/n.
        PixelAspect = "pixel-aspect",
        /// The pixels are rectangles only as far as the digits go. The skew was dropped.
        SkewDropped = "skew-dropped",
        /// The determinant is negative. All signs were reversed, as for a matrix that is known up to a factor.
        SignReversed = "sign-reversed",
        /// The principal point lies far from the middle of the image, so K may be that of another image size.
        PrincipalPoint = "principal-point",
        /// The principal point is the middle of the image with its sides exchanged.
        ImageTurned = "image-turned",
        /// The window is nearly as wide as the half space, with θ greater than 150°.
        WideAngle = "wide-angle",
        /// K is in shares of the image, not in pixels.
        NormalisedPixels = "normalised-pixels",
    }
    /// The name in the output of the command line.
    pub fn code
}

/// A number of a text, with the error that its digits leave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Written {
    pub(crate) value: f64,
    /// Half of its last digit, or the rounding of an `f32` if it has as many digits. 0 for whole numbers.
    pub(crate) error: f64,
}

/// The numbers of a matrix in the order in which they were written, and how many stood in a line.
#[derive(Clone, Debug, PartialEq)]
pub struct MatrixEntries {
    numbers: Vec<Written>,
    /// The count of numbers in each line or inner bracket; `None` if they are one list.
    in_line: Option<usize>,
}

impl MatrixEntries {
    /// Numbers of a file, if their count is that of a matrix.
    pub(crate) fn new(numbers: Vec<Written>, in_line: Option<usize>) -> Option<Self> {
        matches!(numbers.len(), 7 | 9 | 12 | 16).then_some(Self { numbers, in_line })
    }

    /// A matrix that acts on column vectors, by rows.
    pub(crate) fn of_matrix(m: DMat4, error: f64) -> Self {
        let numbers = (0..16).map(|k| Written { value: m.row(k / 4)[k % 4], error }).collect();
        Self { numbers, in_line: Some(4) }
    }

    /// Three, or four.
    pub fn rows(&self) -> usize {
        if self.numbers.len() == 16 { 4 } else { 3 }
    }

    /// The count of numbers: 7, 9, 12 or 16.
    pub fn count(&self) -> usize {
        self.numbers.len()
    }

    /// True if they are one list, without lines.
    pub(crate) fn is_flat(&self) -> bool {
        self.in_line.is_none()
    }

    /// The greatest error that the digits of a number leave.
    pub(crate) fn error(&self) -> f64 {
        self.numbers.iter().map(|number| number.error).fold(0.0, f64::max)
    }

    /// The errors that the digits leave, in the places of the entries.
    pub(crate) fn errors(&self, order: Order) -> DMat4 {
        let errors = self.numbers.iter().map(|number| Written { value: number.error, error: 0.0 }).collect();
        let m = Self { numbers: errors, in_line: self.in_line }.lines(order);
        // Three rows were followed by 0 0 0 1, which is exact.
        if self.rows() == 3 { m - DMat4::IDENTITY } else { m }
    }

    /// The first number that isn't finite, with its place in the lines.
    pub(crate) fn not_finite(&self) -> Option<(usize, usize, f64)> {
        let columns = self.in_line.unwrap_or(if self.count() == 9 { 3 } else { 4 });
        let at = self.numbers.iter().position(|number| !number.value.is_finite())?;
        Some((at / columns + 1, at % columns + 1, self.numbers[at].value))
    }

    /// The orders in which they may be written, the likelier first.
    pub(crate) fn orders(&self) -> &'static [Order] {
        use Order::{Columns, RotationThenTranslation, Rows, TThenWxyz, TThenXyzw, WxyzThenT, XyzwThenT};
        match (self.count(), self.in_line) {
            (7, _) => &[WxyzThenT, TThenXyzw, XyzwThenT, TThenWxyz],
            (12, Some(3)) => &[RotationThenTranslation, Columns],
            (12, Some(4)) => &[Rows],
            (12, _) => &[Rows, Columns, RotationThenTranslation],
            _ => &[Rows, Columns],
        }
    }

    /// The matrix, which acts on column vectors. Three rows are followed by 0 0 0 1. By columns the numbers go down
    /// first, as in OpenGL, glTF and three.js, and as in a matrix written for row vectors.
    pub fn matrix(&self, by_columns: bool) -> DMat4 {
        self.in_order(if by_columns { Order::Columns } else { Order::Rows })
    }

    /// P of a part of its image, whose pixels are several of the whole.
    pub(crate) fn crop(&mut self, corner: [f64; 2], binning: [f64; 2]) {
        for k in 0..self.numbers.len().min(8) {
            let (row, last) = (k / 4, self.numbers[8 + k % 4].value);
            self.numbers[k].value = (self.numbers[k].value - corner[row] * last) / binning[row];
        }
    }

    /// The matrix of an order. Nine numbers are its upper left corner. A quaternion that isn't of unit length gives a
    /// matrix of zeros.
    pub(crate) fn in_order(&self, order: Order) -> DMat4 {
        let value = |k: usize| self.numbers.get(k).map_or(0.0, |number| number.value);
        let at = |places: [usize; 4]| DQuat::from_array(places.map(value));
        let (quaternion, t) = match order {
            Order::WxyzThenT => (at([1, 2, 3, 0]), 4),
            Order::XyzwThenT => (at([0, 1, 2, 3]), 4),
            Order::TThenXyzw => (at([3, 4, 5, 6]), 0),
            Order::TThenWxyz => (at([4, 5, 6, 3]), 0),
            Order::Rows | Order::Columns | Order::RotationThenTranslation => return self.lines(order),
        };
        if (quaternion.length() - 1.0).abs() > 1e-2 {
            return DMat4::ZERO;
        }
        DMat4::from_rotation_translation(quaternion.normalize(), DVec3::new(value(t), value(t + 1), value(t + 2)))
    }

    fn lines(&self, order: Order) -> DMat4 {
        let rows = self.rows();
        let columns = if self.count() == 9 { 3 } else { 4 };
        let mut matrix = DMat4::IDENTITY;
        for (k, number) in self.numbers.iter().enumerate() {
            let (row, column) = match order {
                Order::Columns => (k % rows, k / rows),
                Order::RotationThenTranslation if k >= 9 => (k - 9, 3),
                Order::RotationThenTranslation => (k / 3, k % 3),
                _ => (k / columns, k % columns),
            };
            matrix.col_mut(column)[row] = number.value;
        }
        matrix
    }
}

/// The matrix of R and t, which are in rows.
pub(crate) fn rigid(r: [DVec3; 3], t: DVec3) -> DMat4 {
    let rows = [r[0].extend(t.x), r[1].extend(t.y), r[2].extend(t.z), DVec4::W];
    DMat4::from_cols(rows[0], rows[1], rows[2], rows[3]).transpose()
}
