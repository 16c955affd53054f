//! The values of keys and operations in the words of the pictures: θ = 20°, painter, azimuth 30°.

use crate::appearance::TextureReveal;
use crate::camera::{Ndc, Operation};
use crate::figure::WorldPart;
use crate::figure::variation::VariedValue;
use crate::figure::words::{
    self, COST_REVEALS, DEPTH_FORMATS, FACE_ORDERS, HIDDEN_LINES, NDCS, OUTSIDES, PROJECTIONS, SHADINGS,
    SHADOW_REVEALS, STAGES, TEXTURE_REVEALS, VISIBILITIES,
};
use crate::geometry::Angle;
use crate::sanitize;
use crate::text::literal;
use crate::views::Labels;

/// Parameters of the camera with their symbols in the notes, and their units.
const SYMBOLS: [(&str, &str, &str); 8] = [
    ("camera.view_angle", "θ", "°"),
    ("camera.height", "H", ""),
    ("camera.aspect", "A", ""),
    ("camera.near", "F", ""),
    ("camera.far", "B", ""),
    ("camera.position", "C", ""),
    ("camera.focal_point", "PF", ""),
    ("camera.view_up", "VUP", ""),
];

/// An operation in the words of the pictures: azimuth 30°.
pub(in crate::views) fn done(operation: Operation, labels: &Labels) -> String {
    let number = |value: f64| labels.mark.number(value, 4);
    let [elevation, azimuth, roll, yaw, pitch, zoom, dolly, pan] = labels.operations;
    let turned = |name, angle: Angle| format!("{name} {}°", number(angle.degrees()));
    match operation {
        Operation::Elevation(angle) => turned(elevation, angle),
        Operation::Azimuth(angle) => turned(azimuth, angle),
        Operation::Roll(angle) => turned(roll, angle),
        Operation::Yaw(angle) => turned(yaw, angle),
        Operation::Pitch(angle) => turned(pitch, angle),
        Operation::Zoom(factor) => format!("{zoom} × {}", number(factor)),
        Operation::Dolly(factor) => format!("{dolly} × {}", number(factor)),
        Operation::Pan { dx, dy } => format!("{pan} {}", labels.mark.tuple(&[dx, dy], 4)),
    }
}

/// A value of a key in the words of the pictures, or else as written.
pub(in crate::views) fn said(key: &str, value: Option<&str>, labels: &Labels) -> String {
    fn word<T: Copy>(list: words::Words<T>, said: &[&'static str], value: &str) -> Option<&'static str> {
        said.get(list.iter().position(|(word, _)| *word == value)?).copied()
    }
    /// The text for no value, or for a word of the list.
    fn revealed<T: Copy>(list: words::Words<T>, said: &[&'static str; 4], value: Option<&str>) -> Option<&'static str> {
        value.map_or(Some(said[0]), |value| word(list, &said[1..], value))
    }
    let known = match (key, value) {
        ("style.visibility", Some(value)) => word(VISIBILITIES, &labels.visibilities, value).map(str::to_owned),
        ("style.shading", Some(value)) => word(SHADINGS, &labels.shadings, value).map(str::to_owned),
        ("style.hidden_lines", Some(value)) => word(HIDDEN_LINES, &labels.hidden_lines, value).map(str::to_owned),
        ("camera.projection", Some(value)) => word(PROJECTIONS, &labels.projections, value).map(str::to_owned),
        ("style.depth_format", value) => {
            word(DEPTH_FORMATS, &labels.depth_formats, value.unwrap_or("f32-reversed")).map(str::to_owned)
        }
        ("style.vertex_format", value) => Some(format!("{} {}", labels.vertices_in, value.unwrap_or("f64"))),
        ("style.subpixel_bits", value) => Some(format!("{} {}", labels.subpixel_bits, value.unwrap_or("8"))),
        ("show.stage", Some(value)) => {
            words::value(STAGES, value).and_then(|stage| labels.stages.get(stage as usize)).map(|&name| name.to_owned())
        }
        ("show.stage", None) => Some(labels.no_stage.to_owned()),
        ("reveal.depth", value) => {
            let known = [None, Some("true"), Some("linear")];
            let place = known.iter().position(|known| *known == value.filter(|value| *value != "false"));
            place.map(|place| labels.depths[place].to_owned())
        }
        ("reveal.outside", value) => {
            revealed(OUTSIDES, &labels.outsides, value).map(|word| format!("{}: {word}", labels.outside_of))
        }
        ("reveal.shadows", value) => revealed(SHADOW_REVEALS, &labels.shadow_reveals, value).map(str::to_owned),
        ("reveal.cost", value) => match value {
            None => Some(labels.costs[0]),
            Some(value) => word(COST_REVEALS, &labels.costs[1..], value),
        }
        .map(str::to_owned),
        ("style.order", value) => {
            word(FACE_ORDERS, &labels.face_orders, value.unwrap_or("as-listed")).map(str::to_owned)
        }
        ("show.step.at", Some(value)) => Some(format!("{} {}", labels.step_number, printed(value, labels))),
        ("reveal.texture", value) => match value.map(|value| words::value(TEXTURE_REVEALS, value)) {
            None => Some(labels.with_w.to_owned()),
            Some(Some(TextureReveal::Affine)) => Some(labels.affine.to_owned()),
            Some(Some(TextureReveal::Levels)) => Some(labels.levels.to_owned()),
            Some(Some(TextureReveal::Texels)) => Some(labels.texels.to_owned()),
            Some(None) => None,
        },
        ("style.antialias", Some(value)) => Some(format!("{}: {}", labels.samples, printed(value, labels))),
        ("show.ndc", value) => {
            let ndc = value.map_or(Some(Ndc::default()), |value| words::value(NDCS, value));
            ndc.map(|ndc| labels.ndc_title(ndc))
        }
        (key, Some(value)) => {
            let symbol = SYMBOLS.iter().find(|(known, ..)| *known == key);
            symbol.map(|(_, symbol, unit)| format!("{symbol} = {}{unit}", printed(value, labels)))
        }
        _ => None,
    };
    let part = key.strip_prefix("world.").and_then(|key| WorldPart::ALL.iter().position(|(_, known)| *known == key));
    let switch = labels.switches.iter().find(|(known, _)| *known == key).map(|(_, name)| *name);
    let switch = switch.or(part.map(|part| labels.world_parts[part]));
    known.unwrap_or_else(|| match (switch, value) {
        (Some(name), Some("true")) => format!("{name}: {}", labels.yes_no[0]),
        (Some(name), Some("false")) => format!("{name}: {}", labels.yes_no[1]),
        _ => {
            // Other keys have their name in the file.
            let name = literal(key.rsplit('.').next().unwrap_or(key));
            format!("{name} = {}", value.map_or_else(|| "–".to_owned(), |value| printed(value, labels)))
        }
    })
}

/// A number or a list of numbers in the notation of the pictures' language, or else as written.
fn printed(value: &str, labels: &Labels) -> String {
    /// A longer number doesn't come from the keyboard.
    const LONGEST: usize = 8;
    let number = |text: &str| text.trim().parse::<f64>().ok();
    if let Some(exact) = number(value) {
        let short = value.trim_end_matches(".0");
        return if short.len() > LONGEST { labels.mark.number(exact, 4) } else { labels.mark.printed(short) };
    }
    let inner = value.strip_prefix('[').and_then(|value| value.strip_suffix(']'));
    let numbers: Option<Vec<f64>> = inner.and_then(|inner| inner.split(',').map(number).collect());
    numbers.map_or_else(|| literal(&sanitize::escaped(value)), |numbers| labels.mark.tuple(&numbers, 4))
}

/// The values of one figure of a family, in the words of the pictures, for the caption under its picture.
pub fn caption(at: &[VariedValue], labels: &Labels) -> String {
    let words = at.iter().map(|value| match value {
        VariedValue::Key(key, value) => said(key, value.as_deref(), labels),
        VariedValue::Operation(operation) => done(*operation, labels),
    });
    words.collect::<Vec<_>>().join(", ")
}
