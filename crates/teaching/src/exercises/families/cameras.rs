//! Cameras whose numbers can be computed with pencil and paper.

use glam::DVec3;

use crate::camera::{Camera, ImageSize, Parameters, Projection};
pub(super) use crate::exercises::statement_facts::{about, image, with_point};
use crate::exercises::{Exercise, Slip, Subject};
use crate::figure::Figure;
use crate::numbers::random::Random;
use crate::scene::palette::{BLUE, ORANGE, TEAL};
use crate::scene::{ObjectSpec, Preset, Shape};

/// The numbers of a family for a seed.
pub(in crate::exercises) fn numbers(family: &str, seed: u64) -> Random {
    // FNV-1a gives every family its own numbers for the same seed.
    let stream = family
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    let mut random = Random::new(seed, stream);
    // The first numbers of neighbouring seeds differ in only a few bits.
    random.bits();
    random
}

/// From PF to C: short vectors, none of them along an axis.
const TO_VIEWER: [[f64; 3]; 16] = [
    [3.0, 4.0, 0.0],
    [4.0, 0.0, 3.0],
    [0.0, 3.0, 4.0],
    [2.0, 1.0, 2.0],
    [1.0, 2.0, 2.0],
    [2.0, 3.0, 6.0],
    [6.0, 2.0, 3.0],
    [4.0, 4.0, 7.0],
    [3.0, 2.0, -6.0],
    [-2.0, 2.0, 1.0],
    [1.0, 1.0, 1.0],
    [2.0, 1.0, 1.0],
    [-1.0, 2.0, 3.0],
    [3.0, 1.0, 2.0],
    [4.0, 3.0, 12.0],
    [-3.0, 4.0, 12.0],
];

/// View-up vectors that neither have length 1 nor happen to be perpendicular to the line of sight, because that would
/// hide a forgotten step.
const UPS: [[f64; 3]; 5] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 2.0, 0.0], [0.0, 2.0, 1.0], [1.0, 2.0, 0.0]];

/// Ratios of width to height. With a 2, leaving out A would look like a lost factor of 2.
const ASPECTS: [f64; 5] = [4.0 / 3.0, 3.0 / 2.0, 5.0 / 4.0, 7.0 / 4.0, 3.0 / 4.0];

fn whole(random: &mut Random, low: i64, high: i64) -> f64 {
    random.whole(low, high) as f64
}

/// A whole number between −`most` and `most`.
pub(super) fn small(random: &mut Random, most: i64) -> f64 {
    whole(random, -most, most)
}

/// The first exercise in which each of these slips changes an answer, because other numbers would hide that it was
/// made. If there is none, the last one tried.
pub(super) fn telling(slips: &[Slip], mut make: impl FnMut() -> Exercise) -> Exercise {
    const TRIES: usize = 200;
    let tells = |exercise: &Exercise| slips.iter().all(|slip| exercise.asks.iter().any(|ask| ask.tells(*slip)));
    let mut exercise = make();
    for _ in 1..TRIES {
        if tells(&exercise) {
            break;
        }
        exercise = make();
    }
    exercise
}

/// An exercise without a camera of its own.
pub(super) fn plain() -> Exercise {
    Exercise { facts: Vec::new(), ..about(Subject { figure: Figure::of_preset(Preset::House), ..Subject::default() }) }
}

/// A valid camera: C, PF and VUP of whole numbers, oblique to one another.
pub(super) fn camera(random: &mut Random, projection: Projection) -> Parameters {
    loop {
        let focal_point = DVec3::new(whole(random, -2, 2), whole(random, -2, 2), whole(random, -2, 2));
        let to_viewer = DVec3::from_array(random.one_of(&TO_VIEWER));
        let view_up = DVec3::from_array(random.one_of(&UPS));
        let near = random.one_of(&[1.0, 2.0, 0.5]);
        let parameters = Parameters {
            position: focal_point + to_viewer,
            focal_point,
            view_up,
            projection,
            view_angle: random.one_of(&[60.0, 90.0, 50.0, 40.0]),
            height: random.one_of(&[4.0, 6.0, 8.0, 5.0]),
            aspect: random.one_of(&ASPECTS),
            near,
            far: near * random.one_of(&[10.0, 20.0, 25.0]),
            window: None,
        };
        // If VUP were along v, it could be taken for v unnoticed. A product of length 1 would hide a missing division
        // by its length. C at the origin would hide every translation.
        let n = to_viewer.normalize();
        let oblique = view_up.normalize().dot(n).abs();
        let has_length_1 = (view_up.cross(n).length() - 1.0).abs() < 0.05;
        if (0.1..0.95).contains(&oblique) && !has_length_1 && parameters.position.length() > 1.0 {
            return seeing(parameters, to_viewer.length());
        }
    }
}

/// Distances F that can't be mistaken for another known factor in a product or quotient. 1 would hide a forgotten F,
/// and 2 and 1/2 would make it look like a lost factor of 2.
const NEARS: [f64; 6] = [0.8, 0.4, 1.5, 2.5, 3.0, 5.0];

/// A camera like those of [`camera`], in perspective with an F from [`NEARS`].
pub(super) fn lens_camera(random: &mut Random, projection: Projection) -> Parameters {
    let parameters = camera(random, projection);
    if projection == Projection::Parallel {
        return parameters;
    }
    let distance = (parameters.position - parameters.focal_point).length();
    let near = loop {
        let near = random.one_of(&NEARS);
        if near < 0.7 * distance {
            break near;
        }
    };
    seeing(Parameters { near, far: near * random.one_of(&[10.0, 20.0, 25.0]), ..parameters }, distance)
}

/// A camera with PF at a distance, inside its volume.
fn seeing(parameters: Parameters, distance: f64) -> Parameters {
    let near = if parameters.near < 0.7 * distance { parameters.near } else { 0.5 };
    let far = if parameters.far > 1.3 * distance { parameters.far } else { 40.0 * near };
    Parameters { near, far: far.max(10.0 * near), ..parameters }
}

/// One of the two projections.
pub(super) fn any_projection(random: &mut Random) -> Projection {
    random.one_of(&[Projection::Perspective, Projection::Parallel])
}

/// A camera in front of small things about PF. The camera is never among them.
pub(super) fn subject(camera: Parameters) -> Subject {
    let mut figure = Figure::of_preset(Preset::Empty);
    let (at, unit) = (camera.focal_point, (camera.position - camera.focal_point).length() / 16.0);
    let thing = |name: &str, shape, by: [f64; 3]| {
        let at = at + DVec3::from_array(by) * unit;
        ObjectSpec::new(name, shape).at(at.x, at.y, at.z).scaled(unit, unit, unit)
    };
    figure.scene.objects = vec![
        thing("cube", Shape::Box, [-2.0, 0.0, 0.0]).colored(BLUE),
        thing("sphere", Shape::Sphere, [2.0, 0.0, 1.0]).colored(ORANGE),
        thing("cone", Shape::Cone, [0.0, 1.0, -2.5]).colored(TEAL),
    ];
    figure.camera = camera;
    with_image(Subject { figure, ..Subject::default() }, 768)
}

/// Gives it an image whose sides have the aspect of the window, as far as whole pixels can.
pub(super) fn with_image(mut subject: Subject, height: u32) -> Subject {
    let aspect = subject.figure.camera.window.map_or(subject.figure.camera.aspect, |window| window.aspect());
    #[expect(clippy::cast_possible_truncation, reason = "a few hundred pixels")]
    let width = (f64::from(height) * aspect).round().max(1.0) as u32;
    subject.figure.image = ImageSize { width, height };
    subject
}

/// A point of small whole numbers inside the volume of the camera and off its axis; PF moved a little if there is none.
pub(super) fn point_inside(random: &mut Random, parameters: &Parameters) -> DVec3 {
    let Ok(camera) = Camera::new(parameters) else { return parameters.focal_point };
    for _ in 0..400 {
        let by = DVec3::new(whole(random, -4, 4), whole(random, -4, 4), whole(random, -4, 4)) / 2.0;
        let point = parameters.focal_point + by;
        let clip = camera.clip_point(point);
        let inside = clip.truncate().abs().cmple(DVec3::splat(0.9 * clip.w)).all();
        if inside && clip.x.abs() > 0.05 * clip.w && clip.y.abs() > 0.05 * clip.w {
            return point;
        }
    }
    parameters.focal_point + camera.basis().u * (0.1 * camera.near()) + camera.basis().v * (0.05 * camera.near())
}
