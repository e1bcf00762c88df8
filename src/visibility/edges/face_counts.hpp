#pragma once
/// How many faces, and which, lie before each part of a line: [Appel1967] calls the number the quantitative invisibility of
/// a point, [GalimbertiMontanari1969] call the set its nature.

#include <cstdint>
#include <vector>

#include "visibility/common/box_forest.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {

/// A part of a line, and the facets before it. `faces` is left empty where only the number is asked for.
struct CountedPart {
  double from = 0, to = 0;
  std::uint32_t count = 0;
  std::vector<std::uint32_t> faces{};  ///< ascending

  bool is_like(const CountedPart& other) const { return count == other.count && faces == other.faces; }
};

/// A tree of the facets. Facets of a face do not lie over each other, so that facets count as faces.
class FacetForest {
 public:
  FacetForest(const ProjectedScene& scene, const std::vector<Facet>& facets);

  const std::vector<Facet>& facets() const { return facets_; }
  const std::vector<ProjectedVertex>& vertices() const { return vertices_; }

  /// Calls visit(facet) for each facet that may be before a part of the line.
  template <class Visit>
  void for_each_before(const PageLine& line, const OpenParts& whole, Visit visit) const {
    forest_.for_each_before(root_, line, whole, visit);
  }
  /// Calls visit(facet) for each facet that may have points of the line's own depths at its place on the page: all that
  /// touch the line or that it pierces are among them.
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

/// Tests lines against all facets. Working memory that is kept from line to line.
class FaceCounter {
 public:
  FaceCounter(const FacetForest& forest, double coincidence_steps)
      : forest_(forest), coincidence_steps_(coincidence_steps) {}

  /// The parts of [0, 1], in order, without gaps. A point is seen on the side on which fewer facets are before it. `tests`
  /// is raised by the facets that were asked.
  std::vector<CountedPart> count(const PageLine& line, bool with_faces, std::uint64_t& tests);

 private:
  struct Event {
    double t;
    std::uint32_t face;
    int left, right;  ///< +1 where the facet begins to be before that side, -1 where it ends
  };

  const FacetForest& forest_;
  double coincidence_steps_;
  std::vector<Event> events_;
  std::vector<std::uint32_t> left_, right_;  ///< faces before either side
};

}  // namespace ligne
