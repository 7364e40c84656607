"""Random numbers from the run's seed, the same in Python and JavaScript.

L'Ecuyer's MRG32k3a (Good parameters and implementations for combined multiple recursive random number generators,
Operations Research 47(1), 1999): all its products are below 2^53, so that every interpreter computes them exactly.
"""

_M1 = 4294967087.0
_M2 = 4294944443.0


class Chance:
    """A sequence of random numbers. `seed` is a whole number from 0 to 2^53 - 1."""

    def __init__(self, seed):
        low = float(seed % 4294967296)
        high = float(seed // 4294967296)
        self._s = [low % _M1, high, 12345.0, low % _M2, high, 67890.0]
        # Sequences of neighbouring seeds start alike.
        for _ in range(24):
            self.next()

    def next(self):
        """A number between 0 and 1, neither of them."""
        s = self._s
        a = (1403580.0 * s[1] - 810728.0 * s[0]) % _M1
        s[0] = s[1]
        s[1] = s[2]
        s[2] = a
        b = (527612.0 * s[5] - 1370589.0 * s[3]) % _M2
        s[3] = s[4]
        s[4] = s[5]
        s[5] = b
        return (a - b if a > b else a - b + _M1) * 2.328306549295728e-10
