#include "picture/clear/tidy_strokes.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/no_index.hpp"
#include "drawing/cleanup/flecks.hpp"
#include "drawing/cleanup/inked_bits.hpp"
#include "drawing/cleanup/loose_ends.hpp"
#include "drawing/cleanup/short_bits.hpp"
#include "drawing/cleanup/short_ends.hpp"
#include "drawing/cleanup/smooth_lines.hpp"
#include "drawing/cleanup/spurs.hpp"
#include "drawing/drawing.hpp"
#include "view/tolerances.hpp"

namespace ligne {
namespace {

// Adjustable, in widths of the pen.
constexpr double kLeastInPens = 1.5;
constexpr double kGapInPens = 1;              ///< a wider gap shows between the round ends of two strokes
constexpr double kWideInGaps = 3;             ///< a gap that shows, in a line that goes straight on
constexpr double kFarInGaps = 12;             ///< and among outlines
constexpr double kShortInPens = 3;            ///< what ends short of a line
constexpr double kTouchingInPens = 1.0 / 16;  ///< ends that lie on a line
constexpr double kInkInPens = 0.5;            ///< to either side of a line
constexpr double kShownInPens = 0.5;          ///< of a bit beside the ink of other lines
/// Lines whose ink meets; on scans, without spurs, they go on from one to the other there.
constexpr double kMeetingInPens = 1;
constexpr double kFleckInPens = 8;
constexpr double kFleckPart = 1.0 / 48;  ///< of the extent of its body
constexpr double kRingInPens = 0.25;     ///< a ring so narrow is drawn as one line
constexpr double kLoneInPens = 5;        ///< a line that meets no other, of any body
constexpr double kSpurInPens = 12;
constexpr double kSpurPart = 1.0 / 32;
constexpr double kBesideInPens = 2.5;
constexpr double kBrokenInPens = 4;   ///< a gap in an outline of a scan
constexpr double kBesideInSpurs = 4;  ///< what runs beside a line, in spurs that do not

/// The number of the scan that a stroke belongs to, kNone for other objects.
std::uint32_t scan_of(const std::vector<ScanObject>& scans, const StrokeModel& strokes, const Stroke& s) {
  const bool is_edge = s.source < strokes.edge_count;
  const std::uint32_t number = is_edge ? s.source : strokes.intersections[s.source - strokes.edge_count].faces[0];
  const auto end_of = [&](const ScanObject& scan) { return is_edge ? scan.edge_end : scan.face_end; };
  const auto scan = std::ranges::upper_bound(scans, number, {}, end_of);
  if (scan == scans.end() || number < (is_edge ? scan->edge_begin : scan->face_begin)) return kNone;
  return static_cast<std::uint32_t>(scan - scans.begin());
}

/// The number of the object that a stroke belongs to.
std::uint32_t object_of(const PreparedScene& prepared, const StrokeModel& strokes, const Stroke& s) {
  if (s.source < strokes.edge_count) {
    const auto& ends = prepared.object_edge_ends;
    const auto end = std::ranges::upper_bound(ends, s.source);
    return end == ends.end() ? kNone : static_cast<std::uint32_t>(end - ends.begin());
  }
  const std::vector<Object>& objects = prepared.scene.objects;
  const std::uint32_t face = strokes.intersections[s.source - strokes.edge_count].faces[0];
  const auto object = std::ranges::upper_bound(objects, face, {}, &Object::face_end);
  return object == objects.end() ? kNone : static_cast<std::uint32_t>(object - objects.begin());
}

/// Makes sources of strokes that join lines, on the faces of the line.
class JointSources {
 public:
  JointSources(const StrokeModel& strokes, const ProjectedScene& scene) : strokes_(strokes), scene_(scene) {}

  SourceEdge operator()(const Stroke& joint) {
    SourceEdge source;
    source.ends = {to_model_point(scene_.view, strokes_.lattice.to_mm(joint.from), joint.z_from),
                   to_model_point(scene_.view, strokes_.lattice.to_mm(joint.to), joint.z_to)};
    if (joint.source >= strokes_.edge_count) {
      source.faces = strokes_.intersections[joint.source - strokes_.edge_count].faces;
      return source;
    }
    if (!filed_) {
      edge_of_.assign(scene_.source_count, kNone);
      for (std::uint32_t e = 0; e < scene_.edges.size(); ++e) edge_of_[scene_.edges[e].source] = e;
      filed_ = true;
    }
    const std::uint32_t edge = edge_of_[joint.source];
    if (edge != kNone) source.faces = {scene_.edges[edge].face0, scene_.edges[edge].face1};
    return source;
  }

 private:
  const StrokeModel& strokes_;
  const ProjectedScene& scene_;
  std::vector<std::uint32_t> edge_of_;  ///< by source
  bool filed_ = false;
};

/// Keeps the visible strokes of class mesh apart while the others are tidied, and puts them back behind these. They are no
/// lines of the shape: among the edges of all faces every line would meet others everywhere.
class MeshApart {
 public:
  explicit MeshApart(StrokeModel& model) : strokes_(model.strokes) {
    const auto is_other = [](const Stroke& s) { return !s.visible || s.line_class != LineClass::mesh; };
    const auto others = std::stable_partition(strokes_.begin(), strokes_.end(), is_other);
    mesh_.assign(others, strokes_.end());
    strokes_.erase(others, strokes_.end());
  }
  ~MeshApart() { strokes_.insert(strokes_.end(), mesh_.begin(), mesh_.end()); }
  /// Does it to the mesh alone.
  template <class Work>
  void change(Work work) {
    strokes_.swap(mesh_);
    work();
    strokes_.swap(mesh_);
  }
  MeshApart(const MeshApart&) = delete;
  MeshApart& operator=(const MeshApart&) = delete;

 private:
  std::vector<Stroke>& strokes_;
  std::vector<Stroke> mesh_;
};

void count(RunReport& run, const char* name, std::size_t n) {
  if (n > 0) run.clear.count(name, n);
}

void drop_lone_flecks(StrokeModel& strokes, const PreparedScene& prepared, RunReport& run) {
  const LineRequest& lines = prepared.request.lines;
  const double pen_mm = prepared.request.page.pen_width_mm;
  const LineClasses features = LineClasses::features();
  // Where a class is left out, what its lines would meet stands alone.
  if ((lines.studied().bits & features.bits) != features.bits) return;
  const auto object = [&](const Stroke& s) { return object_of(prepared, strokes, s); };
  count(run, "lone flecks left out",
        drop_flecks(strokes, object,
                    {.longest_mm = kLoneInPens * pen_mm,
                     .body_part = kFleckPart,
                     .touching_mm = kMeetingInPens * pen_mm,
                     .classes = features,
                     .most_ends_on_lines = 0,
                     .ring_width_mm = kRingInPens * pen_mm}));
}

/// Tidies strokes none of which coincide, and none of which are of the mesh.
void tidy_lines(StrokeModel& strokes, const PreparedScene& prepared, double least_mm, double gap_mm, RunReport& run) {
  const double pen_mm = prepared.request.page.pen_width_mm;
  const bool has_outlines = prepared.request.lines.studied().has(LineClass::outline);
  const auto scan = [&](const Stroke& s) { return scan_of(prepared.scans, strokes, s); };
  if (!prepared.scans.empty()) {
    count(run, "points of creases smoothed",
          smooth_lines(strokes, [&](const Stroke& s) { return s.line_class == LineClass::crease && scan(s) != kNone; }));
  }
  JointSources make_source(strokes, prepared.projected);
  // Without outlines nothing tells that a line passes behind something.
  const double wide_mm = (has_outlines ? kFarInGaps : kWideInGaps) * gap_mm;
  const auto join = [&] { return join_loose_ends(strokes, {gap_mm, wide_mm, kInkInPens * pen_mm}, std::ref(make_source)); };
  std::size_t joined = join();
  if (!prepared.scans.empty()) {
    count(run, "spurs of scans left out",
          drop_spurs(strokes, scan,
                     {.longest_mm = kSpurInPens * pen_mm,
                      .body_part = kSpurPart,
                      .beside_mm = kBesideInPens * pen_mm,
                      .beside_times = kBesideInSpurs,
                      .touching_mm = kMeetingInPens * pen_mm,
                      .gap_mm = kBrokenInPens * pen_mm}));
    joined += join();
  }
  count(run, "loose ends joined", joined);
  count(run, "short bits of another class than their line", join_short_classes(strokes, least_mm));
  count(run, "short bits of lines left out", drop_short_bits(strokes, least_mm));
  count(run, "short bits in the ink of other lines",
        drop_inked_bits(strokes, {least_mm, kInkInPens * pen_mm, kShownInPens * pen_mm}));
  if (!prepared.scans.empty()) {
    count(run, "flecks of scans left out",
          drop_flecks(strokes, scan, {kFleckInPens * pen_mm, kFleckPart, kMeetingInPens * pen_mm}));
  }
  if (!has_outlines) return;
  drop_lone_flecks(strokes, prepared, run);
  count(run, "ends led to the line before them",
        extend_short_ends(strokes, {kShortInPens * gap_mm, kTouchingInPens * pen_mm}, std::ref(make_source)));
}

}  // namespace

void tidy_strokes(StrokeModel& strokes, const PreparedScene& prepared, RunReport& run) {
  const LineRequest& lines = prepared.request.lines;
  const double pen_mm = prepared.request.page.pen_width_mm, coincidence = coincidence_mm(prepared.projected);
  const bool clear = lines.quality == Quality::clear;
  const double least_mm = lines.least_mm.value_or(clear ? kLeastInPens * pen_mm : 0);
  const double gap_mm = std::min(least_mm, kGapInPens * pen_mm);
  if (least_mm > 0) count(run, "short gaps closed", close_short_gaps(strokes, gap_mm));
  remove_coincident_strokes(strokes, coincidence);
  if (least_mm == 0) return;
  if (!clear) {
    count(run, "short bits of lines left out", drop_short_bits(strokes, least_mm));
    return;
  }
  MeshApart mesh(strokes);
  if (lines.least_mm) {
    mesh.change([&] { count(run, "short bits of the mesh left out", drop_short_bits(strokes, least_mm)); });
  }
  tidy_lines(strokes, prepared, least_mm, gap_mm, run);
}

}  // namespace ligne
