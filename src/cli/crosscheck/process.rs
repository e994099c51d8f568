//! Programs with a time limit.

use crate::cli::interrupt;
use std::io::{self, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// How a program ended.
pub enum Ending {
    Exited(ExitStatus),
    TimedOut,
    Interrupted,
}

pub struct Finished {
    pub ending: Ending,
    pub stdout: Vec<u8>,
    pub stderr: Vec<u8>,
}

/// Runs a program to its end, or to the end of its time.
pub fn run(command: &mut Command, limit: Duration) -> io::Result<Finished> {
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
    let stdout = collect(child.stdout.take());
    let stderr = collect(child.stderr.take());
    let ending = wait(&mut child, limit)?;
    let text = |reader: JoinHandle<Vec<u8>>| reader.join().unwrap_or_default();
    Ok(Finished { ending, stdout: text(stdout), stderr: text(stderr) })
}

/// Reads a pipe to its end, so that the program never waits for us.
fn collect(pipe: Option<impl Read + Send + 'static>) -> JoinHandle<Vec<u8>> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            // What was read before an error is kept.
            let _ = pipe.read_to_end(&mut bytes);
        }
        bytes
    })
}

fn wait(child: &mut Child, limit: Duration) -> io::Result<Ending> {
    let started = Instant::now();
    let mut pause = Duration::from_millis(2);
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Ending::Exited(status));
        }
        let late = started.elapsed() >= limit;
        if late || interrupt::requested() {
            // It may have ended by itself just now.
            let _ = child.kill();
            child.wait()?;
            return Ok(if late { Ending::TimedOut } else { Ending::Interrupted });
        }
        thread::sleep(pause);
        pause = (pause * 2).min(Duration::from_millis(50));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn output_and_status_are_kept() {
        let mut command = Command::new("sh");
        let done =
            run(command.args(["-c", "echo out; echo err >&2; exit 3"]), Duration::from_secs(20)).unwrap();
        assert_eq!((done.stdout.as_slice(), done.stderr.as_slice()), (&b"out\n"[..], &b"err\n"[..]));
        assert!(matches!(done.ending, Ending::Exited(s) if s.code() == Some(3)));
    }

    #[test]
    fn time_runs_out() {
        let started = Instant::now();
        let done = run(Command::new("sleep").arg("30"), Duration::from_millis(100)).unwrap();
        assert!(matches!(done.ending, Ending::TimedOut));
        assert!(started.elapsed() < Duration::from_secs(10));
    }
}
