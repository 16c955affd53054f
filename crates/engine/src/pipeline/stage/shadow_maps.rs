//! The shadow maps of the lights.
//!
//! *Notes*: `[3]` §1.1 step 9 names shadows, without a method. *Textbook*: the depths of a picture taken from the light
//! (Williams 1978), six pictures around a lamp. *Here*: the same pipeline draws them. A map doesn't depend on the
//! camera of the picture, so all pictures of a scene share it. It's made again only if the light or an occluder
//! changes.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use glam::{DMat4, DVec3};

use super::vertex::{clip_from_view, view_point};
use crate::appearance::Rgba;
use crate::camera::{Camera, Parameters, Projection, ViewWindow};
use crate::drawing::{Rays, ShadowMap, single};
use crate::geometry::try_unit;
use crate::pipeline::scenes::Scenes;
use crate::pipeline::seen_by_light;
use crate::pipeline::space::ObjectPoint;
use crate::pipeline::space::projector::{Projector, ViewFromObject};
use crate::scene::{Light, LightKind, Mesh, Object, ObjectPaint, Scene, Shadows};

/// F of the camera of a lamp, as a share of B. Anything nearer casts no shadow.
const NEAREST: f64 = 1e-4;
/// Room around what casts shadows, as a share of its size.
const ROOM: f64 = 0.01;

/// A light that casts shadows, ready for a picture.
#[derive(Clone, Debug)]
pub(crate) struct ShadowLight {
    pub(crate) map: Arc<ShadowMap>,
    /// Its place among the lights of the scene.
    pub(crate) light: usize,
    /// The distance from the map's depths at which the shadow begins, in steps of the map.
    pub(crate) bias: f32,
    /// The camera of parallel light, or that of the first view of a lamp.
    projector: Projector,
}

/// The shadow maps of a scene. A clone has the same ones, so that pictures of one scene share them.
///
/// Maps of another scene, and of lights that a picture no longer has, go when the next picture is made.
#[derive(Clone, Debug, Default)]
pub struct ShadowMaps {
    kept: Arc<Mutex<Kept>>,
    painting: Arc<Mutex<()>>,
}

#[derive(Debug, Default)]
struct Kept {
    occluders: Arc<[Occluder]>,
    made: Vec<(Light, ShadowLight)>,
}

/// An occluder: an object that hides light.
#[derive(Clone, Debug)]
struct Occluder {
    mesh: Arc<Mesh>,
    world_from_object: DMat4,
}

impl Occluder {
    fn is(&self, object: &Object) -> bool {
        Arc::ptr_eq(&self.mesh, &object.mesh) && self.world_from_object == object.world_from_object
    }
}

impl ShadowMaps {
    /// The maps of a scene that pictures of it will ask for, painted or not.
    pub fn of_scene(&self, scenes: Scenes) -> Vec<Arc<ShadowMap>> {
        self.of(scenes).into_iter().map(|light| light.map).collect()
    }

    /// Paints maps while no other thread does, so that threads with a picture each don't paint the same ones, which
    /// takes as much memory again. Not for threads of the pool, which the painting thread may need.
    pub fn paint_alone(&self, paint: impl FnOnce(&Self)) {
        let _alone = self.painting.lock().unwrap_or_else(PoisonError::into_inner);
        paint(self);
    }

    /// The lights of a scene that cast shadows, with their maps.
    pub(crate) fn of(&self, scenes: Scenes) -> Vec<ShadowLight> {
        if !scenes.casts_shadows() {
            return Vec::new();
        }
        let (occluders, known) = self.kept().known(scenes);
        let mut lights = Vec::new();
        for ((index, light), known) in casting(scenes).zip(known) {
            // Nothing is locked here, because the pool may begin another picture meanwhile, which asks for maps too.
            let found = match known {
                Some(known) => known,
                None => {
                    let Some(made) = made(&light, &occluders) else { continue };
                    self.kept().keep(light, made, &occluders)
                }
            };
            let bias = single(scenes.lights[index].shadows.held().bias);
            lights.push(ShadowLight { light: index, bias, ..found });
        }
        lights
    }

    /// Forgets all maps: the next picture makes its own.
    pub fn forget(&self) {
        *self.kept() = Kept::default();
    }

    fn kept(&self) -> MutexGuard<'_, Kept> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The lights that cast shadows, with their places, as far as their maps depend on them.
fn casting(scenes: Scenes<'_>) -> impl Iterator<Item = (usize, Light)> {
    let casting = scenes.lights.iter().enumerate().filter(|(_, light)| light.shadows.cast);
    casting.map(|(index, light)| (index, Light { shadows: Shadows { bias: 0.0, ..light.shadows }, ..*light }))
}

impl Kept {
    /// The occluders of a scene, and the known maps of its lights that cast shadows.
    fn known(&mut self, scenes: Scenes) -> (Arc<[Occluder]>, Vec<Option<ShadowLight>>) {
        if !self.holds(scenes) {
            self.made.clear();
            let all = scenes.occluders();
            self.occluders = all
                .map(|object| Occluder { mesh: Arc::clone(&object.mesh), world_from_object: object.world_from_object })
                .collect();
        }
        self.made.retain(|(of, _)| casting(scenes).any(|(_, light)| light == *of));
        let found = |light| self.made.iter().find(|(of, _)| *of == light).map(|(_, made)| made.clone());
        (Arc::clone(&self.occluders), casting(scenes).map(|(_, light)| found(light)).collect())
    }

    /// Keeps a map of these occluders, unless another picture has meanwhile kept one, or one of another scene.
    fn keep(&mut self, light: Light, made: ShadowLight, occluders: &Arc<[Occluder]>) -> ShadowLight {
        if let Some((_, known)) =
            self.made.iter().find(|(of, _)| Arc::ptr_eq(&self.occluders, occluders) && *of == light)
        {
            return known.clone();
        }
        if Arc::ptr_eq(&self.occluders, occluders) {
            self.made.push((light, made.clone()));
        }
        made
    }

    /// True if the occluders are those of the last picture.
    fn holds(&self, scenes: Scenes) -> bool {
        let same = self.occluders.iter().map(Some).chain(std::iter::repeat(None));
        let mut count = 0;
        let unchanged = scenes.occluders().zip(same).all(|(object, old)| {
            count += 1;
            old.is_some_and(|old| old.is(object))
        });
        unchanged && count == self.occluders.len()
    }
}

/// The cameras of a light in a scene, whose pictures are its shadow map: one for parallel light, six around a lamp.
/// `None` if nothing hides its light.
pub fn light_cameras(scene: &Scene, light: &Light) -> Option<Vec<Camera>> {
    let scenes = Scenes::from(scene);
    scenes.occluders().next()?;
    cameras(light, scenes.occluders().flat_map(|object| world_points(&object.mesh, &object.world_from_object)))
}

/// The vertices of a mesh in the world, without those that are off to infinity.
fn world_points<'a>(mesh: &'a Mesh, world_from_object: &'a DMat4) -> impl Iterator<Item = DVec3> + 'a {
    mesh.positions.iter().map(|&p| world_from_object.transform_point3(p)).filter(|p| p.is_finite())
}

/// The cameras of a light: one that holds all occluders, or six around a lamp. `None` if there is no occluder.
fn cameras(light: &Light, points: impl Iterator<Item = DVec3>) -> Option<Vec<Camera>> {
    match light.kind {
        LightKind::Directional => Some(vec![parallel(light, points)?]),
        LightKind::Point => around(light, points),
    }
}

/// Half the width of a map at distance 1. Its inner part, of half width 1, holds the scene. The rest is for the soft
/// edge.
fn reach(shadows: Shadows) -> f64 {
    let shadows = shadows.held();
    let beyond = (0.5 * shadows.softness).ceil() + 1.0;
    let size = f64::from(shadows.map);
    size / (size - 2.0 * beyond)
}

/// A direction for up that isn't along `d`.
fn up(d: DVec3) -> DVec3 {
    if d.y.abs() > 0.9 * d.length() { DVec3::Z } else { DVec3::Y }
}

/// The camera of parallel light. Its volume is a box along the light's direction that holds all occluders.
fn parallel(light: &Light, points: impl Iterator<Item = DVec3>) -> Option<Camera> {
    let d = try_unit(light.vector)?;
    let up = up(d);
    let u = try_unit(d.cross(up))?;
    let v = u.cross(d);
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for p in points {
        let p = DVec3::new(u.dot(p), v.dot(p), d.dot(p));
        (low, high) = (low.min(p), high.max(p));
    }
    let (middle, size) = (low + 0.5 * (high - low), high - low);
    let across = size.x.max(size.y);
    let room = ROOM * across.max(size.z);
    if !(room > 0.0 && room.is_finite()) {
        return None;
    }
    let position = u * middle.x + v * middle.y + d * (low.z - 2.0 * room);
    let height = across.max(room) * reach(light.shadows);
    Camera::new(&Parameters {
        position,
        focal_point: position + d * (size.z + 3.0 * room),
        view_up: up,
        projection: Projection::Parallel,
        height,
        aspect: 1.0,
        near: room,
        far: size.z + 3.0 * room,
        ..Parameters::default()
    })
    .ok()
}

/// The six cameras of a lamp, along both directions of each axis.
fn around(light: &Light, points: impl Iterator<Item = DVec3>) -> Option<Vec<Camera>> {
    let position = light.vector;
    let far = points.map(|p| p.distance(position)).fold(0.0, f64::max);
    let near = NEAREST * far;
    let side = near * reach(light.shadows);
    let directions = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];
    let cameras = directions.map(|d| {
        Camera::new(&Parameters {
            position,
            focal_point: position + d * far,
            view_up: up(d),
            projection: Projection::Perspective,
            near,
            far,
            window: Some(ViewWindow { left: -side, right: side, bottom: -side, top: side }),
            ..Parameters::default()
        })
        .ok()
    });
    cameras.into_iter().collect()
}

/// The map of a light, to be painted.
fn made(light: &Light, occluders: &[Occluder]) -> Option<ShadowLight> {
    let points = occluders.iter().flat_map(|occluder| world_points(&occluder.mesh, &occluder.world_from_object));
    let shadows = light.shadows.held();
    let cameras = cameras(light, points)?;
    let scene = Scene { objects: occluders.iter().map(alone).collect(), ..Scene::default() };
    let size = shadows.map;
    let views = cameras.iter().map(|camera| seen_by_light(&scene, camera, size)).collect();
    let projector = Projector::new(cameras.first()?);
    let rays = rays(&cameras, &projector, size)?;
    let map = ShadowMap::new(views, size, rays, single(shadows.softness));
    Some(ShadowLight { map: Arc::new(map), light: 0, bias: 0.0, projector })
}

/// Only faces, without light, seen from both sides.
fn alone(Occluder { mesh, world_from_object }: &Occluder) -> Object {
    let paint = ObjectPaint::Solid(Rgba::rgb(0, 0, 0));
    Object { lit: false, two_sided: true, ..Object::new("", Arc::clone(mesh), *world_from_object, paint) }
}

fn rays(cameras: &[Camera], projector: &Projector, size: u32) -> Option<Rays> {
    let camera = cameras.first()?;
    let (near, far) = (camera.near(), camera.far());
    if !projector.projection.is_perspective() {
        return Some(Rays::Parallel { step: single(camera.window_height() / f64::from(size) / (far - near)) });
    }
    let axes = cameras.iter().map(|camera| {
        let basis = camera.basis();
        [basis.u, basis.v, -basis.n].map(|axis| projector.view_vector(axis).as_vec3().to_array())
    });
    Some(Rays::FromLamp {
        axes: axes.collect::<Vec<_>>().try_into().ok()?,
        reach: single(0.5 * camera.window_height() / near),
        unit: single(near / (far - near)),
    })
}

/// An object as a light sees it.
pub(crate) struct SeenByLight<'a> {
    light: &'a ShadowLight,
    view_from_object: ViewFromObject,
}

impl ShadowLight {
    /// An object at its place in the world as this light sees it.
    pub(crate) fn sees(&self, world_from_object: DMat4) -> SeenByLight<'_> {
        SeenByLight { light: self, view_from_object: self.projector.view_from_object(world_from_object) }
    }
}

impl SeenByLight<'_> {
    /// The place of a point of the object, as [`Rays`] has it.
    pub(crate) fn place(&self, p: ObjectPoint) -> DVec3 {
        let (projector, p_view) = (&self.light.projector, view_point(&self.view_from_object, p));
        if projector.projection.is_perspective() {
            return p_view.0 / projector.far;
        }
        let p = clip_from_view(projector, p_view);
        let half = 0.5 * f64::from(self.light.map.size);
        DVec3::new((1.0 + p.x) * half, (1.0 - p.y) * half, projector.depths.depth(p.distance))
    }

    /// The plane through three [places](Self::place), as [`Rays`] has it; zero if there is none.
    pub(crate) fn plane(&self, [a, b, c]: [DVec3; 3]) -> [f32; 3] {
        let normal = (b - a).cross(c - a);
        let plane = if self.light.projector.projection.is_perspective() {
            normal / normal.dot(a)
        } else {
            DVec3::new(-normal.x / normal.z, -normal.y / normal.z, 0.0)
        };
        let plane = plane.as_vec3();
        if plane.is_finite() { plane.to_array() } else { [0.0; 3] }
    }
}
