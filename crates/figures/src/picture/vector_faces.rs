//! The faces of a page of vectors, in the order of painting, as areas, or as pictures if they have a picture on them.
//!
//! A page has no depth buffer, so faces are painted from back to front. Viewers smooth the border of each area by
//! itself, and the background shows through between neighbours. So triangles of one colour that follow one another
//! become one area, and opaque areas have a thin stroke of their own colour along each side that they share. Gradients
//! and textures become images. The parts of one such surface are put together again if no face between them covers the
//! part that moves, because every cut would be a seam.

use std::collections::HashMap;
use std::sync::Arc;

use tiny_skia::Pixmap;

use crate::appearance::Rgba;
use crate::drawing::{Base, Drawing, Surface, SurfaceLight};
use crate::export::vector::Item;
use crate::raster::Rasterizer;
use crate::text::Element;

/// The width of the strokes along common sides of neighbouring areas, in pixels. Programs that paint each area by
/// itself let the background show there otherwise.
const SEAM: f32 = 1.0;
/// The distance by which triangles may overlap and still count as touching, in pixels.
const TOUCH: f32 = 0.01;
/// The most pictures among the areas of a picture. A surface cut into more of them would show its seams.
const MOST_PICTURES: usize = 8;

/// The most pairs of triangles to compare in putting parts of pictures together, which takes a second.
const MOST_COMPARED: usize = 1 << 26;

/// Makes pixels of surfaces.
pub(super) struct Pictures<'a> {
    /// Pixels per unit of the page.
    pub(super) finer: u32,
    pub(super) rasterizer: &'a mut Rasterizer,
}

impl Pictures<'_> {
    /// The pixels of surfaces with one picture that follow one another in the order of painting, at their place. Empty
    /// if they're outside the drawing; `None` if there's no memory for them.
    fn of(&mut self, drawing: &Drawing, surfaces: &[&Surface]) -> Option<Option<Item>> {
        let size = [drawing.width, drawing.height];
        let ends = [0, 1].map(|axis| {
            let along = || surfaces.iter().flat_map(|surface| &surface.positions).map(|position| position[axis]);
            let from = along().fold(f32::INFINITY, f32::min).floor().max(0.0);
            let to = along().fold(f32::NEG_INFINITY, f32::max).ceil().min(size[axis] as f32);
            [from, to]
        });
        let (corner, extent) = (ends.map(|[from, _]| from), ends.map(|[from, to]| to - from));
        if !extent.iter().all(|side| *side >= 1.0) {
            return Some(None);
        }
        let pixels = self.alone(drawing, surfaces, [corner, extent])?;
        Some(Some(Item::Picture { corner, size: extent, pixels }))
    }

    /// The given surfaces only, in the part of a drawing with this corner and this extent.
    fn alone(&mut self, drawing: &Drawing, surfaces: &[&Surface], [corner, extent]: [[f32; 2]; 2]) -> Option<Pixmap> {
        let factor = self.finer as f32;
        let place = |p: &[f32; 3]| [factor * (p[0] - corner[0]), factor * (p[1] - corner[1]), p[2]];
        let moved = |surface: &&Surface| Surface {
            positions: surface.positions.iter().map(place).collect(),
            ..(*surface).clone()
        };
        #[expect(clippy::cast_possible_truncation, reason = "whole, and within the drawing")]
        let [width, height] = extent.map(|side| side as u32 * self.finer);
        self.rasterizer.paint(&Drawing {
            width,
            height,
            background: drawing.background.with_alpha(0),
            surfaces: surfaces.iter().map(moved).collect(),
            strokes: Vec::new(),
            areas: Vec::new(),
            marks: Vec::new(),
            labels: Vec::new(),
            ..*drawing
        })
    }
}

/// True if both surfaces have the same picture on them.
fn has_picture_of(surface: &Surface, other: &Surface) -> bool {
    match (&surface.base, &other.base) {
        (Base::Texture { image, .. }, Base::Texture { image: same, .. }) => Arc::ptr_eq(image, same),
        _ => false,
    }
}

/// True if the triangles of a surface have one colour each, or a picture on them that isn't lit.
pub(super) fn can_be_written(surface: &Surface) -> bool {
    let has_tints = matches!(&surface.base, Base::Texture { tints, .. } if !tints.is_empty());
    !surface.varies() || (surface.is_textured() && !has_tints && surface.light == SurfaceLight::InBase)
}

/// The contour of a polygon.
pub(super) fn polygon(corners: &[[f32; 2]]) -> Vec<Element> {
    let mut path: Vec<Element> = corners.iter().map(|corner| Element::Line(*corner)).collect();
    if let (Some(first), Some(corner)) = (path.first_mut(), corners.first()) {
        *first = Element::Move(*corner);
        path.push(Element::Close);
    }
    path
}

/// The corners of a triangle, all of one winding.
type Corners = [[f32; 2]; 3];

/// A side, the same in both directions: the bits of its ends.
type SideKey = [[u32; 2]; 2];

fn side_key([a, b]: [[f32; 2]; 2]) -> SideKey {
    let bits = |p: [f32; 2]| p.map(f32::to_bits);
    let (a, b) = (bits(a), bits(b));
    if a < b { [a, b] } else { [b, a] }
}

fn sides_of([a, b, c]: Corners) -> [[[f32; 2]; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// Triangles of one colour that follow one another, or surfaces with pictures on them that do.
enum Part<'a> {
    Area(Rgba, Vec<Corners>),
    Pictured(Vec<&'a Surface>),
}

impl Part<'_> {
    fn triangles(&self) -> Vec<Corners> {
        match self {
            Part::Area(_, triangles) => triangles.clone(),
            Part::Pictured(surfaces) => surfaces.iter().flat_map(|surface| triangles_of(surface)).collect(),
        }
    }
}

/// The place of a part: its triangles, each in the order of painting, and the box around them.
struct PartShape {
    triangles: Vec<Corners>,
    bounds: [[f32; 2]; 2],
}

impl PartShape {
    fn of(part: &Part) -> Self {
        let triangles = part.triangles();
        let bounds = bounds_of(triangles.as_flattened());
        Self { triangles, bounds }
    }

    /// True if the two cover a place together. `steps` is the number of pairs of triangles that may still be compared.
    /// True if none is left.
    fn covers(&self, other: &Self, steps: &mut usize) -> bool {
        if are_apart(self.bounds, other.bounds) {
            return false;
        }
        self.triangles.iter().any(|triangle| {
            let bounds = bounds_of(triangle);
            !are_apart(bounds, other.bounds)
                && other.triangles.iter().any(|other| {
                    *steps = steps.saturating_sub(1);
                    *steps == 0 || (!are_apart(bounds, bounds_of(other)) && overlap(*triangle, *other))
                })
        })
    }

    /// Takes the triangles of another one, before or after its own.
    fn join(&mut self, moved: Self, before: bool) {
        let at = if before { 0 } else { self.triangles.len() };
        self.triangles.splice(at..at, moved.triangles);
        self.bounds = bounds_of([self.bounds, moved.bounds].as_flattened());
    }
}

/// The box around points: its least and its greatest coordinates.
fn bounds_of(points: &[[f32; 2]]) -> [[f32; 2]; 2] {
    let widened = |[low, high]: [[f32; 2]; 2], p: &[f32; 2]| {
        [[low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])]]
    };
    points.iter().fold([[f32::INFINITY; 2], [f32::NEG_INFINITY; 2]], widened)
}

fn are_apart([low, high]: [[f32; 2]; 2], [other_low, other_high]: [[f32; 2]; 2]) -> bool {
    (0..2).any(|axis| high[axis] < other_low[axis] || other_high[axis] < low[axis])
}

/// The triangles of a surface that have an area, all of one winding.
fn triangles_of(surface: &Surface) -> impl Iterator<Item = Corners> {
    surface.triangles.iter().filter_map(|triangle| {
        let corner = |vertex: u32| surface.positions.get(vertex as usize).map(|p| [p[0], p[1]]);
        let [Some(a), Some(b), Some(c)] = triangle.map(corner) else { return None };
        wound([a, b, c])
    })
}

/// The corners in the winding of all, so that neighbours add up; `None` if they have no area.
fn wound([a, b, c]: Corners) -> Option<Corners> {
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    if !area.is_finite() || area == 0.0 {
        return None;
    }
    Some(if area > 0.0 { [a, b, c] } else { [a, c, b] })
}

/// Puts parts of one picture together if nothing between them in the order covers the one that moves. The order cuts a
/// surface by the planes of faces that may be far from it, and each cut would be a seam.
fn gather(parts: &mut Vec<Part>) {
    if !parts.iter().any(|part| matches!(part, Part::Pictured(_))) {
        return;
    }
    let mut shapes: Vec<PartShape> = parts.iter().map(PartShape::of).collect();
    let mut steps = MOST_COMPARED;
    let mut from = 0;
    while let Some(first) = (from..parts.len()).find(|k| matches!(parts[*k], Part::Pictured(_))) {
        from = first + 1;
        let next = (from..parts.len()).find(|k| is_of_one_picture(&parts[first], &parts[*k]));
        let Some(next) = next else { continue };
        let between = first + 1..next;
        let mut is_free =
            |moved: usize| !shapes[between.clone()].iter().any(|shape| shapes[moved].covers(shape, &mut steps));
        // The order of painting stays the same.
        let (moved, to, before) = match (is_free(first), is_free(next)) {
            (true, _) => (first, next - 1, true),
            (false, true) => (next, first, false),
            (false, false) => continue,
        };
        let (moved, shape) = (parts.remove(moved), shapes.remove(moved));
        let (Part::Pictured(moved), Some(Part::Pictured(stays))) = (moved, parts.get_mut(to)) else { continue };
        let at = if before { 0 } else { stays.len() };
        stays.splice(at..at, moved);
        shapes[to].join(shape, before);
        // The part that has grown may move on.
        from = first;
    }
}

fn is_of_one_picture(part: &Part, other: &Part) -> bool {
    match (part, other) {
        (Part::Pictured(of), Part::Pictured(others)) => {
            of.first().zip(others.first()).is_some_and(|(a, b)| has_picture_of(a, b))
        }
        _ => false,
    }
}

/// True if two triangles of one winding cover a place together. Triangles that only touch don't.
fn overlap(triangle: Corners, other: Corners) -> bool {
    let separates = |[a, b]: [[f32; 2]; 2], other: Corners| {
        let along = [b[0] - a[0], b[1] - a[1]];
        let distance = |p: [f32; 2]| along[0] * (p[1] - a[1]) - along[1] * (p[0] - a[0]);
        other.iter().all(|p| distance(*p) <= TOUCH * glam::Vec2::from(along).length())
    };
    let is_apart = |own: Corners, other: Corners| sides_of(own).into_iter().any(|side| separates(side, other));
    !is_apart(triangle, other) && !is_apart(other, triangle)
}

/// The triangles of a drawing in their order, with consecutive ones of one colour as one area. Along the sides that
/// opaque ones share with others, there's a stroke of their colour. Surfaces with pictures on them are pictures; `None`
/// if there are too many of these, or there's no memory for one.
pub(super) fn faces_of(drawing: &Drawing, pictures: &mut Pictures) -> Option<Vec<Item>> {
    let mut parts: Vec<Part> = Vec::new();
    let mut shared: HashMap<SideKey, u32> = HashMap::new();
    for surface in drawing.surfaces.iter().filter(|surface| !surface.triangles.is_empty()) {
        if surface.varies() {
            match parts.last_mut() {
                Some(Part::Pictured(surfaces)) if surfaces.iter().all(|last| has_picture_of(last, surface)) => {
                    surfaces.push(surface);
                }
                _ => parts.push(Part::Pictured(vec![surface])),
            }
            continue;
        }
        for (k, triangle) in surface.triangles.iter().enumerate() {
            let corner = |vertex: u32| surface.positions.get(vertex as usize).map(|p| [p[0], p[1]]);
            let corners = triangle.map(corner);
            let ([Some(a), Some(b), Some(c)], Some(color)) = (corners, surface.face_color(k)) else { continue };
            let color = if surface.translucent { color } else { color.with_alpha(255) };
            let Some(corners) = wound([a, b, c]) else { continue };
            for side in sides_of(corners) {
                *shared.entry(side_key(side)).or_default() += 1;
            }
            match parts.last_mut() {
                Some(Part::Area(of, triangles))
                    if *of == color && (color.is_opaque() || continues(triangles, corners)) =>
                {
                    triangles.push(corners);
                }
                _ => parts.push(Part::Area(color, vec![corners])),
            }
        }
    }
    gather(&mut parts);
    if parts.iter().filter(|part| matches!(part, Part::Pictured(_))).count() > MOST_PICTURES {
        return None;
    }
    let mut items = Vec::new();
    for part in &parts {
        match part {
            Part::Area(color, triangles) => items.extend(area_of(*color, triangles, &shared)),
            Part::Pictured(surfaces) => items.extend(pictures.of(drawing, surfaces)?),
        }
    }
    Some(items)
}

fn area_of(color: Rgba, triangles: &[Corners], shared: &HashMap<SideKey, u32>) -> Vec<Item> {
    let path = triangles.iter().flat_map(|corners| polygon(corners)).collect();
    let mut items = vec![Item::Fill { path, color }];
    let mut own: HashMap<SideKey, u32> = HashMap::new();
    for side in triangles.iter().flat_map(|corners| sides_of(*corners)) {
        *own.entry(side_key(side)).or_default() += 1;
    }
    // Within one path neighbours add up.
    let with_others = |side: &[[f32; 2]; 2]| {
        let key = side_key(*side);
        shared.get(&key) > own.get(&key)
    };
    let sides = triangles.iter().flat_map(|corners| sides_of(*corners)).filter(with_others);
    let seam: Vec<Element> = sides.flat_map(|[a, b]| [Element::Move(a), Element::Line(b)]).collect();
    if color.is_opaque() && !seam.is_empty() {
        items.push(Item::Stroke { path: seam, color, width: SEAM, dashes: Vec::new(), phase: 0.0, round: true });
    }
    items
}

/// True if a triangle has a side in common with the last one of an area, and lies on the other side of it. Then both
/// are blended with the background once.
fn continues(triangles: &[Corners], next: Corners) -> bool {
    let Some(last) = triangles.last() else { return false };
    // With one winding, a common side is passed in both directions.
    sides_of(*last).iter().any(|[a, b]| sides_of(next).contains(&[*b, *a]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::appearance::{Sampler, Texture};

    const LEFT: Corners = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
    const RIGHT: Corners = [[4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    const OVER: Corners = [[1.0, 1.0], [5.0, 1.0], [1.0, 5.0]];
    const FAR: Corners = [[9.0, 9.0], [12.0, 9.0], [9.0, 12.0]];

    #[test]
    fn triangles_with_a_common_side_touch_and_do_not_overlap() {
        for (one, other, expected) in
            [(LEFT, RIGHT, false), (LEFT, OVER, true), (RIGHT, OVER, true), (LEFT, FAR, false)]
        {
            assert_eq!((overlap(one, other), overlap(other, one)), (expected, expected), "{one:?} {other:?}");
        }
        let inside = [[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]];
        assert!(overlap(LEFT, inside) && overlap(inside, LEFT));
    }

    fn pictured(image: &Arc<Texture>, corners: Corners) -> Surface {
        let base = Base::Texture {
            image: image.clone(),
            sampler: Sampler::PICTURE,
            uv: vec![[0.0; 2]; 3],
            tint: Rgba::rgb(255, 255, 255),
            tints: Vec::new(),
        };
        let positions = corners.map(|[x, y]| [x, y, 0.5]).to_vec();
        Surface { base, ..Surface::solid(positions, vec![[0, 1, 2]], Rgba::rgb(0, 0, 0)) }
    }

    /// The kinds of the parts: a letter for an area, the number of surfaces for pictures.
    fn kinds(parts: &[Part]) -> String {
        let kind = |part: &Part| match part {
            Part::Area(..) => "a".to_owned(),
            Part::Pictured(surfaces) => surfaces.len().to_string(),
        };
        parts.iter().map(kind).collect()
    }

    #[test]
    fn parts_of_a_picture_meet_past_pieces_that_do_not_cover_them() {
        let image = Arc::new(Texture::flat(1, 1, vec![0; 4]));
        let [left, right] = [LEFT, RIGHT].map(|corners| pictured(&image, corners));
        let gathered = |between: Corners| {
            let mut parts = vec![
                Part::Pictured(vec![&left]),
                Part::Area(Rgba::rgb(1, 2, 3), vec![between]),
                Part::Pictured(vec![&right]),
            ];
            gather(&mut parts);
            kinds(&parts)
        };
        assert_eq!(gathered(FAR), "a2");
        // Over the first alone, so the second comes to it, below.
        assert_eq!(gathered([[0.5, 0.5], [1.0, 0.5], [0.5, 1.0]]), "2a");
        assert_eq!(gathered(OVER), "1a1");
        // Another picture isn't part of the same one.
        let other = Arc::new(Texture::flat(1, 1, vec![0; 4]));
        let other = pictured(&other, RIGHT);
        let mut parts = vec![Part::Pictured(vec![&left]), Part::Pictured(vec![&other])];
        gather(&mut parts);
        assert_eq!(kinds(&parts), "11");
    }
}
