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
}

impl Mistake {
    /// All, with their codes in the contract.
    pub const ALL: [(Self, &'static str); 26] = [
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
    ];

    /// Its code.
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

macro_rules! slips {
    ($($(#[doc = $doc:literal])+ $name:ident = $mistake:ident;)*) => {
        /// One way of making a [`Mistake`]; some are made in several ways, which give different numbers.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Slip {
            $($(#[doc = $doc])+ $name,)*
        }

        impl Slip {
            /// All; where two explain the same numbers, the first is reported.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// The mistake that it is.
            #[must_use]
            pub const fn mistake(self) -> Mistake {
                match self {
                    $(Self::$name => Mistake::$mistake,)*
                }
            }
        }
    };
}

slips! {
    /// **u** alone is reversed.
    UReversedAlone = UReversed;
    /// **u** is reversed, and **v** = **n** × **u** with it.
    UReversed = UReversed;
    /// **n** alone is reversed.
    NReversedAlone = NReversed;
    /// **n** is reversed, and **u** = VUP × **n** with it.
    NReversed = NReversed;
    /// **v** is VUP, of length 1.
    UnitViewUpAsV = VupAsV;
    /// **v** is VUP as it is given.
    ViewUpAsV = VupAsV;
    /// No vector is divided by its length.
    NothingNormalised = NotNormalised;
    /// **n** alone keeps its length.
    NNotNormalised = NotNormalised;
    /// **u** keeps its length, and **v** with it.
    UNotNormalised = NotNormalised;
    /// **u** alone keeps its length.
    UNotNormalisedAlone = NotNormalised;
    /// The direction of a ray keeps its length.
    RayNotNormalised = NotNormalised;
    /// −C in the last column.
    TranslationNotRotated = TranslationNotRotated;
    /// R C in the last column.
    PositionNotNegated = PositionNotNegated;
    /// C in the last column.
    PositionAsItIs = PositionNotNegated;
    /// θ in degrees put into tan.
    Radians = Radians;
    /// The angle of an operation in degrees put into sin and cos.
    TurnInRadians = Radians;
    /// tan θ for tan(θ/2).
    WholeAngle = WholeAngle;
    /// tan θ for 2 tan(θ/2): H = F tan θ.
    WholeAngleOnce = WholeAngle;
    /// W = H / A.
    AspectInverted = AspectInverted;
    /// θ/s.
    ZoomOnAngle = ZoomOnAngle;
    /// Multiplied by the factor, and not divided.
    FactorInverted = Inverse;
    /// Clip coordinates without w.
    NoDivide = NoDivide;
    /// w = +z_c.
    WSign = ZSign;
    /// The row of z has the opposite signs.
    DepthRowSign = ZSign;
    /// Looking along +z_c: both.
    LeftHanded = ZSign;
    /// z_c with the opposite sign.
    ViewDepthSign = ZSign;
    /// M_p for z_n in 0 … 1.
    DepthRange = ZRange;
    /// Z = z_n.
    DepthNotMapped = ZRange;
    /// −F and −B in place of F and B, in the row of z.
    NearFarAsCoordinates = NearFarAsCoordinates;
    /// −F and −B everywhere.
    NearFarAsCoordinatesEverywhere = NearFarAsCoordinates;
    /// (j, i).
    ColumnsAndRows = ColumnsAndRowsExchanged;
    /// Rows from the bottom.
    YNotFlipped = YNotFlipped;
    /// Without the half.
    PixelCorner = PixelCorner;
    /// The opposite angle.
    OppositeAngle = OppositeAngle;
    /// A rotation about **u** through PF.
    Elevated = OtherOperation;
    /// A rotation about **v** through PF.
    Turned = OtherOperation;
    /// A rotation about **n**.
    Rolled = OtherOperation;
    /// A rotation about **v** through C.
    Yawed = OtherOperation;
    /// A rotation about **u** through C.
    Pitched = OtherOperation;
    /// C moved by the factor.
    Dollied = OtherOperation;
    /// The window divided by the factor.
    Zoomed = OtherOperation;
    /// Factors or operations in the opposite order.
    OrderReversed = OrderReversed;
    /// A missing division by the length, in a question of a family.
    LengthForgotten = NotNormalised;
    /// The opposite sign of a term, in a question of a family.
    TermSign = Sign;
    /// Rows for columns, in a question of a family.
    Transposed = Transposed;
    /// The inverse, in a question of a family.
    Inverted = Inverse;
    /// The axes are the columns of M_v, beside −R C.
    AxesAsColumnsAlone = Transposed;
    /// The axes are the columns of M_v, also where they are multiplied by −C.
    AxesAsColumns = Transposed;
}

impl Slip {
    /// Whether it is made where the axes of the camera are computed.
    #[must_use]
    pub const fn is_of_axes(self) -> bool {
        matches!(
            self,
            Self::UReversedAlone
                | Self::UReversed
                | Self::NReversedAlone
                | Self::NReversed
                | Self::UnitViewUpAsV
                | Self::ViewUpAsV
                | Self::NothingNormalised
                | Self::NNotNormalised
                | Self::UNotNormalised
                | Self::UNotNormalisedAlone
        )
    }
}

/// The slips that are made together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Slips(u64);

impl Slips {
    /// None: the right way.
    pub const NONE: Self = Self(0);

    /// One.
    #[must_use]
    pub const fn one(slip: Slip) -> Self {
        Self(1 << slip as u64)
    }

    /// One more.
    #[must_use]
    pub const fn and(self, slip: Slip) -> Self {
        Self(self.0 | 1 << slip as u64)
    }

    /// Whether it is made.
    #[must_use]
    pub const fn has(self, slip: Slip) -> bool {
        self.0 & (1 << slip as u64) != 0
    }

    /// Whether any of these is made.
    #[must_use]
    pub fn any(self, slips: &[Slip]) -> bool {
        slips.iter().any(|slip| self.has(*slip))
    }
}
