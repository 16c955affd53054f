//! The words about families of pictures, with the reasons why some keys can't be varied.

use super::{Lang, messages};
use crate::figure::variation::VariationError;
use crate::limits::{MAX_FAMILY, MAX_FRAMES};
use crate::sanitize::escaped;

texts!("families");

/// The reason why there is no family.
pub fn error(lang: Lang, error: &VariationError) -> String {
    match error {
        VariationError::NoValues => text!(lang, error_no_values).to_owned(),
        VariationError::Range { found, limit } => text!(lang, error_range, found = escaped(found), limit),
        VariationError::TooMany { count, limit } => text!(lang, error_too_many, count, limit),
        VariationError::Figure { key, value, error } => {
            format!("{} = {}: {}", escaped(key), escaped(value), messages::without_line(lang, error))
        }
        VariationError::Operation { key, value, error } => {
            format!("{} = {}: {}", escaped(key), escaped(value), messages::operation(lang, error))
        }
    }
}

texts_with_values! {
    /// A number of columns that no sheet has.
    columns(lang, text: &str): (text = escaped(text), MAX_FAMILY);

    /// A number of pictures that no animation has.
    frames(lang, text: &str): (text = escaped(text), MAX_FRAMES);

    /// A number of variations that a command can't use.
    variations(lang, count: usize, most: usize);

    /// Rows that wouldn't have the pictures of a figure below one another.
    uneven_rows(lang, count: usize, columns: usize);
}
