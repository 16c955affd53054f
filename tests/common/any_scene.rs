//! Scenes for property tests of the pipeline.

#![expect(clippy::unwrap_used, reason = "tests")]

use std::sync::Arc;

use camera_lab_engine::appearance::{Dash, HiddenLines, LineStyle, MarkShape, Rgba, Sampler, Texture};
use camera_lab_engine::camera::{Camera, Parameters, Projection, ViewWindow};
use camera_lab_engine::scene::primitives;
use camera_lab_engine::scene::{
    Adjacency, Light, Line, Mesh, Object, ObjectPaint, Pictured, PointMark, Scene, Shadows,
};
use glam::{DMat4, DQuat, DVec3, EulerRot, Vec3Swizzles as _};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use super::scenes::CLAY;

/// The same cases in every run, unless `PROPTEST_RNG_SEED` asks for others. There are `PROPTEST_CASES` (256) times
/// `factor` of them.
pub(crate) fn reproducible(factor: u32) -> ProptestConfig {
    let config = ProptestConfig::default();
    let rng_seed = match config.rng_seed {
        RngSeed::Random => RngSeed::Fixed(2026),
        fixed => fixed,
    };
    ProptestConfig { cases: config.cases * factor, failure_persistence: None, rng_seed, ..config }
}

fn any_mesh() -> impl Strategy<Value = Mesh> {
    prop_oneof![
        Just(primitives::cube()),
        Just(primitives::pyramid()),
        (3_u32..12).prop_map(primitives::sphere),
        (3_u32..12).prop_map(primitives::cone),
        (3_u32..9).prop_map(primitives::torus),
    ]
}

fn any_vec(range: f64) -> impl Strategy<Value = DVec3> {
    (-range..range, -range..range, -range..range).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

fn any_color() -> impl Strategy<Value = Rgba> {
    let alpha = prop_oneof![3 => Just(255_u8), 1 => 0_u8..255];
    (any::<[u8; 3]>(), alpha).prop_map(|([r, g, b], a)| Rgba::rgba(r, g, b, a))
}

fn any_line_style() -> impl Strategy<Value = LineStyle> {
    let hidden = prop_oneof![Just(HiddenLines::Dashed), Just(HiddenLines::Hidden), Just(HiddenLines::Shown)];
    (any_color(), 0.5_f32..4.0, hidden, any::<bool>()).prop_map(|(color, width, hidden, arrow)| LineStyle {
        color,
        width,
        dash: Dash::Solid,
        hidden,
        arrow,
    })
}

pub(crate) fn any_object() -> impl Strategy<Value = Object> {
    let scale = prop_oneof![4 => any_vec(2.0), 1 => Just(DVec3::ONE), 1 => Just(DVec3::new(1.0, 0.0, 1.0))];
    let place = (scale, any_vec(3.2), any_vec(3.0)).prop_map(|(scale, angles, at)| {
        let turn = DQuat::from_euler(EulerRot::XYZ, angles.x, angles.y, angles.z);
        DMat4::from_scale_rotation_translation(scale, turn, at)
    });
    let flags = (any::<bool>(), proptest::bool::weighted(0.2), proptest::bool::weighted(0.9));
    let edges = proptest::option::weighted(0.3, any_line_style());
    (any_mesh(), place, any_color(), any::<u8>(), flags, edges).prop_map(
        |(mesh, world_from_object, color, kind, (lit, two_sided, faces), edges)| {
            let varied = |n: usize| {
                let shade = |i: usize| Rgba { r: color.r ^ u8::try_from(i * 37 % 256).unwrap(), ..color };
                Arc::new((0..n).map(shade).collect::<Vec<_>>())
            };
            let paint = match kind % 9 {
                0 | 1 => ObjectPaint::Faces(varied(mesh.triangles.len())),
                2 | 3 => ObjectPaint::Vertices(varied(mesh.positions.len())),
                4 => {
                    // Premultiplied: alpha, the fourth channel, is the greatest. Some are clear in places, some of one
                    // colour.
                    let clear = kind % 2 == 0;
                    let step = if kind % 5 == 0 { 0 } else { 15 };
                    let texel = |i: u8| {
                        if clear {
                            100 + 30 * (i % 4) - step * (i / 4)
                        } else {
                            [165, 195 - step * (i / 4), 20, 255][usize::from(i % 4)]
                        }
                    };
                    let image = Texture::flat(2, 2, (0..16).map(texel).collect());
                    let uv = mesh.positions.iter().map(|p| (2.0 * p.as_vec3()).xz().to_array()).collect();
                    let plain = Pictured::plain(Arc::new(image.with_levels()), uv, color.a);
                    let sampler = [Sampler::PICTURE, Sampler::default()][usize::from(kind) / 9 % 2];
                    let translucent = clear || !color.is_opaque();
                    ObjectPaint::Texture(Pictured { sampler, tint: color, translucent, ..plain })
                }
                _ => ObjectPaint::Solid(color),
            };
            let name = "thing";
            let outline = edges.filter(|_| kind % 2 == 0);
            let mesh = Arc::new(Mesh { adjacency: Adjacency::of(&mesh.positions, &mesh.triangles), ..mesh });
            Object { lit, two_sided, faces, edges, outline, ..Object::new(name, mesh, world_from_object, paint) }
        },
    )
}

pub(crate) fn any_scene() -> impl Strategy<Value = Scene> {
    let light = prop_oneof![any_vec(1.0).prop_map(Light::directional), any_vec(5.0).prop_map(Light::point)];
    let light = (light, any::<bool>())
        .prop_map(|(light, cast)| light.with_shadows(Shadows { cast, map: Shadows::MAPS[0], ..Shadows::NONE }));
    let line = (proptest::collection::vec(any_vec(6.0), 2..5), any_line_style())
        .prop_map(|(points, style)| Line::new(points, style));
    let mark = any_vec(4.0).prop_map(|position| PointMark {
        position,
        shape: MarkShape::Disc,
        radius: 2.0,
        color: CLAY,
        fade_if_hidden: true,
    });
    let few = proptest::collection::vec(any_object(), 1..4);
    // So many that there is a tree over them.
    let many = (proptest::collection::vec(any_object(), 1..3), 16_u32..40).prop_map(|(kinds, n)| {
        let copy = |k: u32| {
            let at = DVec3::new(f64::from(k % 5) - 2.0, f64::from(k / 5) - 3.0, 0.3 * f64::from(k % 7));
            let place = DMat4::from_translation(at * 2.0) * DMat4::from_scale(DVec3::splat(0.4));
            let kind = &kinds[k as usize % kinds.len()];
            Object { world_from_object: place * kind.world_from_object, ..kind.clone() }
        };
        (0..n).map(copy).collect()
    });
    (
        prop_oneof![7 => few, 1 => many],
        proptest::collection::vec(light, 0..3),
        proptest::collection::vec(line, 0..2),
        proptest::collection::vec(mark, 0..2),
    )
        .prop_map(|(objects, lights, lines, marks)| Scene { objects, lights, lines, marks, ..Scene::default() })
}

pub(crate) fn any_camera() -> impl Strategy<Value = Camera> {
    let window = proptest::option::weighted(
        0.3,
        (-0.3..-0.01, 0.02..0.4, -0.2..0.1, 0.11..0.3).prop_map(|(left, right, bottom, top)| ViewWindow {
            left,
            right,
            bottom,
            top,
        }),
    );
    (any_vec(6.0), any_vec(1.0), any::<bool>(), 0.2..4.0, 10.0..90.0, window).prop_filter_map(
        "no camera",
        |(position, focal_point, perspective, near, view_angle, window)| {
            let projection = if perspective { Projection::Perspective } else { Projection::Parallel };
            Camera::new(&Parameters {
                position,
                focal_point,
                projection,
                view_angle,
                height: 5.0,
                near,
                far: near + 6.0,
                window: window.map(|w: ViewWindow| {
                    let s = if perspective { near * 2.0 } else { 10.0 };
                    ViewWindow { left: w.left * s, right: w.right * s, bottom: w.bottom * s, top: w.top * s }
                }),
                ..Parameters::default()
            })
            .ok()
        },
    )
}
