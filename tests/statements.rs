//! Hundreds of small scenes, each one odd but short, beside what POV-Ray makes of them.

mod process;

use process::*;

const TABLE: &str = include_str!("data/statements.txt");

/// Places in the picture, as the table lists them.
const PLACES: [(u32, u32); 4] = [(8, 6), (0, 0), (5, 8), (10, 4)];

fn scene(text: &str) -> String {
    let line_end = if text.contains("#debug") { " #debug \"\\n\"" } else { "" };
    let text = text.replace("@V", "#version 3.7; global_settings{assumed_gamma 1} ");
    let text = text.replace("@O", "camera{location -5*z look_at 0} light_source{<-3,4,-6> 1} ");
    text.replace("@S", "sphere{0,1 pigment{rgb <1,.5,.2>}}") + line_end + "\n"
}

/// What is not as the row says, if anything.
fn difference(folder: &Folder, row: &str) -> Option<String> {
    let [sign, pixels, printed, text] = row.split('\t').collect::<Vec<_>>()[..] else {
        return Some("a row has four fields".to_owned());
    };
    folder.write("s.pov", &scene(text));
    let images = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/images");
    let done = folder.glint(&[
        "render",
        "s.pov",
        "-W",
        "16",
        "-H",
        "12",
        "-o",
        "s.png",
        "-L",
        images,
        "--threads",
        "1",
    ]);
    let accepted = code(&done) == Some(0);
    if accepted != matches!(sign, "+" | "r" | "~") {
        return Some(format!("accepted: {accepted}: {}", stderr(&done).lines().next().unwrap_or_default()));
    }
    if sign != "+" {
        return None;
    }
    let said = stderr(&done).split_whitespace().collect::<Vec<_>>().join(" ");
    if !said.starts_with(printed) {
        return Some(format!("prints {said}"));
    }
    let picture = image::open(folder.path("s.png")).unwrap().to_rgb8();
    let found = PLACES.map(|(x, y)| picture.get_pixel(x, y).0);
    let near = pixels.split(' ').zip(found).all(|(expected, found)| {
        let expected = expected.split('/').map(|v| v.parse::<i32>().unwrap());
        expected.zip(found).all(|(e, f)| (e - i32::from(f)).abs() <= 2)
    });
    (!near).then(|| format!("has the pixels {found:?}"))
}

#[test]
fn statements_mean_what_they_mean_to_the_reference() {
    let rows: Vec<_> = TABLE.lines().filter(|l| !l.starts_with('#')).collect();
    assert!(rows.len() > 500, "{}", rows.len());
    let half = |odd: usize| {
        let folder = Folder::new(&format!("statements-{odd}"));
        let mine = rows.iter().skip(odd).step_by(2);
        let wrong = mine.filter_map(|row| Some(format!("{row}\n  {}", difference(&folder, row)?)));
        wrong.collect::<Vec<_>>()
    };
    let wrong = std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        [half(0), other.join().unwrap()].concat()
    });
    assert!(wrong.is_empty(), "{} rows\n{}", wrong.len(), wrong.join("\n"));
}
