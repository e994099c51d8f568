//! Grammar that is still being written; each function goes when the real one lands.

use crate::interp::{Parser, Result, Value};

// Functions and splines.
impl Parser {
    pub(crate) fn function_statement(&mut self) -> Result<Value> {
        Err(self.unexpected("something else"))
    }
    pub(crate) fn spline_statement(&mut self) -> Result<Value> {
        Err(self.unexpected("something else"))
    }
    /// The value of a function's or spline's call: `(` comes next, `called` is the identifier's value.
    pub(crate) fn call(&mut self, _called: &Value) -> Result<Value> {
        Err(self.unexpected("something else"))
    }
}
