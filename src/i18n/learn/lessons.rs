//! The texts of lessons with their numbers, and the words around them, in both languages.

use serde_json::Value;

use crate::exercises;
use crate::figure::{Bilingual, Figure};
pub use crate::i18n::told;
use crate::i18n::{Lang, told_mut};
use crate::inspect::Report;
use crate::lessons::{self, Lesson, Question, Step, Task};
use crate::numbers::significant;
use crate::sanitize::escaped;

texts! {
    lessons: "Lessons", "Lições";
    lesson: "lesson", "lição";
    aims: "Afterwards you can", "Depois você saberá";
    plan: "Plan for 50 minutes", "Plano para 50 minutos";
    pretest: "Before the lesson", "Antes da lição";
    posttest: "After the lesson", "Depois da lição";
    question: "Question", "Pergunta";
    to_try: "Try", "Experimente";
    step: "Step", "Passo";
    of: "of", "de";
    keep: "To keep", "Para guardar";
    solutions: "Solutions", "Soluções";
    // Messages.
    first_step: "This is the first step of the lesson", "Este é o primeiro passo da lição";
    last_step: "This is the last step of the lesson", "Este é o último passo da lição";
    task_first: "Go on once more to skip the task of this step", "Avance de novo para pular a tarefa do passo";
    // The bar of a lesson.
    back: "Back", "Voltar";
    back_hint: "The step before", "O passo anterior";
    next: "Next", "Avançar";
    next_hint: "The next step", "O próximo passo";
    pass: "Skip", "Pular";
    pass_hint: "Go on without the task of this step", "Seguir sem a tarefa deste passo";
    all_steps: "All steps of the lesson", "Todos os passos da lição";
    again: "Back to the step", "De volta ao passo";
    again_hint: "Shows the figure of the step as it was at first", "Mostra a figura do passo como era no início";
    text_command: "Text of the step", "Texto do passo";
    text_hint: "Shows or hides the text under the views (C in a presentation)", "Mostra ou oculta o texto sob as vistas (C na apresentação)";
    question_command: "Question of the step", "Pergunta do passo";
    question_hint: "Shows or hides the question under the views. In a presentation, Q shows it, then the answer with the hands you counted", "Mostra ou oculta a pergunta sob as vistas. Na apresentação, Q a mostra, depois a resposta com as mãos que você contou";
    notes_command: "Speaker notes", "Notas do apresentador";
    clock_hint: "Minutes and seconds since you opened the speaker notes", "Minutos e segundos desde que você abriu as notas do apresentador";
    notes_hint: "Shows or hides the speaker notes of the step, in a window of their own. In a presentation, they appear under the views, marked as private", "Mostra ou oculta as notas do apresentador do passo, em uma janela própria. Numa apresentação, elas aparecem sob as vistas, marcadas como particulares";
    notes_private: "Private notes: your class sees them now too. N hides them", "Notas particulares: agora a turma também as vê. N as oculta";
    no_notes: "This step has no speaker notes", "Este passo não tem notas do apresentador";
    comes_next: "Next", "A seguir";
    leave: "Leave the lesson", "Sair da lição";
    leave_hint: "The figure of the step stays", "A figura do passo fica";
    region: "Lesson", "Lição";
    done: "Done", "Feito";
    not_yet: "Not there yet. The step notices when you've done it", "Ainda não. O passo percebe quando você terminar";
    show_way: "Show how", "Mostrar como";
    show_way_hint: "Does the task for you", "Faz a tarefa por você";
    exercise_at_side: "Answer the exercise in the panel at the side.", "Responda o exercício no painel ao lado.";
    open_exercise: "Open the exercise", "Abrir o exercício";
    show_answer: "Show the answer", "Mostrar a resposta";
    show_answer_hint: "Marks the right choice and shows how many hands each choice has", "Marca a alternativa certa e mostra quantas mãos cada uma tem";
    count_hands: "A letter counts a hand, Shift and the letter take one away", "Uma letra conta uma mão, Shift e a letra tiram uma";
    hands: "hands", "mãos";
    raise_hint: "counts a hand for this choice", "conta uma mão para esta alternativa";
    hidden_question: "Q shows the question", "Q mostra a pergunta";
    // Recording.
    add_step: "Add as step", "Adicionar como passo";
    add_step_hint: "Adds what is on the screen to a lesson of your own, as its next step. Only the difference from the step before is written", "Adiciona o que está na tela a uma lição sua, como o próximo passo. Só a diferença do passo anterior é escrita";
    step_title: "The lesson to which the step is added", "A lição à qual o passo é adicionado";
    step_action: "Add", "Adicionar";
    step_file: "lesson.toml", "licao.toml";
    // Writing a lesson in the window.
    write_command: "Write the lesson", "Escrever a lição";
    write_hint: "The texts of the step and of the lesson, their preview, and the order of the steps. You edit a copy of a lesson that belongs to the program. If no lesson is open, a new one begins with what is on the screen", "Os textos do passo e da lição, a prévia deles e a ordem dos passos. De uma lição do programa você edita uma cópia. Sem lição, uma nova começa com o que está na tela";
    copy_title: "A copy of the lesson, to be changed by you", "Uma cópia da lição, para você mudar";
    copy_action: "Copy", "Copiar";
    step_earlier: "Move up", "Para cima";
    step_earlier_hint: "Moves the step before the previous one. Its image stays the same", "O passo vem antes do anterior. A imagem continua a mesma";
    step_later: "Move down", "Para baixo";
    step_later_hint: "Moves the step after the next one. Its image stays the same", "O passo vem depois do próximo. A imagem continua a mesma";
    step_screen: "Use what's on the screen", "Usar o que está na tela";
    step_screen_hint: "From now on the step shows what you see. Its texts stay", "A partir de agora o passo mostra o que você vê. Os textos ficam";
    step_another: "New step after this one", "Novo passo depois deste";
    step_another_hint: "Adds a step that shows what is on the screen", "Adiciona um passo que mostra o que está na tela";
    step_remove: "Remove the step", "Remover o passo";
    step_remove_hint: "Takes the step out of the lesson; “Undo the change” brings it back", "Tira o passo da lição; “Desfazer a mudança” o traz de volta";
    read_again: "Reload", "Recarregar";
    read_again_hint: "Reads the file again, with the changes that another program made. You lose text that you typed here and that isn’t saved yet", "Lê o arquivo com as mudanças feitas por outro programa. Você perde o texto que digitou aqui e que ainda não foi salvo";
    is_kept: "saved", "salvo";
    not_kept: "not saved yet", "ainda não salvo";
    not_written: "Not written to the file", "Não foi escrito no arquivo";
    unfinished: "Write the question and its answers. Then it goes into the file.", "Escreva a pergunta e as respostas. Depois ela vai para o arquivo.";
    step_title_field: "Title", "Título";
    step_text_field: "Text (Markdown, $formulas$, {numbers})", "Texto (Markdown, $fórmulas$, {números})";
    of_step: "This step", "Este passo";
    of_step_hint: "Title, text and speaker notes of the step", "Título, texto e notas do apresentador do passo";
    of_lesson: "The whole lesson", "A lição inteira";
    of_lesson_hint: "Title, sentence to keep and minutes of the lesson, as lists and handouts show them", "Título, frase para guardar e minutos da lição, como listas e materiais os mostram";
    lesson_title_field: "Title of the lesson", "Título da lição";
    lesson_sentence_field: "Sentence to keep (Markdown, $formulas$)", "Frase para guardar (Markdown, $fórmulas$)";
    lesson_minutes_field: "Minutes", "Minutos";
    forget_typed: "Back to the saved text", "Voltar ao texto salvo";
    forget_typed_hint: "Discards the text you've typed since it was last saved", "Descarta o texto que você digitou desde que o passo foi salvo";
    // The question about text that can't be saved.
    unsaved_text_title: "Leave without the text of this step?", "Sair sem o texto deste passo?";
    unsaved_text: "The text you typed isn't in the lesson's file, and can't be saved there:", "O texto que você digitou não está no arquivo da lição e não pode ser salvo nele:";
    save_copy: "Save a copy…", "Salvar uma cópia…";
    // The title of a recorded lesson.
    new_lesson: "A new lesson", "Uma nova lição";
    // A line of the window at its first start.
    new_here: "New here?", "Primeira vez aqui?";
    or_gallery: "Gallery of figures", "Galeria de figuras";
    go_on: "Go on", "Continuar";
    no_go_on: "Close this line until the next start", "Fechar esta linha até a próxima vez";
    no_welcome: "Close this line. The lessons are in the menu Help", "Fechar esta linha. As lições estão no menu Ajuda";
    presentation_keys: "Esc: leave · Page ↑ ↓: steps · Q: question · C: text · N: private notes · a number: that step · P: pen · S: spotlight · B: black", "Esc: sair · Page ↑ ↓: passos · Q: pergunta · C: texto · N: notas particulares · um número: aquele passo · P: caneta · S: holofote · B: preto";
    // The list of lessons.
    lessons_command: "Lessons…", "Lições…";
    lessons_hint: "A way through the chapter, step by step", "Um caminho pelo capítulo, passo a passo";
    of_folder: "In the folder of your figures", "Na pasta de suas figuras";
    learn_next: "Learn next", "Próxima lição";
    leads_to: "Exercises", "Exercícios";
    finished: "finished", "concluída";
    read_more: "Read", "Ler";
    practise: "Practise", "Praticar";
    go_on_with: "Go on with", "Continue com";
    see_lesson: "Lesson", "Lição";
}

/// A text with the numbers of a figure. Left as written if the figure has none.
pub fn filled(lang: Lang, text: &Bilingual, figure: &Figure) -> String {
    match lessons::numbers_of(figure) {
        Ok(report) => filled_from(lang, text, &report),
        Err(_) => told(lang, text).to_owned(),
    }
}

/// A text with the numbers of a report. Left as written if the report lacks one of them.
pub fn filled_from(lang: Lang, text: &Bilingual, report: &Report) -> String {
    let text = told(lang, text);
    lessons::filled(text, report, lang.mark()).unwrap_or_else(|_| text.to_owned())
}

/// The text of a step, in Markdown.
pub fn text(lang: Lang, step: &Step) -> String {
    filled(lang, &lessons::with_sentence(&step.text, step.sentence.as_ref()), &step.figure)
}

/// The speaker's notes of a step, in Markdown.
pub fn notes(lang: Lang, step: &Step) -> Option<String> {
    step.notes.as_ref().map(|notes| filled(lang, notes, &step.figure))
}

/// A lesson to read in a terminal.
pub fn to_read(lang: Lang, lesson: &Lesson) -> String {
    let t = texts(lang);
    let mut out = format!("{} ({})\n", told(lang, &lesson.title), lesson.id);
    if !lesson.aims.is_empty() {
        out.push_str(&format!("\n{}:\n", t.aims));
        lesson.aims.iter().for_each(|aim| out.push_str(&format!("- {}\n", told(lang, aim).trim())));
    }
    if let Some(plan) = &lesson.plan {
        out.push_str(&format!("\n{}:\n\n{}\n", t.plan, told(lang, plan).trim()));
    }
    out.push_str(&questions(lang, t.pretest, &lesson.pretest));
    for (k, step) in lesson.steps.iter().enumerate() {
        out.push_str(&format!("\n{}. {}\n\n{}\n", k + 1, told(lang, &step.title), text(lang, step).trim()));
        match &step.task {
            Some(Task::Exercise { id, seed }) => {
                out.push_str(&format!("\n{}: camera-lab exercise show {id} --seed {seed}\n", t.question));
            }
            Some(Task::Question(entry)) => {
                let exercise = entry.exercise(0, &Default::default());
                for ask in &exercise.asks {
                    let asked = super::exercises::ask(lang, &exercise, ask);
                    out.push_str(&format!(
                        "\n{}: {} ({})\n",
                        t.question,
                        asked.trim(),
                        super::exercises::kind(lang, ask)
                    ));
                }
            }
            Some(Task::Try(goal)) => {
                out.push_str(&format!("\n{}: {}\n", t.to_try, filled(lang, &goal.text, &step.figure).trim()));
            }
            None => {}
        }
    }
    if let Some(sentence) = &lesson.sentence {
        out.push_str(&format!("\n{}: {}\n", t.keep, told(lang, sentence).trim()));
    }
    out.push_str(&questions(lang, t.posttest, &lesson.posttest));
    out
}

/// The questions before or after a lesson, each with the command that prints it. Empty if there are none.
fn questions(lang: Lang, heading: &str, questions: &[Question]) -> String {
    let line = |question: &Question| {
        let title = exercises::entry(&question.id).map(|entry| super::exercises::title(lang, entry));
        let Question { id, seed } = question;
        format!("- {}: camera-lab exercise show {id} --seed {seed}\n", title.unwrap_or_default())
    };
    let lines: String = questions.iter().map(line).collect();
    if lines.is_empty() { lines } else { format!("\n{heading}:\n{lines}") }
}

/// The titles of the exercises that a lesson leads to, each once.
pub fn exercises_of(lang: Lang, lesson: &Lesson) -> Vec<&'static str> {
    lessons::exercises_of(lesson)
        .into_iter()
        .filter_map(|id| Some(super::exercises::title(lang, exercises::entry(id)?)))
        .collect()
}

texts_with_values! {
    /// A step was added to a file.
    step_added(lang, file: &str, number: usize): "Step {number} was added to {file}",
        "O passo {number} foi adicionado a {file}";

    /// Another program has changed the file of the lesson.
    changed_elsewhere(lang, file: &str): "Another program has changed {file}, so nothing was written to it. “{again}” shows the text that is in the file now",
        "Outro programa mudou {file}, então nada foi escrito nele. “{again}” mostra o texto que está no arquivo agora"
        (again = texts(lang).read_again);

    /// The tasks of a lesson that are done.
    answered(lang, done: usize, all: usize): "{done} of {all} tasks done", "{done} de {all} tarefas feitas";

    /// A key of a lesson names another lesson that doesn't exist.
    no_lesson(lang, key: &str, id: &str): "{key}: there is no lesson {:?}", "{key}: não há lição {:?}" (escaped(id));

    /// A key of a lesson names a note that doesn't exist.
    no_note(lang, key: &str, id: &str): "{key}: there is no reference page {:?}",
        "{key}: não há verbete {:?}" (escaped(id));

    /// A message about a step, from 1.
    of_step(lang, number: usize, why: &str): "step {number}: {why}", "passo {number}: {why}";

    /// There is no step with this number.
    no_step(lang, found: &str, count: usize): "--step is {found}; allowed: a number from 1 to {count}",
        "--step é {found}; permitido: um número de 1 a {count}" (found = escaped(found));

    /// A link names a step that its lesson doesn't have.
    no_step_of(lang, key: &str, step: usize, count: usize): "{key}: the lesson has no step {step}; allowed: a step from 1 to {count}",
        "{key}: a lição não tem o passo {step}; permitido: um passo de 1 a {count}";

    /// The goal of a step holds from the start.
    reached_already(lang, key: &str): "{key} holds already in the figure of the step; allowed: conditions that do not",
        "{key} já vale na figura do passo; permitido: condições que ainda não valham";

    /// The way of a goal doesn't lead to it.
    not_reached(lang, key: &str): "{key} doesn't reach the goal in until", "{key} não alcança a meta de until";

    /// A handout has another number of steps on a page.
    per_page(lang, found: &str): "--per-page is {found}; allowed: 2 or 4",
        "--per-page é {found}; permitido: 2 ou 4" (found = escaped(found));

    /// Pictures of a lesson for a file that can hold only one.
    output_name(lang, path: &str): "{path} would be one image; allowed: a folder, or a name that ends in .pdf",
        "{path} seria uma só imagem; permitido: uma pasta, ou um nome que termine em .pdf";
}

/// The titles of the recorded step with this number, in the author's language alone: the other language shows the same
/// until it has a title.
pub fn draft(lang: Lang, number: usize) -> lessons::Draft {
    let t = texts(lang);
    let alone = |text: String| {
        let mut both = Bilingual::default();
        *told_mut(lang, &mut both) = text;
        both
    };
    lessons::Draft { lesson: alone(t.new_lesson.to_owned()), title: alone(format!("{} {number}", t.step)) }
}

/// The title of a lesson, and the minutes that it takes.
pub fn with_minutes(lang: Lang, lesson: &Lesson) -> String {
    let minutes = lesson.minutes.map_or_else(String::new, |minutes| format!(" ({} min)", significant(minutes, 3)));
    format!("{}{minutes}", told(lang, &lesson.title))
}

/// The step of how many.
pub fn place(lang: Lang, number: usize, of: usize) -> String {
    let t = texts(lang);
    format!("{} {number} {} {of}", t.step, t.of)
}

/// The way on: the title of a lesson and a step of it, from 0.
pub fn go_on(lang: Lang, lesson: &Lesson, step: usize) -> String {
    let step_word = texts(lang).step.to_lowercase();
    format!("{}, {step_word} {}", told(lang, &lesson.title), step + 1)
}

/// A line of the list of lessons, from its data.
pub fn line(lang: Lang, line: &Value) -> String {
    let text = |key: &str| line[key].as_str().unwrap_or_default();
    let minutes = line["minutes"].as_f64().map_or_else(String::new, |minutes| significant(minutes, 3) + " min");
    let steps = pick!(lang; "steps", "passos");
    format!("{:<16} {:>7} {:>3} {steps}   {}\n", text("id"), minutes, line["steps"], text("title"))
}

/// There is no such lesson.
pub fn unknown(lang: Lang, id: &str, near: Option<&str>) -> String {
    let id = escaped(id);
    match near {
        Some(near) => both!(lang;
            "there is no lesson {id:?}; did you mean {near:?}? `camera-lab lesson list` lists them",
            "não há lição {id:?}; você quis dizer {near:?}? `camera-lab lesson list` as lista"),
        None => both!(lang;
            "there is no lesson {id:?}; allowed: a lesson file, or an id of `camera-lab lesson list`",
            "não há lição {id:?}; permitido: um arquivo de lição, ou um id de `camera-lab lesson list`"),
    }
}

/// A lesson lacks a part that another lecturer needs.
pub fn no_part(lang: Lang, key: &str) -> String {
    let why = match key {
        "aims" => pick!(lang; "what you can do after the lesson, a list of texts",
            "o que você sabe fazer depois da lição, uma lista de textos"),
        "plan" => pick!(lang; "what to show, ask, expect and hand out in 50 minutes",
            "o que mostrar, perguntar, esperar e distribuir em 50 minutos"),
        _ => pick!(lang; "the one sentence to keep", "a frase para guardar"),
    };
    both!(lang; "{key} is missing: {why}. The lesson plays without it",
        "falta {key}: {why}. A lição funciona sem isso")
}

/// The name of a link to a step of a lesson: its title, and the number of the step unless it's the first.
pub fn lesson_link(lang: Lang, lesson: &Lesson, step: usize) -> String {
    let t = texts(lang);
    let title = told(lang, &lesson.title);
    if step == 0 {
        format!("{}: {title}", t.see_lesson)
    } else {
        format!("{}: {title}, {} {}", t.see_lesson, t.step.to_lowercase(), step + 1)
    }
}

/// An option of handouts with a folder of pictures, or the other way round.
pub fn unused_option(lang: Lang, option: &str, is_handout: bool) -> String {
    if is_handout {
        return both!(lang; "{option} is for a folder of images; a handout takes --per-page and --answers",
            "{option} vale para uma pasta de imagens; um material impresso aceita --per-page e --answers");
    }
    both!(lang; "{option} is for a handout; allowed: -o OUT.pdf",
        "{option} vale para um material impresso; permitido: -o SAIDA.pdf")
}

/// All files hold good lessons.
pub fn all_good(lang: Lang, count: usize) -> String {
    match count {
        1 => both!(lang; "the lesson has no errors\n", "a lição não tem erros\n"),
        _ => both!(lang; "{count} lessons have no errors\n", "{count} lições não têm erros\n"),
    }
}
