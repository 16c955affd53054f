//! Opening, saving, exporting and closing, with the questions that are asked in the window.

use std::fs;
use std::path::{Path, PathBuf};

use camera_lab::appearance::Rgba;
use camera_lab::export::png;
use camera_lab::figure::{Explanation, View};
use camera_lab::gui;
use camera_lab::gui::app::file_flow::questions::{Dialog, Purpose};
use camera_lab::progress::{Progress, at_once};
use camera_lab::scene::ObjectPaint;
use camera_lab_files as files;
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, ViewportCommand, ViewportEvent, ViewportId};
use egui_kittest::kittest::Queryable;

use super::lesson_writing::{playing, write};
use super::window::Window;
use crate::named_files;
use crate::words::en;

/// A folder that is there for one test.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("camera-lab-gui-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder for temporary files");
        Self(path)
    }

    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

impl Window {
    /// Types a path into the dialog that asks for one.
    pub(crate) fn choose(&mut self, path: &Path) {
        self.harness.get_by_role_and_label(Role::TextInput, "file").focus();
        self.run();
        self.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        self.harness.event(Event::Text(path.display().to_string()));
        self.run();
        self.key(Key::Enter);
    }

    /// Presses the window's own close button. Returns true if the window closes.
    fn ask_to_close(&mut self) -> bool {
        let events = |window: &mut Self| {
            std::mem::take(&mut window.harness.input_mut().viewports.entry(ViewportId::ROOT).or_default().events)
        };
        events(self);
        self.harness.input_mut().viewports.entry(ViewportId::ROOT).or_default().events.push(ViewportEvent::Close);
        self.harness.step();
        events(self);
        let commands = &self.harness.output().viewport_output[&ViewportId::ROOT].commands;
        let cancelled = commands.contains(&ViewportCommand::CancelClose);
        self.run();
        !cancelled
    }
}

#[test]
fn a_figure_goes_to_its_file_and_comes_back_with_its_comments() {
    let folder = Folder::new("round-trip");
    let path = folder.file("house.toml");
    fs::write(&path, "# For the lecture.\n[camera]\nfar = 50.0 # metres\n\n[scene]\npreset = \"empty\"\n")
        .expect("written");
    let mut window = Window::new(Lang::En);
    window.command_key(Key::O);
    window.choose(&path);
    assert_eq!(window.state().model.desk.shown.name().as_deref(), Some("house.toml"));
    assert_eq!(window.state().model.desk.shown.figure().camera.far, 50.0);
    window.enter("B", "75");
    assert!(window.state().model.desk.shown.is_changed());
    window.command_key(Key::S);
    assert!(!window.state().model.desk.shown.is_changed());
    let text = fs::read_to_string(&path).expect("there");
    assert!(text.starts_with("# For the lecture.\n") && text.contains("far = 75.0 # metres"), "{text}");
    let again = files::open_figure(&path).expect("readable").figure;
    assert_eq!(&again, window.state().model.desk.shown.figure());
}

#[test]
fn save_as_appends_the_ending_and_asks_before_it_replaces() {
    let folder = Folder::new("save-as");
    let mut window = Window::new(Lang::En);
    window.enter("B", "40");
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.run();
    window.choose(&folder.file("a"));
    assert!(folder.file("a.toml").exists());
    fs::write(folder.file("b.toml"), "precious").expect("written");
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.run();
    window.choose(&folder.file("b.toml"));
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Overwrite(..))));
    assert_eq!(fs::read_to_string(folder.file("b.toml")).expect("there"), "precious");
    window.click(en::WINDOW.cancel);
    assert_eq!(fs::read_to_string(folder.file("b.toml")).expect("there"), "precious");
    assert_eq!(window.state().model.desk.shown.name().as_deref(), Some("a.toml"));
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.run();
    window.choose(&folder.file("b.toml"));
    window.click(en::WINDOW.replace);
    assert_eq!(files::open_figure(&folder.file("b.toml")).expect("a figure").figure.camera.far, 40.0);
}

#[test]
fn a_path_to_open_is_typed_right_after_one_to_save() {
    let folder = Folder::new("two-paths");
    let mut window = Window::new(Lang::En);
    window.enter("B", "40");
    window.command_key(Key::O);
    window.click(en::WINDOW.save_first);
    window.choose(&folder.file("first.toml"));
    assert!(folder.file("first.toml").exists());
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Path(Purpose::Open, _))));
    let field = window.harness.get_by_role_and_label(Role::TextInput, en::WINDOW.path_name);
    assert!(field.is_focused());
    // The path to save asks for its own again.
    window.key(Key::Escape);
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.run();
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Path(Purpose::Save, _))));
}

#[test]
fn a_faulty_file_is_explained_and_changes_nothing() {
    let folder = Folder::new("faulty");
    let path = folder.file("broken.toml");
    fs::write(&path, "[camera]\nnear = true\n").expect("written");
    let mut window = Window::new(Lang::PtBr);
    let before = window.state().model.desk.shown.figure().clone();
    window.command_key(Key::O);
    window.harness.get_by_role_and_label(Role::TextInput, "arquivo").focus();
    window.run();
    window.harness.event(Event::Text(path.display().to_string()));
    window.run();
    window.key(Key::Enter);
    // The field is still open, with the reason below it.
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Path(..))));
    assert!(window.says("near é true"));
    window.key(Key::Escape);
    assert!(window.state().file_flow.dialog.is_none());
    assert_eq!(window.state().model.desk.shown.figure(), &before);
}

#[test]
fn changes_are_asked_about_before_they_are_lost() {
    let folder = Folder::new("unsaved");
    let mut window = Window::new(Lang::En);
    assert!(window.ask_to_close(), "nothing has been changed");
    let mut window = Window::new(Lang::En);
    window.enter("C x", "1");
    assert!(!window.ask_to_close());
    assert!(window.says(en::WINDOW.unsaved_title));
    window.click(en::WINDOW.cancel);
    assert!(!window.says(en::WINDOW.unsaved_title));
    window.command_key(Key::N);
    window.click(en::WINDOW.dont_save);
    assert_eq!(window.state().model.desk.shown.figure(), &camera_lab_desk::document::fresh());
    window.enter("C x", "2");
    assert!(!window.ask_to_close());
    window.click(en::WINDOW.save);
    window.choose(&folder.file("kept.toml"));
    assert_eq!(files::open_figure(&folder.file("kept.toml")).expect("a figure").figure.camera.position.x, 2.0);
    assert!(window.state().file_flow.may_close);
}

#[test]
fn an_undone_change_is_no_change() {
    let mut window = Window::new(Lang::En);
    window.enter("C x", "1");
    window.command_key(Key::Z);
    assert!(!window.state().model.desk.shown.is_changed());
    assert!(window.ask_to_close());
}

#[test]
fn an_exported_picture_holds_its_figure_and_brings_it_back() {
    let folder = Folder::new("export");
    let (path, figure) = (folder.file("view.png"), folder.file("view.toml"));
    let mut window = Window::new(Lang::En);
    window.enter("C x", "1.5");
    window.command_key(Key::S);
    window.choose(&figure);
    window.command_key(Key::E);
    assert!(window.says(en::WINDOW.export_heading));
    window.harness.get_by_role_and_label(Role::ComboBox, en::WINDOW.export_what).click();
    window.run();
    window.harness.query_all_by_label("Image").last().expect("an entry").click();
    window.run();
    window.harness.get_by_role_and_label(Role::ComboBox, "size").click();
    window.run();
    window.click(en::WINDOW.export_typed);
    window.enter(en::WINDOW.export_width, "64");
    window.enter(en::WINDOW.export_height, "48");
    window.click(en::WINDOW.export_action);
    window.choose(&path);
    window.wait(|_| path.exists());
    let bytes = fs::read(&path).expect("there");
    let text = png::figure_text(&bytes, 1 << 20).expect("a PNG").expect("with a figure");
    assert!(text.contains("theme = \"print\"") && text.contains("1.5"));
    // The command line gives the same bytes.
    let rendered = folder.file("rendered.png");
    let [figure, rendered_name] = [&figure, &rendered].map(|path| path.display().to_string());
    let arguments = ["camera-lab", "render", &figure, "--view", "image", "--size", "64x48", "--theme", "print", "-o"];
    let _ = camera_lab::cli::run(arguments.into_iter().chain([rendered_name.as_str()]).map(Into::into));
    assert_eq!(bytes, fs::read(&rendered).expect("rendered"));

    let mut other = Window::new(Lang::En);
    other.command_key(Key::O);
    other.choose(&path);
    assert_eq!(other.state().model.desk.shown.figure().camera.position.x, 1.5);
    // Saving must not write a figure file over the picture.
    assert!(other.state().model.desk.shown.path().is_none());
}

#[test]
fn a_picture_is_never_replaced_by_text_whatever_its_name_says() {
    let folder = Folder::new("picture-by-another-name");
    let path = folder.file("view.toml");
    let pixmap = tiny_skia::Pixmap::new(2, 2).expect("two by two");
    let picture = at_once(png::encode(
        pixmap,
        "[camera]\nnear = 0.5\n\n[scene]\npreset = \"empty\"\n",
        None,
        None,
        &Progress::default(),
    ))
    .expect("encoded");
    fs::write(&path, &picture).expect("written");
    for mut window in [Window::opened(&path), Window::new(Lang::En)] {
        window.command_key(Key::O);
        window.choose(&path);
        assert_eq!(window.state().model.desk.shown.figure().camera.near, 0.5);
        window.enter("F", "0.75");
        window.command_key(Key::S);
        assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Path(..))), "it asks for another file");
        assert_eq!(fs::read(&path).expect("there"), picture);
    }
    // A figure file is one, whatever its name says.
    let path = folder.file("figure.png");
    fs::write(&path, "[scene]\npreset = \"empty\"\n").expect("written");
    let mut window = Window::opened(&path);
    window.enter("F", "0.75");
    window.command_key(Key::S);
    assert_eq!(files::open_figure(&path).expect("a figure").figure.camera.near, 0.75);
}

#[test]
fn operations_of_the_command_line_are_a_change_of_the_file() {
    let text = "[camera]\nnear = 0.5\n";
    let mut figure = camera_lab::figure::read::parse(text).expect("a figure");
    let file = files::SourceFile { path: "f.toml".into(), text: text.to_owned(), ..Default::default() };
    let start = |figure| gui::Start {
        figure,
        file: Some(file.clone()),
        lang: Lang::En,
        allow_files: false,
        lesson: None,
        later: None,
    };
    assert!(!gui::State::new(start(figure.clone())).expect("a camera").model.desk.shown.is_changed());
    figure.camera.position.y = 7.0;
    let state = gui::State::new(start(figure)).expect("a camera");
    assert!(state.model.desk.shown.is_changed());
    assert_eq!(state.model.desk.shown.figure().camera.position.y, 7.0);
}

/// A file as the system drops it on the window.
#[derive(Debug)]
pub(crate) struct Dropped(pub(crate) PathBuf);

impl eframe::egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        fs::read(&self.0).map_err(|error| error.to_string())
    }
}

#[test]
fn a_dropped_file_is_opened_after_the_question_about_changes() {
    let folder = Folder::new("drop");
    let path = folder.file("dropped.toml");
    fs::write(&path, "[camera]\nfar = 61.0\n[scene]\npreset = \"empty\"\n").expect("written");
    let mut window = Window::new(Lang::En);
    window.enter("B", "40");
    window.harness.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(path)));
    window.run();
    assert!(window.says(en::WINDOW.unsaved_title));
    assert_eq!(window.state().model.desk.shown.draft().far, 40.0);
    window.click(en::WINDOW.dont_save);
    assert_eq!(window.state().model.desk.shown.draft().far, 61.0);
    assert_eq!(window.state().model.desk.shown.name().as_deref(), Some("dropped.toml"));
}

/// If a file holds only cameras, a message says what to do with it, and the figure stays.
#[test]
fn a_mesh_without_faces_is_refused_and_its_camera_has_a_way() {
    let folder = Folder::new("mesh-camera");
    let path = folder.file("camera.gltf");
    let text = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"camera":0}],
        "cameras":[{"type":"perspective","perspective":{"yfov":0.7,"znear":0.5,"zfar":50}}]}"#;
    fs::write(&path, text).expect("written");
    let mut window = Window::new(Lang::En);
    let before = window.state().model.desk.shown.figure().clone();
    window.command_key(Key::O);
    window.choose(&path);
    window.wait(|window| window.says(en::WINDOW.paste_camera));
    assert!(!window.says("[["));
    assert_eq!(window.state().model.desk.shown.figure(), &before);
}

/// A mesh that's far away and large is a scene of its own, seen whole. Saving asks for a file, and never replaces it.
#[test]
fn a_mesh_opens_as_a_scene_that_is_seen_whole() {
    let folder = Folder::new("mesh-scene");
    let path = folder.file("tent.obj");
    let text = "v 500 0 0\nv 700 0 0\nv 500 300 0\nv 500 0 90\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    fs::write(&path, text).expect("written");
    let mut window = Window::new(Lang::En);
    window.command_key(Key::O);
    window.choose(&path);
    window.run();
    let seen_whole = |window: &Window| {
        let (model, mut vertices) = (&window.state().model, 0);
        for object in &model.scene_cache.scene().objects {
            for &p in &object.mesh.positions {
                let clip = model.desk.shown.camera().clip_point(object.world_from_object.transform_point3(p));
                assert!(clip.w > 0.0 && clip.truncate().abs().max_element() <= clip.w, "{clip}");
                vertices += 1;
            }
        }
        vertices
    };
    assert!(seen_whole(&window) > 3);
    assert_eq!(window.state().model.desk.shown.figure().scene.objects.len(), 1);
    assert_eq!(window.state().model.desk.shown.path(), None);
    // A dropped one is added to it. Aim and fit are one step each, and both can be undone.
    fs::write(folder.file("box.obj"), text.replace("500", "900")).expect("written");
    window.harness.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(folder.file("box.obj"))));
    window.run();
    window.run();
    assert_eq!(window.state().model.desk.shown.figure().scene.objects.len(), 2);
    let camera = |window: &Window| *window.state().model.desk.shown.camera().parameters();
    let before = camera(&window);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::O);
    window.run();
    let aimed = camera(&window);
    let way = |camera: camera_lab::camera::Parameters| camera.position - camera.focal_point;
    assert!(aimed.focal_point.x > 690.0 && way(aimed).distance(way(before)) < 1e-9 * way(before).length());
    window.harness.key_press_modifiers(Modifiers::ALT, Key::I);
    window.run();
    assert_ne!(camera(&window), aimed);
    for earlier in [aimed, before] {
        window.command_key(Key::Z);
        assert_eq!(camera(&window), earlier);
    }
    assert_eq!(fs::read_to_string(&path).expect("there"), text);
}

#[test]
fn the_layout_is_saved_with_its_figure_and_comes_back() {
    let folder = Folder::new("layout");
    let path = folder.file("house.toml");
    fs::write(&path, "# Ours.\n[scene]\npreset = \"house\"\n").expect("written");
    let text = || fs::read_to_string(&path).expect("there");
    let mut window = Window::opened(&path);
    window.enter("B", "75");
    window.command_key(Key::S);
    assert!(!text().contains("[screen]"), "{}", text());
    window.explain(Explanation::Depth);
    window.command_key(Key::Num2);
    window.command_key(Key::S);
    let screen = "[screen]\npictures = [\"canonical\", \"image\"]\npanel = \"depth\"\n";
    assert!(text().starts_with("# Ours.\n") && text().ends_with(screen), "{}", text());
    assert!(!window.state().model.is_unsaved() && !window.state().model.desk.can_undo(false));
    // The layout is no step to be undone.
    window.command_key(Key::Z);
    assert_eq!(window.state().model.layout.shown, [false, true, true]);
    assert_eq!(window.state().model.desk.shown.draft().far, 100.0, "the last edit");
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    window.run();
    window.command_key(Key::S);
    // Another window shows it so, and saves it as it is then.
    let mut window = Window::opened(&path);
    window.app_mut().state.model.layout.maximized = None;
    window.run();
    assert_eq!(window.state().model.layout.shown, [false, true, true]);
    assert!(window.state().model.shows_explanation(Explanation::Depth) && !window.state().model.is_unsaved());
    window.harness.key_press_modifiers(Modifiers::ALT, Key::E);
    window.run();
    window.command_key(Key::S);
    assert!(text().ends_with(&screen.replace("depth", "none")), "{}", text());
    // An explained entry of a matrix comes back too.
    window.explain(Explanation::Matrices);
    window.app_mut().state.model.explained.matrices.entry = [2, 3];
    window.run();
    window.command_key(Key::S);
    let entry = "panel = \"matrices\"\nentry = { matrix = \"projection\", row = 3, column = 4 }\n";
    assert!(text().ends_with(entry), "{}", text());
    let window = Window::opened(&path);
    assert_eq!(window.state().model.explained.matrices.entry, [2, 3]);
}

#[test]
fn a_view_is_hidden_in_its_figure_and_leaving_asks() {
    let folder = Folder::new("layout-of-one");
    let path = folder.file("house.toml");
    fs::write(&path, "[scene]\npreset = \"house\"\n").expect("written");
    let mut window = Window::opened(&path);
    window.app_mut().state.model.layout.maximized = None;
    window.app_mut().state.model.layout.toggle(View::Canonical);
    window.run();
    assert!(window.state().model.is_unsaved(), "a file says otherwise");
    window.command_key(Key::N);
    assert!(window.says(en::WINDOW.unsaved_title));
    window.click(en::WINDOW.save);
    assert_eq!(window.state().model.desk.shown.name(), None);
    assert_eq!(window.state().model.layout.shown, [true; 3], "a new figure has all views");
    let saved = fs::read_to_string(&path).expect("there");
    assert!(saved.contains("pictures = [\"world\", \"image\"]"), "{saved}");
    // Without a file it's a way of looking: nothing asks.
    window.app_mut().state.model.layout.toggle(View::World);
    window.run();
    assert!(!window.state().model.is_unsaved());
    // A presentation hides for its audience only.
    let mut window = Window::opened(&path);
    window.app_mut().state.model.layout.maximized = None;
    window.key(Key::F11);
    window.app_mut().state.model.layout.toggle(View::World);
    window.run();
    assert_eq!(window.state().model.layout.shown, [false, false, true]);
    window.key(Key::F11);
    assert_eq!(window.state().model.layout.shown, [true, false, true]);
    assert!(!window.state().model.is_unsaved());
}

/// True if the window shows every file of its figure.
fn shows_all_files(window: &Window) -> bool {
    let model = &window.state().model;
    let scene = model.scene_cache.scene();
    let is_textured = |object: &camera_lab::scene::Object| matches!(object.paint, ObjectPaint::Texture(_));
    let red = |object: &camera_lab::scene::Object| object.paint == ObjectPaint::Solid(Rgba::rgb(255, 0, 0));
    scene.photograph.is_some() && scene.objects.iter().any(is_textured) && scene.objects.iter().any(red)
}

#[test]
fn save_as_into_another_folder_keeps_mesh_materials_texture_and_photograph() {
    let folder = Folder::new("names");
    for part in ["a", "far"] {
        fs::create_dir(folder.file(part)).expect("a folder");
    }
    named_files::write(&folder.file("a"));
    let (own, far) = (folder.file("a/figure.toml"), folder.file("far/new.toml"));
    let mut window = Window::new(Lang::En);
    window.command_key(Key::O);
    window.choose(&own);
    assert!(shows_all_files(&window));
    window.enter("B", "40");
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.run();
    window.choose(&far);
    assert!(shows_all_files(&window) && !window.state().model.desk.shown.is_changed());
    // Saving again, and each state of the history, lead to the same files.
    window.command_key(Key::S);
    window.command_key(Key::Z);
    assert!(shows_all_files(&window));
    assert_ne!(window.state().model.desk.shown.figure().camera.far, 40.0);
    window.command_key(Key::S);
    let mut again = Window::new(Lang::En);
    again.command_key(Key::O);
    again.choose(&far);
    assert!(shows_all_files(&again));
    for name in named_files::NAMES {
        fs::rename(folder.file("a").join(name), folder.file(name)).expect("moved");
    }
    let without = Window::opened(&far);
    assert!(!shows_all_files(&without));
    assert!(without.says("are missing"), "the image names the missing files");
}

#[test]
fn an_image_exported_elsewhere_carries_its_files_and_saves_them_too() {
    let folder = Folder::new("carried");
    for part in ["a", "far"] {
        fs::create_dir(folder.file(part)).expect("a folder");
    }
    named_files::write(&folder.file("a"));
    let mut window = Window::opened(&folder.file("a/figure.toml"));
    let image = folder.file("far/image.png");
    window.command_key(Key::E);
    window.click(en::WINDOW.export_action);
    window.choose(&image);
    window.wait(|window| image.exists() && !window.says("Exporting"));
    // With its files, the figure is also saved into a folder that can be sent.
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::F);
    window.run();
    window.choose(&folder.file("far/sent.toml"));
    assert!(shows_all_files(&window));
    fs::rename(folder.file("a"), folder.file("gone")).expect("moved");
    let moved = folder.file("moved");
    fs::rename(folder.file("far"), &moved).expect("moved");
    for file in ["image.png", "sent.toml"] {
        let mut other = Window::opened(&moved.join(file));
        assert!(shows_all_files(&other), "{file}");
        other.enter("B", "40");
        other.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
        other.run();
        other.choose(&folder.file("saved.toml"));
        if file == "image.png" {
            assert!(shows_all_files(&other), "saved from {file}");
            assert!(shows_all_files(&Window::opened(&folder.file("saved.toml"))));
        }
    }
}

#[test]
fn a_step_added_to_a_lesson_elsewhere_says_which_files_the_lesson_cannot_show() {
    let folder = Folder::new("step-names");
    fs::create_dir(folder.file("a")).expect("a folder");
    named_files::write(&folder.file("a"));
    let mut window = Window::opened(&folder.file("a/figure.toml"));
    // The lesson reads its own folder and below.
    for (lesson, is_said) in [("lesson.toml", false), ("b/lesson.toml", true)] {
        fs::create_dir_all(folder.file("b")).expect("a folder");
        window.app_mut().state.file_flow.dialog = Some(Dialog::Path(Purpose::Step, String::new()));
        window.run();
        window.choose(&folder.file(lesson));
        let (lesson, _) = files::read_lesson(&folder.file(lesson)).expect("a lesson");
        assert_eq!(window.says("the lesson won't show"), is_said, "{:?}", window.state().model.message);
        let names: Vec<&str> = lesson.steps[0].figure.files().map(|(name, _)| name).collect();
        assert!(is_said || names.iter().all(|name| name.starts_with("a/")), "{names:?}");
    }
    // The step is updated from the window's figure, with the same files.
    let mut window = playing(&folder.file("b/lesson.toml"), 0);
    write(&mut window);
    window.click(en::LESSONS.step_screen);
    assert!(window.says("the lesson won't show"), "{:?}", window.state().model.message);
}
