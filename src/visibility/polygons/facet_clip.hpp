#pragma once
/// Finds the visible part of one facet. The facet is the subject, and the facets in front of it are the clip faces,
/// nearest first.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygons/edge_overlay.hpp"
#include "visibility/polygons/clip_part.hpp"

namespace ligne {

/// Finds sides that two clip faces share, one on each side. Such a side does not bound the union of the two: without it
/// the winding numbers of all clip faces stay unchanged. So a surface of many facets clips a subject as one face, with
/// its rim.
class SharedSides {
 public:
  void clear();

  /// Adds clip faces with the numbers 0, 1, 2, ... A transparent and an opaque face are never partners.
  void add(const ClipPart& clip, bool transparent);

  /// The clip face across a side of a clip face, or kNone. Each side has at most one partner.
  std::uint32_t partner(std::uint32_t clip, std::uint32_t side) const { return partner_[kMostSides * clip + side]; }

 private:
  static constexpr std::uint32_t kMostSides = 4;

  struct Side {
    LatticeSegment segment;
    bool transparent, reversed;
    std::uint32_t number;  ///< kMostSides times the clip face, plus the side
  };
  /// A slot of the hash table. If its round is not the current one, it belongs to an earlier subject.
  struct Slot {
    std::uint32_t round = 0, side = 0;
  };

  void insert(std::uint32_t side);
  void grow();

  std::vector<Side> sides_;
  std::vector<std::uint32_t> partner_;
  std::vector<Slot> slots_;
  std::uint32_t round_ = 0;
};

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
