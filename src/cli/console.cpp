#include "cli/console.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <unistd.h>

#include "cli/options/option_groups.hpp"
#include "files/message_text.hpp"

namespace ligne {
namespace {

constexpr std::chrono::milliseconds kPatience{500};
constexpr int kBarCells = 40;

}  // namespace

void say(std::string_view text) {
  const std::string line = "ligne: " + message_line(text) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void warn(const std::string& place, const std::string& text) { say(place + ": warning: " + text); }

void warn(const std::string& place, const Warnings& warnings, bool with_areas) {
  for (const std::string& line : warnings.lines(with_areas)) warn(place, line);
}

ProgressBar::ProgressBar(const RunOptions& options) {
  const auto now = std::chrono::steady_clock::now();
  switch (options.progress) {
    case ShowProgress::never:
      break;
    case ShowProgress::always:
      wanted_ = true;
      show_from_ = now;
      break;
    case ShowProgress::automatic:
      wanted_ = !options.quiet && isatty(STDERR_FILENO) != 0;
      show_from_ = now + kPatience;
      break;
  }
}

ProgressBar::~ProgressBar() { wipe(); }

void ProgressBar::wipe() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
  drawn_ = false;
}

std::function<void(double)> ProgressBar::callback() {
  if (!wanted_) return {};
  return [this](double fraction) { update(fraction); };
}

void ProgressBar::update(double fraction) {
  if (!std::isfinite(fraction)) return;
  if (fraction >= 1) return wipe();
  const int percent = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * 100);
  if (percent == percent_ || std::chrono::steady_clock::now() < show_from_) return;
  percent_ = percent;
  drawn_ = true;
  const int full = percent * kBarCells / 100;
  const std::string bar =
      "\r[" + std::string(full, '#') + std::string(kBarCells - full, ' ') + "] " + std::to_string(percent) + "%";
  std::fwrite(bar.data(), 1, bar.size(), stderr);
}

}  // namespace ligne
