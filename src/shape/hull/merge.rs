//! From triangles to polygons: triangles in one plane become one face, vertices inside a face or inside an edge go.

use crate::shape::ray::Wide;

/// The loops of the faces after merging triangles whose corners all lie within `flat` of the plane of the largest
/// among them. `None` where that does not give a proper solid; with `flat < 0` nothing is merged.
pub(super) fn polygons(points: &[Wide], triangles: &[[u32; 3]], flat: f64) -> Option<Vec<Vec<u32>>> {
    if flat < 0.0 {
        return Some(triangles.iter().map(|t| t.to_vec()).collect());
    }
    let across = neighbors(triangles)?;
    let mut groups = group(points, triangles, &across, flat)
        .into_iter()
        .map(|members| outline(triangles, &across, &members))
        .collect::<Option<Vec<_>>>()?;
    drop_flat_vertices(&mut groups);
    is_solid(&groups).then_some(groups)
}

/// The triangle across each edge.
fn neighbors(triangles: &[[u32; 3]]) -> Option<Vec<[usize; 3]>> {
    let mut half_edges: Vec<(u32, u32, usize)> = Vec::with_capacity(3 * triangles.len());
    for (i, t) in triangles.iter().enumerate() {
        half_edges.extend((0..3).map(|k| (t[k], t[(k + 1) % 3], i)));
    }
    half_edges.sort_unstable();
    let find = |from, to| {
        half_edges.binary_search_by_key(&(from, to), |&(a, b, _)| (a, b)).ok().map(|i| half_edges[i].2)
    };
    triangles.iter().map(|t| Some([find(t[1], t[0])?, find(t[2], t[1])?, find(t[0], t[2])?])).collect()
}

/// Floods from the largest triangle on: its plane is the best known.
fn group(points: &[Wide], triangles: &[[u32; 3]], across: &[[usize; 3]], flat: f64) -> Vec<Vec<usize>> {
    let cross = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        (b - a).cross(&(c - a))
    };
    let area: Vec<f64> = triangles.iter().map(|t| cross(t).norm_squared()).collect();
    let mut order: Vec<usize> = (0..triangles.len()).collect();
    order.sort_by(|&i, &j| area[j].total_cmp(&area[i]).then(i.cmp(&j)));
    let mut taken = vec![false; triangles.len()];
    let mut groups = Vec::new();
    for seed in order {
        if std::mem::replace(&mut taken[seed], true) {
            continue;
        }
        let n = cross(&triangles[seed]);
        let n = n / n.dot(&n).sqrt();
        let origin = points[triangles[seed][0] as usize];
        let mut members = vec![seed];
        let mut next = 0;
        while next < members.len() {
            for &k in &across[members[next]] {
                let in_plane = |&v: &u32| n.dot(&(points[v as usize] - origin)).abs() <= flat;
                if !taken[k] && triangles[k].iter().all(in_plane) {
                    taken[k] = true;
                    members.push(k);
                }
            }
            next += 1;
        }
        groups.push(members);
    }
    groups
}

/// The rim of a group of triangles, if it is one simple loop.
fn outline(triangles: &[[u32; 3]], across: &[[usize; 3]], members: &[usize]) -> Option<Vec<u32>> {
    let mut rim: Vec<(u32, u32)> = Vec::new();
    for &i in members {
        let outer = (0..3).filter(|&k| !members.contains(&across[i][k]));
        rim.extend(outer.map(|k| (triangles[i][k], triangles[i][(k + 1) % 3])));
    }
    let first = rim.first()?.0;
    let (mut loop_, mut at) = (vec![first], rim[0].1);
    while at != first {
        if loop_.contains(&at) {
            return None;
        }
        loop_.push(at);
        at = rim.iter().find(|e| e.0 == at)?.1;
    }
    (loop_.len() == rim.len()).then_some(loop_)
}

/// A vertex between two faces only lies inside their common edge.
fn drop_flat_vertices(loops: &mut [Vec<u32>]) {
    let top = loops.iter().flatten().max().map_or(0, |&v| v as usize + 1);
    let mut uses = vec![0_u32; top];
    loops.iter().flatten().for_each(|&v| uses[v as usize] += 1);
    for l in loops {
        l.retain(|&v| uses[v as usize] >= 3);
    }
}

/// Whether the loops close to a solid: every edge is met once each way, and Euler's formula holds.
fn is_solid(loops: &[Vec<u32>]) -> bool {
    let mut edges = Vec::new();
    for l in loops {
        if l.len() < 3 {
            return false;
        }
        edges.extend((0..l.len()).map(|i| (l[i], l[(i + 1) % l.len()])));
    }
    edges.sort_unstable();
    let once = edges.windows(2).all(|w| w[0] != w[1]);
    let both_ways = edges.iter().all(|&(a, b)| edges.binary_search(&(b, a)).is_ok());
    let mut vertices: Vec<u32> = edges.iter().map(|e| e.0).collect();
    vertices.dedup();
    once && both_ways && vertices.len() + loops.len() == edges.len() / 2 + 2
}
