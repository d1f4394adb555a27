//! Which settings a method is run with: rate × sub-steps × iterations, or an accuracy.

use crate::case::Case;
use crate::engines::{Maker, Method, Setting};

/// A setting, and whether it is the method as it comes.
pub type Rung = (Setting, bool);

/// As every engine comes: 60 steps a second, 4 sub-steps, its own number of sweeps.
pub fn default_setting() -> Setting {
    Setting::new(60.0, 4)
}

/// From little work to much; the default is always among them.
pub fn rungs(case: &Case, maker: &Maker, method: &Method, is_first: bool, quick: bool) -> Vec<Rung> {
    let with = |rate, sub_steps, iterations| Setting { iterations, ..Setting::new(rate, sub_steps) };
    let plain = |list: &[(f64, u32)]| list.iter().map(|&(r, s)| Setting::new(r, s)).collect::<Vec<_>>();
    let is_exact = matches!(method.solver, "lemke" | "dantzig" | "proximal_admm");
    let mut all = if maker.key == "merev_c" {
        plain(&[(60.0, 4)])
    } else if quick {
        if is_first { plain(&[(60.0, 1), (60.0, 4), (240.0, 4)]) } else { plain(&[(60.0, 4)]) }
    } else if is_exact {
        plain(&[(60.0, 1), (60.0, 4), (240.0, 1), (240.0, 4), (960.0, 1)])
    } else if method.iterates && maker.key == "merev" {
        vec![
            with(60.0, 4, 0),
            with(60.0, 4, 4),
            with(60.0, 4, 20),
            with(60.0, 4, 100),
            with(240.0, 1, 20),
            with(240.0, 4, 20),
            with(960.0, 1, 20),
            with(960.0, 4, 50),
        ]
    } else if !is_first {
        plain(&[(30.0, 1), (60.0, 1), (60.0, 4), (240.0, 4), (960.0, 4)])
    } else {
        let mut all = plain(&[
            (30.0, 4),
            (60.0, 1),
            (60.0, 2),
            (60.0, 4),
            (60.0, 8),
            (60.0, 16),
            (120.0, 4),
            (240.0, 1),
            (240.0, 4),
            (480.0, 4),
            (960.0, 4),
            (1920.0, 4),
        ]);
        if method.iterates {
            all.extend([with(60.0, 4, 4), with(60.0, 4, 20)]);
        }
        all
    };
    if is_first && maker.key == "merev" {
        let accuracies: &[f64] = if quick { &[1e-3] } else { &[1e-2, 1e-3, 1e-4, 1e-5] };
        for (&accuracy, sub_steps) in accuracies.iter().flat_map(|a| [(a, 1), (a, 4)]) {
            all.push(Setting { accuracy: Some(accuracy), ..Setting::new(60.0, sub_steps) });
        }
    }
    all.retain(|s| s.rate <= case.most_rate);
    all.sort_by(|a, b| work(a).total_cmp(&work(b)));
    all.into_iter().map(|s| (s, s == default_setting())).collect()
}

/// What a setting costs, roughly: sweeps a second. What an accuracy costs depends on the scene; a second-order method
/// would take so many.
pub fn work(s: &Setting) -> f64 {
    let sweeps = s.rate * f64::from(s.sub_steps) * f64::from(s.iterations.max(1));
    s.accuracy.map_or(sweeps, |accuracy| sweeps / accuracy.sqrt())
}
