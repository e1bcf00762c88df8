#pragma once
/// The last phase of every method: makes strokes from the visible parts of the lines.

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

/// Puts the visible parts of line number i into `parts`: in order, disjoint. Returns whether another line may coincide
/// with it.
using LineVisibility = std::function<bool(std::size_t i, const PageLine& line, std::vector<LinePart>& parts)>;

/// Makes the LineVisibility for a block of lines. One thread studies the block, with its own memory.
using MakeLineVisibility = FunctionRef<LineVisibility()>;

/// Per line: its parts with the number of faces in front of each (face_counts.hpp).
using CountedLines = std::vector<std::vector<CountedPart>>;

/// Makes the strokes of a scene's lines in parallel. Their order is that of the lines, for any number of threads. Lines
/// seen end on give no stroke; parts too short for the page are left out.
class LineStrokes {
 public:
  /// `hidden_too`: the gaps between the visible parts become hidden strokes. Parts shorter than `shortest_steps`
  /// lattice steps are left out.
  LineStrokes(const ProjectedScene& scene, const Facets& facets, bool hidden_too, double shortest_steps);

  /// Adds all candidate edges. With `counted`, hidden strokes end where the known faces in front of them change, and
  /// their level is the number of these faces. `counted` must live until take().
  void add_edges(MakeLineVisibility make, const std::function<void(double)>& progress = {},
                 const CountedLines* counted = nullptr);

  /// Adds the common segments of penetrating faces, after all edges. To be called once.
  void add_intersections(const std::vector<Intersection>& intersections, MakeLineVisibility make,
                         const CountedLines* counted = nullptr);

  /// Returns all strokes, with the faces in front of the hidden ones where these were counted.
  StrokeModel take();

 private:
  /// The source of a line.
  struct Origin {
    std::uint32_t source;
    LineClass line_class;
    std::array<double, 2> range;  ///< part of the source edge
    bool needs_overlap_check;     ///< even if no other side lies along the line
    const std::vector<CountedPart>* counted = nullptr;
  };

  /// The strokes of a block of lines. Stroke number hidden[i] was made from the part counted[i].
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
  Block counted_;  ///< `hidden` and `counted` of all strokes; its `strokes` stay empty
};

}  // namespace ligne
