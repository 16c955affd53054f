//! The known mistakes: deviations of students from the notes.

crate::listed! {
    /// A mistake with its own name in reports.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Mistake {
        /// One number is wrong, and nothing known explains it.
        ArithmeticSlip = "arithmetic-slip",
        /// A sign is wrong.
        Sign = "sign",
        /// **n** towards PF.
        NReversed = "n-reversed",
        /// **u** = **n** × VUP.
        UReversed = "u-reversed",
        /// VUP in place of **v**.
        VupAsV = "vup-as-v",
        /// A vector wasn't divided by its length.
        NotNormalised = "not-normalised",
        /// Rows and columns of a matrix are exchanged.
        Transposed = "transposed",
        /// The inverse, or the reciprocal, of the answer.
        Inverse = "inverse",
        /// −C instead of −R C in the last column of M_v.
        TranslationNotRotated = "translation-not-rotated",
        /// R C instead of −R C.
        PositionNotNegated = "position-not-negated",
        /// Degrees put into a function that takes radians.
        Radians = "radians",
        /// θ in place of θ/2.
        WholeAngle = "whole-angle",
        /// H/W in place of W/H.
        AspectInverted = "aspect-inverted",
        /// The zoom divides θ instead of tan(θ/2).
        ZoomOnAngle = "zoom-on-angle",
        /// Not divided by w.
        NoDivide = "no-divide",
        /// Depth with the opposite sign.
        ZSign = "z-sign",
        /// Depth in 0 … 1 instead of −1 … 1, or the other way round.
        ZRange = "z-range",
        /// The distances F and B taken as coordinates −F and −B.
        NearFarAsCoordinates = "near-far-as-coordinates",
        /// (j, i).
        ColumnsAndRowsExchanged = "columns-and-rows-exchanged",
        /// Rows counted from the bottom.
        YNotFlipped = "y-not-flipped",
        /// The corner of the pixel instead of its centre.
        PixelCorner = "pixel-corner",
        /// Factors or operations in the opposite order.
        OrderReversed = "order-reversed",
        /// Another operation than the requested one.
        OtherOperation = "other-operation",
        /// The rotation turns the other way.
        OppositeAngle = "opposite-angle",
        /// Too few digits, or rounded on the way.
        RoundedTooEarly = "rounded-too-early",
        /// Not as many numbers as required.
        WrongShape = "wrong-shape",
        /// An erratum of the notes, as they print it.
        AsPrinted = "as-printed",
        /// A factor of 2 is missing, or there once too often.
        FactorTwo = "factor-two",
        /// F is missing where it belongs.
        NearForgotten = "near-forgotten",
        /// D in place of F.
        DistanceForNear = "distance-for-near",
        /// The distance from C in place of the depth −z_c.
        DistanceForDepth = "distance-for-depth",
        /// Numbers of the other projection.
        ProjectionsExchanged = "projections-exchanged",
        /// Numbers of the VRC used as those of the world.
        ViewAsWorld = "view-as-world",
        /// A rotation about an axis of the world.
        WorldAxis = "world-axis",
        /// A rotation or a scale about the origin instead of PF or C.
        ThroughOrigin = "through-origin",
        /// A step wasn't done.
        NotDone = "not-done",
        /// A number that isn't whole where ⌊ ⌋ belongs.
        NotFloored = "not-floored",
        /// Rounded to the nearest instead of down.
        RoundedNotFloored = "rounded-not-floored",
        /// Pixels counted from 1.
        OneBased = "one-based",
        /// The range of depth of the viewport isn't used.
        DepthRangeIgnored = "depth-range-ignored",
        /// The corner of the viewport isn't added.
        OffsetIgnored = "offset-ignored",
        /// Divided by w before clipping.
        ClipAfterDivide = "clip-after-divide",
        /// **v** points down.
        VReversed = "v-reversed",
        /// The point where a segment leaves in place of the one where it enters.
        EntryExitExchanged = "entry-exit-exchanged",
        /// PF in place of C.
        FocalPointForPosition = "focal-point-for-position",
        /// The lit point wasn't subtracted.
        PositionForgotten = "position-forgotten",
        /// **V** in place of **L**.
        ViewForLight = "view-for-light",
        /// A lamp behind the surface takes light away.
        NegativeLight = "negative-light",
        /// An angle in place of its cosine.
        AngleForCosine = "angle-for-cosine",
        /// A share of the material is left out.
        ShareForgotten = "share-forgotten",
        /// Another vector in place of **H**.
        HalfwayForgotten = "halfway-forgotten",
        /// The exponent of the highlight is left out.
        ExponentForgotten = "exponent-forgotten",
        /// A formula that's only approximately true.
        Approximation = "approximation",
        /// A rotation through C where PF belongs, or through PF where C does.
        WrongPoint = "wrong-point",
        /// Divided by w although the question asks for clip coordinates.
        DividedEarly = "divided-early",
        /// w taken as 1.
        WIsOne = "w-is-one",
        /// In the first octant, but away from its planes.
        NotTouching = "not-touching",
        /// The ray starts on the window.
        WindowAsStart = "window-as-start",
        /// w taken as 0.
        WIsZero = "w-is-zero",
        /// A step that the question doesn't contain.
        DoneTooMuch = "done-too-much",
    }
    /// The word of the mistake in JSON and in `progress.toml`.
    pub fn code
}

impl Mistake {
    /// The mistake with a code.
    pub fn of_code(code: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|mistake| mistake.code() == code)
    }
}
