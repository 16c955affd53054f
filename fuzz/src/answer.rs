//! Answers to every exercise, by grammar, so that nearly all of them are judged. A right answer is right in every
//! notation. Each judged answer has as many verdicts as numbers, and a score between 0 and 1.

use arbitrary::{Arbitrary, Unstructured};
use camera_lab::exercises::{Answer, Expected, Free, Kind, check, entries};
use camera_lab_words::Lang;
use camera_lab_words::learn::exercises as texts;

use super::notation::Notation;

#[derive(Arbitrary, Debug)]
struct Input {
    entry: u8,
    seed: u16,
    ask: u8,
    notation: Notation,
    answer: Given,
}

#[derive(Arbitrary, Debug)]
enum Given {
    Right,
    /// The right one, with one number changed.
    Nearly(u8, Term),
    /// As many numbers as are asked for.
    Terms(Vec<Term>),
    /// Of any shape.
    Shape(u8, Vec<Term>),
    Choice(u8),
    Camera(Vec<(u8, Term)>),
    /// Anything at all.
    Text(String),
}

#[derive(Arbitrary, Debug)]
enum Term {
    Whole(i8),
    Decimal(i16, bool),
    Fraction(i8, i8),
    Root(u8),
    Sine(i16),
    Named(u8),
    Sum(Box<Self>, Box<Self>),
    Product(Box<Self>, Box<Self>),
    Minus(Box<Self>),
    Unknown,
}

const NAMES: [&str; 7] = ["F", "B", "D", "M", "pi", "theta", "x"];
const KEYS: [&str; 8] = ["position", "focal_point", "view_up", "view_angle", "near", "far", "projection", "height"];

impl Term {
    fn text(&self, comma: bool) -> String {
        match self {
            Self::Whole(n) => n.to_string(),
            Self::Decimal(n, _) if !comma => format!("{}", f64::from(*n) / 256.0),
            Self::Decimal(n, comma) => {
                let point = format!("{}", f64::from(*n) / 256.0);
                if *comma { point.replace('.', ",") } else { point }
            }
            Self::Fraction(a, b) => format!("{a}/{b}"),
            Self::Root(n) => format!("sqrt({n})"),
            Self::Sine(degrees) => format!("sin({degrees}°)"),
            Self::Named(index) => NAMES[usize::from(*index) % NAMES.len()].to_owned(),
            Self::Sum(a, b) => format!("({} + {})", a.text(comma), b.text(comma)),
            Self::Product(a, b) => format!("{} * {}", a.text(comma), b.text(comma)),
            Self::Minus(a) => format!("−({})", a.text(comma)),
            Self::Unknown => "?".to_owned(),
        }
    }
}

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let Ok(input) = Input::arbitrary_take_rest(Unstructured::new(bytes)) else { return };
    let all: Vec<_> = entries().collect();
    let entry = all[usize::from(input.entry) % all.len()];
    let exercise = entry.exercise(u64::from(input.seed), &Free::new());
    let ask = &exercise.asks[usize::from(input.ask) % exercise.asks.len()];
    let table = ask.expected().table();
    let comma = matches!(input.notation, Notation::Semicolons);
    let as_text = |terms: &[Term]| -> Vec<String> { terms.iter().map(|term| term.text(comma)).collect() };
    let mut must_be_right = false;
    let text = match (&input.answer, &table) {
        (Given::Right, Some(table)) => {
            must_be_right = true;
            input.notation.exact(&ask.kind, table)
        }
        (Given::Nearly(at, term), Some(table)) if !table.entries.is_empty() => {
            let mut cells: Vec<String> = table.entries.iter().map(|entry| format!("{entry:e}")).collect();
            let at = usize::from(*at) % cells.len();
            cells[at] = term.text(comma);
            input.notation.table(&ask.kind, table.rows, &cells)
        }
        (Given::Terms(terms), Some(table)) if !terms.is_empty() => {
            let cells: Vec<String> = as_text(terms).into_iter().cycle().take(table.entries.len()).collect();
            input.notation.table(&ask.kind, table.rows, &cells)
        }
        (Given::Shape(rows, terms), _) => {
            let rows = usize::from(*rows % 6);
            input.notation.table(&Kind::Matrix(rows, 1), rows, &as_text(terms))
        }
        (Given::Camera(pairs), _) => {
            let pair = |(key, term): &(u8, Term)| {
                let (key, term) = (KEYS[usize::from(*key) % KEYS.len()], term.text(false));
                match key {
                    "position" | "focal_point" | "view_up" => format!("{key}=[{term}, 1, {term}]"),
                    "projection" => format!("{key}=\"parallel\""),
                    _ => format!("{key}={term}"),
                }
            };
            pairs.iter().take(8).map(pair).collect::<Vec<_>>().join("; ")
        }
        (Given::Choice(choice), _) | (Given::Nearly(choice, _), _) => choice.to_string(),
        (Given::Text(text), _) => text.clone(),
        (Given::Right | Given::Terms(_), _) => match ask.expected() {
            Expected::Choice(right, ..) => {
                must_be_right = true;
                (right + 1).to_string()
            }
            _ => return,
        },
    };
    let judged = match check(entry, &exercise, ask, &text) {
        Ok(judged) => judged,
        Err(error) => {
            assert!(!must_be_right, "{} {}: {text:?}: {error}", exercise.id, ask.name);
            return;
        }
    };
    assert!(!must_be_right || judged.right, "{} seed {} {}: {text:?}", exercise.id, exercise.seed, ask.name);
    assert!((0.0..=1.0).contains(&judged.score));
    assert_eq!(judged.right, judged.entries.iter().flatten().all(|right| *right));
    if let (Answer::Numbers { rows, columns, .. }, Some(table)) = (&judged.understood, &table)
        && table.shape() == [*rows, *columns]
    {
        assert_eq!(judged.entries.iter().flatten().count(), rows * columns);
    }
    assert!(judged.diagnosis.is_none() || !judged.right);
    for lang in [Lang::En, Lang::PtBr] {
        assert!(texts::diagnosis(lang, ask, &judged).is_none_or(|text| !text.is_empty()));
    }
}
