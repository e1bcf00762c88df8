#pragma once
/// Convex sets and separating planes: a display tree, compiled once, gives the order of the faces from any viewpoint.
///
/// After S. Huet, "Compilation d'objets 3D", 1994. docs/methods/convex-tree.md.

#include "visibility/convex_tree/convex_tree.hpp"
#include "visibility/method.hpp"

namespace ligne {

class ConvexTreeMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult study(const ProjectedScene& scene, const StudyOptions& options) const override;
  std::shared_ptr<const CompiledScene> compile(const Scene& scene, const MethodSettings& settings) const override;
  std::shared_ptr<const CompiledScene> read_compiled(ByteReader& bytes, const Scene& scene) const override;

  /// The same with a tree that was built from the scene's model before, for this view or another one.
  static VisibilityResult study(const ConvexTree& tree, const ProjectedScene& scene, const StudyOptions& options);
};

}  // namespace ligne
