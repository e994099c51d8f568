//! Runs compiled expressions.

use super::program::{DEPTH, Op};
use super::symbols::Symbols;
use super::value::{Array, Value};
use crate::syntax::Symbol;

/// The value of a program; `None` where it takes more than a program can do.
pub(super) fn run(ops: &[Op], symbols: &Symbols) -> Option<f64> {
    let mut stack = [0.0; DEPTH];
    let mut top = 0;
    // The compiler has checked that the stack suffices; the remainder only says so to the machine.
    for op in ops {
        let value = match *op {
            Op::Constant(v) => v,
            Op::Variable(name) => symbols.float(name)?,
            Op::Component(name, index) => component(symbols.value(name)?, index)?,
            Op::Function(f) => {
                top -= 1;
                f(stack[top % DEPTH])
            }
            Op::Partial(f) => {
                top -= 1;
                f.of(stack[top % DEPTH])?
            }
            Op::Binary(binary) => {
                top -= 2;
                binary.apply(stack[top % DEPTH], stack[(top + 1) % DEPTH])?
            }
            Op::BinaryConstant(binary, right) => {
                top -= 1;
                binary.apply(stack[top % DEPTH], right)?
            }
            Op::BinaryVariable(binary, name) => {
                top -= 1;
                binary.apply(stack[top % DEPTH], symbols.float(name)?)?
            }
            Op::Element(name, count) => {
                top -= count as usize;
                match element(symbols, name, stack.get(top..top + count as usize)?)? {
                    Value::Float(v) => *v,
                    _ => return None,
                }
            }
            Op::ElementComponent(name, count, index) => {
                top -= count as usize;
                component(element(symbols, name, stack.get(top..top + count as usize)?)?, index)?
            }
            Op::Choose => {
                top -= 3;
                let (condition, yes, no) =
                    (stack[top % DEPTH], stack[(top + 1) % DEPTH], stack[(top + 2) % DEPTH]);
                if super::expr::truth(condition) { yes } else { no }
            }
        };
        stack[top % DEPTH] = value;
        top += 1;
    }
    Some(stack[0])
}

fn component(value: &Value, index: u8) -> Option<f64> {
    match value {
        Value::Float(v) if index == 0 => Some(*v),
        Value::Vector(n, v) if index < *n => Some(v[index as usize]),
        Value::Color(c) => Some(f64::from(c.components()[index as usize])),
        _ => None,
    }
}

/// The element with those subscripts, of arrays within arrays if need be.
fn element<'a>(symbols: &'a Symbols, name: Symbol, mut subscripts: &[f64]) -> Option<&'a Value> {
    let mut value = symbols.value(name)?;
    while !subscripts.is_empty() {
        let Value::Array(array) = value else { return None };
        let (these, others) = subscripts.split_at_checked(array.sizes.len())?;
        value = array.elements[flat(array, these)?].as_ref()?;
        subscripts = others;
    }
    Some(value)
}

fn flat(array: &Array, subscripts: &[f64]) -> Option<usize> {
    subscripts
        .iter()
        .zip(&array.sizes)
        .try_fold(0, |flat, (&v, &size)| Some(flat * size + super::grammar::array_index(v, size)?))
}
