//! The words of the window about exercises, besides the exercises themselves.

use crate::i18n::Lang;

texts! {
    search: "Search the exercises", "Pesquisar nos exercícios";
    search_hint: "Words from the title, the source or the identifier. Enter opens the first", "Palavras do título, da fonte ou do identificador. Enter abre o primeiro";
    none_found: "No exercise matches.", "Nenhum exercício corresponde.";
    of_the_notes: "From the lecture notes", "Das notas de aula";
    families: "Families, with new numbers as often as you like", "Famílias, com números novos quantas vezes quiser";
    untouched: "not started", "não iniciado";
    begun: "in progress", "em andamento";
    solved: "answered", "respondido";
    alone: "answered without help, on new numbers", "respondido sem ajuda com números novos";
    many_wrong: "Several wrong answers in a row. The lesson may help more than another try, or other numbers:", "Várias respostas erradas seguidas. A lição pode ajudar mais que outra tentativa, ou outros números:";
    practise_next: "Practise next", "Praticar o próximo";
    practise_next_hint: "The exercise on your most frequent mistake, or else one you've begun, then one that is due again after 1, 3, 7 or 21 days, then the next one in the lessons. You see why", "O exercício sobre o seu erro mais frequente, senão o que você começou, senão o que volta depois de 1, 3, 7 ou 21 dias, senão o próximo das lições. Você vê por quê";
    new_numbers: "New numbers", "Números novos";
    new_numbers_hint: "The same exercise with the numbers of the next seed. Your answers for these are kept", "O mesmo exercício com os números da próxima semente. Suas respostas para estes são mantidas";
    back: "Back to the list", "Voltar à lista";
    seed_hint: "The numbers come from it. The same seed gives the same exercise, here and with `camera-lab exercise show`", "Os números vêm dela. A mesma semente dá o mesmo exercício, aqui e com `camera-lab exercise show`";
    how_it_is_read: "Assumptions", "Hipóteses";
    free_numbers: "Numbers left open", "Números deixados em aberto";
    free_hint: "Choose your own. Answers may also be formulas in them", "Escolha os seus. As respostas também podem ser fórmulas com eles";
    free_wrong: "a number greater than 0", "um número maior que 0";
    show_figure: "Show the figure", "Mostrar a figura";
    show_figure_hint: "Loads the exercise's figure into the views, with its points and their names. Undo (Ctrl+Z) brings your own figure back. Saving asks for a file name, so yours stays as it is", "Carrega nas vistas a figura do exercício, com seus pontos e nomes. Desfazer (Ctrl+Z) traz a sua figura de volta. Salvar pede um nome de arquivo, e a sua fica como está";
    figure_later: "The figure is shown once you have answered.", "A figura é mostrada depois que você responder.";
    operations_later: "They're applied once you've answered, because the question is about the camera afterwards.", "São aplicadas depois que você responder, pois a pergunta é sobre a câmera de depois.";
    do_operations: "Apply its operations", "Aplicar as operações";
    do_operations_hint: "Applies the operations of the exercise to the camera in the views, as one step", "Aplica à câmera das vistas as operações do exercício, num passo só";
    your_answer: "Your answer", "Sua resposta";
    answer_hint: "A number or an expression: 1/sqrt(3), 2/3, 45°, 0,5. Enter moves on to the next empty field, then checks", "Um número ou uma expressão: 1/sqrt(3), 2/3, 45°, 0,5. Enter passa ao próximo campo vazio, e depois confere";
    first_field_hint: "A number or an expression, such as 1/sqrt(3), 2/3, 45° or 0,5, or the whole answer in brackets, [a, b, c] or [[a, b], [c, d]]. Enter moves on to the next empty field, then checks", "Um número ou uma expressão, como 1/sqrt(3), 2/3, 45° ou 0,5, ou a resposta inteira entre colchetes, [a; b; c] ou [[a; b]; [c; d]]. Enter passa ao próximo campo vazio, e depois confere";
    camera_hint: "C=[7, −1, 4]; PF=[2, 1, 0]; θ=30°; F=0.5; …, or take the current camera", "C=[7; −1; 4]; PF=[2; 1; 0]; θ=30°; F=0,5; …, ou use a câmera atual";
    take_camera: "Take the current camera", "Usar a câmera atual";
    take_camera_hint: "The camera of the window becomes your answer", "A câmera da janela passa a ser sua resposta";
    other_figure: "The views show another figure; “Show the figure”, above, loads that of this exercise.", "As vistas mostram outra figura; “Mostrar a figura”, acima, carrega a deste exercício.";
    understood: "understood as", "entendido como";
    check: "Check", "Conferir";
    check_hint: "Checks this answer (Ctrl+Enter in one of its fields). An answer that cannot be read does not count", "Confere esta resposta (Ctrl+Enter num de seus campos). Uma resposta que não pode ser lida não conta";
    guess: "That's my guess", "Este é meu palpite";
    guess_hint: "Keeps your guess, which you can't change any more, and shows the image that answers the question", "Guarda seu palpite, que não muda mais, e mostra a imagem que responde à pergunta";
    what_seen: "What did you see?", "O que você viu?";
    and_now: "What do you say now?", "O que você diz agora?";
    where_seen: "Where is it now? Mark it again.", "Onde está agora? Marque de novo.";
    you_guessed: "You said", "Você disse";
    place_hint: "Click in *Image*, or drag the cross there. With the keyboard: Tab to *Image*, then the arrows (with Shift, ten pixels).", "Clique em *Imagem* ou arraste a cruz até lá. Com o teclado: Tab até *Imagem*, depois as setas (com Shift, dez pixels).";
    place_in_image: "Mark the place here", "Marque o lugar aqui";
    right: "right", "certo";
    wrong: "wrong", "errado";
    follows: "follows from a wrong answer", "decorre de uma resposta errada";
    right_read_as: "right, read as", "certo, entendido como";
    changed_since: "This is the result for your previous answer. Check again.", "Este é o resultado da resposta anterior. Confira de novo.";
    hint: "Hint", "Dica";
    next_hint: "A hint", "Uma dica";
    stronger_hint: "A stronger hint", "Uma dica mais forte";
    hint_hint: "One at a time, from weak to strong", "Uma por vez, da mais fraca à mais forte";
    first_step: "A worked step", "Um passo resolvido";
    next_step: "The next step", "O próximo passo";
    step_hint: "The solution with every number, step by step", "A resolução com cada número, passo a passo";
    your_step: "Your number for the last line", "Seu número para a última linha";
    your_step_hint: "You have solved this exercise before: each time, you do one more step yourself. A number or an expression", "Você já resolveu este exercício: a cada vez um passo a mais é seu. Um número ou uma expressão";
    check_step: "Check this step", "Conferir este passo";
    show_step: "Show it", "Mostrar";
    show_camera: "Show the camera of your answer", "Mostrar a câmera da sua resposta";
    show_camera_hint: "Draws the camera that your answer describes beside the right one, in the world. Esc removes it", "Desenha a câmera que sua resposta descreve ao lado da certa, no mundo. Esc a retira";
    hide_camera: "Hide the camera of your answer", "Ocultar a câmera da sua resposta";
    no_camera: "No camera has this", "Nenhuma câmera tem isto";
    own_open: "Open a folder of exercises…", "Abrir uma pasta de exercícios…";
    own_open_hint: "A lecturer's own exercises, one TOML file each. They're listed below the others, and the folder is remembered", "Exercícios de um professor, um arquivo TOML para cada. São listados abaixo dos outros, e a pasta é lembrada";
    own_again: "Read it again", "Ler de novo";
    own_again_hint: "Its files may have changed since", "Seus arquivos podem ter mudado";
    own_close: "Close the folder", "Fechar a pasta";
    own_close_hint: "Removes its exercises from the list. Your progress in them is kept", "Tira os exercícios da lista. Seu progresso neles é mantido";
    own_passed_over: "Skipped in the folder", "Ignorados na pasta";
    own_none: "no exercises (files that end in .toml)", "sem exercícios (arquivos que terminam em .toml)";
    progress: "Progress", "Progresso";
    progress_kept_in: "Stored in this file, which you may read, copy or delete:", "Guardado neste arquivo, que você pode ler, copiar ou apagar:";
    progress_not_kept: "Kept until the window closes.", "Guardado até a janela fechar.";
    no_mistakes: "No known mistake so far.", "Nenhum erro conhecido até agora.";
    mistakes: "Known mistakes, and how often", "Erros conhecidos, e quantas vezes";
    mended: "Solved since without it", "Resolvido depois sem ele";
    export_progress: "Export as CSV…", "Exportar como CSV…";
    export_title: "Export progress", "Exportar o progresso";
    export_progress_hint: "A table for spreadsheets, with a row for each exercise and each known mistake", "Uma tabela para planilhas, com uma linha por exercício e por erro conhecido";
    progress_file: "progress.csv", "progresso.csv";
    delete_progress: "Delete progress", "Excluir o progresso";
    delete_progress_hint: "Asks first", "Pergunta antes";
    delete_progress_text: "Your answers, solved exercises and mistakes are forgotten. The old file stays beside the new one as progress.bak until you delete progress again. To restore it, close the program and rename it to progress.toml.", "Suas respostas, os exercícios resolvidos e os erros são esquecidos. O arquivo antigo fica ao lado do novo como progress.bak até você apagar o progresso de novo. Para restaurá-lo, feche o programa e renomeie-o para progress.toml.";
    all_right: "Everything is right.", "Tudo está certo.";
}

/// The action of a button with its question, so that screen reader users know which one of several it is.
pub fn of_ask(what: &str, ask: &str) -> String {
    format!("{what}: {ask}")
}

/// The guess, and the question after it.
pub fn you_said(lang: Lang, guess: &str, question: &str) -> String {
    format!("{}: **{guess}**. {question}", texts(lang).you_guessed)
}

/// A field of a vector or a matrix. Rows and columns from 0.
pub fn field(lang: Lang, ask: &str, [rows, columns]: [usize; 2], [row, column]: [usize; 2]) -> String {
    let (i, j) = (row + 1, column + 1);
    match (rows, columns) {
        (1, 1) => ask.to_owned(),
        (_, 1) => format!("{ask} {i}"),
        (..) => both!(lang; "{ask} row {i}, column {j}", "{ask} linha {i}, coluna {j}"),
    }
}

/// An answer isn't an axis, because it's longer or shorter than 1.
pub fn axis_length(lang: Lang, length: f64) -> String {
    let length = lang.mark().number(length, 4);
    both!(lang; "your vector has length {length}, but an axis of a camera has length 1",
        "seu vetor tem comprimento {length}, mas um eixo de uma câmera tem comprimento 1")
}

/// An answer isn't an axis, because its scalar product with **n** isn't 0.
pub fn axis_oblique(lang: Lang, product: f64) -> String {
    let product = lang.mark().number(product, 4);
    both!(lang; "your vector is not perpendicular to n: their scalar product is {product}, not 0",
        "seu vetor não é perpendicular a n: o produto escalar deles é {product}, não 0")
}
