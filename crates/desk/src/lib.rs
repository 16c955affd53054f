//! The desk of Camera Lab: what the window knows, without a window.
//!
//! - [`desk`] owns the [documents](document), shown and hidden, and undo.
//! - [`model`] has the scene, the layout, the selection and the explanations for every feature of the window.
//! - [`background`] does work beside the window's thread, and [`storage`] keeps sessions and the files that several
//!   windows write.
//!
//! Nothing here draws or asks. The window is a [`Wake`], which can be asked for another frame.

pub mod action;
/// Work next to the window's thread, and values computed once for each key.
pub mod background {
    pub mod memo;
    pub mod worker;
}
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
pub mod pixel_costs;
pub mod scene_cache;
pub mod scene_tree;
pub mod settings;
pub mod shown;
/// Storage that outlives a window: sessions, recent files, and the files that several windows write.
pub mod storage {
    pub mod recent;
    pub mod session;
    pub mod shared_file;
}
#[cfg(test)]
#[path = "../../files/src/testing.rs"]
mod testing;
pub mod tools;
pub mod watch;

use std::time::Duration;

pub use action::{Action, ChartFile, FileFor, Intent, MeshFor};
pub use background::memo::{Latest, Memo};
pub use background::worker::{Done, Running, Worker};
pub use coach::Advice;
pub use comparison::{LineComparison, LineOrigin};
pub use desk::Desk;
pub use document::Document;
pub use document::source::Source;
pub use exchange::MethodImage;
pub use explained::matrices::{Matrices, Reading, symbols_of};
pub use explained::steps::{Steps, end_of, step_at, time_of};
pub use explained::{Conventions, Question};
pub use export_error::ExportError;
pub use follow::Space;
pub use handout_job::{Content, Job};
pub use history::Revision;
pub use insert::{free_place, rounded};
pub use layout::{ObserverChange, Panels, Side, Tab, WindowPlace};
pub use message::{Message, NotExported, Shortfall};
pub use model::Model;
pub use operations::motion::{FADE, arrow};
pub use operations::predict::{About, Prediction};
pub use operations::{Mark, Placing, Scrub};
pub use scene_cache::is_heavy;
pub use scene_tree::{Draft, Selected, preset_objects};
pub use shown::PanelHover;
pub use storage::recent::{Recent, merged};
pub use storage::session::{Keeping, Kept, LeftOver, News, NewsList, Restored, Sessions, UnsavedText};
pub use storage::shared_file::SharedFile;
pub use tools::{CameraList, Drawn, Grip, LabelMode, PhotographTool, SHORTEST};
pub use watch::{Theirs, Watch};

use camera_lab_engine::{appearance, camera, geometry, limits, numbers, pipeline, progress, sanitize, scene, stage};
use camera_lab_figures::{chart, explain, export, figure, inspect, picture, views};
use camera_lab_teaching::{clock, exercises, lessons, numerics};

/// A window that can be asked for another frame, from any thread.
pub trait Wake: Send + Sync {
    /// Asks for a frame after a time. Zero means at once.
    fn wake_after(&self, time: Duration);

    /// Another handle of the same window, for a thread.
    fn handle(&self) -> Box<dyn Wake>;

    /// Asks for a frame at once.
    fn wake(&self) {
        self.wake_after(Duration::ZERO);
    }
}

/// Nobody waits for an answer.
impl Wake for () {
    fn wake_after(&self, _: Duration) {}

    fn handle(&self) -> Box<dyn Wake> {
        Box::new(())
    }
}
