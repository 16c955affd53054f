//! The fast rasterizer gives the same bytes as that of the textbook, whatever the surfaces.

#![expect(clippy::cast_possible_truncation, reason = "small numbers, and bytes of random ones")]

use std::sync::Arc;
use std::time::Duration;

use camera_lab_engine::appearance::{
    Dash, DepthFormat, FaceOrder, Filter, HiddenLines, LineStyle, Rgba, Sampler, Samples, Texture, TextureReveal, Wrap,
};
use camera_lab_engine::drawing::{
    Base, BlockedLight, Drawing, Lighting, PixelLight, Rays, Shadow, ShadowMap, StrokeSet, Surface, SurfaceLight,
    ViewLight,
};
use camera_lab_engine::progress::{Progress, at_once};
use camera_lab_engine::raster::{Rasterizer, textbook};
use proptest::prelude::*;

/// The looks of a surface, and the seed of all its numbers.
#[derive(Clone, Debug)]
struct Recipe {
    shape: Shape,
    triangles: u32,
    base: BaseKind,
    light: LightKind,
    shadows: Vec<ShadowRecipe>,
    translucent: bool,
    depth_test: bool,
    w: Perspective,
    seed: u64,
}

#[derive(Clone, Copy, Debug)]
enum Shape {
    /// Triangles that lie anywhere, with sides up to this length in pixels.
    Loose(f32),
    /// Long ones, and less than a pixel wide.
    Slivers,
    /// A mesh with common edges, whose vertices lie on half pixels, with cells of this size in pixels.
    Mesh(f32),
}

#[derive(Clone, Copy, Debug)]
enum BaseKind {
    Solid,
    Faces,
    Vertices,
    Texture { sampler: Sampler, levels: bool, opaque: bool },
}

#[derive(Clone, Copy, Debug)]
enum LightKind {
    InBase,
    Faces,
    Vertices,
    PerPixel { two_sided: bool, distant_viewer: bool, specular: bool },
}

#[derive(Clone, Copy, Debug)]
struct ShadowRecipe {
    lamp: bool,
    softness: f32,
    bias: f32,
}

#[derive(Clone, Copy, Debug)]
enum Perspective {
    None,
    /// Hardly any: most colours may be interpolated without.
    Weak,
    Strong,
}

/// Everything in a picture.
#[derive(Clone, Debug)]
struct Scene {
    size: [u32; 2],
    antialias: Samples,
    painted_in_order: bool,
    depth_format: DepthFormat,
    order: FaceOrder,
    surfaces: Vec<Recipe>,
    /// Strokes ask for the slopes of faces.
    slopes: bool,
}

/// Numbers without a pattern (`SplitMix64`).
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(super) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(super) fn within(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.next() >> 40) as f32 / (1 << 24) as f32
    }

    fn vector(&mut self, reach: f32) -> [f32; 3] {
        [0; 3].map(|_| self.within(-reach, reach))
    }

    fn unit_vector(&mut self) -> [f32; 3] {
        let v = self.vector(1.0);
        let length = v.iter().map(|c| c * c).sum::<f32>().sqrt().max(1e-3);
        v.map(|c| c / length)
    }

    pub(super) fn color(&mut self, opaque: bool) -> Rgba {
        let [r, g, b, a] = (self.next() as u32).to_le_bytes();
        Rgba::rgba(r, g, b, if opaque { 255 } else { a })
    }

    /// Depths, of which many are the same.
    fn depth(&mut self) -> f32 {
        if self.next().is_multiple_of(2) { self.within(0.0, 1.0) } else { (self.next() % 9) as f32 / 8.0 }
    }

    pub(super) fn position(&mut self, size: [u32; 2], beyond: f32) -> [f32; 3] {
        let [x, y] = size.map(|size| self.within(-beyond, size as f32 + beyond));
        [x, y, self.depth()]
    }
}

/// Positions and triangles.
fn geometry(random: &mut Random, recipe: &Recipe, size: [u32; 2]) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    match recipe.shape {
        Shape::Loose(reach) => {
            for k in 0..recipe.triangles {
                let [x, y, _] = random.position(size, 0.5 * reach);
                for _ in 0..3 {
                    let [dx, dy, _] = random.vector(0.5 * reach);
                    positions.push([x + dx, y + dy, random.depth()]);
                }
                triangles.push([3 * k, 3 * k + 1, 3 * k + 2]);
            }
        }
        Shape::Slivers => {
            for k in 0..recipe.triangles {
                let (a, b) = (random.position(size, 10.0), random.position(size, 10.0));
                let (t, [dx, dy, _]) = (random.within(0.0, 1.0), random.vector(0.4));
                let between = [0, 1].map(|k| a[k] + t * (b[k] - a[k]));
                positions.extend([a, b, [between[0] + dx, between[1] + dy, random.depth()]]);
                triangles.push([3 * k, 3 * k + 1, 3 * k + 2]);
            }
        }
        Shape::Mesh(cell) => {
            let side = (recipe.triangles as f32 / 2.0).sqrt().ceil() as u32;
            let [left, top, _] = random.position(size, 0.0);
            for j in 0..=side {
                for i in 0..=side {
                    let [dx, dy, _] = random.vector(0.4 * cell);
                    let [x, y] = [left + i as f32 * cell + dx, top + j as f32 * cell + dy];
                    positions.push([(2.0 * x).round() / 2.0, (2.0 * y).round() / 2.0, random.depth()]);
                }
            }
            for (j, i) in (0..side).flat_map(|j| (0..side).map(move |i| (j, i))) {
                let a = j * (side + 1) + i;
                triangles.extend([[a, a + 1, a + side + 1], [a + 1, a + side + 1, a + side + 2]]);
            }
        }
    }
    (positions, triangles)
}

fn texture(random: &mut Random, levels: bool, opaque: bool) -> Arc<Texture> {
    let [width, height] = [0; 2].map(|_| 1 + random.next() as u32 % 17);
    let texel = |_| {
        let [r, g, b, a] = (random.next() as u32).to_le_bytes();
        let a = if opaque { 255 } else { a };
        [r.min(a), g.min(a), b.min(a), a]
    };
    let texture = Texture::flat(width, height, (0..width * height).flat_map(texel).collect());
    Arc::new(if levels { texture.with_levels() } else { texture })
}

fn shadow(random: &mut Random, recipe: ShadowRecipe, counts: [usize; 2], taken: BlockedLight) -> Shadow {
    let size = 8 + random.next() as u32 % 40;
    let mut view = |_| {
        let (positions, triangles) = (0..4_u32)
            .map(|k| ([0; 3].map(|_| random.position([size; 2], 0.0)), [3 * k, 3 * k + 1, 3 * k + 2]))
            .fold((Vec::new(), Vec::new()), |(mut positions, mut triangles), (corners, triangle)| {
                positions.extend(corners);
                triangles.push(triangle);
                (positions, triangles)
            });
        let surfaces = if random.next().is_multiple_of(4) {
            Vec::new()
        } else {
            vec![Surface::solid(positions, triangles, Rgba::rgb(0, 0, 0))]
        };
        Drawing { surfaces, ..Drawing::new(size, size, Rgba::rgb(0, 0, 0)) }
    };
    let views: Vec<Drawing> = (0..if recipe.lamp { 6 } else { 1 }).map(&mut view).collect();
    let rays = if recipe.lamp {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let back = |v: [f32; 3]| v.map(|c: f32| -c);
        let axes = [[y, z, x], [z, y, back(x)], [z, x, y], [x, z, back(y)], [x, y, z], [y, x, back(z)]];
        Rays::FromLamp { axes: Box::new(axes), reach: 1.05, unit: 0.1 }
    } else {
        Rays::Parallel { step: 0.01 }
    };
    let place = |random: &mut Random| {
        if recipe.lamp { random.vector(1.0) } else { random.position([size; 2], 4.0) }
    };
    Shadow {
        bias: recipe.bias,
        places: (0..counts[0]).map(|_| place(random)).collect(),
        planes: (0..counts[1]).map(|_| random.vector(if recipe.lamp { 3.0 } else { 0.03 })).collect(),
        taken,
        map: Arc::new(ShadowMap::new(views, size, rays, recipe.softness)),
    }
}

fn surface(recipe: &Recipe, size: [u32; 2]) -> Surface {
    let random = &mut Random(recipe.seed);
    let (positions, triangles) = geometry(random, recipe, size);
    let (vertices, faces) = (positions.len(), triangles.len());
    let opaque = !recipe.translucent;
    let base = match recipe.base {
        BaseKind::Solid => Base::Solid(random.color(opaque)),
        BaseKind::Faces => Base::Faces((0..faces).map(|_| random.color(opaque)).collect()),
        BaseKind::Vertices => Base::Vertices((0..vertices).map(|_| random.color(opaque)).collect()),
        BaseKind::Texture { sampler, levels, opaque } => Base::Texture {
            image: texture(random, levels, opaque),
            sampler,
            uv: (0..vertices).map(|_| [random.within(-2.0, 3.0), random.within(-2.0, 3.0)]).collect(),
            tint: random.color(!recipe.translucent),
            tints: if opaque { Vec::new() } else { (0..vertices).map(|_| random.color(!recipe.translucent)).collect() },
        },
    };
    let mut light_share = |most: f32| [random.within(0.0, most), random.within(0.0, 0.4 * most)];
    let light = match recipe.light {
        LightKind::InBase => SurfaceLight::InBase,
        LightKind::Faces => SurfaceLight::Faces((0..faces).map(|_| light_share(1.1)).collect()),
        LightKind::Vertices => SurfaceLight::Vertices((0..vertices).map(|_| light_share(1.1)).collect()),
        LightKind::PerPixel { two_sided, distant_viewer, specular } => SurfaceLight::PerPixel(PixelLight {
            normals: (0..vertices).map(|_| random.unit_vector()).collect(),
            positions: (0..vertices).map(|_| random.vector(3.0)).collect(),
            lighting: Lighting {
                ambient: 0.2,
                diffuse: 0.6,
                specular: if specular { 0.5 } else { 0.0 },
                shininess: (random.next() % 40) as f32,
                distant_viewer,
                two_sided,
                lights: vec![ViewLight::directional(random.unit_vector()), ViewLight::point(random.vector(5.0))],
            },
        }),
    };
    let shadows = (0..).zip(&recipe.shadows).map(|(number, &of_lamp)| {
        let mut some =
            |count: usize| (0..count).map(|_| [random.within(-0.2, 0.5), random.within(-0.1, 0.2)]).collect();
        let taken = match recipe.light {
            LightKind::InBase | LightKind::Faces => BlockedLight::Faces(some(faces)),
            LightKind::Vertices => BlockedLight::Vertices(some(vertices)),
            LightKind::PerPixel { .. } => BlockedLight::Light(number),
        };
        shadow(random, of_lamp, [vertices, faces], taken)
    });
    let shadows = shadows.collect();
    let inverse_w = match recipe.w {
        Perspective::None => Vec::new(),
        Perspective::Weak => (0..vertices).map(|_| random.within(0.5, 0.502)).collect(),
        Perspective::Strong => (0..vertices).map(|_| random.within(0.02, 1.0)).collect(),
    };
    let (translucent, depth_test) = (recipe.translucent, recipe.depth_test);
    Surface { positions, inverse_w, triangles, base, light, shadows, translucent, depth_test }
}

/// A fresh drawing: no shadow map of it is painted.
fn drawing(scene: &Scene) -> Drawing {
    let [width, height] = scene.size;
    let style = LineStyle {
        color: Rgba::rgb(0, 0, 0),
        width: 1.0,
        dash: Dash::Solid,
        hidden: HiddenLines::Dashed,
        arrow: false,
    };
    let strokes = StrokeSet::pairs(&[], style);
    Drawing {
        antialias: scene.antialias,
        painted_in_order: scene.painted_in_order,
        depth_format: scene.depth_format,
        order: scene.order,
        surfaces: scene.surfaces.iter().map(|recipe| surface(recipe, scene.size)).collect(),
        strokes: if scene.slopes { vec![strokes] } else { Vec::new() },
        ..Drawing::new(width, height, Rgba::rgba(250, 240, 230, 200))
    }
}

fn shapes() -> impl Strategy<Value = Shape> {
    prop_oneof![
        (0.3..3.0_f32).prop_map(Shape::Loose),
        (3.0..12.0_f32).prop_map(Shape::Loose),
        (12.0..40.0_f32).prop_map(Shape::Loose),
        (40.0..400.0_f32).prop_map(Shape::Loose),
        (400.0..4000.0_f32).prop_map(Shape::Loose),
        Just(Shape::Slivers),
        (0.5..12.0_f32).prop_map(Shape::Mesh),
    ]
}

fn bases() -> impl Strategy<Value = BaseKind> {
    let wrap = || prop::sample::select(vec![Wrap::Repeat, Wrap::Clamp, Wrap::Mirror]);
    let filter = prop::sample::select(vec![Filter::Nearest, Filter::Bilinear, Filter::Trilinear]);
    let reveal: Option<TextureReveal> = None;
    let texture = (wrap(), wrap(), filter, any::<bool>(), any::<bool>()).prop_map(
        move |(wrap_u, wrap_v, filter, levels, opaque)| BaseKind::Texture {
            sampler: Sampler { wrap_u, wrap_v, filter, reveal },
            levels,
            opaque,
        },
    );
    prop_oneof![1 => Just(BaseKind::Solid), 1 => Just(BaseKind::Faces), 2 => Just(BaseKind::Vertices), 2 => texture]
}

fn lights() -> impl Strategy<Value = LightKind> {
    let per_pixel = any::<[bool; 3]>().prop_map(|[two_sided, distant_viewer, specular]| LightKind::PerPixel {
        two_sided,
        distant_viewer,
        specular,
    });
    prop_oneof![2 => Just(LightKind::InBase), 1 => Just(LightKind::Faces), 1 => Just(LightKind::Vertices), 1 => per_pixel]
}

fn recipes() -> impl Strategy<Value = Recipe> {
    let shadow = (any::<bool>(), prop_oneof![Just(0.0_f32), 0.3..4.0_f32], prop_oneof![Just(1.0_f32), 0.0..3.0_f32])
        .prop_map(|(lamp, softness, bias)| ShadowRecipe { lamp, softness, bias });
    let shadows = prop_oneof![Just(Vec::new()), prop::collection::vec(shadow, 1..3)];
    let w = prop::sample::select(vec![Perspective::None, Perspective::Weak, Perspective::Strong]);
    let switches = (prop::bool::weighted(0.3), prop::bool::weighted(0.8));
    (shapes(), 1..24_u32, bases(), lights(), shadows, switches, w, any::<u64>()).prop_map(
        |(shape, triangles, base, light, shadows, (translucent, depth_test), w, seed)| Recipe {
            shape,
            triangles,
            base,
            light,
            shadows,
            translucent,
            depth_test,
            w,
            seed,
        },
    )
}

fn scenes() -> impl Strategy<Value = Scene> {
    let size = prop_oneof![3 => [1..80_u32, 1..60_u32], 1 => [100..200_u32, 100..150_u32]];
    let antialias = prop::sample::select(Samples::ALL.to_vec());
    let format = prop::sample::select(vec![DepthFormat::Float, DepthFormat::Fixed16, DepthFormat::Fixed24]);
    let surfaces = prop::collection::vec(recipes(), 1..5);
    let order = prop::sample::select(FaceOrder::NAMED.iter().map(|(_, order)| *order).collect::<Vec<_>>());
    (size, antialias, prop::bool::weighted(0.2), format, order, surfaces, any::<bool>()).prop_map(
        |(size, antialias, painted_in_order, depth_format, order, surfaces, slopes)| Scene {
            size,
            antialias,
            painted_in_order,
            depth_format,
            order,
            surfaces,
            slopes,
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn the_fast_path_paints_the_bytes_of_the_textbook(scene in scenes(), counts in any::<bool>()) {
        let expected = textbook::paint(&drawing(&scene)).expect("a small picture");
        let mut rasterizer = Rasterizer::default();
        let clock: fn() -> Duration = || Duration::ZERO;
        rasterizer.measure(counts.then_some(clock));
        let image = rasterizer.paint(&drawing(&scene)).expect("a small picture");
        for (k, (fast, textbook)) in image.pixels().iter().zip(expected.image.pixels()).enumerate() {
            let (x, y) = (k as u32 % scene.size[0], k as u32 / scene.size[0]);
            prop_assert_eq!(fast, textbook, "colour of pixel ({}, {})", x, y);
            let depth = rasterizer.depth().at(x, y).unwrap_or(f32::NEG_INFINITY);
            prop_assert_eq!(depth.to_bits(), expected.depths[k].to_bits(), "depth of pixel ({}, {})", x, y);
        }
    }

    /// Many of their depths are equal.
    #[test]
    fn the_order_of_faces_changes_the_counts_alone(scene in scenes()) {
        let paint = |order| {
            let drawing = Drawing { order, ..drawing(&scene) };
            let mut rasterizer = Rasterizer::default();
            rasterizer.measure(Some(|| Duration::ZERO));
            let image = rasterizer.paint(&drawing).expect("a small picture");
            let costs = at_once(textbook::cost(&drawing, 0, &Progress::default())).expect("not cancelled");
            let sum = |of: fn(&textbook::PixelCost) -> u32| costs.iter().map(|cost| u64::from(of(cost))).sum::<u64>();
            let work = rasterizer.work();
            assert_eq!([work.covered, work.written], [sum(|cost| cost.covered), sum(|cost| cost.filled)], "{order:?}");
            (image, textbook::paint(&drawing).expect("a small picture").image)
        };
        let (as_listed, by_textbook) = paint(FaceOrder::AsListed);
        for order in [FaceOrder::FrontToBack, FaceOrder::BackToFront] {
            let (image, textbook) = paint(order);
            prop_assert!(image == as_listed, "{order:?}");
            prop_assert!(textbook == by_textbook, "{order:?}, textbook");
        }
    }

    #[test]
    fn the_faces_at_a_pixel_have_its_counts(scene in scenes(), x in 0..80_u32, y in 0..60_u32) {
        let drawing = drawing(&scene);
        let [x, y] = [x % scene.size[0], y % scene.size[1]];
        let costs = at_once(textbook::cost(&drawing, 0, &Progress::default())).expect("not cancelled");
        let cost = costs[(y * scene.size[0] + x) as usize];
        let faces = textbook::faces_at(&drawing, [x, y]);
        let sum = |of: fn(&textbook::PixelCost) -> u32| faces.iter().map(|face| of(&face.cost)).sum::<u32>();
        prop_assert_eq!([cost.covered, cost.filled], [sum(|cost| cost.covered), sum(|cost| cost.filled)]);
        prop_assert_eq!([cost.lit, cost.blended], [sum(|cost| cost.lit), sum(|cost| cost.blended)]);
        for face in faces {
            let [surface, number] = face.face;
            prop_assert!(number < drawing.surfaces[surface].triangles.len());
            prop_assert_eq!(face.behind.is_some(), face.cost.filled < face.cost.covered);
            prop_assert!(face.behind.is_none_or(|behind| behind >= 0.0));
        }
    }
}

/// Of two squares, the nearer one is painted first or last.
#[test]
fn from_front_to_back_nothing_is_painted_over() {
    let square = |z: f32, color: u8| {
        let corners = vec![[0.0, 0.0, z], [8.0, 0.0, z], [8.0, 8.0, z], [0.0, 8.0, z]];
        Surface::solid(corners, vec![[0, 1, 2], [0, 2, 3]], Rgba::rgb(color, color, color))
    };
    let surfaces = vec![square(0.25, 10), square(0.75, 20), square(0.5, 30)];
    let drawing = Drawing { surfaces, ..Drawing::new(8, 8, Rgba::rgb(255, 255, 255)) };
    for (order, filled) in [(FaceOrder::AsListed, 2), (FaceOrder::FrontToBack, 1), (FaceOrder::BackToFront, 3)] {
        let drawing = Drawing { order, ..drawing.clone() };
        let costs = at_once(textbook::cost(&drawing, 0, &Progress::default())).expect("not cancelled");
        assert!(costs.iter().all(|cost| (cost.covered, cost.filled, cost.painted_over) == (3, filled, filled - 1)));
        assert!(costs.iter().all(|cost| cost.rounding == 0.0), "quarters are exact");
    }
    let faces = textbook::faces_at(&drawing, [3, 4]);
    let told: Vec<_> = faces.iter().map(|face| (face.face[0], face.depth, face.behind)).collect();
    assert_eq!(told, [(0, 0.25, None), (1, 0.75, None), (2, 0.5, Some(0.25))]);
    // Whole numbers of 16 bits don't have a quarter.
    let coarse = Drawing { depth_format: DepthFormat::Fixed16, ..drawing };
    let costs = at_once(textbook::cost(&coarse, 0, &Progress::default())).expect("not cancelled");
    assert!(costs.iter().all(|cost| (0.25 / 65_535.0 - cost.rounding).abs() < 1e-7), "{:?}", costs[0]);
}
