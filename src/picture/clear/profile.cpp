/// Profiles.
///
/// 1. Beside every visible stroke, find what would be visible there without lines (free_parts()).
/// 2. The answer can not change along an arc, a line between two junctions: where a visible area beside it ends, another
///    line ends or crosses the arc. So on each arc a run shorter than two pen widths is noise, from concave corners and
///    from testing at a distance from the line, and takes the value of its neighbours. The remaining changes are at
///    junctions, or inside an arc where another line is not drawn.
/// 3. Cut the strokes at these changes.

#include "picture/clear/tidy_strokes.hpp"

#include <algorithm>
#include <tuple>

#include "linework/map/line_groups.hpp"

namespace ligne {
namespace {

/// Shortest run that counts as a change of the line, in pen widths.
constexpr double kShortestInPens = 2;
/// Shortest such run, in multiples of the distance at which the side of the line was tested. A line that crosses at
/// eight degrees moves the change by that much.
constexpr double kShortestOff = 7;
/// Distance within which a line ends at another line, in mm: twice the largest distance between a curve and its points.
constexpr double kJunctionMm = 0.004;

/// A part of an arc that is free or not free as a whole.
struct Bit {
  std::uint32_t stroke;
  StrokeCut from, to;  ///< on the stroke
  double length;       ///< steps
  bool free;
};

/// Splits a piece of a line into bits, in the order of its stroke.
std::vector<Bit> bits_of(const LineMap& map, std::uint32_t piece, const FreeParts& free) {
  const Stroke &whole = map.stroke_of(piece), &s = map.piece(piece);
  const double size = page_length(whole), from = foot_on(whole, s.from).fraction, to = foot_on(whole, s.to).fraction;
  const auto cut_at = [&](double fraction) -> StrokeCut {
    return {fraction, fraction == from ? s.from : fraction == to ? s.to : point_at(whole, fraction)};
  };
  std::vector<Bit> bits;
  double last = from;
  const auto add = [&](double until, bool is_free) {
    if (!(last < until)) return;
    bits.push_back({map.stroke_number(piece), cut_at(last), cut_at(until), (until - last) * size, is_free});
    last = until;
  };
  for (const StrokePart& open : free.parts) {
    add(std::clamp(open.from, from, to), false);
    add(std::clamp(open.to, from, to), true);
  }
  add(to, false);
  return bits;
}

/// Consecutive bits with the same value of `free`.
struct Run {
  double length;
  bool free;
  std::size_t end;  ///< index behind its last bit
};

/// Merges each run shorter than `shortest` with its neighbours, the shortest run first.
void drop_short_runs(std::vector<Bit>& bits, double shortest) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    if (runs.empty() || runs.back().free != bits[i].free) runs.push_back({0, bits[i].free, 0});
    runs.back().length += bits[i].length;
    runs.back().end = i + 1;
  }
  while (runs.size() > 1) {
    const auto least = std::ranges::min_element(runs, {}, &Run::length);
    if (!(least->length < shortest)) break;
    auto first = least == runs.begin() ? least : least - 1;
    const auto last = least + 1 == runs.end() ? least : least + 1;
    Run joined{0, !least->free, last->end};
    for (auto run = first; run <= last; ++run) joined.length += run->length;
    *first = joined;
    runs.erase(first + 1, last + 1);
  }
  std::size_t i = 0;
  for (const Run& run : runs) {
    for (; i < run.end; ++i) bits[i].free = run.free;
  }
}

/// Cuts the strokes where free bits begin and end.
std::vector<Stroke> cut_strokes(const std::vector<Stroke>& strokes, std::vector<Bit>& free_bits) {
  std::ranges::sort(free_bits, {}, [](const Bit& bit) { return std::tuple(bit.stroke, bit.from.fraction); });
  std::vector<Stroke> cut;
  cut.reserve(strokes.size() + free_bits.size());
  auto bit = free_bits.begin();
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    const Stroke& s = strokes[i];
    StrokeCut last{0, s.from};
    const auto add = [&](const StrokeCut& to, bool is_profile) {
      if (!(last.fraction < to.fraction)) return;
      const Stroke piece = stroke_piece(s, last, to);
      last = to;
      if (piece.from == piece.to || !(piece.t_from < piece.t_to)) return;
      cut.push_back(piece);
      if (is_profile) cut.back().line_class = LineClass::profile;
    };
    if (bit == free_bits.end() || bit->stroke != i) {
      cut.push_back(s);
      continue;
    }
    while (bit != free_bits.end() && bit->stroke == i) {
      add(bit->from, false);
      StrokeCut to = bit->to;
      for (++bit; bit != free_bits.end() && bit->stroke == i && bit->from.fraction == to.fraction; ++bit) to = bit->to;
      add(to, true);
    }
    add({1, s.to}, false);
  }
  return cut;
}

}  // namespace

void draw_profiles(StrokeModel& model, const ProjectedScene& projected, const Scene& scene, const ContourSources& contours,
                   const ProfileStyle& style) {
  const std::vector<FreeParts> free = free_parts(model, projected, scene, contours, style);
  const double step = model.lattice.step_mm;
  /// Side of the cells for the search of lines, in pen widths. Adjustable.
  constexpr double kCellInPens = 4;
  const LineMap map(model, is_edge, {.reach = kJunctionMm / step, .any_node = true},
                    kCellInPens * style.pen_width_mm / step);
  const Arcs arcs(map, kJunctionMm / step);
  std::vector<Bit> profiles;
  for (const Arcs::Arc& arc : arcs.find()) {
    std::vector<Bit> bits;
    double off_mm = 0;
    for (const std::uint32_t end : arc.ends) {
      const FreeParts& parts = free[map.stroke_number(end / 2)];
      std::vector<Bit> of_piece = bits_of(map, end / 2, parts);
      if (end % 2 == 1) std::ranges::reverse(of_piece);
      bits.insert(bits.end(), of_piece.begin(), of_piece.end());
      off_mm = std::max(off_mm, parts.off_mm);
    }
    // A ring begins at a change, so that no run is cut in two.
    const auto change = std::ranges::adjacent_find(bits, std::ranges::not_equal_to{}, &Bit::free);
    if (arc.junctions.empty() && change != bits.end()) std::rotate(bits.begin(), change + 1, bits.end());
    drop_short_runs(bits, std::max(kShortestInPens * style.pen_width_mm, kShortestOff * off_mm) / step);
    std::copy_if(bits.begin(), bits.end(), std::back_inserter(profiles), [](const Bit& bit) { return bit.free; });
  }
  model.strokes = cut_strokes(model.strokes, profiles);
}

}  // namespace ligne
