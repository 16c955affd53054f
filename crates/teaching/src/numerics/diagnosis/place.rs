//! The place of the points of a subject: the side of each plane of the volume, the depth, and the pixels.

use glam::{DVec2, DVec3};

use super::Cause;
use super::subject::NamedThing;
use crate::camera::{Camera, ImageSize, Projection, ViewWindow};
use crate::pipeline::canonical::clipped_segment_of;

/// A side of the view window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
    Bottom,
    Top,
}

const SIDES: [Side; 4] = [Side::Left, Side::Right, Side::Bottom, Side::Top];

/// The place of a subject.
#[derive(Clone, Debug)]
pub(super) struct Whereabouts {
    /// Least and greatest distance from the eye along DOP.
    pub(super) depth: [f64; 2],
    range: [f64; 2],
    /// Sides that all points are outside of, as bits in the order of [`SIDES`].
    every: u8,
    /// The same for all points beyond the near plane.
    every_beyond_near: u8,
    /// The box on the image, in pixels from its middle; `None` if a point isn't in front of the eye.
    box_on_image: Option<[DVec2; 2]>,
    image: DVec2,
    /// The middle of the box of depths and of window points.
    center: DVec3,
}

impl Whereabouts {
    pub(super) fn of(subject: &NamedThing, camera: &Camera, image: ImageSize) -> Self {
        let lens = UnitWindow::of(camera);
        let mut place = Self {
            depth: [f64::INFINITY, f64::NEG_INFINITY],
            range: [camera.near(), camera.far()],
            every: 0b1111,
            every_beyond_near: 0b1111,
            box_on_image: None,
            image: DVec2::new(f64::from(image.width), f64::from(image.height)),
            center: DVec3::ZERO,
        };
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (mut least, mut most) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for p in subject.points() {
            let p = camera.view_point(p);
            let (depth, outside) = (-p.z, lens.outside(p));
            place.depth = [place.depth[0].min(depth), place.depth[1].max(depth)];
            place.every &= outside;
            if depth >= camera.near() {
                place.every_beyond_near &= outside;
            }
            (low, high) = (low.min(p), high.max(p));
            let at = lens.off_middle(p);
            (least, most) = (least.min(at), most.max(at));
        }
        place.center = low + (high - low) * 0.5;
        if camera.projection() == Projection::Parallel || place.depth[0] > 0.0 {
            place.box_on_image = Some([least * place.image, most * place.image]);
        }
        let at = lens.off_middle(place.center);
        place.center = DVec3::new(at.x, at.y, -place.center.z);
        place
    }

    pub(super) fn is_before_near(&self) -> bool {
        self.depth[1] < self.range[0]
    }

    pub(super) fn is_beyond_far(&self) -> bool {
        self.depth[0] > self.range[1]
    }

    /// The sides that all of it is outside of, starting with the one that it's farthest from.
    pub(super) fn outside(&self) -> Vec<Side> {
        let of = |code: u8| (0..4).filter(|i| code & (1 << i) != 0).map(|i| SIDES[i]).collect::<Vec<_>>();
        let partly_before = self.depth[0] < self.range[0] && self.depth[1] >= self.range[0];
        let mut sides = of(if partly_before { self.every_beyond_near } else { self.every });
        sides.sort_by(|a, b| self.excess(*b).total_cmp(&self.excess(*a)));
        sides
    }

    /// Distance of its middle outside a side, in images.
    fn excess(&self, side: Side) -> f64 {
        match side {
            Side::Left => -0.5 - self.center.x,
            Side::Right => self.center.x - 0.5,
            Side::Bottom => -0.5 - self.center.y,
            Side::Top => self.center.y - 0.5,
        }
    }

    /// The side that the middle is farthest outside of.
    pub(super) fn center_outside(&self) -> Option<Side> {
        let side = SIDES.into_iter().max_by(|a, b| self.excess(*a).total_cmp(&self.excess(*b)))?;
        (self.excess(side) > 0.0).then_some(side)
    }

    /// The reason, judged by its middle, if no single plane keeps it out but it isn't visible.
    pub(super) fn aside(&self) -> Cause {
        match self.center_outside() {
            _ if self.center.z <= 0.0 => Cause::BehindCamera,
            Some(side) => Cause::outside(side),
            None => Cause::SmallerThanPixel,
        }
    }

    pub(super) fn center_depth(&self) -> f64 {
        self.center.z
    }

    fn size_on_image(&self) -> Option<DVec2> {
        self.box_on_image.map(|[least, most]| most - least)
    }

    pub(super) fn is_smaller_than_pixel(&self) -> bool {
        self.size_on_image().is_some_and(|size| size.max_element() < 1.0)
    }

    /// True if it may lie between the centres of pixels.
    pub(super) fn is_thin(&self) -> bool {
        self.size_on_image().is_some_and(|size| size.min_element() < 2.0)
    }

    /// The share of its box that's on the image; `None` if it's unknown, or if its middle is on the image.
    pub(super) fn share_inside(&self) -> Option<f64> {
        self.center_outside()?;
        let [least, most] = self.box_on_image?;
        let half = self.image / 2.0;
        let inside = (most.min(half) - least.max(-half)).max(DVec2::ZERO);
        let size = (most - least).max(DVec2::splat(f64::MIN_POSITIVE));
        Some((inside / size).element_product())
    }
}

/// True if a segment of it is in the volume.
pub(super) fn crosses(subject: &NamedThing, camera: &Camera) -> bool {
    let clipped = clipped_segment_of(camera);
    subject.segments().any(|ends| clipped(ends).is_some())
}

/// The window on the plane z_c = −1 in perspective, at any depth in parallel projection.
struct UnitWindow {
    window: ViewWindow,
    perspective: bool,
}

impl UnitWindow {
    fn of(camera: &Camera) -> Self {
        let perspective = camera.projection() == Projection::Perspective;
        let window = camera.window().map(|x| if perspective { x / camera.near() } else { x });
        Self { window, perspective }
    }

    /// Distances from left, right, bottom and top, positive inside, up to a factor.
    fn sides(&self, p: DVec3) -> [f64; 4] {
        let w = if self.perspective { -p.z } else { 1.0 };
        let ViewWindow { left, right, bottom, top } = self.window;
        [p.x - left * w, right * w - p.x, p.y - bottom * w, top * w - p.y]
    }

    fn outside(&self, p: DVec3) -> u8 {
        (0..).zip(self.sides(p)).fold(0, |code, (i, distance)| code | (u8::from(distance < 0.0) << i))
    }

    /// The place on the image, from its middle, in images. Y up.
    fn off_middle(&self, p: DVec3) -> DVec2 {
        let ViewWindow { left, right, bottom, top } = self.window;
        let w = if self.perspective { -p.z } else { 1.0 };
        DVec2::new(
            (p.x / w - f64::midpoint(left, right)) / (right - left),
            (p.y / w - f64::midpoint(bottom, top)) / (top - bottom),
        )
    }
}
