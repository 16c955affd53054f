//! Exercises and lessons.

pub(super) mod exercise_cameras;
pub mod exercise_messages;
pub mod exercise_sheet;
pub(super) mod exercise_texts;
pub mod exercises;
pub mod lessons;
pub mod moodle;

/// The words of the dialog that prints lessons and exercises.
pub mod handouts {
    texts!("learn/handouts");

    texts_with_values! {
        /// The sentence about a sheet with several versions.
        versions(lang, count: u32, first: u32, last: u32);
        /// The sentence about the file of their solutions.
        solutions_beside(lang, name: &str);
    }

    /// The name of the file with the solutions, beside a sheet of this name without an ending.
    pub fn solutions_file(stem: &str, lang: Lang) -> String {
        format!("{stem}-{}.pdf", super::lessons::texts(lang).solutions.to_lowercase())
    }
}

/// The words around the fields for the task of a step.
pub mod lesson_tasks {
    texts!("learn/lesson_tasks");
}

/// The words of the window about exercises, besides the exercises themselves.
pub mod exercise_window {

    texts!("learn/exercise_window");

    /// The action of a button with its question, so that screen reader users know which one of several it is.
    pub fn of_ask(what: &str, ask: &str) -> String {
        format!("{what}: {ask}")
    }

    /// The guess, and the question after it.
    pub fn you_said(lang: Lang, guess: &str, question: &str) -> String {
        format!("{}: **{guess}**. {question}", texts(lang).you_guessed)
    }

    /// A field of a vector or a matrix. Rows and columns from 0.
    pub fn field(lang: Lang, ask: &str, [rows, columns]: [usize; 2], [row, column]: [usize; 2]) -> String {
        let (i, j) = (row + 1, column + 1);
        match (rows, columns) {
            (1, 1) => ask.to_owned(),
            (_, 1) => format!("{ask} {i}"),
            (..) => text!(lang, field, ask, i, j),
        }
    }

    /// An answer isn't an axis, because it's longer or shorter than 1.
    pub fn axis_length(lang: Lang, length: f64) -> String {
        let length = lang.mark().number(length, 4);
        text!(lang, axis_length, length)
    }

    /// An answer isn't an axis, because its scalar product with **n** isn't 0.
    pub fn axis_oblique(lang: Lang, product: f64) -> String {
        let product = lang.mark().number(product, 4);
        text!(lang, axis_oblique, product)
    }
}
