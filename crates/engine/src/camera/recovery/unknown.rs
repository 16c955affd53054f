//! The quantities that a matrix leaves open, and other notices.

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
