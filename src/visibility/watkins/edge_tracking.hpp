#pragma once
/// Visible edges tracked from line to line ([Boulle1980] 2.3.4, after Archuleta 1972).
///
/// On every studied scan line the spans give the state of each candidate line: visible on this scan line (2), visible on the
/// preceding one (1), invisible (0). [Boulle1980] draws from the scan line on which state 2 began to the last one on which
/// it held, so strokes end at scan lines. Here the tracker keeps the face that a span shows in front of an edge, and the
/// exact operation (common/hidden_interval.hpp) computes the part of the edge that it hides. Strokes therefore have exact
/// ends; the scan lines only limit which faces are found.
///
/// An edge is compared with the faces of all spans that it may pass between the preceding and the following scan line; a
/// flat edge passes many. An edge that no scan line meets, horizontal or between two scan lines, is compared with the spans
/// of both.

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/common/hidden_interval.hpp"
#include "visibility/watkins/exact/exact_sweep.hpp"
#include "visibility/watkins/line_scan.hpp"

namespace ligne::watkins {

struct TrackCounts {
  std::uint64_t positions = 0;                          ///< edges examined on studied lines
  std::uint64_t became_visible = 0, became_hidden = 0;  ///< changes of state
  std::uint64_t facet_tests = 0;
  void operator+=(const TrackCounts& o);
};

class EdgeTracker final : public LineListener {
 public:
  EdgeTracker(const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets, const ScanScene& scene,
              std::span<const SweepLine> lines, double coincidence_steps)
      : vertices_(vertices), facets_(facets), scene_(scene), lines_(lines), coincidence_steps_(coincidence_steps) {}

  void line(const LineScan& scan, std::uint32_t line, bool studied) override;
  void ended(const LineScan& scan, std::uint32_t slot) override;
  void hidden_point(const LineScan& scan, std::uint32_t slot, std::uint32_t face) override;

  const std::vector<Finding>& findings() const { return findings_; }
  const TrackCounts& counts() const { return counts_; }

 private:
  enum class State : std::uint8_t { unknown, hidden, visible };
  struct Track {
    std::vector<std::uint32_t> tested;  ///< faces
    std::vector<HiddenInterval> hidden;
    State state = State::unknown;
    double t = 0;  ///< parameter at the last examined scan line
  };
  /// The tracks of the lines of one active edge.
  struct Tracks {
    std::vector<Track> of_line;
    std::size_t used = 0;
  };

  Tracks& tracks_of(const LineScan& scan, std::uint32_t slot);
  void look(const LineScan& scan, std::uint32_t slot, std::uint32_t line);
  void between_lines(const LineScan& scan, std::uint32_t line);
  void hold_part(const LineScan& scan, const ScanEdge& edge, double u0, double u1);
  void hold_against(std::uint32_t index, Track& track, std::uint32_t face);
  template <class Visit>
  void for_each_span(const LineScan& scan, double low, double high, Visit visit) const;

  const std::vector<ProjectedVertex>& vertices_;
  const std::vector<Facet>& facets_;
  const ScanScene& scene_;
  std::span<const SweepLine> lines_;
  double coincidence_steps_;
  std::vector<Tracks> tracks_;  ///< by slot
  std::vector<Finding> findings_;
  TrackCounts counts_;
};

}  // namespace ligne::watkins
