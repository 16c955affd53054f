//! K \[R | t\] of computer vision → its camera.

use glam::{DMat4, DVec4};

use crate::camera::Projection;
use crate::camera::recovery::{EXACT, Lines, Recovery, RecoveryError, SLACK, Unknown};

impl Recovery {
    /// The camera of P = K \[R | t\], which is known up to a factor: an RQ decomposition, whose R has the determinant 1
    /// and whose focal lengths are positive.
    ///
    /// A matrix of four rows is padded: by 0 0 0 1 at its end, or by a row of z before the row of the depth.
    pub(crate) fn pinhole(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let last = m.row(3);
        let is_last = last.truncate().length() <= SLACK * last.w.abs();
        let rows = [m.row(0), m.row(1), m.row(if is_last { 2 } else { 3 })];
        let scale = rows[2].truncate().length();
        if scale <= f64::MIN_POSITIVE {
            return Err(RecoveryError::Affine);
        }
        let mut rows = rows.map(|row| row / scale);
        let [a, b, c] = rows.map(DVec4::truncate);
        if a.dot(b.cross(c)) < 0.0 {
            self.unknown.push(Unknown::SignReversed);
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
        if skew.abs() > EXACT * f_x {
            self.unknown.push(Unknown::SkewDropped);
        }
        let t_z = rows[2].w;
        let t_y = (rows[1].w - c_y * t_z) / f_y;
        let t_x = (rows[0].w - skew * t_y - c_x * t_z) / f_x;
        self.pose(-(r_1 * t_x + r_2 * t_y + r_3 * t_z), -r_2, -r_3);
        self.pixels([f_x, f_y], [c_x, c_y]);
        Ok(())
    }

    /// The window of focal lengths and a principal point in pixels, at the present F.
    fn pixels(&mut self, [f_x, f_y]: [f64; 2], [c_x, c_y]: [f64; 2]) {
        let image = self.reading.image;
        let [m, n] = [image.width, image.height].map(f64::from);
        let near = self.current.near;
        let [width, height] = [near * m / f_x, near * n / f_y];
        self.found.projection = Projection::Perspective;
        self.unknown.extend([Unknown::ClippingPlanes, Unknown::ImageSize]);
        self.window([width, height], [(0.5 - c_x / m) * width, (c_y / n - 0.5) * height]);
        let are_square = (f_x / f_y - 1.0).abs() <= EXACT;
        if !are_square {
            self.unknown.push(Unknown::PixelAspect);
        } else if self.found.window.is_none() {
            self.found.aspect = image.aspect();
        }
    }
}
