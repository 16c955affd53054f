//! The view volume on its way to the canonical one: the picture of the canonical volume, taken back by some of the
//! steps.
//!
//! The scene that moves is the canonical picture's own, so the last of the pictures is the canonical picture by
//! construction. z always points towards the viewer in the picture. If a step makes the space left-handed, the axis
//! turns around.

use std::borrow::Cow;

use glam::{DMat4, DVec3, DVec4};

use crate::appearance::MarkShape;
use crate::camera::{Camera, Factor};
use crate::figure::Observer;
use crate::geometry::Aabb;
use crate::pipeline::{Frame, Scenes};

use super::canonical_box::CanonicalBox;
use crate::views::image::light_view;
use crate::views::observer::enclosing;
use crate::views::pixels::PixelRect;
use crate::views::reveal::probe;
use crate::views::screen::Screen;
use crate::views::timed_pipeline::TimedPipeline;
use crate::views::words::legend::{LegendRow, LegendText};
use crate::views::world::gizmos;
use crate::views::world::gizmos::{AnnotationBuilder, SMALL_TYPE};
use crate::views::{Normalizing, Palette, Request, canonical};

/// The steps of a camera, and the position of a picture on them.
struct Way {
    factors: Vec<Factor>,
    /// The current step.
    step: usize,
    /// The completed share of it, below 1.
    share: f64,
}

impl Way {
    /// `None` if the way is at its end, or the camera has no such steps.
    fn of(request: &Request) -> Option<Self> {
        let Normalizing { decomposition, time } = request.normalizing()?;
        let factors = request.camera.decomposed(decomposition)?;
        let end = factors.len() as f64;
        if time.is_nan() || time >= end {
            return None;
        }
        let time = time.max(0.0);
        #[expect(clippy::cast_possible_truncation, reason = "0 … the number of steps")]
        let step = time.floor() as usize;
        Some(Self { factors, step, share: time - time.floor() })
    }

    fn before(&self, step: usize) -> bool {
        step > 0 && self.factors[step - 1].left_handed
    }

    fn whole(&self, step: usize) -> DMat4 {
        self.factors[step].displayed(self.before(step))
    }

    fn part(&self) -> DMat4 {
        self.factors[self.step].part(self.before(self.step), self.share)
    }

    /// From the canonical display space back to the current position of the way.
    fn back_from_canonical(&self) -> DMat4 {
        let undone = |matrix: DMat4, step: usize| matrix * self.whole(step).inverse();
        (self.step..self.factors.len()).fold(self.part(), undone)
    }

    /// The map from the world to the state after this number of whole steps, as displayed.
    fn forward_from_world(&self, steps: usize) -> DMat4 {
        (0..steps).fold(DMat4::IDENTITY, |matrix, step| self.whole(step) * matrix)
    }

    /// From the world to the current position of the way, as displayed.
    fn now(&self) -> DMat4 {
        self.part() * self.forward_from_world(self.step)
    }

    /// The legend with the current step, or the last whole one, and the present orientation of the axes.
    fn said(&self, request: &Request, palette: Palette) -> Vec<LegendRow> {
        let labels = request.labels;
        let shown = if self.share > 0.0 { Some(self.step) } else { self.step.checked_sub(1) };
        let title = shown.map_or(labels.world, |step| labels.step(self.factors[step].step));
        let left_handed = self.z_axis() < 0.0;
        let turns = self.share > 0.0 && self.before(self.step) != self.factors[self.step].left_handed;
        let handedness = if left_handed { labels.left_handed } else { labels.right_handed };
        let color = if turns || (self.share == 0.0 && shown.is_some_and(|step| self.before(step) != left_handed)) {
            palette.cut
        } else {
            palette.soft
        };
        vec![
            LegendRow::Title(LegendText::new("step", title), palette.ink),
            LegendRow::Title(LegendText::new("handedness", handedness), color),
        ]
    }

    /// The displayed z axis, while it turns around: 1 towards the viewer, −1 away.
    fn z_axis(&self) -> f64 {
        let side = |left_handed: bool| if left_handed { -1.0 } else { 1.0 };
        let (before, after) = (side(self.before(self.step)), side(self.factors[self.step].left_handed));
        before + (after - before) * self.share
    }
}

fn mapped(matrix: &DMat4, p: DVec3) -> Option<DVec3> {
    let q: DVec4 = *matrix * p.extend(1.0);
    (q.w > 0.0).then(|| q.truncate() / q.w).filter(|p| p.is_finite())
}

/// Greatest distance of drawn points from the middle of the volume, relative to its corners.
const FARTHEST: f64 = 4.0;

/// Length of the axes relative to the volume.
const AXIS: f64 = 0.45;

/// The required content of the picture after a number of whole steps: the volume, and the origin with its axes if
/// that's near enough to be visible with it.
fn extent(way: &Way, camera: &Camera, steps: usize) -> Option<Aabb> {
    const FAR_AWAY: f64 = 8.0;
    let matrix = way.forward_from_world(steps);
    let volume = Aabb::around(camera.volume_corners().into_iter().filter_map(|p| mapped(&matrix, p)))?;
    let axes = Aabb { min: DVec3::ZERO, max: DVec3::splat(AXIS * volume.radius()) };
    let with_axes = volume.union(axes);
    Some(if with_axes.radius() <= FAR_AWAY * volume.radius() { with_axes } else { volume })
}

/// The radius of the volume after a number of whole steps.
fn radius(way: &Way, camera: &Camera, steps: usize) -> Option<f64> {
    let matrix = way.forward_from_world(steps);
    Aabb::around(camera.volume_corners().into_iter().filter_map(|p| mapped(&matrix, p))).map(|volume| volume.radius())
}

/// The observer, which looks like that of the canonical picture and moves evenly from one step's extent to the next
/// one's.
fn observer(request: &Request, way: &Way) -> Option<Observer> {
    let end = canonical::observer_of(request);
    let before = extent(way, &request.camera, way.step)?;
    let around = |bounds: Aabb| enclosing(&bounds.corners(), end, request.size);
    let last = way.step + 1 == way.factors.len();
    let after = if last { end } else { around(extent(way, &request.camera, way.step + 1)?) };
    Some(between(around(before), after, way.share))
}

/// An observer between two that look in the same direction. Distances grow by equal factors, and places go along with
/// them.
fn between(a: Observer, b: Observer, share: f64) -> Observer {
    let ratio = b.distance / a.distance;
    let distance = a.distance * ratio.powf(share);
    // Along with the distance, so that points far from the focal point don't leave the picture.
    let along = if (ratio - 1.0).abs() < 1e-9 { share } else { (distance - a.distance) / (b.distance - a.distance) };
    Observer { distance, target: a.target.lerp(b.target, along), ..b }
}

/// Draws the canonical volume, or a state on the way to it.
pub(in crate::views) fn frame_of(request: &Request, pipeline: &mut TimedPipeline) -> Frame {
    let on_the_way = Way::of(request).and_then(|way| moved(request, &way, pipeline));
    on_the_way.unwrap_or_else(|| canonical::frame_of(request, pipeline))
}

/// The picture before the end of the way.
fn moved(request: &Request, way: &Way, pipeline: &mut TimedPipeline) -> Option<Frame> {
    let palette = Palette::of(request.shot.look.style.theme);
    let target = request.size.target(palette.paper);
    let matrix = way.back_from_canonical();
    let the_box = CanonicalBox::of(request);
    let [near, far] = the_box.faces().map(|face| {
        let [a, b, c, d] = face.map(|p| mapped(&matrix, p));
        Some([a?, b?, c?, d?])
    });
    let (near, far) = (near?, far?);
    let bounds = Aabb::around(near.into_iter().chain(far))?;
    let camera = observer(request, way)?.camera(Some(bounds), request.size.aspect()).ok()?;
    let screen = Screen::new(camera, PixelRect::whole(request.size), request.size.scale);
    let mut scene = canonical::contents(request);
    scene.project(&matrix);
    let (scene, style) = gizmos::wired(Cow::Owned(scene), &request.shot.look.style);
    let mut builder = AnnotationBuilder::new(&screen);
    let last = way.step + 1 == way.factors.len();
    let before = radius(way, &request.camera, way.step)?;
    let after = if last { the_box.bounds().radius() } else { radius(way, &request.camera, way.step + 1)? };
    // Sizes grow by equal factors, like the distance of the observer.
    let reach = AXIS * before * (after / before).powf(way.share);
    axes(&mut builder, way, reach, palette);
    canonical::box_between(&mut builder, near, far, palette);
    eye(&mut builder, request, way, bounds, palette);
    let (now, reach) = (way.now(), bounds.radius());
    probe::on_the_way(&mut builder, request, palette, |p| {
        mapped(&now, p).filter(|p| p.distance(bounds.center()) <= FARTHEST * reach)
    });
    let place = |p| screen.place(mapped(&matrix, canonical::shown(request, &the_box, p)?)?);
    let lights = light_view::lights(request, &request.scene);
    let scenes = Scenes::new(&scene, &builder.gear).with_fineness(screen.fineness(request, place));
    let scenes = light_view::shadowed(scenes, request, &lights);
    let drawn = pipeline.frame(request, scenes, screen.camera(), target, &style, |_, _| {});
    Some(canonical::settled(drawn, request, way.said(request, palette), palette))
}

fn axes(builder: &mut AnnotationBuilder, way: &Way, reach: f64, palette: Palette) {
    let z = way.z_axis();
    let axes = [(0, DVec3::X, "x"), (1, DVec3::Y, "y"), (2, DVec3::Z * z, "z")];
    for ((k, axis, name), color) in axes.into_iter().zip(palette.axes) {
        if axis.length() > 0.1 {
            builder.axis(k, DVec3::ZERO, axis * reach, (color, 1.8), name);
        }
    }
}

/// C, until it's too far away, because a division sends it to infinity.
fn eye(builder: &mut AnnotationBuilder, request: &Request, way: &Way, bounds: Aabb, palette: Palette) {
    let Some(p) = mapped(&way.now(), request.camera.position()) else { return };
    if p.distance(bounds.center()) <= FARTHEST * bounds.radius() {
        builder.mark(p, MarkShape::Disc, 4.0, palette.body_edge);
        builder.text(p, "C", glam::DVec2::NEG_Y, SMALL_TYPE, palette.ink);
    }
}
