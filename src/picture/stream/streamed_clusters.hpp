#pragma once
/// Finds clusters of vertices (view/vertex_clusters.hpp) of which only a part would be kept.

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "visibility/stream/stream_facet.hpp"

namespace ligne {

/// Cubes of page space around the needed vertices, larger than the cubes of clusters. If such a cube contains enough
/// vertices for a cluster, and not all of them are needed, the kept vertices would be merged differently than in the
/// whole model.
class ClusterCounter {
 public:
  /// `places`: positions of the needed vertices.
  ClusterCounter(const StreamFacets& facets, std::span<const Point3> places);

  /// Counts a vertex. To be called for all vertices of the file; several threads may call it.
  void count(const Point3& vertex, bool needed);
  /// Whether a vertex of the file lies in a cluster that would be split. Call it after all vertices are counted.
  bool is_split(const Point3& vertex) const;
  bool any_split() const;

 private:
  struct Cube {
    std::uint64_t number = 0;  ///< 0: no cube
    std::atomic<std::uint32_t> vertices{0}, not_needed{0};
    bool torn() const;
  };

  std::size_t slot_of(std::uint64_t number) const;
  std::uint64_t number_of(const Point3& vertex) const;

  const StreamFacets& facets_;
  double side_mm_, reach_mm_;
  std::vector<Cube> cubes_;
};

}  // namespace ligne
