use std::fmt;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Where a picture goes.
#[derive(Clone, Debug, PartialEq)]
pub enum Output {
    File(PathBuf),
    Stdout,
    /// The picture is only wanted for what is said about it.
    Nowhere,
}

impl Output {
    pub fn path(&self) -> Option<&Path> {
        match self {
            Output::File(path) => Some(path),
            Output::Stdout | Output::Nowhere => None,
        }
    }

    /// Writes a whole file: nobody ever sees half of it.
    pub fn write(&self, bytes: &[u8]) -> Result<(), PictureError> {
        let result = match self {
            Output::File(path) => write_atomically(path, bytes),
            Output::Stdout => {
                let mut out = io::stdout().lock();
                out.write_all(bytes).and_then(|()| out.flush())
            }
            Output::Nowhere => Ok(()),
        };
        result.map_err(|error| PictureError::Io { place: self.to_string(), error })
    }
}

impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Output::File(path) => path.display().fmt(f),
            Output::Stdout => f.write_str("-"),
            Output::Nowhere => f.write_str("(no file)"),
        }
    }
}

/// What can go wrong between a picture and a file.
#[derive(Debug)]
pub enum PictureError {
    Io { place: String, error: io::Error },
    Format { place: String, message: String },
}

impl fmt::Display for PictureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PictureError::Io { place, error } => write!(f, "{place}: {error}"),
            PictureError::Format { place, message } => write!(f, "{place}: {message}"),
        }
    }
}

impl std::error::Error for PictureError {}

/// Writes a neighbour under a temporary name and renames it. Devices and pipes are written in place.
fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let special = std::fs::metadata(path).is_ok_and(|m| !m.is_file());
    if special {
        return std::fs::write(path, bytes);
    }
    let temporary = temporary_name(path);
    let result = std::fs::write(&temporary, bytes).and_then(|()| std::fs::rename(&temporary, path));
    if result.is_err() {
        let _ = std::fs::remove_file(&temporary);
    }
    result
}

fn temporary_name(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.{}.part", std::process::id()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_as_a_whole() {
        let folder = std::env::temp_dir().join(format!("glint-file-test-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join("a.png");
        Output::File(path.clone()).write(b"first").unwrap();
        Output::File(path.clone()).write(b"second").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"second");
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1, "no temporary file stays");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn the_error_names_the_place() {
        let out = Output::File("/nonexistent/folder/a.png".into());
        let error = out.write(b"x").unwrap_err().to_string();
        assert!(error.starts_with("/nonexistent/folder/a.png: "), "{error}");
    }
}
