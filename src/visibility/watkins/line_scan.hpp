#pragma once
/// The scan by lines: which edges a scan line meets, what is visible on it, and which lines need no study ([Boulle1980]
/// 2.3.2, 2.3.5).
///
/// Invariants after every line: the active list is sorted by u; the spans equal those of a full study of the line (their
/// ends follow the edges that bound them); an edge is marked as boundary exactly if it bounds a span.
///
/// A line is studied only after a visible change: an edge enters or ends, or two edges are exchanged. Changes among hidden
/// elements are recognised and skipped (figure 2.59): an edge that continues in another one of the same faces, points that
/// appear behind the span round them, ends of edges that bound nothing, exchanges of two such edges, and exchanges of one
/// with the end of a span if the next span hides it too. Touching faces keep their order on all lines (FaceOrders). Where
/// faces penetrate, the line of intersection is an ordinary edge of the scene. A penetration without such an edge gets a
/// straight one until the next study; lines on which one of the two faces gains or loses an edge are studied. The line after
/// a penetration of a skew face is always studied.

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/add_counts.hpp"
#include "visibility/watkins/scan_scene.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {

struct ScanOptions {
  SpanMethodKind kind = SpanMethodKind::stack;
  bool coherence = true;       ///< skips lines without changes
  bool recognise = true;       ///< skips changes among hidden elements
  bool sorted = true;          ///< sorts segments by the full key; otherwise they keep the order of their faces
  SpanTrace* trace = nullptr;  ///< records studies with real coordinates
};

struct ScanCounts {
  std::uint64_t lines = 0;               ///< lines that meet an edge
  std::uint64_t studied = 0;             ///< lines studied by the span method, because:
  std::uint64_t studied_first = 0;       ///< the preceding line is unknown
  std::uint64_t studied_exchanges = 0;   ///< two edges were exchanged
  std::uint64_t studied_ends = 0;        ///< edges entered or ended, and no others were exchanged
  std::uint64_t segments = 0;            ///< segments on studied lines
  std::uint64_t entered = 0, ended = 0;  ///< edges
  std::uint64_t exchanges = 0;           ///< neighbours exchanged from one line to the next
  std::uint64_t passed_chains = 0;       ///< skipped changes: continued edges
  std::uint64_t passed_points = 0;       ///< skipped changes: hidden points
  std::uint64_t passed_exchanges =
      0;  ///< skipped exchanges with edges that stay hidden; on a studied line only those before the first visible one
  void operator+=(const ScanCounts& o) { add_counts(*this, o); }
};

/// An edge on the current line.
struct ActiveEdge {
  EdgeTrack track;
  double u = 0;                         ///< current position: the accumulator, or its nearest integer
  std::uint32_t edge = 0;               ///< edge of the scene
  bool boundary = false;                ///< true if it bounds a span
  bool entered = false;                 ///< true if it entered on this line
  std::uint32_t before = 0, after = 0;  ///< of a boundary: the spans to its left and right, or kNone
  std::uint32_t continues = 0;          ///< slot of the continuation of an ended edge, or kNone
};

/// Largest difference, in grid units, of coincident edges: it covers the rounding of their accumulators and is no exchange.
/// It is far above 2^-53 of the largest u, and far below a lattice step for any possible number of lines.
inline constexpr double kSamePlace = 0x1p-20;

/// A run between two active edges on which one face is visible.
struct LineSpan {
  std::uint32_t left, right;  ///< slots
  double u0, u1;
  std::uint32_t face;
};

class LineScan;
struct PreparedLine;

/// Receives every line.
class LineListener {
 public:
  virtual ~LineListener() = default;
  virtual void line(const LineScan& scan, std::uint32_t line, bool studied) = 0;
  /// No further line meets the edge of the slot.
  virtual void ended(const LineScan&, std::uint32_t) {}
  /// The edge of the slot passed behind that face without a study.
  virtual void hidden_point(const LineScan&, std::uint32_t, std::uint32_t) {}
};

struct SegmentEnds {
  std::uint32_t left, right;  ///< slots
  double u0, u1;
  std::uint32_t face;
};

class LineScan : private PairOrders {
 public:
  LineScan(const ScanScene& scene, const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
           std::span<const SweepLine> lines, const ScanOptions& options, LineListener& listener);

  /// Scans the lines [first, end).
  void scan(std::uint32_t first, std::uint32_t end);

  /// scan() in two tasks ([Boulle1980] 2.3.6.3), by two scans of the same options, without `recognise`: the one makes the
  /// segments of every line and says whether it has to be studied, the other studies it or carries its spans on.
  void begin_preparing(std::uint32_t first);
  void prepare(std::uint32_t line, PreparedLine& out);
  void begin_studying(std::uint32_t first);
  void study_prepared(PreparedLine& prepared);
  void finish_studying();

  const ScanScene& scene() const { return scene_; }
  const std::vector<std::uint32_t>& order() const { return order_; }  ///< slots sorted by u
  const ActiveEdge& active(std::uint32_t slot) const { return slots_[slot]; }
  const std::vector<LineSpan>& spans() const { return spans_; }
  /// Segments of the last studied line in real coordinates, in the order of the span method.
  const std::vector<ScanSegment<double>>& segments() const { return real_segments_; }
  std::uint32_t face_of(const ScanSegment<double>& segment) const { return ends_[segment.face].face; }
  const std::vector<std::uint32_t>& ended_edges() const {
    return ended_edges_;
  }  ///< edges that the preceding line met and this line does not
  const ScanCounts& counts() const { return counts_; }
  SpanCounts span_counts() const;

 private:
  void begin(std::uint32_t line);
  bool take_line(std::uint32_t line);
  void advance_edges(std::uint32_t line);
  bool has_opening() const;
  void count_study(bool first, bool exchanged);
  bool sort(std::uint32_t line);
  bool exchange_matters(std::uint32_t line, std::uint32_t to_the_left, std::uint32_t to_the_right);
  void put_apart();
  void sort_by_vertex();
  template <class Visit>
  void for_each_vertex(Visit visit) const;
  void link_chains();
  bool changes_matter(std::uint32_t line);
  bool vertex_matters(std::uint32_t line, std::span<const std::uint32_t> ended, std::span<const std::uint32_t> entered);
  bool flat_edge_matters(std::uint32_t line) const;
  bool behind_spans(std::uint32_t line, const ScanEdge& edge) const;
  bool bounds_a_penetration(std::uint32_t slot) const;
  bool behind_a_span(std::uint32_t line, std::span<const std::uint32_t> entered);
  bool behind(std::uint32_t line, const ActiveEdge& a, std::uint32_t face) const;
  bool same_faces(std::uint32_t a, std::uint32_t b) const;
  void follow_edges();
  /// Calls work(method, segments), with whole or real coordinates as the grid has them.
  template <class Work>
  void with_segments(const Work& work) {
    whole_ ? work(*whole_, whole_segments_) : work(*real_, real_segments_);
  }
  template <class X>
  void study_segments(SpanMethod<X>& method, const std::vector<ScanSegment<X>>& segments);
  template <class X>
  void collect_segments(std::vector<ScanSegment<X>>& segments);
  void place_spans(const std::vector<VisibleSpan>& found);
  std::uint32_t boundary_between(const VisibleSpan& left, const VisibleSpan& right);
  std::uint32_t penetration_edge(const VisibleSpan& left, const VisibleSpan& right);
  DepthOrder of(std::uint32_t a, std::uint32_t b) override {
    return face_orders_.of(ends_[a].face, ends_[b].face);
  }  ///< of segments
  std::uint32_t make_slot(std::uint32_t edge, const EdgeTrack& track);
  double key(double u) const { return scene_.grid.whole ? std::floor(u + 0.5) : u; }

  /// True for a segment that is a point on this line but not on the next: the corner of a face lies on the line. It has no
  /// span that could continue, and its edges bound nothing when they are exchanged.
  bool is_opening(const SegmentEnds& ends) const {
    return std::abs(ends.u1 - ends.u0) <= kSamePlace && slots_[ends.left].track.du != slots_[ends.right].track.du;
  }

  const ScanScene& scene_;
  std::span<const SweepLine> lines_;
  ScanOptions options_;
  LineListener& listener_;
  FaceOrders face_orders_;
  std::unique_ptr<SpanMethod<double>> real_;
  std::unique_ptr<SpanMethod<std::int32_t>> whole_;

  std::vector<ActiveEdge> slots_;
  std::vector<std::uint32_t> free_slots_, order_;
  std::vector<std::uint32_t> ended_, entered_;                      ///< slots on the current line, without continued edges
  std::vector<std::uint32_t> gone_;                                 ///< slots of all ended edges
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_vertex_;  ///< scratch of sort_by_vertex()
  std::vector<std::uint32_t> ended_edges_;
  bool must_study_ = true;                  ///< no spans to continue
  bool opens_ = false;                      ///< is_opening() for a segment of the last studied line
  bool bends_ = false;                      ///< a skew face penetrates another on the last studied line
  std::vector<std::uint32_t> penetrating_;  ///< faces in a penetration without an edge
  std::vector<LineSpan> spans_;

  std::vector<std::uint32_t> open_;  ///< by face: 1 + its open segment
  std::vector<SegmentEnds> ends_;    ///< by segment
  std::vector<ScanSegment<double>> real_segments_;
  std::vector<ScanSegment<std::int32_t>> whole_segments_;
  std::vector<VisibleSpan> found_;
  std::uint64_t sort_swaps_ = 0;
  bool prepared_ = false;       ///< by another scan: no slots can be made
  std::uint32_t any_slot_ = 0;  ///< then: stands for penetrations without an edge
  ScanCounts counts_;
};

}  // namespace ligne::watkins
