//! The texts of a lecturer's own exercises.

use std::collections::BTreeMap;

use super::value::Table;
use crate::exercises::mistakes::mistake::Mistake;
use crate::figure::Localized;

/// The texts of an exercise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OwnTexts {
    /// One line in each language.
    pub title: Localized,
    /// Its statement in Markdown.
    pub statement: Localized,
    /// Readings of the source that the exercise chooses.
    pub assumptions: Vec<Localized>,
    /// The questions, by the names of the asks.
    pub asks: BTreeMap<String, Localized>,
}

/// A wrong answer that a lecturer expects.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnMistake {
    /// The answer that makes this mistake likely.
    pub answer: ExpectedAnswer,
    /// The known mistake that it makes, if any.
    pub mistake: Option<Mistake>,
    /// The sentence for students who give this answer.
    pub message: Localized,
    /// Hints, weaker ones first.
    pub hints: Vec<Localized>,
}

/// An answer as a lecturer writes it.
#[derive(Clone, Debug, PartialEq)]
pub enum ExpectedAnswer {
    /// Numbers.
    Numbers(Table),
    /// One of the choices, from 0.
    Choice(usize),
}
