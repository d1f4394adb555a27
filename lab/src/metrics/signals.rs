//! Events in sampled signals.

/// When a signal changes its sign, by the cubic through the four samples around it. A rise counts, or a fall, or both.
pub fn crossings(times: &[f64], values: &[f64], rise: bool, fall: bool) -> Vec<f64> {
    let mut found = Vec::new();
    for k in 1..values.len() {
        let (a, b) = (values[k - 1], values[k]);
        let is_rise = a < 0.0 && b >= 0.0;
        let is_fall = a > 0.0 && b <= 0.0;
        if !(is_rise && rise || is_fall && fall) {
            continue;
        }
        let from = k.saturating_sub(2);
        let to = (k + 2).min(values.len());
        let (t, v) = (&times[from..to], &values[from..to]);
        let (mut low, mut high) = (times[k - 1], times[k]);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if (lagrange(t, v, middle) > 0.0) == (a > 0.0) { low = middle } else { high = middle }
        }
        found.push(0.5 * (low + high));
    }
    found
}

/// The polynomial through these points.
fn lagrange(t: &[f64], v: &[f64], at: f64) -> f64 {
    (0..t.len())
        .map(|i| {
            let weight: f64 = (0..t.len()).filter(|&j| j != i).map(|j| (at - t[j]) / (t[i] - t[j])).product();
            v[i] * weight
        })
        .sum()
}

/// The heights at which a thrown body turns round under gravity `g`, from its height and its upward speed: what is
/// read there does not depend on when in a step velocities are meant.
pub fn apexes(heights: &[f64], speeds: &[f64], g: f64) -> Vec<f64> {
    (1..heights.len())
        .filter(|&k| speeds[k - 1] > 0.0 && speeds[k] <= 0.0)
        .map(|k| {
            let rise = |i: usize| heights[i] + speeds[i] * speeds[i] / (2.0 * g);
            // From the sample that is nearer to standing still.
            if speeds[k - 1].abs() < speeds[k].abs() { rise(k - 1) } else { rise(k) }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_crosses_where_it_should() {
        let times: Vec<f64> = (0..200).map(|k| 0.05 * f64::from(k)).collect();
        let values: Vec<f64> = times.iter().map(|&t| libm::sin(t + 0.5)).collect();
        let found = crossings(&times, &values, false, true);
        let exact = std::f64::consts::PI - 0.5;
        assert!((found[0] - exact).abs() < 1e-7, "{found:?}");
        assert_eq!(crossings(&times, &values, true, true).len(), 3);
    }

    #[test]
    fn a_throw_has_its_apex() {
        let at = |t: f64| (3.0 * t - 5.0 * t * t, 3.0 - 10.0 * t);
        let (heights, speeds): (Vec<f64>, Vec<f64>) = (0..10).map(|k| at(0.07 * f64::from(k))).unzip();
        let found = apexes(&heights, &speeds, 10.0);
        assert!(found.len() == 1 && (found[0] - 0.45).abs() < 1e-14, "{found:?}");
    }
}
