use super::{Result, Value};
use crate::camera::Camera;
use crate::color::{Color, Rgb};
use crate::material::Layer;
use crate::math::{Transform, Vec2, Vec3};
use crate::scene::Scene;
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Symbol, Token};

/// The grammar's view of the text: tokens with directives carried out and macros expanded.
pub struct Parser {
    /// The scene so far, and the defaults in force.
    pub(crate) scene: SceneBuilder,
}

/// What statements add to while the text is read.
pub(crate) struct SceneBuilder {
    pub scene: Scene,
    /// The default texture: one layer.
    pub default_layer: Layer,
    pub default_camera: Camera,
    /// Whether `assumed_gamma` was given.
    pub gamma_given: bool,
    /// Whether `noise_generator` was given.
    pub noise_given: bool,
}

impl Parser {
    /// The next token, left in place.
    pub fn peek(&mut self) -> Result<Token> {
        todo!()
    }

    /// Takes the next token.
    pub fn next(&mut self) -> Result<Token> {
        todo!()
    }

    /// Takes the next token if it is `word`.
    pub fn accept(&mut self, _word: Keyword) -> Result<bool> {
        todo!()
    }

    pub fn accept_punct(&mut self, _punct: Punct) -> Result<bool> {
        todo!()
    }

    pub fn expect(&mut self, _word: Keyword) -> Result<Token> {
        todo!()
    }

    pub fn expect_punct(&mut self, _punct: Punct) -> Result<Token> {
        todo!()
    }

    /// Takes a comma if one comes: between list items they are optional.
    pub fn comma(&mut self) -> Result<()> {
        todo!()
    }

    /// A number, at the additive level (no comparison outside parentheses).
    pub fn float(&mut self) -> Result<f64> {
        todo!()
    }

    /// A 3-vector; a number is replicated, 2 components are padded with 0.
    pub fn vector(&mut self) -> Result<Vec3> {
        todo!()
    }

    pub fn vector2(&mut self) -> Result<Vec2> {
        todo!()
    }

    pub fn vector4(&mut self) -> Result<[f64; 4]> {
        todo!()
    }

    /// A full comparison-level number as in `#if (…)` and map keys.
    pub fn condition(&mut self) -> Result<f64> {
        todo!()
    }

    /// Any expression value: a float, a vector, a colour or a string.
    pub fn expression(&mut self) -> Result<Value> {
        todo!()
    }

    /// A colour item (`rgb …`, `color …`, `Id filter 0.5`, a bare vector …).
    pub fn color(&mut self) -> Result<Color> {
        todo!()
    }

    /// A colour where filter and transmit mean nothing: a number is replicated to red, green and blue.
    pub fn rgb(&mut self) -> Result<Rgb> {
        todo!()
    }

    /// Whether the next token can begin a colour or numeric expression.
    pub fn at_expression(&mut self) -> Result<bool> {
        todo!()
    }

    /// A string expression.
    pub fn string(&mut self) -> Result<String> {
        todo!()
    }

    /// A string naming a file: literals keep their backslashes.
    pub fn file_name(&mut self) -> Result<String> {
        todo!()
    }

    /// The optional number of a boolean option: absent means on, on iff it is above 0.
    pub fn flag(&mut self) -> Result<bool> {
        todo!()
    }

    /// A transformation (`translate`, `rotate`, `scale`, `matrix`, `transform …`) if one comes.
    pub fn transformation(&mut self) -> Result<Option<Transform>> {
        todo!()
    }

    /// The value of the identifier that comes next (array elements resolved), left in place; `None` if no
    /// declared identifier comes.
    pub fn peek_value(&mut self) -> Result<Option<Value>> {
        todo!()
    }

    /// Takes the identifier (with its array subscripts) whose value `peek_value` showed.
    pub fn take_value(&mut self) -> Result<Value> {
        todo!()
    }

    /// The spelling of an identifier.
    pub fn name(&self, _symbol: Symbol) -> &str {
        todo!()
    }

    /// The error for a token that does not fit: "expected {expected}", with a did-you-mean for
    /// undeclared names.
    pub fn unexpected(&mut self, _expected: &str) -> Box<Diagnostic> {
        todo!()
    }

    pub fn warn(&mut self, _diagnostic: Diagnostic) {
        todo!()
    }

    /// Notes a known feature that is not rendered yet: one warning, one entry in `unsupported`.
    pub fn unsupported(&mut self, _span: Span, _feature: &str) {
        todo!()
    }

    /// Syntax version times 100 (`V` in the language's rules), 370 until declared otherwise.
    pub fn syntax_version(&self) -> u32 {
        todo!()
    }

    /// Effective version times 100 (`E`), 362 until declared.
    pub fn effective_version(&self) -> u32 {
        todo!()
    }
}
