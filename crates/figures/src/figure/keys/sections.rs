//! The sections of a figure, and the rows of the short ones.

use glam::DVec3;

use super::{Keys, UNIT, camera, comparison, inline, labels, scene, show};
use crate::appearance::{Style, SubpixelBits};
use crate::camera::{ImageSize, Projection, Viewport};
use crate::figure::error::{Allowed, Problem};
use crate::figure::points::may_be_named;
use crate::figure::read::Section;
use crate::figure::value::{
    ANGLE, POSITIVE, SAMPLES, SUBPIXEL_BITS, SWITCH, TEXT, VECTOR, angle_in, integer_in, number_in, write_told,
};
use crate::figure::words::{
    self, ARRANGEMENTS, COST_REVEALS, DEPTH_FORMATS, DEPTHS, FACE_ORDERS, HIDDEN_LINES, OUTSIDES, PANELS, PICTURES,
    PROJECTIONS, SCREEN_MATRICES, SHADINGS, SHADOW_REVEALS, TEXTURE_REVEALS, THEMES, VERTEX_FORMATS, VISIBILITIES,
};
use crate::figure::{
    AXES_LENGTHS, Depth, Figure, Localized, NamedPoint, Observer, Photograph, Reveal, Screen, ScreenEntry,
    ScreenMatrix, View, WorldLook, WorldPart,
};
use crate::limits::{MAX_CAPTION, MAX_NAMED_POINTS, MAX_OFFSET, MAX_SIDE, MAX_TITLE};
use crate::sanitize;

/// The sizes of images in pixels.
const SIDES: [i64; 2] = [1, MAX_SIDE as i64];

/// A figure, in a file or in a part of one.
pub(in crate::figure) fn figure(keys: &mut Keys<'_>, f: &mut Figure) {
    let root = keys.reading().map_or_else(String::new, |root| root.name_of(""));
    let label = |key: &str| match root.trim_matches(['[', ']', ' ']) {
        "" => format!("[{key}]"),
        root => format!("[{root}.{key}]"),
    };
    keys.optional_field("title", &mut f.title, |s| bilingual_line(s, "title", MAX_TITLE), write_told);
    keys.optional_field("caption", &mut f.caption, |s| bilingual_line(s, "caption", MAX_CAPTION), write_told);
    keys.section("camera", &label("camera"), |keys| camera::current(keys, f));
    keys.section("image", &label("image"), |keys| image(keys, f));
    viewport(keys, &label("viewport"), f);
    keys.part("scene", &label("scene"), &mut f.scene, scene::scene);
    // A file ends with its lists, so that they follow all sections.
    if !keys.is_writing() {
        lists(keys, label, f);
    }
    keys.part("style", &label("style"), &mut f.style, style);
    keys.part("reveal", &label("reveal"), &mut f.reveal, reveal);
    keys.part("world", &label("world"), &mut f.world, world);
    keys.part("observers", &label("observers"), &mut f.observers, |keys, observers| {
        observer(keys, "world", "[observers.world]", &mut observers.world);
        observer(keys, "canonical", "[observers.canonical]", &mut observers.canonical);
        keys.without_line();
    });
    keys.part("show", &label("show"), &mut f.show, show::show);
    keys.part("screen", &label("screen"), &mut f.screen, screen);
    comparison::compare(keys, &label("compare"), &mut f.compare, &f.cameras);
    keys.part("labels", &label("labels"), &mut f.labels, labels::labels);
    if keys.is_writing() {
        lists(keys, label, f);
    }
}

fn lists(keys: &mut Keys<'_>, label: impl Fn(&str) -> String, f: &mut Figure) {
    camera::cameras(keys, &format!("[{}]", label("cameras")), f);
    points(keys, &format!("[{}]", label("points")), &mut f.points);
}

/// A text of one line for each language.
fn bilingual_line(section: &mut Section<'_>, key: &'static str, limit: usize) -> Option<Localized> {
    let texts = section.told(key)?;
    let is_short = |text: &str| text.chars().count() <= limit && !text.contains(sanitize::is_obeyed);
    if !texts.iter().all(|(_, text)| is_short(text)) {
        section.refuse(key, Allowed::BilingualLine { limit });
        return None;
    }
    Some(texts)
}

/// The size, the switch for an undistorted image, and the photograph under it.
fn image(keys: &mut Keys<'_>, f: &mut Figure) {
    if keys.is_reading() {
        (f.image, f.undistorted, f.photograph) = Default::default();
    }
    let ImageSize { width, height } = &mut f.image;
    keys.key("width", &integer_in(SIDES), width);
    keys.key("height", &integer_in(SIDES), height);
    keys.switch("undistorted", &mut f.undistorted);
    let (mut file, mut opacity) = match f.photograph.take() {
        Some(Photograph { file, opacity }) => (Some(file), opacity),
        None => (None, Photograph::USUAL_OPACITY),
    };
    keys.option("photograph", &TEXT, &mut file);
    // Both or none, because the reader refuses an opacity alone.
    keys.key_if("photograph_opacity", file.is_some(), &number_in(UNIT), &mut opacity);
    if let Some(section) = keys.reading()
        && section.is_present("photograph_opacity")
    {
        section.require("photograph", Allowed::Text);
    }
    f.photograph = file.map(|file| Photograph { file, opacity });
}

/// The whole image if the section is missing or empty.
fn viewport(keys: &mut Keys<'_>, label: &str, f: &mut Figure) {
    let image = f.image;
    keys.section("viewport", label, |keys| {
        if let Some(section) = keys.reading() {
            f.viewport = None;
            if section.is_empty() {
                return;
            }
        } else if keys.is_writing() && f.viewport.is_none() {
            return;
        }
        let whole = Viewport { x: 0, y: 0, width: image.width, height: image.height, depth_near: 0.0, depth_far: 1.0 };
        let v = f.viewport.get_or_insert(whole);
        keys.key("x", &integer_in([-MAX_OFFSET, MAX_OFFSET]), &mut v.x);
        keys.key("y", &integer_in([-MAX_OFFSET, MAX_OFFSET]), &mut v.y);
        keys.key("width", &integer_in(SIDES), &mut v.width);
        keys.key("height", &integer_in(SIDES), &mut v.height);
        keys.key("depth_near", &number_in(UNIT), &mut v.depth_near);
        keys.key("depth_far", &number_in(UNIT), &mut v.depth_far);
    });
}

fn points(keys: &mut Keys<'_>, label: &str, points: &mut Vec<NamedPoint>) {
    let blank = |_| NamedPoint { name: String::new(), position: DVec3::ZERO };
    keys.list("points", label, MAX_NAMED_POINTS, points, blank, |keys, point, before| {
        keys.needed("name", &TEXT, &mut point.name);
        keys.needed("position", &VECTOR, &mut point.position);
        if let Some(section) = keys.reading()
            && !point.name.is_empty()
            && !may_be_named(&point.name, before.iter())
        {
            section.fault("name", Problem::Duplicate);
        }
        keys.is_good()
    });
}

fn style(keys: &mut Keys<'_>, style: &mut Style) {
    keys.word("shading", SHADINGS, &mut style.shading);
    keys.word("visibility", VISIBILITIES, &mut style.visibility);
    keys.word("hidden_lines", HIDDEN_LINES, &mut style.hidden_lines);
    keys.key("antialias", &SAMPLES, &mut style.antialias);
    keys.word("theme", THEMES, &mut style.theme);
    keys.rare_word("depth_format", DEPTH_FORMATS, &mut style.depth_format);
    keys.rare_word("vertex_format", VERTEX_FORMATS, &mut style.vertex_format);
    keys.rare("subpixel_bits", &SubpixelBits::default(), &SUBPIXEL_BITS, &mut style.subpixel_bits);
    keys.rare_word("order", FACE_ORDERS, &mut style.order);
}

fn reveal(keys: &mut Keys<'_>, reveal: &mut Reveal) {
    keys.in_order(&["depth", "outside", "clipping", "divide_first", "culled", "vanishing", "single_precision"]);
    let read = |s: &mut Section<'_>, depth: &mut Depth| {
        *depth = s.switch_or("depth", [Depth::Off, Depth::Stored], DEPTHS);
    };
    keys.field("depth", reveal.depth != Depth::Off, &mut reveal.depth, read, |depth| match depth {
        Depth::Off => false.into(),
        Depth::Stored => true.into(),
        Depth::Linear => words::name(DEPTHS, *depth).into(),
    });
    keys.rare_word("outside", OUTSIDES, &mut reveal.outside);
    keys.choice("texture", TEXTURE_REVEALS, &mut reveal.texture);
    keys.choice("shadows", SHADOW_REVEALS, &mut reveal.shadows);
    keys.choice("cost", COST_REVEALS, &mut reveal.cost);
    keys.switch("clipping", &mut reveal.clipping);
    keys.switch("divide_first", &mut reveal.divide_first);
    keys.switch("culled", &mut reveal.culled);
    keys.switch("vanishing", &mut reveal.vanishing);
    keys.switch("single_precision", &mut reveal.single_precision);
}

fn world(keys: &mut Keys<'_>, world: &mut WorldLook) {
    keys.in_order(&["window_opacity", "axes_length"]);
    keys.switch("section", &mut world.section);
    keys.switch("dimensions", &mut world.dimensions);
    keys.option("window_opacity", &number_in(UNIT), &mut world.window_opacity);
    keys.option("axes_length", &number_in(AXES_LENGTHS), &mut world.axes_length);
    for (part, key) in WorldPart::ALL {
        let mut drawn = world.parts.has(part);
        keys.rare(key, &true, &SWITCH, &mut drawn);
        world.parts.set(part, drawn);
    }
}

fn observer(keys: &mut Keys<'_>, key: &'static str, label: &str, value: &mut Option<Observer>) {
    let usual =
        Observer { target: DVec3::ZERO, distance: 10.0, azimuth: 30.0, elevation: 20.0, roll: 0.0, parallel: false };
    keys.optional(key, label, toml_edit::Item::Table, value, usual, |keys, o| {
        keys.key("target", &VECTOR, &mut o.target);
        keys.key("distance", &POSITIVE, &mut o.distance);
        keys.key("azimuth", &ANGLE, &mut o.azimuth);
        keys.key("elevation", &angle_in([-90.0, 90.0]), &mut o.elevation);
        keys.rare("roll", &0.0, &ANGLE, &mut o.roll);
        let mut projection = if o.parallel { Projection::Parallel } else { Projection::Perspective };
        keys.word("projection", PROJECTIONS, &mut projection);
        o.parallel = projection == Projection::Parallel;
    });
}

fn screen(keys: &mut Keys<'_>, screen: &mut Screen) {
    keys.in_order(&["pictures", "entry"]);
    keys.optional_field("pictures", &mut screen.pictures, pictures, |pictures| {
        let shown = View::ALL.into_iter().filter(|view| pictures[view.index()]);
        shown.map(View::name).collect::<toml_edit::Array>().into()
    });
    keys.choice("arrangement", ARRANGEMENTS, &mut screen.arrangement);
    keys.choice("panel", PANELS, &mut screen.panel);
    let blank = ScreenEntry { matrix: ScreenMatrix::View, inverse: false, place: [1, 1] };
    keys.optional("entry", "[screen] entry.", inline, &mut screen.entry, blank, |keys, entry| {
        keys.require("matrix", Allowed::word_of(SCREEN_MATRICES));
        keys.word("matrix", SCREEN_MATRICES, &mut entry.matrix);
        keys.switch("inverse", &mut entry.inverse);
        let [row, column] = &mut entry.place;
        keys.key("row", &integer_in([1, 4]), row);
        keys.key("column", &integer_in([1, 4]), column);
    });
}

fn pictures(section: &mut Section<'_>) -> Option<[bool; View::COUNT]> {
    let views = section.words("pictures", PICTURES);
    if views.is_empty() && section.is_present("pictures") && section.faults.is_empty() {
        section.refuse("pictures", Allowed::Words(words::names(PICTURES)));
    }
    Some(View::ALL.map(|view| views.contains(&view))).filter(|pictures| *pictures != [false; View::COUNT])
}
