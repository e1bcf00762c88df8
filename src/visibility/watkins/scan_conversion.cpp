#include "visibility/watkins/scan_conversion.hpp"

#include <algorithm>
#include <utility>

namespace ligne::watkins {

EdgeTrack EdgeTrack::between(GridPoint a, GridPoint b, std::uint32_t line_count) {
  if (b.v < a.v) std::swap(a, b);
  const auto line_from = [line_count](double v) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(v), 0.0, double(line_count)));
  };
  EdgeTrack t;
  t.first = line_from(a.v);
  t.last = line_from(b.v);
  if (t.first == t.last) {
    t.u = a.u;
    t.z = a.z;
    t.du = b.u - a.u;
    t.dz = b.z - a.z;
    return t;
  }
  t.du = (b.u - a.u) / (b.v - a.v);
  t.dz = (b.z - a.z) / (b.v - a.v);
  const double down = t.first - a.v;
  t.u = a.u + down * t.du;
  t.z = a.z + down * t.dz;
  return t;
}

EdgeTrack EdgeTrack::on(std::uint32_t line) const {
  EdgeTrack t = *this;
  t.u += (double(line) - first) * du;
  t.z += (double(line) - first) * dz;
  return t;
}

std::vector<PolygonRun> scan_polygon(std::span<const GridPoint> corners, std::span<const std::uint32_t> contour_end,
                                     std::uint32_t line_count) {
  // The table of edges by first line: one sort does for the buckets.
  std::vector<EdgeTrack> table;
  table.reserve(corners.size());
  std::uint32_t begin = 0;
  for (const std::uint32_t end : contour_end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const EdgeTrack t = EdgeTrack::between(corners[i], corners[i + 1 == end ? begin : i + 1], line_count);
      if (t.first < t.last) table.push_back(t);
    }
    begin = end;
  }
  std::stable_sort(table.begin(), table.end(), [](const EdgeTrack& a, const EdgeTrack& b) { return a.first < b.first; });

  std::vector<PolygonRun> runs;
  std::vector<EdgeTrack> active;
  std::size_t next = 0;
  for (std::uint32_t line = table.empty() ? 0 : table.front().first; next < table.size() || !active.empty(); ++line) {
    std::erase_if(active, [line](const EdgeTrack& t) { return t.last == line; });
    for (EdgeTrack& t : active) t.advance();
    for (; next < table.size() && table[next].first == line; ++next) active.push_back(table[next]);
    // Almost in order: insertion costs little more than looking.
    for (std::size_t i = 1; i < active.size(); ++i) {
      for (std::size_t k = i; k > 0 && active[k].u < active[k - 1].u; --k) std::swap(active[k], active[k - 1]);
    }
    for (std::size_t i = 0; i + 1 < active.size(); i += 2) {
      runs.push_back({line, active[i].u, active[i + 1].u, active[i].z, active[i + 1].z});
    }
    if (active.empty() && next < table.size()) line = table[next].first - 1;
  }
  return runs;
}

}  // namespace ligne::watkins
