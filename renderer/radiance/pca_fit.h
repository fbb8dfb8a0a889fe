#pragma once

#include <Eigen/Core>

namespace lightbench {

/// A mean and orthonormal vectors, whose weighted sums come near to texels' values (texel_values.h).
struct PcaAxes {
  Eigen::VectorXf mean;
  Eigen::MatrixXf vectors;  ///< columns

  /// The weights of the vectors for texels, one a column, with least squared error; open values are open.
  /// Of the mean and the vectors, one a column.
  Eigen::MatrixXf sums(const Eigen::MatrixXf& weights) const;
  Eigen::MatrixXf coefficients(const Eigen::MatrixXf& values) const;
};

/// Finds such axes by principal component analysis: those of the largest variance first.
class PcaFit {
 public:
  /// One texel a column: a few thousand are enough.
  explicit PcaFit(Eigen::MatrixXf values);

  /// More than the last time; but never more than the values have rows or columns.
  PcaAxes grow(Eigen::Index vectors);

 private:
  void widen_block(Eigen::Index vectors);
  void iterate(PcaAxes& axes, Eigen::Index kept);

  Eigen::MatrixXf values_;
  Eigen::MatrixXf targets_;  ///< the values, but what they may as well be where they are open
  Eigen::MatrixXf block_;    ///< orthonormal; spare vectors beside those wanted, so that these converge
};

}  // namespace lightbench
