//! The camera as the pipeline applies it, point by point: object → world → view → clip, in `f64`.

use glam::{DMat3, DMat4, DVec3, DVec4};

use super::depths::{DepthScale, Sheet};
use super::{FromEye, ObjectPoint, ViewPoint, WorldPoint};
use crate::appearance::VertexFormat;
use crate::camera::{Basis, Camera, Projection};

/// The camera as the pipeline applies it, point by point.
#[derive(Clone, Debug)]
pub(crate) struct Projector {
    position: DVec3,
    basis: Basis,
    pub(crate) projection: Projection,
    /// F.
    pub(crate) near: f64,
    /// B.
    pub(crate) far: f64,
    /// `x_clip = scale[0] · x_view − shift[0] · w`, the same for y. The shift is 0 for a symmetric window.
    pub(crate) scale: [f64; 2],
    pub(crate) shift: [f64; 2],
    /// The scale of the depths of the display list: of the range from F to B, unless a picture has less in view.
    pub(crate) depths: DepthScale,
    /// The format to which positions are rounded.
    pub(crate) format: VertexFormat,
    /// The display of a scene that is thin in NDC.
    pub(crate) sheet: Option<Sheet>,
}

impl Projector {
    /// Takes from `camera` the coefficients of `[0]` Eqs. (5.13) and (5.15).
    pub(crate) fn new(camera: &Camera) -> Self {
        let window = camera.window();
        let projection = camera.projection();
        let reach = if projection.is_perspective() { 2.0 * camera.near() } else { 2.0 };
        Self {
            position: camera.position(),
            basis: camera.basis(),
            projection,
            near: camera.near(),
            far: camera.far(),
            scale: [reach / window.width(), reach / window.height()],
            depths: DepthScale::of_volume(projection, camera.near(), camera.far()),
            format: VertexFormat::F64,
            sheet: None,
            shift: [(window.right + window.left) / window.width(), (window.top + window.bottom) / window.height()],
        }
    }

    /// A world point in view space. C is subtracted before anything is rotated.
    pub(crate) fn view(&self, p: WorldPoint) -> ViewPoint {
        ViewPoint(self.view_vector(p.0 - self.position))
    }

    /// A world vector in view space.
    pub(crate) fn view_vector(&self, d: DVec3) -> DVec3 {
        DVec3::new(self.basis.u.dot(d), self.basis.v.dot(d), self.basis.n.dot(d))
    }

    /// The direction in view space in which the distance from a plane of the volume grows, and how fast.
    pub(crate) fn gradient(&self, plane: usize) -> DVec3 {
        // The part of w, which is −z_c or constant.
        let w = if self.projection.is_perspective() { DVec3::NEG_Z } else { DVec3::ZERO };
        let across = |axis: usize, unit: DVec3| unit * self.scale[axis] - w * self.shift[axis];
        match plane {
            0 => w + across(0, DVec3::X),
            1 => w - across(0, DVec3::X),
            2 => w + across(1, DVec3::Y),
            3 => w - across(1, DVec3::Y),
            4 => DVec3::NEG_Z,
            _ => DVec3::Z,
        }
    }

    /// The way from the space of an object to view space.
    pub(crate) fn view_from_object(&self, world_from_object: DMat4) -> ViewFromObject {
        let linear = DMat3::from_mat4(world_from_object);
        let translation = world_from_object.w_axis.truncate();
        let Basis { u, v, n } = self.basis;
        let view_from_world = DMat3::from_cols(u, v, n).transpose();
        let inverse = linear.inverse();
        let determinant = linear.determinant();
        let seen_from = if self.projection.is_perspective() {
            (inverse * (self.position - translation)).extend(1.0)
        } else {
            (inverse * n).extend(0.0)
        };
        // With the eye in object space, one subtraction and one 3×3 product take a vertex to view space, and objects
        // far from the origin lose nothing. The inverse costs digits if the scales along the axes differ wildly.
        let condition = norm(linear) * norm(inverse);
        let format = self.format;
        if determinant != 0.0 && condition < 1e3 && format == VertexFormat::F64 {
            ViewFromObject {
                eye: inverse * (self.position - translation),
                linear: view_from_world * linear,
                through_world: None,
                rest: condition * condition * (self.position - translation).length(),
                determinant,
                seen_from,
                format,
            }
        } else {
            ViewFromObject {
                eye: self.position,
                linear: view_from_world,
                through_world: Some((linear, translation)),
                rest: 0.0,
                determinant,
                seen_from,
                format,
            }
        }
    }
}

/// A point in a format.
#[inline(always)]
pub(crate) fn rounded(format: VertexFormat, p: DVec3) -> DVec3 {
    if format == VertexFormat::F64 { p } else { p.to_array().map(|x| format.round(x)).into() }
}

fn norm(m: DMat3) -> f64 {
    m.to_cols_array().iter().fold(0.0, |sum, c| sum + c * c).sqrt()
}

/// Object space → view space.
#[derive(Clone, Debug)]
pub(crate) struct ViewFromObject {
    eye: DVec3,
    /// Takes [`offset_from_eye`](Self::offset_from_eye) to view space.
    pub(crate) linear: DMat3,
    /// Model matrix, if the eye couldn't be taken to object space.
    through_world: Option<(DMat3, DVec3)>,
    /// The size of the numbers that taking the eye to object space adds to these. The inverse of the model matrix is
    /// known to as many digits as its condition leaves, and so is its product with C.
    pub(crate) rest: f64,
    /// Determinant of the model matrix: negative if it mirrors.
    determinant: f64,
    /// The format to which positions are rounded, in the world and in view space. Not `f64` only on the way through the
    /// world.
    pub(crate) format: VertexFormat,
    /// The eye in object space, homogeneous: a point, or in parallel projection the direction towards it (w = 0). Not
    /// finite for a flattened object.
    pub(crate) seen_from: DVec4,
}

impl ViewFromObject {
    /// The way from the eye to a point of the object, before [`transform`] rotates it to view space.
    ///
    /// [`transform`]: crate::pipeline::stage::vertex::transform
    #[inline(always)]
    pub(crate) fn offset_from_eye(&self, ObjectPoint(p): ObjectPoint) -> FromEye {
        FromEye(match self.through_world {
            None => p - self.eye,
            Some((linear, translation)) => rounded(self.format, linear * p + translation) - self.eye,
        })
    }

    /// [`offset_from_eye`](Self::offset_from_eye) for a block of points, coordinate by coordinate.
    #[inline(always)]
    pub(crate) fn offsets_from_eye(&self, given: &[DVec3], [x, y, z]: [&mut [f64; BLOCK]; 3]) {
        // The same loop twice, so that neither asks for each point which of the two it is.
        match self.through_world {
            None => {
                for (l, &p) in given.iter().enumerate().take(BLOCK) {
                    let d = p - self.eye;
                    (x[l], y[l], z[l]) = (d.x, d.y, d.z);
                }
            }
            Some(_) => {
                for (l, &p) in given.iter().enumerate().take(BLOCK) {
                    let FromEye(d) = self.offset_from_eye(ObjectPoint(p));
                    (x[l], y[l], z[l]) = (d.x, d.y, d.z);
                }
            }
        }
    }

    /// The size of the numbers from which the view coordinates of `p` are summed up: the scale of their rounding
    /// errors.
    pub(crate) fn magnitude(&self, p: DVec3) -> f64 {
        match self.through_world {
            None => norm(self.linear) * (p - self.eye).length(),
            Some((linear, translation)) => norm(linear) * p.length() + translation.length() + self.eye.length(),
        }
    }

    /// The slope in the object's space of a linear function of view space with this gradient.
    pub(crate) fn slope(&self, gradient: DVec3) -> f64 {
        let linear = match self.through_world {
            None => self.linear,
            Some((linear, _)) => self.linear * linear,
        };
        (linear.transpose() * gradient).length()
    }

    /// The whole way to view space as a matrix.
    pub(crate) fn matrix(&self) -> DMat4 {
        let view_from_world = DMat4::from_mat3(self.linear) * DMat4::from_translation(-self.eye);
        match self.through_world {
            None => view_from_world,
            Some((linear, translation)) => {
                view_from_world * DMat4::from_translation(translation) * DMat4::from_mat3(linear)
            }
        }
    }

    /// True if the object is mirrored, so that its triangles turn the other way round.
    pub(crate) fn mirrored(&self) -> bool {
        self.determinant < 0.0
    }

    /// −1 if the object is mirrored, else 1: the factor that makes of (b − a) × (c − a) the outer normal of a
    /// triangle.
    pub(crate) fn outward(&self) -> f64 {
        if self.mirrored() { -1.0 } else { 1.0 }
    }

    /// The matrix for normals: cofactors of the linear part (the inverse transpose times the determinant, which a
    /// flattened object has too), with the sign that keeps normals outside.
    pub(crate) fn normal_matrix(&self) -> DMat3 {
        let m = match self.through_world {
            None => self.linear,
            Some((linear, _)) => self.linear * linear,
        };
        let cofactors = DMat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis));
        if self.mirrored() { cofactors * -1.0 } else { cofactors }
    }
}

/// Vertices that are taken from space to space together: an array for each coordinate, so that the loops over them
/// become vector instructions.
pub(crate) const BLOCK: usize = 32;
