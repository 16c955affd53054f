//! Drawing or report → file formats.
//!
//! | file | purpose |
//! | --- | --- |
//! | `animation` | animations as GIF and APNG |
//! | `crop` | a picture without the empty background around its content |
//! | `format` | the formats of picture files |
//! | `paper` | the sizes of pictures for paper and slides that have a name |
//! | `plot` | charts as pages of vectors |
//! | `png` | PNG with the figure file inside |
//! | `sheet` | several pictures on one sheet |
//! | `vector/` | pages of vectors: the list of the things on one, and its writers |
//! | `web` | WebP and JPEG, without the figure |

pub mod animation;
pub mod crop;
pub mod format;
pub mod paper;
pub mod plot;
pub mod png;
pub mod sheet;
pub mod vector;
pub mod web;
