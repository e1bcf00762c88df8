#pragma once
/// Crowds of vertices (view/crowds.hpp) of which a part would be left out.

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "visibility/stream/stream_facet.hpp"

namespace ligne {

/// Cubes of the page's space round the vertices that are needed, larger than those of crowds. Where more vertices than make
/// a crowd lie in such a cube, and not all of them are needed, what is left would not be gathered as the whole is.
class CrowdWatch {
 public:
  /// `places`: of the needed vertices.
  CrowdWatch(const StreamFacets& facets, std::span<const Point3> places);

  /// To be told of all vertices of the file, from several threads.
  void count(const Point3& vertex, bool needed);
  /// Whether a vertex, of the file too, lies where a crowd may be torn apart. When all are counted.
  bool is_torn(const Point3& vertex) const;
  bool any_torn() const;

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
