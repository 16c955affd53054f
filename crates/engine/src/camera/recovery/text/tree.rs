//! Any text of another program → one tree of names and values.
//!
//! JSON, YAML, TOML, XML, scene files and lines of code have one shape: a name, then numbers, a word, or a group with
//! names of its own. What differs are marks: `=` and `:`, brackets, indentation, tags.

use crate::camera::recovery::MatrixTextError;
use crate::camera::recovery::reading::Written;
use crate::camera::recovery::text::names::{meaning, plain as plain_name};
use crate::camera::recovery::text::tokens::{Reader, Token};
use crate::camera::recovery::text::tokens::{has_decimal_commas, is_separator, without_indices, written};

/// The depth of nesting that is read. No camera needs more.
pub(crate) const DEPTH: usize = 60;

/// A name and its value.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Node {
    /// As it's written. Empty for an item of a list.
    pub(crate) name: String,
    /// The function or the type before the value: `np.array`, `THREE.Vector3`.
    pub(crate) call: String,
    pub(crate) value: Value,
}

/// Numbers, a word, or nodes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    /// Numbers, and their counts in each line or bracket.
    Numbers(Vec<Written>, Vec<usize>),
    Word(String),
    Inner(Vec<Node>),
}

impl Default for Value {
    fn default() -> Self {
        Self::Inner(Vec::new())
    }
}

/// Names after which numbers aren't entries, such as the shape of an array.
const SHAPES: &str = "rows cols dt dtype device type version layout length prototype shape step channels size index id number_of_elements";

impl Node {
    pub(crate) fn new(name: &str, value: Value) -> Self {
        Self { name: name.to_owned(), call: String::new(), value }
    }

    /// Exact numbers under a name.
    pub(crate) fn exact(name: &str, numbers: &[f64]) -> Self {
        let numbers = numbers.iter().map(|value| Written { value: *value, error: 0.0 }).collect();
        Self::new(name, Value::Numbers(numbers, Vec::new()))
    }

    pub(crate) fn children(&self) -> &[Self] {
        match &self.value {
            Value::Inner(nodes) => nodes,
            _ => &[],
        }
    }

    pub(crate) fn child(&self, name: &str) -> Option<&Self> {
        self.children().iter().find(|node| node.name == name)
    }

    pub(crate) fn word(&self) -> Option<&str> {
        match &self.value {
            Value::Word(word) => Some(word),
            _ => None,
        }
    }

    /// The number of a child.
    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        self.child(name)?.values().first().copied()
    }

    pub(crate) fn is_shape(&self) -> bool {
        SHAPES.split(' ').any(|shape| shape.eq_ignore_ascii_case(&self.name))
    }

    /// All numbers below, and their counts in each line, but not those of shapes.
    pub(crate) fn numbers(&self) -> (Vec<Written>, Vec<usize>) {
        let mut all = (Vec::new(), Vec::new());
        self.gather(&mut all);
        all
    }

    /// The count of all numbers below, but not those of shapes.
    pub(crate) fn count(&self) -> usize {
        match &self.value {
            Value::Numbers(numbers, _) => numbers.len(),
            Value::Word(_) => 0,
            Value::Inner(nodes) => nodes.iter().filter(|node| !node.is_shape()).map(Self::count).sum(),
        }
    }

    fn gather(&self, all: &mut (Vec<Written>, Vec<usize>)) {
        match &self.value {
            Value::Numbers(numbers, lines) => {
                all.0.extend(numbers);
                all.1.extend(lines);
            }
            Value::Word(_) => {}
            Value::Inner(nodes) => nodes.iter().filter(|node| !node.is_shape()).for_each(|node| node.gather(all)),
        }
    }

    pub(crate) fn values(&self) -> Vec<f64> {
        self.numbers().0.iter().map(|number| number.value).collect()
    }

    /// Each part that has numbers, with its name, in the order of the text.
    pub(crate) fn leaves(&self, into: &mut Vec<Self>) {
        match &self.value {
            Value::Numbers(..) if !self.is_shape() => into.push(self.clone()),
            Value::Inner(nodes) if !self.is_shape() => {
                for node in nodes {
                    let at = into.len();
                    node.leaves(into);
                    into[at..].iter_mut().filter(|leaf| leaf.name.is_empty() || leaf.name == "data").for_each(|leaf| {
                        leaf.name.clone_from(&self.name);
                    });
                }
            }
            _ => {}
        }
    }
}

/// One value of several nodes: numbers without names are one list.
pub(crate) fn fold(mut nodes: Vec<Node>) -> Value {
    let are_numbers = nodes.iter().all(|node| node.name.is_empty() && matches!(node.value, Value::Numbers(..)));
    if nodes.len() == 1 && nodes[0].name.is_empty() && nodes[0].call.is_empty() {
        return nodes.swap_remove(0).value;
    }
    if !are_numbers || nodes.is_empty() {
        // Coordinates stand in any order.
        let axis = |node: &Node| {
            let name = node.name.to_lowercase();
            ["x", "y", "z", "w"].into_iter().position(|axis| name.strip_prefix('q').unwrap_or(&name) == axis)
        };
        if nodes.iter().all(|node| axis(node).is_some()) {
            nodes.sort_by_key(axis);
        }
        // Lists of pairs, as in Lisp.
        let is_pair = |node: &Node| node.name.is_empty() && matches!(node.children(), [own] if !own.name.is_empty());
        let are_pairs = nodes.len() > 1 && nodes.iter().filter(|node| node.name.is_empty()).all(is_pair);
        let name = |node: &Node| node.children().first().map(|own| own.name.clone());
        let is_distinct = (1..nodes.len()).all(|at| nodes[..at].iter().all(|before| name(before) != name(&nodes[at])));
        if are_pairs && is_distinct {
            let own = |node: Node| match node.value {
                Value::Inner(inner) if node.name.is_empty() => inner,
                value => vec![Node { value, ..node }],
            };
            return Value::Inner(nodes.into_iter().flat_map(own).collect());
        }
        return Value::Inner(nodes);
    }
    let (mut numbers, mut lines) = (Vec::new(), Vec::new());
    for node in nodes {
        if let Value::Numbers(own, counts) = node.value {
            numbers.extend(own);
            lines.extend(counts);
        }
    }
    Value::Numbers(numbers, lines)
}

/// The tree of a text.
///
/// # Errors
/// [`MatrixTextError::Elided`].
pub(crate) fn read(text: &str) -> Result<Node, MatrixTextError> {
    Ok(Node::new("", fold(plain(text)?)))
}

fn plain(text: &str) -> Result<Vec<Node>, MatrixTextError> {
    let text = without_indices(text);
    let spaced: String = text.chars().map(|c| if is_separator(c) { ' ' } else { c }).collect();
    let mut reader = Reader {
        rest: &text,
        decimal_commas: has_decimal_commas(&spaced),
        column: 0,
        indent: 0,
        at_start: true,
        after_space: true,
        factor: 1.0,
        ahead: Vec::new(),
        has_numbers: false,
        is_elided: false,
    };
    let nodes = reader.nodes(None, 0, 0);
    if reader.is_elided {
        return Err(MatrixTextError::Elided);
    }
    // A section of TOML has all that follows.
    let mut all: Vec<Node> = Vec::new();
    let mut is_inside = false;
    for mut node in components(nodes) {
        if node.name.starts_with('[') {
            node.name.remove(0);
            (is_inside, node.call) = (true, "section".to_owned());
            all.push(node);
        } else if is_inside && let Some(Node { value: Value::Inner(own), .. }) = all.last_mut() {
            own.push(node);
        } else {
            all.push(node);
        }
    }
    Ok(all)
}

/// `position.x`, `position.y` and `position.z` are one vector, and a node of VRML has its name before it.
fn components(nodes: Vec<Node>) -> Vec<Node> {
    let mut all: Vec<Node> = Vec::new();
    for mut node in nodes {
        if let [.., def, own] = &all[..]
            && def.name == "DEF"
        {
            (node.call, node.name) = (node.name, own.name.clone());
            all.truncate(all.len() - 2);
        }
        let base = node.name.strip_suffix(['x', 'y', 'z', 'w']).and_then(|name| name.strip_suffix(['.', '_']));
        let base = base
            .filter(|base| {
                !base.is_empty() && node.count() == 1 && meaning(&plain_name(&node.name), 1, false).is_none()
            })
            .map(str::to_owned);
        match (base, all.last_mut()) {
            (Some(base), Some(Node { name, value: Value::Inner(parts), .. })) if *name == base && !parts.is_empty() => {
                parts.push(Node { name: node.name[base.len() + 1..].to_owned(), ..node });
            }
            (Some(base), _) if matches!(node.name.as_bytes(), [.., b'x' | b'w']) => {
                let part = Node { name: node.name[base.len() + 1..].to_owned(), ..node };
                all.push(Node::new(&base, Value::Inner(vec![part])));
            }
            _ => all.push(node),
        }
    }
    all
}

impl Reader<'_> {
    /// The nodes up to a bracket, or of a block of lines that are indented as far.
    fn nodes(&mut self, close: Option<char>, indent: usize, depth: usize) -> Vec<Node> {
        let mut all = Sequence { fresh: true, ..Sequence::default() };
        // A list of YAML may stand as far to the left as its name.
        let is_list = close.is_none() && matches!(self.peek(), Token::Dash);
        loop {
            match self.token() {
                Token::End => break,
                Token::Close(c) => {
                    if Some(c) == close {
                        break;
                    }
                }
                Token::Open(c) if depth < DEPTH => {
                    let is_alone = all.fresh && all.pending.is_empty() && !all.waits();
                    all.begin();
                    all.end_line();
                    let end = match c {
                        '[' => ']',
                        '(' => ')',
                        '{' => '}',
                        _ => '>',
                    };
                    let inner = self.nodes(Some(end), 0, depth + 1);
                    let is_end = matches!(self.peek(), Token::Line(..) | Token::End);
                    let is_section = c == '[' && depth == 0 && is_alone && is_end;
                    match section(&inner).filter(|_| is_section).map(|name| format!("[{name}")) {
                        Some(name) => {
                            all.finish();
                            let own = inner.into_iter().filter(|node| node.word() != Some("")).collect();
                            all.done.push(Node::new(&name, Value::Inner(own)));
                        }
                        // `-nan(ind)` of C.
                        None if all.is_run && inner.iter().all(|node| node.word() == Some("")) => {}
                        None => all.push(fold(inner)),
                    }
                }
                Token::Open(_) => {}
                Token::Comma => all.comma(close.is_some()),
                Token::Semicolon => {
                    all.end_line();
                    all.fresh = true;
                }
                Token::Number(number) => all.number(number),
                Token::Word(word) if word == "*" => {
                    if let (Token::Line(..), Some(factor)) = (self.peek(), all.only_number()) {
                        self.factor = factor;
                    }
                }
                // `1280 x 720`, and `16.0 / 9.0`.
                Token::Word(word) if matches!(word.as_str(), "/" | "x" | "×") && all.is_run => match self.peek() {
                    &Token::Number(by) if word == "/" => {
                        self.token();
                        all.divide(by.value);
                    }
                    Token::Number(_) => {}
                    _ => all.word(word),
                },
                Token::Word(word) => all.word(word),
                Token::Quoted(text) => {
                    let is_name = match self.peek() {
                        Token::Assign(_) => true,
                        Token::Number(_) | Token::Open(_) => !all.waits(),
                        _ => false,
                    };
                    match text.split_whitespace().last() {
                        Some(last) if is_typed(&text) => all.word(last.to_owned()),
                        Some(_) if is_name => all.word(text),
                        _ => all.text(&text),
                    }
                }
                Token::Assign(is_label) => {
                    self.factor = 1.0;
                    while matches!(self.peek(), Token::Assign(_)) {
                        self.token();
                    }
                    all.assign(self.indent, is_label);
                }
                Token::Dash if close.is_none() && depth < DEPTH => {
                    all.finish();
                    let column = self.column;
                    self.indent = column;
                    let inner = self.nodes(None, column, depth + 1);
                    all.done.push(Node::new("", fold(inner)));
                }
                Token::Dash => {}
                Token::Line(next, is_blank) => {
                    all.end_line();
                    if close.is_none() {
                        let is_dash = matches!(self.peek(), Token::Dash);
                        if all.waits_for_block()
                            && depth < DEPTH
                            && (next > all.indent || is_dash && next >= all.indent)
                        {
                            self.indent = next;
                            all.pending.clear();
                            let inner = self.nodes(None, next, depth + 1);
                            all.push(fold(inner));
                            all.finish();
                            continue;
                        }
                        if next < indent || is_list && !is_dash && next <= indent {
                            self.ahead.push(Token::Line(next, is_blank));
                            break;
                        }
                        self.indent = next;
                    }
                    if is_blank && !all.values.is_empty() {
                        all.finish();
                    }
                    all.fresh = true;
                }
            }
        }
        all.finish();
        all.done
    }
}

/// True for a name of pbrt with its type before it: `float fov`.
fn is_typed(text: &str) -> bool {
    let types = ["integer", "float", "string", "bool", "point", "vector", "rgb", "spectrum", "texture"];
    text.split_once(' ').is_some_and(|(kind, name)| types.contains(&kind) && !name.contains(' '))
}

/// The name of a section, if a bracket has no numbers: `[cam0]`, `[node name="Camera3D"]`.
fn section(inner: &[Node]) -> Option<&str> {
    let is_number = |node: &Node| !node.numbers().0.is_empty();
    let first = inner.first().filter(|node| !node.name.is_empty() && !inner.iter().any(is_number))?;
    inner.iter().find(|node| node.name == "name").and_then(Node::word).or(Some(first.name.as_str()))
}

/// Nodes on their way: those that are done, and one that takes values.
#[derive(Default)]
struct Sequence {
    done: Vec<Node>,
    /// Words that name something, or stand before it.
    pending: Vec<String>,
    /// Commas stand between them.
    has_commas: bool,
    /// The names of the node that takes values; none for an item of a list.
    names: Vec<String>,
    call: String,
    values: Vec<Node>,
    /// The last value is a run of numbers, with their count in this line.
    is_run: bool,
    in_line: usize,
    /// `=` or `:` came before.
    is_assigned: bool,
    /// The indentation of its name.
    indent: usize,
    /// A line begins.
    fresh: bool,
}

impl Sequence {
    /// A name waits for its value.
    fn waits(&self) -> bool {
        self.is_assigned && self.values.is_empty()
    }

    fn waits_for_block(&self) -> bool {
        self.waits() && self.pending.iter().all(|word| word.starts_with(['!', '&', '|', '>']))
    }

    /// Words before a value name it, or say what it is made by.
    fn begin(&mut self) {
        let Some(last) = self.pending.pop() else { return };
        if self.waits() || self.names.len() > 1 {
            self.call = last;
            self.pending.clear();
        } else {
            self.finish();
            self.names = vec![last];
        }
    }

    fn number(&mut self, number: Written) {
        self.begin();
        match self.values.last_mut() {
            Some(Node { value: Value::Numbers(numbers, _), .. }) if self.is_run => numbers.push(number),
            _ => self.values.push(Node::new("", Value::Numbers(vec![number], Vec::new()))),
        }
        (self.is_run, self.in_line, self.fresh) = (true, self.in_line + 1, false);
    }

    /// Divides the last number.
    fn divide(&mut self, by: f64) {
        if let Some(Node { value: Value::Numbers(numbers, _), .. }) = self.values.last_mut()
            && let Some(last) = numbers.last_mut()
        {
            *last = Written { value: last.value / by, error: 0.0 };
        }
    }

    fn push(&mut self, value: Value) {
        self.begin();
        self.values.push(Node::new("", value));
        (self.is_run, self.fresh) = (false, false);
    }

    /// Quoted text: numbers, or a word.
    fn text(&mut self, text: &str) {
        match listed(text) {
            Some(numbers) => numbers.into_iter().for_each(|number| self.number(number)),
            None => self.push(Value::Word(text.to_owned())),
        }
    }

    fn word(&mut self, word: String) {
        if self.fresh && !(self.waits() && self.pending.is_empty()) {
            self.finish();
        }
        self.fresh = false;
        self.pending.push(word);
    }

    fn comma(&mut self, is_inside: bool) {
        self.has_commas = !self.pending.is_empty();
        let is_word = self.waits() && self.has_commas;
        if is_word || is_inside && (self.is_assigned || !self.names.is_empty() || !self.pending.is_empty()) {
            self.finish();
        }
    }

    /// Words before `: ` are one name.
    fn assign(&mut self, indent: usize, is_label: bool) {
        let mut names = std::mem::take(&mut self.pending);
        let has_commas = std::mem::take(&mut self.has_commas);
        if is_label && !has_commas && !names.is_empty() {
            names = vec![names.join(" ")];
        }
        self.finish();
        let last = names.pop().unwrap_or_default();
        if !has_commas {
            names.drain(..).for_each(|word| self.done.push(Node::new(&word, Value::Word(String::new()))));
        }
        names.push(last);
        (self.names, self.is_assigned, self.indent, self.fresh) = (names, true, indent, false);
    }

    fn end_line(&mut self) {
        if let Some(Node { value: Value::Numbers(_, lines), .. }) = self.values.last_mut().filter(|_| self.in_line > 0)
        {
            lines.push(self.in_line);
        }
        self.in_line = 0;
    }

    /// The number, if there is one only, which is taken out.
    fn only_number(&mut self) -> Option<f64> {
        let [Node { value: Value::Numbers(numbers, _), .. }] = &self.values[..] else { return None };
        let [number] = numbers[..] else { return None };
        self.values.clear();
        self.in_line = 0;
        Some(number.value)
    }

    /// Ends the node that takes values.
    fn finish(&mut self) {
        self.end_line();
        let (names, values) = (std::mem::take(&mut self.names), std::mem::take(&mut self.values));
        let (call, is_assigned) = (std::mem::take(&mut self.call), std::mem::take(&mut self.is_assigned));
        (self.is_run, self.has_commas) = (false, false);
        if is_assigned && values.is_empty() {
            let word = std::mem::take(&mut self.pending).join(" ");
            self.done.extend(names.first().map(|name| Node::new(name, Value::Word(word))));
        } else if names.len() > 1 {
            self.done.extend(shared(&names, values));
        } else if let Some(name) = names.into_iter().next() {
            let mut node = Node { call, ..Node::new(&name, fold(values)) };
            // `radians(45)` is in degrees.
            let is_angle = |name: &str| name.to_lowercase().ends_with("radians");
            if let (Value::Numbers(numbers, _), true) = (&mut node.value, is_angle(&name) || is_angle(&node.call)) {
                numbers.iter_mut().for_each(|number| number.value = number.value.to_radians());
                node.name = if is_angle(&name) { String::new() } else { name };
            }
            self.done.push(node);
        } else {
            self.done.extend(values);
        }
        let bare = std::mem::take(&mut self.pending);
        self.done.extend(bare.into_iter().map(|word| Node::new(&word, Value::Word(String::new()))));
    }
}

/// Values for several names: `near, far = 0.1, 100`.
fn shared(names: &[String], values: Vec<Node>) -> Vec<Node> {
    let values = match fold(values) {
        Value::Numbers(numbers, _) if numbers.len() == names.len() => {
            numbers.into_iter().map(|number| Node::new("", Value::Numbers(vec![number], vec![1]))).collect()
        }
        Value::Numbers(numbers, _) if numbers.len().is_multiple_of(names.len()) => numbers
            .chunks(numbers.len() / names.len())
            .map(|part| Node::new("", Value::Numbers(part.to_vec(), vec![part.len()])))
            .collect(),
        Value::Inner(nodes) => nodes,
        other => vec![Node::new("", other)],
    };
    names.iter().zip(values).map(|(name, node)| Node { name: name.clone(), ..node }).collect()
}

/// The numbers of a text that has nothing else.
pub(crate) fn listed(text: &str) -> Option<Vec<Written>> {
    let parts = text.split(|c: char| c.is_whitespace() || c == ',').filter(|part| !part.is_empty());
    let numbers: Vec<Written> = parts.map(written).collect::<Option<_>>()?;
    (!numbers.is_empty()).then_some(numbers)
}
