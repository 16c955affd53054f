//! The controls for screen readers. In a browser they would find only a canvas, because eframe drops the tree that egui
//! builds for AccessKit. This plugin hands the tree to the page's script, which keeps an element for each control
//! within the canvas. egui builds no tree before a user asks for one.

use std::cell::RefCell;
use std::collections::HashMap;

use eframe::egui;
use eframe::egui::accesskit::{
    Action, ActionData, ActionRequest, Live, Node, NodeId, Role, Toggled, TreeId, TreeUpdate,
};
use serde_json::{Map, Value, json};

use crate::gui::app::web::call;

thread_local! {
    /// The requests of a screen reader since the last frame.
    static REQUESTS: RefCell<Vec<ActionRequest>> = const { RefCell::new(Vec::new()) };
}

/// Does what a screen reader asks of a control, in the next frame: `click`, `focus`, or a value as `text` or `number`.
pub(super) fn asked(what: &str, control: &str, value: &str) -> Option<()> {
    let (action, data) = match what {
        "click" => (Action::Click, None),
        "focus" => (Action::Focus, None),
        "text" => (Action::SetValue, Some(ActionData::Value(value.into()))),
        _ => (Action::SetValue, Some(ActionData::NumericValue(value.parse().ok()?))),
    };
    let target_node = NodeId(control.parse().ok()?);
    REQUESTS.with_borrow_mut(|requests| {
        requests.push(ActionRequest { action, target_tree: TreeId::ROOT, target_node, data });
    });
    Some(())
}

/// Hands over the tree whenever it changes.
#[derive(Default)]
pub(super) struct Reader {
    told: String,
}

impl egui::Plugin for Reader {
    fn debug_name(&self) -> &'static str {
        "screen reader"
    }

    fn input_hook(&mut self, _ctx: &egui::Context, input: &mut egui::RawInput) {
        input.events.extend(REQUESTS.take().into_iter().map(egui::Event::AccessKitActionRequest));
    }

    fn output_hook(&mut self, _ctx: &egui::Context, output: &mut egui::FullOutput) {
        let Some(update) = output.platform_output.accesskit_update.take() else { return };
        let text = text_of(&update);
        if text != self.told {
            drop(call("cameraLabRead", &text));
            self.told = text;
        }
    }
}

/// The focus, and the elements of all controls.
fn text_of(update: &TreeUpdate) -> String {
    let nodes: HashMap<NodeId, &Node> = update.nodes.iter().map(|(id, node)| (*id, node)).collect();
    let mut elements = Vec::new();
    if let Some(tree) = &update.tree {
        add(&nodes, tree.root, &mut elements);
    }
    json!([update.focus.0.to_string(), elements]).to_string()
}

/// Adds the element of a control: its identifier, its name in HTML, attributes, text, and the elements in it. A
/// container without a name leaves its place to what it contains.
fn add(nodes: &HashMap<NodeId, &Node>, id: NodeId, elements: &mut Vec<Value>) {
    let Some(node) = nodes.get(&id).filter(|node| !node.is_hidden()) else { return };
    let name = name(nodes, node);
    let (element, role) = match node.role() {
        Role::TextRun => return,
        Role::Label => ("span", ""),
        Role::TextInput => ("input", "text"),
        Role::MultilineTextInput => ("textarea", ""),
        Role::SpinButton => ("input", "number"),
        Role::Slider | Role::Splitter => ("input", "range"),
        Role::CheckBox => ("button", "checkbox"),
        Role::RadioButton => ("button", "radio"),
        Role::Link => ("button", "link"),
        Role::Image => ("div", "img"),
        Role::Window | Role::Region | Role::Pane if !name.is_empty() => ("section", ""),
        _ if node.supports_action(Action::Click) && !name.is_empty() => ("button", ""),
        _ => {
            node.children().iter().for_each(|child| add(nodes, *child, elements));
            return;
        }
    };
    let mut attributes = Map::new();
    let mut set = |key: &str, value: String| drop(attributes.insert(key.to_owned(), value.into()));
    if !role.is_empty() {
        set(if element == "input" { "type" } else { "role" }, role.to_owned());
    }
    if element != "span" && !name.is_empty() {
        set("aria-label", name.clone());
    }
    if let Some(description) = node.description().filter(|description| *description != name) {
        set("aria-description", description.to_owned());
    }
    if node.is_disabled() {
        set("aria-disabled", "true".to_owned());
    }
    if let Some(expanded) = node.is_expanded() {
        set("aria-expanded", expanded.to_string());
    }
    if let Some(on) = node.toggled().map(|toggled| toggled == Toggled::True).or(node.is_selected()) {
        set(if ["checkbox", "radio"].contains(&role) { "aria-checked" } else { "aria-pressed" }, on.to_string());
    }
    if node.live().is_some_and(|live| live != Live::Off) {
        set("aria-live", "polite".to_owned());
    }
    if let Some(value) = node.value().filter(|_| element != "span") {
        set(if node.numeric_value().is_some() { "aria-valuetext" } else { "value" }, value.to_owned());
    }
    for (key, number) in
        [("value", node.numeric_value()), ("min", node.min_numeric_value()), ("max", node.max_numeric_value())]
    {
        number.into_iter().for_each(|number| set(key, number.to_string()));
    }
    if element == "input" && role != "text" {
        set("step", "any".to_owned());
    }
    let text = if element == "span" { node.value().unwrap_or(&name) } else { "" };
    let mut inner = Vec::new();
    if element == "section" {
        node.children().iter().for_each(|child| add(nodes, *child, &mut inner));
    }
    elements.push(json!([id.0.to_string(), element, attributes, text, inner]));
    if element != "section" {
        // Buttons of a picture or of a field follow it.
        node.children().iter().for_each(|child| add(nodes, *child, elements));
    }
}

/// The name of a control, or of the text beside it that names it.
fn name(nodes: &HashMap<NodeId, &Node>, node: &Node) -> String {
    match node.label() {
        Some(label) if !label.is_empty() => label.to_owned(),
        _ => {
            let beside = node.labelled_by().iter().filter_map(|id| nodes.get(id));
            beside.filter_map(|node| node.value().or(node.label())).collect::<Vec<_>>().join(" ")
        }
    }
}
