//! Tools on meshes that several stages share: bounds, cutting, new meshes from old ones, outlines.

pub(crate) mod bounds;
pub(crate) mod chunks;
pub(crate) mod cut;
pub(crate) mod outline;
pub(crate) mod resample;
