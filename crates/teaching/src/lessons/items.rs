//! Values of keys in a lesson file, from texts that an author types.

use toml_edit::{InlineTable, Item, Value};

use crate::figure::Bilingual;

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
pub(super) fn told_if_any(text: &Bilingual) -> Option<Item> {
    (!text.en.is_empty() || !text.pt_br.is_empty()).then(|| told_item(text))
}

/// A text in both languages. It's stored once if they're the same, or if only one language has a text.
pub(super) fn told_item(text: &Bilingual) -> Item {
    if text.en == text.pt_br || text.pt_br.is_empty() {
        return Item::Value(text.en.as_str().into());
    }
    if text.en.is_empty() {
        return Item::Value(text.pt_br.as_str().into());
    }
    let mut table = InlineTable::new();
    table.insert("en", text.en.as_str().into());
    table.insert("pt-BR", text.pt_br.as_str().into());
    Item::Value(Value::InlineTable(table))
}
