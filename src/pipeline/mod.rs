//! scene + camera → [`Drawing`]: the stages in the order of the notes `[3]` §1.1.

mod clip;
mod cull;
mod faces;
mod lines;
pub mod project;
mod shade;
mod transform;

use crate::appearance::{LineStyle, Rgba, Shading, Style};
use crate::camera::Camera;
use crate::drawing::{Anchor, Drawing, Label, Mark};
use crate::scene::{Object, ObjectPaint, Scene};
use clip::outcode;
use cull::{Place, place};
use faces::{FaceTask, Faces};
use lines::Strokes;
use shade::{Lights, Shaded};
use transform::{Projector, Screen, ViewVertices, single};

/// The picture to make: its size in pixels, and how large a stroke's or letter's unit is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Pixels of this picture for one unit of stroke width or type size.
    pub scale: f32,
    /// Ground of the picture.
    pub background: Rgba,
}

/// Draws `scene` as `camera` sees it. The view window fills the whole target: who wants no distortion gives a target with the
/// window's aspect.
#[must_use]
pub fn draw(scene: &Scene, camera: &Camera, target: Target, style: &Style) -> Drawing {
    let projector = Projector::new(camera);
    let screen = Screen::new(target);
    let lights = Lights::new(&scene.lights, &projector, style.shading);
    let wireframe = style.shading == Shading::Wireframe;
    let mut vertices = ViewVertices::default();
    let mut faces = Faces::default();
    let mut surfaces = Vec::new();
    let mut strokes = Strokes::new(&projector, &screen, target);

    for object in &scene.objects {
        // An object whose box is outside one plane of the volume is dropped whole.
        let view_from_object = projector.view_from_object(object.world_from_object);
        let Some(bounds) = object.mesh.bounds() else { continue };
        let planes = match place(&projector, &view_from_object, &bounds) {
            Place::Outside(_) => continue,
            Place::Crosses(planes) => planes,
        };

        // World → view: each vertex once.
        vertices.fill(&object.mesh.positions, &view_from_object);

        // Back faces, clipping, projection; then light on what is left.
        if object.faces && !wireframe {
            let task = FaceTask { planes, cull_back: !object.two_sided, mirrored: view_from_object.mirrored() };
            faces.collect(&projector, &screen, &vertices, &object.mesh.triangles, task);
            let shaded = Shaded {
                object,
                projector: &projector,
                view_from_object: &view_from_object,
                vertices: &vertices,
                faces: &faces,
                lights: lights.as_ref(),
                shading: style.shading,
            };
            if !faces.triangles.is_empty() {
                surfaces.extend(shaded.surfaces(true));
            }
        }
        if let Some(line_style) = edge_style(object, wireframe) {
            for edge in &object.mesh.edges {
                if edge.iter().all(|&i| (i as usize) < vertices.len()) {
                    strokes.polyline(edge.map(|i| vertices.point(i)), line_style);
                }
            }
        }
    }

    for line in &scene.lines {
        strokes.polyline(line.points.iter().map(|&p| projector.view(p)), line.style);
    }
    let strokes = strokes.sets;
    let on_image = |p_world| {
        let p = projector.clip(projector.view(p_world));
        (outcode(&projector, p) == 0).then(|| single(screen.project(&projector, p)))
    };
    let marks = scene.marks.iter().filter_map(|mark| {
        Some(Mark {
            position: on_image(mark.position)?,
            shape: mark.shape,
            radius: mark.radius * target.scale,
            color: mark.color,
            outline: target.background,
            fade_if_hidden: mark.fade_if_hidden,
        })
    });
    let labels = scene.texts.iter().filter_map(|text| {
        Some(Label {
            position: on_image(text.position)?,
            offset: text.offset.map(|c| c * target.scale),
            text: text.text.clone(),
            size: text.size * target.scale,
            color: text.color,
            halo: target.background,
            anchor: Anchor::Left,
            fade_if_hidden: text.fade_if_hidden,
        })
    });

    Drawing {
        width: target.width,
        height: target.height,
        background: target.background,
        antialias: style.antialias,
        surfaces,
        strokes,
        marks: marks.collect(),
        labels: labels.collect(),
    }
}

/// How the edges of `object` are drawn: as it says; without faces also in wireframe, in the object's own colour.
fn edge_style(object: &Object, wireframe: bool) -> Option<LineStyle> {
    if !wireframe {
        return object.edges;
    }
    let style = object.edges.unwrap_or(LineStyle {
        color: Rgba::rgb(128, 128, 128),
        width: 1.25,
        dash: crate::appearance::Dash::Solid,
        hidden: crate::appearance::HiddenLines::Shown,
        arrow: false,
    });
    match &object.paint {
        ObjectPaint::Solid(color) => Some(LineStyle { color: color.with_alpha(255), ..style }),
        _ => Some(style),
    }
}
