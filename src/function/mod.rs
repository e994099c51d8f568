//! User functions: expressions compiled to a compact program and evaluated at points.
