//! The nature of an answer, which determines the possible general mistakes and the helpful hints.

use super::mistake::Mistake;
use crate::camera::ParameterKey;
use crate::inspect::quantity::{PointNumber, Quantity, RayNumber, WindowNumber};

crate::worded! {
    /// The nature of the answer.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Nature {
        /// A length, an angle or a share: never negative.
        Size = "size",
        /// A number with a sign.
        Number = "number",
        /// A point or another vector.
        Vector = "vector",
        /// A vector of length 1.
        Direction = "direction",
        /// The cosine of an angle between vectors of length 1.
        Cosine = "cosine",
        /// A share of light: never negative, of vectors of length 1.
        Light = "light",
        /// A matrix.
        Matrix = "matrix",
        /// A pixel.
        Pixel = "pixel",
        /// Six bits.
        Outcode = "outcode",
        /// t of a segment.
        Parameter = "parameter",
        /// Things in an order.
        Order = "order",
        /// One of several.
        Choice = "choice",
        /// A camera.
        Camera = "camera",
    }
    /// Its name among the texts.
    pub fn name
}

impl Nature {
    /// The nature of a quantity; `None` if its kind says it.
    pub(in crate::exercises) fn of_quantity(quantity: Quantity) -> Option<Self> {
        match quantity {
            Quantity::Axis(_) | Quantity::Direction | Quantity::Ray(_, RayNumber::Direction) => Some(Self::Direction),
            Quantity::Point(_, PointNumber::Pixel) | Quantity::Ray(_, RayNumber::Pixel) => Some(Self::Pixel),
            Quantity::Distance
            | Quantity::Window(WindowNumber::Width | WindowNumber::Height | WindowNumber::Aspect)
            | Quantity::Camera(
                ParameterKey::ViewAngle
                | ParameterKey::Height
                | ParameterKey::Aspect
                | ParameterKey::Near
                | ParameterKey::Far,
            ) => Some(Self::Size),
            _ => None,
        }
    }

    /// True if its numbers can be negative.
    pub const fn has_signs(self) -> bool {
        matches!(self, Self::Number | Self::Vector | Self::Direction | Self::Cosine | Self::Matrix)
    }

    /// True if a mistake shows in its numbers. For example, a length that isn't 1 shows if it has to be 1.
    pub(in crate::exercises) const fn shows(self, mistake: Mistake) -> bool {
        let has_lengths = matches!(self, Self::Direction | Self::Cosine | Self::Light | Self::Matrix);
        has_lengths || !matches!(mistake, Mistake::NotNormalised)
    }
}
