//! Explains a text that isn't TOML by its line, its key, and the reason.

use toml_edit::TomlError;

use super::{line_of, snippet};
use crate::figure::error::{FigureError, Problem};
use crate::{expression, sanitize};

/// The parser's error in our words.
pub(super) fn explain(text: &str, error: &TomlError) -> FigureError {
    let duplicate = error.message() == "duplicate key";
    let (start, end) = match error.span() {
        Some(span) => (span.start.min(text.len()), span.end.min(text.len())),
        None => (0, 0),
    };
    // A missing token is reported at the next one, but it's missing at the end of the line before.
    let at = if start == end { text[..floor(text, start)].trim_end().len() } else { start };
    if duplicate {
        let header = line_at(text, at).trim_start().starts_with('[');
        let key = snippet(text, start..end);
        let key = match section_before(text, at) {
            _ if header => snippet(line_at(text, at), 0..line_at(text, at).len()),
            Some(section) => format!("{section} {key}"),
            None => key,
        };
        return FigureError { line: line_of(text, at), key, problem: Problem::Duplicate };
    }
    let key = match (section_before(text, at), key_before(text, at)) {
        (Some(section), Some(key)) => format!("{section} {key}"),
        (Some(section), None) => section,
        (None, Some(key)) => key,
        (None, None) => String::new(),
    };
    let line = line_at(text, at);
    if let Some(expression) = unquoted(line) {
        return FigureError { line: line_of(text, at), key, problem: Problem::Unquoted { text: expression } };
    }
    let found = snippet(line, 0..line.len());
    let detail = snippet_of_message(error.message());
    FigureError { line: line_of(text, at), key, problem: Problem::Syntax { found, detail } }
}

/// The value of a line if it would be a number in quotes: `45°`, `0.9 rad`, `1/3`.
fn unquoted(line: &str) -> Option<String> {
    let (_, value) = line.split_once('=')?;
    let value = value.split('#').next().unwrap_or_default().trim();
    // Digits and points alone are a number that TOML writes in another way.
    let is_number = value.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | ',' | '+' | '-' | 'e' | 'E'));
    expression::evaluate(value, expression::Dimension::Angle).ok().filter(|_| !is_number)?;
    Some(snippet(value, 0..value.len()))
}

fn snippet_of_message(message: &str) -> String {
    sanitize::within(&message.split_whitespace().collect::<Vec<_>>().join(" "), 200)
}

/// The greatest place not after `at` that lies between two characters.
fn floor(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(0)
}

fn line_at(text: &str, at: usize) -> &str {
    let at = floor(text, at);
    let start = text[..at].rfind('\n').map_or(0, |i| i + 1);
    let end = text[at..].find('\n').map_or(text.len(), |i| at + i);
    text[start..end].trim()
}

/// The lines up to the one of `at`, the last one first.
fn lines_back(text: &str, at: usize) -> impl Iterator<Item = &str> {
    let at = floor(text, at);
    let end = text[at..].find('\n').map_or(text.len(), |i| at + i);
    text[..end].lines().rev().map(str::trim)
}

/// The header of the section at `at`.
fn section_before(text: &str, at: usize) -> Option<String> {
    lines_back(text, at)
        .find(|line| line.starts_with('['))
        .and_then(|line| line.find(']').map(|end| &line[..=end]))
        .map(|header| if header.starts_with("[[") { format!("{header}]") } else { header.to_owned() })
        .map(|header| snippet(&header, 0..header.len()))
}

/// The key of the value at `at`: the key of an earlier line whose brackets are still open, or that of this line.
fn key_before(text: &str, at: usize) -> Option<String> {
    let mut lines = lines_back(text, at);
    let here = key_of(lines.next()?);
    let mut open = 0;
    for line in lines.take_while(|line| !line.starts_with('[')) {
        let code = line.split('#').next().unwrap_or_default();
        open += code.matches(['[', '{']).count();
        open = open.saturating_sub(code.matches([']', '}']).count());
        if line.contains('=') {
            return key_of(line).filter(|_| open > 0).or(here);
        }
    }
    here
}

/// The key at the start of a line.
fn key_of(line: &str) -> Option<String> {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.');
    let key = line.split('=').next().unwrap_or_default().trim();
    let good = key.len() <= 80 && key.starts_with(|c: char| c.is_ascii_alphabetic()) && key.chars().all(is_bare);
    good.then(|| key.to_owned())
}
