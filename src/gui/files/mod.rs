//! The file of the figure while another program may change it: checking it, and comparing the texts.

pub mod comparison;
pub(super) mod watch;
