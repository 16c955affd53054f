//! Conventions of NDC: the matrices of each compared with glam, with the output of GLM, three.js and VTK, and with 512
//! bits. Also the places of near, far and the corners, the way back, and the far plane that goes to infinity.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{
    Camera, ClipSpace, ImageSize, InfiniteParallel, Ndc, Parameters, Projection, Stations, ViewWindow, Viewport,
};
use camera_lab::chain;
use camera_lab::chain::real::Real;
use camera_lab::inspect::Report;
use camera_lab::numerics::reference::Reference;
use glam::{DMat4, DVec3, DVec4, dcamera::rh::proj};
use proptest::prelude::*;

use crate::common::any_camera::any_camera;
use crate::common::camera::{camera, rows};
use crate::common::program::Bench;

fn ndc(name: &str) -> Ndc {
    Ndc::ALL.into_iter().find(|ndc| ndc.name() == name).unwrap()
}

/// The conventions in which the camera has matrices.
fn spaces(camera: &Camera) -> impl Iterator<Item = ClipSpace<'_>> {
    Ndc::ALL.into_iter().filter_map(|ndc| camera.clip_space(ndc).ok())
}

/// Entries that differ by no more than some ε of themselves, or of a greatest entry if cancelling terms were rounded
/// before.
#[track_caller]
fn assert_near(found: DMat4, expected: DMat4, relative: f64, absolute: f64, what: &str) {
    for (a, b) in found.to_cols_array().into_iter().zip(expected.to_cols_array()) {
        let slack = relative * f64::EPSILON * b.abs() + absolute;
        assert!((a - b).abs() <= slack, "{what}: {a:?} is not {b:?}\n{found}\n{expected}");
    }
}

fn from_rows(rows: [[f64; 4]; 4]) -> DMat4 {
    DMat4::from_cols_array_2d(&rows).transpose()
}

#[test]
fn names_are_those_of_the_contract() {
    let names: Vec<&str> = Ndc::ALL.into_iter().map(Ndc::name).collect();
    let mut expected = Vec::new();
    for api in ["opengl", "direct3d", "vulkan", "metal", "webgpu"] {
        expected.extend(["", "-reversed", "-infinite", "-reversed-infinite"].map(|rest| format!("{api}{rest}")));
    }
    assert_eq!(names, expected);
    assert_eq!(Ndc::ALL[0], Ndc::default());
    for ndc in Ndc::ALL {
        assert_eq!((ndc.name().contains("reversed"), ndc.name().contains("infinite")), (ndc.reversed, ndc.infinite));
    }
}

#[test]
fn the_default_is_the_notes() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        let camera = camera(|p| p.projection = projection);
        let space = camera.clip_space(Ndc::default()).unwrap();
        assert_eq!(space.clip_from_view(), camera.clip_from_view());
        assert_eq!(space.view_from_clip(), camera.view_from_clip());
        assert_eq!(space.clip_from_world(), camera.clip_from_world());
        let (image, point) = (ImageSize::default(), DVec3::new(0.3, -0.2, 0.1));
        let viewport = Viewport::whole(image);
        assert_eq!(space.stations(point, image, &viewport), camera.stations(point, image, &viewport));
    }
}

/// glam's functions for the same convention, or `None` if it has none.
fn glam(camera: &Camera, ndc: Ndc) -> Option<DMat4> {
    let ViewWindow { left, right, bottom, top } = camera.window();
    let (near, far) = (camera.near(), camera.far());
    let (theta, aspect) = (camera.view_angle().radians(), camera.window_aspect());
    let symmetric = left == -right && bottom == -top;
    let down = ndc.y_points_down();
    let unit = ndc.depths() == [0.0, 1.0];
    Some(match (camera.projection(), ndc.reversed, ndc.infinite) {
        (Projection::Parallel, _, true) => return None,
        // Reversed is with near and far exchanged.
        (Projection::Parallel, reversed, false) => {
            let [near, far] = if reversed { [far, near] } else { [near, far] };
            match (down, unit || reversed) {
                // (glam 0.34.2 forgets the sign of the last entry of row Y in proj::vulkan::orthographic: t would not
                // land at −1.)
                (true, _) if !symmetric => {
                    DMat4::from_scale(DVec3::new(1.0, -1.0, 1.0))
                        * proj::directx::orthographic(left, right, bottom, top, near, far)
                }
                (true, _) => proj::vulkan::orthographic(left, right, bottom, top, near, far),
                (false, true) => proj::directx::orthographic(left, right, bottom, top, near, far),
                (false, false) => proj::opengl::orthographic(left, right, bottom, top, near, far),
            }
        }
        (Projection::Perspective, false, false) => match (down, unit) {
            (true, _) => proj::vulkan::frustum(left, right, bottom, top, near, far),
            (false, true) => proj::directx::frustum(left, right, bottom, top, near, far),
            (false, false) => proj::opengl::frustum(left, right, bottom, top, near, far),
        },
        (Projection::Perspective, true, false) if symmetric && down => {
            proj::vulkan::perspective(theta, aspect, far, near)
        }
        (Projection::Perspective, true, false) if symmetric => proj::directx::perspective(theta, aspect, far, near),
        (Projection::Perspective, false, true) if symmetric && down => {
            proj::vulkan::perspective_infinite(theta, aspect, near)
        }
        (Projection::Perspective, false, true) if symmetric && unit => {
            proj::directx::perspective_infinite(theta, aspect, near)
        }
        (Projection::Perspective, true, true) if symmetric && down => {
            proj::vulkan::perspective_infinite_reverse(theta, aspect, near)
        }
        (Projection::Perspective, true, true) if symmetric => {
            proj::directx::perspective_infinite_reverse(theta, aspect, near)
        }
        (Projection::Perspective, ..) => return None,
    })
}

#[test]
fn the_matrices_are_those_of_glam() {
    let window = Some(ViewWindow { left: -0.3, right: 0.7, bottom: -0.2, top: 0.1 });
    let mut compared = 0;
    for projection in [Projection::Perspective, Projection::Parallel] {
        for window in [None, window] {
            let camera = camera(|p| {
                (p.projection, p.window, p.view_angle, p.aspect, p.near, p.far) =
                    (projection, window, 40.0, 1.5, 0.25, 80.0);
            });
            for space in spaces(&camera) {
                let Some(expected) = glam(&camera, space.ndc()) else { continue };
                compared += 1;
                assert_near(space.clip_from_view(), expected, 8.0, 2.0 * f64::EPSILON, space.ndc().name());
            }
        }
    }
    // Not: reversed or infinite with a given window in perspective, and OpenGL infinite.
    assert_eq!(compared, 19 + 5 + 10 + 10);
}

/// Rows of M_p as libraries print them for θ = 40°, A = 1.5, F = 0.25, B = 80.
mod recorded {
    const X: f64 = 1.831_651_612_969_748_2;
    const Y: f64 = 2.747_477_419_454_622_5;

    const fn perspective(z: f64, depth: f64) -> [[f64; 4]; 4] {
        [[X, 0.0, 0.0, 0.0], [0.0, Y, 0.0, 0.0], [0.0, 0.0, z, depth], [0.0, 0.0, -1.0, 0.0]]
    }

    const fn parallel(x: f64, y: f64, [skew_x, skew_y]: [f64; 2], z: f64, depth: f64) -> [[f64; 4]; 4] {
        [[x, 0.0, 0.0, skew_x], [0.0, y, 0.0, skew_y], [0.0, 0.0, z, depth], [0.0, 0.0, 0.0, 1.0]]
    }

    /// three.js r187: `new PerspectiveCamera(40, 1.5, 0.25, 80)`, `coordinateSystem` WebGL or WebGPU, reversed depth or
    /// not; `projectionMatrix` of `Matrix4.makePerspective` in `src/math/Matrix4.js` (c = −(f + n)/(f − n), d = −2fn/(f
    /// − n) for WebGL, c = −f/(f − n), d = −fn/(f − n) for WebGPU, c = n/(f − n), d = fn/(f − n) reversed).
    pub(super) const THREE_JS: [(&str, [[f64; 4]; 4]); 4] = [
        ("opengl", perspective(-1.006_269_592_476_489, -0.501_567_398_119_122_2)),
        ("opengl-reversed", perspective(0.003_134_796_238_244_514, 0.250_783_699_059_561_1)),
        ("webgpu", perspective(-1.003_134_796_238_244_4, -0.250_783_699_059_561_1)),
        ("webgpu-reversed", perspective(0.003_134_796_238_244_514, 0.250_783_699_059_561_1)),
    ];

    /// three.js r187: `new OrthographicCamera(-0.3, 0.7, 0.1, -0.2, 0.25, 80)` in the same ways.
    pub(super) const THREE_JS_PARALLEL: [(&str, [[f64; 4]; 4]); 4] = {
        let (x, y, skew) = (2.0, 6.666_666_666_666_666, [-0.399_999_999_999_999_9, 0.333_333_333_333_333_26]);
        [
            ("opengl", parallel(x, y, skew, -0.025_078_369_905_956_112, -1.006_269_592_476_489)),
            ("opengl-reversed", parallel(x, y, skew, 0.012_539_184_952_978_056, 1.003_134_796_238_244_4)),
            ("webgpu", parallel(x, y, skew, -0.012_539_184_952_978_056, -0.003_134_796_238_244_514)),
            ("webgpu-reversed", parallel(x, y, skew, 0.012_539_184_952_978_056, 1.003_134_796_238_244_4)),
        ]
    };

    /// VTK 9.7.2: `vtkCamera` with `SetViewAngle(40)`, `SetClippingRange(0.25, 80)`,
    /// `GetProjectionTransformMatrix(1.5, nearz, farz)` with (nearz, farz) = (−1, 1), (0, 1) and (1, 0):
    /// `vtkPerspectiveTransform::Perspective`, then `AdjustZBuffer(-1, 1, nearz, farz)`.
    pub(super) const VTK: [(&str, [[f64; 4]; 4]); 3] = [
        ("opengl", perspective(-1.006_269_592_476_489, -0.501_567_398_119_122_2)),
        ("direct3d", perspective(-1.003_134_796_238_244_4, -0.250_783_699_059_561_1)),
        ("direct3d-reversed", perspective(0.003_134_796_238_244_530_5, 0.250_783_699_059_561_1)),
    ];

    /// VTK 9.7.2: the same with `SetParallelProjection(1)`, `SetParallelScale(1.5)` (half of H).
    pub(super) const VTK_PARALLEL: [(&str, [[f64; 4]; 4]); 3] = {
        let (x, y) = (0.444_444_444_444_444_4, 0.666_666_666_666_666_6);
        [
            ("opengl", parallel(x, y, [0.0; 2], -0.025_078_369_905_956_112, -1.006_269_592_476_489)),
            ("direct3d", parallel(x, y, [0.0; 2], -0.012_539_184_952_978_056, -0.003_134_796_238_244_530_5)),
            ("direct3d-reversed", parallel(x, y, [0.0; 2], 0.012_539_184_952_978_056, 1.003_134_796_238_244_4)),
        ]
    };

    /// GLM 1.1.0 (b1fed407): `perspectiveRH_NO(radians(40), 1.5, 0.25, 80)`, `perspectiveRH_ZO` forwards and with near
    /// and far exchanged (reversed), `infinitePerspectiveRH_NO` and `_ZO`, of `glm/ext/matrix_clip_space.inl`, in
    /// double.
    pub(super) const GLM: [(&str, [[f64; 4]; 4]); 5] = [
        ("opengl", perspective(-1.006_269_592_476_489, -0.501_567_398_119_122_2)),
        ("metal", perspective(-1.003_134_796_238_244_4, -0.250_783_699_059_561_1)),
        ("metal-reversed", perspective(0.003_134_796_238_244_514, 0.250_783_699_059_561_1)),
        ("opengl-infinite", perspective(-1.0, -0.5)),
        ("metal-infinite", perspective(-1.0, -0.25)),
    ];

    const fn frustum(z: f64, depth: f64) -> [[f64; 4]; 4] {
        [
            [0.5, 0.0, 0.399_999_999_999_999_97, 0.0],
            [0.0, 1.666_666_666_666_666_5, -0.333_333_333_333_333_3, 0.0],
            [0.0, 0.0, z, depth],
            [0.0, 0.0, -1.0, 0.0],
        ]
    }

    /// GLM 1.1.0: `frustumRH_NO(-0.3, 0.7, -0.2, 0.1, 0.25, 80)` and `frustumRH_ZO`.
    pub(super) const GLM_FRUSTUM: [(&str, [[f64; 4]; 4]); 2] = [
        ("opengl", frustum(-1.006_269_592_476_489, -0.501_567_398_119_122_2)),
        ("metal", frustum(-1.003_134_796_238_244_4, -0.250_783_699_059_561_1)),
    ];

    /// GLM 1.1.0: `orthoRH_NO(-0.3, 0.7, -0.2, 0.1, 0.25, 80)`, `orthoRH_ZO`, and with near and far exchanged
    /// (reversed).
    pub(super) const GLM_PARALLEL: [(&str, [[f64; 4]; 4]); 3] = {
        let (x, y, skew) = (2.0, 6.666_666_666_666_666, [-0.399_999_999_999_999_97, 0.333_333_333_333_333_3]);
        [
            ("opengl", parallel(x, y, skew, -0.025_078_369_905_956_112, -1.006_269_592_476_489)),
            ("metal", parallel(x, y, skew, -0.012_539_184_952_978_056, -0.003_134_796_238_244_514)),
            ("metal-reversed", parallel(x, y, skew, 0.012_539_184_952_978_056, 1.003_134_796_238_244_4)),
        ]
    };
}

#[test]
fn the_matrices_are_those_that_other_libraries_print() {
    let skewed = Some(ViewWindow { left: -0.3, right: 0.7, bottom: -0.2, top: 0.1 });
    let of = |projection, window, height| {
        camera(|p| {
            (p.projection, p.window, p.height) = (projection, window, height);
            (p.view_angle, p.aspect, p.near, p.far) = (40.0, 1.5, 0.25, 80.0);
        })
    };
    let perspective = of(Projection::Perspective, None, 1.0);
    let frustum = of(Projection::Perspective, skewed, 1.0);
    let parallel = of(Projection::Parallel, None, 3.0);
    let skewed = of(Projection::Parallel, skewed, 1.0);
    let of = |library, camera, recorded: &[(&'static str, [[f64; 4]; 4])]| {
        recorded.iter().map(|(name, rows)| (library, camera, *name, *rows)).collect::<Vec<_>>()
    };
    let all = [
        of("three.js", &perspective, &recorded::THREE_JS),
        of("three.js", &skewed, &recorded::THREE_JS_PARALLEL),
        of("VTK", &perspective, &recorded::VTK),
        of("VTK", &parallel, &recorded::VTK_PARALLEL),
        of("GLM", &perspective, &recorded::GLM),
        of("GLM", &frustum, &recorded::GLM_FRUSTUM),
        of("GLM", &skewed, &recorded::GLM_PARALLEL),
    ];
    for (library, camera, name, rows) in all.concat() {
        let found = camera.clip_space(ndc(name)).unwrap().clip_from_view();
        // VTK makes its (0, 1) and (1, 0) from (−1, 1): cancelling terms are rounded to ε of 1.
        assert_near(found, from_rows(rows), 4.0, f64::EPSILON / 2.0, &format!("{library}, {name}"));
    }
}

/// The rows Z and Y of M_p from z₀ (at F), z₁ (at B) and the direction of y, in 512 bits. With an infinite far plane,
/// its limits.
fn in_512_bits(p: &Parameters, ndc: Ndc) -> [[f64; 4]; 4] {
    let mut matrix = chain::projection_matrix(&chain::Given::<Reference>::of(p), Ndc::default());
    let of = Reference::of;
    let [at_near, at_far] = ndc.depths().map(of);
    let (near, far) = (of(p.near), of(p.far));
    let (range, depth) = (at_near.clone() - at_far.clone(), far.clone() - near.clone());
    let (near_z, far_z) = (at_near.clone() * near.clone(), at_far.clone() * far.clone());
    let (z, d) = match (p.projection, ndc.infinite) {
        (Projection::Perspective, true) => (-at_far, range * near),
        (Projection::Perspective, false) => ((near_z - far_z) / depth.clone(), range * near * far / depth),
        (Projection::Parallel, _) => (range / depth.clone(), (at_near * far - at_far * near) / depth),
    };
    matrix.0[2] = [Reference::zero(), Reference::zero(), z, d];
    if ndc.y_points_down() {
        matrix.0[1] = matrix.0[1].clone().map(|entry| -entry);
    }
    // The rounding error of an exact zero after 512 bits is zero.
    matrix.0.map(|row| row.map(|x| if x.to_f64().abs() < 1e-140 { 0.0 } else { x.to_f64() }))
}

/// All of it for a camera, in every convention in which it has matrices.
fn check(camera: &Camera) -> Result<(), TestCaseError> {
    for space in spaces(camera) {
        let name = space.ndc().name();
        prop_assert!(space.clip_from_world().is_finite() && space.view_from_clip().is_finite(), "{name}");
        let found = rows(space.clip_from_view());
        let exact = in_512_bits(camera.parameters(), space.ndc());
        for (a, b) in found.iter().flatten().zip(exact.iter().flatten()) {
            // The last bit may go the other way if the reference rounds twice.
            prop_assert!((a - b).abs() <= f64::EPSILON * b.abs(), "{name}: {found:?} is not {exact:?}");
        }
        lands(camera, &space)?;
        round_trip(&space)?;
    }
    Ok(())
}

/// The corners of the window at F and B have |x_n| = |y_n| = 1 and the depths of the convention.
fn lands(camera: &Camera, space: &ClipSpace<'_>) -> Result<(), TestCaseError> {
    let (ndc, w) = (space.ndc(), camera.window());
    let (near, far) = (camera.near(), camera.far());
    let up = if ndc.y_points_down() { -1.0 } else { 1.0 };
    let [at_near, at_far] = ndc.depths();
    for (distance, depth) in [(near, at_near), (far, at_far)] {
        let spread = if camera.projection() == Projection::Perspective { distance / near } else { 1.0 };
        for (x, y, expected) in [(w.left, w.bottom, [-1.0, -up]), (w.right, w.top, [1.0, up])] {
            let clip = space.clip_from_view() * DVec4::new(x * spread, y * spread, -distance, 1.0);
            let p = clip / clip.w;
            // The sides are rounded to ε of their size, the entries of a thin depth to ε of theirs.
            let stiff = 8.0 * f64::EPSILON * (1.0 + far / (far - near));
            let slack = |a: f64, b: f64| 8.0 * f64::EPSILON * (1.0 + a.abs().max(b.abs()) / (b - a));
            prop_assert!((p.x - expected[0]).abs() <= slack(w.left, w.right), "{}: {p}", ndc.name());
            prop_assert!((p.y - expected[1]).abs() <= slack(w.bottom, w.top), "{}: {p}", ndc.name());
            if ndc.infinite && distance == far {
                // Short of the far depth by the part that is left behind B: (z₁ − z₀) F/B.
                let expected = at_far - (at_far - at_near) * (near / far);
                prop_assert!((p.z - expected).abs() <= 4.0 * f64::EPSILON, "{}: {p}", ndc.name());
            } else {
                prop_assert!((p.z - depth).abs() <= stiff, "{}: {p}", ndc.name());
            }
        }
    }
    Ok(())
}

/// The inverse, in closed form, times the matrix is 1 in 512 bits, each entry within the rounding of both.
fn round_trip(space: &ClipSpace<'_>) -> Result<(), TestCaseError> {
    let (columns, back) = (space.clip_from_view().to_cols_array_2d(), rows(space.view_from_clip()));
    for (i, row) in back.iter().enumerate() {
        for (j, column) in columns.iter().enumerate() {
            let products = || row.iter().zip(column);
            let sum = products()
                .map(|(a, b)| Reference::of(*a) * Reference::of(*b))
                .fold(Reference::zero(), |sum, term| sum + term);
            let expected = if i == j { 1.0 } else { 0.0 };
            let size: f64 = products().map(|(a, b)| (a * b).abs()).sum();
            let off = (sum - Reference::of(expected)).to_f64().abs();
            prop_assert!(off <= 2.0 * f64::EPSILON * size, "{} {i} {j}: {off:e} of {size:e}", space.ndc().name());
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn near_far_and_corners_land_on_the_box_and_come_back(camera in any_camera()) {
        check(&camera)?;
    }

    #[test]
    fn view_window_and_pixel_are_the_same_in_every_convention(camera in any_camera(), along in -0.5..1.5, x in -1.5..1.5, y in -1.5..1.5) {
        let corners = camera.volume_corners();
        let [near, far]: [DVec3; 2] = [0, 4].map(|first| {
            let [a, b, d] = [corners[first], corners[first + 1], corners[first + 3]];
            a + (b - a) * (0.5 + 0.5 * x) + (d - a) * (0.5 + 0.5 * y)
        });
        let point = near.lerp(far, along);
        prop_assume!(point.is_finite());
        let image = ImageSize { width: 640, height: 480 };
        let viewport = Viewport::whole(image);
        let notes: Stations = camera.stations(point, image, &viewport);
        let Some(projected) = notes.projected else { return Ok(()) };
        for space in spaces(&camera) {
            let found = space.stations(point, image, &viewport);
            let there = found.projected.unwrap();
            prop_assert_eq!((found.view, there.window, there.pixel, there.viewport), (notes.view, projected.window, projected.pixel, projected.viewport));
            let up = if space.ndc().y_points_down() { -1.0 } else { 1.0 };
            prop_assert_eq!((there.ndc.x, there.ndc.y), (projected.ndc.x, up * projected.ndc.y));
            prop_assert_eq!((found.clip.x, found.clip.y, found.clip.w), (notes.clip.x, up * notes.clip.y, notes.clip.w));
            // Away from the planes all conventions say the same of inside.
            let clear = |z: f64| (z.abs() - 1.0).abs() > 1e-9;
            if clear(projected.ndc.x) && clear(projected.ndc.y) && clear(projected.ndc.z) && !space.ndc().infinite {
                prop_assert_eq!(found.inside, notes.inside, "{}", space.ndc().name());
            }
        }
    }
}

#[test]
fn a_growing_far_distance_approaches_the_infinite_matrix() {
    for name in ["opengl", "opengl-reversed", "direct3d", "vulkan", "webgpu-reversed"] {
        let finite = ndc(name);
        let limit = Ndc { infinite: true, ..finite };
        let off = |far: f64| {
            let camera = camera(|p| (p.near, p.far) = (0.5, far));
            let [a, b] = [finite, limit].map(|ndc| camera.clip_space(ndc).unwrap());
            let [forth, back] = [(a.clip_from_view() - b.clip_from_view()), (a.view_from_clip() - b.view_from_clip())];
            [forth, back].map(|m| m.to_cols_array().into_iter().fold(0.0_f64, |most, x| most.max(x.abs())))
        };
        // As F/B. The limit itself does not depend on B.
        for far in [1e3, 1e6, 1e9] {
            for off in off(far) {
                assert!(off > 0.1 / far && off < 4.0 / far, "{name}, B = {far}: {off}");
            }
        }
        assert!(off(1e300).into_iter().all(|off| off < 1e-299), "{name}");
    }
    let camera = camera(|p| (p.near, p.far) = (0.5, 10.0));
    let row = |name: &str| camera.clip_space(ndc(name)).unwrap().clip_from_view().row(2);
    assert_eq!(row("opengl-infinite"), DVec4::new(0.0, 0.0, -1.0, -1.0));
    assert_eq!(row("metal-infinite"), DVec4::new(0.0, 0.0, -1.0, -0.5));
    assert_eq!(row("opengl-reversed-infinite"), DVec4::new(0.0, 0.0, 0.0, 0.5));
    assert_eq!(row("vulkan-reversed-infinite"), DVec4::new(0.0, 0.0, 0.0, 0.5));
}

#[test]
fn inside_has_the_range_of_the_convention() {
    // θ = 90°, A = 1, looking along −z from the origin: |x|, |y| ≤ distance.
    let camera = camera(|p| {
        (p.position, p.focal_point) = (DVec3::ZERO, DVec3::NEG_Z);
        (p.view_angle, p.aspect, p.near, p.far) = (90.0, 1.0, 1.0, 4.0);
    });
    let image = ImageSize { width: 10, height: 10 };
    for space in spaces(&camera) {
        let ndc = space.ndc();
        for (distance, finite, infinite) in [
            (0.5, false, false),
            (1.0, true, true),
            (2.0, true, true),
            (4.0, true, true),
            (5.0, false, true),
            (1e300, false, true),
            (-2.0, false, false),
        ] {
            for (x, y, fits) in [(0.0, 0.0, true), (1.0, -1.0, true), (1.01, 0.0, false), (0.0, -1.01, false)] {
                let point = DVec3::new(x * distance, y * distance, -distance);
                let stations = space.stations(point, image, &Viewport::whole(image));
                let expected = fits && if ndc.infinite { infinite } else { finite };
                assert_eq!(stations.inside, expected, "{}: {point}", ndc.name());
            }
        }
    }
}

#[test]
fn parallel_projection_without_a_far_plane_has_no_matrix() {
    let camera = camera(|p| p.projection = Projection::Parallel);
    for ndc in Ndc::ALL {
        let found = camera.clip_space(ndc).map(|space| space.clip_from_view());
        if ndc.infinite {
            assert_eq!(found, Err(InfiniteParallel(ndc)));
        } else {
            assert!(found.is_ok());
        }
    }
}

#[test]
fn the_report_names_the_convention_and_follows_it() {
    let camera = camera(|p| (p.near, p.far) = (2.0, 6.0));
    let of = |name: &str| {
        let space = camera.clip_space(ndc(name)).unwrap();
        Report::of(&space, ImageSize::default(), None, &[DVec3::new(0.5, 0.25, 1.0)], &[[3, 4]]).unwrap()
    };
    let (notes, vulkan) = (of("opengl"), of("vulkan-reversed"));
    assert_eq!((notes.ndc, vulkan.ndc), ("opengl", "vulkan-reversed"));
    assert_eq!(vulkan.projection_matrix[2], [0.0, 0.0, 0.5, 3.0]);
    assert_eq!(vulkan.projection_matrix[1][1], -notes.projection_matrix[1][1]);
    assert_eq!(vulkan.view_projection_matrix[1], notes.view_projection_matrix[1].map(|x| -x + 0.0));
    assert_eq!(vulkan.inverse_projection_matrix[3], [0.0, 0.0, 1.0 / 3.0, 1.0 / 6.0]);
    let (a, b) = (notes.points[0], vulkan.points[0]);
    assert_eq!((a.view, a.window, a.pixel, a.viewport, a.inside), (b.view, b.window, b.pixel, b.viewport, b.inside));
    assert_ne!((a.clip, a.ndc), (b.clip, b.ndc));
    assert_eq!(
        (&notes.rays, notes.volume_corners, notes.view_matrix),
        (&vulkan.rays, vulkan.volume_corners, vulkan.view_matrix)
    );
}

#[test]
fn the_command_line_takes_the_convention() {
    let bench = Bench::new("ndc");
    bench.write("a.toml", "[camera]\nnear = 2\nfar = 6\n");
    bench.write("b.toml", "[camera]\nprojection = \"parallel\"\n");
    let inspect = |arguments: &[&str]| bench.run(&[&["inspect"], arguments].concat());
    let plain = inspect(&["a.toml"]);
    assert_eq!(plain.out, inspect(&["a.toml", "--ndc", "opengl"]).out);
    assert_eq!(plain.json()["ndc"], "opengl");
    for ndc in Ndc::ALL {
        let report = inspect(&["a.toml", "--ndc", ndc.name(), "--point", "0,0,0"]).json();
        assert_eq!(report["ndc"], ndc.name());
        let m = &report["projection_matrix"];
        let [at_near, at_far] = ndc.depths();
        let z = |distance: f64| (m[2][3].as_f64().unwrap() - distance * m[2][2].as_f64().unwrap()) / distance;
        assert!((z(2.0) - at_near).abs() < 1e-15);
        assert!(ndc.infinite || (z(6.0) - at_far).abs() < 1e-15);
    }
    let refused = inspect(&["b.toml", "--ndc", "vulkan-infinite"]);
    assert_eq!((refused.status, refused.out.len()), (Some(2), 0));
    assert!(refused.err.contains("b.toml: vulkan-infinite moves the back plane to infinity"), "{}", refused.err);
    let refused = inspect(&["b.toml", "--ndc", "vulkan-infinite", "--lang", "pt-BR"]);
    assert!(refused.err.contains("b.toml: vulkan-infinite leva o plano de fundo ao infinito"), "{}", refused.err);
    let unknown = inspect(&["a.toml", "--ndc", "direct3d-inverted"]);
    assert_eq!((unknown.status, unknown.out.len()), (Some(2), 0));
    for part in [
        "direct3d-inverted",
        "opengl, opengl-reversed",
        "webgpu-reversed-infinite",
        "a similar value exists: 'direct3d-reversed'",
    ] {
        assert!(unknown.err.contains(part), "{part}: {}", unknown.err);
    }
    let unknown = inspect(&["a.toml", "--ndc", "vulcan", "--lang", "pt-BR"]).err;
    assert!(unknown.contains("permitido: opengl, ") && unknown.contains("você quis dizer: vulkan"), "{unknown}");
}
