//! The lesson being played: the bar and the text under the pictures, its task, and the list of lessons.

mod editor;
mod hands;
mod list;
pub(in crate::gui) mod moving;
mod quantity_menu;
pub(in crate::gui) mod recording;
mod speaker;
pub(in crate::gui) mod state;
mod task;
mod task_fields;
pub(in crate::gui) mod writing;

use eframe::egui::{self, Button, Key, Modifiers, RichText, ScrollArea, Ui};
pub(in crate::gui) use list::{WIDTH as LIST_WIDTH, show as list};
pub(in crate::gui) use speaker::window as speaker_window;

use crate::figure::{Explanation, Localized};
use crate::gui::kit::{Command, Explained, Region, focus, is_handheld, prose, theme};
use crate::gui::learn::exercises::state::Chosen;
use crate::gui::learn::{CAN_WRITE, Learn, lesson_link};
use crate::lessons::{self, Lesson, Link, Task};
use camera_lab_desk::{Action, Model};
use camera_lab_words::learn::lessons::Texts;
use camera_lab_words::learn::{exercises, lessons as words};
use camera_lab_words::why::notes;
use camera_lab_words::{Lang, told};

/// The share of the window that text and task may take. Longer ones are scrolled.
const SHARE: f32 = 0.42;
/// The share that they may take while they are written.
const SHARE_WRITTEN: f32 = 0.4;
/// The height of the title of a view and of the lines below the views, in points.
const AROUND_VIEWS: f32 = 68.0;
/// The share that they may take in a presentation during a question, so that the button that checks its answer is
/// visible.
const SHARE_ASKED: f32 = 0.5;
/// Lines of text that read well, in heights of a line.
const LINE: f32 = 44.0;
/// The least width at which text and task are side by side, in such lines. Large type in a presentation has little
/// height.
const BESIDE: f32 = 1.4;
const BESIDE_PRESENTED: f32 = 0.8;
/// Between a text and its task beside it.
const GUTTER: f32 = 24.0;
/// Lines of text for a question, its field, the interpretation and the verdict.
const LINES_OF_ANSWER: f32 = 12.0;
/// Lines of text for the verdict on an answer in a presentation.
const LINES_OF_VERDICT: f32 = 4.0;
/// The share of a tall window that they take, so that a long verdict has room.
const ANSWER: f32 = 0.23;
/// Seconds after which typed digits count as a number.
const TYPED: f64 = 0.9;

/// Advances the move to a step, and the typed text, at the beginning of a frame.
pub(in crate::gui) fn advance(ctx: &egui::Context, model: &mut Model, learn: &mut Learn, is_asking: bool) {
    let now = ctx.input(|input| input.time);
    let presses = |event: &egui::Event| {
        matches!(event, egui::Event::PointerButton { pressed: true, .. } | egui::Event::AccessKitActionRequest(_))
    };
    if learn.moves_to_step() && ctx.input(|input| input.raw.events.iter().any(presses)) {
        // The click is for the picture at the end of the move.
        learn.end_move(model);
    }
    if learn.go_on_moving(model, now) {
        ctx.request_repaint();
    }
    typed_step(ctx, model, learn, is_asking, now);
    hands::count(ctx, model, learn, is_asking);
    learn.check_goal(model);
}

/// Offers the first lesson and the gallery, in one line, to first-time users. Returns a command to perform.
pub(in crate::gui) fn welcome(ui: &mut Ui, model: &mut Model, learn: &mut Learn) -> Option<Command> {
    let is_fresh = model.desk.shown.path().is_none() && learn.lesson.is_none() && !model.settings.bare;
    if !(learn.welcome && is_fresh) {
        return None;
    }
    let first = lessons::shipped().first()?.lesson.clone();
    let t = words::texts(model.settings.lang);
    let mut command = None;
    let shown = egui::Panel::top("welcome").show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.label(t.new_here);
            let plays = ui.link(words::with_minutes(t.lang, &first)).clicked();
            ui.label("·");
            if ui.link(t.or_gallery).clicked() {
                command = Some(Command::Gallery);
            }
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if ui.button("✕").explained(t.no_welcome).accessible_name(t.no_welcome).clicked() {
                    learn.welcome = false;
                    model.settings.welcomed = true;
                }
            });
            plays
        })
        .inner
    });
    if shown.inner {
        model.request(Action::Offered(lessons::OpenLesson { lesson: first, path: None, step: 0 }));
    }
    if command.is_some() {
        learn.take_offer(model);
    }
    command
}

/// Offers to continue from the last time, in one line, with the lesson that was begun, an exercise, or the list of
/// lessons.
pub(in crate::gui) fn go_on(ui: &mut Ui, model: &mut Model, learn: &mut Learn) {
    let is_fresh = model.desk.shown.path().is_none() && learn.lesson.is_none() && !model.settings.bare;
    let Some((lesson, step)) = learn.place_to_go_on().filter(|_| learn.goes_on && is_fresh) else { return };
    let lang = model.settings.lang;
    let t = words::texts(lang);
    let mut open = None;
    egui::Panel::top("go on").show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.label(format!("{}:", t.go_on));
            if ui.link(words::go_on(lang, lesson, step)).clicked() {
                open = Some(lessons::OpenLesson { lesson: lesson.clone(), path: None, step });
            }
            ui.label("·");
            if ui.link(t.practise).clicked() && learn.exercises.practise() {
                model.show_explanation(Explanation::Exercises);
                learn.goes_on = false;
            }
            ui.label("·");
            if ui.link(t.lessons).clicked() {
                model.request(Action::Lessons);
            }
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if ui.button("✕").explained(t.no_go_on).accessible_name(t.no_go_on).clicked() {
                    learn.goes_on = false;
                }
            });
        });
    });
    if let Some(open) = open {
        model.request(Action::Offered(open));
    }
}

/// In a presentation, digits are the number of a step. The lesson goes to it after a moment, or at Enter.
fn typed_step(ctx: &egui::Context, model: &mut Model, learn: &mut Learn, is_asking: bool, now: f64) {
    let listens = model.settings.presentation && !ctx.text_edit_focused() && !is_asking;
    let Some(playing) = learn.lesson.as_mut().filter(|_| listens) else { return };
    // In their order, and each as often as it was pressed, because a slow frame brings several.
    ctx.input_mut(|input| {
        input.events.retain(|event| {
            let egui::Event::Key { key, pressed: true, repeat: false, modifiers: Modifiers::NONE, .. } = event else {
                return true;
            };
            let Some((digit, _)) = (0_usize..).zip(DIGITS).find(|(_, of)| of == key) else { return true };
            let before = playing.typed.map_or(0, |(number, _)| number % 100);
            playing.typed = Some((10 * before + digit, now));
            false
        });
    });
    let Some((number, since)) = playing.typed else { return };
    let is_whole = now - since > TYPED || ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
    if is_whole {
        playing.typed = None;
        if let Some(step) = number.checked_sub(1) {
            learn.go_to_step(model, step);
        }
    } else {
        ctx.request_repaint_after(std::time::Duration::from_secs_f64(TYPED - (now - since)));
    }
}

const DIGITS: [Key; 10] =
    [Key::Num0, Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];

/// The bar of the lesson, and the text and the task of its step, below the pictures. Returns a command to perform. All
/// steps have one height, so that nothing moves under the pointer.
pub(in crate::gui) fn panel(ui: &mut Ui, model: &mut Model, learn: &mut Learn) -> Option<Command> {
    let playing = learn.lesson.as_ref()?;
    let key = (playing.lesson.id.clone(), playing.step);
    let t = words::texts(model.settings.lang);
    let ctx = ui.ctx().clone();
    let asks = playing.shows_question && playing.now().is_some_and(|step| matches!(step.task, Some(Task::Question(_))));
    let (writes, presents) = (learn.writes_lesson(model), model.settings.presentation);
    let share = match (writes, presents && asks) {
        (true, _) => SHARE_WRITTEN,
        (false, true) => SHARE_ASKED,
        (false, false) => SHARE,
    };
    let height = ctx.content_rect().height();
    let notes = speaker::are_below(&ctx, model, playing);
    // With notes too, the pictures keep half of the height, without the title of a view and the lines below.
    let left = if presents && notes { ui.available_height() - 0.5 * height - AROUND_VIEWS } else { f32::INFINITY };
    let most = left.clamp(2.0 * ui.spacing().interact_size.y, share * height);
    let shows = writes || playing.shows_text || notes || playing.shows_question && !playing.is_done();
    // Beside an exercise it's narrower, and as high as elsewhere.
    let size = ctx.content_rect().size();
    let asks = (presents && asks).then_some(playing.step);
    let below = [playing.shows_text, notes, playing.hands.answered == Some(playing.step)];
    let fits = Fits { size, lang: t.lang, writes, presents, asks, below, shows };
    let kept = playing.height.as_ref().filter(|(kept, _)| *kept == fits).map(|(_, height)| *height);
    let mut height = match kept {
        Some(height) => height,
        _ if writes || asks.is_some() && shows => most,
        _ => first_height(ui, t, learn, &fits).min(most),
    };
    let panel = egui::Panel::bottom("lesson").resizable(false).exact_size(height).show(ui, |ui| {
        focus::region(ui, ui.max_rect(), Region::Lesson, t.region);
        let command = bar(ui, t, model, learn);
        if writes {
            editor::tools(ui, t, model, learn);
        }
        let mut is_cut = false;
        if shows {
            ui.add_space(2.0);
            // As low as its text, because if it were taller than its panel, it would push the bar out of sight.
            let area = ScrollArea::vertical().id_salt(key).min_scrolled_height(0.0).auto_shrink(false);
            let shown =
                area.show(ui, |ui| if writes { written(ui, t, model, learn) } else { content(ui, t, model, learn) });
            let room = shown.inner_rect.height();
            is_cut = shown.content_size.y > room;
            if asks.is_some() && kept.is_none() {
                // As high as the question, with room for its verdict, because the question is about the pictures.
                let verdict = LINES_OF_VERDICT * ui.text_style_height(&egui::TextStyle::Body);
                height = most.min(height - room + shown.content_size.y + verdict);
                ui.ctx().request_discard("the height of a question");
            }
        }
        (command, is_cut)
    });
    let (command, is_cut) = panel.inner;
    if let Some(playing) = &mut learn.lesson {
        playing.is_cut = is_cut;
        playing.height = Some((fits, height));
    }
    command
}

/// The state that the height of the panel depends on.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::gui) struct Fits {
    size: egui::Vec2,
    lang: Lang,
    writes: bool,
    presents: bool,
    /// The step whose question is shown, in a presentation.
    asks: Option<usize>,
    /// The text, the notes and the counted hands are shown.
    below: [bool; 3],
    /// True if there is more than the bar.
    shows: bool,
}

/// The height for the tallest text of all steps, and with a question for its answer and the verdict.
fn first_height(ui: &mut Ui, t: &Texts, learn: &Learn, fits: &Fits) -> f32 {
    let margin = egui::Frame::side_top_panel(ui.style()).total_margin().sum();
    let bar = ui.spacing().interact_size.y + 2.0 * ui.spacing().item_spacing.y + margin.y + 4.0;
    let Some(playing) = learn.lesson.as_ref().filter(|_| fits.shows) else { return bar };
    let line = ui.text_style_height(&egui::TextStyle::Body);
    let width = fits.size.x - margin.x;
    let tallest = playing.lesson.steps.iter().enumerate().map(|(k, step)| {
        let asks = step.task.is_some() && !fits.presents;
        let column = egui::vec2(column(ui, width, fits.presents, asks), f32::INFINITY);
        let place = egui::Rect::from_min_size(ui.max_rect().min, column);
        let hidden = egui::UiBuilder::new().id_salt(("height of a step", k)).max_rect(place).invisible();
        let mut hidden = ui.new_child(hidden);
        if !fits.presents {
            hidden.add(egui::Label::new(RichText::new(told(t.lang, &step.title)).heading()).wrap());
        }
        // A matrix of numbers is as tall as four lines.
        let text = match lessons::numbers_of(&step.figure) {
            Ok(report) => words::filled_from(t.lang, &step.text, &report),
            Err(_) => told(t.lang, &step.text).to_owned(),
        };
        prose::show(&mut hidden, text.trim());
        if !step.links.is_empty() && !fits.presents {
            hidden.add_space(line);
        }
        let [_, with_notes, _] = fits.below;
        if let Some(notes) = step.notes.as_ref().filter(|_| with_notes) {
            // With their heading and the line above it.
            hidden.add_space(2.0 * line);
            prose::show(&mut hidden, told(t.lang, notes).trim());
        }
        hidden.min_rect().height()
    });
    let text = tallest.fold(0.0, f32::max);
    // In a presentation one line indicates a question.
    let asked = (LINES_OF_ANSWER * line).max(ANSWER * fits.size.y);
    bar + if fits.presents { text + 1.5 * line } else { text.max(asked) }
}

/// The width of a text: half of the panel, if the task is beside it.
fn column(ui: &Ui, available: f32, presents: bool, asks: bool) -> f32 {
    let line = LINE * ui.text_style_height(&egui::TextStyle::Body);
    let least = if presents { BESIDE_PRESENTED } else { BESIDE };
    if asks && available > least * line { 0.5 * (available - GUTTER) } else { available.min(1.4 * line) }
}

/// One line: title, number of the step, the ways on.
fn bar(ui: &mut Ui, t: &Texts, model: &mut Model, learn: &mut Learn) -> Option<Command> {
    let lang = t.lang;
    // A lesson of the program or of a link is copied first.
    let is_own = learn.plays_own_lesson(model);
    let can_write = CAN_WRITE && !model.in_browser && !model.settings.presentation;
    let playing = learn.lesson.as_ref()?;
    let writing = playing.writing.is_some();
    let lesson = playing.lesson.clone();
    let (step, count, may_go_on, moved) = (
        playing.step,
        lesson.steps.len(),
        playing.may_go_on(),
        model.desk.shown.is_changed() && playing.moving.is_none(),
    );
    let mut command = None;
    let mut go_to = None;
    let is_small = is_handheld(ui.ctx());
    let sign = |sign: &'static str, words: String| if is_small { sign.to_owned() } else { words };
    ui.horizontal(|ui| {
        let back = Button::new(sign("◀", format!("◀ {}", t.back)));
        if ui.add_enabled(step > 0, back).explained(t.back_hint).accessible_name(format!("◀ {}", t.back)).clicked() {
            command = Some(Command::PreviousFigure);
        }
        let (label, hint) = if may_go_on { (t.next, t.next_hint) } else { (t.pass, t.pass_hint) };
        if step + 1 < count {
            let next = Button::new(RichText::new(format!("{label} ▶")).strong());
            if ui.add(next).explained(hint).clicked() {
                learn.pass_over();
                command = Some(Command::NextFigure);
            }
        } else if let Some(next) = after(&lesson) {
            let name = format!("{}: {} ▶", t.go_on_with, told(lang, &next.title));
            if ui.button(sign("▶", name.clone())).accessible_name(name).clicked() {
                model.request(Action::lesson(next, 0));
            }
        }
        let place = words::place(lang, step + 1, count);
        ui.menu_button(format!("{place} ▾"), |ui| {
            for (k, other) in lesson.steps.iter().enumerate() {
                let name = format!("{}. {}", k + 1, told(lang, &other.title));
                if ui.selectable_label(k == step, name).clicked() {
                    go_to = Some(k);
                    ui.close();
                }
            }
        })
        .response
        .explained(t.all_steps);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if ui.button("✕").explained(t.leave).accessible_name(t.leave).clicked() {
                command = Some(Command::LeaveLesson);
            }
            let (name, hint) = if is_own { (t.write_command, t.write_hint) } else { (t.copy_title, t.copy_title) };
            if can_write && ui.selectable_label(writing, "✎").explained(hint).accessible_name(name).clicked() {
                command = Some(Command::WriteLesson);
            }
            let again = Button::new(sign("↺", t.again.to_owned()));
            if ui.add_enabled(moved, again).explained(t.again_hint).accessible_name(t.again).clicked() {
                command = Some(Command::StepAgain);
            }
            if !is_small {
                let title = RichText::new(told(lang, &lesson.title)).weak();
                ui.add(egui::Label::new(title).truncate().selectable(false));
            }
        });
    });
    if let Some(step) = go_to {
        learn.go_to_step(model, step);
    }
    command
}

/// The built-in lesson after another one.
fn after(lesson: &Lesson) -> Option<std::sync::Arc<Lesson>> {
    let all = lessons::shipped();
    let place = all.iter().position(|shipped| shipped.lesson.id == lesson.id)?;
    all.get(place + 1).map(|shipped| shipped.lesson.clone())
}

/// The fields of the step or of the lesson, beside their preview.
fn written(ui: &mut Ui, t: &'static Texts, model: &mut Model, learn: &mut Learn) {
    ui.horizontal_top(|ui| {
        let half = 0.5 * (ui.available_width() - GUTTER);
        ui.vertical(|ui| {
            ui.set_width(half);
            editor::fields(ui, t, model, learn);
        });
        ui.add_space(GUTTER - ui.spacing().item_spacing.x);
        ui.vertical(|ui| {
            ui.set_width(half);
            match learn.lesson.as_ref().and_then(|playing| Some((playing, playing.writing.as_ref()?))) {
                Some((playing, writing)) if writing.shows == writing::Fields::Lesson => {
                    whole(ui, writing.lang, &playing.lesson);
                }
                _ => content(ui, t, model, learn),
            }
        });
    });
}

/// Title, minutes and sentence of the lesson, as in the list.
fn whole(ui: &mut Ui, lang: Lang, lesson: &Lesson) {
    ui.add(egui::Label::new(RichText::new(words::with_minutes(lang, lesson)).heading()).wrap());
    if let Some(sentence) = &lesson.sentence {
        prose::show(ui, told(lang, sentence).trim());
    }
}

/// Text, task, links and notes of the step.
fn content(ui: &mut Ui, t: &'static Texts, model: &mut Model, learn: &mut Learn) {
    let Some(playing) = learn.lesson.as_ref() else { return };
    let Some(step) = playing.now().cloned() else { return };
    let writing = playing.writing.as_ref().filter(|_| learn.writes_lesson(model));
    let shows_text = playing.shows_text || writing.is_some();
    let shows_notes = speaker::are_below(ui.ctx(), model, playing) || writing.is_some();
    // The preview is in the language of the fields.
    let lang = writing.map_or(t.lang, |writing| writing.lang);
    // The numbers of the figure on the screen.
    let report = lessons::numbers_of(model.desk.shown.figure()).or_else(|_| lessons::numbers_of(&step.figure)).ok();
    let text = |text: &Localized| match &report {
        Some(report) => words::filled_from(lang, text, report),
        None => told(lang, text).to_owned(),
    };
    let presents = model.settings.presentation;
    // A text with a fault is shown as it's typed.
    let faulty = writing.filter(|writing| writing.fault.is_some()).map(|writing| writing.typed.words.clone());
    let [title, body] = faulty.as_ref().map_or([&step.title, &step.text], |[title, body, ..]| [title, body]);
    let say = |ui: &mut Ui| {
        if !presents {
            ui.add(egui::Label::new(RichText::new(told(lang, title)).heading()).wrap());
        }
        prose::show(ui, text(body).trim());
    };
    let asks = step.task.is_some() && learn.lesson.as_ref().is_some_and(|playing| playing.shows_question);
    // An exercise takes one line here.
    let is_beside = asks && (presents || !matches!(step.task, Some(Task::Exercise { .. })));
    let half = column(ui, ui.available_width(), presents, is_beside);
    if shows_text && is_beside && half < 0.5 * ui.available_width() {
        // Side by side they leave the pictures more room.
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| {
                ui.set_width(half);
                say(ui);
            });
            ui.add_space(GUTTER - ui.spacing().item_spacing.x);
            ui.vertical(|ui| {
                // Without a width of its own, a field that wants more would extend beyond the window.
                ui.set_width(half);
                task::show(ui, t, model, learn, &step, &text);
            });
        });
    } else {
        ui.set_max_width(half);
        if shows_text {
            say(ui);
        }
        task::show(ui, t, model, learn, &step, &text);
    }
    links(ui, t, model, learn, &step.links);
    if let Some(notes) = step.notes.as_ref().filter(|_| shows_notes) {
        ui.separator();
        if presents {
            ui.label(RichText::new(t.notes_private).strong().color(ui.visuals().warn_fg_color));
        } else {
            ui.weak(t.notes_command);
        }
        prose::show(ui, text(notes).trim());
    }
    ui.add_space(2.0);
}

/// Buttons that lead from the step to notes, exercises and lessons.
fn links(ui: &mut Ui, t: &Texts, model: &mut Model, learn: &mut Learn, links: &[Link]) {
    if links.is_empty() || model.settings.presentation {
        return;
    }
    let lang = t.lang;
    ui.horizontal_wrapped(|ui| {
        for link in links {
            match link {
                Link::Note(id) => {
                    let Some(note) = notes::note(lang, id) else { continue };
                    let name = format!("{}: {}", t.read_more, notes::plain(note.title));
                    let job = theme::sentence(ui, &name, &egui::TextStyle::Body, ui.visuals().hyperlink_color);
                    if ui.link(job).accessible_name(name).clicked() {
                        model.request(Action::Note(note.id));
                    }
                }
                Link::Exercise(id, seed) => {
                    let Some(entry) = crate::exercises::entry(id) else { continue };
                    if ui.link(format!("{}: {}", t.practise, exercises::title(lang, entry))).clicked() {
                        learn.exercises.work_on(Chosen { id: id.clone(), seed: *seed });
                        model.show_explanation(Explanation::Exercises);
                    }
                }
                Link::Lesson(id, step) => {
                    if let Some(other) = lessons::shipped().iter().find(|other| other.lesson.id == *id) {
                        lesson_link(ui, model, &other.lesson, *step);
                    }
                }
            }
        }
    });
}
