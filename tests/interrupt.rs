//! Ctrl-C, as a signal to a process.
#![cfg(unix)]

mod process;

use process::*;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

fn interrupt(child: &std::process::Child) {
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

/// Waits until something is there, for half a minute at most.
fn until(condition: impl Fn() -> bool) {
    let started = Instant::now();
    while !condition() {
        assert!(started.elapsed() < Duration::from_secs(30), "it takes too long");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Interrupts a process; how long it takes to end, and how it ends.
fn stop(child: std::process::Child) -> (Duration, Output) {
    let stopped = Instant::now();
    interrupt(&child);
    let done = child.wait_with_output().unwrap();
    (stopped.elapsed(), done)
}

/// A machine that is busy with other tests may delay one try.
fn stops_in_a_second(attempt: impl Fn() -> Duration) {
    let tries: Vec<_> = (0..3).map(|_| attempt()).take_while(|t| *t >= Duration::from_secs(1)).collect();
    assert!(tries.len() < 3, "{tries:?}");
}

#[test]
fn ctrl_c_leaves_the_partial_picture() {
    stops_in_a_second(|| {
        let folder = Folder::new("interrupt");
        folder.write("slow.pov", SLOW);
        folder.write("next.pov", SPHERE);
        let args = ["render", "slow.pov", "next.pov", "-W", "800", "-H", "600", "--partial"];
        let child = folder.command(&args).stderr(Stdio::piped()).spawn().unwrap();
        let picture = folder.path("slow.png");
        until(|| picture.is_file());
        let size = png_header(&std::fs::read(&picture).unwrap());
        assert_eq!(size, (800, 600, false, 8), "the unfinished picture is whole as a file");
        let (took, done) = stop(child);
        assert_eq!(code(&done), Some(130));
        let text = stderr(&done);
        assert!(text.contains("interrupted") && text.contains("slow.png"), "{text}");
        let left = ["next.pov", "slow.png", "slow.pov"];
        assert_eq!(folder.names(), left, "the batch ends, no temporary file stays");
        took
    });
}

#[test]
fn ctrl_c_stops_an_endless_scene_text() {
    stops_in_a_second(|| {
        let folder = Folder::new("endless");
        folder.write("a.pov", "#declare I = 0; #while (1) #declare I = I + 1; #end");
        let child = folder.command(&["render", "a.pov"]).stderr(Stdio::piped()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(700));
        let (took, done) = stop(child);
        assert_eq!(code(&done), Some(130), "{}", stderr(&done));
        took
    });
}
