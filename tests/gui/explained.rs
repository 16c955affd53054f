//! The explanation of a figure file in the window: it is taken up, followed, let go of and brought back.

use std::fs;

use camera_lab::camera::Decomposition;
use camera_lab::figure::Explanation;
use camera_lab::figure::{Measure, Measured, ShownTriangle, TriangleStep};
use camera_lab::views::{Size, image_frame};
use camera_lab_desk::layout::{Side, Tab};
use camera_lab_desk::scene_tree::Selected;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, vec2};
use egui_kittest::kittest::Queryable as _;
use glam::DVec3;

use super::files::Folder;
use super::window::Window;

/// A figure with a box of its own and its explanation.
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
    let triangle = |window: &Window| window.state().model.shown().triangle.clone();
    let own = ShownTriangle { object: "crate".to_owned(), index: 3, step: TriangleStep::Cuts, pixel: None };
    assert_eq!(triangle(&window), Some(own.clone()));
    window.app_mut().state.model.desk.shown.edit(|figure| figure.scene.objects.clear());
    window.run();
    assert_eq!(triangle(&window), None, "a file that is saved now can be read");
    window.command_key(Key::Z);
    assert_eq!(triangle(&window), Some(own.clone()));
    window.app_mut().state.model.desk.shown.show_mut().rename_object("crate", "chest");
    assert_eq!(triangle(&window), Some(ShownTriangle { object: "chest".to_owned(), ..own }));
}

#[test]
fn undo_of_the_camera_leaves_the_step_of_the_triangle_where_it_is() {
    let mut window = window("explained-step", "triangle = { object = \"crate\", index = 3, step = \"view\" }");
    let go_on = |window: &mut Window| {
        let show = window.app_mut().state.model.desk.shown.show_mut();
        let triangle = show.triangle.as_mut().expect("a triangle");
        (triangle.step, triangle.pixel) = (TriangleStep::Depth, Some([5, 4]));
        window.run();
    };
    go_on(&mut window);
    window.enter("F", "0.25");
    window.command_key(Key::Z);
    let triangle = window.state().model.shown().triangle.clone().expect("still followed");
    assert_eq!((triangle.step, triangle.pixel), (TriangleStep::Depth, Some([5, 4])));
}

#[test]
fn esc_leaves_a_presentation_before_it_clears_the_marks_of_a_file() {
    let mut window = window("explained-esc", "measure = [\"F\"]\npainted = 0.5");
    let near = vec![Measured::Dimension(Measure::Near)];
    window.app_mut().state.model.settings.presentation = true;
    window.run();
    window.key(Key::Escape);
    assert_eq!((window.state().model.settings.presentation, &window.state().model.shown().measure), (false, &near));
    window.key(Key::Escape);
    assert!(window.state().model.shown().measure.is_empty() && window.state().model.shown().painted.is_none());
}

#[test]
fn an_open_tab_of_steps_takes_up_the_way_of_a_file() {
    let mut window = window("explained-way", "step = { way = \"box\", at = 1.0 }");
    window.app_mut().state.model.settings.panels.wanted[2] = true;
    window.app_mut().state.model.explained.show(Explanation::Steps);
    window.run();
    let step = window.state().model.shown().step.expect("a step");
    assert_eq!((step.way, step.at), (Decomposition::Box, Some(1.0)));
}

#[test]
fn the_convention_of_a_file_is_that_of_the_window_and_is_saved_again() {
    let window = window("explained-ndc", "ndc = \"direct3d\"");
    assert_eq!(window.state().model.settings.conventions.ndc.name(), "direct3d");
    assert_eq!(window.state().model.figure_to_save().show.ndc.map(|ndc| ndc.name()), Some("direct3d"));
}

/// An object may be called as the part of another one is: a click knows them apart, and chooses no triangle that its
/// name cannot tell from another.
#[test]
fn an_object_and_a_part_of_another_with_the_same_name_differ() {
    let folder = Folder::new("explained-names");
    let corner = |x: f64, y: f64| format!("v {} {y} 0\nv {x} {} 0\nv {x} {y} 1\n", x + 1.0, y + 1.0);
    let mesh = format!("o block\n{}f 1 2 3\no lid\n{}f 4 5 6\n", corner(-1.5, 0.0), corner(-1.5, 1.2));
    fs::write(folder.file("engine.obj"), mesh).expect("written");
    let engine = "[[scene.objects]]\nname = \"engine\"\nshape = \"mesh\"\npath = \"engine.obj\"\n";
    let block = "[[scene.objects]]\nname = \"engine/block\"\nshape = \"box\"\ntranslate = [1.2, 0, 0]\n";
    let path = folder.file("figure.toml");
    let figure = format!("[scene]\npreset = \"empty\"\n{engine}{block}[style]\nantialias = 1\n");
    fs::write(&path, figure).expect("written");
    let mut window = Window::opened(&path);
    window.wait(|window| window.state().model.scene_cache.scene().objects.len() == 3);
    let named = |name: &str| window.state().model.scene_cache.scene().objects.iter().filter(|o| o.name == name).count();
    assert_eq!((named("engine/block"), named("engine/lid")), (2, 1));
    let [part, lid, own] = [[-1.5, 0.0], [-1.5, 1.2], [1.2, 0.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let third = DVec3::splat(1.0 / 3.0);
    let click = |window: &mut Window, p: DVec3| {
        let camera = window.state().model.desk.shown.camera().clone();
        let clip = camera.clip_point(p);
        let place = window.harness.get_by_role(Role::Image).rect();
        let size = Size { width: place.width() as u32, height: place.height() as u32, scale: 1.0 };
        let frame = image_frame(size, 4.0 / 3.0);
        let [x, y] = [
            f64::from(frame.x) + f64::from(frame.width) * (0.5 + 0.5 * clip.x / clip.w),
            f64::from(frame.y) + f64::from(frame.height) * (0.5 - 0.5 * clip.y / clip.w),
        ];
        let at = place.min + vec2(x as f32, y as f32);
        window.harness.hover_at(at);
        window.run();
        window.harness.drag_at(at);
        window.harness.drop_at(at);
        window.run();
    };
    window.app_mut().state.model.settings.tab = Tab::Scene;
    window.run();
    for (place, name) in [(part + third, "engine"), (own, "engine/block"), (lid + third, "engine")] {
        click(&mut window, place);
        let state = window.state();
        let selected = state.model.tree.selected(&state.model.desk.shown.figure().scene);
        assert_eq!(selected, Some(&Selected::Object(name.to_owned())), "{place}");
    }
    window.app_mut().state.model.settings.panels.show(Side::Explain);
    window.app_mut().state.model.explained.show(Explanation::Triangle);
    window.run();
    for (place, name) in [(part + third, None), (own, Some("engine/block")), (lid + third, Some("engine/lid"))] {
        click(&mut window, place);
        assert_eq!(window.state().model.shown().triangle.as_ref().map(|shown| shown.object.as_str()), name, "{place}");
    }
}
