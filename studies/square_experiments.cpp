// Experiments with n squares on the scan plane, [Boulle1980] 2.3.3.4: stack and box; and two zones moved along the line.

#include <algorithm>
#include <array>

#include "studies/experiments.hpp"
#include "studies/measure.hpp"
#include "studies/operations/thesis_spans.hpp"
#include "studies/scenes/generators.hpp"

namespace ligne::studies {
namespace {

using namespace watkins;

constexpr double kSteps = 512.0 / 400 * 1024;  ///< scan line steps per unit: 100 squares span 512 columns of 1024 steps

std::vector<ScanSegment<double>> sorted_squares(int n, double degrees, double steps = kSteps, double shift = 0) {
  auto segments = squares<double>(n, degrees, steps, shift);
  std::sort(segments.begin(), segments.end(), [](const auto& a, const auto& b) { return comes_before(a, b); });
  return segments;
}

struct OurRun {
  std::vector<VisibleSpan> spans;
  std::uint64_t operations = 0, boxes = 0;
};

OurRun ours(SpanMethodKind kind, const std::vector<ScanSegment<double>>& segments) {
  const auto method = make_span_method<double>(kind);
  OurRun run;
  method->study(segments, run.spans);
  run.operations = method->counts().total();
  run.boxes = method->counts().boxes;
  return run;
}

const char* thesis_growth(double degrees) {
  if (degrees == 0) return "stack O(n), box O(n log n)";
  if (degrees == 45) return "both linear, box above";
  if (degrees == 15) return "box above stack";
  return "most of all, box far above";
}

struct Kind {
  const char* name;
  std::uint64_t Operations::*member;
};
constexpr Kind kKinds[] = {{"addition", &Operations::additions},         {"subtraction", &Operations::subtractions},
                           {"multiplication", &Operations::products},    {"division", &Operations::quotients},
                           {"access to a table", &Operations::accesses}, {"test", &Operations::tests},
                           {"assignment", &Operations::assignments}};
constexpr double kAngles[] = {0, 15, 30, 45, 60};

Table by_kind(bool& box_above) {
  Table table{"Five squares by kind of operation, stack and box as the thesis has them",
              {{"angle", ColumnKind::label},
               {"operation", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"stack", ColumnKind::count},
               {"box", ColumnKind::count}}};
  for (const double angle : kAngles) {
    ThesisSpans spans(sorted_squares(5, angle));
    const Operations stack = spans.stack().operations, box = spans.box(true).operations;
    for (const Kind& kind : kKinds) {
      box_above = box_above && box.*kind.member >= stack.*kind.member;
      table.rows.push_back({std::to_string(int(angle)), kind.name, "box above", stack.*kind.member, box.*kind.member});
    }
  }
  return table;
}

Table growth_table() {
  return {"Growth with n: the exponent e of n^e over the last doubling",
          {{"angle", ColumnKind::label},
           {"thesis", ColumnKind::source},
           {"stack", ColumnKind::measure},
           {"box", ColumnKind::measure},
           {"our stack", ColumnKind::measure},
           {"our box", ColumnKind::measure}}};
}

}  // namespace

Result study_squares(const StudyRequest& request) {
  Result result;
  bool box_above = true;
  result.tables.push_back(by_kind(box_above));
  Table table{"Operations of one line by the number of squares; the span methods of the thesis, and those of this program",
              {{"angle", ColumnKind::label},
               {"squares", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"stack", ColumnKind::count},
               {"box", ColumnKind::count},
               {"box over stack", ColumnKind::measure},
               {"our merge", ColumnKind::count},
               {"our stack", ColumnKind::count},
               {"our box", ColumnKind::count},
               {"our point", ColumnKind::count},
               {"thesis' stack wrong on %", ColumnKind::measure}}};
  Table growths = growth_table();
  std::vector<int> numbers{1, 2, 3, 4, 5};
  if (request.full()) numbers.insert(numbers.end(), {10, 20, 30, 40, 50, 60, 70, 80, 90, 100});
  for (const double angle : kAngles) {
    Chart chart{"n squares, turned by " + std::to_string(int(angle)) + " degrees", "squares", "operations"};
    chart.curves = {{"stack, thesis", {}}, {"box, thesis", {}}, {"stack, ours", {}}, {"box, ours", {}}, {"merge, ours", {}}};
    std::array<std::vector<double>, 4> totals;
    for (const int n : numbers) {
      const auto segments = sorted_squares(n, angle);
      ThesisSpans spans(segments);
      const SpanRun stack = spans.stack(), box = spans.box(true);
      const OurRun our_merge = ours(SpanMethodKind::merge, segments), our_stack = ours(SpanMethodKind::stack, segments),
                   our_box = ours(SpanMethodKind::box, segments), our_point = ours(SpanMethodKind::point, segments);
      double width = 0;
      for (const VisibleSpan& s : our_stack.spans) width += s.x1 - s.x0;
      const double of_stack = double(stack.operations.total()), of_box = double(box.operations.total());
      if (n <= 5 || n % 50 == 0) {
        table.rows.push_back({std::to_string(int(angle)), std::to_string(n), thesis_growth(angle), stack.operations.total(),
                              box.operations.total(), of_box / of_stack, our_merge.operations, our_stack.operations,
                              our_box.operations, our_point.operations,
                              100 * difference_of(stack.spans, our_stack.spans) / width});
      }
      const double values[] = {of_stack, of_box, double(our_stack.operations), double(our_box.operations),
                               double(our_merge.operations)};
      for (std::size_t k = 0; k < 5; ++k) chart.curves[k].points.emplace_back(n, values[k]);
      for (std::size_t k = 0; k < 4; ++k) totals[k].push_back(values[k]);
    }
    // Growth from 50 to 100 squares, or from 2 to 4 at small size.
    const std::size_t half = request.full() ? 9 : 1, whole = request.full() ? 14 : 3;
    std::vector<Cell> row{std::to_string(int(angle)), thesis_growth(angle)};
    for (const auto& of : totals) row.emplace_back(growth(numbers[half], of[half], numbers[whole], of[whole]));
    growths.rows.push_back(std::move(row));
    result.charts.push_back(std::move(chart));
  }
  result.tables.push_back(std::move(table));
  result.tables.push_back(std::move(growths));
  result.finding = box_above ? Finding::holds : Finding::in_part;
  result.sentence =
      "Counted as the thesis counts, stack is the cheaper of the two on every scene of five squares but, at 45 degrees, where the "
      "first square hides the others and box finds that at once; there the stack still goes through every segment.";
  return result;
}

Result study_translation(const StudyRequest& request) {
  constexpr double kLine = 512, kColumnsByUnit = 8;  // two squares are 40 columns wide, with a gap of 8
  Table table{"Figure 2.56: two squares on a line of 512 columns, moved along it; operations",
              {{"moved by, columns", ColumnKind::label},
               {"thesis", ColumnKind::source},
               {"stack", ColumnKind::count},
               {"box, divided in the middle", ColumnKind::count},
               {"its parts", ColumnKind::count},
               {"box, divided at ends", ColumnKind::count},
               {"our box", ColumnKind::count}}};
  Chart chart{"Two squares moved along the line", "columns", "operations"};
  chart.curves = {{"stack", {}}, {"box, middle", {}}, {"box, ends", {}}, {"box, ours", {}}};
  std::uint64_t least_stack = ~std::uint64_t{0}, most_stack = 0, least_box = ~std::uint64_t{0}, most_box = 0;
  const int step = request.pick(32, 4);
  for (int columns = 0; columns <= 472; columns += step) {
    const auto segments = sorted_squares(2, 0, kColumnsByUnit, columns / kColumnsByUnit);
    ThesisSpans spans(segments);
    const std::uint64_t stack = spans.stack().operations.total();
    const SpanRun middle = spans.box(false, kLine), ends = spans.box(true, kLine);
    const std::uint64_t our_box = ours(SpanMethodKind::box, segments).operations;
    least_stack = std::min(least_stack, stack);
    most_stack = std::max(most_stack, stack);
    least_box = std::min(least_box, middle.operations.total());
    most_box = std::max(most_box, middle.operations.total());
    const double x = columns;
    chart.curves[0].points.emplace_back(x, double(stack));
    chart.curves[1].points.emplace_back(x, double(middle.operations.total()));
    chart.curves[2].points.emplace_back(x, double(ends.operations.total()));
    chart.curves[3].points.emplace_back(x, double(our_box));
    if (columns % 32 == 0) {
      table.rows.push_back({std::to_string(columns), "stack the same, box not", stack, middle.operations.total(),
                            middle.boxes, ends.operations.total(), our_box});
    }
  }
  Result result;
  result.tables.push_back(std::move(table));
  result.charts.push_back(std::move(chart));
  result.finding = least_stack == most_stack && least_box < most_box ? Finding::holds : Finding::no_longer;
  result.sentence =
      "The stack does the same work wherever the scene lies; the box that is divided in the middle took between " +
      std::to_string(least_box) + " and " + std::to_string(most_box) +
      " operations, and the same everywhere once it is divided at the ends of segments, as the program does.";
  return result;
}

}  // namespace ligne::studies
