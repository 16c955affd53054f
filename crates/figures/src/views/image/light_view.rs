//! The view of a light: its picture in the image, its volume in the world, and the depths to compare at a point.

use std::borrow::Cow;

use glam::{DVec2, DVec3};

use crate::appearance::Dash;
use crate::camera::{Camera, ImageSize, Projection, Viewport};
use crate::drawing::Drawing;
use crate::figure::{Depth, Reveal, ShadowReveal};
use crate::pipeline::{Scenes, light_cameras};
use crate::scene::{Light, Scene};
use crate::views::interact::hits::first_crossing;
use crate::views::pixels::PixelRect;
use crate::views::reveal::triangle_overlay::pixel_run;
use crate::views::words::legend::{LegendRow, LegendText};
use crate::views::world::gizmos::AnnotationBuilder;
use crate::views::{Palette, Request, ShadowTruth};

/// The image as the first light that casts shadows sees it, if the figure reveals that; `None` otherwise.
pub(in crate::views) fn of_light(request: &Request) -> Option<Request> {
    if request.shot.look.reveal.shadows != Some(ShadowReveal::Map) {
        return None;
    }
    let light = first(&request.scene)?;
    let camera = main_camera(&request.scene, light)?;
    let side = light.shadows.held().map;
    let image = ImageSize { width: side, height: side };
    let seen = request.clone().with_shot(|shot| {
        shot.look.image = image;
        shot.look.viewport = Viewport::whole(image);
        shot.look.reveal = Reveal { depth: Depth::Linear, ..Reveal::default() };
    });
    Some(Request { camera, ..seen })
}

/// The lights of a scene as the figure reveals their shadows, without bias.
pub(in crate::views) fn lights<'a>(request: &Request, scene: &'a Scene) -> Cow<'a, [Light]> {
    let mut lights = Cow::Borrowed(scene.lights.as_slice());
    if request.shot.look.reveal.shadows == Some(ShadowReveal::Acne) {
        lights.to_mut().iter_mut().for_each(|light| light.shadows.bias = 0.0);
    }
    lights
}

/// Projected things in the shadows of the world. They're displayed without light, so they need no lights unless there
/// are shadows. `lights` are those of the world as the figure reveals them.
pub(in crate::views) fn shadowed<'a>(scenes: Scenes<'a>, request: &'a Request, lights: &'a [Light]) -> Scenes<'a> {
    if lights.iter().any(|light| light.shadows.cast) {
        scenes.in_shadows_of(&request.scene).lit_by(lights)
    } else {
        scenes
    }
}

/// The legend of shadows without bias, and of shadows compared with rays.
pub(in crate::views) fn rows(request: &Request, palette: Palette) -> Option<LegendRow> {
    let labels = request.labels;
    match (request.shot.look.reveal.shadows?, request.shadow_truth.as_deref()) {
        (ShadowReveal::Acne, _) => {
            let title = LegendText::new("acne", labels.acne);
            first(&request.scene).map(|_| LegendRow::Title(title, palette.ink))
        }
        (ShadowReveal::Truth, Some(truth @ ShadowTruth::Found { of, .. })) => {
            let wrong = truth.wrong();
            let share = 100.0 * wrong as f64 / (*of).max(1) as f64;
            let share = labels.mark.number(share, 2);
            let text = format!("{} {wrong} {} {of} pixels, {share} %", labels.map_wrong, labels.out_of);
            let text = LegendText::new("truth", text);
            Some(if wrong > 0 {
                LegendRow::Warning(palette.differing, text)
            } else {
                LegendRow::Title(text, palette.ink)
            })
        }
        (ShadowReveal::Truth, Some(ShadowTruth::TooMuch)) => {
            Some(LegendRow::Title(LegendText::new("truth", labels.too_much_for_rays), palette.ink))
        }
        (ShadowReveal::Map | ShadowReveal::Truth, _) => None,
    }
}

/// Marks the wrong pixels, in the frame of the image.
pub(in crate::views) fn mark_wrong(drawing: &mut Drawing, frame: PixelRect, request: &Request, palette: Palette) {
    if let Some(ShadowTruth::Found { rows, .. }) = request.shadow_truth.as_deref() {
        let (image, fill) = (request.shot.look.image, palette.differing);
        // Below the legend.
        let areas = rows.iter().map(|row| pixel_run(frame, image, *row, 0.0, fill));
        drawing.areas.splice(0..0, areas);
    }
}

/// The volume of the light whose shadows the figure reveals, and the lamp, faint.
pub(in crate::views) fn in_world(builder: &mut AnnotationBuilder, request: &Request, palette: Palette) {
    if request.shot.look.reveal.shadows.is_none() {
        return;
    }
    let Some(light) = first(&request.scene) else { return };
    let Some(camera) = main_camera(&request.scene, light) else { return };
    let corners = camera.volume_corners();
    let color = palette.soft;
    for first in [0, 4] {
        let face = [0, 1, 2, 3].map(|k| corners[first + k]);
        builder.closed(&face, color, 1.0, Dash::Dashed);
    }
    for k in 0..4 {
        let start = if camera.projection() == Projection::Perspective { camera.position() } else { corners[k] };
        builder.line(vec![start, corners[4 + k]], color, 1.0, Dash::Dashed);
    }
}

fn first(scene: &Scene) -> Option<&Light> {
    scene.lights.iter().find(|light| light.shadows.cast)
}

/// The camera of a light. If it's a lamp with six, the one that looks towards the middle of the scene.
fn main_camera(scene: &Scene, light: &Light) -> Option<Camera> {
    let cameras = light_cameras(scene, light)?;
    let middle = scene.bounds()?.center() - light.vector;
    let towards = |camera: &Camera| camera.direction_of_projection().dot(middle);
    match cameras.as_slice() {
        [one] => Some(one.clone()),
        _ => cameras.into_iter().max_by(|a, b| towards(a).total_cmp(&towards(b))),
    }
}

/// The depths to compare for the shadow at a point.
#[derive(Clone, Debug, PartialEq)]
pub struct ShadowAt {
    /// The light's place among those of the figure.
    pub light: usize,
    /// The distance of the point from the light's plane of projection, in scene units.
    pub own: f64,
    /// The distance of the nearest thing in the middle of the texel; `None` if there's nothing.
    pub nearest: Option<f64>,
    /// The texel: column and row, from the top left.
    pub texel: [u32; 2],
    /// The side of the map in texels.
    pub size: u32,
    /// The distance by which a point may be deeper than the map and still be lit, in scene units.
    pub allowed: f64,
}

impl ShadowAt {
    /// True if the light sees something nearer.
    pub fn is_hidden(&self) -> bool {
        self.nearest.is_some_and(|nearest| self.own > nearest + self.allowed)
    }
}

/// The depths that each light with shadows compares at a point (world).
pub fn shadows_at(scene: &Scene, p: DVec3) -> Vec<ShadowAt> {
    let casting = scene.lights.iter().enumerate().filter(|(_, light)| light.shadows.cast);
    casting.filter_map(|(index, light)| at(scene, index, light, p)).collect()
}

fn at(scene: &Scene, index: usize, light: &Light, p: DVec3) -> Option<ShadowAt> {
    let shadows = light.shadows.held();
    let size = f64::from(shadows.map);
    light_cameras(scene, light)?.iter().find_map(|camera| {
        let view = camera.view_point(p);
        let own = -view.z;
        let perspective = camera.projection() == Projection::Perspective;
        let (window, basis, near, far) = (camera.window(), camera.basis(), camera.near(), camera.far());
        let scale = if perspective { near / own } else { 1.0 };
        let on_window = DVec2::new(view.x, view.y) * scale;
        let place = DVec2::new(
            (on_window.x - window.left) / window.width() * size,
            (window.top - on_window.y) / window.height() * size,
        );
        let texel = place.floor();
        if !(own > 0.0 && texel.min_element() >= 0.0 && texel.max_element() < size) {
            return None;
        }
        // The ray through the middle of the texel, from the front plane to the back plane.
        let middle = (texel + 0.5) / size;
        let x = window.left + middle.x * window.width();
        let y = window.top - middle.y * window.height();
        let on_plane = |distance: f64| {
            let scale = if perspective { distance / near } else { 1.0 };
            camera.position() + (basis.u * x + basis.v * y) * scale - basis.n * distance
        };
        let nearest = first_crossing(scene, on_plane(near), on_plane(far)).map(|t| near + t * (far - near));
        let length = window.width() / size / scale;
        #[expect(clippy::cast_possible_truncation, reason = "within the map")]
        let texel = [texel.x as u32, texel.y as u32];
        // A face seen at 45° sinks by a texel's length within a texel.
        let allowed = 1.5 * shadows.bias * length;
        Some(ShadowAt { light: index, own, nearest, texel, size: shadows.map, allowed })
    })
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

    use super::*;
    use crate::appearance::Style;
    use crate::scene::{ObjectSpec, Preset, SceneSpec, Shadows, Shape, build, no_files};

    #[test]
    fn a_point_behind_another_is_hidden_from_the_light_and_that_one_is_not() {
        let cube = |y: f64| ObjectSpec::new(format!("cube {y}"), Shape::Box).at(0.0, y, 0.0);
        for light in [Light::directional(DVec3::NEG_Y), Light::point(DVec3::Y * 20.0)] {
            let lights = vec![Light::point(DVec3::X), light.with_shadows(Shadows::CAST)];
            let spec = SceneSpec { preset: Preset::Empty, objects: vec![cube(0.0), cube(5.0)], lights };
            let scene = build(&spec, &Style::default(), &mut no_files).unwrap();
            let of = |y: f64| shadows_at(&scene, DVec3::new(0.3, y, 0.2)).pop().unwrap();
            let [above, below] = [of(6.0), of(1.0)];
            assert!(!above.is_hidden() && below.is_hidden() && (above.light, above.size) == (1, 1024));
            assert!((above.own - above.nearest.unwrap()).abs() < 1e-9, "{above:?}");
            assert!((below.own - below.nearest.unwrap() - 5.0).abs() < 1e-9, "{below:?}");
        }
    }
}
