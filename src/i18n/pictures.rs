//! The words in the three pictures.

use super::Lang;
use crate::picture::Crowded;
use crate::views::Labels;

texts! {
    window: "window", "janela";
    near: "near", "frente";
    far: "far", "fundo";
    scene: "scene", "cena";
    vertex: "vertex", "vértice";
    point: "point", "ponto";
    before: "before", "antes";
    depth_stored: "depth buffer: Z (5.25)", "z-buffer: Z (5.25)";
    depth_linear: "distance from the eye", "distância ao olho";
    nothing: "nothing here", "nada aqui";
    outside: "outside the volume", "fora do volume";
    cuts: "made by clipping", "criado pelo recorte";
    back_faces: "back faces: culled", "faces de trás: descartadas";
    dropped: "outside: dropped whole", "fora: descartado inteiro";
    outside_of: "outside", "fora";
    divided_first: "divided before clipping", "dividido antes do recorte";
    wrong: "wrong", "errado";
    no_difference: "nothing wrong falls into the volume", "nada de errado cai no volume";
    not_split: "too many pieces for BSP: depth buffer instead", "pedaços demais para o BSP: usa o buffer de profundidade";
    rounded: "vertices are off by rounding", "vértices deslocados pelo arredondamento";
    reversed: "reversed", "invertido";
    right_handed: "right-handed", "mão direita";
    left_handed: "left-handed", "mão esquerda";
    // The planes, outside of which an object is.
    plane_left: "left", "esquerda";
    plane_right: "right", "direita";
    plane_bottom: "bottom", "baixo";
    plane_top: "top", "topo";
    plane_near: "near", "frente";
    plane_far: "far", "fundo";
}

static LABELS_EN: Labels = of(&EN);
static LABELS_PT_BR: Labels = of(&PT_BR);

/// The words of a language.
#[must_use]
pub const fn labels(lang: Lang) -> &'static Labels {
    match lang {
        Lang::En => &LABELS_EN,
        Lang::PtBr => &LABELS_PT_BR,
    }
}

/// Three pictures with less room on their paper than their letters want.
#[must_use]
pub fn crowded(lang: Lang, crowded: &Crowded) -> String {
    let Crowded { smallest, letters, wanted, room } = crowded;
    let number = |value: &f64| lang.mark().printed(&format!("{value:.1}"));
    let size = |size: &[f64; 2]| format!("{} × {} cm", number(&size[0]), number(&size[1]));
    let (smallest, letters, room) = (size(smallest), number(letters), size(room));
    let wanted = lang.mark().number(*wanted, 3);
    match lang {
        Lang::En => format!(
            "the smallest of the three pictures is {smallest}, with letters of {letters} pt; letters of {wanted} pt want pictures of at least {room}"
        ),
        Lang::PtBr => format!(
            "a menor das três imagens tem {smallest}, com letras de {letters} pt; letras de {wanted} pt pedem imagens de pelo menos {room}"
        ),
    }
}

const fn of(t: &Texts) -> Labels {
    Labels {
        mark: t.lang.mark(),
        window: t.window,
        near: t.near,
        far: t.far,
        scene: t.scene,
        vertex: t.vertex,
        point: t.point,
        before: t.before,
        depth_stored: t.depth_stored,
        depth_linear: t.depth_linear,
        nothing: t.nothing,
        outside: t.outside,
        cuts: t.cuts,
        back_faces: t.back_faces,
        dropped: t.dropped,
        outside_of: t.outside_of,
        divided_first: t.divided_first,
        wrong: t.wrong,
        no_difference: t.no_difference,
        not_split: t.not_split,
        rounded: t.rounded,
        reversed: t.reversed,
        right_handed: t.right_handed,
        left_handed: t.left_handed,
        planes: [t.plane_left, t.plane_right, t.plane_bottom, t.plane_top, t.plane_near, t.plane_far],
    }
}
