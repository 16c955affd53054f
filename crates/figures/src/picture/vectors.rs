//! Pictures as pages of vectors, from the same display list as for pixels, with the visible parts of strokes computed
//! exactly instead of pixel by pixel.

use std::sync::Arc;

use glam::DVec2;
use tiny_skia::Pixmap;

use super::compared::Differences;
use super::error::PictureError;
use super::plate::{Plate, Plates};
use super::renderer::labels_of;
use super::vector_faces::{Pictures, can_be_written, faces_of, polygon};
use super::{Composite, Pixels, Renderer};
use crate::appearance::{DepthFormat, LineStyle, Occlusion, Rgba, TextureReveal, head_corners};
use crate::drawing::{Drawing, Label, single};
use crate::export::vector::{Item, Page, PageText};
use crate::figure::{Reveal, ShadowReveal};
use crate::limits::MAX_PIXELS;
use crate::pipeline::stroke_order::painted_runs;
use crate::pipeline::stroke_runs::{Run, occlusions};
use crate::pipeline::{Output, OverBudget};
use crate::progress::{Activity, Progress, at_once};
use crate::raster::{FADED, HALO, Rasterizer, area_outline, baseline, mark_layers, mark_outline};
use crate::text::Element;
use crate::views::{LabelPlace, Request, Side, Size, overlay};

crate::listed! {
    /// The form of the faces of a page.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub enum Faces {
        /// As areas if these show the same as the pixels, in a number that programs can handle. Faces with a picture on
        /// them, such as the window, are pictures among them. Otherwise as one picture.
        #[default]
        Auto = "auto",
        /// As areas.
        Areas = "vector",
        /// As one picture, under all strokes.
        Picture = "picture",
    }
    /// Its name on the command line.
    pub fn name
}

/// The most triangles that are written as areas unless the user asks for areas.
const MOST_AREAS: usize = 5000;
/// Length of a dot, because some programs leave out a dash of zero length.
const DOT: f32 = 0.01;

/// The reason why a page has its faces as a picture, although areas were requested.
#[derive(Clone, Debug, PartialEq)]
pub enum NoAreas {
    /// Colours that vary over a face: light at vertices or pixels, textures in too many parts.
    Shaded,
    /// Faces intersect too often to be sorted.
    OverBudget(OverBudget),
    /// Only the first faces are shown, in the order in which a depth buffer gets them.
    Partial,
}

/// A page, and its shortfalls.
pub(super) struct Drawn {
    /// The page, without title and description.
    pub page: Page,
    /// A shortfall of a picture.
    pub over_budget: Option<OverBudget>,
    /// The reason why some faces are a picture.
    pub no_areas: Option<NoAreas>,
}

/// Pictures that have been drawn, with the number of pixels of their faces per unit, so that equal ones are drawn once.
pub(super) type KnownPictures = Vec<(u32, Request, Arc<Vec<Item>>)>;

/// The page of a sheet. `per_inch` is the number of units of the page per inch of paper, and `dpi` the resolution of
/// faces that are pictures, at least that of the sheet.
///
/// # Errors
/// [`PictureError::TooLarge`], and [`PictureError::Strokes`] if the visible parts of strokes can't be computed.
pub(super) async fn page(
    sheet: &Composite,
    (faces, known): (Faces, &mut KnownPictures),
    [per_inch, dpi]: [f64; 2],
    crop: bool,
    progress: &Progress,
) -> Result<Drawn, PictureError> {
    let mut painter = FacePainter { faces, finer: finer(sheet, dpi / per_inch), ..FacePainter::default() };
    let (mut pictures, mut parts) = (Vec::new(), Vec::new());
    // The steps below are pictures, not the rows of each.
    painter.renderer.watch(&progress.part());
    progress.begin(Activity::Painting, sheet.requests.len());
    for request in &sheet.requests {
        let same = known.iter().find(|(finer, other, _)| *finer == painter.finer && other == request);
        let items = match same {
            Some((.., items)) => Arc::clone(items),
            None => {
                let items = Arc::new(painter.picture(request)?);
                known.push((painter.finer, request.clone(), Arc::clone(&items)));
                items
            }
        };
        if progress.is_cancelled() {
            return Err(PictureError::Cancelled);
        }
        progress.advance_and_pause(1).await;
        let Size { width, height, .. } = request.size;
        let part = if crop { painter.content(request, sheet.gap)? } else { [0, 0, width, height] };
        parts.push(part);
        pictures.push(items);
    }
    let parts = if crop { sheet.kept(parts) } else { parts };
    let sizes: Vec<[u32; 2]> = parts.iter().map(|part| [part[2], part[3]]).collect();
    let layout = sheet.layout(&sizes, crop).ok_or(PictureError::TooLarge)?;
    let size = layout.size.map(unit);
    let mut items = Vec::new();
    if (pictures.len() > 1 || sheet.grid.is_some()) && sheet.ground.a > 0 {
        items.push(rectangle([0.0, 0.0, size[0], size[1]], sheet.ground));
    }
    for ((part, own), corner) in parts.iter().copied().zip(pictures).zip(&layout.corners) {
        let [left, top, width, height] = part.map(unit);
        let corner = [unit(corner[0]) - left, unit(corner[1]) - top];
        items.push(Item::shared(corner, [left, top, left + width, top + height], own));
    }
    for (corner, strip) in sheet.strips(&layout, &sizes) {
        let clip = [0.0, 0.0, unit(strip.width), unit(strip.height)];
        items.push(Item::group(corner.map(unit), clip, over_faces(&strip)?));
    }
    #[expect(clippy::cast_possible_truncation, reason = "points of a page")]
    let points = (72.0 / per_inch) as f32;
    let page = Page { size, points, title: String::new(), description: String::new(), language: "en", items };
    Ok(Drawn { page, over_budget: painter.over_budget, no_areas: painter.no_areas })
}

/// The whole number of pixels along each side of a pixel of the sheet, within the limit of a picture.
fn finer(sheet: &Composite, wanted: f64) -> u32 {
    let largest = sheet.requests.iter().map(|request| u64::from(request.size.width) * u64::from(request.size.height));
    let largest = largest.max().unwrap_or(1).max(1);
    let fits = |times: &u32| largest * u64::from(*times) * u64::from(*times) <= MAX_PIXELS;
    (1..=8)
        .take_while(fits)
        .find(|times| f64::from(*times) >= wanted - 0.01)
        .unwrap_or_else(|| (1..=8).take_while(fits).last().unwrap_or(1))
}

#[derive(Default)]
struct FacePainter {
    faces: Faces,
    /// Pixels of a picture of faces, per unit.
    finer: u32,
    renderer: Renderer,
    rasterizer: Rasterizer,
    over_budget: Option<OverBudget>,
    no_areas: Option<NoAreas>,
    /// Those of the last picture, in its pixels.
    labels: Vec<LabelPlace>,
}

impl FacePainter {
    /// The items of a picture; for a compared one, those of both sides.
    fn picture(&mut self, request: &Request) -> Result<Vec<Item>, PictureError> {
        let Some(sides) = request.sides() else { return self.one(request) };
        let differences = self.differences(request, &sides)?;
        let (mut items, mut labels) = (Vec::new(), [Vec::new(), Vec::new()]);
        for (side, labels) in sides.iter().zip(&mut labels) {
            let mut inner = self.one(&side.request)?;
            *labels = std::mem::take(&mut self.labels);
            if let Some(differences) = &differences {
                let size = [side.request.size.width, side.request.size.height].map(unit);
                let pixels = differences.marks(side).ok_or(PictureError::TooLarge)?;
                inner.push(Item::Picture { corner: [0.0; 2], size, pixels });
            }
            let left = unit(side.left);
            let [from, to] = [side.columns.start, side.columns.end].map(|column| unit(column) - left);
            let clip = [from, 0.0, to, unit(request.size.height)];
            items.push(Item::group([left, 0.0], clip, inner));
        }
        let share = differences.and_then(|_| at_once(self.renderer.share_that_differs(&sides)));
        let over = overlay(request, &sides, &labels_of(labels, &sides), share).ok_or(PictureError::TooLarge)?;
        items.extend(over_faces(&over)?);
        Ok(items)
    }

    /// The differing pixels of a comparison that marks them, taken from the same picture made of pixels.
    fn differences(&mut self, request: &Request, sides: &[Side; 2]) -> Result<Option<Differences>, PictureError> {
        if !request.shot.compared.as_ref().is_some_and(|compared| compared.comparison.differences) {
            return Ok(None);
        }
        let mut pictures = [Pixels::default(), Pixels::default()];
        for (side, picture) in sides.iter().zip(&mut pictures) {
            *picture = self.renderer.pixels(&side.request).ok_or(PictureError::TooLarge)?;
        }
        Ok(Differences::marked(request, &pictures))
    }

    /// The items of a picture in which nothing is compared.
    fn one(&mut self, request: &Request) -> Result<Vec<Item>, PictureError> {
        let Plates { plates, over_budget } = self.renderer.plates(request).ok_or(PictureError::TooLarge)?;
        self.over_budget = self.over_budget.take().or(over_budget);
        self.labels = plates.iter().flat_map(|plate| LabelPlace::all(&plate.drawing)).collect();
        let finer = if shows_pixels(request) { 1 } else { self.finer };
        let mut others = OtherVersions { request, finer, sorted: None, larger: None };
        let mut items = Vec::new();
        for (k, Plate { drawing, columns }) in plates.iter().enumerate() {
            let inner = self.plate(drawing, k, &mut others)?;
            if k == 0 {
                items = inner;
                continue;
            }
            let clip = [unit(columns.start), 0.0, unit(columns.end), unit(drawing.height)];
            items.push(Item::group([0.0; 2], clip, inner));
        }
        Ok(items)
    }

    /// The items of a plate of a picture, given its place among the plates.
    fn plate(
        &mut self,
        drawing: &Drawing,
        place: usize,
        others: &mut OtherVersions,
    ) -> Result<Vec<Item>, PictureError> {
        let size = [drawing.width, drawing.height].map(unit);
        let mut items = Vec::new();
        if drawing.background.a > 0 {
            items.push(rectangle([0.0, 0.0, size[0], size[1]], drawing.background));
        }
        if drawing.surfaces.iter().any(|surface| !surface.triangles.is_empty()) {
            match self.areas(drawing, place, others) {
                Some(areas) => items.extend(areas),
                None => {
                    let larger = others.larger(&mut self.renderer).and_then(|plates| plates.plates.get(place));
                    let larger = larger.ok_or(PictureError::TooLarge)?;
                    items.push(faces_as_picture(&larger.drawing, size, &mut self.rasterizer)?);
                }
            }
        }
        items.extend(over_faces(drawing)?);
        Ok(items)
    }

    /// The faces as areas, from back to front; `None` if they have to be a picture.
    fn areas(&mut self, drawing: &Drawing, place: usize, others: &mut OtherVersions) -> Option<Vec<Item>> {
        if self.faces == Faces::Picture {
            return None;
        }
        let is_asked = self.faces == Faces::Areas;
        let say = |why: NoAreas, no_areas: &mut Option<NoAreas>| {
            if is_asked && no_areas.is_none() {
                *no_areas = Some(why);
            }
        };
        let triangles: usize = drawing.surfaces.iter().map(|surface| surface.triangles.len()).sum();
        if !drawing.surfaces.iter().all(can_be_written) || drawing.depth_format != DepthFormat::Float {
            say(NoAreas::Shaded, &mut self.no_areas);
            return None;
        }
        if !is_asked && triangles > MOST_AREAS {
            return None;
        }
        let finer = others.finer;
        let mut ordered = drawing;
        if !drawing.painted_in_order {
            if others.request.shot.show.painted.is_some() {
                // From back to front, the first faces would be different ones.
                say(NoAreas::Partial, &mut self.no_areas);
                return None;
            }
            let sorted = others.sorted(&mut self.renderer)?;
            ordered = &sorted.plates.get(place)?.drawing;
            if let Some(over_budget) = sorted.over_budget.clone().filter(|_| !ordered.painted_in_order) {
                say(NoAreas::OverBudget(over_budget), &mut self.no_areas);
                return None;
            }
            let count: usize = ordered.surfaces.iter().map(|surface| surface.triangles.len()).sum();
            if !ordered.painted_in_order || (!is_asked && count > 2 * MOST_AREAS) {
                return None;
            }
        }
        let items = faces_of(ordered, &mut Pictures { finer, rasterizer: &mut self.rasterizer });
        if items.is_none() {
            say(NoAreas::Shaded, &mut self.no_areas);
        }
        items
    }

    /// The part of a picture that isn't empty: left, top, width and height in pixels.
    fn content(&mut self, request: &Request, margin: u32) -> Result<[u32; 4], PictureError> {
        let mut pixels = self.renderer.pixels(request).ok_or(PictureError::TooLarge)?;
        let pixmap: Pixmap = pixels.take_pixmap().ok_or(PictureError::TooLarge)?;
        Ok(crate::export::crop::part(&pixmap, margin))
    }
}

/// True for a picture that shows something as wide as its pixels, because with more of them it would be another
/// picture.
fn shows_pixels(request: &Request) -> bool {
    let Reveal { texture, shadows, cost, .. } = request.shot.look.reveal;
    cost.is_some()
        || matches!(texture, Some(TextureReveal::Levels | TextureReveal::Texels))
        || shadows == Some(ShadowReveal::Acne)
}

/// Other versions of a picture, each made when a plate of it needs one.
struct OtherVersions<'a> {
    request: &'a Request,
    finer: u32,
    sorted: Option<Plates>,
    larger: Option<Plates>,
}

impl OtherVersions<'_> {
    /// With its faces listed from back to front.
    fn sorted(&mut self, renderer: &mut Renderer) -> Option<&Plates> {
        if self.sorted.is_none() {
            self.sorted = renderer.plates(&Request { output: Output::Vectors, ..self.request.clone() });
        }
        self.sorted.as_ref()
    }

    /// With more pixels.
    fn larger(&mut self, renderer: &mut Renderer) -> Option<&Plates> {
        if self.larger.is_none() {
            let Size { width, height, scale } = self.request.size;
            let factor = self.finer as f32;
            let size = Size { width: width * self.finer, height: height * self.finer, scale: scale * factor };
            self.larger = renderer.plates(&Request { size, ..self.request.clone() });
        }
        self.larger.as_ref()
    }
}

/// Only the faces of a drawing, as pixels without a background. `size` is that on the page.
fn faces_as_picture(drawing: &Drawing, size: [f32; 2], rasterizer: &mut Rasterizer) -> Result<Item, PictureError> {
    let alone = Drawing {
        background: drawing.background.with_alpha(0),
        strokes: Vec::new(),
        areas: Vec::new(),
        marks: Vec::new(),
        labels: Vec::new(),
        ..drawing.clone()
    };
    let pixels = rasterizer.paint(&alone).ok_or(PictureError::TooLarge)?;
    let per_pixel = [size[0] / unit(pixels.width()), size[1] / unit(pixels.height())];
    let (pixels, corner) = crate::export::crop::cropped(pixels, 1);
    let scaled = |[x, y]: [u32; 2]| [per_pixel[0] * unit(x), per_pixel[1] * unit(y)];
    Ok(Item::Picture { corner: scaled(corner), size: scaled([pixels.width(), pixels.height()]), pixels })
}

/// A coordinate of pixels.
fn unit(pixels: u32) -> f32 {
    pixels as f32
}

fn rectangle([left, top, right, bottom]: [f32; 4], color: Rgba) -> Item {
    Item::Fill { path: polygon(&[[left, top], [right, top], [right, bottom], [left, bottom]]), color }
}

/// Strokes, areas, marks and texts, in the order of the display list.
fn over_faces(drawing: &Drawing) -> Result<Vec<Item>, PictureError> {
    let mut items = strokes(drawing)?;
    for area in &drawing.areas {
        items.push(Item::Fill { path: area_outline(area), color: area.fill });
    }
    let places: Vec<[f32; 3]> = drawing
        .marks
        .iter()
        .map(|mark| mark.position)
        .chain(drawing.labels.iter().map(|label| label.position))
        .collect();
    let behind = occlusions(drawing, places).map_err(|_| PictureError::Strokes)?;
    let (of_marks, of_labels) = behind.split_at(drawing.marks.len().min(behind.len()));
    for (mark, behind) in drawing.marks.iter().zip(of_marks) {
        let fades = mark.fade_if_hidden && *behind != Occlusion::None;
        let path = mark_outline(mark);
        if path.is_empty() {
            continue;
        }
        for layer in mark_layers(mark) {
            let color = faded(layer.color, fades);
            items.push(match layer.stroke {
                Some(width) => Item::stroke(path.clone(), color, width, false),
                None => Item::Fill { path: path.clone(), color },
            });
        }
    }
    for (label, behind) in drawing.labels.iter().zip(of_labels) {
        let fades = label.fade_if_hidden && *behind == Occlusion::Opaque;
        let at = baseline(label);
        if label.text.trim().is_empty()
            || !at.iter().all(|v| v.is_finite())
            || !(label.size.is_finite() && label.size > 0.0)
        {
            continue;
        }
        let [color, halo] = [label.color, label.halo].map(|color| faded(color, fades));
        let (text, halo_width) = (label.text.clone(), HALO * label.size);
        let Label { mathematical, size, anchor, .. } = *label;
        items.push(Item::Text(PageText { at, text, mathematical, size, color, halo, halo_width, anchor }));
    }
    Ok(items)
}

fn faded(color: Rgba, fades: bool) -> Rgba {
    #[expect(clippy::cast_possible_truncation, reason = "a share of a byte")]
    let alpha = (f32::from(color.a) * FADED).round() as u8;
    if fades { color.with_alpha(alpha) } else { color }
}

/// The painted runs of strokes, with consecutive ones of the same look as one path.
fn strokes(drawing: &Drawing) -> Result<Vec<Item>, PictureError> {
    let mut items: Vec<Item> = Vec::new();
    for run in painted_runs(drawing).map_err(|_| PictureError::Strokes)? {
        let Some(style) = run.style(drawing) else { continue };
        let length = length_of(drawing, &run);
        let head = style.head_length(length);
        // The shaft ends a little inside the head, because the head's point would be blunt otherwise.
        let points = until(&run.points, length - 0.8 * head - run.start);
        if points.len() > 1 {
            push_stroke(&mut items, &points, &run, style);
        }
        if head > 0.0 && run.has_end {
            items.extend(
                head_of(drawing, &run, head).map(|corners| Item::Fill { path: polygon(&corners), color: style.color }),
            );
        }
    }
    Ok(items)
}

fn push_stroke(items: &mut Vec<Item>, points: &[[f32; 2]], run: &Run, style: LineStyle) {
    let (lengths, period) = style.dash_lengths();
    let dashes: Vec<f32> = lengths.iter().map(|length| length.max(DOT)).collect();
    let phase = if dashes.is_empty() { 0.0 } else { (run.start - 0.5 * style.width).rem_euclid(period) };
    let mut own: Vec<Element> = points.iter().map(|point| Element::Line(*point)).collect();
    own[0] = Element::Move(points[0]);
    match items.last_mut() {
        // One path covers each place once, however often it crosses it.
        Some(Item::Stroke { path, color, width, dashes: same, .. })
            if *color == style.color && *width == style.width && same.is_empty() && dashes.is_empty() =>
        {
            path.extend(own);
        }
        _ => items.push(Item::Stroke { path: own, color: style.color, width: style.width, dashes, phase, round: true }),
    }
}

/// The points of the polyline that a run is a part of.
fn polyline<'a>(drawing: &'a Drawing, run: &Run) -> &'a [[f32; 3]] {
    let set = drawing.strokes.get(run.set);
    let points = set.and_then(|set| {
        let range = set.polylines.get(run.polyline)?;
        set.points.get(range.start as usize..range.end as usize)
    });
    points.unwrap_or_default()
}

fn between(a: &[f32], b: &[f32]) -> f32 {
    single(DVec2::new(f64::from(b[0]) - f64::from(a[0]), f64::from(b[1]) - f64::from(a[1])).length())
}

fn length_of(drawing: &Drawing, run: &Run) -> f32 {
    polyline(drawing, run).windows(2).map(|pair| between(&pair[0], &pair[1])).sum()
}

/// The points of a run up to a length along it.
fn until(points: &[[f32; 3]], length: f32) -> Vec<[f32; 2]> {
    let mut kept: Vec<[f32; 2]> = Vec::with_capacity(points.len());
    let mut left = length;
    for pair in points.windows(2) {
        let [from, to] = [[pair[0][0], pair[0][1]], [pair[1][0], pair[1][1]]];
        if left <= 0.0 {
            break;
        }
        if kept.is_empty() {
            kept.push(from);
        }
        let step = between(&from, &to);
        if step > left {
            let share = left / step;
            kept.push([from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);
            break;
        }
        kept.push(to);
        left -= step;
    }
    kept
}

/// The corners of the arrow head at the end of a run's polyline.
fn head_of(drawing: &Drawing, run: &Run, head: f32) -> Option<[[f32; 2]; 3]> {
    let points = polyline(drawing, run);
    let tip = points.last()?;
    let length = length_of(drawing, run);
    let base = until(points, length - head).last().copied()?;
    Some(head_corners([[tip[0], tip[1]], base]))
}
