//! The choice of NDC, of one to compare with, and of the notation of matrices.

use eframe::egui;

use crate::camera::{Api, Ndc};
use crate::gui::kit::{Explained, choice_row, complaint};
use crate::gui::why::state::explain::Explain;
use camera_lab_words::why::conventions::{self, Texts, finite_instead};

/// Shows the choices. Below them come the numbers that depend on them.
pub(in crate::gui::why) fn ui(ui: &mut egui::Ui, model: &mut camera_lab_desk::Model, _explain: &mut Explain) {
    let t = conventions::texts(model.settings.lang);
    let camera = model.desk.shown.camera();
    let shown = &mut model.settings.conventions;
    let mut ndc = Some(shown.ndc);
    one(ui, t, (t.ndc, t.ndc_hint), &mut ndc, false);
    shown.ndc = ndc.unwrap_or_default();
    one(ui, t, (t.compared, t.compared_hint), &mut shown.compared, true);
    for error in [Some(shown.ndc), shown.compared].into_iter().flatten().filter_map(|ndc| camera.clip_space(ndc).err())
    {
        complaint(ui, &finite_instead(t.lang, error));
    }
    for (on, name, hint, said) in [
        (&mut shown.row_vectors, t.row_vectors, t.row_vectors_hint, t.row_vectors_said),
        (&mut shown.left_handed, t.left_handed, t.left_handed_hint, t.left_handed_said),
    ] {
        ui.checkbox(on, name).explained(hint);
        if *on {
            ui.label(egui::RichText::new(said).small().weak());
        }
    }
    ui.separator();
}

/// A library, reversed, without a far plane. With `or_none` also none.
fn one(ui: &mut egui::Ui, t: &Texts, (name, hint): (&str, &str), value: &mut Option<Ndc>, or_none: bool) {
    let mut options: Vec<(Option<Api>, &str)> = Api::ALL.map(|api| (Some(api), api.title())).to_vec();
    if or_none {
        options.insert(0, (None, t.nobody));
    }
    let mut api = value.map(|ndc| ndc.api);
    choice_row(ui, name, hint, &mut api, &options);
    *value = api.map(|api| Ndc { api, ..value.unwrap_or_default() });
    let Some(ndc) = value else { return };
    ui.horizontal(|ui| {
        for (on, text, hint) in
            [(&mut ndc.reversed, t.reversed, t.reversed_hint), (&mut ndc.infinite, t.infinite, t.infinite_hint)]
        {
            ui.checkbox(on, text).explained(hint).accessible_name(format!("{name}: {text}"));
        }
    });
}
