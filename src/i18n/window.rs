//! The words of the window.

use crate::i18n::Lang;

/// The words of a language.
#[must_use]
pub fn texts(lang: Lang) -> &'static Texts {
    match lang {
        Lang::En => &EN,
        Lang::PtBr => &PT_BR,
    }
}

texts! {
    // Menus and commands: label, then what the tooltip adds.
    menu_file: "File", "Arquivo";
    menu_edit: "Edit", "Editar";
    menu_view: "View", "Ver";
    menu_help: "Help", "Ajuda";
    new: "New", "Novo";
    new_hint: "The primitives from their best side", "As primitivas vistas do seu melhor lado";
    open: "Open…", "Abrir…";
    open_hint: "A figure file, or a picture that was exported", "Um arquivo de figura, ou uma imagem exportada";
    save: "Save", "Salvar";
    save_hint: "Writes the figure file; its comments stay", "Grava o arquivo da figura; os comentários ficam";
    save_as: "Save as…", "Salvar como…";
    save_as_hint: "Writes the figure to another file", "Grava a figura em outro arquivo";
    export: "Export pictures…", "Exportar imagens…";
    export_hint: "One picture or all three as PNG; the figure goes with it", "Uma imagem ou as três como PNG; a figura vai junto";
    quit: "Quit", "Sair";
    quit_hint: "Closes the window", "Fecha a janela";
    undo: "Undo", "Desfazer";
    undo_hint: "Takes the last change back", "Volta a última mudança";
    redo: "Redo", "Refazer";
    redo_hint: "Makes the change again", "Faz a mudança de novo";
    reset: "Reset the camera", "Restaurar a câmera";
    reset_hint: "The camera as it was when the figure was opened", "A câmera como era quando a figura foi aberta";
    copy_numbers: "Copy the numbers", "Copiar os números";
    copy_numbers_hint: "Basis, matrices, window and corners as text", "Base, matrizes, janela e cantos como texto";
    language: "Português", "English";
    language_hint: "Mudar para português", "Switch to English";
    theme: "Dark theme", "Tema escuro";
    theme_hint: "Light or dark ground", "Fundo claro ou escuro";
    presentation: "Presentation", "Apresentação";
    presentation_hint: "Large type and thick strokes, full screen, for a projector", "Letras grandes e traços grossos, tela cheia, para um projetor";
    zoom_in: "Larger interface", "Interface maior";
    zoom_in_hint: "Enlarges everything in the window", "Aumenta tudo na janela";
    zoom_out: "Smaller interface", "Interface menor";
    zoom_out_hint: "Shrinks everything in the window", "Diminui tudo na janela";
    zoom_reset: "Normal size", "Tamanho normal";
    zoom_reset_hint: "The interface at its normal size", "A interface no tamanho normal";
    parameters_panel: "Parameters", "Parâmetros";
    parameters_panel_hint: "The panel on the left", "O painel da esquerda";
    numbers_panel: "Operations and numbers", "Operações e números";
    numbers_panel_hint: "The panel on the right", "O painel da direita";
    camera_tab: "Camera tab", "Aba da câmera";
    camera_tab_hint: "Camera, projection, view window, image", "Câmera, projeção, janela de vista, imagem";
    scene_tab: "Scene tab", "Aba da cena";
    scene_tab_hint: "What the camera looks at: a tree of objects, and the lights", "O que a câmera olha: uma árvore de objetos, e as luzes";
    drawing_tab: "Drawing tab", "Aba do desenho";
    drawing_tab_hint: "How the pictures are drawn", "Como as imagens são desenhadas";
    pipeline: "Pipeline stages", "Etapas do pipeline";
    pipeline_hint: "The strip under the pictures: what each stage did, or why it was left out", "A faixa sob as imagens: o que cada etapa fez, ou por que foi omitida";
    look_front: "Look from the front", "Olhar de frente";
    look_front_hint: "The world and the canonical volume from +z", "O mundo e o volume canônico vistos de +z";
    look_top: "Look from the top", "Olhar de cima";
    look_top_hint: "The world and the canonical volume from +y", "O mundo e o volume canônico vistos de +y";
    look_side: "Look from the side", "Olhar de lado";
    look_side_hint: "The world and the canonical volume from +x", "O mundo e o volume canônico vistos de +x";
    look_iso: "Look from a corner", "Olhar de um canto";
    look_iso_hint: "The world and the canonical volume in perspective", "O mundo e o volume canônico em perspectiva";
    look_fit: "Fit all", "Enquadrar tudo";
    look_fit_hint: "Everything of interest in both pictures", "Tudo o que interessa nas duas imagens";
    link_orbits: "Link the orbits", "Ligar as órbitas";
    link_orbits_hint: "Turning one 3D picture turns the other", "Girar uma imagem 3D gira a outra";
    help: "Mouse and keyboard", "Mouse e teclado";
    help_hint: "What the pointer and the keys do", "O que o ponteiro e as teclas fazem";
    help_numbers: "Number fields", "Campos numéricos";
    help_numbers_text: "Drag to the side (Shift: slowly). Click and type a number or an expression: 1/3, sqrt(2)/2, 45°, pi/3. Enter: done · Esc: as before · ↑ ↓: one step · Page ↑ ↓: ten steps", "Arraste para o lado (Shift: devagar). Clique e digite um número ou uma expressão: 1/3, sqrt(2)/2, 45°, pi/3. Enter: pronto · Esc: como antes · ↑ ↓: um passo · Page ↑ ↓: dez passos";
    help_pictures: "Pictures", "Imagens";
    help_pictures_text: "Double-click: maximise. Drag C, PF, VUP and the planes F and B in the world, and the arrows of what is selected in the scene. Click: pin what is pointed at.", "Duplo clique: maximizar. Arraste C, PF, VUP e os planos F e B no mundo, e as setas do que está selecionado na cena. Clique: fixar o que se aponta.";
    help_commands: "Commands", "Comandos";
    close: "Close", "Fechar";
    show_world: "World", "Mundo";
    show_canonical: "Canonical volume", "Volume canônico";
    show_image: "Image", "Imagem";
    show_picture_hint: "Shows or hides this picture", "Mostra ou esconde esta imagem";

    // The bar at the top.
    untitled: "untitled", "sem título";
    changed_hint: "There are changes that have not been saved", "Há mudanças que não foram salvas";
    unchanged_hint: "Everything is saved", "Tudo está salvo";

    panel_width: "Width of the panel", "Largura do painel";
    presentation_keys: "F8: parameters · F9: operations and numbers · F10: pipeline · F11: leave the presentation", "F8: parâmetros · F9: operações e números · F10: pipeline · F11: sair da apresentação";

    // The parameters.
    camera: "Camera", "Câmera";
    position: "position", "posição";
    position_hint: "C: where the camera is. [0] §5.2", "C: onde a câmera está. [0] §5.2";
    focal_point: "focal point", "ponto focal";
    focal_point_hint: "PF: where the camera points. DOP = (PF − C)/D, [0] (5.2)", "PF: para onde a câmera aponta. DOP = (PF − C)/D, [0] (5.2)";
    view_up: "view up", "para cima";
    view_up_hint: "VUP: its projection on the view plane gives v. [0] (5.3)", "VUP: sua projeção no plano de vista dá v. [0] (5.3)";
    projection: "Projection", "Projeção";
    perspective: "Perspective", "Perspectiva";
    perspective_hint: "Projectors meet in C. The size at PF is kept. [0] (5.13)", "Os projetores se encontram em C. O tamanho em PF se mantém. [0] (5.13)";
    parallel: "Parallel", "Paralela";
    parallel_hint: "Projectors are parallel to DOP. The size at PF is kept. [0] (5.15)", "Os projetores são paralelos a DOP. O tamanho em PF se mantém. [0] (5.15)";
    view_angle: "view angle", "ângulo de vista";
    view_angle_hint: "θ, vertical: H = 2 F tan(θ/2). [0] (5.5)", "θ, vertical: H = 2 F tan(θ/2). [0] (5.5)";
    height: "window height", "altura da janela";
    height_hint: "H of the view window", "H da janela de vista";
    aspect: "aspect", "aspecto";
    aspect_hint: "A = W / H. [0] (5.1)", "A = W / H. [0] (5.1)";
    near: "front plane", "plano da frente";
    near_hint: "F: distance of the front clipping plane, which is the view plane too. [0] §5.2", "F: distância do plano de recorte da frente, que é também o plano de vista. [0] §5.2";
    far: "back plane", "plano de fundo";
    far_hint: "B: distance of the back clipping plane. [0] §5.2", "B: distância do plano de recorte de fundo. [0] §5.2";
    window: "View window", "Janela de vista";
    symmetric: "Symmetric", "Simétrica";
    symmetric_hint: "On: the window follows from the angle (or H) and A. Off: l, r, b and t are free. [0] §5.3.2", "Ligado: a janela vem do ângulo (ou de H) e de A. Desligado: l, r, b e t são livres. [0] §5.3.2";
    left: "left", "esquerda";
    right: "right", "direita";
    bottom: "bottom", "baixo";
    top: "top", "topo";
    side_hint: "In scene units on the plane z_c = −F. [0] (5.13)", "Em unidades da cena no plano z_c = −F. [0] (5.13)";
    image: "Image", "Imagem";
    image_size: "pixels", "pixels";
    image_width: "width", "largura";
    image_height: "height (image)", "altura (imagem)";
    image_size_hint: "m × n pixels. [0] (5.22)", "m × n pixels. [0] (5.22)";
    aspect_follows: "A follows the image", "A segue a imagem";
    aspect_follows_hint: "Keeps A = m / n, so that pixels are square", "Mantém A = m / n, para que os pixels sejam quadrados";
    viewport: "Viewport", "Viewport";
    whole_image: "The whole image", "A imagem toda";
    whole_image_hint: "glViewport covers the image, depth 0 … 1. [0] (5.24), (5.25)", "glViewport cobre a imagem, profundidade 0 … 1. [0] (5.24), (5.25)";
    viewport_corner: "corner", "canto";
    viewport_size: "size", "tamanho";
    viewport_hint: "glViewport: lower left corner, width and height. [0] (5.24)", "glViewport: canto inferior esquerdo, largura e altura. [0] (5.24)";
    depth_range: "depth range", "profundidade";
    depth_range_hint: "glDepthRange: Z for z_n = −1 and for z_n = 1. [0] (5.25)", "glDepthRange: Z para z_n = −1 e para z_n = 1. [0] (5.25)";
    scene: "Scene", "Cena";
    preset: "named scene", "cena pronta";
    preset_hint: "What the camera looks at, besides the objects of your own", "O que a câmera olha, além dos seus próprios objetos";
    scene_empty: "none", "nenhuma";
    scene_primitives: "primitives", "primitivas";
    scene_cube: "cube", "cubo";
    scene_house: "house", "casa";
    scene_corridor: "corridor", "corredor";
    scene_pyramid: "pyramid", "pirâmide";
    scene_ndc_cube: "NDC cube", "cubo NDC";
    scene_exercise_51: "exercise 5.1", "exercício 5.1";
    scene_exercise_52: "exercise 5.2", "exercício 5.2";
    scene_exercise_53: "exercise 5.3", "exercício 5.3";
    style: "Style", "Estilo";
    shading: "faces", "faces";
    shading_hint: "How faces are coloured", "Como as faces são coloridas";
    shading_wireframe: "wireframe", "aramado";
    shading_flat: "flat", "constante";
    shading_gouraud: "Gouraud", "Gouraud";
    shading_phong: "Phong", "Phong";
    visibility: "hidden faces", "faces ocultas";
    visibility_hint: "How it is decided which face is seen. The painter goes by centroids, and fails where faces overlap in a circle [2], [3]", "Como se decide qual face é vista. O pintor vai pelos centroides, e falha onde faces se sobrepõem em círculo [2], [3]";
    visibility_depth_buffer: "depth buffer", "z-buffer";
    visibility_painter: "painter", "pintor";
    visibility_bsp: "BSP tree", "árvore BSP";
    hidden_lines: "hidden lines", "linhas ocultas";
    hidden_lines_hint: "Parts of lines that lie behind faces", "Partes de linhas atrás de faces";
    hidden_dashed: "dashed", "tracejadas";
    hidden_hidden: "hidden", "ocultas";
    hidden_shown: "shown", "visíveis";
    antialias: "samples", "amostras";
    antialias_hint: "Samples per pixel: more is smoother and slower", "Amostras por pixel: mais é mais suave e mais lento";
    theme_name: "theme", "tema";
    theme_name_hint: "The ground of the pictures and of the window", "O fundo das imagens e da janela";
    theme_light: "light", "claro";
    theme_dark: "dark", "escuro";
    theme_print: "print", "impressão";

    // What is revealed of the pipeline.
    reveal: "Inside the pipeline", "Por dentro do pipeline";
    depth_view: "image", "imagem";
    depth_view_hint: "The depth buffer in the place of the colours: black is near, white is far. Perspective crowds Z near 1. Point at a pixel: its numbers stand below. [0] (5.25), [2] z-buffer", "O z-buffer no lugar das cores: preto é perto, branco é longe. A perspectiva comprime Z perto de 1. Aponte para um pixel: seus números aparecem embaixo. [0] (5.25), [2] z-buffer";
    depth_off: "colours", "cores";
    depth_stored: "depths (Z)", "profundidades (Z)";
    depth_linear: "distances", "distâncias";
    outside_view: "outside", "fora";
    outside_view_hint: "Parts of the scene outside the view volume, in the world and in the canonical volume. [2] clipping, [0] §5.3", "Partes da cena fora do volume de vista, no mundo e no volume canônico. [2] clipping, [0] §5.3";
    outside_usual: "as usual", "como sempre";
    outside_cut: "cut", "cortado";
    outside_tinted: "tinted", "tingido";
    outside_shown: "shown", "à vista";
    clipping_view: "Vertices of clipping", "Vértices do recorte";
    clipping_view_hint: "Marks the vertices that clipping makes, in all three pictures. Point at a vertex: its outcode and its six distances w ± x, w ± y, w ± z stand below. [2] clipping in homogeneous coordinates", "Marca os vértices que o recorte cria, nas três imagens. Aponte para um vértice: seu outcode e suas seis distâncias w ± x, w ± y, w ± z aparecem embaixo. [2] clipping em coordenadas homogêneas";
    culled_view: "What is culled", "O que é descartado";
    culled_view_hint: "Tints in the world the faces that turn their back to the camera, and the objects that are dropped whole because they are outside a plane of the volume: the camera draws neither. [2] back faces, [3] §1.1", "Tinge no mundo as faces de costas para a câmera e os objetos descartados inteiros por estarem fora de um plano do volume: a câmera não os desenha. [2] faces de trás, [3] §1.1";
    divide_first: "Divide before clipping", "Dividir antes de recortar";
    divide_first_hint: "Wrong on purpose: what lies behind the eye has w < 0, and the divide by w turns it over to the front. Canonical volume and image show what comes of it, in red. [2] the problem of clipping", "Errado de propósito: o que está atrás do olho tem w < 0, e a divisão por w o vira para a frente. O volume canônico e a imagem mostram o que resulta, em vermelho. [2] problema do clipping";

    // Files.
    open_title: "Open a figure", "Abrir uma figura";
    open_action: "Open", "Abrir";
    save_title: "Save the figure", "Salvar a figura";
    save_action: "Save", "Salvar";
    export_title: "Write the picture", "Gravar a imagem";
    figure_filter: "Figure, or picture with a figure in it", "Figura, ou imagem com uma figura dentro";
    picture_filter: "PNG picture", "Imagem PNG";
    untitled_file: "figure.toml", "figura.toml";
    path_text: "There is no file dialog on this system. Which file?", "Não há diálogo de arquivos neste sistema. Qual arquivo?";
    path_name: "file", "arquivo";
    path_hint: "folder/name", "pasta/nome";
    cancel: "Cancel", "Cancelar";
    unsaved_title: "Save the changes?", "Salvar as mudanças?";
    unsaved_text: "Changes have not been saved:", "Há mudanças que não foram salvas:";
    dont_save: "Don't save", "Não salvar";
    save_first: "Save", "Salvar";
    overwrite_title: "Replace the file?", "Substituir o arquivo?";
    overwrite_text: "is there already.", "já existe.";
    replace: "Replace", "Substituir";
    opened: "Opened:", "Aberto:";
    saved: "Saved:", "Salvo:";
    exporting: "Drawing the picture…", "Desenhando a imagem…";
    restored: "The last session is back: it had not been saved.", "A última sessão voltou: ela não tinha sido salva.";
    copied: "Copied.", "Copiado.";
    picture_too_large: "There is no memory for a picture of this size.", "Não há memória para uma imagem deste tamanho.";
    export_heading: "Export pictures", "Exportar imagens";
    export_what: "pictures", "imagens";
    export_all: "all three", "as três";
    export_size: "size", "tamanho";
    export_size_hint: "As many times as large as on the screen, or as typed", "Tantas vezes o tamanho na tela, ou como digitado";
    export_typed: "typed", "digitado";
    export_pixels: "pixels", "pixels";
    export_width: "picture width", "largura da imagem";
    export_height: "picture height", "altura da imagem";
    export_theme_hint: "print: white ground and strokes that survive greyscale", "impressão: fundo branco e traços que sobrevivem a tons de cinza";
    export_note: "The figure goes with the picture: opening or dropping the PNG brings it back.", "A figura vai com a imagem: abrir ou soltar o PNG a traz de volta.";
    export_action: "Export…", "Exportar…";
    drop_here: "Drop it here to open it", "Solte aqui para abrir";

    // Operations.
    operations: "Operations", "Operações";
    elevation: "Elevation", "Elevação";
    elevation_effect: "C, VUP about u through PF", "C, VUP em torno de u por PF";
    azimuth: "Azimuth", "Azimute";
    azimuth_effect: "C, VUP about v through PF", "C, VUP em torno de v por PF";
    roll: "Roll", "Rolagem";
    roll_effect: "VUP about n", "VUP em torno de n";
    yaw: "Yaw", "Guinada";
    yaw_effect: "PF, VUP about v through C", "PF, VUP em torno de v por C";
    pitch: "Pitch", "Arfagem";
    pitch_effect: "PF, VUP about u through C", "PF, VUP em torno de u por C";
    zoom: "Zoom", "Zoom";
    zoom_effect: "l, r, b, t divided by s", "l, r, b, t divididos por s";
    dolly: "Dolly", "Aproximação";
    dolly_effect: "C towards PF: D divided by s", "C rumo a PF: D dividida por s";
    pan_u: "Pan along u", "Pan em u";
    pan_u_effect: "C, PF along u", "C, PF ao longo de u";
    pan_v: "Pan along v", "Pan em v";
    pan_v_effect: "C, PF along v", "C, PF ao longo de v";
    step: "step", "passo";
    step_hint: "What the buttons − and + do at once", "O que os botões − e + fazem de uma vez";
    scrub: "slider", "controle";
    scrub_hint: "Pull it: the camera moves from where it is; let go: it stays there", "Puxe: a câmera se move de onde está; solte: ela fica lá";
    vtk: "Signs of VTK", "Sinais do VTK";
    vtk_hint: "VTK turns elevation and roll the other way. Here a positive angle is counter-clockwise seen from the tip of the axis", "O VTK gira elevação e rolagem ao contrário. Aqui um ângulo positivo é anti-horário visto da ponta do eixo";

    // Numbers.
    numbers: "Numbers", "Números";
    digits: "digits", "dígitos";
    digits_hint: "Significant digits, 2 to 17; 17 shows every number exactly", "Dígitos significativos, 2 a 17; 17 mostra cada número exatamente";
    inverse: "inverses", "inversas";
    inverse_hint: "The inverse matrices", "As matrizes inversas";
    copy: "Copy", "Copiar";
    dop_name: "direction and distance (5.2)", "direção e distância (5.2)";
    basis_name: "basis of the VRC (5.3)", "base do VRC (5.3)";
    window_name: "view window (5.1), (5.5)", "janela de vista (5.1), (5.5)";
    view_name: "view matrix (5.7)", "matriz de vista (5.7)";
    projection_name: "projection matrix (5.13), (5.15)", "matriz de projeção (5.13), (5.15)";
    product_name: "world to clip coordinates (5.8)", "do mundo ao recorte (5.8)";
    inverse_view_name: "inverse of the view matrix", "inversa da matriz de vista";
    inverse_projection_name: "inverse of the projection matrix", "inversa da matriz de projeção";
    corners_name: "corners of the view volume, world", "cantos do volume de vista, mundo";
    warnings: "Warnings", "Avisos";

    // Number fields.
    number_field_hint: "Drag, or click and type: 1/3, sqrt(2)/2, 45°", "Arraste, ou clique e digite: 1/3, sqrt(2)/2, 45°";

    // Repairs.
    repair_focal_point: "Put PF ahead again", "Pôr PF de novo à frente";
    repair_view_up: "VUP =", "VUP =";
    repair_swap_near_far: "Swap F and B", "Trocar F e B";
    repair_far: "B = 10 F", "B = 10 F";
    repair_angle: "θ =", "θ =";
    repair_sides: "Swap them", "Trocar";
    repair_back: "Back to the last possible value", "Voltar ao último valor possível";
}
