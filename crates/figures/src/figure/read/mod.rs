//! The text of a figure file → [`Figure`].

mod cameras;
mod comparison;
mod labels;
mod lens;
mod points;
mod scene;
mod screen;
mod section;
mod show;
mod stacked;
mod syntax;
mod value;

use std::ops::Range;

use glam::DVec3;
use toml_edit::{Document, TableLike};

use super::error::{Allowed, FigureError, Problem};
use super::words::{
    DEPTH_FORMATS, DEPTHS, HIDDEN_LINES, OUTSIDES, PROJECTIONS, SHADINGS, SHADOW_REVEALS, TEXTURE_REVEALS, THEMES,
    VISIBILITIES,
};
use super::{
    AXES_LENGTHS, Depth, Figure, Observer, Observers, Outside, Photograph, Reveal, WorldLook, WorldPart, WorldParts,
};
use crate::appearance::Style;
use crate::camera::{Camera, CameraError, ImageSize, LensForm, Parameters, Projection, ViewWindow, Viewport};
use crate::expression::Dimension;
use crate::limits::{MAX_FIGURE_BYTES, MAX_OFFSET, MAX_SIDE};
use crate::sanitize;
pub use comparison::typed_comparison;
use lens::WAYS_OF_THE_ANGLE;
pub(super) use lens::{is_way_of_the_angle, remove_rivals};
pub use scene::line_of_object;
pub use section::{Fault, Section, at_most};
pub use stacked::Stacked;

/// Reads the bytes of a figure file, or any other bytes.
///
/// # Errors
/// [`FigureError`] names the first faulty line.
pub fn parse_bytes(bytes: &[u8]) -> Result<Figure, FigureError> {
    parse(text_of(bytes, MAX_FIGURE_BYTES)?)
}

/// The text of a file of at most `limit` bytes.
///
/// # Errors
/// [`FigureError`] if it's too large, or isn't UTF-8.
pub fn text_of(bytes: &[u8], limit: usize) -> Result<&str, FigureError> {
    let fault = |line, problem| FigureError { line, key: String::new(), problem };
    if bytes.len() > limit {
        return Err(fault(1, Problem::TooLarge { limit }));
    }
    std::str::from_utf8(bytes).map_err(|error| {
        let good = error.valid_up_to();
        let line = 1 + bytes[..good].iter().filter(|b| **b == b'\n').count();
        fault(line, Problem::NotUtf8 { byte: bytes[good] })
    })
}

/// Reads a file of another kind, with sections of its own, which may contain a figure.
///
/// # Errors
/// [`FigureError`] names the first faulty line.
pub fn parse_with<T>(text: &str, read: impl FnOnce(Section<'_>, &mut Vec<Fault>) -> T) -> Result<T, FigureError> {
    let (found, _) = parse_but(text, read, |_| false)?;
    Ok(found)
}

/// Like [`parse_with`], but returns the `excused` faults.
fn parse_but<T>(
    text: &str,
    read: impl FnOnce(Section<'_>, &mut Vec<Fault>) -> T,
    excused: impl FnMut(&Fault) -> bool,
) -> Result<(T, Vec<Fault>), FigureError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let document = Document::parse(text).map_err(|error| syntax::explain(text, &error))?;
    let mut faults = Vec::new();
    let found = read(Section::new(text, Some(document.as_table() as &dyn TableLike), "", 0), &mut faults);
    let (excused, faults): (Vec<Fault>, Vec<Fault>) = faults.into_iter().partition(excused);
    match faults.into_iter().min_by_key(|fault| fault.at) {
        Some(Fault { at, key, problem }) => Err(FigureError { line: line_of(text, at), key, problem }),
        None => Ok((found, excused)),
    }
}

/// Reads a figure file. A missing key has its default. The empty text is the default figure.
///
/// # Guarantees
/// The camera of the figure is one that [`Camera::new`] accepts.
///
/// # Errors
/// [`FigureError`] names the first faulty line: the line, the key, the value found and the values allowed.
pub fn parse(text: &str) -> Result<Figure, FigureError> {
    parse_with(text, figure)
}

/// Like [`parse`], but skips unknown keys, which a later version may have written. It returns them.
///
/// # Errors
/// As for [`parse`].
pub fn parse_known(text: &str) -> Result<(Figure, Vec<String>), FigureError> {
    let (figure, unknown) = parse_but(text, figure, Fault::is_unknown_key)?;
    Ok((figure, unknown.into_iter().map(|fault| fault.key).collect()))
}

/// Like [`parse`], but an impossible camera isn't a fault. Its error comes with the figure.
///
/// # Errors
/// As for [`parse`], except for [`Problem::Camera`].
pub fn parse_with_any_camera(text: &str) -> Result<(Figure, Option<CameraError>), FigureError> {
    let is_camera = |fault: &Fault| matches!(fault.problem, Problem::Camera(_)) && fault.key.starts_with("[camera]");
    let (figure, faults) = parse_but(text, figure, is_camera)?;
    let error = faults.into_iter().find_map(|fault| match fault.problem {
        Problem::Camera(error) => Some(error),
        _ => None,
    });
    Ok((figure, error))
}

/// The figure whose sections are in a section, which is a file or a part of one.
pub fn figure(mut root: Section<'_>, faults: &mut Vec<Fault>) -> Figure {
    let inside = |root: &Section<'_>, key: &str| match root.name_of("") {
        label if label.is_empty() => format!("[{key}]"),
        label => format!("[{}.{key}]", label.trim_matches(['[', ']', ' '])),
    };
    // In the order of the documentation, which is the order of the list in a message.
    let [title, caption] = screen::told(&mut root);
    let [camera_section, image_section, viewport_section, scene_section] =
        ["camera", "image", "viewport", "scene"].map(|key| root.section(key, &inside(&root, key)));
    let camera_sections = root.sections("cameras", &format!("[{}]", inside(&root, "cameras")));
    let point_sections = root.sections("points", &format!("[{}]", inside(&root, "points")));
    let [style_section, reveal_section, world_section, observers_section] =
        ["style", "reveal", "world", "observers"].map(|key| root.section(key, &inside(&root, key)));
    let [show_section, screen_section, compare_section, labels_section] =
        ["show", "screen", "compare", "labels"].map(|key| root.section(key, &inside(&root, key)));
    faults.extend(root.finish());
    let (image, undistorted, photograph) = image_section.finished(faults, image);
    let (tag, camera, lens) = cameras::current(camera_section, faults);
    let cameras = cameras::cameras(camera_sections, &tag, faults);
    Figure {
        title,
        caption,
        camera,
        lens,
        tag,
        image,
        undistorted,
        photograph,
        viewport: viewport_section.finished(faults, |section| viewport(section, image)),
        scene: scene::scene(scene_section, faults),
        points: points::points(point_sections, faults),
        style: style_section.finished(faults, style),
        reveal: reveal_section.finished(faults, reveal),
        world: world_section.finished(faults, world),
        observers: observers(observers_section, faults),
        show: show::show(show_section, faults),
        screen: screen::screen(screen_section, faults),
        compare: comparison::comparison(compare_section, &cameras, faults),
        labels: labels::labels(labels_section, faults),
        cameras,
    }
}

fn camera(mut section: Section<'_>, faults: &mut Vec<Fault>) -> (Parameters, Option<LensForm>) {
    let found = camera_keys(&mut section, faults);
    faults.extend(section.finish());
    found
}

/// The keys of a camera, in a section that may have others.
fn camera_keys(section: &mut Section<'_>, faults: &mut Vec<Fault>) -> (Parameters, Option<LensForm>) {
    let default = Parameters::default();
    let mut parameters = Parameters {
        position: section.vector("position", default.position),
        focal_point: section.vector("focal_point", default.focal_point),
        view_up: section.vector("view_up", default.view_up),
        projection: section.word("projection", PROJECTIONS, default.projection),
        view_angle: section.angle("view_angle", default.view_angle),
        height: section.number("height", default.height),
        aspect: section.number("aspect", default.aspect),
        near: section.number("near", default.near),
        far: section.number_or_infinity("far", default.far),
        window: window(section, faults),
    };
    let lens = lens::lens(section, faults).filter(|_| section.faults.is_empty());
    if let Some(lens) = lens {
        parameters.view_angle = lens.view_angle(parameters.aspect);
    }
    if section.faults.is_empty()
        && let Err(error) = Camera::new(&parameters)
    {
        let concerned = error.parameters().iter().map(|key| key.name());
        let given = WAYS_OF_THE_ANGLE.into_iter().find(|way| section.is_present(way));
        let written = |key| if is_way_of_the_angle(key) { given.unwrap_or(key) } else { key };
        let keys: Vec<&str> = concerned.map(written).collect();
        let key = keys.iter().find(|key| section.is_present(key)).or(keys.first()).copied();
        section.fault(key.unwrap_or_default(), Problem::Camera(error));
    }
    (parameters, lens)
}

fn window(camera: &mut Section<'_>, faults: &mut Vec<Fault>) -> Option<ViewWindow> {
    let mut section = camera.section("window", &format!("{}.", camera.name_of("window"))).there()?;
    let mut side = |key| {
        let value = section.number(key, 0.0);
        section.require(key, Allowed::Number);
        value
    };
    let window = ViewWindow { left: side("left"), right: side("right"), bottom: side("bottom"), top: side("top") };
    section.good(Some(window), faults)
}

/// The size, the switch for an undistorted image, and the photograph under it.
fn image(section: &mut Section<'_>) -> (ImageSize, bool, Option<Photograph>) {
    let default = ImageSize::default();
    let size = ImageSize {
        width: section.integer("width", 1, i64::from(MAX_SIDE), default.width),
        height: section.integer("height", 1, i64::from(MAX_SIDE), default.height),
    };
    let undistorted = section.switch("undistorted");
    let file = section.text("photograph");
    let opacity = section.number_in("photograph_opacity", 0.0, 1.0, Photograph::USUAL_OPACITY);
    if section.is_present("photograph_opacity") && !section.is_present("photograph") {
        section.missing("photograph", Allowed::Text);
    }
    (size, undistorted, file.map(|file| Photograph { file, opacity }))
}

fn viewport(section: &mut Section<'_>, image: ImageSize) -> Option<Viewport> {
    let given = !section.is_empty();
    let viewport = Viewport {
        x: section.integer("x", -MAX_OFFSET, MAX_OFFSET, 0),
        y: section.integer("y", -MAX_OFFSET, MAX_OFFSET, 0),
        width: section.integer("width", 1, i64::from(MAX_SIDE), image.width),
        height: section.integer("height", 1, i64::from(MAX_SIDE), image.height),
        depth_near: section.number_in("depth_near", 0.0, 1.0, 0.0),
        depth_far: section.number_in("depth_far", 0.0, 1.0, 1.0),
    };
    given.then_some(viewport)
}

fn style(section: &mut Section<'_>) -> Style {
    let default = Style::default();
    Style {
        shading: section.word("shading", SHADINGS, default.shading),
        visibility: section.word("visibility", VISIBILITIES, default.visibility),
        hidden_lines: section.word("hidden_lines", HIDDEN_LINES, default.hidden_lines),
        antialias: section.samples("antialias", default.antialias),
        theme: section.word("theme", THEMES, default.theme),
        depth_format: section.word("depth_format", DEPTH_FORMATS, default.depth_format),
    }
}

fn reveal(section: &mut Section<'_>) -> Reveal {
    Reveal {
        depth: section.switch_or("depth", [Depth::Off, Depth::Stored], DEPTHS),
        outside: section.word("outside", OUTSIDES, Outside::Usual),
        clipping: section.switch("clipping"),
        divide_first: section.switch("divide_first"),
        culled: section.switch("culled"),
        vanishing: section.switch("vanishing"),
        single_precision: section.switch("single_precision"),
        texture: section.choice("texture", TEXTURE_REVEALS),
        shadows: section.choice("shadows", SHADOW_REVEALS),
    }
}

fn world(section: &mut Section<'_>) -> WorldLook {
    let [shortest, longest] = AXES_LENGTHS;
    let window_opacity = section.optional_in("window_opacity", 0.0, 1.0, 1.0);
    let axes_length = section.optional_in("axes_length", shortest, longest, 1.0);
    WorldLook {
        section: section.switch("section"),
        dimensions: section.switch("dimensions"),
        window_opacity,
        axes_length,
        parts: world_parts(section),
    }
}

fn world_parts(section: &mut Section<'_>) -> WorldParts {
    let mut parts = WorldParts::default();
    for (part, key) in WorldPart::ALL {
        parts.set(part, section.switch_else(key, true));
    }
    parts
}

fn observers(mut section: Section<'_>, faults: &mut Vec<Fault>) -> Observers {
    let world = section.section("world", "[observers.world]");
    let canonical = section.section("canonical", "[observers.canonical]");
    let (has_world, has_canonical) = (section.is_present("world"), section.is_present("canonical"));
    faults.extend(section.finish());
    Observers {
        world: has_world.then(|| world.finished(faults, observer)),
        canonical: has_canonical.then(|| canonical.finished(faults, observer)),
    }
}

fn observer(section: &mut Section<'_>) -> Observer {
    Observer {
        target: section.vector("target", DVec3::ZERO),
        distance: section.positive("distance", 10.0),
        azimuth: section.angle("azimuth", 30.0),
        elevation: section.quantity_in("elevation", Dimension::Angle, -90.0, 90.0, 20.0),
        roll: section.angle("roll", 0.0),
        parallel: section.word("projection", PROJECTIONS, Projection::Perspective) == Projection::Parallel,
    }
}

/// The line of a place in the text, counted from 1.
pub fn line_of(text: &str, at: usize) -> usize {
    1 + text.as_bytes()[..at.min(text.len())].iter().filter(|b| **b == b'\n').count()
}

/// A piece of the text that fits into a sentence: one line, no control characters, not long.
fn snippet(text: &str, span: Range<usize>) -> String {
    let piece = text.get(span).unwrap_or_default();
    sanitize::escaped(&piece.split_whitespace().collect::<Vec<_>>().join(" "))
}

#[cfg(test)]
mod tests;
