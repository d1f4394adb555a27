//! The hypervolume of a front: one number that grows when an engine gets faster or more exact.

use super::settings::FLOOR;

/// The worst cost and error that still count. It stays as it is, or numbers of different days cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// CPU milliseconds for a simulated second.
    pub cost_ms: f64,
    pub error: f64,
}

/// The area, in decades of cost times decades of error, between the corner and a front by rising cost: what is
/// cheaper than the corner, more exact than it, and beaten by a point of the front.
pub fn hypervolume(front: &[(f64, f64)], corner: Corner) -> f64 {
    let mut area = 0.0;
    let mut above = corner.error;
    for &(cost, error) in front {
        let error = error.max(FLOOR);
        if cost > 0.0 && cost < corner.cost_ms && error < above {
            area += libm::log10(corner.cost_ms / cost) * libm::log10(above / error);
            above = error;
        }
    }
    area
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNER: Corner = Corner { cost_ms: 1000.0, error: 1.0 };

    #[test]
    fn areas_are_those_worked_out_by_hand() {
        let near = |front: &[(f64, f64)], expected: f64| {
            let area = hypervolume(front, CORNER);
            assert!((area - expected).abs() < 1e-12, "{front:?}: {area}");
        };
        near(&[(10.0, 0.01)], 4.0);
        // Two decades of cost by one of error, and one more decade of error at one decade of cost.
        near(&[(10.0, 0.1), (100.0, 0.01)], 3.0);
        near(&[], 0.0);
        near(&[(1.0, 2.0), (2000.0, 0.001)], 0.0);
        near(&[(1.0, 2.0), (100.0, 0.1)], 1.0);
    }

    #[test]
    fn an_exact_answer_counts_as_the_floor() {
        assert!((hypervolume(&[(100.0, 0.0)], CORNER) - 12.0).abs() < 1e-12);
    }
}
