//! Dialogs: their lists, their focus, and their questions.

use std::fs;

use camera_lab::appearance::Theme;
use camera_lab::export::format::PictureFormat;
use camera_lab::gui::app::file_flow::questions::{Dialog, Purpose};
use camera_lab::views::{View, Views};
use camera_lab_words::Lang;
use camera_lab_words::learn::handouts;
use eframe::egui::accesskit::Role;
use eframe::egui::{ColorImage, Event, Key, Modifiers, OutputCommand, PointerButton, Pos2, TextureId};
use egui_kittest::kittest::{NodeT as _, Queryable};

use super::files::Folder;
use super::window::Window;
use crate::words::en;

impl Window {
    /// Presses and lets go within one frame, as it happens when frames take long.
    pub(crate) fn quick_click(&mut self, at: Pos2) {
        self.harness.hover_at(at);
        self.run();
        for pressed in [true, false] {
            let button = PointerButton::Primary;
            let event = Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE };
            self.harness.input_mut().events.push(event);
        }
        self.run();
    }

    /// Chooses from a list by two quick clicks.
    fn quick_choice(&mut self, list: &str, entry: &str) {
        // The dialog has buttons of its own, and some are called as entries of the list.
        let count = |window: &Self| window.harness.query_all_by_role_and_label(Role::Button, entry).count();
        let before = count(self);
        // A preview that arrives meanwhile may move the list from under the pointer.
        for _ in 0..5 {
            let at = self.harness.get_by_role_and_label(Role::ComboBox, list).rect().center();
            self.quick_click(at);
            if count(self) > before {
                break;
            }
        }
        let entries = self.harness.query_all_by_role_and_label(Role::Button, entry);
        let at = entries.last().expect("the entry").rect().center();
        self.quick_click(at);
    }

    fn export(&self) -> camera_lab::gui::export::Export {
        match &self.state().file_flow.dialog {
            Some(Dialog::Export(export)) => *export,
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn lists_of_the_export_dialog_open_before_it_every_time() {
    let mut window = Window::new(Lang::En);
    let views = [("World", View::World), ("Canonical volume", View::Canonical), ("Image", View::Image)];
    let themes = [("light", Theme::Light), ("dark", Theme::Dark), ("print", Theme::Print)];
    for opening in 0..5 {
        window.command_key(Key::E);
        let (name, view) = views[opening % 3];
        window.quick_choice(en::WINDOW.export_what, name);
        assert_eq!(window.export().what, Views::One(view), "opening {opening}");
        let times = ["3 ×", "4 ×"][opening % 2];
        window.quick_choice("size", times);
        assert_eq!(window.export().times, Some(if opening % 2 == 0 { 3 } else { 4 }), "opening {opening}");
        let (name, theme) = themes[opening % 2];
        window.quick_choice("theme", name);
        assert_eq!(window.export().theme, theme, "opening {opening}");
        window.key(Key::Escape);
        assert_eq!(window.state().file_flow.dialog, None);
    }
}

/// The picture in the export dialog and its size, once it is another one than `before`.
fn preview(window: &mut Window, before: Option<TextureId>) -> (TextureId, [usize; 2]) {
    window.wait_until(|window| {
        let texture = window.state().file_flow.preview.as_ref()?.texture.as_ref()?;
        (before != Some(texture.id())).then(|| (texture.id(), texture.size()))
    })
}

#[test]
fn the_export_dialog_shows_the_picture_as_it_will_be() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::E);
    window.quick_choice(en::WINDOW.export_what, "Image");
    window.quick_choice("size", "typed");
    // Not larger than it will be, and nothing is enlarged.
    window.enter(en::WINDOW.export_width, "320");
    window.enter(en::WINDOW.export_height, "200");
    let mut shown = preview(&mut window, None);
    while shown.1 != [320, 200] {
        shown = preview(&mut window, Some(shown.0));
    }
    let pixels = |window: &Window| window.pixels([320, 200]);
    let print = pixels(&window);
    assert!(print.chunks_exact(4).all(|pixel| pixel[3] == 255));
    window.quick_choice("theme", "dark");
    let dark = preview(&mut window, Some(shown.0));
    assert_eq!(dark.1, [320, 200]);
    assert_ne!(pixels(&window), print);
    window.click(en::WINDOW.export_transparent);
    let clear = preview(&mut window, Some(dark.0));
    assert_eq!(pixels(&window)[3], 0, "transparent at the corner");
    // A large one is shown with its proportions.
    window.enter(en::WINDOW.export_width, "3000");
    let wide = preview(&mut window, Some(clear.0));
    assert_eq!(wide.1, [360, 24]);
    // An impossible export has no picture, but a reason.
    window.enter(en::WINDOW.export_height, "16384");
    window.enter(en::WINDOW.export_width, "16384");
    window.wait_for("not enough memory for an image");
    window.key(Key::Escape);
    assert!(window.state().file_flow.preview.is_none(), "nothing is kept of it");
}

#[test]
fn a_picture_is_copied_at_its_full_size() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::E);
    window.quick_choice(en::WINDOW.export_what, "Image");
    window.quick_choice("size", "typed");
    window.enter(en::WINDOW.export_width, "900");
    window.enter(en::WINDOW.export_height, "600");
    window.harness.get_by_label(en::WINDOW.export_copy).click();
    let copied = |window: &Window| -> Option<ColorImage> {
        window.harness.output().platform_output.commands.iter().find_map(|command| match command {
            OutputCommand::CopyImage(image) => Some(image.clone()),
            _ => None,
        })
    };
    let image = window.wait_until(copied);
    assert_eq!(image.size, [900, 600]);
    assert!(window.says(en::WINDOW.copied));
    window.enter(en::WINDOW.export_width, "16000");
    window.enter(en::WINDOW.export_height, "4000");
    // The preview says how large it will be.
    window.wait(|window| window.harness.get_by_label(en::WINDOW.export_copy).accesskit_node().is_disabled());
}

#[test]
fn after_a_failed_open_the_field_keeps_the_keyboard_and_says_why() {
    let folder = Folder::new("refused");
    fs::write(folder.file("broken.toml"), "[camera]\nnear = 5\nfar = 2\n").expect("written");
    fs::write(folder.file("good.toml"), "[camera]\nfar = 50.0\n").expect("written");
    let mut window = Window::new(Lang::En);
    window.command_key(Key::O);
    window.choose(&folder.file("broken.toml"));
    assert!(window.harness.get_by_role_and_label(Role::TextInput, "file").is_focused());
    assert!(window.says("near < far"));
    assert!(window.state().model.message.is_none(), "it is said once");
    // The keyboard stays in the same field.
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Text(folder.file("good.toml").display().to_string()));
    window.run();
    window.key(Key::Enter);
    assert_eq!(window.state().model.desk.shown.name().as_deref(), Some("good.toml"));
    // The next dialog knows nothing of it.
    window.command_key(Key::O);
    assert!(!window.says("near < far"));
}

#[test]
fn the_file_dialog_does_not_repeat_errors_from_elsewhere() {
    let mut window = Window::new(Lang::En);
    let error = camera_lab::camera::CameraError::ViewUpZero;
    window.app_mut().state.model.say(camera_lab_desk::message::Message::Camera(error));
    window.run();
    let said = window.state().model.message.as_ref().expect("a message").text(Lang::En);
    let times = |window: &Window| window.harness.query_all_by_label_contains(&said).count();
    assert_eq!(times(&window), 1);
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.run();
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Path(..))));
    assert_eq!(times(&window), 1, "in its bar, and there alone");
}

#[test]
fn enter_exports_also_after_a_checkbox_was_clicked_or_walked_to() {
    let mut window = Window::new(Lang::En);
    let asked = |window: &Window| match &window.state().file_flow.dialog {
        Some(Dialog::Path(Purpose::Export(export), _)) => Some(*export),
        _ => None,
    };
    window.command_key(Key::E);
    let at = window.harness.get_by_label(en::WINDOW.export_crop).rect().center();
    window.quick_click(at);
    assert!(window.export().crop);
    window.key(Key::Enter);
    assert!(asked(&window).expect("it goes on to the name").crop, "and the switch is as it was set");
    window.key(Key::Escape);

    // By the keyboard alone: the space bar switches.
    window.command_key(Key::E);
    window.harness.get_by_label(en::WINDOW.export_crop).focus();
    window.run();
    window.key(Key::Space);
    assert!(!window.export().crop);
    window.key(Key::Enter);
    assert!(!asked(&window).expect("it goes on to the name").crop);
    window.key(Key::Escape);

    // In a field Enter takes the typed value, and the next one exports.
    window.command_key(Key::E);
    window.quick_choice("size", "typed");
    window.enter(en::WINDOW.export_width, "333");
    assert_eq!((asked(&window), window.export().width), (None, 333));
    window.key(Key::Enter);
    assert_eq!(asked(&window).expect("it goes on to the name").width, 333);
}

/// Key, format, width with Enter: the path is asked for. The next time it's one click less.
#[test]
fn a_picture_for_paper_is_exported_by_its_width() {
    let mut window = Window::new(Lang::En);
    for (width, opens) in [("8", true), ("5.5", false)] {
        window.command_key(Key::E);
        if opens {
            window.click(PictureFormat::Pdf.name());
        }
        window.harness.event(Event::Text(width.to_owned()));
        window.run();
        window.key(Key::Enter);
        let Some(Dialog::Path(Purpose::Export(export), path)) = &window.state().file_flow.dialog else {
            panic!("{:?}", window.state().file_flow.dialog)
        };
        assert_eq!((export.format, export.on_paper), (PictureFormat::Pdf, true));
        assert_eq!(export.paper.size[0].to_string(), width);
        assert!(path.ends_with(".pdf"), "{path}");
        window.key(Key::Escape);
    }
    // An impossible width is named, and the window asks nothing.
    window.command_key(Key::E);
    window.harness.event(Event::Text("0".to_owned()));
    window.run();
    window.key(Key::Enter);
    assert!(window.says(en::WINDOW.export_heading) && window.says(en::WINDOW.export_width_cm));
}

#[test]
fn a_format_without_transparency_greys_it_and_a_name_that_says_so_is_refused() {
    let folder = Folder::new("opaque");
    let mut window = Window::new(Lang::En);
    window.command_key(Key::E);
    window.quick_choice(en::WINDOW.export_what, "Image");
    window.click(en::WINDOW.export_transparent);
    let greyed =
        |window: &Window| window.harness.get_by_label(en::WINDOW.export_transparent).accesskit_node().is_disabled();
    assert!(window.export().is_without_ground() && !greyed(&window));
    window.click(PictureFormat::Jpeg.name());
    assert!(!window.export().is_without_ground() && greyed(&window));
    window.click(PictureFormat::WebP.name());
    assert!(window.export().is_without_ground() && !greyed(&window), "nothing is forgotten");
    window.key(Key::Enter);
    assert!(matches!(&window.state().file_flow.dialog, Some(Dialog::Path(_, path)) if path.ends_with(".webp")));
    let file = folder.file("a.jpg");
    window.choose(&file);
    assert!(window.says("JPEG has no transparency. Choose a name that ends in .png, .webp, .svg or .pdf"));
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Path(..))), "another name can be typed");
    assert!(!file.exists());
}

#[test]
fn on_paper_lines_have_their_own_width_and_too_little_room_shows() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::E);
    window.quick_choice(en::WINDOW.export_what, en::WINDOW.export_all);
    window.quick_choice("size", "on paper");
    window.wait_for("the smallest image is 3.5 × 2.9 cm");
    let lines = |window: &Window| window.export().paper.lines;
    assert_eq!(lines(&window), None);
    assert!(window.field(en::WINDOW.export_lines).accesskit_node().is_disabled());
    window.click(en::WINDOW.export_lines_own);
    // Nothing jumps: it begins with the width that they have.
    assert_eq!(lines(&window), Some(0.64));
    window.enter(en::WINDOW.export_lines, "1.25");
    assert_eq!(lines(&window), Some(1.25));
    window.enter(en::WINDOW.export_height_cm, "12");
    window.type_into(en::WINDOW.export_width_cm, "16");
    window.key(Key::Tab);
    window.wait_until(|window| (!window.says("the smallest image")).then_some(()));
}

#[test]
fn a_family_is_chosen_typed_and_written_from_the_menu() {
    let folder = Folder::new("family");
    let mut window = Window::new(Lang::En);
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::E);
    window.run();
    let family = |window: &Window| window.state().family.clone();
    let type_values = |window: &mut Window, text: &str| {
        window.harness.get_by_role_and_label(Role::TextInput, "values").click();
        window.run();
        window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        window.harness.event(Event::Text(text.to_owned()));
        window.run();
        window.key(Key::Tab);
    };
    assert_eq!(family(&window).first.values, "20, 40, 60, 90", "it begins with the view angle");
    window.click_in_dialog(en::WINDOW.azimuth);
    assert_eq!(family(&window).first.values, "0, 90, 180, 270");
    // In multiples of the screen, the dialog shows the size of the whole sheet.
    window.quick_choice(en::WINDOW.export_what, "World");
    window.quick_choice("size", "1 ×");
    let [width, height] = window.wait_until(|window| {
        let size = window.state().file_flow.preview.as_ref()?.size;
        size.filter(|[width, _]| (2 * window.export().width..3000).contains(width))
    });
    window.run();
    assert!(window.says(&format!("{width} × {height}")));
    window.quick_choice("in each row", "projection");
    assert_eq!(family(&window).second.values, "perspective, parallel");
    assert!(family(&window).variations().is_some_and(|both| both.is_ok_and(|both| both.len() == 2)));
    window.quick_choice("in each row", "nothing");
    type_values(&mut window, "0, 200, x");
    window.wait_for("azimuth = x");
    type_values(&mut window, "0..90:4");
    window.quick_choice("columns", "2");
    assert_eq!((family(&window).columns, family(&window).parts), (Some(2), true), "a text names the parts");
    window.quick_choice(en::WINDOW.export_what, "World");
    window.quick_choice("size", "on paper");
    window.quick_choice("made for", "A4 text, 16 cm");
    assert_eq!(window.export().paper.size, [16.0, 12.0]);
    window.click(PictureFormat::Svg.name());
    window.key(Key::Enter);
    let file = folder.file("azimuths.svg");
    window.choose(&file);
    window.wait_for("azimuths.svg");
    window.wait(|_| file.exists());
    let svg = fs::read_to_string(&file).expect("text");
    for caption in ["(a) Azimuth 0°", "(b) Azimuth 30°", "(c) Azimuth 60°", "(d) Azimuth 90°"] {
        assert!(svg.contains(caption), "{caption}");
    }
    // Without a wish for a family there is none. The wish is remembered.
    window.command_key(Key::E);
    assert!(family(&window).variations().is_none());
    assert_eq!(window.export().what, Views::One(View::World), "as it was left");
    window.key(Key::Escape);
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::E);
    window.run();
    assert_eq!(family(&window).first.values, "0..90:4");
}

#[test]
fn impossible_paper_sizes_name_their_field_and_range() {
    let on_paper = || {
        let mut window = Window::new(Lang::En);
        window.command_key(Key::E);
        window.quick_choice("size", "on paper");
        window
    };
    for (field, wild, range) in [
        ("letters in points", "1e9", "letters in points: must be between 0.5 and 1000"),
        ("pixels per inch", "1e-9", "pixels per inch: must be between 1 and 10000"),
        ("width in centimetres", "1e-9", "width in centimetres: must be between 0.1 and 1000"),
    ] {
        let mut window = on_paper();
        window.enter(field, wild);
        assert!(window.says(range), "{field}");
        window.click(en::WINDOW.export_action);
        assert!(window.says(en::WINDOW.export_heading), "the question stands");
    }
    // Both in their range, and less than a pixel together.
    let mut window = on_paper();
    for (field, value) in [("pixels per inch", "1"), ("width in centimetres", "0.1")] {
        window.enter(field, value);
    }
    assert!(window.says("pixels: must be between 1 and 16384"));
    window.click(en::WINDOW.export_action);
    assert!(window.says(en::WINDOW.export_heading), "the question stands");
}

#[test]
fn the_export_dialog_has_the_rows_that_its_choices_need() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::E);
    let typed = |window: &Window, name: &str| window.harness.query_by_role_and_label(Role::SpinButton, name).is_some();
    for (size, on_paper, pixels) in [("2 ×", false, false), ("on paper", true, false), ("typed", false, true)] {
        window.quick_choice("size", size);
        window.run();
        assert_eq!(window.says(en::WINDOW.export_letters), on_paper, "{size}");
        assert_eq!(typed(&window, en::WINDOW.export_width), pixels, "{size}");
        assert!(!window.says(en::FAMILIES.captions), "nothing varies");
    }
}

#[test]
fn the_export_dialog_proposes_the_shown_view_and_forgets_families() {
    let mut window = Window::new(Lang::En);
    let proposed = |window: &mut Window| {
        window.command_key(Key::E);
        let (what, family) = (window.export().what, window.state().family.variations());
        assert_eq!(family, None, "a family is not asked for");
        window.key(Key::Escape);
        what
    };
    assert_eq!(proposed(&mut window), Views::One(View::Image));
    window.app_mut().state.model.layout.maximized = None;
    assert_eq!(proposed(&mut window), Views::All);
    window.command_key(Key::Num2);
    assert_eq!(proposed(&mut window), Views::Without(View::Canonical));
    window.command_key(Key::Num1);
    assert_eq!(proposed(&mut window), Views::One(View::Image));
    for by_key in [true, false] {
        window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::E);
        window.run();
        assert!(window.state().family.variations().is_some());
        if by_key {
            window.key(Key::Escape);
        } else {
            window.click(en::WINDOW.cancel);
        }
        assert_eq!(window.state().family.variations(), None);
        assert_eq!(proposed(&mut window), Views::One(View::Image));
    }
}

#[test]
fn vectors_have_settings_of_their_own_and_are_copied_as_text() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::E);
    window.quick_choice(en::WINDOW.export_what, "World");
    assert!(!window.says(en::WINDOW.export_outlines), "a PNG has none");
    window.click(PictureFormat::Svg.name());
    window.click(en::WINDOW.export_outlines);
    window.harness.get_by_label(en::WINDOW.export_copy).click();
    let copied = |window: &Window| -> Option<String> {
        window.harness.output().platform_output.commands.iter().find_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        })
    };
    let text = window.wait_until(copied);
    assert!(text.starts_with("<svg") && text.contains("aria-label=\"VUP\"") && !text.contains("<text"));
}

#[test]
fn a_dialog_of_the_system_holds_the_window_back() {
    let t = camera_lab_words::window::texts(Lang::En);
    let mut window = Window::new(Lang::En);
    window.app_mut().state.file_flow.native = true;
    window.command_key(Key::O);
    assert!(window.says(t.choosing_title) && window.state().file_flow.is_asking());
    let before = window.state().model.desk.shown.figure().clone();
    for key in [Key::G, Key::N, Key::PageDown, Key::E] {
        window.command_key(key);
        assert!(window.state().file_flow.dialog.is_none(), "{key:?}");
    }
    assert_eq!(window.state().model.desk.shown.figure(), &before);
    window.click(t.cancel);
    assert!(!window.state().file_flow.is_asking());
    window.command_key(Key::G);
    assert!(window.state().file_flow.dialog.is_some());
}

/// The pages of a lesson are shown, turned and written as PDF.
#[test]
fn a_lesson_and_exercises_are_printed() {
    let folder = Folder::new("print");
    let t = handouts::texts(Lang::En);
    let mut window = Window::new(Lang::En);
    window.command_key(Key::P);
    let page = |number: usize| format!("{} {number} {}", t.page, t.of);
    window.wait(|window| window.state().file_flow.pages.as_ref().is_some_and(|pages| pages.count > 2));
    assert!(window.says(&page(1)));
    window.click(t.page_after);
    assert!(window.says(&page(2)));
    // Exercises have pages of their own.
    window.click(t.of_exercises);
    window.wait(|window| window.state().file_flow.pages.as_ref().is_some_and(|pages| pages.count == 1));
    window.click(t.answers);
    window.wait(|window| window.state().file_flow.pages.as_ref().is_some_and(|pages| pages.count > 1));
    window.click(t.save);
    let path = folder.file("sheet.pdf");
    window.choose(&path);
    window.wait(|_| path.exists());
    assert!(fs::read(&path).expect("written").starts_with(b"%PDF"));
}

#[test]
fn a_code_without_an_address_asks_for_one_and_a_link_does_not() {
    let mut window = Window::new(Lang::En);
    let t = camera_lab_words::window::sharing::texts(Lang::En);
    let shortcut = |window: &mut Window, modifiers| {
        window.harness.key_press_modifiers(modifiers, Key::K);
        window.run();
        window.says(t.address_first)
    };
    assert!(!shortcut(&mut window, Modifiers::COMMAND));
    window.key(Key::Escape);
    assert!(shortcut(&mut window, Modifiers::COMMAND | Modifiers::SHIFT));
    // The field has the keyboard.
    window.harness.event(Event::Text("https://example.org/".to_owned()));
    window.run();
    assert!(!window.says(t.address_first));
    assert_eq!(window.state().sharing.page_address, "https://example.org/");
    window.click(t.code);
    assert!(window.says(t.code));
}

/// A click beside a form does nothing, Esc closes it, and it opens again as it was.
#[test]
fn forms_keep_typed_and_chosen_values() {
    let mut window = Window::new(Lang::En);
    // The address of a link is no part of its dialog: all links begin with it.
    let shown =
        |window: &Window| (window.state().file_flow.dialog.clone(), window.state().sharing.page_address.clone());
    let (t, words) = (en::WINDOW, handouts::texts(Lang::En));
    let title = format!("{}, {}", t.title_name, Lang::En.name());
    type Change = Box<dyn Fn(&mut Window)>;
    let typed = |field: &str, text: &str| -> Change {
        let (field, text) = (field.to_owned(), text.to_owned());
        Box::new(move |window| {
            window.harness.get_by_role_and_label(Role::TextInput, &field).focus();
            window.run();
            window.harness.event(Event::Text(text.clone()));
            window.run();
        })
    };
    let with_shift = Modifiers::COMMAND | Modifiers::SHIFT;
    let address = camera_lab_words::window::sharing::texts(Lang::En).address;
    let forms: [(Key, Modifiers, Change); 7] = [
        (Key::I, Modifiers::COMMAND, typed(&title, "A title")),
        (Key::E, Modifiers::COMMAND, Box::new(|window| window.click_in_dialog(t.export_crop))),
        (Key::P, Modifiers::COMMAND, Box::new(|window| window.click_in_dialog(words.answers))),
        (Key::K, Modifiers::ALT, Box::new(|window| window.enter(words.numbers, "7"))),
        (Key::O, Modifiers::COMMAND, typed(t.path_name, "folder/mine.toml")),
        (Key::S, with_shift, typed(t.path_name, "yours")),
        (Key::K, Modifiers::COMMAND, typed(address, "https://example.org/lab/")),
    ];
    for (key, modifiers, change) in forms {
        let open = |window: &mut Window| {
            window.harness.key_press_modifiers(modifiers, key);
            window.run();
        };
        open(&mut window);
        let first = shown(&window);
        change(&mut window);
        let changed = shown(&window);
        assert!(changed.0.is_some() && changed != first, "{key:?}: {first:?}");
        window.quick_click(Pos2::new(3.0, 400.0));
        assert_eq!(shown(&window), changed, "{key:?}: a click beside it");
        window.key(Key::Escape);
        assert_eq!(shown(&window).0, None, "{key:?}");
        open(&mut window);
        assert_eq!(shown(&window), changed, "{key:?}: opened again");
        window.key(Key::Escape);
    }
    // Another title, and it begins with that one.
    window.app_mut().state.model.desk.shown.edit(|figure| {
        figure.title = Some(camera_lab::figure::Localized::from(["Other".to_owned(), "Outro".to_owned()]));
    });
    window.command_key(Key::I);
    let field = window.harness.get_by_role_and_label(Role::TextInput, &title);
    assert_eq!(field.value().as_deref(), Some("Other"));
}

/// Thirty versions of a sheet are one file with each number at the foot of its pages, and their solutions are another.
#[test]
fn thirty_versions_are_one_file_with_their_solutions_beside_it() {
    let folder = Folder::new("versions");
    let t = handouts::texts(Lang::En);
    let mut window = Window::new(Lang::En);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::K);
    window.run();
    window.click_in_dialog(t.answers);
    window.enter(t.numbers, "1");
    window.enter(t.until, "30");
    window.wait(|window| window.state().file_flow.pages.as_ref().is_some_and(|pages| pages.count >= 30));
    // The preview has the pages of the sheet alone, and the other file is announced.
    assert!(window.state().file_flow.pages.as_ref().is_some_and(|pages| pages.count < 60));
    assert!(window.says(&handouts::versions(Lang::En, 30, 1, 30)) && window.says("exercises-solutions.pdf"));
    window.click(t.save);
    let path = folder.file("sheet.pdf");
    window.choose(&path);
    window.wait(|_| path.exists());
    for path in [path, folder.file("sheet-solutions.pdf")] {
        assert!(fs::read(&path).expect("written").starts_with(b"%PDF"), "{}", path.display());
    }
    // Fewer than one version can't be had, and raising the first number leaves no version behind it.
    window.harness.key_press_modifiers(Modifiers::ALT, Key::K);
    window.run();
    let Some(Dialog::Handout(form)) = &window.state().file_flow.dialog else { panic!("no sheet") };
    assert_eq!(form.seeds, [1, 30], "they are kept");
    window.enter(t.numbers, "40");
    let Some(Dialog::Handout(form)) = &window.state().file_flow.dialog else { panic!("no sheet") };
    assert_eq!(form.seeds, [40, 40]);
}

/// A sheet begins with an exercise that has its numbers, and says which ones are the same for everybody.
#[test]
fn a_new_sheet_ticks_an_exercise_that_has_its_numbers() {
    let mut window = Window::new(Lang::En);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::K);
    window.run();
    let words = handouts::texts(Lang::En);
    let Some(Dialog::Handout(form)) = &window.state().file_flow.dialog else { panic!("no sheet") };
    let ticked: Vec<_> = form.exercises.iter().filter_map(|id| camera_lab::exercises::entry(id)).collect();
    assert!(ticked.len() == 1 && ticked[0].is_family, "{ticked:?}");
    assert!(window.says(words.with_numbers) && window.says(words.same_for_all));
}
