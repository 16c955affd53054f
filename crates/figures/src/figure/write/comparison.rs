//! [`Comparison`] → the `[compare]` of a figure file.

use toml_edit::{Array, InlineTable, Table, Value};

use super::{number, quoted, table};
use crate::figure::Comparison;

/// The section.
pub(super) fn comparison(comparison: &Comparison) -> Table {
    let Comparison { with, ops, camera, wiper, beside, differences } = comparison;
    let mut keys: Vec<(&str, Value)> = Vec::new();
    if !with.is_empty() {
        let value =
            |value: &str| value.parse::<Value>().map_or_else(|_| quoted(value), |value| value.decorated("", ""));
        let entries: InlineTable = with.iter().map(|(key, text)| (key.as_str(), value(text))).collect();
        keys.push(("with", entries.into()));
    }
    if !ops.is_empty() {
        keys.push(("ops", ops.iter().map(ToString::to_string).collect::<Array>().into()));
    }
    keys.extend(camera.as_ref().map(|name| ("camera", quoted(name))));
    if *beside {
        keys.push(("layout", "beside".into()));
    }
    if !*beside || *wiper != Comparison::default().wiper {
        keys.push(("wiper", number(*wiper)));
    }
    if *differences {
        keys.push(("differences", true.into()));
    }
    table(keys)
}
