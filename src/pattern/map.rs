//! Maps from values to things.

use crate::color::Color;

/// Entries by key, in the order written.
///
/// Keys need not be sorted: the rules of [`BlendMap::at`] hold all the same. In an average they are weights.
#[derive(Clone, Debug, PartialEq)]
pub struct BlendMap<T> {
    entries: Vec<(f64, T)>,
    sorted: bool,
}

pub type ColorMap = BlendMap<Color>;

/// What a map has at a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blended<'a, T> {
    One(&'a T),
    /// The share of the second, and both.
    Two(f64, &'a T, &'a T),
}

impl<T> BlendMap<T> {
    /// Keys in single precision; there must be an entry.
    pub fn new(entries: Vec<(f32, T)>) -> Self {
        assert!(!entries.is_empty(), "a map has an entry");
        let sorted = entries.windows(2).all(|w| w[0].0 <= w[1].0);
        Self { entries: entries.into_iter().map(|(k, item)| (f64::from(k), item)).collect(), sorted }
    }

    pub fn len(&self) -> usize {
        self.entries.len()
    }

    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    pub fn items(&self) -> impl Iterator<Item = &T> {
        self.entries.iter().map(|(_, item)| item)
    }

    pub fn items_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.entries.iter_mut().map(|(_, item)| item)
    }

    /// Key and item, in the order written.
    pub fn iter(&self) -> impl Iterator<Item = (f64, &T)> {
        self.entries.iter().map(|(key, item)| (*key, item))
    }

    pub fn item(&self, index: usize) -> &T {
        &self.entries[index.min(self.entries.len() - 1)].1
    }

    /// The work at one value if every item takes as much as `cost` says: two neighbours are blended.
    pub fn cost(&self, cost: impl Fn(&T) -> f64) -> f64 {
        let costs: Vec<f64> = self.items().map(cost).collect();
        costs.windows(2).map(|two| two[0] + two[1]).fold(costs[0], f64::max)
    }

    pub fn total_weight(&self) -> f64 {
        self.entries.iter().map(|(weight, _)| weight).sum()
    }

    /// The last entry from its key on; else the first entry whose key is at least `v`, alone if the key is
    /// `v` or nothing stands before it, otherwise blended with the entry before it.
    #[inline]
    pub fn at(&self, v: f64) -> Blended<'_, T> {
        let last = self.entries.len() - 1;
        if v >= self.entries[last].0 {
            return Blended::One(&self.entries[last].1);
        }
        let upper = if self.sorted && last > 8 {
            self.entries.partition_point(|&(key, _)| key < v)
        } else {
            self.entries.iter().position(|&(key, _)| key >= v).unwrap_or(last)
        };
        let (high, ref item) = self.entries[upper.min(last)];
        if upper == 0 || high == v {
            return Blended::One(item);
        }
        let (low, ref before) = self.entries[upper - 1];
        // As the reference has it: the distance between keys in single precision.
        Blended::Two((v - low) / f64::from((high - low) as f32), before, item)
    }
}

impl BlendMap<Color> {
    #[inline]
    pub fn color(&self, v: f64) -> Color {
        match self.at(v) {
            Blended::One(&color) => color,
            Blended::Two(t, &low, &high) => low.toward(high, t),
        }
    }

    /// By how much red, green or blue differ at most between two values, or more: ups and downs add up.
    pub fn spread(&self, low: f64, high: f64) -> f32 {
        if !self.sorted {
            return f32::INFINITY;
        }
        let mut sum = 0.0;
        for pair in self.entries.windows(2) {
            let ((from, a), (to, b)) = (&pair[0], &pair[1]);
            if *to < low || *from > high {
                continue;
            }
            let share = if to > from { (to.min(high) - from.max(low)) / (to - from) } else { 1.0 };
            sum += (b.rgb - a.rgb).abs().max_element() * share as f32;
        }
        sum
    }
}

/// By how much the colours of a map differ between two values, looked up: as [`ColorMap::spread`] says it of
/// values a little farther apart.
#[derive(Clone, Debug)]
pub struct Changes {
    /// From below 0 to each of so many values, the first of them below 0 too.
    sums: Vec<f32>,
}

impl Changes {
    const STEPS: i32 = 256;

    /// `None` for maps that are not sorted.
    pub fn new(map: &ColorMap) -> Option<Self> {
        let at = |k: i32| f64::from(k - 1) / f64::from(Self::STEPS);
        let sums = || (0..=Self::STEPS + 1).map(|k| if k == 0 { 0.0 } else { map.spread(at(0), at(k)) });
        map.sorted.then(|| Self { sums: sums().collect() })
    }

    /// Between two values; those outside 0 to 1 count as 0 and 1.
    #[inline]
    pub fn between(&self, low: f64, high: f64) -> f32 {
        let steps = f64::from(Self::STEPS);
        let first = (low * steps) as i32;
        let last = (high * steps) as i32 + 2;
        let clamped = |k: i32| k.clamp(0, Self::STEPS + 1) as usize;
        self.sums[clamped(last)] - self.sums[clamped(first)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_are_looked_up_a_little_larger() {
        let grey = |v: f32| Color { rgb: crate::color::Rgb::splat(v), ..Color::BLACK };
        let steps = [(0.0, 0.2), (0.0, 1.0), (0.3, 0.5), (0.5, 0.5), (0.5, 0.0), (0.8, 0.25), (1.0, 0.3)];
        let map = BlendMap::new(steps.map(|(k, v)| (k, grey(v))).to_vec());
        let changes = Changes::new(&map).unwrap();
        let margin = 2.0 / 256.0;
        for i in 0..=500 {
            for j in i..=500 {
                let (low, high) = (f64::from(i) / 500.0, f64::from(j) / 500.0);
                let found = changes.between(low, high);
                assert!(found >= map.spread(low, high) - 1e-5, "{low} {high}");
                assert!(found <= map.spread(low - margin, high + margin) + 1e-5, "{low} {high}");
            }
        }
        assert_eq!(changes.between(-3.0, 7.0), changes.between(0.0, 1.0));
        assert!(Changes::new(&BlendMap::new(vec![(0.5, grey(0.0)), (0.2, grey(1.0))])).is_none());
    }

    #[test]
    fn lookup_follows_the_written_order() {
        let map = BlendMap::new(vec![(0.5, 'a'), (0.25, 'b'), (0.75, 'c')]);
        assert_eq!(map.at(0.1), Blended::One(&'a'));
        assert_eq!(map.at(0.6), Blended::Two((0.6 - 0.25) / 0.5, &'b', &'c'));
        assert_eq!(map.at(0.75), Blended::One(&'c'));
    }

    #[test]
    fn a_double_key_is_a_step_with_the_earlier_entry_at_the_key() {
        let map = BlendMap::new(vec![(0.0, 'a'), (0.5, 'b'), (0.5, 'c'), (1.0, 'd')]);
        assert_eq!(map.at(0.5), Blended::One(&'b'));
        assert!(matches!(map.at(0.50001), Blended::Two(_, 'c', 'd')));
    }

    #[test]
    fn long_maps_are_searched_alike() {
        let long = BlendMap::new((0..40).map(|i| (i as f32 * 0.025, i)).collect());
        for step in 0..500 {
            let v = f64::from(step) * 0.0021 - 0.01;
            let by_hand = long.iter().position(|(key, _)| key >= v);
            match (by_hand, long.at(v)) {
                (None, Blended::One(&i)) => assert_eq!(i, 39),
                (Some(i), Blended::One(&j)) => assert_eq!(i, j),
                (Some(i), Blended::Two(_, _, &j)) => assert_eq!(i, j),
                other => panic!("{v}: {other:?}"),
            }
        }
    }

    #[test]
    fn spread_sees_entries_between() {
        let grey = |v: f32| Color { rgb: crate::color::Rgb::splat(v), ..Color::BLACK };
        let map = BlendMap::new(vec![(0.0, grey(1.0)), (0.5, grey(0.5)), (0.5, grey(0.0)), (1.0, grey(0.0))]);
        assert_eq!(map.spread(0.6, 0.9), 0.0);
        assert_eq!(map.spread(0.25, 0.75), 0.75);
        assert_eq!(map.spread(0.0, 0.25), 0.25);
    }

    #[test]
    fn undefined_values_choose_something() {
        let map = BlendMap::new(vec![(0.0, 'a'), (1.0, 'b')]);
        map.at(f64::NAN);
    }
}
