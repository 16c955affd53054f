//! Why a text is not a figure.

use super::words::{self, Words};
use crate::camera::CameraError;
use crate::expression::{self, ExpressionError};
use crate::formula::FormulaError;
use crate::sanitize::escaped;
use crate::scene::SceneError;

/// The first fault of a figure file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("line {line}: {key}: {problem}")]
pub struct FigureError {
    /// Counted from 1.
    pub line: usize,
    /// The section and key as they are written, `[camera] near`. Empty if none is concerned.
    pub key: String,
    /// The rule that the line breaks.
    pub problem: Problem,
}

/// A problem in a line of a figure file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Problem {
    /// The bytes are not UTF-8.
    #[error("not UTF-8 (byte {byte:#04x})")]
    NotUtf8 {
        /// The first byte that does not fit.
        byte: u8,
    },
    /// The file is larger than any figure.
    #[error("more than {limit} bytes")]
    TooLarge {
        /// The greatest number of bytes.
        limit: usize,
    },
    /// Not TOML.
    #[error("not TOML: {detail}")]
    Syntax {
        /// The text of the line.
        found: String,
        /// The parser's explanation, in English.
        detail: String,
    },
    /// An expression or an angle without the quotes that TOML needs around it.
    #[error("an expression without quotes: {text}")]
    Unquoted {
        /// As the author wrote it.
        text: String,
    },
    /// A key or section that is there twice.
    #[error("there twice")]
    Duplicate,
    /// A key beside another that gives the same value.
    #[error("stands beside {other}; allowed: one of {}", ways.join(", "))]
    Rival {
        /// The other key.
        other: &'static str,
        /// All keys of which a section may have one.
        ways: &'static [&'static str],
    },
    /// More of them than there may be.
    #[error("are {count}; allowed: at most {limit}")]
    TooMany {
        /// The number found.
        count: usize,
        /// The greatest number allowed.
        limit: usize,
    },
    /// A key that no section of this name has.
    #[error("unknown; known: {}", known.join(", "))]
    UnknownKey {
        /// The key that was probably meant.
        near: Option<String>,
        /// The keys that exist there.
        known: Vec<&'static str>,
    },
    /// A value of the wrong type or out of its range.
    #[error("is {found}; allowed: {allowed:?}")]
    Value {
        /// The value as it is written, shortened.
        found: String,
        /// The allowed values.
        allowed: Allowed,
    },
    /// A number that is written as a text, which cannot be read.
    #[error("is \"{}\": {error} in {}; allowed: {allowed:?}", escaped(text), expression::marked(text, &error.span))]
    Expression {
        /// As the author wrote it.
        text: String,
        /// The fault in the expression.
        error: Box<ExpressionError>,
        /// The allowed values.
        allowed: Allowed,
    },
    /// A key without which the section says nothing.
    #[error("missing")]
    Missing {
        /// The allowed values.
        allowed: Allowed,
    },
    /// A text with a formula that is not only mathematics.
    #[error(transparent)]
    Formula(#[from] FormulaError),
    /// The objects or lights make no scene.
    #[error("{error}")]
    Scene {
        /// Why not.
        error: Box<SceneError>,
        /// The object that was probably meant.
        near: Option<String>,
    },
    /// The values of `[camera]` make no camera.
    #[error(transparent)]
    Camera(#[from] CameraError),
}

/// The allowed values of a key.
#[derive(Clone, Debug, PartialEq)]
pub enum Allowed {
    /// A finite number.
    Number,
    /// A finite number greater than 0.
    PositiveNumber,
    /// A number between two, both included.
    NumberIn(f64, f64),
    /// Degrees between 0 and 180, both excluded.
    HalfTurn,
    /// Two finite numbers greater than 0.
    PositivePair,
    /// An integer between two, both included.
    IntegerIn(i64, i64),
    /// One of some integers.
    Integers(&'static [i64]),
    /// `[x, y, z]`, three finite numbers.
    Vector,
    /// `[x, y, z]`, not all 0.
    NonZeroVector,
    /// `[x, y, z]`, none of them 0.
    NonZeroScale,
    /// Two numbers, neither 0 nor beyond the limit.
    TextureScale,
    /// The name of one of the `[[cameras]]`.
    Camera,
    /// The name of a point of the figure, or `[x, y, z]`, with a place in the image.
    PointInImage,
    /// `"next"`, or a list of operations and keys with their values.
    Seen,
    /// A list of `[x, y, z]`.
    Points,
    /// A list of an even number of `[x, y, z]`.
    PointPairs,
    /// `true` or `false`.
    Switch,
    /// `true`, `false` or one of some words.
    SwitchOr(Vec<&'static str>),
    /// `"#rrggbb"` or `"#rrggbbaa"`.
    Color,
    /// A text that is not empty.
    Text,
    /// One of some words.
    Word {
        /// All that the key takes.
        words: Vec<&'static str>,
        /// The one that was probably meant.
        near: Option<String>,
    },
    /// A list of some words.
    Words(Vec<&'static str>),
    /// Any value of TOML.
    TomlValue,
    /// Two finite numbers.
    Pair,
    /// `[x, y]`, two numbers between two, both included.
    PairIn(f64, f64),
    /// The place of a note.
    NotePlace,
    /// `[i, j]`, two whole numbers.
    Pixel,
    /// Four rows of four numbers.
    Matrix,
    /// A text, or one for each language.
    Bilingual,
    /// A text, or one for each language, of one line each.
    BilingualLine {
        /// The longest in characters.
        limit: usize,
    },
    /// A text of one line that is not empty.
    Line {
        /// The longest in characters.
        limit: usize,
    },
    /// A list of such texts.
    ToldList,
    /// A list of texts.
    Texts,
    /// A name of letters, digits, `-`, `_` and `.`.
    Name {
        /// The longest in characters.
        limit: usize,
    },
    /// A name that nothing else has.
    FreeName,
    /// A list of operations that the camera can do.
    Operations,
    /// A list of pixels, `[i, j]`.
    Pixels,
    /// A number, `[a, b, …]` or `[[…], …]`.
    Numbers,
    /// A path to numbers in the output of `inspect`.
    Quantity,
    /// Paths to two vectors in the output of `inspect`, not of length 0.
    TwoVectors,
    /// At most the number of another key.
    NotAbove(&'static str),
    /// Conditions of which none excludes another.
    Compatible,
    /// A key or a section of the steps of a lesson so far.
    KeyOfSteps,
    /// The identifier of an exercise of the program.
    Exercise,
    /// A list of operations and keys with their values.
    Ways,
    /// Either of two keys.
    Either(&'static str, &'static str),
    /// One of the values of another key.
    Choice(Vec<String>),
    /// An answer that is wrong.
    WrongAnswer,
    /// A section, `[like.this]`.
    Section,
    /// Sections, `[[like.this]]`.
    Sections,
}

impl Allowed {
    /// One of these words.
    pub(super) fn word_of<T>(words: Words<T>) -> Self {
        Self::Word { words: words::names(words), near: None }
    }
}
