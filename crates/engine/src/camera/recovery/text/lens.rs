//! The lens that the entries of a camera say.

use super::camera::{Entry, Said, Side, Sign, matrix_of, word};
use super::names::{Field as F, plain};
use super::{GivenLens, LeftOut, Pasted, Size, Used, Why, image_size};
use crate::camera::recovery::reading::Written;
use crate::camera::recovery::{MatrixEntries, MatrixKind, MatrixTextError};
use crate::camera::{Axes, Order};

impl Said<'_> {
    /// The lens.
    ///
    /// # Errors
    /// [`MatrixTextError::Range`] for a number that no lens has.
    pub(crate) fn lens(&mut self, image: &mut Option<[f64; 2]>) -> Result<Option<GivenLens>, MatrixTextError> {
        let units = self.sign.units;
        let mut lens = GivenLens { near: self.number(F::Near), far: self.number(F::Far), ..GivenLens::default() };
        if units != 1.0 {
            (lens.near, lens.far) = (lens.near.map(|x| x * units), lens.far.map(|x| x * units));
        }
        lens.aspect = self.number(F::Aspect);
        if let (Some(x), Some(y), Some([m, n])) = (self.number(F::PixelAspectX), self.number(F::PixelAspectY), *image) {
            lens.aspect = Some(m * x / (n * y));
        }
        let words = self.words();
        let parallel = self.is_on(F::Parallel).or_else(|| self.is_on(F::Perspective).map(|on| !on));
        let is_said = (words.contains("ortho") || words.contains("parallel")).then_some(true);
        let parallel = parallel.or(is_said).or(self.sign.is_parallel.then_some(true));
        let zoom = if self.has(F::BoundsMin) { 1.0 } else { self.number(F::Zoom).unwrap_or(1.0) };
        lens.shift = [self.number(F::ShiftX), self.number(F::ShiftY)].map(|shift| shift.unwrap_or(0.0));
        lens.shift_of_height = lens.shift != [0.0; 2];
        if let Some([x, y]) = self.number(F::CenterX).zip(self.number(F::CenterY)).map(|(x, y)| [x, y]) {
            lens.shift = [x / 2.0, y / 2.0];
        }
        lens.size = self.size(&mut lens, parallel, image)?;
        lens.zoom = zoom;
        lens.is_parallel = parallel.unwrap_or(matches!(lens.size, Size::Height(_) | Size::Width(_)));
        if let (Some(offset), Some(gauge), Size::AngleY(angle)) =
            (self.number(F::FilmOffset), self.number(F::FilmGauge), lens.size)
            && offset != 0.0
        {
            let width = gauge * lens.aspect.unwrap_or(1.0).min(1.0);
            lens.shift = [offset / width / (2.0 * (angle.to_radians() / 2.0).tan() / zoom), 0.0];
            lens.shift_of_height = true;
        }
        self.crop(&mut lens, image);
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
        if let Some(k) = self.list(F::K) {
            let k = if k[2] == 0.0 && k[5] == 0.0 && (k[6] != 0.0 || k[7] != 0.0) {
                // MATLAB and Open3D write it by columns.
                matrix_of(&k, 3).transpose().to_cols_array_2d()
            } else {
                matrix_of(&k, 3).to_cols_array_2d()
            };
            let [[f_x, _, _, _], [skew, f_y, _, _], [x, y, last, _], _] = k;
            if !(f_x > 0.0 && f_y > 0.0) || (last - 1.0).abs() > 2e-3 {
                let allowed = "f_x > 0, f_y > 0, 0 0 1";
                return Err(MatrixTextError::Range { name: self.name(F::K), value: f_x.min(f_y), allowed });
            }
            return Ok(Size::Pixels { focal_lengths: [f_x, f_y], principal_point: Some([x, y]), skew });
        }
        let middle = image.map(|image| image.map(|side| side / 2.0));
        let point = |said: &mut Self| {
            let point = said.number(F::Cx).zip(said.number(F::Cy)).map(|(x, y)| [x, y]);
            let is_of_middle = said.name(F::Cx).starts_with("Metashape");
            match (point, middle) {
                (Some([x, y]), Some([m, n])) if is_of_middle => Some([m + x, n + y]),
                (point, middle) => point.or(middle),
            }
        };
        let pixels = |f_x, f_y, principal_point| {
            let focal_lengths = [f_x, f_y];
            Ok(Size::Pixels { focal_lengths, principal_point, skew: 0.0 })
        };
        if let Some(f_x) = self.number(F::Fx) {
            let f_y = self.number(F::Fy).unwrap_or(f_x);
            if !(f_x > 0.0 && f_y > 0.0) {
                return Err(MatrixTextError::Range { name: self.name(F::Fx), value: f_x.min(f_y), allowed: "> 0" });
            }
            let point = point(self);
            return pixels(f_x, f_y, point);
        }
        let has_sensor = self.has(F::SensorWidth) || self.has(F::SensorHeight);
        if self.has(F::Focal) && !has_sensor && (image.is_some() || self.has(F::Cx)) {
            let f = self.number(F::Focal).unwrap_or(1.0);
            let point = point(self);
            return pixels(f, f, point);
        }
        let mut size = Size::Open;
        let focal = if self.has(F::FocalMm) { F::FocalMm } else { F::Focal };
        if self.has(focal) && parallel != Some(true) && (has_sensor || focal == F::FocalMm) {
            let f = self.number(focal).unwrap_or(50.0);
            if let (Some(x), Some(y)) = (self.number(F::PixelWidth), self.number(F::PixelHeight)) {
                let point = point(self);
                return pixels(f / x, f / y, point);
            }
            let (width, height) = (self.number(F::SensorWidth), self.number(F::SensorHeight));
            let middle = |side: Option<f64>, x: Option<f64>| side.zip(x).map_or(0.0, |(side, x)| x / side);
            if self.has(F::SensorX) || self.has(F::SensorY) {
                lens.shift = [middle(width, self.number(F::SensorX)), middle(height, self.number(F::SensorY))];
            }
            lens.aspect = lens.aspect.or(width.zip(height).map(|(width, height)| width / height));
            size = match (width, height) {
                (_, Some(height)) => Size::SlopeY(height / f),
                (Some(width), None) => Size::SlopeX(width / f),
                // Blender's sensor is 36 mm along the larger side.
                (None, None) => Size::SlopeLarger(36.0 / f),
            };
        }
        for (field, side) in [(F::AngleY, Side::Up), (F::AngleX, Side::Across), (F::Fov, self.sign.side)] {
            let across = self.entries.iter().find(|entry| entry.fields.contains(&F::FovAxis));
            let side = match across.map(|entry| entry.text.as_str()) {
                Some("x") => Side::Across,
                Some("y") => Side::Up,
                Some("smaller") => Side::Smaller,
                _ => side,
            };
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
                let slope = 2.0 * (degrees.to_radians() / 2.0).tan();
                size = match side {
                    Side::Up => Size::AngleY(degrees),
                    Side::Across => Size::SlopeX(slope),
                    Side::Smaller => Size::SlopeSmaller(slope),
                };
            }
        }
        if size != Size::Open && parallel != Some(true) {
            return Ok(size);
        }
        let of_angle = size;
        let sides = [F::Left, F::Right, F::Bottom, F::Top].map(|field| self.number(field));
        if let [Some(left), Some(right), Some(bottom), Some(top)] = sides {
            return Ok(Size::Sides([left, right, bottom, top]));
        }
        if let (Some(height), Some(x), Some(y)) =
            (self.number(F::WindowHeight), self.number(F::OffsetX), self.number(F::OffsetY))
        {
            (lens.shift, lens.shift_of_height) = ([x / height, y / height], true);
            return Ok(Size::SlopeY(height / lens.near.unwrap_or(1.0)));
        }
        let height = self.number(F::Height).or(self.number(F::HalfHeight).map(|half| 2.0 * half));
        let width = self.number(F::Width).or(self.number(F::HalfWidth).map(|half| 2.0 * half));
        lens.aspect = lens.aspect.or(width.zip(height).map(|(width, height)| width / height));
        Ok(match (height, width) {
            (Some(height), _) => Size::Height(height * units),
            (None, Some(width)) => Size::Width(width * units),
            (None, None) => of_angle,
        })
    }

    /// A part of a larger image.
    fn crop(&mut self, lens: &mut GivenLens, image: &mut Option<[f64; 2]>) {
        let [x, y, width, height] = [F::CropX, F::CropY, F::CropWidth, F::CropHeight].map(|field| self.number(field));
        let (Some(x), Some(y), Some(width), Some(height)) = (x, y, width, height) else { return };
        let whole = self.number(F::FullWidth).zip(self.number(F::FullHeight)).map(|(m, n)| [m, n]).or(*image);
        let is_on = self.is_on(F::Crop).unwrap_or(true);
        let Some([m, n]) = whole.filter(|_| is_on && width > 0.0 && height > 0.0) else { return };
        lens.crop = Some([x / m, y / n, width / m, height / n]);
        if image.is_some() {
            *image = Some([width, height]);
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
    let is_fisheye = said.words().split(' ').any(is_no_pinhole);
    let mut coefficients = Vec::new();
    for (at, entry) in said.entries.iter().enumerate() {
        let name = entry.name.clone();
        let is_taken = said.taken.iter().any(|(_, own)| *own == at);
        let first = entry.fields.first().copied().unwrap_or(F::Unknown);
        let value = entry.value();
        let why = match first {
            F::Skip | F::Ignored => Some(Why::SaysNothing),
            F::NotCamera | F::Map9 | F::Map12 | F::Map16 => Some(Why::NotCamera),
            F::Distortion | F::Coefficient => {
                let own: Vec<f64> = entry.numbers.iter().map(|number| number.value).collect();
                let is_zero = own.iter().all(|k| *k == 0.0);
                if !is_rectified && !is_zero {
                    coefficients.push((at, own));
                    continue;
                }
                Some(if is_zero { Why::Zero } else { Why::BeforeRectification })
            }
            F::Model if is_no_pinhole(&entry.text.to_lowercase()) && !is_rectified => Some(Why::Fisheye),
            F::Model | F::Name | F::Part | F::FovAxis => None,
            F::Binning if entry.numbers.iter().all(|number| number.value <= 1.0) => None,
            F::Unknown => Some(Why::Unknown),
            _ if said.repeated.contains(&at) && entry.fields.len() == 1 => {
                Some(if entry.is_inherited { Why::Overridden } else { Why::Repeated })
            }
            // The pose is a matrix.
            F::Up if !is_taken && pasted.entries.is_some() => Some(Why::Overridden),
            _ if is_taken => None,
            _ if is_rectified => Some(Why::BeforeRectification),
            F::Crop | F::FullWidth | F::FullHeight | F::CropX | F::CropY | F::CropWidth | F::CropHeight => {
                Some(Why::SaysNothing)
            }
            F::Pan | F::FilmOffset if entry.numbers.iter().all(|number| number.value == 0.0) => Some(Why::Zero),
            F::FilmGauge | F::HalfHeight | F::HalfWidth | F::Chain => Some(Why::Overridden),
            _ => Some(Why::NotUsed),
        };
        match why {
            None => pasted.used.push(Used { name, value, meaning: first.symbol() }),
            Some(why) => pasted.left_out.push(LeftOut { name, value, why }),
        }
    }
    if !coefficients.is_empty() {
        let names: Vec<&str> = coefficients.iter().map(|(at, _)| said.entries[*at].name.as_str()).collect();
        let own: Vec<(String, Vec<f64>)> =
            coefficients.iter().map(|(at, k)| (plain(&said.entries[*at].name), k.clone())).collect();
        let model = said.words().trim().to_owned();
        let why =
            if is_fisheye { Why::Fisheye } else { Why::Distortion { model, pixels: pasted.shift_at_corner(&own) } };
        let value = coefficients.iter().map(|(at, _)| said.entries[*at].value()).collect::<Vec<_>>().join(" ");
        pasted.left_out.insert(0, LeftOut { name: names.join(", "), value, why });
    }
    // What a picture can't show comes first.
    pasted.left_out.sort_by_key(|left| left.why.changes_image() == Some(false));
}

/// The camera of some entries.
pub(crate) fn assemble(name: &str, entries: &[Entry], sign: Sign) -> Pasted {
    let mut said = Said::new(entries, sign);
    let mut pasted = Pasted { name: name.to_owned(), ..Pasted::default() };
    let mut image = said.number(F::ImageWidth).zip(said.number(F::ImageHeight)).map(|(m, n)| [m, n]);
    match said.lens(&mut image) {
        Ok(lens) => pasted.lens = lens,
        Err(error) => pasted.refused = Some(error.into()),
    }
    pasted.image = image.and_then(|[m, n]| image_size(m, n));
    let is_vision = matches!(pasted.lens, Some(GivenLens { size: Size::Pixels { .. }, .. })) || said.has(F::Rvec);
    let has_matrix = said.has(F::Pinhole);
    pasted.is_scaled = said.number(F::Scale).is_some();
    if let Some((entries, word)) = said.pose(is_vision) {
        (pasted.entries, pasted.word) = (Some(entries), Some(word));
    }
    if has_matrix {
        // K, its distortion and R are those before rectification.
        pasted.lens = None;
    }
    if let (Some(d), Some(lens)) = (pasted.entries.as_ref().and_then(|_| distance_of(&pasted)), &mut pasted.lens) {
        lens.near = lens.near.or(said.number(F::NearOfTarget).map(|near| d + near).filter(|near| *near > 0.0));
        lens.far = lens.far.or(said.number(F::FarOfTarget).map(|far| d + far));
    }
    // POV-Ray: a parallel window is as large as that of the angle at the target.
    if let Some(lens) = pasted.lens.filter(|lens| lens.is_parallel) {
        let d = pasted.entries.as_ref().and_then(|_| distance_of(&pasted));
        let slope = |angle: f64| 2.0 * (angle.to_radians() / 2.0).tan();
        let size = match (lens.size, d) {
            (Size::AngleY(angle), Some(d)) => Size::Height(d * slope(angle)),
            (Size::SlopeX(slope), Some(d)) => Size::Width(d * slope),
            (Size::AngleY(_) | Size::SlopeX(_) | Size::SlopeSmaller(_) | Size::SlopeLarger(_), _) => Size::Open,
            (size, _) => size,
        };
        pasted.lens = Some(GivenLens { size, ..lens });
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
fn distance_of(pasted: &Pasted) -> Option<f64> {
    let entries = pasted.entries.as_ref().filter(|entries| entries.count() == 9)?;
    let m = entries.matrix(false);
    Some((m.row(0) - m.row(1)).truncate().length())
}
