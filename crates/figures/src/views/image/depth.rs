//! The image as depths: the content of the depth buffer, as grey levels and as numbers.

use glam::DVec2;

use crate::appearance::{Rgba, Samples, Shading, Style, Visibility};
use crate::camera::{Camera, Projected, Projection};
use crate::drawing::{Base, Drawing, Surface};
use crate::figure::Depth;
use crate::pipeline::depths::DepthScale;
use crate::pipeline::divide_before_clip::divided_first;
use crate::pipeline::{Frame, Options, Pipeline, Reason, Stage, Target};
use crate::scene::Scene;

use crate::views::interact::hits;
use crate::views::words::legend::{LegendRow, LegendText};
use crate::views::{Palette, Request};

/// The numbers of one pixel of the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthReading {
    /// Z, in the depth buffer, `[0]` Eq. (5.25).
    pub z: f64,
    /// z_n, in the convention of the request.
    pub ndc_z: f64,
    /// The distance from the eye along DOP, −z_c, in scene units, between F and B.
    pub distance: f64,
}

/// The content of the depth buffer on the ray through a point (x_p, y_p) of the view window; `None` if no opaque face
/// is drawn there.
pub fn reading(request: &Request, point: DVec2) -> Option<DepthReading> {
    let camera = &request.camera;
    let ray = camera.ray_through_window(point);
    let per_depth = ray.direction / ray.direction.dot(camera.direction_of_projection());
    let (from, to) = (ray.origin + per_depth * camera.near(), ray.origin + per_depth * camera.far());
    // Faces divided first have no depth where they're wrong, because they're drawn as glass.
    let right = request.shot.look.reveal.divide_first.then(|| divided_first(&request.scene, camera, 1.0).right);
    let hit = hits::first_opaque(right.as_ref().unwrap_or(&request.scene), from, to)?;
    let space = camera.possible_clip_space(request.shot.ndc);
    let stations = space.stations(hit, request.shot.look.image, &request.shot.look.viewport);
    let Projected { ndc, viewport, .. } = stations.projected?;
    Some(DepthReading { z: viewport.z, ndc_z: ndc.z, distance: -stations.view.z })
}

/// The inputs of the depth test of a triangle: drawings of faces without colours, m × n pixels, one sample each.
#[derive(Clone, Debug)]
pub struct DepthTest {
    /// The triangle alone.
    pub alone: Drawing,
    /// The faces drawn before it.
    pub before: Drawing,
    scale: DepthScale,
    greys: Greys,
}

impl DepthTest {
    /// The inputs for a triangle (object of the scene, index in its mesh) in the image; `None` if its object isn't
    /// drawn.
    pub fn of(request: &Request, object: usize, triangle: u32) -> Option<Self> {
        let plain = request.clone().with_shot(|shot| shot.look.reveal.depth = Depth::Stored);
        let mut scene = Scene::clone(&request.scene);
        only(&mut scene);
        // As it's stored, not resolved over the visible depths.
        let options = Options { followed: Some((object, triangle)), depth_of_volume: true, ..Options::default() };
        let image = request.shot.look.image;
        let target = Target { width: image.width, height: image.height, scale: 1.0, background: Rgba::rgb(0, 0, 0) };
        let style = Style { antialias: Samples::One, ..style(&request.shot.look.style) };
        let frame = Pipeline::default().frame(&scene, &request.camera, target, &style, options);
        let followed = frame.followed?;
        let mut drawing = Drawing { strokes: Vec::new(), marks: Vec::new(), labels: Vec::new(), ..frame.drawing };
        drawing.surfaces.iter_mut().for_each(|surface| {
            surface.depth_test = true;
            // Only their depths matter.
            surface.repaint(Base::Solid(Rgba::rgb(0, 0, 0)));
        });
        let own = drawing.surfaces.get(followed.surface)?;
        let is_translucent = own.translucent;
        let triangles = followed.triangles.iter().filter_map(|i| own.triangles.get(*i).copied()).collect();
        let alone = Surface { triangles, translucent: false, ..own.clone() };
        let mut before = drawing.clone();
        if is_translucent {
            // It comes after all opaque faces.
            before.surfaces.retain(|surface| !surface.translucent);
        } else {
            before.surfaces.truncate(followed.surface + 1);
            before.surfaces.retain(|surface| !surface.translucent);
            if let (Some(last), Some(first)) = (before.surfaces.last_mut(), followed.triangles.first()) {
                last.triangles.truncate(*first);
            }
        }
        let alone = Drawing { surfaces: vec![alone], ..drawing };
        Some(Self { alone, before, scale: frame.depths, greys: Greys::of(&plain)? })
    }

    /// Z (5.25) of a depth of these drawings.
    pub fn z(&self, depth: f32) -> f64 {
        self.greys.level(self.scale.in_scale(&self.greys.volume, f64::from(depth)))
    }
}

/// The style in which faces leave their depth. It needs faces and a depth buffer, but no colours.
pub(in crate::views) fn style(style: &Style) -> Style {
    Style { shading: Shading::Flat, visibility: Visibility::DepthBuffer, ..*style }
}

/// Removes everything from a scene except for its faces, and also removes their light.
pub(in crate::views) fn only(scene: &mut Scene) {
    scene.lights.clear();
    scene.lines.clear();
    scene.marks.clear();
    scene.texts.clear();
    scene.objects.iter_mut().for_each(|object| (object.edges, object.outline) = (None, None));
}

/// Depths, as grey levels of 0 … 1.
#[derive(Clone, Copy, Debug)]
pub(in crate::views) struct Greys {
    /// F / B; 1 in parallel projection, where everything is affine.
    near_over_far: f64,
    /// The meaning of a depth of 1 at F and 0 at B.
    volume: DepthScale,
    /// Z at F and at B; `None` means distances.
    range: Option<[f64; 2]>,
}

impl Greys {
    /// `None` if the image shows colours.
    pub(in crate::views) fn of(request: &Request) -> Option<Self> {
        let v = request.shot.look.viewport;
        let range = match request.shot.look.reveal.depth {
            Depth::Off => return None,
            Depth::Stored => Some([v.depth_near, v.depth_far]),
            Depth::Linear => None,
        };
        let camera = &request.camera;
        let volume = DepthScale::of_volume(camera.projection(), camera.near(), camera.far());
        Some(Self { near_over_far: near_over_far(camera), volume, range })
    }

    /// The level for a depth, which is 1 at F and 0 at B.
    fn level(self, depth: f64) -> f64 {
        match self.range {
            Some([near, far]) => near + (far - near) * (1.0 - depth),
            // (d − F) / (B − F) for the distance d = F B / (F + depth · (B − F)).
            None => {
                let f = self.near_over_far;
                f * (1.0 - depth) / (f + depth * (1.0 - f))
            }
        }
    }

    /// Paints the faces of an image with their depths, removes everything else, and corrects the report on the stages
    /// involved.
    pub(in crate::views) fn paint(self, drawing: &mut Drawing, scale: DepthScale) {
        drawing.surfaces.retain(|surface| !surface.translucent);
        for surface in &mut drawing.surfaces {
            let depths = || surface.positions.iter().map(|p| scale.in_scale(&self.volume, f64::from(p[2])));
            surface.inverse_w = match self.range {
                // Z is affine in the picture, so plain interpolation is exact.
                Some(_) => Vec::new(),
                None => depths().map(|depth| self.inverse_w(depth)).collect(),
            };
            let greys = depths().map(|depth| grey(self.level(depth))).collect();
            surface.repaint(Base::Vertices(greys));
        }
        drawing.strokes.clear();
        drawing.labels.clear();
    }

    /// Corrects the report of a picture of depths. `marks` is true if the picture has any, not counting those of a
    /// stage.
    pub(in crate::views) fn report(frame: &mut Frame, marks: bool) {
        let painted = !frame.drawing.surfaces.is_empty();
        for report in &mut frame.report {
            match report.stage {
                // [`only`] removed lights and lines.
                Stage::Normals | Stage::Light if !report.ran => report.reason = Reason::DepthsShown,
                Stage::Lines if !marks => (report.ran, report.reason) = (false, Reason::DepthsShown),
                Stage::Interpolate if painted => (report.ran, report.reason) = (true, Reason::DepthsShown),
                _ => {}
            }
        }
    }

    /// F / d for a depth, which is 1 at F and 0 at B.
    #[expect(clippy::cast_possible_truncation, reason = "a ratio between 0 and 1, for the display list")]
    fn inverse_w(self, depth: f64) -> f32 {
        (self.near_over_far + depth * (1.0 - self.near_over_far)) as f32
    }

    /// The levels from F to B with their numbers, and the background. `linear` is the heading of distances.
    pub(in crate::views) fn legend(self, request: &Request, linear: &str, palette: Palette) -> Vec<LegendRow> {
        const STEPS: u32 = 40;
        let (camera, labels) = (&request.camera, request.labels);
        let (f, b) = (camera.near(), camera.far());
        let ends = self.range.unwrap_or([0.0, 1.0]);
        let level = |share: f64| ends[0] + (ends[1] - ends[0]) * share;
        let levels = (0..=STEPS).map(|i| grey(level(f64::from(i) / f64::from(STEPS)))).collect();
        // The distance of the level in the middle of the scale.
        let middle = match (self.range, camera.projection()) {
            (Some(_), Projection::Perspective) => 2.0 / (1.0 / f + 1.0 / b),
            (None, _) | (Some(_), Projection::Parallel) => f + (b - f) / 2.0,
        };
        let distances = [f, middle, b].map(|d| request.written(&[], &[d], |mark| mark.number(d, 4)));
        let [near, halfway, far] = distances;
        let distances = [format!("−z_c = {near}"), halfway, far];
        let stored = [0.0, 0.5, 1.0].map(|share| labels.mark.number(level(share), 4));
        let distances = LegendText::below_a_scale("distance", distances);
        let (title, texts) = match self.range {
            Some(_) => {
                let [near, halfway, far] = stored;
                let stored = LegendText::below_a_scale("Z", [format!("Z = {near}"), halfway, far]);
                (labels.depth_stored, vec![stored, distances])
            }
            None => (linear, vec![distances]),
        };
        vec![
            LegendRow::Title(LegendText::new("depth", title), palette.ink),
            LegendRow::Scale(levels, texts),
            LegendRow::Swatch(palette.nothing, LegendText::new("nothing", labels.nothing)),
        ]
    }
}

fn near_over_far(camera: &Camera) -> f64 {
    match camera.projection() {
        Projection::Perspective => camera.near() / camera.far(),
        Projection::Parallel => 1.0,
    }
}

/// The grey of a level, 0 black … 1 white.
fn grey(level: f64) -> Rgba {
    #[expect(clippy::cast_possible_truncation, reason = "clamped to 0 … 255 before the cast")]
    let byte = (255.0 * level).round().clamp(0.0, 255.0) as u8;
    Rgba::rgb(byte, byte, byte)
}
