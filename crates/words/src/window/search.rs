//! The words of the search for anything in the window, and the comparison of words: without accents and capitals, and
//! with the other names of the field.

texts!("window/search");

/// Groups of names for one thing, without accents: those of the notes, of other books and of libraries, in both
/// languages. If you type one of them, you also find the others.
const SYNONYMS: &[&[&str]] = &[
    &[
        "fov",
        "fovy",
        "field of view",
        "view angle",
        "abertura",
        "campo de visao",
        "angulo de vista",
        "focal length",
        "distancia focal",
        "θ",
        "theta",
    ],
    &["frustum", "tronco", "view volume", "volume de vista", "viewing volume", "piramide de visao"],
    &["near", "near plane", "front plane", "plano da frente", "znear", "plano proximo", "hither"],
    &["far", "far plane", "back plane", "plano de fundo", "zfar", "plano distante", "yon"],
    &["eye", "olho", "camera position", "position", "posicao", "centre of projection", "center of projection", "cop"],
    &["lookat", "target", "focal point", "ponto focal", "alvo", "at"],
    &["up", "up vector", "view up", "vup", "para cima"],
    &["lookat", "glulookat", "view matrix", "matriz de vista", "m_v", "other libraries", "outras bibliotecas"],
    &["gluperspective", "glfrustum", "projection matrix", "matriz de projecao", "m_p"],
    &["z-buffer", "zbuffer", "depth buffer", "buffer de profundidade", "depth test"],
    &["zfighting", "z fighting", "z-fighting", "stitching", "depth precision", "precisao de profundidade"],
    &["painter", "pintor", "painter's algorithm", "algoritmo do pintor", "depth sort"],
    &["bsp", "binary space partition", "particao binaria"],
    &["backface", "back face", "back-face", "culling", "culled", "descartadas", "faces de tras", "turned away"],
    &[
        "hidden surfaces",
        "hidden surface removal",
        "visibility",
        "faces ocultas",
        "superficies ocultas",
        "visibilidade",
    ],
    &["clipping", "clip", "recorte", "cohen", "sutherland", "outcode"],
    &["perspective division", "perspective divide", "dividing by w", "dividir por w", "divisao perspectiva"],
    &[
        "homogeneous",
        "homogeneas",
        "coordenadas homogeneas",
        "homogeneous coordinates",
        "dividing by w",
        "dividir por w",
    ],
    &["ndc", "canonical", "canonical volume", "volume canonico", "normalized device", "normalised device", "cubo"],
    &[
        "frustum to cube",
        "tronco ao cubo",
        "frustum → cube",
        "tronco → cubo",
        "normalization",
        "normalizacao",
        "animation",
    ],
    &["direct3d", "directx", "d3d", "opengl", "vulkan", "metal", "webgpu", "conventions", "convencoes"],
    &[
        "three.js",
        "threejs",
        "vtk",
        "glm",
        "unity",
        "blender",
        "quaternion",
        "quaternio",
        "other libraries",
        "outras bibliotecas",
    ],
    &["code", "codigo", "other libraries", "outras bibliotecas"],
    &[
        "intrinsics",
        "k[r|t]",
        "calibration",
        "calibracao",
        "opencv",
        "computer vision",
        "visao computacional",
        "other libraries",
        "outras bibliotecas",
    ],
    &["presentation", "fullscreen", "full screen", "projector", "tela cheia", "apresentacao", "projetor"],
    &["orthographic", "ortografica", "orthogonal", "parallel", "paralela"],
    &["rasterization", "rasterizacao", "scanline", "stages", "etapas", "pipeline"],
    &["aspect ratio", "razao de aspecto", "aspect", "aspecto"],
    &["dark mode", "modo escuro", "night mode", "modo noturno", "dark theme", "tema escuro"],
    &["title", "titulo", "caption", "legenda", "heading", "cabecalho"],
    &["pdf", "svg", "tex", "webp", "transparent", "transparente", "export", "exportar"],
    &[
        "run time",
        "runtime",
        "tempo de execucao",
        "benchmark",
        "numerics",
        "numerica",
        "error against run time",
        "erro por tempo",
    ],
    &["empty image", "empty", "black image", "imagem vazia", "imagem preta", "camera check", "diagnostico da camera"],
    &["compare cameras", "comparar cameras", "two cameras", "duas cameras", "compare", "comparar"],
    &[
        "parallax",
        "paralaxe",
        "stereo",
        "estereo",
        "stereo pair",
        "par estereo",
        "anaglyph",
        "anaglifo",
        "left eye",
        "olho esquerdo",
    ],
    &["smooth shading", "flat shading", "shading", "sombreamento", "tonalizacao"],
    &["predict", "prever", "prediction", "previsao", "predict first", "prever antes"],
    &["ghost", "fantasma", "keep in the figure", "guardar na figura"],
    &["antialias", "antialiasing", "anti-aliasing", "samples", "amostras", "serrilhado"],
    &["rotate", "orbit", "girar", "orbitar", "azimuth", "azimute"],
    &["tilt", "inclinar", "roll", "rolagem"],
    &["screenshot", "print", "imprimir", "export", "exportar", "png"],
    &["poll", "vote", "votacao", "clicker", "hands", "question of the step", "pergunta do passo"],
    &[
        "handout",
        "worksheet",
        "print",
        "imprimir",
        "material impresso",
        "exercise sheet",
        "folha de exercicios",
        "lista de exercicios",
    ],
    &["share", "compartilhar", "link", "copy link"],
    &["html", "web", "browser", "navegador", "the page for your students", "a pagina para seus alunos"],
    &["scorm", "moodle", "canvas", "for the course platform", "para a plataforma do curso"],
    &["weak projector", "projetor fraco", "strong contrast", "contraste forte"],
    &["shortcut", "shortcuts", "atalho", "atalhos", "keyboard", "teclado", "keys"],
    &["study", "studies", "estudo", "estudos", "numerics", "numerica", "error against run time", "erro por tempo"],
    &["students", "alunos", "estudantes", "a class", "uma turma", "my class", "minha turma", "report", "relatorio"],
    &["progress", "progresso", "export progress", "exportar progresso", "exercises", "exercicios"],
    &["import", "importar", "gltf", "glb", "obj", "stl", "ply", "mesh file", "arquivo de malha", "open", "abrir"],
    &["frame", "enquadrar", "fit the image", "ajustar a imagem", "aim at it", "mirar nele"],
    &["look at", "olhar para", "center", "centre", "centralizar", "aim", "mirar", "aim at it", "mirar nele"],
    &[
        "font",
        "font size",
        "fonte",
        "tamanho da letra",
        "large type",
        "letras grandes",
        "larger interface",
        "interface maior",
    ],
    &["hide labels", "ocultar rotulos", "esconder rotulos", "labels", "rotulos"],
    &["distortion", "distorcao", "undistorted", "sem distorcao", "aspect", "aspecto"],
    &["quiz", "test", "prova", "exercise", "exercicio", "exercises", "exercicios"],
];

/// A text without accents and capitals.
pub fn folded(text: &str) -> String {
    let plain = |c| match c {
        'á' | 'à' | 'â' | 'ã' => 'a',
        'é' | 'ê' => 'e',
        'í' => 'i',
        'ó' | 'ô' | 'õ' => 'o',
        'ú' | 'ü' => 'u',
        'ç' => 'c',
        c => c,
    };
    text.to_lowercase().chars().map(plain).collect()
}

/// True if a folded text has all words of `wanted`, ignoring accents and case. Without words, it does.
pub fn has_words(text: &str, wanted: &str) -> bool {
    folded(wanted).split_whitespace().all(|word| text.contains(word))
}

/// The typed words, folded, and the same in the other names of the field.
pub fn also_called(wanted: &str) -> Vec<String> {
    let wanted = folded(wanted).split_whitespace().collect::<Vec<_>>().join(" ");
    let mut all = vec![wanted.clone()];
    let is_whole = SYNONYMS.iter().any(|group| group.contains(&wanted.as_str()));
    for group in SYNONYMS {
        // A name that the user is still typing counts from its third letter on, unless it's another whole name.
        let is_meant = |name: &&&str| wanted == **name || !is_whole && wanted.len() >= 3 && name.starts_with(&wanted);
        let inside = group.iter().find(|name| name.len() > 2 && format!(" {wanted} ").contains(&format!(" {name} ")));
        let Some(name) = group.iter().find(is_meant).or(inside) else { continue };
        for other in group.iter().filter(|other| *other != name) {
            let is_part = wanted.contains(name);
            let replaced = is_part.then(|| wanted.replace(name, other));
            // Among other words, for example “save as pdf”, the other name alone counts too, if it's no short word that
            // many texts have in them, and the words together are no name themselves.
            let alone = (wanted == **name || !is_part || !is_whole && other.len() > 4).then(|| (*other).to_owned());
            for said in replaced.into_iter().chain(alone) {
                if !all.contains(&said) {
                    all.push(said);
                }
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_other_books_are_found() {
        for (typed, other) in [
            ("FOV", "view angle"),
            ("ângulo de vista", "abertura"),
            ("near plane", "plano da frente"),
            ("gluLook", "view matrix"),
            ("z-fighting", "z fighting"),
            ("tamanho da letra", "interface maior"),
            ("hide labels", "rotulos"),
            ("distorção", "undistorted"),
        ] {
            assert!(also_called(typed).iter().any(|said| said == other), "{typed}: {:?}", also_called(typed));
        }
        assert_eq!(also_called("xyzzy"), ["xyzzy"]);
        assert_eq!(also_called("re"), ["re"]);
    }

    #[test]
    fn synonyms_are_folded() {
        for name in SYNONYMS.iter().flat_map(|group| *group) {
            assert_eq!(folded(name), *name);
        }
    }
}
