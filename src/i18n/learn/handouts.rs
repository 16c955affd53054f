//! The words of the dialog that prints lessons and exercises.

texts! {
    handout: "Handout…", "Material impresso…";
    handout_hint: "A lesson as pages to print, with figures, texts, questions and room for answers", "Uma lição como páginas para imprimir, com figuras, textos, perguntas e espaço para respostas";
    sheet: "Exercise sheet…", "Lista de exercícios…";
    sheet_hint: "Exercises of your choice as pages to print, with or without solutions", "Exercícios à sua escolha como páginas para imprimir, com ou sem soluções";
    of_lesson: "A lesson", "Uma lição";
    of_exercises: "An exercise sheet", "Uma lista de exercícios";
    language: "language", "idioma";
    answers: "with solutions", "com soluções";
    answers_hint: "Puts the answers and their worked steps on pages of their own at the end", "Põe as respostas e seus passos em páginas próprias no fim";
    late: "answering steps at the end", "passos com a resposta no fim";
    late_hint: "A step that only shows the answer to the question before it comes after all questions", "Um passo que só mostra a resposta à pergunta anterior vem depois de todas as perguntas";
    plan: "with the lecturer’s plan", "com o plano de aula";
    plan_hint: "Begins with the lecturer’s 50 minutes: figures to show, questions to ask, answers to expect, sheets to hand out", "Começa com os 50 minutos da aula: figuras a mostrar, perguntas a fazer, respostas a esperar, folhas a distribuir";
    no_plan: "This lesson has no plan", "Esta lição não tem plano";
    size: "figures", "figuras";
    large: "large", "grandes";
    large_hint: "About two steps on a page", "Cerca de dois passos por página";
    small: "small", "pequenas";
    small_hint: "Up to four steps on a page", "Até quatro passos por página";
    lesson: "Lesson", "Lição";
    numbers: "numbers no.", "números nº";
    numbers_hint: "Another number gives every exercise other numbers", "Outro número dá outros números a todos os exercícios";
    with_numbers: "With the numbers above", "Com os números acima";
    same_for_all: "The same for everybody", "Iguais para todos";
    choose: "Choose the exercises in the order of the sheet:", "Escolha os exercícios na ordem da lista:";
    preview: "The page as it will be printed", "A página como será impressa";
    drawing: "The pages are being made…", "As páginas estão sendo feitas…";
    nothing: "Choose an exercise.", "Escolha um exercício.";
    page: "Page", "Página";
    of: "of", "de";
    page_before: "The page before", "A página anterior";
    page_after: "The next page", "A próxima página";
    save: "Save as PDF…", "Salvar como PDF…";
    title: "The PDF file to write", "O arquivo PDF a escrever";
    filter: "Handout", "Material impresso";
    file: "exercises", "exercicios";
}
