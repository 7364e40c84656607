//! Rows of bits.

/// A grid of bits, 64 to a word; every row begins with a word of its own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Bits {
    stride: usize,
    words: Vec<u64>,
}

impl Bits {
    /// Number of words of a grid.
    pub fn words(width: usize, height: usize) -> usize {
        width.div_ceil(64).saturating_mul(height)
    }

    /// A grid without a bit set.
    pub fn new(width: usize, height: usize) -> Self {
        Self { stride: width.div_ceil(64), words: vec![0; Self::words(width, height)] }
    }

    /// Number of bits that are set.
    pub fn count(&self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// Sets all bits that are set in another grid of the same size.
    pub fn add(&mut self, other: &Self) {
        self.words.iter_mut().zip(&other.words).for_each(|(word, other)| *word |= other);
    }

    /// The bit in that row and column; both must lie inside.
    #[inline]
    pub fn get(&self, x: usize, y: usize) -> bool {
        self.words[y * self.stride + x / 64] >> (x % 64) & 1 == 1
    }

    /// Number of bits from column `first` to column `last` of a row, both inside, that are set here and not in another grid
    /// of the same size; 0 if `last` is before `first`.
    pub fn count_without(&self, other: &Self, y: usize, first: usize, last: usize) -> usize {
        if first > last {
            return 0;
        }
        let (begin, end) = (first / 64, last / 64);
        let row = y * self.stride + begin..=y * self.stride + end;
        let words = self.words[row.clone()].iter().zip(&other.words[row]).zip(begin..);
        let counts = words.map(|((word, other), place)| {
            let from = if place == begin { u64::MAX << (first % 64) } else { u64::MAX };
            let to = if place == end { u64::MAX >> (63 - last % 64) } else { u64::MAX };
            (word & !other & from & to).count_ones() as usize
        });
        counts.sum()
    }

    /// Sets the bits from column `first` to column `last` of a row, both inside; none if `last` is before `first`.
    #[inline]
    pub fn set(&mut self, y: usize, first: usize, last: usize) {
        if first > last {
            return;
        }
        let row = &mut self.words[y * self.stride..(y + 1) * self.stride];
        let (begin, end) = (first / 64, last / 64);
        let (from, to) = (u64::MAX << (first % 64), u64::MAX >> (63 - last % 64));
        if begin == end {
            row[begin] |= from & to;
        } else {
            row[begin] |= from;
            row[begin + 1..end].fill(u64::MAX);
            row[end] |= to;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_set_across_words_and_nowhere_else() {
        for (first, last) in [(0, 0), (5, 63), (63, 64), (64, 127), (0, 199), (70, 130), (9, 8)] {
            let mut bits = Bits::new(200, 3);
            bits.set(1, first, last);
            for y in 0..3 {
                for x in 0..200 {
                    assert_eq!(bits.get(x, y), y == 1 && (first..=last).contains(&x), "{first} {last} {x} {y}");
                }
            }
        }
    }

    #[test]
    fn bits_that_only_one_has_are_counted_across_words() {
        let (mut bits, mut other) = (Bits::new(200, 3), Bits::new(200, 3));
        bits.set(1, 3, 150);
        other.set(1, 60, 70);
        other.set(1, 149, 199);
        for (first, last) in [(0, 0), (0, 199), (3, 63), (63, 64), (61, 69), (70, 148), (128, 160), (9, 8)] {
            let expected = (first..=last).filter(|&x| bits.get(x, 1) && !other.get(x, 1)).count();
            assert_eq!(bits.count_without(&other, 1, first, last), expected, "{first} {last}");
            assert_eq!(bits.count_without(&other, 0, first, last), 0);
        }
    }
}
