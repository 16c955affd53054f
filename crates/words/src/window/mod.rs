//! The words of the window.

pub mod cameras;
pub mod canvas;
pub mod coach;
pub mod compare;
pub mod gallery;
pub mod labels;
pub mod lens;
pub mod photograph;
pub mod predict;
pub mod progress;
pub mod scenes;
pub mod search;
pub mod sessions;
pub mod sharing;

use crate::Lang;

texts!("window");
