//! The quantities that a matrix leaves open, and other notices.

/// A quantity that the matrix leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Unknown {
    /// PF lies anywhere along DOP: D is the one that was there.
    FocalDistance,
    /// VUP is any vector above **v**. It is the one that was there where that fits, else **v**.
    ViewUp,
    /// C lies anywhere along **n**: F is the one that was there.
    PositionAlongNormal,
    /// Only where the window lies beside the axis *and* where C lies sideways together are known. The window is
    /// symmetric.
    WindowCentre,
    /// The far plane is at infinity: B is the one that was there.
    Far,
    /// Lens, F and B are those that were there.
    Lens,
    /// C, PF and VUP are those that were there.
    Pose,
    /// z is turned around beside that of the notes. The volume is the same, depth grows the other way.
    DepthDirection,
    /// The axes of the view are left-handed there: **n** is turned around.
    LeftHandedView,
    /// The axes are orthonormal only as far as their digits go. They were straightened.
    Rounded,
    /// The axes of a node have other lengths than 1. Its scale was divided out.
    Scaled,
    /// z is up in the world of the matrix: that world was turned.
    WorldTurned,
    /// The world of the matrix is left-handed. Its z was reversed.
    WorldMirrored,
    /// The world of the matrix is left-handed with z up. Its y and z were exchanged.
    WorldExchanged,
    /// K \[R | t\] has no clipping planes: F and B are those that were there.
    ClippingPlanes,
    /// K \[R | t\] does not hold the size of the image. It is that of the reading.
    ImageSize,
    /// `f_x` and `f_y` differ: A is not m/n.
    PixelAspect,
    /// The pixels are rectangles only as far as the digits go. The skew was dropped.
    SkewDropped,
    /// The determinant is negative. All signs were reversed, as for a matrix that is known up to a factor.
    SignReversed,
    /// The principal point lies far from the middle of the image: K may be that of another image size.
    PrincipalPoint,
    /// The principal point is the middle of the image with its sides exchanged.
    ImageTurned,
    /// The window is nearly as wide as the half space: θ is greater than 150°.
    WideAngle,
    /// K is in shares of the image, not in pixels.
    NormalisedPixels,
}

impl Unknown {
    /// The name in the output of the command line.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::FocalDistance => "focal-distance",
            Self::ViewUp => "view-up",
            Self::PositionAlongNormal => "position-along-normal",
            Self::WindowCentre => "window-centre",
            Self::Far => "far",
            Self::Lens => "lens",
            Self::Pose => "pose",
            Self::DepthDirection => "depth-direction",
            Self::LeftHandedView => "left-handed",
            Self::Rounded => "rounded",
            Self::Scaled => "scaled",
            Self::WorldTurned => "world-turned",
            Self::WorldMirrored => "world-mirrored",
            Self::WorldExchanged => "world-exchanged",
            Self::ClippingPlanes => "clipping-planes",
            Self::ImageSize => "image-size",
            Self::PixelAspect => "pixel-aspect",
            Self::SkewDropped => "skew-dropped",
            Self::SignReversed => "sign-reversed",
            Self::PrincipalPoint => "principal-point",
            Self::ImageTurned => "image-turned",
            Self::WideAngle => "wide-angle",
            Self::NormalisedPixels => "normalised-pixels",
        }
    }
}
