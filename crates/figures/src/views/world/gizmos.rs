//! The gear that pictures add to a scene: lines, arrows, marks, texts, and the camera's body.

use std::borrow::Cow;
use std::f64::consts::TAU;
use std::sync::Arc;

use glam::{DMat4, DVec2, DVec3};

use crate::appearance::{Dash, HiddenLines, LineStyle, MarkShape, Rgba, Role, Shading, Style};
use crate::drawing::single;
use crate::scene::{Line, Mesh, Object, ObjectPaint, PointMark, Scene, Text};

use super::volume::DrawnVolume;
use crate::camera::Camera;
use crate::views::screen::Screen;

/// Height of ordinary letters, in pixels at scale 1.
pub(in crate::views) const TYPE: f32 = 14.0;
/// Height of small letters.
pub(in crate::views) const SMALL_TYPE: f32 = 11.5;
/// Free space around the point of a text, in pixels at scale 1.
const GAP: f64 = 7.0;

/// A stroke with the hidden-line rule of the figure.
pub(in crate::views) fn stroke(color: Rgba, width: f32, dash: Dash, hidden: HiddenLines) -> LineStyle {
    LineStyle { color, width, dash, hidden, arrow: false }
}

/// The name of a text. A text with a value goes by its symbol.
pub(in crate::views) fn symbol_of(text: &str) -> &str {
    text.split_once(" = ").map_or(text, |(symbol, _)| symbol)
}

/// The gear of a picture in the making.
#[derive(Debug)]
pub(in crate::views) struct AnnotationBuilder<'a> {
    pub(in crate::views) gear: Scene,
    pub(in crate::views) screen: &'a Screen,
    pub(in crate::views) hidden: HiddenLines,
    /// The role of the next text.
    pub(in crate::views) role: Role,
}

impl<'a> AnnotationBuilder<'a> {
    /// Starts without gear. Its lines are hidden like those of the scene.
    pub(in crate::views) fn new(screen: &'a Screen) -> Self {
        Self { gear: Scene::default(), screen, hidden: HiddenLines::OfStyle, role: Role::Content }
    }

    pub(in crate::views) fn line(&mut self, points: Vec<DVec3>, color: Rgba, width: f32, dash: Dash) {
        let style = stroke(color, width, dash, self.hidden);
        self.gear.lines.push(Line::new(points, style));
    }

    pub(in crate::views) fn closed(&mut self, points: &[DVec3], color: Rgba, width: f32, dash: Dash) {
        let closing = points.first().copied();
        self.line(points.iter().copied().chain(closing).collect(), color, width, dash);
    }

    pub(in crate::views) fn arrow(&mut self, points: Vec<DVec3>, color: Rgba, width: f32, dash: Dash) {
        let style = LineStyle { arrow: true, ..stroke(color, width, dash, self.hidden) };
        self.gear.lines.push(Line::new(points, style));
    }

    /// The two strokes between which a line is left out.
    pub(in crate::views) fn breaks(&mut self, from: DVec3, to: DVec3, color: Rgba) {
        /// Half the length of a stroke, in pixels at scale 1.
        const HALF: f64 = 6.0;
        let (Some(a), Some(b)) = (self.screen.place(from), self.screen.place(to)) else { return };
        let along = (b - a).normalize_or_zero();
        let slanted = (along.perp() + 0.5 * along) * (HALF * self.screen.scale);
        for p in [from, to] {
            let shift = self.screen.moved(p, slanted) - p;
            self.line(vec![p - shift, p + shift], color, 1.3, Dash::Solid);
        }
    }

    /// The four edges of a view volume between two distances.
    pub(in crate::views) fn edges(&mut self, volume: &DrawnVolume, part: [f64; 2], color: Rgba, width: f32) {
        let [from, to] = part.map(|distance| volume.section(distance));
        for (from, to) in from.into_iter().zip(to) {
            self.line(vec![from, to], color, width, Dash::Solid);
        }
    }

    /// The breaks of these edges at an omitted part.
    pub(in crate::views) fn gap(&mut self, volume: &DrawnVolume, gap: Option<[f64; 2]>, color: Rgba) {
        let Some([from, to]) = gap.map(|gap| gap.map(|distance| volume.section(distance))) else { return };
        for (from, to) in from.into_iter().zip(to) {
            self.breaks(from, to, color);
        }
    }

    /// A view volume from the window on: its edges, its sides and its far face.
    pub(in crate::views) fn volume(&mut self, name: &str, volume: &DrawnVolume, [edge, fill]: [Rgba; 2], width: f32) {
        let mut faces = vec![volume.far_face()];
        for part in volume.parts() {
            let [a, b] = part.map(|distance| volume.section(distance));
            faces.extend((0..4).map(|i| [a[i], a[(i + 1) % 4], b[(i + 1) % 4], b[i]]));
            self.edges(volume, part, edge, width);
        }
        self.sheer(name, &faces, fill);
        self.gap(volume, volume.gap, edge);
    }

    /// The body of a camera, with the length of its axes.
    pub(in crate::views) fn camera_body(&mut self, name: &str, camera: &Camera, size: f64, [edge, fill]: [Rgba; 2]) {
        let world_from_body = camera.world_from_view() * DMat4::from_scale(DVec3::splat(size));
        self.gear.objects.push(Object {
            lit: false,
            edges: Some(stroke(edge, 0.8, Dash::Solid, HiddenLines::Hidden)),
            ..Object::new(name, Arc::new(camera_body()), world_from_body, ObjectPaint::Solid(fill))
        });
    }

    /// An arrow along a way, if there is one.
    pub(in crate::views) fn arrows(&mut self, way: Option<Vec<DVec3>>, color: Rgba) {
        if let Some(points) = way {
            self.arrow(points, color, 1.8, Dash::Solid);
        }
    }

    /// A vector on an axis, from 0, with the axis's name at its tip.
    pub(in crate::views) fn axis(&mut self, number: u8, from: DVec3, vector: DVec3, pen: (Rgba, f32), name: &str) {
        self.role = Role::Axis(number);
        self.vector(from, vector, pen.0, pen.1, name);
    }

    /// An arrow from `from` along `direction`, with a name at its tip.
    pub(in crate::views) fn vector(&mut self, from: DVec3, vector: DVec3, color: Rgba, width: f32, name: &str) {
        let tip = from + vector;
        self.arrow(vec![from, tip], color, width, Dash::Solid);
        self.text(tip, name, self.screen.heading(from, vector), TYPE, color);
    }

    pub(in crate::views) fn mark(&mut self, position: DVec3, shape: MarkShape, radius: f32, color: Rgba) {
        self.gear.marks.push(PointMark { position, shape, radius, color, fade_if_hidden: true });
    }

    /// A mark that nothing hides.
    pub(in crate::views) fn mark_above(&mut self, position: DVec3, shape: MarkShape, radius: f32, color: Rgba) {
        self.gear.marks.push(PointMark { position, shape, radius, color, fade_if_hidden: false });
    }

    /// A text beside a point, if there's space in this direction (pixels, y down). Earlier texts choose first.
    pub(in crate::views) fn text(&mut self, position: DVec3, text: &str, toward: DVec2, size: f32, color: Rgba) {
        self.named(symbol_of(text), position, text, toward, size, color);
    }

    /// A text like [`text`](Self::text), with a name with which an author changes it.
    pub(in crate::views) fn named(
        &mut self,
        name: &str,
        position: DVec3,
        text: &str,
        toward: DVec2,
        size: f32,
        color: Rgba,
    ) {
        let d = toward.normalize_or(DVec2::X) * GAP;
        self.gear.texts.push(Text {
            name: name.to_owned(),
            position,
            text: text.to_owned(),
            offset: [single(d.x), single(d.y)],
            size,
            color,
            fade_if_hidden: false,
            role: std::mem::take(&mut self.role),
        });
    }

    /// Faces that show their plain colour, from both sides, without edges.
    pub(in crate::views) fn sheer(&mut self, name: &str, faces: &[[DVec3; 4]], color: Rgba) {
        let mut mesh = Mesh::default();
        for face in faces {
            add_polygon(&mut mesh, face);
        }
        mesh.edges.clear();
        self.gear.objects.push(Object {
            lit: false,
            two_sided: true,
            ..Object::new(name, Arc::new(mesh), DMat4::IDENTITY, ObjectPaint::Solid(color))
        });
    }
}

/// Turns the objects of a scene into edges in their own colours, as wireframe needs them.
fn wire(scene: &mut Scene) {
    for object in &mut scene.objects {
        let own = match object.paint {
            ObjectPaint::Solid(color) => color.with_alpha(255),
            ObjectPaint::Faces(_) | ObjectPaint::Vertices(_) | ObjectPaint::Texture(_) => {
                object.edges.map_or(Rgba::rgb(128, 128, 128), |edges| edges.color)
            }
        };
        object.edges = Some(stroke(own, 1.25, Dash::Solid, HiddenLines::OfStyle));
        object.outline = None;
        object.faces = false;
    }
}

/// The scene as edges in wireframe, and a style in which the camera's gear keeps its faces. Other machines' vertices
/// are the image's alone.
pub(in crate::views) fn wired<'a>(mut scene: Cow<'a, Scene>, style: &Style) -> (Cow<'a, Scene>, Style) {
    let style = style.with_exact_vertices();
    if style.shading != Shading::Wireframe {
        return (scene, style);
    }
    wire(scene.to_mut());
    (scene, Style { shading: Shading::Flat, ..style })
}

/// Adds a planar convex polygon, counter-clockwise seen from outside, with its edges.
pub(in crate::views) fn add_polygon(mesh: &mut Mesh, polygon: &[DVec3]) {
    let normal = match polygon {
        [a, b, c, ..] => crate::geometry::try_unit((b - a).cross(c - a)).unwrap_or(DVec3::Y),
        _ => return,
    };
    let index = |i: usize| u32::try_from(i).unwrap_or(u32::MAX);
    let (first, n) = (index(mesh.positions.len()), index(polygon.len()));
    mesh.positions.extend_from_slice(polygon);
    mesh.normals.extend(std::iter::repeat_n(normal, polygon.len()));
    mesh.triangles.extend((2..n).map(|i| [first, first + i - 1, first + i]));
    mesh.edges.extend((0..n).map(|i| [first + i, first + (i + 1) % n]));
}

/// A closed tube between two polygons of the same number of corners, counter-clockwise seen from the side of `to`.
fn add_loft(mesh: &mut Mesh, from: &[DVec3], to: &[DVec3]) {
    let n = from.len().min(to.len());
    for i in 0..n {
        let j = (i + 1) % n;
        add_polygon(mesh, &[from[i], from[j], to[j], to[i]]);
        if n > 8 {
            // In a round tube, only the two rims are edges.
            mesh.edges.truncate(mesh.edges.len() - 4);
        }
    }
    let back: Vec<_> = from.iter().rev().copied().collect();
    add_polygon(mesh, &back);
    add_polygon(mesh, to);
}

/// A circle about `center` in the plane of two vectors as long as its radius. The pointer needs one in each frame, so
/// it uses the sines of `f64`, which are exact enough for the eye.
pub(in crate::views) fn circle(center: DVec3, a: DVec3, b: DVec3, corners: u32) -> Vec<DVec3> {
    let turn = |i: u32| (TAU * f64::from(i) / f64::from(corners)).sin_cos();
    (0..corners).map(turn).map(|(sin, cos)| center + a * cos + b * sin).collect()
}

/// The body of a film camera in its VRC. The lens opens at the origin (C) towards −z (the scene), and the two reels on
/// top show the direction of **v**. It's about 2 units long and 2 high.
pub(in crate::views) fn camera_body() -> Mesh {
    const ROUND: u32 = 20;
    let mut mesh = Mesh::default();
    let rect = |z: f64, x: f64, y: f64| [(x, -y), (x, y), (-x, y), (-x, -y)].map(|(x, y)| DVec3::new(x, y, z));
    // The box, from its front to its back.
    add_loft(&mut mesh, &rect(0.5, 0.36, 0.42), &rect(1.8, 0.36, 0.42));
    // The hood of the lens widens towards the scene.
    let ring = |z: f64, r: f64| circle(DVec3::new(0.0, 0.0, z), DVec3::X * r, DVec3::Y * r, ROUND);
    add_loft(&mut mesh, &ring(0.0, 0.4), &ring(0.5, 0.2));
    // The reels rotate about the direction of u.
    for (z, r) in [(0.72, 0.44), (1.58, 0.44)] {
        let reel = |x: f64| circle(DVec3::new(x, 0.42 + r, z), DVec3::Y * r, DVec3::Z * r, ROUND);
        add_loft(&mut mesh, &reel(-0.16), &reel(0.16));
    }
    mesh.closed = true;
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn the_body_is_closed_and_its_faces_look_outwards() {
        let m = camera_body();
        let key = |i: u32| m.positions[i as usize].to_array().map(|v| format!("{:.6}", v + 0.0));
        let mut sides: BTreeMap<_, i32> = BTreeMap::new();
        for t in &m.triangles {
            for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                *sides.entry((key(a), key(b))).or_default() += 1;
                *sides.entry((key(b), key(a))).or_default() -= 1;
            }
        }
        assert!(sides.values().all(|&n| n == 0), "each side is used once in each sense");
        let volume: f64 = m
            .triangles
            .iter()
            .map(|t| t.map(|i| m.positions[i as usize]))
            .map(|[a, b, c]| a.dot(b.cross(c)) / 6.0)
            .sum();
        assert!(volume > 1.0, "outwards: {volume}");
    }

    #[test]
    fn the_lens_is_at_the_origin_and_the_reels_are_above() {
        let b = camera_body().bounds().unwrap_or(crate::geometry::Aabb { min: DVec3::ZERO, max: DVec3::ZERO });
        assert_eq!(b.min.z, 0.0, "nothing of the body is before C");
        assert!(b.max.y > 2.0 * -b.min.y, "higher above than below");
        assert!((b.min.x + b.max.x).abs() < 1e-12, "the same to both sides");
    }
}
