#include "tests/support/source_path.hpp"

namespace brunt::test {

std::string source_path(const std::string& below) {
  return std::string(BRUNT_SOURCE_DIR) + "/" + below;
}

}  // namespace brunt::test
