//! The explanation of w.

use crate::Lang;

texts!("why/homogeneous");
