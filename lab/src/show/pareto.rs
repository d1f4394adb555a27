//! The Pareto front: the points that no other point beats in both cost and error.

/// The front of points (cost, error), by rising cost and falling error. Points that are not finite are left out; of
/// equal points one stays.
pub fn front(points: impl IntoIterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut all: Vec<(f64, f64)> =
        points.into_iter().filter(|(cost, error)| cost.is_finite() && error.is_finite()).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut best = f64::INFINITY;
    all.retain(|&(_, error)| {
        let wins = error < best;
        best = best.min(error);
        wins
    });
    all
}

/// The least cost on a front at which the error is at most `tolerance`.
pub fn cost_of(front: &[(f64, f64)], tolerance: f64) -> Option<f64> {
    front.iter().find(|(_, error)| *error <= tolerance).map(|(cost, _)| *cost)
}

/// The least error on a front at a cost of at most `budget`.
pub fn error_within(front: &[(f64, f64)], budget: f64) -> Option<f64> {
    front.iter().rev().find(|(cost, _)| *cost <= budget).map(|(_, error)| *error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_what_nothing_beats() {
        let points = [
            (4.0, 1.0),
            (1.0, 9.0),
            (2.0, 3.0),
            (3.0, 3.0),
            (2.0, 5.0),
            (5.0, 2.0),
            (1.0, 9.0),
            (f64::NAN, 0.0),
        ];
        let front = front(points);
        assert_eq!(front, [(1.0, 9.0), (2.0, 3.0), (4.0, 1.0)]);
        assert_eq!(cost_of(&front, 3.0), Some(2.0));
        assert_eq!(cost_of(&front, 2.9), Some(4.0));
        assert_eq!(cost_of(&front, 0.5), None);
        assert_eq!(error_within(&front, 3.9), Some(3.0));
        assert_eq!(error_within(&front, 0.9), None);
    }

    #[test]
    fn nothing_has_no_front() {
        assert_eq!(front([]), []);
        assert_eq!(front([(1.0, f64::INFINITY), (f64::NAN, f64::NAN)]), []);
    }
}
