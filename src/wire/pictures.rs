//! Pictures of a film from a worker: caption and numbers of each in turn.

use js_sys::{Array, Float64Array};
use robovac_app::explore::FilmPicture;

/// Caption, numbers, caption, numbers, ... as of [`FilmPicture::numbers`].
pub fn pictures_to_js(pictures: &[FilmPicture]) -> Array {
    let film = Array::new();
    for picture in pictures {
        film.push(&picture.text.as_str().into());
        film.push(&Float64Array::from(picture.numbers().as_slice()));
    }
    film
}

/// The inverse of [`pictures_to_js`].
pub fn pictures_from_js(film: &Array) -> Vec<FilmPicture> {
    let picture = |at: u32| {
        let text = film.get(at).as_string().unwrap_or_default();
        FilmPicture::of_numbers(&Float64Array::new(&film.get(at + 1)).to_vec(), text)
    };
    (0..film.length()).step_by(2).map(picture).collect()
}
