//! The words about families of pictures, with the reasons why some keys can't be varied.

use super::{Lang, messages};
use crate::figure::variation::VariationError;
use crate::limits::{MAX_FAMILY, MAX_FRAMES};
use crate::sanitize::escaped;

texts! {
    family: "family", "família";
    family_hint: "The same figure at several values, on one sheet with the value under each image", "A mesma figura com vários valores, numa folha com o valor sob cada imagem";
    none: "none", "nenhuma";
    typed: "another key", "outra chave";
    view_angle: "view angle θ", "ângulo de vista θ";
    projection: "projection", "projeção";
    samples: "samples per pixel", "amostras por pixel";
    values: "values", "valores";
    values_hint: "Separate them by commas. 20..90:4 are four from 20 to 90. With another key, write camera.near=1, 2", "Separe-os por vírgulas. 20..90:4 são quatro de 20 a 90. Com outra chave, escreva camera.near=1, 2";
    second: "in each row", "em cada linha";
    second_hint: "A second key or operation, which varies within each row. The first then varies from row to row", "Uma segunda chave ou operação, que varia dentro de cada linha. A primeira varia então de linha em linha";
    second_values: "values along the rows", "valores ao longo das linhas";
    nothing: "nothing", "nada";
    captions: "captions", "legendas";
    captions_hint: "Captions instead of the values, one for each image, with semicolons between them. If empty, the values", "Legendas no lugar dos valores, uma para cada imagem, separadas por ponto e vírgula. Se vazio, os valores";
    columns: "columns", "colunas";
    columns_hint: "Images in a row", "Imagens em cada linha";
    automatic: "automatic", "automático";
    parts: "(a), (b) …", "(a), (b) …";
    parts_hint: "Letters before the values, for a text that names the parts", "Letras antes dos valores, para um texto que cita as partes";
    paper: "made for", "feito para";
    paper_hint: "Sets the size and the letters", "Define o tamanho e as letras";
    own_size: "own size", "tamanho próprio";
    column: "column, 8.8 cm", "coluna, 8,8 cm";
    a4: "A4 text, 16 cm", "texto A4, 16 cm";
    slide: "slide 16:9", "slide 16:9";
    square: "square", "quadrado";
}

/// The reason why there is no family.
pub fn error(lang: Lang, error: &VariationError) -> String {
    match error {
        VariationError::NoValues => both!(lang;
            "it has no values; allowed: KEY=VALUE,VALUE,…, such as camera.view_angle=20,40,60",
            "não tem valores; permitido: CHAVE=VALOR,VALOR,…, como camera.view_angle=20,40,60"),
        VariationError::Range { found, limit } => both!(lang;
            "\"{}\" is no range of numbers; allowed: FROM..TO:COUNT, with a COUNT from 2 to {limit}",
            "\"{}\" não é um intervalo de números; permitido: DE..ATÉ:QUANTOS, com QUANTOS de 2 a {limit}"; escaped(found)),
        VariationError::TooMany { count, limit } => both!(lang;
            "the family would have {count} images; allowed: at most {limit}",
            "a família teria {count} imagens; permitido: no máximo {limit}"),
        VariationError::Figure { key, value, error } => {
            format!("{} = {}: {}", escaped(key), escaped(value), messages::without_line(lang, error))
        }
        VariationError::Operation { key, value, error } => {
            format!("{} = {}: {}", escaped(key), escaped(value), messages::operation(lang, error))
        }
    }
}

texts_with_values! {
    /// A number of columns that no sheet has.
    columns(lang, text: &str): "--columns is \"{text}\"; allowed: a whole number from 1 to {MAX_FAMILY}",
        "--columns é \"{text}\"; permitido: um número inteiro de 1 a {MAX_FAMILY}" (text = escaped(text));

    /// A number of pictures that no animation has.
    frames(lang, text: &str): "--frames is \"{text}\"; allowed: a whole number from 2 to {MAX_FRAMES}",
        "--frames é \"{text}\"; permitido: um número inteiro de 2 a {MAX_FRAMES}" (text = escaped(text));

    /// A number of variations that a command can't use.
    variations(lang, count: usize, most: usize): "--vary is given {count} times; allowed: at least once and at most {most} times",
        "--vary aparece {count} vezes; permitido: ao menos uma e no máximo {most}";

    /// Rows that wouldn't have the pictures of a figure below one another.
    uneven_rows(lang, count: usize, columns: usize): "{count} figures with several images each do not fill rows of {columns}; allowed: a number of columns that divides {count}",
        "{count} figuras com várias imagens cada não enchem linhas de {columns}; permitido: um número de colunas que divida {count}";
}
