//! The lines and keys of a lesson file to which faults in its scenes or its folder refer.

use crate::figure::read::{Section, line_of, parse_with};

/// A part of a lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The keys before the first step.
    Head,
    /// The lessons before it.
    Before,
    /// A step, from 0.
    Step(usize),
    /// A link of a step, both from 0.
    Link(usize, usize),
    /// The conditions of the goal of a step.
    Until(usize),
    /// A condition of a goal, from 0.
    Condition(usize, usize),
    /// The way to the goal of a step.
    Way(usize),
}

/// The line of a part in the text of a lesson, from 1, and its key as written; `None` if it isn't there.
pub fn place(text: &str, part: Part) -> Option<(usize, String)> {
    let found = parse_with(text, |root, _| within(root, part)).ok().flatten();
    found.map(|(at, key)| (line_of(text, at), key))
}

/// The place in the text, and the key.
fn within(mut root: Section<'_>, part: Part) -> Option<(usize, String)> {
    let of = |section: &Section<'_>, key: &str| Some((section.place(key)?, section.name_of(key)));
    let mut step = |number: usize| root.sections("step", "[[step]]").into_iter().nth(number);
    match part {
        Part::Head => Some((root.place("id")?, String::new())),
        Part::Before => of(&root, "before"),
        Part::Step(number) => step(number).map(|step| (step.at, step.name_of("").trim().to_owned())),
        Part::Link(number, link) => {
            let link = step(number)?.sections("links", "[[step.links]]").into_iter().nth(link)?;
            ["note", "lesson", "exercise"].into_iter().find_map(|key| of(&link, key))
        }
        Part::Until(number) => of(&step(number)?.section("try", "[step.try]"), "until"),
        Part::Condition(number, condition) => {
            let mut goal = step(number)?.section("try", "[step.try]");
            let condition = goal.sections("until", "[step.try] until.").into_iter().nth(condition)?;
            ["seen", "hidden", "quantity", "angle", "key"].into_iter().find_map(|key| of(&condition, key))
        }
        Part::Way(number) => of(&step(number)?.section("try", "[step.try]"), "way"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_the_line_and_the_key_under_which_they_are_written() {
        let text = "\
id = \"a\"
before = [\"b\"]
[[step]]
title = \"A\"
links = [
    { note = \"C\" },
    { lesson = \"b\" },
]
[[step]]
title = \"B\"
[step.try]
text = \"C\"
way = [\"zoom=2\"]
[[step.try.until]]
least = 1
quantity = \"distance\"
[[step.try.until]]
seen = \"door\"
";
        let of = |part| place(text, part);
        let at = |line: usize, key: &str| Some((line, key.to_owned()));
        assert_eq!(of(Part::Before), at(2, "before"));
        assert_eq!(of(Part::Step(1)), at(9, "[[step]]"));
        assert_eq!(of(Part::Link(0, 1)), at(7, "[[step.links]] lesson"));
        assert_eq!(of(Part::Condition(1, 0)), at(16, "[step.try] until.quantity"));
        assert_eq!(of(Part::Condition(1, 1)), at(18, "[step.try] until.seen"));
        assert_eq!(of(Part::Way(1)), at(13, "[step.try] way"));
        assert!(of(Part::Until(1)).is_some_and(|(line, key)| (14..=17).contains(&line) && key == "[step.try] until"));
        assert_eq!((of(Part::Condition(1, 2)), of(Part::Way(0)), of(Part::Step(2))), (None, None, None));
    }
}
