//! Answers as they are typed: `1/sqrt(3)`, `[1, 0, 0]`, `[[1; 0]; [0; 1]]`, a choice, `key=value; …` of `[camera]`.

use super::exercise::{Ask, Kind, Unit};
use crate::camera::Parameters;
use crate::expression::{self, Dimension, ExpressionError, ExpressionProblem};
use crate::figure::{FigureError, read};
use crate::limits::MAX_ANSWER;

/// An answer as it was understood.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// Numbers; `None` where nothing was typed, or `?`.
    Numbers {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
        /// Row by row.
        entries: Vec<Option<f64>>,
    },
    /// Index of the choice.
    Choice(usize),
    /// A camera.
    Camera(Box<Parameters>),
}

/// Why an answer cannot be read. It is not judged then.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AnswerError {
    /// No answer.
    #[error("an answer is missing")]
    Empty,
    /// More than anybody types.
    #[error("an answer has at most {MAX_ANSWER} characters")]
    TooLong,
    /// A number that is not one.
    #[error("row {}, column {}: {error}", row + 1, column + 1)]
    Number {
        /// From 0.
        row: usize,
        /// From 0.
        column: usize,
        /// The text of the entry.
        text: String,
        /// The fault in it.
        error: ExpressionError,
    },
    /// A bracket without its other half.
    #[error("a bracket is missing")]
    Bracket,
    /// Rows of different lengths.
    #[error("row {} has {found} numbers, the first has {first}", row + 1)]
    Ragged {
        /// From 0.
        row: usize,
        /// Its number of entries.
        found: usize,
        /// The number of entries of the first row.
        first: usize,
    },
    /// Not one of the choices.
    #[error("{given:?} is none of {}", choices.join(", "))]
    Choice {
        /// The text of the answer.
        given: String,
        /// The choices.
        choices: Vec<String>,
    },
    /// Not `key=value`.
    #[error("{0:?} is not KEY=VALUE")]
    Pair(String),
    /// Not a camera.
    #[error("{0}")]
    Camera(FigureError),
}

/// Reads an answer; `names` are numbers that it may use by their names, such as F.
///
/// # Errors
/// [`AnswerError`] names the unreadable part and its place.
pub fn read_answer(text: &str, ask: &Ask, names: &[(&str, f64)]) -> Result<Answer, AnswerError> {
    if text.trim().is_empty() {
        return Err(AnswerError::Empty);
    }
    if text.len() > MAX_ANSWER {
        return Err(AnswerError::TooLong);
    }
    match &ask.kind {
        Kind::Choice(choices) => choice(text.trim(), choices),
        Kind::Camera => camera(text).map(|parameters| Answer::Camera(Box::new(parameters))),
        Kind::Number | Kind::Vector(_) | Kind::Matrix(..) => numbers(text.trim(), ask, names),
    }
}

/// Whether an answer uses a name that has a number only in its exercise.
#[must_use]
pub fn uses_names(text: &str, ask: &Ask, names: &[(&str, f64)]) -> bool {
    let unknown = |error: &AnswerError| {
        matches!(
            error,
            AnswerError::Number { error: ExpressionError { problem: ExpressionProblem::UnknownName(_), .. }, .. }
        )
    };
    read_answer(text, ask, &[]).is_err_and(|error| unknown(&error)) && read_answer(text, ask, names).is_ok()
}

fn choice(text: &str, choices: &[String]) -> Result<Answer, AnswerError> {
    let found = choices.iter().position(|choice| choice.eq_ignore_ascii_case(text));
    let number = || text.parse::<usize>().ok().filter(|n| (1..=choices.len()).contains(n)).map(|n| n - 1);
    match found.or_else(number) {
        Some(index) => Ok(Answer::Choice(index)),
        None => Err(AnswerError::Choice { given: text.to_owned(), choices: choices.to_vec() }),
    }
}

fn numbers(text: &str, ask: &Ask, names: &[(&str, f64)]) -> Result<Answer, AnswerError> {
    let dimension = if ask.unit == Unit::Degrees { Dimension::Angle } else { Dimension::Number };
    let is_matrix = matches!(ask.kind, Kind::Matrix(..));
    let cells =
        if ask.kind == Kind::Number && !text.starts_with('[') { vec![vec![text]] } else { cells(text, is_matrix)? };
    let first = cells.first().map_or(0, Vec::len);
    let mut entries = Vec::new();
    for (row, parts) in cells.iter().enumerate() {
        if parts.len() != first {
            return Err(AnswerError::Ragged { row, found: parts.len(), first });
        }
        for (column, part) in parts.iter().enumerate() {
            let part = part.trim();
            if matches!(part, "" | "?" | "_") {
                entries.push(None);
                continue;
            }
            let value = expression::evaluate_with(part, dimension, names).map_err(|error| AnswerError::Number {
                row,
                column,
                text: part.to_owned(),
                error,
            })?;
            entries.push(Some(value));
        }
    }
    let (rows, columns) = (cells.len(), first);
    // A vector may be typed as a row or as a column.
    let lies = !is_matrix && rows == 1;
    Ok(if lies {
        Answer::Numbers { rows: columns, columns: 1, entries }
    } else {
        Answer::Numbers { rows, columns, entries }
    })
}

/// The parts of a list or of a matrix.
fn cells(text: &str, is_matrix: bool) -> Result<Vec<Vec<&str>>, AnswerError> {
    let inner = unwrapped(text)?;
    let has_rows = inner.contains('[') || (is_matrix && inner.trim_start().starts_with('('));
    if has_rows {
        return rows_in_brackets(inner)?.into_iter().map(|row| Ok(split(unwrapped(row)?))).collect();
    }
    if inner.contains('\n') {
        return Ok(inner.lines().filter(|line| !line.trim().is_empty()).map(split).collect());
    }
    // 1, 2; 3, 4
    if is_matrix && inner.contains(';') && inner.contains(',') {
        return Ok(inner.split(';').map(|row| top_level(row, ',')).collect());
    }
    Ok(vec![split(inner)])
}

fn split(text: &str) -> Vec<&str> {
    top_level(text, if text.contains(';') { ';' } else { ',' })
}

/// The parts between separators outside of all brackets.
fn top_level(text: &str, separator: char) -> Vec<&str> {
    let mut open = 0_usize;
    text.split(move |c| {
        match c {
            '(' | '[' => open += 1,
            ')' | ']' => open = open.saturating_sub(1),
            _ => {}
        }
        c == separator && open == 0
    })
    .collect()
}

/// Without the brackets around the whole.
fn unwrapped(text: &str) -> Result<&str, AnswerError> {
    let text = text.trim();
    let (mut open, mut closes_before_end) = (0_i64, false);
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' => open += 1,
            ')' | ']' => open -= 1,
            _ => {}
        }
        if open < 0 {
            return Err(AnswerError::Bracket);
        }
        closes_before_end |= open == 0 && at + c.len_utf8() < text.len();
    }
    if open != 0 {
        return Err(AnswerError::Bracket);
    }
    let is_list = text.starts_with('[') || (text.starts_with('(') && text.contains([',', ';']));
    match text.get(1..text.len().saturating_sub(1)) {
        Some(inner) if is_list && !closes_before_end => Ok(inner),
        _ => Ok(text),
    }
}

/// The rows `[…]` of a matrix, with whatever separators between them.
fn rows_in_brackets(text: &str) -> Result<Vec<&str>, AnswerError> {
    let (mut rows, mut open, mut start) = (Vec::new(), 0_i64, 0);
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' => {
                if open == 0 {
                    start = at;
                }
                open += 1;
            }
            ')' | ']' => {
                open -= 1;
                if open == 0 {
                    rows.push(&text[start..=at]);
                }
            }
            ',' | ';' => {}
            c if c.is_whitespace() => {}
            _ if open == 0 => return Err(AnswerError::Bracket),
            _ => {}
        }
        if open < 0 {
            return Err(AnswerError::Bracket);
        }
    }
    if open == 0 { Ok(rows) } else { Err(AnswerError::Bracket) }
}

/// The keys of `[camera]`, as a figure file has them.
fn camera(text: &str) -> Result<Parameters, AnswerError> {
    let mut toml = String::from("[camera]\n");
    for pair in text.split(['\n', ';']).map(str::trim).filter(|pair| !pair.is_empty() && *pair != "[camera]") {
        let (key, value) = pair.split_once('=').ok_or_else(|| AnswerError::Pair(pair.to_owned()))?;
        toml.push_str(&format!("{} = {}\n", key.trim(), toml_value(value.trim())));
    }
    match read::parse(&toml) {
        Ok(figure) => Ok(figure.camera),
        Err(error) => Err(AnswerError::Camera(error)),
    }
}

/// A value as TOML has it: words and expressions become texts.
fn toml_value(value: &str) -> String {
    if let Some(inner) = value.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
        let parts: Vec<String> = expression::parts(inner).map(|part| toml_value(part.trim())).collect();
        return format!("[{}]", parts.join(", "));
    }
    let is_toml = value.starts_with(['"', '\'', '{']) || value.parse::<f64>().is_ok_and(f64::is_finite);
    if is_toml { value.to_owned() } else { toml_edit::Value::from(value).to_string() }
}
