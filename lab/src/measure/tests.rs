use super::*;
use crate::case::Case;
use crate::scenes;

fn case(name: &str) -> Case {
    scenes::cases().into_iter().find(|c| c.name == name).expect("a case of this name")
}

fn try_default(case: &Case, maker: &Maker) -> Tried {
    let method = (maker.methods)()[0];
    try_case(case, maker, &method, &ladder::default_setting(), false, Duration::from_secs(20))
}

#[test]
fn names_are_unique_and_every_case_says_what_its_error_is() {
    let cases = scenes::cases();
    for (i, case) in cases.iter().enumerate() {
        assert!(cases[..i].iter().all(|c| c.name != case.name), "{}", case.name);
        assert!(!case.primary.is_empty() && !case.about.is_empty(), "{}", case.name);
        assert!(case.scale.0 > 0.0, "{}", case.name);
        assert!(case.name.starts_with(case.group.to_ascii_lowercase()), "{}", case.name);
    }
    for group in 'A'..='J' {
        assert!(cases.iter().any(|c| c.group == group), "{group}");
    }
}

/// Where something has to move, standing still is an error, and a large one.
#[test]
fn standing_still_is_seen() {
    let moving = [
        "a1_ballistic",
        "a2_stable_spin",
        "a3_tumbling",
        "a4_dzhanibekov",
        "a5_fast_slender",
        "b1_bouncing_ball",
        "b3_cradle",
        "b5_rod_05",
        "c1_slide",
        "c2_isotropy",
        "c3_slip_to_roll",
        "c4_sphere",
        "c5_rolling_plate",
        "c8_drag",
        "c8_drag_sliding",
        "c9_rod_low",
        "c9_rod",
        "c9_rod_paradox",
        "c9_tipping_box",
        "c12_tippe_top",
        "c13_euler_disc",
        "e6_squeezer",
        "e6_bricard",
        "e6_governor",
        "e7_spring_5_critical",
        "e9_robot_floats",
        "e9_robot_falls",
        "f4_ledge",
        "g7_yawing",
        "g7_rolling_prism",
        "i3_billiard",
        "j2_galton",
        "j3_hopper",
        "e1_pendulum_90",
        "e2_double_pendulum",
        "h1_far_5km",
        "h4_boost",
    ];
    for name in moving {
        let error = case(name).null_error().unwrap();
        assert!(error > 0.3, "{name}: {error}");
    }
    // The plate's error when nothing moves is that of a published "result" of two engines.
    let plate = case("c5_rolling_plate");
    let Trial::Run(scene, judge) = &plate.trial else { panic!("a run") };
    let verdict = judge(scene, &Track::null(scene, plate.duration));
    let squared = verdict.more.iter().find(|m| m.0 == "squared_error_m2_s2").unwrap().1;
    assert!((squared - 3.14497).abs() < 0.05, "{squared}");
}

/// Every adapter reads back what it was given, spins as it should, and does the same twice.
#[test]
fn adapters_pass_their_checks() {
    for maker in crate::engines::ALL {
        for (check, value, bound) in checks::of(maker) {
            assert!(value <= bound, "{}: {check}: {value} > {bound}", maker.name);
        }
    }
}

/// Both doors lead to the same room.
#[test]
fn c_and_rust_give_the_same_bits() {
    for name in [
        "b1_bouncing_ball",
        "c1_slide_fast",
        "c12_tippe_top",
        "e6_squeezer",
        "e3_chain_10",
        "e7_spring_20",
        "c4_prism_16",
        "e8_cantilever",
    ] {
        let case = case(name);
        let errors: Vec<_> = ["merev", "merev_c"]
            .into_iter()
            .map(|key| try_default(&case, crate::engines::ALL.iter().find(|m| m.key == key).unwrap()).error)
            .collect();
        assert!(errors[0].is_some() && errors[0] == errors[1], "{name}: {errors:?}");
    }
}

/// Two runs give the same error to the last bit.
#[test]
fn errors_repeat() {
    for name in ["a3_tumbling", "b3_cradle", "d2_stack_10", "c14_grip"] {
        let case = case(name);
        let error = || try_default(&case, &crate::engines::ALL[0]).error;
        assert!(error().is_some() && error() == error(), "{name}");
    }
}

/// merev comes close to the truth where the truth is smooth, turned as a whole. (In f32 more steps do not bring the
/// tumbling box closer: the rounding of its rotation adds up.)
#[test]
fn smooth_cases_are_met() {
    for (name, rate, bound) in
        [("a3_tumbling", 60.0, 0.1), ("e1_pendulum_90", 480.0, 1e-3), ("e2_double_pendulum", 960.0, 1e-2)]
    {
        let case = case(name);
        let maker = &crate::engines::ALL[0];
        let setting = Setting::new(rate, 4);
        let method = (maker.methods)()[0];
        let error = try_case(&case, maker, &method, &setting, true, Duration::from_secs(20)).error.unwrap();
        assert!(error < bound, "{name}: {error}");
    }
}

/// A stiff spring that is followed well is fast, and has not exploded.
#[test]
fn a_fast_spring_has_not_exploded() {
    let maker = &crate::engines::ALL[0];
    for name in ["e7_spring_60", "e7_spring_120"] {
        let case = case(name);
        let setting = Setting::new(1920.0, 4);
        let method = (maker.methods)()[0];
        let tried = try_case(&case, maker, &method, &setting, false, Duration::from_secs(20));
        assert!(tried.error.is_some_and(|e| e < 1e-3), "{name}: {:?} {:?}", tried.outcome, tried.error);
    }
}

/// What is missing is refused, not dropped.
#[test]
fn missing_cases_are_refused() {
    let case = case("g1_internal_edges");
    assert_eq!(try_default(&case, &crate::engines::ALL[0]).outcome, Outcome::Refused);
    assert!(case.null_error().is_none());
}

/// A command that goes on measures nothing twice, and gives the same file.
#[test]
fn a_second_chart_has_nothing_to_do() {
    let directory = std::env::temp_dir().join(format!("merev-lab-chart-{}", std::process::id()));
    let _ = std::fs::remove_dir_all(&directory);
    let options = Options {
        directory: directory.clone(),
        quick: true,
        fresh: true,
        peers: false,
        only: Some("a1_ballistic".into()),
        jobs: 1,
        worker: None,
    };
    let rows = |options: &Options| {
        chart::run(options).unwrap();
        crate::records::read::<crate::records::WorkPrecision>(&directory).unwrap()
    };
    let first = rows(&options);
    let second = rows(&Options { fresh: false, ..options.clone() });
    assert_eq!(first, second);
    assert!(first.iter().any(|r| r.turned == 1) && first.iter().any(|r| r.engine == "merev_c"));
    // Times differ, errors do not.
    let again = rows(&options);
    let errors = |rows: &[crate::records::WorkPrecision]| rows.iter().map(|r| r.error).collect::<Vec<_>>();
    assert_eq!(errors(&first), errors(&again));
    std::fs::remove_dir_all(&directory).unwrap();
}
