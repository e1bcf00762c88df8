#pragma once
/// The number or the set of the faces in front of each part of a line: [Appel1967] calls the number the quantitative
/// invisibility of a point, [GalimbertiMontanari1969] call the set its nature.

#include <cstdint>
#include <vector>

#include "visibility/common/box_forest.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

/// A part of a line, and the faces in front of it. `faces` stays empty where only the number is wanted.
struct CountedPart {
  double from = 0, to = 0;
  std::uint32_t count = 0;
  std::vector<std::uint32_t> faces{};  ///< ascending

  bool is_like(const CountedPart& other) const { return count == other.count && faces == other.faces; }
};

/// A tree of the facets. Facets of one face do not overlap on the page, so the number of facets is the number of faces.
class FacetForest {
 public:
  FacetForest(const ProjectedScene& scene, const std::vector<Facet>& facets);

  const std::vector<Facet>& facets() const { return facets_; }
  const std::vector<ProjectedVertex>& vertices() const { return vertices_; }

  /// Calls visit(facet) for each facet that may lie in front of a part of the line.
  template <class Visit>
  void for_each_before(const PageLine& line, const OpenParts& whole, Visit visit) const {
    forest_.for_each_before(root_, line, whole, visit);
  }
  /// Calls visit(facet) for each facet whose box meets the line on the page and in depth. These include every facet
  /// that the line touches or pierces.
  template <class Visit>
  void for_each_near(const PageLine& line, Visit visit) const {
    forest_.for_each_met(root_, line, visit);
  }

 private:
  const std::vector<Facet>& facets_;
  const std::vector<ProjectedVertex>& vertices_;
  BoxForest forest_;
  std::uint32_t root_ = 0;
};

/// Tests lines against all facets. It keeps its working memory from line to line.
class FaceCounter {
 public:
  FaceCounter(const FacetForest& forest, double coincidence_steps)
      : forest_(forest), coincidence_steps_(coincidence_steps) {}

  /// Returns the parts of [0, 1], in order, without gaps. Each count is taken on the side of the line with fewer facets in
  /// front. `tests` grows by the number of facets tested.
  std::vector<CountedPart> count(const PageLine& line, bool with_faces, std::uint64_t& tests);

 private:
  struct Event {
    double t;
    std::uint32_t face;
    int left, right;  ///< +1 where the facet begins to cover that side of the line, -1 where it ends
  };

  const FacetForest& forest_;
  double coincidence_steps_;
  std::vector<Event> events_;
  std::vector<std::uint32_t> left_, right_;  ///< faces in front of either side of the line
};

}  // namespace ligne
