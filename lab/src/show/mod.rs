//! Pictures and pages of what was measured. Everything here reads the CSV files of a directory and computes from
//! nothing else, so whoever has the files can draw it all anew.
//!
//! | file | idea |
//! |---|---|
//! | settings | runs as points: what can be drawn, upright and turned taken together |
//! | pareto, order, profile, hypervolume | what is computed from points |
//! | svg, axis, palette, png | how pictures are made |
//! | work_precision | error against cost, one chart a scene |

mod axis;
mod hypervolume;
mod order;
mod palette;
mod pareto;
mod png;
mod profile;
#[cfg(test)]
mod samples;
mod settings;
mod svg;
mod work_precision;
