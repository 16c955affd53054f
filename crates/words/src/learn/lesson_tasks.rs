//! The words around the fields for the task of a step.

use crate::Lang;

texts!("learn/lesson_tasks");
