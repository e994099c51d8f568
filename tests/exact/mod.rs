//! Numbers of a thousand bits, to hold double precision against.

use astro_float_num::{BigFloat, Consts, RoundingMode};
use std::cell::RefCell;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

const BITS: usize = 1024;
const NEAREST: RoundingMode = RoundingMode::ToEven;

#[derive(Clone, Debug)]
pub struct Exact(BigFloat);

thread_local! {
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().expect("room for constants"));
}

impl From<f64> for Exact {
    fn from(v: f64) -> Self {
        Exact(BigFloat::from_f64(v, BITS))
    }
}

macro_rules! operation {
    ($operation:ident, $name:ident) => {
        impl $operation for &Exact {
            type Output = Exact;
            fn $name(self, o: &Exact) -> Exact {
                Exact(self.0.$name(&o.0, BITS, NEAREST))
            }
        }
    };
}

operation!(Add, add);
operation!(Sub, sub);
operation!(Mul, mul);
operation!(Div, div);

impl Neg for &Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact(BigFloat::neg(&self.0))
    }
}

impl PartialEq for Exact {
    fn eq(&self, o: &Exact) -> bool {
        self.partial_cmp(o) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Exact {
    fn partial_cmp(&self, o: &Exact) -> Option<Ordering> {
        self.0.cmp(&o.0).map(|sign| sign.cmp(&0))
    }
}

#[allow(dead_code)]
impl Exact {
    pub fn abs(&self) -> Exact {
        Exact(self.0.abs())
    }

    pub fn is_negative(&self) -> bool {
        self.0.is_negative() && !self.0.is_zero()
    }

    pub fn sin(&self) -> Exact {
        CONSTANTS.with_borrow_mut(|constants| Exact(self.0.sin(BITS, NEAREST, constants)))
    }

    pub fn cos(&self) -> Exact {
        CONSTANTS.with_borrow_mut(|constants| Exact(self.0.cos(BITS, NEAREST, constants)))
    }

    pub fn sinh(&self) -> Exact {
        CONSTANTS.with_borrow_mut(|constants| Exact(self.0.sinh(BITS, NEAREST, constants)))
    }

    pub fn cosh(&self) -> Exact {
        CONSTANTS.with_borrow_mut(|constants| Exact(self.0.cosh(BITS, NEAREST, constants)))
    }
}
