#pragma once
/// Words of options with a meaning of their own: pages, pens, hatching, methods, ranges. As the functions of parse.hpp,
/// these throw std::invalid_argument.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "picture/requests.hpp"
#include "picture/surface/surface_request.hpp"
#include "scene/readers/read_report.hpp"
#include "visibility/method_parameters.hpp"

namespace ligne {

/// The name of a view, or "camera" or "camera:NAME", the view of a camera of the file.
void parse_view(const std::string& text, ViewRequest& request);

PageSize parse_page_size(const std::string& text);

/// A width above 0 that a pen may have, mm.
double parse_pen_width(const std::string& text);

/// "CLASS=LEN,...", widths of lines by their layers.
LineWidths parse_widths(const std::string& text);
/// Throws unless all are layers of ours.
void require_layers(const LineWidths& widths);

/// A length that is not negative, mm.
double parse_min_length(const std::string& text);
/// An angle from 0 to 180 degrees.
double parse_crease(const std::string& text);
HiddenLines parse_hidden(const std::string& text);

/// One of these words, with ":N" behind dashed or solid: LineRequest::hidden and most_hiding.
struct HiddenChoice {
  HiddenLines lines = HiddenLines::none;
  std::optional<unsigned> most_hiding{};
};
HiddenChoice parse_hidden_choice(const std::string& text);
TangentLines parse_tangent(const std::string& text);
Quality parse_quality(const std::string& text);
ProfileKind parse_profile(const std::string& text);
/// "walk@1.5": a moment of an animation, by its name or number; the name may hold "@".
ScenePose parse_pose(const std::string& text);
/// "auto", "off" (0) or a distance.
std::optional<double> parse_weld(const std::string& text);
/// "SCHEME" or "SCHEME:LEVELS".
Subdivision parse_subdivision(const std::string& text);
/// Dots per inch that a PNG may have.
double parse_dpi(const std::string& text);

FillKind parse_fill(const std::string& text);
HatchKind parse_hatch(const std::string& text);
double parse_hatch_spacing(const std::string& text);
/// Degrees, or "face".
HatchDirection parse_hatch_direction(const std::string& text);
/// A number of degrees of darkness, or "continuous" (0).
unsigned parse_hatch_levels(const std::string& text);

/// "500M", "1.5G", "64KiB", bytes without a suffix; "none" and 0 are no limit.
MemoryLimit parse_memory(const std::string& text);

/// Names as of find_method(); nullptr for "auto".
const Method* parse_method(const std::string& text);
/// A value of a method's own parameter.
ParameterValue parse_parameter(const std::string& text, const MethodParameter& parameter);
/// Puts a value into the settings of the method. Throws RequestError for one that it does not have, or not with this value.
void set_parameter(MethodSettings& settings, const Method& method, const std::string& name, const std::string& text);

inline constexpr unsigned kMostCurves = 20'000;
/// Data sets of a text that can be chosen by their number.
inline constexpr unsigned kMostDataSets = 1'000'000;

/// "A:B" or "A:B:N"; A and B may be formulas of numbers.
CurveRange parse_range(const std::string& text);
/// "A:B".
std::array<double, 2> parse_heights(const std::string& text);

/// "equal", "box" or "X:Y:Z".
AspectRequest parse_aspect(const std::string& text);
/// "metres" or "degrees".
GroundChoice parse_ground(const std::string& text);
/// "matrix", "frame", "series" or "columns".
TableLayout parse_layout(const std::string& text);
/// Three columns "X:Y:Z", or one: names, or numbers from 1.
std::vector<std::string> parse_columns(const std::string& text);
/// A number of samples, or "auto" (nothing).
std::optional<unsigned> parse_every(const std::string& text);

}  // namespace ligne
