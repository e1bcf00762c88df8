#include "visibility/watkins/watkins_options.hpp"

namespace ligne::watkins {
namespace {

constexpr std::string_view kExactWord[] = {"exact"}, kAutoWord[] = {"auto"}, kOffWord[] = {"off"};
constexpr std::string_view kShowNames[] = {"spans", "plane=Y"};
constexpr std::string_view kTrackingNames[] = {"exact", "lines", "overrun"};
constexpr std::string_view kCoordinateNames[] = {"real", "whole"};
constexpr std::string_view kIntersectionNames[] = {"edges", "points"};
constexpr std::string_view kSkewNames[] = {"triangles", "slopes"};
constexpr unsigned kMostLines = 1u << 20;
constexpr unsigned kClassicalLines = 512;  ///< the screen of [Boulle1980]

constexpr MethodParameter kParameters[] = {
    experiment(
        {"span-method", "NAME",
         "how to find the nearest face along a scan line: merge, stack, box, point, or remembered (box with the divisions "
         "of the previous line)",
         "stack", kSpanMethodNames}),
    {"lines", "N|exact", "number of scan lines over the height of the page; exact: a scan line at every event",
     "exact; 512 with settings that need lines", kExactWord, 1, kMostLines},
    imprecise({"coordinates", "NAME", "with --lines: real, or whole (integer) numbers as on the screen of the source",
               "real", kCoordinateNames}),
    imprecise(
        {"tracking", "NAME",
         "with --lines: ends of strokes. exact; lines: on the first and last line where the edge is visible; overrun: up to "
         "the first line where it is hidden",
         "exact", kTrackingNames}),
    imprecise({"intersections", "NAME", "with --lines: intersections of faces as edges, or as one point per scan line",
               "edges", kIntersectionNames}),
    imprecise(
        {"skew", "NAME",
         "with --lines: faces that are not plane as triangles, or straight from side to side on each scan line (slopes)",
         "triangles", kSkewNames}),
    experiment({"line-group", "N|auto", "with --lines: scan lines per group; each group is a task", "auto", kAutoWord, 1,
                kMostLines}),
    experiment({"lines-ahead", "N|off",
                "with --lines: scan lines that one task prepares while another studies the previous ones", "off", kOffWord,
                1, kMostLines}),
    {"show", "spans|plane=Y",
     "spans: layer debug, the visible spans of scan lines, of 48 lines without --lines; plane=Y: below the drawing, the "
     "plane of the scan line Y mm below the top of the page, segment by segment (plane: the middle line)",
     "", kShowNames},
};

}  // namespace

std::span<const MethodParameter> watkins_parameters() { return kParameters; }

WatkinsOptions watkins_options(const MethodSettings& settings) {
  WatkinsOptions options;
  options.kind = settings.choice("span-method", options.kind);
  options.whole = settings.choice("coordinates", 0) == 1;
  options.tracking = settings.choice("tracking", options.tracking);
  options.points = settings.choice("intersections", 0) == 1;
  options.slopes = settings.choice("skew", 0) == 1;
  options.group = settings.count("line-group").value_or(0);
  options.ahead = settings.count("lines-ahead").value_or(0);
  const bool needs_lines = options.whole || options.tracking != Tracking::exact || options.points || options.slopes ||
                           options.group > 0 || options.ahead > 0;
  options.line_count = settings.count("lines").value_or(needs_lines ? kClassicalLines : 0);
  options.exact = options.line_count == 0;
  return options;
}

}  // namespace ligne::watkins
