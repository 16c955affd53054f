//! Fonts and colours of the window.

use std::sync::Arc;

use eframe::egui::{self, FontData, FontDefinitions, FontFamily};

/// `DejaVu` first: it has the Portuguese accents, the Greek letters and the mathematical signs of the notes.
pub fn install_fonts(ctx: &egui::Context) {
    let mut fonts = FontDefinitions::default();
    let faces: [(&str, &'static [u8], FontFamily); 2] = [
        ("DejaVu Sans", include_bytes!("../../assets/fonts/DejaVuSans.ttf"), FontFamily::Proportional),
        ("DejaVu Sans Mono", include_bytes!("../../assets/fonts/DejaVuSansMono.ttf"), FontFamily::Monospace),
    ];
    for (name, bytes, family) in faces {
        fonts.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(bytes)));
        fonts.families.entry(family).or_default().insert(0, name.to_owned());
    }
    ctx.set_fonts(fonts);
}
