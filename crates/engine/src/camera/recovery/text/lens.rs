//! The lens that the entries of a camera say, and the camera of some entries. Each entry ends in a list: used, or left
//! out with a reason.

use glam::DVec3;

use super::camera::{Entry, Said, Side, Sign, matrix_of, word};
use super::names::{Field as F, plain};
use super::{GivenLens, LeftOut, MatrixTextError, Pasted, Size, Used, Why, image_size};
use crate::camera::recovery::reading::Written;
use crate::camera::recovery::{MatrixEntries, MatrixKind};
use crate::camera::{Axes, Order};

/// Of an image: the left upper corner of its part, the size of the part, and how many pixels become one.
pub(crate) struct Part {
    corner: [f64; 2],
    size: [f64; 2],
    binning: [f64; 2],
}

impl Said<'_> {
    /// The lens.
    ///
    /// # Errors
    /// [`MatrixTextError::Range`] for a number that no lens has.
    pub(crate) fn lens(&mut self, image: &mut Option<[f64; 2]>) -> Result<Option<GivenLens>, MatrixTextError> {
        let units = self.sign.units;
        let [near, far] = [F::Near, F::Far].map(|plane| self.number(plane).map(|x| x * units));
        let mut lens = GivenLens { near, far, aspect: self.number(F::Aspect), ..GivenLens::default() };
        if let (Some([x, y]), Some([m, n])) = (self.pair(F::PixelAspectX, F::PixelAspectY), *image) {
            lens.aspect = Some(m * x / (n * y));
        }
        let words = self.words();
        let parallel = self.is_on(F::Parallel).or_else(|| self.is_on(F::Perspective).map(|on| !on));
        let is_said = (words.contains("ortho") || words.contains("parallel")).then_some(true);
        let parallel =
            parallel.or_else(|| self.is_on(F::Orthogonal)).or(is_said).or(self.sign.is_parallel.then_some(true));
        lens.zoom = if self.has(F::BoundsMin) { 1.0 } else { self.number(F::Zoom).unwrap_or(1.0) };
        lens.shift = [self.number(F::ShiftX), self.number(F::ShiftY)].map(|shift| shift.unwrap_or(0.0));
        lens.shift_of_height = lens.shift != [0.0; 2];
        if let Some(center) = self.pair(F::CenterX, F::CenterY) {
            lens.shift = center.map(|x| x / 2.0);
        }
        let length = |said: &mut Self, field| said.vector(field).map(DVec3::length);
        let own = if self.sign.is_pov() {
            [F::Across, F::Up, F::Forward].map(|field| length(self, field))
        } else {
            [None; 3]
        };
        let [right, up, ahead] = own;
        if right.is_some() {
            lens.aspect = right.map(|right| right / up.unwrap_or(1.0));
        }
        lens.size = self.size(&mut lens, parallel, image)?;
        if lens.size == Size::Open && (right.is_some() || ahead.is_some()) {
            lens.is_slope = parallel != Some(true);
            let ahead = ahead.filter(|_| lens.is_slope).unwrap_or(1.0);
            lens.size = Size::Length(Side::Across, right.unwrap_or(4.0 / 3.0) / ahead);
        }
        if let (Some(offset), Some(gauge), Some(angle)) =
            (self.number(F::FilmOffset), self.number(F::FilmGauge), lens.degrees)
            && offset != 0.0
        {
            let width = gauge * lens.aspect.unwrap_or(1.0).min(1.0);
            lens.shift = [offset / width / (2.0 * (angle.to_radians() / 2.0).tan() / lens.zoom), 0.0];
            lens.shift_of_height = true;
        }
        if let Some(part) = self.part(image) {
            let Part { corner, size, binning: by } = part;
            match &mut lens.size {
                Size::Pixels { focal_lengths: f, principal_point, skew } => {
                    (*f, *skew) = ([f[0] / by[0], f[1] / by[1]], *skew / by[0]);
                    *principal_point = principal_point.map(|c| [0, 1].map(|i| (c[i] - corner[i]) / by[i]));
                }
                _ => {
                    let whole = self.pair(F::FullWidth, F::FullHeight).or(*image);
                    lens.crop = whole.map(|[m, n]| [corner[0] / m, corner[1] / n, size[0] / m, size[1] / n]);
                }
            }
            *image = image.map(|_| [size[0] / by[0], size[1] / by[1]]);
        }
        let is_empty = lens.size == Size::Open
            && parallel != Some(true)
            && lens.near.is_none()
            && lens.far.is_none()
            && lens.aspect.is_none();
        Ok((!is_empty).then_some(lens))
    }

    fn size(
        &mut self,
        lens: &mut GivenLens,
        parallel: Option<bool>,
        image: &Option<[f64; 2]>,
    ) -> Result<Size, MatrixTextError> {
        let units = self.sign.units;
        lens.is_parallel = parallel.unwrap_or(false);
        let has_sensor = self.has(F::SensorWidth) || self.has(F::SensorHeight);
        let focal = if self.has(F::FocalMm) { F::FocalMm } else { F::Focal };
        let has_focal = self.has(focal) && parallel != Some(true) && (has_sensor || focal == F::FocalMm);
        let of_four = |k: Vec<f64>| [&k[..3], &k[4..7], &k[8..11]].concat();
        if let Some(k) = self.list(F::K).or_else(|| self.list(F::K4).map(of_four)) {
            // MATLAB and Open3D write it by columns.
            let by_columns = k[2] == 0.0 && k[5] == 0.0 && (k[6] != 0.0 || k[7] != 0.0);
            let k = if by_columns { matrix_of(&k, 3).transpose() } else { matrix_of(&k, 3) };
            let principal_point = Some([k.z_axis.x, k.z_axis.y]);
            return Ok(Size::Pixels { focal_lengths: [k.x_axis.x, k.y_axis.y], principal_point, skew: k.y_axis.x });
        }
        let of_pixels = if let Some(f_x) = self.number(F::Fx) {
            Some((F::Fx, [f_x, self.number(F::Fy).unwrap_or(f_x)]))
        } else if self.has(F::Focal) && !has_sensor && (image.is_some() || self.has(F::Cx)) {
            self.number(F::Focal).map(|f| (F::Focal, [f; 2]))
        } else if has_focal && let Some([x, y]) = self.pair(F::PixelWidth, F::PixelHeight) {
            self.number(focal).map(|f| (focal, [f / x, f / y]))
        } else {
            None
        };
        if let Some((field, focal_lengths)) = of_pixels {
            let least = focal_lengths[0].min(focal_lengths[1]);
            if !(focal_lengths[0] > 0.0 && focal_lengths[1] > 0.0) {
                return Err(MatrixTextError::Range { name: self.name(field), value: least, allowed: "> 0" });
            }
            let middle = image.map(|image| image.map(|side| side / 2.0));
            let is_of_middle = self.name(F::Cx).starts_with("Metashape");
            let principal_point = match (self.pair(F::Cx, F::Cy), middle) {
                (Some([x, y]), Some([m, n])) if is_of_middle => Some([m + x, n + y]),
                (point, middle) => point.or(middle),
            };
            return Ok(Size::Pixels { focal_lengths, principal_point, skew: 0.0 });
        }
        let mut size = Size::Open;
        if has_focal {
            let f = self.number(focal).unwrap_or(50.0);
            let (width, height) = (self.number(F::SensorWidth), self.number(F::SensorHeight));
            let middle = |side: Option<f64>, x: Option<f64>| side.zip(x).map_or(0.0, |(side, x)| x / side);
            if self.has(F::SensorX) || self.has(F::SensorY) {
                lens.shift = [middle(width, self.number(F::SensorX)), middle(height, self.number(F::SensorY))];
            }
            lens.aspect = lens.aspect.or(width.zip(height).map(|(width, height)| width / height));
            size = match (width, height) {
                (_, Some(height)) => Size::Length(Side::Up, height / f),
                (Some(width), None) => Size::Length(Side::Across, width / f),
                // Blender's sensor is 36 mm along the larger side.
                (None, None) => Size::Length(Side::Larger, 36.0 / f),
            };
        }
        let across = self.entries.iter().find(|entry| entry.fields.contains(&F::FovAxis));
        let side = match across.map(|entry| entry.text.as_str()) {
            Some("x") => Side::Across,
            Some("y") => Side::Up,
            Some("smaller") => Side::Smaller,
            _ => self.sign.side,
        };
        for (field, side) in [(F::AngleY, Side::Up), (F::AngleX, Side::Across), (F::Fov, side)] {
            if size == Size::Open
                && let Some(angle) = self.number(field)
            {
                let name = plain(&self.name(field));
                let in_degrees = ["viewangle", "fieldofview", "degrees"].iter().any(|word| name.contains(word));
                let by_name = if in_degrees { Some(false) } else { name.contains("cameraangle").then_some(true) };
                let is_radians = self.sign.is_radians.or(by_name);
                let is_radians = is_radians.unwrap_or(angle.abs() <= std::f64::consts::PI);
                let degrees = if is_radians { angle.to_degrees() } else { angle };
                if !(degrees > 0.0 && degrees < 180.0) {
                    let allowed = if is_radians { "0 … π" } else { "0° … 180°" };
                    return Err(MatrixTextError::Range { name: self.name(field), value: angle, allowed });
                }
                lens.degrees = (side == Side::Up).then_some(degrees);
                size = Size::Length(side, 2.0 * (degrees.to_radians() / 2.0).tan());
            }
        }
        lens.is_slope = size != Size::Open;
        if lens.is_slope && parallel != Some(true) {
            return Ok(size);
        }
        lens.degrees = None;
        let sides = [F::Left, F::Right, F::Bottom, F::Top].map(|field| self.number(field));
        if let [Some(left), Some(right), Some(bottom), Some(top)] = sides {
            return Ok(Size::Sides([left, right, bottom, top]));
        }
        if let (Some(height), Some([x, y])) = (self.number(F::WindowHeight), self.pair(F::OffsetX, F::OffsetY)) {
            (lens.shift, lens.shift_of_height, lens.is_slope) = ([x / height, y / height], true, true);
            return Ok(Size::Length(Side::Up, height / lens.near.unwrap_or(1.0)));
        }
        let height = self.number(F::Height).or(self.number(F::HalfHeight).map(|half| 2.0 * half));
        let height = height.or_else(|| self.number(F::Extent).filter(|_| parallel == Some(true)));
        let width = self.number(F::Width).or(self.number(F::HalfWidth).map(|half| 2.0 * half));
        lens.aspect = lens.aspect.or(width.zip(height).map(|(width, height)| width / height));
        let Some((side, length)) = height.map(|h| (Side::Up, h)).or(width.map(|w| (Side::Across, w))) else {
            return Ok(size);
        };
        (lens.is_slope, lens.is_parallel) = (false, parallel.unwrap_or(true));
        Ok(Size::Length(side, length * units))
    }

    /// The part of a larger image that it is, if it's one.
    pub(crate) fn part(&mut self, image: &Option<[f64; 2]>) -> Option<Part> {
        let binning = [F::BinningX, F::BinningY].map(|field| self.number(field).unwrap_or(1.0).max(1.0));
        let whole = self.pair(F::FullWidth, F::FullHeight).or(*image);
        let corner = self.pair(F::CropX, F::CropY);
        let size = self.pair(F::CropWidth, F::CropHeight).filter(|[width, height]| *width > 0.0 && *height > 0.0);
        let is_on = self.is_on(F::Crop).unwrap_or(true);
        match (corner, size, whole) {
            (Some(corner), Some(size), Some(_)) if is_on => Some(Part { corner, size, binning }),
            (_, _, Some(size)) if binning != [1.0; 2] => Some(Part { corner: [0.0; 2], size, binning }),
            _ => None,
        }
    }
}

/// True for the model of a lens that is no pinhole.
fn is_no_pinhole(model: &str) -> bool {
    let parts =
        ["fish", "equidist", "omni", "spheric", "equirect", "panoram", "cylind", "kannala", "eucm", "double_sphere"];
    parts.iter().any(|part| model.contains(part)) || matches!(model, "ds" | "fov" | "kb" | "kb4")
}

/// Puts each entry into one of the lists.
fn account(pasted: &mut Pasted, said: &Said<'_>, is_rectified: bool) {
    let mut coefficients = Vec::new();
    for (at, entry) in said.entries.iter().enumerate() {
        let is_taken = said.taken.iter().any(|(_, own)| *own == at);
        let first = entry.fields.first().copied().unwrap_or(F::Unknown);
        let is_zero = entry.numbers.iter().all(|number| number.value == 0.0);
        let why = match first {
            F::Distortion | F::Coefficient => {
                coefficients.push(entry);
                continue;
            }
            F::Skip | F::Ignored => Some(Why::SaysNothing),
            F::Extent | F::Orthogonal if !is_taken => Some(Why::SaysNothing),
            F::NotCamera | F::Map9 | F::Map12 | F::Map16 => Some(Why::NotCamera),
            F::Model if is_no_pinhole(&entry.text.to_lowercase()) && !is_rectified => Some(Why::Fisheye),
            F::Model | F::Name | F::Part | F::FovAxis => None,
            F::Unknown => Some(Why::Unknown),
            _ if said.repeated.contains(&at) && entry.fields.len() == 1 => {
                let own = said.first.iter().find(|(field, ..)| *field == first).map(|(.., own)| *own);
                let is_same = !entry.numbers.is_empty() && own == Some(entry.numbers.as_slice());
                Some(if entry.is_inherited || is_same { Why::Overridden } else { Why::Repeated })
            }
            // The pose is a matrix.
            F::Up if !is_taken && pasted.entries.is_some() => Some(Why::Overridden),
            _ if is_taken => None,
            _ if is_rectified => Some(Why::BeforeRectification),
            F::Crop | F::FullWidth | F::FullHeight | F::CropX | F::CropY | F::CropWidth | F::CropHeight => {
                Some(Why::SaysNothing)
            }
            F::Pan | F::FilmOffset if is_zero => Some(Why::Zero),
            F::FilmGauge | F::HalfHeight | F::HalfWidth | F::Chain => Some(Why::Overridden),
            _ => Some(Why::NotUsed),
        };
        let (name, value) = (entry.name.clone(), entry.value());
        match why {
            None => pasted.used.push(Used { name, value, meaning: first.symbol() }),
            Some(why) => pasted.left_out.push(LeftOut { name, value, why }),
        }
    }
    if !coefficients.is_empty() {
        let join =
            |of: &dyn Fn(&Entry) -> String, mark| coefficients.iter().map(|k| of(k)).collect::<Vec<_>>().join(mark);
        let (name, value) = (join(&|entry| entry.name.clone(), ", "), join(&Entry::value, " "));
        if coefficients.iter().all(|entry| entry.numbers.iter().all(|k| k.value == 0.0)) {
            pasted.used.push(Used { name, value, meaning: "k = 0" });
        } else {
            let why = if is_rectified {
                Why::BeforeRectification
            } else if said.words().split(' ').any(is_no_pinhole) {
                Why::Fisheye
            } else {
                Why::Distortion { model: said.words().trim().to_owned(), pixels: pasted.shift_at_corner(&coefficients) }
            };
            pasted.left_out.insert(0, LeftOut { name, value, why });
        }
    }
    // What a picture can't show comes first.
    pasted.left_out.sort_by_key(|left| left.why.changes_image() == Some(false));
}

/// The camera of some entries.
pub(crate) fn assemble(name: &str, entries: &[Entry], sign: Sign) -> Pasted {
    let mut said = Said::new(entries, sign);
    let mut pasted = Pasted { name: name.to_owned(), ..Pasted::default() };
    let mut image = said.pair(F::ImageWidth, F::ImageHeight);
    let has_matrix = said.has(F::Pinhole);
    let part = if has_matrix { said.part(&image) } else { None };
    match said.lens(&mut image) {
        // K, its distortion and R are those before rectification.
        Ok(lens) => pasted.lens = lens.filter(|_| !has_matrix),
        Err(error) => pasted.refused = Some(error.into()),
    }
    pasted.image = image.and_then(|[m, n]| image_size(m, n));
    let is_vision = matches!(pasted.lens, Some(GivenLens { size: Size::Pixels { .. }, .. })) || said.has(F::Rvec);
    pasted.is_scaled = said.number(F::Scale).is_some();
    if let Some((entries, word)) = said.pose(is_vision) {
        (pasted.entries, pasted.word) = (Some(entries), Some(word));
    }
    if let (Some(Part { corner, binning, .. }), Some(entries)) = (part, &mut pasted.entries) {
        entries.crop(corner, binning);
    }
    // M_p beside a pose is its lens.
    let has_pose =
        pasted.word.and_then(|word| word.kind).is_some_and(|kind| kind.has_camera_axes() || kind == MatrixKind::LookAt);
    if has_pose && let Some(lens) = Said::new(entries, sign).only_projection() {
        said.list(F::Projection);
        pasted.projection = Some(Box::new(Pasted { entries: Some(lens.0), word: Some(lens.1), ..Pasted::default() }));
    }
    let d = pasted.entries.as_ref().and_then(distance_of);
    if let Some(lens) = &mut pasted.lens {
        if let Some(d) = d {
            lens.near = lens.near.or(said.number(F::NearOfTarget).map(|near| d + near).filter(|near| *near > 0.0));
            lens.far = lens.far.or(said.number(F::FarOfTarget).map(|far| d + far));
        }
        // POV-Ray: a parallel window is as large as that of the angle at the target.
        if lens.is_parallel && lens.is_slope {
            lens.size = match (lens.size, d) {
                (Size::Length(side @ (Side::Up | Side::Across), slope), Some(d)) => Size::Length(side, d * slope),
                _ => Size::Open,
            };
        }
    }
    pasted.is_chained = said.has(F::Chain);
    if let (None, Some(chain)) = (&pasted.entries, said.list(F::Chain)) {
        let m = matrix_of(&chain, 4);
        let view = word("T_cn_cnm1", MatrixKind::View, Some(Axes::OPENCV), Some(Order::Rows));
        (pasted.entries, pasted.word) = (Some(MatrixEntries::of_matrix(m, 0.0)), Some(view));
    }
    // R alone may be that of a rectification, if it turns nothing.
    let is_identity = |said: &Said<'_>| {
        said.first.iter().all(|(field, _, numbers)| {
            let is_one = |(k, x): (usize, &Written)| (x.value - f64::from(u8::from(k % 4 == 0))).abs() < 1e-9;
            let is_r = *field == F::R && said.name(F::R).to_lowercase().ends_with('r');
            !field.is_pose() || *field == F::Up || is_r && numbers.iter().enumerate().all(is_one)
        })
    };
    let is_half = pasted.entries.is_none() && !is_identity(&said);
    if (is_half || pasted.entries.is_none() && pasted.lens.is_none()) && pasted.refused.is_none() {
        let is_part = |entry: &&Entry| entry.has(|field| field.is_pose() || field.is_lens() && !is_half);
        let mut names: Vec<&str> = entries.iter().filter(is_part).map(|entry| entry.name.as_str()).collect();
        if names.is_empty() {
            names.extend(entries.iter().take(3).map(|entry| entry.name.as_str()));
        }
        pasted.refused = Some(MatrixTextError::Incomplete(names.join(", ")).into());
    }
    account(&mut pasted, &said, has_matrix);
    pasted
}

/// D of a look-at.
fn distance_of(entries: &MatrixEntries) -> Option<f64> {
    let m = (entries.count() == 9).then(|| entries.matrix(false))?;
    Some((m.row(0) - m.row(1)).truncate().length())
}
