//! The export dialog, with a preview of the picture.

use eframe::egui::accesskit::Role;
use eframe::egui::{self, Color32, Id, Key, Modifiers, Rect, RichText, Sense, Vec2, WidgetInfo, vec2};

use super::family;
use super::preview::{Preview, can_be_copied};
use crate::appearance::Theme;
use crate::camera::ImageSize;
use crate::export::format::PictureFormat;
use crate::export::paper::PaperPreset;
use crate::gui::export::family_choice::FamilyChoice;
use crate::gui::export::{Export, ExportSource, Paper, as_letters};
use crate::gui::kit::{
    Explained, FieldError, NumberField, Pressed, Step, buttons, choice, choice_row, complaint, number_field, row, whole,
};
use crate::limits::{MAX_SIDE, PAPER_CM, PAPER_DPI, PAPER_LETTERS, PAPER_LINES};
use crate::picture::Faces;
use crate::sanitize;
use crate::text::face;
use crate::views::{View, Views};
use camera_lab_desk::Model;
use camera_lab_words::window::Texts;
use camera_lab_words::{families, pictures};

/// The width of the settings, of the preview beside them and of both with the gap, in points.
const SETTINGS: f32 = 360.0;
const PICTURE: Vec2 = vec2(360.0, 240.0);
const BETWEEN: f32 = 20.0;
/// For a scroll bar.
const BAR: f32 = 10.0;
pub(in crate::gui) const WIDTH: f32 = SETTINGS + BETWEEN + PICTURE.x + BAR;

/// The height of the settings, if the window has it: with paper and vectors.
const SETTINGS_HIGH: f32 = 430.0;

/// The height of the parts above and below the settings, in points.
const AROUND: f32 = 130.0;

/// The choice of m × n pixels, which are typed ones from then on.
const PIXELS_OF_IMAGE: (Option<u32>, bool) = (Some(0), false);

/// The narrowest picture that deserves its room.
const LEAST_PICTURE: f32 = 120.0;

/// The parts of the window's state that the dialog changes.
pub(in crate::gui) struct Choices<'a> {
    /// The exported family.
    pub(in crate::gui) family: &'a mut FamilyChoice,
    /// The settings of the last export.
    pub(in crate::gui) last: &'a mut Export,
    /// The preview.
    pub(in crate::gui) preview: &'a mut Option<Preview>,
}

/// Asks for the settings, and returns the pressed button. The file comes next.
pub(in crate::gui) fn show(
    ui: &mut egui::Ui,
    t: &'static Texts,
    model: &Model,
    choices: &mut Choices<'_>,
    export: &mut Export,
    first: bool,
) -> Pressed {
    let mut enter = !first && enter(ui);
    let is_family = choices.family.variations().is_some();
    if first && is_family {
        family::take_keyboard(ui.ctx(), t, choices.family);
    } else if first && export.on_paper {
        number_field::take_keyboard(ui.ctx(), t.export_width_cm);
    }
    ui.heading(t.export_heading);
    ui.add_space(6.0);
    let room = (ui.available_width() - SETTINGS - BETWEEN - BAR).min(PICTURE.x);
    // Of one height, so that the dialog keeps its place. In a low window the settings scroll, and the buttons stay
    // visible.
    let height = (ui.ctx().content_rect().height() - AROUND).clamp(LEAST_PICTURE, SETTINGS_HIGH);
    let area = egui::ScrollArea::vertical().max_height(height).min_scrolled_height(height).auto_shrink(false);
    let row = |ui: &mut egui::Ui| {
        ui.spacing_mut().item_spacing.x = BETWEEN;
        let width = SETTINGS.min(ui.available_width());
        let column = |ui: &mut egui::Ui| {
            ui.set_width(width);
            ui.spacing_mut().item_spacing.x = 8.0;
            settings(ui, t, model, choices, export, &mut enter)
        };
        let errors = ui.vertical(column).inner;
        if room >= LEAST_PICTURE {
            ui.vertical(|ui| {
                ui.set_width(room);
                picture(ui, t, model, choices, export, (vec2(room, PICTURE.y), errors.is_empty()));
            });
        }
        errors
    };
    let errors = area.show(ui, |ui| ui.horizontal_top(row).inner).inner;
    ui.add_space(10.0);
    // Unless a field has the keyboard.
    let begins = first && !export.on_paper && !is_family;
    let pressed = match buttons(ui, t.cancel, &[t.export_action], begins.then_some(0)) {
        Pressed::Nothing if enter => Pressed::Action(0),
        pressed => pressed,
    };
    match pressed {
        Pressed::Action(_) if errors.is_empty() => {
            *choices.last = *export;
            choices.family.last = choices.family.remembered();
            pressed
        }
        Pressed::Cancel => {
            *choices.last = *export;
            choices.family.leave();
            pressed
        }
        Pressed::Action(_) | Pressed::Nothing => Pressed::Nothing,
    }
}

/// Stores true under this name if a checkbox of the dialog has the focus.
fn on_checkbox() -> Id {
    Id::unique("checkbox of the export dialog has the focus")
}

/// True if Enter exports, because it has no other use there: without a focus, and on checkboxes, which the space bar
/// switches.
fn enter(ui: &egui::Ui) -> bool {
    let free = ui.memory(|memory| memory.focused()).is_none() && !egui::Popup::is_any_open(ui.ctx());
    let on_checkbox = ui.data_mut(|data| data.remove_temp::<bool>(on_checkbox())).is_some();
    (free || on_checkbox) && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter))
}

/// A switch.
fn checkbox(ui: &mut egui::Ui, on: &mut bool, text: impl Into<egui::WidgetText>, hint: &str) {
    let response = ui.checkbox(on, text.into()).explained(hint).explained_disabled(hint);
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(on_checkbox(), true));
    }
}

/// The preview of the picture, its size, and the button that copies it.
fn picture(
    ui: &mut egui::Ui,
    t: &'static Texts,
    model: &Model,
    choices: &mut Choices<'_>,
    export: &Export,
    (room, valid): (Vec2, bool),
) {
    let ctx = ui.ctx().clone();
    let mut preview = choices.preview.take().unwrap_or_default();
    if valid {
        preview.follow(
            &ctx,
            (export, choices.family),
            [room.x, room.y].map(|side| side * ctx.pixels_per_point()),
            || ExportSource::of(model, choices.family, export.theme),
        );
    }
    let (rect, response) = ui.allocate_exact_size(room, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, t.export_preview));
    paint(ui, &preview, rect, export.is_without_ground());
    if preview.texture.is_none() {
        let why = preview.fault.as_ref().map_or_else(|| t.export_drawing.to_owned(), |error| error.text(t.lang, ""));
        // A child of its own, so that the content below doesn't move.
        let middle = egui::Layout::centered_and_justified(egui::Direction::TopDown);
        let place = egui::UiBuilder::new().max_rect(rect.shrink(12.0)).layout(middle);
        ui.new_child(place).add(egui::Label::new(RichText::new(why).weak()).wrap());
    }
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 8.0;
        let copying = preview.is_copying();
        let fits = can_be_copied(export, preview.size.unwrap_or([export.width, export.height]));
        let button = ui.add_enabled(valid && fits && !copying, egui::Button::new(t.export_copy));
        let hint = match (fits, export.format.is_vector()) {
            (true, false) => t.export_copy_hint,
            (true, true) => t.export_copy_svg_hint,
            (false, _) => t.export_copy_too_large,
        };
        if button.explained(hint).explained_disabled(hint).clicked() {
            *choices.last = *export;
            let subject = ExportSource::of(model, choices.family, export.theme);
            preview.copy(&ctx, export, subject);
        }
        match &preview.copied {
            _ if copying => {
                ui.label(t.export_drawing);
            }
            Some(Ok(())) => {
                ui.label(t.copied);
            }
            Some(Err(error)) => complaint(ui, &error.text(t.lang, "")),
            None => {}
        }
    });
    if !preview.left_out.is_empty() && preview.crowded.is_none() {
        let names = preview.left_out.iter().map(|text| text.chars().map(|c| face(c, false).1).collect::<String>());
        let names = names.collect::<Vec<_>>().join(", ");
        let text = format!("⚠ {} {}", t.export_left_out, sanitize::within(&names, 120));
        ui.add(egui::Label::new(RichText::new(text).color(ui.visuals().warn_fg_color)).wrap());
    }
    if let Some(crowded) = &preview.crowded {
        let text = format!("⚠ {}", pictures::crowded(t.lang, crowded));
        ui.add(egui::Label::new(RichText::new(text).color(ui.visuals().warn_fg_color)).wrap());
    }
    *choices.preview = Some(preview);
}

/// The picture in the middle of a place, on a chequered ground if it has none of its own.
fn paint(ui: &egui::Ui, preview: &Preview, room: Rect, transparent: bool) {
    let painter = ui.painter().with_clip_rect(room.expand(1.0).intersect(ui.clip_rect()));
    let border = ui.visuals().widgets.noninteractive.bg_stroke;
    let Some(texture) = &preview.texture else {
        painter.rect_stroke(room, 0.0, border, egui::StrokeKind::Inside);
        return;
    };
    let size = texture.size_vec2();
    let factor = (room.width() / size.x).min(room.height() / size.y).min(1.0 / ui.ctx().pixels_per_point());
    let rect = Rect::from_center_size(room.center(), size * factor);
    if transparent {
        chequers(&painter.with_clip_rect(rect), rect);
    }
    let whole = Rect::from_min_max(egui::Pos2::ZERO, egui::pos2(1.0, 1.0));
    painter.image(texture.id(), rect, whole, Color32::WHITE);
    painter.rect_stroke(rect, 0.0, border, egui::StrokeKind::Outside);
}

/// Squares of two greys, the sign of transparency in image editors.
fn chequers(painter: &egui::Painter, rect: Rect) {
    const SIDE: f32 = 8.0;
    painter.rect_filled(rect, 0.0, Color32::from_gray(250));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few squares")]
    let count = |length: f32| (length / SIDE).ceil() as u16;
    for row in 0..count(rect.height()) {
        for column in (row % 2..count(rect.width())).step_by(2) {
            let at = rect.min + SIDE * vec2(f32::from(column), f32::from(row));
            painter.rect_filled(Rect::from_min_size(at, Vec2::splat(SIDE)), 0.0, Color32::from_gray(215));
        }
    }
}

/// A field, and the fault of the typed text.
type Fault = (&'static str, FieldError);

/// The settings. Returns the faults of typed texts. `enter` becomes true if Enter is pressed in the width on paper or
/// in the values of a family. A choice adds rows only below itself, so that nothing moves under the pointer.
fn settings(
    ui: &mut egui::Ui,
    t: &'static Texts,
    model: &Model,
    choices: &mut Choices<'_>,
    export: &mut Export,
    enter: &mut bool,
) -> Vec<Fault> {
    let pair = [[t.show_world, t.show_image], [t.show_world, t.show_canonical], [t.show_canonical, t.show_image]]
        .map(|names| names.join(", "));
    let what = [
        (Views::All, t.export_all),
        (Views::Without(View::Canonical), pair[0].as_str()),
        (Views::Without(View::Image), pair[1].as_str()),
        (Views::Without(View::World), pair[2].as_str()),
        (Views::One(View::World), t.show_world),
        (Views::One(View::Canonical), t.show_canonical),
        (Views::One(View::Image), t.show_image),
    ];
    choice_row(ui, t.export_what, "", &mut export.what, &what);
    formats(ui, t, export);
    let themes = [(Theme::Print, t.theme_print), (Theme::Light, t.theme_light), (Theme::Dark, t.theme_dark)];
    choice_row(ui, t.theme_name, t.export_theme_hint, &mut export.theme, &themes);
    let ImageSize { width: m, height: n } = model.desk.shown.figure().image;
    let pixels_of_image = format!("m × n = {m} × {n}");
    let mut sizes = vec![
        ((Some(1), false), "1 ×"),
        ((Some(2), false), "2 ×"),
        ((Some(3), false), "3 ×"),
        ((Some(4), false), "4 ×"),
        ((None, false), t.export_typed),
        ((None, true), t.export_paper),
    ];
    if export.what == Views::One(View::Image) {
        sizes.push((PIXELS_OF_IMAGE, &pixels_of_image));
    }
    let mut size = (export.times.filter(|_| !export.on_paper), export.on_paper);
    choice_row(ui, t.export_size, t.export_size_hint, &mut size, &sizes);
    if size == PIXELS_OF_IMAGE {
        size = (None, false);
        (export.width, export.height, export.scale) = (m, n, 1.0);
    }
    (export.times, export.on_paper) = size;
    let mut errors = if export.on_paper { paper(ui, t, export, enter) } else { Vec::new() };
    export.fit_screen(model.frame.picture_sizes, model.frame.screen_scale);
    // A family in multiples of the screen is larger than its figure.
    let of_family = choices.preview.as_ref().and_then(|preview| preview.size);
    let of_family = of_family.filter(|_| size.0.is_some() && choices.family.variations().is_some());
    errors.extend(row(ui, "", t.export_pixels, "", |ui| {
        if size == (None, false) {
            return pixels(ui, t, export);
        }
        let [width, height] = of_family.unwrap_or([export.width, export.height]);
        ui.label(format!("{width} × {height}"));
        // The preview shows the faults of a family.
        let fault = if of_family.is_some() { None } else { too_large([width, height]) };
        fault.map(|fault| (t.export_pixels, fault)).into_iter().collect()
    }));
    for (field, error) in &errors {
        complaint(ui, &format!("{field}: {}", error.text(t.lang)));
    }
    let faces = [
        (Faces::Auto, t.export_faces_auto),
        (Faces::Areas, t.export_faces_areas),
        (Faces::Picture, t.export_faces_picture),
    ];
    if export.format.is_vector() {
        row(ui, "", t.export_faces, t.export_faces_hint, |ui| {
            choice(ui, t.export_faces, t.export_faces_hint, &mut export.faces, &faces);
            checkbox(ui, &mut export.outlines, t.export_outlines, t.export_outlines_hint);
        });
    }
    ui.add_space(4.0);
    let able = export.format.has_transparency();
    ui.add_enabled_ui(able, |ui| {
        let hint = if able { t.export_transparent_hint } else { t.export_opaque_hint };
        // A format without transparency shows the effect, and keeps the setting.
        let mut shown = export.is_without_ground();
        checkbox(ui, &mut shown, t.export_transparent, hint);
        if able {
            export.transparent = shown;
        }
    });
    checkbox(ui, &mut export.crop, t.export_crop, t.export_crop_hint);
    family::rows(ui, t, choices.family, enter);
    ui.label(RichText::new(t.export_note).small().weak());
    errors
}

/// The formats side by side. A format for paper asks for its width there.
fn formats(ui: &mut egui::Ui, t: &'static Texts, export: &mut Export) {
    row(ui, "", t.export_format, t.export_format_hint, |ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        for format in PictureFormat::ALL {
            let chosen = ui.selectable_value(&mut export.format, format, format.name());
            if chosen.explained(t.export_format_hint).clicked() && format.is_for_paper() {
                export.on_paper = true;
                number_field::take_keyboard(ui.ctx(), t.export_width_cm);
            }
        }
    });
}

/// The size on paper. Returns the faults of typed texts. `enter` becomes true if Enter is pressed in the width.
fn paper(ui: &mut egui::Ui, t: &'static Texts, export: &mut Export, enter: &mut bool) -> Vec<Fault> {
    let mut field = |ui: &mut egui::Ui, name: &'static str, range, value: &mut f64| {
        let field = NumberField::new(name, Step::Add(1.0)).within(range).width(64.0);
        let output = field.show(ui, t, value);
        *enter |= output.entered && name == t.export_width_cm;
        output.error.map(|error| (name, error))
    };
    let paper = &mut export.paper;
    let mut errors = Vec::new();
    preset(ui, t, paper);
    row(ui, "", t.export_centimetres, "", |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        errors.extend(field(ui, t.export_width_cm, PAPER_CM, &mut paper.size[0]));
        ui.label("×");
        errors.extend(field(ui, t.export_height_cm, PAPER_CM, &mut paper.size[1]));
    });
    row(ui, "", t.export_dpi, "", |ui| {
        errors.extend(field(ui, t.export_dpi, PAPER_DPI, &mut paper.dpi));
    });
    row(ui, "", t.export_letters, t.export_letters_hint, |ui| {
        errors.extend(field(ui, t.export_letters, PAPER_LETTERS, &mut paper.letters));
    });
    errors.extend(lines(ui, t, &mut paper.lines, as_letters(paper.letters)));
    errors
}

/// A destination of the picture, which sets its size and its letters.
fn preset(ui: &mut egui::Ui, t: &'static Texts, paper: &mut Paper) {
    let words = families::texts(t.lang);
    let names = PaperPreset::ALL.map(|preset| match preset {
        PaperPreset::Column => words.column,
        PaperPreset::A4 => words.a4,
        PaperPreset::Slide => words.slide,
        PaperPreset::Square => words.square,
    });
    let size = |preset: PaperPreset| {
        let (width, height) = preset.size();
        // A picture of 4 by 3, if the height is free.
        [width, height.unwrap_or(0.75 * width)]
    };
    let is = |preset: &PaperPreset| paper.size == size(*preset) && paper.letters == preset.letters();
    let mut now = PaperPreset::ALL.into_iter().find(is);
    let choices: Vec<(Option<PaperPreset>, &str)> =
        [(None, words.own_size)].into_iter().chain(PaperPreset::ALL.map(Some).into_iter().zip(names)).collect();
    let changed = choice_row(ui, words.paper, words.paper_hint, &mut now, &choices);
    if let Some(preset) = now.filter(|_| changed) {
        (paper.size, paper.letters) = (size(preset), preset.letters());
    }
}

/// The width of lines, which follows the letters as long as it has none of its own. Returns the fault of the typed
/// text.
fn lines(ui: &mut egui::Ui, t: &'static Texts, lines: &mut Option<f64>, as_letters: f64) -> Option<Fault> {
    let mut fault = None;
    row(ui, "", t.export_lines, t.export_lines_hint, |ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        let mut points = lines.unwrap_or(as_letters);
        let mut own = lines.is_some();
        ui.add_enabled_ui(own, |ui| {
            let field = NumberField::new(t.export_lines, Step::Add(0.1)).within(PAPER_LINES).width(64.0);
            fault = field.show(ui, t, &mut points).error.map(|error| (t.export_lines, error));
        });
        checkbox(ui, &mut own, t.export_lines_own, t.export_lines_hint);
        *lines = own.then_some(points);
    });
    fault
}

/// Width and height. Returns the faults of typed texts.
fn pixels(ui: &mut egui::Ui, t: &'static Texts, export: &mut Export) -> Vec<Fault> {
    let [mut width, mut height] = [f64::from(export.width), f64::from(export.height)];
    let sides = 1.0..=f64::from(MAX_SIDE);
    let field = |name: &str| NumberField::new(name, Step::Add(16.0)).whole().within(sides.clone()).width(64.0);
    ui.spacing_mut().item_spacing.x = 4.0;
    let of_width = field(t.export_width).show(ui, t, &mut width);
    ui.label("×");
    let of_height = field(t.export_height).show(ui, t, &mut height);
    (export.width, export.height) = (whole(width), whole(height));
    let beyond = too_large([export.width, export.height]);
    let faults = [(t.export_width, of_width.error), (t.export_height, of_height.error), (t.export_pixels, beyond)];
    faults.into_iter().filter_map(|(field, error)| Some((field, error?))).collect()
}

fn too_large(size: [u32; 2]) -> Option<FieldError> {
    let sides = 1.0..=f64::from(MAX_SIDE);
    size.into_iter().any(|side| !sides.contains(&f64::from(side))).then_some(FieldError::Outside(sides))
}
