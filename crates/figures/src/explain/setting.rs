//! The numbers of the symbols.

use glam::{DMat4, DVec2, DVec3};

use super::{Axis, Component, Matrix, Symbol};
use crate::camera::{ClipSpace, ImageSize, Ndc, Projected, Stations, Unprojected, Viewport};
use crate::geometry::Angle;

/// The placement of an object in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// t
    pub translate: DVec3,
    /// φ: degrees about x, then y, then z
    pub rotate: DVec3,
    /// s
    pub scale: DVec3,
    /// The transform of its parent.
    pub parent: Option<DMat4>,
    /// M_m, as used in building the scene.
    pub world_from_object: DMat4,
}

/// A camera in a convention of NDC, with image and viewport, and optionally an object and a point.
#[derive(Clone, Debug)]
pub struct Setting<'a> {
    space: ClipSpace<'a>,
    image: ImageSize,
    viewport: Viewport,
    placement: Option<Placement>,
    point: Option<Stations>,
    local: Option<DVec3>,
    /// A student's numbers for some symbols, and the entries of matrices that follow from them.
    pub(super) own: Option<(Vec<(Symbol, f64)>, EntryOf)>,
}

/// Computes an entry of a matrix by its formula, from its row and its column.
pub(super) type EntryOf = fn(&Setting<'_>, Matrix, [u8; 2]) -> f64;

impl<'a> Setting<'a> {
    /// A camera without an object and without a point. Without a viewport, it's the whole image, depth 0 … 1.
    pub fn new(space: ClipSpace<'a>, image: ImageSize, viewport: Option<Viewport>) -> Self {
        let viewport = viewport.unwrap_or_else(|| Viewport::whole(image));
        Self { space, image, viewport, placement: None, point: None, local: None, own: None }
    }

    /// Adds an object, for its M_m.
    pub fn with_placement(self, placement: Placement) -> Self {
        Self { placement: Some(placement), ..self }
    }

    /// Adds a point of the world.
    pub fn with_point(self, world: DVec3) -> Self {
        Self { point: Some(self.space.stations(world, self.image, &self.viewport)), local: None, ..self }
    }

    /// Adds the point to which a pixel with a depth leads back, with the numbers of that way, before anything is
    /// rounded to whole pixels.
    pub fn with_way_back(self, way: &Unprojected) -> Self {
        let setting = self.with_point(way.world);
        let pixel = DVec2::from_array(way.pixel.map(|x| x as f64));
        let viewport = |ndc: Projected| ndc.viewport.with_z(way.depth);
        let point = setting.point.map(|point| {
            let found = point.projected.map(viewport);
            let viewport = found.unwrap_or(DVec3::new(f64::NAN, f64::NAN, way.depth));
            let projected = Some(Projected { ndc: way.ndc, window: way.window, pixel, viewport });
            Stations { view: way.view, clip: way.clip, projected, ..point }
        });
        Self { point, ..setting }
    }

    /// The same with a back plane, if the convention has none.
    #[must_use]
    pub fn with_far_plane(&self) -> Self {
        let ndc = Ndc { infinite: false, ..self.space.ndc() };
        let space = self.space.camera().possible_clip_space(ndc);
        let point = self.point.map(|point| space.stations(point.world, self.image, &self.viewport));
        Self { space, point, ..self.clone() }
    }

    /// Adds a point of the world, also in the space of the object if there is one.
    pub fn with_point_seen_from_object(self, world: DVec3) -> Self {
        let local = self.placement.map(|placement| placement.world_from_object.inverse().transform_point3(world));
        Self { local, ..self.with_point(world) }
    }

    /// Adds a point of the object, if there is an object.
    pub fn with_local_point(self, local: DVec3) -> Self {
        let Some(placement) = self.placement else { return self };
        Self { local: Some(local), ..self.with_point(placement.world_from_object.transform_point3(local)) }
    }

    /// The camera, in its convention.
    pub fn space(&self) -> &ClipSpace<'a> {
        &self.space
    }

    /// m × n.
    pub fn image(&self) -> ImageSize {
        self.image
    }

    /// The rectangle and the range of depths that `M_vp` maps to.
    pub fn viewport(&self) -> Viewport {
        self.viewport
    }

    /// The object whose `M_m` is explained.
    pub fn placement(&self) -> Option<Placement> {
        self.placement
    }

    /// The point in every space.
    pub fn point(&self) -> Option<&Stations> {
        self.point.as_ref()
    }

    /// The point in the space of its object.
    pub fn local(&self) -> Option<DVec3> {
        self.local
    }

    /// A matrix with the program's own numbers. The unit matrix if it needs an object and there is none.
    pub fn matrix(&self, matrix: Matrix) -> DMat4 {
        let camera = self.space.camera();
        let model = || self.placement.map_or(DMat4::IDENTITY, |p| p.world_from_object);
        let parent = || self.placement.and_then(|p| p.parent).unwrap_or(DMat4::IDENTITY);
        match matrix {
            Matrix::Model => model(),
            Matrix::InverseModel => model().inverse(),
            Matrix::Parent => parent(),
            Matrix::InverseParent => parent().inverse(),
            Matrix::View => camera.view_from_world(),
            Matrix::InverseView => camera.world_from_view(),
            Matrix::Projection => self.space.clip_from_view(),
            Matrix::InverseProjection => self.space.view_from_clip(),
            Matrix::ViewProjection => self.space.clip_from_world(),
            Matrix::InverseViewProjection => camera.world_from_view() * self.space.view_from_clip(),
            Matrix::Viewport => self.depth_and_window(),
            Matrix::InverseViewport => self.depth_and_window().inverse(),
        }
    }

    /// (5.24) before the floor and (5.25) as a matrix. In other conventions it uses their range of z_n and their
    /// direction of y.
    fn depth_and_window(&self) -> DMat4 {
        let v = &self.viewport;
        let (width, height) = (f64::from(v.width) / 2.0, f64::from(v.height) / 2.0);
        let ndc = self.space.ndc();
        let [at_near, at_far] = ndc.depths();
        let slope = (v.depth_far - v.depth_near) / (at_far - at_near);
        let up = if ndc.y_points_down() { -height } else { height };
        DMat4::from_cols(
            DVec3::X.extend(0.0) * width,
            DVec3::Y.extend(0.0) * up,
            DVec3::Z.extend(0.0) * slope,
            DVec3::new(width + f64::from(v.x), height + f64::from(v.y), v.depth_near - slope * at_near).extend(1.0),
        )
    }

    /// The number of a symbol; NaN if there's no such object or point, or if it has no image.
    pub fn value(&self, symbol: Symbol) -> f64 {
        let own = self.own.iter().flat_map(|(own, _)| own).find(|(of, _)| *of == symbol);
        if let Some((_, own)) = own {
            return *own;
        }
        let camera = self.space.camera();
        let (basis, window) = (camera.basis(), camera.window());
        let projected = self.point.and_then(|p| p.projected);
        let of = |v: DVec3, c: Component| v.to_array().get(c.index()).copied().unwrap_or(1.0) + 0.0;
        let maybe = |v: Option<DVec3>, c: Component| v.map_or(f64::NAN, |v| of(v, c));
        match symbol {
            Symbol::Axis(Axis::U, c) => of(basis.u, c),
            Symbol::Axis(Axis::V, c) => of(basis.v, c),
            Symbol::Axis(Axis::N, c) => of(basis.n, c),
            Symbol::Position(c) => of(camera.position(), c),
            Symbol::FocalPoint(c) => of(camera.focal_point(), c),
            Symbol::ViewUp(c) => of(camera.view_up(), c),
            Symbol::Distance => camera.distance(),
            Symbol::Near => camera.near(),
            Symbol::Far => camera.far(),
            Symbol::Left => window.left + 0.0,
            Symbol::Right => window.right + 0.0,
            Symbol::Bottom => window.bottom + 0.0,
            Symbol::Top => window.top + 0.0,
            Symbol::Width => camera.window_width(),
            Symbol::Height => camera.window_height(),
            Symbol::Aspect => camera.window_aspect(),
            Symbol::ViewAngle => camera.view_angle().degrees(),
            Symbol::ImageWidth => f64::from(self.image.width),
            Symbol::ImageHeight => f64::from(self.image.height),
            Symbol::ViewportX => f64::from(self.viewport.x),
            Symbol::ViewportY => f64::from(self.viewport.y),
            Symbol::ViewportWidth => f64::from(self.viewport.width),
            Symbol::ViewportHeight => f64::from(self.viewport.height),
            Symbol::DepthNear => self.viewport.depth_near,
            Symbol::DepthFar => self.viewport.depth_far,
            Symbol::Translate(c) => maybe(self.placement.map(|p| p.translate), c),
            Symbol::Rotate(c) => maybe(self.placement.map(|p| p.rotate), c),
            Symbol::Scale(c) => maybe(self.placement.map(|p| p.scale), c),
            Symbol::Entry(matrix, row, column) => match self.own {
                Some((_, entry)) => entry(self, matrix, [row, column]),
                None => self.matrix(matrix).row(usize::from(row.min(3))).to_array()[usize::from(column.min(3))] + 0.0,
            },
            Symbol::Local(c) => maybe(self.local, c),
            Symbol::World(c) => maybe(self.point.map(|p| p.world), c),
            Symbol::View(c) => maybe(self.point.map(|p| p.view), c),
            Symbol::Clip(c) => self.point.map_or(f64::NAN, |p| p.clip.to_array()[c.index()] + 0.0),
            Symbol::Homogeneous(c) => {
                self.point.map_or(f64::NAN, |p| p.view.extend(1.0).to_array()[c.index()] / p.clip.w + 0.0)
            }
            Symbol::Ndc(c) => maybe(projected.map(|p| p.ndc), c),
            Symbol::Window(c) => maybe(projected.map(|p| p.window.extend(0.0)), c),
            Symbol::Pixel(c) => maybe(projected.map(|p| p.pixel.extend(0.0)), c),
            Symbol::Viewport(c) => maybe(projected.map(|p| p.viewport), c),
        }
    }

    /// The angle of a symbol that stands for one. Angles are written with a degree sign.
    pub fn angle(&self, symbol: Symbol) -> Option<Angle> {
        matches!(symbol, Symbol::ViewAngle | Symbol::Rotate(_)).then(|| Angle::from_degrees(self.value(symbol)))
    }
}
