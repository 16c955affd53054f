//! The words of a figure file, each name in the file with its value.

use super::{
    Arrangement, CostReveal, Depth, Explanation, Letters, Measure, MeasureText, Measured, Outside, ScreenMatrix,
    ShadowReveal, StagePicture, TriangleStep, View, WindowSide,
};
use crate::appearance::{DepthFormat, FaceOrder, HiddenLines, Shading, TextureReveal, Theme, VertexFormat, Visibility};
use crate::camera::{Decomposition, Ndc, Projection, SensorFit};
use crate::scene::{LightKind, Preset, Shape};
use crate::stage::Stage;

/// Names and their values, in the order of menus.
pub type Words<T> = &'static [(&'static str, T)];

/// `projection`
pub const PROJECTIONS: Words<Projection> =
    &[("perspective", Projection::Perspective), ("parallel", Projection::Parallel)];

/// `[camera] lens.fit`
pub const SENSOR_FITS: Words<SensorFit> =
    &[("horizontal", SensorFit::Horizontal), ("vertical", SensorFit::Vertical), ("larger", SensorFit::Larger)];

/// `[scene] preset`
pub const PRESETS: Words<Preset> = Preset::NAMED;

/// `[style] shading`
pub const SHADINGS: Words<Shading> = &[
    ("wireframe", Shading::Wireframe),
    ("flat", Shading::Flat),
    ("gouraud", Shading::Gouraud),
    ("phong", Shading::Phong),
];

/// `[style] visibility`
pub const VISIBILITIES: Words<Visibility> =
    &[("depth-buffer", Visibility::DepthBuffer), ("painter", Visibility::Painter), ("bsp", Visibility::Bsp)];

/// `[style] hidden_lines`
pub const HIDDEN_LINES: Words<HiddenLines> =
    &[("dashed", HiddenLines::Dashed), ("hidden", HiddenLines::Hidden), ("shown", HiddenLines::Shown)];

/// `[style] theme`
pub const THEMES: Words<Theme> = &[("light", Theme::Light), ("dark", Theme::Dark), ("print", Theme::Print)];

/// `[style] depth_format`
pub const DEPTH_FORMATS: Words<DepthFormat> =
    &[("fixed-16", DepthFormat::Fixed16), ("fixed-24", DepthFormat::Fixed24), ("f32-reversed", DepthFormat::Float)];

/// `[style] vertex_format`
pub const VERTEX_FORMATS: Words<VertexFormat> = &[
    ("f64", VertexFormat::F64),
    ("f32", VertexFormat::F32),
    ("f16", VertexFormat::F16),
    ("bf16", VertexFormat::Bf16),
    ("fixed-16.16", VertexFormat::Fixed16),
];

/// `[style] order`
pub const FACE_ORDERS: Words<FaceOrder> = FaceOrder::NAMED;

/// `[reveal] depth`, besides `true` and `false`
pub const DEPTHS: Words<Depth> = &[("linear", Depth::Linear)];

/// `[reveal] outside`
pub const OUTSIDES: Words<Outside> = &[("cut", Outside::Cut), ("tinted", Outside::Tinted), ("shown", Outside::Shown)];

/// `[reveal] texture`
pub const TEXTURE_REVEALS: Words<TextureReveal> =
    &[("affine", TextureReveal::Affine), ("levels", TextureReveal::Levels), ("texels", TextureReveal::Texels)];

/// `[reveal] shadows`
pub const SHADOW_REVEALS: Words<ShadowReveal> =
    &[("map", ShadowReveal::Map), ("acne", ShadowReveal::Acne), ("truth", ShadowReveal::Truth)];

/// `[reveal] cost`
pub const COST_REVEALS: Words<CostReveal> = CostReveal::NAMED;

/// `[[scene.objects]] shape`. Shapes with data are empty here.
pub const SHAPES: Words<Shape> = Shape::NAMED;

/// `[[scene.lights]] kind`
pub const LIGHTS: Words<LightKind> = LightKind::NAMED;

/// `[show] stage`
pub const STAGES: Words<Stage> = Stage::NAMED;

/// `[show] stage_of`
pub const STAGE_PICTURES: Words<StagePicture> = &[
    (View::World.name(), StagePicture(View::World)),
    (View::Canonical.name(), StagePicture(View::Canonical)),
    (View::Image.name(), StagePicture(View::Image)),
];

/// `[show] step`, its `way`
pub const WAYS: Words<Decomposition> = Decomposition::NAMED;

/// `[show] ndc`
pub const NDCS: Words<Ndc> = &{
    let mut all = [("", Ndc::ALL[0]); Ndc::ALL.len()];
    let mut i = 0;
    while i < all.len() {
        all[i] = (Ndc::ALL[i].name(), Ndc::ALL[i]);
        i += 1;
    }
    all
};

/// `[screen] pictures`
pub const PICTURES: Words<View> = View::NAMED;

/// `[screen] arrangement`; `None` means automatic.
pub const ARRANGEMENTS: Words<Option<Arrangement>> = &[
    ("auto", None),
    ("row", Some(Arrangement::Row)),
    ("column", Some(Arrangement::Column)),
    ("above", Some(Arrangement::Above)),
    ("beside", Some(Arrangement::Beside)),
];

/// `[screen] panel`: [`EXPLANATIONS`], or none.
pub const PANELS: Words<Option<Explanation>> = &{
    let mut all = [("none", None); EXPLANATIONS.len() + 1];
    let mut i = 0;
    while i < EXPLANATIONS.len() {
        all[i] = (EXPLANATIONS[i].0, Some(EXPLANATIONS[i].1));
        i += 1;
    }
    all
};

/// The explanations at the side of the window.
pub const EXPLANATIONS: Words<Explanation> = Explanation::NAMED;

/// `[show] triangle`, its `step`
pub const TRIANGLE_STEPS: Words<TriangleStep> = TriangleStep::NAMED;

/// `[show] measure`: the notes' symbols, with a component after a point.
pub const MEASURES: Words<Measured> = &[
    ("F", Measured::Dimension(Measure::Near)),
    ("B", Measured::Dimension(Measure::Far)),
    ("D", Measured::Dimension(Measure::Distance)),
    ("W", Measured::Dimension(Measure::Width)),
    ("H", Measured::Dimension(Measure::Height)),
    ("theta", Measured::Dimension(Measure::HalfAngle)),
    ("l", Measured::Side(WindowSide::Left)),
    ("r", Measured::Side(WindowSide::Right)),
    ("b", Measured::Side(WindowSide::Bottom)),
    ("t", Measured::Side(WindowSide::Top)),
    ("u.x", Measured::Axis(0, 0)),
    ("u.y", Measured::Axis(0, 1)),
    ("u.z", Measured::Axis(0, 2)),
    ("v.x", Measured::Axis(1, 0)),
    ("v.y", Measured::Axis(1, 1)),
    ("v.z", Measured::Axis(1, 2)),
    ("n.x", Measured::Axis(2, 0)),
    ("n.y", Measured::Axis(2, 1)),
    ("n.z", Measured::Axis(2, 2)),
    ("u.C", Measured::OriginAlong(0)),
    ("v.C", Measured::OriginAlong(1)),
    ("n.C", Measured::OriginAlong(2)),
    ("C.x", Measured::Position(0)),
    ("C.y", Measured::Position(1)),
    ("C.z", Measured::Position(2)),
    ("PF.x", Measured::FocalPoint(0)),
    ("PF.y", Measured::FocalPoint(1)),
    ("PF.z", Measured::FocalPoint(2)),
    ("VUP.x", Measured::ViewUp(0)),
    ("VUP.y", Measured::ViewUp(1)),
    ("VUP.z", Measured::ViewUp(2)),
    ("translate.x", Measured::Translate(0)),
    ("translate.y", Measured::Translate(1)),
    ("translate.z", Measured::Translate(2)),
    ("rotate.x", Measured::Rotate(0)),
    ("rotate.y", Measured::Rotate(1)),
    ("rotate.z", Measured::Rotate(2)),
    ("scale.x", Measured::Scale(0)),
    ("scale.y", Measured::Scale(1)),
    ("scale.z", Measured::Scale(2)),
];

/// `[labels] letters`
pub const LETTERS: Words<Letters> = &[("plain", Letters::Plain), ("mathematics", Letters::Mathematics)];

/// `[[labels.measures]] name`
pub const DIMENSIONS: Words<Measure> = &[
    ("F", Measure::Near),
    ("B", Measure::Far),
    ("D", Measure::Distance),
    ("W", Measure::Width),
    ("H", Measure::Height),
    ("W/2", Measure::HalfWidth),
    ("H/2", Measure::HalfHeight),
    ("theta", Measure::Angle),
    ("theta/2", Measure::HalfAngle),
];

/// `[[labels.measures]] as`
pub const MEASURE_TEXTS: Words<MeasureText> =
    &[("symbol", MeasureText::Symbol), ("value", MeasureText::Value), ("both", MeasureText::Both)];

/// The value called `name`.
pub fn value<T: Clone>(words: Words<T>, name: &str) -> Option<T> {
    words.iter().find(|(word, _)| *word == name).map(|(_, value)| value.clone())
}

/// The word for `value`. Empty if the list lacks it, which a test excludes.
pub fn name<T: Copy + PartialEq>(words: Words<T>, value: T) -> &'static str {
    words.iter().find(|(_, v)| *v == value).map_or("", |(word, _)| word)
}

/// All names, in order.
pub(super) fn names<T>(words: Words<T>) -> Vec<&'static str> {
    words.iter().map(|(word, _)| *word).collect()
}

/// `[screen] entry.matrix`
pub const SCREEN_MATRICES: Words<ScreenMatrix> = ScreenMatrix::NAMED;
