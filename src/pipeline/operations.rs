//! The operations of the stages on vertices and triangles: how many each formula has.
//!
//! How each number is counted stands beside it; [`Operations`] says what counts. The tests run the same formulas on
//! numbers that count: they get the same bits, and as many operations as stand here.

use super::faces::Faces;
use super::light::Lights;
use super::object_pass::ObjectPass;
use super::stages::LitAt;
use crate::lighting::{WITH_LIGHT, light_operations};
use crate::stage::{Cost, Operations, Stage};

/// `ViewFromObject::point`: p − C (3 differences), and a matrix of 3 × 3 (9 products, 6 sums). A point is read.
const VIEW: Operations = Operations::new(3 + 15, 0, 3);

/// The same through the world, where the eye cannot be taken to the space of the object: one matrix more, and a
/// translation.
const THROUGH_WORLD: Operations = Operations::new(15 + 3, 0, 0);

/// `Projector::clip`: the scale of x and that of y.
const CLIP_SPACE: Operations = Operations::new(2, 0, 0);

/// The shift of an oblique window: for x and y a product with w, and a difference.
const OBLIQUE: Operations = Operations::new(4, 0, 0);

/// `Screen::project`, the divide: 1/w, x/w and y/w as products.
const DIVIDE: Operations = Operations::new(3, 0, 0);

/// The depth in perspective: unit/w, and the product with it.
const DIVIDE_DEPTH: Operations = Operations::new(2, 0, 0);

/// `relative_inverse_w`: a division, a product, a comparison; it is written.
const INVERSE_W: Operations = Operations::new(3, 0, 1);

/// `Screen::project`, the rest: for x and y a product and a sum, for the depth 2 differences and a division, 6
/// comparisons that hold them to the picture, and 2 sums that round x and 2 that round y to the grid. Three numbers
/// are written.
const VIEWPORT: Operations = Operations::new(2 * 2 + 3 + 6 + 4, 0, 3);

/// `outcode`: six distances from the planes and their signs; the sum of three sizes and its test; a shift and a join
/// for each bit. It is written.
const OUTCODE: Operations = Operations::new(6 + 6 + 2 + 1, 6 * 2, 1);

/// The outcodes of three corners, joined and masked.
const OUTCODES: Operations = Operations::new(0, 6, 3);

/// `turned_here`: 4 differences, 2 products, 2 comparisons. Three indices, and x and y of three corners, are read.
const TURNED: Operations = Operations::new(8, 0, 3 + 6);

/// `judge`, on the image: 4 differences, 2 products, a difference, the sign and the side.
const JUDGED: Operations = Operations::new(4 + 3 + 3, 0, 3 + 6);

/// `facing`: three corners in view space, 2 differences of vectors, their cross product (6 products, 3 differences) and
/// a dot product.
const IN_WORLD: Operations = VIEW.times(3).and(Operations::new(6 + 9 + 5, 0, 0));

/// A triangle that is left is handed on: three indices read, and three written.
const KEPT: Operations = Operations::new(0, 0, 6);

/// A corner that comes to be clipped: to clip space once more, and its six distances.
const CORNER: Operations = VIEW.and(CLIP_SPACE).and(OBLIQUE).and(Operations::new(6, 0, 0));

/// A corner is held against a plane: not negative, not positive, and two tests whether its edge crosses.
const PLANE_TEST: Operations = Operations::new(4, 0, 0);

/// A new corner: the shares (a sum, 2 divisions), and twelve means (2 products, a sum): six distances, three
/// coordinates, three weights; four tests, two comparisons for each coordinate.
const CROSSING: Operations = Operations::new(3 + 12 * 3 + 4 + 6, 0, 0);

/// A normal in view space: a matrix of 3 × 3. It is read.
const NORMAL: Operations = Operations::new(15, 0, 3);

/// A normal for the light of pixels, of length 1: the square, 2 comparisons, a root, 3 divisions; it is written.
const UNIT_NORMAL: Operations = NORMAL.and(Operations::new(5 + 2 + 1 + 3, 0, 3));

/// The normal of a face: 2 differences of vectors, a cross product, its size and the factor (2 comparisons, 3
/// products), and the matrix. Three indices and three corners are read.
const FACE_NORMAL: Operations = Operations::new(6 + 9 + 5 + 15, 0, 3 + 9);

/// The middle of a face: a sum, a division and a sum of vectors.
const CENTROID: Operations = Operations::new(9, 0, 0);

/// The place of a point for lamps and viewers that are not far away: p − C, the unit, and a matrix.
const PLACE: Operations = Operations::new(3 + 3 + 15, 0, 3);

/// `SeenByLight::place` of parallel light, after `VIEW`: to clip space, for x and y a sum and a product, and the depth
/// as a share (2 differences, a division). It is written.
const PLACE_ON_MAP: Operations = CLIP_SPACE.and(OBLIQUE).and(Operations::new(2 * 2 + 3, 0, 3));

/// The same of a lamp: 3 divisions.
const PLACE_FROM_LAMP: Operations = Operations::new(3, 0, 3);

/// `SeenByLight::plane`, after its three corners: 2 differences of vectors and a cross product.
const PLANE: Operations = Operations::new(6 + 9, 0, 3);

/// Its slopes on the map of parallel light, and what makes it the plane around a lamp: a dot product, 3 divisions.
const SLOPES: Operations = Operations::new(2, 0, 3);
const PLANE_FROM_LAMP: Operations = Operations::new(5 + 3, 0, 3);

/// A mean of three vectors with weights.
const MEAN: Operations = Operations::new(3 * 6, 0, 0);

/// The same of an image under a perspective: three products with 1/w, the mean of 1/w, 3 divisions.
const BENT: Operations = Operations::new(3 * 3 + 6 + 3, 0, 3);

/// The colour that is read and the one that is written, or the two parts of a light that are.
const COLORS: Operations = Operations::new(0, 0, 2);

/// Adds the work on the faces of one object. `lit`: the number of faces or vertices that were lit.
pub(super) fn of_faces(cost: &mut Cost, pass: &ObjectPass, faces: &Faces, lit: u64, lights: &Lights) {
    let (vertices, object) = (pass.vertices(), pass.object);
    let (n, cuts) = (vertices.len() as u64, faces.cuts.len() as u64);
    let through = if vertices.view_from_object.goes_through_world() { THROUGH_WORLD } else { Operations::NONE };

    cost.add(Stage::Transform, VIEW.and(through).and(CLIP_SPACE), n);
    cost.add(Stage::Oblique, OBLIQUE, n);
    of_points(cost, vertices.projector.perspective, n + cuts);
    let with_w = if faces.image.inverse_w.is_empty() { 0 } else { n + cuts };
    cost.add(Stage::Divide, INVERSE_W, with_w);

    let crosses = pass.plan.clip_planes != 0;
    let judged = faces.judged();
    let (together, alone) = (judged.together as u64, judged.alone as u64);
    cost.add(Stage::CullFaces, TURNED, together);
    cost.add(Stage::CullFaces, JUDGED, alone);
    cost.add(Stage::CullFaces, IN_WORLD.and(through.times(3)), judged.in_world as u64);
    cost.add(Stage::CullFaces, KEPT, faces.triangles.len() as u64);

    cost.add(Stage::Clip, OUTCODE, if crosses { n } else { 0 });
    let coded = if faces.image.outcodes.is_empty() { 0 } else { object.mesh.triangles.len() as u64 };
    cost.add(Stage::Clip, OUTCODES, coded);
    let work = faces.clipper.work;
    cost.add(Stage::Clip, CORNER.and(through), work.corners);
    cost.add(Stage::Clip, PLANE_TEST, work.tests);
    cost.add(Stage::Clip, CROSSING, work.crossings);

    let lighting = lights.lighting(pass.lights_both_sides(faces));
    let place = if lighting.needs_positions() { PLACE } else { Operations::NONE };
    // On a texture, and in shadows, the light stays apart from the colour.
    let color = if pass.plan.textured || pass.plan.shadowed { COLORS } else { WITH_LIGHT.and(COLORS) };
    let light = light_operations(&lighting).and(color);
    match pass.plan.lit {
        LitAt::Nowhere => {}
        LitAt::Faces => {
            let middle = if lighting.needs_positions() { CENTROID.and(PLACE) } else { Operations::NONE };
            cost.add(Stage::Light, FACE_NORMAL.and(middle).and(light), lit);
        }
        LitAt::Vertices => {
            cost.add(Stage::Normals, NORMAL, lit);
            cost.add(Stage::Light, place.and(light), lit);
        }
        LitAt::Pixels => cost.add(Stage::Normals, UNIT_NORMAL.and(place), n),
    }
    for shadow in pass.shadows() {
        let point = VIEW.and(through).and(if shadow.is_lamp() { PLACE_FROM_LAMP } else { PLACE_ON_MAP });
        cost.add(Stage::Shadow, point, n);
        let mean = if pass.object.in_world.is_some() { MEAN.and(BENT) } else { MEAN };
        cost.add(Stage::Shadow, point.times(3).and(mean), cuts);
        let plane = PLANE.and(if shadow.is_lamp() { PLANE_FROM_LAMP } else { SLOPES });
        cost.add(Stage::Shadow, plane, faces.triangles.len() as u64);
        // The light of this lamp alone; of what has its light from the world it is known.
        let alone = lights.only(shadow.light).lighting(pass.lights_both_sides(faces));
        let alone = light_operations(&alone).and(COLORS);
        match pass.plan.lit {
            LitAt::Nowhere | LitAt::Pixels => {}
            LitAt::Faces => {
                let middle = if lighting.needs_positions() { CENTROID.and(PLACE) } else { Operations::NONE };
                cost.add(Stage::Shadow, FACE_NORMAL.and(middle).and(alone), lit);
            }
            LitAt::Vertices => cost.add(Stage::Shadow, NORMAL.and(place).and(alone), lit),
        }
    }
}

/// Adds the divide and the viewport of `n` points.
fn of_points(cost: &mut Cost, perspective: bool, n: u64) {
    cost.add(Stage::Divide, DIVIDE.and(if perspective { DIVIDE_DEPTH } else { Operations::NONE }), n);
    cost.add(Stage::Viewport, VIEWPORT, n);
}

/// Adds the work on the ends of the edges of an object whose faces are not drawn.
pub(super) fn of_ends(cost: &mut Cost, perspective: bool, ends: u64) {
    cost.add(Stage::Transform, VIEW.and(CLIP_SPACE), ends);
    cost.add(Stage::Oblique, OBLIQUE, ends);
    of_points(cost, perspective, ends);
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use std::cell::Cell;
    use std::ops::{Add, Div, Mul, Neg, Sub};

    use glam::{DMat4, DVec3};

    use super::super::planes::outcode;
    use super::super::projector::Projector;
    use super::super::shadow_maps::ShadowMaps;
    use super::super::transform::{Screen, on_grid};
    use super::super::{Scenes, Target, light_cameras};
    use super::*;
    use crate::appearance::{Rgba, Shading, Style};
    use crate::camera::{Camera, Parameters, Projection, ViewWindow};
    use crate::drawing::{Lighting, ViewLight};
    use crate::lighting::{light_eight, shade};
    use crate::scene::{Light, Preset, Scene, SceneSpec, Shadows, build, no_files};
    use crate::simd::{f32x8, prelude::*, with_vectors};

    /// Numbers that formulas can be run on.
    trait Real:
        Copy
        + Add<Output = Self>
        + Sub<Output = Self>
        + Mul<Output = Self>
        + Div<Output = Self>
        + Neg<Output = Self>
        + PartialOrd
    {
        fn of(value: f32) -> Self;
        fn root(self) -> Self;
    }

    impl Real for f64 {
        fn of(value: f32) -> Self {
            value.into()
        }

        fn root(self) -> Self {
            self.sqrt()
        }
    }

    impl Real for f32 {
        fn of(value: f32) -> Self {
            value
        }

        fn root(self) -> Self {
            self.sqrt()
        }
    }

    thread_local! {
        static DONE: Cell<u64> = const { Cell::new(0) };
    }

    /// A number that counts what is done with it, except a change of sign.
    #[derive(Clone, Copy, Debug, PartialEq)]
    struct Counted<T>(T);

    fn tick() {
        DONE.set(DONE.get() + 1);
    }

    macro_rules! counted {
        ($($operation:ident $method:ident),*) => {$(
            impl<T: Real> $operation for Counted<T> {
                type Output = Self;

                fn $method(self, other: Self) -> Self {
                    tick();
                    Self(self.0.$method(other.0))
                }
            }
        )*};
    }
    counted!(Add add, Sub sub, Mul mul, Div div);

    impl<T: Real> Neg for Counted<T> {
        type Output = Self;

        fn neg(self) -> Self {
            Self(-self.0)
        }
    }

    impl<T: Real> PartialOrd for Counted<T> {
        fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
            tick();
            self.0.partial_cmp(&other.0)
        }
    }

    impl<T: Real> Real for Counted<T> {
        fn of(value: f32) -> Self {
            Self(T::of(value))
        }

        fn root(self) -> Self {
            tick();
            Self(self.0.root())
        }
    }

    /// The operations of `work`, and what comes of it.
    fn count<T>(work: impl FnOnce() -> T) -> (u64, T) {
        DONE.set(0);
        let result = work();
        (DONE.get(), result)
    }

    fn dot<T: Real>(a: [T; 3], b: [T; 3]) -> T {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    fn to_view<T: Real>(eye: [T; 3], rows: [[T; 3]; 3], p: [T; 3]) -> [T; 3] {
        let d = [p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]];
        rows.map(|row| dot(row, d))
    }

    fn scaled<T: Real>(scale: [T; 2], p: [T; 3]) -> [T; 2] {
        [scale[0] * p[0], scale[1] * p[1]]
    }

    fn shifted<T: Real>(shift: [T; 2], w: T, p: [T; 2]) -> [T; 2] {
        [p[0] - shift[0] * w, p[1] - shift[1] * w]
    }

    fn divided<T: Real>([x, y]: [T; 2], w: T) -> [T; 3] {
        let inverse_w = T::of(1.0) / w;
        [x * inverse_w, y * inverse_w, inverse_w]
    }

    fn depth_divided<T: Real>(share: T, unit: T, inverse_w: T) -> T {
        share * (unit * inverse_w)
    }

    fn held<T: Real>(value: T, limit: T) -> T {
        let v = if value > T::of(0.0) { value } else { T::of(0.0) };
        if v < limit { v } else { limit }
    }

    fn on_image<T: Real>([x, y]: [T; 2], half: [T; 2], limits: [T; 2], zero: T) -> [T; 2] {
        let x = held(x * half[0] + half[0], limits[0]);
        let y = held(half[1] - y * half[1], limits[1]);
        [(x + zero) - zero, (y + zero) - zero]
    }

    fn share_of_depth<T: Real>(near: T, far: T, depth: T) -> T {
        (far - depth) / (far - near)
    }

    fn outside<T: Real>([x, y]: [T; 2], w: T, depth: T, [near, far]: [T; 2], size: [T; 3], greatest: T) -> bool {
        let distances = [w + x, w - x, w + y, w - y, depth - near, far - depth];
        let any = distances.map(|distance| distance < T::of(0.0)).contains(&true);
        size[0] + size[1] + size[2] <= greatest && any
    }

    #[test]
    fn as_many_operations_as_the_way_of_a_vertex_has() {
        let window = Some(ViewWindow { left: -0.5, right: 1.5, bottom: -1.0, top: 0.75 });
        for projection in [Projection::Perspective, Projection::Parallel] {
            let camera = Camera::new(&Parameters { projection, window, ..Parameters::default() }).unwrap();
            let projector = Projector::new(&camera);
            let perspective = projector.perspective;
            let world_from_object = DMat4::from_rotation_y(0.3) * DMat4::from_scale(DVec3::new(1.0, 1.5, 0.75));
            let way = projector.view_from_object(world_from_object);
            assert!(!way.goes_through_world());
            let (eye, rows) = (-way.offset(DVec3::ZERO), way.of_offsets().transpose().to_cols_array_2d());
            let target = Target { width: 640, height: 480, scale: 1.0, background: Rgba::rgb(0, 0, 0) };
            let screen = Screen::new(target);
            let all = |values: [f64; 3]| values.map(Counted);
            let both = |values: [f64; 2]| values.map(Counted);
            let (near, far, greatest) = (projector.near, projector.far, projector.depths.greatest());
            for p in [DVec3::new(0.25, -0.5, 0.75), DVec3::new(-1.0, 0.125, -0.3), DVec3::new(0.7, 0.6, 0.1)] {
                let (of_view, view) =
                    count(|| to_view(all(eye.to_array()), rows.map(all), all(p.to_array())).map(|c| c.0));
                assert_eq!(view, way.point(p).to_array());
                assert_eq!(of_view, VIEW.float);

                let (depth, w) = (-view[2], if perspective { -view[2] } else { 1.0 });
                let (of_scale, scaled) = count(|| scaled(both(projector.scale), all(view)));
                let (of_shift, clip) = count(|| shifted(both(projector.shift), Counted(w), scaled).map(|c| c.0));
                let clip_point = projector.clip(DVec3::from_array(view));
                assert_eq!([clip[0], clip[1], w, depth], [clip_point.x, clip_point.y, clip_point.w, clip_point.depth]);
                assert_eq!([of_scale, of_shift], [CLIP_SPACE.float, OBLIQUE.float]);

                let size = [clip[0].abs(), clip[1].abs(), depth.abs()];
                let limit = Counted(f64::MAX / 4.0);
                let (of_code, outside) =
                    count(|| outside(both(clip), Counted(w), Counted(depth), both([near, far]), all(size), limit));
                assert_eq!(outside, outcode(&projector, clip_point) != 0);
                assert_eq!(of_code, OUTCODE.float);

                let (of_divide, ndc) = count(|| divided(both(clip), Counted(w)));
                let (of_share, share) = count(|| share_of_depth(Counted(near), Counted(far), Counted(depth)));
                let (of_depth, stored) = count(|| depth_divided(share, Counted(near), ndc[2]));
                let half = screen.half_size();
                let limits = [2.0 * half.x, 2.0 * half.y];
                // 1.5 · 2⁵² rounds to whole numbers, and 256 times less to steps of 1/256.
                let zero = Counted(6_755_399_441_055_744.0 / 256.0);
                let (of_image, image) =
                    count(|| on_image([ndc[0], ndc[1]], both(half.to_array()), both(limits), zero).map(|c| c.0));
                let (of_hold, stored) = count(|| held(if perspective { stored } else { share }, Counted(greatest)).0);
                #[expect(clippy::cast_possible_truncation, reason = "the display list has single precision")]
                let position = [image[0] as f32, image[1] as f32, stored as f32];
                assert_eq!(position, on_grid(screen.project(&projector, clip_point)), "{projection:?}");
                assert_eq!([of_divide, of_depth], [DIVIDE.float, DIVIDE_DEPTH.float]);
                assert_eq!(of_share + of_image + of_hold, VIEWPORT.float);
            }
        }
    }

    fn unit<T: Real>(v: [T; 3]) -> [T; 3] {
        let square = dot(v, v);
        let inverse = if square > T::of(0.0) { T::of(1.0) / square.root() } else { T::of(0.0) };
        v.map(|c| c * inverse)
    }

    fn positive<T: Real>(v: T) -> T {
        if v > T::of(0.0) { v } else { T::of(0.0) }
    }

    /// The reflection model, once more: one point at a time, in numbers of any kind.
    fn light<T: Real>(lighting: &Lighting, normal: [T; 3], position: [T; 3]) -> [T; 2] {
        let mut n = unit(normal);
        let to_viewer = if lighting.distant_viewer { [0.0, 0.0, 1.0].map(T::of) } else { unit(position.map(|c| -c)) };
        if lighting.two_sided && dot(n, to_viewer) < T::of(0.0) {
            n = n.map(|c| -c);
        }
        let (mut diffuse, mut specular) = (T::of(0.0), T::of(0.0));
        for lamp in &lighting.lights {
            let vector = lamp.vector.map(T::of);
            let to_light = if lamp.distant { vector } else { unit([0, 1, 2].map(|k| vector[k] - position[k])) };
            let cosine = dot(n, to_light);
            diffuse = diffuse + positive(cosine);
            if lighting.specular > 0.0 {
                let half = unit([0, 1, 2].map(|k| to_light[k] + to_viewer[k]));
                let (mut base, mut power) = (positive(dot(n, half)), T::of(1.0));
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small whole number")]
                let mut left = lighting.shininess as u32;
                while left > 0 {
                    if left & 1 == 1 {
                        power = power * base;
                    }
                    left >>= 1;
                    base = base * base;
                }
                specular = specular + if cosine > T::of(0.0) { power } else { T::of(0.0) };
            }
        }
        [diffuse * T::of(lighting.diffuse) + T::of(lighting.ambient), specular * T::of(lighting.specular)]
    }

    fn channel<T: Real>(color: T, share: T, white: T, most: T) -> T {
        let value = positive(color * share + white);
        let value = if value < most { value } else { most };
        // As rounding does it: by a sum whose lower bits are the whole number.
        value + T::of(8_388_608.0)
    }

    #[test]
    fn as_many_operations_as_light_has() {
        let (near, far) = (ViewLight::point([0.5, 1.0, -1.0]), ViewLight::directional([0.6, 0.0, 0.8]));
        for (lights, specular, shininess) in
            [(vec![far], 0.0, 24.0), (vec![far, near], 0.3, 24.0), (vec![near], 0.5, 7.0), (vec![], 0.3, 1.0)]
        {
            for (distant_viewer, two_sided) in [(true, false), (false, false), (true, true), (false, true)] {
                let lighting = Lighting {
                    ambient: 0.35,
                    diffuse: 0.65,
                    specular,
                    shininess,
                    distant_viewer,
                    two_sided,
                    lights: lights.clone(),
                };
                let (normal, position) = ([0.25, -0.5, 0.75], [0.3, -0.2, -4.0]);
                let (done, shares) =
                    count(|| light(&lighting, normal.map(Counted), position.map(Counted)).map(|c| c.0));
                let there = with_vectors!(simd => {
                    let [n, p] = [normal, position].map(|v| v.map(|c| f32x8::splat(simd, c)));
                    light_eight(simd, &lighting, n, p, |_, _| None).map(|share| share[3])
                });
                assert_eq!(shares, there);
                assert_eq!(done, light_operations(&lighting).float, "{lighting:?}");

                let own = [200.0, 100.0, 40.0_f32];
                let [share, white] = shares.map(Counted);
                let most = Counted(255.0);
                let (done, lit) = count(|| {
                    let white = white * most;
                    own.map(|c| channel(Counted(c), share, white, most).0 - 8_388_608.0)
                });
                let color = shade(&lighting, normal, position, Rgba::rgb(200, 100, 40));
                assert_eq!(lit, [color.r, color.g, color.b].map(f32::from));
                assert_eq!(done, WITH_LIGHT.float);
            }
        }
    }

    fn share_on_map<T: Real>([x, y]: [T; 2], half: T) -> [T; 2] {
        [(T::of(1.0) + x) * half, (T::of(1.0) - y) * half]
    }

    fn normal<T: Real>([a, b, c]: [[T; 3]; 3]) -> [T; 3] {
        let [p, q] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        [p[1] * q[2] - q[1] * p[2], p[2] * q[0] - q[2] * p[0], p[0] * q[1] - q[0] * p[1]]
    }

    #[test]
    fn as_many_operations_as_a_point_and_a_plane_on_a_shadow_map_have() {
        let style = Style { shading: Shading::Flat, ..Style::default() };
        let spec = SceneSpec { preset: Preset::Cube, ..SceneSpec::default() };
        let all = |v: DVec3| v.to_array().map(Counted);
        for light in [Light::directional(DVec3::new(-1.0, -2.0, -0.5)), Light::point(DVec3::new(2.0, 3.0, 1.5))] {
            let light = light.with_shadows(Shadows::CAST);
            let scene = Scene { lights: vec![light], ..build(&spec, &style, &mut no_files).unwrap() };
            let projector = Projector::new(&light_cameras(&scene, &light).unwrap()[0]);
            let maps = ShadowMaps::default();
            let (lights, _) = maps.of(Scenes::from(&scene));
            let (seen, is_lamp) = (lights[0].sees(DMat4::IDENTITY), lights[0].is_lamp());
            let way = projector.view_from_object(DMat4::IDENTITY);
            let (eye, rows) = (-way.offset(DVec3::ZERO), way.of_offsets().transpose().to_cols_array_2d());
            let corners = [DVec3::new(0.25, -0.5, 0.75), DVec3::new(-1.0, 0.125, -0.3), DVec3::new(0.7, 0.6, 0.1)];
            for p in corners {
                let view = to_view(all(eye), rows.map(|row| row.map(Counted)), all(p));
                let (done, place) = count(|| {
                    if is_lamp {
                        return view.map(|c| (c / Counted(projector.far)).0);
                    }
                    let scaled = scaled(projector.scale.map(Counted), view);
                    let clip = shifted(projector.shift.map(Counted), Counted(1.0), scaled);
                    let [x, y] = share_on_map(clip, Counted(0.5 * f64::from(Shadows::CAST.map)));
                    let z = share_of_depth(Counted(projector.near), Counted(projector.far), -view[2]);
                    [x, y, z].map(|c| c.0)
                });
                assert_eq!(place, seen.place(p).to_array());
                assert_eq!(done, if is_lamp { PLACE_FROM_LAMP } else { PLACE_ON_MAP }.float);
            }
            let places = corners.map(|p| all(seen.place(p)));
            let (done, n) = count(|| normal(places));
            assert_eq!(done, PLANE.float);
            let (done, plane) = count(|| {
                if is_lamp {
                    let distance = dot(n, places[0]);
                    return n.map(|c| (c / distance).0);
                }
                [(-n[0] / n[2]).0, (-n[1] / n[2]).0, 0.0]
            });
            assert_eq!(DVec3::from_array(plane).as_vec3().to_array(), seen.plane(corners.map(|p| seen.place(p))));
            assert_eq!(done, if is_lamp { PLANE_FROM_LAMP } else { SLOPES }.float);
        }
    }

    #[test]
    fn as_many_operations_as_the_side_of_a_triangle_has() {
        let [a, b, c] = [[1.0, 2.0], [5.0, 3.0], [2.0, 7.0]].map(|p: [f32; 2]| p.map(Counted));
        let (done, _) = count(|| {
            let (first, second) = ((b[1] - a[1]) * (c[0] - a[0]), (b[0] - a[0]) * (c[1] - a[1]));
            (first > second, first < second)
        });
        assert_eq!(done, TURNED.float);
    }
}
