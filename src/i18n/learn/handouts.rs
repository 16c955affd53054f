//! The words of the dialog that prints lessons and exercises.

use crate::i18n::Lang;

texts!("learn/handouts");
