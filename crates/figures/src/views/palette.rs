//! The colours of the pictures, one set for each theme.

use crate::appearance::{Rgba, Theme};

/// The colours of one theme. The hues are those of Okabe and Ito (2008), which red-green blind people can distinguish,
/// darkened or lightened until a letter in them has a contrast of 4.5 : 1 on the paper. Letters, dashes and shapes
/// repeat the information.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// Background of the three pictures.
    pub paper: Rgba,
    /// Background around the image if its aspect leaves space.
    pub surround: Rgba,
    /// Texts and strong lines.
    pub ink: Rgba,
    /// Texts and lines of less weight.
    pub soft: Rgba,
    /// Lines of the ground grid.
    pub grid: Rgba,
    /// x, y, z. Also u, v, n and x_n, y_n, z_n.
    pub axes: [Rgba; 3],
    /// Faces of the view volume, translucent.
    pub volume: Rgba,
    /// Edges of the view volume.
    pub volume_edge: Rgba,
    /// Body of the camera.
    pub body: Rgba,
    /// Edges of the camera's body.
    pub body_edge: Rgba,
    /// VUP.
    pub view_up: Rgba,
    /// Direction of projection and focal point.
    pub aim: Rgba,
    /// Marks and rays of the probe.
    pub probe: Rgba,
    /// The camera before an operation.
    pub ghost: Rgba,
    /// The colour of pixels without a depth.
    pub nothing: Rgba,
    /// Parts outside the view volume, as glass.
    pub outside: Rgba,
    /// Objects dropped whole, as glass.
    pub dropped: Rgba,
    /// Faces that turn their back to the camera.
    pub back: Rgba,
    /// Vertices that clipping makes, and the edges between them.
    pub cut: Rgba,
    /// Parts wrong on purpose.
    pub wrong: Rgba,
    /// Pixels in which two sides of a comparison differ.
    pub differing: Rgba,
}

impl Palette {
    /// The colours of a theme.
    pub fn of(theme: Theme) -> Self {
        let pick = |colors| theme.color(colors);
        Self {
            paper: pick([0xfa_fb_fc, 0x16_1a_20, 0xff_ff_ff]),
            surround: pick([0xe2_e6_ea, 0x0b_0d_10, 0xff_ff_ff]),
            ink: pick([0x1c_21_28, 0xe9_ec_ef, 0x00_00_00]),
            soft: pick([0x5b_64_70, 0x9a_a4_b0, 0x4a_4a_4a]),
            grid: pick([0xd3_d9_e0, 0x30_38_42, 0xcc_cc_cc]),
            axes: [
                pick([0xb8_43_00, 0xff_8f_57, 0xa3_3a_00]),
                pick([0x00_78_5a, 0x3f_ca_a2, 0x00_69_4f]),
                pick([0x00_67_a5, 0x6f_b8_f5, 0x00_5a_91]),
            ],
            volume: pick([0xe6_9f_00, 0xf5_b9_42, 0x00_00_00]).with_alpha([18, 17, 9][theme as usize]),
            volume_edge: pick([0x8a_5a_00, 0xf5_b9_42, 0x33_33_33]),
            body: pick([0x8c_98_a6, 0x9a_a4_b0, 0xd8_d8_d8]),
            body_edge: pick([0x1c_21_28, 0x0b_0d_10, 0x00_00_00]),
            view_up: pick([0xa0_3d_78, 0xe7_9c_c6, 0x8c_2f_66]),
            aim: pick([0x1c_21_28, 0xe9_ec_ef, 0x00_00_00]),
            probe: pick([0xb0_00_5e, 0xff_7a_c6, 0x90_00_50]),
            ghost: pick([0x5b_64_70, 0x9a_a4_b0, 0x4a_4a_4a]),
            nothing: pick([0xb9_d3_ee, 0x1c_36_54, 0xb9_d3_ee]),
            outside: pick([0xb0_00_9a, 0xff_5a_e0, 0x90_00_80]).with_alpha([105, 95, 150][theme as usize]),
            dropped: pick([0x4a_52_5c, 0xb4_bd_c8, 0x33_33_33]).with_alpha([110, 90, 100][theme as usize]),
            back: pick([0xb3_9d_f0, 0xb9_a2_ff, 0xdd_d4_ff]),
            cut: pick([0xb0_00_5e, 0xff_7a_c6, 0x90_00_50]),
            wrong: pick([0xc4_1e_1e, 0xff_6b_60, 0xb0_10_10]),
            differing: pick([0xd6_00_7f, 0xff_4f_c3, 0x00_00_00]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_has_enough_contrast_on_the_paper() {
        for theme in [Theme::Light, Theme::Dark, Theme::Print] {
            let p = Palette::of(theme);
            let [x, y, z] = p.axes;
            for c in [p.ink, p.soft, x, y, z, p.volume_edge, p.view_up, p.aim, p.probe, p.ghost, p.cut, p.wrong] {
                assert!(c.contrast(p.paper) >= 4.5, "{theme:?} {c}: {:.2}", c.contrast(p.paper));
            }
        }
    }

    #[test]
    fn on_paper_the_tints_differ_in_grey() {
        let p = Palette::of(Theme::Print);
        let grey = |c: Rgba| {
            let share = f64::from(c.a) / 255.0;
            let over = |own: u8, ground: u8| f64::from(own) * share + f64::from(ground) * (1.0 - share);
            0.299 * over(c.r, p.paper.r) + 0.587 * over(c.g, p.paper.g) + 0.114 * over(c.b, p.paper.b)
        };
        let mut greys = [p.paper, p.back, p.dropped, p.outside, p.wrong].map(grey);
        greys.sort_by(f64::total_cmp);
        assert!(greys.windows(2).all(|pair| pair[1] - pair[0] > 25.0), "{greys:?}");
    }

    #[test]
    fn the_grid_stays_behind() {
        for theme in [Theme::Light, Theme::Dark, Theme::Print] {
            let p = Palette::of(theme);
            let c = p.grid.contrast(p.paper);
            assert!((1.2..2.0).contains(&c), "{theme:?}: {c:.2}");
        }
    }
}
