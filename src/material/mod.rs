//! What a surface looks like, and what is inside it: values that answer at a point.

mod finish;
mod ingredients;
mod interior;
mod normal;
mod pigment;
mod texture;

pub use finish::{Finish, Reflection};
pub use ingredients::Ingredients;
pub use interior::{Interior, Media};
pub use normal::{Normal, NormalKind};
pub use pigment::{GreyPigment, Pigment, PigmentField, PigmentKind, PigmentMap, Rough};
pub use texture::{Attached, Layer, PatternedKind, PatternedTexture, Texture, TextureSample, View};
