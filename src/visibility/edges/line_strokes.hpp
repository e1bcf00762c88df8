#pragma once
/// The last phase of every method: from what it found of each line to strokes.

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "base/parallel.hpp"
#include "linework/stroke.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/common/open_parts.hpp"
#include "visibility/edges/face_counts.hpp"
#include "visibility/penetration/penetration.hpp"

namespace ligne {

/// Puts the visible parts of line number i into `parts`: in order, disjoint. Returns whether another line may lie on it.
using LineVisibility = std::function<bool(std::size_t i, const PageLine& line, std::vector<LinePart>& parts)>;

/// Makes the LineVisibility of a block of lines, which one thread studies with memory of its own.
using MakeLineVisibility = FunctionRef<LineVisibility()>;

/// Per line its parts with the number of faces before each (face_counts.hpp).
using CountedLines = std::vector<std::vector<CountedPart>>;

/// Makes the strokes of a scene's lines in parallel, in the order of the lines whatever the number of threads. Lines that
/// are seen end on have none, and parts that are too short for the page are left out.
class LineStrokes {
 public:
  /// `hidden_too`: what lies between the visible parts becomes hidden strokes. Parts shorter than `shortest_steps` are left
  /// out.
  LineStrokes(const ProjectedScene& scene, const Facets& facets, bool hidden_too, double shortest_steps);

  /// All candidate edges. With `counted` hidden strokes end where the faces before them change, as far as these are known,
  /// and have their number as their level. `counted` must live until take().
  void add_edges(MakeLineVisibility make, const std::function<void(double)>& progress = {},
                 const CountedLines* counted = nullptr);

  /// The common segments of penetrating faces, behind all edges. To be called once.
  void add_intersections(const std::vector<Intersection>& intersections, MakeLineVisibility make,
                         const CountedLines* counted = nullptr);

  /// All strokes, with the faces before the hidden ones where they were counted.
  StrokeModel take();

 private:
  /// Where a line comes from.
  struct Origin {
    std::uint32_t source;
    LineClass line_class;
    std::array<double, 2> range;  ///< part of the source edge
    bool needs_overlap_check;     ///< whatever lies near
    const std::vector<CountedPart>* counted = nullptr;
  };

  /// The strokes of a block of lines. counted[i] is the part that hidden[i], the number of a stroke, was made from.
  struct Block {
    std::vector<Stroke> strokes;
    std::vector<std::size_t> hidden;
    std::vector<const CountedPart*> counted;
  };

  template <class LineOf>
  void add(std::size_t count, MakeLineVisibility make, const std::function<void(double)>& progress, LineOf line_of);
  void add_parts(const PageLine& line, const std::vector<LinePart>& parts, const Origin& origin, Block& out) const;
  void add_hidden(const PageLine& line, LinePart gap, const Origin& origin, Block& out) const;
  void append_blocks(std::vector<Block>& blocks);
  Stroke stroke(const PageLine& line, LinePart part, const Origin& origin, bool visible) const;
  double model_parameter(const PageLine& line, double t) const;
  bool is_thin(std::uint32_t face) const { return face < facets_.face_is_thin.size() && facets_.face_is_thin[face]; }

  const ProjectedScene& scene_;
  const Facets& facets_;
  bool hidden_too_;
  double shortest_;
  StrokeModel model_;
  Block counted_;  ///< of all strokes, without these themselves
};

}  // namespace ligne
