#pragma once
/// A method with a tree that is there: one compilation for many viewpoints.

#include "visibility/method.hpp"

namespace ligne::test {

template <class TreeMethod, class Tree>
class CompiledMethod final : public Method {
 public:
  explicit CompiledMethod(const Tree& tree) : tree_(tree) {}
  const MethodTraits& traits() const override { return method_.traits(); }
  VisibilityResult study(const ProjectedScene& scene, const StudyOptions& options) const override {
    return method_.study(tree_, scene, options);
  }

 private:
  const Tree& tree_;
  TreeMethod method_;
};

}  // namespace ligne::test
