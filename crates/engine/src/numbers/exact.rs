//! Numbers that are a fraction or a root, to the last digit: 2/3, 1/√3, 3√38/19.

/// p √b / q in lowest terms, or p / √b.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExactForm {
    /// p. Carries the sign.
    pub numerator: i64,
    /// b, free of squares. 1 if there is no root.
    pub root: i64,
    /// q
    pub denominator: i64,
    /// The root is in the denominator: p / √b, with q = 1.
    pub root_below: bool,
}

/// Greater numerators and denominators are harder to read than decimals.
const MOST: i64 = 999;

/// The form of a number that is a fraction or the root of one to the last digits of an `f64`. `None` for all others,
/// and for numbers that read as well without one: whole numbers, and decimals of three digits at most.
pub fn exact_form(value: f64) -> Option<ExactForm> {
    let size = value.abs();
    if !(1e-4..1e4).contains(&size) || (value * 1000.0).round() / 1000.0 == value {
        return None;
    }
    let sign = if value < 0.0 { -1 } else { 1 };
    if let Some((p, q)) = ratio(size) {
        return (p <= MOST && q <= MOST).then_some(ExactForm {
            numerator: sign * p,
            root: 1,
            denominator: q,
            root_below: false,
        });
    }
    let (p, q) = ratio(size * size)?;
    // √(p/q) = √(p q)/q
    let (above, below) = (without_squares(p), without_squares(q));
    if below.0 == 1 && above.1 == 1 && below.1 > 1 {
        return (above.0 <= MOST).then_some(ExactForm {
            numerator: sign * above.0,
            root: below.1,
            denominator: 1,
            root_below: true,
        });
    }
    let (square, root) = without_squares(p.checked_mul(q)?);
    let common = gcd(square, q);
    let form = ExactForm { numerator: sign * (square / common), root, denominator: q / common, root_below: false };
    (square / common <= MOST && root <= MOST && q / common <= MOST).then_some(form)
}

/// p/q in lowest terms, if that's the number but for the rounding of a few operations. By continued fractions.
fn ratio(value: f64) -> Option<(i64, i64)> {
    const LARGEST: f64 = 20_000.0;
    let (mut rest, mut before, mut now) = (value, (0.0_f64, 1.0_f64), (1.0_f64, 0.0_f64));
    for _ in 0..20 {
        let whole = rest.floor();
        let next = (whole * now.0 + before.0, whole * now.1 + before.1);
        if next.0 > LARGEST * LARGEST.max(value) || next.1 > LARGEST {
            return None;
        }
        (before, now) = (now, next);
        if (now.0 / now.1 - value).abs() <= 4.0 * f64::EPSILON * value {
            #[expect(clippy::cast_possible_truncation, reason = "whole numbers below 4e8")]
            return Some((now.0 as i64, now.1 as i64));
        }
        rest = 1.0 / (rest - whole);
    }
    None
}

/// s and b with n = s² b, b free of squares.
fn without_squares(n: i64) -> (i64, i64) {
    let (mut square, mut rest, mut factor) = (1, n, 2);
    while factor * factor <= rest {
        while rest % (factor * factor) == 0 {
            rest /= factor * factor;
            square *= factor;
        }
        factor += 1;
    }
    (square, rest)
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

impl ExactForm {
    /// As text: `−3√38/19`, `1/√3`.
    pub fn text(self) -> String {
        self.written("−", |n| format!("√{n}"), |above, below| format!("{above}/{below}"))
    }

    /// The LaTeX form: `-\frac{3\sqrt{38}}{19}`.
    pub fn latex(self) -> String {
        self.written("-", |n| format!(r"\sqrt{{{n}}}"), |above, below| format!(r"\frac{{{above}}}{{{below}}}"))
    }

    fn written(self, minus: &str, root: impl Fn(i64) -> String, over: impl Fn(&str, &str) -> String) -> String {
        let sign = if self.numerator < 0 { minus } else { "" };
        let size = self.numerator.abs();
        let number = match (size, self.root) {
            _ if self.root_below => over(&size.to_string(), &root(self.root)),
            (_, 1) => size.to_string(),
            (1, under) => root(under),
            (_, under) => format!("{size}{}", root(under)),
        };
        match self.denominator {
            1 => format!("{sign}{number}"),
            below => format!("{sign}{}", over(&number, &below.to_string())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_and_roots_are_recognised() {
        for (value, text) in [
            (2.0 / 3.0, "2/3"),
            (-5.0 / 3.0, "−5/3"),
            (1.0 / 3f64.sqrt(), "1/√3"),
            (-2.0 / 5f64.sqrt(), "−2/√5"),
            (3.0 * 38f64.sqrt() / 19.0, "3√38/19"),
            (2f64.sqrt(), "√2"),
            (-2.0 * 3f64.sqrt(), "−2√3"),
            (1.0 / 2f64.sqrt(), "1/√2"),
            (5.0 * 2f64.sqrt() / 7.0, "5√2/7"),
            (100.0 / 99.9, "1000/999"),
            (1001.0 / 999.0, "1001/999"),
        ] {
            let said = exact_form(value).map(ExactForm::text).unwrap_or_default();
            let expected = if text.starts_with("100") { "" } else { text };
            assert_eq!(said, expected, "{value}");
        }
    }

    #[test]
    fn other_numbers_stay_decimals() {
        for value in [
            0.0,
            1.0,
            -2.5,
            0.125,
            std::f64::consts::PI,
            std::f64::consts::E,
            0.1234567,
            1e300,
            1e-7,
            f64::NAN,
            f64::INFINITY,
        ] {
            assert_eq!(exact_form(value), None, "{value}");
        }
    }

    #[test]
    fn a_form_has_the_value_that_it_stands_for() {
        for p in 1..40_i32 {
            for q in 1..40_i32 {
                let value = (f64::from(p) / f64::from(q)).sqrt();
                let Some(form) = exact_form(value) else { continue };
                let [numerator, root, denominator] = [form.numerator, form.root, form.denominator].map(|n| n as f64);
                let again =
                    if form.root_below { numerator / root.sqrt() } else { numerator * root.sqrt() / denominator };
                assert!((again - value).abs() <= 4.0 * f64::EPSILON * value, "{p}/{q}: {form:?}");
            }
        }
    }
}
