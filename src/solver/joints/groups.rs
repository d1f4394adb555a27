//! Which joints hang together, and how each such group is solved. Known from the topology alone, and kept until that
//! changes.

use super::elimination::Elimination;
use crate::body::{BodyStore, NONE};
use crate::constraint::joint::{JointKind, JointRow, JointStore, SphericalJoint};
use crate::world::BodyType;

/// Larger groups are not even looked at for a plan.
const MOST_PLANNED: usize = 4000;

/// How many colours the ball joints of a mesh may take; what finds none is solved with the other joints.
const COLORS: u32 = 32;

/// Joints that hang together.
#[derive(Clone, Debug, Default)]
pub struct Group {
    /// Indices of the store; gears last, as their rows are made from those of other joints.
    pub joints: Vec<u32>,
    /// How their unbounded rows are solved at once, where that is not too dear.
    pub plan: Option<Elimination>,
    /// Without a plan: the plain ball joints by colour. Those of one colour share no moving body.
    pub balls: Vec<Vec<u32>>,
}

/// All groups.
#[derive(Debug, Default)]
pub struct Groups {
    /// In order of their first joints.
    pub list: Vec<Group>,
    version: Option<u64>,
}

impl Groups {
    /// Brings the groups up to date.
    pub fn update(&mut self, store: &BodyStore, joints: &JointStore) {
        if self.version != Some(joints.version) {
            self.version = Some(joints.version);
            self.find(store, joints);
        }
    }

    fn find(&mut self, store: &BodyStore, joints: &JointStore) {
        self.list.clear();
        let mut seen = vec![false; joints.joints.len()];
        let mut place = vec![NONE; joints.joints.len()];
        for &seed in &joints.live {
            if seen[seed as usize] || !joints.joints[seed as usize].active {
                continue;
            }
            seen[seed as usize] = true;
            let (mut group, mut next) = (vec![seed], 0);
            while next < group.len() {
                let joint = group[next];
                next += 1;
                for other in neighbours(joint, store, joints) {
                    if !std::mem::replace(&mut seen[other as usize], true) {
                        group.push(other);
                    }
                }
            }
            group.sort_unstable();
            group.sort_by_key(|&j| is_gear(&joints.joints[j as usize].kind));
            for (i, &j) in group.iter().enumerate() {
                place[j as usize] = i as u32;
            }
            let mut group = Group { joints: group, ..Group::default() };
            if group.joints.len() <= MOST_PLANNED {
                let dims: Vec<usize> = group.joints.iter().map(|&j| hard_rows(j, store, joints)).collect();
                let mut edges = Vec::new();
                for (i, &j) in group.joints.iter().enumerate() {
                    let near = neighbours(j, store, joints).filter(|&other| other != j);
                    edges.extend(near.map(|other| (i as u32, place[other as usize])));
                }
                group.plan = Elimination::plan(&dims, &edges);
            }
            if group.plan.is_none() {
                group.color(store, joints);
            }
            self.list.push(group);
        }
    }
}

impl Group {
    /// Takes the plain ball joints out of the list, by colour.
    fn color(&mut self, store: &BodyStore, joints: &JointStore) {
        let mut used = vec![0_u32; store.bodies.len()];
        let mut balls: Vec<Vec<u32>> = Vec::new();
        let plain = JointKind::Spherical(SphericalJoint::default());
        self.joints.retain(|&j| {
            let joint = &joints.joints[j as usize];
            if joint.kind != plain || joint.hertz > 0.0 {
                return true;
            }
            let moving = || joint.members().filter(|&b| moves(b, store));
            let taken = moving().fold(0, |taken, b| taken | used[b as usize]);
            let color = (!taken).trailing_zeros();
            if color >= COLORS {
                return true;
            }
            moving().for_each(|b| used[b as usize] |= 1 << color);
            let color = color as usize;
            if balls.len() <= color {
                balls.resize(color + 1, Vec::new());
            }
            balls[color].push(j);
            false
        });
        self.balls = balls;
    }
}

fn is_gear(kind: &JointKind) -> bool {
    matches!(kind, JointKind::Gear(_) | JointKind::RackPinion(_))
}

fn moves(body: u32, store: &BodyStore) -> bool {
    store.bodies[body as usize].body_type == BodyType::Dynamic
}

/// The acting joints that share a moving body with this one, itself among them.
fn neighbours<'a>(
    joint: u32,
    store: &'a BodyStore,
    joints: &'a JointStore,
) -> impl Iterator<Item = u32> + 'a {
    joints.joints[joint as usize]
        .members()
        .filter(|&b| moves(b, store))
        .flat_map(|b| store.bodies[b as usize].joints.iter().copied())
        .filter(|&other| joints.joints[other as usize].active)
}

/// How many unbounded rows a joint has.
fn hard_rows(index: u32, store: &BodyStore, joints: &JointStore) -> usize {
    let joint = &joints.joints[index as usize];
    if is_gear(&joint.kind) {
        return 1;
    }
    let mut rows: Vec<JointRow> = Vec::new();
    joint.kind.emit(&joint.geometry(store), &mut |row| rows.push(row));
    rows.iter().filter(|row| row.law.is_unbounded()).count()
}
