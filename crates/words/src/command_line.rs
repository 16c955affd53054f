//! The words of the command line, in both languages.

use std::ops::RangeInclusive;

use crate::camera::{Decomposition, ImageSize};
use crate::export::format::PictureFormat;
use crate::expression::ExpressionError;
use crate::inspect::{Conditions, proved_digits};
use crate::limits::MAX_SIDE;
use crate::messages::expressions::in_expression;
use crate::numbers::exact;
use crate::sanitize::escaped;

texts!("command_line");

/// An option of a command before its name.
pub const fn before_the_command(lang: Lang) -> &'static str {
    text!(lang, before_the_command)
}

/// The end of a message about faulty arguments.
pub const fn see_help(lang: Lang) -> &'static str {
    text!(lang, see_help)
}

texts_with_values! {
    /// A command that doesn't exist.
    unknown_command(lang, name: &str, commands: &[String]): (name = escaped(name), commands = commands.join(", "));

    /// A text that isn't a point. If it has three parts, the one that isn't a number, with the reason.
    point(lang, text: &str, fault: Option<(&str, &ExpressionError)>): (text = escaped(text), why = fault.map_or_else(String::new, |(part, error)| format!(": {}", in_expression(lang, part, error))));

    /// A text that isn't a pixel.
    pixel(lang, text: &str): (text = escaped(text));

    /// The name of a file whose extension is neither that of an animation nor that of a picture.
    animation_ending(lang, name: &str);

    /// A text that isn't a pixel with a depth.
    depth_pixel(lang, text: &str): (text = escaped(text));

    /// A text that isn't a size.
    size(lang, text: &str): (text = escaped(text), MAX_SIDE);

    /// A text that isn't a number, or a number that an option doesn't take.
    number(lang, option: &str, text: &str, range: &RangeInclusive<f64>, example: f64): (option, text = escaped(text), least = range.start(), most = range.end(), example);

    /// A text that isn't a number of frames.
    frames(lang, text: &str): (text = escaped(text));

    /// A text that isn't a seed.
    seed(lang, text: &str): (text = escaped(text));

    /// Arguments about a figure without one.
    without_figure(lang);

    /// A file of charts whose extension isn't that of a format.
    plot_ending(lang, path: &str): (path, endings = picture_endings());

    /// A picture larger than pictures can be.
    too_large(lang, width: u64, height: u64): (width, height, MAX_SIDE);

    /// An ending that isn't a picture's.
    ending(lang, name: &str): (name = escaped(name), endings = picture_endings());

    /// A program without a window.
    not_built_in(lang);
}

/// A fault in a file, with the line if it's known.
pub fn in_file(lang: Lang, name: &str, line: Option<usize>, what: &str) -> String {
    match line {
        Some(line) => text!(lang, in_file, name, line, what),
        None => format!("{name}: {what}"),
    }
}

/// An argument of `--show` without a value.
pub const fn show_without_value(lang: Lang) -> &'static str {
    text!(lang, show_without_value)
}

/// A key, `[show] triangle.object`, names an object that the scene doesn't have. Lists those that it has.
pub fn no_such_object(lang: Lang, key: &str, object: &str, objects: &[&str]) -> String {
    const MOST: usize = 12;
    let mut names: Vec<String> = objects.iter().take(MOST).map(|name| format!("\"{}\"", escaped(name))).collect();
    if objects.len() > MOST {
        names.push("…".to_owned());
    }
    let (object, names) = (escaped(object), names.join(", "));
    text!(lang, no_such_object, key, object, names)
}

/// The triangle to follow is beyond the last one of its object.
pub fn no_such_triangle(lang: Lang, object: &str, index: u32, count: usize) -> String {
    let object = escaped(object);
    match count.checked_sub(1) {
        Some(last) => text!(lang, no_such_triangle_some, index, object, last),
        None => text!(lang, no_such_triangle_none, object),
    }
}

/// Several views for a strip of stills.
pub const fn one_view_in_a_strip(lang: Lang) -> &'static str {
    text!(lang, one_view_in_a_strip)
}

/// A source that has no steps for a camera.
pub fn no_steps(lang: Lang, decomposition: Decomposition) -> String {
    let source = decomposition.source();
    match decomposition {
        Decomposition::Scale => text!(lang, no_steps_scale, source),
        _ => text!(lang, no_steps_window, source),
    }
}

/// The bounds of a number, and the digits that they prove; `None` if it isn't enclosed.
pub fn bounds(lang: Lang, pair: Option<[f64; 2]>) -> String {
    let Some([low, high]) = pair else { return text!(lang, not_enclosed).to_owned() };
    let (ends, digits) = ([low, high].map(exact), lang.mark().number(proved_digits([low, high]).floor(), 2));
    let [low, high] = &ends;
    if low == high {
        return text!(lang, bounds_exact).to_owned();
    }
    if digits == "0" { text!(lang, bounds_of_zero, low, high) } else { text!(lang, bounds, low, high, digits) }
}

/// The digits that each question of a camera loses by itself, a line for each.
pub fn conditions(lang: Lang, condition: &Conditions) -> String {
    let Conditions { basis, view_matrix, projection_matrix, inverse_view_projection } = *condition;
    let questions = [
        ("u, v, n", basis),
        ("M_v", view_matrix),
        ("M_p", projection_matrix),
        ("(M_p M_v)⁻¹", inverse_view_projection),
    ];
    let line = |(name, number): (&str, Option<f64>)| match number {
        Some(number) => {
            let (times, lost) = (lang.mark().number(number, 3), lang.mark().number(number.max(1.0).log10(), 2));
            text!(lang, condition, name, times, lost) + "\n"
        }
        None => text!(lang, condition_infinite, name) + "\n",
    };
    questions.map(line).concat()
}

/// A pixel that the image doesn't have. It has a ray all the same.
pub fn pixel_outside(lang: Lang, [i, j]: [i64; 2], image: ImageSize) -> String {
    let ImageSize { width, height } = image;
    let (right, bottom) = (i64::from(width) - 1, i64::from(height) - 1);
    text!(lang, pixel_outside, i, j, right, bottom)
}

/// The words around the table of stages.
#[derive(Debug)]
pub struct ExplainTexts {
    /// Heads of its columns.
    pub columns: [&'static str; 6],
    /// The time of all.
    pub total: &'static str,
    /// The meaning of the mark for "timed with another stage".
    pub together: &'static str,
    /// The way to the study of the figure.
    pub accuracy: &'static str,
    /// Heads of the columns of cost.
    pub cost: [&'static str; 3],
    /// The sums of cost: of the stages that work on vertices and faces, of those that work on pixels, and of all.
    pub blocks: [&'static str; 3],
    /// The meaning of the columns of cost.
    pub counted: &'static str,
}

/// The words around the table of stages.
pub const fn explain(lang: Lang) -> ExplainTexts {
    ExplainTexts {
        columns: text!(lang, explain_columns),
        total: text!(lang, explain_total),
        together: text!(lang, explain_together),
        accuracy: text!(lang, explain_accuracy),
        cost: text!(lang, explain_cost),
        blocks: text!(lang, explain_blocks),
        counted: text!(lang, explain_counted),
    }
}

/// A measurement: the picture, the number of triangles and frames, and median, least and 95 % of the times in ms.
pub fn bench(lang: Lang, what: &str, triangles: usize, frames: usize, [median, min, p95]: [f64; 3]) -> String {
    match frames {
        1 => text!(lang, bench_frame, what, triangles, median, min, p95),
        _ => text!(lang, bench_frames, what, triangles, frames, median, min, p95),
    }
}

/// A sheet on which this many pictures have no room beside the gaps between them.
pub fn no_room(lang: Lang, count: usize, [width, height]: [u64; 2], gap: u32) -> String {
    text!(lang, no_room, count, gap, width, height)
}

/// A size on paper of less than a pixel.
pub fn no_pixel(lang: Lang, [option, centimetres]: [&str; 2], dpi: f64) -> String {
    let centimetres = escaped(centimetres);
    text!(lang, no_pixel, option, centimetres, dpi)
}

fn picture_endings() -> String {
    PictureFormat::ALL.map(|format| format!(".{}", format.ending())).join(", ")
}

/// A picture without ground in a format that has none.
pub fn no_transparency(lang: Lang, format: PictureFormat) -> String {
    let able = PictureFormat::ALL.into_iter().filter(|format| format.has_transparency());
    let endings = able.map(|format| format!(".{}", format.ending())).collect::<Vec<_>>().join(", ");
    let name = format.name();
    text!(lang, no_transparency, name, endings)
}

/// The place where numbers are printed.
pub const fn standard_output(lang: Lang) -> &'static str {
    text!(lang, standard_output)
}

/// No display, or no OpenGL.
pub fn no_window(lang: Lang, why: &str) -> String {
    // The window's library names the line of its source before the reason.
    let reason =
        why.rsplit_once(".rs:").map_or(why, |(_, rest)| rest.trim_start_matches(|c: char| c.is_numeric() || c == ':'));
    let reason: Vec<_> = reason.split_whitespace().collect();
    let reason = reason.join(" ");
    let why = reason.trim_end_matches('.');
    text!(lang, no_window, why)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reason_for_no_window_is_one_sentence_without_paths() {
        let why = "winit EventLoopError: os error at /home/x/linux/mod.rs:765: neither A\nnor B is set.";
        let text = no_window(Lang::En, why);
        assert!(
            text.starts_with("no window can be opened here (neither A nor B is set); `camera-lab render"),
            "{text}"
        );
        assert!(no_window(Lang::PtBr, "sem OpenGL").contains("(sem OpenGL)"));
    }
}
