//! The words of the scene: its tree, its objects and lights.

use crate::i18n::Lang;
use crate::scene::{LightKind, LostFeature, Preset, Shape};

texts! {
    drawing: "Drawing", "Desenho";

    add: "Add", "Adicionar";
    add_hint: "Adds a primitive, a mesh file, a group or a light", "Adiciona uma primitiva, um arquivo de malha, um grupo ou uma luz";
    edit_copy: "Edit a copy", "Editar uma cópia";
    edit_copy_hint: "Copies the named scene into the figure as a list of objects that can be edited, in the colours of the current theme", "Copia a cena nomeada para a figura como uma lista de objetos que podem ser editados, nas cores do tema atual";
    selected_alone: "You can select several objects only if they're the figure's own. Use \"Edit a copy\" first.", "Só objetos da própria figura podem ser selecionados juntos. Use antes \"Editar uma cópia\".";
    lost: "A list of objects cannot express, and loses:", "Uma lista de objetos não exprime, e perde:";
    copied: "The scene is now a list of objects.", "A cena agora é uma lista de objetos.";
    tree: "Objects", "Objetos";
    root: "World", "Mundo";
    root_hint: "Drop an object here to detach it from its parent", "Solte um objeto aqui para separá-lo do pai";
    fold: "Collapse", "Recolher";
    of_preset_hint: "It belongs to the named scene and cannot be edited. “Edit a copy” makes it an object of the figure.", "Pertence à cena nomeada e não pode ser editado. “Editar uma cópia” faz dele um objeto da figura.";
    row_hint: "Click to select, drag onto another object to make it a child, Del to delete", "Clique para selecionar, arraste para outro objeto para torná-lo filho, Del para excluir";
    nothing_selected: "Select an object or a light to edit it, here or with a click in the world or in the image. Ctrl selects several. In the world, arrows, rings and bars move, turn and scale it (keys T, R, S).", "Selecione um objeto ou uma luz para editar, aqui ou com um clique no mundo ou na imagem. Com Ctrl, selecione vários. No mundo, setas, anéis e barras o movem, giram e escalam (teclas T, R, S).";
    empty: "There are no objects yet.", "Ainda não há objetos.";

    object: "Object", "Objeto";
    name: "name", "nome";
    name_hint: "Each object has a name of its own", "Cada objeto tem um nome próprio";
    kind: "kind", "tipo";
    kind_hint: "The shape. A group has only a transform", "A forma. Um grupo só tem uma transformação";
    parent: "parent", "pai";
    parent_hint: "The object whose transform comes before its own", "O objeto cuja transformação vem antes da sua";
    no_parent: "none", "nenhum";
    stay: "Keep in place", "Manter no lugar";
    stay_hint: "If on, an object with a new parent gets the numbers that keep it in place in the world. If off, it keeps its numbers and moves with the new parent", "Ligado, o objeto com um novo pai recebe os números que o mantêm no lugar no mundo. Desligado, mantém os números e se move com o novo pai";
    shear: "It couldn't stay in place. Under this parent, that would need a shear, which translation, rotation and scale can't express.", "Não pôde ficar no lugar. Sob este pai isso seria um cisalhamento, que translação, rotação e escala não exprimem.";
    translate: "translation", "translação";
    translate_hint: "T, scene units along the axes of the parent. The object's matrix is T · R · S, [3]", "T, unidades da cena ao longo dos eixos do pai. A matriz do objeto é T · R · S, [3]";
    rotate: "rotation", "rotação";
    rotate_hint: "R, degrees about x, then y, then z: R = Rz · Ry · Rx", "R, graus em torno de x, depois y, depois z: R = Rz · Ry · Rx";
    scale: "scale", "escala";
    scale_hint: "S, along the object's own axes. It can't be 0. A negative one mirrors", "S, ao longo dos eixos do próprio objeto. Não pode ser 0. Se negativa, espelha";
    color: "colour", "cor";
    color_hint: "#rrggbb, or #rrggbbaa with an opacity", "#rrggbb, ou #rrggbbaa com opacidade";
    color_auto: "automatic", "automática";
    color_auto_hint: "The parent's colour, or else the next one in the palette", "A cor do pai, ou a próxima da paleta";
    color_bad: "a colour is written #rrggbb or #rrggbbaa", "uma cor se escreve #rrggbb ou #rrggbbaa";
    segments: "segments", "segmentos";
    segments_hint: "The number of sides of a prism, cells of a grid, or meridians of a curved shape", "O número de lados de um prisma, células de uma grade ou meridianos de uma forma curva";
    ends: "ends of segments, in pairs", "extremos de segmentos, aos pares";
    add_point: "Add a point", "Adicionar um ponto";
    add_segment: "Add a segment", "Adicionar um segmento";
    remove_point: "Remove", "Remover";
    point_number: "point", "ponto";
    too_many: "There are more points than you can edit here. Edit them in the figure file.", "Há mais pontos do que se pode editar aqui. Edite-os no arquivo da figura.";
    path: "file", "arquivo";
    path_hint: "OBJ, glTF or GLB, relative to the figure file", "OBJ, glTF ou GLB, relativo ao arquivo da figura";
    texture: "texture", "textura";
    texture_hint: "An image on the surface. The colour of the object multiplies it", "Uma imagem sobre a superfície. A cor do objeto a multiplica";
    texture_none: "none", "nenhuma";
    texture_of_file: "of the file", "a do arquivo";
    texture_chequer: "chequers", "xadrez";
    texture_letters: "grid with letters", "grade com letras";
    texture_uv: "u and v as colours", "u e v como cores";
    texture_file: "an image…", "uma imagem…";
    texture_file_hint: "PNG, JPEG or WebP, relative to the figure file. It doesn't travel with a link or an exported image", "PNG, JPEG ou WebP, relativo ao arquivo da figura. Não viaja com um link nem com uma imagem exportada";
    texture_title: "Choose an image", "Escolher uma imagem";
    texture_filter: "Image (PNG, JPEG, WebP)", "Imagem (PNG, JPEG, WebP)";
    texture_action: "Choose", "Escolher";
    wrap: "beyond its border", "além da borda";
    wrap_hint: "How the texture continues when u or v leaves 0 … 1", "Como a textura continua quando u ou v sai de 0 … 1";
    wrap_repeat: "repeated", "repetida";
    wrap_clamp: "border goes on", "borda continua";
    wrap_mirror: "mirrored", "espelhada";
    filter: "filter", "filtro";
    filter_hint: "How a pixel gets its colour from texels. It takes the nearest, a blend of four, or a blend of four in each of two mipmap levels", "Como um pixel obtém a cor dos texels. Usa o mais próximo, ou uma entre quatro, ou entre quatro em dois níveis de mipmap";
    filter_nearest: "nearest", "vizinho mais próximo";
    filter_bilinear: "bilinear", "bilinear";
    filter_trilinear: "trilinear", "trilinear";
    texture_reveal: "to see", "para ver";
    texture_reveal_hint: "The inner workings of texturing, in all views. Choose u and v without w, mipmap levels as colours, or texels", "O trabalho interno da texturização, em todas as vistas. Escolha u e v sem w, níveis de mipmap em cores ou texels";
    texture_plain: "the texture", "a textura";
    texture_affine: "without w", "sem w";
    texture_levels: "mipmap levels", "níveis de mipmap";
    texture_texels: "texels", "texels";
    texture_scale: "times", "vezes";
    texture_scale_hint: "Repetitions along u and v. A negative number mirrors", "Repetições ao longo de u e v. Um número negativo espelha";
    browse: "Choose…", "Escolher…";
    read_again_hint: "The file may have changed since it was read", "O arquivo pode ter mudado desde que foi lido";
    allow_files: "Let this figure read any file", "Deixar esta figura ler qualquer arquivo";
    allow_files_hint: "Until you close it, the figure may name any file of this computer. Files on other machines are never read", "Até você fechá-la, a figura pode indicar qualquer arquivo deste computador. Arquivos de outras máquinas nunca são lidos";
    loading: "Loading", "Carregando";
    duplicate: "Duplicate", "Duplicar";
    duplicate_hint: "Adds a copy with the same numbers", "Adiciona uma cópia com os mesmos números";
    delete: "Delete", "Excluir";
    delete_hint: "Removes it from the scene", "Remove-o da cena";
    delete_all: "With all objects below it", "Com os objetos abaixo dele";
    delete_alone: "Alone. Its children move to its parent", "Sozinho. Os filhos vão para o pai dele";
    delete_question: "Objects below it:", "Objetos abaixo dele:";
    deleted: "Deleted:", "Excluído:";
    matrix: "World matrix", "Matriz no mundo";

    lights: "Lights", "Luzes";
    default_light: "default light", "luz padrão";
    default_light_hint: "A scene without lights of its own has this directional one. The first light that you add replaces it.", "Uma cena sem luzes próprias tem esta, direcional. A primeira luz adicionada a substitui.";
    light: "Light", "Luz";
    light_kind_hint: "Directional light is parallel, as from the sun. A point light shines from one point", "A luz direcional é paralela, como a do sol. A pontual brilha a partir de um ponto";
    direction: "direction", "direção";
    direction_hint: "The direction in which light travels, in the world. Any length but 0", "A direção em que a luz se propaga, no mundo. Qualquer comprimento, exceto 0";
    light_position: "position", "posição";
    light_position_hint: "The position of the light (world)", "A posição da luz (mundo)";
    shadows: "casts shadows", "projeta sombras";
    shadows_hint: "Faces that this light doesn't see are in shadow. Its depth image, the shadow map, says which", "As faces que esta luz não vê ficam na sombra. A imagem de profundidades dela, o mapa de sombras, diz quais";
    shadow_map: "shadow map", "mapa de sombras";
    shadow_map_hint: "Side of the depth image in texels, 64 to 4096. A small one has steps at the edges of shadows", "Lado da imagem de profundidades em texels, de 64 a 4096. Um pequeno mostra degraus nas bordas das sombras";
    shadow_bias: "bias", "bias";
    shadow_bias_hint: "How much deeper than the map a point must lie to be in shadow, in texels, 0 to 100. With 0, faces shadow themselves. With too much, shadows come off their objects", "Quanto mais fundo que o mapa um ponto precisa estar para ficar na sombra, em texels, de 0 a 100. Com 0, as faces sombreiam a si mesmas. Com um bias grande demais, as sombras se descolam dos objetos";
    shadow_reveal: "show", "mostrar";
    shadow_reveal_hint: "A light is a camera too. Choose its image, the shadow map, or the shadows without bias, or the pixels whose rays to the light disagree with the map. The world shows its volume", "Uma luz também é uma câmera. Escolha a imagem dela, o mapa de sombras, ou as sombras sem bias, ou os pixels em que os raios até a luz discordam do mapa. O mundo mostra o volume dela";
    shadow_plain: "shadows", "sombras";
    shadow_of_light: "what the light sees", "o que a luz vê";
    shadow_acne: "without bias", "sem bias";
    shadow_truth: "where the map is wrong", "onde o mapa erra";
    shadow_softness: "soft edge", "borda suave";
    shadow_softness_hint: "Width of the soft edge of shadows, in texels, 0 to 8", "Largura da borda suave das sombras, em texels, de 0 a 8";

    name_empty: "a name must not be empty", "um nome não pode ser vazio";
    mesh_title: "Choose a mesh", "Escolher uma malha";
    mesh_filter: "Mesh (OBJ, glTF, GLB)", "Malha (OBJ, glTF, GLB)";
    mesh_action: "Add", "Adicionar";

    drag_object: "Drag along this axis of its parent", "Arraste ao longo deste eixo do pai";
    drag_lamp: "Drag along this axis", "Arraste ao longo deste eixo";
    drag_parallel_light: "Drag to turn the direction of the light about this axis", "Arraste para girar a direção da luz em torno deste eixo";
    drag_ring: "Drag to turn about this axis of its parent", "Arraste para girar em torno deste eixo do pai";
    drag_bar: "Drag to scale along its own axis, or at the centre to scale along all of them", "Arraste para mudar a escala ao longo do próprio eixo, ou no meio em todos";
    drag_snaps: "Ctrl: in steps", "Ctrl: em passos";
    sheared: "Some stay as they were, since a turn under their parent would shear them", "Alguns ficam como estavam, pois o giro sob o pai os cisalharia";
    together: "objects together", "objetos juntos";
    gizmo_hint: "What dragging in the world does to the selection. With the keyboard, while the world has the focus: T, R, S", "O que arrastar no mundo faz à seleção. Pelo teclado, com o foco no mundo: T, R, S";
    gizmo_move: "T move", "T mover";
    gizmo_turn: "R turn", "R girar";
    gizmo_scale: "S scale", "S escalar";
    several: "objects are selected. Dragging in the world, Duplicate and Delete act on all of them. The fields are those of", "objetos selecionados. Arrastar no mundo, Duplicar e Excluir agem em todos. Os campos são de";

    group: "group", "grupo";
    shape_box: "box", "caixa";
    shape_prism: "prism", "prisma";
    shape_pyramid: "pyramid", "pirâmide";
    shape_sphere: "sphere", "esfera";
    shape_ellipsoid: "ellipsoid", "elipsoide";
    shape_cylinder: "cylinder", "cilindro";
    shape_cone: "cone", "cone";
    shape_torus: "torus", "toro";
    shape_grid: "grid", "grade";
    shape_points: "points", "pontos";
    shape_segments: "segments", "segmentos";
    shape_mesh: "mesh", "malha";
    shape_mesh_file: "mesh file…", "arquivo de malha…";
    directional: "directional", "direcional";
    point: "point", "pontual";
    directional_light: "directional light", "luz direcional";
    point_light: "point light", "luz pontual";
}

impl Texts {
    /// The name of a shape. A group has none.
    pub fn shape(&self, shape: Option<&Shape>) -> &'static str {
        match shape {
            None => self.group,
            Some(Shape::Box) => self.shape_box,
            Some(Shape::Prism) => self.shape_prism,
            Some(Shape::Pyramid) => self.shape_pyramid,
            Some(Shape::Sphere) => self.shape_sphere,
            Some(Shape::Ellipsoid) => self.shape_ellipsoid,
            Some(Shape::Cylinder) => self.shape_cylinder,
            Some(Shape::Cone) => self.shape_cone,
            Some(Shape::Torus) => self.shape_torus,
            Some(Shape::Grid) => self.shape_grid,
            Some(Shape::Points(_)) => self.shape_points,
            Some(Shape::Segments(_)) => self.shape_segments,
            Some(Shape::Mesh { .. }) => self.shape_mesh,
        }
    }

    /// The name of a kind of light.
    pub fn light(&self, kind: LightKind) -> &'static str {
        match kind {
            LightKind::Directional => self.directional,
            LightKind::Point => self.point,
        }
    }
}

/// The displayed name of an object of a named scene. Figure files have the name itself.
pub fn preset_object(lang: Lang, name: &str) -> String {
    pick!(lang; name.to_owned(), name.split(' ').map(in_portuguese).collect::<Vec<_>>().join(" "))
}

fn in_portuguese(word: &str) -> &str {
    match word {
        "ball" => "bola",
        "beam" => "viga",
        "box" => "caixa",
        "chimney" => "chaminé",
        "column" => "coluna",
        "cone" => "cone",
        "crown" => "copa",
        "cube" => "cubo",
        "cylinder" => "cilindro",
        "door" => "porta",
        "ellipsoid" => "elipsoide",
        "floor" => "piso",
        "grid" => "grade",
        "ground" => "chão",
        "house" => "casa",
        "left" => "esquerda",
        "points" => "pontos",
        "prism" => "prisma",
        "pyramid" => "pirâmide",
        "right" => "direita",
        "roof" => "telhado",
        "segments" => "segmentos",
        "sphere" => "esfera",
        "step" => "degrau",
        "table" => "mesa",
        "torus" => "toro",
        "tree" => "árvore",
        "trunk" => "tronco",
        "walls" => "paredes",
        "window" => "janela",
        other => other,
    }
}

/// The features of a named scene that the list of its objects can't express, as a sentence. Empty if it expresses all.
pub fn lost(lang: Lang, preset: Preset) -> String {
    let lost = beyond(lang, preset.beyond_objects());
    if lost.is_empty() { lost } else { format!("{} {lost}.", texts(lang).lost) }
}

/// The features that a list of objects can't express, as a list.
pub fn beyond(lang: Lang, lost: &[LostFeature]) -> String {
    let word = |what: &LostFeature| match what {
        LostFeature::NumberedFaces => pick!(lang; "the colours of single faces and the numbers on them",
            "as cores de cada face e os números nelas"),
        LostFeature::TiledFloor => pick!(lang; "the tiled floor", "o piso ladrilhado"),
        LostFeature::InnerSides => pick!(lang; "the inner sides of faces", "os lados de dentro das faces"),
        LostFeature::CornerNames => pick!(lang; "the coordinates beside the corners",
            "as coordenadas junto aos vértices"),
        LostFeature::WireCube => pick!(lang; "that the cube has no faces", "que o cubo não tem faces"),
        LostFeature::LetterF => pick!(lang; "the letter F", "a letra F"),
        LostFeature::Rays => pick!(lang; "the arrows of the construction", "as setas da construção"),
    };
    lost.iter().map(word).collect::<Vec<_>>().join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::appearance::Theme;
    use crate::scene::palette::SceneColors;
    use crate::scene::preset_objects;

    #[test]
    fn every_object_of_a_named_scene_has_a_name_in_both_languages() {
        let mut same = std::collections::BTreeSet::new();
        for preset in [
            Preset::Primitives,
            Preset::Cube,
            Preset::House,
            Preset::Corridor,
            Preset::Pyramid,
            Preset::NdcCube,
            Preset::Exercise51,
            Preset::Exercise52,
            Preset::Exercise53,
        ] {
            for object in preset_objects(preset, &SceneColors::of(Theme::Light)) {
                assert_eq!(preset_object(Lang::En, &object.name), object.name);
                let shown = preset_object(Lang::PtBr, &object.name);
                if shown == object.name {
                    same.insert(shown);
                }
            }
        }
        assert_eq!(same.into_iter().collect::<Vec<_>>(), ["P", "cone"]);
        assert_eq!(preset_object(Lang::PtBr, "column left 3"), "coluna esquerda 3");
    }
}
