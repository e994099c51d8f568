//! Errors for tokens that do not fit, and the nearest known name.

use super::vocabulary::{Items, STATEMENTS};
use super::{Parser, Result};
use crate::source::{Diagnostic, Label};
use crate::syntax::{Punct, SPELLINGS, Symbol, Tok, Token};
use std::cmp::Reverse;

/// Nothing is suggested for shorter names: everything is near them.
const SHORTEST_NAME: usize = 3;

impl Parser {
    /// The error for a token that does not fit: "expected {expected}", with a did-you-mean for
    /// undeclared names.
    pub fn unexpected(&mut self, expected: &str) -> Box<Diagnostic> {
        match self.peek_operand() {
            Ok(token) => self.unexpected_token(token, expected),
            Err(diagnostic) => diagnostic,
        }
    }

    /// Takes the brace that closes a block of such items.
    pub(super) fn close_block(&mut self, items: &Items) -> Result<Token> {
        let token = self.peek()?;
        match token.tok == Tok::Punct(Punct::RightBrace) {
            true => self.take(token),
            false => Err(self.unexpected_item(items)),
        }
    }

    /// The error for a token that is no item of its block and does not close it.
    pub(super) fn unexpected_item(&mut self, items: &Items) -> Box<Diagnostic> {
        match self.peek_operand() {
            Ok(token) => self.unexpected_among(token, &format!("{} or `}}`", items.noun), items.words),
            Err(diagnostic) => diagnostic,
        }
    }

    /// The error for a token that begins no statement.
    pub(super) fn unexpected_statement(&mut self) -> Box<Diagnostic> {
        match self.peek_operand() {
            Ok(token) => self.unexpected_among(token, STATEMENTS.noun, STATEMENTS.words),
            Err(diagnostic) => diagnostic,
        }
    }

    /// As [`Parser::unexpected`], for a token already taken.
    pub(crate) fn unexpected_token(&mut self, token: Token, expected: &str) -> Box<Diagnostic> {
        self.unexpected_among(token, expected, "")
    }

    /// As [`Parser::unexpected_token`], where these words would fit.
    pub(super) fn unexpected_among(&mut self, token: Token, expected: &str, words: &str) -> Box<Diagnostic> {
        let found = self.describe(token);
        let mut diagnostic = Diagnostic::error(token.span, format!("expected {expected}, found {found}"))
            .with_label(format!("expected {expected}"));
        if let Tok::Identifier(symbol) = token.tok
            && self.symbols.binding(symbol).is_none()
            && let Some(near) = self.nearest_name(symbol, words)
        {
            diagnostic.hint = Some(format!("did you mean `{near}`?"));
        }
        if token.tok == Tok::End
            && let Some(span) = self.open_brace()
        {
            diagnostic.labels.push(Label { span, message: "this `{` is still open".to_owned() });
        }
        Box::new(diagnostic)
    }

    /// A token in the words of a message.
    fn describe(&self, token: Token) -> String {
        match token.tok {
            Tok::Number(v) => format!("the number {v}"),
            Tok::String(_) => "a string".to_owned(),
            Tok::Word(word) => format!("`{}`", word.text()),
            Tok::Punct(punct) => format!("`{}`", punct.text()),
            Tok::Directive(d) => format!("`#{}`", d.word.text()),
            Tok::End => "the end of the text".to_owned(),
            Tok::Identifier(symbol) => match self.symbols.value(symbol) {
                Some(value) => format!("the {} `{}`", value.kind(), self.name(symbol)),
                None if self.symbols.binding(symbol).is_some() => format!("`{}`", self.name(symbol)),
                None => format!("the undeclared identifier `{}`", self.name(symbol)),
            },
        }
    }

    /// The name most like this one: a declared name, a word that fits, or any other word of the language. The earlier
    /// kind wins among equals, and a word that does not fit must be nearer by a letter.
    fn nearest_name(&self, symbol: Symbol, fitting: &str) -> Option<String> {
        let name = self.name(symbol);
        let declared = self.symbols.names().map(|s| (self.name(s), 0, 0));
        let fitting = fitting.split_whitespace().map(|text| (text, 1, 0));
        let words = SPELLINGS.iter().map(|(text, _)| (*text, 2, LETTER));
        declared
            .chain(fitting)
            .chain(words)
            .filter_map(|(known, class, penalty)| {
                let far = distance(name, known, class == 1)? + penalty;
                let first = known.chars().next() == name.chars().next();
                Some(((far, class, Reverse(first), known.len()), known))
            })
            .min()
            .map(|(_, known)| known.to_owned())
    }
}

/// The one of these file names most like `name`, if it has the same extension and another spelling.
pub(super) fn nearest_file(name: &str, known: impl Iterator<Item = String>) -> Option<String> {
    let (stem, extension) = name.rsplit_once('.')?;
    known
        .filter_map(|known| {
            let (other, end) = known.rsplit_once('.')?;
            let far = distance(stem, other, false).filter(|_| end.eq_ignore_ascii_case(extension))?;
            Some((far, known))
        })
        .min()
        .map(|(_, known)| known)
}

/// The one of these words most like `name`, if one is near.
pub fn nearest_word<'a>(name: &str, words: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    words.filter_map(|word| Some((distance(name, word, true)?, word))).min().map(|(_, word)| word)
}

/// What a letter changed, added or left out counts.
const LETTER: usize = 2;
/// What two neighbours that changed places count: no other slip is as common.
const SWAP: usize = 1;

/// How far two names are apart, if they are near. Letters that differ in case only count nothing; the name of something
/// that fits may be a little further away.
fn distance(a: &str, b: &str, fits: bool) -> Option<usize> {
    let length = a.len().max(if fits { b.len() } else { 0 });
    let most = LETTER * (length / 3).max(1);
    if a.len() < SHORTEST_NAME || LETTER * a.len().abs_diff(b.len()) > most {
        return None;
    }
    let (a, b) = (a.to_ascii_lowercase().into_bytes(), b.to_ascii_lowercase().into_bytes());
    let mut before = vec![0; b.len() + 1];
    let mut row: Vec<usize> = (0..=b.len()).map(|j| LETTER * j).collect();
    for i in 1..=a.len() {
        let mut next = vec![LETTER * i; b.len() + 1];
        for j in 1..=b.len() {
            let changed = if a[i - 1] == b[j - 1] { 0 } else { LETTER };
            next[j] = (row[j - 1] + changed).min(row[j] + LETTER).min(next[j - 1] + LETTER);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                next[j] = next[j].min(before[j - 2] + SWAP);
            }
        }
        before = std::mem::replace(&mut row, next);
    }
    (row[b.len()] <= most).then_some(row[b.len()])
}

#[cfg(test)]
mod tests {
    use super::{distance, nearest_file};

    #[test]
    fn near_names_have_small_distances() {
        assert_eq!(distance("shpere", "sphere", false), Some(1));
        assert_eq!(distance("pgn", "png", false), Some(1));
        assert_eq!(distance("pgn", "pgm", false), Some(2));
        assert_eq!(distance("Red", "red", false), Some(0));
        assert_eq!(distance("Leaf", "Leave", false), None);
        assert_eq!(distance("spotlite", "spotlight", false), None);
        assert_eq!(distance("spotlite", "spotlight", true), Some(6));
        assert_eq!(distance("ab", "ab", false), None);
    }

    #[test]
    fn near_files_have_the_same_extension() {
        let known = || ["colors.inc", "colrs.txt", "consts.inc"].map(str::to_owned).into_iter();
        assert_eq!(nearest_file("colrs.inc", known()).as_deref(), Some("colors.inc"));
        assert_eq!(nearest_file("colrs", known()), None);
        assert_eq!(nearest_file("nothing.inc", known()), None);
    }
}
