//! Textures: the place of each texel on the picture, the level of detail, and the sources of textures.

#![expect(
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    reason = "a test may fail by panicking; texels are small numbers"
)]

use std::sync::Arc;

use camera_lab_engine::appearance::{Filter, Rgba, Sampler, Samples, Style, Texture, TextureReveal, Wrap};
use camera_lab_engine::drawing::{Base, Surface, SurfaceLight};
use camera_lab_engine::scene::{self, MeshNotice, ObjectPaint, ReadError, ReadProblem, Scene, TextureFault, Wanted};
use camera_lab_figures::figure::read::parse;
use image::{ExtendedColorType, ImageEncoder as _};

use crate::common::triangles::{Random, drawing, owns, paint, rgb, surface};

const WHITE: Rgba = Rgba::rgb(255, 255, 255);

/// A picture whose texels encode their places: red is the column, green the row.
fn map() -> Arc<Texture> {
    let texel = |i: u32| [(i % 256) as u8, (i / 256) as u8, 0, 255];
    Arc::new(Texture::flat(256, 256, (0..256 * 256).flat_map(texel).collect()))
}

fn textured(
    corners: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
    image: &Arc<Texture>,
    sampler: Sampler,
    uv: Vec<[f32; 2]>,
) -> Surface {
    surface(corners, triangles, Base::Texture { image: Arc::clone(image), sampler, uv, tint: WHITE, tints: Vec::new() })
}

/// Random triangles, thin ones among them, seen under perspectives in which w differs by up to a factor 10⁴: every
/// pixel has the texel that exact arithmetic gives, or one whose border is half a texel away.
#[test]
fn every_pixel_has_its_texel_under_any_perspective() {
    let (mut random, image, side) = (Random(3), map(), 96_u32);
    let mut share = || f64::from(random.next() as u32 % 100_000) / 100_000.0;
    let nearest = Sampler { filter: Filter::Nearest, ..Sampler::PICTURE };
    let mut seen = 0;
    for round in 0..300 {
        let corner = |a: f64, b: f64| {
            [(a * 96.0 * 256.0).round() as f32 / 256.0, (b * 96.0 * 256.0).round() as f32 / 256.0, 0.5]
        };
        let triangle = [corner(share(), share()), corner(share(), share()), corner(share(), share())];
        let reach = if round % 2 == 0 { 4.0 } else { 1.0 };
        let inverse_w: [f32; 3] = std::array::from_fn(|_| 10_f64.powf(-reach * share()) as f32);
        let uv: [[f32; 2]; 3] = std::array::from_fn(|_| [share() as f32, share() as f32]);
        let mut s = textured(triangle.to_vec(), vec![[0, 1, 2]], &image, nearest, uv.to_vec());
        s.inverse_w = inverse_w.to_vec();
        let pixmap = paint(&drawing(96, 96, Samples::One, vec![s]));
        let v = triangle.map(|p| [f64::from(p[0]), f64::from(p[1])]);
        let cross =
            |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        for (x, y) in (0..side * side).map(|i| (i % side, i / side)).filter(|&(x, y)| owns(triangle, x, y)) {
            let p = [f64::from(x) + 0.5, f64::from(y) + 0.5];
            let b = [cross(v[1], v[2], p), cross(v[2], v[0], p), cross(v[0], v[1], p)];
            let b: [f64; 3] = std::array::from_fn(|k| b[k] * f64::from(inverse_w[k]));
            let [red, green, _] = rgb(&pixmap, x, y);
            for (axis, found) in [red, green].into_iter().enumerate() {
                let exact = (0..3).map(|k| b[k] * f64::from(uv[k][axis])).sum::<f64>() / (b[0] + b[1] + b[2]);
                let exact = 256.0 * exact.clamp(0.0, 1.0);
                let off = (exact - (f64::from(found) + 0.5)).abs() - 0.5;
                assert!(off < 0.5, "({x}, {y}) {triangle:?} {inverse_w:?}: texel {found}, exact {exact}");
            }
            seen += 1;
        }
    }
    assert!(seen > 50_000, "{seen}");
}

/// The border of a picture of one colour outside and another inside.
fn border(wrap: Wrap, filter: Filter) -> [u8; 3] {
    let texel = |i: u32| if i.is_multiple_of(8) { [255, 0, 0, 255] } else { [0, 0, 255, 255] };
    let image = Arc::new(Texture::flat(8, 8, (0..64).flat_map(texel).collect()).with_levels());
    let corners = vec![[0.0, 0.0, 0.5], [64.0, 0.0, 0.5], [64.0, 64.0, 0.5], [0.0, 64.0, 0.5]];
    let uv = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let sampler = Sampler { wrap_u: wrap, wrap_v: wrap, filter, reveal: None };
    let s = textured(corners, vec![[0, 1, 2], [0, 2, 3]], &image, sampler, uv);
    rgb(&paint(&drawing(64, 64, Samples::One, vec![s])), 63, 32)
}

#[test]
fn texels_bleed_over_the_border_only_if_the_texture_repeats() {
    for filter in [Filter::Nearest, Filter::Bilinear, Filter::Trilinear] {
        assert_eq!(border(Wrap::Clamp, filter), [0, 0, 255], "{filter:?}");
        assert_eq!(border(Wrap::Mirror, filter), [0, 0, 255], "{filter:?}");
    }
    assert_eq!(border(Wrap::Repeat, Filter::Nearest), [0, 0, 255]);
    // Half a pixel from the border: 7/16 of the way to the first column.
    let [red, _, blue] = border(Wrap::Repeat, Filter::Bilinear);
    assert!(red > 100 && blue > 120 && blue > red, "{red} {blue}");
}

#[test]
fn wrapping_follows_the_settings_of_the_texture() {
    let image = map();
    let nearest = |wrap| Sampler { wrap_u: wrap, wrap_v: wrap, filter: Filter::Nearest, reveal: None };
    let corners = vec![[0.0, 0.0, 0.5], [64.0, 0.0, 0.5], [64.0, 64.0, 0.5], [0.0, 64.0, 0.5]];
    // Four pictures beside each other, from −1 to 3. Far away from 0 they are the same.
    for shift in [0.0, 1000.0] {
        let uv = vec![[shift - 1.0, 0.0], [shift + 3.0, 0.0], [shift + 3.0, 1.0], [shift - 1.0, 1.0]];
        let column = |wrap, x| {
            let s = textured(corners.clone(), vec![[0, 1, 2], [0, 2, 3]], &image, nearest(wrap), uv.clone());
            i32::from(rgb(&paint(&drawing(64, 64, Samples::One, vec![s])), x, 32)[0])
        };
        for x in 0..64 {
            let within = (x as i32 % 16) * 16 + 8;
            assert!((column(Wrap::Repeat, x) - within).abs() <= 1, "{x}");
            let mirrored = if (x / 16) % 2 == 1 { within } else { 255 - within };
            assert!((column(Wrap::Mirror, x) - mirrored).abs() <= 1, "{x}: {}", column(Wrap::Mirror, x));
            if shift == 0.0 {
                let held = if x < 16 {
                    0
                } else if x < 32 {
                    within
                } else {
                    255
                };
                assert!((column(Wrap::Clamp, x) - held).abs() <= 1, "{x}");
            }
        }
    }
}

/// A floor of chequers of one texel each, far away: its pixels are the mean light of black and white.
#[test]
fn levels_of_detail_keep_a_far_floor_from_flickering() {
    let texel = |i: u32| if (i % 64 + i / 64).is_multiple_of(2) { [255; 4] } else { [0, 0, 0, 255] };
    let image = Arc::new(Texture::flat(64, 64, (0..64 * 64).flat_map(texel).collect()).with_levels());
    let corners = vec![[0.0, 0.0, 0.5], [64.0, 0.0, 0.5], [64.0, 64.0, 0.5], [0.0, 64.0, 0.5]];
    let uv = vec![[0.0, 0.0], [16.3, 0.0], [16.3, 16.3], [0.0, 16.3]];
    let spread = |filter| {
        let sampler = Sampler { filter, ..Sampler::default() };
        let s = textured(corners.clone(), vec![[0, 1, 2], [0, 2, 3]], &image, sampler, uv.clone());
        let pixmap = paint(&drawing(64, 64, Samples::One, vec![s]));
        let values: Vec<u8> = (0..64 * 64).map(|i| rgb(&pixmap, i % 64, i / 64)[0]).collect();
        (*values.iter().min().unwrap(), *values.iter().max().unwrap())
    };
    let (low, high) = spread(Filter::Nearest);
    assert!(low == 0 && high == 255);
    let (low, high) = spread(Filter::Trilinear);
    assert!(low >= 186 && high <= 190, "{low} {high}");
}

/// The level is that at which a texel is as large as a pixel, also in perspective.
#[test]
fn the_level_of_detail_is_the_change_of_u_and_v_from_pixel_to_pixel() {
    // Levels of one colour each: the red channel of the revealed level tells which one is asked for.
    let image = Arc::new(Texture::flat(256, 256, vec![0; 4 * 256 * 256]).with_levels());
    let opaque = Arc::new(Texture::flat(256, 256, [0, 0, 0, 255].repeat(256 * 256)).with_levels());
    assert_eq!(image.levels().len(), 9);
    let corners = vec![[0.0, 0.0, 0.5], [64.0, 0.0, 0.5], [64.0, 64.0, 0.5], [0.0, 64.0, 0.5]];
    for level in 0..5_u32 {
        // 2^level texels a pixel.
        let most = 64.0 * 2_f32.powi(level as i32) / 256.0;
        let uv = vec![[0.0, 0.0], [most, 0.0], [most, most], [0.0, most]];
        let sampler = Sampler { reveal: Some(TextureReveal::Levels), ..Sampler::default() };
        let s = textured(corners.clone(), vec![[0, 1, 2], [0, 2, 3]], &opaque, sampler, uv);
        let found = rgb(&paint(&drawing(64, 64, Samples::One, vec![s])), 30, 30);
        let Rgba { r, g, b, .. } = camera_lab_engine::appearance::LEVEL_COLORS[level as usize];
        for (found, whole) in found.into_iter().zip([r, g, b]) {
            assert!((i32::from(found) - i32::from(whole) / 2).abs() <= 3, "level {level}: {found} {whole}");
        }
    }
}

/// On a floor in perspective, u and v without w bend along the diagonal, the common edge of the two triangles.
#[test]
fn without_w_the_floor_bends_along_its_diagonal() {
    let image = map();
    let corners = vec![[0.0, 60.0, 0.9], [96.0, 60.0, 0.9], [60.0, 0.0, 0.1], [36.0, 0.0, 0.1]];
    let uv = vec![[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    let column = |reveal, x| {
        let sampler = Sampler { filter: Filter::Nearest, reveal, ..Sampler::PICTURE };
        let mut s = textured(corners.clone(), vec![[0, 1, 2], [0, 2, 3]], &image, sampler, uv.clone());
        s.inverse_w = vec![1.0, 1.0, 0.25, 0.25];
        i32::from(rgb(&paint(&drawing(96, 64, Samples::One, vec![s])), x, 30)[0])
    };
    // The middle of the row is the middle of the floor. Without w it is not.
    assert!((column(None, 48) - 128).abs() <= 3, "{}", column(None, 48));
    let [left, right] = [column(Some(TextureReveal::Affine), 40), column(Some(TextureReveal::Affine), 56)];
    let [own_left, own_right] = [column(None, 40), column(None, 56)];
    assert!((own_left + own_right - 255).abs() <= 4, "symmetric: {own_left} {own_right}");
    assert!((left + right - 255).abs() > 20, "bent: {left} {right}");
}

/// Light on a white picture is light on a white object.
#[test]
fn a_white_picture_takes_light_as_white_does() {
    let corners = vec![[2.0, 2.0, 0.5], [60.0, 8.0, 0.5], [20.0, 60.0, 0.5]];
    // Of two texels, so that it is no picture of one colour.
    let image = Arc::new(Texture::flat(2, 1, vec![255; 8]));
    let shares = vec![[0.9, 0.0], [0.4, 0.3], [0.1, 0.0]];
    for light in [SurfaceLight::Vertices(shares.clone()), SurfaceLight::Faces(vec![[0.7, 0.1]])] {
        let mut pictured = textured(
            corners.clone(),
            vec![[0, 1, 2]],
            &image,
            Sampler::default(),
            vec![[0.0; 2], [0.3, 0.0], [0.0, 0.7]],
        );
        let mut plain = surface(corners.clone(), vec![[0, 1, 2]], Base::Solid(WHITE));
        (pictured.light, plain.light) = (light.clone(), light);
        let (a, b) =
            (paint(&drawing(64, 64, Samples::One, vec![pictured])), paint(&drawing(64, 64, Samples::One, vec![plain])));
        assert!(a.data() == b.data());
        let [r, ..] = rgb(&a, 25, 20);
        assert!(r > 60 && r < 255, "{r}");
    }
}

fn png(width: u32, height: u32) -> Vec<u8> {
    let mut bytes = Vec::new();
    let texels: Vec<u8> = (0..width * height).flat_map(|i| [(37 * i % 256) as u8, 90, 200]).collect();
    image::codecs::png::PngEncoder::new(&mut bytes)
        .write_image(&texels, width, height, ExtendedColorType::Rgb8)
        .unwrap();
    bytes
}

fn built(toml: &str, files: &[(&str, &[u8])]) -> Scene {
    let figure = parse(toml).unwrap();
    let mut read = |wanted: Wanted<'_>| {
        let found = files.iter().find(|(path, _)| *path == wanted.path);
        let problem = ReadProblem::System { kind: std::io::ErrorKind::NotFound, code: None };
        found.map(|(_, bytes)| bytes.to_vec()).ok_or(ReadError { file: wanted.path.to_owned(), problem })
    };
    scene::build(&figure.scene, &Style::default(), &mut read).unwrap()
}

fn sides(scene: &Scene, object: usize) -> Option<(u32, u32)> {
    match &scene.objects[object].paint {
        ObjectPaint::Texture(pictured) => Some((pictured.image.width(), pictured.image.height())),
        _ => None,
    }
}

#[test]
fn a_figure_puts_pictures_on_objects_and_says_which_it_cannot() {
    let object =
        |texture: &str| format!("[[scene.objects]]\nshape = \"box\"\nname = \"{texture}\"\ntexture = \"{texture}\"\n");
    let names = ["chequer", "letters", "uv", "none", "a.png", "cut.png", "text.png", "missing.png"];
    let text: String = names.iter().map(|name| object(name)).collect();
    let whole = png(3, 5);
    let scene = built(&text, &[("a.png", &whole), ("cut.png", &whole[..50]), ("text.png", b"not a picture")]);
    assert_eq!(sides(&scene, 0), Some((512, 512)));
    assert_eq!((sides(&scene, 3), sides(&scene, 4)), (None, Some((3, 5))));
    assert_eq!([5, 6, 7].map(|k| sides(&scene, k)), [None; 3], "their own colour");
    let faults: Vec<(&str, &TextureFault)> = scene
        .notices
        .iter()
        .map(|(object, notice)| match notice {
            MeshNotice::Texture(error) => {
                assert_eq!(*object, error.file);
                (object.as_str(), &error.fault)
            }
            other => panic!("{other:?}"),
        })
        .collect();
    assert!(
        matches!(
            faults[..],
            [
                ("cut.png", TextureFault::Damaged),
                ("text.png", TextureFault::Format),
                ("missing.png", TextureFault::Unreadable(_))
            ]
        ),
        "{faults:?}"
    );
}

const OBJ: &str =
    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3 4/4\n";

#[test]
fn an_obj_has_the_texture_of_its_material_the_right_way_up() {
    let figure = "[[scene.objects]]\nshape = \"mesh\"\npath = \"o/q.obj\"\n";
    let mtl: &[u8] = b"newmtl m\nKd 1 1 1\nmap_Kd -clamp on -s 2 2 my picture.png\n";
    let files: [(&str, &[u8]); 3] = [("o/q.obj", OBJ.as_bytes()), ("o/m.mtl", mtl), ("o/my picture.png", &png(2, 2))];
    let scene = built(figure, &files);
    let ObjectPaint::Texture(pictured) = &scene.objects[0].paint else { panic!("{:?}", scene.notices) };
    assert_eq!(pictured.sampler.wrap_u, Wrap::Clamp);
    let mesh = &scene.objects[0].mesh;
    for (p, uv) in mesh.positions.iter().zip(pictured.uv.iter()) {
        assert_eq!([f64::from(uv[0]), f64::from(1.0 - uv[1])], [p.x, p.y], "v goes up in the file");
    }
    assert!(pictured.tints.is_empty());
    // Colours of vertices stand in place of the material's, under the picture too. One of the figure wins.
    let colored = OBJ.replacen("v 0 0 0", "v 0 0 0 1 0 0", 1);
    let with_color = |color: &str| {
        let files: [(&str, &[u8]); 3] =
            [("o/q.obj", colored.as_bytes()), ("o/m.mtl", mtl), ("o/my picture.png", &png(2, 2))];
        let ObjectPaint::Texture(pictured) = built(&format!("{figure}{color}"), &files).objects[0].paint.clone() else {
            panic!("no texture")
        };
        (pictured.tint, Vec::clone(&pictured.tints))
    };
    let mut tints = vec![WHITE; 4];
    tints[0] = Rgba::rgb(255, 0, 0);
    assert_eq!(with_color("").1, tints);
    assert_eq!(with_color("color = \"#010203\"\n"), (Rgba::rgb(1, 2, 3), Vec::new()));
    // Another texture, none, and one that the mesh has no coordinates for.
    let with = |texture: &str, obj: &str| {
        let figure = format!("{figure}texture = \"{texture}\"\ntexture_scale = [2, 3]\n");
        built(&figure, &[("o/q.obj", obj.as_bytes()), ("o/m.mtl", mtl), ("o/my picture.png", &png(2, 2))])
    };
    assert_eq!(sides(&with("uv", OBJ), 0), Some((64, 64)));
    assert_eq!(sides(&with("none", OBJ), 0), None);
    let bare = with("uv", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    assert_eq!((sides(&bare, 0), &bare.notices[0].1), (None, &MeshNotice::NoCoordinates));
    let ObjectPaint::Texture(twice) = &with("uv", OBJ).objects[0].paint.clone() else { panic!("a texture") };
    let most = twice.uv.iter().fold([0.0_f32; 2], |most, uv| [most[0].max(uv[0]), most[1].max(1.0 - uv[1])]);
    assert_eq!(most, [2.0, 3.0]);
}

#[test]
fn a_gltf_has_the_texture_of_its_material_moved_as_it_says() {
    use base64::Engine as _;
    let encoded = |bytes: &[u8]| base64::engine::general_purpose::STANDARD.encode(bytes);
    let floats = |values: &[f32]| values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>();
    let mut bytes = floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    bytes.extend(floats(&[0.0, 1.0, 1.0, 1.0, 0.0, 0.0]));
    let json = serde_json::json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": ["KHR_texture_transform"],
        "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0, "TEXCOORD_0": 1 }, "material": 0 }] }],
        "materials": [{ "pbrMetallicRoughness": { "baseColorFactor": [1.0, 0.5, 1.0, 1.0], "baseColorTexture": {
            "index": 0, "extensions": { "KHR_texture_transform": { "offset": [0.5, 0.0], "scale": [2.0, 4.0] } } } } }],
        "textures": [{ "source": 0, "sampler": 0 }],
        "samplers": [{ "wrapS": 33071, "wrapT": 33648, "minFilter": 9729 }],
        "images": [{ "uri": format!("data:image/png;base64,{}", encoded(&png(4, 2))) }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0] },
            { "bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2" }
        ],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": 36 }, { "buffer": 0, "byteOffset": 36, "byteLength": 24 }
        ],
        "buffers": [{ "byteLength": 60, "uri": format!("data:application/octet-stream;base64,{}", encoded(&bytes)) }]
    });
    let figure = "[[scene.objects]]\nshape = \"mesh\"\npath = \"a.gltf\"\n";
    let scene = built(figure, &[("a.gltf", json.to_string().as_bytes())]);
    let ObjectPaint::Texture(pictured) = &scene.objects[0].paint else { panic!("{:?}", scene.notices) };
    assert_eq!(
        pictured.sampler,
        Sampler { wrap_u: Wrap::Clamp, wrap_v: Wrap::Mirror, filter: Filter::Bilinear, reveal: None }
    );
    assert_eq!(sides(&scene, 0), Some((4, 2)));
    assert_eq!((pictured.tint.r, pictured.tint.g), (255, 188), "linear light");
    for (p, uv) in scene.objects[0].mesh.positions.iter().zip(pictured.uv.iter()) {
        let own = [p.x as f32, 1.0 - p.y as f32];
        assert_eq!(*uv, [0.5 + 2.0 * own[0], 4.0 * own[1]]);
    }
    let broken = json.to_string().replace("data:image/png;base64,", "data:image/png;base64,AAAA");
    let scene = built(figure, &[("a.gltf", broken.as_bytes())]);
    assert_eq!(sides(&scene, 0), None);
    assert!(
        matches!(&scene.notices[0].1, MeshNotice::Texture(error) if error.file == "images[0]"),
        "{:?}",
        scene.notices
    );
}

/// The textures of a scene may have so many texels together. A notice names those beyond, and the rest is drawn.
#[test]
fn textures_have_a_budget_of_texels() {
    let mut text = String::new();
    let mut files = Vec::new();
    for k in 0..5 {
        text.push_str(&format!("[[scene.objects]]\nshape = \"box\"\nname = \"b{k}\"\ntexture = \"{k}.png\"\n"));
        files.push((format!("{k}.png"), png(2048, 2048)));
    }
    let files: Vec<(&str, &[u8])> = files.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())).collect();
    let scene = built(&text, &files);
    let drawn = (0..5).filter(|k| sides(&scene, *k).is_some()).count();
    assert_eq!(drawn, 4);
    assert!(matches!(&scene.notices[..], [(_, MeshNotice::Texture(error))] if error.fault == TextureFault::Budget));
}

/// Small pictures in each format, one of them with the four colours of printers.
const PICTURES: [(&str, &[u8]); 4] = [
    ("small.png", include_bytes!("../../../../fuzz/seeds/texture/small.png")),
    ("small.jpg", include_bytes!("../../../../fuzz/seeds/texture/small.jpg")),
    ("small.webp", include_bytes!("../../../../fuzz/seeds/texture/small.webp")),
    ("cmyk.jpg", include_bytes!("../../../../fuzz/seeds/texture/cmyk.jpg")),
];

fn object_with(file: &str) -> String {
    format!("[[scene.objects]]\nshape = \"box\"\ntexture = \"{file}\"\n")
}

#[test]
fn every_format_is_read() {
    for (file, bytes) in PICTURES {
        let scene = built(&object_with(file), &[(file, bytes)]);
        let ObjectPaint::Texture(pictured) = &scene.objects[0].paint else { panic!("{file}: {:?}", scene.notices) };
        let [r, g, b, a] = pictured.image.levels()[0].texel(0, 0);
        assert!(r > 150 && g < 90 && b < 90 && a == 255, "{file}: red at the top: {r} {g} {b}");
        assert_eq!(sides(&scene, 0), Some((4, 4)));
    }
}

/// Whatever a file is made of, it is a whole picture, or its object keeps its colour and says why.
#[test]
fn broken_pictures_give_a_notice_and_do_no_harm() {
    let mut random = Random(8);
    for round in 0..4000 {
        let (file, bytes) = PICTURES[round % PICTURES.len()];
        let mut bytes = bytes.to_vec();
        for _ in 0..1 + random.next() as usize % 4 {
            let at = random.next() as usize % bytes.len();
            bytes[at] = random.next() as u8;
        }
        bytes.truncate(1 + random.next() as usize % (2 * bytes.len()));
        let scene = built(&object_with(file), &[(file, &bytes)]);
        match (&scene.objects[0].paint, scene.notices.as_slice()) {
            (ObjectPaint::Texture(pictured), []) => assert!(!pictured.image.levels().is_empty()),
            (ObjectPaint::Solid(_), [(_, MeshNotice::Texture(_))]) => {}
            other => panic!("{other:?}"),
        }
    }
}
