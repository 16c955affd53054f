//! The engine's proof, in one binary.

#[path = "../../../../tests/common/engine.rs"]
mod common;

mod camera_equations;
mod camera_files;
mod camera_operations;
mod camera_parameters;
mod camera_path;
mod camera_pixels;
mod camera_properties;
mod camera_yaml;
mod meshes;
mod meshes_formats;
mod meshes_gltf;
mod meshes_obj;
mod outline;
mod page_fonts;
mod pipeline;
mod pipeline_bounds;
mod pipeline_counts;
mod pipeline_exact;
mod pipeline_plan;
mod pipeline_visibility;
mod places;
mod raster_colors;
mod raster_fill;
mod raster_lines;
mod raster_pictures;
mod raster_slivers;
mod recovery;
mod strokes;
mod textbook;
