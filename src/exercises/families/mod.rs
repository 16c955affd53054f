//! Families: exercises whose numbers come from a seed.
//!
//! | file | purpose |
//! | --- | --- |
//! | `cameras` | cameras whose numbers can be computed with pencil and paper |
//! | `clipping` | clipping before the division by w, `[2]` |
//! | `depth` | depth: the resolution of a depth buffer, the painter's order |
//! | `hands` | exercises done by hand: a camera to set, and the answer before it is shown |
//! | `light` | light on a vertex, `[2]`, `[3]` §1.8 |
//! | `matrices` | the axes of a camera, its window, and its matrices |
//! | `operations` | the operations on a camera, `[0]` §5.6 |
//! | `points` | points on their way into the image, and pixels on their way back |
//! | `spaces` | other vocabularies and orders: `[3]`, OpenGL, K, products of transforms |

mod cameras;
mod clipping;
mod depth;
mod hands;
mod light;
mod matrices;
mod operations;
mod points;
mod spaces;

use super::Entry;

/// All families, in the order in which they are learnt.
pub static ENTRIES: &[Entry] = &[
    matrices::BASIS,
    matrices::VIEW_MATRIX,
    matrices::WINDOW,
    matrices::PERSPECTIVE_MATRIX,
    matrices::PARALLEL_MATRIX,
    matrices::ASYMMETRIC_WINDOW,
    points::NDC,
    points::INSIDE,
    points::PIXEL,
    points::RAY,
    points::VIEWPORT,
    operations::ELEVATION,
    operations::AZIMUTH,
    operations::ROLL,
    operations::YAW,
    operations::PITCH,
    operations::ZOOM,
    operations::DOLLY,
    operations::PAN,
    depth::ZOOM_OR_DOLLY,
    hands::CANONICAL_CAMERA,
    clipping::OUTCODES,
    clipping::CLIP_SEGMENT,
    spaces::PYRAMID,
    spaces::LEFT_HANDED,
    spaces::VOCABULARY,
    spaces::ORDER,
    depth::DEPTH_RESOLUTION,
    depth::PAINTER,
    light::LIGHT,
    hands::MATCH_PICTURE,
    hands::PLACE_CAMERA,
    hands::PREDICT_VISIBLE,
];
