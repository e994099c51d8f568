//! One file per area of the language, one function per production.

mod csg;
mod modifiers;
mod object;
mod pending;
mod regions;
mod shapes;
