//! K \[R | t\] of computer vision, and K alone → their camera.

use glam::{DMat4, DVec3, DVec4};

use crate::camera::recovery::solve::Recovery;
use crate::camera::recovery::{EXACT, Lines, RecoveryError, SLACK, Unknown};
use crate::camera::{Parameters, Projection};

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
        if skew.abs() > SLACK * f_x {
            return Err(RecoveryError::Skew { skew, focal_length: f_x });
        }
        if skew != 0.0 {
            self.unknown.push(Unknown::SkewDropped);
        }
        self.unknown.push(Unknown::Pose);
        self.pixels([f_x, f_y], [m.z_axis.x, m.z_axis.y]);
        Ok(())
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
