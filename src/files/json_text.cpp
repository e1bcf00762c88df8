#include "files/json_text.hpp"

#include <nlohmann/json.hpp>

namespace ligne {

std::string json_string(std::string_view text) {
  using nlohmann::json;
  return json(std::string(text)).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace ligne
