//! Performance profiles (Dolan and Moré 2002) and data profiles (Moré and Wild 2009): how often which engine is how
//! good, over all scenes.
//!
//! A profile tells which engine leads; how the others rank among themselves depends on the leader, so read those in
//! pairs (Gould and Scott 2016).

/// The errors that profiles are drawn for: looks right, engineering, reference.
pub const TOLERANCES: [f64; 3] = [2e-2, 1e-3, 1e-6];

/// The budgets of data profiles: milliseconds a frame.
pub const BUDGETS_MS: [f64; 4] = [0.5, 2.0, 8.0, 16.0];

/// Frames a second that a budget is for.
pub const FRAMES: f64 = 60.0;

/// A curve that rises in steps: where it rises, and to what share of all scenes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Steps(pub Vec<(f64, f64)>);

impl Steps {
    /// The share of `total` scenes with a value up to x, for every x at which it changes.
    fn new(mut values: Vec<f64>, total: usize) -> Self {
        values.sort_by(f64::total_cmp);
        let mut steps: Vec<(f64, f64)> = Vec::new();
        for (k, x) in values.into_iter().enumerate() {
            let share = (k + 1) as f64 / total.max(1) as f64;
            match steps.last_mut() {
                Some(last) if last.0 == x => last.1 = share,
                _ => steps.push((x, share)),
            }
        }
        Self(steps)
    }

    /// The share at x.
    pub fn at(&self, x: f64) -> f64 {
        self.0.iter().rev().find(|step| step.0 <= x).map_or(0.0, |step| step.1)
    }
}

/// The performance profile of each engine. `costs[p][s]` is the least cost at which engine s solves scene p; a step
/// (τ, share) says in which share of the scenes engine s costs at most τ times what the best engine costs there.
///
/// Scenes that nobody solves count for all engines as not solved.
pub fn performance(costs: &[Vec<Option<f64>>], engines: usize) -> Vec<Steps> {
    let ratio = |row: &Vec<Option<f64>>, engine: usize| {
        let best = row.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        Some(row.get(engine).copied()?? / best)
    };
    let curve = |s| Steps::new(costs.iter().filter_map(|row| ratio(row, s)).collect(), costs.len());
    (0..engines).map(curve).collect()
}

/// The data profile of each engine: the share of scenes that engine s solves within a cost.
pub fn data(costs: &[Vec<Option<f64>>], engines: usize) -> Vec<Steps> {
    let curve =
        |s: usize| Steps::new(costs.iter().filter_map(|row| row.get(s).copied()?).collect(), costs.len());
    (0..engines).map(curve).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three engines on four scenes; the last scene is solved by nobody.
    fn costs() -> Vec<Vec<Option<f64>>> {
        vec![
            vec![Some(1.0), Some(2.0), None],
            vec![Some(3.0), Some(1.0), Some(4.0)],
            vec![Some(2.0), Some(2.0), Some(2.0)],
            vec![None, None, None],
        ]
    }

    #[test]
    fn performance_profiles_are_those_worked_out_by_hand() {
        let all = performance(&costs(), 3);
        assert_eq!(all[0].0, [(1.0, 0.5), (3.0, 0.75)]);
        assert_eq!(all[1].0, [(1.0, 0.5), (2.0, 0.75)]);
        assert_eq!(all[2].0, [(1.0, 0.25), (4.0, 0.5)]);
        assert_eq!((all[0].at(0.5), all[0].at(1.0), all[0].at(2.9), all[0].at(3.0)), (0.0, 0.5, 0.5, 0.75));
        assert_eq!(all[2].at(f64::INFINITY), 0.5);
    }

    #[test]
    fn data_profiles_are_those_worked_out_by_hand() {
        let all = data(&costs(), 3);
        assert_eq!(all[0].0, [(1.0, 0.25), (2.0, 0.5), (3.0, 0.75)]);
        assert_eq!(all[1].0, [(1.0, 0.25), (2.0, 0.75)]);
        assert_eq!(all[2].0, [(2.0, 0.25), (4.0, 0.5)]);
    }

    #[test]
    fn no_scenes_have_level_profiles() {
        assert_eq!(performance(&[], 2), vec![Steps::default(); 2]);
        assert_eq!(data(&[], 1)[0].at(1e9), 0.0);
    }
}
