"""Notes: frequencies in whole Hz, durations in seconds."""


class Note:
    SIXTEENTH = 0.0625
    EIGHTH = 0.125
    QUARTER = 0.25
    HALF = 0.5
    WHOLE = 1.0


def _fill():
    names = ("C", "C_SHARP", "D", "D_SHARP", "E", "F", "F_SHARP", "G", "G_SHARP", "A", "A_SHARP", "B")
    for octave in range(1, 10):
        for place in range(12 if octave < 9 else 1):
            letter, _, sharp = names[place].partition("_")
            name = letter + str(octave) + ("_" + sharp if sharp else "")
            # Equal temperament about A4 = 440 Hz.
            setattr(Note, name, int(440.0 * 2.0 ** (octave - 4 + (place - 9) / 12)))


_fill()
