//! Common parts of the plots of the window: they do not move, and their logarithmic axes are marked at powers of ten.

use std::ops::RangeInclusive;

use egui_plot::{GridInput, GridMark, Plot};

use crate::chart::power_of_ten;

/// A plot that neither moves nor zooms, and shows no coordinates of its own: the values under the pointer are shown
/// beside it.
pub(super) fn still(plot: Plot<'_>) -> Plot<'_> {
    plot.show_x(false).show_y(false).allow_drag(false).allow_zoom(false).allow_scroll(false).allow_boxed_zoom(false)
}

/// The mark of a whole decade on an axis of logarithms; none between.
pub(super) fn decade(mark: GridMark, _: &RangeInclusive<f64>) -> String {
    if mark.value.fract() == 0.0 { power_of_ten(10f64.powf(mark.value)) } else { String::new() }
}

/// The lines of an axis of logarithms, for a [`uniform_grid_spacer`](egui_plot::uniform_grid_spacer).
pub(super) fn decades(_: GridInput) -> [f64; 3] {
    [10.0, 5.0, 1.0]
}
