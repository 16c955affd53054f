//! Three arrows in the world by which what is selected is moved, one along each axis.

use glam::{DVec2, DVec3};

use crate::appearance::{Dash, HiddenLines, LineStyle, MarkShape};
use crate::scene::Line;

use super::gizmos::{SMALL_TYPE, SceneBuilder};
use super::handles::Grip;
use super::screen::Screen;
use super::{Arrows, Palette, Request, world_framing};

/// The tips of the arrows (world). Their length is fixed on the screen.
fn tips(arrows: &Arrows, screen: &Screen) -> [DVec3; 3] {
    let (side, scale) = (screen.extent().min_element(), screen.scale());
    let length = screen.units_per_pixel(arrows.origin) * (0.15 * side).clamp(40.0 * scale, 120.0 * scale);
    arrows.axes.map(|axis| arrows.origin + axis * length)
}

/// The arrow at `pointer` (pixels), within `reach` pixels: near its tip, or on its outer half. None of those that are seen
/// end-on, because they cannot be dragged.
#[must_use]
pub fn arrow_at(request: &Request, pointer: DVec2, reach: f64) -> Option<usize> {
    let arrows = request.overlays.arrows?;
    let screen = world_framing::screen(request)?;
    let from = screen.place(arrows.origin)?;
    let distance = |tip: DVec3| {
        let to = screen.place(tip)?;
        let way = to - from;
        if way.length() < 1.5 * reach {
            return None;
        }
        let t = ((pointer - from).dot(way) / way.length_squared()).clamp(0.4, 1.0);
        Some(pointer.distance(from + way * t))
    };
    let distances = tips(&arrows, &screen).map(distance);
    (0..3)
        .filter_map(|i| Some((i, distances[i].filter(|d| *d <= reach)?)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(i, _)| i)
}

/// How far (world) a thing goes along `axis` (a unit vector) of `origin` when the pointer goes from `from` to `to` (pixels), and
/// the length of a pixel there. `None` where the axis is seen end-on.
#[must_use]
pub fn pull(request: &Request, (origin, axis): (DVec3, DVec3), from: DVec2, to: DVec2) -> Option<(f64, f64)> {
    let screen = world_framing::screen(request)?;
    let observer = world_framing::seen_from(request);
    let grip = Grip { observer: &observer, from: screen.ray(from), to: screen.ray(to) };
    Some((grip.along(origin, axis)?, screen.units_per_pixel(origin)))
}

/// Adds the arrows, if there are any; nothing hides them.
pub(super) fn in_world(builder: &mut SceneBuilder, request: &Request, palette: Palette) {
    let Some(arrows) = request.overlays.arrows else { return };
    let tips = tips(&arrows, builder.screen);
    for (i, ((tip, color), name)) in tips.into_iter().zip(palette.axes).zip(["x", "y", "z"]).enumerate() {
        let width = if arrows.hot == Some(i) { 4.5 } else { 2.5 };
        let style = LineStyle { color, width, dash: Dash::Solid, hidden: HiddenLines::Shown, arrow: true };
        builder.scene.lines.push(Line { points: vec![arrows.origin, tip], style });
        let toward = builder.screen.heading(arrows.origin, arrows.axes[i]);
        builder.text(tip, name, toward, SMALL_TYPE, color);
    }
    builder.mark_above(arrows.origin, MarkShape::Disc, 3.0, palette.ink);
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::{Camera, Parameters};
    use crate::figure::Figure;
    use crate::figure::Observer;
    use crate::i18n::{Lang, pictures};
    use crate::views::{Overlays, SharedScene, Size, View};

    #[test]
    fn an_arrow_is_found_at_its_tip_and_a_pull_moves_what_it_stands_on_under_the_pointer() {
        let observer = Observer {
            target: DVec3::ZERO,
            distance: 30.0,
            azimuth: 40.0,
            elevation: 25.0,
            roll: 0.0,
            parallel: false,
        };
        let origin = DVec3::new(1.0, 0.5, -1.0);
        let axes = [DVec3::X, DVec3::Y, DVec3::new(0.6, 0.0, 0.8)];
        let arrows = Arrows { origin, axes, hot: None };
        let (figure, camera) = (Figure::default(), Camera::new(&Parameters::default()).unwrap());
        let size = Size { width: 600, height: 400, scale: 1.0 };
        let scene = SharedScene::default();
        let request = Request {
            observer: Some(observer),
            overlays: Overlays { arrows: Some(arrows), ..Overlays::default() },
            ..Request::of(&figure, View::World, &camera, &scene, pictures::labels(Lang::En), size)
        };
        let screen = world_framing::screen(&request).unwrap();
        let tips = tips(&arrows, &screen);
        for (i, tip) in tips.into_iter().enumerate() {
            let place = screen.place(tip).unwrap();
            assert_eq!(arrow_at(&request, place + 1.0, 8.0), Some(i));
            let goal = screen.place(tip + axes[i] * 1.75).unwrap();
            // Taken at its tip, the arrow's line stays under the pointer.
            let (way, pixel) = pull(&request, (tip, axes[i]), place, goal).unwrap();
            assert!((way - 1.75).abs() < 1e-9 && pixel > 0.0, "{way}");
        }
        assert_eq!(arrow_at(&request, screen.place(origin).unwrap(), 4.0), None);
        let along_axis = Observer { azimuth: 90.0, elevation: 0.0, parallel: true, ..observer };
        let (from, to) = (DVec2::new(10.0, 10.0), DVec2::new(90.0, 10.0));
        assert_eq!(pull(&Request { observer: Some(along_axis), ..request }, (origin, DVec3::X), from, to), None);
    }
}
