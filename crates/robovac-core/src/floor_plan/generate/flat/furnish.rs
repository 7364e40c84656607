//! Furniture for every room of a flat.

use super::{
    FlatSpec,
    area::Area,
    fitting::{Fitting, PlaceKind},
    layout::{FlatLayout, FlatRoom, RoomUse},
    piece::Piece,
    pieces::{
        armchair, basin, bookcase, breakfast_table, chair, chest_of_drawers, desk, dining_table, double_bed, duct,
        fridge, island, round_thing, rug, shelves, shoe_rack, shower, sideboard, single_bed, sofa, thing_on_floor,
        toilet, tub, wardrobe, washing_machine, worktop,
    },
};
use crate::{floor_plan::Object, geometry::Pose, rng::Rng};
use rand::RngExt;

/// Amount of furniture at which the recipes hold.
const USUAL: f64 = 0.7;
/// Distance of the robot's start from the dock's back, cells: it stands 11 cm before the contacts.
const AHEAD: i32 = 6;

/// A piece that a kind of room can have, where, and how often in a usual home.
type Wish = (fn(&mut Rng) -> Piece, PlaceKind, f64);

const LIVING: &[Wish] = &[
    (duct, PlaceKind::Corner, 0.15),
    (sofa, PlaceKind::Wall, 0.95),
    (sideboard, PlaceKind::Facing, 0.9),
    (dining_table, PlaceKind::Open, 0.5),
    (bookcase, PlaceKind::Wall, 0.7),
    (armchair, PlaceKind::Anywhere, 0.5),
    (bookcase, PlaceKind::Wall, 0.3),
    (round_thing, PlaceKind::Corner, 0.6),
    (round_thing, PlaceKind::Wall, 0.4),
    (chair, PlaceKind::Wall, 0.2),
];
const OPEN_PLAN: &[Wish] = &[
    (duct, PlaceKind::Corner, 0.15),
    (worktop, PlaceKind::Corner, 1.0),
    (fridge, PlaceKind::Corner, 0.9),
    (worktop, PlaceKind::Corner, 0.4),
    (sofa, PlaceKind::Wall, 0.95),
    (sideboard, PlaceKind::Facing, 0.9),
    (dining_table, PlaceKind::Open, 0.9),
    (island, PlaceKind::Open, 0.4),
    (bookcase, PlaceKind::Wall, 0.5),
    (armchair, PlaceKind::Anywhere, 0.4),
    (round_thing, PlaceKind::Corner, 0.6),
    (round_thing, PlaceKind::Wall, 0.4),
];
const STUDIO: &[Wish] = &[
    (double_bed, PlaceKind::Corner, 0.7),
    (single_bed, PlaceKind::Corner, 0.3),
    (wardrobe, PlaceKind::Wall, 0.9),
    (sofa, PlaceKind::Wall, 0.6),
    (sideboard, PlaceKind::Facing, 0.6),
    (breakfast_table, PlaceKind::Wall, 0.8),
    (worktop, PlaceKind::Corner, 0.5),
    (desk, PlaceKind::Wall, 0.5),
    (bookcase, PlaceKind::Wall, 0.4),
    (round_thing, PlaceKind::Corner, 0.5),
];
const KITCHEN: &[Wish] = &[
    (worktop, PlaceKind::Corner, 1.0),
    (fridge, PlaceKind::Corner, 0.9),
    (worktop, PlaceKind::Corner, 0.4),
    (dining_table, PlaceKind::Open, 0.4),
    (breakfast_table, PlaceKind::Wall, 0.6),
    (round_thing, PlaceKind::Wall, 0.6),
    (chair, PlaceKind::Wall, 0.2),
];
const BEDROOM: &[Wish] = &[
    (double_bed, PlaceKind::Wall, 0.95),
    (wardrobe, PlaceKind::Wall, 0.95),
    (chest_of_drawers, PlaceKind::Wall, 0.6),
    (desk, PlaceKind::Wall, 0.15),
    (armchair, PlaceKind::Anywhere, 0.2),
    (chair, PlaceKind::Wall, 0.5),
    (round_thing, PlaceKind::Corner, 0.5),
];
const CHILD: &[Wish] = &[
    (single_bed, PlaceKind::Corner, 0.95),
    (wardrobe, PlaceKind::Wall, 0.8),
    (desk, PlaceKind::Wall, 0.8),
    (bookcase, PlaceKind::Wall, 0.6),
    (chest_of_drawers, PlaceKind::Wall, 0.4),
    (thing_on_floor, PlaceKind::Anywhere, 0.6),
    (thing_on_floor, PlaceKind::Anywhere, 0.5),
    (thing_on_floor, PlaceKind::Anywhere, 0.4),
    (thing_on_floor, PlaceKind::Anywhere, 0.3),
    (round_thing, PlaceKind::Corner, 0.4),
];
const STUDY: &[Wish] = &[
    (desk, PlaceKind::Wall, 1.0),
    (bookcase, PlaceKind::Wall, 0.9),
    (bookcase, PlaceKind::Wall, 0.5),
    (sofa, PlaceKind::Wall, 0.3),
    (armchair, PlaceKind::Anywhere, 0.4),
    (chest_of_drawers, PlaceKind::Wall, 0.4),
    (thing_on_floor, PlaceKind::Anywhere, 0.4),
    (round_thing, PlaceKind::Corner, 0.6),
];
const BATH: &[Wish] = &[
    (tub, PlaceKind::Corner, 0.55),
    (shower, PlaceKind::Corner, 0.6),
    (toilet, PlaceKind::Wall, 1.0),
    (basin, PlaceKind::Wall, 1.0),
    (washing_machine, PlaceKind::Wall, 0.5),
    (round_thing, PlaceKind::Corner, 0.5),
];
const STORAGE: &[Wish] = &[
    (shelves, PlaceKind::Wall, 1.0),
    (shelves, PlaceKind::Wall, 0.7),
    (shelves, PlaceKind::Corner, 0.5),
    (thing_on_floor, PlaceKind::Anywhere, 0.5),
];
const HALL: &[Wish] = &[
    (shoe_rack, PlaceKind::Wall, 0.8),
    (wardrobe, PlaceKind::Wall, 0.3),
    (round_thing, PlaceKind::Corner, 0.5),
    (thing_on_floor, PlaceKind::Wall, 0.3),
    (chair, PlaceKind::Wall, 0.15),
];

impl RoomUse {
    fn wishes(self) -> &'static [Wish] {
        match self {
            Self::Living => LIVING,
            Self::OpenPlan => OPEN_PLAN,
            Self::Studio => STUDIO,
            Self::Kitchen => KITCHEN,
            Self::Bedroom => BEDROOM,
            Self::Child => CHILD,
            Self::Study => STUDY,
            Self::Bath => BATH,
            Self::Storage => STORAGE,
            Self::Hall => HALL,
        }
    }

    fn has_rug(self) -> f64 {
        match self {
            Self::Storage | Self::Kitchen => 0.1,
            Self::Hall | Self::Study => 0.3,
            _ => 0.5,
        }
    }
}

/// What stands in a flat.
#[derive(Debug)]
pub(super) struct Furnished {
    /// What is drawn into the cells.
    pub solids: Vec<Area>,
    pub objects: Vec<Object>,
    /// Where the robot starts: in front of its dock, looking away from it.
    pub start: Pose,
}

/// Furnishes all rooms.
pub(super) fn furnish(layout: &FlatLayout, spec: &FlatSpec, rng: &mut Rng) -> Furnished {
    let fitting = |number: usize, room: &FlatRoom| {
        Fitting::new(room.area, layout.doors.iter().filter(|door| door.rooms.contains(&number)))
    };
    let mut rooms: Vec<Fitting> = layout.rooms.iter().enumerate().map(|(n, room)| fitting(n, room)).collect();
    let start = put_dock(layout, &mut rooms, rng);
    let how_often = |usual: f64| match spec.furniture {
        few if few <= USUAL => usual * few / USUAL,
        many => usual + (1.0 - usual) * (many - USUAL) / (1.0 - USUAL),
    };
    for (number, (room, fitting)) in layout.rooms.iter().zip(&mut rooms).enumerate() {
        // Leaves open into the room that is no hall.
        for door in layout.doors.iter().filter(|door| door.rooms[0] == number && !door.is_wide) {
            if rng.random_bool(0.4 * how_often(1.0).min(1.0)) {
                fitting.hang(door, rng.random_bool(0.5));
            }
        }
        for &(make, spot, usual) in room.purpose.wishes() {
            if rng.random_bool(how_often(usual).clamp(0.0, 1.0)) {
                fitting.put(make, spot, rng);
            }
        }
        if rng.random_bool(how_often(room.purpose.has_rug()).clamp(0.0, 1.0)) && spec.rugs {
            fitting.put(rug, PlaceKind::Anywhere, rng);
        }
    }
    let (mut solids, mut objects) = (Vec::new(), Vec::new());
    for fitting in rooms {
        solids.extend(fitting.solids);
        objects.extend(fitting.objects);
    }
    if !spec.rugs {
        objects.retain(|object| !matches!(object, Object::Carpet { .. }));
    }
    Furnished { solids, objects, start }
}

/// Puts the dock into the hall, if it fits there, or into a living room; returns the start.
fn put_dock(layout: &FlatLayout, rooms: &mut [Fitting], rng: &mut Rng) -> Pose {
    let hall_first = rng.random_bool(0.5);
    let rank = |room: &FlatRoom| match room.purpose {
        RoomUse::Hall => u8::from(!hall_first),
        RoomUse::Living | RoomUse::OpenPlan | RoomUse::Studio => u8::from(hall_first),
        _ => 2,
    };
    let mut order: Vec<usize> = (0..rooms.len()).collect();
    order.sort_by_key(|&number| rank(&layout.rooms[number]));
    let stand = order.into_iter().find_map(|number| rooms[number].dock(AHEAD, rng));
    let ahead = f64::from(AHEAD) * super::CELL;
    stand.map_or(Pose::new(0.0, 0.0, 0.0), |stand| stand.pose([0.25, ahead]))
}
