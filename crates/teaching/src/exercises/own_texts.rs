//! The texts of a lecturer's own exercises.

use std::collections::BTreeMap;

use super::value::Table;
use crate::exercises::mistakes::mistake::Mistake;
use crate::figure::Bilingual;

/// The texts of an exercise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct OwnTexts {
    /// Its title.
    pub title: Bilingual,
    /// Its statement in Markdown.
    pub statement: Bilingual,
    /// The assumptions.
    pub assumptions: Vec<Bilingual>,
    /// The questions, by the names of the asks.
    pub asks: BTreeMap<String, Bilingual>,
}

/// A wrong answer that a lecturer expects.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnMistake {
    /// The answer.
    pub answer: ExpectedAnswer,
    /// The known mistake that it is, if any.
    pub mistake: Option<Mistake>,
    /// The message.
    pub message: Bilingual,
    /// Hints, weaker ones first.
    pub hints: Vec<Bilingual>,
}

/// An answer as a lecturer gives it.
#[derive(Clone, Debug, PartialEq)]
pub enum ExpectedAnswer {
    /// Numbers.
    Numbers(Table),
    /// One of the choices, from 0.
    Choice(usize),
}
