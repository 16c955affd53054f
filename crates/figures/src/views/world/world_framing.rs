//! The framing of the world: its observer, and the sizes of the camera's gear, which belongs in the picture.

use glam::DVec3;

use super::camera_gizmo::GizmoSizes;
use super::framing::{Content, iso_direction};
use super::{dimensions, section};
use crate::camera::Camera;
use crate::figure::Observer;
use crate::views::observer::{Viewpoint, clear_of, enclosing};
use crate::views::pixels::PixelRect;
use crate::views::screen::Screen;
use crate::views::{Request, Size};

/// The observer for a button. It looks from the viewpoint's side and has everything of interest in the picture.
pub(in crate::views) fn observer(request: &Request, viewpoint: Viewpoint) -> Observer {
    let camera = &request.camera;
    let iso = clear_of(iso_direction(camera), &lines(camera));
    framing(request, viewpoint.direction(iso, camera.basis()))
}

/// The lines along which a picture of the camera shows nothing: u, v, and n, which is the line of DOP too.
fn lines(camera: &Camera) -> [DVec3; 3] {
    let basis = camera.basis();
    [basis.u, basis.v, basis.n]
}

/// The observer of several pictures, which has everything of interest of each. It looks like that of the first one, or
/// so that no camera is seen along an axis, if that's possible.
pub(in crate::views) fn common(requests: &[Request]) -> Option<Observer> {
    let first = requests.first()?;
    let all: Vec<DVec3> = requests.iter().flat_map(|request| lines(&request.camera)).collect();
    let direction = clear_of(clear_of(iso_direction(&first.camera), &lines(&first.camera)), &all);
    Some(framing_of(requests.iter().flat_map(Request::each_side), direction, first.size))
}

/// The observer that looks in a direction and has everything of interest in the picture.
pub(in crate::views) fn framing(request: &Request, direction: Observer) -> Observer {
    framing_of(request.each_side(), direction, request.size)
}

/// Frames the content. The camera's gear has a size in pixels, so its extent is only known after a framing, and each
/// further one knows it better.
fn framing_of(sides: impl IntoIterator<Item = Request>, direction: Observer, size: Size) -> Observer {
    let sides: Vec<Request> = sides.into_iter().collect();
    let sides: Vec<(&Request, Content)> = sides.iter().map(|side| (side, Content::of(side))).collect();
    let size = sides.first().map_or(size, |(side, _)| side.size);
    let of_interest: Vec<DVec3> = sides.iter().flat_map(|(_, content)| &content.of_interest).copied().collect();
    let mut observer = enclosing(&of_interest, direction, size);
    for _ in 0..3 {
        let mut points = of_interest.clone();
        for (side, content) in &sides {
            let Some(gear) = gear_points(side, &observer, content) else { return observer };
            points.extend(gear);
        }
        observer = enclosing(&points, direction, size);
    }
    observer
}

/// True if an observer has everything of interest in its picture. For a comparison, that of both sides.
pub(in crate::views) fn holds(request: &Request, observer: &Observer) -> bool {
    request.each_side().iter().all(|side| {
        let content = Content::of(side);
        let gear = gear_points(side, observer, &content);
        gear.is_some_and(|gear| {
            crate::views::observer::holds(observer, &content.of_interest, side.size)
                && crate::views::observer::holds(observer, &gear, side.size)
        })
    })
}

/// The points around the camera's gear, in its size for an observer; `None` for one that isn't a camera.
fn gear_points(request: &Request, observer: &Observer, content: &Content) -> Option<Vec<DVec3>> {
    let screen = screen_of(request, observer, content)?;
    let gear = GizmoSizes::new(&screen, &request.camera, &request.shot.look.world);
    let mut points: Vec<DVec3> = gear.room(&request.camera).into_iter().collect();
    for other in request.shot.cameras.iter() {
        let gear = GizmoSizes::new(&screen, &other.camera, &request.shot.look.world);
        let (c, basis) = (other.camera.position(), other.camera.basis());
        // The body, and the axes, which are shorter than those of the current camera.
        points.extend([c + basis.n * (2.0 * gear.body), c + basis.n * gear.body + basis.v * (1.5 * gear.body)]);
        points.extend([basis.u, basis.v, basis.n].map(|axis| c + axis * (0.8 * gear.axis)));
    }
    if request.shot.look.world.dimensions {
        let below = request.camera.basis().v * (-dimensions::LOWEST * gear.usual_axis);
        let ahead = request.camera.direction_of_projection() * content.volume.end;
        points.extend([request.camera.position() + below, request.camera.position() + ahead + below]);
    }
    Some(points)
}

/// The observer of the world.
pub(in crate::views) fn seen_from(request: &Request) -> Observer {
    if request.shot.look.world.section {
        return section::observer(request);
    }
    request.observer.unwrap_or_else(|| observer(request, Viewpoint::Iso))
}

/// The observer's camera and its pixels; `None` for an observer that isn't a camera.
pub(in crate::views) fn screen(request: &Request) -> Option<Screen> {
    screen_of(request, &seen_from(request), &Content::of(request))
}

pub(in crate::views) fn screen_of(request: &Request, observer: &Observer, content: &Content) -> Option<Screen> {
    let camera = observer.camera(Some(content.bounds()), request.size.aspect()).ok()?;
    Some(Screen::new(camera, PixelRect::whole(request.size), request.size.scale))
}
