use super::recursion::Itself;
use super::{Function, Internal, Number};
use crate::math::field::Field;
use crate::math::{Spline, Transform, Vec3};
use std::fmt::Debug;
use std::sync::Arc;

/// A function with several numbers for a value: of a point, or of one parameter.
pub trait VectorFunction: Debug + Send + Sync {
    /// The number of arguments.
    fn arity(&self) -> usize {
        3
    }

    fn kind(&self) -> VectorKind;

    /// Components that the value lacks are 0.
    fn value(&self, arguments: &[f64]) -> [f64; 5];

    /// How many functions, patterns, pigments and objects stand within each other here.
    fn depth(&self) -> u32 {
        0
    }

    /// The map that the function is, if it is an affine one.
    fn affine(&self) -> Option<&Transform> {
        None
    }
}

/// What a vector-valued function gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VectorKind {
    /// 2 to 5 components.
    Vector(u8),
    /// Red, green, blue, filter, transmit.
    Color,
}

impl VectorKind {
    pub fn components(self) -> usize {
        match self {
            VectorKind::Vector(n) => usize::from(n),
            VectorKind::Color => 5,
        }
    }
}

/// `function { transform { … } }`: the point moved.
impl VectorFunction for Transform {
    fn kind(&self) -> VectorKind {
        VectorKind::Vector(3)
    }

    fn value(&self, arguments: &[f64]) -> [f64; 5] {
        let p = self.point(Vec3::from_slice(arguments));
        [p.x, p.y, p.z, 0.0, 0.0]
    }

    fn affine(&self) -> Option<&Transform> {
        Some(self)
    }
}

/// `function { spline { … } }`.
impl VectorFunction for Spline {
    fn arity(&self) -> usize {
        1
    }

    fn kind(&self) -> VectorKind {
        VectorKind::Vector(self.dimension() as u8)
    }

    fn value(&self, arguments: &[f64]) -> [f64; 5] {
        Spline::value(self, arguments[0])
    }
}

/// What an expression can call and does not contain.
#[derive(Clone, Debug)]
pub(super) enum Callee {
    Internal(Internal),
    /// An expression too long to be copied into its caller.
    Function(Arc<Function>),
    Field(Arc<dyn Field>),
    Vector(Arc<dyn VectorFunction>),
    /// The function whose body holds the call.
    Itself(Itself),
}

impl Callee {
    /// The value; of a vector, the first component.
    #[inline]
    pub fn number<N: Number>(&self, arguments: &[N]) -> N {
        match self {
            Callee::Internal(internal) => internal.value(arguments),
            Callee::Function(function) => function.number(arguments),
            Callee::Field(field) => N::field(&**field, [0, 1, 2].map(|i| arguments[i])),
            Callee::Itself(itself) => itself.number(arguments),
            Callee::Vector(_) => self.values(arguments)[0],
        }
    }

    /// The components of the value; a number is the first.
    #[inline]
    pub fn values<N: Number>(&self, arguments: &[N]) -> [N; 5] {
        let mut values = [N::from(0.0); 5];
        match self {
            Callee::Vector(vector) => N::vector(&**vector, arguments, &mut values),
            _ => values[0] = self.number(arguments),
        }
        values
    }

    /// How many functions and what they call stand within each other in this one.
    pub fn depth(&self) -> u32 {
        match self {
            Callee::Function(function) => function.depth(),
            Callee::Field(field) => field.depth(),
            Callee::Vector(vector) => vector.depth(),
            Callee::Internal(_) | Callee::Itself(_) => 0,
        }
    }

    /// How many numbers a call gives.
    pub fn results(&self) -> usize {
        match self {
            Callee::Vector(v) => v.kind().components(),
            _ => 1,
        }
    }
}
