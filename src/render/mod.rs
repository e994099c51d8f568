//! The world to a picture.
