//! Both languages, while the window runs.

use std::collections::BTreeSet;

use camera_lab_desk::message::Message;
use camera_lab_words::Lang;
use camera_lab_words::window::texts;
use eframe::egui::{Key, Modifiers};
use egui_kittest::kittest::{By, NodeT, Queryable};

use super::window::Window;
use crate::words::{en, pt};

/// Every word in the window.
fn words(window: &Window) -> BTreeSet<String> {
    let nodes = window.harness.query_all(By::new().predicate(|_| true));
    nodes.flat_map(|node| [node.accesskit_node().label(), node.accesskit_node().value()]).flatten().collect()
}

/// Texts that are the same in both languages: symbols, numbers, names.
fn is_international(word: &str, both: &BTreeSet<&str>) -> bool {
    both.contains(word.trim().trim_start_matches("✔ "))
        || !word.chars().any(char::is_alphabetic)
        || word
            .split(|c: char| !c.is_alphabetic())
            .all(|part| part.chars().count() <= 3 || ["Zoom", "Pipeline"].contains(&part))
}

#[test]
fn switching_leaves_no_word_of_the_other_language() {
    let mut window = Window::new(Lang::En);
    window.enter("F", "20");
    window.more(en::WINDOW.viewport);
    window.click(en::WINDOW.menu_edit);
    let english = words(&window);
    assert!(english.iter().any(|word| word.contains("must be less than")));
    window.key(Key::Escape);
    window.command_key(Key::L);
    window.click(pt::WINDOW.menu_edit);
    let portuguese = words(&window);
    assert!(portuguese.iter().any(|word| word.contains("tem de ser menor que")));
    let (en, pt) = (texts(Lang::En).entries(), texts(Lang::PtBr).entries());
    let both: BTreeSet<&str> = en.iter().zip(&pt).filter(|(a, b)| a.1 == b.1).map(|(a, _)| a.1).collect();
    let left: Vec<_> = english.intersection(&portuguese).filter(|word| !is_international(word, &both)).collect();
    assert!(left.is_empty(), "{left:#?}");
}

#[test]
fn no_text_is_missing_and_few_are_the_same() {
    let (en, pt) = (texts(Lang::En).entries(), texts(Lang::PtBr).entries());
    let mut same = Vec::new();
    for ((name, english), (_, portuguese)) in en.into_iter().zip(pt) {
        assert!(!english.trim().is_empty() && !portuguese.trim().is_empty(), "{name}");
        if english == portuguese {
            same.push(english);
        }
    }
    let names = ["Menu", "pixels", "Viewport", "faces", "Gouraud", "Phong", "Zoom"];
    same.retain(|text| !names.contains(text) && !is_international(text, &BTreeSet::new()));
    assert_eq!(same, ["θ, vertical: H = 2 F tan(θ/2). [0] (5.5)", "m × n pixels. [0] (5.22)"]);
}

#[test]
fn the_last_message_changes_its_language_too() {
    let mut window = Window::new(Lang::En);
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::C);
    window.run();
    let (en, pt) = (texts(Lang::En), texts(Lang::PtBr));
    assert!(window.says(en.copied));
    window.command_key(Key::L);
    assert!(window.says(pt.copied) && !window.says(en.copied));
    window.command_key(Key::L);

    // Errors carry their cause, not the words for it.
    let path = std::path::PathBuf::from("/no such figure.toml");
    let error = camera_lab_files::open_figure(&path).expect_err("it is not there");
    window.app_mut().state.model.say(Message::File(path, error));
    window.run();
    assert!(window.says("there is no such file or directory"));
    window.command_key(Key::L);
    assert!(window.says("o arquivo ou diretório não existe") && !window.says("there is no such file"));
}
