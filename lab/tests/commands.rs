//! The commands as a user calls them, on little, and on every engine that was built in.

use std::path::{Path, PathBuf};
use std::process::Command;

fn merev(directory: &Path, words: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_merev"));
    command.args(words).arg("--out").arg(directory);
    if cfg!(feature = "peers") && words[0] != "report" {
        command.arg("--peers");
    }
    let output = command.output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{words:?}: {}\n{text}", String::from_utf8_lossy(&output.stderr));
    text
}

fn fresh(name: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&directory);
    directory
}

fn lines(directory: &Path, file: &str) -> Vec<String> {
    let text = std::fs::read_to_string(directory.join(file)).unwrap();
    text.lines().map(str::to_owned).collect()
}

/// Two processes write the same rows in the same order as one does, but for costs, and leave nothing behind.
#[test]
fn a_chart_is_the_same_in_one_process_and_in_two() {
    let (one, two) = (fresh("chart-1"), fresh("chart-2"));
    merev(&one, &["chart", "--quick", "--only", "b1_bouncing_ball", "--jobs", "1"]);
    merev(&two, &["chart", "--quick", "--only", "b1_bouncing_ball", "--jobs", "2"]);
    let errors = |directory: &Path| -> Vec<Vec<String>> {
        let rows = lines(directory, "work_precision.csv");
        let cells = |row: &String| row.split(',').map(str::to_owned).collect::<Vec<_>>();
        // Up to the error; then come the cost and whether the run was resumed.
        rows.iter().map(|row| cells(row)[..13].to_vec()).collect()
    };
    assert_eq!(errors(&one), errors(&two));
    assert!(errors(&one).len() > 10);
    assert_eq!(lines(&one, "attribution.csv"), lines(&two, "attribution.csv"));
    assert!(!two.join("claims").exists());
    let checks = lines(&one, "checks.csv");
    assert!(checks.len() > 8 && checks[1..].iter().all(|row| row.ends_with("true")), "{checks:?}");
    let page = std::fs::read_to_string(two.join("report.html")).unwrap();
    assert!(page.contains("b1_bouncing_ball"));
}

#[test]
fn stability_finds_a_limit_and_goes_on_where_it_was() {
    let directory = fresh("stability");
    let first = merev(&directory, &["stability", "--quick", "--only", "grip"]);
    assert!(first.contains("time step"), "{first}");
    let rows = lines(&directory, "stability.csv");
    merev(&directory, &["stability", "--quick", "--only", "grip"]);
    assert_eq!(lines(&directory, "stability.csv"), rows);
}
