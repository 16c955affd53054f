//! Values of keys in a lesson file, from texts that an author types.

use toml_edit::{Item, Value};

use crate::figure::Localized;

/// A number as the author types it, in the notation of either language. A text that isn't a number stays a text, for
/// the reader to judge.
pub(super) fn number_item(typed: &str) -> Option<Item> {
    let typed = typed.trim();
    let value = match (typed.parse::<i64>(), typed.replace(',', ".").parse::<f64>()) {
        (Ok(whole), _) => whole.into(),
        (_, Ok(number)) if number.is_finite() => number.into(),
        _ => typed.into(),
    };
    (!typed.is_empty()).then_some(Item::Value(value))
}

/// Like [`told_item`], but `None` for an empty text.
pub(super) fn told_if_any(text: &Localized) -> Option<Item> {
    (*text != Localized::default()).then(|| told_item(text))
}

/// A text in several languages. It's stored once if they're the same. A language without a text isn't stored.
pub(super) fn told_item(text: &Localized) -> Item {
    if text.en == text.pt_br && text.others.iter().all(|(_, text)| text.is_empty()) {
        return Item::Value(text.en.as_str().into());
    }
    Item::Value(Value::InlineTable(text.iter().filter(|(_, text)| !text.is_empty()).collect()))
}

/// The text of a key as it's written. A language without a text of its own is empty, and a text without a language is
/// that of all. `None` if it's no text.
pub(super) fn told(item: Option<&Item>) -> Option<Localized> {
    let item = item?;
    if let Some(text) = item.as_str() {
        return Some(Localized::same(text));
    }
    let table = item.as_table_like()?;
    let text = |(tag, item): (&str, &Item)| Some((tag.to_owned(), item.as_str()?.to_owned()));
    let texts: Vec<_> = table.iter().filter_map(text).collect();
    Localized::in_file(texts).filter(|text| *text != Localized::default() || !table.is_empty())
}
