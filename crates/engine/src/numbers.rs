//! Numbers as people read them: digits, steps that read well, times and counts.

use std::cmp::Ordering;
use std::time::Duration;

mod exact;
pub mod random;

pub use exact::{ExactForm, exact_form};

/// More digits than these are exact: the shortest text that reads back as the same `f64`.
pub const EXACT_DIGITS: usize = 17;

/// `value` with this many significant digits; from [`EXACT_DIGITS`] on, the shortest text that reads back as the same
/// `f64`.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return value.to_string();
    }
    let scientific =
        if digits >= EXACT_DIGITS { format!("{value:e}") } else { format!("{:.*e}", digits.max(1) - 1, value) };
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if !(-5..=9).contains(&exponent) {
        return format!("{}e{exponent}", trim(mantissa));
    }
    if digits >= EXACT_DIGITS {
        return value.to_string();
    }
    // The digits of the mantissa, not `value` rounded again, so that the rounding is that of the scientific form.
    let rounded: f64 = scientific.parse().unwrap_or(value);
    let decimals = usize::try_from(i32::try_from(digits).unwrap_or(17) - 1 - exponent).unwrap_or(0);
    trim(&format!("{rounded:.decimals$}")).to_owned()
}

/// The way in which a language writes numbers: its decimal mark, and the list separator that follows from it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DecimalMark {
    /// `0.5`
    #[default]
    Point,
    /// `0,5`
    Comma,
}

impl DecimalMark {
    /// The mark of a language by its tag: a point in English, Chinese, Japanese, Korean, Hebrew and Thai, a comma in
    /// the others.
    pub fn of_language(tag: &str) -> Self {
        let primary = tag.split('-').next().unwrap_or_default();
        if ["en", "zh", "ja", "ko", "he", "th"].contains(&primary) { Self::Point } else { Self::Comma }
    }

    /// Like [`significant`], as in print, with this mark and a true minus.
    pub fn number(self, value: f64, digits: usize) -> String {
        self.printed(&significant(value, digits))
    }

    /// A text of other functions of this module, or one that Rust has formatted, as in print.
    pub fn printed(self, number: &str) -> String {
        self.typed(number).replace('-', "−")
    }

    /// The number as you type it, with this mark.
    pub fn typed(self, number: &str) -> String {
        match self {
            Self::Point => number.to_owned(),
            Self::Comma => number.replace('.', ","),
        }
    }

    /// Numbers one after the other. A number that is zero but for the rounding of its neighbours is 0, unless all
    /// digits are requested.
    pub fn list(self, values: &[f64], digits: usize) -> String {
        let numbers = without_rests(values, digits).into_iter().map(|v| self.number(v, digits));
        numbers.collect::<Vec<_>>().join(self.separator())
    }

    /// The separator between the numbers of a list.
    pub const fn separator(self) -> &'static str {
        match self {
            Self::Point => ", ",
            Self::Comma => "; ",
        }
    }

    /// A point or a vector, such as `(1, 2.5, 3)` or `(1; 2,5; 3)`, like [`list`](Self::list).
    pub fn tuple(self, values: &[f64], digits: usize) -> String {
        format!("({})", self.list(values, digits))
    }

    /// `value` in full if that `fits`, else rounded to as many digits as fit, which are no more than a reader needs.
    /// It's as short as can be if nothing fits.
    pub fn fitted(self, value: f64, fits: impl Fn(&str) -> bool) -> String {
        let exact = self.number(value, EXACT_DIGITS);
        if fits(&exact) {
            return exact;
        }
        let scientific = |digits: usize| {
            let text = format!("{:.*e}", digits - 1, value);
            let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            self.printed(&format!("{}e{exponent}", trim(mantissa)))
        };
        let rounded = (1..=7).rev().map(|digits| self.number(value, digits));
        let mut shorter = rounded.chain((1..=7).rev().map(scientific));
        shorter.find(|text| fits(text)).unwrap_or_else(|| scientific(1))
    }
}

/// The values, with 0 for those that can be a rounding error next to the greatest of them. Unchanged with
/// [`EXACT_DIGITS`].
pub fn without_rests(values: &[f64], digits: usize) -> Vec<f64> {
    let greatest = values.iter().fold(0.0_f64, |greatest, v| greatest.max(v.abs()));
    values.iter().map(|v| if digits < EXACT_DIGITS && is_rest(*v, greatest) { 0.0 } else { *v }).collect()
}

/// True if a value can be zero but for a few roundings of numbers as large as `greatest`.
pub fn is_rest(value: f64, greatest: f64) -> bool {
    value.abs() <= 4.0 * f64::EPSILON * greatest
}

/// `p/q` for a value that equals it to the last digit, with small p and q. `None` for whole numbers too.
pub fn fraction(value: f64) -> Option<String> {
    (2..=32).find_map(|q| {
        let p = (value * f64::from(q)).round();
        (p != 0.0 && p.abs() < 100.0 && value != value.round() && p / f64::from(q) == value).then(|| format!("{p}/{q}"))
    })
}

/// The shortest text with a point or an exponent that reads back as the same `f64`, as programs write it: `2.0`,
/// `1e300`.
pub fn exact(value: f64) -> String {
    format!("{value:?}")
}

/// A time in three digits.
pub fn duration(time: Duration) -> String {
    let micros = time.as_secs_f64() * 1e6;
    match micros {
        m if m < 9.95 => format!("{m:.1} µs"),
        m if m < 999.5 => format!("{m:.0} µs"),
        m if m < 9_995.0 => format!("{:.2} ms", m / 1e3),
        m if m < 99_950.0 => format!("{:.1} ms", m / 1e3),
        m if m < 999_500.0 => format!("{:.0} ms", m / 1e3),
        m => format!("{:.2} s", m / 1e6),
    }
}

/// A count in five characters at most, up to a billion.
pub fn count(n: usize) -> String {
    match n {
        0..10_000 => n.to_string(),
        10_000..99_950 => format!("{:.1}k", n as f64 / 1e3),
        99_950..999_500 => format!("{:.0}k", n as f64 / 1e3),
        999_500..9_995_000 => format!("{:.2}M", n as f64 / 1e6),
        9_995_000..99_950_000 => format!("{:.1}M", n as f64 / 1e6),
        _ => format!("{:.0}M", n as f64 / 1e6),
    }
}

/// A count with its digits in threes.
pub fn in_threes(n: usize) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push('\u{202f}');
        }
        out.push(digit);
    }
    out
}

/// The multiple of a power of ten, not above `unit`, that is nearest to `value`. Never −0. If `unit` is so small or so
/// large that there is no such power, `value` itself.
pub fn round_to(value: f64, unit: f64) -> f64 {
    let power = unit.abs().log10().floor();
    if !(-300.0..300.0).contains(&power) {
        return value;
    }
    // Dividing by a power of ten that is a whole number rounds once, but multiplying by 0.001 rounds twice.
    let scale = 10f64.powf(power.abs());
    let rounded = if power < 0.0 { (value * scale).round() / scale } else { (value / scale).round() * scale };
    // Adding 0 turns −0 into 0.
    if rounded.is_finite() { rounded + 0.0 } else { value }
}

/// The power of ten at or below `x`. `None` if `x` isn't a positive number that has one.
pub fn power_of_ten(x: f64) -> Option<f64> {
    let power = 10f64.powf(x.log10().floor());
    (power.is_finite() && power > 0.0).then_some(power)
}

/// The greatest of 1, 2 and 5 times a power of ten that is at or below `x`. `None` as for [`power_of_ten`].
pub fn nice_below(x: f64) -> Option<f64> {
    let power = power_of_ten(x)?;
    [5.0, 2.0, 1.0].into_iter().map(|m| m * power).find(|step| *step <= x).or(Some(power))
}

/// The least of 1, 2 and 5 times a power of ten that is at or above `x`. `None` as for [`power_of_ten`].
pub fn nice_above(x: f64) -> Option<f64> {
    let power = power_of_ten(x)?;
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|step| *step >= x && step.is_finite())
}

/// Drops meaningless zeros.
fn trim(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// The order of names that people expect. Numbers in them count as numbers (2 before 10), and capitals don't count.
pub fn natural_order(a: &str, b: &str) -> Ordering {
    let (mut rest_a, mut rest_b) = (a, b);
    while !rest_a.is_empty() && !rest_b.is_empty() {
        let (piece_a, piece_b) = (piece(rest_a), piece(rest_b));
        (rest_a, rest_b) = (&rest_a[piece_a.len()..], &rest_b[piece_b.len()..]);
        let order =
            if piece_a.starts_with(|c: char| c.is_ascii_digit()) && piece_b.starts_with(|c: char| c.is_ascii_digit()) {
                let (digits_a, digits_b) = (piece_a.trim_start_matches('0'), piece_b.trim_start_matches('0'));
                digits_a.len().cmp(&digits_b.len()).then_with(|| digits_a.cmp(digits_b))
            } else {
                piece_a.to_lowercase().cmp(&piece_b.to_lowercase())
            };
        if order.is_ne() {
            return order;
        }
    }
    rest_a.len().cmp(&rest_b.len()).then_with(|| a.cmp(b))
}

/// The first piece of a text: digits, or the characters before the next ones.
fn piece(text: &str) -> &str {
    let digits = text.starts_with(|c: char| c.is_ascii_digit());
    &text[..text.find(|c: char| c.is_ascii_digit() != digits).unwrap_or(text.len())]
}

/// The greatest singular value of a matrix, and its right singular vector, of length 1.
pub fn greatest_singular<const N: usize>(rows: &[[f64; N]]) -> (f64, [f64; N]) {
    // Powers of JᵀJ: those of its greatest eigenvalue outgrow the others. 2¹² steps of the power method at once.
    let each = |f: &dyn Fn(usize, usize) -> f64| -> [[f64; N]; N] {
        std::array::from_fn(|i| std::array::from_fn(|j| f(i, j)))
    };
    let most = rows.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs())).max(f64::MIN_POSITIVE);
    let mut power = each(&|i, j| rows.iter().map(|row| row[i] / most * (row[j] / most)).sum());
    for _ in 0..12 {
        let trace: f64 = (0..N).map(|k| power[k][k]).sum::<f64>().max(f64::MIN_POSITIVE);
        let before = power.map(|row| row.map(|x| x / trace));
        power = each(&|i, j| (0..N).map(|k| before[i][k] * before[k][j]).sum());
    }
    let longest = (0..N).max_by(|&a, &b| power[a][a].total_cmp(&power[b][b])).unwrap_or(0);
    let length = power[longest].into_iter().fold(0.0, f64::hypot);
    let direction = power[longest].map(|x| if length > 0.0 { x / length } else { 0.0 });
    let number = rows.iter().map(|row| row.iter().zip(direction).map(|(a, b)| a * b).sum()).fold(0.0, f64::hypot);
    (number, direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_digits_are_kept_and_empty_zeros_dropped() {
        for (value, digits, text) in [
            (0.0, 6, "0"),
            (-0.0, 6, "0"),
            (1.0, 6, "1"),
            (std::f64::consts::PI, 3, "3.14"),
            (-std::f64::consts::PI, 6, "-3.14159"),
            (1234.5678, 6, "1234.57"),
            (1234.5678, 2, "1200"),
            (0.000_012_345, 3, "0.0000123"),
            (1e-7, 6, "1e-7"),
            (1.5e300, 6, "1.5e300"),
            (9.999_999, 3, "10"),
            (0.1 + 0.2, 6, "0.3"),
            (0.1 + 0.2, 17, "0.30000000000000004"),
            (f64::MAX, 17, "1.7976931348623157e308"),
        ] {
            assert_eq!(significant(value, digits), text);
        }
    }

    #[test]
    fn times_and_counts_are_short() {
        assert_eq!([0, 9_999, 12_345, 512_000, 1_234_567].map(count), ["0", "9999", "12.3k", "512k", "1.23M"]);
        assert_eq!(
            [99_949, 99_950, 999_499, 999_500, 123_456_789].map(count),
            ["99.9k", "100k", "999k", "1.00M", "123M"]
        );
        assert_eq!(in_threes(1_234_567), "1\u{202f}234\u{202f}567");
        assert_eq!(in_threes(12), "12");
        let times = [1.24e-6, 34e-6, 1.234e-3, 45.67e-3, 0.4567, 2.0];
        let said = times.map(|s| duration(Duration::from_secs_f64(s)));
        assert_eq!(said, ["1.2 µs", "34 µs", "1.23 ms", "45.7 ms", "457 ms", "2.00 s"]);
    }

    #[test]
    fn values_are_rounded_to_what_reads_well() {
        for (value, unit, rounded) in [
            (0.123, 0.1, 0.1),
            (-0.04, 0.1, 0.0),
            (12.0, 0.1, 12.0),
            (1234.0, 20.0, 1230.0),
            (-77.0, 20.0, -80.0),
            (1.234_567, 0.02, 1.23),
            (1234.5, 30.0, 1230.0),
            (1.5, 0.0, 1.5),
            (0.3 + 1e-17, 1e-3, 0.3),
            (1.5, f64::NAN, 1.5),
            (1e300, 1e-20, 1e300),
        ] {
            assert_eq!(round_to(value, unit), rounded, "{value} to {unit}");
        }
        assert!(round_to(-0.04, 0.1).is_sign_positive());
    }

    #[test]
    fn nice_steps_are_one_two_and_five() {
        for (x, below, above) in [
            (1.0, 1.0, 1.0),
            (1.5, 1.0, 2.0),
            (3.0, 2.0, 5.0),
            (7.0, 5.0, 10.0),
            (0.034, 0.02, 0.05),
            (450.0, 200.0, 500.0),
        ] {
            assert_eq!((nice_below(x), nice_above(x)), (Some(below), Some(above)), "{x}");
        }
        for x in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!((power_of_ten(x), nice_below(x), nice_above(x)), (None, None, None), "{x}");
        }
        assert_eq!(power_of_ten(250.0), Some(100.0));
    }

    #[test]
    fn printed_and_exact_numbers() {
        let printed = [0.0, -0.5, 2.0 / 3.0, 1234.6, 1e-7, 9.999_96].map(|v| DecimalMark::Point.number(v, 4));
        assert_eq!(printed, ["0", "−0.5", "0.6667", "1235", "1e−7", "10"]);
        assert_eq!([2.0, -0.0, 1e300, 0.1].map(exact), ["2.0", "-0.0", "1e300", "0.1"]);
    }

    #[test]
    fn all_digits_read_back_exactly() {
        for value in [1.0 / 3.0, 1e22, 5e-324, 123_456_789.123_456_78, -2.5e-6, f64::MAX] {
            assert_eq!(significant(value, EXACT_DIGITS).parse(), Ok(value));
        }
    }

    #[test]
    fn numbers_are_rounded_to_what_fits_and_never_cut() {
        for (value, room, text) in [
            (0.5, 7, "0.5"),
            (-12.25, 7, "−12.25"),
            (std::f64::consts::FRAC_1_SQRT_2, 7, "0.70711"),
            (4.0 / 3.0, 5, "1.333"),
            (-6.154_600_01, 5, "−6.15"),
            (1.234_567_89e-9, 9, "1.2346e−9"),
            (123_456_789.5, 7, "1.235e8"),
            (1e100, 7, "1e100"),
            (53.130_102_354_155_98, 30, "53.13010235415598"),
            (53.130_102_354_155_98, 12, "53.1301"),
            (-1.25e-300, 3, "−1e−300"),
        ] {
            let fitted = DecimalMark::Point.fitted(value, |text| text.chars().count() <= room);
            assert_eq!(fitted, text, "{value} in {room}");
        }
    }

    #[test]
    fn names_with_numbers_are_in_the_order_of_the_numbers() {
        let sorted = ["Aula 1", "aula 2", "aula 02b", "aula 10", "aula 10.5", "aula x", "z"];
        for (i, a) in sorted.iter().enumerate() {
            for (j, b) in sorted.iter().enumerate() {
                assert_eq!(natural_order(a, b), i.cmp(&j), "{a} {b}");
            }
        }
        assert!(natural_order("007", "7").is_ne());
    }

    #[test]
    fn a_comma_needs_another_separator() {
        let values = [1.5, -2.0, 1e-7];
        assert_eq!(DecimalMark::Point.tuple(&values, 5), "(1.5, −2, 1e−7)");
        assert_eq!(DecimalMark::Comma.tuple(&values, 5), "(1,5; −2; 1e−7)");
        assert_eq!(DecimalMark::Comma.number(-0.25, 5), "−0,25");
    }

    #[test]
    fn a_rest_of_rounding_is_zero_unless_all_digits_are_wanted() {
        let u = [0.857_49, 3.5716e-17, -0.5145];
        assert_eq!(DecimalMark::Point.tuple(&u, 5), "(0.85749, 0, −0.5145)");
        assert_eq!(DecimalMark::Point.tuple(&u, EXACT_DIGITS), "(0.85749, 3.5716e−17, −0.5145)");
        assert_eq!(without_rests(&[1e-30, 2e-30], 5), [1e-30, 2e-30]);
        assert!(!is_rest(1e-15, 1.0) && is_rest(-1.8e-16, 1.0) && is_rest(0.0, 0.0));
    }

    #[test]
    fn small_fractions_are_known_to_the_last_digit() {
        let said = [4.0 / 3.0, 16.0 / 9.0, 0.75, -1.5, 1.333, 2.0, 0.0, 1e300, 0.1].map(fraction);
        let expected = ["4/3", "16/9", "3/4", "-3/2", "", "", "", "", "1/10"];
        assert_eq!(said.map(Option::unwrap_or_default), expected);
    }
}
