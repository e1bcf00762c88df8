/// The page of an SVG.

#include <array>
#include <cmath>
#include <stdexcept>

#include "plotting/svg/reader.hpp"

namespace ligne::svg {
namespace {

/// Sides of a page without any size, px.
constexpr double kAssumedPx = 1000;

/// Papers that drawings have, and resolutions in which programs write them: PostScript, old Inkscape, CSS, scans.
constexpr const char* kPapers[] = {"A4", "A3", "A2", "A1", "A0", "A5", "A6", "letter", "legal", "tabloid"};
constexpr double kResolutions[] = {72, 90, 96, 300};
/// Largest difference between a side and a paper's, in units: sides are often rounded up or down to whole units.
constexpr double kPaperUnits = 1;

/// Whether the paper has these sides, lying or standing, at the resolution.
bool is_paper(const Page& paper, double width, double height, double dpi) {
  const double scale = dpi / kMmPerInch, short_side = std::min(width, height), long_side = std::max(width, height);
  return std::abs(paper.width_mm * scale - short_side) <= kPaperUnits &&
         std::abs(paper.height_mm * scale - long_side) <= kPaperUnits;
}

}  // namespace

/// Notes which paper a page without a size would have at another resolution, unless it has the size of a paper as it
/// is.
void SvgReader::note_paper(double width, double height) {
  for (const char* name : kPapers) {
    if (is_paper(parse_page(name), width, height, reading_.px_per_inch)) return;
  }
  for (const char* name : kPapers) {
    for (const double dpi : kResolutions) {
      if (!result_.paper_of_view_box.empty() || !is_paper(parse_page(name), width, height, dpi)) continue;
      result_.paper_of_view_box = name;
      result_.paper_dpi = dpi;
    }
  }
}

/// Extends the assumed sides of the page to the lines, except to stray points.
void SvgReader::extend_page(const Polylines& lines) {
  constexpr double kMostTimes = 10;  // assumed sides; a point farther away is a stray one. Adjustable.
  const double assumed = kAssumedPx * mm_per_px();
  for (double Page::*side : {&Page::width_mm, &Page::height_mm}) {
    double& size = result_.page.*side;
    for (const Point2& p : lines.points) {
      const double at = side == &Page::width_mm ? p.x : p.y;
      if (size >= assumed && at > size && at <= kMostTimes * assumed) size = at;
    }
  }
}

/// Sets the size of the page and the transform from its units. If a page gives one side, the viewBox gives the other. A
/// file that gives no size gets the one that vpype assumes.
Context SvgReader::place_page(const pugi::xml_node& root) {
  Context context;
  context.port.px_per_inch = reading_.px_per_inch;
  bool displayed = true;
  context.port.em = context.port.rem = styled(root, {}, context.port, displayed).font_size;
  const Attributes given = attributes(context);
  const std::optional<std::array<double, 4>> box = given.view_box(root);
  const auto told = [&](const char* name) -> std::optional<double> {
    const std::string_view value = trimmed(root.attribute(name).value());
    if (value.empty() || depends_on_window(value)) return {};
    const double side = given.x(root, name, -1);
    return side >= 0 ? std::optional(side) : std::nullopt;
  };
  const std::optional<double> told_width = told("width"), told_height = told("height");
  const auto side = [&](const std::optional<double>& own, std::size_t of_box, const std::optional<double>& other,
                        std::size_t of_other) {
    if (own) return *own;
    if (box) return other ? *other * (*box)[of_box] / (*box)[of_other] : (*box)[of_box];
    result_.size_assumed = true;
    return kAssumedPx;
  };
  const double width = side(told_width, 2, told_height, 3), height = side(told_height, 3, told_width, 2);
  if (box && !told_width && !told_height) note_paper(width, height);
  context.port.page_width = width;
  context.port.page_height = height;
  const Matrix inside = view_box_to(root, given, width, height, context.port);
  const double scale = mm_per_px();
  Page& page = result_.page;
  page = {width * scale, height * scale, 0};
  if (!(page.width_mm > 0 && page.height_mm > 0 && page.width_mm <= kLargestPageMm && page.height_mm <= kLargestPageMm)) {
    throw std::invalid_argument("the page is empty or larger than 100 m");
  }
  context.to_mm = Matrix{scale, 0, 0, scale, 0, 0} * inside;
  return context;
}

}  // namespace ligne::svg
