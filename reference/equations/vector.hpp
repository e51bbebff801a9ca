// Vectors of the paper: columns of D numbers of any scalar type, D = 2 or 3.
#pragma once

#include <Eigen/Core>

namespace tps {

/// A position, velocity or impulse in D dimensions.
template <typename Scalar, int D>
using Vector = Eigen::Matrix<Scalar, D, 1>;

}  // namespace tps
