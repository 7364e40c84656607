//! What stands in homes; lengths in cells of 5 cm unless they are radii.
//!
//! Beds, sofas and tables stand on legs or flush on the floor, as they do: under some a robot vacuum cleans, around
//! others it has to drive.

use super::{CELL, piece::Piece};
use crate::rng::Rng;
use rand::RngExt;

fn metres(cells: i32) -> f64 {
    f64::from(cells) * CELL
}

/// A body on four legs, or flush on the floor.
fn on_legs(piece: Piece, edges: [i32; 4], legs: f64, rng: &mut Rng) -> Piece {
    if rng.random_bool(legs) { piece.legs(edges, rng.random_range(0.015..0.035)) } else { piece.solid(edges) }
}

/// Bed with up to two bedside tables.
pub(super) fn double_bed(rng: &mut Rng) -> Piece {
    let (wide, long) = (rng.random_range(28..=38), rng.random_range(40..=44));
    let tables = rng.random_range(0..3);
    let left = if tables == 2 { 9 } else { 0 };
    let piece = on_legs(Piece::new(wide + 9 * tables, long), [left, 0, left + wide, long], 0.5, rng).front(10);
    let piece = if tables > 0 { piece.solid([left + wide + 1, 0, left + wide + 9, 8]) } else { piece };
    if tables == 2 { piece.solid([0, 0, 8, 8]) } else { piece }
}

/// Bed for one, with its long side at the wall.
pub(super) fn single_bed(rng: &mut Rng) -> Piece {
    let (wide, long) = (rng.random_range(18..=22), rng.random_range(38..=42));
    on_legs(Piece::new(long, wide), [0, 0, long, wide], 0.5, rng).front(10)
}

/// Sofa, with a chaise longue or without, and what stands before it.
pub(super) fn sofa(rng: &mut Rng) -> Piece {
    let (wide, deep) = (rng.random_range(32..=50), rng.random_range(16..=20));
    let (gap, table) = (rng.random_range(7..=10), (rng.random_range(14..=24), rng.random_range(9..=14)));
    let chaise = wide >= 44 && rng.random_bool(0.5);
    let left = if chaise { (wide + 14 - table.0) / 2 } else { (wide - table.0) / 2 };
    let left = left.min(wide - table.0);
    let near = deep + gap;
    let far = near + table.1;
    let piece = on_legs(Piece::new(wide, far), [0, 0, wide, deep], 0.35, rng);
    let piece = if chaise { piece.solid([0, deep, 14.min(left - 4).max(1), deep + 14]) } else { piece };
    let piece = on_legs(piece, [left, near, left + table.0, far], 0.7, rng);
    if rng.random_bool(0.6) {
        piece.rug([left.max(4) - 4, near - 4, (left + table.0 + 4).min(wide), far])
    } else {
        piece
    }
}

/// Sideboard or television bench.
pub(super) fn sideboard(rng: &mut Rng) -> Piece {
    let (wide, deep) = (rng.random_range(22..=40), rng.random_range(8..=10));
    on_legs(Piece::new(wide, deep), [0, 0, wide, deep], 0.3, rng).front(10)
}

pub(super) fn bookcase(rng: &mut Rng) -> Piece {
    Piece::block(rng.random_range(12..=36), rng.random_range(6..=8)).front(10)
}

/// Armchair that stands at an angle.
pub(super) fn armchair(rng: &mut Rng) -> Piece {
    let (side, angle) = (rng.random_range(0.6..0.78), rng.random_range(-0.6..0.6));
    let piece = Piece::new(22, 22);
    if rng.random_bool(0.5) { piece.turned((0.55, 0.55), side, angle) } else { piece.chair((0.55, 0.55), side, angle) }
}

/// Table with chairs at its long sides, as they were left.
pub(super) fn dining_table(rng: &mut Rng) -> Piece {
    let (wide, deep) = (rng.random_range(22..=42), rng.random_range(14..=20));
    let (near, far) = (9, 9 + deep);
    let mut piece = Piece::new(wide, deep + 18);
    piece = match rng.random_range(0..4) {
        0 => piece.round(metres(wide) / 2.0, metres(near + far) / 2.0, rng.random_range(0.08..0.25)),
        _ => piece.legs([0, near, wide, far], rng.random_range(0.02..0.04)),
    };
    let seats = if wide >= 36 { 3 } else { 2 };
    for (v, out) in [(metres(near), -1.0), (metres(far), 1.0)] {
        for seat in 0..seats {
            if rng.random_bool(0.1) {
                continue;
            }
            let u = metres(wide) * (f64::from(seat) + 0.5) / f64::from(seats) + rng.random_range(-0.05..0.05);
            let pulled = rng.random_range(-0.1..0.14);
            piece = piece.chair((u, v + out * pulled), rng.random_range(0.38..0.46), rng.random_range(-0.25..0.25));
        }
    }
    piece
}

/// Small table with a chair or two at the wall.
pub(super) fn breakfast_table(rng: &mut Rng) -> Piece {
    let (wide, deep) = (rng.random_range(14..=20), rng.random_range(13..=16));
    let mut piece = Piece::new(wide + 16, deep).legs([8, 0, 8 + wide, deep], 0.025);
    for u in [metres(7), metres(9 + wide)] {
        if rng.random_bool(0.8) {
            piece = piece.chair((u, 0.5 * metres(deep)), rng.random_range(0.38..0.44), rng.random_range(-0.3..0.3));
        }
    }
    piece
}

/// Desk on a drawer unit and a panel, with an office chair on its star base.
pub(super) fn desk(rng: &mut Rng) -> Piece {
    let (wide, deep) = (rng.random_range(22..=32), rng.random_range(12..=16));
    let piece = Piece::new(wide, deep + 8);
    let piece = match rng.random_range(0..3) {
        0 => piece.legs([0, 0, wide, deep], 0.025),
        1 => piece.solid([0, 0, 8, deep]).solid([wide - 1, 0, wide, deep]),
        _ => piece.solid([0, 0, 1, deep]).solid([wide - 8, 0, wide, deep]),
    };
    let u = 0.5 * metres(wide) + rng.random_range(-0.1..0.1);
    piece.round(u, metres(deep) + rng.random_range(-0.05..0.1), rng.random_range(0.2..0.28))
}

pub(super) fn wardrobe(rng: &mut Rng) -> Piece {
    Piece::block(rng.random_range(20..=50), rng.random_range(11..=13)).front(12)
}

pub(super) fn chest_of_drawers(rng: &mut Rng) -> Piece {
    Piece::block(rng.random_range(12..=26), rng.random_range(8..=10)).front(10)
}

/// A chair for clothes, or a stool.
pub(super) fn chair(rng: &mut Rng) -> Piece {
    Piece::new(12, 12).chair((0.3, 0.3), rng.random_range(0.36..0.46), rng.random_range(-0.5..0.5))
}

/// Plant, standard lamp, umbrella stand, bin or laundry basket.
pub(super) fn round_thing(rng: &mut Rng) -> Piece {
    let radius = rng.random_range(0.08..0.2);
    Piece::new(8, 8).round(0.2, 0.2, radius)
}

/// A toy, shoe or bag on the floor.
pub(super) fn thing_on_floor(rng: &mut Rng) -> Piece {
    let piece = Piece::new(6, 6);
    if rng.random_bool(0.5) {
        piece.round(0.15, 0.15, rng.random_range(0.03..0.1))
    } else {
        piece.turned((0.15, 0.15), rng.random_range(0.06..0.2), rng.random_range(0.0..1.5))
    }
}

/// Worktop with what is built in under it.
pub(super) fn worktop(rng: &mut Rng) -> Piece {
    Piece::block(rng.random_range(36..=72), 12).front(14)
}

pub(super) fn fridge(rng: &mut Rng) -> Piece {
    Piece::block(rng.random_range(12..=14), 13).front(12)
}

/// Kitchen island with stools.
pub(super) fn island(rng: &mut Rng) -> Piece {
    let (wide, deep) = (rng.random_range(28..=44), rng.random_range(14..=18));
    let mut piece = Piece::new(wide, deep + 8).solid([0, 0, wide, deep]);
    for seat in 0..rng.random_range(0..3) {
        let u = metres(wide) * (f64::from(seat) + 1.0) / 3.0;
        piece = piece.round(u, metres(deep) + 0.2, rng.random_range(0.12..0.2));
    }
    piece
}

pub(super) fn tub(rng: &mut Rng) -> Piece {
    Piece::block(rng.random_range(30..=36), rng.random_range(14..=16))
}

pub(super) fn shower(rng: &mut Rng) -> Piece {
    let side = rng.random_range(16..=20);
    Piece::block(side, side)
}

/// Cistern and bowl.
pub(super) fn toilet(rng: &mut Rng) -> Piece {
    Piece::new(8, 12).solid([0, 0, 8, 4]).round(0.2, rng.random_range(0.34..0.4), 0.18).front(8)
}

/// Basin on a cabinet or on a foot.
pub(super) fn basin(rng: &mut Rng) -> Piece {
    if rng.random_bool(0.6) {
        Piece::block(rng.random_range(10..=22), rng.random_range(8..=10)).front(8)
    } else {
        Piece::new(10, 8).round(0.25, 0.15, 0.1).front(8)
    }
}

pub(super) fn washing_machine(_: &mut Rng) -> Piece {
    Piece::block(12, 12).front(10)
}

/// Shelves of a closet or boxes in it.
pub(super) fn shelves(rng: &mut Rng) -> Piece {
    Piece::block(rng.random_range(10..=30), rng.random_range(6..=10))
}

pub(super) fn shoe_rack(rng: &mut Rng) -> Piece {
    Piece::block(rng.random_range(12..=24), rng.random_range(5..=7))
}

/// A rug by itself.
pub(super) fn rug(rng: &mut Rng) -> Piece {
    let (wide, deep) = (rng.random_range(16..=44), rng.random_range(12..=32));
    Piece::new(wide, deep).rug([0, 0, wide, deep])
}

/// Part of a wall: a chimney breast or a duct.
pub(super) fn duct(rng: &mut Rng) -> Piece {
    Piece::block(rng.random_range(6..=14), rng.random_range(5..=9))
}
