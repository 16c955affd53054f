//! The exercises that a lesson leads to, and the lesson that leads to an exercise.

use std::sync::Arc;

use super::lesson::{Lesson, Link, Step, Task};
use super::shipped::shipped;
use crate::exercises::{self, Entry};

/// The way from an exercise back to its lesson.
#[derive(Clone, Debug)]
pub struct Way {
    /// The lesson, one of the program.
    pub lesson: Arc<Lesson>,
    /// The step that asks the exercise or names it, from 0. The first one if only the questions around the lesson do.
    pub step: usize,
}

/// The identifiers of the exercises of the program that a lesson leads to, each once: exercises that its steps ask or
/// link to, and the questions before and after it.
pub fn exercises_of(lesson: &Lesson) -> Vec<&str> {
    let around = lesson.pretest.iter().chain(&lesson.posttest).map(|question| question.id.as_str());
    let asked = lesson.steps.iter().filter_map(asked);
    let linked = lesson.steps.iter().flat_map(linked);
    let mut ids: Vec<&str> = Vec::new();
    for id in asked.chain(linked).chain(around) {
        if !ids.contains(&id) {
            ids.push(id);
        }
    }
    ids
}

/// The minutes that the exercises of its steps take, about.
pub fn exercise_minutes(lesson: &Lesson) -> u16 {
    lesson.steps.iter().filter_map(asked).filter_map(|id| exercises::entry(id)?.minutes).sum()
}

/// The families among [`exercises_of`].
pub fn families_of(lesson: &Lesson) -> Vec<&str> {
    let is_family = |id: &&str| exercises::entry(id).is_some_and(|entry| entry.is_family);
    exercises_of(lesson).into_iter().filter(is_family).collect()
}

/// The first lesson of the program that asks an exercise. If none does, the first that links to it, or has it among the
/// questions around it. `None` for a lecturer's own exercise.
pub fn lesson_of(exercise: &str) -> Option<Way> {
    let asks = |step: &Step| asked(step) == Some(exercise);
    let links = |step: &Step| linked(step).any(|id| id == exercise);
    let first = |names: &dyn Fn(&Step) -> bool| {
        shipped().iter().find_map(|shipped| {
            let step = shipped.lesson.steps.iter().position(names)?;
            Some(Way { lesson: shipped.lesson.clone(), step })
        })
    };
    first(&asks).or_else(|| first(&links)).or_else(|| {
        let lesson = shipped().iter().find(|shipped| exercises_of(&shipped.lesson).contains(&exercise))?;
        Some(Way { lesson: lesson.lesson.clone(), step: 0 })
    })
}

/// Exercises in the order in which the lessons of the program come to them. Exercises without a lesson come last.
pub fn in_order_of_lessons<'a>(entries: impl IntoIterator<Item = &'a Entry>) -> Vec<&'a Entry> {
    let asked = shipped().iter().flat_map(|shipped| shipped.lesson.steps.iter().filter_map(asked));
    let named = shipped().iter().flat_map(|shipped| exercises_of(&shipped.lesson));
    let order: Vec<&str> = asked.chain(named).collect();
    let mut entries: Vec<&Entry> = entries.into_iter().collect();
    entries.sort_by_key(|entry| order.iter().position(|id| *id == entry.id).unwrap_or(order.len()));
    entries
}

/// The family that a lesson of the program comes to after a question, by the question's identifier. `None` for other
/// questions.
pub fn family_after(question: &str) -> Option<&'static str> {
    let is_it = |step: &Step| matches!(&step.task, Some(Task::Question(entry)) if entry.id == question);
    shipped().iter().find_map(|shipped| {
        let steps = &shipped.lesson.steps;
        let at = steps.iter().position(is_it)?;
        let later = steps[at..].iter().flat_map(|step| asked(step).into_iter().chain(linked(step)));
        let mut all = later.chain(exercises_of(&shipped.lesson));
        all.find(|id| exercises::entry(id).is_some_and(|entry| entry.is_family))
    })
}

/// The exercise that a step asks.
fn asked(step: &Step) -> Option<&str> {
    match &step.task {
        Some(Task::Exercise { id, .. }) => Some(id),
        _ => None,
    }
}

/// The exercises that a step links to.
fn linked(step: &Step) -> impl Iterator<Item = &str> {
    step.links.iter().filter_map(|link| match link {
        Link::Exercise(id, _) => Some(id.as_str()),
        Link::Note(_) | Link::Lesson(..) => None,
    })
}
