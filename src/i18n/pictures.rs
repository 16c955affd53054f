//! The words in the three pictures.

use super::{Lang, messages, told, window};
use crate::figure::{Bilingual, Figure};
use crate::i18n::why::pipeline;
use crate::i18n::window::{canvas, scenes};
use crate::picture::{Composite, Crowded, Metadata, NoAreas};
use crate::stage::Stage;
use crate::views::Labels;

/// The words of [`Labels`]: those that it consists of, and its other fields, made from the texts `t`.
macro_rules! words {
    (
        labels { $($label:ident: $label_en:literal, $label_pt:literal;)* }
        parts { $($part:ident: $part_en:literal, $part_pt:literal;)* }
        of($t:ident, $style:ident, $scene:ident) { $($field:ident: $value:expr,)* }
    ) => {
        texts! {
            $($label: $label_en, $label_pt;)*
            $($part: $part_en, $part_pt;)*
        }

        const fn of($t: &Texts) -> Labels {
            let ($style, $scene) = (window::texts($t.lang), scenes::texts($t.lang));
            Labels { $($label: $t.$label,)* $($field: $value,)* }
        }
    };
}

words! {
    labels {
        window: "window", "janela";
        near: "near", "frente";
        far: "far", "fundo";
        scene: "scene", "cena";
        vertex: "vertex", "vértice";
        point: "point", "ponto";
        before: "before", "antes";
        answered: "your answer", "sua resposta";
        depth_stored: "depth buffer: Z (5.25)", "z-buffer: Z (5.25)";
        depth_linear: "distance from the eye", "distância ao olho";
        depth_of_light: "shadow map, distance from the light", "mapa de sombras, distância à luz";
        acne: "shadows without bias: faces shadow themselves", "sombras sem bias: as faces sombreiam a si mesmas";
        map_wrong: "the shadow map is wrong at", "o mapa de sombras erra em";
        out_of: "of", "de";
        too_much_for_rays: "too much for rays; allowed: 4 million pixels and 2 million triangles", "demais para raios; permitido: 4 milhões de pixels e 2 milhões de triângulos";
        nothing: "nothing here", "nada aqui";
        outside: "outside the volume", "fora do volume";
        cuts: "made by clipping", "criado pelo recorte";
        back_faces: "back faces: culled", "faces de trás: descartadas";
        dropped: "outside: dropped whole", "fora: descartado inteiro";
        outside_of: "outside", "fora";
        no_stage: "no stage", "nenhuma etapa";
        with_w: "u, v interpolated with w", "u, v interpolados com w";
        affine: "u, v interpolated without w", "u, v interpolados sem w";
        levels: "level of detail", "nível de detalhe";
        texels: "nearest texel, with the grid of texels", "texel mais próximo, com a grade de texels";
        divided_first: "divided before clipping", "dividido antes do recorte";
        wrong: "wrong", "errado";
        no_difference: "nothing wrong inside the volume", "nada de errado dentro do volume";
        not_split: "too many pieces for BSP, so depth buffer instead", "pedaços demais para a BSP, usa o z-buffer";
        rounded: "vertices are off by rounding", "vértices deslocados pelo arredondamento";
        reversed: "reversed", "invertido";
        right_handed: "right-handed", "mão direita";
        left_handed: "left-handed", "mão esquerda";
        triangles: "triangles", "triângulos";
        goes_in: "goes in", "entra";
        comes_out: "comes out", "sai";
        not_all: "not all of it is shown", "nem tudo é mostrado";
        no_vanishing: "parallel: ideal points stay ideal, w = 0", "paralela: pontos ideais continuam ideais, w = 0";
        ideal: "ideal, parallel to the view plane", "ideal, paralela ao plano de vista";
        beyond_image: "outside the image", "fora da imagem";
        behind_eye: "behind the eye", "atrás do olho";
        horizon: "horizon", "horizonte";
        world: "world", "mundo";
        // The sides of a comparison.
        this_camera: "this camera", "esta câmera";
        other_camera: "camera A", "câmera A";
        differ: "pixels that differ", "pixels que diferem";
        step_number: "step", "passo";
        samples: "samples per pixel", "amostras por pixel";
    }
    parts {
        // The planes that an object can be outside of.
        plane_left: "left", "esquerda";
        plane_right: "right", "direita";
        plane_bottom: "bottom", "baixo";
        plane_top: "top", "topo";
        plane_near: "near", "frente";
        plane_far: "far", "fundo";
        single_precision: "in f32", "em f32";
        pan: "Pan", "Pan";
        section: "Section along u", "Corte ao longo de u";
        undistorted: "Undistorted", "Sem distorção";
        yes: "yes", "sim";
        no: "no", "não";
        fixed_16: "depth: 16 bits", "profundidade: 16 bits";
        fixed_24: "depth: 24 bits", "profundidade: 24 bits";
        float: "depth: f32 reversed", "profundidade: f32 invertido";
        // Parts of the world.
        part_grid: "grid", "grade";
        part_axes: "axes x, y, z", "eixos x, y, z";
        part_camera_body: "camera body", "câmera";
        part_volume: "view volume", "volume";
        part_window: "view window", "janela";
        part_ground_marks: "marks on the ground", "marcas no chão";
        part_names: "names", "nomes";
        hidden_dashed: "hidden lines: dashed", "linhas ocultas: tracejadas";
        hidden_hidden: "hidden lines: not drawn", "linhas ocultas: não desenhadas";
        hidden_shown: "hidden lines: drawn", "linhas ocultas: desenhadas";
        perspective: "perspective", "perspectiva";
        parallel: "parallel", "paralela";
        // The steps from the world to the canonical volume.
        to_eye: "T(−C): the eye moves to the origin", "T(−C): o olho vai à origem";
        turn: "R: u, v, n turn onto x, y, z (5.7)", "R: u, v, n giram sobre x, y, z (5.7)";
        turn_left_handed: "M_{rot} (1-3): u, v, DOP turn onto x, y, z", "M_rot (1-3): u, v, DOP giram sobre x, y, z";
        clip_rows: "M_p, rows x, y, z: clip coordinates (5.8), not yet divided", "M_p, linhas x, y, z: coordenadas de recorte (5.8), ainda sem dividir";
        divide: "÷ w_r (5.6): what is far becomes small", "÷ w_r (5.6): o que está longe fica pequeno";
        to_box: "P: the frustum becomes a box", "P: o tronco vira um paralelepípedo";
        centre: "T: the centre moves to the origin", "T: o centro vai à origem";
        scale: "S: the box becomes the cube, z is reversed", "S: o paralelepípedo vira o cubo, z se inverte";
        pers: "M_{pers}: depth, and division by −z", "M_{pers}: profundidade e divisão por −z";
        xy_scale: "M_{xyscale}: width and height become 2", "M_{xyscale}: largura e altura viram 2";
        unit_slope: "S_{xy} (1-10): the sides become x = ±z, y = ±z", "S_xy (1-10): os lados viram x = ±z, y = ±z";
        unit_depth: "S_z (1-12): the back plane moves to z = 1", "S_z (1-12): o plano de fundo vai a z = 1";
        canonical_box: "M_P (1-17), k = F/B: the frustum becomes the box", "M_P (1-17), k = F/B: o tronco vira o paralelepípedo";
        near_to_origin: "T_{ort} (1-7): the front plane moves to z = 0", "T_ort (1-7): o plano da frente vai a z = 0";
        scale_ort: "S_{ort} (1-7): the box becomes the canonical one", "S_ort (1-7): o paralelepípedo vira o canônico";
    }
    of(t, style, scene) {
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
        world_parts: [
            t.part_grid, t.part_axes, t.part_camera_body, "u, v, n", "VUP", "DOP", "PF", t.part_volume,
            t.part_window, t.part_ground_marks, t.part_names,
        ],
        yes_no: [t.yes, t.no],
        shadings: [style.shading_wireframe, style.shading_flat, style.shading_gouraud, style.shading_phong],
        visibilities: [style.visibility_depth_buffer, style.visibility_painter, style.visibility_bsp],
        hidden_lines: [t.hidden_dashed, t.hidden_hidden, t.hidden_shown],
        depth_formats: [t.fixed_16, t.fixed_24, t.float],
        projections: [t.perspective, t.parallel],
        stages: stages(t.lang),
        steps: [
            t.to_eye, t.turn, t.turn_left_handed, t.clip_rows, t.divide, t.to_box, t.centre, t.scale, t.pers,
            t.xy_scale, t.unit_slope, t.unit_depth, t.canonical_box, t.near_to_origin, t.scale_ort,
        ],
        planes: [t.plane_left, t.plane_right, t.plane_bottom, t.plane_top, t.plane_near, t.plane_far],
    }
}

static LABELS_EN: Labels = of(&EN);
static LABELS_PT_BR: Labels = of(&PT_BR);

/// The words of a language.
pub const fn labels(lang: Lang) -> &'static Labels {
    pick!(lang; &LABELS_EN, &LABELS_PT_BR)
}

/// Three pictures with less room on their paper than their letters need.
pub fn crowded(lang: Lang, crowded: &Crowded) -> String {
    let Crowded { smallest, wanted, room } = crowded;
    let number = |value: &f64| lang.mark().printed(&format!("{value:.1}"));
    let size = |size: &[f64; 2]| format!("{} × {} cm", number(&size[0]), number(&size[1]));
    let (smallest, room) = (size(smallest), size(room));
    let wanted = lang.mark().number(*wanted, 3);
    both!(lang; "the smallest image is {smallest}; letters of {wanted} pt need images of at least {room}, so some names may be missing",
        "a menor imagem tem {smallest}; letras de {wanted} pt pedem imagens de pelo menos {room}, por isso podem faltar nomes")
}

/// Letters that are too small on paper.
pub fn tiny_letters(lang: Lang, points: f64) -> String {
    let points = lang.mark().printed(&format!("{points:.1}"));
    both!(lang; "its letters are {points} pt high on paper; to be legible: at least 6 pt (--letters)",
        "suas letras têm {points} pt de altura no papel; para serem lidas: ao menos 6 pt (--letters)")
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
        |text: &Option<Bilingual>| text.as_ref().map(|text| told(lang, text).to_owned()).filter(|t| !t.is_empty());
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
        NoAreas::Shaded => both!(lang;
            "the faces are an image: their colours vary over a face (Gouraud, Phong, textures, shadows); allowed for areas: shading = \"flat\", without shadows, or \"wireframe\"",
            "as faces são uma imagem: suas cores variam sobre uma face (Gouraud, Phong, texturas, sombras); permitido para áreas: shading = \"flat\", sem sombras, ou \"wireframe\""),
        NoAreas::Partial => both!(lang;
            "the faces are an image: the first of them are shown in the order of the depth buffer; allowed for areas: visibility = \"painter\" or \"bsp\", or without show.painted",
            "as faces são uma imagem: as primeiras delas aparecem na ordem do z-buffer; permitido para áreas: visibility = \"painter\" ou \"bsp\", ou sem show.painted"),
        NoAreas::OverBudget(over) => both!(lang; "the faces are an image: {}",
            "as faces são uma imagem: {}"; messages::over_budget(lang, over)),
    }
}
