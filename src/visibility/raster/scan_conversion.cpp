#include "visibility/raster/scan_conversion.hpp"

#include <utility>

namespace ligne {

EdgeTrack EdgeTrack::between(GridPoint a, GridPoint b, std::uint32_t line_count) {
  if (b.v < a.v) std::swap(a, b);
  const auto line_from = [line_count](double v) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(v), 0.0, double(line_count)));
  };
  EdgeTrack t{.first = line_from(a.v), .last = line_from(b.v)};
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

void PolygonScan::add(const GridPoint& a, const GridPoint& b) {
  EdgeTrack t = EdgeTrack::between(a, b, end_);
  if (t.first < first_) {
    if (t.last <= first_) return;
    t = t.on(first_);
    t.first = first_;
  }
  if (t.first < t.last) table_.push_back(t);
}

void PolygonScan::take_active(std::uint32_t line, std::size_t& next) {
  std::erase_if(active_, [line](const EdgeTrack& t) { return t.last == line; });
  for (EdgeTrack& t : active_) t.advance();
  // The sides are almost in order, so insertion sort costs little more than a check.
  for (std::size_t i = 1; i < active_.size(); ++i) {
    for (std::size_t k = i; k > 0 && active_[k].u < active_[k - 1].u; --k) std::swap(active_[k], active_[k - 1]);
  }
  const auto before = static_cast<std::ptrdiff_t>(active_.size());
  for (; next < table_.size() && table_[next].first == line; ++next) active_.push_back(table_[next]);
  const auto to_the_left = [](const EdgeTrack& a, const EdgeTrack& b) { return a.u < b.u; };
  std::sort(active_.begin() + before, active_.end(), to_the_left);
  std::inplace_merge(active_.begin(), active_.begin() + before, active_.end(), to_the_left);
}

std::vector<PolygonRun> scan_polygon(std::span<const GridPoint> corners, std::span<const std::uint32_t> contour_end,
                                     std::uint32_t line_count) {
  PolygonScan scan;
  scan.begin(0, line_count);
  std::uint32_t begin = 0;
  for (const std::uint32_t end : contour_end) {
    for (std::uint32_t i = begin; i < end; ++i) scan.add(corners[i], corners[i + 1 == end ? begin : i + 1]);
    begin = end;
  }
  std::vector<PolygonRun> runs;
  scan.scan([&](const PolygonRun& run) { runs.push_back(run); });
  return runs;
}

}  // namespace ligne
