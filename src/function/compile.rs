//! Expression to program.
//!
//! First straight code on virtual registers, one per value, in which equal subexpressions are computed once
//! wherever the first computation surely ran ([`Emitter`]). Then each virtual register gets a real one for
//! the span between its first write and its last read ([`assign`]).
//!
//! Reference: M. Poletto and V. Sarkar, "Linear scan register allocation", 1999.

use super::expr::{Expression, Node, Term};
use super::number::{Binary, Unary};
use super::program::{CallSite, Code, LARGEST_FILE, Op, Program, UNUSED};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

/// How `select` is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Choices {
    /// Only the chosen branch is evaluated.
    Jumps,
    /// All branches are evaluated: with ranges, several may be meant.
    All,
}

type Virtual = u32;

/// `None` if the expression keeps more intermediate values than there are registers.
pub(super) fn compile(expression: &Expression, arity: usize, choices: Choices) -> Option<Program> {
    let root = expression.root?;
    // Sharing within and across branches keeps a program as short as its expression, but every shared value
    // holds a register.
    let attempts = [(choices, true), (Choices::All, true), (Choices::All, false)];
    attempts.into_iter().find_map(|(choices, share)| {
        let mut emitter = Emitter::new(expression, arity, choices, share);
        emitter.run(root)?;
        assign(emitter, arity)
    })
}

/// How many times longer than its expression a program may be: what branches have in common is repeated in
/// each of them.
const LARGEST_GROWTH: usize = 16;

/// What is left to do, last first.
enum Task {
    Evaluate(Node),
    /// The operands are on the stack.
    Combine(Node),
    /// The test of a `select` is on the stack.
    Branch(Node),
    /// The value of a branch is on the stack.
    Join(Join),
    /// Both ends of a loop are on the stack.
    Enter(Node),
    /// The value of a loop's body is on the stack.
    Repeat(Repeat),
}

#[derive(Clone, Copy)]
struct Join {
    node: Node,
    /// Where the branching instruction is.
    branch: usize,
    /// 0 negative, 1 zero, 2 positive.
    number: usize,
    to: Virtual,
    scope: usize,
}

#[derive(Clone, Copy)]
struct Repeat {
    node: Node,
    counter: Virtual,
    total: Virtual,
    test: usize,
    scope: usize,
}

struct Emitter<'e> {
    expression: &'e Expression,
    choices: Choices,
    /// Whether values are kept for later use. Without it fewer registers are needed.
    share: bool,
    code: Vec<Op<Virtual>>,
    lists: Vec<Virtual>,
    tasks: Vec<Task>,
    /// Values of operands, as in a stack machine.
    stack: Vec<Virtual>,
    /// Values that surely have been computed when the code about to be emitted runs.
    held: HashMap<Node, Virtual>,
    /// The nodes in `held`, in the order of their coming.
    order: Vec<Node>,
    counters: HashMap<u32, Virtual>,
    /// First and last instruction of each loop, inner before outer.
    loops: Vec<[usize; 2]>,
    registers: Virtual,
}

impl<'e> Emitter<'e> {
    fn new(expression: &'e Expression, arity: usize, choices: Choices, share: bool) -> Self {
        Self {
            expression,
            choices,
            share,
            code: Vec::new(),
            lists: Vec::new(),
            tasks: Vec::new(),
            stack: Vec::new(),
            held: HashMap::new(),
            order: Vec::new(),
            counters: HashMap::new(),
            loops: Vec::new(),
            registers: arity as Virtual,
        }
    }

    /// `None` if the program becomes too long.
    fn run(&mut self, root: Node) -> Option<()> {
        let limit = LARGEST_GROWTH * (self.expression.terms.len() + 64);
        self.tasks.push(Task::Evaluate(root));
        while let Some(task) = self.tasks.pop() {
            match task {
                Task::Evaluate(node) => self.evaluate(node),
                Task::Combine(node) => self.combine(node),
                Task::Branch(node) => self.branch(node),
                Task::Join(join) => self.join(join),
                Task::Enter(node) => self.enter(node),
                Task::Repeat(repeat) => self.repeat(repeat),
            }
            if self.code.len() > limit {
                return None;
            }
        }
        Some(())
    }

    fn term(&self, node: Node) -> &'e Term {
        &self.expression.terms[node.index()]
    }

    fn evaluate(&mut self, node: Node) {
        if let Some(&register) = self.held.get(&node) {
            self.stack.push(register);
            return;
        }
        match self.term(node) {
            Term::Parameter(index) => self.stack.push(*index),
            Term::Counter(number) => self.stack.push(self.counters[number]),
            Term::Choice(test, branches) if self.needs_jumps(branches) => {
                self.tasks.extend([Task::Branch(node), Task::Evaluate(*test)]);
            }
            Term::Loop { from, to, .. } => {
                self.tasks.extend([Task::Enter(node), Task::Evaluate(*to), Task::Evaluate(*from)]);
            }
            Term::Binary(f, a, b) if self.immediate(*f, *a, *b).is_some() => {
                let variable = if self.expression.value(*b).is_some() { *a } else { *b };
                self.tasks.extend([Task::Combine(node), Task::Evaluate(variable)]);
            }
            term => {
                self.tasks.push(Task::Combine(node));
                self.tasks.extend(term.operands().into_iter().rev().map(Task::Evaluate));
            }
        }
    }

    /// Whether some branch is worth leaving out.
    fn needs_jumps(&self, branches: &[Node; 3]) -> bool {
        let is_work = |b: &Node| !matches!(self.term(*b), Term::Constant(_) | Term::Parameter(_));
        self.choices == Choices::Jumps && branches.iter().any(is_work)
    }

    /// The form with an immediate number of an operation with one constant operand.
    fn immediate(&self, f: Binary, a: Node, b: Node) -> Option<(Code, u64)> {
        let code = match (f, self.expression.value(a), self.expression.value(b)) {
            (Binary::Add, Some(k), None) | (Binary::Add, None, Some(k)) => (Code::AddConstant, k),
            (Binary::Mul, Some(k), None) | (Binary::Mul, None, Some(k)) => (Code::MulConstant, k),
            (Binary::Sub, Some(k), None) => (Code::SubFrom, k),
            _ => return None,
        };
        Some((code.0, code.1.to_bits()))
    }

    fn combine(&mut self, node: Node) {
        let term = self.term(node);
        let to = match term {
            Term::Call { callee, arguments } => self.call(*callee, arguments.len()),
            // The components of a call have successive registers.
            Term::Component(_, index) => self.pop() + Virtual::from(*index),
            _ => self.operation(term),
        };
        self.keep(node, to);
    }

    fn operation(&mut self, term: &Term) -> Virtual {
        let (code, mut immediate) = match term {
            Term::Constant(bits) => (Code::Constant, *bits),
            Term::Unary(f, _) => (unary(*f), 0),
            Term::Power(_, n) => (Code::Power, *n as u64),
            Term::Binary(f, a, b) => self.immediate(*f, *a, *b).unwrap_or((binary(*f), 0)),
            _ => (Code::Choose, 0),
        };
        if code == Code::Choose {
            immediate = self.lists.len() as u64;
            let branches = self.stack.split_off(self.stack.len() - 3);
            self.lists.extend(branches);
        }
        let b = if code.reads() == 2 { self.pop() } else { 0 };
        let a = if code.reads() >= 1 { self.pop() } else { 0 };
        let to = self.fresh();
        self.code.push(Op { code, to, a, b, immediate });
        to
    }

    /// The first of the registers of the call's results.
    fn call(&mut self, callee: u32, arguments: usize) -> Virtual {
        let results = self.expression.callees[callee as usize].results();
        let first = self.registers;
        self.registers += results as Virtual;
        let list = self.lists.len() as u32;
        let given = self.stack.split_off(self.stack.len() - arguments);
        self.lists.extend(given);
        self.lists.extend(first..self.registers);
        let site =
            CallSite { list, callee: callee as u16, arguments: arguments as u8, results: results as u8 };
        self.code.push(Op { code: Code::Call, to: 0, a: 0, b: 0, immediate: site.pack() });
        first
    }

    fn branch(&mut self, node: Node) {
        let Term::Choice(_, [negative, zero, positive]) = self.term(node) else { return };
        let test = self.pop();
        let to = self.fresh();
        let branch = self.code.len();
        self.code.push(Op { code: Code::Branch, to: 0, a: test, b: 0, immediate: 0 });
        let join = |number| Task::Join(Join { node, branch, number, to, scope: self.order.len() });
        let (first, middle, last) = (join(0), join(1), join(2));
        self.tasks.extend([last, Task::Evaluate(*positive)]);
        if zero != positive {
            self.tasks.extend([middle, Task::Evaluate(*zero)]);
        }
        self.tasks.extend([first, Task::Evaluate(*negative)]);
    }

    fn join(&mut self, join: Join) {
        let Term::Choice(_, [_, zero, positive]) = self.term(join.node) else { return };
        let a = self.pop();
        self.code.push(Op { code: Code::Move, to: join.to, a, b: 0, immediate: 0 });
        self.forget(join.scope);
        let [mut at_zero, mut at_positive] = self.code[join.branch].targets();
        if join.number == 2 {
            // The instruction before each branch's first is the jump that ends the branch before it.
            let end = self.code.len() as u64;
            self.code[at_zero - 1].immediate = end;
            self.code[at_positive - 1].immediate = end;
            self.keep(join.node, join.to);
            return;
        }
        self.code.push(Op { code: Code::Jump, to: 0, a: 0, b: 0, immediate: 0 });
        if join.number == 0 {
            at_zero = self.code.len();
        }
        if join.number == 1 || zero == positive {
            at_positive = self.code.len();
        }
        self.code[join.branch].immediate = at_zero as u64 | (at_positive as u64) << 32;
    }

    fn enter(&mut self, node: Node) {
        let Term::Loop { product, counter: number, body, .. } = self.term(node) else { return };
        let (limit, from) = (self.pop(), self.pop());
        let (counter, total) = (self.fresh(), self.fresh());
        let start = f64::from(u8::from(*product)).to_bits();
        self.code.push(Op { code: Code::Move, to: counter, a: from, b: 0, immediate: 0 });
        self.code.push(Op { code: Code::Constant, to: total, a: 0, b: 0, immediate: start });
        let test = self.code.len();
        self.code.push(Op { code: Code::Until, to: 0, a: counter, b: limit, immediate: 0 });
        self.counters.insert(*number, counter);
        let repeat = Repeat { node, counter, total, test, scope: self.order.len() };
        self.tasks.extend([Task::Repeat(repeat), Task::Evaluate(*body)]);
    }

    fn repeat(&mut self, r: Repeat) {
        let Term::Loop { product, .. } = self.term(r.node) else { return };
        let b = self.pop();
        let code = if *product { Code::Mul } else { Code::Add };
        self.code.push(Op { code, to: r.total, a: r.total, b, immediate: 0 });
        self.code.push(Op { code: Code::Next, to: r.counter, a: r.counter, b: 0, immediate: r.test as u64 });
        self.code[r.test].immediate = self.code.len() as u64;
        self.loops.push([r.test, self.code.len() - 1]);
        self.forget(r.scope);
        self.keep(r.node, r.total);
    }

    fn fresh(&mut self) -> Virtual {
        self.registers += 1;
        self.registers - 1
    }

    fn pop(&mut self) -> Virtual {
        self.stack.pop().expect("every operand was evaluated")
    }

    fn keep(&mut self, node: Node, register: Virtual) {
        self.stack.push(register);
        if self.share {
            self.held.insert(node, register);
            self.order.push(node);
        }
    }

    /// Forgets what was computed since `scope`: the code that follows may not have run it.
    fn forget(&mut self, scope: usize) {
        for node in self.order.drain(scope..) {
            self.held.remove(&node);
        }
    }
}

fn unary(f: Unary) -> Code {
    match f {
        Unary::Neg => Code::Neg,
        Unary::Abs => Code::Abs,
        Unary::Square => Code::Square,
        Unary::Sqrt => Code::Sqrt,
        f => Code::Unary(f),
    }
}

fn binary(f: Binary) -> Code {
    match f {
        Binary::Add => Code::Add,
        Binary::Sub => Code::Sub,
        Binary::Mul => Code::Mul,
        Binary::Div => Code::Div,
        Binary::Min => Code::Min,
        Binary::Max => Code::Max,
        f => Code::Binary(f),
    }
}

/// Gives virtual registers real ones.
fn assign(emitter: Emitter, arity: usize) -> Option<Program> {
    let Emitter { expression, code, mut lists, stack, loops, registers, .. } = emitter;
    let result = *stack.last()?;
    if expression.callees.len() > usize::from(u16::MAX) {
        return None;
    }
    let last_reads = last_reads(&code, &lists, &loops, registers, result);
    let mut file = Registers::new(arity, last_reads);
    let mut assigned = Vec::with_capacity(code.len());
    for (at, op) in code.iter().enumerate() {
        let (inputs, outputs) = listed(op);
        let [a, b] = [(op.a, 1), (op.b, 2)]
            .map(|(r, count)| if op.code.reads() >= count { file.real[r as usize] } else { 0 });
        for i in inputs {
            lists[i] = Virtual::from(file.real[lists[i] as usize]);
        }
        file.release(at);
        for i in outputs {
            lists[i] = Virtual::from(file.take(lists[i])?);
        }
        let writes = op.code.writes() || op.code == Code::Next;
        let to = if writes { file.take(op.to)? } else { 0 };
        assigned.push(Op { code: op.code, to, a, b, immediate: op.immediate });
    }
    Some(Program {
        code: assigned,
        lists: lists.into_iter().map(|r| r as u16).collect(),
        callees: expression.callees.clone(),
        registers: file.count,
        result: file.real[result as usize],
    })
}

/// Where in the lists an instruction's further inputs and outputs are.
fn listed<R>(op: &Op<R>) -> (std::ops::Range<usize>, std::ops::Range<usize>) {
    match op.code {
        Code::Choose => {
            let list = op.immediate as usize;
            (list..list + 3, 0..0)
        }
        Code::Call => {
            let site = CallSite::unpack(op.immediate);
            let inputs = site.list as usize;
            let outputs = inputs + usize::from(site.arguments);
            (inputs..outputs, outputs..outputs + usize::from(site.results))
        }
        _ => (0..0, 0..0),
    }
}

/// The last instruction that reads each register; `None` for those that nothing reads.
fn last_reads(
    code: &[Op<Virtual>],
    lists: &[Virtual],
    loops: &[[usize; 2]],
    registers: Virtual,
    result: Virtual,
) -> Vec<Option<usize>> {
    let mut first = vec![None; registers as usize];
    let mut last = vec![None; registers as usize];
    let read_by = |op: &Op<Virtual>| -> Vec<Virtual> {
        let direct = [op.a, op.b].into_iter().take(op.code.reads());
        direct.chain(lists[listed(op).0].iter().copied()).collect()
    };
    for (at, op) in code.iter().enumerate() {
        for r in read_by(op) {
            last[r as usize] = Some(at);
        }
        let written = op.code.writes().then_some(op.to);
        for r in written.into_iter().chain(lists[listed(op).1].iter().copied()) {
            first[r as usize].get_or_insert(at);
        }
    }
    // What a loop reads and does not make itself must last until its end.
    for &[start, end] in loops {
        for r in code[start..=end].iter().flat_map(read_by) {
            let made_before = first[r as usize].is_none_or(|f| f < start);
            if made_before && last[r as usize].is_some_and(|l| l < end) {
                last[r as usize] = Some(end);
            }
        }
    }
    last[result as usize] = Some(code.len());
    // Whatever an instruction writes needs a place.
    for (at, op) in code.iter().enumerate().filter(|(_, op)| op.code.writes()) {
        last[op.to as usize].get_or_insert(at + 1);
    }
    last
}

struct Registers {
    real: Vec<u16>,
    /// Whether anything reads the register.
    wanted: Vec<bool>,
    /// Registers by their last reads, the latest first.
    ends: Vec<(usize, Virtual)>,
    free: BinaryHeap<Reverse<u16>>,
    count: usize,
}

impl Registers {
    fn new(arity: usize, last_reads: Vec<Option<usize>>) -> Self {
        let mut real = vec![UNUSED; last_reads.len()];
        real.iter_mut().zip(0..arity).for_each(|(r, i)| *r = i as u16);
        let free = (0..arity).filter(|&i| last_reads[i].is_none()).map(|i| Reverse(i as u16)).collect();
        let ends = last_reads.iter().enumerate().filter_map(|(r, last)| Some(((*last)?, r as Virtual)));
        let mut ends: Vec<_> = ends.collect();
        ends.sort_unstable_by(|a, b| b.cmp(a));
        Self { real, wanted: last_reads.iter().map(Option::is_some).collect(), ends, free, count: arity }
    }

    /// The real register for a value about to be written; `None` if none is left.
    fn take(&mut self, register: Virtual) -> Option<u16> {
        let register = register as usize;
        if self.wanted[register] && self.real[register] == UNUSED {
            let free = self.free.pop().map(|r| r.0).or_else(|| {
                self.count += 1;
                (self.count <= LARGEST_FILE).then_some(self.count as u16 - 1)
            });
            self.real[register] = free?;
        }
        Some(self.real[register])
    }

    /// Frees the registers that are read by instruction `at` for the last time.
    fn release(&mut self, at: usize) {
        while let Some(&(last, register)) = self.ends.last()
            && last <= at
        {
            self.ends.pop();
            self.free.push(Reverse(self.real[register as usize]));
        }
    }
}
