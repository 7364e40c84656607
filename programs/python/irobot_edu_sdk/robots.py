"""All of the SDK that programs usually import."""

from .color import Color
from .create3 import Create3
from .event import event, hand_over
from .robot import Robot
from .root import Root
