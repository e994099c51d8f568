//! Comparisons of numbers and strings.

use super::directives::TINY;
use super::expr::number;
use crate::syntax::{Punct, Tok};
use std::cmp::Ordering;

/// Equality allows for a small difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Comparison {
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
}

impl Comparison {
    #[inline]
    pub fn from_token(tok: Tok) -> Option<Self> {
        let Tok::Punct(punct) = tok else { return None };
        Some(match punct {
            Punct::Less => Self::Less,
            Punct::Greater => Self::Greater,
            Punct::LessEqual => Self::LessEqual,
            Punct::GreaterEqual => Self::GreaterEqual,
            Punct::Equal => Self::Equal,
            Punct::NotEqual => Self::NotEqual,
            _ => return None,
        })
    }

    /// 1 if it holds, else 0.
    #[inline]
    pub fn of(self, a: f64, b: f64) -> f64 {
        number(match self {
            Self::Less => a < b,
            Self::Greater => a > b,
            Self::LessEqual => a < b || near(a, b),
            Self::GreaterEqual => a > b || near(a, b),
            Self::Equal => near(a, b),
            Self::NotEqual => !near(a, b),
        })
    }

    pub fn holds(self, order: Ordering) -> bool {
        match self {
            Self::Less => order.is_lt(),
            Self::LessEqual => order.is_le(),
            Self::Greater => order.is_gt(),
            Self::GreaterEqual => order.is_ge(),
            Self::Equal => order.is_eq(),
            Self::NotEqual => order.is_ne(),
        }
    }
}

pub(super) fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= TINY || a == b
}
