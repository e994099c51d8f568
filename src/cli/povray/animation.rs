//! Frames and their clocks.

use super::settings::Settings;
use crate::cli::exit::Failure;
use crate::interp::Frame;

/// The frames that are asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    /// Each with the digits of its number; empty for a still picture.
    pub frames: Vec<(Frame, String)>,
}

/// More frames than anybody waits for, fewer than fill the memory.
const MAX_FRAMES: i64 = 1_000_000;

impl Animation {
    /// As measured: a picture is still without a first or last frame, or where both are 0 or both are 1.
    pub fn of(settings: &Settings) -> Result<Animation, Failure> {
        let number = |keyword: &str| settings.int(keyword).map(|n| n.max(0));
        let (initial, last) = (number("Initial_Frame"), number("Final_Frame"));
        if matches!((initial.unwrap_or(0), last.unwrap_or(0)), (0, 0) | (1, 1)) {
            return Ok(Animation { frames: vec![(still(settings), String::new())] });
        }
        let first = initial.unwrap_or(1);
        let last = last.unwrap_or(first).max(first);
        let cyclic = settings.flag("Cyclic_Animation", false);
        let end = last + i64::from(cyclic);
        let (low, high) = subset(settings, first, last);
        let step = settings.int("Frame_Step").unwrap_or(1).max(1);
        if high - low > MAX_FRAMES {
            return Err(Failure::usage(format!(
                "frames {low} to {high}: an animation has at most {MAX_FRAMES}"
            )));
        }
        let digits = end.to_string().len();
        let frames = (low..=high).step_by(step as usize);
        let frames = frames.map(|n| (frame(settings, n, first, end), format!("{n:0digits$}")));
        Ok(Animation { frames: frames.collect() })
    }
}

fn still(settings: &Settings) -> Frame {
    let clock = settings.float("Clock").unwrap_or(0.0) as f32;
    Frame { clock, clock_on: settings.float("Clock").is_some(), ..Frame::default() }
}

fn frame(settings: &Settings, number: i64, first: i64, end: i64) -> Frame {
    let initial_clock = settings.float("Initial_Clock").unwrap_or(0.0);
    let final_clock = settings.float("Final_Clock").unwrap_or(1.0);
    let steps = (end - first) as f64;
    let clock_delta = if steps > 0.0 { (final_clock - initial_clock) / steps } else { 0.0 };
    let small = |n: i64| u32::try_from(n).unwrap_or(u32::MAX);
    Frame {
        clock: (initial_clock + clock_delta * (number - first) as f64) as f32,
        clock_on: true,
        number: small(number),
        initial: small(first),
        last: small(end),
        initial_clock,
        final_clock,
        clock_delta,
    }
}

/// The first and the last frame that are rendered; between 0 and 1 a share of the number of frames is meant,
/// whatever the first one's number is. The last one may lie beyond the animation's end: the clock goes on.
fn subset(settings: &Settings, first: i64, last: i64) -> (i64, i64) {
    let share = |v: f64| ((last - first + 1) as f64 * v) as i64;
    let number = |keyword: &str, whole: i64| match settings.float(keyword) {
        None => whole,
        Some(v) if v > 0.0 && v < 1.0 => share(v),
        Some(v) => v as i64,
    };
    let low = number("Subset_Start_Frame", first).max(first);
    (low, number("Subset_End_Frame", last).max(low))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn animation(words: &[(&str, &str)]) -> Vec<(u32, f32, u32, String)> {
        let mut settings = Settings::default();
        for (keyword, value) in words {
            settings.set(keyword, value).unwrap();
        }
        let frames = Animation::of(&settings).unwrap().frames;
        frames.into_iter().map(|(f, digits)| (f.number, f.clock, f.last, digits)).collect()
    }

    #[test]
    fn a_still_picture_has_the_clock_given() {
        assert_eq!(animation(&[("Clock", "0.25")]), [(0, 0.25, 0, String::new())]);
    }

    #[test]
    fn clocks_run_from_end_to_end() {
        let frames =
            animation(&[("Final_Frame", "11"), ("Subset_Start_Frame", "3"), ("Subset_End_Frame", "4")]);
        assert_eq!(frames, [(3, 0.2, 11, "03".to_owned()), (4, 0.3, 11, "04".to_owned())]);
    }

    /// As measured: shares count from 0, also where the first frame has another number.
    #[test]
    fn shares_are_of_the_number_of_frames() {
        let numbers = |words: &[(&str, &str)]| animation(words).iter().map(|f| f.0).collect::<Vec<_>>();
        let half = [("Initial_Frame", "0"), ("Final_Frame", "9"), ("Subset_Start_Frame", "0.5")];
        assert_eq!(numbers(&half), [5, 6, 7, 8, 9]);
        let late = [
            ("Initial_Frame", "5"),
            ("Final_Frame", "14"),
            ("Subset_Start_Frame", "0.5"),
            ("Subset_End_Frame", "0.7"),
        ];
        assert_eq!(numbers(&late), [5, 6, 7]);
        assert_eq!(numbers(&[("Final_Frame", "1")]), [1]);
        assert_eq!(numbers(&[("Initial_Frame", "5")]), [5]);
    }

    /// As measured: a cyclic animation counts one frame more, also in the digits, and does not render it.
    #[test]
    fn cyclic_animations_leave_out_the_last() {
        let frames = animation(&[("Initial_Frame", "0"), ("Final_Frame", "9"), ("Cyclic_Animation", "on")]);
        assert_eq!(frames.len(), 10);
        assert_eq!(frames[8], (8, 0.8, 10, "08".to_owned()));
    }

    /// As measured: what lies outside is moved to the nearest frame, and the end may be passed.
    #[test]
    fn odd_ranges_are_taken_as_the_reference_takes_them() {
        let numbers = |line: &str| {
            let words: Vec<_> = line.split(' ').map(|w| w.split_once('=').unwrap()).collect();
            animation(&words).iter().map(|f| f.0).collect::<Vec<_>>()
        };
        assert_eq!(numbers("Initial_Frame=1 Final_Frame=1"), [0]);
        assert_eq!(numbers("Initial_Frame=0"), [0]);
        assert_eq!(numbers("Initial_Frame=1"), [1]);
        assert_eq!(numbers("Initial_Frame=-2 Final_Frame=1"), [0, 1]);
        assert_eq!(numbers("Initial_Frame=5 Final_Frame=3"), [5]);
        assert_eq!(numbers("Final_Frame=3 Subset_Start_Frame=5"), [5]);
        assert_eq!(numbers("Final_Frame=3 Subset_End_Frame=5"), [1, 2, 3, 4, 5]);
        assert_eq!(numbers("Final_Frame=3 Subset_Start_Frame=3 Subset_End_Frame=2"), [3]);
        assert_eq!(numbers("Final_Frame=4 Subset_Start_Frame=0.6 Subset_End_Frame=1"), [2]);
        assert_eq!(numbers("Final_Frame=4 Subset_End_Frame=0"), [1]);
        assert_eq!(numbers("Final_Frame=5 Frame_Step=2"), [1, 3, 5]);
        let mut endless = Settings::default();
        endless.set("Final_Frame", "1e9").unwrap();
        assert!(Animation::of(&endless).is_err());
    }
}
