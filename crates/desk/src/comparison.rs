//! The lines in which two texts differ.

use std::time::Duration;

use similar::DiffTag;
use similar::algorithms::{Capture, Compact, Replace, myers};
use web_time::Instant;

use crate::limits::MAX_COMPARED_LINES;

/// Equal lines shown around differing ones.
const AROUND: usize = 2;

/// For texts with little in common a rough comparison is enough, because the window waits for it.
const MAX_WAIT: Duration = Duration::from_millis(300);

/// The texts that have the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineOrigin {
    /// In both texts.
    Both,
    /// In the file alone.
    Theirs,
    /// In the window alone.
    Mine,
    /// None, because equal lines are left out here, or too many lines follow.
    Gap,
}

/// The differing lines of a file and the window, with a few around them, in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineComparison {
    /// Each line without its end.
    pub lines: Vec<(LineOrigin, String)>,
}

impl LineComparison {
    /// Compares the text of the file with the text that saving would write.
    pub fn new(theirs: &str, mine: &str) -> Self {
        let [theirs, mine] = [theirs, mine].map(|text| text.split_inclusive('\n').collect::<Vec<_>>());
        let mut found = Compact::new(Replace::new(Capture::new()), &theirs[..], &mine[..]);
        let deadline = Some(Instant::now() + MAX_WAIT);
        let Ok(()) = myers::diff_deadline(&mut found, &theirs[..], 0..theirs.len(), &mine[..], 0..mine.len(), deadline);
        let mut lines = Vec::new();
        for (number, group) in found.into_inner().into_inner().into_grouped_ops(AROUND).iter().enumerate() {
            if number > 0 {
                lines.push((LineOrigin::Gap, String::new()));
            }
            for operation in group {
                let (tag, in_theirs, in_mine) = operation.as_tag_tuple();
                let all: &[(LineOrigin, &[&str])] = match tag {
                    DiffTag::Equal => &[(LineOrigin::Both, &mine[in_mine])],
                    DiffTag::Delete | DiffTag::Insert | DiffTag::Replace => {
                        &[(LineOrigin::Theirs, &theirs[in_theirs]), (LineOrigin::Mine, &mine[in_mine])]
                    }
                };
                for (whose, line) in all.iter().flat_map(|(whose, lines)| lines.iter().map(|line| (*whose, *line))) {
                    if lines.len() >= MAX_COMPARED_LINES {
                        lines.push((LineOrigin::Gap, String::new()));
                        return Self { lines };
                    }
                    lines.push((whose, shown(line)));
                }
            }
        }
        Self { lines }
    }
}

/// The displayed part of a line, without its end.
fn shown(line: &str) -> String {
    crate::sanitize::printable(&line.trim_end_matches(['\r', '\n']).replace('\t', "    "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differing_lines_are_marked_with_a_few_around_them() {
        let theirs = "a\nb\nc\nd\nnear = 1\ne\nf\ng\nh\ni\nj\nk\n";
        let mine = "a\nb\nc\nd\nnear = 2\ne\nf\ng\nh\ni\nj\nk\nl\n";
        let lines = LineComparison::new(theirs, mine).lines;
        let signs: Vec<String> = lines
            .iter()
            .map(|(whose, line)| match whose {
                LineOrigin::Both => format!("={line}"),
                LineOrigin::Theirs => format!("-{line}"),
                LineOrigin::Mine => format!("+{line}"),
                LineOrigin::Gap => "…".to_owned(),
            })
            .collect();
        assert_eq!(signs, ["=c", "=d", "-near = 1", "+near = 2", "=e", "=f", "…", "=j", "=k", "+l"]);
        assert!(LineComparison::new(mine, mine).lines.is_empty());
    }

    #[test]
    fn long_and_strange_texts_are_bounded() {
        let many: String = (0..100_000).map(|i| format!("{i}\n")).collect();
        let lines = LineComparison::new(&many, "x\n").lines;
        assert_eq!(lines.len(), MAX_COMPARED_LINES + 1);
        let lines = LineComparison::new("a\u{1b}[31m\tb\r\n", "").lines;
        assert_eq!(lines, [(LineOrigin::Theirs, r"a\u{1b}[31m    b".to_owned())]);
    }
}
