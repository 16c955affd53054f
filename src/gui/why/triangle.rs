//! One triangle step by step. Its corners in each space, the cuts, the pixels that it covers and their depths.

use eframe::egui::{self, RichText, Ui};

use crate::figure::{ShownTriangle, TriangleStep, View};
use crate::gui::kit::{Explained, NumberField, Step, complain, help_topic, help_topic_row, toggle, whole};
use crate::gui::why::state::explain::Explain;
use crate::gui::why::state::triangle::Covered;
use crate::picture::TrianglePixels;
use crate::pipeline::Stage;
use crate::pipeline::one_triangle::TriangleSteps;
use crate::views::pick::image_pixel;
use crate::views::{Labels, Request, Size};
use camera_lab_desk::Model;
use camera_lab_words::pictures::labels;
use camera_lab_words::why::triangle::Texts;
use camera_lab_words::why::{notes, triangle as words};
use camera_lab_words::{Lang, window};

/// The context in which a step is written.
struct Page<'a> {
    t: &'a Texts,
    labels: &'a Labels,
    mark: crate::numbers::DecimalMark,
    digits: usize,
}

/// A field for a whole number from 0 to `last`.
fn whole_number(ui: &mut Ui, lang: Lang, (name, hint): (&str, &str), now: u32, last: u32) -> u32 {
    let field = NumberField::new(name, Step::Add(1.0)).of("triangle").whole().within(0.0..=f64::from(last));
    let mut value = f64::from(now.min(last));
    let shown = field.hint(hint).show(ui, window::texts(lang), &mut value);
    complain(ui, lang, [&shown]);
    whole(value)
}

/// Shows the chooser, and the steps of the chosen triangle.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, explain: &mut Explain) {
    let t = words::texts(model.settings.lang);
    ui.label(RichText::new(t.heading).strong());
    ui.label(RichText::new(t.hint).weak());
    let labels = labels(model.settings.lang);
    chooser(ui, t, model);
    let Some((steps, covered)) = found(ui.ctx(), model, explain) else { return };
    let Some(mut shown) = model.shown().triangle.clone() else { return };
    choose_step(ui, t, &mut shown.step);
    let page = Page { t, labels, mark: model.settings.lang.mark(), digits: model.settings.digits };
    let step = shown.step;
    let top = ui.cursor().min;
    let pixels = match covered {
        Covered::Found(pixels) => pixels,
        Covered::Searched => {
            ui.label(RichText::new(t.being_found).weak());
            return follow(ui, model, shown);
        }
    };
    match step {
        TriangleStep::View => page.spaces(ui, &steps),
        TriangleStep::Facing => page.facing(ui, &steps),
        TriangleStep::Outcodes => page.outcodes(ui, &steps),
        TriangleStep::Cuts => page.cuts(ui, &steps),
        TriangleStep::Divide => page.divide(ui, &steps),
        TriangleStep::Viewport => page.viewport(ui, &steps),
        TriangleStep::Pixels => page.pixels(ui, pixels.as_deref()),
        TriangleStep::Depth => page.depth(ui, pixels.as_deref(), model.desk.shown.figure().image, &mut shown.pixel),
    }
    let row = egui::Rect::from_min_max(top, egui::pos2(ui.max_rect().right(), ui.cursor().min.y));
    help_topic_row(ui, row, notes::of_stage(stage_of(step)));
    follow(ui, model, shown);
}

/// Goes on with the chosen step, or pixel.
fn follow(ui: &Ui, model: &mut Model, shown: ShownTriangle) {
    if model.shown().triangle.as_ref() != Some(&shown) {
        model.desk.shown.show_mut().triangle = Some(shown);
        ui.ctx().request_repaint();
    }
}

/// The numbers of the triangle that the image shows.
fn found(ctx: &egui::Context, model: &Model, explain: &mut Explain) -> Option<(TriangleSteps, Covered)> {
    // They don't depend on the size.
    let size = Size { width: 1, height: 1, scale: 1.0 };
    let (document, scene, labels) = (&model.desk.shown, model.scene_cache.scene(), labels(model.settings.lang));
    let request = Request::of(document.figure(), View::Image, document.camera(), scene, labels, size);
    explain.triangle.found(ctx, &request)
}

/// The stage that does a step.
fn stage_of(step: TriangleStep) -> Stage {
    match step {
        TriangleStep::View => Stage::Transform,
        TriangleStep::Facing => Stage::CullFaces,
        TriangleStep::Outcodes | TriangleStep::Cuts => Stage::Clip,
        TriangleStep::Divide => Stage::Divide,
        TriangleStep::Viewport => Stage::Viewport,
        TriangleStep::Pixels => Stage::Fill,
        TriangleStep::Depth => Stage::HiddenSurfaces,
    }
}

fn chooser(ui: &mut Ui, t: &Texts, model: &mut Model) {
    let scene = model.scene_cache.scene().clone();
    let objects: Vec<(&str, usize)> = scene
        .objects
        .iter()
        .filter(|object| object.faces && !object.mesh.triangles.is_empty())
        .map(|object| (object.name.as_str(), object.mesh.triangles.len()))
        .collect();
    let shown = model.shown().triangle.clone();
    let mut chosen = shown.as_ref().map(|shown| (shown.object.clone(), shown.index));
    ui.horizontal_wrapped(|ui| {
        let name = chosen.as_ref().map_or("–", |(name, _)| name).to_owned();
        let response = egui::ComboBox::from_id_salt("object of the triangle")
            .selected_text(crate::sanitize::escaped(&name))
            .show_ui(ui, |ui| {
                for (object, _) in &objects {
                    if ui.selectable_label(name == *object, crate::sanitize::escaped(object)).clicked() {
                        chosen = Some(((*object).to_owned(), 0));
                    }
                }
            })
            .response;
        response.explained(t.object).accessible_name(t.object);
        if let Some((name, index)) = &mut chosen {
            let count = objects.iter().find(|(object, _)| object == name).map(|(_, count)| *count);
            let last = |count: usize| u32::try_from(count.saturating_sub(1)).unwrap_or(u32::MAX);
            // When a figure has just been opened, its scene is built after this panel is shown.
            let last = count.map_or(*index, last);
            *index = whole_number(ui, t.lang, (t.number, t.number), *index, last);
            ui.label(format!("0 … {last}"));
            if ui.button("✕").explained(t.release).accessible_name(t.release).clicked() {
                chosen = None;
            }
        }
    });
    if chosen != shown.as_ref().map(|shown| (shown.object.clone(), shown.index)) {
        choose(model, chosen);
        ui.ctx().request_repaint();
    }
}

/// Follows another triangle at the same step, or none.
fn choose(model: &mut Model, chosen: Option<(String, u32)>) {
    let step = model.shown().triangle.as_ref().map(|shown| shown.step).unwrap_or_default();
    let triangle = chosen.map(|(object, index)| ShownTriangle { object, index, step, pixel: None });
    model.desk.shown.show_mut().triangle = triangle;
}

fn choose_step(ui: &mut Ui, t: &Texts, step: &mut TriangleStep) {
    let at = *step as usize;
    let mut to = at;
    ui.horizontal_wrapped(|ui| {
        for (sign, name, next) in [("◀", t.previous, at.saturating_sub(1)), ("▶", t.next, at + 1)] {
            if ui.button(sign).explained(name).accessible_name(name).clicked() {
                to = next.min(TriangleStep::ALL.len() - 1);
            }
        }
        for (i, each) in TriangleStep::ALL.into_iter().enumerate() {
            let response = toggle(ui, i == to, words::step(t, each));
            help_topic(&response, notes::of_stage(stage_of(each)));
            if response.clicked() {
                to = i;
            }
        }
    });
    if to != at {
        *step = TriangleStep::ALL[to];
        ui.ctx().request_repaint();
    }
}

impl Page<'_> {
    fn tuple(&self, values: &[f64]) -> String {
        self.mark.tuple(values, self.digits)
    }

    fn number(&self, value: f64) -> String {
        self.mark.number(value, self.digits)
    }

    fn point(&self, p: glam::DVec3) -> String {
        self.tuple(&p.to_array())
    }

    fn line(&self, ui: &mut Ui, text: &str) {
        ui.add(egui::Label::new(RichText::new(text).monospace()).wrap());
    }

    fn spaces(&self, ui: &mut Ui, steps: &TriangleSteps) {
        for (name, corner) in ('a'..).zip(&steps.corners) {
            ui.label(RichText::new(name).strong());
            for (space, p) in [(self.t.local, corner.local), (self.t.world, corner.world), (self.t.view, corner.view)] {
                self.line(ui, &format!("{space:<6} {}", self.point(p)));
            }
        }
    }

    fn facing(&self, ui: &mut Ui, steps: &TriangleSteps) {
        self.line(ui, &format!("N · (C − a) = {}", self.number(steps.facing)));
        ui.label(if steps.facing > 0.0 { self.t.is_front } else { self.t.is_back });
    }

    /// The six distances of each corner. Negative ones are the bits of its outcode.
    fn outcodes(&self, ui: &mut Ui, steps: &TriangleSteps) {
        const NAMES: [&str; 6] = ["w + x", "w − x", "w + y", "w − y", "d − F", "B − d"];
        for (name, corner) in ('a'..).zip(&steps.corners) {
            ui.label(RichText::new(name).strong());
            self.line(ui, &format!("(x_c, y_c, w) = {}", self.tuple(&[corner.clip.x, corner.clip.y, corner.w])));
            for (plane, value) in corner.distances.into_iter().enumerate() {
                let is_outside = corner.outside[plane];
                let sign = if is_outside { "< 0 → 1" } else { "" };
                let text = format!("{} = {} {sign} {}", NAMES[plane], self.number(value), self.labels.planes[plane]);
                let text = RichText::new(text).monospace();
                ui.label(if is_outside { text.color(ui.visuals().error_fg_color) } else { text });
            }
            let out: Vec<&str> = (0..6).filter(|&i| corner.outside[i]).map(|i| self.labels.planes[i]).collect();
            let code: String = corner.outside.iter().map(|out| if *out { '1' } else { '0' }).collect();
            ui.label(match out.as_slice() {
                [] => self.t.inside.to_owned(),
                out => format!("{} {} · {code}", self.t.outside, out.join(", ")),
            });
        }
        if steps.is_outside {
            ui.label(self.t.all_outside);
        }
    }

    fn cuts(&self, ui: &mut Ui, steps: &TriangleSteps) {
        if steps.is_outside {
            ui.label(self.t.all_outside);
        } else if steps.cuts.is_empty() {
            ui.label(self.t.no_cut);
        }
        for cut in &steps.cuts {
            ui.label(RichText::new(self.labels.planes[cut.plane]).strong());
            for made in &cut.made {
                let [d1, d2] = made.distances;
                let (name, inside, outside) = (made.name, made.inside, made.outside);
                self.line(ui, &format!("{name} = {inside} + t ({outside} − {inside})"));
                let numbers = [d1, -d2, made.t].map(|v| self.number(v));
                let [d1, d2, t] = numbers;
                self.line(ui, &format!("  t = d₁/(d₁ + d₂) = {d1}/({d1} + {d2}) = {t}"));
            }
            let left = if cut.left.len() < 3 { self.t.nothing_left } else { &cut.left };
            ui.label(format!("{} {left}", self.t.left));
        }
    }

    fn divide(&self, ui: &mut Ui, steps: &TriangleSteps) {
        for corner in &steps.left {
            let ndc = self.tuple(&[corner.ndc.x, corner.ndc.y]);
            let clip = self.tuple(&[corner.clip.x, corner.clip.y]);
            self.line(ui, &format!("{}: {clip} ÷ {} = {ndc}", corner.name, self.number(corner.w)));
        }
        self.nothing(ui, steps);
    }

    fn viewport(&self, ui: &mut Ui, steps: &TriangleSteps) {
        for corner in &steps.left {
            let ndc = self.tuple(&[corner.ndc.x, corner.ndc.y]);
            let pixels = self.tuple(&corner.image.map(f64::from));
            self.line(ui, &format!("{}: {ndc} → {pixels} px", corner.name));
        }
        self.nothing(ui, steps);
    }

    fn nothing(&self, ui: &mut Ui, steps: &TriangleSteps) {
        if steps.left.is_empty() {
            ui.label(self.t.nothing_left);
        }
    }

    /// Reports an empty coverage. Returns false then.
    fn covers(&self, ui: &mut Ui, pixels: Option<&TrianglePixels>) -> bool {
        match pixels {
            None => ui.label(self.t.too_large),
            Some(pixels) if pixels.rows.is_empty() => ui.label(self.t.covers_none),
            Some(_) => return true,
        };
        false
    }

    fn pixels(&self, ui: &mut Ui, pixels: Option<&TrianglePixels>) {
        if let Some(pixels) = pixels.filter(|pixels| self.covers(ui, Some(pixels))) {
            let rows = pixels.rows.len();
            ui.label(format!("{} {} · {rows} {}", pixels.count(), self.t.covers, self.t.rows));
        } else if pixels.is_none() {
            self.covers(ui, None);
        }
    }

    fn depth(
        &self,
        ui: &mut Ui,
        pixels: Option<&TrianglePixels>,
        image: crate::camera::ImageSize,
        asked: &mut Option<[u32; 2]>,
    ) {
        if !self.covers(ui, pixels) {
            return;
        }
        let Some((pixels, pixel)) = pixels.and_then(|p| Some((p, p.tested(*asked)?))) else {
            return;
        };
        let mut now = pixel;
        ui.label(self.t.pixel);
        ui.horizontal(|ui| {
            for ((name, size), value) in [("i", image.width), ("j", image.height)].into_iter().zip(&mut now) {
                ui.label(name);
                let last = size.saturating_sub(1);
                *value = whole_number(ui, self.t.lang, (name, self.t.pixel_hint), *value, last);
            }
        });
        if now != pixel {
            *asked = Some(now);
        }
        let Some(tested) = pixels.test(now) else {
            ui.label(self.t.not_covered);
            return;
        };
        self.line(ui, &format!("{}: {}", self.t.z_own, self.number(tested.z)));
        match tested.before {
            Some(before) => self.line(ui, &format!("{}: {}", self.t.z_before, self.number(before))),
            None => self.line(ui, self.t.z_nothing),
        }
        ui.label(RichText::new(if tested.kept { self.t.kept } else { self.t.rejected }).strong());
        ui.label(RichText::new(self.t.before_hint).weak());
    }
}

/// Handles a click in the image while the tab is shown, at a place (pixels) with the triangle found there, if any. At
/// the depth test it chooses a pixel of the followed triangle, otherwise the triangle found. Returns false if there is
/// neither.
pub(in crate::gui) fn clicked(
    ctx: &egui::Context,
    model: &mut Model,
    explain: &mut Explain,
    request: &Request,
    pointer: glam::DVec2,
    triangle: Option<(usize, u32)>,
) -> bool {
    let pixel = image_pixel(request, pointer);
    let shown = model.shown().triangle.clone();
    let at_depth = shown.filter(|shown| shown.step == TriangleStep::Depth);
    let covered = at_depth.and_then(|shown| match found(ctx, model, explain)?.1 {
        Covered::Found(Some(pixels)) if pixel.is_some_and(|pixel| pixels.covers(pixel)) => Some(shown),
        Covered::Found(_) | Covered::Searched => None,
    });
    if let Some(shown) = covered {
        model.desk.shown.show_mut().triangle = Some(ShownTriangle { pixel, ..shown });
    } else if let Some((object, index)) = triangle {
        let name = &request.scene.objects[object].name;
        if request.scene.place_of(name) != Some(object) {
            // The name belongs to another object, so we can't tell which one is meant.
            return false;
        }
        choose(model, Some((name.clone(), index)));
    } else {
        return false;
    }
    true
}
