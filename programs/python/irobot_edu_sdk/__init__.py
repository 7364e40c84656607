"""The names of iRobot's Education Python SDK, so that its lesson programs drive the simulated or real robot here.

Written anew from the published interface (https://github.com/iRobotEducation/irobot-edu-python-sdk). Centimetres and
degrees; the pose is (0, 0) with heading 90 at the start. What this robot can't do is said once, and nothing happens.
"""
