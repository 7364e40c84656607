//! Traces a room from a drawing.

mod alone;
mod behind;
mod cut_frame;
mod fills;
mod frame;
mod gaps;
mod house;
mod leak;
mod openings;
mod outlines;
mod page;
mod pen;
mod raster;
mod region;
mod solids;
mod start;
mod surroundings;

use super::{
    Drawing, DrawingError, DrawingFlaw, DrawingRegion, FreeStandingBuilding, OutsideLeak, Picture, Role, Traced,
    Tracing, error::bad, picture::PictureSampler,
};
pub(crate) use page::without_page;

use alone::FreeBuilding;
use frame::{BoundingBox, RasterFrame, bounds_of};
use house::{FreeStanding, Site};
use raster::RasterCanvas;
use robovac_core::{
    floor_plan::{FloorPlan, MAX_CORNERS, MAX_RESOLUTION, MAX_SIDE, MIN_RESOLUTION, crossing, encloses},
    geometry::{Point, Pose, Vector},
    grid::{Cell, Grid, Occupancy},
    math::{ceil, floor},
};
use surroundings::{Building, Surrounded};

/// Free cells around a whole drawing, so that there is a way around its walls.
const MARGIN: i32 = 2;
/// Floor around a drawing whose walls enclose nothing, m (ours): room for a robot to pass.
const OPEN_MARGIN: f64 = 1.0;
/// Width of outer doors, m (ours): they are closed indoors unless another width is chosen. Double doors and gates stay open.
pub const OUTER_DOOR: f64 = 1.25;
/// Largest niche of the outside without a place as wide as an outer door, m² (ours), where nothing else is inside.
const NICHE: f64 = 12.0;
/// Least share of the floor that walls enclose indoors: the insides of letters and furniture are no building.
const INDOORS: f64 = 0.05;
/// The same of a whole drawing.
const LEAST_ROOM: f64 = 0.02;
/// Ends of walls closer than this are joined, m (ours); allows for rounding by drawing programs.
const TOUCHING: f64 = 1e-3;
/// Side of the first area searched around the point that chooses a room, cells; doubled until it contains the room.
const FIRST_LOOK: i32 = 512;

/// Traces a room from a drawing.
///
/// Strokes of walls stop the robot, and so do open ones of obstacles: every cell that they cross, in their width, is occupied. A closed
/// wall only encloses floor, unless its area is painted dark. A closed obstacle is solid: a piece of furniture, or a leg if it is a circle, with its
/// exact outline; beyond the limits of a room, the cells that it covers. So are open ones that are joined end to end round
/// no more than a piece of furniture.
///
/// Of a whole drawing, floor is the area that can't be reached from outside, if walls enclose more than a tree's inside; otherwise
/// the bounding box. Openings between free ends of walls are closed by lines. Where a room is chosen, and where the whole
/// gets larger by it, openings up to the same width are closed however the walls beside them are drawn: walls that are
/// outlines have no free ends.
///
/// ```
/// use floor_drawing::{DrawingRegion, Role, Tracing, read, trace};
/// use robovac_core::floor_plan::{SourceFile, to_ascii};
/// let dxf = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nWALL\n70\n1\n10\n0\n20\n0\n10\n3000\n20\n0\n10\n3000\n20\n2000\n\
///            10\n0\n20\n2000\n0\nENDSEC\n0\nEOF\n";
/// let drawing = read(&SourceFile { name: "room.dxf".into(), bytes: dxf.into() })?;
/// let how =
///     Tracing { roles: vec![Role::Wall], metre: 0.001, gap: 0.0, resolution: 0.5, region: DrawingRegion::WHOLE };
/// let room = trace(&drawing, &how)?;
/// assert!(to_ascii(&room.plan).ends_with(
///     "##########\n##########\n###.....##\n###.....##\n###.....##\n##########\n##########\n##########\n"
/// ));
/// # Ok::<(), floor_drawing::DrawingError>(())
/// ```
pub fn trace(drawing: &Drawing, how: &Tracing) -> Result<Traced, DrawingError> {
    RoomTracer::new(&outlines::joined(drawing, how), how)
        .and_then(|tracer| tracer.run())
        .map_err(|flaw| bad(&drawing.name, "", flaw))
}

/// Traces a room from a picture, whose unit is a pixel: cells with a pixel that isn't floor are walls. `how.roles` has no
/// use, and only openings between walls are closed, whatever their ends are like.
pub fn trace_picture(picture: &Picture, how: &Tracing) -> Result<Traced, DrawingError> {
    let drawing = Drawing {
        name: picture.name.clone(),
        metre: None,
        layers: Vec::new(),
        strokes: Vec::new(),
        points: Vec::new(),
        left_out: Vec::new(),
    };
    let how = Tracing { roles: Vec::new(), ..how.clone() };
    let sampler = PictureSampler::new(picture);
    let tracer = RoomTracer::with(&drawing, &how, Some(&sampler));
    let traced = tracer.and_then(|tracer| tracer.run()).map_err(|flaw| bad(&drawing.name, "", flaw))?;
    Ok(traced.turned(picture.turn))
}

/// The floor that walls enclose.
struct EnclosedFloor {
    frame: RasterFrame,
    inside: Grid<bool>,
    walls: Grid<bool>,
    /// Openings that are closed for it.
    openings: Vec<[Point; 2]>,
    /// Cells within the outermost walls that lie round the building.
    around: usize,
    /// A building that may stand free within it.
    in_doubt: Option<FreeBuilding>,
    /// The building with little of the floor within the outermost walls: its floor, and whether that is what is taken.
    small: Option<(Grid<bool>, bool)>,
}

struct RoomTracer<'a> {
    drawing: &'a Drawing,
    /// What is traced instead of strokes.
    picture: Option<&'a PictureSampler<'a>>,
    how: &'a Tracing,
    /// Bounding box of all strokes that aren't ignored, drawing units.
    bounds: BoundingBox,
    /// Side of a cell, drawing units.
    side: f64,
    bridges: Vec<[Point; 2]>,
}

impl<'a> RoomTracer<'a> {
    fn new(drawing: &'a Drawing, how: &'a Tracing) -> Result<Self, DrawingFlaw> {
        Self::with(drawing, how, None)
    }

    fn with(
        drawing: &'a Drawing,
        how: &'a Tracing,
        picture: Option<&'a PictureSampler<'a>>,
    ) -> Result<Self, DrawingFlaw> {
        let (layers, roles) = (drawing.layers.len(), how.roles.len());
        if layers != roles || drawing.strokes.iter().any(|stroke| stroke.layer as usize >= roles) {
            return Err(DrawingFlaw::Roles { layers, roles });
        }
        if !(1e-12..=1e12).contains(&how.metre) {
            return Err(DrawingFlaw::Metre { value: how.metre });
        }
        if !(MIN_RESOLUTION..=MAX_RESOLUTION).contains(&how.resolution) {
            return Err(DrawingFlaw::Resolution { value: how.resolution });
        }
        let bounds = match picture {
            Some(PictureSampler { picture: Picture { blocked, turn, .. }, .. }) => {
                let [low, high] = Picture::bounds(blocked.width(), blocked.height(), *turn);
                Some(BoundingBox { low, high })
            }
            None => bounds_of(drawing, |layer| how.roles[layer as usize] != Role::Ignored),
        };
        let bounds = bounds.ok_or(DrawingFlaw::AllIgnored)?;
        let mut tracer = Self { drawing, picture, how, bounds, side: how.resolution / how.metre, bridges: Vec::new() };
        if how.gap > 0.0 {
            tracer.bridges = tracer.bridges();
        }
        Ok(tracer)
    }

    fn bridges(&self) -> Vec<[Point; 2]> {
        let is_wall = |layer: u32| self.how.roles[layer as usize] == Role::Wall;
        let walls: Vec<gaps::WallStroke<'_>> = self
            .drawing
            .strokes
            .iter()
            .filter(|stroke| is_wall(stroke.layer))
            .map(|stroke| gaps::WallStroke {
                corners: self.drawing.corners(stroke),
                is_closed: stroke.is_closed,
                half: 0.5 * stroke.width,
            })
            .collect();
        let gap = self.how.gap.min(1e6) / self.how.metre;
        gaps::bridges(&walls, gap, TOUCHING / self.how.metre)
    }

    fn run(&self) -> Result<Traced, DrawingFlaw> {
        match &self.how.region {
            DrawingRegion::Indoors { .. } => self.indoors(),
            DrawingRegion::Whole { outer } => self.whole_from_indoors(*outer),
            DrawingRegion::Rectangle { low, high } => self.rectangle(*low, *high),
            DrawingRegion::Polygon(outline) => self.polygon(outline),
            DrawingRegion::Room(point) => self.room(*point),
        }
    }

    fn indoors(&self) -> Result<Traced, DrawingFlaw> {
        let found = self.enclosed()?;
        let area = |cells: usize| cells as f64 * self.how.resolution * self.how.resolution;
        let leak = match self.outside_leak(found.as_ref())? {
            None => found.as_ref().and_then(|found| found.garden_leak(self.how.resolution)),
            leak => leak,
        };
        let is_open = found.is_none();
        let mut traced = match found {
            Some(EnclosedFloor { frame, inside, walls, openings, around, in_doubt, small }) => {
                let mut traced = self.cropped(&frame, inside, &walls, &openings)?;
                traced.around_m2 = area(around);
                let home = small.as_ref().filter(|(_, is_taken)| !is_taken).map(|(floor, _)| floor);
                if let Some(home) = home.or(in_doubt.as_ref().map(|building| &building.floor)) {
                    self.start_at(&mut traced, &frame, home);
                }
                traced.free_standing =
                    small.map(|(floor, is_taken)| FreeStandingBuilding { floor_m2: area(floor.count()), is_taken });
                traced
            }
            None => self.whole()?,
        };
        (traced.leak, traced.is_open) = (leak, is_open);
        Ok(traced)
    }

    /// The floor that walls enclose, with openings up to the width of an outer door closed, without what lies round a
    /// building within the outermost walls. `None` if they enclose hardly any.
    fn enclosed(&self) -> Result<Option<EnclosedFloor>, DrawingFlaw> {
        self.enclosed_by(self.outer())
    }

    /// Widest opening to the outside that is closed, m.
    fn outer(&self) -> f64 {
        let outer = match self.how.region {
            DrawingRegion::Indoors { outer } => outer,
            DrawingRegion::Whole { outer } if outer > 0.0 => outer,
            _ => OUTER_DOOR,
        };
        outer.max(self.how.gap)
    }

    /// The same with openings up to `widest` metres closed.
    fn enclosed_by(&self, widest: f64) -> Result<Option<EnclosedFloor>, DrawingFlaw> {
        // Rooms aren't as wide as any opening that can be closed: they are no niches of the outside then.
        if widest > OUTER_DOOR.max(self.how.gap) {
            return self.enclosed_with(widest, widest * widest);
        }
        // Nor is a room full of furniture, if there is no other.
        let found = self.enclosed_with(widest, f64::INFINITY)?;
        if found.is_some() { Ok(found) } else { self.enclosed_with(widest, NICHE) }
    }

    /// The same with niches of the outside up to `most` m².
    fn enclosed_with(&self, widest: f64, most: f64) -> Result<Option<EnclosedFloor>, DrawingFlaw> {
        let [gap, door] = [widest, OUTER_DOOR.max(self.how.gap)].map(|metres| metres / self.how.resolution);
        let frame = RasterFrame::around(&self.bounds, self.side, ceil(gap.min(1e6)).saturating_add(MARGIN));
        if frame.check(self.how.metre).is_err() {
            return Ok(None);
        }
        let walls = self.walls(&frame, false)?;
        let mut inside = region::enclosed(&walls, self.how.resolution);
        let most = (most / self.how.resolution / self.how.resolution) as usize;
        let outside = openings::part_with(&walls, [Cell::new(0, 0)], gap, most);
        let mut openings = Vec::new();
        let mut shut = outside.cells.clone();
        for (cell, &is_wall) in shut.values_mut().iter_mut().zip(walls.values()) {
            *cell |= is_wall;
        }
        let with_doors_closed = region::enclosed(&shut, self.how.resolution);
        if with_doors_closed.count() > inside.count() {
            (inside, openings) = (with_doors_closed, outside.openings);
        }
        let all = inside.count();
        let has_garden = self.drawing.layers.iter().any(|layer| house::names_garden(&layer.name));
        let floor = inside.clone();
        let site = |door: f64| Site {
            floor: &floor,
            outside: &outside.cells,
            door,
            resolution: self.how.resolution,
            has_garden,
        };
        let (free, in_doubt) = match alone::building(&walls, site(door), gap) {
            Some(free) if !free.is_decided(gap) => (None, Some(free)),
            free => (free, None),
        };
        // Its rooms behind terrace doors would be missing.
        let building = |door: f64| surroundings::building(&walls, site(door), in_doubt.is_none());
        let surrounded = if let Some(FreeBuilding { floor, is_small, .. }) = free {
            let openings = openings::openings(&walls, &floor);
            let small = is_small.then_some(FreeStanding::House);
            Surrounded { building: Some(Building { floor, openings, small }), in_doubt: None }
        } else {
            let first = building(gap.max(door));
            let next = (first.building.is_none() && gap > door).then(|| building(door));
            next.filter(|next| next.building.is_some()).unwrap_or(first)
        };
        let Surrounded { building, in_doubt: may_be } = surrounded;
        let is_in_garden = building.is_some();
        let mut small = may_be.map(|floor| (floor, false));
        if let Some(building) = building {
            (inside, openings) = (building.floor, building.openings);
            if building.small.is_some() {
                small = Some((inside.clone(), true));
            }
        }
        surroundings::remove_outbuildings(&mut inside, &walls);
        let around = all - inside.count();
        let size = (self.bounds.high - self.bounds.low) / self.side;
        let is_building = inside.count() as f64 >= INDOORS * size.x * size.y;
        let in_doubt = in_doubt.filter(|_| !is_in_garden);
        Ok(is_building.then_some(EnclosedFloor { frame, inside, walls, openings, around, in_doubt, small }))
    }

    fn whole(&self) -> Result<Traced, DrawingFlaw> {
        if self.picture.is_some() {
            let frame = RasterFrame::around(&self.bounds, self.side, 0);
            frame.check(self.how.metre)?;
            let floor = self.walls(&frame, true)?.map(|is_wall| !is_wall);
            return self.furnished(&frame, &floor);
        }
        let frame = RasterFrame::around(&self.bounds, self.side, MARGIN);
        frame.check(self.how.metre)?;
        let walls = self.walls(&frame, false)?;
        let inside = region::enclosed(&walls, self.how.resolution);
        let closed = inside.count();
        // If walls enclose only a column or one room, rooms with open doors aren't found that way.
        if let Some(traced) = self.whole_with_open_doors(closed)? {
            return Ok(traced);
        }
        // A tree in a garden whose gate is open is no room.
        let size = (self.bounds.high - self.bounds.low) / self.side;
        if closed as f64 > LEAST_ROOM * size.x * size.y {
            return self.furnished(&frame, &inside);
        }
        let margin = ceil(OPEN_MARGIN / self.how.resolution).max(MARGIN);
        let frame = RasterFrame::around(&self.bounds, self.side, margin);
        frame.check(self.how.metre)?;
        let walls = self.walls(&frame, false)?;
        self.furnished(&frame, &walls.map(|is_wall| !is_wall))
    }

    /// The floor enclosed when openings in walls are closed, if that is more than the `closed` cells enclosed anyway.
    fn whole_with_open_doors(&self, closed: usize) -> Result<Option<Traced>, DrawingFlaw> {
        let gap = self.how.gap / self.how.resolution;
        let frame = RasterFrame::around(&self.bounds, self.side, ceil(gap.min(1e6)).saturating_add(MARGIN));
        if gap <= 0.0 || frame.check(self.how.metre).is_err() {
            return Ok(None);
        }
        let walls = self.walls(&frame, false)?;
        let outside = openings::part(&walls, [Cell::new(0, 0)], gap);
        let mut shut = outside.cells;
        for (cell, &is_wall) in shut.values_mut().iter_mut().zip(walls.values()) {
            *cell |= is_wall;
        }
        let inside = region::enclosed(&shut, self.how.resolution);
        if inside.count() <= closed {
            return Ok(None);
        }
        self.cropped(&frame, inside, &walls, &outside.openings).map(Some)
    }

    fn rectangle(&self, a: Point, b: Point) -> Result<Traced, DrawingFlaw> {
        let frame = self.frame_of(&BoundingBox { low: a.inf(&b), high: a.sup(&b) })?;
        let walls = self.walls(&frame, true)?;
        self.furnished(&frame, &walls.map(|is_wall| !is_wall))
    }

    fn polygon(&self, outline: &[Point]) -> Result<Traced, DrawingFlaw> {
        let refused = DrawingFlaw::Outline { most: MAX_CORNERS };
        let is_simple = (3..=MAX_CORNERS).contains(&outline.len()) && crossing(outline).is_none();
        let Some(bounds) = BoundingBox::of(outline.iter().copied()).filter(|_| is_simple) else { return Err(refused) };
        let frame = self.frame_of(&bounds)?;
        let mut free = self.walls(&frame, true)?.map(|is_wall| !is_wall);
        let outline: Vec<Point> = outline.iter().map(|&corner| frame.cells(corner)).collect();
        for index in 0..free.len() {
            let centre = free.cell(index).centre(1.0);
            free.values_mut()[index] &= encloses(&outline, centre);
        }
        self.furnished(&frame, &free)
    }

    /// Cells for a chosen region, if its size is valid.
    fn frame_of(&self, bounds: &BoundingBox) -> Result<RasterFrame, DrawingFlaw> {
        let size = (bounds.high - bounds.low) * self.how.metre;
        let (width, height) = (size.x, size.y);
        let least = 3.0 * self.how.resolution;
        if width >= least && height >= least {
            let frame = RasterFrame::around(bounds, self.side, 0);
            return frame.check(self.how.metre).map(|()| frame);
        }
        Err(DrawingFlaw::TooSmall { width, height, resolution: self.how.resolution })
    }

    fn room(&self, click: Point) -> Result<Traced, DrawingFlaw> {
        let all = RasterFrame::around(&self.bounds, self.side, MARGIN);
        let at = all.cells(click);
        let not_floor = |what| DrawingFlaw::NotFloor { what, x: click.x, y: click.y };
        let is_inside = at.x >= 0.0 && at.y >= 0.0 && at.x < f64::from(all.size[0]) && at.y < f64::from(all.size[1]);
        if !is_inside {
            return Err(not_floor("nothing drawn"));
        }
        let at = [floor(at.x), floor(at.y)];
        let mut look = FIRST_LOOK;
        loop {
            let from = [0, 1].map(|axis| (at[axis] - look / 2).max(0));
            let to = [0, 1].map(|axis| (at[axis].saturating_add(look / 2)).min(all.size[axis]));
            let frame = all.part(from, [to[0] - from[0], to[1] - from[1]]);
            let walls = self.walls(&frame, false)?;
            let start = Cell::new(at[0] - from[0], at[1] - from[1]);
            if walls.is_set(start) {
                return Err(not_floor("a wall"));
            }
            let mut blocked = RasterCanvas::new(frame.size);
            for stroke in solids::solids(self.drawing, &self.how.roles) {
                blocked.fill(&solids::in_cells(self.drawing, stroke, &frame))?;
            }
            if blocked.cells.is_set(start) {
                return Err(not_floor("an obstacle"));
            }
            for (cell, &is_wall) in blocked.cells.values_mut().iter_mut().zip(walls.values()) {
                *cell |= is_wall;
            }
            let blocked = blocked.cells;
            if self.how.gap > 0.0 {
                // Furniture makes no doors. A corridor as narrow as a door is left open.
                let part = openings::part(&walls, [start], self.how.gap / self.how.resolution);
                if !part.meets_border && part.cells.is_set(start) {
                    return self.cropped(&frame, part.cells, &walls, &part.openings);
                }
            }
            let (reached, meets_border) = region::room(&blocked, start);
            if !meets_border {
                return self.cropped(&frame, reached, &walls, &[]);
            }
            let is_all = from == [0, 0] && to == all.size;
            if !is_all && look < MAX_SIDE as i32 {
                look *= 2;
                continue;
            }
            if !is_all {
                all.check(self.how.metre)?;
            }
            let (place, width) = region::leak(&blocked, start).unwrap_or((start.centre(1.0), 1.0));
            let place = frame.point(place);
            // Ends of lines lie somewhere within cells of wall, and the square is an odd number of cells wide.
            let wider = if self.picture.is_some() { 1.0 } else { 3.0 };
            return Err(DrawingFlaw::Leak { x: place.x, y: place.y, width: (width + wider) * self.how.resolution });
        }
    }

    /// The room with its objects, within one cell of wall. `openings` were closed for it.
    fn cropped(
        &self,
        frame: &RasterFrame,
        mut floor: Grid<bool>,
        walls: &Grid<bool>,
        openings: &[[Point; 2]],
    ) -> Result<Traced, DrawingFlaw> {
        // There is floor beneath objects.
        let mut beneath = RasterCanvas::new(frame.size);
        let on_floor = solids::DrawnFloor::new(&floor);
        for stroke in solids::solids(self.drawing, &self.how.roles) {
            let outline = solids::in_cells(self.drawing, stroke, frame);
            if on_floor.touches(&outline) {
                beneath.fill(&outline)?;
            }
        }
        for ((cell, &is_beneath), &is_wall) in
            floor.values_mut().iter_mut().zip(beneath.cells.values()).zip(walls.values())
        {
            *cell |= is_beneath && !is_wall;
        }
        let (mut low, mut high) = ([i32::MAX; 2], [i32::MIN; 2]);
        for (cell, _) in floor.iter().filter(|(_, is_floor)| **is_floor) {
            low = [low[0].min(cell.x), low[1].min(cell.y)];
            high = [high[0].max(cell.x), high[1].max(cell.y)];
        }
        if low[0] > high[0] {
            return Err(DrawingFlaw::NoFloor);
        }
        let from = low.map(|low| low - 1);
        let size = [high[0] - low[0] + 3, high[1] - low[1] + 3];
        let part = frame.part(from, size);
        part.check(self.how.metre)?;
        let mut cut = Grid::filled(size[0] as usize, size[1] as usize, false);
        for index in 0..cut.len() {
            let cell = cut.cell(index);
            cut.values_mut()[index] = floor.is_set(Cell::new(cell.x + from[0], cell.y + from[1]));
        }
        let mut traced = self.furnished(&part, &cut)?;
        self.add_gaps(&mut traced, frame, openings);
        Ok(traced)
    }

    /// Adds closed openings, in cells of `frame`, to the room's gaps.
    fn add_gaps(&self, traced: &mut Traced, frame: &RasterFrame, openings: &[[Point; 2]]) {
        let metres = |end: Point| Point::from((frame.point(end).coords - traced.corner) * self.how.metre);
        let gaps: Vec<_> = openings.iter().map(|ends| ends.map(metres)).collect();
        traced.gaps.extend(gaps);
    }

    /// Cells that walls, closed gaps and open obstacles cross. `outside` is what lies beyond a picture.
    fn walls(&self, frame: &RasterFrame, outside: bool) -> Result<Grid<bool>, DrawingFlaw> {
        let mut canvas = RasterCanvas::new(frame.size);
        if let Some(picture) = self.picture {
            for index in 0..canvas.cells.len() {
                let low = frame.point(canvas.cells.cell(index).centre(1.0) - Vector::new(0.5, 0.5));
                canvas.cells.values_mut()[index] = picture.blocks(low, frame.side, outside);
            }
        }
        fills::paint_walls(&mut canvas, self.drawing, &self.how.roles, frame)?;
        for stroke in &self.drawing.strokes {
            let stops = match self.how.roles[stroke.layer as usize] {
                Role::Wall => true,
                Role::Obstacle => !stroke.is_closed,
                Role::Ignored => false,
            };
            if !stops {
                continue;
            }
            let corners = self.drawing.corners(stroke);
            for pair in corners.windows(2) {
                canvas.segment(frame.cells(pair[0]), frame.cells(pair[1]))?;
            }
            if let (true, Some(&first), Some(&last)) = (stroke.is_closed, corners.first(), corners.last()) {
                canvas.segment(frame.cells(last), frame.cells(first))?;
            }
            for piece in pen::pieces(corners, stroke.is_closed, stroke.width) {
                canvas.fill(&piece.map(|corner| frame.cells(corner)))?;
            }
        }
        for [a, b] in &self.bridges {
            canvas.segment(frame.cells(*a), frame.cells(*b))?;
        }
        Ok(canvas.cells)
    }

    fn furnished(&self, frame: &RasterFrame, floor: &Grid<bool>) -> Result<Traced, DrawingFlaw> {
        let metre = self.how.metre;
        let mut plan = FloorPlan {
            name: self.drawing.name.clone(),
            note: String::new(),
            resolution: self.how.resolution,
            occupancy: floor.map(|&is_floor| if is_floor { Occupancy::Free } else { Occupancy::Occupied }),
            objects: Vec::new(),
            start: None,
            origin: Pose::new(frame.low.x * metre, frame.low.y * metre, 0.0),
        };
        solids::furnish(&mut plan, self.drawing, &self.how.roles, frame)?;
        if !plan.occupancy.values().iter().any(|cell| cell.is_free()) {
            return Err(DrawingFlaw::NoFloor);
        }
        let inside = |end: &Point| (0.0..=plan.width_m()).contains(&end.x) && (0.0..=plan.height_m()).contains(&end.y);
        let in_room = self.bridges.iter().map(|ends| ends.map(|end| frame.cells(end) * self.how.resolution));
        let gaps = in_room.filter(|ends| ends.iter().all(inside)).collect();
        Ok(Traced { corner: frame.low.coords, gaps, ..Traced::of_map(plan, metre) })
    }
}
