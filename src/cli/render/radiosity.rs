//! Files that keep the samples of radiosity from one picture to the next.

use crate::cli::exit::Failure;
use crate::trace::{Sample, radiosity_file};
use std::path::PathBuf;
use std::sync::Arc;

#[derive(Clone, Debug, Default)]
pub struct RadiosityFiles {
    pub load: Option<PathBuf>,
    pub save: Option<PathBuf>,
}

impl RadiosityFiles {
    /// What is known before the picture begins: nothing if the file is not there.
    pub fn read(&self) -> Result<Arc<Vec<Sample>>, Failure> {
        let Some(path) = &self.load else { return Ok(Arc::default()) };
        let refused = |why: String| Failure::unavailable(format!("{}: {why}", path.display()));
        let bytes = match std::fs::read(path) {
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(Arc::default()),
            read => read.map_err(|e| refused(e.to_string()))?,
        };
        let samples = radiosity_file::read(&bytes);
        samples.map(Arc::new).map_err(|line| refused(format!("line {line} is no sample of radiosity")))
    }

    pub fn write(&self, samples: &[Sample]) -> Result<(), Failure> {
        let Some(path) = &self.save else { return Ok(()) };
        std::fs::write(path, radiosity_file::written(samples))
            .map_err(|e| Failure::unavailable(format!("cannot write {}: {e}", path.display())))
    }
}
