// @ts-check
// Kinds of odometry, as the tabs Map and Robot offer them.

/** Ids as in `robot::OdometryModel`, with their names in menus. @type {[id: string, name: string][]} */
export const ODOMETRIES = [
  ["arc", "counts, along arcs"],
  ["straight", "counts, straight pieces"],
  ["packet_arc", "distance and angle, along arcs"],
  ["packet_straight", "distance and angle, straight pieces"],
];

export const ODOMETRY_TIP =
  "What tells of the wheels, encoder counts or the packets of distance (whole millimetres) and angle (whole degrees), which lose what they cut off; and how that becomes motion: along arcs, which is exact for a steady turn, or in straight pieces.";
