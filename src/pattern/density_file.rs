//! Densities sampled on a grid over the unit cube, from a DF3 file; 0 outside.
//!
//! | parameter | default | meaning |
//! |---|---|---|
//! | interpolate | 0 | 0 none, 1 trilinear, 2 tricubic |
//!
//! A file holds three big-endian 16-bit sizes, then samples of 1, 2 or 4 bytes, x fastest. Samples beyond the
//! end wrap around; the one before the first is counted as the language counts it ([`wrapped`]).

use super::{Modifier, Pattern, Setting};
use crate::math::Vec3;
use std::sync::Arc;

#[derive(Clone, Debug)]
pub struct DensityFile {
    grid: Arc<Grid>,
    interpolate: u32,
}

#[derive(Debug)]
struct Grid {
    size: [usize; 3],
    samples: Vec<f32>,
}

impl DensityFile {
    /// From the contents of a DF3 file, or what is wrong with it.
    pub fn new(bytes: &[u8]) -> Result<Self, String> {
        let (header, data) = bytes.split_at_checked(6).ok_or("the file has no header")?;
        let size: [usize; 3] =
            std::array::from_fn(|i| usize::from(u16::from_be_bytes([header[2 * i], header[2 * i + 1]])));
        let count: usize = size.iter().product();
        if count == 0 {
            return Err("the grid is empty".to_owned());
        }
        let width = match data.len() / count {
            0 => return Err("the file is shorter than its header says".to_owned()),
            1 => 1,
            2 | 3 => 2,
            _ => 4,
        };
        let largest = ((1_u64 << (8 * width)) - 1) as f64;
        let sample = |b: &[u8]| {
            let value = b.iter().fold(0_u64, |v, &b| v << 8 | u64::from(b));
            (value as f64 / largest) as f32
        };
        let samples = data.chunks_exact(width).take(count).map(sample).collect();
        Ok(Self { grid: Arc::new(Grid { size, samples }), interpolate: 0 })
    }
}

/// `i` counted around `size`. -1 is 2^64 - 1, which is the last only where the size is a power of two.
fn wrapped(i: i64, size: usize) -> usize {
    // Most are inside, and a division takes long.
    if (i as u64) < size as u64 { i as usize } else { (i as u64 % size as u64) as usize }
}

/// A cubic curve from `b` to `c`, with the slopes that their neighbours give.
fn cubic(t: f32, [a, b, c, d]: [f32; 4]) -> f32 {
    let (slope_b, slope_c) = ((c - a) / 2.0, (d - b) / 2.0);
    let e = 2.0 * (b - c) + slope_b + slope_c;
    let g = -3.0 * (b - c) - 2.0 * slope_b - slope_c;
    ((e * t + g) * t + slope_b) * t + b
}

impl Grid {
    fn sample(&self, x: usize, y: usize, z: usize) -> f32 {
        self.samples[(z * self.size[1] + y) * self.size[0] + x]
    }

    fn trilinear(&self, cell: [i64; 3], f: [f32; 3]) -> f32 {
        let [xs, ys, zs] = [0, 1, 2].map(|a| [0, 1].map(|d| wrapped(cell[a] + d, self.size[a])));
        let mix = |t: f32, a: f32, b: f32| a + t * (b - a);
        let along_x = |y, z| mix(f[0], self.sample(xs[0], y, z), self.sample(xs[1], y, z));
        let along_y = |z| mix(f[1], along_x(ys[0], z), along_x(ys[1], z));
        mix(f[2], along_y(zs[0]), along_y(zs[1]))
    }

    fn tricubic(&self, cell: [i64; 3], f: [f32; 3]) -> f32 {
        let around = |axis: usize| -> [usize; 4] {
            std::array::from_fn(|i| wrapped(cell[axis] + i as i64 - 1, self.size[axis]))
        };
        let (xs, ys, zs) = (around(0), around(1), around(2));
        let along_z = |x, y| cubic(f[2], zs.map(|z| self.sample(x, y, z)));
        let along_y = |x| cubic(f[1], ys.map(|y| along_z(x, y)));
        cubic(f[0], xs.map(along_y)).max(0.0)
    }
}

impl Pattern for DensityFile {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        if !p.to_array().iter().all(|c| (0.0..1.0).contains(c)) {
            return 0.0;
        }
        let grid = &*self.grid;
        let q = p * Vec3::from_array(grid.size.map(|s| s as f64));
        let cell = q.to_array().map(|c| c as i64);
        let f: [f32; 3] = std::array::from_fn(|i| (q[i] - cell[i] as f64) as f32);
        f64::from(match self.interpolate {
            0 => grid.sample(cell[0] as usize, cell[1] as usize, cell[2] as usize),
            1 => grid.trilinear(cell, f),
            _ => grid.tricubic(cell, f),
        })
    }

    fn modified(&self, modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        match modifier {
            Modifier::Interpolate(interpolate) => Some(Arc::new(Self { interpolate, ..self.clone() })),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Context, NoiseGenerator, Turbulence};

    const TABLE: &str = include_str!("../../tests/data/2-density-oracle.csv");

    fn file(name: &str, size: [u16; 3], width: usize) -> DensityFile {
        let prefix = format!("data,{name},");
        let data = TABLE.lines().find_map(|l| l.strip_prefix(&prefix)).unwrap();
        let mut bytes: Vec<u8> = size.iter().flat_map(|s| s.to_be_bytes()).collect();
        for v in data.split(' ') {
            let v: u16 = v.parse().unwrap();
            bytes.extend_from_slice(&v.to_be_bytes()[2 - width..]);
        }
        DensityFile::new(&bytes).unwrap()
    }

    #[test]
    fn densities_are_as_measured() {
        let files = [("a", file("a", [3, 4, 5], 1)), ("b", file("b", [2, 3, 2], 2))];
        let turbulence = Turbulence::default();
        let context = Context { noise: NoiseGenerator::RangeCorrected, waves: 10, hit: None };
        let setting = Setting {
            noise: NoiseGenerator::RangeCorrected,
            turbulence: &turbulence,
            frequency: 1.0,
            phase: 0.0,
            context: &context,
        };
        let mut count = 0;
        for line in TABLE.lines().filter_map(|l| l.strip_prefix("val,")) {
            let (name, rest) = line.split_once(',').unwrap();
            let v: Vec<f64> = rest.split(',').map(|f| f.parse().unwrap()).collect();
            let file = &files.iter().find(|(n, _)| *n == name).unwrap().1;
            let pattern = file.modified(Modifier::Interpolate(v[0] as u32)).unwrap();
            let got = pattern.value(Vec3::new(v[1], v[2], v[3]), &setting);
            assert!((got - v[4]).abs() < 3e-7, "{line}: {got}");
            count += 1;
        }
        assert_eq!(count, 204);
    }

    #[test]
    fn broken_files_are_refused() {
        assert!(DensityFile::new(&[0, 1, 0]).is_err());
        assert!(DensityFile::new(&[0, 0, 0, 1, 0, 1, 9]).is_err());
        assert!(DensityFile::new(&[0, 2, 0, 2, 0, 2, 9]).is_err());
    }
}
