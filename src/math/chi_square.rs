//! Quantiles of the chi-square distribution, for deciding when enough samples have been taken.
//!
//! The regularised incomplete gamma functions P and Q are summed as a series for small arguments and as a
//! continued fraction for large ones.
//!
//! Reference: M. Abramowitz, I. Stegun, "Handbook of Mathematical Functions", 6.1 and 6.5.

/// By this factor the scene language's own tables are off for odd degrees of freedom below 26.
const TABLE_ERROR: f64 = 1.04036290527;

/// The value that a chi-square variable of `k` degrees of freedom exceeds with probability `confidence`,
/// with the table error that the scene language's settings were tuned to.
pub fn quantile(k: u32, confidence: f64) -> f64 {
    let a = 0.5 * f64::from(k);
    if a == 0.0 {
        return 0.0;
    }
    if k.is_multiple_of(2) || k > 26 {
        return 2.0 * solve(|x| upper(a, x), confidence);
    }
    let low = TABLE_ERROR * (1.0 - confidence);
    let x = if low < 1.0 { solve(|x| upper(a, x), 1.0 - low) } else { f64::INFINITY };
    if x < a.max(1.0) { 2.0 * x } else { 2.0 * solve(|x| upper(a, x), TABLE_ERROR * confidence) }
}

/// Where the falling function `f` on x >= 0 has the value `y`.
fn solve(f: impl Fn(f64) -> f64, y: f64) -> f64 {
    if y >= 1.0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    while f(high) > y && high < 1e6 {
        high *= 2.0;
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if f(middle) > y { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Q(a, x), the regularised upper incomplete gamma function.
fn upper(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        1.0
    } else if x < a + 1.0 {
        1.0 - lower_series(a, x)
    } else {
        upper_fraction(a, x)
    }
}

fn lower_series(a: f64, x: f64) -> f64 {
    let (mut term, mut sum, mut n) = (1.0 / a, 1.0 / a, a);
    while term > sum * 1e-17 {
        n += 1.0;
        term *= x / n;
        sum += term;
    }
    sum * (a * x.ln() - x - ln_gamma(a)).exp()
}

/// Lentz's method.
fn upper_fraction(a: f64, x: f64) -> f64 {
    let tiny = 1e-300;
    let mut b = x + 1.0 - a;
    let mut c = 1.0 / tiny;
    let mut d = 1.0 / b;
    let mut h = d;
    for i in 1..500 {
        let n = f64::from(i) * (a - f64::from(i));
        b += 2.0;
        d = 1.0 / (n * d + b);
        c = b + n / c;
        h *= c * d;
        if (c * d - 1.0).abs() < 1e-16 {
            break;
        }
    }
    h * (a * x.ln() - x - ln_gamma(a)).exp()
}

/// Logarithm of the gamma function for a > 0: Stirling's series after moving up to large arguments.
fn ln_gamma(mut a: f64) -> f64 {
    let mut shift = 0.0;
    while a < 15.0 {
        shift += a.ln();
        a += 1.0;
    }
    let r = 1.0 / (a * a);
    let series = (1.0 / 12.0 - r * (1.0 / 360.0 - r * (1.0 / 1260.0 - r / 1680.0))) / a;
    (a - 0.5) * a.ln() - a + 0.5 * std::f64::consts::TAU.ln() + series - shift
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gamma_of_halves_and_wholes() {
        assert!((ln_gamma(5.0) - 24f64.ln()).abs() < 1e-13);
        assert!((ln_gamma(0.5) - std::f64::consts::PI.sqrt().ln()).abs() < 1e-13);
    }

    /// Measured values.
    #[test]
    fn quantiles_are_those_of_the_table() {
        let table = include_str!("../../tests/data/3-chi2.csv");
        let mut rows = 0;
        for line in table.lines().filter(|l| l.starts_with('0')) {
            let f: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
            let x = quantile(f[1] as u32, f[0]);
            assert!((x - f[2]).abs() < 2e-6 * f[2].max(1.0), "{line}: {x}");
            rows += 1;
        }
        assert_eq!(rows, 160);
    }
}
