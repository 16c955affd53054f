//! The words of the photograph under the image, and of the tool that finds its camera, in both languages.

use crate::camera::WorldAxis;
use crate::i18n::Lang;

texts! {
    photograph: "photograph", "fotografia";
    hint: "A photograph that fills the image, under the scene", "Uma fotografia que preenche a imagem, sob a cena";
    choose: "Choose…", "Escolher…";
    choose_title: "Choose a photograph", "Escolher uma fotografia";
    choose_action: "Choose", "Escolher";
    remove: "Remove the photograph", "Remover a fotografia";
    opacity: "opacity", "opacidade";
    opacity_hint: "Of the photograph over the background, 0 … 1", "Da fotografia sobre o fundo, 0 … 1";
    size: "Take its size", "Usar seu tamanho";
    size_hint: "Makes m × n the size of the photograph, so that it isn't stretched", "Faz de m × n o tamanho da fotografia, para que ela não seja esticada";
    find: "Find its camera…", "Achar sua câmera…";
    find_hint: "Draw lines on the photograph along the axes of the world. They give θ, R and, with a known length, C", "Desenhe retas na fotografia ao longo dos eixos do mundo. Elas dizem θ, R e, com um comprimento conhecido, C";
    find_first: "Choose a photograph first", "Escolha antes uma fotografia";
    title: "The camera of the photograph", "A câmera da fotografia";
    how: "Draw lines on the image along edges that are parallel to an axis of the world, from the smaller coordinate to the larger. Two axes need two lines each.", "Desenhe retas na imagem ao longo de arestas paralelas a um eixo do mundo, da coordenada menor para a maior. Dois eixos precisam de duas retas cada um.";
    draw: "Draw:", "Desenhar:";
    line: "line along", "reta ao longo de";
    line_hint: "Drag on the image to draw a line. Drag its ends, or move them with the arrow keys. Delete removes it. A line may begin at an end of a line along another axis", "Arraste na imagem para desenhar uma reta. Arraste as pontas, ou mova-as com as setas. Delete a remove. Uma reta pode começar na ponta de outro eixo";
    origin: "origin", "origem";
    origin_hint: "Click the origin of the world: the direction to C", "Clique na origem do mundo: a direção até C";
    known: "length", "comprimento";
    known_hint: "Click a point on an axis, and give its coordinate: the distance of C", "Clique num ponto de um eixo e dê sua coordenada: a distância de C";
    coordinate: "Coordinate of that point", "Coordenada desse ponto";
    along: "Axis of that point", "Eixo desse ponto";
    beside: "Two images stand side by side. End the comparison to draw lines.", "Há duas imagens lado a lado. Termine a comparação para desenhar retas.";
    take: "Use this camera", "Usar esta câmera";
    take_hint: "Makes it the camera of the figure. Undo brings the old one back", "Faz dela a câmera da figura. Desfazer traz de volta a antiga";
    clear: "Remove the lines", "Remover as retas";
}

/// The name of an end of a line: its number from 1 and its axis, and true for the first end.
pub fn end(lang: Lang, (number, axis): (usize, WorldAxis), is_first: bool) -> String {
    let axis = axis.name();
    if is_first {
        both!(lang; "Line {number} along {axis}: beginning", "Reta {number} ao longo de {axis}: começo")
    } else {
        both!(lang; "Line {number} along {axis}: end", "Reta {number} ao longo de {axis}: fim")
    }
}

/// A point on an axis with its coordinate: x = 2.
pub fn length(lang: Lang, (axis, coordinate): (WorldAxis, f64)) -> String {
    format!("{} = {}", axis.name(), lang.mark().number(coordinate, 4))
}

/// The count of lines along each axis.
pub fn counts(lang: Lang, [x, y, z]: [usize; 3]) -> String {
    both!(lang; "Lines along x: {x}, y: {y}, z: {z}", "Retas ao longo de x: {x}, y: {y}, z: {z}")
}

/// The size of the photograph.
pub fn size(lang: Lang, [width, height]: [u32; 2]) -> String {
    both!(lang; "{width} × {height} pixels: it is stretched", "{width} × {height} pixels: está esticada")
}
