//! The place of a point in the texture of its surface.

use glam::DVec3;

use crate::appearance::{Texture, Wrap};
use crate::camera::Camera;
use crate::scene::{ObjectPaint, Scene};
use crate::views::interact::hits::triangle_hit;

/// A point off a surface by less than this share of its distance from C counts as on it.
const NEAR: f64 = 1e-4;

/// The place of a point in a texture.
#[derive(Clone, Debug, PartialEq)]
pub struct TexelAt {
    /// The object of the figure.
    pub object: String,
    /// u to the right, v upwards.
    pub uv: [f64; 2],
    /// The nearest texel: column and row, from the top left.
    pub texel: [u32; 2],
    /// Width and height of the texture in texels.
    pub size: [u32; 2],
}

/// The texture at a point (world), if it's on a surface that has one.
pub fn texel_at(scene: &Scene, camera: &Camera, p: DVec3) -> Option<TexelAt> {
    // A segment through the point, along the line from C.
    let reach = (p - camera.position()) * NEAR;
    let (from, to) = (p - reach, p + reach);
    let textured = scene.objects.iter().filter_map(|object| match &object.paint {
        ObjectPaint::Texture(pictured) => Some((object, pictured)),
        ObjectPaint::Solid(_) | ObjectPaint::Faces(_) | ObjectPaint::Vertices(_) => None,
    });
    textured.filter(|(object, _)| object.faces).find_map(|(object, pictured)| {
        let (_, index) = triangle_hit(object, from, to, false)?;
        let triangle = *object.mesh.triangles.get(index as usize)?;
        let place = object.world_from_object.inverse().transform_point3(p);
        let corner = |k: usize| object.mesh.positions.get(triangle[k] as usize).copied();
        let weights = barycentric(place, [corner(0)?, corner(1)?, corner(2)?])?;
        let mut uv = [0.0; 2];
        for (i, weight) in triangle.into_iter().zip(weights) {
            let own = pictured.uv.get(i as usize)?;
            uv = [uv[0] + weight * f64::from(own[0]), uv[1] + weight * f64::from(own[1])];
        }
        let image: &Texture = &pictured.image;
        let size = [image.width(), image.height()];
        let wraps = [pictured.sampler.wrap_u, pictured.sampler.wrap_v];
        let texel = [0, 1].map(|axis| texel(uv[axis], wraps[axis], size[axis]));
        Some(TexelAt { object: object.owner().to_owned(), uv: [uv[0], 1.0 - uv[1]], texel, size })
    })
}

/// The shares of three corners in a point of their plane.
fn barycentric(p: DVec3, [a, b, c]: [DVec3; 3]) -> Option<[f64; 3]> {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let normal = ab.cross(ac);
    let square = normal.length_squared();
    if square == 0.0 {
        return None;
    }
    let (s, t) = (ap.cross(ac).dot(normal) / square, ab.cross(ap).dot(normal) / square);
    Some([1.0 - s - t, s, t])
}

/// The nearest texel on an axis.
fn texel(t: f64, wrap: Wrap, size: u32) -> u32 {
    let folded = match wrap {
        Wrap::Clamp => t,
        Wrap::Repeat => t - t.floor(),
        Wrap::Mirror => {
            let twice = t - 2.0 * (0.5 * t).floor();
            if twice > 1.0 { 2.0 - twice } else { twice }
        }
    };
    #[expect(clippy::cast_possible_truncation, reason = "clamped; NaN is 0")]
    let index = (folded * f64::from(size)).clamp(0.0, f64::from(size)) as u32;
    index.min(size.saturating_sub(1))
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

    use super::*;
    use crate::appearance::Style;
    use crate::camera::Parameters;
    use crate::scene::{ObjectSpec, Preset, SceneSpec, Shape, TextureSource, build, no_files};

    #[test]
    fn a_point_on_a_face_has_its_texel_and_one_beside_it_has_none() {
        let cube = ObjectSpec { texture: Some(TextureSource::Letters), ..ObjectSpec::new("cube", Shape::Box) };
        let spec = SceneSpec { preset: Preset::Empty, objects: vec![cube.scaled(2.0, 2.0, 2.0)], lights: Vec::new() };
        let scene = build(&spec, &Style::default(), &mut no_files).unwrap();
        let position = DVec3::new(1.0, 2.0, 9.0);
        let camera = Camera::new(&Parameters { position, ..Parameters::default() }).unwrap();
        // On +z: u = (x/2 + 1)/2, v = (y/2 + 1)/2; 288 texels, rows from the top.
        let at = texel_at(&scene, &camera, DVec3::new(1.0, -1.0, 2.0)).unwrap();
        assert_eq!((at.object.as_str(), at.size, at.texel), ("cube", [288, 288], [216, 216]));
        assert!((at.uv[0] - 0.75).abs() < 1e-6 && (at.uv[1] - 0.25).abs() < 1e-6, "{:?}", at.uv);
        assert_eq!(texel_at(&scene, &camera, DVec3::new(1.0, -1.0, 2.1)), None);
    }
}
