//! A picture on the screen: its textures, and the places of its pixels.

use std::sync::Arc;

use eframe::egui::{Color32, ColorImage, Context, Pos2, Rect, TextureHandle, TextureOptions, Ui, Vec2, pos2, vec2};
use glam::DVec2;

use crate::views;

/// One pixel of a picture is one pixel of the screen.
const OPTIONS: TextureOptions = TextureOptions::NEAREST;

/// The place of a picture: its corner on a whole pixel, its sides whole pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PictureRect {
    /// In points.
    pub(super) rect: Rect,
    /// In pixels.
    pub(super) size: views::Size,
    pixels_per_point: f32,
}

impl PictureRect {
    /// The largest in `room` (points).
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "sides of a screen: clamped to 0 … 16384 before the cast"
    )]
    pub(super) fn in_room(room: Rect, pixels_per_point: f32, stroke_scale: f32) -> Self {
        let (min, max) = (room.min.to_vec2() * pixels_per_point, room.max.to_vec2() * pixels_per_point);
        let (min, max) = (min.ceil(), max.floor());
        let side = |length: f32| length.clamp(0.0, 16_384.0) as u32;
        let size = views::Size {
            width: side(max.x - min.x),
            height: side(max.y - min.y),
            scale: pixels_per_point * stroke_scale,
        };
        let corner = (min / pixels_per_point).to_pos2();
        let rect = Rect::from_min_size(corner, (max - min).max(Vec2::ZERO) / pixels_per_point);
        Self { rect, size, pixels_per_point }
    }

    /// Width and height in pixels.
    fn sides(&self) -> [usize; 2] {
        [self.size.width as usize, self.size.height as usize]
    }

    /// A point of the screen in the picture's pixels.
    pub(super) fn pixel(&self, point: Pos2) -> DVec2 {
        let p = (point - self.rect.min) * self.pixels_per_point;
        DVec2::new(f64::from(p.x), f64::from(p.y))
    }

    /// A rectangle of the picture (pixels) on the screen.
    pub(super) fn rect_of(&self, x: f32, y: f32, width: f32, height: f32) -> Rect {
        let min = self.rect.min + vec2(x, y) / self.pixels_per_point;
        Rect::from_min_size(min, vec2(width, height) / self.pixels_per_point)
    }

    /// Points of the screen as pixels.
    pub(super) fn pixels(&self, points: f32) -> f64 {
        f64::from(points * self.pixels_per_point)
    }
}

/// A picture in tiles no larger than a texture may be.
#[derive(Clone)]
pub(super) struct TextureTiles {
    /// Width and height in pixels.
    pub(super) size: [usize; 2],
    tiles: Vec<TextureTile>,
}

/// A part of a picture.
#[derive(Clone)]
struct TextureTile {
    /// Left and top in the picture, in pixels.
    place: [usize; 2],
    image: Arc<ColorImage>,
    /// The pixels that another image needs to become this one, and that image.
    since: Option<(Arc<ColorImage>, ChangedTiles)>,
}

impl TextureTiles {
    /// Cuts a picture into tiles.
    pub(super) fn of(picture: &crate::picture::Pixels, max_side: usize) -> Self {
        Self::cut([picture.width() as usize, picture.height() as usize], picture.rgba(), max_side)
    }

    /// Cuts premultiplied RGBA into tiles.
    fn cut([width, height]: [usize; 2], rgba: &[u8], max_side: usize) -> Self {
        let side = max_side.max(1);
        let mut tiles = Vec::new();
        for top in (0..height).step_by(side) {
            for left in (0..width).step_by(side) {
                let (w, h) = (side.min(width - left), side.min(height - top));
                let image = if w == width {
                    ColorImage::from_rgba_premultiplied([w, h], &rgba[4 * width * top..4 * width * (top + h)])
                } else {
                    let mut part = Vec::with_capacity(4 * w * h);
                    for y in top..top + h {
                        let start = 4 * (y * width + left);
                        part.extend_from_slice(&rgba[start..start + 4 * w]);
                    }
                    ColorImage::from_rgba_premultiplied([w, h], &part)
                };
                tiles.push(TextureTile { place: [left, top], image: Arc::new(image), since: None });
            }
        }
        Self { size: [width, height], tiles }
    }

    /// Its images, tile by tile.
    pub(super) fn images(&self) -> Vec<Arc<ColorImage>> {
        self.tiles.iter().map(|tile| Arc::clone(&tile.image)).collect()
    }

    /// The same with its difference from the images of another picture, which is probably the one on the screen. The
    /// thread that draws the picture has more time than the one that shows it.
    pub(super) fn since(mut self, images: &[Arc<ColorImage>]) -> Self {
        for (tile, image) in self.tiles.iter_mut().zip(images) {
            tile.since = Some((Arc::clone(image), ChangedTiles::between(image, &tile.image)));
        }
        self
    }
}

/// The newest finished picture, as textures.
#[derive(Default)]
pub(super) struct PictureTexture {
    size: [usize; 2],
    tiles: Vec<PlacedTile>,
    /// The last drawing failed.
    failed: bool,
    /// A picture that fades over this one.
    fading: Option<Fading>,
}

/// A tile of a picture on the screen.
struct PlacedTile {
    /// Its place in the picture, in pixels.
    place: [usize; 2],
    /// The pixels that the texture has.
    image: Arc<ColorImage>,
    texture: TextureHandle,
}

impl PlacedTile {
    /// Shows another tile. Only the changed pixels go to the texture, since uploading them costs as much as drawing
    /// them.
    fn show(&mut self, TextureTile { place, image, since }: TextureTile) {
        self.place = place;
        let changed = match since {
            Some((from, changed)) if Arc::ptr_eq(&from, &self.image) => changed,
            _ => ChangedTiles::between(&self.image, &image),
        };
        match changed {
            ChangedTiles::Nothing => {}
            ChangedTiles::Part { corner, pixels } => self.texture.set_partial(corner, pixels, OPTIONS),
            ChangedTiles::All => self.texture.set(Arc::clone(&image), OPTIONS),
        }
        self.image = image;
    }
}

/// The difference between two pictures.
#[derive(Clone, Debug, PartialEq)]
enum ChangedTiles {
    Nothing,
    /// No change outside a rectangle. Holds its upper left corner, and its pixels.
    Part {
        corner: [usize; 2],
        pixels: Arc<ColorImage>,
    },
    /// Another size, or most of the pixels.
    All,
}

impl ChangedTiles {
    fn between(from: &ColorImage, to: &ColorImage) -> Self {
        let [width, height] = to.size;
        if from.size != to.size || width == 0 {
            return Self::All;
        }
        let rows = || from.pixels.chunks_exact(width).zip(to.pixels.chunks_exact(width));
        let differ = |(old, new): (&[Color32], &[Color32])| old != new;
        let (Some(top), Some(bottom)) = (rows().position(differ), rows().rposition(differ)) else {
            return Self::Nothing;
        };
        let (mut left, mut right) = (width, 0);
        for (old, new) in rows().take(bottom + 1).skip(top) {
            // Of each row only the ends beyond those known to differ.
            let at_left = old.iter().zip(new).take(left).position(|(old, new)| old != new);
            left = at_left.unwrap_or(left);
            let at_right = old.iter().zip(new).skip(right).rposition(|(old, new)| old != new);
            right = at_right.map_or(right, |at| right + at + 1);
        }
        let size = [right.saturating_sub(left), bottom + 1 - top];
        // A part is copied first, a whole picture isn't.
        if 4 * size[0] * size[1] > 3 * width * height {
            return Self::All;
        }
        Self::Part { corner: [left, top], pixels: Arc::new(to.region_by_pixels([left, top], size)) }
    }
}

/// The former picture, as it disappears.
struct Fading {
    size: [usize; 2],
    tiles: Vec<PlacedTile>,
    /// A time in seconds.
    began: f64,
}

impl PictureTexture {
    /// Takes a new picture. Reuses the textures if their number is the same.
    pub(super) fn set(&mut self, ctx: &Context, name: &str, picture: Option<TextureTiles>) {
        self.failed = picture.is_none();
        let Some(TextureTiles { size, tiles }) = picture else { return };
        self.size = size;
        self.tiles.truncate(tiles.len());
        for (i, tile) in tiles.into_iter().enumerate() {
            if let Some(placed) = self.tiles.get_mut(i) {
                placed.show(tile);
                continue;
            }
            let TextureTile { place, image, .. } = tile;
            let texture = ctx.load_texture(name, Arc::clone(&image), OPTIONS);
            self.tiles.push(PlacedTile { place, image, texture });
        }
    }

    /// Lets the displayed picture fade away over the next ones. `now` is a time in seconds.
    pub(super) fn fade(&mut self, now: f64) {
        self.fading = Some(Fading { size: self.size, tiles: std::mem::take(&mut self.tiles), began: now });
    }

    /// True if the last drawing failed.
    pub(super) fn failed(&self) -> bool {
        self.failed
    }

    /// True if the picture leaves nothing of its place free, so that content beneath it is invisible.
    pub(super) fn covers(&self, place: &PictureRect) -> bool {
        !self.tiles.is_empty() && self.size == place.sides()
    }

    /// Paints the picture at its place. If it has another size, because the next is still being drawn, it goes in the
    /// middle.
    pub(super) fn paint(&mut self, ui: &Ui, place: &PictureRect) {
        paint_tiles(ui, place, self.size, &self.tiles, Color32::WHITE);
        let Some(fading) = &self.fading else { return };
        let left = 1.0 - (ui.input(|input| input.time) - fading.began) / camera_lab_desk::FADE;
        let is_at_its_place = fading.size == place.sides();
        if left > 0.0 && is_at_its_place {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 … 255")]
            let tint = Color32::from_white_alpha((255.0 * left as f32).round() as u8);
            paint_tiles(ui, place, fading.size, &fading.tiles, tint);
            ui.ctx().request_repaint();
        } else {
            self.fading = None;
        }
    }
}

/// Paints the tiles of a picture at its place.
#[expect(clippy::cast_precision_loss, reason = "sides of a screen are far below 2²⁴")]
fn paint_tiles(ui: &Ui, place: &PictureRect, size: [usize; 2], tiles: &[PlacedTile], tint: Color32) {
    let painter = ui.painter().with_clip_rect(place.rect.intersect(ui.clip_rect()));
    let (width, height) = (size[0] as f32, size[1] as f32);
    let shift_x = ((place.size.width as f32 - width) / 2.0).round();
    let shift_y = ((place.size.height as f32 - height) / 2.0).round();
    let all = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    for PlacedTile { place: [left, top], image, texture } in tiles {
        let [w, h] = &image.size;
        let rect = place.rect_of(*left as f32 + shift_x, *top as f32 + shift_y, *w as f32, *h as f32);
        painter.image(texture.id(), rect, all, tint);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_hold_each_pixel_once_at_its_place() {
        let (width, height) = (7_u8, 5_u8);
        let rgba: Vec<u8> = (0..width * height).flat_map(|i| [i % width, i / width, 0, 255]).collect();
        for max_side in [2, 3, 5, 7, 100] {
            let TextureTiles { size, tiles } = TextureTiles::cut([7, 5], &rgba, max_side);
            assert_eq!(size, [7, 5]);
            let mut seen = [0; 35];
            for TextureTile { place: [left, top], image, .. } in &tiles {
                assert!(image.size[0] <= max_side && image.size[1] <= max_side);
                for (k, pixel) in image.pixels.iter().enumerate() {
                    let (x, y) = (left + k % image.size[0], top + k / image.size[0]);
                    assert_eq!((usize::from(pixel.r()), usize::from(pixel.g())), (x, y));
                    seen[y * 7 + x] += 1;
                }
            }
            assert!(seen.iter().all(|&n| n == 1));
        }
    }

    /// A grey picture with some black pixels.
    fn picture(size: [usize; 2], black: &[[usize; 2]]) -> ColorImage {
        let mut image = ColorImage::filled(size, Color32::GRAY);
        black.iter().for_each(|[x, y]| image.pixels[y * size[0] + x] = Color32::BLACK);
        image
    }

    #[test]
    fn a_change_is_the_smallest_rectangle_around_all_pixels_that_differ() {
        let grey = picture([40, 30], &[]);
        for (black, corner, size) in [
            (&[[7, 9]][..], [7, 9], [1, 1]),
            (&[[0, 0]][..], [0, 0], [1, 1]),
            (&[[39, 29]][..], [39, 29], [1, 1]),
            (&[[20, 5], [3, 6], [30, 7], [12, 20]][..], [3, 5], [28, 16]),
        ] {
            for [from, to] in [[&grey, &picture([40, 30], black)], [&picture([40, 30], black), &grey]] {
                let pixels = Arc::new(to.region_by_pixels(corner, size));
                assert_eq!(ChangedTiles::between(from, to), ChangedTiles::Part { corner, pixels });
            }
        }
        assert_eq!(ChangedTiles::between(&grey, &grey), ChangedTiles::Nothing);
        assert_eq!(ChangedTiles::between(&grey, &picture([40, 30], &[[0, 0], [39, 29]])), ChangedTiles::All);
        assert_eq!(ChangedTiles::between(&grey, &picture([30, 40], &[])), ChangedTiles::All);
        assert_eq!(ChangedTiles::between(&picture([0, 0], &[]), &picture([0, 0], &[])), ChangedTiles::All);
    }

    fn tiles(size: [usize; 2], black: &[[usize; 2]]) -> TextureTiles {
        TextureTiles {
            size,
            tiles: vec![TextureTile { place: [0, 0], image: Arc::new(picture(size, black)), since: None }],
        }
    }

    #[test]
    fn only_pixels_that_changed_go_to_the_texture() {
        let ctx = Context::default();
        let mut texture = PictureTexture::default();
        let size = [40, 30];
        let (mut last, foreign) = (Vec::new(), tiles(size, &[[8, 11]]).images());
        // A pixel of each: first the whole, then its successor by the difference from the last one, from another one,
        // or from none found before.
        for (black, since, expected) in [
            (&[[7, 9]][..], 0, Some((None, size))),
            (&[[7, 9]][..], 1, None),
            (&[[8, 11]][..], 1, Some((Some([7, 9]), [2, 3]))),
            (&[[0, 0], [39, 29]][..], 1, Some((None, size))),
            (&[[7, 9]][..], 2, Some((None, size))),
            (&[[8, 11]][..], 2, Some((Some([7, 9]), [2, 3]))),
            (&[[8, 12]][..], 0, Some((Some([8, 11]), [1, 2]))),
        ] {
            let tiles = tiles(size, black).since([&[], &last[..], &foreign[..]][since]);
            last = tiles.images();
            let mut output = ctx.run_ui(Default::default(), |ui| texture.set(ui.ctx(), "picture", Some(tiles.clone())));
            let id = texture.tiles[0].texture.id();
            let sent = output.textures_delta.set.iter().filter(|(of, _)| **of == id).flat_map(|(_, deltas)| deltas);
            let sent: Vec<_> = sent.map(|delta| (delta.pos, delta.image.size())).collect();
            assert_eq!(sent, Vec::from_iter(expected), "{black:?}");
            output.textures_delta.clear();
        }
    }

    #[test]
    fn a_picture_of_the_size_of_its_place_covers_it_and_no_other_does() {
        let mut texture = PictureTexture::default();
        let place = |width, height| {
            let room = Rect::from_min_size(pos2(10.0, 20.0), vec2(width, height));
            PictureRect::in_room(room, 1.0, 1.0)
        };
        assert!(!texture.covers(&place(40.0, 30.0)) && !texture.covers(&place(0.0, 0.0)));
        texture.set(&Context::default(), "picture", Some(tiles([40, 30], &[])));
        assert!(texture.covers(&place(40.0, 30.0)));
        assert!(!texture.covers(&place(40.0, 31.0)) && !texture.covers(&place(39.0, 30.0)));
    }

    #[test]
    fn pixels_of_a_picture_are_pixels_of_the_screen() {
        for (pixels_per_point, width) in [(1.0_f32, 199), (1.25, 249), (1.5, 299), (2.0, 399)] {
            let room = Rect::from_min_max(pos2(10.3, 20.7), pos2(210.1, 170.2));
            let place = PictureRect::in_room(room, pixels_per_point, 1.5);
            assert_eq!(place.size.width, width);
            assert_eq!(place.size.scale, 1.5 * pixels_per_point);
            assert!(room.contains_rect(place.rect));
            for side in [place.rect.left(), place.rect.top(), place.rect.right(), place.rect.bottom()] {
                let pixels = side * pixels_per_point;
                assert!((pixels - pixels.round()).abs() < 1e-3, "{side} at {pixels_per_point}");
            }
            let corner = place.rect_of(3.0, 4.0, 1.0, 1.0).center();
            assert!(place.pixel(corner).distance(DVec2::new(3.5, 4.5)) < 1e-3);
        }
    }

    #[test]
    fn a_room_without_height_has_a_picture_without_pixels() {
        let room = Rect::from_min_max(pos2(0.0, 50.0), pos2(100.0, 40.0));
        assert_eq!(PictureRect::in_room(room, 1.0, 1.0).size.height, 0);
    }
}
