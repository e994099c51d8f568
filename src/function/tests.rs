//! One suite over all evaluators: a walk over the expression, the program on numbers, the program on ranges.

use super::expr::Term;
use super::*;
use crate::math::random::Lcg;
use std::collections::HashMap;

/// Numbers for the tests, from a fixed seed.
struct Dice(Lcg);

impl Dice {
    fn below(&mut self, n: u32) -> u32 {
        self.0.draw() % n
    }

    fn number(&mut self) -> f64 {
        match self.below(4) {
            0 => f64::from(self.below(7)) - 3.0,
            1 => f64::from(self.below(100)) * 0.01,
            _ => (f64::from(self.below(10_000)) - 5000.0) * 0.0007,
        }
    }
}

const UNARY: [Unary; 14] = [
    Unary::Neg,
    Unary::Abs,
    Unary::Square,
    Unary::Sqrt,
    Unary::Sin,
    Unary::Cos,
    Unary::Tan,
    Unary::Asin,
    Unary::Atan,
    Unary::Tanh,
    Unary::Exp,
    Unary::Ln,
    Unary::Floor,
    Unary::Int,
];

const BINARY: [Binary; 17] = [
    Binary::Add,
    Binary::Sub,
    Binary::Mul,
    Binary::Div,
    Binary::Add,
    Binary::Sub,
    Binary::Mul,
    Binary::Min,
    Binary::Max,
    Binary::Pow,
    Binary::Mod,
    Binary::Atan2,
    Binary::Less,
    Binary::GreaterEqual,
    Binary::Equal,
    Binary::And,
    Binary::Or,
];

/// Adds a random subexpression with the given counters in scope.
fn grow(e: &mut Expression, dice: &mut Dice, depth: u32, counters: &mut Vec<Node>) -> Node {
    if depth == 0 || dice.below(8) == 0 {
        return match dice.below(3 + counters.len() as u32) {
            0 => e.constant((dice.number() * 4.0).round() * 0.25),
            1 | 2 => e.parameter(dice.below(3) as usize),
            n => counters[n as usize - 3],
        };
    }
    match dice.below(12) {
        0..=2 => {
            let a = grow(e, dice, depth - 1, counters);
            e.unary(UNARY[dice.below(14) as usize], a)
        }
        3 => {
            let branches: [Node; 3] = std::array::from_fn(|_| grow(e, dice, depth - 1, counters));
            let test = grow(e, dice, depth - 1, counters);
            let three_way = dice.below(2) == 0;
            e.choice(test, if three_way { branches } else { [branches[0], branches[1], branches[1]] })
        }
        4 => {
            let counter = e.counter();
            let from = e.constant(f64::from(dice.below(3)));
            let to = match dice.below(2) {
                0 => e.constant(f64::from(dice.below(5))),
                _ => counters.last().copied().unwrap_or(from),
            };
            counters.push(counter);
            let body = grow(e, dice, depth - 1, counters);
            counters.pop();
            e.fold(dice.below(2) == 0, counter, [from, to], body)
        }
        5 => {
            let surroundings = Arc::new(Surroundings::default());
            let sphere = Arc::new(Function::from_internal(Internal::new(61, &surroundings).unwrap()));
            let arguments: [Node; 4] = std::array::from_fn(|_| grow(e, dice, depth - 1, counters));
            sphere.call_in(e, &arguments)
        }
        6 => {
            let shift =
                Arc::new(Function::from_vector(Arc::new(Transform::translate(Vec3::new(1.0, 2.0, 3.0)))));
            let arguments: [Node; 3] = std::array::from_fn(|_| grow(e, dice, depth - 1, counters));
            let call = shift.call_in(e, &arguments);
            e.component(call, dice.below(3) as u8)
        }
        _ => {
            let (a, b) = (grow(e, dice, depth - 1, counters), grow(e, dice, depth - 1, counters));
            e.binary(BINARY[dice.below(17) as usize], a, b)
        }
    }
}

use crate::math::Transform;

/// Evaluates by walking over the terms: slow, and simple.
fn walk(e: &Expression, node: Node, p: &[f64], counters: &mut HashMap<u32, f64>) -> f64 {
    let mut at = |n: Node| walk(e, n, p, counters);
    match &e.terms[node.index()] {
        Term::Constant(bits) => f64::from_bits(*bits),
        Term::Parameter(index) => p[*index as usize],
        Term::Counter(number) => counters[number],
        Term::Unary(f, a) => at(*a).unary(*f),
        Term::Power(a, n) => at(*a).powi(*n),
        Term::Binary(f, a, b) => at(*a).binary(*f, at(*b)),
        Term::Choice(test, branches) => {
            let test = at(*test);
            at(branches[if test < 0.0 {
                0
            } else if test == 0.0 {
                1
            } else {
                2
            }])
        }
        Term::Loop { product, counter, from, to, body } => {
            let (mut i, to) = (at(*from), at(*to));
            let mut total = f64::from(u8::from(*product));
            while i <= to {
                counters.insert(*counter, i);
                let value = walk(e, *body, p, counters);
                total = if *product { total * value } else { total + value };
                i += 1.0;
            }
            total
        }
        Term::Call { callee, arguments } => {
            let arguments: Vec<f64> = arguments.iter().map(|a| at(*a)).collect();
            e.callees[*callee as usize].values(&arguments)[0]
        }
        Term::Component(call, index) => {
            let Term::Call { callee, arguments } = &e.terms[call.index()] else { unreachable!() };
            let arguments: Vec<f64> = arguments.iter().map(|a| at(*a)).collect();
            e.callees[*callee as usize].values(&arguments)[usize::from(*index)]
        }
    }
}

fn same(a: f64, b: f64) -> bool {
    a == b || (a.is_nan() && b.is_nan())
}

#[test]
fn programs_do_what_expressions_say() {
    let mut dice = Dice(Lcg::new(7));
    for round in 0..600 {
        let mut e = Expression::default();
        let root = grow(&mut e, &mut dice, 2 + round % 7, &mut Vec::new());
        let f = Function::new(e.clone(), root, 3).unwrap();
        for _ in 0..10 {
            let p: [f64; 3] = std::array::from_fn(|_| dice.number());
            let expected = walk(&e, root, &p, &mut HashMap::new());
            let value: f64 = f.number(&p);
            assert!(same(value, expected), "{value} instead of {expected} at {p:?}: {:?}", e.terms);
        }
    }
}

#[test]
fn ranges_enclose_programs() {
    let mut dice = Dice(Lcg::new(8));
    let mut useful = 0;
    for round in 0..600 {
        let mut e = Expression::default();
        let root = grow(&mut e, &mut dice, 2 + round % 6, &mut Vec::new());
        let f = Function::new(e.clone(), root, 3).unwrap();
        for _ in 0..5 {
            let center: [f64; 3] = std::array::from_fn(|_| dice.number());
            let radius = 0.5 * f64::from(dice.below(4)) * dice.number().abs();
            let sides = center.map(|c| Interval::new(c - radius, c + radius));
            let range: Interval = f.number(&sides);
            useful += u32::from(range != Interval::WHOLE);
            for _ in 0..20 {
                let p = sides.map(|s| (s.lo + (s.hi - s.lo) * f64::from(dice.below(101)) * 0.01).min(s.hi));
                let value: f64 = f.number(&p);
                assert!(
                    range == Interval::WHOLE || range.contains(value),
                    "{value} at {p:?} outside {range:?} over {sides:?}: {:?}",
                    e.terms
                );
            }
        }
    }
    assert!(useful > 1000, "only {useful} ranges say anything");
}

#[test]
fn copied_functions_do_what_called_ones_do() {
    let mut dice = Dice(Lcg::new(9));
    for round in 0..300 {
        let mut inner = Expression::default();
        let inner_root = grow(&mut inner, &mut dice, 2 + round % 4, &mut Vec::new());
        let inner = Arc::new(Function::new(inner, inner_root, 3).unwrap());
        let build = |copied: bool, dice: &mut Dice| {
            let mut e = Expression::default();
            let arguments: [Node; 3] = std::array::from_fn(|_| grow(&mut e, dice, 2, &mut Vec::new()));
            let call = match copied {
                true => inner.call_in(&mut e, &arguments),
                false => e.call(Callee::Function(inner.clone()), &arguments),
            };
            let two = e.constant(2.0);
            let root = e.binary(Binary::Mul, call, two);
            Function::new(e, root, 3).unwrap()
        };
        let seed = dice.below(30_000);
        let copied = build(true, &mut Dice(Lcg::new(seed)));
        let called = build(false, &mut Dice(Lcg::new(seed)));
        for _ in 0..10 {
            let p: [f64; 3] = std::array::from_fn(|_| dice.number());
            let (a, b): (f64, f64) = (copied.number(&p), called.number(&p));
            // Folding with constant arguments may round once more or less.
            assert!(same(a, b) || (a - b).abs() <= 1e-9 * a.abs().max(1.0), "{a} and {b} at {p:?}");
        }
    }
}

#[test]
fn long_sums_need_few_registers() {
    let mut e = Expression::default();
    let x = e.parameter(0);
    let mut root = x;
    for k in 0..50_000 {
        let k = e.constant(f64::from(k) * 1e-3);
        let term = e.binary(Binary::Mul, x, k);
        root = e.binary(Binary::Add, root, term);
    }
    let f = Function::new(e, root, 1).unwrap();
    let Body::Expression(compiled) = &f.body else { panic!("not compiled") };
    assert!(compiled.on_numbers.registers <= 8);
    let sum: f64 = (0..50_000).map(|k| f64::from(k) * 1e-3).sum::<f64>() + 1.0;
    assert!((f.number(&[1.0]) - sum).abs() < 1e-4);
}

#[test]
fn branches_in_branches_stay_short() {
    let mut e = Expression::default();
    let x = e.parameter(0);
    let mut root = x;
    for k in 0..40 {
        let (k, two) = (e.constant(f64::from(k)), e.constant(2.0));
        let test = e.binary(Binary::Sub, x, k);
        let (more, twice) = (e.binary(Binary::Add, root, k), e.binary(Binary::Mul, root, two));
        root = e.choice(test, [more, twice, twice]);
    }
    let f = Function::new(e, root, 1).unwrap();
    // From 3.5 on the tests are negative: 3.5 doubled four times, then 4 to 39 added.
    assert_eq!(f.number::<f64>(&[3.5]), 3.5 * 16.0 + (4..40).sum::<i32>() as f64);
}

#[test]
fn equal_parts_are_computed_once() {
    let mut e = Expression::default();
    let (x, y) = (e.parameter(0), e.parameter(1));
    let mut length = || {
        let (a, b) = (e.unary(Unary::Square, x), e.unary(Unary::Square, y));
        let sum = e.binary(Binary::Add, a, b);
        e.unary(Unary::Sqrt, sum)
    };
    let (a, b) = (length(), length());
    assert_eq!(a, b);
    let sine = e.unary(Unary::Sin, a);
    let root = e.binary(Binary::Mul, sine, b);
    let f = Function::new(e, root, 2).unwrap();
    let Body::Expression(compiled) = &f.body else { panic!("not compiled") };
    assert_eq!(compiled.on_numbers.code.len(), 6);
}

#[test]
fn only_the_chosen_branch_runs() {
    #[derive(Debug)]
    struct Trap;
    impl Field for Trap {
        fn value(&self, _: Vec3) -> f64 {
            panic!("evaluated");
        }
    }
    let mut e = Expression::default();
    let p = [0, 1, 2].map(|i| e.parameter(i));
    let trap = Arc::new(Function::from_field(Arc::new(Trap))).call_in(&mut e, &p);
    let sum = e.binary(Binary::Add, p[0], p[1]);
    let root = e.choice(p[0], [trap, sum, sum]);
    let f = Function::new(e, root, 3).unwrap();
    assert_eq!(f.number::<f64>(&[1.0, 2.0, 3.0]), 3.0);
    assert_eq!(f.number::<f64>(&[0.0, 2.0, 3.0]), 2.0);
}

#[test]
fn vectors_are_called_once_for_all_components() {
    let mut e = Expression::default();
    let p = [0, 1, 2].map(|i| e.parameter(i));
    let move_ = Arc::new(Function::from_vector(Arc::new(Transform::translate(Vec3::new(1.0, 2.0, 3.0)))));
    let call = move_.call_in(&mut e, &p);
    let again = move_.call_in(&mut e, &p);
    assert_eq!(call, again);
    let (x, z) = (e.component(call, 0), e.component(call, 2));
    let root = e.binary(Binary::Mul, x, z);
    let f = Function::new(e, root, 3).unwrap();
    assert_eq!(f.call(&[1.0, 1.0, 1.0]), FunctionValue::Float(8.0));
    assert_eq!(move_.call(&[1.0, 1.0, 1.0]), FunctionValue::Vector(3, [2.0, 3.0, 4.0, 0.0, 0.0]));
}

/// Checks a function's slopes in a box against differences between points of it. True if they say anything.
fn check_slopes(f: &Function, sides: &[Interval], fixed: &[f64], dice: &mut Dice) -> bool {
    let mut arguments: Vec<Slope> = sides.iter().enumerate().map(|(i, s)| Slope::coordinate(i, *s)).collect();
    arguments.extend(fixed.iter().map(|&v| Slope::from(v)));
    let found: Slope = f.number(&arguments);
    for _ in 0..20 {
        let axis = dice.below(3) as usize;
        let part = |dice: &mut Dice| f64::from(dice.below(1001)) * 0.001;
        let mut p: Vec<f64> = sides.iter().map(|s| s.lo + (s.hi - s.lo) * part(dice)).collect();
        p.extend(fixed);
        let mut q = p.clone();
        q[axis] = sides[axis].lo + (sides[axis].hi - sides[axis].lo) * part(dice);
        let (a, b, slope): (f64, f64, _) = (f.number(&p), f.number(&q), found.by[axis]);
        assert!(found.value == Interval::WHOLE || found.value.contains(a), "{a} outside {found:?}");
        let length = q[axis] - p[axis];
        if length.abs() < 1e-3 || !a.is_finite() || slope == Interval::WHOLE {
            continue;
        }
        let (steep, noise) = ((b - a) / length, 1e-7 * (1.0 + a.abs().max(b.abs())));
        assert!(
            slope.lo - noise <= steep && steep <= slope.hi + noise,
            "{steep} outside {slope:?} at {p:?} of {f:?}"
        );
    }
    found.by.iter().any(|s| *s != Interval::WHOLE)
}

#[test]
fn slopes_enclose_differences() {
    let mut dice = Dice(Lcg::new(10));
    let mut useful = 0;
    for round in 0..1500 {
        let mut e = Expression::default();
        let root = grow(&mut e, &mut dice, 2 + round % 6, &mut Vec::new());
        let f = Function::new(e.clone(), root, 3).unwrap();
        let center: [f64; 3] = std::array::from_fn(|_| dice.number());
        let radius = [0.01, 0.3, 1.0][round as usize % 3];
        let sides = center.map(|c| Interval::new(c - radius, c + radius));
        useful += u32::from(check_slopes(&f, &sides, &[], &mut dice));
    }
    assert!(useful > 700, "only {useful} slopes say anything");
}

#[test]
fn slopes_of_internal_functions_enclose_differences() {
    let mut dice = Dice(Lcg::new(11));
    let surroundings = Arc::new(Surroundings::default());
    let text = include_str!("../../tests/data/internal-functions-oracle.csv");
    let mut useful = std::collections::BTreeMap::new();
    for line in text.lines().filter(|l| !l.starts_with('#')) {
        let fields: Vec<&str> = line.split(',').collect();
        let arguments: Vec<f64> = fields[2].split(' ').map(|a| a.parse().unwrap()).collect();
        let f = Function::from_internal(Internal::new(fields[0].parse().unwrap(), &surroundings).unwrap());
        for radius in [1e-3, 0.05, 0.5] {
            let sides: Vec<Interval> =
                arguments[..3].iter().map(|&c| Interval::new(c - radius, c + radius)).collect();
            let said = check_slopes(&f, &sides, &arguments[3..], &mut dice);
            *useful.entry(fields[1].to_owned()).or_insert(false) |= said;
        }
    }
    let silent: Vec<_> = useful.iter().filter(|u| !u.1).collect();
    assert!(silent.is_empty(), "{silent:?}");
}
