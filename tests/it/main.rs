//! The contract, the pictures and the layers, in one binary.

#[path = "../common/mod.rs"]
mod common;

mod accuracy;
mod camera_equations;
mod camera_extreme;
mod camera_operations;
mod camera_parameters;
mod camera_pixels;
mod camera_properties;
mod cli;
mod composition;
mod contract;
mod depth_in_view;
mod explain;
mod export;
mod figure;
mod guides;
mod hostile;
mod image_pixels;
mod inspect_report;
mod layers;
mod meshes;
mod meshes_gltf;
mod meshes_obj;
mod ndc;
mod outline;
mod pipeline;
mod pipeline_bounds;
mod pipeline_counts;
mod pipeline_exact;
mod pipeline_plan;
mod pipeline_project;
mod pipeline_visibility;
mod raster_colors;
mod raster_fill;
mod raster_lines;
mod raster_pictures;
mod raster_slivers;
mod reveal;
mod scene;
mod stages;
mod stroke_runs;
mod views;
mod views_pictures;
