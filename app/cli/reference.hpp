#pragma once
#include <string>

namespace brunt {

/// `brunt explain [KEY]`: unit, range, default and help of a key; all keys without one.
int explain_command(const std::string& key);
/// `brunt schema`: the JSON schema of decks, or the reference manual.
int schema_command(bool markdown);

}  // namespace brunt
