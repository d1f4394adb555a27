//! What was run, on what.

use super::Options;
use crate::records::Meta;
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

/// Writes meta.json.
///
/// # Errors
/// What the file system says.
pub fn write(options: &Options, command: &str) -> Result<(), String> {
    std::fs::create_dir_all(&options.directory)
        .map_err(|e| format!("{} is not made: {e}", options.directory.display()))?;
    let mut features = Vec::new();
    for (on, name) in [
        (cfg!(feature = "peers"), "peers"),
        (cfg!(feature = "ode"), "ode"),
        (cfg!(feature = "mujoco"), "mujoco"),
        (cfg!(feature = "bullet"), "bullet"),
        (cfg!(feature = "f64"), "f64"),
    ] {
        if on {
            features.push(name.to_string());
        }
    }
    let profile = if cfg!(debug_assertions) { "debug" } else { "release" };
    let meta = Meta {
        version: env!("CARGO_PKG_VERSION").into(),
        features,
        compiler: compiler(),
        flags: flags(profile),
        machine: machine(),
        cores: std::thread::available_parallelism().map_or(1, usize::from),
        date: date(),
        command: format!(
            "{command}{}{}",
            if options.quick { " --quick" } else { "" },
            if options.peers { " --peers" } else { "" }
        ),
        quick: options.quick,
    };
    meta.write(&options.directory)
}

/// How engines were built, and the version and licence of those that the machine has.
fn flags(profile: &str) -> String {
    let mut text = format!("{profile}; Box3D: -O3 -DNDEBUG -ffp-contract=off; Rapier: as Cargo builds it");
    for library in crate::engines::libraries() {
        text += "; ";
        text += &library;
    }
    text
}

fn compiler() -> String {
    let output = Command::new("rustc").arg("--version").output();
    output.ok().map_or_else(String::new, |o| String::from_utf8_lossy(&o.stdout).trim().to_string())
}

/// The CPU's name, where the system tells it.
fn machine() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = text.lines().find(|l| l.starts_with("model name"));
    line.and_then(|l| l.split(": ").nth(1)).unwrap_or(std::env::consts::ARCH).to_string()
}

/// Today, UTC: year-month-day.
fn date() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |d| d.as_secs());
    let (year, month, day) = civil((seconds / 86_400) as i64);
    format!("{year:04}-{month:02}-{day:02}")
}

/// The date of a day counted from 1970-01-01.
fn civil(days: i64) -> (i64, i64, i64) {
    let shifted = days + 719_468;
    let era = shifted.div_euclid(146_097);
    let day_of_era = shifted.rem_euclid(146_097);
    let year = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day = day_of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let m = if month < 10 { month + 3 } else { month - 9 };
    (year + era * 400 + i64::from(m <= 2), m, day - (153 * month + 2) / 5 + 1)
}

#[cfg(test)]
mod tests {
    use super::civil;

    #[test]
    fn days_have_their_dates() {
        assert_eq!(civil(0), (1970, 1, 1));
        assert_eq!(civil(11_016), (2000, 2, 29));
        assert_eq!(civil(20_783), (2026, 11, 26));
    }
}
