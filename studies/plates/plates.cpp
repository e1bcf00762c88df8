#include "studies/plates/plates.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "picture/draw_scene.hpp"
#include "picture/parse/parse_options.hpp"
#include "plotting/writers/writers.hpp"
#include "scene/readers/format_readers.hpp"
#include "studies/plates/plate_scenes.hpp"
#include "studies/scenes/generators.hpp"
#include "visibility/newell/priority_list.hpp"
#include "visibility/registry.hpp"

namespace ligne::studies {
namespace {

// Lengths on the page, mm. Taste.
constexpr double kPlateWidth = 210, kPlateHeight = 297, kMargin = 18;
constexpr double kTitleHeight = 4, kNameHeight = 2.6, kSmallHeight = 2.2, kLineFactor = 1.9;
constexpr double kPlatePen = 0.35;

Scene scene_of(std::string_view json) {
  ReadReport report;
  Warnings warnings;
  Scene scene = read_ligne_scene({{std::as_bytes(std::span(json)), "plate"}, report, warnings});
  finish(scene);
  return scene;
}

/// A cell of the page: its area, caption and margin.
struct PlateCell {
  Rect area;
  std::string name;      ///< caption below the drawing
  double margin_mm = 3;  ///< inside the area
};

/// Puts drawings and texts on a page.
class PlateMaker {
 public:
  PlateMaker(std::string figure, std::string title, std::string caption) {
    plate_.figure = std::move(figure);
    plate_.title = std::move(title);
    plate_.caption = std::move(caption);
    text("Figure " + plate_.figure, {kMargin, kMargin}, kTitleHeight);
    text(plate_.title, {kMargin, kMargin + kLineFactor * kTitleHeight}, kNameHeight);
    text(plate_.caption, {kMargin, kPlateHeight - kMargin}, kSmallHeight);
  }

  void text(const std::string& words, Point2 at, double height, TextAcross across = TextAcross::left) {
    plate_.drawing.texts.push_back({words, at, height, across, TextUp::base});
  }

  /// A block of counts, as beside the drawings of the source.
  void counts(Point2 at, std::span<const std::pair<std::string, std::uint64_t>> rows) {
    for (const auto& [name, n] : rows) {
      text(name, at, kSmallHeight);
      text(std::to_string(n), at + Point2{62, 0}, kSmallHeight, TextAcross::right);
      at.y += kLineFactor * kSmallHeight;
    }
  }

  /// Draws a scene in a cell and returns the counts of the study.
  Statistics draw(const Scene& scene, PictureRequest request, const PlateCell& cell) {
    request.page.size.page = {cell.area.width(), cell.area.height(), 0};
    request.page.size.explicit_size = true;
    request.page.margin_mm = cell.margin_mm;
    request.lines.quality = Quality::exact;
    RunReport run;
    const DrawnScene drawn = draw_lines(scene, request, run);
    add(drawn.compose(run), cell.area.min);
    name_below(cell);
    return drawn.visibility().result.statistics;
  }

  void add(Drawing drawing, Point2 shift) {
    for (Layer& layer : drawing.layers) {
      for (Point2& p : layer.lines.points) p += shift;
      const auto same = [&](const Layer& l) { return l.name == layer.name && l.color == layer.color; };
      const auto known = std::ranges::find_if(plate_.drawing.layers, same);
      if (known != plate_.drawing.layers.end()) {
        append(known->lines, layer.lines);
      } else {
        plate_.drawing.layers.push_back(std::move(layer));
      }
    }
    for (Fill& fill : drawing.fills) {
      for (auto& contour : fill.contours) {
        for (Point2& p : contour) p += shift;
      }
      plate_.drawing.fills.push_back(std::move(fill));
    }
    for (TextItem& item : drawing.texts) {
      item.at += shift;
      plate_.drawing.texts.push_back(std::move(item));
    }
  }

  void lines(const std::string& layer, const std::vector<std::vector<Point2>>& polylines) {
    Drawing drawing;
    Layer& made = drawing.layers.emplace_back(Layer{layer, {}});
    for (const std::vector<Point2>& line : polylines) made.lines.add(line);
    add(std::move(drawing), {0, 0});
  }

  void name_below(const PlateCell& cell) {
    text(cell.name, {(cell.area.min.x + cell.area.max.x) / 2, cell.area.max.y + 4}, kNameHeight, TextAcross::center);
  }

  Plate take() { return std::move(plate_); }

 private:
  Plate plate_;
};

/// Area of the cell at a column and row of a grid between title and caption.
Rect cell_at(unsigned column, unsigned row, unsigned columns, unsigned rows) {
  constexpr double kTop = kMargin + 16, kBottom = kPlateHeight - kMargin - 8, kGap = 8;
  const double width = (kPlateWidth - 2 * kMargin - (columns - 1) * kGap) / columns;
  const double height = (kBottom - kTop - rows * kGap) / rows;
  const Point2 corner{kMargin + column * (width + kGap), kTop + row * (height + kGap)};
  return {corner, corner + Point2{width, height}};
}

PictureRequest view_of(const std::string& view, const char* method) {
  PictureRequest request;
  request.view.named_view = view;
  request.lines.method = find_method(method);
  request.lines.classes = LineClasses::features();
  return request;
}

PictureRequest with_shown(PictureRequest request, const char* what) {
  set_parameter(request.lines.settings, *request.lines.method, "show", what);
  return request;
}

std::uint64_t count_named(const Statistics& statistics, std::string_view name) {
  for (const auto& [known, n] : statistics.counts) {
    if (known == name) return n;
  }
  return 0;
}

/// Figure 2.2: front, side and top views with captions, the block of counts, the subdivision and the result.
Plate three_views() {
  PlateMaker plate("2.2", "A scene treated by Warnock's algorithm: a) three views, b) subdivision, c) front view treated",
                   "The scene of the figure is not known; ours is a stepped block before a wedge.");
  constexpr double kSquareMargin = 12;  // The first window is a square as wide as the drawing.
  const Scene scene = scene_of(kSteppedBlock);
  const std::pair<const char*, const char*> views[] = {{"front", "FRONT VIEW"}, {"left", "SIDE VIEW"}, {"top", "TOP VIEW"}};
  for (unsigned i = 0; i < 3; ++i) {
    PictureRequest request = view_of(views[i].first, "appel");
    request.lines.hidden = HiddenLines::dashed;
    plate.draw(scene, request, {cell_at(i % 2, i / 2, 2, 3), views[i].second});
  }
  PictureRequest divided = with_shown(view_of("front", "warnock"), "windows");
  set_parameter(divided.lines.settings, *divided.lines.method, "resolution", "512");
  const Statistics statistics = plate.draw(scene, divided, {cell_at(0, 2, 2, 3), "b", kSquareMargin});
  plate.draw(scene, view_of("front", "warnock"), {cell_at(1, 2, 2, 3), "c", kSquareMargin});
  const Rect block = cell_at(1, 1, 2, 3);
  const std::pair<std::string, std::uint64_t> rows[] = {{"NUMBER OF VERTICES", scene.vertices.size()},
                                                        {"NUMBER OF FACES", scene.faces.size()},
                                                        {"NUMBER OF WINDOWS", count_named(statistics, "windows studied")}};
  plate.counts(block.min + Point2{10, 30}, rows);
  return plate.take();
}

/// Figure 2.30: brightness as four levels of hatching.
Plate hatched_views() {
  PlateMaker plate("2.30", "Different views of one object, by watkins: brightness as one to four levels of hatching",
                   "The object of the figure is not known; ours is a house.");
  const Scene scene = scene_of(kHouse);
  const char* const views[] = {"front", "right", "iso", "trimetric"};
  for (unsigned i = 0; i < 4; ++i) {
    PictureRequest request = view_of(views[i], "watkins");
    request.hatch.kind = HatchKind::shade;
    request.hatch.levels = 4;
    request.hatch.spacing_mm = 0.9;
    std::string name = views[i];
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    plate.draw(scene, request, {cell_at(i % 2, i / 2, 2, 2), name});
  }
  return plate.take();
}

/// Strokes as the tracking of 2.3.4 draws them. Each scan line knows whether an edge is visible. A stroke spans the first to
/// the last line of a visible run, rounded to whole columns. Edges parallel to the lines have length zero and are not drawn.
std::vector<std::vector<Point2>> tracked_strokes(const StrokeModel& model, double spacing) {
  std::vector<std::vector<Point2>> strokes;
  const auto column = [&](double x) { return std::round(x / spacing) * spacing; };
  for (const Stroke& s : model.strokes) {
    if (!s.visible) continue;
    Point2 a = model.lattice.to_mm(s.from), b = model.lattice.to_mm(s.to);
    if (a.y > b.y) std::swap(a, b);
    const double first = std::ceil(a.y / spacing), last = std::floor(b.y / spacing);
    if (!(first < last)) continue;
    const auto at = [&](double line) {
      const double y = line * spacing, x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
      return Point2{column(x), y};
    };
    strokes.push_back({at(first), at(last)});
  }
  return strokes;
}

Plate imprecise_strokes() {
  constexpr double kSpacingMm = 3;
  PlateMaker plate("2.57", "Imprecision in the drawing: strokes tracked from line to line, and exact ends",
                   "Scan lines 3 mm apart. Ends lie on lines and columns; edges along the lines are not drawn.");
  Scene scene = columns(3, 30);
  finish(scene);
  for (unsigned row = 0; row < 2; ++row) {
    const Rect area = cell_at(0, row, 1, 2);
    PictureRequest request = view_of("iso", "watkins");
    if (row == 1) {
      plate.draw(scene, request, {area, "EXACT ENDS"});
      continue;
    }
    request.page.size.page = {area.width(), area.height(), 0};
    request.page.size.explicit_size = true;
    request.page.margin_mm = 3;
    request.lines.quality = Quality::exact;
    RunReport run;
    const DrawnScene drawn = draw_lines(scene, request, run);
    std::vector<std::vector<Point2>> lines;
    for (double y = 0; y <= area.height(); y += kSpacingMm) lines.push_back({{0, y}, {area.width(), y}});
    std::vector<std::vector<Point2>> strokes = tracked_strokes(*drawn.visibility().result.strokes, kSpacingMm);
    for (auto* list : {&lines, &strokes}) {
      for (auto& line : *list) {
        for (Point2& p : line) p += area.min;
      }
    }
    plate.lines("debug", lines);
    plate.lines("outline", strokes);
    plate.name_below({area, "TRACKED FROM LINE TO LINE"});
  }
  return plate.take();
}

Plate treated_face() {
  PlateMaker plate("2.62",
                   "A face as it is treated by Atherton and Weiler: outer contour, holes, details of their own colours",
                   "Any contour may be convex or not.");
  const Scene scene = scene_of(kDetailedFace);
  PictureRequest contours = view_of("front", "atherton-weiler");
  plate.draw(scene, contours, {cell_at(0, 0, 1, 2), "OUTER CONTOUR AND HOLES"});
  PictureRequest filled = contours;
  filled.fill.kind = FillKind::material;
  filled.lines.classes.add(LineClass::detail);
  plate.draw(scene, filled, {cell_at(0, 1, 1, 2), "WITH ITS DETAILS"});
  return plate.take();
}

Plate details_of_a_face() {
  PlateMaker plate("2.71",
                   "Details of a visible part of a face: those of the scene, clipped, and cast shadows; what glass shows",
                   "F behind a plate that throws a shadow, and behind a pane of glass.");
  const Scene scene = scene_of(kDetailsAndShadow);
  PictureRequest lit = view_of("front", "atherton-weiler");
  lit.fill.kind = FillKind::shade;
  lit.fill.lights = {{1, 2, -0.6}};
  lit.lines.classes.add(LineClass::detail);
  lit.lines.classes.add(LineClass::shadow);
  plate.draw(scene, lit, {cell_at(0, 0, 1, 2), "FRONT VIEW"});
  lit.view.named_view = "iso";
  plate.draw(scene, lit, {cell_at(0, 1, 1, 2), "ISOMETRIC VIEW"});
  return plate.take();
}

Plate priority_lists() {
  PlateMaker plate("2.72 and 2.73",
                   "The model of visibility of Newell, Newell and Sancha: faces reordered; a face that is cut",
                   "Numbers are those of the order of painting.");
  const Scene two = scene_of(kTwoFaces), mutual = scene_of(kMutualFaces);
  plate.draw(two, with_shown(view_of("front", "newell"), "order"), {cell_at(0, 0, 1, 3), "FACES IN THE ORDER F1, F2"});
  plate.draw(mutual, view_of("front", "newell"), {cell_at(0, 1, 1, 3), "F1 AND F2 HIDE EACH OTHER"});
  plate.draw(mutual, with_shown(view_of("front", "newell"), "splits"),
             {cell_at(0, 2, 1, 3), "ONE IS CUT BY THE PLANE OF THE OTHER"});
  return plate.take();
}

/// Draws the tree of sets top down, each set centred over its children.
class TreeDrawer {
 public:
  TreeDrawer(PlateMaker& plate, const newell::PaintElements& elements,
             const std::vector<newell::PriorityList::SetNode>& tree, const Rect& area)
      : plate_(plate), elements_(elements), tree_(tree), children_(tree.size()), at_(tree.size()), area_(area) {
    for (std::uint32_t i = 1; i < tree.size(); ++i) children_[tree[i].parent].push_back(i);
    leaf_width_ = area.width() / static_cast<double>(leaves(0));
    level_height_ = area.height() / (depth(0) + 0.5);
    place(0, 0);
  }

  void draw() {
    std::vector<std::vector<Point2>> links;
    for (std::uint32_t i = 1; i < tree_.size(); ++i)
      links.push_back({at_[tree_[i].parent] + Point2{0, 1.5}, at_[i] - Point2{0, 4}});
    plate_.lines("outline", links);
    for (std::uint32_t i = 0; i < tree_.size(); ++i) plate_.text(words(i), at_[i], kSmallHeight, TextAcross::center);
  }

 private:
  std::size_t leaves(std::uint32_t node) const {
    std::size_t sum = 0;
    for (const std::uint32_t child : children_[node]) sum += leaves(child);
    return std::max<std::size_t>(sum, 1);
  }
  unsigned depth(std::uint32_t node) const {
    unsigned most = 0;
    for (const std::uint32_t child : children_[node]) most = std::max(most, depth(child) + 1);
    return most;
  }
  void place(std::uint32_t node, unsigned level) {
    const double before = next_leaf_;
    for (const std::uint32_t child : children_[node]) place(child, level + 1);
    if (children_[node].empty()) next_leaf_ += 1;
    at_[node] = area_.min + Point2{(before + next_leaf_) / 2 * leaf_width_, (level + 0.5) * level_height_};
  }
  std::string words(std::uint32_t node) const {
    using Division = newell::PriorityList::Division;
    switch (tree_[node].division) {
      case Division::x:
      case Division::y:
        return "zones";
      case Division::depth:
        return "slabs";
      case Division::list:
        return "list";
      case Division::one:
        break;
    }
    return "face " + std::to_string(elements_[tree_[node].elements.front()].face + 1);
  }

  PlateMaker& plate_;
  const newell::PaintElements& elements_;
  const std::vector<newell::PriorityList::SetNode>& tree_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<Point2> at_;
  Rect area_;
  double leaf_width_ = 0, level_height_ = 0, next_leaf_ = 0;
};

Plate decomposition() {
  PlateMaker plate("2.88", "Decomposition of a scene: zones, slabs, and the tree whose walk is the order",
                   "Slabs stand from the nearest on. Every set ends with one face, and no pair is compared.");
  Scene scene = zones_of_slabs();
  finish(scene);
  plate.draw(scene, with_shown(view_of("front", "newell"), "zones"), {cell_at(0, 0, 2, 3), "ZONES, FRONT VIEW"});
  plate.draw(scene, with_shown(view_of("front", "newell"), "slabs"), {cell_at(1, 0, 2, 3), "SLABS, FRONT VIEW"});
  plate.draw(scene, view_of("top", "newell"), {cell_at(0, 1, 2, 3), "TOP VIEW"});
  plate.draw(scene, with_shown(view_of("front", "newell"), "order"), {cell_at(1, 1, 2, 3), "ORDER OF PAINTING"});
  const ProjectedScene projected = on_sheet(scene);
  newell::PaintElements elements(projected);
  newell::PriorityList list(elements, {.keep_sets = true});
  list.sort();
  const PlateCell cell{cell_at(0, 2, 1, 3), "THE TREE"};
  TreeDrawer tree(plate, elements, list.tree(), cell.area);
  tree.draw();
  plate.name_below(cell);
  return plate.take();
}

}  // namespace

std::vector<Plate> make_plates() {
  std::vector<Plate> plates;
  plates.push_back(three_views());
  plates.push_back(hatched_views());
  plates.push_back(imprecise_strokes());
  plates.push_back(treated_face());
  plates.push_back(details_of_a_face());
  plates.push_back(priority_lists());
  plates.push_back(decomposition());
  return plates;
}

std::string plates_pdf(std::span<const Plate> plates) {
  PdfDocument document;
  PlotOptions options{
      .page = {kPlateWidth, kPlateHeight, kMargin}, .pen_width_mm = kPlatePen, .title = "Plates of Boulle 1980, made again"};
  for (const Plate& plate : plates) document.add_page(plate.drawing, options);
  return document.finish();
}

}  // namespace ligne::studies
