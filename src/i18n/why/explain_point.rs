//! The tab that follows a point.

use crate::i18n::Lang;
use crate::numbers::significant;
use crate::sanitize::escaped;
use crate::views::{ShadowAt, TexelAt};

texts! {
    no_points: "No point is followed. Add one, or pin a vertex in a view and press Follow.", "Nenhum ponto é seguido. Adicione um, ou fixe um vértice em uma vista e aperte Seguir.";
    add: "Add", "Adicionar";
    add_hint: "Adds a point, at the vertex under the pointer or at PF, and follows it", "Adiciona um ponto, no vértice sob o ponteiro ou em PF, e o segue";
    delete: "Delete", "Excluir";
    delete_hint: "Deletes the followed point", "Exclui o ponto seguido";
    too_many: "You can't follow more points. There are 32 already.", "Não se podem seguir mais pontos. Já há 32.";
    name: "Name of the point", "Nome do ponto";
    name_hint: "As it is written in the views and in the figure file", "Como é escrito nas vistas e no arquivo da figura";
    name_taken: "Another point has this name.", "Outro ponto tem este nome.";
    name_empty: "A point needs a name.", "Um ponto precisa de um nome.";
    // On the card of the probe.
    follow: "Follow", "Seguir";
    follow_hint: "Follows this point through every space, in the explanations", "Segue este ponto por todos os espaços, nas explicações";
    // The spaces.
    local: "local", "local";
    world: "world", "mundo";
    view: "view", "vista";
    clip: "clip", "recorte";
    ndc: "NDC", "NDC";
    window: "window", "janela";
    pixel: "pixel", "pixel";
    viewport: "viewport", "viewport";
    homogeneous: "homogeneous", "homogêneas";
    typed_hint: "Type in any space, and the point moves to these coordinates", "Digite em qualquer espaço, e o ponto vai para essas coordenadas";
    local_of: "of the selected object", "do objeto selecionado";
    window_and_depth: "and the distance from the eye", "e a distância ao olho";
    pixel_and_depth: "and Z of the depth buffer", "e Z do z-buffer";
    no_image: "no image", "sem imagem";
    behind_pixel: "Beyond it lie the depths that the division gives to points behind the eye. Clipping stops those, so no pixel holds them. Type such a point in any other space, NDC included.",
        "Além dele estão as profundidades que a divisão dá a pontos atrás do olho. O recorte os detém, e nenhum pixel as guarda. Digite tal ponto em qualquer outro espaço, inclusive NDC.";
    // The arithmetic.
    forward: "Forward", "Ida";
    back: "Back", "Volta";
    from_pixel: "From the centre of the pixel with its Z. (5.22) has rounded away the position within the pixel, so the way back misses the point slightly:", "Do centro do pixel com seu Z. (5.22) arredondou a posição dentro do pixel, e a volta passa um pouco ao lado do ponto:";
    no_way_back: "There is no way back:", "Não há caminho de volta:";
    outside: "It's outside the volume, so clipping removes it and no pixel shows it.", "Está fora do volume. O recorte o retira, e nenhum pixel o mostra.";
    behind: "w < 0, so the point is behind the eye (w = −z_c). It has no image, because clipping stops it before the division. The numbers below are what the division would give. They belong to the point where the line through it and C meets the window, upside down and on the other side. On the way back from NDC, z_n tells it apart, because it lies beyond the limit of the depths in front of the eye.", "w < 0, e o ponto está atrás do olho (w = −z_c). Não tem imagem, pois o recorte o detém antes da divisão. Os números abaixo são os que a divisão daria. São do ponto em que a reta por ele e por C encontra a janela, de cabeça para baixo e do outro lado. De volta de NDC, z_n o distingue, pois está além do limite das profundidades à frente do olho.";
    in_plane: "w = 0, so the point is in the plane of the eye (z_c = 0). Its projector is parallel to the window and never meets it. (5.6) would divide by 0, and the way ends here. Such clip coordinates are a direction, a point at infinity.", "w = 0, e o ponto está no plano do olho (z_c = 0). O projetor dele é paralelo à janela e nunca a encontra. (5.6) dividiria por 0, e o caminho acaba aqui. Essas coordenadas de recorte são uma direção, um ponto no infinito.";
    copy_text: "Copy text", "Copiar texto";
    copy_latex: "Copy LaTeX", "Copiar LaTeX";
    copy_hint: "The whole way, forward and back", "O caminho inteiro, ida e volta";
    // In the pictures.
    drag_point: "drag it, and its distance from the eye stays the same", "arraste-o, e a distância ao olho continua a mesma";
}

/// The depths compared for the shadow at a point.
pub fn in_shadow(lang: Lang, at: &ShadowAt, digits: usize) -> String {
    let number = |value: f64| lang.mark().printed(&significant(value, digits));
    let (light, own, size, [i, j]) = (at.light + 1, number(at.own), at.size, at.texel);
    let Some(map) = at.nearest.map(number) else {
        return both!(lang; "Light {light}: depth {own}. Its map has nothing there, so it's lit",
            "Luz {light}: profundidade {own}. O mapa dela não tem nada ali, e fica iluminado");
    };
    let lit = match at.is_hidden() {
        true => pick!(lang; "so it's in the shadow", "e fica na sombra"),
        false => pick!(lang; "so it's lit", "e fica iluminado"),
    };
    both!(lang; "Light {light}: depth {own}. Its map has {map} there (texel {i}, {j} of {size}²), {lit}",
        "Luz {light}: profundidade {own}. O mapa dela tem {map} ali (texel {i}, {j} de {size}²), {lit}")
}

/// The place of a point in a texture.
pub fn on_texture(lang: Lang, at: &TexelAt, digits: usize) -> String {
    let number = |value: f64| lang.mark().printed(&significant(value, digits));
    let ([u, v], [i, j], [wide, high], object) = (at.uv.map(number), at.texel, at.size, escaped(&at.object));
    both!(lang; "On the texture of {object}: u = {u}, v = {v}; texel column {i}, row {j} of {wide} × {high}",
        "Na textura de {object}: u = {u}, v = {v}; texel da coluna {i}, linha {j}, de {wide} × {high}")
}

impl Texts {
    /// A space, by its name in `camera-lab inspect`.
    pub fn space(&self, name: &str) -> &'static str {
        match name {
            "local" => self.local,
            "world" => self.world,
            "view" => self.view,
            "clip" => self.clip,
            "ndc" => self.ndc,
            "window" => self.window,
            "pixel" => self.pixel,
            "viewport" => self.viewport,
            _ => self.homogeneous,
        }
    }
}
