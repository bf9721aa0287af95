#include "io/mesh/abaqus_keyword.hpp"

#include <algorithm>

#include "io/mesh/card.hpp"

namespace brunt {

namespace {
std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
  return text;
}

constexpr const char* kWriteLines = "write the nodes and elements themselves, in one file";

struct UnreadKeyword {
  std::string_view name;
  const char* instead;
};
constexpr UnreadKeyword kUnread[] = {
    {"*INCLUDE", kWriteLines},
    {"*NGEN", kWriteLines},
    {"*NFILL", kWriteLines},
    {"*NCOPY", kWriteLines},
    {"*NMAP", kWriteLines},
    {"*ELGEN", kWriteLines},
    {"*ELCOPY", kWriteLines},
    {"*IMPORT", kWriteLines},
    {"*SYMMETRICMODELGENERATION", kWriteLines},
    {"*IMPERFECTION", "write the nodes where they are"},
    {"*SYSTEM", "write the nodes where they are, or use `translate` and `rotate` of the deck"}};
constexpr std::string_view kRead[] = {"*NODE",    "*ELEMENT", "*NSET",     "*ELSET",
                                      "*SURFACE", "*PART",    "*INSTANCE", "*ASSEMBLY"};
}  // namespace

AbaqusLabel abaqus_label(std::string_view written) {
  written = trimmed(written);
  if (written.size() > 1 && written.front() == '"' && written.back() == '"') {
    const std::string text(written.substr(1, written.size() - 2));
    return {text, text};
  }
  return {std::string(written), upper(written)};
}

AbaqusKeyword::AbaqusKeyword(std::string_view line) {
  // Commas between quotes are of a name.
  const auto next = [&] {
    bool quoted = false;
    std::size_t end = 0;
    for (; end < line.size() && (quoted || line[end] != ','); ++end) quoted ^= line[end] == '"';
    const std::string_view taken = trimmed(line.substr(0, end));
    line.remove_prefix(std::min(line.size(), end + 1));
    return taken;
  };
  name_ = without_blanks(upper(next()));
  while (!line.empty()) {
    const std::string_view one = next();
    const std::size_t equals = std::min(one.find('='), one.size());
    const std::string_view value = trimmed(one.substr(std::min(one.size(), equals + 1)));
    parameters_[without_blanks(upper(one.substr(0, equals)))] = value;
  }
}

const std::string* AbaqusKeyword::parameter(std::string_view name) const {
  if (const auto whole = parameters_.find(std::string(name)); whole != parameters_.end()) {
    return &whole->second;
  }
  for (const auto& [written, value] : parameters_) {
    if (!written.empty() && name.starts_with(written)) return &value;
  }
  return nullptr;
}

std::string instead_of_abaqus(std::string_view keyword) {
  for (const auto& [name, instead] : kUnread) {
    if (name == keyword) return instead;
  }
  // Abaqus takes keywords that are cut short.
  constexpr std::size_t kShortest = 3;
  if (keyword.size() < kShortest) return "";
  for (const std::string_view name : kRead) {
    if (name.starts_with(keyword) && name != keyword) return "write " + std::string(name);
  }
  for (const auto& [name, instead] : kUnread) {
    if (name.starts_with(keyword)) return instead;
  }
  return "";
}

}  // namespace brunt
// Tested by tests/unit/io/abaqus_test.cpp.
