//! `camera-lab exercise`: exercises, their statements, and judged answers.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use serde::Serialize;
use serde_json::{Map, Value, json};

use super::render::{no_picture, save, save_handout};
use super::{Failure, nearest, print, say};
use crate::cli::args::exercise::{
    CheckArgs, ExerciseArgs, ExerciseCommand, ListArgs, NumbersArgs, PackageArgs, ReportArgs, SheetArgs, ShowArgs,
};
use crate::cli::args::words::{DataFormat, TableFormat, written};
use crate::exercises::{self, Answer, AnswerError, Ask, Cause, Entry, Exercise, Expected, Judged, Kind};
use crate::export::format::PictureFormat;
use crate::figure::write::to_toml;
use crate::figure::{Figure, FigureError, Localized};
use crate::inspect::json_text;
use crate::lessons::{Draft, lesson_of, parse_bytes, with_step};
use crate::picture::{self, Composite, FileOptions, Metadata};
use crate::progress::{Progress, at_once};
use crate::sanitize;
use crate::scene::no_files;
use crate::views::{SharedScene, Size, View, Views, scene_of};
use camera_lab_files::{self as files, BadExercise, OwnExercises};
use camera_lab_words::class::{self, ClassReport};
use camera_lab_words::handout::{self, HandoutOptions, NoPicture, Solutions, Version};
use camera_lab_words::learn::moodle::moodle;
use camera_lab_words::learn::{
    exercise_messages::{self as said, plain},
    exercise_sheet as sheet_of, exercise_window, exercises as texts, lessons,
};
use camera_lab_words::{Lang, messages};

/// Digits of the numbers in worked steps.
const DIGITS: usize = 6;

pub(super) fn run(args: &ExerciseArgs, lang: Lang) -> Result<(), Failure> {
    match &args.command {
        ExerciseCommand::List(args) => list(args, lang),
        ExerciseCommand::Show(args) => show(args, lang),
        ExerciseCommand::Check(args) => check(args, lang),
        ExerciseCommand::Sheet(args) => sheet(args, lang),
        ExerciseCommand::Package(args) => package(args, lang),
        ExerciseCommand::Report(args) => report(args, lang),
    }
}

/// The output doesn't depend on the system's language.
fn list(args: &ListArgs, lang: Lang) -> Result<(), Failure> {
    #[derive(Serialize)]
    struct AskLine<'a> {
        id: &'a str,
        source: &'a str,
        title: &'a str,
        minutes: Option<u16>,
        family: bool,
    }
    let written = written(args.lang);
    let own = own(args.folder.as_deref(), lang)?;
    say_faults(&own, lang);
    let lines: Vec<AskLine<'_>> = exercises::with_own(&own.entries)
        .map(|entry| AskLine {
            id: &entry.id,
            source: entry.source,
            title: texts::title(written, entry),
            minutes: entry.minutes,
            family: entry.is_family,
        })
        .collect();
    let text = match args.format {
        TableFormat::Json => json_text(&serde_json::to_value(&lines).unwrap_or_default()),
        TableFormat::Text => {
            let minutes =
                |line: &AskLine<'_>| line.minutes.map_or_else(String::new, |minutes| format!("{minutes} min"));
            let text = |line: &AskLine<'_>| {
                format!("{:<20} {:<30} {:>6}  {}\n", line.id, line.source, minutes(line), line.title)
            };
            lines.iter().map(text).collect()
        }
    };
    print(text.as_bytes(), lang)
}

/// The exercises of a lecturer's folder. None without one.
fn own(folder: Option<&Path>, lang: Lang) -> Result<OwnExercises, Failure> {
    let Some(folder) = folder else { return Ok(OwnExercises::default()) };
    files::read_exercises(folder)
        .map_err(|error| Failure::BadInput(messages::file(lang, &sanitize::path(folder), &error)))
}

/// The reason why a file of the folder holds no exercise.
fn fault(bad: &BadExercise, lang: Lang) -> String {
    messages::file(lang, &sanitize::path(&bad.path), &bad.error)
}

/// Reports which files of the folder are skipped.
fn say_faults(own: &OwnExercises, lang: Lang) {
    own.faults.iter().for_each(|bad| say(&said::passed_over(lang, &fault(bad, lang))));
}

/// The exercise with an identifier, with the numbers of the arguments.
fn find(id: &str, numbers: &NumbersArgs, lang: Lang) -> Result<(Entry, Exercise), Failure> {
    let own = own(numbers.folder.as_deref(), lang)?;
    let found = find_in(&own, id, numbers, numbers.seed(lang)?, lang)?;
    say_faults(&own, lang);
    Ok(found)
}

fn find_in(
    own: &OwnExercises,
    id: &str,
    numbers: &NumbersArgs,
    seed: u64,
    lang: Lang,
) -> Result<(Entry, Exercise), Failure> {
    let all = || exercises::with_own(&own.entries);
    let id = &if numbers.fault { format!("{id}{}", exercises::FAULT) } else { id.to_owned() };
    let found = all().find(|entry| entry.id == *id).or_else(|| exercises::entry(id));
    let entry = found.cloned().ok_or_else(|| {
        if let Some(bad) = own.faults.iter().find(|bad| bad.id.as_deref() == Some(id.as_str())) {
            return Failure::BadInput(fault(bad, lang));
        }
        say_faults(own, lang);
        Failure::BadInput(said::unknown_exercise(lang, id, nearest(all().map(|entry| &*entry.id), id)))
    })?;
    let free = numbers.free(lang)?;
    let exercise = entry.exercise(seed, &free);
    let names: Vec<&str> = exercise.free.iter().map(|(name, _)| *name).collect();
    match free.keys().find(|name| !names.contains(&name.as_str())) {
        Some(name) => Err(Failure::BadInput(said::not_free(lang, id, name, &names))),
        None => Ok((entry, exercise)),
    }
}

fn show(args: &ShowArgs, lang: Lang) -> Result<(), Failure> {
    let (_, exercise) = find(&args.id, &args.numbers, lang)?;
    let written = written(args.numbers.lang);
    if let Some(path) = &args.picture {
        let name = sanitize::path(path);
        let figure = exercise.figure_to_match();
        let figure = figure.ok_or_else(|| Failure::BadInput(said::no_picture(lang, &exercise.id)))?;
        if PictureFormat::of(path) != Some(PictureFormat::Png) {
            return Err(Failure::BadInput(said::picture_ending(lang, &name)));
        }
        save_picture(path, &figure, written, lang)?;
    }
    let text = match args.format {
        TableFormat::Json => json_text(&described(written, &exercise, args.solution)),
        TableFormat::Text => to_read(written, &exercise, args.solution),
    };
    print(text.as_bytes(), lang)
}

/// The JSON output for an exercise.
fn described(lang: Lang, exercise: &Exercise, with_solution: bool) -> Value {
    let subject = &exercise.subject;
    let mut object = json!({
        "id": exercise.id,
        "seed": exercise.seed,
        "title": texts::exercise_title(lang, exercise),
        "statement": texts::statement(lang, exercise).join("\n\n"),
        "assumptions": texts::assumptions(lang, exercise),
        "figure": to_toml(&subject.figure),
        "points": subject.points.iter().map(|point| point.to_array()).collect::<Vec<_>>(),
        "pixels": subject.pixels,
        "ops": subject.operations.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "free": by_name(&exercise.free),
        "asks": exercise.asks.iter().map(|ask| asked(lang, exercise, ask)).collect::<Vec<_>>(),
        "lesson": lesson_of(&exercise.id).map(|way| json!({ "id": way.lesson.id, "step": way.step + 1 })),
        "picture": exercise.figure_to_match().map(|_| picture_command(exercise)),
    });
    if with_solution {
        let answers: Map<String, Value> =
            exercise.asks.iter().map(|ask| (ask.name.clone(), answer_value(lang, ask))).collect();
        object["answers"] = Value::Object(answers);
        let new_steps = exercise.new_steps();
        let steps: Vec<String> =
            new_steps.iter().flatten().map(|step| texts::step(lang, exercise, step, DIGITS)).collect();
        object["steps"] = json!(steps);
    }
    object
}

fn by_name(numbers: &[(&str, f64)]) -> Map<String, Value> {
    numbers.iter().map(|(name, value)| ((*name).to_owned(), json!(value))).collect()
}

pub(super) fn asked(lang: Lang, exercise: &Exercise, ask: &Ask) -> Value {
    let (kind, choices) = match &ask.kind {
        Kind::Number => ("number", None),
        Kind::Vector(_) => ("vector", None),
        Kind::Matrix(..) => ("matrix", None),
        Kind::Choice(choices) => ("choice", Some(choices)),
        Kind::Camera => ("camera", None),
    };
    json!({
        "name": ask.name,
        "text": texts::ask(lang, exercise, ask),
        "kind": kind,
        "places": ask.places,
        "shape": ask.shape(),
        "unit": ask.unit.symbol(),
        "tolerance": ask.tolerance,
        "quantity": ask.quantity.map(|path| path.to_string()),
        "choices": choices,
    })
}

/// The right answer as JSON: a number, a list, a matrix, a choice, a camera as text.
fn answer_value(lang: Lang, ask: &Ask) -> Value {
    match (ask.expected().table(), &ask.kind) {
        (Some(table), Kind::Number) => json!(table.entries.first()),
        (Some(table), Kind::Matrix(..)) => json!(table.rows().collect::<Vec<_>>()),
        (Some(table), _) => json!(table.entries),
        (None, Kind::Choice(choices)) => match ask.expected() {
            Expected::Choice(right, ..) => json!(choices.get(*right)),
            _ => Value::Null,
        },
        (None, _) => json!(sheet_of::answer(lang, ask)),
    }
}

/// The output as text.
fn to_read(lang: Lang, exercise: &Exercise, with_solution: bool) -> String {
    let t = said::texts(lang);
    let mut text = format!("{}  ({})\n", texts::exercise_title(lang, exercise), exercise.id);
    // Writing to a String can't fail.
    for paragraph in texts::statement(lang, exercise) {
        let _ = writeln!(text, "\n{}", plain(&paragraph));
    }
    let assumptions = texts::assumptions(lang, exercise);
    if !assumptions.is_empty() {
        let _ = writeln!(text, "\n{}:", t.assumptions);
        for assumption in assumptions {
            let _ = writeln!(text, "  - {}", plain(&assumption));
        }
    }
    if let Some(way) = lesson_of(&exercise.id) {
        let (name, id, step) = (lessons::lesson_link(lang, &way.lesson, way.step), &way.lesson.id, way.step + 1);
        let _ = writeln!(text, "\n{name}: camera-lab lesson play {id} --step {step}");
    }
    let _ = writeln!(text, "\n{}:", t.asked);
    for ask in &exercise.asks {
        let [asked, kind] = [texts::ask(lang, exercise, ask), texts::kind(lang, ask)].map(|text| plain(&text));
        let _ = writeln!(text, "  {:<12} {asked} ({kind})", ask.name);
    }
    if with_solution {
        for (ask, steps) in exercise.asks.iter().zip(exercise.new_steps()) {
            let _ = writeln!(text, "\n{} = {}", ask.name, plain(&sheet_of::answer(lang, ask)));
            for step in &steps {
                let step = texts::step(lang, exercise, step, DIGITS);
                let _ = writeln!(text, "  {}", plain(&step).replace('\n', "\n  "));
            }
        }
    }
    text
}

/// The command that writes the picture to match. A figure would reveal the answer.
fn picture_command(exercise: &Exercise) -> String {
    format!("camera-lab exercise show {} --seed {} --picture OUT.png", exercise.id, exercise.seed)
}

/// The picture of a figure that an exercise asks to match.
fn to_match(figure: &Figure, (written, size): (Lang, Size), name: &str, lang: Lang) -> Result<Composite, Failure> {
    let failed = |why: String| Failure::Failed(format!("{name}: {why}"));
    let scene = scene_of(figure, &mut no_files, &Progress::default());
    let scene = SharedScene::new(scene.map_err(|error| failed(messages::scene(lang, &error)))?);
    handout::picture(figure, &scene, Views::One(View::Image), size, written).map_err(|error| match error {
        NoPicture::Camera(error) => failed(messages::camera(lang, &error)),
        NoPicture::Composite(error) => no_picture(lang, name, error.into(), [size.width, size.height].map(u64::from)),
    })
}

/// Writes the picture of a figure, but not the figure in it, because that would reveal the camera.
fn save_picture(path: &Path, figure: &Figure, written: Lang, lang: Lang) -> Result<(), Failure> {
    const SIZE: Size = Size { width: 960, height: 720, scale: 2.0 };
    let name = sanitize::path(path);
    let sheet = to_match(figure, (written, SIZE), &name, lang)?;
    let png = FileOptions { dpi: Some(200.0), ..FileOptions::of(PictureFormat::Png) };
    let file = at_once(picture::file(&sheet, png, &Metadata::default(), &Progress::default()));
    let file = file.map_err(|error| no_picture(lang, &name, error, [SIZE.width, SIZE.height].map(u64::from)))?;
    save(path, &file.bytes, None, lang)
}

/// Markdown without its marks. Mathematics stays as written.
fn unmarked(markdown: &str) -> String {
    let part = |(k, part): (usize, &str)| if k % 2 == 1 { part.to_owned() } else { part.replace("**", "") };
    markdown.split('$').enumerate().map(part).collect::<Vec<_>>().join("$")
}

fn check(args: &CheckArgs, lang: Lang) -> Result<(), Failure> {
    let (entry, exercise) = find(&args.id, &args.numbers, lang)?;
    let names: Vec<&str> = exercise.asks.iter().map(|ask| ask.name.as_str()).collect();
    let mut typed: Vec<(&Ask, &str)> = Vec::new();
    for (name, answer) in args.answers(lang)? {
        let ask = exercise.asks.iter().find(|ask| ask.name == name);
        let ask = ask.ok_or_else(|| Failure::BadInput(said::unknown_ask(lang, &entry.id, name, &names)))?;
        if typed.iter().any(|(other, _)| other.name == ask.name) {
            return Err(Failure::BadInput(said::answered_twice(lang, name)));
        }
        typed.push((ask, texts::typed_choice(ask, answer)));
    }
    let unreadable = |ask: &Ask, error: &AnswerError| {
        Failure::BadInput(said::unreadable(lang, &ask.name, &texts::answer_error(lang, error)))
    };
    // Answers submitted together are one piece of work.
    let read = |(ask, text): &(&Ask, &str)| match exercises::read_answer(text, ask, &exercise.free) {
        Ok(answer) => Ok((ask.name.clone(), answer)),
        Err(error) => Err(unreadable(ask, &error)),
    };
    let answers: Vec<(String, Answer)> = typed.iter().map(read).collect::<Result<_, _>>()?;
    let judge = |(ask, text): (_, &str)| match exercises::check_beside(&entry, &exercise, ask, text, &answers) {
        Ok(verdict) => Ok((ask, verdict)),
        Err(error) => Err(unreadable(ask, &error)),
    };
    let judged: Vec<(&Ask, Judged)> = typed.into_iter().map(judge).collect::<Result<_, _>>()?;
    let written = written(args.numbers.lang);
    let right = judged.iter().all(|(_, verdict)| verdict.right);
    let unanswered: Vec<&str> =
        names.iter().copied().filter(|name| !judged.iter().any(|(ask, _)| ask.name == *name)).collect();
    let text = match args.format {
        TableFormat::Json => json_text(&json!({
            "right": right,
            "answers": judged.iter().map(|(ask, verdict)| verdict_value(written, &exercise, ask, verdict)).collect::<Vec<_>>(),
            "unanswered": unanswered,
        })),
        TableFormat::Text => verdicts(written, &exercise, &judged, &unanswered, args.hints(lang)?),
    };
    print(text.as_bytes(), lang)?;
    if right { Ok(()) } else { Err(Failure::NotRight) }
}

fn verdict_value(lang: Lang, exercise: &Exercise, ask: &Ask, verdict: &Judged) -> Value {
    let hints: Vec<String> = said::hints(lang, exercise, ask, verdict).iter().map(|hint| unmarked(hint)).collect();
    let diagnosis = verdict.diagnosis.as_ref().map(|diagnosis| {
        let codes = |causes: &[Cause]| causes.iter().map(|cause| cause.mistake.code()).collect::<Vec<&str>>();
        let (codes, others) = (codes(&diagnosis.causes), codes(&diagnosis.others));
        json!({
            "code": codes.first().copied().unwrap_or("own"),
            "codes": codes,
            "message": texts::diagnosis(lang, ask, verdict).as_deref().map(unmarked),
            "hints": hints,
            "others": others,
        })
    });
    json!({
        "name": ask.name,
        "right": verdict.right,
        "score": verdict.score,
        "entries": verdict.entries,
        "diagnosis": diagnosis,
        "remark": ask.fault.as_ref().and_then(|_| texts::diagnosis(lang, ask, verdict)).as_deref().map(unmarked),
        "off": ask.off(&verdict.understood),
        "carried": verdict.carried,
        "numbers": verdict.numbers.as_ref().map(|own| json!({
            "values": by_name(&own.values),
            "from": own.ask,
            "instead": own.instead.as_deref().map(by_name),
            "message": texts::own_numbers(lang, verdict),
        })),
        "understood": texts::understood(lang, ask, &verdict.understood),
        "reading": Some(verdict.reading).filter(|name| !name.is_empty()),
        "conditions": verdict.conditions.iter().map(|name| texts::condition(lang, name)).collect::<Vec<_>>(),
        "hints": hints,
    })
}

/// The output as text.
fn verdicts(lang: Lang, exercise: &Exercise, judged: &[(&Ask, Judged)], unanswered: &[&str], hints: usize) -> String {
    let (t, words) = (said::texts(lang), exercise_window::texts(lang));
    let mut text = String::new();
    for (ask, verdict) in judged {
        let understood = texts::understood(lang, ask, &verdict.understood);
        let entries: Vec<bool> = verdict.entries.iter().flatten().copied().collect();
        let right = entries.iter().filter(|is| **is).count();
        let share = match (verdict.right, entries.len()) {
            (true, _) => words.right.to_owned(),
            _ if !verdict.carried.is_empty() => words.follows.to_owned(),
            (false, 1) => words.wrong.to_owned(),
            (false, all) => format!("{} ({})", words.wrong, said::right_of(lang, right, all)),
        };
        let _ = writeln!(text, "{}: {share}  ({} {})", ask.name, words.understood, plain(&understood));
        if !verdict.reading.is_empty() {
            let _ = writeln!(text, "  {}: {}", t.read_as, texts::reading(lang, verdict.reading));
        }
        for (condition, is) in verdict.conditions.iter().zip(&entries) {
            let _ = writeln!(text, "  {} {}", if *is { '✓' } else { '✗' }, texts::condition(lang, condition));
        }
        if let Some(numbers) = texts::own_numbers(lang, verdict) {
            let _ = writeln!(text, "  {numbers}");
        }
        if let Some(carried) = texts::carried(lang, verdict) {
            let _ = writeln!(text, "  {carried}");
        }
        if let Some(off) = ask.off(&verdict.understood).filter(|_| !verdict.right) {
            let _ = writeln!(text, "  {}", said::off(lang, off));
        }
        if let Some(diagnosis) = texts::diagnosis(lang, ask, verdict) {
            let _ = writeln!(text, "  {}", plain(&diagnosis));
        }
        for hint in said::hints(lang, exercise, ask, verdict).iter().take(hints) {
            let _ = writeln!(text, "  {}: {}", words.hint, plain(hint));
        }
    }
    if !unanswered.is_empty() {
        let _ = writeln!(text, "{}: {}", t.not_answered, unanswered.join(", "));
    }
    text
}

/// The name of the picture of a sheet's exercise, beside the sheet, with only letters that LaTeX takes unchanged.
fn beside(sheet: &Path, version: &Version, number: usize) -> String {
    let stem = sheet.file_stem().unwrap_or_default().to_string_lossy();
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '-' };
    let version = version.number.map_or_else(String::new, |version| format!("-{version}"));
    format!("{}{version}-{number}.png", stem.chars().map(plain).collect::<String>())
}

fn sheet(args: &SheetArgs, lang: Lang) -> Result<(), Failure> {
    let own = own(args.numbers.folder.as_deref(), lang)?;
    let (seeds, is_range) = args.numbers.seeds(lang)?;
    let version = |seed: u64| {
        let found = args.ids.iter().map(|id| find_in(&own, id.trim(), &args.numbers, seed, lang));
        let exercises = found.map(|found| found.map(|(_, exercise)| exercise)).collect::<Result<_, _>>()?;
        Ok(Version { number: is_range.then_some(seed), exercises })
    };
    let versions: Vec<Version> = seeds.map(version).collect::<Result<_, Failure>>()?;
    say_faults(&own, lang);
    let written = written(args.numbers.lang);
    if args.output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("xml")) {
        let all = exercises::with_own(&own.entries);
        let by_id: BTreeMap<&str, &Entry> = all.map(|entry| (&*entry.id, entry)).collect();
        // All versions of an exercise stand together.
        let of = |k: usize| versions.iter().filter_map(move |version| version.exercises.get(k));
        let sheet = (0..args.ids.len()).flat_map(of);
        let sheet: Vec<(&Entry, &Exercise)> = sheet
            .filter_map(|exercise| {
                Some((by_id.get(exercise.id.as_str()).copied().or_else(|| exercises::entry(&exercise.id))?, exercise))
            })
            .collect();
        let (text, left_out) = moodle(written, &sheet);
        left_out.iter().for_each(|title| say(&said::no_question(lang, title)));
        return save(&args.output, text.as_bytes(), None, lang);
    }
    let answers = if args.answers { Solutions::AtEnd } else { Solutions::None };
    write_sheet((&versions, answers), &args.output, written, lang)?;
    args.solutions.as_ref().map_or(Ok(()), |path| write_sheet((&versions, Solutions::Alone), path, written, lang))
}

/// Writes the versions of a sheet in the format given by the ending of the file.
fn write_sheet(
    (versions, answers): (&[Version], Solutions),
    output: &Path,
    written: Lang,
    lang: Lang,
) -> Result<(), Failure> {
    let name = sanitize::path(output);
    if output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("pdf")) {
        let options = HandoutOptions { lang: written, columns: 1, answers, plan: false, late: false };
        let made =
            handout::of_exercises(versions, options, |figure, size| to_match(figure, (written, size), &name, lang))?;
        return save_handout(&made, output, lang);
    }
    let picture = |version: &Version, number: usize| beside(output, version, number);
    let text = match output.extension().and_then(|ending| ending.to_str()) {
        Some(ending) if ending.eq_ignore_ascii_case("md") => sheet_of::markdown(written, (versions, answers), &picture),
        Some(ending) if ending.eq_ignore_ascii_case("tex") => sheet_of::latex(written, (versions, answers), &picture),
        _ => return Err(Failure::BadInput(said::sheet_ending(lang, &name))),
    };
    for version in versions.iter().filter(|_| answers != Solutions::Alone) {
        for (number, exercise) in (1..).zip(&version.exercises) {
            if let Some(figure) = exercise.figure_to_match() {
                save_picture(&output.with_file_name(picture(version, number)), &figure, written, lang)?;
            }
        }
    }
    save(output, text.as_bytes(), None, lang)
}

/// Packs exercises as a lesson with a step for each.
fn package(args: &PackageArgs, lang: Lang) -> Result<(), Failure> {
    let (seed, written) = (args.seed(lang)?, written(args.lang));
    let in_both = |text: &dyn Fn(Lang) -> String| {
        let mut both = Localized::default();
        Lang::ALL.into_iter().for_each(|lang| *camera_lab_words::told_mut(lang, &mut both) = text(lang));
        both
    };
    let title = in_both(&|lang| said::texts(lang).exercises.to_owned());
    let (mut text, mut made) = (String::new(), None);
    for id in &args.ids {
        let id = id.trim();
        let entry = exercises::entry(id).ok_or_else(|| {
            let all = exercises::entries().map(|entry| &*entry.id);
            Failure::BadInput(said::unknown_exercise(lang, id, nearest(all, id)))
        })?;
        let exercise = entry.exercise(seed, &Default::default());
        let title_of = in_both(&|lang| texts::exercise_title(lang, &exercise).to_owned());
        let draft = Draft { lesson: title.clone(), title: title_of };
        let step = with_step(&text, &format!("exercises-{seed}"), &draft, &exercise.subject.figure);
        let bad = |error: &FigureError| Failure::BadInput(messages::figure(lang, error));
        text = step.map_err(|error| bad(&error))?.0;
        // Both are names without quotes.
        let _ = write!(text, "\n[step.ask]\nexercise = \"{id}\"\nseed = {seed}\n");
        made = Some(parse_bytes(text.as_bytes()).map_err(|error| bad(&error))?);
    }
    // There is at least one exercise.
    made.map_or(Ok(()), |lesson| args.packed.write(&lesson, &text, (written, lang)))
}

/// Reports the mistakes of a class. A file that holds no progress is named in the report, and is no error.
fn report(args: &ReportArgs, lang: Lang) -> Result<(), Failure> {
    let written = written(args.lang);
    if let Some(output) = &args.output {
        if PictureFormat::of(output) != Some(PictureFormat::Pdf) {
            return Err(Failure::BadInput(class::ending(lang, &sanitize::path(output))));
        }
        return save_handout(&ClassReport::of_files(&args.files, written).handout(written), output, lang);
    }
    let report = ClassReport::of_files(&args.files, written);
    let text = match args.format {
        DataFormat::Json => json_text(&report.json()),
        DataFormat::Csv => report.csv(),
        DataFormat::Text => report.text(written),
    };
    print(text.as_bytes(), lang)
}
