//! A stage of the pipeline in its picture: input and output.
//!
//! Work on vertices, triangles and objects is drawn over the picture, as recorded while the picture was made
//! ([`StageWork`]). Work on pixels is shown in two halves: the left one before the stage, the right one after it.

use glam::DVec2;

use crate::appearance::{Dash, HiddenLines, LineStyle, MarkShape, Rgba, Style, Visibility};
use crate::drawing::{Anchor, Area, Base, Drawing, Label, Mark, StrokeSet, Surface};
use crate::inspect::quantity::{PointNumber, Quantity};
use crate::pipeline::{Containment, Frame, Output, Scenes, Stage, StageWork, VertexWork};
use crate::sanitize;
use crate::stage::WorksOn;
use crate::text::literal;

use crate::views::words::label_layout::Author;
use crate::views::words::legend::{LegendRow, LegendText};
use crate::views::world::gizmos::{SMALL_TYPE, stroke};
use crate::views::{Palette, Request};

/// Greatest number of vertices with their numbers written on them.
const MOST_NUMBERS: usize = 10;
/// Greatest number of dropped objects named in the legend.
const MOST_NAMES: usize = 4;
/// More marks than this hide the picture.
const MOST_MARKS: usize = 3000;
/// Opacity of a dropped face.
const GLASS: u8 = 150;
/// The beginnings of the names of labels at objects and at vertices. The object's name or a number, from 1, follows.
const OBJECT: &str = "object:";
const VERTEX: &str = "vertex:";
/// The objects that the pictures add to the scene.
const OWN: [&str; 4] = ["camera", "volume", "window", "near"];
/// The names of the words over the two halves of a picture.
const GOES_IN: &str = "goes-in";
const COMES_OUT: &str = "comes-out";

/// Shows the stage in its picture. `again` draws a scene in a style like this picture.
pub(in crate::views) fn show(
    frame: &mut Frame,
    request: &Request,
    scenes: Scenes,
    style: &Style,
    again: impl FnOnce(Scenes, &Style, Output) -> Drawing,
) {
    let Some(work) = frame.work.take() else { return };
    let palette = Palette::of(request.shot.look.style.theme);
    frame.before = before(work.stage, &frame.drawing, (scenes, style), again, request);
    frame.dropped_faces = work.dropped.iter().map(|polygon| dropped_face(polygon, palette)).collect();
    draw(&mut frame.drawing, &work, request, palette);
    frame.work = Some(work);
}

/// The picture before a stage that works on pixels, without texts.
fn before(
    stage: Stage,
    drawing: &Drawing,
    (scenes, style): (Scenes, &Style),
    again: impl FnOnce(Scenes, &Style, Output) -> Drawing,
    request: &Request,
) -> Option<Drawing> {
    let mut before = match stage {
        Stage::Light => again(scenes.without_lights(), style, request.output),
        // Only a drawing for pixels leaves the faces in their original order.
        Stage::HiddenSurfaces => {
            again(scenes, &Style { visibility: Visibility::DepthBuffer, ..*style }, Output::Pixels)
        }
        _ if stage.works_on() == WorksOn::Pixels => drawing.clone(),
        _ => return None,
    };
    before.labels.clear();
    let palette = Palette::of(request.shot.look.style.theme);
    match stage {
        Stage::HiddenSurfaces => {
            before.painted_in_order = true;
            before.surfaces.iter_mut().for_each(|surface| surface.depth_test = false);
        }
        Stage::Fill => {
            before.strokes = outlines(&before.surfaces, stroke_of(palette.axes[0], request));
            before.surfaces.clear();
            before.marks.clear();
        }
        Stage::Interpolate => {
            let values = before.surfaces.iter().flat_map(values_at_vertices);
            let marks = values.take(MOST_MARKS).map(|(position, color)| mark(position, color, 2.5, request));
            before.marks = marks.collect();
            before.strokes.clear();
            before.surfaces.retain(|surface| !surface.varies());
        }
        Stage::Texture => {
            for surface in before.surfaces.iter_mut().filter(|surface| surface.is_textured()) {
                surface.base = Base::Solid(palette.body);
            }
        }
        Stage::Shadow => before.surfaces.iter_mut().for_each(|surface| surface.shadows.clear()),
        Stage::Blend => before.surfaces.iter_mut().filter(|s| s.translucent).for_each(Surface::make_opaque),
        Stage::Antialias => before.antialias = crate::appearance::Samples::One,
        Stage::Lines => {
            before.strokes.clear();
            before.marks.clear();
        }
        Stage::Write => {
            before.surfaces.clear();
            before.strokes.clear();
            before.marks.clear();
        }
        _ => {}
    }
    Some(before)
}

fn stroke_of(color: Rgba, request: &Request) -> LineStyle {
    stroke(color, 1.2 * request.size.scale, Dash::Solid, HiddenLines::Shown)
}

/// The values at the vertices of a surface before interpolation, as colours.
fn values_at_vertices(surface: &Surface) -> Vec<([f32; 3], Rgba)> {
    let triangles = surface.triangles.iter().enumerate().filter(|_| surface.varies());
    let corners = triangles.flat_map(|(triangle, corners)| corners.map(|i| (triangle, i)));
    let value = |(triangle, i): (usize, u32)| {
        Some((*surface.positions.get(i as usize)?, surface.color_at_vertex(triangle, i)?))
    };
    corners.filter_map(value).collect()
}

/// The sides of triangles.
fn outlines(surfaces: &[Surface], style: LineStyle) -> Vec<StrokeSet> {
    let sides = surfaces.iter().flat_map(|surface| {
        surface.triangles.iter().flat_map(|&[a, b, c]| {
            let at = |i: u32| surface.positions.get(i as usize).copied().unwrap_or_default();
            [[a, b], [b, c], [c, a]].map(|ends| ends.map(at))
        })
    });
    vec![StrokeSet::pairs(&sides.collect::<Vec<_>>(), style)]
}

fn mark(position: [f32; 3], color: Rgba, radius: f32, request: &Request) -> Mark {
    let palette = Palette::of(request.shot.look.style.theme);
    Mark::new(position, MarkShape::Disc, radius * request.size.scale, [color, palette.paper])
}

/// A face that the stage drops, as glass.
fn dropped_face(polygon: &[[f32; 3]], palette: Palette) -> Surface {
    let corners = u32::try_from(polygon.len()).unwrap_or(0);
    let triangles = (2..corners).map(|i| [0, i - 1, i]).collect();
    Surface { depth_test: false, ..Surface::solid(polygon.to_vec(), triangles, palette.back.with_alpha(GLASS)) }
}

/// The input dashed, the output over it.
fn draw(drawing: &mut Drawing, work: &StageWork, request: &Request, palette: Palette) {
    let [color_in, color_out] = colors(palette);
    let thin = stroke_of(color_in, request);
    // Wide enough to be visible on both sides of the output.
    let dashed = LineStyle { dash: Dash::Dashed, width: 3.0 * thin.width, ..thin };
    for (sides, style) in [(&work.before, dashed), (&work.after, stroke_of(color_out, request))] {
        if !sides.is_empty() {
            drawing.strokes.push(StrokeSet::pairs(sides, style));
        }
    }
    let cut = |p: &[f32; 3]| Mark { shape: MarkShape::Diamond, ..mark(*p, palette.cut, 3.4, request) };
    drawing.marks.extend(work.cuts.iter().take(MOST_MARKS).map(cut));
    drawing.marks.extend(work.vertices.iter().take(MOST_MARKS).map(|v| mark(v.image, color_out, 2.6, request)));
    let mut label = |name: String, position: [f32; 3], text: String| {
        drawing.labels.push(Label {
            name,
            offset: [7.0 * request.size.scale, -7.0 * request.size.scale],
            ..Label::new(
                position,
                text,
                (SMALL_TYPE * request.size.scale).max(request.least_letters()),
                [palette.ink, palette.paper],
            )
        });
    };
    for object in &work.objects {
        if let Some(middle) = object.middle {
            let name = sanitize::escaped(&object.name);
            label(object_label(&name), middle, literal(&name));
        }
    }
    let mut known: Vec<VertexWork> = Vec::new();
    for vertex in &work.vertices {
        if known.len() < MOST_NUMBERS && known.iter().all(|k| k.image != vertex.image) {
            known.push(*vertex);
            label(format!("{VERTEX}{}", known.len()), vertex.image, in_and_out(work.stage, vertex, request));
        }
    }
}

fn colors(palette: Palette) -> [Rgba; 2] {
    [palette.axes[0], palette.axes[2]]
}

/// The numbers of a vertex before and after a stage.
fn in_and_out(stage: Stage, vertex: &VertexWork, request: &Request) -> String {
    let numbers = |values: &[f64]| request.labels.mark.tuple(values, 3);
    let VertexWork { world, view, clip, w, image } = vertex;
    let ndc = clip.map(|c| c / w);
    let shown = match stage {
        Stage::Divide | Stage::Oblique => [PointNumber::Clip, PointNumber::Ndc],
        Stage::Viewport => [PointNumber::Ndc, PointNumber::Viewport],
        _ => [PointNumber::World, PointNumber::View],
    };
    if request.shot.asked.hides(&shown.map(|number| Quantity::Point(0, number)), &[]) {
        return "?".to_owned();
    }
    match stage {
        Stage::Divide => format!("{} ÷ {} → {}", numbers(clip), request.labels.mark.number(*w, 3), numbers(&ndc)),
        Stage::Viewport => format!("{} → {}", numbers(&ndc), numbers(&[image[0], image[1]].map(f64::from))),
        Stage::Oblique => format!("{} → {}", numbers(&[view.x, view.y]), numbers(clip)),
        _ => format!("{} → {}", numbers(&world.to_array()), numbers(&view.to_array())),
    }
}

/// The meanings of the colours.
pub(in crate::views) fn rows(frame: &Frame, request: &Request, palette: Palette) -> Vec<LegendRow> {
    let Some(work) = &frame.work else { return Vec::new() };
    let ([color_in, color_out], labels) = (colors(palette), request.labels);
    let mut rows = Vec::new();
    let mut row = |there: bool, row: LegendRow| rows.extend(there.then_some(row));
    let lost = work.objects.iter().filter_map(|object| match object.containment {
        Containment::Outside(planes) => Some((object, planes)),
        Containment::Empty | Containment::Crosses(_) => None,
    });
    for (object, planes) in lost.take(MOST_NAMES) {
        let name = sanitize::escaped(&object.name);
        let text = format!("{}: {}", literal(&name), labels.outside_planes(planes));
        row(true, LegendRow::Title(LegendText::new(&object_label(&name), text), palette.soft));
    }
    row(!work.before.is_empty(), LegendRow::Swatch(color_in, LegendText::new(GOES_IN, labels.goes_in)));
    row(!work.dropped.is_empty(), LegendRow::Swatch(palette.back, LegendText::new("back-faces", labels.back_faces)));
    row(!work.after.is_empty(), LegendRow::Swatch(color_out, LegendText::new(COMES_OUT, labels.comes_out)));
    row(!work.cuts.is_empty(), LegendRow::Mark(MarkShape::Diamond, palette.cut, LegendText::new("cuts", labels.cuts)));
    let vertices = LegendText::new("vertices", format!("{} → {}", labels.goes_in, labels.comes_out));
    row(!work.vertices.is_empty(), LegendRow::Mark(MarkShape::Disc, color_out, vertices));
    row(work.more, LegendRow::Title(LegendText::new("not-all", labels.not_all), palette.soft));
    rows
}

/// Completes the half before the stage with the texts of the other one, and the line between the two.
pub(in crate::views) fn part(frame: &mut Frame, request: &Request) {
    let (Some(before), Some(work)) = (&mut frame.before, &frame.work) else { return };
    let drawing = &mut frame.drawing;
    if !matches!(work.stage, Stage::Lines | Stage::Write) {
        before.labels.clone_from(&drawing.labels);
    }
    let palette = Palette::of(request.shot.look.style.theme);
    let (middle, height, scale) = ((drawing.width / 2) as f32, drawing.height as f32, request.size.scale);
    let author = Author::of(request, palette);
    for drawing in [before, drawing] {
        let line = Area { corner: [middle - scale, 0.0], size: [2.0 * scale, height], radius: 0.0, fill: palette.ink };
        drawing.areas.push(line);
        let sides = [
            (GOES_IN, -6.0, Anchor::Right, request.labels.goes_in),
            (COMES_OUT, 6.0, Anchor::Left, request.labels.comes_out),
        ];
        for (name, aside, anchor, text) in sides {
            let label = Label {
                name: name.to_owned(),
                anchor,
                ..Label::new(
                    [middle + aside * scale, 14.0 * scale, 1.0],
                    text,
                    13.0 * scale,
                    [palette.ink, palette.paper],
                )
            };
            drawing.labels.extend(author.finished(label, &Author::page(request, DVec2::ZERO)).map(|(label, _)| label));
        }
    }
}

/// The name of the label of an object.
fn object_label(name: &str) -> String {
    format!("{OBJECT}{name}")
}

/// True for the names of labels of a stage, in a scene with these objects, as they're shown.
pub(in crate::views) fn is_label(name: &str, objects: &[String]) -> bool {
    let is_object = |name: &str| OWN.contains(&name) || objects.iter().any(|object| object == name);
    let is_number = |number: &str| number.parse().is_ok_and(|number: usize| (1..=MOST_NUMBERS).contains(&number));
    [GOES_IN, COMES_OUT].contains(&name)
        || name.strip_prefix(OBJECT).is_some_and(is_object)
        || name.strip_prefix(VERTEX).is_some_and(is_number)
}
