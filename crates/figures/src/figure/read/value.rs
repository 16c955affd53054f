//! Numbers and texts in values of a figure file.

use glam::DVec3;
use toml_edit::{Item, TableLike, Value};

use crate::expression::{self, Dimension, ExpressionError};

/// The reason why a value with numbers in it is refused.
pub(super) enum Refused {
    /// The value isn't allowed.
    Value,
    /// A text in it can't be read as a number.
    Expression { text: String, error: ExpressionError },
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
pub(super) fn number_if(value: &Value, dimension: Dimension, is_allowed: impl Fn(f64) -> bool) -> Result<f64, Refused> {
    number(value, dimension).and_then(|x| is_allowed(x).then_some(x).ok_or(Refused::Value))
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

/// A text for both languages. `text.en = "…"` is a table, `text = { en = "…" }` a value.
pub(super) fn told_by(item: &Item) -> Option<[String; 2]> {
    match item.as_table_like() {
        Some(table) => bilingual_in(table),
        None => item.as_value().and_then(told),
    }
}

/// A text for both languages. A missing one is the same as the other.
pub(super) fn told(value: &Value) -> Option<[String; 2]> {
    match value.as_inline_table() {
        Some(table) => bilingual_in(table),
        None => words_of(value).map(|text| [text.clone(), text]),
    }
}

fn words_of(value: &Value) -> Option<String> {
    value.as_str().filter(|text| !text.trim().is_empty()).map(str::to_owned)
}

fn bilingual_in(table: &dyn TableLike) -> Option<[String; 2]> {
    let of = |key: &str| table.get(key).map(|item| item.as_value().and_then(words_of));
    let [en, pt_br] = ["en", "pt-BR"].map(of);
    let known = usize::from(en.is_some()) + usize::from(pt_br.is_some());
    match (en.or(pt_br.clone())?, pt_br) {
        (Some(en), None) if known == table.len() => Some([en.clone(), en]),
        (Some(en), Some(Some(pt_br))) if known == table.len() => Some([en, pt_br]),
        _ => None,
    }
}

pub(super) fn vector(value: &Value, dimension: Dimension) -> Result<DVec3, Refused> {
    numbers(value, dimension).map(DVec3::from_array)
}
