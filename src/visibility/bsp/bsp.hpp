#pragma once
/// Binary space-partitioning: a tree of the faces, built once for any viewpoint, gives their order.
///
/// After H. Fuchs, Z. Kedem, B. Naylor, "On visible surface generation by a priori tree structures", SIGGRAPH 1980.
/// docs/methods/bsp.md.

#include "visibility/bsp/bsp_tree.hpp"
#include "visibility/method.hpp"

namespace ligne {

class BspMethod final : public Method {
 public:
  const MethodTraits& traits() const override;
  VisibilityResult study(const ProjectedScene& scene, const StudyOptions& options) const override;
  std::shared_ptr<const CompiledScene> compile(const Scene& scene, const MethodSettings& settings) const override;
  std::shared_ptr<const CompiledScene> read_compiled(ByteReader& bytes, const Scene& scene) const override;

  /// The same with a tree that was built from the scene's model before, for this view or another one.
  static VisibilityResult study(const BspTree& tree, const ProjectedScene& scene, const StudyOptions& options);
};

}  // namespace ligne
