//! The desk of Camera Lab: what the window knows, without a window.
//!
//! - [`desk`] owns the [documents](document), shown and hidden, and undo.
//! - [`model`] has the scene, the layout, the selection and the explanations for every feature of the window.
//! - [`background`] does work beside the window's thread, and [`storage`] keeps sessions and the files that several
//!   windows write.
//!
//! Nothing here draws or asks. The window is a [`Wake`], which can be asked for another frame.

pub mod action;
pub mod background;
pub mod coach;
pub mod comparison;
pub mod desk;
pub mod document;
pub mod exchange;
pub mod explained;
pub mod export_error;
pub mod follow;
pub mod handout_job;
pub mod history;
pub mod insert;
pub mod layout;
pub mod message;
pub mod model;
pub mod operations;
pub mod scene_cache;
pub mod scene_tree;
pub mod selected_placement;
pub mod settings;
pub mod shown;
pub mod storage;
#[cfg(test)]
#[path = "../../files/src/testing.rs"]
mod testing;
pub mod tools;
pub mod unsaved_text;
mod wake;
pub mod watch;

use camera_lab_engine::{appearance, camera, geometry, limits, numbers, pipeline, progress, sanitize, scene, stage};
use camera_lab_figures::{chart, explain, export, figure, picture, views};
use camera_lab_teaching::{clock, exercises, lessons, numerics};

pub use action::{Action, FileFor, Intent, MeshFor};
pub use background::memo::{Latest, Memo};
pub use background::worker::{Done, Running, Worker};
pub use coach::Advice;
pub use comparison::{Comparison, LineOrigin};
pub use desk::Desk;
pub use document::Document;
pub use document::source::Source;
pub use explained::Question;
pub use explained::conventions::Conventions;
pub use explained::matrices::{Matrices, Reading, symbols_of};
pub use explained::steps::{Steps, end_of, step_at, time_of};
pub use export_error::ExportError;
pub use follow::Space;
pub use handout_job::{Content, Job};
pub use history::Revision;
pub use insert::{free_place, rounded};
pub use layout::{ObserverChange, Panels, Side, Tab, WindowPlace};
pub use message::{Message, NotExported, Shortfall};
pub use model::Model;
pub use operations::Scrub;
pub use operations::motion::{FADE, arrow};
pub use operations::placing::{Mark, Placing};
pub use operations::predict::{About, Prediction};
pub use scene_cache::is_heavy;
pub use scene_tree::{Draft, Selected, preset_objects};
pub use shown::PanelHover;
pub use storage::recent::{Recent, merged};
pub use storage::session::{Keeping, Kept, LeftOver, News, NewsList, Restored, Sessions};
pub use storage::shared_file::SharedFile;
pub use tools::{CameraList, Drawn, Grip, LabelMode, PhotographTool, SHORTEST};
pub use unsaved_text::UnsavedText;
pub use wake::Wake;
pub use watch::{Theirs, Watch};
