//! The panel on the left: every parameter of the figure, in three tabs for the camera, the scene, and the way it's
//! drawn.

mod camera;
mod cameras;
mod image;
mod lens_menu;
mod photograph;
mod style;
mod world_section;

use eframe::egui;
use glam::DVec3;

use super::{complain, complaint, row, toggle};
use crate::camera::{Camera, CameraError, CameraRepair, ImageSize, LensForm, ParameterKey, Parameters, camera_repairs};
use crate::explain::Symbol;
use crate::figure::{Explanation, Measure, MeasureText, Measured, WindowSide};
use crate::gui::kit::{
    Command, Explained, FieldOutput, NumberField, has_focus, help_topic_row, keep_in_sight, written,
};
use crate::inspect::Asked;
use crate::inspect::quantity::Quantity;
use crate::numbers;
use camera_lab_desk::{Model, Tab, symbols_of};
use camera_lab_words::messages::faults;
use camera_lab_words::why::{explain_point, notes};
use camera_lab_words::window::{self, Texts, scenes};

/// Shows the panel's content: one of its tabs.
pub fn ui(ui: &mut egui::Ui, model: &mut Model) {
    tabs(ui, model);
    let scroll = egui::ScrollArea::vertical().id_salt(model.settings.tab).auto_shrink(false);
    match model.settings.tab {
        Tab::Camera => {
            scroll.show(ui, |ui| {
                camera_tab(ui, model);
                keep_in_sight(ui);
            });
        }
        Tab::Scene => super::scene::ui(ui, model),
        Tab::Drawing => {
            scroll.show(ui, |ui| {
                style::ui(ui, model);
                world_section::ui(ui, model);
                keep_in_sight(ui);
            });
        }
    }
}

/// The heads of the tabs, side by side.
fn tabs(ui: &mut egui::Ui, model: &mut Model) {
    let t = window::texts(model.settings.lang);
    let drawing = scenes::texts(model.settings.lang).drawing;
    ui.add_space(2.0);
    ui.columns(3, |columns| {
        let all = [(Tab::Camera, t.camera), (Tab::Scene, t.scene), (Tab::Drawing, drawing)];
        for (column, (tab, text)) in columns.iter_mut().zip(all) {
            let command = Command::Tab(tab);
            let keys = written(column.ctx(), &command.shortcut(), model.settings.lang);
            let hint = format!("{} ({keys})", command.hint(t));
            let impossible = tab == Tab::Camera && model.desk.shown.problem().is_some();
            let text = if impossible { format!("⚠ {text}") } else { text.to_owned() };
            column.vertical_centered_justified(|ui| {
                let button = toggle(ui, model.settings.tab == tab, text).explained(hint);
                if button.accessible_name(command.label(t)).clicked() {
                    model.settings.tab = tab;
                }
            });
        }
    });
    ui.add_space(2.0);
}

fn camera_tab(ui: &mut egui::Ui, model: &mut Model) {
    let mut form = ParameterForm::new(model);
    if form.error.is_some() && model.frame.problem_out_of_sight {
        form.problem(ui);
        form.said = false;
    }
    camera::placement(ui, &mut form);
    camera::projection(ui, &mut form, model);
    camera::window(ui, &mut form);
    model.frame.hover.measured = form.measured;
    model.frame.hover.pointed = form.pointed;
    model.frame.problem_out_of_sight = form.error.is_some() && !form.said;
    match form.replaced {
        Some(camera) => model.desk.shown.set_camera(camera),
        None => model.desk.shown.set_parameters(form.parameters),
    }
    if let Some(lens) = form.new_lens {
        model.desk.shown.set_lens(lens);
    }
    if let Some(point) = form.follows {
        model.follow_point(point);
        model.show_explanation(Explanation::Point);
    }
    if let Some(measure) = form.keeps {
        let shown = (!form.kept.contains(&measure)).then(MeasureText::default);
        model.desk.shown.edit_labels(|labels| labels.measure(measure, shown));
    }
    cameras::ui(ui, model);
    image::ui(ui, model);
}

/// The camera's parameters while their fields are shown, and their faults.
struct ParameterForm {
    t: &'static Texts,
    lang: camera_lab_words::Lang,
    /// The scene that the camera looks at, because the notes have errata for some exercises.
    preset: crate::scene::Preset,
    parameters: Parameters,
    error: Option<CameraError>,
    good: Camera,
    /// The form in which θ was given.
    lens: Option<LensForm>,
    /// The new form, if it changes in this frame.
    new_lens: Option<LensForm>,
    image: ImageSize,
    /// The quantities that open questions ask for.
    asked: Asked,
    /// A camera that knows more than its parameters.
    replaced: Option<Camera>,
    said: bool,
    /// The measure of the parameter under the pointer.
    measured: Vec<Measured>,
    /// The parameter under the pointer, or with the keyboard.
    pointed: Vec<Symbol>,
    /// The measures that the figure shows as labels, and the one that it's to show or hide now.
    kept: Vec<Measure>,
    keeps: Option<Measure>,
    /// The point of the world to follow.
    follows: Option<DVec3>,
}

impl ParameterForm {
    fn new(model: &Model) -> Self {
        Self {
            t: window::texts(model.settings.lang),
            lang: model.settings.lang,
            preset: model.desk.shown.figure().scene.preset,
            parameters: *model.desk.shown.draft(),
            error: model.desk.shown.problem().cloned(),
            good: model.desk.shown.camera().clone(),
            lens: model.desk.shown.figure().lens_in_force(),
            new_lens: None,
            image: model.desk.shown.figure().image,
            asked: model.frame.asked.clone(),
            replaced: None,
            said: false,
            measured: Vec::new(),
            pointed: Vec::new(),
            kept: model.desk.shown.figure().labels.measures.iter().map(|shown| shown.measure).collect(),
            keeps: None,
            follows: None,
        }
    }

    fn is_marked(&self, key: ParameterKey) -> bool {
        self.error.as_ref().is_some_and(|error| error.parameters().contains(&key))
    }

    /// Shows the fault of a value below its field, either of the typed text or of the value.
    fn complain(&mut self, ui: &mut egui::Ui, key: ParameterKey, fields: &[FieldOutput]) {
        complain(ui, self.lang, fields);
        if self.error.as_ref().is_some_and(|error| error.parameters().first() == Some(&key)) {
            self.problem(ui);
        }
    }

    /// The reason why the parameters aren't a camera, and the buttons that mend them.
    fn problem(&mut self, ui: &mut egui::Ui) {
        let Some(error) = &self.error else { return };
        self.said = true;
        complaint(ui, &faults::camera_error(self.lang, error));
        let mut mended = None;
        ui.horizontal_wrapped(|ui| {
            for (repair, parameters) in camera_repairs(error, &self.parameters, &self.good) {
                if ui.button(label(self.t, repair)).clicked() {
                    mended = Some(parameters);
                }
            }
        });
        if let Some(mended) = mended {
            self.parameters = mended;
        }
    }

    /// Shows the row of a parameter without its value while a question asks for it. Returns false if none does.
    fn is_hidden(
        &self,
        ui: &mut egui::Ui,
        [symbol, name]: [&str; 2],
        (quantities, values): (&[Quantity], &[f64]),
    ) -> bool {
        let hides = self.asked.hides(quantities, values);
        if hides {
            row(ui, symbol, name, self.t.asked_hint, |ui| ui.label(self.t.asked_here));
        }
        hides
    }

    /// A vector: its name, and below it three fields side by side.
    fn vector(
        &mut self,
        ui: &mut egui::Ui,
        key: ParameterKey,
        [name, hint]: [&'static str; 2],
        step: f64,
        value: fn(&mut Parameters) -> &mut DVec3,
    ) {
        let (symbol, marked) = (key.symbol(), self.is_marked(key));
        let numbers = value(&mut self.parameters).to_array();
        if self.is_hidden(ui, [symbol, name], (&[Quantity::Camera(key)], &numbers)) {
            return;
        }
        let shown = super::VectorField { symbol, name, hint, field: symbol, owner: "", step, angles: false, marked };
        let outputs = ui.scope(|ui| shown.show(ui, self.t, value(&mut self.parameters)));
        self.point_at(ui, key, outputs.response.rect);
        self.complain(ui, key, &outputs.inner);
    }

    /// One number: its name on the left, its field on the right.
    fn number(
        &mut self,
        ui: &mut egui::Ui,
        key: ParameterKey,
        [name, hint]: [&'static str; 2],
        field: NumberField<'static>,
        value: fn(&mut Parameters) -> &mut f64,
    ) {
        let marked = self.is_marked(key);
        let number = *value(&mut self.parameters);
        if self.is_hidden(ui, [key.symbol(), name], (&[Quantity::Camera(key)], &[number])) {
            return;
        }
        let output = ui.scope(|ui| {
            row(ui, key.symbol(), name, hint, |ui| {
                if key == ParameterKey::ViewAngle {
                    lens_menu::button(ui, self);
                }
                field.hint(hint).width(92.0).marked(marked).show(ui, self.t, value(&mut self.parameters))
            })
        });
        self.point_at(ui, key, output.response.rect);
        self.complain(ui, key, &[output.inner]);
    }

    /// While the pointer is on the row of a parameter, the world shows its length or angle. Then, and while its field
    /// has the focus, the explanations mark the entries that depend on it.
    fn point_at(&mut self, ui: &egui::Ui, key: ParameterKey, row: egui::Rect) {
        self.menu(ui, key, row);
        self.point_at_symbols(ui, symbols_of(key), measure_of(key), row);
    }

    /// The same for a side of the view window.
    fn point_at_side(&mut self, ui: &egui::Ui, side: WindowSide, row: egui::Rect) {
        let symbol = match side {
            WindowSide::Left => Symbol::Left,
            WindowSide::Right => Symbol::Right,
            WindowSide::Bottom => Symbol::Bottom,
            WindowSide::Top => Symbol::Top,
        };
        self.point_at_symbols(ui, vec![symbol], Some(Measured::Side(side)), row);
    }

    fn point_at_symbols(&mut self, ui: &egui::Ui, symbols: Vec<Symbol>, measured: Option<Measured>, row: egui::Rect) {
        let pointed = ui.rect_contains_pointer(row);
        if pointed
            && !ui.input(|input| input.pointer.any_down())
            && let Some(measured) = measured
        {
            self.measured = vec![measured];
        }
        if let Some(symbol) = symbols.first() {
            help_topic_row(ui, row, notes::of_symbol(*symbol));
        }
        if pointed || (has_focus(ui, row) && self.pointed.is_empty()) {
            self.pointed = symbols;
        }
    }

    /// The menu that a right click on a row opens. It copies the row's value, follows its point through the spaces, or
    /// keeps its measure in the figure as a label in the world.
    fn menu(&mut self, ui: &egui::Ui, key: ParameterKey, row: egui::Rect) {
        let opens = ui.rect_contains_pointer(row) && ui.input(|input| input.pointer.secondary_clicked());
        let id = egui::Id::unique(("menu of a parameter", key.symbol()));
        let menu = egui::Popup::new(id, ui.ctx().clone(), egui::PopupAnchor::PointerFixed, ui.layer_id())
            .kind(egui::PopupKind::Menu)
            .open_memory(opens.then_some(egui::SetOpenCommand::Bool(true)));
        menu.show(|ui| {
            let Parameters { position, focal_point, view_up, .. } = self.parameters;
            let (point, values) = match key {
                ParameterKey::Position => (Some(position), position.to_array().to_vec()),
                ParameterKey::FocalPoint => (Some(focal_point), focal_point.to_array().to_vec()),
                ParameterKey::ViewUp => (None, view_up.to_array().to_vec()),
                ParameterKey::ViewAngle => (None, vec![self.good.view_angle().degrees()]),
                ParameterKey::Height => (None, vec![self.good.window().height()]),
                ParameterKey::Aspect => (None, vec![self.good.window().aspect()]),
                ParameterKey::Near => (None, vec![self.parameters.near]),
                ParameterKey::Far => (None, vec![self.parameters.far]),
                ParameterKey::Window => return,
            };
            let written = |value: &f64| self.t.lang.mark().number(*value, numbers::EXACT_DIGITS);
            if ui.button(format!("{} {}", self.t.copy, key.symbol())).clicked() {
                ui.ctx().copy_text(values.iter().map(written).collect::<Vec<_>>().join(" "));
                ui.close();
            }
            if let Some(point) = point
                && ui.button(format!("{} {}", explain_point::texts(self.lang).follow, key.symbol())).clicked()
            {
                self.follows = Some(point);
                ui.close();
            }
            if let Some(Measured::Dimension(measure)) = measure_of(key) {
                let text = format!("{}: {}", self.t.keep_operation, measure.symbol());
                if ui.selectable_label(self.kept.contains(&measure), text).clicked() {
                    self.keeps = Some(measure);
                    ui.close();
                }
            }
        });
    }

    /// A number that follows from others.
    fn derived(&mut self, ui: &mut egui::Ui, key: ParameterKey, named: (&str, &str), value: f64) {
        self.derived_beside(ui, key, named, (value, ""), |_, _| ());
    }

    /// The same with its unit, after another control.
    fn derived_beside(
        &mut self,
        ui: &mut egui::Ui,
        key: ParameterKey,
        (name, hint): (&str, &str),
        (value, unit): (f64, &str),
        beside: impl FnOnce(&mut egui::Ui, &mut Self),
    ) {
        if self.is_hidden(ui, [key.symbol(), name], (&[Quantity::Camera(key)], &[value])) {
            return;
        }
        row(ui, key.symbol(), name, hint, |ui| {
            // As high as a field.
            ui.set_min_height(ui.spacing().interact_size.y);
            beside(ui, self);
            let number = |digits| self.t.lang.mark().number(value, digits);
            let exact = number(numbers::EXACT_DIGITS);
            ui.label(format!("{}{unit}", number(6))).explained(format!("= {exact}{unit}"));
        });
    }
}

/// The length or angle that a parameter is, or sets.
fn measure_of(key: ParameterKey) -> Option<Measured> {
    let measure = match key {
        ParameterKey::Near => Measure::Near,
        ParameterKey::Far => Measure::Far,
        ParameterKey::ViewAngle => Measure::HalfAngle,
        ParameterKey::Height => Measure::Height,
        ParameterKey::Aspect => Measure::Width,
        ParameterKey::FocalPoint => Measure::Distance,
        ParameterKey::Position | ParameterKey::ViewUp | ParameterKey::Window => return None,
    };
    Some(Measured::Dimension(measure))
}

fn label(t: &Texts, repair: CameraRepair) -> String {
    match repair {
        CameraRepair::FocalPointAhead => t.repair_focal_point.to_owned(),
        CameraRepair::ViewUp(axis) => format!("{} ({}, {}, {})", t.repair_view_up, axis.x, axis.y, axis.z),
        CameraRepair::SwapNearFar => t.repair_swap_near_far.to_owned(),
        CameraRepair::FarTenTimesNear => t.repair_far.to_owned(),
        CameraRepair::ViewAngle(angle) => format!("{} {}°", t.repair_angle, t.lang.mark().printed(&angle.to_string())),
        CameraRepair::SwapSides => t.repair_sides.to_owned(),
        CameraRepair::Back => t.repair_back.to_owned(),
    }
}
