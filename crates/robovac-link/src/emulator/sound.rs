//! Songs, and the robot's own tunes.
//!
//! Songs 0 to 3 can be stored and played. A song that isn't stored doesn't play, and while one plays, Play is ignored (as the
//! Create's specification says). What the robot's own tunes sound like is ours.

use super::clock::{Nanos, SECOND};
use roomba_oi::{Note, SONGS};

/// Most tunes kept until they are fetched.
const MOST: usize = 64;

/// The beep of Start in Off.
pub(super) const HELLO: &[Note] = &[[72, 8], [79, 8]];
/// The tune of Stop.
pub(super) const BYE: &[Note] = &[[79, 8], [72, 8]];
/// Falling notes for the change to 19200 baud.
pub(super) const SLOW: &[Note] = &[[84, 8], [79, 8], [76, 8], [72, 16]];
/// Start and end of a built-in program.
pub(super) const BEGINS: &[Note] = &[[76, 8], [84, 8]];
pub(super) const DONE: &[Note] = &[[72, 8], [76, 8], [79, 16]];
/// Trouble.
pub(super) const TROUBLE: &[Note] = &[[60, 16], [55, 32]];

/// State of the loudspeaker.
#[derive(Debug, Clone, Default)]
pub(super) struct Sound {
    songs: [Vec<Note>; SONGS as usize],
    /// The last selected song (packet 36).
    pub number: u8,
    plays_until: Nanos,
    /// Tunes started since the last fetch.
    pub tunes: Vec<Vec<Note>>,
}

impl Sound {
    /// Stores a song.
    pub fn store(&mut self, number: u8, notes: &[Note]) {
        if let Some(song) = self.songs.get_mut(usize::from(number)) {
            *song = notes.to_vec();
        }
    }

    /// Plays a stored song, unless one is playing.
    pub fn play(&mut self, now: Nanos, number: u8) {
        let notes = self.songs.get(usize::from(number)).cloned().unwrap_or_default();
        if notes.is_empty() || self.is_playing(now) {
            return;
        }
        self.number = number;
        let length: Nanos = notes.iter().map(|&[_, duration]| Nanos::from(duration)).sum();
        self.plays_until = now + length * SECOND / 64;
        self.sound(&notes);
    }

    /// Plays one of the robot's own tunes, which packet 37 doesn't report.
    pub fn sound(&mut self, notes: &[Note]) {
        if self.tunes.len() == MOST {
            self.tunes.remove(0);
        }
        self.tunes.push(notes.to_vec());
    }

    /// Whether a song is playing (packet 37).
    pub fn is_playing(&self, now: Nanos) -> bool {
        now < self.plays_until
    }

    /// Clears the songs, as after a power loss.
    pub fn power_down(&mut self) {
        let tunes = core::mem::take(&mut self.tunes);
        *self = Self { tunes, ..Self::default() };
    }
}
