//! The words of the dialog that prints lessons and exercises.

use crate::Lang;

texts!("learn/handouts");
