//! The nearest opaque face at any place of an image, in `f64`.
//!
//! The textbook way is a ray for each pixel and a tree of boxes over the triangles. All rays of a camera go through its
//! image, so a grid over the image is enough. Each tile lists the triangles whose projections touch it, and a ray tries
//! those of its tile. That takes a tenth of the time, so every pixel can be compared.

use glam::DVec3;

use crate::camera::{Camera, ImageSize, Projection};
use crate::geometry::ray_meets_triangle;
use crate::scene::Object;

/// Side of a tile in pixels.
const TILE: f64 = 16.0;
/// Entries of all lists: 128 MiB.
const MAX_LISTED: usize = 1 << 25;
/// Places up to this far outside a tile are looked up in it, in pixels.
const MARGIN: f64 = 1.0;

/// Triangles in view space (VRC), by tiles of the image.
pub struct Tiles<'a> {
    camera: &'a Camera,
    image: ImageSize,
    triangles: Vec<Triangle>,
    /// Tiles in a row.
    across: usize,
    tiles: Vec<Vec<u32>>,
}

struct Triangle {
    /// View space.
    corners: [DVec3; 3],
    /// The only drawn side: `true` if its corners run counter-clockwise on it.
    side: Option<bool>,
}

/// The nearest face at a place.
#[derive(Clone, Copy)]
pub struct Nearest {
    /// Its number among all triangles.
    pub triangle: usize,
    /// Its distance from the plane of the eye.
    pub depth: f64,
}

/// A ray in view space. Its points are origin + depth · `per_depth`.
struct DepthRay {
    origin: DVec3,
    per_depth: DVec3,
}

impl<'a> Tiles<'a> {
    /// `None` if the lists of the tiles would be too long.
    pub fn new<'o>(objects: impl Iterator<Item = &'o Object>, camera: &'a Camera, image: ImageSize) -> Option<Self> {
        let [across, down] = [image.width, image.height].map(|side| tile(f64::from(side)) + 1);
        let mut tiles = Self { camera, image, triangles: Vec::new(), across, tiles: vec![Vec::new(); across * down] };
        let mut room = MAX_LISTED;
        for object in objects {
            tiles.add(object, &mut room)?;
        }
        Some(tiles)
    }

    /// Adds the faces of an object; `None` if there is no `room` for them.
    fn add(&mut self, object: &Object, room: &mut usize) -> Option<()> {
        let view = |&p: &DVec3| self.camera.view_point(object.world_from_object.transform_point3(p));
        let points: Vec<DVec3> = object.mesh.positions.iter().map(view).collect();
        let mirrored = object.world_from_object.determinant() < 0.0;
        let side = (!object.two_sided && !object.mesh.closed).then_some(!mirrored);
        for triangle in &object.mesh.triangles {
            let corners = triangle.map(|i| points.get(i as usize).copied().unwrap_or(DVec3::NAN));
            let number = u32::try_from(self.triangles.len()).unwrap_or(u32::MAX);
            self.triangles.push(Triangle { corners, side });
            let Some([low, high]) = self.bounds(corners) else { continue };
            *room = room.checked_sub((high[0] - low[0] + 1) * (high[1] - low[1] + 1))?;
            for row in low[1]..=high[1] {
                for column in low[0]..=high[0] {
                    if let Some(tile) = self.tiles.get_mut(row * self.across + column) {
                        tile.push(number);
                    }
                }
            }
        }
        Some(())
    }

    /// The first and the last tile that a triangle touches, column and row; `None` if it can't be seen.
    fn bounds(&self, corners: [DVec3; 3]) -> Option<[[usize; 2]; 2]> {
        let size = [self.image.width, self.image.height].map(f64::from);
        let depths = corners.map(|p| -p.z);
        if !corners.iter().all(|p| p.is_finite()) || depths.iter().all(|&d| d < self.camera.near()) {
            return None;
        }
        let whole = [[0, 0], size.map(tile)];
        let perspective = self.camera.projection() == Projection::Perspective;
        if perspective && depths.iter().any(|&d| d < self.camera.near()) {
            // Its projection has no bounds.
            return Some(whole);
        }
        let places = corners.map(|p| self.place(p));
        let bound = |axis: usize| {
            let [a, b, c] = places.map(|place| place[axis]);
            [a.min(b).min(c) - MARGIN, a.max(b).max(c) + MARGIN]
        };
        let [x, y] = [bound(0), bound(1)];
        if x[1] < 0.0 || y[1] < 0.0 || x[0] > size[0] || y[0] > size[1] {
            return None;
        }
        Some([[tile(x[0]), tile(y[0])], [tile(x[1].min(size[0])), tile(y[1].min(size[1]))]])
    }

    /// The place of a point in front of the eye in the image, in pixels from the top left; `[0]` Eqs. (5.9), (5.10),
    /// (5.22).
    pub fn place(&self, p: DVec3) -> [f64; 2] {
        let window = self.camera.window();
        let scale = match self.camera.projection() {
            Projection::Perspective => self.camera.near() / -p.z,
            Projection::Parallel => 1.0,
        };
        let [x, y] = [p.x * scale, p.y * scale];
        let [width, height] = [self.image.width, self.image.height].map(f64::from);
        [(x - window.left) / window.width() * width, (window.top - y) / window.height() * height]
    }

    /// The ray through a place of the image, in pixels from the top left.
    fn ray(&self, [x, y]: [f64; 2]) -> DepthRay {
        let window = self.camera.window();
        let [width, height] = [self.image.width, self.image.height].map(f64::from);
        let on_window = [window.left + x / width * window.width(), window.top - y / height * window.height()];
        let [x, y] = on_window;
        match self.camera.projection() {
            Projection::Perspective => {
                let near = self.camera.near();
                DepthRay { origin: DVec3::ZERO, per_depth: DVec3::new(x / near, y / near, -1.0) }
            }
            Projection::Parallel => DepthRay { origin: DVec3::new(x, y, 0.0), per_depth: DVec3::NEG_Z },
        }
    }

    /// The nearest face at a place of the image, in pixels from the top left, between the front and the back plane.
    pub fn nearest(&self, place: [f64; 2]) -> Option<Nearest> {
        self.met(place).reduce(|old, new| if new.depth < old.depth { new } else { old })
    }

    /// All faces at a place of the image, between the front and the back plane, the nearest first. Of faces at one
    /// depth, the first of the scene comes first.
    pub fn all(&self, place: [f64; 2]) -> Vec<Nearest> {
        let mut all: Vec<Nearest> = self.met(place).collect();
        all.sort_by(|a, b| a.depth.total_cmp(&b.depth));
        all
    }

    fn met(&self, place: [f64; 2]) -> impl Iterator<Item = Nearest> {
        let DepthRay { origin, per_depth } = self.ray(place);
        let tile = tile(place[1]) * self.across + tile(place[0]);
        let range = self.camera.near()..=self.camera.far();
        let meets = move |&number: &u32| {
            let Triangle { corners, side } = &self.triangles[number as usize];
            let (depth, is_front) = ray_meets_triangle(origin, per_depth, *corners)?;
            let is_drawn = side.is_none_or(|side| side == is_front) && range.contains(&depth);
            is_drawn.then_some(Nearest { triangle: number as usize, depth })
        };
        self.tiles.get(tile).map_or(&[][..], Vec::as_slice).iter().filter_map(meets)
    }

    /// The corners of a triangle in view space.
    pub fn corners(&self, triangle: usize) -> Option<[DVec3; 3]> {
        Some(self.triangles.get(triangle)?.corners)
    }

    /// The point of the plane of a triangle at a place of the image, in view space. Not finite if the ray runs along
    /// the plane.
    pub fn on_plane(&self, [a, b, c]: [DVec3; 3], place: [f64; 2]) -> DVec3 {
        let DepthRay { origin, per_depth } = self.ray(place);
        let normal = (b - a).cross(c - a);
        origin + per_depth * (normal.dot(a - origin) / normal.dot(per_depth))
    }

    /// The distance of the plane of a triangle behind a depth at a place of the image, in units of the error that the
    /// difference may have; `None` if the ray runs along the plane.
    pub fn behind(&self, triangle: usize, place: [f64; 2], depth: f64) -> Option<f64> {
        let DepthRay { origin, per_depth } = self.ray(place);
        let corners = self.triangles.get(triangle)?.corners;
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a);
        let along = normal.dot(per_depth);
        let reach = corners.into_iter().map(|p| p.length()).fold(depth, f64::max);
        let cosine = (along / (normal.length() * per_depth.length())).abs();
        let error = ROUNDING * reach / cosine;
        let behind = (normal.dot(a - origin) / along - depth) / error;
        behind.is_finite().then_some(behind)
    }

    /// The unit normal of a triangle, on either side; `None` if it has no area.
    pub fn normal(&self, triangle: usize) -> Option<DVec3> {
        let [a, b, c] = self.triangles.get(triangle)?.corners;
        (b - a).cross(c - a).try_normalize()
    }
}

/// The intersection of a ray with a plane takes some ten roundings of 2⁻⁵³ of the largest number in it.
const ROUNDING: f64 = 1e-14;

/// The tile of a coordinate in pixels. The first one for coordinates before the image.
fn tile(coordinate: f64) -> usize {
    #[expect(clippy::cast_possible_truncation, reason = "between 0 and an image's side")]
    let tile = (coordinate / TILE).max(0.0) as usize;
    tile
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::appearance::Style;
    use crate::camera::{Parameters, ViewWindow};
    use crate::numbers::random::Random;
    use crate::pipeline::shadow_rays::Solids;
    use crate::scene::{ObjectSpec, Preset, Scene, SceneSpec, Shape, build, no_files};

    fn boxes(random: &mut Random) -> Scene {
        let shapes = [Shape::Box, Shape::Sphere, Shape::Cone];
        let objects = (0..8).map(|i: usize| {
            let at = random.direction() * random.between(0.0, 4.0);
            let [a, b, c] = [0, 1, 2].map(|_| random.between(-90.0, 90.0));
            let [x, y, z] = [0, 1, 2].map(|_| random.between(0.1, 2.0));
            let object = ObjectSpec::new(format!("o{i}"), shapes[i % 3].clone()).at(at.x, at.y, at.z);
            object.turned(a, b, c).scaled(x, y, z).with_segments(9)
        });
        let spec = SceneSpec { preset: Preset::Empty, objects: objects.collect(), ..SceneSpec::default() };
        build(&spec, &Style::default(), &mut no_files).unwrap()
    }

    #[test]
    fn the_nearest_face_is_the_one_of_a_ray_through_all_triangles() {
        let mut random = Random::new(3, 1);
        let (mut hits, mut through) = (0, 0);
        for round in 0..40 {
            let scene = boxes(&mut random);
            let position = random.direction() * random.between(0.5, 9.0);
            let mut parameters = Parameters {
                position,
                focal_point: random.direction(),
                view_up: random.direction(),
                projection: if round % 2 == 0 { Projection::Perspective } else { Projection::Parallel },
                view_angle: random.between(10.0, 120.0),
                height: random.between(1.0, 12.0),
                near: random.between(0.01, 2.0),
                far: random.between(4.0, 40.0),
                ..Parameters::default()
            };
            if round % 5 == 0 {
                let side = parameters.near;
                parameters.window = Some(ViewWindow { left: 0.1 * side, right: side, bottom: -side, top: 0.3 * side });
            }
            let camera = Camera::new(&parameters).unwrap();
            let image = ImageSize { width: 50, height: 37 };
            let solids = Solids::of(&scene);
            let tiles = Tiles::new(scene.objects.iter(), &camera, image).unwrap();
            for _ in 0..300 {
                let place = [random.between(-0.25, 50.25), random.between(-0.25, 37.25)];
                let (seen, nearest) = (solids.seen(&camera, image, place), tiles.nearest(place));
                let depth = seen.map(|seen| -camera.view_point(seen.point).z);
                match (depth, nearest) {
                    (Some(depth), Some(nearest)) => {
                        hits += 1;
                        assert!((depth - nearest.depth).abs() < 1e-9 * depth, "{depth} {}", nearest.depth);
                        let behind = tiles.behind(nearest.triangle, place, nearest.depth).unwrap();
                        assert!(behind.abs() < 1.0, "{behind}");
                    }
                    (None, None) => through += 1,
                    other => panic!("{round} {place:?}: {:?} {:?}", other.0, nearest.map(|n| n.depth)),
                }
            }
        }
        assert!(hits > 2000 && through > 2000, "{hits} {through}");
    }
}
