#include "visibility/watkins/transparent_spans.hpp"

#include <algorithm>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"

namespace ligne::watkins {
namespace {

using Segment = ScanSegment<double>;

/// The scan needs a listener, but prepares lines without one.
class NoListener final : public LineListener {
 public:
  void line(const LineScan&, std::uint32_t, bool) override {}
};

/// Composes the spans of single lines. Invariant: `active_` has the transparent segments over the current gap, from
/// front to back right of its left end.
class TransparentLineSpans final : private PairOrders {
 public:
  TransparentLineSpans(const ProjectedScene& scene, const std::vector<Facet>& facets, const ScanScene& scan_scene,
                       SpanMethodKind kind)
      : scene_(scene),
        scan_scene_(scan_scene),
        face_orders_(scene.vertices, facets, scan_scene.of_faces, scan_scene.skew),
        method_(make_span_method<double>(kind)) {
    method_->ask(this);
  }

  void compose(const PreparedLine& line) {
    line_ = &line;
    opaque_.clear();
    transparent_.clear();
    stops_.clear();
    active_.clear();
    for (const Segment& s : line.real_segments) {
      if (s.x0 < s.x1) (is_transparent(face_of(s)) ? transparent_ : opaque_).push_back(s);
    }
    std::ranges::sort(transparent_, {}, [](const Segment& s) { return std::pair(s.x0, s.face); });
    method_->study(opaque_, found_);
    for (const VisibleSpan& s : found_) stops_.insert(stops_.end(), {s.x0, s.x1});
    for (const Segment& s : transparent_) stops_.insert(stops_.end(), {s.x0, s.x1});
    std::ranges::sort(stops_);
    stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
    walk();
  }

  std::vector<Span> spans;
  TransparentLayers layers;

 private:
  DepthOrder of(std::uint32_t a, std::uint32_t b) override {
    return face_orders_.of(line_->ends[a].face, line_->ends[b].face);
  }
  std::uint32_t face_of(const Segment& s) const { return line_->ends[s.face].face; }
  bool is_transparent(std::uint32_t face) const {
    return face < scene_.face_is_transparent.size() && scene_.face_is_transparent[face] != 0;
  }
  DepthComparison compare(const Segment& a, const Segment& b, double from, double to) {
    return compare_depths(a, b, from, to, counts_, this);
  }

  void walk() {
    std::size_t next_opaque = 0, next_transparent = 0;
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      const double from = stops_[i], to = stops_[i + 1];
      std::erase_if(active_, [&](std::uint32_t g) { return transparent_[g].x1 <= from; });
      for (; next_transparent < transparent_.size() && transparent_[next_transparent].x0 <= from; ++next_transparent) {
        active_.push_back(static_cast<std::uint32_t>(next_transparent));
      }
      while (next_opaque < found_.size() && found_[next_opaque].x1 <= from) ++next_opaque;
      const bool covered = next_opaque < found_.size() && found_[next_opaque].x0 <= from;
      study_gap(from, to, covered ? &opaque_[found_[next_opaque].segment] : nullptr);
    }
  }

  /// No segment begins or ends within the gap; those that cross divide it.
  void study_gap(double from, double end, const Segment* opaque) {
    while (from < end && (opaque || !active_.empty())) {
      sort_active(from, end);
      double to = end;
      for (std::size_t i = 1; i < active_.size(); ++i) {
        const DepthComparison c = compare(transparent_[active_[i - 1]], transparent_[active_[i]], from, end);
        if (c.order == DepthOrder::crossing) to = std::min(to, c.x);
      }
      in_front_.clear();
      for (const std::uint32_t g : active_) {
        if (opaque) {
          const DepthComparison c = compare(transparent_[g], *opaque, from, end);
          if (c.order == DepthOrder::crossing) to = std::min(to, c.x);
          if (!c.begins_with_first()) continue;
        }
        in_front_.push_back(face_of(transparent_[g]));
      }
      std::uint32_t list = TransparentLayers::kEmptyList;
      for (auto face = in_front_.rbegin(); face != in_front_.rend(); ++face) list = layers.over(*face, list);
      give(from, to, opaque ? face_of(*opaque) : kNone, list);
      from = to;
    }
  }

  /// Insertion sort: from gap to gap the order hardly changes.
  void sort_active(double from, double end) {
    for (std::size_t i = 1; i < active_.size(); ++i) {
      const std::uint32_t moving = active_[i];
      std::size_t k = i;
      for (; k > 0 && !compare(transparent_[active_[k - 1]], transparent_[moving], from, end).begins_with_first(); --k) {
        active_[k] = active_[k - 1];
      }
      active_[k] = moving;
    }
  }

  void give(double u0, double u1, std::uint32_t face, std::uint32_t list) {
    const Rect& window = scene_.view.window;  // faces extend slightly beyond the window
    const auto mm = [&](double u) {
      return std::clamp(scene_.lattice.origin_mm.x + scan_scene_.grid.x(u) * scene_.lattice.step_mm, window.min.x,
                        window.max.x);
    };
    const double from = mm(u0), to = mm(u1);
    if (!(from < to)) return;
    if (!spans.empty()) {
      Span& last = spans.back();
      if (last.line == line_->line && last.face == face && last.in_front == list && last.x_to == from) {
        last.x_to = to;
        return;
      }
    }
    spans.push_back({line_->line, from, to, face, list});
  }

  const ProjectedScene& scene_;
  const ScanScene& scan_scene_;
  FaceOrders face_orders_;
  std::unique_ptr<SpanMethod<double>> method_;
  const PreparedLine* line_ = nullptr;
  std::vector<Segment> opaque_, transparent_;
  std::vector<VisibleSpan> found_;
  std::vector<double> stops_;
  std::vector<std::uint32_t> active_, in_front_;
  SpanCounts counts_;
};

}  // namespace

SpanModel transparent_spans(const ProjectedScene& scene, const std::vector<Facet>& facets, const LineGrid& grid,
                            const SpanLines& lines, const LineStudyOptions& options) {
  constexpr std::uint32_t kGroups = 32;
  const ScanScene scan_scene = make_scan_scene(scene, facets, {}, grid, options.coincidence_steps, options.skew);
  const std::uint32_t size = std::max(1u, (grid.count + kGroups - 1) / kGroups), groups = (grid.count + size - 1) / size;
  ScanOptions scan_options = options.scan;
  scan_options.recognise = false;
  std::vector<SpanModel> found(groups);
  parallel_tasks(groups, [&](std::size_t group) {
    const auto first = static_cast<std::uint32_t>(group) * size;
    NoListener listener;
    LineScan scan(scan_scene, scene.vertices, facets, {}, scan_options, listener);
    TransparentLineSpans composer(scene, facets, scan_scene, options.scan.kind);
    PreparedLine prepared;
    scan.begin_preparing(first);
    for (std::uint32_t line = first; line < std::min(grid.count, first + size); ++line) {
      scan.prepare(line, prepared);
      composer.compose(prepared);
    }
    found[group] = {lines, std::move(composer.spans), std::move(composer.layers)};
  });
  SpanModel model;
  model.lines = lines;
  for (const SpanModel& part : found) {
    const std::vector<std::uint32_t> numbers = model.layers.merge(part.layers);
    for (Span span : part.spans) {
      span.in_front = numbers[span.in_front];
      model.spans.push_back(span);
    }
  }
  return model;
}

}  // namespace ligne::watkins
