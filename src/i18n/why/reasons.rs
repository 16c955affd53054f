//! The reasons why stages run, and why they are skipped.

use crate::i18n::Lang;
use crate::pipeline::{PlaneSet, Reason};

texts! {
    always: "every view needs it", "toda vista precisa dela";
    nothing_in_view: "nothing is in view", "não há nada no campo de visão";
    something_in_view: "the vertices of what is in view must be mapped to pixels", "os vértices do que se vê precisam ser levados a pixels";
    forced: "not needed; runs because all stages were requested", "desnecessária; é executada porque todas foram pedidas";
    no_objects: "there are no objects", "não há objetos";
    wireframe: "wireframe: only edges are drawn", "aramado: só as arestas são desenhadas";
    no_faces: "no object in view has faces", "nenhum objeto visível tem faces";
    no_light: "there is no light: faces show their own colour", "não há luz: as faces mostram a própria cor";
    unlit: "no object in view is lit", "nenhum objeto visível recebe luz";
    flat_shading: "flat shading: lighting each face once needs no vertex normals", "sombreamento constante: iluminar cada face uma vez dispensa as normais dos vértices";
    both_sides_seen: "both sides of all faces may be seen: they are two-sided or translucent", "os dois lados das faces podem ser vistos: são de dois lados ou translúcidas";
    no_face_left: "no face is left: all were dropped or clipped before", "não sobra nenhuma face: todas foram descartadas ou recortadas antes";
    symmetric_window: "symmetric window: l = −r and b = −t, so these terms are 0", "janela simétrica: l = −r e b = −t, logo esses termos são 0";
    oblique_window: "the axis of projection misses the centre of the window", "o eixo de projeção não passa pelo centro da janela";
    parallel_projection: "parallel projection: w is 1 everywhere", "projeção paralela: w vale 1 em toda parte";
    perspective_projection: "perspective: w is the distance from the eye", "perspectiva: w é a distância ao olho";
    one_color_a_face: "every face has one colour", "cada face tem uma só cor";
    convex_alone: "a single closed convex object does not hide itself once its back faces are dropped", "um só objeto convexo e fechado não esconde partes de si mesmo depois de descartadas as faces de trás";
    hides_itself: "depth buffer: an object that is not convex, or open, may hide itself", "z-buffer: um objeto não convexo, ou aberto, pode esconder partes de si mesmo";
    lines_ask_for_depth: "depth buffer: hidden parts of lines, marks or texts are drawn differently", "z-buffer: as partes ocultas de linhas, marcas ou textos são desenhadas de outro modo";
    painted_by_centroid: "painter: from back to front by centroid", "pintor: de trás para a frente, pelo centroide";
    painted_by_splitting: "BSP: from back to front, split at faces that cross each other's planes", "BSP: de trás para a frente, com as faces divididas pelos planos umas das outras";
    no_depth_buffer: "BSP: the output has no depth buffer; from back to front, split at faces that cross each other's planes", "BSP: a saída não tem z-buffer; de trás para a frente, com as faces divididas pelos planos umas das outras";
    no_texture: "no object has a texture", "nenhum objeto tem textura";
    no_shadows: "no light casts a shadow into view", "nenhuma luz projeta sombra no que se vê";
    nothing_shadowed: "nothing in view can be shadowed: no object takes light", "nada no campo de visão pode ficar na sombra: nenhum objeto recebe luz";
    all_opaque: "everything in view is opaque", "tudo que se vê é opaco";
    one_sample: "one sample for each pixel", "uma amostra por pixel";
    lines_in_view: "edges, outlines, lines, marks or texts are to be drawn", "há arestas, contornos, linhas, marcas ou textos a desenhar";
    depths_shown: "the image shows depths instead of colours", "a imagem mostra profundidades em vez de cores";
    divided_first: "after the divide, as requested: too late, what is behind the eye has folded over", "depois da divisão, como foi pedido: tarde demais, o que está atrás do olho já dobrou para a frente";
    no_lines: "nothing but faces is in view", "só há faces no campo de visão";
}

/// The reason why a stage runs, or why it's skipped.
pub fn reason(lang: Lang, reason: Reason) -> String {
    let t = texts(lang);
    let objects = |n: usize| match n {
        1 => both!(lang; "1 object", "1 objeto"),
        n => both!(lang; "{n} objects", "{n} objetos"),
    };
    let n_of = |n: usize, of: usize| both!(lang; "{n} of {}", "{n} de {}"; objects(of));
    match reason {
        Reason::Always => t.always.to_owned(),
        Reason::NothingInView => t.nothing_in_view.to_owned(),
        Reason::SomethingInView => t.something_in_view.to_owned(),
        Reason::FacesInView { objects: n } => both!(lang; "faces of {} are in view",
            "há faces de {} no campo de visão"; objects(n)),
        Reason::Forced => t.forced.to_owned(),
        Reason::Outside { outside, of } => both!(lang;
            "{}: all of the bounding box is outside one plane of the volume",
            "{}: toda a caixa envolvente está fora de um plano do volume"; n_of(outside, of)),
        Reason::NoneOutside { of: 0 } => t.no_objects.to_owned(),
        Reason::NoneOutside { of: 1 } => both!(lang; "the object is not wholly outside the volume",
            "o objeto não está totalmente fora do volume"),
        Reason::NoneOutside { of } => both!(lang; "none of {} is wholly outside the volume",
            "nenhum de {} está totalmente fora do volume"; objects(of)),
        Reason::Wireframe => t.wireframe.to_owned(),
        Reason::NoFaces => t.no_faces.to_owned(),
        Reason::NoLight => t.no_light.to_owned(),
        Reason::Unlit { .. } => t.unlit.to_owned(),
        Reason::FlatShading => t.flat_shading.to_owned(),
        Reason::LitFaces { objects: n } => both!(lang; "one colour for each face of {}",
            "uma cor para cada face de {}"; objects(n)),
        Reason::LitVertices { objects: n } => both!(lang; "one colour for each vertex of {}",
            "uma cor para cada vértice de {}"; objects(n)),
        Reason::LitPixels { objects: n } => both!(lang; "light is computed at each pixel of {}",
            "a luz é calculada em cada pixel de {}"; objects(n)),
        Reason::LitVerticesAndPixels { vertices, pixels } => both!(lang;
            "{} with colours at the vertices: lit there; lit at each pixel of {}",
            "{} com cores nos vértices: luz ali; em cada pixel de {}"; objects(vertices), objects(pixels)),
        Reason::BackFaces { objects: n, of } => both!(lang; "{}: closed or one-sided, so back faces cannot be seen",
            "{}: em objetos fechados ou de um só lado, as faces de trás não se veem"; n_of(n, of)),
        Reason::BothSidesSeen { .. } => t.both_sides_seen.to_owned(),
        Reason::CutOpen { objects: n, of } => both!(lang;
            "the front plane cuts {} open: the inside may be seen, so nothing is dropped",
            "o plano da frente abre {}: vê-se o interior, e nada é descartado"; n_of(n, of)),
        Reason::NoFaceLeft => t.no_face_left.to_owned(),
        Reason::AllInside { objects: n } => both!(lang; "{}: wholly inside the volume, so there is nothing to cut",
            "{}: por inteiro dentro do volume, logo não há o que cortar"; objects(n)),
        Reason::Crossing { objects: 1, of, planes: crossed } => both!(lang;
            "{} may cross {}; only it is cut, and only there",
            "{} pode cruzar {}; só ele é cortado, e só ali"; n_of(1, of), planes(lang, crossed)),
        Reason::Crossing { objects: n, of, planes: crossed } => both!(lang;
            "{} may cross {}; only they are cut, and only there",
            "{} podem cruzar {}; só eles são cortados, e só ali"; n_of(n, of), planes(lang, crossed)),
        Reason::SymmetricWindow => t.symmetric_window.to_owned(),
        Reason::ObliqueWindow => t.oblique_window.to_owned(),
        Reason::ParallelProjection => t.parallel_projection.to_owned(),
        Reason::PerspectiveProjection => t.perspective_projection.to_owned(),
        Reason::OneColorAFace => t.one_color_a_face.to_owned(),
        Reason::VariesOverFaces { objects: n } => both!(lang; "colours vary over the faces of {}",
            "as cores variam sobre as faces de {}"; objects(n)),
        Reason::ConvexAlone => t.convex_alone.to_owned(),
        Reason::SeveralObjects { objects: n } => both!(lang; "depth buffer: faces of {} may hide each other",
            "z-buffer: faces de {} podem esconder umas às outras"; objects(n)),
        Reason::HidesItself => t.hides_itself.to_owned(),
        Reason::LinesAskForDepth => t.lines_ask_for_depth.to_owned(),
        Reason::PaintedByCentroid => t.painted_by_centroid.to_owned(),
        Reason::PaintedBySplitting => t.painted_by_splitting.to_owned(),
        Reason::NoDepthBuffer => t.no_depth_buffer.to_owned(),
        Reason::TooManyPieces { pieces } => both!(lang;
            "depth buffer instead of BSP: splitting stopped at {pieces} pieces, which are too many",
            "z-buffer em vez de BSP: a divisão parou em {pieces} pedaços, que são demais"),
        Reason::TextureOfOneColor { objects: n } => both!(lang; "a texture of one colour on {}",
            "textura de uma só cor em {}"; objects(n)),
        Reason::NoTexture => t.no_texture.to_owned(),
        Reason::Textured { objects: n } => both!(lang; "a texture on {}", "uma textura sobre {}"; objects(n)),
        Reason::NoShadows => t.no_shadows.to_owned(),
        Reason::NothingShadowed => t.nothing_shadowed.to_owned(),
        Reason::Shadowed { objects: n } => both!(lang; "shadows may fall on {}",
            "sombras podem cair sobre {}"; objects(n)),
        Reason::AllOpaque => t.all_opaque.to_owned(),
        Reason::Translucent { objects: n } => both!(lang; "something shows through {}",
            "algo se vê através de {}"; objects(n)),
        Reason::OneSample => t.one_sample.to_owned(),
        Reason::Samples { samples } => both!(lang; "{samples} samples for each pixel", "{samples} amostras por pixel"),
        Reason::LinesInView => t.lines_in_view.to_owned(),
        Reason::DepthsShown => t.depths_shown.to_owned(),
        Reason::DividedFirst => t.divided_first.to_owned(),
        Reason::NoLines => t.no_lines.to_owned(),
    }
}

/// The names of planes: "left and near", "os planos da esquerda e da frente".
pub fn planes(lang: Lang, planes: PlaneSet) -> String {
    let names = pick!(lang; ["left", "right", "bottom", "top", "near", "far"],
        ["da esquerda", "da direita", "de baixo", "de cima", "da frente", "de fundo"]);
    let names: Vec<&str> =
        names.into_iter().enumerate().filter(|(i, _)| planes & (1 << i) != 0).map(|(_, name)| name).collect();
    let [first @ .., last] = names.as_slice() else { return String::new() };
    let first = first.join(", ");
    if first.is_empty() {
        return both!(lang; "{last}", "o plano {last}");
    }
    both!(lang; "{first} and {last}", "os planos {first} e {last}")
}
