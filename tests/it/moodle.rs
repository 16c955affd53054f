//! The bank of questions for Moodle, read by another parser, which marks answers as Moodle does.

#![expect(clippy::unwrap_used, clippy::print_stderr, reason = "tests")]

use camera_lab::exercises::{Exercise, Free, Kind, Slip, Slips, check, entries};
use camera_lab_words::Lang;
use camera_lab_words::learn::exercises as said;

use crate::common::program::Bench;

/// The texts of the elements with a name, in order.
fn elements<'a>(xml: &'a str, name: &str) -> Vec<&'a str> {
    let (begin, end) = (format!("<{name}"), format!("</{name}>"));
    let mut found = Vec::new();
    let mut rest = xml;
    while let Some(at) = rest.find(&begin) {
        let after = &rest[at + begin.len()..];
        if !after.starts_with(['>', ' ']) {
            rest = after;
            continue;
        }
        let text = after.split_once('>').unwrap().1;
        let length = text.find(&end).expect("an end");
        found.push(&text[..length]);
        rest = &text[length + end.len()..];
    }
    found
}

/// The text in a CDATA section, or as it is.
fn data(text: &str) -> &str {
    text.strip_prefix("<![CDATA[").and_then(|text| text.strip_suffix("]]>")).unwrap_or(text)
}

/// The answers of a field: value, tolerance, whether it's right, feedback.
type Answers = Vec<(String, f64, bool, String)>;

/// The fields of a question, as Moodle takes them apart.
fn fields(question: &str) -> Vec<Answers> {
    let html = data(elements(elements(question, "questiontext")[0], "text")[0]);
    let mut fields = Vec::new();
    for part in html.split("{1:").skip(1) {
        let (_, body) = part.split_once(':').unwrap();
        let (mut answers, mut now, mut is_escaped) = (Vec::new(), String::new(), false);
        for c in body.chars() {
            match c {
                _ if is_escaped => {
                    // A character that stands for itself.
                    now.extend(['\u{1}', c]);
                    is_escaped = false;
                }
                '\\' => is_escaped = true,
                '}' => break,
                '~' => answers.push(std::mem::take(&mut now)),
                c => now.push(c),
            }
        }
        answers.push(now);
        let answer = |text: &String| {
            let (answer, feedback) = text.split_once('#').unwrap_or((text, ""));
            let (right, answer) = match (answer.strip_prefix('='), answer.strip_prefix("%0%")) {
                (Some(answer), _) => (true, answer),
                (_, Some(answer)) => (false, answer),
                _ => (false, answer),
            };
            let (value, tolerance) = answer.rsplit_once(':').unwrap_or((answer, "0"));
            let plain = |text: &str| text.replace('\u{1}', "");
            (plain(value), tolerance.parse().unwrap_or(0.0), right, plain(feedback))
        };
        fields.push(answers.iter().map(answer).collect());
    }
    if fields.is_empty() {
        let answer = |xml: &&str| {
            let text = |name: &str| {
                elements(xml, name).first().map_or("", |inner| data(elements(inner, "text").first().unwrap_or(inner)))
            };
            let value = data(elements(xml, "text")[0]).to_owned();
            let tolerance = elements(xml, "tolerance").first().and_then(|t| t.parse().ok()).unwrap_or(0.0);
            let feedback = text("feedback").to_owned();
            (value, tolerance, xml.is_empty(), feedback)
        };
        let mut answers: Answers = elements(question, "answer").iter().map(answer).collect();
        for (answer, part) in answers.iter_mut().zip(question.split("<answer fraction=\"").skip(1)) {
            answer.2 = part.starts_with("100");
        }
        fields.push(answers);
    }
    fields
}

/// The mark and the feedback of Moodle: those of the first answer that fits.
fn marked(field: &Answers, given: f64) -> Option<(bool, &str)> {
    let fits = |(value, tolerance, ..): &&(String, f64, bool, String)| {
        (value.parse::<f64>().unwrap() - given).abs() <= *tolerance
    };
    field.iter().find(fits).map(|(.., right, feedback)| (*right, feedback.as_str()))
}

/// The exercises whose answers are numbers in fields.
fn with_fields(exercise: &Exercise) -> bool {
    let is_field = |kind: &Kind| matches!(kind, Kind::Number | Kind::Vector(_) | Kind::Matrix(..) | Kind::Choice(_));
    exercise.asks.iter().all(|ask| is_field(&ask.kind) && !ask.any_order)
}

#[test]
fn every_right_answer_is_right_and_each_named_mistake_gets_its_sentence() {
    let bench = Bench::new("moodle");
    let (mut numbers, mut mistakes) = (0, 0);
    for (lang, entry) in
        entries().map(|entry| (Lang::En, entry)).chain(entries().take(8).map(|entry| (Lang::PtBr, entry)))
    {
        let run =
            bench.run(&["exercise", "sheet", "--ids", &entry.id, "--seed", "3-5", "-o", "q.xml", "--lang", lang.tag()]);
        assert_eq!(run.status, Some(0), "{}", run.err);
        let xml = String::from_utf8(bench.read("q.xml")).unwrap();
        let questions = elements(&xml, "question");
        let of: Vec<&&str> = questions.iter().filter(|question| !question.contains("<category>")).collect();
        if !with_fields(&entry.exercise(3, &Free::new())) {
            assert!(of.is_empty() && !run.err.is_empty(), "{}: what can't be asked is named", entry.id);
            continue;
        }
        assert_eq!(of.len(), 3, "{}", entry.id);
        for (question, seed) in of.iter().zip(3..) {
            let exercise = entry.exercise(seed, &Free::new());
            let mut fields = fields(question).into_iter();
            for ask in &exercise.asks {
                if let Kind::Choice(choices) = &ask.kind {
                    let field = fields.next().unwrap();
                    assert_eq!(field.len(), choices.len(), "{} {}", entry.id, ask.name);
                    assert_eq!(field.iter().filter(|(.., right, _)| *right).count(), 1, "{} {}", entry.id, ask.name);
                    continue;
                }
                let right = ask.expected().table().unwrap();
                let own: Vec<Answers> = fields.by_ref().take(right.entries.len()).collect();
                assert_eq!(own.len(), right.entries.len(), "{} {}", entry.id, ask.name);
                for (field, value) in own.iter().zip(&right.entries) {
                    let rounded: f64 = format!("{value:.2e}").parse().unwrap();
                    for given in [*value, rounded] {
                        assert_eq!(marked(field, given).map(|(right, _)| right), Some(true), "{} {given}", entry.id);
                        numbers += 1;
                    }
                }
                for slip in Slip::ALL {
                    let wrong =
                        ask.expected().slipped(Slips::one(*slip)).filter(|wrong| wrong.shape() == right.shape());
                    let Some(wrong) = wrong else { continue };
                    let rows: Vec<String> = wrong.rows().map(|row| format!("{row:?}")).collect();
                    let typed = match wrong.shape() {
                        [1, 1] => format!("{:?}", wrong.entries[0]),
                        [_, 1] => format!("{:?}", wrong.entries),
                        _ => format!("[{}]", rows.join(", ")),
                    };
                    let Ok(judged) = check(entry, &exercise, ask, &typed) else { continue };
                    if judged.right || said::diagnosis(lang, ask, &judged).is_none() {
                        continue;
                    }
                    // At least one of its numbers is marked wrong, with a sentence.
                    let told = own.iter().zip(&wrong.entries).filter_map(|(field, value)| marked(field, *value));
                    let has_sentence = told.filter(|(right, feedback)| !right && !feedback.is_empty()).count() > 0;
                    let differs = own
                        .iter()
                        .zip(&wrong.entries)
                        .any(|(field, value)| marked(field, *value).is_none_or(|(right, _)| !right));
                    assert!(has_sentence || !differs, "{} {} {slip:?}", entry.id, ask.name);
                    mistakes += usize::from(has_sentence);
                }
            }
        }
    }
    assert!(numbers > 1_000 && mistakes > 500, "{numbers} {mistakes}");
}

/// Python's parser of XML takes it, if there is one.
#[test]
fn the_bank_is_well_formed() {
    let bench = Bench::new("moodle-xml");
    let ids: Vec<&str> = entries().map(|entry| &*entry.id).collect();
    let run = bench.run(&["exercise", "sheet", "--ids", &ids.join(","), "--seed", "1-4", "-o", "all.xml"]);
    assert_eq!(run.status, Some(0));
    let script = "import sys, xml.etree.ElementTree as t\nr = t.parse(sys.argv[1]).getroot()\nprint(r.tag, len(r.findall('question')))";
    let path = bench.path("all.xml");
    let Ok(python) = std::process::Command::new("python3").args(["-c", script]).arg(&path).output() else {
        eprintln!("python3 is not installed: the bank was not parsed by it");
        return;
    };
    assert!(python.status.success(), "{}", String::from_utf8_lossy(&python.stderr));
    assert!(String::from_utf8_lossy(&python.stdout).starts_with("quiz "));
}
