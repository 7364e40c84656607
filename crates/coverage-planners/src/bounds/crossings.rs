//! The possible uses of a cell's sides, and the fewest turns of each.
//!
//! A *use* of a cell's sides says how often each is crossed. Passages pair crossings off; straight ones take no turn, bent
//! ones one and those back through the same side two. With prices, what a use costs is linear in the crossings, plus turn x
//! the fewest turns of any such pairing.
//!
//! The *label* of a side says whether it is not crossed, an odd number of times, or an even one. Of all uses with given labels
//! only few can be the cheapest: if passages can be taken out of a use and what is left has the same labels, then that is no
//! dearer, as no passage costs less than nothing. It can be done with a passage that goes back through a side crossed more
//! than three times, and with two through the same two sides if neither is crossed just twice. In what is left, a side that
//! is crossed more than three times has at most two passages to each of the three others and one half for each end of the
//! walk: eight crossings at most. So the uses that matter are finite, and listed once.

/// Labels of a side: 0 if it isn't crossed, 1 for an odd, 2 for an even number of crossings. Distinguishing one from
/// three would cost time and gain nothing: a side is crossed that often only for the sake of turns.
pub(super) const LABELS: usize = 3;
/// Labels of all four sides.
pub(super) const LABELLINGS: usize = LABELS.pow(4);
/// Most crossings of one side in a use that matters.
const MOST: usize = 8;

/// A use of the four sides.
#[derive(Debug, Clone, Copy)]
pub(super) struct Use {
    /// Crossings of each side, counter-clockwise from the right.
    pub crossings: [u8; 4],
    /// Fewest quarter turns.
    pub turns: u8,
}

/// Per labelling, the uses that may be cheapest. The label of side s is the digit of weight [`LABELS`]^s.
pub(super) type Uses = Vec<Vec<Use>>;

/// The uses of a cell, by the walk's ends that it contains.
#[derive(Debug)]
pub(super) struct Crossings {
    /// Uses without and with the walk's end here.
    pub plain: [Uses; 2],
    /// The same with the walk's start here.
    pub begun: [Uses; 2],
}

/// Fewest turns per use; [`NEVER`] if no such use exists.
struct Turns(Vec<u8>);

const NEVER: u8 = u8::MAX;

impl Crossings {
    /// `first_turns`: quarter turns to a first step through each side.
    pub fn new(first_turns: [u8; 4]) -> Self {
        let whole = Turns::whole();
        let ended = whole.with_half([0; 4]);
        let begun = whole.with_half(first_turns);
        let both = ended.with_half(first_turns);
        Self { plain: [whole.uses(), ended.uses()], begun: [begun.uses(), both.uses()] }
    }
}

fn index(crossings: [usize; 4]) -> usize {
    crossings.iter().rev().fold(0, |index, &count| index * (MOST + 1) + count)
}

fn all() -> impl Iterator<Item = [usize; 4]> {
    (0..(MOST + 1).pow(4)).map(|index| std::array::from_fn(|side| index / (MOST + 1).pow(side as u32) % (MOST + 1)))
}

/// `crossings` without those of `sides`.
fn without(mut crossings: [usize; 4], sides: &[usize]) -> Option<[usize; 4]> {
    for &side in sides {
        crossings[side] = crossings[side].checked_sub(1)?;
    }
    Some(crossings)
}

/// Pairs of sides and the quarter turns between them.
fn passages() -> impl Iterator<Item = ([usize; 2], u8)> {
    let turns = |a: usize, b: usize| if a == b { 2 } else { ((a + b) % 2) as u8 };
    (0..4).flat_map(move |a| (a..4).map(move |b| ([a, b], turns(a, b))))
}

impl Turns {
    /// Of passages alone.
    fn whole() -> Self {
        let mut turns = vec![NEVER; (MOST + 1).pow(4)];
        turns[0] = 0;
        // Taking crossings away gives a smaller index.
        for crossings in all().skip(1) {
            let rest = |(sides, more): ([usize; 2], u8)| {
                without(crossings, &sides).map(|rest| turns[index(rest)].saturating_add(more))
            };
            turns[index(crossings)] = passages().filter_map(rest).min().unwrap_or(NEVER);
        }
        Self(turns)
    }

    /// The same plus half a passage, which crosses one side and takes the given number of turns.
    fn with_half(&self, turns: [u8; 4]) -> Self {
        let fewest = |crossings: [usize; 4]| {
            let rest =
                |side: usize| without(crossings, &[side]).map(|rest| self.0[index(rest)].saturating_add(turns[side]));
            (0..4).filter_map(rest).min().unwrap_or(NEVER)
        };
        Self(all().map(fewest).collect())
    }

    fn uses(&self) -> Uses {
        let mut uses = vec![Vec::new(); LABELLINGS];
        for crossings in all() {
            let turns = self.0[index(crossings)];
            let labels = labels(crossings);
            let is_thinned_by = |sides: &[usize], fewer: u8| {
                without(crossings, sides).is_some_and(|rest| {
                    labels == self::labels(rest) && self.0[index(rest)].saturating_add(fewer) <= turns
                })
            };
            let can_be_thinned = || {
                passages().any(|([a, b], fewer)| {
                    if a == b { is_thinned_by(&[a, a], fewer) } else { is_thinned_by(&[a, a, b, b], 2 * fewer) }
                })
            };
            // An empty use isn't a visit.
            if turns != NEVER && crossings != [0; 4] && !can_be_thinned() {
                let crossings = crossings.map(|count| count as u8);
                uses[labels_index(labels)].push(Use { crossings, turns });
            }
        }
        uses
    }
}

fn labels(crossings: [usize; 4]) -> [usize; 4] {
    crossings.map(|count| if count == 0 { 0 } else { 2 - count % 2 })
}

fn labels_index(labels: [usize; 4]) -> usize {
    labels.iter().rev().fold(0, |index, &label| index * LABELS + label)
}
