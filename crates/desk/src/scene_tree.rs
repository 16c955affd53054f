//! The state of the tree: selection, folding, typed texts.

use std::collections::BTreeSet;

use crate::explain::Placement;
use crate::figure::Measured;
use crate::model::Model;
use crate::scene::edit::placement;
use crate::scene::palette::SceneColors;
use crate::scene::transform::Trs;
use crate::scene::{ObjectSpec, Preset, SceneError, SceneSpec};
use crate::views::{ObjectTransform, Transforming};

/// A selection in the tree.
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
    /// The item of an object of the built scene, by the name of its [`owner`](crate::scene::Object::owner).
    pub fn of_object(scene: &SceneSpec, name: &str) -> Option<Self> {
        if scene.objects.iter().any(|object| object.name == name) {
            return Some(Self::Object(name.to_owned()));
        }
        let is_of_preset = preset_objects(scene.preset).iter().any(|o| o.name == name);
        is_of_preset.then(|| Self::OfPreset(name.to_owned()))
    }
}

/// The state of the tree from one frame to the next.
#[derive(Debug, Default)]
pub struct SceneTree {
    /// The selected object or light.
    pub selected: Option<Selected>,
    /// The figure's other selected objects.
    also: BTreeSet<String>,
    /// The selection after this frame, because text being typed is applied before.
    next: Option<(Option<Selected>, BTreeSet<String>)>,
    /// The gizmo for dragging the selection in the world.
    pub transforming: Transforming,
    /// The objects whose children are hidden, by name.
    pub folded: BTreeSet<String>,
    /// The scene as in the fields while it's impossible.
    pub draft: Option<Draft>,
    /// True if an object with a new parent moves to it.
    pub moves_with_parent: bool,
}

/// A scene being typed that is impossible.
#[derive(Debug)]
pub struct Draft {
    /// The scene of the figure that it came from. With another one, it's void.
    pub base: SceneSpec,
    /// The scene as it would be.
    pub now: SceneSpec,
    /// The reason why it isn't.
    pub error: SceneError,
}

impl SceneTree {
    /// The selection, if the scene has it.
    pub fn selected(&self, scene: &SceneSpec) -> Option<&Selected> {
        self.selected.as_ref().filter(|selected| match selected {
            Selected::Object(name) => scene.objects.iter().any(|o| o.name == *name),
            Selected::OfPreset(name) => preset_objects(scene.preset).iter().any(|o| o.name == *name),
            Selected::Light(index) => *index < scene.lights.len(),
        })
    }

    /// Selects an object, or none, once all panels have been shown in this frame.
    pub fn select(&mut self, selected: Option<Selected>) {
        self.select_all(selected, BTreeSet::new());
    }

    /// As [`select`](Self::select), with other objects of the figure.
    pub fn select_all(&mut self, selected: Option<Selected>, also: BTreeSet<String>) {
        self.next = Some((selected, also));
    }

    /// Adds an object of the figure to the selection, or removes it.
    pub fn toggle(&mut self, scene: &SceneSpec, name: &str) {
        let mut names = self.names(scene);
        let primary = if names.remove(name) {
            let kept = self.selected.clone().filter(|selected| *selected != Selected::Object(name.to_owned()));
            kept.or_else(|| names.first().cloned().map(Selected::Object))
        } else {
            Some(Selected::Object(name.to_owned()))
        };
        if let Some(Selected::Object(primary)) = &primary {
            names.remove(primary);
        }
        self.select_all(primary, names);
    }

    /// The figure's objects selected together with [`selected`](Self::selected). Some may be gone.
    pub fn also(&self) -> &BTreeSet<String> {
        &self.also
    }

    /// All selected objects of the figure.
    pub fn names(&self, scene: &SceneSpec) -> BTreeSet<String> {
        let own = scene.objects.iter().map(|o| &o.name);
        let is_selected = |name: &String| {
            self.also.contains(name) || matches!(&self.selected, Some(Selected::Object(selected)) if selected == name)
        };
        own.filter(|name| is_selected(name)).cloned().collect()
    }

    /// Updates the selection after undo or redo has turned `before` into `after`. Restored objects become selected, and
    /// renamed ones stay so.
    pub fn follow(&mut self, before: &SceneSpec, after: &SceneSpec) {
        let has = |scene: &SceneSpec, name: &str| scene.objects.iter().any(|o| o.name == name);
        let of = |from: &SceneSpec, other: &SceneSpec| -> Vec<String> {
            from.objects.iter().filter(|o| !has(other, &o.name)).map(|o| o.name.clone()).collect()
        };
        let (gone, come) = (of(before, after), of(after, before));
        let is_renaming = gone.len() == come.len();
        let new_name = |name: &String| match gone.iter().position(|gone| gone == name) {
            Some(k) if is_renaming => Some(come[k].clone()),
            Some(_) => None,
            None => Some(name.clone()),
        };
        if !is_renaming && !come.is_empty() {
            // If objects are restored with their parent, only the parent.
            let is_top = |name: &&String| {
                let object = after.objects.iter().find(|o| o.name == **name);
                object.and_then(|o| o.parent.as_ref()).is_none_or(|parent| !come.contains(parent))
            };
            let mut tops = come.iter().filter(is_top).cloned();
            let first = tops.next().map(Selected::Object);
            self.select_all(first, tops.collect());
            return;
        }
        let also = self.also.iter().filter_map(new_name).collect();
        match &self.selected {
            Some(Selected::Object(name)) => self.select_all(new_name(name).map(Selected::Object), also),
            other => self.select_all(other.clone(), also),
        }
    }

    /// Applies the last [`select`](Self::select). Returns true if there was one.
    pub fn settle(&mut self) -> bool {
        let next = self.next.take();
        let asked = next.is_some();
        if let Some((selected, also)) = next {
            (self.selected, self.also) = (selected, also);
        }
        asked
    }
}

/// The objects of a preset. Their colours don't matter here.
pub fn preset_objects(preset: Preset) -> Vec<ObjectSpec> {
    crate::scene::preset_objects(preset, &SceneColors::of(crate::appearance::Theme::Light))
}

impl Model {
    /// The transform of the selected object, if the pointer is on a part of it.
    pub fn object_transform(&self) -> Option<ObjectTransform> {
        let of_object = |m: &Measured| matches!(m, Measured::Translate(_) | Measured::Rotate(_) | Measured::Scale(_));
        let (_, Placement { translate, rotate, scale, parent, .. }) =
            self.frame.hover.measured.iter().any(of_object).then(|| self.selected_placement()).flatten()?;
        let world_from_parent = parent.unwrap_or(glam::DMat4::IDENTITY);
        Some(ObjectTransform { world_from_parent, trs: Trs { translate, rotate, scale } })
    }

    /// The placement of the selected object in the world. `None` if none is selected, or the scene is impossible.
    pub fn selected_placement(&self) -> Option<(String, Placement)> {
        let scene = &self.desk.shown.figure().scene;
        let (name, spec) = match self.tree.selected(scene)? {
            Selected::Object(name) => (name, scene.objects.iter().find(|o| o.name == *name)?.clone()),
            Selected::OfPreset(name) => (name, preset_objects(scene.preset).into_iter().find(|o| o.name == *name)?),
            Selected::Light(_) => return None,
        };
        let parent = match &spec.parent {
            Some(parent) => Some(placement(scene, parent).ok()??),
            None => None,
        };
        let world_from_object = placement(scene, name).ok()??;
        let (translate, rotate, scale) = (spec.translate, spec.rotate, spec.scale);
        Some((name.clone(), Placement { translate, rotate, scale, parent, world_from_object }))
    }
}
