//! The reasons why a text isn't a figure.

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
    /// The section and key as written, `[camera] near`. Empty if none is concerned.
    pub key: String,
    /// The rule that the line breaks.
    pub problem: Problem,
}

/// A problem in a line of a figure file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Problem {
    /// The bytes aren't UTF-8.
    #[error("not UTF-8 (byte {byte:#04x})")]
    NotUtf8 {
        /// The first invalid byte.
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
    /// A key or section that appears twice.
    #[error("there twice")]
    Duplicate,
    /// A key beside another that gives the same value.
    #[error("stands beside {other}; allowed: one of {}", ways.join(", "))]
    Rival {
        /// The other key.
        other: &'static str,
        /// All keys, only one of which a section may have.
        ways: &'static [&'static str],
    },
    /// More of them than allowed.
    #[error("are {count}; allowed: at most {limit}")]
    TooMany {
        /// The number found.
        count: usize,
        /// The greatest number allowed.
        limit: usize,
    },
    /// A key that's unknown in this section.
    #[error("unknown; known: {}", known.join(", "))]
    UnknownKey {
        /// The key that the author probably meant.
        near: Option<String>,
        /// The keys that exist there.
        known: Vec<&'static str>,
    },
    /// A value of the wrong type or out of its range.
    #[error("is {found}; allowed: {allowed:?}")]
    Value {
        /// The value as written, shortened.
        found: String,
        /// The allowed values.
        allowed: Allowed,
    },
    /// A number written as a text, which can't be read.
    #[error("is \"{}\": {error} in {}; allowed: {allowed:?}", escaped(text), expression::marked(text, &error.span))]
    Expression {
        /// As the author wrote it.
        text: String,
        /// The error in the expression.
        error: Box<ExpressionError>,
        /// The allowed values.
        allowed: Allowed,
    },
    /// A key without which the section is incomplete.
    #[error("missing")]
    Missing {
        /// The allowed values.
        allowed: Allowed,
    },
    /// A text with a formula that isn't only mathematics.
    #[error(transparent)]
    Formula(#[from] FormulaError),
    /// The objects or lights don't make a scene.
    #[error("{error}")]
    Scene {
        /// The reason why not.
        error: Box<SceneError>,
        /// The object that the author probably meant.
        near: Option<String>,
    },
    /// The values of `[camera]` don't make a camera.
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
    /// A number between two others, both included.
    NumberIn(f64, f64),
    /// Degrees between 0 and 180, both excluded.
    HalfTurn,
    /// Two finite numbers greater than 0.
    PositivePair,
    /// An integer between two others, both included.
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
    /// A point with a place in the image: the name of one of the figure, `[x, y, z]`, a point of an object, or
    /// coordinates in another space.
    PointInImage,
    /// The name of a point of an object.
    ObjectPoint,
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
    /// A text that isn't empty.
    Text,
    /// One of some words.
    Word {
        /// All words allowed for the key.
        words: Vec<&'static str>,
        /// The word that the author probably meant.
        near: Option<String>,
    },
    /// A list of some words.
    Words(Vec<&'static str>),
    /// Any value of TOML.
    TomlValue,
    /// Two finite numbers.
    Pair,
    /// `[x, y]`, two numbers between two others, both included.
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
    /// A text of one line that isn't empty.
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
    /// A name that isn't used yet.
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
    /// Conditions that don't exclude each other.
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
    /// A wrong answer.
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
