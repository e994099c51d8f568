//! Noise and sums of its octaves.
//!
//! Reference: D. Ebert et al., "Texturing and Modeling: A Procedural Approach", 1994 (F. K. Musgrave's
//! multifractals).

use super::super::number::Number;
use super::{Arguments, rows};
use crate::math::noise::NoiseGenerator;

rows! {
    29 hetero_mf 6;
    58 ridge 6;
    59 ridged_mf 6;
    76 noise3d 0;
    78 noise_generator 1;
}

/// Most octaves that are summed; later ones are beyond what coordinates resolve.
const LARGEST_OCTAVES: f64 = 1000.0;

/// The generator that a parameter's two lowest bits name; 0 is the first.
fn generator<N: Number>(parameter: N) -> Option<NoiseGenerator> {
    let bits = parameter.known()? as i32 & 3;
    Some(NoiseGenerator::from_number(bits as u32).unwrap_or(NoiseGenerator::Original))
}

fn noise3d<N: Number>(a: &Arguments<N>) -> N {
    N::noise([a.x, a.y, a.z], a.generator)
}

fn noise_generator<N: Number>(a: &Arguments<N>) -> N {
    match generator(a.p[0]) {
        Some(generator) => N::noise([a.x, a.y, a.z], generator),
        None => N::UNKNOWN,
    }
}

/// Octaves whose size depends on the sum so far: rough where it is high.
fn hetero_mf<N: Number>(a: &Arguments<N>) -> N {
    let (Some(octaves), Some(power), Some(generator)) = (a.p[2].known(), a.p[4].known(), generator(a.p[5]))
    else {
        return N::UNKNOWN;
    };
    let [lacunarity, offset] = [a.p[1], a.p[3]];
    let falloff = lacunarity.pow(-a.p[0]);
    let signal = |p: [N; 3]| N::noise(p, generator) * 2.0 - 1.0 + offset;
    let mut p = [a.x, a.y, a.z];
    let mut sum = signal(p);
    let mut weight = falloff;
    let mut octave = 1.0;
    while octave < octaves.min(LARGEST_OCTAVES) {
        p = p.map(|c| c * lacunarity);
        let mut increment = signal(p) * weight;
        for _ in 0..power.floor().min(LARGEST_OCTAVES) as i32 {
            increment = increment * sum;
        }
        sum = sum + increment;
        weight = weight * falloff;
        octave += 1.0;
    }
    let rest = octaves - octaves.floor();
    if rest != 0.0 {
        p = p.map(|c| c * lacunarity);
        sum = sum + signal(p) * weight * sum * rest;
    }
    sum
}

/// Octaves of distance from a level, scaled by what they can reach.
fn ridge<N: Number>(a: &Arguments<N>) -> N {
    let (Some(octaves), Some(generator)) = (a.p[1].known(), generator(a.p[5])) else {
        return N::UNKNOWN;
    };
    let [lambda, omega, offset, level] = [a.p[0], a.p[2], a.p[3], a.p[4]];
    let one = N::from(1.0);
    let reach = level.max(one - level);
    let signal = |l: N| (N::noise([a.x * l, a.y * l, a.z * l], generator) - level).abs() / reach - offset;
    let (mut sum, mut total) = (signal(one), one);
    let (mut l, mut o) = (lambda, omega);
    let mut octave = 2.0;
    while octave <= octaves.min(LARGEST_OCTAVES).floor() {
        sum = sum + o * signal(l);
        total = total + o;
        l = l * lambda;
        o = o * omega;
        octave += 1.0;
    }
    let rest = octaves - octaves.floor();
    if rest != 0.0 {
        sum = sum + o * signal(l) * rest;
        total = total + o * rest;
    }
    sum / (offset.max(one - offset) * total)
}

/// Squared ridges; each octave counts where the one before it was high.
fn ridged_mf<N: Number>(a: &Arguments<N>) -> N {
    let (Some(octaves), Some(generator)) = (a.p[2].known(), generator(a.p[5])) else {
        return N::UNKNOWN;
    };
    let [h, lacunarity, offset, gain] = [a.p[0], a.p[1], a.p[3], a.p[4]];
    let signal = |p: [N; 3]| (offset - (N::noise(p, generator) * 2.0 - 1.0).abs()).square();
    let mut p = [a.x, a.y, a.z];
    let mut ridge = signal(p);
    let mut sum = ridge;
    let falloff = lacunarity.pow(-h);
    let mut height = falloff;
    let mut octave = 1.0;
    while octave < octaves.min(LARGEST_OCTAVES) {
        p = p.map(|c| c * lacunarity);
        let weight = (ridge * gain).max(N::from(0.0)).min(N::from(1.0));
        ridge = signal(p) * weight;
        sum = sum + ridge * height;
        height = height * falloff;
        octave += 1.0;
    }
    sum
}
