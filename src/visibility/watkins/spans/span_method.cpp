#include "visibility/watkins/spans/span_method.hpp"

#include "visibility/watkins/spans/merge_spans.hpp"
#include "visibility/watkins/spans/point_spans.hpp"
#include "visibility/watkins/spans/stack_spans.hpp"

namespace ligne::watkins {

std::uint64_t SpanCounts::total() const {
  std::uint64_t sum = 0;
  for (const auto& [name, value] : named()) sum += value;
  return sum;
}

std::array<std::pair<std::string_view, std::uint64_t>, SpanCounts::kKinds> SpanCounts::named() const {
  return {{{"comparisons", comparisons},
           {"depth tests", depth_tests},
           {"penetrations", penetrations},
           {"insertions", insertions},
           {"pushes", pushes},
           {"pops", pops},
           {"boxes", boxes},
           {"divisions remembered", remembered},
           {"points", points},
           {"spans", spans},
           {"swaps", swaps}}};
}

void report(const SpanCounts& counts, Statistics& statistics) {
  for (const auto& [name, value] : counts.named()) statistics.count("span method: " + std::string(name), value);
}

template <class X>
std::unique_ptr<SpanMethod<X>> make_span_method(SpanMethodKind kind) {
  switch (kind) {
    case SpanMethodKind::merge:
      return std::make_unique<MergeMethod<X>>();
    case SpanMethodKind::point:
      return std::make_unique<PointMethod<X>>();
    case SpanMethodKind::box:
    case SpanMethodKind::remembered:
      return make_box_method<X>(kind == SpanMethodKind::remembered);
    case SpanMethodKind::stack:
      break;
  }
  return std::make_unique<StackMethod<X>>();
}

template std::unique_ptr<SpanMethod<double>> make_span_method<double>(SpanMethodKind);
template std::unique_ptr<SpanMethod<std::int32_t>> make_span_method<std::int32_t>(SpanMethodKind);

}  // namespace ligne::watkins
