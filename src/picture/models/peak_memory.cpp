#include "picture/models/peak_memory.hpp"

#include <fstream>
#include <string>
#include <string_view>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ligne {
namespace {

/// Reads a line of /proc/self/status, such as "VmHWM:  1234 kB".
std::optional<double> status_bytes(std::string_view name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with(name)) continue;
    constexpr double kBytesPerKb = 1024;
    return kBytesPerKb * std::stod(line.substr(name.size()));
  }
  return {};
}

}  // namespace

PeakMemory::PeakMemory() {
#ifdef __GLIBC__
  malloc_trim(0);  // otherwise freed memory would be reused without being counted
#endif
  // "5" resets the peak to the current size (proc(5)).
  std::ofstream reset("/proc/self/clear_refs");
  if (reset << '5' << std::flush) before_ = status_bytes("VmRSS:");
}

std::optional<double> PeakMemory::bytes() const {
  const std::optional<double> peak = before_ ? status_bytes("VmHWM:") : std::nullopt;
  if (!peak) return {};
  return *peak > *before_ ? *peak - *before_ : 0;
}

}  // namespace ligne
