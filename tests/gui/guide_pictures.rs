//! The pictures of windows in the guides, a window for each explanation and the whole one:
//! `cargo test --test gui guide_pictures -- --ignored` draws them again, as a part of `docs/pictures.sh`.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::path::PathBuf;
use std::time::Duration;

use camera_lab::camera::Decomposition;
use camera_lab::camera::{Camera, MatrixKind, Reading, recover};
use camera_lab::exercises::{Free, check, entry};
use camera_lab::explain::Matrix;
use camera_lab::figure::Explanation;
use camera_lab::figure::NamedPoint;
use camera_lab::figure::ShownStep;
use camera_lab::gui::learn::exercises::state::{Checked, Chosen, Described, Typed, joined};
use camera_lab::gui::{Start, State};
use camera_lab::scene::{ObjectSpec, Preset, Shape};
use camera_lab::views::View;
use camera_lab_desk::scene_tree::Selected;
use camera_lab_words::Lang;
use glam::{DMat4, DVec3};

use super::pictures::write;
use super::window::Window;

/// The picture shown beside a tab.
struct Shown {
    tab: Explanation,
    /// The name of the file.
    name: &'static str,
    view: View,
    change: fn(&mut State),
}

const ALL: [Shown; 9] = [
    Shown { tab: Explanation::Point, name: "point", view: View::Image, change: |_| () },
    Shown {
        tab: Explanation::Steps,
        name: "steps",
        view: View::Canonical,
        change: |state| {
            state.model.desk.shown.show_mut().step = Some(ShownStep { way: Decomposition::Notes, at: Some(2.6) });
        },
    },
    Shown {
        tab: Explanation::Homogeneous,
        name: "w",
        view: View::Image,
        change: |state| state.model.desk.shown.edit(|figure| figure.reveal.vanishing = true),
    },
    Shown {
        tab: Explanation::Stages,
        name: "stages",
        view: View::Image,
        change: |state| state.model.desk.shown.show_mut().painted = Some(0.4),
    },
    Shown { tab: Explanation::Dialects, name: "dialects", view: View::World, change: |_| () },
    Shown {
        tab: Explanation::Order,
        name: "order",
        view: View::World,
        change: |state| {
            state.model.desk.shown.edit(|figure| {
                figure.scene.preset = Preset::Empty;
                let tower = ObjectSpec::new("box", Shape::Box).at(2.0, 0.0, 0.0).turned(0.0, 50.0, 0.0);
                figure.scene.objects = vec![tower.scaled(0.5, 1.0, 0.5)];
            });
            state.model.tree.select(Some(Selected::Object("box".to_owned())));
        },
    },
    Shown { tab: Explanation::Code, name: "code", view: View::World, change: |_| () },
    Shown {
        tab: Explanation::Notes,
        name: "notes",
        view: View::World,
        change: |state| state.explain.notes.chosen = "5.14",
    },
    Shown { tab: Explanation::Exercises, name: "exercises", view: View::World, change: wrong_view_matrix },
];

/// A view matrix with −C in its last column, judged, and its camera beside the right one.
fn wrong_view_matrix(state: &mut State) {
    let entry = entry("view-matrix").unwrap();
    let exercise = entry.exercise(1, &Free::new());
    let ask = &exercise.asks[0];
    let mut numbers = ask.expected().table().unwrap().entries;
    let camera = exercise.subject.figure.camera;
    for (row, c) in camera.position.to_array().into_iter().enumerate() {
        numbers[4 * row + 3] = -c;
    }
    let fields: Vec<String> = numbers.iter().map(|x| format!("{}", (x * 1000.0).round() / 1000.0)).collect();
    let judged = check(entry, &exercise, ask, &joined(ask, &fields)).unwrap();
    let chosen = Chosen { id: entry.id.clone().into_owned(), seed: 1 };
    state.learn.exercises.work_on(chosen.clone());
    let typed = Typed { answers: [(ask.name.clone(), fields.clone())].into(), ..Typed::default() };
    state.learn.exercises.typed.insert(chosen, typed);
    state.learn.exercises.checked.insert(ask.name.clone(), Checked { fields, judged });
    let matrix = DMat4::from_cols_slice(&numbers).transpose();
    let found = recover(&Reading::of(MatrixKind::View), matrix, &camera).unwrap();
    let described = Box::new(Camera::new(&found.parameters).unwrap());
    state.learn.exercises.described = Some(Described { ask: ask.name.clone(), camera: Ok(described) });
    state.model.desk.shown.edit(|figure| figure.points.clear());
    state.model.desk.replace(exercise.subject.figure.clone()).unwrap();
}

/// A window that shows a tab beside one picture.
fn window(shown: &Shown, lang: Lang, size: [f32; 2], change: impl FnOnce(&mut State)) -> Window {
    let figure = camera_lab_desk::document::fresh();
    let mut state =
        State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None }).unwrap();
    state.file_flow.native = false;
    state.model.desk.shown.edit(|figure| {
        let points = [("A", DVec3::new(0.5, 1.2, 1.5)), ("B", DVec3::new(-1.5, 0.0, -1.0))];
        figure.points = points.map(|(name, position)| NamedPoint { name: name.to_owned(), position }).to_vec();
    });
    state.model.settings.panels.wanted = [false, false, true];
    state.model.explained.show(shown.tab);
    state.model.layout.maximized = Some(shown.view);
    (shown.change)(&mut state);
    change(&mut state);
    Window::with_state(state, size)
}

fn draw(window: &mut Window, path: &PathBuf) {
    window.harness.remove_cursor();
    window.harness.run_steps(6);
    window.app_mut().state.model.coach.take(Duration::from_secs(60));
    window.harness.run_steps(6);
    write(path, &window.harness.render().unwrap());
}

#[test]
#[ignore = "writes pictures of the guides"]
fn of_each_tab() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/images");
    for (lang, code) in [(Lang::En, "en"), (Lang::PtBr, "pt-BR")] {
        for shown in &ALL {
            let mut window = window(shown, lang, [960.0, 640.0], |_| ());
            draw(&mut window, &folder.join(format!("explain-{}.{code}.png", shown.name)));
        }
        let matrices = Shown { tab: Explanation::Matrices, name: "", view: View::World, change: |_| () };
        let mut window = window(&matrices, lang, [1280.0, 720.0], |state| {
            state.model.layout.maximized = None;
            state.model.settings.panels.wanted = [true, false, true];
            state.model.desk.shown.edit(|figure| figure.points.clear());
            state.model.explained.matrices.matrix = Matrix::Projection;
            state.model.explained.matrices.entry = [2, 2];
        });
        draw(&mut window, &folder.join(format!("explain.{code}.png")));
    }
}

#[test]
#[ignore = "writes pictures of the guides"]
fn of_the_whole_window() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let path = folder.join("assets/figures/corridor.toml");
    for (lang, code) in [(Lang::En, "en"), (Lang::PtBr, "pt-BR")] {
        let (figure, file) = camera_lab_files::open_figure(&path).unwrap().at(&path);
        let mut state =
            State::new(Start { figure, file: Some(file), lang, allow_files: false, lesson: None, later: None })
                .unwrap();
        state.file_flow.native = false;
        let mut window = Window::with_state(state, [1280.0, 720.0]);
        draw(&mut window, &folder.join(format!("docs/images/window.{code}.png")));
    }
}
