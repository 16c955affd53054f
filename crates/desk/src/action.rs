//! Requests of a feature to the window: an action, a file, an intent that may lose work.

use crate::chart::Chart;
use crate::export::plot::Block;
use crate::lessons::{Lesson, OpenLesson};
use camera_lab_words::class::ClassReport;

/// A request of one feature to another. The window performs it at the end of the frame.
#[derive(Clone, Debug)]
pub enum Action {
    /// Ask for a file to read or to write.
    File(FileFor),
    /// Do this once nothing can be lost any more.
    Begin(Intent),
    /// Play the lesson on offer in the line above the window.
    Offered(OpenLesson),
    /// Ask if the objects below the deleted ones go too.
    Delete {
        /// Their names.
        names: std::collections::BTreeSet<String>,
        /// Number of other objects below them.
        below: usize,
    },
    /// Ask if the progress in exercises is to be deleted.
    DeleteProgress,
    /// Show the camera check.
    Coach,
    /// Show the study of the figure on the screen.
    Examine,
    /// Show the comparison.
    Compare,
    /// Show the list of lessons.
    Lessons,
    /// Show a note.
    Note(&'static str),
}

impl Action {
    /// Plays a built-in lesson from a step.
    pub fn lesson(lesson: std::sync::Arc<Lesson>, step: usize) -> Self {
        Self::Begin(Intent::Lesson(OpenLesson { lesson, path: None, step }))
    }

    /// Asks where to write a chart with this title.
    pub fn chart(title: &str, chart: Chart) -> Self {
        Self::chart_with(title, chart, [const { String::new() }; 2])
    }

    /// Asks where to write a chart with this title, or its numbers as CSV or JSON.
    pub fn chart_with(title: &str, chart: Chart, [csv, json]: [String; 2]) -> Self {
        let block = Block { title: title.to_owned(), rows: vec![vec![chart]] };
        Self::File(FileFor::Chart(Box::new(ChartFile { block, csv, json })))
    }
}

/// A chart for a file, and its numbers, which are empty if it has none of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartFile {
    /// The chart.
    pub block: Block,
    /// As CSV.
    pub csv: String,
    /// As JSON.
    pub json: String,
}

/// A file that a feature asks for.
#[derive(Clone, Debug, PartialEq)]
pub enum FileFor {
    /// To put a mesh into the scene.
    Mesh(MeshFor),
    /// To put a texture on the object of this name.
    Texture(String),
    /// To put a photograph under the image.
    Photograph,
    /// To compare the figure with the one in it.
    CompareWith,
    /// To write the way to the canonical volume, by these steps, as an animation or a strip, depending on the ending of
    /// the name.
    Animation(crate::camera::Decomposition),
    /// To write a chart.
    Chart(Box<ChartFile>),
    /// To export progress in exercises, as a table for spreadsheets.
    Progress,
    /// A folder of a lecturer's own exercises.
    Exercises,
    /// A folder with the progress of students.
    Class,
    /// To write the keys as a page to print: its bytes.
    Keys(Vec<u8>),
    /// To write the report on a class.
    ClassReport(Box<ClassReport>),
}

/// An action to perform once nothing can be lost any more.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Intent {
    /// The default figure.
    New,
    /// Ask for a file and open it.
    Open,
    /// Open this file.
    OpenPath(std::path::PathBuf),
    /// Open the built-in figure with this name.
    Shipped(&'static str),
    /// Open the figure of this text.
    Text(String),
    /// Play this lesson.
    Lesson(OpenLesson),
    /// End the lesson. The figure of its step stays.
    LeaveLesson,
    /// Write the lesson to which steps were added last.
    WriteRecorded,
    /// Read the file of the lesson being written again.
    ReadLesson,
    /// Read the figure's own file again.
    Reload,
    /// Restore the session of this slot.
    Restore(usize),
    /// Close the window.
    Quit,
}

impl Intent {
    /// True if it loses the figure of the window.
    pub fn replaces_figure(&self) -> bool {
        // Work in the steps of a lesson is kept if its file is read again.
        !matches!(self, Self::LeaveLesson | Self::ReadLesson)
    }
}

/// The use of a mesh file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MeshFor {
    /// A new object.
    New,
    /// This object, by name.
    Object(String),
}
