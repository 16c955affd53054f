//! Words in the pictures: labels and their layout, captions, the legend.

pub(super) mod author_labels;
pub(super) mod caption_strip;
pub(super) mod coverage_grid;
pub(super) mod label_layout;
pub(super) mod label_names;
pub(super) mod label_obstacles;
pub(super) mod labels;
pub(super) mod legend;
pub(super) mod note_place;
pub(super) mod values;
