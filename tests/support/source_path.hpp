#pragma once
#include <string>

namespace brunt::test {

/// The path of a file of the repository, "decks/bars/bars.yaml". One source alone knows where the
/// repository stands: a definition on every test would make each of them another object in each
/// folder, and ccache useless between folders.
std::string source_path(const std::string& below);

}  // namespace brunt::test
