//! The canonical volume: the scene after clipping and projection, in the cube \[−1, 1\]³.
//!
//! NDC is left-handed. The picture shows (x_n, y_n, −z_n), which is right-handed, so that with x_n to the right and y_n
//! up z_n goes into the screen, as in `[0]` Fig. 5.4. The mirror is in the display space, not in the numbers.

pub(super) mod canonical_box;
pub(super) mod normalizing;

use glam::{DVec2, DVec3};

use crate::appearance::{Dash, HiddenLines, Role};
use crate::camera::Basis;
use crate::figure::{Observer, Outside};
use crate::geometry::Aabb;
use crate::pipeline::canonical::displayed_ndc;
use crate::pipeline::{Frame, Scenes};
use crate::scene::Scene;

use super::observer::{Viewpoint, enclosing, on_side};
use super::pixels::PixelRect;
use super::screen::Screen;
use super::timed_pipeline::TimedPipeline;
use super::{Labels, Palette, Request};
use crate::views::canonical::canonical_box::CanonicalBox;
use crate::views::image::light_view;
use crate::views::reveal::{operation_path, probe, revealed_scene, triangle_overlay};
use crate::views::words::label_layout::{Author, Rules};
use crate::views::words::legend::LegendRow;
use crate::views::words::{author_labels, label_layout};
use crate::views::world::gizmos;
use crate::views::world::gizmos::{AnnotationBuilder, SMALL_TYPE};

/// The canonical volume.
pub(super) const CUBE: Aabb = Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE };
/// Length of the axes from the middle of the cube.
const AXIS: f64 = 1.42;
/// Size of the visible space around the cube if the outside is shown.
const BEYOND: f64 = 1.5;
const ISO: Observer = on_side(32.0, 20.0, false);

/// The camera's axes in the picture.
const VRC: Basis = Basis { u: DVec3::X, v: DVec3::Y, n: DVec3::Z };

/// The observer for a button. It looks from the viewpoint's side and has the cube in the picture.
pub(super) fn observer(request: &Request, viewpoint: Viewpoint) -> Observer {
    framing(request, viewpoint.direction(ISO, VRC))
}

/// The observer of several pictures, which has the box of each in the picture.
pub(super) fn common(requests: &[Request]) -> Option<Observer> {
    let points: Vec<_> = requests.iter().flat_map(Request::each_side).flat_map(|side| points(&side)).collect();
    Some(enclosing(&points, ISO, requests.first()?.size))
}

/// The observer that looks in a direction and has the cube in the picture.
pub(super) fn framing(request: &Request, direction: Observer) -> Observer {
    let sides = request.each_side();
    let points: Vec<_> = sides.iter().flat_map(points).collect();
    enclosing(&points, direction, sides.first().unwrap_or(request).size)
}

/// True if an observer has the box, and everything shown around it, in its picture. For a comparison, both boxes.
pub(super) fn holds(request: &Request, observer: &Observer) -> bool {
    request.each_side().iter().all(|side| super::observer::holds(observer, &points(side), side.size))
}

/// The corners of the box, as far as parts outside are shown around it, and the tips of its axes.
fn points(request: &Request) -> Vec<DVec3> {
    let canonical = CanonicalBox::of(request);
    let tips = canonical.axes().map(|axis| axis * (AXIS + 0.05));
    let beyond = match request.shot.look.reveal.outside {
        Outside::Usual | Outside::Cut => 1.0,
        Outside::Tinted | Outside::Shown => BEYOND,
    };
    let bounds = canonical.bounds();
    let middle = bounds.center();
    bounds.corners().map(|p| middle + (p - middle) * beyond).into_iter().chain(tips).collect()
}

/// The observer's camera and its pixels; `None` for an observer that isn't a camera.
pub(super) fn screen(request: &Request) -> Option<Screen> {
    let observer = observer_of(request);
    let bounds = Aabb { min: CUBE.min * 2.0, max: CUBE.max * 2.0 };
    let camera = observer.camera(Some(bounds), request.size.aspect()).ok()?;
    Some(Screen::new(camera, PixelRect::whole(request.size), request.size.scale))
}

/// The clipped and projected scene, in display space.
pub(super) fn contents(request: &Request) -> Scene {
    let palette = Palette::of(request.shot.look.style.theme);
    revealed_scene::in_canonical(request, palette).scene.into_owned()
}

/// The observer of the picture.
pub(super) fn observer_of(request: &Request) -> Observer {
    request.observer.unwrap_or_else(|| observer(request, Viewpoint::Iso))
}

/// Draws the canonical volume. An observer that isn't a camera sees nothing.
pub(super) fn frame_of(request: &Request, pipeline: &mut TimedPipeline) -> Frame {
    let style = &request.shot.look.style;
    let palette = Palette::of(style.theme);
    let target = request.size.target(palette.paper);
    let Some(screen) = screen(request) else {
        return pipeline.frame(request, &Scene::default(), &request.camera, target, style, |_, _| {});
    };
    let mut revealed = revealed_scene::in_canonical(request, palette);
    let (scene, style) = gizmos::wired(std::mem::take(&mut revealed.scene), style);
    let mut builder = AnnotationBuilder::new(&screen);
    let canonical = CanonicalBox::of(request);
    axes(&mut builder, &canonical, palette);
    revealed.mark(&mut builder, palette);
    probe::in_canonical(&mut builder, request, palette);
    triangle_overlay::in_canonical(&mut builder, request, palette);
    revealed.rows.extend(operation_path::in_canonical(&mut builder, request, palette));
    cube(&mut builder, &canonical, request.labels, palette);
    let fineness = screen.fineness(request, |p| screen.place(shown(request, &canonical, p)?));
    let lights = light_view::lights(request, &request.scene);
    let scenes = Scenes::new(&scene, &builder.gear).with_fineness(fineness);
    let scenes = light_view::shadowed(scenes, request, &lights);
    let drawn = pipeline.frame(request, scenes, screen.camera(), target, &style, |_, _| {});
    revealed.rows.extend(revealed_scene::drawn_rows(&drawn, request, palette));
    settled(drawn, request, revealed.rows, palette)
}

/// The displayed place of a point of the world, or the nearest place of the volume.
pub(super) fn shown(request: &Request, canonical: &CanonicalBox, p: DVec3) -> Option<DVec3> {
    let ndc = displayed_ndc(&request.camera, p)?;
    Some(canonical.place(ndc.clamp(DVec3::NEG_ONE, DVec3::ONE)))
}

fn axes(builder: &mut AnnotationBuilder, canonical: &CanonicalBox, palette: Palette) {
    for ((axis, (k, name)), color) in
        canonical.axes().into_iter().zip((0..).zip(["x_n", "y_n", "z_n"])).zip(palette.axes)
    {
        builder.axis(k, DVec3::ZERO, axis * AXIS, (color, 1.8), name);
    }
}

/// The box. Its front face (z_n = −1 in the notes) is emphasised like the window in the world, and its back face has
/// dashed edges like there.
fn cube(builder: &mut AnnotationBuilder, canonical: &CanonicalBox, labels: &Labels, palette: Palette) {
    let bounds = canonical.bounds();
    let [near, far] = canonical.faces();
    box_between(builder, near, far, palette);
    hatch(builder, bounds.max.z, palette);

    let [at_near, at_far] = canonical.ndc.depths().map(|depth| labels.mark.number(depth, 2));
    let back = if canonical.ndc.infinite { "B → ∞" } else { labels.far };
    let names = [
        ("near", near[3], format!("{} (z_n = {at_near})", labels.near)),
        ("far", far[2], format!("{back} (z_n = {at_far})")),
    ];
    for (name, p, text) in names {
        builder.named(name, p, &text, outwards(builder.screen, p), SMALL_TYPE, palette.ink);
    }
    for (p, text) in corner_names(builder.screen, canonical) {
        let toward = outwards(builder.screen, p);
        builder.role = Role::Aside;
        builder.named(&corner_name(p), p, &text, toward, SMALL_TYPE - 1.0, palette.soft);
    }
}

/// A volume between its near and its far face, each counter-clockwise as the camera sees it.
pub(super) fn box_between(builder: &mut AnnotationBuilder, near: [DVec3; 4], far: [DVec3; 4], palette: Palette) {
    let side = |i: usize| [near[i], near[(i + 1) % 4], far[(i + 1) % 4], far[i]];
    builder.sheer("volume", &[side(0), side(1), side(2), side(3), far], palette.volume);
    builder.sheer("near", &[near], palette.volume.with_alpha(palette.volume.a * 2));
    for i in 0..4 {
        builder.line(vec![near[i], far[i]], palette.volume_edge, 1.3, Dash::Solid);
    }
    builder.closed(&far, palette.volume_edge, 1.5, Dash::Dashed);
    builder.closed(&near, palette.ink, 2.0, Dash::Solid);
}

/// Places the texts of a picture of the volume around its legend.
pub(super) fn settled(mut drawn: Frame, request: &Request, rows: Vec<LegendRow>, palette: Palette) -> Frame {
    let target = request.size.target(palette.paper);
    let legend = revealed_scene::legend(request, rows, PixelRect::whole(request.size), target.scale, palette);
    let rules = Rules {
        reserved: revealed_scene::room(legend.as_ref()),
        leader: Some((palette.soft, 0.8 * request.size.scale)),
        author: Some(Author::of(request, palette)),
    };
    author_labels::add_notes(&mut drawn.drawing, request, DVec2::ZERO, screen(request).as_ref());
    label_layout::settle(&mut drawn.drawing, &rules);
    revealed_scene::explain(&mut drawn, request, legend.as_ref());
    drawn
}

/// The direction on the screen from the middle of the cube.
fn outwards(screen: &Screen, p: DVec3) -> DVec2 {
    match (screen.place(DVec3::ZERO), screen.place(p)) {
        (Some(middle), Some(px)) => px - middle,
        _ => DVec2::ZERO,
    }
}

/// The coordinates of the corners, or in a small picture of two corners only. Two that coincide in the picture have one
/// name, with ±.
fn corner_names(screen: &Screen, canonical: &CanonicalBox) -> Vec<(DVec3, String)> {
    const SMALL: f64 = 320.0;
    let corners = canonical.bounds().corners();
    let wanted = if screen.extent.min_element() < SMALL * screen.scale {
        vec![corners[4], corners[3]]
    } else {
        corners.to_vec()
    };
    let coincide = |a: DVec3, b: DVec3| matches!((screen.place(a), screen.place(b)), (Some(a), Some(b)) if a.distance(b) < 12.0 * screen.scale);
    let mut names: Vec<(DVec3, String)> = Vec::new();
    for p in wanted {
        let twin = corners.into_iter().find(|&q| q != p && coincide(p, q));
        if twin.is_some_and(|t| names.iter().any(|(q, _)| *q == t)) {
            continue;
        }
        let (p_ndc, t_ndc) = (canonical.ndc_at(p), canonical.ndc_at(twin.unwrap_or(p)));
        let [x, y, z] = [(p_ndc.x, t_ndc.x), (p_ndc.y, t_ndc.y), (p_ndc.z, t_ndc.z)].map(|(a, b)| coordinate(a, b));
        names.push((p, format!("({x}, {y}, {z})")));
    }
    names
}

/// The name with which an author changes the coordinates of a corner of the box.
fn corner_name(p: DVec3) -> String {
    let side = |is_high, [low, high]: [&'static str; 2]| if is_high { high } else { low };
    let depth = side(p.z > 0.0, ["far", "near"]);
    format!("corner:{depth}-{}-{}", side(p.x > 0.0, ["left", "right"]), side(p.y > 0.0, ["bottom", "top"]))
}

/// A coordinate of a corner, or of two in one place.
fn coordinate(a: f64, b: f64) -> &'static str {
    match (a == b, a.min(b) < 0.0, a == 0.0) {
        (false, true, _) => "±1",
        (false, false, _) => "0…1",
        (true, true, _) => "−1",
        (true, false, true) => "0",
        (true, false, false) => "1",
    }
}

/// Short strokes along the inner side of the near face's border, as draughtsmen mark a plane.
fn hatch(builder: &mut AnnotationBuilder, depth: f64, palette: Palette) {
    const STROKES: i32 = 12;
    const LENGTH: f64 = 0.07;
    let hidden = std::mem::replace(&mut builder.hidden, HiddenLines::Hidden);
    for i in 0..STROKES {
        let a = -1.0 + 2.0 * (f64::from(i) + 0.5) / f64::from(STROKES);
        let ends = [
            [(a, 1.0), (a - LENGTH, 1.0 - LENGTH)],
            [(a, -1.0), (a + LENGTH, -1.0 + LENGTH)],
            [(1.0, a), (1.0 - LENGTH, a - LENGTH)],
            [(-1.0, a), (-1.0 + LENGTH, a + LENGTH)],
        ];
        for stroke in ends {
            let points = stroke.map(|(x, y)| DVec3::new(x, y, depth)).to_vec();
            builder.line(points, palette.soft, 0.8, Dash::Solid);
        }
    }
    builder.hidden = hidden;
}
