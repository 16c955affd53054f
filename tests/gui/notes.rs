//! The tab of notes: searched, read, left by links. F1 on a thing opens the note on it.

use camera_lab::figure::Explanation;
use camera_lab::figure::NamedPoint;
use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab::scene::{ObjectSpec, Shape};
use camera_lab_desk::layout::{Side, Tab};
use camera_lab_desk::scene_tree::Selected;
use camera_lab_words::Lang;
use camera_lab_words::why::explain::texts;
use camera_lab_words::why::notes::note;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, Pos2};
use egui_kittest::kittest::{NodeT, Queryable};
use glam::DVec3;

use super::window::Window;

fn reading(lang: Lang) -> Window {
    let mut window = Window::new(lang);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::E);
    window.run();
    window.app_mut().state.model.explained.show(Explanation::Notes);
    window.run();
    window
}

fn chosen(window: &Window) -> &'static str {
    window.state().explain.notes.chosen
}

/// The note that is shown, with the side of explanations and its tab.
fn shown(window: &Window) -> Option<&'static str> {
    let state = window.state();
    let is_shown =
        state.model.settings.panels().is_shown(Side::Explain) && state.model.explained.shown() == Explanation::Notes;
    is_shown.then_some(state.explain.notes.chosen)
}

fn is_guide_open(window: &Window) -> bool {
    matches!(window.state().file_flow.dialog, Some(Dialog::Help))
}

fn focused(window: &Window) -> Option<String> {
    let node = window.harness.query_by(|node| node.is_focused())?;
    node.accesskit_node().label()
}

fn title(lang: Lang, id: &str) -> &'static str {
    note(lang, id).expect("a note").title
}

fn point_at(window: &mut Window, at: Pos2) {
    window.harness.hover_at(at);
    window.run();
}

#[test]
fn words_are_searched_and_enter_reads_the_first_note_that_has_them() {
    for (lang, words, id) in [(Lang::PtBr, "REJEICAO", "stage-cull-objects"), (Lang::En, "(5.22)", "5.22")] {
        let mut window = reading(lang);
        let heads = |window: &Window| window.harness.query_all_by_label(title(lang, "5.25")).count();
        assert_eq!(heads(&window), 1, "without words, all notes are in the list");
        let t = texts(lang);
        window.harness.get_by(|node| node.label().as_deref() == Some(t.search_notes)).focus();
        window.run();
        window.harness.event(Event::Text(words.to_owned()));
        window.run();
        assert_eq!(heads(&window), 0);
        window.key(Key::Enter);
        assert_eq!(chosen(&window), id);
        assert_eq!(focused(&window).as_deref(), Some(title(lang, id)), "it has the keyboard");
        // The list and the heading.
        assert_eq!(window.harness.query_all_by_label(title(lang, id)).count(), 2);
    }
}

#[test]
fn a_note_says_its_equation_its_number_here_and_its_errata() {
    let mut window = reading(Lang::En);
    window.app_mut().state.explain.notes.chosen = "H";
    window.run();
    for said in ["H = 2F tan(θ/2)", "[0] (5.5)"] {
        assert!(window.harness.query_by_label(said).is_some(), "{said}");
    }
    let height = window.state().model.desk.shown.camera().window_height();
    let said = camera_lab::numbers::DecimalMark::Point.number(height, window.state().model.settings.digits);
    assert!(window.harness.query_all_by_label_contains(&said).next().is_some(), "{said}");
    window.app_mut().state.explain.notes.chosen = "5.11";
    window.run();
    assert!(window.harness.query_by_label("2n/(r − l)").is_some(), "what is printed in [0]");
    assert!(window.harness.query_by_label("≠").or(window.harness.query_by_label("≠ ")).is_some());
}

#[test]
fn links_lead_from_note_to_note_and_back() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut window = reading(lang);
        window.app_mut().state.explain.notes.chosen = "5.17";
        window.run();
        let link = window
            .harness
            .get_by(|node| node.role() == Role::Link && node.label().as_deref() == Some(title(lang, "ray")));
        link.focus();
        window.run();
        window.key(Key::Enter);
        assert_eq!(chosen(&window), "ray");
        assert_eq!(focused(&window).as_deref(), Some(title(lang, "ray")));
        window.click(texts(lang).note_before);
        assert_eq!(chosen(&window), "5.17");
    }
}

#[test]
fn arrows_go_through_the_list_and_read_note_by_note() {
    let mut window = reading(Lang::En);
    window.app_mut().state.explain.notes.chosen = "C";
    window
        .harness
        .get_by(|node| node.label().as_deref() == Some(title(Lang::En, "C")) && node.role() == Role::Button)
        .focus();
    window.run();
    assert_eq!(focused(&window).as_deref(), Some(title(Lang::En, "C")));
    window.key(Key::ArrowDown);
    assert_eq!(focused(&window).as_deref(), Some(title(Lang::En, "PF")));
    assert_eq!(chosen(&window), "PF");
    window.key(Key::ArrowDown);
    assert_eq!(chosen(&window), "VUP");
}

#[test]
fn f1_opens_the_note_on_a_parameter_with_the_keyboard_or_under_the_pointer() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut window = Window::new(lang);
        let field =
            window.harness.get_by(|node| node.role() == Role::SpinButton && node.label().as_deref() == Some("F"));
        let place = field.rect().center();
        field.focus();
        window.run();
        window.key(Key::F1);
        assert_eq!(shown(&window), Some("F"));
        assert!(!is_guide_open(&window));
        assert_eq!(focused(&window).as_deref(), Some(title(lang, "F")), "read on by keyboard");
        // Nothing is pointed at, and the list is none of the things: the guide.
        window.key(Key::F1);
        assert!(is_guide_open(&window));
        window.key(Key::Escape);
        window.app_mut().state.explain.notes.chosen = "C";
        point_at(&mut window, place);
        window.key(Key::F1);
        assert_eq!(shown(&window), Some("F"), "under the pointer");
    }
}

#[test]
fn f1_opens_the_note_on_a_matrix_from_its_heading() {
    let mut window = Window::new(Lang::En);
    let heading = window.harness.get_all_by_label_contains("(5.7)").next().expect("the heading of M_v").rect().center();
    point_at(&mut window, heading);
    window.key(Key::F1);
    assert_eq!(shown(&window), Some("M_v"));
}

#[test]
fn f1_opens_the_note_on_an_operation_a_stage_and_the_entry_of_a_matrix() {
    let mut window = Window::new(Lang::PtBr);
    window.harness.get_by_label("Guinada +").focus();
    window.run();
    window.key(Key::F1);
    assert_eq!(shown(&window), Some("yaw"));
    assert!(window.harness.query_by_label("≠ ").is_some() || window.harness.query_by_label("≠").is_some());

    window.app_mut().state.model.layout.strip = true;
    window.run();
    let stage = window
        .harness
        .get_by(|node| node.role() == Role::ListItem && node.label().is_some_and(|label| label.starts_with("recorte")));
    let place = stage.rect().center();
    point_at(&mut window, place);
    window.key(Key::F1);
    assert_eq!(shown(&window), Some("stage-clip"));
    // The note names the file in which the stage can be read.
    window.harness.get_by_label_contains(&camera_lab::stage::Stage::Clip.source());
    point_at(&mut window, Pos2::ZERO);

    window.app_mut().state.model.explained.show(Explanation::Matrices);
    window.run();
    window.harness.get_by_label_contains("M_p, linha 3, coluna 3").focus();
    window.run();
    window.key(Key::F1);
    assert_eq!(shown(&window), Some("5.14"), "the equation in force");
}

#[test]
fn f1_opens_notes_on_the_other_tabs_of_explanations() {
    let mut window = Window::new(Lang::En);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::E);
    window.run();
    let mut ask = |tab, role, label: &str, note: &str| {
        window.app_mut().state.model.explained.show(tab);
        window.run();
        window.harness.get_by_role_and_label(role, label).focus();
        window.run();
        window.key(Key::F1);
        assert_eq!(shown(&window), Some(note), "{label}");
    };
    let t = camera_lab_words::why::homogeneous::texts(Lang::En);
    ask(Explanation::Homogeneous, Role::Slider, t.share, "5.6");
    ask(Explanation::Homogeneous, Role::CheckBox, t.vanishing, "ideal-point");
    ask(Explanation::Homogeneous, Role::DisclosureTriangle, t.plane_title, "w");
    ask(Explanation::Order, Role::Button, "Step 2: R_y", "rotation");
    ask(Explanation::Order, Role::SpinButton, "S y", "scale");
    ask(Explanation::Dialects, Role::SpinButton, "gluPerspective fovy", "theta");
    ask(Explanation::Dialects, Role::SpinButton, "gluLookAt eyeX", "C");
    ask(Explanation::Dialects, Role::DisclosureTriangle, "K [R | t]: computer vision", "K");
    ask(Explanation::Dialects, Role::MultilineTextInput, "A matrix → its camera", "inverse");
}

#[test]
fn f1_opens_the_note_on_the_fields_of_an_object_and_of_a_point() {
    let mut window = Window::new(Lang::PtBr);
    let object = ObjectSpec::new("caixa", Shape::Box);
    let point = NamedPoint { name: "A".to_owned(), position: DVec3::ONE };
    let state = &mut window.app_mut().state;
    state.model.desk.shown.edit(|figure| (figure.scene.objects, figure.points) = (vec![object], vec![point]));
    state.model.tree.select(Some(Selected::Object("caixa".to_owned())));
    state.model.settings.tab = Tab::Scene;
    window.run();
    let t = camera_lab_words::window::scenes::texts(Lang::PtBr);
    for (name, note) in [(t.translate, "translation"), (t.rotate, "rotation"), (t.scale, "scale")] {
        window.field(&format!("{name} z")).focus();
        window.run();
        window.key(Key::F1);
        assert_eq!(shown(&window), Some(note));
    }
    window.app_mut().state.model.explained.show(Explanation::Point);
    window.run();
    window.field("NDC z_n").focus();
    window.run();
    window.key(Key::F1);
    assert_eq!(shown(&window), Some("ndc"));
}

#[test]
fn f1_opens_the_guide_if_nothing_is_under_the_pointer() {
    let mut window = Window::new(Lang::En);
    window.key(Key::F1);
    assert!(is_guide_open(&window));
    assert_eq!(shown(&window), None);
}
