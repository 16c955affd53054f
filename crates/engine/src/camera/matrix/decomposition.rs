//! M_p M_v as a product of steps, in the decomposition of each of the notes. The view volume becomes the canonical one,
//! one step at a time.
//!
//! | steps | perspective | parallel |
//! | --- | --- | --- |
//! | `[0]` | T(−C), R (5.7), the first three rows of M_p, ÷ w_r (5.6) | T(−C), R, T, S (5.15) |
//! | `[2]` | T(−C), R, P (the frustum becomes a box), T, S | T(−C), R, T, S |
//! | `[1]` | T(−C), R, M_pers, M_xyscale; symmetric windows only | – (one matrix there) |
//! | `[3]` | M_trans, M_rot (left-handed), S_xy, S_z, M_P (1-10) to (1-18); symmetric windows only | M_trans, M_rot, T_ort, S_ort (1-7) |

use glam::{DMat3, DMat4, DQuat, DVec3, DVec4};

use crate::camera::{Api, Camera, Ndc, Projection};

crate::listed! {
    /// The source of the steps.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum Decomposition {
        /// `[0]`, Pagliosa
        #[default]
        Notes = "notes",
        /// `[2]`, Gattass: S T P
        Box = "box",
        /// `[1]`, USP: M_xyscale M_pers
        Scale = "scale",
        /// `[3]`: N_persp and M_P, N_ort; its canonical volume has z in 0 … 1
        Normalised = "normalised",
    }
    /// Its word on the command line.
    pub fn name
}

/// A step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factor {
    /// The step's place in its source, such as `[2]` P.
    pub step: Step,
    /// Multiplies the product of the steps before it from the left.
    pub matrix: DMat4,
    /// After it z grows into the screen. The space is left-handed.
    pub left_handed: bool,
}

/// A step, in the words of its source.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// T(−C): the eye moves to the origin.
    ToEye,
    /// R: **u**, **v**, **n** turn onto x, y, z.
    Turn,
    /// `[3]` M_rot: **u**, **v** and DOP, which is left-handed.
    TurnLeftHanded,
    /// The first three rows of M_p: clip coordinates, before anything is divided.
    ClipRows,
    /// ÷ w_r, as a matrix applied to the result of the clip rows.
    Divide,
    /// `[2]` P (over F): things at depth d become d/F times smaller; the frustum becomes a box.
    Box,
    /// The middle of the box moves to the origin.
    Centre,
    /// The box becomes the cube. Z turns around.
    Scale,
    /// `[1]` M_pers
    Pers,
    /// `[1]` M_xyscale
    XyScale,
    /// `[3]` S_xy: the sides become planes x = ±z, y = ±z.
    UnitSlope,
    /// `[3]` S_z: the far plane comes to z = 1.
    UnitDepth,
    /// `[3]` M_P, with k = F/B: the canonical frustum becomes the canonical box.
    CanonicalBox,
    /// `[3]` T_ort: the near plane comes to z = 0.
    NearToOrigin,
    /// `[3]` S_ort
    ScaleOrt,
}

impl Decomposition {
    /// The convention of NDC in which it ends.
    pub fn ndc(self) -> Ndc {
        match self {
            Self::Notes | Self::Box | Self::Scale => Ndc::default(),
            Self::Normalised => Ndc { api: Api::Direct3d, ..Ndc::default() },
        }
    }

    /// The most steps that it has, in perspective or parallel projection.
    pub const fn most_steps(self) -> u32 {
        match self {
            Self::Notes | Self::Scale => 4,
            Self::Box | Self::Normalised => 5,
        }
    }

    /// Its number in the list of sources: `[0]` … `[3]`.
    pub fn source(self) -> &'static str {
        match self {
            Self::Notes => "[0]",
            Self::Scale => "[1]",
            Self::Box => "[2]",
            Self::Normalised => "[3]",
        }
    }
}

impl Camera {
    /// The steps, first to last. `None` if the source has none, because `[1]` and `[3]` know symmetric windows only,
    /// and `[1]` has one matrix for parallel projection.
    ///
    /// *Guarantees*: their product, last to first, is M_p M_v in [`Decomposition::ndc`], up to the rounding of plain
    /// `f64` (in perspective up to a positive factor, which the division takes out).
    pub fn decomposed(&self, decomposition: Decomposition) -> Option<Vec<Factor>> {
        let symmetric = self.has_symmetric_window();
        let perspective = self.projection() == Projection::Perspective;
        let mut left_handed = false;
        let factors: Vec<(Step, DMat4)> = match (decomposition, perspective) {
            (Decomposition::Scale | Decomposition::Normalised, _) if !symmetric => return None,
            (Decomposition::Scale, false) => return None,
            (Decomposition::Notes, true) => {
                [self.to_eye(), self.turn()].into_iter().chain(self.clip_and_divide()).collect()
            }
            (Decomposition::Box, true) => {
                [self.to_eye(), self.turn(), self.to_box(), self.centre(), self.scale()].into()
            }
            (Decomposition::Notes | Decomposition::Box, false) => {
                [self.to_eye(), self.turn(), self.centre(), self.scale()].into()
            }
            (Decomposition::Scale, true) => {
                [self.to_eye(), self.turn()].into_iter().chain(self.pers_and_scale()).collect()
            }
            (Decomposition::Normalised, true) => {
                [self.to_eye(), self.turn_left_handed()].into_iter().chain(self.normalised()).collect()
            }
            (Decomposition::Normalised, false) => {
                [self.to_eye(), self.turn_left_handed()].into_iter().chain(self.normalised_box()).collect()
            }
        };
        let factor = |(step, matrix): (Step, DMat4)| {
            left_handed |= step.turns_z_around();
            Factor { step, matrix, left_handed }
        };
        Some(factors.into_iter().map(factor).collect())
    }

    fn to_eye(&self) -> (Step, DMat4) {
        (Step::ToEye, DMat4::from_translation(-self.position()))
    }

    fn turn(&self) -> (Step, DMat4) {
        let basis = self.basis();
        let turn = DMat3::from_cols(basis.u, basis.v, basis.n).transpose();
        (Step::Turn, DMat4::from_mat3(turn))
    }

    fn turn_left_handed(&self) -> (Step, DMat4) {
        (Step::TurnLeftHanded, mirror() * self.turn().1)
    }

    fn clip_and_divide(&self) -> [(Step, DMat4); 2] {
        let m = self.clip_from_view();
        let rows = [m.row(0), m.row(1), m.row(2), DVec4::W];
        let (z, depth) = (m.row(2).z, m.row(2).w);
        // w_r = −z_c, and z_r = z z_c + d.
        let divide = [DVec4::X, DVec4::Y, DVec4::Z, DVec4::new(0.0, 0.0, -1.0 / z, depth / z)];
        [(Step::ClipRows, from_rows(rows)), (Step::Divide, from_rows(divide))]
    }

    fn to_box(&self) -> (Step, DMat4) {
        let (near, far) = (self.near(), self.far());
        let rows =
            [DVec4::X, DVec4::Y, DVec4::new(0.0, 0.0, 1.0 + far / near, far), DVec4::new(0.0, 0.0, -1.0 / near, 0.0)];
        (Step::Box, from_rows(rows))
    }

    fn centre(&self) -> (Step, DMat4) {
        let w = self.window();
        let depth = self.near() / 2.0 + self.far() / 2.0;
        let middle = DVec3::new(-(w.left / 2.0 + w.right / 2.0), -(w.bottom / 2.0 + w.top / 2.0), depth);
        (Step::Centre, DMat4::from_translation(middle))
    }

    fn scale(&self) -> (Step, DMat4) {
        let depth = self.far() - self.near();
        let scale = DVec3::new(2.0 / self.window_width(), 2.0 / self.window_height(), -2.0 / depth);
        (Step::Scale, DMat4::from_scale(scale))
    }

    fn pers_and_scale(&self) -> [(Step, DMat4); 2] {
        let m = self.clip_from_view();
        let near = self.near();
        let rows = [DVec4::X * near, DVec4::Y * near, m.row(2), DVec4::NEG_Z];
        let scale = DVec3::new(2.0 / self.window_width(), 2.0 / self.window_height(), 1.0);
        [(Step::Pers, from_rows(rows)), (Step::XyScale, DMat4::from_scale(scale))]
    }

    fn normalised(&self) -> [(Step, DMat4); 3] {
        let (near, far) = (self.near(), self.far());
        let slope = DVec3::new(2.0 * near / self.window_width(), 2.0 * near / self.window_height(), 1.0);
        // 1 − k is (B − F)/B, where nothing cancels but what must.
        let rest = (far - near) / far;
        let k = near / far;
        let rows = [DVec4::X, DVec4::Y, DVec4::new(0.0, 0.0, 1.0 / rest, -k / rest), DVec4::Z];
        [
            (Step::UnitSlope, DMat4::from_scale(slope)),
            (Step::UnitDepth, DMat4::from_scale(DVec3::splat(1.0 / far))),
            (Step::CanonicalBox, from_rows(rows)),
        ]
    }

    fn normalised_box(&self) -> [(Step, DMat4); 2] {
        let scale = DVec3::new(2.0 / self.window_width(), 2.0 / self.window_height(), 1.0 / (self.far() - self.near()));
        [
            (Step::NearToOrigin, DMat4::from_translation(DVec3::new(0.0, 0.0, -self.near()))),
            (Step::ScaleOrt, DMat4::from_scale(scale)),
        ]
    }
}

impl Step {
    fn turns_z_around(self) -> bool {
        matches!(self, Self::TurnLeftHanded | Self::ClipRows | Self::Scale | Self::Pers)
    }
}

impl Factor {
    /// The step with z towards the viewer before and after it, as a right-handed picture shows it. `before` is true if
    /// the space before it is left-handed.
    pub fn displayed(&self, before: bool) -> DMat4 {
        let side = |left_handed: bool| if left_handed { mirror() } else { DMat4::IDENTITY };
        side(self.left_handed) * self.matrix * side(before)
    }

    /// A part of a displayed step, 0 … 1. A rotation turns evenly, all others go straight.
    pub fn part(&self, before: bool, share: f64) -> DMat4 {
        let whole = self.displayed(before);
        if matches!(self.step, Step::Turn | Step::TurnLeftHanded) {
            let turn = DQuat::from_mat3(&DMat3::from_mat4(whole)).normalize();
            return DMat4::from_quat(DQuat::IDENTITY.slerp(turn, share));
        }
        DMat4::IDENTITY * (1.0 - share) + whole * share
    }
}

/// z the other way round.
fn mirror() -> DMat4 {
    DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0))
}

fn from_rows(rows: [DVec4; 4]) -> DMat4 {
    DMat4::from_cols(rows[0], rows[1], rows[2], rows[3]).transpose()
}
