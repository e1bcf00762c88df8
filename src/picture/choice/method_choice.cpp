#include "picture/choice/method_choice.hpp"

#include <algorithm>

#include "picture/products.hpp"
#include "visibility/common/convex_body.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Adjustable: fewest triangles for which the choice matters. With fewer, either method takes a few milliseconds.
constexpr std::size_t kManyTriangles = 512;
/// Adjustable: most triangles of a scene whose transparent faces are drawn as transparent. In larger scenes they count
/// as opaque, with a warning, because the method that supports them takes several times the time of the default method,
/// and more memory.
constexpr std::size_t kMaxTransparentTriangles = 100'000;

constexpr ChoiceRule kRules[] = {
    {"areas of faces are requested", "atherton-weiler", [](const ChoiceFacts& f) { return f.regions; }},
    {"some faces are transparent", "atherton-weiler", [](const ChoiceFacts& f) { return f.has_transparency; }},
    {"one opaque convex body of many faces", "culling",
     [](const ChoiceFacts& f) { return f.many_triangles && f.may_be_one_body; }},
    {"any other scene", "appel", [](const ChoiceFacts&) { return true; }},
};

bool renders_transparency(const ProjectedScene& projected) {
  return projected.triangles.size() <= kMaxTransparentTriangles &&
         std::ranges::any_of(projected.face_is_transparent, [](std::uint8_t t) { return t != 0; });
}

}  // namespace

std::span<const ChoiceRule> choice_rules() { return kRules; }

std::size_t choose_rule(const ChoiceFacts& facts) {
  const auto rule = std::find_if(std::begin(kRules), std::end(kRules), [&](const ChoiceRule& r) { return r.holds(facts); });
  return static_cast<std::size_t>(rule - std::begin(kRules));
}

bool chooses_regions(const PictureRequest& request, const ProjectedScene& projected) {
  return needs_regions(request) || renders_transparency(projected);
}

ChoiceFacts facts_of(const PictureRequest& request, const ProjectedScene& projected) {
  ChoiceFacts facts{.regions = needs_regions(request),
                    .many_triangles = projected.triangles.size() >= kManyTriangles,
                    .has_transparency = renders_transparency(projected)};
  facts.may_be_one_body = !facts.regions && facts.many_triangles && convexity::looks_like_one_convex_body(projected);
  return facts;
}

ChosenStudy study_by_choice(const PictureRequest& request, const ProjectedScene& projected,
                            const VisibilityOptions& options) {
  const std::size_t number = choose_rule(facts_of(request, projected));
  const auto words = [](std::size_t rule) {
    return "rule " + std::to_string(rule + 1) + ": " + std::string(kRules[rule].when);
  };
  ChosenStudy choice{find_method(kRules[number].method), words(number), {}};
  choice.result = choice.method->compute_visibility(projected, options);
  if (choice.result.unsupported_reason.empty()) return choice;
  constexpr std::size_t kLast = std::size(kRules) - 1;
  choice.why = words(kLast) + " (" + std::string(choice.method->traits().name) + " found that " +
               choice.result.unsupported_reason + ")";
  choice.method = find_method(kRules[kLast].method);
  choice.result = choice.method->compute_visibility(projected, options);
  return choice;
}

}  // namespace ligne
