//! `camera-lab lesson`: lessons, their steps, and their pictures.

mod step_pictures;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::{Value, json};

use super::render::{no_picture, save, save_handout};
use super::{Failure, Opening, nearest, print, say, say_left_out};
use crate::camera::Camera;
use crate::cli::args::exercise::ListArgs;
use crate::cli::args::figure::size;
use crate::cli::args::lesson::{
    CheckArgs, LessonArgs, LessonCommand, LessonRenderArgs, PackageArgs, PageArgs, PlayArgs, ShowArgs, WhichArgs,
};
use crate::cli::args::package::{of_file, page_of};
use crate::cli::args::words::{LangArg, TableFormat, written};
use crate::cli::lesson::step_pictures::{Found, composite, files_of, scene, size_of};
use crate::exercises::Entry;
use crate::export::format::PictureFormat;
use crate::figure::Figure;
use crate::figure::write::to_toml;
use crate::inspect::json_text;
use crate::lessons::{
    Goal, Lesson, Link, OpenLesson, Part, Question, Seen, Step, Subject, Task, exercise_minutes, exercises_of,
    families_of, objects_named, place, shipped,
};
use crate::picture::{self, Composite, FileOptions};
use crate::progress::{Progress, at_once};
use crate::sanitize;
use crate::scene::Scene;
use camera_lab_files::hand_out;
use camera_lab_files::share::{self, Held, fragment};
use camera_lab_files::{self as files, FileError};
use camera_lab_words::handout::{self, HandoutOptions, Scenes, Solutions, views_of};
use camera_lab_words::learn::lessons as texts;
use camera_lab_words::{Lang, command_line, messages, pictures};

/// Runs the command. For `play`, returns the options with which the window opens.
pub(super) fn run(args: &LessonArgs, lang: Lang) -> Result<Option<Box<Opening>>, Failure> {
    match &args.command {
        LessonCommand::List(args) => list(args, lang)?,
        LessonCommand::Show(args) => show(args, lang)?,
        LessonCommand::Check(args) => check(args, lang)?,
        LessonCommand::Render(args) => render(args, lang)?,
        LessonCommand::Package(args) => package(args, lang)?,
        LessonCommand::Page(args) => page(args, lang)?,
        LessonCommand::Play(args) => return play(args, lang).map(Some),
    }
    Ok(None)
}

/// The lesson with an identifier, or in a file.
fn find(args: &WhichArgs, lang: Lang) -> Result<Found, Failure> {
    // For the built-in lessons, as in the address of a page.
    let of_address = args.id.rsplit_once("?lesson=").and_then(|(_, asked)| asked.split(['&', '#']).next());
    let id = of_address.unwrap_or(&args.id);
    if let Some(shipped) = shipped().iter().find(|shipped| shipped.lesson.id == id) {
        return Ok(Found { lesson: shipped.lesson.clone(), path: None });
    }
    let path = PathBuf::from(&args.id);
    let is_name = share::link_of(&path).is_none() && !args.id.contains(['.', '/', '\\']);
    if is_name && !path.exists() {
        let near = nearest(shipped().iter().map(|shipped| &*shipped.lesson.id), &args.id);
        return Err(Failure::BadInput(texts::unknown(lang, &args.id, near)));
    }
    let (lesson, _) = read(&path, lang)?;
    Ok(Found { lesson: Arc::new(lesson), path: Some(path) })
}

fn read(path: &Path, lang: Lang) -> Result<(Lesson, String), Failure> {
    files::read_lesson(path).map_err(|error| of_file(path, &error, lang))
}

/// Packs a lesson. A built-in one is in the page already.
fn package(args: &PackageArgs, lang: Lang) -> Result<(), Failure> {
    let Found { lesson, path } = find(&args.which, lang)?;
    let text = path.map(|path| with_files(&path, &lesson, (&args.packed.output, lang))).transpose()?;
    let opened = text.as_deref().unwrap_or(&lesson.id);
    args.packed.write(&lesson, opened, (written(args.which.lang), lang))
}

/// The text of a lesson file, with the files that its figures name, for the file to write.
fn with_files(path: &Path, lesson: &Lesson, (output, lang): (&Path, Lang)) -> Result<String, Failure> {
    let text = read(path, lang)?.1;
    hand_out::lesson_with_files(&text, lesson, Some(path)).map_err(|error| of_file(output, &error, lang))
}

/// Writes the page that opens with a lesson.
fn page(args: &PageArgs, lang: Lang) -> Result<(), Failure> {
    let Found { lesson, path } = find(&args.which, lang)?;
    let page = page_of(&args.page, lang)?;
    let opens = match path {
        Some(path) => fragment(Held::Lesson, &with_files(&path, &lesson, (&args.output, lang))?),
        None => hand_out::of_shipped(&lesson.id),
    };
    save(&args.output, hand_out::page_with(&page, &opens).as_bytes(), None, lang)
}

fn list(args: &ListArgs, lang: Lang) -> Result<(), Failure> {
    let written = written(args.lang);
    let own = match &args.folder {
        Some(folder) => files::read_lessons(folder).map_err(|error| of_file(folder, &error, lang))?,
        None => files::OwnLessons::default(),
    };
    own.faults.iter().for_each(|(path, error)| say(&messages::file(lang, &sanitize::path(path), error)));
    let of_program = shipped().iter().map(|shipped| (&shipped.lesson, None));
    let all = of_program.chain(own.lessons.iter().map(|(path, lesson)| (lesson, Some(path))));
    let lines: Vec<Value> = all
        .map(|(lesson, path)| {
            json!({
                "id": lesson.id,
                "title": texts::told(written, &lesson.title),
                "minutes": lesson.minutes,
                "exercise_minutes": exercise_minutes(lesson),
                "families": families_of(lesson),
                "exercises": exercises_of(lesson),
                "steps": lesson.steps.len(),
                "file": path.map(|path| path.to_string_lossy()),
            })
        })
        .collect();
    let text = match args.format {
        TableFormat::Json => json_text(&Value::Array(lines)),
        TableFormat::Text => lines.iter().map(|line| texts::line(written, line)).collect(),
    };
    print(text.as_bytes(), lang)
}

fn show(args: &ShowArgs, lang: Lang) -> Result<(), Failure> {
    let Found { lesson, .. } = find(&args.which, lang)?;
    let written = written(args.which.lang);
    let text = match args.format {
        TableFormat::Json => json_text(&described(written, &lesson)),
        // Line by line: the lines are ours.
        TableFormat::Text => {
            texts::to_read(written, &lesson).split('\n').map(sanitize::printable).collect::<Vec<_>>().join("\n")
        }
    };
    print(text.as_bytes(), lang)
}

/// The JSON output for a lesson.
fn described(lang: Lang, lesson: &Lesson) -> Value {
    json!({
        "id": lesson.id,
        "title": texts::told(lang, &lesson.title),
        "sentence": lesson.sentence.as_ref().map(|text| texts::told(lang, text)),
        "minutes": lesson.minutes,
        "aims": lesson.aims.iter().map(|text| texts::told(lang, text)).collect::<Vec<_>>(),
        "plan": lesson.plan.as_ref().map(|text| texts::told(lang, text).trim()),
        "pretest": ids(&lesson.pretest),
        "pretest_seeds": seeds(&lesson.pretest),
        "posttest": ids(&lesson.posttest),
        "posttest_seeds": seeds(&lesson.posttest),
        "before": lesson.before,
        "steps": lesson.steps.iter().map(|step| described_step(lang, step)).collect::<Vec<_>>(),
    })
}

fn ids(questions: &[Question]) -> Vec<&str> {
    questions.iter().map(|question| question.id.as_str()).collect()
}

/// The sources of the numbers of questions, in the same order.
fn seeds(questions: &[Question]) -> Vec<u64> {
    questions.iter().map(|question| question.seed).collect()
}

fn described_step(lang: Lang, step: &Step) -> Value {
    let mut object = json!({
        "title": texts::told(lang, &step.title),
        "text": texts::text(lang, step),
        "figure": to_toml(&step.figure),
        "seconds": step.seconds,
    });
    match &step.task {
        Some(Task::Exercise { id, seed }) => object["ask"] = json!({ "id": id, "seed": seed }),
        Some(Task::Question(entry)) => object["ask"] = asked(lang, entry),
        Some(Task::Try(goal)) => object["try"] = tried(lang, step, goal),
        None => {}
    }
    if let Some(notes) = texts::notes(lang, step) {
        object["notes"] = json!(notes);
    }
    if !step.links.is_empty() {
        object["links"] = step.links.iter().map(linked).collect();
    }
    object
}

fn asked(lang: Lang, entry: &Entry) -> Value {
    let exercise = entry.exercise(0, &Default::default());
    let asks = exercise.asks.iter().map(|ask| super::exercise::asked(lang, &exercise, ask)).collect::<Vec<_>>();
    json!({ "id": entry.id, "seed": 0, "asks": asks })
}

fn tried(lang: Lang, step: &Step, goal: &Goal) -> Value {
    let way = goal.way.iter().map(|(key, value)| format!("{key}={value}")).collect::<Vec<_>>();
    json!({ "text": texts::filled(lang, &goal.text, &step.figure), "way": way })
}

fn linked(link: &Link) -> Value {
    match link {
        Link::Note(note) => json!({ "note": note }),
        Link::Exercise(id, seed) => json!({ "exercise": id, "seed": seed }),
        Link::Lesson(id, step) => json!({ "lesson": id, "step": step + 1 }),
    }
}

fn check(args: &CheckArgs, lang: Lang) -> Result<(), Failure> {
    let mut faults = Vec::new();
    let mut read = Vec::new();
    for path in &args.files {
        match files::read_lesson(path) {
            Err(error) => faults.push(messages::file(lang, &messages::opened(lang, path), &error)),
            Ok((lesson, text)) => read.push((path, lesson, text)),
        }
    }
    let of_program = shipped().iter().map(|shipped| shipped.lesson.id.as_str());
    let ids: Vec<&str> = of_program.chain(read.iter().map(|(_, lesson, _)| lesson.id.as_str())).collect();
    for (path, lesson, text) in &read {
        let name = messages::opened(lang, path);
        for key in missing_of(lesson) {
            let line = place(text, Part::Head).map(|(line, _)| line);
            say(&command_line::in_file(lang, &name, line, &texts::no_part(lang, key)));
        }
        for (part, say) in faults_of(lesson, &ids, Some(path), args.allow_files, lang) {
            // The text has been read, so it's there.
            let (line, key) = place(text, part).map_or((None, String::new()), |(line, key)| (Some(line), key));
            faults.push(command_line::in_file(lang, &name, line, &say(&key)));
        }
    }
    match faults.pop() {
        None => print(texts::all_good(lang, args.files.len()).as_bytes(), lang),
        Some(last) => {
            faults.iter().for_each(|fault| say(fault));
            Err(Failure::BadInput(last))
        }
    }
}

/// A fault: its place, and its message, which begins with a key.
type Fault = (Part, Box<dyn Fn(&str) -> String>);

/// The parts that a lesson needs so that another lecturer can teach it. It's good without them, and plays.
fn missing_of(lesson: &Lesson) -> impl Iterator<Item = &'static str> {
    let parts =
        [("aims", lesson.aims.is_empty()), ("plan", lesson.plan.is_none()), ("sentence", lesson.sentence.is_none())];
    parts.into_iter().filter(|(_, is_missing)| *is_missing).map(|(key, _)| key)
}

/// The faults of a lesson that only its scenes show, and its links.
fn faults_of(lesson: &Lesson, ids: &[&str], path: Option<&PathBuf>, allow_files: bool, lang: Lang) -> Vec<Fault> {
    let mut faults: Vec<Fault> = Vec::new();
    let mut seen = Seen::default();
    for unknown in lesson.before.iter().filter(|id| !ids.contains(&id.as_str())) {
        let unknown = unknown.clone();
        faults.push((Part::Before, Box::new(move |key| texts::no_lesson(lang, key, &unknown))));
    }
    for (k, step) in lesson.steps.iter().enumerate() {
        for (number, link) in step.links.iter().enumerate() {
            let part = Part::Link(k, number);
            match link.clone() {
                Link::Lesson(id, _) if !ids.contains(&id.as_str()) => {
                    faults.push((part, Box::new(move |key| texts::no_lesson(lang, key, &id))));
                }
                Link::Lesson(id, step) if steps_of(&id).is_some_and(|count| step >= count) => {
                    let count = steps_of(&id).unwrap_or_default();
                    faults.push((part, Box::new(move |key| texts::no_step_of(lang, key, step + 1, count))));
                }
                Link::Note(id) if camera_lab_words::why::notes::note(lang, &id).is_none() => {
                    faults.push((part, Box::new(move |key| texts::no_note(lang, key, &id))));
                }
                _ => {}
            }
        }
        match scene(&step.figure, path, allow_files, lang) {
            Err(why) => faults.push((Part::Step(k), Box::new(move |key| format!("{key}: {why}")))),
            Ok((scene, missing)) => {
                for why in missing {
                    faults.push((Part::Step(k), Box::new(move |key| format!("{key}: {why}"))));
                }
                if let Some(Task::Try(goal)) = &step.task {
                    let after = |figure: &Figure| Some(self::scene(figure, path, allow_files, lang).ok()?.0);
                    faults.extend(faults_of_goal(goal, (k, &step.figure), (&scene, &after), &mut seen, lang));
                }
            }
        }
    }
    faults
}

/// The number of steps of a built-in lesson.
fn steps_of(id: &str) -> Option<usize> {
    shipped().iter().find(|shipped| shipped.lesson.id == id).map(|shipped| shipped.lesson.steps.len())
}

/// Gives the scene of a figure, if it can be built.
type SceneOf<'a> = &'a dyn Fn(&Figure) -> Option<Scene>;

/// The faults of the goal of a step with a scene. `scene_after` gives that of a figure, which the way may change.
fn faults_of_goal(
    goal: &Goal,
    (k, figure): (usize, &Figure),
    (scene, scene_after): (&Scene, SceneOf<'_>),
    seen: &mut Seen,
    lang: Lang,
) -> Vec<Fault> {
    let mut faults: Vec<Fault> = Vec::new();
    for (number, condition) in goal.until.iter().enumerate() {
        let unknown = condition.object().filter(|name| objects_named(scene, name).next().is_none());
        let Some(name) = unknown.map(str::to_owned) else { continue };
        let names: Vec<String> = scene.objects.iter().map(|object| object.name.clone()).collect();
        let say = move |key: &str| {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            command_line::no_such_object(lang, key, &name, &names)
        };
        faults.push((Part::Condition(k, number), Box::new(say)));
    }
    let Ok(camera) = Camera::new(&figure.camera) else { return faults };
    if !faults.is_empty() {
        // A goal about unknown objects can't be checked any further.
        return faults;
    }
    if goal.is_reached(Subject { figure, camera: &camera, scene }, seen) {
        faults.push((Part::Until(k), Box::new(move |key| texts::reached_already(lang, key))));
    }
    if !goal.way.is_empty()
        && let Ok(after) = goal.reached_from(figure, &camera)
        && let Some(scene) = scene_after(&after.figure)
        && !goal.is_reached(Subject { figure: &after.figure, camera: &after.camera, scene: &scene }, seen)
    {
        faults.push((Part::Way(k), Box::new(move |key| texts::not_reached(lang, key))));
    }
    faults
}

fn write_handout(args: &LessonRenderArgs, found: &Found, lang: Lang) -> Result<(), Failure> {
    let columns = if args.per_page(lang)? > 2 { 2 } else { 1 };
    let written = written(args.which.lang);
    let answers = if args.answers { Solutions::AtEnd } else { Solutions::None };
    let options = HandoutOptions { lang: written, columns, answers, plan: args.plan, late: false };
    let mut scenes = Scenes::default();
    let draw = |step: (usize, &Step), size| composite(args, (found, &mut scenes), step, size, lang);
    let made = handout::of_lesson(&found.lesson, options, draw)?;
    save_handout(&made, &args.output, lang)
}

fn render(args: &LessonRenderArgs, lang: Lang) -> Result<(), Failure> {
    let size = size(args.size.as_deref(), lang)?;
    let found = find(&args.which, lang)?;
    // The output is a handout, and not a folder of pictures.
    let is_handout = args.output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("pdf"));
    if let Some(option) = args.unused(is_handout) {
        return Err(Failure::BadInput(texts::unused_option(lang, option, is_handout)));
    }
    if is_handout {
        return write_handout(args, &found, lang);
    }
    // A folder of pictures with the name of a picture is a slip.
    if args.output.extension().is_some() && PictureFormat::of(&args.output).is_some() {
        return Err(Failure::BadInput(texts::output_name(lang, &sanitize::path(&args.output))));
    }
    let lesson = &found.lesson;
    let written = written(args.which.lang);
    let format = args.format.unwrap_or(PictureFormat::Png);
    let digits = lesson.steps.len().to_string().len().max(2);
    // If a step is faulty, no file is written.
    let (mut made, mut scenes) = (Vec::new(), Scenes::default());
    for (k, step) in lesson.steps.iter().enumerate() {
        let name = format!("{:0digits$}-{}.{}", k + 1, lesson.id, format.ending());
        let output = args.output.join(name);
        let views = args.view.unwrap_or_else(|| views_of(&step.figure));
        let sheet = composite(args, (&found, &mut scenes), (k, step), size_of(size, views), lang)?;
        let (text, left_out) = files::text_in_picture(
            to_toml,
            &step.figure,
            files_of(found.path.as_deref(), args.which.allow_files),
            &output,
        );
        say_left_out(left_out, &output, lang);
        let told = pictures::told_of(written, &step.figure, &sheet, text).for_file(&output);
        let options = FileOptions::of(format);
        let file = at_once(picture::file(&sheet, options, &told, &Progress::default()));
        let file = file.map_err(|error| no_picture(lang, &sanitize::path(&output), error, pixels_of(&sheet)))?;
        made.push((output, file));
    }
    fs::create_dir_all(&args.output).map_err(|error| {
        Failure::Failed(messages::file(lang, &sanitize::path(&args.output), &FileError::Write(error)))
    })?;
    made.into_iter().try_for_each(|(output, file)| save(&output, &file.bytes, file.beside, lang))
}

fn pixels_of(sheet: &Composite) -> [u64; 2] {
    sheet.requests.first().map_or([0; 2], |request| [request.size.width, request.size.height].map(u64::from))
}

fn play(args: &PlayArgs, lang: Lang) -> Result<Box<Opening>, Failure> {
    let Found { lesson, path } = find(&args.which, lang)?;
    let step = args.step(lesson.steps.len(), lang)?;
    let asked_lang = args.which.lang.map(LangArg::lang);
    Ok(Box::new(opening(OpenLesson { lesson, path, step }, args.which.allow_files, (lang, asked_lang))))
}

/// The window that plays the lesson in a file or a link.
///
/// # Errors
/// If it can't be read, or holds no lesson.
pub(super) fn opened(path: &Path, allow_files: bool, langs: (Lang, Option<Lang>)) -> Result<Opening, Failure> {
    let (lesson, _) = read(path, langs.0)?;
    Ok(opening(OpenLesson { lesson: Arc::new(lesson), path: Some(path.to_owned()), step: 0 }, allow_files, langs))
}

fn opening(open: OpenLesson, allow_files: bool, (lang, asked_lang): (Lang, Option<Lang>)) -> Opening {
    let figure = open.lesson.steps.get(open.step).map_or_else(Figure::default, |step| (*step.figure).clone());
    Opening { figure, file: None, allow_files, lang, asked_lang, lesson: Some(open), later: None, page_address: None }
}
