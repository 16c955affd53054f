//! The image: the scene as the figure's camera sees it, with the aspect of the view window.

use crate::appearance::{Dash, HiddenLines, Rgba, Style, Visibility};
use crate::camera::ViewWindow;
use crate::drawing::{Drawing, Paint, StrokeSet, Surface};
use crate::figure::Reveal;
use crate::pipeline::{Frame, Reason, Stage, Target};
use crate::scene::Scene;

use super::depth::{self, Greys};
use super::gizmos::{Sheet, stroke};
use super::screen::Screen;
use super::{Engine, Palette, Request, Size, placing, probe, reveal};

/// A rectangle of a picture, in pixels; (0, 0) is the top left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelRect {
    /// Left.
    pub x: u32,
    /// Top.
    pub y: u32,
    /// Width, at least 1 in a picture that is not empty.
    pub width: u32,
    /// Height, at least 1 in a picture that is not empty.
    pub height: u32,
}

impl PixelRect {
    /// All of a picture.
    pub(super) fn whole(size: Size) -> Self {
        Self { x: 0, y: 0, width: size.width, height: size.height }
    }
}

/// Where the image lies in a picture of this size: the largest rectangle with the window's aspect (to the nearest pixel), in
/// the middle.
#[must_use]
pub fn frame(size: Size, window: ViewWindow) -> PixelRect {
    let aspect = window.aspect();
    let width = rounded(f64::from(size.height) * aspect, size.width);
    let height = rounded(f64::from(size.width) / aspect, size.height);
    PixelRect { x: (size.width - width) / 2, y: (size.height - height) / 2, width, height }
}

/// The nearest whole number of pixels, 1 … `most`.
fn rounded(pixels: f64, most: u32) -> u32 {
    let bounded = pixels.round().clamp(1.0_f64.min(f64::from(most)), f64::from(most));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number in 0 … most")]
    let whole = bounded as u32;
    whole
}

/// The camera and the pixels that its window fills.
pub(super) fn screen(request: &Request) -> Screen {
    Screen::new(request.camera.clone(), frame(request.size, request.camera.window()), request.size.scale)
}

/// Draws the image.
pub(super) fn frame_of(request: &Request, engine: &mut Engine) -> Frame {
    let style = &request.look.style;
    let palette = Palette::of(style.theme);
    let greys = Greys::of(request);
    let paper = if greys.is_some() { palette.nothing } else { palette.paper };
    let style = match (greys, request.look.reveal.divide_first) {
        (Some(_), _) => depth::style(style),
        // What is wrong is drawn for itself, and only a depth buffer brings both together.
        (None, true) => Style { visibility: Visibility::DepthBuffer, ..*style },
        (None, false) => *style,
    };
    let (whole, screen) = (request.size.target(paper), screen(request));
    let rect = frame(request.size, request.camera.window());
    let target = Target { width: rect.width, height: rect.height, ..whole };
    // A scene of many objects is not copied where nothing is added to it.
    let plain = request.look.reveal == Reveal::default() && request.overlays.probe.is_none();
    let (revealed, wrong) = if plain { Default::default() } else { reveal::in_image(request, palette) };
    let mut drawn = if plain {
        engine.frame(request, &request.scene, &request.camera, target, &style)
    } else {
        let mut sheet = Sheet { scene: revealed.scene.clone(), screen: &screen, hidden: style.hidden_lines };
        if greys.is_some() {
            depth::only(&mut sheet.scene);
        }
        revealed.mark(&mut sheet, palette);
        probe::in_image(&mut sheet, request, palette);
        engine.frame(request, &sheet.scene, &request.camera, target, &style)
    };
    // Where nothing is behind the eye, dividing first makes no difference, and clipping did its work as ever.
    let wrong = wrong.filter(|wrong| *wrong != Scene { lights: wrong.lights.clone(), ..Scene::default() });
    if let Some((wrong, front)) = wrong.zip(reveal::front()) {
        drawn.say(Stage::Clip, Reason::DividedFirst);
        add(&mut drawn.drawing, Engine::default().frame(request, &wrong, &front, target, &style).drawing);
    }
    let mut rows = revealed.rows;
    if let Some(greys) = greys {
        greys.paint(&mut drawn);
        rows.extend(greys.legend(request, palette));
    }
    placing::settle(&mut drawn.drawing, &[], None);
    if rect != PixelRect::whole(request.size) {
        drawn.drawing = mounted(drawn.drawing, rect, request.size, palette);
    }
    reveal::explain(&mut drawn.drawing, reveal::legend(request, rows, &whole, palette).as_ref());
    drawn
}

/// Adds what another drawing shows in the same place, with the same depths.
fn add(drawing: &mut Drawing, more: Drawing) {
    drawing.surfaces.extend(more.surfaces);
    drawing.surfaces.iter_mut().for_each(|surface| surface.depth_test = true);
    drawing.strokes.extend(more.strokes);
    drawing.marks.extend(more.marks);
}

/// The image in the middle of a larger picture, with a thin border.
fn mounted(mut image: Drawing, rect: PixelRect, size: Size, palette: Palette) -> Drawing {
    #[expect(clippy::cast_precision_loss, reason = "pixels")]
    let [x, y, w, h] = [rect.x, rect.y, rect.width, rect.height].map(|v| v as f32);
    let shift = |p: &mut [f32; 3]| {
        p[0] += x;
        p[1] += y;
    };
    image.surfaces.iter_mut().flat_map(|s| &mut s.positions).for_each(shift);
    image.strokes.iter_mut().flat_map(|s| &mut s.points).for_each(shift);
    image.areas.iter_mut().for_each(|area| area.corner = [area.corner[0] + x, area.corner[1] + y]);
    image.marks.iter_mut().for_each(|m| shift(&mut m.position));
    image.labels.iter_mut().for_each(|l| shift(&mut l.position));
    image.surfaces.insert(0, sheet_of_paper([x, y, w, h], image.background));
    let half = 0.5 * size.scale;
    let corner = |dx: f32, dy: f32| [x + dx * w + half * (2.0 * dx - 1.0), y + dy * h + half * (2.0 * dy - 1.0), 1.0];
    image.strokes.push(StrokeSet {
        points: vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0), corner(0.0, 0.0)],
        polylines: std::iter::once(0..5).collect(),
        style: stroke(palette.soft, size.scale, Dash::Solid, HiddenLines::Shown),
    });
    Drawing { width: size.width, height: size.height, background: palette.surround, ..image }
}

/// A rectangle behind everything.
fn sheet_of_paper([x, y, w, h]: [f32; 4], color: Rgba) -> Surface {
    Surface {
        positions: vec![[x, y, 0.0], [x + w, y, 0.0], [x + w, y + h, 0.0], [x, y + h, 0.0]],
        inverse_w: Vec::new(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        paint: Paint::Solid(color),
        translucent: false,
        depth_test: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size(width: u32, height: u32) -> Size {
        Size { width, height, scale: 1.0 }
    }

    fn window(aspect: f64) -> ViewWindow {
        ViewWindow { left: -aspect, right: aspect, bottom: -1.0, top: 1.0 }
    }

    #[test]
    fn the_frame_has_the_windows_aspect_and_lies_in_the_middle() {
        let rect = |x, y, width, height| PixelRect { x, y, width, height };
        assert_eq!(frame(size(400, 300), window(4.0 / 3.0)), rect(0, 0, 400, 300));
        assert_eq!(frame(size(400, 300), window(1.0)), rect(50, 0, 300, 300));
        assert_eq!(frame(size(400, 300), window(2.0)), rect(0, 50, 400, 200));
        assert_eq!(frame(size(401, 300), window(0.5)), rect(125, 0, 150, 300));
    }

    #[test]
    fn an_extreme_window_still_has_a_frame() {
        for aspect in [1e-12, 1e12] {
            let f = frame(size(400, 300), window(aspect));
            assert!(f.width >= 1 && f.height >= 1 && f.x + f.width <= 400 && f.y + f.height <= 300, "{f:?}");
        }
        assert_eq!(frame(size(0, 0), window(1.0)), PixelRect { x: 0, y: 0, width: 0, height: 0 });
    }
}
