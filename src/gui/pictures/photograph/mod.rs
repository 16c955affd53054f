//! The camera of the photograph, from lines drawn on it along the axes of the world.

mod card;
mod lines;
