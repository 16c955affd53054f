//! Undo and redo: snapshots of the figure, which share scenes that haven't changed.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::camera::{Camera, Parameters};
use crate::figure::{Figure, Screen, Show, ShownTriangle};
use crate::limits::{MAX_UNDO_BYTES, MAX_UNDO_STEPS};
use crate::scene::{Light, ObjectSpec, SceneSpec, Shape, ShapeData};
use camera_lab_files::{Renamed, rename};

/// The number of a scene or of a document. Equal numbers mean equal content, without comparing it, which can be large.
/// Different numbers have no meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Revision(u64);

impl Revision {
    /// A number that nothing else has.
    pub fn fresh() -> Self {
        static LAST: AtomicU64 = AtomicU64::new(0);
        Self(LAST.fetch_add(1, Ordering::Relaxed))
    }
}

/// The content of an undo step: everything but the observers. Of `[show]` it restores the choices, or all of it if the
/// figure was another one.
#[derive(Clone, Debug)]
struct Snapshot {
    /// Tells this step from all others.
    step: Revision,
    scene: Arc<SceneSpec>,
    revision: Revision,
    /// The figure without its scene.
    rest: Figure,
    /// With its digits beyond the `f64`s of its parameters.
    camera: Camera,
    draft: Parameters,
    show: Show,
    /// True if this figure has replaced another one.
    replaces: bool,
}

/// The edited state, as seen by undo and redo.
#[derive(Clone, Debug)]
pub struct Moment {
    pub(crate) figure: Figure,
    pub(crate) revision: Revision,
    pub(crate) camera: Camera,
    pub(crate) draft: Parameters,
}

impl Snapshot {
    /// Shares the scene of `before` if it's the same.
    fn new(
        (figure, revision): (&Figure, Revision),
        camera: &Camera,
        draft: &Parameters,
        before: Option<&Self>,
    ) -> Self {
        let shared = before.filter(|before| before.has_scene(&figure.scene, revision)).map(|before| &before.scene);
        Self {
            step: Revision::fresh(),
            scene: shared.map_or_else(|| Arc::new(figure.scene.clone()), Arc::clone),
            revision,
            rest: edited(figure),
            camera: camera.clone(),
            draft: *draft,
            show: figure.show.clone(),
            replaces: false,
        }
    }

    fn has_scene(&self, scene: &SceneSpec, revision: Revision) -> bool {
        self.revision == revision || *self.scene == *scene
    }

    fn is_of(&self, (figure, revision): (&Figure, Revision), camera: &Camera, draft: &Parameters) -> bool {
        (&self.camera, &self.draft) == (camera, draft)
            && self.rest == edited(figure)
            && chosen(&self.show) == chosen(&figure.show)
            && self.has_scene(&figure.scene, revision)
    }

    /// The figure then, with the viewpoints and layout of `now`. If `all`, the explanations of then replace the present
    /// ones as a whole.
    fn moment(&self, now: &Figure, all: bool) -> Moment {
        let Self { scene, revision, rest, camera, draft, show: then, step: _, replaces: _ } = self.clone();
        let scene = Arc::unwrap_or_clone(scene);
        let show = if all { then } else { with_chosen(&now.show, &then) };
        let (observers, screen) = (now.observers, now.screen);
        let figure = Figure { camera: *camera.parameters(), scene, observers, screen, show, ..rest };
        Moment { figure, revision, camera, draft }
    }
}

/// The edited parts except the scene, which snapshots share. The layout is stored in the file and isn't a step.
fn edited(figure: &Figure) -> Figure {
    Figure { screen: Screen::default(), ..figure.without_scene() }
}

/// The parts of `[show]` that are choices. Parts set by pointing, playing, or a panel aren't.
fn chosen(show: &Show) -> impl PartialEq {
    let triangle = show.triangle.as_ref().map(|triangle| (&triangle.object, triangle.index));
    (show.stage, show.stage_of, triangle, &show.measure, &show.measure_of, &show.operations)
}

/// The present `[show]`, with the choices of then.
fn with_chosen(now: &Show, then: &Show) -> Show {
    let Show { stage, stage_of, triangle, measure, measure_of, operations, .. } = then.clone();
    let is_of = |triangle: &ShownTriangle| (triangle.object.clone(), triangle.index);
    // For the same triangle, its step and its pixel stay.
    let triangle =
        if now.triangle.as_ref().map(is_of) == triangle.as_ref().map(is_of) { now.triangle.clone() } else { triangle };
    Show { stage, stage_of, triangle, measure, measure_of, operations, ..now.clone() }
}

/// The steps.
#[derive(Clone, Debug)]
pub struct History {
    now: Snapshot,
    past: Vec<Snapshot>,
    future: Vec<Snapshot>,
}

impl History {
    pub(crate) fn new(figure: &Figure, revision: Revision, camera: &Camera) -> Self {
        let now = Snapshot::new((figure, revision), camera, &figure.camera, None);
        Self { now, past: Vec::new(), future: Vec::new() }
    }

    /// Makes a step of the changes since the last one. Returns false if there are none.
    pub fn commit(&mut self, of: (&Figure, Revision), camera: &Camera, draft: &Parameters) -> bool {
        if self.now.is_of(of, camera, draft) {
            // Another number may have come to the same scene.
            self.now.revision = of.1;
            return false;
        }
        let now = Snapshot::new(of, camera, draft, Some(&self.now));
        self.push(now);
        true
    }

    /// True if the choice of explanation has changed since the last step.
    pub fn shows_other(&self, show: &Show) -> bool {
        chosen(&self.now.show) != chosen(show)
    }

    /// True if the kept operations are still those of the last step, but the camera isn't, so they don't lead to it.
    pub fn leads_elsewhere(&self, show: &Show, camera: &Camera) -> bool {
        !show.operations.is_empty()
            && self.now.show.operations == show.operations
            && self.now.camera.parameters() != camera.parameters()
    }

    /// Makes a step of another figure that has replaced the one before, which explained `before`.
    pub fn replace(&mut self, before: Show, of: (&Figure, Revision), camera: &Camera) {
        self.now.show = before;
        let now = Snapshot::new(of, camera, &of.0.camera, Some(&self.now));
        if !self.now.is_of(of, camera, &of.0.camera) || self.now.show != of.0.show {
            self.push(Snapshot { replaces: true, ..now });
        }
    }

    fn push(&mut self, now: Snapshot) {
        self.past.push(std::mem::replace(&mut self.now, now));
        self.future.clear();
        let steps = self.affordable();
        self.past.drain(..self.past.len() - steps);
    }

    /// Number of the last steps within the bounds, at least one.
    fn affordable(&self) -> usize {
        let mut newer = &self.now;
        let mut bytes = 0_usize;
        let mut steps = 0;
        for step in self.past.iter().rev().take(MAX_UNDO_STEPS) {
            if !Arc::ptr_eq(&step.scene, &newer.scene) {
                bytes = bytes.saturating_add(bytes_of(&step.scene));
            }
            if bytes > MAX_UNDO_BYTES && steps > 0 {
                break;
            }
            steps += 1;
            newer = step;
        }
        steps
    }

    /// Gives new names to the files of all steps.
    pub fn rename(&mut self, renamed: &Renamed) {
        if renamed.is_empty() {
            return;
        }
        // Steps go on sharing their scenes.
        let mut last: Option<(Arc<SceneSpec>, Arc<SceneSpec>)> = None;
        for step in self.past.iter_mut().chain([&mut self.now]).chain(&mut self.future) {
            let known = last.as_ref().filter(|(old, _)| Arc::ptr_eq(old, &step.scene)).map(|(_, new)| Arc::clone(new));
            let new = known.unwrap_or_else(|| {
                let mut scene = SceneSpec::clone(&step.scene);
                rename(scene.files_mut(), renamed);
                Arc::new(scene)
            });
            let old = std::mem::replace(&mut step.scene, Arc::clone(&new));
            last = Some((old, new));
            rename(step.rest.files_mut(), renamed);
        }
    }

    /// Drops the steps to redo.
    pub fn forget_future(&mut self) {
        self.future.clear();
    }

    /// The present step. Undoing and redoing lead to the same steps again.
    pub(crate) const fn step(&self) -> Revision {
        self.now.step
    }

    pub(crate) fn can_undo(&self, back: bool) -> bool {
        !if back { &self.past } else { &self.future }.is_empty()
    }

    /// Undoes a step (`back`), or redoes it. Returns the state then, seen and laid out as `now`.
    pub fn undo(&mut self, now: &Figure, back: bool) -> Option<Moment> {
        let (from, to) = if back { (&mut self.past, &mut self.future) } else { (&mut self.future, &mut self.past) };
        let next = from.pop()?;
        self.now.show = now.show.clone();
        let last = std::mem::replace(&mut self.now, next);
        let all = if back { &last } else { &self.now }.replaces;
        to.push(last);
        Some(self.now.moment(now, all))
    }
}

/// The approximate memory of a scene: that of its objects, their names and their points.
fn bytes_of(scene: &SceneSpec) -> usize {
    let object = |object: &ObjectSpec| {
        let names = object.name.len() + object.parent.as_ref().map_or(0, String::len);
        size_of::<ObjectSpec>() + names + object.shape.as_ref().map_or(0, data_of)
    };
    scene.objects.iter().map(object).sum::<usize>() + size_of_val(&scene.lights[..]) + size_of::<Light>()
}

fn data_of(shape: &Shape) -> usize {
    match shape.data() {
        ShapeData::Points(points) => size_of_val(points),
        ShapeData::Path(path) => path.len(),
        ShapeData::None => 0,
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;

    fn history(objects: usize) -> (History, Figure, Camera) {
        let mut figure = Figure::default();
        figure.scene.objects = (0..objects).map(|i| ObjectSpec::new(format!("object {i}"), Shape::Box)).collect();
        let camera = Camera::new(&figure.camera).unwrap();
        (History::new(&figure, Revision::fresh(), &camera), figure, camera)
    }

    #[test]
    fn a_scene_that_stays_is_not_copied() {
        let (mut history, mut figure, camera) = history(1000);
        for width in 1..=2 * u32::try_from(MAX_UNDO_STEPS).unwrap() {
            figure.image.width = width;
            history.commit((&figure, Revision::fresh()), &camera, &figure.camera);
        }
        assert_eq!(history.past.len(), MAX_UNDO_STEPS);
        assert!(history.past.iter().all(|step| Arc::ptr_eq(&step.scene, &history.now.scene)));
        assert_eq!(Arc::strong_count(&history.now.scene), MAX_UNDO_STEPS + 1);
    }

    #[test]
    fn scenes_with_the_same_number_are_not_compared() {
        let (mut history, figure, camera) = history(3);
        // A scene that is only declared the same, because it hasn't been compared.
        let mut other = figure.clone();
        other.scene.objects.clear();
        history.commit((&other, history.now.revision), &camera, &figure.camera);
        assert!(!history.can_undo(true));
        // The same scene under another number has that from then on.
        let renumbered = Revision::fresh();
        history.commit((&figure, renumbered), &camera, &figure.camera);
        assert!(!history.can_undo(true) && history.now.revision == renumbered);
        history.commit((&other, Revision::fresh()), &camera, &figure.camera);
        assert_eq!(history.undo(&Figure::default(), true).unwrap().revision, renumbered);
    }

    #[test]
    fn scenes_that_change_have_a_budget_and_the_oldest_go() {
        let (mut history, mut figure, camera) = history(20_000);
        let scene = bytes_of(&figure.scene);
        assert!(scene > 20_000 * size_of::<ObjectSpec>());
        for x in 1..=60 {
            figure.scene.objects[7].translate.x = f64::from(x);
            history.commit((&figure, Revision::fresh()), &camera, &figure.camera);
        }
        assert_eq!(history.past.len(), MAX_UNDO_BYTES / scene);
        assert!(history.past.len() < 60 && history.past.len() >= 5);
        let last = history.undo(&Figure::default(), true).unwrap().figure;
        assert_eq!(last.scene.objects[7].translate.x, 59.0);
        // At least one step is kept, however large the scene.
        let (mut history, mut figure, camera) = self::history(1);
        let points = MAX_UNDO_BYTES / size_of::<glam::DVec3>() + 1;
        figure.scene.objects[0].shape = Some(Shape::Points(vec![glam::DVec3::ZERO; points]));
        history.commit((&figure, Revision::fresh()), &camera, &figure.camera);
        figure.scene.objects[0].name.push('!');
        history.commit((&figure, Revision::fresh()), &camera, &figure.camera);
        assert_eq!(history.past.len(), 1);
        assert_eq!(history.undo(&Figure::default(), true).unwrap().figure.scene.objects[0].name, "object 0");
    }
}
