//! A frame of the window, in five phases: the input, the panels, the pictures, the dialogs, and the work in the
//! background.
//!
//! Their order is the protocol between them. Keys change the figure before a panel shows it. The panels note the target
//! of the pointer, and the pictures mark it in the same frame. Dialogs lie over both. After everything has been shown,
//! the changes are committed and handed to the threads that write files.

use std::time::Duration;

use eframe::egui;

use super::command::show_lessons;
use super::state::State;
use super::{App, dialogs, menu, presentation, status};
use crate::figure::Explanation;
use crate::gui::app::file_flow::questions::{Dialog, Purpose};
use crate::gui::app::file_flow::{self, ask, begin};
use crate::gui::inspector::state::compare::CompareForm;
use crate::gui::inspector::{numerics, operations, parameters, values};
use crate::gui::kit::handheld::{self, side_panel};
use crate::gui::kit::{Command, Region, context_help, focus, frames, text_field, tooltip};
use crate::gui::learn::{exercises, lesson};
use crate::gui::storage::recovery::{self, Decision};
use crate::gui::storage::session_news;
use crate::gui::views::long_work::is_long;
use crate::gui::views::{Canvas, Inputs, motion};
use crate::gui::why;
use camera_lab_desk::{Action, Intent, Kept, Message, Model, PanelHover, Side};
use camera_lab_words::window::{self, Texts};

/// Below this width, in points, there is room for only one panel beside the pictures.
const NARROW: f32 = 960.0;

/// Commands that the panels have called, performed after the pictures have been shown.
#[derive(Default)]
struct Called {
    of_bar: Option<Command>,
    of_lesson: Option<Command>,
}

impl App {
    /// Shows one frame. `ui` is the whole window.
    pub fn show(&mut self, ui: &mut egui::Ui) {
        let ctx = ui.ctx().clone();
        self.input(&ctx);
        let called = self.panels(ui);
        self.pictures(ui, called);
        self.dialogs(&ctx);
        self.background(&ctx);
    }

    /// Advances animations, and performs the commands of the keyboard.
    fn input(&mut self, ctx: &egui::Context) {
        let os = ctx.os();
        ctx.input_mut(|input| {
            text_field::cut_pasted(&mut input.events);
            text_field::drop_letters_with_alt(&mut input.events, os);
        });
        self.caret.follow(ctx);
        motion::advance(ctx, &mut self.state.model);
        lesson::advance(ctx, &mut self.state.model, &mut self.state.learn, self.state.file_flow.is_asking());
        if ctx.input(|input| self.held_key.follow(input)) {
            self.state.model.desk.commit();
        }
        self.focus.begin(ctx, self.state.file_flow.is_asking());
        file_flow::poll(ctx, &mut self.state);
        let of_files = self.state.file_flow.running(self.state.model.settings.lang);
        if !self.state.file_flow.is_asking() && self.canvas.listen_for_cancel(ctx, &mut self.state.model, &of_files) {
            self.state.file_flow.cancel(is_long);
        }
        if !self.canvas.holds_something(&self.state.model)
            && let Some(command) =
                presentation::escape(ctx, &self.state.model, &self.state.file_flow, &self.state.annotations)
        {
            self.perform(ctx, command);
        }
        // Each key press acts in its turn. If one opens a dialog, later keys are for the dialog.
        while !self.state.file_flow.is_asking()
            && let Some(command) = self.keyboard(ctx)
        {
            match context_help::asked(ctx).filter(|_| command == Command::Help) {
                Some(note) => self.state.explain.explain_by_note(&mut self.state.model, note),
                None => self.perform(ctx, command),
            }
        }
        context_help::begin(ctx);
        self.state.model.frame.asked = self.state.learn.asked(&self.state.model);
        // The panels of this frame set the hover.
        self.state.model.frame.hover = PanelHover::default();
        handheld::fit_controls(ctx);
        self.state.model.settings.panels_mut().narrow = ctx.content_rect().width() < NARROW;
        if let Some(left) = self.state.model.forget_old_news(ctx.input(|input| input.time)) {
            ctx.request_repaint_after(Duration::from_secs_f64(left));
        }
    }

    /// Bars and panels around the pictures.
    fn panels(&mut self, ui: &mut egui::Ui) -> Called {
        let ctx = ui.ctx().clone();
        let t = window::texts(self.state.model.settings.lang);
        let presenting = self.state.model.settings.presentation;
        let of_bar = (!self.state.model.settings.bare && !presenting).then(|| {
            egui::Panel::top("menu").show(ui, |ui| {
                focus::region(ui, ui.max_rect(), Region::Bar, t.region_bar);
                menu::bar(ui, &self.state)
            })
        });
        let of_bar = of_bar.and_then(|bar| bar.inner);
        // Notices wait until the end of the presentation.
        if !presenting {
            self.notices(ui);
        }
        status::error(ui, &mut self.state.model);
        if presenting {
            presentation::caption(ui, &self.state.model, &self.state.learn);
        }
        // The exercise of a step has the whole height, because it's longer than the text of the step.
        let has_height = !presenting && self.state.learn.works_on_step() && self.state.model.shows_exercises();
        if has_height {
            self.explanation_panel(ui, t);
        }
        let of_lesson = lesson::panel(ui, &mut self.state.model, &mut self.state.learn);
        self.side_panels(ui, t, !has_height);
        tooltip::beside_nothing(&ctx);
        if let Some(note) = context_help::called(&ctx) {
            self.state.explain.explain_by_note(&mut self.state.model, note);
        }
        motion::show_done(&ctx, &mut self.state.model);
        self.state.model.follow_panels();
        self.state.model.frame.answered = self.state.learn.exercises.answered_camera();
        Called { of_bar, of_lesson }
    }

    /// News and offers, each in a line of its own.
    fn notices(&mut self, ui: &mut egui::Ui) {
        self.end_start(ui.ctx());
        self.recovery(ui);
        session_news::bar(ui, self.state.model.settings.lang, &mut self.state.file_flow.news);
        if let Some(intent) = status::changed_file(ui, &self.state.model, &mut self.state.file_flow) {
            begin(ui.ctx(), &mut self.state, intent);
        }
        if let Some(command) = lesson::welcome(ui, &mut self.state.model, &mut self.state.learn) {
            self.perform(ui.ctx(), command);
        }
        lesson::go_on(ui, &mut self.state.model, &mut self.state.learn);
    }

    /// Once the user has begun something, the lines about the start go: the offers, and that the session was restored.
    fn end_start(&mut self, ctx: &egui::Context) {
        let State { model, learn, file_flow, .. } = &mut self.state;
        let now = (model.desk.shown.id(), model.desk.shown.version(), file_flow.news.has_restored());
        let id = egui::Id::unique("figure of the start");
        let start = ctx.data_mut(|data| *data.get_temp_mut_or_insert_with(id, || now));
        if now == start {
            return;
        }
        // Restoring another session is a start too.
        if now.2 == start.2 {
            learn.take_offer(model);
            file_flow.news.forget_restored();
        }
        ctx.data_mut(|data| data.insert_temp(id, (now.0, now.1, file_flow.news.has_restored())));
    }

    /// The open panels: studies below, parameters at the left, operations and explanations at the right.
    fn side_panels(&mut self, ui: &mut egui::Ui, t: &Texts, with_explanation: bool) {
        let sides = *self.state.model.settings.panels();
        let lesson = self.state.learn.lesson.is_some();
        if self.state.numerics.shown {
            egui::Panel::bottom("numerics").default_size(290.0).size_range(200.0..=520.0).show(ui, |ui| {
                focus::region(ui, ui.max_rect(), Region::Numerics, t.numerics);
                numerics::ui(ui, &mut self.state.model, &mut self.state.numerics);
            });
            name_handle(ui, "numerics", t.panel_width);
        }
        if sides.is_shown(Side::Left) {
            side_panel(ui.ctx(), egui::Panel::left("parameters"), (256.0, (220.0..=420.0).into()), lesson).show(
                ui,
                |ui| {
                    focus::region(ui, ui.max_rect(), Region::Parameters, t.parameters_panel);
                    tooltip::beside_panel(ui, egui::RectAlign::RIGHT_START);
                    parameters::ui(ui, &mut self.state.model);
                },
            );
            name_handle(ui, "parameters", t.panel_width);
        }
        if sides.is_shown(Side::Right) {
            side_panel(ui.ctx(), egui::Panel::right("numbers"), (316.0, (260.0..=520.0).into()), lesson).show(
                ui,
                |ui| {
                    focus::region(ui, ui.max_rect(), Region::Numbers, t.numbers_panel);
                    tooltip::beside_panel(ui, egui::RectAlign::LEFT_START);
                    self.right(ui);
                },
            );
            name_handle(ui, "numbers", t.panel_width);
        }
        if sides.is_shown(Side::Explain) && with_explanation {
            self.explanation_panel(ui, t);
        }
    }

    fn explanation_panel(&mut self, ui: &mut egui::Ui, t: &Texts) {
        let presenting = self.state.model.settings.presentation;
        // In a presentation the pictures keep more than half of the width.
        let (id, share) = if presenting { ("explain in a presentation", 0.45) } else { ("explain", 1.0) };
        let most = (share * ui.ctx().content_rect().width()).clamp(320.0, 620.0);
        let lesson = self.state.learn.lesson.is_some();
        side_panel(ui.ctx(), egui::Panel::right(id), (400.0, (320.0..=most).into()), lesson).show(ui, |ui| {
            focus::region(ui, ui.max_rect(), Region::Numbers, t.explain_panel);
            tooltip::beside_panel(ui, egui::RectAlign::LEFT_START);
            self.explanation(ui);
        });
        name_handle(ui, id, t.panel_width);
    }

    /// The chosen explanation. Other features show the exercises, and the matrices in the chosen conventions.
    fn explanation(&mut self, ui: &mut egui::Ui) {
        let State { model, explain, learn, .. } = &mut self.state;
        why::head(ui, model, explain);
        let shown = model.explained.shown();
        if shown == Explanation::Exercises {
            exercises::head(ui, model, learn);
            ui.separator();
        }
        egui::ScrollArea::vertical().id_salt(("explain", shown)).auto_shrink(false).show(ui, |ui| {
            match shown {
                Explanation::Exercises => exercises::ui(ui, model, learn),
                // Nearly each of them prints nearly every number.
                shown if shown != Explanation::Notes && !model.frame.asked.is_empty() => {
                    why::asked(ui, model);
                }
                _ => why::content(ui, model, explain),
            }
            if shown == Explanation::Conventions && model.frame.asked.is_empty() {
                let compared = model.settings.conventions.compared;
                values::list(ui, model, false, compared, |table| table.is_matrix());
            }
            focus::keep_in_sight(ui);
        });
    }

    /// Operations above, at their own height but not more than about half if the numbers below are unfolded.
    fn right(&mut self, ui: &mut egui::Ui) {
        let share = if self.state.model.settings.numbers_open { 0.56 } else { 0.8 };
        let half = ui.available_height() * share;
        egui::ScrollArea::vertical().id_salt("operations").max_height(half).auto_shrink([false, true]).show(ui, |ui| {
            operations::ui(ui, &mut self.state.model);
            focus::keep_in_sight(ui);
        });
        ui.add_space(4.0);
        egui::ScrollArea::vertical().id_salt("numbers").auto_shrink(false).show(ui, |ui| {
            values::ui(ui, &mut self.state.model);
            focus::keep_in_sight(ui);
        });
    }

    /// Shows the pictures, then performs the commands that they and the panels have called.
    fn pictures(&mut self, ui: &mut egui::Ui, called: Called) {
        let ctx = ui.ctx().clone();
        let pictures = egui::CentralPanel::no_frame().show(ui, |ui| pictures(ui, &mut self.canvas, &mut self.state));
        if let Some(command) = self.canvas.wanted.take() {
            self.perform(&ctx, command);
        }
        let is_down = ctx.input(|input| input.pointer.any_down());
        self.state.model.check_camera(&frames(&ctx), is_down);
        self.state.model.count_pixels(&frames(&ctx), is_down);
        let State { learn, annotations, .. } = &mut self.state;
        presentation::show(&ctx, learn, annotations, pictures.response.rect);
        let presenting = self.state.model.settings.presentation;
        let of_bar = if presenting { presentation::bar(&ctx, &self.state) } else { called.of_bar };
        status::toast(&ctx, &self.state.model, pictures.response.rect);
        if let Some(command) = of_bar {
            self.perform(&ctx, command);
        }
        let of_speaker = lesson::speaker_window(&ctx, &self.state.model, &mut self.state.learn);
        // The speaker's window doesn't know of questions in this one.
        let of_speaker = of_speaker.filter(|_| !self.state.file_flow.is_asking());
        if let Some(command) = called.of_lesson.or(of_speaker) {
            self.perform(&ctx, command);
        }
    }

    /// A question or a form over the window, the action that a feature has requested, and the sign for a dropped file.
    fn dialogs(&mut self, ctx: &egui::Context) {
        if let Some(command) = dialogs::show(ctx, &mut self.state) {
            self.perform(ctx, command);
            ctx.request_repaint();
        }
        perform_request(ctx, &mut self.state);
        drop_hint(ctx, &self.state.model);
        self.resting.show(ctx, self.state.model.settings.presentation);
        self.focus.end(ctx);
    }

    /// Settings and title for the system, then session and preferences. A moving figure is stored when it rests.
    fn background(&mut self, ctx: &egui::Context) {
        self.apply_settings(ctx);
        self.refuse_links(ctx);
        self.update_title(ctx);
        let moves = self.state.learn.lesson.as_ref().is_some_and(|playing| playing.moving.is_some());
        let moving = self.state.model.motion.is_some() || moves || self.state.model.explained.steps.plays();
        if moving || ctx.input(|input| input.pointer.any_down()) || self.held_key.is_held(ctx) {
            return;
        }
        self.state.model.desk.commit();
        if self.state.model.desk.shown.take_operations_gone() {
            self.state.model.say(Message::OperationsGone);
        }
        let now = ctx.input(|input| input.time);
        if let Some(left) = self.state.model.views.follow(self.state.model.desk.shown.figure().observers, now) {
            ctx.request_repaint_after(Duration::from_secs_f64(left));
        }
        if let Some(sessions) = &mut self.sessions {
            let seen = self.state.model.as_seen();
            let state = &self.state;
            let explains = state.learn.lesson.is_none() && state.model.desk.shown.explains_other(&seen.show);
            let is_work = state.model.is_unsaved() || explains;
            let shown =
                Kept { document: &state.model.desk.shown, seen: &seen, is_work, text: state.learn.unsaved_text() };
            sessions.keep(&frames(ctx), shown, &state.model.desk.held());
        }
        if let Some(preferences) = &mut self.preferences {
            preferences.keep(ctx, &mut self.state);
        }
    }

    /// The list of left sessions, and the user's decision.
    fn recovery(&mut self, ui: &mut egui::Ui) {
        let Some(sessions) = &mut self.sessions else { return };
        let decision = recovery::list(ui, self.state.model.settings.lang, sessions.left());
        match decision {
            Some(Decision::Restore(slot)) => begin(ui.ctx(), &mut self.state, Intent::Restore(slot)),
            Some(Decision::Discard(slot)) => sessions.discard(slot),
            None => {}
        }
        if let Some(slot) = self.state.file_flow.restore.take() {
            let left = sessions.restore(slot);
            self.go_on_with(left);
        }
        self.show_notices();
    }
}

/// Shows the pictures with their inputs from other features, and hands on the mark that the user puts there.
pub fn pictures(ui: &mut egui::Ui, canvas: &mut Canvas, state: &mut State) {
    let State { model, learn, annotations, explain, file_flow, .. } = state;
    let placing = learn.placing(model);
    let mark = placing.as_ref().and_then(|placing| placing.mark);
    let mut inputs = Inputs {
        placing,
        fades: learn.lesson.as_ref().map_or(0, |playing| playing.fades),
        keys: presentation::keys(ui.ctx(), model, learn, annotations),
        frozen: annotations.frozen,
        of_files: file_flow.running(model.settings.lang),
        triangle_waits: explain.triangle.is_searched(),
        on_triangle: &mut |ctx, model, request, pointer, triangle| {
            why::clicked(ctx, model, explain, request, pointer, triangle)
        },
    };
    canvas.ui(ui, model, &mut inputs);
    if let Some(placing) = inputs.placing
        && let Some(place) = placing.mark.filter(|place| mark != Some(*place))
    {
        learn.put_mark(model, &placing.of, place);
    }
}

/// Names the handle of a panel in the language of the window, because egui's own name for it is English.
fn name_handle(ui: &egui::Ui, panel: &str, name: &str) {
    let handle = ui.scope_id().with_salt(egui::IdSalt::new(panel)).with("__resize");
    ui.ctx().accesskit_node_builder(handle, |node| node.set_label(name));
}

/// Shows the effect of dropping a file held over the window.
fn drop_hint(ctx: &egui::Context, model: &Model) {
    if ctx.input(|input| input.raw.hovered_files.is_empty()) {
        return;
    }
    let painter = ctx.layer_painter(egui::LayerId::new(egui::Order::Foreground, egui::Id::unique("drop")));
    let (rect, visuals) = (ctx.content_rect(), ctx.global_style().visuals.clone());
    painter.rect_filled(rect, 0.0, visuals.panel_fill.gamma_multiply(0.85));
    let text = window::texts(model.settings.lang).drop_here;
    let font = egui::FontId::proportional(24.0);
    painter.text(rect.center(), egui::Align2::CENTER_CENTER, text, font, visuals.text_color());
}

/// Performs the action that was requested in this frame, if any.
fn perform_request(ctx: &egui::Context, state: &mut State) {
    let Some(action) = state.model.frame.request.take() else { return };
    ctx.request_repaint();
    let dialog = match action {
        Action::File(file) => return ask(ctx, state, Purpose::For(file)),
        Action::Begin(next) => return begin(ctx, state, next),
        Action::Offered(open) => {
            begin(ctx, state, Intent::Lesson(open));
            // It stays if the question about changes is open.
            if state.learn.lesson.is_some() {
                state.learn.take_offer(&mut state.model);
            }
            return;
        }
        Action::Examine => {
            (state.numerics.shown, state.numerics.of_figure) = (true, true);
            return;
        }
        Action::Note(note) => return state.explain.explain_by_note(&mut state.model, note),
        Action::Lessons => return show_lessons(state),
        Action::Delete { names, below } => Dialog::Delete { names, below },
        Action::DeleteProgress => Dialog::DeleteProgress,
        Action::Coach => Dialog::Coach,
        Action::Compare => Dialog::Compare(CompareForm::of(state.model.desk.shown.figure())),
    };
    state.file_flow.dialog = Some(dialog);
}
