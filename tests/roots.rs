//! Roots of polynomials against arithmetic of a thousand bits: none lost, none invented, and every one as good as
//! double precision can tell it.

mod exact;

use exact::Exact;
use glint::math::polynomial::{MAX_COEFFICIENTS, Touching, first_root, magnitude, roots};
use glint::math::{EPSILON, Range};

/// A value below this many roundings of the sum of the terms' sizes cannot be told from 0.
const NOISE: f64 = 64.0 * EPSILON;

/// Numbers from 0 to 1 in an order without pattern.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

fn value(c: &[Exact], t: &Exact) -> Exact {
    c.iter().rev().fold(Exact::from(0.0), |sum, k| &(&sum * t) + k)
}

fn derivative(c: &[Exact]) -> Vec<Exact> {
    c.iter().enumerate().skip(1).map(|(i, k)| &Exact::from(i as f64) * k).collect()
}

/// The polynomial, its derivative, and the negative remainder of each two before.
fn sturm_chain(c: &[Exact]) -> Vec<Vec<Exact>> {
    let size = |p: &[Exact]| p.iter().fold(Exact::from(0.0), |s, k| if k.abs() > s { k.abs() } else { s });
    let zero = Exact::from(2f64.powi(-700));
    let mut chain = vec![c.to_vec(), derivative(c)];
    loop {
        let [.., a, b] = &chain[..] else { unreachable!("two at least") };
        let mut rest = a.clone();
        while rest.len() >= b.len() {
            let factor = &rest[rest.len() - 1] / &b[b.len() - 1];
            let shift = rest.len() - b.len();
            for (i, k) in b.iter().enumerate() {
                rest[shift + i] = &rest[shift + i] - &(&factor * k);
            }
            rest.pop();
        }
        let threshold = &size(a) * &zero;
        while rest.last().is_some_and(|k| k.abs() <= threshold) {
            rest.pop();
        }
        if rest.is_empty() {
            return chain;
        }
        // Only signs count: of size 1 the numbers stay handy.
        let largest = size(&rest);
        chain.push(rest.iter().map(|k| -&(k / &largest)).collect());
    }
}

/// How many distinct roots lie above `t`, but for a constant.
fn changes(chain: &[Vec<Exact>], t: &Exact) -> usize {
    let signs = chain.iter().map(|p| value(p, t)).filter(|v| *v != Exact::from(0.0));
    let negative: Vec<bool> = signs.map(|v| v.is_negative()).collect();
    negative.windows(2).filter(|w| w[0] != w[1]).count()
}

/// All distinct roots in a range, to thirty digits.
fn exact_roots(c: &[f64], low: f64, high: f64) -> Vec<Exact> {
    let c: Vec<Exact> = c.iter().map(|&k| Exact::from(k)).collect();
    let chain = sturm_chain(&c);
    let mut found = Vec::new();
    let (low, high) = (Exact::from(low), Exact::from(high));
    let mut todo = vec![(low.clone(), changes(&chain, &low), high.clone(), changes(&chain, &high), 0)];
    while let Some((a, at_a, b, at_b, depth)) = todo.pop() {
        if at_a == at_b {
            continue;
        }
        let middle = &(&a + &b) * &Exact::from(0.5);
        if depth == 110 {
            found.push(middle);
            continue;
        }
        let here = changes(&chain, &middle);
        todo.push((middle.clone(), here, b, at_b, depth + 1));
        todo.push((a, at_a, middle, here, depth + 1));
    }
    found
}

/// The double just above an exact number in a range.
fn approximate(x: &Exact, low: f64, high: f64) -> f64 {
    let (mut a, mut b) = (low, high);
    loop {
        let m = 0.5 * (a + b);
        if m <= a || m >= b {
            return b;
        }
        if Exact::from(m) < *x { a = m } else { b = m }
    }
}

fn near(x: &Exact, t: f64) -> f64 {
    // The difference is small: a few bits of it suffice.
    let d = (x - &Exact::from(t)).abs();
    let mut bound = 1e-300;
    while Exact::from(bound) < d {
        bound *= 2.0;
    }
    bound
}

/// Holds the roots that are found against the true ones; how many of these there are.
fn check(c: &[f64], low: f64, high: f64) -> usize {
    let exact: Vec<Exact> = c.iter().map(|&k| Exact::from(k)).collect();
    let slope = derivative(&exact);
    let expected = exact_roots(c, low, high);
    let found = roots(c, Range::new(low, high), Touching::Skip);
    let noise = |t: f64| Exact::from(NOISE * magnitude(c, t));
    for &t in &found {
        // The root of a polynomial whose coefficients are a few roundings away, up to the rounding of t itself.
        let (f, d) = (value(&exact, &Exact::from(t)).abs(), value(&slope, &Exact::from(t)).abs());
        let bound = &noise(t) + &(&d * &Exact::from(8.0 * EPSILON * t.abs()));
        assert!(f <= bound, "{t} is no root of {c:?}");
    }
    // What double precision cannot tell from 0 hangs together: in each such stretch the number of roots is even or
    // odd as it truly is, and where there is one simple root it is found once.
    let in_noise = |a: f64, b: f64| {
        let parts = (1..8).map(|i| a + (b - a) * f64::from(i) / 8.0);
        parts.into_iter().all(|t| value(&exact, &Exact::from(t)).abs() <= &noise(t) + &noise(t))
    };
    let mut all: Vec<(f64, bool)> = found.iter().map(|&t| (t, true)).collect();
    all.extend(expected.iter().map(|x| (approximate(x, low, high), false)));
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut rest = &all[..];
    while let Some(&(first, _)) = rest.first() {
        let together = |pair: &[(f64, bool)]| {
            let ulps = (pair[1].0 - pair[0].0) <= 16.0 * EPSILON * pair[0].0.abs();
            ulps || in_noise(pair[0].0, pair[1].0)
        };
        let count = 1 + rest.windows(2).take_while(|pair| together(pair)).count();
        let here = rest[..count].iter().filter(|r| r.1).count();
        assert_eq!(here % 2, (count - here) % 2, "{c:?} at {first}: {expected:?}, found {found:?}");
        rest = &rest[count..];
    }
    // Where the condition lets it, a root is good to a few units in the last place.
    for x in &expected {
        let t = approximate(x, low, high);
        let steep = value(&slope, &Exact::from(t)).abs();
        if t != 0.0 && noise(t) < &steep * &Exact::from(1e-13 * t.abs()) {
            let best = found.iter().map(|&f| near(x, f)).fold(f64::INFINITY, f64::min);
            let bound = &(&noise(t) / &steep) + &Exact::from(8.0 * EPSILON * t.abs());
            assert!(Exact::from(best) <= &bound + &bound, "{c:?}: {t} is {best} off");
        }
    }
    let first = first_root(c, Range::new(low, high), Touching::Skip);
    assert_eq!(first.is_some(), !found.is_empty(), "{c:?}");
    expected.len()
}

fn product(roots: &[f64]) -> Vec<f64> {
    let mut c = vec![1.0];
    for r in roots {
        let mut next = vec![0.0; c.len() + 1];
        for (i, k) in c.iter().enumerate() {
            next[i + 1] += k;
            next[i] -= r * k;
        }
        c = next;
    }
    c
}

#[test]
fn random_coefficients() {
    let mut random = Random(1);
    let mut count = 0;
    for i in 0..300 {
        let degree = 3 + i % 8;
        let c: Vec<f64> = (0..=degree).map(|_| random.between(-1.0, 1.0)).collect();
        count += check(&c, -1.9, 2.1);
    }
    assert!(count > 300, "{count}");
}

#[test]
fn huge_ratios() {
    let mut random = Random(2);
    let mut count = 0;
    for i in 0..200 {
        let degree = 3 + i % 6;
        let sized = |random: &mut Random| random.between(-1.0, 1.0) * 10f64.powf(random.between(-9.0, 9.0));
        let c: Vec<f64> = (0..=degree).map(|_| sized(&mut random)).collect();
        let reach = 10f64.powf(random.between(-3.0, 3.0));
        count += check(&c, -reach, 1.1 * reach);
    }
    assert!(count > 60, "{count}");
}

#[test]
fn pairs_that_are_almost_double() {
    let mut random = Random(3);
    let mut count = 0;
    for i in 0..240 {
        let gap = 10f64.powi(-1 - i % 15);
        let degree = 3 + (i as usize / 15) % 6;
        let mut r: Vec<f64> = (2..degree).map(|_| random.between(-2.0, 2.0)).collect();
        let a = random.between(-1.5, 1.5);
        r.extend([a, a + gap]);
        let mut c = product(&r);
        if i % 2 == 1 {
            // The pair lifted just off the axis, or pushed just through it.
            c[0] += random.between(-1.0, 1.0) * gap * gap;
        }
        count += check(&c, -2.6, 2.7);
    }
    assert!(count > 400, "{count}");
}

#[test]
fn clusters() {
    let mut random = Random(4);
    let mut count = 0;
    for i in 0..60 {
        let width = 10f64.powi(-(i % 4));
        let n = 3 + i as usize % 6;
        let middle = random.between(-1.0, 1.0);
        let r: Vec<f64> = (0..n).map(|_| middle + width * random.between(-1.0, 1.0)).collect();
        count += check(&product(&r), -2.3, 2.4);
    }
    // Wilkinson's, up to degree 10.
    for n in 4..=10 {
        count += check(&product(&(1..=n).map(f64::from).collect::<Vec<_>>()), 0.4, 11.0);
    }
    assert!(count > 200, "{count}");
}

#[test]
fn tiny_leading_terms() {
    let mut random = Random(5);
    for i in 0..120 {
        let mut c: Vec<f64> = (0..4 + i % 4).map(|_| random.between(-1.0, 1.0)).collect();
        for _ in 0..1 + i % 3 {
            c.push(random.between(-1.0, 1.0) * 10f64.powf(random.between(-30.0, -8.0)));
        }
        check(&c, -3.0, 3.1);
    }
}

#[test]
fn higher_degrees() {
    let mut random = Random(6);
    for degree in [11, 12, 15, 20, 26, 35] {
        assert!(degree < MAX_COEFFICIENTS);
        for _ in 0..6 {
            let c: Vec<f64> = (0..=degree).map(|_| random.between(-1.0, 1.0)).collect();
            check(&c, -1.2, 1.3);
        }
    }
}
