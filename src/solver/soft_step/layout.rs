//! Lays the constraints of the awake islands out by (batch, colour, kind).

use super::kinds::{KINDS, Kind, KindTable, Placed, kind_of};
use super::preload::Preload;
use crate::body::{BodyStore, NONE};
use crate::constraint::{ContactStore, JointStore, contact::flags};
use crate::island::IslandStore;
use crate::island::color::{COLORS, OVERFLOW};
use crate::math::{Float, length};
use crate::solver::Settings;
use crate::solver::bodies::{Bodies, HEADS_AHEAD, center};
use crate::solver::joints;
use crate::solver::rows::Rows;
use crate::solver::soft;
use std::ops::Range;

/// Impulses of loads grow with the sub-step, those of impacts and push-out do not: after a far shorter step, such as
/// what rounding leaves of a frame, most are of the latter kind, and grown in full they would throw bodies about.
const GREATEST_GROWTH: Float = 8.0;

/// How many constraints are placed before their blocks are filled: a multiple of every width, few enough to stay
/// in the cache.
const CHUNK: usize = 512;

/// How many contacts ahead a walk asks for their memory.
const CONTACTS_AHEAD: usize = 12;

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
    /// Constraints.
    pub kinds: KindTable,
    /// How many overflow constraints the last layout had.
    pub overflow: usize,
    groups: Vec<Group>,
    /// The groups of each batch, in the order in which they are solved.
    groups_of: Vec<Range<usize>>,
    /// The filter rate of each island, by island index.
    ratio_of: Vec<Float>,
    /// Σ normal impulse, and mass, by solver row.
    load: Vec<[Float; 2]>,
    /// Which solver rows have contacts.
    touched: Vec<bool>,
    preload: Preload,
    keys: Vec<u64>,
    placed: Vec<Placed>,
}

impl Workspace {
    /// Runs `f` over the groups of a batch, in order.
    #[inline]
    pub fn each_group(
        &mut self,
        batch: usize,
        rows: &mut Rows,
        mut f: impl FnMut(&mut dyn Kind, Range<u32>, &mut Rows),
    ) {
        for group in &self.groups[self.groups_of[batch].clone()] {
            let kind = &mut self.kinds.by_width[group.width][group.kind];
            f(&mut **kind, group.blocks.clone(), rows);
        }
    }

    #[allow(clippy::too_many_arguments)]
    /// See the module. The islands have been gathered; new resting contacts get their first impulses.
    pub fn lay_out(
        &mut self,
        rows: &mut Bodies,
        joint_rows: &mut joints::Workspace,
        bodies: &BodyStore,
        contacts: &mut ContactStore,
        joints: &JointStore,
        islands: &mut IslandStore,
        settings: &Settings,
    ) {
        for island in &rows.islands {
            if islands.islands[island.id as usize].changed {
                islands.measure(island.id, &bodies.bodies, &contacts.contacts, &joints.joints);
                if settings.warm_starting && islands.islands[island.id as usize].anchored {
                    self.preload.run(island.id, islands, bodies, contacts, settings);
                }
            }
        }
        rows.fill(bodies, islands, settings);
        self.sort_constraints(rows, contacts);
        self.measure_loads(rows, bodies, contacts, islands, settings);
        joint_rows.begin(rows, bodies, joints);
        self.fill_blocks(rows, joint_rows, bodies, contacts, joints, islands, settings);
        joint_rows.end(rows);
    }

    /// The load ratio of each island (how much more a body carries than it weighs) and who is held by contacts.
    /// Sums run over the sorted constraints, so that they do not depend on what else is in the world.
    fn measure_loads(
        &mut self,
        rows: &mut Bodies,
        bodies: &BodyStore,
        contacts: &ContactStore,
        islands: &IslandStore,
        settings: &Settings,
    ) {
        self.ratio_of.clear();
        self.ratio_of.resize(islands.islands.len(), 1.0);
        self.load.clear();
        self.load.extend(rows.rows.aux.iter().map(|aux| [0.0, aux.mass]));
        for (k, &key) in self.keys.iter().enumerate() {
            contacts.prefetch_at(self.keys.get(k + CONTACTS_AHEAD).map(|&key| key as u32));
            let contact = &contacts.contacts[key as u32 as usize];
            let island = rows.island_of(contact.body).expect("sorted ones have an island");
            let sum: Float = contact.points().iter().map(|p| p.impulse).sum();
            let mut masses = [0.0; 2];
            for (mass, seat) in masses.iter_mut().zip(rows.seats_of(contact.body)) {
                if seat.island != NONE {
                    let [load, its_mass] = &mut self.load[seat.row as usize];
                    *load += sum;
                    *mass = *its_mass;
                }
            }
            if masses[0] > 0.0 && masses[1] > 0.0 {
                let ratio = (masses[0] / masses[1]).max(masses[1] / masses[0]);
                let known = &mut self.ratio_of[island as usize];
                *known = known.max(ratio);
            }
        }
        let weight = length(settings.gravity) * settings.last_h;
        for (row, &[load, _]) in self.load.iter().enumerate().skip(1) {
            let aux = &mut rows.rows.aux[row];
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
    fn sort_constraints(&mut self, rows: &Bodies, contacts: &ContactStore) {
        self.keys.clear();
        self.overflow = 0;
        for (k, &c) in contacts.awake.iter().enumerate() {
            contacts.prefetch_head(contacts.awake.get(k + HEADS_AHEAD).copied());
            let contact = &contacts.contacts[c as usize];
            if !contact.is(flags::CONSTRAINT) {
                continue;
            }
            let island = rows.island_of(contact.body).filter(|&island| rows.is_gathered(island));
            let Some(island) = island else { continue };
            let color = if contact.color == OVERFLOW {
                self.overflow += 1;
                0
            } else {
                debug_assert!((contact.color as usize) < COLORS);
                u64::from(contact.color) + 1
            };
            let batch = u64::from(rows.batch_of(island));
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
    #[allow(clippy::too_many_arguments)]
    fn fill_blocks(
        &mut self,
        rows: &mut Bodies,
        joint_rows: &mut joints::Workspace,
        bodies: &BodyStore,
        contacts: &ContactStore,
        joints: &JointStore,
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
        self.groups_of.clear();
        self.touched.clear();
        self.touched.resize(rows.rows.row.len(), false);
        let mut at = 0;
        for batch in 0..rows.batches.len() {
            let settings = &settings.at(rows.batches[batch].level);
            let h = settings.h();
            // Between moving bodies, and on immovable ones.
            let softness_of = [(1.0, settings.push_out_between_moving), (2.0, settings.push_out_on_static)]
                .map(|(factor, speed)| {
                    soft(factor * settings.stiffness / h, settings.damping_ratio, h, speed)
                });
            let impulse_scale =
                if settings.last_h > 0.0 { (h / settings.last_h).min(GREATEST_GROWTH) } else { 1.0 };
            let first = self.groups.len();
            rows.open_batch(batch);
            joint_rows.lay_out_batch(batch, rows, bodies, joints, settings);
            while at < self.keys.len() && (self.keys[at] >> 42) as usize == batch {
                let group = self.keys[at] >> 32;
                self.placed.clear();
                while at < self.keys.len() && self.keys[at] >> 32 == group && self.placed.len() < CHUNK {
                    let index = self.keys[at] as u32;
                    contacts.prefetch_at(self.keys.get(at + CONTACTS_AHEAD).map(|&key| key as u32));
                    let contact = &contacts.contacts[index as usize];
                    let island = rows.island_of(contact.body).expect("sorted ones have an island");
                    let is_fixed = rows.seats_of(contact.body).iter().any(|seat| seat.island == NONE);
                    let placed = Placed {
                        index,
                        rows: contact.body.map(|b| rows.row_for(bodies, b, batch, settings)),
                        offset: center(bodies, contact.body[0]) - center(bodies, contact.body[1]),
                        soft: softness_of[usize::from(is_fixed)],
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
                // Copies of kinematic bodies came just now.
                self.touched.resize(rows.rows.row.len(), false);
                for &row in self.placed.iter().flat_map(|p| &p.rows) {
                    self.touched[row as usize] = true;
                }
                let blocks =
                    self.kinds.by_width[width][kind].append(&contacts.contacts, &self.placed, &rows.rows);
                self.groups.push(Group { width, kind, blocks });
            }
            self.groups_of.push(first..self.groups.len());
        }
        debug_assert_eq!(at, self.keys.len());
        for (aux, &touched) in rows.rows.aux.iter_mut().zip(&self.touched) {
            aux.touched |= touched;
        }
    }

    /// How many times its own weight a body of an island carried at most when the last step began, by the island's index.
    pub fn ratio_of(&self, island: u32) -> Float {
        self.ratio_of[island as usize]
    }

    /// Multiplies the impulses that were stored for the contacts of a batch, sums over the step aside.
    pub fn scale_stored(&self, batch: usize, contacts: &mut ContactStore, factor: Float) {
        let batch_of = |key: &u64| (*key >> 42) as usize;
        let from = self.keys.partition_point(|key| batch_of(key) < batch);
        for &key in self.keys[from..].iter().take_while(|key| batch_of(key) == batch) {
            let contact = &mut contacts.contacts[key as u32 as usize];
            for p in &mut contact.points[..contact.count as usize] {
                p.impulse *= factor;
                p.memory *= factor;
            }
            contact.friction_impulse *= factor;
            contact.twist_impulse *= factor;
            contact.rolling_impulse *= factor;
        }
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        let blocks: usize = self.kinds.by_width.iter().flatten().map(|k| k.byte_count()).sum();
        blocks
            + self.keys.capacity() * 8
            + self.load.capacity() * size_of::<[Float; 2]>()
            + self.touched.capacity()
            + self.placed.capacity() * size_of::<Placed>()
    }
}

/// How fast the load memory follows the impulse, per step: slower than the sweeps converge, of which a decimal
/// digit takes 2.3 R for a load ratio R and 0.93 H² for a height H.
fn memory_rate(ratio: Float, height: u32, sub_steps: u32) -> Float {
    let height = height as Float;
    let sweeps = (2.3 * ratio).max(0.93 * height * height);
    (4.0 * sub_steps as Float / sweeps).min(0.1)
}
