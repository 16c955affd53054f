//! The difference of two figures, as a step of a lesson states it.

use toml_edit::{DocumentMut, Item, Table, TableLike};

use super::same;
use crate::figure::Figure;
use crate::figure::keys::is_way_of_the_angle;
use crate::figure::write::document;

/// The keys in which a figure differs from another.
#[derive(Debug, Default)]
pub struct Difference {
    /// The sections with the keys that are new or have another value.
    pub changed: DocumentMut,
    /// The keys of the other figure that this one doesn't have, `show.stage`.
    pub without: Vec<String>,
}

impl Difference {
    /// The names of all keys in it, such as `camera.near`. A list or a text of its own counts as one key.
    pub fn keys(&self) -> Vec<String> {
        let of = |(section, item): (&str, &Item)| match item.as_table_like() {
            Some(table) => table.iter().map(|(key, _)| format!("{section}.{key}")).collect(),
            None => vec![section.to_owned()],
        };
        self.changed.iter().flat_map(of).chain(self.without.iter().cloned()).collect()
    }
}

/// The difference of `now` from `before`; `None` means everything. Title and caption don't take part.
///
/// *Guarantees*: sections of `before` without the keys in `without`, with those in `changed` put over them, are `now`.
pub fn difference(before: Option<&Figure>, now: &Figure) -> Difference {
    let own = |figure: &Figure| document(&Figure { title: None, caption: None, ..figure.clone() });
    let (old, new) = (before.map(own).unwrap_or_default(), own(now));
    let mut difference = Difference::default();
    for (section, item) in new.iter() {
        let was = old.get(section);
        match (item.as_table_like(), was.and_then(Item::as_table_like)) {
            (Some(now), Some(was)) => {
                put(&mut difference.changed, section, changed(now, was));
                // Another way to give θ replaces the previous one.
                let replaced = |key: &&str| section == "camera" && is_way_of_the_angle(key);
                let gone = was.iter().map(|(key, _)| key).filter(|key| !now.contains_key(key) && !replaced(key));
                difference.without.extend(gone.map(|key| format!("{section}.{key}")));
            }
            _ if was.is_some_and(|was| same(was, item)) => {}
            _ => drop(difference.changed.insert(section, item.clone())),
        }
    }
    // A section of the camera would end the operations that led to the camera before.
    let operations = |figure: &DocumentMut| Some(figure.get("show")?.as_table_like()?.get("operation")?.clone());
    let kept = operations(&new).zip(operations(&old)).filter(|(now, was)| same(now, was));
    if let Some((kept, _)) = kept.filter(|_| difference.changed.contains_key("camera")) {
        let show = difference.changed.entry("show").or_insert_with(toml_edit::table);
        show.as_table_like_mut().into_iter().for_each(|show| drop(show.insert("operation", kept.clone())));
    }
    let gone = old.iter().map(|(section, _)| section).filter(|section| !new.contains_key(section));
    difference.without.extend(gone.map(str::to_owned));
    difference
}

/// The keys of a section with another value than before.
fn changed(now: &dyn TableLike, was: &dyn TableLike) -> Table {
    let mut table = Table::new();
    for (key, item) in now.iter().filter(|(key, item)| !was.get(key).is_some_and(|was| same(was, item))) {
        table.insert(key, item.clone());
    }
    table
}

fn put(document: &mut DocumentMut, section: &str, mut table: Table) {
    if table.is_empty() {
        return;
    }
    // `[observers.world]` has no `[observers]` of its own.
    let holds_tables = table.iter().all(|(_, item)| item.is_table());
    table.set_implicit(holds_tables);
    document.insert(section, Item::Table(table));
}
