//! The stages of the geometry half of the pipeline, in the order of the notes. The code lights last, when culling and
//! clipping have left the points that need it.
//!
//! | stage | from → to | file |
//! | --- | --- | --- |
//! | traverse | scene → objects | [`traverse`] |
//! | cull objects | boxes of objects | [`cull_objects`] |
//! | normals | object → view | [`normals`] |
//! | light | view → colours | [`light`], eight points at a time in [`reflection`]; the rest of a surface in [`attributes`] |
//! | transform, oblique window, divide, viewport | object → pixels | [`vertex`], in a loop in [`vertices`] |
//! | cull faces | triangles on the image | [`cull_faces`] |
//! | clip | clip | [`clip`] |
//! | hidden surfaces, without a depth buffer | view | [`hidden_surfaces`] |
//! | lines | world → pixels | [`lines`] |
//!
//! The other stages work on pixels and live in [`raster`](crate::raster).
//!
//! The loop over the vertices runs before culling and clipping, which need them on the image and their sides of the
//! planes. Corners that clipping makes follow on their own. [`faces`] holds the buffers in between, [`shadow_maps`] the
//! lights' own pictures.

pub(crate) mod attributes;
pub(crate) mod clip;
pub(crate) mod cull_faces;
pub(crate) mod cull_objects;
pub(crate) mod faces;
pub(crate) mod hidden_surfaces;
pub(crate) mod light;
pub(crate) mod lines;
pub(crate) mod normals;
pub mod reflection;
pub(crate) mod shadow_maps;
pub(crate) mod traverse;
pub(crate) mod vertex;
pub(crate) mod vertices;
