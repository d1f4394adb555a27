//! The bodies of a step as the solvers see them: rows in order of batch and island, and who is where.

use super::Settings;
use super::rows::{Aux, InertiaRow, Row, Rows};
use crate::body::{BodySet, BodyStore, NONE, SetId};
use crate::constraint::{ContactStore, JointStore, contact::flags};
use crate::integrate::IntegratorKind;
use crate::island::IslandStore;
use crate::math::{Float, Quat, Vec3, length};
use std::ops::Range;

/// How many contacts ahead a walk over their heads asks for memory.
pub(super) const HEADS_AHEAD: usize = 16;

/// A batch takes islands until its rows fill about half of a core's second-level cache \[bytes\].
const BATCH_BYTES: usize = 512 << 10;

/// Below this turn per sub-step \[rad\] I_w is left as it is within the step: the energy error of that is of the
/// order of its square. Who names an integrator gets it for every turn.
fn spin_bound(integrator: IntegratorKind) -> Float {
    if integrator == IntegratorKind::Auto { 2e-4 } else { 0.0 }
}

/// Islands that one thread takes through all sub-steps.
#[derive(Clone, Debug)]
pub struct Batch {
    /// Solver rows of the islands' bodies.
    pub rows: Range<usize>,
    /// Solver rows of the kinematic bodies that they touch (copies).
    pub kinematic: Range<usize>,
    /// Row ranges of islands that nothing immovable touches: their angular momentum is kept.
    pub isolated: Range<usize>,
    /// Places of its islands in [`Bodies::islands`].
    pub islands: Range<usize>,
    /// Whether its islands (all or none) have both joints and contacts.
    pub mixed: bool,
    /// Its islands' sub-steps are the world's times two to this power.
    pub level: i32,
}

/// An awake island.
#[derive(Clone, Debug)]
pub struct AwakeIsland {
    /// Its index in the store.
    pub id: u32,
    /// How many constraints it has.
    pub constraints: u32,
    /// Whether it has both joints and contacts.
    pub mixed: bool,
    /// Its sub-steps are the world's times two to this power.
    pub level: i32,
    /// The solver rows of its bodies.
    pub rows: Range<usize>,
}

/// Where a body is in this step, and what laying constraints out asks of it besides.
#[derive(Clone, Copy, Debug)]
pub struct Seat {
    /// Its island, or [`NONE`].
    pub island: u32,
    /// Its solver row, if it has an island.
    pub row: u32,
}

impl Seat {
    /// Of a body without an awake island.
    const NONE: Seat = Seat { island: NONE, row: 0 };
}

/// The bodies of the awake islands. All that is kept between steps is memory.
#[derive(Debug, Default)]
pub struct Bodies {
    /// Their rows.
    pub rows: Rows,
    /// Batches of islands.
    pub batches: Vec<Batch>,
    /// The awake islands, in order of their first awake body; those with both joints and contacts, or more sub-steps
    /// than others, last.
    pub islands: Vec<AwakeIsland>,
    /// How many constraints they have.
    pub constraints: usize,
    /// By stable index of the body.
    seats: Vec<Seat>,
    /// Who has a seat.
    seated: Vec<u32>,
    pub(super) isolated: Vec<Range<usize>>,
    /// Solver row by awake row.
    row_of: Vec<u32>,
    /// Place in `islands`, and batch, by island index.
    place_of: Vec<u32>,
    batch_of: Vec<u32>,
    /// Batch and row of each kinematic body's last copy, by awake row.
    kinematic_copy: Vec<[u32; 2]>,
}

impl Bodies {
    /// Finds the awake islands (in a rehearsal: those that are rehearsed) and counts their constraints.
    pub fn gather(
        &mut self,
        bodies: &BodyStore,
        contacts: &ContactStore,
        joints: &JointStore,
        islands: &IslandStore,
        settings: &Settings,
        rehearsal: Option<usize>,
    ) {
        self.islands.clear();
        self.place_of.clear();
        self.place_of.resize(islands.islands.len(), NONE);
        for body in self.seated.drain(..) {
            if let Some(seat) = self.seats.get_mut(body as usize) {
                *seat = Seat::NONE;
            }
        }
        self.seats.resize(bodies.bodies.len(), Seat::NONE);
        let mut uneven = false;
        for &index in &bodies.awake().index {
            let island = bodies.bodies[index as usize].island;
            self.seats[index as usize].island = island;
            self.seated.push(index);
            if island == NONE || self.place_of[island as usize] != NONE {
                continue;
            }
            let pacing = &islands.islands[island as usize].pacing;
            let level = match rehearsal {
                Some(_) if !pacing.rehearsed => continue,
                Some(trial) => pacing.trials(settings.sub_steps)[trial],
                None => pacing.level,
            };
            uneven |= level != 0;
            self.place_of[island as usize] = self.islands.len() as u32;
            self.islands.push(AwakeIsland { id: island, constraints: 0, mixed: false, level, rows: 0..0 });
        }
        self.constraints = 0;
        for (k, &c) in contacts.awake.iter().enumerate() {
            contacts.prefetch_head(contacts.awake.get(k + HEADS_AHEAD).copied());
            let contact = &contacts.contacts[c as usize];
            if !contact.is(flags::CONSTRAINT) {
                continue;
            }
            if let Some(island) = self.island_of(contact.body).filter(|&island| self.is_gathered(island)) {
                self.islands[self.place_of[island as usize] as usize].constraints += 1;
                self.constraints += 1;
            }
        }
        if !joints.live.is_empty() {
            uneven |= self.find_mixed(bodies, islands);
        }
        if uneven {
            self.put_alike_together();
        }
    }

    /// Finds the islands that are swept twice a sub-step; says whether there are any.
    fn find_mixed(&mut self, bodies: &BodyStore, islands: &IslandStore) -> bool {
        let mut any = false;
        for island in self.islands.iter_mut().filter(|island| island.constraints > 0) {
            let mut members = islands.islands[island.id as usize].bodies.iter();
            island.mixed = members.any(|&b| !bodies.bodies[b as usize].joints.is_empty());
            any |= island.mixed;
        }
        any
    }

    /// No island's result may depend on which others share its batch, so those that are swept alike have their own.
    fn put_alike_together(&mut self) {
        let Self { islands, place_of, .. } = self;
        islands.sort_unstable_by_key(|island| (island.mixed, island.level, place_of[island.id as usize]));
        for (place, island) in islands.iter().enumerate() {
            place_of[island.id as usize] = place as u32;
        }
    }

    /// Whether an island, by its index in the store, takes part.
    pub fn is_gathered(&self, island: u32) -> bool {
        self.place_of[island as usize] != NONE
    }

    /// Lays the bodies of the gathered islands out, by batch and island.
    pub fn fill(&mut self, bodies: &BodyStore, islands: &IslandStore, settings: &Settings) {
        let awake = bodies.awake();
        self.rows.row.clear();
        self.rows.inertia.clear();
        self.rows.aux.clear();
        self.rows.row.push(Row::IMMOVABLE);
        self.rows.inertia.push(InertiaRow::ZERO);
        self.rows.aux.push(immovable_aux());
        self.row_of.clear();
        self.row_of.resize(awake.len(), 0);
        self.batch_of.clear();
        self.batch_of.resize(islands.islands.len(), NONE);
        self.kinematic_copy.clear();
        self.kinematic_copy.resize(awake.len(), [NONE; 2]);
        self.batches.clear();
        self.isolated.clear();

        let (mut bytes, mut alike) = (usize::MAX, (false, 0));
        for (place, awake_island) in self.islands.iter_mut().enumerate() {
            let island = &islands.islands[awake_island.id as usize];
            let size = island.bodies.len() * (size_of::<Row>() + size_of::<InertiaRow>() + size_of::<Aux>())
                + awake_island.constraints as usize * 70 * size_of::<Float>();
            let (mixed, level) = (awake_island.mixed, awake_island.level);
            if bytes == usize::MAX || bytes + size > BATCH_BYTES || alike != (mixed, level) {
                alike = (mixed, level);
                let (row, isolated) = (self.rows.row.len(), self.isolated.len());
                self.batches.push(Batch {
                    rows: row..row,
                    kinematic: 0..0,
                    isolated: isolated..isolated,
                    islands: place..place,
                    mixed,
                    level,
                });
                bytes = 0;
            }
            bytes += size;
            self.batch_of[awake_island.id as usize] = self.batches.len() as u32 - 1;
            let start = self.rows.row.len();
            let h = settings.at(level).h();
            for &body in &island.bodies {
                let row = bodies.bodies[body as usize].row as usize;
                self.row_of[row] = self.rows.row.len() as u32;
                self.seats[body as usize].row = self.rows.row.len() as u32;
                self.rows.push_body(awake, row, settings, h);
            }
            let end = self.rows.row.len();
            awake_island.rows = start..end;
            let batch = self.batches.last_mut().expect("pushed above");
            batch.rows.end = end;
            batch.islands.end = place + 1;
            if !island.anchored && island.bodies.len() > 1 {
                self.isolated.push(start..end);
                batch.isolated.end = self.isolated.len();
            }
        }
    }

    /// The seats of a pair of bodies.
    #[inline(always)]
    pub fn seats_of(&self, pair: [u32; 2]) -> [Seat; 2] {
        pair.map(|body| self.seats[body as usize])
    }

    /// The awake island that a pair of bodies belongs to: that of either one that moves.
    #[inline(always)]
    pub fn island_of(&self, pair: [u32; 2]) -> Option<u32> {
        self.seats_of(pair).into_iter().map(|seat| seat.island).find(|&island| island != NONE)
    }

    /// The batch of an awake island, by its index in the store.
    pub fn batch_of(&self, island: u32) -> u32 {
        self.batch_of[island as usize]
    }

    /// The place of an awake island in [`Bodies::islands`], by its index in the store.
    pub fn place_of(&self, island: u32) -> u32 {
        self.place_of[island as usize]
    }

    /// The solver row of an island's body.
    pub fn row_of(&self, bodies: &BodyStore, body: u32) -> usize {
        self.row_of[bodies.bodies[body as usize].row as usize] as usize
    }

    /// From here on [`Bodies::row_for`] makes copies of kinematic bodies for this batch.
    pub fn open_batch(&mut self, batch: usize) {
        let end = self.rows.row.len();
        self.batches[batch].kinematic = end..end;
    }

    /// The solver row of a body in the open batch; each batch has its own copies of kinematic bodies.
    pub fn row_for(&mut self, bodies: &BodyStore, body: u32, batch: usize, settings: &Settings) -> u32 {
        let b = &bodies.bodies[body as usize];
        if b.set != SetId::AWAKE {
            return 0;
        }
        if b.island != NONE {
            return self.row_of[b.row as usize];
        }
        let copy = &mut self.kinematic_copy[b.row as usize];
        if copy[0] != batch as u32 {
            *copy = [batch as u32, self.rows.row.len() as u32];
            self.rows.push_body(bodies.awake(), b.row as usize, settings, settings.h());
            self.batches[batch].kinematic.end = self.rows.row.len();
        }
        copy[1]
    }

    /// Bytes held.
    #[must_use]
    pub fn byte_count(&self) -> usize {
        self.rows.row.capacity() * size_of::<Row>()
            + self.rows.inertia.capacity() * size_of::<InertiaRow>()
            + self.rows.aux.capacity() * size_of::<Aux>()
            + self.seats.capacity() * size_of::<Seat>()
    }
}

/// The centre of mass of a body \[m\].
pub fn center(bodies: &BodyStore, body: u32) -> Vec3 {
    let (set, row) = bodies.at(body as usize);
    set.motion[row].x
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
        jointed: false,
        planned: false,
        touched: false,
        joint: [zero; 2],
        joint_middle: zero,
        extra: 0.0,
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
            spin: !mass.isotropic && turns_freely && length(w) * h > spin_bound(settings.integrator),
            supported: false,
            kinematic: drive.kinematic,
            locked: drive.locks.any(),
            ..immovable_aux()
        });
    }
}
