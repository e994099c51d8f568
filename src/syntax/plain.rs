use super::leading_number;

/// Reads vectors written with plain numbers straight from bytes, for lists of millions. It knows no comments
/// and no names: where those come, it gives up, and the text is read as usual from there.
#[derive(Debug)]
pub struct Plain<'a> {
    text: &'a [u8],
    at: usize,
}

impl<'a> Plain<'a> {
    pub fn new(text: &'a [u8], at: usize) -> Self {
        Self { text, at }
    }

    /// Where the text read so far ends.
    pub fn position(&self) -> usize {
        self.at
    }

    pub fn seek(&mut self, at: usize) {
        self.at = at;
    }

    /// Whether another vector or the list's closing brace comes next.
    pub fn at_list_end(&self) -> bool {
        matches!(self.text.get(self.space(self.at)), Some(b'<' | b'}'))
    }

    /// `<a, b, …>` with exactly `count` (up to 5) plain numbers, and the comma behind it; nothing is taken if
    /// anything else comes.
    #[inline]
    pub fn vector(&mut self, count: usize) -> Option<[f64; 5]> {
        let mut at = self.expect(self.at, b'<')?;
        let mut v = [0.0; 5];
        for (i, slot) in v[..count].iter_mut().enumerate() {
            if i > 0 {
                at = self.expect(at, b',')?;
            }
            (*slot, at) = self.signed(at)?;
        }
        at = self.expect(at, b'>')?;
        self.at = self.end_of_item(at)?;
        Some(v)
    }

    /// A plain number and the comma behind it; nothing is taken if anything else comes.
    #[inline]
    pub fn number(&mut self) -> Option<f64> {
        let (v, at) = self.signed(self.at)?;
        self.at = self.end_of_item(at)?;
        Some(v)
    }

    /// Behind an item's comma, if it has one; `None` if the item goes on with an operator or a member.
    #[inline]
    fn end_of_item(&self, at: usize) -> Option<usize> {
        let next = self.space(at);
        match self.text.get(next) {
            Some(b'+' | b'-' | b'*' | b'/' | b'.' | b'#') => None,
            Some(b',') => Some(next + 1),
            _ => Some(at),
        }
    }

    fn signed(&self, at: usize) -> Option<(f64, usize)> {
        let at = self.space(at);
        let negative = self.text.get(at) == Some(&b'-');
        let at = at + usize::from(negative);
        let (v, length) = leading_number(&self.text[at..])?;
        let at = at + length;
        match self.text.get(at) {
            // `1.5.` or `2x` is an error, told elsewhere.
            Some(b) if b.is_ascii_alphanumeric() || matches!(b, b'.' | b'_') => None,
            _ => Some((if negative { -v } else { v }, at)),
        }
    }

    #[inline]
    fn expect(&self, at: usize, byte: u8) -> Option<usize> {
        let at = self.space(at);
        (self.text.get(at) == Some(&byte)).then_some(at + 1)
    }

    #[inline]
    fn space(&self, mut at: usize) -> usize {
        while matches!(self.text.get(at), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            at += 1;
        }
        at
    }
}

#[cfg(test)]
mod tests {
    use super::Plain;

    #[test]
    fn plain_vectors_are_read_and_others_left() {
        let text = b" <1,-2.5, 3e2>,\n<4,5,6> < 7 ,8,\t9 >x<1,2>";
        let mut plain = Plain::new(text, 0);
        assert_eq!(plain.vector(3), Some([1.0, -2.5, 300.0, 0.0, 0.0]));
        assert_eq!(plain.vector(3), Some([4.0, 5.0, 6.0, 0.0, 0.0]));
        assert_eq!(plain.vector(3), Some([7.0, 8.0, 9.0, 0.0, 0.0]));
        assert_eq!(text[plain.position()], b'x');
        assert_eq!(plain.vector(3), None);
        assert_eq!(text[plain.position()], b'x');
        for other in [
            "<1 2,3>",
            "<1,2>",
            "<1,2,3,4>",
            "<1,2,a>",
            "<1,2+1,3>",
            "<1,2,3.4.5>",
            "<1,2,3ex>",
            "<1,/**/2,3>",
        ] {
            assert_eq!(Plain::new(other.as_bytes(), 0).vector(3), None, "{other}");
        }
    }

    #[test]
    fn plain_numbers_stand_alone() {
        let mut plain = Plain::new(b"1, 2 3<", 0);
        assert_eq!(
            [plain.number(), plain.number(), plain.number(), plain.number()],
            [Some(1.0), Some(2.0), Some(3.0), None]
        );
        assert_eq!(Plain::new(b"1 + 2", 0).number(), None);
    }
}
