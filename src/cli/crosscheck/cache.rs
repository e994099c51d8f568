//! POV-Ray's pictures of earlier checks, by the content of everything that they were made of.

use super::povray::Times;
use super::scenes::Scene;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// A folder with a picture (or a message) and times for each key.
pub struct Cache {
    folder: PathBuf,
}

/// What POV-Ray made of a scene.
pub struct Entry {
    /// The picture file, if there is one.
    pub png: Option<Vec<u8>>,
    /// Why there is none.
    pub message: String,
    pub times: Times,
}

impl Cache {
    /// In the folder given, else in the user's cache folder.
    pub fn new(folder: Option<&Path>) -> Self {
        let variable = |name: &str| std::env::var_os(name).filter(|v| !v.is_empty()).map(PathBuf::from);
        let user = || {
            let base = variable("XDG_CACHE_HOME").or_else(|| variable("HOME").map(|h| h.join(".cache")));
            base.unwrap_or_else(std::env::temp_dir).join("glint").join("crosscheck")
        };
        Self { folder: folder.map_or_else(user, Path::to_owned) }
    }

    /// Names the scene's text, all files beside it that it names, and the options.
    pub fn key(&self, scene: &Scene, options: &[String]) -> String {
        let mut hash = Hash::new();
        for option in options {
            hash.add(option.as_bytes());
        }
        let mut seen = HashSet::new();
        add_file(&scene.path, scene.folder(), &mut seen, &mut hash);
        hash.name()
    }

    pub fn get(&self, key: &str) -> Option<Entry> {
        let text = std::fs::read_to_string(self.folder.join(format!("{key}.txt"))).ok()?;
        let mut lines = text.lines();
        let mut time = || lines.next()?.parse::<f64>().ok();
        let times = Times { parse: time(), bounding: time(), trace: time() };
        let message = lines.next().unwrap_or_default().to_owned();
        let png = std::fs::read(self.folder.join(format!("{key}.png"))).ok();
        (png.is_some() || !message.is_empty()).then_some(Entry { png, message, times })
    }

    /// A cache that cannot be written is only slow.
    pub fn put(&self, key: &str, entry: &Entry) {
        let time = |t: Option<f64>| t.map_or("-".into(), |t| t.to_string());
        let t = &entry.times;
        let text = format!("{}\n{}\n{}\n{}\n", time(t.parse), time(t.bounding), time(t.trace), entry.message);
        let write = |extension: &str, bytes: &[u8]| {
            let path = self.folder.join(format!("{key}.{extension}"));
            crate::picture::Output::File(path).write(bytes)
        };
        let _ = std::fs::create_dir_all(&self.folder);
        if entry.png.as_ref().is_none_or(|png| write("png", png).is_ok()) {
            let _ = write("txt", text.as_bytes());
        }
    }
}

/// Adds a file, and every file below `folder` that its text names between quotes.
fn add_file(path: &Path, folder: &Path, seen: &mut HashSet<PathBuf>, hash: &mut Hash) {
    const TEXT: [&str; 5] = ["pov", "inc", "ini", "txt", "mac"];
    let mut open = vec![path.to_owned()];
    while let Some(path) = open.pop() {
        if !seen.insert(path.clone()) {
            continue;
        }
        let Ok(bytes) = std::fs::read(&path) else { continue };
        hash.add(path.file_name().unwrap_or_default().as_encoded_bytes());
        hash.add(&bytes);
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        if TEXT.contains(&extension.as_str()) {
            open.extend(named_files(&bytes, folder));
        }
    }
}

/// Files below `folder` whose names stand between quotes in a text.
fn named_files(text: &[u8], folder: &Path) -> Vec<PathBuf> {
    const MAX_NAME: usize = 200;
    let words = text.split(|&b| b == b'"').skip(1).filter(|w| !w.is_empty() && w.len() <= MAX_NAME);
    let names = words.filter_map(|w| std::str::from_utf8(w).ok());
    names.map(|name| folder.join(name)).filter(|path| path.is_file()).collect()
}

/// FNV-1a in 128 bits: stable over versions and machines, and nobody is to be deceived.
struct Hash(u128);

impl Hash {
    fn new() -> Self {
        Self(0x6c62272e07bb014262b821756295c58d)
    }

    /// Adds bytes with their number, so that neighbours do not run into each other.
    fn add(&mut self, bytes: &[u8]) {
        for b in (bytes.len() as u64).to_le_bytes().iter().chain(bytes) {
            self.0 = (self.0 ^ u128::from(*b)).wrapping_mul(0x0000000001000000000000000000013b);
        }
    }

    fn name(&self) -> String {
        format!("{:032x}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scratch(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("glint-cache-test-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn keys_change_with_everything_that_is_named() {
        let folder = scratch("keys");
        let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
        write("a.pov", "#include \"b.inc\"");
        write("b.inc", "#declare File = \"c.png\";");
        write("c.png", "1");
        let cache = Cache::new(Some(&folder));
        let scene = Scene { name: "a".into(), path: folder.join("a.pov") };
        let options = ["+W160".to_owned()];
        let first = cache.key(&scene, &options);
        assert_eq!(first, cache.key(&scene, &options));
        assert_ne!(first, cache.key(&scene, &["+W161".to_owned()]));
        write("c.png", "2");
        assert_ne!(first, cache.key(&scene, &options));
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn entries_come_back() {
        let folder = scratch("entries");
        let cache = Cache::new(Some(&folder));
        assert!(cache.get("a").is_none());
        let times = Times { parse: Some(0.25), bounding: None, trace: Some(2.0) };
        cache.put("a", &Entry { png: Some(vec![1, 2, 3]), message: String::new(), times });
        cache.put("b", &Entry { png: None, message: "Parse Error: x".into(), times: Times::default() });
        let entry = cache.get("a").unwrap();
        assert_eq!((entry.png, entry.times), (Some(vec![1, 2, 3]), times));
        assert_eq!(cache.get("b").unwrap().message, "Parse Error: x");
        std::fs::remove_dir_all(folder).unwrap();
    }
}
