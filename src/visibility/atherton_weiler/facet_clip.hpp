#pragma once
/// The visible part of one facet: it is the subject, what is in front of it are the clip faces, nearest first.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/edge_overlay.hpp"
#include "visibility/atherton_weiler/facet_order.hpp"

namespace ligne::atherton_weiler {

/// Numbers of source segments: side k of facet f is 3 f + k; cuts have one number in common.
inline constexpr std::uint32_t kCutSource = 0xffffffffu;
inline std::uint32_t side_source(std::uint32_t facet, unsigned side) { return 3 * facet + side; }

/// A facet, or the part of it on the left of a line, as the edges of its contour. Side k of a facet is the segment from the vertex of the
/// lower number, so that both facets on it have the same segment.
struct ClipPart {
  std::array<ContourEdge, 4> edges;
  std::uint32_t count = 0;  ///< 0 when nothing is left

  ContourFace face() const { return {{EdgeLoop(edges.begin(), edges.begin() + count)}}; }
};
ClipPart whole_facet(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices, std::uint32_t facet);
ClipPart left_of(const ClipPart& triangle, const LatticeSegment& line);

/// Working memory that is kept from facet to facet.
class FacetClip {
 public:
  void begin(const ClipPart& subject) {
    subject_ = subject;
    clips_.clear();
    lines_.clear();
    faces_.clear();
  }
  void add(const ClipPart& clip, bool transparent) {
    if (clip.count == 0) return;
    clips_.push_back({clip, transparent});
    lines_.emplace_back(clip);
  }
  void add(std::vector<ContourFace> clips, bool transparent) {
    for (ContourFace& face : clips) faces_.push_back({std::move(face), transparent});
  }
  std::size_t clip_count() const { return clips_.size() + faces_.size(); }

  /// Appends the borders of what is left of the subject, the inside on the left: out[k] of that behind k transparent clip faces.
  void finish(std::vector<std::vector<ContourEdge>>& out);

 private:
  /// A part of the page in half steps; its sides are odd, so that no corner lies on them and no side runs along them.
  struct Window {
    std::int64_t x0, y0, x1, y1;
  };
  enum class Meeting : std::uint8_t { apart, covers, meets };

  /// The lines of a convex part: a point (x, y) in half steps is inside while a x + b y + c > 0 for all of them.
  struct Lines {
    explicit Lines(const ClipPart& part);
    Meeting meet(const Window& window) const;

    struct Line {
      double a, b, c;
    };
    std::array<Line, 4> line;
    std::uint32_t count;
  };

  template <class Form>
  struct Clip {
    Form form;
    bool transparent;
  };

  /// A side of a clip face that is no cut.
  struct Side {
    LatticeSegment segment;
    bool transparent, reversed;
    std::uint32_t clip, number;
  };

  void pair_sides();
  bool is_paired(std::uint32_t clip, std::uint32_t side) const {
    const std::uint32_t partner = partner_[4 * clip + side];
    return partner != kNoPartner && listed_[partner] == listed_[clip];
  }
  bool covered() const;
  void split(const Window& window, std::span<const std::uint32_t> list, int depth);
  void borders_in(const Window& window, std::span<const std::uint32_t> list, bool whole);
  bool beside_subject(const ContourEdge& edge) const;
  bool passes_over_subject(const ContourEdge& edge) const;
  std::vector<ContourEdge>& level(std::size_t k);

  ClipPart subject_;
  std::vector<Clip<ClipPart>> clips_;
  std::vector<Lines> lines_;
  std::vector<Clip<ContourFace>> faces_;  ///< clip faces that are no convex parts
  std::vector<Side> sides_;
  static constexpr std::uint32_t kNoPartner = 0xffffffffu;
  std::vector<std::uint32_t> partner_;  ///< per clip face four: the clip face on the other bank of its side
  std::vector<std::uint32_t> listed_;   ///< per clip face: the list it was in last
  std::uint32_t list_number_ = 0;
  EdgeOverlay overlay_;
  std::vector<std::vector<ContourEdge>>* out_ = nullptr;
};

}  // namespace ligne::atherton_weiler
