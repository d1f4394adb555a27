//! The race: every scene of the race on every engine, in turns.

use super::{Options, meta};
use crate::progress;
use crate::race::{self, Options as RaceOptions};
use crate::records::{Log, Race};
use crate::scenes;
use crate::table::{Table, length, milliseconds, share};

/// Races all scenes that are not in the file yet.
///
/// # Errors
/// What the file system says; why ours refuses a scene.
pub fn run(options: &Options) -> Result<String, String> {
    let mut log = Log::<Race>::open(&options.directory, options.fresh)?;
    meta::write(options, "race")?;
    let builders: Vec<_> = scenes::ALL.iter().collect();
    let bar = progress::bar(builders.len() as u64, "race");
    for build in builders {
        bar.inc(1);
        let scene = build();
        let engines = crate::engines::racers(options.peers);
        let has = |key: &str| log.rows().iter().any(|r| r.scene == scene.name && r.engine == key);
        if !options.wants(scene.name) || engines.iter().all(|m| has(m.key)) {
            continue;
        }
        bar.set_message(scene.name);
        let most = if options.quick { 16 } else { 200 };
        let race = RaceOptions {
            steps: scene.steps.min(most),
            repeats: if options.quick { 1 } else { 4 },
            peers: options.peers,
            stages: false,
        };
        for row in race::rows(&scene, &race, &|_| {})? {
            log.push(row)?;
        }
    }
    bar.finish_and_clear();
    Ok(table(log.rows()))
}

fn table(rows: &[Race]) -> String {
    let mut table = Table::new(&[
        "scene", "engine", "median", "minimum", "ours/it", "first", "sagged", "sideways", "overlap", "gap",
        "energy",
    ]);
    for row in rows {
        let ours = rows.iter().find(|r| r.scene == row.scene && r.engine == "merev");
        if row.median_ms.is_nan() {
            let cells = [row.scene.clone(), row.engine.clone(), "left out".into()];
            table.row(cells.into_iter().chain(std::iter::repeat_n(String::new(), 8)));
            continue;
        }
        table.row([
            row.scene.clone(),
            row.engine.clone(),
            milliseconds(row.median_ms),
            milliseconds(row.minimum_ms),
            ours.map_or(String::new(), |o| format!("{:.2}", o.median_ms / row.median_ms)),
            milliseconds(row.first_ms),
            length(row.sagged_m),
            length(row.sideways_m),
            length(row.overlap_m),
            length(row.joint_gap_m),
            share(row.energy_change),
        ]);
    }
    table.to_string()
}
