#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Vector3.hpp>

namespace harmos::recovery {

/// A face on which the traction is known: free of it, or loaded.
struct KnownFace {
  std::vector<int> node;  ///< of the part, from 0
  base::Vector3 normal;   ///< unit vector out of the part
  /// [stress] per node and column, node by node; empty: free of traction in all columns.
  std::vector<base::Vector3> traction;
};

/// Gives nodal stresses the smallest change, in the norm of stress tensors, with which sigma n = t at the nodes of
/// faces whose traction t is known.
///
/// Faces at a node whose normals differ by less than 37 degrees share the mean normal; where the tractions of such
/// faces differ, as at the rim of a load, nothing is asked of the node there. `skipped`: nodes of the part of which
/// nothing is asked at all. stress: (components xx, yy, zz, xy, yz, zx x columns) x nodes [stress]. Returns whether
/// anything was asked of each node. Throws base::Error when LAPACK fails. Not collective.
std::vector<bool> correctTractions(const std::vector<KnownFace>& faces, const std::vector<bool>& skipped, int dimension,
                                   base::Matrix& stress);

}  // namespace harmos::recovery
