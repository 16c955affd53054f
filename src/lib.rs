//! Camera Lab: an interactive laboratory for the virtual camera of computer graphics.
//!
//! Data goes one way: **figure → camera → pipeline → drawing → picture**. The window ([`gui`]) and the command line
//! ([`cli`]) are two thin shells over the same library: what one can show, the other can print.
//!
//! | space | unit | axes |
//! | --- | --- | --- |
//! | world | scene units | right-handed, y up |
//! | view (VRC) | scene units | right-handed, x right, y up, z towards the viewer |
//! | clip | homogeneous | x, y, z in \[−w, w\] inside the volume |
//! | ndc | 1 | left-handed, −1 … 1, z into the screen |
//! | window | scene units | on the plane z_c = −F, x right, y up |
//! | image | pixels | (0, 0) is the top-left corner, y down |
//!
//! Start reading at [`camera`] for the model of the notes, and at [`pipeline`] for the way from a scene to a picture.
//!
//! | module | purpose |
//! | --- | --- |
//! | `appearance` | colour, line style, and the `[style]` of a figure |
//! | `camera/` | the camera of the notes `[0]`: pure values in `f64` |
//! | `chart` | a chart as data, with logarithmic axes |
//! | `cli/` | the command line: one file per subcommand, and their shared parts |
//! | `clock` | the clock of the two shells |
//! | `drawing/` | the display list: a picture as data, in pixels with depth |
//! | `exercises/` | exercises: those of the notes, families with numbers from a seed, and a lecturer's own |
//! | `explain/` | every number explained, as data for both shells |
//! | `export/` | drawing or report → file formats |
//! | `expression` | numbers as people write them: `sqrt(2)/2`, `45°`, `1/3`, `12,5` |
//! | `figure/` | a figure as a value, and the figure file: TOML text ↔ value |
//! | `files/` | the file system for both shells, and its substitute in a page of a browser |
//! | `formula` | mathematics between dollar signs in texts from outside: the allowed commands |
//! | `geometry/` | the words that glam lacks: angle, ray, plane, box |
//! | `gui/` | the window: a thin shell over the library |
//! | `i18n/` | every text in both languages, as typed Rust values |
//! | `inspect` | every number of a figure, as the command line prints it and the window shows it |
//! | `lessons/` | lessons: figures one after the other, each with a text, a question or something to do |
//! | `lighting` | the reflection model of `[2]` and `[3]`, for faces, vertices and pixels |
//! | `limits` | every limit, once, with its reason |
//! | `numbers` | numbers as people read them: digits, steps that read well, times and counts |
//! | `numerics/` | error against run time; health and diagnosis of a camera |
//! | `picture/` | request → pixels: the only place that makes pictures |
//! | `pipeline/` | scene + camera → `Drawing`: the stages in the order of the notes `[3]` §1.1 |
//! | `progress` | progress and cancellation of long work |
//! | `raster/` | `Drawing` → pixels |
//! | `sanitize` | display of text from outside: control characters escaped, shortened |
//! | `scene/` | the scene: meshes in world space, lights, and the lines, marks and texts placed in the world |
//! | `share` | a figure in a link: its text, packed, after the `#` of an address |
//! | `simd` | wide vectors: the one door to the library that has them |
//! | `stage` | the stages of the pipeline by name, for plans, files and windows |
//! | `text` | labels in the bundled font: their size, and their outlines |
//! | `views/` | a figure → the scene that each of the three pictures shows, and its observer |

pub mod appearance;
pub mod camera;
pub mod chart;
pub mod cli;
pub mod clock;
pub mod drawing;
pub mod exercises;
pub mod explain;
pub mod export;
pub mod expression;
pub mod figure;
pub mod files;
pub mod formula;
pub mod geometry;
#[cfg(feature = "gui")]
pub mod gui;
pub mod i18n;
pub mod inspect;
pub mod lessons;
pub mod lighting;
pub mod limits;
pub mod numbers;
pub mod numerics;
pub mod picture;
pub mod pipeline;
pub mod progress;
pub mod raster;
pub mod sanitize;
pub mod scene;
pub mod share;
mod simd;
pub mod stage;
pub mod text;
pub mod views;
