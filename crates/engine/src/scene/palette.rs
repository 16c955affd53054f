//! The colours of scenes: a palette that red-green blind people and grey printers can read, and the inks of each theme.

use super::{Object, ObjectPaint, Scene};
use crate::appearance::{HiddenLines, LineStyle, Rgba, Theme};

/// The colours that objects get when they name none, in turn. From the palettes of Okabe and Ito (2008) and of Paul Tol
/// (2021), chosen so that any two stay apart also for red-green and blue-yellow blind eyes and in greyscale
/// (lightness L\* 29 … 89 in steps of at least 5). Neighbours in the list are far apart.
pub const PALETTE: [Rgba; 8] = [
    Rgba::rgb(0x44, 0x77, 0xaa),
    Rgba::rgb(0xe6, 0x9f, 0x00),
    Rgba::rgb(0x44, 0xaa, 0x99),
    Rgba::rgb(0xaa, 0x33, 0x77),
    Rgba::rgb(0x66, 0xcc, 0xee),
    Rgba::rgb(0xd5, 0x5e, 0x00),
    Rgba::rgb(0xf0, 0xe4, 0x42),
    Rgba::rgb(0x00, 0x44, 0x88),
];

/// The colour of [`PALETTE`] that the fewest objects of a scene have. The first one of several.
pub fn least_used(scene: &Scene) -> Rgba {
    let has =
        |object: &&Object, color: Rgba| matches!(object.paint, ObjectPaint::Solid(c) if c.with_alpha(255) == color);
    let count = |color: Rgba| scene.objects.iter().filter(|object| has(object, color)).count();
    PALETTE.into_iter().min_by_key(|color| count(*color)).unwrap_or(PALETTE[0])
}

/// Blue of [`PALETTE`].
pub const BLUE: Rgba = PALETTE[0];
/// Orange of [`PALETTE`].
pub const ORANGE: Rgba = PALETTE[1];
/// Teal of [`PALETTE`].
pub const TEAL: Rgba = PALETTE[2];
/// Purple of [`PALETTE`].
pub const PURPLE: Rgba = PALETTE[3];
/// Light blue of [`PALETTE`].
pub const SKY: Rgba = PALETTE[4];
/// Vermilion of [`PALETTE`].
pub const VERMILION: Rgba = PALETTE[5];
/// Yellow of [`PALETTE`].
pub const YELLOW: Rgba = PALETTE[6];
/// Dark blue of [`PALETTE`].
pub const NAVY: Rgba = PALETTE[7];

/// The scene's colours in a theme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneColors {
    /// Letters, marks and free lines.
    pub ink: Rgba,
    /// Edges on faces.
    pub edge: Rgba,
    /// Lines of a grid.
    pub grid: Rgba,
    /// The ground under objects.
    pub ground: Rgba,
    /// The other tiles of a tiled ground.
    pub ground_other: Rgba,
    /// Walls, columns: background, not the subject.
    pub stone: Rgba,
}

impl SceneColors {
    /// The colours of a theme.
    pub const fn of(theme: Theme) -> Self {
        Self {
            ink: theme.color([0x1c_22_2b, 0xe8_ec_f1, 0x00_00_00]),
            edge: theme.color([0x2b_33_40, 0x10_14_1a, 0x00_00_00]),
            grid: theme.color([0xa8_b0_bb, 0x5a_65_73, 0x8c_8c_8c]),
            ground: theme.color([0xdf_e3_e8, 0x4a_53_60, 0xf2_f2_f2]),
            ground_other: theme.color([0xb9_c1_cb, 0x35_3d_48, 0xd0_d0_d0]),
            stone: theme.color([0xd8_d2_c4, 0x9c_96_8a, 0xe2_de_d6]),
        }
    }

    /// Style of the edges of a faceted object.
    pub const fn edge_style(&self) -> LineStyle {
        LineStyle::solid(self.edge, 1.0, HiddenLines::OfStyle)
    }

    /// Style of free segments.
    pub const fn segment_style(&self, color: Rgba) -> LineStyle {
        LineStyle::solid(color, 1.75, HiddenLines::OfStyle)
    }

    /// Style of a grid.
    pub const fn grid_style(&self, color: Rgba) -> LineStyle {
        LineStyle::solid(color, 0.75, HiddenLines::Hidden)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn linear(c: u8) -> f64 {
        let c = f64::from(c) / 255.0;
        if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
    }

    /// CIE L\*a\*b\* (D65) of linear sRGB.
    fn lab(rgb: [f64; 3]) -> [f64; 3] {
        let [r, g, b] = rgb.map(|c| c.clamp(0.0, 1.0));
        let f = |t: f64| if t > 0.008_856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 };
        let x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
        let y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
        let z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// Machado, Oliveira, Fernandes (2009), severity 1: protan, deutan, tritan.
    const BLIND: [[[f64; 3]; 3]; 3] = [
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    ];

    #[test]
    fn colours_stay_apart_for_colour_blind_eyes() {
        for m in BLIND {
            let seen = PALETTE.map(|c| {
                let c = [linear(c.r), linear(c.g), linear(c.b)];
                lab(m.map(|row| row[0] * c[0] + row[1] * c[1] + row[2] * c[2]))
            });
            for (i, a) in seen.iter().enumerate() {
                for (j, b) in seen.iter().enumerate().skip(i + 1) {
                    let d: f64 = (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
                    assert!(d > 14.0, "{} and {} differ by {d:.1}", PALETTE[i], PALETTE[j]);
                }
            }
        }
    }

    #[test]
    fn colours_stay_apart_in_greyscale() {
        let mut lightness = PALETTE.map(|c| lab([linear(c.r), linear(c.g), linear(c.b)])[0]);
        lightness.sort_by(f64::total_cmp);
        for pair in lightness.windows(2) {
            assert!(pair[1] - pair[0] > 5.0, "{lightness:?}");
        }
    }
}
