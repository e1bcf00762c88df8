#pragma once
/// Texts of options for pages, pens, hatching, methods and ranges. The functions throw std::invalid_argument, as in
/// parse.hpp.

#include <array>
#include <optional>
#include <string>

#include "picture/requests.hpp"
#include "picture/surface/surface_request.hpp"
#include "scene/readers/read_report.hpp"
#include "visibility/method_parameters.hpp"

namespace ligne {

/// The name of a view, "camera" for the first camera of the file, or "camera:NAME" for a named one.
void parse_view(const std::string& text, ViewRequest& request);

PageSize parse_page_size(const std::string& text);

/// The width of a pen, above 0, in mm.
double parse_pen_width(const std::string& text);

/// "CLASS=LEN,...", line widths by layer.
LineWidths parse_widths(const std::string& text);
/// Throws std::invalid_argument if a name is not that of a layer.
void require_layers(const LineWidths& widths);

/// A length that is not negative, mm.
double parse_min_length(const std::string& text);
/// An angle from 0 to 180 degrees.
double parse_crease(const std::string& text);
HiddenLines parse_hidden(const std::string& text);

/// The values of LineRequest::hidden and most_hiding: "none", "dashed" or "solid", the last two optionally with ":N".
struct HiddenChoice {
  HiddenLines lines = HiddenLines::none;
  std::optional<unsigned> most_hiding{};
};
HiddenChoice parse_hidden_choice(const std::string& text);
TangentLines parse_tangent(const std::string& text);
Quality parse_quality(const std::string& text);
ProfileKind parse_profile(const std::string& text);
/// A moment of an animation, such as "walk@1.5": a name or number, and seconds. The name may contain "@".
ScenePose parse_pose(const std::string& text);
/// "auto", "off" (0) or a distance.
std::optional<double> parse_weld(const std::string& text);
/// Names of facts, separated by commas.
StatedFacts parse_facts(const std::string& text);
/// "SCHEME" or "SCHEME:LEVELS".
Subdivision parse_subdivision(const std::string& text);
/// A resolution of a PNG, in dots per inch.
double parse_dpi(const std::string& text);

FillKind parse_fill(const std::string& text);
GrayTone parse_gray_tone(const std::string& text);
HatchKind parse_hatch(const std::string& text);
double parse_hatch_spacing(const std::string& text);
/// Degrees, "face", "curvature" or "iso".
HatchDirection parse_hatch_direction(const std::string& text);
/// A number of degrees of darkness, or "continuous" (0).
unsigned parse_hatch_levels(const std::string& text);

/// A size such as "500M", "1.5G" or "64KiB"; bytes without a suffix; "none" and 0 mean no limit.
MemoryLimit parse_memory(const std::string& text);

/// The name of a method, as for find_method(); "auto" returns nullptr.
const Method* parse_method(const std::string& text);
/// A value of a method's own parameter.
ParameterValue parse_parameter(const std::string& text, const MethodParameter& parameter);
/// Sets a value in the settings of the method. Throws SettingError if the method has no such parameter, or does not
/// accept the value.
void set_parameter(MethodSettings& settings, const Method& method, const std::string& name, const std::string& text);

inline constexpr unsigned kMostCurves = 20'000;
/// Largest number of a data set that can be chosen in a text.
inline constexpr unsigned kMostDataSets = 1'000'000;

/// "A:B" or "A:B:N". A and B may be formulas of numbers.
CurveRange parse_range(const std::string& text);
/// "A:B".
std::array<double, 2> parse_heights(const std::string& text);

/// "equal", "box" or "X:Y:Z".
AspectRequest parse_aspect(const std::string& text);
/// "metres" or "degrees".
GroundChoice parse_ground(const std::string& text);
/// "matrix", "frame", "series" or "columns".
TableLayout parse_layout(const std::string& text);
/// Three columns "X:Y:Z", or one column. A column is a name or a number from 1.
std::vector<std::string> parse_columns(const std::string& text);
/// A number of samples, or "auto", which returns nothing.
std::optional<unsigned> parse_every(const std::string& text);

}  // namespace ligne
