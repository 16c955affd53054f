//! The explanation of w.

texts! {
    plane_title: "Points in xᵣ and wᵣ", "Pontos em xᵣ e wᵣ";
    plane_hint: "Every point of clip space seen from the side. The line from the origin through a point meets w = 1 at its xₙ, which is the division by w (5.6). The inside is |xᵣ| ≤ wᵣ. Below w = 0, behind the eye, the line meets w = 1 on the other side, so such a point would be flipped. On w = 0 it never meets it. That's an ideal point.",
        "Cada ponto do espaço de recorte visto de lado. A reta da origem por um ponto encontra w = 1 em seu xₙ, o que é a divisão por w (5.6). O interior é |xᵣ| ≤ wᵣ. Abaixo de w = 0, atrás do olho, a reta encontra w = 1 do outro lado, e tal ponto seria virado. Em w = 0 ela nunca a encontra. Esse é um ponto ideal.";
    plane_parallel: "In parallel projection every w is 1, so nothing is divided.", "Em projeção paralela todo w é 1, e nada é dividido.";
    inside: "inside", "dentro";
    behind: "behind the eye", "atrás do olho";
    ideal: "ideal", "ideal";
    turned_over: "flipped", "virado";
    no_points: "The corners of the volume at half its height. Points of the figure replace them.", "Os cantos do volume a meia altura. Pontos da figura os substituem.";
    middle_title: "The middle does not stay in the middle", "O meio não fica no meio";
    middle_hint: "A segment in the world above, its image below. The division by w isn't affine. A point at t along the segment is seen at s along its image.",
        "Um segmento no mundo em cima, sua imagem embaixo. A divisão por w não é afim. Um ponto em t ao longo do segmento é visto em s ao longo da imagem.";
    world: "world", "mundo";
    image: "image", "imagem";
    share: "t along the segment", "t ao longo do segmento";
    share_hint: "Which point of the segment", "Qual ponto do segmento";
    behind_middle: "One end is behind the eye, or in its plane, so the segment as a whole has no image.", "Uma ponta está atrás do olho, ou em seu plano, e o segmento não tem imagem inteira.";
    floor_title: "A chequered floor", "Um piso xadrez";
    floor_hint: "The floor around PF, seen by this camera. On the left, u and v are interpolated in the image as if nothing had been divided (affine), and each triangle is distorted on its own. On the right, u/w, v/w and 1/w are interpolated, as rasterizers do, and then divided.",
        "O piso em volta de PF, visto por esta câmera. À esquerda, u e v são interpolados na imagem como se nada tivesse sido dividido (afim), e cada triângulo se deforma por si. À direita, u/w, v/w e 1/w são interpolados, como fazem os rasterizadores, e então divididos.";
    affine: "affine: wrong", "afim: errado";
    correct: "with w: right", "com w: certo";
    same: "In parallel projection both are the same.", "Em projeção paralela os dois são iguais.";
    vanishing: "Vanishing points in the views", "Pontos de fuga nas vistas";
}
