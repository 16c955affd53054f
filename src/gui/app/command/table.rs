//! The rows of the commands: words, keys, conditions and effects.

use eframe::egui::{Context, Key, KeyboardShortcut, Modifiers, ViewportCommand};

use super::{CommandRow, InBrowser, Menu};
use crate::appearance;
use crate::camera::Framing;
use crate::gui::app::file_flow;
use crate::gui::app::file_flow::hand_out;
use crate::gui::app::file_flow::questions::{Dialog, FileFlow, HandOut, Purpose, TitleForm};
use crate::gui::app::search::Search;
use crate::gui::app::state::State;
use crate::gui::export::family_choice::Subject;
use crate::gui::gallery::Part;
use crate::gui::inspector::number_tables;
use crate::gui::inspector::state::compare::{CompareForm, swap};
use crate::gui::kit::keys::Command::{self, *};
use crate::gui::learn::Learn;
use crate::gui::learn::handout::form::HandoutForm;
use crate::gui::learn::lesson::state::Playing;
use crate::views::observer::Viewpoint;
use crate::views::{Arrangement, View};
use camera_lab_desk::settings::Settings;
use camera_lab_desk::{Intent, Message, Model, ObserverChange, Panels, Side, layout};
use camera_lab_files::{self as files, Overwrite};
use camera_lab_words::class;
use camera_lab_words::learn::{handouts, lessons};
use camera_lab_words::window::{Texts, cameras, canvas, compare, labels, sharing};

/// A row: command, keys, the names of label and hint, and the effect: a flag, one of several values in the state, or
/// otherwise a function. The names are those of texts of the window, or of the texts before `::`.
macro_rules! row {
    ($command:expr, $keys:expr, $label:ident, $hint:ident, switch $($flag:tt)+) => {
        row!($command, $keys, $label, $hint, |s, _| s.$($flag)+ ^= true).on(|s| s.$($flag)+)
    };
    (world $flag:ident, $command:expr, $keys:expr, $label:ident, $hint:ident) => {
        row!($command, $keys, $label, $hint, |s, _| s.model.desk.shown.edit(|figure| figure.world.$flag ^= true))
            .on(|s| s.model.desk.shown.figure().world.$flag)
    };
    (tab $tab:ident, $keys:expr, $label:ident, $hint:ident) => {
        row!(Tab(layout::Tab::$tab), $keys, $label, $hint, |s, _| show_tab(&mut s.model.settings, layout::Tab::$tab))
            .on(|s| s.model.settings.tab == layout::Tab::$tab && s.model.settings.panels().is_shown(Side::Left))
    };
    (panel $command:ident, $side:ident, $keys:expr, $label:ident, $hint:ident) => {
        row!($command, $keys, $label, $hint, |s, _| s.model.settings.panels_mut().toggle(Side::$side))
            .on(|s| s.model.settings.panels().is_shown(Side::$side))
    };
    (picture $view:ident, $keys:expr, $label:ident) => {
        row!(Show(View::$view), $keys, $label, show_picture_hint, |s, _| s.model.layout.toggle(View::$view))
            .on(|s| s.model.layout.is_shown(View::$view))
    };
    (arrangement $arrangement:expr, $keys:expr) => {
        CommandRow::new(
            Arrange($arrangement),
            $keys,
            |t| (canvas::texts(t.lang).arrangement($arrangement), t.arrange_hint),
            |s, _| {
                s.model.layout.arrangement = $arrangement;
                s.model.layout.maximized = None;
            },
        )
        .on(|s| s.model.layout.arrangement == $arrangement)
    };
    (look $change:expr, $keys:expr, $label:ident, $hint:ident) => {
        row!(Observe($change), $keys, $label, $hint, |s, _| s.model.frame.observer_change = Some($change))
    };
    ($command:expr, $keys:expr, $label:ident, $hint:ident, $run:expr) => {
        CommandRow::new($command, $keys, |t| (t.$label, t.$hint), $run)
    };
    ($command:expr, $keys:expr, $texts:ident::$label:ident, $hint:ident, $run:expr) => {
        CommandRow::new($command, $keys, |t| ($texts::texts(t.lang).$label, $texts::texts(t.lang).$hint), $run)
    };
}

/// The menus, in the order of the bar.
pub const MENUS: &[Menu] = &[
    Menu {
        title: |t| t.menu_file,
        in_bar: true,
        groups: &[
            &[
                row!(New, ctrl(Key::N), new, new_hint, |s, ctx| file_flow::begin(ctx, s, Intent::New)).browsers_keys(),
                row!(Gallery, ctrl(Key::G), gallery, gallery_hint, |s, _| s.file_flow.show(Dialog::Gallery)),
                row!(Open, ctrl(Key::O), open, open_hint, |s, ctx| file_flow::begin(ctx, s, Intent::Open)),
                row!(Recent, ctrl_shift(Key::O), recent, recent_hint, |s, _| {
                    s.gallery.part = Part::Recent;
                    s.file_flow.show(Dialog::Gallery);
                })
                .not_in_browser(),
            ],
            &[
                row!(Save, ctrl(Key::S), save, save_hint, save),
                row!(SaveAs, ctrl_shift(Key::S), save_as, save_as_hint, |s, ctx| {
                    file_flow::ask(ctx, s, Purpose::Save);
                }),
                row!(SaveWithFiles, ctrl_shift(Key::F), save_with_files, save_with_files_hint, |s, ctx| {
                    file_flow::ask(ctx, s, Purpose::SaveWithFiles);
                })
                .not_in_browser()
                .listed_if(|s| !files::own_files(s.model.desk.shown.figure()).is_empty()),
                row!(Title, ctrl(Key::I), title_command, title_hint, |s, _| {
                    s.file_flow.show(Dialog::Title(TitleForm::of(&s.model, None)));
                }),
            ],
            &[row!(Export, ctrl(Key::E), export, export_hint, |s, _| {
                s.family.choose(Subject::Nothing);
                show_export(s);
            })],
            &[row!(Quit, ctrl(Key::Q), quit, quit_hint, |s, ctx| file_flow::begin(ctx, s, Intent::Quit))
                .not_in_browser()],
        ],
    },
    // By their keys and the search. In the menu, they're in the dialogs of the entries above.
    Menu {
        title: |t| t.menu_file,
        in_bar: false,
        groups: &[&[
            row!(ExportFamily, ctrl_shift(Key::E), export_family, export_family_hint, |s, _| {
                s.family = std::mem::take(&mut s.family).or_last();
                show_export(s);
            }),
            row!(QrCode, ctrl_shift(Key::K), sharing::code, code_hint, |s, _| {
                show_code(&mut s.file_flow, !s.sharing.address().is_empty());
            }),
        ]],
    },
    Menu {
        title: |t| t.menu_edit,
        in_bar: true,
        groups: &[
            &[
                row!(Undo, ctrl(Key::Z), undo, undo_hint, |s, _| s.learn.undo(&mut s.model, true))
                    .enabled(|s| s.learn.can_undo(&s.model, true)),
                row!(Redo, ctrl_shift(Key::Z), redo, redo_hint, |s, _| s.learn.undo(&mut s.model, false))
                    .or(ctrl(Key::Y))
                    .enabled(|s| s.learn.can_undo(&s.model, false)),
            ],
            &[
                row!(Aim, alt(Key::O), aim, aim_hint, |s, _| s.model.frame_objects(Framing::Aim)),
                row!(FitImage, alt(Key::I), fit_image, fit_image_hint, |s, _| s.model.frame_objects(Framing::Fit)),
            ],
            &[row!(Reset, ctrl(Key::R), reset, reset_hint, |s, _| s.model.desk.shown.reset())
                .enabled(|s| s.model.desk.shown.can_reset())
                .browsers_keys()],
            &[row!(CopyNumbers, ctrl_shift(Key::C), copy_numbers, copy_numbers_hint, |s, ctx| copy_numbers(
                &mut s.model,
                ctx
            ))],
        ],
    },
    Menu {
        title: |t| t.menu_view,
        in_bar: true,
        groups: &[
            &[
                row!(picture World, ctrl(Key::Num1), show_world),
                row!(picture Canonical, ctrl(Key::Num2), show_canonical),
                row!(picture Image, ctrl(Key::Num3), show_image),
            ],
            &[
                row!(arrangement None, ctrl(Key::Num4)),
                row!(arrangement Some(Arrangement::Row), ctrl(Key::Num5)),
                row!(arrangement Some(Arrangement::Column), ctrl(Key::Num6)),
                row!(arrangement Some(Arrangement::Above), ctrl(Key::Num7)),
                row!(arrangement Some(Arrangement::Beside), ctrl(Key::Num8)),
            ],
            &[
                row!(ViewBack, alt(Key::ArrowLeft), view_back, view_back_hint, |s, _| see_as(&mut s.model, true))
                    .enabled(|s| s.model.views.can_go(s.model.desk.shown.figure().observers, true)),
                row!(ViewForward, alt(Key::ArrowRight), view_forward, view_forward_hint, |s, _| see_as(
                    &mut s.model,
                    false
                ))
                .enabled(|s| s.model.views.can_go(s.model.desk.shown.figure().observers, false)),
                row!(world section, Section, alt(Key::Num8), section_view, section_view_hint),
                row!(world dimensions, Dimensions, alt(Key::Num9), dimensions, dimensions_hint)
                    .enabled(|s| !s.model.desk.shown.figure().world.section)
                    .disabled_because(|t| t.dimensions_in_section),
                row!(Compare, ctrl_shift(Key::D), compare::command, command_hint, |s, _| {
                    s.file_flow.show(Dialog::Compare(CompareForm::of(s.model.desk.shown.figure())));
                }),
                row!(KeepCamera, shift(Key::F4), cameras::add, add_hint, |s, _| {
                    let name = s.model.keep_camera();
                    s.model.say(Message::CameraKept(name));
                })
                .enabled(|s| s.model.desk.shown.figure().cameras.len() < crate::limits::MAX_CAMERAS)
                .disabled_because(|t| cameras::texts(t.lang).full),
                row!(SwapSides, plain(Key::F4), compare::swap, swap_command_hint, |s, _| swap(&mut s.model)),
                row!(LinkOrbits, alt(Key::L), link_orbits, link_orbits_hint, switch model.layout.linked),
                row!(Labels, alt(Key::T), labels::title, command_hint, |s, _| s.model.label_mode.toggle())
                    .on(|s| s.model.label_mode.on),
            ],
        ],
    },
    Menu {
        title: |t| t.menu_viewpoint,
        in_bar: false,
        groups: &[&[
            row!(look ObserverChange::From(Viewpoint::Front), alt(Key::Num1), look_front, look_front_hint),
            row!(look ObserverChange::From(Viewpoint::Top), alt(Key::Num2), look_top, look_top_hint),
            row!(look ObserverChange::From(Viewpoint::Side), alt(Key::Num3), look_side, look_side_hint),
            row!(look ObserverChange::From(Viewpoint::Iso), alt(Key::Num4), look_iso, look_iso_hint),
            row!(look ObserverChange::From(Viewpoint::AlongU), alt(Key::Num5), look_along_u, look_along_u_hint),
            row!(look ObserverChange::From(Viewpoint::AlongV), alt(Key::Num6), look_along_v, look_along_v_hint),
            row!(look ObserverChange::From(Viewpoint::AlongN), alt(Key::Num7), look_along_n, look_along_n_hint),
            row!(look ObserverChange::Fit, alt(Key::Num0), look_fit, look_fit_hint),
        ]],
    },
    Menu {
        title: |t| t.menu_window,
        in_bar: true,
        groups: &[
            &[
                row!(tab Camera, plain(Key::F5), camera_tab, camera_tab_hint).browsers_keys(),
                row!(tab Scene, plain(Key::F6), scene_tab, scene_tab_hint),
                row!(tab Drawing, plain(Key::F7), drawing_tab, drawing_tab_hint),
                row!(panel ParametersPanel, Left, plain(Key::F8), parameters_panel, parameters_panel_hint),
                row!(panel NumbersPanel, Right, plain(Key::F9), numbers_panel, numbers_panel_hint),
                row!(Explain, alt(Key::E), explain_panel, explain_panel_hint, |s, _| toggle_explain(&mut s.model))
                    .on(|s| s.model.settings.panels().is_shown(Side::Explain) && !s.model.shows_exercises()),
                row!(Exercises, alt(Key::X), exercises, exercises_hint, |s, _| toggle_exercises(
                    &mut s.model,
                    &mut s.learn
                ))
                .on(|s| s.model.shows_exercises()),
                row!(Pipeline, plain(Key::F10), pipeline, pipeline_hint, switch model.layout.strip),
                row!(Numerics, ctrl(Key::Num9), numerics, numerics_hint, switch numerics.shown),
            ],
            &[
                row!(Theme, ctrl(Key::T), theme, theme_hint, |s, _| toggle_theme(&mut s.model.settings.theme))
                    .on(|s| s.model.settings.theme == appearance::Theme::Dark)
                    .browsers_keys(),
                row!(Contrast, alt(Key::H), contrast, contrast_hint, |s, _| toggle_contrast(&mut s.model.settings))
                    .on(|s| s.model.settings.theme == appearance::Theme::Print),
                row!(ReduceMotion, alt(Key::M), reduce_motion, reduce_motion_hint, switch model.settings.reduce_motion),
            ],
            &[
                row!(ZoomIn, ctrl(Key::Plus), zoom_in, zoom_in_hint, |s, _| zoom_by(&mut s.model.settings.zoom, 0.1))
                    // On most keyboards + is on the key of =.
                    .or(ctrl(Key::Equals))
                    .browsers_keys(),
                row!(ZoomOut, ctrl(Key::Minus), zoom_out, zoom_out_hint, |s, _| zoom_by(
                    &mut s.model.settings.zoom,
                    -0.1
                ))
                .browsers_keys(),
                row!(ZoomReset, ctrl(Key::Num0), zoom_reset, zoom_reset_hint, |s, _| s.model.settings.zoom = 1.0)
                    .browsers_keys(),
            ],
            &[CommandRow::new(
                Language,
                ctrl(Key::L),
                |t| (t.lang.next().name(), camera_lab_words::window::texts(t.lang.next()).language_hint),
                |s, _| s.model.settings.lang = s.model.settings.lang.next(),
            )
            .browsers_keys()],
        ],
    },
    Menu {
        title: |t| t.menu_present,
        in_bar: true,
        groups: &[
            &[row!(Presentation, plain(Key::F11), presentation, presentation_hint, toggle_presentation)
                .on(|s| s.model.settings.presentation)],
            &[
                row!(NextFigure, ctrl(Key::PageDown), next_figure, next_figure_hint, |s, ctx| step(s, ctx, true))
                    .browsers_keys(),
                row!(PreviousFigure, ctrl(Key::PageUp), previous_figure, previous_figure_hint, |s, ctx| {
                    step(s, ctx, false);
                })
                .browsers_keys(),
            ],
            &[
                row!(Pen, alt(Key::P), pen, pen_hint, switch annotations.pen),
                row!(Spot, alt(Key::S), spot, spot_hint, switch annotations.spot),
                row!(Freeze, alt(Key::F), freeze, freeze_hint, switch annotations.frozen),
                row!(Blank, alt(Key::B), blank, blank_hint, switch annotations.blank),
            ],
            &[row!(AddStep, ctrl_shift(Key::A), lessons::add_step, add_step_hint, record_step).not_in_browser()],
            &[
                row!(StepAgain, alt(Key::Z), lessons::again, again_hint, |s, _| s.learn.step_again(&mut s.model))
                    .in_lesson(),
                row!(StepText, alt(Key::C), lessons::text_command, text_hint, |s, _| {
                    change_lesson(&mut s.learn, |playing| playing.shows_text ^= true);
                })
                .in_lesson()
                .on(|s| s.learn.lesson.as_ref().is_some_and(|playing| playing.shows_text)),
                row!(StepQuestion, alt(Key::A), lessons::question_command, question_hint, |s, _| {
                    let presents = s.model.settings.presentation;
                    change_lesson(&mut s.learn, |playing| playing.go_on_asking(presents));
                })
                .in_lesson()
                .on(|s| s.learn.lesson.as_ref().is_some_and(|playing| playing.shows_question)),
                row!(StepNotes, alt(Key::N), lessons::notes_command, notes_hint, |s, _| {
                    let presents = s.model.settings.presentation;
                    change_lesson(&mut s.learn, |playing| playing.toggle_notes(presents));
                })
                .in_lesson()
                .on(|s| {
                    let presents = s.model.settings.presentation;
                    s.learn.lesson.as_ref().is_some_and(|playing| playing.has_notes(presents))
                }),
                row!(WriteLesson, alt(Key::R), lessons::write_command, write_hint, write_lesson)
                    .not_in_browser()
                    .on(|s| s.learn.lesson.as_ref().is_some_and(|playing| playing.writing.is_some())),
                row!(LeaveLesson, alt(Key::W), lessons::leave, leave_hint, |s, ctx| {
                    file_flow::begin(ctx, s, Intent::LeaveLesson);
                })
                .in_lesson(),
            ],
            &[row!(ClearAnnotations, alt(Key::Backspace), clear_annotations, clear_annotations_hint, |s, _| s
                .annotations
                .clear())
            .enabled(|s| s.annotations.any())],
        ],
    },
    Menu {
        title: |t| handouts::texts(t.lang).hand_out,
        in_bar: true,
        groups: &[
            &[
                row!(Handout, ctrl(Key::P), handouts::handout, handout_hint, |s, _| show_handout(s, true))
                    .browsers_keys(),
                row!(ExerciseSheet, alt(Key::K), handouts::sheet, sheet_hint, |s, _| show_handout(s, false)),
            ],
            &[
                row!(StudentPage, ctrl_shift(Key::H), handouts::student_page, student_page_hint, |s, ctx| {
                    hand_out::begin(ctx, s, HandOut::Page);
                })
                .not_in_browser(),
                row!(CoursePackage, ctrl_shift(Key::M), handouts::course, course_hint, |s, ctx| {
                    hand_out::begin(ctx, s, HandOut::Course);
                })
                .enabled(|s| s.learn.lesson.is_some())
                .disabled_because(|t| handouts::texts(t.lang).no_lesson)
                .not_in_browser(),
                row!(CopyLink, ctrl(Key::K), sharing::copy_link, copy_link_hint, |s, _| s.file_flow.show(Dialog::Link)),
            ],
            &[row!(Class, alt(Key::U), class::class, class_hint, |s, ctx| {
                file_flow::ask(ctx, s, Purpose::For(camera_lab_desk::FileFor::Class));
            })
            .not_in_browser()],
        ],
    },
    Menu {
        title: |t| t.menu_help,
        in_bar: true,
        groups: &[&[
            row!(Lessons, ctrl_shift(Key::L), lessons::lessons_command, lessons_hint, |s, _| show_lessons(s)),
            row!(Search, ctrl(Key::F), search, search_hint, |s, _| {
                s.search = Search::default();
                s.file_flow.show(Dialog::Search);
            })
            .or(ctrl_shift(Key::P))
            .browsers_keys(),
            row!(Help, plain(Key::F1), help, help_hint, |s, _| s.file_flow.show(Dialog::Help)),
            row!(About, shift(Key::F1), about, about_hint, |s, _| s.file_flow.show(Dialog::About)),
        ]],
    },
];

const fn plain(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::NONE, key)
}

/// With the platform's command key.
const fn ctrl(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND, key)
}

const fn ctrl_shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key)
}

const fn shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::SHIFT, key)
}

const fn alt(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::ALT, key)
}

/// Label and hint.
type Words = fn(&Texts) -> (&'static str, &'static str);

impl CommandRow {
    /// A command that is always available, and is neither on nor off.
    const fn new(command: Command, shortcut: KeyboardShortcut, words: Words, run: fn(&mut State, &Context)) -> Self {
        Self {
            command,
            shortcut,
            second_shortcut: None,
            in_browser: InBrowser::All,
            words,
            enabled: |_| true,
            only_if_enabled: false,
            hint_disabled: None,
            on: None,
            run,
        }
    }

    /// Other keys call it too.
    const fn or(self, keys: KeyboardShortcut) -> Self {
        Self { second_shortcut: Some(keys), ..self }
    }

    /// Its keys are left to the browser.
    const fn browsers_keys(self) -> Self {
        Self { in_browser: InBrowser::WithoutKeys, ..self }
    }

    const fn not_in_browser(self) -> Self {
        Self { in_browser: InBrowser::Nothing, ..self }
    }

    const fn enabled(self, enabled: fn(&State) -> bool) -> Self {
        Self { enabled, ..self }
    }

    /// Available, and in its menu, only while this holds.
    const fn listed_if(self, enabled: fn(&State) -> bool) -> Self {
        Self { enabled, only_if_enabled: true, ..self }
    }

    /// Available, and in its menu, only while a lesson is played.
    const fn in_lesson(self) -> Self {
        self.listed_if(|s| s.learn.lesson.is_some())
    }

    const fn disabled_because(self, hint: fn(&Texts) -> &'static str) -> Self {
        Self { hint_disabled: Some(hint), ..self }
    }

    const fn on(self, on: fn(&State) -> bool) -> Self {
        Self { on: Some(on), ..self }
    }

    pub(super) fn all_keys(&self) -> impl Iterator<Item = KeyboardShortcut> + use<> {
        [Some(self.shortcut), self.second_shortcut].into_iter().flatten()
    }
}

/// Adds the state on the screen to the lesson to which steps were added last. Without such a lesson, asks for a file.
fn record_step(state: &mut State, ctx: &Context) {
    match state.learn.file.clone() {
        Some(path) => state.learn.add_step(&mut state.model, &path, Overwrite::Writable),
        None => file_flow::ask(ctx, state, Purpose::Step),
    }
}

/// Writes the user's own lesson, or a copy of a built-in one. While no lesson is played, writes the one to which steps
/// were added last, or a new one that begins with the state on the screen.
fn write_lesson(state: &mut State, ctx: &Context) {
    if state.learn.lesson.is_none() && state.learn.file.is_none() {
        file_flow::ask(ctx, state, Purpose::NewLesson);
    } else if state.learn.lesson.is_none() {
        file_flow::begin(ctx, state, Intent::WriteRecorded);
    } else if state.learn.plays_own_lesson(&state.model) {
        state.learn.write_lesson(&mut state.model);
    } else {
        file_flow::ask(ctx, state, Purpose::OwnLesson);
    }
}

fn change_lesson(learn: &mut Learn, change: impl FnOnce(&mut Playing)) {
    if let Some(playing) = &mut learn.lesson {
        change(playing);
    }
}

/// Saves the text typed in the lesson, or the figure.
fn save(state: &mut State, ctx: &Context) {
    let writing =
        state.learn.lesson.as_ref().and_then(|playing| Some((playing.path.clone()?, playing.writing.as_ref()?)));
    match writing.filter(|(_, writing)| writing.is_ahead()) {
        Some((path, _)) => {
            if state.learn.save_text(&mut state.model) {
                state.model.say(Message::Saved(path));
            }
        }
        None => file_flow::save(ctx, state),
    }
}

/// Opens the list of lessons, including those of the figures' folder.
pub(in crate::gui::app) fn show_lessons(state: &mut State) {
    state.learn.look_for_lessons(&state.model, state.gallery.folder(), &state.recent.files);
    state.file_flow.show(Dialog::Lessons);
}

/// Shows the QR code of the link to the screen. Without the address of a page, asks for that first.
fn show_code(file_flow: &mut FileFlow, has_address: bool) {
    file_flow.show(if has_address { Dialog::Qr } else { Dialog::Link });
    file_flow.refused = (!has_address).then_some(Message::AddressFirst);
}

fn show_handout(state: &mut State, is_lesson: bool) {
    state.learn.look_for_lessons(&state.model, state.gallery.folder(), &state.recent.files);
    let form = HandoutForm::of(&state.learn, state.model.settings.lang, is_lesson, state.sharing.address());
    state.file_flow.show(Dialog::Handout(form));
}

/// Opens the export dialog as the user left it, or for the displayed views if these have changed since.
fn show_export(state: &mut State) {
    let displayed = state.model.layout.views();
    if state.exported_of.replace(displayed) != Some(displayed) {
        state.export.what = displayed;
    }
    state.export.fit_screen(state.model.frame.picture_sizes, state.model.frame.screen_scale);
    state.file_flow.show(Dialog::Export(state.export));
}

fn copy_numbers(model: &mut Model, ctx: &Context) {
    ctx.copy_text(number_tables::text(model));
    model.say(Message::NumbersCopied);
}

/// Shows the 3D pictures from an earlier or later viewpoint, if there is one.
fn see_as(model: &mut Model, back: bool) {
    if let Some(observers) = model.views.go(model.desk.shown.figure().observers, back) {
        *model.desk.shown.observers_mut() = observers;
    }
}

/// Goes on to the next figure or step, or back to the one before.
fn step(state: &mut State, ctx: &Context, forwards: bool) {
    // A frozen picture would stay under another title.
    state.annotations.frozen = false;
    if state.learn.lesson.is_some() {
        state.learn.step_lesson(&mut state.model, forwards);
    } else {
        file_flow::step(ctx, state, forwards);
    }
}

fn show_tab(settings: &mut Settings, tab: layout::Tab) {
    settings.tab = tab;
    settings.panels_mut().show(Side::Left);
}

fn toggle_exercises(model: &mut Model, learn: &mut Learn) {
    if model.shows_exercises() && learn.exercises.was_called {
        model.settings.panels_mut().toggle(Side::Explain);
    } else {
        model.show_explanation(crate::figure::Explanation::Exercises);
        learn.exercises.call();
    }
}

/// The explanations and the exercises share a panel. One of them is on.
fn toggle_explain(model: &mut Model) {
    if model.shows_exercises() {
        let [last, ..] = model.explained.last();
        model.explained.show(last);
    } else {
        model.settings.panels_mut().toggle(Side::Explain);
    }
}

fn toggle_theme(theme: &mut appearance::Theme) {
    *theme = if *theme == appearance::Theme::Dark { appearance::Theme::Light } else { appearance::Theme::Dark };
}

/// Black on white, and back to the theme before.
fn toggle_contrast(settings: &mut Settings) {
    let is_on = settings.theme == appearance::Theme::Print;
    let next = if is_on { settings.theme_before } else { appearance::Theme::Print };
    settings.theme_before = std::mem::replace(&mut settings.theme, next);
}

fn zoom_by(zoom: &mut f32, more: f32) {
    *zoom = (*zoom + more).clamp(0.5, 3.0);
}

fn toggle_presentation(state: &mut State, ctx: &Context) {
    // An explanation that the figure requests is open in the presentation too, if it's open now.
    let explained =
        state.model.desk.shown.figure().screen.panel.flatten().filter(|panel| state.model.shows_explanation(*panel));
    state.model.layout.turn_presentation(!state.model.settings.presentation);
    state.model.settings.presentation ^= true;
    // A panel opened before one class doesn't belong to the next one.
    state.model.settings.presentation_panels = Panels::default();
    if let Some(playing) = &mut state.learn.lesson {
        playing.shows_question = !state.model.settings.presentation;
        playing.shows_private_notes = false;
    }
    explained.into_iter().for_each(|panel| state.model.show_explanation(panel));
    ctx.send_viewport_cmd(ViewportCommand::Fullscreen(state.model.settings.presentation));
    state.model.message = None;
    state.annotations.keys_since = Some(ctx.input(|input| input.time));
}
