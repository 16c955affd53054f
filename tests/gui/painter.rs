//! A small renderer for egui's triangles, so that whole windows can be compared without a graphics card.
//!
//! Integer edge functions at pixel centres with 8 sub-pixel bits and the top-left rule, as a graphics card does it.
//! Colours are blended in gamma space, as egui's own renderers do.

use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use eframe::egui::epaint::{ClippedPrimitive, Primitive, Vertex};
use eframe::egui::{self, Color32, ImageData, Mesh, Pos2, TextureFilter, TextureId, TextureOptions, TexturesDelta};
use image::RgbaImage;

/// The renderer.
#[derive(Default)]
pub(crate) struct Painter {
    textures: Textures,
}

/// The shapes and textures from egui, for tests to look at.
#[derive(Clone, Default)]
pub(crate) struct Textures(Rc<RefCell<HashMap<TextureId, Texture>>>);

struct Texture {
    size: [usize; 2],
    pixels: Vec<Color32>,
    options: TextureOptions,
}

impl Painter {
    /// The textures that it draws with.
    pub(crate) fn textures(&self) -> Textures {
        self.textures.clone()
    }
}

impl Textures {
    /// The pixels (premultiplied RGBA) of the only texture of this size in a frame.
    pub(crate) fn only(&self, size: [usize; 2], frame: &egui::FullOutput) -> Vec<u8> {
        let textures = self.0.borrow();
        let painted: HashSet<TextureId> = frame.shapes.iter().map(|clipped| clipped.shape.texture_id()).collect();
        let found: Vec<&Texture> = textures
            .iter()
            .filter(|(id, texture)| texture.size == size && painted.contains(*id))
            .map(|(_, texture)| texture)
            .collect();
        let [texture] = found[..] else { panic!("{} textures of {size:?}", found.len()) };
        texture.pixels.iter().flat_map(Color32::to_array).collect()
    }
}

impl egui_kittest::TestRenderer for Painter {
    #[expect(clippy::iter_over_hash_type, reason = "each texture is changed on its own, in any order")]
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        let mut textures = self.textures.0.borrow_mut();
        for (id, changes) in delta.set.drain() {
            for change in changes {
                let ImageData::Color(image) = &change.image;
                match change.pos {
                    None => {
                        let texture =
                            Texture { size: image.size, pixels: image.pixels.clone(), options: change.options };
                        textures.insert(id, texture);
                    }
                    Some([x, y]) => {
                        let texture = textures.get_mut(&id).expect("a patch for a texture that is there");
                        for row in 0..image.size[1] {
                            let to = (y + row) * texture.size[0] + x;
                            let from = row * image.size[0];
                            texture.pixels[to..to + image.size[0]]
                                .copy_from_slice(&image.pixels[from..from + image.size[0]]);
                        }
                    }
                }
            }
        }
        for id in delta.free.drain() {
            textures.remove(&id);
        }
    }

    fn render(&mut self, ctx: &egui::Context, output: &egui::FullOutput) -> Result<RgbaImage, String> {
        let textures = self.textures.0.borrow();
        let scale = output.pixels_per_point;
        let size = ctx.content_rect().size() * scale;
        // As a frame of the window begins.
        let ground = ctx.global_style().visuals.panel_fill;
        let mut image =
            RgbaImage::from_pixel(size.x.round() as u32, size.y.round() as u32, image::Rgba(ground.to_array()));
        for ClippedPrimitive { clip_rect, primitive } in ctx.tessellate(output.shapes.clone(), scale) {
            let Primitive::Mesh(mesh) = primitive else { return Err("a paint callback".to_owned()) };
            let texture = textures.get(&mesh.texture_id).ok_or("an unknown texture")?;
            let clip = [
                (clip_rect.min.x * scale).round().max(0.0) as i64,
                (clip_rect.min.y * scale).round().max(0.0) as i64,
                ((clip_rect.max.x * scale).round() as i64).min(i64::from(image.width())),
                ((clip_rect.max.y * scale).round() as i64).min(i64::from(image.height())),
            ];
            paint_mesh(&mut image, &mesh, texture, clip, scale);
        }
        Ok(image)
    }
}

fn paint_mesh(image: &mut RgbaImage, mesh: &Mesh, texture: &Texture, clip: [i64; 4], scale: f32) {
    for corners in mesh.indices.chunks_exact(3) {
        let corners = [0, 1, 2].map(|i| mesh.vertices[corners[i] as usize]);
        paint_triangle(image, corners, texture, clip, scale);
    }
}

/// A point in 256ths of a pixel.
fn fixed(p: Pos2, scale: f32) -> [i64; 2] {
    [
        (f64::from(p.x) * f64::from(scale) * 256.0).round() as i64,
        (f64::from(p.y) * f64::from(scale) * 256.0).round() as i64,
    ]
}

/// Twice the area of a, b, p, positive if p is on the inner side of a → b.
fn edge(a: [i64; 2], b: [i64; 2], p: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

fn paint_triangle(image: &mut RgbaImage, mut v: [Vertex; 3], texture: &Texture, clip: [i64; 4], scale: f32) {
    let mut p = v.map(|v| fixed(v.pos, scale));
    let mut area = edge(p[0], p[1], p[2]);
    if area == 0 {
        return;
    }
    if area < 0 {
        v.swap(1, 2);
        p.swap(1, 2);
        area = -area;
    }
    let bound = |axis: usize| {
        let all = p.map(|p| p[axis]);
        let (least, most) = (all[0].min(all[1]).min(all[2]), all[0].max(all[1]).max(all[2]));
        (least.div_euclid(256).max(clip[axis]), (most.div_euclid(256) + 1).min(clip[axis + 2]))
    };
    let ((x0, x1), (y0, y1)) = (bound(0), bound(1));
    // With y down and this winding, a top edge goes to the right and a left edge goes up.
    let owned = |a: [i64; 2], b: [i64; 2]| (a[1] == b[1] && b[0] > a[0]) || b[1] < a[1];
    let edges = [(p[1], p[2]), (p[2], p[0]), (p[0], p[1])];
    let bias = edges.map(|(a, b)| if owned(a, b) { 0 } else { -1 });
    for y in y0..y1 {
        for x in x0..x1 {
            let center = [x * 256 + 128, y * 256 + 128];
            let w = [0, 1, 2].map(|i| edge(edges[i].0, edges[i].1, center));
            if (0..3).all(|i| w[i] + bias[i] >= 0) {
                let share = w.map(|w| w as f32 / area as f32);
                shade(image, x as u32, y as u32, &v, share, texture);
            }
        }
    }
}

fn shade(image: &mut RgbaImage, x: u32, y: u32, v: &[Vertex; 3], share: [f32; 3], texture: &Texture) {
    let mix = |get: &dyn Fn(&Vertex) -> f32| (0..3).map(|i| get(&v[i]) * share[i]).sum::<f32>();
    let texel = sample(texture, mix(&|v| v.uv.x), mix(&|v| v.uv.y));
    let color: [f32; 4] = std::array::from_fn(|c| mix(&|v| f32::from(v.color.to_array()[c])) / 255.0 * texel[c]);
    let pixel = image.get_pixel_mut(x, y);
    for (channel, c) in pixel.0.iter_mut().zip(color) {
        let below = f32::from(*channel) / 255.0 * (1.0 - color[3]);
        *channel = ((c + below) * 255.0).round().clamp(0.0, 255.0) as u8;
    }
}

/// The texture at (u, v), 0 … 1 a channel.
fn sample(texture: &Texture, u: f32, v: f32) -> [f32; 4] {
    let [width, height] = texture.size;
    let texel = |x: i64, y: i64| {
        let x = x.clamp(0, width as i64 - 1) as usize;
        let y = y.clamp(0, height as i64 - 1) as usize;
        texture.pixels[y * width + x].to_array().map(|c| f32::from(c) / 255.0)
    };
    let (x, y) = (u * width as f32, v * height as f32);
    if texture.options.magnification == TextureFilter::Nearest {
        return texel(x.floor() as i64, y.floor() as i64);
    }
    let (x, y) = (x - 0.5, y - 0.5);
    let (fx, fy) = (x - x.floor(), y - y.floor());
    let (x, y) = (x.floor() as i64, y.floor() as i64);
    let corners = [texel(x, y), texel(x + 1, y), texel(x, y + 1), texel(x + 1, y + 1)];
    std::array::from_fn(|c| {
        let top = corners[0][c] * (1.0 - fx) + corners[1][c] * fx;
        let bottom = corners[2][c] * (1.0 - fx) + corners[3][c] * fx;
        top * (1.0 - fy) + bottom * fy
    })
}
