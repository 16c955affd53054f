//! A change of a figure → the change of its text, with comments and order kept.

mod difference;
mod vary;

use toml_edit::{Array, ArrayOfTables, DocumentMut, InlineTable, Item, Table, TableLike, Value};

use super::write::{document, to_toml};
use super::{Figure, read};

pub use difference::{Difference, difference};
pub(super) use vary::value_of;
pub use vary::{has, number_at, show_with, varied, varied_together};

/// The figure file of `figure`, made from an earlier text by changing only the parts that differ. Comments, order and
/// the notation of numbers stay. A text that isn't a figure file is replaced.
///
/// # Guarantees
/// Reading the text gives `figure` back, as with [`to_toml`].
pub fn update(text: &str, figure: &Figure) -> String {
    edit(text, figure).unwrap_or_else(|| to_toml(figure))
}

fn edit(text: &str, figure: &Figure) -> Option<String> {
    // A repair replaces a camera that may be impossible.
    let mut old = document(&read::parse_with_any_camera(text).ok()?.0);
    let new = document(figure);
    if same_table(old.as_table(), new.as_table()) {
        return Some(text.to_owned());
    }
    let (text, bom) = text.strip_prefix('\u{feff}').map_or((text, ""), |rest| (rest, "\u{feff}"));
    let mut edited: DocumentMut = text.parse().ok()?;
    // Some defaults depend on other keys (the preset on the objects, the viewport on the image), so a second round
    // writes down those that the first has moved.
    for _ in 0..2 {
        merge(edited.as_table_mut(), old.as_table(), new.as_table());
        old = document(&read::parse(&edited.to_string()).ok()?);
        if same_table(old.as_table(), new.as_table()) {
            break;
        }
    }
    let mut edited = edited.to_string();
    if text.contains("\r\n") {
        edited = edited.replace("\r\n", "\n").replace('\n', "\r\n");
    }
    // If the author's formatting is too unlike ours to be edited piece by piece, the numbers come first.
    let reached = document(&read::parse(&edited).ok()?);
    same_table(reached.as_table(), new.as_table()).then(|| format!("{bom}{edited}"))
}

/// Applies to `mine` the changes from `old` to `new`.
fn merge(mine: &mut dyn TableLike, old: &dyn TableLike, new: &dyn TableLike) {
    for (key, _) in old.iter().filter(|(key, _)| !new.contains_key(key)) {
        mine.remove(key);
    }
    for (key, value) in new.iter() {
        let was = old.get(key);
        if !was.is_some_and(|was| same(was, value)) {
            merge_item(mine, key, was, value);
        }
    }
}

/// True if both have the same text.
fn same(a: &Item, b: &Item) -> bool {
    match (a, b) {
        (Item::Value(a), Item::Value(b)) => a.to_string() == b.to_string(),
        (Item::Table(a), Item::Table(b)) => same_table(a, b),
        (Item::ArrayOfTables(a), Item::ArrayOfTables(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same_table(a, b))
        }
        _ => false,
    }
}

fn same_table(a: &dyn TableLike, b: &dyn TableLike) -> bool {
    a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| same(a, b)))
}

fn merge_item(table: &mut dyn TableLike, key: &str, old: Option<&Item>, new: &Item) {
    match (table.get_mut(key), new) {
        (Some(Item::ArrayOfTables(mine)), Item::ArrayOfTables(new)) => {
            merge_list(mine, old.and_then(Item::as_array_of_tables), new);
        }
        (Some(Item::Value(Value::Array(mine))), Item::Value(Value::Array(new)))
            if mine.len() == new.len() && new.iter().all(|x| !x.is_array()) =>
        {
            merge_vector(mine, old.and_then(Item::as_array), new);
        }
        (Some(Item::Value(mine)), Item::Value(new)) if !(mine.is_inline_table() && new.is_inline_table()) => {
            let decor = mine.decor().clone();
            *mine = new.clone();
            *mine.decor_mut() = decor;
        }
        (Some(mine), new) if mine.is_table_like() && new.is_table_like() => {
            let nothing = Table::new();
            if let (Some(mine), Some(new)) = (mine.as_table_like_mut(), new.as_table_like()) {
                merge(mine, old.and_then(Item::as_table_like).unwrap_or(&nothing), new);
            }
            if let Item::Value(Value::InlineTable(new)) = new {
                order_as(mine, new);
            }
        }
        _ => {
            table.insert(key, new.clone());
        }
    }
}

/// Brings the keys of a table into the order of `new` if the order matters, because the first key of a comparison names
/// it.
fn order_as(mine: &mut Item, new: &InlineTable) {
    let place = |key: &str| new.iter().position(|(other, _)| other == key);
    let is_ordered = |table: &dyn TableLike| table.iter().map(|(key, _)| place(key)).is_sorted();
    match mine {
        Item::Table(table) if !is_ordered(table) => {
            table.sort_values_by(|a, _, b, _| place(a.get()).cmp(&place(b.get())));
        }
        Item::Value(Value::InlineTable(table)) if !is_ordered(table) => {
            table.sort_values_by(|a, _, b, _| place(a.get()).cmp(&place(b.get())));
        }
        _ => {}
    }
}

/// Updates the components that have changed, so that the others stay as written.
fn merge_vector(mine: &mut Array, old: Option<&Array>, new: &Array) {
    for (i, component) in new.iter().enumerate() {
        let same = old.and_then(|old| old.get(i)).is_some_and(|was| was.to_string() == component.to_string());
        if let Some(mine) = mine.get_mut(i).filter(|_| !same) {
            let decor = mine.decor().clone();
            *mine = component.clone();
            *mine.decor_mut() = decor;
        }
    }
}

/// Merges two lists of tables, which [`sources`] pairs: by name if possible, otherwise by equal keys.
fn merge_list(mine: &mut ArrayOfTables, old: Option<&ArrayOfTables>, new: &ArrayOfTables) {
    let old: Vec<&Table> = old.iter().flat_map(|list| list.iter()).collect();
    let mut rest: Vec<Option<Table>> = mine.iter().cloned().map(Some).collect();
    let mut places: Vec<isize> = mine.iter().filter_map(Table::position).collect();
    places.sort_unstable();
    let mut places = places.into_iter();
    let sources = sources(&old, new);
    mine.clear();
    for (table, source) in new.iter().zip(sources) {
        let found = source.and_then(|j| Some((old.get(j)?, rest.get_mut(j)?.take()?)));
        let merged = match found {
            Some((was, mut found)) => {
                merge(&mut found, *was, table);
                found.set_position(places.next());
                found
            }
            None => table.clone(),
        };
        mine.push(merged);
    }
}

/// The old table that each new one comes from. The first choice is the one with the same name. The next is an equal
/// one, at the same place if there are several. After those comes the pair with the most equal keys. So a renamed
/// object is recognized although another was deleted or added.
///
/// If very many remain, they're paired in their order, because comparing all with all would take too long.
fn sources(old: &[&Table], new: &ArrayOfTables) -> Vec<Option<usize>> {
    const MOST_PAIRS: usize = 1 << 16;
    let new: Vec<&Table> = new.iter().collect();
    let mut found = Sources { of_new: vec![None; new.len()], taken: vec![false; old.len()] };
    let name = |table: &Table| table.get("name").map(ToString::to_string);
    found.take_equal(old, &new, name);
    found.take_equal(old, &new, |table| Some(table.to_string()));
    let (rest_of_new, rest_of_old) = found.rest();
    if rest_of_new.len().saturating_mul(rest_of_old.len()) > MOST_PAIRS {
        rest_of_new.into_iter().zip(rest_of_old).for_each(|(i, j)| found.take(i, j));
        return found.of_new;
    }
    let common = |was: &Table, table: &Table| {
        table.iter().filter(|(key, value)| was.get(key).is_some_and(|was| same(was, value))).count()
    };
    let mut pairs = Vec::new();
    for &i in &rest_of_new {
        for &j in &rest_of_old {
            pairs.push((common(old[j], new[i]), i == j, i, j));
        }
    }
    pairs.sort_by_key(|&(common, same_place, i, j)| (std::cmp::Reverse((common, same_place)), i, j));
    pairs.into_iter().for_each(|(_, _, i, j)| found.take(i, j));
    found.of_new
}

/// The pairs of old and new tables found so far.
struct Sources {
    of_new: Vec<Option<usize>>,
    taken: Vec<bool>,
}

impl Sources {
    /// Makes a pair, if both are free.
    fn take(&mut self, i: usize, j: usize) {
        if self.of_new[i].is_none() && !self.taken[j] {
            self.of_new[i] = Some(j);
            self.taken[j] = true;
        }
    }

    /// Pairs tables with the same key, at the same place first, then in order.
    fn take_equal(&mut self, old: &[&Table], new: &[&Table], key: impl Fn(&Table) -> Option<String>) {
        let (rest_of_new, rest_of_old) = self.rest();
        if rest_of_new.is_empty() || rest_of_old.is_empty() {
            return;
        }
        let keys = |tables: &[&Table]| tables.iter().map(|table| key(table)).collect::<Vec<_>>();
        let (old, new) = (keys(old), keys(new));
        let keyed = || rest_of_new.iter().copied().filter(|&i| new[i].is_some());
        keyed().filter(|&i| old.get(i) == Some(&new[i])).for_each(|i| self.take(i, i));
        for i in keyed() {
            let free = rest_of_old.iter().find(|&&j| !self.taken[j] && old[j] == new[i]);
            if let Some(&j) = free {
                self.take(i, j);
            }
        }
    }

    /// The new tables without an old one, and the old ones without a new one.
    fn rest(&self) -> (Vec<usize>, Vec<usize>) {
        let new = (0..self.of_new.len()).filter(|&i| self.of_new[i].is_none());
        (new.collect(), (0..self.taken.len()).filter(|&j| !self.taken[j]).collect())
    }
}

#[cfg(test)]
mod tests;
