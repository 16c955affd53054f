//! Files to hand out: the page for students, and the package for a course platform.

use std::fs;
use std::path::Path;

use camera_lab::gui::app::file_flow::questions::{Dialog, Purpose};
use camera_lab::lessons::shipped;
use camera_lab_files::hand_out::lesson_with_files;
use camera_lab_files::share::{self, Held, text_in};
use camera_lab_words::Lang;
use camera_lab_words::learn::lessons;
use camera_lab_words::window::sharing;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;

use super::files::{Dropped, Folder};
use super::lessons::playing;
use super::window::Window;

/// A page of this version, as far as the program looks.
const PAGE: &str = concat!("<meta name=\"camera-lab\" content=\"", env!("CARGO_PKG_VERSION"), "\">Stand-in");

#[test]
fn the_page_is_asked_for_once_and_opens_the_figure_or_the_lesson() {
    let folder = Folder::new("hand-out");
    let mut window = Window::new(Lang::En);
    let write = |window: &mut Window, key, name: &str| {
        window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, key);
        window.run();
        window.choose(&folder.file(name));
        window.run();
    };
    let asks_for_page =
        |window: &Window| matches!(&window.state().file_flow.dialog, Some(Dialog::Path(Purpose::Page(_), _)));
    fs::write(folder.file("other.html"), "<html>").expect("written");
    write(&mut window, Key::H, "other.html");
    assert!(asks_for_page(&window) && window.says("isn't the page of this version"));
    fs::write(folder.file("camera-lab.html"), PAGE).expect("written");
    window.choose(&folder.file("camera-lab.html"));
    window.run();
    window.choose(&folder.file("figure.html"));
    window.run();
    let page = fs::read_to_string(folder.file("figure.html")).expect("a page");
    let link = page.split('\'').find(|part| part.starts_with("#figure=")).expect("a link");
    assert!(matches!(text_in(link), Some(Ok(text)) if text.starts_with(b"[")), "{link}");
    // No lesson, no package. The page isn't asked for again.
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::M);
    window.run();
    assert_eq!(window.state().file_flow.dialog, None);
    let mut lesson = playing(1, 0, Lang::En);
    lesson.app_mut().state.sharing.page_file = folder.file("camera-lab.html");
    let window = &mut lesson;
    let id = format!("&lesson={}'", shipped()[1].lesson.id);
    write(window, Key::H, "lesson.html");
    assert!(fs::read_to_string(folder.file("lesson.html")).expect("a page").contains(&id));
    write(window, Key::M, "course.zip");
    assert!(fs::read(folder.file("course.zip")).expect("a package").starts_with(b"PK"));
}

/// A mesh of the user's own goes with the figure, in a link and in the page.
#[test]
fn a_figure_that_is_handed_out_takes_its_mesh_along() {
    let folder = Folder::new("hand-out-mesh");
    fs::write(folder.file("tent.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n").expect("written");
    fs::copy(folder.file("tent.obj"), folder.file("second.obj")).expect("written");
    fs::write(folder.file("camera-lab.html"), PAGE).expect("written");
    let mut window = Window::new(Lang::En);
    window.command_key(Key::O);
    window.choose(&folder.file("tent.obj"));
    window.app_mut().state.sharing.page_file = folder.file("camera-lab.html");
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::H);
    window.run();
    window.choose(&folder.file("tent.html"));
    window.run();
    let page = fs::read_to_string(folder.file("tent.html")).expect("a page");
    let of_page = page.split('\'').find(|part| part.starts_with("#figure=")).expect("a link").to_owned();
    window.command_key(Key::K);
    let words = sharing::texts(Lang::En);
    assert!(!window.says(words.own_files), "nothing is left out");
    let field = window.harness.get_by_role_and_label(Role::TextInput, words.link);
    let of_dialog = field.value().expect("a link");
    fs::remove_file(folder.file("tent.obj")).expect("a file");
    for link in [of_page, of_dialog] {
        let mut other = Window::new(Lang::En);
        other.command_key(Key::O);
        other.choose(Path::new(&link));
        other.run();
        other.wait(|window| !window.state().model.scene_cache.scene().objects.is_empty());
        let objects = |window: &Window| {
            let scene = window.state().model.scene_cache.scene();
            scene.objects.iter().filter(|object| object.mesh.positions.len() >= 4).count()
        };
        assert_eq!(objects(&other), 1);
        // A mesh of one's own disk joins it, and goes along from now on.
        other.harness.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(folder.file("second.obj"))));
        other.run();
        other.wait(|window| objects(window) == 2);
        assert!(!other.says("second.obj"), "nothing is refused");
    }
}

/// The copy of a lesson from a link has the meshes that came with it.
#[test]
fn a_lesson_from_a_link_is_copied_with_its_meshes() {
    let folder = Folder::new("hand-out-copy");
    fs::write(folder.file("tent.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n").expect("written");
    let text = "id = \"own\"\ntitle = \"Own\"\n[[step]]\ntitle = \"One\"\n[[step.scene.objects]]\nname = \"tent\"\n\
                shape = \"mesh\"\npath = \"tent.obj\"\n";
    let lesson = camera_lab::lessons::parse(text).expect("a lesson");
    let whole = lesson_with_files(text, &lesson, Some(&folder.file("own.toml"))).expect("it has room");
    let link = share::link("", Held::Lesson, &whole).expect("a link");
    fs::create_dir(folder.file("mine")).expect("a folder");
    let copy = folder.file("mine/copy.toml");
    let mut window = Window::new(Lang::En);
    window.command_key(Key::O);
    window.choose(Path::new(&link));
    window.run();
    // The button is there for all lessons that aren't in a file yet.
    window.click(lessons::texts(Lang::En).copy_title);
    window.choose(&copy);
    window.run();
    assert_eq!(fs::read_to_string(&copy).expect("a lesson"), text);
    assert_eq!(
        fs::read(folder.file("mine/tent.obj")).expect("a mesh"),
        fs::read(folder.file("tent.obj")).expect("a mesh")
    );
    assert_eq!(window.state().learn.lesson.as_ref().and_then(|playing| playing.path.as_deref()), Some(&*copy));
}
