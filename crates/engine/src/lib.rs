//! The virtual camera of computer graphics, as lecture notes teach it: cameras, scenes, the pipeline and a software
//! rasterizer.
//!
//! | space | unit | axes |
//! | --- | --- | --- |
//! | object | of its own | local coordinates, before the model matrix |
//! | world | scene units | right-handed, y up |
//! | view (VRC) | scene units | right-handed, x right, y up, z towards the viewer |
//! | clip | homogeneous | x, y, z in \[−w, w\] inside the volume |
//! | ndc | 1 | left-handed, −1 … 1, z into the screen |
//! | window | scene units | on the plane z_c = −F, x right, y up |
//! | image | pixels | (0, 0) is the top-left corner, y down |
//!
//! Start with [`raster::textbook`], a whole rasterizer without tricks, and with [`camera`] for the model of the notes.
//! [`pipeline`] leads from a scene to a drawing, which [`raster`] paints.
//!
//! Without the feature `import` there is no glTF, no texture from a file, and no camera in JSON or YAML. Without `text`
//! an image has no labels. The README has the limitations.
//!
//! # A mesh on an image
//!
//! A scene is built from a spec, the pipeline turns it into a [`drawing::Drawing`] in pixels with depths, and the
//! rasterizer paints that. The engine reads no files: the caller hands in the bytes of the mesh.
//!
//! ```
//! use camera_lab_engine::appearance::{Rgba, Style};
//! use camera_lab_engine::camera::{Camera, Parameters};
//! use camera_lab_engine::pipeline::{Options, Pipeline, Target};
//! use camera_lab_engine::raster::Rasterizer;
//! use camera_lab_engine::scene::{ObjectSpec, Preset, SceneSpec, Shape, build};
//!
//! let obj = "v -1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
//! let mesh = ObjectSpec::new("triangle", Shape::Mesh { path: "triangle.obj".to_owned() });
//! let spec = SceneSpec { preset: Preset::Empty, objects: vec![mesh], lights: Vec::new() };
//! let style = Style::default();
//! let scene = build(&spec, &style, &mut |_| Ok(obj.as_bytes().to_vec()))?;
//! let camera = Camera::new(&Parameters::default())?;
//! let white = Rgba::rgb(255, 255, 255);
//! let target = Target { width: 320, height: 240, scale: 1.0, background: white };
//! let frame = Pipeline::default().frame(&scene, &camera, target, &style, Options::default());
//! let image = Rasterizer::default().paint(&frame.drawing).expect("a small image");
//! assert!(image.pixels().iter().any(|pixel| pixel.red() != 255));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A point from world to pixel
//!
//! ```
//! use camera_lab_engine::camera::{Camera, ImageSize, Parameters, Viewport};
//! use glam::{DVec2, DVec3};
//!
//! let position = DVec3::new(0.0, 0.0, 5.0);
//! let camera = Camera::new(&Parameters { position, view_angle: 90.0, near: 1.0, far: 3.0, aspect: 1.0, ..Parameters::default() })?;
//! let image = ImageSize { width: 100, height: 100 };
//! let p = camera.stations(DVec3::new(1.0, -1.0, 3.0), image, &Viewport::whole(image));
//! assert_eq!(p.view, DVec3::new(1.0, -1.0, -2.0)); // M_v, `[0]` (5.7)
//! assert_eq!(p.clip.w, 2.0); // M_p, (5.14): the distance from the plane through the eye
//! let projected = p.projected.expect("w isn't 0");
//! assert_eq!(projected.ndc, DVec3::new(0.5, -0.5, 0.5)); // x, y and z divided by w, (5.6)
//! assert_eq!(projected.pixel, DVec2::new(75.0, 75.0)); // (5.22)
//! # Ok::<(), camera_lab_engine::camera::CameraError>(())
//! ```

pub use glam;
pub use tiny_skia;

pub mod appearance;
pub mod camera;
pub mod chain;
pub mod drawing;
pub mod expression;
pub mod geometry;
pub mod lighting;
pub mod limits;
mod listed;
pub mod numbers;
pub mod pipeline;
pub mod progress;
pub mod raster;
pub mod sanitize;
pub mod scene;
mod simd;
pub mod stage;
pub mod text;

/// Runs the examples of the README.
#[cfg(all(doctest, feature = "import"))]
#[doc = include_str!("../README.md")]
pub struct Readme;

#[cfg(test)]
mod tests {
    /// Compiles only if values of a type may move to another thread, and be shared with it.
    const fn crosses_threads<T: Send + Sync>() {}

    #[test]
    fn values_cross_threads() {
        crosses_threads::<crate::camera::Camera>();
        crosses_threads::<crate::camera::CameraError>();
        crosses_threads::<crate::camera::Pasted>();
        crosses_threads::<crate::camera::Recognised>();
        crosses_threads::<crate::drawing::Drawing>();
        crosses_threads::<crate::pipeline::Frame>();
        crosses_threads::<crate::pipeline::Pipeline>();
        crosses_threads::<crate::progress::Progress>();
        crosses_threads::<crate::raster::Rasterizer>();
        crosses_threads::<crate::scene::MeshError>();
        crosses_threads::<crate::scene::MeshFiles>();
        crosses_threads::<crate::scene::Scene>();
        crosses_threads::<crate::scene::SceneError>();
        crosses_threads::<crate::scene::SceneSpec>();
    }
}
