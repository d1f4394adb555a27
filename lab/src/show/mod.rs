//! Pictures and pages of what was measured. Everything here reads the CSV files of a directory and computes from
//! nothing else, so whoever has the files can draw it all anew.
//!
//! | file | idea |
//! |---|---|
//! | data, settings | the records; runs as points, upright and turned taken together |
//! | pareto, order, profile, hypervolume | what is computed from points |
//! | svg, axis, palette, png | how pictures are made |
//! | work_precision | error against cost, one chart a scene |
//! | overview | performance and data profiles over all scenes |
//! | attribution | what remains of an error when a source of it is made exact |
//! | stability_map | the map of what each method bears |
//! | race_chart | times, and what came of them |
//! | verdict | where merev wins and where it loses |
//! | report | all of it as one page |
//! | readme | the chart and the tables of the README |

mod attribution;
mod axis;
mod data;
pub mod hypervolume;
pub mod order;
mod overview;
mod palette;
pub mod pareto;
mod png;
mod profile;
mod race_chart;
pub mod readme;
mod report;
#[cfg(test)]
pub mod samples;
pub mod settings;
mod stability_map;
mod svg;
mod verdict;
mod work_precision;

use data::{Data, Entrant};
use std::fs;
use std::path::Path;
use svg::Svg;

/// How many pixels of a PNG stand for one of an SVG.
const SCALE: f32 = 2.0;

/// Draws the work–precision charts, attribution bars and profiles into `charts/` of a directory with records.
///
/// # Errors
/// What the file system says; records that cannot be read.
pub fn charts(directory: &Path) -> Result<(), String> {
    let data = Data::read(directory)?;
    let folder = directory.join("charts");
    for scene in &data.scenes {
        let settings = data.settings_of(&scene.scene);
        if !settings.is_empty() {
            write(&folder, &scene.scene, &work_precision::draw(scene, &settings, true))?;
        }
        if let Some(bars) = attribution::draw(&scene.scene, &data.attribution, true) {
            write(&folder, &format!("{}_sources", scene.scene), &bars)?;
        }
    }
    if !data.settings.is_empty() {
        let entrants = data.entrants();
        let title = "Share of scenes solved within a budget";
        let panels = overview::budget(&data, &entrants);
        write(&folder, "overview_budget", &overview::sheet(title, &panels, &entrants))?;
        let title = "Share of scenes solved at so many times the least cost";
        let panels = overview::performance(&data, &entrants);
        write(&folder, "overview_performance", &overview::sheet(title, &panels, &entrants))?;
    }
    Ok(())
}

/// Draws the stability map.
///
/// # Errors
/// As [`charts`].
pub fn stability(directory: &Path) -> Result<(), String> {
    let data = Data::read(directory)?;
    if data.stability.is_empty() {
        return Ok(());
    }
    write(&directory.join("charts"), "stability", &stability_map::draw(&data.stability))
}

/// Draws the race.
///
/// # Errors
/// As [`charts`].
pub fn race(directory: &Path) -> Result<(), String> {
    let data = Data::read(directory)?;
    if data.race.is_empty() {
        return Ok(());
    }
    let mut engines = settings::distinct(data.race.iter().map(|r| r.engine.as_str()));
    engines.sort_by(|a, b| palette::rank(a).cmp(&palette::rank(b)));
    let entrants: Vec<Entrant> = engines.into_iter().map(|engine| Entrant { engine, choice: None }).collect();
    let sheet =
        overview::sheet("The race: time and what came of it", &race_chart::panels(&data.race), &entrants);
    write(&directory.join("charts"), "race", &sheet)
}

/// Writes `report.html`: everything in one page.
///
/// # Errors
/// As [`charts`].
pub fn report(directory: &Path) -> Result<(), String> {
    let page = report::page(&Data::read(directory)?);
    let path = directory.join("report.html");
    fs::write(&path, page).map_err(|e| format!("{} is not written: {e}", path.display()))
}

/// Writes a picture as SVG and PNG.
fn write(folder: &Path, name: &str, picture: &Svg) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|e| format!("{} is not made: {e}", folder.display()))?;
    // Scenes are named by words; whatever else there is must not lead out of the folder.
    let name: String =
        name.chars().map(|c| if c.is_alphanumeric() || c == '_' || c == '-' { c } else { '_' }).collect();
    let text = picture.file();
    let bytes = png::png(&text, SCALE)?;
    for (path, bytes) in
        [(folder.join(format!("{name}.svg")), text.as_bytes()), (folder.join(format!("{name}.png")), &bytes)]
    {
        fs::write(&path, bytes).map_err(|e| format!("{} is not written: {e}", path.display()))?;
    }
    Ok(())
}
