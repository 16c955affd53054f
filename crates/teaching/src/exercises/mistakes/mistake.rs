//! The known mistakes: deviations of students from the notes.

/// A mistake with a name of its own, under which it is reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Mistake {
    /// One number is wrong, and nothing known explains it.
    ArithmeticSlip,
    /// A sign is wrong.
    Sign,
    /// **n** towards PF.
    NReversed,
    /// **u** = **n** × VUP.
    UReversed,
    /// VUP in the place of **v**.
    VupAsV,
    /// A vector was not divided by its length.
    NotNormalised,
    /// Rows and columns of a matrix are exchanged.
    Transposed,
    /// The inverse, or the reciprocal, of the answer.
    Inverse,
    /// −C in the last column of M_v, and not −R C.
    TranslationNotRotated,
    /// R C, and not −R C.
    PositionNotNegated,
    /// PF in the place of C.
    FocalPointForPosition,
    /// Degrees put into a function that takes radians.
    Radians,
    /// θ in the place of θ/2.
    WholeAngle,
    /// H/W in the place of W/H.
    AspectInverted,
    /// The zoom divides θ, and not tan(θ/2).
    ZoomOnAngle,
    /// Not divided by w.
    NoDivide,
    /// Depth with the opposite sign.
    ZSign,
    /// Depth in 0 … 1 and not in −1 … 1, or the other way round.
    ZRange,
    /// The distances F and B taken as coordinates −F and −B.
    NearFarAsCoordinates,
    /// (j, i).
    ColumnsAndRowsExchanged,
    /// Rows counted from the bottom.
    YNotFlipped,
    /// The corner of the pixel, and not its centre.
    PixelCorner,
    /// Factors or operations in the opposite order.
    OrderReversed,
    /// Another operation than the requested one.
    OtherOperation,
    /// The rotation turns the other way.
    OppositeAngle,
    /// Too few digits, or rounded on the way.
    RoundedTooEarly,
    /// Not as many numbers as required.
    WrongShape,
    /// An erratum of the notes, as they print it.
    AsPrinted,
    /// A factor of 2 is lost, or there once too often.
    FactorTwo,
    /// F does not occur where it belongs.
    NearForgotten,
    /// D in the place of F.
    DistanceForNear,
    /// The distance from C in the place of the depth −z_c.
    DistanceForDepth,
    /// Numbers of the other projection.
    ProjectionsExchanged,
    /// Numbers of the VRC used as those of the world.
    ViewAsWorld,
    /// A rotation about an axis of the world.
    WorldAxis,
    /// A rotation or a scale about the origin, and not about PF or C.
    ThroughOrigin,
    /// A step was not done.
    NotDone,
    /// A number that is not whole where ⌊ ⌋ belongs.
    NotFloored,
    /// Rounded to the nearest, and not down.
    RoundedNotFloored,
    /// Pixels counted from 1.
    OneBased,
    /// The range of depth of the viewport is not used.
    DepthRangeIgnored,
    /// The corner of the viewport is not added.
    OffsetIgnored,
    /// Divided by w before it was clipped.
    ClipAfterDivide,
    /// **v** points down.
    VReversed,
    /// The point where a segment leaves in the place of the one where it enters.
    EntryExitExchanged,
    /// The point that is lit was not subtracted.
    PositionForgotten,
    /// **V** in the place of **L**.
    ViewForLight,
    /// A lamp behind the surface takes light away.
    NegativeLight,
    /// An angle in the place of its cosine.
    AngleForCosine,
    /// A share of the material is left out.
    ShareForgotten,
    /// Another vector in the place of **H**.
    HalfwayForgotten,
    /// The exponent of the highlight is left out.
    ExponentForgotten,
    /// A formula that holds only nearly.
    Approximation,
    /// A rotation through C where PF belongs, or through PF where C does.
    WrongPoint,
    /// Divided by w where clip coordinates are asked for.
    DividedEarly,
    /// w taken as 1.
    WIsOne,
    /// In the first octant, but away from its planes.
    NotTouching,
    /// The ray starts on the window.
    WindowAsStart,
}

impl Mistake {
    /// All, with their codes in the contract.
    pub const ALL: [(Self, &'static str); 58] = [
        (Self::ArithmeticSlip, "arithmetic-slip"),
        (Self::Sign, "sign"),
        (Self::NReversed, "n-reversed"),
        (Self::UReversed, "u-reversed"),
        (Self::VupAsV, "vup-as-v"),
        (Self::NotNormalised, "not-normalised"),
        (Self::Transposed, "transposed"),
        (Self::Inverse, "inverse"),
        (Self::TranslationNotRotated, "translation-not-rotated"),
        (Self::PositionNotNegated, "position-not-negated"),
        (Self::Radians, "radians"),
        (Self::WholeAngle, "whole-angle"),
        (Self::AspectInverted, "aspect-inverted"),
        (Self::ZoomOnAngle, "zoom-on-angle"),
        (Self::NoDivide, "no-divide"),
        (Self::ZSign, "z-sign"),
        (Self::ZRange, "z-range"),
        (Self::NearFarAsCoordinates, "near-far-as-coordinates"),
        (Self::ColumnsAndRowsExchanged, "columns-and-rows-exchanged"),
        (Self::YNotFlipped, "y-not-flipped"),
        (Self::PixelCorner, "pixel-corner"),
        (Self::OrderReversed, "order-reversed"),
        (Self::OtherOperation, "other-operation"),
        (Self::OppositeAngle, "opposite-angle"),
        (Self::RoundedTooEarly, "rounded-too-early"),
        (Self::WrongShape, "wrong-shape"),
        (Self::AsPrinted, "as-printed"),
        (Self::FactorTwo, "factor-two"),
        (Self::NearForgotten, "near-forgotten"),
        (Self::DistanceForNear, "distance-for-near"),
        (Self::DistanceForDepth, "distance-for-depth"),
        (Self::ProjectionsExchanged, "projections-exchanged"),
        (Self::ViewAsWorld, "view-as-world"),
        (Self::WorldAxis, "world-axis"),
        (Self::ThroughOrigin, "through-origin"),
        (Self::NotDone, "not-done"),
        (Self::NotFloored, "not-floored"),
        (Self::RoundedNotFloored, "rounded-not-floored"),
        (Self::OneBased, "one-based"),
        (Self::DepthRangeIgnored, "depth-range-ignored"),
        (Self::OffsetIgnored, "offset-ignored"),
        (Self::ClipAfterDivide, "clip-after-divide"),
        (Self::VReversed, "v-reversed"),
        (Self::EntryExitExchanged, "entry-exit-exchanged"),
        (Self::FocalPointForPosition, "focal-point-for-position"),
        (Self::PositionForgotten, "position-forgotten"),
        (Self::ViewForLight, "view-for-light"),
        (Self::NegativeLight, "negative-light"),
        (Self::AngleForCosine, "angle-for-cosine"),
        (Self::ShareForgotten, "share-forgotten"),
        (Self::HalfwayForgotten, "halfway-forgotten"),
        (Self::ExponentForgotten, "exponent-forgotten"),
        (Self::Approximation, "approximation"),
        (Self::WrongPoint, "wrong-point"),
        (Self::DividedEarly, "divided-early"),
        (Self::WIsOne, "w-is-one"),
        (Self::NotTouching, "not-touching"),
        (Self::WindowAsStart, "window-as-start"),
    ];

    /// The word of the mistake in JSON and in `progress.toml`.
    #[must_use]
    pub fn code(self) -> &'static str {
        Self::ALL.iter().find(|(mistake, _)| *mistake == self).map_or("", |(_, code)| code)
    }

    /// The mistake of a code.
    #[must_use]
    pub fn of_code(code: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, known)| *known == code).map(|(mistake, _)| *mistake)
    }
}
