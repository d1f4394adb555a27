//! The measured order of a method: the slope of log error over log step.

use super::settings::{FLOOR, Setting};

/// The order from points (step, error), or nothing with fewer than three that tell.
///
/// Errors fall with the step until round-off, or what else does not depend on the step, is all that is left. So the
/// fit ends at the first point, from the coarse end, that is within twice the smallest error; where that leaves
/// fewer than three, the error hardly depends on the step, and all points count: the order is near 0 then.
pub fn order(points: impl IntoIterator<Item = (f64, f64)>) -> Option<f64> {
    let good = |&(h, e): &(f64, f64)| h > 0.0 && h.is_finite() && e > FLOOR && e.is_finite();
    let mut points: Vec<(f64, f64)> = points.into_iter().filter(good).collect();
    points.sort_by(|a, b| b.0.total_cmp(&a.0));
    let least = points.iter().map(|p| p.1).fold(f64::INFINITY, f64::min);
    let falling = points.iter().position(|p| p.1 <= 2.0 * least).map_or(0, |at| at + 1);
    if falling >= 3 {
        points.truncate(falling);
    }
    if points.len() < 3 { None } else { slope(&points) }
}

/// The slope of a line through (log x, log y) with the least squares.
fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> = points.iter().map(|&(x, y)| (libm::log10(x), libm::log10(y))).collect();
    let n = logs.len() as f64;
    let mean_x = logs.iter().map(|p| p.0).sum::<f64>() / n;
    let mean_y = logs.iter().map(|p| p.1).sum::<f64>() / n;
    let xy: f64 = logs.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum();
    let xx: f64 = logs.iter().map(|p| (p.0 - mean_x) * (p.0 - mean_x)).sum();
    // Steps that are all the same say nothing.
    (xx > 1e-6).then(|| xy / xx)
}

/// The order of a method from its ladder of steps: the settings that differ from its default in the rate alone or,
/// without a default, those of the longest ladder.
pub fn of_method<'a>(settings: impl IntoIterator<Item = &'a Setting>) -> Option<f64> {
    // Sub-steps, sweeps and accuracy; whether the default is on it; points.
    type Ladder = ((u32, u32, Option<f64>), bool, Vec<(f64, f64)>);
    let mut ladders: Vec<Ladder> = Vec::new();
    for setting in settings {
        let key = (setting.sub_steps, setting.iterations, setting.accuracy);
        let at = ladders.iter().position(|ladder| ladder.0 == key).unwrap_or_else(|| {
            ladders.push((key, false, Vec::new()));
            ladders.len() - 1
        });
        ladders[at].1 |= setting.is_default;
        ladders[at].2.extend(setting.error.map(|error| (setting.step(), error)));
    }
    // Sorting keeps the order of equals, so the result does not depend on anything but the rows.
    ladders.sort_by_key(|(_, is_default, points)| (!is_default, std::cmp::Reverse(points.len())));
    ladders.into_iter().find_map(|(_, _, points)| order(points))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_of_a_power_is_its_exponent() {
        let second = [0.1, 0.05, 0.025, 0.0125].map(|h| (h, 7.0 * h * h));
        assert!((order(second).unwrap() - 2.0).abs() < 1e-12);
        // By hand: logs (0, 0), (1, 1), (2, 3) of base 10 have the slope 3/2.
        let line = slope(&[(1.0, 1.0), (10.0, 10.0), (100.0, 1000.0)]).unwrap();
        assert!((line - 1.5).abs() < 1e-12);
    }

    #[test]
    fn the_floor_of_round_off_is_left_out() {
        let points = [(1.0, 1e-2), (0.1, 1e-4), (0.01, 1e-6), (1e-3, 9e-7), (1e-4, 1.1e-6), (1e-5, 8e-7)];
        assert!((order(points).unwrap() - 2.0).abs() < 1e-12);
    }

    #[test]
    fn a_level_error_has_order_zero() {
        let level = [(0.1, 0.31), (0.05, 0.3), (0.025, 0.3)];
        assert!(order(level).unwrap().abs() < 0.05);
    }

    #[test]
    fn too_few_points_have_no_order() {
        assert_eq!(order([(0.1, 1.0), (0.05, 0.5)]), None);
        assert_eq!(order([(0.1, 1.0), (0.1, 0.5), (0.1, 0.25)]), None);
        assert_eq!(order([(0.1, 1.0), (0.05, 0.0), (0.02, f64::NAN), (f64::NAN, 1.0)]), None);
    }
}
