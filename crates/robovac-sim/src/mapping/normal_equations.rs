//! Observations of the state as a least-squares problem (normal equations).

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

/// A sum of squared residuals, linear around the present state.
#[derive(Debug, Default)]
pub(super) struct NormalEquations {
    /// Sum of the rows' squares, each over its variance.
    pub information: Matrix6<f64>,
    /// Half the sum's derivative.
    pub gradient: Vector6<f64>,
    /// Covariance of the gradient by errors of the observations, without what they have in common with others.
    pub noise: Matrix6<f64>,
    /// The part of the information that comes from the map, and the covariance of the errors of the pose from which that was
    /// mapped, times a weight, with the sum of these weights.
    pub mapped: Matrix3<f64>,
    pub drift: (Matrix3<f64>, f64),
}

/// Residuals of the pose with a common error: points of one wall are all nearer or all farther than they seem.
#[derive(Debug, Default)]
pub(super) struct Group {
    information: Matrix3<f64>,
    gradient: Vector3<f64>,
    rows: Vector3<f64>,
    /// Sum of the residuals, each over its own variance, and of one over those.
    off: f64,
    weight: f64,
    /// Variance of the error in common.
    shared: f64,
    /// Sum of the shares of new information, and number of points.
    news: f64,
    count: f64,
}

impl NormalEquations {
    /// Whether there are no observations.
    pub fn is_empty(&self) -> bool {
        self.information == Matrix6::zeros()
    }

    /// A residual `off` with its derivatives `row`; `weight` is one over its variance.
    pub fn add(&mut self, row: &Vector6<f64>, off: f64, weight: f64) {
        let information = row * row.transpose() * weight;
        self.information += information;
        self.noise += information;
        self.gradient += row * (off * weight);
    }

    /// Adds residuals of the pose, as the sums of their squares and half the derivative of those.
    pub fn add_pose(&mut self, information: &Matrix3<f64>, gradient: &Vector3<f64>) {
        let mut block = self.information.fixed_view_mut::<3, 3>(0, 0);
        block += information;
        let mut head = self.gradient.fixed_rows_mut::<3>(0);
        head += gradient;
    }

    /// Adds a group. The common error is integrated out (Sherman & Morrison's formula); the rest counts by its new
    /// information.
    pub fn add_group(&mut self, group: &Group) {
        if group.weight == 0.0 {
            return;
        }
        let news = group.news / group.count;
        let factor = group.shared / (1.0 + group.shared * group.weight);
        let information = group.information - group.rows * group.rows.transpose() * factor;
        let gradient = group.gradient - group.rows * (factor * group.off);
        let mut block = self.information.fixed_view_mut::<3, 3>(0, 0);
        block += information * news;
        let mut block = self.noise.fixed_view_mut::<3, 3>(0, 0);
        block += information * (news * news);
        self.mapped += information * news;
        let mut head = self.gradient.fixed_rows_mut::<3>(0);
        head += gradient * news;
    }
}

impl Group {
    /// Adds a residual with the common variance `shared`; `news` is the share of it that counts.
    pub fn add(&mut self, row: &Vector3<f64>, off: f64, weight: f64, shared: f64, news: f64) {
        self.information += row * row.transpose() * weight;
        self.gradient += row * (off * weight);
        self.rows += row * weight;
        self.off += off * weight;
        self.weight += weight;
        self.shared = self.shared.max(shared);
        self.news += news;
        self.count += 1.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_points_with_an_error_in_common_say_no_more_than_that_error_allows() {
        let row = Vector3::new(1.0, 0.0, 0.0);
        let mut group = Group::default();
        for _ in 0..1000 {
            group.add(&row, 0.02, 1.0 / 1e-4, 4e-4, 1.0);
        }
        let mut equations = NormalEquations::default();
        equations.add_group(&group);
        // The variance of the mean of a thousand is nearly that of what they share.
        let variance = 1.0 / equations.information[(0, 0)];
        assert!((variance - 4e-4).abs() < 1e-6, "{variance}");
        assert!((equations.gradient[0] * variance - 0.02).abs() < 1e-9);
    }
}
