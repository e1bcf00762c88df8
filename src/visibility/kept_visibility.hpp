#pragma once
/// Intermediate results that a method keeps for a later run.

#include <cstdint>

namespace ligne {

/// Base class of such results. A method recognizes its own ones, and ignores others.
class KeptVisibility {
 public:
  virtual ~KeptVisibility() = default;
};

/// The kind of later run for which results are kept.
enum class Keep : std::uint8_t {
  nothing,
  for_next_view,     ///< the same model from another viewpoint
  for_more_objects,  ///< the same view, with further objects appended to the same ones
};

}  // namespace ligne
