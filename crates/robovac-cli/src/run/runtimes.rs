//! The runtimes of users' programs, which this program carries: the Python package and the node runner.

/// A file of `programs/`, with its path there.
macro_rules! file {
    ($path:literal) => {
        ($path, include_str!(concat!("../../../../programs/", $path)))
    };
}

/// For Python.
pub const PYTHON: &[(&str, &str)] = &[
    file!("python/irobot_edu_sdk/__init__.py"),
    file!("python/irobot_edu_sdk/backend/__init__.py"),
    file!("python/irobot_edu_sdk/backend/bluetooth.py"),
    file!("python/irobot_edu_sdk/backend/serial.py"),
    file!("python/irobot_edu_sdk/backend/usb.py"),
    file!("python/irobot_edu_sdk/color.py"),
    file!("python/irobot_edu_sdk/create3.py"),
    file!("python/irobot_edu_sdk/event.py"),
    file!("python/irobot_edu_sdk/getter_types.py"),
    file!("python/irobot_edu_sdk/music.py"),
    file!("python/irobot_edu_sdk/robot.py"),
    file!("python/irobot_edu_sdk/robots.py"),
    file!("python/irobot_edu_sdk/root.py"),
    file!("python/irobot_edu_sdk/utils.py"),
    file!("python/robovac_program/__init__.py"),
    file!("python/robovac_program/__main__.py"),
    file!("python/robovac_program/chance.py"),
    file!("python/robovac_program/frames.py"),
    file!("python/robovac_program/motions.py"),
    file!("python/robovac_program/native.py"),
    file!("python/robovac_program/page.py"),
    file!("python/robovac_program/program.py"),
    file!("python/robovac_program/robot.py"),
    file!("python/robovac_program/room.py"),
    file!("python/robovac_program/words.py"),
];

/// For JavaScript: modules, as `package.json` says.
pub const JAVASCRIPT: &[(&str, &str)] = &[
    ("javascript/package.json", "{\"type\": \"module\"}\n"),
    file!("javascript/chance.js"),
    file!("javascript/frames.js"),
    file!("javascript/javascript.js"),
    file!("javascript/layout.js"),
    file!("javascript/motions.js"),
    file!("javascript/node.js"),
    file!("javascript/readings.js"),
    file!("javascript/robot.js"),
    file!("javascript/room.js"),
    file!("javascript/trace-javascript.js"),
    file!("javascript/words.js"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::{fs, path::Path};

    fn files(folder: &Path, ending: &str, found: &mut Vec<String>) {
        for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            let name = entry.to_string_lossy().into_owned();
            if entry.is_dir() && !name.ends_with("__pycache__") {
                files(&entry, ending, found);
            } else if name.ends_with(ending) {
                found.push(name);
            }
        }
    }

    #[test]
    fn all_of_the_python_package_is_carried_and_modules_find_what_they_import() {
        let programs = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../programs"));
        let mut found = Vec::new();
        files(&programs.join("python"), ".py", &mut found);
        assert_eq!(found.len(), PYTHON.len(), "a file was added or removed: list it above");
        for (name, text) in JAVASCRIPT {
            for import in text.lines().filter(|line| line.starts_with("import ")) {
                let Some((_, module)) = import.split_once("from \"./") else { continue };
                let module = format!("javascript/{}", module.trim_end_matches([';', '"']));
                assert!(JAVASCRIPT.iter().any(|(other, _)| *other == module), "{name} imports {module}");
            }
        }
    }
}
