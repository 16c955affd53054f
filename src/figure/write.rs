//! [`Figure`] → the text of a figure file.

use std::fmt::Write as _;

use glam::DVec3;

pub use super::edit::update;
use super::words::{self, DEPTHS, HIDDEN_LINES, OUTSIDES, PROJECTIONS, SHADINGS, THEMES, VISIBILITIES};
use super::{Depth, Figure, Observer, Outside, Reveal};
use crate::camera::Projection;
use crate::numbers;
use crate::scene::{LightSpec, ObjectSpec, Shape};

/// The figure file of `figure`, its keys in the order of the documentation.
///
/// # Guarantees
/// Reading the text gives the same figure back, every number to the last bit, for each figure that a file can hold.
#[must_use]
pub fn to_toml(figure: &Figure) -> String {
    let mut out = Text::default();
    let p = &figure.camera;
    out.section("[camera]");
    out.key("position", vector(p.position));
    out.key("focal_point", vector(p.focal_point));
    out.key("view_up", vector(p.view_up));
    out.key("projection", quoted(words::name(PROJECTIONS, p.projection)));
    out.key("view_angle", number(p.view_angle));
    out.key("height", number(p.height));
    out.key("aspect", number(p.aspect));
    out.key("near", number(p.near));
    out.key("far", number(p.far));
    if let Some(w) = p.window {
        let sides = [("left", w.left), ("right", w.right), ("bottom", w.bottom), ("top", w.top)];
        let sides: Vec<_> = sides.iter().map(|(side, x)| format!("{side} = {}", number(*x))).collect();
        out.key("window", format!("{{ {} }}", sides.join(", ")));
    }
    out.section("[image]");
    out.key("width", figure.image.width);
    out.key("height", figure.image.height);
    if let Some(v) = figure.viewport {
        out.section("[viewport]");
        out.key("x", v.x);
        out.key("y", v.y);
        out.key("width", v.width);
        out.key("height", v.height);
        out.key("depth_near", number(v.depth_near));
        out.key("depth_far", number(v.depth_far));
    }
    out.section("[scene]");
    out.key("preset", quoted(figure.scene.preset.name()));
    for object in &figure.scene.objects {
        write_object(&mut out, object);
    }
    for light in &figure.scene.lights {
        write_light(&mut out, *light);
    }
    let style = &figure.style;
    out.section("[style]");
    out.key("shading", quoted(words::name(SHADINGS, style.shading)));
    out.key("visibility", quoted(words::name(VISIBILITIES, style.visibility)));
    out.key("hidden_lines", quoted(words::name(HIDDEN_LINES, style.hidden_lines)));
    out.key("antialias", style.antialias);
    out.key("theme", quoted(words::name(THEMES, style.theme)));
    write_reveal(&mut out, figure.reveal);
    write_observer(&mut out, "[observers.world]", figure.observers.world);
    write_observer(&mut out, "[observers.canonical]", figure.observers.canonical);
    out.text
}

fn write_object(out: &mut Text, object: &ObjectSpec) {
    out.section("[[scene.objects]]");
    out.key("name", quoted(&object.name));
    if let Some(shape) = &object.shape {
        out.key("shape", quoted(shape.name()));
        match shape {
            Shape::Points(points) => out.key("points", vectors(points)),
            Shape::Segments(pairs) => out.key("points", vectors(pairs.as_flattened())),
            Shape::Mesh { path } => out.key("path", quoted(path)),
            Shape::Box
            | Shape::Prism
            | Shape::Pyramid
            | Shape::Sphere
            | Shape::Ellipsoid
            | Shape::Cylinder
            | Shape::Cone
            | Shape::Torus
            | Shape::Grid => {}
        }
    }
    if let Some(parent) = &object.parent {
        out.key("parent", quoted(parent));
    }
    for (key, value, default) in [
        ("translate", object.translate, DVec3::ZERO),
        ("rotate", object.rotate, DVec3::ZERO),
        ("scale", object.scale, DVec3::ONE),
    ] {
        // −0 is not 0: compared as it is written.
        if vector(value) != vector(default) {
            out.key(key, vector(value));
        }
    }
    if let Some(color) = object.color {
        out.key("color", quoted(&color.to_string()));
    }
    if object.segments != Shape::usual_segments(object.shape.as_ref()) {
        out.key("segments", object.segments);
    }
}

fn write_light(out: &mut Text, light: LightSpec) {
    out.section("[[scene.lights]]");
    out.key("kind", quoted(light.name()));
    match light {
        LightSpec::Directional(direction) => out.key("direction", vector(direction)),
        LightSpec::Point(position) => out.key("position", vector(position)),
    }
}

fn write_reveal(out: &mut Text, reveal: Reveal) {
    if reveal == Reveal::default() {
        return;
    }
    out.section("[reveal]");
    match reveal.depth {
        Depth::Off => {}
        Depth::Stored => out.key("depth", true),
        depth @ Depth::Linear => out.key("depth", quoted(words::name(DEPTHS, depth))),
    }
    if reveal.outside != Outside::Usual {
        out.key("outside", quoted(words::name(OUTSIDES, reveal.outside)));
    }
    for (key, on) in [("clipping", reveal.clipping), ("divide_first", reveal.divide_first), ("culled", reveal.culled)] {
        if on {
            out.key(key, on);
        }
    }
}

fn write_observer(out: &mut Text, header: &str, observer: Option<Observer>) {
    let Some(o) = observer else { return };
    let projection = if o.parallel { Projection::Parallel } else { Projection::Perspective };
    out.section(header);
    out.key("target", vector(o.target));
    out.key("distance", number(o.distance));
    out.key("azimuth", number(o.azimuth));
    out.key("elevation", number(o.elevation));
    out.key("projection", quoted(words::name(PROJECTIONS, projection)));
}

/// A figure file in the making.
#[derive(Default)]
struct Text {
    text: String,
}

impl Text {
    fn section(&mut self, header: &str) {
        if !self.text.is_empty() {
            self.text.push('\n');
        }
        self.text.push_str(header);
        self.text.push('\n');
    }

    fn key(&mut self, key: &str, value: impl std::fmt::Display) {
        // Writing to a `String` cannot fail.
        let _ = writeln!(self.text, "{key} = {value}");
    }
}

/// The shortest decimal number that reads back as the same `f64`.
fn number(x: f64) -> String {
    if x.is_finite() { numbers::exact(x) } else { x.to_string().to_lowercase() }
}

fn vector(v: DVec3) -> String {
    format!("[{}, {}, {}]", number(v.x), number(v.y), number(v.z))
}

fn vectors(points: &[DVec3]) -> String {
    let points: Vec<_> = points.iter().map(|p| vector(*p)).collect();
    format!("[{}]", points.join(", "))
}

/// A text in quotes, on one line.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            '\n' => out.push_str("\\n"),
            c if c.is_control() => {
                // Writing to a `String` cannot fail.
                let _ = write!(out, "\\u{:04X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
