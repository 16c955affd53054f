//! The tab of stages.

use crate::stage::{Stage, WorksOn};

texts! {
    hint: "The image as far as it is painted: triangle by triangle, in the order in which they are painted.", "A imagem até onde foi pintada: triângulo por triângulo, na ordem em que são pintados.";
    hidden: "The image is hidden: Ctrl+3 shows it.", "A imagem está oculta: Ctrl+3 a mostra.";
    painter: "Painter", "Pintor";
    painter_hint: "From back to front by the distance of the middle of each face", "De trás para a frente, pela distância do meio de cada face";
    painter_said: "Each face is painted over those behind it. The order is that of their middles: faces that cross, or that lie over one another in a ring, have no right order.",
        "Cada face é pintada por cima das que estão atrás. A ordem é a dos seus meios: faces que se cruzam, ou que se cobrem em círculo, não têm ordem certa.";
    bsp: "BSP", "BSP";
    bsp_hint: "From back to front by a tree of planes that cuts faces apart", "De trás para a frente por uma árvore de planos que corta faces";
    bsp_said: "A tree of planes puts the faces into the order, cut where they cross: from back to front it is always right, and has more triangles.",
        "Uma árvore de planos ordena as faces, cortadas onde se cruzam: de trás para a frente está sempre certa, e há mais triângulos.";
    depth_buffer: "Depth buffer", "Buffer de profundidade";
    depth_buffer_hint: "In any order; each pixel keeps what is nearest", "Em qualquer ordem; cada pixel guarda o que está mais perto";
    depth_buffer_said: "The order does not matter: a pixel is painted where Z (5.25) is less than what the buffer holds there. Show Z to watch it fill.",
        "A ordem não importa: um pixel é pintado onde Z (5.25) é menor que o que o buffer guarda ali. Mostre Z para vê-lo encher.";
    depth: "Show Z, the depth buffer", "Mostrar Z, o buffer de profundidade";
    depth_hint: "[reveal] depth: grey from 0 at the front to 1 at the back", "[reveal] depth: cinza de 0 na frente a 1 atrás";
    scrubber: "How much is painted", "Quanto foi pintado";
    nothing: "Nothing yet", "Nada ainda";
    fewer: "Fewer triangles", "Menos triângulos";
    more: "More triangles", "Mais triângulos";
    all: "The whole image", "A imagem inteira";
    shown: "Shown in the picture", "Na imagem";
    none_shown: "A click on a stage, here or in the strip (F10), shows in the picture what goes in and what comes out.", "Um clique numa etapa, aqui ou na faixa (F10), mostra na imagem o que entra e o que sai.";
    show: "Click, Enter: show it in the picture, or no more · F1: the note on it", "Clique, Enter: mostrar na imagem, ou não mais · F1: a nota sobre ela";
    boxes: "The boxes around the objects: dashed those that are dropped.", "As caixas em volta dos objetos: tracejadas as que são descartadas.";
    normals: "At each vertex its normal, as it is in the world.", "Em cada vértice a sua normal, como está no mundo.";
    vertices: "At vertices their numbers: before → after.", "Nos vértices os seus números: antes → depois.";
    faces: "Tinted: the faces that are dropped. Lines: the triangles that are left.", "Tingidas: as faces descartadas. Linhas: os triângulos que ficam.";
    pieces: "Dashed: triangles that cross a plane. Lines: the pieces that are left of them; the new vertices are marked. What lies outside is tinted in the world.",
        "Tracejado: triângulos que cruzam um plano. Linhas: os pedaços que ficam; os vértices novos estão marcados. O que fica fora está tingido no mundo.";
    halves: "Left half: as it goes in. Right half: as it comes out.", "Metade esquerda: como entra. Metade direita: como sai.";
    order: "All stages, in their order", "Todas as etapas, na ordem";
}

/// How a stage shows in a picture.
#[must_use]
pub const fn in_and_out(t: &Texts, stage: Stage) -> &'static str {
    match stage.works_on() {
        WorksOn::Objects => t.boxes,
        WorksOn::Normals => t.normals,
        WorksOn::Vertices => t.vertices,
        WorksOn::Faces => t.faces,
        WorksOn::Pieces => t.pieces,
        WorksOn::Colors | WorksOn::Pixels => t.halves,
    }
}
