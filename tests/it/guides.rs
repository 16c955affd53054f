//! The guides' statements, compared with the program.

use std::collections::BTreeSet;

use camera_lab::camera::{
    Amount, AngleUnit, Camera, Convention, Freedom, OPERATIONS, Operation, Order, Program, Toward, WorldUp,
};
use camera_lab::exercises::Mistake;
use camera_lab::figure::{KEYS, read};
use camera_lab_words::learn::exercises;
use camera_lab_words::{Lang, messages, window};

use crate::common::camera::camera;
use crate::common::program::Bench;

/// The guide for students, with its table of operations.
const STUDENT: [(Lang, &str, &str); 2] = [
    (Lang::En, include_str!("../../docs/student.en.md"), "| operation |"),
    (Lang::PtBr, include_str!("../../docs/student.pt-BR.md"), "| operação |"),
];
/// The guide for lecturers.
const LECTURER: [(Lang, &str); 2] =
    [(Lang::En, include_str!("../../docs/lecturer.en.md")), (Lang::PtBr, include_str!("../../docs/lecturer.pt-BR.md"))];
/// The page of mistakes, with its table.
const MISTAKES: [(Lang, &str, &str); 2] = [
    (Lang::En, include_str!("../../docs/mistakes.en.md"), "| code | mistake |"),
    (Lang::PtBr, include_str!("../../docs/mistakes.pt-BR.md"), "| código | erro |"),
];
/// The guide to the command line.
const COMMAND_LINE: [(Lang, &str); 2] = [
    (Lang::En, include_str!("../../docs/command-line.en.md")),
    (Lang::PtBr, include_str!("../../docs/command-line.pt-BR.md")),
];
/// The guide for authors.
const AUTHOR: [(Lang, &str); 2] =
    [(Lang::En, include_str!("../../docs/author.en.md")), (Lang::PtBr, include_str!("../../docs/author.pt-BR.md"))];

/// The cells of the table that begins with this heading.
fn table<'a>(guide: &'a str, heading: &str) -> Vec<Vec<&'a str>> {
    let rows = guide.lines().skip_while(|line| !line.starts_with(heading)).skip(2);
    let rows = rows.take_while(|line| line.starts_with('|'));
    rows.map(|line| line.trim_matches('|').split('|').map(str::trim).collect()).collect()
}

/// The axis of a turn, its fixed point and the values it changes, in the words of the table: from its effect on a
/// camera.
fn done(freedom: Freedom, lang: Lang) -> [String; 3] {
    let before = camera(|p| {
        (p.position, p.focal_point, p.view_up) = (glam::DVec3::new(3.0, 4.0, 5.0), glam::DVec3::ONE, glam::DVec3::Y);
    });
    let after = match freedom.by(20.0).apply(&before, Convention::RightHand) {
        Ok(after) => after,
        Err(error) => panic!("{error}"),
    };
    let moved = |of: fn(&Camera) -> glam::DVec3| (of(&before) - of(&after)).length() > 1e-9;
    let turned = [("C", moved(Camera::position)), ("PF", moved(Camera::focal_point)), ("VUP", moved(Camera::view_up))];
    let turned: Vec<_> = turned.into_iter().filter(|(_, moved)| *moved).map(|(name, _)| name).collect();
    let axes = [("u", moved(|c| c.basis().u)), ("v", moved(|c| c.basis().v)), ("n", moved(|c| c.basis().n))];
    let axis: Vec<_> = axes.into_iter().filter(|(_, moved)| !moved).map(|(name, _)| name).collect();
    assert_eq!(axis.len(), 1, "{freedom:?}");
    let and = match lang {
        Lang::En => " and ",
        _ => " e ",
    };
    let pivot = if turned.contains(&"C") { "PF" } else { "C" };
    [turned.join(and), axis[0].to_owned(), pivot.to_owned()]
}

#[test]
fn the_table_of_operations_agrees_with_the_operations() {
    for (lang, guide, heading) in STUDENT {
        let t = window::texts(lang);
        let name = |freedom| match freedom {
            Freedom::Elevation => t.elevation,
            Freedom::Azimuth => t.azimuth,
            Freedom::Roll => t.roll,
            Freedom::Yaw => t.yaw,
            Freedom::Pitch => t.pitch,
            Freedom::Zoom | Freedom::Dolly | Freedom::PanU | Freedom::PanV => panic!("{freedom:?} does not turn"),
        };
        let turns = OPERATIONS.iter().filter(|descriptor| descriptor.amount == Amount::Angle);
        let expected: Vec<Vec<String>> = turns
            .map(|descriptor| {
                let [turned, axis, pivot] = done(descriptor.freedom, lang);
                vec![name(descriptor.freedom).to_lowercase(), turned, axis, pivot]
            })
            .collect();
        assert_eq!(table(guide, heading), expected, "{lang:?}");
    }
}

/// The table of programs in the words of the page.
#[test]
fn the_table_of_programs_is_the_one_in_the_code() {
    for (lang, page, heading) in [
        (Lang::En, include_str!("../../docs/cameras.en.md"), "| program |"),
        (Lang::PtBr, include_str!("../../docs/cameras.pt-BR.md"), "| programa |"),
    ] {
        let say = |[en, pt]: [&'static str; 2]| if lang == Lang::En { en } else { pt };
        let toward = |toward| match toward {
            Toward::Right => say(["right", "à direita"]),
            Toward::Left => say(["left", "à esquerda"]),
            Toward::Up => say(["up", "para cima"]),
            Toward::Down => say(["down", "para baixo"]),
            Toward::Viewer => say(["towards the viewer", "rumo ao observador"]),
            Toward::Scene => say(["into the scene", "para dentro da cena"]),
        };
        let expected: Vec<Vec<String>> = Program::ALL
            .iter()
            .map(|program| {
                let [x, y, z] = program.axes.camera.map(toward);
                let mut world = match program.axes.up {
                    WorldUp::Y => say(["y up", "y para cima"]),
                    WorldUp::Z => say(["z up", "z para cima"]),
                    WorldUp::Open => say(["as it is", "como está"]),
                }
                .to_owned();
                if program.axes.left_handed {
                    world += say([", left-handed", ", mão esquerda"]);
                }
                if program.units != 1.0 {
                    world += &format!(", 1/{} {}", program.units, say(["of ours", "da nossa unidade"]));
                }
                let order = match program.order {
                    Order::Rows => say(["by rows", "por linhas"]),
                    Order::Columns => say(["by columns", "por colunas"]),
                    Order::WxyzThenT => say(["quaternion w x y z, t", "quatérnio w x y z, t"]),
                    other => panic!("{other:?} has no words yet"),
                };
                let angle = match program.angle {
                    Some(AngleUnit::Degrees) => say(["degrees", "graus"]),
                    Some(AngleUnit::Radians) => say(["radians", "radianos"]),
                    None => "–",
                };
                vec![
                    format!("{}: `{}`", program.name, program.word),
                    format!("x {x}, y {y}, z {z}"),
                    world,
                    program.ndc.map_or_else(|| "pixels".to_owned(), |ndc| format!("`{}`", ndc.name())),
                    order.to_owned(),
                    angle.to_owned(),
                ]
            })
            .collect();
        assert_eq!(table(page, heading), expected, "{lang:?}");
    }
}

#[test]
fn the_guides_list_the_operations_of_the_command_line() {
    for (lang, guide) in COMMAND_LINE {
        let Some(start) = guide.find("`--op N") else { panic!("{lang:?}: no --op") };
        let sentence = guide[start..].split("DX,DY`").next().unwrap_or_default();
        let words: Vec<&str> = sentence.split('`').skip(3).step_by(2).map(|word| word.trim_end_matches('=')).collect();
        assert_eq!(words, Operation::names(), "{lang:?}");
        let groups: Vec<usize> = sentence.split(" (").map(|group| group.matches('`').count() / 2).collect();
        let count = |amount| OPERATIONS.iter().filter(|descriptor| descriptor.amount == amount).count();
        assert_eq!(groups[0] - 1, count(Amount::Angle), "{lang:?}: those in degrees");
        assert_eq!(groups[1], count(Amount::Factor), "{lang:?}: those that are factors");
    }
}

#[test]
fn the_guides_list_every_mistake_by_its_code() {
    for (lang, guide, heading) in MISTAKES {
        let expected: Vec<Vec<String>> = Mistake::ALL
            .iter()
            .map(|mistake| vec![format!("`{}`", mistake.code()), exercises::mistake(lang, *mistake)[0].to_owned()])
            .collect();
        assert_eq!(table(guide, heading), expected, "{lang:?}");
    }
}

/// Words of a page outside of code.
fn words(page: &str) -> usize {
    page.split("```").step_by(2).flat_map(str::split_whitespace).count()
}

#[test]
fn guides_are_short_enough_to_be_read() {
    let pages = STUDENT.iter().map(|(_, page, _)| *page);
    for page in pages.chain(LECTURER.iter().chain(&COMMAND_LINE).chain(&AUTHOR).map(|(_, page)| *page)) {
        assert!((800..4000).contains(&words(page)), "{}: {} words", &page[..40], words(page));
        for paragraph in page.split("```").step_by(2).flat_map(|text| text.split("\n\n")) {
            let is_prose = !paragraph.trim_start().starts_with(['|', '-', '1']);
            let count = paragraph.split_whitespace().count();
            assert!(!is_prose || count <= 90, "{count} words: {paragraph}");
        }
    }
}

/// The figure file that a guide prints has every key that a figure can have, and is one.
#[test]
fn the_figure_file_of_the_guides_can_be_read() {
    for (lang, page) in AUTHOR {
        let (_, example) = page.split_once("```toml\n").unwrap_or_else(|| panic!("{lang:?}: no example"));
        let example = example.split("```").next().unwrap_or_default();
        // The parent and the objects that the example names.
        let scene = example.replace("parent    = \"house\"", "# parent");
        if let Err(error) = read::parse(&scene) {
            panic!("{lang:?}: line {}: {}", error.line, messages::figure(lang, &error));
        }
        let words: BTreeSet<&str> = example.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).collect();
        let name = |key: &'static str| key.rsplit('.').next().unwrap_or(key);
        let missing: Vec<&str> = KEYS.iter().map(|key| name(key)).filter(|key| !words.contains(key)).collect();
        assert!(missing.is_empty(), "{lang:?}: the example lacks {missing:?}");
    }
}

#[test]
fn every_image_is_shown_on_a_page_and_every_page_has_its_images() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let names = |folder: &str| {
        let entries = std::fs::read_dir(root.join(folder)).unwrap_or_else(|error| panic!("{folder}: {error}"));
        entries.flatten().map(|entry| entry.file_name().into_string().unwrap_or_default()).collect::<BTreeSet<_>>()
    };
    let pages = names("docs").into_iter().filter(|name| name.ends_with(".md")).map(|name| format!("docs/{name}"));
    let mut shown = BTreeSet::new();
    for page in pages.chain(["README.md", "README.pt-BR.md"].map(str::to_owned)) {
        let text = std::fs::read_to_string(root.join(&page)).unwrap_or_else(|error| panic!("{page}: {error}"));
        let images = text.split("](").skip(1).filter_map(|link| link.split(')').next()?.split_once("images/"));
        shown.extend(images.map(|(_, name)| name.to_owned()));
    }
    assert_eq!(shown, names("docs/images"));
}

/// Each picture holds its figure, which can be opened.
#[cfg(unix)]
#[test]
fn the_figures_of_the_guides_can_be_redrawn() {
    let script = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/pictures.sh");
    let bench = Bench::new("guide-figures");
    let figures = ["pipeline-depth.pt-BR.png", "points.en.svg"];
    let output = std::process::Command::new("sh")
        .arg(script)
        .args([env!("CARGO_BIN_EXE_camera-lab").as_ref(), bench.path("").as_path()])
        .args(figures)
        .output()
        .expect("sh runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(bench.names(), figures);
    for figure in figures {
        bench.run(&["inspect", figure]).done();
    }
}

/// The limit of the files that go along stands in several guides.
#[test]
fn guides_give_the_limit_of_what_is_handed_out() {
    let limit = format!("{} KiB", camera_lab::limits::MAX_HANDED_OUT_BYTES >> 10);
    let limits = (Lang::En, include_str!("../../docs/limits.md"));
    for (lang, guide) in LECTURER.into_iter().chain(AUTHOR).chain([limits]) {
        assert!(guide.contains(&limit), "{lang:?}: {limit} is missing in {:?}", guide.lines().next());
    }
}
