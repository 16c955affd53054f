//! Writes the texts of `assets/words` as Rust.
//!
//! Each file `LANG/PLACE.toml` has lines `key = "text"` or lists `key = ["text", "text"]`. Those at its top become the
//! fields of a struct `Texts` with one value for each language. Those under `[lines]` become arms of a macro `text!`,
//! which inserts values into them: `{name}` is a value, and a brace of the text itself stands twice. Every language has
//! the keys of English and inserts the same values, or the build fails.
//!
//! TOML is read here by hand: these few forms take 40 lines, while a library would be built before everything else.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// From the folder of this crate.
const WORDS: &str = "../../assets/words";
const ASSETS: &str = "../../assets";

/// Folders with a page in Markdown for each language.
const PAGES: [&str; 2] = ["exercises", "notes"];

/// The language that names the keys.
const REFERENCE: &str = "en";

/// The texts of one key in one language.
struct Entry {
    line: usize,
    key: String,
    /// Whether it stands under `[lines]`.
    in_lines: bool,
    /// As Rust literals.
    literals: Vec<String>,
    is_list: bool,
    /// The names of its values, each with its format.
    values: BTreeSet<String>,
}

impl Entry {
    /// Its key, which the two parts of a file may have both.
    fn name(&self) -> (bool, &str) {
        (self.in_lines, &self.key)
    }

    /// The parts of a text that must be the same in every language.
    fn shape(&self) -> (bool, usize, &BTreeSet<String>) {
        (self.is_list, self.literals.len(), &self.values)
    }

    /// The text as a Rust expression without values.
    fn plain(&self) -> String {
        let single = |literal: &String| match self.in_lines {
            true => literal.replace("{{", "{").replace("}}", "}"),
            false => literal.clone(),
        };
        let texts: Vec<String> = self.literals.iter().map(single).map(|literal| unicode(&literal)).collect();
        if self.is_list { format!("[{}]", texts.join(", ")) } else { texts.concat() }
    }
}

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed={WORDS}");
    println!("cargo::rerun-if-changed=build.rs");
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    let mut languages: Vec<String> = names(Path::new(WORDS))?.into_iter().filter(|name| name != REFERENCE).collect();
    languages.insert(0, REFERENCE.to_owned());
    fs::write(out.join("pages.rs"), pages(&languages)?)?;
    let mut places = Vec::new();
    collect(&Path::new(WORDS).join(REFERENCE), "", &mut places)?;
    let mut faults = Vec::new();
    for language in &languages[1..] {
        let mut own = Vec::new();
        collect(&Path::new(WORDS).join(language), "", &mut own)?;
        let extra = own.iter().filter(|place| !places.contains(place));
        faults.extend(extra.map(|place| format!("{WORDS}/{language}/{place}.toml: {REFERENCE} has no such file")));
    }
    for place in &places {
        let mut texts = Vec::new();
        for language in &languages {
            let path = format!("{WORDS}/{language}/{place}.toml");
            let text = fs::read_to_string(&path).unwrap_or_else(|error| {
                faults.push(format!("{path}: {error}"));
                String::new()
            });
            texts.push(read(&path, &text, &mut faults));
        }
        for (language, own) in languages.iter().zip(&texts).skip(1) {
            compare(&format!("{WORDS}/{language}/{place}.toml"), &texts[0], own, &mut faults);
        }
        if faults.is_empty() {
            let path = out.join("words").join(format!("{place}.rs"));
            fs::create_dir_all(path.parent().unwrap_or(&out))?;
            fs::write(path, rust(&languages, &texts))?;
        }
    }
    faults.iter().for_each(|fault| println!("cargo::error={}", fault.replace("../../", "")));
    Ok(())
}

/// A function for each page: its text in a language, or in English if there is none.
fn pages(languages: &[String]) -> io::Result<String> {
    let mut out = "use crate::Lang;\n".to_owned();
    for page in PAGES {
        println!("cargo::rerun-if-changed={ASSETS}/{page}");
        let path = |language: &str| Path::new(ASSETS).join(page).join(format!("{language}.md"));
        let arms = languages.iter().map(|language| {
            let own = Some(path(language)).filter(|own| own.exists());
            let file = fs::canonicalize(own.unwrap_or_else(|| path(REFERENCE)))?;
            Ok(format!("Lang::{} => include_str!({file:?}),\n", variant(language).0))
        });
        let arms = arms.collect::<io::Result<String>>()?;
        out += &format!("pub(crate) const fn {page}(lang: Lang) -> &'static str {{ match lang {{ {arms} }} }}\n");
    }
    Ok(out)
}

/// The names in a folder, sorted.
fn names(folder: &Path) -> io::Result<Vec<String>> {
    let names = fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    let mut names = names.collect::<io::Result<Vec<String>>>()?;
    names.sort();
    Ok(names)
}

/// The files below a folder as `window/canvas`.
fn collect(folder: &Path, before: &str, into: &mut Vec<String>) -> io::Result<()> {
    for name in names(folder)? {
        if let Some(place) = name.strip_suffix(".toml") {
            into.push(format!("{before}{place}"));
        } else {
            collect(&folder.join(&name), &format!("{before}{name}/"), into)?;
        }
    }
    Ok(())
}

/// The entries of a file.
fn read(path: &str, text: &str, faults: &mut Vec<String>) -> Vec<Entry> {
    let (mut entries, mut in_lines) = (Vec::<Entry>::new(), false);
    let mut lines = (1..).zip(text.lines().map(str::trim));
    while let Some((number, line)) = lines.next() {
        let mut line = line.to_owned();
        if line.ends_with(" = [") {
            lines.by_ref().map(|(_, more)| more).take_while(|more| *more != "]").for_each(|more| line += more);
            line.push(']');
        }
        match line.as_str() {
            "[lines]" => in_lines = true,
            _ if line.is_empty() || line.starts_with('#') => {}
            _ => match entry(number, &line, in_lines) {
                Ok(entry) if entries.iter().any(|other| other.name() == entry.name()) => {
                    faults.push(format!("{path}:{number}: {} is there twice", entry.key));
                }
                Ok(entry) if entry.is_list && !in_lines => {
                    faults.push(format!("{path}:{number}: a list stands under [lines]"));
                }
                Ok(entry) => entries.push(entry),
                Err(why) => faults.push(format!("{path}:{number}: {why}")),
            },
        }
    }
    entries
}

fn entry(line: usize, text: &str, in_lines: bool) -> Result<Entry, &'static str> {
    let (key, mut rest) = text.split_once(" = ").ok_or("expected key = \"text\"")?;
    if key.is_empty() || key.contains(|c: char| !(c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')) {
        return Err("a key has letters a to z, digits and _");
    }
    let is_list = rest.starts_with('[');
    let mut literals = Vec::new();
    if is_list {
        while let Some(after) = rest.strip_prefix(['[', ',']).filter(|after| *after != "]") {
            let (literal, after) = literal(after.trim_start())?;
            literals.push(literal);
            rest = after.trim_start();
        }
        rest = rest.trim_start_matches(',').strip_prefix(']').ok_or("expected [\"text\", \"text\"]")?;
    } else {
        let (literal, after) = literal(rest)?;
        literals.push(literal);
        rest = after;
    }
    if !rest.trim().is_empty() {
        return Err("there is more after the text");
    }
    let mut values = BTreeSet::new();
    if in_lines {
        literals.iter().try_for_each(|literal| find_values(literal, &mut values))?;
    }
    if is_list && !values.is_empty() {
        return Err("texts of a list take no values");
    }
    Ok(Entry { line, key: key.to_owned(), in_lines, literals, is_list, values })
}

/// The text in quotes at the beginning, with its quotes, and the rest. Its escapes are those of Rust too, except
/// `\u`.
fn literal(text: &str) -> Result<(String, &str), &'static str> {
    let inner = text.strip_prefix('"').ok_or("a text stands in double quotes")?;
    let mut letters = inner.char_indices();
    while let Some((at, letter)) = letters.next() {
        match letter {
            '"' => return Ok((text[..at + 2].to_owned(), &inner[at + 1..])),
            '\\' if !is_escape(&inner[at + 1..]) => {
                return Err("after \\ may stand \", \\, n, t or u with four digits");
            }
            '\\' => drop(letters.next()),
            _ => {}
        }
    }
    Err("the text has no end on its line")
}

/// Whether the text after a backslash is an escape.
fn is_escape(rest: &str) -> bool {
    let digits = rest.strip_prefix('u').and_then(|rest| rest.get(..4));
    rest.starts_with(['"', '\\', 'n', 't']) || digits.is_some_and(|d| d.bytes().all(|b| b.is_ascii_hexdigit()))
}

/// Adds the values of a text with their formats.
fn find_values(literal: &str, values: &mut BTreeSet<String>) -> Result<(), &'static str> {
    const SINGLE: &str = "a brace that isn't around the name of a value stands twice";
    let mut rest = literal;
    while let Some(at) = rest.find(['{', '}']) {
        let inner = &rest[at + 1..];
        if rest[at..].starts_with("{{") || rest[at..].starts_with("}}") {
            rest = &rest[at + 2..];
            continue;
        }
        let end = inner.find('}').filter(|_| rest[at..].starts_with('{')).ok_or(SINGLE)?;
        let name = inner[..end].split(':').next().unwrap_or_default();
        if name.is_empty() || name.contains(|c: char| !(c.is_ascii_alphanumeric() || c == '_')) {
            return Err(SINGLE);
        }
        values.insert(inner[..end].to_owned());
        rest = &inner[end + 1..];
    }
    Ok(())
}

/// `\u00A0` of TOML as `\u{00A0}` of Rust.
fn unicode(literal: &str) -> String {
    let mut parts = literal.split("\\u");
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (digits, rest) = part.split_at_checked(4).unwrap_or((part, ""));
        out += &format!("\\u{{{digits}}}{rest}");
    }
    out
}

/// Compares a language with the reference.
fn compare(path: &str, reference: &[Entry], own: &[Entry], faults: &mut Vec<String>) {
    for entry in reference {
        let Some(other) = own.iter().find(|other| other.name() == entry.name()) else {
            faults.push(format!("{path}: {} is missing; {REFERENCE} has it in line {}", entry.key, entry.line));
            continue;
        };
        if other.shape() != entry.shape() {
            let shape = match entry.values.is_empty() {
                true => "another number of texts".to_owned(),
                false => format!("the values {{{}}}", entry.values.iter().cloned().collect::<Vec<_>>().join("}, {")),
            };
            faults.push(format!("{path}:{}: in {REFERENCE}, {} has {shape}", other.line, entry.key));
        }
    }
    let extra = own.iter().filter(|entry| !reference.iter().any(|other| other.name() == entry.name()));
    faults.extend(extra.map(|entry| format!("{path}:{}: {REFERENCE} has no {}", entry.line, entry.key)));
}

/// The variant of `Lang`, and the name of its static: `pt-BR` is `PtBr` and `PT_BR`.
fn variant(language: &str) -> (String, String) {
    let word = |part: &str| part[..1].to_uppercase() + &part[1..].to_lowercase();
    (language.split('-').map(word).collect(), language.to_uppercase().replace('-', "_"))
}

/// The program text of a place, from its texts in each language.
fn rust(languages: &[String], texts: &[Vec<Entry>]) -> String {
    let arm = |language: &str, value: &str| format!("Lang::{} => {value},\n", variant(language).0);
    let (lines, fields): (Vec<&Entry>, Vec<&Entry>) = texts[0].iter().partition(|entry| entry.in_lines);
    let mut out = String::new();
    if !fields.is_empty() {
        let declare = |entry: &Entry| {
            let text = &entry.literals[0][1..entry.literals[0].len() - 1];
            let code = if text.contains('`') { format!("`` {text} ``") } else { format!("`{text}`") };
            format!("#[doc = \"{}\"] pub {}: &'static str,\n", unicode(&code), entry.key)
        };
        let declared: String = fields.iter().map(|entry| declare(entry)).collect();
        let entries: String = fields.iter().map(|entry| format!("({0:?}, self.{0}), ", entry.key)).collect();
        let statics = languages.iter().zip(texts).map(|(language, texts)| {
            let (variant, name) = variant(language);
            let own = texts.iter().filter(|entry| !entry.in_lines);
            let own: String = own.map(|entry| format!("{}: {},\n", entry.key, entry.plain())).collect();
            format!("static {name}: Texts = Texts {{ lang: Lang::{variant},\n{own}}};\n")
        });
        let statics: String = statics.collect();
        let arms: String =
            languages.iter().map(|language| arm(language, &format!("&{}", variant(language).1))).collect();
        out += &format!(
            "/// Every text of this place in one language.
#[derive(Debug)]
pub struct Texts {{
/// The language.
pub lang: Lang,
{declared}}}
{statics}
/// The words of a language.
pub const fn texts(lang: Lang) -> &'static Texts {{ match lang {{ {arms} }} }}
impl Texts {{
/// Name and text of each entry, for tests.
pub fn entries(&self) -> Vec<(&'static str, &'static str)> {{ vec![{entries}] }}
}}
"
        );
    }
    if !lines.is_empty() {
        let mut macro_arms = String::new();
        for line in lines {
            let key = &line.key;
            let (given, values) = match line.values.is_empty() {
                true => ("", ""),
                false => (" $(, $name:ident $(= $value:expr)?)+ $(,)?", ", $($name = value!($name $($value)?)),+"),
            };
            let arms = languages.iter().zip(texts).map(|(language, texts)| {
                let own = texts.iter().find(|entry| entry.name() == line.name());
                let value = own.map_or_else(String::new, |own| match values {
                    "" => own.plain(),
                    _ => format!("format!({}{values})", unicode(&own.literals[0])),
                });
                arm(language, &value)
            });
            let arms: String = arms.collect();
            // Writing to a string can't fail.
            let _ = writeln!(macro_arms, "($lang:expr, {key}{given}) => {{ match $lang {{ {arms} }} }};");
        }
        out += &format!("macro_rules! text {{\n{macro_arms}}}\n");
    }
    out
}
