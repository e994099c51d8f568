//! Linear pixels, and the files that they go to.
