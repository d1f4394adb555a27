//! What an engine looks like: its colour and its mark are the same in all charts. The colours are those of Okabe
//! and Ito, told apart with any kind of colour blindness; the marks tell apart what is printed in grey.

use super::svg::num;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    Disc,
    Diamond,
    Square,
    Triangle,
    Wedge,
    Pentagon,
    Cross,
}

#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// As records name it; also its class in pictures.
    pub engine: &'static str,
    /// As readers know it.
    pub title: &'static str,
    pub colour: &'static str,
    /// On a dark page.
    pub dark: &'static str,
    pub mark: Mark,
}

/// The engines that have a look of their own, in the order of legends.
pub const LOOKS: [Look; 7] = [
    Look { engine: "merev", title: "merev", colour: "#0072b2", dark: "#4aa8e0", mark: Mark::Disc },
    Look { engine: "merev_c", title: "merev (C)", colour: "#56b4e9", dark: "#8fd0f5", mark: Mark::Diamond },
    Look { engine: "box3d", title: "Box3D", colour: "#d55e00", dark: "#f08a3c", mark: Mark::Square },
    Look { engine: "rapier", title: "Rapier", colour: "#009e73", dark: "#2fc79b", mark: Mark::Triangle },
    Look { engine: "bullet", title: "Bullet", colour: "#b8589a", dark: "#dd8fc2", mark: Mark::Wedge },
    Look { engine: "ode", title: "ODE", colour: "#c98a00", dark: "#efb83a", mark: Mark::Pentagon },
    Look { engine: "mujoco", title: "MuJoCo", colour: "#4d4d4d", dark: "#c4c4c4", mark: Mark::Cross },
];

const OTHER: Look =
    Look { engine: "other", title: "", colour: "#7a7a7a", dark: "#a8a8a8", mark: Mark::Pentagon };

pub fn look(engine: &str) -> Look {
    LOOKS.into_iter().find(|look| look.engine == engine).unwrap_or(OTHER)
}

/// An engine's name for readers.
pub fn title(engine: &str) -> String {
    let look = look(engine);
    if look.title.is_empty() { engine.to_owned() } else { look.title.to_owned() }
}

/// Where an engine stands in legends and tables: those with a look first, in their order.
pub fn rank(engine: &str) -> (usize, &str) {
    (LOOKS.iter().position(|look| look.engine == engine).unwrap_or(LOOKS.len()), engine)
}

impl Mark {
    /// Its outline around (x, y), of about the same area for all marks.
    pub fn path(self, x: f64, y: f64, r: f64) -> String {
        let polygon = |corners: &[(f64, f64)]| {
            let mut d = String::new();
            for (k, (dx, dy)) in corners.iter().enumerate() {
                d += if k == 0 { "M" } else { "L" };
                d += &format!("{} {}", num(x + r * dx), num(y + r * dy));
            }
            d + "Z"
        };
        match self {
            Self::Disc => {
                let (r, d) = (num(r), num(2.0 * r));
                format!(
                    "M{} {}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0 -{d} 0Z",
                    num(x - r.parse::<f64>().unwrap_or(0.0)),
                    num(y)
                )
            }
            Self::Diamond => polygon(&[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)]),
            Self::Square => polygon(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)]),
            Self::Triangle => polygon(&[(0.0, -1.25), (1.15, 0.8), (-1.15, 0.8)]),
            Self::Wedge => polygon(&[(0.0, 1.25), (1.15, -0.8), (-1.15, -0.8)]),
            Self::Pentagon => {
                polygon(&[(0.0, -1.15), (1.09, -0.36), (0.68, 0.93), (-0.68, 0.93), (-1.09, -0.36)])
            }
            Self::Cross => polygon(&[
                (-0.4, -1.2),
                (0.4, -1.2),
                (0.4, -0.4),
                (1.2, -0.4),
                (1.2, 0.4),
                (0.4, 0.4),
                (0.4, 1.2),
                (-0.4, 1.2),
                (-0.4, 0.4),
                (-1.2, 0.4),
                (-1.2, -0.4),
                (-0.4, -0.4),
            ]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_engines_look_alike() {
        for (k, a) in LOOKS.iter().enumerate() {
            for b in &LOOKS[k + 1..] {
                assert!(a.colour != b.colour && a.dark != b.dark && a.mark != b.mark, "{a:?} {b:?}");
            }
        }
        assert_eq!((title("box3d"), title("newton")), ("Box3D".to_owned(), "newton".to_owned()));
    }
}
