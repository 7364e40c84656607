//! `robovac twin` and `robovac simulate --twin`, with a recording that is made here.

use std::{fmt::Write, fs, path::PathBuf, process::Command};

fn robovac(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_robovac")).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn place(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// A robot in Safe mode that starts and stops, with 1.2 m/s² and 98 % of the commanded speed.
fn drive(seconds: f64) -> String {
    let mut text = "robovac-oi-recording 1\n0.0 ! open\n0.5 > 80 8E 23\n0.52 < 01\n0.55 > 83\n".to_owned();
    let (mut at, mut speed, mut way) = (0.6, 0.0_f64, 0.0);
    for step in 0..(seconds / 0.015) as usize {
        let wanted = [0.0, 300.0, 0.0, -300.0][step / 100 % 4];
        if step % 100 == 0 {
            let [high, low] = (wanted as i16).to_be_bytes();
            writeln!(text, "{at:.4} > 91 {high:02X} {low:02X} {high:02X} {low:02X}").unwrap();
        }
        at += 0.015;
        way += 0.98 * speed * 0.015 / 0.444_565;
        speed += (wanted - speed).clamp(-18.0, 18.0);
        // Group 100: mode, requested speeds, counts.
        let ([high, low], counts) = ((wanted as i16).to_be_bytes(), (way as i32 as u16).to_be_bytes());
        let mut frame = vec![0; 83];
        frame[..3].copy_from_slice(&[19, 81, 100]);
        frame[43] = 2;
        frame[51..59].copy_from_slice(&[high, low, high, low, counts[0], counts[1], counts[0], counts[1]]);
        frame.push(frame.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte)).wrapping_neg());
        let bytes: Vec<String> = frame.iter().map(|byte| format!("{byte:02X}")).collect();
        writeln!(text, "{at:.4} < {}", bytes.join(" ")).unwrap();
    }
    text
}

#[test]
fn a_twin_is_told_checked_kept_and_simulated() {
    let [first, second, twin] = ["twin-first.txt", "twin-second.txt", "twin.json"].map(place);
    fs::write(&first, drive(30.0)).unwrap();
    fs::write(&second, drive(20.0)).unwrap();
    let [first, second, twin] = [&first, &second, &twin].map(|path| path.to_str().unwrap());
    let (code, told, error) = robovac(&["twin", first, "--check", second, "--json", twin]);
    assert_eq!((code, &*error), (Some(0), ""));
    for words in [
        "Wheel base                   235.0 mm",
        "turn was seen",
        "no full turn was seen",
        "after a second",
        "twin=speed:0.9",
    ] {
        assert!(told.contains(words), "{words}: {told}");
    }
    let base = ["simulate", "--room", "empty", "--behaviour", "bounce", "--max-time", "20"];
    let (code, simulated, error) = robovac(&[&base[..], &["--twin", twin]].concat());
    assert_eq!((code, &*error), (Some(0), ""));
    assert!(simulated.contains("Twin of your Roomba") && simulated != robovac(&base).1, "{simulated}");
    let (code, _, error) = robovac(&[&base[..], &["--twin", first]].concat());
    assert!(code == Some(2) && error.contains("not a twin"), "{error}");
}

#[test]
fn a_recording_that_is_too_short_is_refused_with_its_name() {
    let short = place("twin-short.txt");
    fs::write(&short, drive(3.0)).unwrap();
    let (code, told, error) = robovac(&["twin", short.to_str().unwrap()]);
    assert!(
        code == Some(2) && told.is_empty() && error.contains("twin-short.txt: the recording covers 3 s"),
        "{error}"
    );
}
