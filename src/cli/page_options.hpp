#pragma once
/// Options that say where on which page the picture lies.

#include <optional>

#include "geometry/point.hpp"
#include "plotting/page.hpp"

namespace CLI {
class App;
}

namespace ligne {

/// A page as written on the command line.
struct PageSize {
  Page page;
  bool explicit_size = false;  ///< WxH: its orientation is meant as written
};

struct PageOptions {
  PageSize size;
  bool landscape = false, portrait = false;
  double margin_mm = 10;
  double pen_width_mm = 0.35;
  std::optional<double> scale;  ///< page length per true length; nothing: fit
  double unit_mm = 1;           ///< true length of one model unit

  /// Page mm per model unit, or nothing when the picture is to fit.
  std::optional<double> page_mm_per_unit() const { return scale ? std::optional(*scale * unit_mm) : std::nullopt; }
};

void add_page_options(CLI::App& app, PageOptions& options);

/// Reads "--page".
PageSize parse_page_size(const std::string& text);

/// Throws UsageError when the margins leave nothing of the page.
void check(const PageOptions& options);

/// The page in its orientation: as asked for, else that in which a picture of this extent becomes larger (as the
/// page is named when both are alike).
Page page_for(const PageOptions& options, const Rect& extent);

}  // namespace ligne
