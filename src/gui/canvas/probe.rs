//! What the pointer points at, and its coordinates in every space.

use glam::{DVec2, DVec3};

use crate::camera::{Camera, ImageSize, Projected, Viewport};
use crate::figure::{Depth, Observer};
use crate::gui::handles::point;
use crate::i18n::canvas::CanvasTexts;
use crate::numbers::significant;
use crate::pipeline::clip_parts;
use crate::views::View;
use crate::views::depth::{self, DepthReading};
use crate::views::{Probe, Setup, pick};

/// How near the pointer must come to a vertex, in points.
pub(super) const REACH: f32 = 7.0;

/// What is at `pointer` (pixels) in a picture: a vertex within `reach` pixels, or a pixel of the image.
pub(super) fn at(picture: View, setup: &Setup, observer: &Observer, pointer: DVec2, reach: f64) -> Option<Probe> {
    match picture {
        View::World => pick::vertex_in_world(setup, observer, pointer, reach).map(Probe::Point),
        View::Canonical => pick::vertex_in_canonical(setup, observer, pointer, reach).map(Probe::Point),
        // What a pixel of the depth buffer holds is the depth of a face, not of a vertex behind or beside it.
        View::Image => vertex_unless_depths(setup, pointer, reach).map(Probe::Point).or_else(|| {
            let point = pick::window_point_in_image(setup, pointer)?;
            let pixel = pixel_of(setup.figure.image, setup.camera, point);
            Some(Probe::Window(center_of(setup.figure.image, setup.camera, pixel)))
        }),
    }
}

fn vertex_unless_depths(setup: &Setup, pointer: DVec2, reach: f64) -> Option<DVec3> {
    (setup.figure.reveal.depth == Depth::Off).then(|| pick::vertex_in_image(setup, pointer, reach))?
}

/// The pixel (i, j) of the figure's image at a point of the view window, `[0]` Eq. (5.22); on the right and the lower border
/// the last one.
pub(super) fn pixel_of(image: ImageSize, camera: &Camera, point: DVec2) -> DVec2 {
    let last = DVec2::new(f64::from(image.width), f64::from(image.height)) - 1.0;
    image.image_from_window(&camera.window(), point).floor().clamp(DVec2::ZERO, last.max(DVec2::ZERO))
}

/// The point of the view window at the centre of a pixel, `[0]` Eq. (5.23).
fn center_of(image: ImageSize, camera: &Camera, pixel: DVec2) -> DVec2 {
    image.window_from_image(&camera.window(), pixel + 0.5)
}

/// A space and the coordinates in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Cell {
    pub(super) space: &'static str,
    pub(super) value: String,
    /// How much room the coordinates take: 1, or 2 for four numbers.
    pub(super) slots: u8,
    /// Shown also where there is no room for all.
    pub(super) wanted: bool,
}

/// The coordinates of a probe in every space, in the order of the pipeline.
pub(super) fn cells(
    probe: Probe,
    depths: Option<Depths>,
    setup: &Setup,
    digits: usize,
    texts: &CanvasTexts,
) -> Vec<Cell> {
    let (figure, camera) = (setup.figure, setup.camera);
    let wanted = |space, value| Cell { space, value, slots: 1, wanted: true };
    let other = |space, value| Cell { space, value, slots: 1, wanted: false };
    match probe {
        Probe::Point(p) => {
            let viewport = figure.viewport.unwrap_or_else(|| Viewport::whole(figure.image));
            let s = camera.stations(p, figure.image, &viewport);
            let [x, y, z, w] = s.clip.to_array().map(|v| significant(v, digits));
            let mut cells = vec![
                wanted(texts.space_world, point(p, digits)),
                other(texts.space_view, point(s.view, digits)),
                Cell { slots: 2, ..other(texts.space_clip, format!("({x}, {y}, {z}, {w})")) },
            ];
            if figure.reveal.clipping {
                cells.extend(clipping_cells(p, setup, digits, texts));
            }
            let Some(Projected { ndc, window, pixel, viewport }) = s.projected else {
                cells.push(wanted(texts.space_ndc, texts.no_image.to_owned()));
                return cells;
            };
            let outside = if s.inside { String::new() } else { format!(" {}", texts.outside) };
            cells.push(wanted(texts.space_ndc, format!("{}{outside}", point(ndc, digits))));
            cells.push(other(texts.space_window, pair(window, digits)));
            cells.push(wanted(texts.space_pixel, pair(pixel, digits.max(6))));
            let [x, y] = [viewport.x, viewport.y].map(|v| significant(v, digits.max(6)));
            cells.push(other(texts.space_viewport, format!("({x}, {y}, {})", significant(viewport.z, digits))));
            cells
        }
        Probe::Window(w) => {
            let ray = camera.ray_through_window(w);
            let mut cells = vec![
                wanted(texts.space_pixel, pair(pixel_of(figure.image, camera, w), 17)),
                other(texts.space_window, pair(w, digits)),
            ];
            cells.extend(depth_cells(depths, digits, texts));
            let ray_cell = |space, p| Cell { wanted: depths.is_none(), ..other(space, point(p, digits)) };
            cells.push(ray_cell(texts.ray_origin, ray.origin));
            cells.push(ray_cell(texts.ray_direction, ray.direction));
            cells
        }
    }
}

/// The outcode of a point, with the planes that its bits name, and its homogeneous distances from them.
fn clipping_cells(p: DVec3, setup: &Setup, digits: usize, texts: &CanvasTexts) -> [Cell; 4] {
    let cell = |space, value| Cell { space, value, slots: 1, wanted: true };
    let code = clip_parts::outcode_of(setup.camera, p).unwrap_or([true; 6]);
    let bits: String = code.iter().map(|outside| if *outside { '1' } else { '0' }).collect();
    let planes: Vec<&str> = setup.labels.planes.into_iter().zip(code).filter(|(_, out)| *out).map(|(n, _)| n).collect();
    let meaning = if planes.is_empty() { texts.inside.to_owned() } else { planes.join(", ") };
    let d = clip_parts::homogeneous_distances(setup.camera, p).map(|d| significant(d, digits));
    [
        cell(texts.outcode, format!("{bits} {meaning}")),
        cell("w + x, w − x", format!("{}, {}", d[0], d[1])),
        cell("w + y, w − y", format!("{}, {}", d[2], d[3])),
        cell("w + z, w − z", format!("{}, {}", d[4], d[5])),
    ]
}

/// What the depth buffer holds at a pixel, if anything.
pub(super) type Depths = Option<DepthReading>;

/// What the depth buffer holds under the probe; `None` where the image does not show depths.
pub(super) fn depths(probe: Probe, setup: &Setup) -> Option<Depths> {
    match probe {
        Probe::Window(w) if setup.figure.reveal.depth != Depth::Off => Some(depth::reading(setup, w)),
        _ => None,
    }
}

fn depth_cells(depths: Option<Depths>, digits: usize, texts: &CanvasTexts) -> Vec<Cell> {
    // Depths differ late: near the back of the volume the first four digits are all alike.
    let digits = digits.max(6);
    let cell = |space, value| Cell { space, value, slots: 1, wanted: true };
    match depths {
        None => Vec::new(),
        Some(None) => vec![cell(texts.depth, texts.nothing_here.to_owned())],
        Some(Some(DepthReading { z, ndc_z, distance })) => vec![
            cell(texts.depth, format!("Z = {}", significant(z, digits))),
            cell(texts.space_ndc, format!("z_n = {}", significant(ndc_z, digits))),
            cell(texts.distance, format!("−z_c = {}", significant(distance, digits))),
        ],
    }
}

/// Two coordinates.
pub(super) fn pair(p: DVec2, digits: usize) -> String {
    format!("({}, {})", significant(p.x, digits), significant(p.y, digits))
}
