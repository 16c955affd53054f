//! The words around the fields for the task of a step.

use crate::i18n::Lang;

texts!("learn/lesson_tasks");
