//! Links to figures, and the differences in a page of a browser, in both languages.

use crate::Lang;

texts!("window/sharing");
