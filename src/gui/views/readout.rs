//! The coordinates of the target of the pointer, in every space.

use glam::{DVec2, DVec3};

use crate::gui::views::pointer::handle_drag::point;
use crate::gui::views::pointer::keyboard_probe::pixel_of;
use crate::gui::views::pointer::picking::Depths;
use crate::gui::views::pointer::vertex_name::VertexName;
use crate::inspect::Asked;
use crate::inspect::quantity::{PointNumber, Quantity, RayNumber};
use crate::numbers::{DecimalMark, significant};
use crate::pipeline::clip_parts;
use crate::views::depth::DepthReading;
use crate::views::{Probe, Request};
use camera_lab_words::window;
use camera_lab_words::window::canvas::CanvasTexts;
use camera_lab_words::window::scenes::preset_object;

/// A space and the coordinates in it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cell {
    pub(super) space: &'static str,
    pub(super) value: String,
    /// Shown even if there isn't room for all.
    pub(super) wanted: bool,
    /// The quantity that it prints.
    quantity: Option<Quantity>,
    /// Its numbers, if they belong to a point of the scene. The pointer itself passes over any number.
    numbers: Vec<f64>,
}

fn wanted(space: &'static str, value: String) -> Cell {
    Cell { space, value, wanted: true, quantity: None, numbers: Vec::new() }
}

impl Cell {
    fn of_point(self, number: PointNumber, numbers: &[f64]) -> Self {
        Self { quantity: Some(Quantity::Point(0, number)), numbers: numbers.to_vec(), ..self }
    }

    fn of_ray(self, number: RayNumber) -> Self {
        Self { quantity: Some(Quantity::Ray(0, number)), ..self }
    }

    /// The cell, without its value while a question asks for it.
    pub(super) fn unless_asked(self, asked: &Asked, texts: &CanvasTexts) -> Self {
        let is_asked = self.quantity.is_some_and(|quantity| asked.hides(&[quantity], &self.numbers));
        if is_asked { Self { value: window::texts(texts.lang).asked_here.to_owned(), ..self } } else { self }
    }
}

/// The coordinates of a probe in every space, in the order of the pipeline.
pub(super) fn cells(
    probe: Probe,
    depths: Option<Depths>,
    request: &Request,
    (digits, mark): (usize, DecimalMark),
    texts: &CanvasTexts,
) -> Vec<Cell> {
    let (look, camera) = (&request.shot.look, &request.camera);
    let other = |space, value| Cell { wanted: false, ..wanted(space, value) };
    use PointNumber::{Clip, Inside, Ndc, Pixel, View, Viewport, Window, World};
    match probe {
        Probe::Point(p) => {
            let s = camera.possible_clip_space(request.shot.ndc).stations(p, look.image, &look.viewport);
            let mut cells = vec![
                wanted(texts.space_world, point(p, digits, mark)).of_point(World, &p.to_array()),
                other(texts.space_view, point(s.view, digits, mark)).of_point(View, &s.view.to_array()),
                other(texts.space_clip, mark.tuple(&s.clip.to_array(), digits)).of_point(Clip, &s.clip.to_array()),
            ];
            if look.reveal.clipping {
                cells.extend(clipping_cells(p, request, (digits, mark), texts).map(|cell| cell.of_point(Inside, &[])));
            }
            let Some(crate::camera::Projected { ndc, window, pixel, viewport }) = s.projected else {
                cells.push(wanted(texts.space_ndc, texts.no_image.to_owned()));
                return cells;
            };
            let outside = if s.inside { String::new() } else { format!(" {}", texts.outside) };
            cells.push(
                wanted(texts.space_ndc, format!("{}{outside}", point(ndc, digits, mark)))
                    .of_point(Ndc, &ndc.to_array()),
            );
            cells.push(other(texts.space_window, pair(window, digits, mark)).of_point(Window, &window.to_array()));
            cells.push(wanted(texts.space_pixel, pair(pixel, digits.max(6), mark)).of_point(Pixel, &pixel.to_array()));
            let [x, y] = [viewport.x, viewport.y].map(|v| significant(v, digits.max(6)));
            let (x, y, z) = (mark.printed(&x), mark.printed(&y), mark.number(viewport.z, digits));
            let viewport_numbers = [viewport.x, viewport.y, viewport.z];
            let viewport = other(texts.space_viewport, format!("({})", [x, y, z].join(mark.separator())));
            cells.push(viewport.of_point(Viewport, &viewport_numbers));
            cells
        }
        Probe::Window(w) => {
            let ray = camera.ray_through_window(w);
            let mut cells = vec![
                wanted(texts.space_pixel, pair(pixel_of(look.image, camera, w), 17, mark)).of_ray(RayNumber::Pixel),
                other(texts.space_window, pair(w, digits, mark)).of_ray(RayNumber::Pixel),
            ];
            cells.extend(depth_cells(depths, (digits, mark), texts));
            let ray_cell = |space, p| Cell { wanted: depths.is_none(), ..other(space, point(p, digits, mark)) };
            cells.push(ray_cell(texts.ray_origin, ray.origin).of_ray(RayNumber::Origin));
            cells.push(ray_cell(texts.ray_direction, ray.direction).of_ray(RayNumber::Direction));
            cells
        }
    }
}

/// The outcode of a point, with the planes that its bits name, and its homogeneous distances from them.
fn clipping_cells(p: DVec3, request: &Request, (digits, mark): (usize, DecimalMark), texts: &CanvasTexts) -> [Cell; 4] {
    let ndc = request.camera.possible_clip_space(request.shot.ndc).ndc();
    let mut code = clip_parts::outcode_of(&request.camera, p).unwrap_or([true; 6]);
    // Without a far plane, no point is beyond it.
    code[5] &= !ndc.infinite;
    let bits: String = code.iter().map(|outside| if *outside { '1' } else { '0' }).collect();
    let planes: Vec<&str> =
        request.labels.planes.into_iter().zip(code).filter(|(_, out)| *out).map(|(n, _)| n).collect();
    let meaning = if planes.is_empty() { texts.inside.to_owned() } else { planes.join(", ") };
    let [left, right, bottom, top, near, far] = clip_parts::homogeneous_distances(&request.camera, p, ndc);
    let pair = |ends: [f64; 2]| mark.list(&ends, digits);
    let y = if ndc.y_points_down() { "w − y, w + y" } else { "w + y, w − y" };
    let z = match ndc.depths() {
        [-1.0, _] => "w + z, w − z",
        [0.0, _] => "z, w − z",
        _ => "w − z, z",
    };
    [
        wanted(texts.outcode, format!("{bits} {meaning}")),
        wanted("w + x, w − x", pair([left, right])),
        wanted(y, pair([bottom, top])),
        wanted(z, pair([near, far])),
    ]
}

fn depth_cells(depths: Option<Depths>, (digits, mark): (usize, DecimalMark), texts: &CanvasTexts) -> Vec<Cell> {
    // Depths differ late. Near the back of the volume the first four digits are all alike.
    let digits = digits.max(6);
    match depths {
        None => Vec::new(),
        Some(None) => vec![wanted(texts.depth, texts.nothing_here.to_owned())],
        Some(Some(DepthReading { z, ndc_z, distance })) => vec![
            wanted(texts.depth, format!("Z = {}", mark.number(z, digits))).of_point(PointNumber::Viewport, &[]),
            wanted(texts.space_ndc, format!("z_n = {}", mark.number(ndc_z, digits))).of_point(PointNumber::Ndc, &[]),
            wanted(texts.distance, format!("−z_c = {}", mark.number(distance, digits)))
                .of_point(PointNumber::View, &[]),
        ],
    }
}

/// The vertex of a probe: its number, from 1, and its object.
pub(super) fn vertex_cell(name: &VertexName, texts: &CanvasTexts) -> Cell {
    let VertexName { object, of_preset, number } = name;
    let object = if *of_preset { preset_object(texts.lang, object) } else { crate::sanitize::escaped(object) };
    wanted(texts.vertex, format!("{number} – {object}"))
}

/// Two coordinates.
pub(super) fn pair(p: DVec2, digits: usize, mark: DecimalMark) -> String {
    mark.tuple(&p.to_array(), digits)
}
