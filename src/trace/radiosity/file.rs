//! Samples as text, in the reference's own layout, so that they can go back and forth.
//!
//! A line for each: `C` and the depth counted from 1, place, normal, colour, harmonic mean of the distances,
//! nearest distance, direction to it; tabs in between. Normals and directions have two hexadecimal digits
//! an axis, `floor((v + 1)*127 + 0.499999)`. How well a sample is founded is not written: one that is read
//! counts fully.

use super::Sample;
use crate::color::Rgb;
use crate::math::Vec3;
use std::fmt::Write;

/// More reflections than any scene may ask for.
const DEEPEST: u32 = 20;

/// The text of samples.
pub fn written(samples: &[Sample]) -> String {
    let mut text = String::new();
    for s in samples {
        let Vec3 { x, y, z } = s.point;
        let [r, g, b] = s.color.to_array();
        let (depth, normal, towards) = (s.depth + 1, packed(s.normal), packed(s.towards));
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "C{depth}\t{x}\t{y}\t{z}\t{normal}\t{r}\t{g}\t{b}\t{}\t{}\t{towards}",
            s.radius, s.nearest
        );
    }
    text
}

/// The samples of a text, their reach left open; else the number of the first line that is none.
pub fn read(text: &[u8]) -> Result<Vec<Sample>, usize> {
    let text = String::from_utf8_lossy(text);
    let lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    lines.map(|(i, line)| sample(line).ok_or(i + 1)).collect()
}

fn sample(line: &str) -> Option<Sample> {
    let fields: Vec<&str> = line.split_whitespace().collect();
    let [depth, x, y, z, normal, r, g, b, radius, nearest, towards] = fields[..] else { return None };
    let number = |text: &str| text.parse::<f64>().ok().filter(|v| v.is_finite());
    let single = |text: &str| number(text).map(|v| v as f32).filter(|v| v.is_finite());
    let depth: u32 = depth.strip_prefix('C')?.parse().ok()?;
    let (radius, nearest) = (single(radius)?, single(nearest)?);
    ((1..=DEEPEST).contains(&depth) && radius > 0.0 && nearest >= 0.0).then_some(())?;
    Some(Sample {
        depth: depth - 1,
        point: Vec3::new(number(x)?, number(y)?, number(z)?),
        normal: unpacked(normal)?,
        color: Rgb::new(single(r)?, single(g)?, single(b)?),
        quality: 1.0,
        radius,
        nearest,
        towards: unpacked(towards)?,
        reach: 0.0,
    })
}

fn packed(v: Vec3) -> String {
    let digits = |v: f64| ((v + 1.0) * 127.0 + 0.499999) as u8;
    format!("{:02x}{:02x}{:02x}", digits(v.x), digits(v.y), digits(v.z))
}

/// A unit vector, or none.
fn unpacked(text: &str) -> Option<Vec3> {
    let all = u32::from_str_radix(text, 16).ok().filter(|_| text.len() == 6)?;
    let axis = |shift: u32| f64::from(all >> shift & 0xff) / 127.0 - 1.0;
    Some(Vec3::new(axis(16), axis(8), axis(0)).normalize_or_zero())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_come_back() {
        let sample = Sample {
            depth: 2,
            point: Vec3::new(0.1, -2e7, 5.55112e-17),
            normal: Vec3::Y,
            color: Rgb::new(0.25, 0.5, 1.5),
            quality: 1.0,
            radius: 0.310025,
            nearest: 2e10,
            towards: Vec3::ZERO,
            reach: 0.0,
        };
        let text = written(std::slice::from_ref(&sample));
        assert_eq!(text.split('\t').count(), 11);
        assert_eq!(read(text.as_bytes()), Ok(vec![sample]));
    }

    /// A line as the reference writes it.
    #[test]
    fn the_reference_is_understood() {
        let line =
            b"C2\t0.0966111\t5.55112e-17\t0.41007\t7ffe7f\t0.1066\t0.1066\t0.1066\t0.310025\t0.140379\t93e73a\n";
        let samples = read(line).unwrap();
        assert_eq!((samples[0].depth, samples[0].normal, samples[0].color.x), (1, Vec3::Y, 0.1066));
        assert!((samples[0].towards - Vec3::new(0.157, 0.818, -0.543)).length() < 0.02);
    }

    #[test]
    fn other_texts_are_refused() {
        for text in ["C1 2 3", "C0\t0 0 0 7ffe7f 0 0 0 1 1 7f7f7f", "C1 0 0 nan 7ffe7f 0 0 0 1 1 7f7f7f", "é"]
        {
            assert_eq!(read(format!("\n{text}\n").as_bytes()), Err(2), "{text}");
        }
    }
}
