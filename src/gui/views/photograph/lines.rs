//! The lines on the photograph, which can be drawn, dragged by their ends, and prolonged to the vanishing points.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, CursorIcon, EventFilter, Id, Key, Painter, Pos2, Rect, Response, Sense, Shape, Stroke, TextStyle,
    Ui, Vec2, WidgetInfo, vec2,
};
use glam::DVec2;

use crate::camera::{PhotographCamera, WorldAxis};
use crate::gui::kit::theme::lowered;
use crate::gui::views::image_place::ImagePlace;
use crate::gui::views::labels::label_drag::arrow_of;
use crate::gui::views::{Canvas, Pane};
use crate::views::{Palette, View};
use camera_lab_desk::settings::Settings;
use camera_lab_desk::{Drawn, Grip, Model, PhotographTool, SHORTEST};
use camera_lab_words::Lang;
use camera_lab_words::window::photograph as words;

/// The radius of a grip, and that in which the pointer catches it, in points.
const GRIP: f32 = 5.0;
const REACH: f32 = 9.0;
/// Pixels of the image for one press of an arrow key with Shift.
const FAST: f64 = 10.0;

impl Canvas {
    /// Shows the lines while the tool is open, and lets pointer and keys draw and move them.
    pub(in crate::gui::views) fn photograph_lines(ui: &Ui, model: &mut Model, panes: &[Pane]) {
        // Two images side by side have no place for them.
        let shows = |pane: &&Pane| {
            let compared = pane.request.shot.compared.as_ref();
            pane.view == View::Image && compared.is_none_or(|compared| !compared.comparison.beside)
        };
        let Some(pane) = panes.iter().find(shows).filter(|_| model.photograph.on) else { return };
        let Model { photograph, settings, desk, .. } = model;
        let place = ImagePlace::of(pane);
        let (image, given) = (desk.shown.figure().image, *desk.shown.camera().parameters());
        // A place outside the pane would be moved to its border.
        let middle = pane.rect.rect.center();
        let reach = place.in_image(middle + vec2(REACH, 0.0)).distance(place.in_image(middle));
        photograph.find_axis(image, &given, reach);
        draw(ui, photograph, pane, &place);
        let mut removed = None;
        for (grip, at) in photograph.grips() {
            removed = removed.or(drag(ui, settings.lang, photograph, pane, &place, (grip, at)));
        }
        if let Some(grip) = removed {
            photograph.remove(grip);
        }
        // A drag is one step, and so is a number.
        if !ui.input(|input| input.pointer.any_down()) && !ui.ctx().text_edit_focused() {
            photograph.settle(desk.shown.step());
        }
        let found = photograph.camera(image, &given).ok();
        paint(ui, settings, photograph, pane, &place, found.as_ref());
    }
}

/// A drag on the photograph draws a line or puts a point.
fn draw(ui: &Ui, photograph: &mut PhotographTool, pane: &Pane, place: &ImagePlace) {
    let response = ui.interact(pane.rect.rect, Id::unique("photograph"), Sense::click_and_drag());
    if response.hovered() {
        ui.set_cursor_icon(CursorIcon::Crosshair);
    }
    let pressed = ui.input(|input| input.pointer.press_origin()).map(|origin| place.in_image(origin));
    let tool = &mut *photograph;
    new_line(tool, &response, place, pressed);
    // A line needs two ends, a point only a click.
    let clicked = response.interact_pointer_pos().filter(|_| response.clicked());
    if let Some(pointer) = clicked.filter(|_| !matches!(tool.drawn, Drawn::Line(_))) {
        tool.begin(place.in_image(pointer));
    }
}

/// Begins a mark when a drag of `response` starts, at `from`, and follows the pointer.
fn new_line(tool: &mut PhotographTool, response: &Response, place: &ImagePlace, from: Option<DVec2>) {
    if let Some(from) = from.filter(|_| response.drag_started()) {
        tool.begin(from);
    }
    if let Some(pointer) = held_at(response) {
        tool.go_on(place.in_image(pointer));
    }
    if response.drag_stopped() {
        let ends = tool.new_line.and_then(|line| tool.marks.lines.get(line)).map(|line| line.ends);
        let is_long = |[a, b]: [DVec2; 2]| place.on_screen(a).distance(place.on_screen(b)) >= SHORTEST;
        tool.end(ends.is_some_and(is_long));
    }
}

/// The pointer of a drag. A quick hand lets go in the frame of its last move.
fn held_at(response: &Response) -> Option<Pos2> {
    response.interact_pointer_pos().filter(|_| response.dragged() || response.drag_stopped())
}

/// A grip follows the pointer and the arrow keys. Returns it if its mark is to be removed.
fn drag(
    ui: &Ui,
    lang: Lang,
    photograph: &mut PhotographTool,
    pane: &Pane,
    place: &ImagePlace,
    (grip, at): (Grip, DVec2),
) -> Option<Grip> {
    // A line that was too short has disappeared in this frame.
    if matches!(grip, Grip::End(line, _) if line >= photograph.marks.lines.len()) {
        return None;
    }
    let middle = place.on_screen(at);
    let rect = Rect::from_center_size(middle, Vec2::splat(2.0 * REACH)).intersect(pane.rect.rect);
    let response = ui.interact(rect, Id::unique(("photograph", grip)), Sense::click_and_drag());
    let name = name(lang, photograph, grip);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    let response = response.on_hover_and_drag_cursor(CursorIcon::Grab);
    if response.clicked() || response.drag_started() {
        response.request_focus();
    }
    match (grip, photograph.drawn) {
        // At a corner that ends another edge, a line along the chosen axis begins.
        (Grip::End(line, _), Drawn::Line(axis)) if photograph.marks.lines[line].axis != axis => {
            new_line(photograph, &response, place, Some(at));
        }
        (Grip::End(..), Drawn::Origin | Drawn::Length) if response.clicked() => photograph.begin(at),
        // So does one at the origin, and the length starts there. Only the origin's own tool moves it.
        // A length drawn along an edge doesn't move its end either.
        (Grip::End(..) | Grip::Origin, Drawn::Length) | (Grip::Origin | Grip::Length, Drawn::Line(_)) => {
            new_line(photograph, &response, place, Some(at));
        }
        _ => {
            if let Some(pointer) = held_at(&response) {
                photograph.move_to(grip, place.in_image(pointer));
            }
        }
    }
    (response.has_focus() && is_removed(ui, photograph, &response, (grip, at))).then_some(grip)
}

/// The name of a grip for screen readers.
fn name(lang: Lang, tool: &PhotographTool, grip: Grip) -> String {
    match grip {
        Grip::End(line, end) => words::end(lang, (line + 1, tool.marks.lines[line].axis), end == 0),
        Grip::Origin => words::texts(lang).origin.to_owned(),
        Grip::Length => words::length(lang, tool.length),
    }
}

/// Moves the grip that has the focus by the arrow keys. True if Delete is pressed.
fn is_removed(ui: &Ui, photograph: &mut PhotographTool, response: &Response, (grip, at): (Grip, DVec2)) -> bool {
    let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, tab: false, escape: false };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let (by, removes) = ui.input(|input| {
        let step = if input.modifiers.shift { FAST } else { 1.0 };
        let keys = [Key::ArrowLeft, Key::ArrowRight, Key::ArrowUp, Key::ArrowDown];
        let presses = |key| f64::from(u32::try_from(input.num_presses(key)).unwrap_or(0));
        let by: DVec2 = keys.into_iter().map(|key| arrow_of(key) * (step * presses(key))).sum();
        (DVec2::new(by.x, -by.y), input.key_pressed(Key::Delete) || input.key_pressed(Key::Backspace))
    });
    if by != DVec2::ZERO {
        photograph.move_to(grip, at + by);
    }
    removes
}

const fn color_of(rgba: crate::appearance::Rgba) -> Color32 {
    Color32::from_rgb(rgba.r, rgba.g, rgba.b)
}

fn axis_color(palette: Palette, axis: WorldAxis) -> Color32 {
    let place = WorldAxis::ALL.iter().position(|known| *known == axis).unwrap_or(0);
    color_of(palette.axes[place])
}

/// A stroke that is visible on any photograph.
fn stroke(painter: &Painter, ends: [Pos2; 2], width: f32, [color, paper]: [Color32; 2]) {
    painter.line_segment(ends, Stroke::new(width + 2.0, paper.gamma_multiply(0.7)));
    painter.line_segment(ends, Stroke::new(width, color));
}

fn paint(
    ui: &Ui,
    settings: &Settings,
    photograph: &PhotographTool,
    pane: &Pane,
    place: &ImagePlace,
    found: Option<&PhotographCamera>,
) {
    let palette = Palette::of(settings.theme);
    let painter = ui.painter().with_clip_rect(pane.rect.rect);
    let paper = color_of(palette.paper);
    let marks = &photograph.marks;
    if let Some([a, b]) = found.and_then(|found| found.horizon) {
        // Far enough to cross the pane.
        let along = (b - a).normalize() * 1e5;
        let ends = [a - along, a + along].map(|end| place.on_screen(end));
        stroke(&painter, ends, 1.0, [color_of(palette.soft), paper]);
    }
    let shows_axis = photograph.drawn == Drawn::Length || marks.length.is_some();
    if let Some((origin, way, _)) = photograph.axis.filter(|_| shows_axis) {
        let ends = [origin - way * 1e5, origin + way * 1e5].map(|end| place.on_screen(end));
        stroke(&painter, ends, 1.0, [axis_color(palette, photograph.length.0), paper]);
    }
    for line in &marks.lines {
        let color = axis_color(palette, line.axis);
        let ends = line.ends.map(|end| place.on_screen(end));
        let vanishing = found.and_then(|found| found.vanishing.iter().find(|point| point.axis == line.axis));
        if let Some(point) = vanishing.and_then(|point| point.pixel) {
            let nearer = usize::from(line.ends[1].distance(point) < line.ends[0].distance(point));
            let way = [ends[nearer], place.on_screen(point)];
            painter.extend(Shape::dashed_line(&way, Stroke::new(1.0, color), 5.0, 5.0));
        }
        stroke(&painter, ends, 2.5, [color, paper]);
    }
    for (grip, at) in photograph.grips() {
        let color = match grip {
            Grip::End(line, _) => axis_color(palette, marks.lines[line].axis),
            Grip::Origin => color_of(palette.ink),
            Grip::Length => axis_color(palette, photograph.length.0),
        };
        let middle = place.on_screen(at);
        let is_focused = ui.memory(|memory| memory.has_focus(Id::unique(("photograph", grip))));
        let radius = if is_focused { GRIP + 2.0 } else { GRIP };
        painter.circle(middle, radius, color.gamma_multiply(0.5), Stroke::new(1.5, paper));
        let name = match grip {
            Grip::End(line, 1) => marks.lines[line].axis.name().to_owned(),
            Grip::End(..) => continue,
            Grip::Origin => "O".to_owned(),
            Grip::Length => words::length(settings.lang, photograph.length),
        };
        label(ui, &painter, middle, &name, [color, paper]);
    }
    for point in found.iter().flat_map(|found| &found.vanishing) {
        let Some(pixel) = point.pixel else { continue };
        let (at, color) = (place.on_screen(pixel), axis_color(palette, point.axis));
        painter.circle_stroke(at, GRIP, Stroke::new(2.0, color));
        label(ui, &painter, at, &format!("V_{}", point.axis.name()), [color, paper]);
    }
}

/// A name beside a place.
fn label(ui: &Ui, painter: &Painter, at: Pos2, text: &str, [color, paper]: [Color32; 2]) {
    let galley = painter.layout_job(lowered(ui, text, &TextStyle::Body, color));
    let room = Align2::LEFT_BOTTOM.anchor_size(at + vec2(8.0, -8.0), galley.size());
    painter.rect_filled(room.expand(2.0), 2.0, paper.gamma_multiply(0.8));
    painter.galley(room.min, galley, color);
}
