use super::{Function, FunctionValue, VectorKind, patience};
use crate::color::Color;
use std::sync::Arc;

/// `function W, H { … }` in place of an image file: the function sampled over the unit square.
#[derive(Clone, Debug)]
pub struct FunctionImage {
    pub width: u32,
    pub height: u32,
    /// Gives numbers or colours.
    pub function: Arc<Function>,
}

impl FunctionImage {
    pub fn is_color(&self) -> bool {
        self.function.vector_kind() == Some(VectorKind::Color)
    }

    /// Grey values in rows from the top: of a colour, its grey.
    pub fn greys(&self) -> Vec<u16> {
        self.sample(|value| match value {
            FunctionValue::Float(v) => quantized(v),
            FunctionValue::Vector(_, v) => quantized(v[0]),
            FunctionValue::Color(c) => quantized(f64::from(crate::color::grey(c.rgb))),
        })
    }

    /// Red, green, blue and opacity in rows from the top. `filter` is dropped.
    pub fn colors(&self) -> Vec<[u16; 4]> {
        let components =
            |c: Color| [c.rgb.x, c.rgb.y, c.rgb.z, 1.0 - c.transmit].map(|v| quantized(v.into()));
        self.sample(|value| match value {
            FunctionValue::Color(c) => components(c),
            FunctionValue::Float(v) | FunctionValue::Vector(_, [v, ..]) => {
                let v = quantized(v);
                [v, v, v, u16::MAX]
            }
        })
    }

    /// Column j of row i is the value at (j / (W - 1), i / (H - 1), 0). Ends where functions give up.
    fn sample<T>(&self, texel: impl Fn(FunctionValue) -> T) -> Vec<T> {
        let step = |i: u32, count: u32| f64::from(i) / f64::from(count.max(2) - 1);
        let rows = (0..self.height).map(|i| step(i, self.height));
        rows.flat_map(|y| (0..self.width).map(move |j| [step(j, self.width), y, 0.0]))
            .map_while(|p| patience::step().then(|| texel(self.function.call(&p))))
            .collect()
    }
}

/// A 16-bit sample. Values outside 0 .. 1 wrap around, as the reference has it.
fn quantized(v: f64) -> u16 {
    (v * 65535.0) as i64 as u16
}

#[cfg(test)]
mod tests {
    use super::super::{Expression, Unary};
    use super::*;

    fn image(
        width: u32,
        height: u32,
        build: impl Fn(&mut Expression) -> super::super::Node,
    ) -> FunctionImage {
        let mut e = Expression::default();
        let root = build(&mut e);
        let function = Arc::new(Function::new(e, root, 3).unwrap());
        FunctionImage { width, height, function }
    }

    #[test]
    fn no_time_no_texels() {
        let x = image(3000, 3000, |e| e.parameter(0));
        patience::give_up_at(std::time::Instant::now().checked_sub(std::time::Duration::from_secs(1)));
        let (greys, gave_up) = (x.greys(), patience::gave_up());
        patience::give_up_at(None);
        assert!(greys.len() < 1_000_000 && gave_up, "{}", greys.len());
    }

    #[test]
    fn rows_go_down_and_reach_both_edges() {
        let y = image(2, 3, |e| e.parameter(1));
        assert_eq!(y.greys(), [0, 0, 32767, 32767, 65535, 65535]);
        let x = image(3, 1, |e| e.parameter(0));
        assert_eq!(x.colors()[1], [32767, 32767, 32767, 65535]);
    }

    #[test]
    fn values_wrap() {
        let wrapped = |v: f64| f64::from(image(1, 1, |e| e.constant(v)).greys()[0]) / 65535.0;
        assert!((wrapped(-0.5) - 0.500023).abs() < 1e-6);
        assert_eq!(wrapped(1.0323), 2115.0 / 65535.0);
        let whole = image(2, 1, |e| {
            let x = e.parameter(0);
            e.unary(Unary::Neg, x)
        });
        assert_eq!(whole.greys(), [0, 1]);
    }
}
