#pragma once
/// The scan by lines: which edges a line meets, what is seen on it, and which lines need no study at all
/// ([Boulle1980] 2.3.2, 2.3.5).
///
/// Invariants, on every line after it was taken: the active list is ordered by u; the spans are those that a full study of
/// the line would give (their ends follow the edges that bound them); an edge is marked as a boundary exactly when it bounds
/// a span.
///
/// A line is studied anew only where something changes that can be seen: an edge enters or ends, two edges change places.
/// Changes among hidden elements are recognised and passed over (figure 2.59): an edge whose end goes on in another one of
/// the same faces, points that appear behind the span that they lie in, ends of edges that bound nothing, exchanges of two
/// such edges, and of one with the end of a span when the next span hides it too. Faces that touch keep their order on all
/// lines (FaceOrders). Where faces penetrate, their common line is an edge of the scene like any other, so it enters,
/// crosses and ends as one. A penetration without such an edge gets one for the time until the next study: it goes straight
/// on, and where one of the two faces gains or loses an edge a line is studied.

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "visibility/watkins/scan_scene.hpp"
#include "visibility/watkins/spans/span_method.hpp"

namespace ligne::watkins {

struct ScanOptions {
  SpanMethodKind kind = SpanMethodKind::stack;
  bool coherence = true;       ///< pass over lines on which nothing changes
  bool recognise = true;       ///< and over changes among hidden elements
  bool sorted = true;          ///< segments by the full key; otherwise as their faces come
  SpanTrace* trace = nullptr;  ///< records studies on real coordinates
};

struct ScanCounts {
  std::uint64_t lines = 0;               ///< lines that meet an edge
  std::uint64_t studied = 0;             ///< of them: by the span method, and of these:
  std::uint64_t studied_first = 0;       ///< nothing is known of the line before
  std::uint64_t studied_exchanges = 0;   ///< two edges changed places
  std::uint64_t studied_ends = 0;        ///< edges entered or ended, and no others changed places
  std::uint64_t segments = 0;            ///< on studied lines
  std::uint64_t entered = 0, ended = 0;  ///< edges
  std::uint64_t exchanges = 0;           ///< neighbours that changed places from one line to the next
  std::uint64_t passed_chains = 0;       ///< changes that altered nothing: an edge goes on in another
  std::uint64_t passed_points = 0;       ///< hidden points
  std::uint64_t passed_exchanges =
      0;  ///< exchanges with edges that stay hidden; on a line to be studied only those before the first that can be seen
  void operator+=(const ScanCounts& o);
};

/// An edge on the line at hand.
struct ActiveEdge {
  EdgeTrack track;
  double u = 0;                         ///< where it is: the accumulator, or the whole number nearest to it
  std::uint32_t edge = 0;               ///< of the scene
  bool boundary = false;                ///< bounds a span
  bool entered = false;                 ///< on this line
  std::uint32_t before = 0, after = 0;  ///< of a boundary: the spans left and right of it, or kNone
  std::uint32_t continues = 0;          ///< slot of the edge in which it goes on, when it has ended; or kNone
};

/// Edges on one line of the page have accumulators that differ by their roundings; that is no exchange. In grid units: far
/// above 2^-53 of the largest u, far below a lattice step at any number of lines that a page can have.
inline constexpr double kSamePlace = 0x1p-20;

/// A run on which one face is seen, between two active edges.
struct LineSpan {
  std::uint32_t left, right;  ///< slots
  double u0, u1;
  std::uint32_t face;
};

class LineScan;

/// Gets every line.
class LineListener {
 public:
  virtual ~LineListener() = default;
  virtual void line(const LineScan& scan, std::uint32_t line, bool studied) = 0;
  virtual void ended(const LineScan& scan, std::uint32_t slot) = 0;  ///< the edge of the slot is met by no further line
  virtual void hidden_point(const LineScan& scan, std::uint32_t slot,
                            std::uint32_t face) = 0;  ///< an edge came behind that face, unstudied
};

class LineScan : private PairOrders {
 public:
  LineScan(const ScanScene& scene, const std::vector<ProjectedVertex>& vertices, const std::vector<Facet>& facets,
           std::span<const SweepLine> lines, const ScanOptions& options, LineListener& listener);

  /// Lines [first, end).
  void scan(std::uint32_t first, std::uint32_t end);

  const ScanScene& scene() const { return scene_; }
  const std::vector<std::uint32_t>& order() const { return order_; }  ///< slots by u
  const ActiveEdge& active(std::uint32_t slot) const { return slots_[slot]; }
  const std::vector<LineSpan>& spans() const { return spans_; }
  /// Segments of the line studied last, on real coordinates, in the order of the span method.
  const std::vector<ScanSegment<double>>& segments() const { return real_segments_; }
  std::uint32_t face_of(const ScanSegment<double>& segment) const { return ends_[segment.face].face; }
  const std::vector<std::uint32_t>& ended_edges() const {
    return ended_edges_;
  }  ///< edges that the line before met, and this one does not
  const ScanCounts& counts() const { return counts_; }
  SpanCounts span_counts() const;

 private:
  void begin(std::uint32_t line);
  bool take_line(std::uint32_t line);
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
  template <class X>
  void study_line(SpanMethod<X>& method);
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

  struct SegmentEnds {
    std::uint32_t left, right;  ///< slots
    double u0, u1;
    std::uint32_t face;
  };
  /// A segment that is a point on this line and not on the next one: the corner of a face lies on the line. No span of it is
  /// found, so none can be carried on, and its edges bound nothing when they change places.
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
  std::vector<std::uint32_t> ended_, entered_;  ///< slots, on the line at hand; without edges that go on in others
  std::vector<std::uint32_t> gone_;             ///< slots of all edges that ended
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_vertex_;  ///< working memory of sort_by_vertex()
  std::vector<std::uint32_t> ended_edges_;
  bool must_study_ = true;                  ///< there is nothing to be carried on
  bool opens_ = false;                      ///< is_opening() for some segment of the line studied last
  std::vector<std::uint32_t> penetrating_;  ///< faces that meet in a penetration without an edge
  std::vector<LineSpan> spans_;

  std::vector<std::uint32_t> open_;  ///< by face: segment that has begun, plus one
  std::vector<SegmentEnds> ends_;    ///< by segment
  std::vector<ScanSegment<double>> real_segments_;
  std::vector<ScanSegment<std::int32_t>> whole_segments_;
  std::vector<VisibleSpan> found_;
  std::uint64_t sort_swaps_ = 0;
  ScanCounts counts_;
};

}  // namespace ligne::watkins
