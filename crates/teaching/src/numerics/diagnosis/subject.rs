//! The contents of a scene, by name: objects and grids.

use std::collections::BTreeSet;

use glam::DVec3;

use super::Ball;
use crate::appearance::{Shading, Style};
use crate::geometry::Aabb;
use crate::scene::{Line, Object, ObjectPaint, PointMark, Scene};

/// Something that may be visible.
pub(super) struct NamedThing<'a> {
    pub(super) name: &'a str,
    /// Its place among the objects of the scene.
    pub(super) index: Option<usize>,
    /// The greatest alpha of its colours.
    pub(super) opacity: u8,
    what: ThingKind<'a>,
}

/// The parts of a named thing.
#[derive(Clone, Copy)]
enum ThingKind<'a> {
    Object(&'a Object),
    Lines(&'a [Line]),
    Marks(&'a [PointMark]),
}

impl<'a> NamedThing<'a> {
    /// All of a scene. Additions of a preset count only if there's nothing else.
    pub(super) fn all(scene: &'a Scene) -> Vec<Self> {
        let objects = scene.objects.iter().enumerate().filter(|(_, object)| !object.mesh.positions.is_empty());
        let objects = objects.map(|(index, object)| Self {
            name: &object.name,
            index: Some(index),
            opacity: opacity(object),
            what: ThingKind::Object(object),
        });
        let lines = |name, lines: &'a [Line]| {
            let opacity = lines.iter().map(|line| line.style.color.a).max()?;
            Some(Self { name, index: None, opacity, what: ThingKind::Lines(lines) })
        };
        let grids = scene.grids.iter().filter_map(|(name, range)| lines(name, scene.lines.get(range.clone())?));
        let mut all: Vec<Self> = objects.chain(grids).collect();
        if all.is_empty() {
            all.extend(lines("", &scene.lines));
            let opacity = scene.marks.iter().map(|mark| mark.color.a).max();
            all.extend(opacity.map(|opacity| Self {
                name: "",
                index: None,
                opacity,
                what: ThingKind::Marks(&scene.marks),
            }));
        }
        all
    }

    /// Its points in the world.
    pub(super) fn points(&self) -> Box<dyn Iterator<Item = DVec3> + '_> {
        match self.what {
            ThingKind::Object(object) => {
                Box::new(object.mesh.positions.iter().map(|&p| object.world_from_object.transform_point3(p)))
            }
            ThingKind::Lines(lines) => Box::new(lines.iter().flat_map(|line| line.points.iter().copied())),
            ThingKind::Marks(marks) => Box::new(marks.iter().map(|mark| mark.position)),
        }
    }

    /// The segments that it's drawn with, if it has no faces.
    pub(super) fn segments(&self) -> Box<dyn Iterator<Item = [DVec3; 2]> + '_> {
        match self.what {
            ThingKind::Object(object) => Box::new(object.mesh.edges.iter().filter_map(|edge| {
                let [Some(a), Some(b)] = edge.map(|i| object.mesh.positions.get(i as usize)) else { return None };
                Some([*a, *b].map(|p| object.world_from_object.transform_point3(p)))
            })),
            ThingKind::Lines(lines) => {
                Box::new(lines.iter().flat_map(|line| line.points.windows(2).map(|ab| [ab[0], ab[1]])))
            }
            ThingKind::Marks(_) => Box::new(std::iter::empty()),
        }
    }

    /// True if it's drawn as marks, which keep their size with any camera.
    pub(super) fn is_point(&self) -> bool {
        match self.what {
            ThingKind::Object(object) => !object.faces && object.mesh.edges.is_empty(),
            ThingKind::Lines(_) => false,
            ThingKind::Marks(_) => true,
        }
    }

    /// Its faces are drawn.
    pub(super) fn has_faces(&self, style: &Style) -> bool {
        matches!(self.what, ThingKind::Object(object) if object.faces && !object.mesh.triangles.is_empty())
            && style.shading != Shading::Wireframe
    }

    /// A wireframe draws edges in full colour, whatever the alpha of the object.
    pub(super) fn can_be_wireframe(&self) -> bool {
        matches!(self.what, ThingKind::Object(object) if !object.mesh.edges.is_empty())
    }

    pub(super) fn is_shown_by_wireframe(&self, style: &Style) -> bool {
        style.shading == Shading::Wireframe && self.can_be_wireframe()
    }

    /// True if a point is inside a closed surface, because then the surface fills the whole sphere of directions around
    /// it (the solid angles of its triangles add up to 4π; A. van Oosterom, J. Strackee, *The solid angle of a plane
    /// triangle*, 1983).
    pub(super) fn contains(&self, p_world: DVec3) -> bool {
        let ThingKind::Object(object) = self.what else { return false };
        if !(object.faces && object.mesh.closed) {
            return false;
        }
        let object_from_world = object.world_from_object.inverse();
        let p = object_from_world.transform_point3(p_world);
        let inside = |b: Aabb| p.cmpge(b.min).all() && p.cmple(b.max).all();
        p.is_finite() && object.mesh.bounds().is_some_and(inside) && winding(object, p).abs() > 0.5
    }

    /// The scene without everything else.
    pub(super) fn alone(&self, scene: &Scene) -> Scene {
        let mut alone = Scene { lights: scene.lights.clone(), ..Scene::default() };
        self.add_to(&mut alone, scene);
        alone
    }

    /// Adds it to a scene.
    pub(super) fn add_to(&self, to: &mut Scene, from: &Scene) {
        match self.what {
            ThingKind::Object(object) => {
                to.objects.push(object.clone());
                if self.is_point() {
                    let bits = |p: DVec3| p.to_array().map(f64::to_bits);
                    let points: BTreeSet<[u64; 3]> = self.points().map(bits).collect();
                    to.marks.extend(from.marks.iter().filter(|mark| points.contains(&bits(mark.position))).cloned());
                }
            }
            ThingKind::Lines(lines) => to.lines.extend_from_slice(lines),
            ThingKind::Marks(marks) => to.marks.extend_from_slice(marks),
        }
    }

    /// The same thing, with both sides of its faces drawn.
    pub(super) fn both_sides(&self, scene: &Scene) -> Scene {
        let mut alone = self.alone(scene);
        alone.objects.iter_mut().for_each(|object| object.two_sided = true);
        alone
    }
}

/// A ball around subjects; `None` without a finite point.
pub(super) fn ball(subjects: &[&NamedThing]) -> Option<Ball> {
    let points = || subjects.iter().flat_map(|subject| subject.points()).filter(|p| p.is_finite());
    let center = Aabb::around(points())?.center();
    let radius = points().map(|p| p.distance(center)).fold(0.0, f64::max);
    radius.is_finite().then_some(Ball { center, radius })
}

fn opacity(object: &Object) -> u8 {
    let greatest = |colors: &[crate::appearance::Rgba]| colors.iter().map(|color| color.a).max().unwrap_or(0);
    match &object.paint {
        ObjectPaint::Solid(color) => color.a,
        ObjectPaint::Faces(colors) | ObjectPaint::Vertices(colors) => greatest(colors),
        ObjectPaint::Texture(pictured) => pictured.tint.a,
    }
}

/// Winding number of a surface around a point of the object's space.
fn winding(object: &Object, p: DVec3) -> f64 {
    let mesh = &object.mesh;
    let angle = |triangle: &[u32; 3]| {
        let [Some(a), Some(b), Some(c)] = triangle.map(|i| mesh.positions.get(i as usize)) else { return 0.0 };
        let [a, b, c] = [*a - p, *b - p, *c - p];
        let (la, lb, lc) = (a.length(), b.length(), c.length());
        let y = a.dot(b.cross(c));
        let x = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        2.0 * y.atan2(x)
    };
    let sum: f64 = mesh.triangles.iter().map(angle).sum();
    sum / (4.0 * std::f64::consts::PI)
}
