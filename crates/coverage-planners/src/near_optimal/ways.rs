//! The ways a walk can pass one cell.

/// Most uses of one side of a cell, see [`super`].
pub(super) const MOST_USES: usize = 3;
const USES: usize = MOST_USES + 1;

/// A side of a cell, counter-clockwise: 0 right, 1 up, 2 left, 3 down.
pub(super) type CellSide = usize;

/// A walk's use of one cell: passages, each in through one side and out through one (perhaps the same), and halves of
/// passages where the walk begins or ends.
#[derive(Debug, Clone)]
pub(super) struct CellWay {
    /// How often each side is used.
    pub used: [u8; 4],
    /// Quarter turns of all passages.
    pub turns: u8,
    /// Which sides are connected: those with the same number. Unused sides have numbers of their own.
    pub groups: [u8; 4],
    /// The passages.
    pub passages: Vec<[CellSide; 2]>,
    /// Sides of halves: of the walk's first step, then of its last.
    pub halves: Vec<CellSide>,
}

/// Ways by how many halves they have.
#[derive(Debug)]
pub(super) struct CellWays {
    by_halves: [Vec<CellWay>; 3],
}

/// Quarter turns between coming in through one side and going out through another.
pub(super) fn turns(a: CellSide, b: CellSide) -> u32 {
    match (a + 4 - b) & 3 {
        0 => 2,
        2 => 0,
        _ => 1,
    }
}

impl CellWays {
    /// All ways that use no side more often than `most_uses`, without those made redundant by another one that uses the
    /// same sides, turns no more and connects more.
    pub fn new(most_uses: usize) -> Self {
        let most_uses = most_uses.min(MOST_USES) as u8;
        let mut by_halves: [Vec<CellWay>; 3] = Default::default();
        let mut halves = vec![vec![]];
        halves.extend((0..4).map(|a| vec![a]));
        halves.extend((0..16).map(|ab| vec![ab / 4, ab % 4]));
        let pairs: Vec<[CellSide; 2]> = (0..4).flat_map(|a| (a..4).map(move |b| [a, b])).collect();
        for halves in halves {
            let mut used = [0; 4];
            for &side in &halves {
                used[side] += 1;
            }
            let mut found = Vec::new();
            if used.iter().all(|&n| n <= most_uses) {
                extend(&pairs, &mut Vec::new(), used, most_uses, &halves, &mut found);
            }
            for (i, way) in found.iter().enumerate() {
                let beaten = found.iter().enumerate().any(|(j, other)| {
                    other.used == way.used
                        && other.turns <= way.turns
                        && is_coarser(other, way)
                        && (other.turns < way.turns || !is_coarser(way, other) || j < i)
                        && j != i
                });
                if !beaten {
                    by_halves[halves.len()].push(way.clone());
                }
            }
        }
        Self { by_halves }
    }

    pub fn with_halves(&self, count: usize) -> &[CellWay] {
        &self.by_halves[count]
    }
}

/// Whether `a` connects everything that `b` connects; both use the same sides.
fn is_coarser(a: &CellWay, b: &CellWay) -> bool {
    (0..4).all(|i| (0..4).all(|j| b.groups[i] != b.groups[j] || a.groups[i] == a.groups[j]))
}

/// Adds every continuation with `passages` of the list.
fn extend(
    pairs: &[[CellSide; 2]],
    passages: &mut Vec<[CellSide; 2]>,
    used: [u8; 4],
    most_uses: u8,
    halves: &[CellSide],
    found: &mut Vec<CellWay>,
) {
    if !(passages.is_empty() && halves.is_empty()) {
        let mut groups = [0, 1, 2, 3];
        for &[a, b] in &*passages {
            let (from, to) = (groups[a], groups[b]);
            groups.iter_mut().filter(|g| **g == from).for_each(|g| *g = to);
        }
        let turns = passages.iter().map(|&[a, b]| turns(a, b) as u8).sum();
        found.push(CellWay { used, turns, groups, passages: passages.clone(), halves: halves.to_vec() });
    }
    for (i, &[a, b]) in pairs.iter().enumerate() {
        let mut used = used;
        used[a] += 1;
        used[b] += 1;
        if used[a] <= most_uses && used[b] <= most_uses {
            passages.push([a, b]);
            extend(&pairs[i..], passages, used, most_uses, halves, found);
            passages.pop();
        }
    }
}

/// Index of a pair of uses, of two sides.
pub(super) fn pair(a: u8, b: u8) -> usize {
    usize::from(a) * USES + usize::from(b)
}

/// Number of such pairs.
pub(super) const PAIRS: usize = USES * USES;
