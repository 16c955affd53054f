//! Points on their way into the image, and pixels on their way back.

use glam::{DVec3, DVec4};

use super::cameras::{
    about, any_projection, image, lens_camera, point_inside, subject, telling, with_image, with_point,
};
use crate::camera::{Camera, ImageSize, Projection, Viewport};
use crate::exercises::worked::inside as steps_inside;
use crate::exercises::{Ask, Exercise, Mistake, Slip, Subject, Table, Unit};
use crate::inspect::quantity::{PointNumber, Quantity, RayNumber, ReportMatrix, WindowNumber};
use crate::numbers::random::Random;

/// An exercise about the point of a subject, with P in its statement.
fn about_point(asks: Vec<Ask>, subject: Subject) -> Exercise {
    let point = subject.points.first().map(|point| ("P", *point));
    Exercise { asks, ..about(subject) }.with_facts(point)
}

fn with_a_point(random: &mut Random, projection: Projection) -> Subject {
    let camera = lens_camera(random, projection);
    let point = point_inside(random, &camera);
    with_point(subject(camera), point)
}

pub(super) fn ndc(random: &mut Random) -> Exercise {
    telling(&[Slip::AxesAsColumns, Slip::RowsExchanged], || {
        let projection = any_projection(random);
        ndc_of(with_a_point(random, projection))
    })
}

fn ndc_of(subject: Subject) -> Exercise {
    let to_clip = subject.value(Quantity::Matrix(ReportMatrix::Projection)).and_then(|matrix| matrix.matrix());
    let asks = [PointNumber::View, PointNumber::Clip, PointNumber::Ndc].map(|space| {
        let ask = Ask::quantity(space.name(), &subject, Quantity::Point(0, space));
        match space {
            PointNumber::Clip => {
                ask.following(&["view"], move |tables| Some(Table::from(to_clip? * tables[0].vector()?.extend(1.0))))
            }
            PointNumber::Ndc => ask.following(&["clip"], divided).following(&["view"], move |tables| {
                divided(&[Table::from(to_clip? * tables[0].vector()?.extend(1.0))])
            }),
            _ => ask,
        }
    });
    about_point(asks.to_vec(), subject)
}

/// Clip coordinates, divided by w.
fn divided(tables: &[Table]) -> Option<Table> {
    let [x, y, z, w] = tables[0].entries[..] else { return None };
    (w != 0.0).then(|| Table::column(&[x / w, y / w, z / w]))
}

/// Distances of a point in clip space inside each plane, in the order of the outcode.
fn beyond_planes(clip: DVec4) -> [f64; 6] {
    [clip.w + clip.x, clip.w - clip.x, clip.w + clip.y, clip.w - clip.y, clip.w + clip.z, clip.w - clip.z]
}

/// The planes by which a point can be outside, in the order of the outcode of `[2]`.
const PLANES: [&str; 7] = ["none", "left", "right", "bottom", "top", "near", "far"];

pub(super) fn inside(random: &mut Random) -> Exercise {
    telling(&[Slip::AxesAsColumns, Slip::UReversedAlone, Slip::VReversed], || inside_of(random))
}

fn inside_of(random: &mut Random) -> Exercise {
    let projection = any_projection(random);
    let parameters = lens_camera(random, projection);
    let wanted = usize::try_from(random.whole(0, 6)).unwrap_or(0);
    let (point, plane) = point_beyond(random, &Camera::new(&parameters).ok(), parameters.focal_point, wanted);
    let subject = with_point(subject(parameters), point);
    let is_inside = Ask {
        quantity: Some(Quantity::Point(0, PointNumber::Inside).into()),
        ..Ask::choice("inside", &["yes", "no"], usize::from(plane != 0), &[], steps_inside(&subject, 0))
    };
    let clip = Ask::quantity("clip", &subject, Quantity::Point(0, PointNumber::Clip));
    let cut = Ask::choice("plane", &PLANES, plane, &opposite(plane), steps_inside(&subject, 0));
    let outside = |tables: &[Table]| {
        let clip: [f64; 4] = tables[0].entries[..].try_into().ok()?;
        Some((1..=6_u8).zip(beyond_planes(clip.into())).filter(|(_, d)| *d < 0.0).map(|(k, _)| k).collect::<Vec<u8>>())
    };
    let is_inside = is_inside
        .following(&["clip"], move |tables| Some(Table::number(if outside(tables)?.is_empty() { 0.0 } else { 1.0 })));
    let cut = cut.following(&["clip"], move |tables| match outside(tables)?[..] {
        [] => Some(Table::number(0.0)),
        [plane] => Some(Table::number(f64::from(plane))),
        _ => None,
    });
    about_point(vec![clip, is_inside, cut], subject)
}

/// The plane on the other side, which comes out if a sign is wrong.
fn opposite(plane: usize) -> Vec<(usize, Mistake)> {
    match plane {
        0 => Vec::new(),
        5 | 6 => vec![(11 - plane, Mistake::ZSign)],
        1 | 2 => vec![(3 - plane, Mistake::Sign)],
        _ => vec![(7 - plane, Mistake::Sign)],
    }
}

/// A point of small numbers outside exactly one plane (0: inside), and the plane: the wanted one, if there is such a
/// point.
fn point_beyond(random: &mut Random, camera: &Option<Camera>, around: DVec3, wanted: usize) -> (DVec3, usize) {
    let Some(camera) = camera else { return (around, 0) };
    let mut spare = (around, 0);
    for _ in 0..4000 {
        let by = DVec3::from_array([0, 1, 2].map(|_| random.whole(-20, 20) as f64));
        let clip = camera.clip_point(around + by);
        if clip.w <= 0.1 && wanted != 5 {
            continue;
        }
        let beyond = beyond_planes(clip);
        // Not so near a plane that rounding decides.
        if beyond.iter().any(|distance| distance.abs() < 0.02 * clip.w.abs().max(1.0)) {
            continue;
        }
        let out: Vec<usize> = (0..6).filter(|plane| beyond[*plane] < 0.0).map(|plane| plane + 1).collect();
        match out[..] {
            [] if wanted == 0 => return (around + by, 0),
            [plane] if plane == wanted => return (around + by, plane),
            [] => spare = (around + by, 0),
            _ => {}
        }
    }
    spare
}

pub(super) fn pixel(random: &mut Random) -> Exercise {
    let projection = any_projection(random);
    let mut slips = vec![
        Slip::AxesAsColumns,
        Slip::PositionNotNegated,
        Slip::RoundedNotFloored,
        Slip::ColumnsAndRows,
        Slip::RowsExchanged,
    ];
    if projection == Projection::Perspective {
        slips.push(Slip::NearForgotten);
    }
    telling(&slips, || {
        let height = random.one_of(&[240, 300, 480, 600]);
        pixel_of(off_borders(random, PointNumber::Window, |random| {
            with_image(with_a_point(random, projection), height)
        }))
    })
}

fn pixel_of(subject: Subject) -> Exercise {
    let asks = vec![
        Ask::quantity("window", &subject, Quantity::Point(0, PointNumber::Window)).in_unit(Unit::Scene),
        Ask::quantity("pixel", &subject, Quantity::Point(0, PointNumber::Pixel)).following(&["window"], {
            let camera = subject.camera().ok();
            let ImageSize { width, height } = subject.figure.image;
            move |tables| {
                let camera = camera.as_ref()?;
                let [x, y] = tables[0].entries[..] else { return None };
                let window = camera.window();
                let i = f64::from(width) * (x - window.left) / window.width();
                let j = f64::from(height) * (window.top - y) / window.height();
                Some(Table::column(&[i.floor(), j.floor()]))
            }
        }),
    ];
    let size = image(subject.figure.image);
    about_point(asks, subject).with_facts(size)
}

/// A subject whose point isn't on the border of two pixels, because there the last digit of a calculator decides.
fn off_borders(random: &mut Random, space: PointNumber, mut make: impl FnMut(&mut Random) -> Subject) -> Subject {
    for _ in 0..200 {
        let subject = make(random);
        let Some(at) = subject.value(Quantity::Point(0, space)) else { continue };
        let ImageSize { width, height } = subject.figure.image;
        let (size, window) = match subject.figure.viewport {
            Some(viewport) => ([viewport.width, viewport.height], [2.0, 2.0]),
            None => {
                let Some(window) = [WindowNumber::Width, WindowNumber::Height]
                    .map(|side| subject.value(Quantity::Window(side)))
                    .into_iter()
                    .map(|side| side.map(|side| side.entries[0]))
                    .collect::<Option<Vec<f64>>>()
                else {
                    continue;
                };
                ([width, height], [window[0], window[1]])
            }
        };
        // Rows of an image are counted from the top.
        let up = if subject.figure.viewport.is_some() { 1.0 } else { -1.0 };
        let share = |k: usize| f64::from(size[k]) * ([1.0, up][k] * at.entries[k] / window[k] + 0.5);
        let is_rounded_up = |k: usize| share(k).round() > share(k);
        // Near the middle of the window a coordinate has few digits left.
        let is_off_middle = (0..2).all(|k| (at.entries[k] / window[k]).abs() > 0.02);
        // In one of them ⌊ ⌋ differs from rounding. If it did in both, rounding would give the same as counting from 1.
        let is_inside = (0..2).all(|k| (share(k) - share(k).round()).abs() > 0.02);
        if is_off_middle && is_inside && is_rounded_up(0) != is_rounded_up(1) {
            return subject;
        }
    }
    make(random)
}

pub(super) fn ray(random: &mut Random) -> Exercise {
    telling(&[Slip::ColumnsAndRows], || ray_of(random))
}

fn ray_of(random: &mut Random) -> Exercise {
    let projection = any_projection(random);
    // Few pixels, so that half a pixel counts.
    let mut subject = with_image(subject(lens_camera(random, projection)), random.one_of(&[12, 24, 48]));
    let size = subject.figure.image;
    let [i, j] = [size.width, size.height].map(|side| {
        loop {
            let k = random.whole(0, i64::from(side) - 1);
            // Not in the middle, because there rows from above and from below are the same.
            if (2 * k + 1 - i64::from(side)).abs() > 2 {
                break k;
            }
        }
    });
    subject.pixels.push([i, j]);
    let asks = [RayNumber::Origin, RayNumber::Direction]
        .map(|number| Ask::quantity(number.name(), &subject, Quantity::Ray(0, number)));
    let pixel = [("i", i as f64), ("j", j as f64)];
    Exercise { asks: asks.to_vec(), ..about(subject) }.with_facts(pixel).with_facts(image(size))
}

pub(super) fn viewport(random: &mut Random) -> Exercise {
    telling(&[Slip::AxesAsColumns, Slip::RoundedNotFloored], || viewport_of(random))
}

fn viewport_of(random: &mut Random) -> Exercise {
    let projection = any_projection(random);
    let (width, height) = random.one_of(&[(400, 300), (640, 480), (300, 200), (512, 384)]);
    // No corner and no range that would hide their omission.
    let (x, y) = random.one_of(&[(10, 30), (100, 50), (20, 40), (64, 32)]);
    let (depth_near, depth_far) = random.one_of(&[(0.5, 1.0), (0.0, 0.5), (0.25, 1.0), (1.0, 0.0)]);
    let viewport = Viewport { x, y, width, height, depth_near, depth_far };
    let subject = off_borders(random, PointNumber::Ndc, |random| {
        let mut subject = with_a_point(random, projection);
        subject.figure.viewport = Some(viewport);
        subject
    });
    let placed = move |tables: &[Table]| {
        let [x_n, y_n, z_n] = tables[0].entries[..] else { return None };
        let along = |start: i32, size: u32, n: f64| (f64::from(size) / 2.0 * (n + 1.0)).floor() + f64::from(start);
        let z = (depth_far - depth_near) / 2.0 * z_n + f64::midpoint(depth_far, depth_near);
        Some(Table::column(&[along(x, width, x_n), along(y, height, y_n), z]))
    };
    let asks = vec![
        Ask::quantity("ndc", &subject, Quantity::Point(0, PointNumber::Ndc)),
        Ask::quantity("viewport", &subject, Quantity::Point(0, PointNumber::Viewport)).following(&["ndc"], placed),
    ];
    let numbers = [
        ("Xv", f64::from(x)),
        ("Yv", f64::from(y)),
        ("Wv", f64::from(width)),
        ("Hv", f64::from(height)),
        ("dn", depth_near),
        ("df", depth_far),
    ];
    about_point(asks, subject).with_facts(numbers)
}
