#include "cli/options/idle_options.hpp"

#include <algorithm>
#include <iterator>

#include "cli/messages.hpp"
#include "picture/parse/parse.hpp"

namespace ligne {
namespace {

/// Sets of output formats, as bits.
constexpr unsigned bit(OutputFormat format) { return 1u << static_cast<unsigned>(format); }
constexpr unsigned kSvg = bit(OutputFormat::svg), kPng = bit(OutputFormat::png), kJson = bit(OutputFormat::json),
                   kPaper = kSvg | bit(OutputFormat::pdf) | kPng,
                   kPlotted = bit(OutputFormat::hpgl) | bit(OutputFormat::gcode), kDrawn = kPaper | kPlotted,
                   kAll = kDrawn | kJson;

/// Words in OptionUse::needs beside names of options.
constexpr std::string_view kPens = "pens", kNoPens = "no-pens", kSvgInput = "svg";

/// The conditions under which an option has an effect. Other combinations get a warning.
struct OptionUse {
  std::string_view commands;  ///< separated by blanks
  std::string_view option;
  unsigned formats = kAll;
  std::string_view needs{};   ///< one of these options or of the words above, separated by blanks; empty: none
  unsigned needed_in = kAll;  ///< formats in which the option needs them
};

constexpr OptionUse kUses[] = {
    {"surface plot", "--dpi", kPng},
    {"draw", "--dpi", kPaper, "--shade-tone", kSvg | bit(OutputFormat::pdf)},
    {"draw", "--shade-tone", kPaper, "--shade --fill"},
    {"draw surface", "--curves", kPaper, kNoPens},
    {"plot", "--curves", kPaper},
    {"draw", "--profile", kAll, "--pens --pen", kPlotted},
    {"surface", "--pen-width", kAll,
     "--hatch --hachures --water-fill --grid --method --contours --contour-step --outline --parametric --points --curve",
     kPlotted | kJson},
    {"plot", "--pen-width", kAll, "--hatch --hatch-spacing --hatch-angle --hatch-cross --fill --occlude", kPlotted},
    {"draw", "--title", kSvg | bit(OutputFormat::pdf)},
    {"surface", "--title", kDrawn},
    {"draw", "--group", kSvg | kJson, kNoPens},
    {"draw surface plot", "--width", kPaper},
    {"draw surface", "--join", kDrawn, "pens --optimize"},
    {"draw surface", "--simplify", kDrawn, "pens --optimize"},
    {"draw surface", "--unit", kAll, "--scale --move"},
    {"draw", "--samples", kAll, "--surface"},
    {"draw", "--every", kAll, "--grid"},
    {"surface", "--text", kDrawn, "--axes --title --scale-bar --north-arrow --legend --points --contour-labels"},
    {"surface", "--text-height", kDrawn, "--axes --title --scale-bar --north-arrow --legend --points --contour-labels"},
    {"surface", "--contour-labels", kDrawn},
    {"surface", "--x-names", kAll, "--axes"},
    {"surface", "--y-names", kAll, "--axes"},
    {"surface", "--z-names", kAll, "--axes"},
    {"surface", "--index-contours", kPaper},
    {"surface", "--points", kDrawn},
    {"surface", "--colors", kPaper, kNoPens},
    {"surface", "--sun", kAll, "--hachures"},
    {"plot", "--margin", kAll, "--scale --tile --grid"},
    {"plot", "--skip", kAll, kSvgInput},
    {"plot", "--strict", kAll, kSvgInput},
    {"plot", "--input-dpi", kAll, kSvgInput},
    {"plot", "--occlude", kAll, kSvgInput},
};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

bool holds(std::string_view need, const CommandUse& use) {
  if (need == kPens) return use.by_pens;
  if (need == kNoPens) return !use.by_pens;
  if (need == kSvgInput) return use.svg_input;
  return std::ranges::find(use.given, need) != use.given.end();
}

/// The words for a need in a message.
std::string_view phrase_of(std::string_view need) {
  if (need == kPens) return "pens or a --device";
  if (need == kNoPens) return "a drawing without pens";
  return need == kSvgInput ? "an SVG input" : need;
}

std::string names_of(unsigned formats) {
  std::vector<std::string_view> names;
  for (std::size_t f = 0; f < std::size(kOutputFormatNames); ++f) {
    if (formats & bit(static_cast<OutputFormat>(f))) names.push_back(kOutputFormatNames[f]);
  }
  return list_of(names);
}

}  // namespace

std::vector<IdleOption> idle_options(const CommandUse& use) {
  std::vector<IdleOption> idle;
  for (const OptionUse& row : kUses) {
    const std::vector<std::string_view> commands = words_of(row.commands);
    if (std::ranges::find(commands, use.command) == commands.end()) continue;
    if (std::ranges::find(use.given, row.option) == use.given.end()) continue;
    if (!(row.formats & bit(use.format))) {
      const std::string_view format = kOutputFormatNames[static_cast<std::size_t>(use.format)];
      idle.push_back(
          {std::string(row.option), "has no effect in " + std::string(format) + ", only in " + names_of(row.formats)});
      continue;
    }
    std::vector<std::string_view> needs = words_of(row.needed_in & bit(use.format) ? row.needs : std::string_view());
    if (needs.empty() || std::ranges::any_of(needs, [&](std::string_view need) { return holds(need, use); })) continue;
    std::ranges::transform(needs, needs.begin(), phrase_of);
    idle.push_back({std::string(row.option), "has no effect without " + list_of(needs)});
  }
  return idle;
}

void warn_of_idle_options(const CommandUse& use) {
  for (const IdleOption& idle : idle_options(use)) warn(idle.option, idle.why);
}

}  // namespace ligne
