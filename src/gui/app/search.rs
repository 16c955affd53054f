//! One search for everything in the window: commands, parameters, explanations, matrices, notes, exercises, figures.

use std::borrow::Cow;
use std::sync::Arc;

use eframe::egui::{self, Align, Button, Key, Modifiers, RichText, Role, Ui, WidgetInfo};

use crate::camera::{Descriptor, Freedom, OPERATIONS};
use crate::explain::Matrix;
use crate::figure::{Explanation, KEYS};
use crate::gui::app::file_flow;
use crate::gui::app::file_flow::questions::Dialog;
use crate::gui::app::state::State;
use crate::gui::inspector::operations;
use crate::gui::kit::{Command, Explained, TextField, number_field, theme, written};
use crate::gui::learn::Learn;
use crate::gui::learn::exercises::list;
use crate::gui::why;
use crate::lessons::{OpenLesson, shipped};
use camera_lab_desk::{Intent, Memo, Model, ObserverChange, Side, Tab};
use camera_lab_words::learn::exercises as exercise_words;
use camera_lab_words::why::{explain as explain_words, notes};
use camera_lab_words::window::search::{also_called, folded, has_words};
use camera_lab_words::window::{self, cameras, coach as coach_words, photograph, predict, search as words};
use camera_lab_words::{Lang, told};

/// The width of the dialog.
pub(in crate::gui) const WIDTH: f32 = 620.0;

/// Number of results that are listed.
const MOST: usize = 60;

/// The words of the search, and its results.
#[derive(Clone, Debug, Default)]
pub struct Search {
    /// The typed words.
    pub wanted: String,
    /// The place of the result that Enter opens.
    pub chosen: usize,
    /// The results by the words and the language, as long as it's open. Nothing behind it changes meanwhile.
    results: Memo<(String, Lang), Arc<[SearchEntry]>>,
}

/// The target of a result.
#[derive(Clone, Debug, PartialEq)]
enum SearchTarget {
    Command(Command),
    /// The row of an operation, opened.
    Operation(Freedom),
    /// The camera check.
    CameraCheck,
    /// A field or a list at the left, by its name.
    Parameter(Tab, &'static str),
    /// A control among the operations, by its name.
    AmongOperations(&'static str),
    Explanation(Explanation),
    Matrix(Matrix),
    Note(&'static str),
    Exercise(String),
    Figure(&'static str),
    /// A built-in lesson, by its place, and a step of it.
    Step(usize, usize),
}

/// Something that can be found.
#[derive(Debug)]
struct SearchEntry {
    target: SearchTarget,
    /// The word for its kind.
    kind: &'static str,
    title: Cow<'static, str>,
    /// More of it, in which words are found too.
    about: Cow<'static, str>,
}

/// The parameters: the name of the field, its symbol, and its name in words.
type Parameter = (Tab, &'static str, fn(&window::Texts) -> &'static str);

const PARAMETERS: [Parameter; 11] = [
    (Tab::Camera, "C x", |t| t.position),
    (Tab::Camera, "PF x", |t| t.focal_point),
    (Tab::Camera, "VUP x", |t| t.view_up),
    (Tab::Camera, "θ", |t| t.view_angle),
    (Tab::Camera, "A", |t| t.aspect),
    (Tab::Camera, "F", |t| t.near),
    (Tab::Camera, "B", |t| t.far),
    (Tab::Camera, "", |t| t.perspective),
    (Tab::Camera, "", |t| t.parallel),
    (Tab::Camera, "", |t| t.window),
    (Tab::Camera, "", |t| t.viewport),
];

/// The place of a key of figure files in the window. The name of a section counts for its keys without a row.
type Home = (&'static str, fn(&window::Texts) -> SearchTarget);

const HOMES: &[Home] = &[
    ("title", |_| SearchTarget::Command(Command::Title)),
    ("caption", |_| SearchTarget::Command(Command::Title)),
    ("camera.position", |_| SearchTarget::Parameter(Tab::Camera, "C x")),
    ("camera.focal_point", |_| SearchTarget::Parameter(Tab::Camera, "PF x")),
    ("camera.view_up", |_| SearchTarget::Parameter(Tab::Camera, "VUP x")),
    ("camera.view_angle", |_| SearchTarget::Parameter(Tab::Camera, "θ")),
    ("camera.height", |_| SearchTarget::Parameter(Tab::Camera, "H")),
    ("camera.aspect", |_| SearchTarget::Parameter(Tab::Camera, "A")),
    ("camera.near", |_| SearchTarget::Parameter(Tab::Camera, "F")),
    ("camera.far", |_| SearchTarget::Parameter(Tab::Camera, "B")),
    ("camera", |_| SearchTarget::Parameter(Tab::Camera, "")),
    ("cameras", |t| SearchTarget::Parameter(Tab::Camera, cameras::texts(t.lang).add)),
    ("image.photograph", |t| SearchTarget::Parameter(Tab::Camera, photograph::texts(t.lang).choose_title)),
    ("image.photograph_opacity", |t| SearchTarget::Parameter(Tab::Camera, photograph::texts(t.lang).opacity)),
    ("image", |_| SearchTarget::Parameter(Tab::Camera, "m")),
    ("viewport", |_| SearchTarget::Parameter(Tab::Camera, "")),
    ("scene", |_| SearchTarget::Parameter(Tab::Scene, "")),
    ("points", |_| SearchTarget::Explanation(Explanation::Point)),
    ("style.shading", |t| SearchTarget::Parameter(Tab::Drawing, t.shading)),
    ("style.visibility", |_| SearchTarget::Explanation(Explanation::HiddenSurfaces)),
    ("style.hidden_lines", |t| SearchTarget::Parameter(Tab::Drawing, t.hidden_lines)),
    ("style.antialias", |t| SearchTarget::Parameter(Tab::Drawing, t.antialias)),
    ("style.vertex_format", |t| SearchTarget::Parameter(Tab::Drawing, t.vertex_format)),
    ("style.subpixel_bits", |t| SearchTarget::Parameter(Tab::Drawing, t.subpixel_bits)),
    ("style.theme", |t| SearchTarget::Parameter(Tab::Drawing, t.file_theme)),
    ("style.depth_format", |_| SearchTarget::Explanation(Explanation::Depth)),
    ("style.order", |_| SearchTarget::Explanation(Explanation::Stages)),
    ("reveal.cost", |_| SearchTarget::Explanation(Explanation::Stages)),
    ("reveal.depth", |_| SearchTarget::Explanation(Explanation::Depth)),
    ("reveal.outside", |_| SearchTarget::Explanation(Explanation::Clipping)),
    ("reveal.clipping", |_| SearchTarget::Explanation(Explanation::Clipping)),
    ("reveal.divide_first", |_| SearchTarget::Explanation(Explanation::Clipping)),
    ("reveal.culled", |_| SearchTarget::Explanation(Explanation::HiddenSurfaces)),
    ("reveal.vanishing", |_| SearchTarget::Explanation(Explanation::Homogeneous)),
    ("reveal.single_precision", |_| SearchTarget::Command(Command::Numerics)),
    ("reveal", |_| SearchTarget::Parameter(Tab::Scene, "")),
    ("world.section", |_| SearchTarget::Command(Command::Section)),
    ("world.dimensions", |_| SearchTarget::Command(Command::Dimensions)),
    ("world.window_opacity", |t| SearchTarget::Parameter(Tab::Drawing, t.window_opacity)),
    ("world.axes_length", |t| SearchTarget::Parameter(Tab::Drawing, t.axes_length)),
    ("world", |_| SearchTarget::Parameter(Tab::Drawing, "")),
    ("observers", |_| SearchTarget::Command(Command::Observe(ObserverChange::Fit))),
    ("show.operation", |t| SearchTarget::AmongOperations(t.keep_operation)),
    ("show.stage", |_| SearchTarget::Explanation(Explanation::Stages)),
    ("show.stage_of", |_| SearchTarget::Explanation(Explanation::Stages)),
    ("show.painted", |_| SearchTarget::Explanation(Explanation::HiddenSurfaces)),
    ("show.step", |_| SearchTarget::Explanation(Explanation::Steps)),
    ("show.triangle", |_| SearchTarget::Explanation(Explanation::Triangle)),
    ("show.probe", |_| SearchTarget::Explanation(Explanation::Point)),
    ("show.moved", |_| SearchTarget::Explanation(Explanation::Order)),
    ("show.ndc", |_| SearchTarget::Explanation(Explanation::Conventions)),
    ("show.answer", |_| SearchTarget::Explanation(Explanation::Exercises)),
    ("show", |_| SearchTarget::Explanation(Explanation::Matrices)),
    ("screen", |_| SearchTarget::Command(Command::Arrange(None))),
    ("compare", |_| SearchTarget::Command(Command::Compare)),
    ("labels", |_| SearchTarget::Command(Command::Labels)),
];

/// The place of a key in the window.
fn home(key: &str, t: &window::Texts) -> Option<SearchTarget> {
    let is_of = |name: &str| key.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
    HOMES.iter().find(|(name, _)| is_of(name)).map(|(_, target)| target(t))
}

/// The keys of figure files. They're names for a file, so they count only once a name like them is typed.
fn keys(lang: Lang, wanted: &str) -> Vec<SearchEntry> {
    if !wanted.contains(['.', '_']) {
        return Vec::new();
    }
    let (kind, t) = (words::texts(lang).key, window::texts(lang));
    KEYS.iter().filter_map(|key| Some(SearchEntry::new(home(key, t)?, kind, key.as_str(), ""))).collect()
}

/// A matrix and its name among the texts of the window.
type NamedMatrix = (Matrix, fn(&window::Texts) -> &'static str);

const MATRICES: [NamedMatrix; 3] = [
    (Matrix::View, |t| t.view_name),
    (Matrix::Projection, |t| t.projection_name),
    (Matrix::ViewProjection, |t| t.product_name),
];

impl SearchEntry {
    fn new(
        target: SearchTarget,
        kind: &'static str,
        title: impl Into<Cow<'static, str>>,
        about: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self { target, kind, title: title.into(), about: about.into() }
    }
}

/// All searchable entries, in the order of equally good results.
fn entries(model: &Model, learn: &Learn) -> Vec<SearchEntry> {
    let lang = model.settings.lang;
    let (t, t_window) = (words::texts(lang), window::texts(lang));
    let mut all = Vec::new();
    for Descriptor { freedom, .. } in &OPERATIONS {
        let [title, about] = operations::words(*freedom, t_window);
        all.push(SearchEntry::new(SearchTarget::Operation(*freedom), t.operation, title, about));
    }
    all.extend(controls(lang));
    let coach = coach_words::texts(lang);
    all.push(SearchEntry::new(SearchTarget::CameraCheck, t.command, coach.coach, coach.coach_hint));
    for (explanation, question, (title, about)) in why::all(explain_words::texts(lang)) {
        all.push(SearchEntry::new(SearchTarget::Explanation(explanation), question, title, about));
    }
    for command in Command::all().filter(|command| *command != Command::Search && command.is_there(model)) {
        let target = SearchTarget::Command(command);
        all.push(SearchEntry::new(target, t.command, command.label(t_window), command.hint(t_window)));
    }
    for (tab, field, name) in PARAMETERS {
        let symbol = field.split(' ').next().unwrap_or_default();
        let title = format!("{symbol} {}", name(t_window)).trim().to_owned();
        all.push(SearchEntry::new(SearchTarget::Parameter(tab, field), t.parameter, title, ""));
    }
    for (matrix, name) in MATRICES {
        let title = format!("{} {}", matrix.text(), name(t_window));
        let about = explain_words::matrix(lang, matrix);
        all.push(SearchEntry::new(SearchTarget::Matrix(matrix), explain_words::texts(lang).matrices, title, about));
    }
    for figure in &camera_lab_files::SHIPPED_FIGURES {
        let [title, about] = figure.told().map(|text| told(lang, &text).to_owned());
        all.push(SearchEntry::new(SearchTarget::Figure(figure.name), t.figure, title, about));
    }
    for (place, shipped) in shipped().iter().enumerate() {
        let lesson = &shipped.lesson;
        let of_lesson = told(lang, &lesson.title);
        let about = lesson.sentence.as_ref().map_or("", |sentence| told(lang, sentence));
        all.push(SearchEntry::new(SearchTarget::Step(place, 0), t.lesson, of_lesson, about));
        for (k, step) in lesson.steps.iter().enumerate() {
            all.push(SearchEntry::new(SearchTarget::Step(place, k), t.step, told(lang, &step.title), of_lesson));
        }
    }
    for note in notes::notes(lang) {
        all.push(SearchEntry::new(SearchTarget::Note(note.id), t.note, note.title, note.searched()));
    }
    for entry in learn.exercises.entries() {
        let target = SearchTarget::Exercise(entry.id.clone().into_owned());
        let about = format!("{} {}", entry.id, entry.source);
        all.push(SearchEntry::new(target, t.exercise, exercise_words::title(lang, entry).to_owned(), about));
    }
    all
}

/// The controls that have names of their own.
fn controls(lang: Lang) -> Vec<SearchEntry> {
    let (t, of_cameras, of_predict) = (window::texts(lang), cameras::texts(lang), predict::texts(lang));
    let of_photograph = photograph::texts(lang);
    let shadings = [t.shading_hint, t.shading_wireframe, t.shading_flat, t.shading_gouraud, t.shading_phong];
    let control = |target, title, about| SearchEntry::new(target, words::texts(lang).control, title, about);
    let drawing = |name, about| control(SearchTarget::Parameter(Tab::Drawing, name), name, about);
    let among_cameras = |name, title, about| control(SearchTarget::Parameter(Tab::Camera, name), title, about);
    let among_operations = |name, about| control(SearchTarget::AmongOperations(name), name, about);
    vec![
        SearchEntry { about: shadings.join(" · ").into(), ..drawing(t.shading, "") },
        drawing(t.hidden_lines, t.hidden_lines_hint),
        drawing(t.antialias, t.antialias_hint),
        drawing(t.window_opacity, t.window_opacity_hint),
        drawing(t.axes_length, t.axes_length_hint),
        among_cameras(of_cameras.add, of_cameras.add, of_cameras.add_hint),
        among_cameras(of_cameras.pair, of_cameras.pair, of_cameras.pair_hint),
        among_cameras(of_photograph.choose_title, of_photograph.photograph, of_photograph.hint),
        among_operations(of_predict.switch, of_predict.switch_hint),
        among_operations(t.keep_operation, t.keep_operation_hint),
    ]
}

/// The results, best first: the word stands in the title of a control as a whole or begins a title, the words are in
/// it, or are elsewhere, and then the same by other names.
fn found(model: &Model, learn: &Learn, wanted: &str) -> Arc<[SearchEntry]> {
    let called = also_called(wanted);
    // The ways of shading are its choices.
    let shading = SearchTarget::Parameter(Tab::Drawing, window::texts(model.settings.lang).shading);
    let rank = |entry: &SearchEntry| {
        let title = folded(&entry.title);
        let whole = format!("{title} {}", folded(&entry.about));
        // The hint of an explanation is about as short as a title, and users look for it first.
        let is_explained = matches!(entry.target, SearchTarget::Explanation(_));
        let is_shading = entry.target == shading;
        let is_control = matches!(entry.target, SearchTarget::Command(_) | SearchTarget::Parameter(..));
        let of_name = |name: &str| match name {
            name if is_control && title.split(|c: char| !c.is_alphanumeric()).any(|word| word == name) => Some(0),
            name if title.starts_with(name) || is_shading && has_words(&whole, name) => Some(0),
            name if has_words(&title, name) || is_explained && has_words(&whole, name) => Some(1),
            name if has_words(&whole, name) => Some(3),
            _ => None,
        };
        let own = called.first().and_then(|name| of_name(name));
        // Another name of a control counts as its title. Others come after titles, but before words elsewhere.
        let others = called.iter().skip(1).filter_map(|name| of_name(name)).min();
        let others = others.map(|rank: usize| if is_control && rank == 0 { 0 } else { rank.max(1) + 1 });
        [own, others].into_iter().flatten().min()
    };
    let all = entries(model, learn).into_iter().chain(keys(model.settings.lang, wanted));
    let mut ranked: Vec<_> = all.filter_map(|entry| Some((rank(&entry)?, entry))).collect();
    ranked.sort_by_key(|(rank, _)| *rank);
    ranked.into_iter().take(MOST).map(|(_, entry)| entry).collect()
}

/// Shows the field and the results. Goes to the chosen one, or returns its command. `first` is true when it has just
/// been opened.
pub(in crate::gui) fn show(ui: &mut Ui, state: &mut State, first: bool) -> Option<Command> {
    state.file_flow.dialog = Some(Dialog::Search);
    let lang = state.model.settings.lang;
    let t = words::texts(lang);
    ui.heading(t.title);
    let State { model, learn, search, .. } = &mut *state;
    let results = search.results.of((search.wanted.clone(), lang), |(wanted, _)| found(model, learn, wanted));
    let results = Arc::clone(results);
    let last = results.len().saturating_sub(1);
    let before = state.search.wanted.clone();
    let (mut chosen, enter) = ui.input_mut(|input| {
        let down = input.count_and_consume_key(Modifiers::NONE, Key::ArrowDown);
        let up = input.count_and_consume_key(Modifiers::NONE, Key::ArrowUp);
        let to = (state.search.chosen + down).min(last).saturating_sub(up);
        (to, input.key_pressed(Key::Enter))
    });
    let moved = chosen != state.search.chosen;
    let field = TextField::line(&mut state.search.wanted, crate::limits::MAX_TYPED_NAME);
    let field = field.with(|edit| edit.hint_text(t.field).desired_width(f32::INFINITY));
    let response = field.show(ui, lang).accessible_name(t.title);
    if first {
        response.request_focus();
    }
    let mut wanted = None;
    // At its final height from the first frame, so that nothing moves under the pointer.
    let height = (ui.ctx().content_rect().height() - 170.0).clamp(120.0, 420.0);
    let area = egui::ScrollArea::vertical().max_height(height).min_scrolled_height(height).auto_shrink(false);
    area.show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 1.0;
        if results.is_empty() {
            ui.label(t.nothing);
        }
        for (i, entry) in results.iter().enumerate() {
            let enabled = !matches!(&entry.target, SearchTarget::Command(command) if !command.is_enabled(state));
            let row = row(ui, &state.model, entry, enabled, i == chosen);
            if moved && i == chosen {
                row.scroll_to_me(Some(Align::Center));
            }
            if row.clicked() {
                wanted = Some(entry.target.clone());
            }
        }
    });
    ui.add_space(4.0);
    ui.label(RichText::new(t.keys).small().weak());
    if enter && (response.has_focus() || response.lost_focus()) {
        wanted = wanted.or_else(|| results.get(chosen).map(|entry| entry.target.clone()));
    }
    if state.search.wanted != before {
        chosen = 0;
    }
    state.search.chosen = chosen;
    let target = wanted?;
    state.file_flow.dialog = None;
    if let SearchTarget::Command(command) = target {
        return Some(command).filter(|command| command.is_enabled(state));
    }
    go_to(ui.ctx(), state, target);
    None
}

/// A result: its title, its kind, and the keys of a command.
fn row(ui: &mut Ui, model: &Model, entry: &SearchEntry, enabled: bool, chosen: bool) -> egui::Response {
    let keys = match &entry.target {
        SearchTarget::Command(command) => {
            command.keys(model).next().map(|keys| written(ui.ctx(), &keys, model.settings.lang))
        }
        _ => None,
    };
    let side = keys.map_or_else(|| entry.kind.to_owned(), |keys| format!("{}  {keys}", entry.kind));
    let button = Button::selectable(chosen, theme::symbol(ui, &entry.title)).shortcut_text(side).truncate();
    let response =
        ui.with_layout(egui::Layout::top_down_justified(Align::LEFT), |ui| ui.add_enabled(enabled, button)).inner;
    let said = format!("{}, {}", entry.title, entry.kind);
    response.widget_info(|| WidgetInfo::selected(Role::Button, enabled, chosen, &said));
    if matches!(entry.target, SearchTarget::Note(_)) { response } else { response.explained(entry.about.as_ref()) }
}

fn go_to(ctx: &egui::Context, state: &mut State, target: SearchTarget) {
    match target {
        // Its caller does it.
        SearchTarget::Command(_) => {}
        SearchTarget::Parameter(tab, field) => {
            state.model.settings.tab = tab;
            let t = cameras::texts(state.model.settings.lang);
            state.model.cameras.was_called |= [t.add, t.pair].contains(&field);
            state.model.settings.panels_mut().show(Side::Left);
            if !field.is_empty() {
                number_field::take_keyboard(ctx, field);
            }
        }
        SearchTarget::AmongOperations(name) => {
            state.model.settings.panels_mut().show(Side::Right);
            number_field::take_keyboard(ctx, name);
        }
        SearchTarget::Operation(freedom) => {
            state.model.operations.open(freedom);
            state.model.settings.panels_mut().show(Side::Right);
            number_field::take_keyboard(ctx, &operations::step_name(freedom, window::texts(state.model.settings.lang)));
        }
        SearchTarget::CameraCheck => state.file_flow.dialog = Some(Dialog::Coach),
        SearchTarget::Explanation(explanation) => {
            state.model.show_explanation(explanation);
            if explanation == Explanation::Exercises {
                state.learn.exercises.call();
            }
        }
        SearchTarget::Matrix(matrix) => state.model.explain_entry(matrix, [0, 0]),
        SearchTarget::Note(id) => state.explain.explain_by_note(&mut state.model, id),
        SearchTarget::Exercise(id) => {
            state.model.show_explanation(Explanation::Exercises);
            let entry = state.learn.exercises.entry(&id).cloned();
            entry.iter().for_each(|entry| list::open(&mut state.learn.exercises, entry));
        }
        SearchTarget::Figure(name) => file_flow::begin(ctx, state, Intent::Shipped(name)),
        SearchTarget::Step(place, step) => {
            if let Some(shipped) = shipped().get(place) {
                let open = OpenLesson { lesson: shipped.lesson.clone(), path: None, step };
                file_flow::begin(ctx, state, Intent::Lesson(open));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first results for some words, by title.
    fn titles(lang: Lang, wanted: &str) -> Vec<String> {
        let start = crate::gui::Start { lang, ..crate::gui::Start::default() };
        let state = State::new(start).expect("nothing is opened");
        found(&state.model, &state.learn, wanted).iter().take(3).map(|entry| entry.title.clone().into_owned()).collect()
    }

    #[test]
    fn every_key_of_figure_files_leads_to_a_control() {
        for lang in [Lang::En, Lang::PtBr] {
            let t = window::texts(lang);
            let homeless: Vec<_> = KEYS.iter().filter(|key| home(key, t).is_none()).collect();
            assert!(homeless.is_empty(), "{homeless:?}");
            for (name, _) in HOMES {
                let is_of = |key: &String| key == name || key.starts_with(&format!("{name}."));
                assert!(KEYS.iter().any(is_of), "{name} is no key");
            }
            assert_eq!(titles(lang, "style.antialias"), ["style.antialias"]);
            assert_eq!(home("style.antialias", t), Some(SearchTarget::Parameter(Tab::Drawing, t.antialias)));
        }
    }

    #[test]
    fn people_find_by_the_words_they_know() {
        for (lang, wanted, title) in [
            (Lang::En, "fov", "θ view angle"),
            (Lang::En, "near plane", "F front plane"),
            (Lang::En, "frustum to cube", "Frustum → cube"),
            (Lang::En, "gluLookAt", "Other libraries"),
            (Lang::En, "z-fighting", "Depth, z-fighting"),
            (Lang::En, "painter", "Hidden surfaces"),
            (Lang::En, "view matrix", "M_v view matrix (5.7)"),
            (Lang::En, "direct3d", "Conventions"),
            (Lang::En, "azimuth", "Azimuth"),
            (Lang::En, "empty image", "Camera check"),
            (Lang::En, "title", "Title and caption…"),
            (Lang::En, "pdf", "Export images…"),
            (Lang::En, "run time", "Numerics"),
            (Lang::En, "handout", "Handout…"),
            (Lang::En, "worksheet", "Handout…"),
            (Lang::En, "study", "Numerics"),
            (Lang::En, "students", "A class…"),
            (Lang::En, "progress", "Exercises"),
            (Lang::En, "import", "Open…"),
            (Lang::En, "gltf", "Open…"),
            (Lang::En, "frame", "Aim at it"),
            (Lang::En, "scorm", "For the course platform…"),
            (Lang::En, "look at", "Aim at it"),
            (Lang::En, "center", "Aim at it"),
            (Lang::En, "blender", "Other libraries"),
            (Lang::En, "web", "The page for your students…"),
            (Lang::PtBr, "estudo", "Numérica"),
            (Lang::PtBr, "mirar", "Mirar nele"),
            (Lang::PtBr, "alunos", "Uma turma…"),
            (Lang::PtBr, "enquadrar", "Ajustar a imagem"),
            (Lang::PtBr, "folha de exercícios", "Lista de exercícios…"),
            (Lang::PtBr, "legenda", "Título e legenda…"),
            (Lang::PtBr, "imagem vazia", "Diagnóstico da câmera"),
            (Lang::PtBr, "guinada", "Guinada"),
            (Lang::PtBr, "abertura", "θ ângulo de vista"),
            (Lang::PtBr, "angulo de vista", "θ ângulo de vista"),
            (Lang::PtBr, "recorte", "Recorte"),
            (Lang::PtBr, "matriz de vista", "M_v matriz de vista (5.7)"),
            (Lang::PtBr, "lookAt", "Outras bibliotecas"),
        ] {
            let found = titles(lang, wanted);
            assert!(found.iter().take(2).any(|found| found == title), "{wanted}: {found:?}");
        }
        assert_eq!(titles(Lang::En, "xyzzy"), Vec::<String>::new());
    }
}
