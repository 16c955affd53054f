//! Finds the target of the pointer: immediately in a light scene, beside the window's thread in a heavy one, so that
//! neither the pointer nor the pictures wait for a walk through a million triangles.

use eframe::egui;
use glam::{DVec2, DVec3};

use super::keyboard_probe::{ProbeStep, center_of, pixel_of};
use crate::figure::Depth;
use crate::gui::kit::frames;
use crate::progress::{Progress, at_once, pause};
use crate::views::depth::{self, DepthReading};
use crate::views::{Probe, Request, View, pick};
use camera_lab_desk::background::memo::MAX_WAIT;
use camera_lab_desk::{Latest, is_heavy};

/// Distance within which the pointer catches a vertex, in points.
pub(in crate::gui::views) const REACH: f32 = 7.0;

/// A query about a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::gui::views) enum PickQuery {
    /// The probe at a place (pixels), within reach (pixels).
    Under { pointer: DVec2, reach: f64 },
    /// The point of a probe: for a pixel the first point of the scene behind it, with its depth in the buffer.
    At(Probe),
    /// The new place of the probe after a key.
    Step(ProbeStep),
    /// The object, and the triangle of the image, at a place (pixels), if they are wanted.
    Click { pointer: DVec2, object: bool, triangle: bool },
}

/// A pick, with every input of its answer.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::gui::views) struct PickRequest {
    pub(in crate::gui::views) request: Request,
    pub(in crate::gui::views) what: PickQuery,
}

impl PickRequest {
    /// True if the result of the other query is better than none, because the pointer has moved only a little.
    fn is_near(&self, other: &Self) -> bool {
        match (self.what, other.what) {
            (PickQuery::Under { pointer, reach }, PickQuery::Under { pointer: there, .. }) => {
                pointer.distance(there) <= reach && self.request == other.request
            }
            _ => false,
        }
    }

    pub(in crate::gui::views) fn is_heavy(&self) -> bool {
        is_heavy(&self.request.scene)
    }

    async fn find(&self) -> PickResult {
        match self.what {
            PickQuery::Under { pointer, reach } => {
                PickResult { probe: probe_at(&self.request, pointer, reach), ..PickResult::default() }
            }
            PickQuery::At(probe) => PickResult {
                probe: None,
                depths: depths(probe, &self.request),
                point: Some(pick::point_of(&self.request, probe)),
                ..PickResult::default()
            },
            PickQuery::Step(step) => PickResult { probe: step.taken(&self.request), ..PickResult::default() },
            PickQuery::Click { pointer, object, triangle } => {
                let object = object.then(|| pick::object(&self.request, pointer)).flatten();
                pause().await;
                let triangle = triangle.then(|| pick::triangle_in_image(&self.request, pointer)).flatten();
                PickResult { object, triangle, ..PickResult::default() }
            }
        }
    }
}

/// The result of a query.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::gui::views) struct PickResult {
    pub(in crate::gui::views) probe: Option<Probe>,
    pub(in crate::gui::views) depths: Option<Depths>,
    /// The point of the world that the probe marks.
    pub(in crate::gui::views) point: Option<DVec3>,
    /// The name of the figure's object.
    pub(in crate::gui::views) object: Option<String>,
    /// The object of the scene, and the index in its mesh.
    pub(in crate::gui::views) triangle: Option<(usize, u32)>,
}

/// The content of the depth buffer at a pixel, if any.
pub(in crate::gui::views) type Depths = Option<DepthReading>;

/// The target at `pointer` (pixels) in a picture: a vertex within `reach` pixels, or a pixel of the image.
fn probe_at(request: &Request, pointer: DVec2, reach: f64) -> Option<Probe> {
    // A pixel of the depth buffer holds the depth of a face, not of a vertex behind or beside it.
    let shows_depths = request.view == View::Image && request.shot.look.reveal.depth != Depth::Off;
    let vertex = if shows_depths { None } else { pick::vertex(request, pointer, reach) };
    vertex.map(Probe::Point).or_else(|| {
        let point = pick::window_point_in_image(request, pointer).filter(|_| request.view == View::Image)?;
        let pixel = pixel_of(request.shot.look.image, &request.camera, point);
        let window = center_of(request.shot.look.image, &request.camera, pixel);
        // A pixel of another camera isn't one of the figure's own, but both see the point that it shows.
        let beside = request.projector.is_some();
        let hit = || pick::hit_of(request, window);
        if beside { hit().map(Probe::Point) } else { Some(Probe::Window(window)) }
    })
}

/// The content of the depth buffer under the probe. `None` if the image doesn't show depths.
fn depths(probe: Probe, request: &Request) -> Option<Depths> {
    match probe {
        Probe::Window(w) if request.shot.look.reveal.depth != Depth::Off => Some(depth::reading(request, w)),
        Probe::Window(_) | Probe::Point(_) => None,
    }
}

/// Answers one pick after the other. One that hasn't been started is dropped when the next comes.
pub(in crate::gui::views) struct Picker {
    found: Latest<PickRequest, PickResult>,
}

impl Default for Picker {
    fn default() -> Self {
        Self { found: Latest::new("pointer", || async |pick: &PickRequest, _: &Progress| pick.find().await) }
    }
}

impl Picker {
    /// The result. During the search, the last one nearby. Requests a frame of `ctx` when it's found.
    pub(in crate::gui::views) fn ask(&mut self, ctx: &egui::Context, pick: PickRequest) -> PickResult {
        if let Some(found) = self.found(ctx, &pick) {
            return found;
        }
        let near = self.found.newest().filter(|(last, _)| last.is_near(&pick));
        near.map_or_else(PickResult::default, |(_, found)| found.clone())
    }

    /// True while an answer may still come.
    pub(in crate::gui::views) fn is_waiting(&self) -> bool {
        self.found.waiting().is_some()
    }

    /// The result. `None` during the search.
    pub(in crate::gui::views) fn found(&mut self, ctx: &egui::Context, pick: &PickRequest) -> Option<PickResult> {
        if !pick.is_heavy() {
            return Some(at_once(pick.find()));
        }
        self.found.ask(&frames(ctx), pick.clone());
        self.found.poll(MAX_WAIT);
        self.found.newest().filter(|(last, _)| *last == pick).map(|(_, found)| found.clone())
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use std::time::Duration;

    use super::*;
    use crate::appearance::Style;
    use crate::camera::Camera;
    use crate::clock;
    use crate::figure::Figure;
    use crate::scene::{ObjectSpec, Preset, SceneSpec, Shape, build, no_files};
    use crate::views::{SharedScene, Size};
    use camera_lab_words::{Lang, pictures};

    fn pick(segments: u32, pointer: DVec2) -> PickRequest {
        let ball = ObjectSpec::new("ball", Shape::Sphere).with_segments(segments);
        let spec = SceneSpec { preset: Preset::Empty, objects: vec![ball], lights: Vec::new() };
        let scene = SharedScene::new(build(&spec, &Style::default(), &mut no_files).unwrap());
        let figure = Figure::default();
        let camera = Camera::new(&figure.camera).unwrap();
        let size = Size { width: 400, height: 300, scale: 1.0 };
        let request = Request::of(&figure, View::Image, &camera, &scene, pictures::labels(Lang::En), size);
        PickRequest { request, what: PickQuery::Under { pointer, reach: 7.0 } }
    }

    #[test]
    fn a_heavy_scene_gives_the_same_answer_a_little_later() {
        let ctx = egui::Context::default();
        let mut picker = Picker::default();
        let light = pick(16, DVec2::new(200.0, 150.0));
        assert!(!light.is_heavy());
        assert_eq!(picker.ask(&ctx, light.clone()), at_once(light.find()));
        assert!(picker.found.waiting().is_none(), "at once");
        let heavy = pick(256, DVec2::new(200.0, 150.0));
        assert!(heavy.is_heavy());
        let wanted = at_once(heavy.find());
        assert!(wanted.probe.is_some());
        let start = clock::now();
        while picker.ask(&ctx, heavy.clone()) != wanted {
            assert!(clock::now() - start < Duration::from_secs(60));
        }
        // Until the next result, the last one nearby is shown, but not one of another camera.
        let what = PickQuery::Under { pointer: DVec2::new(201.0, 150.0), reach: 7.0 };
        let beside = PickRequest { what, ..heavy.clone() };
        assert!(picker.ask(&ctx, beside).probe.is_some());
        let near = crate::camera::Parameters { near: 2.0, ..*heavy.request.camera.parameters() };
        let other = PickRequest { request: Request { camera: Camera::new(&near).unwrap(), ..heavy.request }, ..heavy };
        assert!(!other.is_near(picker.found.newest().unwrap().0));
    }
}
