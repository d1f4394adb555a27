//! The ball joints of meshes, by colour, one and four at a time.

use super::ball::{BallBlock, BallSeed};
use super::row::PUSH_SPEED;
use crate::body::NONE;
use crate::constraint::joint::JointStore;
use crate::math::{Float, Vec3};
use crate::simd::{Four, Lane, Quad};
use crate::solver::SubStep;
use crate::solver::rows::Rows;
use std::ops::Range;

/// Ball joints of one colour: blocks of one width.
#[derive(Clone, Debug)]
struct Color {
    wide: bool,
    blocks: Range<usize>,
}

/// The ball joints of the meshes, one and four at a time.
#[derive(Debug, Default)]
pub struct Balls {
    single: Vec<BallBlock<Float>>,
    four: Vec<BallBlock<Four>>,
    colors: Vec<Color>,
}

/// What is done to every block of ball joints.
pub trait OnBall {
    fn run<L: Lane>(&self, block: &mut BallBlock<L>, rows: &mut Rows);
}

pub struct Forget;
pub struct WarmStart;
pub struct LookAhead<'a> {
    pub ahead: &'a [[Quad; 2]],
    pub rate: Float,
    pub sub: &'a SubStep,
}
pub struct Solve {
    pub share: Float,
    pub leak: Float,
}
pub struct BeginRelax;
pub struct End;

impl OnBall for Forget {
    fn run<L: Lane>(&self, block: &mut BallBlock<L>, _: &mut Rows) {
        block.lambda = crate::simd::V3::zero();
    }
}
impl OnBall for WarmStart {
    fn run<L: Lane>(&self, block: &mut BallBlock<L>, rows: &mut Rows) {
        block.warm_start(rows);
    }
}
impl OnBall for LookAhead<'_> {
    fn run<L: Lane>(&self, block: &mut BallBlock<L>, rows: &mut Rows) {
        block.look_ahead(rows, self.ahead, self.rate, PUSH_SPEED, self.sub);
    }
}
impl OnBall for Solve {
    fn run<L: Lane>(&self, block: &mut BallBlock<L>, rows: &mut Rows) {
        block.solve(rows, self.share, self.leak);
    }
}
impl OnBall for BeginRelax {
    fn run<L: Lane>(&self, block: &mut BallBlock<L>, rows: &mut Rows) {
        block.begin_relax(rows);
    }
}
impl OnBall for End {
    fn run<L: Lane>(&self, block: &mut BallBlock<L>, _: &mut Rows) {
        block.end();
    }
}

impl Balls {
    /// How many joints there are.
    pub fn joint_count(&self) -> usize {
        let four = self.four.iter().flat_map(|block| block.source);
        self.single.len() + four.filter(|&source| source != NONE).count()
    }

    /// How many colours there are so far.
    pub fn color_count(&self) -> usize {
        self.colors.len()
    }

    /// Bytes held.
    pub fn byte_count(&self) -> usize {
        self.single.capacity() * size_of::<BallBlock<Float>>()
            + self.four.capacity() * size_of::<BallBlock<Four>>()
    }

    pub fn clear(&mut self) {
        self.single.clear();
        self.four.clear();
        self.colors.clear();
    }

    /// Appends the joints of one colour.
    pub fn push(&mut self, seeds: &[BallSeed], wide: bool, rows: &Rows) {
        let blocks = if wide {
            let start = self.four.len();
            self.four.extend(seeds.chunks(Four::N).map(|s| BallBlock::new(s, rows)));
            start..self.four.len()
        } else {
            let start = self.single.len();
            self.single.extend(seeds.chunks(1).map(|s| BallBlock::new(s, rows)));
            start..self.single.len()
        };
        self.colors.push(Color { wide, blocks });
    }

    pub fn each(&mut self, colors: Range<usize>, rows: &mut Rows, act: impl OnBall) {
        for color in &self.colors[colors] {
            if color.wide {
                self.four[color.blocks.clone()].iter_mut().for_each(|block| act.run(block, rows));
            } else {
                self.single[color.blocks.clone()].iter_mut().for_each(|block| act.run(block, rows));
            }
        }
    }

    pub fn store(&self, joints: &mut JointStore, dt: Float) {
        fn store<L: Lane>(block: &BallBlock<L>, joints: &mut JointStore, dt: Float) {
            for (lane, &source) in block.source.as_ref().iter().enumerate() {
                if source != NONE {
                    let joint = &mut joints.joints[source as usize];
                    let lambda = block.lambda.get(lane);
                    joint.impulse[..3].copy_from_slice(lambda.as_slice());
                    (joint.total, joint.total_angular) = (block.total.get(lane), Vec3::zeros());
                    joint.total_dt = dt;
                }
            }
        }
        self.four.iter().for_each(|block| store(block, joints, dt));
        self.single.iter().for_each(|block| store(block, joints, dt));
    }
}
