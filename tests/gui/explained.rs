//! What a figure file explains, in the window: it is taken up, followed, let go of and brought back.

use std::fs;

use camera_lab::camera::Decomposition;
use camera_lab::figure::Explanation;
use camera_lab::figure::{Measure, Measured, ShownTriangle, TriangleStep};
use eframe::egui::Key;

use super::files::Folder;
use super::window::Window;

/// A figure with a box of its own, and what it explains.
fn window(name: &str, show: &str) -> Window {
    let folder = Folder::new(name);
    let path = folder.file("figure.toml");
    let objects = "[scene]\npreset = \"empty\"\n[[scene.objects]]\nname = \"crate\"\nshape = \"box\"\n";
    fs::write(&path, format!("{objects}[style]\nantialias = 1\n[show]\n{show}\n")).expect("written");
    Window::opened(&path)
}

#[test]
fn the_triangle_of_an_object_goes_with_it_comes_back_with_it_and_follows_its_name() {
    let mut window = window("explained-triangle", "triangle = { object = \"crate\", index = 3, step = \"cuts\" }");
    let triangle = |window: &Window| window.state().shown().triangle.clone();
    let own = ShownTriangle { object: "crate".to_owned(), index: 3, step: TriangleStep::Cuts, pixel: None };
    assert_eq!(triangle(&window), Some(own.clone()));
    window.app_mut().state.document.edit(|figure| figure.scene.objects.clear());
    window.run();
    assert_eq!(triangle(&window), None, "a file that is saved now can be read");
    window.command_key(Key::Z);
    assert_eq!(triangle(&window), Some(own.clone()));
    window.app_mut().state.document.show_mut().rename_object("crate", "chest");
    assert_eq!(triangle(&window), Some(ShownTriangle { object: "chest".to_owned(), ..own }));
}

#[test]
fn undo_of_the_camera_leaves_the_step_of_the_triangle_where_it_is() {
    let mut window = window("explained-step", "triangle = { object = \"crate\", index = 3, step = \"view\" }");
    let go_on = |window: &mut Window| {
        let show = window.app_mut().state.document.show_mut();
        let triangle = show.triangle.as_mut().expect("a triangle");
        (triangle.step, triangle.pixel) = (TriangleStep::Depth, Some([5, 4]));
        window.run();
    };
    go_on(&mut window);
    window.enter("F", "0.25");
    window.command_key(Key::Z);
    let triangle = window.state().shown().triangle.clone().expect("still followed");
    assert_eq!((triangle.step, triangle.pixel), (TriangleStep::Depth, Some([5, 4])));
}

#[test]
fn esc_lets_go_of_what_a_file_brought_and_a_presentation_keeps_it() {
    let mut window = window("explained-esc", "measure = [\"F\"]\npainted = 0.5");
    let near = vec![Measured::Dimension(Measure::Near)];
    window.app_mut().state.settings.presentation = true;
    window.run();
    window.key(Key::Escape);
    assert_eq!((window.state().settings.presentation, &window.state().shown().measure), (false, &near));
    window.key(Key::Escape);
    assert!(window.state().shown().measure.is_empty() && window.state().shown().painted.is_none());
}

#[test]
fn an_open_tab_of_steps_takes_up_the_way_of_a_file() {
    let mut window = window("explained-way", "step = { way = \"box\", at = 1.0 }");
    window.app_mut().state.settings.panels.wanted[2] = true;
    window.app_mut().state.explain.show(Explanation::Steps);
    window.run();
    let step = window.state().shown().step.expect("a step");
    assert_eq!((step.way, step.at), (Decomposition::Box, Some(1.0)));
}

#[test]
fn the_convention_of_a_file_is_that_of_the_window_and_is_saved_again() {
    let window = window("explained-ndc", "ndc = \"direct3d\"");
    assert_eq!(window.state().settings.conventions.ndc.name(), "direct3d");
    assert_eq!(window.state().figure_to_save().show.ndc.map(|ndc| ndc.name()), Some("direct3d"));
}
