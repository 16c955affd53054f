//! Stages and hidden surfaces.

use crate::stage::{Stage, WorksOn};

texts! {
    in_the_code: "In the code", "No código";
    in_the_code_hint: "The source file of this stage, in the project's folder. Its head explains the algorithm", "O arquivo-fonte desta etapa, na pasta do projeto. O começo dele explica o algoritmo";
    hint: "The image as painted so far, triangle by triangle, in the order of painting.", "A imagem pintada até aqui, triângulo por triângulo, na ordem de pintura.";
    hidden: "The image is hidden: Ctrl+3 shows it.", "A imagem está oculta: Ctrl+3 a mostra.";
    painter: "Painter", "Pintor";
    painter_hint: "From back to front by the distance of the centroid of each face", "De trás para a frente, pela distância do centroide de cada face";
    painter_said: "Each face is painted over those behind it. The order is that of their centroids. Faces that cross, or overlap in a cycle, have no right order.",
        "Cada face é pintada por cima das que estão atrás. A ordem é a dos centroides. Faces que se cruzam, ou se sobrepõem em ciclo, não têm ordem certa.";
    bsp: "BSP", "BSP";
    bsp_hint: "From back to front by a tree of planes that splits faces", "De trás para a frente por uma árvore de planos que divide faces";
    bsp_said: "A tree of planes sorts the faces and splits those that cross. The order from back to front is always right, and there are more triangles.",
        "Uma árvore de planos ordena as faces e divide as que se cruzam. A ordem de trás para a frente é sempre certa, e há mais triângulos.";
    depth_buffer: "Depth buffer", "Z-buffer";
    depth_buffer_hint: "In any order. Each pixel keeps the nearest", "Em qualquer ordem. Cada pixel guarda o mais próximo";
    depth_buffer_said: "The order doesn't matter. A pixel is painted if its Z (5.25) is less than the stored one. Show Z to watch it fill.",
        "A ordem não importa. Um pixel é pintado se o Z dele (5.25) é menor que o guardado. Mostre Z para vê-lo encher.";
    depth: "Show Z, the depth buffer", "Mostrar Z, o z-buffer";
    depth_hint: "[reveal] depth: grey from 0 at the front to 1 at the back", "[reveal] depth: cinza de 0 na frente a 1 atrás";
    scrubber: "How much is painted", "Quanto foi pintado";
    nothing: "Nothing yet", "Nada ainda";
    fewer: "Fewer triangles", "Menos triângulos";
    more: "More triangles", "Mais triângulos";
    all: "The whole image", "A imagem inteira";
    shown: "Shown in the view", "Na vista";
    none_shown: "A click on a stage, here or in the strip (F10), shows in the view what goes in and what comes out.", "Um clique numa etapa, aqui ou na faixa (F10), mostra na vista o que entra e o que sai.";
    show: "Click or press Enter to show it in the view, or to stop showing it. F1 opens its reference page", "Clique ou aperte Enter para mostrar na vista, ou deixar de mostrar. F1 abre o verbete";
    boxes: "The boxes around the objects. Those that are dropped are dashed.", "As caixas em volta dos objetos. As descartadas são tracejadas.";
    normals: "The normal at each vertex, as it is in the world.", "A normal em cada vértice, como é no mundo.";
    vertices: "The numbers at vertices: before → after.", "Os números nos vértices: antes → depois.";
    faces: "The dropped faces are tinted. The lines show the triangles that remain.", "As faces descartadas são tingidas. As linhas são os triângulos que restam.";
    pieces: "Triangles that cross a plane are dashed. The lines show the pieces that remain, with the new vertices marked. Parts outside are tinted in the world.",
        "Os triângulos que cruzam um plano são tracejados. As linhas são os pedaços que restam, com os vértices novos marcados. As partes de fora são tingidas no mundo.";
    halves: "The left half shows the input, the right half the output.", "A metade esquerda mostra a entrada, a direita a saída.";
    strip: "Also under the views (F10), with counts and times", "Também sob as vistas (F10), com contagens e tempos";
    strip_hint: "The strip under the views shows the input, the output and the time of each stage", "A faixa sob as vistas mostra a entrada, a saída e o tempo de cada etapa";
}

/// The display of a stage in a picture.
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
