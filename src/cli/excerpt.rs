//! The lines of a text that a diagnostic points at, long ones cut around the places.
//!
//! Lines keep their numbers and places their columns, so that only what is drawn has to be copied.

use std::collections::BTreeMap;
use std::ops::Range;

/// Lines up to this many bytes are shown whole.
const WHOLE: usize = 160;
/// What is shown of a longer line before and behind the begin of a span, and its end.
const AROUND_START: (usize, usize) = (60, 80);
const AROUND_END: (usize, usize) = (20, 20);
/// Stands for what is cut. In ASCII, so that carets stand right also where nothing else is drawn.
const CUT: &str = "...";
/// Of a span over many lines, so many are kept from its first one on; at its end two.
const FIRST_LINES: usize = 5;

pub struct Excerpt {
    pub text: String,
    /// In order.
    pieces: Vec<Piece>,
    lines: Vec<Line>,
}

/// Bytes that stand in the original as they are shown.
struct Piece {
    shown: usize,
    original: usize,
    length: usize,
}

struct Line {
    /// Counted from 0.
    index: usize,
    shown: Range<usize>,
    original: usize,
}

impl Excerpt {
    /// What is needed to show spans of a text.
    pub fn of(text: &[u8], spans: &[Range<usize>]) -> Excerpt {
        let mut lines = BTreeMap::new();
        for span in spans {
            let [start, end] = [span.start, span.end].map(|p| p.min(text.len()));
            let first = line_start(text, start);
            let last = line_start(text, end);
            let mut begins = vec![last, line_start(text, last.saturating_sub(1)).max(first)];
            let following = std::iter::successors(Some(first), |&at| Some(line_end(text, at)));
            begins.extend(following.take(FIRST_LINES).take_while(|&at| at <= last));
            for begin in begins {
                lines.entry(begin).or_insert_with(Vec::new);
            }
            lines.entry(first).or_default().push(around(start, AROUND_START));
            lines.entry(last).or_default().push(around(end, AROUND_END));
        }
        let mut excerpt = Excerpt { text: String::new(), pieces: Vec::new(), lines: Vec::new() };
        let (mut index, mut counted) = (0, 0);
        for (begin, windows) in lines {
            index += text[counted..begin].iter().filter(|&&b| b == b'\n').count();
            counted = begin;
            excerpt.line(text, index, begin..line_end(text, begin), windows);
        }
        excerpt
    }

    fn line(&mut self, text: &[u8], index: usize, line: Range<usize>, mut windows: Vec<Range<usize>>) {
        let shown = self.text.len();
        if line.len() <= WHOLE {
            windows.clear();
            windows.push(line.clone());
        } else if windows.is_empty() {
            windows.push(line.start..line.start + WHOLE);
        }
        windows.sort_by_key(|w| w.start);
        let mut done = line.start;
        for window in windows {
            let start = boundary(text, window.start.clamp(done, line.end), done);
            let end = boundary(text, window.end.clamp(start, line.end), start);
            if start > done {
                self.text.push_str(CUT);
            }
            self.pieces.push(Piece { shown: self.text.len(), original: start, length: end - start });
            self.text.push_str(&readable(&text[start..end]));
            done = end;
        }
        if done < line.end {
            self.text.push_str(CUT);
        }
        self.lines.push(Line { index, shown: shown..self.text.len(), original: line.start });
    }

    /// Where a place of the original is shown.
    pub fn shown(&self, original: usize) -> usize {
        let behind = self.pieces.partition_point(|p| p.original <= original);
        let piece = behind.checked_sub(1).map(|i| &self.pieces[i]);
        piece.map_or(0, |p| p.shown + (original - p.original).min(p.length))
    }

    fn original(&self, shown: usize) -> usize {
        let behind = self.pieces.partition_point(|p| p.shown <= shown);
        let piece = behind.checked_sub(1).map(|i| &self.pieces[i]);
        piece.map_or(0, |p| p.original + (shown - p.shown).min(p.length))
    }

    /// The index of the line that a shown byte belongs to.
    pub fn line_index(&self, shown: usize) -> usize {
        let behind = self.lines.partition_point(|l| l.shown.start <= shown);
        behind.checked_sub(1).map_or(0, |i| self.lines[i].index)
    }

    /// The line's bytes; nothing for lines that are not shown.
    pub fn line_range(&self, index: usize) -> Range<usize> {
        self.find(index).map_or(0..0, |l| l.shown.clone())
    }

    /// In characters, counted from 1.
    pub fn column(&self, text: &[u8], index: usize, shown: usize) -> usize {
        let Some(line) = self.find(index) else { return 1 };
        let place = self.original(shown).clamp(line.original, text.len());
        let chunks = text[line.original..place].utf8_chunks();
        chunks.map(|c| c.valid().chars().count() + c.invalid().len()).sum::<usize>() + 1
    }

    fn find(&self, index: usize) -> Option<&Line> {
        self.lines.binary_search_by_key(&index, |l| l.index).ok().map(|i| &self.lines[i])
    }
}

fn around(at: usize, (before, behind): (usize, usize)) -> Range<usize> {
    at.saturating_sub(before)..at + behind
}

fn line_start(text: &[u8], at: usize) -> usize {
    text[..at].iter().rposition(|&b| b == b'\n').map_or(0, |i| i + 1)
}

/// Behind the line's end.
fn line_end(text: &[u8], at: usize) -> usize {
    text[at..].iter().position(|&b| b == b'\n').map_or(text.len(), |i| at + i + 1)
}

/// The place, or the beginning of the character that it would cut.
fn boundary(text: &[u8], at: usize, least: usize) -> usize {
    let inside = |i: usize| text.get(i).is_some_and(|b| b & 0xC0 == 0x80);
    (at.saturating_sub(3).max(least)..=at).rev().find(|&i| !inside(i)).unwrap_or(at)
}

/// The text with `?` for every byte that is not UTF-8.
fn readable(bytes: &[u8]) -> String {
    let mut out = String::with_capacity(bytes.len());
    for chunk in bytes.utf8_chunks() {
        out.push_str(chunk.valid());
        out.extend(chunk.invalid().iter().map(|_| '?'));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_lines_are_kept_whole_with_their_numbers() {
        let text = b"a\nsphere { x }\nb\n";
        let e = Excerpt::of(text, std::slice::from_ref(&(11..12)));
        assert_eq!((e.text.as_str(), e.line_index(e.shown(11))), ("sphere { x }\n", 1));
        assert_eq!((&e.text[e.line_range(1)], e.column(text, 1, e.shown(11))), ("sphere { x }\n", 10));
    }

    #[test]
    fn long_lines_are_cut_around_their_places() {
        let mut text = "x\n".to_owned() + &"é".repeat(5000) + "WRONG" + &"é".repeat(5000) + "THERE\nlast";
        let [at, there] = ["WRONG", "THERE"].map(|word| text.find(word).unwrap());
        let e = Excerpt::of(text.as_bytes(), &[at..at + 5, there..there + 5]);
        assert!(e.text.len() < 500, "{}", e.text.len());
        assert!(e.text.starts_with("...é") && e.text.ends_with("éTHERE\n"), "{}", e.text);
        assert_eq!(e.text.matches(CUT).count(), 2);
        for (place, word) in [(at, "WRONG"), (there, "THERE")] {
            let shown = e.shown(place);
            assert_eq!(&e.text[shown..e.shown(place + 5)], word);
            let column = text[2..place].chars().count() + 1;
            assert_eq!((e.line_index(shown), e.column(text.as_bytes(), 1, shown)), (1, column));
        }
        text.push_str(&"\nmore".repeat(1000));
        let e = Excerpt::of(text.as_bytes(), std::slice::from_ref(&(at..text.len())));
        assert!(e.text.len() < 800 && e.text.ends_with("more\nmore"), "{}", e.text);
    }

    /// Every place of a text with all kinds of lines, also those inside characters.
    #[test]
    fn any_span_can_be_shown() {
        let text = ["é\n\n", &"ab é".repeat(90), "\n", &"\u{1F600}".repeat(60), "\r\n\nend\n"].concat();
        for start in 0..=text.len() {
            for end in [start, start + 1, start + 7, start + 400, text.len() + 5] {
                let e = Excerpt::of(text.as_bytes(), std::slice::from_ref(&(start..end)));
                let shown = e.shown(start)..e.shown(end.min(text.len()));
                assert!(shown.start <= shown.end && shown.end <= e.text.len(), "{start}..{end}");
                let line = text.as_bytes()[..start].iter().filter(|&&b| b == b'\n').count();
                assert_eq!(e.line_index(shown.start), line, "{start}..{end}");
            }
        }
    }
}
