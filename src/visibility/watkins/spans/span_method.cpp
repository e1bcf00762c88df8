#include "visibility/watkins/spans/span_method.hpp"

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
      return make_merge_method<X>();
    case SpanMethodKind::box:
      return make_box_method<X>();
    case SpanMethodKind::point:
      return make_point_method<X>();
    case SpanMethodKind::remembered:
      return make_remembered_method<X>();
    default:
      return make_stack_method<X>();
  }
}

template std::unique_ptr<SpanMethod<double>> make_span_method<double>(SpanMethodKind);
template std::unique_ptr<SpanMethod<std::int32_t>> make_span_method<std::int32_t>(SpanMethodKind);

}  // namespace ligne::watkins
