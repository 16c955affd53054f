//! Lessons: figures one after the other, each with a text, a question or something to do. A lesson is a file, and each
//! of its steps is a whole figure.
//!
//! | file | purpose |
//! | --- | --- |
//! | `condition` | goals of a student: conditions on the camera, on the keys of the figure, or on what is seen |
//! | `edit` | changes of a lesson file by its author in the window |
//! | `lesson` | a lesson and its steps as values |
//! | `numbers_in_texts` | the numbers of a figure in the texts of a lesson, in place of the paths in braces |
//! | `passage` | the way from the figure of one step to that of the next |
//! | `place` | the lines and keys of a lesson file at which its scenes and its folder show a fault |
//! | `read` | the text of a lesson file → `Lesson` |
//! | `record` | a step of a lesson from what is on the screen |
//! | `shipped` | the lessons that are part of the program |

mod condition;
mod edit;
mod lesson;
mod numbers_in_texts;
mod passage;
mod place;
mod read;
mod record;
mod shipped;

pub use condition::{Condition, Goal, Range, Seen, Subject, objects_named};
pub use edit::{Edit, LessonText, StepText, Words, edited, reworded};
pub use lesson::{Lesson, Link, OpenLesson, Step, Task};
pub use numbers_in_texts::{filled, numbers_of};
pub use passage::Passage;
pub use place::{Part, place};
pub use read::{parse, parse_bytes};
pub use record::{Draft, with_step};
pub use shipped::{ShippedLesson, shipped};
