//! What the guides say, against the program.

use camera_lab::camera::{Amount, Camera, Convention, Freedom, OPERATIONS, Operation};
use camera_lab::exercises::Mistake;
use camera_lab::i18n::{Lang, exercises, window};

use crate::common::camera::camera;
use crate::common::program::Bench;

const GUIDES: [(Lang, &str, &str); 2] = [
    (Lang::En, include_str!("../../docs/guide.en.md"), "| operation |"),
    (Lang::PtBr, include_str!("../../docs/guide.pt-BR.md"), "| operação |"),
];

/// The cells of the table that begins with this heading.
fn table<'a>(guide: &'a str, heading: &str) -> Vec<Vec<&'a str>> {
    let rows = guide.lines().skip_while(|line| !line.starts_with(heading)).skip(2);
    let rows = rows.take_while(|line| line.starts_with('|'));
    rows.map(|line| line.trim_matches('|').split('|').map(str::trim).collect()).collect()
}

/// What a turn changes, about which axis and through which point, in the words of the table: from what it does to a
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
        Lang::PtBr => " e ",
    };
    let pivot = if turned.contains(&"C") { "PF" } else { "C" };
    [turned.join(and), axis[0].to_owned(), pivot.to_owned()]
}

#[test]
fn the_table_of_operations_is_what_operations_do() {
    for (lang, guide, heading) in GUIDES {
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

#[test]
fn the_guides_list_the_operations_of_the_command_line() {
    for (lang, guide, _) in GUIDES {
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
    for ((lang, guide, _), heading) in GUIDES.into_iter().zip(["| code | mistake |", "| código | erro |"]) {
        let expected: Vec<Vec<String>> = Mistake::ALL
            .iter()
            .map(|(mistake, code)| vec![format!("`{code}`"), exercises::mistake(lang, *mistake)[0].to_owned()])
            .collect();
        assert_eq!(table(guide, heading), expected, "{lang:?}");
    }
}

/// The pictures that a page shows, without their folder.
fn pictures(page: &str) -> impl Iterator<Item = &str> {
    page.split("images/").skip(1).filter_map(|rest| rest.split(')').next())
}

/// Windows are drawn by `tests/gui/guide_pictures.rs`, which is a part of the same command.
fn is_of_the_window(name: &str) -> bool {
    ["explain", "window"].iter().any(|start| name.starts_with(start))
}

#[cfg(unix)]
#[test]
fn the_figures_of_the_guides_are_those_that_their_command_draws() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let bench = Bench::new("guide-figures");
    let script = std::process::Command::new("sh")
        .arg(root.join("docs/pictures.sh"))
        .args([env!("CARGO_BIN_EXE_camera-lab").as_ref(), bench.path("").as_path()])
        .output()
        .expect("sh runs");
    assert!(script.status.success(), "{}", String::from_utf8_lossy(&script.stderr));
    let drawn = bench.names();
    let readme = include_str!("../../README.md");
    let mut shown: Vec<String> =
        GUIDES.iter().flat_map(|(_, guide, _)| pictures(guide)).chain(pictures(readme)).map(str::to_owned).collect();
    shown.sort();
    shown.dedup();
    let (windows, figures): (Vec<String>, Vec<String>) = shown.into_iter().partition(|name| is_of_the_window(name));
    assert_eq!(drawn, figures);
    let images = root.join("docs/images");
    for name in figures {
        let kept = std::fs::read(images.join(&name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(kept == bench.read(&name), "docs/images/{name} is not what docs/pictures.sh draws: run it");
        // Vectors are line work: no pixels but those of the image on the window, no letters whose font may be missing.
        let of_pixels = ["gouraud", "phong", "depth"].iter().any(|word| name.contains(word));
        assert_eq!(name.ends_with(".svg"), !of_pixels, "{name}");
        let text = String::from_utf8_lossy(&kept);
        let widths = text.split("<image ").skip(1).filter_map(|rest| rest.split("width=\"").nth(1)?.split('"').next());
        let widths: Vec<f64> = widths.filter_map(|width| width.parse().ok()).collect();
        assert!(of_pixels || (widths.len() <= 1 && widths.iter().all(|width| *width < 100.0)), "{name}: {widths:?}");
        assert!(!text.contains("<text"), "{name}");
    }
    for name in windows {
        assert!(images.join(&name).is_file(), "{name}");
    }
}
