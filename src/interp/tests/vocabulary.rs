//! The lists of fitting words are exactly the words that the grammar takes.

use super::outcome;
use crate::interp::vocabulary::*;
use crate::syntax::{Keyword, SPELLINGS};
use std::collections::BTreeSet;

/// Each block with the texts behind which its items stand.
const BLOCKS: &[(&Items, &[&str])] = &[
    (&FINISH, &["sphere { 0, 1 finish {"]),
    (&REFLECTION, &["sphere { 0, 1 finish { reflection { 1"]),
    (
        &PIGMENT,
        &["sphere { 0, 1 pigment {", "sphere { 0, 1 pigment { bozo", "sphere { 0, 1 pigment { mandel 9"],
    ),
    (
        &DENSITY,
        &["sphere { 0, 1 interior { media { density {", "sphere { 0, 1 interior { media { density { bozo"],
    ),
    (&NORMAL, &["sphere { 0, 1 normal {", "sphere { 0, 1 normal { bozo", "sphere { 0, 1 normal { mandel 9"]),
    (
        &TEXTURE,
        &["sphere { 0, 1 texture {", "sphere { 0, 1 texture { bozo texture_map { [0 pigment { rgb 1 }] }"],
    ),
    (&INTERIOR, &["sphere { 0, 1 interior {"]),
    (&MATERIAL, &["sphere { 0, 1 material {"]),
    (&MEDIA, &["sphere { 0, 1 interior { media {"]),
    (
        &LIGHT,
        &[
            "light_source { 0, 1",
            "light_source { 0, 1 spotlight",
            "light_source { 0, 1 area_light x, y, 2, 2",
        ],
    ),
    (&OBJECT, &["sphere { 0, 1", "mesh { triangle { x, y, z }"]),
    (&CAMERA, &["camera {", "camera { perspective"]),
    (&FOG, &["fog {"]),
    (&RAINBOW, &["rainbow {"]),
    (&IMAGE_MAP, &["plane { y, 0 pigment { image_map { iff \"a\""]),
    (&BUMP_MAP, &["plane { y, 0 normal { bump_map { iff \"a\""]),
    (&IMAGE_PATTERN, &["plane { y, 0 pigment { image_pattern { iff \"a\""]),
    (&GLOBAL_SETTINGS, &["global_settings {"]),
    (&RADIOSITY, &["global_settings { radiosity {"]),
    (&PHOTONS, &["global_settings { photons {"]),
    (&SUBSURFACE, &["global_settings { subsurface {"]),
    (&IMAGE_TYPES, &["plane { y, 0 pigment { image_map {"]),
    (&STATEMENTS, &[""]),
];

/// Whether the reader goes past `word`: it may miss something behind it, but does not complain of the word.
fn is_taken(before: &str, word: &str, keyword: Keyword) -> bool {
    let text = format!("{before} {word} ");
    match outcome(&text).scene {
        Ok(_) => true,
        Err(error) => {
            let place = error.span.map_or(0, |span| span.start as usize);
            let named = error.message.contains(&format!("`{}`", keyword.text()));
            place > before.len() + 1 || place == before.len() + 1 && !named
        }
    }
}

#[test]
fn lists_hold_the_words_that_fit() {
    let taken = |texts: &[&str]| -> BTreeSet<&str> {
        let is_taken = |(word, keyword)| texts.iter().any(|before| is_taken(before, word, keyword));
        SPELLINGS.iter().filter(|&&spelling| is_taken(spelling)).map(|(word, _)| *word).collect()
    };
    let begins_value = taken(&["#declare A = 1 +", "#debug"]);
    let mut wrong = Vec::new();
    for (items, texts) in BLOCKS {
        let listed: BTreeSet<&str> = items.words.split_whitespace().collect();
        let is_item = |word: &&str| !begins_value.contains(word) || listed.contains(word);
        let found: BTreeSet<&str> = taken(texts).into_iter().filter(is_item).collect();
        if found != listed {
            wrong.push(format!("{}: {}", items.noun, found.into_iter().collect::<Vec<_>>().join(" ")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// An unknown word is answered with the nearest one that fits.
#[test]
fn misspelt_words_are_answered() {
    for (text, expected, near) in [
        ("sphere { 0, 1 finish { refletion 1 } }", "a finish item or `}`", "reflection"),
        ("sphere { 0, 1 pigment { chekcer rgb 1, rgb 0 } }", "a pigment item or `}`", "checker"),
        ("plane { y, 0 normal { bmps 1 } }", "a normal item or `}`", "bumps"),
        ("plane { y, 0 pigment { image_map { pgn \"x\" } } }", "an image's type or its file name", "png"),
        ("light_source { 0, 1 spotlite }", "a light source item or `}`", "spotlight"),
        ("global_settings { asumed_gama 1 }", "a setting of `global_settings` or `}`", "assumed_gamma"),
        ("#declare Red = rgb x; sphere { 0, 1 pigment { color Redd } }", "a color", "Red"),
        ("#declare Red = rgb x; sphere { 0, 1 pigment { Redd } }", "a pigment item or `}`", "Red"),
        ("lightsource { 0, 1 }", "an object or a directive", "light_source"),
    ] {
        let Err(error) = outcome(text).scene else { panic!("no error: {text}") };
        assert!(
            error.message.starts_with(&format!("expected {expected}, found")),
            "{text}: {}",
            error.message
        );
        assert_eq!(error.hint, Some(format!("did you mean `{near}`?")), "{text}");
    }
}
