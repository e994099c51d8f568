//! What is printed where POV-Ray's command line asks for help or the version.

const HELP: &str = "\
Glint reads POV-Ray 3.7's command line here: switches (+W320 -A), keywords (Width=320) and INI files.

  +Iname  scene          +Oname  picture (- for standard output)   +W +H  size
  +A[t]   anti-aliasing  +AM1 +AM2 method, +Rn depth, +J[a] jitter +Qn    quality
  +F[x]   N PNG, T C Targa, P PPM, B BMP, J JPEG, E OpenEXR, H HDR; +FN16 16 bits, +FNg grey
  +UA     alpha          +SC +EC +SR +ER  part of the picture      +WTn   threads
  +Ldir   library        +HIname header   Declare=name=number      +MVn   version
  +Kc     clock          +KFIn +KFFn frames, +KIc +KFc clocks, +KC cyclic, +SFn +EFn subset
  +C      (or --resume) skips the frames of an animation that are there already
  --allow-read=DIR, --allow-write=DIR   folders that scenes may use besides their own and libraries

  name.ini, name[section] read options from a file.

Glint's own command line: glint --help
";

/// The text to print, if one of the words asks for it.
pub fn asked_for(words: &[String]) -> Option<String> {
    let is = |names: &[&str]| words.iter().any(|w| names.contains(&w.as_str()));
    if words.is_empty() || is(&["--help", "-help", "-h", "-?", "+?", "--h"]) {
        return Some(HELP.to_owned());
    }
    let version = || format!("Glint {} (POV-Ray 3.7's command line)\n", env!("CARGO_PKG_VERSION"));
    is(&["--version", "-version", "--V"]).then(version)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn help_and_version_are_asked_for_in_several_ways() {
        let asked = |line: &str| asked_for(&line.split_whitespace().map(String::from).collect::<Vec<_>>());
        assert!(asked("").unwrap().contains("+KFIn"));
        assert!(asked("a.pov -help").is_some());
        assert!(asked("-version").unwrap().starts_with("Glint "));
        assert_eq!(asked("a.pov -V -H8"), None);
    }
}
