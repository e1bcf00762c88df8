#include "picture/pages/plotter.hpp"

#include <memory>
#include <string_view>
#include <vector>

#include "files/closest_name.hpp"
#include "files/message_text.hpp"
#include "picture/errors.hpp"

namespace ligne {
namespace {

/// Largest size of a file of devices or pens, in bytes; such files are short.
constexpr std::uintmax_t kMostTomlBytes = 1 << 20;

std::string read_toml_file(const std::string& file, InputFiles& files) {
  const std::vector<std::byte> bytes = read_input(file, file, files, kMostTomlBytes);
  return std::string(as_characters(bytes));
}

std::string known_devices(DeviceLanguage language) {
  std::string names;
  for (const Device& device : devices()) {
    if (device.language == language) names += (names.empty() ? "" : ", ") + device.name;
  }
  return names;
}

/// The devices that the user probably meant: all whose names begin with the text, or else the most similar one.
std::string devices_like(std::string_view written) {
  std::string list;
  std::vector<std::string_view> names;
  for (const Device& device : devices()) {
    names.push_back(device.name);
    if (!written.empty() && names.back().starts_with(written)) list += (list.empty() ? "" : ", ") + device.name;
  }
  return list.empty() ? suggestion(written, names) : " (" + list + "?)";
}

DeviceLanguage language_of(OutputFormat format) {
  return format == OutputFormat::hpgl    ? DeviceLanguage::hpgl
         : format == OutputFormat::gcode ? DeviceLanguage::gcode
                                         : DeviceLanguage::svg;
}

/// The default device of each plotter language.
constexpr std::string_view kDefaultHpgl = "cutter", kDefaultGcode = "grbl-servo";

std::shared_ptr<const Device> device_of(const PlotterChoice& choice, OutputFormat format, InputFiles& files) {
  const DeviceLanguage language = language_of(format);
  std::shared_ptr<const Device> device;
  if (!choice.device_file.empty()) {
    device = std::make_shared<Device>(read_device(read_toml_file(choice.device_file, files), choice.device_file));
  } else {
    const std::string_view standard = language == DeviceLanguage::hpgl    ? kDefaultHpgl
                                      : language == DeviceLanguage::gcode ? kDefaultGcode
                                                                          : std::string_view{};
    const std::string_view name = choice.device.empty() ? standard : std::string_view(choice.device);
    if (name.empty()) return nullptr;
    const Device* known = find_device(name);
    if (!known)
      throw RequestError("device", shown(name, '"') + " is not known" + devices_like(name) + "; ligne devices lists them");
    device = std::make_shared<Device>(*known);
  }
  const std::string_view speaks = kDeviceLanguageNames[static_cast<std::size_t>(device->language)];
  if (device->language != language) {
    throw RequestError("device", printable(device->name) + " takes " + std::string(speaks) + ", not " +
                                     std::string(kOutputFormatNames[static_cast<std::size_t>(format)]) +
                                     (known_devices(language).empty() ? "" : "; these do: " + known_devices(language)));
  }
  return device;
}

/// Adds pens to a table. The added ones take precedence.
void add_pens(PenTable& pens, const PenTable& given) {
  for (const auto& [number, pen] : given.pens) {
    const auto [entry, added] = pens.pens.emplace(number, pen);
    if (added) continue;
    entry->second.color = pen.color;
    if (pen.width_mm) entry->second.width_mm = pen.width_mm;
  }
  for (const auto& [layer, number] : given.pen_of_layer) pens.pen_of_layer[layer] = number;
  for (const auto& entry : given.pen_of_object) pens.pen_of_object.push_back(entry);
  for (const auto& [material, number] : given.pen_of_material) pens.pen_of_material[material] = number;
  for (const auto& [shade, number] : given.pen_of_shade) pens.pen_of_shade[shade] = number;
  if (given.names_rest) {
    pens.rest = given.rest;
    pens.names_rest = true;
  }
}

}  // namespace

PlotterRequest plotter_request(const PlotterChoice& choice, OutputFormat format, InputFiles& files) {
  PlotterRequest request = choice.request;
  if (format == OutputFormat::json) {
    const bool given = !choice.device.empty() || !choice.device_file.empty() || !choice.pens_file.empty() ||
                       !request.pens.empty() || request.optimize || request.report || request.preview || request.fit_device;
    if (given) throw RequestError("format", "a JSON drawing has no pens; ligne plot makes a plot of it");
    return request;
  }
  request.device = device_of(choice, format, files);
  if (request.fit_device && !request.device) throw RequestError("fit-device", "there is no --device");
  request.pens = {};
  if (!choice.pens_file.empty()) request.pens = read_pens(read_toml_file(choice.pens_file, files), choice.pens_file);
  add_pens(request.pens, choice.request.pens);
  request.asked_pens = choice.request.pens;
  return request;
}

}  // namespace ligne
