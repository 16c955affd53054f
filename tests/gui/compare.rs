//! The figure in two ways: the dialog, the wiper, undo.

use camera_lab::appearance::{DepthFormat, Shading, Visibility};
use camera_lab::camera::Projection;
use camera_lab::figure::Comparison;
use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab::gui::{Start, State};
use camera_lab::views::View;
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Rect, vec2};
use egui_kittest::kittest::Queryable;

use super::files::Folder;
use super::window::Window;
use crate::words::{en, pt};

/// The house, its image alone.
fn house(lang: Lang) -> Window {
    let text = "[camera]\nposition = [2.5, 3, 5]\n[scene]\npreset = \"house\"\n[style]\nantialias = 1\n";
    let figure = camera_lab::figure::read::parse(text).expect("a figure");
    let mut state = State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None })
        .expect("a possible camera");
    state.file_flow.native = false;
    state.model.layout.maximized = Some(View::Image);
    Window::with_state(state, [1280.0, 800.0])
}

impl Window {
    fn compared(&self) -> Option<&Comparison> {
        self.state().model.desk.shown.figure().compare.as_ref()
    }

    fn compare(&mut self) {
        self.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::D);
        self.run();
        assert!(matches!(self.state().file_flow.dialog, Some(Dialog::Compare(_))));
    }

    fn wiper(&self) -> Rect {
        self.harness.get_by_role_and_label(Role::Slider, en::COMPARE.wiper).rect()
    }
}

#[test]
fn a_pair_is_chosen_the_wiper_is_dragged_and_both_are_undone() {
    let mut window = house(Lang::En);
    window.compare();
    window.click(en::COMPARE.shading);
    assert_eq!(window.compared().expect("a comparison").with, [("style.shading".to_owned(), "\"phong\"".to_owned())]);
    window.click(en::COMPARE.differences);
    assert!(window.compared().expect("a comparison").differences);
    // Without the card, which would end the comparison if it were closed.
    window.app_mut().state.file_flow.dialog = None;
    window.run();
    let (place, from) = (window.state().model.frame.picture_sizes[View::Image.index()], window.wiper().center());
    window.drag(from, vec2(-100.0, 0.0), |_| {});
    let wiper = window.compared().expect("a comparison").wiper;
    assert!((wiper - (0.5 - 100.0 / f64::from(place[0]))).abs() < 0.01, "{wiper}");
    assert!((window.wiper().center().x - (from.x - 100.0)).abs() < 2.0);
    // The keys move it on, and Home takes it to the border.
    window.key(Key::ArrowRight);
    let moved = window.compared().expect("a comparison").wiper;
    assert!((moved - wiper - 0.02).abs() < 1e-9, "{moved}");
    window.key(Key::Home);
    assert_eq!(window.compared().expect("a comparison").wiper, 0.0);
    for expected in [Some(moved), Some(wiper), Some(0.5)] {
        window.command_key(Key::Z);
        assert_eq!(window.compared().map(|comparison| comparison.wiper), expected);
    }
    while window.state().model.desk.can_undo(true) {
        window.command_key(Key::Z);
    }
    assert_eq!(window.compared(), None);
    assert!(window.harness.query_by_label(en::COMPARE.wiper).is_none());
}

#[test]
fn each_ready_pair_compares_and_is_swapped() {
    let mut window = house(Lang::En);
    window.compare();
    // The name of the side that the figure is stands at the left, like its side.
    for (pair, key) in [
        ("depth buffer | painter", "style.visibility"),
        ("depth buffer | BSP", "style.visibility"),
        ("perspective | parallel", "camera.projection"),
        ("OpenGL | Direct3D", "show.ndc"),
        ("f32 reversed | depth of 16 bits", "style.depth_format"),
    ] {
        window.click(pair);
        assert_eq!(window.compared().expect("a comparison").with[0].0, key, "{pair}");
        assert!(window.state().model.compared().is_some(), "{pair}");
    }
    window.click(en::COMPARE.swap);
    assert_eq!(window.state().model.desk.shown.figure().style.depth_format, DepthFormat::Fixed16);
    assert_eq!(window.compared().expect("a comparison").with[0].1, "\"f32-reversed\"");
    window.click(en::COMPARE.swap);
    window.click("perspective | parallel");
    window.click(en::COMPARE.swap);
    assert!(window.says(en::COMPARE.projection), "its sides are exchanged");
    assert_eq!(window.state().model.desk.shown.figure().camera.projection, Projection::Parallel);
    window.click(en::COMPARE.operation);
    assert_eq!(window.compared().expect("a comparison").ops.len(), 1);
    window.click(en::COMPARE.beside);
    assert!(window.compared().expect("a comparison").beside);
    window.click(en::COMPARE.nothing);
    assert_eq!(window.compared(), None);
    let style = window.state().model.desk.shown.figure().style;
    assert_eq!((style.shading, style.visibility), (Shading::Flat, Visibility::DepthBuffer));
}

#[test]
fn any_key_is_compared_and_a_wrong_one_is_explained() {
    let mut window = house(Lang::PtBr);
    window.compare();
    let hint = "Uma chave dos arquivos de figura";
    let type_key = |window: &mut Window, text: &str| {
        let is_field = |node: &egui_kittest::kittest::AccessKitNode<'_>| {
            node.role() == Role::TextInput && node.label().is_some_and(|label| label.starts_with(hint))
        };
        window.harness.get_by(is_field).focus();
        window.run();
        window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        window.harness.event(eframe::egui::Event::Text(text.to_owned()));
        window.run();
        window.key(Key::Enter);
    };
    type_key(&mut window, "image.width = 512");
    assert_eq!(window.compared().expect("a comparison").with, [("image.width".to_owned(), "512".to_owned())]);
    window.click(pt::COMPARE.swap);
    assert_eq!(window.compared().expect("a comparison").with, [("image.width".to_owned(), "1024".to_owned())]);
    assert_eq!(window.state().model.desk.shown.figure().image.width, 512);
    type_key(&mut window, "camera.near = 0");
    assert!(window.says("near é 0"));
    assert_eq!(window.compared().expect("the comparison before").with[0].0, "image.width");
    // This is possible for some figures and not for this one.
    type_key(&mut window, "camera.near = 1000");
    assert!(window.says(pt::COMPARE.impossible));
    window.app_mut().state.file_flow.dialog = None;
    window.run();
    assert!(window.says(pt::COMPARE.impossible), "under the views too");
}

#[test]
fn the_numbers_at_the_pointer_are_those_of_its_side() {
    let text = "[camera]\nposition = [2.5, 3, 5]\n[image]\nwidth = 800\nheight = 600\n[scene]\npreset = \"empty\"\n\
                [compare]\nwith = { \"image.width\" = 80, \"image.height\" = 60 }\n";
    let figure = camera_lab::figure::read::parse(text).expect("a figure");
    let mut state =
        State::new(Start { figure, file: None, lang: Lang::En, allow_files: false, lesson: None, later: None })
            .expect("a possible camera");
    state.model.layout.maximized = Some(View::Image);
    let mut window = Window::with_state(state, [1280.0, 800.0]);
    let wiper = window.wiper().center();
    for (offset, pixel) in [(-60.0, "Pixel (3"), (60.0, "Pixel (4")] {
        window.harness.hover_at(wiper + vec2(offset, 0.0));
        window.run();
        let said = window.state().model.frame.probe;
        assert!(window.says(pixel), "{offset}: {said:?}");
    }
    window.harness.hover_at(wiper + vec2(60.0, 0.0));
    window.run();
    assert!(window.says("/ 80 × 60"));
    // The numbers of a pinned place follow the figure.
    window.click_at(wiper + vec2(-60.0, 0.0));
    window.harness.hover_at(eframe::egui::pos2(640.0, 795.0));
    window.run();
    assert!(window.says("Pixel (3"));
    window.app_mut().state.model.desk.shown.edit(|figure| (figure.image.width, figure.image.height) = (400, 300));
    window.run();
    assert!(window.says("Pixel (1") && !window.says("Pixel (3"));
}

#[test]
fn the_convention_of_the_window_is_the_side_that_is_swapped() {
    let mut window = house(Lang::En);
    window.compare();
    window.click(en::COMPARE.convention);
    window.click(en::COMPARE.swap);
    assert_eq!(window.state().model.settings.conventions.ndc.name(), "direct3d");
    assert_eq!(window.compared().expect("a comparison").with[0].1, "\"opengl\"");
}

#[test]
fn a_camera_is_kept_in_the_list_compared_and_swapped_and_closing_ends_it() {
    let folder = Folder::new("compare");
    let mut window = house(Lang::En);
    let first = window.state().model.desk.shown.figure().camera;
    let framed = window.state().model.desk.shown.figure().observers;
    window.key(Key::F4);
    assert!(window.says(en::COMPARE.no_sides) && window.compared().is_none());
    window.harness.key_press_modifiers(Modifiers::SHIFT, Key::F4);
    window.run();
    window.enter("C x", "-3");
    let second = window.state().model.desk.shown.figure().camera;
    // Its image stands beside: swapped, and back.
    window.key(Key::F4);
    assert_eq!(window.state().model.compared().expect("a side").camera.expect("another camera").parameters(), &first);
    assert_eq!(window.state().model.camera_beside(), Some(0));
    window.key(Key::F4);
    let figure = window.state().model.desk.shown.figure();
    assert_eq!((figure.camera, figure.cameras[0].parameters), (first, second));
    window.key(Key::F4);
    assert_eq!(window.state().model.desk.shown.figure().camera, second);
    // The kept one stays as it was while the camera continues.
    window.enter("C y", "1.5");
    assert_eq!(window.state().model.compared().expect("a side").camera.expect("another camera").parameters(), &first);
    // Another comparison takes its place.
    window.compare();
    window.click(en::COMPARE.shading);
    assert_eq!(window.compared().expect("a comparison").camera, None);
    window.click(en::WINDOW.close);
    assert_eq!(window.compared(), None);
    assert_eq!(window.state().model.desk.shown.figure().observers, framed);
    // As it was opened, and another file.
    window.compare();
    window.click(en::COMPARE.with_saved);
    assert_eq!(window.state().model.compared().expect("a side").camera.expect("another camera").parameters(), &first);
    let path = folder.file("other.toml");
    let other =
        "[camera]\nprojection = \"parallel\"\nheight = 7\n[scene]\npreset = \"house\"\n[style]\nshading = \"flat\"\n";
    std::fs::write(&path, other).expect("written");
    window.click(en::COMPARE.with_file);
    window.choose(&path);
    window.run();
    let side = window.state().model.compared().expect("a side").camera.clone().expect("another camera");
    assert_eq!((side.parameters().projection, side.parameters().height), (Projection::Parallel, 7.0));
}
