//! Cameras, operations, points and scenes that no person would write, and the invariants they must keep: `cargo test`
//! tries some, the example `stress` as many as you ask for.

use camera_lab::appearance::{Samples, Shading, Style, Visibility};
use camera_lab::camera::{Camera, Convention, ImageSize, Operation, Parameters, Projection, ViewWindow, Viewport};
use camera_lab::figure::Figure;
use camera_lab::geometry::Angle;
use camera_lab::numbers::random::Random;
use camera_lab::progress::Progress;
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{ObjectSpec, Preset, SceneSpec, Shape, no_files};
use camera_lab::views::{Request, SharedScene, Size, TimedPipeline, View, frame, scene_of};
use camera_lab_words::{Lang, pictures};
use glam::{DMat4, DVec3};

/// The numbers of things tried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Tried {
    /// Parameters, and how many of them are those of a camera.
    pub(crate) parameters: u64,
    pub(crate) cameras: u64,
    /// Operations on a camera.
    pub(crate) operations: u64,
    /// Points that went through all spaces.
    pub(crate) points: u64,
    /// Pictures, to the last pixel.
    pub(crate) pictures: u64,
}

/// Tries number `case` of a seed, with a picture of each `picture_of`-th camera.
///
/// # Errors
/// The broken invariant.
pub(crate) fn case(seed: u64, case: u64, picture_of: u64, tried: &mut Tried) -> Result<(), String> {
    let mut random = Random::new(seed, case);
    let parameters = parameters(&mut random);
    tried.parameters += 1;
    let Ok(mut camera) = Camera::new(&parameters) else { return Ok(()) };
    tried.cameras += 1;
    let failed = |camera: &Camera, what: String| format!("{what}; {:?}", camera.parameters());
    check(&camera).map_err(|what| failed(&camera, what))?;
    for _ in 0..2 {
        tried.operations += 1;
        if let Ok(next) = operation(&mut random).apply(&camera, Convention::RightHand) {
            camera = next;
            check(&camera).map_err(|what| failed(&camera, what))?;
        }
    }
    let image = ImageSize { width: 640, height: 480 };
    let viewport = Viewport::whole(image);
    let corners = camera.volume_corners();
    for k in 0..3 {
        tried.points += 1;
        let point = match k {
            0 => corners[pick(&mut random, 8)],
            1 => corners[0].lerp(corners[6], random.unit()),
            _ => camera.position() + vector(&mut random),
        };
        let stations = camera.stations(point, image, &viewport);
        let c = stations.clip;
        if !c.is_finite() {
            continue;
        }
        let inside = c.w > 0.0 && c.truncate().abs().max_element() <= c.w;
        if inside != stations.inside {
            return Err(failed(&camera, format!("{point}: inside is {}, but {c}", stations.inside)));
        }
        let in_ndc = stations.projected.is_none_or(|p| !stations.inside || p.ndc.abs().max_element() <= 1.0 + 1e-15);
        if !in_ndc {
            return Err(failed(&camera, format!("{point} is inside and not in the cube")));
        }
    }
    if case.is_multiple_of(picture_of) {
        picture(&mut random, &camera, tried).map_err(|what| failed(&camera, what))?;
    }
    Ok(())
}

fn pick(random: &mut Random, of: usize) -> usize {
    usize::try_from(random.bits() % of as u64).unwrap_or(0)
}

/// Every power of ten in a range as likely as every other.
fn size(random: &mut Random, exponents: f64) -> f64 {
    10f64.powf(random.between(-exponents, exponents))
}

/// Often a whole number, zero, or along an axis.
fn vector(random: &mut Random) -> DVec3 {
    let exponents = [1.0, 3.0, 12.0, 150.0][pick(random, 4)];
    let size = size(random, exponents);
    match pick(random, 4) {
        0 => DVec3::AXES[pick(random, 3)] * size,
        1 => (random.direction() * 4.0).round() * size,
        2 => DVec3::new(size, -size, random.between(-1.0, 1.0)),
        _ => random.direction() * size,
    }
}

fn parameters(random: &mut Random) -> Parameters {
    let base = Parameters::default();
    let position = vector(random);
    let toward = vector(random);
    let focal_point = position + toward;
    let view_up = match pick(random, 4) {
        0 => DVec3::Y,
        1 => vector(random),
        // Nearly along DOP.
        _ => toward + vector(random).normalize_or_zero() * (toward.length() * size(random, 15.0).min(1.0)),
    };
    let near = size(random, 12.0);
    let far = match pick(random, 3) {
        0 => near * (1.0 + size(random, 14.0).min(1.0)),
        _ => near * (1.0 + size(random, 15.0)),
    };
    let view_angle = match pick(random, 3) {
        0 => size(random, 7.0).min(179.999_999),
        1 => 180.0 - size(random, 7.0).min(179.0),
        _ => random.between(1.0, 120.0),
    };
    let middle = [random.between(-3.0, 3.0), random.between(-3.0, 3.0)].map(|v| v * size(random, 3.0));
    let half = [size(random, 6.0), size(random, 6.0)];
    let window = ViewWindow {
        left: middle[0] - half[0],
        right: middle[0] + half[0],
        bottom: middle[1] - half[1],
        top: middle[1] + half[1],
    };
    Parameters {
        position,
        focal_point,
        view_up,
        near,
        far,
        view_angle,
        height: size(random, 12.0),
        aspect: if pick(random, 2) == 0 { base.aspect } else { size(random, 6.0) },
        projection: [Projection::Perspective, Projection::Parallel][pick(random, 2)],
        window: (pick(random, 4) == 0).then_some(window),
    }
}

fn operation(random: &mut Random) -> Operation {
    let turn = [size(random, 15.0).min(1e6), random.between(-360.0, 360.0), 90.0, 180.0][pick(random, 4)];
    let (angle, factor) = (Angle::from_degrees(turn), size(random, 3.0));
    match pick(random, 8) {
        0 => Operation::Elevation(angle),
        1 => Operation::Azimuth(angle),
        2 => Operation::Roll(angle),
        3 => Operation::Yaw(angle),
        4 => Operation::Pitch(angle),
        5 => Operation::Zoom(factor),
        6 => Operation::Dolly(factor),
        _ => Operation::Pan { dx: random.between(-1.0, 1.0) * factor, dy: factor },
    }
}

/// The basis is orthonormal, and inverse matrices are inverse.
fn check(camera: &Camera) -> Result<(), String> {
    let b = camera.basis();
    let off = [b.u.dot(b.v), b.v.dot(b.n), b.n.dot(b.u), b.u.length() - 1.0, b.v.length() - 1.0, b.n.length() - 1.0];
    if !off.iter().all(|off| off.abs() < 4e-16) || (b.u.cross(b.v) - b.n).length() > 1e-15 {
        return Err(format!("not orthonormal: {off:?}"));
    }
    inverse("view", camera.view_from_world(), camera.world_from_view())?;
    inverse("projection", camera.clip_from_view(), camera.view_from_clip())
}

/// The product of a matrix with its inverse, compared with the size of its summands. Numbers beyond all bounds are left
/// out.
fn inverse(what: &str, matrix: DMat4, inverse: DMat4) -> Result<(), String> {
    let (rows, columns) = (matrix.transpose(), inverse);
    for i in 0..4 {
        for j in 0..4 {
            let (row, column) = (rows.col(i), columns.col(j));
            let size = (row * column).abs().element_sum();
            let expected = if i == j { 1.0 } else { 0.0 };
            // As far as rounding of an entry that is less than all numbers can take it.
            let least = f64::MIN_POSITIVE * (row.abs().max_element() + column.abs().max_element()) * 8.0;
            let off = (row.dot(column) - expected).abs();
            if size.is_finite() && off > 1e-15 * size.max(f64::from(u8::from(i == j))) * 4.0 + least {
                return Err(format!(
                    "{what}: entry ({i}, {j}) of the product with its inverse is off by {off:e} of {size:e}"
                ));
            }
        }
    }
    Ok(())
}

/// A scene before the camera, in all three pictures.
fn picture(random: &mut Random, camera: &Camera, tried: &mut Tried) -> Result<(), String> {
    let shapes = [Shape::Box, Shape::Sphere, Shape::Cone, Shape::Torus];
    let (near, far) = (camera.near(), camera.far());
    let objects = (0..3).map(|k| {
        let depth = near + (far - near) * random.unit().powi(4);
        let at = camera.position() + camera.direction_of_projection() * depth;
        let scale = DVec3::splat(depth.min(far - near) * size(random, 2.0));
        let mut object = ObjectSpec::new(format!("object {k}"), shapes[pick(random, 4)].clone());
        (object.translate, object.scale, object.segments) = (at, scale, 8);
        object
    });
    let scene = SceneSpec { preset: Preset::Empty, objects: objects.collect(), ..SceneSpec::default() };
    let style = Style {
        shading: [Shading::Flat, Shading::Phong, Shading::Gouraud, Shading::Wireframe][pick(random, 4)],
        visibility: [Visibility::DepthBuffer, Visibility::Painter, Visibility::Bsp][pick(random, 3)],
        antialias: Samples::One,
        ..Style::default()
    };
    let figure = Figure { camera: *camera.parameters(), scene, style, ..Figure::default() };
    // Scenes have their own limits.
    let Ok(scene) = scene_of(&figure, &mut no_files, &Progress::default()) else { return Ok(()) };
    let scene = SharedScene::new(scene);
    for view in View::ALL {
        let size = Size { width: 64, height: 48, scale: 0.3 };
        let request = Request::of(&figure, view, camera, &scene, pictures::labels(Lang::En), size);
        let drawing = frame(&request, None, &mut TimedPipeline::default()).drawing;
        // Vertices that no triangle has are anywhere: they were clipped away.
        let corners = drawing.surfaces.iter().flat_map(|s| s.triangles.iter().flatten().map(move |&i| (s, i as usize)));
        let faces = corners.flat_map(|(s, i)| s.positions[i].iter().chain(s.inverse_w.get(i)));
        let strokes = drawing.strokes.iter().flat_map(|s| s.points.iter().flatten());
        if !faces.chain(strokes).all(|v| v.is_finite()) {
            return Err(format!("{view:?}: the drawing has a number that is not finite"));
        }
        if Rasterizer::default().paint(&drawing).is_none() {
            return Err(format!("{view:?}: no picture"));
        }
        tried.pictures += 1;
    }
    Ok(())
}
