//! The facts about an operation that need no camera: its word, its amount, and its text form.

use std::fmt;
use std::str::FromStr;

use crate::camera::Operation;
use crate::expression::{self, Dimension, ExpressionError};
use crate::geometry::Angle;
use crate::numbers::{EXACT_DIGITS, significant};
use crate::sanitize::escaped;

/// A degree of freedom of the operations: the thing that one number moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Freedom {
    /// C about **u** through PF.
    Elevation,
    /// C about **v** through PF.
    Azimuth,
    /// VUP about **n**.
    Roll,
    /// PF about **v** through C.
    Yaw,
    /// PF about **u** through C.
    Pitch,
    /// Divides l, r, b and t; C, PF and VUP stay.
    Zoom,
    /// C along DOP.
    Dolly,
    /// C and PF along **u**.
    PanU,
    /// C and PF along **v**.
    PanV,
}

/// The meaning of the number of a degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Amount {
    /// Degrees; 0 changes nothing.
    Angle,
    /// A factor greater than 0; 1 changes nothing.
    Factor,
    /// A length in scene units; 0 changes nothing.
    Length,
}

/// A degree of freedom with its word and its step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Descriptor {
    /// The degree of freedom.
    pub freedom: Freedom,
    /// The operation, as you write it on the command line. If two have the same word, their numbers follow it in
    /// order.
    pub word: &'static str,
    /// The meaning of its number.
    pub amount: Amount,
    /// A step that is neither small nor large.
    pub step: f64,
}

/// Every degree of freedom of every operation, in the order of [`Freedom`].
pub const OPERATIONS: [Descriptor; 9] = {
    const fn row(freedom: Freedom, word: &'static str, amount: Amount, step: f64) -> Descriptor {
        Descriptor { freedom, word, amount, step }
    }
    [
        row(Freedom::Elevation, "elevation", Amount::Angle, 15.0),
        row(Freedom::Azimuth, "azimuth", Amount::Angle, 15.0),
        row(Freedom::Roll, "roll", Amount::Angle, 15.0),
        row(Freedom::Yaw, "yaw", Amount::Angle, 5.0),
        row(Freedom::Pitch, "pitch", Amount::Angle, 5.0),
        row(Freedom::Zoom, "zoom", Amount::Factor, 1.25),
        row(Freedom::Dolly, "dolly", Amount::Factor, 1.25),
        row(Freedom::PanU, "pan", Amount::Length, 0.5),
        row(Freedom::PanV, "pan", Amount::Length, 0.5),
    ]
};

impl Freedom {
    /// Its word, the meaning of its number, and its step.
    pub const fn descriptor(self) -> &'static Descriptor {
        &OPERATIONS[self as usize]
    }

    /// The operation that moves it by `amount`.
    pub const fn by(self, amount: f64) -> Operation {
        let angle = Angle::from_degrees(amount);
        match self {
            Self::Elevation => Operation::Elevation(angle),
            Self::Azimuth => Operation::Azimuth(angle),
            Self::Roll => Operation::Roll(angle),
            Self::Yaw => Operation::Yaw(angle),
            Self::Pitch => Operation::Pitch(angle),
            Self::Zoom => Operation::Zoom(amount),
            Self::Dolly => Operation::Dolly(amount),
            Self::PanU => Operation::Pan { dx: amount, dy: 0.0 },
            Self::PanV => Operation::Pan { dx: 0.0, dy: amount },
        }
    }
}

impl Amount {
    /// The amount that undoes this one, which is the opposite angle or length, or the inverse factor.
    pub fn inverse(self, amount: f64) -> f64 {
        match self {
            Self::Angle | Self::Length => -amount,
            Self::Factor => 1.0 / amount,
        }
    }
}

impl Operation {
    /// The words of all operations, each once.
    pub fn names() -> Vec<&'static str> {
        let mut words = OPERATIONS.map(|descriptor| descriptor.word).to_vec();
        words.dedup();
        words
    }

    /// The degree of freedom that it moves, for `pan` the first.
    pub const fn freedom(&self) -> Freedom {
        match self {
            Self::Elevation(_) => Freedom::Elevation,
            Self::Azimuth(_) => Freedom::Azimuth,
            Self::Roll(_) => Freedom::Roll,
            Self::Yaw(_) => Freedom::Yaw,
            Self::Pitch(_) => Freedom::Pitch,
            Self::Zoom(_) => Freedom::Zoom,
            Self::Dolly(_) => Freedom::Dolly,
            Self::Pan { .. } => Freedom::PanU,
        }
    }

    /// Its name, as written on the command line.
    pub const fn name(&self) -> &'static str {
        self.freedom().descriptor().word
    }
}

/// The reason why a text isn't an operation.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OperationError {
    /// No `=`.
    #[error("\"{}\" is not an operation; allowed: NAME=VALUE, where NAME is one of {}", escaped(text), Operation::names().join(", "))]
    NoValue {
        /// The text found.
        text: String,
    },
    /// A name that is none of [`Operation::names`].
    #[error("there is no operation \"{}\"; allowed: {}", escaped(name), Operation::names().join(", "))]
    UnknownName {
        /// The name found.
        name: String,
    },
    /// A number that can't be read.
    #[error("{word} is \"{}\": {error} in {marked}; allowed: {allowed}", escaped(value), word = descriptor.word,
        marked = expression::marked(value, &error.span), allowed = allowed(descriptor))]
    NotANumber {
        /// The operation.
        descriptor: Descriptor,
        /// The value found.
        value: String,
        /// The fault in the value.
        error: ExpressionError,
    },
    /// A factor that isn't greater than 0.
    #[error("{word} is \"{}\"; allowed: {allowed}", escaped(value), word = descriptor.word, allowed = allowed(descriptor))]
    NotAFactor {
        /// The operation.
        descriptor: Descriptor,
        /// The value found.
        value: String,
    },
    /// Too few numbers, or too many.
    #[error("{word} is \"{}\"; allowed: {allowed}", escaped(value), word = descriptor.word, allowed = allowed(descriptor))]
    WrongCount {
        /// The operation.
        descriptor: Descriptor,
        /// The value found.
        value: String,
    },
}

/// The allowed values of an operation, in words.
fn allowed(descriptor: &Descriptor) -> String {
    let word = descriptor.word;
    match descriptor.amount {
        Amount::Angle => format!("a finite number of degrees, such as {word}=30"),
        Amount::Factor => format!("a finite number greater than 0, such as {word}=1.5"),
        Amount::Length => format!("two finite numbers DX,DY in scene units, such as {word}=1,-0.5"),
    }
}

impl FromStr for Operation {
    type Err = OperationError;

    /// Reads `NAME=VALUE`. The value is an expression, as of [`expression::evaluate`]. For `pan` it's two of
    /// them, `DX,DY`.
    fn from_str(text: &str) -> Result<Self, OperationError> {
        let (name, value) = text.split_once('=').ok_or_else(|| OperationError::NoValue { text: text.to_owned() })?;
        let mut moved = OPERATIONS.iter().filter(|descriptor| descriptor.word == name.trim());
        let (first, second) = match (moved.next(), moved.next()) {
            (None, _) => return Err(OperationError::UnknownName { name: name.to_owned() }),
            (Some(first), None) => return read_amount(first, value).map(|amount| first.freedom.by(amount)),
            (Some(first), Some(second)) => (first, second),
        };
        let mut parts = expression::parts(value);
        let (Some(dx), Some(dy), None) = (parts.next(), parts.next(), parts.next()) else {
            return Err(OperationError::WrongCount { descriptor: *first, value: value.to_owned() });
        };
        Ok(Self::Pan { dx: read_amount(first, dx)?, dy: read_amount(second, dy)? })
    }
}

fn read_amount(descriptor: &Descriptor, text: &str) -> Result<f64, OperationError> {
    let (descriptor, value) = (*descriptor, || text.to_owned());
    let dimension = match descriptor.amount {
        Amount::Angle => Dimension::Angle,
        Amount::Factor | Amount::Length => Dimension::Number,
    };
    let number = expression::evaluate(text, dimension).map_err(|error| OperationError::NotANumber {
        descriptor,
        value: value(),
        error,
    })?;
    if descriptor.amount == Amount::Factor && number <= 0.0 {
        return Err(OperationError::NotAFactor { descriptor, value: value() });
    }
    Ok(number)
}

impl fmt::Display for Operation {
    /// Writes `NAME=VALUE`, which [`Operation::from_str`] reads back.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.name();
        let exact = |x: f64| significant(x, EXACT_DIGITS);
        match *self {
            Self::Zoom(factor) | Self::Dolly(factor) => write!(f, "{name}={}", exact(factor)),
            Self::Pan { dx, dy } => write!(f, "{name}={},{}", exact(dx), exact(dy)),
            Self::Elevation(angle)
            | Self::Azimuth(angle)
            | Self::Roll(angle)
            | Self::Yaw(angle)
            | Self::Pitch(angle) => write!(f, "{name}={}", exact(angle.degrees())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_degree_of_freedom_stands_at_its_place() {
        for (index, descriptor) in OPERATIONS.iter().enumerate() {
            assert_eq!(descriptor.freedom as usize, index);
            let operation = descriptor.freedom.by(descriptor.step);
            assert_eq!(operation.name(), descriptor.word);
            let undone = descriptor.freedom.by(descriptor.amount.inverse(descriptor.step));
            assert_ne!(undone, operation);
        }
    }

    #[test]
    fn what_undoes_an_amount_is_its_opposite_or_its_inverse() {
        for amount in [Amount::Angle, Amount::Length] {
            assert_eq!(amount.inverse(7.5), -7.5);
        }
        assert_eq!(Amount::Factor.inverse(4.0), 0.25);
    }
}
