//! The operations on the camera: by a step, or scrubbed with a slider from where the camera is.

use eframe::egui::{self, Align, Layout, RichText, Slider};

use super::{TEXT_LINE, section};
use crate::camera::{Camera, Convention, Operation};
use crate::geometry::Angle;
use crate::gui::number_field::{NumberField, Step};
use crate::gui::numbers;
use crate::gui::state::State;
use crate::gui::theme;
use crate::i18n::faults;
use crate::i18n::window::{self, Texts};
use crate::views::Ghost;

/// A row of the panel: an operation along one of its degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// C about **u** through PF.
    Elevation,
    /// C about **v** through PF.
    Azimuth,
    /// VUP about **n**.
    Roll,
    /// PF about **v** through C.
    Yaw,
    /// PF about **u** through C.
    Pitch,
    /// The window.
    Zoom,
    /// C along DOP.
    Dolly,
    /// C and PF along **u**.
    PanU,
    /// C and PF along **v**.
    PanV,
}

impl Kind {
    /// All, as they are listed.
    pub const ALL: [Self; 9] = [
        Self::Elevation,
        Self::Azimuth,
        Self::Roll,
        Self::Yaw,
        Self::Pitch,
        Self::Zoom,
        Self::Dolly,
        Self::PanU,
        Self::PanV,
    ];

    /// The operation by an amount: degrees; a power of two; scene units. 0 changes nothing.
    #[must_use]
    pub fn by(self, amount: f64) -> Operation {
        let angle = Angle::from_degrees(amount);
        match self {
            Self::Elevation => Operation::Elevation(angle),
            Self::Azimuth => Operation::Azimuth(angle),
            Self::Roll => Operation::Roll(angle),
            Self::Yaw => Operation::Yaw(angle),
            Self::Pitch => Operation::Pitch(angle),
            Self::Zoom => Operation::Zoom(amount.exp2()),
            Self::Dolly => Operation::Dolly(amount.exp2()),
            Self::PanU => Operation::Pan { dx: amount, dy: 0.0 },
            Self::PanV => Operation::Pan { dx: 0.0, dy: amount },
        }
    }

    /// The operation of a button: one step forwards or backwards.
    fn step(self, step: f64, forwards: bool) -> Operation {
        match self {
            Self::Zoom => Operation::Zoom(if forwards { step } else { 1.0 / step }),
            Self::Dolly => Operation::Dolly(if forwards { step } else { 1.0 / step }),
            _ => self.by(if forwards { step } else { -step }),
        }
    }

    fn is_factor(self) -> bool {
        matches!(self, Self::Zoom | Self::Dolly)
    }

    fn is_pan(self) -> bool {
        matches!(self, Self::PanU | Self::PanV)
    }

    fn name(self, t: &Texts) -> &'static str {
        match self {
            Self::Elevation => t.elevation,
            Self::Azimuth => t.azimuth,
            Self::Roll => t.roll,
            Self::Yaw => t.yaw,
            Self::Pitch => t.pitch,
            Self::Zoom => t.zoom,
            Self::Dolly => t.dolly,
            Self::PanU => t.pan_u,
            Self::PanV => t.pan_v,
        }
    }

    /// What changes, and how.
    fn effect(self, t: &Texts) -> &'static str {
        match self {
            Self::Elevation => t.elevation_effect,
            Self::Azimuth => t.azimuth_effect,
            Self::Roll => t.roll_effect,
            Self::Yaw => t.yaw_effect,
            Self::Pitch => t.pitch_effect,
            Self::Zoom => t.zoom_effect,
            Self::Dolly => t.dolly_effect,
            Self::PanU => t.pan_u_effect,
            Self::PanV => t.pan_v_effect,
        }
    }
}

/// The panel's own state.
#[derive(Clone, Debug)]
pub struct Operations {
    /// What a button does: degrees, factor or scene units, in the order of [`Kind::ALL`].
    pub steps: [f64; 9],
    /// Whose signs.
    pub convention: Convention,
    scrub: Option<Scrub>,
}

/// A slider that is being held.
#[derive(Clone, Debug)]
struct Scrub {
    kind: Kind,
    start: Camera,
    amount: f64,
}

impl Default for Operations {
    fn default() -> Self {
        Self {
            steps: [15.0, 15.0, 15.0, 5.0, 5.0, 1.25, 1.25, 0.5, 0.5],
            convention: Convention::default(),
            scrub: None,
        }
    }
}

/// Shows the operations.
pub fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = window::texts(state.settings.lang);
    state.ghost = None;
    let possible = state.document.problem().is_none();
    section(ui, t.operations, "operations", true, |ui| {
        ui.spacing_mut().item_spacing.y = 2.0;
        ui.add_enabled_ui(possible, |ui| {
            for (index, kind) in Kind::ALL.into_iter().enumerate() {
                ui.push_id(index, |ui| operation(ui, t, state, index, kind));
            }
        });
        let mut vtk = state.operations.convention == Convention::Vtk;
        ui.checkbox(&mut vtk, t.vtk).on_hover_text(t.vtk_hint);
        state.operations.convention = if vtk { Convention::Vtk } else { Convention::RightHand };
    });
    if !ui.input(|input| input.pointer.any_down()) {
        state.operations.scrub = None;
    }
}

fn operation(ui: &mut egui::Ui, t: &'static Texts, state: &mut State, index: usize, kind: Kind) {
    let amount = state.operations.scrub.as_ref().filter(|scrub| scrub.kind == kind).map(|scrub| scrub.amount);
    let row = ui.scope(|ui| {
        ui.spacing_mut().item_spacing.y = 1.0;
        let height = std::mem::replace(&mut ui.spacing_mut().interact_size.y, TEXT_LINE);
        ui.horizontal(|ui| {
            ui.label(RichText::new(kind.name(t)).strong());
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let small = match amount {
                    Some(amount) => RichText::new(describe(kind, amount)).small().strong(),
                    None => RichText::new(kind.effect(t)).small().weak(),
                };
                ui.add(egui::Label::new(small).truncate());
            });
        });
        ui.spacing_mut().interact_size.y = height;
        controls(ui, t, state, index, kind);
    });
    ui.add_space(1.0);
    let hovered = ui.rect_contains_pointer(row.response.rect) && ui.is_enabled();
    if state.ghost.is_none() && hovered && !ui.input(|input| input.pointer.any_down()) {
        let before = state.document.camera().clone();
        let operation = kind.step(state.operations.steps[index], true);
        state.ghost = Some(Ghost { before, operation, convention: state.operations.convention });
    }
}

/// How far a slider has been pulled.
fn describe(kind: Kind, amount: f64) -> String {
    let sign = if amount > 0.0 { "+" } else { "" };
    match kind {
        Kind::Zoom | Kind::Dolly => format!("× {}", numbers::significant(amount.exp2(), 4)),
        Kind::PanU | Kind::PanV => format!("{sign}{}", numbers::significant(amount, 4)),
        _ => format!("{sign}{}°", numbers::significant(amount, 5)),
    }
}

/// − step + and the slider.
fn controls(ui: &mut egui::Ui, t: &'static Texts, state: &mut State, index: usize, kind: Kind) {
    let name = kind.name(t);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        button(ui, t, state, index, kind, false);
        let step = &mut state.operations.steps[index];
        let field = if kind.is_factor() {
            NumberField::new(format!("{name}: {}", t.step), Step::Multiply(1.1)).prefix("×")
        } else if kind.is_pan() {
            NumberField::new(format!("{name}: {}", t.step), Step::Multiply(1.1))
        } else {
            NumberField::angle(format!("{name}: {}", t.step), 5.0)
        };
        let before = *step;
        field.width(58.0).hint(t.step_hint).show(ui, t, step);
        if !(*step > 0.0 && step.is_finite()) {
            *step = before;
        }
        button(ui, t, state, index, kind, true);
        slider(ui, t, state, kind);
    });
}

fn button(ui: &mut egui::Ui, t: &Texts, state: &mut State, index: usize, kind: Kind, forwards: bool) {
    let sign = if forwards { "+" } else { "−" };
    let button = egui::Button::new(sign).min_size(egui::vec2(24.0, 0.0));
    let name = format!("{} {sign}", kind.name(t));
    if ui.add(button).accessible_name(name).on_hover_text(kind.effect(t)).clicked() {
        apply(state, kind.step(state.operations.steps[index], forwards));
    }
}

/// Pulls the camera from where it was taken; springs back when it is let go.
fn slider(ui: &mut egui::Ui, t: &Texts, state: &mut State, kind: Kind) {
    let range = match kind {
        Kind::Zoom | Kind::Dolly => 3.0,
        Kind::PanU | Kind::PanV => {
            state.operations.scrub.as_ref().map_or(state.document.camera(), |s| &s.start).distance()
        }
        _ => 180.0,
    };
    let grain = match kind {
        Kind::Zoom | Kind::Dolly => 0.05,
        Kind::PanU | Kind::PanV => 0.0,
        _ => 1.0,
    };
    let mut amount = state.operations.scrub.as_ref().filter(|scrub| scrub.kind == kind).map_or(0.0, |s| s.amount);
    ui.spacing_mut().slider_width = ui.available_width().max(40.0);
    theme::strengthen_rail(ui);
    let slider = Slider::new(&mut amount, -range..=range).show_value(false).step_by(grain);
    let response = ui.add(slider).on_hover_text(t.scrub_hint);
    let response = response.accessible_name(format!("{}: {}", kind.name(t), t.scrub));
    if response.drag_started() {
        state.operations.scrub = Some(Scrub { kind, start: state.document.camera().clone(), amount: 0.0 });
    }
    if response.dragged() {
        let convention = state.operations.convention;
        if let Some(scrub) = state.operations.scrub.as_mut().filter(|scrub| scrub.kind == kind) {
            state.ghost = Some(Ghost { before: scrub.start.clone(), operation: kind.by(amount), convention });
            if scrub.amount != amount {
                scrub.amount = amount;
                let after = if amount == 0.0 {
                    Ok(scrub.start.clone())
                } else {
                    kind.by(amount).apply(&scrub.start, convention)
                };
                match after {
                    Ok(camera) => state.document.set_camera(camera),
                    Err(error) => state.say_error(faults::camera_error(state.settings.lang, &error)),
                }
            }
        }
    } else if response.changed() {
        apply(state, kind.by(amount));
    }
}

/// Does an operation to the camera; where it has no result, says why.
pub fn apply(state: &mut State, operation: Operation) {
    match operation.apply(state.document.camera(), state.operations.convention) {
        Ok(camera) => state.document.set_camera(camera),
        Err(error) => state.say_error(faults::camera_error(state.settings.lang, &error)),
    }
}
