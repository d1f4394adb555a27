//! Where an error comes from: what remains of it when one of its sources is made exact.
//!
//! | source | what is exact instead | how |
//! |---|---|---|
//! | total | nothing | the engine as it comes |
//! | integrator | free motion | exact_rotation; translation is exact anyway |
//! | contact_law | contacts are rigid instead of soft | projected_gauss_seidel with 50 sweeps a sub-step |
//! | solver | rigid contacts, solved to the end | proximal_admm, whose residual is that of rounding |
//! | geometry | all arithmetic, contact geometry above all, in f64 | the same setting in the build of other precision, if it is in the file |
//!
//! The third and the fourth share the law: their difference is what sweeps leave unsolved.

use super::workers::Claims;
use super::{Options, ladder, try_case};
use crate::case::{Case, Trial, Vary};
use crate::engines::{self, Method, Setting};
use crate::records::{self, Attribution, Log, Record, WorkPrecision};
use crate::table::Table;

/// In the order of the table.
const SOURCES: [&str; 5] = ["total", "integrator", "contact_law", "solver", "geometry"];

/// The sources, the methods that make them exact, and the sweeps.
fn sources() -> [(&'static str, Method, u32); 4] {
    let first = engines::merev::methods()[0];
    [
        ("total", first, 0),
        ("integrator", Method { integrator: "exact_rotation", ..first }, 0),
        ("contact_law", Method { solver: "projected_gauss_seidel", iterates: true, ..first }, 50),
        ("solver", Method { solver: "proximal_admm", ..first }, 0),
    ]
}

/// Measures what is not there yet; merev only, the peers have no such switches. `first` is the number of its first unit.
///
/// # Errors
/// What the file system says.
pub fn measure(
    options: &Options,
    cases: &[Case],
    claims: Option<&Claims>,
    first: usize,
) -> Result<(), String> {
    let mut log = Log::<Attribution>::open(&options.directory, options.fresh)?;
    let maker = engines::ALL[0];
    let rows: Vec<WorkPrecision> = records::read(&options.directory)?;
    let told = |c: &Case| matches!(c.trial, Trial::Run(..)) && c.vary != Vary::Nothing;
    for (k, case) in cases.iter().enumerate().filter(|(_, c)| told(c)) {
        if claims.is_some_and(|c| !c.take(first + k)) {
            continue;
        }
        for (source, method, iterations) in sources() {
            let row = |error| row(case, source, error);
            if log.contains(&row(0.0).key()) {
                continue;
            }
            let setting = Setting { iterations, ..ladder::default_setting() };
            // Most of it has been measured for the chart.
            let known = rows.iter().find(|r| is_row(r, case, &method, &setting));
            let error = known.map_or_else(
                || try_case(case, &maker, &method, &setting, false, options.budget_of(false)).error,
                |row| row.error,
            );
            if let Some(error) = error {
                log.push(row(error))?;
            }
        }
    }
    Ok(())
}

fn row(case: &Case, source: &str, error: f64) -> Attribution {
    Attribution { scene: case.name.into(), engine: engines::ALL[0].key.into(), source: source.into(), error }
}

/// Adds what runs in double precision say, and puts the rows in order.
///
/// # Errors
/// What the file system says.
pub fn finish(options: &Options, cases: &[Case], rows: &[WorkPrecision]) -> Result<String, String> {
    let mut log = Log::<Attribution>::open(&options.directory, false)?;
    let method = engines::merev::methods()[0].name();
    for case in cases.iter().filter(|c| matches!(c.trial, Trial::Run(..))) {
        let double = rows.iter().find(|r| {
            r.scene == case.name
                && r.engine == engines::ALL[0].key
                && r.method == method
                && r.precision == "f64"
                && r.is_default == 1
                && r.turned == 0
        });
        if let Some(error) = double.and_then(|r| r.error) {
            log.push(row(case, "geometry", error))?;
        }
    }
    let place = |r: &Attribution| cases.iter().position(|c| c.name == r.scene).unwrap_or(usize::MAX);
    let source = |r: &Attribution| SOURCES.iter().position(|s| *s == r.source);
    log.sort_by_key(|r| (place(r), source(r)))?;
    Ok(table(log.rows()))
}

/// Whether a row is that of merev in this build with a method and a setting.
fn is_row(row: &WorkPrecision, case: &Case, method: &Method, setting: &Setting) -> bool {
    row.scene == case.name
        && row.engine == engines::ALL[0].key
        && row.method == method.name()
        && row.precision == engines::ALL[0].precision
        && row.turned == 0
        && row.rate_hz == setting.rate
        && row.sub_steps == setting.sub_steps
        && row.iterations == setting.iterations
        && row.accuracy == setting.accuracy
}

fn table(rows: &[Attribution]) -> String {
    let mut table = Table::new(&[&["what remains without"][..], &SOURCES].concat());
    let mut scenes: Vec<&str> = rows.iter().map(|r| r.scene.as_str()).collect();
    scenes.dedup();
    for scene in scenes {
        let cells = SOURCES.map(|source| {
            let found = rows.iter().find(|r| r.scene == scene && r.source == source);
            found.map_or(String::new(), |r| format!("{:.1e}", r.error))
        });
        table.row(std::iter::once(scene.to_string()).chain(cells));
    }
    table.to_string()
}
