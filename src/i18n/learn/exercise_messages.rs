//! The words of the command line about exercises, besides the exercises themselves.

use super::exercises::mistake;
use super::{exercises, lessons};
use crate::exercises::{Ask, Exercise, Judged, Why};
use crate::i18n::{Lang, told};
use crate::lessons::lesson_of;
use crate::sanitize::escaped;

texts! {
    asked: "Asked", "Pede-se";
    assumptions: "Assumptions", "Hipóteses";
    answers: "Answers", "Respostas";
    solution: "Solution", "Resolução";
    not_answered: "Not answered yet", "Ainda sem resposta";
    read_as: "read as", "entendido";
    source: "Source", "Fonte";
    exercises: "Exercises", "Exercícios";
    name: "Name", "Nome";
    date: "Date", "Data";
    seed: "seed", "semente";
    target: "The image to match", "Esta é a imagem a reproduzir";
}

/// An identifier that no exercise has.
pub fn unknown_exercise(lang: Lang, id: &str, near: Option<&str>) -> String {
    let id = escaped(id);
    let meant =
        near.map(|near| both!(lang; " did you mean {near:?}?", " você quis dizer {near:?}?")).unwrap_or_default();
    both!(lang; "there is no exercise {id:?};{meant} `camera-lab exercise list` lists them",
        "não há exercício {id:?};{meant} `camera-lab exercise list` os lista")
}

texts_with_values! {
    /// An answer to an unknown question.
    unknown_ask(lang, id: &str, name: &str, asks: &[&str]): "--answer: {id} does not ask for {name:?}; it asks for: {asks}",
        "--answer: {id} não pede {name:?}; pede: {asks}" (name = escaped(name), asks = asks.join(", "));

    /// The same question answered twice.
    answered_twice(lang, name: &str): "--answer: {} is answered twice",
        "--answer: {} foi respondido duas vezes" (escaped(name));

    /// A file of a folder that isn't an exercise, if the others are used.
    passed_over(lang, why: &str): "skipped: {why}", "ignorado: {why}";

    /// An answer that can't be read. It hasn't been judged.
    unreadable(lang, name: &str, why: &str): "--answer {name}: {why}. Nothing was checked",
        "--answer {name}: {why}. Nada foi conferido";

    /// `--hints` that isn't a number of hints.
    hints_range(lang, text: &str): "--hints {text}: expected a whole number from 0 to 9",
        "--hints {text}: esperava-se um número inteiro de 0 a 9" (text = escaped(text));

    /// The number of right entries.
    score(lang, right: usize, all: usize): "{right} of {all}", "{right} de {all}";

    /// The number of right entries or conditions of a wrong answer.
    right_of(lang, right: usize, all: usize): "{right} of {all} right", "{right} de {all} certos";

    /// A sheet with an ending that can't be written.
    sheet_ending(lang, path: &str): "{path}: unknown extension; allowed: .pdf, .md, .tex",
        "{path}: extensão desconhecida; permitido: .pdf, .md, .tex";

    /// A picture of an exercise that doesn't have one.
    no_picture(lang, id: &str): "--picture: {id} has no image to match", "--picture: {id} não tem imagem a reproduzir";

    /// A picture with an ending that can't be written.
    picture_ending(lang, path: &str): "--picture {path}: unknown extension; allowed: .png",
        "--picture {path}: extensão desconhecida; permitido: .png";

    /// The progress is deleted, and still in the file at `path`.
    progress_deleted(lang, path: &str): "Progress deleted. The old file is now {path}.",
        "Progresso apagado. O arquivo antigo é agora {path}.";

    /// The place of a point in the image, in whole pixels.
    lands(lang, place: [f64; 2]): "The point lands on the pixel {pixel}.",
        "O ponto cai no pixel {pixel}." (pixel = lang.mark().tuple(&place.map(f64::floor), 5));
}

/// The reason why a file was skipped, if others were too.
pub fn and_more(lang: Lang, why: &str, more: usize) -> String {
    match more {
        1 => both!(lang; "{why} (and one more file was skipped)", "{why} (e mais um arquivo foi ignorado)"),
        _ => {
            both!(lang; "{why} (and {more} more files were skipped)", "{why} (e mais {more} arquivos foram ignorados)")
        }
    }
}

/// An answer without `=`.
pub fn answer_form(lang: Lang, text: &str) -> String {
    format!("--answer {}: {}", escaped(text), name_and_value(lang))
}

/// `--with` that can't be used.
pub fn with(_lang: Lang, text: &str, why: &str) -> String {
    format!("--with {}: {why}", escaped(text))
}

/// A number that the exercise doesn't leave open.
pub fn not_free(lang: Lang, id: &str, name: &str, free: &[&str]) -> String {
    let name = escaped(name);
    if free.is_empty() {
        return both!(lang; "--with: {id} leaves no number open, so {name:?} cannot be set",
            "--with: {id} não deixa nenhum número em aberto, e {name:?} não pode ser definido");
    }
    both!(lang; "--with: {id} does not leave {name:?} open; it leaves open: {}",
        "--with: {id} não deixa {name:?} em aberto; deixa: {}"; free.join(", "))
}

/// The expected form.
pub const fn name_and_value(lang: Lang) -> &'static str {
    pick!(lang; "expected NAME=VALUE", "esperava-se NOME=VALOR")
}

/// The expected range.
pub const fn greater_than_zero(lang: Lang) -> &'static str {
    pick!(lang; "expected a number greater than 0", "esperava-se um número maior que 0")
}

/// Hints for a wrong answer, weaker ones first. None for a right one.
pub fn hints(lang: Lang, exercise: &Exercise, ask: &Ask, verdict: &Judged) -> Vec<String> {
    /// Digits of the numbers in the first step.
    const DIGITS: usize = 6;
    match &verdict.diagnosis {
        _ if verdict.right || !verdict.carried.is_empty() => Vec::new(),
        // The reason has been given.
        _ if verdict.numbers.as_ref().is_some_and(|own| own.instead.is_some()) => Vec::new(),
        Some(diagnosis) => exercises::hints(lang, ask, diagnosis).into_iter().map(str::to_owned).collect(),
        None => {
            let steps = exercises::steps(lang, exercise, ask, DIGITS);
            let first = steps.get(verdict.first_step).and_then(|step| step.lines().next()).map(str::to_owned);
            let way = lesson_of(&exercise.id);
            let keep = way.and_then(|way| {
                let sentence = way.lesson.sentence.as_ref().map(|sentence| told(lang, sentence).trim().to_owned())?;
                Some(format!("{sentence} ({})", lessons::lesson_link(lang, &way.lesson, way.step)))
            });
            exercises::hints_without_diagnosis(lang, verdict, (keep, first.as_deref()))
        }
    }
}

/// The reason why an exercise is the next to practise.
pub fn why(lang: Lang, why: Why) -> String {
    match (lang, why) {
        (Lang::En, Why::Mistake(made, times)) => {
            let times = if times == 1 { "once".to_owned() } else { format!("{times} times") };
            format!("It practises a mistake that you made {times}: {}", mistake(lang, made)[0])
        }
        (Lang::PtBr, Why::Mistake(made, times)) => {
            let times = if times == 1 { "uma vez".to_owned() } else { format!("{times} vezes") };
            format!("Ele exercita um erro que você cometeu {times}: {}", mistake(lang, made)[0])
        }
        (_, Why::Begun) => both!(lang; "You began it, and it isn't solved yet.",
            "Você já o iniciou, mas ele ainda não está resolvido."),
        (Lang::En, Why::Due(days)) => {
            let ago = if days == 1 { "a day ago".to_owned() } else { format!("{days} days ago") };
            format!("You solved it {ago}. See whether you still can, with new numbers.")
        }
        (Lang::PtBr, Why::Due(days)) => {
            let ago = if days == 1 { "um dia".to_owned() } else { format!("{days} dias") };
            format!("Você o resolveu há {ago}. Veja se ainda consegue, com números novos.")
        }
        (_, Why::NotSolved) => both!(lang; "In the order of the lessons, it's the next one you haven't solved.",
            "É o próximo das lições que você ainda não resolveu."),
        (_, Why::LongestAgo) => both!(lang; "You've solved them all. This is the one you tried longest ago.",
            "Você já resolveu todos. Este é o que você tentou há mais tempo."),
    }
}

/// The distance of an answer from the right place in the image, pixels to the right and down, and that place.
pub fn off(lang: Lang, [x, y]: [f64; 2]) -> String {
    let distance = x.hypot(y);
    let by = lang.mark().number(distance.round(), 5);
    let is_far = |part: f64| part.abs() >= 0.25 * distance && part.abs() >= 0.5;
    let across = is_far(x).then_some(match x > 0.0 {
        true => pick!(lang; "farther to the left", "mais à esquerda"),
        false => pick!(lang; "farther to the right", "mais à direita"),
    });
    let down = is_far(y).then_some(match y > 0.0 {
        true => pick!(lang; "higher", "mais acima"),
        false => pick!(lang; "lower", "mais abaixo"),
    });
    let ways: Vec<&str> = across.into_iter().chain(down).collect();
    if ways.is_empty() {
        return pick!(lang; "Your mark is on the pixel.", "Sua marca está no pixel certo.").to_owned();
    }
    let ways = ways.join(pick!(lang; " and ", " e "));
    both!(lang; "Your mark is {by} pixels off. The point is {ways}.",
        "Sua marca está a {by} pixels do ponto. Ele está {ways}.")
}
