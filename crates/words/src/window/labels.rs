//! The words of the mode *Labels*, in both languages.

use crate::Lang;
use crate::figure::labels::LabelTextError;
use crate::limits::MAX_LABEL_TEXT;
use crate::messages::figure_files;
use crate::sanitize::escaped;

texts!("window/labels");

/// The reason why a text can't be that of a label.
pub fn refused(lang: Lang, error: &LabelTextError) -> String {
    match error {
        LabelTextError::Length => text!(lang, refused_length, MAX_LABEL_TEXT),
        LabelTextError::Formula(error) => text!(lang, refused_formula, formula = figure_files::formula(lang, error)),
    }
}

/// A name in `[labels]` that no label has.
pub fn unknown(lang: Lang, name: &str, near: Option<&str>) -> String {
    let name = escaped(name);
    let meant = figure_files::meant(lang, near);
    text!(lang, unknown, name, meant)
}
