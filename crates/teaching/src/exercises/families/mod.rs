//! Families: exercises whose numbers come from a seed.

mod cameras;
mod clipping;
mod depth;
mod hands;
mod light;
mod matrices;
mod operations;
mod points;
mod spaces;
mod stereo;

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
    stereo::DISPARITY,
    light::LIGHT,
    hands::MATCH_PICTURE,
    hands::PLACE_CAMERA,
    hands::PREDICT_VISIBLE,
];
