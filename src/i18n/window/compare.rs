//! The words of the dialog that compares a figure with itself in another way, and of the wiper, in both languages.

use crate::figure::FigureError;
use crate::i18n::{Lang, messages};

texts! {
    command: "Compare…", "Comparar…";
    command_hint: "The figure in two versions in one view, with a divider between them", "A figura em duas versões na mesma vista, com um divisor entre elas";
    title: "Compare two versions", "Comparar duas versões";
    text: "Left of the divider you see the figure as it is, right of it the other version. Drag the divider in the view.", "À esquerda do divisor está a figura como ela é, à direita a outra versão. Arraste o divisor na vista.";
    keep: "Keep this camera as A", "Guardar esta câmera como A";
    keep_hint: "Go on with the camera, and compare it with this one later", "Siga com a câmera e compare-a depois com esta";
    keep_short: "Keep as A", "Guardar como A";
    with_a: "with A", "com A";
    with_a_hint: "This camera and camera A; F4 swaps them", "Esta câmera e a câmera A; F4 as troca";
    with_a_none: "No camera has been kept as A yet", "Nenhuma câmera foi guardada como A ainda";
    with_file: "another file…", "outro arquivo…";
    with_file_hint: "The camera and the drawing style of another figure file", "A câmera e o estilo de desenho de outro arquivo de figura";
    with_saved: "as saved", "como salva";
    with_saved_hint: "The figure as it was opened or saved last", "A figura como foi aberta ou salva por último";
    with_saved_none: "Nothing has changed since then", "Nada mudou desde então";
    kept: "This camera is A now: F4 compares and swaps", "Esta câmera agora é A: F4 compara e troca";
    no_sides: "Nothing is compared, and no camera has been kept as A", "Nada está sendo comparado, e nenhuma câmera foi guardada como A";
    swap_command_hint: "Swaps the two sides of a comparison. Without one, compares with camera A", "Troca os dois lados de uma comparação. Sem uma, compara com a câmera A";
    nothing: "nothing", "nada";
    visibility_painter: "painter | depth buffer", "pintor | z-buffer";
    visibility_bsp: "BSP | depth buffer", "BSP | z-buffer";
    shading: "flat | Phong", "constante | Phong";
    projection: "parallel | perspective", "paralela | perspectiva";
    convention: "OpenGL | Direct3D", "OpenGL | Direct3D";
    depth: "depth of 16 bits | f32 reversed", "profundidade de 16 bits | f32 invertido";
    angle: "θ", "θ";
    angle_hint: "The view angle of the other version", "O ângulo de vista da outra versão";
    angle_none: "A parallel camera or one with a free window has no θ", "Uma câmera paralela ou de janela livre não tem θ";
    operation: "before | after", "antes | depois";
    operation_hint: "An operation as on the command line, such as azimuth=30, zoom=2 or pan=1,-0.5", "Uma operação como na linha de comando, tal como azimuth=30, zoom=2 ou pan=1,-0.5";
    key: "key = value", "chave = valor";
    key_hint: "A key of figure files, and its value in the other version, such as camera.near = 0.5, style.antialias = 1, reveal.depth = \"linear\"", "Uma chave dos arquivos de figura, e o valor dela na outra versão, como camera.near = 0.5, style.antialias = 1, reveal.depth = \"linear\"";
    differences: "mark differences", "marcar diferenças";
    differences_hint: "Hatches the pixels in which the two sides differ, and counts them", "Hachura os pixels em que os dois lados diferem, e os conta";
    beside: "two whole views", "duas vistas inteiras";
    beside_hint: "Two halves with a whole view each, without a divider", "Duas metades com uma vista inteira cada, sem divisor";
    swap: "Swap sides", "Trocar os lados";
    swap_hint: "The figure becomes the other version, and you compare it with the previous one", "A figura passa a ser a outra versão, comparada com a anterior";
    impossible: "The other version is impossible:", "A outra versão é impossível:";
    wiper: "divider between the two versions", "divisor entre as duas versões";
    format: "depth format", "formato de profundidade";
    format_hint: "The numbers in which the image stores depths. With few bits, planes that are close together fight for pixels (z-fighting), far from the eye first", "Os números em que a imagem guarda profundidades. Com poucos bits, planos próximos disputam pixels, primeiro longe do olho";
}

/// The reason why there is no other side.
pub fn impossible(lang: Lang, error: &FigureError) -> String {
    format!("{} {}", texts(lang).impossible, messages::without_line(lang, error))
}

/// The other figure has another scene.
pub fn other_scene(lang: Lang, file: &str) -> String {
    both!(lang; "{file} has another scene, so its camera is compared in this one", "{file} tem outra cena, e a câmera dele é comparada nesta")
}
