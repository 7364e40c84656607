//! Execution of commands.
//!
//! [`Mode::after_command`] defines which mode allows which command, and the mode after it; others are ignored, with
//! their data. The effect of values out of range isn't documented. Here **amounts** are brought into their range -
//! speeds, radii, duty cycles - while a command with a **name** that means nothing is ignored as a whole: a baud code
//! above 11, a song above 3 or without or with more than 16 notes, a packet that doesn't exist (lists: only that one),
//! a state of the stream other than 0 and 1, a character that isn't printable, a time that no clock shows.
//!
//! Also undocumented, and decided here:
//! - Start in Safe and Full stops the wheels and brushes, as every way into Passive or Off does.
//! - Safe and Full end a built-in program. Wheels and brushes keep running between Full and Safe.
//! - Start and Stop don't end a built-in program, which doesn't depend on the interface.
//! - Packets 39 to 42 are 0 again after a stop by mode.

use super::{
    builtin_program::Chore,
    clock::Nanos,
    machine::Machine,
    motion::{Brushes, Told},
    power::PowerState,
    report::Stream,
    sound,
};
use roomba_oi::{BAUD_RATES, Buttons, Command, Mode};

impl Machine {
    /// Takes a command; returns whether the robot accepted it.
    pub fn obey(&mut self, command: Command<'_>) -> bool {
        let command = command.clamped();
        let is_list = matches!(command, Command::Stream { .. } | Command::QueryList { .. });
        let Some(mode) = self.mode.after_command(command.opcode()) else { return false };
        if !is_list && command.check().is_err() {
            return false;
        }
        self.active = self.now;
        match command {
            Command::Reset => self.boot(),
            Command::Stop => {
                self.report();
                self.sound.sound(sound::BYE);
                self.enter(mode);
            }
            Command::Start => {
                if self.mode == Mode::Off {
                    self.sound.sound(sound::HELLO);
                }
                self.enter(mode);
            }
            Command::Safe | Command::Control => {
                self.enter(mode);
                self.lights = super::lights::Lights::default();
            }
            Command::Full => self.enter(mode),
            Command::Power => {
                self.enter(mode);
                self.builtin_program = None;
                self.fall_asleep();
            }
            Command::Clean | Command::Spot | Command::Max | Command::SeekDock => {
                self.enter(mode);
                self.ask(match command {
                    Command::Spot => Chore::Spot,
                    Command::Max => Chore::Max,
                    Command::SeekDock => Chore::Dock,
                    _ => Chore::Clean,
                });
            }
            other => self.act(other),
        }
        true
    }

    /// Executes a command that doesn't change the mode.
    fn act(&mut self, command: Command<'_>) {
        if self.told.take(command) || self.lights.take(command) {
            return;
        }
        match command {
            Command::Baud { code } => {
                if let Some(&baud) = BAUD_RATES.get(usize::from(code)) {
                    self.line.set_baud(self.now, baud);
                }
            }
            Command::Motors(motors) => self.brushes = Brushes::of_motors(motors),
            Command::PwmMotors { main_brush, side_brush, vacuum } => {
                self.brushes = Brushes::of_pwm(main_brush, side_brush, vacuum);
            }
            Command::Song { number, notes } => self.sound.store(number, notes),
            Command::Play { number } => self.sound.play(self.now, number),
            Command::SensorReadings { packet } => self.asked.push(packet),
            Command::QueryList { packets } => self.asked.extend(packets),
            Command::Stream { packets } => {
                let packets = packets.iter().filter_map(|&id| self.packet(id)).collect();
                self.stream = Stream { packets, is_paused: false };
            }
            Command::PauseResume { state } => self.stream.is_paused = state == 0,
            Command::Buttons(buttons) => self.push(buttons),
            Command::Schedule { days, times } => {
                let held = self.buttons();
                if !held.schedule && !held.clock {
                    self.calendar.set_schedule(days, times);
                }
            }
            Command::DayTime { day, time } => self.calendar.set_clock(self.now, day, time),
            _ => {}
        }
    }

    /// Changes the mode, with all consequences.
    pub fn enter(&mut self, mode: Mode) {
        let before = core::mem::replace(&mut self.mode, mode);
        match (before >= Mode::Safe, mode >= Mode::Safe) {
            (true, false) => {
                self.told = Told::default();
                self.brushes = Brushes::default();
                self.active = self.now;
            }
            (false, true) => {
                // Lights set by the robot itself stay on in Full until commanded otherwise.
                self.lights = super::lights::Lights::of(self.condition());
                self.builtin_program = None;
                self.is_in_trouble = false;
            }
            _ => {}
        }
        if mode == Mode::Off {
            self.asked.clear();
            self.stream = Stream::default();
        }
    }

    /// Effect of buttons, pressed by hand or by opcode 165: each starts a built-in program. No effect in Safe and Full,
    /// which only report them (packet 18).
    pub fn push(&mut self, buttons: Buttons) {
        self.hold(buttons);
        self.active = self.now;
        if self.mode >= Mode::Safe {
            return;
        }
        let chores = [(buttons.clean, Chore::Clean), (buttons.spot, Chore::Spot), (buttons.dock, Chore::Dock)];
        if let Some(&(_, chore)) = chores.iter().find(|(is_pressed, _)| *is_pressed) {
            self.ask(chore);
        }
    }

    /// Starts a built-in program, or pauses the present one: Clean, Spot and Max pause each other, as their buttons do,
    /// and the same button continues. Seek Dock replaces any program; a second press pauses it as well.
    pub fn ask(&mut self, chore: Chore) {
        self.is_in_trouble = false;
        let goes_home_from_cleaning = |builtin_program: &super::builtin_program::BuiltinProgram| {
            chore == Chore::Dock && builtin_program.chore != Chore::Dock
        };
        match &mut self.builtin_program {
            Some(builtin_program) if !builtin_program.is_paused && !goes_home_from_cleaning(builtin_program) => {
                builtin_program.is_paused = true;
            }
            Some(builtin_program) if builtin_program.is_paused && builtin_program.chore == chore => {
                builtin_program.is_paused = false;
            }
            _ => self.begin(chore),
        }
    }

    /// Starts a built-in program, unless a charger is plugged in or a wheel is dropped.
    pub fn begin(&mut self, chore: Chore) {
        use robovac_core::robot::RobotPort;
        if self.charger.is_plugged || self.robot.sensors().wheel_dropped() {
            self.trouble();
            return;
        }
        self.builtin_programs += 1;
        let (robot, seed) = self.builtin_program_setup();
        self.builtin_program = super::builtin_program::BuiltinProgram::new(chore, robot, seed, self.charger.on_dock);
        self.sound.sound(sound::BEGINS);
    }

    /// Checks the present program.
    pub fn go_on(&mut self) {
        let Some(builtin_program) = &self.builtin_program else { return };
        if !builtin_program.is_paused {
            self.active = self.now;
        }
        if builtin_program.is_done() {
            let goes_home = builtin_program.goes_home;
            self.builtin_program = None;
            if goes_home { self.begin(Chore::Dock) } else { self.sound.sound(sound::DONE) }
        }
    }

    /// Ends the program with the tune for trouble.
    pub fn trouble(&mut self) {
        self.is_in_trouble = true;
        self.sound.sound(sound::TROUBLE);
    }

    /// Buttons pressed by hand.
    pub fn press(&mut self, buttons: Buttons) {
        match self.power {
            PowerState::Awake => self.push(buttons),
            PowerState::Asleep(since) if buttons.clean => self.wake(self.now - since, true),
            _ => {}
        }
    }

    /// Logs the time asleep, and wakes up.
    pub fn wake(&mut self, slept: Nanos, by_button: bool) {
        self.power = PowerState::Awake;
        self.active = self.now;
        if self.who.tells_of_sleep {
            self.line.send(self.now, super::power::woken(slept, by_button).as_bytes());
        }
    }
}
