//! The texts of exercises, written in `assets/exercises`.
//!
//! A file is read line by line. `# id: title` begins an exercise, whose other lines are paragraphs of the statement in
//! Markdown, and `? name: text` its questions. `# name` begins a list of `- name: text`.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use crate::i18n::Lang;

/// The texts of one language.
#[derive(Debug, Default)]
pub(in crate::i18n) struct Texts {
    pub(in crate::i18n) exercises: BTreeMap<&'static str, Statement>,
    pub(in crate::i18n) lists: BTreeMap<&'static str, BTreeMap<&'static str, &'static str>>,
}

/// The texts of an exercise.
#[derive(Debug, Default)]
pub(in crate::i18n) struct Statement {
    pub(in crate::i18n) title: &'static str,
    pub(in crate::i18n) paragraphs: Vec<&'static str>,
    pub(in crate::i18n) asks: BTreeMap<&'static str, &'static str>,
}

static EN: LazyLock<Texts> = LazyLock::new(|| read(include_str!("../../../assets/exercises/en.md")));
static PT_BR: LazyLock<Texts> = LazyLock::new(|| read(include_str!("../../../assets/exercises/pt-BR.md")));

/// The texts of a language.
pub(in crate::i18n) fn texts(lang: Lang) -> &'static Texts {
    pick!(lang; &EN, &PT_BR)
}

fn read(text: &'static str) -> Texts {
    enum TextPlace {
        Exercise(&'static str),
        List(&'static str),
    }
    let (mut texts, mut place) = (Texts::default(), None);
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
        if let Some(heading) = line.strip_prefix("# ") {
            place = Some(match heading.split_once(": ") {
                Some((id, title)) => {
                    texts.exercises.insert(id, Statement { title, ..Statement::default() });
                    TextPlace::Exercise(id)
                }
                None => TextPlace::List(heading),
            });
            continue;
        }
        match place {
            Some(TextPlace::Exercise(id)) => {
                let statement = texts.exercises.entry(id).or_default();
                match line.strip_prefix("? ").and_then(|ask| ask.split_once(": ")) {
                    Some((name, text)) => {
                        statement.asks.insert(name, text);
                    }
                    None => statement.paragraphs.push(line),
                }
            }
            Some(TextPlace::List(list)) => {
                if let Some((name, text)) = line.strip_prefix("- ").and_then(|entry| entry.split_once(": ")) {
                    texts.lists.entry(list).or_default().insert(name, text);
                }
            }
            None => {}
        }
    }
    texts
}
