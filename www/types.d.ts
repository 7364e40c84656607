// Generated from the Rust types by `cargo test --test page types`: change them there.

/** An answer file. */
export type Answer = {
/** Version of the format; 1. */
robovac_answer: number,
/** Id of the lesson. */
lesson: string,
/** [`digest`] of the lesson's text; empty if unknown. */
lesson_digest: string,
/** Who hands it in; can be empty. */
name: string,
/** Answers to goals, by the ids of these. */
goals: { [key in string]: GoalAnswer },
/** Answers to quizzes, by the ids of these. */
quizzes: { [key in string]: QuizAnswer },
/** Predictions, by the ids of these: the number of the option, from 0. */
predictions: { [key in string]: number }, };

/** Median and central 80 % of values; see [`quantile`] for the definition. */
export type Band = {
/** A tenth of the values is lower. */
low: number,
/** Half of the values are lower. */
median: number,
/** A tenth of the values is higher. */
high: number, };

/** Readings of the battery gauge. */
export type BatteryView = {
/** Remaining share of the capacity, 0 to 1. */
share: number,
/** Current, mA, negative while discharging. */
current_ma: number,
/** Whether the robot charges on its dock. */
on_dock: boolean,
/** Whether the gauge was read. */
is_known: boolean,
/** Whether it is low. */
is_low: boolean, };

/** Beams detected by an infrared receiver. */
export type BeamsView = {
/** Beams: `green`, `field` and `red` of a dock, `wall` of a virtual wall. */
lit: Array<string>,
/** The same in words. */
text: string, };

/** One case's result. */
export type BenchResult = {
/** Name of the case. */
name: string,
/** Median time of one run, ms. */
ms: number,
/** Speed relative to real time, for simulations. */
times_real_time: number | null,
/** Peak memory of the program so far, MB (10^6 bytes); `None` if unknown. */
memory_mb: number | null, };

/** Which values of a metric are better. */
export type Better = "lower" | "higher";

/** An outline by its dimensions, m. */
export type BodyChoice = { "kind": "model",
/** Its id. */
id: string, } | { "kind": "circle",
/** Its radius. */
radius: number, } | { "kind": "rectangle",
/** Length along its heading. */
length: number,
/** Width. */
width: number, } | { "kind": "octagon",
/** From side to side. */
width: number, } | { "kind": "polygon",
/** Its corners, `x y; x y; ...`: x ahead, y to the left. */
corners: string, };

/** Proven lower bounds for every walk that begins at a job's start, ends anywhere and visits all its cells.
 *
 * A walk that reaches a bound is best possible in that number; often none does. */
export type Bounds = {
/** Fewest steps. */
steps: number,
/** Fewest quarter turns; a reversal counts two, the turn before the first step isn't counted. */
turns: number,
/** Least steps + [`TURN_STEPS`] x quarter turns; can exceed the sum of the two bounds above. */
cost: number, };

/** State of the wire that wakes a robot. */
export type BrcWire = "low" | "high" | "none";

/** Kinds of calibrations. */
export type Calibration = "nudge" | "spin" | "metre" | "square" | "square_right";

/** A calibration. */
export type CalibrationView = {
/** `nudge`, `spin`, `metre`, `square` or `square_right`; empty for none. */
what: "" | "nudge" | "spin" | "metre" | "square" | "square_right",
/** `none`, `moving`, `asking`, `done` or `failed`. */
step: "none" | "moving" | "asking" | "done" | "failed",
/** Progress, question or result. */
text: string,
/** What the question asks for, as measured on the floor of a virtual robot; empty for others. */
measured: string,
/** Unit of the answer: `yes` for yes or no, `deg`, `m`; empty for no question. */
asks: "" | "yes" | "deg" | "m",
/** Suggested answer. */
suggestion: number,
/** Whether the encoders are swapped, as in use now. */
swapped: boolean,
/** True distance divided by the encoders' distance, as in use now. */
distance_factor: number,
/** True wheel base divided by 235 mm, as in use now. */
base_factor: number, };

/** A title and a note; both can be empty. */
export type Caption = {
/** A title. */
title: string,
/** A sentence; empty for none. */
note: string, };

/** The choices in menus and forms: rooms, planners, behaviours, robots, sensors with noise, cell sizes and speeds. */
export type Catalogue = { rooms: Array<RoomEntry>, planners: Array<CatalogueEntry>, behaviours: Array<CatalogueEntry>, robots: Array<RobotEntry>,
/** Ids and labels. */
sensors: [[string, string], [string, string], [string, string], [string, string], [string, string], [string, string], [string, string]],
/** Numbers of plans, as in tables. */
metrics: Array<MetricInfo>, cell_sizes_m: [number, number, number, number, number, number, number, number], speeds: [number, number, number, number, number, number, number], };

/** A planner or behaviour. Claims that only the other kind has are false. */
export type CatalogueEntry = { id: string, title: string, summary: string,
/** `planner` or `behaviour`. */
kind: "planner" | "behaviour", mark: Mark, complete: boolean, deterministic: boolean, fast: boolean, anytime: boolean,
/** The parameter that says how much of the floor its plans sweep; others sweep what they can. */
coverage_param: string | null, ends: boolean, cleans: boolean, manual: boolean, params: Array<Param>, };

/** A question with options. */
export type Choice = {
/** Its name in answers. */
id: string,
/** The question. */
question: string,
/** The options. */
options: Array<string>,
/** Index of the right one. */
right: number,
/** Why, as safe HTML. */
because: string, };

/** Snapshot of a comparison, one per frame. */
export type ComparisonView = { version: number, set: string, sets: Array<[string, string]>, seeds: number, rooms: Array<string>,
/** Number of the session's room in `rooms`. */
done: number, total: number, cancelled: boolean, entrants: Array<EntrantView>,
/** Chosen entrants that could race, but don't: nine race at most. */
waiting: Array<number>,
/** Which of those that race leaves if one of them joins; `None` while there is room. */
leaves: number | null, race: RaceView | null, };

/** Which requests are allowed. */
export type ConnectionActions = {
/** Connect again. */
connect: boolean,
/** Disconnect. */
disconnect: boolean,
/** Take control. */
arm: boolean,
/** Give control up. */
disarm: boolean,
/** Drive, run programs, calibrate, play songs, switch motors and lights. */
drive: boolean,
/** Drive by hand: no program is driving. */
steer: boolean,
/** Start a program. */
ride: boolean,
/** Press buttons, send raw bytes. */
press: boolean, };

/** Snapshot of a connection, taken 20 times a second. */
export type ConnectionView = {
/** `closed`, `diagnosing`, `waiting` (no answer; it keeps trying), `connected` or `lost` (the line is open, but
 * frames no longer arrive). */
phase: "closed" | "diagnosing" | "waiting" | "connected" | "lost",
/** The diagnosis of the device on the line. */
diagnosis: DiagnosisView,
/** `Passive`, `Safe` or `Full`; empty while unknown. */
mode: "" | "Off" | "Passive" | "Safe" | "Full",
/** Whether the robot's mode byte is one too high. */
mode_offset: boolean,
/** The program or person that drives. */
ride: DriveSessionView | null,
/** The robot's sensor readings; `None` before the first one and when not connected. */
readings: RoombaView | null,
/** The robot's estimated pose: x, y in m, heading in rad. */
pose: [number, number, number],
/** Id of its odometry model. */
odometry: string,
/** Path driven, m. */
distance_m: number,
/** Brushes and vacuum that run by command, as the bits of a request for motors. */
motors: number,
/** Their duty cycles in 1/128: main brush, side brush, vacuum. */
duty: [number, number, number],
/** Lights that are on by command. */
lights: LightsView,
/** Requested wheel speeds that were sent last, left and right, m/s. */
wheels: [number, number],
/** Whether the robot is driven by this program, or is about to be. */
is_moving: boolean,
/** Whether it has driven at half its speed for a while because the page responds slowly. */
is_slowed: boolean,
/** Whether it moves otherwise: by its own program, by raw bytes, or pushed. */
moves_alone: boolean,
/** Its activity. */
doing: Caption,
/** The line below its bytes. */
transport: TransportView,
/** Name and state of the line. */
line: Caption,
/** Whether a line is open or expected to return. */
is_open: boolean,
/** Whether this is a recording, which has no line. */
is_recording: boolean,
/** Statistics of the line. */
statistics: Statistics,
/** Time until the robot falls asleep, s; `None` unless it is Passive and off the dock. */
sleeps_in_s: number | null,
/** Time in Safe or Full, without charging, s. */
awake_s: number | null,
/** A sentence on these, if relevant; empty otherwise. */
clock: string,
/** Why it left Safe or Full. */
drop: DropView | null,
/** The calibration in progress, or its result. */
calibration: CalibrationView,
/** Firmware reported by the robot. */
firmware: string | null,
/** The latest message. */
notice: Notice | null,
/** Which requests are allowed now. */
can: ConnectionActions, };

/** Diagnosis of the device on the line. */
export type DiagnosisView = {
/** Current test: `listening`, `asking`, `waking`, `slow` (19200 baud), `create1` (57600 baud), `done`. */
step: string,
/** Finding: `nothing` (yet), `silence`, `stream`, `charging`, `booting`, `bootloader`, `garbage`, `text`,
 * `no_stream`, `robot`. */
finding: "" | "nothing" | "silence" | "stream" | "charging" | "booting" | "bootloader" | "garbage" | "text" | "no_stream" | "robot",
/** One sentence on it. */
text: string,
/** Advice; empty for none. */
remedy: string,
/** Tests so far and their results, in order. */
log: Array<string>,
/** Whether it is shown, which is while not connected. */
is_shown: boolean,
/** Its picture: a file in `www/connection/pictures/`, without `.svg`. */
picture: string,
/** The test or finding with advice, in words. */
caption: Caption, };

/** Effect of closing doors. */
export type Doors = {
/** Openings that would be closed in addition; 0 if it isn't known where. */
count: number,
/** Gap setting that closes them, m. */
gap: number,
/** Free floor of the room then, m². */
floor_m2: number, };

/** The part of a drawing to be traced, in its unit. */
export type DrawingPart = { "kind": "indoors" } | { "kind": "whole" } | { "kind": "rectangle",
/** Two opposite corners. */
corners: [[number, number], [number, number]], } | { "kind": "polygon",
/** Its corners. */
corners: Array<[number, number]>, } | { "kind": "room",
/** The point. */
at: [number, number], };

/** Tools for clicks. */
export type DrawingTool = "view" | "scale" | "rectangle" | "polygon" | "room";

/** The program or person that drives the robot. */
export type DriveSessionView = {
/** Name of the algorithm. */
title: string,
/** Its activity. */
activity: string,
/** Time since it began, s. */
time_s: number,
/** Whether a person drives with a joystick. */
manual: boolean,
/** Why forward, left, right and backward are blocked, if a person drives. */
blocked: [string | null, string | null, string | null, string | null],
/** Index of the planned line's corner that it drives to. */
corner: number | null,
/** Whether it is done. */
done: boolean,
/** Why it was ended early; empty if it wasn't. */
ended: string, };

/** Why the robot left Safe or Full. */
export type DropView = {
/** The mode before. */
from: string,
/** One sentence. */
text: string,
/** What to do, or why control can't be taken back. */
remedy: string,
/** Whether control can be taken back at once. */
can_rearm: boolean, };

export type EntrantView = { id: string, kind: "planner" | "behaviour",
/** With what tells it from its copies. */
title: string,
/** That alone, such as "vertical"; empty without copies. */
distinction: string, mark: Mark,
/** 1, or 2 and up for copies; 0 for one that was removed, and for a program that isn't there. */
copy: number, chosen: boolean,
/** What the robot lacks for it; it then doesn't take part. */
lacks: string, params: Params,
/** `out`, `trying`, `done` or `failed`. */
state: "out" | "trying" | "done" | "failed",
/** 0 to 1. */
progress: number, message: string, };

/** What an entry of a timeline is about. */
export type EntryKind = "line" | "mode" | "hazard" | "frames" | "battery" | "command" | "robot";

export type ExampleEntry = { room: string, why: string, };

/** An explanation. The page loads them from `www/explainers.json`, and the opening scene's from a file of its own. */
export type ExplainerEntry = { idea: string, complexity: string, use_when: string, shines: ExampleEntry, fails: ExampleEntry, source: string, link: string, };

/** Progress of a film. */
export type FilmView = {
/** Index of the current picture; the number of pictures once it's over. */
at: number,
/** Number of pictures. */
pictures: number,
/** Whether it plays by itself. */
runs: boolean, };

/** The parts of a generated flat's name: joined, they are the name. */
export type FlatView = {
/** Its seed, which can be larger than a JavaScript number. */
seed: string,
/** Its area, as in `~area:40..60`; empty if any. */
area: string,
/** What else it has. */
more: string, };

/** Settings of the Floor plan tab. */
export type FloorPlanSettings = {
/** Metres per unit of the drawing; `None` until known. */
metre: number | null,
/** The role of every layer. */
roles: Array<Role>,
/** Widest gap between walls that is closed, m. */
gap: number,
/** Widest opening to the outside that is closed indoors, m. */
outer: number,
/** Side of the room's cells, m. */
resolution: number,
/** The part to be traced. */
part: DrawingPart,
/** Angle by which the file is turned, degrees counter-clockwise, above -180 to 180. */
turn: number,
/** How the shades of an image are told apart. */
method: ShadeMethod,
/** Shades of an image that are walls: those darker than this, 0 (black) to 1 (white). For the method *level*. */
shade: number,
/** How much darker than their surroundings walls are, 0 to 1. For the method *local*. */
contrast: number,
/** Marks of an image that are smaller than this are left out, m; and words and symbols of doors, unless it
 * is 0. Not by the method *map*. */
specks: number,
/** Whether light shades are walls instead. */
negate: boolean,
/** The robot's outline. */
body: BodyChoice,
/** Distance between scan lines, m; half the robot's width if `None`. */
scan_width: number | null,
/** The order in which subgoals are linked. */
order: LinkOrder,
/** Distance that the sweep keeps from everything, m. */
clearance: number,
/** Side of the obstacle map's cells, m. */
cell: number,
/** Headings of the obstacle map. */
headings: number,
/** The unit, m, whose unusual size the user has confirmed. */
confirmed: number | null, };

/** Snapshot of a floor plan, and of the displayed part of its sweep. */
export type FloorPlanView = {
/** Time taken to plan the sweep, s. */
seconds: number,
/** Displayed stage of the sweep, 0 for none. */
stage: number,
/** Heading of the displayed slice, -1 for none. */
slice: number,
/** Its name. */
name: string,
/** `drawing`, `image` or `map`. */
kind: "drawing" | "image" | "map",
/** Whether a file states its unit. */
says_unit: boolean,
/** Pixels of the file on a side of one that is shown: more than 1 for a picture that was reduced. */
reduced: number,
/** The size of the file then, in words; empty otherwise. */
reduced_from: string,
/** Whether it can be scaled. */
is_scalable: boolean,
/** Size of the source, in words, if known. */
size: string | null,
/** The units in the menu, with the size that the source would have in each. */
units: Array<UnitView>,
/** Whether a room's cells can be chosen: an image's pixels are finer than they. */
has_cells: boolean,
/** Whether a picture's size is only assumed. */
assumes_size: boolean,
/** The side of a pixel of an image's file that is assumed, in words; empty once another is chosen. */
assumed_pixel: string,
/** Width of outer doors, m, up to which openings to the outside are closed at first. */
outer_door: number,
/** A size that is unusual for a room, in words, until it is confirmed; empty otherwise. */
asks: string,
/** The scales of a plan on paper that would give a usual size, while the size is asked about. */
papers: Array<UnitView>,
/** Angle by which the walls are askew, degrees; `None` if they are straight or have no common direction. */
askew: number | null,
/** Layers of a drawing. */
layers: Array<LayerView>,
/** Number of strokes of a drawing. */
strokes: number,
/** Content that isn't drawn. */
left_out: Array<string>,
/** Its settings. */
settings: FloorPlanSettings,
/** The room, if there is one. */
room: TracedRoomView | null,
/** Open doors through which a chosen room extends. */
doors: Doors | null,
/** The width up to which openings to the outside have to be closed, m, so that the one that the notice is about is. */
closes: number | null,
/** Whether the notice is about openings that were closed, and can be left open. */
opens: boolean,
/** What can be wrong with the room, in words; empty for nothing. */
notice: string,
/** Why there is no room; empty if there is one or the user has yet to choose. */
fault: string,
/** The tool for clicks. */
tool: DrawingTool,
/** Number of points set. */
points: number,
/** Whether two scale points are set. */
is_measured: boolean,
/** Their present distance, m. */
measured_m: number | null,
/** Width of the robot, m; `None` if it is invalid. */
body_width: number | null,
/** Corners of its outline for a small picture, m; x ahead, y to the left. Empty for a circle. */
body: Array<[number, number]>,
/** Error of the robot's outline. */
body_fault: string,
/** The sweep, once planned. */
sweep: SweepView | null,
/** One or two sentences that describe the picture. */
words: string, };

/** Tools of the pointer on the floor. */
export type FloorTool = "view" | "wall" | "erase" | "start" | "place";

/** A task: settings to start from, what may be changed, and the condition. */
export type Goal = {
/** Its name in answers. */
id: string,
/** What to achieve, in a sentence; empty if the condition says it all. */
title: string,
/** The settings to start from, as in links; they miss the goal. */
start: string,
/** The room, if `start` names none: the id of a scene with a scenario. */
scene: string | null,
/** Names of what may be changed. */
changes: Array<string>,
/** The seeds: the first, and how many. */
first_seed: number,
/** Number of runs. */
runs: number,
/** Simulated time of each run, min. */
minutes: number,
/** All must hold. */
needs: Array<Need>, };

/** The answer to a goal. */
export type GoalAnswer = {
/** The settings, as in links. */
link: string,
/** The program, if the settings say that one drives or plans. */
program?: Program,
/** The runs that the page made; grading makes them again. */
runs: Array<RunRecord>, };

/** A condition and what was measured. */
export type Judged = {
/** The condition. */
text: string,
/** The measured value, in the number's unit; `None` if too few runs got there. */
value: number | null,
/** Its unit. */
unit: string,
/** Whether it holds. */
passed: boolean, };

export type LaneView = {
/** Its number in `entrants`. */
entrant: number,
/** When it had swept 95 % and arrived, s. */
won_s: number | null, coverage: number, time_s: number, distance_m: number, turning_deg: number, finished: boolean,
/** Rank, from 1. */
place: number, };

/** A layer. */
export type LayerView = {
/** Its name. */
name: string,
/** `#rrggbb`, as in the file. */
colour: string,
/** Number of strokes. */
strokes: number,
/** Its role. */
role: Role, };

/** A lesson. */
export type Lesson = {
/** Its name in links and answers: small letters, digits, dashes. */
id: string,
/** Its heading. */
title: string,
/** How long it takes, min; 0 if unknown. */
minutes: number,
/** For whom it is; can be empty. */
audience: string,
/** What one can do afterwards. */
outcomes: Array<string>,
/** Labels of the page's numbers and controls that it explains; the definitions there lead to it. */
explains: Array<string>,
/** Sources, as safe HTML. */
sources: Array<string>,
/** Digest of the text. */
digest: string,
/** Its content, in order. */
blocks: Array<LessonBlock>, };

/** A part of a lesson. */
export type LessonBlock = { "kind": "prose",
/** Safe HTML. */
html: string, } | { "kind": "scene" } & LessonScene | { "kind": "predict" } & Choice | { "kind": "do",
/** What is on it. */
label: string,
/** Settings, as in links; can be empty. */
link: string, } | { "kind": "goal" } & Goal | { "kind": "hint",
/** Safe HTML. */
html: string, } | { "kind": "code",
/** `python` or `javascript`. */
language: string,
/** Its text. */
text: string, } | { "kind": "measure" } & Measure | { "kind": "quiz" } & Quiz;

/** A scene. */
export type LessonScene = {
/** Its name for goals; can be empty. */
id: string,
/** What is on its button. */
title: string,
/** Settings, as in links; empty for a scenario. */
link: string,
/** The text of a scenario file; empty for a link. */
scenario: string, };

/** Lights that are on by command; all dark while the robot has them for itself. */
export type LightsView = {
/** Bits: debris, spot, dock, check. */
lamps: number,
/** Colour of the Clean button, 0 green to 255 red, and its brightness, 0 to 255. */
clean_light: [number, number],
/** The four digits. */
digits: string,
/** Bits, the lowest for Sunday. */
weekdays: number,
/** Bits: colon, PM, AM, clock, schedule. */
schedule: number, };

/** Request to the transport. */
export type LineRequest = { "baud": number } | { "brc": boolean } | "stop";

/** The order in which subgoals are linked. */
export type LinkOrder = "nearest" | "printed" | "uncrossed";

/** What a link asks for. */
export type LinkOutline = {
/** It would change nothing but an own room. Keys of other tabs don't count. */
is_shown: boolean,
/** The room was drawn or loaded. */
has_own_room: boolean,
/** A program of the user drives or plans. */
has_program: boolean, };

export type ManyRunsEntrant = { id: string, title: string, summary: string,
/** `planner` or `behaviour`. */
kind: "planner" | "behaviour",
/** Whether it is measured by the boundary that it has met rather than by clean floor. */
explores: boolean, mark: Mark, params: Array<Param>, };

export type ManyRunsEntrantView = {
/** That of the user's program has its name. */
title: string, chosen: boolean,
/** Whether it can take part: the user's program only if there is one of its kind. */
offered: boolean,
/** What the robot lacks for it; it then doesn't take part. */
lacks: string, params: Params,
/** Finished runs among the required ones. */
runs: number, failure: string, };

/** The choices available for many runs. */
export type ManyRunsOffer = { entrants: Array<ManyRunsEntrant>, seeds: [number, number, number], minutes: [number, number, number, number], };

/** Place and conditions of all runs, in words. */
export type ManyRunsPlace = { room: string, robot: string, slip: string, noise: string, quantised: boolean, start_charge_percent: number, };

/** Snapshot of many runs, one per frame. */
export type ManyRunsView = { version: number, running: boolean, done: number, total: number, seeds: number, minutes: number, entrants: Array<ManyRunsEntrantView>, };

/** Actions that are allowed now. */
export type MapActions = {
/** Start or continue. */
play: boolean,
/** Pause. */
pause: boolean,
/** Advance by a few seconds. */
step: boolean,
/** Seek another time. */
seek: boolean,
/** Pick the robot up. */
lift: boolean,
/** Put it down. */
put_down: boolean,
/** Start again. */
forget: boolean,
/** Export the map. */
use_map: boolean,
/** Clean by the map. */
clean: boolean,
/** Give the robot a map. */
open: boolean, };

/** Errors of a mapper's map and pose. */
export type MapErrorFigures = {
/** Distance between the robot's true and estimated position, m; `None` while there is no estimate. */
position_m: number | null,
/** Angle between its true and estimated heading, degrees, 0 to 180. */
heading_deg: number | null,
/** Share of the known cells that are right within one cell, 0 to 1; 1 while nothing is known. */
right: number,
/** Share of the floor that the body can cover that is known to be free, 0 to 1. */
known: number,
/** Share of the boundary that a bumper can find that is on the map, to within one cell, 0 to 1. */
boundary: number, };

/** Phase of a mapping run. */
export type MapPhase = "failed" | "ready" | "playing" | "paused" | "held" | "seeking" | "resuming" | "finished";

/** The program that is chosen as method. */
export type MapProgramView = {
/** Its name; empty while there is none. */
name: string,
/** Changes when it has to be run again: from the start, or from a person's last input on. */
version: number,
/** Steps for which its commands are known. */
reach_steps: number,
/** Whether it drives: the robot fits in, and doesn't clean by its map. */
drives: boolean,
/** Which program of a link is missing, as sentences for users; empty if none is. */
missing: string, };

/** Snapshot of a mapping run. SI units; shares from 0 to 1. */
export type MapView = {
/** Phase of the run. */
phase: MapPhase,
/** Actions that are allowed now. */
can: MapActions,
/** Why the robot can't be placed in the room, or the program can't drive it; empty if it can. */
complaint: string,
/** Name of the room. */
title: string,
/** Id of the behaviour. */
behaviour: string,
/** The user's program, if that is the method. */
program: MapProgramView | null,
/** The robot's activity, in a few words. */
activity: string,
/** Its parameters. */
params: Params,
/** How the robot estimates its pose. */
tracking: string,
/** What to expect of the robot's maps, if it has nothing but a bumper, or lacks what the method needs;
 * else empty. */
expectation: string,
/** How wheel counts are converted to motion. */
counts: string,
/** Level of wheel slip. */
wheels: string,
/** Level of sensor noise; empty if the kinds differ. */
senses: string,
/** The grid that is shown, measured and exported. */
grid: string,
/** Layers that are shown. */
layers: Array<string>,
/** Set speed, times real time; 0 for as fast as possible. */
speed: number,
/** Achieved speed, times real time. */
speed_factor: number,
/** Displayed time, s. */
time_s: number,
/** Furthest simulated time, s. */
end_s: number,
/** Progress of restoring a stored run; `None` if none is being restored. */
returned: number | null,
/** Errors of the map. */
figures: MapErrorFigures | null,
/** Errors of a map by odometry alone. */
odometry: MapErrorFigures | null,
/** Errors of dead reckoning, one for each odometry model in the order of their registry: m and degrees. */
drifts: Array<[number, number]>,
/** Standard deviations of the estimate: along the longer axis of the ellipse (m), and heading (degrees). */
spread: [number, number] | null,
/** Name of the map given to the robot; `None` if it makes its own. */
known: string | null,
/** Whether it has relocalised on that map; `None` if it was never lost. */
is_sure: boolean | null,
/** Id of the planner for the remaining floor. */
planner: string,
/** Number of frontiers. */
frontiers: number,
/** Whether it follows a route. */
has_route: boolean,
/** Whether it cleans by its map. */
is_cleaning: boolean,
/** Floor reachable by its map that it has swept by its estimate, and all floor reachable by its map, m²; `None`
 * unless it cleans by a map. */
by_map: [number, number] | null,
/** Floor cleaned by the robot's own estimate, m². */
cleaned_m2: number,
/** Swept share of the reachable floor. */
coverage: number,
/** Area where it has found dirt, m². */
dirt_m2: number,
/** Number of samples of the curve; changes with them. */
samples: number,
/** Changes whenever another run, or another time of it, is displayed. */
version: number,
/** Whether the robot is held on the picture; not part of the session. */
is_carried: boolean, };

/** A mark that no other algorithm has. */
export type Mark = { colour: number, shape: number, };

/** A table: one row for each setting, one column for each number, medians over the runs. */
export type Measure = {
/** What it shows; can be empty. */
title: string,
/** The rows. */
rows: Array<MeasureRow>,
/** The columns: name with unit. */
columns: Array<string>,
/** The columns' numbers. */
numbers: Array<Number>,
/** Number of runs of each row; seeds from 1. */
runs: number,
/** Simulated time of each run, min. */
minutes: number, };

/** A row. */
export type MeasureRow = {
/** Its name. */
title: string,
/** Its settings, as in links. */
link: string, };

/** Median and range of a number over several seeds. */
export type MedianAndRange = {
/** The median. */
median: number,
/** The smallest value. */
min: number,
/** The largest value. */
max: number, };

/** A column of a table of plans. */
export type MetricInfo = {
/** Name in files and on the command line. */
id: string,
/** Name in tables. */
label: string,
/** Unit of the value; empty for counts. */
unit: string,
/** Definition, in one or two sentences. */
definition: string,
/** Which values are better. */
better: Better,
/** Digits shown after the decimal point. */
decimals: number,
/** How the value is rounded to them. */
rounding: RoundingMode, };

/** One condition. */
export type Need = {
/** As it was written. */
text: string,
/** Over the runs. */
statistic: Statistic,
/** What is measured. */
number: Number,
/** Whether at least `value` is needed; else at most. */
at_least: boolean,
/** The limit, in the number's unit. */
value: number, };

/** A message. */
export type Notice = {
/** Number of the message, which increases. */
number: number,
/** `notice` or `error`. */
kind: "notice" | "error",
/** The message for users. */
text: string, };

/** A number of a run. */
export type Number = "coverage" | "time" | "time_to90" | "time_to99" | "distance" | "bumps" | "falls" | "dirt_left" | "excess_distance" | "excess_time";

/** Models that convert the rolling of wheels to a change of pose: the source of the measurement, and the assumed line. */
export type OdometryModel = "arc" | "straight" | "packet_arc" | "packet_straight";

/** Figures of an own robot as they are typed, m, m/s and degrees a second; empty ones are the model's. */
export type OwnRobotForm = {
/** Kind of body. */
shape: OwnShape,
/** Diameter or width. */
first: string,
/** Length of a rectangle. */
second: string,
/** Corners of a polygon: `x y; x y; …`. */
corners: string,
/** Whether it cleans all floor under its body. */
cleans_all: boolean,
/** Width of the tool. */
tool: string,
/** Middle of the tool: ahead, to the left. */
at: [string, string],
/** Speed of driving. */
speed: string,
/** Speed of turning. */
turn: string,
/** How it moves, if not as its model. */
wheels: WheelLayout | null,
/** Sensors of its model that it lacks. */
without: Array<OwnSensor>, };

/** A kind of sensor that a robot can have or lack. */
export type OwnSensor = "bumper" | "cliffs" | "light" | "infrared" | "wheel_drops" | "laser";

/** Kinds of bodies in the form. */
export type OwnShape = "model" | "circle" | "rectangle" | "octagon" | "polygon";

/** Snapshot of a session and of the pointer's tool. */
export type PageView = {
/** The pointer's tool. */
tool: FloorTool,
/** Names of the objects in the room. */
objects: Array<string>,
/** Index of the selected one; -1 for none. */
selected: number,
/** Kind of object that the tool *place* places. */
placing: string,
/** Whether the robot is held on the picture. */
is_carried: boolean,
/** Whether the whole room is shown: it then gives way to what is said above it. */
is_all_shown: boolean,
/** Where on the picture the robot is, as shares of its width from the left and of its height from the top: nothing must
 * hide it. 1 and 1 without one. */
robot_spot: [number, number],
/** State of the session. */
state: SessionState,
/** Actions that are allowed now. */
can: SessionActions,
/** Message for the user; empty for none. */
message: string,
/** `error` or `notice`; empty for none. */
message_kind: "" | "error" | "notice",
/** The room. */
room: RoomView,
/** Id of the robot. */
robot: string,
/** Figures of a twin, as in links; empty for the model and for an own robot. */
twin: string,
/** Choices of an own robot, as in links; empty for a model; `model` for one that is built on a model without changes. */
own_robot: string,
/** Corners of a path from elsewhere that is driven in place of the planner's; 0 for none. */
path_corners: number,
/** Id of the planner or behaviour. */
algorithm: string,
/** `planner` or `behaviour`. */
kind: "planner" | "behaviour",
/** The user's program, if it is chosen. */
program: ProgramView | null,
/** The robot's activity, in a few words; empty for none. */
activity: string,
/** Changes whenever the list of events does. */
diary: number,
/** Whether the robot is held. */
is_lifted: boolean,
/** Why a person's commands are blocked: forward, left, right, backward; `None` unless a person drives. */
blocked: [string | null, string | null, string | null, string | null] | null,
/** Share of the dirt that is left; `None` in rooms without dirt. */
dirt_left: number | null,
/** Its parameters. */
params: Params,
/** Side of the planning cells, m. */
cell_size_m: number,
/** How far the planning cells begin to the left of the room's lower-left corner and below it, m. */
cell_offset_m: [number, number],
/** Seed of everything random. */
seed: number,
/** Level of wheel slip. */
slip: string,
/** Levels of noise, in the order of the catalogue's sensors. */
noise: [string, string, string, string, string, string, string],
/** Whether wheels turn only at the speeds that the motor controller can keep. */
quantised: boolean,
/** Charge of the battery at the start, percent. */
start_charge_percent: number,
/** Layers drawn on the floor. */
shows: Shows,
/** How the follower computes its pose. */
odometry: string,
/** Whether the corners of plans are rounded, and whether this robot can do that. */
smooth: boolean,
/** See above. */
can_smooth: boolean,
/** Set speed, times real time; 0 for as fast as possible. */
speed: number,
/** Achieved speed, times real time. */
speed_factor: number,
/** Displayed time, s. */
time_s: number,
/** Share of the reachable floor that was swept before the room was changed, which began the run again; 0 if it
 * wasn't. */
swept_before: number,
/** Furthest simulated time, s. */
run_end_s: number,
/** Swept share of the reachable floor. */
coverage: number,
/** Area swept again, as a share of the area swept. */
overlap: number,
/** Distance driven, m. */
distance_m: number,
/** The least distance in which any robot with this tool sweeps as much floor, m; `None` until the run is over, of those that plan
 * it, and where it isn't known. */
least_m: number | null,
/** Time for that distance at the robot's top speed, s: no run that sweeps as much takes less. */
least_s: number | null,
/** Sum of all turning, degrees. */
turning_deg: number,
/** Number of bumps. */
bumps: number,
/** Distance between the robot's true and estimated position, m. */
pose_error_m: number,
/** The planner's search. */
search: SearchView,
/** The plan, or the best so far while the planner is running. */
plan: PlanView | null, };

/** One parameter. */
export type Param = { id: string, label: string, help: string, default: ParamValue, } & ({ "kind": "number", min: number, max: number, step: number, unit: string, } | { "kind": "choice", options: Array<[string, string]>, } | { "kind": "flag" });

/** Value of a parameter. */
export type ParamValue = boolean | number | string;

/** Values for all parameters of one planner or controller; complete and within range. */
export type Params = { [key in string]: ParamValue };

/** A personality, for menus. */
export type PersonalityView = { id: string, title: string, summary: string, };

/** The plan in numbers; those of walk and drive are 0 while planning, those of the walk also for a path in metres. */
export type PlanView = {
/** Whether the planner is running. */
running: boolean,
/** Its progress, 0 to 1. */
progress: number,
/** Planning time, s; `None` while planning, and for a precomputed plan. */
planning_s: number | null,
/** Optimality gap of the plan, or of the best walk so far, in the planner's own objective, as a share of the bound;
 * 0 if it is proven optimal, `None` for planners that prove nothing. */
gap: number | null,
/** The same in steps + 2 x quarter turns, as in comparisons; `None` until it is proven, or if the walk misses
 * cells. */
above_bound: number | null,
/** Its exact coverage, and what any path needs that sweeps as much; `None` until it is computed. */
least: SweepBound | null,
/** Steps that a quarter turn counts as in `gap`. */
turn_weight: number | null,
/** Whether that is the robot's time for one. */
times_turns: boolean,
/** Share of the search after which the user ended it; `None` if the planner finished. */
kept_at: number | null,
/** The share of the floor that it was to sweep, 0 to 1, if the planner has a parameter for it. */
asked_coverage: number | null,
/** Cells that can be reached from the start, the start included. */
reachable_cells: number,
/** Cells of those that the walk visits. */
visited_cells: number,
/** Steps from cell to cell. */
steps: number,
/** Quarter turns between consecutive steps; a reversal counts two. */
turns: number,
/** Steps that lead in another direction than the one before: a reversal counts once, as in the thesis' Table 2. */
direction_changes: number,
/** Quarter turns from the robot's heading at the start to its first step; not part of `turns`. */
initial_turns: number,
/** Visits to cells beyond the first to each. */
revisits: number,
/** Cells that are visited more than once. */
revisited_cells: number,
/** Length, m. */
length_m: number,
/** Sum of all turns, degrees, the one at the start included. */
turning_deg: number,
/** Time from rest to rest by the robot's motion model (straight pieces and turns on the spot, or curves as well), s. */
duration_s: number,
/** Energy taken from the battery, Wh: the robot's power while driving straight and while turning, times the time of
 * each. Some of the robots' figures are estimates, so it is accurate to about a quarter. */
energy_wh: number,
/** Swept share of the reachable floor, 0 to 1; accurate to about a fine cell's width along every edge. */
coverage: number,
/** Area swept again by later passes, as a share of the area swept; 0 or more. */
overlap: number,
/** Area swept again by later passes, m²; what is swept three times counts twice. */
overlap_m2: number, };

/** How far a twin's and its model's predictions are off. */
export type Prediction = {
/** What is predicted. */
what: string,
/** Unit of the errors. */
unit: string,
/** Digits after the point. */
digits: number,
/** Error of the twin. */
twin: number,
/** Error of the model. */
model: number,
/** From what: a sentence. */
how: string, };

/** Buttons of the robot on the page. */
export type PressedButton = "clean" | "spot" | "max" | "dock" | "power";

/** A program that a user wrote. */
export type Program = {
/** Name in lists and of its file, without an ending. */
name: string,
/** Its language. */
language: ProgramLanguage,
/** What it does. */
kind: ProgramKind,
/** Its text. */
source: string, };

/** Kinds of programs. */
export type ProgramKind = "behaviour" | "planner";

/** Languages of programs. */
export type ProgramLanguage = "python" | "javascript";

/** A user's program that is chosen. */
export type ProgramView = {
/** Its name. */
name: string,
/** Its language. */
language: ProgramLanguage,
/** What it does. */
kind: ProgramKind,
/** Changes when it has to be run again: from the start, or from a person's last input on. */
version: number,
/** Steps for which it has commanded; `None` for a planner. */
reach_steps: number | null,
/** How it ended, if it has. */
end: "done" | "failed" | null,
/** Whether the run stands still because the program hasn't got farther. */
waits: boolean,
/** Steps before a person's last input; `None` without one. */
input: number | null, };

/** A question. */
export type Question = {
/** The question. */
text: string,
/** A room: `#` wall, `.` floor, `S` start; rows from top to bottom. Empty if there is none. */
room: Array<string>,
/** The options to choose from; empty for a number or bytes. */
options: Array<string>,
/** What a written answer looks like. */
example: string, };

/** A quiz of a lesson: questions of one kind. */
export type Quiz = {
/** Its name in answers. */
id: string,
/** The kind of its questions. */
about: QuizKind,
/** How many must be answered well. */
rounds: number, };

/** The answers to the questions of a quiz. */
export type QuizAnswer = {
/** Seed and text of each answer. */
answers: Array<[number, string]>, };

/** A kind of question. */
export type QuizKind = "reachable" | "lanes" | "parity" | "median" | "odometry" | "logodds" | "bytes";

export type RaceView = { state: SessionState, time_s: number, end_s: number, planned_s: number, speed: number,
/** Whether it stands still because the user's program hasn't got farther. */
waits: boolean,
/** Why the user's program failed; empty if it didn't. */
failure: string, lanes: Array<LaneView>, };

/** User requests to a robot. In JavaScript, `{ do: "arm", full: false }` and the like. */
export type Request = { "do": "connect" } | { "do": "disconnect" } | { "do": "arm",
/** Full, without the robot's own safety features. */
full: boolean, } | { "do": "disarm" } | { "do": "stop" } | { "do": "drive",
/** Forward, -1 to 1. */
forward: number,
/** To the left, -1 to 1. */
left: number, } | { "do": "press",
/** The button. */
button: PressedButton, } | { "do": "raw",
/** At most 256 bytes. */
bytes: Array<number>, } | { "do": "song",
/** 0 to 3. */
number: number,
/** 1 to 16 of note and duration in 1/64 s. */
notes: Array<[number, number]>, } | { "do": "leds",
/** Bits: debris, spot, dock, check. */
lamps: number,
/** Colour of the Clean button: 0 green to 255 red. */
colour: number,
/** Its brightness, 0 to 255. */
intensity: number, } | { "do": "digits",
/** Up to four printable characters. */
text: string, } | { "do": "schedule_leds",
/** Bits, the lowest for Sunday. */
weekdays: number,
/** Bits: colon, PM, AM, clock, schedule. */
lamps: number, } | { "do": "motors",
/** Bits: side brush, vacuum, main brush, side brush clockwise, main brush outward. */
bits: number, } | { "do": "pwm_motors",
/** -127 to 127; inward positive. */
main_brush: number,
/** -127 to 127; counter-clockwise positive. */
side_brush: number,
/** 0 to 127. */
vacuum: number, } | { "do": "drive_pwm",
/** -255 to 255. */
right: number,
/** -255 to 255. */
left: number, } | { "do": "clock",
/** 0 Sunday to 6 Saturday. */
day: number,
/** 0 to 23. */
hour: number,
/** 0 to 59. */
minute: number, } | { "do": "schedule",
/** Bits, the lowest for Sunday; none for no schedule. */
days: number,
/** Hour and minute, from Sunday to Saturday. */
times: [[number, number], [number, number], [number, number], [number, number], [number, number], [number, number], [number, number]], } | { "do": "calibrate",
/** The calibration. */
what: Calibration, } | { "do": "answer",
/** Degrees or metres, as requested. */
value: number, } | { "do": "skip" } | { "do": "use_calibration",
/** Packets 43 and 44 are swapped. */
swapped: boolean,
/** True distance divided by the encoders' distance. */
distance_factor: number,
/** True wheel base divided by 235 mm. */
base_factor: number, } | { "do": "odometry",
/** Its name, as in links. */
model: OdometryModel, } | { "do": "identify" };

/** A robot, for its portrait and its dashboard. */
export type RobotEntry = { id: string, title: string, summary: string, default_cell_m: number, tool_width_m: number,
/** Speed along paths, and turn rate on the spot. */
speed_m_s: number, turn_deg_s: number,
/** Radius of the smallest circle around the body; all other lengths are in units of it, x ahead and y to the left. */
radius_m: number,
/** Corners of a body that isn't round. */
body: Array<[number, number]>, wheel_base: number, wheel_radius: number,
/** Half the angle that the bumper spans, rad; 0 for none. */
bumper: number,
/** Left, front left, front right, right; `null` where there is none. */
cliffs: [[number, number] | null, [number, number] | null, [number, number] | null, [number, number] | null],
/** Directions of the light bumper's beams, rad; empty for none. */
light: Array<number>, infrared: boolean, wheel_drops: boolean, gauge: boolean, lateral: boolean,
/** First direction and step (rad), range and place (m) of the laser scanner; empty for none. */
laser: Array<number>, };

/** Meaning of a layer for the robot. */
export type Role = "wall" | "obstacle" | "ignored";

export type RoomEntry = { id: string, title: string, note: string, };

/** The room in numbers. */
export type RoomView = {
/** Id if it is built in and unchanged, else empty. */
id: string,
/** Name. */
title: string,
/** Its purpose; without the name of a generated flat. */
note: string,
/** What it was generated from, also after changes. */
flat: FlatView | null,
/** Width of the floor within its walls, m. */
width_m: number,
/** Its height, m. */
height_m: number,
/** Side of a map cell, m. */
resolution_m: number,
/** Number of map cells. */
cells: number,
/** Floor that the robot's tool can reach from the start, m². */
reachable_m2: number,
/** Free floor that the tool can't reach, m². */
left_out_m2: number, };

/** Readings of a Roomba's Open Interface. */
export type RoombaView = {
/** The readings that all robots have in common. */
sensors: SensorsView,
/** Strength of the wall sensor's signal, 0 to 1023. */
wall_signal: number,
/** Voltage of the battery, V. */
voltage_v: number,
/** Its charge, mAh. */
charge_mah: number,
/** Its capacity, mAh. */
capacity_mah: number,
/** Its temperature, degrees Celsius. */
temperature_c: number,
/** Charging state and source of power, in words. */
charging: string,
/** Motor currents, mA: left wheel, right wheel, main brush, side brush. */
motors_ma: [number, number, number, number],
/** Requested speeds, mm/s: left wheel, right wheel. */
requested_mm_s: [number, number],
/** Names of the buttons that are pressed. */
buttons: Array<string>,
/** Number of the last selected song, from 1. */
song: number,
/** Whether it plays. */
song_plays: boolean, };

/** How values are rounded to the shown digits. */
export type RoundingMode = "down" | "nearest" | "up";

export type RowView = {
/** Number of the planner in the view's `entrants`. */
entrant: number, trials: number, missing: number, failure: string, values: Array<MedianAndRange | null>,
/** The exact coverage of its paths and the bounds for it, above which the excess is: medians of seeds, sums over rooms. */
least: SweepBound | null,
/** Which values are the best of their columns. */
best: Array<boolean>,
/** Whether it leaves floor out that others clean: it then has the best of nothing that costs. */
leaves_floor: boolean,
/** What a paper prints in the place of each value. */
printed: Array<number | null>, };

/** A run in an answer. */
export type RunRecord = {
/** Its seed. */
seed: number,
/** Swept share of the reachable floor, %. */
coverage_percent: number,
/** Simulated time, s. */
time_s: number,
/** Distance driven, m. */
distance_m: number,
/** Digest of its final state, hexadecimal. */
digest: string, };

/** The choices of a scenario besides its room, as text that settings check. Missing ones stay unchanged. */
export type ScenarioChoices = {
/** Id of the robot. */
robot: string | null,
/** Figures of a twin, as in links; without them the robot is the model. */
twin: string | null,
/** Choices of an own robot, as in links. */
own_robot: string | null,
/** Side of the planning cells, m. */
cell_size: number | null,
/** How far they begin to the left of the room's lower-left corner and below it, m. */
cell_offset: [number, number] | null,
/** Id of the planner. */
planner: string | null,
/** Id of the behaviour. */
behaviour: string | null,
/** The user's program, if that is the planner or behaviour. */
program: Program | null,
/** Parameters of the planner or behaviour, by name. */
params: Array<[string, string]>,
/** A path that is driven in place of the planner's, as in links. */
path: string | null,
/** Seed of all random numbers. */
seed: string | null,
/** Level of wheel slip. */
slip: string | null,
/** Level of noise for each kind of sensor; missing ones are *off*. */
noise: Array<[string, string]> | null,
/** Whether wheel speeds are quantised. */
quantised: boolean | null,
/** Charge of the battery at the start, percent. */
start_charge_percent: number | null,
/** How the robot computes its pose. */
odometry: string | null,
/** Whether the corners of plans are rounded. */
smooth: boolean | null, };

/** The planner's search in words. */
export type SearchView = {
/** Whether the planner can show it. */
offered: boolean,
/** Whether it is shown. */
on: boolean,
/** The current decision, or the film's caption; empty for none. */
text: string,
/** Why it can't be shown; empty if it can. */
refusal: string,
/** Whether it could in a smaller room. */
fits_small: boolean,
/** The film, if there is one and it is shown. */
film: FilmView | null, };

/** Sensor readings that all robots have in common. Sensors that a robot doesn't have stay at their defaults. */
export type SensorsView = {
/** Bumper pressed: left and right half. */
bumper: [boolean, boolean],
/** Wheel dropped: left and right. */
wheel_drops: [boolean, boolean],
/** Both wheels dropped: the robot is lifted. */
is_lifted: boolean,
/** No floor: left, front left, front right, right. */
cliffs: [boolean, boolean, boolean, boolean],
/** Signals of the cliff sensors, 0 to 4095. */
cliff_signals: [number, number, number, number],
/** The wall sensor on the right detects something. */
wall: boolean,
/** The beam of a virtual wall is detected. */
virtual_wall: boolean,
/** The castor turns. */
is_moving: boolean,
/** Motors that draw too much current. */
overloads: Array<string>,
/** Detections of the light bumper, from left to right. */
light: [boolean, boolean, boolean, boolean, boolean, boolean],
/** Strengths of its signals, 0 to 4095. */
light_signals: [number, number, number, number, number, number],
/** Receivers on the left, on top and on the right. */
infrared: [BeamsView, BeamsView, BeamsView],
/** Battery and charger. */
battery: BatteryView,
/** Encoders: left, right, sideways. */
counts: [number, number, number],
/** Amount of dirt being picked up, 0 to 255. */
dirt: number, };

/** Allowed actions: one flag per button, which JavaScript only copies. */
export type SessionActions = {
/** Start or continue. */
play: boolean,
/** Pause. */
pause: boolean,
/** Advance by one move. */
step: boolean,
/** Return to the start. */
reset: boolean,
/** Cancel planning. */
cancel: boolean,
/** Stop planning, and drive the best walk so far. */
keep: boolean,
/** Seek another time. */
seek: boolean,
/** Change choices or the room. */
edit: boolean,
/** Pick the robot up. */
lift: boolean,
/** Undo the last change of the room. */
undo: boolean,
/** Redo it. */
redo: boolean, };

/** Everything that determines a session's plan and runs. Equal snapshots mean equal sessions. */
export type SessionSnapshot = {
/** Id of the room if it is built in and unchanged. */
room: string | null,
/** Changes with every change of the room. */
room_version: number,
/** An own room, for receivers that don't have this version of it. */
own: object | null,
/** Start chosen by the user: x, y in m, heading in rad. */
start: [number, number, number] | null,
/** Robot, algorithm, seed and conditions; missing ones have their defaults. */
choices: ScenarioChoices, };

/** State of the session. */
export type SessionState = "failed" | "planning" | "ready" | "playing" | "paused" | "seeking" | "finished";

/** How shades are told apart. */
export type ShadeMethod = "map" | "level" | "local";

/** Layers of the picture that can be shown or hidden. */
export type Shows = {
/** Passes over the floor. */
coverage: boolean,
/** Remaining dirt. */
dirt: boolean,
/** Sensor beams and detections. */
sensors: boolean,
/** The robot's estimated trail. */
estimate: boolean, };

/** How the numbers of several runs become one. */
export type Statistic = "median" | "every" | "best";

/** Statistics of the line. */
export type Statistics = {
/** Baud rate. */
baud: number,
/** Accepted frames. */
frames: number,
/** Frames with a wrong checksum. */
bad_checksums: number,
/** Headers without a frame. */
false_headers: number,
/** Frames with a right checksum but impossible values. */
implausible: number,
/** Frames accepted one frame late, after a jump of a value. */
late: number,
/** Lines of text. */
texts: number,
/** Other bytes. */
noise: number,
/** Bytes received and sent. */
bytes: [number, number],
/** Current frames per second. */
rate_hz: number,
/** Time since the last frame, ms. */
age_ms: number,
/** Median of the last delays from a command to the robot's report of it, ms. */
latency_ms: number | null,
/** The longest time without a frame, ms. */
longest_gap_ms: number,
/** Bytes of the subscription, and of the slot of 15 ms into which they must fit. */
slot: [number, number], };

/** Summary of many runs of one algorithm. */
export type Summary = {
/** Number of runs. */
runs: number,
/** Swept share of the reachable floor at the end, 0 to 1. */
coverage: Band,
/** Times to the shares of [`GOALS`]. */
time_to: [TimeTo, TimeTo],
/** Distance driven, m. */
distance_m: Band,
/** Number of bumps. */
bumps: Band,
/** Falls of all runs together. */
falls: number,
/** Remaining share of the dirt, 0 to 1; `None` if there was none. */
dirt_left: Band | null,
/** How far distance and time exceed the least of any run that sweeps as much, as shares; `None` if there is none for a run. */
excess: [Band, Band] | null, };

/** What any path needs that sweeps so much of a floor. */
export type SweepBound = {
/** Share of the floor, 0 to 1. */
coverage: number,
/** Length, m. */
length_m: number,
/** Time by the robot's motion model, s. */
duration_s: number, };

/** Results of a sweep. */
export type SweepView = {
/** Subgoals in all, then by contact: left and right wall, left and right obstacle. */
subgoals: [number, number, number, number, number],
/** Links. */
links: number,
/** Links whose straight way collides. */
collisions: number,
/** Of these, those with a detour. */
resolved: number,
/** How often the ways of links cross each other. */
crossings: number,
/** Crossings and length, m, in the order *nearest*, for another one. */
nearest: [number, number] | null,
/** Length of the path, m. */
length: number,
/** Strokes of the last stage, and their length with the ways there, m. */
finish: [number, number],
/** Share of the reachable floor that is swept by the links, 0 to 1. */
linked_share: number,
/** Share of the reachable floor that is swept, 0 to 1. */
coverage: number,
/** The same by the finer cells of Explore, and the time, s: what a run without slip gives there. */
driven: [number, number],
/** What is kept free, if it isn't the outline. */
kept_free: string | null,
/** Distance between scan lines, m. */
scan_width: number, };

/** A table of numbers. */
export type TableView = { metrics: Array<MetricInfo>,
/** Of a single room. */
bounds: Bounds | null, least: SweepBound | null, rows: Array<RowView>, };

/** Time at which runs reached a share of the floor.
 *
 * The time of a run that didn't reach it is only known to be longer than the run. Times that depend on such a run are
 * `None`: the median, unless more than half of the runs reached it. */
export type TimeTo = {
/** The share, %. */
percent: number,
/** Number of runs that reached it. */
reached: number,
/** Time by which one run in ten reached it, s. */
low_s: number | null,
/** Time by which half of the runs reached it, s. */
median_s: number | null,
/** Time by which nine runs in ten reached it, s. */
high_s: number | null, };

/** What happened in a recording, in order. */
export type Timeline = {
/** Duration of the recording, s. */
duration_s: number,
/** Readings of the sensors. */
readings: number,
/** Frames that were lost on the line, as far as their remains arrived. */
lost_frames: number,
/** Path driven by odometry, m. */
distance_m: number,
/** Times that the bumper was pressed. */
bumps: number,
/** Charge of the battery at the first and at the last reading, percent; `None` if it wasn't reported. */
charge_percent: [number, number] | null,
/** What happened. */
entries: Array<TimelineEntry>,
/** Entries that were left out, as there were too many. */
left_out: number, };

/** Something that happened in a recording. */
export type TimelineEntry = {
/** When it began, s since the start of the recording. */
time_s: number,
/** How long it lasted, s; 0 for a moment. */
duration_s: number,
/** What it is about. */
kind: EntryKind,
/** Whether something was wrong. */
is_fault: boolean,
/** A sentence. */
text: string, };

/** The resulting room. */
export type TracedRoomView = {
/** Width of its floor, without walls, m. */
width_m: number,
/** Height of its floor, m. */
height_m: number,
/** Columns and rows. */
cells: [number, number],
/** Floor without objects, m². */
floor_m2: number,
/** Side of a cell, m. */
resolution: number,
/** Number of objects. */
objects: number,
/** Gaps that were closed. */
gaps: number,
/** Those of them that are wider than was asked for: openings to the outside, indoors. */
outer_doors: number,
/** Floor round the building that is left out, m². */
around_m2: number,
/** Floor that a robot can't get to, m²; 0 if it is hardly any. */
cut_off_m2: number,
/** Floor that the brush of a Roomba reaches, m², as Explore counts it, if it can't get to some. */
reachable_m2: number | null, };

/** A line of traffic. */
export type Traffic = {
/** Time, s. */
time_s: number,
/** Its kind. */
kind: TrafficKind,
/** As bytes. */
hex: string,
/** In words. */
text: string,
/** Number of consecutive events that it represents: frames come 64 times a second. */
times: number, };

/** Kinds of traffic. */
export type TrafficKind = "sent" | "frame" | "refused" | "held" | "text" | "bytes" | "line";

/** Errors of an adapter. */
export type TransportErrors = {
/** Breaks. */
break: number,
/** Framing errors. */
framing: number,
/** Parity errors. */
parity: number,
/** Overruns. */
overrun: number, };

/** Kinds of lines. */
export type TransportKind = "" | "virtual" | "serial" | "socket";

/** States of a line. */
export type TransportState = "closed" | "opening" | "open" | "lost";

/** The line below a robot's bytes. */
export type TransportView = {
/** Kind of the line. */
kind: TransportKind,
/** State of the line. */
state: TransportState,
/** Name of the adapter, bridge or personality. */
name: string,
/** A sentence on the state; empty for none. */
text: string,
/** Baud rate. */
baud: number,
/** Whether the baud rate can be changed. */
can_baud: boolean,
/** Whether it is the USB port of a robot itself, without an adapter. */
is_own_usb: boolean,
/** The BRC wire at the adapter's RTS. */
brc: BrcWire,
/** Errors that the adapter reported and recovered from. */
errors: TransportErrors,
/** How often the line has returned by itself. */
returns: number,
/** Another client of the bridge drives: what is sent from here doesn't reach the robot. */
is_watching: boolean, };

/** A figure of a twin, for people. */
export type TwinFigure = {
/** What it is. */
name: string,
/** Its value; `None` if there is neither a measurement nor a default. */
value: number | null,
/** Its standard deviation; `None` for a value that wasn't fitted. */
uncertainty: number | null,
/** The model's value; `None` if the model has none. */
model: number | null,
/** Unit, empty for none. */
unit: string,
/** Digits after the point. */
digits: number,
/** A sentence: what it was found from, or why it is the model's. */
how: string, };

/** Typed bytes, and what they would do. */
export type TypedBytes = {
/** Those to be sent; none if they are refused. */
bytes: Array<number>,
/** Commands that may move the robot, by name and opcode. */
moving: Array<string>,
/** Whether they can't be sent. */
is_refused: boolean,
/** What to know about them, for users. */
told: string, };

/** A unit in the menu. */
export type UnitView = {
/** Its name. */
name: string,
/** Metres per unit. */
metre: number,
/** The size that the drawing would have. */
size: string, };

/** Whether a goal is reached, and by what numbers. */
export type Verdict = {
/** Whether all conditions hold. */
passed: boolean,
/** Each condition. */
needs: Array<Judged>,
/** Each run. */
runs: Array<RunRecord>, };

/** Visible and audible state of the virtual robot. Bit sets are encoded as on the line. */
export type VirtualView = {
/** Its true pose: x, y in m, heading in rad. */
pose: [number, number, number], mode: string, awake: boolean, lifted: boolean, fallen: boolean, lamps: number,
/** Colour, 0 green to 255 red, and brightness. */
clean_light: [number, number], digits: string, weekdays: number, schedule: number, motors: number,
/** Share of the room's dirt that is left; `None` in a room without any. */
dirt_left: number | null,
/** Tunes started since the last view: notes of MIDI number and 1/64 s. */
tunes: Array<Array<[number, number]>>, };

/** How a robot moves. */
export type WheelLayout = "differential" | "omnidirectional";
