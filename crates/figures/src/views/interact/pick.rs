//! Picking: from a place in a picture to the object or point there.

use std::borrow::Cow;

use glam::{DVec2, DVec3};

use crate::camera::Camera;
use crate::scene::Scene;

use super::hits::{can_be_seen, crossing, faced, fronts_only, triangle_hit};
use crate::views::canonical::canonical_box::shown_at;
use crate::views::reveal::probe::{Pixel, ray_of};
use crate::views::screen::Screen;
use crate::views::world::world_framing;
use crate::views::{Probe, Request, View, canonical, image};

/// The vertex of the scene (world) nearest to a place (pixels) of a picture, within `reach` pixels. A hidden vertex is
/// picked only if no other is within reach. In the canonical volume and in the image, only vertices inside the view
/// volume are.
pub fn vertex(request: &Request, pointer: DVec2, reach: f64) -> Option<DVec3> {
    let points = vertices(&request.scene).filter_map(|p| Some((shown_at(request, p)?, p)));
    nearest(points, &faces(request), &screen(request)?, pointer, reach)
}

/// The name of the figure's object whose face is at a place (pixels) of a picture; `None` if there is none, and in the
/// canonical volume, where faces have been clipped and projected.
pub fn object(request: &Request, pointer: DVec2) -> Option<String> {
    match request.view {
        View::World => object_in_world(request, pointer),
        View::Canonical => None,
        View::Image => {
            let (object, _) = triangle_in_image(request, pointer)?;
            Some(request.scene.objects[object].owner().to_owned())
        }
    }
}

/// The triangle (object of the scene, index in its mesh) that the image shows at a place (pixels).
pub fn triangle_in_image(request: &Request, pointer: DVec2) -> Option<(usize, u32)> {
    let (_, from, to) = ray_of(request, window_point_in_image(request, pointer)?);
    let hits = faced(&request.scene).filter_map(|(i, o)| Some((triangle_hit(o, from, to, fronts_only(o))?, i)));
    hits.min_by(|a, b| a.0.0.total_cmp(&b.0.0)).map(|((_, triangle), object)| (object, triangle))
}

/// The pixel of the figure's image, m × n, at a place (pixels) of the image picture, (0, 0) at the top left.
pub fn image_pixel(request: &Request, pointer: DVec2) -> Option<[u32; 2]> {
    let frame = image::screen(request);
    let share = frame.holds(pointer).then(|| frame.window_point(pointer))?;
    let window = request.camera.window();
    let (m, n) = (request.shot.look.image.width, request.shot.look.image.height);
    #[expect(clippy::cast_possible_truncation, reason = "held to the image")]
    let part = |share: f64, size: u32| ((share * f64::from(size)) as u32).min(size.saturating_sub(1));
    let x = (share.x - window.left) / window.width();
    let y = (window.top - share.y) / window.height();
    Some([part(x, m), part(y, n)])
}

/// The next vertex (world) from `from` in a direction (pixels, y down) of a picture. Without `from`, it's the one
/// nearest to the middle. Only visible vertices count. `None` if there is none.
pub fn vertex_beside(request: &Request, from: Option<DVec3>, toward: DVec2) -> Option<DVec3> {
    let (screen, faces) = (screen(request)?, faces(request));
    let of_shown = |p: DVec3| screen.place_inside(shown_at(request, p)?);
    let start = match from {
        Some(p) => of_shown(p)?,
        None => screen.middle(),
    };
    // Direction counts more than distance. Half the way to the side is as far as the way ahead.
    let far = |way: DVec2| if from.is_some() { way.length_squared() / way.dot(toward) } else { way.length() };
    let mut next: Vec<(f64, DVec3)> = vertices(&request.scene)
        .filter_map(|p| {
            let way = of_shown(p)? - start;
            let is_on = from.is_none() || (way.length() > 0.5 && way.dot(toward) > 0.35 * way.length());
            is_on.then(|| (far(way), p))
        })
        .collect();
    next.sort_by(|a, b| a.0.total_cmp(&b.0));
    next.dedup_by(|a, b| a.1 == b.1);
    let seen = |p: &DVec3| shown_at(request, *p).is_some_and(|shown| can_be_seen(shown, &faces, screen.camera()));
    next.into_iter().map(|(_, p)| p).find(seen)
}

/// The point (world) of a probe: the point itself, or for a ray its first point of the scene, else that of the window.
pub fn point_of(request: &Request, probe: Probe) -> DVec3 {
    match probe {
        Probe::Point(p) => p,
        Probe::Window(point) => {
            let pixel = Pixel::new(request, point);
            pixel.hit.unwrap_or(pixel.window)
        }
    }
}

/// The first point of the scene (world) behind a point of the view window.
pub fn hit_of(request: &Request, point: DVec2) -> Option<DVec3> {
    Pixel::new(request, point).hit
}

/// The places (pixels) where a picture shows points of the world, if it does; `None` for an observer that isn't a
/// camera. It doesn't look at the scene.
pub fn places(request: &Request) -> Option<impl Fn(DVec3) -> Option<DVec2>> {
    let screen = screen(request)?;
    Some(move |p_world| screen.place_inside(shown_at(request, p_world)?))
}

/// The screen of a picture; `None` for an observer that isn't a camera.
fn screen(request: &Request) -> Option<Screen> {
    match request.view {
        View::World => world_framing::screen(request),
        View::Canonical => canonical::screen(request),
        View::Image => Some(image::screen(request)),
    }
}

/// The faces that hide vertices in a picture.
fn faces(request: &Request) -> Cow<'_, Scene> {
    match request.view {
        View::Canonical => Cow::Owned(canonical::contents(request)),
        View::World | View::Image => Cow::Borrowed(&*request.scene),
    }
}

/// The point (x_p, y_p) of the view window at a place (pixels) of the image picture; `None` outside the frame.
pub fn window_point_in_image(request: &Request, pointer: DVec2) -> Option<DVec2> {
    let screen = image::screen(request);
    screen.holds(pointer).then(|| screen.window_point(pointer))
}

fn object_in_world(request: &Request, pointer: DVec2) -> Option<String> {
    let ray = world_framing::screen(request)?.ray(pointer);
    let bounds = request.scene.bounds()?;
    let far = ray.origin + ray.direction * (bounds.center().distance(ray.origin) + 2.0 * bounds.radius());
    let hits = faced(&request.scene).filter_map(|(_, o)| Some((crossing(o, ray.origin, far, fronts_only(o))?, o)));
    hits.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, object)| object.owner().to_owned())
}

/// Every point that can be picked: vertices, ends of lines, marks.
fn vertices(scene: &Scene) -> impl Iterator<Item = DVec3> {
    let lines = scene.lines.iter().flat_map(|l| l.points.iter().copied());
    let marks = scene.marks.iter().map(|m| m.position);
    scene.vertices().map(|v| v.p_world).chain(lines).chain(marks)
}

/// The point (as drawn, with its meaning) nearest to a place. A point hidden by faces loses to any visible one.
fn nearest(
    points: impl Iterator<Item = (DVec3, DVec3)>,
    faces: &Scene,
    screen: &Screen,
    pointer: DVec2,
    reach: f64,
) -> Option<DVec3> {
    /// Number of the nearest points tested for visibility. If more are within reach, they're indistinguishable.
    const MOST: usize = 8;
    let mut close: Vec<(f64, DVec3, DVec3)> = points
        .filter_map(|(shown, stands_for)| Some((screen.place_inside(shown)?.distance(pointer), shown, stands_for)))
        .filter(|(distance, ..)| *distance <= reach)
        .collect();
    close.sort_by(|a, b| a.0.total_cmp(&b.0));
    close.dedup_by(|a, b| a.1 == b.1);
    close.truncate(MOST);
    let visible = close.iter().find(|(_, shown, _)| can_be_seen(*shown, faces, screen.camera()));
    visible.or(close.first()).map(|(_, _, stands_for)| *stands_for)
}

/// True if no face hides a point (world) behind the camera's front plane.
pub fn can_be_seen_by(camera: &Camera, faces: &Scene, p: DVec3) -> bool {
    can_be_seen(p, faces, camera)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::{Camera, Parameters};
    use crate::figure::Figure;
    use crate::pipeline::canonical::displayed_ndc;
    use crate::views::interact::hits::first_hit;
    use crate::views::observer::Viewpoint;
    use crate::views::{SharedScene, Size, unlabelled};

    /// Calls `test` with a picture of the cube \[−1, 1\]³, which a camera at (3, 4, 5) sees whole.
    fn with_cube(parameters: Parameters, test: impl Fn(&Request)) {
        let mut figure = Figure::default();
        figure.scene.preset = crate::scene::Preset::Empty;
        figure.scene.objects.push(crate::scene::ObjectSpec {
            segments: 32,
            ..crate::scene::ObjectSpec::new("cube", crate::scene::Shape::Box)
        });
        let scene = crate::views::scene_of(&figure, &mut crate::scene::no_files, &crate::progress::Progress::default())
            .unwrap();
        let camera = Camera::new(&parameters).unwrap();
        let (scene, size) = (SharedScene::new(scene), Size { width: 600, height: 450, scale: 1.0 });
        test(&Request::of(&figure, View::Image, &camera, &scene, unlabelled(), size));
    }

    /// The same for another picture.
    fn seen(request: &Request, view: View, viewpoint: Viewpoint) -> Request {
        let request = Request { view, ..request.clone() };
        let observer = request.observer_from(viewpoint);
        request.seen_by(observer)
    }

    /// The front plane cuts the front away, so the inside of the back is visible.
    #[test]
    fn the_inside_of_a_solid_that_is_cut_open_is_the_solid() {
        let position = DVec3::new(0.0, 0.0, 5.0);
        for near in [1.0, 4.5] {
            with_cube(Parameters { position, near, ..Parameters::default() }, |request| {
                let middle = DVec2::new(300.0, 225.0);
                assert_eq!(object(request, middle).as_deref(), Some("cube"), "F = {near}");
                let (_, triangle) = triangle_in_image(request, middle).unwrap();
                let corners = request.scene.objects[0].mesh.triangles[triangle as usize];
                let z = request.scene.objects[0].mesh.positions[corners[0] as usize].z;
                assert_eq!(z, if near < 4.0 { 1.0 } else { -1.0 });
            });
        }
    }

    #[test]
    fn an_invisible_object_in_front_is_not_picked() {
        with_cube(Parameters::default(), |request| {
            let middle = DVec2::new(300.0, 225.0);
            let mut scene = (*request.scene).clone();
            let mut glass = scene.objects[0].clone();
            glass.paint = crate::scene::ObjectPaint::Solid(crate::appearance::Rgba::rgb(1, 2, 3).with_alpha(0));
            glass.name = "glass".to_owned();
            glass.world_from_object = glam::DAffine3::from_scale(DVec3::splat(1.1)) * glass.world_from_object;
            scene.objects.insert(0, glass);
            let request = Request { scene: SharedScene::new(scene), ..request.clone() };
            for view in [View::World, View::Image] {
                let request = Request { view, ..request.clone() };
                let corner = screen(&request).unwrap().place(DVec3::new(0.9, 0.9, 1.0)).unwrap();
                assert_eq!(object(&request, corner).as_deref(), Some("cube"), "{view:?}");
            }
            assert_eq!(triangle_in_image(&request, middle).map(|(object, _)| object), Some(1));
            assert_eq!(vertex(&request, screen(&request).unwrap().place(DVec3::ONE).unwrap(), 4.0), Some(DVec3::ONE));
        });
    }

    #[test]
    fn of_two_vertices_at_one_place_the_one_in_front_is_caught() {
        with_cube(Parameters::default(), |request| {
            for (viewpoint, front) in
                [(Viewpoint::Front, DVec3::Z), (Viewpoint::Side, DVec3::X), (Viewpoint::Top, DVec3::Y)]
            {
                let request = seen(request, View::World, viewpoint);
                let screen = world_framing::screen(&request).unwrap();
                for other in [DVec3::ONE, DVec3::NEG_ONE, DVec3::new(1.0, -1.0, 1.0)] {
                    let p = other * (DVec3::ONE - front) + front;
                    let place = screen.place(p - 2.0 * front).unwrap();
                    let found = vertex(&request, place + DVec2::new(2.0, 1.0), 8.0);
                    assert_eq!(found, Some(p), "{viewpoint:?}");
                }
            }
        });
    }

    #[test]
    fn a_hidden_vertex_is_picked_if_there_is_no_other() {
        with_cube(Parameters::default(), |request| {
            let screen = image::screen(request);
            let place = screen.place(DVec3::NEG_ONE).unwrap();
            assert!(!can_be_seen(DVec3::NEG_ONE, &request.scene, screen.camera()));
            assert!(can_be_seen(DVec3::ONE, &request.scene, screen.camera()));
            assert_eq!(vertex(request, place, 8.0), Some(DVec3::NEG_ONE));
            assert_eq!(vertex(request, place + 20.0, 8.0), None);
        });
    }

    #[test]
    fn the_object_that_is_seen_is_the_one_that_is_found() {
        with_cube(Parameters::default(), |request| {
            let world = seen(request, View::World, Viewpoint::Front);
            let screen = world_framing::screen(&world).unwrap();
            let middle = screen.place(DVec3::Z).unwrap();
            assert_eq!(object(&world, middle).as_deref(), Some("cube"));
            assert_eq!(object(&world, DVec2::ONE), None);
            let middle = image::screen(request).place(DVec3::ZERO).unwrap();
            assert_eq!(object(request, middle).as_deref(), Some("cube"));
            assert_eq!(object(request, DVec2::ONE), None);
        });
    }

    #[test]
    fn the_canonical_picture_leads_back_to_the_world() {
        with_cube(Parameters { near: 2.0, far: 12.0, ..Parameters::default() }, |request| {
            let request = seen(request, View::Canonical, Viewpoint::Iso);
            let screen = canonical::screen(&request).unwrap();
            let mut seen = 0;
            for p in canonical::CUBE.corners() {
                let shown = displayed_ndc(&request.camera, p).unwrap();
                if can_be_seen(shown, &canonical::contents(&request), screen.camera()) {
                    seen += 1;
                    let place = screen.place(shown).unwrap();
                    assert_eq!(vertex(&request, place, 3.0), Some(p));
                }
            }
            assert!((4..=7).contains(&seen), "{seen} of eight");
        });
    }

    #[test]
    fn vertices_outside_the_volume_are_not_picked_in_the_image() {
        // F = 7: the corner (1, 1, 1), nearest to C, has been cut off.
        with_cube(Parameters { near: 7.0, ..Parameters::default() }, |request| {
            let toward = request.camera.view_point(DVec3::ONE);
            let place = image::screen(request).window_place(toward.truncate() * (7.0 / -toward.z));
            assert_eq!(vertex(request, place, 4.0), None);
        });
    }

    #[test]
    fn the_image_maps_to_the_window() {
        with_cube(Parameters { aspect: 1.0, ..Parameters::default() }, |request| {
            let w = request.camera.window();
            let undistorted = request.clone().with_shot(|shot| shot.look.undistorted = true);
            let at = |x, y| window_point_in_image(&undistorted, DVec2::new(x, y));
            assert_eq!(at(75.0, 0.0), Some(DVec2::new(w.left, w.top)), "450 × 450 in the middle of 600");
            assert_eq!(at(525.0, 450.0), Some(DVec2::new(w.right, w.bottom)));
            assert_eq!(at(74.0, 10.0), None);
            let at = |x, y| window_point_in_image(request, DVec2::new(x, y));
            assert_eq!(
                at(0.0, 0.0),
                Some(DVec2::new(w.left, w.top)),
                "the square window fills the m × n image of 4 : 3"
            );
            assert_eq!(at(600.0, 450.0), Some(DVec2::new(w.right, w.bottom)));
            let request = Request { size: Size { width: 800, ..request.size }, ..request.clone() };
            let at = |x, y| window_point_in_image(&request, DVec2::new(x, y));
            assert_eq!(at(100.0, 0.0), Some(DVec2::new(w.left, w.top)), "beside it is room");
            assert_eq!(at(99.0, 10.0), None);
        });
    }

    #[test]
    fn a_segment_ends_on_the_first_face() {
        with_cube(Parameters::default(), |request| {
            let hit = first_hit(&request.scene, DVec3::new(0.25, 0.5, 9.0), DVec3::new(0.25, 0.5, -9.0)).unwrap();
            assert!((hit - DVec3::new(0.25, 0.5, 1.0)).length() < 1e-12);
            let short = first_hit(&request.scene, DVec3::new(0.25, 0.5, 9.0), DVec3::new(0.25, 0.5, 1.5));
            assert_eq!(short, None);
            assert_eq!(first_hit(&request.scene, DVec3::new(1.25, 0.5, 9.0), DVec3::new(1.25, 0.5, -9.0)), None);
        });
    }
}
