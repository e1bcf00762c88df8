#pragma once
/// The results that a study leaves for a later one.

#include <cstdint>

namespace ligne {

/// Each method knows its own, and does not use what does not fit.
class KeptVisibility {
 public:
  virtual ~KeptVisibility() = default;
};

enum class Keep : std::uint8_t {
  nothing,
  for_next_view,     ///< the same model is studied from elsewhere
  for_more_objects,  ///< the same objects, and others behind them, are studied from the same place
};

}  // namespace ligne
