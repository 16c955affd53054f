//! The image: the scene as the figure's camera sees it, m × n pixels of (5.22), which aren't square if A ≠ m / n.

pub mod depth;
pub(super) mod light_view;
pub(super) mod offscreen_arrows;
pub(super) mod partial_paint;
mod photograph;
mod single_precision;
pub(super) mod vanishing;

use std::cell::Cell;

use glam::DVec2;

use crate::appearance::{HiddenLines, LineStyle, Rgba, Style, Visibility};
use crate::drawing::{Drawing, StrokeSet, Surface};
use crate::pipeline::depths::DepthScale;
use crate::pipeline::{Frame, Reason, Scenes, Stage, Target};
use crate::scene::Scene;

use super::pixels::{PixelRect, Size, image_frame};
use super::screen::Screen;
use super::timed_pipeline::TimedPipeline;
use super::{Palette, Request};
use crate::views::image::depth::Greys;
use crate::views::reveal::{operation_path, probe, revealed_scene, triangle_overlay};
use crate::views::words::author_labels;
use crate::views::words::label_layout;
use crate::views::words::label_layout::{Author, Rules};
use crate::views::words::label_obstacles::Box2;
use crate::views::words::legend::{LegendRow, LegendText};
use crate::views::world::gizmos::AnnotationBuilder;

/// The camera and the pixels that its window fills.
pub(super) fn screen(request: &Request) -> Screen {
    Screen::new(request.camera.clone(), frame(request), request.size.scale)
}

pub(super) fn frame(request: &Request) -> PixelRect {
    /// Space for half a mark, in units of stroke width.
    const MARGIN: f32 = 6.0;
    let Size { width, height, scale } = request.size;
    let aspect = request.shot.look.image_aspect(&request.camera);
    let margin = (MARGIN * request.size.type_scale()).ceil();
    let room = width.min(height) as f32 / 8.0;
    if !request.finish.framed || request.finish.bare || room < margin {
        return image_frame(request.size, aspect);
    }
    #[expect(clippy::cast_possible_truncation, reason = "at most an eighth of the picture")]
    let margin = margin as u32;
    let inner = image_frame(Size { width: width - 2 * margin, height: height - 2 * margin, scale }, aspect);
    PixelRect { x: inner.x + margin, y: inner.y + margin, ..inner }
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
    let style = &request.shot.look.style;
    let palette = Palette::of(style.theme);
    let greys = Greys::of(request);
    let paper = if greys.is_some() { palette.nothing } else { palette.paper };
    let style = match (greys, request.shot.look.reveal.divide_first) {
        (Some(_), _) => depth::style(style),
        // The wrong part is drawn by itself, and only a depth buffer combines both.
        (None, true) => Style { visibility: Visibility::DepthBuffer, ..*style },
        (None, false) => *style,
    };
    let (whole, screen) = (request.size.target(paper), screen(request));
    let rect = frame(request);
    let target = Target { width: rect.width, height: rect.height, ..whole };
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
    let marks = Cell::new(false);
    let repaint = |drawing: &mut Drawing, scale: DepthScale| {
        marks.set(!drawing.marks.is_empty());
        if let Some(greys) = greys {
            greys.paint(drawing, scale);
        }
    };
    let mut drawn = pipeline.frame(request, scenes, &request.camera, target, &style, repaint);
    for drawing in std::iter::once(&mut drawn.drawing).chain(&mut drawn.before) {
        drawing.depth_format = style.depth_format;
    }
    // If nothing is behind the eye, dividing first makes no difference, and clipping worked as usual.
    let wrong = wrong.filter(|wrong| *wrong != Scene { lights: wrong.lights.clone(), ..Scene::default() });
    if let Some((wrong, front)) = wrong.zip(revealed_scene::front()) {
        drawn.say(Stage::Clip, Reason::DividedFirst);
        let plain = request.clone().with_shot(|shot| shot.show.stage = None);
        let mut more = TimedPipeline::default().frame(&plain, &wrong, &front, target, &style, |_, _| {}).drawing;
        if greys.is_some() {
            // Glass has no depth.
            more.surfaces.clear();
            more.strokes.clear();
        }
        add(&mut drawn.drawing, more);
    }
    if request.finish.bare {
        // The drawing below has the texts of the scene itself.
        drawn.drawing.labels.clear();
    }
    let mut rows = revealed.rows;
    if let Some(share) = request.shot.show.painted {
        let [count, all] = partial_paint::first(&mut drawn.drawing, share);
        let text = format!("{count} / {all} {}", request.labels.triangles);
        rows.push(LegendRow::Title(LegendText::new("triangles", text), palette.ink));
    }
    if let Some(greys) = greys {
        Greys::report(&mut drawn, marks.get());
        rows.extend(greys.legend(request, linear, palette));
    }
    rows.extend(light_view::rows(request, palette));
    rows.extend(revealed_scene::drawn_rows(&drawn, request, palette));
    offscreen_arrows::in_image(&mut drawn.drawing, request, palette);
    if request.shot.look.reveal.vanishing {
        rows.extend(vanishing::in_image(&mut drawn.drawing, request, palette));
    }
    // It doesn't cover the border.
    let part = if request.finish.framed { rect } else { PixelRect::whole(request.size) };
    let legend = revealed_scene::legend(request, rows, part, whole.scale, palette);
    // The legend lies in the whole picture, while the image may only be its middle.
    let reserved = revealed_scene::room(legend.as_ref())
        .map(|room| Box2 { center: room.center - DVec2::new(f64::from(rect.x), f64::from(rect.y)), ..room });
    let corner = DVec2::new(f64::from(rect.x), f64::from(rect.y));
    author_labels::add_notes(&mut drawn.drawing, request, corner, Some(&screen));
    let author = Some(Author { page: Some(Author::page(request, corner)), ..Author::of(request, palette) });
    label_layout::settle(&mut drawn.drawing, &Rules { reserved, leader: None, author });
    if greys.is_none() {
        photograph::under(std::iter::once(&mut drawn.drawing).chain(&mut drawn.before), request);
    }
    if rect != PixelRect::whole(request.size) {
        let mount = |drawing: Drawing| {
            let mut drawing = mounted(drawing, rect, request.size, palette);
            if request.finish.transparent {
                // The sheet of paper.
                drawing.surfaces.remove(0);
            }
            drawing
        };
        (drawn.drawing, drawn.before) = (mount(drawn.drawing), drawn.before.map(mount));
        let dropped = drawn.dropped_faces.iter_mut().flat_map(|face| &mut face.positions);
        dropped.for_each(|p| *p = shifted(*p, rect));
    }
    triangle_overlay::pixels(&mut drawn.drawing, rect, request, palette);
    light_view::mark_wrong(&mut drawn.drawing, rect, request, palette);
    revealed_scene::explain(&mut drawn, request, legend.as_ref());
    drawn
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
