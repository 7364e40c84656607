// @ts-check
// Kinds of odometry, as the tabs Explore, Map and Robot offer them.

/** Ids as in `robot::OdometryModel`, with their names in menus. @type {[id: string, name: string][]} */
export const ODOMETRIES = [
  ["arc", "encoder counts, arcs"],
  ["straight", "encoder counts, straight segments"],
  ["packet_arc", "distance and angle, arcs"],
  ["packet_straight", "distance and angle, straight segments"],
];

export const ODOMETRY_TIP =
  "The data: encoder counts, or the packets with distance (whole millimetres) and angle (whole degrees), which lose the fractions. The model: arcs, exact for a steady turn, or straight segments.";
