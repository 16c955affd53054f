//! The `[camera]` and the `[[cameras]]` of a figure file.

use toml_edit::{ArrayOfTables, Item, Table, Value};

use super::{camera, quoted, table};
use crate::appearance::Rgba;
use crate::figure::{CameraTag, Figure, NamedCamera};

/// `[camera]`, with its optional name and color.
pub(super) fn current(figure: &Figure) -> Table {
    let CameraTag { name, color } = &figure.tag;
    tagged(name.as_deref(), *color, camera(&figure.camera, figure.lens_in_force()))
}

/// `[[cameras]]`.
pub(super) fn cameras(figure: &Figure) -> ArrayOfTables {
    let one =
        |other: &NamedCamera| tagged(Some(&other.name), other.color, camera(&other.parameters, other.lens_in_force()));
    figure.cameras.iter().map(one).collect()
}

/// Name and color first, then the keys of the camera.
fn tagged(name: Option<&str>, color: Option<Rgba>, keys: Table) -> Table {
    let name = name.map(|name| ("name", quoted(name)));
    let color = color.map(|color| ("color", Value::from(color.to_string())));
    let mut section = table(name.into_iter().chain(color));
    for (key, item) in keys.iter().filter_map(|(key, item)| Some((key, item.as_value()?))) {
        section.insert(key, Item::Value(item.clone()));
    }
    section
}
