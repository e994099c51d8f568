//! Expressions as a list of instructions on a file of registers, for numbers and for ranges alike.

use super::external::Callee;
use super::number::{Binary, Number, Unary};
use super::patience;
use smallvec::SmallVec;

/// What an instruction does. Frequent operations have codes of their own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Code {
    /// The immediate number.
    Constant,
    Move,
    Neg,
    Abs,
    Square,
    Sqrt,
    Unary(Unary),
    /// `a` to an immediate whole power.
    Power,
    Add,
    Sub,
    Mul,
    Div,
    Min,
    Max,
    Binary(Binary),
    AddConstant,
    MulConstant,
    /// The immediate number minus `a`.
    SubFrom,
    /// One of three by the sign of `a`; all have been computed and stand in a list of registers.
    Choose,
    /// Goes on if `a` is negative, else jumps to the first target (0) or the second (positive).
    Branch,
    /// To the first target.
    Jump,
    /// Jumps to the first target unless `a` <= `b`.
    Until,
    /// Adds 1 to `a`, in place, and jumps to the first target.
    Next,
    /// A callee with a list of registers for arguments, then results.
    Call,
}

impl Code {
    /// How many of `a` and `b` are read.
    pub(super) fn reads(self) -> usize {
        match self {
            Code::Constant | Code::Jump | Code::Call => 0,
            Code::Add | Code::Sub | Code::Mul | Code::Div | Code::Min | Code::Max => 2,
            Code::Binary(_) | Code::Until => 2,
            _ => 1,
        }
    }

    /// Whether `to` is written.
    pub(super) fn writes(self) -> bool {
        !matches!(self, Code::Branch | Code::Jump | Code::Until | Code::Next | Code::Call)
    }
}

/// One instruction. `R` is a register: a virtual one while a program is built, then a real one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Op<R> {
    pub code: Code,
    pub to: R,
    pub a: R,
    pub b: R,
    /// A number, a whole power, two targets, or where lists are: as the code has it.
    pub immediate: u64,
}

impl<R> Op<R> {
    fn number(&self) -> f64 {
        f64::from_bits(self.immediate)
    }

    /// The first and the second target of a jump.
    pub fn targets(&self) -> [usize; 2] {
        [self.immediate as u32 as usize, (self.immediate >> 32) as usize]
    }
}

/// Where a call finds what it needs.
#[derive(Clone, Copy, Debug)]
pub(super) struct CallSite {
    pub list: u32,
    pub callee: u16,
    pub arguments: u8,
    pub results: u8,
}

impl CallSite {
    pub fn pack(self) -> u64 {
        u64::from(self.list)
            | u64::from(self.callee) << 32
            | u64::from(self.arguments) << 48
            | u64::from(self.results) << 56
    }

    pub fn unpack(bits: u64) -> Self {
        Self {
            list: bits as u32,
            callee: (bits >> 32) as u16,
            arguments: (bits >> 48) as u8,
            results: (bits >> 56) as u8,
        }
    }
}

/// What stands in the list of a call's results for a component that nobody asks for.
pub(super) const UNUSED: u16 = u16::MAX;

/// Most registers that a program may use.
pub(super) const LARGEST_FILE: usize = 1024;

/// A compiled expression. Evaluation allocates nothing.
#[derive(Clone, Debug)]
pub(super) struct Program {
    pub code: Vec<Op<u16>>,
    pub lists: Vec<u16>,
    pub callees: Vec<Callee>,
    pub registers: usize,
    pub result: u16,
}

impl Program {
    /// The value for these arguments, as many as the function has parameters.
    #[inline]
    pub fn run<N: Number>(&self, arguments: &[N]) -> N {
        match self.registers {
            0..=8 => self.run_in::<N, 8>(arguments),
            9..=32 => self.run_in::<N, 32>(arguments),
            33..=128 => self.run_in::<N, 128>(arguments),
            _ => self.run_in::<N, LARGEST_FILE>(arguments),
        }
    }

    /// With `F` registers, a power of 2: reducing a register's number by it costs less than a check.
    fn run_in<N: Number, const F: usize>(&self, arguments: &[N]) -> N {
        let mut file = [N::from(0.0); F];
        file[..arguments.len()].copy_from_slice(arguments);
        let mut next = 0;
        while let Some(op) = self.code.get(next) {
            next += 1;
            let (a, b) = (file[usize::from(op.a) & (F - 1)], file[usize::from(op.b) & (F - 1)]);
            let value = match op.code {
                Code::Constant => N::from(op.number()),
                Code::Move => a,
                Code::Neg => -a,
                Code::Abs => a.abs(),
                Code::Square => a.square(),
                Code::Sqrt => a.sqrt(),
                Code::Unary(f) => a.unary(f),
                Code::Power => a.powi(op.immediate as i32),
                Code::Add => a + b,
                Code::Sub => a - b,
                Code::Mul => a * b,
                Code::Div => a / b,
                Code::Min => a.min(b),
                Code::Max => a.max(b),
                Code::Binary(f) => a.binary(f, b),
                Code::AddConstant => a + op.number(),
                Code::MulConstant => a * op.number(),
                Code::SubFrom => N::from(op.number()) - a,
                Code::Choose => {
                    let list = &self.lists[op.immediate as usize..];
                    let branch = |i: usize| file[usize::from(list[i]) & (F - 1)];
                    a.choose(branch(0), branch(1), branch(2))
                }
                Code::Next => {
                    if !patience::step() {
                        return N::UNKNOWN;
                    }
                    next = op.targets()[0];
                    a + 1.0
                }
                Code::Jump => {
                    next = op.targets()[0];
                    continue;
                }
                Code::Branch => {
                    match a.known() {
                        Some(v) if v < 0.0 => {}
                        Some(v) => next = op.targets()[usize::from(v != 0.0)],
                        None => return N::UNKNOWN,
                    }
                    continue;
                }
                Code::Until => {
                    match (a.known(), b.known()) {
                        (Some(counter), Some(limit)) if counter <= limit => {}
                        (Some(_), Some(_)) => next = op.targets()[0],
                        _ => return N::UNKNOWN,
                    }
                    continue;
                }
                Code::Call => {
                    if !patience::step() {
                        return N::UNKNOWN;
                    }
                    self.call(CallSite::unpack(op.immediate), &mut file);
                    continue;
                }
            };
            file[usize::from(op.to) & (F - 1)] = value;
        }
        file[usize::from(self.result) & (F - 1)]
    }

    #[inline]
    fn call<N: Number, const F: usize>(&self, site: CallSite, file: &mut [N; F]) {
        let list = &self.lists[site.list as usize..];
        let (given, wanted) = list.split_at(usize::from(site.arguments));
        let wanted = &wanted[..usize::from(site.results)];
        let at = |i: u16| file[usize::from(i) & (F - 1)];
        let callee = &self.callees[usize::from(site.callee)];
        match *given {
            // Most calls are about a point.
            [x, y, z] => give(callee, &[at(x), at(y), at(z)], wanted, file),
            _ if given.len() <= 8 => {
                let mut few = [N::from(0.0); 8];
                few.iter_mut().zip(given).for_each(|(to, &g)| *to = at(g));
                give(callee, &few[..given.len()], wanted, file);
            }
            _ => {
                let many: SmallVec<[N; 16]> = given.iter().map(|&g| at(g)).collect();
                give(callee, &many, wanted, file);
            }
        }
    }
}

/// Puts what a call gives into the registers that want it.
#[inline]
fn give<N: Number, const F: usize>(callee: &Callee, arguments: &[N], wanted: &[u16], file: &mut [N; F]) {
    if let [to] = *wanted {
        let value = callee.number(arguments);
        if to != UNUSED {
            file[usize::from(to) & (F - 1)] = value;
        }
        return;
    }
    for (&to, value) in wanted.iter().zip(callee.values(arguments)) {
        if to != UNUSED {
            file[usize::from(to) & (F - 1)] = value;
        }
    }
}
