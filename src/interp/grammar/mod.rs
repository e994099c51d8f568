//! One file per area of the language, one function per production.
