//! The explanation of order: a list of transforms on an object, read from either end, and the same list in another
//! order.

use eframe::egui::{self, RichText, Slider, Ui};
use glam::{DMat4, DVec3};

use super::answer::Writing;
use super::steps::numbers;
use super::{ExplainedSetting, order_list};
use crate::explain::order::{Call, Link, Reading, Stage, Unbalanced, chain, exchanged, in_force, read, same};
use crate::explain::{Formula, Placement};
use crate::geometry::{Ray, try_unit};
use crate::gui::kit::{Explained, alternatives, choice, complaint, mathematics, section, theme};
use crate::gui::why::state::explain::Explain;
use crate::gui::why::state::order::{Order, Own};
use crate::scene::edit::descendants;
use crate::scene::transform::{Trs, put_on_chain};
use camera_lab_desk::{Message, Model, Selected};
use camera_lab_words::why::order as words;
use camera_lab_words::why::order::Texts;

/// Shows the part that stays in sight above the list: its object, and the button that applies the list.
pub(super) fn head(ui: &mut Ui, model: &mut Model, explain: &mut Explain) {
    let t = words::texts(model.settings.lang);
    let selected = model.selected_placement();
    explain.order.follow(own(selected.as_ref()));
    let calls = explain.order.calls();
    let links = chain(&calls);
    let wanted = ui
        .horizontal_wrapped(|ui| {
            let wanted = take(ui, model, t, links.as_ref().err().copied());
            match &selected {
                None => drop(ui.label(t.example)),
                Some((name, _)) => drop(ui.label(format!("{} {}", t.object, crate::sanitize::escaped(name)))),
            }
            wanted
        })
        .inner;
    let Ok(links) = links else { return };
    let late = links.get(1).and_then(|link| link.first).and_then(|place| Some((place, *calls.get(place)?)));
    let holds = match late {
        None => t.is_form.to_owned(),
        Some(late) => words::needs_groups(t.lang, late, links.len() - 1),
    };
    ui.add(egui::Label::new(RichText::new(holds).small().weak()).wrap());
    if let Some(name) = wanted {
        take_over(model, t, &name, &links);
    }
}

/// Shows the tab.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, explain: &mut Explain) {
    let t = words::texts(model.settings.lang);
    let selected = model.selected_placement();
    model.frame.placed.clear();
    let mut order = std::mem::take(&mut explain.order);
    order.follow(own(selected.as_ref()));
    tab(ui, model, t, (&mut order, selected.as_ref()));
    explain.order = order;
}

fn own(selected: Option<&(String, Placement)>) -> Own {
    match selected {
        None => Own { object: None, trs: Trs::default() },
        Some((name, Placement { translate, rotate, scale, .. })) => {
            Own { object: Some(name.clone()), trs: Trs { translate: *translate, rotate: *rotate, scale: *scale } }
        }
    }
}

type OrderedObject<'a> = Option<&'a (String, Placement)>;

fn tab(ui: &mut Ui, model: &mut Model, t: &'static Texts, (order, selected): (&mut Order, OrderedObject<'_>)) {
    ui.label(RichText::new(t.list).strong()).explained(t.list_hint);
    let stages = read(&order.calls(), order.reading);
    let included: Vec<usize> = match &stages {
        Ok(stages) => stages[..=done(order, stages)].iter().filter_map(|stage| stage.call).collect(),
        Err(_) => Vec::new(),
    };
    order_list::ui(ui, t, order, &included);
    add(ui, t, order);
    ui.separator();
    readings(ui, t, &mut order.reading);
    // The display in this frame includes changes by the rows.
    let calls = order.calls();
    let stages = match read(&calls, order.reading) {
        Ok(stages) => stages,
        Err(error) => return complaint(ui, &words::unbalanced(t.lang, error)),
    };
    slider(ui, t, order, &stages);
    let k = done(order, &stages);
    part(ui, model, t, (order.reading, &calls), &stages[..=k]);
    place(model, selected, stages[k], false);
    section(ui, t.other, "other order", true, |ui| {
        other(ui, model, t, (order, selected), (&calls, &stages));
    });
}

/// Number of calls applied.
fn done(order: &Order, stages: &[Stage]) -> usize {
    order.done.map_or(stages.len() - 1, |done| done.min(stages.len() - 1))
}

/// The menu of calls to add, and the button to start over.
fn add(ui: &mut Ui, t: &'static Texts, order: &mut Order) {
    ui.horizontal(|ui| {
        ui.menu_button(format!("+ {}", t.add), |ui| {
            for call in [
                Call::Translate(DVec3::X),
                Call::RotateX(30.0),
                Call::RotateY(30.0),
                Call::RotateZ(30.0),
                Call::Scale(DVec3::splat(2.0)),
                Call::Push,
                Call::Pop,
            ] {
                if ui.button(words::kind(t.lang, call)).explained(words::function(call)).clicked() {
                    order.add(call);
                    ui.close();
                }
            }
        })
        .response
        .explained(t.add_hint);
        if ui.button(t.again).explained(t.again_hint).clicked() {
            order.begin_again();
        }
    });
}

fn readings(ui: &mut Ui, t: &Texts, reading: &mut Reading) {
    let all = [(Reading::Frame, t.frame, t.frame_hint), (Reading::Object, t.fixed, t.fixed_hint)];
    ui.horizontal_wrapped(|ui| alternatives(ui, reading, all));
}

/// The number of calls applied: step by step, or by the slider.
fn slider(ui: &mut Ui, t: &Texts, order: &mut Order, stages: &[Stage]) {
    let (all, before) = (stages.len() - 1, done(order, stages));
    let mut k = before;
    ui.horizontal(|ui| {
        if ui.button("◀").explained(t.back).accessible_name(t.back).clicked() {
            k = k.saturating_sub(1);
        }
        if ui.button("▶|").explained(t.forward).accessible_name(t.forward).clicked() {
            k = (k + 1).min(all);
        }
        theme::strengthen_rail(ui);
        ui.spacing_mut().slider_width = (ui.available_width() - 64.0).max(60.0);
        ui.add(Slider::new(&mut k, 0..=all).show_value(false)).explained(t.done).accessible_name(t.done);
        ui.label(format!("{k} / {all}"));
    });
    if k != before {
        order.done = (k < all).then_some(k);
    }
}

/// The effect of the last call of a part, its matrix, and the matrix of the part.
fn part(ui: &mut Ui, model: &Model, t: &'static Texts, (reading, calls): (Reading, &[Call]), stages: &[Stage]) {
    let number = writer(model);
    let Some((stage, last)) = stages.last().and_then(|stage| Some((stage, stage.call?))) else {
        ui.label(t.nothing);
        return;
    };
    let Some(call) = calls.get(last).copied() else { return };
    ui.add(egui::Label::new(words::sentence(t.lang, reading, call, &number)).wrap());
    if let Some(matrix) = call.matrix() {
        ui.label(RichText::new(t.this_step).weak());
        equation(ui, "", &[call]);
        let subject = ExplainedSetting::of(model);
        let setting = subject.setting(model);
        let writing = Writing { setting: &setting, lang: t.lang, digits: model.settings.digits.min(5) };
        let entries = call.entries();
        numbers(ui, &matrix, &number, |i, j| {
            let formula = &entries.as_ref()?[i][j];
            let said = [writing.formula(formula).text, writing.numbers(formula).text, number(matrix.row(i)[j] + 0.0)];
            (!matches!(formula, Formula::Number(_))).then(|| said.join(" = "))
        });
    }
    ui.label(RichText::new(t.so_far).weak());
    equation(ui, "M = ", &factors(reading, calls, stages));
    numbers(ui, &stage.matrix, &number, |_, _| None);
}

/// A number with few digits. A matrix has to fit.
fn writer(model: &Model) -> impl Fn(f64) -> String {
    let (mark, digits) = (model.settings.lang.mark(), model.settings.digits.min(5));
    move |value: f64| mark.number(value, digits)
}

/// The calls whose product a part is, from left to right.
fn factors(reading: Reading, calls: &[Call], stages: &[Stage]) -> Vec<Call> {
    let of_part = stages.iter().filter_map(|stage| calls.get(stage.call?).copied());
    match reading {
        Reading::Object => of_part.rev().collect(),
        Reading::Frame => {
            let part: Vec<Call> = of_part.collect();
            in_force(&part).map(|kept| kept.into_iter().map(|i| part[i]).collect()).unwrap_or_default()
        }
    }
}

/// Symbols side by side. For a long product only the beginning and the end.
fn equation(ui: &mut Ui, before: &str, calls: &[Call]) {
    const MOST: usize = 12;
    let mut symbols: Vec<&str> = calls.iter().map(|call| call.symbol()).collect();
    if symbols.len() > MOST {
        symbols.splice(MOST / 2..symbols.len() - MOST / 2, ["…"]);
    }
    if symbols.is_empty() {
        symbols.push("I");
    }
    let text = format!("{before}{}", symbols.join(" "));
    let latex = format!("{before}{}", symbols.join(r"\,").replace('…', r"\cdots "));
    mathematics::show(ui, &latex, &text, 16.0);
}

/// Shows an object in the world in the place given by a part of the list. Without an object, a cube.
fn place(model: &mut Model, selected: OrderedObject<'_>, stage: Stage, wrong: bool) {
    let scene = &model.desk.shown.figure().scene;
    let (parent, now, objects) = match selected {
        None => (DMat4::IDENTITY, DMat4::IDENTITY, std::collections::BTreeSet::new()),
        Some((name, placement)) => {
            let mut objects = descendants(scene, name);
            objects.insert(name.clone());
            (placement.parent.unwrap_or(DMat4::IDENTITY), placement.world_from_object, objects)
        }
    };
    let world_from_frame = parent * stage.matrix;
    let change = world_from_frame * now.inverse();
    let axis = stage.axis.and_then(|axis| {
        let direction = try_unit(parent.transform_vector3(axis.direction))?;
        Some(Ray { origin: parent.transform_point3(axis.origin), direction })
    });
    if change.is_finite() {
        model.frame.placed.push(crate::figure::TransformPreview { objects, change, world_from_frame, axis, wrong });
    }
}

/// The list with two calls exchanged: its result, and if that is the same.
fn other(
    ui: &mut Ui,
    model: &mut Model,
    t: &'static Texts,
    (order, selected): (&mut Order, OrderedObject<'_>),
    (calls, stages): (&[Call], &[Stage]),
) {
    ui.add(egui::Label::new(RichText::new(t.other_hint).small().weak()).wrap());
    let names: Vec<String> =
        calls.iter().enumerate().map(|(i, call)| format!("{}. {}", i + 1, call.symbol().replace('_', ""))).collect();
    let options: Vec<(usize, &str)> = names.iter().enumerate().map(|(i, name)| (i, name.as_str())).collect();
    ui.horizontal(|ui| {
        let [a, b] = &mut order.exchange;
        choice(ui, t.first, t.other_hint, a, &options);
        ui.label("↔");
        choice(ui, t.second, t.other_hint, b, &options);
    });
    let pair = order.exchange;
    if pair[0] == pair[1] || pair.iter().any(|place| *place >= calls.len()) {
        return;
    }
    let other_calls = exchanged(calls, pair);
    let other = match read(&other_calls, order.reading) {
        Ok(other) => other,
        Err(error) => return complaint(ui, &words::unbalanced(t.lang, error)),
    };
    let k = done(order, stages).min(other.len() - 1);
    let (Some(end), Some(other_end)) = (stages.last(), other.last()) else { return };
    let matters = !same(&end.matrix, &other_end.matrix);
    let now = same(&stages[done(order, stages)].matrix, &other[k].matrix);
    equation(ui, "M' = ", &factors(order.reading, &other_calls, &other[..=k]));
    numbers(ui, &other[k].matrix, writer(model), |_, _| None);
    let verdict = match (matters, now) {
        (false, _) => t.same,
        (true, true) => t.so_far_same,
        (true, false) => t.differs,
    };
    ui.add(egui::Label::new(RichText::new(verdict).strong()).wrap());
    place(model, selected, other[k], true);
}

/// The button, and the object that is to get the list. Greyed with the reason if there is none, or if the list isn't
/// one of transforms.
fn take(ui: &mut Ui, model: &Model, t: &'static Texts, unbalanced: Option<Unbalanced>) -> Option<String> {
    let (name, why) = match model.tree.selected(&model.desk.shown.figure().scene) {
        Some(Selected::Object(name)) => (Some(name.clone()), String::new()),
        Some(Selected::OfPreset(_)) => (None, t.take_preset.to_owned()),
        Some(Selected::Light(_)) | None => (None, t.take_nothing.to_owned()),
    };
    let why = unbalanced.map_or(why, |error| words::unbalanced(t.lang, error));
    let button = ui.add_enabled(why.is_empty(), egui::Button::new(t.take));
    let clicked = button.explained(t.take_hint).explained_disabled(why).clicked();
    name.filter(|_| clicked)
}

/// Gives the object of the figure the whole list, with groups above it if it needs them.
fn take_over(model: &mut Model, t: &'static Texts, name: &str, links: &[Link]) {
    let trs: Vec<Trs> = links.iter().map(|link| link.trs).collect();
    let mut changed = model.desk.shown.figure().scene.clone();
    match put_on_chain(&mut changed, name, &trs, t.group) {
        Ok(()) => model.desk.shown.edit(|figure| figure.scene = changed),
        Err(error) => model.say(Message::Scene(error)),
    }
}
