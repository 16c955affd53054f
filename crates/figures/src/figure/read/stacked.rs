//! Stacks sections of figures. Each states only changes.

use toml_edit::{Item, Table, TableLike};

use super::figure;
use super::section::{Fault, Section};
use crate::figure::Figure;
use crate::figure::keys::{home, remove_rivals, sections};

/// Stacked sections, with their places in the text.
#[derive(Debug, Default)]
pub struct Stacked {
    table: Table,
}

impl Stacked {
    /// Puts the sections of a figure in `over` on top, where each key replaces the one that was there. Lists of
    /// sections are replaced whole. A section of the camera ends `show.operation`, which led to the camera before,
    /// unless `over` has that too.
    pub fn put(&mut self, over: &mut Section<'_>) {
        for name in sections() {
            over.skip(name);
        }
        let Some(items) = over.table else { return };
        let has_operation =
            items.get("show").and_then(Item::as_table_like).is_some_and(|s| s.contains_key("operation"));
        if items.contains_key("camera") && !has_operation {
            self.remove("show.operation");
        }
        for name in sections() {
            let Some((key, item)) = items.get_key_value(name) else { continue };
            match (self.table.get_mut(name).and_then(Item::as_table_like_mut), item.as_table_like()) {
                (Some(below), Some(above)) => {
                    if name == "camera" {
                        above.iter().for_each(|(key, _)| remove_rivals(below, key));
                    }
                    put(below, above);
                }
                _ => drop(self.table.insert_formatted(key, item.clone())),
            }
        }
    }

    /// Removes a key, `show.stage`, or a whole section, `labels`. False if there is none.
    pub fn remove(&mut self, path: &str) -> bool {
        match path.split_once('.') {
            None => sections().contains(&path) && self.table.remove(path).is_some(),
            Some((section, key)) => {
                let section = self.table.get_mut(section).and_then(Item::as_table_like_mut);
                section.is_some_and(|section| section.remove(key).is_some())
            }
        }
    }

    /// The figure of all of them. `within` is a section of their text.
    pub fn figure(&self, within: &Section<'_>, faults: &mut Vec<Fault>) -> Figure {
        let label = within.name_of("").trim_matches(['[', ']', ' ']).to_owned();
        figure(Section::new(within.text, Some(&self.table), &format!("[{label}]"), within.at).with_homes(home), faults)
    }
}

fn put(below: &mut dyn TableLike, above: &dyn TableLike) {
    for (name, item) in above.iter() {
        below.remove(name);
        // With the key that knows its place in the text.
        if let Some((key, _)) = above.get_key_value(name) {
            below.entry_format(key).or_insert(item.clone());
        }
    }
}
