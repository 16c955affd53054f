//! Warnings: a camera that is possible, but probably not meant.

use crate::camera::{Camera, ImageSize, Projection};

/// Something about a camera, or about a figure, that a user should know.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Warning {
    /// VUP is almost along DOP, so **u** and **v** depend on its last digits.
    #[error(
        "view_up is only {degrees:.3e} degrees away from the direction of projection, so its last digits decide where up is"
    )]
    ViewUpNearlyCollinear {
        /// The angle between VUP and the line of DOP.
        degrees: f64,
    },
    /// The depth of far objects falls into few steps of a 24-bit depth buffer.
    #[error(
        "far / near is {ratio:.3e}: a 24-bit depth buffer cannot tell apart depths that differ by {step:.3e} at the back plane; move near away from the camera"
    )]
    DepthPrecision {
        /// B / F.
        ratio: f64,
        /// The smallest difference of depth at B that is resolved, in scene units.
        step: f64,
    },
    /// PF isn't between the clipping planes.
    #[error(
        "focal_point is {distance} away, which is not between near = {near} and far = {far}: what the camera looks at is clipped away"
    )]
    FocalPointClipped {
        /// D.
        distance: f64,
        /// F.
        near: f64,
        /// B.
        far: f64,
    },
    /// A perspective so wide that its borders are stretched.
    #[error("the window spans {degrees:.6} degrees: everything is stretched towards its borders")]
    WideAngle {
        /// θ, or the angle that a given window spans.
        degrees: f64,
    },
    /// The camera is small and far from the origin of the world.
    #[error(
        "the camera is {ratio:.3e} times farther from the origin than from its focal_point: only {digits} of 15 digits are left for what it sees"
    )]
    FarFromOrigin {
        /// The greatest coordinate of C or PF over D.
        ratio: f64,
        /// Decimal digits that are left.
        digits: u32,
    },
    /// The picture would be stretched.
    #[error("the view window has aspect {window:.6} and the image {image:.6}: shapes are stretched")]
    AspectMismatch {
        /// A.
        window: f64,
        /// m / n.
        image: f64,
    },
}

impl Warning {
    /// A name that doesn't change, for programs.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::ViewUpNearlyCollinear { .. } => "view-up-nearly-collinear",
            Self::DepthPrecision { .. } => "depth-precision",
            Self::FocalPointClipped { .. } => "focal-point-clipped",
            Self::WideAngle { .. } => "wide-angle",
            Self::FarFromOrigin { .. } => "far-from-origin",
            Self::AspectMismatch { .. } => "aspect-mismatch",
        }
    }
}

/// The thresholds at which a number of a camera becomes trouble, used by warnings and by the program's camera check.
pub mod thresholds {
    /// Below this angle between VUP and DOP, an error in the sixth digit of VUP shows.
    pub const NEARLY_COLLINEAR_DEGREES: f64 = 0.01;
    /// A step of the depth buffer at B that is more than this part of B.
    pub const COARSE_DEPTH: f64 = 0.01;
    /// From here on a window is wide.
    pub const WIDE_DEGREES: f64 = 120.0;
    /// From here on fewer than nine digits are left.
    pub const FAR_AWAY: f64 = 1e7;
}

use thresholds::{COARSE_DEPTH, FAR_AWAY, NEARLY_COLLINEAR_DEGREES, WIDE_DEGREES};

/// Steps of a depth buffer of 24 bits.
const STEPS: f64 = 16_777_216.0;

impl Camera {
    /// Warnings about a camera that is possible, but probably not meant. Empty if there are none.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        let degrees = self.view_up_angle();
        if degrees < NEARLY_COLLINEAR_DEGREES {
            warnings.push(Warning::ViewUpNearlyCollinear { degrees });
        }
        let (near, far) = (self.near(), self.far());
        let distance = self.distance();
        if self.projection() == Projection::Perspective {
            let (ratio, step) = (far / near, self.depth_step(far));
            if step > COARSE_DEPTH * far {
                warnings.push(Warning::DepthPrecision { ratio, step });
            }
            let degrees = self.view_angle().degrees();
            if degrees > WIDE_DEGREES {
                warnings.push(Warning::WideAngle { degrees });
            }
        }
        if distance < near || distance > far {
            warnings.push(Warning::FocalPointClipped { distance, near, far });
        }
        let ratio = self.origin_ratio();
        if ratio > FAR_AWAY {
            #[expect(clippy::cast_possible_truncation, reason = "between 0 and 15")]
            let digits = (15.0 - ratio.log10()).clamp(0.0, 15.0) as u32;
            warnings.push(Warning::FarFromOrigin { ratio, digits });
        }
        warnings
    }

    /// The warning that the picture would be stretched by a pixel or more.
    pub fn aspect_warning(&self, image: ImageSize) -> Option<Warning> {
        let window = self.window_aspect();
        let (m, n) = (f64::from(image.width), f64::from(image.height));
        let stretched = (window * n - m).abs() >= 1.0 && (m / window - n).abs() >= 1.0;
        stretched.then(|| Warning::AspectMismatch { window, image: image.aspect() })
    }

    /// The smallest difference of depth that a depth buffer of 24 bits keeps at a depth in front of the eye, in scene
    /// units: one step over dZ/dz of (5.25), BF / ((B − F) z²) in perspective and 1 / (B − F) in parallel projection.
    /// Infinite if an `f64` has no such number.
    pub fn depth_step(&self, depth: f64) -> f64 {
        let (near, far) = (self.near(), self.far());
        match self.projection() {
            // Quotients come before products, so that nothing underflows on the way. If that overflows, the other order
            // is tried.
            Projection::Perspective => {
                let share = 1.0 - near / far;
                let step = depth / near * share * depth / STEPS;
                if step.is_finite() { step } else { depth / STEPS / near * share * depth }
            }
            Projection::Parallel => (far - near) / STEPS,
        }
    }

    /// The greatest coordinate of C or PF over D: how many times farther from the origin a camera is than from its
    /// focal point.
    pub fn origin_ratio(&self) -> f64 {
        self.position().abs().max(self.focal_point().abs()).max_element() / self.distance()
    }

    /// The angle between VUP and the line of DOP, in degrees, 0 … 90.
    pub fn view_up_angle(&self) -> f64 {
        let up = self.pose.up;
        let across = self.frame.v.dot(up).value().abs();
        let along = self.frame.n.dot(up).value().abs();
        across.atan2(along).to_degrees()
    }
}
