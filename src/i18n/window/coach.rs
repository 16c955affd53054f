//! The words of the coach: the health of a camera, and the reasons why a picture is empty.

use std::collections::BTreeMap;

use super::scenes::preset_object;
use crate::appearance::DepthFormat;
use crate::camera::{Camera, CameraError, Ndc, Projection};
use crate::i18n::Lang;
use crate::i18n::messages::cameras::warning_wording;
use crate::i18n::why::conventions;
use crate::numbers::significant;
use crate::numerics::diagnosis::{Cause, Diagnosis, Finding, Value, WrongPixels};
use crate::numerics::health::{Health, HealthQuantity, Level, coarseness, volume_sides};
use crate::sanitize::{self, escaped};
use crate::scene::SceneSpec;

texts! {
    // For the command line.
    health: "Health", "Saúde";
    findings: "Problems", "Problemas";
    no_problems: "No problems found. The image agrees with exact visibility.", "Nenhum problema encontrado. A imagem concorda com a visibilidade exata.";
    on_the_other_side: "In the other version of the comparison:", "Na outra versão da comparação:";
    no_problems_in_coarse: "No problems found. A coarser image agrees with exact visibility.", "Nenhum problema encontrado. Uma imagem menos fina concorda com a visibilidade exata.";
    repair: "Repair", "Correção";
    no_repair: "no change to the figure repairs this", "nenhuma mudança na figura corrige isto";
    nothing_repaired: "there's nothing to repair, so the figure is written unchanged", "não há nada a corrigir, e a figura é gravada sem mudança";
    cannot_repair: "no change to the figure repairs this, so it's written unchanged", "nenhuma mudança na figura corrige isto, e ela é gravada como está";
    // For the window.
    coach: "Camera check", "Diagnóstico da câmera";
    coach_hint: "How close the camera is to numerical trouble, and why something is missing from the image", "Quão perto a câmera está de problemas numéricos, e por que algo falta na imagem";
    camera_is: "Camera check:", "Diagnóstico da câmera:";
    image_empty: "Image empty: why?", "Imagem vazia: por quê?";
    one_finding: "1 problem", "1 problema";
    many_findings: "problems", "problemas";
    show_it: "Fix it", "Corrigir";
    improve: "Improve", "Melhorar";
    looking: "Looking…", "Examinando…";
    too_large: "The image is too large to be drawn.", "A imagem é grande demais para ser desenhada.";
    about_depth: "Depth and z-fighting in a depth buffer →", "Profundidade e z-fighting em um z-buffer →";
    depth_hint: "z_n against the distance from the eye, from F to B, in the convention in use. The curves are in perspective, linear as in parallel projection, and reversed (from 1 to 0). The thick curve is that of this camera", "z_n em função da distância ao olho, de F a B, na convenção em uso. As curvas são a da perspectiva, a linear, como na projeção paralela, e a invertida (de 1 a 0). A curva grossa é a desta câmera";
    depth_chart: "Depth against the distance from the eye", "Profundidade em função da distância ao olho";
    distance: "distance from the eye", "distância ao olho";
    perspective: "perspective", "perspectiva";
    parallel: "parallel", "paralela";
    reversed: "reversed", "invertida";
    format: "format", "formato";
    step_here: "step at this depth", "passo nesta profundidade";
    two_planes: "Two planes, this far apart:", "Dois planos, a esta distância:";
    two_planes_hint: "In scene units. Imagine a tilted plane this far behind another, parallel to it and drawn after it. If a format stores the same value for both, the farther one shows through", "Em unidades da cena. Pense em um plano inclinado a esta distância atrás de outro, paralelo a ele e desenhado depois. Se um formato guarda o mesmo valor para os dois, aparece o mais distante";
    scene_units: "scene units", "unidades da cena";
    nearer: "nearer", "o mais próximo";
    farther: "farther", "o mais distante";
    at_probe: "at the distance of the probe,", "na distância da sonda,";
    at_focus: "at the distance of PF,", "na distância de PF,";
    suggested: "F and B that hold the scene:", "F e B que contêm a cena:";
    use_them: "Use them", "Usar";
    shadow_bias: "bias of shadows", "bias das sombras";
    good: "good", "boa";
    fair: "fair", "regular";
    poor: "poor", "ruim";
}

/// The word for a level.
pub const fn level(lang: Lang, level: Level) -> &'static str {
    let t = texts(lang);
    match level {
        Level::Good => t.good,
        Level::Fair => t.fair,
        Level::Poor => t.poor,
    }
}

/// The level of the camera, in two words.
pub fn camera_is(lang: Lang, level: Level) -> String {
    format!("{} {}", texts(lang).camera_is, self::level(lang, level))
}

/// The judged quantity, in a few words.
pub const fn quantity(lang: Lang, quantity: HealthQuantity) -> &'static str {
    match quantity {
        HealthQuantity::VupAngle => pick!(lang; "angle between VUP and DOP", "ângulo entre VUP e DOP"),
        HealthQuantity::FarNearRatio => "B / F",
        HealthQuantity::DepthResolution => pick!(lang; "depth resolution", "resolução em profundidade"),
        HealthQuantity::PositionDigits => pick!(lang; "digits left", "dígitos que restam"),
        HealthQuantity::VolumeShape => pick!(lang; "shape of the volume", "forma do volume"),
        HealthQuantity::ViewAngle => pick!(lang; "view angle θ", "ângulo de vista θ"),
    }
}

/// A plain sentence about one quantity of a camera, with the equation of the notes that it comes from.
pub fn health(lang: Lang, health: &Health, camera: &Camera, format: DepthFormat) -> String {
    let n = |x: f64| length(lang, x);
    let perspective = camera.projection() == Projection::Perspective;
    let own = match health.quantity {
        HealthQuantity::VupAngle => vup_angle(lang, health.value),
        HealthQuantity::FarNearRatio if perspective => {
            let half = 2.0 * camera.near() / (1.0 + camera.near() / camera.far());
            let (ratio, half) = (n(health.value), n(half));
            both!(lang; "B/F is {ratio}, so half of all values of Z (5.25) lie before depth 2BF/(B + F) = {half}.",
                "B/F é {ratio}, e metade dos valores de Z (5.25) fica antes da profundidade 2BF/(B + F) = {half}.")
        }
        HealthQuantity::FarNearRatio => {
            let ratio = n(health.value);
            both!(lang; "B/F is {ratio}. In parallel projection Z (5.25) grows linearly with depth, whatever B/F is.",
                "B/F é {ratio}. Na projeção paralela Z (5.25) cresce linearmente com a profundidade, qualquer que seja B/F.")
        }
        HealthQuantity::DepthResolution => depth_resolution(lang, camera, format),
        HealthQuantity::PositionDigits => {
            let (ratio, digits) = (n(camera.origin_ratio()), n(health.value));
            both!(lang; "C and PF lie {ratio} times as far from the origin as from each other. Of 16 digits, p − C in (5.7) keeps {digits}.",
                "C e PF estão {ratio} vezes mais longe da origem que um do outro. De 16 dígitos, p − C em (5.7) conserva {digits}.")
        }
        HealthQuantity::VolumeShape => {
            let [w, h, d] = volume_sides(camera).map(n);
            let ratio = n(health.value);
            both!(lang; "At half its depth the view volume is {w} wide and {h} high, H = 2 d tan(θ/2) (5.5), and B − F = {d} deep. Its longest side is {ratio} times its shortest.",
                "À meia profundidade o volume de vista tem largura {w} e altura {h}, H = 2 d tan(θ/2) (5.5), e profundidade B − F = {d}. O lado maior é {ratio} vezes o menor.")
        }
        HealthQuantity::ViewAngle => view_angle(lang, health.value, perspective),
    };
    let more = health.warnings.iter().filter(|_| health.quantity == HealthQuantity::VolumeShape);
    more.fold(own, |text, warning| format!("{text} {}.", warning_wording(lang, warning).in_symbols))
}

fn vup_angle(lang: Lang, degrees: f64) -> String {
    let n = |x: f64| lang.mark().number(x, 3);
    let lost = -degrees.to_radians().sin().log10();
    let angle = n(degrees);
    if lost < 0.5 {
        return both!(lang;
            "VUP is {angle}° away from the line of DOP, so u = VUP × n / |VUP × n| (5.3) keeps its digits.",
            "VUP está a {angle}° da reta de DOP, e u = VUP × n / |VUP × n| (5.3) conserva os dígitos.");
    }
    both!(lang;
        "VUP is only {angle}° away from the line of DOP. An error in VUP is {} times as large in u = VUP × n / |VUP × n| (5.3), which costs {} digits.",
        "VUP está a só {angle}° da reta de DOP. Um erro em VUP é {} vezes maior em u = VUP × n / |VUP × n| (5.3), o que custa {} dígitos.";
        n(10f64.powf(lost)), n(lost))
}

/// A number with three digits. If it's beyond the greatest `f64`, the text says so.
fn length(lang: Lang, x: f64) -> String {
    if x < f64::MAX { lang.mark().number(x, 3) } else { both!(lang; "more than 10³⁰⁸", "mais de 10³⁰⁸") }
}

fn depth_resolution(lang: Lang, camera: &Camera, format: DepthFormat) -> String {
    let step = |z: f64| length(lang, (camera.depth_step(z) * coarseness(format)).min(f64::MAX));
    let [at_near, at_focus, at_far] = [camera.near(), camera.distance(), camera.far()].map(step);
    let (bits, power) = if format == DepthFormat::Fixed16 { (16, "2¹⁶") } else { (24, "2²⁴") };
    let own = match camera.projection() {
        Projection::Perspective => both!(lang;
            "{bits} bits of Z (5.25) tell apart depths d that differ by d² (B − F) / (B F {power}): by {at_near} at F, {at_focus} at PF, {at_far} at B.",
            "{bits} bits de Z (5.25) distinguem profundidades d que diferem de d² (B − F) / (B F {power}): de {at_near} em F, {at_focus} em PF, {at_far} em B."),
        Projection::Parallel => both!(lang;
            "{bits} bits of Z (5.25) tell apart depths that differ by (B − F) / {power} = {at_far}, at every depth.",
            "{bits} bits de Z (5.25) distinguem profundidades que diferem de (B − F) / {power} = {at_far}, em toda profundidade."),
    };
    match format {
        DepthFormat::Float => both!(lang; "{own} This figure's reversed f32 depths are finer.",
            "{own} As profundidades desta figura, em f32 invertido, são mais finas."),
        _ => own,
    }
}

fn view_angle(lang: Lang, degrees: f64, perspective: bool) -> String {
    let stretched = (0.5 * degrees).to_radians().cos().powi(-2);
    let (angle, stretched) = (lang.mark().number(degrees, 4), lang.mark().number(stretched, 3));
    if !perspective {
        return both!(lang; "Parallel projection has no θ, so nothing is stretched towards the borders.",
            "A projeção paralela não tem θ, e nada se estica perto das bordas.");
    }
    both!(lang;
        "θ is {angle}° (5.4). At the upper border things are drawn 1/cos²(θ/2) = {stretched} times as high as in the middle.",
        "θ é {angle}° (5.4). Na borda de cima tudo é desenhado 1/cos²(θ/2) = {stretched} vezes mais alto que no meio.")
}

/// The owner of the NDC of depths.
pub fn depth_in(lang: Lang, ndc: Ndc) -> String {
    let name = conventions::name(lang, ndc);
    let [near, far] = ndc.depths().map(|depth| lang.mark().number(depth, 2));
    let back = if ndc.infinite { "B → ∞" } else { "B" };
    both!(lang; "In the NDC of {name}, z_n is {near} at F and {far} at {back}.",
        "No NDC de {name}, z_n é {near} em F e {far} em {back}.")
}

/// The verdict of a depth buffer on two planes. `share` is the part of their common area in which the farther one is
/// visible.
pub fn two_planes(lang: Lang, share: f64) -> String {
    let percent = lang.mark().number(100.0 * share, 2);
    if share == 0.0 {
        return both!(lang; "told apart", "distinguem-se");
    }
    both!(lang; "flicker (z-fighting): the farther on {percent}\u{a0}%",
        "cintilam (z-fighting): o mais distante em {percent}\u{a0}%")
}

/// Explains a finding, with the names of the objects concerned in this language. `scene` is the figure's, whose own
/// objects have their names from its author.
pub fn finding(lang: Lang, finding: &Finding, diagnosis: &Diagnosis, scene: &SceneSpec) -> String {
    if let Some(error) = &diagnosis.camera_error {
        return impossible_camera(lang, error);
    }
    if let Some(pixels) = finding.pixels {
        let names: Vec<String> = finding.objects().map(|name| object_name(lang, name, scene)).collect();
        let sentence = wrong_pixels(lang, finding.cause, pixels);
        return if names.is_empty() { sentence } else { format!("{}: {sentence}", listed(lang, &names)) };
    }
    match finding.cause {
        Cause::EmptyScene => {
            return both!(lang; "The scene is empty: there is nothing to draw.", "A cena está vazia: não há o que desenhar.");
        }
        Cause::NotCompared => {
            return both!(lang; "The image has too many pixels or faces to be compared with exact visibility.",
                "A imagem tem pixels ou faces demais para ser comparada com a visibilidade exata.");
        }
        _ => {}
    }
    let [whole, in_part] = [false, true].map(|partly| not_seen(lang, finding.cause, partly, diagnosis));
    let [lost, cut] = [&finding.whole, &finding.partly]
        .map(|names| names.iter().map(|name| object_name(lang, name, scene)).collect::<Vec<_>>());
    // A sentence that also holds for partly visible objects is written once.
    let groups =
        if whole == in_part { vec![([lost, cut].concat(), whole)] } else { vec![(lost, whole), (cut, in_part)] };
    let sentences = groups.into_iter().filter(|(names, _)| !names.is_empty());
    sentences.map(|(names, said)| format!("{}: {said}", listed(lang, &names))).collect::<Vec<_>>().join(" ")
}

/// The files that a figure needs and that can't be read. Each is true if there is no such file.
pub fn lost_files(lang: Lang, lost: &BTreeMap<String, bool>) -> String {
    let (gone, unread): (Vec<_>, Vec<_>) = lost.iter().partition(|(_, is_gone)| **is_gone);
    let sentence = |files: Vec<(&String, &bool)>, [one, many]: [&str; 2]| {
        let names: Vec<String> = files.into_iter().map(|(name, _)| sanitize::within(name, 60)).collect();
        let words = if names.len() == 1 { one } else { many };
        (!names.is_empty()).then(|| format!("{} {words}", listed(lang, &names)))
    };
    let gone = sentence(gone, pick!(lang; ["is missing", "are missing"], ["está faltando", "estão faltando"]));
    let unread =
        sentence(unread, pick!(lang; ["can't be read", "can't be read"], ["não pode ser lido", "não podem ser lidos"]));
    gone.into_iter().chain(unread).collect::<Vec<_>>().join("; ")
}

/// The name of an object: its author's, or in this language that of a part of a named scene.
fn object_name(lang: Lang, name: &str, scene: &SceneSpec) -> String {
    match name {
        "" => both!(lang; "The scene", "A cena"),
        name if scene.objects.iter().any(|object| object.name == name) => escaped(name),
        name => preset_object(lang, name),
    }
}

/// The equation that has no result, and why.
fn impossible_camera(lang: Lang, error: &CameraError) -> String {
    let reason = match (lang, error) {
        (_, CameraError::ViewUpZero | CameraError::ViewUpCollinear) => pick!(lang;
            "u = VUP × n / |VUP × n| (5.3) has no direction: ",
            "u = VUP × n / |VUP × n| (5.3) não tem direção: "),
        (_, CameraError::FocalPointAtPosition) => pick!(lang; "DOP = PF − C has no direction: ",
            "DOP = PF − C não tem direção: "),
        (_, CameraError::FarNotBeyondNear { .. }) => pick!(lang; "The view volume from F to B is empty: ",
            "O volume de vista entre F e B está vazio: "),
        _ => "",
    };
    format!("{reason}{}.", crate::i18n::messages::cameras::camera_wording(lang, error).in_symbols)
}

/// The fault of pixels, with their number.
fn wrong_pixels(lang: Lang, cause: Cause, pixels: WrongPixels) -> String {
    let WrongPixels { wrong, of } = pixels;
    let share = lang.mark().number(100.0 * pixels.share(), 3);
    let count = both!(lang; "{share} % of the compared pixels ({wrong} of {of})",
        "{share} % dos pixels comparados ({wrong} de {of})");
    match cause {
        Cause::WrongOrder => both!(lang;
            "{count} show a farther face in front of a nearer one, because faces are painted in the order of their centroids.",
            "{count} mostram uma face mais distante na frente de uma mais próxima, porque as faces são pintadas na ordem de seus centroides."),
        Cause::ShadowAcne => both!(lang;
            "{count} that face a light lie in their own shadow (shadow acne). The bias of the shadow map is too small.",
            "{count} voltados para uma luz estão em sua própria sombra (acne de sombras). O bias do mapa de sombras é pequeno demais."),
        Cause::ShadowDetached => both!(lang;
            "{count} that face a light are lit although something blocks it: the shadow is detached from its object. The bias of the shadow map is too large.",
            "{count} voltados para uma luz estão iluminados, embora algo a bloqueie: a sombra se descola do objeto. O bias do mapa de sombras é grande demais."),
        Cause::AffineTexture => both!(lang;
            "{count} show the wrong part of a texture, because it is interpolated without w.",
            "{count} mostram a parte errada de uma textura, porque ela é interpolada sem w."),
        _ => both!(lang;
            "{count} show a farther face in front of a nearer one, because the depth format can't tell their depths apart.",
            "{count} mostram uma face mais distante na frente de uma mais próxima, porque o formato de profundidade não distingue as duas."),
    }
}

/// Some names, and how many more.
fn listed(lang: Lang, names: &[String]) -> String {
    const MOST: usize = 4;
    let first = names.iter().take(MOST).map(String::as_str).collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(MOST) {
        0 => first,
        more => both!(lang; "{first} and {more} more", "{first} e mais {more}"),
    }
}

/// The reason why an object, or most of it, can't be seen.
fn not_seen(lang: Lang, cause: Cause, partly: bool, diagnosis: &Diagnosis) -> String {
    let most = if partly { pick!(lang; "most of it is ", "a maior parte está ") } else { "" };
    let percent = lang.mark().number(100.0 * diagnosis.covered, 2);
    match cause {
        Cause::CameraInsideObject => both!(lang; "the camera is inside it, and all its faces are turned away.",
            "a câmera está dentro dele e vê todas as faces por trás."),
        Cause::BehindCamera => both!(lang; "{most}behind the camera, z_c ≥ 0 (5.7): the camera looks the other way.",
            "{most}atrás da câmera, z_c ≥ 0 (5.7): ela olha para o outro lado."),
        Cause::BeforeNear => {
            both!(lang; "{most}nearer than the front plane, −z_c < F: clipping removes what is there.",
            "{most}mais perto que o plano da frente, −z_c < F: o recorte elimina o que está ali.")
        }
        Cause::BeyondFar => both!(lang; "{most}farther than the back plane, −z_c > B: clipping removes what is there.",
            "{most}mais longe que o plano de fundo, −z_c > B: o recorte elimina o que está ali."),
        Cause::OutsideLeft => both!(lang; "{most}to the left of the view window, x_p < l (5.9).",
            "{most}à esquerda da janela de vista, x_p < l (5.9)."),
        Cause::OutsideRight => both!(lang; "{most}to the right of the view window, x_p > r (5.9).",
            "{most}à direita da janela de vista, x_p > r (5.9)."),
        Cause::OutsideTop => both!(lang; "{most}above the view window, y_p > t (5.10).",
            "{most}acima da janela de vista, y_p > t (5.10)."),
        Cause::OutsideBottom => both!(lang; "{most}below the view window, y_p < b (5.10).",
            "{most}abaixo da janela de vista, y_p < b (5.10)."),
        Cause::SmallerThanPixel => both!(lang; "smaller in the image than a pixel (5.22).",
            "menor na imagem que um pixel (5.22)."),
        Cause::FullyTransparent => both!(lang; "its colour has alpha 0: what is behind it shows through completely.",
            "a cor tem alfa 0: vê-se tudo o que está atrás."),
        Cause::HiddenByNearCut => {
            both!(lang; "the front plane, −z_c = F, cuts its front away, and its inside is seen.",
            "o plano da frente, −z_c = F, corta a frente fora, e vê-se o interior.")
        }
        Cause::FewPixels => both!(lang; "visible, but on only {percent} % of the image.",
            "visível, mas em só {percent} % da imagem."),
        // The others have sentences of their own.
        _ => String::new(),
    }
}

/// The changes of a repair: keys of the figure file with their new values.
pub fn changes(changes: &[(&'static str, Value)]) -> String {
    let n = |x: f64| significant(x, 6);
    let of = |(key, value): &(&'static str, Value)| match value {
        Value::Number(x) => format!("{key} = {}", n(*x)),
        Value::Vector(v) => format!("{key} = [{}, {}, {}]", n(v.x), n(v.y), n(v.z)),
        Value::Window(w) => {
            format!("{key} = [{}, {}] × [{}, {}]", n(w.left), n(w.right), n(w.bottom), n(w.top))
        }
        Value::Word(word) => format!("{key} = {word}"),
        Value::Absent => format!("{key} = –"),
    };
    changes.iter().map(of).collect::<Vec<_>>().join(", ")
}

/// The changes of a repair as in the panels: the notes' symbols, with the decimal mark of the language.
pub fn changes_in_symbols(lang: Lang, changes: &[(&'static str, Value)]) -> String {
    let n = |x: f64| lang.mark().number(x, 4);
    let mark = lang.mark();
    let symbol = |key: &'static str| match key {
        "position" => "C",
        "focal_point" => "PF",
        "view_up" => "VUP",
        "view_angle" => "θ",
        "height" => "H",
        "aspect" => "A",
        "near" => "F",
        "far" => "B",
        "shading" => crate::i18n::window::texts(lang).shading,
        "visibility" => crate::i18n::window::texts(lang).visibility,
        "depth_format" => texts(lang).format,
        "scene.lights.shadow_bias" => texts(lang).shadow_bias,
        key => key,
    };
    let of = |(key, value): &(&'static str, Value)| match value {
        Value::Number(x) if *key == "view_angle" => format!("θ = {}°", n(*x)),
        Value::Number(x) => format!("{} = {}", symbol(key), n(*x)),
        Value::Vector(v) => format!("{} = {}", symbol(key), mark.tuple(&v.to_array(), 4)),
        Value::Window(w) => format!("l = {}, r = {}, b = {}, t = {}", n(w.left), n(w.right), n(w.bottom), n(w.top)),
        Value::Word(word) => format!("{}: {}", symbol(key), style_word(lang, word)),
        Value::Absent => format!("{}: –", symbol(key)),
    };
    changes.iter().map(of).collect::<Vec<_>>().join(" · ")
}

/// A word of `[style]` as in the panels.
fn style_word(lang: Lang, word: &'static str) -> &'static str {
    let t = crate::i18n::window::texts(lang);
    match word {
        "wireframe" => t.shading_wireframe,
        "flat" => t.shading_flat,
        "depth-buffer" => t.visibility_depth_buffer,
        "bsp" => t.visibility_bsp,
        word => word,
    }
}

/// The share of the image that the scene covers.
pub fn seen(lang: Lang, visible: u64, covered: f64) -> String {
    let share = lang.mark().number(100.0 * covered, 3);
    both!(lang; "The scene covers {visible} pixels of the image, {share} %.",
        "A cena cobre {visible} pixels da imagem, {share} %.")
}
