#include "plotting/page.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/portable.hpp"
#include "files/message_text.hpp"

namespace ligne {
namespace {

constexpr double kPointsPerInch = 72;

constexpr std::pair<std::string_view, double> kUnits[] = {
    {"mm", 1}, {"cm", 10}, {"in", kMmPerInch}, {"pt", kMmPerInch / kPointsPerInch}};

struct NamedPage {
  std::string_view name;
  double width_mm, height_mm;
};
// ISO 216; ANSI Y14.1 and North American office sizes.
constexpr NamedPage kPages[] = {
    {"a0", 841, 1189}, {"a1", 594, 841}, {"a2", 420, 594},         {"a3", 297, 420},        {"a4", 210, 297},
    {"a5", 148, 210},  {"a6", 105, 148}, {"letter", 215.9, 279.4}, {"legal", 215.9, 355.6}, {"tabloid", 279.4, 431.8}};

// ISO 128-2, line 02 (dashed): lengths in line widths.
constexpr double kDash = 12;
constexpr double kGap = 3;

struct LayerPen {
  std::string_view layer;
  double width;  ///< factor of the pen width
};
constexpr LayerPen kLayerPens[] = {{"profile", 1.4},    {"intersection", 0.7},  {"crease", 0.7},       {"tangent", 0.5},
                                   {"mesh", 0.5},       {"contour-index", 1.7}, {"curve", 2},          {"points", 1.4},
                                   {"water", 0.5},      {"hidden", 0.5},        {"axes", 0.7},         {"text", 0.7},
                                   {"debug", 0.5},      {"hatch", 0.5},         {"behind-glass", 0.5}, {"shadow", 0.5},
                                   {"suggestive", 0.7}, {"ridge", 0.7},         {"valley", 0.7},       {"detail", 0.5}};
constexpr std::array<double, 3> kDebugColor{0.8, 0, 0}, kTransparentColor{0.5, 0.5, 0.5};

/// A number and the unit behind it, which may be empty.
std::pair<double, std::string_view> split_unit(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = from_chars(text.data(), end, value);
  if (error == std::errc::result_out_of_range) throw std::invalid_argument("length out of range: " + shown(text));
  if (error != std::errc{}) throw std::invalid_argument("not a length: " + shown(text));
  if (!std::isfinite(value)) throw std::invalid_argument("length is not finite: " + shown(text));
  if (std::signbit(value)) throw std::invalid_argument("length is negative: " + shown(text));
  return {value, {rest, static_cast<std::size_t>(end - rest)}};
}

double in_mm(double value, std::string_view unit, std::string_view text) {
  if (unit.empty()) return value;
  for (const auto& [name, mm] : kUnits) {
    if (unit != name) continue;
    if (!std::isfinite(value * mm)) throw std::invalid_argument("length out of range: " + shown(text));
    return value * mm;
  }
  throw std::invalid_argument("unknown unit " + shown(unit) + " in length " + shown(text) + " (mm, cm, in, pt)");
}

}  // namespace

double parse_length_mm(std::string_view text) {
  const auto [value, unit] = split_unit(text);
  return in_mm(value, unit, text);
}

Page parse_page(std::string_view text) {
  Page page;
  const std::string name = lower_case(text);
  for (const NamedPage& named : kPages) {
    if (name != named.name) continue;
    page.width_mm = named.width_mm;
    page.height_mm = named.height_mm;
    return page;
  }
  const std::size_t cross = name.find('x');
  if (cross == std::string::npos) {
    throw std::invalid_argument("unknown page " + shown(text) + " (A0 to A6, letter, legal, tabloid, or WxH)");
  }
  try {
    const auto [width, width_unit] = split_unit(std::string_view(name).substr(0, cross));
    const auto [height, height_unit] = split_unit(std::string_view(name).substr(cross + 1));
    // "8x10in" means inches for both.
    page.width_mm = in_mm(width, width_unit.empty() ? height_unit : width_unit, name);
    page.height_mm = in_mm(height, height_unit, name);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("page " + shown(text) + ": " + error.what());
  }
  if (page.width_mm <= 0 || page.height_mm <= 0) throw std::invalid_argument("page " + shown(text) + " has no area");
  if (std::max(page.width_mm, page.height_mm) > kLargestPageMm) {
    throw std::invalid_argument("page " + shown(text) + " is larger than 100 m");
  }
  return page;
}

LineStyle with_width(LineStyle style, double width_mm) {
  for (double& dash : style.dashes_mm) dash *= width_mm / style.width_mm;
  style.width_mm = width_mm;
  return style;
}

LineStyle layer_style(std::string_view layer, double pen_width_mm, bool hidden_solid) {
  LineStyle style;
  style.width_mm = pen_width_mm;
  for (const LayerPen& pen : kLayerPens) {
    if (pen.layer == layer) style.width_mm = pen.width * pen_width_mm;
  }
  if (layer == "debug") style.color = kDebugColor;
  if (layer == "behind-glass") style.color = kTransparentColor;
  if (layer == "hidden" && !hidden_solid) style.dashes_mm = {kDash * style.width_mm, kGap * style.width_mm};
  return style;
}

}  // namespace ligne
