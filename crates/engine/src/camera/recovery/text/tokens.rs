//! A text → its marks, words and numbers.

use super::numbers::{is_separator, written};
use crate::camera::recovery::entries::Written;

#[derive(Debug)]
pub(crate) enum Token {
    Word(String),
    Quoted(String),
    Number(Written),
    Open(char),
    Close(char),
    Comma,
    Semicolon,
    Assign,
    /// A dash before an item of YAML.
    Dash,
    /// The end of a line: the indentation of the next one, and if an empty one lies between.
    Line(usize, bool),
    End,
}

/// A text on its way.
pub(crate) struct Reader<'a> {
    pub(crate) rest: &'a str,
    pub(crate) decimal_commas: bool,
    pub(crate) column: usize,
    /// The indentation of this line, or of this item.
    pub(crate) indent: usize,
    pub(crate) at_start: bool,
    pub(crate) after_space: bool,
    /// `1.0e+03 *` of MATLAB before a matrix.
    pub(crate) factor: f64,
    /// Tokens that were looked at, the next one last.
    pub(crate) ahead: Vec<Token>,
    pub(crate) has_numbers: bool,
    pub(crate) is_elided: bool,
}

impl Reader<'_> {
    fn skip(&mut self, bytes: usize) {
        self.column += bytes;
        self.rest = &self.rest[bytes..];
    }

    pub(crate) fn peek(&mut self) -> &Token {
        let token = self.token();
        self.ahead.push(token);
        // It was pushed.
        &self.ahead[self.ahead.len() - 1]
    }

    pub(crate) fn token(&mut self) -> Token {
        if let Some(token) = self.ahead.pop() {
            return token;
        }
        loop {
            let Some(c) = self.rest.chars().next() else { return Token::End };
            let (at_start, after_space) = (self.at_start, self.after_space);
            let after = &self.rest[c.len_utf8()..];
            if c == '\n' {
                let rest = self.rest.trim_start();
                let passed = &self.rest[..self.rest.len() - rest.len()];
                self.column = passed.rsplit('\n').next().map_or(0, str::len);
                self.rest = rest;
                (self.at_start, self.after_space) = (true, true);
                return Token::Line(self.column, passed.matches('\n').count() > 1);
            }
            if c == '#' && after_space || self.rest.starts_with("//") {
                self.skip(self.rest.find('\n').unwrap_or(self.rest.len()));
                continue;
            }
            self.after_space = c.is_whitespace();
            if c == '-' && at_start && after.starts_with([' ', '\n', '\r']) {
                self.skip(1);
                let rest = self.rest.trim_start_matches(' ');
                self.skip(self.rest.len() - rest.len());
                return Token::Dash;
            }
            self.at_start &= c.is_whitespace();
            if matches!(c, '"' | '\'') {
                self.skip(1);
                if let Some(text) = self.quoted(c) {
                    return Token::Quoted(text);
                }
                continue;
            }
            let is_bracket = c != '<' || after.starts_with(|c: char| c.is_alphanumeric() || "+-. ".contains(c));
            let token = match c {
                '[' | '(' | '{' | '<' if is_bracket => Token::Open(c),
                ']' | ')' | '}' | '>' => Token::Close(c),
                ',' if !self.decimal_commas => Token::Comma,
                ';' | '\\' => Token::Semicolon,
                ':' | '=' => Token::Assign,
                _ if c.is_whitespace() || is_separator(c) => {
                    self.skip(c.len_utf8());
                    continue;
                }
                _ => return self.part(),
            };
            self.skip(1);
            return token;
        }
    }

    /// The text up to the other quote, which is on the same line.
    fn quoted(&mut self, mark: char) -> Option<String> {
        let mut is_escaped = false;
        let is_end = |(_, c): &(usize, char)| {
            let ends = *c == '\n' || *c == mark && !is_escaped;
            is_escaped = *c == '\\' && !is_escaped;
            ends
        };
        let (end, _) = self.rest.char_indices().find(is_end).filter(|(_, c)| *c == mark)?;
        let written = &self.rest[..end];
        // What JSON escapes, `\u00e9`. A path with backslashes that JSON doesn't know stays as it is.
        let unescaped = (mark == '"').then(|| serde_json::from_str(&format!("\"{written}\"")).ok()).flatten();
        let text = unescaped.unwrap_or_else(|| written.to_owned());
        self.skip(end + 1);
        Some(text)
    }

    /// A word or a number.
    fn part(&mut self) -> Token {
        let mut word = String::new();
        loop {
            let ends = |c: char| {
                c.is_whitespace() || is_separator(c) || "\"':=".contains(c) || c == ',' && !self.decimal_commas
            };
            let end = self.rest.find(ends).unwrap_or(self.rest.len());
            word.push_str(&self.rest[..end]);
            self.skip(end);
            // `a::b` and `a->b` are names with a point.
            if self.rest.starts_with("::") {
                word.push('.');
                self.skip(2);
            } else if self.rest.starts_with('>') && word.ends_with('-') && word.len() > 1 {
                word.pop();
                word.push('.');
                self.skip(1);
            } else {
                break;
            }
        }
        // `0:` counts rows.
        if !self.rest.starts_with([':', '='])
            && let Some(mut number) = written(&word)
        {
            number.value *= self.factor;
            number.error *= self.factor;
            self.has_numbers = true;
            return Token::Number(number);
        }
        self.is_elided |= self.has_numbers && matches!(word.as_str(), "..." | "…");
        Token::Word(word)
    }
}
