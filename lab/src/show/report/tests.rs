use super::*;
use crate::records::{Check, Meta, Outcome, Race, Stability, WorkPrecision};
use crate::show::samples::{run, scene};
use crate::show::settings::settings;

/// Records of three scenes, with whatever may go wrong in them.
pub fn sample() -> Data {
    let mut runs = Vec::new();
    for (k, name) in ["a1", "b2 <x>", "c3"].iter().enumerate() {
        for (engine, factor) in [("merev", 1.0), ("box3d", 3.0), ("newton", 0.5)] {
            for hz in [30.0, 60.0, 120.0] {
                runs.push(run(name, engine, hz, factor * hz / 60.0, 1e-2 * (k + 1) as f64 / (factor * hz)));
            }
        }
        runs.push(WorkPrecision {
            outcome: Outcome::Exploded,
            error: None,
            ..run(name, "box3d", 15.0, 0.1, 0.0)
        });
        runs.push(WorkPrecision { error: Some(f64::NAN), ..run(name, "rapier", 15.0, f64::INFINITY, 0.0) });
    }
    let stability = Stability {
        scene: "stack".into(),
        engine: "merev".into(),
        method: "</script>".into(),
        stressor: "height".into(),
        unit: "m".into(),
        harder: "larger".into(),
        survived: Some(3.0),
        failed: None,
        outcome: Outcome::Ok,
    };
    let race = Race {
        scene: "pile".into(),
        engine: "merev".into(),
        bodies: 5,
        steps: 7,
        median_ms: 1.0,
        minimum_ms: f64::NAN,
        first_ms: 2.0,
        sagged_m: f64::NAN,
        sideways_m: 0.0,
        overlap_m: 0.0,
        joint_gap_m: f64::INFINITY,
        energy_change: 0.0,
        residual: 0.0,
    };
    let check = Check { check: "A2".into(), engine: "ode".into(), value: f64::NAN, bound: 1.0, pass: false };
    Data {
        scenes: ["a1", "b2 <x>", "c3", "d4"].map(scene).into(),
        settings: settings(&runs),
        secondary: vec![],
        attribution: vec![],
        stability: vec![stability],
        race: vec![race],
        checks: vec![check],
        meta: Some(Meta { machine: "<&>".into(), ..Meta::default() }),
    }
}

#[test]
fn the_page_has_every_scene_and_refers_to_nothing_else() {
    let page = page(&sample());
    for name in ["a1", "b2 &lt;x&gt;", "c3", "d4"] {
        assert!(page.contains(&format!("<h3>{name}</h3>")), "{name}");
    }
    assert_eq!(page.matches("class=\"chart\"").count(), 3);
    for reference in ["src=", "href=\"http", "@import", "url("] {
        assert!(!page.contains(reference), "{reference}");
    }
    assert!(!page.contains("NaN") && !page.contains("{{"));
    assert_eq!(page.matches("<script").count(), 2);
}

#[test]
fn pictures_in_the_page_are_well_formed() {
    let page = page(&sample());
    let pictures: Vec<&str> =
        page.split("<svg").skip(1).map(|rest| rest.split_once("</svg>").unwrap().0).collect();
    assert!(pictures.len() > 10);
    for picture in pictures {
        roxmltree::Document::parse(&format!("<svg{picture}</svg>")).unwrap();
    }
}

#[test]
fn the_data_of_the_page_are_json_with_a_line_a_mark() {
    let data = sample();
    let page = page(&data);
    let text = page.split_once("id=\"data\">").unwrap().1.split_once("</script>").unwrap().0;
    let json: serde_json::Value = serde_json::from_str(text).unwrap();
    assert_eq!(json["runs"].as_array().unwrap().len(), data.settings.len());
    assert_eq!(json["runs"][0]["lines"][0], "error 3.3e-4");
}

#[test]
fn where_merev_loses_is_said() {
    let page = page(&sample());
    // At error 2e-2 everybody solves every scene at the lowest rate, and newton at half the cost.
    assert!(page.contains("<span class=\"lose\">loses 3</span>, even 0"));
    assert!(page.contains("a1 (newton ahead by 2×)"));
    assert!(page.contains("Failed:</span> A2"));
}

#[test]
fn nothing_measured_is_a_page_as_well() {
    let empty = Data {
        scenes: vec![],
        settings: vec![],
        secondary: vec![],
        attribution: vec![],
        stability: vec![],
        race: vec![],
        checks: vec![],
        meta: None,
    };
    assert!(page(&empty).contains("<code>merev chart</code>"));
}
