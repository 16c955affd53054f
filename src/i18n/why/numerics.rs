//! The words of the studies: titles, parameters, cases, methods, units.

use crate::i18n::Lang;
use crate::numbers::significant;
use crate::numerics::charts::Words;
use crate::numerics::overhead::{Cost, Price};
use crate::numerics::{Findings, Row, Study, Unit};

texts! {
    // Columns of a table.
    case: "case", "caso";
    parameter: "parameter", "parâmetro";
    method: "method", "método";
    error: "error", "erro";
    worst: "worst", "pior";
    bits: "bits off", "bits errados";
    bits_hint: "How many of the last bits of a double (53 bits of precision) are wrong", "Quantos dos últimos bits de um double (53 bits de precisão) estão errados";
    nanos: "ns", "ns";
    // Buttons.
    measure: "Measure", "Medir";
    measure_hint: "Runs all methods of this study on the same inputs, in the background. It takes a few seconds", "Executa todos os métodos deste estudo nas mesmas entradas, em segundo plano. Leva alguns segundos";
    cancel: "Cancel", "Cancelar";
    open: "open", "abrir";
    open_hint: "Shows in the three views the camera on which this method was worst. The open figure is kept with its changes", "Mostra nas três vistas a câmera em que este método foi pior. A figura aberta é guardada com as alterações";
    // Which chart.
    over_parameter: "error against parameter", "erro contra parâmetro";
    over_time: "error against time", "erro contra tempo";
    // Hints.
    measuring: "Measuring:", "Medindo:";
    nothing_yet: "Not measured yet: “Measure” runs all its methods on the same inputs and compares them with a more exact reference.", "Ainda não medido: “Medir” executa todos os métodos nas mesmas entradas e os compara com uma referência mais exata.";
    point_at: "Point at a dot to read it, and click to open its worst camera.", "Aponte para um ponto para lê-lo, e clique para abrir a pior câmera dele.";
    star: "* no other method is both as accurate and as fast", "* nenhum outro método é tão exato e tão rápido";
    // Below a table.
    front: "Pareto front", "fronteira de Pareto";
    time: "time of one item / ns", "tempo por item / ns";
}

/// The question of a study.
pub const fn title(lang: Lang, study: Study) -> &'static str {
    match study {
        Study::VertexTransform => pick!(lang; "World points to view space, far from the origin",
            "Pontos do mundo ao espaço de vista, longe da origem"),
        Study::Basis => pick!(lang; "u, v, n when VUP is almost along DOP",
            "u, v, n com VUP quase na direção de DOP"),
        Study::RepeatedOperations => pick!(lang; "Many small azimuths, one after the other",
            "Muitos azimutes pequenos, um após o outro"),
        Study::DepthBuffer => pick!(lang; "Formats of depth buffers, and depths they can't tell apart",
            "Formatos de z-buffer, e profundidades que não distinguem"),
        Study::Visibility => pick!(lang; "Which surface is seen with painter, BSP or depth buffers",
            "Qual superfície se vê com pintor, BSP ou z-buffers"),
        Study::Shading => pick!(lang; "Light on curved surfaces made of flat faces",
            "Luz em superfícies curvas feitas de faces planas"),
        Study::Antialiasing => pick!(lang; "Samples of a pixel against exact area",
            "Amostras por pixel contra a área exata"),
        Study::Clipping => pick!(lang; "Segments through w = 0, clipped before or after the division",
            "Segmentos por w = 0, recortados antes ou depois da divisão"),
        Study::TextureFilter => pick!(lang; "Filters of a texture against the exact mean over the pixel",
            "Filtros de uma textura contra a média exata sobre o pixel"),
        Study::Shadows => pick!(lang; "Shadow maps against rays to the light",
            "Mapas de sombras contra raios até a luz"),
        Study::Photograph => pick!(lang; "The camera of a photograph from lines that are a pixel off",
            "A câmera de uma fotografia, de retas erradas em um pixel"),
    }
}

/// A study by a few words.
pub const fn short_title(lang: Lang, study: Study) -> &'static str {
    match study {
        Study::VertexTransform => pick!(lang; "Worlds far away", "Mundos distantes"),
        Study::Basis => "u, v, n",
        Study::RepeatedOperations => pick!(lang; "Many operations", "Muitas operações"),
        Study::DepthBuffer => pick!(lang; "Depth buffers", "Z-buffers"),
        Study::Visibility => pick!(lang; "What is seen", "O que se vê"),
        Study::Shading => pick!(lang; "Light on curved surfaces", "Luz em superfícies curvas"),
        Study::Antialiasing => pick!(lang; "Samples of a pixel", "Amostras por pixel"),
        Study::Clipping => pick!(lang; "Clipping through w = 0", "Recorte por w = 0"),
        Study::TextureFilter => pick!(lang; "Filters of textures", "Filtros de texturas"),
        Study::Shadows => pick!(lang; "Shadow maps", "Mapas de sombras"),
        Study::Photograph => pick!(lang; "Camera of a photograph", "Câmera de uma fotografia"),
    }
}

/// The values at a point of a chart.
pub fn readout(lang: Lang, study: Study, row: &Row, number: impl Fn(f64) -> String) -> String {
    let (method, at) = (name(lang, row.method), lang.mark().printed(&value(row.parameter)));
    let error = lang.mark().printed(&short(row.error));
    let (unit, bits) = (unit(lang, row.unit), lang.mark().printed(&format!("{:.1}", row.bits)));
    let (parameter, nanos) = (parameter(lang, study), number(row.nanos));
    both!(lang; "{method}, {parameter} {at}: {unit} {error}, {bits} bits off, {nanos} ns",
        "{method}, {parameter} {at}: {unit} {error}, {bits} bits errados, {nanos} ns")
}

/// The parameter of a study.
pub const fn parameter(lang: Lang, study: Study) -> &'static str {
    match study {
        Study::VertexTransform => pick!(lang; "distance from the origin / scene units",
            "distância da origem / unidades da cena"),
        Study::Basis => pick!(lang; "angle between VUP and DOP / rad", "ângulo entre VUP e DOP / rad"),
        Study::RepeatedOperations => pick!(lang; "operations", "operações"),
        Study::DepthBuffer | Study::Visibility => "B / F",
        Study::Shading => pick!(lang; "segments", "segmentos"),
        Study::Antialiasing => pick!(lang; "size of the triangles / pixels", "tamanho dos triângulos / pixels"),
        Study::Clipping => pick!(lang; "distance of the other end from the plane w = 0 / scene units",
            "distância da outra ponta ao plano w = 0 / unidades da cena"),
        Study::TextureFilter => pick!(lang; "texels along a pixel", "texels ao longo de um pixel"),
        Study::Shadows => pick!(lang; "side of the map / texels", "lado do mapa / texels"),
        Study::Photograph => pick!(lang; "angle between the lines of an axis / degrees",
            "ângulo entre as retas de um eixo / graus"),
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
        Unit::SceneUnits => pick!(lang; "error / scene units", "erro / unidades da cena"),
        Unit::Radians => pick!(lang; "error / rad", "erro / rad"),
        Unit::Relative => pick!(lang; "relative error", "erro relativo"),
        Unit::Share => pick!(lang; "wrong fraction", "fração errada"),
        Unit::Color => pick!(lang; "error / range of a channel", "erro / faixa de um canal"),
        Unit::Ndc => pick!(lang; "error / NDC", "erro / NDC"),
    }
}

/// Names of cases and methods in Portuguese, if they differ. In English they are the names of the command line.
const PORTUGUESE: &[(&str, &str)] = &[
    ("perspective", "perspectiva"),
    ("parallel", "paralela"),
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
    let found = PORTUGUESE.iter().find(|(english, _)| *english == name).filter(|_| lang == Lang::PtBr);
    found.map_or(name, |(_, portuguese)| portuguese).to_owned()
}

/// The words of the charts of a study, given to `with`.
pub fn with_words<T>(lang: Lang, study: Study, with: impl FnOnce(&Words) -> T) -> T {
    with(&Words {
        parameter: parameter(lang, study),
        error: &|row: &Row| unit(lang, row.unit).to_owned(),
        time: texts(lang).time,
        front: texts(lang).front,
        at: &|at| both!(lang; "error against time at {}", "erro contra tempo em {}"; lang.mark().printed(&value(at))),
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
        Study::TextureFilter => "média exata sobre o pixel, em luz linear",
        Study::Shadows => "raios até a luz, em f64",
        Study::Photograph => "a câmera sorteada",
    }
}

/// A study as a table: `*` marks the methods on the Pareto front.
pub fn table(lang: Lang, findings: &Findings) -> String {
    let t = texts(lang);
    let number = |text: &str| lang.mark().typed(text);
    let mut table = format!("{} ({})\n", title(lang, findings.study), findings.study.name());
    table += &pick!(lang; format!("Reference: {}. Times: median of warm passes over inputs of {} bytes. * no other method is both as accurate and as fast.\n", findings.reference, findings.working_set),
        format!("Referência: {}. Tempos: mediana de passagens aquecidas sobre entradas de {} bytes. * nenhum outro método é tão exato e tão rápido.\n", reference(findings.study), findings.working_set));
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
            if row.pareto { '*' } else { ' ' },
            name(lang, row.method),
            number(&short(row.error)),
            number(&short(row.error_max)),
            number(&format!("{:.1}", row.bits)),
            number(&significant(row.nanos, 3)),
        );
    }
    table
}

/// The cost of the camera model in double-double.
pub fn price(lang: Lang, price: &Price) -> String {
    let micros = |nanos: f64| lang.mark().printed(&significant(nanos / 1e3, 3));
    let [(a, b), (c, d)] = [price.numbers, price.frame].map(|cost| (micros(cost.camera_lab), micros(cost.f64)));
    let more = |cost: Cost| lang.mark().printed(&format!("{:.1}", 100.0 * (cost.camera_lab / cost.f64 - 1.0)));
    both!(lang; "The cost of the camera model in double-double\n\n  numbers of a figure: {a} µs; textbook formulas in f64: {b} µs\n  a frame of the first scene: {c} µs; with the textbook formulas: {d} µs ({} % more)\n",
        "O custo do modelo de câmera em precisão dupla-dupla\n\n  números de uma figura: {a} µs; fórmulas do livro em f64: {b} µs\n  um quadro da primeira cena: {c} µs; com as fórmulas do livro: {d} µs ({} % a mais)\n"; more(price.frame))
}

/// An error with its size and little more.
pub fn short(x: f64) -> String {
    if x == 0.0 { "0".to_owned() } else { format!("{x:.1e}") }
}
