//! The two version numbers that the text's meaning depends on.

/// Times 100, as the language counts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Version {
    declared: Option<u32>,
}

/// What a scene that declares nothing is read as.
const SYNTAX: u32 = 370;
/// What a scene that declares nothing is rendered as.
const EFFECTIVE: u32 = 362;

impl Version {
    pub fn new(declared: Option<u32>) -> Self {
        Self { declared }
    }

    pub fn set(&mut self, version: u32) {
        self.declared = Some(version);
    }

    pub fn is_declared(&self) -> bool {
        self.declared.is_some()
    }

    pub fn syntax(&self) -> u32 {
        self.declared.unwrap_or(SYNTAX)
    }

    pub fn effective(&self) -> u32 {
        self.declared.unwrap_or(EFFECTIVE)
    }
}
