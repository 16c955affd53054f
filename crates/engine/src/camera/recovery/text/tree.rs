//! Numbers in a tree of JSON, into which YAML is turned too.

use serde_json::Value;

/// A number of JSON; `null` is the NaN of JavaScript.
pub(crate) fn number(value: &Value) -> Option<f64> {
    if value.is_null() { Some(f64::NAN) } else { value.as_f64() }
}

/// A list of numbers, of one level or more.
pub(crate) fn list(value: &Value) -> Option<Vec<f64>> {
    let mut numbers = Vec::new();
    for item in value.as_array()? {
        match item {
            Value::Array(_) => numbers.extend(list(item)?),
            _ => numbers.push(number(item)?),
        }
    }
    Some(numbers)
}
