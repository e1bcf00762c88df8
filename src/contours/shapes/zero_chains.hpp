#pragma once
/// The zero set of a function of the nodes of a mesh, as chains of segments.

#include <cstdint>
#include <vector>

#include "scene/form/form_mesh.hpp"

namespace ligne {

/// Segment i runs from point i to point i + 1 over triangle i. A closed chain repeats its first point.
struct ZeroChain {
  std::vector<Point3> points;
  std::vector<std::uint32_t> triangles;
  bool closed = false;

  std::size_t size() const { return triangles.size(); }
};

/// The function is linear over a triangle, and zero at a node counts as positive; so chains never branch. With `way`, values
/// are those along directions of which either of two opposite ones is meant: before two values are compared the directions
/// are made to agree. Triangles whose three directions do not agree have no segment; chains end there.
std::vector<ZeroChain> trace_zero_set(const FormMesh& mesh, const std::vector<double>& value,
                                      const std::vector<Point3>& way = {});

}  // namespace ligne
