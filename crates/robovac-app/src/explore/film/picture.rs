//! One picture of a film.

use robovac_core::{geometry::Point, grid::Cell};

/// Kind of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilmInk {
    /// A path.
    Path,
    /// A new part of a path.
    New,
    /// A part of a path that is taken apart, by its number.
    Part(usize),
}

/// What is drawn, with its caption.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FilmPicture {
    /// Lines, m, the later ones above the earlier.
    pub lines: Vec<(FilmInk, Vec<Point>)>,
    /// Cells where the path changes.
    pub tinted: Vec<Cell>,
    /// Its caption, which sets for how long it is shown.
    pub text: String,
}

impl FilmPicture {
    /// Lines and cells as numbers: for each line its ink, its number of points and x, y, ...; then x, y, ... of the cells after -1.
    pub fn numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        for (ink, points) in &self.lines {
            let ink = match ink {
                FilmInk::Path => 0,
                FilmInk::New => 1,
                FilmInk::Part(number) => 2 + number,
            };
            numbers.extend([ink as f64, points.len() as f64]);
            numbers.extend(points.iter().flat_map(|point| [point.x, point.y]));
        }
        numbers.push(-1.0);
        numbers.extend(self.tinted.iter().flat_map(|cell| [f64::from(cell.x), f64::from(cell.y)]));
        numbers
    }

    /// The inverse of [`FilmPicture::numbers`].
    pub fn of_numbers(numbers: &[f64], text: String) -> Self {
        let (mut picture, mut rest) = (Self { text, ..Self::default() }, numbers);
        while let [ink, count, points @ ..] = rest
            && *ink >= 0.0
        {
            let (points, others) = points.split_at(points.len().min(2 * *count as usize));
            let ink = match *ink as usize {
                0 => FilmInk::Path,
                1 => FilmInk::New,
                part => FilmInk::Part(part - 2),
            };
            picture.lines.push((ink, points.as_chunks().0.iter().map(|&[x, y]| Point::new(x, y)).collect()));
            rest = others;
        }
        let cells = rest.get(1..).unwrap_or_default().as_chunks().0;
        picture.tinted = cells.iter().map(|&[x, y]| Cell::new(x as i32, y as i32)).collect();
        picture
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_give_the_picture_back() {
        let points = vec![Point::new(-0.5, 1.25), Point::new(2.0, 0.0)];
        let lines = vec![(FilmInk::Path, points.clone()), (FilmInk::New, Vec::new()), (FilmInk::Part(3), points)];
        let picture = FilmPicture { lines, tinted: vec![Cell::new(0, 7), Cell::new(3, 2)], text: "So.".to_owned() };
        assert_eq!(FilmPicture::of_numbers(&picture.numbers(), "So.".to_owned()), picture);
        for broken in [&[][..], &[0.0], &[0.0, 9.0, 1.0], &[-1.0], &[-1.0, 3.0], &[1.0, f64::NAN, -1.0]] {
            FilmPicture::of_numbers(broken, String::new());
        }
        assert_eq!(FilmPicture::of_numbers(&FilmPicture::default().numbers(), String::new()), FilmPicture::default());
    }
}
