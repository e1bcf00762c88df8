#pragma once
/// Traces the zero set of a function given at the nodes of a mesh, as chains of segments.

#include <cstdint>
#include <vector>

#include "scene/form/form_mesh.hpp"

namespace ligne {

/// Segment i runs from point i to point i + 1 over triangle i. A closed chain repeats its first point.
struct ZeroChain {
  std::vector<Point3> points;
  std::vector<std::uint32_t> triangles;  ///< per segment
  bool closed = false;

  /// Number of segments.
  std::size_t size() const { return triangles.size(); }
};

/// Traces the zero set of a function that is linear over each triangle. Zero at a node counts as positive, so chains
/// never branch. If `way` is given, the values are derivatives along its directions, whose signs are arbitrary. Then
/// the signs of directions (and values) are made to agree before two values are compared. Triangles whose three
/// directions can not be made to agree have no segment, and chains end there.
std::vector<ZeroChain> trace_zero_set(const FormMesh& mesh, const std::vector<double>& value,
                                      const std::vector<Point3>& way = {});

}  // namespace ligne
