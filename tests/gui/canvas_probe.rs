//! The three pictures: the pixel and the vertex under the pointer, marked in all three with their numbers.

#![expect(clippy::unwrap_used, clippy::cast_possible_truncation, reason = "tests; places on a small screen")]

use camera_lab::camera::{Parameters, Projection};
use camera_lab::figure::{Observer, ShownProbe};
use camera_lab::lessons::shipped;
use camera_lab::scene::{ObjectSpec, Preset, Shape};
use camera_lab::views::{Probe, View, image_frame, pick};
use eframe::egui::{Id, Key, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use glam::{DVec2, DVec3};

use super::canvas::{IMAGE, Stage, WORLD, free_place, observer, place, stage, world};
use crate::words::en;

#[test]
fn the_pixel_under_the_pointer_is_named_and_its_ray_is_probed() {
    let mut h = stage(|_| ());
    let rect = place(&h, IMAGE);
    let window = h.state().state.model.desk.shown.camera().window();
    let frame = image_frame(world(&h, rect).size, window.aspect());
    let share = DVec2::new(0.03, 0.96);
    let inside = DVec2::new(f64::from(frame.width), f64::from(frame.height)) * share;
    let at = rect.min + vec2((f64::from(frame.x) + inside.x) as f32, (f64::from(frame.y) + inside.y) as f32);
    h.hover_at(at);
    h.run();
    let pixel = (DVec2::new(1024.0, 768.0) * share).floor();
    let near = |text: &str| {
        let numbers: Vec<f64> = text.split(|c: char| !c.is_ascii_digit()).filter_map(|n| n.parse().ok()).collect();
        (numbers[0] - pixel.x).abs() <= 3.0 && (numbers[1] - pixel.y).abs() <= 3.0 && numbers[2..4] == [1024.0, 768.0]
    };
    let text = h.get_by_label_contains("/ 1024 × 768").accesskit_node().value().unwrap();
    assert!(near(&text), "{text} is not near {pixel}");
    let Some(Probe::Window(point)) = h.state().state.model.frame.probe else {
        panic!("{:?}", h.state().state.model.frame.probe)
    };
    assert!((point.x - (window.left + share.x * window.width())).abs() < 0.01 * window.width());
    assert!((point.y - (window.top - share.y * window.height())).abs() < 0.01 * window.height());

    h.remove_cursor();
    h.run();
    assert_eq!(h.state().state.model.frame.probe, None);
    h.hover_at(at);
    h.run();
    h.drag_at(at);
    h.drop_at(at);
    h.run();
    h.remove_cursor();
    h.run();
    assert_eq!(h.state().state.model.frame.probe, Some(Probe::Window(point)), "a click pins it");
    h.key_press(Key::Escape);
    h.run();
    assert_eq!(h.state().state.model.frame.probe, None, "Esc releases it");
}

#[test]
fn a_vertex_is_marked_in_all_three_pictures_with_its_coordinates() {
    let observer = Observer { azimuth: 40.0, distance: 12.0, ..observer() };
    let mut h = stage(|state| state.model.desk.shown.observers_mut().world = Some(observer));
    let [_, _, back] = observer.axes();
    let eye = observer.target + back * observer.distance;
    let scene = h.state().state.model.scene_cache.scene().clone();
    let object = &scene.objects[0];
    let corners = object.mesh.positions.iter().map(|&p| object.world_from_object.transform_point3(p));
    let corner = corners.min_by(|a, b| a.distance(eye).total_cmp(&b.distance(eye))).unwrap();

    let rect = place(&h, WORLD);
    let camera = observer.camera(None, f64::from(rect.width() / rect.height())).unwrap();
    let clip = camera.clip_point(corner);
    let at = rect.center()
        + vec2((clip.x / clip.w) as f32 * rect.width() / 2.0, -(clip.y / clip.w) as f32 * rect.height() / 2.0);
    h.hover_at(free_place(&h));
    h.run();
    let drawn = h.state().canvas.drawn();
    h.hover_at(at + vec2(2.0, -1.0));
    h.run();
    assert_eq!(h.state().state.model.frame.probe, Some(Probe::Point(corner)));
    for (after, before) in h.state().canvas.drawn().iter().zip(drawn) {
        assert_eq!(*after, before + 1);
    }
    let text = h.get_by_label_contains("NDC").accesskit_node().value().unwrap();
    let ndc = h.state().state.model.desk.shown.camera().clip_point(corner);
    let x = format!("{:.4}", ndc.x / ndc.w);
    assert!(text.contains(&x), "{text} has no {x}");
}

/// A window of 3 × 4 over 1024 × 768 pixels, as in exercise 5.2: the pointer, the probe and the cross of lines name the
/// pixels of the m × n image, which are those of `inspect` and of the PNG (`tests/it/image_pixels.rs`).
#[test]
fn pixels_that_are_not_square_are_those_of_the_image_that_is_shown() {
    let mut h = stage(|state| {
        state.model.desk.shown.edit(|figure| {
            figure.scene.preset = Preset::Empty;
            figure.scene.objects = vec![ObjectSpec::new("P", Shape::Points(vec![DVec3::new(1.0, 1.0, 0.0)]))];
        });
        state.model.desk.shown.set_parameters(Parameters {
            position: DVec3::new(0.0, 0.0, 5.0),
            projection: Projection::Parallel,
            height: 4.0,
            aspect: 0.75,
            near: 1.0,
            far: 20.0,
            ..Parameters::default()
        });
        state.model.layout.maximized = Some(View::Image);
    });
    let rect = place(&h, IMAGE);
    // The largest rectangle of 4 : 3, in the middle.
    let height = rect.height().min(rect.width() * 0.75).round();
    let frame = Rect::from_center_size(rect.center(), vec2((height / 0.75).round(), height));
    let at = |[i, j]: [f32; 2]| frame.min + frame.size() * vec2(i / 1024.0, j / 768.0);
    h.hover_at(at([853.33, 192.0]));
    h.run();
    assert_eq!(
        h.state().state.model.frame.probe,
        Some(Probe::Point(DVec3::new(1.0, 1.0, 0.0))),
        "its mark stands there"
    );
    assert!(
        h.get_all_by_label_contains(en::CANVAS.space_pixel)
            .any(|node| { node.accesskit_node().value().is_some_and(|text| text.contains("(853, 192)")) })
    );
    h.hover_at(at([100.5, 700.5]));
    h.run();
    let status = h.get_by_label_contains("/ 1024 × 768").accesskit_node().value().unwrap();
    let numbers: Vec<f64> = status.split(|c: char| !c.is_ascii_digit()).filter_map(|n| n.parse().ok()).collect();
    assert!((numbers[0] - 100.0).abs() <= 3.0 && (numbers[1] - 700.0).abs() <= 3.0, "{status}");
    // As the eye would see it: narrower, in the middle, and the switch goes back.
    h.get_by_label(en::CANVAS.undistorted).click();
    h.run();
    assert!(h.state().state.model.desk.shown.figure().undistorted);
    let narrow = Rect::from_center_size(rect.center(), vec2((height * 0.75).round(), height));
    h.hover_at(narrow.min + narrow.size() * vec2(2.5 / 3.0, 0.25));
    h.run();
    assert_eq!(h.state().state.model.frame.probe, Some(Probe::Point(DVec3::new(1.0, 1.0, 0.0))));
    h.get_by_label(en::CANVAS.undistorted).click();
    h.run();
    assert!(!h.state().state.model.desk.shown.figure().undistorted);
    // With square pixels there is nothing to switch.
    h.state_mut().state.model.desk.shown.set_parameters(Parameters::default());
    h.run();
    assert!(h.query_by_label(en::CANVAS.undistorted).is_none());
}

#[test]
fn pointer_and_vertex_differ_and_a_card_keeps_its_pinned_point() {
    let mut h = stage(|state| {
        state.model.desk.shown.edit(|figure| {
            figure.scene.preset = Preset::Empty;
            let ends = [[DVec3::ZERO, DVec3::new(0.0, 0.0, 1.0)], [DVec3::new(1.0, 0.5, 0.0), DVec3::X]];
            figure.scene.objects = vec![
                ObjectSpec::new("box", Shape::Box),
                ObjectSpec::new("edges", Shape::Segments(ends.to_vec())).at(0.0, 2.0, 0.0),
            ];
        });
        state.model.layout.maximized = Some(View::Image);
    });
    let rect = place(&h, IMAGE);
    let at = |h: &Harness<Stage>, p: DVec3| {
        let camera = h.state().state.model.desk.shown.camera();
        let clip = camera.clip_from_world() * p.extend(1.0);
        let ndc = clip.truncate() / clip.w;
        let height = rect.height().min(rect.width() * 0.75).round();
        let frame = Rect::from_center_size(rect.center(), vec2((height / 0.75).round(), height));
        frame.center() + frame.size() * 0.5 * vec2(ndc.x as f32, -ndc.y as f32)
    };
    let says = |h: &Harness<Stage>, text: &str| h.query_all_by_label_contains(text).next().is_some();
    let place = at(&h, DVec3::new(1.0, 2.5, 0.0));
    h.hover_at(place + vec2(2.0, 1.0));
    h.run();
    assert!(says(&h, "Vertex 3 – edges") && says(&h, "Pointer: Pixel ("));
    let corner = at(&h, DVec3::ONE);
    h.hover_at(corner);
    h.run();
    let status = h.get_by_label_contains("– box").accesskit_node().value().unwrap();
    let number: usize = status.split_whitespace().nth(1).unwrap().parse().unwrap();
    let mesh = &h.state().state.model.scene_cache.scene().objects[0].mesh;
    assert_eq!(mesh.positions[number - 1], DVec3::ONE, "{status}");
    // A click pins it: the card stays when the pointer has gone, until it is released.
    h.drag_at(corner);
    h.drop_at(corner);
    h.run();
    h.remove_cursor();
    h.run();
    assert!(says(&h, "Release (Esc)") && says(&h, "(1, 1, 1)"));
    h.get_by_label("Copy").click();
    h.step();
    let commands = &h.output().platform_output.commands;
    let copied = commands.iter().find_map(|command| match command {
        eframe::egui::OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    assert!(copied.is_some_and(|text| text.contains("World\t(1, 1, 1)\n") && text.contains("\nPixel\t(")));
    h.get_by_label(en::CANVAS.release).click();
    h.run();
    assert!(!says(&h, "Release (Esc)"));
}

/// A card that was never moved is in the same place as in a window that has always been as large.
#[test]
fn a_card_goes_with_the_window_until_it_is_moved() {
    let open = |size: [f32; 2]| {
        let mut h = stage(|state| state.model.desk.shown.show_mut().probe = Some(ShownProbe::World(DVec3::ONE)));
        h.set_size(size.into());
        h.run();
        h
    };
    let card = |h: &Harness<Stage>| h.get_by_label(en::CANVAS.release).rect().center();
    let [small, large] = [[700.0, 300.0], [1400.0, 900.0]];
    let expected = [small, large].map(|size| card(&open(size)));
    assert_ne!(expected[0], expected[1]);
    let mut h = open(small);
    assert_eq!(card(&h), expected[0]);
    h.set_size(large.into());
    h.run();
    assert_eq!(card(&h), expected[1]);
    // By hand.
    let from = card(&h) + vec2(30.0, -40.0);
    h.hover_at(from);
    h.run();
    h.drag_at(from);
    h.run_steps(2);
    h.hover_at(from + vec2(-90.0, -120.0));
    h.run_steps(2);
    h.drop_at(from + vec2(-90.0, -120.0));
    h.run();
    let moved = card(&h);
    assert_ne!(moved, expected[1]);
    h.set_size([1390.0, 890.0].into());
    h.run();
    assert_eq!(card(&h), moved);
}

/// In a lesson the rays and triangles of its probe meet in C.
#[test]
fn the_card_of_a_lesson_covers_neither_its_point_nor_the_camera() {
    let mut shown = 0;
    for step in shipped().iter().flat_map(|shipped| &shipped.lesson.steps) {
        let Some(ShownProbe::World(point)) = step.figure.show.probe else { continue };
        let mut h = stage(|state| {
            state.model.desk.shown.edit(|figure| {
                figure.clone_from(&step.figure);
                figure.style.antialias = camera_lab::appearance::Samples::One;
            });
            state.model.desk.shown.set_parameters(step.figure.camera);
        });
        h.set_size([900.0, 560.0].into());
        h.run();
        let card = h.ctx.memory(|memory| memory.area_rect(Id::unique("card of the probe"))).unwrap();
        let rect = place(&h, WORLD);
        let request = world(&h, rect);
        let Some(places) = pick::places(&request) else { continue };
        for p in [point, step.figure.camera.position] {
            let at = places(p).unwrap();
            let at = rect.min + vec2(at.x as f32, at.y as f32);
            assert!(!card.contains(at), "{:?}: {p} at {at} under {card}", step.title.en);
        }
        shown += 1;
    }
    assert!(shown >= 3, "{shown}");
}
