//! The task of a step as its author types it. Every field is a text, which the reader of lessons judges.

use toml_edit::{Array, ArrayOfTables, DocumentMut, InlineTable, Item, Table, TableLike, Value};

use super::items::{number_item, told, told_item};
use crate::figure::Localized;
use crate::inspect::quantity::QuantityPath;

/// Number of choices in a new question.
const CHOICES: usize = 2;

/// A kind of task.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum TaskKind {
    /// No task.
    #[default]
    None,
    /// A question with choices.
    Choices,
    /// A question whose answer is a number, several numbers, or a quantity of the figure.
    Number,
    /// Something to reach with the controls.
    Goal,
    /// An exercise of the program.
    Exercise,
    /// A task with keys that these fields don't have. It stays as it is in the file.
    InFile,
}

/// The task of a step as its author types it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TaskText {
    /// Its kind. Only the fields of this kind are written.
    pub kind: TaskKind,
    /// The question or the goal, in Markdown.
    pub text: Localized,
    /// The choices in their order.
    pub choices: Vec<ChoiceText>,
    /// The index of the right choice.
    pub right: usize,
    /// The right number, a list of numbers, a formula, or the path of a quantity in the output of `inspect`.
    pub number: String,
    /// The greatest error of a number. Empty for the program's default.
    pub tolerance: String,
    /// Wrong numbers, each with its sentence.
    pub mistakes: Vec<(String, Localized)>,
    /// Keys of a question that have no field, such as `see` and `place`, with their values from the file.
    pub kept: Vec<(String, String)>,
    /// The same of mistakes that have a place, each with its sentence.
    pub kept_mistakes: Vec<(Vec<(String, String)>, Localized)>,
    /// The conditions of a goal.
    pub conditions: Vec<ConditionText>,
    /// Operations and keys that lead to the goal, separated by `;`.
    pub way: String,
    /// The identifier of an exercise.
    pub exercise: String,
    /// The source of the numbers of an exercise.
    pub seed: String,
}

/// A choice of a question.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ChoiceText {
    /// The name under which answers are stored.
    pub name: String,
    /// The text of the choice.
    pub text: Localized,
    /// The sentence shown to students who choose it. Unused for the right one.
    pub message: Localized,
}

/// A kind of condition.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ConditionKind {
    /// A quantity lies between two numbers.
    #[default]
    Quantity,
    /// An object is visible in the image.
    Seen,
    /// An object isn't visible in the image.
    Hidden,
}

/// A condition of a goal.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ConditionText {
    /// Its kind.
    pub kind: ConditionKind,
    /// The path of the quantity, or the name of the object.
    pub name: String,
    /// The least number. May be empty.
    pub least: String,
    /// The greatest number. May be empty.
    pub most: String,
}

impl TaskText {
    /// True while its author still has to fill in the question, a choice or the number.
    pub fn is_unfinished(&self) -> bool {
        let is_blank = |text: &Localized| text.iter().all(|(_, text)| text.trim().is_empty());
        match self.kind {
            TaskKind::None | TaskKind::Exercise | TaskKind::InFile => false,
            TaskKind::Choices => is_blank(&self.text) || self.choices.iter().any(|choice| is_blank(&choice.text)),
            TaskKind::Number => is_blank(&self.text) || self.number.trim().is_empty(),
            TaskKind::Goal => is_blank(&self.text),
        }
    }

    /// The task in the text of a step, as in the file.
    pub fn of_step(step: &str) -> Self {
        let Ok(document) = step.parse::<DocumentMut>() else { return Self::default() };
        let step = document.get("step").and_then(Item::as_array_of_tables).and_then(|steps| steps.get(0));
        let table = |key| step.and_then(|step| step.get(key)).and_then(Item::as_table_like);
        let read = match (table("ask"), table("try")) {
            (None, None) => return Self::default(),
            (Some(ask), None) => read_question(ask),
            (None, Some(goal)) => read_goal(goal),
            (Some(_), Some(_)) => None,
        };
        read.unwrap_or(Self { kind: TaskKind::InFile, ..Self::default() })
    }

    /// The text of a step that has only this task.
    pub fn to_toml(&self) -> String {
        let mut step = Table::new();
        self.put(&mut step);
        let mut steps = ArrayOfTables::new();
        steps.push(step);
        let mut document = DocumentMut::new();
        document.insert("step", Item::ArrayOfTables(steps));
        document.to_string()
    }

    /// The same task with another kind, and with the empty fields that this kind starts with.
    pub fn with_kind(mut self, kind: TaskKind) -> Self {
        self.kind = kind;
        while kind == TaskKind::Choices && self.choices.len() < CHOICES {
            self.add_choice();
        }
        if kind == TaskKind::Goal && self.conditions.is_empty() {
            self.conditions.push(ConditionText::default());
        }
        self
    }

    /// Adds an empty choice. Its name is a letter that no other choice has.
    pub fn add_choice(&mut self) {
        let is_free = |name: &String| self.choices.iter().all(|choice| choice.name != *name);
        let letters = ('a'..='z').map(String::from);
        let numbers = (1_usize..).map(|number| format!("choice-{number}"));
        let name = letters.chain(numbers).find(is_free).unwrap_or_default();
        self.choices.push(ChoiceText { name, ..ChoiceText::default() });
    }

    /// Removes a choice. The right one stays right as long as it's there.
    pub fn remove_choice(&mut self, place: usize) {
        if place < self.choices.len() {
            self.choices.remove(place);
            if self.right > place || self.right == self.choices.len() {
                self.right = self.right.saturating_sub(1);
            }
        }
    }

    /// Writes the task into the table of a step, replacing the one that's there.
    pub(super) fn put(&self, step: &mut Table) {
        if self.kind == TaskKind::InFile {
            return;
        }
        step.remove("ask");
        step.remove("try");
        let mut table = Table::new();
        let key = match self.kind {
            TaskKind::None | TaskKind::InFile => return,
            TaskKind::Goal => "try",
            TaskKind::Choices | TaskKind::Number | TaskKind::Exercise => "ask",
        };
        match self.kind {
            TaskKind::Exercise => {
                table.insert("exercise", Item::Value(self.exercise.trim().into()));
                put_number(&mut table, "seed", &self.seed);
            }
            TaskKind::Goal => self.put_goal(&mut table),
            _ => self.put_question(&mut table),
        }
        step.insert(key, Item::Table(table));
    }

    fn put_question(&self, table: &mut Table) {
        table.insert("text", told_item(&self.text));
        let mut mistakes = ArrayOfTables::new();
        let mut add = |answer: Option<Item>, message: &Localized| {
            let mut mistake = Table::new();
            answer.into_iter().for_each(|answer| drop(mistake.insert("answer", answer)));
            mistake.insert("message", told_item(message));
            mistakes.push(mistake);
        };
        if self.kind == TaskKind::Choices {
            let right = self.choices.get(self.right).map_or("", |choice| &*choice.name);
            table.insert("answer", Item::Value(right.into()));
            let mut choices = Table::new();
            for (place, choice) in self.choices.iter().enumerate() {
                choices.insert(&choice.name, told_item(&choice.text));
                if place != self.right && choice.message != Localized::default() {
                    add(Some(Item::Value(choice.name.as_str().into())), &choice.message);
                }
            }
            table.insert("choices", Item::Table(choices));
        } else {
            if QuantityPath::of(self.number.trim()).is_some() {
                table.insert("quantity", Item::Value(self.number.trim().into()));
            } else {
                put_number(table, "answer", &self.number);
            }
            put_number(table, "tolerance", &self.tolerance);
            self.mistakes.iter().for_each(|(answer, message)| add(numbers_item(answer), message));
        }
        // A typed number replaces a place.
        let is_replaced = self.kind == TaskKind::Choices || !self.number.trim().is_empty();
        for (key, written) in &self.kept {
            if let Some(value) = written.parse::<Value>().ok().filter(|_| key != PLACE || !is_replaced) {
                table.insert(key, Item::Value(value));
            }
        }
        for (kept, message) in self.kept_mistakes.iter().filter(|_| !is_replaced) {
            let mut mistake = Table::new();
            let values = kept.iter().filter_map(|(key, written)| Some((key, written.parse::<Value>().ok()?)));
            values.for_each(|(key, value)| drop(mistake.insert(key, Item::Value(value))));
            mistake.insert("message", told_item(message));
            mistakes.push(mistake);
        }
        if !mistakes.is_empty() {
            table.insert("mistake", Item::ArrayOfTables(mistakes));
        }
    }

    fn put_goal(&self, table: &mut Table) {
        table.insert("text", told_item(&self.text));
        let until = self.conditions.iter().map(|condition| {
            let mut table = InlineTable::new();
            let name = Value::from(condition.name.trim());
            match condition.kind {
                ConditionKind::Seen => drop(table.insert("seen", name)),
                ConditionKind::Hidden => drop(table.insert("hidden", name)),
                ConditionKind::Quantity => {
                    table.insert("quantity", name);
                    for (key, typed) in [("least", &condition.least), ("most", &condition.most)] {
                        if let Some(Item::Value(value)) = number_item(typed) {
                            table.insert(key, value);
                        }
                    }
                }
            }
            table
        });
        table.insert("until", Item::Value(until.collect::<Array>().into()));
        let way: Array = self.way.split(';').map(str::trim).filter(|way| !way.is_empty()).collect();
        if !way.is_empty() {
            table.insert("way", Item::Value(way.into()));
        }
    }
}

/// A number, or a list of numbers. `None` for an empty text.
fn numbers_item(typed: &str) -> Option<Item> {
    let is_list = typed.trim().starts_with('[');
    let list = is_list.then(|| typed.trim().parse::<Value>().ok()).flatten();
    list.map(Item::Value).or_else(|| number_item(typed))
}

fn put_number(table: &mut Table, key: &str, typed: &str) {
    if let Some(item) = numbers_item(typed) {
        table.insert(key, item);
    }
}

/// The keys of a question without fields.
const SEE: &str = "see";
const PLACE: &str = "place";
const ASKS: &str = "asks";
const BECAUSE: &str = "because";
const SECOND: &str = crate::exercises::SECOND;

/// A question or an exercise; `None` if it has more than the fields.
fn read_question(ask: &dyn TableLike) -> Option<TaskText> {
    if ask.contains_key("exercise") {
        only(ask, &["exercise", "seed"])?;
        let [exercise, seed] = ["exercise", "seed"].map(|key| typed(ask.get(key)));
        return Some(TaskText { kind: TaskKind::Exercise, exercise, seed, ..TaskText::default() });
    }
    only(ask, &["text", "answer", "quantity", "choices", "tolerance", "mistake", SEE, PLACE, ASKS, BECAUSE, SECOND])?;
    let mut task = TaskText { kind: TaskKind::Number, text: told(ask.get("text"))?, ..TaskText::default() };
    let kept = |of: &dyn TableLike| -> Vec<(String, String)> {
        let kept =
            [SEE, PLACE, ASKS, BECAUSE, SECOND].into_iter().filter_map(|key| Some((key, of.get(key)?.as_value()?)));
        kept.map(|(key, value)| (key.to_owned(), value.to_string().trim().to_owned())).collect()
    };
    task.kept = kept(ask);
    let mut mistakes = Vec::new();
    for mistake in ask.get("mistake").and_then(Item::as_array_of_tables).into_iter().flatten() {
        if mistake.contains_key(PLACE) {
            only(mistake, &[SEE, PLACE, "message"])?;
            task.kept_mistakes.push((kept(mistake), told(mistake.get("message"))?));
            continue;
        }
        only(mistake, &["answer", "message"])?;
        mistakes.push((typed(mistake.get("answer")), told(mistake.get("message"))?));
    }
    let answer = typed(ask.get("answer"));
    let Some(choices) = ask.get("choices") else {
        task.number = if ask.contains_key("quantity") { typed(ask.get("quantity")) } else { answer };
        task.tolerance = typed(ask.get("tolerance"));
        task.mistakes = mistakes;
        return Some(task);
    };
    only(ask, &["text", "answer", "choices", "mistake", SEE, ASKS, BECAUSE])?;
    task.kind = TaskKind::Choices;
    let mut add = |name: &str, text: Localized| {
        let place = mistakes.iter().position(|(answer, _)| answer == name);
        let message = place.map(|place| mistakes.swap_remove(place).1).unwrap_or_default();
        task.choices.push(ChoiceText { name: name.to_owned(), text, message });
    };
    if let Some(list) = choices.as_array() {
        for word in list.iter().filter_map(Value::as_str) {
            add(word, Localized::same(word));
        }
    } else {
        choices.as_table_like()?.iter().try_for_each(|(name, text)| told(Some(text)).map(|text| add(name, text)))?;
    }
    task.right = task.choices.iter().position(|choice| choice.name == answer)?;
    // Two sentences for one choice, or a sentence for a choice that isn't there.
    mistakes.is_empty().then_some(task)
}

/// A goal; `None` if it has more than the fields.
fn read_goal(goal: &dyn TableLike) -> Option<TaskText> {
    only(goal, &["text", "until", "way"])?;
    let text = told(goal.get("text"))?;
    let conditions = goal.get("until")?.as_array()?.iter().map(|condition| {
        let table = condition.as_inline_table()?;
        only(table, &["quantity", "seen", "hidden", "least", "most"])?;
        let of = |key| table.get(key).map(written);
        let (kind, name) = match (of("quantity"), of("seen"), of("hidden")) {
            (Some(path), None, None) => (ConditionKind::Quantity, path),
            (None, Some(name), None) => (ConditionKind::Seen, name),
            (None, None, Some(name)) => (ConditionKind::Hidden, name),
            _ => return None,
        };
        let [least, most] = ["least", "most"].map(|key| of(key).unwrap_or_default());
        Some(ConditionText { kind, name, least, most })
    });
    let conditions = conditions.collect::<Option<Vec<_>>>()?;
    let way: Vec<&str> =
        goal.get("way").and_then(Item::as_array).into_iter().flatten().filter_map(Value::as_str).collect();
    Some(TaskText { kind: TaskKind::Goal, text, conditions, way: way.join("; "), ..TaskText::default() })
}

/// `None` if the table has a key that isn't one of these.
fn only(table: &dyn TableLike, keys: &[&str]) -> Option<()> {
    table.iter().all(|(key, _)| keys.contains(&key)).then_some(())
}

/// A value as an author types it.
fn typed(item: Option<&Item>) -> String {
    item.and_then(Item::as_value).map(written).unwrap_or_default()
}

fn written(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string().trim().to_owned(), str::to_owned)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::exercises::{judge_answer, read_answer};
    use crate::lessons::{Task, Words, parse, reworded, shipped, text_of_step};

    const HEAD: &str = "id = \"x\"\ntitle = \"x\"\n\n[[step]]\ntitle = \"a\"\ntext = \"b\"\n";

    fn both(text: &str) -> Localized {
        Localized::from([text.to_owned(), format!("{text} (pt)")])
    }

    fn with(task: TaskText) -> Result<Task, crate::figure::FigureError> {
        let (text, lesson) = reworded(HEAD, &[Words::Task(0, Box::new(task.clone()))])?;
        assert_eq!(TaskText::of_step(text_of_step(&text, 0).unwrap()), task);
        Ok(lesson.steps[0].task.clone().unwrap())
    }

    fn is_right(task: &Task, answer: &str) -> bool {
        let Task::Question(entry) = task else { panic!("{task:?}") };
        let exercise = entry.exercise(0, &Default::default());
        let ask = &exercise.asks[0];
        judge_answer(ask, read_answer(answer, ask, &[]).unwrap()).right
    }

    /// All of a task. The sentences for wrong answers may be in another order.
    fn described(task: &Option<Task>) -> String {
        let Some(Task::Question(entry)) = task else { return format!("{task:?}") };
        let mut exercise = entry.exercise(0, &Default::default());
        exercise.asks[0].own_mistakes.sort_by_key(|mistake| format!("{mistake:?}"));
        format!("{} {exercise:?}", entry.id)
    }

    #[test]
    fn tasks_of_all_lessons_come_back_as_they_were() {
        for shipped in shipped() {
            let count = shipped.lesson.steps.len();
            for (step, place) in shipped.lesson.steps.iter().zip(0..count) {
                let task = TaskText::of_step(text_of_step(shipped.text, place).unwrap());
                let name = format!("{} {place}", shipped.lesson.id);
                assert_eq!(task.kind == TaskKind::None, step.task.is_none(), "{name}");
                assert_ne!(task.kind, TaskKind::InFile, "{name}");
                let (_, lesson) = reworded(shipped.text, &[Words::Task(place, Box::new(task.clone()))]).unwrap();
                let [old, new] = [&step.task, &lesson.steps[place].task].map(described);
                assert_eq!(old, new, "{name}");
                assert_eq!(TaskText::of_step(&task.to_toml()), task, "{name}");
            }
        }
    }

    #[test]
    fn questions_typed_in_fields_are_judged() {
        let mut task = TaskText { text: both("Which?"), ..TaskText::default() }.with_kind(TaskKind::Choices);
        task.add_choice();
        for (place, choice) in task.choices.iter_mut().enumerate() {
            choice.text = both(&format!("choice {place}"));
        }
        task.right = 1;
        task.choices[2].message = both("Look again.");
        let choices = with(task.clone()).unwrap();
        assert!(is_right(&choices, "b") && !is_right(&choices, "c"));
        task.remove_choice(0);
        assert_eq!((task.right, &*task.choices[task.right].name), (0, "b"));
        task.add_choice();
        assert_eq!(task.choices[2].name, "a", "the name is free again");
        // A choice without a text can't be asked.
        assert!(with(task).is_err());

        let number = |number: &str, tolerance: &str| {
            let (number, tolerance) = (number.to_owned(), tolerance.to_owned());
            let task = TaskText { text: both("How much?"), number, tolerance, ..TaskText::default() };
            with(task.with_kind(TaskKind::Number))
        };
        assert!(is_right(&number("2.5", "0.1").unwrap(), "2.58"));
        assert!(!is_right(&number("2.5", "0.1").unwrap(), "2.65"));
        assert!(is_right(&number("sqrt(2)", "").unwrap(), "1.41421"));
        assert!(is_right(&number("[1, 2, 3]", "").unwrap(), "[1, 2, 3]"));
        let distance = parse(HEAD).unwrap().steps[0].figure.camera;
        let distance = (distance.focal_point - distance.position).length();
        assert!(is_right(&number("distance", "").unwrap(), &distance.to_string()));
        for refused in ["", "far away", "camera.nonsense"] {
            assert!(number(refused, "").is_err(), "{refused}");
        }
    }

    #[test]
    fn tasks_beyond_the_fields_stay_in_the_file() {
        let ask = "[step.ask]\ntext = \"c\"\nanswer = 30\nunit = \"degrees\"\n";
        let text = format!("{HEAD}\n{ask}");
        let task = TaskText::of_step(text_of_step(&text, 0).unwrap());
        assert_eq!(task.kind, TaskKind::InFile);
        let (after, _) = reworded(&text, &[Words::Task(0, Box::new(task))]).unwrap();
        assert!(after.ends_with(ask), "{after}");
    }
}
