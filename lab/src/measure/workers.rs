//! A measurement spread over processes. Each takes what none has taken yet and appends its rows to the same files, so no
//! core waits for another, and an engine that brings its process down takes no other measurement along.

use super::Options;
use indicatif::ProgressBar;
use std::fs::{self, OpenOptions};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// What a process that helps another is told.
#[derive(Clone, Copy, Debug)]
pub struct Worker {
    /// Which core it stays on.
    pub core: usize,
    /// Whether the command goes on where an earlier one had stopped.
    pub resumed: bool,
}

/// Who does what: a file for each unit of work that somebody has begun, which says what is being done.
pub struct Claims {
    directory: PathBuf,
}

impl Claims {
    fn of(options: &Options) -> Self {
        Self { directory: options.directory.join("claims") }
    }

    /// The claims that a worker sees; without workers there are none, and everything may be taken.
    pub fn shared(options: &Options) -> Option<Self> {
        options.worker.map(|_| Self::of(options))
    }

    fn file(&self, unit: usize) -> PathBuf {
        self.directory.join(unit.to_string())
    }

    /// Whether the unit is ours to do.
    pub fn take(&self, unit: usize) -> bool {
        OpenOptions::new().write(true).create_new(true).open(self.file(unit)).is_ok()
    }

    /// Says what of a unit is being done, and by which process.
    pub fn note(&self, unit: usize, what: &str) {
        // Without the note a crash is reported all the same, but not of what.
        let _ = fs::write(self.file(unit), format!("{}\n{what}", std::process::id()));
    }

    /// What this process was doing: the unit, and its note.
    fn of_process(&self, id: u32) -> Option<(usize, String)> {
        let mut found = None;
        for entry in fs::read_dir(&self.directory).ok()?.flatten() {
            let text = fs::read_to_string(entry.path()).unwrap_or_default();
            let Some((process, what)) = text.split_once('\n') else { continue };
            if process == id.to_string() {
                let time = entry.metadata().and_then(|m| m.modified()).ok();
                let unit = entry.file_name().to_string_lossy().parse().unwrap_or(0);
                found = found.max(Some((time, unit, what.to_string())));
            }
        }
        found.map(|(_, unit, what)| (unit, what))
    }
}

/// Runs `command` in as many processes as the options say. `died` is told what a process was doing when it crashed
/// and records it; the rest of that unit is then done by another.
///
/// # Errors
/// A worker that failed; what the file system says.
pub fn run(
    options: &Options,
    command: &str,
    resumed: bool,
    bar: &ProgressBar,
    done: &dyn Fn() -> u64,
    died: &mut dyn FnMut(&str) -> Result<(), String>,
) -> Result<(), String> {
    let claims = Claims::of(options);
    let fail = |e: std::io::Error| format!("{}: {e}", claims.directory.display());
    if claims.directory.exists() {
        fs::remove_dir_all(&claims.directory).map_err(fail)?;
    }
    fs::create_dir_all(&claims.directory).map_err(fail)?;
    let start = |core| spawn(options, command, Worker { core, resumed });
    let mut running: Vec<(usize, Child)> =
        (0..options.jobs).map(|core| Ok((core, start(core)?))).collect::<Result<_, String>>()?;
    while !running.is_empty() {
        sleep(Duration::from_millis(200));
        bar.set_position(done());
        let mut left = Vec::new();
        let mut fault = None;
        for (core, mut child) in running {
            let Some(status) = child.try_wait().map_err(|e| e.to_string())? else {
                left.push((core, child));
                continue;
            };
            match status.code() {
                Some(0) => {}
                // It has said on the terminal what was wrong.
                Some(1) => fault = Some("a worker failed".to_string()),
                // A signal, or a panic of an engine.
                _ => match claims.of_process(child.id()) {
                    None => fault = Some(format!("a worker died ({status})")),
                    Some((unit, what)) => {
                        died(&what)?;
                        fs::remove_file(claims.file(unit)).map_err(fail)?;
                        left.push((core, start(core)?));
                    }
                },
            }
        }
        running = left;
        if let Some(fault) = fault {
            // Who is already gone need not be stopped.
            running.iter_mut().for_each(|(_, child)| drop(child.kill()));
            return Err(fault);
        }
    }
    fs::remove_dir_all(&claims.directory).map_err(fail)
}

fn spawn(options: &Options, command: &str, worker: Worker) -> Result<Child, String> {
    let program = std::env::current_exe().map_err(|e| e.to_string())?;
    let mut call = Command::new(program);
    call.arg(command).arg("--out").arg(&options.directory).args(["--worker", &worker.core.to_string()]);
    for (on, name) in [(options.quick, "--quick"), (options.peers, "--peers"), (worker.resumed, "--resumed")]
    {
        if on {
            call.arg(name);
        }
    }
    if let Some(only) = &options.only {
        call.args(["--only", only]);
    }
    call.stdout(Stdio::null()).spawn().map_err(|e| format!("no worker can be started: {e}"))
}

/// Keeps this process on one core, where the system allows it.
pub fn stay_on(core: usize) {
    if let Some(ids) = core_affinity::get_core_ids()
        && let Some(&id) = ids.get(core)
    {
        core_affinity::set_for_current(id);
    }
}

/// How many rows a file has, without reading what they say.
pub fn count(path: &Path) -> u64 {
    let text = fs::read(path).unwrap_or_default();
    (text.iter().filter(|&&b| b == b'\n').count() as u64).saturating_sub(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_is_taken_once_and_says_who_was_at_it() {
        let directory = std::env::temp_dir().join(format!("merev-lab-claims-{}", std::process::id()));
        fs::create_dir_all(&directory).unwrap();
        let claims = Claims { directory: directory.clone() };
        assert!(claims.take(3) && !claims.take(3) && claims.take(4));
        claims.note(3, "a\nb");
        claims.note(4, "c");
        assert_eq!(claims.of_process(std::process::id()), Some((4, "c".into())));
        fs::remove_file(claims.file(4)).unwrap();
        assert_eq!(claims.of_process(std::process::id()), Some((3, "a\nb".into())));
        assert_eq!(claims.of_process(0), None);
        fs::remove_dir_all(&directory).unwrap();
    }
}
