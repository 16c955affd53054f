//! A scene, and the things that a picture adds to it, side by side. Neither is copied to be drawn with the other.

use std::sync::LazyLock;

use crate::scene::{Light, Line, Object, PointMark, Scene, Text};

/// A scene and the gear of a picture. Objects, lines, marks and texts of the scene come first.
#[derive(Clone, Copy, Debug)]
pub struct Scenes<'a> {
    scene: &'a Scene,
    gear: &'a Scene,
    /// The scene whose objects cast shadows.
    occluders: &'a Scene,
    pub(crate) lights: &'a [Light],
    pub(crate) fineness: f32,
}

static NOTHING: LazyLock<Scene> = LazyLock::new(Scene::default);

impl<'a> From<&'a Scene> for Scenes<'a> {
    fn from(scene: &'a Scene) -> Self {
        Self::new(scene, &NOTHING)
    }
}

impl<'a> Scenes<'a> {
    /// A scene with gear, which is lit by the lights of the scene.
    pub fn new(scene: &'a Scene, gear: &'a Scene) -> Self {
        Self { scene, gear, occluders: scene, lights: &scene.lights, fineness: 1.0 }
    }

    /// Draws edges and outlines of objects, lines of the scene, and marks `fineness` times as wide as their styles say,
    /// so that a scene that is small in the picture isn't lost in its own strokes.
    #[must_use]
    pub fn with_fineness(self, fineness: f32) -> Self {
        Self { fineness, ..self }
    }

    /// Takes the shadows of another scene: objects that aren't shown cast their shadows all the same.
    #[must_use]
    pub fn in_shadows_of(self, other: &'a Scene) -> Self {
        Self { occluders: other, ..self }
    }

    /// The objects that hide light: those with opaque faces. Gear hides none.
    pub(crate) fn occluders(self) -> impl Iterator<Item = &'a Object> {
        let has_faces = |object: &&Object| object.faces && !object.mesh.triangles.is_empty();
        self.occluders.objects.iter().filter(has_faces).filter(|object| !object.paint.is_translucent())
    }

    /// True if any light casts a shadow.
    pub(crate) fn casts_shadows(self) -> bool {
        self.lights.iter().any(|light| light.shadows.cast) && self.occluders().next().is_some()
    }

    /// Switches all lights off, so that everything shows its own colours.
    #[must_use]
    pub fn without_lights(self) -> Self {
        Self { lights: &[], ..self }
    }

    /// Replaces the lights.
    #[must_use]
    pub fn lit_by(self, lights: &'a [Light]) -> Self {
        Self { lights, ..self }
    }

    pub(crate) fn objects(self) -> impl Iterator<Item = &'a Object> {
        self.scene.objects.iter().chain(&self.gear.objects)
    }

    /// Number of [`Self::objects`] that belong to the scene. They come first.
    pub(crate) fn own_object_count(self) -> usize {
        self.scene.objects.len()
    }

    pub(crate) fn lines(self) -> impl Iterator<Item = &'a Line> {
        self.scene.lines.iter().chain(&self.gear.lines)
    }

    /// Number of [`Self::lines`] that belong to the scene. They come first.
    pub(crate) fn own_line_count(self) -> usize {
        self.scene.lines.len()
    }

    pub(crate) fn marks(self) -> impl Iterator<Item = &'a PointMark> {
        self.scene.marks.iter().chain(&self.gear.marks)
    }

    pub(crate) fn texts(self) -> impl Iterator<Item = &'a Text> {
        self.scene.texts.iter().chain(&self.gear.texts)
    }

    /// The number of objects.
    pub(crate) fn object_count(self) -> usize {
        self.scene.objects.len() + self.gear.objects.len()
    }

    /// The number of lines, marks and texts.
    pub(crate) fn line_count(self) -> usize {
        let count = |scene: &Scene| scene.lines.len() + scene.marks.len() + scene.texts.len();
        count(self.scene) + count(self.gear)
    }
}
