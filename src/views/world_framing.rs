//! How the world is framed: its observer, and the sizes of the camera's gear, which belongs into the picture.

use glam::DVec3;

use super::Request;
use super::content::{Content, iso_direction};
use super::observer::{Direction, Viewpoint, enclosing};
use super::pixels::PixelRect;
use super::screen::Screen;
use crate::camera::Camera;
use crate::figure::Observer;

/// The observer that a button gives: it looks from the viewpoint's side and has everything of interest in the picture.
pub(super) fn observer(request: &Request, viewpoint: Viewpoint) -> Observer {
    let camera = &request.camera;
    let iso = iso_direction(camera).clear_of(&lines(camera));
    framing(request, viewpoint.direction(iso, camera.basis()))
}

/// The observer that keeps `observer`'s direction as long as it is clear of the camera's axes, and has everything of interest in
/// the picture.
pub(super) fn kept_clear(request: &Request, observer: &Observer) -> Observer {
    framing(request, Direction::from(*observer).clear_of(&lines(&request.camera)))
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

/// Frames what is of interest; the camera's gear has a size in pixels, so its room is known after a framing only, and each next
/// one knows it better.
fn framing(request: &Request, direction: Direction) -> Observer {
    let content = Content::of(request);
    let mut observer = enclosing(&content.of_interest, direction, request.size);
    for _ in 0..3 {
        let Some(screen) = screen_of(request, &observer, &content) else { break };
        let mut points = content.of_interest.clone();
        points.extend(Gear::new(&screen, &request.camera).room(&request.camera));
        observer = enclosing(&points, direction, request.size);
    }
    observer
}

/// From where the world is seen.
pub(super) fn seen_from(request: &Request) -> Observer {
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

/// The sizes of the camera's gear in scene units: fixed on the screen, so that the camera is found in any scene.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gear {
    /// One unit of [`camera_body`](super::gizmos::camera_body).
    pub(super) body: f64,
    /// Length of **u**, **v**, **n**.
    pub(super) axis: f64,
}

impl Gear {
    pub(super) fn new(screen: &Screen, camera: &Camera) -> Self {
        let pixel = screen.units_per_pixel(camera.position());
        let (side, scale) = (screen.extent().min_element(), screen.scale());
        Self {
            body: pixel * (0.036 * side).clamp(9.0 * scale, 60.0 * scale),
            axis: pixel * (0.12 * side).clamp(30.0 * scale, 180.0 * scale),
        }
    }

    /// Where VUP's arrow ends.
    pub(super) fn view_up_tip(&self, camera: &Camera) -> DVec3 {
        let up = crate::geometry::try_unit(camera.view_up()).unwrap_or(DVec3::Y);
        camera.position() + up * (1.35 * self.axis)
    }

    /// Points around the camera that a picture of it must hold.
    fn room(&self, camera: &Camera) -> [DVec3; 5] {
        let (c, basis) = (camera.position(), camera.basis());
        let out = 1.35 * self.axis;
        [self.view_up_tip(camera), c + basis.u * out, c + basis.v * out, c + basis.n * out, c - basis.v * (0.3 * out)]
    }
}
