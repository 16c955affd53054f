//! Fonts, sizes and colours of the window.

use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{
    self, Color32, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Stroke, Style, TextStyle, Visuals,
};

use crate::appearance::Theme;
use crate::numerics::health::Level;
use crate::text::{self, runs};

/// Letters for titles and the heads of sections: Latin, Greek and the signs of mathematics.
const BOLD_BYTES: &[u8] = font!("DejaVuSans-Bold.ttf");
/// Code and columns of numbers.
const MONOSPACED_BYTES: &[u8] = font!("DejaVuSansMono.ttf");

/// The sign of egui's own button that copies a colour (`dist/clipboard.py`).
const CLIPBOARD: &[u8] = include_bytes!("../../../assets/fonts/Clipboard.ttf");

fn bold_family() -> FontFamily {
    FontFamily::Name("bold".into())
}

/// Bold letters of a size, for the head of a section.
pub fn bold(size: f32) -> FontId {
    FontId::new(size, bold_family())
}

/// `DejaVu` first, because it has the Portuguese accents, the Greek letters and the mathematical signs of the notes.
pub fn install_fonts(ctx: &egui::Context) {
    let mut fonts = FontDefinitions::default();
    let faces: [(&str, &'static [u8], FontFamily); 3] = [
        ("DejaVu Sans Bold", BOLD_BYTES, bold_family()),
        ("DejaVu Sans", text::FONT_BYTES, FontFamily::Proportional),
        ("DejaVu Sans Mono", MONOSPACED_BYTES, FontFamily::Monospace),
    ];
    for (name, bytes, family) in faces {
        fonts.font_data.insert(name.to_owned(), std::sync::Arc::new(FontData::from_static(bytes)));
        fonts.families.entry(family).or_default().insert(0, name.to_owned());
    }
    fonts.font_data.insert("Clipboard".to_owned(), std::sync::Arc::new(FontData::from_static(CLIPBOARD)));
    fonts.families.entry(FontFamily::Proportional).or_default().push("Clipboard".to_owned());
    for family in [FontFamily::Monospace, bold_family()] {
        fonts.families.entry(family).or_default().push("DejaVu Sans".to_owned());
    }
    super::mathematics::add_fonts(&mut fonts);
    ctx.set_fonts(fonts);
}

/// A symbol with subscripts as in the pictures.
pub fn symbol(ui: &egui::Ui, text: &str) -> LayoutJob {
    lowered(ui, text, &TextStyle::Body, ui.visuals().strong_text_color())
}

/// A symbol that opens something with a click, in the colour of links. The keyboard skips it, because F1 on its field
/// does the same.
pub fn linked_symbol(ui: &mut egui::Ui, text: &str) -> egui::Response {
    let job = lowered(ui, text, &TextStyle::Body, ui.visuals().hyperlink_color);
    let response = ui.add(egui::Label::new(job).selectable(false).sense(egui::Sense::CLICK | egui::Sense::HOVER));
    if response.hovered() {
        let under = Stroke::new(1.0, ui.visuals().hyperlink_color);
        ui.painter().hline(response.rect.x_range(), response.rect.bottom() - 1.0, under);
    }
    response.on_hover_cursor(egui::CursorIcon::PointingHand)
}

/// A text with subscripts as in the pictures.
pub fn lowered(ui: &egui::Ui, text: &str, style: &TextStyle, color: Color32) -> LayoutJob {
    let font = style.resolve(ui.style());
    let low = FontId::new(font.size * 0.75, font.family.clone());
    let mut job = LayoutJob::default();
    for run in runs(text) {
        let (font_id, valign) =
            if run.lowered { (low.clone(), egui::Align::BOTTOM) } else { (font.clone(), egui::Align::Center) };
        job.append(run.text, 0.0, TextFormat { font_id, color, valign, ..Default::default() });
    }
    job
}

/// A sentence in which symbols have subscripts, M_v and z_n. The names of keys and files stay as they are.
pub fn sentence(ui: &egui::Ui, text: &str, style: &TextStyle, color: Color32) -> LayoutJob {
    let is_of_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut marked = String::with_capacity(text.len() + 8);
    for part in text.split_inclusive(|c| !is_of_word(c)) {
        let (word, end) = part.split_at(part.find(|c| !is_of_word(c)).unwrap_or(part.len()));
        match word.split_once('_') {
            Some((letter, below)) if letter.chars().count() == 1 && (1..=3).contains(&below.len()) => {
                marked.push_str(&format!("{letter}_{{{below}}}"));
            }
            _ => marked.push_str(&word.replace('_', "\\_")),
        }
        marked.push_str(end);
    }
    lowered(ui, &marked, style, color)
}

/// A label with such a sentence, which wraps. Screen readers read it as written.
pub fn sentence_label(ui: &mut egui::Ui, text: &str) -> egui::Response {
    let job = sentence(ui, text, &TextStyle::Body, ui.visuals().text_color());
    let response = ui.add(egui::Label::new(job).wrap().selectable(false));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, text));
    response
}

/// A label that wraps, with subscripts as in the pictures. Screen readers read it as written.
pub fn wrapped(ui: &mut egui::Ui, text: &str, style: &TextStyle, color: Color32) -> egui::Response {
    let job = lowered(ui, text, style, color);
    let response = ui.add(egui::Label::new(job).wrap());
    let said = text.replace(['{', '}'], "");
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, &said));
    response
}

/// Makes the header of a section a quiet bar, so that it doesn't look like a field.
pub fn tint_header(ui: &mut egui::Ui) {
    let visuals = ui.visuals_mut();
    visuals.collapsing_header_frame = true;
    let bar = if visuals.dark_mode { Color32::from_rgb(0x2b, 0x33, 0x3e) } else { Color32::from_rgb(0xdf, 0xe6, 0xee) };
    let widgets = &mut visuals.widgets;
    for state in [&mut widgets.inactive, &mut widgets.open] {
        state.weak_bg_fill = bar;
        state.bg_fill = bar;
        state.bg_stroke = Stroke::NONE;
    }
}

/// Gives a slider a visible rail.
pub fn strengthen_rail(ui: &mut egui::Ui) {
    let border = ui.visuals().widgets.noninteractive.bg_stroke.color;
    let widgets = &mut ui.visuals_mut().widgets;
    for state in [&mut widgets.inactive, &mut widgets.hovered, &mut widgets.active] {
        state.bg_fill = border;
    }
}

/// Sizes and colours of both themes.
pub fn install_style(ctx: &egui::Context) {
    ctx.set_visuals_of(egui::Theme::Light, light());
    ctx.set_visuals_of(egui::Theme::Dark, dark());
    ctx.all_styles_mut(sizes);
    // The keys are commands, so that the menu shows them.
    ctx.options_mut(|options| options.zoom_with_keyboard = false);
}

/// The least size of a control for a pointer, in points.
pub(in crate::gui) const INTERACT_SIZE: egui::Vec2 = egui::vec2(32.0, 22.0);

fn sizes(style: &mut Style) {
    style.text_styles = [
        (TextStyle::Small, FontId::proportional(10.5)),
        (TextStyle::Body, FontId::proportional(12.5)),
        (TextStyle::Button, FontId::proportional(12.5)),
        (TextStyle::Heading, bold(15.0)),
        (TextStyle::Monospace, FontId::monospace(11.5)),
    ]
    .into();
    let spacing = &mut style.spacing;
    spacing.item_spacing = egui::vec2(6.0, 4.0);
    spacing.button_padding = egui::vec2(6.0, 2.0);
    spacing.interact_size = INTERACT_SIZE;
    spacing.icon_width = 15.0;
    spacing.tooltip_width = 340.0;
    spacing.scroll = egui::style::ScrollStyle {
        foreground_color: true,
        dormant_background_opacity: 0.0,
        dormant_handle_opacity: 0.35,
        active_background_opacity: 0.3,
        ..egui::style::ScrollStyle::thin()
    };
    style.animation_time = 0.0;
    style.interaction.tooltip_delay = 0.4;
}

/// The differences between the themes.
struct ThemePalette {
    panel: Color32,
    field: Color32,
    button: Color32,
    hovered: Color32,
    border: Color32,
    strong_border: Color32,
    text: Color32,
    weak: Color32,
    accent: Color32,
    selected: Color32,
    error: Color32,
    warning: Color32,
}

/// The colours of the window in a theme. That of print has the strongest contrast.
pub(in crate::gui) fn visuals(theme: Theme) -> Visuals {
    match theme {
        Theme::Light => light(),
        Theme::Dark => dark(),
        Theme::Print => {
            let mut v = light();
            (v.panel_fill, v.window_fill) = (Color32::WHITE, Color32::WHITE);
            (v.override_text_color, v.weak_text_color) = (Some(Color32::BLACK), Some(Color32::BLACK));
            v.hyperlink_color = Color32::from_rgb(0x00, 0x3a, 0x75);
            let widgets = &mut v.widgets;
            for state in [&mut widgets.noninteractive, &mut widgets.inactive] {
                state.bg_stroke.color = Color32::BLACK;
            }
            v
        }
    }
}

fn light() -> Visuals {
    dress(
        Visuals::light(),
        &ThemePalette {
            panel: Color32::from_rgb(0xf5, 0xf6, 0xf8),
            field: Color32::WHITE,
            button: Color32::from_rgb(0xff, 0xff, 0xff),
            hovered: Color32::from_rgb(0xe6, 0xee, 0xf7),
            border: Color32::from_rgb(0xc4, 0xca, 0xd3),
            strong_border: Color32::from_rgb(0x5b, 0x7a, 0x9d),
            text: Color32::from_rgb(0x1d, 0x22, 0x2b),
            weak: Color32::from_rgb(0x5a, 0x63, 0x70),
            accent: Color32::from_rgb(0x0a, 0x5c, 0xa8),
            selected: Color32::from_rgb(0xcd, 0xe2, 0xf6),
            error: Color32::from_rgb(0xb0, 0x1e, 0x1e),
            warning: Color32::from_rgb(0x8a, 0x4b, 0x00),
        },
    )
}

fn dark() -> Visuals {
    dress(
        Visuals::dark(),
        &ThemePalette {
            panel: Color32::from_rgb(0x1c, 0x1f, 0x24),
            field: Color32::from_rgb(0x12, 0x14, 0x18),
            button: Color32::from_rgb(0x2a, 0x2f, 0x37),
            hovered: Color32::from_rgb(0x37, 0x40, 0x4c),
            border: Color32::from_rgb(0x43, 0x4a, 0x55),
            strong_border: Color32::from_rgb(0x7f, 0xa6, 0xcf),
            text: Color32::from_rgb(0xe8, 0xeb, 0xef),
            weak: Color32::from_rgb(0xa4, 0xad, 0xb9),
            accent: Color32::from_rgb(0x7c, 0xbc, 0xf7),
            selected: Color32::from_rgb(0x1f, 0x4e, 0x79),
            error: Color32::from_rgb(0xff, 0x8f, 0x85),
            warning: Color32::from_rgb(0xff, 0xc2, 0x66),
        },
    )
}

fn dress(mut v: Visuals, p: &ThemePalette) -> Visuals {
    v.panel_fill = p.panel;
    v.window_fill = p.panel;
    v.extreme_bg_color = p.field;
    v.text_edit_bg_color = Some(p.field);
    v.weak_text_color = Some(p.weak);
    v.hyperlink_color = p.accent;
    v.error_fg_color = p.error;
    v.warn_fg_color = p.warning;
    v.selection.bg_fill = p.selected;
    v.selection.stroke = Stroke::new(1.0, p.text);
    v.window_stroke = Stroke::new(1.0, p.border);
    v.slider_trailing_fill = false;
    v.indent_has_left_vline = false;
    let radius = CornerRadius::same(3);
    let w = &mut v.widgets;
    w.noninteractive.bg_stroke = Stroke::new(1.0, p.border);
    w.noninteractive.fg_stroke = Stroke::new(1.0, p.text);
    w.noninteractive.bg_fill = p.panel;
    for (state, fill, border) in [
        (&mut w.inactive, p.button, p.border),
        (&mut w.hovered, p.hovered, p.strong_border),
        (&mut w.active, p.selected, p.accent),
        (&mut w.open, p.hovered, p.strong_border),
    ] {
        state.bg_fill = fill;
        state.weak_bg_fill = fill;
        state.bg_stroke = Stroke::new(1.0, border);
        state.fg_stroke = Stroke::new(1.0, p.text);
        state.corner_radius = radius;
        state.expansion = 0.0;
    }
    v
}

/// The colour of right and wrong answers.
pub(in crate::gui) fn verdict_color(ui: &egui::Ui, right: bool) -> Color32 {
    match (right, ui.visuals().dark_mode) {
        (false, _) => ui.visuals().error_fg_color,
        (true, true) => Color32::from_rgb(0x6c, 0xc6, 0x7a),
        (true, false) => Color32::from_rgb(0x1e, 0x7a, 0x34),
    }
}

/// The colour of a level of health.
pub(in crate::gui) fn level_color(ui: &egui::Ui, level: Level) -> Color32 {
    match level {
        Level::Good => ui.visuals().text_color(),
        Level::Fair => ui.visuals().warn_fg_color,
        Level::Poor => ui.visuals().error_fg_color,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_signs_of_egui_s_own_buttons_are_there() {
        let ctx = egui::Context::default();
        install_fonts(&ctx);
        let _ = ctx.run_ui(egui::RawInput::default(), |_| {});
        let font = FontId::proportional(12.5);
        assert!(ctx.fonts_mut(|fonts| fonts.has_glyph(&font, '📋')));
    }
}
