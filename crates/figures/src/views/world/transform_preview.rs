//! An object at the place that a list of transforms gives it, as glass in another colour, with its own axes.

use std::sync::Arc;

use glam::DMat4;

use crate::appearance::{Dash, HiddenLines, LineStyle, MarkShape, Rgba};
use crate::geometry::Ray;
use crate::scene::{Line, Object, ObjectPaint, primitives};

use super::gizmos::{self, AnnotationBuilder, SMALL_TYPE};
use crate::figure::TransformPreview;
use crate::views::{Palette, Request};

/// Adds the previewed objects.
pub(in crate::views) fn in_world(builder: &mut AnnotationBuilder, request: &Request, palette: Palette) {
    for (k, preview) in request.shot.show.moved.iter().enumerate() {
        let color = if preview.wrong { palette.wrong } else { palette.ghost };
        bodies(builder, request, preview, color);
        axes(builder, preview, k + 1, color);
        if let Some(axis) = preview.axis {
            about(builder, axis, color);
        }
    }
}

/// The objects as glass, and the strokes of those without faces. Objects scaled to nothing have no visible faces. If
/// they're in place already, there's nothing to add.
fn bodies(builder: &mut AnnotationBuilder, request: &Request, preview: &TransformPreview, color: Rgba) {
    let mut add = |name: &str, mesh, world_from_object: DMat4| {
        if world_from_object.determinant().abs() <= f64::MIN_POSITIVE {
            return;
        }
        builder.gear.objects.push(Object {
            lit: false,
            two_sided: true,
            edges: Some(gizmos::stroke(color, 1.2, Dash::Solid, HiddenLines::Hidden)),
            ..Object::new(format!("{name} moved"), mesh, world_from_object, ObjectPaint::Solid(color.with_alpha(60)))
        });
    };
    if preview.objects.is_empty() {
        return add("cube", Arc::new(primitives::cube()), preview.world_from_frame);
    }
    if preview.change.abs_diff_eq(DMat4::IDENTITY, 1e-9) {
        return;
    }
    let shown = |object: &&Object| preview.objects.contains(object.owner());
    for object in request.scene.objects.iter().filter(shown).filter(|object| object.faces) {
        add(&object.name, Arc::clone(&object.mesh), preview.change * object.world_from_object);
    }
    for object in request.scene.objects.iter().filter(shown).filter(|object| !object.faces) {
        bare(builder, object, preview.change * object.world_from_object, color);
    }
    let lines = request.scene.grids.iter().filter(|(name, _)| preview.objects.contains(name));
    for line in lines.flat_map(|(_, range)| request.scene.lines.get(range.clone()).unwrap_or_default()) {
        let points = line.points.iter().map(|p| preview.change.transform_point3(*p)).collect();
        builder.line(points, color, 1.0, Dash::Solid);
    }
}

/// Objects without faces: segments as strokes, points as marks.
fn bare(builder: &mut AnnotationBuilder, object: &Object, world_from_object: DMat4, color: Rgba) {
    let place = |i: &u32| object.mesh.positions.get(*i as usize).map(|p| world_from_object.transform_point3(*p));
    for ends in &object.mesh.edges {
        builder.line(ends.iter().filter_map(place).collect(), color, 1.6, Dash::Solid);
    }
    if object.mesh.edges.is_empty() {
        for p in &object.mesh.positions {
            builder.mark(world_from_object.transform_point3(*p), MarkShape::Ring, 4.0, color);
        }
    }
}

/// The columns of its matrix, from their origin, and with their own length. Nothing hides them.
fn axes(builder: &mut AnnotationBuilder, preview: &TransformPreview, number: usize, color: Rgba) {
    let origin = preview.world_from_frame.w_axis.truncate();
    let columns = [preview.world_from_frame.x_axis, preview.world_from_frame.y_axis, preview.world_from_frame.z_axis];
    for (column, name) in columns.into_iter().zip(["x", "y", "z"]) {
        let tip = origin + column.truncate();
        let style = LineStyle { color, width: 2.0, dash: Dash::Solid, hidden: HiddenLines::Shown, arrow: true };
        builder.gear.lines.push(Line::new(vec![origin, tip], style));
        let toward = builder.screen.heading(origin, column.truncate());
        builder.text(tip, &format!("{name}_{number}"), toward, SMALL_TYPE, color);
    }
    builder.mark_above(origin, MarkShape::Disc, 3.0, color);
}

/// The axis of the last turn.
fn about(builder: &mut AnnotationBuilder, axis: Ray, color: Rgba) {
    let reach = builder.screen.units_per_pixel(axis.origin) * 0.25 * builder.screen.extent.min_element();
    let ends = [-reach, reach].map(|t| axis.origin + axis.direction * t);
    builder.line(ends.to_vec(), color, 1.2, Dash::DashDot);
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use std::collections::BTreeSet;

    use glam::DVec3;

    use super::*;
    use crate::camera::{Camera, Parameters};
    use crate::drawing::Drawing;
    use crate::figure::{Figure, Observer};
    use crate::views::timed_pipeline::TimedPipeline;
    use crate::views::{SharedScene, Size, View, frame, unlabelled};

    fn drawn(moved: Vec<TransformPreview>) -> Drawing {
        drawn_in(&SharedScene::default(), moved)
    }

    fn drawn_in(scene: &SharedScene, moved: Vec<TransformPreview>) -> Drawing {
        let (figure, camera) = (Figure::default(), Camera::new(&Parameters::default()).unwrap());
        let size = Size { width: 600, height: 400, scale: 1.0 };
        let observer = Observer {
            target: DVec3::ZERO,
            distance: 30.0,
            azimuth: 40.0,
            elevation: 25.0,
            roll: 0.0,
            parallel: false,
        };
        let request = Request::of(&figure, View::World, &camera, scene, unlabelled(), size)
            .with_shot(|shot| shot.show.moved = moved.clone())
            .seen_by(Some(observer));
        frame(&request, None, &mut TimedPipeline::default()).drawing
    }

    #[test]
    fn each_has_its_axes_and_an_object_scaled_to_nothing_no_body() {
        let preview = |scale: DVec3, wrong| TransformPreview {
            objects: BTreeSet::new(),
            change: DMat4::IDENTITY,
            world_from_frame: DMat4::from_translation(DVec3::X) * DMat4::from_scale(scale),
            axis: None,
            wrong,
        };
        let plain = drawn(Vec::new());
        let two = drawn(vec![preview(DVec3::ONE, false), preview(DVec3::ONE, true)]);
        let texts: Vec<&str> = two.labels.iter().map(|label| label.text.as_str()).collect();
        for name in ["x_1", "y_1", "z_1", "x_2", "y_2", "z_2"] {
            assert!(texts.contains(&name), "{texts:?}");
        }
        assert!(two.surfaces.len() > plain.surfaces.len());
        // No faces are added for flat objects.
        let flat = drawn(vec![preview(DVec3::new(1.0, 0.0, 1.0), false)]);
        assert_eq!(flat.surfaces.len(), plain.surfaces.len());
    }

    #[test]
    fn objects_without_faces_are_drawn_by_their_strokes() {
        use crate::scene::{ObjectSpec, Preset, SceneSpec, Shape, build};

        let [a, b, c] = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0)];
        let objects = vec![
            ObjectSpec::new("grid", Shape::Grid).with_segments(4),
            ObjectSpec::new("segments", Shape::Segments(vec![[a, b], [c, 2.0 * c]])),
            ObjectSpec::new("points", Shape::Points(vec![a, b, c])),
        ];
        let spec = SceneSpec { preset: Preset::Empty, objects, lights: Vec::new() };
        let style = crate::appearance::Style::default();
        let scene = SharedScene::new(build(&spec, &style, &mut |_| unreachable!("no file is named")).unwrap());
        let preview = |name: &str| TransformPreview {
            objects: BTreeSet::from([name.to_owned()]),
            change: DMat4::from_translation(DVec3::new(0.0, 2.0, 0.0)),
            world_from_frame: DMat4::IDENTITY,
            axis: None,
            wrong: false,
        };
        // Objects in the preview's colour. The world is drawn around its content.
        let color = Palette::of(style.theme).ghost;
        let polylines = |drawing: &Drawing| {
            let own = drawing.strokes.iter().filter(|set| set.style.color == color);
            own.map(|set| set.polylines.len()).sum::<usize>()
        };
        let [none, points, grid, segments] =
            ["none", "points", "grid", "segments"].map(|name| drawn_in(&scene, vec![preview(name)]));
        assert_eq!(points.marks.len() - none.marks.len(), 3);
        // Points have no strokes, so the strokes there belong to the axes.
        assert_eq!([&grid, &segments].map(|drawing| polylines(drawing) - polylines(&points)), [10, 2]);
    }
}
