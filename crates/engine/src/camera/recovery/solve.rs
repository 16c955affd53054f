//! The camera of a matrix: (5.7) and (5.13) to (5.16) read backwards.
//!
//! The rows of a view matrix are u, v and n, so C = −Rᵀ t. The first two rows of a projection matrix give the window
//! over F, and the third one gives F and B, because z_n is known at both planes. A product of both is harder. In
//! perspective its last row is −n and n · c up to a factor, which gives n. The rows above it are u and v, divided by
//! half the window, plus a part along n if the window is asymmetric. Every division is checked, because the matrix may
//! be singular, or that of no camera at all.

use glam::{DMat4, DVec3, DVec4};

use super::{EXACT, Lines, Reading, RecoveryError, SLACK, Unknown};
use crate::camera::{Api, Ndc, Parameters, Projection, Toward, ViewWindow, WorldUp};

/// A camera on its way from its matrix.
pub(crate) struct Recovery {
    pub(crate) current: Parameters,
    pub(crate) found: Parameters,
    pub(crate) reading: Reading,
    pub(crate) unknown: Vec<Unknown>,
}

impl Recovery {
    pub(crate) fn view(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let rows = affine_rows(m)?;
        for (i, row) in rows.iter().enumerate() {
            let length = row.truncate().length();
            if (length - 1.0).abs() > SLACK {
                return Err(RecoveryError::Length { row: i + 1, length });
            }
        }
        let axes = self.straightened(Lines::Rows, rows.map(DVec4::truncate))?;
        let position = -(axes[0] * rows[0].w + axes[1] * rows[1].w + axes[2] * rows[2].w);
        self.camera_axes(axes, position);
        Ok(())
    }

    /// C and the axes are the columns. An object may be scaled as well.
    pub(crate) fn camera_to_world(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let rows = affine_rows(m)?;
        let column = |i: usize| DVec3::new(rows[0][i], rows[1][i], rows[2][i]);
        let columns = [0, 1, 2].map(column);
        let axes = self.straightened(Lines::Columns, columns)?;
        let error = columns.iter().map(|axis| (axis.length() - 1.0).abs()).fold(0.0, f64::max);
        if error > SLACK {
            self.unknown.push(Unknown::Scaled);
        } else if error > EXACT {
            self.unknown.push(Unknown::Rounded);
        }
        self.camera_axes(axes, column(3));
        Ok(())
    }

    /// The pose of a camera whose axes x, y and z are known in the world of the reading.
    fn camera_axes(&mut self, axes: [DVec3; 3], position: DVec3) {
        let (mut v, mut n, mut u) = (DVec3::ZERO, DVec3::ZERO, DVec3::ZERO);
        for (axis, toward) in axes.into_iter().zip(self.reading.axes.camera) {
            match toward {
                Toward::Right => u = axis,
                Toward::Left => u = -axis,
                Toward::Up => v = axis,
                Toward::Down => v = -axis,
                Toward::Viewer => n = axis,
                Toward::Scene => n = -axis,
            }
        }
        let is_right_handed = u.cross(v).dot(n) > 0.0;
        if is_right_handed == self.reading.axes.left_handed {
            self.unknown.push(Unknown::LeftHandedView);
            n = -n;
        }
        self.pose(position, v, n);
        self.unknown.push(Unknown::Lens);
    }

    /// C, PF and VUP, one in each row.
    pub(crate) fn look_at(&mut self, m: DMat4) {
        self.note_world();
        let axes = self.reading.axes;
        let [position, focal_point, view_up] = [0, 1, 2].map(|i| axes.world_from_foreign(m.row(i).truncate()));
        self.found.position = position;
        self.found.focal_point = focal_point;
        self.found.view_up = view_up;
        self.unknown.push(Unknown::Lens);
    }

    /// Unit vectors at right angles, if the rows are so up to their digits.
    fn straightened(&mut self, lines: Lines, rows: [DVec3; 3]) -> Result<[DVec3; 3], RecoveryError> {
        for (i, row) in rows.iter().enumerate() {
            if row.length() == 0.0 {
                return Err(RecoveryError::Singular { lines, at: i + 1 });
            }
        }
        let units = rows.map(DVec3::normalize);
        for (a, b) in [(0, 1), (0, 2), (1, 2)] {
            let cosine = units[a].dot(units[b]);
            if cosine.abs() > SLACK {
                return Err(RecoveryError::Shear { lines, a: a + 1, b: b + 1, cosine });
            }
            if cosine.abs() > EXACT {
                self.unknown.push(Unknown::Rounded);
            }
        }
        let n = units[2];
        let u = (units[0] - n * units[0].dot(n)).normalize();
        let v = units[1] - n * units[1].dot(n);
        Ok([u, (v - u * v.dot(u)).normalize(), n])
    }

    /// Says how the world of the matrix was brought to ours.
    fn note_world(&mut self) {
        let axes = self.reading.axes;
        self.unknown.extend(match (axes.left_handed, axes.up == WorldUp::Z) {
            (true, true) => Some(Unknown::WorldExchanged),
            (true, false) => Some(Unknown::WorldMirrored),
            (false, true) => Some(Unknown::WorldTurned),
            (false, false) => None,
        });
    }

    /// C, and PF and VUP as far as they were right, in a right-handed world.
    pub(crate) fn pose(&mut self, position: DVec3, v: DVec3, n: DVec3) {
        self.note_world();
        let axes = self.reading.axes;
        let [position, v, n] = [position, v, n].map(|vector| axes.world_from_foreign(vector));
        let distance = (self.current.focal_point - self.current.position).length();
        let up = self.current.view_up;
        let above = up - n * up.dot(n);
        self.found.position = position;
        self.found.focal_point = position - n * distance;
        let fits = above.length() > 1e-6 * up.length() && above.normalize().dot(v) > 1.0 - 1e-12;
        self.found.view_up = if fits { up } else { v };
        self.unknown.extend([Unknown::FocalDistance, Unknown::ViewUp]);
    }

    pub(crate) fn projection(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let [down, forward] = self.reading.axes.signs();
        let m = m * DMat4::from_scale(DVec3::new(1.0, down, forward));
        let last = m.row(3);
        let rows = [m.row(0), m.row(1), m.row(2)];
        let size = rows.iter().map(|row| row.abs().max_element()).fold(last.abs().max_element(), f64::max);
        let perspective = last.z.abs() > SLACK * last.abs().max_element();
        let others = if perspective { [last.x, last.y, last.w] } else { [last.x, last.y, last.z] };
        if last == DVec4::ZERO {
            return Err(RecoveryError::LastRow { last });
        }
        let columns = if perspective { [1, 2, 4] } else { [1, 2, 3] };
        for (column, value) in columns.into_iter().zip(others) {
            if value.abs() > SLACK * last.abs().max_element() {
                return Err(RecoveryError::NotZero { row: 4, column, value });
            }
        }
        let kept = if perspective { [[0, 2], [1, 2], [2, 3]] } else { [[0, 3], [1, 3], [2, 3]] };
        for (i, (row, kept)) in rows.iter().zip(kept).enumerate() {
            for column in (0..4).filter(|column| !kept.contains(column)) {
                if row[column].abs() > SLACK * size {
                    return Err(RecoveryError::NotZero { row: i + 1, column: column + 1, value: row[column] });
                }
            }
        }
        self.unknown.push(Unknown::Pose);
        if perspective {
            let [x, y, z] = rows.map(|row| row / -last.z);
            self.perspective([x.x, y.y], [x.z, y.z], z.z, z.w)
        } else {
            let [x, y, z] = rows.map(|row| row / last.w);
            let near = self.near_in_parallel(z.z, z.w)?;
            self.parallel([x.x, y.y], [x.w, y.w], z.z, near)
        }
    }

    pub(crate) fn both(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let last = m.row(3);
        let axis = last.truncate().length();
        let largest = (0..3).map(|i| m.row(i).truncate().length()).fold(0.0, f64::max);
        // A perspective's last row is as long as 1 beside 2F/W and the like. A row of mere noise has no direction.
        if axis > 1e-9 * largest.max(last.w.abs()) { self.both_perspective(m / axis) } else { self.both_parallel(m) }
    }

    fn both_perspective(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let last = m.row(3);
        let n = -last.truncate();
        let rows = [m.row(0), m.row(1), m.row(2)];
        let skew = [0, 1].map(|i| rows[i].truncate().dot(n));
        let across = [0, 1].map(|i: usize| rows[i].truncate() - n * skew[i]);
        let [u, mut v, _] = self.straightened(Lines::Rows, [across[0], across[1], n])?;
        let scale = [u.dot(rows[0].truncate()), v.dot(rows[1].truncate())];
        if self.reading.ndc.y_down {
            v = -v;
        }
        if (u.cross(v).dot(n) < 0.0) != self.reading.axes.left_handed {
            return Err(RecoveryError::Mirrored);
        }
        let deep = rows[2].truncate();
        let z = deep.dot(n);
        if (deep - n * z).length() > SLACK * deep.length().max(EXACT) && deep.length() > EXACT {
            return Err(RecoveryError::Shear {
                lines: Lines::Rows,
                a: 3,
                b: 4,
                cosine: (deep - n * z).length() / deep.length(),
            });
        }
        // n·c, then the rest of the constants of the first two rows.
        let along = last.w;
        let down = if self.reading.ndc.y_down { -1.0 } else { 1.0 };
        let [x_c, y_c] = [(-rows[0].w - skew[0] * along) / scale[0], (-rows[1].w - skew[1] * along) / scale[1] * down];
        let position = u * x_c + v * y_c + n * along;
        self.pose(position, v, n);
        self.perspective([scale[0], down * scale[1]], skew, z, rows[2].w + z * along)
    }

    fn both_parallel(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let last = m.row(3);
        if last.w == 0.0 {
            return Err(RecoveryError::LastRow { last });
        }
        let rows = [0, 1, 2].map(|i| m.row(i) / last.w);
        let [u, v, deep] = self.straightened(Lines::Rows, rows.map(DVec4::truncate))?;
        let v = if self.reading.ndc.y_down { -v } else { v };
        let n = if self.reading.axes.left_handed { v.cross(u) } else { u.cross(v) };
        let mut z = deep.dot(n) * rows[2].truncate().length();
        let mut constant = rows[2].w;
        let [at_near, at_far] = self.reading.ndc.depths();
        // z_n grows away from the viewer, from z₀ to z₁.
        if z * (at_near - at_far) < 0.0 {
            self.unknown.push(Unknown::DepthDirection);
            (z, constant) = (-z, at_near + at_far - constant);
        }
        let scale = [rows[0].truncate().length(), rows[1].truncate().length()];
        let down = if self.reading.ndc.y_down { -1.0 } else { 1.0 };
        let near = self.current.near;
        let along = (at_near + z * near - constant) / z;
        let position = u * (-rows[0].w / scale[0]) + v * (-rows[1].w * down / scale[1]) + n * along;
        self.pose(position, v, n);
        self.unknown.extend([Unknown::PositionAlongNormal, Unknown::WindowCentre]);
        self.parallel([scale[0], down * scale[1]], [0.0, 0.0], z, near)
    }

    /// Window, F and B from the entries of (5.13).
    fn perspective(
        &mut self,
        [x, y]: [f64; 2],
        [skew_x, skew_y]: [f64; 2],
        z: f64,
        depth: f64,
    ) -> Result<(), RecoveryError> {
        let (y, skew_y) = if self.reading.ndc.y_down { (-y, -skew_y) } else { (y, skew_y) };
        if x <= 0.0 || y <= 0.0 {
            return Err(RecoveryError::Mirrored);
        }
        let (near, far) = self.planes(z, depth)?;
        self.found.projection = Projection::Perspective;
        (self.found.near, self.found.far) = (near, far);
        let (width, height) = (2.0 * near / x, 2.0 * near / y);
        self.window([width, height], [skew_x * width / 2.0, skew_y * height / 2.0]);
        Ok(())
    }

    /// F and B: z_n is z₀ at F and z₁ at B, so that F = d/(z + z₀), B = d/(z + z₁).
    fn planes(&mut self, z: f64, depth: f64) -> Result<(f64, f64), RecoveryError> {
        let of = |[at_near, at_far]: [f64; 2]| (depth / (z + at_near), depth / (z + at_far));
        let is_possible = |(near, far): (f64, f64)| near > 0.0 && near.is_finite() && near < far && far.is_finite();
        let (near, far) = of(self.reading.ndc.depths());
        // B is lost if 1 − F/B doesn't fit in an f64.
        if near > 0.0 && near.is_finite() && !(far > 0.0 && far < near * 1e15) {
            let [_, at_far] = self.reading.ndc.depths();
            if (z + at_far).abs() <= 1e-14 {
                self.unknown.push(Unknown::Far);
                return Ok((near, self.current.far.max(near * 2.0)));
            }
        }
        if is_possible((near, far)) {
            return Ok((near, far));
        }
        let fits = conventions().find(|ndc| is_possible(of(ndc.depths())));
        Err(RecoveryError::Depths { near, far, fits })
    }

    /// F of a parallel projection, which may be any finite number below B.
    fn near_in_parallel(&self, z: f64, depth: f64) -> Result<f64, RecoveryError> {
        if z == 0.0 {
            return Err(RecoveryError::Singular { lines: Lines::Rows, at: 3 });
        }
        let of = |[at_near, at_far]: [f64; 2]| ((depth - at_near) / z, (depth - at_far) / z);
        let is_possible = |(near, far): (f64, f64)| near.is_finite() && far.is_finite() && near < far;
        let (near, far) = of(self.reading.ndc.depths());
        if is_possible((near, far)) {
            return Ok(near);
        }
        let fits = conventions().find(|ndc| is_possible(of(ndc.depths())));
        Err(RecoveryError::Depths { near, far, fits })
    }

    fn parallel(
        &mut self,
        [x, y]: [f64; 2],
        [shift_x, shift_y]: [f64; 2],
        z: f64,
        near: f64,
    ) -> Result<(), RecoveryError> {
        let down = self.reading.ndc.y_down;
        let (y, shift_y) = if down { (-y, -shift_y) } else { (y, shift_y) };
        if x <= 0.0 || y <= 0.0 {
            return Err(RecoveryError::Mirrored);
        }
        let [at_near, at_far] = self.reading.ndc.depths();
        self.found.projection = Projection::Parallel;
        self.found.near = near;
        self.found.far = near + (at_near - at_far) / z;
        self.window([2.0 / x, 2.0 / y], [-shift_x / x, -shift_y / y]);
        Ok(())
    }

    /// A window of a size around a middle. A symmetric one as angle or height and aspect.
    pub(crate) fn window(&mut self, [width, height]: [f64; 2], [middle_x, middle_y]: [f64; 2]) {
        let symmetric = middle_x.abs() <= EXACT * width && middle_y.abs() <= EXACT * height;
        if symmetric {
            self.found.window = None;
            self.found.aspect = width / height;
            match self.found.projection {
                Projection::Perspective => {
                    self.found.view_angle = 2.0 * (height / 2.0).atan2(self.found.near).to_degrees();
                }
                Projection::Parallel => self.found.height = height,
            }
        } else {
            self.found.window = Some(ViewWindow {
                left: middle_x - width / 2.0,
                right: middle_x + width / 2.0,
                bottom: middle_y - height / 2.0,
                top: middle_y + height / 2.0,
            });
        }
    }
}

/// The first three rows of a matrix whose last one is 0 0 0 1, up to a factor.
fn affine_rows(m: DMat4) -> Result<[DVec4; 3], RecoveryError> {
    let last = m.row(3);
    if last.truncate().length() > SLACK * last.w.abs() || last.w == 0.0 {
        return Err(RecoveryError::LastRow { last });
    }
    Ok([0, 1, 2].map(|i| m.row(i) / last.w))
}

/// The conventions that a matrix may be in, those of the libraries themselves first.
fn conventions() -> impl Iterator<Item = Ndc> {
    let of_others = |ndc: &Ndc| !(ndc.infinite || ndc.api == Api::OpenGl && ndc.reversed);
    Ndc::ALL.into_iter().filter(of_others)
}

/// P = K \[R | t\], factored.
struct Factored {
    focal_lengths: [f64; 2],
    principal_point: [f64; 2],
    skew: f64,
    /// The rows of R: x right, y down, z into the scene.
    axes: [DVec3; 3],
    translation: [f64; 3],
    sign_reversed: bool,
}

/// An RQ decomposition of P, which is known up to a factor: R has the determinant 1, and focal lengths are positive.
///
/// A matrix of four rows is padded: by 0 0 0 1 at its end, or by a row of z before the row of the depth.
fn factored(m: DMat4) -> Result<Factored, RecoveryError> {
    let last = m.row(3);
    let is_last = last.truncate().length() <= SLACK * last.w.abs();
    let rows = [m.row(0), m.row(1), m.row(if is_last { 2 } else { 3 })];
    let scale = rows[2].truncate().length();
    if scale <= f64::MIN_POSITIVE {
        return Err(RecoveryError::Affine);
    }
    let mut rows = rows.map(|row| row / scale);
    let [a, b, c] = rows.map(DVec4::truncate);
    let sign_reversed = a.dot(b.cross(c)) < 0.0;
    if sign_reversed {
        rows = rows.map(|row| -row);
    }
    let [a, b, r_3] = rows.map(DVec4::truncate);
    let [c_x, c_y] = [a.dot(r_3), b.dot(r_3)];
    let across = b - r_3 * c_y;
    let f_y = across.length();
    if f_y <= EXACT * b.length() {
        return Err(RecoveryError::Singular { lines: Lines::Rows, at: 2 });
    }
    let r_2 = across / f_y;
    let r_1 = r_2.cross(r_3);
    let [f_x, skew] = [a.dot(r_1), a.dot(r_2)];
    if f_x <= EXACT * a.length() {
        return Err(RecoveryError::Singular { lines: Lines::Rows, at: 1 });
    }
    if skew.abs() > SLACK * f_x {
        return Err(RecoveryError::Skew { skew, focal_length: f_x });
    }
    let t_z = rows[2].w;
    let t_y = (rows[1].w - c_y * t_z) / f_y;
    let t_x = (rows[0].w - skew * t_y - c_x * t_z) / f_x;
    Ok(Factored {
        focal_lengths: [f_x, f_y],
        principal_point: [c_x, c_y],
        skew,
        axes: [r_1, r_2, r_3],
        translation: [t_x, t_y, t_z],
        sign_reversed,
    })
}

/// True if the numbers of K \[R | t\] can be pixels. If they can't, sixteen numbers are rather a projection.
pub(crate) fn check_pixels(m: DMat4) -> Result<(), RecoveryError> {
    let Factored { focal_lengths: [f_x, f_y], principal_point: [x, y], .. } = factored(m)?;
    let is_of_pixels = |f: f64, c: f64| f > 2.0 && c > 2.0 && f > 0.1 * c && f < 100.0 * c;
    if is_of_pixels(f_x, x) && is_of_pixels(f_y, y) {
        return Ok(());
    }
    Err(RecoveryError::NoPixels { focal_length: f_x, x, y })
}

impl Recovery {
    /// The camera of P = K \[R | t\].
    pub(crate) fn pinhole(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let p = factored(m)?;
        if p.sign_reversed {
            self.unknown.push(Unknown::SignReversed);
        }
        if p.skew.abs() > EXACT * p.focal_lengths[0] {
            self.unknown.push(Unknown::SkewDropped);
        }
        let ([r_1, r_2, r_3], [t_x, t_y, t_z]) = (p.axes, p.translation);
        self.pose(-(r_1 * t_x + r_2 * t_y + r_3 * t_z), -r_2, -r_3);
        self.pixels(p.focal_lengths, p.principal_point);
        Ok(())
    }

    /// The window of K alone.
    pub(crate) fn intrinsics(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let last = m.row(2).z;
        for (row, column) in [(1, 0), (2, 0), (2, 1)] {
            let value = m.row(row)[column];
            if value.abs() > SLACK * m.x_axis.x.abs() {
                return Err(RecoveryError::NotIntrinsics { row: row + 1, column: column + 1, value, expected: 0.0 });
            }
        }
        if (last - 1.0).abs() > SLACK {
            return Err(RecoveryError::NotIntrinsics { row: 3, column: 3, value: last, expected: 1.0 });
        }
        let [f_x, f_y] = [m.x_axis.x, m.y_axis.y];
        for (at, f) in [(1, f_x), (2, f_y)] {
            if f <= 0.0 {
                return Err(RecoveryError::Singular { lines: Lines::Rows, at });
            }
        }
        let skew = m.y_axis.x;
        self.skew(skew, f_x)?;
        self.unknown.push(Unknown::Pose);
        self.pixels([f_x, f_y], [m.z_axis.x, m.z_axis.y]);
        Ok(())
    }

    /// Drops a skew that is only that of the digits.
    pub(crate) fn skew(&mut self, skew: f64, focal_length: f64) -> Result<(), RecoveryError> {
        self.unknown.extend((skew != 0.0).then_some(Unknown::SkewDropped));
        let is_small = skew.abs() <= SLACK * focal_length;
        if is_small { Ok(()) } else { Err(RecoveryError::Skew { skew, focal_length }) }
    }

    /// The window of focal lengths and a principal point in pixels, at the present F.
    pub(crate) fn pixels(&mut self, focal_lengths: [f64; 2], principal_point: [f64; 2]) {
        let image = self.reading.image;
        let sides @ [m, n] = [image.width, image.height].map(f64::from);
        let (mut f, mut c) = (focal_lengths, principal_point);
        // No image is narrower than a pixel, so these are shares of its sides.
        let are_shares = c.iter().all(|c| (0.1..0.9).contains(c)) && f.iter().all(|f| (0.1..20.0).contains(f));
        if are_shares {
            self.unknown.push(Unknown::NormalisedPixels);
            f = [f[0] * m, f[1] * n];
            c = [c[0] * m, c[1] * n];
        }
        self.implausible(f, c, sides);
        self.distances();
        let near = self.found.near;
        let [width, height] = [near * m / f[0], near * n / f[1]];
        self.found.projection = Projection::Perspective;
        self.unknown.extend([Unknown::ClippingPlanes, Unknown::ImageSize]);
        self.window([width, height], [(0.5 - c[0] / m) * width, (c[1] / n - 0.5) * height]);
        let are_square = (f[0] / f[1] - 1.0).abs() <= EXACT;
        if !are_square {
            self.unknown.push(Unknown::PixelAspect);
        } else if self.found.window.is_none() {
            self.found.aspect = image.aspect();
        }
    }

    /// F and B of a parallel camera may be 0 or less. A perspective takes the usual ones then.
    pub(crate) fn distances(&mut self) {
        if self.found.near <= 0.0 {
            let Parameters { near, far, .. } = Parameters::default();
            (self.found.near, self.found.far) = (near, far);
        }
    }

    /// Notices on numbers that hardly any camera has.
    fn implausible(&mut self, f: [f64; 2], c: [f64; 2], sides: [f64; 2]) {
        let is_off = |c: f64, side: f64| (c / side - 0.5).abs() > 0.25;
        let is_middle = |c: f64, side: f64| (c / side - 0.5).abs() < 0.05;
        let is_middle_of = |[m, n]: [f64; 2]| is_middle(c[0], m) && is_middle(c[1], n);
        if !is_middle_of(sides) && is_middle_of([sides[1], sides[0]]) {
            self.unknown.push(Unknown::ImageTurned);
        } else if is_off(c[0], sides[0]) || is_off(c[1], sides[1]) {
            self.unknown.push(Unknown::PrincipalPoint);
        }
        // θ > 150°: H/2 > F tan 75°.
        if f.iter().zip(sides).any(|(f, side)| side / 2.0 > f * 75.0_f64.to_radians().tan()) {
            self.unknown.push(Unknown::WideAngle);
        }
    }
}
