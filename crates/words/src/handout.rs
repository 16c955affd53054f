//! Lessons and exercises on paper, for the command line and the window.

pub use crate::learn::exercise_sheet::{MAX_VERSIONS, Solutions, Version};
use crate::learn::{exercise_messages, exercise_sheet, exercises as said, lessons as texts};
use crate::{Lang, pictures};
use camera_lab_engine::appearance::Theme;
use camera_lab_engine::camera::{Camera, CameraError, ImageSize};
use camera_lab_engine::scene::Scene;
use camera_lab_figures::figure::Figure;
use camera_lab_figures::picture::{
    Composite, FormulaPart, Handout, HandoutEntry, HandoutPart, NoComposite, Paragraph, have_same_scene,
};
use camera_lab_figures::views::{Request, SharedScene, Shot, Size, View, Views};
use camera_lab_teaching::exercises::{self, Exercise, Kind};
use camera_lab_teaching::lessons::{Lesson, Question, See, Step, Task};

/// Digits of the numbers in worked steps.
const DIGITS: usize = 5;
/// Lines to write on, for a question with numbers and for one with choices, in one column and in two.
const ROOM: [[usize; 2]; 2] = [[4, 1], [2, 0]];
/// Height of the letters in pictures, in points.
const LETTERS: f32 = 7.5;
/// Width of the picture of a step in pixels, and the height of its parts.
const WIDTH: u32 = 900;
const HEIGHT: u32 = 330;

/// The greatest size of a picture in pixels.
pub const PICTURE: [u64; 2] = [WIDTH as u64, 3 * HEIGHT as u64 / 2];

/// The choices for a handout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HandoutOptions {
    /// The language of its texts.
    pub lang: Lang,
    /// One column, or two with smaller entries.
    pub columns: usize,
    /// Its solutions.
    pub answers: Solutions,
    /// It begins with the plan for the lecturer.
    pub plan: bool,
    /// Steps that answer the question before them come after all questions.
    pub late: bool,
}

impl HandoutOptions {
    /// The size of a picture.
    fn size(&self) -> Size {
        lettered(ImageSize { width: WIDTH, height: HEIGHT * if self.columns > 1 { 3 } else { 2 } / 2 }, self.columns)
    }

    const fn room(&self) -> [usize; 2] {
        ROOM[if self.columns > 1 { 1 } else { 0 }]
    }
}

/// A lesson as a handout. `draw` makes the picture of a step, counted from 0, in a size.
///
/// # Errors
/// The errors of `draw`.
pub fn of_lesson<E>(
    lesson: &Lesson,
    options: HandoutOptions,
    mut draw: impl FnMut((usize, &Step), Size) -> Result<Composite, E>,
) -> Result<Handout, E> {
    let HandoutOptions { lang, columns, .. } = options;
    let (t, room) = (texts::texts(lang), options.room());
    let mut entries = Vec::new();
    if let Some(plan) = lesson.plan.as_ref().filter(|_| options.plan) {
        let mut paragraphs = vec![Paragraph::Heading(t.plan.to_owned())];
        paragraphs.extend(set(texts::told(lang, plan)));
        entries.push(HandoutEntry { picture: None, paragraphs });
    }
    entries.push(HandoutEntry { picture: None, paragraphs: beginning(lang, lesson) });
    entries.extend(around(lang, t.pretest, &lesson.pretest, room));
    let mut late = Vec::new();
    for (k, step) in lesson.steps.iter().enumerate() {
        let on_paper = Step { figure: printed(&step.figure).into(), ..step.clone() };
        let picture = Some(draw((k, &on_paper), options.size())?);
        let entry = HandoutEntry { picture, paragraphs: of_step(lang, k, step, room) };
        if options.late && answers(lesson, k) { late.push(entry) } else { entries.push(entry) }
    }
    let after = around(lang, t.posttest, &lesson.posttest, room);
    if options.late {
        entries.extend(after.clone());
    }
    entries.extend(late);
    if let Some(sentence) = &lesson.sentence {
        let text = format!("{}: {}", t.keep, in_line(texts::told(lang, sentence)));
        entries.push(HandoutEntry { picture: None, paragraphs: vec![Paragraph::Text(text)] });
    }
    if !options.late {
        entries.extend(after);
    }
    let title = texts::told(lang, &lesson.title).to_owned();
    let mut parts = vec![HandoutPart { title, foot: String::new(), entries }];
    if options.answers != Solutions::None {
        let solutions = lesson.steps.iter().enumerate().filter_map(|(k, step)| solution(lang, k, step));
        let before = solved_around(lang, t.pretest, &lesson.pretest);
        let after = solved_around(lang, t.posttest, &lesson.posttest);
        let entries: Vec<HandoutEntry> = before.into_iter().chain(solutions).chain(after).collect();
        if !entries.is_empty() {
            parts.push(HandoutPart { title: t.solutions.to_owned(), foot: String::new(), entries });
        }
    }
    Ok(Handout { language: lang.tag(), parts, columns })
}

/// A figure with a white ground.
fn printed(figure: &Figure) -> Figure {
    let mut figure = figure.clone();
    figure.style.theme = Theme::Print;
    figure
}

/// True if a step only shows the answer to the question of the step before it.
fn answers(lesson: &Lesson, step: usize) -> bool {
    let before = step.checked_sub(1).and_then(|before| lesson.steps.get(before));
    let is_shown = before.is_some_and(|before| matches!(before.see, See::Next));
    is_shown && lesson.steps.get(step).is_some_and(|step| step.task.is_none())
}

/// Exercises as a handout: first the sheets of all versions, then their solutions. `draw` makes the picture that an
/// exercise asks to match, in a size.
///
/// # Errors
/// The errors of `draw`.
pub fn of_exercises<E>(
    versions: &[Version],
    options: HandoutOptions,
    mut draw: impl FnMut(&Figure, Size) -> Result<Composite, E>,
) -> Result<Handout, E> {
    let HandoutOptions { lang, columns, answers, .. } = options;
    let t = exercise_messages::texts(lang);
    let mut parts = Vec::new();
    for version in versions.iter().filter(|_| answers != Solutions::Alone) {
        // An underscore would begin a subscript.
        let [name, date] = [36, 18].map(|dots| "…".repeat(dots / 2));
        let line = Paragraph::Text(format!("{}: {name}  {}: {date}", t.name, t.date));
        let mut entries = vec![HandoutEntry { picture: None, paragraphs: vec![line] }];
        for (number, exercise) in (1..).zip(&version.exercises) {
            let picture = exercise.figure_to_match();
            let picture = picture.map(|figure| draw(&printed(&figure), options.size())).transpose()?;
            let title = said::exercise_title(lang, exercise);
            let mut paragraphs = vec![Paragraph::Heading(format!("{number}. {title}"))];
            paragraphs.extend(said::statement(lang, exercise).iter().flat_map(|paragraph| set(paragraph)));
            let assumptions = said::assumptions(lang, exercise);
            paragraphs.extend(assumptions.iter().map(|assumption| Paragraph::Remark(in_line(assumption))));
            paragraphs.extend(questions(lang, exercise, options.room()));
            paragraphs.push(Paragraph::Remark(exercise_messages::source_of_numbers(lang, exercise)));
            entries.push(HandoutEntry { picture, paragraphs });
        }
        parts.push(HandoutPart { title: t.exercises.to_owned(), foot: version.name(lang), entries });
    }
    for version in versions.iter().filter(|_| answers != Solutions::None) {
        let title = |number, exercise| format!("{number}. {}", said::exercise_title(lang, exercise));
        let solutions = (1..).zip(&version.exercises);
        let entries = solutions.map(|(number, exercise)| solved(lang, exercise, title(number, exercise))).collect();
        let title = texts::texts(lang).solutions.to_owned();
        parts.push(HandoutPart { title, foot: version.name(lang), entries });
    }
    Ok(Handout { language: lang.tag(), parts, columns })
}

/// "a) ", "b) " … before a question and its answer if there are several.
fn letter(exercise: &Exercise, k: usize) -> String {
    ('a'..='z').nth(k).filter(|_| exercise.asks.len() > 1).map_or_else(String::new, |letter| format!("{letter}) "))
}

/// The scenes of a handout. Figures with the same objects share one, so that equal pictures are drawn once.
#[derive(Debug, Default)]
pub struct Scenes(Vec<(Figure, SharedScene)>);

impl Scenes {
    /// The scene of a figure, which `build` makes if no figure before had it.
    ///
    /// # Errors
    /// Those of `build`.
    pub fn of<E>(&mut self, figure: &Figure, build: impl FnOnce() -> Result<Scene, E>) -> Result<SharedScene, E> {
        if let Some((_, scene)) = self.0.iter().find(|(other, _)| have_same_scene(other, figure)) {
            return Ok(scene.clone());
        }
        let scene = SharedScene::new(build()?);
        self.0.push((figure.clone(), scene.clone()));
        Ok(scene)
    }
}

/// The pictures of a figure on a handout.
///
/// # Errors
/// The camera is impossible, or the pictures have no room.
pub fn picture(
    figure: &Figure,
    scene: &SharedScene,
    views: Views,
    size: Size,
    lang: Lang,
) -> Result<Composite, NoPicture> {
    let camera = Camera::new(&figure.camera)?;
    let shot = Shot::of(figure);
    let request = Request::new(&shot, View::Image, &camera, scene, pictures::labels(lang), size);
    // A lecturer turns the pictures of a lesson in a window, whose shape differs from that of a page.
    Ok(Composite::of(views, &request, &shot, None)?.gone_back())
}

/// The reason why a figure has no picture.
#[derive(Debug, thiserror::Error)]
pub enum NoPicture {
    /// The camera is impossible.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// The pictures have no room.
    #[error(transparent)]
    Composite(#[from] NoComposite),
}

/// The views that a figure shows.
pub fn views_of(figure: &Figure) -> Views {
    let shown = figure.screen.pictures.unwrap_or([true; View::COUNT]);
    let is_it = |views: &Views| View::ALL.iter().zip(shown).all(|(view, shown)| views.contains(*view) == shown);
    Views::CHOICES.into_iter().find(is_it).unwrap_or(Views::All)
}

/// A size of a picture whose letters have [`LETTERS`] points on the page.
fn lettered(size: ImageSize, columns: usize) -> Size {
    let per_point = WIDTH as f32 / Handout::picture_width(columns);
    Size::with_letters(size.width, size.height, LETTERS * per_point)
}

fn beginning(lang: Lang, lesson: &Lesson) -> Vec<Paragraph> {
    let mut paragraphs = Vec::new();
    if !lesson.aims.is_empty() {
        paragraphs.push(Paragraph::Text(format!("{}:", texts::texts(lang).aims)));
        let aim = |aim| Paragraph::Text(format!("• {}", in_line(texts::told(lang, aim))));
        paragraphs.extend(lesson.aims.iter().map(aim));
    }
    paragraphs
}

/// Heading, text and task of a step.
fn of_step(lang: Lang, k: usize, step: &Step, room: [usize; 2]) -> Vec<Paragraph> {
    let mut paragraphs = vec![Paragraph::Heading(format!("{}. {}", k + 1, in_line(texts::told(lang, &step.title))))];
    paragraphs.extend(set(&texts::text(lang, step)));
    match &step.task {
        Some(Task::Question(entry)) => {
            let exercise = entry.exercise(0, &Default::default());
            paragraphs.extend(questions(lang, &exercise, room));
        }
        Some(Task::Exercise { id, seed }) => paragraphs.extend(of_exercise(lang, id, *seed, room)),
        Some(Task::Try(goal)) => {
            let text = texts::filled(lang, &goal.text, &step.figure);
            paragraphs.push(Paragraph::Text(format!("{}: {}", texts::texts(lang).to_try, in_line(&text))));
        }
        None => {}
    }
    paragraphs
}

/// Title, statement and questions of a built-in exercise.
fn of_exercise(lang: Lang, id: &str, seed: u64, room: [usize; 2]) -> Vec<Paragraph> {
    let Some(entry) = exercises::entry(id) else { return Vec::new() };
    let exercise = entry.exercise(seed, &Default::default());
    let mut paragraphs = vec![Paragraph::Text(said::exercise_title(lang, &exercise).to_owned())];
    paragraphs.extend(said::statement(lang, &exercise).iter().flat_map(|paragraph| set(paragraph)));
    paragraphs.extend(questions(lang, &exercise, room));
    paragraphs
}

/// The questions before or after the lesson, under a heading.
fn around(lang: Lang, heading: &str, asked: &[Question], room: [usize; 2]) -> Vec<HandoutEntry> {
    let entry = |(k, question): (usize, &Question)| {
        let mut paragraphs = of_exercise(lang, &question.id, question.seed, room);
        if k == 0 {
            paragraphs.insert(0, Paragraph::Heading(heading.to_owned()));
        }
        HandoutEntry { picture: None, paragraphs }
    };
    asked.iter().enumerate().map(entry).collect()
}

/// The solutions of the questions before or after the lesson.
fn solved_around(lang: Lang, heading: &str, asked: &[Question]) -> Vec<HandoutEntry> {
    let solved = |question: &Question| {
        let exercise = exercises::entry(&question.id)?.exercise(question.seed, &Default::default());
        let title = said::exercise_title(lang, &exercise).to_owned();
        Some(solved(lang, &exercise, format!("{heading}: {title}")))
    };
    asked.iter().filter_map(solved).collect()
}

/// The questions of an exercise, with room for the answers.
fn questions(lang: Lang, exercise: &Exercise, room: [usize; 2]) -> Vec<Paragraph> {
    let mut paragraphs = Vec::new();
    for (k, ask) in exercise.asks.iter().enumerate() {
        paragraphs.extend(set(&format!("{}{}", letter(exercise, k), said::ask(lang, exercise, ask))));
        if let Kind::Choice(choices) = &ask.kind {
            let choice = |name| Paragraph::Text(format!("☐ {}", in_line(said::choice_of(lang, ask, name))));
            paragraphs.extend(choices.iter().map(|name| choice(name.as_str())));
            paragraphs.push(Paragraph::Room(room[1]));
        } else if ask.places {
            // It's marked in the picture above.
            paragraphs.push(Paragraph::Remark(said::tolerance(lang, ask)));
        } else {
            paragraphs.push(Paragraph::Remark(said::tolerance(lang, ask)));
            paragraphs.push(Paragraph::Room(room[0]));
        }
    }
    paragraphs
}

/// The answers to the questions of a step, with their worked steps. `None` if it asks none.
fn solution(lang: Lang, k: usize, step: &Step) -> Option<HandoutEntry> {
    let exercise = match step.task.as_ref()? {
        Task::Question(entry) => entry.exercise(0, &Default::default()),
        Task::Exercise { id, seed } => exercises::entry(id)?.exercise(*seed, &Default::default()),
        Task::Try(_) => return None,
    };
    let title = in_line(texts::told(lang, &step.title));
    Some(solved(lang, &exercise, format!("{}. {title}", k + 1)))
}

/// The answers to an exercise with their worked steps, below a title.
fn solved(lang: Lang, exercise: &Exercise, title: String) -> HandoutEntry {
    let mut paragraphs = vec![Paragraph::Text(title)];
    for (k, ask) in exercise.asks.iter().enumerate() {
        paragraphs.push(answered(&letter(exercise, k), &exercise_sheet::answer(lang, ask)));
    }
    let steps = exercise.new_steps();
    for step in steps.iter().flatten() {
        let text = said::step(lang, exercise, step, DIGITS);
        // A chain of equations is one line: D = … = …
        let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
        let chained = lines.fold(String::new(), |text, line| {
            let before = if text.is_empty() || line.starts_with('=') { " " } else { "\n\n" };
            format!("{text}{before}{line}")
        });
        paragraphs.extend(set(&lowered(&chained)).into_iter().map(|paragraph| match paragraph {
            Paragraph::Text(text) => Paragraph::Remark(text),
            Paragraph::Formula(parts) => Paragraph::SmallFormula(parts),
            other => other,
        }));
    }
    HandoutEntry { picture: None, paragraphs }
}

/// An answer behind its letter. A matrix, `[[a, b], [c, d]]`, in rows.
fn answered(letter: &str, answer: &str) -> Paragraph {
    let inner = answer.strip_prefix("[[").and_then(|answer| answer.strip_suffix("]]"));
    let Some(inner) = inner else { return Paragraph::Text(format!("{letter}→ {}", in_line(answer))) };
    let separator = if inner.contains(';') { ";" } else { "," };
    let row = |row: &str| row.split(separator).map(|entry| in_line(entry.trim())).collect();
    let rows = inner.split(']').map(|rest| rest.trim_start_matches([',', ';', ' ', '[']));
    Paragraph::Formula(vec![FormulaPart::Line(format!("{letter}→")), FormulaPart::Matrix(rows.map(row).collect())])
}

/// Markdown as paragraphs. Formulas on lines of their own are paragraphs, and so are those with matrices.
fn set(markdown: &str) -> Vec<Paragraph> {
    let mut paragraphs = Vec::new();
    for (k, part) in markdown.split("$$").enumerate() {
        if k % 2 == 1 {
            paragraphs.push(Paragraph::Formula(formula(part)));
            continue;
        }
        for text in part.split("\n\n") {
            // A matrix needs more than a line, so the text before and after it gets paragraphs of its own.
            let mut line = String::new();
            for (k, part) in text.split('$').enumerate() {
                match (k % 2, part.contains(MATRIX[0])) {
                    (0, _) => line.push_str(part),
                    (_, false) => line.push_str(&format!("${part}$")),
                    (_, true) => {
                        paragraphs.push(Paragraph::Text(in_line(&std::mem::take(&mut line))));
                        paragraphs.push(Paragraph::Formula(formula(part)));
                    }
                }
            }
            paragraphs.push(Paragraph::Text(in_line(&line)));
        }
    }
    paragraphs.retain(|paragraph| *paragraph != Paragraph::Text(String::new()));
    paragraphs
}

/// A line of a worked step, in which subscripts are lowered as a whole, as in `p_11`.
fn lowered(line: &str) -> String {
    let mut text = String::with_capacity(line.len() + 8);
    let mut rest = line;
    while let Some((before, after)) = rest.split_once('_') {
        text.push_str(before);
        let end = after.find(|c: char| !c.is_alphanumeric()).unwrap_or(after.len());
        text.push_str(&if end > 1 { format!("_{{{}}}", &after[..end]) } else { format!("_{}", &after[..end]) });
        rest = &after[end..];
    }
    text + rest
}

/// Markdown on a line: without its marks, formulas as signs.
pub(crate) fn in_line(markdown: &str) -> String {
    let text = markdown.replace("$$", "$").replace("**", "").replace('\n', " ");
    let part = |(k, part): (usize, &str)| match k % 2 {
        1 => formula_in_line(part),
        _ => part.replace(['*', '`'], ""),
    };
    text.split('$').enumerate().map(part).collect::<String>().trim().to_owned()
}

/// The begin and the end of a matrix in LaTeX.
const MATRIX: [&str; 2] = ["\\begin{bmatrix}", "\\end{bmatrix}"];

/// LaTeX as signs and matrices.
fn formula(latex: &str) -> Vec<FormulaPart> {
    let mut parts = Vec::new();
    let mut rest = latex;
    let line = |latex: &str| {
        let signs = formula_in_line(latex);
        (!signs.trim().is_empty()).then(|| FormulaPart::Line(signs.trim().to_owned()))
    };
    while let Some((before, (entries, after))) =
        rest.split_once(MATRIX[0]).and_then(|(before, rest)| Some((before, rest.split_once(MATRIX[1])?)))
    {
        let row = |row: &str| row.split('&').map(|entry| formula_in_line(entry.trim())).collect();
        parts.extend(line(before));
        parts.push(FormulaPart::Matrix(entries.split("\\\\").map(row).collect()));
        rest = after;
    }
    parts.extend(line(rest));
    parts
}

/// LaTeX as signs on a line. For a matrix, the plain text of the notes.
fn formula_in_line(latex: &str) -> String {
    if latex.trim().is_empty() {
        return String::new();
    }
    // A comma between braces is the decimal mark, not a comma of a list.
    let points = latex.replace("{,}", ".").replace("\\qquad", ";\\ ");
    let set = crate::formula::set(&format!("${points}$")).unwrap_or_else(|_| crate::why::notes::plain(&points));
    if latex.contains("{,}") { set.replace('.', ",") } else { set }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;

    #[test]
    fn markdown_becomes_paragraphs_and_formulas_signs() {
        let paragraphs = set("The *eye* is **C**, $z_c = -D$.\n\nThen\n\n$$H = 2F\\tan(\\theta/2)$$");
        let text = |text: &str| Paragraph::Text(text.to_owned());
        assert_eq!(paragraphs.len(), 3);
        assert_eq!(paragraphs[1], text("Then"));
        assert!(
            matches!(&paragraphs[0], Paragraph::Text(text) if text.starts_with("The eye is C, ") && !text.contains('$'))
        );
        let Paragraph::Formula(parts) = &paragraphs[2] else { panic!("a formula") };
        assert!(matches!(&parts[..], [FormulaPart::Line(line)] if line.contains('θ')));
        assert!(in_line("$D = 6{,}53$").ends_with(" = 6,53"));
    }

    #[test]
    fn a_matrix_has_rows_in_the_middle_of_a_text_too() {
        let row = |row: [&str; 2]| row.map(str::to_owned).to_vec();
        let matrix = "\\begin{bmatrix} 1 & 0{,}5 \\\\ 0 & -1 \\end{bmatrix}";
        for text in
            [format!("The matrix $M_v = {matrix}$ turns."), format!("The matrix\n\n$$M_v = {matrix}$$\n\nturns.")]
        {
            let paragraphs = set(&text);
            let [Paragraph::Text(before), Paragraph::Formula(parts), Paragraph::Text(after)] = &paragraphs[..] else {
                panic!("{paragraphs:?}")
            };
            assert_eq!((before.as_str(), after.as_str()), ("The matrix", "turns."));
            let [FormulaPart::Line(name), FormulaPart::Matrix(rows)] = &parts[..] else { panic!("{parts:?}") };
            assert!(name.ends_with('='), "{name}");
            assert_eq!(*rows, [row(["1", "0,5"]), row(["0", "−1"])]);
        }
        for answer in ["[[1, 0.5], [0, -1]]", "[[1; 0,5]; [0; -1]]"] {
            let Paragraph::Formula(parts) = answered("", answer) else { panic!("a matrix") };
            let FormulaPart::Matrix(rows) = &parts[1] else { panic!("a matrix") };
            assert_eq!(rows.iter().map(Vec::len).collect::<Vec<_>>(), [2, 2], "{rows:?}");
        }
        assert_eq!(answered("b) ", "(1, 2)"), Paragraph::Text("b) → (1, 2)".to_owned()));
        assert_eq!(lowered("p_11 = 2F/W_c"), "p_{11} = 2F/W_c");
    }

    #[test]
    fn each_page_of_a_version_has_its_number_and_each_answer_its_letter() {
        use camera_lab_engine::progress::{Progress, at_once};
        use camera_lab_figures::export::vector::{Item, Page};

        fn texts(items: &[Item]) -> Vec<String> {
            let text = |item: &Item| match item {
                Item::Text(text) => vec![text.text.clone()],
                Item::Group { items, .. } => texts(items),
                _ => Vec::new(),
            };
            items.iter().flat_map(text).collect()
        }
        let of = |id: &str, seed| exercises::entry(id).map(|entry| entry.exercise(seed, &Default::default()));
        let version = |number: u64| {
            let exercises = ["basis", "0-5.1", "view-matrix"].iter().filter_map(|id| of(id, number)).collect();
            Version { number: Some(number), exercises }
        };
        let versions: Vec<Version> = (7..=9).map(version).collect();
        let pages = |answers| -> Vec<Vec<String>> {
            let options = HandoutOptions { lang: Lang::PtBr, columns: 1, answers, plan: false, late: false };
            let made = of_exercises(&versions, options, |_, _| Err(())).unwrap();
            let pages: Vec<Page> = at_once(made.pages(&Progress::default())).unwrap();
            pages.iter().map(|page| texts(&page.items)).collect()
        };
        for answers in [Solutions::None, Solutions::Alone, Solutions::AtEnd] {
            let pages = pages(answers);
            let feet: Vec<&String> = pages.iter().filter_map(|page| page.last()).collect();
            assert!(feet.iter().all(|foot| foot.starts_with("Versão ")), "{feet:?}");
            let has = |number: u64| feet.iter().any(|foot| **foot == format!("Versão {number}  ·  1"));
            assert!((7..=9).all(has), "{feet:?}");
            // No exercise is cut: its last line stands on the page of its title.
            let first = &versions[0].exercises[0];
            let title = format!("1. {}", said::exercise_title(Lang::PtBr, first));
            let page = pages.iter().find(|page| page.contains(&title)).unwrap();
            let (last, answer) = ("basis, semente 7".to_owned(), "b) →");
            let alone = answers == Solutions::Alone;
            assert_eq!(page.contains(&last), !alone, "{page:?}");
            assert_eq!(page.iter().any(|text| text.starts_with(answer)), alone, "{page:?}");
        }
    }

    /// On paper, a ground that isn't white is a grey stain.
    #[test]
    fn pictures_of_a_handout_have_the_theme_for_paper() {
        let options = HandoutOptions { lang: Lang::En, columns: 1, answers: Solutions::None, plan: false, late: false };
        let mut themes = Vec::new();
        let lesson = &camera_lab_teaching::lessons::shipped()[0].lesson;
        let drawn = of_lesson(lesson, options, |(_, step), _| {
            themes.push(step.figure.style.theme);
            Err::<Composite, ()>(())
        });
        assert!(drawn.is_err() && themes == [Theme::Print]);
    }
}
