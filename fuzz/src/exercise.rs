//! A lecturer's exercise, made of the keys that there are with values that fit, nearly fit, or do not: it is refused
//! with a line and a key, or all that it asks can be answered rightly.

use arbitrary::{Arbitrary, Unstructured};
use camera_lab::exercises::{Expected, Free, check, own};

use super::notation::Notation;

#[derive(Arbitrary, Debug)]
struct Input<'a> {
    head: Vec<Head<'a>>,
    camera: Option<[i8; 9]>,
    asks: Vec<Ask<'a>>,
    /// A line of anybody's, put before the asks.
    foreign: Option<&'a str>,
}

#[derive(Arbitrary, Debug)]
enum Head<'a> {
    Title(&'a str),
    Both(&'a str, &'a str),
    Statement(&'a str),
    Operation(u8, i8),
    Pixels(i16, i16),
}

#[derive(Arbitrary, Debug)]
struct Ask<'a> {
    asked: Asked,
    text: &'a str,
    tolerance: Option<i8>,
    unit: Option<u8>,
    mistake: Option<(i16, &'a str)>,
}

#[derive(Arbitrary, Debug)]
enum Asked {
    Quantity(u8),
    Number(i32),
    Vector(Vec<i16>),
    Matrix(Vec<Vec<i16>>),
    Expression(u8, i8),
    Choice(u8, u8),
}

const QUANTITIES: [&str; 10] = [
    "basis.u",
    "basis.n",
    "dop",
    "distance",
    "window.width",
    "view_matrix",
    "projection_matrix",
    "points.0.ndc",
    "points.0.pixel",
    "camera.view_angle",
];
const OPERATIONS: [&str; 8] = ["elevation", "azimuth", "roll", "yaw", "pitch", "zoom", "dolly", "pan"];
const UNITS: [&str; 5] = ["none", "scene", "degrees", "pixels", "furlongs"];
const FUNCTIONS: [&str; 5] = ["sqrt", "sin", "atan", "abs", "log"];

/// A text as TOML writes it.
fn quoted(text: &str) -> String {
    let escaped: String = text.chars().take(200).map(|c| format!("\\U{:08X}", c as u32)).collect();
    format!("\"{escaped}\"")
}

fn pick<'a>(from: &[&'a str], index: u8) -> &'a str {
    from[usize::from(index) % from.len()]
}

fn toml(input: &Input) -> String {
    let mut text =
        String::from("id = \"mine\"\ntitle = \"Mine\"\nstatement = \"Say it.\"\npoints = [[0.5, 0.25, -1]]\n");
    let mut operations = Vec::new();
    for head in input.head.iter().take(6) {
        match head {
            Head::Title(title) => text = text.replacen("\"Mine\"", &quoted(title), 1),
            Head::Both(en, pt) => {
                text = text.replacen("\"Mine\"", &format!("{{ en = {}, pt-BR = {} }}", quoted(en), quoted(pt)), 1);
            }
            Head::Statement(statement) => text = text.replacen("\"Say it.\"", &quoted(statement), 1),
            Head::Operation(name, by) => operations.push(format!("\"{}={by}\"", pick(&OPERATIONS, *name))),
            Head::Pixels(i, j) => text.push_str(&format!("pixels = [[{i}, {j}]]\n")),
        }
    }
    text.push_str(&format!("ops = [{}]\n", operations.join(", ")));
    if let Some([a, b, c, d, e, f, near, far, angle]) = input.camera {
        let angle = f64::from(angle) + 0.5;
        text.push_str(&format!(
            "[figure.camera]\nposition = [{a}, {b}, {c}]\nfocal_point = [{d}, {e}, {f}]\nnear = {near}\nfar = {far}\nview_angle = {angle}\n"
        ));
    }
    if let Some(line) = input.foreign {
        text.push_str(line);
        text.push('\n');
    }
    for (index, ask) in input.asks.iter().enumerate().take(30) {
        text.push_str(&format!("[[ask]]\nname = \"a{index}\"\ntext = {}\n", quoted(ask.text)));
        match &ask.asked {
            Asked::Quantity(index) => text.push_str(&format!("quantity = \"{}\"\n", pick(&QUANTITIES, *index))),
            Asked::Number(number) => text.push_str(&format!("answer = {number}\n")),
            Asked::Vector(numbers) => text.push_str(&format!("answer = {numbers:?}\n")),
            Asked::Matrix(rows) => text.push_str(&format!("answer = {rows:?}\n")),
            Asked::Expression(function, of) => {
                text.push_str(&format!("answer = \"{}({of})/7\"\n", pick(&FUNCTIONS, *function)));
            }
            Asked::Choice(count, right) => {
                let choices: Vec<String> = (0..count % 8).map(|k| format!("\"choice {k}\"")).collect();
                text.push_str(&format!("choices = [{}]\nanswer = \"choice {right}\"\n", choices.join(", ")));
            }
        }
        if let Some(tolerance) = ask.tolerance {
            text.push_str(&format!("tolerance = {}\n", f64::from(tolerance) / 16.0));
        }
        if let Some(unit) = ask.unit {
            text.push_str(&format!("unit = \"{}\"\n", pick(&UNITS, unit)));
        }
        if let Some((answer, said)) = ask.mistake {
            text.push_str(&format!("[[ask.mistake]]\nanswer = {answer}\nmessage = {}\n", quoted(said)));
        }
    }
    text
}

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let Ok(input) = Input::arbitrary_take_rest(Unstructured::new(bytes)) else { return };
    let text = toml(&input);
    let entry = match own::parse(&text) {
        Ok(entry) => entry,
        Err(error) => {
            assert!(error.line >= 1 && error.line <= text.lines().count().max(1), "{error}");
            return;
        }
    };
    let exercise = entry.exercise(0, &Free::new());
    for ask in &exercise.asks {
        let right = match ask.expected() {
            Expected::Choice(right, ..) => (right + 1).to_string(),
            expected => {
                Notation::Brackets.exact(&ask.kind, &expected.table().expect("a good exercise has right answers"))
            }
        };
        let judged = check(&entry, &exercise, ask, &right).expect("it can be read");
        assert!(judged.right, "{}: {right}", ask.name);
    }
}
