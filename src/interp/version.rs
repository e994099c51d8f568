//! The two version numbers that the text's meaning depends on.

/// Times 100, as the language counts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Version {
    declared: Option<u32>,
    /// Whether the text did it, and not an option.
    by_text: bool,
    /// Whether an option asks for the rules of today.
    modern_option: bool,
}

/// From this version on a scene that says no `assumed_gamma` has one.
const GAMMA: u32 = 370;

/// What a scene that declares nothing is read as.
const SYNTAX: u32 = 370;
/// What a scene that declares nothing is rendered as.
const EFFECTIVE: u32 = 362;

impl Version {
    pub fn new(declared: Option<u32>) -> Self {
        Self { declared, by_text: false, modern_option: declared.is_some_and(|option| option >= GAMMA) }
    }

    pub fn set(&mut self, version: u32) {
        self.declared = Some(version);
        self.by_text = true;
    }

    pub fn is_declared(&self) -> bool {
        self.declared.is_some()
    }

    pub fn syntax(&self) -> u32 {
        self.declared.unwrap_or(SYNTAX)
    }

    /// As measured: an option's version does not say how images are read.
    pub fn for_images(&self) -> u32 {
        if self.by_text { self.effective() } else { EFFECTIVE }
    }

    pub fn effective(&self) -> u32 {
        self.declared.unwrap_or(EFFECTIVE)
    }

    /// Whether colours are linear light where the scene says no `assumed_gamma`: as measured, an option decides that
    /// for all of the text.
    pub fn has_gamma(&self) -> bool {
        self.modern_option || self.effective() >= GAMMA
    }
}
