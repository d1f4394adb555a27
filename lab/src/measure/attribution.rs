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

use super::{Options, ladder, try_case};
use crate::case::{Case, Trial, Vary};
use crate::engines::{self, Method, Setting};
use crate::records::{Attribution, Log, Record, WorkPrecision};
use crate::table::Table;

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

/// Measures what is not there yet; merev only, the peers have no such switches.
///
/// # Errors
/// What the file system says.
pub fn run(options: &Options, cases: &[Case], rows: &[WorkPrecision]) -> Result<String, String> {
    let mut log = Log::<Attribution>::open(&options.directory, options.fresh)?;
    let maker = engines::ALL[0];
    let bar = crate::progress::bar(cases.len() as u64, "attribution");
    let told = |c: &&Case| matches!(c.trial, Trial::Run(..)) && c.vary != Vary::Nothing;
    for case in cases.iter().filter(told) {
        bar.inc(1);
        for (source, method, iterations) in sources() {
            let new = |error| Attribution {
                scene: case.name.into(),
                engine: maker.key.into(),
                source: source.into(),
                error,
            };
            if log.contains(&new(0.0).key()) {
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
                log.push(new(error))?;
            }
        }
        let name = engines::merev::methods()[0].name();
        let double = rows.iter().find(|r| {
            r.scene == case.name
                && r.engine == maker.key
                && r.method == name
                && r.precision == "f64"
                && r.is_default == 1
                && r.turned == 0
        });
        if let Some(error) = double.and_then(|r| r.error) {
            log.push(Attribution {
                scene: case.name.into(),
                engine: maker.key.into(),
                source: "geometry".into(),
                error,
            })?;
        }
    }
    bar.finish_and_clear();
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
    let names = ["total", "integrator", "contact_law", "solver", "geometry"];
    let mut table = Table::new(&[&["what remains without"][..], &names].concat());
    let mut scenes: Vec<&str> = rows.iter().map(|r| r.scene.as_str()).collect();
    scenes.dedup();
    for scene in scenes {
        let cells = names.map(|source| {
            let found = rows.iter().find(|r| r.scene == scene && r.source == source);
            found.map_or(String::new(), |r| format!("{:.1e}", r.error))
        });
        table.row(std::iter::once(scene.to_string()).chain(cells));
    }
    table.to_string()
}
