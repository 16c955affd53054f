//! A lesson of anybody's, alone and below a good first step: it is refused with a line of it, or each of its steps is a
//! figure that opens by itself, with everything on the way to it and to its goal.

use camera_lab::camera::Camera;
use camera_lab::figure::{read, write};
use camera_lab::lessons::{Part, Passage, Task, parse, place};
use camera_lab_words::Lang;
use camera_lab_words::learn::lessons;

const HEAD: &str = "\
id = \"mine\"
title = \"Mine\"
[[step]]
title = \"One\"
text = \"D is {distance}.\"
[step.scene]
preset = \"house\"
";

fn try_out(text: &str) {
    let lesson = match parse(text) {
        Ok(lesson) => lesson,
        Err(error) => {
            assert!(error.line >= 1 && error.line <= text.lines().count().max(1), "{error}");
            return;
        }
    };
    for (k, step) in lesson.steps.iter().enumerate() {
        assert_eq!(read::parse(&write::to_toml(&step.figure)).as_ref(), Ok(&*step.figure));
        assert!(place(text, Part::Step(k)).is_some());
        let camera = Camera::new(&step.figure.camera).expect("each step has a camera");
        for lang in [Lang::En, Lang::PtBr] {
            let said = lessons::text(lang, step);
            assert!(!said.contains("{distance}"), "{said}");
        }
        if let Some(before) = k.checked_sub(1).and_then(|before| lesson.steps.get(before)) {
            let on_the_way = Passage::new(before.figure.clone(), step.figure.clone()).at(0.5);
            Camera::new(&on_the_way.camera).expect("each figure on the way has one");
        }
        if let Some(Task::Try(goal)) = &step.task {
            goal.reached_from(&step.figure, &camera).expect("the way to a goal was tried");
        }
    }
}

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    try_out(text);
    try_out(&format!("{HEAD}{text}"));
}
