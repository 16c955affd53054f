//! The places of the objects of a picture. Those in view stand one by one, those out of sight by groups: neither plan
//! nor report takes memory for each of thousands that nobody sees.

use std::sync::Arc;

use super::cull::Containment;
use super::planes::PlaneSet;

/// The place of each object of a scene.
#[derive(Clone, Debug, Default)]
pub(super) struct Places {
    /// Number of objects.
    count: usize,
    /// Objects that were tested alone, in the order of the scene.
    alone: Vec<(u32, Containment)>,
    /// All others.
    groups: Vec<Group>,
    /// The place of each object in the order of the tree, if it is there.
    ranks: Arc<[u32]>,
}

/// Objects that are out of sight together.
#[derive(Clone, Copy, Debug)]
pub(super) struct Group {
    /// The first of them, in the order of the tree.
    pub(super) first: u32,
    /// The one after the last.
    pub(super) end: u32,
    /// The planes that all of them are outside of.
    pub(super) planes: PlaneSet,
}

impl Places {
    /// Of `count` objects: each is either `alone` or in one of the groups, which are sorted.
    pub(super) fn new(count: usize, mut alone: Vec<(u32, Containment)>, groups: Vec<Group>, ranks: Arc<[u32]>) -> Self {
        if !alone.is_sorted_by_key(|(object, _)| *object) {
            alone.sort_unstable_by_key(|(object, _)| *object);
        }
        Self { count, alone, groups, ranks }
    }

    /// Number of objects.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// Number of objects that are out of sight.
    pub(super) fn outside(&self) -> usize {
        let others = self.alone.iter().filter(|(_, place)| !matches!(place, Containment::Outside(_)));
        self.count - others.count()
    }

    /// Those that may be in view, in the order of the scene.
    pub(super) fn in_view(&self) -> impl Iterator<Item = (usize, Containment)> {
        let alone = self.alone.iter().filter(|(_, place)| matches!(place, Containment::Crosses(_)));
        alone.map(|&(object, place)| (object as usize, place))
    }

    /// All of them.
    pub(super) fn iter(&self) -> impl Iterator<Item = (usize, Containment)> {
        (0..self.count).map(|object| (object, self.of(object)))
    }

    /// The place of one of them.
    pub(super) fn of(&self, object: usize) -> Containment {
        if let Ok(at) = self.alone.binary_search_by_key(&object, |(object, _)| *object as usize) {
            return self.alone[at].1;
        }
        let group = self.ranks.get(object).and_then(|&rank| {
            let next = self.groups.partition_point(|group| group.first <= rank);
            self.groups[..next].last().filter(|group| rank < group.end)
        });
        // Every object is alone or in a group.
        group.map_or(Containment::Empty, |group| Containment::Outside(group.planes))
    }
}

/// Something known of each object of a scene: listed where the object is drawn, else made from its place.
#[derive(Clone, Debug)]
pub struct ByObject<T> {
    listed: Vec<(usize, T)>,
    places: Arc<Places>,
}

impl<T: Copy + From<Containment>> ByObject<T> {
    /// `listed` is in the order of the scene.
    pub(super) fn new(listed: Vec<(usize, T)>, places: Arc<Places>) -> Self {
        Self { listed, places }
    }

    /// Something else known of the same objects.
    pub(super) fn map<U>(&self, each: impl Fn(&T) -> U) -> ByObject<U> {
        let listed = self.listed.iter().map(|(object, of)| (*object, each(of))).collect();
        ByObject { listed, places: self.places.clone() }
    }

    /// The same together with something else known of the same objects, of which the same ones are listed.
    pub(super) fn zipped<U>(&self, with: &ByObject<U>, each: impl Fn(&T, &U) -> T) -> Self {
        let listed = self.listed.iter().zip(&with.listed);
        let listed = listed.map(|((object, of), (_, with))| (*object, each(of, with))).collect();
        Self { listed, places: self.places.clone() }
    }

    /// Number of objects.
    #[must_use]
    pub fn len(&self) -> usize {
        self.places.count()
    }

    /// True of a scene without objects.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of objects that are out of sight.
    pub(super) fn outside(&self) -> usize {
        self.places.outside()
    }

    /// Those that are drawn, with their places in the scene.
    pub(super) fn listed(&self) -> &[(usize, T)] {
        &self.listed
    }

    /// That of one that is drawn.
    pub(super) fn listed_mut(&mut self, object: usize) -> Option<&mut T> {
        let at = self.at(object).ok()?;
        Some(&mut self.listed[at].1)
    }

    /// That of one object; `None` where the scene has fewer.
    #[must_use]
    pub fn get(&self, object: usize) -> Option<T> {
        (object < self.len()).then(|| match self.at(object) {
            Ok(at) => self.listed[at].1,
            Err(_) => self.places.of(object).into(),
        })
    }

    /// Those of all objects, in the order of the scene.
    pub fn iter(&self) -> impl Iterator<Item = T> {
        (0..self.len()).filter_map(|object| self.get(object))
    }

    fn at(&self, object: usize) -> Result<usize, usize> {
        self.listed.binary_search_by_key(&object, |(object, _)| *object)
    }
}

/// Without objects.
impl<T> Default for ByObject<T> {
    fn default() -> Self {
        Self { listed: Vec::new(), places: Arc::default() }
    }
}

/// Equal where the same is known of each object, however it is stored.
impl<T: Copy + From<Containment> + PartialEq> PartialEq for ByObject<T> {
    fn eq(&self, other: &Self) -> bool {
        self.len() == other.len() && self.iter().eq(other.iter())
    }
}

impl<T: Copy + From<Containment> + Eq> Eq for ByObject<T> {}
