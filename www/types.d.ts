// Generated from the Rust types by `cargo test --test page types`: change them there.

/** The middle of many values and where four in five of them lie; see [`quantile`] for the definition. */
export type Band = {
/** A tenth of the values is lower. */
low: number,
/** Half of the values are lower. */
median: number,
/** A tenth of the values is higher. */
high: number, };

/** What the battery gauge reports. */
export type BatteryView = {
/** Share of the capacity that is left, 0 to 1. */
share: number,
/** Current, mA, negative while it discharges. */
current_ma: number,
/** Whether the robot charges on its dock. */
on_dock: boolean,
/** Whether the gauge was read. */
is_known: boolean,
/** Whether it should be charged. */
is_low: boolean, };

/** What an infrared receiver detects. */
export type BeamsView = {
/** Beams: `green`, `field` and `red` of a dock, `wall` of a virtual wall. */
lit: Array<string>,
/** In words. */
text: string, };

/** One case's result. */
export type BenchResult = {
/** What was measured. */
name: string,
/** Median time of one run, ms. */
ms: number,
/** Times real time, where it stands for a time of the robot's. */
times_real_time: number | null,
/** All memory that the program has had by then, MB (10^6 bytes); where somebody knows. */
memory_mb: number | null, };

/** Which values of a number are wanted. */
export type Better = "lower" | "higher";

/** An outline by its figures, m. */
export type BodyChoice = { "kind": "model",
/** Its id. */
id: string, } | { "kind": "circle",
/** Its radius. */
radius: number, } | { "kind": "rectangle",
/** Along the way that it looks. */
length: number,
/** Across. */
width: number, } | { "kind": "octagon",
/** From side to side. */
width: number, } | { "kind": "polygon",
/** Its corners, `x y; x y; ...`: x ahead, y to the left. */
corners: string, };

/** Proven lower bounds for every walk that starts in a job's start, ends anywhere and visits all its cells.
 *
 * A walk that reaches a bound is best possible in that number; often none does. */
export type Bounds = {
/** Fewest steps. */
steps: number,
/** Fewest quarter turns; a reversal counts two, the turn before the first step isn't counted. */
turns: number,
/** Least steps + [`TURN_STEPS`] x quarter turns; may be more than what the two bounds above add up to. */
cost: number, };

/** The wire that wakes a robot. */
export type BrcWire = "low" | "high" | "none";

/** What can be calibrated. */
export type Calibration = "nudge" | "spin" | "metre" | "square";

/** A calibration. */
export type CalibrationView = {
/** `nudge`, `spin`, `metre` or `square`; empty for none. */
what: "" | "nudge" | "spin" | "metre" | "square",
/** `none`, `moving`, `asking`, `done` or `failed`. */
step: "none" | "moving" | "asking" | "done" | "failed",
/** What is going on, what is asked, or what was found. */
text: string,
/** Unit of the answer: `yes` for yes or no, `deg`, `m`; empty if nothing is asked. */
asks: "" | "yes" | "deg" | "m",
/** The likeliest answer. */
suggestion: number,
/** What is in use now: swapped encoders, distance factor, wheel base factor. */
swapped: boolean,
/** True distance over what encoders say. */
distance_factor: number,
/** True wheel base over 235 mm. */
base_factor: number, };

/** A few words, and a few more; these may be empty. */
export type Caption = {
/** A title. */
title: string,
/** A sentence. */
note: string, };

/** Rooms, planners, behaviours, robots, kinds of sensors whose noise can be chosen, cell sizes and speeds. */
export type Catalogue = { rooms: Array<RoomEntry>, planners: Array<CatalogueEntry>, behaviours: Array<CatalogueEntry>, robots: Array<RobotEntry>,
/** Ids and labels. */
sensors: [[string, string], [string, string], [string, string], [string, string], [string, string], [string, string], [string, string]], cell_sizes_m: [number, number, number, number, number, number, number, number], speeds: [number, number, number, number, number, number, number], };

/** A planner or behaviour. What only the other kind claims is false. */
export type CatalogueEntry = { id: string, title: string, summary: string, source: string, link: string,
/** `planner` or `behaviour`. */
kind: "planner" | "behaviour", mark: Mark, complete: boolean, deterministic: boolean, fast: boolean, anytime: boolean, ends: boolean, cleans: boolean, manual: boolean, idea: string, complexity: string, use_when: string, shines: ExampleEntry, fails: ExampleEntry, params: Array<Param>, };

/** Snapshot for every frame. */
export type ComparisonView = { version: number, set: string, sets: Array<[string, string]>, seeds: number, rooms: Array<string>,
/** Number of the session's room in `rooms`. */
done: number, total: number, cancelled: boolean, entrants: Array<EntrantView>, race: RaceView | null, };

/** Which requests are allowed. */
export type ConnectionActions = {
/** Connect again. */
connect: boolean,
/** Disconnect. */
disconnect: boolean,
/** Take control. */
arm: boolean,
/** Give it back. */
disarm: boolean,
/** Drive, ride, calibrate, play, switch motors and lights. */
drive: boolean,
/** Drive by hand: no program drives. */
steer: boolean,
/** Start a program. */
ride: boolean,
/** Press buttons, send raw bytes. */
press: boolean, };

/** Snapshot of a connection, for 20 looks a second. */
export type ConnectionView = {
/** `closed`, `diagnosing`, `waiting` (nobody answers, and it goes on trying), `connected` or `lost` (the line is open, but
 * nothing comes any more). */
phase: "closed" | "diagnosing" | "waiting" | "connected" | "lost",
/** What was found out about who is there. */
diagnosis: DiagnosisView,
/** `Passive`, `Safe` or `Full`; empty while unknown. */
mode: "" | "Off" | "Passive" | "Safe" | "Full",
/** Whether the robot's mode byte is one too high. */
mode_offset: boolean,
/** What drives. */
ride: DriveSessionView | null,
/** What the robot's sensors report; none before the first reading, and when nobody is connected. */
readings: RoombaView | null,
/** The robot's estimated pose: x, y in m, heading in rad. */
pose: [number, number, number],
/** Id of the odometry model that this is by. */
odometry: string,
/** Path driven, m. */
distance_m: number,
/** Requested wheel speeds that were sent last, left and right, m/s. */
wheels: [number, number],
/** Whether the robot drives at this program's word, or is about to. */
is_moving: boolean,
/** Whether it moves otherwise: by its own program, by bytes that were sent, or pushed by somebody. */
moves_alone: boolean,
/** What it is doing. */
doing: Caption,
/** The line below its bytes. */
transport: TransportView,
/** Its name and state. */
line: Caption,
/** Whether a line is open, or waited for. */
is_open: boolean,
/** Whether a recording is shown, which has no line. */
is_recording: boolean,
/** How the line is. */
statistics: Statistics,
/** Until the robot falls asleep, s; none unless it is Passive and off the dock. */
sleeps_in_s: number | null,
/** How long it has been in Safe or Full, where it doesn't charge, s. */
awake_s: number | null,
/** A sentence on these, when they matter; empty otherwise. */
clock: string,
/** Why it isn't in Safe or Full any more. */
drop: DropView | null,
/** The calibration that is going on, or its result. */
calibration: CalibrationView,
/** What the robot said of its firmware. */
firmware: string | null,
/** The latest message. */
notice: Notice | null,
/** Which requests are allowed now. */
can: ConnectionActions, };

/** What was found out about who is there. */
export type DiagnosisView = {
/** What is being tried: `listening`, `asking`, `waking`, `slow` (19200 baud), `create1` (57600 baud), `done`. */
step: string,
/** What was found: `nothing` (yet), `silence`, `stream`, `charging`, `booting`, `bootloader`, `garbage`, `text`, `robot`. */
finding: "" | "nothing" | "silence" | "stream" | "charging" | "booting" | "bootloader" | "garbage" | "text" | "no_stream" | "robot",
/** One sentence on it. */
text: string,
/** What to do about it; empty if nothing. */
remedy: string,
/** What was tried so far, and what came of it, in order. */
log: Array<string>,
/** Whether it is shown: nobody is connected. */
is_shown: boolean,
/** Picture of it: `listening`, `asleep`, `awake`, `dock`, `boot`, `speed` or `unplugged`. */
picture: string,
/** What is being tried or was found, and what to do about it. */
caption: Caption, };

/** What closing doors would do. */
export type Doors = {
/** Openings that would be closed, and were not before. */
count: number,
/** Widest gap that would have to be closed, m. */
gap: number,
/** Free floor that the room would have, m². */
floor_m2: number, };

/** The part of a drawing that is meant, in its unit. */
export type DrawingPart = { "kind": "whole" } | { "kind": "rectangle",
/** Two opposite corners. */
corners: [[number, number], [number, number]], } | { "kind": "polygon",
/** Its corners. */
corners: Array<[number, number]>, } | { "kind": "room",
/** The point. */
at: [number, number], };

/** What clicks mean. */
export type DrawingTool = "view" | "scale" | "rectangle" | "polygon" | "room";

/** What drives the robot. */
export type DriveSessionView = {
/** Name of the algorithm. */
title: string,
/** What it is doing. */
activity: string,
/** Time since it began, s. */
time_s: number,
/** Whether it is a person with a joystick. */
manual: boolean,
/** Why forward, left, right and backward are not obeyed, if somebody drives by hand. */
blocked: [string | null, string | null, string | null, string | null],
/** Corner of the planned line that it drives to. */
corner: number | null,
/** Whether it has come to its end. */
done: boolean,
/** Why it was ended before it was done; empty if it wasn't. */
ended: string, };

/** Why the robot left Safe or Full. */
export type DropView = {
/** Mode that it was in. */
from: string,
/** One sentence. */
text: string,
/** What to do, or why it can't be taken back. */
remedy: string,
/** Whether control can be taken back at once. */
can_rearm: boolean, };

export type EntrantView = { id: string, chosen: boolean, params: Params,
/** `out`, `trying`, `done` or `failed`. */
state: "out" | "trying" | "done" | "failed",
/** 0 to 1. */
progress: number, message: string, };

export type ExampleEntry = { room: string, why: string, };

/** How far a film is. */
export type FilmView = {
/** Number of the picture that is seen, from 0; that of all pictures once it's over. */
at: number,
/** How many pictures there are. */
pictures: number,
/** Whether it goes on by itself. */
runs: boolean, };

/** What was chosen. */
export type FloorPlanSettings = {
/** Metres per unit of the drawing; `None` until somebody says so. */
metre: number | null,
/** What every layer is. */
roles: Array<Role>,
/** Widest gap between walls that is closed, m. */
gap: number,
/** Side of the room's cells, m. */
resolution: number,
/** The part that is meant. */
part: DrawingPart,
/** Shades of an image that are wall: those darker than this, 0 (black) to 1 (white). */
shade: number,
/** Whether light shades are walls instead. */
negate: boolean,
/** The robot's outline. */
body: BodyChoice,
/** Distance between scan lines, m; half the robot's width if `None`. */
scan_width: number | null,
/** Side of the obstacle map's cells, m. */
cell: number,
/** Headings of the obstacle map. */
headings: number, };

/** Snapshot of a floor plan, and of what is shown of its sweep. */
export type FloorPlanView = {
/** How long the sweep took to be planned. */
seconds: number,
/** Stage of the sweep that is shown, 0 for none. */
stage: number,
/** Heading of the slice that is shown, -1 for none. */
slice: number,
/** Its name. */
name: string,
/** `drawing`, `image` or `map`. */
kind: "drawing" | "image" | "map",
/** Whether a file says how long its unit is. */
says_unit: boolean,
/** Whether it can be scaled. */
is_scalable: boolean,
/** Size of all of it, in words, if that is known. */
size: string | null,
/** The units that there are, with the size that it would have. */
units: Array<UnitView>,
/** Layers of a drawing. */
layers: Array<LayerView>,
/** Number of strokes of a drawing. */
strokes: number,
/** What isn't drawn. */
left_out: Array<string>,
/** What was chosen. */
settings: FloorPlanSettings,
/** The room, if there is one. */
room: TracedRoomView | null,
/** Open doors through which a room that was marked reaches on. */
doors: Doors | null,
/** Why there is none; empty if there is, or if a question is open. */
fault: string,
/** What clicks mean. */
tool: DrawingTool,
/** Points that were set. */
points: number,
/** Whether two points are set whose distance is to be typed. */
is_measured: boolean,
/** That distance as it is now, m. */
measured_m: number | null,
/** Width of the robot, m; `None` if something is wrong with it. */
body_width: number | null,
/** Corners of its outline for a small picture, m; x ahead, y to the left. None of a circle. */
body: Array<[number, number]>,
/** What is wrong with the robot. */
body_fault: string,
/** The sweep, once planned. */
sweep: SweepView | null,
/** One or two sentences that stand for the picture. */
words: string, };

/** What the pointer does on the floor. */
export type FloorTool = "view" | "wall" | "erase" | "start" | "place";

export type LaneView = {
/** Number of the planner in `entrants`. */
entrant: number, coverage: number, time_s: number, distance_m: number, turning_deg: number, finished: boolean,
/** From 1. */
place: number, };

/** A layer. */
export type LayerView = {
/** Its name. */
name: string,
/** `#rrggbb`, as in the file. */
colour: string,
/** Number of strokes. */
strokes: number,
/** What it is. */
role: Role, };

/** What the transport is to do with the line. */
export type LineRequest = { "baud": number } | { "brc": boolean };

/** What the user may do now. */
export type MapActions = {
/** Let time go on. */
play: boolean,
/** Stop time. */
pause: boolean,
/** Go on by a few seconds. */
step: boolean,
/** Go to another point of time. */
seek: boolean,
/** Pick the robot up. */
lift: boolean,
/** Put it down. */
put_down: boolean,
/** Begin anew. */
forget: boolean,
/** Take the map away. */
use_map: boolean,
/** Let it clean by its map. */
clean: boolean,
/** Give the robot a map. */
open: boolean, };

/** How far a mapper is from the truth. */
export type MapErrorFigures = {
/** Distance between the robot's true and estimated position, m; `None` while it has no idea. */
position_m: number | null,
/** Angle between its true and estimated heading, degrees, 0 to 180. */
heading_deg: number | null,
/** Share of the known cells that are right within one cell, 0 to 1; 1 while nothing is known. */
right: number,
/** Share of the floor that the body can cover which is known to be free, 0 to 1. */
known: number,
/** Share of the boundary that a bumper can find which is on the map, to within one cell, 0 to 1. */
boundary: number, };

/** What the survey is doing. */
export type MapPhase = "failed" | "ready" | "playing" | "paused" | "held" | "seeking" | "resuming" | "finished";

/** Snapshot of a survey. SI units; shares from 0 to 1. */
export type MapView = {
/** What the survey is doing. */
phase: MapPhase,
/** What the user may do. */
can: MapActions,
/** Why the robot can't be put into the room; empty if it can. */
complaint: string,
/** Name of the room. */
title: string,
/** Id of the behaviour. */
behaviour: string,
/** What the robot is doing, in a few words. */
activity: string,
/** Its parameters. */
params: Params,
/** How the robot keeps track of itself. */
tracking: string,
/** How wheel counts become motion. */
counts: string,
/** How well the wheels hold. */
wheels: string,
/** How much the sensors err; empty if each kind errs otherwise. */
senses: string,
/** Layers that are shown. */
layers: Array<string>,
/** Speed asked for, times real time; 0 for as fast as it goes. */
speed: number,
/** Speed reached lately, times real time. */
speed_factor: number,
/** Time shown, s. */
time_s: number,
/** Furthest simulated time, s. */
end_s: number,
/** How far the way back to a survey that was left is done; `None` if there is none. */
returned: number | null,
/** Figures of the map. */
figures: MapErrorFigures | null,
/** Figures of a map by odometry alone. */
odometry: MapErrorFigures | null,
/** How far off dead reckoning would be, one for each odometry model in the order of their registry: m and degrees. */
drifts: Array<[number, number]>,
/** Standard deviations that the robot believes in: along the longer axis of the ellipse (m), and heading (degrees). */
spread: [number, number] | null,
/** Name of the map that the robot was given; `None` if it makes its own. */
known: string | null,
/** Whether it is sure of its place on that; `None` if it was never lost. */
is_sure: boolean | null,
/** Id of the planner of what is left. */
planner: string,
/** Pieces of unknown floor that it could go for. */
frontiers: number,
/** Whether it is driving along a line to somewhere. */
has_route: boolean,
/** Whether it cleans by its map. */
is_cleaning: boolean,
/** Floor that it can get to by its map and believes to have swept, and all that it can get to, m²; `None` unless it cleans
 * by that. */
by_map: [number, number] | null,
/** Floor cleaned by the robot's own estimate, m². */
cleaned_m2: number,
/** Share of the reachable floor that it really has cleaned. */
coverage: number,
/** Places where it has found dirt, m². */
dirt_m2: number,
/** Number of samples of the curve; grows or shrinks with them. */
samples: number,
/** Changes whenever another run, or another moment of it, is shown. */
version: number,
/** Whether a hand holds the robot on the picture, which the session doesn't know. */
is_carried: boolean, };

/** A mark that no other algorithm has. */
export type Mark = { colour: number, shape: number, };

/** A number over several seeds. */
export type MedianAndRange = {
/** The middle value; of an even number of values the mean of the two in the middle. */
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
/** Unit that the value is in; empty for counts. */
unit: string,
/** What it is, in one or two sentences. */
definition: string,
/** Which values are wanted. */
better: Better,
/** Digits after the point that are worth showing. */
decimals: number, };

/** A message. */
export type Notice = {
/** Grows with every message. */
number: number,
/** `notice` or `error`. */
kind: "notice" | "error",
/** Sentences for users. */
text: string, };

/** How wheels that have rolled become a change of pose: what tells of them, and along which line that is taken. */
export type OdometryModel = "arc" | "straight" | "packet_arc" | "packet_straight";

/** Snapshot of a session, and of what the hand on the picture of the floor is doing. */
export type PageView = {
/** What the pointer does on the floor. */
tool: FloorTool,
/** What stands, lies and moves in the room, by name. */
objects: Array<string>,
/** Index of the selected one; -1 for none. */
selected: number,
/** What the tool "place" places. */
placing: string,
/** Whether the robot is held on the picture, to be put down somewhere. */
is_carried: boolean,
/** Whether it is held in the upper half of the picture. */
is_held_high: boolean,
/** What the page is doing. */
state: SessionState,
/** What the user may do. */
can: SessionActions,
/** Something to tell the user; empty for nothing. */
message: string,
/** `error` or `notice`; empty for nothing. */
message_kind: "" | "error" | "notice",
/** The room. */
room: RoomView,
/** Id of the robot. */
robot: string,
/** Id of the planner or behaviour. */
algorithm: string,
/** `planner` or `behaviour`. */
kind: "planner" | "behaviour",
/** What the robot is doing, in a few words; empty if there is nothing to tell. */
activity: string,
/** Changes whenever the list of events does. */
diary: number,
/** Whether the robot is held. */
is_lifted: boolean,
/** Why a person's commands aren't obeyed: forward, left, right, backward; `None` unless a person drives. */
blocked: [string | null, string | null, string | null, string | null] | null,
/** Share of the dirt that is left; `None` where there was none. */
dirt_left: number | null,
/** Its parameters. */
params: Params,
/** Side of the planning cells, m. */
cell_size_m: number,
/** Seed of everything random. */
seed: number,
/** How well the wheels hold. */
slip: string,
/** How much the sensors err, in the order of the catalogue's sensors. */
noise: [string, string, string, string, string, string, string],
/** Whether wheels only turn at the speeds that the motor controller can keep. */
quantised: boolean,
/** What is drawn on the floor. */
shows: Shows,
/** How the follower computes its pose. */
odometry: string,
/** Speed asked for, times real time; 0 for as fast as it goes. */
speed: number,
/** Speed reached lately, times real time. */
speed_factor: number,
/** Time shown, s. */
time_s: number,
/** Furthest simulated time, s. */
run_end_s: number,
/** Swept share of the reachable floor. */
coverage: number,
/** Area swept again, as a share of the area swept. */
overlap: number,
/** Distance driven, m. */
distance_m: number,
/** Sum of all turning, degrees. */
turning_deg: number,
/** How often the bumper was pressed. */
bumps: number,
/** Distance between the robot's true and estimated position, m. */
pose_error_m: number,
/** The planner's search. */
search: SearchView,
/** The plan, or what is known of it while the planner is at work. */
plan: PlanView | null, };

/** One parameter. */
export type Param = { id: string, label: string, help: string, default: ParamValue, } & ({ "kind": "number", min: number, max: number, step: number, unit: string, } | { "kind": "choice", options: Array<[string, string]>, } | { "kind": "flag" });

/** Value of a parameter. */
export type ParamValue = boolean | number | string;

/** Values for all parameters of one planner or controller; complete and within range. */
export type Params = { [key in string]: ParamValue };

/** A personality, for menus. */
export type PersonalityView = { id: string, title: string, summary: string, };

/** The plan in numbers; those of walk and drive are 0 until it is there. */
export type PlanView = {
/** Whether the planner is at work. */
running: boolean,
/** How far it is. */
progress: number,
/** Time that planning took, s; `None` while it goes on, and for a plan that was made in advance. */
planning_s: number | null,
/** By how much the plan, or the best walk so far, costs more than any walk must in what its planner keeps low, as a share
 * of that; 0 if it is proven to be the best, `None` for planners that prove nothing. */
gap: number | null,
/** The same in steps + 2 x quarter turns, as plans are compared; `None` as long as nothing is proven, or if it misses cells. */
above_bound: number | null,
/** Steps that a quarter turn counts as in `gap`. */
turn_weight: number | null,
/** Whether that is as long as the robot takes for one. */
times_turns: boolean,
/** Share of the search after which the user was content with the plan; `None` if the planner ended by itself. */
kept_at: number | null,
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
/** Time from rest to rest by the robot's motion model (straight pieces and turns on the spot), s. */
duration_s: number,
/** What the battery gives for it, Wh: the robot's power while it drives straight and while it turns, each times the
 * time of it. As good as the robot's figures, of which some are estimates: about a quarter. */
energy_wh: number,
/** Swept share of the reachable floor, 0 to 1; known to about a fine cell's width along every edge. */
coverage: number,
/** Area swept again by later passes, as a share of the area swept; 0 or more. */
overlap: number,
/** Area swept again by later passes, m²; what is swept three times counts twice. */
overlap_m2: number, };

/** Buttons on the page that stand for those of the robot. */
export type PressedButton = "clean" | "spot" | "dock" | "power";

export type RaceView = { state: SessionState, time_s: number, end_s: number, planned_s: number, speed: number, lanes: Array<LaneView>, };

/** User requests to a robot. In JavaScript, `{ do: "arm", full: false }` and the like. */
export type Request = { "do": "connect" } | { "do": "disconnect" } | { "do": "arm",
/** Full, without the robot's own safety features. */
full: boolean, } | { "do": "disarm" } | { "do": "stop" } | { "do": "drive",
/** Forward, -1 to 1. */
forward: number,
/** To the left, -1 to 1. */
left: number, } | { "do": "press",
/** Which. */
button: PressedButton, } | { "do": "raw",
/** Some bytes, 256 at most. */
bytes: Array<number>, } | { "do": "song",
/** 0 to 3. */
number: number,
/** 1 to 16 of note and duration in 1/64 s. */
notes: Array<[number, number]>, } | { "do": "leds",
/** Bits: debris, spot, dock, check. */
lamps: number,
/** Of the Clean button: 0 green to 255 red. */
colour: number,
/** Its brightness, 0 to 255. */
intensity: number, } | { "do": "digits",
/** Up to four printable characters. */
text: string, } | { "do": "schedule_leds",
/** Bits from Sunday on. */
weekdays: number,
/** Bits: colon, PM, AM, clock, schedule. */
lamps: number, } | { "do": "motors",
/** Bits: side brush, vacuum, main brush, side brush clockwise, main brush outward. */
bits: number, } | { "do": "calibrate",
/** Which. */
what: Calibration, } | { "do": "answer",
/** Degrees or metres, as asked. */
value: number, } | { "do": "skip" } | { "do": "use_calibration",
/** Packets 43 and 44 are swapped. */
swapped: boolean,
/** True distance over what encoders say. */
distance_factor: number,
/** True wheel base over 235 mm. */
base_factor: number, } | { "do": "odometry",
/** Its name, as in links. */
model: OdometryModel, } | { "do": "identify" };

export type RobotEntry = { id: string, title: string, summary: string, default_cell_m: number, tool_width_m: number,
/** Of the smallest circle around the body; all else is in its units, x ahead and y to the left. */
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

/** What a layer is to a robot. */
export type Role = "wall" | "obstacle" | "ignored";

export type RoomEntry = { id: string, title: string, note: string, };

/** The room in numbers. */
export type RoomView = {
/** Id if it ships and hasn't been changed, else empty. */
id: string,
/** Name. */
title: string,
/** What it is good for. */
note: string,
/** Width, m. */
width_m: number,
/** Height, m. */
height_m: number,
/** Side of a map cell, m. */
resolution_m: number,
/** Number of map cells. */
cells: number,
/** Floor that the robot's tool can reach from the start, m². */
reachable_m2: number,
/** Free floor that it can't reach, m². */
left_out_m2: number, };

/** What a Roomba reports over its Open Interface. */
export type RoombaView = {
/** What other robots report, too. */
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
/** Charging state and where the power comes from, in words. */
charging: string,
/** Motor currents, mA: left wheel, right wheel, main brush, side brush. */
motors_ma: [number, number, number, number],
/** Requested speeds, mm/s: left wheel, right wheel. */
requested_mm_s: [number, number],
/** Names of the buttons that are pressed. */
buttons: Array<string>,
/** Number of the song that was chosen last, from 1. */
song: number,
/** Whether it plays. */
song_plays: boolean, };

export type RowView = {
/** Number of the planner in the view's `entrants`. */
entrant: number, trials: number, missing: number, failure: string, values: Array<MedianAndRange | null>,
/** Which values are the best of their column. */
best: Array<boolean>, };

/** What a scenario says beside its room, as text that settings check. What it doesn't mention stays as it is. */
export type ScenarioChoices = {
/** Id of the robot. */
robot: string | null,
/** Side of the planning cells, m. */
cell_size: number | null,
/** Id of the planner. */
planner: string | null,
/** Id of the behaviour. */
behaviour: string | null,
/** Parameters of either, by name. */
params: Array<[string, string]>,
/** Seed of all random numbers. */
seed: string | null,
/** How well the wheels hold. */
slip: string | null,
/** How much each kind of sensor errs; those left out don't. */
noise: Array<[string, string]> | null,
/** Whether wheel speeds come in steps. */
quantised: boolean | null,
/** How the robot computes its pose. */
odometry: string | null, };

/** The planner's search in words. */
export type SearchView = {
/** Whether the planner can show it. */
offered: boolean,
/** Whether it is to be shown. */
on: boolean,
/** The decision at this moment, or what the film shows; empty if there is nothing to tell. */
text: string,
/** Why it can't be shown in this room; empty if it can. */
refusal: string,
/** The film, if there is one and it is to be shown. */
film: FilmView | null, };

/** What the sensors of any robot report. What a robot doesn't have stays at its default. */
export type SensorsView = {
/** Bumper pressed: left and right half. */
bumper: [boolean, boolean],
/** Wheel dropped: left and right. */
wheel_drops: [boolean, boolean],
/** Both wheels dropped: the robot is in somebody's hand. */
is_lifted: boolean,
/** No floor: left, front left, front right, right. */
cliffs: [boolean, boolean, boolean, boolean],
/** Light from the floor there, 0 to 4095. */
cliff_signals: [number, number, number, number],
/** The wall sensor on the right detects something. */
wall: boolean,
/** The beam of a virtual wall is detected. */
virtual_wall: boolean,
/** The castor turns. */
is_moving: boolean,
/** Motors that draw too much current. */
overloads: Array<string>,
/** Light bumper, from left to right: something is near. */
light: [boolean, boolean, boolean, boolean, boolean, boolean],
/** Strengths of its signals, 0 to 4095. */
light_signals: [number, number, number, number, number, number],
/** Receivers on the left, on top and on the right. */
infrared: [BeamsView, BeamsView, BeamsView],
/** Battery and charger. */
battery: BatteryView,
/** Encoders: left, right, sideways. */
counts: [number, number, number],
/** Dirt that is being picked up, 0 to 255. */
dirt: number, };

/** What the user may do now: a flag for each button, which JavaScript only copies. */
export type SessionActions = {
/** Let time go on. */
play: boolean,
/** Stop time. */
pause: boolean,
/** Go on by one move. */
step: boolean,
/** Back to the start. */
reset: boolean,
/** Stop the planner. */
cancel: boolean,
/** Stop it, and drive the best walk that it has found. */
keep: boolean,
/** Go to another point of time. */
seek: boolean,
/** Change something. */
edit: boolean,
/** Pick the robot up. */
lift: boolean,
/** Take the last change of the room back. */
undo: boolean,
/** Make it again. */
redo: boolean, };

/** Everything that determines a session's plan and runs. Two that are equal stand for the same session. */
export type SessionSnapshot = {
/** Id of the room if it ships and hasn't been changed. */
room: string | null,
/** Changes with every change of the room. */
room_version: number,
/** A room of one's own, for those who don't have this version of it. */
own: object | null,
/** Start chosen by the user: x, y in m, heading in rad. */
start: [number, number, number] | null,
/** Robot, algorithm, seed and conditions; what it leaves out is as at first. */
choices: ScenarioChoices, };

/** What the page is doing. */
export type SessionState = "failed" | "planning" | "ready" | "playing" | "paused" | "seeking" | "finished";

/** Layers of the picture that can be shown or not. */
export type Shows = {
/** How often the floor was swept. */
coverage: boolean,
/** Dirt that is left. */
dirt: boolean,
/** What the sensors look at, and what they see. */
sensors: boolean,
/** The robot's estimated trail. */
estimate: boolean, };

/** How the line is. */
export type Statistics = {
/** Baud rate. */
baud: number,
/** Frames that were believed. */
frames: number,
/** Frames with a wrong checksum. */
bad_checksums: number,
/** Headers without a frame. */
false_headers: number,
/** Frames with a right checksum and values that can't be. */
implausible: number,
/** Frames that were believed a frame late, as something in them jumped. */
late: number,
/** Lines of text. */
texts: number,
/** Bytes that belong to nothing. */
noise: number,
/** Bytes received and sent. */
bytes: [number, number],
/** Frames a second, lately. */
rate_hz: number,
/** Time since the last frame, ms. */
age_ms: number,
/** Time from a command until the robot reports it, ms; median of the last ones. */
latency_ms: number | null,
/** The longest time without a frame, ms. */
longest_gap_ms: number,
/** Bytes of the subscription and of the slot of 15 ms that they have to fit in. */
slot: [number, number], };

export type StudyEntrant = { id: string, title: string, summary: string,
/** `planner` or `behaviour`. */
kind: "planner" | "behaviour",
/** Whether it is measured by the boundary that it has met, and not by clean floor. */
explores: boolean, mark: Mark, params: Array<Param>, };

export type StudyEntrantView = { chosen: boolean, params: Params,
/** Runs made of those that are wanted. */
runs: number, failure: string, };

/** What there is to choose from. */
export type StudyOffer = { entrants: Array<StudyEntrant>, seeds: [number, number, number], minutes: [number, number, number], };

/** Where and how all runs are made, in words. */
export type StudyPlace = { room: string, robot: string, slip: string, noise: string, quantised: boolean, };

/** Snapshot for every frame. */
export type StudyView = { version: number, running: boolean, done: number, total: number, seeds: number, minutes: number, entrants: Array<StudyEntrantView>, };

/** Summary of many runs of one algorithm. */
export type Summary = {
/** How many. */
runs: number,
/** Swept share of the reachable floor at the end, 0 to 1. */
coverage: Band,
/** When it had swept the shares of [`GOALS`]. */
time_to: [TimeTo, TimeTo],
/** Distance driven, m. */
distance_m: Band,
/** How often the bumper was pressed. */
bumps: Band,
/** Falls of all runs together. */
falls: number,
/** Share of the dirt that was left, 0 to 1; `None` where there was none. */
dirt_left: Band | null, };

/** A sweep in figures. */
export type SweepView = {
/** Subgoals in all, then by contact: left and right wall, left and right obstacle. */
subgoals: [number, number, number, number, number],
/** Links. */
links: number,
/** Links whose straight way collides. */
collisions: number,
/** Of these, those with a detour. */
resolved: number,
/** Length of the path, m. */
length: number,
/** Share of the reachable floor that is swept, 0 to 1. */
coverage: number,
/** Distance between scan lines, m. */
scan_width: number, };

/** A table of numbers. */
export type TableView = { metrics: Array<MetricInfo>,
/** Of a single room. */
bounds: Bounds | null, rows: Array<RowView>, };

/** When runs had swept a share of the floor.
 *
 * The time of a run that didn't get there is only known to be longer than the run. Times that depend on such a run are
 * `None`: the median, unless more than half of the runs got there. */
export type TimeTo = {
/** The share, %. */
percent: number,
/** Runs that got there. */
reached: number,
/** One run in ten was there by then, s. */
low_s: number | null,
/** Half of the runs were there by then, s. */
median_s: number | null,
/** Nine runs in ten were there by then, s. */
high_s: number | null, };

/** The room that comes of it. */
export type TracedRoomView = {
/** Width, m. */
width_m: number,
/** Height, m. */
height_m: number,
/** Columns and rows. */
cells: [number, number],
/** Floor on which nothing stands, m². */
floor_m2: number,
/** Side of a cell, m. */
resolution: number,
/** Things that stand or lie in it. */
objects: number,
/** Gaps that were closed. */
gaps: number, };

/** Something that went over the line. */
export type Traffic = {
/** When, s. */
time_s: number,
/** What it is. */
kind: TrafficKind,
/** As bytes. */
hex: string,
/** In words. */
text: string,
/** How many of them in a row this stands for: frames come 64 times a second. */
times: number, };

/** What went over the line. */
export type TrafficKind = "sent" | "frame" | "refused" | "text" | "bytes" | "line";

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
/** What it is. */
kind: TransportKind,
/** Whether it is there. */
state: TransportState,
/** Name of the adapter, bridge or personality. */
name: string,
/** A sentence on the state; empty if there is nothing to tell. */
text: string,
/** Baud rate. */
baud: number,
/** Whether the baud rate can be changed. */
can_baud: boolean,
/** The BRC wire at the adapter's RTS. */
brc: BrcWire,
/** What the adapter reported and recovered from. */
errors: TransportErrors,
/** How often it has come back by itself. */
returns: number, };

/** A unit that may be chosen. */
export type UnitView = {
/** Its name. */
name: string,
/** Metres per unit. */
metre: number,
/** The size that the drawing would have. */
size: string, };

/** What is seen and heard of the virtual robot. Sets of bits are as on the line. */
export type VirtualView = {
/** Where it really is: x, y in m, heading in rad. */
pose: [number, number, number], mode: string, awake: boolean, lifted: boolean, fallen: boolean, lamps: number,
/** Colour, 0 green to 255 red, and brightness. */
clean_light: [number, number], digits: string, weekdays: number, schedule: number, motors: number,
/** Tunes that began to sound since the view before: notes of MIDI number and 1/64 s. */
tunes: Array<Array<[number, number]>>, };
