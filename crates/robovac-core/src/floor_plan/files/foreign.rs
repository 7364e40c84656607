//! Files of other kinds, with how to make a floor plan of them.

/// All kinds of files that are taken as floor plans, for messages.
pub const TAKEN: &str = "Accepted formats: drawings (DXF, SVG, GeoJSON), images (PNG, JPEG, WebP, PGM), ROS maps (YAML with its \
                         image), text maps of # and ., and saved scenarios (JSON)";

/// A kind of file that isn't taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ForeignFile {
    /// Its name, e.g. "a PDF document".
    pub kind: &'static str,
    /// How to convert it.
    pub remedy: &'static str,
}

const AS_PNG: &str = "save it as PNG";

/// First bytes of common kinds of files.
const MAGIC: &[(&[u8], ForeignFile)] = &[
    (b"\xff\xd8\xff", ForeignFile { kind: "a JPEG image", remedy: "this program can't decode it; save it as PNG" }),
    (b"GIF8", ForeignFile { kind: "a GIF image", remedy: AS_PNG }),
    (b"BM", ForeignFile { kind: "a BMP image", remedy: AS_PNG }),
    (b"II*\0", ForeignFile { kind: "a TIFF image", remedy: AS_PNG }),
    (b"MM\0*", ForeignFile { kind: "a TIFF image", remedy: AS_PNG }),
    (b"P7", ForeignFile { kind: "a PAM image", remedy: AS_PNG }),
    (
        b"%PDF",
        ForeignFile {
            kind: "a PDF document",
            remedy: "export its page as SVG (Inkscape opens PDFs; or run \"pdftocairo -svg plan.pdf plan.svg\"), or as \
                     a PNG image",
        },
    ),
    (b"PK\x03\x04", ForeignFile { kind: "a ZIP archive", remedy: "unpack it and choose the floor plan inside" }),
    (b"Rar!", ForeignFile { kind: "a RAR archive", remedy: "unpack it and choose the floor plan inside" }),
    (b"7z\xbc\xaf", ForeignFile { kind: "a 7z archive", remedy: "unpack it and choose the floor plan inside" }),
    (b"\x1f\x8b", ForeignFile { kind: "a gzip archive", remedy: "unpack it and choose the floor plan inside" }),
    (
        b"AC10",
        ForeignFile {
            kind: "a DWG drawing, AutoCAD's own format",
            remedy: "save it as DXF in the CAD program, or convert it with LibreDWG (\"dwg2dxf plan.dwg\")",
        },
    ),
    (b"<", ForeignFile { kind: "a web page or an unknown kind of XML", remedy: "choose the drawing itself" }),
];

/// Names of files within documents, which are ZIP archives, and which no archive of floor plans has.
const DOCUMENTS: &[(&[u8], &str)] = &[
    (b"word/document.xml", "a Word document"),
    (b"ppt/presentation.xml", "a PowerPoint presentation"),
    (b"xl/workbook.xml", "an Excel workbook"),
    (b"vnd.oasis.opendocument", "an OpenDocument file"),
];

/// Brands of HEIF files: those of cameras, and of AVIF.
const HEIC: [&[u8]; 6] = [b"heic", b"heix", b"hevc", b"mif1", b"msf1", b"heim"];

/// The kind of a file that isn't taken, by its first bytes.
///
/// ```
/// use robovac_core::floor_plan::foreign;
/// assert_eq!(foreign(b"%PDF-1.7").unwrap().kind, "a PDF document");
/// assert_eq!(foreign(b"\0\0\0\x18ftypheic").unwrap().kind, "a HEIC photograph");
/// assert_eq!(foreign(b"####\n#..#\n"), None);
/// ```
pub fn foreign(bytes: &[u8]) -> Option<ForeignFile> {
    if bytes.get(4..8) == Some(b"ftyp") {
        let brand = bytes.get(8..12).unwrap_or_default();
        return Some(if HEIC.contains(&brand) {
            ForeignFile {
                kind: "a HEIC photograph",
                remedy: "export it as JPEG (on a Mac in Preview; on an iPhone, choose Settings > Camera > Formats > \
                         Most Compatible before you take it)",
            }
        } else if brand.starts_with(b"avi") {
            ForeignFile { kind: "an AVIF image", remedy: AS_PNG }
        } else {
            ForeignFile { kind: "a film", remedy: "choose a picture of the floor plan" }
        });
    }
    if bytes.starts_with(b"RIFF") {
        let is_webp = bytes.get(8..12) == Some(b"WEBP");
        return Some(if is_webp {
            ForeignFile { kind: "a WebP image", remedy: "this program can't decode it; save it as PNG" }
        } else {
            ForeignFile { kind: "a sound or a film", remedy: "choose a picture of the floor plan" }
        });
    }
    if bytes.starts_with(b"PK\x03\x04") {
        let has = |name: &[u8]| bytes.windows(name.len()).any(|part| part == name);
        if let Some(&(_, kind)) = DOCUMENTS.iter().find(|(name, _)| has(name)) {
            return Some(ForeignFile { kind, remedy: "save the picture in it as PNG and choose that" });
        }
    }
    MAGIC.iter().find(|(magic, _)| bytes.starts_with(magic)).map(|&(_, foreign)| foreign)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_says_how_to_go_on() {
        for (magic, _) in MAGIC {
            let found = foreign(magic).unwrap();
            assert!(found.remedy.len() >= AS_PNG.len() && !found.kind.is_empty(), "{found:?}");
        }
        let heic = foreign(b"\0\0\0\x18ftypmif1").unwrap();
        assert!(heic.remedy.contains("JPEG"));
        assert!(foreign(b"PK\x03\x04").unwrap().remedy.contains("unpack"));
        for (name, kind) in DOCUMENTS {
            let found = foreign(&[b"PK\x03\x04[Content_Types].xml".as_slice(), name, b"..."].concat()).unwrap();
            assert!(found.kind == *kind && found.remedy.contains("PNG"), "{found:?}");
        }
    }

    #[test]
    fn all_formats_are_named() {
        for format in ["DXF", "SVG", "GeoJSON", "PNG", "JPEG", "WebP", "PGM", "YAML", "text maps", "JSON"] {
            assert!(TAKEN.contains(format), "{format}");
        }
    }
}
