//! Complaints of the TOML parser. In English these are the beginnings of its own words.

use crate::Lang;

texts!("messages/toml_complaints");
