//! How much a frame of egui paints.

use eframe::egui::epaint::{ClippedPrimitive, Primitive};
use eframe::egui::{Pos2, Rect};

/// The area that triangles cover, in square points. A place that is painted over counts each time. Of a triangle that
/// is cut off, the share of the rectangle around it is taken.
pub(crate) fn painted(primitives: &[ClippedPrimitive]) -> f32 {
    let of_mesh = |clipped: &ClippedPrimitive| match &clipped.primitive {
        Primitive::Callback(_) => 0.0,
        Primitive::Mesh(mesh) => {
            let corners = |of: &[u32]| [0, 1, 2].map(|i| mesh.vertices[of[i] as usize].pos);
            mesh.indices.chunks_exact(3).map(|of| of_triangle(corners(of), clipped.clip_rect)).sum()
        }
    };
    primitives.iter().map(of_mesh).sum()
}

fn of_triangle([a, b, c]: [Pos2; 3], clip: Rect) -> f32 {
    let around = Rect::from_points(&[a, b, c]);
    let seen = around.intersect(clip);
    if !seen.is_positive() || !around.is_positive() {
        return 0.0;
    }
    let (ab, ac) = (b - a, c - a);
    0.5 * (ab.x * ac.y - ab.y * ac.x).abs() * seen.area() / around.area()
}
