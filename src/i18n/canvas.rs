//! The words around the three pictures: titles, hints, readouts, and descriptions for screen readers.

use super::Lang;
use crate::views::View;

/// The texts of the canvas in one language.
#[derive(Debug)]
pub struct CanvasTexts {
    /// Title of the world.
    pub world: &'static str,
    /// Title of the canonical volume.
    pub canonical: &'static str,
    /// Title of the image.
    pub image: &'static str,
    /// Tooltip of a button.
    pub hide: &'static str,
    /// Tooltip of a button.
    pub maximize: &'static str,
    /// Tooltip of a button.
    pub restore: &'static str,
    /// Tooltip of a switch.
    pub link: &'static str,
    /// Tooltip of a menu.
    pub look_menu: &'static str,
    /// From where to look.
    pub fit: &'static str,
    /// From where to look.
    pub front: &'static str,
    /// From where to look.
    pub top: &'static str,
    /// From where to look.
    pub side: &'static str,
    /// From where to look.
    pub iso: &'static str,
    /// Tooltip of a menu.
    pub arrange: &'static str,
    /// How the pictures share the room.
    pub arrange_auto: &'static str,
    /// How the pictures share the room.
    pub arrange_row: &'static str,
    /// How the pictures share the room.
    pub arrange_column: &'static str,
    /// How the pictures share the room.
    pub arrange_above: &'static str,
    /// How the pictures share the room.
    pub arrange_beside: &'static str,
    /// Before the names of the pictures that can be shown again.
    pub hidden: &'static str,
    /// What pointer and wheel do in the world and in the canonical volume.
    pub pointer_in_space: &'static str,
    /// What the pointer does in the image.
    pub pointer_in_image: &'static str,
    /// Where nothing is pointed at: what can be done.
    pub idle: &'static str,
    /// What the keys do in the world.
    pub keys_in_world: &'static str,
    /// What the keys do in the canonical volume.
    pub keys_in_canonical: &'static str,
    /// What the keys do in the image.
    pub keys_in_image: &'static str,
    /// Title of the strip of stages, and the button that shows it.
    pub strip: &'static str,
    /// Tooltip of that button.
    pub strip_show: &'static str,
    /// Name of the chooser whose stages are shown.
    pub strip_of: &'static str,
    /// Tooltip of a button.
    pub strip_close: &'static str,
    /// Of a picture that is hidden.
    pub strip_hidden: &'static str,
    /// Before the time of all stages.
    pub strip_total: &'static str,
    /// Before the number of stages that ran.
    pub strip_ran: &'static str,
    /// Before the number of those that did not.
    pub strip_out: &'static str,
    /// What can be done with the strip.
    pub strip_hint: &'static str,
    /// While the eye turns.
    pub turning: &'static str,
    /// While the picture is moved.
    pub moving: &'static str,
    /// How a point is dragged on the plane; what follows is its height.
    pub drag_on_plane: &'static str,
    /// How a point is dragged up and down.
    pub drag_vertically: &'static str,
    /// How VUP is turned.
    pub drag_up: &'static str,
    /// How a plane is dragged.
    pub drag_along_axis: &'static str,
    /// Before the reason why a handle does not go on.
    pub stopped: &'static str,
    /// Where a picture could not be drawn.
    pub not_drawn: &'static str,
    /// Where nothing is pointed at.
    pub probe_hint: &'static str,
    /// While the probe is pinned.
    pub pinned: &'static str,
    /// Of a point outside the view volume.
    pub outside: &'static str,
    /// Of a point for which w = 0.
    pub no_image: &'static str,
    /// The space.
    pub space_world: &'static str,
    /// The space.
    pub space_view: &'static str,
    /// The space.
    pub space_clip: &'static str,
    /// The space.
    pub space_ndc: &'static str,
    /// The space.
    pub space_window: &'static str,
    /// The space.
    pub space_pixel: &'static str,
    /// The space.
    pub space_viewport: &'static str,
    /// The bits that say outside which planes a point is.
    pub outcode: &'static str,
    /// What the outcode of a point inside means.
    pub inside: &'static str,
    /// Z of a pixel.
    pub depth: &'static str,
    /// Where the depth buffer holds nothing.
    pub nothing_here: &'static str,
    /// From the eye.
    pub distance: &'static str,
    /// Where a ray begins.
    pub ray_origin: &'static str,
    /// Where a ray goes.
    pub ray_direction: &'static str,
    /// The distance of the front plane.
    pub near_plane: &'static str,
    /// The distance of the back plane.
    pub far_plane: &'static str,
}

impl CanvasTexts {
    /// The name of a picture.
    #[must_use]
    pub fn view(&self, view: View) -> &'static str {
        match view {
            View::World => self.world,
            View::Canonical => self.canonical,
            View::Image => self.image,
        }
    }
}

static EN: CanvasTexts = CanvasTexts {
    world: "World",
    canonical: "Canonical volume",
    image: "Image",
    hide: "Hide this picture",
    maximize: "Enlarge (double-click)",
    restore: "All pictures again (double-click)",
    link: "Turn world and canonical volume together",
    look_menu: "Look from…",
    fit: "Fit all",
    front: "From the front (+z)",
    top: "From the top (+y)",
    side: "From the side (+x)",
    iso: "From a corner",
    arrange: "Arrange the pictures",
    arrange_auto: "As suits the room",
    arrange_row: "Side by side",
    arrange_column: "One above the other",
    arrange_above: "The world above the others",
    arrange_beside: "The world beside the others",
    hidden: "Hidden:",
    pointer_in_space: "Drag: turn · Shift or right button: move · wheel: zoom",
    pointer_in_image: "Click: pin the probe",
    idle: "In the world C, PF, VUP and the planes can be dragged. Elsewhere a drag turns the view.",
    keys_in_world: "Arrows: raise and turn the camera · Shift + arrows: turn the view · + −: zoom the view · Home: fit all",
    keys_in_canonical: "Arrows: turn the view · + −: zoom the view · Home: fit all",
    keys_in_image: "Arrows: raise and turn the camera · + −: zoom · Page ↑ ↓: nearer, farther",
    strip: "Pipeline",
    strip_show: "Every stage of the pipeline: what went in and came out, how long it took, or why it was left out (F10)",
    strip_of: "Stages of the picture",
    strip_close: "Hide the pipeline (F10)",
    strip_hidden: "This picture is hidden: no stage runs for it.",
    strip_total: "together",
    strip_ran: "ran:",
    strip_out: "left out:",
    strip_hint: "point at a stage",
    turning: "Turning the view",
    moving: "Moving the view",
    drag_on_plane: "Drag: on the plane y =",
    drag_vertically: "Shift or Ctrl: up and down",
    drag_up: "Drag: turn VUP about DOP",
    drag_along_axis: "Drag: along the axis",
    stopped: "Stopped:",
    not_drawn: "This picture could not be drawn.",
    probe_hint: "Point at a vertex or at a pixel of the image: its coordinates in every space stand here.",
    pinned: "pinned (Esc: release)",
    outside: "outside the volume",
    no_image: "w = 0: no image",
    space_world: "World",
    space_view: "View",
    space_clip: "Clip",
    space_ndc: "NDC",
    space_window: "Window",
    space_pixel: "Pixel",
    space_viewport: "Viewport",
    outcode: "Outcode",
    inside: "inside",
    depth: "Depth",
    nothing_here: "nothing here",
    distance: "Distance",
    ray_origin: "Ray from",
    ray_direction: "Direction",
    near_plane: "front plane",
    far_plane: "back plane",
};

static PT_BR: CanvasTexts = CanvasTexts {
    world: "Mundo",
    canonical: "Volume canônico",
    image: "Imagem",
    hide: "Esconder esta imagem",
    maximize: "Ampliar (clique duplo)",
    restore: "Todas as imagens de novo (clique duplo)",
    link: "Girar mundo e volume canônico juntos",
    look_menu: "Ver de…",
    fit: "Enquadrar tudo",
    front: "De frente (+z)",
    top: "De cima (+y)",
    side: "De lado (+x)",
    iso: "De um canto",
    arrange: "Arrumar as imagens",
    arrange_auto: "Conforme o espaço",
    arrange_row: "Lado a lado",
    arrange_column: "Uma sobre a outra",
    arrange_above: "O mundo acima das outras",
    arrange_beside: "O mundo ao lado das outras",
    hidden: "Escondidas:",
    pointer_in_space: "Arrastar: girar · Shift ou botão direito: mover · roda: zoom",
    pointer_in_image: "Clique: fixar a sonda",
    idle: "No mundo, C, PF, VUP e os planos podem ser arrastados. Fora deles, arrastar gira a vista.",
    keys_in_world: "Setas: erguer e girar a câmera · Shift + setas: girar a vista · + −: zoom da vista · Home: enquadrar tudo",
    keys_in_canonical: "Setas: girar a vista · + −: zoom da vista · Home: enquadrar tudo",
    keys_in_image: "Setas: erguer e girar a câmera · + −: zoom · Page ↑ ↓: perto, longe",
    strip: "Pipeline",
    strip_show: "Cada etapa do pipeline: o que entrou e o que saiu, quanto durou, ou por que foi omitida (F10)",
    strip_of: "Etapas da imagem",
    strip_close: "Esconder o pipeline (F10)",
    strip_hidden: "Esta imagem está escondida: nenhuma etapa é executada para ela.",
    strip_total: "ao todo",
    strip_ran: "executadas:",
    strip_out: "omitidas:",
    strip_hint: "aponte para uma etapa",
    turning: "Girando a vista",
    moving: "Movendo a vista",
    drag_on_plane: "Arrastar: no plano y =",
    drag_vertically: "Shift ou Ctrl: para cima e para baixo",
    drag_up: "Arrastar: girar VUP em torno de DOP",
    drag_along_axis: "Arrastar: ao longo do eixo",
    stopped: "Parado:",
    not_drawn: "Esta imagem não pôde ser desenhada.",
    probe_hint: "Aponte para um vértice ou para um pixel da imagem: suas coordenadas em cada espaço aparecem aqui.",
    pinned: "fixada (Esc: soltar)",
    outside: "fora do volume",
    no_image: "w = 0: sem imagem",
    space_world: "Mundo",
    space_view: "Vista",
    space_clip: "Recorte",
    space_ndc: "NDC",
    space_window: "Janela",
    space_pixel: "Pixel",
    space_viewport: "Viewport",
    outcode: "Outcode",
    inside: "dentro",
    depth: "Profundidade",
    nothing_here: "nada aqui",
    distance: "Distância",
    ray_origin: "Raio de",
    ray_direction: "Direção",
    near_plane: "plano da frente",
    far_plane: "plano de fundo",
};

/// The words of a language.
#[must_use]
pub const fn canvas(lang: Lang) -> &'static CanvasTexts {
    match lang {
        Lang::En => &EN,
        Lang::PtBr => &PT_BR,
    }
}

/// The world in words, from the coordinates of C and PF.
#[must_use]
pub fn describe_world(lang: Lang, position: &str, focal_point: &str) -> String {
    match lang {
        Lang::En => {
            format!("World: the scene with the camera at {position}, which looks at {focal_point}, and its view volume")
        }
        Lang::PtBr => {
            format!("Mundo: a cena com a câmera em {position}, que olha para {focal_point}, e seu volume de vista")
        }
    }
}

/// The canonical volume in words.
#[must_use]
pub fn describe_canonical(lang: Lang) -> String {
    match lang {
        Lang::En => "Canonical volume: the scene after projection, in the cube from −1 to 1".to_owned(),
        Lang::PtBr => "Volume canônico: a cena depois da projeção, no cubo de −1 a 1".to_owned(),
    }
}

/// The image in words, from its size in pixels.
#[must_use]
pub fn describe_image(lang: Lang, width: u32, height: u32) -> String {
    match lang {
        Lang::En => format!("Image: what the camera sees, {width} × {height} pixels"),
        Lang::PtBr => format!("Imagem: o que a câmera vê, {width} × {height} pixels"),
    }
}
