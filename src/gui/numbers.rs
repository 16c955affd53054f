//! Numbers as text.

/// More digits than these are exact: the shortest text that reads back as the same `f64`.
pub const EXACT_DIGITS: usize = 17;

/// `value` with so many significant digits; from [`EXACT_DIGITS`] on, the shortest text that reads back as the same `f64`.
#[must_use]
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

/// Drops zeros that say nothing.
fn trim(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// `value` in at most `room` characters: exactly where that fits, otherwise cut off, with `…` to say so.
#[must_use]
pub fn short(value: f64, room: usize) -> String {
    let exact = significant(value, EXACT_DIGITS);
    if exact.chars().count() <= room {
        return exact;
    }
    let (mantissa, exponent) = match exact.split_once('e') {
        Some((mantissa, exponent)) => (mantissa, format!("e{exponent}")),
        None => (exact.as_str(), String::new()),
    };
    let keep = room.saturating_sub(1 + exponent.len());
    let point = mantissa.find('.').unwrap_or(mantissa.len());
    if exponent.is_empty() && point > keep {
        let scientific = format!("{value:e}");
        return short_scientific(&scientific, room);
    }
    let cut: String = mantissa.chars().take(keep.max(1)).collect();
    format!("{cut}…{exponent}")
}

fn short_scientific(text: &str, room: usize) -> String {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let keep = room.saturating_sub(2 + exponent.len()).max(1);
    if mantissa.len() <= keep {
        return format!("{mantissa}e{exponent}");
    }
    let cut: String = mantissa.chars().take(keep).collect();
    format!("{cut}…e{exponent}")
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
    fn all_digits_read_back_exactly() {
        for value in [1.0 / 3.0, 1e22, 5e-324, 123_456_789.123_456_78, -2.5e-6, f64::MAX] {
            assert_eq!(significant(value, EXACT_DIGITS).parse(), Ok(value));
        }
    }

    #[test]
    fn short_numbers_fit_and_say_when_they_are_cut() {
        for (value, room, text) in [
            (0.5, 7, "0.5"),
            (-12.25, 7, "-12.25"),
            (std::f64::consts::FRAC_1_SQRT_2, 7, "0.7071…"),
            (1.234_567_89e-9, 9, "1.234…e-9"),
            (123_456_789.5, 7, "1.23…e8"),
            (1e100, 7, "1e100"),
        ] {
            assert_eq!(short(value, room), text);
            assert!(short(value, room).chars().count() <= room);
        }
    }
}
