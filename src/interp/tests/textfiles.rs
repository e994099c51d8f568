use super::super::options::{Options, SceneSource};
use super::super::{Outcome, interpret};
use std::path::PathBuf;

/// A folder of its own with a scene that stands in it.
pub(super) struct Folder(PathBuf);

impl Folder {
    pub(super) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("glint-textfiles-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    pub(super) fn run(&self, text: &str) -> Outcome {
        let scene = self.0.join("scene.pov");
        std::fs::write(&scene, text).unwrap();
        interpret(SceneSource::Path(scene), &Options { start_version: Some(370), ..Options::default() })
    }

    pub(super) fn path(&self, name: &str) -> String {
        self.0.join(name).display().to_string()
    }

    /// What a loop that reads one number at a time prints for a file of that text.
    fn read(&self, data: &str) -> String {
        std::fs::write(self.0.join("data.txt"), data).unwrap();
        let text =
            "#fopen H \"data.txt\" read #while(defined(H)) #read(H,A) #debug concat(str(A,0,0),\";\") #end";
        self.run(text).debug
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn items_are_written_as_the_language_prints_them() {
    let folder = Folder::new("write");
    let text = format!(
        "#fopen H \"{}\" write #write(H, 1/3, \",\", <1,2,3>, 1e10, \"\\n\", -0.00001, \" \", <1,2>) #fclose H",
        folder.path("out.txt")
    );
    assert!(folder.run(&text).scene.is_ok());
    let written = std::fs::read_to_string(folder.path("out.txt")).unwrap();
    assert_eq!(written, "0.333333,<1,2,3> 1e+10\n-1e-05 <1,2> ");
    let text = format!("#fopen H \"{}\" append #write(H, \"end\")", folder.path("out.txt"));
    assert!(folder.run(&text).scene.is_ok());
    assert!(std::fs::read_to_string(folder.path("out.txt")).unwrap().ends_with("> end"));
}

#[test]
fn binary_numbers_are_clamped_and_rounded() {
    let folder = Folder::new("binary");
    let text = format!(
        "#fopen H \"{}\" write #write(H, sint8 300 (-300) 1.5, uint16be <1,2,70000>, sint32le -2, 7 \"a\" uint8 66, 67)",
        folder.path("out.bin")
    );
    assert!(folder.run(&text).scene.is_ok());
    let expected = [127, 128, 2, 0, 1, 0, 2, 255, 255, 254, 255, 255, 255, b'7', b'a', b'B', b'6', b'7'];
    assert_eq!(std::fs::read(folder.path("out.bin")).unwrap(), expected);
}

#[test]
fn the_file_closes_with_its_last_item() {
    let folder = Folder::new("read");
    assert_eq!(folder.read("1,2"), "1;2;");
    assert_eq!(folder.read("1,2\n\n // end\n"), "1;2;");
    // A comma at the end hides the end of the file from the read before it.
    assert_eq!(folder.read("1,2,\n"), "1;2;2;");
    // What stands in the place of a comma is lost.
    assert_eq!(folder.read("1,2,\n3 4 5"), "1;2;3;5;");
}

#[test]
fn items_may_be_vectors_and_strings() {
    let folder = Folder::new("kinds");
    std::fs::write(folder.path("data.txt"), "\"a\\n\", <1,-2,3>, -7.5, <1,2>").unwrap();
    let outcome = folder.run(
        "#fopen H \"data.txt\" read #read(H,A,B,C,D,E) #debug concat(A,vstr(3,B,\",\",0,0),str(C,0,1),str(D.v,0,0)) \
         #ifdef (E) #debug \"E\" #end #ifdef (H) #debug \"H\" #end",
    );
    assert_eq!(outcome.debug, "a\n1,-2,3-7.52");
}

#[test]
fn files_elsewhere_are_refused() {
    let folder = Folder::new("elsewhere");
    for text in
        ["#fopen H \"/etc/hosts\" read", "#fopen H \"/tmp/../etc/x\" write", "#fopen H \"../../x.txt\" write"]
    {
        let error = folder.run(text).scene.unwrap_err();
        assert!(error.message.contains("lies outside"), "{text}: {}", error.message);
    }
}

#[test]
fn includes_are_found_beside_the_scene_with_a_warning() {
    let folder = Folder::new("include");
    std::fs::write(folder.path("Part.inc"), "#local L=1; #declare G=2; #debug \"part\"").unwrap();
    let outcome = folder.run("#include \"part\" #ifdef (L) #debug \"L\" #end #debug str(G,0,0)");
    assert_eq!(outcome.debug, "part2");
    assert!(outcome.warnings.iter().any(|w| w.message.contains("capitals")));
    std::fs::write(folder.path("loop.inc"), "#include \"loop.inc\"").unwrap();
    assert!(folder.run("#include \"loop.inc\"").scene.unwrap_err().message.contains("32 files"));
    std::fs::write(folder.path("open.inc"), "#if (1)").unwrap();
    assert!(folder.run("#include \"open.inc\" #end").scene.unwrap_err().message.contains("no `#end`"));
}
