//! The framing of the world: its observer, and the sizes of the camera's gear, which belongs into the picture.

use glam::DVec3;

use super::Request;
use super::camera_gizmo::Gear;
use super::framing::{Content, iso_direction};
use super::observer::{Direction, Viewpoint, enclosing};
use super::pixels::PixelRect;
use super::screen::Screen;
use super::{dimensions, section};
use crate::camera::Camera;
use crate::figure::Observer;

/// The observer that a button gives: it looks from the viewpoint's side and has everything of interest in the picture.
pub(super) fn observer(request: &Request, viewpoint: Viewpoint) -> Observer {
    let camera = &request.camera;
    let iso = iso_direction(camera).clear_of(&lines(camera));
    framing(request, viewpoint.direction(iso, camera.basis()))
}

/// The lines along which a picture of the camera tells nothing: u, v, and n, which is the line of DOP too.
fn lines(camera: &Camera) -> [DVec3; 3] {
    let basis = camera.basis();
    [basis.u, basis.v, basis.n]
}

/// The observer that looks in the same direction and has everything of interest in the picture.
pub(super) fn fit(request: &Request, observer: &Observer) -> Observer {
    framing(request, Direction::from(*observer))
}

/// Frames the content; the camera's gear has a size in pixels, so its extent is known after a framing only, and each
/// next one knows it better.
fn framing(request: &Request, direction: Direction) -> Observer {
    let content = Content::of(request);
    let mut observer = enclosing(&content.of_interest, direction, request.size);
    for _ in 0..3 {
        let Some(screen) = screen_of(request, &observer, &content) else { break };
        let points = points(request, &content, &screen);
        observer = enclosing(&points, direction, request.size);
    }
    observer
}

/// Whether an observer has everything of interest in its picture.
pub(super) fn holds(request: &Request, observer: &Observer) -> bool {
    let content = Content::of(request);
    let screen = screen_of(request, observer, &content);
    screen.is_some_and(|screen| super::observer::holds(observer, &points(request, &content, &screen), request.size))
}

/// The points of interest, those of the camera's gear and of the dimensions among them.
fn points(request: &Request, content: &Content, screen: &Screen) -> Vec<DVec3> {
    let mut points = content.of_interest.clone();
    let gear = Gear::new(screen, &request.camera);
    points.extend(gear.room(&request.camera));
    if request.shot.look.world.dimensions {
        let below = request.camera.basis().v * (-dimensions::LOWEST * gear.axis);
        let ahead = request.camera.direction_of_projection() * content.volume.end;
        points.extend([request.camera.position() + below, request.camera.position() + ahead + below]);
    }
    points
}

/// The observer of the world.
pub(super) fn seen_from(request: &Request) -> Observer {
    if request.shot.look.world.section {
        return section::observer(request);
    }
    request.observer.unwrap_or_else(|| observer(request, Viewpoint::Iso))
}

/// The observer's camera and its pixels; `None` for an observer that is not a camera.
pub(super) fn screen(request: &Request) -> Option<Screen> {
    screen_of(request, &seen_from(request), &Content::of(request))
}

pub(super) fn screen_of(request: &Request, observer: &Observer, content: &Content) -> Option<Screen> {
    let camera = observer.camera(Some(content.bounds()), request.size.aspect()).ok()?;
    Some(Screen::new(camera, PixelRect::whole(request.size), request.size.scale))
}
