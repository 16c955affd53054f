//! The lens that the entries of a camera say.

use super::camera::{Said, Side, matrix_of};
use super::names::{Field as F, plain};
use super::{GivenLens, MatrixTextError, Size};

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
