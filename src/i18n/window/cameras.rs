//! The words of the list of cameras, in both languages.

use crate::i18n::Lang;

texts!("window/cameras");
