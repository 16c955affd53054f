//! The words of the mode *Labels*, in both languages.

use crate::figure::labels::LabelTextError;
use crate::i18n::Lang;
use crate::i18n::messages::figure_files;
use crate::limits::MAX_LABEL_TEXT;
use crate::sanitize::escaped;

texts! {
    command_hint: "Labels can be dragged, renamed and hidden, and annotations added", "Os rótulos podem ser arrastados, renomeados e ocultos, e anotações adicionadas";
    title: "Labels", "Rótulos";
    choose: "label", "rótulo";
    choose_hint: "The label to change. A click on it chooses it too", "O rótulo a mudar. Um clique nele também o escolhe";
    none: "none", "nenhum";
    text: "text", "texto";
    text_hint: "Symbols stand between dollar signs: $\\theta/2$, $x_c$, $\\mathbf{u}$", "Símbolos ficam entre cifrões: $\\theta/2$, $x_c$, $\\mathbf{u}$";
    size: "size", "tamanho";
    smaller: "smaller", "menor";
    larger: "larger", "maior";
    color: "colour", "cor";
    hide: "Hide", "Ocultar";
    hide_legend: "Hide the legend", "Ocultar a legenda";
    legend_hint: "Hides all of it. Dragging one of its lines moves all of it", "Oculta-a inteira. Arrastar uma das linhas a move inteira";
    delete: "Delete", "Excluir";
    automatic: "Automatic again", "Automático de novo";
    automatic_hint: "The label gets its original text, place, size and colour back. An annotation keeps its text", "O rótulo volta a ter o próprio texto, lugar, tamanho e cor. Uma anotação conserva o texto";
    all_automatic: "All automatic again", "Todos automáticos de novo";
    all_automatic_hint: "All labels get their original texts and places back. Annotations stay", "Todos os rótulos voltam a ter os próprios textos e lugares. As anotações ficam";
    hidden: "hidden:", "ocultos:";
    show_again: "Shows the label again", "Mostra o rótulo de novo";
    add: "Add an annotation", "Adicionar anotação";
    add_hint: "A click puts it at a vertex, an edge, a point, or at any place of the view. Enter in a view puts it at its centre", "Um clique a põe em um vértice, uma aresta, um ponto ou um lugar da vista. Enter em uma vista a põe no centro dela";
    adding: "Click to place the annotation, or press Esc to cancel", "Clique para pôr a anotação, ou aperte Esc para desistir";
    note: "annotation", "anotação";
    full: "There is no room for more annotations", "Não há lugar para mais anotações";
    measures: "measures:", "medidas:";
    measures_hint: "Shows this length or angle in the world", "Mostra este comprimento ou ângulo no mundo";
    shown: "shown as", "mostrar";
    symbol: "symbol", "símbolo";
    value: "value", "valor";
    both: "both", "ambos";
    mathematics: "letters of mathematics", "letras de matemática";
    mathematics_hint: "Symbols as in the explanations, with vectors bold and others in italics", "Símbolos como nas explicações, com vetores em negrito e outros em itálico";
    leave: "Done", "Concluir";
    idle: "Drag a label · click: choose · arrow keys: move the chosen one · Esc: done", "Arraste um rótulo · clique: escolher · setas: mover o escolhido · Esc: concluir";

}

/// The reason why a text can't be that of a label.
pub fn refused(lang: Lang, error: &LabelTextError) -> String {
    match error {
        LabelTextError::Length => both!(lang; "A label has 1 to {MAX_LABEL_TEXT} characters on one line.",
            "Um rótulo tem de 1 a {MAX_LABEL_TEXT} caracteres em uma linha."),
        LabelTextError::Formula(error) => both!(lang; "The text {}.",
            "O texto {}."; figure_files::formula(lang, error)),
    }
}

/// A name in `[labels]` that no label has.
pub fn unknown(lang: Lang, name: &str, near: Option<&str>) -> String {
    let name = escaped(name);
    let meant = figure_files::meant(lang, near);
    both!(lang; "[labels] names \"{name}\", which no label of the views is called{meant}",
        "[labels] cita \"{name}\", nome que nenhum rótulo das vistas tem{meant}")
}
