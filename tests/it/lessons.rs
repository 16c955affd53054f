//! Lessons: the format, the command line, and every step of the lessons of the program.
#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::camera::{Camera, Convention, Projection};
use camera_lab::exercises::{self, Expected, ExpectedAnswer, Kind};
use camera_lab::figure::variation::varied_by;
use camera_lab::figure::write::to_toml;
use camera_lab::figure::{Figure, WorldPart, read};
use camera_lab::formula;
use camera_lab::lessons::{Link, Seen, Subject, Task, families_of, lesson_of, objects_named, parse, shipped};
use camera_lab::picture::Paragraph;
use camera_lab::scene::no_files;
use camera_lab::views::{Request, SharedScene, Size, View, Views, scene_of};
use camera_lab_words::handout::{self, HandoutOptions, Solutions};
use camera_lab_words::learn::{exercise_sheet, exercises as said, lessons as words};
use camera_lab_words::pictures::labels;
use camera_lab_words::why::notes;
use camera_lab_words::{Lang, messages, told};

use crate::common::program::Bench;
use crate::views::draw;

const LESSON: &str = r#"
id = "small"
title = { en = "Small", pt-BR = "Pequena" }
[[step]]
title = "One"
text.en = "D is {distance}."
text.pt-BR = "D é {distance}."
[step.camera]
position = [0, 0, 5]
near = 1
[step.show]
measure = ["F"]
stage = "clip"
[[step]]
title = "Two"
text = "$F = {camera.near}$"
without = ["show.stage"]
seconds = 0
[step.camera]
near = 2
[step.ask]
text = "Is F {camera.near}?"
choices = { yes = { en = "it is", pt-BR = "é" }, no = "no" }
answer = "yes"
[[step.ask.mistake]]
answer = "no"
message = "It is."
"#;

#[test]
fn a_step_keeps_all_of_the_steps_before_except_its_changes() {
    let lesson = parse(LESSON).unwrap();
    let [one, two] = &lesson.steps[..] else { panic!("two steps") };
    assert_eq!((one.figure.camera.near, two.figure.camera.near), (1.0, 2.0));
    assert_eq!(one.figure.camera.position, two.figure.camera.position);
    assert_eq!(one.figure.show.measure, two.figure.show.measure);
    assert!(one.figure.show.stage.is_some() && two.figure.show.stage.is_none());
    assert_eq!((one.seconds, two.seconds), (1.5, 0.0));
    assert_eq!(words::text(Lang::PtBr, one), "D é 5.");
    assert_eq!(words::text(Lang::En, two), "$F = 2$");
    let Some(Task::Question(entry)) = &two.task else { panic!("a question") };
    let exercise = entry.exercise(0, &Default::default());
    let ask = &exercise.asks[0];
    assert_eq!(camera_lab_words::learn::exercises::ask(Lang::En, &exercise, ask), "Is F 2?");
    assert!(exercises::check(entry, &exercise, ask, "yes").unwrap().right);
    let wrong = exercises::check(entry, &exercise, ask, "no").unwrap();
    assert!(!wrong.right);
    assert!(camera_lab_words::learn::exercises::diagnosis(Lang::En, ask, &wrong).unwrap().contains("It is."));
}

#[test]
fn faults_name_line_and_key() {
    for (from, to, line, key) in [
        ("near = 1", "neer = 1", 10, "[step.camera] neer"),
        ("near = 2", "near = 0", 20, "[step.camera] near"),
        ("{distance}.\"\ntext.pt", "{distence.x}.\"\ntext.pt", 6, "[[step]] text"),
        ("without = [\"show.stage\"]", "without = [\"show.painted\"]", 17, "[[step]] without"),
        ("answer = \"yes\"", "answer = \"maybe\"", 24, "[step.ask] answer"),
        ("seconds = 0", "seconds = 99", 18, "[[step]] seconds"),
        ("title = \"Two\"", "title = \"Two\"\nlinks = [{ exercise = \"nope\" }]", 16, "[[step.links]] exercise"),
        ("title = \"Two\"", "titel = \"Two\"", 14, "[[step]] title"),
    ] {
        assert!(LESSON.contains(from), "{from}");
        let error = parse(&LESSON.replacen(from, to, 1)).unwrap_err();
        assert_eq!((error.line, error.key.as_str()), (line, key), "{to}: {error}");
    }
    let endless = format!("id = \"a\"\ntitle = \"A\"\n{}", "[[step]]\ntitle = \"B\"\ntext = \"C\"\n".repeat(101));
    assert_eq!(parse(&endless).unwrap_err().key, "[[step]]");
    assert_eq!(parse("id = \"a\"\ntitle = \"A\"\n").unwrap_err().key, "step");
}

/// A lesson of one step with a goal, its condition in the last line.
fn with_goal(condition: &str) -> String {
    format!(
        "id = \"goal\"\ntitle = \"G\"\n[[step]]\ntitle = \"One\"\ntext = \"Now you.\"\n[step.scene]\npreset = \"house\"\n\
         [step.show]\nstep = {{ way = \"notes\", at = 0 }}\n[step.try]\ntext = \"Do it.\"\n[[step.try.until]]\n{condition}\n"
    )
}

#[test]
fn goals_are_about_visibility_numbers_and_every_key_of_the_figure() {
    let mut seen = Seen::default();
    for (condition, way) in [
        ("key = \"style.visibility\"\nis = \"painter\"", &["style.visibility=painter"][..]),
        ("key = \"style.antialias\"\nis = 16", &["style.antialias=16"]),
        ("key = \"reveal.clipping\"\nis = true", &["reveal.clipping=true"]),
        ("key = \"reveal.depth\"\nis = \"linear\"", &["reveal.depth=linear"]),
        ("key = \"show.step.at\"\nleast = 2", &["show.step.at=2.5"]),
        // A way without a place has gone to its end.
        ("key = \"show.step.at\"\nleast = 2", &["show.step.at="]),
        ("key = \"show.stage\"\nis = \"clip\"", &["show.stage=clip"]),
        ("key = \"show.measure\"\nis = [\"F\", \"B\"]", &["show.measure=[\"F\", \"B\"]"]),
        ("key = \"show.painted\"\nmost = 0.5", &["show.painted=0.25"]),
        ("key = \"observers.world.elevation\"\nleast = \"60°\"", &["observers.world.elevation=75"]),
        ("key = \"scene.preset\"\nis = \"cube\"", &["scene.preset=cube"]),
        ("quantity = \"camera.view_angle\"\nleast = \"2atan(1)\"", &["camera.view_angle=100"]),
        ("angle = [\"camera.view_up\", \"dop\"]\nmost = \"30°\"", &["camera.view_up=[-3, -4, -4]"]),
        ("hidden = \"door\"", &["azimuth=150"]),
    ] {
        let lesson = parse(&with_goal(condition)).unwrap_or_else(|error| panic!("{condition}: {error}"));
        let step = &lesson.steps[0];
        let Some(Task::Try(goal)) = &step.task else { panic!("a goal") };
        let mut holds = |figure: &Figure, camera: &Camera| {
            let scene = scene_of(figure, &mut no_files, &Default::default()).unwrap();
            goal.is_reached(Subject { figure, camera, scene: &scene }, &mut seen)
        };
        let camera = Camera::new(&step.figure.camera).unwrap();
        assert!(!holds(&step.figure, &camera), "{condition}");
        let way: Vec<(&str, &str)> = way.iter().filter_map(|way| way.split_once('=')).collect();
        let after = varied_by(&step.figure, &camera, &way, Convention::RightHand).unwrap();
        assert!(holds(&after.figure, &after.camera), "{condition}: {way:?}");
    }
}

#[test]
fn faulty_goals_name_line_and_key() {
    for (condition, line, key, told) in [
        ("key = \"style.visibilty\"\nis = \"painter\"", 13, "key", "visibility"),
        ("key = \"stile.visibility\"\nis = \"painter\"", 13, "key", "style"),
        ("key = \"style.visibility\"\nis = \"painting\"", 14, "is", "depth-buffer"),
        ("key = \"reveal.clipping\"\nis = 3", 14, "is", "true"),
        ("key = \"style.shading\"\nleast = 3", 14, "least", "gouraud"),
        ("key = \"show.painted\"\nmost = 7", 14, "most", "from 0 to 1"),
        ("key = \"show.painted\"", 12, "is", "least and most"),
        ("key = \"show.painted\"\nis = 0.5\nleast = 0", 14, "is", "least and most"),
        ("key = \"show.painted\"\nseen = \"door\"", 12, "quantity", "hidden"),
        ("angle = [\"dop\"]\nmost = 30", 13, "angle", "two vectors"),
        ("angle = [\"dop\", \"distance\"]\nmost = 30", 13, "angle", "two vectors"),
        ("angle = [\"dop\", \"basis.n\"]", 12, "least", "number"),
        ("quantity = \"basis.w\"\nmost = 30", 13, "quantity", "basis.u"),
    ] {
        let error = parse(&with_goal(condition)).unwrap_err();
        assert_eq!((error.line, &*error.key), (line, &*format!("[step.try] until.{key}")), "{condition}");
        let said = messages::figure(Lang::En, &error);
        assert!(said.contains(told), "{condition}: {said}");
    }
}

#[test]
fn the_lessons_of_the_guides_are_good() {
    for (guide, heading) in [("lecturer.en.md", "## Lessons"), ("lecturer.pt-BR.md", "## Lições")] {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(guide);
        let text = std::fs::read_to_string(path).unwrap();
        let (_, section) = text.split_once(heading).unwrap();
        let (_, example) = section.split_once("```toml\n").unwrap();
        let (example, _) = example.split_once("```").unwrap();
        // The first two steps show all that a step may say. No step before has `show.measure`.
        let lesson =
            parse(&example.replace("without = [\"show.measure\"]", "")).unwrap_or_else(|e| panic!("{guide}: {e}"));
        assert_eq!(lesson.steps.len(), 3);
    }
}

#[test]
fn every_step_of_the_lessons_of_the_program_is_good() {
    assert_eq!(shipped().len(), 20, "each file is a lesson");
    let ids: Vec<&str> = shipped().iter().map(|shipped| shipped.lesson.id.as_str()).collect();
    let mut seen = Seen::default();
    for lesson in shipped().iter().map(|shipped| &shipped.lesson) {
        let id = &lesson.id;
        assert!((7..=13).contains(&lesson.steps.len()), "{id}");
        assert!(lesson.minutes.is_some() && !lesson.aims.is_empty() && lesson.sentence.is_some(), "{id}");
        assert!(lesson.before.iter().all(|before| ids.contains(&before.as_str())), "{id}");
        let asked = lesson.steps.iter().take(2).any(|step| matches!(step.task, Some(Task::Question(_))));
        assert!(asked, "{id} begins with a question");
        let exercises = lesson.steps.iter().filter(|step| matches!(step.task, Some(Task::Exercise { .. }))).count();
        assert!(exercises >= 2, "{id} ends with exercises");
        for (k, step) in lesson.steps.iter().enumerate() {
            let place = format!("{id}, step {}", k + 1);
            let again = read::parse(&to_toml(&step.figure)).unwrap_or_else(|error| panic!("{place}: {error}"));
            assert_eq!(again, *step.figure, "{place} opens by itself");
            for lang in [Lang::En, Lang::PtBr] {
                let text = words::text(lang, step);
                assert!(!text.contains('{') || text.contains('$'), "{place}: {text}");
                formula::check(&text).unwrap_or_else(|error| panic!("{place}: {error}"));
                assert!(told(lang, &step.title).chars().count() <= 60, "{place}");
                for link in &step.links {
                    match link {
                        Link::Note(note) => assert!(notes::note(lang, note).is_some(), "{place}: {note}"),
                        Link::Lesson(other, step) => {
                            let other = shipped().iter().find(|shipped| shipped.lesson.id == *other);
                            assert!(other.is_some_and(|other| *step < other.lesson.steps.len()), "{place}: {link:?}");
                        }
                        Link::Exercise(..) => {}
                    }
                }
            }
            let camera = Camera::new(&step.figure.camera).unwrap();
            let scene = scene_of(&step.figure, &mut no_files, &Default::default());
            match &step.task {
                Some(Task::Question(entry)) => {
                    let exercise = entry.exercise(0, &Default::default());
                    let ask = &exercise.asks[0];
                    let right = exercise_sheet::answer(Lang::En, ask);
                    let right = camera_lab_words::learn::exercises::typed_choice(ask, &right).to_owned();
                    assert!(exercises::check(entry, &exercise, ask, &right).unwrap().right, "{place}: {right}");
                    if ask.places {
                        assert!((1..=3).contains(&ask.own_mistakes.len()), "{place}: typical wrong marks");
                        for own in &ask.own_mistakes {
                            let ExpectedAnswer::Numbers(wrong) = &own.answer else { panic!("{place}: {own:?}") };
                            let off = 0.3 * ask.tolerance;
                            let mark = format!("({}, {})", wrong.entries[0] + off, wrong.entries[1] - off);
                            let judged = exercises::check(entry, &exercise, ask, &mark).unwrap();
                            assert!(!judged.right, "{place}: {mark}");
                            let found = judged.diagnosis.and_then(|diagnosis| diagnosis.own);
                            assert_eq!(found.as_ref(), Some(own), "{place}: {mark}");
                        }
                    }
                    let (Expected::Choice(right, ..), Kind::Choice(choices)) = (ask.expected(), &ask.kind) else {
                        continue;
                    };
                    for (_, wrong) in choices.iter().enumerate().filter(|(k, _)| k != right) {
                        let judged = exercises::check(entry, &exercise, ask, wrong).unwrap();
                        for lang in [Lang::En, Lang::PtBr] {
                            let said =
                                camera_lab_words::learn::exercises::diagnosis(lang, ask, &judged).unwrap_or_default();
                            assert!(said.chars().count() > 20, "{place}: {wrong} has no message");
                        }
                    }
                }
                Some(Task::Try(goal)) => {
                    let scene = scene.unwrap();
                    for name in goal.until.iter().filter_map(|condition| condition.object()) {
                        assert!(objects_named(&scene, name).next().is_some(), "{place}: {name}");
                    }
                    let at_first = Subject { figure: &step.figure, camera: &camera, scene: &scene };
                    assert!(!goal.is_reached(at_first, &mut seen), "{place} is reached from the start");
                    let after = goal.reached_from(&step.figure, &camera).unwrap();
                    let scene = scene_of(&after.figure, &mut no_files, &Default::default()).unwrap();
                    let there = Subject { figure: &after.figure, camera: &after.camera, scene: &scene };
                    assert!(!goal.way.is_empty() && goal.is_reached(there, &mut seen), "{place} cannot be reached");
                }
                Some(Task::Exercise { id, .. }) => assert!(exercises::entry(id).is_some(), "{place}"),
                None => {}
            }
        }
    }
}

/// Always to guess the same place gives a third of the points.
#[test]
fn every_mark_has_reasons_for_wrong_places_and_a_second_place() {
    for shipped in shipped() {
        for (k, step) in shipped.lesson.steps.iter().enumerate() {
            let Some(Task::Question(entry)) = &step.task else { continue };
            for ask in entry.exercise(0, &Default::default()).asks.iter().filter(|ask| ask.places) {
                let place = |ask: &exercises::Ask| ask.expected().table().unwrap().entries;
                let (first, second) = (place(ask), place(ask.second.as_deref().unwrap()));
                let apart = (first[0] - second[0]).hypot(first[1] - second[1]);
                let name = format!("{} {}", shipped.lesson.id, k + 1);
                assert!(!ask.own_mistakes.is_empty() && apart > 1.5 * ask.tolerance, "{name}: {apart}");
            }
        }
    }
}

#[test]
fn every_question_with_choices_has_the_reason_of_its_right_answer() {
    for shipped in shipped() {
        for (k, step) in shipped.lesson.steps.iter().enumerate() {
            let Some(Task::Question(entry)) = &step.task else { continue };
            for ask in entry.exercise(0, &Default::default()).asks {
                let has_reason = ask.because.as_ref().is_some_and(|because| because.iter().count() == 2);
                assert!(has_reason || !matches!(ask.kind, Kind::Choice(_)), "{} {}", shipped.lesson.id, k + 1);
            }
        }
    }
}

#[test]
fn right_answers_have_no_favourite_place_among_three() {
    let mut places = [0_usize; 3];
    for step in shipped().iter().flat_map(|shipped| &shipped.lesson.steps) {
        let Some(Task::Question(entry)) = &step.task else { continue };
        let exercise = entry.exercise(0, &Default::default());
        let ask = &exercise.asks[0];
        if let (Expected::Choice(right, ..), Kind::Choice(choices)) = (ask.expected(), &ask.kind)
            && choices.len() == places.len()
        {
            places[*right] += 1;
        }
    }
    let third = places.iter().sum::<usize>() / places.len();
    assert!(places.iter().all(|place| place.abs_diff(third) <= 3), "{places:?}");
}

/// A question names each numbered equation: in its step, in itself, or in the reason of its answer.
#[test]
fn every_numbered_equation_is_asked() {
    let mut asked = std::collections::BTreeSet::new();
    for step in shipped().iter().flat_map(|shipped| &shipped.lesson.steps) {
        let Some(Task::Question(entry)) = &step.task else { continue };
        let exercise = entry.exercise(0, &Default::default());
        let ask = &exercise.asks[0];
        let because = ask.because.as_ref().map(|because| because.en.clone()).unwrap_or_default();
        let text = words::text(Lang::En, step) + &said::ask(Lang::En, &exercise, ask) + &because;
        asked.extend((1..=25).filter(|n| text.contains(&format!("(5.{n})"))));
    }
    let missing: Vec<u8> = (1..=25).filter(|n| !asked.contains(n)).collect();
    assert!(missing.is_empty(), "no question of a lesson names (5.n) for n = {missing:?}");
}

/// A guess at one place doesn't pay in families either: the order of choices comes from the seed.
#[test]
fn families_put_their_choices_in_an_order_of_the_seed() {
    let mut compared = 0;
    for entry in exercises::entries().filter(|entry| entry.is_family) {
        let mut places: Vec<Vec<usize>> = Vec::new();
        for seed in 0..40 {
            let exercise = entry.exercise(seed, &Default::default());
            let choices = exercise.asks.iter().filter(|ask| matches!(ask.kind, Kind::Choice(_)));
            for (n, ask) in choices.enumerate() {
                let (Expected::Choice(right, ..), Kind::Choice(names)) = (ask.expected(), &ask.kind) else { panic!() };
                assert!(exercises::check(entry, &exercise, ask, &names[*right]).unwrap().right, "{} {seed}", entry.id);
                places.resize(places.len().max(n + 1), Vec::new());
                places[n].resize(names.len(), 0);
                places[n][*right] += 1;
            }
        }
        for places in places {
            compared += 1;
            assert!(places.iter().all(|count| *count > 0), "{}: {places:?}", entry.id);
        }
    }
    assert!(compared >= 5, "{compared}");
}

#[test]
fn the_minutes_of_a_lesson_and_of_its_exercises_are_told_apart() {
    let lesson = |id: &str| &shipped().iter().find(|shipped| shipped.lesson.id == id).unwrap().lesson;
    // `view-matrix` and II.
    assert_eq!(words::with_minutes(Lang::En, lesson("view")), "From world to view (9 min, and 28 for the exercises)");
    assert_eq!(words::with_minutes(Lang::PtBr, lesson("view")), "Do mundo à vista (9 min, e 28 para os exercícios)");
}

/// It stands in the file once, and the text of one step shows it again.
#[test]
fn the_sentence_to_keep_is_one_text_shown_twice() {
    for shipped in shipped() {
        let (lesson, id) = (&shipped.lesson, &shipped.lesson.id);
        assert_eq!(shipped.text.matches("**{sentence}**").count(), 2, "{id}: once in each language");
        for (lang, called) in [(Lang::En, "The sentence to keep:"), (Lang::PtBr, "A frase para guardar:")] {
            let sentence = told(lang, lesson.sentence.as_ref().unwrap());
            let texts: Vec<String> = lesson.steps.iter().map(|step| words::text(lang, step)).collect();
            let shown = texts.iter().filter(|text| text.contains(&format!("{called} **{sentence}**")));
            assert_eq!(shown.count(), 1, "{id} {lang:?}");
            assert_eq!(texts.iter().filter(|text| text.contains(called)).count(), 1, "{id} {lang:?}");
        }
    }
    let with = |text: &str| parse(&LESSON.replace("text = \"$F = {camera.near}$\"", &format!("text = \"{text}\"")));
    assert_eq!(words::text(Lang::En, &with("Keep {sentence}!").unwrap().steps[1]), "Keep !", "a lesson without one");
    let sentence = "sentence = { en = \"F is {camera.near}.\", pt-BR = \"F é {camera.near}.\" }\n[[step]]";
    let lesson = LESSON.replacen("[[step]]", sentence, 1).replace("$F = {camera.near}$", "Keep: {sentence}");
    let lesson = parse(&lesson).unwrap();
    assert_eq!(words::text(Lang::PtBr, &lesson.steps[1]), "Keep: F é 2.");
}

#[test]
fn every_exercise_is_reached_by_a_lesson_and_knows_it() {
    let reached: Vec<&str> = shipped().iter().flat_map(|shipped| families_of(&shipped.lesson)).collect();
    for entry in exercises::entries() {
        assert!(!entry.is_family || reached.contains(&&*entry.id), "{}", entry.id);
        let way = lesson_of(&entry.id).unwrap_or_else(|| panic!("{}", entry.id));
        let step = &way.lesson.steps[way.step];
        let asks = matches!(&step.task, Some(Task::Exercise { id, .. }) if *id == entry.id);
        let links = step.links.iter().any(|link| matches!(link, Link::Exercise(id, _) if *id == entry.id));
        assert!(asks || links, "{}: {} {}", entry.id, way.lesson.id, way.step);
    }
    assert!(lesson_of("question-0").is_none());
    // Questions before, in and after a lesson have different numbers.
    for lesson in shipped().iter().map(|shipped| &shipped.lesson) {
        assert!(lesson.plan.is_some() && lesson.pretest.len() == 3 && lesson.posttest.len() == 3, "{}", lesson.id);
        let asked = lesson.steps.iter().filter_map(|step| match &step.task {
            Some(Task::Exercise { id, seed }) => Some((id.clone(), *seed)),
            _ => None,
        });
        let around = lesson.pretest.iter().chain(&lesson.posttest).map(|asked| (asked.id.clone(), asked.seed));
        let mut all: Vec<(String, u64)> = asked.chain(around).collect();
        let count = all.len();
        all.sort();
        all.dedup();
        assert_eq!(all.len(), count, "{}", lesson.id);
        for question in lesson.pretest.iter().chain(&lesson.posttest) {
            let exercise = exercises::entry(&question.id).unwrap().exercise(question.seed, &Default::default());
            assert!(exercise.figure_to_match().is_none(), "{}: {} needs its picture", lesson.id, question.id);
        }
    }
}

/// A lesson about one projection practises that one.
#[test]
fn lessons_about_a_projection_practise_it() {
    let about = [
        ("triangles", Projection::Perspective),
        ("cube", Projection::Perspective),
        ("depth", Projection::Perspective),
        ("w", Projection::Perspective),
        ("parallel", Projection::Parallel),
    ];
    for (id, projection) in about {
        let lesson = &shipped().iter().find(|shipped| shipped.lesson.id == id).unwrap().lesson;
        let asked = lesson.steps.iter().filter_map(|step| match &step.task {
            Some(Task::Exercise { id, seed }) => Some((id.as_str(), *seed)),
            _ => None,
        });
        let around = lesson.pretest.iter().chain(&lesson.posttest).map(|asked| (asked.id.as_str(), asked.seed));
        let of_a_camera = ["pixel", "ndc", "perspective-matrix", "parallel-matrix", "asymmetric-window"];
        for (exercise, seed) in asked.chain(around).filter(|(exercise, _)| of_a_camera.contains(exercise)) {
            let camera = exercises::entry(exercise).unwrap().exercise(seed, &Default::default()).subject.figure.camera;
            assert_eq!(camera.projection, projection, "{id}: {exercise} {seed}");
        }
    }
}

#[test]
fn a_lesson_has_a_plan_and_questions_around_it() {
    let bench = Bench::new("plans");
    let list = bench.run(&["lesson", "list", "--format", "json"]).json();
    let window = list.as_array().unwrap().iter().find(|lesson| lesson["id"] == "window").unwrap();
    assert!(window["families"].as_array().unwrap().contains(&"zoom-or-dolly".into()), "{window}");
    let show = bench.run(&["lesson", "show", "window", "--format", "json", "--lang", "pt-BR"]).json();
    assert!(show["plan"].as_str().unwrap().contains("Mostre"), "{}", show["plan"]);
    for key in ["pretest", "posttest"] {
        let ids = show[key].as_array().unwrap();
        let seeds = show[format!("{key}_seeds")].as_array().unwrap();
        assert!(ids.len() == 3 && seeds.len() == 3, "{show}");
        for (id, seed) in ids.iter().zip(seeds) {
            let seed = seed.to_string();
            bench.run(&["exercise", "show", id.as_str().unwrap(), "--seed", &seed]).done();
        }
    }
    let shown = bench.run(&["exercise", "show", "window", "--format", "json"]).json();
    assert_eq!(shown["lesson"]["id"], "window", "{shown}");
    let read = String::from_utf8(bench.run(&["exercise", "show", "0-5.1"]).done().to_vec()).unwrap();
    assert!(read.contains("camera-lab lesson play sheet --step 2"), "{read}");
    // The plan is for the lecturer, the questions for everybody.
    for (name, options) in [("with.pdf", &["--plan"][..]), ("without.pdf", &[])] {
        bench.run(&[&["lesson", "render", "light", "-o", name, "--per-page", "4"][..], options].concat()).done();
    }
    assert!(bench.read("with.pdf").len() > bench.read("without.pdf").len() + 1000);
    assert!(bench.run(&["lesson", "render", "light", "-o", "pictures", "--plan"]).refused(2).contains("--plan"));
    for (questions, told) in [
        ("pretest = [{ exercise = \"nope\" }]", "exercise"),
        ("pretest = [{ seed = 1 }]", "exercise"),
        ("posttest = 3", "posttest"),
        ("links = 1", "links"),
    ] {
        let error = parse(&LESSON.replacen("title", &format!("{questions}\ntitle"), 1)).unwrap_err();
        assert!(error.line == 3 && error.key.contains(told), "{questions}: {error}");
    }
    let link = "links = [{ lesson = \"basis\", step = 99 }]";
    bench.write("link.toml", LESSON.replace("seconds = 0", link));
    let refused = bench.run(&["lesson", "check", "link.toml"]);
    assert!(refused.refused(2).contains("the lesson has no step 99; allowed: a step from 1 to 12"), "{}", refused.err);
}

#[test]
fn the_command_line_lists_shows_checks_and_draws() {
    let bench = Bench::new("lessons");
    let list = bench.run(&["lesson", "list", "--format", "json"]).json();
    assert_eq!(list.as_array().unwrap().len(), 20);
    assert_eq!(list[0]["id"], "camera");
    let show = bench.run(&["lesson", "show", "basis", "--format", "json"]).json();
    let steps = show["steps"].as_array().unwrap();
    assert_eq!(steps.len(), shipped()[1].lesson.steps.len());
    for step in steps {
        read::parse(step["figure"].as_str().unwrap()).unwrap();
    }
    assert!(steps.iter().any(|step| step["ask"]["id"] == "basis" && step["ask"]["seed"].is_u64()));
    let read = String::from_utf8(bench.run(&["lesson", "show", "basis", "--lang", "pt-BR"]).done().to_vec()).unwrap();
    assert!(read.contains("Pergunta:") && read.contains("Experimente:"), "{read}");

    bench.write("small.toml", LESSON);
    // It's a good lesson, but a colleague can't teach it yet.
    let checked = bench.run(&["lesson", "check", "small.toml"]);
    assert_eq!(checked.status, Some(0));
    for part in ["aims", "plan", "sentence"] {
        assert!(checked.err.contains(&format!("small.toml, line 2: {part} is missing")), "{}", checked.err);
    }
    let head =
        "aims = [\"a\"]\nplan = \"**0–50** Show.\"\nsentence = \"s\"\npretest = [{ exercise = \"basis\", seed = 7 }]\n";
    bench.write("whole.toml", LESSON.replacen("title", &format!("{head}title"), 1));
    assert!(bench.run(&["lesson", "check", "whole.toml"]).done().starts_with(b"the lesson has no errors"));
    bench.run(&["lesson", "render", "small.toml", "-o", "pictures", "--size", "300x100"]).done();
    for number in ["01", "02"] {
        assert!(bench.path("pictures").join(format!("{number}-small.png")).exists());
    }
    bench.run(&["lesson", "render", "small.toml", "-o", "pictures", "--view", "image", "--format", "svg"]).done();
    let drawn = std::fs::read_to_string(bench.path("pictures").join("01-small.svg")).unwrap();
    assert!(drawn.contains("<title>One</title>"));
    for (name, options) in [("two.pdf", &[][..]), ("four.pdf", &["--per-page", "4", "--answers", "--lang", "pt-BR"])] {
        let given = ["lesson", "render", "small.toml", "-o", name];
        bench.run(&[&given[..], options].concat()).done();
        let handout = bench.read(name);
        assert!(handout.starts_with(b"%PDF") && handout.len() > 10_000, "{name}");
    }
    assert!(
        bench.run(&["lesson", "render", "small.toml", "-o", "a.pdf", "--per-page", "3"]).refused(2).contains("2 or 4")
    );
    assert!(bench.run(&["lesson", "render", "small.toml", "-o", "a.png"]).refused(2).contains("a folder"));
    let listed = bench.run(&["lesson", "list", "--folder", ".", "--format", "json"]).json();
    assert_eq!(listed[20]["id"], "small");

    bench.write("small.toml", LESSON.replace("near = 2", "near = -2"));
    let refused = bench.run(&["lesson", "check", "small.toml"]);
    assert!(refused.refused(2).contains("line 20"), "{}", refused.err);
    bench.write("links.toml", LESSON.replace("seconds = 0", "links = [{ lesson = \"nope\" }, { note = \"nope\" }]"));
    let refused = bench.run(&["lesson", "check", "links.toml"]);
    assert!(
        refused.refused(2).contains("links.toml, line 18: [[step.links]] note: there is no reference page \"nope\""),
        "{}",
        refused.err
    );
    for (condition, way, said) in [
        (
            "hidden = \"dor\"",
            "",
            "goal.toml, line 13: [step.try] until.hidden is \"dor\", which the scene does not have; allowed: \"ground\", \"walls\"",
        ),
        ("quantity = \"distance\"\nleast = 0", "", "goal.toml, line 12: [step.try] until holds already"),
        (
            "quantity = \"distance\"\nleast = 50",
            "way = [\"zoom=2\"]\n",
            "goal.toml, line 12: [step.try] way doesn't reach",
        ),
    ] {
        let text = with_goal(condition).replace("[[step.try.until]]", &format!("{way}[[step.try.until]]"));
        bench.write("goal.toml", text);
        let refused = bench.run(&["lesson", "check", "goal.toml"]);
        assert!(refused.refused(2).contains(said), "{}", refused.err);
    }
    bench.write("before.toml", LESSON.replacen("title", "before = [\"nope\"]\ntitle", 1));
    let refused = bench.run(&["lesson", "check", "before.toml"]);
    assert!(refused.refused(2).contains("before.toml, line 3: before: there is no lesson \"nope\""), "{}", refused.err);
    assert!(bench.run(&["lesson", "show", "bassis"]).refused(2).contains("did you mean \"basis\""));
    assert!(bench.run(&["lesson", "play", "basis", "--step", "99"]).refused(2).contains("from 1 to"));
}

/// Beside one another in a presentation, low and less low, and in a window with its panels.
const SHAPES: [(u32, u32, f32); 4] = [(635, 215, 1.6), (635, 460, 1.6), (955, 600, 1.6), (510, 470, 1.0)];

#[test]
fn the_axes_of_the_camera_are_in_the_world_of_every_step() {
    let mut cut = Vec::new();
    for lesson in shipped().iter().map(|shipped| &shipped.lesson) {
        for (k, step) in lesson.steps.iter().enumerate() {
            if step.figure.screen.pictures.is_some_and(|shown| !shown[View::World as usize]) {
                continue;
            }
            let camera = Camera::new(&step.figure.camera).unwrap();
            let scene = scene_of(&step.figure, &mut no_files, &Default::default()).unwrap();
            let scene = SharedScene::new(scene);
            let parts = &step.figure.world.parts;
            let names =
                [("u", WorldPart::Vrc), ("v", WorldPart::Vrc), ("n", WorldPart::Vrc), ("VUP", WorldPart::ViewUp)];
            for (width, height, scale) in SHAPES {
                let size = Size { width, height, scale };
                let request = Request::of(&step.figure, View::World, &camera, &scene, labels(Lang::En), size);
                let sides = request.sides().map_or_else(|| vec![request], |sides| sides.map(|s| s.request).to_vec());
                for side in sides {
                    let whole = [side.size.width as f32, side.size.height as f32];
                    let drawing = draw(&side);
                    let is_in_sight = |name: &str| {
                        let mut named = drawing.labels.iter().filter(|label| label.text == name);
                        named.any(|label| (0..2).all(|k| (0.0..whole[k]).contains(&label.position[k])))
                    };
                    let hidden = &step.figure.labels.hidden;
                    let shown =
                        names.iter().filter(|(name, part)| parts.has(*part) && !hidden.iter().any(|h| h == name));
                    for (name, _) in shown.filter(|(name, _)| !is_in_sight(name)) {
                        cut.push(format!("{} {}: {name} at {width} × {height}", lesson.id, k + 1));
                    }
                }
            }
        }
    }
    assert!(cut.is_empty(), "{cut:#?}");
}

/// A step that only shows the answer to the question before it comes after the last question, if that is wanted.
#[test]
fn no_page_of_a_handout_answers_a_question_of_the_page_before() {
    let lesson = &shipped()[0].lesson;
    let headings = |late: bool| -> Vec<String> {
        let options = HandoutOptions { lang: Lang::En, columns: 1, answers: Solutions::None, plan: false, late };
        let handout = handout::of_lesson(lesson, options, |(_, step), size| {
            let scene = scene_of(&step.figure, &mut no_files, &Default::default()).unwrap();
            handout::picture(&step.figure, &SharedScene::new(scene), Views::One(View::Image), size, Lang::En)
        });
        let entries = handout.unwrap().parts.into_iter().flat_map(|part| part.entries);
        let heading = |paragraph: &Paragraph| match paragraph {
            Paragraph::Heading(text) => Some(text.clone()),
            _ => None,
        };
        entries.filter_map(|entry| entry.paragraphs.first().and_then(heading)).collect()
    };
    let [usual, late] = [false, true].map(headings);
    assert_eq!(usual.len(), late.len());
    let place = |all: &[String], title: &str| all.iter().position(|heading| heading.ends_with(title)).unwrap();
    let (question, answer) = ("PF – where it looks", "PF twice as far");
    assert_eq!(place(&usual, answer), place(&usual, question) + 1);
    let last = lesson.steps.iter().rposition(|step| step.task.is_some()).unwrap();
    let last = told(Lang::En, &lesson.steps[last].title).to_owned();
    assert!(place(&late, answer) > place(&late, &last), "{late:?}");
}
