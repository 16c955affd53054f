//! The window, driven without a display.

mod canvas;
