//! Values of keys in a lesson file, from texts that an author types.

use toml_edit::{Item, Value};

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

/// A text in both languages. It's stored once if they're the same. A language without a text isn't stored.
pub(super) fn told_item(text: &Bilingual) -> Item {
    if text.en == text.pt_br {
        return Item::Value(text.en.as_str().into());
    }
    let texts = [("en", &text.en), ("pt-BR", &text.pt_br)].into_iter().filter(|(_, text)| !text.is_empty());
    Item::Value(Value::InlineTable(texts.map(|(lang, text)| (lang, text.as_str())).collect()))
}

/// The text of a key as it's written. A language without a text of its own is empty, and a text without a language is
/// that of both. `None` if it's no text.
pub(super) fn told(item: Option<&Item>) -> Option<Bilingual> {
    let item = item?;
    if let Some(text) = item.as_str() {
        return Some(Bilingual { en: text.to_owned(), pt_br: text.to_owned() });
    }
    let table = item.as_table_like()?;
    let of = |key| table.get(key).and_then(Item::as_str).map(str::to_owned);
    let [en, pt_br] = ["en", "pt-BR"].map(of);
    (en.is_some() || pt_br.is_some())
        .then(|| Bilingual { en: en.unwrap_or_default(), pt_br: pt_br.unwrap_or_default() })
}
