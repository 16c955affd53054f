//! The words in the three pictures.

use super::{messages, told, window};
use crate::figure::{Figure, Localized};
use crate::picture::{Composite, Crowded, Metadata, NoAreas};
use crate::stage::Stage;
use crate::views::Labels;
use crate::why::pipeline;
use crate::window::{canvas, scenes};

texts!("pictures");

/// [`Labels`]: a text for each field of the same name, and the other fields.
macro_rules! labels {
    ($texts:ident { $($text:ident)* } $($field:ident: $value:expr,)*) => {
        Labels { $($text: $texts.$text,)* $($field: $value,)* }
    };
}

const fn of(t: &Texts) -> Labels {
    let (style, scene) = (window::texts(t.lang), scenes::texts(t.lang));
    labels! {
        t {
            window near far scene vertex point before answered depth_stored depth_linear depth_of_light acne
            map_wrong out_of too_much_for_rays nothing outside cuts back_faces dropped outside_of no_stage
            with_w affine levels texels divided_first wrong no_difference not_split rounded reversed
            right_handed left_handed triangles goes_in comes_out not_all no_vanishing ideal beyond_image
            behind_eye in_eye_plane in_eye horizon epipolar epipole painted_over from_front world this_camera other_camera differ step_number samples
        }
        mark: t.lang.mark(),
        operations: [
            style.elevation, style.azimuth, style.roll, style.yaw, style.pitch, style.zoom, style.dolly, t.pan,
        ],
        switches: [
            ("reveal.clipping", style.clipping_view),
            ("reveal.divide_first", style.divide_first),
            ("reveal.culled", style.culled_view),
            ("reveal.vanishing", style.vanishing),
            ("reveal.single_precision", t.single_precision),
            ("world.section", t.section),
            ("world.dimensions", style.dimensions),
            ("image.undistorted", t.undistorted),
        ],
        depths: [style.depth_off, style.depth_stored, style.depth_linear],
        outsides: [style.outside_usual, style.outside_cut, style.outside_tinted, style.outside_shown],
        shadow_reveals: [scene.shadow_plain, scene.shadow_of_light, scene.shadow_acne, scene.shadow_truth],
        costs: [t.cost_none, t.cost_overdraw, t.cost_operations, t.cost_rounding, t.cost_error],
        face_orders: [t.as_listed, t.order_front, t.order_back],
        world_parts: [
            t.part_grid, t.part_axes, t.part_camera_body, "u, v, n", "VUP", "DOP", "PF", t.part_volume,
            t.part_window, t.part_ground_marks, t.part_names,
        ],
        yes_no: [t.yes, t.no],
        shadings: [style.shading_wireframe, style.shading_flat, style.shading_gouraud, style.shading_phong],
        visibilities: [style.visibility_depth_buffer, style.visibility_painter, style.visibility_bsp],
        hidden_lines: [t.hidden_dashed, t.hidden_hidden, t.hidden_shown],
        depth_formats: [t.fixed_16, t.fixed_24, t.float],
        vertices_in: t.vertices_in,
        subpixel_bits: t.subpixel_bits,
        projections: [t.perspective, t.parallel],
        stages: stages(t.lang),
        steps: [
            t.to_eye, t.turn, t.turn_left_handed, t.clip_rows, t.divide, t.to_box, t.centre, t.scale, t.pers,
            t.xy_scale, t.unit_slope, t.unit_depth, t.canonical_box, t.near_to_origin, t.scale_ort,
        ],
        planes: [t.plane_left, t.plane_right, t.plane_bottom, t.plane_top, t.plane_near, t.plane_far],
    }
}

/// The words of each language, in the order of [`Lang::ALL`].
static LABELS: [Labels; Lang::ALL.len()] = {
    let mut all = [of(texts(Lang::En)); Lang::ALL.len()];
    let mut at = 0;
    while at < all.len() {
        all[at] = of(texts(Lang::ALL[at]));
        at += 1;
    }
    all
};

/// The words of a language.
pub const fn labels(lang: Lang) -> &'static Labels {
    &LABELS[lang as usize]
}

/// Three pictures with less room on their paper than their letters need.
pub fn crowded(lang: Lang, crowded: &Crowded) -> String {
    let Crowded { smallest, wanted, room } = crowded;
    let number = |value: &f64| lang.mark().printed(&format!("{value:.1}"));
    let size = |size: &[f64; 2]| format!("{} × {} cm", number(&size[0]), number(&size[1]));
    let (smallest, room) = (size(smallest), size(room));
    let wanted = lang.mark().number(*wanted, 3);
    text!(lang, crowded, smallest, wanted, room)
}

/// Letters that are too small on paper.
pub fn tiny_letters(lang: Lang, points: f64) -> String {
    let points = lang.mark().printed(&format!("{points:.1}"));
    text!(lang, tiny_letters, points)
}

/// The names of the stages, in their order.
const fn stages(lang: Lang) -> [&'static str; Stage::ALL.len()] {
    let mut names = [""; Stage::ALL.len()];
    let mut place = 0;
    while place < names.len() {
        names[place] = pipeline::stage(lang, Stage::ALL[place]);
        place += 1;
    }
    names
}

/// The words that go with pictures into their file: the title of the figure, or the names of the pictures, its caption,
/// and a description of each picture.
pub fn told_of(lang: Lang, figure: &Figure, sheet: &Composite, text: String) -> Metadata {
    let own =
        |text: &Option<Localized>| text.as_ref().map(|text| told(lang, text).to_owned()).filter(|t| !t.is_empty());
    let names = sheet.requests.iter().map(|request| canvas::texts(lang).view(request.view));
    let title = own(&figure.title).unwrap_or_else(|| names.collect::<Vec<_>>().join(", "));
    let words =
        sheet.requests.iter().map(|request| canvas::describe(lang, request.view, &request.camera, figure.image));
    let description = own(&figure.caption).into_iter().chain(words.map(|words| format!("{words}.")));
    let description = description.collect::<Vec<_>>().join(" ");
    Metadata { figure: text, title, description, language: lang.tag(), stem: String::new() }
}

/// The reason why the faces of a page of vectors are a picture, although areas were requested.
pub fn no_areas(lang: Lang, why: &NoAreas) -> String {
    match why {
        NoAreas::Shaded => text!(lang, no_areas_shaded).to_owned(),
        NoAreas::Partial => text!(lang, no_areas_partial).to_owned(),
        NoAreas::OverBudget(over) => text!(lang, no_areas_over_budget, over_budget = messages::over_budget(lang, over)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_labels_that_are_no_symbols_have_words() {
        let named = |name| labels(Lang::PtBr).named(name);
        for name in [
            "window",
            "near",
            "far",
            "scene",
            "before",
            "answered",
            "outside",
            "horizon",
            "epipolar",
            "epipole",
            "behind-eye",
            "goes-in",
            "comes-out",
            "differ",
            "elevation",
            "azimuth",
            "corner:near-left-bottom",
        ] {
            assert_ne!(named(name), name);
        }
        assert_eq!(named("corner:far-right-top"), "fundo, direita, topo");
        assert_eq!(["C", "VUP", "x_n"].map(named), ["C", "VUP", "x_n"]);
    }
}
