#include "visibility/edges/line_strokes.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>
#include <utility>

#include "base/no_index.hpp"

namespace ligne {
namespace {

constexpr std::size_t kLinesPerBlock = 1024;  ///< lines that one thread studies at a time

LatticePoint point(const PageLine& line, double t) {
  if (t == 0) return line.p0;
  if (t == 1) return line.p1;
  return {static_cast<std::int32_t>(std::lround(line.p0.x + t * line.dx)),
          static_cast<std::int32_t>(std::lround(line.p0.y + t * line.dy))};
}

double page_length(const PageLine& line) { return std::sqrt(line.dx * line.dx + line.dy * line.dy); }

Point3 to_model(const ProjectedScene& scene, const ProjectedVertex& v) {
  return to_model_point(scene.view, scene.lattice.to_mm(v.p), v.z);
}

/// Strokes whose source is `scene.source_count` + i come from intersections[i]. Numbers the intersections that have
/// strokes, without gaps, and lists them in the model.
void number_intersections(const ProjectedScene& scene, const std::vector<Intersection>& intersections, StrokeModel& model) {
  std::vector<std::uint32_t> number(intersections.size(), kNone);
  for (Stroke& s : model.strokes) {
    if (s.source < scene.source_count) continue;
    const std::uint32_t i = s.source - scene.source_count;
    if (number[i] == kNone) {
      number[i] = static_cast<std::uint32_t>(model.intersections.size());
      const Intersection& x = intersections[i];
      model.intersections.push_back({{to_model(scene, x.from), to_model(scene, x.to)}, {x.face0, x.face1}, true});
    }
    s.source = scene.source_count + number[i];
  }
}

}  // namespace

LineStrokes::LineStrokes(const ProjectedScene& scene, const Facets& facets, bool hidden_too, double shortest_steps)
    : scene_(scene), facets_(facets), hidden_too_(hidden_too), shortest_(shortest_steps) {
  model_.lattice = scene.lattice;
  model_.edge_count = scene.source_count;
}

template <class LineOf>
void LineStrokes::add(std::size_t count, MakeLineVisibility make, const std::function<void(double)>& progress,
                      LineOf line_of) {
  std::vector<Block> made(block_count(count, kLinesPerBlock));
  std::mutex progress_mutex;
  std::size_t done = 0;
  parallel_blocks(count, kLinesPerBlock, [&](std::size_t begin, std::size_t end) {
    const LineVisibility visibility = make();
    Block& out = made[begin / kLinesPerBlock];
    std::vector<LinePart> parts;
    for (std::size_t i = begin; i < end; ++i) {
      auto [line, origin] = line_of(i);
      if (line.p0 == line.p1) continue;  // seen end on
      parts.clear();
      const bool near = visibility(i, line, parts);
      assert(are_ascending(parts));
      origin.needs_overlap_check = origin.needs_overlap_check || near;
      drop_short_parts(parts, page_length(line), shortest_);
      add_parts(line, parts, origin, out);
    }
    if (!progress) return;
    const std::lock_guard lock(progress_mutex);
    progress(static_cast<double>(++done) / static_cast<double>(made.size()));
  });
  append_blocks(made);
}

/// Appends the strokes of all blocks to the model.
void LineStrokes::append_blocks(std::vector<Block>& blocks) {
  std::vector<Stroke>& strokes = model_.strokes;
  std::vector<std::size_t> first(blocks.size() + 1, strokes.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) first[b + 1] = first[b] + blocks[b].strokes.size();
  strokes.resize(first.back());
  parallel_for(blocks.size(), [&](std::size_t b) {
    std::copy(blocks[b].strokes.begin(), blocks[b].strokes.end(), strokes.begin() + static_cast<std::ptrdiff_t>(first[b]));
    std::vector<Stroke>().swap(blocks[b].strokes);
  });
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (const std::size_t stroke : blocks[b].hidden) counted_.hidden.push_back(first[b] + stroke);
    counted_.counted.insert(counted_.counted.end(), blocks[b].counted.begin(), blocks[b].counted.end());
  }
}

StrokeModel LineStrokes::take() {
  std::vector<HiddenPart>& parts = model_.hidden_parts;
  for (std::size_t i = 0; i < counted_.hidden.size(); ++i) {
    const Stroke& s = model_.strokes[counted_.hidden[i]];
    parts.push_back({s.source, s.t_from, s.t_to, counted_.counted[i]->count, counted_.counted[i]->faces});
  }
  std::sort(parts.begin(), parts.end(), [](const HiddenPart& a, const HiddenPart& b) {
    return std::pair(a.source, a.t_from) < std::pair(b.source, b.t_from);
  });
  return std::move(model_);
}

void LineStrokes::add_edges(MakeLineVisibility make, const std::function<void(double)>& progress,
                            const CountedLines* counted) {
  add(scene_.edges.size(), make, progress, [&](std::size_t i) {
    const ProjectedEdge& edge = scene_.edges[i];
    const auto range = scene_.edge_parts.empty() ? std::array<double, 2>{0, 1} : scene_.edge_parts[i];
    return std::pair(PageLine(scene_.vertices[edge.v0], scene_.vertices[edge.v1], edge.face0, edge.face1),
                     Origin{edge.source, edge.line_class, range, is_thin(edge.face0) || is_thin(edge.face1),
                            counted ? &(*counted)[i] : nullptr});
  });
}

void LineStrokes::add_intersections(const std::vector<Intersection>& intersections, MakeLineVisibility make,
                                    const CountedLines* counted) {
  add(intersections.size(), make, {}, [&](std::size_t i) {
    const Intersection& s = intersections[i];
    return std::pair(PageLine(s.from, s.to, s.face0, s.face1), Origin{scene_.source_count + static_cast<std::uint32_t>(i),
                                                                      LineClass::intersection,
                                                                      {0, 1},
                                                                      true,
                                                                      counted ? &(*counted)[i] : nullptr});
  });
  number_intersections(scene_, intersections, model_);
}

void LineStrokes::add_parts(const PageLine& line, const std::vector<LinePart>& parts, const Origin& origin,
                            Block& out) const {
  double end = 0;
  for (const LinePart& part : parts) {
    if (hidden_too_ && part.from > end) add_hidden(line, {end, part.from}, origin, out);
    out.strokes.push_back(stroke(line, part, origin, true));
    end = part.to;
  }
  if (hidden_too_ && end < 1) add_hidden(line, {end, 1}, origin, out);
}

/// A piece too short for the page joins the piece before it; the first piece joins the next one.
void LineStrokes::add_hidden(const PageLine& line, LinePart gap, const Origin& origin, Block& out) const {
  struct Piece {
    LinePart part;
    const CountedPart* counted = nullptr;
  };
  std::vector<Piece> pieces;
  const double least = shortest_ / page_length(line);
  if (origin.counted) {
    for (const CountedPart& part : *origin.counted) {
      const double from = std::max(part.from, gap.from), to = std::min(part.to, gap.to);
      if (part.count == 0 || !(from < to)) continue;
      if (!pieces.empty() && (to - from < least || pieces.back().counted->is_like(part))) continue;
      if (pieces.size() == 1 && from - gap.from < least) pieces.clear();
      pieces.push_back({{pieces.empty() ? gap.from : from, gap.to, part.count}, &part});
      if (pieces.size() > 1) pieces[pieces.size() - 2].part.to = from;
    }
  }
  if (pieces.empty()) pieces.push_back({gap});
  for (const Piece& piece : pieces) {
    if (piece.counted) {
      out.hidden.push_back(out.strokes.size());
      out.counted.push_back(piece.counted);
    }
    out.strokes.push_back(stroke(line, piece.part, origin, false));
  }
}

Stroke LineStrokes::stroke(const PageLine& line, LinePart part, const Origin& origin, bool visible) const {
  Stroke s{.t_from = origin.range[0] + (origin.range[1] - origin.range[0]) * model_parameter(line, part.from),
           .t_to = origin.range[0] + (origin.range[1] - origin.range[0]) * model_parameter(line, part.to),
           .from = point(line, part.from),
           .to = point(line, part.to),
           .z_from = static_cast<float>(line.z(part.from)),
           .z_to = static_cast<float>(line.z(part.to))};
  if (scene_.view.camera.perspective) {
    s.w_from = static_cast<float>(1 / scene_.magnification(line.z(part.from)));
    s.w_to = static_cast<float>(1 / scene_.magnification(line.z(part.to)));
  }
  s.source = origin.source;
  s.line_class = origin.line_class;
  s.visible = visible;
  s.level = static_cast<std::uint8_t>(std::min(part.level, 255u));
  // The search stops when a line is hidden, before it has seen all neighbours.
  s.needs_overlap_check = origin.needs_overlap_check || !visible;
  return s;
}

/// Converts the page parameter t to the parameter in model space. The weights are the distances along the viewing
/// direction, which are one over the magnifications.
double LineStrokes::model_parameter(const PageLine& line, double t) const {
  if (!scene_.view.camera.perspective || t == 0 || t == 1) return t;
  const double m0 = scene_.magnification(line.z0), m1 = scene_.magnification(line.z1);
  return t * m1 / ((1 - t) * m0 + t * m1);
}

}  // namespace ligne
