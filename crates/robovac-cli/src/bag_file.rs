//! `--mcap`: a file with ROS 2 messages.

use super::failure::Failure;
use robovac_ros::{Bag, Stamped};
use std::{
    fs::File,
    io::BufWriter,
    path::{Path, PathBuf},
};

/// A bag being written to a file.
pub struct BagFile {
    path: PathBuf,
    bag: Bag<BufWriter<File>>,
}

impl BagFile {
    pub fn create(path: &Path) -> Result<Self, Failure> {
        let file = File::create(path).map_err(|e| Failure::io(path.display(), &e))?;
        let bag = Bag::new(BufWriter::new(file), "").map_err(|e| Failure::bag(path, e))?;
        Ok(Self { path: path.to_owned(), bag })
    }

    pub fn put_all(&mut self, messages: impl IntoIterator<Item = Stamped>) -> Result<(), Failure> {
        self.bag.put_all(messages).map_err(|e| Failure::bag(&self.path, e))
    }

    pub fn finish(self) -> Result<(), Failure> {
        let Self { path, bag } = self;
        bag.finish().map(drop).map_err(|e| Failure::bag(&path, e))
    }
}
