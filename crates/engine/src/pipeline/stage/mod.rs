//! The stages that run in the geometry half of the pipeline, one file each, in the order of the
//! notes:
//!
//! | stage | from → to | file |
//! | --- | --- | --- |
//! | traverse | scene → objects | [`traverse`] |
//! | cull objects | boxes of objects | [`cull_objects`] |
//! | normals | object → view | [`normals`] |
//! | light | view → colours | [`light`], eight points at a time in [`reflection`] |
//! | transform | object → world → view | [`transform`] |
//! | – projection of a symmetric window | view → clip | [`project`] |
//! | oblique window | clip | [`oblique`] |
//! | cull faces | triangles on the image | [`cull_faces`] |
//! | clip | clip | [`clip`] |
//! | divide | clip → NDC | [`divide`] |
//! | viewport | NDC → pixels | [`viewport`] |
//! | hidden surfaces, without a depth buffer | view | [`hidden_surfaces`] |
//! | lines | world → pixels | [`lines`] |
//!
//! The other stages work on pixels and live in [`raster`](crate::raster).
//!
//! A vertex goes through transform, projection, oblique window, divide and viewport in one loop, in [`vertices`]. The
//! loop runs before culling and clipping, which need the vertices on the image and their sides of the planes. Corners
//! that clipping makes follow on their own. [`faces`] holds the buffers in between, [`shadow_maps`] the lights'
//! own pictures.

pub(crate) mod clip;
pub(crate) mod cull_faces;
pub(crate) mod cull_objects;
pub(crate) mod divide;
pub(crate) mod faces;
pub(crate) mod hidden_surfaces;
pub(crate) mod light;
pub(crate) mod lines;
pub(crate) mod normals;
pub(crate) mod oblique;
pub(crate) mod project;
pub mod reflection;
pub(crate) mod shadow_maps;
pub(crate) mod transform;
pub(crate) mod traverse;
pub(crate) mod vertices;
pub(crate) mod viewport;
