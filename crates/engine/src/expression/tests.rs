use super::{ExpressionProblem as E, *};

fn number(text: &str) -> Result<f64, E> {
    evaluate(text, Dimension::Number).map_err(|error| error.problem)
}

fn angle(text: &str) -> Result<f64, E> {
    evaluate(text, Dimension::Angle).map_err(|error| error.problem)
}

#[test]
fn what_people_type_is_understood() {
    for (text, value) in [
        ("7", 7.0),
        (" 12,5 ", 12.5),
        (".5", 0.5),
        ("5.", 5.0),
        ("−3", -3.0),
        ("--3", 3.0),
        ("2e3", 2000.0),
        ("1E-2", 0.01),
        ("1/3", 1.0 / 3.0),
        ("1/2/2", 0.25),
        ("2-3-4", -5.0),
        ("sqrt(2)/2", std::f64::consts::SQRT_2 / 2.0),
        ("2√2", 2.0 * std::f64::consts::SQRT_2),
        ("pi/3", std::f64::consts::PI / 3.0),
        ("2pi", std::f64::consts::TAU),
        ("-2^2", -4.0),
        ("2^3^2", 512.0),
        ("2^-1", 0.5),
        ("(1+2)(3+4)", 21.0),
        ("cos(60°)", 0.5),
        ("90°/45°", 2.0),
        ("1,25×2", 2.5),
        ("tan(45°)", 1.0),
        ("tan 45°", 1.0),
        ("2 tan 45°/2", 1.0),
        ("tan 45 deg", 1.0),
        ("cot(45 graus)", 1.0),
        ("2 sqrt 4/2", 2.0),
        ("36,5%", 0.365),
        (r"\frac{1}{4}", 0.25),
        (r"-\frac{\sqrt{4}}{2^{3}}\cdot 2", -0.5),
        (r"\cos{60^\circ}", 0.5),
        (r"2\pi", std::f64::consts::TAU),
    ] {
        let found = number(text).unwrap_or(f64::NAN);
        assert!((found - value).abs() <= 4.0 * f64::EPSILON * value.abs(), "{text}: {found}, not {value}");
    }
}

#[test]
fn angles_come_out_in_degrees() {
    for (text, degrees) in [
        ("45°", 45.0),
        ("45", 45.0),
        ("pi/3", 60.0),
        ("π", 180.0),
        ("pi/3 rad", 60.0),
        ("-30°", -30.0),
        ("90°/2", 45.0),
        ("2·22,5°", 45.0),
    ] {
        assert_eq!(angle(text), Ok(degrees), "{text}");
    }
    assert!((angle("1 rad").unwrap_or(0.0) - 57.295_779_513_082_32).abs() < 1e-13);
    assert!((angle("2 atan(0,5)").unwrap_or(0.0) - 53.130_102_354_155_98).abs() < 1e-13);
}

#[test]
fn nonsense_is_named() {
    for (text, error) in [
        ("", E::Empty),
        (" ", E::Empty),
        ("1 +", E::Unfinished),
        ("(1 + 2", E::MissingParenthesis),
        ("1)", E::Unexpected(')')),
        ("1.000,5", E::Unexpected(',')),
        ("1 2", E::Unexpected('2')),
        ("1;2", E::Unexpected(';')),
        ("abc", E::UnknownName("abc".into())),
        ("nan", E::UnknownName("nan".into())),
        ("2e", E::UnknownName("e".into())),
        ("1/0", E::NotFinite),
        ("1e400", E::NotFinite),
        ("sqrt(-1)", E::NotFinite),
        ("45°", E::MixedUnits),
        ("1 + 45°", E::MixedUnits),
        (".", E::Unfinished),
        ("sin 3", E::NoUnit("3".into())),
        ("8 tan 40/2", E::NoUnit("40".into())),
    ] {
        assert_eq!(number(text), Err(error), "{text:?}");
    }
}

#[test]
fn faults_say_where_they_are() {
    for (text, dimension, at) in [
        ("2*atn(1/2)", Dimension::Angle, "atn"),
        ("1 + 45° + 2", Dimension::Number, "1 + 45°"),
        ("(2 · 45°²)", Dimension::Number, "²"),
        ("√(45°)", Dimension::Number, "(45°)"),
        (" 1/0 ", Dimension::Number, "1/0"),
        ("3 $ 4", Dimension::Number, "$"),
        ("2 − x", Dimension::Number, "x"),
        ("(1 + 2", Dimension::Number, ""),
        ("1 +", Dimension::Number, ""),
    ] {
        let error = evaluate(text, dimension).expect_err(text);
        assert_eq!(&text[error.span.clone()], at, "{text}");
        assert!(!at.is_empty() || error.span.start == text.len(), "{text}");
    }
}

#[test]
fn a_fault_is_marked_on_one_line() {
    for (text, span, shown) in
        [("2*atn(1/2)", 2..5, "2*▸atn◂(1/2)"), ("(1 + 2", 6..6, "(1 + 2▸◂"), ("", 0..0, "▸◂"), ("1\n°", 2..4, "1 ▸°◂")]
    {
        assert_eq!(marked(text, &span), shown);
    }
    let long = marked(&"1+".repeat(200), &(300..301));
    assert!(long.chars().count() < 50 && long.starts_with("…") && long.contains("▸1◂") && long.ends_with("…"));
}

#[test]
fn lists_are_cut_at_commas_or_at_semicolons() {
    for (text, expected) in [
        ("1,2,3", &["1", "2", "3"][..]),
        ("sqrt(2)/2,0,0", &["sqrt(2)/2", "0", "0"]),
        ("max(1,2),(3", &["max(1,2)", "(3"]),
        ("0,5;1;", &["0,5", "1", ""]),
        ("", &[""]),
    ] {
        assert_eq!(parts(text).collect::<Vec<_>>(), expected, "{text}");
    }
}

#[test]
fn depth_and_length_are_bounded() {
    for text in ["(".repeat(400), "√".repeat(400), "1".repeat(2000), "2^".repeat(200), "sqrt(".repeat(90)] {
        assert_eq!(number(&text), Err(E::TooLong), "{text}");
    }
    assert_eq!(number(&"-".repeat(499)), Err(E::Unfinished));
}
