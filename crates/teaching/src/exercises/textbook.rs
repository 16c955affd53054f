//! The notes' equations as students write them by hand, with the known mistakes built in. They're the reference for
//! wrong answers.
//!
//! Right answers come from the camera itself ([`Subject::value`]). This chain only computes the results of mistakes.

use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};

use super::operated::operated;
use super::subject::Subject;
use super::value::Table;
use crate::camera::{Camera, ImageSize, ParameterKey, Projection, ViewWindow, Viewport};
use crate::exercises::mistakes::slip::{Slip, Slips};
use crate::inspect::quantity::{BasisAxis, PointNumber, Quantity, QuantityPath, RayNumber, ReportMatrix, WindowNumber};

/// A quantity of the report with slips; `None` if it isn't a number, or the report doesn't have it.
pub(super) fn value(subject: &Subject, path: impl Into<QuantityPath>, slips: Slips) -> Option<Table> {
    let QuantityPath { quantity, entry } = path.into();
    let camera = operated(subject, slips).ok()?;
    let found = Textbook::new(&camera, subject, slips).at(quantity)?;
    let found = match entry {
        [None, _] => found,
        [Some(row), column] => {
            let row = found.rows().nth(row)?;
            column.map_or_else(|| Some(Table::column(row)), |k| row.get(k).map(|entry| Table::number(*entry)))?
        }
    };
    found.is_finite().then_some(found)
}

/// The quantities derived from a camera with slips.
struct Textbook<'a> {
    camera: &'a Camera,
    subject: &'a Subject,
    slips: Slips,
    u: DVec3,
    v: DVec3,
    n: DVec3,
    window: ViewWindow,
    near: f64,
    far: f64,
    view: DMat4,
    projection: DMat4,
}

impl<'a> Textbook<'a> {
    fn new(camera: &'a Camera, subject: &'a Subject, slips: Slips) -> Self {
        let [u, v, n] = basis(camera, slips);
        let window = window(camera, slips);
        let origin = if slips.has(Slip::FocalPointAsOrigin) { camera.focal_point() } else { camera.position() };
        let view = view_matrix([u, v, n], origin, slips);
        let (near, far) = (camera.near(), camera.far());
        let projection = projection_matrix(camera, &window, subject.figure.image.height, slips);
        Self { camera, subject, slips, u, v, n, window, near, far, view, projection }
    }

    fn at(&self, quantity: Quantity) -> Option<Table> {
        let (parameters, slips) = (self.camera.parameters(), self.slips);
        // These concern the formula of the point that moves.
        let of_point = [Slip::PointsExchanged, Slip::TurnedInPlace, Slip::CentreNotAddedBack, Slip::DistanceLeftOut];
        if slips.any(&of_point)
            && !matches!(quantity, Quantity::Camera(ParameterKey::Position | ParameterKey::FocalPoint))
        {
            return None;
        }
        Some(match quantity {
            Quantity::Axis(BasisAxis::U) => self.u.into(),
            Quantity::Axis(BasisAxis::V) => self.v.into(),
            Quantity::Axis(BasisAxis::N) => self.n.into(),
            Quantity::Direction => (if slips.has(Slip::DirectionIsNormal) { self.n } else { -self.n }).into(),
            Quantity::Distance => self.camera.distance().into(),
            Quantity::Matrix(ReportMatrix::View) => self.view.into(),
            Quantity::Matrix(ReportMatrix::Projection) => self.shown_projection().into(),
            Quantity::Matrix(ReportMatrix::ViewProjection) => self.view_projection().into(),
            Quantity::Matrix(ReportMatrix::InverseView) => self.view.inverse().into(),
            Quantity::Matrix(ReportMatrix::InverseProjection) => self.projection.inverse().into(),
            Quantity::Window(number) => {
                let is_side = !matches!(number, WindowNumber::Width | WindowNumber::Height | WindowNumber::Aspect);
                let times = if is_side && slips.has(Slip::SideWhole) { 2.0 } else { 1.0 };
                (times * window_number(&self.window, number)).into()
            }
            Quantity::Camera(ParameterKey::Position) => parameters.position.into(),
            Quantity::Camera(ParameterKey::FocalPoint) => parameters.focal_point.into(),
            Quantity::Camera(ParameterKey::ViewUp) => parameters.view_up.into(),
            Quantity::Camera(ParameterKey::ViewAngle) => {
                let angle = parameters.view_angle;
                let over_near = 2.0 * (angle / 2.0).to_radians().tan();
                let wrong = [
                    (Slip::AnswerInRadians, angle.to_radians()),
                    (Slip::AngleHalved, angle / 2.0),
                    (Slip::AngleOfHeight, over_near.atan().to_degrees()),
                ];
                slips.pick(wrong, angle).into()
            }
            Quantity::Camera(ParameterKey::Height) => self.window.height().into(),
            Quantity::Camera(ParameterKey::Aspect | ParameterKey::Near | ParameterKey::Far | ParameterKey::Window)
            | Quantity::CameraSide(_)
            | Quantity::Lens(_)
            | Quantity::Plane(_) => return None,
            Quantity::Corner(k) => self.corner(k)?.into(),
            Quantity::Point(k, number) => self.point(*self.subject.points.get(k)?, number)?,
            Quantity::Ray(k, number) => self.ray(*self.subject.pixels.get(k)?, number)?,
        })
    }

    /// M_p as the student writes it.
    fn shown_projection(&self) -> DMat4 {
        let mut rows = self.projection.transpose();
        let (near, far) = (self.near, self.far);
        let is_perspective = self.projection() == Projection::Perspective;
        let [x, y] = [rows.x_axis.x, rows.y_axis.y];
        let scale = if self.is_symmetric() && self.slips.has(Slip::AspectOnOther) {
            [y, x]
        } else if is_perspective && self.slips.has(Slip::NearFarExchanged) {
            [x * far / near, y * far / near]
        } else if !is_perspective && self.slips.has(Slip::PerspectiveScale) {
            [x * near, y * near]
        } else if self.is_symmetric() && self.slips.has(Slip::ScaleInverted) {
            [1.0 / x, 1.0 / y]
        } else if is_perspective && self.is_symmetric() && self.slips.has(Slip::TangentForCotangent) {
            [x / (y * y), 1.0 / y]
        } else {
            [x, y]
        };
        [rows.x_axis.x, rows.y_axis.y] = scale;
        if self.slips.has(Slip::NearFarExchanged) {
            // B − F turns round; B + F and B F don't.
            rows.z_axis = -rows.z_axis;
        }
        let others = projection_matrix(
            self.camera,
            &self.window,
            self.subject.figure.image.height,
            self.slips.and(Slip::ProjectionsExchanged),
        );
        if self.slips.any(&[Slip::OtherDepthRow, Slip::OtherLastRows]) {
            rows.z_axis = others.row(2);
        }
        if self.slips.has(Slip::LastRowsExchanged) {
            (rows.z_axis, rows.w_axis) = (rows.w_axis, rows.z_axis);
        }
        if !is_perspective && self.slips.has(Slip::ShiftNotScaled) {
            let ViewWindow { left, right, bottom, top } = self.window;
            rows.x_axis.w = -f64::midpoint(left, right);
            rows.y_axis.w = -f64::midpoint(bottom, top);
            rows.z_axis.w = f64::midpoint(near, far);
        }
        if self.slips.any(&[Slip::OtherLastRow, Slip::OtherLastRows]) {
            rows.w_axis = if is_perspective { DVec4::W } else { DVec4::NEG_Z };
        }
        rows.transpose()
    }

    /// True if the window extends as far to the left as to the right, and as far up as down.
    fn is_symmetric(&self) -> bool {
        let ViewWindow { left, right, bottom, top } = self.window;
        left == -right && bottom == -top
    }

    fn view_projection(&self) -> DMat4 {
        if self.slips.has(Slip::OrderReversed) && self.subject.operations.len() < 2 {
            self.view * self.projection
        } else {
            self.projection * self.view
        }
    }

    /// The axes that numbers of the VRC refer to.
    fn axes(&self) -> [DVec3; 3] {
        if self.slips.has(Slip::ViewAsWorld) { [DVec3::X, DVec3::Y, DVec3::Z] } else { [self.u, self.v, self.n] }
    }

    fn corner(&self, k: usize) -> Option<DVec3> {
        let ViewWindow { left, right, bottom, top } = self.window;
        let (x, y) = *[(left, bottom), (right, bottom), (right, top), (left, top)].get(k % 4)?;
        let distance = if k < 4 { self.near } else { self.far };
        // In perspective, a point on the far plane is farther from the axis by the same factor.
        let spread = if self.camera.projection() == Projection::Perspective { distance / self.near } else { 1.0 };
        let is_printed = self.slips.has(Slip::PrintedBackFace);
        let depth = if is_printed { self.near } else { distance };
        let depth = if self.slips.has(Slip::NearForgottenOnWindow) && k < 4 { 0.0 } else { depth };
        let depth = if self.slips.any(&[Slip::WSign, Slip::LeftHanded, Slip::ViewDepthSign]) { -depth } else { depth };
        let x = if self.slips.any(&[Slip::OtherCorner, Slip::OtherCornerAcross]) { -x } else { x };
        let y = if self.slips.any(&[Slip::OtherCorner, Slip::OtherCornerUp]) { -y } else { y };
        let times = if self.slips.has(Slip::CornerWhole) && k < 4 { 2.0 } else { 1.0 };
        let (x, y) = (times * x, times * y);
        if self.slips.has(Slip::ViewGiven) {
            return (k < 4).then_some(DVec3::new(x, y, -depth));
        }
        let [u, v, n] = self.axes();
        (k < 8).then(|| self.camera.position() + u * (x * spread) + v * (y * spread) - n * depth)
    }

    fn point(&self, world: DVec3, number: PointNumber) -> Option<Table> {
        let view = if self.slips.has(Slip::ViewInverted) { self.view.inverse() } else { self.view };
        let seen = if self.slips.has(Slip::ViewForgotten) { world.extend(1.0) } else { view * world.extend(1.0) };
        let seen = if self.slips.has(Slip::ViewDepthSign) { DVec4::new(seen.x, seen.y, -seen.z, 1.0) } else { seen };
        let clip = self.projection * seen;
        let ndc = if self.slips.has(Slip::NoDivide) { clip.truncate() } else { clip.truncate() / clip.w };
        let linear = -2.0 * (seen.z + self.near) / (self.far - self.near) - 1.0;
        let in_perspective = self.projection() == Projection::Perspective;
        let z = self.slips.pick(
            [(Slip::DepthNotDivided, clip.z), (Slip::LinearDepth, if in_perspective { linear } else { ndc.z })],
            ndc.z,
        );
        let ndc = ndc.truncate().extend(z);
        Some(match number {
            PointNumber::World => world.into(),
            PointNumber::View if self.slips.has(Slip::ViewForgotten) => return None,
            PointNumber::View if self.slips.has(Slip::WorldGiven) => world.into(),
            PointNumber::View => seen.truncate().into(),
            PointNumber::Clip if self.slips.has(Slip::ClipDivided) => (clip / clip.w).into(),
            PointNumber::Clip if self.slips.has(Slip::ProjectionForgotten) => seen.truncate().extend(1.0).into(),
            PointNumber::Clip if self.slips.has(Slip::ClipWithOne) => clip.truncate().extend(1.0).into(),
            PointNumber::Clip => clip.into(),
            PointNumber::Ndc => ndc.into(),
            PointNumber::Window if self.slips.has(Slip::NdcAsWindow) => Table::column(&ndc.truncate().to_array()),
            PointNumber::Window => Table::column(&self.projected(seen.truncate()).to_array()),
            PointNumber::Pixel => Table::column(&self.pixel(self.projected(seen.truncate()))),
            PointNumber::Viewport => Table::column(&self.viewport(ndc)),
            PointNumber::Inside => return None,
        })
    }

    /// F in the projection of a point.
    fn near_of_window(&self) -> f64 {
        self.slips
            .pick([(Slip::NearForgottenOnWindow, 1.0), (Slip::DistanceOnWindow, self.camera.distance())], self.near)
    }

    /// The projection of points and rays.
    fn projection(&self) -> Projection {
        exchanged(self.camera.projection(), self.slips)
    }

    fn projected(&self, seen: DVec3) -> DVec2 {
        let in_perspective = self.projection() == Projection::Perspective && !self.slips.has(Slip::NoDivide);
        let depth = if self.slips.any(&[Slip::WSign, Slip::LeftHanded]) { seen.z } else { -seen.z };
        let depth = if self.slips.has(Slip::DistanceAsDepth) { seen.length() } else { depth };
        seen.truncate() * if in_perspective { self.near_of_window() / depth } else { 1.0 }
    }

    /// A number of pixels as a whole number.
    fn floored(&self, x: f64) -> f64 {
        let whole = self.slips.pick([(Slip::NotFloored, x), (Slip::RoundedNotFloored, x.round())], whole(x));
        whole + if self.slips.has(Slip::OneBased) { 1.0 } else { 0.0 }
    }

    /// m and n.
    fn sizes(&self, width: u32, height: u32) -> [f64; 2] {
        let [m, n] = [width, height].map(f64::from);
        if self.slips.has(Slip::SizesExchanged) { [n, m] } else { [m, n] }
    }

    fn pixel(&self, window: DVec2) -> [f64; 2] {
        let ImageSize { width, height } = self.subject.figure.image;
        let [m, n] = self.sizes(width, height);
        let ViewWindow { left, right, bottom, top } = self.window;
        let (left, top) = if self.slips.has(Slip::ImageMiddleForgotten) { (0.0, 0.0) } else { (left, top) };
        let across = if self.slips.has(Slip::XFlipped) { right - window.x } else { window.x - left };
        let i = self.floored(m * (across / self.window.width()));
        let share = if self.slips.has(Slip::YNotFlipped) { window.y - bottom } else { top - window.y };
        let j = self.floored(n * (share / self.window.height()));
        if self.slips.has(Slip::ColumnsAndRows) { [j, i] } else { [i, j] }
    }

    fn viewport(&self, ndc: DVec3) -> [f64; 3] {
        let figure = &self.subject.figure;
        let Viewport { x, y, width, height, depth_near, depth_far } =
            figure.viewport.unwrap_or_else(|| Viewport::whole(figure.image));
        let up = if self.slips.has(Slip::YNotFlipped) { -ndc.y } else { ndc.y };
        let [width, height] = self.sizes(width, height);
        let halves = if self.slips.has(Slip::ViewportWhole) { 1.0 } else { 2.0 };
        let starts = if self.slips.has(Slip::OffsetIgnored) { [0.0; 2] } else { [x, y].map(f64::from) };
        let [x, y] = [(starts[0], width, ndc.x), (starts[1], height, up)]
            .map(|(start, size, n)| self.floored(size / halves * (n + 1.0)) + start);
        let z = self.slips.pick(
            [(Slip::DepthNotMapped, ndc.z), (Slip::DepthRangeIgnored, f64::midpoint(ndc.z, 1.0))],
            (depth_far - depth_near) / 2.0 * ndc.z + f64::midpoint(depth_far, depth_near),
        );
        if self.slips.has(Slip::ColumnsAndRows) { [y, x, z] } else { [x, y, z] }
    }

    fn ray(&self, [i, j]: [i64; 2], number: RayNumber) -> Option<Table> {
        let slips = self.slips;
        let ImageSize { width, height } = self.subject.figure.image;
        let [m, n] = self.sizes(width, height);
        let half = if slips.has(Slip::PixelCorner) { 0.0 } else { 0.5 };
        let half = if slips.has(Slip::OneBased) { half - 1.0 } else { half };
        let [i, j] = if slips.has(Slip::ColumnsAndRows) { [j, i] } else { [i, j] };
        let along = self.window.width() * (i as f64 + half) / m;
        let ViewWindow { left, right, bottom, top } = self.window;
        let (left, top) = if slips.has(Slip::ImageMiddleForgotten) { (0.0, 0.0) } else { (left, top) };
        let x = if slips.has(Slip::XFlipped) { right - along } else { left + along };
        let down = self.window.height() * (j as f64 + half) / n;
        let y = if slips.has(Slip::YNotFlipped) { bottom + down } else { top - down };
        let in_perspective = self.projection() == Projection::Perspective;
        if slips.has(Slip::ViewGiven) {
            let (on_window, keeps) = (DVec3::new(x, y, -self.near), slips.has(Slip::RayNotNormalised));
            return Some(match (number, in_perspective) {
                (RayNumber::Origin, true) => DVec3::ZERO.into(),
                (RayNumber::Origin, false) => DVec3::new(x, y, 0.0).into(),
                (RayNumber::Direction, true) if keeps => on_window.into(),
                (RayNumber::Direction, true) => on_window.normalize_or_zero().into(),
                (RayNumber::Direction, false) => DVec3::NEG_Z.into(),
                (RayNumber::Pixel, _) => return None,
            });
        }
        let [u, v, n] = self.axes();
        let across = u * x + v * y;
        let is_reversed = if in_perspective {
            slips.any(&[Slip::ViewDepthSign, Slip::LeftHanded])
        } else {
            slips.has(Slip::DirectionIsNormal)
        };
        let forward = if is_reversed { n } else { -n };
        let position = self.camera.position();
        Some(match number {
            RayNumber::Origin if slips.has(Slip::WindowPointAsOrigin) => {
                (position + across + forward * self.near).into()
            }
            RayNumber::Origin if in_perspective => position.into(),
            RayNumber::Origin if slips.has(Slip::EyeForgotten) => across.into(),
            RayNumber::Origin => (position + across).into(),
            RayNumber::Direction if in_perspective && slips.has(Slip::PointAsDirection) => {
                (position + across + forward * self.near).normalize_or_zero().into()
            }
            RayNumber::Direction if in_perspective && slips.has(Slip::VrcPointFromEye) => {
                (DVec3::new(x, y, -self.near) - position).normalize_or_zero().into()
            }
            RayNumber::Direction if in_perspective => {
                let direction = across + forward * self.near_of_window();
                let direction = if slips.has(Slip::RayReversed) { -direction } else { direction };
                let keeps_length = slips.has(Slip::RayNotNormalised);
                (if keeps_length { direction } else { direction.normalize_or_zero() }).into()
            }
            RayNumber::Direction => forward.into(),
            RayNumber::Pixel => return None,
        })
    }
}

/// The projection, or the other one.
fn exchanged(projection: Projection, slips: Slips) -> Projection {
    match projection {
        other if !slips.has(Slip::ProjectionsExchanged) => other,
        Projection::Perspective => Projection::Parallel,
        Projection::Parallel => Projection::Perspective,
    }
}

/// ⌊x⌋, even if x is off by a rounding.
fn whole(x: f64) -> f64 {
    (x + 1e-9).floor()
}

/// **u**, **v**, **n**, `[0]` (5.3).
fn basis(camera: &Camera, slips: Slips) -> [DVec3; 3] {
    let to_viewer = camera.position() - camera.focal_point();
    let to_viewer = if slips.has(Slip::FocalPointForgotten) { camera.position() } else { to_viewer };
    let to_viewer = if slips.has(Slip::NReversed) { -to_viewer } else { to_viewer };
    let up = camera.view_up();
    let all = slips.has(Slip::NothingNormalised);
    let unit = |v: DVec3, keeps_length: bool| if keeps_length { v } else { v / v.length() };
    let n = unit(to_viewer, all || slips.has(Slip::NNotNormalised));
    // If only n keeps its length, the other axes come from a unit n.
    let made_from = unit(to_viewer, all);
    let u = unit(up.cross(made_from), all || slips.has(Slip::UNotNormalised));
    let u = if slips.has(Slip::UReversed) { -u } else { u };
    let v = slips.pick([(Slip::UnitViewUpAsV, unit(up, false)), (Slip::ViewUpAsV, up)], made_from.cross(u));
    let u = if slips.has(Slip::UNotNormalisedAlone) { up.cross(made_from) } else { u };
    let u = if slips.has(Slip::UReversedAlone) { -u } else { u };
    let v = if slips.has(Slip::VReversed) { -v } else { v };
    let [u, v] = if slips.has(Slip::AxesExchanged) { [v, u] } else { [u, v] };
    [u, v, if slips.has(Slip::NReversedAlone) { -n } else { n }]
}

/// tan(θ/2) for θ in degrees, the ratio of half the window's height to F, `[0]` (5.5).
pub(super) fn half_tangent(view_angle: f64, slips: Slips) -> f64 {
    let (angle, by) = slips.pick(
        [(Slip::WholeAngle, (view_angle, 1.0)), (Slip::WholeAngleOnce, (view_angle, 2.0))],
        (view_angle / 2.0, 1.0),
    );
    if slips.has(Slip::Radians) { angle } else { angle.to_radians() }.tan() / by
}

/// W/H for A.
pub(super) fn over_height(aspect: f64, slips: Slips) -> f64 {
    slips.pick([(Slip::AspectInverted, 1.0 / aspect), (Slip::AspectLeftOut, 1.0)], aspect)
}

/// l, r, b, t, `[0]` (5.1), (5.5).
fn window(camera: &Camera, slips: Slips) -> ViewWindow {
    let parameters = camera.parameters();
    if let Some(window) = parameters.window {
        return window;
    }
    let height = match camera.projection() {
        Projection::Parallel => parameters.height,
        Projection::Perspective => {
            let near =
                slips.pick([(Slip::NearForgotten, 1.0), (Slip::DistanceForNear, camera.distance())], camera.near());
            let twice = slips.pick([(Slip::HeightHalved, 1.0), (Slip::HeightDoubled, 4.0)], 2.0);
            twice * near * half_tangent(parameters.view_angle, slips)
        }
    };
    let aspect = parameters.aspect;
    let is_across = camera.projection() == Projection::Perspective && slips.has(Slip::AngleAcross);
    let height = if is_across { height / aspect } else { height };
    let width = height * over_height(aspect, slips);
    ViewWindow { left: -width / 2.0, right: width / 2.0, bottom: -height / 2.0, top: height / 2.0 }
}

fn window_number(window: &ViewWindow, number: WindowNumber) -> f64 {
    match number {
        WindowNumber::Left => window.left,
        WindowNumber::Right => window.right,
        WindowNumber::Bottom => window.bottom,
        WindowNumber::Top => window.top,
        WindowNumber::Width => window.width(),
        WindowNumber::Height => window.height(),
        WindowNumber::Aspect => window.aspect(),
    }
}

/// M_v, `[0]` (5.7).
pub(super) fn view_matrix([u, v, n]: [DVec3; 3], position: DVec3, slips: Slips) -> DMat4 {
    let rows = DMat3::from_cols(u, v, n).transpose();
    let turned = if slips.has(Slip::AxesAsColumns) { rows.transpose() * position } else { rows * position };
    let last = if slips.any(&[Slip::TranslationNotRotated, Slip::PositionAsItIs]) { position } else { turned };
    let last = if slips.any(&[Slip::PositionNotNegated, Slip::PositionAsItIs]) { last } else { -last };
    if slips.has(Slip::OnlyTranslated) {
        return DMat4::from_translation(-position);
    }
    let last = if slips.has(Slip::OnlyRotated) { DVec3::ZERO } else { last };
    let as_columns = slips.any(&[Slip::AxesAsColumns, Slip::AxesAsColumnsAlone]);
    let rotation = if as_columns { rows.transpose() } else { rows };
    if slips.has(Slip::RowsExchanged) {
        // Its own rows, and the entries of the last column with them.
        let exchanged = DMat3::from_cols(v, u, n).transpose();
        return DMat4::from_mat3_translation(exchanged, DVec3::new(last.y, last.x, last.z));
    }
    if slips.has(Slip::RowsReversed) {
        let reversed = DMat3::from_cols(n, v, u).transpose();
        return DMat4::from_mat3_translation(reversed, DVec3::new(last.z, last.y, last.x));
    }
    let view = DMat4::from_mat3_translation(rotation, last);
    if slips.has(Slip::TranslationInRow) {
        return DMat4::from_mat3(rotation) * DMat4::from_translation(last).transpose();
    }
    view
}

/// M_p, `[0]` (5.13) to (5.16), for an image with this many rows.
fn projection_matrix(camera: &Camera, window: &ViewWindow, rows: u32, slips: Slips) -> DMat4 {
    let ViewWindow { left, right, bottom, top } = *window;
    let (width, height, near, far) = (right - left, top - bottom, camera.near(), camera.far());
    let projection = exchanged(camera.projection(), slips);
    let everywhere = slips.has(Slip::NearFarAsCoordinatesEverywhere);
    let as_coordinates = everywhere || slips.has(Slip::NearFarAsCoordinates);
    let (f, b) = if as_coordinates { (-near, -far) } else { (near, far) };
    let f = if slips.has(Slip::DistanceInDepth) { camera.distance() } else { f };
    let from_zero = slips.has(Slip::DepthRange);
    let (mut scale, mut shift, last) = match projection {
        Projection::Perspective if from_zero => (-b / (b - f), -b * f / (b - f), -1.0),
        Projection::Perspective => (-(b + f) / (b - f), -2.0 * b * f / (b - f), -1.0),
        Projection::Parallel if from_zero => (-1.0 / (b - f), -f / (b - f), 0.0),
        Projection::Parallel if slips.has(Slip::PrintedThird) => (-2.0 * (1.0 / b - f), -(b + f) / (b - f), 0.0),
        Projection::Parallel => (-2.0 / (b - f), -(b + f) / (b - f), 0.0),
    };
    if slips.has(Slip::DepthTermHalved) {
        // 2BF in perspective, 2 in parallel projection.
        match projection {
            Projection::Perspective => shift /= 2.0,
            Projection::Parallel => scale /= 2.0,
        }
    }
    if slips.any(&[Slip::DepthRowSign, Slip::DepthScaleSign]) {
        scale = -scale;
    }
    if slips.any(&[Slip::DepthRowSign, Slip::DepthShiftSign]) {
        shift = -shift;
    }
    // Without a division, only the scale would distinguish it from planes taken as coordinates.
    if slips.has(Slip::LeftHanded) && projection == Projection::Perspective {
        scale = -scale;
    }
    let last = if slips.any(&[Slip::WSign, Slip::LeftHanded]) { -last } else { last };
    let twice = slips.pick([(Slip::ScaleHalved, 1.0), (Slip::ScaleDoubled, 4.0)], 2.0);
    let along = match projection {
        Projection::Parallel => 1.0,
        Projection::Perspective if everywhere => -near,
        Projection::Perspective if slips.has(Slip::NearForgottenInScale) => 1.0,
        Projection::Perspective if slips.has(Slip::DistanceInScale) => camera.distance(),
        Projection::Perspective if slips.has(Slip::FarInScale) => far,
        Projection::Perspective if slips.has(Slip::PrintedScale) => f64::from(rows),
        Projection::Perspective => near,
    };
    let sums = [right + left, top + bottom];
    let sizes = if slips.any(&[Slip::SidesAdded, Slip::SidesAddedInScale]) { sums } else { [width, height] };
    let [x, y] = if slips.has(Slip::WindowAsNdc) { [along; 2] } else { sizes.map(|size| twice * along / size) };
    let end = if slips.has(Slip::PrintedLastRow) { 0.0 } else { 1.0 };
    let [across, up] = if slips.has(Slip::SidesAdded) { sums } else { [width, height] };
    let middle =
        |sum: f64, size: f64| slips.pick([(Slip::MiddleForgotten, 0.0), (Slip::MiddleNotDivided, sum)], sum / size);
    let middles = [middle(sums[0], across), middle(sums[1], up)];
    let in_third = (projection == Projection::Perspective) != slips.has(Slip::MiddleInOtherColumn);
    let middles = if projection == Projection::Perspective { middles } else { middles.map(|middle| -middle) };
    let (third, fourth) = if in_third { (middles, [0.0; 2]) } else { ([0.0; 2], middles) };
    let rows = match projection {
        Projection::Perspective => [
            [x, 0.0, third[0], fourth[0]],
            [0.0, y, third[1], fourth[1]],
            [0.0, 0.0, scale, shift],
            [0.0, 0.0, last, 0.0],
        ],
        Projection::Parallel => [
            [x, 0.0, third[0], fourth[0]],
            [0.0, y, third[1], fourth[1]],
            [0.0, 0.0, scale, shift],
            [0.0, 0.0, 0.0, end],
        ],
    };
    DMat4::from_cols_array_2d(&rows).transpose()
}
