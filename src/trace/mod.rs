//! A ray through the world to a colour.
