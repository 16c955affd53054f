//! The bytes that the methods of the studies keep.

use super::Study;

/// The bytes that a method keeps for one item of a study: numbers of a point, a basis, a pixel, a vertex or a map.
/// `parameter` is that of the case.
pub(super) fn bytes(study: Study, method: &str, parameter: f64) -> f64 {
    // A method's name tells its numbers. Double-double has two `f64`.
    let of_number = match method {
        _ if method.starts_with("f32") || method.starts_with("fixed-16.16") => 4.0,
        _ if method.starts_with("f16") || method.starts_with("bf16") => 2.0,
        "f64 compensated" | "double-double" | super::OWN => 16.0,
        _ => 8.0,
    };
    match study {
        Study::VertexTransform => match method {
            // Homogeneous coordinates.
            "f32 stages" => 4.0 * of_number,
            _ if method.ends_with("matrix") => 4.0 * of_number,
            "camera-lab pictures" => 3.0 * 8.0,
            _ => 3.0 * of_number,
        },
        Study::Basis => 9.0 * of_number,
        // C, PF and three axes, or a quaternion instead of these.
        Study::RepeatedOperations if method.ends_with("quaternion") => 10.0 * of_number,
        Study::RepeatedOperations => 15.0 * of_number,
        Study::DepthBuffer => match method {
            "fixed 16" | "f16 reversed" | "bf16 reversed" => 2.0,
            "fixed 24" | "logarithmic 24" => 3.0,
            _ => 4.0,
        },
        Study::Visibility => match method {
            "painter" | "bsp" => 0.0,
            "depth buffer 16" => 2.0,
            "depth buffer 24" => 3.0,
            _ => 4.0,
        },
        // A colour for each face or vertex, or a normal and a position for each vertex.
        Study::Shading if method == "phong" => 24.0,
        Study::Shading => 4.0,
        // A colour and a depth for each sample.
        Study::Antialiasing => 8.0 * samples(method),
        // The two coordinates of a corner.
        Study::Grid => 8.0,
        Study::Clipping => 8.0 * of_number,
        // A texel; in all levels of detail, a third more; or the samples of a pixel.
        Study::TextureFilter => match method {
            "16 samples of nearest" => 16.0 * 4.0,
            "trilinear" | super::OWN => 4.0 * 4.0 / 3.0,
            _ => 4.0,
        },
        // A depth for each texel of a map, of which the program's own has its usual side.
        Study::Shadows if method == super::OWN => 4.0 * f64::from(crate::scene::Shadows::CAST.map).powi(2),
        Study::Shadows => 4.0 * parameter * parameter,
        // Two ends of each line, in pixels.
        Study::Photograph => 4.0 * 8.0,
    }
}

/// The samples in a pixel of a method, which begins with their number. The program's own has four.
fn samples(method: &str) -> f64 {
    method.split(' ').next().and_then(|number| number.parse().ok()).unwrap_or(4.0)
}
