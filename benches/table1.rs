//! The seed's table of broad phases, measured:
//! `cargo bench --bench table1 -- [--quick] [--only moving] [--kinds NAME,NAME…] [--out FILE]`.
//!
//! Table 1: N unit boxes strewn evenly over a cube of side (8 N)^(1/3), so that each meets one other on average. Timed
//! is one cycle as the seed has it: an empty structure takes in all boxes one by one, and all pairs are found, sorted.
//! Not timed is that the structure is given back. In the columns `half` every second box is immovable (the seed puts
//! the elements into two structures and checks half of them), in the columns `all` every box can move.
//!
//! The moving scenes: the same boxes; a tenth takes a random step of up to half a box along each axis and all pairs of
//! these are found, again and again. Timed is the update of the tenth and `find_pairs`. The rest is immovable in the
//! first scene and can move, but does not, in the second. In the third it is another tenth each time.

use merev::broad_phase::{BroadPhaseKind, Layer};
use merev::{Aabb, Float, Vec3, math::scalar, math::vec3};
use std::fmt::Write;
use std::time::{Duration, Instant};

/// splitmix64
struct Random(u64);

impl Random {
    /// −1 … 1.
    fn signed(&mut self) -> Float {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^= x >> 31;
        (x >> 40) as Float / (1u64 << 23) as Float - 1.0
    }

    fn vec(&mut self) -> Vec3 {
        vec3(self.signed(), self.signed(), self.signed())
    }
}

fn boxes(count: usize) -> Vec<Aabb> {
    let mut random = Random(1);
    let side = scalar::cbrt(8.0 * count as Float);
    (0..count).map(|_| Aabb::around(random.vec() * (0.5 * side), vec3(0.5, 0.5, 0.5))).collect()
}

/// Seconds the seed published for 10, 100, … 100 000 boxes; 0 where it did not finish.
const PUBLISHED: [(&str, BroadPhaseKind, [f64; 5]); 7] = [
    ("all pairs", BroadPhaseKind::BruteForce, [102e-9, 6.83e-6, 2100e-6, 252e-3, 0.0]),
    ("sort-and-sweep", BroadPhaseKind::SortAndSweep, [483e-9, 7.04e-6, 261e-6, 19e-3, 1830e-3]),
    ("sort-and-sweep 3", BroadPhaseKind::SortAndSweep3, [1611e-9, 29e-6, 1829e-6, 210e-3, 0.0]),
    ("R-tree", BroadPhaseKind::RTree, [557e-9, 39e-6, 941e-6, 21e-3, 708e-3]),
    ("R-tree (split)", BroadPhaseKind::RTreeSplit, [444e-9, 24e-6, 771e-6, 14e-3, 486e-3]),
    ("OMT", BroadPhaseKind::Omt, [468e-9, 17e-6, 505e-6, 8.65e-3, 164e-3]),
    ("OMT (split)", BroadPhaseKind::OmtSplit, [455e-9, 15e-6, 453e-6, 7.98e-3, 146e-3]),
];

/// A cell that is predicted to take longer is skipped.
const LIMIT: f64 = 60.0;

/// The same for a step of a moving scene.
const STEP_LIMIT: f64 = 2.0;

struct Options {
    /// The time after which no further run of a cell is begun.
    budget: Duration,
    /// Runs of a cell, at most.
    runs: usize,
    counts: Vec<usize>,
}

/// The median time of one call; short calls are timed many at once.
fn median(options: &Options, mut run: impl FnMut() -> Duration) -> f64 {
    let begin = Instant::now();
    let first = run();
    let batch = (Duration::from_millis(2).as_nanos() / first.as_nanos().max(1)).clamp(1, 10_000) as u32;
    let mut times = Vec::new();
    // The first run only warms up, unless it took so long that no other is made.
    if first > Duration::from_secs(2) {
        times.push(first.as_secs_f64());
    }
    while first <= Duration::from_secs(2)
        && times.len() < options.runs
        && (times.len() < 3 || begin.elapsed() < options.budget)
    {
        let sum: Duration = (0..batch).map(|_| run()).sum();
        times.push(sum.as_secs_f64() / f64::from(batch));
    }
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// One cycle of Table 1: build from nothing and find all pairs.
fn cycle(kind: BroadPhaseKind, boxes: &[Aabb], half: bool, all: &[u32], out: &mut Vec<[u32; 2]>) -> Duration {
    let begin = Instant::now();
    let mut bp = kind.build();
    for (i, b) in (0u32..).zip(boxes) {
        bp.insert(i, b, if half && i % 2 == 1 { Layer::Static } else { Layer::Moving });
    }
    bp.find_pairs(all, out);
    let time = begin.elapsed();
    drop(bp);
    time
}

/// The seed's yardstick: two nested loops over plain boxes, one test after the other.
fn naive(boxes: &[Aabb], out: &mut Vec<[u32; 2]>) -> Duration {
    let begin = Instant::now();
    out.clear();
    for i in 0..boxes.len() {
        for j in i + 1..boxes.len() {
            if boxes[i].overlaps(&boxes[j]) {
                out.push([i as u32, j as u32]);
            }
        }
    }
    begin.elapsed()
}

/// What a tenfold larger scene will take, from the growth of the last two.
fn predicted(times: &[f64]) -> f64 {
    match times {
        [.., a, b] => b * (b / a).max(10.0),
        _ => 0.0,
    }
}

fn table(options: &Options, kinds: &[BroadPhaseKind]) -> Vec<(BroadPhaseKind, [Vec<f64>; 2])> {
    let mut rows = Vec::new();
    for &kind in kinds {
        let mut columns = [Vec::new(), Vec::new()];
        for (half, column) in [true, false].into_iter().zip(&mut columns) {
            for &count in &options.counts {
                if predicted(column) > LIMIT {
                    break;
                }
                let boxes = boxes(count);
                let all: Vec<u32> = (0..count as u32).collect();
                let mut out = Vec::new();
                column.push(median(options, || cycle(kind, &boxes, half, &all, &mut out)));
            }
        }
        eprintln!(
            "{:24} {}",
            kind.name(),
            columns[0].iter().map(|&t| milliseconds(t)).collect::<Vec<_>>().join(" ")
        );
        rows.push((kind, columns));
    }
    rows
}

/// What the nine tenths do that do not move in a step.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Scene {
    /// They are immovable.
    Standing,
    /// They can move, but do not.
    Resting,
    /// They moved in other steps: who moves is drawn anew each time.
    Creeping,
}

impl Scene {
    const ALL: [Scene; 3] = [Scene::Standing, Scene::Resting, Scene::Creeping];

    fn name(self) -> &'static str {
        match self {
            Scene::Standing => "standing",
            Scene::Resting => "resting",
            Scene::Creeping => "creeping",
        }
    }
}

/// Steps of a moving scene, in seconds.
#[derive(Clone, Copy)]
struct Steps {
    median: f64,
    /// What the median hides: work that is done in some steps for all.
    mean: f64,
}

fn moving(options: &Options, kind: BroadPhaseKind, count: usize, scene: Scene) -> Steps {
    let mut boxes = boxes(count);
    let mut random = Random(2);
    let mut bp = kind.build();
    let rest = if scene == Scene::Standing { Layer::Static } else { Layer::Moving };
    for (i, b) in (0u32..).zip(&boxes) {
        bp.insert(i, b, if i % 10 == 0 { Layer::Moving } else { rest });
    }
    let mut moved: Vec<u32> = (0..count as u32).step_by(10).collect();
    let mut out = Vec::new();
    let mut steps = |runs: usize, budget: Duration| {
        let (begin, mut times) = (Instant::now(), Vec::new());
        while times.len() < runs && (times.is_empty() || begin.elapsed() < budget) {
            if scene == Scene::Creeping {
                moved.clear();
                moved.extend((0..count as u32).filter(|_| random.signed() < -0.8));
            }
            for &i in &moved {
                let b = &mut boxes[i as usize];
                let d = random.vec() * 0.5;
                *b = Aabb { lower: b.lower + d, upper: b.upper + d };
            }
            let begin = Instant::now();
            moved.iter().for_each(|&i| bp.update(i, &boxes[i as usize]));
            bp.find_pairs(&moved, &mut out);
            times.push(begin.elapsed().as_secs_f64());
        }
        times
    };
    // Long enough for a structure to age.
    steps(60, options.budget);
    let mut times = steps(options.runs.max(11) * 5, options.budget * 2);
    times.sort_by(f64::total_cmp);
    Steps { median: times[times.len() / 2], mean: times.iter().sum::<f64>() / times.len() as f64 }
}

/// Three digits.
fn milliseconds(seconds: f64) -> String {
    let t = seconds * 1e3;
    // Where the third digit stands.
    let places = (0..7).find(|&p| t >= 100.0 / f64::from(10u32.pow(p))).unwrap_or(7);
    format!("{t:.*}", places as usize)
}

fn cell(time: Option<&f64>) -> String {
    time.map_or("skipped".to_owned(), |&t| milliseconds(t))
}

fn write(path: &std::path::Path, text: &str) {
    std::fs::write(path, text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    println!("{}", path.display());
}

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let value = |name: &str| {
        args.iter().position(|a| a == name).map(|at| args.get(at + 1).expect("a value after the option"))
    };
    let quick = args.iter().any(|a| a == "--quick");
    let measured = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/measured");
    let path: std::path::PathBuf =
        value("--out").map_or_else(|| measured.join("broad_phase.csv"), |path| path.into());
    let stem = path.file_stem().expect("a file").to_string_lossy().into_owned();
    let moving_path = path.with_file_name(format!("{stem}_moving.csv"));
    let wanted: Option<Vec<&str>> = value("--kinds").map(|names| names.split(',').collect());
    let kinds: Vec<BroadPhaseKind> = BroadPhaseKind::ALL
        .into_iter()
        .filter(|kind| wanted.as_ref().is_none_or(|names| names.contains(&kind.name())))
        .collect();
    let options = if quick {
        Options { budget: Duration::from_millis(100), runs: 5, counts: vec![10, 100, 1000, 10_000, 100_000] }
    } else {
        let counts = vec![10, 100, 1000, 10_000, 100_000, 1_000_000];
        Options { budget: Duration::from_secs(1), runs: 11, counts }
    };
    match value("--only").map(String::as_str) {
        Some("moving") => {}
        None => table_1(&options, &kinds, &path),
        Some(other) => panic!("--only moving, not {other}"),
    }
    table_2(&options, &kinds, &moving_path);
}

const PRECISION: &str = if size_of::<Float>() == 4 { "f32" } else { "f64" };

/// Taking in all boxes and finding all pairs.
fn table_1(options: &Options, kinds: &[BroadPhaseKind], path: &std::path::Path) {
    let yardstick = boxes(10_000);
    let mut pairs = Vec::new();
    let naive = median(&Options { runs: 9, budget: Duration::from_secs(5), counts: Vec::new() }, || {
        naive(&yardstick, &mut pairs)
    });
    let factor = naive / 252e-3;
    println!(
        "two nested loops over 10 000 boxes: {} ms, the seed's: 252 ms, factor {factor:.2}",
        milliseconds(naive)
    );

    let rows = table(options, kinds);
    let mut text = format!(
        "# Milliseconds to take in N boxes and find all pairs, {PRECISION}; medians of 3 to {} runs. See benches/table1.rs.\n\
         # Columns `half`: every second box immovable; `all`: every box can move; `published`: Table 1 of the seed.\n\
         # Two nested loops over 10 000 boxes: {} ms here; the seed published 252 ms; factor {factor:.3}.\n\
         broad phase",
        options.runs,
        milliseconds(naive)
    );
    for column in ["half", "all", "published"] {
        for &n in options.counts.iter().filter(|&&n| column != "published" || n <= 100_000) {
            write!(text, ",{column} {n} [ms]").unwrap();
        }
    }
    text.push('\n');
    for (kind, columns) in &rows {
        text += kind.name();
        for column in columns {
            (0..options.counts.len()).for_each(|k| write!(text, ",{}", cell(column.get(k))).unwrap());
        }
        let published = PUBLISHED.iter().find(|p| p.1 == *kind);
        for k in 0..options.counts.len().min(5) {
            let time = published.map(|p| p.2[k]);
            let shown = match time {
                None => "–".to_owned(),
                Some(0.0) => "did not finish".to_owned(),
                Some(t) => milliseconds(t),
            };
            write!(text, ",{shown}").unwrap();
        }
        text.push('\n');
    }
    write(path, &text);

    let find = |kind| rows.iter().find(|r: &&(BroadPhaseKind, _)| r.0 == kind).map(|r| &r.1[0]);
    if let Some(omt) = find(BroadPhaseKind::OmtSplit).and_then(|times| times.get(4)) {
        let scaled = 146e-3 * factor;
        println!(
            "omt_split at 100 000: {} ms; published and scaled {} ms: {:.1} times faster",
            milliseconds(*omt),
            milliseconds(scaled),
            scaled / omt
        );
    }
}

/// A tenth moves.
fn table_2(options: &Options, kinds: &[BroadPhaseKind], path: &std::path::Path) {
    let counts: Vec<usize> =
        options.counts.iter().copied().filter(|n| (1000..=100_000).contains(n)).collect();
    let mut text = format!(
        "# Milliseconds a step: a tenth of N boxes is moved by up to half a box an axis, and their pairs are found; {PRECISION}, medians.\n\
         # Columns `standing`: the other nine tenths are immovable; `resting`: they can move, but do not; `creeping`: another tenth moves each step.\n\
         broad phase"
    );
    for scene in Scene::ALL {
        counts.iter().for_each(|n| write!(text, ",{} {n} [ms]", scene.name()).unwrap());
    }
    text.push('\n');
    let mut rows: Vec<(BroadPhaseKind, Scene, Vec<Steps>)> = Vec::new();
    for &kind in kinds {
        text += kind.name();
        for scene in Scene::ALL {
            let mut row: Vec<Steps> = Vec::new();
            for &n in &counts {
                let medians: Vec<f64> = row.iter().map(|steps| steps.median).collect();
                if predicted(&medians) < STEP_LIMIT {
                    row.push(moving(options, kind, n, scene));
                }
            }
            (0..counts.len()).for_each(|k| write!(text, ",{}", cell(row.get(k).map(|r| &r.median))).unwrap());
            rows.push((kind, scene, row));
        }
        text.push('\n');
    }
    write(path, &text);
    print!("{text}");

    let find = |kind, scene| rows.iter().find(|row| (row.0, row.1) == (kind, scene)).map(|row| &row.2);
    for scene in Scene::ALL {
        for kind in [BroadPhaseKind::DynamicBvh, BroadPhaseKind::DynamicRTree] {
            let (Some(own), Some(omt)) = (find(kind, scene), find(BroadPhaseKind::OmtSplit, scene)) else {
                continue;
            };
            for ((own, omt), count) in own.iter().zip(omt).zip(&counts) {
                println!(
                    "a tenth of {count} moves, {}: {} takes {} ms (mean {}) and is {:.2} times as fast as omt_split \
                     (by the mean {:.2})",
                    scene.name(),
                    kind.name(),
                    milliseconds(own.median),
                    milliseconds(own.mean),
                    omt.median / own.median,
                    omt.mean / own.mean
                );
            }
        }
    }
}
