//! The ranges of normalised device coordinates that projections lead to, one row each.

use super::Ndc;

/// A range of normalised device coordinates. Programs have more of them than [`Ndc`] can write: near and far exchanged
/// in −1 … 1, or y turned over without Vulkan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct NdcRange {
    /// z_n at F.
    pub at_near: i8,
    /// z_n at B.
    pub at_far: i8,
    /// B is infinite.
    pub infinite: bool,
    /// y_n grows downwards.
    pub y_down: bool,
}

/// z_n at F and at B; the names with y_n up and down; points against it if the camera looks along −z, and along z.
struct RangeRow([i8; 2], [&'static str; 2], [f64; 2]);

/// The likelier first.
const DEPTHS: [RangeRow; 4] = [
    RangeRow([-1, 1], ["opengl", "opengl-y-down"], [0.0, 1.5]),
    RangeRow([0, 1], ["direct3d", "vulkan"], [1.5, 0.0]),
    RangeRow([1, 0], ["direct3d-reversed", "vulkan-reversed"], [2.0, 1.0]),
    RangeRow([1, -1], ["opengl-exchanged", "opengl-exchanged-y-down"], [3.0, 3.0]),
];

impl NdcRange {
    /// All with a back plane, the likelier first.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        let range = |[at_near, at_far]: [i8; 2], y_down| Self { at_near, at_far, infinite: false, y_down };
        DEPTHS.iter().flat_map(move |row| [range(row.0, false), range(row.0, true)])
    }

    fn row(self) -> &'static RangeRow {
        DEPTHS.iter().find(|row| row.0 == [self.at_near, self.at_far]).unwrap_or(&DEPTHS[0])
    }

    /// z_n at F and at B.
    pub(crate) fn depths(self) -> [f64; 2] {
        [self.at_near, self.at_far].map(f64::from)
    }

    /// Points against it before any number speaks.
    pub(crate) fn rarity(self, is_forward: bool) -> f64 {
        self.row().2[usize::from(is_forward)]
    }

    /// The name of its library, and the differences there.
    pub fn name(self) -> String {
        let ending = if self.infinite { "-infinite" } else { "" };
        format!("{}{ending}", self.row().1[usize::from(self.y_down)])
    }
}

impl From<Ndc> for NdcRange {
    fn from(ndc: Ndc) -> Self {
        let [at_near, at_far] = match ndc.depths() {
            [1.0, _] => [1, 0],
            [0.0, _] => [0, 1],
            _ => [-1, 1],
        };
        Self { at_near, at_far, infinite: ndc.infinite, y_down: ndc.y_points_down() }
    }
}

impl Default for NdcRange {
    fn default() -> Self {
        Ndc::default().into()
    }
}
