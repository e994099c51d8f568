//! What lies outside of a scene's folders is neither read nor written, and no message quotes it.

mod process;

use process::*;
use std::process::Output;

const SECRET: &str = "#declare Secret = 42 secretword";

/// Folders `own` with the scene and `other` with what is not its business; the work is done in `own`.
fn stage(name: &str) -> Folder {
    let folder = Folder::new(name);
    for sub in ["own/below", "other"] {
        std::fs::create_dir_all(folder.path(sub)).unwrap();
    }
    folder.write("other/secret.inc", SECRET);
    folder.write("other/harmless.inc", "sphere { 0, 1 }\n");
    folder.write("own/below/harmless.inc", "sphere { 0, 1 }\n");
    folder
}

fn check(folder: &Folder, text: &str, options: &[&str]) -> Output {
    folder.write("own/s.pov", &format!("#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n{text}\n"));
    let mut words = vec!["check"];
    words.extend(options);
    words.push("s.pov");
    folder.command(&words).current_dir(folder.path("own")).output().unwrap()
}

fn refused(folder: &Folder, text: &str, options: &[&str]) {
    let done = check(folder, text, options);
    let said = stderr(&done);
    assert_eq!(code(&done), Some(1), "{text}: {said}");
    assert!(said.contains("lies outside the folders that a scene may"), "{text}: {said}");
    assert!(!said.contains("secretword") && !stdout(&done).contains("secretword"), "{text}: {said}");
}

fn accepted(folder: &Folder, text: &str, options: &[&str]) -> Output {
    let done = check(folder, text, options);
    assert_eq!(code(&done), Some(0), "{text} {options:?}: {}", stderr(&done));
    done
}

#[test]
fn files_elsewhere_are_not_read() {
    let folder = stage("folders-read");
    let elsewhere = folder.path("other/secret.inc").display().to_string();
    for text in [
        "#include \"../other/secret.inc\"".to_owned(),
        "#include \"../other/secret\"".to_owned(),
        "#include \"below/../../other/secret.inc\"".to_owned(),
        "#include \"..\\other\\secret.inc\"".to_owned(),
        "#include \"../OTHER/Secret.inc\"".to_owned(),
        format!("#include \"{elsewhere}\""),
        "#fopen F \"../other/secret.inc\" read #read(F, A)".to_owned(),
        "sphere { 0, 1 pigment { image_map { png \"../other/secret.inc\" } } }".to_owned(),
        "height_field { pgm \"../other/secret.inc\" }".to_owned(),
        "mesh { obj \"../other/secret.inc\" }".to_owned(),
        "text { ttf \"../other/secret.inc\", \"a\", 1, 0 }".to_owned(),
        "media { density { density_file df3 \"../other/secret.inc\" } }".to_owned(),
        "global_settings { photons { load_file \"../other/secret.inc\" } }".to_owned(),
    ] {
        refused(&folder, &text, &[]);
    }
    let exists = "#if (file_exists(\"../other/secret.inc\")) #error \"seen\" #end";
    accepted(&folder, exists, &[]);
    accepted(&folder, "#include \"below/harmless.inc\"", &[]);
}

#[test]
fn options_open_further_folders() {
    let folder = stage("folders-options");
    let text = "#include \"../other/harmless.inc\"";
    refused(&folder, text, &[]);
    accepted(&folder, text, &["--allow-read", "../other"]);
    accepted(&folder, text, &["--allow-read=../other"]);
    accepted(&folder, text, &["--allow-write", "../other"]);
    accepted(&folder, text, &["-L", "../other"]);
    refused(&folder, text, &["--allow-read", "below"]);
    let done = check(&folder, text, &["--allow-read", "none"]);
    assert_eq!(code(&done), Some(3));
    assert!(stderr(&done).contains("--allow-read none: there is no such folder"));
}

#[test]
fn only_named_folders_are_written() {
    let folder = stage("folders-write");
    let text = "#fopen F \"../other/out.txt\" write #write(F, \"text\") #fclose F";
    refused(&folder, text, &[]);
    refused(&folder, text, &["--allow-read", "../other", "-L", "../other"]);
    assert!(!folder.path("other/out.txt").exists());
    accepted(&folder, text, &["--allow-write", "../other"]);
    assert_eq!(std::fs::read_to_string(folder.path("other/out.txt")).unwrap(), "text");
    accepted(&folder, &text.replace("../other", "below"), &[]);
    let append = text.replace("write #", "append #");
    refused(&folder, &append, &[]);
    refused(&folder, "global_settings { photons { count 10 save_file \"../other/p.ph\" } }", &[]);
}

#[cfg(unix)]
#[test]
fn links_lead_nowhere() {
    use std::os::unix::fs::symlink;
    let folder = stage("folders-links");
    symlink(folder.path("other/secret.inc"), folder.path("own/link.inc")).unwrap();
    symlink(folder.path("other"), folder.path("own/elsewhere")).unwrap();
    symlink(folder.path("other/new.txt"), folder.path("own/new.txt")).unwrap();
    refused(&folder, "#include \"link.inc\"", &[]);
    refused(&folder, "#include \"elsewhere/secret.inc\"", &[]);
    for name in ["link.inc", "new.txt", "elsewhere/new.txt"] {
        refused(&folder, &format!("#fopen F \"{name}\" write"), &[]);
    }
    assert_eq!(std::fs::read_to_string(folder.path("other/secret.inc")).unwrap(), SECRET);
    assert!(!folder.path("other/new.txt").exists());
    // The folder that the user names may be a link.
    accepted(&folder, "#include \"elsewhere/harmless.inc\"", &["-L", "elsewhere"]);
}

#[test]
fn pov_rays_command_line_has_the_same_folders() {
    let folder = stage("folders-pov");
    let scene =
        "#version 3.7; #include \"../other/harmless.inc\"\n#fopen F \"../other/o.txt\" write #write(F, 1)";
    folder.write("own/s.pov", scene);
    let run = |options: &[&str]| {
        let mut words = vec!["pov", "+Is.pov", "+W4", "+H3", "-D", "+Oo.png"];
        words.extend(options);
        let mut command = folder.command(&words);
        command.current_dir(folder.path("own")).env("POVINI", folder.path("none")).env("HOME", &folder.0);
        command.output().unwrap()
    };
    for (options, exit) in [
        (&[][..], 1),
        (&["+L../other"], 1),
        (&["--allow-read=../other"], 1),
        (&["--allow-write=../other"], 0),
        (&["--allow-write=none"], 3),
    ] {
        let done = run(options);
        assert_eq!(code(&done), Some(exit), "{options:?}: {}", stderr(&done));
    }
}

/// Writing to a pipe would wait for a reader for ever.
#[test]
#[cfg(unix)]
fn only_plain_files_are_written() {
    let folder = stage("plain");
    let made = std::process::Command::new("mkfifo").arg(folder.path("own/pipe")).status().unwrap();
    assert!(made.success());
    for how in ["write", "append"] {
        let done = check(&folder, &format!("#fopen F \"pipe\" {how}"), &[]);
        assert_eq!(code(&done), Some(1));
        assert!(stderr(&done).contains("cannot open `pipe`: it is no plain file"), "{}", stderr(&done));
    }
}
