//! Errors for tokens that do not fit, and the nearest known name.

use super::Parser;
use crate::source::{Diagnostic, Label};
use crate::syntax::{SPELLINGS, Symbol, Tok, Token};

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

    /// As [`Parser::unexpected`], for a token already taken.
    pub(crate) fn unexpected_token(&mut self, token: Token, expected: &str) -> Box<Diagnostic> {
        let found = self.describe(token);
        let mut diagnostic = Diagnostic::error(token.span, format!("expected {expected}, found {found}"))
            .with_label(format!("expected {expected}"));
        if let Tok::Identifier(symbol) = token.tok
            && self.symbols.binding(symbol).is_none()
            && let Some(near) = self.nearest_name(symbol)
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

    /// The declared name or word of the language most like this one.
    fn nearest_name(&self, symbol: Symbol) -> Option<String> {
        let name = self.name(symbol);
        if name.len() < SHORTEST_NAME {
            return None;
        }
        let most = (name.len() / 3).max(1);
        let declared = self.symbols.names().map(|s| self.name(s));
        let words = SPELLINGS.iter().map(|(text, _)| *text);
        declared
            .chain(words)
            .filter_map(|known| Some((distance(name, known, most)?, known)))
            .min_by_key(|&(d, known)| (d, known.len()))
            .map(|(_, known)| known.to_owned())
    }
}

/// How many letters must be changed, added, left out or swapped, if no more than `most`. Letters that
/// differ in case only count nothing.
fn distance(a: &str, b: &str, most: usize) -> Option<usize> {
    if a.len().abs_diff(b.len()) > most {
        return None;
    }
    let (a, b) = (a.to_ascii_lowercase().into_bytes(), b.to_ascii_lowercase().into_bytes());
    let mut before = vec![0; b.len() + 1];
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut next = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let same = usize::from(a[i - 1] != b[j - 1]);
            next[j] = (row[j - 1] + same).min(row[j] + 1).min(next[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                next[j] = next[j].min(before[j - 2] + 1);
            }
        }
        before = std::mem::replace(&mut row, next);
    }
    (row[b.len()] <= most).then_some(row[b.len()])
}

#[cfg(test)]
mod tests {
    use super::distance;

    #[test]
    fn near_names_have_small_distances() {
        assert_eq!(distance("shpere", "sphere", 2), Some(1));
        assert_eq!(distance("Red", "red", 1), Some(0));
        assert_eq!(distance("Leaf", "Leave", 1), None);
        assert_eq!(distance("Leaf", "Leaves", 3), Some(3));
    }
}
