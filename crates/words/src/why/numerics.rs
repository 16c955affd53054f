//! The words of the studies: titles, parameters, cases, methods, units.

use crate::Grammar;
use crate::numbers::significant;
use crate::numerics::charts::Words;
use crate::numerics::overhead::{Cost, Price};
use crate::numerics::three_ways::ThreeWays;
use crate::numerics::{Findings, Row, Study, Unit};
use camera_lab_figures::chart::power_of_ten;

texts!("why/numerics");

/// The question of a study.
pub const fn title(lang: Lang, study: Study) -> &'static str {
    match study {
        Study::VertexTransform => text!(lang, title_vertex_transform),
        Study::Basis => text!(lang, title_basis),
        Study::RepeatedOperations => text!(lang, title_repeated_operations),
        Study::DepthBuffer => text!(lang, title_depth_buffer),
        Study::Visibility => text!(lang, title_visibility),
        Study::Shading => text!(lang, title_shading),
        Study::Antialiasing => text!(lang, title_antialiasing),
        Study::Grid => text!(lang, title_grid),
        Study::Clipping => text!(lang, title_clipping),
        Study::TextureFilter => text!(lang, title_texture_filter),
        Study::Shadows => text!(lang, title_shadows),
        Study::Photograph => text!(lang, title_photograph),
    }
}

/// A study by a few words.
pub const fn short_title(lang: Lang, study: Study) -> &'static str {
    match study {
        Study::VertexTransform => text!(lang, short_title_vertex_transform),
        Study::Basis => "u, v, n",
        Study::RepeatedOperations => text!(lang, short_title_repeated_operations),
        Study::DepthBuffer => text!(lang, short_title_depth_buffer),
        Study::Visibility => text!(lang, short_title_visibility),
        Study::Shading => text!(lang, short_title_shading),
        Study::Antialiasing => text!(lang, short_title_antialiasing),
        Study::Grid => text!(lang, short_title_grid),
        Study::Clipping => text!(lang, short_title_clipping),
        Study::TextureFilter => text!(lang, short_title_texture_filter),
        Study::Shadows => text!(lang, short_title_shadows),
        Study::Photograph => text!(lang, short_title_photograph),
    }
}

/// The values at a point of a chart.
pub fn readout(lang: Lang, study: Study, row: &Row, number: impl Fn(f64) -> String) -> String {
    let (method, at) = (name(lang, row.method), lang.mark().printed(&value(row.parameter)));
    let error = lang.mark().printed(&short(row.error));
    let (unit, bits) = (unit(lang, row.unit), lang.mark().printed(&format!("{:.1}", row.bits)));
    let (parameter, nanos) = (parameter(lang, study), number(row.nanos));
    text!(lang, readout, method, parameter, at, unit, error, bits, nanos)
}

/// The parameter of a study.
pub const fn parameter(lang: Lang, study: Study) -> &'static str {
    match study {
        Study::VertexTransform => text!(lang, parameter_vertex_transform),
        Study::Basis => text!(lang, parameter_basis),
        Study::RepeatedOperations => text!(lang, parameter_repeated_operations),
        Study::DepthBuffer | Study::Visibility => "B / F",
        Study::Shading => text!(lang, parameter_shading),
        Study::Antialiasing | Study::Grid => text!(lang, parameter_antialiasing),
        Study::Clipping => text!(lang, parameter_clipping),
        Study::TextureFilter => text!(lang, parameter_texture_filter),
        Study::Shadows => text!(lang, parameter_shadows),
        Study::Photograph => text!(lang, parameter_photograph),
    }
}

/// A value of the parameter. Whole thousands, like the sides of maps, are written with all of their digits.
pub fn value(parameter: f64) -> String {
    let is_whole = parameter.fract() == 0.0 && (1e3..1e4).contains(&parameter);
    significant(parameter, if is_whole { 4 } else { 3 })
}

/// The meaning of an error, with its unit.
pub const fn unit(lang: Lang, unit: Unit) -> &'static str {
    match unit {
        Unit::SceneUnits => text!(lang, unit_scene_units),
        Unit::Radians => text!(lang, unit_radians),
        Unit::Relative => text!(lang, unit_relative),
        Unit::Share => text!(lang, unit_share),
        Unit::Color => text!(lang, unit_color),
        Unit::Ndc => text!(lang, unit_ndc),
    }
}

/// Names of cases and methods in Portuguese, if they differ. In English they are the names of the command line.
const PORTUGUESE: &[(&str, &str)] = &[
    ("perspective", "perspectiva"),
    ("parallel", "paralela"),
    ("f16 matrix", "f16 matriz única"),
    ("bf16 matrix", "bf16 matriz única"),
    ("fixed-16.16 matrix", "fixed-16.16 matriz única"),
    ("f16 naive", "f16 ingênuo"),
    ("bf16 naive", "bf16 ingênuo"),
    ("fixed-16.16 naive", "fixed-16.16 ingênuo"),
    ("f16 reversed", "f16 invertido"),
    ("bf16 reversed", "bf16 invertido"),
    ("fixed-16.16 reversed", "fixed-16.16 invertido"),
    ("phong f16", "phong em f16"),
    ("phong bf16", "phong em bf16"),
    ("phong fixed-16.16", "phong em fixed-16.16"),
    ("f32 matrix", "f32 matriz única"),
    ("f32 stages", "f32 em etapas"),
    ("f32 relative to eye", "f32 relativo ao olho"),
    ("f64 matrix", "f64 matriz única"),
    ("f64 stages", "f64 em etapas"),
    ("f64 compensated", "f64 compensado"),
    ("camera-lab pictures", "camera-lab, figuras"),
    ("size 1", "tamanho 1"),
    ("size 1e150", "tamanho 1e150"),
    ("size 1e-150", "tamanho 1e-150"),
    ("f32 naive", "f32 ingênuo"),
    ("f64 naive", "f64 ingênuo"),
    ("f64 scaled", "f64 com escala"),
    ("orthonormality", "ortonormalidade"),
    ("distance", "distância D"),
    ("position", "posição C"),
    ("f32 orthonormalised", "f32 ortonormalizada"),
    ("f64 orthonormalised", "f64 ortonormalizada"),
    ("f32 quaternion", "f32 quatérnio"),
    ("f64 quaternion", "f64 quatérnio"),
    ("perspective at F", "perspectiva, em F"),
    ("perspective at √(F B)", "perspectiva, em √(F B)"),
    ("perspective at B", "perspectiva, em B"),
    ("perspective z-fighting", "perspectiva, z-fighting"),
    ("parallel at √(F B)", "paralela, em √(F B)"),
    ("parallel z-fighting", "paralela, z-fighting"),
    ("fixed 16", "ponto fixo 16"),
    ("fixed 24", "ponto fixo 24"),
    ("f32 reversed", "f32 invertido"),
    ("logarithmic 24", "logarítmico 24"),
    ("interpenetrating", "que se atravessam"),
    ("cyclic overlap", "sobreposição cíclica"),
    ("close surfaces", "superfícies próximas"),
    ("flat", "plana"),
    ("painter", "pintor"),
    ("bsp", "BSP"),
    ("depth buffer 16", "z-buffer 16"),
    ("depth buffer 24", "z-buffer 24"),
    ("sphere", "esfera"),
    ("torus", "toro"),
    ("sphere silhouette", "silhueta da esfera"),
    ("torus silhouette", "silhueta do toro"),
    ("triangles", "triângulos"),
    ("cracks", "frestas"),
    ("silhouettes", "silhuetas"),
    ("slivers", "lascas"),
    ("1 sample", "1 amostra"),
    ("4 samples", "4 amostras"),
    ("16 samples", "16 amostras"),
    ("64 samples on a grid", "64 amostras em grade"),
    ("16 samples on a grid", "16 amostras em grade"),
    ("in front", "à frente do olho"),
    ("through w = 0", "por w = 0"),
    ("f32 after the divide", "f32 depois da divisão"),
    ("f32 before the divide", "f32 antes da divisão"),
    ("f64 after the divide", "f64 depois da divisão"),
    ("f64 before the divide", "f64 antes da divisão"),
    ("floor from above", "chão visto de cima"),
    ("slanted floor", "chão inclinado"),
    ("grazing floor", "chão rasante"),
    ("nearest", "texel mais próximo"),
    ("16 samples of nearest", "16 do mais próximo"),
    ("screen and ball", "biombo e bola"),
    ("screen and ball, acne", "biombo e bola, acne"),
    ("screen and ball, detached", "biombo e bola, descoladas"),
    ("house", "casa"),
    ("house, acne", "casa, acne"),
    ("house, detached", "casa, descoladas"),
    ("corridor with a lamp", "corredor com luz"),
    ("corridor with a lamp, acne", "corredor com luz, acne"),
    ("corridor with a lamp, detached", "corredor com luz, descoladas"),
    ("bias 0, edge 1", "bias 0, borda 1"),
    ("bias 30, edge 1", "bias 30, borda 1"),
    ("bias 1, edge 0", "bias 1, borda 0"),
    ("bias 1, edge 1", "bias 1, borda 1"),
    ("bias 1, edge 4", "bias 1, borda 4"),
    ("view angle", "ângulo de vista"),
    ("direction", "direção"),
    ("two lines", "duas retas"),
    ("mean of intersections", "média das interseções"),
];

/// A case or a method by its name.
pub fn name(lang: Lang, name: &str) -> String {
    let found =
        PORTUGUESE.iter().find(|(english, _)| *english == name).filter(|_| lang.grammar() == Grammar::Portuguese);
    found.map_or(name, |(_, portuguese)| portuguese).to_owned()
}

/// The words of the charts of a study, given to `with`.
pub fn with_words<T>(lang: Lang, study: Study, with: impl FnOnce(&Words) -> T) -> T {
    let name_of_parameter = parameter(lang, study);
    let at = |at: f64| {
        let is_power = at >= 1e5 && at.log10().fract() == 0.0;
        let value = if is_power { power_of_ten(at) } else { lang.mark().printed(&value(at)) };
        // A longer name has no room in a title.
        if name_of_parameter.chars().count() <= 24 { format!("{name_of_parameter} = {value}") } else { value }
    };
    with(&Words {
        parameter: name_of_parameter,
        error: &|row: &Row| unit(lang, row.unit).to_owned(),
        time: texts(lang).time,
        front: texts(lang).front,
        at: &|value| text!(lang, with_words, at = at(value)),
        case: &|case| name(lang, case),
        method: &|method| name(lang, method),
    })
}

/// The reference of a study's errors, in Portuguese. In English the study names it itself.
fn reference(study: Study) -> &'static str {
    match study {
        Study::VertexTransform | Study::Basis | Study::RepeatedOperations | Study::Clipping => "512 bits",
        Study::DepthBuffer => "ordem exata das profundidades",
        Study::Visibility => "traçado de raios com 512 bits",
        Study::Shading => "traçado de raios da superfície verdadeira com 512 bits",
        Study::Antialiasing => "área exata com 512 bits",
        Study::Grid => "cobertura exata",
        Study::TextureFilter => "média exata sobre o pixel, em luz linear",
        Study::Shadows => "raios até a luz, em f64",
        Study::Photograph => "a câmera sorteada",
    }
}

/// The kind of a study's error, in the words of [FPBench](https://fpbench.org): forward or backward, absolute or
/// relative, sampled or proved.
pub const fn kind(lang: Lang, study: Study) -> &'static str {
    match study {
        Study::VertexTransform | Study::Basis | Study::Shading | Study::Antialiasing => text!(lang, kind_absolute),
        Study::Clipping | Study::TextureFilter | Study::Photograph => text!(lang, kind_absolute),
        Study::RepeatedOperations => text!(lang, kind_relative),
        Study::DepthBuffer | Study::Visibility | Study::Shadows | Study::Grid => text!(lang, kind_share),
    }
}

/// A study as a table: `*` marks the methods on the Pareto front.
pub fn table(lang: Lang, findings: &Findings) -> String {
    let t = texts(lang);
    let number = |text: &str| lang.mark().typed(text);
    let mut table = format!("{} ({})\n", title(lang, findings.study), findings.study.name());
    let reference = if lang.grammar() == Grammar::Portuguese { reference(findings.study) } else { findings.reference };
    table += &text!(lang, table, reference, kind = kind(lang, findings.study), working_set = findings.working_set);
    let mut last: Option<(&str, f64)> = None;
    for row in &findings.rows {
        if last != Some((&row.case, row.parameter)) {
            let at = number(&value(row.parameter));
            table += &format!("\n{}, {} = {}\n", name(lang, &row.case), parameter(lang, findings.study), at);
            table += &format!("    {:<34}{:>10}{:>10}{:>14}{:>12}\n", t.method, t.error, t.worst, t.bits, t.nanos);
            last = Some((&row.case, row.parameter));
        }
        table += &format!(
            "  {} {:<34}{:>10}{:>10}{:>14}{:>12}\n",
            mark(row),
            name(lang, row.method),
            number(&short(row.error)),
            number(&short(row.error_max)),
            number(&format!("{:.1}", row.bits)),
            number(&significant(row.nanos, 3)),
        );
    }
    table
}

/// The mark of a row in a table: on the front, off it, or undecided.
const fn mark(row: &Row) -> char {
    match (row.undecided, row.pareto) {
        (true, _) => '?',
        (false, true) => '*',
        (false, false) => ' ',
    }
}

/// The cost of the camera model in double-double.
pub fn price(lang: Lang, price: &Price) -> String {
    let micros = |nanos: f64| lang.mark().printed(&significant(nanos / 1e3, 3));
    let [(a, b), (c, d)] = [price.numbers, price.frame].map(|cost| (micros(cost.camera_lab), micros(cost.f64)));
    let more = |cost: Cost| lang.mark().printed(&format!("{:.1}", 100.0 * (cost.camera_lab / cost.f64 - 1.0)));
    text!(lang, price, a, b, c, d, more = more(price.frame))
}

/// The digits of M_v, as three ways tell them.
pub fn three_ways(lang: Lang, ThreeWays { reference, bound, random }: ThreeWays) -> String {
    let [reference, bound, random] = [reference, bound, random].map(|x| lang.mark().printed(&format!("{x:.1}")));
    text!(lang, three_ways, reference, bound, random)
}

/// An error with its size and little more.
pub fn short(x: f64) -> String {
    if x == 0.0 { "0".to_owned() } else { format!("{x:.1e}") }
}
