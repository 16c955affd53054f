//! Predictions in lessons: a place in the image, judged by the pipeline, and the figure that shows the answer.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::Camera;
use camera_lab::exercises::{self, Guess, Progress};
use camera_lab::figure::{Figure, FigureError};
use camera_lab::lessons::{See, Task, parse, shipped};
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{ObjectPoint, no_files};
use camera_lab::views::{Request, SharedScene, Size, View, scene_of};
use camera_lab_words::Lang;
use camera_lab_words::learn::{exercise_messages, exercises as said};
use camera_lab_words::pictures::labels;
use glam::DVec3;
use tiny_skia::PremultipliedColorU8;
use toml_edit::{DocumentMut, Value};

use crate::views::draw;

/// C = (0, 0, 5) looks at the origin, θ = 90° and 800 × 600 pixels. P = (1, 1, 0) has the depth 5: half the window is
/// 5 high there, so P is 1/5 of 300 pixels above the middle, and as many pixels to the right of it.
const LESSON: &str = r#"
id = "places"
title = "Places"
[[step]]
title = "One"
text = "One"
[step.camera]
position = [0, 0, 5]
focal_point = [0, 0, 0]
view_angle = 90
near = 1
far = 20
[step.image]
width = 800
height = 600
[[step.points]]
name = "P"
position = [1, 1, 0]
[step.ask]
text = "Where is P?"
place = "P"
[[step]]
title = "Two"
text = "Two"
[step.ask]
text = "Where will (1, 1, 0) be?"
place = [1, 1, 0]
see = ["camera.position=[0, 0, 10]"]
tolerance = 5
[[step]]
title = "Three"
text = "Three"
[step.ask]
text = "Is it smaller?"
choices = ["yes", "no"]
answer = "yes"
see = "next"
[[step]]
title = "Four"
text = "Four"
[step.camera]
position = [0, 0, 20]
"#;

#[test]
fn a_place_is_judged_by_its_pixels_and_says_how_far_it_is_off() {
    let lesson = parse(LESSON).unwrap();
    let judge = |step: usize, text: &str| {
        let Some(Task::Question(entry)) = &lesson.steps[step].task else { panic!("a question") };
        let exercise = entry.exercise(0, &Default::default());
        let ask = &exercise.asks[0];
        let judged = exercises::check(entry, &exercise, ask, text).unwrap();
        (judged.right, ask.off(&judged.understood).unwrap())
    };
    let near = |a: [f64; 2], b: [f64; 2]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    let (right, off) = judge(0, "[460, 240]");
    assert!(right && near(off, [0.0, 0.0]), "{off:?}");
    // A twentieth of 600 pixels.
    assert!(judge(0, "[490, 240]").0 && !judge(0, "[491, 240]").0);
    let (right, off) = judge(0, "[400, 300]");
    assert!(!right && near(off, [-60.0, 60.0]), "{off:?}");
    let (en, pt) = (exercise_messages::off(Lang::En, off), exercise_messages::off(Lang::PtBr, off));
    assert!(en.contains("85 pixels") && en.contains("to the right and higher"), "{en}");
    assert!(pt.contains("85 pixels") && pt.contains("à direita e mais acima"), "{pt}");
    // From twice as far it's half as far from the middle.
    assert!(judge(1, "[430, 270]").0 && judge(1, "[435, 275]").0 && !judge(1, "[460, 240]").0);
    assert_eq!(exercise_messages::off(Lang::En, [-3.0, 0.2]).matches("higher").count(), 0);
}

#[test]
fn a_question_knows_the_figure_that_answers_it() {
    let lesson = parse(LESSON).unwrap();
    assert!(lesson.seen_after(0).is_none() && lesson.seen_after(3).is_none());
    assert_eq!(lesson.seen_after(1).unwrap().camera.position.z, 10.0);
    assert_eq!(lesson.steps[1].figure.camera.position.z, 5.0);
    assert_eq!(lesson.seen_after(2).unwrap().camera.position.z, 20.0);
}

#[test]
fn a_place_that_the_image_does_not_have_is_refused_with_its_line() {
    for (from, to, key) in [
        ("place = \"P\"", "place = \"Q\"", "[step.ask] place"),
        ("place = \"P\"", "place = [0, 0, 9]", "[step.ask] place"),
        ("place = \"P\"", "place = \"P\"\nanswer = 3", "[step.ask] answer"),
        ("see = \"next\"", "see = \"there\"", "[step.ask] see"),
        ("see = \"next\"", "see = [\"camera.near=-1\"]", "[step.ask] see"),
    ] {
        let text = LESSON.replace(from, to);
        let error = parse(&text).unwrap_err();
        assert_eq!(error.key, key, "{to}: {error}");
        let line = 1 + text.lines().position(|line| line.starts_with(key.rsplit(' ').next().unwrap())).unwrap();
        assert!(error.line >= line, "{to}: line {} of {line}", error.line);
    }
}

/// The right place for a `place` of the second step, in which the camera steps back to z = 10.
fn marked(place: &str) -> Result<[f64; 2], FigureError> {
    let cone =
        "[[step.scene.objects]]\nname = \"cone\"\nshape = \"cone\"\ntranslate = [1, 0, 0]\nscale = [1, 0.5, 1]\n";
    let text = LESSON.replace("place = [1, 1, 0]", &format!("place = {place}"));
    let text = text.replacen("[step.ask]\ntext = \"Where will", &format!("{cone}[step.ask]\ntext = \"Where will"), 1);
    let lesson = parse(&text)?;
    let Some(Task::Question(entry)) = &lesson.steps[1].task else { panic!("a question") };
    let exercise = entry.exercise(0, &Default::default());
    Ok(exercise.asks[0].expected().table().unwrap().entries.try_into().unwrap())
}

/// (1, 1, 0) is at the depth 5 of C = (0, 0, 5), and at the depth 10 once C has stepped back.
#[test]
fn a_place_is_computed_from_a_thing_or_from_coordinates_of_the_step() {
    for place in [
        "[1, 1, 0]",
        "\"P\"",
        r#"{ object = "cone", vertex = "tip" }"#,
        // The rim has 32 vertices before the tips.
        r#"{ object = "cone", vertex = "vertex:33" }"#,
        "{ view = [1, 1, -5] }",
        // A = 4/3, and z_n = (20 + 1)/19 − 40/(19 · 5) at the depth 5, with w as the depth.
        "{ ndc = [0.15, 0.2, \"13/19\"] }",
        "{ clip = [0.75, 1, \"65/19\", 5] }",
        "{ clip = [1.5, 2, \"130/19\", 10] }",
    ] {
        let [x, y] = marked(place).unwrap();
        assert!((x - 430.0).abs() < 1e-9 && (y - 270.0).abs() < 1e-9, "{place}: {x}, {y}");
    }
    let at = |place| marked(place).unwrap();
    // The box of the cone is [0, 2] × [0, 1] × [−1, 1].
    assert_eq!(at(r#"{ object = "cone", vertex = "center" }"#), at("[1, 0.5, 0]"));
    assert_eq!(at(r#"{ object = "cone", vertex = "corner:7" }"#), at("[2, 1, 1]"));
    // A pixel has its own place, and its centre is half a pixel from its corner.
    assert_eq!(at("{ pixel = [11, 3] }"), [11.5, 3.5]);
}

#[test]
fn a_place_without_a_point_is_refused_at_its_line() {
    for (place, key) in [
        (r#"{ object = "cone", vertex = "top" }"#, "vertex"),
        (r#"{ object = "cone", vertex = "corner:9" }"#, "vertex"),
        (r#"{ object = "sphere", vertex = "tip" }"#, "vertex"),
        (r#"{ object = "cone" }"#, "vertex"),
        (r#"{ object = "cone", vertex = "tip", view = [1, 1, -5] }"#, "place"),
        ("{ view = [1, 1] }", "view"),
        ("{ view = [1, 1, 5] }", "place"),
        ("{ clip = [1, 1, 1] }", "place"),
        ("{ clip = [-1, -1, -3, -5] }", "place"),
        ("{ pixel = [800, 3] }", "place"),
        ("{ pixel = [1.5, 3] }", "pixel"),
        ("{ eye = [1, 1, 0] }", "place"),
        ("{}", "place"),
    ] {
        let error = marked(place).unwrap_err();
        let expected = if key == "place" { "[step.ask] place".to_owned() } else { format!("[step.ask] place.{key}") };
        assert!(error.key == expected || error.key.starts_with("[step.ask] place.eye"), "{place}: {error}");
        assert!(error.line > 30, "{place}: line {}", error.line);
    }
}

/// The questions of the program's lessons that ask for a mark, with the lesson's identifier and the value of `place`.
fn marks() -> Vec<(String, [String; 2], Value)> {
    let mut marks = Vec::new();
    for shipped in shipped() {
        let document: DocumentMut = shipped.text.parse().unwrap();
        for step in document["step"].as_array_of_tables().unwrap() {
            let Some(place) = step.get("ask").and_then(|ask| ask.get("place")) else { continue };
            let text = step["ask"].get("text").unwrap();
            let texts = ["en", "pt-BR"].map(|lang| text[lang].as_str().unwrap().to_owned());
            marks.push((shipped.lesson.id.clone(), texts, place.as_value().unwrap().clone()));
        }
    }
    assert_eq!(marks.len(), 20, "one in each lesson");
    marks
}

/// Coordinates that a person typed may be wrong. The student has to see them, so that they can be compared.
#[test]
fn coordinates_of_a_mark_stand_in_its_question() {
    for (id, texts, place) in marks() {
        let coordinates =
            |value: &Value| value.as_array().map(|list| list.iter().filter_map(number).collect::<Vec<_>>());
        let of_space =
            ["view", "ndc", "clip", "pixel"].into_iter().find_map(|space| coordinates(of_key(&place, space)?));
        for number in coordinates(&place).or(of_space).unwrap_or_default() {
            for (text, comma) in texts.iter().zip([false, true]) {
                assert!(numbers_in(text, comma).contains(&number), "{id}: {number} in {text}");
            }
        }
    }
}

/// The points of a figure on which an answer depends are typed too. The student sees their coordinates, or the program
/// knows the place: a point of a thing, or the middle of two points.
#[test]
fn points_of_an_answer_stand_in_the_step_or_have_a_known_place() {
    let (mut faults, mut compared) = (Vec::new(), 0);
    for shipped in shipped() {
        let document: DocumentMut = shipped.text.parse().unwrap();
        let tables = document["step"].as_array_of_tables().unwrap();
        for (k, (table, step)) in tables.iter().zip(&shipped.lesson.steps).enumerate() {
            let answer = table.get("ask").map(ToString::to_string).unwrap_or_default();
            let texts = ["en", "pt-BR"].map(|lang| step.text.get(lang).to_owned() + &answer);
            for (n, point) in step.figure.points.iter().enumerate() {
                let depends = answer.contains(&format!("quantity = \"points.{n}."))
                    || answer.contains(&format!("place = \"{}\"", point.name));
                let written = |text: &str, comma| {
                    let numbers = numbers_in(text, comma);
                    ["world", "view"].iter().any(|space| text.contains(&format!("{{points.{n}.{space}}}")))
                        || point.position.to_array().iter().all(|number| numbers.contains(number))
                };
                let stands = written(&texts[0], false) && written(&texts[1], true);
                compared += usize::from(depends);
                if depends && !stands && !is_known(&step.figure, point.position) {
                    faults.push(format!("{} step {}: {} at {}", shipped.lesson.id, k + 1, point.name, point.position));
                }
            }
        }
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
    assert!(compared > 6, "only {compared} points were compared");
}

/// True if the point is the middle, a corner, the tip or a vertex of an object, the middle of a side of its box, or the
/// middle of two points of the figure.
fn is_known(figure: &Figure, p: DVec3) -> bool {
    let middles = |points: &[DVec3]| {
        let pairs = (0..points.len()).flat_map(|i| (0..i).map(move |k| [i, k]));
        pairs.map(|pair| (points[pair[0]] + points[pair[1]]) / 2.0).collect::<Vec<_>>()
    };
    let is_p = |point: &DVec3| point.abs_diff_eq(p, 1e-9);
    let points: Vec<DVec3> = figure.points.iter().map(|point| point.position).collect();
    middles(&points).iter().any(is_p)
        || figure.scene.objects.iter().any(|object| {
            let of = |name: String| {
                name.parse().ok().and_then(|point: ObjectPoint| point.in_world(&figure.scene, &object.name))
            };
            let corners: Vec<DVec3> = (1..=8).filter_map(|k| of(format!("corner:{k}"))).collect();
            let vertices = (1..).map_while(|k| of(format!("vertex:{k}")));
            middles(&corners)
                .into_iter()
                .chain(corners)
                .chain(of("tip".to_owned()))
                .chain(vertices)
                .any(|point| is_p(&point))
        })
}

/// The value of a key in a table.
fn of_key<'a>(value: &'a Value, key: &str) -> Option<&'a Value> {
    value.as_inline_table()?.get(key)
}

fn number(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))
}

/// The numbers between brackets of a text: `−0,8`, `1/2`.
fn numbers_in(text: &str, comma: bool) -> Vec<f64> {
    let text = text.replace('−', "-");
    let text = if comma { text.replace(", ", ";").replace(',', ".") } else { text.replace(", ", ";") };
    let inside = text.split('(').skip(1).filter_map(|rest| rest.split_once(')')).map(|(inside, _)| inside.to_owned());
    let value = |written: &str| match written.trim().split_once('/') {
        Some((above, below)) => Some(above.parse::<f64>().ok()? / below.parse::<f64>().ok()?),
        None => written.trim().parse().ok(),
    };
    inside.flat_map(|inside| inside.split(';').filter_map(value).collect::<Vec<_>>()).collect()
}

/// The program knows the places of a thing's parts, in each figure.
#[test]
fn a_part_of_a_thing_is_marked_by_its_name() {
    let parts = [
        "corner", "tip", "end", "edge", "middle", "centre", "top", "canto", "ponta", "fim", "aresta", "meio", "centro",
        "topo",
    ];
    for (id, texts, place) in marks() {
        let words: Vec<&str> = texts.iter().flat_map(|text| text.split(|c: char| !c.is_alphabetic())).collect();
        let names_part = words.iter().any(|word| parts.contains(word));
        // A point of the figure is on a thing, as `points_of_an_answer_stand_in_the_step_or_have_a_known_place` shows.
        let is_computed = place.is_str() || ["object", "pixel"].iter().any(|key| of_key(&place, key).is_some());
        assert!(!names_part || is_computed, "{id}: {place} for {texts:?}");
    }
}

/// The two marks that were wrong once, by hand. The tip of the cone (2 high before its scale) is at (0.5, 1.8, −10),
/// and b = 0.6 takes it to x_c = −0.1. The corner of the sheet is turned by 25° about y.
#[test]
fn the_tip_of_the_cone_and_the_corner_of_the_turned_sheet_are_where_they_are_seen() {
    let marked = |id: &str| {
        let lesson = &shipped().iter().find(|shipped| shipped.lesson.id == id).unwrap().lesson;
        let mut entries = lesson.steps.iter().enumerate().filter_map(|(k, step)| match &step.task {
            Some(Task::Question(entry)) => Some((k, entry.exercise(0, &Default::default()))),
            _ => None,
        });
        let (step, exercise) = entries.find(|(_, exercise)| exercise.asks[0].places).unwrap();
        let right: [f64; 2] = exercise.asks[0].expected().table().unwrap().entries.try_into().unwrap();
        (right, lesson.seen_after(step).unwrap().clone())
    };
    let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() < 0.01 && (a[1] - b[1]).abs() < 0.01;
    let (tip, figure) = marked("eyes");
    let [width, height] = [figure.image.width, figure.image.height].map(f64::from);
    // 1000 pixels for a slope of 1.
    assert!(near(tip, [width / 2.0 - 10.0, height / 2.0 - 180.0]), "{tip:?}");
    let (corner, figure) = marked("hidden");
    let (sin, cos) = 25_f64.to_radians().sin_cos();
    let world = DVec3::new(-6.0 * cos + 4.0 * sin, 0.018, 6.0 * sin + 4.0 * cos);
    let camera = Camera::new(&figure.camera).unwrap();
    assert!(near(corner, exercises::place_of(&camera, figure.image, world).unwrap()), "{corner:?}");
    let middle = exercises::place_of(&camera, figure.image, DVec3::ZERO).unwrap();
    assert!(corner[0] < middle[0] && corner[1] > middle[1], "lower left: {corner:?}");
}

/// The brightest pixels of the ball are the middle of its highlight.
#[test]
fn the_mark_on_the_highlight_is_where_the_ball_is_brightest() {
    let lesson = &shipped().iter().find(|shipped| shipped.lesson.id == "light").unwrap().lesson;
    let found = lesson.steps.iter().enumerate().find_map(|(k, step)| match &step.task {
        Some(Task::Question(entry)) => {
            let exercise = entry.exercise(0, &Default::default());
            let right = exercise.asks[0].expected().table()?;
            exercise.asks[0].places.then_some((k, right.entries))
        }
        _ => None,
    });
    let (step, right) = found.unwrap();
    let figure = lesson.seen_after(step).unwrap();
    let size = Size { width: figure.image.width, height: figure.image.height, scale: 1.0 };
    let scene = SharedScene::new(scene_of(figure, &mut no_files, &Default::default()).unwrap());
    let camera = Camera::new(&figure.camera).unwrap();
    let request = Request::of(figure, View::Image, &camera, &scene, labels(Lang::En), size);
    let image = Rasterizer::default().paint(&draw(&request)).unwrap();
    // The ball is blue. At its rim the light ground shows through.
    let of_ball = image.pixels().iter().enumerate().filter(|(_, p)| p.blue() > p.red().saturating_add(80));
    let light = |p: &PremultipliedColorU8| u32::from(p.red()) + u32::from(p.green()) + u32::from(p.blue());
    let most = of_ball.clone().map(|(_, p)| light(p)).max().unwrap();
    let width = size.width as usize;
    let at = |k: usize| [(k % width) as f64, (k / width) as f64];
    let bright: Vec<[f64; 2]> = of_ball.filter(|(_, p)| light(p) + 3 >= most).map(|(k, _)| at(k)).collect();
    let mean = [0, 1].map(|axis| bright.iter().map(|at| at[axis]).sum::<f64>() / bright.len() as f64);
    let off = (mean[0] - right[0]).hypot(mean[1] - right[1]);
    assert!(off < 6.0, "{mean:?} {right:?}");
}

#[test]
fn each_lesson_asks_for_a_place_and_shows_its_answer() {
    let mut shown = 0;
    for shipped in shipped() {
        let lesson = &shipped.lesson;
        let questions = lesson.steps.iter().filter_map(|step| match &step.task {
            Some(Task::Question(entry)) => Some(entry.exercise(0, &Default::default())),
            _ => None,
        });
        let places = questions.flat_map(|exercise| exercise.asks).filter(|ask| ask.places);
        for ask in places.clone() {
            let right = ask.expected().table().unwrap().entries;
            // Neither the middle nor a corner, which anybody marks.
            assert!((right[0], right[1]) != (512.0, 384.0), "{}", lesson.id);
            assert!(said::tolerance(Lang::PtBr, &ask).contains("vertical"), "{}", lesson.id);
        }
        assert!(places.count() > 0, "{}", lesson.id);
        shown += lesson.steps.iter().filter(|step| !matches!(step.see, See::Nothing)).count();
    }
    assert!(shown > 25, "{shown} questions move the picture");
}

#[test]
fn guesses_are_kept_in_the_text_of_the_progress() {
    let mut progress = Progress::default();
    let guess = |said: &str, right, at| Guess { said: said.to_owned(), right, sure: None, at };
    progress.guessed("question-1", guess("smaller", false, 9));
    progress.guessed("question-1", guess("larger", true, 10));
    assert!(!progress.is_empty());
    let read = Progress::read(&progress.to_toml()).unwrap();
    let kept: Vec<(&str, Guess)> = read.guesses().map(|(id, guess)| (id, guess.clone())).collect();
    assert_eq!(kept, [("question-1", guess("larger", true, 10))]);
    assert!(read.to_csv().contains("guess,question-1,1,1,1970-01-01T00:00:10Z"), "{}", read.to_csv());
}
