//! The dialog that prints a lesson or exercises, with a preview of the pages.

use eframe::egui::{self, Button, Color32, ComboBox, Rect, RichText, ScrollArea, Sense, Ui, WidgetInfo, vec2};

use crate::gui::kit::{Explained, NumberField, Pressed, Step, buttons, whole};
use crate::gui::learn::Learn;
use crate::gui::learn::handout::form::{HandoutForm, MAX_SEED, played};
use crate::gui::learn::handout::pages::PagesPreview;
use crate::lessons::{OpenLesson, shipped};
use camera_lab_desk::Model;
use camera_lab_words::file_names::name_of_title;
use camera_lab_words::handout::{MAX_VERSIONS, Solutions};
use camera_lab_words::learn::handouts::{Texts, solutions_beside, solutions_file, texts, versions};
use camera_lab_words::learn::{exercises, lessons as words};
use camera_lab_words::{Lang, told, window};

/// The width of the settings, and that of the dialog, in points.
const SETTINGS: f32 = 330.0;
pub(in crate::gui) const WIDTH: f32 = 760.0;
/// The height of everything above and below the settings, in points.
const AROUND: f32 = 150.0;
/// The greatest height of a page, in points.
const PAGE: f32 = 560.0;
/// Width by height of a page.
const SHAPE: f32 = 595.0 / 842.0;

impl HandoutForm {
    /// The name of its file, without an ending.
    pub(in crate::gui) fn stem(&self) -> String {
        let t = texts(self.options.lang);
        let name = match &self.lesson {
            Some(open) => name_of_title(told(self.options.lang, &open.lesson.title)).unwrap_or(open.lesson.id.clone()),
            None => t.file.to_owned(),
        };
        if self.shows_solutions() { format!("{name}-{}", t.file_with_solutions) } else { name }
    }
}

/// Shows the dialog, and returns the pressed button. `first` is true when it has just been opened.
pub(in crate::gui) fn show(
    ui: &mut Ui,
    model: &Model,
    learn: &Learn,
    pages: &mut Option<PagesPreview>,
    form: &mut HandoutForm,
    first: bool,
) -> Pressed {
    let t = texts(model.settings.lang);
    let heading = if form.lesson.is_some() { t.handout } else { t.sheet };
    ui.heading(heading.trim_end_matches('…'));
    ui.add_space(6.0);
    let height = (ui.ctx().content_rect().height() - AROUND).clamp(120.0, PAGE);
    ui.horizontal_top(|ui| {
        ui.vertical(|ui| {
            ui.set_width(SETTINGS.min(ui.available_width()));
            settings(ui, t, model, learn, form, height);
        });
        ui.add_space(12.0);
        ui.vertical(|ui| page(ui, t, learn, pages, form, height));
    });
    ui.add_space(10.0);
    let close = window::texts(model.settings.lang).cancel;
    match buttons(ui, close, &[t.save], first.then_some(0)) {
        Pressed::Action(_) if !form.is_whole() => Pressed::Nothing,
        pressed => pressed,
    }
}

fn settings(ui: &mut Ui, t: &Texts, model: &Model, learn: &Learn, form: &mut HandoutForm, height: f32) {
    let mut is_lesson = form.lesson.is_some();
    ui.horizontal(|ui| {
        ui.selectable_value(&mut is_lesson, true, t.of_lesson);
        ui.selectable_value(&mut is_lesson, false, t.of_exercises);
    });
    if is_lesson != form.lesson.is_some() {
        (form.lesson, form.page) = (is_lesson.then(|| played(learn)).flatten(), 0);
    }
    ui.add_space(4.0);
    let options = &mut form.options;
    ui.horizontal(|ui| {
        ui.label(t.language);
        for lang in Lang::ALL {
            ui.selectable_value(&mut options.lang, lang, lang.name());
        }
    });
    let mut has_answers = options.answers != Solutions::None;
    ui.checkbox(&mut has_answers, t.answers).explained(t.answers_hint);
    options.answers = if has_answers { Solutions::AtEnd } else { Solutions::None };
    match &mut form.lesson {
        Some(open) => {
            ui.checkbox(&mut options.late, t.late).explained(t.late_hint);
            let has_plan = open.lesson.plan.is_some();
            options.plan &= has_plan;
            ui.add_enabled(has_plan, egui::Checkbox::new(&mut options.plan, t.plan))
                .explained(t.plan_hint)
                .explained_disabled(t.no_plan);
            ui.horizontal(|ui| {
                ui.label(t.size);
                ui.selectable_value(&mut options.columns, 1, t.large).explained(t.large_hint);
                ui.selectable_value(&mut options.columns, 2, t.small).explained(t.small_hint);
            });
            ui.add_space(4.0);
            lessons(ui, t, model, learn, open);
        }
        None => {
            ui.horizontal(|ui| {
                let shown = window::texts(model.settings.lang);
                let field = |ui: &mut Ui, name, hint, range: std::ops::RangeInclusive<u32>, seed: &mut u32| {
                    ui.label(name);
                    let mut number = f64::from(*seed);
                    let range = f64::from(*range.start())..=f64::from(*range.end());
                    let field = NumberField::new(name, Step::Add(1.0)).whole().within(range).width(60.0);
                    field.hint(hint).show(ui, shown, &mut number);
                    *seed = whole(number);
                };
                let [first, last] = &mut form.seeds;
                let is_one = first == last;
                field(ui, t.numbers, t.numbers_hint, 0..=MAX_SEED, first);
                let most = (*first + MAX_VERSIONS - 1).min(MAX_SEED);
                *last = if is_one { *first } else { (*last).clamp(*first, most) };
                field(ui, t.until, t.until_hint, *first..=most, last);
            });
            let [first, last] = form.seeds;
            let mut lines =
                if first < last { versions(t.lang, last - first + 1, first, last) } else { t.one_version.to_owned() };
            if first < last && has_answers {
                lines += &format!(". {}", solutions_beside(t.lang, &solutions_file(&form.stem(), form.options.lang)));
            }
            ui.add(egui::Label::new(RichText::new(lines).small().weak()).wrap());
            ui.add_space(4.0);
            ui.label(t.choose);
            chosen_exercises(ui, model, learn, form, height - 172.0);
        }
    }
}

/// The built-in lessons, those of the folder, and the one being played.
fn lessons(ui: &mut Ui, t: &Texts, model: &Model, learn: &Learn, chosen: &mut OpenLesson) {
    let lang = model.settings.lang;
    let of_program = shipped().iter().map(|shipped| OpenLesson { lesson: shipped.lesson.clone(), path: None, step: 0 });
    let of_folder = learn.own.iter().map(|(path, lesson)| (lesson.clone(), Some(path.clone())));
    let of_folder = of_folder.map(|(lesson, path)| OpenLesson { lesson, path, step: 0 });
    let mut all: Vec<OpenLesson> = of_program.chain(of_folder).collect();
    let own = learn.lesson.as_ref().and_then(|_| played(learn));
    all.extend(
        own.filter(|own| all.iter().all(|other| (&other.path, &other.lesson.id) != (&own.path, &own.lesson.id))),
    );
    ui.label(t.lesson);
    let width = ui.available_width() - 2.0 * ui.spacing().item_spacing.x;
    let shown = ComboBox::from_id_salt("lesson of a handout").width(width);
    let shown = shown.selected_text(words::with_minutes(lang, &chosen.lesson)).truncate().show_ui(ui, |ui| {
        for open in all {
            let is_it = open == *chosen;
            if ui.selectable_label(is_it, words::with_minutes(lang, &open.lesson)).clicked() {
                *chosen = open;
            }
        }
    });
    shown.response.accessible_name(t.lesson);
    if let Some(sentence) = &chosen.lesson.sentence {
        ui.add_space(4.0);
        crate::gui::kit::prose::show(ui, told(lang, sentence).trim());
    }
}

/// A switch for each exercise. Their order on the sheet is the order of choosing them.
fn chosen_exercises(ui: &mut Ui, model: &Model, learn: &Learn, form: &mut HandoutForm, height: f32) {
    let lang = model.settings.lang;
    let area = ScrollArea::vertical().max_height(height.max(80.0)).auto_shrink([false, true]);
    let t = texts(lang);
    area.show(ui, |ui| {
        for (heading, is_family) in [(t.with_numbers, true), (t.same_for_all, false)] {
            ui.weak(heading);
            for entry in learn.exercises.entries().filter(|entry| entry.is_family == is_family) {
                let place = form.exercises.iter().position(|id| *id == *entry.id);
                let number = place.map_or_else(String::new, |place| format!("{}. ", place + 1));
                let mut on = place.is_some();
                ui.checkbox(&mut on, format!("{number}{}", exercises::title(lang, entry)));
                match (on, place) {
                    (true, None) => form.exercises.push(entry.id.to_string()),
                    (false, Some(place)) => drop(form.exercises.remove(place)),
                    _ => {}
                }
            }
        }
    });
}

/// The preview of the page, and the ways to the others.
fn page(ui: &mut Ui, t: &Texts, learn: &Learn, shown: &mut Option<PagesPreview>, form: &mut HandoutForm, height: f32) {
    let mut pages = shown.take().unwrap_or_default();
    let height = height - ui.spacing().interact_size.y - ui.spacing().item_spacing.y;
    let size = vec2(height * SHAPE, height).min(vec2(ui.available_width(), ui.available_width() / SHAPE));
    if form.is_whole() {
        let zoom = size.x * ui.pixels_per_point();
        let choices = (form.lesson.clone(), form.exercises.clone(), form.seeds, form.options);
        pages.follow(ui.ctx(), choices, (form.page, zoom), || form.job(learn).first_file());
    }
    let count = pages.count.max(1);
    form.page = form.page.min(count - 1);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(egui::accesskit::Role::Image, true, t.preview));
    ui.painter().rect_filled(rect, 0.0, Color32::WHITE);
    ui.painter().rect_stroke(rect, 0.0, ui.visuals().widgets.noninteractive.bg_stroke, egui::StrokeKind::Outside);
    match pages.texture.as_ref().filter(|_| form.is_whole()) {
        Some(texture) => {
            let whole = Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
            ui.painter().image(texture.id(), rect, whole, Color32::WHITE);
        }
        None => {
            let drawing = || if form.is_whole() { t.drawing.to_owned() } else { t.nothing.to_owned() };
            let why = pages.fault.as_ref().map_or_else(drawing, |error| error.text(t.lang, &form.stem()));
            let middle = egui::Layout::centered_and_justified(egui::Direction::TopDown);
            let place = egui::UiBuilder::new().max_rect(rect.shrink(12.0)).layout(middle);
            ui.new_child(place).add(egui::Label::new(RichText::new(why).color(Color32::DARK_GRAY)).wrap());
        }
    }
    ui.horizontal(|ui| {
        let turns = |ui: &mut Ui, sign, name, is_possible| {
            ui.add_enabled(is_possible, Button::new(sign)).explained(name).accessible_name(name).clicked()
        };
        if turns(ui, "◀", t.page_before, form.page > 0) {
            form.page -= 1;
        }
        ui.label(format!("{} {} {} {count}", t.page, form.page + 1, t.of));
        if turns(ui, "▶", t.page_after, form.page + 1 < count) {
            form.page += 1;
        }
    });
    *shown = Some(pages);
}
