//! The words around the three pictures: titles, hints, readouts, and descriptions for screen readers.

use glam::DVec3;

use crate::camera::{Camera, ImageSize};
use crate::i18n::Lang;
use crate::views::{Arrangement, View};

/// The texts of the canvas in one language, under a name that distinguishes them from the window's, which are often at
/// hand too.
pub type CanvasTexts = Texts;

texts! {
    // Tooltip of a button.
    hide: "Hide this view", "Ocultar esta vista";
    maximize: "Enlarge (double-click)", "Ampliar (clique duplo)";
    restore: "All views again (double-click)", "Todas as vistas de novo (clique duplo)";
    // A switch of the image, and its tooltip.
    undistorted: "undistorted", "sem distorção";
    undistorted_hint: "As the eye would see it, with the aspect A of the view window. If off, you see the m × n image of (5.22), whose pixels aren't square here. Pixel numbers are those of the image in both cases", "Como o olho veria, com o aspecto A da janela de vista. Desligado, você vê a imagem m × n de (5.22), cujos pixels aqui não são quadrados. Os números dos pixels são os da imagem nos dois casos";
    // Tooltip of a switch.
    section: "Section along u, with similar triangles", "Corte ao longo de u, com triângulos semelhantes";
    link: "Orbit world and canonical volume together", "Orbitar mundo e volume canônico juntos";
    // A menu, and its tooltip.
    on_the_way: "World → canonical volume", "Mundo → volume canônico";
    look: "Viewpoint", "Ponto de vista";
    axis: "axis", "eixo";
    look_menu: "Look from…", "Ver de…";
    // Viewpoints.
    fit: "Fit all", "Enquadrar tudo";
    front: "From the front (+z)", "De frente (+z)";
    top: "From the top (+y)", "De cima (+y)";
    side: "From the side (+x)", "De lado (+x)";
    iso: "From a corner", "De um canto";
    along_u: "Along u, from the side, eye left, back plane right", "Ao longo de u, de lado, olho à esquerda, fundo à direita";
    along_v: "Along v, from above, eye left, back plane right", "Ao longo de v, de cima, olho à esquerda, fundo à direita";
    along_n: "Along n, as the camera looks", "Ao longo de n, como a câmera olha";
    // Tooltip of a menu.
    arrange: "Arrange the views", "Dispor as vistas";
    // The ways in which the pictures share the room.
    arrange_auto: "To fit the window", "Conforme a janela";
    arrange_row: "Side by side", "Lado a lado";
    arrange_column: "One above the other", "Uma sobre a outra";
    arrange_above: "The world above the others", "O mundo acima das outras";
    arrange_beside: "The world beside the others", "O mundo ao lado das outras";
    // Before the names of the hidden pictures, which can be shown again.
    hidden: "Hidden:", "Ocultas:";
    // The actions of pointer and wheel in the world and in the canonical volume.
    pointer_in_space: "Drag: orbit · Shift or right button: pan · wheel: zoom", "Arrastar: orbitar · Shift ou botão direito: mover · roda: zoom";
    // The actions of the pointer in the image.
    pointer_in_image: "Drag: orbit the camera · Shift or right button: pan · wheel: dolly · click: pin the probe", "Arrastar: orbitar com a câmera · Shift ou botão direito: mover · roda: aproximar · clique: fixar a sonda";
    // The possible actions if the pointer is on nothing.
    idle: "Drag C, PF, VUP and the planes in the world, or anything else to orbit", "Arraste C, PF, VUP e os planos no mundo, ou o resto para orbitar";
    // The same if the world is hidden.
    idle_canonical: "Drag: orbit", "Arraste: girar";
    // The actions of the keys in the world.
    keys_in_world: "Arrows: raise and turn the camera · Shift + arrows: orbit · + −: zoom the view · Home: fit all · V: probe vertices", "Setas: erguer e girar a câmera · Shift + setas: orbitar · + −: ampliar · Home: enquadrar tudo · V: sondar vértices";
    // The actions of the keys in the canonical volume.
    keys_in_canonical: "Arrows: orbit · + −: zoom the view · Home: fit all · V: probe vertices", "Setas: orbitar · + −: ampliar · Home: enquadrar tudo · V: sondar vértices";
    // The actions of the keys in the image.
    keys_in_image: "Arrows: raise and turn the camera · + −: zoom · Page ↑ ↓: nearer, farther · I, V: probe pixels, vertices", "Setas: erguer e girar a câmera · + −: zoom · Page ↑ ↓: perto, longe · I, V: sondar pixels, vértices";
    // Title of the strip of stages, and the button that shows it.
    strip: "Stages", "Etapas";
    // Tooltip of that button. Name of the chooser of the view whose stages are shown.
    strip_of: "Stages of the view", "Etapas da vista";
    // Tooltip of a button.
    strip_close: "Hide the stages (F10)", "Ocultar as etapas (F10)";
    // For a hidden picture.
    strip_hidden: "This view is hidden, so no stage runs for it.", "Esta vista está oculta, e nenhuma etapa é executada para ela.";
    // Before the time of all stages.
    strip_total: "in all", "ao todo";
    // Before the number of stages that ran.
    strip_ran: "ran:", "executadas:";
    // Before the number of stages that didn't run.
    strip_out: "skipped:", "omitidas:";
    // The use of the strip.
    strip_hint: "click a stage to see what goes in and what comes out", "clique em uma etapa para ver o que entra e o que sai";
    // For a stage.
    strip_reveal: "Click or press Enter to show in the view what goes in and what comes out. F1 opens its reference page", "Clique ou aperte Enter para mostrar na vista o que entra e o que sai. F1 abre o verbete";
    strip_unreveal: "Click or press Enter or Esc to stop showing it. F1 opens its reference page", "Clique ou aperte Enter ou Esc para deixar de mostrar. F1 abre o verbete";
    // While the eye turns.
    turning: "Orbiting", "Orbitando";
    // While the picture is moved.
    moving: "Panning", "Movendo a vista";
    // The way to drag a point on the plane, followed by its height.
    drag_on_plane: "Drag: on the plane y =", "Arrastar: no plano y =";
    // The way to drag a point up and down.
    drag_vertically: "Shift or Ctrl: up and down", "Shift ou Ctrl: para cima e para baixo";
    // The way to turn VUP.
    drag_up: "Drag to turn VUP about DOP", "Arraste para girar VUP em torno de DOP";
    // The way to drag a plane.
    drag_along_axis: "Drag along the axis", "Arraste ao longo do eixo";
    // Before the reason why a handle can't be dragged further.
    stopped: "Stopped:", "Parado:";
    // If a picture couldn't be drawn.
    given_up: "Cancelled. This view is redrawn when the figure changes.", "Cancelada. Esta vista é redesenhada quando a figura mudar.";
    not_drawn: "This view could not be drawn.", "Esta vista não pôde ser desenhada.";
    // If the pointer is on nothing.
    probe_hint: "Point at a vertex or at a pixel of the image to read its coordinates here.", "Aponte para um vértice ou um pixel da imagem para ler aqui suas coordenadas.";
    // While the probe is pinned.
    pinned: "pinned (Esc: release)", "fixada (Esc: soltar)";
    // For a point outside the view volume.
    outside: "outside the volume", "fora do volume";
    // For a point with w = 0.
    no_image: "w = 0, in the plane of the eye, no image", "w = 0, no plano do olho, sem imagem";
    // Before the place of the pointer, which isn't that of a vertex near it.
    pointer: "Pointer:", "Ponteiro:";
    // Before the number and the object of a vertex.
    vertex: "Vertex", "Vértice";
    // Title of the card with the pinned probe, and its buttons.
    card: "Probe", "Sonda";
    copy: "Copy", "Copiar";
    copy_hint: "All digits, as text", "Todos os dígitos, como texto";
    release: "Release (Esc)", "Soltar (Esc)";
    // The space.
    space_world: "World", "Mundo";
    space_view: "View", "Vista";
    space_clip: "Clip", "Recorte";
    space_ndc: "NDC", "NDC";
    space_window: "Window", "Janela";
    space_pixel: "Pixel", "Pixel";
    space_viewport: "Viewport", "Viewport";
    // The bits for the planes that a point is outside of.
    outcode: "Outcode", "Outcode";
    // The meaning of the outcode of a point inside.
    inside: "inside", "dentro";
    // Z of a pixel.
    depth: "Depth", "Profundidade";
    // If the depth buffer is empty there.
    nothing_here: "nothing here", "nada aqui";
    // From the eye.
    distance: "Distance", "Distância";
    // The start of a ray.
    ray_origin: "Ray from", "Raio de";
    // The direction of a ray.
    ray_direction: "Direction", "Direção";
}

/// The observer of a picture went back. The first key fits the picture, undo of the camera brings it back.
pub fn went_back(lang: Lang, view: View) -> String {
    let name = texts(lang).view(view);
    both!(lang; "{name} is seen from farther away, so that everything stays in the view (Alt+0 fits it)",
        "{name} é visto de mais longe, para que tudo continue na vista (Alt+0 enquadra)")
}

impl CanvasTexts {
    /// The name of an arrangement. `None` is the automatic one.
    pub fn arrangement(&self, arrangement: Option<Arrangement>) -> &'static str {
        match arrangement {
            None => self.arrange_auto,
            Some(Arrangement::Row) => self.arrange_row,
            Some(Arrangement::Column) => self.arrange_column,
            Some(Arrangement::Above) => self.arrange_above,
            Some(Arrangement::Beside) => self.arrange_beside,
        }
    }
}

impl Texts {
    /// The name of a picture.
    pub fn view(&self, view: View) -> &'static str {
        let t = super::texts(self.lang);
        match view {
            View::World => t.show_world,
            View::Canonical => t.show_canonical,
            View::Image => t.show_image,
        }
    }
}

/// A picture in words: the camera's place of the world, the size of the image in pixels.
pub fn describe(lang: Lang, view: View, camera: &Camera, image: ImageSize) -> String {
    match view {
        View::World => {
            let place = |p: DVec3| lang.mark().tuple(&p.to_array(), 4);
            describe_world(lang, &place(camera.position()), &place(camera.focal_point()))
        }
        View::Canonical => describe_canonical(lang),
        View::Image => describe_image(lang, image.width, image.height),
    }
}

/// The world in words, from the coordinates of C and PF.
fn describe_world(lang: Lang, position: &str, focal_point: &str) -> String {
    both!(lang; "World: the scene, the camera at {position} looking at {focal_point}, and its view volume",
        "Mundo: a cena, a câmera em {position} olhando para {focal_point}, e seu volume de vista")
}

/// The canonical volume in words.
fn describe_canonical(lang: Lang) -> String {
    both!(lang; "Canonical volume: the scene after projection, in the cube from −1 to 1",
        "Volume canônico: a cena depois da projeção, no cubo de −1 a 1")
}

/// The image in words, from its size in pixels.
fn describe_image(lang: Lang, width: u32, height: u32) -> String {
    both!(lang; "Image: what the camera sees, {width} × {height} pixels",
        "Imagem: o que a câmera vê, {width} × {height} pixels")
}
