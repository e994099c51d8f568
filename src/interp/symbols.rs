//! Which identifier means what: a stack of tables, found through a stack of bindings per name.

use super::macros::Macro;
use super::value::Value;
use crate::syntax::{Interner, Symbol};
use std::rc::Rc;
use std::sync::Arc;

/// What a name is bound to.
#[derive(Clone, Debug)]
pub(super) enum Binding {
    Value(Value),
    Macro(Rc<Macro>),
    /// An open text file, by number.
    File(usize),
    /// A macro parameter that stands for a variable of the caller.
    Reference(Box<Reference>),
}

/// A variable, or an element of one.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Reference {
    pub symbol: Symbol,
    /// The table that holds it.
    pub scope: u32,
    /// Element numbers, one per level of arrays within arrays.
    pub path: Vec<usize>,
}

#[derive(Debug)]
struct Entry {
    scope: u32,
    binding: Binding,
}

#[derive(Debug)]
pub(super) struct Symbols {
    /// For each symbol its bindings, innermost last; at most one per table.
    slots: Vec<Vec<Entry>>,
    /// For each table above the global one its symbols.
    scopes: Vec<Vec<Symbol>>,
}

/// The table of global symbols.
pub(super) const GLOBAL: u32 = 0;

impl Symbols {
    pub fn new() -> Self {
        Self { slots: Vec::new(), scopes: Vec::new() }
    }

    /// A name that no text can spell; it stands for an array element already looked up.
    pub const ELEMENT: Symbol = Interner::NAMELESS;

    /// How many tables are open above the global one.
    pub fn depth(&self) -> usize {
        self.scopes.len()
    }

    /// The number of the innermost table.
    pub fn innermost(&self) -> u32 {
        self.scopes.len() as u32
    }

    pub fn enter(&mut self) {
        self.scopes.push(Vec::new());
    }

    pub fn leave(&mut self) {
        let scope = self.innermost();
        for symbol in self.scopes.pop().unwrap_or_default() {
            let slot = &mut self.slots[symbol.0 as usize];
            if slot.last().is_some_and(|e| e.scope == scope) {
                slot.pop();
            }
        }
    }

    /// What the innermost table that knows the name binds it to.
    pub fn binding(&self, symbol: Symbol) -> Option<&Binding> {
        self.slots.get(symbol.0 as usize)?.last().map(|e| &e.binding)
    }

    /// The value of a variable, or of the variable that a parameter stands for.
    pub fn value(&self, symbol: Symbol) -> Option<&Value> {
        match self.binding(symbol)? {
            Binding::Value(value) => Some(value),
            Binding::Reference(reference) => self.target(reference),
            Binding::Macro(_) | Binding::File(_) => None,
        }
    }

    /// The variable's own place, if it is a plain number of its own.
    pub fn float_mut(&mut self, symbol: Symbol) -> Option<&mut f64> {
        match &mut self.slots.get_mut(symbol.0 as usize)?.last_mut()?.binding {
            Binding::Value(Value::Float(v)) => Some(v),
            _ => None,
        }
    }

    /// The value of a number variable.
    #[inline]
    pub fn float(&self, symbol: Symbol) -> Option<f64> {
        match &self.slots.get(symbol.0 as usize)?.last()?.binding {
            Binding::Value(Value::Float(v)) => Some(*v),
            Binding::Reference(reference) => match self.target(reference) {
                Some(Value::Float(v)) => Some(*v),
                _ => None,
            },
            _ => None,
        }
    }

    /// Whether a name is a number variable that an assignment would overwrite. `local`: one of the innermost
    /// table.
    #[inline]
    pub fn is_plain_float(&self, symbol: Symbol, local: bool) -> bool {
        match self.slots.get(symbol.0 as usize).and_then(|slot| slot.last()) {
            Some(Entry { scope, binding: Binding::Value(Value::Float(_)) }) => {
                !local || *scope == self.innermost()
            }
            _ => false,
        }
    }

    /// Overwrites a number variable; false if it is none.
    #[inline]
    pub fn set_float(&mut self, symbol: Symbol, value: f64) -> bool {
        match self.float_mut(symbol) {
            Some(place) => {
                *place = value;
                true
            }
            None => false,
        }
    }

    #[inline]
    pub fn is_macro(&self, symbol: Symbol) -> bool {
        matches!(self.binding(symbol), Some(Binding::Macro(_)))
    }

    pub fn target(&self, reference: &Reference) -> Option<&Value> {
        let slot = self.slots.get(reference.symbol.0 as usize)?;
        let entry = slot.iter().rev().find(|e| e.scope == reference.scope)?;
        let Binding::Value(first) = &entry.binding else { return None };
        let mut value = first;
        for &index in &reference.path {
            let Value::Array(array) = value else { return None };
            value = array.elements.get(index)?.as_ref()?;
        }
        Some(value)
    }

    /// The variable that a name stands for now.
    pub fn reference(&self, symbol: Symbol) -> Option<Reference> {
        let entry = self.slots.get(symbol.0 as usize)?.last()?;
        match &entry.binding {
            Binding::Reference(reference) => Some((**reference).clone()),
            _ => Some(Reference { symbol, scope: entry.scope, path: Vec::new() }),
        }
    }

    /// The place of a variable or element, to be assigned a value of that many arrays within each other. An element
    /// that is not set is `None` inside.
    pub fn place(&mut self, reference: &Reference, arrays: u32) -> Option<Place<'_>> {
        let slot = self.slots.get_mut(reference.symbol.0 as usize)?;
        let entry = slot.iter_mut().rev().find(|e| e.scope == reference.scope)?;
        let Some((last, outer)) = reference.path.split_last() else {
            return Some(Place::Variable(&mut entry.binding));
        };
        let Binding::Value(first) = &mut entry.binding else { return None };
        let mut value = first;
        let mut depth = arrays + reference.path.len() as u32;
        for &index in outer {
            let Value::Array(array) = value else { return None };
            let array = Arc::make_mut(array);
            array.depth = array.depth.max(depth);
            depth -= 1;
            value = array.elements.get_mut(index)?.as_mut()?;
        }
        let Value::Array(array) = value else { return None };
        let array = Arc::make_mut(array);
        array.depth = array.depth.max(depth);
        Some(Place::Element { kind: &mut array.kind, element: array.elements.get_mut(*last)? })
    }

    /// Binds a name in one table, replacing what that table had.
    pub fn bind(&mut self, symbol: Symbol, scope: u32, binding: Binding) {
        let index = symbol.0 as usize;
        if index >= self.slots.len() {
            self.slots.resize_with(index + index / 2 + 64, Vec::new);
        }
        let slot = &mut self.slots[index];
        match slot.binary_search_by_key(&scope, |e| e.scope) {
            Ok(at) => slot[at].binding = binding,
            Err(at) => {
                slot.insert(at, Entry { scope, binding });
                if scope > GLOBAL {
                    self.scopes[scope as usize - 1].push(symbol);
                }
            }
        }
    }

    pub fn bind_innermost(&mut self, symbol: Symbol, binding: Binding) {
        self.bind(symbol, self.innermost(), binding);
    }

    /// Whether the innermost table itself knows the name.
    pub fn is_local(&self, symbol: Symbol) -> bool {
        self.slots.get(symbol.0 as usize).and_then(|s| s.last()).is_some_and(|e| e.scope == self.innermost())
    }

    /// Removes a name from one table; false if it was not there.
    pub fn remove(&mut self, symbol: Symbol, scope: u32) -> bool {
        let Some(slot) = self.slots.get_mut(symbol.0 as usize) else { return false };
        let Ok(at) = slot.binary_search_by_key(&scope, |e| e.scope) else { return false };
        slot.remove(at);
        if scope > GLOBAL {
            self.scopes[scope as usize - 1].retain(|s| *s != symbol);
        }
        true
    }

    /// Removes a name from the innermost table that has it; false if none has.
    pub fn remove_innermost(&mut self, symbol: Symbol) -> bool {
        match self.slots.get(symbol.0 as usize).and_then(|slot| slot.last()) {
            Some(entry) => self.remove(symbol, entry.scope),
            None => false,
        }
    }

    /// Every name with a meaning now.
    pub fn names(&self) -> impl Iterator<Item = Symbol> + '_ {
        let bound = |(index, slot): (usize, &Vec<Entry>)| (!slot.is_empty()).then_some(Symbol(index as u32));
        self.slots.iter().enumerate().filter_map(bound).filter(|s| *s != Self::ELEMENT)
    }
}

/// Where an assignment goes.
pub(super) enum Place<'a> {
    Variable(&'a mut Binding),
    Element {
        /// What the array's elements are, once one is set.
        kind: &'a mut Option<&'static str>,
        element: &'a mut Option<Value>,
    },
}
