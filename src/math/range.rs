/// An open interval of ray parameters, `min < t < max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    pub min: f64,
    pub max: f64,
}

impl Range {
    /// Everything in front of a ray's origin.
    pub const FORWARD: Range = Range { min: 0.0, max: f64::INFINITY };
    /// The whole line, behind the origin too.
    pub const LINE: Range = Range { min: f64::NEG_INFINITY, max: f64::INFINITY };

    #[inline]
    pub fn new(min: f64, max: f64) -> Self {
        Self { min, max }
    }

    /// Whether `t` lies strictly inside. False for NaN.
    #[inline]
    pub fn contains(&self, t: f64) -> bool {
        t > self.min && t < self.max
    }

    /// The same interval measured in another unit: both ends times `factor > 0`.
    #[inline]
    pub fn scaled(&self, factor: f64) -> Self {
        Self { min: self.min * factor, max: self.max * factor }
    }
}
