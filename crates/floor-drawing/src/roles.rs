//! Role of a layer, guessed from its name.

use super::Role;

/// Words in names of layers that don't obstruct the robot: annotations, openings and dimensions. With those of paths
/// that this program writes, so that they don't come back as walls.
const IGNORED: &[&str] = &[
    // English, and the abbreviations of the AIA CAD layer guidelines
    "TEXT",
    "DIM",
    "ANNO",
    "NOTE",
    "HATCH",
    "PATT",
    "DOOR",
    "TITLE",
    "FRAME",
    "BORDER",
    "GRID",
    "AXIS",
    "AXES",
    "LABEL",
    "LEGEND",
    "BACKGROUND",
    "PAGE=",
    "PAPER=",
    "SHEET=",
    "LOGO",
    "WATERMARK",
    "DEFPOINTS",
    "VIEWPORT",
    "VPORT",
    "CENTER",
    "CENTRE",
    "SYMB",
    "ELEC",
    "LIGHT",
    "LITE",
    "CEIL",
    "CLNG",
    "ROOF",
    "IDEN",
    "AREA",
    "SWEEP",
    "PATH",
    "ROBOVAC", // German
    "BEMA",
    "MASSE",
    "SCHRAFF",
    "BESCHRIFT",
    "TÜR",
    "TUER",
    "ACHS",
    "RASTER",
    "RAHMEN",
    "PLANKOPF",
    "SCHRIFTFELD",
    "SCHRIFTKOPF",
    "TITELBLOCK",
    "TITELFELD",
    "HINTERGRUND",
    "BLATT=",
    "NORDPFEIL",
    "ELEKTRO",
    "DECKE", // French
    "COTE",
    "COTATION",
    "HACHUR",
    "TEXTE",
    "PORTE=",
    "PORTES=",
    "CARTOUCHE",
    "CADRE",
    "ARRIÈRE",
    "ARRIERE",
    "FEUILLE",
    "AXE=", // Spanish, Portuguese, Italian
    "COTA",
    "SOMBREADO",
    "PUERTA",
    "PORTA",
    "QUOT",
    "TESTO",
    "RETINO",
    "CAMPITURA",
    "EJE",
    "EIXO",
    "ASSI",
    "CAJETIN",
    "CAJETÍN",
    "FONDO=",
    "MARCO=",
    "CARIMBO",
    "CARTIGLIO",
    "SQUADRATURA",
    // Dutch, Scandinavian, Polish, Czech
    "MAAT",
    "ARCERING",
    "DEUR",
    "DÖRR",
    "MÅTT",
    "WYMIAR",
    "DRZWI",
    "KRESKOW",
    "DVEŘ",
    "KÓTY",
    // Russian, Chinese, Japanese
    "РАЗМЕР",
    "ТЕКСТ",
    "ШТРИХ",
    "ДВЕР",
    "ОСИ",
    "尺寸",
    "文字",
    "标注",
    "門",
    "门",
    "寸法",
    "ハッチ",
    "ドア",
];

/// Words in names of layers with objects on the floor.
const OBSTACLES: &[&str] = &[
    "FURN",
    "OBSTACLE",
    "STAIR",
    "OBST",
    "EQPM",
    "EQUIP",
    "CASE",
    "TABLE",
    "CHAIR",
    "SOFA",
    "SANITARY",
    "FIXT",
    "CABINET",
    "SHELF",
    "RACK",
    "APPL",
    "MACHINE",
    "MÖBEL",
    "MOEBEL",
    "MOBEL",
    "EINRICHT",
    "HINDERNIS",
    "SANITÄR",
    "TISCH",
    "STUHL",
    "SCHRANK",
    "REGAL",
    "MASCHINE",
    "MEUBLE",
    "MOBILIER",
    "MOBILI",
    "ARRED",
    "MUEBLE",
    "MOVEIS",
    "MÓVEIS",
    "MÓVEL",
    "MUEB",
    "MEUBEL",
    "INVENTARIS",
    "MÖBL",
    "MEBL",
    "NÁBYT",
    "NABYT",
    "МЕБЕЛ",
    "ОБОРУД",
    "家具",
    "设备",
];

/// Words in names of layers with walls, needed only where another rule would give another role.
const WALLS: &[&str] = &[
    "WALL",
    "WAND",
    "WÄND",
    "WAEND",
    "MAUER",
    "MUR",
    "CLOISON",
    "PARED",
    "PARET",
    "TABIQUE",
    "MUUR",
    "VÄGG",
    "ŚCIAN",
    "SCIAN",
    "STĚN",
    "ZDI",
    "СТЕН",
    "墙",
    "墻",
    "壁",
    "GLAZ",
    "WIND",
    "FENSTER",
    "COLS",
    "COLUMN",
    "PARTITION",
];

/// Whether a name says that a layer has walls.
pub(super) fn says_wall(name: &str) -> bool {
    let name = name.to_uppercase();
    WALLS.iter().any(|word| name.contains(word))
}

/// Whether a name has a word that says what a layer has. Drawing programs call anything a path, with a number.
pub(super) fn is_known(name: &str) -> bool {
    let is_numbered = name.to_uppercase().starts_with("PATH") && name.contains(|c: char| c.is_ascii_digit());
    !is_numbered && (guess(name) != Role::Wall || says_wall(name))
}

/// Guesses the role of a layer. Names without a known word are taken as walls: an additional obstacle is safer than a
/// missing one.
///
/// A word of up to four letters must begin a part of the name, a longer one can be anywhere in it, and one with an
/// equals sign must be a whole part.
pub(super) fn guess(name: &str) -> Role {
    let name = name.to_uppercase();
    let parts = || name.split(|c: char| !c.is_alphanumeric());
    let has = |words: &[&str]| {
        words.iter().any(|word| {
            if let Some(word) = word.strip_suffix('=') {
                return parts().any(|part| part == word);
            }
            let is_script = !word.is_ascii() && word.chars().all(|c| c as u32 >= 0x2e80);
            if word.chars().count() > 4 || is_script {
                name.contains(word)
            } else {
                parts().any(|part| part.starts_with(word))
            }
        })
    };
    let is_compound_wall = ["WAND", "WALL", "MUUR"].iter().any(|word| parts().any(|part| part.ends_with(word)));
    if has(IGNORED) {
        Role::Ignored
    } else if has(OBSTACLES) && !has(WALLS) && !is_compound_wall {
        Role::Obstacle
    } else {
        Role::Wall
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_many_languages() {
        for name in [
            "0",
            "WALLS",
            "A-WALL-FULL",
            "Aussenwand",
            "Wände tragend",
            "MUR_PORTEUR",
            "Muros",
            "PAREDES",
            "Muur",
            "стены",
            "外壁",
            "S-COLS",
            "A-GLAZ",
            "CASEWALL",
            "outline",
            "Dormitory",
        ] {
            assert_eq!(guess(name), Role::Wall, "{name}");
        }
        for name in [
            "FURNITURE",
            "A-FURN",
            "Möbel",
            "MOEBEL_OG",
            "mobilier",
            "MUEBLES",
            "OBSTACLES",
            "I-EQPM",
            "Мебель",
            "家具",
        ] {
            assert_eq!(guess(name), Role::Obstacle, "{name}");
        }
        for name in [
            "A-ANNO-DIMS",
            "DIM",
            "TEXT",
            "Bemassung",
            "HATCH",
            "A-WALL-PATT",
            "Schraffur",
            "DOORS",
            "A-DOOR",
            "Türen",
            "PORTES",
            "Defpoints",
            "COTES",
            "尺寸",
            "размеры",
            "SWEEP_PATH",
            "FURN-TEXT",
            "PLANKOPF",
            "Hintergrund",
            "Schriftfeld_A3",
            "Titelblock",
            "Background",
            "page 1",
            "Paper",
            "Title block",
            "A-ANNO-TTLB",
            "CARTOUCHE",
            "cajetín",
        ] {
            assert_eq!(guess(name), Role::Ignored, "{name}");
        }
        // Words that contain a short one by coincidence.
        for name in ["Sheetrock", "Radim", "Remote", "Ajourcote"] {
            assert_eq!(guess(name), Role::Wall, "{name}");
        }
    }
}
