//! The named scenes. Each is a list of objects like those of a figure file, with additions that such a list can't
//! express: colours of single faces, marks, labels.

use std::sync::Arc;

use glam::{DMat4, DVec2, DVec3};

use crate::appearance::{Dash, HiddenLines, LineStyle, MarkShape, Rgba};
use crate::scene::palette::{BLUE, NAVY, ORANGE, PURPLE, SKY, SceneColors, TEAL, VERMILION, YELLOW};
use crate::scene::{
    Line, Mesh, Object, ObjectPaint, ObjectSpec, Preset, Scene, Shape, Text, point_mark, point_name, primitives,
};

/// A feature of a preset that a list of objects can't express.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LostFeature {
    /// A colour for each face, and a number on it.
    NumberedFaces,
    /// Tiles on the ground.
    TiledFloor,
    /// The inner sides of faces.
    InnerSides,
    /// Coordinates beside the corners.
    CornerNames,
    /// A solid without faces.
    WireCube,
    /// The letter F.
    LetterF,
    /// Arrows of a construction.
    Rays,
}

impl Preset {
    /// The features lost when the objects of this preset are expanded into a list.
    pub const fn beyond_objects(self) -> &'static [LostFeature] {
        match self {
            Self::Cube => &[LostFeature::NumberedFaces],
            Self::Corridor => &[LostFeature::TiledFloor],
            Self::Pyramid => &[LostFeature::InnerSides, LostFeature::CornerNames],
            Self::NdcCube => &[LostFeature::WireCube, LostFeature::LetterF],
            Self::Exercise51 => &[LostFeature::Rays],
            Self::Exercise53 => &[LostFeature::WireCube, LostFeature::CornerNames],
            Self::Empty | Self::Primitives | Self::House | Self::Exercise52 => &[],
        }
    }
}

/// The objects of a preset, as a figure file would list them.
pub fn objects(preset: Preset, colors: &SceneColors) -> Vec<ObjectSpec> {
    match preset {
        Preset::Empty => Vec::new(),
        Preset::Primitives => one_of_each(colors),
        Preset::Cube => vec![ObjectSpec::new("cube", Shape::Box)],
        Preset::House => house(colors),
        Preset::Corridor => corridor(colors),
        Preset::Pyramid => pyramid(),
        Preset::NdcCube => ndc_cube(),
        Preset::Exercise51 => exercise_51(),
        Preset::Exercise52 => exercise_52(),
        Preset::Exercise53 => vec![ObjectSpec::new("cube", Shape::Box).colored(BLUE)],
    }
}

/// Adds the features that objects alone can't express. `scene` holds the results of [`objects`], in their order, and
/// nothing else.
pub(crate) fn finish(preset: Preset, colors: &SceneColors, scene: &mut Scene) {
    match preset {
        Preset::Cube => number_the_faces(scene, colors),
        Preset::Corridor => scene.objects.insert(0, tiled_floor(colors)),
        Preset::Pyramid => {
            // The camera of exercise II stands on a corner and sees the inner side.
            scene.objects.iter_mut().for_each(|o| o.two_sided = true);
            name_corners(scene, colors, |p| p.y == 0.0);
        }
        Preset::NdcCube => {
            make_wire(scene, colors);
            scene.objects.push(letter_f(colors));
        }
        Preset::Exercise51 => rays_of_exercise_51(scene, colors),
        Preset::Exercise53 => {
            make_wire(scene, colors);
            name_corners(scene, colors, |p| p.y < 0.0);
        }
        Preset::Empty | Preset::Primitives | Preset::House | Preset::Exercise52 => {}
    }
}

fn one_of_each(colors: &SceneColors) -> Vec<ObjectSpec> {
    // A tetrahedron of points and segments.
    let corners = [
        DVec3::new(0.0, 1.1, 0.0),
        DVec3::new(0.0, 0.0, -0.6),
        DVec3::new(-0.52, 0.0, 0.3),
        DVec3::new(0.52, 0.0, 0.3),
    ];
    let sides = [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3], [3, 1]];
    let step = 1.65;
    let things = vec![
        ObjectSpec::new("ground", Shape::Box).at(0.0, -0.05, 0.0).scaled(2.5, 0.05, 2.5).colored(colors.ground),
        ObjectSpec::new("grid", Shape::Grid).scaled(2.5, 1.0, 2.5),
        ObjectSpec::new("cylinder", Shape::Cylinder).at(-step, 0.0, -step).scaled(0.55, 0.75, 0.55).colored(BLUE),
        ObjectSpec::new("cone", Shape::Cone).at(0.0, 0.0, -step).scaled(0.6, 0.75, 0.6).colored(ORANGE),
        ObjectSpec::new("pyramid", Shape::Pyramid).at(step, 0.0, -step).scaled(0.6, 0.65, 0.6).colored(TEAL),
        ObjectSpec::new("sphere", Shape::Sphere).at(-step, 0.65, 0.0).scaled(0.65, 0.65, 0.65).colored(VERMILION),
        ObjectSpec::new("torus", Shape::Torus).at(0.0, 0.24, 0.0).scaled(0.8, 0.8, 0.8).colored(YELLOW),
        ObjectSpec::new("box", Shape::Box).at(step, 0.5, 0.0).turned(0.0, 20.0, 0.0).scaled(0.5, 0.5, 0.5).colored(SKY),
        ObjectSpec::new("prism", Shape::Prism).at(-step, 0.0, step).scaled(0.6, 0.5, 0.6).colored(PURPLE),
        ObjectSpec::new("ellipsoid", Shape::Ellipsoid).at(0.0, 0.5, step).scaled(0.75, 0.75, 0.75).colored(NAVY),
        ObjectSpec::new("segments", Shape::Segments(sides.map(|[a, b]| [corners[a], corners[b]]).to_vec()))
            .at(step, 0.0, step)
            .colored(colors.ink),
        ObjectSpec::new("points", Shape::Points(corners.to_vec())).under("segments").colored(VERMILION),
    ];
    // Objects on the table move with it, and a figure can add more.
    let on_table = things.into_iter().map(|o| if o.parent.is_none() { o.under("table") } else { o });
    std::iter::once(ObjectSpec::group("table")).chain(on_table).collect()
}

/// A house 2.6 wide with its door to the left and its window to the right of the front, chimney at the back right, and
/// a tree, so that no mirror image of it looks the same.
fn house(colors: &SceneColors) -> Vec<ObjectSpec> {
    let ground = ObjectSpec::new("ground", Shape::Box);
    // The roof is a prism of three sides that lies along x: √3 sx wide, 1.5 sz high, its ridge at the vertex.
    let (width, height, length, eaves) = (2.4, 1.0, 2.9, 1.5);
    let roof = ObjectSpec::new("roof", Shape::Prism).with_segments(3).turned(90.0, 90.0, 0.0).scaled(
        width / 3.0_f64.sqrt(),
        length / 2.0,
        height / 1.5,
    );
    let part = |name: &str, center: [f64; 3], half: [f64; 3], color| {
        let [x, y, z] = center;
        ObjectSpec::new(name, Shape::Box).at(x, y, z).scaled(half[0], half[1], half[2]).colored(color).under("house")
    };
    vec![
        ground.at(0.0, -0.05, 0.0).scaled(2.3, 0.05, 1.9).colored(colors.ground),
        ObjectSpec::group("house").at(-0.3, 0.0, -0.25).scaled(0.85, 0.85, 0.85),
        part("walls", [0.0, 0.75, 0.0], [1.3, 0.75, 1.0], colors.stone),
        roof.at(-length / 2.0, eaves + height / 3.0, 0.0).colored(VERMILION).under("house"),
        part("chimney", [0.75, 2.15, -0.45], [0.17, 0.55, 0.17], PURPLE),
        part("door", [-0.65, 0.5, 1.0], [0.26, 0.5, 0.04], NAVY),
        part("window", [0.5, 0.85, 1.0], [0.36, 0.27, 0.04], SKY),
        part("step", [-0.65, 0.05, 1.2], [0.4, 0.05, 0.2], colors.ground_other),
        ObjectSpec::group("tree").at(1.55, 0.0, 0.85).scaled(0.85, 0.85, 0.85),
        ObjectSpec::new("trunk", Shape::Cylinder).scaled(0.09, 0.25, 0.09).colored(ORANGE).under("tree"),
        ObjectSpec::new("crown", Shape::Cone).at(0.0, 0.4, 0.0).scaled(0.5, 0.65, 0.5).colored(TEAL).under("tree"),
    ]
}

/// Half the width of the corridor's floor.
const HALF_WIDTH: f64 = 1.75;
/// The ends of the corridor, on z.
const CORRIDOR: [f64; 2] = [1.75, -12.25];

/// Two rows of columns under beams. Equal balls, as a measure of how distance shrinks.
fn corridor(colors: &SceneColors) -> Vec<ObjectSpec> {
    let mut all = Vec::new();
    let middle = (CORRIDOR[0] + CORRIDOR[1]) / 2.0;
    let half_length = (CORRIDOR[0] - CORRIDOR[1]) / 2.0;
    for (side, x) in [("left", -1.4), ("right", 1.4)] {
        all.push(
            ObjectSpec::new(format!("beam {side}"), Shape::Box)
                .at(x, 2.13, middle)
                .scaled(0.2, 0.13, half_length)
                .colored(colors.stone),
        );
        for k in 0..7 {
            all.push(
                ObjectSpec::new(format!("column {side} {}", k + 1), Shape::Cylinder)
                    .at(x, 0.0, 0.875 - 2.0 * f64::from(k))
                    .scaled(0.17, 1.0, 0.17)
                    .with_segments(24)
                    .colored(BLUE),
            );
        }
    }
    for (k, color) in [VERMILION, YELLOW, TEAL, PURPLE].into_iter().enumerate() {
        let z = [0.0, -3.5, -7.0, -10.5][k];
        all.push(
            ObjectSpec::new(format!("ball {}", k + 1), Shape::Sphere)
                .at(if k % 2 == 0 { -0.6 } else { 0.6 }, 0.3, z)
                .scaled(0.3, 0.3, 0.3)
                .colored(color),
        );
    }
    all
}

fn tiled_floor(colors: &SceneColors) -> Object {
    let (nx, nz) = (4, 16);
    let mesh = primitives::tiles([-HALF_WIDTH, CORRIDOR[1]], [HALF_WIDTH, CORRIDOR[0]], nx, nz);
    let tile = |t: u32| if (t % nx + t / nx).is_multiple_of(2) { colors.ground } else { colors.ground_other };
    Object {
        two_sided: true,
        ..Object::new(
            "floor",
            Arc::new(mesh),
            DMat4::IDENTITY,
            ObjectPaint::Faces(Arc::new((0..nx * nz).flat_map(|t| [tile(t); 2]).collect())),
        )
    }
}

/// `[1]`, exercises I and II with day 15 and month 8: the pyramid with its base scaled by 8 and its height by 15, moved
/// into the first octant.
fn pyramid() -> Vec<ObjectSpec> {
    vec![
        ObjectSpec::new("grid", Shape::Grid).at(5.0, 0.0, 5.0).scaled(5.0, 1.0, 5.0),
        ObjectSpec::new("pyramid", Shape::Pyramid).at(4.0, 0.0, 4.0).scaled(4.0, 7.5, 4.0).colored(ORANGE),
    ]
}

/// The contents of the cube: a ball before, a cone behind, and the letter of [`letter_f`].
fn ndc_cube() -> Vec<ObjectSpec> {
    vec![
        ObjectSpec::new("cube", Shape::Box),
        ObjectSpec::new("ball", Shape::Sphere).at(0.55, -0.55, 0.6).scaled(0.25, 0.25, 0.25).colored(VERMILION),
        ObjectSpec::new("cone", Shape::Cone).at(0.6, -0.1, -0.6).scaled(0.25, 0.35, 0.25).colored(YELLOW),
    ]
}

/// A letter F, which no mirror image equals, in the middle of the cube.
fn letter_f(colors: &SceneColors) -> Object {
    let (left, right, stem, arm) = (-0.63, 0.43, 0.26, 0.23);
    let outline = [
        [left, -0.7],
        [left + stem, -0.7],
        [left + stem, -0.1],
        [right - 0.2, -0.1],
        [right - 0.2, -0.1 + arm],
        [left + stem, -0.1 + arm],
        [left + stem, 0.7 - arm],
        [right, 0.7 - arm],
        [right, 0.7],
        [left, 0.7],
    ];
    Object {
        edges: Some(colors.edge_style()),
        ..Object::new(
            "F",
            Arc::new(primitives::plate(&outline.map(DVec2::from), 0.13)),
            DMat4::IDENTITY,
            ObjectPaint::Solid(BLUE),
        )
    }
}

/// `[0]` exercise 5.1: C = (3, 4, 0), PF = 0. The point with VRC coordinates (1, 1, 0) is C + **u** + **v**. The
/// **v** = (0, 1, 0) of the text can only be VUP.
const EXERCISE_51: [DVec3; 3] = [DVec3::new(3.0, 4.0, 0.0), DVec3::new(0.0, 0.0, -1.0), DVec3::new(-0.8, 0.6, 0.0)];

fn exercise_51() -> Vec<ObjectSpec> {
    let [c, u, v] = EXERCISE_51;
    vec![
        ObjectSpec::new("grid", Shape::Grid).scaled(4.0, 1.0, 4.0).with_segments(8),
        ObjectSpec::new("box", Shape::Box).at(0.0, 0.6, 0.0).scaled(0.6, 0.6, 0.6).colored(SKY),
        ObjectSpec::new("cone", Shape::Cone).at(0.0, 1.2, 0.0).scaled(0.4, 0.4, 0.4).colored(ORANGE),
        ObjectSpec::new("ball", Shape::Sphere).at(0.0, 0.45, 1.5).scaled(0.45, 0.45, 0.45).colored(TEAL),
        ObjectSpec::new("P", Shape::Points(vec![c + u + v])).colored(VERMILION),
    ]
}

/// The way to P along **u** and **v**, and both rays: in parallel projection from P along DOP, in perspective from C
/// through P.
fn rays_of_exercise_51(scene: &mut Scene, colors: &SceneColors) {
    let [c, u, v] = EXERCISE_51;
    let p = c + u + v;
    let style = |color, dash, arrow| LineStyle { color, width: 2.0, dash, hidden: HiddenLines::OfStyle, arrow };
    let way = LineStyle { width: 1.25, ..style(colors.ink, Dash::Dotted, false) };
    scene.lines.push(Line::new(vec![c, c + u, p, c + v, c], way));
    let parallel = p - c;
    scene.lines.push(Line::new(vec![p, parallel], style(BLUE, Dash::Solid, true)));
    let perspective = c + 2.2 * (p - c);
    scene.lines.push(Line::new(vec![c, perspective], style(VERMILION, Dash::Dashed, true)));
    scene.texts.extend([(parallel, BLUE), (perspective, VERMILION)].map(|(end, color)| point_name(end, "D_R", color)));
}

/// `[0]` exercise 5.2: C = (7, 0, 0), PF = (1, 1, 1), VUP = (1, 0, 0): the camera lies on its side. A cube about PF,
/// marked on its upper side and on the one that looks along z.
fn exercise_52() -> Vec<ObjectSpec> {
    let c = DVec3::new(7.0, 0.0, 0.0);
    let n = (c - DVec3::ONE).normalize();
    let u = DVec3::X.cross(n).normalize();
    let p = c + u + n.cross(u);
    vec![
        ObjectSpec::new("grid", Shape::Grid).scaled(4.0, 1.0, 4.0).with_segments(8),
        ObjectSpec::new("box", Shape::Box).at(1.0, 1.0, 1.0).scaled(0.8, 0.8, 0.8).colored(SKY),
        ObjectSpec::new("cone", Shape::Cone).at(1.0, 1.8, 1.0).scaled(0.6, 0.75, 0.6).colored(ORANGE),
        ObjectSpec::new("ball", Shape::Sphere).at(1.0, 0.6, 2.6).scaled(0.6, 0.6, 0.6).colored(TEAL),
        ObjectSpec::new("P", Shape::Points(vec![p])).colored(VERMILION),
    ]
}

/// Leaves only the edges of the first object.
fn make_wire(scene: &mut Scene, colors: &SceneColors) {
    if let Some(cube) = scene.objects.first_mut() {
        cube.faces = false;
        cube.edges = Some(colors.segment_style(colors.ink));
    }
}

/// Writes their coordinates beside the corners of the last object (each corner once). Below them if `below` holds.
fn name_corners(scene: &mut Scene, colors: &SceneColors, below: impl Fn(DVec3) -> bool) {
    let Some(object) = scene.objects.last() else { return };
    let mut corners: Vec<DVec3> = Vec::new();
    for p in &object.mesh.positions {
        let p = object.world_from_object.transform_point3(*p);
        if !corners.contains(&p) {
            corners.push(p);
        }
    }
    for p in corners {
        let text = format!("({}, {}, {})", p.x, p.y, p.z).replace('-', "−");
        let offset = [6.0, if below(p) { 12.0 } else { -12.0 }];
        scene.marks.push(point_mark(p, MarkShape::Disc, colors.ink));
        scene.texts.push(Text { offset, size: 13.0, ..point_name(p, &text, colors.ink) });
    }
}

/// Paints each face of the first object in its own colour and writes a number on it, as on a die: opposite faces add up
/// to 7. The numbers are strokes on the faces, so they deform with them and show a mirror image at once.
fn number_the_faces(scene: &mut Scene, colors: &SceneColors) {
    // Face, its digit, the directions right and up of a reader before it; in the order of `primitives::cuboid`.
    let faces: [(DVec3, usize, DVec3, DVec3, Rgba); 6] = [
        (DVec3::NEG_X, 5, DVec3::Z, DVec3::Y, TEAL),
        (DVec3::X, 2, DVec3::NEG_Z, DVec3::Y, YELLOW),
        (DVec3::NEG_Y, 4, DVec3::X, DVec3::Z, PURPLE),
        (DVec3::Y, 3, DVec3::X, DVec3::NEG_Z, SKY),
        (DVec3::NEG_Z, 6, DVec3::NEG_X, DVec3::Y, VERMILION),
        (DVec3::Z, 1, DVec3::X, DVec3::Y, ORANGE),
    ];
    if let Some(cube) = scene.objects.first_mut() {
        cube.paint = ObjectPaint::Faces(Arc::new(faces.iter().flat_map(|f| [f.4; 2]).collect()));
    }
    for (normal, digit, right, up, color) in faces {
        // A hair's breadth before the face.
        let center = normal * 1.003;
        let points: Vec<DVec3> =
            DIGITS[digit - 1].iter().map(|&[x, y]| center + right * (x - 0.5) * 0.7 + up * (y - 0.8) * 0.7).collect();
        let on_face = if is_dark(color) { Rgba::rgb(255, 255, 255) } else { Rgba::rgb(0x10, 0x14, 0x1a) };
        scene.objects.push(Object {
            lit: false,
            two_sided: true,
            faces: false,
            edges: Some(LineStyle::solid(on_face, 4.0, HiddenLines::Hidden)),
            ..Object::new(
                digit.to_string(),
                Arc::new(Mesh::segments(points.windows(2).map(|pair| [pair[0], pair[1]]))),
                DMat4::IDENTITY,
                // The colour in wireframe, if there is no face behind it.
                ObjectPaint::Solid(colors.ink),
            )
        });
    }
}

/// True if white letters read better than black ones.
fn is_dark(c: Rgba) -> bool {
    u32::from(c.r) * 30 + u32::from(c.g) * 59 + u32::from(c.b) * 11 < 110 * 100
}

/// One stroke each, in a box 1 wide and 1.6 high.
const DIGITS: [&[[f64; 2]]; 6] = [
    &[[0.2, 1.25], [0.55, 1.6], [0.55, 0.0]],
    &[[0.0, 1.25], [0.25, 1.6], [0.75, 1.6], [1.0, 1.3], [1.0, 1.05], [0.0, 0.0], [1.0, 0.0]],
    &[
        [0.0, 1.6],
        [1.0, 1.6],
        [0.45, 0.95],
        [0.75, 0.95],
        [1.0, 0.7],
        [1.0, 0.3],
        [0.75, 0.0],
        [0.25, 0.0],
        [0.0, 0.25],
    ],
    &[[0.75, 0.0], [0.75, 1.6], [0.0, 0.5], [1.0, 0.5]],
    &[[0.95, 1.6], [0.1, 1.6], [0.05, 0.9], [0.65, 0.95], [1.0, 0.7], [1.0, 0.3], [0.7, 0.0], [0.25, 0.0], [0.0, 0.2]],
    &[
        [0.9, 1.45],
        [0.65, 1.6],
        [0.35, 1.6],
        [0.0, 1.2],
        [0.0, 0.3],
        [0.25, 0.0],
        [0.75, 0.0],
        [1.0, 0.3],
        [1.0, 0.6],
        [0.75, 0.9],
        [0.25, 0.9],
        [0.0, 0.6],
    ],
];
