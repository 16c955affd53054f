//! The stages of the pipeline, and the reason why each runs or is skipped.

pub use super::reasons::{planes, reason};
use crate::i18n::Lang;
use crate::numbers;
use crate::pipeline::{Containment, FacesDone, ObjectReport, Reason, Stage, StageReport};
use crate::stage::Operations;

/// The name of a stage, short enough for a column.
pub const fn stage(lang: Lang, stage: Stage) -> &'static str {
    match stage {
        Stage::Traverse => pick!(lang; "traversal", "percurso"),
        Stage::CullObjects => pick!(lang; "trivial rejection", "rejeição trivial"),
        Stage::Normals => pick!(lang; "normals", "normais"),
        Stage::Light => pick!(lang; "lighting", "iluminação"),
        Stage::Transform => pick!(lang; "view transform", "transf. de vista"),
        Stage::CullFaces => pick!(lang; "back faces", "faces de trás"),
        Stage::Clip => pick!(lang; "clipping", "recorte"),
        Stage::Oblique => pick!(lang; "off-axis window", "janela fora do eixo"),
        Stage::Divide => pick!(lang; "divide by w", "divisão por w"),
        Stage::Viewport => "viewport",
        Stage::Fill => pick!(lang; "fill", "preenchimento"),
        Stage::Interpolate => pick!(lang; "interpolation", "interpolação"),
        Stage::HiddenSurfaces => pick!(lang; "hidden surfaces", "faces ocultas"),
        Stage::Texture => pick!(lang; "texture", "textura"),
        Stage::Shadow => pick!(lang; "shadow", "sombra"),
        Stage::Blend => pick!(lang; "blending", "mistura"),
        Stage::Antialias => "antialiasing",
        Stage::Lines => pick!(lang; "lines and texts", "linhas e textos"),
        Stage::Write => pick!(lang; "write", "escrita"),
    }
}

/// The report of a stage: counts in and out, time, and reason. If it was skipped, the reason for that.
pub fn line(lang: Lang, report: &StageReport) -> String {
    let (name, reason) = (stage(lang, report.stage), reason(lang, report.reason));
    if !report.ran {
        return format!("{name}: {} – {reason}", left_out(lang));
    }
    let mut parts = Vec::new();
    if let Some((from, to)) = report.counts {
        let [from, to] = [from, to].map(numbers::in_threes);
        parts.push(format!("{from} → {to} {}", unit(lang, report)));
    }
    if let Some(time) = report.time {
        parts.push(lang.mark().printed(&numbers::duration(time)));
    }
    parts.push(reason);
    parts.extend(cost(lang, report));
    format!("{name}: {}", parts.join(" · "))
}

/// The operations of a stage in short. `None` if none were counted.
pub fn cost(lang: Lang, report: &StageReport) -> Option<String> {
    let Operations { float, integer, memory } = report.operations;
    let count = |n: u64| lang.mark().printed(&numbers::count(usize::try_from(n).unwrap_or(usize::MAX)));
    let [float_name, integer_name, memory_name] = pick!(lang; ["floating-point operations", "integer operations", "memory accesses"],
        ["operações de ponto flutuante", "operações inteiras", "acessos à memória"]);
    let counted = [(float, float_name), (integer, integer_name), (memory, memory_name)].into_iter();
    let said: Vec<String> = counted.filter(|(n, _)| *n > 0).map(|(n, name)| format!("{} {name}", count(n))).collect();
    (!said.is_empty()).then(|| said.join(", "))
}

/// The action of a stage, in a sentence, with the place in the notes.
pub const fn purpose(lang: Lang, stage: Stage) -> &'static str {
    match stage {
        Stage::Traverse => pick!(lang;
            "Walks through the tree of the scene, multiplies the transforms, and adds whatever else the view shows. [3] §1.1, step 1",
            "Percorre a árvore da cena, multiplica as transformações e acrescenta o que a vista mostra além dela. [3] §1.1, passo 1"),
        Stage::CullObjects => pick!(lang;
            "Drops objects whose bounding box is outside one plane of the view volume. [3] §1.1",
            "Descarta os objetos cuja caixa envolvente está fora de um plano do volume de vista. [3] §1.1"),
        Stage::Normals => pick!(lang;
            "Transforms the normals of vertices to view space, for lighting. [3] §1.1, step 2",
            "Leva as normais dos vértices ao espaço de vista, para a iluminação. [3] §1.1, passo 2"),
        Stage::Light => pick!(lang;
            "The reflection model: ambient, diffuse and specular light. [2]; [3] §1.1, step 2",
            "O modelo de reflexão: luz ambiente, difusa e especular. [2]; [3] §1.1, passo 2"),
        Stage::Transform => pick!(lang; "World → view, each vertex of the faces once. [0] Eq. (5.7); [3] §1.1, step 3",
            "Mundo → vista, cada vértice das faces uma vez. [0] Eq. (5.7); [3] §1.1, passo 3"),
        Stage::CullFaces => pick!(lang; "Drops faces that are turned away from the eye. [3] §1.1, step 4",
            "Descarta as faces que dão as costas ao olho. [3] §1.1, passo 4"),
        Stage::Clip => pick!(lang; "Cuts what crosses a plane of the volume, before the divide. [2]; [3] §1.1, step 5",
            "Corta o que cruza um plano do volume, antes da divisão. [2]; [3] §1.1, passo 5"),
        Stage::Oblique => pick!(lang;
            "The terms (r + l)/(r − l) and (t + b)/(t − b) of an asymmetric window. [0] Eq. (5.13)",
            "Os termos (r + l)/(r − l) e (t + b)/(t − b) de uma janela assimétrica. [0] Eq. (5.13)"),
        Stage::Divide => pick!(lang; "Clip → NDC: x, y and z are divided by w. [0] §5.4; [3] §1.1, step 5",
            "Recorte → NDC: x, y e z são divididos por w. [0] §5.4; [3] §1.1, passo 5"),
        Stage::Viewport => pick!(lang; "NDC → pixels. [0] Eqs. (5.24), (5.25)",
            "NDC → pixels. [0] Eqs. (5.24), (5.25)"),
        Stage::Fill => pick!(lang; "Finds the pixels of each face. [3] §1.1, step 6",
            "Encontra os pixels de cada face. [3] §1.1, passo 6"),
        Stage::Interpolate => pick!(lang;
            "Colours or normals between the vertices of a face, perspective-correct. [2]; [3] §1.1, step 7",
            "Cores ou normais entre os vértices de uma face, com correção de perspectiva. [2]; [3] §1.1, passo 7"),
        Stage::HiddenSurfaces => pick!(lang; "Decides which face is seen at a pixel. [2]; [3] §1.1, step 8",
            "Decide qual face é vista em cada pixel. [2]; [3] §1.1, passo 8"),
        Stage::Texture => pick!(lang; "Images on surfaces. [3] §1.1, step 9",
            "Imagens sobre superfícies. [3] §1.1, passo 9"),
        Stage::Shadow => pick!(lang;
            "Removes the light from a point if the light sees something nearer in its depth image, the shadow map. [3] §1.1, step 9",
            "Retira luz se a fonte vê algo mais próximo em sua imagem de profundidades, o mapa de sombras. [3] §1.1, passo 9"),
        Stage::Blend => pick!(lang; "Blends translucent colours with what is behind them. [3] §1.1, step 9",
            "Mistura cores translúcidas com o que está atrás. [3] §1.1, passo 9"),
        Stage::Antialias => pick!(lang; "Takes several samples of each pixel and averages them. [3] §1.1, step 10",
            "Toma várias amostras de cada pixel e faz a média. [3] §1.1, passo 10"),
        Stage::Lines => pick!(lang;
            "Edges, outlines of curved solids, lines, marks and texts, over the finished surfaces.",
            "Arestas, contornos de sólidos curvos, linhas, marcas e textos, sobre as superfícies prontas."),
        Stage::Write => pick!(lang; "Colours go to the frame buffer. Only here is z dropped. [3] §1.1, step 11",
            "As cores vão para o frame buffer. Só aqui z é descartado. [3] §1.1, passo 11"),
    }
}

/// The unit of a stage's counts. A sample is a pixel if there is one for each.
pub const fn unit(lang: Lang, report: &StageReport) -> &'static str {
    let (en, pt_br) = match (report.stage, report.reason) {
        (Stage::Traverse | Stage::CullObjects, _) => ("objects", "objetos"),
        (Stage::Transform | Stage::Viewport | Stage::Divide | Stage::Oblique | Stage::Normals, _)
        | (Stage::Light, Reason::LitVertices { .. }) => ("vertices", "vértices"),
        (Stage::Fill, _) => ("triangles → samples", "triângulos → amostras"),
        (Stage::HiddenSurfaces, Reason::PaintedByCentroid | Reason::PaintedBySplitting | Reason::NoDepthBuffer) => {
            ("triangles → pieces", "triângulos → pedaços")
        }
        (
            Stage::CullFaces
            | Stage::Clip
            | Stage::Light
            | Stage::Interpolate
            | Stage::Texture
            | Stage::Shadow
            | Stage::Blend,
            _,
        ) => ("triangles", "triângulos"),
        (Stage::HiddenSurfaces, _) => ("samples", "amostras"),
        (Stage::Antialias, _) => ("samples → pixels", "amostras → pixels"),
        (Stage::Lines, _) => ("lines, marks, texts", "linhas, marcas, textos"),
        (Stage::Write, _) => ("pixels", "pixels"),
    };
    pick!(lang; en, pt_br)
}

/// "skipped": the mark of a stage that doesn't run.
pub const fn left_out(lang: Lang) -> &'static str {
    pick!(lang; "skipped", "omitida")
}

/// The treatment of an object, and the reason.
pub fn object(lang: Lang, report: &ObjectReport) -> String {
    let mut text = match report.containment {
        Containment::Empty => {
            return both!(lang; "has no vertices", "não tem vértices");
        }
        Containment::Outside(outside) => {
            let names = planes(lang, outside);
            return both!(lang; "outside: beyond {names}, dropped whole",
                "fora: além d{names}, descartado por inteiro");
        }
        Containment::Crosses(0) => both!(lang; "inside: not clipped", "dentro: sem recorte"),
        Containment::Crosses(crossed) => {
            let names = planes(lang, crossed);
            both!(lang; "may cross {names}: clipped there", "pode cruzar {names}: recortado ali")
        }
    };
    text += match report.faces {
        FacesDone::NotDrawn => pick!(lang; "; no faces", "; sem faces"),
        FacesDone::BackDropped => pick!(lang; "; back faces dropped", "; faces de trás descartadas"),
        FacesDone::BothSides => pick!(lang; "; both sides of its faces may be seen",
            "; os dois lados das faces podem ser vistos"),
        FacesDone::CutOpen => pick!(lang; "; the front plane cuts it open, so both sides of its faces may be seen",
            "; o plano da frente o abre, e os dois lados das faces podem ser vistos"),
    };
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_are_named_in_their_order() {
        assert_eq!(planes(Lang::En, 0b01_0001), "left and near");
        assert_eq!(planes(Lang::PtBr, 0b11_1110), "os planos da direita, de baixo, de cima, da frente e de fundo");
        assert_eq!(planes(Lang::PtBr, 0b01_0000), "o plano da frente");
        assert_eq!(planes(Lang::En, 0b10_0000), "far");
    }

    #[test]
    fn one_is_not_many() {
        assert_eq!(
            reason(Lang::En, Reason::Outside { outside: 1, of: 1 }),
            "1 of 1 object: all of the bounding box is outside one plane of the volume"
        );
        assert_eq!(reason(Lang::PtBr, Reason::LitFaces { objects: 2 }), "uma cor para cada face de 2 objetos");
    }

    #[test]
    fn stages_have_names_and_purposes_of_their_own() {
        for lang in [Lang::En, Lang::PtBr] {
            for texts in [Stage::ALL.map(|s| stage(lang, s)), Stage::ALL.map(|s| purpose(lang, s))] {
                let different: std::collections::BTreeSet<_> = texts.into_iter().collect();
                assert_eq!(different.len(), Stage::ALL.len());
            }
        }
    }
}
