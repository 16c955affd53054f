//! The values of keys: which are allowed, and how they're read and written.

use glam::{DMat4, DVec2, DVec3};
use toml_edit::{Array, InlineTable, Item, TableLike, Value};

use super::Localized;
use super::error::Allowed;
use crate::appearance::{Rgba, Samples, SubpixelBits};
use crate::expression::{self, Dimension, ExpressionError};
use crate::{numbers, sanitize};

/// The values of a key.
pub struct Values<V> {
    /// The allowed ones.
    pub allowed: Allowed,
    pub(super) read: Read<V>,
    pub(super) write: fn(&V) -> Value,
}

/// Reads a value that's among the allowed ones.
type Read<V> = fn(&Value, &Allowed) -> Result<V, Refused>;

const fn values<V>(allowed: Allowed, read: Read<V>, write: fn(&V) -> Value) -> Values<V> {
    Values { allowed, read, write }
}

/// A value that removes its key, for a file that has to give one.
pub(super) const NOTHING: &str = "\"\"";

/// Finite numbers.
pub static NUMBER: Values<f64> = values(Allowed::Number, |v, _| number(v, Dimension::Number), write_number);

/// Numbers and infinity, which the caller refuses with a better message.
pub static NUMBER_OR_INFINITY: Values<f64> = values(Allowed::Number, number_or_infinity, write_number);

/// Numbers greater than 0.
pub static POSITIVE: Values<f64> = values(Allowed::PositiveNumber, |v, _| positive(v), write_number);

/// Degrees.
pub static ANGLE: Values<f64> = values(Allowed::Number, |v, _| number(v, Dimension::Angle), write_number);

/// Degrees between 0 and 180, both excluded.
pub static HALF_TURN: Values<f64> = values(Allowed::HalfTurn, |v, _| half_turn(v), write_number);

/// Numbers between two others, both included.
pub const fn number_in([least, most]: [f64; 2]) -> Values<f64> {
    let read: Read<f64> = |v, allowed| number_if(v, Dimension::Number, |x| allowed.has_number(x));
    values(Allowed::NumberIn(least, most), read, write_number)
}

/// Degrees between two others, both included.
pub const fn angle_in([least, most]: [f64; 2]) -> Values<f64> {
    let read: Read<f64> = |v, allowed| number_if(v, Dimension::Angle, |x| allowed.has_number(x));
    values(Allowed::NumberIn(least, most), read, write_number)
}

/// Integers between two others, both included, which fit the type.
pub const fn integer_in<V: Copy + TryFrom<i64> + Into<i64>>([least, most]: [i64; 2]) -> Values<V> {
    values(Allowed::IntegerIn(least, most), integer, |i| Into::<i64>::into(*i).into())
}

/// The number of samples of a pixel.
pub static SAMPLES: Values<Samples> = values(
    Allowed::Integers(&[1, 4, 16]),
    |v, _| {
        let count = v.as_integer().and_then(|count| Samples::from_count(u8::try_from(count).ok()?));
        count.ok_or(Refused::Value)
    },
    |samples| i64::from(samples.count()).into(),
);

/// The grid of a pixel.
pub static SUBPIXEL_BITS: Values<SubpixelBits> = values(
    Allowed::Integers(&[4, 8, 12]),
    |v, _| {
        let is = |bits: &SubpixelBits| v.as_integer() == Some(bits.count().into());
        SubpixelBits::ALL.into_iter().find(is).ok_or(Refused::Value)
    },
    |bits| i64::from(bits.count()).into(),
);

/// `true` or `false`.
pub static SWITCH: Values<bool> =
    values(Allowed::Switch, |v, _| v.as_bool().ok_or(Refused::Value), |on| Value::from(*on));

/// Three finite numbers.
pub static VECTOR: Values<DVec3> =
    values(Allowed::Vector, |v, _| vector(v, Dimension::Number), |v| numbers_of(v.to_array()));

/// Degrees about x, y and z.
pub static ANGLES: Values<DVec3> =
    values(Allowed::Vector, |v, _| vector(v, Dimension::Angle), |v| numbers_of(v.to_array()));

/// Two finite numbers.
pub static PAIR: Values<DVec2> =
    values(Allowed::Pair, |v, _| numbers(v, Dimension::Number).map(DVec2::from_array), |p| numbers_of(p.to_array()));

/// Two numbers greater than 0.
pub static POSITIVE_PAIR: Values<[f64; 2]> = values(
    Allowed::PositivePair,
    |v, _| numbers(v, Dimension::Number).and_then(|pair| allow(pair, pair.iter().all(|x| *x > 0.0))),
    |pair| numbers_of(*pair),
);

/// A 4 × 4 matrix, row by row.
pub static MATRIX: Values<DMat4> = values(Allowed::Matrix, |v, _| matrix(v), write_matrix);

/// A pixel (i, j), also outside the image.
pub static PIXEL: Values<[i64; 2]> =
    values(Allowed::Pixel, |v, _| whole_numbers(v).ok_or(Refused::Value), |pixel| pixel.iter().copied().collect());

/// A pixel (i, j) from (0, 0) on.
pub static PIXEL_OF_IMAGE: Values<[u32; 2]> = values(
    Allowed::Pixel,
    |v, _| {
        let [i, j] = whole_numbers(v).ok_or(Refused::Value)?.map(|k| u32::try_from(k).map_err(|_| Refused::Value));
        Ok([i?, j?])
    },
    |pixel| pixel.iter().map(|k| i64::from(*k)).collect(),
);

/// Colours as `#rrggbb` or `#rrggbbaa`.
pub static COLOR: Values<Rgba> = values(
    Allowed::Color,
    |v, _| v.as_str().and_then(|text| text.parse().ok()).ok_or(Refused::Value),
    |color| color.to_string().into(),
);

/// Texts that aren't empty.
pub static TEXT: Values<String> = values(Allowed::Text, |v, _| text_if(v, |text| !text.is_empty()), |t| quoted(t));

/// Texts of one line, of at most `limit` characters.
pub const fn line(limit: usize) -> Values<String> {
    let read: Read<String> = |v, allowed| {
        let fits = |text: &str| matches!(allowed, Allowed::Line { limit } if text.chars().count() <= *limit);
        text_if(v, |text| !text.trim().is_empty() && !text.contains(sanitize::is_obeyed) && fits(text))
    };
    values(Allowed::Line { limit }, read, |text| quoted(text))
}

impl Allowed {
    fn has_number(&self, x: f64) -> bool {
        matches!(self, Self::NumberIn(least, most) if (*least..=*most).contains(&x))
    }

    fn has_integer(&self, i: i64) -> bool {
        match self {
            Self::IntegerIn(least, most) => (*least..=*most).contains(&i),
            Self::Integers(choice) => choice.contains(&i),
            _ => false,
        }
    }
}

fn allow<V>(value: V, is_allowed: bool) -> Result<V, Refused> {
    if is_allowed { Ok(value) } else { Err(Refused::Value) }
}

fn write_number(x: &f64) -> Value {
    written(*x)
}

fn number_or_infinity(value: &Value, _: &Allowed) -> Result<f64, Refused> {
    if value.as_float() == Some(f64::INFINITY) { Ok(f64::INFINITY) } else { number(value, Dimension::Number) }
}

fn positive(value: &Value) -> Result<f64, Refused> {
    number_if(value, Dimension::Number, |x| x > 0.0)
}

fn half_turn(value: &Value) -> Result<f64, Refused> {
    number_if(value, Dimension::Angle, |degrees| degrees > 0.0 && degrees < 180.0)
}

fn integer<V: TryFrom<i64>>(value: &Value, allowed: &Allowed) -> Result<V, Refused> {
    let integer = value.as_integer().filter(|i| allowed.has_integer(*i));
    integer.and_then(|i| V::try_from(i).ok()).ok_or(Refused::Value)
}

fn text_if(value: &Value, is_allowed: impl Fn(&str) -> bool) -> Result<String, Refused> {
    value.as_str().filter(|text| is_allowed(text)).map(str::to_owned).ok_or(Refused::Value)
}

fn matrix(value: &Value) -> Result<DMat4, Refused> {
    let rows = value.as_array().filter(|rows| rows.len() == 4).ok_or(Refused::Value)?;
    let mut entries = [[0.0; 4]; 4];
    for (place, row) in entries.iter_mut().zip(rows) {
        *place = numbers(row, Dimension::Number)?;
    }
    Ok(DMat4::from_cols_array_2d(&entries).transpose())
}

/// The reason why a value with numbers in it is refused.
pub enum Refused {
    /// The value isn't allowed.
    Value,
    /// A text in it can't be read as a number.
    Expression {
        /// As the author wrote it.
        text: String,
        /// The error in the expression.
        error: ExpressionError,
    },
}

/// A finite number, an integer, or an expression as a text.
pub(super) fn number(value: &Value, dimension: Dimension) -> Result<f64, Refused> {
    match value {
        Value::Integer(i) => Ok(*i.value() as f64),
        Value::Float(x) => Some(*x.value()).filter(|x| x.is_finite()).ok_or(Refused::Value),
        Value::String(text) => {
            let text = text.value();
            expression::evaluate(text, dimension).map_err(|error| Refused::Expression { text: text.clone(), error })
        }
        Value::Boolean(_) | Value::Datetime(_) | Value::Array(_) | Value::InlineTable(_) => Err(Refused::Value),
    }
}

/// An allowed number.
fn number_if(value: &Value, dimension: Dimension, is_allowed: impl Fn(f64) -> bool) -> Result<f64, Refused> {
    number(value, dimension).and_then(|x| allow(x, is_allowed(x)))
}

/// A list of exactly this many numbers.
pub(super) fn numbers<const N: usize>(value: &Value, dimension: Dimension) -> Result<[f64; N], Refused> {
    let list = value.as_array().filter(|list| list.len() == N).ok_or(Refused::Value)?;
    let mut numbers = [0.0; N];
    for (place, value) in numbers.iter_mut().zip(list) {
        *place = number(value, dimension)?;
    }
    Ok(numbers)
}

pub(super) fn whole_numbers(value: &Value) -> Option<[i64; 2]> {
    let list = value.as_array().filter(|list| list.len() == 2)?;
    Some([list.get(0)?.as_integer()?, list.get(1)?.as_integer()?])
}

/// A text for every language, or for some. `text.en = "…"` is a table, `text = { en = "…" }` a value.
pub(super) fn told_by(item: &Item) -> Option<Localized> {
    match item.as_table_like() {
        Some(table) => localized_in(table),
        None => item.as_value().and_then(told),
    }
}

/// A text for every language, or for some. English stands for a missing one.
pub(super) fn told(value: &Value) -> Option<Localized> {
    match value.as_inline_table() {
        Some(table) => localized_in(table),
        None => words_of(value).map(|text| Localized::same(&text)),
    }
}

fn words_of(value: &Value) -> Option<String> {
    value.as_str().filter(|text| !text.trim().is_empty()).map(str::to_owned)
}

fn localized_in(table: &dyn TableLike) -> Option<Localized> {
    let text = |(tag, item): (&str, &Item)| Some((tag.to_owned(), item.as_value().and_then(words_of)?));
    Localized::from_languages(table.iter().map(text).collect::<Option<_>>()?)
}

pub(super) fn vector(value: &Value, dimension: Dimension) -> Result<DVec3, Refused> {
    numbers(value, dimension).map(DVec3::from_array)
}

/// A text that's the same in every language, or one for each.
pub(super) fn write_told(text: &Localized) -> Value {
    if text.to_file().all(|(tag, _)| tag == "en") {
        return quoted(&text.en);
    }
    text.to_file().map(|(tag, text)| (tag, quoted(text))).collect::<InlineTable>().into()
}

/// A text in double quotes on one line. The library would take several lines for a text with a line end, and those
/// change with the line ends of the file. (JSON escapes the same characters as TOML, except for DEL.)
pub(super) fn quoted(text: &str) -> Value {
    let quoted = serde_json::Value::from(text).to_string().replace('\u{7f}', "\\u007F");
    let mut value = quoted.parse().unwrap_or_else(|_| Value::from(text));
    value.decor_mut().clear();
    value
}

/// The shortest decimal number that reads back as the same `f64`. It's in Rust's notation for floats, because the
/// library's has hundreds of zeros if the number is very large or small.
fn written(x: f64) -> Value {
    let mut value = numbers::exact(x).parse().unwrap_or_else(|_| Value::from(x));
    // Spaces around it belong to its place.
    value.decor_mut().clear();
    value
}

fn write_vector(v: DVec3) -> Value {
    numbers_of(v.to_array())
}

pub(super) fn write_vectors(points: &[DVec3]) -> Value {
    points.iter().map(|p| write_vector(*p)).collect::<Array>().into()
}

fn write_matrix(m: &DMat4) -> Value {
    (0..4).map(|i| numbers_of(m.row(i).to_array())).collect::<Array>().into()
}

fn numbers_of<const N: usize>(numbers: [f64; N]) -> Value {
    numbers.into_iter().map(written).collect::<Array>().into()
}
