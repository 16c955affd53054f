//! What a lecturer meets while preparing and giving a class.

use camera_lab::camera::ParameterKey;
use camera_lab::export::format::PictureFormat;
use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab::lessons::shipped;
use camera_lab::views::View;
use camera_lab_desk::Message;
use camera_lab_desk::layout::Side;
use camera_lab_files::read_lesson;
use camera_lab_words::Lang;
use camera_lab_words::learn::{lesson_tasks, lessons};
use camera_lab_words::window::parameter;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Rect};
use egui_kittest::kittest::Queryable as _;

use super::files::Folder;
use super::lesson_writing::{pause, playing as writing_in, type_into, write};
use super::lessons::playing;
use super::window::Window;
use crate::words::en;

fn press(window: &mut Window, modifiers: Modifiers, key: Key) {
    window.harness.key_press_modifiers(modifiers, key);
    window.run();
}

fn button(window: &Window, label: &str) -> Rect {
    window.harness.query_all_by_role_and_label(Role::Button, label).last().expect("the button").rect()
}

#[test]
fn the_export_dialog_keeps_its_place_while_its_contents_change() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::E);
    window.run();
    let places = |window: &Window| {
        let list = |name: &str| window.harness.get_by_role_and_label(Role::ComboBox, name).rect();
        let export = button(window, en::WINDOW.export_action);
        [list(en::WINDOW.export_what), list(en::WINDOW.theme_name), list("size"), export]
    };
    let before = places(&window);
    for format in [PictureFormat::Pdf, PictureFormat::Svg, PictureFormat::Png] {
        window.click(format.name());
        window.run();
        assert_eq!(places(&window), before, "{format:?}");
    }
    press(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::E);
    window.key(Key::Escape);
    press(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::E);
    window.run();
    assert_eq!(places(&window)[3], before[3], "with a family");
}

#[test]
fn the_image_is_offered_with_its_own_pixels() {
    let mut window = Window::new(Lang::En);
    let image = window.state().model.desk.shown.figure().image;
    window.command_key(Key::E);
    let export = |window: &Window| match &window.state().file_flow.dialog {
        Some(Dialog::Export(export)) => *export,
        other => panic!("{other:?}"),
    };
    assert_eq!(export(&window).what, camera_lab::views::Views::One(View::Image));
    window.harness.get_by_role_and_label(Role::ComboBox, "size").click();
    window.run();
    window.click_in_dialog(&format!("m × n = {} × {}", image.width, image.height));
    let export = export(&window);
    assert_eq!((export.width, export.height, export.times), (image.width, image.height, None));
}

#[test]
fn own_lessons_are_in_the_list_wherever_their_files_are() {
    let folder = Folder::new("my-lessons");
    let path = folder.file("mine.toml");
    std::fs::write(&path, shipped()[2].text).expect("written");
    let mut window = Window::new(Lang::En);
    window.command_key(Key::O);
    window.choose(&path);
    assert!(window.state().recent.files.contains(&path));
    press(&mut window, Modifiers::ALT, Key::W);
    window.command_key(Key::N);
    press(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::L);
    assert!(window.says(lessons::texts(Lang::En).my_lessons));
    window.harness.get_all_by_label_contains(&shipped()[2].lesson.title.en).next().expect("the first").click();
    window.run();
    let playing = window.state().learn.lesson.as_ref().expect("a lesson");
    assert_eq!(playing.path.as_ref(), Some(&path));
}

/// A fault of one field keeps neither the others from the file nor its own text from the preview, and its message is in
/// sight. A number is put into the text from a menu.
#[test]
fn valid_parts_of_a_step_are_saved_beside_a_faulty_one() {
    let folder = Folder::new("valid-parts");
    let path = folder.file("mine.toml");
    std::fs::write(&path, shipped()[1].text).expect("written");
    let (t, tasks) = (lessons::texts(Lang::En), lesson_tasks::texts(Lang::En));
    let mut window = writing_in(&path, 1);
    write(&mut window);
    type_into(&mut window, t.step_text_field, "See {camera.nonsense} here");
    type_into(&mut window, t.step_title_field, "Another title");
    pause(&mut window);
    let step = |path| read_lesson(path).expect("a lesson").0.steps[1].clone();
    assert_eq!(step(&path).title.en, "Another title");
    assert!(!step(&path).text.en.contains("nonsense"));
    let seen = window.written();
    let place = |text: &str| seen.iter().find(|(line, _)| line.contains(text)).map(|(_, place)| *place);
    let message = place(t.not_written).expect("a message");
    assert!(message.is_positive() && message.top() < place(t.step_text_field).expect("a field").top());
    assert!(seen.iter().filter(|(line, _)| line.contains("{camera.nonsense} here")).count() > 1, "field and preview");
    window.click(t.forget_typed);
    type_into(&mut window, t.step_text_field, "The distance is ");
    window.harness.get_all_by_label_contains(tasks.insert_number).next().expect("a menu").click();
    window.run();
    window.click_in_dialog(tasks.camera_group);
    // With the mouse, which takes the keyboard from a field. The user goes on typing all the same.
    let place = window.harness.get_all_by_label_contains("D = ").last().expect("D").rect().center();
    let height = parameter(Lang::En, ParameterKey::Height);
    assert!(window.harness.query_by_label_contains(&height).is_none(), "H of another projection");
    window.click_at(place);
    window.harness.event(eframe::egui::Event::Text(" units".to_owned()));
    window.run();
    pause(&mut window);
    assert_eq!(step(&path).text.en, "The distance is {distance} units");
}

#[test]
fn a_step_says_which_keys_it_takes_and_leaves_the_panels_alone() {
    let folder = Folder::new("taken-keys");
    let path = folder.file("mine.toml");
    std::fs::write(&path, shipped()[1].text).expect("written");
    let t = lessons::texts(Lang::En);
    let mut window = writing_in(&path, 1);
    write(&mut window);
    window.app_mut().state.model.settings.panels_mut().show(Side::Right);
    window.run();
    window
        .app_mut()
        .state
        .model
        .desk
        .shown
        .edit(|figure| figure.style.antialias = camera_lab::appearance::Samples::One);
    window.run();
    window.click(t.step_screen);
    let message = window.state().model.message.as_ref();
    assert!(
        matches!(message, Some(Message::StepTook(keys)) if keys.contains(&"style.antialias".to_owned())),
        "{message:?}"
    );
    assert!(window.state().model.settings.panels().is_shown(Side::Right));
    window.click(t.step_another);
    assert!(window.state().model.settings.panels().is_shown(Side::Right));
}

/// With the text, the question and the notes of each step, the class still sees the pictures.
#[test]
fn the_pictures_keep_half_of_the_height_in_a_presentation() {
    for (lesson, shipped) in shipped().iter().enumerate().step_by(5) {
        let asks = |step: &camera_lab::lessons::Step| step.task.is_some() && step.notes.is_some();
        let Some(step) = shipped.lesson.steps.iter().position(asks) else { continue };
        let mut window = playing(lesson, step, Lang::PtBr);
        window.key(Key::F11);
        window.key(Key::Q);
        window.key(Key::N);
        window.run();
        let high = window.harness.ctx.content_rect().height();
        let places: Vec<Rect> =
            window.harness.state().as_ref().expect("a window").canvas.places().map(|(_, r)| r).collect();
        let [top, bottom] = [f32::min as fn(f32, f32) -> f32, f32::max]
            .map(|of| places.iter().flat_map(|place| [place.top(), place.bottom()]).reduce(of).expect("a picture"));
        assert!(bottom - top >= 0.5 * high - 1.0, "{}: {} of {high}", shipped.lesson.id, bottom - top);
    }
}

#[test]
fn menus_are_whole_in_a_presentation() {
    let mut window = playing(1, 0, Lang::PtBr);
    window.key(Key::F11);
    window.harness.hover_at(eframe::egui::pos2(400.0, 2.0));
    window.run();
    window.run();
    let words = camera_lab_words::window::texts(Lang::PtBr);
    for menu in [words.menu_view, words.menu_window, words.menu_present] {
        window.click(menu);
        window.run();
        let room = window.harness.ctx.content_rect();
        let entries: Vec<Rect> = window.harness.query_all_by_role(Role::Button).map(|node| node.rect()).collect();
        assert!(entries.iter().all(|entry| entry.bottom() <= room.bottom() + 0.5), "{menu}");
        window.key(Key::Escape);
        window.harness.hover_at(eframe::egui::pos2(400.0, 2.0));
        window.run();
    }
}

#[test]
fn a_message_without_room_in_the_bar_is_read_whole() {
    let mut window = Window::new(Lang::En);
    let path = std::path::PathBuf::from(format!("/{}/lesson.toml", "a-long-folder/".repeat(6)));
    let message = Message::StepAdded(path, 12, None);
    let text = message.text(Lang::En);
    window.app_mut().state.model.say(message);
    window.run();
    window.run();
    let line: String = window.written().iter().map(|(line, _)| line.as_str()).collect::<Vec<_>>().join(" ");
    let has = |text: &str| line.replace(' ', "").contains(&text.replace(' ', ""));
    assert!(has(&text), "{line}");
}

#[test]
fn the_lines_of_the_start_go_with_the_first_action() {
    let mut window = Window::new(Lang::En);
    window.app_mut().state.learn.welcome = true;
    window.run();
    let t = lessons::texts(Lang::En);
    assert!(window.says(t.new_here));
    window.run();
    assert!(window.says(t.new_here), "nothing has been done");
    window.enter("C x", "2");
    assert!(!window.says(t.new_here));
}

#[test]
fn an_edited_title_is_the_heading_of_the_presentation_at_once() {
    let folder = Folder::new("edited-title");
    let path = folder.file("mine.toml");
    std::fs::write(&path, shipped()[1].text).expect("written");
    let mut window = writing_in(&path, 1);
    write(&mut window);
    type_into(&mut window, lessons::texts(Lang::En).step_title_field, "A new heading");
    window.key(Key::F11);
    window.run();
    assert!(window.says("A new heading"));
}

#[test]
fn one_key_gives_a_weak_projector_the_strongest_contrast_and_takes_it_back() {
    use camera_lab::appearance::Theme;
    let mut window = Window::new(Lang::En);
    window.app_mut().state.model.settings.theme = Theme::Dark;
    window.key(Key::F11);
    window.key(Key::K);
    assert_eq!(window.state().model.settings.theme, Theme::Print);
    window.run();
    assert_eq!(window.harness.ctx.global_style().visuals.panel_fill, eframe::egui::Color32::WHITE);
    window.key(Key::K);
    assert_eq!(window.state().model.settings.theme, Theme::Dark);
}
