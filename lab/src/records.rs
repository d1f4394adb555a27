//! The files in which measurements meet their readers: one struct a row, one CSV file a kind of row. Columns stand in
//! the order of the fields. Lists only grow; a row that is there need not be measured again.

use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// To its end, with an error.
    Ok,
    /// A number stopped being finite.
    Nan,
    /// A body got faster, or farther away, than the scene has energy for.
    Exploded,
    /// A body came through something.
    Tunnelled,
    /// The engine took its whole process down.
    Crashed,
    /// It took more time than a run is given.
    Timeout,
    /// The engine has not what the scene needs, or does not take the setting.
    Refused,
}

impl Outcome {
    /// As it is written.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Nan => "nan",
            Self::Exploded => "exploded",
            Self::Tunnelled => "tunnelled",
            Self::Crashed => "crashed",
            Self::Timeout => "timeout",
            Self::Refused => "refused",
        }
    }
}

/// A row of a file: which file, and what makes two rows the same measurement.
pub trait Record: Serialize + DeserializeOwned {
    /// The file's name.
    const FILE: &'static str;
    /// The names of the columns, in order.
    const COLUMNS: &'static [&'static str];
    /// Equal for two rows that measure the same.
    fn key(&self) -> String;
}

/// Defines a row: its struct, its file and the columns that make its key.
macro_rules! record {
    ($(#[$doc:meta])* $name:ident, $file:literal, key [$($key:ident),*],
     { $($(#[$field_doc:meta])* $field:ident: $type:ty),* $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        pub struct $name { $($(#[$field_doc])* pub $field: $type),* }

        impl Record for $name {
            const FILE: &'static str = $file;
            const COLUMNS: &'static [&'static str] = &[$(stringify!($field)),*];

            fn key(&self) -> String {
                [$(format!("{:?}", self.$key)),*].join("|")
            }
        }
    };
}

record! {
    /// A run of a scene with one setting: a point of the work–precision plots.
    WorkPrecision, "work_precision.csv",
    key [scene, engine, method, precision, turned, rate_hz, sub_steps, iterations, accuracy],
    {
        scene: String,
        /// A … J, as in the catalogue of scenes.
        group: String,
        /// merev, merev_c, box3d, rapier, bullet, ode or mujoco.
        engine: String,
        /// Solver and integrator, as the engine calls them.
        method: String,
        /// f32 or f64.
        precision: String,
        /// 1: the scene is rotated as a whole.
        turned: u8,
        /// Steps a second.
        rate_hz: f64,
        sub_steps: u32,
        /// Sweeps a sub-step; 0 where the method has no such number, or its default is meant.
        iterations: u32,
        /// The value of the accuracy knob, where it is used.
        accuracy: Option<f64>,
        /// 1: as the engine comes.
        is_default: u8,
        outcome: Outcome,
        /// The primary error over the scene's natural scale; only with the outcome ok.
        error: Option<f64>,
        /// CPU milliseconds of one thread for a simulated second, median of repeats.
        cost_ms: Option<f64>,
        /// 1: measured by a command that went on where an earlier one had stopped.
        resumed: u8,
    }
}

record! {
    /// A scene.
    SceneRow, "scenes.csv", key [scene],
    {
        scene: String,
        group: String,
        about: String,
        /// closed form, golden values, invariant or threshold.
        reference: String,
        /// What the error is, with its formula in words.
        primary: String,
        /// What errors are divided by.
        scale: f64,
        scale_unit: String,
        /// The error of a simulation in which nothing moves.
        null_error: Option<f64>,
        duration_s: f64,
    }
}

record! {
    /// A further measure of a run of [`WorkPrecision`].
    Secondary, "secondary.csv",
    key [scene, engine, method, precision, turned, rate_hz, sub_steps, iterations, accuracy, metric],
    {
        scene: String,
        engine: String,
        method: String,
        precision: String,
        turned: u8,
        rate_hz: f64,
        sub_steps: u32,
        iterations: u32,
        accuracy: Option<f64>,
        /// energy, momentum, angular_momentum, penetration, joint_gap, residual, …
        metric: String,
        value: f64,
    }
}

record! {
    /// What remains of an error when one of its sources is made exact.
    Attribution, "attribution.csv", key [scene, engine, source],
    {
        scene: String,
        engine: String,
        /// integrator, contact_law, solver, geometry or total.
        source: String,
        error: f64,
    }
}

record! {
    /// How much of a stressor a method bears.
    Stability, "stability.csv", key [scene, engine, method, stressor],
    {
        scene: String,
        engine: String,
        method: String,
        stressor: String,
        unit: String,
        /// larger or smaller: which values are harder.
        harder: String,
        /// The hardest value that passed; empty if the mildest failed.
        survived: Option<f64>,
        /// The mildest that failed; empty if the cap passed.
        failed: Option<f64>,
        /// How the mildest failure ended.
        outcome: Outcome,
    }
}

/// In the name of a method, before the accuracy that it was asked to keep.
pub const WITH_ACCURACY: &str = "/accuracy ";

record! {
    /// An engine's time for a scene of the race, and how good the result is.
    Race, "race.csv", key [scene, engine],
    {
        scene: String,
        engine: String,
        bodies: usize,
        steps: usize,
        /// Of a step, over the repeats.
        median_ms: f64,
        minimum_ms: f64,
        /// Of the first step.
        first_ms: f64,
        sagged_m: f64,
        sideways_m: f64,
        overlap_m: f64,
        joint_gap_m: f64,
        /// As a share of the greatest of kinetic and potential energy, at the start and at the end.
        energy_change: f64,
        /// Approach speed left at contacts \[m/s\].
        residual: f64,
    }
}

record! {
    /// A check that an adapter is right.
    Check, "checks.csv", key [check, engine],
    {
        check: String,
        engine: String,
        value: f64,
        bound: f64,
        pass: bool,
    }
}

/// What was run, on what: meta.json.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Meta {
    /// Of merev.
    pub version: String,
    pub features: Vec<String>,
    pub compiler: String,
    pub flags: String,
    /// The CPU's name.
    pub machine: String,
    pub cores: usize,
    /// UTC.
    pub date: String,
    pub command: String,
    pub quick: bool,
}

impl Meta {
    pub const FILE: &'static str = "meta.json";

    pub fn write(&self, directory: &Path) -> Result<(), String> {
        let path = directory.join(Self::FILE);
        let text = serde_json::to_string_pretty(self).map_err(|e| e.to_string())?;
        fs::write(&path, text + "\n").map_err(|e| format!("{} is not written: {e}", path.display()))
    }

    pub fn read(directory: &Path) -> Option<Self> {
        serde_json::from_str(&fs::read_to_string(directory.join(Self::FILE)).ok()?).ok()
    }
}

/// The rows of a kind in a directory; none if there is no such file.
///
/// # Errors
/// A file that does not hold such rows.
pub fn read<T: Record>(directory: &Path) -> Result<Vec<T>, String> {
    let path = directory.join(T::FILE);
    let file = match File::open(&path) {
        Ok(file) => file,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(e) => return Err(format!("{}: {e}", path.display())),
    };
    // Another process may be appending.
    file.lock_shared().map_err(|e| format!("{}: {e}", path.display()))?;
    let rows = csv::Reader::from_reader(file).into_deserialize();
    rows.collect::<Result<_, _>>().map_err(|e| format!("{}: {e}", path.display()))
}

/// A file that rows are appended to, each of them at once on disk.
pub struct Log<T: Record> {
    path: PathBuf,
    rows: Vec<T>,
    keys: std::collections::BTreeSet<String>,
    /// How many rows were there when the file was opened.
    found: usize,
}

impl<T: Record> Log<T> {
    /// Opens a file of the directory, which is made if need be. `fresh` begins anew.
    ///
    /// # Errors
    /// What the file system says; a file that does not hold such rows.
    pub fn open(directory: &Path, fresh: bool) -> Result<Self, String> {
        fs::create_dir_all(directory).map_err(|e| format!("{} is not made: {e}", directory.display()))?;
        let path = directory.join(T::FILE);
        let rows = if fresh { Vec::new() } else { read::<T>(directory)? };
        let keys = rows.iter().map(Record::key).collect();
        let found = rows.len();
        let log = Self { path, rows, keys, found };
        // Never over a file that is there: another process may have appended to it since it was read.
        if fresh || fs::metadata(&log.path).map_or(0, |m| m.len()) == 0 {
            let mut head = csv::Writer::from_writer(Vec::new());
            head.write_record(T::COLUMNS).map_err(|e| e.to_string())?;
            let bytes = head.into_inner().map_err(|e| e.to_string())?;
            fs::write(&log.path, bytes).map_err(|e| format!("{} is not written: {e}", log.path.display()))?;
        }
        Ok(log)
    }

    pub fn rows(&self) -> &[T] {
        &self.rows
    }

    pub fn contains(&self, key: &str) -> bool {
        self.keys.contains(key)
    }

    /// Whether rows of an earlier command were there.
    pub fn is_resumed(&self) -> bool {
        self.found > 0
    }

    /// Writes the rows anew in the order of `rank`, which processes that append by turns have not kept.
    ///
    /// # Errors
    /// What the file system says.
    pub fn sort_by_key<K: Ord>(&mut self, rank: impl FnMut(&T) -> K) -> Result<(), String> {
        self.rows.sort_by_cached_key(rank);
        let fail = |e: &dyn std::fmt::Display| format!("{} is not written: {e}", self.path.display());
        let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
        writer.write_record(T::COLUMNS).map_err(|e| fail(&e))?;
        for row in &self.rows {
            writer.serialize(row).map_err(|e| fail(&e))?;
        }
        fs::write(&self.path, writer.into_inner().map_err(|e| fail(&e))?).map_err(|e| fail(&e))
    }

    /// Appends a row, unless its measurement is there already.
    ///
    /// # Errors
    /// What the file system says.
    pub fn push(&mut self, row: T) -> Result<(), String> {
        if !self.keys.insert(row.key()) {
            return Ok(());
        }
        let fail = |e: &dyn std::fmt::Display| format!("{} is not written: {e}", self.path.display());
        let file = OpenOptions::new().append(true).open(&self.path).map_err(|e| fail(&e))?;
        file.lock().map_err(|e| fail(&e))?;
        let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(file);
        writer.serialize(&row).map_err(|e| fail(&e))?;
        writer.flush().map_err(|e| fail(&e))?;
        self.rows.push(row);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::show::samples::run;

    fn directory(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("merev-lab-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        path
    }

    fn point(rate_hz: f64, error: Option<f64>) -> WorkPrecision {
        let outcome = if error.is_some() { Outcome::Ok } else { Outcome::Nan };
        WorkPrecision { outcome, error, ..run("a1_ballistic", "merev", rate_hz, 0.125, 0.0) }
    }

    /// What is written is read back bit for bit, and a second run goes on where the first has stopped.
    #[test]
    fn rows_come_back_and_lists_only_grow() {
        let directory = directory("records");
        let rows = [point(60.0, Some(1.0 / 3.0e9)), point(120.0, None)];
        let mut log = Log::open(&directory, true).unwrap();
        assert!(!log.is_resumed());
        for row in &rows {
            log.push(row.clone()).unwrap();
        }
        let mut again = Log::<WorkPrecision>::open(&directory, false).unwrap();
        assert!(again.is_resumed() && again.contains(&rows[0].key()));
        assert_eq!(again.rows(), rows);
        again.push(WorkPrecision { error: Some(7.0), ..rows[0].clone() }).unwrap();
        again.push(point(240.0, Some(0.5))).unwrap();
        let all = read::<WorkPrecision>(&directory).unwrap();
        assert_eq!(all.len(), 3);
        assert_eq!(all[..2], rows);
        let head = fs::read_to_string(directory.join(WorkPrecision::FILE)).unwrap();
        assert!(head.starts_with(
            "scene,group,engine,method,precision,turned,rate_hz,sub_steps,iterations,accuracy,is_default,outcome,error,cost_ms,resumed\n"
        ));
        assert!(Log::<WorkPrecision>::open(&directory, true).unwrap().rows().is_empty());
        fs::remove_dir_all(&directory).unwrap();
    }

    /// Two that have opened an empty file both append to it, in whatever order.
    #[test]
    fn who_opens_a_file_takes_nothing_from_it() {
        let directory = directory("records-two");
        let mut one = Log::open(&directory, true).unwrap();
        let mut two = Log::open(&directory, false).unwrap();
        one.push(point(60.0, Some(0.5))).unwrap();
        two.push(point(120.0, Some(0.25))).unwrap();
        std::thread::scope(|scope| {
            for _ in 0..2 {
                scope.spawn(|| {
                    for k in 0..200 {
                        let mut log = Log::<WorkPrecision>::open(&directory, false).unwrap();
                        log.push(point(1000.0 + f64::from(k), Some(0.5))).unwrap();
                    }
                });
            }
        });
        let rows = read::<WorkPrecision>(&directory).unwrap();
        let rates: std::collections::BTreeSet<u64> = rows.iter().map(|r| r.rate_hz as u64).collect();
        assert_eq!(rates.len(), 202);
        assert_eq!(rows[..2], [point(60.0, Some(0.5)), point(120.0, Some(0.25))]);
        fs::remove_dir_all(&directory).unwrap();
    }

    #[test]
    fn a_missing_file_has_no_rows_and_a_wrong_one_is_an_error() {
        let directory = directory("records-wrong");
        assert_eq!(read::<Race>(&directory).unwrap(), []);
        fs::create_dir_all(&directory).unwrap();
        fs::write(directory.join(Race::FILE), "scene,engine\na,b\n").unwrap();
        assert!(read::<Race>(&directory).unwrap_err().contains("race.csv"));
        fs::remove_dir_all(&directory).unwrap();
    }

    #[test]
    fn meta_comes_back() {
        let directory = directory("records-meta");
        fs::create_dir_all(&directory).unwrap();
        let meta = Meta { version: "0.1.0".into(), cores: 2, quick: true, ..Meta::default() };
        meta.write(&directory).unwrap();
        assert_eq!(Meta::read(&directory), Some(meta));
        fs::remove_dir_all(&directory).unwrap();
    }
}
