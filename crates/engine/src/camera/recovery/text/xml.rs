//! Elements of XML → nodes.

use super::tree::{DEPTH, Node, Value, fold, listed};

/// The numbers of a text, or the text.
fn content(text: &str) -> Value {
    match listed(text) {
        Some(numbers) => {
            let lines = text.lines().map(|line| line.split_whitespace().count()).filter(|count| *count > 0).collect();
            Value::Numbers(numbers, lines)
        }
        None => Value::Word(text.to_owned()),
    }
}

/// The tree of XML.
pub(crate) fn read(text: &str) -> Node {
    Node::new("", fold(xml(text)))
}

/// The elements of XML: attributes are nodes as well. An attribute that names an element is its name.
fn xml(text: &str) -> Vec<Node> {
    let mut open: Vec<(Node, Vec<Node>)> = vec![Default::default()];
    let mut rest = text;
    while let Some(at) = rest.find('<') {
        let between = rest[..at].trim();
        // There is always the whole.
        if let Some((_, inner)) = open.last_mut().filter(|_| !between.is_empty()) {
            inner.push(Node::new("", content(between)));
        }
        rest = &rest[at..];
        let end = if rest.starts_with("<!--") { "-->" } else { ">" };
        let Some(length) = rest.find(end) else { break };
        let tag = &rest[1..length];
        rest = &rest[length + end.len()..];
        if tag.starts_with(['?', '!']) {
            continue;
        }
        if !tag.starts_with('/') && open.len() <= DEPTH {
            open.push(element(tag.trim_end_matches('/')));
        }
        if (tag.starts_with('/') || tag.ends_with('/')) && open.len() > 1 {
            // It has more than the whole.
            close(&mut open);
        }
    }
    while open.len() > 1 {
        close(&mut open);
    }
    open.pop().map(|(_, inner)| inner).unwrap_or_default()
}

/// Puts the last open element into the one around it.
fn close(open: &mut Vec<(Node, Vec<Node>)>) {
    if let Some((mut node, inner)) = open.pop()
        && let Some((_, outer)) = open.last_mut()
    {
        node.value = fold(inner);
        outer.push(node);
    }
}

fn element(tag: &str) -> (Node, Vec<Node>) {
    let (name, mut rest) = tag.split_once(char::is_whitespace).unwrap_or((tag, ""));
    let mut node = Node { name: name.to_owned(), call: name.to_owned(), ..Node::default() };
    let mut inner = Vec::new();
    while let Some((key, after)) = rest.split_once('=') {
        let after = after.trim_start();
        let Some(mark) = after.chars().next().filter(|c| matches!(c, '"' | '\'')) else { break };
        let Some((value, after)) = after[1..].split_once(mark) else { break };
        rest = after;
        match key.trim() {
            "name" | "sid" if name != "node" && name != "camera" => value.clone_into(&mut node.name),
            "value" | "data" => inner.push(Node::new("", content(value))),
            key => inner.push(Node::new(key, content(value))),
        }
    }
    (node, inner)
}
