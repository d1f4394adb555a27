//! The lab of merev: scenes, measurements and replay pages.

mod bounce;
mod case;
mod compare;
mod engines;
mod joints;
mod measure;
mod metrics;
mod programs;
mod progress;
mod race;
mod records;
mod references;
mod replay;
mod scene;
mod scenes;
mod show;
mod table;
mod tour;
mod vector;

use clap::{Parser, Subcommand};
use measure::workers::Worker;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Scenes, measurements and replay pages for merev. Without a command: runs a bouncing ball and pyramids through
/// the C interface, prints what they cost and how exact they are, and writes a page that replays them.
#[derive(Parser)]
#[command(name = "merev", version, about)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    /// List the scenes and the engines.
    List,
    /// Hold pendulums and chains against golden values.
    Joints {
        /// On the other engines too (needs the feature `peers`).
        #[arg(long)]
        peers: bool,
    },
    /// Chart speed against accuracy: every case on every method with many settings.
    Chart {
        #[command(flatten)]
        files: Files,
    },
    /// Find where methods fail: the hardest mass ratio, height, step, speed … that each survives.
    Stability {
        #[command(flatten)]
        files: Files,
    },
    /// Time a scene, and say how good the result is. Without a scene: all of them, into race.csv.
    Race {
        /// The scene, see `merev list`.
        scene: Option<String>,
        /// Of all scenes, a little.
        #[arg(long)]
        quick: bool,
        /// Of all scenes: begin anew instead of going on.
        #[arg(long)]
        fresh: bool,
        /// Run it on the other engines too (needs the feature `peers`).
        #[arg(long)]
        peers: bool,
        /// Number of steps; by default the scene's.
        #[arg(long, value_parser = clap::value_parser!(u32).range(2..))]
        steps: Option<u32>,
        /// How often to run it on each engine.
        #[arg(long, default_value_t = 4, value_parser = clap::value_parser!(u32).range(1..))]
        repeats: u32,
        /// Say what each engine says its stages took.
        #[arg(long)]
        stages: bool,
        /// Write the report into this file too; of all scenes, the directory for the files.
        #[arg(long)]
        out: Option<PathBuf>,
    },
    /// Draw all charts and the page anew from what was measured.
    Report {
        /// The directory with the records.
        #[arg(long, default_value = "target/lab")]
        out: PathBuf,
        /// Draw the chart and the tables of the README instead, into this folder of documents.
        #[arg(long)]
        readme: Option<PathBuf>,
    },
    /// Say what got better or worse since the baseline.
    Compare {
        /// The directory with the records.
        #[arg(long, default_value = "target/lab")]
        out: PathBuf,
        /// The directory with the baseline.
        #[arg(long, default_value = "lab/baseline")]
        baseline: PathBuf,
        /// By which factor costs may differ without anything having changed.
        #[arg(long, default_value_t = 1.25)]
        noise: f64,
        /// Fail if merev got worse.
        #[arg(long)]
        strict: bool,
        /// Take a single bit of merev's errors that differs for worse.
        #[arg(long)]
        exact: bool,
        /// Costs do not count: for a build that is not made for speed.
        #[arg(long)]
        errors: bool,
        /// Make what was measured the baseline.
        #[arg(long)]
        accept: bool,
    },
}

/// What the commands that measure are told.
#[derive(clap::Args, Default)]
struct Files {
    /// Little of everything, in a few minutes.
    #[arg(long)]
    quick: bool,
    /// Where the files go; by default target/lab.
    #[arg(long)]
    out: Option<PathBuf>,
    /// On the other engines too (needs the feature `peers`).
    #[arg(long)]
    peers: bool,
    /// Begin anew: else what is in the files is not measured again.
    #[arg(long)]
    fresh: bool,
    /// Only scenes whose name has this in it.
    #[arg(long)]
    only: Option<String>,
    /// In how many processes, each on a core of its own; by default one a core.
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// This is one of those processes; the core it stays on.
    #[arg(long, hide = true)]
    worker: Option<usize>,
    /// The command goes on where an earlier one had stopped.
    #[arg(long, hide = true)]
    resumed: bool,
}

impl Files {
    fn options(self) -> Result<measure::Options, String> {
        if self.peers && !engines::has_peers() {
            return Err(NO_PEERS.into());
        }
        let directory = self.out.unwrap_or_else(|| PathBuf::from("target/lab"));
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let worker = self.worker.map(|core| Worker { core, resumed: self.resumed });
        if let Some(worker) = worker {
            measure::workers::stay_on(worker.core);
        }
        Ok(measure::Options {
            directory,
            quick: self.quick,
            fresh: self.fresh,
            peers: self.peers,
            only: self.only,
            jobs: self.jobs.map_or(cores, usize::from),
            worker,
        })
    }
}

const NO_PEERS: &str = "no other engines were built in; build with `--features peers`";

fn main() -> ExitCode {
    match run(Arguments::parse()) {
        Ok(text) => {
            // Whoever reads this may have read enough.
            let _ = std::io::stdout().write_all(text.as_bytes());
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("merev: {message}");
            ExitCode::FAILURE
        }
    }
}

/// What to print.
fn run(arguments: Arguments) -> Result<String, String> {
    match arguments.command {
        None => tour::run(),
        Some(Command::List) => Ok(list()),
        Some(Command::Joints { peers }) => {
            if peers && !engines::has_peers() {
                return Err(NO_PEERS.into());
            }
            Ok(joints::run(peers))
        }
        Some(Command::Chart { files }) => shown(files, measure::chart::run, show::charts),
        Some(Command::Stability { files }) => shown(files, measure::stability::run, show::stability),
        Some(Command::Race { scene: None, quick, fresh, peers, out, .. }) => {
            shown(Files { quick, out, peers, fresh, ..Files::default() }, measure::race::run, show::race)
        }
        Some(Command::Race { scene: Some(scene), peers, steps, repeats, stages, out, .. }) => {
            if peers && !engines::has_peers() {
                return Err(NO_PEERS.into());
            }
            let scene =
                scenes::find(&scene).ok_or(format!("there is no scene `{scene}`; see `merev list`"))?;
            let steps = steps.map_or(scene.steps, |n| n as usize);
            let report =
                race::run(&scene, &race::Options { steps, repeats: repeats as usize, peers, stages })?;
            if let Some(path) = out {
                std::fs::write(&path, &report)
                    .map_err(|e| format!("{} is not written: {e}", path.display()))?;
            }
            Ok(report)
        }
        Some(Command::Report { out, readme: Some(documents) }) => show::readme::write(&out, &documents),
        Some(Command::Report { out, readme: None }) => {
            show::charts(&out)?;
            show::stability(&out)?;
            show::race(&out)?;
            show::report(&out)?;
            Ok(format!("{}\n", out.join("report.html").display()))
        }
        Some(Command::Compare { out, baseline, accept: true, .. }) => compare::accept(&out, &baseline),
        Some(Command::Compare { out, baseline, noise, strict, exact, errors, .. }) => {
            if !(noise.is_finite() && noise >= 1.0) {
                return Err("--noise is a factor of at least 1".into());
            }
            let (text, is_worse) = compare::run(&out, &baseline, &compare::Options { noise, exact, errors })?;
            if strict && is_worse { Err(format!("\n{text}")) } else { Ok(text) }
        }
    }
}

/// Measures, draws what there is to draw, and writes the page anew.
fn shown(
    files: Files,
    measure: fn(&measure::Options) -> Result<String, String>,
    draw: fn(&std::path::Path) -> Result<(), String>,
) -> Result<String, String> {
    let options = files.options()?;
    let text = measure(&options)?;
    if options.worker.is_some() {
        return Ok(text);
    }
    draw(&options.directory)?;
    show::report(&options.directory)?;
    Ok(format!("{text}\n{}\n", options.directory.join("report.html").display()))
}

fn list() -> String {
    let mut table = table::Table::new(&["scene", "bodies", "steps", "about"]);
    for scene in scenes::ALL.iter().map(|build| build()) {
        table.row([
            scene.name.to_string(),
            scene.dynamic_count().to_string(),
            scene.steps.to_string(),
            scene.about.to_string(),
        ]);
    }
    let names: Vec<&str> = engines::ALL.iter().map(|maker| maker.name).collect();
    format!("{table}\nengines: {}\n", names.join(", "))
}
