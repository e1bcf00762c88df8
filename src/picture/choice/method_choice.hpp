#pragma once
/// The choice of --method auto.
///
/// The rules follow from the measurements of bench/auto_table.py, see docs/compare.md. On all kinds of larger scenes but
/// one, the default method is the fastest exact method or a few percent slower.

#include <span>
#include <string>
#include <string_view>

#include "picture/requests.hpp"
#include "view/projected_scene.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// The facts that the choice depends on.
struct ChoiceFacts {
  bool regions = false;          ///< the picture is made of areas
  bool many_triangles = false;   ///< enough for the time of a method to be noticed
  bool may_be_one_body = false;  ///< it may be one opaque convex body; the method itself verifies it
  /// Some faces are transparent, and the scene is small enough for a method that returns areas.
  bool has_transparency = false;
};

struct ChoiceRule {
  std::string_view when;  ///< a phrase
  std::string_view method;
  bool (*holds)(const ChoiceFacts&);
};

/// The rules in order. The first one that holds decides. The last one always holds, and its method accepts all scenes.
std::span<const ChoiceRule> choice_rules();

/// Returns the number of the rule that decides, from 0.
std::size_t choose_rule(const ChoiceFacts& facts);

ChoiceFacts facts_of(const PictureRequest& request, const ProjectedScene& projected);

struct ChosenStudy {
  const Method* method = nullptr;
  std::string why;  ///< the rule's number and words
  VisibilityResult result;
};

/// Whether study_by_choice() tries a method that returns regions first.
bool chooses_regions(const PictureRequest& request, const ProjectedScene& projected);

/// Computes visibility by the method that the rules choose. If that method finds that it does not support the scene,
/// uses the method of the last rule. So the result is always that of a method that supports the scene.
ChosenStudy study_by_choice(const PictureRequest& request, const ProjectedScene& projected,
                            const VisibilityOptions& options);

}  // namespace ligne
