//! Numbers as programs write them.

use crate::camera::recovery::entries::Written;
use crate::expression::{self, Dimension};

/// A number as programs write it; NaN and infinities are entries too, so that they can be named.
pub(crate) fn written(part: &str) -> Option<Written> {
    let lower = part.to_lowercase();
    let unsigned = lower.trim_start_matches(['+', '-', '−']).trim_start_matches("np.").trim_start_matches("math.");
    // `-1.#IND00` of C on Windows has digits behind it.
    let is_msvc = ["1.#ind", "1.#qnan", "1.#snan"].iter().any(|spelling| unsigned.starts_with(spelling));
    // `null` is the NaN of JavaScript.
    if matches!(unsigned, "nan" | "null") || is_msvc {
        return Some(Written { value: f64::NAN, error: 0.0 });
    }
    if ["inf", "infinity", "∞"].contains(&unsigned) || unsigned.starts_with("1.#inf") {
        let value = if lower.starts_with(['-', '−']) { f64::NEG_INFINITY } else { f64::INFINITY };
        return Some(Written { value, error: 0.0 });
    }
    if !begins_number(part) {
        return None;
    }
    // Suffixes of C, C# and Rust.
    let suffixes = ["_f32", "_f64", "f32", "f64", "f", "F", "d", "D", "L"];
    let bare = suffixes.iter().find_map(|suffix| part.strip_suffix(suffix)).unwrap_or(part);
    let bare_value =
        bare.parse().ok().or_else(|| expression::evaluate(bare.trim_start_matches('+'), Dimension::Number).ok());
    let value: f64 = bare_value?;
    Some(Written { value, error: error(bare, value) })
}

/// Half of the last digit. Numbers with the digits of an `f32` have its rounding, shorter ones are what they say.
fn error(text: &str, value: f64) -> f64 {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let Some((_, decimals)) = mantissa.split_once(['.', ',']) else { return 0.0 };
    let digits = mantissa.chars().filter(char::is_ascii_digit).count();
    let exponent: i32 = exponent.trim_start_matches('+').parse().unwrap_or(0);
    let places = i32::try_from(decimals.len()).unwrap_or(i32::MAX);
    let last = 0.5 * 10.0_f64.powi(exponent.saturating_sub(places));
    if digits > 7 { last.max(6e-8 * value.abs()) } else { last }
}

/// Brackets and quotes, and the frames of matrices in consoles.
pub(crate) fn is_separator(c: char) -> bool {
    "[](){}<>|;&\\".contains(c) || ('\u{2500}'..='\u{257f}').contains(&c) || ('\u{239b}'..='\u{23b1}').contains(&c)
}

/// The text without lines of comments.
pub(crate) fn without_comments(text: &str) -> String {
    let is_comment = |line: &&str| ["#", "//", "%"].iter().any(|mark| line.trim_start().starts_with(mark));
    text.lines().filter(|line| !is_comment(line)).collect::<Vec<_>>().join("\n")
}

/// The text without indices in brackets: `m[4][4] =`, and `[0]`, `[1]` … of debuggers.
pub(crate) fn without_indices(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('[') {
        let inside = &rest[at + 1..];
        // `[1,]` and `[,1]` are those of R.
        let digits = inside.chars().take_while(|c| c.is_ascii_digit() || *c == ',').count();
        let is_of_r = inside[..digits].len() > 1 && inside[..digits].matches(',').count() == 1;
        let closes = inside[digits..].starts_with(']')
            && (is_of_r && inside[..digits].trim_matches(',').len() + 1 == digits
                || digits > 0 && !inside[..digits].contains(','));
        let after = inside.get(digits + 1..).unwrap_or_default().trim_start_matches(' ');
        let before = plain.chars().chain(rest[..at].chars()).next_back();
        let follows_name = before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '\u{1}');
        plain.push_str(&rest[..at]);
        if closes
            && (is_of_r || follows_name || after.starts_with(['=', ':', '{', '(', '\t', '[']) || begins_number(after))
        {
            // Remembers that a second index follows.
            plain.push('\u{1}');
            rest = &inside[digits + 1..];
        } else {
            plain.push('[');
            rest = inside;
        }
    }
    plain.push_str(rest);
    plain.replace('\u{1}', " ")
}

pub(crate) fn begins_number(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '−' | '.' | '+'))
}

/// True if commas stand inside the numbers, no more than one in each part, between digits.
pub(crate) fn has_decimal_commas(text: &str) -> bool {
    let is_decimal = |part: &str| {
        part.split_once(',').is_none_or(|(whole, decimals)| {
            !decimals.contains(',')
                && whole.ends_with(|c: char| c.is_ascii_digit())
                && decimals.starts_with(|c: char| c.is_ascii_digit())
        })
    };
    text.contains(',') && text.split_whitespace().all(is_decimal)
}
