//! A matrix of another program → its camera: its kind and its axes, recognised or chosen.

use eframe::egui::{self, RichText};

use crate::camera::{
    Assumed, Axes, Camera, Evidence, ImageSize, MatrixKind, Ndc, Parameters, Pasted, Reading, Recognised,
    RecoveryError, Stated, camera_names, read_cameras, recognise,
};
use crate::explain::vocabulary::Vocabulary;
use crate::gui::kit::{Explained, NumberField, Step, TextField, choice_row, complaint, help_topic, row, theme, whole};
use crate::gui::why::state::explain::Explain;
use crate::limits::{MAX_ANSWER, MAX_SIDE};
use camera_lab_desk::Model;
use camera_lab_words::why::conventions;
use camera_lab_words::why::dialects::{self, Texts};
use camera_lab_words::window;

/// The note on a pasted matrix.
pub(in crate::gui::why) const fn note_on_matrix(kind: Option<MatrixKind>) -> &'static str {
    match kind {
        Some(MatrixKind::View) => "M_v",
        Some(MatrixKind::CameraToWorld) | None => "inverse",
        Some(MatrixKind::Projection) => "M_p",
        Some(MatrixKind::ViewProjection) => "M_pM_v",
        Some(MatrixKind::Pinhole | MatrixKind::Intrinsics) => "K",
        Some(MatrixKind::LookAt) => "M_v",
    }
}

/// Takes parameters over. If they have an aspect of their own, it no longer follows the image.
pub(in crate::gui::why) fn take(model: &mut Model, parameters: Parameters) {
    let own = parameters.window.is_none() && parameters.aspect.to_bits() != model.desk.shown.draft().aspect.to_bits();
    model.settings.aspect_follows_image &= !own;
    model.desk.shown.set_parameters(parameters);
}

/// Shows a field for a matrix, and the camera that has it.
pub(in crate::gui::why) fn ui(ui: &mut egui::Ui, model: &mut Model, explain: &mut Explain) {
    let lang = model.settings.lang;
    let t = dialects::texts(lang);
    ui.label(RichText::new(t.pasted_hint).weak());
    choices(ui, explain, t);
    let pasted = &mut explain.pasted;
    let hint = "1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1";
    let field = TextField::lines(&mut pasted.text, MAX_ANSWER).with(|edit| {
        let edit = edit.desired_rows(4).desired_width(f32::INFINITY);
        edit.hint_text(hint).font(egui::TextStyle::Monospace)
    });
    // A file may have hundreds of lines, but the camera below is what the user wants to see.
    let most = 10.0 * ui.text_style_height(&egui::TextStyle::Monospace);
    let scroll = egui::ScrollArea::vertical().id_salt(t.pasted).max_height(most);
    let field = scroll.show(ui, |ui| field.show(ui, lang)).inner.accessible_name(t.pasted);
    help_topic(&field, note_on_matrix(pasted.kind));
    if pasted.text.trim().is_empty() {
        return;
    }
    let cameras = match read_cameras(pasted.text.as_bytes()) {
        Ok(cameras) => cameras,
        Err(fault) => return complaint(ui, &dialects::unreadable(lang, &fault)),
    };
    which_camera(ui, explain, t, &camera_names(&cameras));
    let Some(camera) = cameras.get(explain.pasted.camera).or(cameras.first()) else { return };
    let mut stated = stated(model, explain);
    stated.image = explain.pasted.image.or(camera.image).unwrap_or(stated.image);
    match recognise(camera, &stated, model.desk.shown.draft()) {
        Err(error) => refused(ui, model, explain, camera, &stated, &error),
        Ok(found) => recognised(ui, model, explain, t, &found),
    }
    // What isn't in the camera is seen before it's taken.
    for left in camera.left_out.iter().filter(|left| left.why.changes_image() != Some(false)) {
        note(ui, &format!("• {}: {}", crate::sanitize::escaped(&left.name), dialects::left_out(lang, left)));
    }
    if cameras.len() > 1 && ui.button(t.take_all).explained(t.take_all_hint).clicked() {
        take_all(model, explain, &cameras, &stated);
    }
}

/// Makes the first camera that of the figure, and the others its list.
fn take_all(model: &mut Model, explain: &Explain, cameras: &[Pasted], stated: &Stated) {
    let stated = Stated { image: model.desk.shown.figure().image, ..*stated };
    let mut taken = model.desk.shown.figure().clone();
    taken.take_cameras(cameras, &stated, explain.pasted.image);
    if taken.image != model.desk.shown.figure().image {
        model.desk.shown.edit(|figure| figure.image = taken.image);
    }
    take(model, taken.camera);
    model.desk.shown.edit_cameras(|figure| {
        (figure.cameras, figure.tag, figure.compare, figure.lens) =
            (taken.cameras, taken.tag, taken.compare, taken.lens);
    });
}

/// A choice among the cameras of a file. A text with one camera has none.
fn which_camera(ui: &mut egui::Ui, explain: &mut Explain, t: &Texts, names: &[String]) {
    let chosen = &mut explain.pasted.camera;
    if *chosen >= names.len() {
        *chosen = 0;
    }
    if names.is_empty() {
        return;
    }
    let names: Vec<_> = names.iter().map(|name| crate::sanitize::escaped(name).to_string()).collect();
    let options: Vec<(usize, &str)> = names.iter().map(String::as_str).enumerate().collect();
    choice_row(ui, t.camera, t.camera_hint, chosen, &options);
}

/// The chosen part of the reading.
fn stated(model: &Model, explain: &Explain) -> Stated {
    let pasted = &explain.pasted;
    let ndc = model.settings.conventions.ndc;
    Stated {
        kind: pasted.kind,
        axes: pasted.axes.filter(|_| pasted.kind.is_none_or(MatrixKind::has_pose)),
        by_columns: pasted.transposed,
        // That of OpenGL is the one you have if you chose none.
        ndc: (ndc != Ndc::default()).then(|| ndc.into()),
        image: pasted.image.unwrap_or(model.desk.shown.figure().image),
    }
}

/// Its kind, its axes, and its notation.
fn choices(ui: &mut egui::Ui, explain: &mut Explain, t: &Texts) {
    let pasted = &mut explain.pasted;
    let mut kinds = vec![(None, t.recognise)];
    kinds.extend(MatrixKind::ALL.map(|kind| (Some(kind), dialects::kind(t.lang, kind))));
    choice_row(ui, t.kind, t.kind_hint, &mut pasted.kind, &kinds);
    if pasted.kind.is_none_or(MatrixKind::has_pose) {
        let mut axes = vec![(None, t.recognise)];
        axes.extend(Axes::ALL.map(|axes| (Some(axes), axes.title)));
        let hint = format!("{}\n{}", t.axes_hint, conventions::axes_table(t.lang, |axes| axes.title));
        choice_row(ui, t.axes, &hint, &mut pasted.axes, &axes);
    }
    ui.checkbox(&mut pasted.transposed, t.transposed).explained(t.transposed_hint);
}

/// The reason why it isn't the matrix of a camera, and the kinds of which it would be one.
fn refused(
    ui: &mut egui::Ui,
    model: &Model,
    explain: &mut Explain,
    camera: &Pasted,
    stated: &Stated,
    error: &RecoveryError,
) {
    let lang = model.settings.lang;
    complaint(ui, &dialects::recovery_error(lang, error));
    if matches!(error, RecoveryError::Depths { .. }) || stated.kind.is_none() {
        return;
    }
    // The other way of writing matrices is the usual reason, the kind the next one.
    let turned = Stated { by_columns: !stated.by_columns, ..*stated };
    if recognise(camera, &turned, model.desk.shown.draft()).is_ok() {
        ui.label(dialects::texts(lang).try_transposed);
        return;
    }
    let open = Stated { kind: None, axes: None, by_columns: false, ..*stated };
    if let Ok(found) = recognise(camera, &open, model.desk.shown.draft()) {
        read_as(ui, model, explain, &[found.best().reading.kind]);
    }
}

/// The way it was read, the values that it leaves open, and its camera.
fn recognised(ui: &mut egui::Ui, model: &mut Model, explain: &mut Explain, t: &Texts, found: &Recognised) {
    let (lang, best) = (t.lang, found.best());
    let reading = best.reading;
    ui.label(dialects::reading(lang, best, found.evidence));
    let reasons: Vec<String> = best.reasons.iter().map(|reason| dialects::reason(lang, *reason)).collect();
    if matches!(found.evidence, Evidence::Nothing | Evidence::Only) && !reasons.is_empty() {
        note(ui, &format!("{}: {}", t.why, reasons.join(", ")));
    }
    if reading.kind.has_pose() {
        note(ui, &conventions::axes_row(lang, reading.axes));
    }
    // The buttons below offer the other kinds.
    for assumed in found.assumed.iter().filter(|assumed| !matches!(assumed, Assumed::Kind(_))) {
        note(ui, &format!("• {}", dialects::assumed(lang, found, *assumed)));
    }
    read_as(ui, model, explain, &found.others);
    if reading.kind.has_pixels() {
        image(ui, model, explain, t);
    }
    for unknown in &best.found.unknown {
        note(ui, &format!("• {}", dialects::unknown(lang, *unknown)));
    }
    if let Ok(camera) = Camera::new(&best.found.parameters) {
        camera_found(ui, model, &camera, &reading);
    }
    if ui.button(t.take).explained(t.take_hint).clicked() {
        if reading.kind.has_pixels() && reading.image != model.desk.shown.figure().image {
            model.desk.shown.edit(|figure| figure.image = reading.image);
        }
        take(model, best.found.parameters);
    }
}

/// A small sentence whose symbols have subscripts. Screen readers read it as written.
fn note(ui: &mut egui::Ui, text: &str) {
    let job = theme::sentence(ui, text, &egui::TextStyle::Small, ui.visuals().text_color());
    let response = ui.add(egui::Label::new(job).wrap());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, text));
}

/// A button for each other kind in which it gives a camera.
fn read_as(ui: &mut egui::Ui, model: &Model, explain: &mut Explain, others: &[MatrixKind]) {
    let t = dialects::texts(model.settings.lang);
    if others.is_empty() {
        return;
    }
    ui.horizontal_wrapped(|ui| {
        ui.label(t.instead);
        for kind in others {
            if ui.button(dialects::kind(t.lang, *kind)).explained(t.instead_hint).clicked() {
                explain.pasted.kind = Some(*kind);
            }
        }
    });
}

/// The size of the image that K is for.
fn image(ui: &mut egui::Ui, model: &Model, explain: &mut Explain, t: &Texts) {
    let own = model.desk.shown.figure().image;
    let old = explain.pasted.image.unwrap_or(own);
    let mut sides = [old.width, old.height].map(f64::from);
    row(ui, "m × n", t.image, t.image_hint, |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (name, side) in ["m", "n"].into_iter().zip(&mut sides) {
            let field = NumberField::new(format!("{} {name}", t.image), Step::Add(16.0))
                .whole()
                .within(1.0..=f64::from(MAX_SIDE));
            field.hint(t.image_hint).width(62.0).show(ui, window::texts(t.lang), side);
        }
    });
    let [width, height] = sides.map(whole);
    let new = ImageSize { width, height };
    if new != old {
        explain.pasted.image = (new != own).then_some(new);
    }
}

/// C, DOP and, for K, its numbers, to compare with those of the program.
fn camera_found(ui: &mut egui::Ui, model: &Model, camera: &Camera, reading: &Reading) {
    let (mark, digits) = (model.settings.lang.mark(), model.settings.digits);
    let mut lines = Vec::new();
    if reading.kind.has_pose() {
        for (name, vector) in [("C", camera.position()), ("DOP", camera.direction_of_projection())] {
            lines.push(format!("{name} = {}", mark.tuple(&vector.to_array(), digits)));
        }
    }
    if reading.kind.has_pixels()
        && let Ok(vocabulary) = Vocabulary::Pinhole.lines(camera, reading.image)
    {
        let numbers = vocabulary.iter().filter(|line| line.name == "K").flat_map(|line| &line.arguments);
        let numbers = numbers.filter(|argument| argument.name != "skew");
        lines.push(
            numbers.map(|a| format!("{} = {}", a.name, mark.number(a.value, digits))).collect::<Vec<_>>().join(", "),
        );
    }
    for line in lines {
        note(ui, &line);
    }
}
