//! Changes of a path that link parts of it anew, with ways round obstacles.

use robovac_core::geometry::Point;

/// What lies between two points of a path becomes one or two parts of it, in a new order.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Relink {
    /// The last point before and the first one behind; that is the number of points if all behind changes.
    pub from: usize,
    pub to: usize,
    /// First and last point of each part, and whether it's reversed.
    parts: [(usize, usize, bool); 2],
    count: usize,
    /// A corner on the way to each part, and from the last one on.
    pub corners: [Option<Point>; 3],
}

/// A piece of a new path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Stretch {
    /// A new corner.
    Corner(Point),
    /// Points of the old path, the first and the last as they are passed.
    Part(usize, usize),
}

impl Relink {
    /// The points from `first` to `last` come in the opposite order.
    pub fn reversed(first: usize, last: usize) -> Self {
        let parts = [(first, last, true), (0, 0, false)];
        Self { from: first - 1, to: last + 1, parts, count: 1, ..Self::default() }
    }

    /// The points from `first` to `last` are carried to between point `after` and the next, and reversed if so wanted.
    pub fn carried(first: usize, last: usize, after: usize, is_reversed: bool) -> Self {
        let carried = (first, last, is_reversed);
        if after > last {
            let parts = [(last + 1, after, false), carried];
            Self { from: first - 1, to: after + 1, parts, count: 2, ..Self::default() }
        } else {
            let parts = [carried, (after + 1, first - 1, false)];
            Self { from: after, to: last + 1, parts, count: 2, ..Self::default() }
        }
    }

    /// What comes between `from` and `to`.
    pub fn stretches(&self) -> impl Iterator<Item = Stretch> {
        (0..=self.count).flat_map(|i| {
            let part = self.parts[..self.count].get(i).map(|&(first, last, is_reversed)| {
                if is_reversed { Stretch::Part(last, first) } else { Stretch::Part(first, last) }
            });
            self.corners[i].map(Stretch::Corner).into_iter().chain(part)
        })
    }

    /// The ends of each new way: to every part, and from the last one to `to`, unless the path ends there. `n` is the number of points.
    pub fn ways(&self, n: usize) -> impl Iterator<Item = (usize, usize)> {
        let parts = self.parts[..self.count].iter().map(
            |&(first, last, is_reversed)| {
                if is_reversed { (last, first) } else { (first, last) }
            },
        );
        let leaves = std::iter::once(self.from).chain(parts.clone().map(|(_, leave)| leave));
        let enters = parts.map(|(enter, _)| enter).chain((self.to < n).then_some(self.to));
        leaves.zip(enters)
    }

    /// The ranges of pieces that are taken out, by the points of their ends.
    pub fn cuts(&self) -> impl Iterator<Item = (usize, usize)> {
        let [one, other] = self.parts.map(|(first, last, _)| (first, last));
        let ordered = if self.count > 1 && other.0 < one.0 { [other, one] } else { [one, other] };
        let count = self.count;
        (0..=count).map(move |i| {
            let begin = if i == 0 { self.from } else { ordered[i - 1].1 };
            (begin, if i < count { ordered[i].0 } else { self.to })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(relink: &Relink) -> Vec<Stretch> {
        relink.stretches().collect()
    }

    #[test]
    fn parts_are_reversed_and_carried() {
        let reversed = Relink::reversed(3, 5);
        assert_eq!((reversed.from, reversed.to), (2, 6));
        assert_eq!(parts(&reversed), [Stretch::Part(5, 3)]);
        assert_eq!(reversed.ways(9).collect::<Vec<_>>(), [(2, 5), (3, 6)]);
        assert_eq!(reversed.ways(6).collect::<Vec<_>>(), [(2, 5)], "nothing behind");
        assert_eq!(reversed.cuts().collect::<Vec<_>>(), [(2, 3), (5, 6)]);
        let on = Relink::carried(3, 4, 7, true);
        assert_eq!(parts(&on), [Stretch::Part(5, 7), Stretch::Part(4, 3)]);
        assert_eq!(on.cuts().collect::<Vec<_>>(), [(2, 3), (4, 5), (7, 8)]);
        let back = Relink::carried(6, 7, 2, false);
        assert_eq!(parts(&back), [Stretch::Part(6, 7), Stretch::Part(3, 5)]);
        assert_eq!(back.ways(9).collect::<Vec<_>>(), [(2, 6), (7, 3), (5, 8)]);
        assert_eq!(back.cuts().collect::<Vec<_>>(), [(2, 3), (5, 6), (7, 8)]);
    }

    #[test]
    fn corners_come_before_their_part() {
        let mut relink = Relink::reversed(1, 3);
        let [one, other] = [1.0, 2.0].map(|x| Point::new(x, 0.0));
        relink.corners[..2].copy_from_slice(&[Some(one), Some(other)]);
        assert_eq!(parts(&relink), [Stretch::Corner(one), Stretch::Part(3, 1), Stretch::Corner(other)]);
    }
}
