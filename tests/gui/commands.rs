//! Menus, keys, presentation, and a window that is left alone.

use camera_lab::appearance::Theme;
use camera_lab::figure::WorldLook;
use camera_lab::figure::{Measure, Measured};
use camera_lab::gui::LaunchOptions;
use camera_lab::gui::app::command::MENUS;
use camera_lab::gui::kit::keys::Command;
use camera_lab::views::View;
use camera_lab::views::observer::Viewpoint;
use camera_lab_desk::layout::{ObserverChange, Side};
use camera_lab_words::Lang;
use camera_lab_words::window::{cameras, compare, photograph, predict, search, texts};
use eframe::egui::accesskit::Role;
use eframe::egui::os::OperatingSystem;
use eframe::egui::{self, Event, Key, Modifiers};
use egui_kittest::kittest::{By, Queryable};

use super::files::Folder;
use super::window::Window;
use crate::words::{en, pt};

impl Window {
    /// The image has the keyboard.
    fn focus_image(&mut self) {
        self.harness.get_by_label_contains("Image: what the camera sees").focus();
        self.run();
    }

    /// A key goes down, or up.
    pub(crate) fn key_event(&mut self, key: Key, pressed: bool, modifiers: Modifiers) {
        self.harness.event(Event::Key { key, physical_key: None, pressed, repeat: false, modifiers });
        self.harness.step();
    }

    /// As on most keyboards: + is Shift and =, and Shift is let go first.
    pub(crate) fn plus_that_comes_up_as_equals(&mut self) {
        self.key_event(Key::Plus, true, Modifiers::SHIFT);
        self.key_event(Key::Equals, false, Modifiers::NONE);
    }
}

#[test]
fn turns_after_a_plus_are_undone_one_by_one() {
    let mut window = Window::new(Lang::En);
    window.focus_image();
    let camera = |window: &Window| *window.state().model.desk.shown.camera().parameters();
    let mut cameras = vec![camera(&window)];
    window.plus_that_comes_up_as_equals();
    cameras.push(camera(&window));
    for key in [Key::ArrowRight, Key::ArrowRight, Key::ArrowUp] {
        window.key(key);
        cameras.push(camera(&window));
    }
    for (i, before) in cameras.iter().enumerate().rev().skip(1) {
        assert_ne!(camera(&window), *before, "step {i} does something");
        window.command_key(Key::Z);
        assert_eq!(camera(&window), *before, "step {i} is taken back alone");
    }
    assert!(!window.state().model.desk.can_undo(true));
}

#[test]
fn a_held_key_makes_one_step() {
    let mut window = Window::new(Lang::En);
    window.focus_image();
    let camera = |window: &Window| *window.state().model.desk.shown.camera().parameters();
    let before = camera(&window);
    for _ in 0..10 {
        window.key_event(Key::ArrowRight, true, Modifiers::NONE);
    }
    let turned = camera(&window);
    // Another key, while the first one is still down.
    for _ in 0..3 {
        window.key_event(Key::ArrowUp, true, Modifiers::NONE);
    }
    window.key_event(Key::ArrowUp, false, Modifiers::NONE);
    window.key_event(Key::ArrowRight, false, Modifiers::NONE);
    window.command_key(Key::Z);
    assert_eq!(camera(&window), turned);
    window.command_key(Key::Z);
    assert_eq!(camera(&window), before);
    assert!(!window.state().model.desk.can_undo(true));
}

#[test]
fn a_key_that_never_comes_up_is_not_held_for_ever() {
    let mut window = Window::new(Lang::En);
    window.focus_image();
    window.key_event(Key::ArrowRight, true, Modifiers::NONE);
    assert!(!window.state().model.desk.can_undo(true), "it may repeat yet");
    window.harness.run_steps(6);
    assert!(window.state().model.desk.can_undo(true));
}

#[test]
fn every_command_stands_in_a_menu_with_its_keys() {
    let mut window = Window::new(Lang::En);
    let t = texts(Lang::En);
    let titles = ["File", "Edit", "View", "Window", "Present", "Hand out", "Help"];
    let in_bar = || MENUS.iter().filter(|menu| menu.in_bar);
    assert_eq!(in_bar().count(), titles.len());
    for (title, menu) in titles.into_iter().zip(in_bar()) {
        window.harness.get_all_by_label(title).next().expect("a menu").click();
        window.run();
        for command in
            menu.groups(&window.state().model).flatten().filter(|c| c.is_listed(window.state())).collect::<Vec<_>>()
        {
            assert!(window.says(command.label(t)), "{command:?}");
            assert!(window.says(&window.harness.ctx.format_shortcut(&command.shortcut())), "{command:?}");
        }
        window.key(Key::Escape);
    }
}

#[test]
fn presentation_enlarges_everything_and_gives_the_room_to_the_pictures() {
    let mut window = Window::new(Lang::En);
    assert_eq!(window.state().model.settings.stroke_scale(), 1.0);
    window.key(Key::F11);
    assert!(window.state().model.settings.stroke_scale() > 1.0);
    assert!(window.harness.ctx.zoom_factor() > 1.5);
    assert!(!window.says(en::WINDOW.elevation_effect));
    window.key(Key::F9);
    assert!(window.says(en::WINDOW.elevation_effect));
    window.key(Key::F11);
    assert_eq!(window.harness.ctx.zoom_factor(), 1.0);
    assert!(window.says(en::WINDOW.elevation_effect) && window.says(en::WINDOW.view_angle));
}

#[test]
fn the_way_out_of_a_presentation_can_be_read_on_a_small_screen() {
    for (lang, way) in [(Lang::En, "Esc: leave · Page"), (Lang::PtBr, "Esc: sair · Page")] {
        let mut window = Window::new(lang);
        window.harness.set_size([1280.0, 720.0].into());
        window.key(Key::F11);
        // The size of the window is in points, which are larger now.
        window.harness.set_size(egui::vec2(1280.0, 720.0) / window.harness.ctx.zoom_factor());
        window.run();
        let written = window.written();
        assert!(written.iter().any(|(line, _)| line.contains(way)), "{lang:?}: {written:?}");
        // All of it, and within the screen.
        let last = if lang == Lang::En { "all keys" } else { "todas as teclas" };
        let screen = window.harness.ctx.content_rect();
        assert!(written.iter().any(|(line, rect)| line.contains(last) && screen.contains_rect(*rect)), "{written:?}");
        // It follows the language at once, and fades.
        window.command_key(Key::L);
        assert!(!window.written().iter().any(|(line, _)| line.contains(way)));
        assert!(window.written().iter().any(|(line, _)| line.starts_with("Esc: ")));
        window.command_key(Key::L);
        window.harness.input_mut().time = Some(1000.0);
        window.harness.step();
        window.harness.step();
        assert!(!window.written().iter().any(|(line, _)| line.contains(way)));
    }
}

#[test]
fn the_interface_grows_and_shrinks() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::Plus);
    window.command_key(Key::Equals);
    assert!((window.harness.ctx.zoom_factor() - 1.2).abs() < 1e-6);
    window.command_key(Key::Minus);
    assert!((window.harness.ctx.zoom_factor() - 1.1).abs() < 1e-6);
    window.command_key(Key::Num0);
    assert_eq!(window.harness.ctx.zoom_factor(), 1.0);
}

#[test]
fn a_narrow_window_has_room_for_one_panel() {
    let mut window = Window::new(Lang::En);
    window.harness.set_size([800.0, 600.0].into());
    window.run();
    let shown =
        |window: &Window| [Side::Left, Side::Right].map(|side| window.state().model.settings.panels().is_shown(side));
    assert_eq!(shown(&window), [true, false]);
    window.key(Key::F9);
    assert_eq!(shown(&window), [false, true]);
    window.key(Key::F8);
    assert_eq!(shown(&window), [true, false]);
    window.key(Key::F8);
    assert_eq!(shown(&window), [false, true]);
    window.key(Key::F9);
    assert_eq!(shown(&window), [false, false]);
}

#[test]
fn on_a_telephone_the_menus_are_in_one_and_everything_in_the_bar_is_on_the_screen() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = texts(lang);
        let mut window = Window::new(lang);
        window.harness.set_size([390.0, 844.0].into());
        window.run();
        let screen = window.harness.ctx.content_rect();
        let mut bar: Vec<_> = window.written().into_iter().filter(|(_, rect)| rect.max.y < 48.0).collect();
        bar.sort_by(|(_, a), (_, b)| a.min.x.total_cmp(&b.min.x));
        assert!(bar.len() >= 7 && bar.iter().all(|(_, rect)| screen.contains_rect(*rect)), "{bar:?}");
        assert!(bar.windows(2).all(|pair| pair[0].1.max.x < pair[1].1.min.x), "{bar:?}");
        window.click(t.menus);
        window.menu(t.menu_window, Command::ReduceMotion.label(t));
        assert!(window.state().model.settings.reduce_motion);
        assert!(!window.says(t.menu_file), "the menus are closed");
    }
}

#[test]
fn the_theme_is_that_of_the_pictures_and_of_the_window() {
    let mut window = Window::new(Lang::En);
    assert_eq!(window.harness.ctx.theme(), egui::Theme::Light);
    window.command_key(Key::T);
    assert_eq!(window.state().model.settings.theme, Theme::Dark);
    assert_eq!(window.harness.ctx.theme(), egui::Theme::Dark);
    // It is not the figure that has changed.
    let document = &window.state().model.desk.shown;
    assert!(!document.is_changed() && !document.can_undo(true));
    assert_eq!(document.figure().style.theme, Theme::Light);
    // Nor does another figure change it, not even one that was drawn for print.
    let folder = Folder::new("theme");
    let path = folder.file("print.toml");
    std::fs::write(&path, "[scene]\npreset = \"empty\"\n[style]\ntheme = \"print\"\n").expect("written");
    window.command_key(Key::O);
    window.choose(&path);
    assert_eq!(window.state().model.desk.shown.figure().style.theme, Theme::Print);
    assert_eq!((window.state().model.settings.theme, window.harness.ctx.theme()), (Theme::Dark, egui::Theme::Dark));
}

#[test]
fn changed_preferences_are_remembered_for_the_next_window() {
    let folder = Folder::new("preferences");
    let figure = folder.file("figure.toml");
    std::fs::write(&figure, "[scene]\npreset = \"empty\"\n").expect("written");
    let remembering = || {
        let mut window = Window::new(Lang::En);
        let ctx = window.harness.ctx.clone();
        window.app_mut().keep_preferences(&ctx, &folder.file("config"), LaunchOptions::default());
        window.run();
        window
    };
    let mut window = remembering();
    window.command_key(Key::T);
    window.command_key(Key::L);
    window.key(Key::F10);
    window.command_key(Key::O);
    window.harness.get_by_role_and_label(Role::TextInput, "arquivo").focus();
    window.run();
    window.harness.event(Event::Text(figure.display().to_string()));
    window.run();
    window.key(Key::Enter);
    eframe::App::on_exit(window.app_mut(), None);
    let next = remembering();
    assert_eq!((next.state().model.settings.lang, next.state().model.settings.theme), (Lang::PtBr, Theme::Dark));
    assert!(next.state().model.layout.strip && next.says(pt::WINDOW.menu_file));
    assert_eq!(next.harness.ctx.theme(), egui::Theme::Dark);
    assert_eq!(next.state().recent.files, [figure]);
}

#[test]
fn pictures_are_hidden_and_shown_and_looked_at() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::Num1);
    assert!(window.state().model.layout.is_shown(View::World));
    window.command_key(Key::Num1);
    assert!(!window.state().model.layout.is_shown(View::World));
    // The last one stays.
    window.command_key(Key::Num3);
    assert!(window.state().model.layout.is_shown(View::Image));
    window.command_key(Key::Num1);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::Num2);
    window.run();
    let observers = window.state().model.desk.shown.figure().observers;
    assert_eq!(
        observers.world.map(|observer| observer.elevation),
        Some(90.0),
        "{:?}",
        ObserverChange::From(Viewpoint::Top)
    );
    // Looking from somewhere else is no change of the figure.
    assert!(!window.state().model.desk.shown.is_changed() && !window.state().model.desk.can_undo(true));
}

#[test]
fn a_window_that_is_left_alone_does_not_repaint() {
    let mut window = Window::new(Lang::En);
    window.enter("C x", "2");
    window.assert_rests();
}

#[test]
fn help_lists_the_keys() {
    let mut window = Window::new(Lang::PtBr);
    window.key(Key::F1);
    assert!(window.says(pt::WINDOW.help) && window.says("Ctrl+Shift+S"));
    assert!(window.says("Ctrl+Shift+Z, Ctrl+Y"), "every key of a command is named");
    window.click("Fechar");
    assert_eq!(window.state().file_flow.dialog, None);
    assert!(!window.says("Ctrl+Shift+S"));
}

#[test]
fn about_names_the_version_the_licence_and_the_libraries() {
    let mut window = Window::new(Lang::PtBr);
    window.harness.key_press_modifiers(Modifiers::SHIFT, Key::F1);
    window.run();
    assert!(window.says(&format!("Camera Lab {}", env!("CARGO_PKG_VERSION"))) && window.says("licença MIT"));
    assert!(window.says("ab_glyph"), "the first of the libraries");
    window.click("Fechar");
    assert_eq!(window.state().file_flow.dialog, None);
}

/// Key presses that all come in one frame.
fn in_one_frame(window: &mut Window, keys: &[(Modifiers, Key)]) {
    for &(modifiers, key) in keys {
        for pressed in [true, false] {
            let event = Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
            window.harness.input_mut().events.push(event);
        }
    }
    window.run();
}

#[test]
fn every_key_of_a_frame_acts() {
    let mut window = Window::new(Lang::En);
    let x = |window: &Window| window.state().model.desk.shown.camera().position().x;
    let start = x(&window);
    for value in 1..=6 {
        window.enter("C x", &(10 * value).to_string());
    }
    in_one_frame(&mut window, &[(Modifiers::COMMAND, Key::Z); 6]);
    assert_eq!((x(&window), window.state().model.desk.can_undo(true)), (start, false));
    in_one_frame(&mut window, &[(Modifiers::COMMAND, Key::Y); 4]);
    assert_eq!(x(&window), 40.0);
    // In their order: two back, one forward.
    let [undo, redo] = [(Modifiers::COMMAND, Key::Z), (Modifiers::COMMAND | Modifiers::SHIFT, Key::Z)];
    in_one_frame(&mut window, &[undo, redo, undo, undo, redo]);
    assert_eq!(x(&window), 30.0);
    in_one_frame(&mut window, &[(Modifiers::NONE, Key::F10), (Modifiers::NONE, Key::F8), (Modifiers::NONE, Key::F9)]);
    let shown = [Side::Left, Side::Right].map(|side| window.state().model.settings.panels().is_shown(side));
    assert!(window.state().model.layout.strip && shown == [false, false]);
    let before: Vec<bool> = View::ALL.map(|view| window.state().model.layout.is_shown(view)).into();
    in_one_frame(&mut window, &[(Modifiers::COMMAND, Key::Num2), (Modifiers::COMMAND, Key::Num3)]);
    let after: Vec<bool> = View::ALL.map(|view| window.state().model.layout.is_shown(view)).into();
    assert!(before[1] != after[1], "{before:?} {after:?}");
}

#[test]
fn keys_after_a_dialogs_shortcut_do_not_reach_the_window() {
    let mut window = Window::new(Lang::En);
    let theme = window.state().model.desk.shown.figure().style.theme;
    in_one_frame(&mut window, &[(Modifiers::COMMAND, Key::E), (Modifiers::COMMAND, Key::T)]);
    assert!(window.state().file_flow.dialog.is_some());
    assert_eq!(window.state().model.desk.shown.figure().style.theme, theme);
}

#[test]
fn the_arc_of_an_operation_goes_with_its_panel() {
    let mut window = Window::new(Lang::En);
    let at = window.harness.get_by_label("Elevation: slider").rect().center();
    window.harness.hover_at(at);
    window.run();
    assert!(window.state().model.frame.hover.ghost.is_some());
    window.key(Key::F9);
    assert!(window.state().model.frame.hover.ghost.is_none());
    window.key(Key::F9);
    assert!(window.state().model.frame.hover.ghost.is_some(), "it is pointed at again");
}

#[test]
fn news_go_when_they_have_been_read_and_errors_stay() {
    let mut window = Window::new(Lang::En);
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::C);
    window.run();
    assert!(window.says("Copied"));
    let pass = |window: &mut Window, seconds: f64| {
        let steps = (seconds / f64::from(window.harness.input_mut().predicted_dt)).ceil();
        window.harness.run_steps(steps as usize);
    };
    pass(&mut window, 5.0);
    assert!(window.says("Copied"));
    pass(&mut window, 6.0);
    assert!(!window.says("Copied") && window.state().model.message.is_none());
    let error = camera_lab::camera::CameraError::ViewUpZero;
    window.app_mut().state.model.say(camera_lab_desk::message::Message::Camera(error));
    pass(&mut window, 12.0);
    assert!(window.state().model.message.is_some());
}

#[test]
fn a_parameter_that_is_pointed_at_shows_its_length_in_the_world_and_no_other_does() {
    let mut window = Window::new(Lang::En);
    for (field, measure) in [("F", Measure::Near), ("B", Measure::Far), ("θ", Measure::HalfAngle)] {
        let place = window.field(field).rect().center();
        window.harness.hover_at(place);
        window.run();
        assert_eq!(window.state().model.frame.hover.measured, [Measured::Dimension(measure)], "{field}");
    }
    window.harness.remove_cursor();
    window.run();
    assert!(window.state().model.frame.hover.measured.is_empty());
}

#[test]
fn section_and_dimensions_are_switched_by_their_commands_and_undone_like_any_edit() {
    let mut window = Window::new(Lang::En);
    let press = |window: &mut Window, modifiers: Modifiers, key: Key| {
        window.harness.key_press_modifiers(modifiers, key);
        window.run();
    };
    press(&mut window, Modifiers::ALT, Key::Num9);
    press(&mut window, Modifiers::ALT, Key::Num8);
    let world = window.state().model.desk.shown.figure().world;
    assert!(world.section && world.dimensions);
    press(&mut window, Modifiers::ALT, Key::Num9);
    assert!(window.state().model.desk.shown.figure().world.dimensions, "the section has its own: it does nothing");
    press(&mut window, Modifiers::COMMAND, Key::Z);
    press(&mut window, Modifiers::ALT, Key::Num9);
    assert_eq!(window.state().model.desk.shown.figure().world, WorldLook::default());
}

/// A window with all three pictures.
fn whole(lang: Lang) -> Window {
    let mut window = Window::new(lang);
    window.app_mut().state.model.layout.maximized = None;
    window.run();
    window
}

#[test]
fn from_where_to_look_is_a_menu_in_words_with_the_keys_for_it() {
    for (lang, menu, entry) in [(Lang::En, "Look from…", "From the side (+x)"), (Lang::PtBr, "Ver de…", "De lado (+x)")]
    {
        let mut window = whole(lang);
        let world = window.harness.query_all(By::new().label(menu)).next().expect("the menu of the world");
        world.click();
        window.run();
        let keys = window.written().into_iter().any(|(text, _)| text.contains("Alt+3"));
        assert!(keys, "{:?}", window.written());
        // The buttons beside it have the same names, but no words.
        let place = window.written().into_iter().find(|(text, _)| text == entry).expect(entry).1;
        let in_menu = window.harness.query_all(By::new().label_contains(entry));
        in_menu.into_iter().find(|node| node.rect().contains(place.center())).expect(entry).click();
        window.run();
        let seen = window.state().model.desk.shown.figure().observers.world.expect("an observer");
        assert_eq!((seen.azimuth, seen.elevation, seen.parallel), (90.0, 0.0, true));
    }
}

#[test]
fn the_section_is_in_the_menu_of_viewpoints_and_another_side_leaves_it() {
    let mut window = whole(Lang::En);
    window.harness.get_all_by_label(en::CANVAS.look_menu).next().expect("the world's").click();
    window.run();
    window.click(en::CANVAS.section);
    assert!(window.state().model.desk.shown.figure().world.section);
    window.key(Key::Escape);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::Num1);
    window.run();
    let figure = window.state().model.desk.shown.figure();
    assert!(!figure.world.section && figure.observers.world.is_some());
    window.harness.key_press_modifiers(Modifiers::ALT, Key::Num8);
    window.run();
    window.harness.key_press_modifiers(Modifiers::ALT, Key::Num0);
    window.run();
    assert!(window.state().model.desk.shown.figure().world.section, "fitting is no other side");
}

#[test]
fn a_framed_view_is_framed_again_at_another_size_and_a_turned_one_stays() {
    let mut window = whole(Lang::En);
    let seen = |window: &Window| window.state().model.desk.shown.figure().observers.world.expect("an observer");
    window.harness.key_press_modifiers(Modifiers::ALT, Key::Num5);
    window.run();
    let framed = seen(&window);
    window.key(Key::F11);
    window.run();
    let again = seen(&window);
    assert_ne!(framed.distance, again.distance);
    assert_eq!((framed.azimuth, framed.elevation, framed.roll), (again.azimuth, again.elevation, again.roll));
    assert!(!window.state().model.desk.shown.is_changed());
    window.key(Key::F11);
    window.run();
    assert!((seen(&window).distance / framed.distance - 1.0).abs() < 1e-9, "and back");
    let turned = camera_lab::figure::Observer { azimuth: framed.azimuth + 7.0, ..seen(&window) };
    window.app_mut().state.model.desk.shown.observers_mut().world = Some(turned);
    window.run();
    window.key(Key::F11);
    window.run();
    assert_eq!(seen(&window), turned);
}

#[test]
fn redo_with_nothing_to_redo_does_not_undo() {
    let mut window = Window::new(Lang::En);
    window.enter("B", "40");
    window.key(Key::Escape);
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    window.run();
    assert_eq!(window.state().model.desk.shown.figure().camera.far, 40.0);
}

#[test]
fn alt_calls_commands_from_a_field_and_option_writes_into_it() {
    for (os, is_called) in [(OperatingSystem::Nix, true), (OperatingSystem::Mac, false)] {
        let mut window = Window::new(Lang::En);
        window.harness.ctx.set_os(os);
        window.field("B").click();
        window.run();
        window.key_event(Key::M, true, Modifiers::ALT);
        window.harness.event(Event::Text("µ".to_owned()));
        window.run();
        assert_eq!(window.state().model.settings.reduce_motion, is_called, "{os:?}");
    }
}

/// Controls are found by the words that people have for them, and take the keyboard.
#[test]
fn controls_are_found_by_their_names() {
    let mut window = Window::new(Lang::En);
    for (lang, place) in [(Lang::En, 0), (Lang::PtBr, 1)] {
        window.app_mut().state.model.settings.lang = lang;
        window.run();
        let (t, compare, of_predict) = (texts(lang), compare::texts(lang), predict::texts(lang));
        let of_cameras = cameras::texts(lang);
        for (wanted, title, role) in [
            (["shading", "sombreamento"], t.shading, Some(Role::ComboBox)),
            (["Gouraud", "gouraud"], t.shading, Some(Role::ComboBox)),
            (["predict", "prever"], of_predict.switch, Some(Role::CheckBox)),
            (["stereo pair", "par estéreo"], of_cameras.pair, Some(Role::Button)),
            (["keep in the figure", "guardar na figura"], t.keep_operation, None),
            (["compare cameras", "comparar câmeras"], compare.command, None),
            (["photograph", "fotografia"], photograph::texts(lang).photograph, None),
            (["samples", "amostras"], t.antialias, None),
        ] {
            window.command_key(Key::F);
            window.harness.event(Event::Text(wanted[place].to_owned()));
            window.run();
            let kinds = [search::texts(lang).control, search::texts(lang).command];
            let found =
                kinds.map(|kind| window.harness.query_by_label(&format!("{title}, {kind}")).map(|row| row.rect()));
            let above = found.into_iter().flatten().next().expect(wanted[place]);
            let rows = window
                .harness
                .get_all(By::new().predicate(|node| node.label().is_some_and(|label| label.contains(", "))));
            let higher = rows.filter(|row| row.rect().top() < above.top() && row.rect().left() == above.left()).count();
            assert!(higher < 2, "{wanted:?}: {higher} before it");
            window.key(if role.is_some() { Key::Enter } else { Key::Escape });
            if let Some(role) = role {
                window.run();
                assert!(window.harness.get_by_role_and_label(role, title).is_focused(), "{wanted:?}");
            }
        }
    }
}
