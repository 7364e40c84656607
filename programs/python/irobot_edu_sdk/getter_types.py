"""What getters and events tell."""


class Pose:
    def __init__(self, x=0, y=0, heading=90):
        self.set(x, y, heading)

    def set(self, x, y, heading):
        self.x = x
        self.y = y
        self.heading = heading

    def __str__(self):
        return "Pose (%.2f, %.2f, %.1f°)" % (self.x, self.y, self.heading)


class Movement:
    def __init__(self, distance=0, angle=0):
        self.distance = distance
        self.angle = self.minimize_angle(angle)

    @staticmethod
    def minimize_angle(angle):
        while angle > 180:
            angle -= 360
        while angle < -180:
            angle += 360
        return angle


class Values:
    """Named values."""

    def __init__(self, **values):
        for name in values:
            setattr(self, name, values[name])
