//! The image tinted with the cost of its pixels (`[reveal] cost`).

use std::sync::Arc;

use crate::appearance::{Filter, Rgba, Sampler, Texture};
use crate::drawing::{Base, Surface};
use crate::figure::CostReveal;
use crate::pipeline::Frame;
use crate::views::words::legend::{LegendRow, LegendText};
use crate::views::{Palette, Request};

/// The colours of a scale, from nothing to the greatest value: viridis, whose lightness grows evenly.
const COLORS: [[u8; 3]; 5] = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/// The place of a value on its scale, 0 … 1. Rounding and errors are mostly far below their greatest value, so their
/// scale shows roots.
fn share(of: CostReveal, value: f64) -> f64 {
    match of {
        CostReveal::Overdraw | CostReveal::Operations => value,
        CostReveal::Rounding | CostReveal::Error => value.sqrt(),
    }
}

fn color(share: f64) -> Rgba {
    let at = share.clamp(0.0, 1.0) * (COLORS.len() - 1) as f64;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place among the colours")]
    let below = (at as usize).min(COLORS.len() - 2);
    let mix = |k: usize| {
        let [a, b] = [0, 1].map(|next| f64::from(COLORS[below + next][k]));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 … 255")]
        let byte = (a + (at - below as f64) * (b - a)).round() as u8;
        byte
    };
    Rgba::rgb(mix(0), mix(1), mix(2))
}

/// The legend: the meaning, the scale with its numbers, and the needless fills.
pub(super) fn rows(request: &Request, palette: Palette) -> Vec<LegendRow> {
    const STEPS: u32 = 40;
    let labels = request.labels;
    let (Some(of), Some(map)) = (request.shot.look.reveal.cost, &request.cost) else { return Vec::new() };
    let title = |name: &str, text: String| LegendRow::Title(LegendText::new(name, text), palette.ink);
    let mut rows = vec![title("cost", labels.costs[1 + of as usize].to_owned())];
    if map.values.is_empty() {
        rows.push(title("cost-of-rays", labels.too_much_for_rays.to_owned()));
        return rows;
    }
    let greatest = f64::from(map.greatest());
    // In the middle of a scale of roots, there's a quarter.
    let middle = if share(of, 0.25) == 0.5 { 0.25 } else { 0.5 };
    let numbers = [0.0, middle, 1.0].map(|part| labels.mark.number(part * greatest, 3));
    let colors = (0..=STEPS).map(|step| color(f64::from(step) / f64::from(STEPS))).collect();
    rows.push(LegendRow::Scale(colors, vec![LegendText::below_a_scale("cost", numbers)]));
    if of == CostReveal::Overdraw {
        let (now, best) = map.painted_over;
        let percent = |name: &str, share: f64| format!("{name} {} %", labels.mark.number(100.0 * share, 2));
        let best = best.map(|best| format!(", {}", percent(labels.from_front, best))).unwrap_or_default();
        rows.push(title("painted-over", percent(labels.painted_over, now) + &best));
    }
    rows
}

/// Lays the tint over the faces, under all lines. No stage counts it.
pub(super) fn tint(frame: &mut Frame, request: &Request) {
    let (Some(of), Some(map)) = (request.shot.look.reveal.cost, &request.cost) else { return };
    let greatest = f64::from(map.greatest());
    let [width, height] = map.size;
    let texel = |&value: &f32| {
        if value <= 0.0 {
            return [0; 4];
        }
        let Rgba { r, g, b, .. } = color(share(of, f64::from(value) / greatest));
        [r, g, b, 255]
    };
    let image = Texture::flat(width, height, map.values.iter().flat_map(texel).collect());
    let [w, h] = [frame.drawing.width, frame.drawing.height].map(|side| side as f32);
    let corners = vec![[0.0, 0.0, 0.0], [w, 0.0, 0.0], [w, h, 0.0], [0.0, h, 0.0]];
    let base = Base::Texture {
        image: Arc::new(image),
        sampler: Sampler { filter: Filter::Nearest, ..Sampler::PICTURE },
        uv: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        tint: Rgba::rgb(255, 255, 255),
        tints: Vec::new(),
    };
    let plain = Surface::solid(corners, vec![[0, 1, 2], [0, 2, 3]], Rgba::rgb(255, 255, 255));
    frame.dropped_faces.push(Surface { base, translucent: true, depth_test: false, ..plain });
}
