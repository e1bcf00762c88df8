#include "picture/parse/parse_options.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "base/portable.hpp"
#include "drawing/drawing.hpp"
#include "files/closest_name.hpp"
#include "files/input_error.hpp"
#include "files/message_text.hpp"
#include "picture/errors.hpp"
#include "picture/parse/parse.hpp"
#include "plotting/page.hpp"
#include "scene/surfaces/surface_points.hpp"
#include "view/view.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

constexpr double kWidestPenMm = 50;
constexpr double kLowestDpi = 1, kHighestDpi = 9600;

/// A number, or a formula of numbers such as 2*pi.
double parse_constant(const std::string& text) {
  try {
    const double value = constant_of(text);
    if (std::isfinite(value)) return value;
  } catch (const InputError& e) {
    throw std::invalid_argument(e.what());
  }
  throw std::invalid_argument(shown(text, '"') + " is not a finite number");
}

/// "A:B", and the text after a second colon.
struct Ends {
  double from, to;
  std::optional<std::string> rest;
};

Ends parse_ends(const std::string& text, const std::string& form) {
  const std::size_t first = text.find(':');
  if (first == std::string::npos) throw std::invalid_argument(shown(text, '"') + " is not " + form);
  const std::size_t second = text.find(':', first + 1);
  Ends ends{parse_constant(text.substr(0, first)), 0, {}};
  ends.to = parse_constant(text.substr(first + 1, second == std::string::npos ? second : second - first - 1));
  if (second != std::string::npos) ends.rest = text.substr(second + 1);
  if (!(ends.from < ends.to)) throw std::invalid_argument("the range " + printable(text) + " does not ascend");
  if (!std::isfinite(ends.to - ends.from)) throw std::invalid_argument("the range " + printable(text) + " is too large");
  return ends;
}

}  // namespace

void parse_view(const std::string& text, ViewRequest& request) {
  constexpr std::string_view kFileCamera = "camera";
  if (text == kFileCamera || text.starts_with(std::string(kFileCamera) + ":")) {
    request.camera = text.size() > kFileCamera.size() ? text.substr(kFileCamera.size() + 1) : "";
    return;
  }
  std::vector<std::string_view> names(std::begin(kNamedViews), std::end(kNamedViews));
  names.push_back(kFileCamera);
  request.named_view = kNamedViews[parse_choice(text, names)];
}

PageSize parse_page_size(const std::string& text) {
  PageSize size;
  size.page = parse_page(text);
  const unsigned char first = text.empty() ? 0 : static_cast<unsigned char>(text[0]);
  size.explicit_size = !std::isalpha(first);
  return size;
}

double parse_pen_width(const std::string& text) {
  const double width = parse_length_mm(text);
  if (!(width > 0 && width <= kWidestPenMm)) {
    throw std::invalid_argument(printable(text) + " is not above 0 and at most " + shortest(kWidestPenMm) + " mm");
  }
  return width;
}

LineWidths parse_widths(const std::string& text) {
  LineWidths widths;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.rfind('=');
    if (equals == std::string::npos || equals == 0) throw std::invalid_argument(shown(part, '"') + " is not CLASS=LEN");
    widths[std::string(part.substr(0, equals))] = parse_pen_width(std::string(part.substr(equals + 1)));
  }
  return widths;
}

void require_layers(const LineWidths& widths) {
  std::vector<std::string_view> names;
  for (std::size_t l = kStrokeLayerCount; l > 0; --l) names.push_back(stroke_layer_name(l - 1));
  for (const std::string_view other :
       {"hatch", "underside", "contour-base", "contour-index", "shore", "water", "points", "legend", "text", "debug"}) {
    names.push_back(other);
  }
  for (const auto& [name, width] : widths) parse_choice(name, names);
}

double parse_min_length(const std::string& text) {
  const double length = parse_length_mm(text);
  if (length < 0) throw std::invalid_argument("a length can not be negative");
  return length;
}

double parse_crease(const std::string& text) { return parse_within(text, 0, 180, "degrees"); }

HiddenLines parse_hidden(const std::string& text) { return static_cast<HiddenLines>(parse_choice(text, kHiddenLinesNames)); }

HiddenChoice parse_hidden_choice(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return {parse_hidden(text)};
  HiddenChoice choice{parse_hidden(text.substr(0, colon))};
  if (choice.lines == HiddenLines::none) throw std::invalid_argument("none takes no number of faces");
  choice.most_hiding = parse_count(text.substr(colon + 1), 1, kMostCountedFaces);
  return choice;
}

TangentLines parse_tangent(const std::string& text) { return static_cast<TangentLines>(parse_choice(text, kTangentNames)); }

Quality parse_quality(const std::string& text) { return static_cast<Quality>(parse_choice(text, kQualityNames)); }

ProfileKind parse_profile(const std::string& text) { return static_cast<ProfileKind>(parse_choice(text, kProfileNames)); }

ScenePose parse_pose(const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos || at == 0) {
    throw std::invalid_argument(shown(text, '"') + " is not ANIMATION@SECONDS, such as walk@1.5 or 0@0");
  }
  return {text.substr(0, at), parse_number(text.substr(at + 1))};
}

std::optional<double> parse_weld(const std::string& text) {
  if (text == "auto") return std::nullopt;
  return text == "off" ? 0 : parse_positive(text);
}

StatedFacts parse_facts(const std::string& text) {
  StatedFacts facts;
  for (const std::string& name : parse_names(text)) {
    facts.state(static_cast<StatedFact>(parse_choice(name, kStatedFactNames)));
  }
  return facts;
}

Subdivision parse_subdivision(const std::string& text) {
  constexpr std::string_view kSchemeNames[] = {"catmull-clark", "loop"};
  const std::size_t colon = text.find(':');
  Subdivision subdivision;
  subdivision.scheme = static_cast<SubdivisionScheme>(parse_choice(text.substr(0, colon), kSchemeNames));
  if (colon != std::string::npos) subdivision.levels = parse_count(text.substr(colon + 1), 1, kMostSubdivisionLevels);
  return subdivision;
}

double parse_dpi(const std::string& text) { return parse_within(text, kLowestDpi, kHighestDpi, "dots per inch"); }

FillKind parse_fill(const std::string& text) { return static_cast<FillKind>(parse_choice(text, kFillNames)); }

GrayTone parse_gray_tone(const std::string& text) { return static_cast<GrayTone>(parse_choice(text, kGrayToneNames)); }

HatchKind parse_hatch(const std::string& text) {
  bool length = true;
  try {
    parse_length_mm(text);
  } catch (const std::invalid_argument&) {
    length = false;
  }
  if (length)
    throw std::invalid_argument(shown(text, '"') + " is not one of " + list_of(kHatchNames) +
                                "; the distance of the strokes is --hatch-spacing");
  return static_cast<HatchKind>(parse_choice(text, kHatchNames));
}

double parse_hatch_spacing(const std::string& text) {
  const double mm = parse_length_mm(text);
  if (!(mm > 0)) throw std::invalid_argument(shown(text, '"') + " is not a length above zero");
  return mm;
}

HatchDirection parse_hatch_direction(const std::string& text) {
  HatchDirection direction;
  if (text == "face") {
    direction.by_face = true;
  } else if (text == "curvature") {
    direction.form = FormLines::curvature;
  } else if (text == "iso") {
    direction.form = FormLines::iso;
  } else {
    direction.degrees = parse_within(text, -360, 360, "degrees");
  }
  return direction;
}

unsigned parse_hatch_levels(const std::string& text) { return text == "continuous" ? 0 : parse_count(text, 1, kMostShades); }

const Method* parse_method(const std::string& text) {
  if (text == "auto") return nullptr;
  if (const Method* method = find_method(text)) return method;
  std::vector<std::string_view> names{"auto"};
  for (const Method* method : all_methods()) names.push_back(method->traits().name);
  throw std::invalid_argument(shown(text, '"') + " is not one of " + list_of(names) + suggestion(text, names));
}

ParameterValue parse_parameter(const std::string& text, const MethodParameter& parameter) {
  if (parameter.words.empty()) return parse_count(text, parameter.low, parameter.high);
  const bool number = parameter.high > 0 && !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  if (number) return parse_count(text, parameter.low, parameter.high);
  const std::size_t sign = text.find('=');
  std::vector<std::string_view> names(parameter.words.begin(), parameter.words.end());
  for (std::string_view& name : names) {
    const std::size_t end = name.find('=');
    if (end != std::string_view::npos && name.substr(0, end) == text.substr(0, sign)) {
      const auto index = static_cast<std::size_t>(&name - names.data());
      return ParameterWord{index,
                           sign == std::string::npos ? std::nullopt : std::optional(parse_number(text.substr(sign + 1)))};
    }
  }
  return ParameterWord{parse_choice(text, parameter.words)};
}

CurveRange parse_range(const std::string& text) {
  const Ends ends = parse_ends(text.starts_with('=') ? text.substr(1) : text, "A:B or A:B:N");  // -x=A:B
  CurveRange range{ends.from, ends.to, {}};
  if (ends.rest) range.curves = parse_count(*ends.rest, 2, kMostCurves);
  return range;
}

std::array<double, 2> parse_heights(const std::string& text) {
  const Ends ends = parse_ends(text, "A:B");
  if (ends.rest) throw std::invalid_argument(shown(text, '"') + " is not A:B");
  return {ends.from, ends.to};
}

AspectRequest parse_aspect(const std::string& text) {
  if (text == "equal") return {AspectRequest::equal};
  if (text == "box") return {AspectRequest::box};
  AspectRequest aspect{AspectRequest::ratio};
  std::size_t begin = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t end = k < 2 ? text.find(':', begin) : text.size();
    if (end == std::string::npos) throw std::invalid_argument(shown(text, '"') + " is not equal, box or X:Y:Z");
    aspect.sides[k] = parse_positive(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return aspect;
}

GroundChoice parse_ground(const std::string& text) {
  constexpr std::string_view kNames[] = {"metres", "degrees"};
  return parse_choice(text, kNames) == 0 ? GroundChoice::metres : GroundChoice::degrees;
}

TableLayout parse_layout(const std::string& text) {
  constexpr std::string_view kNames[] = {"matrix", "frame", "series", "columns"};
  constexpr TableLayout kLayouts[] = {TableLayout::matrix, TableLayout::frame, TableLayout::series, TableLayout::columns};
  return kLayouts[parse_choice(text, kNames)];
}

std::vector<std::string> parse_columns(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, ':');
  std::vector<std::string> columns(parts.begin(), parts.end());
  if (std::ranges::count(columns, "") > 0 || (columns.size() != 1 && columns.size() != 3))
    throw std::invalid_argument(shown(text, '"') + " is not X:Y:Z, three columns, or Z, one of heights");
  return columns;
}

std::optional<unsigned> parse_every(const std::string& text) {
  constexpr unsigned kMostSteps = 1'000'000;
  return text == "auto" ? std::nullopt : std::optional(parse_count(text, 1, kMostSteps));
}

MemoryLimit parse_memory(const std::string& text) {
  if (text == "none") return {};
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = from_chars(text.data(), end, number);
  std::string suffix = lower_case({rest, end});
  constexpr std::string_view kUnits = "kmgt";
  const std::size_t unit = suffix.empty() ? std::string_view::npos : kUnits.find(suffix[0]);
  if (unit != std::string_view::npos) {
    constexpr double kKilo = 1024;
    number *= std::pow(kKilo, static_cast<double>(unit + 1));
    suffix.erase(0, 1);
    if (suffix == "ib") suffix = "b";
  }
  if (error != std::errc() || !std::isfinite(number) || number < 0 || !(suffix.empty() || suffix == "b")) {
    throw std::invalid_argument(shown(text, '"') + " is not a size such as 500M or 2G, or none");
  }
  return number > 0 ? MemoryLimit{number} : MemoryLimit{};
}

void set_parameter(MethodSettings& settings, const Method& method, const std::string& name, const std::string& text) {
  const auto own = method.traits().parameters;
  const auto found = std::find_if(own.begin(), own.end(), [&](const MethodParameter& p) { return p.name == name; });
  if (found == own.end()) throw SettingError(name, "method " + std::string(method.traits().name) + " has no such option");
  try {
    settings.set(found->name, parse_parameter(text, *found));
  } catch (const std::invalid_argument& e) {
    throw SettingError(name, e.what());
  }
}

}  // namespace ligne
