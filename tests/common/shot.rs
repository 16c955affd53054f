//! Random shots of the house: its options, its observers, and operations on its camera.

use camera_lab::camera::{Decomposition, Ndc, Operation, Parameters};
use camera_lab::figure::words::MEASURES;
use camera_lab::figure::{
    Figure, Measured, Observer, Observers, Show, ShownProbe, ShownStep, ShownTriangle, StagePicture, TransformPreview,
    TriangleStep, View,
};
use camera_lab::geometry::{Angle, Ray};
use camera_lab::scene::{Preset, no_files};
use camera_lab::stage::Stage;
use camera_lab::views::{SharedScene, scene_of};
use glam::{DMat4, DVec3};
use proptest::collection::{btree_set, vec};
use proptest::option;
use proptest::prelude::*;
use proptest::sample::select;

/// The house, with something shown of it.
pub(crate) fn house(show: Show) -> Figure {
    Figure { show, ..Figure::of_preset(Preset::House) }
}

/// The scene of a figure without files.
pub(crate) fn scene(figure: &Figure) -> SharedScene {
    SharedScene::new(scene_of(figure, &mut no_files, &Default::default()).expect("a scene"))
}

/// The options that may be shown of the house.
pub(crate) fn shows() -> impl Strategy<Value = Show> {
    let objects: Vec<(String, usize)> = scene(&house(Show::default()))
        .objects
        .iter()
        .map(|object| (object.name.clone(), object.mesh.triangles.len()))
        .filter(|(_, triangles)| *triangles > 0)
        .collect();
    let names: Vec<String> = objects.iter().map(|(name, _)| name.clone()).collect();
    let stage = (option::of(select(&Stage::ALL[..])), select(&View::ALL[..]));
    let step = (select(&Decomposition::ALL[..]), option::of(0.0..=4.0_f64));
    let triangle = (select(objects), 0..64_usize, select(&TriangleStep::ALL[..]), option::of([0..64_u32, 0..48_u32]));
    let measures: Vec<Measured> = MEASURES.iter().map(|(_, measured)| *measured).collect();
    let probe = prop_oneof![
        point(2.0).prop_map(ShownProbe::World),
        (0..1024_i64, 0..768_i64).prop_map(|(i, j)| ShownProbe::Pixel([i, j])),
        [-1.0..1.0, -1.0..1.0].prop_map(|p: [f64; 2]| ShownProbe::Window(p.into())),
    ];
    (
        stage,
        option::of(0.0..1.0_f64),
        option::of(step),
        option::of(triangle),
        (vec(select(measures), 0..3), option::of(select(names.clone()))),
        option::of(probe),
        vec(preview(names), 0..3),
        (option::of(select(&Ndc::ALL[..])), option::of(point(1.0)), operations()),
    )
        .prop_map(
            |((stage, of), painted, step, triangle, (measure, measure_of), probe, moved, (ndc, answer, ops))| Show {
                stage,
                stage_of: if stage.is_some() { StagePicture(of) } else { StagePicture::default() },
                painted: painted.filter(|_| stage.is_none()),
                step: step.map(|(way, at)| ShownStep { way, at }),
                triangle: triangle.map(|((object, triangles), index, step, pixel)| {
                    let index = u32::try_from(index % triangles).expect("below 64");
                    ShownTriangle { object, index, step, pixel }
                }),
                measure,
                measure_of,
                probe,
                moved,
                ndc,
                answer: answer.map(|aside| Parameters {
                    position: DVec3::new(4.0, 3.0, 2.0) + aside,
                    ..Figure::default().camera
                }),
                operations: ops.into_iter().take(Show::MOST_OPERATIONS).collect(),
            },
        )
}

/// A list of transforms that is tried on some of the objects, or on none.
fn preview(names: Vec<String>) -> impl Strategy<Value = TransformPreview> {
    let matrix = || {
        let turned = (point(1.0), -180.0..180.0_f64).prop_filter("an axis", |(axis, _)| axis.length() > 0.1);
        (turned, point(2.0), point(1.5)).prop_map(|((axis, angle), by, scale)| {
            let turn = DMat4::from_axis_angle(axis.normalize(), angle.to_radians());
            DMat4::from_translation(by) * turn * DMat4::from_scale(scale)
        })
    };
    let axis = (point(2.0), point(1.0)).prop_filter("an axis", |(_, axis)| axis.length() > 0.1);
    let most = names.len().min(2);
    (btree_set(select(names), 0..=most), matrix(), matrix(), option::of(axis), any::<bool>()).prop_map(
        |(objects, change, world_from_frame, axis, wrong)| TransformPreview {
            objects,
            change,
            world_from_frame,
            axis: axis.map(|(origin, direction)| Ray { origin, direction: direction.normalize() }),
            wrong,
        },
    )
}

/// The observers that the pictures may have.
pub(crate) fn observers() -> impl Strategy<Value = Observers> {
    let observer = || {
        let angles = (-180.0..180.0_f64, -90.0..=90.0_f64, prop_oneof![Just(0.0), -180.0..180.0_f64]);
        (point(2.0), 3.0..30.0_f64, angles, any::<bool>()).prop_map(
            |(target, distance, (azimuth, elevation, roll), parallel)| Observer {
                target,
                distance,
                azimuth,
                elevation,
                roll,
                parallel,
            },
        )
    };
    (option::of(observer()), option::of(observer())).prop_map(|(world, canonical)| Observers { world, canonical })
}

/// Operations on a camera: none, a few, or a hundred in a row.
pub(crate) fn operations() -> impl Strategy<Value = Vec<Operation>> {
    let angle = || (-20.0..20.0_f64).prop_map(Angle::from_degrees);
    let factor = || 0.9..1.1_f64;
    let operation = prop_oneof![
        angle().prop_map(Operation::Elevation),
        angle().prop_map(Operation::Azimuth),
        angle().prop_map(Operation::Roll),
        (-3.0..3.0_f64).prop_map(|turn| Operation::Yaw(Angle::from_degrees(turn))),
        (-3.0..3.0_f64).prop_map(|turn| Operation::Pitch(Angle::from_degrees(turn))),
        factor().prop_map(Operation::Zoom),
        factor().prop_map(Operation::Dolly),
        [-0.1..0.1_f64, -0.1..0.1_f64].prop_map(|[dx, dy]| Operation::Pan { dx, dy }),
    ]
    .boxed();
    prop_oneof![vec(operation.clone(), 0..4), vec(operation, 100)]
}

fn point(reach: f64) -> impl Strategy<Value = DVec3> {
    [-reach..reach, -reach..reach, -reach..reach].prop_map(DVec3::from_array)
}
