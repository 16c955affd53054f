//! A tree of boxes over the scene, so that objects out of sight are dropped by the thousand.

use std::collections::{BTreeSet, HashMap};
use std::sync::{Arc, Weak};

use glam::{DMat4, DVec3};

use super::bounds::Bounds;
use super::cull::{Containment, containment, outside};
use super::depths::InView;
use super::places::{Group, Places};
use super::projector::Projector;
use super::scenes::Scenes;
use crate::geometry::Aabb;
use crate::scene::{Mesh, Object, SceneRevision};

/// The scene drawn last, and the tree of boxes over its objects.
///
/// A scene that has changed a little keeps its tree; the changed objects are then tested one by one.
#[derive(Debug, Default)]
pub(super) struct BoundingTree {
    /// Bounds of meshes, by their address: no other mesh gets it as long as the weak pointer exists, and a mesh does
    /// not change as long as it is shared.
    meshes: HashMap<usize, (Weak<Mesh>, Option<Bounds>)>,
    objects: Vec<Known>,
    /// That of the scene, and how many of the objects are its own.
    revision: Option<(SceneRevision, usize)>,
    /// Objects in the order of the leaves.
    order: Vec<u32>,
    /// The place of each object in `order`; [`u32::MAX`] of those that are not there.
    ranks: Arc<[u32]>,
    /// Each before the two below it; empty where there is nothing to gain.
    nodes: Vec<Node>,
    /// Objects that are not, or no longer, where the tree has them.
    loose: BTreeSet<u32>,
    /// Number of them that cannot be in any tree.
    without_box: usize,
}

/// The objects of a scene, held against the volume.
#[derive(Debug)]
pub(super) struct Found {
    pub(super) places: Places,
    /// Number of boxes tested against the volume.
    pub(super) boxes_tested: usize,
    /// Between which distances there may be any of them in the volume.
    pub(super) in_view: InView,
}

/// An object as it was last seen.
#[derive(Clone, Debug)]
struct Known {
    mesh: Weak<Mesh>,
    world_from_object: DMat4,
    bounds: Option<Bounds>,
}

/// A box around objects, in the world.
#[derive(Clone, Copy, Debug)]
struct Node {
    aabb: Aabb,
    /// The size of the numbers that the objects' coordinates are summed up from.
    magnitude: f64,
    /// The objects: a range of `order`.
    first: u32,
    end: u32,
    /// The node that comes after all that are below this one.
    skip: u32,
}

/// Scenes with fewer objects have no tree.
const FEW: usize = 16;
/// Greatest number of objects in a leaf.
const LEAF: usize = 4;

impl BoundingTree {
    /// The place of each object of `scenes`.
    pub(super) fn find(&mut self, scenes: Scenes, projector: &Projector) -> Found {
        self.update(scenes);
        let (mut alone, mut in_view, mut groups) = (Vec::new(), InView::NOTHING, Vec::new());
        let (mut next, mut boxes) = (0, 0);
        let mut test = |k: u32| {
            let place = match &self.objects[k as usize] {
                Known { bounds: None, .. } => Containment::Empty,
                Known { bounds: Some(bounds), world_from_object, .. } => {
                    boxes += 1;
                    let place = containment(projector, &projector.view_from_object(*world_from_object), bounds);
                    in_view = in_view.and(place.in_view);
                    place.containment
                }
            };
            alone.push((k, place));
        };
        let count = self.objects.len();
        if self.nodes.is_empty() {
            (0..to_u32(count)).for_each(&mut test);
        }
        let mut visited = 0;
        while let Some((k, node)) = self.nodes.get(next).map(|node| (next, node)) {
            visited += 1;
            next += 1;
            let planes = outside(projector, &node.aabb, node.magnitude);
            let is_leaf = node.skip as usize == next;
            if planes == 0 && !is_leaf {
                continue;
            }
            if planes != 0 {
                groups.push(Group { first: node.first, end: node.end, planes });
            } else {
                let objects = &self.order[node.first as usize..node.end as usize];
                // A scene may have become shorter, and objects may have gone elsewhere.
                objects.iter().filter(|&&k| (k as usize) < count && !self.loose.contains(&k)).for_each(|&k| test(k));
            }
            next = self.nodes[k].skip as usize;
        }
        self.loose.iter().for_each(|&k| test(k));
        let boxes_tested = boxes + visited;
        Found { places: Places::new(count, alone, groups, self.ranks.clone()), boxes_tested, in_view }
    }

    /// Updates the tree and the bounds.
    fn update(&mut self, scenes: Scenes) {
        let count = scenes.object_count();
        self.objects.truncate(count);
        self.loose.retain(|&k| (k as usize) < count);
        let (before, now) = (std::mem::replace(&mut self.revision, scenes.revision()), scenes.revision());
        let unchanged = now.filter(|_| before == now).map_or(0, |(_, own)| own);
        for (k, object) in (0_u32..).zip(scenes.objects()).skip(unchanged) {
            match self.objects.get(k as usize) {
                Some(known) if known.is(object) => continue,
                Some(_) => self.objects[k as usize] = self.look_at(object),
                None => {
                    let known = self.look_at(object);
                    self.objects.push(known);
                }
            }
            self.loose.insert(k);
        }
        if self.meshes.len() > 2 * count + FEW {
            self.meshes.retain(|_, (mesh, _)| mesh.strong_count() > 0);
        }
        if count < FEW {
            self.nodes.clear();
            self.loose.clear();
        } else if self.nodes.is_empty() || self.loose.len() > self.without_box + FEW + count / 8 {
            self.build();
        }
    }

    fn look_at(&mut self, object: &Object) -> Known {
        let mesh = Arc::downgrade(&object.mesh);
        let known = self.meshes.entry(mesh.as_ptr().addr());
        let (_, bounds) = known.or_insert_with(|| (mesh.clone(), Bounds::of(&object.mesh)));
        Known { mesh, world_from_object: object.world_from_object, bounds: *bounds }
    }

    fn build(&mut self) {
        let boxes = (0_u32..).zip(&self.objects).filter_map(|(k, object)| Some((k, object.world_box()?)));
        let mut boxes: Vec<Boxed> =
            boxes.map(|(object, (aabb, magnitude))| Boxed { object, aabb, magnitude }).collect();
        self.nodes.clear();
        grow(&mut self.nodes, &mut boxes, 0);
        self.order = boxes.iter().map(|boxed| boxed.object).collect();
        let mut ranks = vec![u32::MAX; self.objects.len()];
        (0..).zip(&self.order).for_each(|(rank, &object)| ranks[object as usize] = rank);
        self.loose = (0_u32..).zip(&ranks).filter(|(_, rank)| **rank == u32::MAX).map(|(k, _)| k).collect();
        self.ranks = ranks.into();
        self.without_box = self.loose.len();
    }
}

impl Known {
    fn is(&self, object: &Object) -> bool {
        std::ptr::eq(self.mesh.as_ptr(), Arc::as_ptr(&object.mesh))
            && self.world_from_object == object.world_from_object
    }

    /// A box in the world around the object, and the size of the numbers that its corners are summed up from. `None`
    /// without one that can be relied on.
    fn world_box(&self) -> Option<(Aabb, f64)> {
        let bounds = self.bounds.filter(|bounds| bounds.finite)?;
        let m = self.world_from_object;
        let size = bounds.aabb.corners().into_iter().fold(0.0, |most: f64, p| most.max(p.length()));
        let norm = m.to_cols_array().iter().fold(0.0, |sum, c| sum + c * c).sqrt();
        let magnitude = norm * (1.0 + size);
        // Without a box where a corner is not a number.
        let aabb = Aabb::around(bounds.aabb.corners().map(|p| m.transform_point3(p)))?;
        magnitude.is_finite().then_some((aabb, magnitude))
    }
}

/// An object that is to be put into the tree.
struct Boxed {
    object: u32,
    aabb: Aabb,
    magnitude: f64,
}

/// Adds the tree over `boxes`, and puts them in the order of its leaves; the first of them is number `first` of all.
fn grow(nodes: &mut Vec<Node>, boxes: &mut [Boxed], first: usize) {
    let all = boxes.iter().map(|boxed| (boxed.aabb, boxed.magnitude));
    let Some((aabb, magnitude)) = all.reduce(|(a, m), (b, n)| (a.union(b), m.max(n))) else { return };
    let at = nodes.len();
    nodes.push(Node { aabb, magnitude, first: to_u32(first), end: to_u32(first + boxes.len()), skip: 0 });
    if boxes.len() > LEAF {
        let middles = Aabb::around(boxes.iter().map(|boxed| boxed.aabb.center()));
        let extent = middles.map_or(DVec3::ZERO, |b| b.max - b.min);
        let axis = (0..3).max_by(|&i, &j| extent[i].total_cmp(&extent[j])).unwrap_or(0);
        let along = |boxed: &Boxed| boxed.aabb.center()[axis];
        let half = boxes.len() / 2;
        boxes.select_nth_unstable_by(half, |a, b| along(a).total_cmp(&along(b)));
        let (low, high) = boxes.split_at_mut(half);
        grow(nodes, low, first);
        grow(nodes, high, first + half);
    }
    nodes[at].skip = to_u32(nodes.len());
}

/// Objects are counted with 32 bits.
fn to_u32(k: usize) -> u32 {
    u32::try_from(k).unwrap_or(u32::MAX)
}
