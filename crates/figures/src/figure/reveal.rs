//! The inner work of the pipeline that pictures show: the `[reveal]` section of a figure.

use crate::appearance::TextureReveal;

/// The `[reveal]` section: stages of the pipeline made visible in the pictures. The default shows nothing of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Reveal {
    /// The image shows depths instead of colours.
    pub depth: Depth,
    /// Drawing of the parts of the scene outside the view volume.
    pub outside: Outside,
    /// Marks the vertices that clipping makes in all three pictures.
    pub clipping: bool,
    /// The canonical volume and the image show the result of dividing by w before clipping `[2]`.
    pub divide_first: bool,
    /// The world shows the objects and faces that culling drops for the camera.
    pub culled: bool,
    /// World and image show where the scene's directions x, y, z vanish, with the construction `[4]`.
    pub vanishing: bool,
    /// The image is the one of a pipeline in single precision, for the model and view matrix, and their points.
    pub single_precision: bool,
    /// The inner work of texturing.
    pub texture: Option<TextureReveal>,
    /// The inner work of shadows.
    pub shadows: Option<ShadowReveal>,
    /// The image is tinted with the cost of each pixel.
    pub cost: Option<CostReveal>,
}

crate::worded! {
    /// The price of a pixel, or its error (`[reveal] cost`).
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum CostReveal {
        /// How often it was filled, on average over its samples.
        Overdraw = "overdraw",
        /// The operations and memory accesses of all stages that work on pixels.
        Operations = "operations",
        /// The distance between the stored depth and the exact one, by the grid of vertices and the depth format.
        Rounding = "rounding",
        /// The greatest difference of a channel from the exact image, of 255.
        Error = "error",
    }
    /// Its name in a figure file.
    pub fn name
}

/// The inner work of shadows, made visible (`[reveal] shadows`). With each of them the volume of the light appears in
/// the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ShadowReveal {
    /// The image is that of the first light that casts shadows, with the distances from it.
    Map,
    /// The pictures have no bias.
    Acne,
    /// The image marks the pixels where rays to the lights contradict the shadow maps.
    Truth,
}

/// The depths that the image shows, if any (`[reveal] depth`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Depth {
    /// Colours, as always (`false`).
    #[default]
    Off,
    /// Z as stored in the depth buffer, `[0]` Eq. (5.25), grey from 0 (black) to 1 (white) (`true`).
    Stored,
    /// The distance from the eye along DOP, grey from F (black) to B (white) (`"linear"`).
    Linear,
}

/// Drawing of the parts outside the view volume (`[reveal] outside`), in the world and in the canonical volume.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Outside {
    /// Shown in the world, cut in the canonical volume (no key).
    #[default]
    Usual,
    /// Cut off at the planes.
    Cut,
    /// Shown as coloured glass.
    Tinted,
    /// Shown as it is.
    Shown,
}
