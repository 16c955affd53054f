//! Puts the numbers of a figure into the texts of a lesson, in place of the paths in braces.

use crate::camera::Convention;
use crate::figure::{Figure, Localized, ShownProbe};
use crate::inspect::quantity::{Numbers, QuantityPath};
use crate::inspect::{InspectError, Report};
use crate::numbers::{DecimalMark, significant, without_rests};

/// Decimals of a number if a text doesn't give them.
const DECIMALS: usize = 3;
/// The most decimals that a text may ask for.
const MOST_DECIMALS: usize = 12;
/// Numbers from here on, and those whose decimals would all be 0, have an exponent.
const LARGE: f64 = 1e9;

/// Every number of a figure. Its points are those of `[[points]]`, and its pixel is that of the probe.
///
/// # Errors
/// [`InspectError`] names the impossible quantity.
pub fn numbers_of(figure: &Figure) -> Result<Report, InspectError> {
    let points: Vec<_> = figure.points.iter().map(|point| point.position).collect();
    Report::new(figure, &[], Convention::RightHand, &points, &pixels_of(figure))
}

/// The pixels that a figure shows.
pub(super) fn pixels_of(figure: &Figure) -> Vec<[i64; 2]> {
    match figure.show.probe {
        Some(ShownProbe::Pixel(pixel)) => vec![pixel],
        _ => Vec::new(),
    }
}

/// The text with the sentence of its lesson in place of `{sentence}`, or with none while the author has removed it.
pub fn with_sentence(text: &Localized, sentence: Option<&Localized>) -> Localized {
    const PLACE: &str = "{sentence}";
    text.map(|tag, text| text.replace(PLACE, sentence.map_or("", |sentence| sentence.get(tag)).trim()))
}

/// The text with the numbers of a report in place of `{quantity}` and `{quantity:decimals}`, where `quantity` is a path
/// of `inspect`. Between dollar signs, braces are LaTeX if they don't hold such a path, or follow a command, `^` or
/// `_`.
///
/// # Errors
/// The text between braces that doesn't lead to a number.
pub fn filled(text: &str, report: &Report, mark: DecimalMark) -> Result<String, String> {
    let mut out = String::with_capacity(text.len());
    let (mut rest, mut in_formula) = (text, false);
    while let Some(at) = rest.find(['{', '$', '\\']) {
        let (before, from) = rest.split_at(at);
        out.push_str(before);
        let is_braced = from.starts_with('{') && !(in_formula && follows_command(&out));
        let inner = from.strip_prefix('{').filter(|_| is_braced).and_then(|from| from.split_once('}'));
        rest = if let Some((path, after)) = inner
            && let Some(numbers) = written(path, report, mark, in_formula)
        {
            out.push_str(&numbers);
            after
        } else if from.starts_with('{') && (!in_formula || inner.is_some_and(|(path, _)| is_path(path))) {
            return Err(inner.map_or_else(|| from.chars().take(20).collect(), |(path, _)| path.to_owned()));
        } else {
            // The text consumed by a backslash, and a dollar sign, or two.
            let taken = match from.as_bytes() {
                [b'\\', ..] => 1 + from[1..].chars().next().map_or(0, char::len_utf8),
                [b'$', b'$', ..] => 2,
                _ => 1,
            };
            in_formula ^= from.starts_with('$');
            out.push_str(&from[..taken]);
            &from[taken..]
        };
    }
    out.push_str(rest);
    Ok(out)
}

/// True if a brace would open the argument of a command, or a sub- or superscript.
fn follows_command(before: &str) -> bool {
    let word = before.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    before.ends_with(['^', '_', '}', ']']) || word.len() < before.len() && word.ends_with('\\')
}

/// True if a text is a path, not LaTeX.
fn is_path(text: &str) -> bool {
    let is_of_path = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | ':');
    text.contains('.') && text.starts_with(|c: char| c.is_ascii_lowercase()) && text.chars().all(is_of_path)
}

/// The numbers of a path.
fn written(path: &str, report: &Report, mark: DecimalMark, in_formula: bool) -> Option<String> {
    let (path, decimals) = match path.split_once(':') {
        Some((path, decimals)) => (path, decimals.trim().parse().ok().filter(|n| *n <= MOST_DECIMALS)?),
        None => (path, DECIMALS),
    };
    let Numbers { columns, entries } = QuantityPath::of(path.trim())?.numbers(report)?;
    let entries = without_rests(&entries, decimals + 4);
    let number = |value: &f64| number(*value, decimals, mark, in_formula);
    let separator = match (in_formula, mark) {
        (true, DecimalMark::Point) => ",\\ ",
        (true, DecimalMark::Comma) => ";\\ ",
        (false, mark) => mark.separator(),
    };
    match (entries.as_slice(), columns) {
        ([single], _) => Some(number(single)),
        (_, ..=1) => {
            let list: Vec<String> = entries.iter().map(number).collect();
            Some(format!("({})", list.join(separator)))
        }
        // Only a formula has rows.
        _ if !in_formula => None,
        _ => {
            let row = |row: &[f64]| row.iter().map(number).collect::<Vec<_>>().join(" & ");
            let rows: Vec<String> = entries.chunks(columns).map(row).collect();
            Some(format!("\\begin{{bmatrix}} {} \\end{{bmatrix}}", rows.join(" \\\\ ")))
        }
    }
}

/// A number as in print, or in LaTeX.
fn number(value: f64, decimals: usize, mark: DecimalMark, in_formula: bool) -> String {
    let fixed = format!("{value:.decimals$}");
    let fixed = if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.') } else { &*fixed };
    let is_zero = fixed.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.'));
    let text = match (value == 0.0, value.abs() >= LARGE || is_zero) {
        (true, _) => "0".to_owned(),
        (false, true) => significant(value, 3),
        (false, false) => fixed.to_owned(),
    };
    if !in_formula {
        return mark.printed(&text);
    }
    let text = match text.split_once('e') {
        Some((digits, power)) => format!("{digits} \\cdot 10^{{{power}}}"),
        None => text,
    };
    if mark == DecimalMark::Comma { text.replace('.', "{,}") } else { text }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::figure::read::parse;

    fn report() -> Report {
        let text =
            "[camera]\nposition = [3, 0, 4]\nnear = 1\nfar = 1e12\n[[points]]\nname = \"P\"\nposition = [0, 0, 0]\n";
        numbers_of(&parse(text).unwrap()).unwrap()
    }

    fn en(text: &str) -> String {
        filled(text, &report(), DecimalMark::Point).unwrap()
    }

    #[test]
    fn numbers_stand_in_place_of_their_paths() {
        assert_eq!(en("D is {distance}, n {basis.n}."), "D is 5, n (0.6, 0, 0.8).");
        assert_eq!(en("$D = {distance}$"), "$D = 5$");
        assert_eq!(en("$\\mathbf{n} = {basis.n}$, {basis.n.0:1}"), "$\\mathbf{n} = (0.6,\\ 0,\\ 0.8)$, 0.6");
        assert_eq!(en("$$M_v = {view_matrix}$$ and {points.0.view}").matches('&').count(), 12);
        assert_eq!(en("far {camera.far}, $B = {camera.far}$"), "far 1e12, $B = 1 \\cdot 10^{12}$");
    }

    #[test]
    fn decimals_are_those_of_the_language() {
        let pt = |text: &str| filled(text, &report(), DecimalMark::Comma).unwrap();
        assert_eq!(pt("n {basis.u} e $n = {basis.n}$"), "n (0,8; 0; −0,6) e $n = (0{,}6;\\ 0;\\ 0{,}8)$");
    }

    #[test]
    fn braces_of_latex_stay() {
        for text in ["$\\frac{distance}{2}$", "$x_{distance}$", "$\\text{dop}$ $\\{a\\}$", "costs \\$5 and \\{x"] {
            assert_eq!(en(text), text);
        }
    }

    #[test]
    fn a_path_to_no_numbers_is_refused() {
        for (text, found) in [("{basis.w}", "basis.w"), ("{points.1.ndc}", "points.1.ndc"), ("a {b", "{b"), ("{}", "")]
        {
            assert_eq!(filled(text, &report(), DecimalMark::Point), Err(found.to_owned()));
        }
        assert!(filled("a matrix {view_matrix}", &report(), DecimalMark::Point).is_err());
        // In a formula too, if it's plainly a path.
        assert!(filled("$a = {basis.w}$", &report(), DecimalMark::Point).is_err());
    }
}
