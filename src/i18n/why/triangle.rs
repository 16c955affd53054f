//! One triangle step by step, among the explanations.

use crate::figure::TriangleStep;

texts! {
    heading: "One triangle, step by step", "Um triângulo, passo a passo";
    hint: "Click a triangle in the image, or choose an object and a number.", "Clique num triângulo na imagem, ou escolha um objeto e um número.";
    object: "Object", "Objeto";
    number: "Triangle, by its number in the mesh", "Triângulo, pelo seu número na malha";
    of: "of", "de";
    release: "Release the triangle (Esc)", "Soltar o triângulo (Esc)";
    next: "Next step", "Próximo passo";
    previous: "Previous step", "Passo anterior";
    step_view: "local → world → view", "local → mundo → vista";
    step_facing: "front or back", "frente ou costas";
    step_outcodes: "clip coordinates, outcodes", "coordenadas de recorte, outcodes";
    step_cuts: "cuts", "cortes";
    step_divide: "÷ w", "÷ w";
    step_viewport: "viewport", "viewport";
    step_pixels: "pixels", "pixels";
    step_depth: "depth test", "teste de profundidade";
    local: "local", "local";
    world: "world", "mundo";
    view: "view", "vista";
    is_front: "N · (C − a) > 0, so you see its front", "N · (C − a) > 0, e vê-se a frente";
    is_back: "N · (C − a) ≤ 0, so it faces away. It's culled if the object is closed or one-sided", "N · (C − a) ≤ 0, e está de costas. É descartado se o objeto é fechado ou de um lado só";
    inside: "inside all planes: 000000", "dentro de todos os planos: 000000";
    outside: "outside:", "fora:";
    all_outside: "All vertices are outside one plane, so the triangle is dropped whole, without a cut.", "Todos os vértices estão fora de um mesmo plano, e ele é descartado inteiro, sem corte.";
    no_cut: "No vertex is outside any plane, so nothing is cut.", "Nenhum vértice está fora de algum plano, e nada é cortado.";
    left: "remaining:", "resta:";
    nothing_left: "nothing remains", "nada resta";
    covers: "pixels covered", "pixels cobertos";
    rows: "rows", "linhas";
    too_large: "Nothing to show. The object isn't drawn, or the image is larger than 4 million pixels.", "Nada a mostrar. O objeto não é desenhado, ou a imagem tem mais de 4 milhões de pixels.";
    being_found: "Its pixels are being found…", "Os seus pixels estão sendo determinados…";
    covers_none: "It covers the centre of no pixel.", "Não cobre o centro de nenhum pixel.";
    pixel: "pixel (i, j), from the top left", "pixel (i, j), do canto superior esquerdo";
    pixel_hint: "Type it, or click a pixel of the triangle in the image", "Digite-o, ou clique num pixel do triângulo na imagem";
    not_covered: "The triangle does not cover this pixel.", "O triângulo não cobre este pixel.";
    z_own: "Z of the triangle (5.25)", "Z do triângulo (5.25)";
    z_before: "Z that was there", "Z que estava ali";
    z_nothing: "nothing was there", "nada estava ali";
    kept: "nearer, so it's kept and the buffer now holds its Z", "mais perto, e é mantido. O buffer agora guarda o Z dele";
    rejected: "not nearer, so it's discarded and the buffer stays", "não está mais perto, e é descartado. O buffer fica como está";
    before_hint: "Other objects, and other triangles of its own object, are drawn before it.", "Antes dele são desenhados outros objetos, e outros triângulos do próprio objeto.";
}

/// The name of a step.
pub const fn step(t: &Texts, step: TriangleStep) -> &'static str {
    match step {
        TriangleStep::View => t.step_view,
        TriangleStep::Facing => t.step_facing,
        TriangleStep::Outcodes => t.step_outcodes,
        TriangleStep::Cuts => t.step_cuts,
        TriangleStep::Divide => t.step_divide,
        TriangleStep::Viewport => t.step_viewport,
        TriangleStep::Pixels => t.step_pixels,
        TriangleStep::Depth => t.step_depth,
    }
}
