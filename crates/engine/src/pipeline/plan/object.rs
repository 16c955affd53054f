//! The plan for an object, and its result.

use crate::pipeline::space::PlaneSet;
use crate::pipeline::space::depths::InView;
use crate::scene::{FoundLight, Object, ObjectPaint};

/// The place of an object, as far as the box and the ball around it tell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Containment {
    /// No vertices.
    #[default]
    Empty,
    /// No point of it is in the volume. All of it is outside each of these planes.
    Outside(PlaneSet),
    /// All of it is inside all planes but these, which it may cross.
    Crosses(PlaneSet),
}

/// The verdict of box and ball on an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    pub(crate) containment: Containment,
    /// The distances between which parts of it may be in the volume.
    pub(crate) in_view: InView,
}

/// The place of the light computation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LitAt {
    /// Nowhere. It shows its own colours.
    #[default]
    Nowhere,
    /// Once for each face.
    Faces,
    /// Once for each vertex.
    Vertices,
    /// Once for each pixel.
    Pixels,
}

/// The plan of one object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ObjectPlan {
    /// The place of its bounding box.
    pub containment: Containment,
    /// True if it's drawn. Otherwise the other fields are meaningless.
    pub drawn: bool,
    /// The planes that its faces are clipped against.
    pub clip_planes: PlaneSet,
    /// Its faces are drawn.
    pub faces: bool,
    /// Its back faces are dropped, unless the near plane cuts it open.
    pub cull_back: bool,
    /// The place of the light computation.
    pub lit: LitAt,
    /// Shadows may fall on it.
    pub shadowed: bool,
    /// Something shows through it.
    pub translucent: bool,
    /// Each pixel takes its colour from the object's picture, which has more than one colour.
    pub textured: bool,
}

impl ObjectPlan {
    /// True if a value is interpolated over the faces, so that 1/w is needed.
    pub(crate) fn interpolates(&self, object: &Object) -> bool {
        match self.lit {
            _ if self.shadowed => true,
            LitAt::Vertices | LitAt::Pixels => true,
            LitAt::Faces => matches!(object.paint, ObjectPaint::Texture(_)),
            LitAt::Nowhere => matches!(object.paint, ObjectPaint::Vertices(_) | ObjectPaint::Texture(_)),
        }
    }

    /// True if the triangles of the mesh have colours, their own or those of their light, so that each remaining face
    /// must know its triangle.
    pub(crate) fn colors_faces(&self, object: &Object) -> bool {
        // A shadow knows the plane of each face.
        let found = object.in_world.as_ref().map(|in_world| &in_world.light);
        self.shadowed
            || self.lit == LitAt::Faces
            || matches!(object.paint, ObjectPaint::Faces(_))
            || matches!(found, Some(FoundLight::Faces(_)))
    }
}

/// The report of one object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectReport {
    /// The place of its bounding box.
    pub containment: Containment,
    /// The treatment of its faces.
    pub faces: FacesDone,
    /// The place of the light computation.
    pub lit: LitAt,
    /// Triangles that are in the picture.
    pub triangles: usize,
}

/// The treatment of the faces of an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FacesDone {
    /// Not drawn, or without faces.
    NotDrawn,
    /// Those that turn their back were dropped.
    BackDropped,
    /// Both sides may be seen, because it is two-sided or translucent.
    BothSides,
    /// Both sides may be seen, because the near plane cuts it open.
    CutOpen,
}

/// The plan of an object that isn't drawn.
impl From<Containment> for ObjectPlan {
    fn from(containment: Containment) -> Self {
        Self { containment, ..Self::default() }
    }
}

/// The report of an object of which nothing is drawn yet.
impl From<Containment> for ObjectReport {
    fn from(containment: Containment) -> Self {
        Self { containment, faces: FacesDone::NotDrawn, lit: LitAt::Nowhere, triangles: 0 }
    }
}
