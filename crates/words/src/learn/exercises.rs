//! The texts of exercises, in both languages. In the texts `{name}` stands for a fact of the exercise.

use super::exercise_cameras;
use super::exercise_texts::{Statement, texts};
use crate::exercises::{
    Answer, AnswerError, Ask, Cause, Diagnosis, Entry, Exercise, FAULT, Fact, Fault, Judged, Kind, Mistake, OwnTexts,
    Table, Unit, Worked,
};
use crate::explain::{Line, Notation, Style};
use crate::expression::marked;
use crate::numbers::{DecimalMark, exact_form};
use crate::sanitize::escaped;
use crate::why::notes;
use crate::why::notes::Note;
use crate::{Grammar, messages, told, window};

texts!("learn/exercises");

/// A text of a list. The name itself if there is none, as for names that are the same in both languages.
fn listed<'a>(lang: Lang, list: &str, name: &'a str) -> &'a str {
    texts(lang).lists.get(list).and_then(|list| list.get(name)).copied().unwrap_or(name)
}

/// The title of an exercise or a family.
pub fn title(lang: Lang, entry: &Entry) -> &str {
    title_of(lang, &entry.id, entry.texts())
}

/// The title of an exercise with its numbers.
pub fn exercise_title(lang: Lang, exercise: &Exercise) -> &str {
    title_of(lang, &exercise.id, exercise.texts.as_deref())
}

fn title_of<'a>(lang: Lang, id: &str, own: Option<&'a OwnTexts>) -> &'a str {
    match own {
        Some(own) => told(lang, &own.title),
        None => of_id(lang, id).map_or("", |statement| statement.title),
    }
}

/// The texts of an exercise, also for the mistake in a solution of it.
fn of_id(lang: Lang, id: &str) -> Option<&'static Statement> {
    texts(lang).exercises.get(id.strip_suffix(FAULT).unwrap_or(id))
}

/// The paragraphs of its statement, in Markdown. The lines of a student's solution are the last.
pub fn statement(lang: Lang, exercise: &Exercise) -> Vec<String> {
    let mut paragraphs = given(lang, exercise);
    let mut number = 0;
    for step in exercise.fault().iter().flat_map(|fault| &fault.steps) {
        paragraphs.push(step_heading(lang, exercise, step));
        paragraphs.extend(in_dollars(lang, step).map(|line| {
            number += 1;
            format!("**({number})** {line}")
        }));
    }
    paragraphs
}

/// The rows of a step in sentences: symbol = formula = numbers = value, each once.
fn in_dollars(lang: Lang, step: &Worked) -> impl Iterator<Item = String> {
    let lines = step.lines(Style { notation: Notation::Latex, mark: lang.mark(), digits: 6 }, true);
    lines.into_iter().map(|Line { symbol, formula, numbers, value }| {
        let mut parts = vec![symbol, formula, numbers, value];
        parts.dedup();
        format!("${}$", parts.join(" = "))
    })
}

/// The paragraphs of its statement, in Markdown, without the lines of a student's solution.
pub fn given(lang: Lang, exercise: &Exercise) -> Vec<String> {
    if let Some(own) = &exercise.texts {
        let paragraphs = told(lang, &own.statement).split("\n\n").map(str::trim);
        return paragraphs
            .filter(|paragraph| !paragraph.is_empty())
            .map(|paragraph| paragraph.replace('\n', " "))
            .collect();
    }
    let paragraphs = of_id(lang, &exercise.id).map_or(&[][..], |statement| &statement.paragraphs);
    let paragraphs = paragraphs.iter().map(|paragraph| filled(lang, exercise, paragraph));
    let of_fault = exercise.fault().map(|fault| text!(lang, fault, ask = ask(lang, exercise, &fault.ask)));
    paragraphs.chain(of_fault).collect()
}

/// The assumptions if the source leaves a question open, and the differing ones of the source. The assumption `≠ yaw`
/// is the text about it in the note `yaw`.
pub fn assumptions(lang: Lang, exercise: &Exercise) -> Vec<String> {
    let text = |name: &&str| match name.strip_prefix("≠ ") {
        Some(id) => notes::note(lang, id).map_or_else(String::new, |note| differs(lang, note)),
        None => filled(lang, exercise, listed(lang, "assumptions", name)),
    };
    let own = exercise.texts.iter().flat_map(|own| &own.assumptions).map(|text| told(lang, text).to_owned());
    exercise.assumptions.iter().map(text).chain(own).collect()
}

/// The errata of a note, in Markdown.
fn differs(lang: Lang, note: &Note) -> String {
    let errata: Vec<String> = note.errata.iter().map(|pieces| notes::markdown(pieces)).collect();
    format!("{}: {}", window::texts(lang).erratum, errata.join(" "))
}

/// The text of a question.
pub fn ask(lang: Lang, exercise: &Exercise, ask: &Ask) -> String {
    if let Some(own) = exercise.texts.as_ref().and_then(|own| own.asks.get(&ask.name)) {
        return told(lang, own).to_owned();
    }
    if ask.fault.is_some() {
        let [line, cause] = text!(lang, fault_asks);
        return (if matches!(ask.kind, Kind::Choice(_)) { cause } else { line }).to_owned();
    }
    let found = of_id(lang, &exercise.id).and_then(|s| s.asks.get(ask.name.as_str()));
    found.map_or_else(|| ask.name.clone(), |text| filled(lang, exercise, text))
}

/// The reading of a question.
pub fn reading(lang: Lang, name: &'static str) -> &'static str {
    listed(lang, "readings", name)
}

/// The name of a choice typed by its name or by its word in any language, yes and no also in the form of `inspect`,
/// true and false. The typed text if it's none of them.
pub fn typed_choice<'a>(ask: &'a Ask, typed: &'a str) -> &'a str {
    let Kind::Choice(choices) = &ask.kind else { return typed };
    let wanted = typed.trim().to_lowercase();
    let is_it = |name: &&String| Lang::ALL.iter().any(|lang| choice_of(*lang, ask, name).to_lowercase() == wanted);
    let truth = [("yes", "sim", ["true", "verdadeiro"]), ("no", "não", ["false", "falso"])];
    let of_truth = |(en, pt_br, words): &(&str, &str, [&str; 2])| {
        let is_asked = |name: &&String| [en, pt_br].iter().any(|word| word.eq_ignore_ascii_case(name));
        words.contains(&wanted.as_str()).then(|| choices.iter().find(is_asked)).flatten()
    };
    let found = choices.iter().find(is_it).or_else(|| truth.iter().find_map(of_truth));
    found.map_or(typed, String::as_str)
}

/// A choice for which the program has a text.
pub fn choice(lang: Lang, name: &str) -> &str {
    listed(lang, "choices", name)
}

/// A choice of a question.
pub fn choice_of<'a>(lang: Lang, ask: &'a Ask, name: &'a str) -> &'a str {
    if let Some(fault) = &ask.fault
        && let Some(of) =
            name.bytes().next().and_then(|letter| fault.causes.get(usize::from(letter.wrapping_sub(b'a'))))
    {
        return cause(lang, &fault.ask, *of)[0];
    }
    ask.own_choices.get(name).map_or_else(|| choice(lang, name), |text| told(lang, text))
}

/// A condition on a camera.
pub fn condition(lang: Lang, name: &'static str) -> &'static str {
    listed(lang, "conditions", name)
}

/// The heading of a worked step.
pub fn heading(lang: Lang, name: &'static str) -> &'static str {
    listed(lang, "headings", name)
}

/// The text of a mistake, a hint, and a stronger one.
pub fn mistake(lang: Lang, mistake: Mistake) -> [&'static str; 3] {
    parts(listed(lang, "mistakes", mistake.code()))
}

/// The text of a mistake, a hint, and a stronger one.
fn parts(text: &'static str) -> [&'static str; 3] {
    let mut parts = text.split(" | ");
    std::array::from_fn(|_| parts.next().unwrap_or_default())
}

/// The text of a cause, a hint, and a stronger one: for its way of making the mistake, else for the question, else for
/// the mistake.
fn cause(lang: Lang, ask: &Ask, cause: Cause) -> [&'static str; 3] {
    let code = cause.mistake.code();
    let list = &texts(lang).lists["mistakes"];
    let of_variant = format!("{code}/{}", cause.variant);
    let of_nature = format!("{code}@{}", ask.nature.name());
    let found = [of_variant.as_str(), of_nature.as_str()].into_iter().find_map(|key| list.get(key));
    found.map_or_else(|| mistake(lang, cause.mistake), |text| parts(text))
}

/// The sentence on an answer about a student's solution, right or wrong.
fn on_fault(lang: Lang, fault: &Fault, ask: &Ask, judged: &Judged) -> String {
    let [before, after, other] = text!(lang, fault_wrong);
    match &judged.understood {
        Answer::Numbers { .. } if judged.right => {
            text!(
                lang,
                fault_right,
                line = ask
                    .steps()
                    .iter()
                    .flat_map(|step| in_dollars(lang, step))
                    .map(|line| format!("\n\n${line}$"))
                    .collect::<String>()
            )
        }
        Answer::Numbers { entries, .. } => {
            let is_after = entries.iter().flatten().any(|given| *given > f64::from(fault.line));
            (if is_after { after } else { before }).to_owned()
        }
        _ if judged.right => cause(lang, &fault.ask, fault.cause)[2].to_owned(),
        _ => other.to_owned(),
    }
}

/// The diagnosis of a wrong answer: the mistakes, one after the other, or all of which one was made, and the place of a
/// single faulty number. `None` if nothing explains the answer.
pub fn diagnosis(lang: Lang, ask: &Ask, judged: &Judged) -> Option<String> {
    if let Some(fault) = &ask.fault {
        return Some(on_fault(lang, fault, ask, judged));
    }
    let diagnosis = judged.diagnosis.as_ref()?;
    if let Some(own) = &diagnosis.own {
        return Some(told(lang, &own.message).to_owned());
    }
    // An arithmetic slip claims that all other numbers are right, which is wrong beside another mistake.
    let beside = diagnosis.causes.len() > 1;
    let told = diagnosis.causes.iter().filter(|found| !beside || found.mistake != Mistake::ArithmeticSlip);
    let mut said: Vec<String> = told.map(|found| cause(lang, ask, *found)[0].to_owned()).collect();
    if !diagnosis.others.is_empty() {
        let [several, either, or] = text!(lang, diagnosis);
        said.insert(0, format!("{several} {either}"));
        said.extend(diagnosis.others.iter().map(|other| format!("{or} {}", cause(lang, ask, *other)[0])));
    }
    if let Some([row, column]) = diagnosis.entry {
        let (row, column) = (row + 1, column + 1);
        said.push(match beside {
            true => text!(lang, diagnosis_also_wrong, row, column),
            false => {
                text!(lang, diagnosis_wrong_one, row, column)
            }
        });
    }
    if let Answer::Numbers { rows, columns, .. } = judged.understood
        && diagnosis.causes.iter().any(|cause| cause.mistake == Mistake::WrongShape)
    {
        let [asked, given] = [ask.shape(), [rows, columns]].map(shape);
        let given_one = rows * columns == 1;
        said.push(if ask.shape() == [1, 1] {
            text!(lang, expected_one, given)
        } else if given_one {
            text!(lang, expected_given_one, asked, given)
        } else {
            text!(lang, expected, asked, given)
        });
        if lang.mark() == DecimalMark::Comma && ask.shape()[1] == 1 && rows > ask.shape()[0] {
            said.push(text!(lang, expected_semicolons).to_owned());
        }
    }
    Some(said.join(" "))
}

const fn and(lang: Lang) -> &'static str {
    text!(lang, and)
}

/// The answers from whose wrong values this one follows correctly. `None` if it doesn't.
pub fn carried(lang: Lang, judged: &Judged) -> Option<String> {
    let (last, first) = judged.carried.split_last()?;
    let and = and(lang);
    let names = if first.is_empty() { last.clone() } else { format!("{} {and} {last}", first.join(", ")) };
    Some(match first.is_empty() {
        true => text!(lang, carried_one, names),
        false => text!(lang, carried_many, names),
    })
}

/// The numbers that the statement leaves open and for which the answer was judged. `None` if they're those of the
/// statement and nothing depends on them.
pub fn own_numbers(lang: Lang, judged: &Judged) -> Option<String> {
    let own = judged.numbers.as_ref()?;
    let (ask, values) = (&own.ask, named_numbers(lang, &own.values));
    Some(match &own.instead {
        Some(instead) => {
            let instead = named_numbers(lang, instead);
            text!(lang, own_numbers_instead, instead, ask, values)
        }
        None if judged.right => text!(lang, own_numbers_right, values),
        None => text!(lang, own_numbers_checked, values, ask),
    })
}

/// F = 3 and B = 10
fn named_numbers(lang: Lang, values: &[(&'static str, f64)]) -> String {
    let one = |(name, value): &(&str, f64)| match *name {
        "theta" => format!("θ = {}°", lang.mark().number(*value, 6)),
        _ => format!("{name} = {}", number(lang.mark(), *value)),
    };
    values.iter().map(one).collect::<Vec<_>>().join(text!(lang, named_numbers))
}

/// The count of numbers: a vector's, or a matrix' by rows and columns.
fn shape([rows, columns]: [usize; 2]) -> String {
    if columns == 1 { rows.to_string() } else { format!("{rows} × {columns}") }
}

/// Its hints, weaker ones first.
pub fn hints<'a>(lang: Lang, ask: &Ask, diagnosis: &'a Diagnosis) -> Vec<&'a str> {
    if let Some(own) = diagnosis.own.as_ref().filter(|own| !own.hints.is_empty()) {
        return own.hints.iter().map(|hint| told(lang, hint)).collect();
    }
    let of = |strength: usize| {
        let all = diagnosis.causes.iter().chain(&diagnosis.others);
        all.map(move |found| cause(lang, ask, *found)[strength])
    };
    of(1).chain(of(2)).collect()
}

/// The hints for a wrong answer that no known mistake explains. The sentence to keep of the lesson, and the first step
/// of the solution. Without a lesson, the number of right entries comes first.
pub fn hints_without_diagnosis(
    lang: Lang,
    judged: &Judged,
    (sentence, first_step): (Option<String>, Option<&str>),
) -> Vec<String> {
    let all: usize = judged.entries.iter().map(Vec::len).sum();
    let right = judged.entries.iter().flatten().filter(|is| **is).count();
    let mut hints = Vec::new();
    if let Some(sentence) = sentence {
        hints.push(sentence);
    } else if !judged.conditions.is_empty() {
        hints.push(text!(lang, hints_without_diagnosis_judged, right, all));
    } else if all > 1 {
        hints.push(match right {
            0 => text!(lang, hints_without_diagnosis_zero, all),
            1 => text!(lang, hints_without_diagnosis_one, all),
            _ => text!(lang, hints_without_diagnosis_some_right, right, all),
        });
    }
    if let Some(step) = first_step {
        hints.push(match judged.first_step {
            0 => text!(lang, hints_without_diagnosis_begins, step),
            _ => text!(lang, hints_without_diagnosis_goes_on, step),
        });
    }
    if hints.is_empty() {
        hints.push(text!(lang, hints_without_diagnosis_hints).to_owned());
    }
    hints
}

/// The required form of an answer.
pub fn kind(lang: Lang, ask: &Ask) -> String {
    let kind = match &ask.kind {
        Kind::Number => text!(lang, kind_number).to_owned(),
        Kind::Vector(rows) => text!(lang, kind_vector, rows),
        Kind::Matrix(rows, columns) => text!(lang, kind_matrix, rows, columns),
        Kind::Choice(choices) => {
            text!(lang, kind_choice, list_of_choices = list_of_choices(choices, |name| choice_of(lang, ask, name)))
        }
        Kind::Camera => text!(lang, kind_camera).to_owned(),
    };
    let tolerance = tolerance(lang, ask);
    if tolerance.is_empty() { kind } else { format!("{kind}; {tolerance}") }
}

fn list_of_choices<'a>(choices: &'a [String], said: impl Fn(&'a str) -> &'a str) -> String {
    let choice = |name: &'a String| match said(name) {
        said if said == name => name.clone(),
        said => format!("{name} ({said})"),
    };
    choices.iter().map(choice).collect::<Vec<_>>().join(", ")
}

/// The tolerance of an answer. Empty for choices and cameras.
pub fn tolerance(lang: Lang, ask: &Ask) -> String {
    let numbers = matches!(ask.kind, Kind::Number | Kind::Vector(_) | Kind::Matrix(..));
    let by = lang.mark().number(ask.tolerance, 3);
    let unit = unit(lang, ask.unit);
    let share = || {
        let percent = lang.mark().number(100.0 * ask.share, 3);
        if ask.share.is_finite() { format!(" {} {percent} %", and(lang)) } else { String::new() }
    };
    match (numbers, ask.whole) {
        (false, _) => String::new(),
        (true, _) if ask.places => text!(lang, tolerance_across, by, unit),
        (_, true) => text!(lang, tolerance_whole).to_owned(),
        (..) => text!(lang, tolerance_rounded, by, unit, share = share()),
    }
}

fn unit(lang: Lang, unit: Unit) -> &'static str {
    match unit {
        Unit::None => "",
        Unit::Scene => text!(lang, scene_units),
        Unit::Degrees => "°",
        Unit::Pixels => " px",
    }
}

/// The worked steps to an answer, one text each.
pub fn steps(lang: Lang, exercise: &Exercise, ask: &Ask, digits: usize) -> Vec<String> {
    ask.steps().iter().map(|worked| step(lang, exercise, worked, digits)).collect()
}

/// A worked step: heading, equation, and the rows below one another.
pub fn step(lang: Lang, exercise: &Exercise, step: &Worked, digits: usize) -> String {
    let style = Style { notation: Notation::Text, mark: lang.mark(), digits };
    let mut text = step_heading(lang, exercise, step);
    for line in step.lines(style, true) {
        text.push_str(&format!("\n  {} = {}", line.symbol, line.formula));
        if line.numbers != line.formula && line.numbers != line.value {
            text.push_str(&format!("\n    = {}", line.numbers));
        }
        if line.value != line.formula {
            text.push_str(&format!(" = {}", line.value));
        }
    }
    text
}

/// The heading of a worked step: its action, and its equation.
pub fn step_heading(lang: Lang, exercise: &Exercise, step: &Worked) -> String {
    let heading = filled(lang, exercise, heading(lang, step.heading));
    if step.equation.is_empty() { heading } else { format!("{heading}  {}", step.equation) }
}

/// The interpretation of an answer.
pub fn understood(lang: Lang, ask: &Ask, answer: &Answer) -> String {
    let mark = lang.mark();
    let entry = |entry: &Option<f64>| entry.map_or_else(|| "?".to_owned(), |value| number(mark, value));
    match (answer, &ask.kind) {
        (Answer::Choice(index), Kind::Choice(choices)) => {
            choices.get(*index).map_or_else(String::new, |name| choice_of(lang, ask, name).to_owned())
        }
        (Answer::Numbers { rows: 1, columns: 1, entries }, _) => entries.iter().map(entry).collect(),
        (Answer::Numbers { columns: 1, entries, .. }, _) => {
            let numbers: Vec<String> = entries.iter().map(entry).collect();
            format!("({})", numbers.join(mark.separator()))
        }
        (Answer::Numbers { columns, entries, .. }, _) => {
            let row = |row: &[Option<f64>]| {
                let numbers: Vec<String> = row.iter().map(entry).collect();
                format!("[{}]", numbers.join(mark.separator()))
            };
            let rows: Vec<String> = entries.chunks((*columns).max(1)).map(row).collect();
            format!("[{}]", rows.join(mark.separator()))
        }
        (Answer::Camera(parameters), _) => exercise_cameras::typed(lang, parameters),
        (Answer::Choice(_), _) => String::new(),
    }
}

/// The names that an answer uses for the parameters of a camera.
const CAMERA_NAMES: &str = "C, PF, VUP, projection, θ, W, H, A, F, B, window";

/// The reason why an answer can't be read.
pub fn answer_error(lang: Lang, error: &AnswerError) -> String {
    match (lang.grammar(), error) {
        (_, AnswerError::Number { row, column, text, error }) => {
            let place = text!(lang, answer_error_place, row = row + 1, column = column + 1);
            format!("{place}: {}: {}", marked(text, &error.span), messages::expression(lang, &error.problem))
        }
        (_, AnswerError::Camera(error)) => exercise_cameras::refused(lang, error),
        (_, AnswerError::Choice { given, choices }) => text!(
            lang,
            answer_error_choice,
            given = escaped(given),
            list_of_choices = list_of_choices(choices, |name| choice(lang, name))
        ),
        (_, AnswerError::Pair(text)) => text!(lang, answer_error_pair, text = escaped(text)),
        (_, AnswerError::Parameter(text)) => text!(lang, answer_error_parameter, text = escaped(text), CAMERA_NAMES),
        (Grammar::English, other) => other.to_string(),
        (Grammar::Portuguese, AnswerError::Empty) => "falta uma resposta".to_owned(),
        (Grammar::Portuguese, AnswerError::TooLong) => {
            format!("uma resposta tem no máximo {} caracteres", crate::limits::MAX_ANSWER)
        }
        (Grammar::Portuguese, AnswerError::BesideBrackets) => {
            "ao lado dos colchetes só pode estar um fator; uma função leva parênteses: [1; 1; 1]/sqrt(3)".to_owned()
        }
        (Grammar::Portuguese, AnswerError::Bracket) => "falta um colchete ou parêntese".to_owned(),
        (Grammar::Portuguese, AnswerError::Ragged { row, found, first }) => {
            format!("a linha {} tem {found} números, a primeira tem {first}", row + 1)
        }
    }
}

/// A text with the facts of an exercise put in.
fn filled(lang: Lang, exercise: &Exercise, text: &str) -> String {
    let mut filled = text.to_owned();
    // A fact that is a text has facts in it.
    for _ in 0..2 {
        if !filled.contains('{') {
            break;
        }
        for (name, fact) in &exercise.facts {
            for (place, as_code) in [(format!("{{{name}}}"), false), (format!("{{={name}}}"), true)] {
                if filled.contains(&place) {
                    filled = filled.replace(&place, &if as_code { in_code(fact) } else { written(lang, fact) });
                }
            }
        }
    }
    filled
}

/// A fact as an argument of a function, which is the same in every language.
fn in_code(fact: &Fact) -> String {
    match fact {
        Fact::Angle(degrees) => number(DecimalMark::Point, *degrees),
        Fact::Number(_) | Fact::Tuple(_) | Fact::Matrix(_) | Fact::Word(_) | Fact::Text(_) => written(Lang::En, fact),
    }
}

/// A fact as part of a sentence.
fn written(lang: Lang, fact: &Fact) -> String {
    let mark = lang.mark();
    match fact {
        Fact::Number(value) => number(mark, *value),
        Fact::Angle(degrees) => format!("{}°", mark.number(*degrees, 8)),
        Fact::Tuple(values) => tuple(mark, values),
        Fact::Matrix(table) => matrix(mark, table),
        Fact::Word(word) => word.clone(),
        Fact::Text(name) => listed(lang, "words", name).to_owned(),
    }
}

/// A number as a fraction or a root if it's one, otherwise in six digits.
pub fn number(mark: DecimalMark, value: f64) -> String {
    exact_form(value).map_or_else(|| mark.number(value, 6), |form| form.text())
}

/// (a, b, c)
pub fn tuple(mark: DecimalMark, values: &[f64]) -> String {
    let numbers: Vec<String> = values.iter().map(|value| number(mark, *value)).collect();
    format!("({})", numbers.join(mark.separator()))
}

/// [[a, b], [c, d]]
pub fn matrix(mark: DecimalMark, table: &Table) -> String {
    let row = |row: &[f64]| {
        let numbers: Vec<String> = row.iter().map(|value| number(mark, *value)).collect();
        format!("[{}]", numbers.join(mark.separator()))
    };
    format!("[{}]", table.rows().map(row).collect::<Vec<_>>().join(mark.separator()))
}

/// A number, or a matrix, in LaTeX. A vector is a column. `None` is a missing entry.
pub fn table_latex(mark: DecimalMark, unit: Unit, columns: usize, entries: &[Option<f64>]) -> String {
    let unit = if unit == Unit::Degrees { r"^\circ" } else { "" };
    let decimal = |value: f64| mark.number(value, 6).replace('−', "-").replace(',', "{,}");
    let number = |entry: &Option<f64>| {
        let set = |value: f64| exact_form(value).map_or_else(|| decimal(value), |form| form.latex());
        entry.map_or_else(|| "?".to_owned(), |value| format!("{}{unit}", set(value)))
    };
    if entries.len() == 1 {
        return entries.iter().map(number).collect();
    }
    let (mut rows, mut end) = (String::new(), "");
    for row in entries.chunks(columns.max(1)) {
        let row = row.iter().map(number).collect::<Vec<_>>().join(" & ");
        rows.push_str(end);
        rows.push_str(&row);
        // A gap counts from the line of the letters: one that keeps fractions apart is wide below numbers.
        end = if row.contains(r"\frac") { r" \\[11pt] " } else { r" \\ " };
    }
    format!(r"\begin{{bmatrix}} {rows} \end{{bmatrix}}").replace(r"\frac", r"\dfrac")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_languages_have_the_same_names() {
        let (en, pt) = (texts(Lang::En), texts(Lang::PtBr));
        assert_eq!(en.exercises.keys().collect::<Vec<_>>(), pt.exercises.keys().collect::<Vec<_>>());
        for (id, statement) in &en.exercises {
            let other = &pt.exercises[id];
            assert_eq!(statement.asks.keys().collect::<Vec<_>>(), other.asks.keys().collect::<Vec<_>>(), "{id}");
            assert!(!statement.title.is_empty() && !other.title.is_empty() && !other.paragraphs.is_empty(), "{id}");
        }
        for (list, names) in &en.lists {
            assert_eq!(names.keys().collect::<Vec<_>>(), pt.lists[list].keys().collect::<Vec<_>>(), "{list}");
        }
        for mistake in Mistake::ALL {
            for lang in [Lang::En, Lang::PtBr] {
                let said = super::mistake(lang, mistake);
                assert!(said.iter().all(|text| text.len() > 10), "{mistake:?} {lang:?}");
            }
        }
    }
}
