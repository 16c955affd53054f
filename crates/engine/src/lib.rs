//! The virtual camera of computer graphics, as lecture notes teach it: cameras, scenes, the pipeline and a software rasterizer.
//!
//! | space | unit | axes |
//! | --- | --- | --- |
//! | world | scene units | right-handed, y up |
//! | view (VRC) | scene units | right-handed, x right, y up, z towards the viewer |
//! | clip | homogeneous | x, y, z in \[−w, w\] inside the volume |
//! | ndc | 1 | left-handed, −1 … 1, z into the screen |
//! | window | scene units | on the plane z_c = −F, x right, y up |
//! | image | pixels | (0, 0) is the top-left corner, y down |
//!
//! Start reading at [`camera`] for the model of the notes, and at [`pipeline`] for the way from a scene to a drawing, which
//! [`raster`] paints.

pub mod appearance;
pub mod camera;
pub mod drawing;
pub mod expression;
pub mod geometry;
pub mod lighting;
pub mod limits;
pub mod numbers;
pub mod pipeline;
pub mod progress;
pub mod raster;
pub mod sanitize;
pub mod scene;
mod simd;
pub mod stage;
pub mod text;
