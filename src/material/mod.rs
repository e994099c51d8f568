//! What a surface looks like, and what is inside it: values that answer at a point.

mod finish;
mod interior;
mod texture;

pub use finish::{Finish, Reflection};
pub use interior::{Interior, Media};
pub use texture::{Attached, Layer, Normal, Pigment, Texture, TextureSample};
