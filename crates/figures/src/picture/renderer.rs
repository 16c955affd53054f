//! Makes pictures from requests: first the drawing of the view, then its pixels.

mod several;

use std::ops::Range;
use std::sync::Arc;
use std::time::Duration;

use tiny_skia::{Pixmap, PixmapPaint, Transform};

use super::compared::{Differences, counted_requests, differing_share, joined};
use super::cost::{Costs, FoundCosts};
use super::plate::Plates;
use super::shadow_truth::FoundShadows;
use super::{FollowedTriangle, Pixels, RenderReport};
use crate::appearance::Texture;
use crate::drawing::Surface;
use crate::pipeline::{Frame, ShadowMaps};
use crate::progress::{Progress, at_once};
use crate::raster::Rasterizer;
use crate::views::{self, LabelPlace, Request, Side, Size, TimedPipeline, View, overlay};

/// Makes pictures. Keeps its buffers, and the image on the view window, from one to the next.
///
/// *Guarantees*: equal requests give equal pixels, regardless of earlier pictures.
#[derive(Debug)]
pub struct Renderer {
    pipeline: TimedPipeline,
    /// The same for all pictures of a scene.
    shadow_maps: ShadowMaps,
    rasterizer: Rasterizer,
    on_window: Option<(Request, Arc<Texture>)>,
    triangle: FollowedTriangle,
    shadows: FoundShadows,
    costs: FoundCosts,
    /// The images whose differing pixels were counted last, and their share.
    counted: Option<([Request; 2], f64)>,
    /// For pictures made at the same time as its own.
    beside: Vec<Self>,
    clock: Option<fn() -> Duration>,
    progress: Progress,
}

impl Default for Renderer {
    fn default() -> Self {
        Self::sharing(&ShadowMaps::default())
    }
}

impl Renderer {
    /// A renderer that shares these shadow maps with others.
    pub fn sharing(shadow_maps: &ShadowMaps) -> Self {
        let mut pipeline = TimedPipeline::default();
        pipeline.stages.share_shadows(shadow_maps);
        Self {
            pipeline,
            shadow_maps: shadow_maps.clone(),
            rasterizer: Rasterizer::default(),
            on_window: None,
            triangle: FollowedTriangle::default(),
            shadows: FoundShadows::default(),
            costs: FoundCosts::default(),
            counted: None,
            beside: Vec::new(),
            clock: None,
            progress: Progress::default(),
        }
    }

    /// Times every stage from now on, with a clock that gives the time since some fixed moment; `None` stops timing.
    pub fn measure(&mut self, clock: Option<fn() -> Duration>) {
        self.clock = clock;
    }

    /// Reports the progress of pictures from now on. If that's cancelled, there's no picture.
    pub fn watch(&mut self, progress: &Progress) {
        self.progress = progress.clone();
        self.rasterizer.watch(progress);
        self.pipeline.stages.watch(progress);
    }

    /// Forgets cached pictures and shadow maps. The next one is made from scratch, in the same memory.
    pub fn forget(&mut self) {
        self.on_window = None;
        self.pipeline.stages.forget();
        self.beside.iter_mut().for_each(Self::forget);
    }

    /// A picture. `None` if a side is 0, there isn't enough memory, or it was cancelled.
    pub fn pixels(&mut self, request: &Request) -> Option<Pixels> {
        let mut picture = Pixels::default();
        at_once(self.pixels_into(request, &mut picture)).map(|_| picture)
    }

    /// Makes a picture like [`pixels`](Self::pixels) in place of another one, with a report. If the result is `None`,
    /// the other one is lost too. It pauses when [`Rasterizer::paint_into`] does. If the figure is compared, the report
    /// is that of the figure as it is, with the shortfall and the labels of either side.
    pub async fn pixels_into(&mut self, request: &Request, picture: &mut Pixels) -> Option<RenderReport> {
        let Some(sides) = request.sides() else { return self.one_into(request, picture, [0, 1]).await };
        let mut pictures = [Pixels::default(), Pixels::default()];
        let of_other = self.one_into(&sides[1].request, &mut pictures[1], [0, 2]).await?;
        let mut account = self.one_into(&sides[0].request, &mut pictures[0], [1, 2]).await?;
        account.over_budget = account.over_budget.or(of_other.over_budget);
        account.labels = labels_of([account.labels, of_other.labels], &sides);
        let Size { width, height, .. } = request.size;
        let mut whole = Pixels::from(Pixmap::new(width, height)?);
        let differences = Differences::marked(request, &pictures);
        joined(&mut whole, &sides, &pictures, differences.as_ref());
        let share = if differences.is_some() { self.share_that_differs(&sides).await } else { None };
        let over = overlay(request, &sides, &account.labels, share)?;
        account.labels.extend(LabelPlace::all(&over));
        let over = self.rasterizer.paint(&over)?;
        let mut pixmap = whole.take_pixmap()?;
        pixmap.draw_pixmap(0, 0, over.as_ref(), &PixmapPaint::default(), Transform::identity(), None);
        *picture = pixmap.into();
        Some(account)
    }

    /// The share of the image's own pixels in which its two sides differ, 0 … 1; `None` for the other views.
    pub(super) async fn share_that_differs(&mut self, sides: &[Side; 2]) -> Option<f64> {
        let requests = counted_requests(sides)?;
        if let Some((of, share)) = &self.counted
            && *of == requests
        {
            return Some(*share);
        }
        // Separate pictures, which aren't part of the progress of these.
        let mut counter = Self::sharing(&self.shadow_maps);
        let mut pictures = [Pixels::default(), Pixels::default()];
        for (request, picture) in requests.iter().zip(&mut pictures) {
            Box::pin(counter.one_into(request, picture, [0, 1])).await?;
        }
        let share = differing_share(&pictures);
        self.counted = Some((requests, share));
        Some(share)
    }

    /// A picture in which nothing is compared. `side` tells which of how many are painted for one picture.
    async fn one_into(&mut self, request: &Request, picture: &mut Pixels, side: [usize; 2]) -> Option<RenderReport> {
        let now = self.clock.unwrap_or(|| Duration::ZERO);
        let start = now();
        let (frame, on_window) = self.timed_drawing(request).await?;
        if self.progress.is_cancelled() {
            return None;
        }
        let mut pixmap = picture.take_pixmap().or_else(|| Pixmap::new(1, 1))?;
        self.rasterizer.measure(self.clock);
        let mut frame = frame;
        let drops_faces = !frame.dropped_faces.is_empty();
        let passes = 1 + usize::from(drops_faces) + usize::from(frame.before.is_some());
        let pass = |pass: usize| [side[0] * passes + pass, side[1] * passes];
        let painted = self.rasterizer.paint_pass(&frame.drawing, &mut pixmap, pass(0)).await;
        if !painted || self.progress.is_cancelled() {
            return None;
        }
        let (work, total) = (self.rasterizer.work(), now().saturating_sub(start));
        let account = match self.clock {
            Some(_) => RenderReport::of(&frame, work, on_window, total),
            None => {
                let labels = LabelPlace::all(&frame.drawing);
                RenderReport { over_budget: frame.over_budget.take(), labels, ..RenderReport::default() }
            }
        };
        let mut plates = Plates::from(frame).plates.into_iter();
        let whole = plates.next()?;
        // The report above is of the picture without the faces that a stage drops.
        if drops_faces && !self.rasterizer.paint_pass(&whole.drawing, &mut pixmap, pass(1)).await {
            return None;
        }
        for plate in plates {
            let mut part = Pixmap::new(1, 1)?;
            if !self.rasterizer.paint_pass(&plate.drawing, &mut part, pass(passes - 1)).await {
                return None;
            }
            put_columns(&part, plate.columns, &mut pixmap);
        }
        if self.progress.is_cancelled() {
            return None;
        }
        *picture = pixmap.into();
        Some(account)
    }

    /// The drawing of a picture with its plan and report, for outputs that aren't made of pixels. It's the drawing that
    /// [`pixels`](Self::pixels) paints, or that of the [`Output`](crate::pipeline::Output) in the request. `None`
    /// without enough memory for the image on the window.
    pub fn drawing(&mut self, request: &Request) -> Option<Frame> {
        at_once(self.timed_drawing(request)).map(|(frame, _)| frame)
    }

    /// The places of a picture's labels, without painting it. For a compared picture, those of both sides.
    pub fn labels(&mut self, request: &Request) -> Vec<LabelPlace> {
        let sides =
            request.sides().map_or_else(|| vec![request.clone()], |sides| sides.map(|side| side.request).into());
        let frames = sides.iter().filter_map(|side| self.drawing(side));
        frames.flat_map(|frame| LabelPlace::all(&frame.drawing)).collect()
    }

    /// The same at four times the size, where labels have places that found none in the picture.
    pub fn labels_with_room(&mut self, request: &Request) -> Vec<LabelPlace> {
        let Size { width, height, scale } = request.size;
        self.labels(&Request { size: Size { width: 4 * width, height: 4 * height, scale }, ..request.clone() })
    }

    /// The cost of each pixel of a picture. For a compared picture, that of the figure as it is. `None` without enough
    /// memory, or if it was cancelled. It pauses on the way.
    pub async fn costs(&mut self, request: &Request, progress: &Progress) -> Option<Costs> {
        let own = request.sides().map_or_else(|| request.clone(), |[own, _]| own.request);
        let plain = own.with_shot(|shot| shot.look.reveal.cost = None);
        Costs::of(self.drawing(&plain)?, progress).await
    }

    /// The plates of a picture in which nothing is compared, for a page of vectors. `None` without enough memory for
    /// the image on the window.
    pub(super) fn plates(&mut self, request: &Request) -> Option<Plates> {
        let mut plates = Plates::from(self.drawing(request)?);
        // A forced stage looks up a texture of one colour for the colour of each pixel. A page has areas of that
        // colour.
        for plate in &mut plates.plates {
            plate.drawing.surfaces.iter_mut().for_each(Surface::simplify);
        }
        Some(plates)
    }

    /// The drawing of a picture, and the time that the image on the window took, if one was drawn for it.
    async fn timed_drawing(&mut self, request: &Request) -> Option<(Frame, Option<Duration>)> {
        let (on_window, time) = match request.view {
            View::World => {
                let (texture, time) = self.image_on_window(request).await?;
                (Some(texture), time)
            }
            View::Canonical | View::Image => (None, None),
        };
        let overlay = self.triangle.overlay(request).await;
        let truth = self.shadows.of(request, &self.progress).await;
        let cost = self.costs.of(request, &self.shadow_maps, &self.progress).await;
        let followed = (overlay.is_some() || truth.is_some() || cost.is_some()).then(|| Request {
            triangle: overlay,
            shadow_truth: truth,
            cost,
            ..request.clone()
        });
        let request = followed.as_ref().unwrap_or(request);
        self.pipeline.clock = self.clock;
        Some((views::frame(request, on_window.as_ref(), &mut self.pipeline), time))
    }

    /// The image that the window of the world shows. Drawn again only if its content has changed, and an empty one if
    /// it shows none.
    async fn image_on_window(&mut self, request: &Request) -> Option<(Arc<Texture>, Option<Duration>)> {
        if !request.shows_image_on_window() {
            return Some((Arc::new(Texture::flat(1, 1, Vec::new())), None));
        }
        let image = request.image_on_window();
        if let Some((made_from, texture)) = &self.on_window
            && *made_from == image
        {
            return Some((Arc::clone(texture), None));
        }
        let now = self.clock.unwrap_or(|| Duration::ZERO);
        let start = now();
        self.rasterizer.measure(None);
        self.pipeline.clock = None;
        let frame = views::frame(&image, None, &mut self.pipeline);
        let mut pixmap = Pixmap::new(1, 1)?;
        if !self.rasterizer.paint_into(&frame.drawing, &mut pixmap).await || self.progress.is_cancelled() {
            return None;
        }
        let picture = Pixels::from(pixmap);
        let texture = Arc::new(picture.into_texture());
        self.on_window = Some((image, Arc::clone(&texture)));
        Some((texture, Some(now().saturating_sub(start))))
    }
}

/// The visible labels of two sides, in the pixels of the whole picture.
pub(super) fn labels_of(labels: [Vec<LabelPlace>; 2], sides: &[Side; 2]) -> Vec<LabelPlace> {
    let of_side = |(side, labels): (&Side, Vec<LabelPlace>)| {
        let columns = f64::from(side.columns.start)..f64::from(side.columns.end);
        let moved = labels.into_iter().map(|label| label.shifted(f64::from(side.left)));
        moved.filter(|label| columns.contains(&label.center.x)).collect::<Vec<_>>()
    };
    sides.iter().zip(labels).flat_map(of_side).collect()
}

/// Puts columns of a picture over those of another one of the same size.
fn put_columns(from: &Pixmap, columns: Range<u32>, onto: &mut Pixmap) {
    let width = 4 * onto.width() as usize;
    let columns = 4 * columns.start as usize..4 * columns.end as usize;
    let rows = onto.data_mut().chunks_exact_mut(width.max(1)).zip(from.data().chunks_exact(width.max(1)));
    rows.for_each(|(row, part)| row[columns.clone()].copy_from_slice(&part[columns.clone()]));
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use std::sync::OnceLock;
    use std::time::Instant;

    use super::*;
    use crate::appearance::Shading;
    use crate::camera::{Camera, Parameters};
    use crate::drawing::Drawing;
    use crate::figure::read::parse;
    use crate::figure::{Observer, ShadowReveal, WorldPart};
    use crate::pipeline::{Output, OverBudget, Reason, Stage};
    use crate::scene::{Scene, no_files};
    use crate::views::{Finish, SharedScene, Shot, Size, unlabelled};

    /// Three boxes that intersect, with some glass. A BSP tree splits them into more than fifty pieces.
    pub(super) fn request(view: View, visibility: &str) -> Request {
        let object = |name: &str, color: &str, rotate: &str| {
            format!(
                "[[scene.objects]]\nname = \"{name}\"\nshape = \"box\"\ncolor = \"{color}\"\nrotate = {rotate}\nscale = [2, 0.4, 2]\n"
            )
        };
        let text = format!(
            "{}{}{}[style]\nantialias = 1\nvisibility = \"{visibility}\"\n",
            object("one", "#4477aa", "[0, 0, 0]"),
            object("two", "#ee886680", "[70, 10, 0]"),
            object("three", "#228833", "[10, 0, 80]"),
        );
        let figure = parse(&text).unwrap();
        let camera = Camera::new(&figure.camera).unwrap();
        let scene = SharedScene::new(views::scene_of(&figure, &mut no_files, &Progress::default()).unwrap());
        let size = Size { width: 320, height: 240, scale: 1.0 };
        Request::of(&figure, view, &camera, &scene, unlabelled(), size)
    }

    fn with_few_pieces() -> Renderer {
        let mut renderer = Renderer::default();
        renderer.pipeline.stages.max_pieces = Some(40);
        renderer
    }

    #[test]
    fn scene_camera_or_shading_changes_rebuild_the_canonical_volume() {
        let first = request(View::Canonical, "depth-buffer");
        let mut moved = first.clone();
        moved.camera = Camera::new(&Parameters { near: 3.5, ..*first.camera.parameters() }).unwrap();
        let mut other = request(View::Canonical, "bsp");
        other.scene = SharedScene::new(Scene { lights: Vec::new(), ..Scene::clone(&first.scene) });
        let shaded = |shading| {
            let mut request = first.clone();
            Arc::make_mut(&mut request.shot).look.style.shading = shading;
            request
        };
        let mut around = first.clone();
        around.observer = Some(Observer { azimuth: 77.0, ..first.seen_from().unwrap() });
        let [wired, smooth] = [Shading::Wireframe, Shading::Gouraud].map(shaded);
        let all = [&first, &around, &moved, &moved, &other, &wired, &wired, &smooth, &first];
        let mut kept = Renderer::default();
        let mut last = Vec::new();
        for (k, request) in all.into_iter().enumerate() {
            let pixels = kept.pixels(request).unwrap();
            assert!(pixels == Renderer::default().pixels(request).unwrap(), "{k}");
            assert_eq!(pixels == *last.last().unwrap_or(&Pixels::default()), [3, 6].contains(&k), "{k}");
            last.push(pixels);
            if k == 4 {
                kept.forget();
            }
        }
    }

    #[test]
    fn pictures_of_a_scene_share_shadow_maps_whose_drawings_go_when_they_are_painted() {
        let text = "[scene]\npreset = \"house\"\n[[scene.lights]]\nkind = \"point\"\nposition = [2, 5, 3]\n\
            shadows = true\nshadow_map = 64\n";
        let figure = parse(text).unwrap();
        let camera = Camera::new(&figure.camera).unwrap();
        let scene = SharedScene::new(views::scene_of(&figure, &mut no_files, &Progress::default()).unwrap());
        let size = Size { width: 80, height: 60, scale: 1.0 };
        let of = |view| Request::of(&figure, view, &camera, &scene, unlabelled(), size);
        // Without bias the depths are the same.
        let acne = of(View::Image).with_shot(|shot| shot.look.reveal.shadows = Some(ShadowReveal::Acne));
        let requests: Vec<Request> = View::ALL.map(of).into_iter().chain([acne]).collect();
        let mut renderer = Renderer::default();
        let mut pictures = vec![Pixels::default(); requests.len()];
        at_once(renderer.all_into(&requests, &mut pictures)).unwrap();
        let mut maps: Vec<Arc<crate::drawing::ShadowMap>> = Vec::new();
        for (request, picture) in requests.iter().zip(&pictures) {
            let frame = renderer.drawing(request).unwrap();
            maps.extend(frame.drawing.surfaces.iter().flat_map(|surface| &surface.shadows).map(|s| s.map.clone()));
            assert!(*picture == Renderer::default().pixels(request).unwrap());
        }
        assert!(maps.len() >= requests.len() && maps.iter().all(|map| Arc::ptr_eq(map, &maps[0])));
        assert!(maps[0].unpainted().is_none() && maps[0].depths().is_some());
    }

    fn since_start() -> Duration {
        static START: OnceLock<Instant> = OnceLock::new();
        START.get_or_init(Instant::now).elapsed()
    }

    #[test]
    fn scenes_too_large_to_split_use_the_depth_buffer_and_say_so() {
        for view in View::ALL {
            let (split, tested) = (request(view, "bsp"), request(view, "depth-buffer"));
            let bare =
                |request: &Request| Request { finish: Finish { bare: true, ..Finish::default() }, ..request.clone() };
            let mut renderer = with_few_pieces();
            renderer.measure(Some(since_start));
            let mut picture = Pixels::default();
            let account = at_once(renderer.pixels_into(&split, &mut picture)).unwrap();
            let OverBudget::Pieces { objects } = account.over_budget.unwrap() else { panic!("pieces") };
            let mut names = objects.clone();
            names.sort();
            assert_eq!(names, ["one", "three", "two"]);
            let report = account.stages.iter().find(|report| report.stage == Stage::HiddenSurfaces).unwrap();
            assert!(matches!(report.reason, Reason::TooManyPieces { pieces: 41.. }), "{report:?}");
            // The note is in it, and nothing else differs.
            assert_ne!(Some(&picture), renderer.pixels(&bare(&split)).as_ref());
            assert_eq!(renderer.pixels(&bare(&split)), Renderer::default().pixels(&bare(&tested)));

            let mut picture = Pixels::default();
            let account = at_once(Renderer::default().pixels_into(&split, &mut picture)).unwrap();
            assert_eq!(account.over_budget, None);
        }
    }

    #[test]
    fn a_comparison_reports_the_shortfall_of_either_side() {
        let compared = |visibility: &str| {
            let request = request(View::Image, visibility);
            let figure = parse(&format!(
                "[style]\nvisibility = \"{visibility}\"\n[compare]\nwith = {{ \"style.visibility\" = \"painter\" }}\n"
            ));
            request.with_shot(|shot| shot.compared = Shot::of(figure.as_ref().unwrap()).compared)
        };
        let mut other = compared("bsp");
        // The side that isn't the figure's own is sorted.
        other = other.with_shot(|shot| {
            let style = &mut shot.look.style;
            style.visibility = match style.visibility {
                crate::appearance::Visibility::Bsp => crate::appearance::Visibility::Painter,
                _ => crate::appearance::Visibility::Bsp,
            };
        });
        for request in [compared("bsp"), other] {
            let mut picture = Pixels::default();
            assert!(request.sides().is_some());
            let account = at_once(with_few_pieces().pixels_into(&request, &mut picture)).unwrap();
            assert!(account.over_budget.is_some());
        }
    }

    #[test]
    fn strokes_are_wider_by_their_factor_also_on_the_window_and_nothing_else_changes() {
        for view in View::ALL {
            let request = request(view, "depth-buffer");
            let of = |stroke_factor| {
                let finish = Finish { stroke_factor, ..Finish::default() };
                Renderer::default().drawing(&Request { finish, ..request.clone() }).unwrap().drawing
            };
            let (plain, same, mut wide) = (of(None), of(Some(1.0)), of(Some(2.5)));
            assert!(plain == same && !plain.strokes.is_empty());
            wide.strokes.iter_mut().for_each(|stroke| stroke.style.width /= 2.5);
            let width = |drawing: &Drawing| drawing.strokes.iter().map(|s| f64::from(s.style.width)).sum::<f64>();
            assert!((width(&wide) / width(&plain) - 1.0).abs() < 1e-5);
            assert!((&wide.labels, &wide.marks, &wide.areas) == (&plain.labels, &plain.marks, &plain.areas));
            let wide = Finish { stroke_factor: Some(2.5), ..Finish::default() };
            let on_window = Request { finish: wide, ..request.clone() }.image_on_window();
            assert_eq!(on_window.finish.stroke_factor, Some(2.5));
        }
    }

    #[test]
    fn a_drawing_for_vectors_that_is_not_in_order_says_so() {
        let request = Request { output: Output::Vectors, ..request(View::Image, "depth-buffer") };
        let mut pipeline = TimedPipeline::default();
        assert!(views::frame(&request, None, &mut pipeline).over_budget.is_none());
        pipeline.stages.max_pieces = Some(40);
        let frame = views::frame(&request, None, &mut pipeline);
        assert!(frame.over_budget.is_some() && !frame.drawing.painted_in_order);
    }

    #[test]
    fn a_window_that_shows_no_image_has_none_drawn() {
        let hide: [fn(&mut Shot); 3] = [
            |shot| shot.look.world.section = true,
            |shot| shot.look.world.window_opacity = Some(0.0),
            |shot| shot.look.world.parts.set(WorldPart::Window, false),
        ];
        for hide in hide {
            let request = request(View::World, "depth-buffer").with_shot(hide);
            let mut renderer = Renderer::default();
            let picture = renderer.pixels(&request).unwrap();
            assert!(renderer.on_window.is_none());
            let image = Arc::new(renderer.pixels(&request.image_on_window()).unwrap().into_texture());
            let drawing = views::frame(&request, Some(&image), &mut TimedPipeline::default()).drawing;
            assert!(picture == Rasterizer::default().paint(&drawing).unwrap().into());
        }
    }

    #[test]
    fn a_picture_that_is_cancelled_is_none_and_the_next_one_is_whole() {
        let progress = Progress::default();
        let mut renderer = Renderer::default();
        renderer.watch(&progress);
        for view in View::ALL {
            let request = request(view, "bsp");
            progress.cancel();
            assert_eq!(renderer.pixels(&request), None);
            progress.begin_anew();
            assert_eq!(renderer.pixels(&request), Renderer::default().pixels(&request));
        }
    }
}
