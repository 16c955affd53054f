//! What a lecturer's own exercises say.

use std::collections::BTreeMap;

use super::mistake::Mistake;
use super::value::Table;

/// A text in both languages.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Told {
    /// In English.
    pub en: String,
    /// In Portuguese.
    pub pt_br: String,
}

impl From<[String; 2]> for Told {
    fn from([en, pt_br]: [String; 2]) -> Self {
        Self { en, pt_br }
    }
}

/// The texts of an exercise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OwnTexts {
    /// Its title.
    pub title: Told,
    /// Its statement in Markdown.
    pub statement: Told,
    /// How it is read.
    pub assumptions: Vec<Told>,
    /// What is asked, by the names of the asks.
    pub asks: BTreeMap<String, Told>,
}

/// A wrong answer that a lecturer expects.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnMistake {
    /// The answer.
    pub answer: Given,
    /// Which of the known mistakes it is, if it is one.
    pub mistake: Option<Mistake>,
    /// What is said of it.
    pub message: Told,
    /// Hints, weaker ones first.
    pub hints: Vec<Told>,
}

/// An answer as a lecturer gives it.
#[derive(Clone, Debug, PartialEq)]
pub enum Given {
    /// Numbers.
    Numbers(Table),
    /// One of the choices, from 0.
    Choice(usize),
}
