//! **Lines**: edges, outlines, lines, marks and texts over the finished surfaces.
//!
//! *Notes*: `[3]` §1.2 has the wireframe model as one way of showing an object; lines, marks and texts of the world are
//! ours. *Textbook*: clip each segment (Cohen and Sutherland), project its ends, draw it pixel by pixel (Bresenham).
//! *Here*: clipped by the clipper of the faces, in homogeneous coordinates too, and projected like every vertex, but
//! not onto the grid of the image: a stroke has a width of its own and no neighbour to agree with. The vertices of a
//! mesh are projected once for all its edges. Strokes of one style are collected in one set, and the hidden parts are
//! found pixel by pixel, or exactly for vectors ([`stroke_runs`](crate::pipeline::stroke_runs)).

use std::ops::Range;

use glam::DVec3;

use super::clip::Clipper;
use super::vertex::{clip_from_view, clip_from_world, divide, unsnapped, viewport};
use super::vertices::{OnImage, Snap, Vertices, Wanted};
use crate::appearance::{HiddenLines, LineStyle, Rgba, Role, Shading, Style};
use crate::drawing::{Label, Mark, StrokeSet};
use crate::pipeline::Target;
use crate::pipeline::mesh::outline::outline;
use crate::pipeline::mesh::{CHUNK, each};
use crate::pipeline::scenes::Scenes;
use crate::pipeline::space::depths::InView;
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{ClipPoint, NOT_A_NUMBER, Screen, ViewPoint, WorldPoint, outcode};
use crate::scene::{Object, ObjectPaint};

/// The range of distances at which lines, marks and texts of the scene are in the volume.
pub(crate) fn in_view(scenes: Scenes, projector: &Projector) -> InView {
    let clip = |p: DVec3| clip_from_world(projector, WorldPoint(p));
    let mut clipper = Clipper::default();
    let segments = scenes.lines().flat_map(|line| line.points.windows(2));
    let lines = segments
        .filter_map(|ends| clipper.segment(projector, [clip(ends[0]), clip(ends[1])]))
        .flat_map(|ends| ends.map(|(p, _)| p.distance));
    let points = scenes.marks().map(|mark| mark.position).chain(scenes.texts().map(|text| text.position));
    let points = points.map(clip).filter(|&p| outcode(projector, p) == 0).map(|p| p.distance);
    lines.chain(points).fold(InView::NOTHING, |all, depth| all.and(InView::between(depth, depth)))
}

/// Draws the edges and the outline of an object. Returns the number of points transformed for them.
pub(crate) fn object_lines(strokes: &mut Strokes, object: &Object, vertices: &Vertices, style: &Style) -> usize {
    strokes.edges(object, vertices, style) + strokes.outline(object, vertices, style)
}

/// Draws the lines of the world. Returns the marks and the texts that are in view.
pub(crate) fn lines(strokes: &mut Strokes, scenes: Scenes, style: &Style) -> (Vec<Mark>, Vec<Label>) {
    strokes.lines(scenes, style);
    (strokes.marks(scenes), strokes.labels(scenes))
}

/// Collects strokes. Strokes that follow each other in the same style become one set. The order of styles is that of
/// the lines.
pub(crate) struct Strokes<'a> {
    projector: &'a Projector,
    screen: &'a Screen,
    scale: f32,
    /// Pixels for one unit of strokes of the scene, and of marks.
    fine: f32,
    background: Rgba,
    clipper: Clipper,
    /// The role of the next strokes.
    role: Role,
    pub(crate) sets: Vec<StrokeSet>,
    /// Number of requested edges, polylines of outlines, lines, marks and texts.
    pub(crate) asked: usize,
}

impl<'a> Strokes<'a> {
    pub(crate) fn new(projector: &'a Projector, screen: &'a Screen, target: Target, fineness: f32) -> Self {
        Self {
            projector,
            screen,
            scale: target.scale,
            fine: target.scale * fineness,
            background: target.background,
            clipper: Clipper::default(),
            role: Role::Content,
            sets: Vec::new(),
            asked: 0,
        }
    }

    /// A polyline through points of view space, `scale` pixels for one unit of its style. Where it leaves the volume it
    /// ends, and where it comes back another begins. An arrow head stays only at the true end.
    fn polyline(&mut self, points: impl IntoIterator<Item = ViewPoint>, style: LineStyle, scale: f32) {
        let style = LineStyle { width: style.width * scale, ..style };
        let mut points = points.into_iter().map(|p| clip_from_view(self.projector, p)).peekable();
        let Some(mut from) = points.next() else { return };
        let mut run: Vec<[f32; 3]> = Vec::new();
        let projector = self.projector;
        while let Some(to) = points.next() {
            let Some([(a, _), (b, cut)]) = self.clipper.segment(projector, [from, to]) else {
                self.flush(&mut run, style, false);
                from = to;
                continue;
            };
            if run.is_empty() {
                run.push(self.point(a));
            }
            run.push(self.point(b));
            if cut || points.peek().is_none() {
                self.flush(&mut run, style, !cut);
            }
            from = to;
        }
        self.flush(&mut run, style, false);
    }

    /// The edges of an object. Returns the number of points transformed: each vertex once if edges share it, and
    /// the ends of those that cross a plane once more.
    fn edges(&mut self, object: &Object, vertices: &Vertices, style: &Style) -> usize {
        let Some(line_style) = edge_style(object, style, self.background) else {
            return 0;
        };
        let edges = &object.mesh.edges;
        self.asked += edges.len();
        let cut = |strokes: &mut Self, edge: [u32; 2]| {
            strokes.polyline(edge.map(|i| vertices.view_point(i)), line_style, strokes.fine);
            edge.len()
        };
        if vertices.len() > 2 * edges.len() {
            // Few edges of many vertices.
            let known = edges.iter().filter(|edge| edge.iter().all(|&i| (i as usize) < vertices.len()));
            return known.map(|&edge| cut(self, edge)).sum();
        }
        let mut ends = OnImage::default();
        ends.fill(vertices, self.screen, Snap::Exact, Wanted { outcodes: true, inverse_w: false });
        let mut points = vertices.len();
        let style = LineStyle { width: line_style.width * self.fine, ..line_style };
        if ends.outcodes.is_empty() && edges.iter().flatten().all(|&i| (i as usize) < vertices.len()) {
            self.whole_edges(edges, &ends.positions, style);
        } else {
            let end = |i: u32| {
                let code = if ends.outcodes.is_empty() { 0 } else { *ends.outcodes.get(i as usize)? };
                Some((*ends.positions.get(i as usize)?, code))
            };
            for &[a, b] in edges {
                let (Some((p, p_code)), Some((q, q_code))) = (end(a), end(b)) else { continue };
                let either = p_code | q_code;
                if either == 0 {
                    self.push(&[p, q], style);
                } else if p_code & q_code == 0 && either & NOT_A_NUMBER == 0 {
                    points += cut(self, [a, b]);
                }
            }
        }
        points
    }

    /// Edges between points of the picture, none of them outside the volume: `edges` are indices into `ends`.
    fn whole_edges(&mut self, edges: &[[u32; 2]], ends: &[[f32; 3]], style: LineStyle) {
        if edges.is_empty() {
            return;
        }
        let set = self.set(style);
        let (first_point, first) = (set.points.len(), set.polylines.len());
        set.points.resize(first_point + 2 * edges.len(), [0.0; 3]);
        set.polylines.resize(first + edges.len(), 0..0);
        let (points, polylines) = (&mut set.points[first_point..], &mut set.polylines[first..]);
        let chunks = edges.chunks(CHUNK).zip(points.chunks_mut(2 * CHUNK)).zip(polylines.chunks_mut(CHUNK)).enumerate();
        each(edges.len(), chunks, |(k, ((edges, points), polylines))| {
            let points = points.as_chunks_mut::<2>().0;
            let starts = (first_point + 2 * CHUNK * k..).step_by(2);
            for (((&[a, b], points), polyline), start) in edges.iter().zip(points).zip(polylines).zip(starts) {
                *points = [ends[a as usize], ends[b as usize]];
                *polyline = range(start, start + 2);
            }
        });
    }

    /// The outline of an object: silhouette and creases. Returns the number of points transformed.
    fn outline(&mut self, object: &Object, vertices: &Vertices, style: &Style) -> usize {
        let Some(line_style) = object.outline.filter(|_| style.shading != Shading::Wireframe) else { return 0 };
        let line_style = line_style.in_style(style);
        let polylines = outline(&object.mesh, vertices.view_from_object.seen_from);
        self.asked += polylines.len();
        for polyline in &polylines {
            self.polyline(polyline.iter().map(|&i| vertices.view_point(i)), line_style, self.fine);
        }
        polylines.iter().map(Vec::len).sum()
    }

    /// The lines of the world.
    fn lines(&mut self, scenes: Scenes, style: &Style) {
        let projector = self.projector;
        self.asked += scenes.line_count();
        for (i, line) in scenes.lines().enumerate() {
            self.role = line.role;
            let scale = if i < scenes.own_line_count() { self.fine } else { self.scale };
            self.polyline(
                line.points.iter().map(|&p| projector.view(WorldPoint(p))),
                line.style.in_style(style),
                scale,
            );
        }
        self.role = Role::Content;
    }

    /// Number of strokes.
    pub(crate) fn drawn(&self) -> usize {
        self.sets.iter().map(|set| set.polylines.len()).sum()
    }

    /// The marks inside the volume.
    fn marks(&self, scenes: Scenes) -> Vec<Mark> {
        let marks = scenes.marks().filter_map(|mark| {
            Some(Mark {
                position: self.inside(mark.position)?,
                shape: mark.shape,
                radius: mark.radius * self.fine,
                color: mark.color,
                outline: self.background,
                fade_if_hidden: mark.fade_if_hidden,
            })
        });
        marks.collect()
    }

    /// The texts whose point is inside the volume.
    fn labels(&self, scenes: Scenes) -> Vec<Label> {
        let labels = scenes.texts().filter_map(|text| {
            Some(Label {
                name: text.name.clone(),
                offset: text.offset.map(|c| c * self.scale),
                fade_if_hidden: text.fade_if_hidden,
                role: text.role,
                ..Label::new(
                    self.inside(text.position)?,
                    &*text.text,
                    text.size * self.scale,
                    [text.color, self.background],
                )
            })
        });
        labels.collect()
    }

    /// A world point on the image; `None` if it's outside the volume.
    fn inside(&self, p_world: DVec3) -> Option<[f32; 3]> {
        let p = clip_from_world(self.projector, WorldPoint(p_world));
        (outcode(self.projector, p) == 0).then(|| self.point(p))
    }

    fn point(&self, p: ClipPoint) -> [f32; 3] {
        unsnapped(viewport(self.screen, divide(&self.projector.depths, p)))
    }

    /// Ends a run; `whole_end` says that its last point is the last of the line.
    fn flush(&mut self, run: &mut Vec<[f32; 3]>, style: LineStyle, whole_end: bool) {
        if run.len() >= 2 {
            self.push(run, LineStyle { arrow: style.arrow && whole_end, ..style });
        }
        run.clear();
    }

    fn push(&mut self, run: &[[f32; 3]], style: LineStyle) {
        let set = self.set(style);
        let start = set.points.len();
        set.points.extend_from_slice(run);
        set.polylines.push(range(start, set.points.len()));
    }

    /// The set for the next strokes of this style: the last one if it has the style and the role, else a new one.
    fn set(&mut self, style: LineStyle) -> &mut StrokeSet {
        let role = self.role;
        if self.sets.last().is_none_or(|set| set.style != style || set.role != role) {
            self.sets.push(StrokeSet { points: Vec::new(), polylines: Vec::new(), style, role });
        }
        let last = self.sets.len() - 1;
        &mut self.sets[last]
    }
}

/// The style of the edges of `object`: its own, and in wireframe always one in the object's own colour, made legible
/// if it's too near the background of the picture.
fn edge_style(object: &Object, style: &Style, background: Rgba) -> Option<LineStyle> {
    let edges = object.edges.map(|edges| edges.in_style(style));
    if style.shading != Shading::Wireframe {
        return edges;
    }
    let style = edges.unwrap_or(LineStyle::solid(Rgba::rgb(128, 128, 128), 1.25, HiddenLines::Shown));
    let color = match &object.paint {
        ObjectPaint::Solid(color) => color.with_alpha(255),
        ObjectPaint::Faces(_) | ObjectPaint::Vertices(_) | ObjectPaint::Texture(_) => style.color,
    };
    Some(LineStyle { color: color.legible_on(background), ..style })
}

/// Indices of the display list are 32 bits wide. A longer list than that would not fit in memory.
fn range(start: usize, end: usize) -> Range<u32> {
    u32::try_from(start).unwrap_or(u32::MAX)..u32::try_from(end).unwrap_or(u32::MAX)
}
