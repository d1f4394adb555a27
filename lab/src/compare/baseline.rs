//! The committed baseline: frozen corners, and the runs of an earlier state.

use super::Corners;
use crate::records::{self, Meta, Record, WorkPrecision};
use crate::show::hypervolume::Corner;
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::Path;

/// The corner of scenes that have none of their own.
const ALL: &str = "*";

/// A row of corners.csv.
#[derive(Serialize, Deserialize)]
struct CornerRow {
    scene: String,
    cost_ms: f64,
    error: f64,
}

impl Record for CornerRow {
    const FILE: &'static str = "corners.csv";
    const COLUMNS: &'static [&'static str] = &["scene", "cost_ms", "error"];

    fn key(&self) -> String {
        self.scene.clone()
    }
}

pub struct Baseline {
    pub corners: Corners,
    pub runs: Vec<WorkPrecision>,
    pub meta: Option<Meta>,
}

impl Baseline {
    /// Reads a baseline.
    ///
    /// # Errors
    /// No runs; corners that are not there or are none.
    pub fn read(directory: &Path) -> Result<Self, String> {
        let corners = corners(directory)?;
        let runs: Vec<WorkPrecision> = records::read(directory)?;
        if runs.is_empty() {
            return Err(format!(
                "there are no runs in {}; `merev compare --accept` puts those of now there",
                directory.display()
            ));
        }
        Ok(Self { corners, runs, meta: Meta::read(directory) })
    }

    pub fn corner(&self, scene: &str) -> Corner {
        self.corners.get(scene).or_else(|| self.corners.get(ALL)).copied().expect("checked when read")
    }
}

pub fn corners(directory: &Path) -> Result<Corners, String> {
    let rows: Vec<CornerRow> = records::read(directory)?;
    let path = directory.join(CornerRow::FILE);
    let mut all = Corners::new();
    for row in rows {
        let corner = Corner { cost_ms: row.cost_ms, error: row.error };
        let is_corner = |x: f64| x.is_finite() && x > 0.0;
        if !is_corner(row.cost_ms) || !is_corner(row.error) {
            return Err(format!("{}: {} has no corner above 0", path.display(), row.scene));
        }
        all.insert(row.scene, corner);
    }
    if !all.contains_key(ALL) {
        return Err(format!("{}: there is no row `{ALL}`", path.display()));
    }
    Ok(all)
}

/// Copies runs and meta into the baseline.
pub fn accept(directory: &Path, baseline: &Path) -> Result<String, String> {
    let runs: Vec<WorkPrecision> = records::read(directory)?;
    if runs.is_empty() {
        return Err(format!("there are no runs in {}; `merev chart` makes them", directory.display()));
    }
    for name in [WorkPrecision::FILE, Meta::FILE] {
        let (from, to) = (directory.join(name), baseline.join(name));
        if from.exists() {
            fs::copy(&from, &to).map_err(|e| format!("{} is not written: {e}", to.display()))?;
        }
    }
    Ok(format!("{} runs are the baseline now\n", runs.len()))
}
