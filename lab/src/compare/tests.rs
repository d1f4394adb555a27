use super::*;
use crate::show::samples::run;
use std::path::PathBuf;

const OPTIONS: Options = Options { noise: 1.25, exact: false, errors: false };

fn base(runs: Vec<WorkPrecision>) -> Baseline {
    let corner = Corner { cost_ms: 1000.0, error: 1.0 };
    Baseline { corners: [("*".to_owned(), corner)].into(), runs, meta: None }
}

fn ladder(engine: &str) -> Vec<WorkPrecision> {
    [30.0, 60.0, 120.0].map(|hz| run("s", engine, hz, hz / 6.0, 0.3 / hz)).into()
}

#[test]
fn the_same_runs_are_the_same() {
    let findings = find(&base(ladder("merev")), &ladder("merev"), 1.25);
    assert_eq!((findings.common, findings.same, findings.pace), (3, 3, 1.0));
    assert!(!findings.is_regression(&Options { exact: true, ..OPTIONS }));
    // By hand: costs 5, 10, 20 against 1000, errors 1e-2, 5e-3, 2.5e-3 against 1.
    let two = libm::log10(2.0);
    let expected = (3.0 - libm::log10(5.0)) * 2.0 + 2.0 * two + (2.0 - two) * two;
    assert!((findings.volumes[0].after - expected).abs() < 1e-12);
}

#[test]
fn costs_within_the_noise_are_no_regression_and_beyond_it_they_are() {
    for (factor, is_worse, is_better) in [(1.2, false, false), (1.3, true, false), (0.7, false, true)] {
        let mut now = ladder("merev");
        now.iter_mut().for_each(|r| r.cost_ms = r.cost_ms.map(|c| c * factor));
        let findings = find(&base(ladder("merev")), &now, 1.25);
        let volume = &findings.volumes[0];
        assert_eq!((volume.is_worse(), volume.is_better()), (is_worse, is_better), "{factor}: {volume:?}");
        assert_eq!(findings.is_regression(&OPTIONS), is_worse);
        assert!(!findings.is_regression(&Options { errors: true, ..OPTIONS }));
    }
}

#[test]
fn a_slow_day_slows_the_others_too() {
    let both = || -> Vec<WorkPrecision> {
        let others = (0..12).map(|k| run("s", "box3d", 30.0 + f64::from(k), 1.0, 0.1));
        ladder("merev").into_iter().chain(others).collect()
    };
    let mut now = both();
    now.iter_mut().for_each(|r| r.cost_ms = r.cost_ms.map(|c| 2.0 * c));
    let findings = find(&base(both()), &now, 1.25);
    assert_eq!(findings.pace, 2.0);
    assert!(!findings.is_regression(&OPTIONS));
}

#[test]
fn engines_that_did_not_change_tell_the_noise() {
    let both = |factor: f64| -> Vec<WorkPrecision> {
        let cost = |k: i32| if k % 2 == 0 { 1.0 } else { factor };
        let others = (0..12).map(|k| run("s", "box3d", 30.0 + f64::from(k), cost(k), 0.1));
        ladder("merev").into_iter().chain(others).collect()
    };
    let mut now = both(1.5);
    now.iter_mut().filter(|r| r.engine == "merev").for_each(|r| r.cost_ms = r.cost_ms.map(|c| 1.4 * c));
    let findings = find(&base(both(1.0)), &now, 1.25);
    assert_eq!((findings.pace, findings.noise), (1.5, 1.5));
    assert!(!findings.is_regression(&OPTIONS));
}

#[test]
fn a_few_runs_that_take_too_long_are_chance() {
    let mut now = ladder("merev");
    (now[2].outcome, now[2].error) = (Outcome::Timeout, None);
    let findings = find(&base(ladder("merev")), &now, 1.25);
    assert_eq!((findings.newly_late, findings.is_regression(&OPTIONS)), (1, false));
    assert!(report::text(&findings, &OPTIONS, &(None, None)).contains("Took too long"));
    let many = |outcome| -> Vec<WorkPrecision> {
        let late = |k: i32| WorkPrecision { outcome, ..run("s", "merev", 61.0 + f64::from(k), 1.0, 0.1) };
        (0..4).map(late).collect()
    };
    let findings = find(&base(many(Outcome::Ok)), &many(Outcome::Timeout), 1.25);
    assert!(findings.is_regression(&OPTIONS));
}

#[test]
fn errors_that_grow_and_runs_that_fail_are_regressions() {
    let changed = |at: usize, change: &dyn Fn(&mut WorkPrecision)| {
        let mut now = ladder("merev");
        change(&mut now[at]);
        find(&base(ladder("merev")), &now, 1.25)
    };
    // The default is the rung of 60 Hz.
    let findings = changed(1, &|r| r.error = Some(1.2 * 0.3 / 60.0));
    assert!(findings.is_regression(&OPTIONS));
    let findings = changed(2, &|r| (r.outcome, r.error) = (Outcome::Nan, None));
    assert!(findings.is_regression(&OPTIONS));
    let findings = changed(1, &|r| r.error = Some(f64::from_bits((0.3_f64 / 60.0).to_bits() + 1)));
    assert_eq!((findings.same, findings.is_regression(&OPTIONS)), (2, false));
    assert!(findings.is_regression(&Options { exact: true, ..OPTIONS }));
    let text = report::text(&findings, &OPTIONS, &(None, None));
    assert!(text.contains("2 have the same outcome") && text.contains("did not get worse"), "{text}");
}

#[test]
fn the_committed_corners_can_be_read() {
    let directory = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("baseline");
    assert!(baseline::corners(&directory).unwrap().contains_key("*"));
}

#[test]
fn what_is_accepted_compares_as_the_same() {
    let root = std::env::temp_dir().join(format!("merev-compare-{}", std::process::id()));
    let (now, kept) = (root.join("now"), root.join("kept"));
    std::fs::create_dir_all(&kept).unwrap();
    let mut log = records::Log::open(&now, true).unwrap();
    ladder("merev").into_iter().for_each(|r| log.push(r).unwrap());
    std::fs::write(kept.join("corners.csv"), "scene,cost_ms,error\n*,1000,1\n").unwrap();
    assert!(super::run(&now, &kept, &OPTIONS).unwrap_err().contains("--accept"));
    accept(&now, &kept).unwrap();
    let (text, is_worse) = super::run(&now, &kept, &Options { exact: true, ..OPTIONS }).unwrap();
    assert!(!is_worse && text.contains("3 runs are in both; 3 have"), "{text}");
    std::fs::remove_dir_all(&root).unwrap();
}
