//! POV-Ray's switches in Glint's words, for advice.

/// The command line with every word of POV-Ray's syntax replaced by Glint's for the same.
pub fn to_glint(words: &[String]) -> String {
    let known = words.first().is_some_and(|w| super::COMMANDS.contains(&w.as_str()));
    let command =
        if known { vec!["glint".to_owned()] } else { vec!["glint".to_owned(), "render".to_owned()] };
    command.into_iter().chain(words.iter().filter_map(|w| word(w))).collect::<Vec<_>>().join(" ")
}

/// One word; `None` if Glint needs nothing for it.
fn word(word: &str) -> Option<String> {
    let Some(switch) = word.strip_prefix('+') else {
        if word.to_ascii_lowercase().ends_with(".ini") {
            return None;
        }
        return Some(word.to_owned());
    };
    let split = switch.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(switch.len());
    // Switches whose parameter is a name run into it: the first letter is the switch.
    let (letters, value) = match switch.chars().next().map(|c| c.to_ascii_uppercase()) {
        Some('I' | 'O' | 'L') => switch.split_at(1),
        _ => switch.split_at(split),
    };
    translated(&letters.to_ascii_uppercase(), value)
}

fn translated(letters: &str, value: &str) -> Option<String> {
    match letters {
        "I" => Some(value.to_owned()),
        "O" => Some(format!("-o {value}")),
        "W" => Some(format!("-W {value}")),
        "H" => Some(format!("-H {value}")),
        "L" => Some(format!("-L {value}")),
        "A" if value.is_empty() => Some("-A".to_owned()),
        "A" => Some(format!("-A={value}")),
        "AM" => Some(format!("--aa-method {value}")),
        "R" => Some(format!("--aa-depth {value}")),
        "J" => Some("--jitter on".to_owned()),
        "Q" => Some(format!("--quality {value}")),
        "UA" => Some("--alpha".to_owned()),
        "FN" if value == "16" => Some("--bits 16".to_owned()),
        "WT" => Some(format!("--threads {value}")),
        "K" => Some(format!("--clock {value}")),
        _ => None,
    }
}
