#pragma once
/// The choice of --method auto.
///
/// The rules are what the measurements of bench/auto_table.py come to, docs/compare.md: on all scenes of some size but one
/// kind the default method is the fastest exact one, or within a few hundredths of it.

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
  bool many_triangles = false;   ///< so many that the time of a study is noticed
  bool may_be_one_body = false;  ///< it looks like one opaque convex body, which the method itself finds out
  bool glass = false;            ///< some faces are transparent, and the scene is not too large for a method of areas
};

struct ChoiceRule {
  std::string_view when;  ///< a phrase
  std::string_view method;
  bool (*holds)(const ChoiceFacts&);
};

/// In their order: the first that holds decides. The last holds always, and its method has no scenes that it is not for.
std::span<const ChoiceRule> choice_rules();

/// The number of the rule, from 0.
std::size_t choose_rule(const ChoiceFacts& facts);

ChoiceFacts facts_of(const PictureRequest& request, const ProjectedScene& projected);

struct ChosenStudy {
  const Method* method = nullptr;
  std::string why;  ///< the rule's number and words
  VisibilityResult result;
};

/// True where study_by_choice() first takes a method that gives regions.
bool chooses_regions(const PictureRequest& request, const ProjectedScene& projected);

/// Studies by the method that the rules choose; where that finds that the scene is beyond it, by that of the last rule. So
/// no result is beyond its method.
ChosenStudy study_by_choice(const PictureRequest& request, const ProjectedScene& projected,
                            const VisibilityOptions& options);

}  // namespace ligne
