#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use super::*;
use crate::appearance::{Filter, HiddenLines, Rgba, Samples, Style, SubpixelBits, TextureReveal, Theme, Wrap};
use crate::camera::{Decomposition, ImageSize, Ndc, Operation, Parameters, Projection, ViewWindow, Viewport};
use crate::figure::words::{
    ARRANGEMENTS, DEPTH_FORMATS, DIMENSIONS, FACE_ORDERS, MEASURE_TEXTS, MEASURES, PANELS, PRESETS, SCREEN_MATRICES,
    SHADINGS, VERTEX_FORMATS, VISIBILITIES,
};
use crate::figure::{
    CameraTag, Comparison, CostReveal, Depth, LabelledMeasure, Labels, Letters, Localized, Measured, MovedLabel,
    NamedCamera, NamedPoint, Note, NotePlace, Observer, Observers, Outside, Photograph, RenamedLabel, Reveal, Screen,
    ScreenEntry, ShadowReveal, Show, ShownProbe, ShownStep, ShownTriangle, StagePicture, StyledLabel, TransformPreview,
    TriangleStep, View, WorldLook, WorldPart, WorldParts,
};
use crate::geometry::Ray;
use crate::limits::MAX_LIGHTS;
use crate::scene::{Light, ObjectSpec, Preset, SceneSpec, Shadows, Shape, TextureSource};
use crate::stage::Stage;
use glam::{DMat4, DVec2, DVec3};
use proptest::collection::vec;
use proptest::prelude::*;

fn point() -> impl Strategy<Value = DVec3> {
    let number =
        || prop_oneof![-1e3..1e3, Just(0.0), Just(-0.0), Just(1e-300), Just(-1e150), any::<i32>().prop_map(f64::from)];
    (number(), number(), number()).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

fn parameters() -> impl Strategy<Value = Parameters> {
    let directions = proptest::array::uniform3(-1.0..1.0).prop_map(DVec3::from_array);
    let window = proptest::option::of((0.01..5.0, 0.01..5.0).prop_map(|(w, h): (f64, f64)| ViewWindow {
        left: -w,
        right: w * 1.5,
        bottom: -h / 3.0,
        top: h,
    }));
    (directions.clone(), directions, any::<bool>(), 1e-3..179.0, 1e-3..1e3, 0.1..10.0, window)
        .prop_map(|(position, up, parallel, view_angle, near, aspect, window)| Parameters {
            position: position * 10.0,
            focal_point: DVec3::new(11.0, 12.0, 13.0),
            view_up: up,
            projection: if parallel { Projection::Parallel } else { Projection::Perspective },
            view_angle,
            height: near / 3.0,
            aspect,
            near,
            far: near * 1000.0,
            window,
        })
        .prop_filter("a camera", |p| crate::camera::Camera::new(p).is_ok())
}

fn shape() -> impl Strategy<Value = Option<Shape>> {
    prop_oneof![
        Just(None),
        Just(Some(Shape::Torus)),
        vec(point(), 0..4).prop_map(|points| Some(Shape::Points(points))),
        (point(), point()).prop_map(|(a, b)| Some(Shape::Segments(vec![[a, b]; 2]))),
        "[a-z\"'\\\\\n ç]{1,9}".prop_map(|path| Some(Shape::Mesh { path })),
    ]
}

fn scene() -> impl Strategy<Value = SceneSpec> {
    let object = (shape(), point(), point(), any::<Option<[u8; 4]>>(), 3_u32..=512, any::<bool>());
    let light = (any::<bool>(), point()).prop_map(|(directional, p)| {
        let light = if directional { Light::directional(p + DVec3::new(0.5, 0.5, 0.25)) } else { Light::point(p) };
        let of = |x: f64| x.abs().fract();
        light.with_shadows(Shadows { cast: p.x > 0.0, map: 64, bias: 100.0 * of(p.y), softness: 8.0 * of(p.z) })
    });
    let lights = vec(light, 0..3);
    (proptest::sample::select(PRESETS), vec(object, 0..5), lights).prop_map(|((_, preset), objects, lights)| {
        SceneSpec {
            preset,
            objects: objects
                .into_iter()
                .enumerate()
                .map(|(i, (shape, translate, scale, color, segments, child))| ObjectSpec {
                    texture: (i % 2 == 1).then(|| TextureSource::of(["chequer", "none", "a \"b\".png"][i % 3])),
                    wrap: (segments % 4 == 1).then_some(Wrap::Mirror),
                    filter: (segments % 5 == 1).then_some(Filter::Nearest),
                    texture_scale: DVec2::new(f64::from(segments) / 4.0, -1.0),
                    name: format!("peça \"{i}\""),
                    shape,
                    parent: (child && i > 0).then(|| "peça \"0\"".to_owned()),
                    translate,
                    rotate: translate,
                    scale: DVec3::select(scale.cmpeq(DVec3::ZERO), DVec3::ONE, scale),
                    color: color.map(|[r, g, b, a]| Rgba { r, g, b, a }),
                    segments,
                    outline: child,
                })
                .collect(),
            lights: lights.into_iter().filter(|l| l.vector != DVec3::ZERO).collect(),
        }
    })
}

fn figure() -> impl Strategy<Value = Figure> {
    let viewport = proptest::option::of((-100..100, 1_u32..=16_384, 0.0..=1.0, 0.0..=1.0).prop_map(
        |(x, width, depth_near, depth_far)| Viewport { x, y: -x, width, height: width, depth_near, depth_far },
    ));
    let style = (
        proptest::sample::select(SHADINGS),
        proptest::sample::select(VISIBILITIES),
        proptest::sample::select(DEPTH_FORMATS),
        (proptest::sample::select(VERTEX_FORMATS), proptest::sample::select(&SubpixelBits::ALL[..])),
        proptest::sample::select(FACE_ORDERS),
    );
    let style = style.prop_map(|(shading, visibility, depth_format, ((_, vertex_format), bits), order)| Style {
        shading: shading.1,
        visibility: visibility.1,
        hidden_lines: HiddenLines::Shown,
        antialias: Samples::Sixteen,
        theme: Theme::Dark,
        depth_format: depth_format.1,
        vertex_format,
        subpixel_bits: bits,
        order: order.1,
    });
    let observer = || {
        proptest::option::of((point(), 0.1..1e4, -90.0..=90.0, any::<bool>()).prop_map(
            |(target, distance, elevation, parallel)| Observer {
                target,
                distance,
                azimuth: elevation * 5.0,
                elevation,
                roll: if parallel { elevation } else { 0.0 },
                parallel,
            },
        ))
    };
    let reveal = (0..3_usize, 0..4_usize, any::<[bool; 5]>()).prop_map(
        |(depth, outside, [clipping, divide_first, culled, vanishing, undistorted])| {
            let reveal = Reveal {
                depth: [Depth::Off, Depth::Stored, Depth::Linear][depth],
                outside: [Outside::Usual, Outside::Cut, Outside::Tinted, Outside::Shown][outside],
                clipping,
                divide_first,
                culled,
                vanishing,
                single_precision: clipping && vanishing,
                texture: culled.then_some(if clipping { TextureReveal::Affine } else { TextureReveal::Texels }),
                shadows: [None, Some(ShadowReveal::Map), Some(ShadowReveal::Truth)][depth],
                cost: [Some(CostReveal::Overdraw), None, Some(CostReveal::Error)][depth],
            };
            (reveal, undistorted)
        },
    );
    let points = vec(point(), 0..4);
    let seen = (observer(), observer());
    let texts = proptest::array::uniform3("\\PC{0,9}");
    let show = (show(), screen(), texts);
    let compare = proptest::option::of((0.0..=1.0, 0..3_usize, any::<[bool; 2]>()).prop_map(
        |(wiper, keys, [beside, differences])| {
            let other = [("style.shading", "\"phong\""), ("camera.near", "1e-3"), ("show.step", "{ way = \"notes\" }")];
            let with = other[keys..].iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
            let ops = vec![Operation::Zoom(1.5), Operation::Pan { dx: 1.0, dy: -0.25 }];
            Comparison { with, ops, camera: None, wiper, beside, differences }
        },
    ));
    let seen = (seen, compare, labels(), vec(parameters(), 0..3));
    (parameters(), 1_u32..=16_384, viewport, scene(), (style, points), reveal, seen, show).prop_map(
        |(
            camera,
            width,
            viewport,
            scene,
            (style, points),
            (reveal, undistorted),
            ((world, canonical), compare, labels, cameras),
            (show, screen, texts),
        )| Figure {
            title: told(&texts[0], &texts[0]),
            caption: told(&texts[1], &texts[2]),
            lens: None,
            camera,
            tag: CameraTag { name: undistorted.then(|| "q \"0\"".to_owned()), color: None },
            cameras: cameras
                .into_iter()
                .enumerate()
                .map(|(i, parameters)| NamedCamera {
                    name: format!("c \"{i}\""),
                    color: reveal.culled.then(|| Rgba::rgb(1, 2, 3)),
                    parameters,
                    lens: None,
                })
                .collect(),
            image: ImageSize { width, height: 16_385 - width },
            undistorted,
            photograph: undistorted
                .then(|| Photograph { file: format!("{width} \"p\".jpg"), opacity: 1.0 / f64::from(width) }),
            viewport,
            scene,
            style,
            points: points
                .into_iter()
                .enumerate()
                .map(|(i, position)| NamedPoint { name: format!("p \"{i}\""), position })
                .collect(),
            reveal,
            world: WorldLook {
                section: undistorted,
                dimensions: reveal.culled,
                window_opacity: reveal.clipping.then_some(0.4),
                axes_length: reveal.clipping.then_some(1.5),
                parts: parts(width),
            },
            observers: Observers { world, canonical },
            show,
            screen,
            compare,
            labels,
        },
    )
}

/// Parts of the world, one for each bit.
fn parts(bits: u32) -> WorldParts {
    let mut parts = WorldParts::default();
    for (k, (part, _)) in WorldPart::ALL.into_iter().enumerate() {
        parts.set(part, bits >> k & 1 == 0);
    }
    parts
}

/// A text in both languages; `None` if one is empty.
fn told(en: &str, pt_br: &str) -> Option<Localized> {
    let is_there = |text: &str| !text.trim().is_empty() && !text.contains(crate::sanitize::is_obeyed);
    (is_there(en) && is_there(pt_br)).then(|| [en.to_owned(), pt_br.to_owned()].into())
}

/// Any changes of labels, and notes.
fn labels() -> impl Strategy<Value = Labels> {
    let name =
        || "\\PC{1,9}".prop_filter("a name", |name| crate::figure::labels::set_text(&name.replace('$', "S")).is_ok());
    let text = || "\\PC{1,9}".prop_filter("a text", |text| crate::figure::labels::set_text(text).is_ok());
    let pair = || (-9.0..9.0_f64, -9.0..9.0_f64).prop_map(|(x, y)| DVec2::new(x, y));
    let view = || proptest::option::of(select(&View::ALL));
    let look = || (proptest::option::of(0.25..8.0_f64), proptest::option::of(any::<[u8; 3]>()));
    let color = |color: Option<[u8; 3]>| color.map(|[r, g, b]| Rgba::rgb(r, g, b));
    let at = (0..4_usize, point(), name()).prop_map(|(kind, p, object)| match kind {
        0 => NotePlace::World(p),
        1 => NotePlace::Vertex { object, vertex: 3 },
        2 => NotePlace::Edge { object, edge: 7 },
        _ => NotePlace::Picture(DVec2::new(0.25, 1.0)),
    });
    let note =
        (view(), at, proptest::option::of(pair()), text(), look()).prop_map(move |(view, at, by, text, (size, of))| {
            let view = view.or(matches!(at, NotePlace::Picture(_)).then_some(View::Image));
            Note { view, at, by, text, size, color: color(of) }
        });
    let styled = (name(), look()).prop_map(move |(name, (size, of))| StyledLabel { name, size, color: color(of) });
    let moved = (name(), view(), pair()).prop_map(|(name, view, by)| MovedLabel { name, view, by });
    let renamed = (name(), view(), text()).prop_map(|(name, view, text)| RenamedLabel { name, view, text });
    let measure = (select(DIMENSIONS), select(MEASURE_TEXTS))
        .prop_map(|((_, measure), (_, shown))| LabelledMeasure { measure, shown });
    let lists = (vec(name(), 0..3), vec(renamed, 0..3), vec(moved, 0..3), vec(styled, 0..3));
    (any::<bool>(), lists, vec(measure, 0..3), vec(note, 0..3)).prop_map(
        |(letters, (hidden, renamed, moved, styled), measures, notes)| Labels {
            letters: if letters { Letters::Mathematics } else { Letters::Plain },
            hidden,
            renamed,
            moved,
            styled,
            measures,
            notes,
        },
    )
}

/// Any state of a window.
fn screen() -> impl Strategy<Value = Screen> {
    let pictures = any::<[bool; 3]>().prop_map(|shown| Some(shown).filter(|shown| *shown != [false; View::COUNT]));
    let arrangement = proptest::option::of(proptest::sample::select(ARRANGEMENTS));
    let panel = proptest::option::of(proptest::sample::select(PANELS));
    let entry = (proptest::sample::select(SCREEN_MATRICES), any::<bool>(), [1..=4_u8, 1..=4_u8]);
    let entry = entry.prop_map(|((_, matrix), inverse, place)| ScreenEntry { matrix, inverse, place });
    let entry = proptest::option::of(entry);
    (pictures, arrangement, panel, entry).prop_map(|(pictures, arrangement, panel, entry)| Screen {
        pictures,
        entry,
        arrangement: arrangement.map(|(_, arrangement)| arrangement),
        panel: panel.map(|(_, panel)| panel),
    })
}

/// Any combination of explanations in the pictures.
fn show() -> impl Strategy<Value = Show> {
    let stage = (proptest::option::of(select(&Stage::ALL)), select(&View::ALL));
    let step = (select(&Decomposition::ALL), proptest::option::of(0.0..=4.0_f64));
    let step = proptest::option::of(step.prop_map(|(way, at)| ShownStep { way, at }));
    let pixel = proptest::option::of((0..9_u32, 0..9_u32).prop_map(|(i, j)| [i, j]));
    let triangle = (".*", 0..u32::MAX, select(&TriangleStep::ALL), pixel)
        .prop_filter_map("a name", |(object, index, step, pixel)| {
            (!object.is_empty()).then_some(ShownTriangle { object, index, step, pixel })
        });
    let measures: Vec<Measured> = MEASURES.iter().map(|(_, measured)| *measured).collect();
    let measure = (vec(proptest::sample::select(measures), 0..4), proptest::option::of("[^\\PC]+"));
    let probe = prop_oneof![
        point().prop_map(ShownProbe::World),
        point().prop_map(|p| ShownProbe::Window(p.truncate())),
        (-9..9_i64, 0..999_i64).prop_map(|(i, j)| ShownProbe::Pixel([i, j])),
    ];
    let preview = (proptest::collection::btree_set(".+", 0..3), point(), point(), any::<[bool; 2]>()).prop_map(
        |(objects, a, b, [wrong, turned])| TransformPreview {
            objects,
            change: DMat4::from_translation(a),
            world_from_frame: DMat4::from_diagonal(b.extend(2.0)),
            axis: turned.then_some(Ray { origin: a, direction: DVec3::NEG_Z }),
            wrong,
        },
    );
    let moved = vec(preview, 0..3);
    let painted = proptest::option::of(0.0..=1.0_f64);
    let answer = proptest::option::of(parameters());
    let ndc = proptest::option::of(proptest::sample::select(&Ndc::ALL[..]));
    let operation = select(&["azimuth=30", "elevation=-12.5", "zoom=0.1", "pan=1,-0.5"]);
    let operations = vec(operation.prop_map(|text| text.parse().unwrap()), 0..=Show::MOST_OPERATIONS);
    let of_camera = (ndc, answer, operations);
    (stage, painted, step, proptest::option::of(triangle), measure, proptest::option::of(probe), moved, of_camera)
        .prop_map(|((stage, of), painted, step, triangle, (measure, measure_of), probe, moved, of_camera)| Show {
            stage,
            stage_of: StagePicture(of),
            painted,
            step,
            triangle,
            measure,
            measure_of,
            probe,
            moved,
            ndc: of_camera.0,
            answer: of_camera.1,
            operations: of_camera.2,
        })
}

fn select<T: Copy + std::fmt::Debug + 'static>(all: &'static [T]) -> impl Strategy<Value = T> {
    proptest::sample::select(all)
}

const BY_HAND: &str = r##"# My figure, for the third lecture
[style] # first, for a change
theme = "dark" # the room is dark

[camera]
near = 1     # an integer
position = [ 3,
             4, # up
             5 ]

  # the torus
  [[scene.objects]]
  name = "torus"   # its name
  shape = "torus"
  # the box
  [[scene.objects]]
  name = "box"
  shape = "box"
  color = "#ff0000" # red
# the end
"##;

const OTHER_FORMS: [&str; 5] = [
    "",
    BY_HAND,
    "camera.near = 0.5\ncamera.far = 7 # far\nscene = { preset = \"cube\", objects = [{ name = \"a\" }, { name = \"b\" }] }\n",
    "camera = { near = 0.5, window = { left = -1, right = 1, bottom = -1, top = 1 } } # all\r\n[scene]\r\nobjects = [{ shape = \"box\" }] # one\r\n",
    "\u{feff}[camera.window] # w\nleft = -1\nright = 1\nbottom = -1\ntop = 1\n[observers]\nworld = { distance = 3 } # near\n",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn written_figures_read_back(figure in figure()) {
        let text = to_toml(&figure);
        let back = read::parse(&text);
        prop_assert_eq!(back.as_ref(), Ok(&figure), "{}", &text);
        prop_assert_eq!(to_toml(&back.unwrap()), text);
    }

    #[test]
    fn edited_figures_read_back(before in figure(), after in figure(), form in 0..OTHER_FORMS.len()) {
        for text in [OTHER_FORMS[form], &to_toml(&before)] {
            let edited = edit(text, &after);
            prop_assert!(edited.is_some(), "had to be replaced: {}", text);
            let edited = edited.unwrap();
            let back = read::parse(&edited);
            prop_assert_eq!(back.as_ref(), Ok(&after), "{}", edited);
        }
    }
}

#[test]
fn a_layout_is_written_beside_comments_and_taken_out_again() {
    let text = "# What it is.\ntitle = \"Ours\" # short\n\n[screen] # as in class\npanel = \"depth\"   # at the side\n";
    let mut figure = read::parse(text).unwrap();
    figure.screen.panel = Some(None);
    figure.screen.pictures = Some([true, false, false]);
    let edited = update(text, &figure);
    assert_eq!(edited, text.replace("\"depth\" ", "\"none\" ") + "pictures = [\"world\"]\n");
    figure.screen = Screen::default();
    assert_eq!(update(text, &figure), "# What it is.\ntitle = \"Ours\" # short\n");
}

#[test]
fn the_first_key_of_a_comparison_is_written_first() {
    let text = "[compare]\nwiper = 0.25 # left\n[compare.with]\n\"camera.near\" = 0.5 # near\n";
    let mut figure = read::parse(text).unwrap();
    let compare = figure.compare.as_mut().unwrap();
    compare.with.insert(0, ("style.shading".to_owned(), "\"flat\"".to_owned()));
    let edited = edit(text, &figure).unwrap();
    assert_eq!(read::parse(&edited).as_ref(), Ok(&figure));
    assert!(edited.contains("# left") && edited.contains("# near"), "{edited}");
}

#[test]
fn a_figure_that_did_not_change_leaves_the_text_alone() {
    for text in OTHER_FORMS {
        assert_eq!(update(text, &read::parse(text).unwrap()), text);
    }
}

#[test]
fn comments_and_order_stay() {
    let mut figure = read::parse(BY_HAND).unwrap();
    figure.camera.near = 0.25;
    figure.camera.far = 50.0;
    figure.style.theme = Theme::Print;
    figure.scene.objects[1].color = None;
    figure.scene.objects[1].segments = 12;
    figure.image.width = 800;
    let expected = BY_HAND
        .replace("near = 1 ", "near = 0.25 ")
        .replace("5 ]\n", "5 ]\nfar = 50.0\n")
        .replace("theme = \"dark\" #", "theme = \"print\" #")
        .replace("  color = \"#ff0000\" # red\n", "segments = 12\n");
    let edited = update(BY_HAND, &figure);
    assert_eq!(edited.replace("\n[image]\nwidth = 800\nheight = 768\n", ""), expected, "{edited}");
}

#[test]
fn objects_keep_their_comments_when_others_come_and_go() {
    let mut figure = read::parse(BY_HAND).unwrap();
    figure.scene.objects.remove(0);
    let without = update(BY_HAND, &figure);
    assert!(without.contains("# the box") && !without.contains("# the torus"), "{without}");
    let mut turned = read::parse(BY_HAND).unwrap();
    turned.scene.objects.reverse();
    let edited = update(BY_HAND, &turned);
    assert!(edited.find("# the box") < edited.find("# the torus"), "{edited}");
    assert!(edited.contains("# red") && edited.contains("# its name"), "{edited}");
}

#[test]
fn a_moved_point_keeps_its_typed_formulas_and_those_of_others() {
    let text = concat!(
        "[[points]]\nname = \"P\" # the corner\nposition = [\"sqrt(2)/2\", 1, 2] # exact\n",
        "# the other\n[[points]]\nposition = [0, 0, 3]\nname = \"Q\"\n",
    );
    let mut figure = read::parse(text).unwrap();
    figure.points[0].position.y = 1.5;
    let edited = update(text, &figure);
    assert_eq!(edited, text.replace("\", 1, 2]", "\", 1.5, 2]"));
    figure.points.remove(0);
    let without = update(&edited, &figure);
    assert_eq!(without, "# the other\n[[points]]\nposition = [0, 0, 3]\nname = \"Q\"\n");
    figure.points.clear();
    assert_eq!(read::parse(&update(&without, &figure)).unwrap(), Figure::default());
}

#[test]
fn forms_that_others_use_are_edited_in_place() {
    let mut figure = read::parse(OTHER_FORMS[2]).unwrap();
    figure.camera.far = 9.0;
    figure.scene.preset = Preset::House;
    let expected = OTHER_FORMS[2].replace("far = 7", "far = 9.0").replace("cube", "house");
    assert_eq!(update(OTHER_FORMS[2], &figure), expected);
}

#[test]
fn line_ends_of_windows_stay() {
    let mut figure = read::parse(OTHER_FORMS[3]).unwrap();
    figure.style.antialias = Samples::One;
    figure.camera.near = 0.75;
    let edited = update(OTHER_FORMS[3], &figure);
    assert!(edited.contains("near = 0.75") && edited.contains("# one"), "{edited}");
    assert_eq!(edited.matches('\n').count(), edited.matches("\r\n").count(), "{edited:?}");
}

#[test]
fn text_that_is_not_a_figure_is_replaced() {
    assert_eq!(update("[camera]\nnear = what", &Figure::default()), to_toml(&Figure::default()));
}

#[test]
fn a_renamed_object_keeps_its_comments_although_another_is_deleted() {
    let text = "[[scene.objects]]\n# the ring\nname = \"torus\"\nshape = \"torus\"\ntranslate = [1, 0, 0]\n\n\
                [[scene.objects]]\n# the crate\nname = \"box\"\nshape = \"box\"\nscale = [2, 1, 1]\n";
    let mut figure = read::parse(text).unwrap();
    figure.scene.objects.remove(0);
    figure.scene.objects[0].name = "crate".to_owned();
    let edited = update(text, &figure);
    assert!(edited.contains("# the crate") && !edited.contains("# the ring"), "{edited}");
}

#[test]
fn a_renamed_object_keeps_its_comments_although_another_is_added_before_it() {
    let text = "[[scene.objects]]\n# the ring\nname = \"torus\"\nshape = \"torus\"\n\n\
                [[scene.objects]]\n# the crate\nname = \"box\"\nshape = \"box\"\nscale = [2, 1, 1]\n";
    let mut figure = read::parse(text).unwrap();
    let mut second = figure.scene.objects[0].clone();
    second.name = "torus 2".to_owned();
    figure.scene.objects.insert(1, second);
    figure.scene.objects[2].name = "crate".to_owned();
    let edited = update(text, &figure);
    let at = |what: &str| edited.find(what).unwrap();
    assert!(at("\"torus 2\"") < at("# the crate") && at("# the crate") < at("\"crate\""), "{edited}");
    assert_eq!(edited.matches("# the").count(), 2, "{edited}");
}

#[test]
fn expressions_stay_when_something_else_changes() {
    let text =
        "[camera]\nposition = [\"sqrt(2)\", 4, 5] # on the diagonal\nview_angle = \"2*atan(1/2) rad\"\nnear = 0.5\n";
    let mut figure = read::parse(text).unwrap();
    figure.camera.near = 0.25;
    figure.camera.position.y = 3.0;
    let edited = update(text, &figure);
    assert!(edited.contains("position = [\"sqrt(2)\", 3.0, 5] # on the diagonal\n"), "{edited}");
    assert!(edited.contains("view_angle = \"2*atan(1/2) rad\"\nnear = 0.25\n"), "{edited}");
    assert_eq!(read::parse(&edited).unwrap(), figure);
    figure.camera.view_angle = 60.0;
    assert!(update(&edited, &figure).contains("view_angle = 60.0\n"), "its own change replaces it");
}

#[test]
fn names_of_all_kinds_stay_on_their_line_and_read_back() {
    let names = ["plain", "two \"quotes\"", "it's", "back\\slash", "line\nend", "tab\tand\u{7f}del\u{1}", "ç → 한"];
    let mut figure = Figure::default();
    figure.scene.objects = names.iter().map(|name| ObjectSpec::new(*name, Shape::Box)).collect();
    let text = to_toml(&figure);
    assert_eq!(read::parse(&text).as_ref(), Ok(&figure));
    assert_eq!(text.lines().filter(|line| line.starts_with("name = \"") && line.ends_with('"')).count(), names.len());
    assert!(text.contains("\nview_angle = 45.0\n") && text.contains("\nposition = [3.0, 4.0, 5.0]\n"), "{text}");
}

#[test]
fn one_of_very_many_objects_is_edited_in_the_time_of_reading_them() {
    const MANY: usize = 5000;
    let named = |prefix: &str| {
        let mut figure = Figure::default();
        figure.scene.objects = (0..MANY).map(|i| ObjectSpec::new(format!("{prefix}{i}"), Shape::Box)).collect();
        figure
    };
    let figure = named("object ");
    let text = to_toml(&figure);
    let begin = std::time::Instant::now();
    assert_eq!(read::parse(&text).as_ref(), Ok(&figure));
    let reading = begin.elapsed();

    let mut moved = figure.clone();
    moved.scene.objects[4000].translate.x = 1.0;
    let mut lights = figure.clone();
    lights.scene.lights =
        (1..=MAX_LIGHTS).map(|i| Light::point(DVec3::new(f64::from(u32::try_from(i).unwrap()), 0.0, 0.0))).collect();
    let lit = to_toml(&lights);
    let mut relit = lights.clone();
    relit.scene.lights.reverse();
    relit.scene.lights.iter_mut().for_each(|light| *light = Light::point(DVec3::Y));
    // One moved, all renamed, or all lights, which have no names, replaced.
    for (text, figure) in [(&text, &moved), (&text, &named("thing ")), (&lit, &relit)] {
        let begin = std::time::Instant::now();
        let edited = update(text, figure);
        let editing = begin.elapsed();
        assert_eq!(read::parse(&edited).as_ref(), Ok(figure));
        // Comparing all names with all takes several hundred times as long as reading. The text is read three times in
        // an edit.
        assert!(editing < 40 * reading, "{editing:?} to edit, {reading:?} to read");
    }
}
