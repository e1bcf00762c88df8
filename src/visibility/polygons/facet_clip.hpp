#pragma once
/// Finds the visible part of one facet. The facet is the subject, and the facets in front of it are the clip faces,
/// nearest first.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygons/edge_overlay.hpp"
#include "visibility/polygons/clip_part.hpp"
#include "visibility/polygons/shared_sides.hpp"

namespace ligne {

/// Clips one facet after the other. It keeps its working memory from facet to facet.
class FacetClip {
 public:
  /// A rectangle of the page in half steps.
  struct Window {
    double x0, y0, x1, y1;
  };
  using Number = std::uint32_t;

  void begin(const ClipPart& subject);

  /// Adds a clip face and returns its number, counted from 0.
  Number add(const ClipPart& clip, bool transparent);
  void add(std::vector<ContourFace> clips, bool transparent) {
    for (ContourFace& face : clips) faces_.push_back({std::move(face), transparent});
  }
  std::size_t clip_count() const { return clips_.size() + faces_.size(); }

  /// Whether the subject lies beside the window. False where rounding leaves it open.
  bool subject_beside(const Window& window) const { return subject_lines_.meet(window) == Meeting::apart; }

  /// Whether the opaque clip faces of the list hide all of the subject in the window. False where rounding leaves it
  /// open.
  bool covers(std::span<const Number> list, const Window& window);

  /// Appends the borders of the visible part of the subject, with the inside on the left. out[k] gets the part behind k
  /// transparent clip faces.
  void finish(std::vector<std::vector<ContourEdge>>& out);

 private:
  enum class Meeting : std::uint8_t { apart, covers, meets };

  /// The lines that bound a convex part: a point (x, y) in half steps is inside if a x + b y + c > 0 for all of them.
  struct Lines {
    Lines() = default;
    explicit Lines(const ClipPart& part);
    Meeting meet(const Window& window) const;
    bool surely_inside(double x, double y) const;

    struct Line {
      double a, b, c;
    };
    std::array<Line, 4> line{};
    std::uint32_t count = 0;
  };

  template <class Form>
  struct Clip {
    Form form;
    bool transparent;
  };

  void split(const Window& window, std::span<const Number> list, int depth);
  void borders_in(const Window& window, std::span<const Number> list, bool whole);
  void begin_list(std::span<const Number> list);
  bool is_rim(Number clip, std::uint32_t side) const;
  bool beside_subject(const ContourEdge& edge) const;
  bool passes_over_subject(const ContourEdge& edge) const;
  bool find_inner_point(const Window& window, double& x, double& y) const;
  std::vector<ContourEdge>& level(std::size_t k);

  ClipPart subject_;
  Lines subject_lines_;
  std::vector<Clip<ClipPart>> clips_;
  std::vector<Lines> lines_;
  std::vector<Clip<ContourFace>> faces_;  ///< clip faces that are not convex parts
  SharedSides sides_;
  std::vector<std::uint32_t> listed_;  ///< per clip face: number of the last list that contained it
  std::uint32_t list_number_ = 0;
  std::vector<Number> patch_;  ///< clip faces of one surface
  EdgeOverlay overlay_;
  std::vector<std::vector<ContourEdge>>* out_ = nullptr;
};

}  // namespace ligne
