#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use proptest::prelude::*;

use super::*;
use crate::figure::error::{FigureError, Problem};
use crate::figure::read::parse;
use crate::figure::write::to_toml;
use crate::figure::{Figure, update, varied};

/// A file with one key, with those that it can't be without.
fn file(key: &str, value: &str) -> String {
    let (section, last) = key.rsplit_once('.').unwrap_or(("", key));
    let is_list = !section.is_empty() && parse(&format!("{section} = []\n")).is_ok();
    let needed = match key {
        "scene.lights.direction" => "kind = \"directional\"\n",
        "scene.objects.points" => "shape = \"points\"\n",
        "scene.objects.path" => "shape = \"mesh\"\n",
        "scene.lights.kind" => "",
        _ if section == "scene.lights" => "kind = \"point\"\n",
        _ => "",
    };
    match section {
        "" => format!("{key} = {value}\n"),
        _ if is_list => format!("[[{section}]]\n{needed}{last} = {value}\n"),
        _ => format!("[{section}]\n{last} = {value}\n"),
    }
}

const WORDS: [&str; 12] =
    ["flat", "linear", "notes", "world", "F", "azimuth=30", "#4477aa", "1/3", "45°", "", "huose", "painter"];
const TABLES: [&str; 6] = [
    "{}",
    "{ a = 1 }",
    "{ en = \"a\", \"pt-BR\" = \"b\" }",
    "{ \"style.shading\" = \"flat\" }",
    "{ object = \"a\", edge = 2 }",
    "[{ name = \"a\" }]",
];

/// A value of any kind, allowed or not.
fn value() -> impl Strategy<Value = String> {
    let number = || prop_oneof![-3..600_i64, Just(i64::MAX)].prop_map(|i| i.to_string());
    let float = || prop_oneof![-2.0..200.0, Just(0.0), Just(-0.0), Just(1e300)].prop_map(|x: f64| format!("{x:?}"));
    let list = proptest::collection::vec(prop_oneof![number(), float()], 0..5);
    prop_oneof![
        any::<bool>().prop_map(|on| on.to_string()),
        number(),
        float(),
        proptest::sample::select(&["nan", "inf", "-inf", "1979-05-27"][..]).prop_map(str::to_owned),
        proptest::sample::select(&WORDS[..]).prop_map(|word| quoted(word).to_string()),
        "\\PC{0,9}".prop_map(|text| quoted(&text).to_string()),
        list.prop_map(|list| format!("[{}]", list.join(", "))),
        proptest::sample::select(&WORDS[..]).prop_map(|word| format!("[{}]", quoted(word))),
        Just("[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]".to_owned()),
        proptest::sample::select(&TABLES[..]).prop_map(str::to_owned),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2048))]

    #[test]
    fn a_key_takes_a_value_and_gives_it_back_or_refuses_it_by_name(at in 0..KEYS.len(), value in value()) {
        let (key, text) = (KEYS[at].as_str(), file(&KEYS[at], &value));
        match parse(&text) {
            Ok(figure) => {
                let written = to_toml(&figure);
                let back = parse(&written);
                prop_assert_eq!(back.as_ref(), Ok(&figure), "{}\n{}", text, written);
                prop_assert_eq!(update(&text, &figure), text);
            }
            Err(FigureError { problem: Problem::UnknownKey { known, .. }, .. }) => {
                prop_assert!(known.is_empty() || value.contains('{'), "{} is unknown among {:?}", key, known);
            }
            Err(error) => prop_assert!(!error.key.is_empty(), "{}: {}", text, error),
        }
    }

    #[test]
    fn setting_a_key_of_a_figure_is_reading_its_file(at in 0..KEYS.len(), value in value()) {
        // A list of sections has no keys of its own, and an empty text removes a key.
        let key = KEYS[at].as_str();
        let is_plain = file(key, "0").starts_with(&format!("[{}]", key.rsplit_once('.').map_or("", |(section, _)| section)));
        prop_assume!(is_plain && value != "\"\"");
        // A key that's impossible with the others may be refused by the name of one of them.
        let set = varied(&Figure::default(), key, &value).ok();
        prop_assert_eq!(set, parse(&file(key, &value)).ok(), "{} = {}", key, value);
    }
}

#[test]
fn each_section_of_the_table_is_known_to_the_reader_and_named_once() {
    let all: std::collections::BTreeSet<_> = KEYS.iter().collect();
    assert_eq!(all.len(), KEYS.len());
    let Problem::UnknownKey { known, .. } = parse("nothing = 1\n").unwrap_err().problem else { panic!("a known key") };
    let of_figure: Vec<&str> = ["title", "caption"].into_iter().chain(sections()).collect();
    assert_eq!(known, of_figure);
}
