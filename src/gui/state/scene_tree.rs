//! What is selected, folded and typed in the tree of the scene.

use std::collections::BTreeSet;

use crate::appearance::Theme;
use crate::scene::palette::SceneColors;
use crate::scene::{ObjectSpec, Preset, SceneError, SceneSpec};

/// What is selected in the tree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Selected {
    /// An object of the figure, by name.
    Object(String),
    /// An object of the named scene, by name.
    OfPreset(String),
    /// A light of the figure, by its place in the list.
    Light(usize),
}

impl Selected {
    /// What an object of the built scene stands for, by its name.
    #[must_use]
    pub fn of_object(scene: &SceneSpec, name: &str) -> Option<Self> {
        let whole = name.split_once('/').map_or(name, |(whole, _)| whole);
        let own = [name, whole].into_iter().find(|name| scene.objects.iter().any(|o| o.name == *name));
        if let Some(own) = own {
            return Some(Self::Object(own.to_owned()));
        }
        let is_of_preset = preset_objects(scene.preset).iter().any(|o| o.name == name);
        is_of_preset.then(|| Self::OfPreset(name.to_owned()))
    }
}

/// What the tree remembers from one frame to the next.
#[derive(Debug, Default)]
pub struct SceneTree {
    pub(in crate::gui) selected: Option<Selected>,
    /// What is selected after this frame: what is being typed now is taken over before.
    next: Option<Option<Selected>>,
    pub(in crate::gui) folded: BTreeSet<String>,
    /// The scene as the fields show it while it is impossible.
    pub(in crate::gui) draft: Option<Draft>,
    /// A name or a colour that is being typed, and whose it is.
    pub(in crate::gui) typing: Option<Typing>,
    /// An object that is hung elsewhere moves with its new parent.
    pub(in crate::gui) moves_with_parent: bool,
}

/// A scene that is being typed and impossible.
#[derive(Debug)]
pub(in crate::gui) struct Draft {
    /// The scene of the figure that it was made from; another one makes it void.
    pub(in crate::gui) base: SceneSpec,
    pub(in crate::gui) now: SceneSpec,
    pub(in crate::gui) error: SceneError,
}

/// A text that is being typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::gui) struct Typing {
    pub(in crate::gui) owner: String,
    pub(in crate::gui) key: &'static str,
    pub(in crate::gui) text: String,
    /// It was left although it is wrong.
    pub(in crate::gui) left: bool,
}

impl Typing {
    pub(in crate::gui) fn of(owner: &str, key: &'static str, text: &str) -> Self {
        Self { owner: owner.to_owned(), key, text: text.to_owned(), left: false }
    }
}

impl SceneTree {
    /// What is selected, if the scene has it.
    #[must_use]
    pub fn selected(&self, scene: &SceneSpec) -> Option<&Selected> {
        self.selected.as_ref().filter(|selected| match selected {
            Selected::Object(name) => scene.objects.iter().any(|o| o.name == *name),
            Selected::OfPreset(name) => preset_objects(scene.preset).iter().any(|o| o.name == *name),
            Selected::Light(index) => *index < scene.lights.len(),
        })
    }

    /// Selects something, or nothing, once all panels have been shown in this frame.
    pub fn select(&mut self, selected: Option<Selected>) {
        self.next = Some(selected);
    }

    /// Does what [`select`](Self::select) has asked for; true where it has.
    pub fn settle(&mut self) -> bool {
        let next = self.next.take();
        let asked = next.is_some();
        self.selected = next.unwrap_or(self.selected.take());
        asked
    }
}

/// The objects of a preset; their colours do not matter here.
pub(in crate::gui) fn preset_objects(preset: Preset) -> Vec<ObjectSpec> {
    crate::scene::preset_objects(preset, &SceneColors::of(Theme::Light))
}
