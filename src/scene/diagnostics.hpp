#pragma once
/// Errors and warnings about input.

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace ligne {

/// The input can not be used. what() is one line, "FILE[:LINE]: what is wrong and where".
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  InputError(const std::string& place, const std::string& cause) : std::runtime_error(place + ": " + cause) {}
};

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
