//! Every solver in the same scenes: closed forms, conserved quantities, determinism, and what is degenerate.
//! What a solver does not hold is said in `LIMITS` and in its page under docs/methods, with the figure it reaches.

mod common;
#[path = "common/scenes.rs"]
mod scenes;

use common::Random;
use merev::math::{length, quat_about, scalar, vec3};
use merev::solver::SolverKind;
use merev::world::{BodyDef, ShapeDef, WorldDef};
use merev::{BodyId, Float, Pose, Quat, Shape, Vec3, World};
use scenes::{Scene, cube, orientations, sleepless, stack};

const G: Float = 10.0;
const H: Float = 1.0 / 60.0;

fn def(solver: SolverKind) -> WorldDef {
    WorldDef { solver, restitution_threshold: 0.0, ..sleepless() }
}

fn surface(friction: Float, restitution: Float) -> ShapeDef {
    let mut def = ShapeDef::default();
    (def.material.friction, def.material.restitution) = (friction, restitution);
    def
}

#[test]
fn a_box_rests() {
    for solver in SolverKind::ALL {
        for turn in orientations() {
            let mut scene = Scene::new(&def(solver), turn);
            scene.floor(&surface(0.6, 0.0));
            let body = scene.add(&BodyDef::dynamic(vec3(0.0, 0.5, 0.0)), &surface(0.6, 0.0), cube());
            scene.steps(300);
            let (off, v) = (scene.position(body) - vec3(0.0, 0.5, 0.0), length(scene.velocity(body)));
            println!("{}: {:.2e} m off, {v:.2e} m/s", solver.name(), length(off));
        }
    }
}

fn on_slope(solver: SolverKind, turn: Quat, friction: Float, tangent: Float, steps: usize) -> (Float, Float) {
    let slope = quat_about(Vec3::z(), -scalar::atan2(tangent, 1.0));
    let mut scene = Scene::new(&def(solver), turn * slope);
    scene.world.set_gravity(turn * vec3(0.0, -G, 0.0)).unwrap();
    scene.floor(&surface(friction, 0.0));
    let at = BodyDef::dynamic(vec3(0.0, 0.25, 0.0));
    let body = scene.add(&at, &surface(friction, 0.0), Shape::new_box(1.0, 0.5, 1.0));
    scene.steps(steps);
    (scene.position(body).x, scene.velocity(body).x)
}

#[test]
fn a_box_on_a_slope() {
    for solver in SolverKind::ALL {
        for turn in orientations() {
            let (way, v) = on_slope(solver, turn, 0.5, 0.45, 300);
            println!("{}: sticks: {way:.2e} m in 5 s, {v:.2e} m/s", solver.name());
            let (_, v) = on_slope(solver, turn, 0.5, 0.55, 120);
            let angle = scalar::atan2(0.55, 1.0);
            let expected = G * (scalar::sin(angle) - 0.5 * scalar::cos(angle)) * 2.0;
            println!(
                "{}: slides: {v} m/s of {expected}: {:.3} %",
                solver.name(),
                (v / expected - 1.0) * 100.0
            );
        }
    }
}

#[test]
fn a_stack_stands() {
    for solver in SolverKind::ALL {
        for turn in orientations() {
            let (mut scene, bodies) = stack(&def(solver), turn, 5);
            scene.steps(600);
            let top = scene.position(bodies[4]) - vec3(0.0, 4.5, 0.0);
            let r = scene.world.step_report();
            println!(
                "{}: top off by {:.2e} m, overlap {:.2e}, residual {:.2e}/{:.2e} {:?}",
                solver.name(),
                length(top),
                r.worst_penetration,
                r.residual,
                r.solve.residual,
                r.solve
            );
        }
    }
}

#[test]
fn bouncing() {
    for solver in SolverKind::ALL {
        let mut scene = Scene::new(&def(solver), Quat::identity());
        scene.floor(&surface(0.5, 0.8));
        let at = BodyDef::dynamic(vec3(0.0, 0.1 + 1.0, 0.0));
        let ball = scene.add(&at, &surface(0.5, 0.8), Shape::new_sphere(0.2));
        let mut peaks = Vec::new();
        let (mut y, mut v) = (1.0, 0.0);
        for _ in 0..300 {
            scene.steps(1);
            let (y1, v1) = (scene.position(ball).y - 0.1, scene.velocity(ball).y);
            if v > 0.0 && v1 <= 0.0 {
                peaks.push(y + v * v / (2.0 * G));
            }
            (y, v) = (y1, v1);
        }
        println!("{}: {:?}", solver.name(), &peaks[..peaks.len().min(4)]);
    }
}

#[test]
fn dbg_env() {
    let get = |k: &str, d: f64| std::env::var(k).ok().and_then(|v| v.parse().ok()).unwrap_or(d);
    let solver = SolverKind::ALL[get("S", 2.0) as usize];
    let n = get("N", 5.0) as usize;
    let d = WorldDef {
        solver_iterations: get("IT", 8.0) as u32,
        contact_speed: get("PUSH", 3.0) as Float,
        enable_warm_starting: get("WARM", 1.0) > 0.0,
        ..def(solver)
    };
    let mut scene = Scene::new(&d, orientations()[get("TURN", 0.0) as usize]);
    scene.floor(&surface(get("MU", 0.6) as Float, 0.0));
    let bodies: Vec<BodyId> = (0..n)
        .map(|i| {
            let at = BodyDef::dynamic(vec3(0.0, 0.5 + i as Float, 0.0));
            scene.add(&at, &surface(get("MU", 0.6) as Float, 0.0), cube())
        })
        .collect();
    for _ in 0..get("STEPS", 6.0) as usize {
        for _ in 0..get("EACH", 100.0) as usize {
            scene.world.try_step(1.0 / 60.0, get("SUB", 4.0) as u32).unwrap();
        }
        let top = scene.position(bodies[n - 1]) - vec3(0.0, n as Float - 0.5, 0.0);
        let r = scene.world.step_report();
        println!(
            "{:.1e} {:.1e} ov {:.1e} res {:.1e} failed {} {}",
            top.y,
            (top.x * top.x + top.z * top.z).sqrt(),
            r.worst_penetration,
            r.solve.residual,
            r.solve.failed,
            r.solve.failure.name()
        );
        if get("SHOW", 0.0) > 0.0 {
            for &b in &bodies {
                for c in scene.world.body(b).unwrap().contacts() {
                    println!(
                        "   {:?}",
                        c.points.iter().map(|p| (p.normal_impulse, p.separation)).collect::<Vec<_>>()
                    );
                }
            }
        }
    }
}
