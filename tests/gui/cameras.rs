//! The list of cameras: kept, looked through, renamed, shown beside, made a stereo pair.

use camera_lab::camera::Camera;
use camera_lab::figure::Figure;
use camera_lab::gui::{Start, State};
use camera_lab::views::pick;
use camera_lab_words::Lang;
use camera_lab_words::window::cameras;
use eframe::egui::{Key, vec2};

use super::canvas::{WORLD, parameters, place, stage, world};
use super::window::Window;

const PAIR: &str = "[camera]\nname = \"left\"\nposition = [2, 2, 6]\n[[cameras]]\nname = \"right\"\n\
                    position = [5, 2, 4]\n[scene]\npreset = \"house\"\n[style]\nantialias = 1\n";

fn window(lang: Lang, text: &str) -> Window {
    let figure = camera_lab::figure::read::parse(text).expect("a figure");
    let state = State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None })
        .expect("a possible camera");
    Window::with_state(state, [1280.0, 1000.0])
}

impl Window {
    fn figure(&self) -> &Figure {
        self.state().model.desk.shown.figure()
    }
}

#[test]
fn a_camera_is_looked_through_and_back_by_the_list_and_undone() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = cameras::texts(lang);
        let mut window = window(lang, PAIR);
        let before = window.figure().clone();
        window.click(&format!("{}: right", t.look));
        assert_eq!(window.figure().camera, before.cameras[0].parameters);
        assert_eq!(window.figure().cameras[0].name, "left");
        window.command_key(Key::Z);
        assert_eq!(window.figure(), &before);
        window.click(&format!("{}: right", t.remove));
        assert!(window.figure().cameras.is_empty());
    }
}

#[test]
fn the_image_of_a_camera_stands_beside_until_the_camera_is_removed() {
    let t = cameras::texts(Lang::En);
    let mut window = window(Lang::En, PAIR);
    window.click(&format!("{}: right", t.beside));
    let compared = |window: &Window| window.figure().compare.as_ref().and_then(|compare| compare.camera.clone());
    assert_eq!(compared(&window).as_deref(), Some("right"));
    window.click(&format!("{}: right", t.look));
    assert_eq!(compared(&window).as_deref(), Some("left"));
    window.click(&format!("{}: left", t.remove));
    assert_eq!(window.figure().compare, None);
}

#[test]
fn a_stereo_pair_is_half_a_baseline_to_each_side() {
    let t = cameras::texts(Lang::En);
    let mut window = window(Lang::En, PAIR);
    let middle = window.state().model.desk.shown.camera().clone();
    window.app_mut().state.model.cameras.baseline = Some(0.5);
    window.click(t.pair);
    window.click(t.shifted);
    let figure = window.figure();
    let [left, right] = [&figure.camera, &figure.cameras[1].parameters].map(|p| Camera::new(p).expect("a camera"));
    assert!((left.position().midpoint(right.position()) - middle.position()).length() < 1e-12);
    let apart = (right.position() - left.position()).dot(middle.basis().u);
    assert!((apart - 0.5).abs() < 1e-12, "{apart}");
    assert_eq!((figure.tag.name.as_deref(), figure.cameras[1].name.as_str()), (Some("left"), "right 2"));
}

#[test]
fn a_click_on_a_camera_in_the_world_looks_through_it() {
    let mut h = stage(|state| {
        let pair = camera_lab::figure::read::parse(PAIR).expect("a figure");
        state.model.desk.shown.edit_cameras(|figure| figure.cameras = pair.cameras);
    });
    let wanted = h.state().state.model.desk.shown.figure().cameras[0].parameters;
    let rect = place(&h, WORLD);
    let at = pick::places(&world(&h, rect)).expect("an observer")(wanted.position).expect("in the picture");
    let at = rect.min + vec2(at.x as f32, at.y as f32);
    h.hover_at(at);
    h.run();
    h.drag_at(at);
    h.run();
    h.drop_at(at);
    h.run();
    assert_eq!(parameters(&h), wanted);
}
