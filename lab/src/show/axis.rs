//! Axes: where a value lies, and which values are written beside.

use super::svg::{Anchor, FAINT, GRID, INK, Svg};

/// A logarithmic axis from `low` to `high` (both above 0), drawn from one pixel to another.
#[derive(Clone, Copy, Debug)]
pub struct LogAxis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl LogAxis {
    /// An axis on which all the values have a place; values that are not finite or not above 0 do not count. At
    /// least a decade is shown, with a margin on both sides.
    pub fn around(values: impl IntoIterator<Item = f64>, from: f64, to: f64) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values {
            if value.is_finite() && value > 0.0 {
                low = low.min(libm::log10(value));
                high = high.max(libm::log10(value));
            }
        }
        if low > high {
            (low, high) = (-1.0, 1.0);
        }
        let margin = 0.06 * (high - low) + 0.05;
        let missing = (1.0 - (high - low) - 2.0 * margin).max(0.0);
        Self { low: low - margin - missing / 2.0, high: high + margin + missing / 2.0, from, to }
    }

    pub fn new(low: f64, high: f64, from: f64, to: f64) -> Self {
        Self { low: libm::log10(low), high: libm::log10(high), from, to }
    }

    /// The pixel of a value; values beyond an end lie at that end.
    pub fn pixel(&self, value: f64) -> f64 {
        let share = (libm::log10(value.max(1e-300)) - self.low) / (self.high - self.low);
        let share = if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) };
        self.from + share * (self.to - self.from)
    }

    /// The value at a pixel.
    pub fn value(&self, pixel: f64) -> f64 {
        libm::exp10(self.low + (pixel - self.from) / (self.to - self.from) * (self.high - self.low))
    }

    pub fn holds(&self, value: f64) -> bool {
        value > 0.0 && (self.low..=self.high).contains(&libm::log10(value))
    }

    /// Values to be written: decades, every second or third where there are many, 1-2-5 where there are few.
    pub fn ticks(&self) -> Vec<f64> {
        let decades = self.high - self.low;
        let apart = (decades / 7.0).ceil().max(1.0) as i32;
        let mut all = Vec::new();
        for k in self.low.floor() as i32..=self.high.ceil() as i32 {
            if k.rem_euclid(apart) != 0 {
                continue;
            }
            let factors: &[u32] = if decades < 2.5 { &[1, 2, 5] } else { &[1] };
            all.extend(factors.iter().map(|f| round(*f, k)).filter(|v| self.holds(*v)));
        }
        all
    }
}

fn round(factor: u32, exponent: i32) -> f64 {
    // Through text, so that 5e-6 is the number that is written so.
    format!("{factor}e{exponent}").parse().unwrap_or(1.0)
}

/// A value as it stands at a tick: 1e-6, 0.02, 500.
pub fn label(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) {
        let text = format!("{value:.6}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:e}")
    }
}

/// A value with three significant digits.
pub fn short(value: f64) -> String {
    if !value.is_finite() {
        return "–".into();
    }
    let size = value.abs();
    if size == 0.0 {
        "0".into()
    } else if (1e-3..1e5).contains(&size) {
        let digits = (2 - libm::floor(libm::log10(size)) as i32).clamp(0, 5) as usize;
        let text = format!("{value:.digits$}");
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        let text = format!("{value:.1e}");
        text.replace(".0e", "e")
    }
}

/// The frame of a plot: grid lines, numbers and the names of the axes. `area` is x, y, width, height.
pub fn frame(svg: &mut Svg, area: [f64; 4], x: &[(f64, String)], y: &[(f64, String)], names: [&str; 2]) {
    let [left, top, width, height] = area;
    let bottom = top + height;
    for (px, text) in x {
        svg.line([*px, top, *px, bottom], GRID, 1.0, "", "grid");
        svg.text(*px, bottom + 16.0, Anchor::Middle, 12.5, FAINT, text);
    }
    for (py, text) in y {
        svg.line([left, *py, left + width, *py], GRID, 1.0, "", "grid");
        svg.text(left - 6.0, py + 4.0, Anchor::End, 12.5, FAINT, text);
    }
    svg.line([left, bottom, left + width, bottom], FAINT, 1.0, "", "axis");
    svg.line([left, top, left, bottom], FAINT, 1.0, "", "axis");
    svg.text(left + width / 2.0, bottom + 34.0, Anchor::Middle, 13.0, INK, names[0]);
    svg.upright_text(14.0, top + height / 2.0, 13.0, names[1]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_has_a_finite_place() {
        let axis = LogAxis::around([f64::NAN, 0.0, -1.0, 3.0, 300.0, f64::INFINITY], 0.0, 100.0);
        for value in [3.0, 300.0, 0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!((0.0..=100.0).contains(&axis.pixel(value)), "{value}: {}", axis.pixel(value));
        }
        assert!(axis.pixel(3.0) > 0.0 && axis.pixel(300.0) < 100.0);
        assert!((axis.value(axis.pixel(7.0)) - 7.0).abs() < 1e-12);
        let empty = LogAxis::around([], 0.0, 100.0);
        assert!(empty.ticks().len() >= 2);
        let one = LogAxis::around([5.0], 0.0, 100.0);
        assert!((one.pixel(5.0) - 50.0).abs() < 1e-9);
    }

    #[test]
    fn ticks_are_round_and_few() {
        assert_eq!(LogAxis::new(0.9, 110.0, 0.0, 1.0).ticks(), [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0]);
        let wide = LogAxis::new(1e-12, 10.0, 0.0, 1.0).ticks();
        assert!(wide.len() >= 5 && wide.len() <= 8, "{wide:?}");
        let small: Vec<String> =
            LogAxis::new(1.5e-6, 6e-6, 0.0, 1.0).ticks().into_iter().map(label).collect();
        assert_eq!(small, ["2e-6", "5e-6"]);
        assert_eq!([label(1e-6), label(0.02), label(500.0)], ["1e-6", "0.02", "500"]);
        assert_eq!(
            [short(0.0123456), short(1235.4), short(1.2345e-7), short(0.0)],
            ["0.0123", "1235", "1.2e-7", "0"]
        );
    }
}
