//! The words of the list of cameras, in both languages.

use crate::Lang;

texts!("window/cameras");
