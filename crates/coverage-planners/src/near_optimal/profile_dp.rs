//! The cheapest walk through a region, by profile dynamic programming over the border of the processed cells.

use super::{
    region::{Beyond, RegionSite, WalkRegion},
    ways::{CellSide, CellWay, CellWays, PAIRS, pair},
};
use std::{
    collections::HashMap,
    hash::{BuildHasherDefault, Hasher},
};

/// Entries of a state: edges of the frontier, then plugs, then whether the walk's end is set.
const ENTRIES: usize = 40;
type DpState = [u8; ENTRIES];
/// Entry for the end of the walk.
const END: usize = ENTRIES - 1;
/// Most columns and plugs together.
pub(super) const MOST_OPEN: usize = ENTRIES - 2;
/// States kept of all sites together, 12 bytes each; above that no proof is attempted.
const MOST_KEPT: usize = 8_000_000;
/// States processed between two checks for cancellation.
const ASK_EVERY: usize = 2_048;
/// An entry holds a label, and above it how often an edge is used.
const LABEL: u8 = 63;

/// Parameters of a search.
#[derive(Debug, Clone, Copy)]
pub(super) struct DpSearch {
    /// Limit of a walk's cost in the region, noise included, in price units; others are dropped.
    pub limit: i64,
    /// States kept after each cell: the cheapest.
    pub most_states: usize,
    /// Whether to give up if there are more states.
    pub is_all_or_nothing: bool,
}

/// Result of a search.
pub(super) struct DpResult<'w> {
    /// The way used in each site; empty if no walk is below the limit.
    pub ways: Vec<&'w CellWay>,
    /// Cost of these ways, in price units, without noise.
    pub cost: i64,
    /// Whether no state was dropped.
    pub is_exact: bool,
    /// Ways tried.
    pub work: usize,
}

/// A way that a site allows.
#[derive(Clone, Copy)]
struct WayChoice {
    cost: i32,
    halves: u8,
    way: u16,
}

/// Choices of a site by uses of its left and lower side, cheapest first.
type WayChoices = [Vec<WayChoice>; PAIRS];

impl WalkRegion {
    /// Searches for a cheaper walk through the region. `goes_on` is called before each site with the work done.
    pub fn search<'w>(
        &self,
        costs: (i32, i32),
        ways: &'w CellWays,
        search: DpSearch,
        mut goes_on: impl FnMut(usize) -> bool,
    ) -> DpResult<'w> {
        let choices: Vec<WayChoices> = self.sites.iter().map(|site| self.choices(site, costs, ways)).collect();
        let rest = self.rests(&choices);
        let (mut is_exact, mut work, mut kept) = (true, 0, 0);
        let mut layer = vec![(self.begin(), 0_i64)];
        let mut trails: Vec<Vec<(u32, WayChoice)>> = Vec::with_capacity(self.sites.len());
        let mut index: HashMap<DpState, u32, BuildHasherDefault<Mixer>> = HashMap::default();
        for (i, site) in self.sites.iter().enumerate() {
            if !goes_on(work) {
                return DpResult { ways: Vec::new(), cost: self.cost, is_exact: false, work };
            }
            let mut next: Vec<(DpState, i64)> = Vec::new();
            let mut trail = Vec::new();
            index.clear();
            for (from, (state, cost)) in layer.iter().enumerate() {
                if from % ASK_EVERY == ASK_EVERY - 1 && !goes_on(work) {
                    return DpResult { ways: Vec::new(), cost: self.cost, is_exact: false, work };
                }
                let uses = |side: CellSide| match site.beyond[side] {
                    Beyond::Nothing => 0,
                    Beyond::Plug(plug) => self.plugs[plug].uses,
                    Beyond::Site => state[self.slot(site, side)] >> 6,
                };
                for &choice in &choices[i][pair(uses(2), uses(3))] {
                    let is_ended = choice.halves > u8::from(site.is_start);
                    if is_ended && state[END] == 1 {
                        continue;
                    }
                    let total = cost + i64::from(choice.cost);
                    if total + rest[i + 1][usize::from(state[END] == 1 || is_ended)] >= search.limit {
                        if state[END] == 1 {
                            break;
                        }
                        continue;
                    }
                    let way = &ways.with_halves(choice.halves as usize)[choice.way as usize];
                    work += 1;
                    let Some(state) = self.after(i, state, way, is_ended) else { continue };
                    match index.entry(state) {
                        std::collections::hash_map::Entry::Occupied(entry) => {
                            let at = *entry.get() as usize;
                            if total < next[at].1 {
                                next[at].1 = total;
                                trail[at] = (from as u32, choice);
                            }
                        }
                        std::collections::hash_map::Entry::Vacant(entry) => {
                            entry.insert(next.len() as u32);
                            next.push((state, total));
                            trail.push((from as u32, choice));
                        }
                    }
                }
            }
            kept += next.len();
            if next.len() > search.most_states || kept > MOST_KEPT {
                is_exact = false;
                if search.is_all_or_nothing {
                    return DpResult { ways: Vec::new(), cost: self.cost, is_exact, work };
                }
                let worth = |&(state, cost): &(DpState, i64)| cost + rest[i + 1][usize::from(state[END] == 1)];
                let mut order: Vec<u32> = (0..next.len() as u32).collect();
                if search.most_states < order.len() {
                    order.select_nth_unstable_by_key(search.most_states, |&k| (worth(&next[k as usize]), k));
                    order.truncate(search.most_states);
                    order.sort_unstable();
                }
                next = order.iter().map(|&k| next[k as usize]).collect();
                trail = order.iter().map(|&k| trail[k as usize]).collect();
            }
            trails.push(trail);
            layer = next;
        }
        let cheapest = layer.iter().enumerate().min_by_key(|(_, (_, cost))| *cost);
        let Some((mut at, _)) = cheapest else {
            return DpResult { ways: Vec::new(), cost: self.cost, is_exact, work };
        };
        let mut chosen = Vec::with_capacity(self.sites.len());
        for trail in trails.iter().rev() {
            let (from, choice) = trail[at];
            chosen.push(&ways.with_halves(choice.halves as usize)[choice.way as usize]);
            at = from as usize;
        }
        chosen.reverse();
        let cost = self.sites.iter().zip(&chosen).map(|(site, way)| i64::from(self.cost_of(costs, site, way))).sum();
        DpResult { ways: chosen, cost, is_exact, work }
    }

    /// The state before the first site.
    fn begin(&self) -> DpState {
        let mut state = [0; ENTRIES];
        for (entry, plug) in state[self.columns + 1..].iter_mut().zip(&self.plugs) {
            *entry = plug.label;
        }
        state[END] = u8::from(!self.has_end);
        renumber(&mut state[..self.used()]);
        state
    }

    /// Number of entries used, without that of the end.
    fn used(&self) -> usize {
        self.columns + 1 + self.plugs.len()
    }

    /// Entry of the edge or plug at a side of a site.
    fn slot(&self, site: &RegionSite, side: CellSide) -> usize {
        match (site.beyond[side], side) {
            (Beyond::Plug(plug), _) => self.columns + 1 + plug,
            (_, 0 | 2) => self.columns,
            _ => site.column,
        }
    }

    /// The state after a site; `None` if something is closed that can no longer be connected with the rest.
    fn after(&self, index: usize, before: &DpState, way: &CellWay, is_ended: bool) -> Option<DpState> {
        let site = &self.sites[index];
        let mut state = *before;
        let slots: [usize; 4] = std::array::from_fn(|side| self.slot(site, side));
        let is_open = |side: CellSide| side < 2 && site.beyond[side] == Beyond::Site;
        let mut labels = [0; 4];
        for side in 0..4 {
            let is_there = way.used[side] > 0 && !is_open(side);
            if is_there {
                labels[side] = before[slots[side]] & LABEL;
            }
        }
        for side in 0..4 {
            if matches!(site.beyond[side], Beyond::Plug(_)) || (side >= 2 && site.beyond[side] == Beyond::Site) {
                state[slots[side]] = 0;
            }
        }
        state[END] |= u8::from(is_ended);
        // New labels are above all old ones until they are renumbered.
        let mut fresh = LABEL - 4;
        let mut is_closed = false;
        for group in 0..4 {
            let mut label = 0;
            let mut opens = false;
            for side in (0..4).filter(|&side| way.used[side] > 0 && way.groups[side] == group as u8) {
                opens |= is_open(side);
                let other = labels[side];
                if label == 0 {
                    label = other;
                } else if other != 0 && other != label {
                    state[..self.used()]
                        .iter_mut()
                        .filter(|e| **e & LABEL == other)
                        .for_each(|e| *e = *e & !LABEL | label);
                    labels.iter_mut().filter(|l| **l == other).for_each(|l| *l = label);
                }
            }
            if opens {
                if label == 0 {
                    fresh += 1;
                    label = fresh;
                }
                for side in
                    (0..2).filter(|&side| is_open(side) && way.used[side] > 0 && way.groups[side] == group as u8)
                {
                    state[slots[side]] = way.used[side] << 6 | label;
                }
            }
        }
        // The site's uses must still be connected with something, unless all is done.
        for group in 0..4 {
            let mut sides = (0..4).filter(|&side| way.used[side] > 0 && way.groups[side] == group as u8).peekable();
            if sides.peek().is_none() {
                continue;
            }
            let (mut opens, mut label) = (false, 0);
            for side in sides {
                opens |= is_open(side);
                label = label.max(labels[side]);
            }
            let lives = opens || (label != 0 && state[..self.used()].iter().any(|&e| e & LABEL == label));
            is_closed |= !lives;
        }
        if is_closed {
            let is_done = index + 1 == self.sites.len() && state[..END].iter().all(|&e| e == 0);
            let groups = groups_of(way);
            if !is_done || groups != 1 && !is_one(way, &labels) {
                return None;
            }
        } else if index + 1 == self.sites.len() {
            return None;
        }
        if index + 1 == self.sites.len() && state[END] == 0 {
            return None;
        }
        renumber(&mut state[..self.used()]);
        Some(state)
    }

    /// The ways that a site allows.
    fn choices(&self, site: &RegionSite, costs: (i32, i32), ways: &CellWays) -> WayChoices {
        let mut choices: WayChoices = Default::default();
        let least = u8::from(site.is_start);
        let most = least + u8::from(self.has_end);
        for halves in least..=most {
            for (number, way) in ways.with_halves(halves as usize).iter().enumerate() {
                let fits = (0..4).all(|side| match site.beyond[side] {
                    Beyond::Nothing => way.used[side] == 0,
                    Beyond::Site => true,
                    Beyond::Plug(plug) => way.used[side] == self.plugs[plug].uses,
                });
                if !fits {
                    continue;
                }
                let cost = self.seeming_cost_of(costs, site, way);
                choices[pair(way.used[2], way.used[3])].push(WayChoice { cost, halves, way: number as u16 });
            }
        }
        for list in &mut choices {
            list.sort_by_key(|choice| choice.cost);
        }
        choices
    }

    /// The least cost of the sites from each one on: while the walk's end isn't set, and after it is.
    fn rests(&self, choices: &[WayChoices]) -> Vec<[i64; 2]> {
        let mut rests = vec![[0; 2]; choices.len() + 1];
        rests[choices.len()][0] = i64::MAX / 4;
        for (i, (choices, site)) in choices.iter().zip(&self.sites).enumerate().rev() {
            let least = |is_end: bool| {
                let all = choices.iter().flatten();
                let fitting = all.filter(|choice| (choice.halves > u8::from(site.is_start)) == is_end);
                fitting.map(|choice| i64::from(choice.cost)).min().unwrap_or(i64::MAX / 4)
            };
            let [open, ended] = rests[i + 1];
            rests[i][0] = i64::min(least(false) + open, least(true) + ended).min(i64::MAX / 4);
            rests[i][1] = (least(false) + ended).min(i64::MAX / 4);
        }
        rests
    }
}

/// Number of groups of sides that a way connects.
fn groups_of(way: &CellWay) -> usize {
    (0..4).filter(|&group| (0..4).any(|side| way.used[side] > 0 && way.groups[side] == group)).count()
}

/// Whether all sides that a way uses are connected.
fn is_one(way: &CellWay, labels: &[u8; 4]) -> bool {
    let mut used = (0..4).filter(|&side| way.used[side] > 0).map(|side| labels[side]);
    let first = used.next();
    used.all(|label| label != 0 && Some(label) == first)
}

/// Numbers labels in the order in which they appear.
fn renumber(state: &mut [u8]) {
    let mut names = [0_u8; LABEL as usize + 1];
    let mut last = 0;
    for entry in state {
        let label = (*entry & LABEL) as usize;
        if label == 0 {
            continue;
        }
        if names[label] == 0 {
            last += 1;
            names[label] = last;
        }
        *entry = *entry & !LABEL | names[label];
    }
}

/// Mixes the eight bytes of a word at a time; hash collisions by an attacker aren't a concern.
#[derive(Default)]
struct Mixer(u64);

impl Hasher for Mixer {
    fn finish(&self) -> u64 {
        self.0 ^ self.0 >> 29
    }

    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.0 = (self.0.rotate_left(23) ^ u64::from_le_bytes(word)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        }
    }
}
