//! The fixed random numbers that patterns are built on.
//!
//! Reference: M. Matsumoto, T. Nishimura, "Mersenne Twister", ACM TOMACS 8 (1998).

use std::sync::LazyLock;

/// A linear congruential generator of 15-bit numbers.
#[derive(Clone, Copy, Debug)]
pub struct Lcg {
    state: u32,
}

impl Lcg {
    pub const fn new(seed: u32) -> Self {
        Self { state: seed }
    }

    /// The next number, 0 ..= 32767.
    pub const fn draw(&mut self) -> u32 {
        self.state = self.state.wrapping_mul(1_812_433_253).wrapping_add(12345);
        (self.state >> 16) & 0x7FFF
    }
}

/// Number of entries in [`uniform_table`]; a power of two.
pub const UNIFORM_ENTRIES: usize = 32768;

/// Uniform numbers in 0..1 that cells, crackle, facets and black holes look up by a hash of their lattice
/// cell: the first outputs of MT19937 with its standard seed.
pub fn uniform_table() -> &'static [f64; UNIFORM_ENTRIES] {
    static TABLE: LazyLock<Box<[f64; UNIFORM_ENTRIES]>> = LazyLock::new(|| {
        let mut twister = MersenneTwister::new(5489);
        let table: Vec<f64> =
            (0..UNIFORM_ENTRIES).map(|_| f64::from(twister.draw()) / 4_294_967_296.0).collect();
        table.try_into().expect("as many numbers as entries")
    });
    &TABLE
}

/// The entry at any index, counted around.
pub fn uniform(table: &[f64; UNIFORM_ENTRIES], index: usize) -> f64 {
    table[index & (UNIFORM_ENTRIES - 1)]
}

/// MT19937.
struct MersenneTwister {
    state: [u32; 624],
    next: usize,
}

impl MersenneTwister {
    fn new(seed: u32) -> Self {
        let mut state = [seed; 624];
        for i in 1..624 {
            let last: u32 = state[i - 1];
            state[i] = 1_812_433_253_u32.wrapping_mul(last ^ (last >> 30)).wrapping_add(i as u32);
        }
        Self { state, next: 624 }
    }

    fn twist(&mut self) {
        for i in 0..624 {
            let joined = (self.state[i] & 0x8000_0000) | (self.state[(i + 1) % 624] & 0x7FFF_FFFF);
            let odd = if joined & 1 == 1 { 0x9908_B0DF } else { 0 };
            self.state[i] = self.state[(i + 397) % 624] ^ (joined >> 1) ^ odd;
        }
        self.next = 0;
    }

    fn draw(&mut self) -> u32 {
        if self.next == 624 {
            self.twist();
        }
        let mut y = self.state[self.next];
        self.next += 1;
        y ^= y >> 11;
        y ^= (y << 7) & 0x9D2C_5680;
        y ^= (y << 15) & 0xEFC6_0000;
        y ^ (y >> 18)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uniform_table_starts_as_measured() {
        let text = include_str!("../../tests/data/2-rand32768.csv");
        let mut rows = 0;
        for line in text.lines().filter(|l| !l.starts_with('#')) {
            let (i, value) = line.split_once(',').unwrap();
            assert_eq!(uniform_table()[i.parse::<usize>().unwrap()], value.parse::<f64>().unwrap());
            rows += 1;
        }
        assert_eq!(rows, 64);
    }

    #[test]
    fn indices_go_around() {
        let table = uniform_table();
        assert_eq!(uniform(table, UNIFORM_ENTRIES + 5), table[5]);
    }
}
