//! The ways in which a known mistake is made, each with numbers of its own.

use super::mistake::Mistake;

/// The cause of a wrong answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cause {
    /// The mistake that the student made.
    pub mistake: Mistake,
    /// The name of the texts for this way of making it. Empty if those of the mistake serve.
    pub variant: &'static str,
}

impl Cause {
    pub(in crate::exercises) const fn of(mistake: Mistake) -> Self {
        Self { mistake, variant: "" }
    }
}

macro_rules! slips {
    ($($(#[doc = $doc:literal])+ $name:ident = $mistake:ident $($variant:literal)?;)*) => {
        /// One way of making a [`Mistake`]. Some are made in several ways, which give different numbers.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Slip {
            $($(#[doc = $doc])+ $name,)*
        }

        impl Slip {
            /// All slips. If several explain the same numbers, the first comes first.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// The mistake, and the way of making it.
            #[must_use]
            pub const fn cause(self) -> Cause {
                match self {
                    $(Self::$name => Cause { mistake: Mistake::$mistake, variant: concat!($($variant)?) },)*
                }
            }
        }
    };
}

slips! {
    /// Nothing was done.
    NothingDone = NotDone;
    /// The direction of a ray is **n**, without the minus.
    DirectionIsNormal = Sign "direction";
    /// The direction of a ray from the point to C.
    RayReversed = Sign "backwards";
    /// The axes of yaw and pitch as printed in `[0]`.
    PrintedAxes = AsPrinted "axes";
    /// VUP doesn't turn with the camera, as `[0]` prints for the elevation.
    PrintedElevation = AsPrinted "elevation";
    /// VUP doesn't turn with the camera.
    ViewUpKept = NotDone "view-up";
    /// **u** alone is reversed.
    UReversedAlone = UReversed;
    /// **u** is reversed, and **v** = **n** × **u** with it.
    UReversed = UReversed;
    /// **v** = **u** × **n**.
    VReversed = VReversed;
    /// **n** alone is reversed.
    NReversedAlone = NReversed;
    /// **n** is reversed, and **u** = VUP × **n** with it.
    NReversed = NReversed;
    /// **v** is VUP, of length 1.
    UnitViewUpAsV = VupAsV;
    /// **v** is VUP as given.
    ViewUpAsV = VupAsV;
    /// The formula of VUV in `[3]`, with a VPN that isn't of length 1.
    PrintedViewUp = AsPrinted "vuv";
    /// That formula, with the result divided by its length.
    PrintedViewUpUnit = AsPrinted "vuv";
    /// No vector is divided by its length.
    NothingNormalised = NotNormalised;
    /// **n** alone keeps its length, of a camera or of a surface.
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
    /// −R PF in the last column.
    FocalPointAsOrigin = FocalPointForPosition;
    /// θ in degrees put into tan.
    Radians = Radians;
    /// The angle of an operation in degrees put into sin and cos.
    TurnInRadians = Radians;
    /// An angle in radians although the question asks for degrees.
    AnswerInRadians = Radians "answer";
    /// tan θ for tan(θ/2).
    WholeAngle = WholeAngle;
    /// tan θ for 2 tan(θ/2): H = F tan θ.
    WholeAngleOnce = WholeAngle;
    /// H = F tan(θ/2).
    HeightHalved = FactorTwo;
    /// r = W, t = H.
    SideWhole = FactorTwo;
    /// F/W for 2F/W, 1/W for 2/W.
    ScaleHalved = FactorTwo;
    /// H = 4 F tan(θ/2).
    HeightDoubled = FactorTwo;
    /// 2F/r for F/r.
    ScaleDoubled = FactorTwo;
    /// BF for 2BF.
    DepthTermHalved = FactorTwo;
    /// `c_x` = m.
    CentreWhole = FactorTwo;
    /// H = 2 tan(θ/2).
    NearForgotten = NearForgotten;
    /// 2/W for 2F/W.
    NearForgottenInScale = NearForgotten "scale";
    /// `x_c`/(−`z_c`).
    NearForgottenOnWindow = NearForgotten;
    /// H = 2 D tan(θ/2).
    DistanceForNear = DistanceForNear;
    /// 2D/W.
    DistanceInScale = DistanceForNear;
    /// D for F in the row of z.
    DistanceInDepth = DistanceForNear;
    /// D `x_c`/(−`z_c`).
    DistanceOnWindow = DistanceForNear;
    /// W = H / A.
    AspectInverted = AspectInverted;
    /// θ from left to right: W = 2 F tan(θ/2), H = W / A.
    AngleAcross = AspectInverted "across";
    /// W = H.
    AspectLeftOut = AspectInverted "left-out";
    /// θ/s.
    ZoomOnAngle = ZoomOnAngle;
    /// θ s.
    ZoomTimesAngle = ZoomOnAngle;
    /// Multiplied by the factor instead of divided.
    FactorInverted = Inverse "factor";
    /// t along the segment of NDC.
    ClipAfterDivide = ClipAfterDivide;
    /// The point where the segment leaves.
    EntryExit = EntryExitExchanged;
    /// Clip coordinates without w.
    NoDivide = NoDivide;
    /// Numbers of the other projection.
    ProjectionsExchanged = ProjectionsExchanged;
    /// The last row of the other M_p.
    OtherLastRow = ProjectionsExchanged "last-row";
    /// The ray begins at the point of the window.
    WindowPointAsOrigin = WindowAsStart;
    /// The depth of a parallel camera.
    LinearDepth = ProjectionsExchanged "depth";
    /// NDC in place of window coordinates.
    NdcAsWindow = NotDone "window";
    /// The distance from C as depth.
    DistanceAsDepth = DistanceForDepth;
    /// Numbers of the VRC as those of the world.
    ViewAsWorld = ViewAsWorld;
    /// w = +z_c.
    WSign = ZSign "w";
    /// The row of z has the opposite signs.
    DepthRowSign = ZSign;
    /// Looking along +z_c: both.
    LeftHanded = ZSign;
    /// z_c with the opposite sign.
    ViewDepthSign = ZSign;
    /// Without the minus before the factor of z_c.
    DepthScaleSign = Sign "depth";
    /// Without the minus before the last number of the row of z.
    DepthShiftSign = Sign "depth";
    /// M_p for z_n in 0 … 1.
    DepthRange = ZRange;
    /// Z = z_n.
    DepthNotMapped = ZRange;
    /// The last row of (5.15) and (5.16).
    PrintedLastRow = AsPrinted "last-row";
    /// 2n of (5.11).
    PrintedScale = AsPrinted "scale";
    /// The back face of the frustum at −F.
    PrintedBackFace = AsPrinted "back-face";
    /// 1/B − F of (1-7).
    PrintedThird = AsPrinted "third";
    /// −F and −B in place of F and B, in the row of z.
    NearFarAsCoordinates = NearFarAsCoordinates;
    /// −F and −B everywhere.
    NearFarAsCoordinatesEverywhere = NearFarAsCoordinates;
    /// (j, i).
    ColumnsAndRows = ColumnsAndRowsExchanged;
    /// m for n, and n for m.
    SizesExchanged = ColumnsAndRowsExchanged "sizes";
    /// `c_x` and `c_y` exchanged.
    CentresExchanged = ColumnsAndRowsExchanged "sizes";
    /// Rows from the bottom.
    YNotFlipped = YNotFlipped;
    /// Without the half.
    PixelCorner = PixelCorner;
    /// The principal point if whole numbers are middles of pixels.
    CentresAtWhole = PixelCorner "principal-point";
    /// Without ⌊ ⌋.
    NotFloored = NotFloored;
    /// Rounded to the nearest whole number.
    RoundedNotFloored = RoundedNotFloored;
    /// From 1.
    OneBased = OneBased;
    /// Z from 0 to 1.
    DepthRangeIgnored = DepthRangeIgnored;
    /// Without X and Y of the viewport.
    OffsetIgnored = OffsetIgnored;
    /// The principal point at (0, 0).
    CentreIgnored = OffsetIgnored "principal-point";
    /// Columns from the right.
    XFlipped = YNotFlipped "columns";
    /// The opposite angle.
    OppositeAngle = OppositeAngle;
    /// The opposite motion.
    OppositePan = OppositeAngle "pan";
    /// Half of the angle.
    HalfTurn = FactorTwo "angle";
    /// sin α and cos α in each other's place.
    SineForCosine = OrderReversed "sine";
    /// A rotation about **u** through PF.
    Elevated = OtherOperation "elevation";
    /// A rotation about **v** through PF.
    Turned = OtherOperation "azimuth";
    /// A rotation about **n**.
    Rolled = OtherOperation "roll";
    /// A rotation about **v** through C.
    Yawed = OtherOperation "yaw";
    /// A rotation about **u** through C.
    Pitched = OtherOperation "pitch";
    /// C moved by the factor.
    Dollied = OtherOperation "dolly";
    /// The window divided by the factor.
    Zoomed = OtherOperation "zoom";
    /// A rotation about an axis of the world.
    WorldAxis = WorldAxis;
    /// A rotation about VUP.
    ViewUpAxis = WorldAxis "view-up";
    /// A rotation or a scale about the origin, of C or PF alone.
    ThroughOrigin = ThroughOrigin;
    /// A rotation of everything that turns, about the origin.
    ThroughOriginAll = ThroughOrigin;
    /// Factors or operations in the opposite order.
    OrderReversed = OrderReversed;
    /// R T S.
    OrderRts = OrderReversed;
    /// T S R.
    OrderTsr = OrderReversed;
    /// S T R.
    OrderStr = OrderReversed;
    /// R S T.
    OrderRst = OrderReversed;
    /// The segment from B to A.
    EndsExchanged = OrderReversed "ends";
    /// Planes of a pair exchanged: left and right, bottom and top, near and far.
    PairsExchanged = OrderReversed;
    /// Left and right, bottom and top exchanged.
    SidesExchanged = OrderReversed;
    /// l, b, r, t.
    SidesByPairs = OrderReversed "sides";
    /// The place of each thing in the order instead of the things.
    RankOfEach = OrderReversed "ranks";
    /// A missing division by the length, in a question of a family.
    LengthForgotten = NotNormalised;
    /// The inverse, in a question of a family.
    Inverted = Inverse "factor";
    /// A step of the buffer instead of its distance.
    StepNotConverted = NotDone "step";
    /// A point through M_v^{-1}.
    ViewInverted = Inverse;
    /// The axes are the columns of M_v, beside −R C.
    AxesAsColumnsAlone = Transposed "block";
    /// The axes are the columns of M_v, also in the product with −C.
    AxesAsColumns = Transposed "block";
    /// The sum of **L** and **V** in place of **H**.
    HalfwaySum = NotNormalised "halfway";
    /// Half of that sum.
    HalfwayMean = NotNormalised "halfway";
    /// The vector along which light travels, in place of the way to a lamp that's far away.
    TravelForWay = Sign "travel";
    /// P − S in place of S − P.
    LampReversed = Sign "lamp";
    /// The ways to a lamp and to the viewer begin at the origin.
    PositionForgotten = PositionForgotten;
    /// **V** in place of **L**.
    ViewForLight = ViewForLight;
    /// A lamp behind the surface takes light away.
    NegativeLight = NegativeLight;
    /// The light on the other side of the surface counts too: |N · L|.
    AbsoluteCosine = NegativeLight "absolute";
    /// The mean of both lights.
    MeanOfLights = FactorTwo "lights";
    /// The angle in degrees instead of its cosine.
    CosineLeftAsAngle = AngleForCosine;
    /// The share of a right angle that an angle leaves.
    ShareOfRightAngle = AngleForCosine "share";
    /// The ambient share is left out.
    AmbientForgotten = ShareForgotten "ambient";
    /// 1 in place of the diffuse share.
    DiffuseForgotten = ShareForgotten "diffuse";
    /// 1 in place of the white of the highlight.
    SpecularForgotten = ShareForgotten "specular";
    /// **L** in place of **H**.
    LightForHalfway = HalfwayForgotten;
    /// Phong's **R** · **V** in place of **N** · **H**.
    ReflectedForHalfway = HalfwayForgotten "reflected";
    /// Without the exponent of the highlight.
    ExponentForgotten = ExponentForgotten;
    /// **n** towards the viewer, in the left-handed system of `[3]`.
    LeftHandedNReversed = NReversed "left-handed";
    /// **u** = **v** × **n**, in the left-handed system of `[3]`.
    LeftHandedUReversed = UReversed "left-handed";
    /// **v** points down, in the left-handed system of `[3]`.
    LeftHandedVReversed = VReversed "left-handed";
    /// 2B/W for 2F/W.
    FarInScale = NearFarAsCoordinates "scale";
    /// F and B exchanged.
    NearFarExchanged = NearFarAsCoordinates "exchanged";
    /// The scale of a perspective, 2F/W, in parallel projection.
    PerspectiveScale = ProjectionsExchanged "scale";
    /// tan(θ/2) where its reciprocal belongs, with A in the right place.
    TangentForCotangent = Inverse "scale";
    /// W/2F and H/2F.
    ScaleInverted = Inverse "scale";
    /// 1 for the sides that contain the point.
    OutcodeInverted = Inverse "outcode";
    /// The corner on the other side, left or right.
    OtherCornerAcross = Sign "corner";
    /// The corner on the other side, top or bottom.
    OtherCornerUp = Sign "corner";
    /// The opposite corner.
    OtherCorner = Sign "corner";
    /// M_p applied to points of the world.
    ViewForgotten = NotDone "view";
    /// The point in the VRC, without M_p.
    ProjectionForgotten = NotDone "projection";
    /// x_p in place of x_n, without the scale of the window to 2.
    WindowAsNdc = NotDone "scale";
    /// d²/(F 2^b): without B/(B − F), and 2^b for 2^b − 1.
    ApproximateStep = Approximation;
    /// Without B/(B − F).
    FarForgotten = Approximation "far";
    /// 2^b for 2^b − 1.
    PowerOfTwo = Approximation "power";
    /// C and PF in each other's place in the formula of the rotation.
    PointsExchanged = WrongPoint;
    /// The rotation of a point through itself.
    TurnedInPlace = WrongPoint "in-place";
    /// P − C, without the rotation: T(−C) for R T(−C).
    OnlyTranslated = NotDone "rotation";
    /// R P, without the translation: R for R T(−C).
    OnlyRotated = NotDone "translation";
    /// The translation in the last row of M_v.
    TranslationInRow = Transposed "translation";
    /// **u** and **v** in each other's row.
    RowsExchanged = OrderReversed "rows";
    /// The point as given, although the question asks for its coordinates in the VRC.
    WorldGiven = NotDone "world";
    /// Clip coordinates divided by w.
    ClipDivided = DividedEarly;
    /// The fourth clip coordinate is 1.
    ClipWithOne = WIsOne;
    /// W and H in place of their halves.
    CornerWhole = FactorTwo "corner";
    /// Coordinates of the VRC, although the question asks for those of the world.
    ViewGiven = ViewAsWorld "given";
    /// The least entry, or the greatest exit.
    MinForMax = EntryExitExchanged "min-for-max";
    /// T(1/2) S in place of S T(1/2).
    MovedByHalf = OrderReversed "half";
    /// S without T.
    OnlyScaled = NotDone "move";
    /// The day and the month in each other's place.
    DayAndMonth = OrderReversed "day-and-month";
    /// Moved by M instead of M/2.
    MovedByWhole = NotTouching;
    /// Moved by M/2 + 1.
    MovedOneMore = NotTouching;
    /// b/2 for b.
    BaselineHalved = FactorTwo "baseline";
    /// δ/(f b) in place of f b/δ, or d in place of δ.
    DisparityInverted = Inverse "disparity";
    /// d and b in each other's place: f d/b.
    DepthOverBaseline = Inverse "disparity";
    /// F in place of f in pixels.
    WindowUnits = NotDone "pixels";
    /// The column in the left image instead of the difference of both.
    OneImage = NotDone "disparity";
    /// The sum of both columns.
    PositionsAdded = Sign "columns";
    /// The column in the right image minus that in the left one.
    EyesExchanged = Sign "eyes";
    /// Parallel windows, although they are shifted.
    ShiftForgotten = NotDone "shift";
    /// D in place of d: the shift itself.
    MeetingForDepth = DistanceForDepth "meeting";
    /// The first pole in place of the one behind it.
    BehindForgotten = NotDone "behind";
    /// The dolly divides the distance of the pole behind PF, and not that of PF.
    DollyOfBehind = WrongPoint "dolly";
    /// C + (PF − C)/f: the part of the way that the dolly leaves, taken as the way.
    WayForDistance = WrongPoint "way";
    /// R (C − PF), without PF.
    CentreNotAddedBack = NotDone "back";
    /// PF + **n**, without D.
    DistanceLeftOut = NotDone "distance";
    /// **n** = C/‖C‖, without PF.
    FocalPointForgotten = NotDone "focal-point";
    /// **u** and **v** in each other's place.
    AxesExchanged = OrderReversed "axes";
    /// The rows of M_v from **n** to **u**.
    RowsReversed = OrderReversed "rows-reversed";
    /// A window in the middle, although it's to one side.
    MiddleForgotten = NotDone "middle";
    /// r + l for (r + l)/(r − l).
    MiddleNotDivided = NotDone "middle-divided";
    /// The middle of the window in the column of the other projection.
    MiddleInOtherColumn = ProjectionsExchanged "middle";
    /// r + l for r − l, everywhere.
    SidesAdded = Sign "sides";
    /// r + l for r − l, in the scale alone.
    SidesAddedInScale = Sign "sides";
    /// The row of z of the other M_p.
    OtherDepthRow = ProjectionsExchanged "depth-row";
    /// The last two rows of the other M_p.
    OtherLastRows = ProjectionsExchanged "last-rows";
    /// The last two rows of M_p in each other's place.
    LastRowsExchanged = OrderReversed "last-rows";
    /// The first two numbers of the diagonal of M_p in each other's place.
    AspectOnOther = AspectInverted "other";
    /// T S in place of S T, in a parallel M_p.
    ShiftNotScaled = OrderReversed "shift";
    /// Columns and rows from the middle of the image.
    ImageMiddleForgotten = OffsetIgnored "middle";
    /// The width of the viewport for its half, and the height.
    ViewportWhole = FactorTwo "viewport";
    /// x and y divided by w, and z not.
    DepthNotDivided = NoDivide "depth";
    /// The point of the window as the direction.
    PointAsDirection = PositionForgotten "ray";
    /// The point of the VRC minus C.
    VrcPointFromEye = ViewAsWorld "minus-eye";
    /// The start of a ray relative to C.
    EyeForgotten = PositionForgotten "eye";
    /// θ/2 for θ.
    AngleHalved = FactorTwo "half-angle";
    /// θ = arctan(H/F).
    AngleOfHeight = WholeAngle "height";
    /// t = d_A/(d_A + d_B), with the signs of the distances.
    DistancesAdded = Sign "cut";
    /// Left, bottom and near before right, top and far.
    NegativePlanesFirst = OrderReversed "planes";
    /// R S.
    WithoutTranslation = NotDone "without-t";
    /// T S.
    WithoutRotation = NotDone "without-r";
    /// T R.
    WithoutScale = NotDone "without-s";
    /// `k_a` for each light.
    AmbientPerLight = DoneTooMuch "ambient";
    /// The highlight, added to the share of the vertex's own colour.
    HighlightAdded = DoneTooMuch "highlight";
    /// M_v applied to the vertices of the object.
    ModelForgotten = NotDone "model";
    /// D for F = D/100.
    DayUndivided = NotDone "hundredth";
    /// F and B from the month.
    MonthForDay = OrderReversed "month-for-day";
    /// w = 0.
    WithoutW = WIsZero;
    /// A base of side 2.
    BaseOfTwo = FactorTwo "base";
    /// A base of side 2 and a height of 2.
    PyramidOfTwo = FactorTwo "base";
    /// The scaled vertices, where those before it are asked for.
    ScaledAlready = DoneTooMuch "scaled";
    /// The base on the plane z = 0.
    BaseUpright = OrderReversed "upright";
}

/// [`Slips`] has a bit for each.
const _: () = assert!(Slip::ALL.len() <= 2 * u128::BITS as usize);

impl Slip {
    /// The mistake that this slip makes.
    pub const fn mistake(self) -> Mistake {
        self.cause().mistake
    }

    /// True if it's made on the way from the world to the VRC.
    pub const fn is_before_view(self) -> bool {
        self.is_of_axes()
            || matches!(
                self,
                Self::TranslationNotRotated
                    | Self::PositionNotNegated
                    | Self::PositionAsItIs
                    | Self::FocalPointAsOrigin
                    | Self::AxesAsColumns
                    | Self::AxesAsColumnsAlone
                    | Self::OnlyTranslated
                    | Self::OnlyRotated
                    | Self::TranslationInRow
                    | Self::RowsExchanged
                    | Self::RowsReversed
                    | Self::AxesExchanged
                    | Self::FocalPointForgotten
                    | Self::ViewInverted
                    | Self::ViewForgotten
                    | Self::ViewAsWorld
            )
    }

    /// True if it's made between the window and the pixels.
    pub const fn is_of_pixels(self) -> bool {
        matches!(
            self,
            Self::ColumnsAndRows
                | Self::SizesExchanged
                | Self::YNotFlipped
                | Self::XFlipped
                | Self::PixelCorner
                | Self::OneBased
                | Self::NotFloored
                | Self::RoundedNotFloored
                | Self::ImageMiddleForgotten
        )
    }

    /// True if it's made in computing the axes of the camera.
    pub const fn is_of_axes(self) -> bool {
        matches!(
            self,
            Self::DirectionIsNormal
                | Self::UReversedAlone
                | Self::UReversed
                | Self::VReversed
                | Self::NReversedAlone
                | Self::NReversed
                | Self::UnitViewUpAsV
                | Self::ViewUpAsV
                | Self::LeftHandedNReversed
                | Self::LeftHandedUReversed
                | Self::LeftHandedVReversed
                | Self::PrintedViewUp
                | Self::PrintedViewUpUnit
                | Self::NothingNormalised
                | Self::NNotNormalised
                | Self::UNotNormalised
                | Self::UNotNormalisedAlone
        )
    }
}

/// Slips made together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Slips([u128; 2]);

impl Slips {
    /// None: the right way.
    pub const NONE: Self = Self([0; 2]);

    /// One.
    pub const fn one(slip: Slip) -> Self {
        Self::NONE.and(slip)
    }

    /// One more.
    #[must_use]
    pub const fn and(mut self, slip: Slip) -> Self {
        let place = slip as usize;
        self.0[place / 128] |= 1 << (place % 128);
        self
    }

    /// True if the set contains it.
    pub const fn has(self, slip: Slip) -> bool {
        let place = slip as usize;
        self.0[place / 128] & (1 << (place % 128)) != 0
    }

    /// The value of the first of these mistakes that was made; `right` if none was.
    pub fn pick<T, const N: usize>(self, mistakes: [(Slip, T); N], right: T) -> T {
        mistakes.into_iter().find(|(slip, _)| self.has(*slip)).map_or(right, |(_, wrong)| wrong)
    }

    /// True if any of these was made.
    pub fn any(self, slips: &[Slip]) -> bool {
        slips.iter().any(|slip| self.has(*slip))
    }
}
