//! The other cameras of a figure in the world: body, volume, axes and name of each, in its color.

use glam::DVec3;

use super::camera_gizmo::GizmoSizes;
use super::gizmos::{AnnotationBuilder, SMALL_TYPE};
use super::volume::DrawnVolume;
use crate::appearance::{Dash, MarkShape, Rgba};
use crate::camera::Projection;
use crate::figure::WorldPart;
use crate::sanitize;
use crate::views::{OtherCamera, Palette, Request};

/// Adds the other cameras with their volumes as drawn.
pub(in crate::views) fn in_world(
    builder: &mut AnnotationBuilder,
    request: &Request,
    palette: Palette,
    volumes: &[DrawnVolume],
) {
    for ((place, other), volume) in request.shot.cameras.iter().enumerate().zip(volumes) {
        let color = OtherCamera::color_at(other.color, place, palette);
        if request.shot.look.world.parts.has(WorldPart::Volume) {
            sides(builder, volume, color);
        }
        if request.shot.look.world.parts.has(WorldPart::Window) {
            window(builder, other, volume, color);
        }
        gear(builder, request, other, color);
    }
}

/// Adds the projectors of a point to the windows of the other cameras. Each window shows the point where its projector
/// meets it.
pub(in crate::views) fn projectors(builder: &mut AnnotationBuilder, request: &Request, palette: Palette, p: DVec3) {
    for (place, other) in request.shot.cameras.iter().enumerate() {
        let (camera, color) = (&other.camera, OtherCamera::color_at(other.color, place, palette));
        let depth = -camera.view_point(p).z;
        if depth <= 0.0 {
            continue;
        }
        let origin = match camera.projection() {
            Projection::Perspective => camera.position(),
            Projection::Parallel => p + camera.basis().n * depth,
        };
        builder.line(vec![origin, p], color, 1.1, Dash::Solid);
        builder.mark(origin.lerp(p, camera.near() / depth), MarkShape::Square, 2.6, color);
    }
}

/// The volume from the window to the far face.
fn sides(builder: &mut AnnotationBuilder, volume: &DrawnVolume, color: Rgba) {
    /// Opacity of a face, of 255. The volumes lie over one another.
    const FACE: u8 = 14;
    builder.volume("volume of another camera", volume, [color, color.with_alpha(FACE)], 1.1);
    builder.closed(&volume.far_face(), color, 1.2, Dash::Dashed);
}

/// The window, and in perspective the edges from C to it.
fn window(builder: &mut AnnotationBuilder, other: &OtherCamera, volume: &DrawnVolume, color: Rgba) {
    if other.camera.projection() == Projection::Perspective {
        for part in volume.parts_before() {
            builder.edges(volume, part, color, 0.8);
        }
    }
    builder.closed(&volume.window(), color, 1.6, Dash::Solid);
}

/// The body at C, the axes, and the name.
fn gear(builder: &mut AnnotationBuilder, request: &Request, other: &OtherCamera, color: Rgba) {
    let (camera, screen, parts) = (&other.camera, builder.screen, request.shot.look.world.parts);
    let (c, basis) = (camera.position(), camera.basis());
    let gear = GizmoSizes::new(screen, camera, &request.shot.look.world);
    if parts.has(WorldPart::CameraBody) {
        builder.camera_body("another camera", camera, gear.body, [color, color.with_alpha(110)]);
    }
    builder.mark_above(c, MarkShape::Disc, 2.2, color);
    let crowd = screen.heading(c, basis.u) + screen.heading(c, basis.v) + screen.heading(c, basis.n);
    builder.named(&other.label_name(), c, &sanitize::escaped(&other.name), -crowd, SMALL_TYPE, color);
    if parts.has(WorldPart::Vrc) {
        // Shorter and thinner than those of the current camera.
        for (_, axis, name) in basis.named() {
            let along = axis * (0.7 * gear.axis);
            builder.arrow(vec![c, c + along], color, 1.3, Dash::Solid);
            let label = format!("{}:{name}", other.label_name());
            builder.named(&label, c + along, name, screen.heading(c, axis), SMALL_TYPE, color);
        }
    }
}
