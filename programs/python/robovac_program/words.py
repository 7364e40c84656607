"""Errors that name the cause and the mend."""


class ProgramError(Exception):
    """A mistake in a program, said in words."""


def distance(a, b):
    """Letters to insert, delete, replace or swap to get from `a` to `b`."""
    before, row = [], list(range(len(b) + 1))
    for i in range(1, len(a) + 1):
        older, before, row = before, row, [i] + [0] * len(b)
        for j in range(1, len(b) + 1):
            cost = before[j - 1] + (a[i - 1] != b[j - 1])
            cost = min(cost, before[j] + 1, row[j - 1] + 1)
            if i > 1 and j > 1 and a[i - 1] == b[j - 2] and a[i - 2] == b[j - 1]:
                cost = min(cost, older[j - 2] + 1)
            row[j] = cost
    return row[len(b)]


def nearest(name, names):
    """The one of `names` that is meant by `name`, or None."""
    plain = name.replace("_", "").lower()
    best, least = None, 1 + len(plain) // 3
    for other in names:
        off = distance(plain, other.replace("_", "").lower())
        if off < least or (off == least and best is None):
            best, least = other, off
    return best


def unknown(what, name, names):
    """Says that `what` has no `name`, and what may be meant."""
    meant = nearest(name, names)
    hint = "; did you mean %s?" % meant if meant else ""
    return "%s.%s: there is no such name%s" % (what, name, hint)


def number(place, value):
    """`value` as a float, or an error that names `place`."""
    if isinstance(value, (int, float)):
        value = float(value)
        if value - value == 0.0:
            return value
    raise ProgramError("%s must be a number, not %r" % (place, value))
