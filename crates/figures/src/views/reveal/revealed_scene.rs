//! The pipeline's inner work in the pictures: the scene of each, changed by `[reveal]`.

use std::borrow::Cow;
use std::sync::Arc;

use glam::{DMat4, DVec3};

use crate::appearance::{Dash, LEVEL_COLORS, MarkShape, Rgba, Shading, TextureReveal};
use crate::camera::{Camera, Ndc, Parameters, Projection, ViewWindow};
use crate::figure::Outside;
use crate::pipeline::canonical::{clipped_scene, displayed_ndc, legible_clipped_scene};
use crate::pipeline::clip_parts::{Parts, clip_parts};
use crate::pipeline::cull_result::{CullResult, cull_result};
use crate::pipeline::divide_before_clip::{DividedFirst, divided_first};
use crate::pipeline::{Frame, OverBudget, with_triangles};
use crate::scene::{Object, ObjectPaint, Scene};

use super::stage_overlay;
use crate::views::canonical::canonical_box::CanonicalBox;
use crate::views::pixels::PixelRect;
use crate::views::words::label_layout::Author;
use crate::views::words::label_obstacles::Box2;
use crate::views::words::legend::{Legend, LegendRow, LegendText};
use crate::views::world::gizmos::{AnnotationBuilder, SMALL_TYPE};
use crate::views::{Labels, Palette, Request};

/// Range in which parts outside the canonical volume are shown, in its own half sides.
pub(in crate::views) const REACH: f64 = 2.0;
/// More new vertices than this aren't marked one by one. The sides between them still are.
const MOST_MARKS: usize = 500;
/// Greatest number of dropped objects with their reason written on them.
const MOST_NAMES: usize = 24;
/// Share of the error colour in wrong faces. The rest is their own colour, so that objects can be distinguished.
const WRONG: f64 = 0.75;
/// The opacity of wrong parts. The right scene behind them is still visible.
const GLASS: u8 = 140;

/// The scene of a picture: its own, or that of the request, which isn't copied.
#[derive(Clone, Debug)]
pub(in crate::views) struct PipelineReveal<'a> {
    pub(in crate::views) scene: Cow<'a, Scene>,
    /// The meaning of its colours.
    pub(in crate::views) rows: Vec<LegendRow>,
    /// New vertices and the sides between them.
    cuts: Vec<DVec3>,
    sides: Vec<[DVec3; 2]>,
    /// Reasons, and their positions.
    names: Vec<(DVec3, String)>,
}

impl<'a> PipelineReveal<'a> {
    /// A scene without changes.
    pub(in crate::views) fn plain(scene: Cow<'a, Scene>) -> Self {
        Self { scene, rows: Vec::new(), cuts: Vec::new(), sides: Vec::new(), names: Vec::new() }
    }

    /// Draws the additions to the scene.
    pub(in crate::views) fn mark(&self, builder: &mut AnnotationBuilder, palette: Palette) {
        for side in &self.sides {
            builder.line(side.to_vec(), palette.cut, 1.6, Dash::Solid);
        }
        if self.cuts.len() <= MOST_MARKS {
            for &p in &self.cuts {
                builder.mark(p, MarkShape::Diamond, 3.4, palette.cut);
            }
        }
        for (p, name) in &self.names {
            builder.named("outside", *p, name, glam::DVec2::NEG_Y, SMALL_TYPE, palette.ink);
        }
    }

    fn note_cuts(&mut self, parts: &Parts, request: &Request, palette: Palette, place: impl Fn(DVec3) -> DVec3) {
        self.cuts = parts.cuts.iter().map(|&p| place(p)).collect();
        self.sides = parts.sides.iter().map(|side| side.map(&place)).collect();
        let meaning = LegendText::new("cuts", request.labels.cuts);
        self.rows.extend(match self.cuts.len() {
            0 => None,
            1..=MOST_MARKS => Some(LegendRow::Mark(MarkShape::Diamond, palette.cut, meaning)),
            _ => Some(LegendRow::Swatch(palette.cut, meaning)),
        });
    }
}

/// A legend of `rows` in a part of the picture, if there's space for one. `scale` is the number of pixels for one unit
/// of type size.
pub(in crate::views) fn legend(
    request: &Request,
    rows: Vec<LegendRow>,
    part: PixelRect,
    scale: f32,
    palette: Palette,
) -> Option<Legend> {
    let author = Author::of(request, palette);
    Legend::new(rows, part, scale, (palette, Some(&author)), request.size).filter(|_| !request.finish.bare)
}

/// The legend of a stage in a drawing, and its shortfalls.
pub(in crate::views) fn drawn_rows(drawn: &Frame, request: &Request, palette: Palette) -> Vec<LegendRow> {
    let mut rows = stage_overlay::rows(drawn, request, palette);
    let (name, what) = match &drawn.over_budget {
        None => return rows,
        Some(OverBudget::Pieces { .. } | OverBudget::Strokes) => ("not-split", request.labels.not_split),
        Some(OverBudget::Rounding { .. }) => ("rounded", request.labels.rounded),
    };
    rows.push(LegendRow::Title(LegendText::new(name, what), palette.wrong));
    rows
}

/// Draws the legend, and completes the display of a stage.
pub(in crate::views) fn explain(drawn: &mut Frame, request: &Request, legend: Option<&Legend>) {
    stage_overlay::part(drawn, request);
    for drawing in drawn.before.iter_mut().chain([&mut drawn.drawing]) {
        if let Some(legend) = legend {
            legend.draw(drawing);
        }
    }
}

/// The space that other texts leave to a legend.
pub(in crate::views) fn room(legend: Option<&Legend>) -> Option<Box2> {
    legend.map(Legend::place)
}

/// The scene of the world.
pub(in crate::views) fn in_world(request: &Request, palette: Palette) -> PipelineReveal<'_> {
    let reveal = request.shot.look.reveal;
    let edges_only = request.shot.look.style.shading == Shading::Wireframe;
    let mut revealed = PipelineReveal::plain(Cow::Borrowed(&*request.scene));
    let mut dropped = Scene::default();
    if reveal.culled {
        let (kept, gone) = culled(request, edges_only, palette, &mut revealed);
        revealed.scene.to_mut().objects = kept;
        dropped.objects = gone;
    }
    let parted = matches!(reveal.outside, Outside::Cut | Outside::Tinted);
    if parted || reveal.clipping {
        let parts = clip_parts(&revealed.scene, &request.camera, edges_only);
        if reveal.clipping {
            revealed.note_cuts(&parts, request, palette, |p| p);
        }
        if parted {
            revealed.scene = Cow::Owned(parts.inside);
        }
        if reveal.outside == Outside::Tinted {
            revealed.add_outside(parts.outside, request.labels, palette);
        }
    }
    if !dropped.objects.is_empty() {
        append(revealed.scene.to_mut(), glass(dropped, palette.dropped));
    }
    revealed.textures(request, palette);
    revealed
}

impl PipelineReveal<'_> {
    /// Moves it from the display space of the notes to that of a convention of NDC. If that's another one, it's named
    /// if the picture has space, because in a small one the name would cover the axes.
    fn move_into(&mut self, canonical: &CanonicalBox, request: &Request, palette: Palette) {
        const SMALL: f64 = 200.0;
        let (ndc, labels) = (canonical.ndc, request.labels);
        if ndc == Ndc::default() {
            return;
        }
        canonical.move_scene(self.scene.to_mut());
        let points = self.cuts.iter_mut().chain(self.sides.iter_mut().flatten());
        points.chain(self.names.iter_mut().map(|(p, _)| p)).for_each(|p| *p = canonical.place(*p));
        let side = f64::from(request.size.width.min(request.size.height));
        if side >= SMALL * f64::from(request.size.scale) {
            let hand = if ndc.is_right_handed() { labels.right_handed } else { labels.left_handed };
            let text = LegendText::new("ndc", format!("{}: {hand}", labels.ndc_title(ndc)));
            self.rows.insert(0, LegendRow::Title(text, palette.ink));
        }
    }

    /// Shows the inner work of texturing, if there are textures.
    fn textures(&mut self, request: &Request, palette: Palette) {
        let Some(reveal) = request.shot.look.reveal.texture else { return };
        let is_textured = |object: &Object| matches!(object.paint, ObjectPaint::Texture(_));
        if !self.scene.objects.iter().any(is_textured) {
            return;
        }
        let mut most = 0;
        for object in &mut self.scene.to_mut().objects {
            if let ObjectPaint::Texture(pictured) = &mut object.paint {
                pictured.sampler.reveal = Some(reveal);
                most = most.max(pictured.image.levels().len());
            }
        }
        let labels = request.labels;
        match reveal {
            TextureReveal::Affine => {
                self.rows.push(LegendRow::Warning(palette.wrong, LegendText::new("affine", labels.affine)));
            }
            TextureReveal::Levels => {
                self.rows.push(LegendRow::Title(LegendText::new("levels", labels.levels), palette.ink));
                let last = LEVEL_COLORS.len() - 1;
                for (k, color) in LEVEL_COLORS.into_iter().enumerate().take(most) {
                    let more = if k == last && most > LEVEL_COLORS.len() { "+" } else { "" };
                    self.rows.push(LegendRow::Swatch(color, LegendText::new("level", format!("{k}{more}"))));
                }
            }
            TextureReveal::Texels => {
                self.rows.push(LegendRow::Title(LegendText::new("texels", labels.texels), palette.ink));
            }
        }
    }

    fn add_outside(&mut self, outside: Scene, labels: &Labels, palette: Palette) {
        if !outside.objects.is_empty() || !outside.lines.is_empty() {
            self.rows.push(LegendRow::Swatch(palette.outside, LegendText::new("outside", labels.outside)));
        }
        append(self.scene.to_mut(), glass(outside, palette.outside));
    }
}

/// The scene of the canonical volume, in its display space.
pub(in crate::views) fn in_canonical<'a>(request: &'a Request, palette: Palette) -> PipelineReveal<'a> {
    let reveal = request.shot.look.reveal;
    let shading = request.shot.look.style.shading;
    let edges_only = shading == Shading::Wireframe;
    let beyond = matches!(reveal.outside, Outside::Tinted | Outside::Shown);
    let (divided, rows) = divide_first(request, if beyond { REACH } else { 1.0 }, palette).unzip();
    let right = divided.as_ref().map_or(&*request.scene, |divided| &divided.right);
    let clipped = legible_clipped_scene(right, &request.camera, shading);
    let mut revealed = PipelineReveal::plain(Cow::Owned(clipped));
    revealed.rows.extend(rows);
    if beyond || reveal.clipping {
        let parts = clip_parts(right, &request.camera, edges_only);
        if reveal.clipping {
            let shown = |p| displayed_ndc(&request.camera, p).unwrap_or_default().clamp(DVec3::NEG_ONE, DVec3::ONE);
            revealed.note_cuts(&parts, request, palette, shown);
        }
        if let Some(wider) = Wider::new(&request.camera).filter(|_| beyond) {
            let outside = Scene { lights: request.scene.lights.clone(), ..parts.outside };
            let outside = wider.show(&outside, shading);
            if reveal.outside == Outside::Tinted {
                revealed.add_outside(outside, request.labels, palette);
            } else {
                append(revealed.scene.to_mut(), outside);
            }
        }
    }
    if let Some(divided) = divided {
        append(revealed.scene.to_mut(), divided.wrong);
    }
    revealed.textures(request, palette);
    revealed.move_into(&CanonicalBox::of(request), request, palette);
    revealed
}

/// The scene of the image, in the world and in the display space of the canonical volume, whose front is the image.
pub(in crate::views) fn in_image(request: &Request, palette: Palette) -> (PipelineReveal<'_>, Option<Scene>) {
    let reveal = request.shot.look.reveal;
    let (divided, rows) = divide_first(request, 1.0, palette).unzip();
    let (right, wrong) = match divided {
        None => (Cow::Borrowed(&*request.scene), None),
        Some(divided) => (Cow::Owned(divided.right), Some(divided.wrong)),
    };
    let mut revealed = PipelineReveal::plain(right);
    revealed.rows.extend(rows);
    if reveal.clipping {
        let edges_only = request.shot.look.style.shading == Shading::Wireframe;
        let parts = clip_parts(&revealed.scene, &request.camera, edges_only);
        // A hair inwards, so that rounding doesn't leave a new vertex outside the plane that it's in.
        let middle = request.camera.volume_corners().iter().fold(DVec3::ZERO, |sum, &p| sum + p / 8.0);
        revealed.note_cuts(&parts, request, palette, |p| p + (middle - p) * 1e-9);
    }
    revealed.textures(request, palette);
    (revealed, wrong)
}

/// The camera that looks at the canonical volume from its front, so that it sees the image.
pub(in crate::views) fn front() -> Option<Camera> {
    let parameters = Parameters {
        position: DVec3::Z * 2.0,
        focal_point: DVec3::ZERO,
        view_up: DVec3::Y,
        projection: Projection::Parallel,
        near: 1.0,
        far: 3.0,
        window: Some(ViewWindow { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 }),
        ..Parameters::default()
    };
    Camera::new(&parameters).ok()
}

/// Divides before clipping, if the figure reveals that, and explains it.
fn divide_first(request: &Request, reach: f64, palette: Palette) -> Option<(DividedFirst, LegendRow)> {
    if !request.shot.look.reveal.divide_first {
        return None;
    }
    let mut divided = divided_first(&request.scene, &request.camera, reach);
    let (labels, edges_only) = (request.labels, request.shot.look.style.shading == Shading::Wireframe);
    let said = |what| LegendText::new("divided-first", format!("{}: {what}", labels.divided_first));
    let row = if divided.is_right() {
        LegendRow::Title(said(labels.no_difference), palette.ink)
    } else {
        LegendRow::Warning(palette.wrong, said(labels.wrong))
    };
    let Scene { objects, lines, marks, .. } = &mut divided.wrong;
    for object in objects {
        let tinted = |colors: &[Rgba]| Arc::new(colors.iter().map(|c| mixed(*c, palette.wrong)).collect());
        object.paint = match &object.paint {
            _ if edges_only => ObjectPaint::Solid(palette.wrong),
            ObjectPaint::Solid(color) => ObjectPaint::Solid(mixed(*color, palette.wrong)),
            ObjectPaint::Faces(colors) => ObjectPaint::Faces(tinted(colors)),
            ObjectPaint::Vertices(colors) => ObjectPaint::Vertices(tinted(colors)),
            // A picture can't be mixed with a colour.
            ObjectPaint::Texture(_) => ObjectPaint::Solid(mixed(Rgba::rgb(128, 128, 128), palette.wrong)),
        };
        if let Some(edges) = &mut object.edges {
            edges.color = palette.wrong;
        }
    }
    lines.iter_mut().for_each(|line| line.style.color = palette.wrong);
    marks.iter_mut().for_each(|mark| mark.color = palette.wrong);
    Some((divided, row))
}

fn mixed(own: Rgba, with: Rgba) -> Rgba {
    #[expect(clippy::cast_possible_truncation, reason = "a mean of two bytes")]
    let mix = |a: u8, b: u8| (f64::from(a) * (1.0 - WRONG) + f64::from(b) * WRONG).round() as u8;
    Rgba::rgba(mix(own.r, with.r), mix(own.g, with.g), mix(own.b, with.b), GLASS)
}

/// The objects that are kept, with back faces in their colour, and those that are dropped.
fn culled(
    request: &Request,
    edges_only: bool,
    palette: Palette,
    revealed: &mut PipelineReveal,
) -> (Vec<Object>, Vec<Object>) {
    let open = matches!(request.shot.look.reveal.outside, Outside::Cut | Outside::Tinted);
    let (mut kept, mut dropped) = (Vec::new(), Vec::new());
    let mut turned = false;
    for object in &request.scene.objects {
        match cull_result(object, &request.camera) {
            CullResult::Dropped(planes) => {
                if let Some(bounds) = object.bounds().filter(|_| dropped.len() < MOST_NAMES) {
                    revealed.names.push((bounds.center(), request.labels.outside_planes(planes)));
                }
                dropped.push(object.clone());
            }
            CullResult::BackFaces(back) if object.faces && !edges_only && back.contains(&true) => {
                turned = true;
                let [front, back] = parted(object, &back, palette.back);
                kept.extend([front, back].map(|part| Object { two_sided: part.two_sided || open, ..part }));
            }
            CullResult::BackFaces(_) | CullResult::Kept => kept.push(object.clone()),
        }
    }
    if turned {
        let text = LegendText::new("back-faces", request.labels.back_faces);
        revealed.rows.push(LegendRow::Swatch(palette.back, text));
    }
    if !dropped.is_empty() {
        let text = LegendText::new("dropped", request.labels.dropped);
        revealed.rows.push(LegendRow::Swatch(palette.dropped, text));
    }
    (kept, dropped)
}

/// An object in two: its front faces with its edges and its outline, and its back faces in one colour.
fn parted(object: &Object, back: &[bool], color: Rgba) -> [Object; 2] {
    let of = |side: bool| -> Vec<u32> { (0..).zip(back).filter(|(_, b)| **b == side).map(|(i, _)| i).collect() };
    let (fronts, backs) = (of(false), of(true));
    [
        with_triangles(object, &fronts, object.mesh.edges.clone(), object.mesh.adjacency.edges.clone()),
        Object {
            paint: ObjectPaint::Solid(color),
            lit: false,
            edges: None,
            outline: None,
            ..with_triangles(object, &backs, Vec::new(), Vec::new())
        },
    ]
}

/// A scene of coloured glass, without light, so that it has the one colour of its legend.
fn glass(mut scene: Scene, color: Rgba) -> Scene {
    let strong = color.with_alpha(255);
    for object in &mut scene.objects {
        object.paint = ObjectPaint::Solid(color);
        (object.lit, object.in_world) = (false, None);
        object.two_sided = true;
        for style in [&mut object.edges, &mut object.outline].into_iter().flatten() {
            style.color = strong;
        }
    }
    scene.lines.iter_mut().for_each(|line| line.style.color = strong);
    scene.marks.iter_mut().for_each(|mark| mark.color = strong);
    scene.texts.iter_mut().for_each(|text| text.color = strong);
    scene
}

fn append(scene: &mut Scene, more: Scene) {
    scene.objects.extend(more.objects);
    scene.lines.extend(more.lines);
    scene.marks.extend(more.marks);
    scene.texts.extend(more.texts);
}

/// A camera that sees more, whose canonical volume is a box around that of the other.
struct Wider {
    camera: Camera,
    /// From its display space to that of the other camera.
    from_wider: DMat4,
}

impl Wider {
    /// Sees [`REACH`] times as much in each direction of NDC, as far as there is anything in front of the eye. `None`
    /// if that isn't a camera.
    fn new(camera: &Camera) -> Option<Self> {
        let (f, b) = (camera.near(), camera.far());
        let (near, far) = match camera.projection() {
            // From z_n = (B + F)/(B − F) − 2 F B/((B − F) d).
            Projection::Perspective => {
                let rest = (b + f) - REACH * (b - f);
                let far = if rest > 0.0 { 2.0 * f * b / rest } else { f64::INFINITY };
                (2.0 * f * b / ((b + f) + REACH * (b - f)), far.min(1e4 * b))
            }
            Projection::Parallel => {
                let (middle, half) = ((f + b) / 2.0, (b - f) / 2.0);
                ((middle - REACH * half).max(1e-3 * f), middle + REACH * half)
            }
        };
        let window = camera.window();
        let scale = if camera.projection() == Projection::Perspective { near / f } else { 1.0 };
        let side = |low: f64, high: f64| {
            let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
            [scale * (middle - REACH * half), scale * (middle + REACH * half)]
        };
        let ([left, right], [bottom, top]) = (side(window.left, window.right), side(window.bottom, window.top));
        let window = Some(ViewWindow { left, right, bottom, top });
        let camera = Camera::new(&Parameters { near, far, window, ..*camera.parameters() }).ok()?;
        // The depth p of the display list is affine in 1/d (in d without perspective), so one is affine in the other.
        let (a, c) = match camera.projection() {
            Projection::Perspective => (f / (b - f) * (b / near - b / far), f / (b - f) * (b / far - 1.0)),
            Projection::Parallel => ((far - near) / (b - f), (b - far) / (b - f)),
        };
        let scale = DMat4::from_scale(DVec3::new(REACH, REACH, a));
        Some(Self { camera, from_wider: DMat4::from_translation(DVec3::Z * (a + 2.0 * c - 1.0)) * scale })
    }

    /// A scene clipped to this camera's volume, in the display space of the other.
    fn show(&self, scene: &Scene, shading: Shading) -> Scene {
        let mut shown = clipped_scene(scene, &self.camera, shading);
        let place = |p: &mut DVec3| *p = self.from_wider.transform_point3(*p);
        shown.objects.iter_mut().for_each(|object| object.world_from_object = self.from_wider);
        shown.lines.iter_mut().flat_map(|line| &mut line.points).for_each(place);
        shown.marks.iter_mut().for_each(|mark| place(&mut mark.position));
        shown.texts.iter_mut().for_each(|text| place(&mut text.position));
        shown
    }
}
