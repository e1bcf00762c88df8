# The headers of others that most sources read, compiled once for all folders, which spares a quarter of the time to build. A
# source still includes all that it uses: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON compiles it with that alone.
# GCC 13 and later take it only for sources of its own level of optimization, and those of cold folders read the headers themselves.
set(CMAKE_PCH_WARN_INVALID OFF)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers.cpp CONTENT "")
add_library(ligne_headers STATIC ${PROJECT_BINARY_DIR}/headers.cpp)
target_include_directories(ligne_headers SYSTEM PRIVATE ${GLM_INCLUDE_DIR})
target_link_libraries(ligne_headers PRIVATE ligne_flags)
set_target_properties(ligne_headers PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_precompile_headers(ligne_headers PRIVATE
  <algorithm> <array> <cmath> <cstdint> <functional> <glm/geometric.hpp> <map> <memory> <numeric> <optional> <span> <stdexcept>
  <string> <string_view> <tuple> <unordered_map> <utility> <vector>)
