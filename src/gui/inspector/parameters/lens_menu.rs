//! The menu at θ: the lens in the words of photography and of other programs. Each row shows its value and takes
//! another.

use eframe::egui::{self, Popup, PopupCloseBehavior};

use super::{ParameterForm, complain, row, toggle};
use crate::camera::{Camera, LensForm, LensNumbers, Parameters, Sensor, SensorFit};
use crate::gui::kit::{Explained, NumberField, Step};
use crate::inspect::quantity::{LensNumber, Quantity};
use camera_lab_words::window::lens::{self, Texts};

/// The values of the menu that no camera has.
#[derive(Clone, Copy, Debug)]
struct Kept {
    sensor: Sensor,
    /// `None`: D.
    distance: Option<f64>,
}

/// A change of the lens.
enum LensChange {
    /// θ, for a symmetric window.
    Form(LensForm),
    /// The window becomes smaller by this factor. It's free, or the form has no place in a figure file.
    Zoom(f64),
    /// The middle of the window, as shares of the side that the sensor spans.
    Shift([f64; 2]),
}

/// The button that opens the menu.
pub(super) fn button(ui: &mut egui::Ui, form: &mut ParameterForm) {
    let t = lens::texts(form.lang);
    let numbers = form.good.lens_numbers(form.image).map(|lens| {
        let [x, y] = lens.focal_length_pixels;
        [lens.horizontal_angle, lens.diagonal_angle, x, y]
    });
    let all = LensNumber::ALL.iter().copied().map(Quantity::Lens).collect::<Vec<_>>();
    if form.asked.hides(&all, numbers.as_ref().map_or(&[], |numbers| numbers)) {
        return;
    }
    let shown = egui::Button::new("▾");
    // Its identity is the menu's, which stays open while rows above it come or go.
    let place = egui::UiBuilder::new().scope_id(egui::Id::unique("button of the lens menu"));
    let button = ui.scope_builder(place, |ui| ui.add_enabled(form.error.is_none(), shown)).inner;
    let button = button.explained(t.lens_hint).accessible_name(t.lens);
    let id = egui::Id::unique("values of the lens menu");
    let own = match form.lens {
        Some(LensForm::FocalLength { sensor, .. }) => sensor,
        _ => Sensor::default(),
    };
    let mut kept = ui.data(|data| data.get_temp(id)).unwrap_or(Kept { sensor: own, distance: None });
    let popup = Popup::from_toggle_button_response(&button).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let change = popup.show(|ui| {
        ui.set_width(300.0);
        rows(ui, form, t, &mut kept)
    });
    ui.data_mut(|data| data.insert_temp(id, kept));
    if let Some(change) = change.and_then(|shown| shown.inner) {
        apply(form, change, kept.sensor);
    }
}

/// The rows. Returns the last change that one of them asks for.
fn rows(ui: &mut egui::Ui, form: &ParameterForm, t: &Texts, kept: &mut Kept) -> Option<LensChange> {
    let camera = &form.good;
    let lens = camera.lens_numbers(form.image)?;
    let mut change = angles(ui, form, lens, t);
    let focal = |focal_length, sensor: Sensor| match form.parameters.window {
        None => LensChange::Form(LensForm::FocalLength { focal_length, sensor }),
        Some(_) => LensChange::Zoom(focal_length / camera.focal_length(sensor)),
    };
    let mut focal_length = camera.focal_length(kept.sensor);
    if number(ui, form, (t.focal_length, t.focal_length_hint), &mut focal_length) {
        change = Some(focal(focal_length, kept.sensor));
    }
    sensor(ui, form, t, &mut kept.sensor);
    let mut pixels = lens.focal_length_pixels;
    let fields = ["f_x", "f_y"].map(|name| NumberField::new(name, Step::Multiply(1.1)).positive());
    if pair(ui, form, (t.pixels, t.pixels_hint), fields, &mut pixels) {
        // Pixels keep their shape, so the typed one counts.
        let typed = usize::from(pixels[0].to_bits() == lens.focal_length_pixels[0].to_bits());
        change = Some(LensChange::Zoom(pixels[typed] / lens.focal_length_pixels[typed]));
    }
    let mut shift = camera.lens_shift(kept.sensor);
    let before = shift;
    let fields = ["x", "y"].map(|axis| NumberField::new(format!("{} {axis}", t.shift), Step::Add(0.05)));
    if pair(ui, form, (t.shift, t.shift_hint), fields, &mut shift) && shift != before {
        change = Some(LensChange::Shift(shift));
    }
    ui.separator();
    let mut distance = kept.distance.unwrap_or(camera.distance());
    if number(ui, form, (t.distance, t.distance_hint), &mut distance) {
        kept.distance = Some(distance);
    }
    let [width, height] = camera.view_size_at(distance);
    let sizes = |digits| [width, height].map(|side| form.lang.mark().number(side, digits)).join(" × ");
    row(ui, "", t.view_there, t.view_there_hint, |ui| {
        ui.label(sizes(5)).explained(sizes(crate::numbers::EXACT_DIGITS))
    });
    change
}

/// θ, the horizontal and the diagonal angle.
fn angles(ui: &mut egui::Ui, form: &ParameterForm, lens: LensNumbers, t: &Texts) -> Option<LensChange> {
    type OfDegrees = fn(f64) -> LensForm;
    let vertical = form.good.view_angle().degrees();
    let mut change = None;
    let rows: [(&str, f64, Option<OfDegrees>); 3] = [
        (t.vertical, vertical, None),
        (t.horizontal, lens.horizontal_angle, Some(LensForm::HorizontalAngle)),
        (t.diagonal, lens.diagonal_angle, Some(LensForm::DiagonalAngle)),
    ];
    for (name, mut degrees, of_degrees) in rows {
        let field = NumberField::angle(name, 5.0).within(0.001..=179.999).greyed(t.angle_hint);
        let field = field.hint(t.angle_hint).width(92.0);
        let before = degrees;
        let output = ui.add_enabled_ui(form.parameters.window.is_none(), |ui| {
            row(ui, "", name, t.angle_hint, |ui| field.show(ui, form.t, &mut degrees))
        });
        complain(ui, form.lang, &[output.inner]);
        if degrees.to_bits() != before.to_bits() {
            change = Some(
                of_degrees.map_or(LensChange::Zoom(zoom(before, degrees)), |form| LensChange::Form(form(degrees))),
            );
        }
    }
    change
}

/// The factor by which a lens becomes longer if its angle changes.
fn zoom(from: f64, to: f64) -> f64 {
    let slope = |degrees: f64| (degrees.to_radians() / 2.0).tan();
    slope(from) / slope(to)
}

/// Width, height and fit of the sensor.
fn sensor(ui: &mut egui::Ui, form: &ParameterForm, t: &Texts, sensor: &mut Sensor) {
    let mut sides = [sensor.width, sensor.height];
    let fields = ["W", "H"].map(|side| NumberField::new(format!("{} {side}", t.sensor), Step::Add(1.0)).positive());
    if pair(ui, form, (t.sensor, t.sensor_hint), fields, &mut sides) {
        [sensor.width, sensor.height] = sides;
    }
    row(ui, "", t.fit, t.sensor_hint, |ui| {
        for (fit, name, hint) in [
            (SensorFit::Horizontal, t.fit_horizontal, t.fit_horizontal_hint),
            (SensorFit::Vertical, t.fit_vertical, t.fit_vertical_hint),
            (SensorFit::Larger, t.fit_larger, t.fit_larger_hint),
        ] {
            let button = toggle(ui, sensor.fit == fit, name).explained(hint);
            if button.accessible_name(format!("{}: {name}", t.fit)).clicked() {
                sensor.fit = fit;
            }
        }
    });
}

/// One positive number. Returns true if it changed.
fn number(ui: &mut egui::Ui, form: &ParameterForm, (name, hint): (&str, &str), value: &mut f64) -> bool {
    let before = *value;
    let field = NumberField::new(name, Step::Multiply(1.1)).positive().hint(hint).width(92.0);
    let output = row(ui, "", name, hint, |ui| field.show(ui, form.t, value));
    complain(ui, form.lang, &[output]);
    value.to_bits() != before.to_bits()
}

/// Two numbers side by side. Returns true if one changed.
fn pair(
    ui: &mut egui::Ui,
    form: &ParameterForm,
    (name, hint): (&str, &str),
    fields: [NumberField<'_>; 2],
    values: &mut [f64; 2],
) -> bool {
    let before = *values;
    let outputs = row(ui, "", name, hint, |ui| {
        let fields = fields.into_iter().zip(values.iter_mut());
        fields.map(|(field, value)| field.hint(hint).width(70.0).show(ui, form.t, value)).collect::<Vec<_>>()
    });
    complain(ui, form.lang, &outputs);
    values.map(f64::to_bits) != before.map(f64::to_bits)
}

/// Changes the lens of the parameters.
fn apply(form: &mut ParameterForm, change: LensChange, sensor: Sensor) {
    let parameters = form.parameters;
    match change {
        LensChange::Form(lens) => {
            form.parameters.view_angle = lens.view_angle(parameters.aspect);
            // A figure file has no diagonal angle.
            form.new_lens = Some(lens).filter(|lens| !matches!(lens, LensForm::DiagonalAngle(_)));
        }
        LensChange::Zoom(factor) => form.parameters = zoomed(&parameters, &form.good, factor),
        LensChange::Shift(shift) => {
            let moved = Parameters { window: Some(form.good.window_with_shift(sensor, shift)), ..parameters };
            // In the middle the window is the symmetric one again.
            form.parameters = if shift == [0.0; 2] { symmetric_window(&moved) } else { moved };
        }
    }
}

/// The parameters with a window smaller by a factor.
fn zoomed(parameters: &Parameters, good: &Camera, factor: f64) -> Parameters {
    match parameters.window {
        Some(window) => Parameters { window: Some(window.map(|side| side / factor)), ..*parameters },
        None => {
            let slope = good.window_height() / good.near() / factor;
            // A sensor as high as the image, behind a lens of length 1.
            let sensor = Sensor { height: slope, fit: SensorFit::Vertical, ..Sensor::default() };
            let lens = LensForm::FocalLength { focal_length: 1.0, sensor };
            Parameters { view_angle: lens.view_angle(parameters.aspect), ..*parameters }
        }
    }
}

/// Frees the window without changing it.
pub(super) fn free_window(parameters: &Parameters, good: &Camera) -> Parameters {
    let window = Camera::new(parameters).map_or_else(|_| good.window(), |camera| camera.window());
    Parameters { window: Some(window), ..*parameters }
}

/// Makes the window symmetric. Its size stays. If only the padlock has been used, θ, H and A stay to the last bit.
pub(super) fn symmetric_window(parameters: &Parameters) -> Parameters {
    let before = Parameters { window: None, ..*parameters };
    let Some(window) = parameters.window else { return before };
    if Camera::new(&before).is_ok_and(|camera| camera.window() == window) {
        return before;
    }
    let height = window.height();
    let angle = 2.0 * (height / 2.0 / parameters.near).atan().to_degrees();
    let after = Parameters { view_angle: angle, height, aspect: window.aspect(), ..before };
    if Camera::new(&after).is_ok() { after } else { before }
}
