#pragma once
/// Warnings about input; errors come with them.

#include <cstddef>
#include <map>
#include <string>

#include "files/input_error.hpp"

namespace ligne {

/// Things that were mended or left out while reading, counted by kind, so that a thousand of one kind are one line.
class Warnings {
 public:
  /// `kind` is a phrase such as "faces with fewer than three distinct vertices dropped".
  void add(const std::string& kind, std::size_t n = 1) {
    if (n != 0) counts_[kind] += n;
  }
  const std::map<std::string, std::size_t>& counts() const { return counts_; }

 private:
  std::map<std::string, std::size_t> counts_;
};

}  // namespace ligne
