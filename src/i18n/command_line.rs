//! The words of the command line, in both languages.

use std::ops::RangeInclusive;

use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::Lang;
use crate::camera::{Decomposition, ImageSize};
use crate::export::format::PictureFormat;
use crate::expression::ExpressionError;
use crate::i18n::messages::expressions::in_expression;
use crate::limits::MAX_SIDE;
use crate::sanitize::{self, escaped};

/// Faulty arguments, in one paragraph.
pub fn arguments(lang: Lang, error: &clap::Error) -> String {
    let before_the_command =
        error.kind() == ErrorKind::ArgumentConflict && error.get(ContextKind::InvalidSubcommand).is_some();
    let what = match lang {
        Lang::En if before_the_command => {
            "an option comes before the command; allowed: camera-lab COMMAND FIGURE OPTIONS".to_owned()
        }
        Lang::PtBr if before_the_command => {
            "há uma opção antes do comando; permitido: camera-lab COMANDO FIGURA OPÇÕES".to_owned()
        }
        Lang::En => english(error),
        Lang::PtBr => portuguese(error),
    };
    // It may contain typed text of any length.
    let what = sanitize::within(&what, 600);
    format!("{what}{}", both!(lang; "; see --help", "; veja --help"))
}

texts_with_values! {
    /// A command that doesn't exist.
    unknown_command(lang, name: &str, commands: &[String]): "there is no command \"{name}\", nor a figure file of this name; allowed: {commands}; see --help",
        "não há o comando \"{name}\", nem um arquivo de figura com este nome; permitido: {commands}; veja --help"
        (name = escaped(name), commands = commands.join(", "));

    /// A text that isn't a point. If it has three parts, the one that isn't a number, with the reason.
    point(lang, text: &str, fault: Option<(&str, &ExpressionError)>): "--point is \"{text}\"{why}; allowed: three finite numbers X,Y,Z, such as --point 1,2.5,-3",
        "--point é \"{text}\"{why}; permitido: três números finitos X,Y,Z, como --point 1,2.5,-3"
        (text = escaped(text), why = fault.map_or_else(String::new, |(part, error)| format!(": {}", in_expression(lang, part, error))));

    /// A text that isn't a pixel.
    pixel(lang, text: &str): "--pixel is \"{text}\"; allowed: two integers I,J (column, row), such as --pixel 0,0",
        "--pixel é \"{text}\"; permitido: dois inteiros I,J (coluna, linha), como --pixel 0,0" (text = escaped(text));

    /// The name of a file whose extension is neither that of an animation nor that of a picture.
    animation_ending(lang, name: &str): "{name}: unknown extension; allowed: .gif, .apng (animations), .png, .webp, .jpg (a strip of stills)",
        "{name}: extensão desconhecida; permitido: .gif, .apng (animações), .png, .webp, .jpg (uma tira de quadros)";

    /// A text that isn't a pixel with a depth.
    depth_pixel(lang, text: &str): "--depth-pixel is \"{text}\"; allowed: two integers and a number I,J,Z (column, row, depth), such as --depth-pixel 512,384,0.5",
        "--depth-pixel é \"{text}\"; permitido: dois inteiros e um número I,J,Z (coluna, linha, profundidade), como --depth-pixel 512,384,0.5"
        (text = escaped(text));

    /// A text that isn't a size.
    size(lang, text: &str): "--size is \"{text}\"; allowed: WxH with integers from 1 to {MAX_SIDE}, such as --size 800x600",
        "--size é \"{text}\"; permitido: LxA com inteiros de 1 a {MAX_SIDE}, como --size 800x600"
        (text = escaped(text));

    /// A text that isn't a number, or a number that an option doesn't take.
    number(lang, option: &str, text: &str, range: &RangeInclusive<f64>, example: f64): "{option} is \"{text}\"; allowed: a number from {least} to {most}, such as {option} {example}",
        "{option} é \"{text}\"; permitido: um número de {least} a {most}, como {option} {example}"
        (text = escaped(text), least = range.start(), most = range.end());

    /// A text that isn't a number of frames.
    frames(lang, text: &str): "--frames is \"{text}\"; allowed: an integer from 1 to 1000000, such as --frames 100",
        "--frames é \"{text}\"; permitido: um inteiro de 1 a 1000000, como --frames 100" (text = escaped(text));

    /// A text that isn't a seed.
    seed(lang, text: &str): "--seed is \"{text}\"; allowed: an integer from 0 to 18446744073709551615, such as --seed 1",
        "--seed é \"{text}\"; permitido: um inteiro de 0 a 18446744073709551615, como --seed 1" (text = escaped(text));

    /// A file of charts whose extension isn't that of a format.
    plot_ending(lang, path: &str): "{path}: its extension is not that of a plot format; allowed: {endings}",
        "{path}: a extensão não é de um formato de gráfico; permitido: {endings}" (endings = picture_endings());

    /// A picture larger than pictures can be.
    too_large(lang, width: u64, height: u64): "the image would have {width} × {height} pixels (see --size and --scale); allowed: at most {MAX_SIDE} on each side and 134 million in all",
        "a imagem teria {width} × {height} pixels (veja --size e --scale); permitido: no máximo {MAX_SIDE} de cada lado e 134 milhões ao todo";

    /// An ending that isn't a picture's.
    ending(lang, name: &str): "--output is \"{name}\"; allowed: a file name that ends in {endings}",
        "--output é \"{name}\"; permitido: um nome de arquivo que termina em {endings}"
        (name = escaped(name), endings = picture_endings());

    /// A program without a window.
    not_built_in(lang): "this camera-lab was built without its window; `camera-lab render FIGURE -o picture.png` draws without one",
        "este camera-lab foi compilado sem a janela; `camera-lab render FIGURA -o imagem.png` desenha sem janela";
}

/// Clap's own words, without its usage lines, on one line.
fn english(error: &clap::Error) -> String {
    let text = error.render().to_string();
    let parts: Vec<String> = text
        .split("\n\n")
        .map(|part| part.split_whitespace().collect::<Vec<_>>().join(" "))
        .filter(|part| !part.is_empty() && !part.starts_with("Usage:") && !part.starts_with("For more information"))
        .collect();
    let text = parts.join("; ");
    text.strip_prefix("error: ").unwrap_or(&text).to_owned()
}

fn portuguese(error: &clap::Error) -> String {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        Some(ContextValue::Strings(texts)) => texts.join(", "),
        Some(ContextValue::Number(number)) => number.to_string(),
        _ => String::new(),
    };
    let arg = context(ContextKind::InvalidArg);
    let value = context(ContextKind::InvalidValue);
    let mut text = match error.kind() {
        ErrorKind::InvalidValue if value.is_empty() => format!("falta um valor para '{arg}'"),
        ErrorKind::InvalidValue => format!("valor '{value}' inválido para '{arg}'"),
        ErrorKind::UnknownArgument => format!("argumento '{arg}' desconhecido"),
        ErrorKind::InvalidSubcommand => format!("comando '{}' desconhecido", context(ContextKind::InvalidSubcommand)),
        ErrorKind::ValueValidation => format!("valor '{value}' inválido para '{arg}'"),
        ErrorKind::TooManyValues => format!("valor '{value}' a mais para '{arg}'"),
        ErrorKind::TooFewValues | ErrorKind::WrongNumberOfValues => format!("número errado de valores para '{arg}'"),
        ErrorKind::NoEquals => format!("falta '=' depois de '{arg}'"),
        ErrorKind::ArgumentConflict => {
            let other = context(ContextKind::PriorArg);
            if other.is_empty() || other == arg {
                format!("'{arg}' só pode ser usado uma vez")
            } else {
                format!("'{arg}' não pode ser usado com '{other}'")
            }
        }
        ErrorKind::MissingRequiredArgument => format!("falta o argumento obrigatório {arg}"),
        ErrorKind::InvalidUtf8 => "um argumento não é UTF-8".to_owned(),
        _ => english(error),
    };
    for (kind, before) in [
        (ContextKind::ValidValue, "permitido"),
        (ContextKind::SuggestedArg, "você quis dizer"),
        (ContextKind::SuggestedValue, "você quis dizer"),
        (ContextKind::SuggestedSubcommand, "você quis dizer"),
    ] {
        let found = context(kind);
        if !found.is_empty() {
            text += &format!("; {before}: {found}");
        }
    }
    text
}

/// A fault in a file, with the line if it's known.
pub fn in_file(lang: Lang, name: &str, line: Option<usize>, what: &str) -> String {
    match line {
        Some(line) => both!(lang; "{name}, line {line}: {what}", "{name}, linha {line}: {what}"),
        None => format!("{name}: {what}"),
    }
}

/// An argument of `--show` without a value.
pub const fn show_without_value(lang: Lang) -> &'static str {
    pick!(lang; "it has no value; allowed: KEY=VALUE, such as stage=clip",
        "não tem valor; permitido: CHAVE=VALOR, como stage=clip")
}

/// A key, `[show] triangle.object`, names an object that the scene doesn't have. Lists those that it has.
pub fn no_such_object(lang: Lang, key: &str, object: &str, objects: &[&str]) -> String {
    const MOST: usize = 12;
    let mut names: Vec<String> = objects.iter().take(MOST).map(|name| format!("\"{}\"", escaped(name))).collect();
    if objects.len() > MOST {
        names.push("…".to_owned());
    }
    let (object, names) = (escaped(object), names.join(", "));
    both!(lang; "{key} is \"{object}\", which the scene does not have; allowed: {names}",
        "{key} é \"{object}\", que a cena não tem; permitido: {names}")
}

/// The triangle to follow is beyond the last one of its object.
pub fn no_such_triangle(lang: Lang, object: &str, index: u32, count: usize) -> String {
    let object = escaped(object);
    match count.checked_sub(1) {
        Some(last) => both!(lang; "[show] triangle.index is {index}; allowed for \"{object}\": 0 to {last}",
            "[show] triangle.index é {index}; permitido para \"{object}\": de 0 a {last}"),
        None => both!(lang; "[show] triangle.object is \"{object}\", which has no triangles",
            "[show] triangle.object é \"{object}\", que não tem triângulos"),
    }
}

/// Several views for a strip of stills.
pub const fn one_view_in_a_strip(lang: Lang) -> &'static str {
    pick!(lang; "a strip of stills shows one view; for several, write a .gif or .apng, or use \"sheet\"",
        "uma tira de quadros mostra uma só vista; para várias, grave um .gif ou .apng, ou use \"sheet\"")
}

/// A source that has no steps for a camera.
pub fn no_steps(lang: Lang, decomposition: Decomposition) -> String {
    let source = decomposition.source();
    match decomposition {
        Decomposition::Scale => both!(lang; "{source} has these steps only in perspective with a symmetric window",
            "{source} tem esses passos só em perspectiva com janela simétrica"),
        _ => both!(lang; "{source} has these steps only with a symmetric window",
            "{source} tem esses passos só com janela simétrica"),
    }
}

/// A pixel that the image doesn't have. It has a ray all the same.
pub fn pixel_outside(lang: Lang, [i, j]: [i64; 2], image: ImageSize) -> String {
    let ImageSize { width, height } = image;
    let (right, bottom) = (i64::from(width) - 1, i64::from(height) - 1);
    both!(lang; "--pixel {i},{j} lies outside the image, which has columns 0 to {right} and rows 0 to {bottom}; its ray is printed anyway",
        "--pixel {i},{j} fica fora da imagem, que tem colunas de 0 a {right} e linhas de 0 a {bottom}; o raio é impresso mesmo assim")
}

/// The words around the table of stages.
#[derive(Debug)]
pub struct ExplainTexts {
    /// Heads of its columns.
    pub columns: [&'static str; 6],
    /// The time of all.
    pub total: &'static str,
    /// The meaning of the mark for "timed with another stage".
    pub together: &'static str,
    /// Heads of the columns of cost.
    pub cost: [&'static str; 3],
    /// The sums of cost: of the stages that work on vertices and faces, of those that work on pixels, and of all.
    pub blocks: [&'static str; 3],
    /// The meaning of the columns of cost.
    pub counted: &'static str,
}

/// The words around the table of stages.
pub const fn explain(lang: Lang) -> &'static ExplainTexts {
    const EN: ExplainTexts = ExplainTexts {
        columns: ["stage", "in", "out", "of", "µs", "why"],
        total: "from the scene to the last pixel",
        together: "(″: in the time of the stage that it runs with)",
        cost: ["float", "integer", "memory"],
        blocks: ["geometry", "rasterization", "both"],
        counted: "Operations on floating-point and on whole numbers, and numbers read from memory or written to it: those of the \
                  textbook's algorithms.\nNot counted (·): work on whole objects, lines, marks and texts.",
    };
    const PT_BR: ExplainTexts = ExplainTexts {
        columns: ["etapa", "entra", "sai", "de", "µs", "por quê"],
        total: "da cena ao último pixel",
        together: "(″: no tempo da etapa com que é executada)",
        cost: ["flutuante", "inteira", "memória"],
        blocks: ["geometria", "rasterização", "as duas"],
        counted: "Operações com números de ponto flutuante e com inteiros, e números lidos da memória ou escritos nela: os dos \
                  algoritmos dos livros.\nSem contagem (·): o trabalho com objetos inteiros, linhas, marcas e textos.",
    };
    pick!(lang; &EN, &PT_BR)
}

/// A measurement: the picture, the number of triangles and frames, and median, least and 95 % of the times in ms.
pub fn bench(lang: Lang, what: &str, triangles: usize, frames: usize, [median, min, p95]: [f64; 3]) -> String {
    let times = |p95_name: &str, least: &str, middle: &str| {
        format!("{middle} {median:.3} ms, {least} {min:.3} ms, {p95_name} {p95:.3} ms\n")
    };
    match lang {
        Lang::En => {
            let frames = if frames == 1 { "1 frame".to_owned() } else { format!("{frames} frames") };
            format!("{what}: {triangles} triangles, {frames}\n{}", times("95 % within", "least", "median"))
        }
        Lang::PtBr => {
            let frames = if frames == 1 { "1 quadro".to_owned() } else { format!("{frames} quadros") };
            format!("{what}: {triangles} triângulos, {frames}\n{}", times("95 % em até", "mínimo", "mediana"))
        }
    }
}

/// A sheet on which this many pictures have no room beside the gaps between them.
pub fn no_room(lang: Lang, count: usize, [width, height]: [u64; 2], gap: u32) -> String {
    both!(lang; "{count} images with gaps of {gap} pixels do not fit into {width} × {height} pixels; the gaps grow with --letters and --scale; allowed: a larger --size or --width-cm, or smaller letters",
        "{count} imagens com intervalos de {gap} pixels não cabem em {width} × {height} pixels; os intervalos crescem com --letters e --scale; permitido: --size ou --width-cm maior, ou letras menores")
}

/// A size on paper of less than a pixel.
pub fn no_pixel(lang: Lang, [option, centimetres]: [&str; 2], dpi: f64) -> String {
    let centimetres = escaped(centimetres);
    both!(lang; "{option} {centimetres} is less than one pixel at {dpi} pixels per inch; allowed: a larger {option} or --dpi",
        "{option} {centimetres} é menos de um pixel a {dpi} pixels por polegada; permitido: {option} ou --dpi maior")
}

fn picture_endings() -> String {
    PictureFormat::ALL.map(|format| format!(".{}", format.ending())).join(", ")
}

/// A picture without ground in a format that has none.
pub fn no_transparency(lang: Lang, format: PictureFormat) -> String {
    let able = PictureFormat::ALL.into_iter().filter(|format| format.has_transparency());
    let endings = able.map(|format| format!(".{}", format.ending())).collect::<Vec<_>>().join(", ");
    let name = format.name();
    both!(lang; "--transparent: {name} has no transparency; allowed: an --output that ends in {endings}",
        "--transparent: {name} não tem transparência; permitido: um --output que termina em {endings}")
}

/// The place where numbers are printed.
pub const fn standard_output(lang: Lang) -> &'static str {
    pick!(lang; "standard output", "a saída padrão")
}

/// No display, or no OpenGL.
pub fn no_window(lang: Lang, why: &str) -> String {
    // The window's library names the line of its source before the reason.
    let reason =
        why.rsplit_once(".rs:").map_or(why, |(_, rest)| rest.trim_start_matches(|c: char| c.is_numeric() || c == ':'));
    let reason: Vec<_> = reason.split_whitespace().collect();
    let reason = reason.join(" ");
    let why = reason.trim_end_matches('.');
    both!(lang; "no window can be opened here ({why}); `camera-lab render FIGURE -o picture.png` draws without one, and the page camera-lab.html is the same window in a browser",
        "não é possível abrir uma janela aqui ({why}); `camera-lab render FIGURA -o imagem.png` desenha sem janela, e a página camera-lab.html é a mesma janela em um navegador")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reason_for_no_window_is_one_sentence_without_paths() {
        let why = "winit EventLoopError: os error at /home/x/linux/mod.rs:765: neither A\nnor B is set.";
        let text = no_window(Lang::En, why);
        assert!(
            text.starts_with("no window can be opened here (neither A nor B is set); `camera-lab render"),
            "{text}"
        );
        assert!(no_window(Lang::PtBr, "sem OpenGL").contains("(sem OpenGL)"));
    }
}
