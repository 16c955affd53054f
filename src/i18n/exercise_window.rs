//! What the window says about exercises, besides the exercises themselves.

use super::Lang;

texts! {
    search: "Search the exercises", "Procurar nos exercícios";
    search_hint: "Words of the title, of the source or of the identifier. Enter opens the first", "Palavras do título, da fonte ou do identificador. Enter abre o primeiro";
    none_found: "No exercise says that.", "Nenhum exercício diz isso.";
    of_the_notes: "The notes' own", "Das notas de aula";
    families: "Families: new numbers as often as you like", "Famílias: números novos quantas vezes quiser";
    untouched: "untouched", "intocado";
    begun: "begun", "começado";
    solved: "solved", "resolvido";
    practise_next: "Practise next", "Praticar o próximo";
    practise_next_hint: "What shows the mistake that you made most often, else the first that is not solved, else the one tried longest ago; the reason is said", "O que mostra o erro que você mais cometeu, senão o primeiro não resolvido, senão o tentado há mais tempo; o motivo é dito";
    new_numbers: "New numbers", "Números novos";
    new_numbers_hint: "The same exercise with the numbers of the next seed; what was typed for these stays", "O mesmo exercício com os números da próxima semente; o que foi digitado para estes fica";
    back: "Back to the list", "Voltar à lista";
    seed_hint: "The numbers come from it: the same seed gives the same exercise, here and with `camera-lab exercise show`", "Dela vêm os números: a mesma semente dá o mesmo exercício, aqui e com `camera-lab exercise show`";
    how_it_is_read: "How it is read", "Como se entende";
    free_numbers: "Numbers left open", "Números deixados em aberto";
    free_hint: "Choose your own; answers may also be formulas in it", "Escolha os seus; respostas também podem ser fórmulas nele";
    free_wrong: "a number greater than 0", "um número maior que 0";
    show_figure: "Show the figure", "Mostrar a figura";
    show_figure_hint: "Puts the figure of the exercise into the pictures, with its points and their names. Undo (Ctrl+Z) brings your own figure back; saving asks for a file, so that yours stays as it is", "Põe a figura do exercício nas imagens, com seus pontos e nomes. Desfazer (Ctrl+Z) traz a sua figura de volta; salvar pergunta por um arquivo, e o seu fica como está";
    figure_later: "The figure is shown once you have answered.", "A figura é mostrada depois que você responder.";
    do_operations: "Do its operations", "Fazer as operações";
    do_operations_hint: "Puts the camera as it is after the operations of the exercise into the pictures, as one step", "Põe nas imagens a câmera como fica depois das operações do exercício, num passo só";
    your_answer: "Your answer", "Sua resposta";
    answer_hint: "A number or an expression: 1/sqrt(3), 2/3, 45°, 0,5. Enter goes on to what is empty, and then checks", "Um número ou uma expressão: 1/sqrt(3), 2/3, 45°, 0,5. Enter segue para o que está vazio, e depois confere";
    first_field_hint: "A number or an expression: 1/sqrt(3), 2/3, 45°, 0,5; or the whole answer in brackets: [a, b, c] or [[a, b], [c, d]]. Enter goes on to what is empty, and then checks", "Um número ou uma expressão: 1/sqrt(3), 2/3, 45°, 0,5; ou a resposta inteira entre colchetes: [a; b; c] ou [[a; b]; [c; d]]. Enter segue para o que está vazio, e depois confere";
    camera_hint: "position=[0, 0, 2]; projection=parallel; … as in a figure file; or take the camera that is set", "position=[0, 0, 2]; projection=parallel; … como num arquivo de figura; ou use a câmera que está ajustada";
    take_camera: "Take the camera that is set", "Usar a câmera ajustada";
    take_camera_hint: "The camera of the window becomes your answer", "A câmera da janela passa a ser sua resposta";
    other_figure: "The pictures show another figure; “Show the figure”, above, puts this exercise's there.", "As imagens mostram outra figura; “Mostrar a figura”, acima, põe ali a deste exercício.";
    understood: "understood as", "entendido como";
    check: "Check", "Conferir";
    check_hint: "Judges this answer (Ctrl+Enter in one of its fields). What cannot be read costs nothing", "Julga esta resposta (Ctrl+Enter num de seus campos). O que não pode ser lido não custa nada";
    right: "right", "certo";
    wrong: "wrong", "errado";
    right_read_as: "right, read as", "certo, entendido como";
    changed_since: "This was said of the answer before; check again.", "Isto foi dito da resposta anterior; confira de novo.";
    hint: "Hint", "Dica";
    next_hint: "A hint", "Uma dica";
    stronger_hint: "A stronger hint", "Uma dica mais forte";
    hint_hint: "One at a time, weaker ones first", "Uma por vez, primeiro as mais fracas";
    first_step: "A worked step", "Um passo resolvido";
    next_step: "The next step", "O próximo passo";
    step_hint: "The way to the answer with every number, step by step", "O caminho à resposta com cada número, passo a passo";
    show_camera: "Show the camera of your answer", "Mostrar a câmera da sua resposta";
    show_camera_hint: "Draws the camera that your answer describes beside the right one, in the world. Esc takes it away", "Desenha a câmera que sua resposta descreve ao lado da certa, no mundo. Esc a retira";
    hide_camera: "Take the camera of your answer away", "Retirar a câmera da sua resposta";
    no_camera: "No camera has this", "Nenhuma câmera tem isto";
    own_open: "Open a folder of exercises…", "Abrir uma pasta de exercícios…";
    own_open_hint: "A lecturer's own exercises, one TOML file each; they stand below the others, and the folder is remembered", "Exercícios de um professor, um arquivo TOML para cada; ficam abaixo dos outros, e a pasta é lembrada";
    own_again: "Read it again", "Ler de novo";
    own_again_hint: "Its files may have changed since", "Seus arquivos podem ter mudado";
    own_close: "Close the folder", "Fechar a pasta";
    own_close_hint: "Its exercises leave the list; what was done with them is kept", "Seus exercícios saem da lista; o que foi feito com eles fica guardado";
    own_passed_over: "Passed over in the folder", "Deixados de lado na pasta";
    own_none: "no exercises (files that end with .toml)", "sem exercícios (arquivos que terminam em .toml)";
    progress: "Progress", "Progresso";
    progress_kept_in: "Kept in this file, which you may read, copy or delete:", "Guardado neste arquivo, que você pode ler, copiar ou apagar:";
    progress_not_kept: "Kept until the window closes.", "Guardado até a janela fechar.";
    no_mistakes: "No known mistake so far.", "Nenhum erro conhecido até agora.";
    mistakes: "Known mistakes, and how often", "Erros conhecidos, e quantas vezes";
    mended: "Solved since without it", "Resolvido depois sem ele";
    export_progress: "Export as CSV…", "Exportar como CSV…";
    export_title: "Export progress", "Exportar o progresso";
    export_progress_hint: "A table for spreadsheets: a row for each exercise and each known mistake", "Uma tabela para planilhas: uma linha por exercício e por erro conhecido";
    progress_file: "progress.csv", "progresso.csv";
    delete_progress: "Delete progress", "Apagar o progresso";
    delete_progress_hint: "Asks first", "Pergunta antes";
    delete_progress_text: "What you typed, what is solved, and the mistakes are forgotten. The file stays as progress.bak beside it until you delete progress again; to have it back, close the program and rename it to progress.toml.", "O que você digitou, o que está resolvido e os erros são esquecidos. O arquivo fica como progress.bak ao lado até você apagar o progresso de novo; para tê-lo de volta, feche o programa e renomeie-o para progress.toml.";
    all_right: "All of it is right.", "Tudo está certo.";
}

/// What a button does, for what is asked: screen readers hear which one of several it is.
#[must_use]
pub fn of_ask(what: &str, ask: &str) -> String {
    format!("{what}: {ask}")
}

/// A field of a vector or a matrix; rows and columns from 0.
#[must_use]
pub fn field(lang: Lang, ask: &str, [rows, columns]: [usize; 2], [row, column]: [usize; 2]) -> String {
    let (i, j) = (row + 1, column + 1);
    match (lang, rows, columns) {
        (_, 1, 1) => ask.to_owned(),
        (_, _, 1) => format!("{ask} {i}"),
        (Lang::En, ..) => format!("{ask} row {i}, column {j}"),
        (Lang::PtBr, ..) => format!("{ask} linha {i}, coluna {j}"),
    }
}

/// An answer is not an axis: it is longer or shorter than 1.
#[must_use]
pub fn axis_length(lang: Lang, length: f64) -> String {
    let length = lang.mark().number(length, 4);
    match lang {
        Lang::En => format!("your vector has the length {length}; an axis of a camera has the length 1"),
        Lang::PtBr => format!("seu vetor tem comprimento {length}; um eixo de uma câmera tem comprimento 1"),
    }
}

/// An answer is not an axis: its scalar product with **n** is not 0.
#[must_use]
pub fn axis_oblique(lang: Lang, product: f64) -> String {
    let product = lang.mark().number(product, 4);
    match lang {
        Lang::En => format!("your vector is not perpendicular to n: their scalar product is {product}, not 0"),
        Lang::PtBr => format!("seu vetor não é perpendicular a n: o produto escalar deles é {product}, não 0"),
    }
}
