//! Answers as students type them: `1/sqrt(3)`, `[1, 0, 0]`, `[[1; 0]; [0; 1]]`, a choice, `key=value; …` of `[camera]`.

use std::borrow::Cow;

use super::exercise::{Ask, Kind, Unit};
use crate::camera::Parameters;
use crate::expression::{self, Dimension, ExpressionError, ExpressionProblem};
use crate::figure::{FigureError, read};
use crate::limits::MAX_ANSWER;

/// A parsed answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// Numbers; `None` for an empty entry, or `?`.
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

/// The reason why an answer can't be read. It isn't judged then.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AnswerError {
    /// No answer.
    #[error("an answer is missing")]
    Empty,
    /// Too long for any sensible answer.
    #[error("an answer has at most {MAX_ANSWER} characters")]
    TooLong,
    /// An invalid number.
    #[error("row {}, column {}: {error}", row + 1, column + 1)]
    Number {
        /// From 0.
        row: usize,
        /// From 0.
        column: usize,
        /// The text of the entry.
        text: String,
        /// The error in it.
        error: ExpressionError,
    },
    /// A bracket without its other half.
    #[error("a bracket is missing")]
    Bracket,
    /// Neither a number that's multiplied nor a row.
    #[error("beside the brackets only a factor may stand; a function needs brackets: [1, 1, 1]/sqrt(3)")]
    BesideBrackets,
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
    /// None of the choices.
    #[error("{given:?} is none of {}", choices.join(", "))]
    Choice {
        /// The text of the answer.
        given: String,
        /// The words that the question accepts.
        choices: Vec<String>,
    },
    /// Not `key=value`.
    #[error("{0:?} is not KEY=VALUE")]
    Pair(String),
    /// No parameter of a camera.
    #[error("{0:?} begins with no parameter of a camera; allowed: C, PF, VUP, projection, θ, W, H, A, F, B, window")]
    Parameter(String),
    /// Not a camera.
    #[error("{0}")]
    Camera(FigureError),
}

/// Reads an answer. It may use the numbers in `names` by their names, such as F.
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

/// True if an answer uses a name that has a number only in its exercise.
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
    let number = |text: &str| expression::evaluate_with(text, dimension, names);
    let (text, is_turned) = from_latex(text);
    let text = text.trim();
    let product = if ask.kind == Kind::Number { None } else { without_factor(text, number) };
    let (text, factor) = product.unwrap_or((text, 1.0));
    let [asked_rows, asked_columns] = ask.shape();
    let asked = if is_matrix { asked_columns } else { asked_rows };
    let reads = |part: &str| is_gap(part) || number(part).is_ok();
    let parts = |row| between_blanks(row, asked, reads).unwrap_or_else(|| split(row));
    let is_one = ask.kind == Kind::Number && !text.starts_with('[');
    let cells = if is_one { vec![vec![text]] } else { cells(text, is_matrix, parts)? };
    let first = cells.first().map_or(0, Vec::len);
    let mut entries = Vec::new();
    for (row, parts) in cells.iter().enumerate() {
        if parts.len() != first {
            return Err(AnswerError::Ragged { row, found: parts.len(), first });
        }
        for (column, part) in parts.iter().enumerate() {
            let part = part.trim();
            if is_gap(part) {
                entries.push(None);
                continue;
            }
            let value =
                number(part).map_err(|error| AnswerError::Number { row, column, text: part.to_owned(), error })?;
            entries.push(Some(factor * value));
        }
    }
    let (rows, columns) = (cells.len(), first);
    if is_turned && rows > 1 && columns > 1 {
        let entries = (0..entries.len()).map(|k| entries[k % rows * columns + k / rows]).collect();
        return Ok(Answer::Numbers { rows: columns, columns: rows, entries });
    }
    // A student may type a vector as a row or as a column.
    let lies = !is_matrix && rows == 1;
    Ok(if lies {
        Answer::Numbers { rows: columns, columns: 1, entries }
    } else {
        Answer::Numbers { rows, columns, entries }
    })
}

/// A matrix of LaTeX, `\begin{pmatrix} 1 & 0 \\ 0 & 1 \end{pmatrix}`, in brackets, and true if it's to be transposed,
/// `[…]^T`. Other texts stay.
fn from_latex(text: &str) -> (Cow<'_, str>, bool) {
    const TURNED: [&str; 6] = ["^T", "^{T}", r"^\top", r"^{\top}", "^t", "ᵀ"];
    let closes = |rest: &&str| rest.trim_end().ends_with([']', ')', '}']);
    let turned = TURNED.iter().find_map(|mark| text.trim_end().strip_suffix(mark)).filter(closes);
    let (text, is_turned) = turned.map_or((text, false), |rest| (rest.trim_end(), true));
    let matrix = || {
        let (before, rest) = text.split_once(r"\begin{")?;
        let (kind, rest) = rest.split_once('}')?;
        let (rows, after) = rest.split_once(&format!(r"\end{{{kind}}}"))?;
        let rows = rows.split(r"\\").map(str::trim).filter(|row| !row.is_empty());
        let rows: Vec<String> = rows.map(|row| format!("[{}]", row.replace('&', ";"))).collect();
        kind.ends_with("matrix").then(|| format!("{before}[{}]{after}", rows.join(", ")))
    };
    (matrix().map_or(Cow::Borrowed(text), Cow::Owned), is_turned)
}

/// The numbers of a row if only blanks separate them; `None` for other rows.
fn between_blanks(row: &str, asked: usize, reads: impl Fn(&str) -> bool) -> Option<Vec<&str>> {
    let apart: Vec<&str> = row.split_whitespace().collect();
    let is_number = |part: &&str| !part.starts_with([',', ';']) && !part.ends_with([',', ';']) && reads(part);
    (asked > 1 && apart.len() == asked && apart.iter().all(is_number)).then_some(apart)
}

/// The marks that stand for a missing number.
fn is_gap(part: &str) -> bool {
    matches!(part, "" | "?" | "_")
}

/// A list or a matrix without the number that multiplies or divides it, and that number: `2*[1, 0]`, `[1, 0]/√2`.
fn without_factor<E>(text: &str, number: impl Fn(&str) -> Result<f64, E>) -> Option<(&str, f64)> {
    let (start, end) = match (text.find('['), text.rfind(']')) {
        (Some(start), Some(end)) if start < end => (start, end + 1),
        _ => last_list(text)?,
    };
    let (before, list, after) = (text.get(..start)?.trim(), text.get(start..end)?, text.get(end..)?.trim());
    if before.is_empty() && after.is_empty() {
        return None;
    }
    let before = before.trim_end_matches(['*', '×', '·']).trim_end();
    let before = before.strip_suffix(r"\cdot").unwrap_or(before);
    // 1*[…]/2 and -[…]. The text after it begins with its sign.
    let before = match before {
        "" => "1".to_owned(),
        "-" | "−" | "–" => "-1".to_owned(),
        other => other.to_owned(),
    };
    // In a sum, only a part would be multiplied.
    let scales = |one: f64, twice: f64| ((2.0 * one - twice).abs() <= 1e-9 * twice.abs()).then_some(one);
    let factor = scales(number(&before).ok()?, number(&format!("2*{before}")).ok()?)?;
    let share = scales(number(&format!("1{after}")).ok()?, number(&format!("2{after}")).ok()?)?;
    // 1[…]5 isn't a product.
    let is_product = after.is_empty() || after.starts_with(['/', '*', '÷', '×', '·']);
    (is_product && (factor * share).is_finite()).then_some((list, factor * share))
}

/// The bytes of the last parentheses with a list between them.
fn last_list(text: &str) -> Option<(usize, usize)> {
    let (mut starts, mut found) = (Vec::new(), None);
    for (at, c) in text.char_indices() {
        match c {
            '(' => starts.push(at),
            ')' => {
                let start = starts.pop()?;
                let is_list = starts.is_empty() && text[start..at].contains([',', ';']);
                found = if is_list { Some((start, at + 1)) } else { found };
            }
            _ => {}
        }
    }
    found
}

/// The parts of a list or of a matrix.
fn cells<'a>(
    text: &'a str,
    is_matrix: bool,
    parts: impl Fn(&'a str) -> Vec<&'a str>,
) -> Result<Vec<Vec<&'a str>>, AnswerError> {
    let inner = unwrapped(text)?;
    let has_rows = inner.contains('[') || (is_matrix && inner.trim_start().starts_with('('));
    if has_rows {
        return rows_in_brackets(inner)?.into_iter().map(|row| Ok(parts(unwrapped(row)?))).collect();
    }
    if inner.contains('\n') {
        return Ok(inner.lines().filter(|line| !line.trim().is_empty()).map(parts).collect());
    }
    // 1, 2; 3, 4 and 1 2; 3 4
    let has_blanks = || inner.split(';').any(|row| row.trim().contains(char::is_whitespace));
    if is_matrix && inner.contains(';') && (inner.contains(',') || has_blanks()) {
        let rows = inner.split(';').filter(|row| !row.trim().is_empty());
        return Ok(rows.map(parts).collect());
    }
    Ok(vec![parts(inner)])
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

/// The text without the brackets around the whole.
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

/// The rows `[…]` of a matrix, with any separators between them.
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
            _ if open == 0 => return Err(AnswerError::BesideBrackets),
            _ => {}
        }
        if open < 0 {
            return Err(AnswerError::Bracket);
        }
    }
    if open == 0 { Ok(rows) } else { Err(AnswerError::Bracket) }
}

/// The names of the parameters of a camera in the notes and in both languages, and their keys.
const PARAMETERS: [(&[&str], &str); 10] = [
    (&["c", "position", "posição", "posicao"], "position"),
    (&["pf", "focal_point", "focal point", "ponto focal"], "focal_point"),
    (&["vup", "view_up"], "view_up"),
    (&["projection", "projeção", "projecao"], "projection"),
    (&["θ", "theta", "view_angle", "ângulo", "angulo"], "view_angle"),
    (&["h", "height", "altura"], "height"),
    (&["a", "aspect", "aspecto"], "aspect"),
    (&["f", "near"], "near"),
    (&["b", "far"], "far"),
    (&["window", "janela"], "window"),
];

/// The words for values in another language.
const WORDS: [(&str, &str); 3] =
    [("paralela", "parallel"), ("perspectiva", "perspective"), ("em perspectiva", "perspective")];

/// A camera by the names of the notes, or by the keys of a figure file.
fn camera(text: &str) -> Result<Parameters, AnswerError> {
    let mut toml = String::from("[camera]\n");
    let pairs = text.lines().flat_map(|line| top_level(line, ';')).flat_map(between_commas);
    let pairs: Vec<&str> = pairs.filter(|pair| !pair.is_empty() && *pair != "[camera]").collect();
    let given = |names: &[&str]| {
        let mut named = pairs.iter().filter_map(|pair| pair.split_once('='));
        named.find(|(name, _)| names.contains(&&*name.trim().to_lowercase())).map(|(_, value)| value.trim())
    };
    for pair in &pairs {
        let pair_error = || AnswerError::Pair((*pair).to_owned());
        let (name, value) = pair.split_once('=').ok_or_else(pair_error)?;
        let name = name.trim().to_lowercase();
        // W = A H (5.1) tells the one that's missing.
        if ["w", "width", "largura"].contains(&&*name) {
            let [height, aspect] = [5, 6].map(|k: usize| given(PARAMETERS[k].0));
            let line = match (height, aspect) {
                (None, aspect) => toml_value(&format!("({value})/({})", aspect.unwrap_or("4/3"))),
                // With A as well, the key is there twice, and the message says so.
                (Some(height), _) => toml_value(&format!("({value})/({height})")),
            };
            toml.push_str(&format!("{} = {line}\n", if height.is_none() { "height" } else { "aspect" }));
            continue;
        }
        let known = PARAMETERS.iter().find(|(names, _)| names.contains(&name.as_str()));
        let (_, key) = known.ok_or_else(|| AnswerError::Parameter((*pair).to_owned()))?;
        let value = value.trim();
        let sides = if *key == "window" { sides(value) } else { None };
        toml.push_str(&format!("{key} = {}\n", sides.unwrap_or_else(|| toml_value(value))));
    }
    match read::parse(&toml) {
        Ok(figure) => Ok(figure.camera),
        Err(error) => Err(AnswerError::Camera(error)),
    }
}

/// `C=(0, 0, 2), F=0,5` at the commas before a name.
fn between_commas(text: &str) -> Vec<&str> {
    let mut pairs = Vec::new();
    let (mut start, mut end) = (0, 0);
    for part in top_level(text, ',') {
        if part.contains('=') && end > start {
            pairs.push(text[start..end].trim());
            start = end + 1;
        }
        end += part.len() + usize::from(end > 0);
    }
    pairs.push(text[start..].trim());
    pairs
}

/// (l, r, b, t) as a window in TOML.
fn sides(value: &str) -> Option<String> {
    let inner = value.strip_prefix(['(', '['])?.strip_suffix([')', ']'])?;
    let parts: Vec<String> = expression::parts(inner).map(|part| toml_value(part.trim())).collect();
    let [left, right, bottom, top] = parts.try_into().ok()?;
    Some(format!("{{ left = {left}, right = {right}, bottom = {bottom}, top = {top} }}"))
}

/// A value in TOML: words and expressions become texts.
fn toml_value(value: &str) -> String {
    let between = |open, close| value.strip_prefix(open).and_then(|rest: &str| rest.strip_suffix(close));
    let list = between('[', ']').or_else(|| between('(', ')').filter(|inner| inner.contains([',', ';'])));
    if let Some(inner) = list {
        let parts: Vec<String> = expression::parts(inner).map(|part| toml_value(part.trim())).collect();
        return format!("[{}]", parts.join(", "));
    }
    if let Some((_, word)) = WORDS.iter().find(|(word, _)| word.eq_ignore_ascii_case(value)) {
        return format!("{word:?}");
    }
    let number = value.parse::<f64>().ok().filter(|value| value.is_finite());
    let is_toml = value.parse::<toml_edit::Value>().is_ok();
    match number {
        _ if is_toml && (number.is_some() || value.starts_with(['"', '\'', '{'])) => value.to_owned(),
        // .5 is a number, but not one in TOML.
        Some(number) => toml_edit::Value::from(number).to_string(),
        None => toml_edit::Value::from(value).to_string(),
    }
}
