//! The words of the gallery: its parts, and the headings of the built-in figures.

use crate::files::Topic;
use crate::i18n::Lang;

texts! {
    // Title.
    gallery: "Gallery", "Galeria";
    // Its parts.
    examples: "Examples", "Exemplos";
    recent: "Recent", "Recentes";
    folder: "Folder", "Pasta";
    // A button.
    choose: "Choose a folder…", "Escolher uma pasta…";
    // The question for the path of a folder.
    which_folder: "Which folder?", "Qual pasta?";
    // The actions of the keys.
    keys: "Arrows: choose · Enter: open · Ctrl+Tab: next part · Esc: close", "Setas: escolher · Enter: abrir · Ctrl+Tab: parte seguinte · Esc: fechar";
    // The same if there is one part.
    keys_of_one: "Arrows: choose · Enter: open · Esc: close", "Setas: escolher · Enter: abrir · Esc: fechar";
    // A button, if there is nothing to show.
    no_recent: "Nothing has been opened or saved yet.", "Nada foi aberto ou salvo ainda.";
    no_folder: "You haven't chosen a folder. This list shows the open figure's folder, or one that you choose.", "Você não escolheu uma pasta. Aqui aparece a da figura aberta, ou uma que você escolher.";
    empty_folder: "There are no figure files (.toml) in this folder.", "Não há arquivos de figura (.toml) nesta pasta.";
    // For a file.
    gone: "no longer exists", "não existe mais";
    // Headings.
    camera: "The camera", "A câmera";
    cube: "Projection and the cube", "Projeção e o cubo";
    clipping: "Clipping and dividing", "Recorte e divisão";
    hidden: "Hidden surfaces and depth", "Faces ocultas e profundidade";
    light: "Light, textures and shadows", "Luz, texturas e sombras";
    exercises: "Exercises", "Exercícios";
    limits: "Limits of numbers", "Limites dos números";
    // A field for words of titles and captions.
    wanted: "Search the cards", "Pesquisar nos cartões";
    nothing: "No card has these words. Try fewer letters, or another name for it.", "Nenhum cartão tem estas palavras. Tente menos letras, ou outro nome.";
    // A button if nothing goes wrong, before the title of a figure in which something does.
    shows: "Open the figure that shows it:", "Abrir a figura que mostra isso:";
    // Before the number of hidden files.
    more: "more files:", "outros arquivos:";
}

/// The heading of a topic.
pub fn heading(lang: Lang, topic: Topic) -> &'static str {
    let t = texts(lang);
    match topic {
        Topic::Camera => t.camera,
        Topic::Cube => t.cube,
        Topic::Clipping => t.clipping,
        Topic::Hidden => t.hidden,
        Topic::Light => t.light,
        Topic::Exercises => t.exercises,
        Topic::Limits => t.limits,
    }
}
