//! The three pictures in the middle of the window: their layout, their observers, and the interaction with them.
//!
//! Nothing is stored that can be computed. Each frame describes anew the request of each visible picture, and only a
//! picture whose request has changed is drawn again.

pub(in crate::gui) mod annotations;
mod arrange;
mod axis_cross;
mod brief;
mod card;
pub(super) mod highlight;
mod icons;
mod image_place;
mod method_image;
/// The mode *Labels*, in which labels can be moved, renamed and hidden.
pub(super) mod labels {
    pub(super) mod label_drag;
    pub(super) mod labels_card;
}
pub(super) mod long_work;
pub(super) mod motion;
/// The camera of the photograph, from lines drawn on it along the axes of the world.
pub(super) mod photograph {
    mod card;
    mod lines;
}
/// The pointer and the keys in the pictures: probes, picking, drags.
pub(super) mod pointer {
    pub(super) mod camera_drag;
    pub(super) mod followed;
    pub(in crate::gui) mod handle_drag;
    pub(super) mod held;
    pub(super) mod interaction;
    pub(super) mod keyboard_probe;
    pub(super) mod picking;
    pub(super) mod placing;
    pub(super) mod probe_steps;
    pub(in crate::gui) mod selection_gizmo;
    pub(super) mod vertex_name;
    pub(super) mod wiper;
}
mod readout;
mod rendering;
mod status;
mod strip;
mod texture;

use std::sync::Arc;
use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Button, Context, CursorIcon, Id, Rect, Response, Sense, Stroke, StrokeKind, TextStyle, Ui, UiBuilder,
    WidgetInfo, pos2,
};

use self::arrange::{Axis, Framed, Shares, arrange, automatic};
use self::brief::{Brief, lost_files, why_empty};
use self::card::CardPlace;
use self::long_work::LongWork;
use self::rendering::{Missing, RenderJob, Rendering};
use self::status::StatusAction;
use self::strip::{Strip, StripAction};
use self::texture::{PictureRect, PictureTexture};
use crate::appearance::{Rgba, Samples};
use crate::figure::{Explanation, Observer};
use crate::gui::kit::{Command, Region, focus, frames, is_handheld};
use crate::gui::views::arrange::auto_observer::Auto;
use crate::gui::views::arrange::title::{Title, TitleAction};
use crate::gui::views::highlight::Highlight;
use crate::gui::views::pointer::held::Drag;
use crate::gui::views::pointer::keyboard_probe::{ProbeStep, Probing};
use crate::gui::views::pointer::picking::{PickRequest, Picker};
use crate::gui::views::pointer::probe_steps::Click;
use crate::gui::views::pointer::selection_gizmo::Movable;
use crate::gui::views::pointer::vertex_name::VertexNames;
use crate::pipeline::OverBudget;
use crate::scene::Scene;
use crate::views::{
    Hover, LabelPlace, MAX_PICTURES, Palette, Picture, Probe, Request, SharedScene, Shot, Size, View, aspect_shown,
};
use camera_lab_desk::{Action, Message, Model, ObserverChange, Placing, Running};
use camera_lab_words::pictures::labels;
use camera_lab_words::window::canvas::CanvasTexts;
use camera_lab_words::window::{self, canvas as words};

/// Time that a frame waits for its pictures. Slower ones appear when they are done.
const MAX_WAIT: Duration = Duration::from_millis(30);
/// In a narrower room, in points of a presentation, one picture is large instead of three being small.
const ROOM_FOR_SEVERAL: f32 = 560.0;
/// Interval between reports of long work.
const TELL: Duration = Duration::from_millis(100);

/// Draws the pictures and stores their state from one frame to the next.
#[derive(Default)]
pub struct Canvas {
    /// Time that a frame waits for its pictures. `None` for as long as a dragging hand allows. Tests have more of it.
    pub patience: Option<Duration>,
    rendering: Rendering,
    /// The pictures of the shot, as on the screen.
    pictures: Vec<ScreenPicture>,
    shares: Shares,
    /// The request of a title's button, and its picture.
    asked: Option<(usize, ObserverChange)>,
    /// The shot of this frame, and the additions of the pointer.
    shot: Shot,
    hover: Hover,
    highlight: Highlight,
    /// Pickers for the pointer, for the point of the probe, and for its next point by keys.
    picker: Picker,
    probe_picker: Picker,
    key_picker: Picker,
    /// With its picture.
    drag: Option<(usize, Drag)>,
    card: CardPlace,
    vertex_names: VertexNames,
    /// For a double-click, whose first click wasn't meant to pin.
    pinned_before: Option<Probe>,
    /// The mode of the arrow keys, and its picture.
    probing: Option<(usize, Probing)>,
    /// Steps of the keys that haven't been followed yet, by picture.
    probe_steps: std::collections::VecDeque<(usize, ProbeStep)>,
    /// The search at the pointer, and one whose result will be pinned.
    hover_pick: Option<PickRequest>,
    clicked_pick: Option<PickRequest>,
    /// The last probe of the pointer in a compared picture, and its side.
    probed_side: Option<(Probe, usize)>,
    /// A click whose target hasn't been found yet, and its picker.
    clicked: Option<Click>,
    click_picker: Picker,
    /// The scene, and the same with nothing but its photograph, while lines are drawn on that.
    photograph_alone: Option<[SharedScene; 2]>,
    /// The image of a way to draw, beside the exact one.
    method: method_image::MethodPane,
    /// The steps of a lesson whose pictures have begun to fade in.
    faded: u64,
    /// The command chosen in a context menu, until it's taken.
    pub(in crate::gui) wanted: Option<Command>,
}

/// The parts of other features that the pictures show or act on.
pub struct Inputs<'a> {
    /// The question for a place in the image, with the mark that a click puts there.
    pub(in crate::gui) placing: Option<Placing>,
    /// The number of times that a step of a lesson has faded in its pictures.
    pub(in crate::gui) fades: u64,
    /// The keys of a presentation, with their opacity, while they are visible.
    pub(in crate::gui) keys: Option<(&'static str, f32)>,
    /// True if the pictures stay the same during edits.
    pub(in crate::gui) frozen: bool,
    /// The files being written or read, each in a sentence, and their progress.
    pub(in crate::gui) of_files: Vec<(String, Running)>,
    /// True while the pixels of the followed triangle are being searched.
    pub(in crate::gui) triangle_waits: bool,
    /// Takes a click on a triangle of the image. Returns false if it has no meaning there.
    pub(in crate::gui) on_triangle: &'a mut OnTriangle<'a>,
}

/// Takes a click in an image: its request, the pointer in pixels, and the triangle there by its object and number.
type OnTriangle<'a> = dyn FnMut(&Context, &mut Model, &Request, glam::DVec2, Option<(usize, u32)>) -> bool + 'a;

/// A picture on the screen, and the state that it keeps from one frame to the next.
#[derive(Default)]
struct ScreenPicture {
    texture: PictureTexture,
    /// The report of its rendering.
    account: Option<crate::picture::RenderReport>,
    /// The reason why there is none.
    missing: Option<Missing>,
    /// A budget that it exceeded.
    over_budget: Option<OverBudget>,
    /// Its observer if the figure doesn't set one.
    auto: Auto,
    /// The last observer framed by a button or a key, with the size of the picture.
    framed: Option<(Observer, Size)>,
    /// The places of its labels.
    labels: Vec<LabelPlace>,
    /// Its place, in points.
    place: Option<Rect>,
}

/// A picture in this frame.
struct Pane {
    /// Its place among the pictures of the shot.
    picture: usize,
    /// Its kind.
    view: View,
    rect: PictureRect,
    response: Response,
    /// Its whole content.
    request: Request,
}

impl Canvas {
    /// The number of times that each picture of the shot has been drawn since the window was opened.
    pub fn drawn(&self) -> Vec<u64> {
        self.rendering.drawn()[..self.pictures.len()].to_vec()
    }

    /// The place of each picture of the shot on the screen, with its kind. In points.
    pub fn places(&self) -> impl Iterator<Item = (View, Rect)> {
        self.shot.pictures.iter().zip(&self.pictures).filter_map(|(shown, screen)| Some((shown.kind, screen.place?)))
    }

    /// The labels of the picture of a kind, in its pixels.
    pub fn labels(&self, kind: View) -> &[LabelPlace] {
        self.picture_of(kind).map(|picture| picture.labels.as_slice()).unwrap_or_default()
    }

    /// A picture of the shot with the additions for the pointer.
    fn request(&self, model: &Model, picture: &Picture, size: Size) -> Request {
        let (camera, scene) = (model.desk.shown.camera(), model.scene_cache.scene());
        let request = Request::of_picture(&self.shot, picture, camera, scene, labels(model.settings.lang), size);
        Request { hover: self.hover.seen_in(picture.kind), ..request }
    }

    /// The picture of a kind on the screen.
    fn picture_of(&self, kind: View) -> Option<&ScreenPicture> {
        let of_kind = self.shot.pictures.iter().zip(&self.pictures).find(|(shown, _)| shown.kind == kind);
        of_kind.map(|(_, screen)| screen)
    }

    /// True if Esc would release something in a picture.
    pub fn holds_something(&self, model: &Model) -> bool {
        self.drag.is_some()
            || model.label_mode.on
            || model.photograph.on
            || self.is_probing()
            || model.pinned().is_some()
            || model.can_release_shown()
    }

    /// Fills the remaining room in `ui` with the pictures, and lets the pointer and the keys act on them.
    pub fn ui(&mut self, ui: &mut Ui, model: &mut Model, inputs: &mut Inputs<'_>) {
        let room = ui.available_rect_before_wrap();
        ui.take_available_space();
        let texts = words::texts(model.settings.lang);
        let lines = status::height(ui, room.width(), model.settings.presentation);
        let (room, lines) = room.split_top_bottom_at_y((room.bottom() - lines).max(room.top()));
        let stages = if model.layout.strip { strip::height(ui, room.width()) } else { 0.0 };
        let (pictures, stages) = room.split_top_bottom_at_y((room.bottom() - stages).max(room.top()));

        let (ctx, patience) = (ui.ctx().clone(), self.patience.unwrap_or(MAX_WAIT));
        if model.tree.settle() {
            ctx.request_repaint();
        }
        if let Err(error) = model.scene_cache.update(&frames(&ctx), &model.desk.shown, model.settings.theme, patience) {
            model.say(Message::Scene(error));
        } else if model.scene_cache.loading().is_empty() {
            model.forget_missing();
        }
        if let Some(notice) = model.scene_cache.take_notice() {
            model.say(Message::NoPhotograph(notice));
        }
        self.hover = Hover {
            ghost: model.frame.hover.ghost.clone(),
            measured: model.frame.hover.measured.clone(),
            object: model.object_transform(),
            gizmo: Movable::selected(model).map(|movable| movable.gizmo),
            ..Hover::default()
        };
        self.shot = model.shot(std::mem::take(&mut self.shot.pictures));
        self.shot.pictures.truncate(MAX_PICTURES);
        let scene = model.scene_cache.scene();
        let wants = model.photograph.on && !model.photograph.has_scene && !model.accounts_for_stages();
        let is_alone = wants && scene.photograph.is_some();
        let known = self.photograph_alone.take().filter(|[of, _]| of == scene);
        self.photograph_alone = is_alone.then(|| {
            let alone = || Scene { photograph: scene.photograph.clone(), ..Scene::default() };
            known.unwrap_or_else(|| [scene.clone(), SharedScene::new(alone())])
        });
        self.pictures.resize_with(self.shot.pictures.len(), ScreenPicture::default);
        let is_small = model.settings.presentation && pictures.width() < ROOM_FOR_SEVERAL;
        let asks_for_place = inputs.placing.as_ref().is_some_and(|placing| placing.is_open);
        let alone =
            (is_small || is_handheld(&ctx)).then(|| if asks_for_place { View::Image } else { model.main_picture() });
        let pictures = match alone {
            Some(only) if is_handheld(&ctx) && !model.settings.bare => Self::tabs(ui, pictures, model, (only, texts)),
            _ => pictures,
        };
        let mut panes = self.panes(ui, pictures, model, (alone, texts));
        self.pictures.iter_mut().for_each(|picture| picture.place = None);
        for pane in &panes {
            self.pictures[pane.picture].place = Some(pane.rect.rect);
            model.frame.picture_sizes[pane.view.index()] = [pane.rect.size.width, pane.rect.size.height];
            model.frame.screen_scale = pane.rect.size.scale;
        }
        self.settle_observers(ui, model, &mut panes);
        let mut status = self.interact(ui, model, &mut inputs.placing, &panes, texts);
        self.pin_clicked(&ctx, model);
        self.take_click(&ctx, model, inputs);
        self.take_probe_steps(&ctx, model, &panes);
        model.frame.probe = model.pinned().or(self.hover.probe);
        model.frame.seen = Picture::observers(&self.shot.pictures);
        self.draw(ui, model, inputs, &mut panes);
        self.decorate(ui, model, &panes, texts);
        self.axis_cross(ui, model, &panes, texts);
        self.outline_labels(ui, model, &panes);
        self.labels_card(ui, model, &panes);
        Self::marks(ui, inputs.placing.as_ref(), &panes);
        Self::wipers(ui, model, &panes);
        self.method_image(ui, model, &panes);
        Self::photograph_lines(ui, model, &panes);
        Self::photograph_card(ui, model, &panes);

        if model.layout.strip {
            self.strip(ui, stages, model, texts);
        }

        // Below the titles, whose buttons a card would cover.
        let room = panes.iter().map(|pane| pane.rect.rect).reduce(|a, b| a.union(b)).unwrap_or(pictures);
        self.describe_probe((ui, room), &panes, model, &mut status, texts);
        self.say_why_empty(ui, model, &panes);
        status.coach = Brief::of(model);
        status.presenting = model.settings.presentation;
        status.keys = inputs.keys;
        let loading = loading(model);
        if !loading.is_empty() {
            status.message = loading;
        }
        status.work = LongWork::of(self, model, &inputs.of_files);
        if self.rendering.running().is_some() || model.scene_cache.running().is_some() || !inputs.of_files.is_empty() {
            ctx.request_repaint_after(TELL);
        }
        status.hidden = if model.layout.maximized.is_none() && !is_handheld(&ctx) {
            View::ALL.into_iter().filter(|p| !model.layout.shown[p.index()]).collect()
        } else {
            Vec::new()
        };
        status.arrangement = (panes.len() > 1).then_some(model.layout.arrangement);
        match status.show(ui, lines, texts) {
            None => {}
            Some(StatusAction::ShowAgain(view)) => model.layout.shown[view.index()] = true,
            Some(StatusAction::Arrange(arrangement)) => model.layout.arrangement = arrangement,
            Some(StatusAction::Coach) => model.request(Action::Coach),
        }
    }

    /// The axes in the corner of the world. A presentation, and a figure inside a text, show the picture alone.
    fn axis_cross(&mut self, ui: &Ui, model: &Model, panes: &[Pane], texts: &CanvasTexts) {
        let is_alone = model.settings.presentation || model.settings.bare;
        let world = panes.iter().find(|pane| pane.view == View::World && !is_alone);
        let Some((pane, observer)) = world.and_then(|pane| Some((pane, pane.request.seen_from()?))) else { return };
        if let Some(change) = axis_cross::show(ui, pane.rect.rect, &observer, texts, model.settings.theme) {
            self.asked = Some((pane.picture, change));
            ui.request_repaint();
        }
    }

    /// Explains in the image what isn't in it.
    fn say_why_empty(&self, ui: &mut Ui, model: &mut Model, panes: &[Pane]) {
        let image = panes.iter().find(|pane| pane.view == View::Image);
        let is_there = |pane: &&Pane| self.drag.is_none() && self.pictures[pane.picture].missing.is_none();
        if let Some(pane) = image.filter(is_there)
            && !lost_files(ui, pane.rect.rect, model)
        {
            why_empty(ui, pane.rect.rect, model);
        }
    }

    /// The stages of the pipeline, as in the picture on the screen.
    fn strip(&self, ui: &mut Ui, room: Rect, model: &mut Model, texts: &CanvasTexts) {
        let view = model.layout.strip_of;
        let hidden = !model.layout.is_shown(view);
        let account = self.picture_of(view).and_then(|picture| picture.account.as_ref()).filter(|_| !hidden);
        focus::region(ui, room, Region::Strip, texts.strip);
        let strip = Strip { lang: model.settings.lang, texts, view, account, hidden, shown: model.shown_stage() };
        match strip.show(ui, room) {
            None => return,
            Some(StripAction::Of(view)) => model.list_stages_of(view),
            Some(StripAction::Close) => model.layout.strip = false,
            Some(StripAction::Show(stage)) => model.toggle_stage(stage),
        }
        ui.request_repaint();
    }

    /// A tab for each picture, of which one is `shown`. Returns the room below.
    fn tabs(ui: &mut Ui, room: Rect, model: &mut Model, (shown, texts): (View, &CanvasTexts)) -> Rect {
        let (tabs, below) = room.split_top_bottom_at_y(room.top() + ui.spacing().interact_size.y);
        let mut tabs = ui.new_child(UiBuilder::new().max_rect(tabs));
        tabs.columns(View::ALL.len(), |columns| {
            for (ui, view) in columns.iter_mut().zip(View::ALL) {
                let button = Button::selectable(model.layout.maximized.unwrap_or(shown) == view, texts.view(view));
                if ui.add_sized(ui.available_size(), button).clicked() {
                    model.layout.maximized = Some(view);
                }
            }
        });
        below
    }

    /// Lays the pictures out, with their titles and the bars between them.
    fn panes(
        &mut self,
        ui: &mut Ui,
        room: Rect,
        model: &mut Model,
        (alone, texts): (Option<View>, &CanvasTexts),
    ) -> Vec<Pane> {
        let is_visible = |view| {
            model.layout.is_shown(view) && (model.layout.maximized.is_some() || alone.is_none_or(|only| only == view))
        };
        let visible = self.shot.pictures.iter().enumerate().filter(|(_, shown)| is_visible(shown.kind));
        let framed = |(picture, shown): (usize, &Picture)| Framed {
            picture,
            aspect: aspect_shown(shown.kind, model.desk.shown.figure().image),
        };
        let mut framed: Vec<Framed> = visible.map(framed).collect();
        if model.shows_explanation(Explanation::Steps) {
            // Moving content has the largest place.
            framed.sort_by_key(|framed| self.shot.pictures[framed.picture].kind != View::Canonical);
        }
        let presenting = model.settings.presentation;
        let panels = if presenting { 0 } else { 2 - usize::from(model.settings.panels.narrow) };
        let arrangement = model.layout.arrangement;
        // Beside a lesson that's presented, the room is low.
        let whole = if presenting { room.size() } else { ui.ctx().content_rect().size() };
        let arrangement = arrangement.unwrap_or_else(|| automatic(whole, panels, &framed));
        let (rects, bars) = arrange(room, &framed, arrangement, &self.shares);
        for (i, bar) in bars.iter().enumerate() {
            let response = ui.interact(bar.rect, Id::unique(("between pictures", i)), Sense::CLICK | Sense::DRAG);
            let cursor = if bar.axis == Axis::X { CursorIcon::ResizeHorizontal } else { CursorIcon::ResizeVertical };
            let response = response.on_hover_and_drag_cursor(cursor);
            if response.double_clicked() {
                self.shares.reset(bar);
            } else if response.dragged()
                && let Some(pointer) = response.interact_pointer_pos()
            {
                self.shares.drag(bar, pointer);
            }
        }
        let mut panes = Vec::new();
        let handheld = is_handheld(ui.ctx());
        for (picture, rect) in rects {
            let view = self.shot.pictures[picture].kind;
            // Of one picture the tabs say the name, and its menu has the rest.
            let height = if handheld { 0.0 } else { ui.spacing().interact_size.y + 4.0 };
            let (title, below) = rect.split_top_bottom_at_y((rect.top() + height).min(rect.bottom()));
            let heading = Title {
                view,
                name: if view == View::Canonical && model.is_on_the_way() {
                    texts.on_the_way
                } else {
                    texts.view(view)
                },
                texts,
                linked: model.layout.linked,
                maximized: model.layout.maximized == Some(view),
                quiet: presenting,
                can_hide: model.layout.maximized.is_none() && framed.len() > 1,
                undistorted: undistorted(model).filter(|_| view == View::Image),
                section: (view == View::World).then_some(model.desk.shown.figure().world.section),
            };
            let mut action = if handheld { None } else { heading.show(ui, title) };
            let pane_rect = PictureRect::in_room(below, ui.pixels_per_point(), model.settings.stroke_scale());
            let response = ui.interact(pane_rect.rect, Id::unique(("picture", picture)), Sense::click_and_drag());
            let description =
                words::describe(model.settings.lang, view, model.desk.shown.camera(), model.desk.shown.figure().image);
            response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &description));
            let t = window::texts(model.settings.lang);
            response.context_menu(|ui| action = heading.context_menu(ui, t).or(action.take()));
            self.take_action(ui, model, (picture, view), action);
            focus::note(ui.ctx(), Region::Picture(picture), response.id, rect);
            let request = self.request(model, &self.shot.pictures[picture], pane_rect.size);
            panes.push(Pane { picture, view, rect: pane_rect, response, request });
        }
        panes
    }

    fn take_action(&mut self, ui: &Ui, model: &mut Model, (picture, view): (usize, View), action: Option<TitleAction>) {
        match action {
            None => return,
            Some(TitleAction::Observe(change)) => self.asked = Some((picture, change)),
            Some(TitleAction::ToggleMaximized) => toggle_maximized(model, view),
            Some(TitleAction::Hide) => model.layout.shown[view.index()] = false,
            Some(TitleAction::Do(command)) => self.wanted = Some(command),
            Some(TitleAction::ToggleUndistorted) => {
                model.desk.shown.edit(|figure| figure.undistorted = !figure.undistorted);
            }
        }
        ui.request_repaint();
    }

    /// Requests the pictures that have changed, takes finished ones, and shows the newest of each.
    fn draw(&mut self, ui: &Ui, model: &mut Model, inputs: &Inputs<'_>, panes: &mut [Pane]) {
        let (ctx, patience) = (ui.ctx(), self.patience.unwrap_or(MAX_WAIT));
        let (max_side, moving) = ui.input(|i| (i.max_texture_side, i.pointer.any_down()));
        let style = model.style();
        let scene = self.highlight.scene(model);
        for pane in panes.iter_mut() {
            let Pane { picture, view, ref mut request, .. } = *pane;
            // The changes by pointer and keys in this frame.
            let shown = &self.shot.pictures[picture];
            request.camera = shown.camera.as_ref().unwrap_or(model.desk.shown.camera()).rounded();
            (request.observer, request.hover) = (shown.observer, self.hover.seen_in(view));
            if pane.rect.size.width == 0 || pane.rect.size.height == 0 {
                continue;
            }
            let mut request = Request { scene: scene.clone(), ..pane.request.clone() };
            if let Some([_, alone]) = self.photograph_alone.as_ref().filter(|_| view == View::Image) {
                // Nobody can draw along an edge of a pale photograph behind the scene.
                (request.scene, request.hover) = (alone.clone(), Hover::default());
                Arc::make_mut(&mut request.shot).look.photograph_opacity = 1.0;
            }
            let heavy = style.antialias != Samples::One && self.rendering.is_heavy(picture, patience);
            let accounted = model.accounts_for_stages() && model.layout.strip_of == pane.view;
            if !inputs.frozen {
                self.rendering.ask(ctx, RenderJob { picture, request, draft: moving && heavy, max_side, accounted });
            }
        }
        if std::mem::replace(&mut self.faded, inputs.fades) < inputs.fades {
            let now = ui.input(|input| input.time);
            self.pictures.iter_mut().for_each(|picture| picture.texture.fade(now));
        }
        for (i, done) in self.rendering.collect(patience).into_iter().enumerate() {
            let (Some(rendered), Some(shown)) = (done, self.shot.pictures.get(i)) else { continue };
            let missing = rendered.as_ref().err().copied();
            let (tiles, account, over_budget, labels) = rendered
                .map_or((None, None, None, Vec::new()), |r| (Some(r.tiles), r.account, r.over_budget, r.labels));
            // Reported when it comes up. As long as it holds, a note is in the picture.
            let is_known =
                |new: &OverBudget| self.pictures.iter().any(|picture| picture.over_budget.as_ref() == Some(new));
            if let Some(over_budget) = over_budget.as_ref().filter(|new| !is_known(new)) {
                model.say(Message::OverBudget(over_budget.clone()));
            }
            let picture = &mut self.pictures[i];
            picture.texture.set(ctx, words::texts(model.settings.lang).view(shown.kind), tiles);
            (picture.missing, picture.account, picture.over_budget) = (missing, account, over_budget);
            picture.labels = labels;
        }
        self.report(ctx, model, panes);
        let palette = Palette::of(style.theme);
        for pane in panes.iter() {
            let texture = &mut self.pictures[pane.picture].texture;
            if !texture.covers(&pane.rect) {
                let ground = if pane.view == View::Image { palette.surround } else { palette.paper };
                let Rgba { r, g, b, .. } = ground;
                ui.painter().rect_filled(pane.rect.rect, 0.0, eframe::egui::Color32::from_rgb(r, g, b));
            }
            texture.paint(ui, &pane.rect);
        }
    }

    /// Passes the report of each picture to the side of explanations.
    fn report(&mut self, ctx: &Context, model: &mut Model, panes: &[Pane]) {
        let of = model.layout.strip_of;
        let pane = panes.iter().find(|pane| pane.view == of && model.accounts_for_stages());
        model.frame.explained = pane.map(|pane| Request { hover: Hover::default(), ..pane.request.clone() });
        if let Some((pane, request)) = pane.zip(model.frame.explained.as_ref())
            && let Some(costs) = model.costs.known(request)
            && let Some(account) = &mut self.pictures[pane.picture].account
        {
            let on_pixels = account.stages.iter_mut().filter(|report| report.stage.is_raster());
            on_pixels.for_each(|report| report.operations = costs.of_stage(report.stage));
        }
        let is_asked = model.shows_explanation(Explanation::Stages) && model.layout.is_shown(of);
        let account = self.picture_of(of).and_then(|picture| picture.account.as_ref()).filter(|_| is_asked);
        let reports = account.map(|account| account.stages.as_slice()).unwrap_or_default();
        if model.frame.reports != reports {
            model.frame.reports = reports.to_vec();
            ctx.request_repaint();
        }
    }

    /// Overlays of the pictures: borders, the focus ring, the cross hairs of the pointer.
    fn decorate(&self, ui: &Ui, model: &Model, panes: &[Pane], texts: &CanvasTexts) {
        for pane in panes {
            let rect = pane.rect.rect;
            let border = ui.visuals().widgets.noninteractive.bg_stroke;
            ui.painter().rect_stroke(rect, 0.0, border, StrokeKind::Inside);
            if pane.response.has_focus() {
                let ring = Stroke::new(2.0, ui.visuals().hyperlink_color);
                ui.painter().rect_stroke(rect, 0.0, ring, StrokeKind::Inside);
            }
            let picture = &self.pictures[pane.picture];
            if picture.missing == Some(Missing::Cancelled) {
                note(ui, rect, texts.given_up);
            } else if picture.texture.failed() {
                let font = TextStyle::Body.resolve(ui.style());
                let color = ui.visuals().error_fg_color;
                ui.painter().text(rect.center(), Align2::CENTER_CENTER, texts.not_drawn, font, color);
            }
            note(ui, rect, &loading(model));
            if pane.view == View::Image && pane.response.hovered() && self.drag.is_none() {
                cross(ui, pane);
            }
        }
    }
}

/// True if the image is shown as the eye would see it. `None` if its pixels are square, so that it makes no difference.
fn undistorted(model: &Model) -> Option<bool> {
    let figure = model.desk.shown.figure();
    let differs = model.desk.shown.camera().aspect_warning(figure.image).is_some();
    (differs || figure.undistorted).then_some(figure.undistorted)
}

/// The mesh files being read, in a sentence. Empty if there are none.
fn loading(model: &Model) -> String {
    let files = model.scene_cache.loading();
    if files.is_empty() {
        return String::new();
    }
    format!("{} {}…", window::scenes::texts(model.settings.lang).loading, files.join(", "))
}

/// A sentence over a picture.
fn note(ui: &Ui, picture: Rect, text: &str) {
    if text.is_empty() {
        return;
    }
    let font = TextStyle::Body.resolve(ui.style());
    let color = ui.visuals().text_color();
    let galley = ui.painter().layout(text.to_owned(), font, color, (picture.width() - 24.0).max(40.0));
    let place = Align2::CENTER_CENTER.anchor_size(picture.center(), galley.size());
    ui.painter().rect_filled(place.expand2(eframe::egui::vec2(8.0, 4.0)), 3.0, ui.visuals().panel_fill);
    ui.painter().galley(place.min, galley, color);
}

/// Gives a picture all the room, or restores the others.
fn toggle_maximized(model: &mut Model, view: View) {
    model.layout.maximized = if model.layout.maximized == Some(view) { None } else { Some(view) };
}

/// Two lines that cross at the pointer, within the frame of the image.
#[expect(clippy::cast_precision_loss, reason = "sides of a screen are far below 2²⁴")]
fn cross(ui: &Ui, pane: &Pane) {
    let Some(pointer) = pane.response.hover_pos() else { return };
    let (left, request) = pane.side(pointer).map_or((0, pane.request.clone()), |side| (side.left, side.request));
    let f = request.image_frame();
    let frame = pane.rect.rect_of((f.x + left) as f32, f.y as f32, f.width as f32, f.height as f32);
    if !frame.contains(pointer) {
        return;
    }
    let stroke = Stroke::new(1.0, ui.visuals().weak_text_color().gamma_multiply(0.5));
    let gap = 8.0;
    let painter = ui.painter().with_clip_rect(frame);
    for (a, b) in [
        (pos2(frame.left(), pointer.y), pos2(pointer.x - gap, pointer.y)),
        (pos2(pointer.x + gap, pointer.y), pos2(frame.right(), pointer.y)),
        (pos2(pointer.x, frame.top()), pos2(pointer.x, pointer.y - gap)),
        (pos2(pointer.x, pointer.y + gap), pos2(pointer.x, frame.bottom())),
    ] {
        painter.line_segment([a, b], stroke);
    }
    ui.set_cursor_icon(CursorIcon::Crosshair);
}
