// @ts-check
// A lesson to begin with.
import { download } from "../files.js";

const FENCE = "```";
/** The same as in docs/teaching.md; a test holds them equal. */
export const TEMPLATE = `# Corners

${FENCE}lesson
id: corners
minutes: 20
for: students of robotics
outcome: Say why a round robot leaves corners
source: [Choset 2001](https://doi.org/10.1023/A:1016639210559)
${FENCE}

Text in **Markdown**. Raw HTML is shown as text.

${FENCE}scene
title: Set the scene
link: room=living&robot=roomba600&behaviour=bounce&slip=typical
${FENCE}

${FENCE}predict
question: How much of the floor is swept after ten minutes?
option: about half
option: nearly all
answer: 1
because: The robot crosses the same floor again and again.
${FENCE}

${FENCE}do
label: Run it
link: room=living&robot=roomba600&behaviour=bounce&slip=typical&speed=64
${FENCE}

${FENCE}measure
in: room=living&robot=roomba600&slip=typical
row: Bounce | behaviour=bounce
row: Lanes | planner=boustrophedon
runs: 5
minutes: 20
show: coverage, distance, bumps
${FENCE}

${FENCE}goal
title: Sweep nearly everything.
in: room=living&robot=roomba600&behaviour=bounce&slip=typical
change: algorithm, cell
runs: 20
minutes: 20
need: median coverage >= 90 %
${FENCE}

${FENCE}hint
A plan knows where it has been.
${FENCE}

${FENCE}quiz lanes
rounds: 3
${FENCE}
`;

export const saveTemplate = () => download("lesson.md", TEMPLATE, "text/markdown");
