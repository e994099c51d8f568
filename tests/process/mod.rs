//! The program as a process, in a folder of its own. Each test file uses what it needs of this.
#![allow(dead_code)]

use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

pub const SPHERE: &str = "
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -4> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
sphere { 0, 1 pigment { rgb <1, 0.2, 0.1> } finish { reflection 0.3 } }
";

/// Slow enough to be stopped: half a million pixels of mirrors in mirrors.
pub const SLOW: &str = "
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 40 }
camera { location <0, 0.3, -1.9> look_at 0 }
#declare I = 0;
#while (I < 30)
  light_source { <2*cos(I), 1.5, 2*sin(I)> rgb 0.05 }
  sphere { <cos(I), 0, sin(I)>, 0.4 pigment { rgb 1 } finish { reflection 0.95 } }
  #declare I = I + 1;
#end
sphere { 0, 5 pigment { rgb 1 } finish { reflection 0.95 } }
";

/// A folder of one test, removed at its end.
pub struct Folder(pub PathBuf);

impl Folder {
    pub fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("glint-cli-{test}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, text).unwrap();
        path
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    pub fn glint(&self, args: &[&str]) -> Output {
        self.command(args).output().unwrap()
    }

    pub fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_glint"));
        command.current_dir(&self.0).args(args).stdin(Stdio::null());
        command
    }

    pub fn names(&self) -> Vec<String> {
        let mut names: Vec<_> = std::fs::read_dir(&self.0)
            .unwrap()
            .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

pub fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

pub fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Width, height, and whether there is an alpha channel.
pub fn png_header(bytes: &[u8]) -> (u32, u32, bool, u8) {
    assert!(bytes.starts_with(b"\x89PNG\r\n\x1a\n"), "no PNG");
    let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    (number(16), number(20), bytes[25] == 6, bytes[24])
}

/// The program under the name of POV-Ray, without the user's own INI files.
#[cfg(unix)]
pub fn as_povray(folder: &Folder, args: &[&str]) -> Output {
    let link = folder.path("povray");
    if !link.exists() {
        std::os::unix::fs::symlink(env!("CARGO_BIN_EXE_glint"), &link).unwrap();
    }
    let ini = folder.write("empty.ini", "");
    Command::new(link)
        .current_dir(&folder.0)
        .args(args)
        .env("POVINI", ini)
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

/// A program that a test needs; where it is missing the test says that it is skipped, or fails if the
/// variable is set, as `.ci/run` sets it.
pub fn needed(program: &str, variable: &str) -> bool {
    let there = Command::new(program).arg("--version").output().is_ok_and(|o| o.status.success());
    if !there {
        assert!(std::env::var_os(variable).is_none(), "{program} is needed ({variable} is set)");
        eprintln!("skipped: {program} is not installed");
    }
    there
}

/// Whether POV-Ray is installed.
pub fn povray() -> bool {
    needed("povray", "GLINT_REQUIRE_POVRAY")
}

/// POV-Ray itself, without the user's own INI files.
pub fn reference(folder: &Folder, args: &[&str]) -> Output {
    let ini = folder.write("empty.ini", "");
    let mut command = Command::new("povray");
    command.current_dir(&folder.0).args(args).env("POVINI", ini).env_remove("DISPLAY");
    // Where it looks for permission to read and write, and finds none but the system's.
    command.env("HOME", &folder.0);
    command.stdin(Stdio::null()).output().unwrap()
}
