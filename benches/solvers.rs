//! How well and how fast each solver holds what it is given, in the engine: residual against time for stacks of 2 … 50
//! cubes and for mass ratios of 1 … 10⁶.
//!
//! `cargo bench --bench solvers` writes docs/measured/solvers_stack.csv and solvers_ratio.csv; `-- --quick` measures a
//! few sizes only and writes nothing. Times are of the solve stage, medians over the steps; they vary with the
//! machine, the rest does not.

use merev::math::{length, vec3};
use merev::solver::SolverKind;
use merev::world::{BodyDef, ShapeDef, WorldDef};
use merev::{BodyId, Float, Shape, World};
use std::fmt::Write as _;

/// A solver and how hard it tries.
#[derive(Clone, Copy)]
struct Entry {
    solver: SolverKind,
    /// Iterations in each of 4 sub-steps, for the solvers that iterate.
    iterations: u32,
}

const ENTRIES: [Entry; 10] = [
    Entry { solver: SolverKind::SoftStep, iterations: 0 },
    Entry { solver: SolverKind::SequentialImpulse, iterations: 4 },
    Entry { solver: SolverKind::SequentialImpulse, iterations: 16 },
    Entry { solver: SolverKind::SequentialImpulse, iterations: 64 },
    Entry { solver: SolverKind::ProjectedGaussSeidel, iterations: 4 },
    Entry { solver: SolverKind::ProjectedGaussSeidel, iterations: 16 },
    Entry { solver: SolverKind::ProjectedGaussSeidel, iterations: 64 },
    Entry { solver: SolverKind::Lemke, iterations: 0 },
    Entry { solver: SolverKind::Dantzig, iterations: 0 },
    Entry { solver: SolverKind::ProximalAdmm, iterations: 0 },
];

/// Cubes of these densities on each other.
fn stack(entry: Entry, densities: &[Float]) -> (World, Vec<BodyId>) {
    let def = WorldDef {
        solver: entry.solver,
        solver_iterations: entry.iterations,
        enable_sleep: false,
        ..WorldDef::default()
    };
    let mut world = World::try_new(&def).expect("a valid definition");
    let floor = BodyDef::fixed(vec3(0.0, -1.0, 0.0));
    let ground = Shape::new_box(50.0, 2.0, 50.0);
    world.create_body_with_shape(&floor, &ShapeDef::default(), ground).expect("a floor");
    let bodies = densities.iter().enumerate().map(|(i, &density)| {
        let at = BodyDef::dynamic(vec3(0.0, 0.5 + i as Float, 0.0));
        let surface = ShapeDef { density, ..ShapeDef::default() };
        world.create_body_with_shape(&at, &surface, Shape::new_box(1.0, 1.0, 1.0)).expect("a cube").0
    });
    let bodies = bodies.collect();
    (world, bodies)
}

/// One line of a table.
fn measure(entry: Entry, densities: &[Float], steps: usize) -> String {
    let (mut world, bodies) = stack(entry, densities);
    let mut times = Vec::new();
    let (mut fallbacks, mut spent) = (0, 0.0);
    for _ in 0..steps {
        world.try_step(1.0 / 60.0, 4).expect("a valid step");
        times.push(world.profile().solve);
        spent += world.profile().step;
        // Slow ones are measured over fewer steps, which the table says.
        if spent > 5_000.0 {
            break;
        }
    }
    let done = times.len();
    let report = world.step_report();
    fallbacks += report.solve.fallbacks;
    times.sort_by(f32::total_cmp);
    let drift = bodies
        .iter()
        .enumerate()
        .map(|(i, &b)| {
            length(world.body(b).expect("alive").world_center() - vec3(0.0, 0.5 + i as Float, 0.0))
        })
        .fold(0.0, Float::max);
    let laws = if entry.solver == SolverKind::SoftStep {
        "not measured".to_owned()
    } else {
        format!("{:.1e}", report.solve.residual)
    };
    let iterations = if entry.iterations > 0 { entry.iterations.to_string() } else { "–".to_owned() };
    format!(
        "{},{iterations},{:.3},{:.1e},{laws},{:.1e},{:.1e},{fallbacks},{done}",
        entry.solver.name(),
        times[done / 2],
        report.residual,
        report.worst_penetration,
        drift,
    )
}

const COLUMNS: &str = "solver,iterations,solve [ms a step],approach left [m/s],error of the contact laws [m/s],overlap [m],drift [m],swept instead,steps";

fn main() {
    let quick = std::env::args().any(|a| a == "--quick");
    let steps = if quick { 30 } else { 120 };
    let sizes: &[usize] = if quick { &[2, 10] } else { &[2, 5, 10, 20, 30, 50] };
    let ratios: &[i32] = if quick { &[0, 3] } else { &[0, 1, 2, 3, 4, 5, 6] };

    let mut table = format!("cubes,{COLUMNS}\n");
    for &size in sizes {
        for entry in ENTRIES {
            let line = format!("{size},{}", measure(entry, &vec![1000.0; size], steps));
            println!("{line}");
            writeln!(table, "{line}").expect("text");
        }
    }
    write("solvers_stack.csv", &table, quick);

    let mut table = format!("heavy on light,{COLUMNS}\n");
    for &decade in ratios {
        // The ratio is between the two bodies, so both have masses that are nothing special.
        let root = (0..decade).fold(1.0, |x: f64, _| x * 10.0);
        for entry in ENTRIES {
            let line = format!("1e{decade},{}", measure(entry, &[1.0, root as Float], steps));
            println!("{line}");
            writeln!(table, "{line}").expect("text");
        }
    }
    write("solvers_ratio.csv", &table, quick);
}

fn write(name: &str, table: &str, quick: bool) {
    if quick {
        return;
    }
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/measured");
    std::fs::create_dir_all(&folder).expect("a folder for the tables");
    std::fs::write(folder.join(name), table).expect("a table");
    println!("wrote docs/measured/{name}");
}
