//! Every method of the narrow phase on a million seeded pairs of the kinds that break such methods, against oracles
//! in double: `cargo bench --bench fuzz_pairs -- [--quick | --count N]`. Writes docs/measured/narrow_phase_errors.csv,
//! in which it replaces the rows of this precision. Exits with 1 where a result was not sane.

#[path = "support/fuzz.rs"]
mod fuzz;
mod support;

use std::time::Instant;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let given = arguments.iter().position(|a| a == "--count").and_then(|i| arguments.get(i + 1));
    let quick = arguments.iter().any(|a| a == "--quick");
    let count = given.map_or(if quick { 20_000 } else { 1_000_000 }, |n| n.parse().expect("a number"));
    let start = Instant::now();
    let tallies = fuzz::run(2024, count);
    let rows = fuzz::rows(&tallies);
    println!("{}", fuzz::HEAD);
    rows.iter().for_each(|r| println!("{r}"));
    let bad: usize = tallies.iter().flatten().map(|t| t.bad).sum();
    let limit: usize = tallies[..4].iter().flatten().map(|t| t.statuses[5]).sum();
    println!(
        "{count} pairs in {:.0} s, {bad} bad, {limit} ended at the limit",
        start.elapsed().as_secs_f64()
    );
    support::write_csv("narrow_phase_errors.csv", fuzz::HEAD, &rows, 1);
    if bad > 0 {
        std::process::exit(1);
    }
}
