//! The tree of the scene: objects and lights added, renamed, hung elsewhere, moved, deleted, undone and saved.

use camera_lab::appearance::{Filter, TextureReveal, Wrap};
use camera_lab::figure::ShadowReveal;
use camera_lab::figure::read::parse;
use camera_lab::scene::{Light, LightKind, ObjectPaint, ObjectSpec, Preset, Shadows, Shape, TextureSource};
use camera_lab_desk::scene_tree::Selected;
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, TouchPhase, vec2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;

use super::files::{Dropped, Folder};
use super::window::Window;
use crate::words::{en, pt};

impl Window {
    /// The window with the tab of the scene open.
    fn scene(lang: Lang) -> Self {
        let mut window = Self::new(lang);
        window.key(Key::F6);
        window
    }

    fn objects(&self) -> &[ObjectSpec] {
        &self.state().model.desk.shown.figure().scene.objects
    }

    fn names(&self) -> Vec<&str> {
        self.objects().iter().map(|object| object.name.as_str()).collect()
    }

    fn row<'a>(&'a self, name: &'a str) -> egui_kittest::Node<'a> {
        self.harness.get_by_role_and_label(Role::TreeItem, name)
    }

    fn select(&mut self, name: &str) {
        self.row(name).click();
        self.run();
    }

    /// Chooses from the menu of objects that can be added.
    fn add(&mut self, button: &str, what: &str) {
        self.harness.get_by_role_and_label(Role::Button, button).click();
        self.run();
        let entries: Vec<_> = self.harness.query_all_by_role_and_label(Role::Button, what).collect();
        entries.last().expect("an entry").click();
        self.run();
        self.run();
    }

    /// Replaces the text of a field.
    fn write(&mut self, field: &str, text: &str, end: Key) {
        self.harness.get_by_role_and_label(Role::TextInput, field).click();
        self.run();
        self.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        self.run();
        self.harness.event(Event::Text(text.to_owned()));
        self.run();
        self.key(end);
        self.run();
    }

    /// Chooses an entry of a combo box.
    fn pick(&mut self, combo: &str, entry: &str) {
        self.harness.get_by_role_and_label(Role::ComboBox, combo).click();
        self.run();
        self.harness.get_by_role_and_label(Role::Button, entry).click();
        self.run();
    }
}

#[test]
fn of_thousands_of_objects_the_tree_has_the_rows_around_those_that_are_seen() {
    let mut window = Window::scene(Lang::En);
    let object = |i| ObjectSpec::group(format!("object {i}"));
    window.app_mut().state.model.desk.shown.edit(|figure| figure.scene.objects = (0..1000).map(object).collect());
    window.run();
    let rows = |window: &Window| window.harness.query_all_by_role(Role::TreeItem).count();
    assert!((20..400).contains(&rows(&window)), "{}", rows(&window));
    let place = window.row("object 3").rect().center();
    window.harness.hover_at(place);
    window.harness.event(Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        delta: vec2(0.0, -1e6),
        phase: TouchPhase::Move,
        source: MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    window.harness.run_steps(60);
    assert!(window.row("object 999").rect().bottom() < 800.0);
    window.select("object 999");
    let scene = &window.state().model.desk.shown.figure().scene;
    assert_eq!(window.state().model.tree.selected(scene), Some(&Selected::Object("object 999".to_owned())));
    // The keyboard continues from there.
    window.key(Key::ArrowUp);
    assert!(window.row("object 998").is_focused());
    assert!((20..400).contains(&rows(&window)));
    assert!(window.harness.query_by_role_and_label(Role::TreeItem, "object 3").is_none());
}

#[test]
fn adding_an_object_by_keyboard_closes_the_menu() {
    let mut window = Window::new(Lang::En);
    window.key(Key::F6);
    for (what, names) in [("sphere", &["sphere"][..]), ("group", &["sphere", "group"])] {
        window.harness.get_by_role_and_label(Role::Button, "Add").focus();
        window.run();
        window.key(Key::Enter);
        let entry = |window: &Window| window.harness.query_all_by_role_and_label(Role::Button, "torus").count();
        assert_eq!(entry(&window), 1, "the menu is open");
        window.harness.get_by_role_and_label(Role::Button, what).focus();
        window.run();
        window.key(Key::Enter);
        window.run();
        assert_eq!(window.names(), names);
        assert_eq!(entry(&window), 0, "the menu is closed");
    }
}

#[test]
fn a_sphere_is_added_renamed_hung_elsewhere_and_moved_and_each_is_undone() {
    let mut window = Window::scene(Lang::En);
    window.add("Add", "box");
    window.add("Add", "sphere");
    assert_eq!(window.names(), ["box", "sphere"]);
    assert_eq!(window.objects()[1].shape, Some(Shape::Sphere));

    window.write("name", "ball", Key::Enter);
    assert_eq!(window.names(), ["box", "ball"]);

    window.pick("parent", "box");
    assert_eq!(window.objects()[1].parent.as_deref(), Some("box"));
    let hung = window.objects()[1].translate;

    window.enter("translation x", "1/4");
    assert_eq!(window.objects()[1].translate.x, 0.25);
    window.enter("rotation y", "30°");
    window.enter("scale z", "2");
    window.enter(en::SCENES.shape_segments, "12");
    let moved = window.objects()[1].clone();
    assert_eq!((moved.rotate.y, moved.scale.z, moved.segments), (30.0, 2.0, 12));

    for _ in 0..4 {
        window.command_key(Key::Z);
    }
    assert_eq!(window.objects()[1].translate, hung);
    window.command_key(Key::Z);
    assert_eq!(window.objects()[1].parent, None);
    window.command_key(Key::Z);
    assert_eq!(window.names(), ["box", "sphere"]);
    window.command_key(Key::Z);
    window.command_key(Key::Z);
    assert!(window.names().is_empty() && !window.state().model.desk.can_undo(true));
    for _ in 0..8 {
        window.command_key(Key::Y);
    }
    assert_eq!(window.objects()[1], moved);
}

#[test]
fn the_scene_is_in_the_file_with_the_comments_that_were_there() {
    let folder = Folder::new("scene");
    let path = folder.file("arm.toml");
    let text = "# The arm.\n[scene]\npreset = \"empty\" # nothing else\n\n# It stands.\n[[scene.objects]]\nname = \"base\"\nshape = \"box\"\n";
    std::fs::write(&path, text).expect("written");
    let mut window = Window::opened(&path);
    window.key(Key::F6);
    window.add("Add", "cylinder");
    window.write("name", "link", Key::Tab);
    window.pick("parent", "base");
    window.enter("translation y", "1.5");
    window.add("Add", "point light");
    window.enter(&format!("{} y", en::SCENES.light_position), "4");
    window.command_key(Key::S);
    let saved = std::fs::read_to_string(&path).expect("saved");
    assert!(saved.starts_with("# The arm.\n[scene]\npreset = \"empty\" # nothing else\n\n# It stands.\n"), "{saved}");
    let figure = parse(&saved).expect("a figure");
    assert_eq!(&figure, window.state().model.desk.shown.figure());
    assert_eq!(figure.scene.objects[1].parent.as_deref(), Some("base"));
    assert_eq!(figure.scene.objects[1].translate.y, 1.5);
    assert!(matches!(figure.scene.lights[..], [Light { kind: LightKind::Point, vector, .. }] if vector.y == 4.0));
}

#[test]
fn a_light_gets_shadows_with_their_numbers_and_options() {
    let mut window = Window::scene(Lang::En);
    window.add("Add", "directional light");
    let shadows = |window: &Window| window.state().model.desk.shown.figure().scene.lights[0].shadows;
    assert!(!shadows(&window).cast && !window.says(en::SCENES.shadow_map));
    window.click(en::SCENES.shadows);
    assert_eq!(shadows(&window), Shadows::CAST);
    for (field, value) in [("shadow map", "256"), ("bias", "2.5"), ("soft edge", "0")] {
        window.enter(field, value);
    }
    assert_eq!(shadows(&window), Shadows { cast: true, map: 256, bias: 2.5, softness: 0.0 });
    window.enter(en::SCENES.shadow_map, "63");
    assert!(window.says("allowed: whole numbers from 64 to 4096") || window.says("64"));
    assert_eq!(shadows(&window).map, 256);
    window.key(Key::Escape);
    let t = camera_lab_words::window::scenes::texts(Lang::En);
    window.pick(t.shadow_reveal, t.shadow_of_light);
    assert_eq!(window.state().model.desk.shown.figure().reveal.shadows, Some(ShadowReveal::Map));
    window.click(en::SCENES.shadows);
    assert!(!shadows(&window).cast && shadows(&window).map == 256, "the numbers stay");
}

#[test]
fn an_impossible_value_shows_an_error_and_keeps_the_last_good_scene() {
    let mut window = Window::scene(Lang::En);
    window.add("Add", "cone");
    let before = window.objects()[0].clone();
    window.enter("scale x", "0");
    assert!(window.says("the scale must not be 0 along any axis"));
    assert_eq!(window.objects()[0], before);
    window.enter("scale x", "3");
    assert!(!window.says("the scale must not be 0"));
    assert_eq!(window.objects()[0].scale.x, 3.0);
    let before_segments = window.objects()[0].clone();
    window.enter(en::SCENES.shape_segments, "2");
    assert!(window.says("allowed: whole numbers from 3 to 512"));
    for typed in ["-5", "513", "1e12"] {
        window.key(Key::Escape);
        window.enter(en::SCENES.shape_segments, typed);
        assert!(window.says("allowed: whole numbers from 3 to 512"), "{typed}");
        assert_eq!(window.objects()[0], before_segments, "{typed}");
    }
    window.key(Key::Escape);
    window.enter(en::SCENES.shape_segments, "3");
    assert_eq!(window.objects()[0].segments, 3);

    window.add("Add", "torus");
    window.write("name", "cone", Key::Enter);
    assert!(window.says("another object has this name"));
    assert_eq!(window.names(), ["cone", "torus"]);
    window.write("name", "  ", Key::Enter);
    assert!(window.says(en::SCENES.name_empty));
    window.write("name", "ring", Key::Enter);
    assert_eq!(window.names(), ["cone", "ring"]);

    window.add("Add", "directional light");
    for axis in ["x", "y", "z"] {
        window.enter(&format!("direction {axis}"), "0");
    }
    assert!(window.says("the direction must not be 0"));
    window.enter("direction y", "-1");
    assert!(
        matches!(window.state().model.desk.shown.figure().scene.lights[..], [light] if light == Light::directional(-DVec3::Y))
    );
}

#[test]
fn a_value_typed_for_one_object_does_not_go_to_the_next_selected() {
    let mut window = Window::scene(Lang::En);
    window.add("Add", "box");
    window.add("Add", "cone");
    window.type_into("translation x", "7");
    window.select(en::SCENES.shape_box);
    window.run();
    assert_eq!(window.objects()[1].translate.x, 7.0, "it is taken over");
    assert_eq!(window.objects()[0].translate.x, 0.0);
}

#[test]
fn a_row_is_dragged_onto_its_new_parent_in_one_step() {
    let mut window = Window::scene(Lang::En);
    window.add("Add", "group");
    window.enter("rotation y", "90");
    window.select(en::SCENES.root);
    window.add("Add", "box");
    window.enter("translation x", "2");
    let (from, to) = (window.row(en::SCENES.shape_box).rect().center(), window.row(en::SCENES.group).rect().center());
    window.drag(from, to - from, |_| {});
    window.run();
    let hung = window.objects()[1].clone();
    assert_eq!(hung.parent.as_deref(), Some("group"));
    // It stays at (2, 0, 0): Ry(90°) takes z to x.
    assert!((hung.translate - DVec3::new(0.0, 0.0, 2.0)).length() < 1e-9, "{}", hung.translate);
    // Not onto its own child.
    let (from, to) = (window.row(en::SCENES.group).rect().center(), window.row(en::SCENES.shape_box).rect().center());
    window.drag(from, to - from, |_| {});
    assert_eq!(window.objects()[0].parent, None);
    let (from, to) = (window.row(en::SCENES.shape_box).rect().center(), window.row(en::SCENES.root).rect().center());
    window.drag(from, to - from, |_| {});
    window.run();
    assert_eq!(window.objects()[1].parent, None);
    assert!((window.objects()[1].translate - DVec3::new(2.0, 0.0, 0.0)).length() < 1e-9);
    window.command_key(Key::Z);
    assert_eq!(window.objects()[1], hung);
}

#[test]
fn deleting_asks_about_the_children() {
    let mut window = Window::scene(Lang::En);
    window.add("Add", "group");
    window.add("Add", "box");
    assert_eq!(window.objects()[1].parent.as_deref(), Some("group"), "it goes into the group that is selected");
    window.select(en::SCENES.group);
    window.click(en::SCENES.delete);
    window.click(en::SCENES.delete_alone);
    window.run();
    assert_eq!(window.names(), ["box"]);
    assert_eq!(window.objects()[0].parent, None);
    window.command_key(Key::Z);
    window.select(en::SCENES.group);
    window.key(Key::Delete);
    assert_eq!(window.names(), ["group", "box"], "the key asks too");
    window.click(en::WINDOW.cancel);
    window.run();
    assert_eq!(window.names(), ["group", "box"]);
    window.select(en::SCENES.group);
    window.key(Key::Delete);
    window.click(en::SCENES.delete_alone);
    window.run();
    assert_eq!(window.names(), ["box"]);
    window.command_key(Key::Z);
    window.select(en::SCENES.group);
    window.key(Key::Delete);
    window.click(en::SCENES.delete_all);
    window.run();
    assert!(window.names().is_empty());
    window.command_key(Key::Z);
    assert_eq!(window.names(), ["group", "box"]);
    // If it has no children, there is nothing to ask.
    window.select(en::SCENES.shape_box);
    window.key(Key::Delete);
    window.run();
    assert_eq!(window.names(), ["group"]);
}

#[test]
fn several_are_selected_copied_with_their_children_deleted_and_brought_back() {
    let mut window = Window::scene(Lang::En);
    window.add("Add", "group");
    window.add("Add", "box");
    window.select(en::SCENES.root);
    window.add("Add", "cone");
    let colors: Vec<_> = window.objects().iter().filter_map(|o| o.color).collect();
    assert!(colors.len() == 2 && colors[0] != colors[1], "each has a colour of its own");
    window.select(en::SCENES.group);
    window.harness.get_by_role_and_label(Role::TreeItem, "cone").click_modifiers(Modifiers::COMMAND);
    window.run();
    assert!(window.says("2 objects are selected"));
    window.click(en::SCENES.duplicate);
    window.run();
    assert_eq!(window.names(), ["group", "box", "group 2", "box 2", "cone", "cone 2"]);
    assert_eq!(window.objects()[3].parent.as_deref(), Some("group 2"));
    assert!(window.says("2 objects are selected"), "the copies");
    window.key(Key::Delete);
    window.run();
    // The keyboard is with the row that was clicked last, which is not selected any more.
    let before = window.names().len();
    window.select(en::SCENES.group);
    window.harness.get_by_role_and_label(Role::TreeItem, "box").click_modifiers(Modifiers::COMMAND);
    window.run();
    window.key(Key::Delete);
    window.run();
    assert_eq!(window.names().len(), before - 2, "nothing to ask: all that hangs on it is selected too");
    window.command_key(Key::Z);
    window.run();
    assert_eq!(window.names().len(), before);
    let scene = &window.state().model.desk.shown.figure().scene;
    assert_eq!(window.state().model.tree.names(scene), ["group".to_owned()].into(), "what came back is selected");
}

#[test]
fn objects_that_cannot_be_selected_together_say_why() {
    let mut window = Window::scene(Lang::En);
    let beside = |window: &mut Window, row: &str| {
        window.harness.get_by_role_and_label(Role::TreeItem, row).click_modifiers(Modifiers::COMMAND);
        window.run();
    };
    let why = "only if they're the figure's own";
    window.add("Add", "box");
    window.select(en::SCENES.root);
    window.add("Add", "cone");
    beside(&mut window, "box");
    assert!(window.says("2 objects are selected") && !window.says(why));
    window.pick("named scene", "house");
    beside(&mut window, "roof");
    assert!(window.says(why));
    // Nor does an object of the figure join it.
    window.app_mut().state.model.message = None;
    beside(&mut window, "box");
    assert!(window.says(why));
    // A single selected object has nothing to complain about.
    window.app_mut().state.model.message = None;
    window.select("roof");
    assert!(!window.says(why));
}

#[test]
fn a_new_object_is_in_sight_and_touches_nothing() {
    let folder = Folder::new("in sight");
    let path = folder.file("figure.toml");
    std::fs::write(&path, "[scene]\npreset = \"primitives\"\n").expect("written");
    let mut window = Window::opened(&path);
    window.key(Key::F6);
    window.run();
    let others: Vec<_> = window.state().model.scene_cache.scene().objects.iter().filter_map(|o| o.bounds()).collect();
    assert!(others.len() > 4);
    window.add("Add", "box");
    window.run();
    let scene = window.state().model.scene_cache.scene();
    let new = scene.objects.last().expect("the box").bounds().expect("it has corners");
    for other in &others {
        assert!((new.max.cmplt(other.min) | new.min.cmpgt(other.max)).any(), "{new:?} {other:?}");
    }
    let camera = window.state().model.desk.shown.camera();
    for corner in new.corners() {
        let clip = camera.clip_point(corner);
        assert!(clip.truncate().abs().max_element() <= clip.w, "{corner}");
    }
}

#[test]
fn a_named_scene_becomes_a_list_and_says_what_the_list_loses() {
    let mut window = Window::scene(Lang::PtBr);
    window.pick("cena nomeada", "cubo");
    window.run();
    window.click(pt::SCENES.edit_copy);
    window.run();
    let scene = window.state().model.desk.shown.figure().scene.clone();
    assert_eq!((scene.preset, scene.objects.len()), (Preset::Empty, 1));
    assert_eq!(scene.objects[0].name, "cubo", "the names are in the language of the window");
    let said = window.state().model.message.as_ref().expect("a message").text(Lang::PtBr);
    assert!(said.contains("os números nelas"), "{said}");
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.figure().scene.preset, Preset::Cube);
}

#[test]
fn a_colour_is_typed_and_given_back_to_the_palette() {
    let mut window = Window::scene(Lang::En);
    window.add("Add", "box");
    window.write("colour #", "#10203080", Key::Enter);
    assert_eq!(window.objects()[0].color.map(|c| c.to_string()).as_deref(), Some("#10203080"));
    window.write("colour #", "red", Key::Enter);
    assert!(window.says(en::SCENES.color_bad));
    window.write("colour #", "#ff0000", Key::Enter);
    assert_eq!(window.objects()[0].color.map(|c| c.to_string()).as_deref(), Some("#ff0000"));
    window.click(en::SCENES.color_auto);
    assert_eq!(window.objects()[0].color, None);
}

#[test]
fn switching_the_language_leaves_no_word_of_the_other_in_the_tab() {
    let mut window = Window::scene(Lang::En);
    window.add("Add", "sphere");
    window.command_key(Key::L);
    for word in ["translation", "parent", "Duplicate", "Add", "default light"] {
        assert!(!window.says(word), "{word}");
    }
    assert!(window.says(pt::SCENES.translate) && window.says("Adicionar") && window.says(pt::SCENES.default_light));
}

#[test]
fn a_mesh_file_is_added_by_relative_path_and_a_broken_one_says_why() {
    let folder = Folder::new("meshes");
    let path = folder.file("figure.toml");
    std::fs::write(&path, "[scene]\npreset = \"empty\"\n").expect("written");
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::fs::write(folder.file("tent.obj"), triangle).expect("written");
    std::fs::write(folder.file("torn.obj"), "v 0 0 0\nf 1 2 3\n").expect("written");
    let mut window = Window::opened(&path);
    window.key(Key::F6);
    window.add("Add", "mesh file…");
    window.choose(&folder.file("tent.obj"));
    window.run();
    assert_eq!(window.names(), ["tent"]);
    assert_eq!(window.objects()[0].shape, Some(Shape::Mesh { path: "tent.obj".to_owned() }));
    assert_eq!(window.state().model.scene_cache.scene().objects.len(), 1);

    window.harness.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(folder.file("torn.obj"))));
    window.run();
    window.run();
    assert_eq!(window.names(), ["tent", "torn"]);
    assert!(window.says("torn.obj") && window.says("line 2"));
    // The rest of the scene is there, and can be changed.
    window.select("tent");
    window.enter("translation z", "1");
    let scene = window.state().model.scene_cache.scene();
    assert_eq!((scene.objects.len(), scene.objects[0].world_from_object.w_axis.z), (1, 1.0));
    std::fs::write(folder.file("torn.obj"), format!("{triangle}f 1 2\n")).expect("written");
    window.select("torn");
    window.click(en::WINDOW.reload);
    window.run();
    assert_eq!(window.state().model.scene_cache.scene().objects.len(), 2);
    assert!(!window.says("line 2"));
    // A message at the object names the parts of a mesh that were left out.
    assert!(window.says("line 5: a face with 2 corners; it is left out"));
}

#[test]
fn files_outside_a_meshs_folder_are_read_once_the_user_allows_it() {
    let folder = Folder::new("reach");
    std::fs::create_dir_all(folder.file("inner")).expect("a folder");
    let path = folder.file("figure.toml");
    let object =
        |name: &str| format!("[[scene.objects]]\nname = \"{name}\"\nshape = \"mesh\"\npath = \"inner/{name}\"\n");
    std::fs::write(&path, object("tent.obj") + &object("tent.gltf")).expect("written");
    std::fs::write(folder.file("red.mtl"), "newmtl red\nKd 1 0 0\n").expect("written");
    let triangle = "mtllib ../red.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::fs::write(folder.file("inner/tent.obj"), triangle).expect("written");
    let gltf = r#"{"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "../points.bin"}]}"#;
    std::fs::write(folder.file("inner/tent.gltf"), gltf).expect("written");
    let points = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    std::fs::write(folder.file("points.bin"), points.map(f32::to_le_bytes).as_flattened()).expect("written");

    let mut window = Window::opened(&path);
    window.key(Key::F6);
    window.run();
    window.select("tent.obj");
    assert!(window.says("red.mtl") && window.says("a mesh names it and it lies elsewhere"));
    assert!(window.says("drawn without it"));
    window.select("tent.gltf");
    assert!(window.says("points.bin"));
    assert_eq!(window.state().model.scene_cache.scene().objects.len(), 1);
    window.click(en::SCENES.allow_files);
    window.run();
    window.run();
    assert_eq!(window.state().model.scene_cache.scene().objects.len(), 2);
    assert!(!window.says("points.bin") && !window.says(en::SCENES.allow_files));
    window.select("tent.obj");
    assert!(!window.says("red.mtl"));
}

#[test]
fn a_figure_that_is_saved_elsewhere_takes_the_way_to_its_meshes_along() {
    let folder = Folder::new("elsewhere");
    let path = folder.file("figure.toml");
    std::fs::write(&path, "[[scene.objects]]\nname = \"tent\"\nshape = \"mesh\"\npath = \"tent.obj\"\n")
        .expect("written");
    std::fs::write(folder.file("tent.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("written");
    std::fs::create_dir_all(folder.file("other")).expect("a folder");
    let mut window = Window::opened(&path);
    window.harness.key_press_modifiers(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::S);
    window.run();
    window.choose(&folder.file("other/copy.toml"));
    window.run();
    assert_eq!(window.objects()[0].shape, Some(Shape::Mesh { path: "../tent.obj".to_owned() }));
    assert_eq!(window.state().model.scene_cache.scene().objects.len(), 1);
}

#[test]
fn names_of_any_length_leave_the_panel_as_wide_as_it_is() {
    let mut window = Window::new(Lang::En);
    let width = |window: &Window| window.harness.get_by_label(en::WINDOW.drawing_tab).rect().right();
    window.key(Key::F6);
    let before = width(&window);
    let long = ["a", "b"].map(|letter| letter.repeat(5_000));
    let state = &mut window.app_mut().state;
    state.model.desk.shown.edit(|figure| {
        let of = |name: &str| ObjectSpec::new(name, Shape::Box);
        figure.scene.objects = vec![of(&long[0]), of(&long[1]).under(&long[0])];
    });
    state.model.tree.select(Some(Selected::Object(long[1].clone())));
    window.harness.run_steps(4);
    assert!(window.says("aaaaaaaaaa…"));
    assert_eq!(width(&window), before);
}

#[test]
fn an_object_gets_a_texture_and_says_which_file_it_lacks() {
    let folder = Folder::new("texture");
    for lang in [Lang::En, Lang::PtBr] {
        let t = camera_lab_words::window::scenes::texts(lang);
        let mut window = Window::scene(lang);
        window.app_mut().state.model.desk.shown.edit(|figure| {
            figure.scene.objects = vec![ObjectSpec::new("cube", Shape::Box)];
        });
        window.run();
        window.select(en::WINDOW.scene_cube);
        assert!(window.harness.query_by_role_and_label(Role::ComboBox, t.filter).is_none(), "there is none yet");
        window.pick(t.texture, t.texture_chequer);
        window.run();
        assert_eq!(window.objects()[0].texture, Some(TextureSource::Chequer));
        let paint = |window: &Window| window.state().model.scene_cache.scene().objects[0].paint.clone();
        assert!(matches!(paint(&window), ObjectPaint::Texture(_)));
        for (combo, entry) in [(t.wrap, t.wrap_mirror), (t.filter, t.filter_nearest)] {
            window.harness.get_by_role_and_label(Role::ComboBox, combo).scroll_to_me();
            window.run();
            window.pick(combo, entry);
        }
        assert_eq!((window.objects()[0].wrap, window.objects()[0].filter), (Some(Wrap::Mirror), Some(Filter::Nearest)));
        window.harness.get_by_role_and_label(Role::ComboBox, t.texture_reveal).scroll_to_me();
        window.run();
        window.pick(t.texture_reveal, t.texture_texels);
        assert_eq!(window.state().model.desk.shown.figure().reveal.texture, Some(TextureReveal::Texels));
        // A file that is not there: the object's colour, and a notice with its name.
        window.harness.get_by_role_and_label(Role::ComboBox, t.texture).scroll_to_me();
        window.run();
        window.pick(t.texture, t.texture_file);
        window.harness.get_by_role_and_label(Role::TextInput, t.texture_file).scroll_to_me();
        window.run();
        let missing = folder.file("missing.png");
        window.write(t.texture_file, &missing.to_string_lossy(), Key::Enter);
        for _ in 0..20 {
            window.run();
        }
        assert!(matches!(paint(&window), ObjectPaint::Solid(_)));
        assert!(window.says("missing.png"));
        // And one that is.
        let mut image = image::RgbImage::new(4, 2);
        image.put_pixel(0, 0, image::Rgb([255, 0, 0]));
        image.save(&missing).expect("a folder of the test");
        window.click(camera_lab_words::window::texts(lang).reload);
        for _ in 0..20 {
            window.run();
        }
        let ObjectPaint::Texture(pictured) = paint(&window) else { panic!("a texture") };
        assert_eq!((pictured.image.width(), pictured.image.height()), (4, 2));
        std::fs::remove_file(&missing).expect("its own file");
    }
}
