//! The photograph under the scene, which fills the image.

use std::sync::Arc;

use crate::appearance::{Filter, Rgba, Sampler};
use crate::drawing::{Base, Drawing, Surface};
use crate::views::Request;

/// Puts the photograph of the figure behind everything else in drawings of its image, with its opacity. Images of other
/// cameras don't have it, because the figure's own camera took it.
pub(super) fn under<'a>(drawings: impl Iterator<Item = &'a mut Drawing>, request: &Request) {
    let share = request.shot.look.photograph_opacity;
    #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
    let opacity = (255.0 * share.clamp(0.0, 1.0)).round() as u8;
    let Some(image) = request.scene.photograph.as_ref().filter(|_| opacity > 0 && request.projector.is_none()) else {
        return;
    };
    for drawing in drawings {
        let [w, h] = [drawing.width, drawing.height].map(|side| side as f32);
        // On the back plane, the farthest place of all.
        let corners = vec![[0.0, 0.0, 0.0], [w, 0.0, 0.0], [w, h, 0.0], [0.0, h, 0.0]];
        let base = Base::Texture {
            image: Arc::clone(image),
            sampler: Sampler { filter: Filter::Trilinear, ..Sampler::PICTURE },
            uv: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            tint: Rgba::rgba(255, 255, 255, opacity),
        };
        let translucent = opacity < 255 || !image.is_opaque();
        if translucent && !drawing.painted_in_order {
            // Translucent surfaces come after opaque ones, and only depths keep the photograph behind.
            drawing.surfaces.iter_mut().filter(|s| !s.translucent).for_each(|s| s.depth_test = true);
        }
        let triangles = vec![[0, 1, 2], [0, 2, 3]];
        let plain = Surface::solid(corners, triangles, Rgba::rgb(255, 255, 255));
        drawing.surfaces.insert(0, Surface { base, translucent, depth_test: translucent, ..plain });
    }
}
