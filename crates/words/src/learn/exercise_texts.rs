//! The texts of exercises, written in `assets/exercises`.
//!
//! A file is read line by line. `# id: title` begins an exercise, whose other lines are paragraphs of the statement in
//! Markdown, and `? name: text` its questions. `# name` begins a list of `- name: text`.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use crate::{Lang, pages};

/// The texts of one language.
#[derive(Debug, Default)]
pub(crate) struct Texts {
    pub(crate) exercises: BTreeMap<&'static str, Statement>,
    pub(crate) lists: BTreeMap<&'static str, BTreeMap<&'static str, &'static str>>,
}

/// The texts of an exercise.
#[derive(Debug, Default)]
pub(crate) struct Statement {
    pub(crate) title: &'static str,
    pub(crate) paragraphs: Vec<&'static str>,
    pub(crate) asks: BTreeMap<&'static str, &'static str>,
}

/// By the numbers of the languages.
static TEXTS: [OnceLock<Texts>; Lang::ALL.len()] = [const { OnceLock::new() }; Lang::ALL.len()];

/// The texts of a language.
pub(crate) fn texts(lang: Lang) -> &'static Texts {
    TEXTS[lang as usize].get_or_init(|| read(pages::exercises(lang)))
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
