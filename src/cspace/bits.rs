//! Rows of bits.

/// A grid of bits, 64 to a word; every row begins with a word of its own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Bits {
    stride: usize,
    words: Vec<u64>,
}

impl Bits {
    /// Words that a grid takes.
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

    /// Sets all bits that are set in another grid of the same size too.
    pub fn add(&mut self, other: &Self) {
        self.words.iter_mut().zip(&other.words).for_each(|(word, other)| *word |= other);
    }

    /// The bit in that row and column; both must lie inside.
    #[inline]
    pub fn get(&self, x: usize, y: usize) -> bool {
        self.words[y * self.stride + x / 64] >> (x % 64) & 1 == 1
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
}
