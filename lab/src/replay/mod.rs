//! The replay page: one HTML file that needs nothing else, with the recorded poses inside.

mod base64;
mod pack;

use crate::programs::{Frame, Pose};
use pack::pack;
use std::fmt::Write;

const PAGE: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// What a body looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Look {
    /// Half side lengths [m].
    Box([f32; 3]),
    /// Radius [m].
    Sphere(f32),
}

/// Linear red, green, blue.
pub type Color = [f32; 3];

/// A recorded run, and how to look at it.
pub struct Recording<'a> {
    /// In the page's address.
    pub name: &'a str,
    /// On the button.
    pub title: &'a str,
    pub about: &'a str,
    /// Length of a step [s].
    pub dt: f64,
    pub bodies: Vec<(Look, Color)>,
    /// Static boxes: centre, half side lengths.
    pub fixed: Vec<([f32; 3], [f32; 3], Color)>,
    /// Height at which the ground is drawn [m].
    pub ground: f32,
    /// What the camera looks at [m].
    pub target: [f32; 3],
    /// From there [m].
    pub distance: f32,
    /// About the vertical, and above the horizon [rad].
    pub yaw: f32,
    pub pitch: f32,
    /// How far around the target things cast shadows [m].
    pub radius: f32,
    /// The poses at the start, and after every step.
    pub start: Vec<Pose>,
    pub frames: &'a [Frame],
}

/// The page.
pub fn page(recordings: &[Recording]) -> String {
    let scenes: Vec<String> = recordings.iter().map(json).collect();
    PAGE.replace("/*STYLE*/", STYLE)
        .replace("/*SCRIPT*/", SCRIPT)
        .replace("/*DATA*/", &format!("[{}]", scenes.join(",\n")))
}

/// A scene as the page's script reads it. Names and titles hold nothing that would have to be escaped.
fn json(r: &Recording) -> String {
    let list = |v: &[f32]| format!("{v:?}");
    let packed = pack(&r.start, r.frames, r.bodies.len());
    let mut out = String::new();
    let _ = write!(
        out,
        "{{\"name\":\"{}\",\"title\":\"{}\",\"about\":\"{}\",\"dt\":{},\"frames\":{},\"ground\":{},\"radius\":{},\
         \"camera\":{{\"target\":{},\"distance\":{},\"yaw\":{},\"pitch\":{}}},\"low\":{:?},\"step\":{:?},\"bodies\":[",
        r.name,
        r.title,
        r.about,
        r.dt,
        r.frames.len() + 1,
        r.ground,
        r.radius,
        list(&r.target),
        r.distance,
        r.yaw,
        r.pitch,
        packed.low,
        packed.step,
    );
    let bodies: Vec<String> = r
        .bodies
        .iter()
        .map(|(look, color)| match look {
            Look::Box(half) => format!("{{\"half\":{},\"color\":{}}}", list(half), list(color)),
            Look::Sphere(radius) => format!("{{\"radius\":{radius},\"color\":{}}}", list(color)),
        })
        .collect();
    let fixed: Vec<String> = r
        .fixed
        .iter()
        .map(|(at, half, color)| {
            format!("{{\"at\":{},\"half\":{},\"color\":{}}}", list(at), list(half), list(color))
        })
        .collect();
    let _ = write!(
        out,
        "{}],\"fixed\":[{}],\"data\":\"{}\"}}",
        bodies.join(","),
        fixed.join(","),
        base64::encode(&packed.bytes)
    );
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_asks_nobody_for_anything() {
        let page = page(&[]);
        assert!(
            !page.contains("http") && !page.contains("src=") && !page.contains("@import"),
            "it reaches out"
        );
        assert!(!page.contains("/*DATA*/") && !page.contains("/*SCRIPT*/") && !page.contains("/*STYLE*/"));
    }
}
