//! The image: the scene as the figure's camera sees it, m × n pixels of (5.22), which aren't square if A ≠ m / n.

pub(super) mod cost;
pub mod depth;
pub(super) mod light_view;
pub(super) mod offscreen_arrows;
mod single_precision;
pub(super) mod vanishing;

use std::cell::Cell;
use std::sync::Arc;

use glam::DVec2;

use crate::appearance::{Filter, HiddenLines, LineStyle, Rgba, Sampler, Style, Visibility};
use crate::drawing::{Base, Drawing, Label, StrokeSet, Surface};
use crate::pipeline::depths::DepthScale;
use crate::pipeline::{Frame, Reason, Scenes, Stage, Target};
use crate::scene::Scene;

use super::pixels::{PixelRect, Size, image_frame};
use super::screen::Screen;
use super::timed_pipeline::TimedPipeline;
use super::{Palette, Request};
use crate::views::image::depth::Greys;
use crate::views::reveal::{operation_path, probe, revealed_scene, triangle_overlay};
use crate::views::words::label_layout::{Author, Rules};
use crate::views::words::label_obstacles::Box2;
use crate::views::words::legend::{Legend, LegendRow, LegendText};
use crate::views::words::{author_labels, label_layout};
use crate::views::world::gizmos::AnnotationBuilder;

/// The camera and the pixels that its window fills.
pub(super) fn screen(request: &Request) -> Screen {
    Screen::new(request.camera.clone(), frame(request), request.size.scale)
}

pub(super) fn frame(request: &Request) -> PixelRect {
    /// Space for half a mark, in units of stroke width.
    const MARGIN: f32 = 6.0;
    let Size { width, height, scale } = request.size;
    let margin = (MARGIN * request.size.type_scale()).ceil();
    let room = width.min(height) as f32 / 8.0;
    if !request.finish.framed || request.finish.bare || room < margin {
        return request.image_frame();
    }
    #[expect(clippy::cast_possible_truncation, reason = "at most an eighth of the picture")]
    let margin = margin as u32;
    let inner = request.image_frame_in(Size { width: width - 2 * margin, height: height - 2 * margin, scale });
    PixelRect { x: inner.x + margin, y: inner.y + margin, ..inner }
}

impl Request {
    /// The place of the image in its picture: the largest rectangle with its aspect, in the middle; or less, if the
    /// vanishing points of a photograph are shown beside it.
    pub fn image_frame(&self) -> PixelRect {
        self.image_frame_in(self.size)
    }

    fn image_frame_in(&self, size: Size) -> PixelRect {
        let most = image_frame(size, self.shot.look.image_aspect(&self.camera));
        let share = vanishing::share_beside(self, most, size);
        #[expect(clippy::cast_possible_truncation, reason = "a part of a side")]
        let [width, height] = [most.width, most.height].map(|side| (f64::from(side) * share).round() as u32);
        PixelRect { x: most.x + (most.width - width) / 2, y: most.y + (most.height - height) / 2, width, height }
    }
}

/// Draws the image.
pub(super) fn frame_of(request: &Request, pipeline: &mut TimedPipeline) -> Frame {
    let in_single = single_precision::in_single(request);
    let request = in_single.as_ref().unwrap_or(request);
    match light_view::of_light(request) {
        Some(of_light) => headed(&of_light, request.labels.depth_of_light, pipeline),
        None => headed(request, request.labels.depth_linear, pipeline),
    }
}

/// Draws the image of a request. `linear` is the heading of distances.
fn headed(request: &Request, linear: &str, pipeline: &mut TimedPipeline) -> Frame {
    let mut image = Image::of_scene(request, linear, pipeline);
    LAYERS.iter().for_each(|add| add(&mut image));
    image.drawn
}

/// A part of the picture, added to it.
type Layer = fn(&mut Image<'_>);

/// The layers over the scene and its gear, in their visible order. The legend has the rows of those before it.
const LAYERS: [Layer; 8] = [
    |image| image.add_divided_first(),
    |image| image.paint_first_triangles(),
    |image| image.explain(),
    |image| image.settle_texts(),
    |image| image.put_photograph_under(),
    |image| image.mount(),
    |image| triangle_overlay::pixels(&mut image.drawn.drawing, image.rect, image.request, image.palette),
    |image| image.finish(),
];

/// The picture in the making.
struct Image<'a> {
    request: &'a Request,
    /// The heading of distances.
    linear: &'a str,
    palette: Palette,
    greys: Option<Greys>,
    style: Style,
    screen: Screen,
    /// The part of the picture that the window fills.
    rect: PixelRect,
    target: Target,
    /// The scene as dividing before clipping makes it.
    wrong: Option<Scene>,
    /// True if the scene has marks.
    has_marks: bool,
    rows: Vec<LegendRow>,
    /// The names of points beside the image, which have no place in it to be settled.
    outside: Vec<Label>,
    legend: Option<Legend>,
    drawn: Frame,
}

impl<'a> Image<'a> {
    /// The scene with its gear.
    fn of_scene(request: &'a Request, linear: &'a str, pipeline: &mut TimedPipeline) -> Self {
        let palette = Palette::of(request.shot.look.style.theme);
        let greys = Greys::of(request);
        let paper = if greys.is_some() { palette.nothing } else { palette.paper };
        let style = style_of(request, greys.is_some());
        let (rect, screen) = (frame(request), screen(request));
        let target = Target { width: rect.width, height: rect.height, ..request.size.target(paper) };
        let (mut revealed, wrong) = revealed_scene::in_image(request, palette);
        let mut scene = std::mem::take(&mut revealed.scene);
        if greys.is_some() {
            depth::only(scene.to_mut());
        }
        let mut builder = AnnotationBuilder::new(&screen);
        revealed.mark(&mut builder, palette);
        probe::in_image(&mut builder, request, palette);
        triangle_overlay::in_image(&mut builder, request, palette);
        revealed.rows.extend(operation_path::in_image(&mut builder, request, palette));
        let lights = light_view::lights(request, &scene);
        let scenes = Scenes::new(&scene, &builder.gear)
            .with_fineness(screen.fineness(request, |p| screen.place(p)))
            .in_shadows_of(&request.scene)
            .lit_by(&lights);
        let has_marks = Cell::new(false);
        let repaint = |drawing: &mut Drawing, scale: DepthScale| {
            has_marks.set(!drawing.marks.is_empty());
            if let Some(greys) = greys {
                greys.paint(drawing, scale);
            }
        };
        let mut drawn = pipeline.frame(request, scenes, &request.camera, target, &style, repaint);
        for drawing in std::iter::once(&mut drawn.drawing).chain(&mut drawn.before) {
            (drawing.depth_format, drawing.order) = (style.depth_format, style.order);
        }
        if request.finish.bare {
            // The drawing below has the texts of the scene itself.
            drawn.drawing.labels.clear();
        }
        let (rows, has_marks) = (revealed.rows, has_marks.get());
        Self {
            request,
            linear,
            palette,
            greys,
            style,
            screen,
            rect,
            target,
            wrong,
            has_marks,
            rows,
            outside: Vec::new(),
            legend: None,
            drawn,
        }
    }

    /// The part that dividing before clipping makes.
    fn add_divided_first(&mut self) {
        // If nothing is behind the eye, dividing first makes no difference, and clipping worked as usual.
        let wrong = self.wrong.take().filter(|w| *w != Scene { lights: w.lights.clone(), ..Scene::default() });
        let Some((wrong, front)) = wrong.zip(revealed_scene::front()) else { return };
        self.drawn.say(Stage::Clip, Reason::DividedFirst);
        let plain = self.request.clone().with_shot(|shot| shot.show.stage = None);
        let mut pipeline = TimedPipeline::default();
        let mut more = pipeline.frame(&plain, &wrong, &front, self.target, &self.style, |_, _| {}).drawing;
        if self.greys.is_some() {
            // Glass has no depth.
            more.surfaces.clear();
            more.strokes.clear();
        }
        add(&mut self.drawn.drawing, more);
    }

    fn paint_first_triangles(&mut self) {
        if let Some(share) = self.request.shot.show.painted {
            let [count, all] = keep_first_triangles(&mut self.drawn.drawing, share);
            let text = format!("{count} / {all} {}", self.request.labels.triangles);
            self.rows.push(LegendRow::Title(LegendText::new("triangles", text), self.palette.ink));
        }
    }

    /// Marks of what the picture shows besides the scene, and their rows in the legend.
    fn explain(&mut self) {
        let (request, palette, drawn) = (self.request, self.palette, &mut self.drawn);
        if let Some(greys) = self.greys {
            Greys::report(drawn, self.has_marks);
            self.rows.extend(greys.legend(request, self.linear, palette));
        }
        self.rows.extend(light_view::rows(request, palette));
        self.rows.extend(cost::rows(request, palette));
        self.rows.extend(revealed_scene::drawn_rows(drawn, request, palette));
        offscreen_arrows::in_image(&mut drawn.drawing, request, palette);
        vanishing::epipolar_line(&mut drawn.drawing, request, palette);
        if request.shot.look.reveal.vanishing {
            let before = drawn.drawing.labels.len();
            self.rows.extend(vanishing::in_image(&mut drawn.drawing, request, palette));
            let sides = [drawn.drawing.width, drawn.drawing.height].map(|side| side as f32);
            let is_inside = |label: &Label| (0..2).all(|k| (0.0..=sides[k]).contains(&label.position[k]));
            let (inside, outside) = drawn.drawing.labels.split_off(before).into_iter().partition(is_inside);
            self.outside = outside;
            drawn.drawing.labels.extend::<Vec<_>>(inside);
        }
    }

    /// The texts, the author's notes and the place of the legend.
    fn settle_texts(&mut self) {
        let (request, rect, palette) = (self.request, self.rect, self.palette);
        // The legend doesn't cover the border.
        let part = if request.finish.framed { rect } else { PixelRect::whole(request.size) };
        let rows = std::mem::take(&mut self.rows);
        self.legend = revealed_scene::legend(request, rows, part, self.target.scale, palette);
        // It lies in the whole picture, while the image may only be its middle.
        let corner = DVec2::new(f64::from(rect.x), f64::from(rect.y));
        let reserved =
            revealed_scene::room(self.legend.as_ref()).map(|room| Box2 { center: room.center - corner, ..room });
        author_labels::add_notes(&mut self.drawn.drawing, request, corner, Some(&self.screen));
        let author = Some(Author { page: Some(Author::page(request, corner)), ..Author::of(request, palette) });
        label_layout::settle(&mut self.drawn.drawing, &Rules { reserved, leader: None, author });
    }

    fn put_photograph_under(&mut self) {
        if self.greys.is_none() {
            let drawings = std::iter::once(&mut self.drawn.drawing).chain(&mut self.drawn.before);
            self.drawn.ground += usize::from(put_photograph_under(drawings, self.request));
        }
    }

    /// Puts the image into the middle of the picture, if it doesn't fill it.
    fn mount(&mut self) {
        let (request, rect, palette) = (self.request, self.rect, self.palette);
        if rect == PixelRect::whole(request.size) {
            return;
        }
        let mount = |drawing: &mut Drawing| {
            let image = std::mem::replace(drawing, Drawing::new(0, 0, palette.surround));
            *drawing = mounted(image, rect, request.size, palette);
            if request.finish.transparent {
                // The sheet of paper.
                drawing.surfaces.remove(0);
            }
        };
        std::iter::once(&mut self.drawn.drawing).chain(&mut self.drawn.before).for_each(mount);
        let outside = std::mem::take(&mut self.outside).into_iter();
        let shifted_label = |label: Label| Label { position: shifted(label.position, rect), ..label };
        self.drawn.drawing.labels.extend(outside.map(shifted_label));
        self.drawn.ground += usize::from(!request.finish.transparent);
        let dropped = self.drawn.dropped_faces.iter_mut().flat_map(|face| &mut face.positions);
        dropped.for_each(|p| *p = shifted(*p, rect));
    }

    fn finish(&mut self) {
        cost::tint(&mut self.drawn, self.request);
        light_view::mark_wrong(&mut self.drawn.drawing, self.rect, self.request, self.palette);
        revealed_scene::explain(&mut self.drawn, self.request, self.legend.as_ref());
    }
}

/// The style of the scene, or of its depths as greys.
fn style_of(request: &Request, has_greys: bool) -> Style {
    let style = &request.shot.look.style;
    match (has_greys, request.shot.look.reveal.divide_first) {
        (true, _) => depth::style(style),
        // The wrong part is drawn by itself, and only a depth buffer combines both.
        (false, true) => Style { visibility: Visibility::DepthBuffer, ..*style },
        (false, false) => *style,
    }
}

/// Keeps the first share (0 … 1) of the triangles, and returns their number, and that of all. Strokes and marks are
/// left out, because the faces that hide them may be missing.
fn keep_first_triangles(drawing: &mut Drawing, share: f64) -> [usize; 2] {
    let all: usize = drawing.surfaces.iter().map(|surface| surface.triangles.len()).sum();
    #[expect(clippy::cast_possible_truncation, reason = "a share of a count")]
    let count = (all as f64 * share.clamp(0.0, 1.0)).round() as usize;
    // Without an order, translucent faces are painted last, whatever their place in the list.
    let mut order: Vec<usize> = (0..drawing.surfaces.len()).collect();
    order.sort_by_key(|i| !drawing.painted_in_order && drawing.surfaces[*i].translucent);
    let mut left = count;
    for i in order {
        let surface = &mut drawing.surfaces[i];
        let kept = left.min(surface.triangles.len());
        left -= kept;
        surface.truncate(kept);
    }
    drawing.surfaces.retain(|surface| !surface.triangles.is_empty());
    drawing.strokes.clear();
    drawing.marks.clear();
    [count, all]
}

/// Puts the photograph of the figure behind everything else in drawings of its image, with its opacity. Images of other
/// cameras don't have it, because the figure's own camera took it. False if there is none.
fn put_photograph_under<'a>(drawings: impl Iterator<Item = &'a mut Drawing>, request: &Request) -> bool {
    let share = request.shot.look.photograph_opacity;
    #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
    let opacity = (255.0 * share.clamp(0.0, 1.0)).round() as u8;
    let Some(image) = request.scene.photograph.as_ref().filter(|_| opacity > 0 && request.projector.is_none()) else {
        return false;
    };
    for drawing in drawings {
        let [w, h] = [drawing.width, drawing.height].map(|side| side as f32);
        // On the back plane, the farthest place of all.
        let corners = vec![[0.0, 0.0, 0.0], [w, 0.0, 0.0], [w, h, 0.0], [0.0, h, 0.0]];
        let base = Base::Texture {
            image: Arc::clone(image),
            sampler: Sampler { filter: Filter::Trilinear, ..Sampler::PICTURE },
            uv: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            tint: Rgba::rgba(255, 255, 255, opacity),
            tints: Vec::new(),
        };
        let translucent = opacity < 255 || !image.is_opaque();
        if translucent && !drawing.painted_in_order {
            // Translucent surfaces come after opaque ones, and only depths keep the photograph behind.
            drawing.surfaces.iter_mut().filter(|s| !s.translucent).for_each(|s| s.depth_test = true);
        }
        let triangles = vec![[0, 1, 2], [0, 2, 3]];
        let plain = Surface::solid(corners, triangles, Rgba::rgb(255, 255, 255));
        drawing.surfaces.insert(0, Surface { base, translucent, depth_test: translucent, ..plain });
    }
    true
}

/// Adds the content of another drawing in the same place, with the same depths.
fn add(drawing: &mut Drawing, more: Drawing) {
    drawing.surfaces.extend(more.surfaces);
    drawing.surfaces.iter_mut().for_each(|surface| surface.depth_test = true);
    drawing.strokes.extend(more.strokes);
    drawing.marks.extend(more.marks);
}

/// The image in the middle of a larger picture, with a thin border.
fn mounted(mut image: Drawing, rect: PixelRect, size: Size, palette: Palette) -> Drawing {
    let [x, y, w, h] = [rect.x, rect.y, rect.width, rect.height].map(|v| v as f32);
    let shift = |p: &mut [f32; 3]| *p = shifted(*p, rect);
    image.surfaces.iter_mut().flat_map(|s| &mut s.positions).for_each(shift);
    image.strokes.iter_mut().flat_map(|s| &mut s.points).for_each(shift);
    image.areas.iter_mut().for_each(|area| area.corner = [area.corner[0] + x, area.corner[1] + y]);
    image.marks.iter_mut().for_each(|m| shift(&mut m.position));
    image.labels.iter_mut().for_each(|l| shift(&mut l.position));
    image.surfaces.insert(0, sheet_of_paper([x, y, w, h], image.background));
    let half = 0.5 * size.scale;
    let corner = |dx: f32, dy: f32| [x + dx * w + half * (2.0 * dx - 1.0), y + dy * h + half * (2.0 * dy - 1.0), 1.0];
    let border = vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0), corner(0.0, 0.0)];
    let style = LineStyle::solid(palette.soft, size.scale, HiddenLines::Shown);
    image.strokes.push(StrokeSet::line(border, style));
    Drawing { width: size.width, height: size.height, background: palette.surround, ..image }
}

/// A place in the image, in the coordinates of the whole picture.
fn shifted([x, y, z]: [f32; 3], rect: PixelRect) -> [f32; 3] {
    [x + rect.x as f32, y + rect.y as f32, z]
}

/// A rectangle behind everything.
fn sheet_of_paper([x, y, w, h]: [f32; 4], color: Rgba) -> Surface {
    let corners = vec![[x, y, 0.0], [x + w, y, 0.0], [x + w, y + h, 0.0], [x, y + h, 0.0]];
    let plain = Surface::solid(corners, vec![[0, 1, 2], [0, 2, 3]], color);
    Surface { translucent: false, depth_test: false, ..plain }
}
