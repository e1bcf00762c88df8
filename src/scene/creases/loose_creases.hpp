#pragma once
/// Creases that end in the middle of a surface.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "scene/creases/bend.hpp"
#include "scene/creases/parallel_bends.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// The free ends of creases, and the runs of edges behind them. Reads the bends anew at each call.
class FreeEnds {
 public:
  /// `ends` are sorted; `is_anchor`: by vertex of an end, whether a crease may end there.
  FreeEnds(const Topology& topology, std::span<const BendEnd> ends, const std::vector<Bend>& bends,
           const std::function<bool(std::uint32_t)>& is_anchor)
      : topology_(topology), ends_(ends), bends_(bends), is_anchor_(is_anchor) {}

  /// The vertices of one crease alone, ascending.
  std::vector<std::uint32_t> list() const;
  /// The only crease at a vertex beside `except`, or kNone.
  std::uint32_t only_crease_at(std::uint32_t vertex, std::uint32_t except) const;
  /// Whether a crease ends freely at a vertex.
  bool is_free(std::uint32_t vertex) const { return only_crease_at(vertex, kNone) != kNone && !is_anchor_(vertex); }
  bool is_crease(std::uint32_t e) const { return bends_[e] >= Bend::strong; }
  std::uint32_t other_end(std::uint32_t e, std::uint32_t vertex) const {
    return ligne::other_end(topology_.edges[e], vertex);
  }

  struct Run {
    std::vector<std::uint32_t> edges;
    std::uint32_t end = kNone;  ///< the vertex where it stops
  };
  /// The run from a free end to the next vertex of three creases or more, to an anchored one, or to an edge for which
  /// `may_go` does not hold.
  template <class MayGo>
  Run run_from(std::uint32_t tip, const MayGo& may_go) const {
    Run run{{}, tip};
    for (std::uint32_t e = only_crease_at(tip, kNone); e != kNone && may_go(e); e = only_crease_at(run.end, e)) {
      run.edges.push_back(e);
      run.end = other_end(e, run.end);
      if (run.end == tip || is_anchor_(run.end)) break;
    }
    return run;
  }

 private:
  const Topology& topology_;
  std::span<const BendEnd> ends_;
  const std::vector<Bend>& bends_;
  const std::function<bool(std::uint32_t)>& is_anchor_;
};

/// Makes the edges of runs from free ends weak, and goes on from the ends that this leaves: judge(tip, gone, left) appends
/// the edges that go and the vertices where they stop. Returns the number of creases that go.
template <class Judge>
std::size_t drop_from_free_ends(const FreeEnds& free, std::vector<Bend>& bends, const Judge& judge) {
  std::size_t dropped = 0;
  for (std::vector<std::uint32_t> tips = free.list(); !tips.empty();) {
    std::vector<std::uint32_t> gone, left;
    for (const std::uint32_t tip : tips) {
      if (free.is_free(tip)) judge(tip, gone, left);
    }
    for (const std::uint32_t e : gone) {
      dropped += free.is_crease(e);
      bends[e] = Bend::weak;
    }
    tips = std::move(left);
  }
  return dropped;
}

/// The creases that may be loose.
struct LooseEdges {
  std::span<const BendEnd> ends;                        ///< sorted
  std::span<const double> sizes;                        ///< per object: diagonal of its box
  const std::function<bool(std::uint32_t)>& may_go;     ///< by edge: only its faces tell that it is a crease
  const std::function<bool(std::uint32_t)>& is_anchor;  ///< by vertex of an end: a crease may end there
};

/// Takes back creases that end in the middle of a surface, up to an eighth of their object long: lines with two free ends,
/// and runs from a free end over edges that the file calls smooth and that bend too much for it. A tube of six sides bends
/// by 60 degrees, and by a little less where it is bent itself. Lines with two free ends stay if one of their edges exceeds
/// the crease angle by 20 degrees. Edges that go are weak then. Returns their number.
std::size_t drop_loose_creases(const Scene& scene, const Topology& topology, const LooseEdges& edges,
                               std::vector<Bend>& bends);

/// The creases of free forms.
struct BluntEdges {
  const EdgeRows& rows;
  std::span<const BendEnd> ends;                     ///< sorted
  std::span<const double> sizes;                     ///< per object: diagonal of its box
  const std::function<bool(std::uint32_t)>& may_go;  ///< by edge: only its faces, of free forms, tell that it is a crease
  const std::function<bool(std::uint32_t)>& is_in_large;  ///< by such an edge: its free form is large for its borders
  const std::function<bool(std::uint32_t)>& is_anchor;    ///< by vertex of an end: it lies on a border
};

/// Takes back connected creases inside large free forms that are no sharper than the form around them: together they bend by
/// less than a turn of six facets on average, and by less than four times as much as the other edges within two rings of
/// faces, or five where they fork, by lengths. A coarse mesh bends so wherever its facets happen to be large. Creases of
/// which one edge may not go stay, and so do rings half as long as their object, and edges across a strip, from border to
/// border. Edges that go are weak then. Returns their number.
std::size_t drop_blunt_creases(const Scene& scene, const Topology& topology, const BluntEdges& edges,
                               std::vector<Bend>& bends);

}  // namespace ligne
