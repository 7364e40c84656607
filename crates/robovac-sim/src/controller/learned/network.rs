//! A small network of neurons, and the text that it is stored as.
//!
//! Lines that begin with `#` are comments. The first other line has the sizes of the layers, from inputs to outputs; then
//! comes a line for each neuron, layer by layer: its bias, then its weights for the neurons of the layer before. Every layer
//! but the last is bent by `x / (1 + |x|)`, which has the same bits on every machine.

use std::fmt;

/// Most neurons of a layer.
const WIDEST: usize = 64;

/// The network.
#[derive(Debug, Clone, PartialEq)]
pub struct Network {
    sizes: Vec<usize>,
    /// In the order of the text.
    weights: Vec<f32>,
}

/// Why a text isn't a network.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NetworkError {
    /// Too few or too large layers.
    #[error("the first line has the sizes of two or more layers, from 1 to {WIDEST}, not \"{0}\"")]
    Sizes(String),
    /// A word that isn't a number.
    #[error("line {line}: \"{word}\" is not a finite number")]
    Number {
        /// Line of the text, from 1.
        line: usize,
        /// The word.
        word: String,
    },
    /// Weights are missing, or there are too many.
    #[error("layers of these sizes need {expected} weights; there are {found}")]
    Count {
        /// How many there are to be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
}

impl Network {
    /// How many weights layers of these sizes need, biases among them.
    pub fn weights_of(sizes: &[usize]) -> usize {
        sizes.windows(2).map(|pair| (pair[0] + 1) * pair[1]).sum()
    }

    /// Layers of these sizes with these weights.
    pub fn new(sizes: &[usize], weights: Vec<f32>) -> Result<Self, NetworkError> {
        if sizes.len() < 2 || sizes.iter().any(|size| !(1..=WIDEST).contains(size)) {
            let words: Vec<_> = sizes.iter().map(usize::to_string).collect();
            return Err(NetworkError::Sizes(words.join(" ")));
        }
        let (expected, found) = (Self::weights_of(sizes), weights.len());
        if expected != found {
            return Err(NetworkError::Count { expected, found });
        }
        Ok(Self { sizes: sizes.to_vec(), weights })
    }

    /// Layers of these sizes with weights that are all 0.
    pub fn zero(sizes: &[usize]) -> Self {
        Self { sizes: sizes.to_vec(), weights: vec![0.0; Self::weights_of(sizes)] }
    }

    /// Reads the text.
    pub fn parse(text: &str) -> Result<Self, NetworkError> {
        let mut lines = text.lines().zip(1..).filter(|(line, _)| !line.trim().is_empty() && !line.starts_with('#'));
        let first = lines.next().map_or("", |(line, _)| line);
        let sizes: Result<Vec<usize>, _> = first.split_whitespace().map(str::parse).collect();
        let sizes = sizes.map_err(|_| NetworkError::Sizes(first.to_owned()))?;
        let mut weights = Vec::new();
        for (text, line) in lines {
            for word in text.split_whitespace() {
                let weight = word.parse().ok().filter(|weight: &f32| weight.is_finite());
                weights.push(weight.ok_or_else(|| NetworkError::Number { line, word: word.to_owned() })?);
            }
        }
        Self::new(&sizes, weights)
    }

    /// Sizes of its layers, from inputs to outputs.
    pub fn sizes(&self) -> &[usize] {
        &self.sizes
    }

    /// Its first outputs for these inputs. What is missing on either side is left out.
    pub fn outputs<const N: usize>(&self, inputs: &[f32]) -> [f32; N] {
        let (mut before, mut after) = ([0.0; WIDEST], [0.0; WIDEST]);
        for (value, input) in before.iter_mut().zip(inputs) {
            *value = *input;
        }
        let mut rest = &*self.weights;
        let layers = self.sizes.len() - 1;
        for (layer, pair) in self.sizes.windows(2).enumerate() {
            let (own, next) = rest.split_at((pair[0] + 1) * pair[1]);
            rest = next;
            for (value, line) in after.iter_mut().zip(own.chunks_exact(pair[0] + 1)) {
                let products = line[1..].iter().zip(&before).map(|(weight, input)| weight * input);
                let sum = products.fold(line[0], |sum, product| sum + product);
                *value = if layer + 1 < layers { sum / (1.0 + sum.abs()) } else { sum };
            }
            std::mem::swap(&mut before, &mut after);
        }
        std::array::from_fn(|i| before[i])
    }
}

impl fmt::Display for Network {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sizes: Vec<String> = self.sizes.iter().map(ToString::to_string).collect();
        writeln!(f, "{}", sizes.join(" "))?;
        let mut rest = &*self.weights;
        for pair in self.sizes.windows(2) {
            let (own, next) = rest.split_at((pair[0] + 1) * pair[1]);
            rest = next;
            for line in own.chunks_exact(pair[0] + 1) {
                let words: Vec<String> = line.iter().map(ToString::to_string).collect();
                writeln!(f, "{}", words.join(" "))?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_add_weigh_and_bend() {
        let network = Network::parse("# two inputs\n2 2 1\n0 1 0\n1 0 -1\n\n0.5 2 4\n").unwrap();
        // Hidden: 3 bends to 0.75, 1 - 2 = -1 to -0.5.
        assert_eq!(network.outputs(&[3.0, 2.0]), [0.5 + 2.0 * 0.75 - 4.0 * 0.5]);
        assert_eq!(Network::parse(&network.to_string()), Ok(network));
    }

    #[test]
    fn faults_have_a_line_or_a_count() {
        let error = |text: &str| Network::parse(text).unwrap_err().to_string();
        assert_eq!(error(""), "the first line has the sizes of two or more layers, from 1 to 64, not \"\"");
        assert_eq!(error("1 1\n0 inf"), "line 2: \"inf\" is not a finite number");
        assert_eq!(error("2 1\n0 1"), "layers of these sizes need 3 weights; there are 2");
        assert!(error("2 65\n0").starts_with("the first line"));
    }
}
