#include "visibility/watkins/watkins_options.hpp"

namespace ligne::watkins {
namespace {

constexpr std::string_view kExactWord[] = {"exact"}, kAutoWord[] = {"auto"}, kOffWord[] = {"off"};
constexpr std::string_view kShowNames[] = {"spans", "plane=Y"};
constexpr std::string_view kTrackingNames[] = {"exact", "lines", "overrun"};
constexpr std::string_view kCoordinateNames[] = {"real", "whole"};
constexpr std::string_view kIntersectionNames[] = {"edges", "points"};
constexpr unsigned kMostLines = 1u << 20;
constexpr unsigned kClassicalLines = 512;  ///< the screen of [Boulle1980]

constexpr MethodParameter kParameters[] = {
    experiment(
        {"span-method", "NAME",
         "how the nearest face along a scan line is found: merge, stack, box, point, or remembered (box with the divisions of the "
         "line before)",
         "stack", kSpanMethodNames}),
    {"lines", "N|exact", "scan lines over the height of the page, or a stop at every event",
     "exact; 512 beside options that need lines", kExactWord, 1, kMostLines},
    imprecise({"coordinates", "NAME", "by lines: real, or whole as on the screen of the source", "real", kCoordinateNames}),
    imprecise(
        {"tracking", "NAME",
         "by lines: ends of strokes exact, or on the lines on which the edges are visible (lines), or up to the first line on which "
         "they are hidden (overrun)",
         "exact", kTrackingNames}),
    imprecise({"intersections", "NAME", "by lines: lines of intersection as edges, or as a point on each scan line", "edges",
               kIntersectionNames}),
    experiment(
        {"line-group", "N|auto", "by lines: lines of a group; each group is a task", "auto", kAutoWord, 1, kMostLines}),
    experiment({"lines-ahead", "N|off", "by lines: one task prepares so many lines while another studies those before",
                "off", kOffWord, 1, kMostLines}),
    {"show", "spans|plane=Y",
     "as layer debug: the runs of scan lines on which one face is seen, 48 lines without --lines; or below the drawing "
     "the plane of the scan line Y mm below the top of the page (plane: through the middle), segment by segment",
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
  options.group = settings.count("line-group").value_or(0);
  options.ahead = settings.count("lines-ahead").value_or(0);
  const bool needs_lines =
      options.whole || options.tracking != Tracking::exact || options.points || options.group > 0 || options.ahead > 0;
  options.line_count = settings.count("lines").value_or(needs_lines ? kClassicalLines : 0);
  options.exact = options.line_count == 0;
  return options;
}

}  // namespace ligne::watkins
