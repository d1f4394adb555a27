//! Lays the constraints of the awake islands out by (batch, colour, kind) and their bodies by batch.

use super::kinds::{KINDS, Kind, KindTable, Placed, kind_of};
use super::preload::Preload;
use super::rows::{Aux, InertiaRow, Row, Rows};
use super::{Settings, soft};
use crate::body::{BodySet, BodyStore, NONE};
use crate::constraint::{ContactStore, contact::flags};
use crate::island::IslandStore;
use crate::island::color::{COLORS, OVERFLOW};
use crate::math::{Float, Quat, Vec3, length};
use std::ops::Range;

/// A batch takes islands until its rows fill about half of a core's second-level cache \[bytes\].
const BATCH_BYTES: usize = 512 << 10;

/// Below this turn per sub-step \[rad\] I_w is left as it is within the step: the energy error of that is of the
/// order of its square.
const SPIN_BOUND: Float = 2e-4;

/// Impulses of loads grow with the sub-step, those of impacts and push-out do not: after a far shorter step, such as
/// what rounding leaves of a frame, most are of the latter kind, and grown in full they would throw bodies about.
const GREATEST_GROWTH: Float = 8.0;

/// How many constraints are placed before their blocks are filled: a multiple of every width, few enough to stay
/// in the cache.
const CHUNK: usize = 512;

/// Islands that one thread takes through all sub-steps.
#[derive(Clone, Debug)]
pub struct Batch {
    /// Solver rows of the islands' bodies.
    pub rows: Range<usize>,
    /// Solver rows of the kinematic bodies that they touch (copies).
    pub kinematic: Range<usize>,
    /// The constraints, in the order in which they are solved.
    pub groups: Range<usize>,
    /// Row ranges of islands that nothing immovable touches: their angular momentum is kept.
    pub isolated: Range<usize>,
}

/// Blocks of one (batch, colour, kind).
#[derive(Clone, Debug)]
pub struct Group {
    width: usize,
    kind: usize,
    blocks: Range<u32>,
}

/// All that the solver keeps between steps is memory.
#[derive(Debug, Default)]
pub struct Workspace {
    /// Bodies.
    pub rows: Rows,
    /// Constraints.
    pub kinds: KindTable,
    /// Batches.
    pub batches: Vec<Batch>,
    /// How many overflow constraints the last layout had.
    pub overflow: usize,
    /// How many constraints.
    pub constraints: usize,
    /// How many islands.
    pub islands: usize,
    pub(super) groups: Vec<Group>,
    pub(super) isolated: Vec<Range<usize>>,
    /// Solver row by awake row.
    row_of: Vec<u32>,
    /// Awake islands in order, with their number of constraints, batch and filter rate, by island index.
    order: Vec<u32>,
    constraints_of: Vec<u32>,
    batch_of: Vec<u32>,
    ratio_of: Vec<Float>,
    /// Σ normal impulse by solver row.
    load: Vec<Float>,
    preload: Preload,
    keys: Vec<u64>,
    placed: Vec<Placed>,
    /// Batch and row of each kinematic body's last copy, by awake row.
    kinematic_copy: Vec<[u32; 2]>,
}

impl Clone for Workspace {
    /// A workspace holds nothing that outlives a step, so a copy starts empty.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Workspace {
    /// Runs `f` over the groups of a batch, in order.
    #[inline]
    pub fn each_group(&mut self, batch: usize, mut f: impl FnMut(&mut dyn Kind, Range<u32>, &mut Rows)) {
        let groups = self.batches[batch].groups.clone();
        for group in &self.groups[groups] {
            let kind = &mut self.kinds.by_width[group.width][group.kind];
            f(&mut **kind, group.blocks.clone(), &mut self.rows);
        }
    }

    /// See the module.
    pub fn lay_out(
        &mut self,
        bodies: &BodyStore,
        contacts: &mut ContactStore,
        islands: &mut IslandStore,
        settings: &Settings,
    ) {
        self.gather_islands(bodies, contacts, islands, settings);
        self.fill_rows(bodies, islands, settings);
        self.sort_constraints(bodies, contacts);
        self.measure_loads(bodies, contacts, settings);
        self.fill_blocks(bodies, contacts, islands, settings);
    }

    /// The awake islands and how many constraints each has.
    fn gather_islands(
        &mut self,
        bodies: &BodyStore,
        contacts: &mut ContactStore,
        islands: &mut IslandStore,
        settings: &Settings,
    ) {
        self.order.clear();
        let count = islands.islands.len();
        self.constraints_of.clear();
        self.constraints_of.resize(count, 0);
        self.batch_of.clear();
        self.batch_of.resize(count, NONE);
        self.ratio_of.clear();
        self.ratio_of.resize(count, 1.0);
        for &index in &bodies.awake().index {
            let island = bodies.bodies[index as usize].island;
            if island != NONE && self.batch_of[island as usize] == NONE {
                self.batch_of[island as usize] = 0;
                self.order.push(island);
            }
        }
        for &island in &self.order {
            if islands.islands[island as usize].changed {
                islands.measure(island, &bodies.bodies, &contacts.contacts);
                if settings.warm_starting && islands.islands[island as usize].anchored {
                    self.preload.run(island, islands, bodies, contacts, settings);
                }
            }
        }
        self.islands = self.order.len();
        self.constraints = 0;
        for &c in &contacts.awake {
            let contact = &contacts.contacts[c as usize];
            if let Some(island) = island_of(bodies, contact.body).filter(|_| contact.is(flags::CONSTRAINT)) {
                self.constraints_of[island as usize] += 1;
                self.constraints += 1;
            }
        }
    }

    /// Bodies by batch and island.
    fn fill_rows(&mut self, bodies: &BodyStore, islands: &IslandStore, settings: &Settings) {
        let awake = bodies.awake();
        let h = settings.dt / settings.sub_steps as Float;
        self.rows.row.clear();
        self.rows.inertia.clear();
        self.rows.aux.clear();
        self.rows.row.push(Row::IMMOVABLE);
        self.rows.inertia.push(InertiaRow::ZERO);
        self.rows.aux.push(immovable_aux());
        self.row_of.clear();
        self.row_of.resize(awake.len(), 0);
        self.batches.clear();
        self.isolated.clear();

        let mut bytes = usize::MAX;
        for &id in &self.order {
            let island = &islands.islands[id as usize];
            let size = island.bodies.len() * (size_of::<Row>() + size_of::<InertiaRow>() + size_of::<Aux>())
                + self.constraints_of[id as usize] as usize * 70 * size_of::<Float>();
            if bytes == usize::MAX || bytes + size > BATCH_BYTES {
                let (row, isolated) = (self.rows.row.len(), self.isolated.len());
                self.batches.push(Batch {
                    rows: row..row,
                    kinematic: 0..0,
                    groups: 0..0,
                    isolated: isolated..isolated,
                });
                bytes = 0;
            }
            bytes += size;
            self.batch_of[id as usize] = self.batches.len() as u32 - 1;
            let start = self.rows.row.len();
            for &body in &island.bodies {
                let row = bodies.bodies[body as usize].row as usize;
                self.row_of[row] = self.rows.row.len() as u32;
                self.rows.push_body(awake, row, settings, h);
            }
            let end = self.rows.row.len();
            let batch = self.batches.last_mut().expect("pushed above");
            batch.rows.end = end;
            if !island.anchored && island.bodies.len() > 1 {
                self.isolated.push(start..end);
                batch.isolated.end = self.isolated.len();
            }
        }
    }

    /// The load ratio of each island (how much more a body carries than it weighs) and who is held by contacts.
    /// Sums run over the sorted constraints, so that they do not depend on what else is in the world.
    fn measure_loads(&mut self, bodies: &BodyStore, contacts: &ContactStore, settings: &Settings) {
        self.load.clear();
        self.load.resize(self.rows.row.len(), 0.0);
        for &key in &self.keys {
            let contact = &contacts.contacts[key as u32 as usize];
            let island = island_of(bodies, contact.body).expect("sorted ones have an island");
            let sum: Float = contact.points().iter().map(|p| p.impulse).sum();
            let mut masses = [0.0; 2];
            for (mass, &body) in masses.iter_mut().zip(&contact.body) {
                let body = &bodies.bodies[body as usize];
                if body.island != NONE {
                    let row = self.row_of[body.row as usize] as usize;
                    self.load[row] += sum;
                    *mass = self.rows.aux[row].mass;
                }
            }
            if masses[0] > 0.0 && masses[1] > 0.0 {
                let ratio = (masses[0] / masses[1]).max(masses[1] / masses[0]);
                let known = &mut self.ratio_of[island as usize];
                *known = known.max(ratio);
            }
        }
        let weight = length(settings.gravity) * settings.last_h;
        for (row, &load) in self.load.iter().enumerate().skip(1) {
            let aux = &mut self.rows.aux[row];
            aux.supported = load > 0.0;
            if load > 0.0 && weight > 0.0 && aux.mass > 0.0 {
                // A body that carries R times its weight is pressed from above by R and from below by R + 1.
                let ratio = 0.5 * (load / (aux.mass * weight) - 1.0);
                let index = bodies.awake().index[aux.awake_row as usize];
                let known = &mut self.ratio_of[bodies.bodies[index as usize].island as usize];
                *known = known.max(ratio);
            }
        }
    }

    /// Keys (batch, colour, kind, contact), sorted. Overflow comes first: what the colours do after it is better
    /// converged.
    fn sort_constraints(&mut self, bodies: &BodyStore, contacts: &ContactStore) {
        self.keys.clear();
        self.overflow = 0;
        for &c in &contacts.awake {
            let contact = &contacts.contacts[c as usize];
            let Some(island) = island_of(bodies, contact.body).filter(|_| contact.is(flags::CONSTRAINT))
            else {
                continue;
            };
            let color = if contact.color == OVERFLOW {
                self.overflow += 1;
                0
            } else {
                debug_assert!((contact.color as usize) < COLORS);
                u64::from(contact.color) + 1
            };
            let batch = u64::from(self.batch_of[island as usize]);
            self.keys.push(((batch * 32 + color) * 32 + kind_of(contact) as u64) << 32 | u64::from(c));
        }
        self.keys.sort_unstable();
        // Within a colour order is of no consequence; overflow goes by the shapes, as contact slots depend on what
        // else is in the world.
        let group = |key: u64| key >> 32;
        for run in self.keys.chunk_by_mut(|a, b| group(*a) == group(*b)) {
            if group(run[0]) / 32 % 32 == 0 {
                run.sort_unstable_by_key(|&key| contacts.contacts[key as u32 as usize].shape);
            }
        }
    }

    /// Blocks, group by group.
    fn fill_blocks(
        &mut self,
        bodies: &BodyStore,
        contacts: &ContactStore,
        islands: &IslandStore,
        settings: &Settings,
    ) {
        for width in &mut self.kinds.by_width {
            for kind in width {
                kind.clear();
            }
        }
        const { assert!(KINDS <= 32) };
        self.groups.clear();
        self.kinematic_copy.clear();
        self.kinematic_copy.resize(bodies.awake().len(), [NONE; 2]);
        let h = settings.dt / settings.sub_steps as Float;
        // Between moving bodies, and on immovable ones.
        let softness_of = [(1.0, settings.push_out_between_moving), (2.0, settings.push_out_on_static)]
            .map(|(factor, speed)| soft(factor * settings.stiffness / h, settings.damping_ratio, h, speed));
        let impulse_scale =
            if settings.last_h > 0.0 { (h / settings.last_h).min(GREATEST_GROWTH) } else { 1.0 };
        let mut at = 0;
        for batch in 0..self.batches.len() {
            self.batches[batch].groups.start = self.groups.len();
            self.batches[batch].kinematic.start = self.rows.row.len();
            while at < self.keys.len() && (self.keys[at] >> 42) as usize == batch {
                let group = self.keys[at] >> 32;
                self.placed.clear();
                while at < self.keys.len() && self.keys[at] >> 32 == group && self.placed.len() < CHUNK {
                    let index = self.keys[at] as u32;
                    let contact = &contacts.contacts[index as usize];
                    let island = island_of(bodies, contact.body).expect("sorted ones have an island");
                    let placed = Placed {
                        index,
                        rows: contact.body.map(|b| self.row_for(bodies, b, batch as u32, settings, h)),
                        offset: center(bodies, contact.body[0]) - center(bodies, contact.body[1]),
                        soft: softness_of[usize::from(
                            contact.body.iter().any(|&b| bodies.bodies[b as usize].island == NONE),
                        )],
                        alpha: if settings.load_memory {
                            memory_rate(
                                self.ratio_of[island as usize],
                                islands.islands[island as usize].height,
                                settings.sub_steps,
                            )
                        } else {
                            0.0
                        },
                        impulse_scale,
                    };
                    self.placed.push(placed);
                    at += 1;
                }
                let (kind, color) = ((group % 32) as usize, group / 32 % 32);
                let width = usize::from(settings.wide && color != 0);
                let blocks =
                    self.kinds.by_width[width][kind].append(&contacts.contacts, &self.placed, &self.rows);
                self.groups.push(Group { width, kind, blocks });
            }
            self.batches[batch].groups.end = self.groups.len();
            self.batches[batch].kinematic.end = self.rows.row.len();
        }
        debug_assert_eq!(at, self.keys.len());
    }

    /// The solver row of a body in a batch; each batch has its own copies of kinematic bodies.
    fn row_for(&mut self, bodies: &BodyStore, body: u32, batch: u32, settings: &Settings, h: Float) -> u32 {
        let b = &bodies.bodies[body as usize];
        if b.set != crate::body::SetId::AWAKE {
            return 0;
        }
        if b.island != NONE {
            return self.row_of[b.row as usize];
        }
        let copy = &mut self.kinematic_copy[b.row as usize];
        if copy[0] != batch {
            *copy = [batch, self.rows.row.len() as u32];
            self.rows.push_body(bodies.awake(), b.row as usize, settings, h);
        }
        copy[1]
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        let blocks: usize = self.kinds.by_width.iter().flatten().map(|k| k.byte_count()).sum();
        blocks
            + self.rows.row.capacity() * size_of::<Row>()
            + self.rows.inertia.capacity() * size_of::<InertiaRow>()
            + self.rows.aux.capacity() * size_of::<Aux>()
            + self.keys.capacity() * 8
            + self.placed.capacity() * size_of::<Placed>()
    }
}

/// The island that a pair of bodies belongs to: that of either one that moves.
fn island_of(bodies: &BodyStore, pair: [u32; 2]) -> Option<u32> {
    pair.iter().map(|&b| &bodies.bodies[b as usize]).find(|b| b.island != NONE).map(|b| b.island)
}

/// The centre of mass of a body.
fn center(bodies: &BodyStore, body: u32) -> Vec3 {
    let (set, row) = bodies.at(body as usize);
    set.motion[row].x
}

/// How fast the load memory follows the impulse, per step: slower than the sweeps converge, of which a decimal
/// digit takes 2.3 R for a load ratio R and 0.93 H² for a height H.
fn memory_rate(ratio: Float, height: u32, sub_steps: u32) -> Float {
    let height = height as Float;
    let sweeps = (2.3 * ratio).max(0.93 * height * height);
    (4.0 * sub_steps as Float / sweeps).min(0.1)
}

fn immovable_aux() -> Aux {
    let (zero, one) = (Vec3::zeros(), Quat::identity());
    Aux {
        accel: zero,
        torque: zero,
        before: [zero; 2],
        middle: [zero; 2],
        warm: [zero; 2],
        first_dl: zero,
        begin: [zero; 2],
        l: zero,
        q: [one; 2],
        damping: [1.0; 2],
        mass: 0.0,
        moments: zero,
        awake_row: NONE,
        spin: false,
        supported: true,
        kinematic: true,
        locked: false,
    }
}

impl Rows {
    /// Appends a body of the awake set.
    fn push_body(&mut self, set: &BodySet, row: usize, settings: &Settings, h: Float) {
        let (motion, mass, drive) = (&set.motion[row], &set.mass[row], &set.drive[row]);
        let (v, w) = (set.velocity(row), set.angular_velocity(row));
        let mut solver_row = Row::IMMOVABLE;
        solver_row.set_v(v);
        solver_row.set_w(w);
        solver_row.0[0][3] = mass.inv_mass;
        self.row.push(solver_row);
        self.inertia.push(InertiaRow::new(&set.inv_inertia[row]));
        let q = motion.q * mass.principal;
        let moves = !drive.kinematic && mass.inv_mass > 0.0;
        let turns_freely = mass.turns() && drive.locks.angular == [false; 3];
        self.aux.push(Aux {
            accel: if moves {
                settings.gravity * drive.gravity_scale + drive.force * mass.inv_mass
            } else {
                Vec3::zeros()
            },
            torque: drive.torque,
            begin: [v, w],
            l: motion.l,
            q: [q, q],
            damping: [1.0 / (1.0 + h * drive.linear_damping), 1.0 / (1.0 + h * drive.angular_damping)],
            mass: mass.mass,
            moments: mass.moments,
            awake_row: row as u32,
            spin: !mass.isotropic && turns_freely && length(w) * h > SPIN_BOUND,
            supported: false,
            kinematic: drive.kinematic,
            locked: drive.locks.any(),
            ..immovable_aux()
        });
    }
}
