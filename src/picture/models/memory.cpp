#ifdef __GLIBC__
#endif

#include "picture/models/memory.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

#include <malloc.h>

namespace ligne {
namespace {

/// Texts about a stage: its purpose, and how to make it need less memory.
struct StageWords {
  std::string_view name, purpose, help;
};

constexpr StageWords kStages[] = {
    {"read", "to read the input", "a smaller model takes less, and a surface with fewer --samples"},
    {"topology", "to join faces at their edges", "a model of fewer faces takes less"},
    {"project", "to project the model", "a model of fewer faces takes less"},
    {"place", "to place the surface", "fewer --samples take less"},
    {"study", "to find the hidden lines", "fewer faces or samples take less, and fewer classes in --edges"},
    {"regions", "for light and shadow", "fewer faces, and fewer --light, take less"},
    {"drawing", "to find lines that coincide", "fewer faces take less, and fewer classes in --edges"},
    {"hatch", "for the hatching", "a wider --hatch-spacing takes less"},
    {"paths", "to order the strokes", "--optimize off takes less"},
    {"write", "to write the picture", "fewer lines take less, and for a PNG a lower --dpi"},
    {"output", "for the bytes of the file", "fewer lines take less, and for a PNG a lower --dpi"},
};

/// Returns text such as "not enough memory for the hatching: 12 faces".
std::string shortage(const StageWords* words, const Stage& stage) {
  std::string text = "not enough memory " + (words ? std::string(words->purpose) : "for the stage " + stage.name);
  if (!stage.asks.empty()) text += ": " + stage.asks;
  return text;
}

const StageWords* words_of(const Stage& stage) {
  const auto* const found = std::find_if(std::begin(kStages), std::end(kStages),
                                         [&](const StageWords& words) { return words.name == stage.name; });
  return found == std::end(kStages) ? nullptr : found;
}

std::string with_help(const std::string& text, const StageWords* words) {
  return words ? text + "; " + std::string(words->help) : text;
}

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

MemoryError::MemoryError(std::string_view text) noexcept {
  std::memcpy(text_.data(), text.data(), std::min(text.size(), kLongestMessage));
}

MemoryError out_of_memory(const Stage& stage) {
  const StageWords* const words = words_of(stage);
  return MemoryError(with_help(shortage(words, stage), words));
}

std::string bytes_text(double bytes) {
  constexpr std::string_view kUnits[] = {"", "K", "M", "G", "T", "P"};
  constexpr double kStep = 1024;
  std::size_t unit = 0;
  for (; unit + 1 < std::size(kUnits) && bytes >= kStep; bytes /= kStep) ++unit;
  constexpr int kDigits = 3;
  return (bytes < kStep && bytes >= 1000 ? std::to_string(static_cast<int>(bytes)) : rounded(bytes, kDigits)) +
         std::string(kUnits[unit]);
}

void MemoryLimit::require(double least, const Stage& stage) const {
  if (least <= bytes) return;
  const StageWords* const words = words_of(stage);
  throw MemoryError(with_help(shortage(words, stage) + ", " + bytes_text(least) + " at least", words));
}

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
