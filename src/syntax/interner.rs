use super::{SPELLINGS, StringId, Symbol};

/// Every identifier and string literal once, numbered. Reserved words come first, in the order of
/// [`SPELLINGS`], so that one look-up tells words from identifiers.
#[derive(Debug)]
pub struct Interner {
    names: Table,
    strings: Table,
}

impl Default for Interner {
    fn default() -> Self {
        let mut names = Table::default();
        for (text, _) in SPELLINGS {
            names.intern(text.as_bytes());
        }
        names.intern(b"");
        Self { names, strings: Table::default() }
    }
}

impl Interner {
    /// The empty name, which no text can spell.
    pub const NAMELESS: Symbol = Symbol(SPELLINGS.len() as u32);

    pub fn name(&mut self, bytes: &[u8]) -> Symbol {
        Symbol(self.names.intern(bytes))
    }

    /// The spelling of an identifier (ASCII by the lexer's rule).
    pub fn spelling(&self, symbol: Symbol) -> &str {
        std::str::from_utf8(self.names.bytes(symbol.0)).unwrap_or("?")
    }

    pub fn string(&mut self, bytes: &[u8]) -> StringId {
        StringId(self.strings.intern(bytes))
    }

    /// A string literal as written between its quotes.
    pub fn literal(&self, id: StringId) -> &[u8] {
        self.strings.bytes(id.0)
    }

    /// How many names there are, reserved words included.
    pub fn names(&self) -> usize {
        self.names.ends.len()
    }
}

/// Byte strings in one arena, found through open addressing.
#[derive(Debug, Default)]
struct Table {
    bytes: Vec<u8>,
    /// Where each entry ends in `bytes`.
    ends: Vec<u32>,
    /// Entry number plus 1, 0 for free; the length is a power of two.
    slots: Vec<u32>,
}

impl Table {
    fn bytes(&self, index: u32) -> &[u8] {
        let index = index as usize;
        let start = if index == 0 { 0 } else { self.ends[index - 1] as usize };
        &self.bytes[start..self.ends[index] as usize]
    }

    fn intern(&mut self, key: &[u8]) -> u32 {
        if self.ends.len() * 2 >= self.slots.len() {
            self.grow();
        }
        let mask = self.slots.len() - 1;
        let mut at = hash(key) as usize & mask;
        loop {
            match self.slots[at] {
                0 => break,
                entry if self.bytes(entry - 1) == key => return entry - 1,
                _ => at = (at + 1) & mask,
            }
        }
        self.bytes.extend_from_slice(key);
        self.ends.push(self.bytes.len() as u32);
        self.slots[at] = self.ends.len() as u32;
        self.ends.len() as u32 - 1
    }

    fn grow(&mut self) {
        let size = (self.slots.len() * 2).max(2048);
        self.slots = vec![0; size];
        for index in 0..self.ends.len() as u32 {
            let mut at = hash(self.bytes(index)) as usize & (size - 1);
            while self.slots[at] != 0 {
                at = (at + 1) & (size - 1);
            }
            self.slots[at] = index + 1;
        }
    }
}

/// Eight bytes at a time, multiplied and folded.
fn hash(key: &[u8]) -> u64 {
    const FACTOR: u64 = 0x9E37_79B9_7F4A_7C15;
    let mut state = key.len() as u64;
    let mut chunks = key.chunks_exact(8);
    for chunk in &mut chunks {
        let word = chunk.iter().rev().fold(0u64, |w, &b| w << 8 | u64::from(b));
        state = (state ^ word).wrapping_mul(FACTOR);
        state ^= state >> 32;
    }
    let rest = chunks.remainder().iter().rev().fold(0u64, |w, &b| w << 8 | u64::from(b));
    state = (state ^ rest).wrapping_mul(FACTOR);
    state ^ state >> 32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reserved_words_come_first_and_names_are_kept_apart() {
        let mut interner = Interner::default();
        assert_eq!(
            interner.name(b"sphere").0 as usize,
            SPELLINGS.iter().position(|s| s.0 == "sphere").unwrap()
        );
        let a = interner.name(b"Leaf");
        assert_eq!(interner.name(b"Leaf"), a);
        assert_ne!(interner.name(b"leaf"), a);
        assert_eq!(interner.spelling(a), "Leaf");
        assert_eq!(interner.name(b""), Interner::NAMELESS);
    }

    #[test]
    fn many_names_survive_growth() {
        let mut interner = Interner::default();
        let all: Vec<_> = (0..20_000).map(|i| interner.name(format!("N{i}").as_bytes())).collect();
        for (i, s) in all.iter().enumerate() {
            assert_eq!(interner.spelling(*s), format!("N{i}"));
            assert_eq!(interner.name(format!("N{i}").as_bytes()), *s);
        }
    }
}
