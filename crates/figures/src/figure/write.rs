//! [`Figure`] → the text of a figure file.

mod cameras;
mod comparison;
mod labels;
mod show;

use glam::{DVec2, DVec3};
use toml_edit::{Array, ArrayOfTables, DocumentMut, InlineTable, Item, Table, Value};

use super::words::{
    self, ARRANGEMENTS, DEPTH_FORMATS, DEPTHS, HIDDEN_LINES, OUTSIDES, PANELS, PROJECTIONS, SCREEN_MATRICES,
    SENSOR_FITS, SHADINGS, SHADOW_REVEALS, TEXTURE_REVEALS, THEMES, VISIBILITIES,
};
use super::{
    Bilingual, Depth, Figure, Labels, NamedPoint, Observer, Outside, Photograph, Reveal, Screen, ScreenEntry, Show,
    View, WorldLook, WorldPart,
};
use crate::appearance::{DepthFormat, Style};
use crate::camera::{LensForm, Parameters, Projection, Sensor, Viewport};
use crate::numbers;
use crate::scene::{Light, ObjectSpec, SceneSpec, Shadows, Shape, ShapeData};

/// The figure file of `figure`, with its keys in the order of the documentation.
///
/// # Guarantees
/// Reading the text gives the same figure back, every number to the last bit, for each figure that a file can hold.
pub fn to_toml(figure: &Figure) -> String {
    document(figure).to_string()
}

/// The figure file as a document.
pub(super) fn document(figure: &Figure) -> DocumentMut {
    let mut document = DocumentMut::new();
    for (key, text) in [("title", &figure.title), ("caption", &figure.caption)] {
        if let Some(text) = text {
            document.insert(key, Item::Value(told(text)));
        }
    }
    let mut put = |key: &str, section: Table| document.insert(key, Item::Table(section));
    put("camera", cameras::current(figure));
    let size = figure.image;
    let mut image = table([("width", i64::from(size.width).into()), ("height", i64::from(size.height).into())]);
    if figure.undistorted {
        image.insert("undistorted", Item::Value(true.into()));
    }
    // Both or none, because the reader refuses an opacity alone.
    if let Some(Photograph { file, opacity }) = &figure.photograph {
        image.insert("photograph", Item::Value(quoted(file)));
        image.insert("photograph_opacity", Item::Value(number(*opacity)));
    }
    put("image", image);
    if let Some(v) = figure.viewport {
        put("viewport", viewport(v));
    }
    put("scene", scene(&figure.scene));
    put("style", style(&figure.style));
    if figure.reveal != Reveal::default() {
        put("reveal", reveal(figure.reveal));
    }
    if figure.world != WorldLook::default() {
        put("world", world(figure.world));
    }
    let observers = [("world", figure.observers.world), ("canonical", figure.observers.canonical)];
    let mut sections = Table::new();
    // Without a line of its own, because only [observers.world] and [observers.canonical] are written.
    sections.set_implicit(true);
    for (key, given) in observers {
        if let Some(o) = given {
            sections.insert(key, Item::Table(observer(o)));
        }
    }
    if !sections.is_empty() {
        put("observers", sections);
    }
    if figure.show != Show::default() {
        put("show", show::show(&figure.show));
    }
    if figure.screen != Screen::default() {
        put("screen", screen(figure.screen));
    }
    if let Some(comparison) = &figure.compare {
        put("compare", comparison::comparison(comparison));
    }
    if figure.labels != Labels::default() {
        put("labels", labels::labels(&figure.labels));
    }
    let cameras = cameras::cameras(figure);
    if !cameras.is_empty() {
        document.insert("cameras", Item::ArrayOfTables(cameras));
    }
    let points: ArrayOfTables = figure.points.iter().map(point).collect();
    if !points.is_empty() {
        document.insert("points", Item::ArrayOfTables(points));
    }
    document
}

fn camera(p: &Parameters, form: Option<LensForm>) -> Table {
    let (lens_key, lens) = match form {
        Some(LensForm::HorizontalAngle(degrees)) => ("horizontal_angle", number(degrees)),
        Some(LensForm::FocalLength { focal_length, sensor }) => ("lens", lens(focal_length, sensor)),
        Some(LensForm::DiagonalAngle(_)) | None => ("view_angle", number(p.view_angle)),
    };
    let mut section = table([
        ("position", vector(p.position)),
        ("focal_point", vector(p.focal_point)),
        ("view_up", vector(p.view_up)),
        ("projection", words::name(PROJECTIONS, p.projection).into()),
        (lens_key, lens),
        ("height", number(p.height)),
        ("aspect", number(p.aspect)),
        ("near", number(p.near)),
        ("far", number(p.far)),
    ]);
    if let Some(w) = p.window {
        let sides = [("left", w.left), ("right", w.right), ("bottom", w.bottom), ("top", w.top)];
        let sides: InlineTable = sides.into_iter().map(|(side, x)| (side, number(x))).collect();
        section.insert("window", Item::Value(sides.into()));
    }
    section
}

fn lens(focal_length: f64, Sensor { width, height, fit }: Sensor) -> Value {
    let sensor: Array = [width, height].into_iter().map(number).collect();
    let fit = Value::from(words::name(SENSOR_FITS, fit));
    let keys = [("focal_length", number(focal_length)), ("sensor", sensor.into()), ("fit", fit)];
    keys.into_iter().collect::<InlineTable>().into()
}

fn viewport(v: Viewport) -> Table {
    table([
        ("x", i64::from(v.x).into()),
        ("y", i64::from(v.y).into()),
        ("width", i64::from(v.width).into()),
        ("height", i64::from(v.height).into()),
        ("depth_near", number(v.depth_near)),
        ("depth_far", number(v.depth_far)),
    ])
}

fn scene(spec: &SceneSpec) -> Table {
    let mut section = table([("preset", spec.preset.name().into())]);
    let objects: ArrayOfTables = spec.objects.iter().map(object).collect();
    let lights: ArrayOfTables = spec.lights.iter().map(light).collect();
    for (key, list) in [("objects", objects), ("lights", lights)] {
        if !list.is_empty() {
            section.insert(key, Item::ArrayOfTables(list));
        }
    }
    section
}

fn object(object: &ObjectSpec) -> Table {
    let mut keys: Vec<(&str, Value)> = vec![("name", quoted(&object.name))];
    if let Some(shape) = &object.shape {
        keys.push(("shape", shape.name().into()));
        match shape.data() {
            ShapeData::Points(points) => keys.push(("points", vectors(points))),
            ShapeData::Path(path) => keys.push(("path", quoted(path))),
            ShapeData::None => {}
        }
    }
    if let Some(parent) = &object.parent {
        keys.push(("parent", quoted(parent)));
    }
    for (key, value, default) in [
        ("translate", object.translate, DVec3::ZERO),
        ("rotate", object.rotate, DVec3::ZERO),
        ("scale", object.scale, DVec3::ONE),
    ] {
        // −0 isn't 0, so they're compared bit by bit.
        if value.to_array().map(f64::to_bits) != default.to_array().map(f64::to_bits) {
            keys.push((key, vector(value)));
        }
    }
    if let Some(color) = object.color {
        keys.push(("color", color.to_string().into()));
    }
    if object.segments != Shape::usual_segments(object.shape.as_ref()) {
        keys.push(("segments", i64::from(object.segments).into()));
    }
    keys.extend(object.texture.as_ref().map(|texture| ("texture", quoted(&texture.to_string()))));
    keys.extend(object.wrap.map(|wrap| ("wrap", wrap.name().into())));
    keys.extend(object.filter.map(|filter| ("filter", filter.name().into())));
    if object.texture_scale != DVec2::ONE {
        keys.push(("texture_scale", object.texture_scale.to_array().map(number).into_iter().collect::<Array>().into()));
    }
    table(keys)
}

fn light(light: &Light) -> Table {
    let (Shadows { cast, map, bias, softness }, usual) = (light.shadows, Shadows::NONE);
    let mut keys: Vec<(&str, Value)> =
        vec![("kind", light.kind.name().into()), (light.kind.vector().0, vector(light.vector))];
    keys.extend(cast.then(|| ("shadows", true.into())));
    keys.extend((map != usual.map).then(|| ("shadow_map", i64::from(map).into())));
    keys.extend((bias != usual.bias).then(|| ("shadow_bias", number(bias))));
    keys.extend((softness != usual.softness).then(|| ("shadow_softness", number(softness))));
    table(keys)
}

fn point(point: &NamedPoint) -> Table {
    table([("name", quoted(&point.name)), ("position", vector(point.position))])
}

fn style(style: &Style) -> Table {
    let mut section = table([
        ("shading", words::name(SHADINGS, style.shading).into()),
        ("visibility", words::name(VISIBILITIES, style.visibility).into()),
        ("hidden_lines", words::name(HIDDEN_LINES, style.hidden_lines).into()),
        ("antialias", i64::from(style.antialias.count()).into()),
        ("theme", words::name(THEMES, style.theme).into()),
    ]);
    if style.depth_format != DepthFormat::default() {
        section.insert("depth_format", Item::Value(words::name(DEPTH_FORMATS, style.depth_format).into()));
    }
    section
}

fn reveal(reveal: Reveal) -> Table {
    let mut keys: Vec<(&str, Value)> = Vec::new();
    match reveal.depth {
        Depth::Off => {}
        Depth::Stored => keys.push(("depth", true.into())),
        depth @ Depth::Linear => keys.push(("depth", words::name(DEPTHS, depth).into())),
    }
    if reveal.outside != Outside::Usual {
        keys.push(("outside", words::name(OUTSIDES, reveal.outside).into()));
    }
    keys.extend(reveal.texture.map(|texture| ("texture", words::name(TEXTURE_REVEALS, texture).into())));
    keys.extend(reveal.shadows.map(|shadows| ("shadows", words::name(SHADOW_REVEALS, shadows).into())));
    let switches = [
        ("clipping", reveal.clipping),
        ("divide_first", reveal.divide_first),
        ("culled", reveal.culled),
        ("vanishing", reveal.vanishing),
        ("single_precision", reveal.single_precision),
    ];
    keys.extend(switches.into_iter().filter(|(_, on)| *on).map(|(key, on)| (key, on.into())));
    table(keys)
}

fn world(world: WorldLook) -> Table {
    let mut keys: Vec<(&str, Value)> = Vec::new();
    let switches = [("section", world.section), ("dimensions", world.dimensions)];
    keys.extend(switches.into_iter().filter(|(_, on)| *on).map(|(key, on)| (key, on.into())));
    keys.extend(world.window_opacity.map(|opacity| ("window_opacity", number(opacity))));
    keys.extend(world.axes_length.map(|length| ("axes_length", number(length))));
    let left_out = WorldPart::ALL.into_iter().filter(|(part, _)| !world.parts.has(*part));
    keys.extend(left_out.map(|(_, key)| (key, false.into())));
    table(keys)
}

fn observer(o: Observer) -> Table {
    let projection = if o.parallel { Projection::Parallel } else { Projection::Perspective };
    let mut keys = vec![
        ("target", vector(o.target)),
        ("distance", number(o.distance)),
        ("azimuth", number(o.azimuth)),
        ("elevation", number(o.elevation)),
    ];
    if o.roll != 0.0 {
        keys.push(("roll", number(o.roll)));
    }
    keys.push(("projection", words::name(PROJECTIONS, projection).into()));
    table(keys)
}

fn screen(screen: Screen) -> Table {
    let mut keys: Vec<(&str, Value)> = Vec::new();
    if let Some(pictures) = screen.pictures {
        let shown = View::ALL.into_iter().filter(|view| pictures[view.index()]);
        keys.push(("pictures", shown.map(View::name).collect::<Array>().into()));
    }
    keys.extend(screen.arrangement.map(|arrangement| ("arrangement", words::name(ARRANGEMENTS, arrangement).into())));
    keys.extend(screen.panel.map(|panel| ("panel", words::name(PANELS, panel).into())));
    keys.extend(screen.entry.map(|ScreenEntry { matrix, inverse, place: [row, column] }| {
        let matrix = [("matrix", Value::from(words::name(SCREEN_MATRICES, matrix)))];
        let inverse = inverse.then(|| ("inverse", true.into()));
        let place = [("row", i64::from(row).into()), ("column", i64::from(column).into())];
        ("entry", matrix.into_iter().chain(inverse).chain(place).collect::<InlineTable>().into())
    }));
    table(keys)
}

/// A text that's the same in both languages, or one for each.
fn told(text: &Bilingual) -> Value {
    let Bilingual { en, pt_br } = text;
    if en == pt_br {
        return quoted(en);
    }
    [("en", quoted(en)), ("pt-BR", quoted(pt_br))].into_iter().collect::<InlineTable>().into()
}

fn table<'a>(keys: impl IntoIterator<Item = (&'a str, Value)>) -> Table {
    let mut table = Table::new();
    for (key, value) in keys {
        table.insert(key, Item::Value(value));
    }
    table
}

/// A text in double quotes on one line. The library would take several lines for a text with a line end, and those
/// change with the line ends of the file. (JSON escapes the same characters as TOML, except for DEL.)
pub(super) fn quoted(text: &str) -> Value {
    let quoted = serde_json::Value::from(text).to_string().replace('\u{7f}', "\\u007F");
    let mut value = quoted.parse().unwrap_or_else(|_| Value::from(text));
    value.decor_mut().clear();
    value
}

/// The shortest decimal number that reads back as the same `f64`. It's in Rust's notation for floats, because the
/// library's has hundreds of zeros if the number is very large or small.
fn number(x: f64) -> Value {
    let mut value = numbers::exact(x).parse().unwrap_or_else(|_| Value::from(x));
    // Spaces around it belong to its place.
    value.decor_mut().clear();
    value
}

fn vector(v: DVec3) -> Value {
    v.to_array().into_iter().map(number).collect::<Array>().into()
}

fn vectors(points: &[DVec3]) -> Value {
    points.iter().map(|p| vector(*p)).collect::<Array>().into()
}
