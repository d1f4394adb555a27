//! The lab of merev: scenes, measurements and replay pages.

mod bounce;
mod compare;
mod engines;
mod joints;
mod programs;
mod progress;
mod race;
#[allow(dead_code, reason = "written by what measures, read by what shows")]
mod records;
mod replay;
mod scene;
mod scenes;
mod show;
mod table;
mod tour;

use clap::{Parser, Subcommand};
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
    /// Time a scene, and say how good the result is.
    Race {
        /// The scene, see `merev list`.
        scene: String,
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
        /// Write the report into this file too.
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
        /// Make what was measured the baseline.
        #[arg(long)]
        accept: bool,
    },
}

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
            if peers && engines::ALL.len() == 1 {
                return Err("no peers were built in; build with `--features peers`".into());
            }
            Ok(joints::run(peers))
        }
        Some(Command::Race { scene, peers, steps, repeats, stages, out }) => {
            if peers && engines::ALL.len() == 1 {
                return Err("no peers were built in; build with `--features peers`".into());
            }
            let scene =
                scenes::find(&scene).ok_or(format!("there is no scene `{scene}`; see `merev list`"))?;
            let steps = steps.map_or(scene.steps, |n| n as usize);
            let report =
                race::run(&scene, &race::Options { steps, repeats: repeats as usize, peers, stages });
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
        Some(Command::Compare { out, baseline, noise, strict, exact, .. }) => {
            if !(noise.is_finite() && noise >= 1.0) {
                return Err("--noise is a factor of at least 1".into());
            }
            let (text, is_worse) = compare::run(&out, &baseline, &compare::Options { noise, exact })?;
            if strict && is_worse { Err(format!("\n{text}")) } else { Ok(text) }
        }
    }
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
