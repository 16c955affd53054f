//! The words of the lens: the view angle as cameras and other programs give it, in both languages.

use crate::Lang;

texts!("window/lens");
