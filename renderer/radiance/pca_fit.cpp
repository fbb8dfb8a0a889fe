#include "renderer/radiance/pca_fit.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "renderer/radiance/texel_values.h"

namespace lightbench {
namespace {

using Eigen::Index;
using Eigen::MatrixXf;

constexpr Index kSpare = 8;
constexpr int kIterations = 3;       // for each two vectors more; four times as many gain 1 % of the error
constexpr int kOpenIterations = 10;  // 5 ask for half as many vectors more where an eighth is saturated

MatrixXf orthonormal(const MatrixXf& m) {
  return Eigen::HouseholderQR<MatrixXf>(m).householderQ() * MatrixXf::Identity(m.rows(), m.cols());
}

/// Columns in which a fit is visibly beyond an open value.
std::vector<Index> overshot_columns(const MatrixXf& values, const MatrixXf& fitted) {
  std::vector<Index> columns;
  for (Index i = 0; i < values.cols(); ++i)
    if ((values.col(i).binaryExpr(fitted.col(i), target_of) - values.col(i)).cwiseAbs().maxCoeff() > 0.5f)
      columns.push_back(i);
  return columns;
}

/// Descends from these weights to those of the least squared error, by Nesterov's accelerated gradient.
MatrixXf settled(const PcaAxes& axes, const MatrixXf& values, MatrixXf weights) {
  MatrixXf ahead = weights;
  float t = 1;
  for (int i = 0; i < kOpenIterations; ++i) {
    const MatrixXf fitted = axes.sums(ahead);
    const MatrixXf next = ahead + axes.vectors.transpose() * (values.binaryExpr(fitted, target_of) - fitted);
    const float next_t = (1 + std::sqrt(1 + 4 * t * t)) / 2;
    ahead = next + (t - 1) / next_t * (next - weights);
    weights = next, t = next_t;
  }
  return weights;
}

}  // namespace

MatrixXf PcaAxes::sums(const MatrixXf& weights) const {
  return (vectors * weights).colwise() + mean;
}

MatrixXf PcaAxes::coefficients(const MatrixXf& values) const {
  MatrixXf result = vectors.transpose() * (values.colwise() - mean);
  const std::vector<Index> open = overshot_columns(values, sums(result));
  if (!open.empty())
    result(Eigen::all, open) = settled(*this, values(Eigen::all, open), result(Eigen::all, open));
  return result;
}

PcaFit::PcaFit(MatrixXf values) : values_(std::move(values)), targets_(values_), block_(values_.rows(), 0) {}

/// By random vectors, the same each time.
void PcaFit::widen_block(Index vectors) {
  std::minstd_rand random(static_cast<unsigned>(vectors));
  MatrixXf wider(values_.rows(), vectors);
  wider.leftCols(block_.cols()) = block_;
  for (Index k = block_.cols(); k < vectors; ++k)
    for (Index row = 0; row < wider.rows(); ++row)
      wider(row, k) = float(random()) / float(std::minstd_rand::max()) - 0.5f;
  block_ = orthonormal(wider);
}

/// A step of subspace iteration: the block is turned to its principal axes, then multiplied by the
/// covariance. The targets follow what the axes give.
void PcaFit::iterate(PcaAxes& axes, Index kept) {
  axes.mean = targets_.rowwise().mean();
  const MatrixXf centered = targets_.colwise() - axes.mean;
  MatrixXf weights = block_.transpose() * centered;
  const Eigen::SelfAdjointEigenSolver<MatrixXf> solver(weights * weights.transpose());
  const MatrixXf principal = solver.eigenvectors().rowwise().reverse();
  axes.vectors = block_ * principal.leftCols(kept);
  weights = principal.transpose() * weights;
  block_ = orthonormal(centered * weights.transpose());
  targets_ = values_.binaryExpr(axes.sums(weights.topRows(kept)), target_of);
}

PcaAxes PcaFit::grow(Index vectors) {
  const Index most = std::min(values_.rows(), values_.cols());
  widen_block(std::max(block_.cols(), std::min(vectors + kSpare, most)));
  PcaAxes axes;
  for (int i = 0; i < kIterations; ++i) iterate(axes, std::min(vectors, most));
  return axes;
}

}  // namespace lightbench
