//! The explanation of w.

use crate::i18n::Lang;

texts!("why/homogeneous");
