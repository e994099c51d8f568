//! Standard include files that Glint carries with it, for when none are installed.
//!
//! Names, values and meanings are those of the reference manual; the text is ours. Files of design (textures,
//! woods, stones, metals, golds, glass, skies, stars) are not here: they come with POV-Ray's own package.

/// The text of the embedded include file of that name, compared as the file system would (case matters).
pub fn lookup(name: &str) -> Option<&'static str> {
    FILES.binary_search_by_key(&name, |&(known, _)| known).ok().map(|at| FILES[at].1)
}

/// Names of all embedded files, in alphabetical order.
pub fn names() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|&(name, _)| name)
}

/// Sorted by name.
const FILES: &[(&str, &str)] = &[
    ("arrays.inc", include_str!("arrays.inc")),
    ("colors.inc", include_str!("colors.inc")),
    ("consts.inc", include_str!("consts.inc")),
    ("debug.inc", include_str!("debug.inc")),
    ("finish.inc", include_str!("finish.inc")),
    ("functions.inc", include_str!("functions.inc")),
    ("ior.inc", include_str!("ior.inc")),
    ("math.inc", include_str!("math.inc")),
    ("meshmaker.inc", include_str!("meshmaker.inc")),
    ("rad_def.inc", include_str!("rad_def.inc")),
    ("rand.inc", include_str!("rand.inc")),
    ("screen.inc", include_str!("screen.inc")),
    ("shapes.inc", include_str!("shapes.inc")),
    ("shapes2.inc", include_str!("shapes2.inc")),
    ("shapes3.inc", include_str!("shapes3.inc")),
    ("shapes_old.inc", include_str!("shapes_old.inc")),
    ("shapesq.inc", include_str!("shapesq.inc")),
    ("stdinc.inc", include_str!("stdinc.inc")),
    ("strings.inc", include_str!("strings.inc")),
    ("sunpos.inc", include_str!("sunpos.inc")),
    ("transforms.inc", include_str!("transforms.inc")),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_sorted_and_found() {
        assert!(FILES.windows(2).all(|pair| pair[0].0 < pair[1].0));
        for name in names() {
            assert!(lookup(name).is_some_and(|text| text.contains("Part of Glint")), "{name}");
        }
    }

    #[test]
    fn design_files_are_not_carried() {
        for name in
            ["textures.inc", "woods.inc", "stones.inc", "metals.inc", "golds.inc", "glass.inc", "skies.inc"]
        {
            assert!(lookup(name).is_none(), "{name}");
        }
        assert!(lookup("Colors.inc").is_none(), "case matters");
    }

    /// A file that sets the language version must put back what it found.
    #[test]
    fn the_version_is_restored() {
        for (name, text) in FILES.iter().filter(|(name, _)| *name != "debug.inc") {
            let set = text.lines().filter(|line| line.starts_with("#version")).count();
            assert_eq!(set, 2, "{name}");
        }
    }
}
